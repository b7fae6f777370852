# SPDX-License-Identifier: Apache-2.0
"""Engine and frame as one system: its matrices, the displacement of every place, and its steady state under harmonic
wrenches.

Coordinates: the six of the engine's centre of gravity, then the six of the chassis and one for each mode of the frame.
"""

import math

import numpy as np

from ..sheet.arrays import Array, ComplexArray
from ..sheet.formula import formula
from ..sheet.record import record, replace
from ..sheet.units import Kilograms, PhasorMetres, PhasorNewtons, PhasorNewtonsPerMetre, RadiansPerSecond
from ..sheet.value import based_on, link_of, linked
from . import body
from .body import displacement, mass_matrix
from .inputs import Chassis, MountingInputs, Point, tensor

RESONANT = 1e-12  # of an eigenvalue: an undamped resonance is hit


@record
class System:
    """`between`: how each mount is deflected (mounts, 3, coordinates), engine side less frame side, in engine axes;
    `axes`: R of each."""

    mounting: MountingInputs
    size: int
    M: Array
    between: Array
    axes: Array
    ground: Array  # (supports, 3, coordinates): how each support of the frame moves
    arms: Array  # (mounts, 3): places of the mounts from the centre of gravity
    static_frame: ComplexArray  # (coordinates, coordinates): of the modes of the frame
    source: object  # what the matrices come of

    @property
    def constant(self) -> bool:
        """Whether nothing depends on frequency: one eigenproblem then answers all speeds."""
        frame = self.mounting.chassis
        supports = frame.supports if frame is not None else ()
        return all([*map(body.constant, self.mounting.mounts), *map(body.constant, supports)])

    def mount_stiffness(self, Omega: Array) -> tuple[ComplexArray, ComplexArray]:
        """Along the own axes of each mount itself (mounts, frequencies, 3), and with its foundation in engine axes."""
        own_stiffness = [body.own(mount, Omega) for mount in self.mounting.mounts]
        whole = [
            body.with_foundation(m, k, R, Omega) for m, k, R in zip(self.mounting.mounts, own_stiffness, self.axes)
        ]
        return np.stack(own_stiffness), np.stack(whole)

    def stiffness(self, whole: ComplexArray, Omega: Array) -> ComplexArray:
        """K* (frequencies, coordinates, coordinates) from that of the mounts."""
        D, total = self.between, np.zeros((Omega.size, self.size, self.size), dtype=complex)
        for d, k in zip(D, whole):
            total += d.T @ k @ d
        frame = self.mounting.chassis
        if frame is not None:
            for support, g in zip(frame.supports, self.ground):
                R = body.rotation(support.turned)
                total += g.T @ ((R * body.own(support, Omega)[:, None, :]) @ R.T) @ g
        return total + self.static_frame


def system(mounting: MountingInputs, J: Array, *, frame: bool = True) -> System:
    """The system of a design; `frame`: with the machine below, else on rigid ground."""
    chassis = mounting.chassis if frame else None
    modes = chassis.modes if chassis is not None else ()
    size = 6 + (6 + len(modes) if chassis is not None else 0)
    r_G = np.asarray(mounting.centre_of_gravity)
    arms = np.array([mount.position for mount in mounting.mounts]) - r_G
    M = np.eye(size)
    M[:6, :6] = np.asarray(mass_matrix(m=mounting.mass, J=J))
    static_frame = np.zeros((size, size), dtype=complex)
    between = np.zeros((len(arms), 3, size))
    supports = chassis.supports if chassis is not None else ()
    ground = np.zeros((len(supports), 3, size))
    for j, mount in enumerate(mounting.mounts):
        between[j, :, :6] = displacement(arms[j])
        if chassis is not None:
            between[j, :, 6:] = -_on_frame(chassis, mount.name, mount.position)
    if chassis is not None:
        M[6:12, 6:12] = np.asarray(mass_matrix(m=chassis.mass, J=tensor(chassis.inertia, chassis.inertia_coupling)))
        for i, mode in enumerate(modes):
            static_frame[12 + i, 12 + i] = (2 * math.pi * mode.frequency) ** 2 * (1 + 1j * mode.loss_factor)
        for j, support in enumerate(supports):
            ground[j, :, 6:] = _on_frame(chassis, support.name, support.position)
    axes = np.stack([body.rotation(mount.turned) for mount in mounting.mounts])
    design = mounting if chassis is mounting.chassis else replace(mounting, chassis=None)
    source = (J, mounting.mass, mounting.centre_of_gravity, mounting.mounts, chassis)
    return System(design, size, M, between, axes, ground, arms, static_frame, source)


def _on_frame(chassis: Chassis, name: str, position: tuple[float, ...]) -> Array:
    """How a place of the frame moves with the chassis and its modes."""
    rigid = displacement(np.asarray(position) - np.asarray(chassis.centre_of_gravity))
    shapes = [
        next((place.move for place in mode.shape if place.name == name), (0.0, 0.0, 0.0)) for mode in chassis.modes
    ]
    return np.hstack([rigid, np.array(shapes, dtype=float).reshape(-1, 3).T])


def moves(s: System, point: Point) -> Array:
    """How a point moves with the coordinates (3, coordinates)."""
    motion = np.zeros((3, s.size))
    if point.on == "chassis":
        assert s.mounting.chassis is not None
        motion[:, 6:] = _on_frame(s.mounting.chassis, point.name, point.position)
    else:
        motion[:, :6] = displacement(np.asarray(point.position) - np.asarray(s.mounting.centre_of_gravity))
    return motion


@formula("q̂", "dynamics: steady state of a linear system under harmonic wrenches", shows="(K* − Ω²·M)⁻¹·f̂")
def steady_state(K: PhasorNewtonsPerMetre, M: Kilograms, f: PhasorNewtons, Omega: RadiansPerSecond) -> PhasorMetres:
    """`f`: (frequencies, cases, 6) on the engine; `K`: one matrix, or one for each frequency.  None of a resonance
    without loss."""
    mass, w = np.asarray(M), np.asarray(Omega)
    if K.ndim == 2:
        return _by_modes(K, mass, f, w)
    D = K - (w**2)[:, None, None] * mass
    right = np.zeros((w.size, mass.shape[0], f.shape[1]), dtype=np.complex128)
    right[:, :6] = np.swapaxes(f, 1, 2)
    try:
        response = np.linalg.solve(D, right)
    except np.linalg.LinAlgError:
        response = np.stack([_one(d, r) for d, r in zip(D, right)])
    return np.swapaxes(response, 1, 2)


def _one(D: ComplexArray, right: ComplexArray) -> ComplexArray:
    try:
        solved: ComplexArray = np.asarray(np.linalg.solve(D, right), dtype=complex)
        return solved
    except np.linalg.LinAlgError:
        return np.full_like(right, np.nan)


@record
class Decomposed:
    """One complex-symmetric eigenproblem for all speeds: q̂ = right·(left·f̂)/(λ − Ω²)."""

    values: ComplexArray
    left: ComplexArray  # (modes, 6)
    right: ComplexArray  # (coordinates, modes)


def decomposed(K: ComplexArray, M: Array) -> Decomposed:
    inverse = np.linalg.inv(np.linalg.cholesky(M))
    values, V = np.linalg.eig(inverse @ K @ inverse.T)
    return Decomposed(values, np.linalg.solve(V, inverse.astype(complex))[:, :6], inverse.T @ V)


def gain(values: ComplexArray, Omega: Array) -> ComplexArray:
    """1/(λ − Ω²) (frequencies, modes); no number where an undamped resonance is hit."""
    gap = values - (Omega**2)[:, None]
    hit = np.abs(gap) <= RESONANT * np.abs(values)
    gains: ComplexArray = np.where(hit, np.nan, 1.0 / np.where(hit, 1.0, gap))
    return gains


def _by_modes(K: ComplexArray, M: Array, f: ComplexArray, Omega: Array) -> ComplexArray:
    d = decomposed(K, M)
    response: ComplexArray = ((f @ d.left.T) * gain(d.values, Omega)[:, None, :]) @ d.right.T
    return response


@record
class Response:
    """q̂ (frequencies, cases, coordinates), and the forces of the mounts on the frame (mounts, frequencies, cases, 3)
    in engine axes, with their own deflections along their own axes."""

    Omega: Array
    q: ComplexArray
    force: ComplexArray
    deflection: ComplexArray


def respond(s: System, Omega: Array, f: ComplexArray) -> Response:
    """The steady state under wrenches about the engine's centre of gravity, (frequencies, cases, 6)."""
    at = Omega[:1] if s.constant else Omega
    own_stiffness, whole = s.mount_stiffness(at)
    K = s.stiffness(whole, at)
    K_given = based_on(K[0] if s.constant else K, s.source)
    q = steady_state(K=K_given, M=based_on(s.M, s.source), f=f, Omega=Omega)
    between = np.einsum("jac,fvc->jfva", s.between, q)
    force = np.einsum("jfab,jfvb->jfva", np.broadcast_to(whole, (len(whole), Omega.size, 3, 3)), between)
    deflection = np.einsum("jba,jfvb->jfva", s.axes, force) / own_stiffness[:, :, None, :]
    return Response(Omega, linked(q, link_of(q)), force, deflection)


def respond_at(s: System, Omega: Array, f: ComplexArray) -> ComplexArray:
    """The displacements alone, frequency by frequency."""
    _, whole = s.mount_stiffness(Omega)
    return steady_state(K=s.stiffness(whole, Omega), M=s.M, f=f, Omega=Omega)


def transmitted(s: System, r: Response) -> tuple[ComplexArray, ComplexArray]:
    """Force and moment about the centre of gravity that the mounts pass on (frequencies, cases, 3)."""
    return r.force.sum(0), np.cross(s.arms[:, None, None, :], r.force).sum(0)
