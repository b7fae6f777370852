"""Places by two circles, by choice, by what is given; and the room around the wheels."""

import cmath
import math
from dataclasses import replace
from itertools import pairwise

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from calc.gears.layout.curves import layout_curve
from calc.gears.layout.solve import ShaftInTrain, layout
from tests.calc.gears.layout.trains import AXIS, at, laid, mesh, r753, screw, solved, train, triangle, verdicts, wall

TRIANGLE = triangle()
SOLVED = solved(TRIANGLE)

NOWHERE = {}


def place(outcome, name):
    return outcome.result.wheels[name].position * 1e3


def test_two_circles_of_a_3_4_5_triangle():
    rows = next(t for t in laid(triangle(), AXIS).tables if t.id == "idler_positions").rows
    assert [row[2:4] for row in rows] == [pytest.approx((-24, 18)), pytest.approx((24, 18))]
    assert [row[5] for row in rows] == ["yes", "no"]  # nothing near: the one further in the sense of rotation


@pytest.mark.parametrize("obstacle, up", [(wall("sump", -40, -80, -40, 90), 24), (wall("head", 40, -80, 40, 90), -24)])
def test_the_place_with_more_room_is_chosen(obstacle, up):
    found = laid(triangle(walls=[obstacle]), AXIS)
    assert place(found, "idler") == pytest.approx(complex(up, 18))
    assert found.result.wheels["idler"].clearance_wall == pytest.approx(0.064 - 0.021)
    assert any("more room: 43 mm, the other −5 mm" in note for note in found.notes)


def test_the_right_angle_at_the_idler():
    found = laid(triangle(), AXIS).result
    assert math.degrees(found.wheels["idler"].included_angle) == pytest.approx(90)
    assert found.wheels["shaft"].included_angle is None


@pytest.mark.parametrize("axis, verdict", [(0.0701j, "fail"), (0.0099j, "fail"), (0.050j, "pass"), (0.069j, "warn")])
def test_the_reach_of_both_centre_distances(axis, verdict):
    found = laid(triangle(), axis)
    assert verdicts(found)["idler.position"] == verdict
    assert (found.result.wheels["idler"].position is None) is (verdict == "fail")


def test_out_of_reach_names_the_limits():
    check = next(c for c in laid(triangle(), 0.080j).checks if c.id == "gears.idler.position")
    assert check.limit == pytest.approx((10 - 0.002, 70 + 0.002))
    assert "10 to 70 mm" in check.advice and "10 mm closer" in check.advice


def test_a_stretched_train_within_the_tolerance_stands_on_its_line():
    found = laid(triangle(), 0.070001j)
    assert verdicts(found)["idler.position"] == "warn"
    assert place(found, "idler").real == pytest.approx(0, abs=1e-9)
    assert any("miss" in note and "1 µm" in note for note in found.notes)


def test_given_places_that_contradict_a_centre_distance():
    off = laid(triangle(idler=(24, 18.1)), AXIS)
    assert verdicts(off)["crank_idler.position"] == verdicts(off)["idler_shaft.position"] == "fail"
    errors = {c.id: c.value for c in off.checks if c.id.endswith(".position")}
    assert errors["gears.crank_idler.position"] == pytest.approx((math.hypot(24, 18.1) - 30) * 1e3)
    right = verdicts(laid(triangle(idler=(24, 18)), AXIS))
    assert right["crank_idler.position"] == right["idler_shaft.position"] == "pass"


def test_a_given_place_of_the_last_wheel_against_the_counter_shaft():
    gears = triangle()
    gears = replace(gears, wheels=(*gears.wheels[:2], at("shaft", 40, (0, 50.1))))
    assert verdicts(laid(gears, AXIS))["shaft.axis"] == "fail"
    assert verdicts(laid(gears, 0.0501j))["shaft.axis"] == "pass"


def test_a_wheel_with_a_third_neighbour_takes_the_place_that_fits_it():
    pump = at("pump", 20, (24, 48))  # 30 mm above the upper place of the idler
    gears = triangle(meshes=(mesh("crank", "idler"), mesh("idler", "shaft"), mesh("idler", "pump")))
    gears = replace(
        gears, wheels=(*gears.wheels[:2], at("shaft", 40, (0, 50)), pump), walls=(wall("head", 46, -80, 46, 90),)
    )
    found = laid(gears)
    assert place(found, "idler") == pytest.approx(24 + 18j)
    assert "idler_pump.position" not in verdicts(found)


def test_without_positions_nothing_is_invented():
    found = laid(r753())
    assert all(w.position is None and w.clearance is None for w in found.result.wheels.values())
    assert "position_up" not in {v.id.split(".")[-1] for v in found.values()}
    assert not found.tables and any("not given" in note for note in found.notes)
    assert layout_curve(r753(), solved(r753()), found.result) is None


def test_two_idlers_in_a_row_keep_their_centre_distances():
    gears = r753()
    found = laid(gears, 0.130 + 0.103j)
    meshes = solved(gears).meshes
    for mesh_ in meshes.values():
        c = abs(found.result.wheels[mesh_.driver].position - found.result.wheels[mesh_.driven].position)
        assert c == pytest.approx(mesh_.centre_distance, abs=1e-12)
    assert any("chosen" in note and "one angle is free" in note for note in found.notes)


def test_two_idlers_in_a_row_find_the_most_room():
    """No direction of a scan of its own leaves the tighter idler more, beyond what the step of the program's own scan
    costs."""
    gears = replace(r753(), walls=(wall("cover", -60, 20, 160, 20),), neighbours=(screw("screw", 150, -10, 10),))
    outcome = laid(gears, 0.130 + 0.103j)
    found, system = outcome.result, solved(gears)
    a = [m.centre_distance for m in system.meshes.values()]
    r = {name: w.tip_diameter / 2 for name, w in system.wheels.items()}
    tolerance, q = 55e-6, 0.130 + 0.103j
    best = -1.0
    for k in range(2880):
        A = a[0] * cmath.exp(2j * math.pi * k / 2880)
        c = abs(q - A)
        if abs(a[1] - a[2]) < c < a[1] + a[2]:
            u = (c**2 + a[1] ** 2 - a[2] ** 2) / (2 * c)
            for s in (1, -1):
                B = A + (u + s * 1j * math.sqrt(a[1] ** 2 - u**2)) * (q - A) / c
                room = []
                for name, p, other, far in (("central", A, "shaft", q), ("idler", B, "crank", 0)):
                    own = r[name] + tolerance
                    room.append(abs(p - far) - own - r[other] - (tolerance if other == "shaft" else 0))
                    room.append(abs(p - (0.150 - 0.010j)) - 0.010 - own)
                    room.append(abs(p - complex(min(max(p.real, -0.06), 0.16), 0.02)) - own)
                best = max(best, min(room))
    assert min(found.wheels[name].clearance for name in ("central", "idler")) == pytest.approx(best, abs=0.05e-3)


def row(open_, places=NOWHERE):
    """A train of so many wheels of 30 teeth between crank and shaft, with a module of 1 mm."""
    names = ["crank", *(f"i{n}" for n in range(1, open_ + 1)), "shaft"]
    wheels = [at(name, 30, places.get(name)) for name in names]
    return train(wheels, [mesh(*pair) for pair in pairwise(names)], m_n=1.0, beta=0.0, ball=None)


@pytest.mark.parametrize("open_", [2, 3, 4, 5, 6])
def test_a_row_that_can_not_span_the_distance_of_its_ends_fails_however_many_they_are(open_):
    spans = (open_ + 1) * 30e-3
    for far, verdict in ((0.5 * spans, "pass"), (1.001 * spans, "fail"), (5 * spans, "fail")):
        assert verdicts(laid(row(open_), 1j * far))["i1.position"] == verdict


@pytest.mark.parametrize("open_", [3, 4, 5, 6])
@pytest.mark.parametrize("share", [0.3, 0.6, 0.95])
def test_a_longer_row_is_not_verified_until_the_proposed_places_are_given(open_, share):
    axis = 1j * share * (open_ + 1) * 30e-3
    found = laid(row(open_), axis)
    (unplaced,) = (check for check in found.checks if check.verdict == "not_verified")
    assert found.result.wheels["i2"].position is None
    (proposed,) = unplaced.remedies
    assert tuple(key for key, _ in proposed.changes) == unplaced.missing
    places = {key.split(".")[2]: place for key, place in proposed.changes}
    placed = laid(row(open_, places), axis)
    assert all(wheel.position is not None for wheel in placed.result.wheels.values())
    assert not any(c.verdict in ("fail", "not_verified") for c in placed.checks if ".position" in c.id)


def test_a_row_whose_longest_distance_is_more_than_all_others_can_not_fold():
    wheels = [at(name, teeth) for name, teeth in (("crank", 300), ("a", 20), ("b", 20), ("c", 20), ("shaft", 20))]
    gears = train(wheels, [mesh(*pair) for pair in pairwise(w.name for w in wheels)], m_n=1.0, beta=0.0, ball=None)
    assert [verdicts(laid(gears, 1j * c))["a.position"] for c in (0.09, 0.16)] == ["fail", "pass"]


def test_clearances_take_runout_tolerance_and_the_upper_deviation():
    gears = triangle(idler=(24, 18), walls=[wall("head", 50, -80, 50, 90)], neighbours=[screw("gallery", 24, -20, 4)])
    exact = laid(gears, AXIS).result.wheels["idler"]
    assert exact.clearance_wall * 1e3 == pytest.approx(26 - 21)
    assert exact.clearance_neighbour * 1e3 == pytest.approx(38 - 21 - 4)
    idler = at("idler", 40, (24, 18), runout=40e-6, tip_diameter_tolerance=(20e-6, -100e-6))
    meshes = mesh("crank", "idler", 30, tolerance=50), mesh("idler", "shaft", 40, tolerance=30)
    worse = laid(replace(gears, wheels=(gears.wheels[0], idler, gears.wheels[2]), meshes=meshes), AXIS).result.wheels[
        "idler"
    ]
    assert (exact.clearance_wall - worse.clearance_wall) * 1e6 == pytest.approx(10 + 20 + 50)


@pytest.mark.parametrize("up, limit, usual", [(44.9, "fail", "note"), (45.5, "pass", "note"), (46.5, "pass", "pass")])
def test_the_checks_of_a_clearance(up, limit, usual):
    found = verdicts(laid(triangle(idler=(24, 18), walls=[wall("head", up, -80, up, 90)]), AXIS))
    assert (found["idler.clearance"], found["idler.clearance_usual"]) == (limit, usual)


def test_beyond_its_end_a_wall_is_as_near_as_its_end():
    found = laid(triangle(idler=(24, 18), walls=[wall("rib", 24, 48, 24, 80)]), AXIS).result.wheels["idler"]
    assert found.clearance_wall * 1e3 == pytest.approx(30 - 21)


def test_wheels_that_do_not_mesh_but_overlap_fail_once():
    gears = triangle(meshes=(mesh("crank", "idler", 30), mesh("idler", "shaft", 40)))
    found = laid(gears, 0.030j)  # tips 11 and 21 mm on 30 mm
    failing = [c.id for c in found.checks if c.id.endswith(".clearance") and c.verdict == "fail"]
    assert failing == ["gears.shaft.clearance"]
    assert found.result.wheels["crank"].clearance_wheel * 1e3 == pytest.approx(-2)


@given(st.floats(11, 69), st.floats(0, 6.2))
def test_the_idler_stands_at_both_centre_distances(c, angle):
    assume(abs(c - 10) > 0.01)
    axis = c * 1e-3 * cmath.exp(1j * angle)
    p = layout(TRIANGLE, SOLVED, {"shaft": ShaftInTrain(axis)}).result.wheels["idler"].position
    assert abs(p) == pytest.approx(0.030, abs=1e-12)
    assert abs(p - axis) == pytest.approx(0.040, abs=1e-12)


def test_the_picture_has_every_wheel_at_its_place():
    gears = triangle(walls=[wall("head", 50, -80, 50, 90)], neighbours=[screw("gallery", 60, 20, 4)])
    found = laid(gears, AXIS)
    curve = layout_curve(gears, solved(gears), found.result)
    assert [s.label for s in curve.series] == ["crank", "idler", "shaft", "head", "gallery"]
    for series, name in zip(curve.series, ("crank", "idler", "shaft")):
        p, tip = place(found, name), solved(gears).wheels[name].tip_diameter * 1e3
        assert (series.x.max() + series.x.min()) / 2 == pytest.approx(p.imag, abs=1e-2 * tip)
        assert series.y.max() - series.y.min() == pytest.approx(tip, rel=1e-3)
