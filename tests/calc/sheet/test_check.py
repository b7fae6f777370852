"""Checks: margin and verdict; numbers as they are written; records; the root finder."""

import math
from dataclasses import FrozenInstanceError, replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.sheet.check import Check, check, grouped, step_verdict, worst
from calc.sheet.functions import root
from calc.sheet.number import short
from calc.sheet.quantity import group, inputs, published, quantity, result, value
from calc.sheet.remedy import change, remedy
from calc.sheet.text import Text
from calc.sheet.units import Metre


def judged(value, sense=">=", limit=1.0, kind="limit", **more):
    return Check("step.object.name", Text("A check"), value, limit, sense, "", "a source", kind=kind, **more)


@pytest.mark.parametrize(
    "number, sense, limit, kind, margin, verdict",
    [
        (9.0, ">=", 9.0, "limit", 0.0, "warn"),
        (10.0, ">=", 9.0, "limit", 1 / 9, "pass"),
        (8.0, ">=", 9.0, "limit", -1 / 9, "fail"),
        (9.2, ">=", 9.0, "limit", 0.2 / 9, "warn"),
        (8.0, ">=", 9.0, "advice", -1 / 9, "note"),
        (9.0, ">=", 9.0, "advice", 0.0, "pass"),
        (8.0, ">=", 9.0, "caution", -1 / 9, "warn"),
        (9.2, ">=", 9.0, "caution", 0.2 / 9, "pass"),
        (8.0, ">=", 9.0, "method", -1 / 9, "note"),
        (130.0, "<=", 135.0, "limit", 5 / 135, "warn"),
        (136.0, "<=", 135.0, "limit", -1 / 135, "fail"),
        (0.0, ">", 0.0, "limit", 0.0, "fail"),
        (3.0, ">", 0.0, "limit", 3.0, "pass"),
        (-4.8, ">", 0.0, "limit", -4.8, "fail"),
        (0.5, "in", (0.2, 1.0), "limit", 1.5, "pass"),
        (0.9, "in", (0.2, 1.0), "limit", 0.1, "pass"),
        (0.99, "in", (0.2, 1.0), "limit", 0.01, "warn"),
        (0.1, "in", (0.2, 1.0), "limit", -0.5, "fail"),
        (1.5, "in", (0.2, 1.0), "advice", -0.5, "note"),
        (math.nan, ">=", 1.0, "limit", math.nan, "fail"),
        (math.nan, ">=", 1.0, "advice", math.nan, "note"),
        (math.nan, ">=", 1.0, "caution", math.nan, "warn"),
    ],
)
def test_margin_and_verdict(number, sense, limit, kind, margin, verdict):
    made = judged(number, sense, limit, kind)
    assert made.margin == pytest.approx(margin, nan_ok=True)
    assert made.verdict == verdict


@pytest.mark.parametrize(
    "kind, verdict, step",
    [
        ("limit", "not_verified", "not_verified"),
        ("caution", "not_verified", "warn"),
        ("advice", "pass", "pass"),
        ("method", "pass", "pass"),
    ],
)
def test_a_check_whose_data_are_missing_is_not_verified_even_if_it_holds(kind, verdict, step):
    made = judged(2.0, kind=kind, missing=("gears.housing_material",))
    assert (made.verdict, step_verdict([made])) == (verdict, step)


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
    made = judged(value, kind=kind, accepted="seen on the test bench")
    assert made.verdict == verdict and made.open is (verdict in ("fail", "warn"))
    assert step_verdict([made]) == {"accepted": "pass"}.get(verdict, verdict)


def test_notes_do_not_colour_a_step_and_a_caution_does():
    note, caution, limit = judged(0.5, kind="advice"), judged(0.5, kind="caution"), judged(0.5)
    assert [step_verdict(some) for some in ([note], [note, caution], [caution, limit, note], [])] == [
        "pass",
        "warn",
        "fail",
        "pass",
    ]


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
    assert judged(value, sense, limit, demand=demand).utilisation == utilisation


def test_a_group_stands_where_its_worst_check_does():
    names = dict(
        note=judged(0.5, kind="advice"),
        corner=judged(0.2, kind="caution"),
        fails=judged(0.9),
        far=judged(0.1),
        holds=judged(9.0),
    )
    rows = {id: replace(one, id=id, cause="" if id in ("note", "far") else "fails") for id, one in names.items()}
    assert [[c.id for c in group] for group in grouped(rows.values())] == [
        ["fails", "corner", "holds"],
        ["far"],
        ["note"],
    ]


def test_a_check_stands_in_the_shown_unit_and_has_the_kind_of_its_row():
    made = check("bearings.front.film_edge_corner", Text("Film"), 7.4e-6, ">=", 9e-6, "µm", "a source", kind="limit")
    assert (made.value, made.limit, made.limit_text(), made.margin_text()) == (7.4, 9.0, "≥ 9 µm", "−18 %")
    assert (made.kind, made.cause, made.value_id) == (
        "caution",
        "bearings.front.film_edge",
        "bearings.front.corners.film_edge",
    )
    assert check("gears.front.ball", Text("Ball"), 1.0, ">=", 0.0, "mm", "a source", kind="advice").kind == "advice"
    assert check("gears.front.ball", Text("Ball"), 1.0, ">=", 0.0, "mm", "a source").kind == "limit"


def test_the_advice_is_rendered_from_the_remedies_in_the_labels_and_units_of_the_fields():
    cut = remedy(change(Plate, "plates.lid.width_mm", 3.0, place="lid", bound=">="), effect=Text("it then fits"))
    both = remedy(change(Plate, "plates.depth_mm", None), change(Plate, "plates.lid.width_mm", [1.5, 2.0], place="lid"))
    made = check(
        "bearings.front.film_edge",
        Text("Film"),
        1.0,
        ">=",
        2.0,
        "",
        "a source",
        Text("Or a thinner lid."),
        remedies=lambda: (cut, both),
    )
    assert (
        made.advice
        == "To pass: Width of lid at least 3 mm (it then fits) or Depth left out and Width of lid [1.5; 2] mm. Or a "
        "thinner lid."
    )
    assert [one.changes for one in made.remedies] == [
        (("plates.lid.width_mm", 3.0),),
        (("plates.depth_mm", None), ("plates.lid.width_mm", [1.5, 2.0])),
    ]
    alone = check("bearings.front.film_edge", Text("Film"), 1.0, ">=", 2.0, "", "a source", remedies=lambda: (cut,))
    assert alone.advice == "To pass: Width of lid at least 3 mm (it then fits)." and judged(0.5).advice == ""
    assert (
        check(
            "bearings.front.film_edge", Text("Film"), 3.0, ">=", 2.0, "", "a source", remedies=lambda: (cut,)
        ).remedies
        == ()
    )


def test_the_worst_of_several():
    assert worst(["pass", "warn", "fail", "pass"]) == "fail"
    assert worst(["pass", "note", "accepted"]) == "pass"
    assert worst([]) == "pass"


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
    ids = [v.ids for v in published(Outer(film=1e-6, now=one, each={"a": one}), "x")]
    assert ids[:3] == [("x.film",), ("x.now.film", "x.once.film"), ("x.now.lambda", "x.once.lambda")]
    assert ids[3:] == [("x.each.a.film",), ("x.each.a.lambda",)]


@given(st.floats(-5, 5), st.floats(0.1, 3))
def test_the_root_of_a_rising_function(zero, steepness):
    found = root(lambda x: math.atan(steepness * (x - zero)) + (x - zero) ** 3, -7, 8)
    assert found == pytest.approx(zero, abs=1e-9)


def test_a_jump_through_zero_is_a_root_and_no_change_of_sign_is_an_error():
    assert root(lambda x: 1.0 if x < 0.3 else -1.0, 0, 1) == pytest.approx(0.3)
    with pytest.raises(ValueError, match="no change of sign"):
        root(lambda x: x * x + 1, 0, 1)


def test_a_limit_that_is_kept_narrowly_is_told_from_one_that_is_passed_over():
    near, over, far = (judged(value) for value in (1.01, 0.9, 2.0))
    assert (near.verdict, over.verdict, far.verdict) == ("warn", "fail", "pass")
    assert near.narrow and not over.narrow and not far.narrow
    assert not judged(0.9, kind="advice").narrow and not judged(1.01, kind="caution").narrow
