# SPDX-License-Identifier: Apache-2.0
"""What stands above a curve: its variant, its lines and limits, its axes; at the cursor what is read off.  As many rows as there are."""

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from textual.content import Content

from calc.sheet.text import COMMA, Amount, Text

from ..base_app import BaseApp
from .sight import Sight
from .ticks import stand_below
from .text import fit

if TYPE_CHECKING:
    from .reading import Reading

GAP = "  "


class Legend:
    """Of one sight, with what is read off it if there is a cursor."""

    def __init__(self, app: BaseApp, sight: Sight, reading: "Reading | None" = None) -> None:
        self.app, self.sight, self.reading = app, sight, reading

    def rows(self, width: int, most: int) -> list[Content]:
        """At most so many rows; what matters least is left out first, with a sign where lines are missing."""
        axes = Content.styled(_cut(self._axes(), width), "dim")
        if self.reading is None:
            named = stand_below([str(name) for name in self.sight.curve.names], width)
            parts = [[*self._state()], [*self._names(), *(() if named else self._groups())]]
            if self.sight.curve.names and len(_flow(parts, width)) > most:
                parts = [parts[0], [*self._names(), self._how_to_read()]]
            return self._fitted(parts, axes, width, most)
        state = [*self._state(keys=False), Content.styled(self.app.say(self.reading.at), "bold")]
        for parts, least in (
            ([state, [*self._reads(), *self._chains(), *self._limits()]], 1),  # the limits have their names on their lines
            ([state, [*self._reads()]], 0), ([state, [*self._reads(1)]], 0), ([state, [*self._reads(1, brief=True)]], 0),
            ([state, [*self._reads(0)]], 0), ([state, [*self._reads(0, brief=True)]], 0),
        ):  # fmt: skip
            whole = all(part.cell_length <= width for group in parts for part in group)
            if whole and len(_flow(parts, width)) <= most - least:
                break
        return self._fitted(parts, axes, width, most)

    def _fitted(self, groups: list[list[Content]], axes: Content, width: int, most: int) -> list[Content]:
        """The rows, with the names of the axes at the end of the last one that has room for them."""
        rows = _flow(groups, width)
        for n in range(len(rows) - 1, -1, -1):
            gap = width - axes.cell_length - rows[n].cell_length
            if gap >= 2 and n < most:
                rows[n] = Content.assemble(rows[n], " " * gap, axes)
                break
        else:
            if len(rows) < most:
                rows.append(Content.assemble(" " * (width - axes.cell_length), axes))
        if len(rows) > most:
            rows = [*rows[: most - 1], Content.assemble(rows[most - 1][: width - 2], " …")]
        return rows

    def _axes(self) -> str:
        from calc.sheet.expression import plain

        curve = self.sight.curve
        name, comma, unit = curve.y_label.rpartition(", ")
        up = f"{plain(name)}, {unit}" if comma else plain(curve.y_label)
        return up if curve.names else self.app.say(Text("{y} over {x}", y=up, x=curve.x_label))

    def _state(self, keys: bool = True) -> Iterator[Content]:
        """The variant and the crank angle, with the keys that change them."""
        sight, key, say = self.sight, self.app.shown_key, self.app.say
        if sight.variant:
            yield Content.assemble((key("variant") + " ", "dim"), (sight.variant, "bold"))
        if sight.turns:
            turning = f"{key('crank_back')} {key('crank_on')}"
            how = " " + say(Text("{keys} after {leave}", keys=turning, leave=key("leave"))) if keys else ""
            yield Content.assemble((say(Text("crank at {angle}", angle=Amount(sight.degrees, "°"))), "bold"), (how, "dim"))

    def _names(self) -> Iterator[Content]:
        series = self.sight.series
        if len(series) > 1 or (series and series[0].label):
            for n, one in enumerate(series):
                yield Content.styled(f"{self._mark(n)} {one.label}", self.app.signs.look(n).colour)
        yield from self._chains()
        yield from self._limits()

    def _groups(self) -> Iterator[Content]:
        """The names of groups of bars that have only their numbers below them."""
        for n, name in enumerate(self.sight.curve.names, 1):
            yield Content.assemble((str(n), "bold"), " ", (name, "dim"))

    def _how_to_read(self) -> Content:
        key = self.app.shown_key
        return Content.styled(self.app.say(Text("{keys} name the bars", keys=f"{key('read_back')} {key('read')}")), "dim")

    def _mark(self, n: int) -> str:
        look = self.app.signs.look(n)
        return look.bar_mark if self.sight.curve.bars else look.line_mark

    def _chains(self) -> Iterator[Content]:
        signs, sight = self.app.signs, self.sight
        n = len(sight.series)
        for chain in sight.chains:
            for name, phasor in zip(chain.names, chain.phasors):
                if abs(phasor) > 1e-9 * max(map(abs, chain.phasors)):  # one without length can not be seen
                    yield Content.styled(f"{signs.look(n).line_mark} {name}", signs.look(n).colour)
                n += 1
        if sight.turns:
            yield Content(f"{'@' if signs.ascii else '●'} {self.app.say(Text('their sum'))}")

    def _limits(self) -> Iterator[Content]:
        from .reading import axis, finite_limits

        signs, unit = self.app.signs, axis(self.sight.curve.y_label)[1]
        for name, limit in finite_limits(self.sight.curve):
            yield Content.styled(f"{signs.limit().line_mark} {name} {self.app.say.part(Amount(limit, unit))}", signs.style("fail"))

    def _reads(self, distances: int = 9, *, brief: bool = False) -> Iterator[Content]:
        """What is read, with so many of the distances to limits; the series that was chosen stands out."""
        assert self.reading is not None
        signs = self.app.signs
        for read in self.reading.reads:
            name = f"{self._mark(read.number)} {read.label}".rstrip()
            chosen = read.number == self.reading.chosen
            text = self.app.say(COMMA.join((read.brief if brief else read.value, *read.distances[:distances])))
            yield Content.assemble((name, signs.look(read.number).colour), " ", (text, "bold" if chosen else ""))


def _cut(axes: str, width: int) -> str:
    """The names of the axes.  Where they are too long, what is explained in brackets goes first, and the last unit stays."""
    if len(axes) <= width:
        return axes
    axes = re.sub(r" \([^()]*\)$", "", axes)
    if len(axes) <= width:
        return axes
    head, _, unit = axes.rpartition(", ")
    return f"{fit(head, width - len(unit) - 2)}, {unit}" if head and len(unit) < 12 else fit(axes, width)


def _flow(groups: list[list[Content]], width: int) -> list[Content]:
    """Parts beside each other as long as there is room; each group begins a row of its own."""
    rows: list[Content] = []
    for group in groups:
        row = Content("")
        for part in group:
            part = part if part.cell_length <= width else Content.assemble(part[: width - 1], "…")
            if row.cell_length and row.cell_length + len(GAP) + part.cell_length > width:
                rows.append(row)
                row = Content("")
            row = Content.assemble(row, GAP, part) if row.cell_length else part
        rows += [row] if row.cell_length else []
    return rows
