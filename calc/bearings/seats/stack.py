# SPDX-License-Identifier: Apache-2.0
"""What the clearance of one bearing is made of: housing bore, walls, journal."""

from ...countershaft.rows import BearingRow
from ...sheet.record import record
from ...sheet.units import Metre
from ...sheet.value import based_on
from . import formulas as f
from .classes import Range, Select
from .rings import Rings


@record
class Stack:
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

    def clearances(self, rings: Rings | None) -> Range:
        """Least and most of all parts that may come together, with the least interference for the least."""
        if self.pairs is None:
            return self._of(self.bore, self.walls, self.journal, rings, selected=False)
        every = [self._of(*pair, rings, selected=True) for pair in self.pairs.values()]
        return min(least for least, _ in every), max(most for _, most in every)

    def of_pair(self, pair: tuple[int, int], rings: Rings | None) -> Range:
        assert self.pairs is not None
        return self._of(*self.pairs[pair], rings, selected=True)

    def _of(self, bore: Range, walls: Range | None, journal: Range, rings: Rings | None, *, selected: bool) -> Range:
        if walls is None or rings is None:
            least, most = (
                f.clearance_direct(D_b=based_on(D, self.bore), d_J=based_on(d, self.journal))
                for D, d in ((bore[0], journal[1]), (bore[1], journal[0]))
            )
            return least, most
        ends = (rings.middle, rings.middle) if selected else rings.interference
        g = []
        D_m, w_m = (bore[0] + bore[1]) / 2, (walls[0] + walls[1]) / 2
        fit = rings.fit_of(D_m, D_m - 2 * w_m)
        for D, w, d, delta in zip(bore, reversed(walls), reversed(journal), ends):
            g.append(f.clearance_as_pressed(D_b=D, w=w, d_J=d, delta=delta, c_i=rings.pressed(fit, delta).c))
        return g[0], g[1]


def stack_of(row: BearingRow, select: Select | None, rise: Metre = 0.0) -> Stack | None:
    """Of a bearing whose clearance its parts make; None where it is given otherwise.  `rise`: by which its seated bore
    stands wider, which walls that are found allow for."""
    if select is not None and row.seat == "shells":
        return _sorted(select, rise)
    if row.journal is None:
        return None
    journal = row.journal[0], row.journal[1]
    if row.finished is not None:
        return Stack((row.finished[0], row.finished[1]), None, journal)
    assert row.bore is not None
    walls = None if row.wall is None or not row.ringed else (row.wall[0], row.wall[-1])
    return Stack((row.bore[0], row.bore[1]), walls, journal)


def _sorted(select: Select, rise: Metre) -> Stack:
    walls, bores, journals = select.walls(rise), select.bores, select.journals
    return Stack(
        (bores[0][0], bores[-1][1]), (walls[0][0], walls[-1][1]), (journals[0][0], journals[-1][1]), select.pairs(rise)
    )
