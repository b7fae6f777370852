"""Each check of the measures just inside and just outside its limit."""

import math
from dataclasses import replace

import pytest

from calc.gears.formulas import pressure_angle_at
from calc.gears.measures.result import Measured
from calc.gears.measures.solve import ball_at, checks, contact_checks
from tests.calc.gears.trains import pair_1, solved

MM, UM = 1e-3, 1e-6
TRAIN = solved(pair_1(span=(5, 5)))
WHEEL = TRAIN.wheels["idler"]
SIZES = WHEEL.measures
FORM, TIP = WHEEL.form_diameter, WHEEL.tip_diameter
LITTLE = 1e-9


def judged(wheel=None, **sizes):
    """The checks of one wheel by their last words, with these measures in place of those that are solved."""
    wheel, sizes = replace(WHEEL, **(wheel or {})), replace(SIZES, **sizes)
    every = (*contact_checks(TRAIN.system, wheel, sizes), *checks(TRAIN.system, wheel, sizes))
    return {c.id.removeprefix("gears.idler."): c for c in every}


def tooth(change=-25 * UM, thickness=3 * MM):
    return Measured(
        generating_shift=0.0,
        span_change=change,
        thickness_change=change,
        normal_thickness=thickness,
        transverse_thickness=thickness,
    )


@pytest.mark.parametrize("name", ["span_contact", "constant_chord"])
@pytest.mark.parametrize(
    ("at", "verdict"), [(FORM, "pass"), (FORM - LITTLE, "note"), (TIP, "pass"), (TIP + LITTLE, "note")]
)
def test_a_calliper_touches_the_involute(name, at, verdict):
    """Between the form circle and the tip circle."""
    check = judged(**{f"{name}_diameter": at})[name]
    assert (check.verdict, check.kind) == (verdict, "advice")
    assert check.limit == pytest.approx((FORM / MM, TIP / MM))
    assert str(check.source).startswith("ISO 21771") and "must touch the involute" in check.source


@pytest.mark.parametrize(
    ("name", "source"),
    [
        ("span_width", "W·sin β_b, the width of the anvils apart"),
        ("pins_width", "half an axial pitch between the pins"),
    ],
)
@pytest.mark.parametrize(("more", "verdict"), [(0.0, "pass"), (LITTLE, "note")])
def test_a_wheel_is_as_wide_as_its_measures_ask(name, source, more, verdict):
    check = judged(**{name: WHEEL.face_width + more})[name]
    assert (check.verdict, check.kind) == (verdict, "advice")
    assert check.value == pytest.approx(WHEEL.face_width / MM) and source in check.source


def ball(at):
    return ball_at(TRAIN.system, WHEEL, pressure_angle_at(WHEEL.base_diameter, at))


@pytest.mark.parametrize(
    ("diameter", "verdict"),
    [
        (ball(FORM) + LITTLE, "pass"),
        (ball(FORM) - LITTLE, "warn"),
        (ball(TIP) - LITTLE, "pass"),
        (ball(TIP) + LITTLE, "warn"),
    ],
)
def test_a_given_ball_touches_between_form_and_tip(diameter, verdict):
    check = judged({"ball_diameter": diameter})["ball"]
    assert (check.verdict, check.kind) == (verdict, "caution")
    assert "must touch between form and tip circle" in check.source


@pytest.mark.parametrize(("proud", "verdict"), [(LITTLE, "pass"), (0.0, "warn")])
def test_balls_stand_proud_of_the_tip(proud, verdict):
    check = judged({"over_balls": TIP + 2 * proud, "ball_diameter": 3.5 * MM})["ball_proud"]
    assert (check.verdict, check.kind, check.sense) == (verdict, "caution", ">")
    assert check.margin == pytest.approx(proud / (3.5 * MM), abs=1e-12) and "proud of the tip circle" in check.source


@pytest.mark.parametrize(("above", "verdict"), [(LITTLE, "pass"), (-LITTLE, "warn")])
def test_a_ball_does_not_lie_on_the_root(above, verdict):
    size = WHEEL.root_diameter / 2 + 3.5 * MM + above
    check = judged({"ball_diameter": 3.5 * MM}, over_one_ball=size)["ball_root"]
    assert (check.verdict, check.kind) == (verdict, "caution") and "must not lie on the root" in check.source
    assert check.margin == pytest.approx(above / (3.5 * MM))


@pytest.mark.parametrize("preferred, diameter", [(3.25 * MM, 3.25), (None, 3.457)])
def test_a_ball_that_does_not_fit_is_changed_or_left_out(preferred, diameter):
    wheel = {"ball_diameter": ball(FORM) - LITTLE, "preferred_ball": preferred, "ideal_ball": 3.4567 * MM}
    other, own = judged(wheel)["ball"].remedies
    assert other.changes == (("gears.ball_diameter_mm", diameter),)
    assert own.changes == (("gears.ball_diameter_mm", None),) and own.effect == "each wheel then has its own"


def test_a_ball_that_the_program_chose_is_not_judged():
    assert {"ball", "ball_proud", "ball_root"} <= judged().keys()
    assert not {"ball", "ball_proud", "ball_root"} & judged({"ball_given": False}).keys()


@pytest.mark.parametrize(
    "name", ["measured_span", "measured_over_balls", "measured_over_pins", "measured_chordal_thickness"]
)
@pytest.mark.parametrize(("change", "verdict"), [(-20, "pass"), (-19.99, "warn"), (-30, "pass"), (-30.01, "warn")])
def test_what_is_measured_lies_inside_its_allowance(name, change, verdict):
    """Of −20 to −30 µm, whose width the margin is a share of."""
    check = judged(**{name: tooth(change * UM)})[name]
    assert (check.verdict, check.kind) == (verdict, "caution")
    assert check.limit == pytest.approx((-30, -20)) and check.source == "gears.wheels.idler.span_allowance_um"
    assert check.margin == pytest.approx(min(-20 - change, change + 30) / 10)
    assert check.moved_by == (f"gears.wheels.idler.{name}_mm", "gears.wheels.idler.span_allowance_um")


@pytest.mark.parametrize(("apart", "verdict"), [(10.6417, "pass"), (10.6418, "note")])
def test_routes_agree_within_the_field_of_the_allowance(apart, verdict):
    """10 µm of the span are 10/cos 20° µm of the thickness."""
    routes = {"measured_span": tooth(), "measured_over_pins": tooth(thickness=3 * MM + apart * UM)}
    check = judged(**routes, measured_over_balls=tooth(thickness=3 * MM + 1 * UM))["measured_spread"]
    assert (check.verdict, check.kind) == (verdict, "method") and check.value == pytest.approx(apart)
    assert "differ by more than the whole field" in check.source


def test_how_a_size_is_taken_is_said():
    """The chord by hand: its half angle on the virtual wheel leans the flank against the middle of the tooth."""
    keys = "measured_span", "measured_over_balls", "measured_over_pins", "measured_chordal_thickness"
    sizes = {**dict.fromkeys(keys, tooth()), "over_pins": 91.234 * MM, "over_two_pins": 91.111 * MM}
    span, balls, pins, chord = (judged({"ball_diameter": 3.5 * MM}, **sizes)[key].advice for key in keys)
    assert span.startswith("It is taken over 5 teeth.")
    assert balls == "It is taken with 3.5 mm in diameter. Half of the runout can hide in it."
    assert pins.endswith("faces parallel to the axis. Two pins under a free micrometer read 0.123 mm less.")
    psi = math.asin(WHEEL.chordal_thickness * math.cos(math.radians(21.916)) ** 3 / (39 * 2 * MM))
    assert chord.endswith(f"makes the chord read {math.tan(math.radians(20) - psi) * 0.1:.3f} mm more.")
    for none in ("over_pins", "over_two_pins"):
        assert judged(**{**sizes, none: None})["measured_over_pins"].advice.endswith("faces parallel to the axis.")


def test_one_route_has_no_spread():
    assert "measured_spread" not in judged(measured_span=tooth())
    both = judged(measured_span=tooth(), measured_over_pins=tooth(thickness=2.999 * MM))
    assert both["measured_spread"].value == pytest.approx(1.0)


def test_an_allowance_without_a_field_has_a_margin():
    wheel = {"allowance": (0.0, 0.0)}
    routes = {"measured_span": tooth(1 * UM), "measured_over_pins": tooth(1 * UM, 3.002 * MM)}
    checked = judged(wheel, **routes)
    assert checked["measured_span"].margin == pytest.approx(-0.0005)
    assert checked["measured_spread"].margin == pytest.approx(-0.001)
