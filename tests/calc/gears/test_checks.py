# SPDX-License-Identifier: Apache-2.0
"""Each check of the teeth just inside its limit and just outside it, through the code that makes it."""

from dataclasses import replace

import pytest

from calc.gears.checks import checks, speed_ratio_check
from calc.gears.limits import above_fillet, mm
from tests.calc.gears.trains import SPEED, r753, solved

GEARS = r753()
TRAIN = solved(GEARS)
PAIR = "idler_shaft"
M_N = 2e-3
LITTLE = 1e-6  # of the limit, or of a module
PRACTICE = "practice of gear handbooks, from memory"


def judged(train):
    return {check.id: check for check in checks(GEARS, train)}


def with_mesh(**changes):
    return judged(replace(TRAIN, meshes={**TRAIN.meshes, PAIR: replace(TRAIN.meshes[PAIR], **changes)}))


def with_wheel(**changes):
    return judged(replace(TRAIN, wheels={**TRAIN.wheels, "shaft": replace(TRAIN.wheels["shaft"], **changes)}))


# check, the result that it judges, its limit, verdicts just inside and just outside, source
OF_MESHES = [
    ("contact_ratio", "transverse_contact_ratio", 1.1, ("warn", "fail"), "each pair hands over to the next"),
    ("contact_ratio_usual", "transverse_contact_ratio", 1.25, ("pass", "note"), PRACTICE),
    ("contact_ratio_least", "transverse_contact_ratio_min", 1.0, ("pass", "warn"), "at the end of the tolerances"),
    ("tip_clearance", "tip_clearance_driver", 0.15 * M_N, ("pass", "note"), f"{PRACTICE}: 0.15 m_n"),
    ("tip_clearance", "tip_clearance_driven", 0.15 * M_N, ("pass", "note"), f"{PRACTICE}: 0.15 m_n"),
    ("tip_clearance_least", "tip_clearance_min", 0.0, ("warn", "fail"), "at the end of the tolerances"),
    ("interference", "form_margin_driver", 0.0, ("warn", "fail"), "(d_Nf − d_Ff)/2"),
    ("interference", "form_margin_driven", 0.0, ("warn", "fail"), "(d_Nf − d_Ff)/2"),
    ("interference_usual", "form_margin_driver", 0.1 * M_N, ("pass", "note"), f"{PRACTICE}: 0.1 m_n"),
    ("interference_usual", "form_margin_driven", 0.1 * M_N, ("pass", "note"), f"{PRACTICE}: 0.1 m_n"),
    ("interference_least", "form_margin_min", 0.0, ("warn", "fail"), "at the end of the tolerances"),
]
OF_WHEELS = [
    ("undercut", "profile_shift", TRAIN.wheels["shaft"].undercut_limit, ("warn", "fail"), "ISO"),
    ("tip_thickness", "tip_thickness_normal_min", 0.25 * M_N, ("warn", "fail"), f"{PRACTICE}: 0.25 m_n"),
    ("tip_thickness_hardened", "tip_thickness_normal_min", 0.4 * M_N, ("pass", "note"), "0.4 m_n if case-hardened"),
]


@pytest.mark.parametrize("name, field, limit, verdicts, source", OF_MESHES)
def test_each_check_of_a_mesh(name, field, limit, verdicts, source):
    """With everything else of the mesh far inside."""
    roomy = dict.fromkeys(("tip_clearance_driver", "tip_clearance_driven", "tip_clearance_min"), 1e-3)
    roomy |= dict.fromkeys(("form_margin_driver", "form_margin_driven", "form_margin_min"), 1e-3)
    little = LITTLE * (limit or M_N)
    inside, outside = (
        with_mesh(**{**roomy, field: x})[f"gears.{PAIR}.{name}"] for x in (limit + little, limit - little)
    )
    assert (inside.verdict, outside.verdict) == verdicts
    assert outside.value_id == f"gears.{PAIR}.{field}" and source in outside.source


@pytest.mark.parametrize("name, field, limit, verdicts, source", OF_WHEELS)
def test_each_check_of_a_wheel(name, field, limit, verdicts, source):
    little = LITTLE * abs(limit)
    inside, outside = (with_wheel(**{field: x})[f"gears.shaft.{name}"] for x in (limit + little, limit - little))
    assert (inside.verdict, outside.verdict) == verdicts
    assert outside.value_id == f"gears.shaft.{field}" and source in outside.source


def test_a_wheel_without_tolerances_is_judged_by_its_drawing():
    check = with_wheel(tip_thickness_normal=0.49e-3, tip_thickness_normal_min=None)["gears.shaft.tip_thickness"]
    assert check.verdict == "fail" and check.value_id == "gears.shaft.tip_thickness_normal"


# --- where the limit is 0
@pytest.mark.parametrize("name", ["tip_clearance_least", "interference", "interference_least"])
def test_a_twentieth_of_a_quarter_module_is_narrow(name):
    field = {"tip_clearance_least": "tip_clearance_min", "interference": "form_margin_driver"}.get(
        name, "form_margin_min"
    )
    for share, verdict in ((0.05 * 0.25 * M_N * (1 + LITTLE), "pass"), (0.05 * 0.25 * M_N * (1 - LITTLE), "warn")):
        check = with_mesh(**{"form_margin_driven": 1e-3, field: share})[f"gears.{PAIR}.{name}"]
        assert check.verdict == verdict and check.zero_scale == pytest.approx(0.5)
        assert check.rule.zero == "0.25 m_n"


def test_a_limit_of_the_undercut_may_be_0():
    narrow, wide = (
        with_wheel(undercut_limit=0.0, profile_shift=0.0125 * x)["gears.shaft.undercut"] for x in (0.999, 1.001)
    )
    assert (narrow.verdict, wide.verdict) == ("warn", "pass")


# --- the tighter side, and what helps
@pytest.mark.parametrize("low, cut", [("driver", "shaft"), ("driven", "idler")])
def test_the_mate_of_the_tighter_root_is_cut(low, cut):
    """A tip that comes too close to a root by 0.1 mm loses that much, beside the 0.2 mm that are cut off the idler's."""
    roomy = {"tip_clearance_driver": 1e-3, "tip_clearance_driven": 1e-3}
    check = with_mesh(**{**roomy, f"tip_clearance_{low}": 0.2e-3})[f"gears.{PAIR}.tip_clearance"]
    (way,) = check.remedies
    assert way.changes == ((f"gears.wheels.{cut}.tip_shortening_mm", 0.3 if cut == "idler" else 0.1),)
    assert f"of {cut} at least" in way.words
    for beside, tips in ((0.99e-6, 2), (1.01e-6, 1)):  # less than 1 µm beside it, the other tip is as bad
        pair = {"tip_clearance_driver": 0.2e-3, "tip_clearance_driven": 0.2e-3 + beside}
        assert len(with_mesh(**pair)[f"gears.{PAIR}.tip_clearance"].remedies[0].changes) == tips


def test_a_tip_that_jams_with_room_on_the_drawing_is_not_cut():
    """Its tolerances are what jams."""
    roomy = {"tip_clearance_driver": 0.3e-3, "tip_clearance_driven": 0.4e-3}
    jams, close = (
        with_mesh(**{**roomy, **less}, tip_clearance_min=-1e-6)[f"gears.{PAIR}.tip_clearance_least"]
        for less in ({}, {"tip_clearance_driver": 0.2992e-3})
    )
    assert jams.remedies == () and close.remedies[0].changes == (("gears.wheels.shaft.tip_shortening_mm", 0.001),)


@pytest.mark.parametrize("limit, enough", [(0.12341, 0.1235), (-0.56789, -0.5678)])
def test_the_shift_that_just_avoids_an_undercut(limit, enough):
    check = with_wheel(undercut_limit=limit, profile_shift=limit - 0.1)["gears.shaft.undercut"]
    assert check.remedies[0].changes == (("gears.wheels.shaft.profile_shift", enough),)
    assert "at least" in check.remedies[0].words


@pytest.mark.parametrize("tight, mate", [("driver", "shaft"), ("driven", "idler")])
def test_the_tip_that_works_low_is_said(tight, mate):
    roomy = {"form_margin_driver": 1e-3, "form_margin_driven": 1e-3}
    check = with_mesh(**{**roomy, f"form_margin_{tight}": -1e-3})[f"gears.{PAIR}.interference"]
    assert f"The tip of {mate} works low" in check.advice and check.verdict == "fail"


def test_a_cut_that_is_asked_for_is_enough():
    """The tip that is cut as it is said arrives where the fillet ends."""
    short = solved(r753(tool=(1.25, 0.38)))
    for key, mesh in short.meshes.items():
        check = next(c for c in checks(GEARS, short) if c.id == f"gears.{key}.interference_usual")
        ((key_of_cut, cut),) = check.remedies[0].changes
        name = key_of_cut.split(".")[2]
        tip = short.wheels[name].tip_diameter / 2 - (cut - (0.2 if name == "idler" else 0.0)) * 1e-3
        wheel = short.wheels[mesh.driver if name == mesh.driven else mesh.driven]
        base, mate = wheel.base_diameter / 2, short.wheels[name].base_diameter / 2
        rho = mesh.line_of_action - (tip**2 - mate**2) ** 0.5
        reached = (base**2 + rho**2) ** 0.5 - wheel.form_diameter / 2
        assert 0.1 * M_N <= reached < 0.1 * M_N + 0.03e-3


# --- the train
def test_the_speed_ratio_is_kept_to_a_billionth():
    turning = replace(TRAIN, shafts={"shaft": replace(TRAIN.shafts["shaft"], speed_ratio=-1.0)})
    inside, outside = (speed_ratio_check(turning, "shaft", -1.0 - off) for off in (0.99e-9, 1.01e-9))
    assert inside.holds and outside.verdict == "fail"
    assert "number of meshes" in outside.source and inside.role == "self"
    assert speed_ratio_check(turning, "shaft", -1.0 - 0.99e-12).value == 0.0
    assert speed_ratio_check(turning, "shaft", -1.0 - 1.01e-12).value == pytest.approx(1.01e-12, rel=1e-3)


@pytest.mark.parametrize(
    "wanted, crank, value, name, advice",
    [
        (
            -2.0,
            None,
            1.0,
            "shaft to crank, −1: off the wanted −2",
            "give shaft 0.5 times the teeth of crank and an odd",
        ),
        (-1.0, 2 * SPEED, 0.5, "shaft to the crank, −0.5: off", "give shaft 0.5 times the teeth of crank and an odd"),
        (0.2, None, 1.2, "shaft to crank, −1: off the wanted +0.2", "give shaft 125 teeth and an even number"),
        (-0.2, 5 * SPEED, 0.0, "shaft to the crank, −0.2: off", "give shaft 25 teeth and an odd number"),
    ],
)
def test_the_speed_ratio_is_that_of_the_last_wheel_to_the_crank(wanted, crank, value, name, advice):
    """Of all wheels on the way from the first driver."""
    check = speed_ratio_check(TRAIN, "shaft", wanted, crank)
    assert check.value == pytest.approx(value, abs=1e-12) and name in check.name
    assert "crank 25 → central 36 → idler 39 → shaft 25" in check.advice and "by 3 meshes" in check.advice
    assert advice in check.advice
    assert check.moved_by == tuple(f"gears.wheels.{w}.teeth" for w in ("shaft", "idler", "central", "crank"))


# --- limits
@pytest.mark.parametrize("rho_a, reached", [(2e-3, 13.0), (7e-3, 12.0), (7.5e-3, 11.5)])
def test_where_the_tip_of_the_mate_arrives(rho_a, reached):
    """In mm: on the involute by Pythagoras, past the base circle along the line of action."""
    c_F = above_fillet(d_b=24e-3, T=7e-3, rho_a=rho_a, d_Ff=22e-3)
    assert c_F == pytest.approx((reached - 11.0) * 1e-3)


def test_a_length_in_a_sentence_is_in_millimetres():
    assert str(mm(12.5e-3)) == "12.5" and str(mm(12.5e-3, ".2f")) == "12.50"
