# SPDX-License-Identifier: Apache-2.0
"""What is published of the modes: frequencies, energies, the torque roll axis, the window of stiffness, mounts that could lean."""

import math

import numpy as np

from ..sheet.arrays import each, many
from ..sheet.linked_array import elements
from ..sheet.quantity import Stated
from ..sheet.record import record
from ..sheet.text import Text
from ..sheet.value import based_on, link_of, linked
from . import aids, body, modes, springs
from .body import DOFS
from .drive import Drive
from .inputs import MountingInputs
from .modes import Modes
from .numbers import described
from .result import Ceiling, Focal, Mode, RollAxis, Tree, Window
from .system import System
from .words import DOF_WORDS


@record
class Matrices:
    """Of the engine on rigid ground: stiffness at rest, its loss, masses; and the modes that they have."""

    K: float  # arrays, by the door of formulas
    K_loss: float
    M: float
    J: float
    found: Modes
    energies: list[list[float]]  # by coordinate and mode


def matrices(mounting: MountingInputs, free: System, J: float) -> Matrices:
    """Raises NoSolution where the mounts leave the engine a motion."""
    mounts = mounting.mounts
    B, R = each(based_on(free.between, mounting.centre_of_gravity)), each(free.axes)
    k, loss = (np.stack([of(mount) for mount in mounts]) for of in (springs.real_at_rest, springs.loss_at_rest))
    K = modes.stiffness_matrix(k=each(based_on(k, mounts)), B=B, R=R)
    K_loss = modes.stiffness_matrix(k=each(based_on(loss, mounts)), B=B, R=R)
    M = body.mass_matrix(m=mounting.mass, J=J)
    found = modes.modes(many(K), many(M))
    phi = modes.shapes(K=K, M=M)
    p = based_on(np.asarray(M) @ np.asarray(phi), phi, M)
    E = [[modes.energy(phi=_of(phi, j, i), p=_of(p, j, i)) for i in range(6)] for j in range(6)]
    return Matrices(K, K_loss, M, J, found, E)


def of_modes(m: Matrices) -> dict[str, Mode]:
    """Mode by mode, slowest first."""
    squares, losses = elements(many(modes.eigenvalues(K=m.K, M=m.M))), elements(many(modes.mode_loss(K_loss=m.K_loss, K=m.K, M=m.M)))
    E = m.energies
    shares = {i: {dof: Stated(described(SHARE[dof], "%", "E"), E[j][i]) for j, dof in enumerate(DOFS)} for i in range(6)}
    return {f"mode_{i + 1}": Mode(frequency=modes.frequency(omega2=squares[i]), loss_factor=losses[i], share=shares[i]) for i in range(6)}


SHARE = {dof: Text("Energy of the mode in {dof}", dof=words) for dof, words in DOF_WORDS.items()}
NAMED = {dof: Text("Frequency of the mode named {dof}", dof=words) for dof, words in DOF_WORDS.items()}
PURE = {dof: Text("Energy of the mode named {dof} in it", dof=words) for dof, words in DOF_WORDS.items()}


def _of(x: float, *place: int) -> float:
    """One number of an array, with the array's link."""
    return linked(float(np.asarray(x)[place]), link_of(x))


def frequencies(m: Matrices, one: dict[str, Mode]) -> dict[str, Stated]:
    """By the coordinate that a mode is named after, which is not its number."""
    return {dof: Stated(described(NAMED[dof], "Hz", "f"), one[f"mode_{m.found.of[i] + 1}"].frequency) for i, dof in enumerate(DOFS)}


def energies(m: Matrices) -> dict[str, Stated]:
    return {dof: Stated(described(PURE[dof], "%", "E"), m.energies[i][m.found.of[i]]) for i, dof in enumerate(DOFS)}


def roll_axis(m: Matrices) -> RollAxis:
    e_T, shares = body.roll_axis(J=m.J), modes.roll_shares(K=m.K, M=m.M)
    along = {
        axis: Stated(described(Text("Torque roll axis along {axis}", axis=axis), "", "e_T"), _of(e_T, i)) for i, axis in enumerate("xyz")
    }
    return RollAxis(angle=body.roll_axis_angle(e_T=e_T), decoupling=_of(shares, int(np.argmax(np.asarray(shares)))), direction=along)


def with_chassis(whole: System) -> Tree:
    """The frequencies of engine and frame together, slowest first."""
    one = np.array([2 * math.pi * springs.REFERENCE])
    found = modes.of_whole(whole.stiffness(whole.mount_stiffness(one)[1], one)[0], whole.M)
    about = described(Text("Frequency of engine and frame together"), "Hz", "f")
    return {f"mode_{i}": {"frequency": Stated(about, based_on(float(f), whole.source))} for i, f in enumerate(found, 1)}


def window(mounting: MountingInputs, driven: Drive, m: Matrices, one: dict[str, Mode]) -> Window:
    f_min, f_max = one["mode_1"].frequency, one["mode_6"].frequency
    ceilings = {}
    speeds = np.array([float(mounting.idle_speed)])
    wrench = driven.wrench(speeds, driven.torque(speeds))[0]
    rho = body.radius_of_gyration(float(mounting.mass), many(m.J))
    for name in ("half", "shaft"):
        order = (
            None
            if name not in driven.variants
            else aids.lowest_order(driven.orders, np.asarray(wrench[:, driven.variants.index(name)]), rho)
        )
        if order is not None:
            n = based_on(order, wrench)
            f_exc = aids.excitation_frequency(i=n, n=mounting.idle_speed)
            ceilings[name] = Ceiling(highest_factor=aids.highest_factor(f_exc=f_exc, f_max=f_max), lowest_order=n)
    return Window(
        lowest_factor=aids.lowest_factor(f_road=mounting.road_frequency, f_min=f_min),
        spread=aids.spread(f_max=f_max, f_min=f_min),
        **ceilings,
    )


def focal(mounting: MountingInputs) -> Tree | None:
    """Of the pair at the front under `focal` itself; of several each by its first mount as well."""
    found: Tree = {}
    pairs = aids.pairs(mounting)
    for i, pair in enumerate(pairs):
        of = (mounting.mounts, mounting.centre_of_gravity)
        b, L, h = (based_on(x, of) for x in (pair.b, pair.L, pair.h))
        reach = aids.focal_reach(b=b, L=L)
        leans = L > 1 and 0 < h <= reach
        one = Focal(angle=aids.focal_angle(b=b, L=L, h=h) if leans else None, reach=reach)
        if i == 0:
            found["reach"] = Stated(described(REACH, "mm", "a_max"), one.reach)
            if one.angle is not None:
                found["angle"] = Stated(described(LEAN, "°", "φ"), one.angle)
        if len(pairs) > 1:
            found[pair.first] = one
    return found or None


LEAN = Text("Inclination of the front pair that decouples roll from lateral")
REACH = Text("Highest elastic centre that an inclination of the front pair gives")
