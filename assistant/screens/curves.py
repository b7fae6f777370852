# SPDX-License-Identifier: Apache-2.0
"""The list of all curves and tables of a step, and a figure as pixels, on a terminal that shows them."""

import base64
import sys
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, ClassVar

import numpy as np
from textual import events
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.screen import ModalScreen
from textual.widgets import Input, OptionList, Static
from textual.widgets.option_list import Option

from calc.locale import Language
from calc.sheet.step import Curve, Table
from calc.sheet.text import COMMA, Text, plural

from ..actions import bound
from ..base_app import BaseApp
from ..output import bare
from ..widgets.line import Line
from ..widgets.text import wrap
from .dialogs import Once

if TYPE_CHECKING:
    from numpy import uint8
    from numpy.typing import NDArray


# --- figures as pixels, on a terminal that shows them
# By the protocol of Kitty, of iTerm2, or as Sixel.  The terminal is known by what it says of itself in the
# environment; nothing is asked of it, since an answer would come as keys.

KITTY, ITERM, SIXEL = "kitty", "iterm2", "sixel"
CHUNK = 4096  # characters of base64 that Kitty takes at a time
SIZE = 520.0, 300.0  # points
LEVELS = 6  # of each of red, green and blue in a Sixel picture: 216 colours


def protocol(environment: Mapping[str, str]) -> str:
    """How this terminal shows pixels; empty where it does not say that it does, or where another program stands
    between."""
    asked = environment.get("CONTRALBERO_PIXELS", "")
    if asked in (KITTY, ITERM, SIXEL):
        return asked
    if environment.get("TMUX") or environment.get("STY") or asked == "none":
        return ""
    terminal, program = environment.get("TERM", ""), environment.get("TERM_PROGRAM", "")
    if "kitty" in terminal or "ghostty" in terminal or program.lower() == "ghostty":
        return KITTY
    if program in ("iTerm.app", "WezTerm"):
        return ITERM
    return SIXEL if terminal.startswith(("foot", "mlterm", "contour", "yaft")) else ""


def kitty(png: bytes) -> Iterator[str]:
    """The picture in pieces, the first of which says that it is a PNG to be shown here."""
    text = base64.standard_b64encode(png).decode()
    pieces = [text[at : at + CHUNK] for at in range(0, len(text), CHUNK)]
    for n, piece in enumerate(pieces):
        start = "f=100,a=T," if n == 0 else ""
        yield f"\x1b_G{start}m={int(n < len(pieces) - 1)};{piece}\x1b\\"


def iterm2(png: bytes) -> Iterator[str]:
    yield f"\x1b]1337;File=inline=1;size={len(png)}:{base64.standard_b64encode(png).decode()}\x07"


def sixel(pixels: "NDArray[uint8]") -> Iterator[str]:
    """Rows of six dots, colour by colour; equal dots that follow each other are counted."""
    step = 255 / (LEVELS - 1)
    levels = np.rint(pixels / step).astype(int)
    index = (levels[:, :, 0] * LEVELS + levels[:, :, 1]) * LEVELS + levels[:, :, 2]
    yield f'\x1bPq"1;1;{pixels.shape[1]};{pixels.shape[0]}'
    for colour in np.unique(index):
        red, rest = divmod(int(colour), LEVELS * LEVELS)
        shares = (round(100 * part / (LEVELS - 1)) for part in (red, *divmod(rest, LEVELS)))
        yield f"#{colour};2;" + ";".join(map(str, shares))
    weights = 2 ** np.arange(6)
    for top in range(0, index.shape[0], 6):
        band = index[top : top + 6]
        for colour in np.unique(band):
            bits = ((band == colour) * weights[: len(band), None]).sum(axis=0)
            ends = np.append(np.flatnonzero(np.diff(bits)) + 1, len(bits))
            counts = np.diff(ends, prepend=0)
            yield (
                f"#{colour}"
                + "".join(f"!{n}{chr(63 + bit)}" for n, bit in zip(counts.tolist(), bits[ends - 1].tolist()))
                + "$"
            )
        yield "-"
    yield "\x1b\\"


def show(curve: Curve, how: str, say: Language) -> None:
    """Write the figure to the terminal, and wait for Enter.  The curve's texts are said in the language already."""
    from reports.figures.pixels import pixels, png

    if how == SIXEL:
        pieces = sixel(pixels(curve, *SIZE, say))
    else:
        pieces = (kitty if how == KITTY else iterm2)(png(curve, *SIZE, say))
    out = bare()
    out.write("\n" + "".join(pieces) + "\n" + say(Text("Enter goes back")) + " ")
    out.flush()
    sys.stdin.readline()


# --- the list of all curves and tables
# Words that are typed find them by their titles.

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
        bound("leave", "cancel"),
        Binding("down", "move(1)", "Down", show=False),
        Binding("up", "move(-1)", "Up", show=False),
        Binding("pagedown", "page(1)", "A screenful down", show=False),
        Binding("pageup", "page(-1)", "A screenful up", show=False),
        bound("save", "app.save"),
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
            yield Line(placeholder=say(Text("words of the title")), compact=True, id="words")
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
        entries: list[Option] = []
        for group, kind in GROUPS:
            if leaves := [leaf for leaf in left if isinstance(leaf, kind)]:
                entries.append(Option(Content.styled(self.app.say(group), "bold"), disabled=True))
                entries += [self._option(leaf, width) for leaf in leaves]
        options.add_options(
            entries
            or [
                Option(
                    Content.styled(self.app.say(Text("Nothing has these words in its title.")), "dim"), disabled=True
                )
            ]
        )
        ids = [option.id for option in entries]
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
