# SPDX-License-Identifier: Apache-2.0
"""The engine as a rigid body, its inertia and its roll axis; and the stiffness of what it stands on.

The inertia is given or estimated; the roll axis is that about which the torque of the crank turns the engine."""

import math
from typing import Annotated

import numpy as np

from ..sheet.arrays import Array, ComplexArray
from ..sheet.formula import formula
from ..sheet.linked_array import gathered
from ..sheet.units import (
    Kilogram,
    KilogramMetres2,
    Kilograms,
    NewtonPerMetre,
    NewtonSecondPerMetre,
    Number,
    Numbers,
    PhasorNewtonPerMetre,
    Radian,
    RadPerSecond,
)
from ..sheet.value import based_on
from .inputs import Mobility, Mount, MountingInputs, Support, tensor

BOX, LEAST, MOST = 0.7, 0.5, 0.9  # of a full box: own assumption
DOFS = ("bounce", "lateral", "fore_aft", "yaw", "pitch", "roll")


@formula(
    "J",
    "definition of the inertia tensor about the centre of gravity",
    shows="diagonal J_x, J_y, J_z beside −∫xy dm …",
    unit="kg·m²",
)
def inertia_tensor(
    J: Annotated[tuple[float, ...], "kg·m²"], J_c: Annotated[tuple[float, ...], "kg·m²"]
) -> KilogramMetres2:
    return tensor(J, J_c)


@formula(
    "J",
    "assumed: a share c of a full box of the overall dimensions; two public engines of 123 and 164 kg lie within 0.5 "
    "… 0.9",
    shows="c·m·(b² + c²)/12 for each axis",
    unit="kg·m²",
)
def box_inertia(c: Number, m: Kilogram, sides: Annotated[tuple[float, ...], "m"]) -> KilogramMetres2:
    a, b, d = sides
    return np.diag(c * m / 12 * np.array([b * b + d * d, a * a + d * d, a * a + b * b]))


def inertia(mounting: MountingInputs, share: float = BOX) -> KilogramMetres2:
    """The tensor as given, or that of a box."""
    if mounting.inertia is None:
        assert mounting.dimensions is not None
        return box_inertia(c=share, m=mounting.mass, sides=mounting.dimensions)
    coupling = mounting.inertia_coupling if mounting.inertia_coupling is not None else (0.0, 0.0, 0.0)
    if mounting.integral:
        coupling = based_on(tuple(-x for x in coupling), coupling)
    return inertia_tensor(J=mounting.inertia, J_c=coupling)


@formula("M", "dynamics: mass matrix of a rigid body about its centre of gravity", shows="diag(m, m, m) with J")
def mass_matrix(m: Kilogram, J: KilogramMetres2) -> Kilograms:
    M: Array = np.zeros((6, 6))
    M[:3, :3], M[3:, 3:] = np.eye(3) * float(m), np.asarray(J)
    return M


@formula(
    "e_T", "dynamics: axis about which a free body turns under a torque about the crank", shows="J⁻¹·e_z, of length 1"
)
def roll_axis(J: KilogramMetres2) -> Numbers:
    solved = np.linalg.solve(np.asarray(J), np.array([0.0, 0.0, 1.0]))
    axis: Array = solved / np.linalg.norm(solved)
    return axis


@formula("∠e_T", "geometry: between the torque roll axis and the crank", shows="arccos e_T·e_z")
def roll_axis_angle(e_T: Numbers) -> Radian:
    return float(np.arctan2(np.hypot(e_T[0], e_T[1]), e_T[2]))


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


# --- the stiffness of mounts and supports
# Dynamic, with loss, turned, on a foundation that gives; at rest, real, or at a frequency.

REFERENCE = 20.0  # Hz, at which the stiffness of a fractional mount is the given one


@formula("k_dyn", "definition of the dynamic ratio of rubber", unit="N/mm")
def dynamic_stiffness(k: NewtonPerMetre, d: Number) -> NewtonPerMetre:
    return k * d


@formula("k*", "definition of the loss factor: complex stiffness along an own axis")
def lossy(k: NewtonPerMetre, eta: Number) -> PhasorNewtonPerMetre:
    return k * (1 + 1j * eta)


@formula("k*", "dynamics: spring with a viscous damper beside it, at one frequency")
def damped(k: NewtonPerMetre, Omega: RadPerSecond, c: NewtonSecondPerMetre) -> PhasorNewtonPerMetre:
    return k + 1j * Omega * c


@formula(
    "α",
    "mathematics, causality: the exponent with which a stiffness of constant loss factor rises over frequency",
    shows="2/π·arctan η",
)
def exponent(eta: Number) -> Number:
    return 2 / math.pi * math.atan(eta)


@formula("k_eff", "statics: two springs in series, mount and foundation")
def in_series(k: PhasorNewtonPerMetre, k_f: PhasorNewtonPerMetre) -> PhasorNewtonPerMetre:
    return k * k_f / (k + k_f)


def rotation(turned: tuple[float, ...] | None) -> Array:
    """The axes of a mount as columns: turned by a about x, then b about y, then c about z, all fixed."""
    if turned is None:
        return np.eye(3)
    (ca, cb, cc), (sa, sb, sc) = (np.asarray(f(np.asarray(turned))).tolist() for f in (np.cos, np.sin))
    x = np.array([[1.0, 0, 0], [0, ca, -sa], [0, sa, ca]])
    y = np.array([[cb, 0, sb], [0, 1.0, 0], [-sb, 0, cb]])
    z = np.array([[cc, -sc, 0], [sc, cc, 0], [0, 0, 1.0]])
    turning: Array = z @ y @ x
    return turning


def dynamic(mount: Mount) -> Array:
    """Along its own axes, without loss and without foundation."""
    return dynamic_stiffness(k=gathered(mount.stiffness), d=mount.dynamic_ratio)


def constant(spring: Mount | Support) -> bool:
    """Whether its stiffness is the same at every frequency."""
    if spring.damping:
        return False
    return isinstance(spring, Support) or (spring.frequency_dependence == "none" and not spring.mobility)


def own_foundation(mount: Mount) -> Array:
    """The foundation's own stiffness along the mount's axes, without its loss; infinite where it is rigid."""
    given = np.inf if mount.foundation is None else np.asarray(mount.foundation, dtype=float)
    return np.broadcast_to(given, (3,))


def foundation(mount: Mount) -> ComplexArray | None:
    """The same with its loss; None where it is rigid."""
    return None if mount.foundation is None else lossy(k=own_foundation(mount), eta=mount.foundation_loss or 0.0)


def at_rest(mount: Mount) -> ComplexArray:
    """For the modes: dynamic, with its loss factor, on the foundation; no damper and no growth with frequency."""
    k = lossy(k=dynamic(mount), eta=mount.eta)
    k_f = foundation(mount)
    return k if k_f is None else in_series(k=k, k_f=k_f)


def real_at_rest(mount: Mount) -> Array:
    """Its real counterpart: the springs alone in series."""
    k = dynamic(mount)
    return k if mount.foundation is None else np.real(in_series(k=k, k_f=own_foundation(mount)))


def own(spring: Mount | Support, Omega: Array) -> ComplexArray:
    """k* of the mount itself along its own axes (frequencies, 3)."""
    k = dynamic(spring) if isinstance(spring, Mount) else np.asarray(spring.stiffness, dtype=float)
    if spring.damping:
        return damped(k=k, Omega=Omega[:, None], c=spring.damping)
    k_star = lossy(k=k, eta=spring.eta)
    if isinstance(spring, Mount) and spring.frequency_dependence == "fractional":
        rise = (Omega / (2 * math.pi * REFERENCE)) ** exponent(eta=spring.eta)
        return np.asarray(rise)[:, None] * k_star
    same: ComplexArray = np.broadcast_to(k_star, (Omega.size, 3))
    return same


def with_foundation(mount: Mount, k: ComplexArray, R: Array, Omega: Array) -> ComplexArray:
    """The stiffness between engine and frame in engine axes (frequencies, 3, 3), from k* along the own axes."""
    k_f = foundation(mount)
    if k_f is not None:
        k = in_series(k=k, k_f=k_f)
    if not mount.mobility:
        turned: ComplexArray = (R * k[:, None, :]) @ R.T
        return turned
    softness = (R / k[:, None, :]) @ R.T + _receptance(mount.mobility, Omega)[:, :, None] * np.eye(3)
    stiff: ComplexArray = np.asarray(np.linalg.inv(softness), dtype=complex)
    return stiff


def _receptance(rows: tuple[Mobility, ...], Omega: Array) -> ComplexArray:
    """Displacement over force of the foundation along x, y, z: between the rows linear, beyond them the nearest."""
    at, f = np.array([row.frequency for row in rows]), Omega / (2 * math.pi)
    receptance = np.empty((Omega.size, 3), dtype=complex)
    for i, axis in enumerate("xyz"):
        real, imaginary = (np.array([getattr(row, axis)[part] for row in rows]) for part in (0, 1))
        receptance[:, i] = (np.interp(f, at, real) + 1j * np.interp(f, at, imaginary)) / (1j * Omega)
    return receptance


def loss_at_rest(mount: Mount) -> Array:
    """What of it is lost, as a stiffness."""
    lost: Array = at_rest(mount).imag
    return lost
