"""The shaft seen from its supports: against closed forms, the beam itself, and reference values of another program."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from calc import countershaft
from calc.countershaft.bending import formulas as f
from calc.countershaft.bending.beam import beam, bend, displaced, sprung
from calc.countershaft.bending.condensed import of_beam
from calc.countershaft.formulas import lever_gear
from calc.countershaft.inputs import EccentricMass
from calc.countershaft.outline import Piece, outline
from calc.library.catalogue import Material
from calc.sheet.errors import NoSolution
from tests.calc.countershaft.bending import cases

L, EI, MU, Q = 0.8, 12_000.0, 7.0, 900.0
STEEL = Material(name="steel", E=206e9, poisson=0.3, density=7860.0, expansion=11e-6)


def uniform(pins, ends=(0.0, L), shear=math.inf, load=Q, **more):
    n = len(ends) - 1
    return beam(ends, [EI] * n, [shear] * n, [MU] * n, [load] * n, pins, **more)


# --- what turns
def test_a_uniform_load_on_three_supports():
    """3/8, 10/8 and 3/8 of the load of a span (Gere & Goodno, Mechanics of Materials)."""
    shaft = of_beam(uniform((0, L / 2, L)), 0.0)
    assert shaft.f_c / (Q * L / 2) == pytest.approx([3 / 8, 10 / 8, 3 / 8], rel=1e-6)


def test_the_airy_points():
    """On supports at (1 − 1/√3)/2 of its length from its ends, the ends of a bar under its weight stay upright."""

    def end_slope(a):
        return of_beam(uniform((a * L, (1 - a) * L), longest=1.0), 0.0).u[1].real

    low, high = 0.15, 0.3
    assert end_slope(low) * end_slope(high) < 0
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (middle, high) if end_slope(low) * end_slope(middle) > 0 else (low, middle)
    assert low == pytest.approx((1 - 1 / math.sqrt(3)) / 2, abs=1e-8)


def test_the_least_sag():
    """Supports at 0.2232 of the length from the ends bring middle and ends to one height."""

    def sag(a):
        line = of_beam(uniform((a * L, (1 - a) * L)), 0.0).deflection(np.zeros(2)).real
        return line.max() - line.min()

    places = np.linspace(0.222, 0.2245, 126)
    assert places[np.argmin([sag(a) for a in places])] == pytest.approx(0.2232, abs=1e-4)


def test_it_goes_on_as_the_beam_does():
    omega = 900.0
    model = uniform((0, 0.3, L), ends=(0, 0.4, L), shear=1e8, forces=([0.6], [500j]))
    shaft, bent = of_beam(model, omega), bend(model, omega)
    assert shaft.f_c == pytest.approx(-bent.reactions, rel=1e-9)
    assert shaft.theta_0 == pytest.approx(bent.slopes, rel=1e-9)
    assert bend(model, omega, shaft.u).moment == pytest.approx(bent.moment, rel=1e-6, abs=1e-9 * abs(bent.moment).max())


def test_on_springs_it_stands_as_the_whole_beam_does():
    """Against the beam on springs, which knows nothing of the condensed one."""
    k, omega = np.array([2e7, 5e7, 3e7]), 900.0
    model = uniform((0.1, 0.3, L), ends=(0, 0.4, L), shear=1e8, forces=([0.6], [500 - 300j]))
    whole = displaced(sprung(model, k), omega)
    shaft = of_beam(model, omega)
    x = np.linalg.solve(shaft.K_c + np.diag(k), shaft.f_c)
    assert x == pytest.approx(whole[model.pinned], rel=1e-8)
    assert shaft.theta_0 + shaft.Theta @ x == pytest.approx(whole[model.pinned + 1], rel=1e-8)
    assert shaft.deflection(x) == pytest.approx(whole[::2], rel=1e-7, abs=1e-12)


lengths = st.floats(0.1, 0.4)
beams = st.lists(
    st.tuples(
        lengths, st.floats(1e2, 1e6), st.floats(1e6, 1e9), st.floats(0.5, 50), st.complex_numbers(max_magnitude=5e4)
    ),
    min_size=1,
    max_size=5,
)
places = st.lists(st.integers(0, 10), min_size=2, max_size=5, unique=True).map(sorted)


def drawn(pieces, pins):
    l, EI, S, mu, q = (np.array(column) for column in zip(*pieces))
    ends = np.append(0.0, np.cumsum(l))
    return beam(ends, EI, S, mu, q, np.array(pins) / 10 * ends[-1], longest=0.05)


@settings(max_examples=50, deadline=None)
@given(pieces=beams, pins=places, omega=st.floats(0, 500), seed=st.integers(0, 999))
def test_forces_and_inertia_are_in_equilibrium(pieces, pins, omega, seed):
    """The supports hold the load and the inertia ω²·∫w dm of the whole bent line, wherever the journals are."""
    model = drawn(pieces, pins)
    shaft = of_beam(model, omega)
    x = np.random.default_rng(seed).normal(size=(len(pins), 2)) @ [1e-4, 1e-4j]
    u = shaft.u + shaft.moved @ x
    up, about = np.tile([1.0, 0.0], model.z.size), np.stack([model.z, np.ones(model.z.size)], 1).ravel()
    r = shaft.K_c @ x - shaft.f_c
    for move, arm in ((up, np.ones(len(pins))), (about, shaft.z)):  # virtual work of a rigid move
        loads = move @ model.f, omega**2 * move @ model.M @ u, r @ arm
        terms = abs(move) @ abs(model.f) + omega**2 * abs(move) @ abs(model.M) @ abs(u)
        assert abs(sum(loads)) <= 1e-6 * terms + 1e-11 * abs(model.K).max() * abs(x).max() * arm.max()


@settings(max_examples=50, deadline=None)
@given(pieces=beams, pins=places, omega=st.floats(0, 500))
def test_stiffness_is_mutual_and_a_rigid_move_asks_for_inertia_alone(pieces, pins, omega):
    model = drawn(pieces, pins)
    shaft, still = of_beam(model, omega), of_beam(model, 0.0)
    dust = 1e-11 * abs(model.K).max()
    assert abs(shaft.K_c - shaft.K_c.T).max() <= dust  # Maxwell and Betti
    assert abs(still.K_c.sum(1)).max() <= dust
    assert abs(still.K_c @ still.z).max() <= dust * max(abs(still.z))


def test_a_support_beyond_the_shaft_is_refused():
    with pytest.raises(NoSolution, match="beyond the shaft"):
        countershaft.condensed([Piece(0, 0.1, 0.01, 0, None, 0, "full")], (0.02, 0.2), 100.0, STEEL)


# --- what stands
@pytest.mark.parametrize("name", cases.STANDING)
def test_what_stands_agrees_with_another_program(name):
    case = cases.STANDING[name]
    (force,) = case.get("forces", [None])
    shaft = cases.still(case, None if force is None else force[0] / 1e3)
    on = countershaft.standing_on(shaft, np.array(case["k_N_um"]) * 1e6)
    load = on.weight + on.offset(np.array([complex(*g) for g in case["bores_um"]]) * 1e-6)
    if force is not None:
        load = load + on.force * complex(*force[1:])
    found = {f"standing.{row}": F for row, F in zip(case["names"], abs(load))}
    found |= {f"alignment_load.{row}": F for row, F in zip(case["names"], on.alignment(20e-6))}
    cases.compared(name, found)


ROW = cases.STANDING["bore-up-20"]


@pytest.mark.parametrize("z", [-0.2, -0.122, -0.05, 0.0, 0.11, 0.15])  # beyond both ends as well
def test_two_supports_know_nothing_of_their_stiffness(z):
    """Weight by the levers, a wheel by today's bound, which the columns give where the wheel is not between them."""
    case = ROW | {"supports_mm": [-112, 100]}
    on = countershaft.standing_on(cases.still(case, z), np.array([3e7, 8e7]))
    z_f, z_r = cases.supports(case)
    weight = 9.80665 * 7860 * math.pi * 0.012**2 * 0.245
    assert -on.weight == pytest.approx(weight * np.array([z_r, -z_f]) / (z_r - z_f), rel=1e-9)
    assert on.force == pytest.approx([(z_r - z) / (z_r - z_f), (z - z_f) / (z_r - z_f)], rel=1e-7, abs=1e-9)
    assert on.couple == pytest.approx(np.array([-1, 1]) / (z_r - z_f), rel=1e-7)
    forces = {"F_t": 300.0, "F_r": 110.0, "F_a": 90.0, "d": 0.05}
    bound = f.wheel_load(G_F=abs(on.force), G_C=abs(on.couple), **forces)
    ends = ((z_f, z_r), (z_r, z_f))
    assert np.all(bound >= [lever_gear(**forces, z_G=z, z_o=other, z_B=own) - 1e-6 for own, other in ends])
    assert on.offset(np.array([20e-6, -10e-6j])) == pytest.approx([0, 0], abs=1e-6)  # a bar on two bores is not bent


@pytest.mark.parametrize("k", [(3e7, 8e7, 3e7), (math.inf, 8e7, 3e7), (3e7, 0.0, 4e7), (math.inf, math.inf, math.inf)])
def test_springs_rigid_supports_and_those_that_do_not_touch(k):
    """Against the equation with very stiff and very soft springs: K₀·x + k·(x − g) = f."""
    case = cases.STANDING["sectors-mean-plane"]
    shaft, k = cases.still(case), np.array(k)
    g = np.array([10e-6, 15e-6j, -5e-6])
    springs = np.clip(k, 1e-3, 1e15)
    x = np.linalg.solve(shaft.K_0 + np.diag(springs), shaft.weight + springs * g)
    on = countershaft.standing_on(shaft, k)
    assert on.weight + on.offset(g) == pytest.approx(shaft.weight - shaft.K_0 @ x, rel=1e-6, abs=1e-4)


@settings(max_examples=50, deadline=None)
@given(
    k=st.lists(st.floats(1e6, 1e10), min_size=3, max_size=3), lift=st.floats(-1e-4, 1e-4), tilt=st.floats(-1e-3, 1e-3)
)
def test_a_rigid_move_of_all_bores_gives_nothing(k, lift, tilt):
    shaft = cases.still(cases.STANDING["sectors-mean-plane"])
    on = countershaft.standing_on(shaft, np.array(k))
    assert abs(on.offset(lift + tilt * shaft.z)).max() <= 1e-6 * abs(shaft.K_0).max() * 1e-4
    assert abs(on.yields - on.yields.T).max() <= 1e-6 * abs(on.yields).max()
    weight = 9.80665 * weighed(cases.STANDING["sectors-mean-plane"])
    assert on.weight.sum() == pytest.approx(-weight, rel=1e-9)


def weighed(case):
    shape = outline(cases.pieces(case), derived=False)
    return case["rho"] * sum(A * piece.length for A, piece in zip(shape.area, shape.pieces))


def test_the_most_of_a_tolerance_is_the_worst_of_its_corners():
    on = countershaft.standing_on(cases.still(ROW), np.array([3e7, 8e7, 3e7]))
    corners = np.array(np.meshgrid(*[[-1, 1]] * 3)).reshape(3, -1) * 10e-6
    assert on.alignment(20e-6) == pytest.approx(abs(on.yields @ corners).max(1), rel=1e-12)


def test_further_masses_weigh():
    case = ROW | {"points": [[30, 0.5, 12, 40]]}
    more = countershaft.standing_on(cases.still(case), np.full(3, 5e7))
    bare = countershaft.standing_on(cases.still(ROW, 0.03), np.full(3, 5e7))
    assert more.weight - bare.weight == pytest.approx(-0.5 * 9.80665 * bare.force, rel=1e-7)


def test_a_shaft_that_fewer_than_two_supports_touch_is_not_held():
    with pytest.raises(NoSolution, match="fewer than two touch"):
        countershaft.standing_on(cases.still(ROW), np.array([0.0, 8e7, 0.0]))


def test_a_hole_of_no_mass_and_a_point_at_a_support_change_nothing():
    case = cases.SHARE["r754-pins"]
    nothing = EccentricMass(name="nothing", mass=0.0, radius=0.01, angle=0.0, z=0.0)
    arguments = cases.pieces(case), cases.supports(case), 600.0, STEEL
    assert countershaft.condensed(*arguments, (nothing,)).f_c == pytest.approx(
        countershaft.condensed(*arguments).f_c, abs=1e-9
    )
