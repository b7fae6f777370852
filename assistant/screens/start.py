# SPDX-License-Identifier: Apache-2.0
"""The first screen: the ways to begin, and beside the one under the cursor what it leads to.

Words that are typed find an engine or a design; Enter begins with the row under the cursor."""

from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import ClassVar

from textual import events
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, VerticalScroll
from textual.content import Content
from textual.screen import Screen
from textual.widgets import Input, OptionList, Static
from textual.widgets.option_list import Option
from textual.worker import get_current_worker

from calc.design.model import STEPS
from calc.sheet.errors import BadInput, NoSolution
from calc.sheet.text import EMPTY, Text
from calc.studies.shipped import EXAMPLE

from ..actions import anywhere, bound
from ..base_app import TYPING, BaseApp
from ..session.beginnings import OWN, OWN_WORDS, Beginning, Finding, finding, groups
from ..session.guide import GUIDES
from ..session.recovery import Memory
from ..session.session import Session
from ..widgets.line import Line
from ..widgets.text import fit, folded, match, pad, wrap
from .path_dialogs import OpenDialog, begin_with

# --- about the way to begin that is under the cursor
# What an engine shakes with, what a design comes to.  Found out in another thread.

ABOUT_BEGINNING = {
    "open": Text("A design file, from any folder. Unsaved edits of it that were kept are put back."),
    "example": Text(
        "The counter-shaft of a three-cylinder diesel as it was published, from the engine to the friction. Look at "
        "what fails, and why. Nothing is written before you save, and then under a name of its own."
    ),
    "own": Text(
        "Enter asks for a name. Then bore, stroke, rod, masses, speed and power are asked for, one after the other, "
        "with what is usual; nothing comes from another engine."
    ),
    "engine": Text(
        "Enter asks for a name. Then come balancing, shaft, bearings, gears and friction, one question at a time; "
        "every number of the "
        "engine can be replaced by your own."
    ),
}
UNSOLVED = ("open", "own")  # of which nothing is found out before
ICON = 15, 7  # cells of the sketch at most where it stands beside the text
TALL = 32, 16  # and below it


class BeginDetail(VerticalScroll, can_focus=False):
    app: BaseApp

    def __init__(self, memory: Memory) -> None:
        super().__init__(id="begin-detail")
        self.memory = memory
        self._known: dict[str, Finding] = {}  # by the key of a row
        self._row: Beginning | None = None

    def compose(self) -> ComposeResult:
        yield Static(id="begin-text")
        yield Static(id="begin-sketch")

    def show(self, row: Beginning) -> None:
        self._row = row
        self.scroll_home(animate=False)
        self._draw()
        if row.key not in self._known and row.kind not in UNSOLVED:
            self.run_worker(
                lambda: self._find_out(row), thread=True, exclusive=True, exit_on_error=False, group="begin"
            )

    def tell(self, text: Text) -> None:
        """Something to be said in its place."""
        self._row = None
        self._write([Content.styled(line, "bold") for line in wrap(self.app.say(text), self._room(False))])

    def on_resize(self) -> None:
        self._draw()

    @property
    def wide(self) -> bool:
        """It stands beside the rows, not below them."""
        return self.screen.has_class("-wide")

    def _room(self, sketch: bool) -> int:
        return max(10, self.size.width - 3 - (ICON[0] + 1 if sketch and not self.wide else 0))

    def _draw(self) -> None:
        row, say, wide = self._row, self.app.say, self.wide
        if row is None:
            return
        detail = self._known.get(row.key)
        room = self._room(detail is not None and detail.sketch is not None)
        gap = [Content("")] if wide else []
        lines = [Content.styled(line, "bold") for line in wrap(say(row.title), room)]
        if row.kind in ("engine", "file") and (wide or row.kind == "file"):
            lines += [
                Content(line) for fact in filter(None, (row.about, row.size)) for line in wrap(say(fact), room)
            ] + gap
        about = (
            [Content.styled(line, "dim") for line in wrap(say(ABOUT_BEGINNING[row.kind]), room)]
            if row.kind in ABOUT_BEGINNING
            else []
        )
        if about and row.kind != "engine":
            lines += [*about, *gap]
        if detail is None and row.kind not in UNSOLVED:
            lines.append(Content(self.app.signs.mark("more")))
        for text in detail.lines if detail is not None else ():
            lines += [Content(line) for line in wrap(say(text), room, 2)]
        if row.kind == "engine" and wide:
            lines += [*gap, *about]
        self._write(lines, detail)

    def _write(self, lines: list[Content], detail: Finding | None = None) -> None:
        self.query_one("#begin-text", Static).update(Content("\n").join(lines))
        picture = self.query_one("#begin-sketch", Static)
        picture.display = detail is not None and detail.sketch is not None
        if detail is not None and detail.sketch is not None:
            from ..widgets.canvas import draw

            columns, rows = TALL if self.wide else (ICON[0], max(2, min(ICON[1], self.size.height)))
            columns = min(columns, self.size.width - 3)
            picture.update(draw(detail.sketch, columns, rows, self.app.signs, self.app.say))

    def _find_out(self, row: Beginning) -> None:
        """Runs in another thread."""
        worker = get_current_worker()
        try:
            detail = finding(row, self.memory)
        except BadInput as bad:
            detail = Finding((bad.errors[0].text(bad.place),))
        if not worker.is_cancelled:
            self.app.call_later(self.know, row, detail)

    def know(self, row: Beginning, detail: Finding) -> None:
        self._known[row.key] = detail
        if self._row is row and self.is_attached:
            self._draw()

    def known(self, row: Beginning) -> Finding:
        """What was found out so far."""
        return self._known.get(row.key, Finding(()))


# --- the screen

NOTHING = Text(
    "Nothing is called so. An engine of your own is found by its layout and number: own 4, v 6, boxer 2, radial 5; a "
    "VR is a V of small bank angle."
)
IN_STEP = Text(
    "That is for step {n} of a design, {step}: {question} Begin with an engine, or open a design; {key} finds it there."
)
ENTER = {  # what it does with a row, by its kind
    "open": Text("Enter asks for the file"),
    "example": Text("Enter opens it"),
    "file": Text("Enter opens it"),
}
SPACES = 3  # cells before a row
TITLE, ABOUT, SIZE, SHAKES, BALANCING = 20, 31, 17, 38, 20  # cells of the columns; of what it is at least


class BeginningList(OptionList, can_focus=False):
    """The rows; the place to type keeps the focus."""


class Start(Screen[None]):
    """`missing`: a file that was asked for and is not there, which an engine may begin.  `engines`: the cursor begins
    there."""

    app: BaseApp
    HORIZONTAL_BREAKPOINTS = [(0, "-narrow"), (100, "-wide")]  # noqa: RUF012
    VERTICAL_BREAKPOINTS = [(0, "-low"), (16, "-high")]  # noqa: RUF012
    AUTO_FOCUS = "#words"
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("down", "move(1)", "Down", show=False, priority=True),
        Binding("up", "move(-1)", "Up", show=False, priority=True),
        Binding("pagedown", "page(1)", "A screenful down", show=False, priority=True),
        Binding("pageup", "page(-1)", "A screenful up", show=False, priority=True),
        Binding("ctrl+p", "app.command_palette", "Palette", show=False, priority=True, id=anywhere("palette")),
        Binding("ctrl+o", "open", "Open", show=False, priority=True, id=anywhere("open")),
        Binding("escape", "leave", "Back", show=False, priority=True),
        bound("save", "app.save"),
    ]

    def __init__(self, memory: Memory, missing: Path | None = None, *, engines: bool = False) -> None:
        super().__init__()
        self.memory, self.missing, self.engines = memory, missing, engines
        self._groups: list[tuple[Text, list[Beginning]]] = []
        self._rows: list[Beginning | None] = []  # None: a heading

    def compose(self) -> ComposeResult:
        self.set_class(self.app.ascii, "-ascii")
        say = self.app.say
        self._groups = groups(self.memory, self.missing)
        asks = (
            Text("{name} is not there yet: which engine is it for?", name=self.missing.name)
            if self.missing is not None
            else None
        )
        yield Static(
            Content.assemble(
                (" Contralbero", "bold"), f"   {say(asks or Text('from an engine to a drive that holds'))}"
            ),
            id="start-title",
        )
        yield Line(
            placeholder=say(Text("type to find an engine or a design: own 4, boxer, V-twin …")),
            compact=True,
            id="words",
        )
        with Horizontal(id="start-body"):
            yield BeginningList(id="ways", compact=True)
            yield BeginDetail(self.memory)
        yield Static(id="start-keys")

    def show_keys(self) -> None:
        """What Enter does with the row under the cursor, Esc with what is typed, and the other keys."""
        say, here = self.app.say, self.here
        typed = self.query_one("#words", Input).value
        leaves = Text("goes back") if len(self.app.screen_stack) > 1 else Text("ends")
        hints = [
            ENTER.get(here.kind, Text("Enter begins")) if here is not None else EMPTY,
            Text("↑ ↓ choose"),
            Text("{key} opens a file", key=self.app.shown_key("open")),
            Text("Esc {leaves}", leaves=Text("takes the words away") if typed else leaves),
        ]
        line = " " + "   ".join(say(hint) for hint in hints if hint)
        for row in self.query("#start-keys").results(Static):  # none while the screen is made anew
            row.update(Content.styled(line, "dim"), layout=False)

    def on_mount(self) -> None:
        self.fill()
        self.call_after_refresh(self.app.release, self.app.holding)
        self.set_timer(TYPING, self._look_at_all)

    # --- what shakes, and what balancing it calls for
    def _look_at_all(self) -> None:
        engines = [row for _, rows in self._groups for row in rows if row.kind == "engine"]
        self.run_worker(partial(self._find_all, engines), thread=True, exit_on_error=False, group="engines")

    def _find_all(self, engines: list[Beginning]) -> None:
        """Runs in another thread, which rests while somebody types."""
        worker = get_current_worker()
        for row in engines:
            self.app.rest(self)
            if worker.is_cancelled or not self.is_attached:
                return
            with suppress(BadInput, NoSolution):
                self.app.call_later(self.query_one(BeginDetail).know, row, finding(row, self.memory))
        self.app.call_later(self.fill)

    def on_resize(self, event: events.Resize) -> None:
        self.call_after_refresh(self.fill)

    async def speak(self) -> None:
        """Show everything in the language that the program speaks now."""
        await self.recompose()
        self.fill()
        self.query_one("#words").focus()

    # --- the rows
    @property
    def ways(self) -> BeginningList:
        return self.query_one(BeginningList)

    @property
    def here(self) -> Beginning | None:
        """The row under the cursor."""
        at = self.ways.highlighted
        return self._rows[at] if at is not None and at < len(self._rows) else None

    def fill(self) -> None:
        """The rows that the words find, the best first where there are words."""
        if not self.query(BeginningList):
            return
        before, say = self.here, self.app.say
        words = folded(self.query_one("#words", Input).value).split()
        self._rows = []
        options: list[Option] = []
        width, tall = (
            self.ways.size.width - SPACES - 1,
            self.ways.size.height > sum(len(rows) + 2 for _, rows in self._groups),
        )
        for heading, rows in self._groups:
            ranked = (
                sorted(self._found(words, rows), key=lambda pair: (pair[1].kind != "own", -round(pair[0], 1)))
                if words
                else [(0.0, row) for row in rows if not row.sought]
            )
            if ranked:
                if options and tall:
                    self._rows.append(None)
                    options.append(Option(" ", disabled=True))
                self._rows += [None, *(row for _, row in ranked)]
                options.append(Option(Content.styled(f" {say(heading)}", "bold $primary not dim"), disabled=True))
                options += [Option(self._row(row, width)) for _, row in ranked]
        self.ways.clear_options()
        self.ways.add_options(options)
        stays = not words and before is not None and before in self._rows
        first = next(
            (
                n
                for n, row in enumerate(self._rows)
                if row is not None and (words or not self.engines or row.kind == "own")
            ),
            None,
        )
        self.ways.highlighted = self._rows.index(before) if stays else first
        if not options:
            self.query_one(BeginDetail).tell(self._nothing(words))
        self.show_keys()

    def _nothing(self, words: list[str]) -> Text:
        """What to do where nothing is called so: what the words may mean is asked in a step of a design."""
        say = self.app.say
        for n, step in enumerate(STEPS, 1):
            about = GUIDES[step.key].words
            if match(words, folded(f"{say(step.title)} {say(about)} {about}"))[0]:
                return Text(
                    IN_STEP.template,
                    n=n,
                    step=step.title,
                    question=GUIDES[step.key].question,
                    key=self.app.shown_key("palette"),
                )
        return NOTHING

    def _found(self, words: list[str], rows: list[Beginning]) -> list[tuple[float, Beginning]]:
        scored = [(score, row) for row in rows if (score := self._score(words, row))]
        which = any(row.sought for _, row in scored)  # one of those it is, then
        return [(score, row) for score, row in scored if not (which and row is OWN)]

    def _score(self, words: list[str], row: Beginning) -> float:
        say = self.app.say
        if row.sought:  # a blank engine, whatever it is to burn
            any_engine = folded(f"{say(OWN_WORDS)} {OWN_WORDS}").split()
            words = [word for word in words if word not in any_engine or folded(say(row.title)).startswith(word)]
        return match(words, say(row.title), folded(row.found_by(say)))[0] if words else 0.0

    def _row(self, row: Beginning, width: int) -> Content:
        """In columns where there is room: title, what it is, size, what shakes and the balancing; what is left out
        stands in the detail."""
        say, signs = self.app.say, self.app.signs
        mark = Content.styled(f" {signs.mark('edited')} ", "dim") if row.edited else Content(" " * SPACES)
        detail = self.query_one(BeginDetail).known(row)
        room = width - TITLE - 1
        if room < 8:
            return mark + Content(fit(say(row.title), max(1, width)))
        beside, left = "", room - ABOUT if row.kind == "engine" else 0
        if BALANCING <= left:
            beside = pad(f"  {say(detail.balancing)}", BALANCING)
        if SIZE + SHAKES + BALANCING <= left:
            beside = pad(f"  {say(detail.shakes)}", SHAKES) + beside
        if SIZE + BALANCING <= left:
            beside = f"{say(row.size):>{SIZE}}" + beside
        about = say(row.about)
        if row.kind == "own":  # what tells it from others of its title comes first
            about = about.removeprefix(say(row.title).partition(" ")[2]).lstrip(", ")
        about = pad(about, room - len(beside))
        return Content.assemble(mark, pad(say(row.title), TITLE), (f" {about}{beside}", "dim"))

    def on_option_list_option_highlighted(self, event: OptionList.OptionHighlighted) -> None:
        event.stop()
        if self.here is not None:
            self.query_one(BeginDetail).show(self.here)
        self.show_keys()

    # --- keys
    def on_input_changed(self, event: Input.Changed) -> None:
        event.stop()
        self.fill()

    def action_move(self, by: int) -> None:
        ways = self.ways
        if by > 0:
            ways.action_cursor_down()
        else:
            ways.action_cursor_up()

    def action_page(self, by: int) -> None:
        for _ in range(max(1, self.ways.size.height - 2)):
            at = self.ways.highlighted
            self.action_move(by)
            if (self.ways.highlighted or 0) * by < (at or 0) * by:  # it has come round
                self.ways.highlighted = at
                break

    def action_leave(self) -> None:
        """Esc takes the words away first."""
        words = self.query_one("#words", Input)
        if words.value:
            words.value = ""
        elif len(self.app.screen_stack) > 1:
            self.dismiss()
        else:
            self.app.exit(0)

    def on_input_submitted(self, event: Input.Submitted) -> None:
        event.stop()
        self._begin(self.here)

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        event.stop()
        self._begin(self._rows[event.option_index])

    # --- beginning
    def _begin(self, row: Beginning | None) -> None:
        if row is None:
            return
        if row.kind == "open":
            self.action_open()
        elif row is OWN:
            self._ask_which()
        elif row.kind in ("engine", "own"):
            begin_with(self.app, row, self.missing)
        else:
            self._open(EXAMPLE if row.kind == "example" else Path(row.id))

    def _ask_which(self) -> None:
        """The blank engines, from which words choose."""
        words = self.query_one("#words", Input)
        words.value = "own "
        words.cursor_position = len(words.value)

    def action_open(self) -> None:
        self.app.push_screen(OpenDialog(self.memory, Path.cwd()), self._enter)

    def _open(self, path: Path) -> None:
        try:
            self._enter(Session.open(path, memory=self.memory))
        except BadInput as bad:
            self.query_one(BeginDetail).tell(bad.errors[0].text(bad.place) or EMPTY)

    def _enter(self, session: Session | None) -> None:
        if session is not None:
            self.app.call_later(self.app.enter, session)
