# SPDX-License-Identifier: Apache-2.0
"""Each check of the rating just inside its limit and just outside it, what is not known of the engine's irregularity,
and the formulas that are used outside their validity."""

import math
from dataclasses import replace

import pytest

from calc.design.toml_file import design, read
from calc.gears import solve
from calc.gears.rating.checks import (
    application_factor_check,
    flank_reversal_check,
    hardness_checks,
    influence_checks,
    mesh_checks,
    roughness_check,
    screening_checks,
    strength_checks,
)
from calc.gears.rating.classes import strength_class
from calc.gears.rating.irregular import Irregular, MeshTorques
from calc.gears.rating.load import UNEVEN, USUAL, RatingLoad, Surroundings, loads
from calc.library.catalogue import materials, oils
from calc.library.lubricant import Lubricant
from calc.sheet.check import stretched
from calc.solve import solve as solve_design
from tests.calc.gears.trains import r753, solved
from tests.conftest import DESIGNS

GEARS = r753()
TRAIN = solved(GEARS)
KEY = "central_idler"
MESH = TRAIN.meshes[KEY]
OIL = Surroundings(lubricant=Lubricant(oils()["10W-40 Q8 T905"]), oil_temperature=90.0)
STEEL = materials()
LITTLE = 1e-6
HEAVY = 60.0  # N·m: no formula is outside its validity


def rated(torque=HEAVY, around=OIL, gears=GEARS):
    return solve.rating(gears, TRAIN, torque, STEEL, around)


RATED = rated().result.meshes[KEY]


def by_name(checks):
    return {check.id.rpartition(".")[2]: check for check in checks}


def of_influence(**changes):
    mesh = replace(MESH, shift_sum=changes.pop("shift_sum", MESH.shift_sum))
    return by_name(influence_checks(KEY, mesh, replace(RATED.influence, **changes)))


def of_screening(**changes):
    return by_name(screening_checks(KEY, replace(RATED.screening, **changes)))


def of_notch(q_s):
    form = replace(RATED.forms["idler"], q_s=q_s)
    return by_name(mesh_checks(KEY, MESH, replace(RATED, forms={"idler": form}), RatingLoad(1.0, None, None, 1.0, 1.0)))


def of_flanks(S_H):
    contact = {name: replace(RATED.strength.contact[name], S_H=x) for name, x in zip(("central", "idler"), S_H)}
    return by_name(strength_checks({KEY: replace(RATED.strength, contact=contact)}))


def of_roots(S_F):
    bending = {name: replace(root, S_F=S_F) for name, root in RATED.strength.bending.items()}
    return by_name(strength_checks({KEY: replace(RATED.strength, bending=bending)}))


def of_hardness(HV):
    return by_name(hardness_checks("idler", replace(strength_class("case-hardened", "MQ", 700.0), hardness=HV)))


# check, how it is made of a number, its limit, on which side of it is inside, verdicts inside and outside, source
EACH = [
    ("line_load", lambda x: of_influence(line_load=x), 50e3, 1, ("pass", "note"), "below 50 N/mm flanks can part"),
    (
        "resonance",
        lambda x: of_influence(resonance_ratio=x, lower_resonance=0.7),
        0.7,
        -1,
        ("pass", "warn"),
        "from N_S to 1.15",
    ),
    (
        "resonance",
        lambda x: of_influence(resonance_ratio=x, lower_resonance=0.7),
        1.15,
        1,
        ("pass", "warn"),
        "from N_S to 1.15",
    ),
    ("shift_sum", lambda x: of_influence(shift_sum=x), -0.5, 1, ("pass", "note"), "clause 9"),
    ("shift_sum", lambda x: of_influence(shift_sum=x), 2.0, -1, ("pass", "note"), "clause 9"),
    ("contact_width", lambda x: of_influence(contact_width_share=x), 1.0, 1, ("pass", "warn"), "K_Hβ up to 2"),
    ("notch_idler", of_notch, 1.0, 1, ("pass", "note"), "range of Y_S"),
    ("notch_idler", of_notch, 8.0, -1, ("pass", "note"), "range of Y_S"),
    ("safety_contact", lambda x: of_flanks((x, 9.0)), 1.0, 1, ("warn", "fail"), "the usual 1 to 1.2"),
    ("safety_contact", lambda x: of_flanks((9.0, x)), 1.0, 1, ("warn", "fail"), "the usual 1 to 1.2"),
    ("safety_contact_usual", lambda x: of_flanks((x, 9.0)), 1.2, 1, ("pass", "note"), "1.15 to 1.2"),
    ("safety_bending", of_roots, 1.4, 1, ("warn", "fail"), "the usual 1.4 to 1.6"),
    ("safety_bending_usual", of_roots, 1.6, 1, ("pass", "note"), "1.4 to 1.45"),
    ("hardness", of_hardness, 660.0, 1, ("warn", "fail"), "ISO 6336-5:2016, Table 1"),
    ("hardness_most", of_hardness, 800.0, -1, ("pass", "note"), "ISO 6336-5:2016, Table 1"),
    (
        "micropitting_film",
        lambda x: of_screening(specific_film_min=x, permissible_film=0.3),
        0.3,
        1,
        ("pass", "note"),
        "ISO/TR 15144-1:2014",
    ),
    ("scuffing", lambda x: of_screening(scuffing_margin=x), 50.0, 1, ("pass", "warn"), "10.5: for instance 50 K"),
    (
        "root_roughness",
        lambda x: {"root_roughness": roughness_check(x)},
        40e-6,
        -1,
        ("pass", "note"),
        "found up to 40 µm",
    ),
]


@pytest.mark.parametrize("name, made_of, limit, side, verdicts, source", EACH)
def test_each_check(name, made_of, limit, side, verdicts, source):
    inside, outside = (made_of(limit * (1 + sign * LITTLE * math.copysign(1.0, limit)))[name] for sign in (side, -side))
    assert (inside.verdict, outside.verdict) == verdicts
    assert source in outside.source


def test_the_weaker_flank_is_named_and_what_would_just_do_is_advised():
    check = of_flanks((0.9, 0.8))["safety_contact"]
    assert check.value == 0.8 and "weaker: idler" in check.name and "on load 0.64" in check.name
    assert f"more than {1 / 0.64:.3g} times the face width" in check.advice and "less than 0.64 of it" in check.advice
    assert "1.27 times the face width" in of_roots(1.1)["safety_bending"].advice


@pytest.mark.parametrize("safeties, least, pair", [((1.5, 2.0), 1.5, KEY), ((2.0, 1.5), 1.5, "idler_shaft")])
def test_the_root_of_a_wheel_counts_in_the_mesh_that_is_worse(safeties, least, pair):
    """Of both meshes of the idler; where it carries nothing it has no safety."""
    rated_ = rated().result.meshes

    def of_idler(*safeties):
        meshes = {}
        for key, S_F in zip((KEY, "idler_shaft"), safeties):
            strength = rated_[key].strength
            bending = {**strength.bending, "idler": replace(strength.bending["idler"], S_F=S_F)}
            meshes[key] = replace(strength, bending=bending)
        checks = {c.id: c for c in strength_checks(meshes)}
        return checks.get("gears.idler.safety_bending")

    check = of_idler(*safeties)
    assert check.value == least and TRAIN.meshes[pair].title in check.name
    assert of_idler(None, 2.0).value == of_idler(2.0, None).value == 2.0 and of_idler(None, None) is None


def test_flanks_that_carry_nothing_are_not_judged():
    assert "safety_contact" not in of_flanks((None, None)) and of_flanks((None, 2.0))["safety_contact"].value == 2.0


@pytest.mark.parametrize("name, end, side", [("hardness", 110, 1), ("hardness_most", 210, -1)])
def test_the_hardness_of_a_class_in_brinell(name, end, side):
    """HBW = 0.95 HV, ISO 18265: 110 to 210 HBW."""
    cls = strength_class("normalised steel", "MQ", 200.0)
    inside, outside = (
        by_name(hardness_checks("idler", replace(cls, hardness=end / 0.95 + off)))[name] for off in (side, -side)
    )
    assert inside.holds and not outside.holds and outside.limit == pytest.approx(end / 0.95)
    assert "110 to 210 HBW" in outside.source
    assert not [*hardness_checks("idler", replace(cls, hardness=None))]


def test_how_smooth_the_roots_have_to_be_is_said():
    (way,) = roughness_check(41e-6).remedies
    assert way.changes == (("gears.root_rz_um", 40.0),) and "at most 40 µm" in way.words


def test_below_the_load_of_the_standard_the_contact_over_the_width_is_not_judged():
    assert "contact_width" in of_influence(line_load=50e3)
    assert "contact_width" not in of_influence(line_load=49.9e3)


@pytest.mark.parametrize("ratio, sense", [(1.0, "<="), (1.001, ">=")])
def test_the_resonance_is_kept_away_from_on_either_side(ratio, sense):
    check = of_influence(resonance_ratio=ratio)["resonance"]
    assert check.sense == sense and check.verdict == "warn"


def test_the_oil_is_tested_from_the_pressure_of_its_first_stage_on():
    film = dict(specific_film_min=0.1, permissible_film=0.3)
    low, high = (of_screening(**film, film_pressure=p)["micropitting_film"].advice for p in (799e6, 801e6))
    assert "about 800 MPa" in low and "Have the oil tested" in high


# --- the application factor, and the sign of the torque
@pytest.mark.parametrize("K_A, verdict", [(1.5 + LITTLE, "pass"), (1.5 - LITTLE, "warn")])
@pytest.mark.parametrize("mean", [4.0, -4.0])
def test_a_given_factor_covers_mean_and_dynamic_torque(K_A, verdict, mean):
    load = RatingLoad(mean, 2.0, 2.0, mean, K_A)
    check = application_factor_check(KEY, "central–idler", load)
    assert check.verdict == verdict and check.kind == "caution" and "dynamic torque over the mean" in check.source


@pytest.mark.parametrize("least, verdict", [(0.0, "pass"), (-LITTLE, "note")])
def test_flanks_leave_each_other_where_the_torque_changes_its_sign(least, verdict):
    check = flank_reversal_check(KEY, "central–idler", RatingLoad(-4.0, 2.0, least, 6.0, 1.0, of_peak=True))
    assert check.verdict == verdict and check.scale == 4.0 and "does not change its sign" in check.source


def test_what_is_not_known_of_the_torque_is_said():
    check = flank_reversal_check(KEY, "central–idler", RatingLoad(4.0, None, None, 4.0, USUAL, assumed=True))
    assert check.verdict == "note" and "not known" in check.name and math.isnan(check.value)
    assert (check.limit, check.scale) == (0.0, 4.0)
    assert check.missing == ("gears.application_factor", "gears.speed_irregularity")
    assert [str(text) for text in check.taken] == ["application factor 1.25"]
    given = RatingLoad(4.0, None, None, 4.0, 1.5)
    assert flank_reversal_check(KEY, "central–idler", given) is None
    idle = RatingLoad(0.0, None, None, 0.0, USUAL, assumed=True)
    assert flank_reversal_check(KEY, "central–idler", idle) is None


# --- the irregularity of the engine
def safeties(outcome):
    return {c.id: c for c in outcome.checks if c.id.rpartition(".")[2] in ("safety_contact", "safety_bending")}


def test_without_irregularity_the_worst_end_is_a_rating_at_five():
    """K_V and K_Hβ follow the load; what is not known of the engine spares no other check."""
    unknown, at_five = safeties(rated()), safeties(rated(gears=replace(GEARS, application_factor=5.0)))
    assert len(unknown) == 3 + 4
    for id, check in unknown.items():
        assert check.at_best == check.value and check.at_worst == pytest.approx(at_five[id].value, rel=1e-12)
        assert at_five[id].missing == () and at_five[id].at_worst is None
        assert check.missing == ("gears.application_factor", "gears.speed_irregularity")
    contact = unknown["gears.central_idler.safety_contact"]
    assert contact.at_worst > contact.value * math.sqrt(USUAL / UNEVEN) and UNEVEN == 5.0


def of_design(name, **said):
    document = read(DESIGNS / f"{name}.toml")
    for key, value in said.items():
        document = document.with_value(f"gears.{key}", value)
    checks = solve_design(design(document)).checks()
    return [c for c in checks if c.id.rpartition(".")[2] in ("safety_contact", "safety_bending")]


def test_a_parallel_twin_needs_no_flywheel():
    """At its worst it is as if the irregularity were given that is assumed at idle speed, δ = 0.06, or by the usual
    1.25, which is about as much; before what the small load per width takes from that.  The roots are loaded from both
    sides there."""
    checks = of_design("twin_drive")
    assert len(checks) == 3 + 4 and all(c.outside and c.missing and c.verdict == "pass" for c in checks)
    rated = design(read(DESIGNS / "twin_drive.toml")).engine.rated_speed * 60
    idle = min(max(0.13 * rated, 600), 1300)
    given = {c.id: c for c in of_design("twin_drive", speed_irregularity=0.06 * (idle / rated) ** 2)}
    for check in checks:
        assert given[check.id].missing == ()
        if check.id.endswith("contact"):
            assert check.at_worst * math.sqrt(2.0) == pytest.approx(given[check.id].value, rel=3e-3)
        else:
            assert check.at_worst * 2.0 == pytest.approx(given[check.id].value, rel=1e-2)


@pytest.mark.parametrize(
    "name, assumed", [("finotti_gear_sheet", False), ("r753ie4_gamma", True), ("r753ie4_sized", True)]
)
def test_the_safeties_of_shipped_designs_are_verified(name, assumed):
    checks = of_design(name)
    assert len(checks) > 4 and {c.verdict for c in checks} == {"pass"}
    assert {bool(c.missing) for c in checks} == {assumed}


def test_a_known_irregularity_is_no_unknown():
    every = {key: MeshTorques(0.1, (0.1,), (1.0,)) for key in TRAIN.meshes}
    known = safeties(rated(around=replace(OIL, uneven=Irregular(every, assumed=False))))
    assert {check.missing for check in known.values()} == {()}


def test_an_irregularity_that_is_assumed_takes_the_place_of_the_worst_factor():
    """K_A at its worst is the peak over the mean, in place of 5, and not below the usual 1.25."""
    for dynamic, worst in ((HEAVY, 2.0), (2 * HEAVY, 3.0), (0.1 * HEAVY, 1.25)):
        every = {key: MeshTorques(dynamic, (dynamic,), (1.0,)) for key in TRAIN.meshes}
        load = loads(GEARS, TRAIN, {KEY: HEAVY}, Irregular(every, assumed=True))[KEY]
        assert (load.K_A, load.at_worst, load.dynamic) == (USUAL, pytest.approx(worst), None)
        around = replace(OIL, uneven=Irregular(every, assumed=True))
        check = safeties(rated(dict.fromkeys(TRAIN.meshes, HEAVY), around))["gears.idler.safety_bending"]
        given = rated(dict.fromkeys(TRAIN.meshes, HEAVY), OIL, replace(GEARS, application_factor=worst))
        at_worst = safeties(given)["gears.idler.safety_bending"].value
        assert check.missing and check.at_worst == pytest.approx(at_worst, rel=0.02) and check.at_worst <= check.at_best


# on the wheel that is weakest in bending: at 1.25 and at 5
@pytest.mark.parametrize(
    "torque, state", [(5.0, "pass"), (HEAVY, "not_verified"), (400.0, "fail")], ids=["light", "usual", "heavy"]
)
def test_a_safety_is_verified_where_it_holds_at_both_ends(torque, state):
    check = safeties(rated(torque))["gears.idler.safety_bending"]
    ends = check.at_best >= 1.4, check.at_worst >= 1.4
    assert ends == {"pass": (True, True), "not_verified": (True, False), "fail": (False, False)}[state]
    assert check.verdict == state
    assert "How unevenly the engine turns is not known" in check.advice or state == "fail"


def test_a_wheel_without_a_class_is_not_verified():
    """Nobody knows its strength; its mates are rated with their other wheels."""
    soft = tuple(replace(w, material="EN AC-43100") if w.name == "shaft" else w for w in GEARS.wheels)
    checks = safeties(rated(gears=replace(GEARS, wheels=soft)))
    shaft = checks["gears.shaft.safety_bending"]
    assert shaft.verdict == "not_verified" and shaft.missing == ("gears.wheels.shaft.gear_material",)
    assert "no safety" in shaft.advice and "gears.idler_shaft.safety_contact" not in checks
    assert checks["gears.idler.safety_bending"].value > 0


# --- outside the validity
def weakened(method):
    """The factors by which checks are known less well when a check of the method is passed over."""
    roots = {
        wheel: replace(of_roots(2.8)["safety_bending"], id=f"gears.{wheel}.safety_bending") for wheel in TRAIN.wheels
    }
    flank = of_flanks((2.0, 2.0))["safety_contact"]
    checks = stretched((method, flank, *roots.values()))
    return {c.id: c.value / c.at_worst for c in checks if c.outside}


@pytest.mark.parametrize(
    "method, factors",
    [
        (of_influence(line_load=40e3)["line_load"], {"contact": math.sqrt(2.0), "central": 2.0, "idler": 2.0}),
        (of_influence(shift_sum=2.1)["shift_sum"], {"central": 1.3, "idler": 1.3}),
        (of_notch(9.0)["notch_idler"], {"idler": 1.3}),
        (roughness_check(41e-6), {"crank": 1.1, "central": 1.1, "idler": 1.1, "shaft": 1.1}),
    ],
    ids=["line_load", "shift_sum", "notch", "root_roughness"],
)
def test_a_formula_outside_its_validity_weakens_what_stands_on_it(method, factors):
    ids = {"contact": f"gears.{KEY}.safety_contact"}
    expected = {ids.get(name, f"gears.{name}.safety_bending"): factor for name, factor in factors.items()}
    assert weakened(method) == pytest.approx(expected)


def test_a_load_that_is_too_small_in_both_meshes_of_a_wheel_is_counted_once():
    low = of_influence(line_load=40e3)["line_load"]
    root = replace(of_roots(2.8)["safety_bending"], id="gears.idler.safety_bending")
    other = replace(low, id="gears.idler_shaft.line_load")
    *_, check = stretched((low, other, root))
    assert check.outside == (low.id, other.id) and check.at_worst == pytest.approx(1.4)
    assert check.verdict == "pass"
