"""What stands below a mount, and rubber whose stiffness rises with frequency."""

import math
from dataclasses import replace

import numpy as np
import pytest

from calc.mounting import body as springs
from calc.mounting.inputs import Mobility, Mount
from calc.mounting.system import respond, system
from tests.calc.mounting.test_dynamics import SKEW, four

MOUNT = Mount(
    name="one", position=(0.0, 0.0, 0.0), stiffness=(900e3, 420e3, 420e3), dynamic_ratio=1.3, loss_factor=0.12
)
OMEGA = 2 * math.pi * np.array([15.0, 22.5, 60.0])


def stiffness(mount):
    return springs.with_foundation(mount, springs.own(mount, OMEGA), springs.rotation(mount.turned), OMEGA)


def test_a_spring_below_adds_its_softness():
    k, k_f = 1.3 * np.array([900e3, 420e3, 420e3]) * (1 + 0.12j), 2e6 * (1 + 0.05j)
    found = stiffness(replace(MOUNT, foundation=(2e6,), foundation_loss=0.05))
    assert np.diagonal(found, axis1=1, axis2=2) == pytest.approx(np.tile(1 / (1 / k + 1 / k_f), (3, 1)), rel=1e-12)


def test_the_mobility_of_a_spring_is_that_spring():
    """A foot of stiffness k_f has v/F = iΩ/k_f: given as a mobility it does what it does as a stiffness."""
    rows = tuple(
        Mobility(
            frequency=f, x=(0.0, 2 * math.pi * f / 2e6), y=(0.0, 2 * math.pi * f / 2e6), z=(0.0, 2 * math.pi * f / 2e6)
        )
        for f in (15.0, 22.5, 60.0)
    )
    turned = (0.1, 0.2, 0.3)
    found = stiffness(replace(MOUNT, mobility=rows, turned=turned))
    assert found == pytest.approx(stiffness(replace(MOUNT, foundation=(2e6,), turned=turned)), rel=1e-12)


def test_fractional_rubber_rises_as_its_loss_asks():
    """η = 0.12: α = 0.076, nine per cent from 20 to 60 Hz."""
    assert springs.exponent(eta=0.12) == pytest.approx(0.076, abs=5e-4)
    mount = replace(MOUNT, frequency_dependence="fractional")
    k = springs.own(mount, 2 * math.pi * np.array([20.0, 60.0]))
    assert k[0] == pytest.approx(springs.own(MOUNT, OMEGA)[0], rel=1e-12)
    assert np.abs(k[1] / k[0]) == pytest.approx([1.09] * 3, abs=0.005)
    assert k.imag / k.real == pytest.approx(np.full((2, 3), 0.12), rel=1e-12)


def test_a_place_that_a_shape_does_not_name_stays_where_it_is():
    from calc.mounting.inputs import FrameMode, Move
    from tests.calc.mounting.test_dynamics import CHASSIS

    mode = FrameMode(frequency=27.0, loss_factor=0.06, shape=(Move(name="mount-0", move=(0.006, 0.002, 0.0)),))
    s = system(four(eta=0.12, chassis=replace(CHASSIS, modes=(mode,))), SKEW)
    assert s.size == 13
    assert s.between[0, :, 12] == pytest.approx([-0.006, -0.002, 0.0])
    assert not s.between[1:, :, 12].any()


def test_on_stiff_mounts_engine_and_frame_are_one_free_body():
    """Far above its own supports: the force on both over the mass of both."""
    from calc.mounting.inputs import Chassis, Support

    soft = Support(name="soft", position=(0.0, 0.0, 0.0), stiffness=(1.0, 1.0, 1.0), loss_factor=0.0)
    frame = Chassis(mass=700.0, centre_of_gravity=(-0.4, 0.1, 0.3), inertia=(80.0, 90.0, 50.0), supports=(soft,))
    given = four(chassis=frame)
    stiff = replace(given, mounts=tuple(replace(mount, stiffness=(1e14, 1e14, 1e14)) for mount in given.mounts))
    w, f = 100.0, np.array([3.0, -2.0, 0.5, 1.0, 4.0, -2.0])
    q = np.asarray(respond(system(stiff, SKEW), np.array([w]), f.astype(complex)[None, None]).q)[0, 0].real
    c = np.array([-0.4, 0.1, 0.3])
    B = np.eye(6)
    B[:3, 3:] = [[0, c[2], -c[1]], [-c[2], 0, c[0]], [c[1], -c[0], 0]]
    M = np.zeros((6, 6))
    M[:3, :3], M[3:, 3:] = 310.0 * np.eye(3), SKEW
    whole = M + B.T @ np.diag([700.0] * 3 + [80.0, 90.0, 50.0]) @ B
    assert -(w**2) * q[:6] == pytest.approx(np.linalg.solve(whole, f), rel=1e-5)
