# SPDX-License-Identifier: Apache-2.0
"""Where the words of a picture stand: each as near to its place as it can be without covering another one or lying across a line."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np

from calc.draw.drawing import Point

from .setting.boxes import Box

UP, DOWN = 0.74, 0.22  # of the size: what letters take above and below their base line
SIZE = 7.5
FREE = 4.0  # how far words may reach out of their picture
STEPS = 9  # rings of places around the first one
STEP = 3.2  # from ring to ring
WAYS = tuple((np.cos(t), np.sin(t)) for t in np.pi / 4 * np.array([2, 6, 0, 4, 1, 3, 5, 7]))
CROSSED, FAR = 6.0, 1.0  # what a line under words costs, and a ring
Side = Literal["left", "centre", "right", "above"]
Extent = tuple[float, float, float, float]


@dataclass(frozen=True, slots=True)
class Label:
    """Words with the place that they belong to: `side` as in sketches; above: in the middle over it."""

    words: Box
    at: Point
    side: Side

    def box(self, scale: float = 1.0) -> Extent:
        x, y = self.base(scale)
        return x, y - DOWN * SIZE, x + self.words.width, y + UP * SIZE

    def base(self, scale: float = 1.0) -> Point:
        """Where its base line begins."""
        x, y = self.at[0] * scale, self.at[1] * scale
        wide = self.words.width
        back = {"left": -2.0, "centre": wide / 2, "right": wide + 2.0, "above": wide / 2}[self.side]
        return x - back, y + (DOWN * SIZE + 1.2 if self.side == "above" else -(UP - DOWN) / 2 * SIZE)

    def moved(self, scale: float, dx: float, dy: float) -> Label:
        """The same on the page."""
        return replace(self, at=(dx + scale * self.at[0], dy + scale * self.at[1]))


def placed(labels: list[Label], pieces: Any, frame: Extent) -> list[tuple[Box, Point, bool]]:
    """The words with their places, and whether no line is under them."""
    taken: list[Extent] = []
    made = []
    for label in labels:
        best: tuple[float, Extent, bool] | None = None
        for cost, box in _places(label.box(), frame):
            if best is not None and cost >= best[0]:
                break
            if any(meet(box, other) for other in taken):
                continue
            across = crossed(box, pieces)
            if best is None or cost + CROSSED * bool(across) < best[0]:
                best = cost + CROSSED * bool(across), box, not across
        _, box, clear = best or (0.0, label.box(), False)
        taken.append(box)
        made.append((label.words, (box[0], box[1] + DOWN * SIZE), clear))
    return made


def _places(box: Extent, frame: Extent) -> list[tuple[float, Extent]]:
    """Places for words with what they cost, the cheapest first, all within the frame."""
    made = []
    for ring in range(STEPS + 1):
        for x, y in WAYS if ring else ((0.0, 0.0),):
            dx, dy = ring * STEP * x * (1.6 if ring else 1.0), ring * STEP * y
            dx = min(max(dx, frame[0] - box[0]), frame[2] - box[2])
            dy = min(max(dy, frame[1] - box[1]), frame[3] - box[3])
            made.append((FAR * ring, (box[0] + dx, box[1] + dy, box[2] + dx, box[3] + dy)))
    return made


def meet(one: Extent, other: Extent) -> bool:
    return one[0] < other[2] + 1.5 and other[0] < one[2] + 1.5 and one[1] < other[3] and other[1] < one[3]


def crossed(box: Extent, pieces: Any) -> bool:
    """Whether a piece of line runs through a box: its ends clipped to it leave something."""
    if not len(pieces):
        return False
    start, way = pieces[:, :2], pieces[:, 2:] - pieces[:, :2]
    low, high = np.array(box[:2]) + 0.2, np.array(box[2:]) - 0.2
    with np.errstate(divide="ignore", invalid="ignore"):
        a, b = (low - start) / way, (high - start) / way
    still = way == 0
    inside = (start >= low) & (start <= high)
    first = np.where(still, np.where(inside, -np.inf, np.inf), np.minimum(a, b)).max(axis=1)
    last = np.where(still, np.where(inside, np.inf, -np.inf), np.maximum(a, b)).min(axis=1)
    return bool(np.any((first <= last) & (last >= 0) & (first <= 1)))
