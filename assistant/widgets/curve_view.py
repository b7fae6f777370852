# SPDX-License-Identifier: Apache-2.0
"""What is seen of a curve: one of its variants, its vectors at one crank angle; and where the ticks of its axes stand.

Knows neither screen nor plotting library, and needs no numpy: it is there before the first curve is drawn."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from rich.cells import cell_len

from calc.sheet.step import Curve, Series, Turning

TURN = 10  # degrees by which the crank is turned at a time


@dataclass(frozen=True)
class Cursor:
    """Where a curve is read.  `place`: an x, or the parameter of a locus, or the number of a point; `line`: the series
    that was chosen."""

    place: float
    line: int = 0


@dataclass(frozen=True)
class Sight:
    """`wanted`: the variant that was chosen, by its name; a curve that does not have it shows its first."""

    curve: Curve
    wanted: str = ""
    degrees: int = 0  # crank angle; 0: cylinder 1 at TDC

    @property
    def variant(self) -> str:
        variants = self.curve.variants
        return self.wanted if self.wanted in variants else variants[0] if variants else ""

    @property
    def next_variant(self) -> str:
        variants = self.curve.variants
        return variants[(variants.index(self.variant) + 1) % len(variants)] if variants else ""

    @property
    def series(self) -> tuple[Series, ...]:
        return tuple(s for s in self.curve.series if s.variant in ("", self.variant))

    @property
    def chains(self) -> tuple[Turning, ...]:
        """The vectors that are drawn: only true scale shows them as they are."""
        return tuple(t for t in self.curve.turning if t.variant in ("", self.variant)) if self.curve.equal else ()

    @property
    def turns(self) -> bool:
        return bool(self.chains)


# --- where the ticks of an axis stand

AXIS = 14  # cells that the numbers of the upright axis may take, with the frame
DEGREES = (1, 2, 5, 10, 15, 30, 45, 60, 90, 180, 360)  # steps of an axis of angles


def stand_below(names: Sequence[str], width: int) -> bool:
    """Whether the names of the groups of a bar chart fit below them, in a plot of so many cells, its axis among
    them."""
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
