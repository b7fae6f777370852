# SPDX-License-Identifier: Apache-2.0
"""How much of the stretch for which a position stands has a property that begins or ends between two positions.

A quadrature that counts a position wholly or not at all would make the power of a mesh jump whenever one of its positions changes its
regime.  Here the stretch around each position, as long as its weight, is cut where the property changes, so that the sum changes
steadily and is right to the second order of the stretches.
"""

import numpy as np

from ...sheet.arrays import Array, IndexArray
from ...sheet.record import record


@record
class Cells:
    """The stretch to the left and right of each position, and the neighbours by which a number is continued to its ends."""

    left: Array
    right: Array
    before: tuple[IndexArray, IndexArray]
    after: tuple[IndexArray, IndexArray]
    to_left: Array  # of the difference of both neighbours
    to_right: Array

    def below_zero(self, value: Array) -> Array:
        """The share of each stretch in which a number that is known at the positions lies below 0, taken as a line between them."""
        there = value < 0
        if there.all() or not there.any():
            return np.where(there, 1.0, 0.0)
        at_left = value - self.to_left * (value[..., self.before[1]] - value[..., self.before[0]])
        at_right = value + self.to_right * (value[..., self.after[1]] - value[..., self.after[0]])
        length = self.left + self.right
        share = (_below(at_left, value) * self.left + _below(value, at_right) * self.right) / np.where(length > 0, length, 1.0)
        return np.where(length > 0, share, np.where(there, 1.0, 0.0))


def _below(a: Array, b: Array) -> Array:
    """The share of a line from a to b that lies below 0."""
    size = np.abs(a) + np.abs(b)
    return (np.maximum(-a, 0.0) + np.maximum(-b, 0.0)) / np.where(size > 0, size, 1.0)


def cells(x: Array, width: Array, points: int, others: int) -> Cells:
    """Rows of positions: pieces of so many points each, whose widths fill their piece, then `others` that stand for nothing."""
    rows, columns = x.shape
    place = np.arange(columns - others)
    in_piece = place % points
    # stretches: those of a piece lie one after the other from its beginning
    dx = width.reshape(rows, -1, points)
    ends = np.cumsum(dx, axis=-1)
    inside = x[:, : columns - others].reshape(rows, -1, points)
    begin = inside.mean(axis=-1, keepdims=True) - ends[..., -1:] / 2  # Gauss points lie evenly about the middle of their piece
    left, right = inside - (begin + ends - dx), begin + ends - inside
    nothing = np.zeros((rows, others))
    first = np.where(in_piece > 0, place - 1, place)
    last = np.where(in_piece < points - 1, place + 1, place)
    marks = np.arange(columns - others, columns)
    base = np.arange(rows)[:, None] * columns
    pair_before = np.where(in_piece > 0, first, place), np.where(in_piece > 0, place, last)
    pair_after = np.where(in_piece < points - 1, place, first), np.where(in_piece < points - 1, last, place)
    before, after = (
        tuple((base + np.concatenate((one, marks))).ravel() for one in pair) for pair in (pair_before, pair_after)
    )  # fmt: skip
    flat = x.ravel()
    lefts, rights = (np.hstack((side.reshape(rows, -1), nothing)).ravel() for side in (left, right))

    def share(stretch: Array, pair: tuple[IndexArray, ...]) -> Array:
        apart = flat[pair[1]] - flat[pair[0]]
        return np.where(apart > 0, stretch / np.where(apart > 0, apart, 1.0), 0.0)

    return Cells(left=lefts, right=rights, before=before, after=after, to_left=share(lefts, before), to_right=share(rights, after))
