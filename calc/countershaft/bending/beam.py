# SPDX-License-Identifier: Apache-2.0
"""A stepped beam on rigid pins: finite elements after Timoshenko with the interpolation that is exact in statics.

Each element has constant stiffness and mass and a load that varies linearly, so that displacements, rotations and
reactions at the nodes are those of the differential equation; only inertia is approximated (consistent mass: the error
of a frequency falls with the fourth power of the elements' length, with the second where shear prevails). Loads and
displacements are complex: the two transverse planes of an axially symmetric shaft, which do not couple, in one
solution.

Signs: w in the direction of the load, θ the rotation of the section (w' without shear), M positive where a load in the
positive direction makes it so between two supports: M = −E·I·θ'.  All numbers in SI."""

import math
from collections.abc import Sequence

import numpy as np

from ...sheet.arrays import Array, ComplexArray, IndexArray
from ...sheet.record import record, replace
from ...sheet.units import Metre, RadPerSecond
from ...sheet.value import Link

Numbers = float | Sequence[float] | Array  # one for all pieces, or one for each
Loads = complex | Sequence[complex] | ComplexArray

MOST = 300  # elements, of which a shaft of some metres has as many as it needs: their work grows with the third power
ELEMENT = 10e-3  # m: the longest element; a frequency of a stout shaft is then right to some 10⁻⁵, statics are with any
SAME = 1e-6  # m: places that lie closer become one node
POINTS = 10  # moments are given at the tenths of each element
MODES = 4  # vectors that are iterated together for the lowest frequency
SETTLED = 1e-12  # relative change of the frequency's square at which the iteration ends


@record
class Beam:
    """Nodes and elements, their matrices assembled.  Unknowns: w and θ of each node in turn.

    `stiffness` E·I, `shear` κ·G·A, `line_mass` ρ·A and `load` at both ends belong to the elements; `pinned` are the
    unknowns held at zero."""

    z: Array
    load: ComplexArray
    line_mass: Array
    element_K: Array
    element_M: Array
    element_f: ComplexArray
    K: Array
    M: Array
    R: Array  # rotary inertia
    f: ComplexArray
    pinned: IndexArray
    free: IndexArray


@record
class Bent:
    """The loaded beam.  w, θ at the nodes; `reactions` of the pins on the beam; `slopes` θ at the pins; M at the places
    `moment_z`.

    Q = M' stands at both ends of each element, `shear_z`: two numbers where a force or a pin makes it jump.
    """

    z: Array
    w: ComplexArray
    theta: ComplexArray
    slopes: ComplexArray
    reactions: ComplexArray
    moment_z: Array
    moment: ComplexArray
    shear_z: Array
    shear: ComplexArray
    link: Link | None = None  # what the beam and its load were made of

    def moment_at(self, z: Array) -> ComplexArray:
        """The bending moment at places, linear between the points at which it is known."""
        return np.interp(z, self.moment_z, self.moment.real) + 1j * np.interp(z, self.moment_z, self.moment.imag)


def _shapes(L: Array, Phi: Array) -> tuple[Array, Array]:
    """Deflection and rotation of an element as polynomials of ξ = z/L: coefficients by element, unknown and power.

    The solution of the unloaded Timoshenko element for unit displacements of its ends (Przemieniecki, Theory of Matrix
    Structural Analysis, 5.6), Φ = 12·E·I/(κ·G·A·L²)."""
    ones, o = np.ones_like(L), np.zeros_like(L)
    w = np.array(
        [
            [ones + Phi, -Phi, -3 * ones, 2 * ones],
            [o, L * (1 + Phi / 2), -L * (2 + Phi / 2), L],
            [o, Phi, 3 * ones, -2 * ones],
            [o, -L * Phi / 2, -L * (1 - Phi / 2), L],
        ]
    )
    theta = np.array(
        [[o, -6 / L, 6 / L], [ones + Phi, -(4 + Phi), 3 * ones], [o, 6 / L, -6 / L], [o, -(2 - Phi), 3 * ones]]
    )
    return np.moveaxis(w, 2, 0) / (1 + Phi)[:, None, None], np.moveaxis(theta, 2, 0) / (1 + Phi)[:, None, None]


def _nodes(ends: Array, places: Array, longest: Metre) -> Array:
    """Every end of a piece and every place with a pin, a force or a mass, and what is needed between to keep elements
    short."""
    marks = np.sort(np.concatenate([ends, places]))
    marks = marks[np.concatenate([[True], np.diff(marks) > SAME])]
    longest = max(longest, (marks[-1] - marks[0]) / MOST)
    apart = np.diff(marks)
    parts = np.ceil(apart / longest - 1e-9).astype(int)
    number = np.arange(parts.sum()) - np.repeat(np.cumsum(parts) - parts, parts)  # of each node within its stretch
    return np.append(np.repeat(marks[:-1], parts) + number * np.repeat(apart / parts, parts), marks[-1])


def _nearest(z: Array, places: Array) -> IndexArray:
    nearest: IndexArray = np.abs(z[None, :] - places[:, None]).argmin(1)
    return nearest


def beam(
    ends: Numbers,
    stiffness: Numbers,
    shear: Numbers,
    line_mass: Numbers,
    load: Loads,
    pins: Numbers,
    forces: tuple[Numbers, Loads] = ((), ()),
    masses: tuple[Numbers, Numbers] = ((), ()),
    rotary: Numbers = 0.0,
    longest: Metre = ELEMENT,
) -> Beam:
    """A beam of pieces between `ends` (one more than pieces).

    `load` per length: one number of each piece, or a row of two, at its ends.  `shear` may be infinite (Bernoulli's
    beam).  `forces` and `masses`: their places and their amounts; a mass may be below zero (a hole).  `rotary`: ρ·I of
    each piece, left out without it; it counts for the frequencies, and not in the frame of a turning shaft, where −ρ·I
    would stiffen it by a part in ten thousand."""
    ends, places = np.asarray(ends, dtype=float), [np.asarray(x, dtype=float) for x in (pins, forces[0], masses[0])]
    z = _nodes(ends, np.concatenate(places), longest)
    L = np.diff(z)
    piece = np.clip(np.searchsorted(ends, (z[:-1] + z[1:]) / 2) - 1, 0, ends.size - 2)
    EI, S, mu = (
        np.broadcast_to(np.asarray(x, dtype=float), ends.size - 1)[piece] for x in (stiffness, shear, line_mass)
    )
    q = np.asarray(load, dtype=complex)
    q = np.broadcast_to(q[..., None] if q.ndim < 2 else q, (ends.size - 1, 2))[piece]
    share = (np.stack([z[:-1], z[1:]], 1) - ends[piece][:, None]) / np.diff(ends)[piece][:, None]
    q = q[:, :1] + (q[:, 1:] - q[:, :1]) * share

    Phi = 12 * EI / (S * L**2)
    w, theta = _shapes(L, Phi)
    power = np.arange(4)
    over_length = 1 / (power[:, None] + power[None, :] + 1)  # ∫ξ^i·ξ^j dξ
    ones, a, b, c = np.ones_like(L), L / 2, (4 + Phi) * L**2 / 12, (2 - Phi) * L**2 / 12
    K = np.array([[ones, a, -ones, a], [a, b, -a, c], [-ones, -a, ones, -a], [a, c, -a, b]])
    K = np.moveaxis(K, 2, 0) * (12 * EI / (L**3 * (1 + Phi)))[:, None, None]
    M = (mu * L)[:, None, None] * (w @ over_length @ w.transpose(0, 2, 1))
    of_section = np.broadcast_to(np.asarray(rotary, dtype=float), ends.size - 1)[piece]
    R = (of_section * L)[:, None, None] * (theta @ over_length[:3, :3] @ theta.transpose(0, 2, 1))
    f = L[:, None] * (w @ over_length[:, 0] * q[:, :1] + w @ over_length[:, 1] * (q[:, 1:] - q[:, :1]))

    n = 2 * z.size
    at = 2 * np.arange(L.size)[:, None] + power[None, :]
    whole_K, whole_M, whole_R = np.zeros((3, n, n))
    whole_f = np.zeros(n, dtype=complex)
    np.add.at(whole_K, (at[:, :, None], at[:, None, :]), K)
    np.add.at(whole_M, (at[:, :, None], at[:, None, :]), M)
    np.add.at(whole_R, (at[:, :, None], at[:, None, :]), R)
    np.add.at(whole_f, at, f)
    pinned, pushed, loaded = (2 * _nearest(z, x) for x in places)
    np.add.at(whole_f, pushed, np.asarray(forces[1], dtype=complex))
    np.add.at(whole_M, (loaded, loaded), np.asarray(masses[1], dtype=float))
    return Beam(
        z=z,
        load=q,
        line_mass=mu,
        element_K=K,
        element_M=M,
        element_f=f,
        K=whole_K,
        M=whole_M,
        R=whole_R,
        f=whole_f,
        pinned=pinned,
        free=np.delete(np.arange(n), pinned),
    )


def displaced(beam: Beam, omega: RadPerSecond = 0.0) -> ComplexArray:
    """w and θ of each node in turn, from (K − ω²·M)·u = f: the beam turns at ω with a load that turns with it; ω = 0:
    at rest."""
    free = np.ix_(beam.free, beam.free)
    # two real columns: a complex side would make K complex
    loads = np.stack([beam.f.real[beam.free], beam.f.imag[beam.free]], 1)
    columns = np.linalg.solve(beam.K[free] - omega**2 * beam.M[free], loads)
    u = np.zeros(beam.f.size, dtype=np.complex128)
    u[beam.free] = columns[:, 0] + 1j * columns[:, 1]
    return u


def bend(beam: Beam, omega: RadPerSecond = 0.0, u: ComplexArray | None = None) -> Bent:
    """The displaced beam with its reactions and moments; `u`: w and θ of each node, where they are known already."""
    u = displaced(beam, omega) if u is None else u
    reactions = (beam.K[beam.pinned] - omega**2 * beam.M[beam.pinned]) @ u - beam.f[beam.pinned]
    z, w = beam.z, u[::2]
    ends = np.stack([u[:-2:2], u[1:-2:2], u[2::2], u[3::2]], 1)
    # what holds each element
    pushed = np.einsum("eij,ej->ei", beam.element_K - omega**2 * beam.element_M, ends) - beam.element_f
    q = beam.load + (omega**2 * beam.line_mass)[:, None] * np.stack([w[:-1], w[1:]], 1)
    xi, L = np.arange(POINTS) / POINTS, np.diff(z)[:, None]
    M = (1 - xi) * pushed[:, 1:2] - xi * pushed[:, 3:4]
    M = M + L**2 * (q[:, :1] * (xi - xi**2) / 2 + (q[:, 1:] - q[:, :1]) * (xi - xi**3) / 6)
    # of M between the ends, and what the load adds to it
    slope, rise = (-(pushed[:, 1] + pushed[:, 3]) / L[:, 0], q[:, 1] - q[:, 0])
    Q = np.stack([slope + L[:, 0] * (q[:, 0] / 2 + rise / 6), slope - L[:, 0] * (q[:, 0] / 2 + rise / 3)], 1)
    return Bent(
        z=z,
        w=w,
        theta=u[1::2],
        slopes=u[1::2][beam.pinned // 2],
        reactions=reactions,
        moment_z=np.append((z[:-1, None] + xi * L).ravel(), z[-1]),
        moment=np.append(M.ravel(), -pushed[-1, 3]),
        shear_z=np.stack([z[:-1], z[1:]], 1).ravel(),
        shear=Q.ravel(),
    )


def sprung(beam: Beam, stiffness: Array) -> Beam:
    """The same beam on springs in place of its pins."""
    K = beam.K.copy()
    K[beam.pinned, beam.pinned] += stiffness
    return replace(beam, K=K, pinned=beam.pinned[:0], free=np.arange(beam.f.size))


def natural_frequency(beam: Beam) -> RadPerSecond:
    """The lowest angular frequency of bending, by subspace iteration on K⁻¹·M; infinite for a beam without mass.

    The Ritz step needs only K to be positive, so that a hole's mass below zero does no harm.
    """
    K, M = (X[np.ix_(beam.free, beam.free)] for X in (beam.K, beam.M + beam.R))
    n = beam.free.size
    D = np.linalg.solve(K, M)
    V = np.cos(np.outer(np.arange(n) + 0.5, np.arange(1, min(MODES, n) + 1)) * math.pi / n)  # any that are not alike
    V = np.linalg.qr(D @ V)[0]
    before = 0.0
    for _ in range(100):
        try:
            C = np.linalg.inv(np.linalg.cholesky(V.T @ K @ V))
        except np.linalg.LinAlgError:  # of a short stiff piece the higher shapes have shrunk to dust beside the first
            V = np.linalg.qr(V)[0]
            C = np.linalg.inv(np.linalg.cholesky(V.T @ K @ V))
        values, vectors = np.linalg.eigh(C @ (V.T @ M @ V) @ C.T)
        largest = float(values[-1])
        if abs(largest - before) <= SETTLED * abs(largest):
            break
        before, V = largest, D @ (V @ (C.T @ vectors))
    return 1 / math.sqrt(largest) if largest > 0 else math.inf
