# SPDX-License-Identifier: Apache-2.0
"""The engine as a rigid body: its inertia, given or estimated, and the axis about which the torque of the crank turns
it."""

import numpy as np

from ..sheet.arrays import Array, each, many
from ..sheet.formula import formula
from ..sheet.units import Kilogram, KilogramMetre2, Metre, Number, Radian
from ..sheet.value import based_on
from .inputs import MountingInputs, tensor

BOX, LEAST, MOST = 0.7, 0.5, 0.9  # of a full box: own assumption
DOFS = ("bounce", "lateral", "fore_aft", "yaw", "pitch", "roll")


@formula(
    "J",
    "definition of the inertia tensor about the centre of gravity",
    shows="diagonal J_x, J_y, J_z beside −∫xy dm …",
    unit="kg·m²",
)
def inertia_tensor(J: KilogramMetre2, J_c: KilogramMetre2) -> KilogramMetre2:
    return each(tensor(J, J_c))  # type: ignore[arg-type]


@formula(
    "J",
    "assumed: a share c of a full box of the overall dimensions; two public engines of 123 and 164 kg lie within 0.5 "
    "… 0.9",
    shows="c·m·(b² + c²)/12 for each axis",
    unit="kg·m²",
)
def box_inertia(c: Number, m: Kilogram, sides: Metre) -> KilogramMetre2:
    a, b, d = np.asarray(sides).tolist()
    return each(np.diag(c * m / 12 * np.array([b * b + d * d, a * a + d * d, a * a + b * b])))


def inertia(mounting: MountingInputs, share: float = BOX) -> KilogramMetre2:
    """The tensor as given, or that of a box."""
    if mounting.inertia is None:
        assert mounting.dimensions is not None
        return box_inertia(c=share, m=mounting.mass, sides=mounting.dimensions)  # type: ignore[arg-type]
    coupling = mounting.inertia_coupling if mounting.inertia_coupling is not None else (0.0, 0.0, 0.0)
    if mounting.integral:
        coupling = based_on(tuple(-x for x in coupling), coupling)
    return inertia_tensor(J=mounting.inertia, J_c=coupling)  # type: ignore[arg-type]


@formula("M", "dynamics: mass matrix of a rigid body about its centre of gravity", shows="diag(m, m, m) with J")
def mass_matrix(m: Kilogram, J: KilogramMetre2) -> Kilogram:
    M = np.zeros((6, 6))
    M[:3, :3], M[3:, 3:] = np.eye(3) * float(m), np.asarray(J)
    return each(M)


@formula(
    "e_T", "dynamics: axis about which a free body turns under a torque about the crank", shows="J⁻¹·e_z, of length 1"
)
def roll_axis(J: KilogramMetre2) -> Number:
    found = np.linalg.solve(np.asarray(J), np.array([0.0, 0.0, 1.0]))
    axis: Array = found / np.linalg.norm(found)
    return each(axis)


@formula("∠e_T", "geometry: between the torque roll axis and the crank", shows="arccos e_T·e_z")
def roll_axis_angle(e_T: Number) -> Radian:
    return float(np.arctan2(np.hypot(many(e_T)[0], many(e_T)[1]), many(e_T)[2]))


def cross(r: Array) -> Array:
    """[r]×, so that [r]×·θ = r × θ."""
    x, y, z = np.asarray(r, dtype=float).tolist()
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def displacement(r: Array) -> Array:
    """How a place moves with the body: B = [I, −[r]×], r from the centre of gravity."""
    return np.hstack([np.eye(3), -cross(r)])


def radius_of_gyration(mass: float, J: Array) -> float:
    """By which a force is compared with a moment."""
    return float(np.sqrt(np.trace(J) / (3 * mass)))
