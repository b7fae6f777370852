"""The mechanics by closed forms, published cases, limits, symmetries and time: nothing here is a number of our own."""

import math

import numpy as np
import pytest

from calc.mounting import body
from calc.mounting import modal as aids
from calc.mounting.body import real_at_rest
from calc.mounting.inputs import Chassis, Mount, MountingInputs, Support, tensor
from calc.mounting.modes import eigen, modes, roll_shares, stiffness_matrix
from calc.mounting.system import moves, respond, system, transmitted

SKEW = tensor((22.0, 24.0, 13.0), (0.25, -0.35, 1.60))


def mounting(
    places,
    stiffness,
    *,
    mass=310.0,
    inertia=(22.0, 24.0, 13.0),
    coupling=(0.0, 0.0, 0.0),
    eta=0.0,
    damping=None,
    turned=None,
    **more,
):
    mounts = tuple(
        Mount(
            name=f"mount-{n}",
            position=tuple(place),
            stiffness=tuple(k),
            dynamic_ratio=1.0,
            loss_factor=None if damping else eta,
            damping=damping,
            turned=turned[n] if turned else None,
        )
        for n, (place, k) in enumerate(zip(places, stiffness))
    )
    given = dict(centre_of_gravity=(0.0, 0.0, 0.0)) | more
    return MountingInputs(
        mass=mass, inertia=inertia, inertia_coupling=coupling, idle_speed=15.0, mounts=mounts, **given
    )


def four(h=0.18, **more):
    places = [(-h, y, z) for y in (-0.26, 0.26) for z in (-0.25, 0.25)]
    return mounting(places, [(260e3, 110e3, 90e3)] * 4, **more)


def solved(given):
    s = system(given, np.asarray(body.inertia(given)))
    k = np.array([real_at_rest(mount) for mount in given.mounts])
    K = np.asarray(stiffness_matrix(k=k, B=s.between[:, :, :6], R=s.axes))
    return s, K, modes(K, s.M[:6, :6])


def frequencies(found):
    return dict(zip(body.DOFS, (float(found.frequencies[i]) for i in found.of)))


def test_the_symmetric_four_in_closed_form():
    _, _, found = solved(four())
    f = frequencies(found)
    assert f["bounce"] == pytest.approx(aids.four_bounce(k_x=260e3, m=310.0), rel=1e-9)
    assert f["yaw"] == pytest.approx(aids.four_yaw(k_y=110e3, c=0.25, k_z=90e3, b=0.26, J_x=22.0), rel=1e-9)
    for pair, k, a, J in ((("lateral", "roll"), 110e3, 0.26, 13.0), (("fore_aft", "pitch"), 90e3, 0.25, 24.0)):
        closed = aids.four_coupled(k=k, k_x=260e3, h=0.18, a=a, m=310.0, J=J)
        assert sorted(f[dof] for dof in pair) == pytest.approx(sorted(closed), rel=1e-9)


def test_mounts_at_the_height_of_the_centre_of_gravity_decouple_all():
    _, _, found = solved(four(h=0.0))
    assert [found.energy[i, found.of[i]] for i in range(6)] == pytest.approx([1.0] * 6, abs=1e-12)


def test_two_mounts_that_lean_as_the_formula_says_decouple_roll_from_lateral():
    b, L, h = 0.26, 4.0, 0.12
    phi = aids.focal_angle(b=b, L=L, h=h)
    places = [(-h, side * b, z) for side in (-1, 1) for z in (-0.25, 0.25)]
    leaning = [(0.0, 0.0, -side * phi) for side in (-1, 1) for _ in range(2)]
    _, K, _ = solved(mounting(places, [(L * 65e3, 65e3, 65e3)] * 4, turned=leaning))
    assert abs(K[1, 5]) < 1e-12 * K[1, 1]
    assert aids.elastic_centre(b=b, L=L, phi=phi) == pytest.approx(h, rel=1e-12)


def test_energies_add_up_by_rows_and_columns():
    s, K, found = solved(four(coupling=(0.25, -0.35, 1.60)))
    assert found.energy.sum(0) == pytest.approx(np.ones(6), abs=1e-12)
    assert found.energy.sum(1) == pytest.approx(np.ones(6), abs=1e-12)
    assert float(np.sum(roll_shares(K=K, M=s.M))) == pytest.approx(1.0, abs=1e-12)


@pytest.mark.parametrize(("r", "published"), [(0.5, 1.3282), (1.0, 5.0990), (3.0, 0.14537)])
def test_one_degree_of_freedom(r, published):
    """Den Hartog, ch. 2: rotating unbalance and transmissibility at ζ = 0.1."""
    k, zeta, M = 260e3, 0.1, 310.0
    omega = math.sqrt(4 * k / M)
    s, _, _ = solved(four(h=0.0, damping=2 * zeta * M * omega / 4))
    f = np.zeros((1, 1, 6), dtype=complex)
    f[0, 0, 0] = 0.02 * (r * omega) ** 2  # m·e·Ω²
    found = respond(s, np.array([r * omega]), f)
    amplitude = 0.02 / M * r**2 / math.hypot(1 - r**2, 2 * zeta * r)
    assert abs(found.q[0, 0, 0]) == pytest.approx(amplitude, rel=1e-12)
    F_t, _ = transmitted(s, found)
    assert abs(F_t[0, 0, 0]) / f[0, 0, 0].real == pytest.approx(published, rel=5e-5)


CHASSIS = Chassis(
    mass=2750.0,
    centre_of_gravity=(-0.15, 0.0, 0.8),
    inertia=(2300.0, 2400.0, 900.0),
    inertia_coupling=(0.0, 0.0, 60.0),
    supports=tuple(
        Support(name=f"tyre-{n}", position=(-0.7, y, z), stiffness=(450e3, 250e3, 350e3), loss_factor=0.1)
        for n, (y, z) in enumerate(((-0.75, 1.35), (0.75, 1.35), (-0.75, 0.35), (0.75, 0.35)))
    ),
)


def test_reciprocity_and_power():
    s = system(four(coupling=(0.25, -0.35, 1.60), eta=0.12, chassis=CHASSIS), SKEW)
    Omega = 2 * math.pi * np.array([7.5, 15.0, 22.5, 65.0])
    H = np.asarray(respond(s, Omega, np.broadcast_to(np.eye(6, dtype=complex), (4, 6, 6))).q)[:, :, :6]
    assert H == pytest.approx(np.swapaxes(H, 1, 2), rel=1e-9, abs=1e-9 * np.abs(H).max())
    f = (np.arange(1, 7) * np.exp(1j * np.arange(6)))[None, None].repeat(4, 0)
    found = respond(s, Omega, f)
    q = np.asarray(found.q)[:, 0]
    given = 0.5 * (f[:, 0].conj() * (1j * Omega[:, None] * q[:, :6])).real.sum(-1)
    _, whole = s.mount_stiffness(Omega[:1])
    K = s.stiffness(whole, Omega[:1])[0]
    lost = 0.5 * Omega * np.einsum("fi,ij,fj->f", q.conj(), K.imag, q).real
    assert given == pytest.approx(lost, rel=1e-9)


def test_slow_and_fast_limits():
    s, K, _ = solved(four(coupling=(0.25, -0.35, 1.60)))
    f = np.arange(1, 7).astype(complex)[None, None]
    slow = np.asarray(respond(s, np.array([1e-4]), f).q)[0, 0]
    assert slow.real == pytest.approx(np.linalg.solve(K, np.arange(1, 7)), rel=1e-6)
    fast = np.asarray(respond(s, np.array([1e6]), f).q)[0, 0]
    assert -1e12 * fast.real == pytest.approx(np.linalg.solve(s.M, np.arange(1, 7)), rel=1e-5)


def test_a_heavy_chassis_is_rigid_ground():
    heavy = Chassis(
        mass=1e7,
        centre_of_gravity=(0.0, 0.0, 0.0),
        inertia=(1e8, 1e8, 1e8),
        supports=(Support(name="ground", position=(0.0, 0.0, 0.0), stiffness=(1e9, 1e9, 1e9)),),
    )
    f = np.arange(1, 7).astype(complex)[None, None]
    Omega = np.array([100.0])
    on_ground = np.asarray(respond(system(four(eta=0.1), SKEW), Omega, f).q)[0, 0]
    on_heavy = np.asarray(respond(system(four(eta=0.1, chassis=heavy), SKEW), Omega, f).q)[0, 0, :6]
    assert on_heavy == pytest.approx(on_ground, rel=1e-3)


def test_the_eigenproblem_gives_what_each_frequency_gives_by_itself():
    from calc.mounting.system import respond_at

    s = system(four(eta=0.12, chassis=CHASSIS), SKEW)
    Omega = np.linspace(50.0, 900.0, 7)
    f = np.broadcast_to(np.arange(1, 7).astype(complex), (7, 1, 6))
    assert np.asarray(respond(s, Omega, f).q) == pytest.approx(respond_at(s, Omega, f), rel=1e-9)


def test_time_integration_comes_back_to_the_phasor():
    """Viscous mounts: one period from the state of the phasor ends in it, and passes it on the way."""
    given = four(coupling=(0.25, -0.35, 1.60), damping=300.0)
    s, K, _ = solved(given)
    Omega = 2 * math.pi * 15.0
    f = (np.arange(1, 7) * np.exp(0.3j * np.arange(6))).astype(complex)
    q = np.asarray(respond(s, np.array([Omega]), f[None, None]).q)[0, 0]
    C = np.einsum("jai,jab->ib", s.between, s.between) * 300.0
    inverse = np.linalg.inv(s.M)

    def slope(t, y):
        force = (f * np.exp(1j * Omega * t)).real - K @ y[:6] - C @ y[6:]
        return np.concatenate([y[6:], inverse @ force])

    steps = 2000
    dt, y = 2 * math.pi / Omega / steps, np.concatenate([q.real, (1j * Omega * q).real])
    for n in range(steps):
        t = n * dt
        a = slope(t, y)
        b = slope(t + dt / 2, y + dt / 2 * a)
        c = slope(t + dt / 2, y + dt / 2 * b)
        y = y + dt / 6 * (a + 2 * b + 2 * c + slope(t + dt, y + dt * c))
        if n + 1 == steps // 3:
            now = (q * np.exp(1j * Omega * (t + dt))).real
            assert y[:6] == pytest.approx(now, abs=1e-6 * np.abs(q).max())
    assert y[:6] == pytest.approx(q.real, abs=1e-6 * np.abs(q).max())


# --- published cases
def of_two(K, M):
    return np.sqrt(eigen(np.array(K), np.array(M))[0])


@pytest.mark.parametrize(
    ("K", "M", "printed", "digits"),
    [
        # Edwards & Penney, Differential Equations, 7.4-24: a car on two axles
        ([[4000.0, -4000.0], [-4000.0, 104000.0]], [[100.0, 0], [0, 1000.0]], (6.13, 10.31), 0.006),
        # Barton & Fieldhouse, Automotive Chassis Engineering, (3.83): body on wheel on tyre; the book rounds its
        # polynomial
        ([[22e3, -22e3], [-22e3, 214e3]], [[317.5, 0], [0, 45.4]], (7.87, 68.73), 0.03),
        # Rao, Mechanical Vibrations: automobile (from memory)
        ([[40e3, 15e3], [15e3, 67.5e3]], [[1000.0, 0], [0, 810.0]], (5.8593, 9.4341), 6e-5),
        # Thomson, Theory of Vibration: automobile, lb and ft (from memory)
        ([[5000.0, 3500.0], [3500.0, 127250.0]], [[100.0, 0], [0, 1600.0]], (6.90, 9.06), 0.02),
    ],
)
def test_two_degrees_of_freedom(K, M, printed, digits):
    assert of_two(K, M) == pytest.approx(printed, abs=digits)


def test_an_engine_on_three_turned_mounts():
    """SAIPA EF7, of the public files of NVHteam (hojjatkarami, SavedResults/file1_res.mat): full tensor, mounts turned
    about z and y."""
    places = ((-0.066452, 0.463088, 0.156098), (-0.003592, -0.456004, 0.100914), (0.250718, -0.044719, -0.200540))
    k = ((349.5e3, 370.5e3, 553e3), (141e3, 57e3, 367.5e3), (640.5e3, 450e3, 225e3))
    turned = ((0.0, 0.0, math.pi / 2), (0.0, 0.0, 0.0), (0.0, -math.radians(10), 0.0))
    given = mounting(places, k, mass=163.9, inertia=(9.91, 4.12, 9.09), coupling=(-0.813, 1.34, -0.472), turned=turned)
    _, _, found = solved(given)
    assert found.frequencies == pytest.approx([9.61067, 11.57906, 12.81533, 16.37214, 24.62196, 26.04758], rel=2e-5)


# --- symmetries
def levels_of(given, f):
    s = system(given, np.asarray(body.inertia(given)))
    q = np.asarray(respond(s, np.array([94.0]), f[None, None]).q)[0, 0]
    return np.abs([moves(s, point) @ q for point in given.points])


def points(*places):
    from calc.mounting.inputs import Point

    return tuple(Point(name=f"point-{n}", position=place) for n, place in enumerate(places))


def test_a_mirrored_engine_has_the_same_levels():
    f = np.array([3.0, 2.0 - 1.0j, 0.5, 1.0j, 4.0, -2.0 + 1.0j])
    turned = [(0.1, 0.2, 0.3), (0.0, 0.0, 0.0), (0.2, -0.1, 0.0), (0.0, 0.4, 0.1)]
    places = [(-0.1, -0.26, -0.2), (-0.12, 0.3, -0.25), (-0.1, -0.2, 0.3), (-0.15, 0.25, 0.28)]
    k = [(260e3, 110e3, 90e3)] * 4
    one = mounting(places, k, coupling=(0.25, -0.35, 1.6), eta=0.12, turned=turned, points=points((0.4, 0.1, -0.2)))
    other = mounting(
        [(x, -y, z) for x, y, z in places],
        k,
        coupling=(-0.25, 0.35, 1.6),
        eta=0.12,
        turned=[(-a, b, -c) for a, b, c in turned],
        points=points((0.4, -0.1, -0.2)),
    )
    signs = np.array([1, -1, 1, -1, 1, -1])  # a force to the side turns round, a moment about x and z too
    assert levels_of(other, f * signs) == pytest.approx(levels_of(one, f), rel=1e-9)


def test_the_origin_does_not_matter():
    f = np.array([3.0, 2.0 - 1.0j, 0.5, 1.0j, 4.0, -2.0 + 1.0j])
    shift = np.array([0.3, -0.2, 0.5])
    places = np.array([(-0.1, -0.26, -0.2), (-0.12, 0.3, -0.25), (-0.1, -0.2, 0.3), (-0.15, 0.25, 0.28)])
    k, at = [(260e3, 110e3, 90e3)] * 4, np.array([0.4, 0.1, -0.2])
    one = mounting(places, k, eta=0.12, points=points(tuple(at)))
    other = mounting(places + shift, k, eta=0.12, points=points(tuple(at + shift)), centre_of_gravity=tuple(shift))
    assert levels_of(other, f) == pytest.approx(levels_of(one, f), rel=1e-9)


def test_a_resonance_without_loss_gives_no_number():
    s, _, _ = solved(four(h=0.0))
    f = np.ones((1, 1, 6), dtype=complex)
    omega = math.sqrt(4 * 260e3 / 310.0)
    q = np.asarray(respond(s, np.array([omega]), f).q)
    assert not np.isinf(q).any() and np.isnan(q).any()
