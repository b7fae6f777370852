"""Values of the shipped engine on its mounts once more, from its file by plain code that shares nothing with the
step."""

import math
import tomllib
from dataclasses import replace

import numpy as np
import pytest

from calc.design.toml_file import design, load
from calc.solve import solve
from tests.conftest import DESIGNS

FILE = DESIGNS / "r753ie4_mounting.toml"
G = 9.80665


@pytest.fixture(scope="module")
def shipped():
    return design(load(FILE)[0])


@pytest.fixture(scope="module")
def published(shipped):
    return solve(shipped).values()


@pytest.fixture(scope="module")
def file():
    return tomllib.loads(FILE.read_text(encoding="utf-8"))["mounting"]


def mass_matrix(file):
    (a, b, c), (xy, yz, zx) = file["inertia_kgm2"], file["inertia_coupling_kgm2"]
    M = np.diag([file["mass_kg"]] * 3 + [0.0] * 3)
    M[3:, 3:] = [[a, xy, zx], [xy, b, yz], [zx, yz, c]]
    return M


def arms(file):
    return [(np.array(mount["position_mm"]) - file["centre_of_gravity_mm"]) / 1000 for mount in file["mounts"]]


def spring_forces(file, q, of_spring):
    """Force and moment of the springs on the engine at q, mount by mount by the cross product."""
    total = np.zeros(6)
    for mount, r in zip(file["mounts"], arms(file)):
        force = -np.array(of_spring(mount)) * (q[:3] + np.cross(q[3:], r))
        total += np.concatenate([force, np.cross(r, force)])
    return total


def matrix(file, of_spring):
    return -np.column_stack([spring_forces(file, unit, of_spring) for unit in np.eye(6)])


def static(mount):
    return [1000 * k for k in mount["stiffness_N_mm"]]


def dynamic(mount):
    return [mount["dynamic_ratio"] * k for k in static(mount)]


def test_six_frequencies_and_the_lowest_factor(file, published):
    squares = np.linalg.eigvals(np.linalg.solve(mass_matrix(file), matrix(file, dynamic)))
    expected = sorted(np.sqrt(squares.real) / (2 * math.pi))
    found = sorted(
        published[f"mounting.frequency.{dof}"].shown
        for dof in ("bounce", "lateral", "fore_aft", "yaw", "pitch", "roll")
    )
    assert found == pytest.approx(expected, rel=1e-9)
    assert published["mounting.window.lowest_factor"].shown == pytest.approx((6.0 / expected[0]) ** 2, rel=1e-9)


def test_the_axis_about_which_a_torque_turns_the_free_engine(file, published):
    axis = np.linalg.solve(mass_matrix(file)[3:, 3:], [0.0, 0.0, 1.0])
    expected = math.degrees(math.atan2(math.hypot(axis[0], axis[1]), axis[2]))
    assert published["mounting.roll_axis.angle"].shown == pytest.approx(expected, rel=1e-9)


def test_how_the_engine_sits_under_its_weight(file, published):
    q = np.linalg.solve(matrix(file, static), [-file["mass_kg"] * G, 0, 0, 0, 0, 0])
    loads = 0.0
    for mount, r in zip(file["mounts"], arms(file)):
        down = -(q[:3] + np.cross(q[3:], r))[0]
        of = f"mounting.static.{mount['name']}"
        assert published[f"{of}.deflection"].shown == pytest.approx(1000 * down, rel=1e-9)
        assert published[f"{of}.load"].shown == pytest.approx(static(mount)[0] * down, rel=1e-9)
        loads += published[f"{of}.load"].shown
    assert loads == pytest.approx(file["mass_kg"] * G, rel=1e-9)


def on_rigid_ground(shipped, **of_mounts):
    given = shipped.mounting
    points = tuple(point for point in given.points if point.on == "engine")
    mounts = tuple(replace(mount, **of_mounts) for mount in given.mounts)
    return solve(replace(shipped, mounting=replace(given, chassis=None, points=points, mounts=mounts)))


def test_time_integration_gives_the_velocity_at_the_head(file, shipped):
    """Runge–Kutta from rest through 15 cycles, viscous mounts; the level of the 16th."""
    c, per_cycle, settle, idle = 4000.0, 1600, 15, 15.0
    results = on_rigid_ground(shipped, loss_factor=None, damping=c)
    result = results.outcomes["mounting"].solution
    lines = result.levels
    half = result.drive.variants.index("half")
    row = list(result.speeds).index("idle")
    phasors, orders = np.asarray(lines.wrench)[row, :, half], np.asarray(result.drive.orders)
    h = 2 / idle / per_cycle
    t = h / 2 * np.arange(2 * per_cycle)
    wrench = (np.exp(2j * math.pi * idle * np.outer(t, orders)) @ phasors).real
    M, K = mass_matrix(file), matrix(file, dynamic)
    C = matrix(file, lambda mount: [c] * 3)
    A = np.block([[np.zeros((6, 6)), np.eye(6)], [-np.linalg.solve(M, K), -np.linalg.solve(M, C)]])
    b = np.hstack([np.zeros_like(wrench), np.linalg.solve(M, wrench.T).T])
    point = file["points"][0]
    r = (np.array(point["position_mm"]) - file["centre_of_gravity_mm"]) / 1000
    y, sum_of_squares = np.zeros(12), 0.0
    for i in range((settle + 1) * per_cycle):
        k = 2 * i % len(b)
        one = A @ y + b[k]
        two = A @ (y + h / 2 * one) + b[k + 1]
        three = A @ (y + h / 2 * two) + b[k + 1]
        four = A @ (y + h * three) + b[(k + 2) % len(b)]
        y = y + h / 6 * (one + 2 * two + 2 * three + four)
        if i >= settle * per_cycle:
            v = y[6:9] + np.cross(y[9:], r)
            sum_of_squares += v @ v / per_cycle
    found = results.values()[f"mounting.idle.half.{point['name']}.velocity"].shown
    assert found == pytest.approx(1000 * math.sqrt(sum_of_squares), rel=1e-6)


def test_stiff_mounts_pass_on_all_of_the_moment(shipped):
    stiff = tuple(1e4 * k for k in shipped.mounting.mounts[0].stiffness)
    values = on_rigid_ground(shipped, stiffness=stiff).values()
    assert values["mounting.idle.half.order_1.transmissibility_moment"].shown == pytest.approx(1.0, abs=1e-3)
