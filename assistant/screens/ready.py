# SPDX-License-Identifier: Apache-2.0
"""The closing page: the drive in one picture and ten numbers, what is assumed, accepted and not verified, and what is
left to do."""

from collections import Counter
from collections.abc import Iterator
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.screen import Screen
from textual.widgets import Static

from calc.countershaft import sketch as shaft
from calc.design.key_results import outside
from calc.design.model import STEPS
from calc.design.unusual import unusual
from calc.engine import sketch as engine
from calc.sheet.check import Check
from calc.sheet.text import COMMA, Amount, Name, Text, plural
from calc.studies.headlines import headline, main_numbers
from calc.studies.ready import OPEN, StepState, ready

from ..base_app import BaseApp
from ..session.places import label_of
from ..session.session import Session
from ..widgets.canvas import draw
from ..widgets.item_list import Item, ItemList
from ..widgets.steps import states_of
from ..widgets.text import fit, pad, wrap
from .dialogs import Once

REPORT, EXPORT, DRIVE = "report", "export", "drive"  # actions that the page gives beside a step's key and a check's id
PICTURE = (90, 14)  # cells of the picture at most
ASSUMED = "assumed"


class Closing(ItemList):
    """The key of an item is that of a step, the id of a check, or ASSUMED."""

    def __init__(self, session: Session) -> None:
        super().__init__(id="closing")
        self.session = session
        self.unfolded = False

    def choose(self, clicked: bool = False) -> None:
        if self.key == ASSUMED:
            self.unfolded = not self.unfolded
            self.rebuild()
        else:
            super().choose(clicked)

    def build(self, width: int) -> list[Item]:
        parts = (self._picture(width), self._numbers(width), self._left(width), *self._said(width))
        return [item for part in parts if part for item in (*part, Item("", [Content("")]))]

    def _picture(self, width: int) -> list[Item]:
        drawn = picture(self.session, min(width, PICTURE[0]), min(PICTURE[1], max(6, self.size.height // 2)), self.app)
        return [Item("", drawn.split("\n"))] if drawn.plain.strip() else []

    def _numbers(self, width: int) -> list[Item]:
        """Words and values in as many columns as there is room for."""
        if self.session.results is None:
            return []
        say = self.app.say
        pairs = [
            (say(word), say(value).replace("→", self.app.signs.mark("then")))
            for word, value in main_numbers(self.session.results)
        ]
        if not pairs:
            return []
        for count in (3, 2, 1):
            deep = -(-len(pairs) // count)
            columns = [pairs[n : n + deep] for n in range(0, len(pairs), deep)]
            cells = [
                (max(len(word) for word, _ in column) + 2, max(len(value) for _, value in column) + 4)
                for column in columns
            ]
            if sum(left + right for left, right in cells) <= width:
                break
        rows = []
        for n in range(deep):
            row = [(*column[n], *size) for column, size in zip(columns, cells) if n < len(column)]
            pieces = [
                piece
                for word, value, left, right in row
                for piece in ((pad(word, left), "dim"), (pad(value, right), "bold"))
            ]
            rows.append(Content.assemble(*pieces))
        return [Item("", rows)]

    def _left(self, width: int) -> list[Item]:
        """A row for every step that is not ready."""
        states = states_of(self.session)
        return [self._step(n, state, width) for n, state in enumerate(states, 1) if not state.done]

    def _step(self, n: int, state: StepState, width: int) -> Item:
        say, style = self.app.say, self.app.signs.style(state.state)
        title, words, results = f"{n} {say(STEPS[n - 1].title)}", say(state.words), self.session.results
        decides = headline(results, state.key) if results is not None and state.state in OPEN else None
        row = Content.assemble(
            (f"{self.app.signs.mark(state.state)} ", style),
            pad(title, 20),
            (pad(words, 24), style),
            (fit(say(decides.text), max(4, width - 46)), "dim") if decides is not None else "",
        )
        return Item(state.key, [row], line=f"{title}: {words}")

    def _said(self, width: int) -> Iterator[list[Item]]:
        """What stands behind the verdict: left out, accepted, not verified, measured, assumed."""
        session, say = self.session, self.app.say
        outcomes = session.results.outcomes.values() if session.results is not None else ()
        checks = [check for outcome in outcomes for check in outcome.checks]
        without = [
            (step, Text("{step}: {reason}", step=_title(step), reason=reason))
            for step, reason in session.design.without
        ]
        yield self._part(Text("left out ({n})", n=len(without)), without, width)
        accepted = [
            (c.id, Text("{check}: {reason}", check=c.name, reason=c.accepted))
            for c in checks
            if c.verdict == "accepted"
        ]
        yield self._part(Text("accepted ({n})", n=len(accepted)), accepted, width)
        unknown: dict[str, list[Check]] = {}  # the keys that are not given → what can not be judged without them
        for check in checks:
            if check.verdict == "not_verified":
                unknown.setdefault(", ".join(check.missing), []).append(check)
        lacking = [
            (
                mine[0].id,
                plural(
                    "{input} is not given: {check}",
                    "{input} is not given: {check} and {more} more",
                    n=len(mine),
                    input=self._labels(mine[0].missing),
                    check=mine[0].name,
                    more=len(mine) - 1,
                ),
            )
            for mine in unknown.values()
        ]
        yield self._part(Text("not verified ({n})", n=sum(map(len, unknown.values()))), lacking, width)
        held = [
            outside(check, outcome.checks)
            for outcome in outcomes
            for check in outcome.checks
            if check.verdict == "pass"
        ]
        # how many hold by a formula that it puts out of its range
        beyond = Counter(method for methods in held for method in methods)
        stretched = [(method.id, Text("{what}: {n} of them", n=n, what=method.name)) for method, n in beyond.items()]
        yield self._part(Text("held by a formula outside its validity ({n})", n=sum(map(bool, held))), stretched, width)
        odd = [(oddity.key.partition(".")[0], oddity.words) for oddity in unusual(session.design, checks=checks)]
        yield self._part(Text("not usual ({n})", n=len(odd)), odd, width)
        values = session.values()
        measured = [
            (
                row.step,
                Text(
                    "{what}: {value}",
                    what=values[row.value].label if row.value in values else self._labels((row.value,)),
                    value=Amount(row.is_, row.unit),
                ),
            )
            for row in session.design.measured
        ]
        yield self._part(Text("measured ({n})", n=len(measured)), measured, width)
        notes = [note for outcome in outcomes if outcome.state == "solved" for note in outcome.notes]
        if notes:
            fold = self.app.signs.mark("unfolded" if self.unfolded else "folded")
            head = Content.styled(f"{say(Text('assumed ({n})', n=len(notes)))} {fold}", "bold")
            rows = (
                [Content(f"{lead}{row}") for note in notes for lead, row in _bulleted(say(note), width)]
                if self.unfolded
                else []
            )
            yield [Item(ASSUMED, [head]), *([Item("", rows)] if rows else [])]

    def _labels(self, keys: tuple[str, ...]) -> Text:
        return COMMA.join(label_of(self.session.data, key) for key in keys)

    def _part(self, title: Text, rows: list[tuple[str, Text]], width: int) -> list[Item]:
        if not rows:
            return []
        head = Item("", [Content.styled(self.app.say(title), "bold")])
        return [
            head,
            *(
                Item(id, [Content(lead + row) for lead, row in _bulleted(self.app.say(text), width)])
                for id, text in rows
            ),
        ]


def _bulleted(text: str, width: int) -> Iterator[tuple[str, str]]:
    for n, row in enumerate(wrap(text, max(8, width - 4))):
        yield ("    " if n else "  · "), row


def _title(step: str) -> Text:
    return next((candidate.title for candidate in STEPS if candidate.key == step), Name(step))


def picture(session: Session, columns: int, rows: int, app: BaseApp) -> Content:
    """The drive as its shaft in its bearings, else as its engine; nothing where neither is solved."""
    results = session.results
    for step, make in (("countershaft", shaft.sketch), ("engine", engine.sketch)):
        if results is not None and results.outcomes[step].state == "solved":
            try:
                return draw(make(results.design, results), columns, rows, app.signs, app.say)
            except Exception:  # a picture that cannot be drawn never stops the work that it shows
                continue
    return Content("")


class ReadyScreen(Once, Screen[str | None]):
    """Gives the key of a step or the id of a check to go to, REPORT or EXPORT, or None."""

    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape,q", "give('')", "Close", show=False),
        Binding("f8,p", f"give('{REPORT}')", "Report", show=False),
        Binding("e", f"give('{EXPORT}')", "Export", show=False),
        Binding("t", f"give('{DRIVE}')", "Whole drive", show=False),
        Binding("enter", "choose", "Go there", show=False),
        Binding("down,j", "move(1)", "Down", show=False),
        Binding("up,k", "move(-1)", "Up", show=False),
    ]

    def __init__(self, session: Session) -> None:
        super().__init__()
        self.session = session

    def compose(self) -> ComposeResult:
        yield Static(id="ready-title")
        yield Closing(self.session)
        keys = Text(
            "{report} report · e export · t better drives · Enter goes there · Esc goes on editing",
            report=self.app.shown_key("report"),
        )
        yield Static(Content.styled(f" {self.app.say(keys)}", "dim"), id="ready-keys")

    def on_mount(self) -> None:
        self.query_one(Closing).focus()

    def on_resize(self) -> None:
        """The design and its verdict at both ends of the first row."""
        say, signs, states = self.app.say, self.app.signs, states_of(self.session)
        done = ready(states)
        if done:
            corners = self.session.results is not None and any(
                c.id.endswith("_corner") for c in self.session.results.checks()
            )
            words = (
                Text("every limit holds, at every corner of the tolerances") if corners else Text("every limit holds")
            )
            if without := [_title(step) for step, _ in self.session.design.without]:
                words = Text("every limit holds; left out: {steps}", steps=COMMA.join(without))
        else:
            left = sum(not state.done for state in states)
            words = plural("{n} step is left", "{n} steps are left", n=left)
        mark = "ready" if done else "todo"
        title = f" {say(Text('Ready'))}: {self.session.design.name}" if done else f" {self.session.design.name}"
        end = Content.assemble((f"{signs.mark(mark)} {say(words)} ", signs.style(mark)))
        start = Content.styled(fit(title, max(8, self.size.width - end.cell_length - 2)), "bold")
        gap = max(1, self.size.width - start.cell_length - end.cell_length)
        self.query_one("#ready-title", Static).update(Content.assemble(start, " " * gap, end))

    def on_item_list_chosen(self, event: ItemList.Chosen) -> None:
        event.stop()
        self.dismiss(event.key)

    def action_give(self, what: str) -> None:
        self.dismiss(what or None)

    def action_choose(self) -> None:
        self.query_one(Closing).choose()

    def action_move(self, by: int) -> None:
        self.query_one(Closing).move(by)
