# SPDX-License-Identifier: Apache-2.0
"""The list of all curves and tables of a step: words that are typed find them by their titles."""

from typing import ClassVar

from textual import events
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.screen import ModalScreen
from textual.widgets import Input, OptionList, Static
from textual.widgets.option_list import Option

from calc.sheet.step import Curve, Table
from calc.sheet.text import COMMA, Text, plural

from ..base_app import BaseApp
from ..widgets.text import wrap
from .dialogs import Once
from .host import Host
from .moves import Moves

EDGES = 12  # rows of the dialog that are not the list
SIDES = 10  # cells of the dialog that are not a row of the list
GROUPS = ((Text("Curves"), Curve), (Text("Tables"), Table))


def found(leaves: tuple[Curve | Table, ...], typed: str) -> list[Curve | Table]:
    """Those whose titles have every word, wherever it stands."""
    words = typed.casefold().split()
    return [leaf for leaf in leaves if all(word in leaf.title.casefold() for word in words)]


class CurveList(Once, ModalScreen[str | None]):
    """Gives the id of what was chosen.  The words are typed and the list is moved through without a change of the
    focus."""

    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "cancel", "Back", show=False),
        Binding("down", "move(1)", "Down", show=False),
        Binding("up", "move(-1)", "Up", show=False),
        Binding("pagedown", "page(1)", "A screenful down", show=False),
        Binding("pageup", "page(-1)", "A screenful up", show=False),
    ]

    def __init__(self, step: str, leaves: tuple[Curve | Table, ...], current: str) -> None:
        super().__init__()
        self.step, self.leaves, self.current = step, leaves, current

    def compose(self) -> ComposeResult:
        self.set_class(self.app.ascii, "-ascii")
        say = self.app.say
        curves = sum(isinstance(leaf, Curve) for leaf in self.leaves)
        tables = len(self.leaves) - curves
        listed = COMMA.join((plural("{n} curve", "{n} curves", n=curves), plural("{n} table", "{n} tables", n=tables)))
        with Vertical(classes="dialog"):
            yield Static(Content.styled(f"{self.step}: {say(listed)}", "bold"))
            yield Input(placeholder=say(Text("words of the title")), compact=True, id="words")
            yield OptionList(id="leaves", compact=True)
            yield Static(Content.styled(say(Text("Enter shows it, ↑ ↓ choose, Esc goes back")), "dim"))

    def on_mount(self) -> None:
        self.query_one("#words", Input).focus()
        self.fill()

    def on_resize(self) -> None:
        self.fill()

    @property
    def options(self) -> OptionList:
        return self.query_one("#leaves", OptionList)

    def fill(self) -> None:
        """What is found, curves and tables apart; the cursor on what is shown, else on the first."""
        options, left = self.options, found(self.leaves, self.query_one("#words", Input).value)
        options.styles.max_height = max(3, self.app.size.height - EDGES)
        width = max(20, min(110, self.app.size.width * 9 // 10) - SIDES)
        options.clear_options()
        made: list[Option] = []
        for group, kind in GROUPS:
            if own := [leaf for leaf in left if isinstance(leaf, kind)]:
                made.append(Option(Content.styled(self.app.say(group), "bold"), disabled=True))
                made += [self._option(leaf, width) for leaf in own]
        options.add_options(
            made
            or [
                Option(
                    Content.styled(self.app.say(Text("Nothing has these words in its title.")), "dim"), disabled=True
                )
            ]
        )
        ids = [option.id for option in made]
        known = [id for id in ids if id is not None]
        options.highlighted = ids.index(self.current if self.current in known else known[0]) if known else None

    def _option(self, leaf: Curve | Table, width: int) -> Option:
        """A title with its number, and a sign at the one that is shown."""
        number = next(n for n, other in enumerate(self.leaves, 1) if other is leaf)
        here = self.app.signs.mark("cursor") if leaf.id == self.current else " "
        rows = wrap(f"{here}{number:3} {leaf.title}", width, 5)
        return Option(Content("\n").join(map(Content, rows)), id=leaf.id)

    # --- typing and moving
    def on_input_changed(self, event: Input.Changed) -> None:
        event.stop()
        self.fill()

    def on_input_submitted(self, event: Input.Submitted) -> None:
        event.stop()
        at = self.options.highlighted
        if at is not None:
            self.dismiss(self.options.get_option_at_index(at).id)

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        event.stop()
        self.dismiss(event.option_id)

    def on_click(self, event: events.Click) -> None:
        if event.widget is self:
            self.dismiss(None)

    def action_move(self, by: int) -> None:
        self.options.action_cursor_down() if by > 0 else self.options.action_cursor_up()

    def action_page(self, by: int) -> None:
        self.options.action_page_down() if by > 0 else self.options.action_page_up()  # type: ignore[no-untyped-call]

    def action_cancel(self) -> None:
        self.dismiss(None)


# Actions in the pane of curves and tables.

NO_PIXELS = Text(
    "P draws the curve in pixels, as Kitty, iTerm2, WezTerm, foot and others can; "
    "this terminal does not say that it does, so nothing was drawn."
)


class CurveActions:
    def __init__(self, host: Host, moves: Moves) -> None:
        self._host, self._moves = host, moves

    # --- which curve, and what of it
    def turn_curve(self, by: int) -> None:
        host, pane = self._host, self._host.curve_pane
        if pane.leaves and not pane.display:  # first the one that stands there, which has not been seen
            self._moves.to_view("curve")
            return
        if len(pane.leaves) < 2:
            host.app.tell(Text("This step has no other curve.") if pane.leaves else Text("This step has no curve."))
        pane.action_turn(by)

    def curves(self) -> None:
        """The list of all curves and tables of the step."""

        host, pane = self._host, self._host.curve_pane
        if not pane.leaves or pane.leaf is None:
            host.app.tell(Text("This step has no curve."))
            return

        def choose(id: str | None) -> None:
            if id is not None:
                pane.choose(id)
                self._moves.to_view("curve")

        host.app.push_screen(
            CurveList(f"{host.number} {host.app.say(host.step.title)}", pane.leaves, pane.leaf.id), choose
        )

    def pixels(self) -> None:
        """The curve as the report has it, on a terminal that shows pixels."""
        import os

        from textual.app import SuspendNotSupported

        from ..widgets.pixels import protocol, show

        host, curve = self._host, self._host.curve_pane.curve
        how = protocol(os.environ)
        if curve is None or not how:
            host.app.tell(Text("This step has no curve.") if curve is None else NO_PIXELS)
            return
        try:
            with host.app.suspend():
                show(curve, how, host.app.say)
        except SuspendNotSupported:
            host.app.tell(NO_PIXELS)

    def read(self, by: int, fine: bool = False) -> None:
        """Move the cursor of a curve, or the columns of a table."""
        host, pane = self._host, self._host.curve_pane
        if host.focused is pane:
            pane.read(by, fine)
        elif host.focused is pane.list:
            pane.list.columns(by)

    def read_end(self, last: bool) -> None:
        pane = self._host.curve_pane
        if self._host.focused is pane:
            pane.read_end(last)

    def variant(self) -> None:
        host, pane = self._host, self._host.curve_pane
        shown = pane.next_variant()
        if not shown:
            host.app.tell(Text("This curve has one variant only."))
        elif not pane.display:
            host.app.tell(Text("The curve is shown {shown}.", shown=shown))

    def crank(self, by: int) -> None:
        """Turn the vectors that turn with the crank, in steps."""
        if not self._host.curve_pane.turn_crank(by):
            self._host.app.tell(Text("This curve has no vectors that turn with the crank."))
