# SPDX-License-Identifier: Apache-2.0
"""The lines of a hatch: parallel, at 45°, and nowhere outside the outlines of what is cut."""

import math
from itertools import pairwise

from ..draw.drawing import Hatch, Point

HALF = math.sqrt(0.5)


def hatch_lines(hatch: Hatch) -> list[tuple[Point, Point]]:
    """Every line from where it enters what is cut to where it leaves it; what lies in two outlines is not cut."""
    turned = [[_turned(point, -1.0) for point in outline] for outline in hatch.outlines]
    levels = [y for outline in turned for _, y in outline]
    first, last = math.ceil(min(levels) / hatch.spacing), math.floor(max(levels) / hatch.spacing)
    lines = []
    for n in range(first, last + 1):
        y = n * hatch.spacing
        ends = sorted(x for outline in turned for x in _crossings(outline, y))
        lines += [(_turned((a, y), 1.0), _turned((b, y), 1.0)) for a, b in zip(ends[::2], ends[1::2]) if b > a]
    return lines


def _turned(point: Point, sense: float) -> Point:
    """A point about the origin by 45°, anticlockwise where `sense` is above 0."""
    x, y = point
    return HALF * (x - sense * y), HALF * (sense * x + y)


def _crossings(outline: list[Point], level: float) -> list[float]:
    """Where a closed outline crosses a level."""
    return [
        ax + (bx - ax) * (level - ay) / (by - ay)
        for (ax, ay), (bx, by) in pairwise([*outline, outline[0]])
        if (ay <= level) != (by <= level)
    ]  # fmt: skip
