"""What shafts and counterweights need, and what they leave."""

import math

import numpy as np
import pytest
from hypothesis import given, settings

from calc.imbalance.inputs import ImbalanceInputs
from calc.imbalance.remedies import supplied_couple, supplied_force
from tests.calc.imbalance.engines import fans, solved

SINGLE = dict(cylinders=1, firing_order=None)
TWIN = dict(cylinders=2, firing_order=(1, 2))


def test_two_shafts_leave_nothing_of_their_order():
    """Less than 1e-9 of the couple, from the shafts' own unbalance, speed and direction."""
    _, e, i = solved(ImbalanceInputs(crank_balance_fraction=0.0))
    first, second = i.orders["order_1"], i.orders["order_2"]
    pair, fast = i.remedy["first_order_pair"], i.remedy["second_order_shafts"]
    for order, shafts in (
        (first, (pair.shafts["forward"], pair.shafts["backward"])),
        (second, (fast.shafts["forward_2"], fast.shafts["backward_2"])),
    ):
        for vector, shaft in zip(order.vectors[2:], shafts):
            own = supplied_couple(
                i=shaft.speed_ratio,
                omega=e.angular_speed,
                P=shaft.unbalance_product,
                gamma=shaft.unbalance_product_phase,
            )
            assert abs(vector + own) < 1e-12 * abs(vector)
    assert pair.order_1_couple < 1e-9 * first.couple_peak and fast.order_2_couple < 1e-9 * second.couple_peak
    assert pair.order_2_couple == second.couple_peak


def test_second_order_shafts_of_the_r753():
    """Spec of the second-order pair: U·Δz = 634.17 kg·mm² each with two terms."""
    shafts = solved(ImbalanceInputs(kinematics="two_term"))[2].remedy["second_order_shafts"].shafts
    assert [s.unbalance_product * 1e6 for s in shafts.values()] == pytest.approx([634.17, 634.17], abs=5e-3)


def test_complete_balance_of_a_single_cylinder():
    """Shafts at ±ω with ½·m·r each, at ±2ω with m·λ·r/8 each (mechanics textbook, ch. 48); the two-term motion leaves
    nothing."""
    inputs, e, i = solved(ImbalanceInputs(crank_balance_fraction=0.0, kinematics="two_term"), **SINGLE)
    four = i.remedy["four_shafts"]
    moment = e.reciprocating_mass * inputs.crank_radius
    assert four.shafts["forward"].unbalance == pytest.approx(moment / 2)
    assert four.shafts["backward"].unbalance == pytest.approx(moment / 2)
    assert four.shafts["forward_2"].unbalance == pytest.approx(moment * e.lambda_ / 8)
    assert four.shafts["backward_2"].unbalance == pytest.approx(moment * e.lambda_ / 8)
    assert four.order_1_force < 1e-9 * i.one_force and four.order_2_force < 1e-9 * i.one_force


def test_two_term_shafts_leave_091_percent_of_the_exact_motion():
    """λ = 0.28: shafts sized for two terms leave 0.91 % of the peak force of the exact motion."""
    _inputs, e, i = solved(
        ImbalanceInputs(crank_balance_fraction=0.0, kinematics="two_term"), rod_length=0.0535 / 0.28, **SINGLE
    )
    turn = np.linspace(0, 2 * np.pi, 721)
    sine = e.lambda_ * np.sin(turn)
    exact = (
        np.cos(turn)
        + e.lambda_ * np.cos(2 * turn) / np.sqrt(1 - sine**2)
        + e.lambda_ * sine**2 * np.cos(turn) ** 2 / (1 - sine**2) ** 1.5
    )
    force = i.one_force * exact
    for name, n in (("forward", 1), ("backward", -1), ("forward_2", 2), ("backward_2", -2)):
        shaft = i.remedy["four_shafts"].shafts[name]
        own = supplied_force(i=float(n), omega=e.angular_speed, U=shaft.unbalance, gamma=shaft.unbalance_phase)
        force = force + (own * np.exp(1j * n * turn)).real
    assert np.abs(force).max() / (i.one_force * (1 + e.lambda_)) == pytest.approx(0.0091, abs=5e-5)


def test_twin_with_one_balance_shaft():
    """Half on the crank and one shaft at −ω with U = m·r; 2·m·r·ω²·λ of second order stay; beside the crank it rolls
    the engine."""
    inputs, e, i = solved(ImbalanceInputs(kinematics="two_term"), axis=complex(-0.03, 0.08), **TWIN)
    remedy = i.remedy["backward_shaft"]
    assert remedy.shafts["backward"].unbalance == pytest.approx(e.reciprocating_mass * inputs.crank_radius)
    assert remedy.order_1_force < 1e-9 * i.one_force
    assert remedy.order_2_force == pytest.approx(2 * i.one_force * e.lambda_)
    force = i.orders["order_1"].force_backward
    assert remedy.roll_torque == pytest.approx(math.hypot(0.03, 0.08) * force)
    assert remedy.roll_torque_at_100_mm == pytest.approx(0.1 * force)


def test_a_pure_couple_rolls_nothing():
    remedy = solved(axis=0.1 + 0j)[2].remedy["backward_shaft"]
    assert remedy.roll_torque is None and remedy.shafts["backward"].unbalance is None


def test_counterweights_of_a_single_and_of_a_twin():
    """m_cp = ½·m_rot·r/r_cp twice for the single; m_rot·(b/c)·(r/r_cp) at either end of the 180° twin (mechanics
    textbook, ch. 48)."""
    given = ImbalanceInputs(crank_balance_fraction=0.0, counterweight_span=0.08, counterweight_radius=0.04)
    inputs, e, i = solved(given, **SINGLE)
    assert [w.mass for w in i.counterweight.values()] == pytest.approx(
        [e.rotating_mass / 2 * inputs.crank_radius / 0.04] * 2
    )
    assert [math.degrees(w.angle) for w in i.counterweight.values()] == pytest.approx([180, 180])
    given = ImbalanceInputs(crank_balance_fraction=0.0, counterweight_span=0.2, counterweight_radius=0.04)
    inputs, e, i = solved(given, cylinders=2, firing_order=None, crank_angles=(0.0, math.pi))
    assert [w.mass for w in i.counterweight.values()] == pytest.approx(
        [e.rotating_mass * 0.112 / 0.2 * inputs.crank_radius / 0.04] * 2
    )


def test_counterweights_of_the_inline_three():
    """m_e·r_e = √3·a·m·r/l (Finotti 2013, 2.4), for the equivalent mass 1503.325 g at half of the reciprocating
    mass."""
    given = ImbalanceInputs(counterweight_span=0.3, counterweight_radius=0.06)
    weights = solved(given)[2].counterweight
    assert [w.mass * 0.06 for w in weights.values()] == pytest.approx(
        [math.sqrt(3) * 0.112 * 1.503325 * 0.0535 / 0.3] * 2, rel=1e-6
    )
    assert math.degrees(weights["rear"].angle - weights["front"].angle) % 360 == pytest.approx(180)


@settings(max_examples=25, deadline=None)
@given(fan=fans(offset=False))
def test_half_on_the_crank_and_one_shaft_take_the_first_order_of_any_engine(fan):
    i = solved(**fan)[2]
    remedy = i.remedy.get("backward_shaft") or i.remedy["crank"]
    scale = len(fan["axial_positions"])
    assert remedy.order_1_force < 1e-5 * i.one_force * scale and remedy.order_1_couple < 1e-5 * i.one_force * scale


def test_mistiming():
    """1° leaves 10.0 N·m of the R753's 572.9; a tooth of 25 leaves 2·sin(π/25) of it."""
    from calc.engine import solve as engine
    from calc.engine.inputs import EngineInputs
    from calc.imbalance import solve as imbalance
    from tests.calc.imbalance.engines import R753

    inputs = EngineInputs(**R753)
    found = imbalance.values(ImbalanceInputs(), inputs, engine.values(inputs), 25)
    assert found.mistiming_per_degree == pytest.approx(10.0, abs=0.05)
    assert found.mistiming_per_tooth == pytest.approx(abs(found.required - found.required * np.exp(2j * np.pi / 25)))


def test_the_whole_set_leaves_nothing():
    i = solved()[2]
    whole = i.remedy["crank_and_shafts"]
    assert set(whole.shafts) == {"backward", "forward_2", "backward_2"}
    assert whole.order_1_couple == whole.order_2_couple == 0


def test_what_an_offset_leaves_on_the_crank_is_said():
    """Counterweights opposite the pins can not take a vector that the offset turns away from them."""
    from calc.engine import solve as engine
    from calc.engine.inputs import EngineInputs
    from calc.imbalance.solve import solve
    from tests.calc.imbalance.engines import R753

    said = {}
    for offset in (0.0, 0.008):
        inputs = EngineInputs(**{**R753, "cylinder_offset": offset})
        said[offset] = solve(ImbalanceInputs(), inputs, engine.values(inputs)).proposals[0]
    assert "take all of first order" in said[0.0]
    assert "take all but a couple of" in said[0.008]
