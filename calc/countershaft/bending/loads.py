# SPDX-License-Identifier: Apache-2.0
"""The centrifugal load of a shaft as the few forces that a sketch of it shows."""

import numpy as np

from ...sheet.arrays import Array
from ...sheet.units import Metre, Newton, PhasorNewton, PhasorNewtonPerMetre

LEAST = 5e-3  # of the largest: a smaller force is not shown


def resultants(ends: Array, q: PhasorNewtonPerMetre, forces: tuple[Metre, PhasorNewton], back: complex) -> tuple[tuple[Metre, Newton], ...]:
    """Place and size of the loads along a plane: of neighbouring pieces that are loaded to the same side one together, at its middle.

    `q` per length of the pieces between `ends`; `forces`: places and amounts; `back` turns the plane into the real axis.
    """
    ends = np.asarray(ends, float)
    middles, each = (ends[1:] + ends[:-1]) / 2, (np.asarray(q) * back).real * np.diff(ends)
    largest = float(np.abs(each).max(initial=0.0))
    groups: list[list[tuple[float, float]]] = []
    side = 0
    for z, F in zip(middles.tolist(), each.tolist()):
        now = 0 if abs(F) < LEAST * largest else 1 if F > 0 else -1
        if now and now != side:
            groups.append([])
        if now:
            groups[-1].append((z, F))
        side = now
    groups += [[(z, F)] for z, F in zip(np.ravel(forces[0]).tolist(), np.ravel((np.asarray(forces[1]) * back).real).tolist())]
    sums = [(sum(z * F for z, F in group), sum(F for _, F in group)) for group in groups]
    found = [(moment / F, F) for moment, F in sums if F]
    largest = max((abs(F) for _, F in found), default=0.0)
    return tuple((z, F) for z, F in found if abs(F) >= LEAST * largest)
