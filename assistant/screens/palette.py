# SPDX-License-Identifier: Apache-2.0
"""The palette: words in any order find whatever can be done or gone to, in every language of the program.

Its entries, where they lead, and the dialog."""

from collections.abc import Awaitable, Callable, Iterator
from dataclasses import dataclass
from functools import partial
from inspect import isawaitable
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.screen import ModalScreen
from textual.widgets import Input, OptionList, Static
from textual.widgets.option_list import Option

from calc.design.addresses import quantities, step_at, within
from calc.design.model import STEPS, Design
from calc.design.names import choice_word
from calc.locale import LANGUAGES, language
from calc.sheet.quantity import Quantity, keys
from calc.sheet.step import Curve
from calc.sheet.text import EMPTY, Text

from ..actions import ACTIONS, CALLED, bound, key_names
from ..base_app import BaseApp
from ..session.beginnings import OWN, OWN_WORDS, with_engines
from ..session.guide import DOCUMENT, GUIDES, NAME, NOTE
from ..widgets.line import Line
from ..widgets.text import fit, folded, match
from .explain import Explain
from .path_dialogs import begin_with
from .workbench import Workbench

# --- what the palette finds
# Actions, steps, fields, checks, values, curves, engines to begin with, designs, colours and languages.

Does = Callable[[], Awaitable[object] | object]
HIDDEN = {"palette", "up", "down", "go_on", "leave", "close", "more", "less"}  # of no use from a list
HIDDEN |= {action.id for action in ACTIONS if action.id.partition("_")[0] == "read"}
ACTION, FIELD, PLACE, OTHER = 1.0, 0.9, 0.8, 0.7  # what counts more where words find both
FOLDED = 0.8  # of a field that lies in a fold: what decides is found before it


@dataclass(frozen=True)
class PaletteEntry:
    """`title` and `help` in the user's language; `called`: what it is called beside its title; `also`: what else finds
    it; `keys`: those of an action; `first`: shown before a word is typed."""

    title: str
    help: str
    does: Does
    called: str = ""
    also: str = ""
    keys: str = ""
    weight: float = OTHER
    first: bool = False

    def score(self, words: list[str]) -> tuple[float, list[tuple[int, int]]]:
        score, spans = match(words, self.title, self.also)
        if self.called:
            end = len(self.title)
            named, all_spans = match(words, f"{self.title} {self.called}", self.also)
            if named > score:
                score, spans = named, [span for span in all_spans if span[1] <= end]
        return score * self.weight, spans


def entries(app: BaseApp, work: Workbench | None) -> list[PaletteEntry]:
    """Everything that can be found now; `work` is the main screen if a design is open."""
    others = [language(code) for code in LANGUAGES if code != app.say.code]
    rows: list[PaletteEntry] = []

    def add(
        title: Text,
        help: str,
        does: Does,
        *also: str,
        called: Text = EMPTY,
        keys: str = "",
        weight: float = OTHER,
        first: bool = False,
    ) -> None:
        known = folded(" ".join([*(other(title) for other in others), *also]))
        words = folded(" ".join(say(called) for say in (app.say, *others))) if called else ""
        rows.append(PaletteEntry(app.say(title), app.say(help), does, words, known, keys, weight, first))

    for part in (_actions, _designs, _fields, _results, _curves) if work is not None else ():
        part(work, add)  # type: ignore[arg-type]
    _program(app, work is not None, add)
    return rows


Add = Callable[..., None]


def _actions(work: Workbench, add: Add) -> None:
    for action in ACTIONS:
        idle = (action.id == "drive" and work.no_drive()) or (action.id == "fit" and work.no_fit())
        if action.id not in HIDDEN and not idle:
            keys = key_names(work.app.keys_of(action.id)[:2], work.app.say)
            does: Does = partial(work.run_action, action.does)
            called = CALLED.get(action.id, EMPTY)
            if action.call[:1] == ("to_step",):
                step = STEPS[action.call[1] - 1]
                does, called = partial(work.land, step), GUIDES[step.key].words
            add(
                action.title,
                action.help,
                does,
                action.id.replace("_", " "),
                action.help,
                called=called,
                keys=keys,
                weight=ACTION,
                first=True,
            )


def _designs(work: Workbench, add: Add) -> None:
    for kept in work.session.put_aside():
        title = Text("Put back unsaved edits of {when}", when=work.session.when(kept))
        add(
            title,
            Text("Edits of this file that another session has kept."),
            partial(work.restore, kept),
            first=True,
        )
    for path in work.session.memory.recent():
        if path != work.session.path:
            title = Text("Open recent: {path}", path=str(path))
            add(title, Text("Opens this design again."), partial(work.open_path, path), first=True)


def _fields(work: Workbench, add: Add) -> None:
    for key, about in (*_of_design(), *quantities(work.session.data)):
        title = Text("Field: {label}  {key}", label=about.label, key=key)
        in_step = ".".join([step_at(work.session.data, key), *within(key)])  # as schema 1 had it
        does = partial(work.to_field, work.session.place(key))
        weight = FIELD * FOLDED if about.fold and not about.decides else FIELD
        choices = (f"{work.app.say(choice_word(choice))} {choice}" for choice in about.choices)
        add(title, about.help or about.allowed(), does, in_step, *choices, weight=weight)


def _of_design() -> Iterator[tuple[str, Quantity]]:
    """What is asked with the first step: name, note and document control of the design."""
    design_keys = keys(Design)
    for (top,) in (NAME, NOTE, DOCUMENT):
        about = design_keys[str(top)].about
        if about.table is None:
            yield str(top), about
        else:
            yield from (
                (f"{top}.{key}", field.about) for key, field in keys(about.table).items() if field.about.table is None
            )


def _results(work: Workbench, add: Add) -> None:
    steps = {step.key: step for step in STEPS}
    for check in work.session.results.checks() if work.session.results is not None else ():
        add(
            Text("Check: {name}", name=check.name),
            Text("Goes to this check."),
            partial(work.to_check, steps[check.id.partition(".")[0]], check.id),
            check.id,
            weight=PLACE,
        )
    for id, value in work.session.values().items():
        title = Text("Value: {label}  {key}", label=value.label, key=id)
        add(title, Text("Walks back through its formulas to the inputs."), partial(explain, work, id))


def _curves(work: Workbench, add: Add) -> None:
    for n, step in enumerate(STEPS, 1):
        page = work.pages.get(step.key)
        for leaf in page.leaves if page is not None else ():
            title = (
                Text("Curve: {title}", title=leaf.title)
                if isinstance(leaf, Curve)
                else Text("Table: {title}", title=leaf.title)
            )
            add(
                title,
                Text("In step {n}, {title}.", n=n, title=step.title),
                partial(to_curve, work, n, leaf.id),
                weight=PLACE,
            )


def _program(app: BaseApp, open: bool, add: Add) -> None:
    for row in with_engines():
        if row is OWN:
            begin = partial(app.begin, engines=True)
            add(Text("New: own engine …"), row.about, begin, called=OWN_WORDS, weight=ACTION)
            continue
        if row.kind == "own":
            title = Text("New: own {what}", what=row.about)
        else:
            title = Text("New from {engine}: {what}", engine=row.title, what=row.about)
        found_by = (row.found_by(language(code)) for code in LANGUAGES)
        add(title, Text("Begins a design with this engine."), partial(begin_with, app, row), *found_by, "engine motore")
    for name in app.available_themes:
        does = partial(setattr, app, "theme", name)
        add(
            Text("Theme: {name}", name=name),
            Text("Other colours; ansi-dark and ansi-light take those of the terminal"),
            does,
        )
    for code, name in LANGUAGES.items():
        if code != app.say.code:
            title, help = Text("Language: {name}", name=name), Text("The session in this language")
            add(title, help, partial(app.speak, code), "language lingua", first=True)
    if not open:
        add(Text("Quit"), Text("Ends the program."), app.action_quit, "exit", weight=ACTION, first=True)


# --- where they lead


def explain(work: Workbench, id: str) -> None:
    async def to_value(key: str | None) -> None:
        if key is not None:
            await work.to_value(key)

    work.app.push_screen(Explain(work.session, value=id), to_value)


async def to_curve(work: Workbench, n: int, id: str) -> None:
    await work.action_to_step(n)
    work.curve_pane.choose(id)
    work.action_to_view("curve")


# --- the dialog

MOST = 60  # rows


class PaletteHit(OptionList, can_focus=False):
    """The rows; the place to type keeps the focus."""


class Palette(ModalScreen[None]):
    app: BaseApp
    HOLDS = True  # keys that follow Enter or Escape are for where it leads
    AUTO_FOCUS = "#words"
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "leave", "Back", show=False, priority=True),
        Binding("down", "move(1)", "Down", show=False, priority=True),
        Binding("up", "move(-1)", "Up", show=False, priority=True),
        Binding("pagedown", "move(10)", "A screenful down", show=False, priority=True),
        Binding("pageup", "move(-10)", "A screenful up", show=False, priority=True),
        bound("save", "app.save"),
    ]

    def __init__(self) -> None:
        super().__init__()
        self._entries: list[PaletteEntry] = []
        self.rows: list[PaletteEntry] = []
        self._words = ""  # for which the rows are
        self._ending = False

    def compose(self) -> ComposeResult:
        self.set_class(self.app.ascii, "-ascii")
        work = next((screen for screen in self.app.screen_stack if isinstance(screen, Workbench)), None)
        self._entries = entries(self.app, work)
        with Vertical(classes="dialog", id="palette"):
            yield Line(
                placeholder=self.app.say(Text("what to do, or where to go: words in any order")),
                compact=True,
                id="words",
            )
            yield PaletteHit(id="found", compact=True)
            yield Static("", id="palette-help")

    def on_mount(self) -> None:
        self.fill()
        self.call_after_refresh(self.app.release, self.app.holding)

    def on_resize(self) -> None:
        self.call_after_refresh(self.fill)

    # --- rows
    def fill(self) -> None:
        """The best first; without words, what can be done."""
        self._words = self.query_one("#words", Input).value
        words = folded(self._words).split()
        if words:
            scored = [(*entry.score(words), entry) for entry in self._entries]
            best = sorted((candidate for candidate in scored if candidate[0] > 0), key=lambda candidate: -candidate[0])[
                :MOST
            ]
        else:
            best = [(1.0, [], entry) for entry in self._entries if entry.first]
        self.rows = [entry for _, _, entry in best]
        hits = self.query_one(PaletteHit)
        width = max(8, hits.size.width - 3)
        hits.clear_options()
        hits.add_options([Option(self._row(entry, spans, width)) for _, spans, entry in best])
        hits.highlighted = 0 if self.rows else None
        self._show_help()

    def _row(self, entry: PaletteEntry, spans: list[tuple[int, int]], width: int) -> Content:
        keys = f"  {entry.keys}" if entry.keys and len(entry.title) + len(entry.keys) + 2 <= width else ""
        title = Content(fit(entry.title, width - len(keys)))
        for start, end in spans:
            title = title.stylize("bold underline", start, min(end, len(title)))
        return Content.assemble(" ", title, " " * max(0, width - len(title) - len(keys)), (keys, "dim"))

    def _show_help(self) -> None:
        at = self.query_one(PaletteHit).highlighted
        help_text = (
            self.rows[at].help
            if at is not None and at < len(self.rows)
            else self.app.say(Text("Nothing has these words."))
        )
        self.query_one("#palette-help", Static).update(Content.styled(help_text, "dim"))

    def on_option_list_option_highlighted(self, event: OptionList.OptionHighlighted) -> None:
        event.stop()
        self._show_help()

    def on_input_changed(self, event: Input.Changed) -> None:
        event.stop()
        self.fill()

    # --- keys
    def action_move(self, by: int) -> None:
        hits = self.query_one(PaletteHit)
        if self.rows and hits.highlighted is not None:
            hits.highlighted = max(0, min(len(self.rows) - 1, hits.highlighted + by))

    def action_leave(self) -> None:
        self._end()

    def on_input_submitted(self, event: Input.Submitted) -> None:
        event.stop()
        if event.value != self._words:  # Enter came before the rows of the last letters
            self.fill()
        at = self.query_one(PaletteHit).highlighted
        if at is None:
            self.app.release(self.app.holding)
        else:
            self._end(self.rows[at])

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        event.stop()
        self._end(self.rows[event.option_index])

    def _end(self, entry: PaletteEntry | None = None) -> None:
        """Close, once, and run what was chosen."""
        if self._ending:
            return
        self._ending = True
        app, hold = self.app, self.app.holding

        async def run() -> None:
            try:
                if entry is not None:
                    result = entry.does()
                    if isawaitable(result):
                        await result
            finally:
                app.call_after_refresh(app.call_after_refresh, app.release, hold)  # the focus is where it leads

        self.dismiss()
        app.call_later(run)
