# SPDX-License-Identifier: Apache-2.0
"""Two wheels in a row between two placed ones: the free angle with the most room, by a scan that is refined about its best point."""

import math
from typing import Any

from ...sheet.units import Metre, Radian
from .room import Room

COARSE, FINE, ROUNDS = 180, 65, 1
DUST = 1e-12  # stretched or folded, the circles only touch


def most_room(
    room: Room, places: dict[str, complex], chain: tuple[str, str, str, str], a: tuple[Metre, Metre, Metre]
) -> tuple[Radian, float, Metre] | None:
    """(direction of the first open wheel from its placed neighbour, side of the second, clearance of the tighter one).

    None where no direction was found in which both wheels reach.  The coarse scan holds the stretched and the folded position.
    """
    import numpy as np

    first, one, two, last = chain
    p, q = places[first], places[last]
    toward = math.atan2((q - p).imag, (q - p).real)
    phi: Any = toward + 2 * math.pi / COARSE * np.arange(COARSE)
    step, best = 2 * math.pi / COARSE, None
    for _ in range(1 + ROUNDS):
        clearance = _clearances(room, places, (one, two), p, q, phi, a)
        top = int(clearance.argmax())
        found = float(clearance.flat[top])
        if found == -math.inf:
            return best
        side, angle = divmod(top, phi.size)
        if best is None or found > best[2]:
            best = float(phi[angle]), (1.0, -1.0)[side], found
        phi = best[0] + step * np.linspace(-1, 1, FINE)
        step *= 2 / (FINE - 1)
    return best


def _clearances(
    room: Room, places: dict[str, complex], names: tuple[str, str], p: complex, q: complex, phi: Any, a: tuple[Metre, Metre, Metre]
) -> Any:
    """Of the tighter wheel, one row for each side; −∞ where the wheels do not reach each other."""
    import numpy as np

    sides = np.array([[1j], [-1j]])
    one, two = names
    A = p + a[0] * np.exp(1j * phi)
    way = q - A
    c2 = np.maximum(way.real**2 + way.imag**2, DUST * a[1] ** 2)
    u = (c2 + a[1] ** 2 - a[2] ** 2) / 2  # times c
    square = a[1] ** 2 * c2 - u**2
    v = np.sqrt(np.maximum(square, 0.0))
    B = A + (u + sides * v) * (way / c2)
    tighter = np.minimum(room.around_all(one, A, places), room.around_all(two, B, places))
    return np.where(square >= -DUST * a[1] ** 2 * c2, tighter, -math.inf)
