# SPDX-License-Identifier: Apache-2.0
"""What mechanics says of any slider-crank and its torque, whatever its numbers; the list of all such laws is
docs/laws.md."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc.engine import cycle as c
from calc.engine import formulas as f
from calc.engine import throw_strength as throw_formulas
from calc.engine import torque
from calc.engine.crank import firing
from calc.engine.gas import GasInputs
from calc.engine.inputs import EngineInputs
from calc.engine.solve import values
from calc.engine.torque import prepare
from tests.calc.imbalance.engines import R753

TURN = 2 * math.pi
lambdas, offsets = st.floats(0.02, 0.45), st.floats(-0.3, 0.3)  # the offset over the rod's length less the crank's


@st.composite
def engines(draw, **fixed):
    """Any crank train with any offset and masses, four or two strokes, firing evenly in its usual order."""
    r, lam = draw(st.floats(0.01, 0.2)), draw(lambdas)
    L = r / lam
    said = dict(
        crank_radius=r,
        rod_length=L,
        cylinder_offset=draw(offsets) * (L - r),
        piston_mass=draw(st.floats(0.05, 20)),
        rod_mass=draw(st.floats(0, 20)),
        rod_cg_to_big_end=draw(st.floats(0, 1)) * L,
        rated_speed=draw(st.floats(5, 150)),
        cylinders=draw(st.integers(1, 8)),
        strokes=draw(st.sampled_from([2, 4])),
        bore=draw(st.floats(0.02, 0.3)),
        firing_order=None,
    )
    engine = EngineInputs(**{**R753, **said, **fixed})
    assert list(engine.problems()) == []
    return engine


gases = st.builds(
    GasInputs,
    peak_pressure=st.floats(60e5, 250e5),
    compression_ratio=st.floats(6, 20),
    intake_pressure=st.floats(0.4e5, 2e5),
    exhaust_pressure=st.floats(0.8e5, 3e5),
    crankcase_pressure=st.floats(0.5e5, 1.5e5),
    compression_exponent=st.floats(1.2, 1.4),
    expansion_exponent=st.floats(1.15, 1.4),
    constant_pressure_angle=st.floats(0.0, 0.6),
)


def motion(engine, e, alpha):
    """Way, speed over ω·r and acceleration over ω²·r of the piston, and the rod's angle, at angles of the crank from
    the cylinder's axis."""
    beta = f.rod_angle(lam=e.lambda_, alpha=alpha, delta=e.delta)
    x = c.piston_way(r=engine.crank_radius, lam=e.lambda_, phi_0=e.tdc_angle, alpha=alpha, beta=beta)
    return (
        x,
        f.relative_speed(alpha=alpha, beta=beta),
        f.relative_acceleration(alpha=alpha, beta=beta, lam=e.lambda_),
        beta,
    )


@settings(max_examples=60, deadline=None)
@given(engine=engines())
def test_speed_and_acceleration_are_the_slopes_of_the_way(engine):
    """dx/dα = r·v_rel and dv_rel/dα = a_rel, by the Fourier series of each over the turn; and no piston leaves its
    stroke."""
    e = values(engine)
    size = 4096
    x, v, a, _ = motion(engine, e, np.arange(size) * TURN / size)
    n = np.fft.rfftfreq(size, 1 / size)
    slope, bend = (np.fft.irfft(1j * n * np.fft.rfft(y), size) for y in (x / engine.crank_radius, v))
    assert np.abs(slope - v).max() < 1e-7 and np.abs(bend - a).max() < 1e-7 * np.abs(a).max()
    assert x.min() > -1e-12 * e.stroke and x.max() < e.stroke * (1 + 1e-12)
    assert x.max() > e.stroke * (1 - 1e-5)  # it comes to BDC


@settings(max_examples=60, deadline=None)
@given(lam=st.floats(0.005, 0.4))
def test_a_long_rod_moves_as_two_terms(lam):
    """What cos α + λ·cos 2α leaves out goes with λ³: its largest amount is between 0.4·λ³ and λ³/(1 − λ²)^1.5 of
    ω²·r."""
    alpha = np.linspace(0, TURN, 721)
    exact = f.relative_acceleration(alpha=alpha, beta=f.rod_angle(lam=lam, alpha=alpha, delta=0.0), lam=lam)
    off = np.abs(exact - f.relative_acceleration_two_term(alpha=alpha, lam=lam, delta=0.0)).max()
    assert 0.4 * lam**3 < off < lam**3 / (1 - lam**2) ** 1.5


@settings(max_examples=60, deadline=None)
@given(engine=engines())
def test_the_orders_hold_the_mean_square(engine):
    """Parseval: the mean square of a over the turn is half the sum of the squared orders; orders above 8 hold less than
    λ_max⁸ of it."""
    e = values(engine)
    _, _, a, _ = motion(engine, e, np.arange(4096) * TURN / 4096)
    whole, orders = np.mean(a**2), sum(abs(c_n) ** 2 for c_n in e.harmonics) / 2
    widest = e.lambda_ + abs(e.delta)
    assert -1e-12 * whole < whole - orders < widest**8 * whole


@settings(max_examples=60, deadline=None)
@given(engine=engines(cylinders=1))
def test_inertia_torque_takes_from_the_kinetic_energy_what_it_gives_the_crank(engine):
    """∫T_I dε = ½·m·(v₀² − v²) between any two crank angles: nothing over a turn."""
    e = values(engine)
    epsilon = np.linspace(0, TURN, 4001)
    _, T, _ = torque.at(engine, e, None, np.zeros(1), epsilon[:, None])
    _, v_rel, _, _ = motion(engine, e, e.tdc_angle + epsilon)
    energy = e.reciprocating_mass * (v_rel * e.angular_speed * engine.crank_radius) ** 2 / 2
    assert np.abs(c.running(epsilon, T[:, 0]) + energy).max() < 1e-6 * energy.max()
    assert abs(T[:-1].mean()) < 1e-11 * np.abs(T).max()


@settings(max_examples=40, deadline=None)
@given(engine=engines(), masses=st.floats(0.1, 10), lengths=st.floats(0.1, 10), speeds=st.floats(0.1, 10))
def test_torque_goes_with_mass_length_and_speed_squared(engine, masses, lengths, speeds):
    """Similar engines: T ~ m·l²·ω²."""
    said = {name: getattr(engine, name) * masses for name in ("piston_mass", "rod_mass", "crankpin_bearing_mass")}
    said |= {
        name: getattr(engine, name) * lengths
        for name in ("crank_radius", "rod_length", "cylinder_offset", "rod_cg_to_big_end", "bore")
    }
    other = EngineInputs(**{**vars(engine), **said, "rated_speed": engine.rated_speed * speeds})
    (one, _, _), (large, _, _) = (
        torque.solve(x, e := values(x), firing(x, e.crank).angles, None, None) for x in (engine, other)
    )
    scale = masses * lengths**2 * speeds**2
    e = values(engine)
    dust = 1e-9 * scale * engine.cylinders * e.reciprocating_mass * (engine.crank_radius * e.angular_speed) ** 2
    assert abs(large.inertia_torque_peak - scale * one.inertia_torque_peak) < dust
    assert (
        abs(large.reaction_inertia_peak - scale * one.reaction_inertia_peak)
        < dust * engine.rod_length / engine.crank_radius
    )
    assert np.abs(np.array(large.harmonics) - scale * np.array(one.harmonics)).max() < dust


@settings(max_examples=40, deadline=None)
@given(engine=engines())
def test_even_firing_leaves_orders_of_the_firing_frequency(engine):
    """Of the inertia torque only orders that are multiples of 2·N/strokes are left, and these are N times those of one
    cylinder."""
    e = values(engine)
    N = engine.cylinders
    found, _, _ = torque.solve(engine, e, firing(engine, e.crank).angles, None, None)
    single = EngineInputs(**{**vars(engine), "cylinders": 1})
    alone, _, _ = torque.solve(single, values(single), np.zeros(1), None, None)
    size = N * np.abs(alone.harmonics).max()
    for n, (t, one) in enumerate(zip(found.harmonics, alone.harmonics), 1):
        expected = N * one if n * engine.strokes % (2 * N) == 0 else 0.0
        assert abs(t - expected) < 1e-9 * size, n


@settings(max_examples=60, deadline=None)
@given(engine=engines(cylinders=1), epsilon=st.floats(0, TURN))
def test_the_block_feels_the_side_thrust(engine, epsilon):
    """The reaction −T + d·F of one cylinder is the moment −F·tan β·(r·cos α + L·cos β) of its side thrust about the
    crank's axis."""
    e = values(engine)
    _, T, F = (None if x is None else float(x[0]) for x in torque.at(engine, e, None, np.zeros(1), np.array([epsilon])))
    alpha = e.tdc_angle + epsilon
    beta = f.rod_angle(lam=e.lambda_, alpha=alpha, delta=e.delta)
    height = engine.crank_radius * math.cos(alpha) + engine.rod_length * math.cos(beta)
    moment = -throw_formulas.side_thrust(F=F, beta=beta) * height
    size = e.reciprocating_mass * engine.crank_radius * e.angular_speed**2 * engine.rod_length
    # angles within 1e-9 of a dead centre are taken for it
    assert torque.reaction(T=T, d=engine.cylinder_offset, F_I=F) == pytest.approx(moment, abs=2e-9 * size)


@settings(max_examples=60, deadline=None)
@given(engine=engines(), F=st.floats(-1e5, 1e5), alpha=st.floats(0, TURN))
def test_the_rod_passes_the_pistons_force_to_the_pin(engine, F, alpha):
    """|rod force|² = F² + side thrust², and its power at the pin is that of the piston: F_t·r·ω = F·v."""
    e = values(engine)
    beta = f.rod_angle(lam=e.lambda_, alpha=alpha, delta=e.delta)
    S, N = throw_formulas.rod_force(F=F, beta=beta), throw_formulas.side_thrust(F=F, beta=beta)
    assert S**2 == pytest.approx(F**2 + N**2, rel=1e-12)
    F_t = throw_formulas.tangential_force(F=F, v_rel=f.relative_speed(alpha=alpha, beta=beta))
    F_r = throw_formulas.radial_force(
        S=S, alpha=alpha, beta=beta, M_rot=0.0, r=engine.crank_radius, omega=e.angular_speed
    )
    assert math.hypot(F_t, F_r) == pytest.approx(abs(S), rel=1e-9)


@settings(max_examples=30, deadline=None)
@given(engine=engines(), gas=gases)
def test_indicated_work_is_the_area_of_the_cycle(engine, gas):
    """W_i by the torque over the crank angle is ∮p dV in closed form; the crankcase's pressure adds nothing."""
    e = values(engine)
    cycle = prepare(engine, e, gas)
    found, _, _ = torque.solve(engine, e, firing(engine, e.crank).angles, gas, None)
    g, area = cycle.given, math.pi / 4 * engine.bore**2
    low, high, held = (area * (g.h_c + x) for x in (0.0, g.s, g.x_p))
    work = g.p_max * (held - low)
    work += g.p_max * held / (g.n_e - 1) * (1 - (held / high) ** (g.n_e - 1))
    work -= g.p_in * high / (g.n_c - 1) * ((high / low) ** (g.n_c - 1) - 1)
    if engine.strokes == 4:
        work += (g.p_in - g.p_ex) * (high - low)
    assert found.indicated_work == pytest.approx(work, abs=1e-6 * g.p_max * (high - low))


@settings(max_examples=20, deadline=None)
@given(engine=engines(), gas=gases, faster=st.floats(0.3, 3))
def test_inertia_adds_nothing_to_the_mean_torque(engine, gas, faster):
    """The mean of the whole torque over the cycle is N·W_i over the cycle's angle at any speed and with any masses."""
    e = values(engine)
    fires = firing(engine, e.crank).angles
    cycle = prepare(engine, e, gas)
    epsilon = c.points(cycle, fires)
    T_G, T_I, _ = torque.at(engine, e, cycle, fires, epsilon[:, None])
    mean_gas, mean_inertia = (c.running(epsilon, T.sum(-1))[-1] / cycle.length for T in (T_G, T_I))
    assert abs(mean_inertia) < 1e-7 * np.abs(T_I).sum(-1).max()
    heavy = EngineInputs(
        **{**vars(engine), "rated_speed": engine.rated_speed * faster, "piston_mass": engine.piston_mass * 2}
    )
    one, other = (torque.solve(x, values(x), fires, gas, None)[0] for x in (engine, heavy))
    assert one.mean_torque == pytest.approx(mean_gas, abs=1e-9 * np.abs(T_G).sum(-1).max())
    assert other.mean_torque == pytest.approx(one.mean_torque, abs=1e-12 * np.abs(T_G).sum(-1).max())
    assert other.indicated_power == pytest.approx(faster * one.indicated_power, rel=1e-9, abs=1e-9)
