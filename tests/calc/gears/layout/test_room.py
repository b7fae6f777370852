"""Each check of places, room and assembly just inside and just outside its limit."""

import cmath
import math
from dataclasses import replace

import numpy as np
import pytest

from calc.gears.layout.positions import allowed
from calc.gears.layout.room import (
    Clearance,
    Room,
    axis_check,
    clearance_checks,
    clearances,
    distance_check,
    hunting_check,
    insertion_check,
    most_room,
    reach_check,
    room,
)
from calc.sheet.text import Text
from tests.calc.gears.layout.trains import AXIS, at, laid, mesh, solved, triangle, wall

MM, UM = 1e-3, 1e-6
TRAIN = solved(triangle())
AROUND = Room(
    walls=(("sump", -0.06 - 0.08j, -0.05 + 0.09j), ("rib", 0.08 + 0.01j, 0.04 + 0.12j)),
    neighbours=(("screw", 0.01 + 0.11j, 0.004), ("pipe", 0.05 - 0.05j, 0.006)),
    swept={"first": 0.011, "a": 0.012, "b": 0.017, "last": 0.013},
    mates={"first": {"a"}, "a": {"first", "b"}, "b": {"a", "last"}, "last": {"b"}},
)
CHAIN = "first", "a", "b", "last"
CIRCLES = "geometry: two circles about the fixed axes, with the working centre distances"


def to_wall(p, a, b):
    """Of points from a straight wall: along it, or to one of its ends."""
    seen = (p - a) / (b - a)
    across = np.abs(seen.imag) * abs(b - a)
    return np.where((seen.real > 0) & (seen.real < 1), across, np.minimum(np.abs(p - a), np.abs(p - b)))


def free(p, radius, *wheels):
    """The room of a wheel at points, with the wheels that it does not mesh with: place and radius of each."""
    round_things = [(q, r) for _, q, r in AROUND.neighbours] + list(wheels)
    gaps = [to_wall(p, a, b) for _, a, b in AROUND.walls] + [np.abs(p - q) - r for q, r in round_things]
    return np.min(gaps, axis=0) - radius


def test_the_room_of_a_wheel_at_any_point():
    places = {"first": 0.01 + 0.02j, "b": 0.02 + 0.06j, "last": -0.02 + 0.07j}
    points = (np.linspace(-0.12, 0.12, 25)[:, None] + 1j * np.linspace(-0.12, 0.15, 28)).astype(complex)
    wanted = free(points, 0.012, (places["last"], 0.013))
    assert AROUND.around_all("a", points, places) == pytest.approx(wanted, abs=1e-15)
    assert AROUND.around("a", complex(points[3, 4]), places) == pytest.approx(wanted[3, 4], abs=1e-15)
    alone = replace(AROUND, walls=(), neighbours=())
    assert alone.around("a", 0.1j, {name: places[name] for name in ("first", "b")}) == math.inf


def test_the_nearest_of_each_kind():
    """By what is left between the rims, not between the axes."""
    places = {"first": 0j, "a": 0.03 + 0.01j, "b": 0.01 + 0.05j, "last": 0.005 + 0.09j}
    found = clearances("first", places, replace(AROUND, neighbours=(*AROUND.neighbours, ("hub", 0.08j, 0.05))))
    assert [(c.kind, c.to) for c in found.values()] == [("wall", "sump"), ("neighbour", "hub"), ("wheel", "b")]
    wall = float(to_wall(np.array(0j), *AROUND.walls[0][1:])) - 0.011
    wanted = wall, 0.08 - 0.05 - 0.011, abs(places["b"]) - 0.017 - 0.011
    assert [c.g for c in found.values()] == pytest.approx(wanted, abs=1e-15)
    last = clearances("last", places, replace(AROUND, walls=(), neighbours=()))
    assert [(c.kind, c.to) for c in last.values()] == [("wheel", "a")]
    assert not clearances("first", {"first": 0j}, replace(AROUND, walls=(), neighbours=()))


def test_how_far_a_wheel_reaches():
    """Half of deviation and runout, and the larger tolerance of its two axes."""
    idler = at("idler", 40, (24, 18), runout=40e-6, tip_diameter_tolerance=(20e-6, -100e-6))
    gears = triangle(meshes=(mesh("crank", "idler", 30, tolerance=50), mesh("idler", "shaft", 40, tolerance=30)))
    gears = replace(gears, wheels=(gears.wheels[0], idler, gears.wheels[2]))
    swept = room(gears, solved(gears)).swept
    wanted = {"crank": 11 * MM + 50 * UM, "idler": 21 * MM + 80 * UM, "shaft": 21 * MM + 30 * UM}
    assert swept == pytest.approx(wanted, abs=1e-12)
    assert room(gears, solved(gears)).mates == {"crank": {"idler"}, "idler": {"crank", "shaft"}, "shaft": {"idler"}}


# --- two wheels in a row


def linkage(p, q, a, phi, side):
    """Places of both wheels by the law of cosines; none where they do not reach."""
    first = p + a[0] * np.exp(1j * phi)
    c = np.abs(q - first)
    with np.errstate(invalid="ignore"):
        turn = np.arccos((c**2 + a[1] ** 2 - a[2] ** 2) / (2 * c * a[1]))
    return first, first + a[1] * np.exp(1j * (np.angle(q - first) + side * turn))


@pytest.mark.parametrize(
    "p, q, a",
    [
        (0.01 + 0.005j, 0.02 + 0.07j, (0.03, 0.04, 0.025)),
        (-0.01 + 0.005j, 0.03 - 0.03j, (0.024, 0.03, 0.04)),
        (0.01 - 0.03j, -0.01 + 0.04j, (0.027, 0.03, 0.03)),
    ],
)
def test_the_direction_with_the_most_room(p, q, a):
    """Of all directions that are 1/16° apart, counted from the line of the fixed axes, none leaves more."""
    places = {"first": p, "last": q}
    phi = cmath.phase(q - p) + math.pi / 180 * np.arange(16 * 360) / 16
    tighter = []
    for side in (1.0, -1.0):
        one, two = linkage(p, q, a, phi, side)
        both = np.minimum(free(one, 0.012, (q, 0.013)), free(two, 0.017, (p, 0.011)))
        tighter.append(np.where(np.isnan(both), -np.inf, both))
    direction, side, clearance = most_room(AROUND, places, CHAIN, a)
    best, angle = np.unravel_index(np.argmax(tighter), (2, phi.size))
    assert clearance == pytest.approx(np.max(tighter), abs=1e-14)
    assert (side, direction % (2 * math.pi)) == pytest.approx(((1.0, -1.0)[best], phi[angle] % (2 * math.pi)))


@pytest.mark.parametrize("beyond, reaches", [(0.0, True), (0.98e-12, True), (1.02e-12, False), (1e-9, False)])
def test_a_row_that_is_stretched_reaches(beyond, reaches):
    """By δ further, the square of the triangle's height over its base is −2·δ·a_3/a_2 of a_2²: 10⁻¹² is rounding."""
    a_1, a_2, a_3 = a = 0.03, 0.04, 0.02
    apart = a_1 + (a_2 + a_3) * (1 + beyond * a_2 / (2 * a_3))
    found = most_room(AROUND, {"first": 0j, "last": apart * 1j}, CHAIN, a)
    assert (found is not None) == reaches
    if found is not None:
        assert found[0] == pytest.approx(math.pi / 2)


def test_a_wheel_does_not_stand_on_the_second_axis():
    """There the other one could stand in any direction."""
    direction, _, clearance = most_room(AROUND, {"first": 0j, "last": 0.03 + 0j}, CHAIN, (0.03, 0.02, 0.02))
    assert math.isfinite(clearance) and abs(direction) > 0.1


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
    off = {9.9979: "at least 2.1·10⁻³ mm further apart", 70.0021: "at least 2.1·10⁻³ mm closer"}
    assert off.get(c, "near a limit") in check.advice and "10 to 70 mm apart" in check.advice


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
    assert "Or move" not in check.advice and "The axes stand 30.0000 mm apart" in check.advice
    given = distance_check("crank_idler", 0, TRAIN.meshes["crank_idler"], 30 * MM, error * UM, 20 * UM, ["crank"])
    assert "Or move crank." in given.advice


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
    hard, soft = clearance_checks("idler", free, ["crank", "idler"], False, {})
    assert (hard.id, hard.verdict, hard.kind, hard.role) == ("gears.idler.clearance", limit, "limit", "physics")
    assert (soft.id, soft.verdict, soft.kind) == ("gears.idler.clearance_usual", usual, "advice")
    assert hard.margin == pytest.approx(g) and soft.limit == pytest.approx(1.0)
    assert "tip circle with its upper deviation" in hard.source and "1 mm" in soft.source


@pytest.mark.parametrize(
    "kind, chosen, name, advice",
    [
        ("wall", False, "wall x", "move idler or wall x apart by 2 mm, or give it fewer teeth or a smaller shift."),
        ("neighbour", False, "x", "move idler or x apart by 2 mm, or give it fewer teeth or a smaller shift."),
        ("wheel", False, "wheel x", "move idler or wheel x apart by 2 mm, or give it fewer teeth or a smaller shift."),
        (
            "wall",
            True,
            "wall x",
            "give idler another place, or give it fewer teeth or a smaller shift. `choose",
        ),
        ("wheel", True, "wheel x", "give idler another place, or give it fewer teeth or a smaller shift."),
    ],
)
def test_what_a_wheel_that_has_no_room_is_told(kind, chosen, name, advice):
    hard, soft = clearance_checks("idler", {kind: Clearance(-2 * MM, kind, "x")}, ["x", "idler"], chosen, {})
    assert hard.name == f"Clearance of idler to {name}" and soft.name == f"{hard.name}, usual"
    assert advice in hard.advice and ("choose FILE" in hard.advice) == (chosen and kind == "wall")
    assert ("by 2 mm" in hard.advice) is not chosen and hard.zero_scale == pytest.approx(1.0)
    touching, _ = clearance_checks("idler", {kind: Clearance(0.0, kind, "x")}, ["x", "idler"], chosen, {})
    assert "mm" not in touching.advice


def test_two_wheels_that_come_near_each_other_are_judged_at_the_later_one():
    near, order = {"wheel": Clearance(-1 * MM, "wheel", "crank")}, ["crank", "idler"]
    assert next(c.id for c in clearance_checks("idler", near, order, False, {})) == "gears.idler.clearance"
    assert not [*clearance_checks("crank", {"wheel": Clearance(-1 * MM, "wheel", "idler")}, order, False, {})]
    assert not [*clearance_checks("idler", {}, order, False, {})]


def test_a_wall_is_judged_where_it_stands():
    checks = {c.id: c for c in laid(triangle(idler=(24, 18), walls=[wall("head", 46, -80, 46, 90)]), AXIS).checks}
    assert checks["gears.idler.clearance"].value == pytest.approx(46 - 45)


@pytest.mark.parametrize(("factor", "verdict"), [(1.0, "pass"), (2.0, "note")])
def test_numbers_of_teeth_without_a_common_factor(factor, verdict):
    check = hunting_check("crank_idler", TRAIN.meshes["crank_idler"], 20, 40, factor, 2.0)
    assert (check.id, check.verdict, check.kind, check.limit) == ("gears.crank_idler.hunting", verdict, "advice", 1.0)
    assert "hunting tooth" in check.source and check.advice.startswith("Numbers" if factor == 1 else "Every tooth")
    assert factor == 1 or "only 20 of the 40 teeth of idler, and one fault returns after 2 turns" in check.advice
    real = next(c for c in laid(triangle(), AXIS).checks if c.id == "gears.crank_idler.hunting")
    assert real.value == 20 and real.value_id == "gears.crank_idler.common_factor"


@pytest.mark.parametrize(("gap", "verdict"), [(0.0, "pass"), (-0.001, "warn")])
def test_the_last_wheel_passes_the_seat(gap, verdict):
    check = insertion_check("shaft", Text("front"), gap * MM)
    assert (check.id, check.verdict, check.kind) == ("gears.train.assembly", verdict, "caution")
    assert check.moved_by[0] == "shafts.S.bearings.*.diameter_mm"
    assert check.margin == pytest.approx(gap) and "passes through the seat of the journal" in check.source
    assert ("give that journal 0.001 mm more" in check.advice) == ("more" in check.advice) == (gap < 0)
