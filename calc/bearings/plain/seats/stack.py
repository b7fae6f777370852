# SPDX-License-Identifier: Apache-2.0
"""What the clearance of one bearing is made of: housing bore, walls, journal."""

from ....countershaft.rows import BearingRow
from ....sheet.record import record, replace
from ....sheet.text import Text
from ....sheet.units import Metre
from ....sheet.value import based_on, untraced
from . import formulas as f
from .classes import Range, Select
from .rings import Rings

# what shells of one wall are called, from the thinnest, as makers mark them with paint
COLOURS = (
    Text("brown"),
    Text("black"),
    Text("blue"),
    Text("green"),
    Text("yellow"),
    Text("red"),
    Text("white"),
    Text("pink"),
    Text("violet"),
    Text("orange"),
)


@record
class SeatStack:
    """Limits of the parts at the reference temperature.  `bore`: of the housing, or as finished; `walls` None: there
    are none between bore and journal, or they do not count.  `pairs`: where they are selected, of each pair of classes
    bore, walls and journal, by the numbers of bore class and journal class from 1."""

    bore: Range
    walls: Range | None
    journal: Range
    pairs: dict[tuple[int, int], tuple[Range, Range, Range]] | None = None

    @property
    def journal_width(self) -> Metre:
        """Of the tolerance of one journal beside the parts that it is picked with."""
        of = [journal for *_, journal in self.pairs.values()] if self.pairs is not None else [self.journal]
        return max(most - least for least, most in of)

    @property
    def shells(self) -> dict[Range, Text]:
        """The walls that are picked, from the thinnest, each with the word for its colour."""
        walls = sorted({wall for _, wall, _ in (self.pairs or {}).values()})
        more = (Text("number {n}", n=n) for n in range(len(COLOURS) + 1, len(walls) + 1))
        return dict(zip(walls, (*COLOURS, *more)))

    def clearances(self, rings: Rings | None) -> Range:
        """Least and most of all parts that may come together, with the least interference for the least."""
        least, most = (None, None) if self.pairs is None else self.governing(rings)
        return self.end(least, rings, 0), self.end(most, rings, 1)

    def governing(self, rings: Rings | None) -> tuple[tuple[int, int], tuple[int, int]]:
        """The pairs of classes with the least and with the most clearance."""
        assert self.pairs is not None
        with untraced():
            every = {pair: self.of_pair(pair, rings) for pair in self.pairs}
        return min(every, key=lambda pair: every[pair][0]), max(every, key=lambda pair: every[pair][1])

    def of_pair(self, pair: tuple[int, int], rings: Rings | None) -> Range:
        """Of one pair of classes, at the middle interference."""
        at_middle = None if rings is None else replace(rings, interference=(rings.middle, rings.middle))
        return self.end(pair, at_middle, 0), self.end(pair, at_middle, 1)

    def end(self, pair: tuple[int, int] | None, rings: Rings | None, most: int) -> Metre:
        """The least clearance of a pair of classes, or of parts that are not sorted; or the `most`."""
        bore, walls, journal = (self.bore, self.walls, self.journal) if pair is None else (self.pairs or {})[pair]
        D, d = based_on(bore[most], bore), based_on(journal[1 - most], journal)
        if walls is None or rings is None:
            direct: Metre = f.clearance_direct(D_b=D, d_J=d)
            return direct
        delta = rings.interference[most]
        with untraced():
            D_m, w_m = (bore[0] + bore[1]) / 2, (walls[0] + walls[1]) / 2
            c = rings.pressed(rings.fit_of(D_m, D_m - 2 * w_m), delta).c
        w = based_on(walls[1 - most], walls)
        c = based_on(c, delta, D, w, rings.outside)
        pressed: Metre = f.clearance_as_pressed(D_b=D, w=w, d_J=d, delta=delta, c_i=c)
        return pressed


def stack_of(row: BearingRow, select: Select | None, rise: Metre = 0.0) -> SeatStack | None:
    """Of a bearing whose clearance its parts make; None where it is given otherwise.  `rise`: by which its seated bore
    stands wider, which walls that are found allow for."""
    if select is not None and row.seat == "shells":
        return _sorted(select, rise)
    if row.journal is None:
        return None
    journal = row.journal[0], row.journal[1]
    if row.finished is not None:
        return SeatStack((row.finished[0], row.finished[1]), None, journal)
    assert row.bore is not None
    walls = None if row.wall is None or not row.ringed else (row.wall[0], row.wall[-1])
    return SeatStack((row.bore[0], row.bore[1]), walls, journal)


def _sorted(select: Select, rise: Metre) -> SeatStack:
    walls, bores, journals = select.walls(rise), select.bores, select.journals
    return SeatStack(
        (bores[0][0], bores[-1][1]), (walls[0][0], walls[-1][1]), (journals[0][0], journals[-1][1]), select.pairs(rise)
    )
