# SPDX-License-Identifier: Apache-2.0
"""How a train rattles with the shifts of a row: what they change of it is its backlash alone."""

from collections.abc import Sequence

from ...sheet.errors import NoSolution
from ...sheet.record import replace
from ...sheet.text import EMPTY, Amount, Text
from ...sheet.units import MetrePerSecond
from ...sheet.value import untraced
from ..drive.bodies import plays_on_line
from ..drive.checks import grade_letter, grade_limits, grade_of
from ..drive.remedies import Workshop
from ..drive.result import IDLE
from ..inputs import GearsInputs
from ..result import TrainResult
from ..solve import at_rest
from .search import ShiftRow


class RattleOfRows:
    """The hardest strike at idle without load of each row, m/s; known only of a design whose drive is solved."""

    def __init__(self, gears: GearsInputs, train: TrainResult | None) -> None:
        drive = train.drive if train is not None else None
        self.gears, self.assumed = gears, drive is not None and drive.assumed
        self._shop = None
        if train is not None and drive is not None and IDLE in drive.at:
            self._shop = Workshop(gears, train, drive)
        self._known: dict[int, MetrePerSecond | None] = {}

    @property
    def known(self) -> bool:
        return self._shop is not None

    def speed(self, row: ShiftRow) -> MetrePerSecond | None:
        """None where the train can not be put together so."""
        if id(row) not in self._known:
            self._known[id(row)] = self._struck(row)
        return self._known[id(row)]

    def _struck(self, row: ShiftRow) -> MetrePerSecond | None:
        if self._shop is None:
            return None
        base = row.freedom.gears if row.freedom is not None else self.gears
        shifts = {name: float(x[0]) for name, x in row.states.shifts.items()} if row.freedom is not None else {}
        wheels = tuple(
            replace(
                w,
                profile_shift=shifts.get(w.name, w.profile_shift),
                tip_shortening=row.cuts.get(w.name, w.tip_shortening),
            )
            for w in base.wheels
        )
        with untraced():
            try:
                train = at_rest(replace(base, wheels=wheels)).solution
            except NoSolution:
                return None
            line = self._shop.now.line
            line = replace(line, play=plays_on_line(train, line))
        return self._shop.hardest(replace(self._shop.now, line=line))

    def cell(self, row: ShiftRow) -> Text:
        """`B 58`."""
        u = self.speed(row)
        if u is None:
            return EMPTY
        return Text("{grade} {u}", grade=grade_letter(grade_of(u)), u=Amount(u * 1e3, form=".0f"))

    def note(self, rows: Sequence[tuple[str, ShiftRow]]) -> Text:
        """What the column says, and which of the rows rattle: a caution that the choice passes over."""
        note = Text("idle: grade of the rattle and hardest strike without load, mm/s.")
        if self.assumed:
            note += Text(" It rests on an assumed irregularity.")
        loud = [number for number, row in rows if (self.speed(row) or 0.0) > grade_limits()[1]]
        if loud:
            note += Text(" C at idle, a caution that is passed over here: {rows}.", rows=", ".join(loud))
        return note
