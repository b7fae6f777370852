# SPDX-License-Identifier: Apache-2.0
"""The inertia tensor of a rigid body, and whether a body can have it."""

import numpy as np

from ..sheet.arrays import Array
from ..sheet.text import COMMA, Amount, Text

DUST = 1e-9  # of the sum of two principal moments: a thin disc has exactly the third


def tensor(diagonal: tuple[float, ...], coupling: tuple[float, ...] | None, integral: bool = False) -> Array:
    """The tensor from its diagonal and [J_xy, J_yz, J_zx]; `integral`: these are given as ∫xy dm, with the other sign."""
    xy, yz, zx = coupling if coupling is not None else (0.0, 0.0, 0.0)
    off = np.array([[0.0, xy, zx], [xy, 0.0, yz], [zx, yz, 0.0]])
    found: Array = np.diag(np.asarray(diagonal, dtype=float)) + (-off if integral else off)
    return found


def problem(diagonal: tuple[float, ...], coupling: tuple[float, ...] | None, integral: bool = False) -> Text | None:
    """Why no body can have these moments of inertia; None where one can."""
    if len(diagonal) != 3 or (coupling is not None and len(coupling) != 3):
        return None  # said already
    J = tensor(diagonal, coupling, integral)
    if not np.isfinite(J).all():
        return None
    first, second, third = np.linalg.eigvalsh(J).tolist()
    if first > 0 and third <= (first + second) * (1 + DUST):
        return None
    moments = COMMA.join(Text("{J}", J=Amount(x, form=".4g")) for x in (first, second, third))
    if first <= 0:
        return Text("no body has it: its principal moments are {moments} kg·m², and each must be above 0", moments=moments)
    return Text("no body has it: of its principal moments {moments} kg·m² the largest exceeds the sum of the others", moments=moments)
