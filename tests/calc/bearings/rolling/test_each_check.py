# SPDX-License-Identifier: Apache-2.0
"""Every check of rolling bearings: just inside its limit, just outside, and what is no number."""

import math
from dataclasses import replace

import pytest

from calc.bearings.result import BearingsResult
from calc.bearings.rolling import checks as declared
from calc.bearings.rolling.checks import rolling_checks
from calc.bearings.rolling.kind import Rolling
from calc.bearings.support import ShaftInView
from calc.countershaft.outline import Piece
from calc.design.toml_file import design, parse
from calc.library.catalogue import shipped_materials
from calc.sheet.check import CheckRule
from calc.solve import solve
from tests.calc.bearings.rolling.test_bearing import PROFILE, REFERENCE, TWO, with_rows

H, UM, RPM = 3600.0, 1e-6, 1 / 60
ALL = {rule.id: rule for rule in vars(declared).values() if isinstance(rule, CheckRule)}
INSIDE = {"limit": "warn", "caution": "pass", "advice": "pass", "method": "pass"}  # a limit that just holds is narrow
OUTSIDE = {"limit": "fail", "caution": "warn", "advice": "note", "method": "note"}


@pytest.fixture(scope="module")
def bearings():
    """Rollers and a flanged bearing, a ball bearing and a drawn cup, and a cage in the place of the cup."""
    found = {}
    for name in (TWO, PROFILE):
        rows = solve(design(parse(REFERENCE["designs"][name].encode(), "x.toml"))).result(BearingsResult).bearings
        found |= {r.row.size: r for r in rows.values()}
    cage = solve(design(with_rows(PROFILE, rear={"size": "K25x30x20"}))).result(BearingsResult).bearings["rear"]
    return found | {"K25x30x20": cage}


def row_of(r, **keys):
    """With other inputs of its row."""
    return replace(r, case=replace(r.case, row=replace(r.case.row, **keys)))


def of_inputs(r, **keys):
    return replace(r, case=replace(r.case, inputs=replace(r.case.inputs, **keys)))


def asked(r, x):
    return of_inputs(replace(r, life=x), life=5000 * H)


def at_gap(name):
    def at(r, x):
        published = {"frozen": "clearance_cold"}.get(name, f"clearance_{name}")
        return replace(r, gap=replace(r.gap, **{name: x}), **{published: x})

    return at


def of_shares(share):
    def of(r, x):
        rows = declared_rows(r, share)
        return replace(r, rows=rows, carries=((x, 100.0), (1e4, 100.0)))

    return of


def declared_rows(r, share):
    import numpy as np

    from calc.bearings.rolling.solve import Rows

    none = np.zeros(2)
    return Rows(("a", "b"), none + 40, np.array([share, 1 - share]), none + 100, none, none + 1, (None, None))


def on_alloy(r, name):
    return replace(r, case=replace(r.case, solids=replace(r.case.solids, housing=shipped_materials()[name])))


def of_gamma(r, gamma):
    inside = replace(r.case.inside, diameter=gamma * r.case.inside.pitch)
    return replace(r, case=replace(r.case, inside=inside))


NU, NJ, BALL, CUP, CAGE = "NU205", "NJ205", "6305", "HK3020", "K25x30x20"
TABLE = [
    # check, of which bearing, how its value comes, just inside, just outside, the limit as shown
    ("life", NU, asked, 5001 * H, 4999 * H, 5000.0),
    ("life_assumed", NU, lambda r, x: replace(r, life=x), 5001 * H, 4999 * H, 5000.0),
    ("life_reference", NU, lambda r, x: replace(r, life_reference=x), 5001 * H, 4999 * H, 5000.0),
    ("static_safety", NU, lambda r, x: replace(r, static_safety=x), 1.501, 1.499, 1.5),
    ("static_safety", BALL, lambda r, x: replace(r, static_safety=x), 1.001, 0.999, 1.0),
    ("static_safety", CUP, lambda r, x: replace(r, static_safety=x), 3.001, 2.999, 3.0),
    ("speed_factor", NU, lambda r, x: replace(r, task=replace(r.task, speed=x)), 15584 * RPM, 15585 * RPM, 15584.4156),
    ("speed_factor", NU, lambda r, x: row_of(r, limiting_speed=2600 / 60 / x), 0.999, 1.001, None),
    ("running_temperature", NU, lambda r, x: replace(r, hottest=x), 119.9, 120.1, 120.0),
    ("running_temperature", NU, lambda r, x: row_of(replace(r, hottest=x), cage="steel"), 149.9, 150.1,
     150.0),
    ("clearance_least", NU, at_gap("least"), 0.1 * UM, -0.1 * UM, 0.0),
    ("clearance_start", NU, at_gap("start"), 0.1 * UM, -0.1 * UM, 0.0),
    ("clearance_frozen", NU, at_gap("frozen"), 0.1 * UM, -0.1 * UM, 0.0),
    ("grip_hot", NU, lambda r, x: replace(r, grip_hot=x), 0.1 * UM, -0.1 * UM, 0.0),
    ("grip_hot_held", NU, lambda r, x: row_of(replace(r, grip_hot=x), outer_ring_held="pin"), 0.1 * UM, -0.1 * UM, 0.0),
    ("slope", NU, lambda r, x: replace(r, slope=x), 1.159e-3, 1.161e-3, 1.16),
    ("slope", BALL, lambda r, x: replace(r, slope=x), 2.899e-3, 2.901e-3, 2.9),
    ("slope", CUP, lambda r, x: replace(r, slope=x), 0.289e-3, 0.291e-3, 0.29),
    ("slope_near", NU, lambda r, x: replace(r, slope=x), 0.579e-3, 0.581e-3, 0.58),
    ("minimum_load", NU, lambda r, x: replace(r, carries=((x, 100.0),)), 100.1, 99.9, 100.0),
    ("minimum_load", NU, of_shares(0.021), 100.1, 99.9, 100.0),
    ("minimum_load_rare", NU, of_shares(0.019), 100.1, 99.9, 100.0),
    ("thrust", NJ, lambda r, x: replace(r, axial=x * r.equivalent_load), 0.499, 0.501, 0.5),
    ("raceway_hardness", CUP, lambda r, x: row_of(r, raceway_hardness=x), 671.0, 669.0, 670.0),
    ("raceway_case", CUP, lambda r, x: row_of(r, case_depth=x), 0.301e-3, 0.299e-3, 0.3),
    ("raceway_roughness", CUP, lambda r, x: row_of(r, raceway_roughness=x), 0.199 * UM, 0.201 * UM, 0.2),
    ("viscosity_ratio", NU, lambda r, x: replace(r, viscosity_ratio=x), 1.001, 0.999, 1.0),
    ("friction_spread", NU, lambda r, x: replace(r, torque=x * r.torque_two_part), 1.999, 2.001, 2.0),
    ("friction_spread", NU, lambda r, x: replace(r, torque=r.torque_two_part / x), 1.999, 2.001, 2.0),
    ("reference_speed", NU, lambda r, x: replace(r, reference_speed=r.task.speed / x), 0.999, 1.001, None),
]  # fmt: skip


def made(r):
    return {c.id.removeprefix("bearings.front."): c for c in rolling_checks("front", r)}


@pytest.mark.parametrize(("name", "of", "of_value", "inside", "outside", "limit"), TABLE)
def test_just_inside_and_just_outside(bearings, name, of, of_value, inside, outside, limit):
    kind = ALL[f"bearings.B.{name}"].kind
    good, bad = (made(of_value(bearings[of], x))[name] for x in (inside, outside))
    assert good.verdict == (INSIDE[kind] if not good.rule.exact else "pass")
    assert bad.verdict == OUTSIDE[kind]
    if limit is not None:
        assert good.limit == pytest.approx(limit)


@pytest.mark.parametrize(
    ("name", "of_value"),
    [(name, of_value) for name, of, of_value, *_ in TABLE if of == NU and name not in ("minimum_load_rare",)],
)
def test_what_is_no_number_does_not_hold(bearings, name, of_value):
    check = made(of_value(bearings[NU], math.nan))[name]
    assert not check.holds and check.verdict == OUTSIDE[check.kind]


@pytest.mark.parametrize(
    ("name", "of_value", "known", "outside"),
    [
        ("viscosity_ratio_outside", lambda r, x: replace(r, viscosity_ratio=x), 0.101, 0.099),
        ("viscosity_ratio_outside", lambda r, x: replace(r, viscosity_ratio=x), 3.99, 4.01),
        ("temperature_outside", lambda r, x: replace(r, hottest=x), 199.9, 200.1),
        ("geometry_outside", of_gamma, 0.399, 0.401),
    ],
)
def test_what_no_formula_knows_is_said_there_alone(bearings, name, of_value, known, outside):
    assert name not in made(of_value(bearings[NU], known))
    assert made(of_value(bearings[NU], outside))[name].verdict == "note"


def test_a_rating_that_is_computed_is_an_estimate(bearings):
    r = bearings[NU]
    for C, C_0, verdict in ((None, None, "note"), (3e4, None, "note"), (None, 3e4, "note"), (3e4, 3e4, "pass")):
        assert made(row_of(r, dynamic_rating=C, static_rating=C_0))["rating_estimate"].verdict == verdict


def test_needles_without_a_ring_need_a_hard_bore(bearings):
    cage = bearings[CAGE]
    assert made(on_alloy(cage, "EN AC-43100"))["raceway_seat"].verdict == "fail"
    assert made(on_alloy(cage, "steel"))["raceway_seat"].verdict == "pass"
    assert made(row_of(on_alloy(cage, "EN AC-43100"), outer_ring_held="insert"))["raceway_seat"].verdict == "pass"
    assert "raceway_seat" not in made(bearings[CUP])


def test_what_is_asked_of_whom(bearings):
    """Raceways of what has no inner ring, thrust of flanges, a grip of what has a ring; of a load that turns alone."""
    for size, there in ((NU, set()), (CUP, {"raceway_hardness", "raceway_case", "raceway_roughness"})):
        assert {name for name in made(bearings[size]) if name.startswith("raceway_")} == there
    assert "thrust" not in made(bearings[NJ]) and "grip_hot" in made(bearings[CUP])
    assert "grip_hot" not in made(bearings[CAGE])
    assert "grip_hot" not in made(replace(bearings[NU], standing_load=bearings[NU].load + 1))


def test_what_is_not_given_is_not_verified(bearings):
    found = made(bearings[CUP])
    assert found["raceway_case"].verdict == found["slope"].verdict == "not_verified" and "slope_near" not in found
    unknown = replace(bearings[NU], gap=None, life_reference=None, clearance_least=None, clearance_start=None)
    found = made(replace(unknown, clearance_cold=None))
    for name in ("life_reference", "clearance_least", "clearance_start", "clearance_frozen"):
        assert found[name].verdict == "not_verified", name


def test_no_load_has_no_life(bearings):
    found = made(replace(bearings[NU], life=None, static_safety=None, carries=((0.0, 150.0),)))
    assert not {"life", "life_assumed", "life_reference", "static_safety"} & found.keys()
    assert found["minimum_load"].verdict == "warn"


# --- of all bearings of a shaft
def view(outline=None, bearings=2):
    return ShaftInView(None, 1.0, 43.3, bearings, outline)


def of_shaft(results, **more):
    return {c.id: c for c in Rolling().checks(results, view(**more))}


def test_somebody_locates_the_shaft(bearings):
    two = {"front": bearings[NU], "rear": bearings[NJ]}
    assert of_shaft(two)["bearings.locating"].verdict == "warn"
    located = two | {"rear": row_of(two["rear"], locates=True)}
    assert of_shaft(located)["bearings.locating"].verdict == "pass"
    assert "bearings.locating" not in of_shaft(two, bearings=3)  # a plain one beside them may


class Outline:
    def __init__(self, *pieces):
        self.pieces = pieces


@pytest.mark.parametrize(("radius", "verdict"), [(12.5e-3, "pass"), (12.6e-3, "fail")])
def test_a_ring_passes_the_shaft_to_its_place(bearings, radius, verdict):
    """From the end that has more room, a wheel left out; not asked of a cage in halves."""
    end, core, wheel = (Piece(*at, r, 0.0, None, 0.0, what) for *at, r, what in (
        (-0.2, -0.18, radius, "full"), (-0.15, 0.2, 30e-3, "full"), (-0.25, -0.2, 60e-3, "gear")))  # fmt: skip
    found = of_shaft({"front": bearings[NU]}, outline=Outline(wheel, end, core))
    assert found["bearings.front.assembly"].verdict == verdict
    split = {"front": row_of(bearings[CAGE], split_cage=True)}
    assert "bearings.front.assembly" not in of_shaft(split, outline=Outline(end, core))


@pytest.mark.parametrize(("life", "verdict"), [(5001 * H, "pass"), (4999 * H, "warn")])
def test_all_live_together(bearings, life, verdict):
    (check,) = Rolling().renewed({"front": bearings[NU], "rear": bearings[NJ]}, life)
    assert check.verdict == verdict
    assert not [*Rolling().renewed({"front": bearings[NU]}, life)]


def test_every_check_is_here():
    known = {f"bearings.B.{name}" for name, *_ in TABLE} | {"bearings.system_life", "bearings.locating"}
    known |= {f"bearings.B.{name}" for name in ("assembly", "raceway_seat", "rating_estimate")}
    known |= {f"bearings.B.{name}_outside" for name in ("viscosity_ratio", "temperature", "geometry")}
    assert known == set(ALL)
