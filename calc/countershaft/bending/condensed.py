# SPDX-License-Identifier: Apache-2.0
"""The shaft as its supports know it: stiffness, load and slope at their places, in its own frame and in the housing's.

In the frame that turns with the shaft its centrifugal load and the bent shaft stand still: `condensed`.  Weight, tooth
force and bores out of line stand still in the housing: `at_rest`, and `standing_on` supports that give way.

Left out of the turning shaft: the rotary inertia of its sections (in synchronous turning (I_p − I_d)·ω²·θ is left of
it), the moment with which a film answers a tilt (which holds the journal straighter: left out on the safe side),
torsion, and that sections at other angles than the load's bend across their plane of symmetry."""

from collections.abc import Sequence

import numpy as np

from ...library.catalogue import Material
from ...sheet.arrays import Array, ComplexArray
from ...sheet.errors import NoSolution
from ...sheet.linked_array import column
from ...sheet.record import record
from ...sheet.text import Text
from ...sheet.units import Metre, Number, RadPerSecond
from ...sheet.value import untraced
from ..formulas import line_weight, weight
from ..inputs import EccentricMass
from ..outline import Outline, Piece, outline
from . import formulas as f
from .beam import Beam
from .shaft import prepared, shared_stiffness, sideways, within_shaft


@record
class Condensed:
    """The turning shaft at its N supports: they push it with r = K_c·x − f_c and its sections there turn by
    θ = θ₀ + Θ·x, where its journals are displaced by x.

    Displacements and loads are complex and turn with the shaft; r is the force of the supports on it, N; K_c, N/m,
    holds the inertia of what is displaced, so that a rigid move asks for a force.  x = 0: rigid supports.  `u`: w and θ
    of each node in turn on rigid supports, `moved`: the same, a column for 1 m at each support."""

    z: Array  # of the supports
    K_c: Array
    f_c: ComplexArray
    theta_0: ComplexArray
    Theta: Array
    nodes: Array
    u: ComplexArray
    moved: Array

    def deflection(self, x: ComplexArray) -> ComplexArray:
        """The bending line at `nodes`, its journals displaced by x."""
        line: ComplexArray = (self.u + self.moved @ x)[::2]
        return line


@record
class AtRest:
    """The shaft that stands in its housing, at its N supports: they push it with K₀·x − f.

    f is what a load puts on rigid supports: `weight` of the shaft, up positive, N; `force` of 1 N at the wheel,
    `couple` of 1 N·m there (positive where it lifts what lies behind the wheel)."""

    z: Array
    K_0: Array
    weight: Array
    force: Array | None = None
    couple: Array | None = None


@record
class OnSupports:
    """What stands on each of N supports that give way by springs of their own: linear in weight, wheel and bores.

    `weight`, N, up positive; `force` for 1 N at the wheel, `couple` for 1 N·m; `yields`, N/m: so much less stands on
    the row's support for each metre by which the column's bore is off the line."""

    weight: Array
    yields: Array
    force: Array | None = None
    couple: Array | None = None

    def offset(self, g: ComplexArray) -> ComplexArray:
        """The loads of bores that stand at g, up + i·side, off the line."""
        loads: ComplexArray = -(self.yields @ g)
        return loads

    def alignment(self, t: Metre) -> Array:
        """The most that bores anywhere in their zone of the diameter t put on each support."""
        return f.alignment_load(t=t, A=self.yields)


def condensed(
    pieces: Outline | Sequence[Piece],
    supports: tuple[Metre, ...],
    omega: RadPerSecond,
    material: Material,
    points: tuple[EccentricMass, ...] = (),
    effectiveness: Number = 1.0,
) -> Condensed:
    """The shaft that turns at `omega` [rad/s] on journals whose middles lie at `supports` [m], two or more, which rise.

    `pieces`: its outline, front to rear, sizes in m, angles in rad in the sense of its own rotation, as the axis of the
    complex plane has them that turns with it; `material`: modulus [Pa] and density [kg/m³].  `points`: further masses
    [kg] at a radius, an angle and a place; below zero what is removed.  `effectiveness`: the share η, 0 to 1, of what
    the sectors add to the core's bending stiffness.  What comes back, in N and m, is linear in how far the journals are
    displaced (`Condensed`); `carried` puts it on its supports.  Raises NoSolution where a support or a point lies
    beyond the shaft's ends."""
    shape = _shape(pieces)
    within_shaft(shape, supports, points)
    shaft = prepared(shape, material, omega, supports, points)
    core = f.core_inertia(I=shape.inertia, r_0=column(shape.pieces, "core_radius"), sector=shaft.sector)
    return of_beam(shaft.model(shared_stiffness(material, core, effectiveness, shape.inertia)), omega)


def of_beam(model: Beam, omega: RadPerSecond) -> Condensed:
    """A loaded beam seen from its pins; `bend(model, omega, made.u)` goes on without solving it again."""
    loads = np.stack([model.f.real, model.f.imag], 1)
    u, r = _reduced(model, loads, omega)
    on_pins = u[:, 0] + 1j * u[:, 1]
    slopes = model.pinned + 1
    return Condensed(
        z=model.z[model.pinned // 2],
        K_c=r[:, 2:],
        f_c=-(r[:, 0] + 1j * r[:, 1]),
        theta_0=on_pins[slopes],
        Theta=u[slopes, 2:],
        nodes=model.z,
        u=on_pins,
        moved=u[:, 2:],
    )


def at_rest(
    pieces: Outline | Sequence[Piece],
    supports: tuple[Metre, ...],
    material: Material,
    points: tuple[EccentricMass, ...] = (),
    effectiveness: Number = 1.0,
    wheel: Metre | None = None,
) -> AtRest:
    """The same shaft while it stands in its housing under its weight: arguments as `condensed` has them, and `wheel`,
    the middle of its wheel [m], which beyond an end of the outline stands on a stiff stub.

    Its sectors go round, so that they bend by the mean of both planes.  Loads [N] are positive upwards; with a wheel
    those of 1 N and of 1 N·m there are given too (`AtRest`); `standing_on` puts it on springs.  Raises NoSolution as
    `condensed` does."""
    shape = _shape(pieces)
    if wheel is not None:  # a node for it
        node = min(max(wheel, shape.pieces[0].start), shape.pieces[-1].end)
        points = (*points, EccentricMass(name="wheel", mass=0.0, radius=0.0, angle=0.0, z=node))
    within_shaft(shape, supports, points)
    with untraced():
        still = prepared(shape, material, 0.0, supports, points)
    given = still.given
    given["q"] = (-line_weight(mu=given["mu"])).astype(np.complex128)
    given["F"] = (-weight(m_S=given["m"])).astype(np.complex128)
    core = f.core_inertia(I=shape.inertia, r_0=column(shape.pieces, "core_radius"), sector=still.sector)
    mean = f.mean_inertia(I=shape.inertia, I_side=sideways(shape)) if still.sector.any() else shape.inertia
    model = still.model(shared_stiffness(material, core, effectiveness, mean))
    loads = [model.f.real]
    if wheel is not None:
        w = 2 * int(np.abs(model.z - node).argmin())
        force, couple = np.eye(model.f.size)[w : w + 2]
        loads += [force + (wheel - node) * couple, couple]
    _, r = _reduced(model, np.stack(loads, 1), 0.0)
    return AtRest(model.z[model.pinned // 2], r[:, len(loads) :], *-r[:, : len(loads)].T)


def standing_on(shaft: AtRest, stiffness: Array) -> OnSupports:
    """What stands on supports of that stiffness [N/m], one for each support of the shaft, from 0, where it does not
    touch, to infinite, where it is rigid: loads [N], up positive.

    Raises NoSolution where fewer than two touch."""
    k = np.asarray(stiffness, dtype=float)
    if np.count_nonzero(k) < 2:
        raise NoSolution(Text("bearings that hold the shaft at rest: fewer than two touch it"))
    # of y = P·(k + κ)/k both the load P = a·y and the way x − g = b·y are finite, whatever k
    typical = np.abs(np.diag(shaft.K_0)).max()
    a, b = 1.0 - typical / (k + typical), 1.0 / (k + typical)
    S = a[:, None] * np.linalg.inv(shaft.K_0 * b + np.diag(a))
    return OnSupports(
        weight=S @ shaft.weight,
        yields=S @ shaft.K_0,
        force=None if shaft.force is None else S @ shaft.force,
        couple=None if shaft.couple is None else S @ shaft.couple,
    )


def _shape(pieces: Outline | Sequence[Piece]) -> Outline:
    return pieces if isinstance(pieces, Outline) else outline(tuple(pieces), derived=False)


def _reduced(model: Beam, loads: Array, omega: RadPerSecond) -> tuple[Array, Array]:
    """w and θ of each node under each load on rigid pins, then for 1 m at each pin; and the forces of the pins then."""
    A = model.K - omega**2 * model.M
    free, pins = model.free, model.pinned
    sides = np.hstack([loads[free], -A[np.ix_(free, pins)]])
    u = np.zeros((model.f.size, sides.shape[1]))
    u[free] = np.linalg.solve(A[np.ix_(free, free)], sides)
    u[pins, np.arange(loads.shape[1], sides.shape[1])] = 1.0
    r = A[pins] @ u
    r[:, : loads.shape[1]] -= loads[pins]
    return u, r
