# SPDX-License-Identifier: Apache-2.0
"""The rows of a file of loads, and what is kept while they are made: what is left out, and whether sums close."""

import math
from collections.abc import Sequence
from dataclasses import field

import numpy as np

from ..sheet.record import record
from ..sheet.text import Text
from ..sheet.units import RevPerSecond
from .frame import Frame, Vector

NOTHING: Vector = (0j, 0j, 0j)
LoadPlace = tuple[float | None, float | None, float]  # X, Y, Z in m; None: not known


@record
class LoadRow:
    """One row.  `speed` of the crank; `place`: the point by its name; `on`: the body that the force acts on; `force`,
    N, and `moment` about the point, N·m, are phasors along the axes of the file, of order 0 real."""

    speed: RevPerSecond
    kind: str
    place: str
    on: str
    order: float
    at: LoadPlace
    force: Vector
    moment: Vector = NOTHING


@record
class Book:
    """`frame`: the axes of the file; `left_out`: what is not in it though it might be asked, and `notes`: on what some
    rows stand, each once, by a key; `sums`: by what was added up, by how much it does not close, as a share of the
    largest part."""

    frame: Frame
    left_out: dict[str, Text] = field(default_factory=dict)
    notes: dict[str, Text] = field(default_factory=dict)
    sums: dict[str, float] = field(default_factory=dict)

    def place(self, axis: complex | None, z: float) -> LoadPlace:
        """A point at z on an axis beside the crank, up + i·side; None: it is not known where."""
        return (None, None, z) if axis is None else self.frame.place(float(axis.real), float(axis.imag), z)

    def closed(self, what: str, rows: Sequence[LoadRow], asked: Sequence[LoadRow]) -> None:
        """Keeps by how much the rows of one order differ from others that they shall equal in force and in moment about
        the origin."""
        pairs = zip(("force", "moment about the origin"), total(rows), total(asked))
        for n, (name, found, wanted) in enumerate(pairs):
            size = max([_size(total([row])[n]) for row in (*rows, *asked)], default=0.0)
            off = _size([a - b for a, b in zip(found, wanted)]) / size if size else 0.0
            self.sums[f"{what}, {name}"] = max(self.sums.get(f"{what}, {name}", 0.0), off)


def total(rows: Sequence[LoadRow]) -> tuple[Vector, Vector]:
    """Force, and moment about the origin; what has no known place across the engine stands on the crank's axis."""
    F, M = np.zeros(3, dtype=complex), np.zeros(3, dtype=complex)
    for row in rows:
        force = np.array(row.force)
        F, M = F + force, M + np.array(row.moment) + np.cross([part or 0.0 for part in row.at], force)
    (a, b, c), (d, e, f) = F.tolist(), M.tolist()
    return (a, b, c), (d, e, f)


def _size(vector: Sequence[complex]) -> float:
    return math.sqrt(sum(abs(part) ** 2 for part in vector))
