"""Two balance shafts at unequal heights: their roll about the crank's axis, against hand formulas and a turn in
time."""

import cmath
import math
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from calc.engine import solve as engine
from calc.engine.inputs import EngineInputs
from calc.imbalance import solve as imbalance
from calc.imbalance.inputs import ImbalanceInputs
from calc.imbalance.shaft_pair import ShaftPair, pair_table, roll_backward, roll_forward
from tests.calc.imbalance.engines import R753

FOUR = dict(cylinders=4, firing_order=(1, 3, 4, 2))
SINGLE = dict(cylinders=1, firing_order=None)


def outcome(forward=None, backward=None, kinematics="exact", n=2, **changes):
    """Engine's values and the imbalance outcome with the shafts at [up, side] in metres."""
    inputs = EngineInputs(**{**R753, **changes})
    e = engine.solve(inputs).result
    given = ImbalanceInputs(
        crank_balance_fraction=0.0,
        kinematics=kinematics,
        forward_shaft_axis=forward,
        backward_shaft_axis=backward,
        shaft_pair_order=n,
    )
    assert list(given.problems()) == []
    return e, imbalance.solve(given, inputs, e)


def pair(forward, backward, **changes):
    return outcome(forward, backward, **{**FOUR, **changes})[1].result.shaft_pair


def test_equal_heights_roll_nothing():
    """Lanchester's arrangement: mirrored at the cylinders' plane."""
    made = pair((0.03, 0.08), (0.03, -0.08))
    assert made.roll_torque == 0 and made.roll_left == made.reaction > 0
    assert made.force_forward == made.force_backward > 0


def test_unequal_heights_roll_by_half_the_force_times_the_height():
    """F/2·Δh, F = 4·m·r·ω²·λ the second-order force of the flat four; the sideways places cancel."""
    e, made = outcome((0.10, 0.09), (-0.02, -0.09), "two_term", **FOUR)
    found = made.result.shaft_pair
    force = 4 * e.reciprocating_mass * 0.0535 * e.angular_speed**2 * e.lambda_
    assert found.force_forward == pytest.approx(force / 2)
    assert found.height_difference == pytest.approx(0.12)
    assert found.roll_torque == pytest.approx(force / 2 * 0.12)
    # the force is taken wherever the shafts stand
    assert made.result.remedy["second_order_shafts"].order_2_force < 1e-9 * force


def test_sideways_places_that_are_no_mirror_roll_too():
    """Both shafts 80 mm to one side: the whole force F at 80 mm, a quarter of its period from what a height makes."""
    aside, high = pair((0.0, 0.08), (0.0, 0.08)), pair((0.08, 0.0), (0.0, 0.0))
    assert aside.roll_torque == pytest.approx(2 * 0.08 * aside.force_forward)
    assert abs(math.sin(aside.roll_torque_phase - high.roll_torque_phase)) == pytest.approx(1)


def test_a_height_of_the_rod_takes_the_whole_inertia_torque():
    """Two terms, flat four: T_2 = 2·m·r²·ω² = F/2·L (mechanics of the slider-crank): the nearer, the longer the rod."""
    for rod, near in ((0.163, 0.04), (1.63, 4e-4)):
        found = pair((0.7 * rod, 0.09), (0.0, -0.09), kinematics="two_term", rod_length=rod)
        assert found.height_difference_of_least_roll == pytest.approx(rod, rel=near)
        assert found.roll_left / found.reaction == pytest.approx(0.3, abs=near)  # 0.7 of the rod takes 70 %


def test_the_height_of_least_roll_is_that():
    """Wherever the shafts stand sideways, each millimetre off leaves more; at it a mirrored pair leaves nothing."""
    best = pair((0.02, 0.09), (0.01, -0.07)).height_difference_of_least_roll
    left = [pair((0.01 + best + off, 0.09), (0.01, -0.07)).roll_left for off in (-1e-3, 0.0, 1e-3)]
    assert left[1] < min(left[0], left[2])
    mirrored = pair((0.02, 0.09), (0.01, -0.09))
    assert pair((mirrored.height_difference_of_least_roll, 0.09), (0.0, -0.09)).roll_left < 1e-9 * mirrored.reaction


@pytest.mark.parametrize("n", [1, 2])
@pytest.mark.parametrize(
    "changes", [SINGLE, {**SINGLE, "cylinder_offset": 0.008}, dict(cylinders=2, firing_order=(1, 2))]
)
def test_roll_against_a_turn_in_time(n, changes):
    """Order n of the moment on the block, from positions in time: the pistons' energy turns the crank, each force acts
    at its place."""
    p_f, p_b = complex(0.11, 0.05), complex(-0.03, -0.07)
    e, made = outcome((p_f.real, p_f.imag), (p_b.real, p_b.imag), n=n, **changes)
    inputs = EngineInputs(**{**R753, **changes})
    found, remedy = made.result.shaft_pair, made.result.remedy
    shafts = remedy["first_order_pair" if n == 1 else "second_order_shafts"].shafts.values()
    turn = np.arange(4096) * 2 * np.pi / 4096
    alpha, d, r, L, omega = (
        turn + e.tdc_angle,
        inputs.cylinder_offset,
        inputs.crank_radius,
        inputs.rod_length,
        e.angular_speed,
    )
    x = r * np.cos(alpha) + np.sqrt(L**2 - (r * np.sin(alpha) - d) ** 2)

    def slope(y):
        return np.fft.irfft(1j * np.arange(2049) * np.fft.rfft(y), 4096)

    mass = inputs.cylinders * e.reciprocating_mass
    torque = -slope(mass * (omega * slope(x)) ** 2 / 2)  # on the crank: what the pistons lose of energy
    upwards = -mass * omega**2 * slope(slope(x))  # inertia force, at the distance d in the sense of rotation
    moment = -torque - d * upwards
    of_shafts = np.zeros_like(turn)
    for place, shaft in zip((p_f, p_b), shafts):
        force = shaft.unbalance * (n * omega) ** 2 * np.exp(1j * (shaft.unbalance_phase + shaft.speed_ratio * turn))
        of_shafts += place.real * force.imag - place.imag * force.real
    for course, amount, phase in (
        (of_shafts, found.roll_torque, found.roll_torque_phase),
        (moment, found.reaction, found.reaction_phase),
    ):
        assert 2 * np.fft.rfft(course)[n] / 4096 == pytest.approx(cmath.rect(amount, phase), rel=1e-6)
    assert abs(2 * np.fft.rfft(of_shafts + moment)[n] / 4096) == pytest.approx(found.roll_left, rel=1e-6)


places = st.complex_numbers(max_magnitude=1, allow_nan=False, allow_infinity=False)


@given(places, places, places, places, places)
def test_a_shift_of_both_shafts_changes_the_roll_by_the_whole_force_only(p_f, p_b, F_f, F_b, shift):
    """The moment about another axis differs by shift × resultant force, and by nothing where the two forces cancel."""

    def roll(p_f, p_b):
        return roll_forward(p=p_f, F=F_f) + roll_backward(p=p_b, F=F_b)

    assert abs(roll(p_f + shift, p_b + shift) - roll(p_f, p_b) - roll(shift, shift)) < 1e-10


def test_the_wrong_shaft_on_top_is_advised_against():
    """The shaft that turns against the crank on top adds to the inertia's roll; the other way round it takes of it."""
    for forward, backward, passes in (((0.1, 0.09), (0.0, -0.09), True), ((0.0, 0.09), (0.1, -0.09), False)):
        made = next(c for c in outcome(forward, backward, **FOUR)[1].checks if c.id == "imbalance.shaft_pair.roll")
        assert (made.value <= made.limit) is passes and made.kind == "advice"


@pytest.mark.parametrize("n, name, left", [(1, "first_order_pair", 11.0), (2, "second_order_shafts", 12.0)])
def test_the_table_of_the_pair(n, name, left):
    """Lengths in mm, phases in degrees, and of the remedy the force of the order that the shafts are for."""
    numbers = dict(
        force_forward=1.0,
        force_backward=2.0,
        height_difference=0.12,
        roll_torque=3.0,
        roll_torque_phase=math.radians(40.0),
        reaction=5.0,
        reaction_phase=math.radians(-60.0),
        roll_left=7.0,
    )
    remedy = {name: SimpleNamespace(order_1_force=11.0, order_2_force=12.0)}
    (row,) = pair_table(ShaftPair(**numbers, height_difference_of_least_roll=0.05), n, remedy).rows
    assert row[0] == f"±{n}"
    assert row[1:] == pytest.approx((1.0, 2.0, left, 120.0, 3.0, 40.0, 5.0, -60.0, 7.0, 50.0))
    assert pair_table(ShaftPair(**numbers), n, remedy).rows[0][-1] is None


def test_without_places_or_forces_there_is_no_pair():
    bare = outcome(**FOUR)[1]
    assert bare.result.shaft_pair is None and not [t for t in bare.tables if t.id == "shaft_pair"]
    three = outcome((0.1, 0.09), (0.0, -0.09))[1]  # couples alone
    assert three.result.shaft_pair is None and any("carries a force of order 2" in note for note in three.notes)
    # a flat four has no force of first order
    assert outcome((0.1, 0.09), (0.0, -0.09), n=1, **FOUR)[1].result.shaft_pair is None


V_TWIN = dict(
    layout="vee",
    cylinders=2,
    firing_order=None,
    crank_angles=(0.0, 0.0),
    bank_of_cylinder=(0, 1),
    axial_positions=(0.0, 0.0),
)


def test_one_shaft_of_a_pair_may_have_nothing_to_carry():
    """Two cylinders of a vee of 60° on one pin: cos(3·30°) = 0 of the second order turns backward."""
    shafts = pair((0.03, 0.04), (0.0, -0.07), **V_TWIN, bank_angle=math.radians(60.0))
    assert shafts.force_backward == 0.0
    assert shafts.roll_torque == pytest.approx(0.05 * shafts.force_forward) and shafts.roll_torque > 1.0


def test_a_force_across_does_not_mind_the_height():
    """In a vee of 90° the second order of both cylinders on a pin lies across: cos(45°) = −cos(3·45°)."""
    shafts = pair((0.1, 0.04), (0.0, -0.04), **V_TWIN, bank_angle=math.radians(90.0))
    assert shafts.force_forward == pytest.approx(shafts.force_backward) and shafts.force_forward > 1000.0
    assert shafts.height_difference_of_least_roll is None


def test_one_place_needs_the_other():
    alone = ImbalanceInputs(forward_shaft_axis=(0.1, 0.09), shaft_pair_order=2)
    inputs = EngineInputs(**{**R753, **FOUR})
    assert imbalance.values(alone, inputs, engine.solve(inputs).result).shaft_pair is None
    assert [key for key, _ in ImbalanceInputs(forward_shaft_axis=(0.1, 0.0)).problems()] == ["backward_shaft_axis_mm"]
