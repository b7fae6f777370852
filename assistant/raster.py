# SPDX-License-Identifier: Apache-2.0
"""Dots of lines and halves of cells of areas, in a frame of character cells: the arithmetic below the canvas.

A cell is twice as high as wide, and holds 2 by 4 square dots, or two square halves.  Places are in dots, down from the upper left.
"""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Integers = npt.NDArray[np.int64]

BITS = np.array([[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]])  # of the dots of a braille letter
PLAIN = "-|/\\"  # by the direction of a line, where there is no braille
FLAT, STEEP = 0.4, 2.2  # slopes up to which, and from which, a line is drawn as a level or an upright one
CROSSING = 0.6  # a cell where the second direction has this share of the first shows a crossing
UPPER, LOWER = 0x2580, 0x2584  # half blocks


class Raster:
    """`roles`: how each cell of lines is drawn, a higher one over a lower one; `fill`: what is in each half of a cell, 0 nothing."""

    def __init__(self, columns: int, rows: int) -> None:
        self.columns, self.rows = columns, rows
        self.dots = np.zeros((rows * 4, columns * 2), bool)
        self.roles = np.zeros((rows, columns), np.int64)
        self.fill = np.zeros((rows * 2, columns), np.int64)
        self._ways = np.zeros((4, rows, columns), np.int64)

    def lines(self, paths: Sequence[tuple[Floats, int, tuple[float, ...]]]) -> None:
        """Draw paths (corners, role, pattern): a pattern has the lengths in dots that are drawn, left out, drawn …"""
        if not paths:
            return
        starts: list[Floats] = []
        steps: list[Floats] = []
        roles: list[Integers] = []
        ways: list[Floats] = []
        keeps: list[tuple[float, ...]] = []
        for corners, role, pattern in paths:
            pieces = np.diff(corners, axis=0)
            starts.append(corners[:-1])
            steps.append(pieces)
            roles.append(np.full(len(pieces), role))
            length = np.hypot(pieces[:, 0], pieces[:, 1])
            ways.append(np.cumsum(length) - length)
            keeps += [pattern] * len(pieces)
        start, step, kinds, way = np.concatenate(starts), np.concatenate(steps), np.concatenate(roles), np.concatenate(ways)
        count = np.ceil(np.abs(step).max(axis=1)).astype(int) + 1
        of = np.repeat(np.arange(len(count)), count)
        t = (np.arange(len(of)) - np.repeat(np.cumsum(count) - count, count)) / np.maximum(count[of] - 1, 1)
        points = start[of] + t[:, None] * step[of]
        drawn = np.ones(len(of), bool)
        for pattern in {p for p in keeps if p}:
            mine = np.array([p == pattern for p in keeps])[of]
            along = way[of[mine]] + t[mine] * np.hypot(step[:, 0], step[:, 1])[of[mine]]
            drawn[mine] = np.searchsorted(np.cumsum(pattern), along % sum(pattern), side="right") % 2 == 0
        x, y = np.floor(points).astype(int).T
        drawn &= (x >= 0) & (x < self.columns * 2) & (y >= 0) & (y < self.rows * 4)
        x, y, of = x[drawn], y[drawn], of[drawn]
        self.dots[y, x] = True
        np.maximum.at(self.roles, (y // 4, x // 2), kinds[of])
        np.add.at(self._ways, (_direction(step)[of], y // 4, x // 2), 1)

    def area(self, outlines: Sequence[Floats], value: int) -> None:
        """Fill the halves of cells whose middles lie within an odd number of the outlines."""
        start = np.concatenate(outlines) / 2
        end = np.concatenate([np.roll(outline, -1, axis=0) for outline in outlines]) / 2
        middle = np.arange(self.rows * 2) + 0.5
        cut = (start[:, 1, None] <= middle) != (end[:, 1, None] <= middle)
        edge, row = np.nonzero(cut)
        (x0, y0), (x1, y1) = start[edge].T, end[edge].T
        x = x0 + (middle[row] - y0) / (y1 - y0) * (x1 - x0)
        left_of = np.zeros((self.rows * 2, self.columns + 1), np.int64)
        np.add.at(left_of, (row, np.clip(np.ceil(x - 0.5), 0, self.columns).astype(int)), 1)
        crossings = np.cumsum(left_of[:, ::-1], axis=1)[:, ::-1][:, 1:]
        self.fill[crossings % 2 == 1] = value

    def letters(self, plain: bool) -> Integers:
        """The code of each cell's letter: of braille, or plain ones; 0 where no line runs."""
        cells = self.dots.reshape(self.rows, 4, self.columns, 2)
        if not plain:
            bits = np.einsum("ryxd,yd->rx", cells.transpose(0, 1, 2, 3), BITS)
            return np.where(bits > 0, 0x2800 + bits, 0)
        order = np.sort(self._ways, axis=0)
        main = np.array([ord(letter) for letter in PLAIN])[self._ways.argmax(axis=0)]
        few = np.where(cells.any(axis=(1, 3)), ord("."), 0)
        crossing = order[-2] >= np.maximum(2, CROSSING * order[-1])
        return np.where(order[-1] > 1, np.where(crossing, ord("*"), main), few)


def _direction(step: Floats) -> Integers:
    """Of each piece of a line: level, upright, rising or falling."""
    across, down = step.T
    slope = np.abs(down) / np.maximum(np.abs(across), 1e-9)
    leaning = np.where(across * down < 0, 2, 3)
    return np.where(slope < FLAT, 0, np.where(slope > STEEP, 1, leaning))
