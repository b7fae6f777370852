"""Checks: margin and verdict; numbers as they are written; records; the root finder."""

import math
from dataclasses import FrozenInstanceError, replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.sheet.check import RULES, CheckRule, Missing, stretched
from calc.sheet.functions import root
from calc.sheet.number import short
from calc.sheet.quantity import group, inputs, published, quantity, result, value
from calc.sheet.remedy import change, remedy
from calc.sheet.text import EMPTY, Text
from calc.sheet.units import Metre
from tests.made_checks import made_check, rule


@pytest.mark.parametrize(
    "value, sense, limit, unit, scale, margin",
    [
        (9.2, ">=", 9.0, "µm", None, 0.2 / 9),
        (8.0, ">=", 9.0, "µm", None, -1 / 9),
        (236.0, "<=", 235.0, "MPa", None, -1 / 235),
        (131.0, "<=", 135.0, "°C", None, 0.04),  # 100 K
        (-5.0, ">=", 0.0, "°C", None, -0.05),
        (0.5, "in", (0.2, 1.0), "", None, 0.3 / 0.8),  # its width
        (0.9, "in", (0.2, 1.0), "", None, 0.1 / 0.8),
        (-15.4, ">=", 0.0, "µm", 103.0, -15.4 / 103),
        (1.6, ">", 0.0, "µm", 32.0, 0.05),
        (math.nan, ">=", 1.0, "", None, math.nan),
        (2.0, ">=", 0.0, "", 0.0, math.inf),
        (0.0, ">=", 0.0, "", 0.0, 0.0),
        (3.0, "in", (3.0, 3.0), "", None, 0.0),
    ],
)
def test_a_margin_is_the_gap_over_its_scale(value, sense, limit, unit, scale, margin):
    check = made_check(value, sense, limit, unit=unit, zero_scale=scale)
    assert check.margin == pytest.approx(margin, nan_ok=True)


@pytest.mark.parametrize(
    "value, sense, limit, unit, scale, text",
    [
        (10.0, ">=", 9.0, "µm", None, "+11 %"),
        (20.8, ">=", 0.0, "µm", 100.0, "+20.8 µm"),
        (-8.7, ">=", 0.0, "µm", 100.0, "−8.7 µm"),
        (116.5, "<=", 135.0, "°C", None, "+18.5 K"),
        (2871.4, ">", 0.0, "W", 3000.0, "+2871 W"),
        (1000.4, ">", 0.0, "W", 3000.0, "+1000 W"),
        (999.4, ">", 0.0, "W", 3000.0, "+999 W"),
        (1.004, ">=", 1.0, "", None, "+0.4 %"),
        (1000.5, ">=", 1.0, "", None, "+99950 %"),
        (1001.5, ">=", 1.0, "", None, "beyond +99999 %"),
        (-1000.5, ">=", 1.0, "", None, "beyond −99999 %"),
        (0.5, "in", (0.0, 1.0), "", None, "+50 %"),
        (math.nan, ">=", 1.0, "", None, "no number"),
    ],
)
def test_a_margin_is_told_per_cent_and_that_of_nought_with_its_unit(value, sense, limit, unit, scale, text):
    assert made_check(value, sense, limit, unit=unit, zero_scale=scale).margin_text() == text


NO, HOLDS, NONE = None, "holds", "none"


@pytest.mark.parametrize(  # kind, value, sense, limit, unit, scale, best, worst, exact → finding
    "kind, value, sense, limit, unit, scale, best, worst, exact, finding",
    [
        ("limit", 4.6, ">=", 4.5, "µm", NO, NO, NO, False, "warn"),
        ("limit", 4.4, ">=", 4.5, "µm", NO, NO, NO, False, "fail"),
        ("limit", 1.6, ">", 0.0, "µm", 32.0, NO, NO, False, "pass"),
        ("limit", -0.2, ">", 0.0, "µm", 32.0, 20.8, -0.2, False, "not_verified"),
        ("limit", 131.0, "<=", 135.0, "°C", NO, NO, NO, False, "warn"),
        ("limit", 116.0, "<=", 135.0, "°C", NO, NO, NO, False, "pass"),
        ("limit", -34.7, ">=", 0.0, "µm", 107.0, -14.65, NONE, False, "fail"),
        ("limit", -15.4, ">=", 0.0, "µm", 103.0, 3.5, -15.4, False, "not_verified"),
        ("limit", 12.0, ">=", 0.0, "µm", 90.0, HOLDS, 12.0, False, "pass"),
        ("limit", 2.02, ">=", 1.0, "", NO, 2.02, 1.119, False, "pass"),
        ("limit", 2.02, ">=", 1.0, "", NO, 2.02, 0.9, False, "not_verified"),
        ("limit", 0.95, ">=", 1.0, "", NO, 0.95, 0.6, False, "fail"),
        ("limit", 180.0, "<=", 235.0, "MPa", NO, HOLDS, 180.0, False, "pass"),
        ("limit", 240.0, "<=", 235.0, "MPa", NO, HOLDS, 240.0, False, "not_verified"),
        ("limit", 130.5, "<=", 135.0, "°C", NO, 124.0, 130.5, False, "warn"),
        ("limit", 0.0, ">=", 0.0, "mm", 37.0, NO, NO, True, "pass"),
        ("limit", 0.0, ">=", 0.0, "mm", 37.0, NO, NO, False, "warn"),
        ("limit", 0.0, ">", 0.0, "mm", 37.0, NO, NO, True, "fail"),
        ("limit", 0.0, "<", 0.0, "mm", 37.0, NO, NO, True, "fail"),
        ("limit", 0.0, "<=", 0.0, "mm", 37.0, NO, NO, True, "pass"),
        ("limit", 0.5, "in", (0.2, 1.0), "", NO, NO, NO, False, "pass"),
        ("limit", 0.21, "in", (0.2, 1.0), "", NO, NO, NO, False, "warn"),
        ("limit", 0.1, "in", (0.2, 1.0), "", NO, NO, NO, False, "fail"),
        ("limit", math.nan, ">=", 4.5, "µm", NO, NO, NO, False, "fail"),
        ("limit", math.nan, ">=", 1.0, "", NO, NONE, NONE, False, "not_verified"),
        ("caution", 3.4, ">=", 6.2, "µm", NO, NO, NO, False, "warn"),
        ("caution", 6.3, ">=", 6.2, "µm", NO, NO, NO, False, "pass"),
        ("caution", 6.4, ">=", 6.2, "µm", NO, 7.0, NONE, False, "not_verified"),
        ("caution", -0.3, ">", 0.0, "µm", 50.0, 4.0, -0.3, False, "not_verified"),
        ("caution", -0.3, ">", 0.0, "µm", 50.0, -0.1, -0.3, False, "warn"),
        ("caution", math.nan, ">=", 1.0, "", NO, NO, NO, False, "warn"),
        ("advice", 3.4, ">=", 6.2, "µm", NO, 7.0, 3.4, False, "note"),
        ("advice", math.nan, ">=", 1.0, "", NO, NONE, NONE, False, "note"),
        ("method", 3.4, ">=", 6.2, "µm", NO, NO, NO, False, "note"),
        ("method", 9.0, ">=", 6.2, "µm", NO, NO, NO, False, "pass"),
    ],
)
def test_what_is_found_with_and_without_all_that_is_needed(
    kind, value, sense, limit, unit, scale, best, worst, exact, finding
):
    missing = () if best is None else ("gears.wheels.idler.runout_um",)
    check = made_check(
        value,
        sense,
        limit,
        kind,
        unit,
        zero_scale=scale,
        missing=missing,
        at_best=best,
        at_worst=worst,
        rule_of={"exact": exact},
    )
    assert check.finding == finding
    assert check.narrow is (finding == "warn" and kind == "limit")


@pytest.mark.parametrize(
    "kind, value, verdict",
    [
        ("limit", 0.5, "fail"),
        ("limit", 1.01, "warn"),
        ("caution", 0.5, "accepted"),
        ("advice", 0.5, "accepted"),
        ("method", 0.5, "accepted"),
        ("caution", 2.0, "pass"),
    ],
)
def test_a_limit_is_accepted_by_nobody(kind, value, verdict):
    check = made_check(value, kind=kind, accepted="seen on the test bench")
    assert check.verdict == verdict and check.open is (verdict in ("fail", "warn"))


@pytest.mark.parametrize(
    "value, sense, limit, demand, utilisation",
    [
        (2.0, "<=", 5.0, True, 0.4),
        (6.0, "<", 5.0, True, 1.2),
        (2.0, ">=", 1.0, True, 0.5),
        (2.0, "<=", 5.0, False, None),
        (0.0, ">=", 1.0, True, None),
        (2.0, "in", (1.0, 3.0), True, None),
    ],
)
def test_utilisation_is_demand_over_capacity(value, sense, limit, demand, utilisation):
    assert made_check(value, sense, limit, rule_of={"demand": demand}).utilisation == utilisation


@pytest.mark.parametrize(
    "value, sense, limit, share",
    [
        (7.4, ">=", 9.0, 7.4 / 9),
        (6.0, "<=", 5.0, 1.2),
        (1.1, "in", (0.2, 1.0), 1.1),
        (0.3, "in", (0.2, 1.0), 1.5),
        (0.0, ">=", 9.0, 0.0),
        (-1.0, ">=", 9.0, None),
        (2.0, ">=", 0.0, None),
    ],
)
def test_a_share_is_of_the_nearest_limit(value, sense, limit, share):
    assert made_check(value, sense, limit, zero_scale=1.0).share == (None if share is None else pytest.approx(share))


A, B, FRONT, IDLER = (
    "bearings.slope_mrad",
    "gears.module_mm",
    "gears.wheels.front.runout_um",
    "gears.wheels.idler.runout_um",
)
TAKEN = (Text("0.1 mrad"), Text("IT7"))


@pytest.mark.parametrize(
    "value, missing, taken, best, worst, words, in_short",
    [
        (2.0, (), (), NO, NO, "", ""),
        (2.0, (A,), TAKEN, 2.0, 1.2, "Assumed: 0.1 mrad; IT7.", "Assumed: 0.1 mrad; IT7."),
        (2.0, (A, B), TAKEN, 2.0, 1.2, "Assumed: 0.1 mrad; IT7.", "Assumed: 0.1 mrad; IT7."),
        (2.0, (A,), (), HOLDS, 2.0, f"Not given: {A}.", f"Not given: {A}."),
        (2.0, (), (), 2.0, 0.5, "At best 2, at worst 0.5.", "At best 2, at worst 0.5."),
        (
            2.0,
            (A, B),
            TAKEN,
            HOLDS,
            NONE,
            f"Not given: {A}, {B}; taken: 0.1 mrad; IT7. At best it can not fail, at worst nobody knows.",
            f"Not given: {A}; module_mm. At best it can not fail, at worst nobody knows.",
        ),
        (
            2.0,
            (FRONT, A, IDLER),
            TAKEN,
            2.0,
            0.5,
            f"Not given: {FRONT}, {A}, {IDLER}; taken: 0.1 mrad; IT7. At best 2, at worst 0.5.",
            f"Not given: runout_um of front, idler; {A}. At best 2, at worst 0.5.",
        ),
    ],
)
def test_what_is_not_given_in_words(value, missing, taken, best, worst, words, in_short):
    check = made_check(value, id="gears.front.name", missing=missing, taken=taken, at_best=best, at_worst=worst)
    assert (check.lack_text(), check.lack_in_short()) == (words, in_short)


# --- what is declared, and what is made of it


def test_a_declaration_fills_its_letters_and_shows_si_in_its_unit():
    edge = rule(
        "caution",
        "µm",
        id="bearings.B.edge_corner",
        cause="bearings.B.edge",
        value_id="bearings.B.corners.edge",
        limit_id="bearings.B.least",
        moved_by=("bearings.B.length_mm", "bearings.journal_fit"),
        name=Text("Film"),
        sense=">=",
    )
    check = edge(7.4e-6, 9e-6, at="front")
    assert (check.id, check.value, check.limit) == ("bearings.front.edge_corner", 7.4, 9.0)
    assert (check.limit_text(), check.margin_text(), check.name) == ("≥ 9 µm", "−18 %", "Film")
    assert (check.cause, check.value_id) == ("bearings.front.edge", "bearings.front.corners.edge")
    assert check.limit_id == "bearings.front.least" and check.base == 0
    assert edge(7.4e-6, (5e-6, 9e-6), at="front", sense="in").limit == (5.0, 9.0)
    assert check.moved_by == ("bearings.front.length_mm", "bearings.journal_fit")
    with pytest.raises(ValueError):
        edge(7.4e-6, 9e-6)  # of which bearing?


def test_the_letters_of_a_mesh_are_its_wheels_and_its_place():
    keys = ("gears.wheels.DRIVER.teeth", "gears.wheels.DRIVEN.teeth", "gears.meshes.#.tolerance_um")
    root = rule("method", id="gears.M.trial_W", value_id="gears.M.notch_parameter_W", moved_by=keys)
    check = root(1.0, 2.0, at=("rear_front", "front"), index=2)
    assert (check.id, check.value_id) == ("gears.rear_front.trial_front", "gears.rear_front.notch_parameter_front")
    assert check.moved_by == ("gears.wheels.rear.teeth", "gears.wheels.front.teeth", "gears.meshes.2.tolerance_um")
    assert not any("meshes" in key for key in root(1.0, 2.0, at=("rear_front", "front")).moved_by)


def test_a_limit_of_nought_needs_a_scale():
    gap = rule("limit", "mm", id="step.gap", zero="the radius")
    with pytest.raises(TypeError, match=r"step\.gap"):
        gap(0.001, 0.0)
    assert gap(0.001, 0.0, scale=0.02).margin == pytest.approx(0.05)
    assert rule("limit", "°C", id="step.ice")(-3.0, 0.0).margin == pytest.approx(-0.03)


def test_a_check_is_declared_once_and_a_limit_has_a_role():
    CheckRule("test.twice", "advice", "Once.")
    try:
        with pytest.raises(ValueError, match="declared twice"):
            CheckRule("test.twice", "advice", "Twice.")
    finally:
        del RULES["test.twice"]
    for kind, role in (("limit", ""), ("caution", "physics")):
        with pytest.raises(ValueError, match="role"):
            CheckRule("test.role", kind, "A role.", role=role)


def test_what_is_missing_is_shown_in_the_unit_of_the_check():
    film = rule("limit", "µm", id="step.film")
    lack = Missing(("bearings.slope_mrad",), (Text("0.1 mrad"),), 8e-6, 4e-6)
    check = film(5e-6, 4.5e-6, missing=lack)
    assert (check.at_best, check.at_worst, check.missing) == (8.0, 4.0, ("bearings.slope_mrad",))
    assert check.finding == "not_verified"
    assert film(5e-6, 4.5e-6, missing=Missing(("a.b",), (EMPTY,), "holds", "none")).at_worst == "none"
    assert film(5e-6, 4.5e-6).at_best is None


def test_the_advice_is_rendered_from_the_remedies_in_the_labels_and_units_of_the_fields():
    cut = remedy(change(Plate, "plates.lid.width_mm", 3.0, place="lid", bound=">="), effect=Text("it then fits"))
    both = remedy(change(Plate, "plates.depth_mm", None), change(Plate, "plates.lid.width_mm", [1.5, 2.0], place="lid"))
    film = rule("limit", id="step.film")
    check = film(1.0, 2.0, advice=Text("Or a thinner lid."), remedies=lambda: (cut, both))
    assert (
        check.advice
        == "To pass: Width of lid at least 3 mm (it then fits) or Depth left out and Width of lid [1.5; 2] mm. Or a "
        "thinner lid."
    )
    assert [one.changes for one in check.remedies] == [
        (("plates.lid.width_mm", 3.0),),
        (("plates.depth_mm", None), ("plates.lid.width_mm", [1.5, 2.0])),
    ]
    assert film(1.0, 2.0, remedies=lambda: (cut,)).advice == "To pass: Width of lid at least 3 mm (it then fits)."
    assert film(3.0, 2.0, remedies=lambda: (cut,)).remedies == () and film(1.0, 2.0).advice == ""


# --- outside the validity of a formula


def test_a_stretched_formula_weakens_what_stands_on_it():
    safety = rule("limit", id="gears.W.safety")
    other = rule("limit", id="gears.W.other")
    load = rule("method", id="gears.M.load", weakens=((safety, 2.0),))
    root = rule("method", id="gears.train.root", weakens=((safety, 1.5),))
    front, back, calm = safety(2.5, 1.0, at="front"), safety(4.0, 1.0, at="back"), other(1.5, 1.0, at="front")
    low, rough = load(1.0, 2.0, at="front_idler"), root(1.0, 2.0)

    def verdicts(*checks):
        return [(c.verdict, c.at_worst, c.outside) for c in stretched(checks)[: len(checks)]]

    assert verdicts(front, load(3.0, 2.0, at="front_idler"))[0] == ("pass", None, ())
    assert verdicts(front, low)[0] == ("pass", 1.25, (low.id,))
    assert verdicts(front, low, rough)[0] == ("not_verified", pytest.approx(2.5 / 3), (low.id, rough.id))
    assert verdicts(back, low)[0] == ("pass", None, ()), "a wheel of another mesh"
    assert verdicts(calm, low, rough)[0] == ("pass", None, ())
    assert verdicts(safety(0.9, 1.0, at="front"), low)[0][0] == "fail"
    assert verdicts(safety(2.5, 1.0, at="idler"), low, load(1.0, 2.0, at="idler_rear"))[0][1] == 1.25, "once a wheel"


@pytest.mark.parametrize("sense, worst", [(">=", 4.0 / 1.3), (">", 4.0 / 1.3), ("<=", 4.0 * 1.3), ("<", 4.0 * 1.3)])
def test_what_is_weakened_goes_towards_its_limit(sense, worst):
    film = rule("caution", id="bearings.B.film", sense=sense)
    oil = rule("method", id="bearings.oil", weakens=((film, 1.3),))  # of all bearings
    assert stretched((film(4.0, 4.0, at="rear"), oil(1.0, 2.0)))[0].at_worst == pytest.approx(worst)


def test_of_several_shafts_a_bearing_weakens_its_own_checks():
    film = rule("caution", id="bearings.B.film")
    flow = rule("method", id="bearings.B.flow", weakens=((film, 1.3),))
    checks = film(4.0, 2.0, at="front"), film(4.0, 2.0, at="rear"), flow(1.0, 2.0, at="rear")
    of_two = [check.of_one(name, ["bearings"]) for name in ("left", "right") for check in checks]
    worst = {check.id: check.at_worst for check in stretched((*of_two[:3], *of_two[3:5]))}
    assert worst.pop("bearings.left.rear.film") == pytest.approx(4.0 / 1.3)
    assert set(worst.values()) == {None}


def test_one_wheel_of_a_mesh_weakens_its_own_checks():
    safety = rule("limit", id="gears.W.safety")
    notch = rule("method", id="gears.M.trial_W", weakens=((safety, 1.3),))
    front, idler, _ = stretched(
        (safety(2.6, 1.0, at="front"), safety(2.6, 1.0, at="idler"), notch(1.0, 2.0, at=("front_idler", "front")))
    )
    assert (front.at_worst, idler.at_worst) == (pytest.approx(2.0), None)


def test_what_is_weakened_counts_from_its_base_and_from_the_unfavourable_end():
    outlet = rule("limit", "°C", id="bearings.B.outlet", sense="<=")
    film = rule("caution", "µm", id="bearings.B.film")
    flow = rule("method", id="bearings.B.flow", weakens=((outlet, 1.3), (film, 1.3)))
    missed = flow(1.0, 2.0, at="rear")
    lack = Missing(("bearings.slope_mrad",), (EMPTY,), 9e-6, 5.2e-6)
    hot, thin, _ = stretched(
        (outlet(120.0, 135.0, at="rear", base=90.0), film(6e-6, 5e-6, at="rear", missing=lack), missed)
    )
    assert hot.at_worst == pytest.approx(129.0) and hot.finding == "pass"
    assert (thin.at_best, thin.at_worst) == (9.0, pytest.approx(4.0)) and thin.finding == "not_verified"


@pytest.mark.parametrize(
    "number, text",
    [
        (0.0, "0"),
        (1710.0, "1710"),
        (0.0062, "6.2·10⁻³"),
        (572.932, "572.9"),
        (0.0595, "0.0595"),
        (1045072.6, "1.045·10⁶"),
        (-0.5, "−0.5"),
        (99999.0, "1·10⁵"),
        (math.inf, "∞"),
        (math.nan, "no value"),
        (2e-300, "2·10⁻³⁰⁰"),
        (1e4, "10000"),
        (-3e-9, "−3·10⁻⁹"),
    ],
)
def test_numbers_as_people_write_them(number, text):
    assert short(number) == text


@given(st.floats(-1e300, 1e300))
def test_any_number_is_written_to_four_digits(number):
    sup = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹−", "-0123456789-")
    mantissa, _, power = short(number).partition("·10")
    back = float(mantissa.translate(sup)) * (10.0 ** int(power.translate(sup)) if power else 1) if number else 0.0
    assert back == pytest.approx(number, rel=6e-4, abs=1e-300)


@inputs
class Plate:
    width: float = quantity("Width", "mm", above=0)
    depth: float = quantity("Depth", "mm", default=0.002)


@result
class Found:
    film: Metre = value("Film", "µm", "h")
    other: Metre | None = value("Other", "µm", default=None)
    lambda_: float = value("Ratio")


def test_inputs_are_frozen_and_equal_by_value():
    plate = Plate(width=0.1)
    assert plate == Plate(width=0.1) and plate != replace(plate, width=0.2) and plate.depth == 0.002
    with pytest.raises(FrozenInstanceError):
        plate.width = 3.0
    for wrong in ({}, {"width": 1.0, "height": 2.0}):
        with pytest.raises(TypeError):
            Plate(**wrong)


def test_results_publish_what_is_there_in_its_unit():
    found = Found(film=9.5e-6, lambda_=0.3)
    assert [(v.id, v.shown, v.unit) for v in published(found, "a.b")] == [
        ("a.b.film", 9.5, "µm"),
        ("a.b.lambda", 0.3, ""),
    ]
    assert found != Found(film=9.5e-6, lambda_=0.3)


def test_a_group_that_is_renamed_is_found_by_its_former_name():
    @result
    class Outer:
        film: float = value("Film", "µm")
        now: Found | None = group(default=None, former="once")
        each: dict[str, Found] = group()

    one = Found(film=9.5e-6, lambda_=0.3)
    ids = [(v.id, v.former) for v in published(Outer(film=1e-6, now=one, each={"a": one}), "x")]
    assert ids[:3] == [("x.film", ""), ("x.now.film", "x.once.film"), ("x.now.lambda", "x.once.lambda")]
    assert ids[3:] == [("x.each.a.film", ""), ("x.each.a.lambda", "")]


def test_the_names_of_a_dict_may_stand_in_the_address_only_where_there_are_several():
    @result
    class Shafts:
        turns: dict[str, Found] = group(spread=True, named="several")
        films: dict[str, dict[str, Found]] = group(named="several", default=None)

    one = Found(film=9.5e-6, lambda_=0.3)
    alone = Shafts(turns={"left": one}, films={"left": {"front": one}})
    assert [v.id for v in published(alone, "x")] == ["x.film", "x.lambda", "x.films.front.film", "x.films.front.lambda"]
    both = Shafts(turns={"left": one, "right": one}, films={"left": {"front": one}, "right": {}})
    assert [v.id for v in published(both, "x") if v.id.endswith("film")] == [
        "x.left.film",
        "x.right.film",
        "x.films.left.front.film",
    ]


@given(st.floats(-5, 5), st.floats(0.1, 3))
def test_the_root_of_a_rising_function(zero, steepness):
    found = root(lambda x: math.atan(steepness * (x - zero)) + (x - zero) ** 3, -7, 8)
    assert found == pytest.approx(zero, abs=1e-9)


def test_a_jump_through_zero_is_a_root_and_no_change_of_sign_is_an_error():
    assert root(lambda x: 1.0 if x < 0.3 else -1.0, 0, 1) == pytest.approx(0.3)
    with pytest.raises(ValueError, match="no change of sign"):
        root(lambda x: x * x + 1, 0, 1)
