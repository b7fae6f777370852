# SPDX-License-Identifier: Apache-2.0
"""Fronts: which rows no other row beats in everything, and a few that stand for all.

Rows are arrays of shape (rows, objectives), all of them to be as small as can be.
"""

import numpy as np

from ..sheet.arrays import Array, BoolArray, IndexArray

BLOCK = 512


def front(rows: Array) -> IndexArray:
    """The places of the rows that no other beats (is nowhere larger and somewhere smaller); of equal rows the first.  Rising."""
    order = np.lexsort(rows.T[::-1])  # a row can only be beaten by one before it
    kept = np.zeros((0, rows.shape[1]))
    places: list[IndexArray] = []
    for start in range(0, len(order), BLOCK):
        at = order[start : start + BLOCK]
        block = rows[at]
        if len(kept):
            alive = np.ones(len(block), dtype=bool)
            for k in range(0, len(kept), 2048):
                alive &= ~_beaten(block, kept[k : k + 2048]).any(axis=1)
            at, block = at[alive], block[alive]
        first = ~np.tril(_beaten(block, block), -1).any(axis=1)
        kept = np.concatenate([kept, block[first]])
        places.append(at[first])
    return np.sort(np.concatenate(places)) if places else np.zeros(0, dtype=int)


def _beaten(rows: Array, others: Array) -> BoolArray:
    """[row, other]: whether the other is nowhere larger."""
    beaten: BoolArray = np.logical_and.reduce([others[None, :, n] <= rows[:, None, n] for n in range(rows.shape[1])])
    return beaten


def lower_left(x: Array, y: Array) -> IndexArray:
    """The same of two objectives, in the order of the first."""
    order = np.lexsort((y, x))
    best = np.minimum.accumulate(y[order])
    first = np.ones(order.size, dtype=bool)
    first[1:] = y[order][1:] < best[:-1]
    chosen: IndexArray = order[first]
    return chosen


def representatives(rows: Array, units: Array, count: int) -> list[int]:
    """The best of every objective, the knee, then ever the row that is worst represented: what it lacks beside the nearest chosen one, in
    units, in its worst objective (additive ε)."""
    if not len(rows):
        return []
    scaled = rows / units
    chosen = list(dict.fromkeys([int(np.lexsort((scaled.sum(1), scaled[:, n]))[0]) for n in range(rows.shape[1])] + [knee(rows)]))
    lacks = np.full(len(rows), np.inf)
    for place in chosen:
        lacks = np.minimum(lacks, (scaled[place] - scaled).max(1))
    while len(chosen) < min(count, len(rows)):
        place = int(lacks.argmax())
        if lacks[place] <= 0:
            break
        chosen.append(place)
        lacks = np.minimum(lacks, (scaled[place] - scaled).max(1))
    return chosen[:count]


def knee(rows: Array) -> int:
    """The row nearest to the best of everything at once, each objective over its own range."""
    low, high = rows.min(0), rows.max(0)
    return int((((rows - low) / np.where(high > low, high - low, 1.0)) ** 2).sum(1).argmin())
