# SPDX-License-Identifier: Apache-2.0
"""Selected fits: journals, bores and shells sorted into classes, and which shell goes with which pair.

Lists of [least, most] in the file's millimetres; inside, in metres, they are `Range`s."""

import math
from collections.abc import Iterable
from itertools import pairwise, product
from typing import Any

from ....sheet.quantity import dotted, inputs, open_, series
from ....sheet.text import Amount, Text
from ....sheet.units import Metre
from ....sheet.value import based_on

Range = tuple[Metre, Metre]

WALL_FIELD: Metre = 4e-6  # of a shell of one class, where the program finds the walls; rule of this program
LEAST_WALL, MOST_WALL = 0.5e-3, 10e-3  # m, as of a bearing's own wall_mm
BOUNDS = {"least": Amount(LEAST_WALL * 1e3), "most": Amount(MOST_WALL * 1e3, "mm")}
PAIRS = Text("a list of pairs of numbers in mm, [[least, most], …], rising and apart")


def _ranges(rows: Any) -> tuple[Range, ...] | None:
    """In metres; None where it is no list of rising pairs that stay apart."""
    if not isinstance(rows, (list, tuple)) or not rows:
        return None
    found = []
    for row in rows:
        if not isinstance(row, (list, tuple)) or len(row) != 2:
            return None
        if any(isinstance(x, bool) or not isinstance(x, (int, float)) or not math.isfinite(x) for x in row):
            return None
        low, high = (x / 1000 for x in row)
        if not 0 < low <= high <= 1:
            return None
        found.append((low, high))
    return None if any(a[1] > b[0] for a, b in pairwise(found)) else tuple(found)


@inputs
class Select:
    """Shells that are picked by the classes of bore and journal."""

    journal_classes_mm: list[Any] = open_(
        "Classes of the journal", help="[[27.987, 27.993], [27.994, 28.0]]: least and most of each, smallest first."
    )
    bore_classes_mm: list[Any] = open_(
        "Classes of the housing's bore", help="[[31.0, 31.008], [31.009, 31.016]]: least and most, smallest first."
    )
    clearance_band: tuple[float, ...] = series(
        "Clearance asked for",
        "µm",
        count=(2, 2),
        within=(0, 5000),
        symbol="g_sel",
        help="Least and most that every pair of classes shall have.",
    )
    walls_mm: list[Any] | None = open_(
        "Walls of the shells",
        default=None,
        help="[[1.484, 1.488], …]: least and most of each, thinnest first. Left out: the program finds them.",
    )
    pick: list[Any] | None = open_(
        "Which shell",
        default=None,
        help="Rows by bore class, columns by journal class: the number of the wall, from 0. Left out: the nearest to "
        "the middle of the clearance.",
    )

    @property
    def journals(self) -> tuple[Range, ...]:
        return _ranges(self.journal_classes_mm) or ()

    @property
    def bores(self) -> tuple[Range, ...]:
        return _ranges(self.bore_classes_mm) or ()

    def walls(self, rise: Metre = 0.0) -> tuple[Range, ...]:
        """As given, else as found.  `rise`: of a seated bore over what housing bore and walls leave."""
        if self.walls_mm is not None:
            return _ranges(self.walls_mm) or ()
        found = found_walls(self.bores, self.journals, self._middle(rise))
        limits = ((_whole_um(w - WALL_FIELD / 2), _whole_um(w + WALL_FIELD / 2)) for w in found)
        return tuple(based_on(wall, self.clearance_band, rise) for wall in limits)

    def _middle(self, rise: Metre) -> Metre:
        """Of the clearance asked for, less what the seated bore adds."""
        return (self.clearance_band[0] + self.clearance_band[-1]) / 2 - rise

    def picked(self, rise: Metre = 0.0) -> tuple[tuple[int, ...], ...]:
        """By bore class and journal class the index of the wall."""
        if self.pick is not None:
            return tuple(tuple(row) for row in self.pick)
        band, walls = self._middle(rise), self.walls(rise)
        wanted = [[(_middle(D) - _middle(d) - band) / 2 for d in self.journals] for D in self.bores]
        return tuple(
            tuple(min(range(len(walls)), key=lambda i: abs(_middle(walls[i]) - w)) for w in row) for row in wanted
        )

    def pairs(self, rise: Metre = 0.0) -> dict[tuple[int, int], tuple[Range, Range, Range]]:
        """By the numbers of bore class and journal class, from 1: bore, wall, journal."""
        picked, walls = self.picked(rise), self.walls(rise)
        return {
            (i + 1, j + 1): (self.bores[i], walls[picked[i][j]], self.journals[j])
            for i, j in product(range(len(self.bores)), range(len(self.journals)))
        }

    def problems(self) -> Iterable[tuple[str, Text]]:
        lists = {
            dotted(Select.journal_classes_mm): self.journal_classes_mm,
            dotted(Select.bore_classes_mm): self.bore_classes_mm,
        }
        if self.walls_mm is not None:
            lists[dotted(Select.walls_mm)] = self.walls_mm
        wrong = [key for key, rows in lists.items() if _ranges(rows) is None]
        for key in wrong:
            yield key, Text("must be {pairs}", pairs=PAIRS)
        if self.clearance_band[0] >= self.clearance_band[-1]:
            yield dotted(Select.clearance_band), Text("least before most")
        elif not wrong and any(low < LEAST_WALL or high > MOST_WALL for low, high in self.walls()):
            key = dotted(Select.clearance_band) if self.walls_mm is None else dotted(Select.walls_mm)
            yield key, Text("must leave walls of {least} to {most} between bore and journal", **BOUNDS)
        if self.pick is not None and not wrong:
            yield from self._pick(self.pick)

    def _pick(self, pick: list[Any]) -> Iterable[tuple[str, Text]]:
        if self.walls_mm is None:
            yield dotted(Select.pick), Text("needs walls_mm, whose numbers it gives")
            return
        rows, columns, walls = len(self.bores), len(self.journals), len(self.walls_mm)
        shape = isinstance(pick, list) and len(pick) == rows
        shape = shape and all(isinstance(row, list) and len(row) == columns for row in pick)
        if not shape or any(type(i) is not int or not 0 <= i < walls for row in pick for i in row):
            must = Text(
                "must be {rows} rows (bore classes) of {columns} numbers (journal classes), each from 0 to {last}",
                rows=str(rows),
                columns=str(columns),
                last=str(walls - 1),
            )
            yield dotted(Select.pick), must


def found_walls(bores: tuple[Range, ...], journals: tuple[Range, ...], band: Metre) -> list[Metre]:
    """Middles of the walls that bring every pair of classes near the middle `band` of the clearance: a pair joins the
    one before while it stands less than half a field above the first of its group."""
    wanted = sorted((_middle(D) - _middle(d) - band) / 2 for D, d in product(bores, journals))
    groups: list[list[Metre]] = []
    for w in wanted:
        if groups and w - groups[-1][0] < WALL_FIELD / 2:
            groups[-1].append(w)
        else:
            groups.append([w])
    return [sum(group) / len(group) for group in groups]


def _whole_um(length: Metre) -> Metre:
    """As it stands on a drawing."""
    return round(length, 6)


def _middle(limits: Range) -> Metre:
    return (limits[0] + limits[1]) / 2
