# SPDX-License-Identifier: Apache-2.0
"""The curves and the tables of the step, one at a time, under a legend, in a pane with a title.

The plotting library is loaded when there is something to plot, never before the first picture."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from textual import events
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.message import Message
from textual.widgets import Static

from calc.locale.language import in_language
from calc.sheet.step import Curve, Table
from calc.sheet.text import COMMA, Amount, Text

from ..base_app import BaseApp
from .curve_view import TURN, Cursor, Sight, stand_below
from .item_list import ItemList
from .pane import Pane
from .residual_strip import PLAIN_POINT, POINT
from .table_list import TableList
from .text import fit

if TYPE_CHECKING:
    from .reading import Reader, Reading


# --- what stands above a curve
# Its variant, its lines and limits, its axes; at the cursor what is read off.  As many rows as there are.

GAP = "  "


class Legend:
    """Of one sight, with what is read off it if there is a cursor."""

    def __init__(self, app: BaseApp, sight: Sight, reading: "Reading | None" = None, walks: bool = False) -> None:
        self.app, self.sight, self.reading, self.walks = app, sight, reading, walks

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
            (
                [state, [*self._reads(), *self._chains(), *self._limits()]],
                1,
            ),  # the limits have their names on their lines
            ([state, [*self._reads()]], 0),
            ([state, [*self._reads(1)]], 0),
            ([state, [*self._reads(1, brief=True)]], 0),
            ([state, [*self._reads(0)]], 0),
            ([state, [*self._reads(0, brief=True)]], 0),
        ):
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
        """The variant and the crank angle, with the keys that change them; those that walk."""
        sight, key, say = self.sight, self.app.shown_key, self.app.say
        if self.walks and keys:
            words = Text(
                "{keys} after {leave}: other speeds, {key} other loads",
                keys=f"{key('walk_back')} {key('walk_on')}",
                leave=key("leave"),
                key=key("variant"),
            )
            yield Content.styled(say(words), "dim")
        if sight.variant:
            yield Content.assemble((key("variant") + " ", "dim"), (sight.variant, "bold"))
        if sight.turns:
            turning = f"{key('crank_back')} {key('crank_on')}"
            how = " " + say(Text("{keys} after {leave}", keys=turning, leave=key("leave"))) if keys else ""
            yield Content.assemble(
                (say(Text("crank at {angle}", angle=Amount(sight.degrees, "°"))), "bold"), (how, "dim")
            )

    def _names(self) -> Iterator[Content]:
        series = self.sight.series
        if len(series) > 1 or (series and series[0].label):
            for n, line in enumerate(series):
                yield Content.styled(f"{self._mark(n)} {line.label}", self.app.signs.look(n, self.sight.series).colour)
        if (points := self.sight.curve.measured) is not None:
            yield Content(f"{PLAIN_POINT if self.app.signs.ascii else POINT} {points.label}")
        yield from self._chains()
        yield from self._limits()

    def _groups(self) -> Iterator[Content]:
        """The names of groups of bars that have only their numbers below them."""
        for n, name in enumerate(self.sight.curve.names, 1):
            yield Content.assemble((str(n), "bold"), " ", (name, "dim"))

    def _how_to_read(self) -> Content:
        key = self.app.shown_key
        return Content.styled(
            self.app.say(Text("{keys} name the bars", keys=f"{key('read_back')} {key('read')}")), "dim"
        )

    def _mark(self, n: int) -> str:
        look = self.app.signs.look(n, self.sight.series)
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
            yield Content.styled(
                f"{signs.limit().line_mark} {name} {self.app.say.part(Amount(limit, unit))}", signs.style("fail")
            )

    def _reads(self, distances: int = 9, *, brief: bool = False) -> Iterator[Content]:
        """What is read, with so many of the distances to limits; the series that was chosen stands out."""
        assert self.reading is not None
        signs = self.app.signs
        for read in self.reading.reads:
            name = f"{self._mark(read.number)} {read.label}".rstrip()
            chosen = read.number == self.reading.chosen
            text = self.app.say(COMMA.join((read.brief if brief else read.value, *read.distances[:distances])))
            yield Content.assemble(
                (name, signs.look(read.number, self.sight.series).colour), " ", (text, "bold" if chosen else "")
            )


def _cut(axes: str, width: int) -> str:
    """The names of the axes.  Where they are too long, what is explained in brackets goes first, and the last unit
    stays."""
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


# --- the pane of curves and tables


class CurvePane(Pane, can_focus=True):
    """`variant` and `degrees` hold for all curves that have variants or vectors; `cursor` for the curve that is shown,
    as long as it is."""

    app: BaseApp
    whole: ClassVar[bool] = True
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("space", "turn(1)", "Next curve", show=False),
    ]

    @dataclass
    class Turned(Message):
        """Another curve or table is shown."""

        pane: "CurvePane"

    def __init__(self) -> None:
        self.legend = Static(id="curve-legend")
        self.list = TableList()
        self.strip = Static(id="residuals")
        super().__init__(Text("Curve"), self.legend, self.list, self.strip, id="curve")
        self.leaves: tuple[Curve | Table, ...] = ()
        self.chosen: dict[str, str] = {}  # step → id of the curve or the table that was chosen
        self.step = ""
        self.variant = ""  # the name of the variant that was chosen
        self.degrees = 0  # crank angle
        self.walked: dict[str, tuple[int, int]] = {}  # step and stack of a curve → where it was walked to
        self._there: tuple[Curve, tuple[int, int], Curve] | None = None
        self.pending = False
        self.cursor: Cursor | None = None
        self._plot: Any = None
        self._written: Content | None = None
        self._drawn: tuple[Any, ...] = ()

    def compose(self) -> ComposeResult:
        self.list.display = self.strip.display = False
        yield from super().compose()

    # --- what is shown
    def show(self, step: str, leaves: tuple[Curve | Table, ...], pending: bool = False) -> None:
        """Other curves and tables; where the same one is shown as before, with other numbers, its cursor stays at its
        place.

        `pending`: they are still being written out.
        """
        self.pending = pending
        before = self.step, self.leaf.id if self.leaf is not None else ""
        self.step, self.leaves = step, leaves
        if before != (step, self.leaf.id if self.leaf is not None else ""):
            self.cursor = None
        self.draw()

    @property
    def target(self) -> "CurvePane | TableList":
        # the list of a table before is still there
        return self.list if self.list.display and isinstance(self.leaf, Table) else self

    @property
    def leaf(self) -> Curve | Table | None:
        wanted = self.chosen.get(self.step)
        return next((c for c in self.leaves if c.id == wanted), self.leaves[0] if self.leaves else None)

    @property
    def curve(self) -> Curve | None:
        """The one that was chosen; one that is walked, where it was walked to."""
        leaf = self.leaf
        if not isinstance(leaf, Curve) or leaf.walk is None:
            return leaf if isinstance(leaf, Curve) else None
        at = self.walked.get(self._way(leaf), leaf.walk.here)
        if at == leaf.walk.here or not (at[0] < leaf.walk.steps and at[1] < leaf.walk.rows):
            return leaf
        if self._there is None or self._there[0] is not leaf or self._there[1] != at:
            self._there = leaf, at, in_language(leaf.walk.at(*at), self.app.say)
        return self._there[2]

    @property
    def walks(self) -> bool:
        """Whether it can be shown at other points."""
        return isinstance(leaf := self.leaf, Curve) and leaf.walk is not None

    def _way(self, leaf: Curve) -> str:
        return f"{self.step}.{leaf.stack}"

    @property
    def sight(self) -> Sight | None:
        return Sight(curve, self.variant, self.degrees) if (curve := self.curve) is not None else None

    def _number(self, leaf: Curve | Table) -> int:
        return next(n for n, other in enumerate(self.leaves) if other is leaf)

    # --- what the keys do
    def action_turn(self, by: int) -> None:
        if self.leaf is not None:
            self.choose(self.leaves[(self._number(self.leaf) + by) % len(self.leaves)].id)

    def choose(self, id: str) -> None:
        """Show one of the curves and tables of the step."""
        if self.leaf is not None and id != self.leaf.id:
            self.cursor = None
        self.chosen[self.step] = id
        self.post_message(self.Turned(self))
        self.draw()

    def next_variant(self) -> str:
        """Show the next variant of the curve, of one that is walked the next row; gives its name, or nothing where
        there is no other."""
        if self.walk(0, 1) and (curve := self.curve) is not None:
            return curve.title
        sight = self.sight
        if sight is None or len(sight.curve.variants) < 2:
            return ""
        self.variant = sight.next_variant
        self.draw()
        return self.variant

    def walk(self, by: int, rows: int = 0) -> bool:
        """Show the curve at a further point, or in another row; False where it is at no other."""
        leaf = self.leaf
        if not isinstance(leaf, Curve) or leaf.walk is None or (rows and leaf.walk.rows < 2):
            return False
        walk = leaf.walk
        step, row = self.walked.get(self._way(leaf), walk.here)
        self.walked[self._way(leaf)] = min(max(step + by, 0), walk.steps - 1), (row + rows) % walk.rows
        self.draw()
        return True

    def turn_crank(self, by: int) -> bool:
        """Turn the vectors; False where there are none."""
        sight = self.sight
        if sight is None or not sight.turns:
            return False
        self.degrees = (self.degrees + by * TURN) % 360
        self.draw()
        return True

    # --- the cursor
    @property
    def _reader(self) -> "Reader | None":
        """Reads the curve; None where there is nothing to be read."""
        from .reading import Reader

        reader = Reader(sight) if (sight := self.sight) is not None else None
        return reader if reader is not None and reader.kind else None

    @property
    def reading(self) -> "Reading | None":
        """What is read at the cursor."""
        if self.cursor is None or (reader := self._reader) is None:
            return None
        return reader.read(self.cursor)

    def read(self, by: int, fine: bool = False) -> None:
        """Move the cursor; the first time it appears."""
        if (reader := self._reader) is not None:
            self._put(reader.start() if self.cursor is None else reader.moved(self.cursor, by, fine))

    def read_end(self, last: bool) -> None:
        """To the first or the last place."""
        if (reader := self._reader) is not None:
            self._put(reader.ended(reader.kept(self.cursor or reader.start()), last))

    def read_line(self, by: int) -> None:
        """Choose another series at the cursor."""
        if self.cursor is not None and (reader := self._reader) is not None:
            self._put(reader.other(reader.kept(self.cursor), by))

    def put_away(self) -> bool:
        """Take the cursor away; False where there is none."""
        if self.cursor is None or self.curve is None:
            return False
        self._put(None)
        return True

    def _put(self, cursor: Cursor | None) -> None:
        self.cursor = cursor
        self.draw()

    def _point(self, event: events.MouseEvent) -> None:
        """Put the cursor where the mouse points to, if that is into the frame of a curve."""
        plot = self._plot
        if plot is None or not plot.display or (reader := self._reader) is None:
            return
        if (place := plot.pointed_at(event.screen_x, event.screen_y)) is not None:
            self._put(reader.nearest(*place))

    def on_click(self, event: events.Click) -> None:
        self._point(event)

    def on_mouse_move(self, event: events.MouseMove) -> None:
        if event.button:
            self._point(event)

    # --- drawing
    def on_resize(self) -> None:
        super().on_resize()
        self.draw()

    def draw(self) -> None:
        """Draw what was chosen, if it is not what stands there."""
        leaf = self.leaf
        if not self.is_mounted or not self.display:
            return
        curve = self.curve
        drawn = (leaf, curve, self.variant, self.degrees, self.cursor, self.size, self.app.theme, self.pending)
        if self._drawn and leaf is self._drawn[0] and curve is self._drawn[1] and drawn[2:] == self._drawn[2:]:
            return
        self._drawn = drawn
        self._arrange(isinstance(leaf, Table))
        key, say, lists = self.app.shown_key, self.app.say, self.app.shown_key("curves")
        count = (
            say(Text("{n} of {count}", n=self._number(leaf) + 1, count=len(self.leaves)))
            if leaf is not None and len(self.leaves) > 1
            else ""
        )
        all_ = say(Text("{key} lists all", key=lists))
        if isinstance(leaf, Table):
            self.set_title(leaf.title, f"{count} · {all_}" if count else "")
            self.list.show(leaf)
            self._head()
        elif curve is None:
            self.set_title(
                Text("Curve"), say(Text("is being written out …")) if self.pending else say(Text("none in this step"))
            )
            self._write(Content(""))
        else:
            hints = (
                count,
                say(Text("{keys} reads it", keys=f"{key('read_back')} {key('read')}")),
                all_ if count else "",
            )
            self.set_title(curve.title, " · ".join(filter(None, hints)))
            self._legend(Sight(curve, self.variant, self.degrees))
            if self._plot is None:
                from .plot import Plot

                self._plot = Plot()
                self._plot.strip = self.strip
                self.mount(self._plot, before=self.strip)
            self.call_after_refresh(self._fill)
        self.strip.display = curve is not None and curve.measured is not None
        if self._plot is not None:
            self._plot.display = isinstance(leaf, Curve)

    def _arrange(self, table: bool) -> None:
        """The list for a table, the plot for a curve; the focus goes from one to the other."""
        if not table and self.list.has_focus:
            self.screen.set_focus(self)
        self.list.display = table
        if table and self.has_focus:
            self.screen.set_focus(self.list)

    def _fill(self) -> None:
        if (sight := self.sight) is not None and self._plot is not None and self._plot.is_attached:
            self._plot.draw(sight, self.app.signs, self.reading)

    def _write(self, content: Content) -> None:
        if self._written is None or not content.is_same(self._written):
            self._written = content
            self.legend.update(content)

    # --- above a curve: what its lines are, or what is read off them.  Above a table: its head
    def _legend(self, sight: Sight) -> None:
        """A quarter of the height; what is read may take a row more."""
        reading = self.reading
        most = max(2, min(6, self.size.height // 4)) + (reading is not None)
        rows = Legend(self.app, sight, reading, self.walks).rows(max(10, self.size.width - 2), min(6, most))
        self._write(Content("\n").join(Content.assemble(" ", row) for row in rows))

    def _head(self) -> None:
        rows = self.list.head
        if self.list.part:
            rows = [
                Content.styled(self.app.say(Text("{columns}, ← → for the others", columns=self.list.part)), "dim"),
                *rows,
            ]
        self._write(Content("\n").join(Content.assemble(" ", row) for row in rows))

    def on_item_list_moved(self, event: ItemList.Moved) -> None:
        """The table has been set anew, for another width or with other columns."""
        if event.source is self.list and self.list.display:
            self._head()
