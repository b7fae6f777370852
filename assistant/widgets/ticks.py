# SPDX-License-Identifier: Apache-2.0
"""Where the ticks of an axis stand."""

import math
from collections.abc import Sequence

from rich.cells import cell_len

AXIS = 14  # cells that the numbers of the upright axis may take, with the frame
DEGREES = (1, 2, 5, 10, 15, 30, 45, 60, 90, 180, 360)  # steps of an axis of angles


def stand_below(names: Sequence[str], width: int) -> bool:
    """Whether the names of the groups of a bar chart fit below them, in a plot of so many cells, its axis among them."""
    return bool(names) and max(map(cell_len, names)) < (width - AXIS) // len(names)


def ticks(low: float, high: float, most: int, *, degrees: bool = False) -> list[float]:
    """At most so many places at 1, 2 or 5 times a power of ten; of angles at parts of a turn."""
    span = high - low
    if not span > 0:
        return [low]
    power = 10.0 ** math.floor(math.log10(span / most))
    step = next((n * power for n in (1, 2, 5, 10, 20) if span / (n * power) <= most), 50 * power)
    if degrees and step > 1:
        step = next((float(n) for n in DEGREES if span / n <= most), step)
    first = math.ceil(low / step - 1e-9)
    last = math.floor(high / step + 1e-9)
    return [n * step for n in range(first, last + 1)]


def even_ticks(low: float, high: float, rows: int, *, grounded: bool = False) -> tuple[float, float, list[float]]:
    """Limits that are hardly wider, with which the ticks stand equally many rows apart, and the ticks.

    `grounded`: the lower limit stays, else each tick is in the middle of its row.
    """
    span = high - low
    if not span > 0:
        return low, high, [low]
    power = 10.0 ** math.floor(math.log10(span / rows))
    best: tuple[float, float, float, float] | None = None  # how much wider, step, rows apart, lower limit
    for step in (n * power * ten for ten in (1, 10) for n in (1, 2, 2.5, 5)):
        for apart in range(int(rows * step / span + 1e-9), 1, -1):
            row = step / apart
            first = math.ceil(low / step - 1e-9) * step
            start = low if grounded else first - (math.ceil((first - low) / row - 0.5 - 1e-9) + 0.5) * row
            spare = math.floor((start + rows * row - high) / row + 1e-9)
            if spare >= 0:
                start -= 0.0 if grounded else spare // 2 * row
                wider = rows * row / span
                if rows >= 2 * apart and (best is None or wider < 0.9 * best[0]):
                    best = wider, step, row, start
                break
    if best is None:
        return low, high, ticks(low, high, max(2, rows // 2))
    _, step, row, start = best
    end = start + rows * row * (1 - 1e-9)  # so that rounding puts no tick of a grounded scale into the row below
    return start, end, [n * step for n in range(math.ceil(start / step - 1e-9), math.floor(end / step + 1e-9) + 1)]
