"""The torque about the crank beside closed forms: work of the cycle, kinetic energy, Fourier series of the two-term
motion."""

import math
from dataclasses import replace

import numpy as np
import pytest

from calc.engine import formulas as f
from calc.engine import torque
from calc.engine.crank import firing
from calc.engine.cycle import dead_centre_angle, highest, own_angle, piston_way, points, running
from calc.engine.gas import GasInputs, PressurePoint
from calc.engine.inputs import EngineInputs
from calc.engine.solve import solve, values
from calc.engine.torque import prepare
from calc.sheet.quantity import published
from calc.sheet.value import link_of, trace
from tests.calc.engine.test_gas import DIESEL, pressure
from tests.calc.imbalance.test_engines import R753

DEGREE = math.pi / 180
V6 = dict(
    layout="vee",
    cylinders=6,
    bank_angle=90 * DEGREE,
    firing_order=None,
    crank_angles=tuple(a * DEGREE for a in (0, 0, 240, 240, 120, 120)),
)


def engine_of(**changes):
    engine = EngineInputs(**{**R753, **changes})
    assert not list(engine.problems())
    e = values(engine)
    return engine, e, firing(engine, e.crank).angles


def solved(gas=None, J=None, **changes):
    return torque.solve(*engine_of(**changes), gas, J)


def single(**changes):
    return dict(cylinders=1, firing_order=None, **changes)


# --- inertia
def test_inertia_torque_of_a_long_rod():
    """Two terms: T = m·r²·ω²·(λ/4·sin α − ½·sin 2α − ¾·λ·sin 3α − ¼·λ²·sin 4α), −v·a of sin α + ½λ·sin 2α and cos α +
    λ·cos 2α."""
    lam = 0.01
    engine, e, fires = engine_of(**single(rod_length=0.0535 / lam, rod_cg_to_big_end=0.05))
    found, _, _ = torque.solve(engine, e, fires, None, None)
    scale = e.reciprocating_mass * engine.crank_radius**2 * e.angular_speed**2
    sines = -np.imag(found.harmonics) / scale
    assert sines[:4] == pytest.approx([lam / 4, -1 / 2, -3 * lam / 4, -(lam**2) / 4], rel=3 * lam**2)
    assert np.abs(np.real(found.harmonics)).max() < 1e-12 * scale
    assert found.inertia_torque_peak == pytest.approx(scale / 2, rel=1.5 * lam)


@pytest.mark.parametrize("offset", [0.0, 0.01])
def test_inertia_torque_is_the_loss_of_kinetic_energy(offset):
    """∫T dα = ½·m·(v₀² − v²) at every crank angle, hence no work over a turn."""
    engine, e, fires = engine_of(**single(cylinder_offset=offset))
    epsilon = np.linspace(0, 2 * np.pi, 2001)
    _, T, _ = torque.at(engine, e, None, fires, epsilon[:, None])
    alpha = e.tdc_angle + epsilon
    v = (
        f.relative_speed(alpha=alpha, beta=f.rod_angle(lam=e.lambda_, alpha=alpha, delta=e.delta))
        * e.angular_speed
        * engine.crank_radius
    )
    assert running(epsilon, T[:, 0]) == pytest.approx(
        -e.reciprocating_mass * v**2 / 2, abs=1e-6 * e.reciprocating_mass * v.max() ** 2
    )
    assert abs(T[:-1].mean()) < 1e-12 * np.abs(T).max()
    assert T[0, 0] == pytest.approx(0, abs=1e-9)  # at TDC, with offset too


@pytest.mark.parametrize("changes", [single(), {}, single(cylinder_offset=0.008), V6])
def test_the_harmonics_add_up_to_the_curve(changes):
    found, (curve,), _ = solved(**changes)
    epsilon = np.radians(curve.series[0].x)
    sum_ = sum((t_n * np.exp(1j * n * epsilon)).real for n, t_n in enumerate(found.harmonics, 1))
    assert sum_ == pytest.approx(curve.series[0].y, abs=2e-4 * found.inertia_torque_peak)
    assert found.inertia_torque_peak == pytest.approx(np.abs(curve.series[0].y).max(), rel=2e-3)
    assert found.inertia_torque_peak >= np.abs(curve.series[0].y).max() * (1 - 1e-9)


@pytest.mark.parametrize(
    "changes, orders",
    [
        (dict(cylinders=4, firing_order=(1, 3, 4, 2)), {2, 4, 6, 8}),
        ({}, {3, 6}),
        (dict(cylinders=6, firing_order=(1, 5, 3, 6, 2, 4)), {3, 6}),
        (dict(cylinders=5, firing_order=None), {5}),
    ],
)
def test_even_firing_leaves_multiples_of_half_the_cylinders(changes, orders):
    """Four-stroke engines: orders N/2 and its multiples, those of whole number; each is N times that of one
    cylinder."""
    found, _, _ = solved(**changes)
    one, _, _ = solved(**single())
    cylinders = changes.get("cylinders", 3)
    assert {int(name.removeprefix("order_")) for name in found.inertia_torque} == orders
    assert np.abs(found.harmonics) == pytest.approx(
        [cylinders * abs(t) if n in orders else 0 for n, t in enumerate(one.harmonics, 1)], abs=1e-9
    )


def test_inertia_torque_grows_with_the_square_of_the_speed():
    slow, fast = (solved(rated_speed=n / 60)[0].inertia_torque_peak for n in (1000, 3000))
    assert fast == pytest.approx(9 * slow)


@pytest.mark.parametrize("changes", [{}, V6, dict(cylinder_offset=0.008), dict(cylinders=5, firing_order=None)])
def test_the_cylinders_stand_where_the_crank_says(changes):
    """α_k = θ + φ_k − ψ_k, θ the angle of throw 1 from up, is the angle that follows from the firing of cylinder k."""
    _, e, fires = engine_of(**changes)
    for epsilon in (0.0, 1.0, 5.0):
        theta = epsilon + e.crank.theta_0 - e.crank.phi[0]
        by_firing = e.tdc_angle + own_angle(epsilon=epsilon, fires=fires, cycle=4 * math.pi)
        assert np.exp(1j * (theta + e.crank.phi - e.crank.psi)) == pytest.approx(np.exp(1j * by_firing))


def test_without_gas_the_rest_is_unknown():
    found, curves, notes = solved(J=1.0)
    assert (
        found.gas_torque_peak
        is found.torque_peak
        is found.mean_torque
        is found.indicated_power
        is found.speed_irregularity
        is None
    )
    assert [curve.id for curve in curves] == ["torque"]
    assert any("No gas" in note for note in notes)
    assert {p.id for p in published(found, "engine")} == {
        "engine.inertia_torque_peak",
        "engine.inertia_torque.order_3",
        "engine.inertia_torque.order_6",
        "engine.reaction_inertia_peak",
        "engine.reaction_inertia.order_3",
        "engine.reaction_inertia.order_6",
    }


# --- gas
def work(engine, e, gas=DIESEL, p_in=1e5, p_ex=1.1e5, n_c=1.35, n_e=1.28, hold=10 * DEGREE):
    """∮p dV of the cycle in closed form; p·V^n constant."""
    area, h = math.pi / 4 * engine.bore**2, e.stroke / (gas["compression_ratio"] - 1)
    alpha = e.tdc_angle + hold
    x = piston_way(
        r=engine.crank_radius,
        lam=e.lambda_,
        phi_0=e.tdc_angle,
        alpha=alpha,
        beta=f.rod_angle(lam=e.lambda_, alpha=alpha, delta=e.delta),
    )
    H, s = h + e.stroke, e.stroke
    W = gas["peak_pressure"] * (x + (h + x) / (n_e - 1) * (1 - ((h + x) / H) ** (n_e - 1)))
    W -= p_in * H / (n_c - 1) * ((H / h) ** (n_c - 1) - 1)
    return area * (W + (p_in - p_ex) * s if engine.strokes == 4 else W)


@pytest.mark.parametrize("strokes", [2, 4])
@pytest.mark.parametrize(
    "changes", [{}, single(), dict(cylinder_offset=0.01), dict(cylinders=4, firing_order=(1, 3, 4, 2))]
)
def test_mean_torque_is_the_work_of_the_cycle(changes, strokes):
    """T_m = N·∮p dV over 4π (four-stroke), 2π (two-stroke)."""
    engine, e, fires = engine_of(**changes, strokes=strokes)
    found, (curve, _), _ = torque.solve(engine, e, fires, GasInputs(**DIESEL), None)
    expected = engine.cylinders * work(engine, e) / (math.pi * strokes)
    assert found.mean_torque == pytest.approx(expected, rel=1e-7)
    assert found.indicated_work == pytest.approx(work(engine, e), rel=1e-7)
    assert found.indicated_power == pytest.approx(expected * e.angular_speed, rel=1e-7)
    assert found.indicated_mean_pressure == pytest.approx(
        work(engine, e) / (math.pi / 4 * engine.bore**2 * e.stroke), rel=1e-7
    )
    rated = values(replace(engine, rated_power=found.indicated_power))
    # as if nothing were lost
    assert rated.brake_mean_pressure == pytest.approx(found.indicated_mean_pressure, rel=1e-9)
    assert curve.limits == (("mean", found.mean_torque),)
    assert curve.series[2].x[-1] == pytest.approx(180 * strokes)
    assert curve.series[2].y[:-1].mean() == pytest.approx(expected, rel=2e-3)  # the drawn degrees miss the corners


def test_mean_torque_knows_neither_speed_nor_crankcase():
    mean = {
        (n, p): solved(GasInputs(**DIESEL, crankcase_pressure=p), rated_speed=n / 60)[0].mean_torque
        for n in (1000, 4000)
        for p in (0.5e5, 1e5)
    }
    assert list(mean.values()) == pytest.approx([mean[1000, 1e5]] * 4, rel=1e-6)


def test_even_firing_repeats_every_interval():
    _, (curve, _), _ = solved(GasInputs(**DIESEL), cylinders=4, firing_order=(1, 3, 4, 2))
    for series in curve.series:
        assert series.y[180:] == pytest.approx(series.y[:-180], abs=1e-6)
        assert np.ptp(series.y) > 100


def test_gas_torque_begins_at_dead_centre():
    """dx/dα is 0 at TDC, which an offset cylinder reaches at α = φ₀: the torque of full pressure is 0 there."""
    engine, e, fires = engine_of(**single(cylinder_offset=0.01))
    cycle = prepare(engine, e, GasInputs(**DIESEL))
    bdc = dead_centre_angle(delta=e.delta, lam=e.lambda_)
    T_G, T_I, _ = torque.at(engine, e, cycle, fires, np.array([[0.0], [bdc], [2 * np.pi], [2 * np.pi + bdc]]))
    assert np.abs(T_G).max() < 1e-9
    assert np.abs(T_I).max() < 1e-9


def test_peaks_are_the_largest_of_a_fine_scan():
    engine, e, fires = engine_of()
    gas = GasInputs(**DIESEL)
    found, _, _ = torque.solve(engine, e, fires, gas, None)
    T_G, T_I = (
        part.sum(-1)
        for part in torque.at(engine, e, prepare(engine, e, gas), fires, np.linspace(0, 4 * np.pi, 72001)[:, None])[:2]
    )
    assert found.gas_torque_peak == pytest.approx(np.abs(T_G).max(), rel=1e-6)
    assert found.torque_peak == pytest.approx(np.abs(T_G + T_I).max(), rel=1e-6)


def test_the_peak_may_stand_at_a_corner_of_the_cycle():
    """Peak pressure held for 30°, then expansion: the gas torque of one cylinder is largest right there."""
    engine, e, fires = engine_of(**single())
    gas = GasInputs(**DIESEL, constant_pressure_angle=30.3 * DEGREE)
    found, _, _ = torque.solve(engine, e, fires, gas, None)
    T_G, _, _ = torque.at(engine, e, prepare(engine, e, gas), fires, 30.3 * DEGREE)
    assert found.gas_torque_peak == pytest.approx(T_G.item(), rel=1e-9)


@pytest.mark.parametrize("changes", [{}, single(), V6])
def test_speed_irregularity_against_the_energy_of_a_fine_scan(changes):
    engine, e, fires = engine_of(**changes)
    gas = GasInputs(**DIESEL)
    found, _, _ = torque.solve(engine, e, fires, gas, 2.0)
    epsilon = np.linspace(0, 4 * np.pi, 72001)
    T = (
        sum(part.sum(-1) for part in torque.at(engine, e, prepare(engine, e, gas), fires, epsilon[:, None])[:2])
        - found.mean_torque
    )
    energy = np.cumsum((T[1:] + T[:-1]) / 2) * epsilon[1]
    assert found.energy_fluctuation == pytest.approx(np.ptp(energy), rel=1e-5)
    assert found.speed_irregularity == pytest.approx(found.energy_fluctuation / 2.0 / e.angular_speed**2)
    assert torque.solve(engine, e, fires, gas, None)[0].speed_irregularity is None


def test_a_table_sampled_from_the_cycle_gives_the_same_torque():
    """With a point on either side of each jump."""
    engine, e, fires = engine_of()
    cycle = prepare(engine, e, GasInputs(**DIESEL))
    degrees = np.sort(np.concatenate([np.arange(0, 720, 0.25), [10.0 + 1e-4, 180 + 1e-4, 360 - 1e-4, 720 - 1e-4]]))
    rows = tuple(
        PressurePoint(angle=d * DEGREE, pressure=float(p)) for d, p in zip(degrees, pressure(engine, e, cycle, degrees))
    )
    of_cycle, _, _ = torque.solve(engine, e, fires, GasInputs(**DIESEL), 1.0)
    of_table, _, _ = torque.solve(engine, e, fires, GasInputs(pressure=rows, crankcase_pressure=1e5), 1.0)
    for name in ("mean_torque", "torque_peak", "gas_torque_peak", "energy_fluctuation", "speed_irregularity"):
        assert getattr(of_table, name) == pytest.approx(getattr(of_cycle, name), rel=2e-5)
    assert of_table.compression_end_pressure is None


def test_constant_pressure_turns_nothing_over():
    """The same pressure everywhere: no work, and the energy that the pistons store and give back is what fluctuates."""
    gas = GasInputs(
        pressure=tuple(PressurePoint(angle=i * math.pi / 4, pressure=5e5) for i in range(16)), crankcase_pressure=5e5
    )
    engine, e, fires = engine_of(**single())
    found, _, _ = torque.solve(engine, e, fires, gas, 1.0)
    assert found.mean_torque == pytest.approx(0, abs=1e-9)
    speed = e.piston_speed_max
    assert found.energy_fluctuation == pytest.approx(e.reciprocating_mass * speed**2 / 2, rel=1e-6)


def test_the_published_values_are_the_recorded_ones():
    """Each leads back to the line that made it."""
    engine, e, fires = engine_of()
    with trace() as lines:
        found, _, _ = torque.solve(engine, e, fires, GasInputs(**DIESEL), 1.2)
    missing = {p.id for p in published(found, "engine") if link_of(p.inside) not in lines}
    assert missing == set()


def test_integration_and_peak_of_known_functions():
    engine, e, fires = engine_of(cylinder_offset=0.01)
    epsilon = points(prepare(engine, e, GasInputs(**DIESEL)), fires)
    assert epsilon[0] == 0 and epsilon[-1] == pytest.approx(4 * np.pi) and (np.diff(epsilon) > 0).all()
    assert running(epsilon, np.cos(epsilon)) == pytest.approx(np.sin(epsilon), abs=1e-9)
    at, size = highest(epsilon, np.cos(epsilon - 1.2345))
    assert (at % (2 * math.pi), size) == pytest.approx((1.2345, 1), abs=1e-6)
    assert highest(epsilon, epsilon) == pytest.approx((4 * math.pi, 4 * math.pi))
    assert highest(epsilon, np.ones(epsilon.size)) == (0.0, 1.0)


def test_many_cylinders_are_one_after_the_other():
    """Without one another's help: the torque of the engine is that of one cylinder, turned by each firing angle and
    added up."""
    engine, e, fires = engine_of(**V6)
    one = replace(engine, cylinders=1, layout="inline", bank_angle=None, crank_angles=None)
    cycle = prepare(engine, e, GasInputs(**DIESEL))
    epsilon = np.linspace(0, 4 * np.pi, 50)
    whole = sum(torque.at(engine, e, cycle, fires, epsilon[:, None])[:2]).sum(-1)
    turned = sum(sum(torque.at(one, e, cycle, 0.0, np.mod(epsilon - fire, 4 * np.pi))[:2]) for fire in fires)
    assert whole == pytest.approx(turned, abs=1e-6)


@pytest.mark.parametrize("offset", [0.0, 0.012, -0.02])
def test_the_torque_reaction_is_the_moment_of_the_side_thrust(offset):
    """Statics of the piston: the liner carries the rod's side force at the height of the pin; that is all that turns
    the block."""
    engine, e, fires = engine_of(**single(cylinder_offset=offset))
    found, _, _ = torque.solve(engine, e, fires, None, None)
    theta = np.linspace(0, 2 * np.pi, 7201)
    alpha = e.tdc_angle + theta
    r, L, d = engine.crank_radius, engine.rod_length, offset
    y = r * np.cos(alpha) + np.sqrt(L**2 - (r * np.sin(alpha) - d) ** 2)
    slope = -r * np.sin(alpha) - (r * np.sin(alpha) - d) * r * np.cos(alpha) / (y - r * np.cos(alpha))
    outward = np.gradient(slope, theta, edge_order=2) * e.angular_speed**2
    along_rod = e.reciprocating_mass * outward
    moment = y * along_rod * (d - r * np.sin(alpha)) / (y - r * np.cos(alpha))
    assert found.reaction_inertia_peak == pytest.approx(np.abs(moment[5:-5]).max(), rel=1e-5)
    if offset:
        assert abs(found.reaction_inertia_peak / found.inertia_torque_peak - 1) > 0.05
    else:
        assert found.reaction_inertia_peak == pytest.approx(found.inertia_torque_peak)


def test_forces_that_cancel_add_no_reaction():
    """Inline three with offset: no force of orders 1 and 2, so the block feels the crank's torque of these orders,
    turned round."""
    engine, e, fires = engine_of(cylinder_offset=0.01)
    found, _, _ = torque.solve(engine, e, fires, None, None)
    crank = {name: stated.number for name, stated in found.inertia_torque.items()}
    block = {name: stated.number for name, stated in found.reaction_inertia.items()}
    assert {"order_1", "order_2", "order_4"}.isdisjoint(block) and "order_3" in block
    assert block["order_3"] != pytest.approx(crank["order_3"], rel=1e-6)


@pytest.mark.parametrize("power, verdict", [(50e3, "pass"), (120e3, "fail")])
def test_a_crank_gives_no_more_than_its_gas(power, verdict):
    found = solve(EngineInputs(**R753, gas=GasInputs(**DIESEL), rated_power=power))
    (check,) = [c for c in found.checks if c.id == "engine.rated_power"]
    assert check.verdict == verdict
