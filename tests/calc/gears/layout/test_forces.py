"""Forces on the axes: equilibrium of every wheel, the right angle by hand, the direction of the thrust."""

import cmath
import math
from dataclasses import replace
from itertools import pairwise

import pytest

from calc.gears.layout.forces import forces
from tests.calc.gears.layout.trains import AXIS, laid, r753, solved, triangle

T = 4.958  # N·m at the crank


def torques(gears, loss=1.0):
    """Of the drivers, handed on without loss, or with a share of it in every mesh."""
    result = solved(gears)
    on, found = {gears.meshes[0].driver: T}, {}
    for key, m in result.meshes.items():
        found[key] = on[m.driver]
        on[m.driven] = on[m.driver] * result.wheels[m.driven].teeth / result.wheels[m.driver].teeth * loss
    return found


def loaded(gears, axis=None, loss=1.0):
    return forces(gears, solved(gears), laid(gears, axis).result, torques(gears, loss))


def handed(gears, **hand):
    return replace(gears, wheels=tuple(replace(w, hand=hand.get(w.name)) for w in gears.wheels))


def test_tangential_force_of_the_consistent_load():
    """4.958 N·m on d = 53.895 mm is 184.0 N in every mesh; at the working circle it is 184.0·d/d_w."""
    gears = r753()
    found = loaded(gears)
    result = solved(gears)
    for key, m in result.meshes.items():
        at_reference = (
            found.result.meshes[key].working_tangential_force
            * m.working_diameter_driver
            / result.wheels[m.driver].reference_diameter
        )
        assert at_reference == pytest.approx(184.0, abs=0.05)
        assert found.result.meshes[key].axial_force == pytest.approx(at_reference * math.tan(gears.helix_angle))


@pytest.mark.parametrize("up, sign", [(-24, 1), (24, -1)])
def test_an_idler_at_a_right_angle(up, sign):
    """F_1 and F_2 turn by 90° against each other: √2·(F_t ± F_r), by the side on which the idler stands."""
    found = loaded(triangle(idler=(up, 18)), AXIS).result
    F_t, F_r = 2 * T / 0.020, 2 * T / 0.020 * math.tan(math.radians(20))
    assert found.meshes["crank_idler"].working_tangential_force == pytest.approx(F_t)
    assert found.wheels["idler"].bearing_force == pytest.approx(math.sqrt(2) * (F_t + sign * F_r))


def test_the_torque_of_the_forces_about_every_axis():
    """Moment of the mesh about the axis: against the crank's drive at the crank, none left at the idlers."""
    gears, axis = r753(), 0.130 + 0.103j
    places = laid(gears, axis).result
    result, given = solved(gears), torques(gears)
    moments = dict.fromkeys(result.wheels, 0.0)
    sums = dict.fromkeys(result.wheels, 0j)
    sense = 1
    for key, m in result.meshes.items():
        gamma, made = places.meshes[key].line_of_centres, loaded(gears, axis).result.meshes[key]
        along = cmath.exp(1j * gamma)
        pressure = made.working_radial_force + 1j * sense * made.working_tangential_force  # on the driven wheel
        point = places.wheels[m.driver].position + along * m.working_diameter_driver / 2
        for name, sign in ((m.driven, 1), (m.driver, -1)):
            F = sign * along * pressure
            moments[name] += ((point - places.wheels[name].position).conjugate() * F).imag
            sums[name] += F
        sense = -sense
    assert moments["crank"] == pytest.approx(-T)
    assert moments["central"] == pytest.approx(0, abs=1e-9) and moments["idler"] == pytest.approx(0, abs=1e-9)
    assert moments["shaft"] == pytest.approx(-given["idler_shaft"] * 25 / 39)  # turns it against the crank
    for name, w in loaded(gears, axis).result.wheels.items():
        assert w.bearing_force == pytest.approx(abs(sums[name]))
        assert w.bearing_force * cmath.exp(1j * w.bearing_force_direction) == pytest.approx(sums[name])
    assert sum(sums.values()) == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("axis", [0.130 + 0.103j, 0.08j, -0.1 + 0.15j])
def test_bounds_without_positions_hold_with_them(axis):
    gears = r753()
    free, placed = loaded(gears).result.wheels, loaded(gears, axis).result.wheels
    for name in ("central", "idler"):
        assert free[name].bearing_force is None and placed[name].bearing_force_min is None
        assert free[name].bearing_force_min <= placed[name].bearing_force <= free[name].bearing_force_max
        assert free[name].bearing_force_min == 0, "both meshes pull alike, and the last digits are no force"
        assert free[name].tilting_couple_min <= placed[name].tilting_couple <= free[name].tilting_couple_max
    for name in ("crank", "shaft"):
        assert free[name].bearing_force == pytest.approx(placed[name].bearing_force)


def test_a_right_handed_driver_is_pushed_along_its_own_rotation():
    """In space: at (r, 0, 0) a right-handed tooth runs along (0, sin β, cos β); its leading flank, normal (0, cos β,
    −sin β), is pushed back by the mate, and the wheel that turns from x to y about +z is pushed towards +z."""
    beta = r753().helix_angle
    trace, normal = (math.sin(beta), math.cos(beta)), (math.cos(beta), -math.sin(beta))
    assert trace[0] * normal[0] + trace[1] * normal[1] == pytest.approx(0)
    pushed = -normal[1]
    assert math.copysign(1, loaded(handed(r753(), crank="right")).result.wheels["crank"].thrust) == math.copysign(
        1, pushed
    )
    assert loaded(handed(r753(), crank="left")).result.wheels["crank"].thrust < 0


def test_thrusts_cancel_on_idlers_and_over_the_train():
    found = loaded(r753()).result.wheels
    assert found["central"].thrust == 0 and found["idler"].thrust == 0
    assert found["crank"].thrust == pytest.approx(-found["shaft"].thrust)
    assert found["shaft"].thrust < 0  # the left-handed shaft wheel, turning backwards, towards the front


def test_a_loss_leaves_a_thrust_on_the_idlers():
    found = loaded(r753(), loss=0.99).result
    a, b = found.meshes["crank_central"].axial_force, found.meshes["central_idler"].axial_force
    assert abs(found.wheels["central"].thrust) == pytest.approx(a - b)
    assert a - b == pytest.approx(0.01 * a)


def test_the_tilting_couple_of_idlers_in_one_line():
    """Stretched out, both axial forces act on opposite sides: F_a·d_w, the mean of the two working diameters."""
    gears = r753()
    m = solved(gears).meshes
    stretched = sum(x.centre_distance for x in m.values())
    found = loaded(gears, 1j * stretched * (1 - 1e-15)).result
    F_a = found.meshes["crank_central"].axial_force
    d_w = (m["crank_central"].working_diameter_driven + m["central_idler"].working_diameter_driver) / 2
    assert found.wheels["central"].tilting_couple == pytest.approx(F_a * d_w)
    assert found.wheels["shaft"].tilting_couple == pytest.approx(F_a * m["idler_shaft"].working_diameter_driven / 2)


def test_spur_wheels_have_neither_hand_nor_thrust():
    found = loaded(triangle(), AXIS)
    assert all(w.thrust is None and w.tilting_couple is None and not w.hand for w in found.result.wheels.values())
    assert all(m.axial_force is None for m in found.result.meshes.values())
    assert not found.notes


@pytest.mark.parametrize(
    "given, first",
    [
        ({}, "right"),
        ({"crank": "left"}, "left"),
        ({"central": "right"}, "left"),
        ({"idler": "right"}, "right"),
        ({"shaft": "right"}, "left"),
    ],
)
def test_hands_alternate_from_any_that_is_given(given, first):
    found = list(handed(r753(), **given).hands().values())
    assert found[0] == first
    assert all(a != b for a, b in pairwise(found))


def test_hands_that_do_not_alternate_are_refused():
    wrong = list(handed(r753(), crank="right", idler="left").problems())
    assert [key for key, _ in wrong] == ["wheels.2.hand"] and "must be right" in wrong[0][1]


def test_the_note_says_where_the_shaft_is_pushed():
    notes = loaded(r753()).notes
    assert any(
        "shaft, left-handed and turning against the crank, is pushed 74.02 N towards the front" in n for n in notes
    )
    assert any("not given; chosen: crank right-handed" in n for n in notes)
