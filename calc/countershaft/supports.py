# SPDX-License-Identifier: Apache-2.0
"""The reactions of a shaft on any number of supports.

Clapeyron's three moments: constant bending stiffness over the whole length, supports rigid and in line, point loads, shear left out.  Loads
and reactions are complex and turn with the shaft.  A moment is positive where a load in the positive direction makes it so between two
supports, so that the moments over inner supports come out below zero (hogging).
"""

from typing import cast

import numpy as np

from ..sheet.abreast import design_by_design
from ..sheet.arrays import Array, BoolArray, ComplexArray, IndexArray, each, phasors
from ..sheet.errors import NoSolution
from ..sheet.formula import formula
from ..sheet.text import Text
from ..sheet.units import Metre, PhasorNewton, PhasorNewtonMetre

CLAPEYRON = Text(
    "statics: bending moments over the supports, by Clapeyron's three moments (Finotti 2013, 3.2.3.1, for two spans; here any number)"
)


@formula("M_i", CLAPEYRON,
    shows="M_1·L_1 + 2·M_2·(L_1 + L_2) + M_3·L_2 = −Σ F·a·(L_1² − a²)/L_1 − Σ F·b·(L_2² − b²)/L_2; "
    "M = −Σ F·a over the outer supports, a the distance of the loads beyond them")  # fmt: skip
def support_moments(F: PhasorNewton, z: Metre, z_s: Metre) -> PhasorNewtonMetre:
    """Bending moments over the supports at z_s, from loads F at z: all arrays.  a is counted from the support away, b likewise."""
    load, place, support = _arrays(F, z, z_s)
    n, L = support.size, np.diff(support)
    first, last = place < support[0], place > support[-1]
    M = np.zeros(n, dtype=complex)
    M[0] = -np.sum((load * (support[0] - place))[first])
    M[-1] = -np.sum((load * (place - support[-1]))[last])
    if n > 2:
        span, a, b, inside = _spans(place, support)
        L_s, load = L[span], load[inside]
        right, left = np.zeros(n, dtype=complex), np.zeros(n, dtype=complex)
        np.add.at(right, span + 1, load * a * (L_s**2 - a**2) / L_s)
        np.add.at(left, span, load * b * (L_s**2 - b**2) / L_s)
        wanted = -(right + left)[1:-1]
        wanted[0] -= M[0] * L[0]
        wanted[-1] -= M[-1] * L[-1]
        A = np.diag(2 * (L[:-1] + L[1:])) + np.diag(L[1:-1], 1) + np.diag(L[1:-1], -1)
        M[1:-1] = np.linalg.solve(A, wanted)
    return cast(PhasorNewtonMetre, M)


@formula("R_i", "statics: reactions of the supports, from the equilibrium of each span after Clapeyron",
    shows="−(Σ F·b/L on the span behind + Σ F·a/L on the span ahead + moments' differences over the spans + overhung loads)")  # fmt: skip
def support_reactions(F: PhasorNewton, z: Metre, z_s: Metre, M: PhasorNewtonMetre) -> PhasorNewton:
    """Forces of the supports on the shaft, from the loads and the moments over the supports: all arrays."""
    load, place, support = _arrays(F, z, z_s)
    moment = M
    span, a, b, inside = _spans(place, support)
    L = np.diff(support)
    carried = np.zeros(support.size, dtype=complex)
    carried[0] += np.sum(load[place < support[0]])
    carried[-1] += np.sum(load[place > support[-1]])
    np.add.at(carried, span, load[inside] * b / L[span])
    np.add.at(carried, span + 1, load[inside] * a / L[span])
    tilt = np.diff(moment) / L
    carried[:-1] += tilt
    carried[1:] -= tilt
    return cast(PhasorNewton, -carried)


@design_by_design
def reactions(F: PhasorNewton, z: Metre, positions: tuple[Metre, ...]) -> ComplexArray:
    """Forces of the supports on the shaft, front to rear.  `positions` rise; loads may lie between or beyond them.

    Raises NoSolution for less than two supports or two in one place.
    """
    if len(positions) < 2 or np.any(np.diff(positions) <= 0):
        raise NoSolution(Text("reactions of the shaft's supports"),
            Text("{count} supports at {what} mm", count=len(positions), what=', '.join(f'{p * 1000.0:g}' for p in positions)),
            Text("Give at least two bearing_positions_mm that rise from front to rear."))  # fmt: skip
    z_s = each(positions)
    return phasors(support_reactions(F=F, z=z, z_s=z_s, M=support_moments(F=F, z=z, z_s=z_s)))


def _arrays(F: PhasorNewton, z: Metre, z_s: Metre) -> tuple[ComplexArray, Array, Array]:
    return np.asarray(F, dtype=complex), np.asarray(z, dtype=float), np.asarray(z_s, dtype=float)


def _spans(place: Array, support: Array) -> tuple[IndexArray, Array, Array, BoolArray]:
    """Of each load between the outer supports: its span, and its distances from the support ahead of it and from that behind it."""
    inside = (place >= support[0]) & (place <= support[-1])
    span = np.clip(np.searchsorted(support, place[inside], side="right") - 1, 0, support.size - 2)
    return span, place[inside] - support[span], support[span + 1] - place[inside], inside
