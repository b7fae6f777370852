"""The beam against closed forms of elementary beam theory (Gere & Goodno, Mechanics of Materials, appendix of
deflections)."""

import math

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from calc.countershaft.bending.beam import SAME, beam, bend, natural_frequency, sprung

L, EI, MU, Q, P = 0.8, 12_000.0, 7.0, 900.0, 350.0
STIFF = np.inf  # Bernoulli's beam: no shear
REL = 1e-9


def uniform(ends=(0.0, L), pins=(0.0, L), load=0.0, shear=STIFF, **more):
    n = len(ends) - 1
    return beam(ends, [EI] * n, [shear] * n, [MU] * n, load if np.ndim(load) else [load] * n, pins, **more)


def at(bent, z, of="w"):
    """The deflection at a node."""
    (i,) = np.flatnonzero(np.abs(bent.z - z) < 1e-9)
    return getattr(bent, of)[i]


# --- statics
def test_uniform_load_between_two_pins():
    bent = bend(uniform(load=Q))
    assert at(bent, L / 2) == pytest.approx(5 * Q * L**4 / (384 * EI), rel=REL)
    assert bent.slopes == pytest.approx(np.array([1, -1]) * Q * L**3 / (24 * EI), rel=REL)
    assert bent.reactions == pytest.approx([-Q * L / 2] * 2, rel=REL)
    assert abs(bent.moment).max() == pytest.approx(Q * L**2 / 8, rel=REL)


def test_shear_adds_its_own_deflection_and_no_rotation():
    S = 50_000.0
    bent = bend(uniform(load=Q, shear=S))
    assert at(bent, L / 2) == pytest.approx(5 * Q * L**4 / (384 * EI) + Q * L**2 / (8 * S), rel=REL)
    assert bent.slopes[0] == pytest.approx(Q * L**3 / (24 * EI), rel=REL)
    middle = bend(uniform(shear=S, forces=([L / 2], [P])))
    assert at(middle, L / 2) == pytest.approx(P * L**3 / (48 * EI) + P * L / (4 * S), rel=REL)


@pytest.mark.parametrize("longest", [10.0, 0.1, 0.01])
def test_statics_do_not_depend_on_the_elements(longest):
    """Exact at the nodes, one element or eighty."""
    S, a = 60_000.0, 0.3
    b = L - a
    bent = bend(uniform(shear=S, forces=([a], [P]), longest=longest))
    assert at(bent, a) == pytest.approx(P * a**2 * b**2 / (3 * EI * L) + P * a * b / (L * S), rel=1e-8)
    assert bent.slopes[0] == pytest.approx(P * b * (L**2 - b**2) / (6 * L * EI), rel=1e-8)
    assert bent.moment_at(a) == pytest.approx(P * a * b / L, rel=1e-8)


def test_a_linear_load():
    """From 0 to Q: slopes 7·q·L³/360 and 8·q·L³/360 over E·I, largest moment q·L²/(9·√3)."""
    bent = bend(uniform(load=[[0.0, Q]]))
    assert bent.slopes == pytest.approx([7 * Q * L**3 / (360 * EI), -8 * Q * L**3 / (360 * EI)], rel=REL)
    # given at points 1 mm apart
    assert abs(bent.moment).max() == pytest.approx(Q * L**2 / (9 * math.sqrt(3)), rel=1e-5)
    assert bent.reactions == pytest.approx([-Q * L / 6, -Q * L / 3], rel=REL)


def test_a_load_beyond_the_pins():
    """A force at the end of an overhang a: P·a²·(L + a)/(3·E·I) below it, the slope at the far pin −P·a·L/(6·E·I)."""
    a = 0.25
    bent = bend(uniform(ends=(0, L, L + a), forces=([L + a], [P])))
    assert at(bent, L + a) == pytest.approx(P * a**2 * (L + a) / (3 * EI), rel=REL)
    assert bent.slopes == pytest.approx([-P * a * L / (6 * EI), P * a * L / (3 * EI)], rel=REL)
    assert bent.moment_at(L) == pytest.approx(-P * a, rel=REL)
    assert bent.reactions == pytest.approx([P * a / L, -P * (L + a) / L], rel=REL)


def test_a_cantilever_by_two_close_pins():
    """Held by two pins a short way apart, an overhang bends like one that is built in."""
    a, short = L, 1e-3
    bent = bend(uniform(ends=(-short, 0, a), pins=(-short, 0), forces=([a], [P])))
    assert at(bent, a) == pytest.approx(P * a**3 / (3 * EI), rel=2e-3)  # the turning of the short span adds short/a


def test_an_antisymmetric_uniform_load():
    """Slopes q·(L/2)³/(24·E·I) at the ends: each half is a beam on two supports."""
    bent = bend(uniform(ends=(0, L / 2, L), load=[Q, -Q]))
    assert abs(bent.slopes) == pytest.approx([Q * (L / 2) ** 3 / (24 * EI)] * 2, rel=REL)
    assert abs(at(bent, L / 2)) < 1e-12


def test_a_stepped_beam_by_hand():
    """Half of E·I on the rear half, a force in the middle: by the moment areas, θ_front = P·L²/(16·E·I)·(1 + 1/3·(2 −
    1)).

    M = P·z/2 up to the middle.  θ_f·L = ∫M·(L − z)/(E·I) dz = P/(2·E·I)·[(L/2)²·L/2 − (L/2)³/3 + 2·(L/2)³/3] =
    P·L³/(12·E·I)."""
    bent = bend(beam([0, L / 2, L], [EI, EI / 2], [STIFF] * 2, [MU] * 2, [0, 0], [0, L], forces=([L / 2], [P])))
    assert bent.slopes[0] == pytest.approx(P * L**2 / (12 * EI), rel=REL)


def test_the_two_planes_do_not_mix():
    one, other = bend(uniform(load=Q)), bend(uniform(load=1j * Q))
    assert other.w == pytest.approx(1j * one.w, rel=REL)
    both = bend(uniform(load=Q * (3 + 4j)))
    assert both.moment == pytest.approx((3 + 4j) * one.moment, abs=1e-8 * abs(both.moment).max())


def test_three_pins_and_a_uniform_load():
    """Two equal spans: 3/8, 10/8 and 3/8 of a span's load, −q·l²/8 over the middle."""
    bent = bend(uniform(pins=(0, L / 2, L), load=Q))
    assert -bent.reactions / (Q * L / 2) == pytest.approx([3 / 8, 10 / 8, 3 / 8], rel=1e-8)
    assert bent.moment_at(L / 2) == pytest.approx(-Q * (L / 2) ** 2 / 8, rel=1e-8)


lengths = st.floats(0.02, 0.5)


@settings(max_examples=40, deadline=None)
@given(
    pieces=st.lists(
        st.tuples(lengths, st.floats(100, 1e6), st.floats(1e4, 1e9), st.floats(-5e4, 5e4)), min_size=1, max_size=6
    ),
    place=st.floats(0, 1),
    force=st.floats(-5000, 5000),
    first=st.floats(0, 0.4),
    second=st.floats(0.6, 1),
)
def test_any_beam_is_in_equilibrium(pieces, place, force, first, second):
    ends = np.cumsum([0, *(p[0] for p in pieces)])
    whole, (l, stiffness, shear, q) = ends[-1], (np.array(x) for x in zip(*pieces))
    pins = np.array([first, second]) * whole
    bent = bend(beam(ends, stiffness, shear, np.ones(l.size), q, pins, forces=([place * whole], [force]), longest=0.05))
    middles = (ends[1:] + ends[:-1]) / 2
    # an end that lies so close to a pin becomes one with it
    near = 1e-5 * (np.sum(abs(q) * l) + abs(force) + 1) + SAME * np.max(abs(q))
    assert abs(np.sum(bent.reactions) + np.sum(q * l) + force) < near
    assert abs(np.sum(bent.reactions * pins) + np.sum(q * l * middles) + force * place * whole) < near * whole


# --- vibration
def test_frequency_of_a_pinned_beam():
    assert natural_frequency(uniform()) == pytest.approx((math.pi / L) ** 2 * math.sqrt(EI / MU), rel=1e-6)


def test_frequency_with_shear():
    """ω² = E·I·k⁴/(μ·(1 + E·I·k²/(κ·G·A))), k = π/L, without rotary inertia: put w = sin kz into Timoshenko's
    equations."""
    S, k = 2e6, math.pi / L
    exact = math.sqrt(EI * k**4 / (MU * (1 + EI * k**2 / S)))
    assert natural_frequency(uniform(shear=S, longest=2e-3)) == pytest.approx(exact, rel=1e-6)
    assert natural_frequency(uniform(shear=S)) == pytest.approx(exact, rel=2e-5)


def test_frequency_with_rotary_inertia():
    """Rayleigh's beam: ω² = E·I·k⁴/(μ + j·k²), j = ρ·I."""
    j, k = 0.02, math.pi / L
    exact = math.sqrt(EI * k**4 / (MU + j * k**2))
    assert natural_frequency(uniform(rotary=[j])) == pytest.approx(exact, rel=1e-6)


def test_frequency_with_shear_and_rotary_inertia():
    """Timoshenko's beam on two pins: μ·j/S·ω⁴ − ω²·(μ + (j + μ·E·I/S)·k²) + E·I·k⁴ = 0, the lower root, k = π/L."""
    S, j, k = 2e6, 0.02, math.pi / L
    half = MU + (j + MU * EI / S) * k**2
    exact = math.sqrt((half - math.sqrt(half**2 - 4 * MU * j / S * EI * k**4)) / (2 * MU * j / S))
    assert natural_frequency(uniform(shear=S, rotary=[j], longest=2e-3)) == pytest.approx(exact, rel=1e-6)


def test_rotary_inertia_does_not_bend_a_turning_beam():
    with_, without = (bend(uniform(rotary=rotary), 100.0) for rotary in ([0.02], None))
    assert np.array_equal(with_.w, without.w)


def test_on_stiff_springs_it_swings_as_on_pins():
    on_pins = natural_frequency(uniform())
    softer = [natural_frequency(sprung(uniform(), np.full(2, K))) for K in (1e6, 1e8, 1e12)]
    assert softer == sorted(softer) and softer[-1] == pytest.approx(on_pins, rel=1e-6)
    # a stiff support gives way by a part that falls with its stiffness: 1/ω² = 1/ω_pins² + …/K
    lost = [
        1 / f**2 - 1 / on_pins**2 for f in (natural_frequency(sprung(uniform(), np.full(2, K))) for K in (1e8, 2e8))
    ]
    assert lost[0] == pytest.approx(2 * lost[1], rel=2e-2)


def test_a_stiff_beam_bounces_and_tilts_on_its_springs():
    """ω² = 2·K/m, and tilting ω² = 6·K/m, both at its ends; on unequal springs the lower of the two roots."""
    K, m = 1e4, MU * L
    assert natural_frequency(sprung(uniform(), np.full(2, K))) == pytest.approx(math.sqrt(2 * K / m), rel=2e-2)
    stiff = beam([0, L], [EI * 1e4], [STIFF], [MU], [0], [0, L], longest=L / 4)
    assert natural_frequency(sprung(stiff, np.full(2, K))) == pytest.approx(math.sqrt(2 * K / m), rel=1e-6)
    a, b = K, 3 * K  # of w at both ends: M = m/6·[[2, 1], [1, 2]]
    roots = np.linalg.eigvals(np.linalg.solve(m / 6 * np.array([[2, 1], [1, 2]]), np.diag([a, b])))
    assert natural_frequency(sprung(stiff, np.array([a, b]))) == pytest.approx(math.sqrt(roots.min()), rel=1e-6)


def test_frequency_of_an_overhang():
    """Held by two close pins: (1.8751/a)²·√(E·I/μ) of a built-in beam."""
    f = natural_frequency(uniform(ends=(-1e-3, 0, L), pins=(-1e-3, 0)))
    assert f == pytest.approx((1.8751 / L) ** 2 * math.sqrt(EI / MU), rel=3e-3)


def test_frequency_of_a_mass_on_a_light_beam():
    m = 5.0
    light = beam([0, L], [EI], [STIFF], [1e-9], [0], [0, L], masses=([L / 2], [m]))
    assert natural_frequency(light) == pytest.approx(math.sqrt(48 * EI / L**3 / m), rel=1e-6)


def test_a_hole_raises_the_frequency_and_a_mass_lowers_it():
    """Rayleigh: a small mass at the middle changes ω by −m/(μ·L)."""
    m = 1e-4 * MU * L
    plain, hole, more = (natural_frequency(uniform(masses=([L / 2], [x]))) for x in (0.0, -m, m))
    assert hole / plain - 1 == pytest.approx(m / (MU * L), rel=1e-3)
    assert more / plain - 1 == pytest.approx(-m / (MU * L), rel=1e-3)


def test_a_beam_without_mass_does_not_swing():
    assert natural_frequency(beam([0, L], [EI], [STIFF], [0], [0], [0, L])) == math.inf


@settings(max_examples=30, deadline=None)
@given(
    pieces=st.lists(
        st.tuples(lengths, st.floats(10, 1e6), st.floats(1e5, 1e9), st.floats(0.1, 100)), min_size=1, max_size=5
    ),
    first=st.floats(0, 0.45),
    second=st.floats(0.55, 1),
    mass=st.floats(0, 50),
)
@example(pieces=[(0.02, 937919.5, 1e5, 1.0)], first=0.0, second=0.5546875, mass=0.875)  # whose higher shapes are dust
def test_the_frequency_is_that_of_the_full_eigenvalue_problem(pieces, first, second, mass):
    ends = np.cumsum([0, *(p[0] for p in pieces)])
    _, stiffness, shear, mu = (np.array(x) for x in zip(*pieces))
    model = beam(
        ends,
        stiffness,
        shear,
        mu,
        0 * mu,
        np.array([first, second]) * ends[-1],
        masses=([ends[-1]], [mass]),
        longest=0.05,
    )
    free = np.ix_(model.free, model.free)
    C = np.linalg.inv(np.linalg.cholesky(model.K[free]))
    exact = 1 / math.sqrt(np.linalg.eigvalsh(C @ model.M[free] @ C.T)[-1])
    assert natural_frequency(model) == pytest.approx(exact, rel=1e-6)


# --- turning
def test_turning_raises_the_deflection_like_a_single_mass():
    """A load in the shape of the first mode: 1/(1 − (ω/ω_1)²) times the deflection at rest."""
    n = 80
    ends = np.linspace(0, L, n + 1)
    load = np.stack([np.sin(math.pi * ends[:-1] / L), np.sin(math.pi * ends[1:] / L)], 1) * Q
    model = uniform(ends=ends, load=load)
    omega = 0.6 * natural_frequency(model)
    still, turning = bend(model), bend(model, omega)
    assert abs(turning.w).max() / abs(still.w).max() == pytest.approx(1 / (1 - 0.6**2), rel=1e-6)
    assert turning.reactions == pytest.approx(still.reactions / (1 - 0.6**2), rel=1e-4)
    assert abs(turning.moment).max() == pytest.approx(abs(still.moment).max() / (1 - 0.6**2), rel=1e-4)


def test_the_shear_force_is_the_slope_of_the_moment():
    a = 0.3
    bent = bend(uniform(load=[[0.0, Q]], forces=([a], [P])))
    added = (bent.shear[::2] + bent.shear[1::2]) / 2 * np.diff(bent.shear_z)[::2]
    ends = np.interp(bent.shear_z[1::2], bent.moment_z, bent.moment.real)
    assert np.cumsum(added).real == pytest.approx(ends, abs=0.02 * ends.max())
    assert bent.shear[0] == pytest.approx(-bent.reactions[0], rel=REL)
    before, after = bent.shear[np.flatnonzero(np.abs(bent.shear_z - a) < 1e-9)]
    assert before - after == pytest.approx(P, rel=REL)
