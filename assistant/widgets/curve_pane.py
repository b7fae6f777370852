# SPDX-License-Identifier: Apache-2.0
"""The curves and the tables of the step, one at a time.  The plotting library is loaded when there is something to plot, never
before the first picture."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.message import Message
from textual.widgets import Static

from calc.sheet.step import Curve, Table

from .item_list import ItemList
from .pane import Pane
from .sight import TURN, Sight
from .table_list import TableList
from .wrap import fit

if TYPE_CHECKING:
    from ..app import ContralberoApp


class CurvePane(Pane, can_focus=True):
    """`variant` and `degrees` hold for all curves that have variants or vectors."""

    app: "ContralberoApp"
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("left", "turn(-1)", "Curve before", show=False),
        Binding("right,space", "turn(1)", "Next curve", show=False),
    ]

    @dataclass
    class Turned(Message):
        """Another curve or table is shown."""

        pane: "CurvePane"

    def __init__(self) -> None:
        self.legend = Static(id="curve-legend")
        self.list = TableList()
        super().__init__("Curve", self.legend, self.list, id="curve")
        self.leaves: tuple[Curve | Table, ...] = ()
        self.chosen: dict[str, str] = {}  # step → id of the curve or the table that was chosen
        self.step = ""
        self.variant = ""  # the name of the variant that was chosen
        self.degrees = 0  # crank angle
        self._plot: Any = None
        self._written: Content | None = None
        self._drawn: tuple[Any, ...] = ()

    def compose(self) -> ComposeResult:
        self.list.display = False
        yield from super().compose()

    # --- what is shown
    def show(self, step: str, leaves: tuple[Curve | Table, ...]) -> None:
        self.step, self.leaves = step, leaves
        self.draw()

    @property
    def target(self) -> "CurvePane | TableList":
        return self.list if self.list.display else self

    @property
    def leaf(self) -> Curve | Table | None:
        wanted = self.chosen.get(self.step)
        return next((c for c in self.leaves if c.id == wanted), self.leaves[0] if self.leaves else None)

    @property
    def curve(self) -> Curve | None:
        return leaf if isinstance(leaf := self.leaf, Curve) else None

    @property
    def sight(self) -> Sight | None:
        return Sight(curve, self.variant, self.degrees) if (curve := self.curve) is not None else None

    def _number(self, leaf: Curve | Table) -> int:
        return next(n for n, other in enumerate(self.leaves) if other is leaf)

    # --- what the keys do
    def action_turn(self, by: int) -> None:
        if self.leaf is not None:
            self.chosen[self.step] = self.leaves[(self._number(self.leaf) + by) % len(self.leaves)].id
            self.post_message(self.Turned(self))
            self.draw()

    def next_variant(self) -> str:
        """Show the next variant of the curve; gives its name, or nothing where there is no other."""
        sight = self.sight
        if sight is None or len(sight.curve.variants) < 2:
            return ""
        self.variant = sight.next_variant
        self.draw()
        return self.variant

    def turn_crank(self, by: int) -> bool:
        """Turn the vectors; False where there are none."""
        sight = self.sight
        if sight is None or not sight.turns:
            return False
        self.degrees = (self.degrees + by * TURN) % 360
        self.draw()
        return True

    # --- drawing
    def on_resize(self) -> None:
        super().on_resize()
        self.draw()

    def draw(self) -> None:
        """Draw what was chosen, if it is not what stands there."""
        leaf = self.leaf
        if not self.is_mounted or not self.display:
            return
        drawn = (leaf, self.variant, self.degrees, self.size, self.app.theme)
        if self._drawn and leaf is self._drawn[0] and drawn[1:] == self._drawn[1:]:
            return
        self._drawn = drawn
        self._arrange(isinstance(leaf, Table))
        count = f"{self._number(leaf) + 1} of {len(self.leaves)}" if leaf is not None and len(self.leaves) > 1 else ""
        if isinstance(leaf, Table):
            self.set_title(leaf.title, count)
            self.list.show(leaf)
            self._head()
        elif leaf is None:
            self.set_title("Curve", "none in this step")
            self._write(Content(""))
        else:
            self.set_title(leaf.title, count)
            self._legend(Sight(leaf, self.variant, self.degrees))
            if self._plot is None:
                from .plot import Plot

                self._plot = Plot()
                self.mount(self._plot)
            self.call_after_refresh(self._fill)
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
        if (sight := self.sight) is not None and self._plot is not None:
            self._plot.draw(sight, self.app.signs)

    def _write(self, made: Content) -> None:
        if self._written is None or not made.is_same(self._written):
            self._written = made
            self.legend.update(made)

    # --- above a curve: what its lines are.  Above a table: its head
    def _legend(self, sight: Sight) -> None:
        width = max(10, self.size.width - 2)
        most = max(2, min(6, self.size.height // 4))
        rows: list[Content] = []
        for group in (self._state(sight), self._names(sight)):
            row = Content("")
            for part in group:
                part = part if part.cell_length <= width else part[: width - 1] + "…"
                if row.cell_length and row.cell_length + 2 + part.cell_length > width:
                    rows.append(row)
                    row = Content("")
                row = Content.assemble(row, "  ", part) if row.cell_length else part
            rows += [row] if row.cell_length else []
        axes = Content.styled(fit(f"{sight.curve.y_label} over {sight.curve.x_label}", width), "dim")
        gap = width - axes.cell_length - (rows[-1].cell_length if rows else 0)
        if rows and gap >= 2:
            rows[-1] = Content.assemble(rows[-1], " " * gap, axes)
        elif not rows or len(rows) < most:
            rows.append(Content.assemble(" " * (width - axes.cell_length), axes))
        if len(rows) > most:
            rows = [*rows[: most - 1], Content.assemble(rows[most - 1][: width - 2], " …")]
        self._write(Content("\n").join(Content.assemble(" ", row) for row in rows))

    def _state(self, sight: Sight) -> Iterator[Content]:
        """The variant and the crank angle, with the keys that change them."""
        if sight.variant:
            yield Content.assemble((self.app.shown_key("variant") + " ", "dim"), (sight.variant, "bold"))
        if sight.turns:
            keys = f" {self.app.shown_key('crank_back')} {self.app.shown_key('crank_on')} after {self.app.shown_key('leave')}"
            yield Content.assemble((f"crank at {sight.degrees}°", "bold"), (keys, "dim"))

    def _names(self, sight: Sight) -> Iterator[Content]:
        signs = self.app.signs
        series = sight.series
        if len(series) > 1 or (series and series[0].label):
            for n, one in enumerate(series):
                look = signs.look(n)
                yield Content.styled(f"{look.bar_mark if sight.curve.bars else look.line_mark} {one.label}", look.colour)
        n = len(series)
        for chain in sight.chains:
            for name, phasor in zip(chain.names, chain.phasors):
                if abs(phasor) > 1e-9 * max(map(abs, chain.phasors)):  # one without length can not be seen
                    yield Content.styled(f"{signs.look(n).line_mark} {name}", signs.look(n).colour)
                n += 1
        if sight.turns:
            yield Content(f"{'@' if signs.ascii else '●'} their sum")
        for name, limit in sight.curve.limits:
            yield Content.styled(f"{signs.limit().line_mark} {name} {limit:.4g}", signs.style("fail"))

    def _head(self) -> None:
        rows = self.list.head
        if self.list.part:
            rows = [Content.styled(f"{self.list.part}, Shift+← → for the others", "dim"), *rows]
        self._write(Content("\n").join(Content.assemble(" ", row) for row in rows))

    def on_item_list_moved(self, event: ItemList.Moved) -> None:
        """The table has been set anew, for another width or with other columns."""
        if event.source is self.list and self.list.display:
            self._head()
