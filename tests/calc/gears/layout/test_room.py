"""Each check of places, room and assembly just inside and just outside its limit."""

import math
from dataclasses import replace

import pytest

from calc.gears.layout.positions import allowed
from calc.gears.layout.room import (
    Clearance,
    axis_check,
    clearance_checks,
    distance_check,
    hunting_check,
    insertion_check,
    reach_check,
)
from calc.sheet.text import Text
from tests.calc.gears.layout.trains import AXIS, at, laid, mesh, solved, triangle, wall

MM, UM = 1e-3, 1e-6
TRAIN = solved(triangle())
CIRCLES = "geometry: two circles about the fixed axes, with the working centre distances"


@pytest.mark.parametrize(
    ("c", "verdict"), [(9.998, "pass"), (9.9979, "fail"), (40.0, "pass"), (70.002, "pass"), (70.0021, "fail")]
)
def test_the_reach_of_a_wheel_between_two_axes(c, verdict):
    """Within the sum and the difference of the centre distances and the tolerance."""
    check = reach_check("idler", Text("idler"), "crank", "shaft", c * MM, 10 * MM, 70 * MM, 2 * UM)
    assert check.id == "gears.idler.position" and (check.kind, check.role) == ("limit", "self")
    assert check.holds == (verdict == "pass") and check.verdict in (verdict, "warn" if check.holds else verdict)
    assert check.limit == pytest.approx((9.998, 70.002)) and str(check.source) == CIRCLES
    assert check.margin == pytest.approx(min(c - 9.998, 70.002 - c) / 60.004, abs=1e-9)
    do = "near a limit" if check.holds else "closer" if c > 40 else "further apart"
    assert do in check.advice


def test_axes_can_stand_on_each_other():
    check = reach_check("idler", Text("idler"), "crank", "shaft", 0.0, 1 * UM, 70 * MM, 2 * UM)
    assert check.limit == pytest.approx((0.0, 70.002)) and check.holds


@pytest.mark.parametrize(("off", "verdict"), [(0.94, "pass"), (0.96, "warn"), (1.0, "warn"), (1.001, "fail")])
def test_the_last_wheel_stands_on_the_shaft(off, verdict):
    """Within a thousandth of a module; closer to that than a twentieth is narrow."""
    check = axis_check("shaft", off * UM, 1 * UM)
    assert (check.id, check.verdict, check.kind, check.role) == ("gears.shaft.axis", verdict, "limit", "self")
    assert "within 10⁻³ m_n" in check.source
    last = at("shaft", 40, (50 + off * 1e-3, 0))
    gears = triangle(idler=None)
    there = laid(replace(gears, wheels=(*gears.wheels[:2], last)), 0.050 + 0j)
    assert next(c for c in there.checks if c.id == "gears.shaft.axis").limit == pytest.approx(1.0)
    assert next(c for c in there.checks if c.id == "gears.shaft.axis").value == pytest.approx(off)


@pytest.mark.parametrize(("error", "verdict"), [(18.9, "pass"), (19.1, "warn"), (20.0, "warn"), (20.01, "fail")])
def test_axes_stand_at_their_centre_distance(error, verdict):
    check = distance_check("crank_idler", 0, TRAIN.meshes["crank_idler"], 30 * MM, error * UM, 20 * UM, [])
    assert (check.id, check.verdict, check.kind, check.role) == ("gears.crank_idler.position", verdict, "limit", "self")
    assert "the tolerance of the centre distance, at least 10⁻³ m_n" in check.source


def test_given_axes_may_miss_by_the_tolerance_and_at_least_a_thousandth_of_the_module():
    between = TRAIN.meshes["crank_idler"]
    assert allowed(TRAIN, between) == pytest.approx(1 * UM)
    assert allowed(TRAIN, replace(between, centre_tolerance=3 * UM)) == pytest.approx(3 * UM)


def test_a_distance_that_is_off_is_judged_at_its_own_mesh():
    gears = triangle(idler=(24, 18.01), meshes=(mesh("crank", "idler", 30, tolerance=5), mesh("idler", "shaft", 40)))
    checks = {c.id: c for c in laid(gears, AXIS).checks}
    first, second = (checks[f"gears.{key}.position"] for key in ("crank_idler", "idler_shaft"))
    assert (first.limit, first.value) == pytest.approx((5.0, abs(math.hypot(24, 18.01) - 30) * 1e3))
    assert (second.limit, second.value) == pytest.approx((1.0, abs(math.hypot(24, 50 - 18.01) - 40) * 1e3))


@pytest.mark.parametrize(
    ("g", "limit", "usual"),
    [
        (-0.001, "fail", "note"),
        (0.0, "warn", "note"),
        (0.049, "warn", "note"),
        (0.051, "pass", "note"),
        (0.999, "pass", "note"),
        (1.0, "pass", "pass"),
    ],
)
def test_the_room_of_a_wheel(g, limit, usual):
    """The tightest place around it; below a twentieth of a millimetre it is narrow."""
    free = {"wall": Clearance(g * MM, "wall", "head"), "neighbour": Clearance(5 * MM, "neighbour", "screw")}
    hard, soft = clearance_checks("idler", free, ["crank", "idler"], False)
    assert (hard.id, hard.verdict, hard.kind, hard.role) == ("gears.idler.clearance", limit, "limit", "physics")
    assert (soft.id, soft.verdict, soft.kind) == ("gears.idler.clearance_usual", usual, "advice")
    assert hard.margin == pytest.approx(g) and soft.limit == pytest.approx(1.0)
    assert "tip circle with its upper deviation" in hard.source and "1 mm" in soft.source


def test_two_wheels_that_come_near_each_other_are_judged_at_the_later_one():
    near, order = {"wheel": Clearance(-1 * MM, "wheel", "crank")}, ["crank", "idler"]
    assert next(c.id for c in clearance_checks("idler", near, order, False)) == "gears.idler.clearance"
    assert not [*clearance_checks("crank", {"wheel": Clearance(-1 * MM, "wheel", "idler")}, order, False)]
    assert not [*clearance_checks("idler", {}, order, False)]


def test_a_wall_is_judged_where_it_stands():
    checks = {c.id: c for c in laid(triangle(idler=(24, 18), walls=[wall("head", 46, -80, 46, 90)]), AXIS).checks}
    assert checks["gears.idler.clearance"].value == pytest.approx(46 - 45)


@pytest.mark.parametrize(("factor", "verdict"), [(1.0, "pass"), (2.0, "note")])
def test_numbers_of_teeth_without_a_common_factor(factor, verdict):
    check = hunting_check("crank_idler", TRAIN.meshes["crank_idler"], 20, 40, factor, 2.0)
    assert (check.id, check.verdict, check.kind, check.limit) == ("gears.crank_idler.hunting", verdict, "advice", 1.0)
    assert "hunting tooth" in check.source
    real = next(c for c in laid(triangle(), AXIS).checks if c.id == "gears.crank_idler.hunting")
    assert real.value == 20 and real.value_id == "gears.crank_idler.common_factor"


@pytest.mark.parametrize(("gap", "verdict"), [(0.0, "pass"), (-0.001, "warn")])
def test_the_last_wheel_passes_the_seat(gap, verdict):
    check = insertion_check("shaft", Text("front"), gap * MM)
    assert (check.id, check.verdict, check.kind) == ("gears.train.assembly", verdict, "caution")
    assert check.margin == pytest.approx(gap) and "passes through the seat of the journal" in check.source
