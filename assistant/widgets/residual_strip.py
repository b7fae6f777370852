# SPDX-License-Identifier: Apache-2.0
"""Below a curve on which something was measured: where it lies above, on and below what was measured, in three rows."""

import math
from collections.abc import Callable, Iterator

from calc.locale import Language
from calc.sheet.curve import MeasuredPoints
from calc.sheet.text import Amount, Text

ROWS = 3
POINT, BAR = "•", "│"  # of what was measured, on the curve too
PLAIN_POINT, PLAIN_BAR = "o", "|"


def strip(
    points: MeasuredPoints, unit: str, column: Callable[[float], int], left: int, width: int, say: Language, point: str
) -> list[str]:
    """Three rows: a point stands above where the curve lies over the measurement by more than its bar, below where it
    lies under it by more, else between.  Where there are no bars a third of the largest residual stands for one.

    `column`: the cell of an x; `left`: cells before the frame, in which the rows are named."""
    known = [r for r in points.residual.tolist() if math.isfinite(r)]
    whole = [bar for bar in points.bar.tolist() if math.isfinite(bar)]
    share = max(map(abs, known), default=0.0) / 3
    rows = [[" "] * max(0, width - left) for _ in range(ROWS)]
    for x, r, bar in zip(points.x.tolist(), points.residual.tolist(), points.bar.tolist()):
        if not math.isfinite(r):
            continue
        limit = bar if math.isfinite(bar) else share
        row = 0 if r > limit else 2 if r < -limit else 1
        if 0 <= (cell := column(x)) < len(rows[row]):
            rows[row][cell] = point
    names = ["> σ", "0", "< −σ"] if whole else ["> 0", "0", "< 0"]
    zero = "".join(rows[1]).replace(" ", "·")
    texts = ["".join(rows[0]), zero, "".join(rows[2])]
    largest = max(known, key=abs, default=None)
    told = [f"{name:>{left}}{text}" for name, text in zip(names, texts)]
    if largest is not None:
        words = say(Text("furthest {r}", r=Amount(largest, unit, form="+.3g")))
        if len(words) + 2 < len(rows[0]) and not "".join(rows[2])[-len(words) - 1 :].strip():
            told[2] = f"{told[2][: -len(words) - 1]}{words} "
    return told


def bars_of(points: MeasuredPoints) -> Iterator[tuple[float, float, float]]:
    """Of each point with a bar: x, from, to."""
    for x, y, bar in zip(points.x.tolist(), points.y.tolist(), points.bar.tolist()):
        if math.isfinite(bar) and bar > 0:
            yield x, y - bar, y + bar
