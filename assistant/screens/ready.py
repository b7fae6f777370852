# SPDX-License-Identifier: Apache-2.0
"""The closing page: the drive in one picture and ten numbers, what is left to do, what stays to shake, what was left
out by whom, and what is assumed, accepted and not verified."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import BindingType
from textual.content import Content
from textual.screen import Screen
from textual.widgets import Static

from calc.countershaft import sketch as shaft
from calc.design.key_results import outside
from calc.design.labels import label_of
from calc.design.model import STEPS
from calc.design.unusual import unusual
from calc.engine import sketch as engine
from calc.sheet.check import Check
from calc.sheet.text import COMMA, EMPTY, SEMICOLON, Amount, Name, Text, plural
from calc.sheet.verdict import findings_of
from calc.studies.described import not_counted
from calc.studies.headlines import closest_limit, felt, headline, main_numbers, remaining
from calc.studies.ready import OF_PROGRAM, SOLVED, StepState

from ..actions import bound
from ..base_app import BaseApp
from ..session.guide import title_of
from ..session.places import named_key
from ..session.session import Session
from ..session.wording import not_repeated
from ..widgets.canvas import draw
from ..widgets.item_list import Item, ItemList
from ..widgets.steps import ready_words, states_of, verdict_of, whole_of
from ..widgets.text import fit, pad, wrap
from .dialogs import Once
from .workbench_panes import WorkbenchPanes

# actions that the page gives beside a step's key and a check's id
KEYS = (
    ("report", Text("PDF")),
    ("export", Text("export")),
    ("save", Text("save")),
    ("drive", Text("drives")),
    ("not_counted", Text("not counted")),
    ("leave", Text("back")),
)
GIVEN = ("report", "export", "drive", "palette", "undo", "redo", "quit")
PICTURE = (90, 14)  # cells of the picture at most
TALL = 30  # rows with room for the picture before the numbers
ASSUMED, NOT_COUNTED, HELD, STRETCHED = FOLDED = "assumed", "not_counted", "held", "stretched"  # what is folded


class Closing(ItemList):
    """The key of an item is that of a step, the id of a check, or of what is folded."""

    def __init__(self, session: Session) -> None:
        super().__init__(id="closing")
        self.session = session
        self.unfolded: set[str] = set()

    @property
    def enter(self) -> Text:
        """What Enter does with the row under the cursor; empty where there is none."""
        if self.key in FOLDED:
            return Text("folds it") if self.key in self.unfolded else Text("unfolds")
        return EMPTY if not self.key else Text("goes there") if "." in self.key else Text("opens it")

    def choose(self, clicked: bool = False) -> None:
        if self.key in FOLDED:
            self.unfolded ^= {self.key}
            self.rebuild()
        else:
            super().choose(clicked)

    def unfold(self, key: str) -> None:
        """Show what is folded there."""
        self.unfolded |= {key}
        self.rebuild()
        self.go_to(key, top=True)

    def build(self, width: int) -> list[Item]:
        said = (self._numbers(width), *self._steps(width), *self._said(width))
        picture = self._picture(width)
        parts = (picture, *said) if self.size.height >= TALL else (*said, picture)  # where room is short, numbers first
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
        for count in (3, 2, 1):
            deep = max(1, -(-len(pairs) // count))
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
        closest = say(closest_limit(self.session.results))
        rows.append(Content.assemble((f"{say(Text('closest limit'))}  ", "dim"), (closest, "bold")))
        return [Item("", rows)]

    def _steps(self, width: int) -> Iterator[list[Item]]:
        """A row for every step that is left, and for every other in which something is open."""
        states = list(enumerate(states_of(self.session), 1))
        left = [(n, state) for n, state in states if not state.done]
        open_ = [(n, state) for n, state in states if state.done and state.colour == "warn"]
        wide = max((len(self.app.say(state.words)) for _, state in left + open_ if state.state in SOLVED), default=0)
        findings = Text("done, with findings ({n})", n=len(open_))
        for title, those in ((whole_of(self.session).words, left), (findings, open_)):
            if those:
                head = Item("", [Content.styled(self.app.say(title), "bold")])
                yield [head, *(self._step(n, state, max(22, wide) + 2, width) for n, state in those)]

    def _step(self, n: int, state: StepState, wide: int, width: int) -> Item:
        """`wide`: the cells of the words."""
        say, style = self.app.say, self.app.signs.style(state.colour)
        title = f"{n} {say(title_of(STEPS[n - 1], self.session.data))}"
        words, results = say(state.words), self.session.results
        decides = headline(results, state.key) if results is not None and state.state in SOLVED else None
        row = Content.assemble(
            (f"{self.app.signs.mark(state.state)} ", style),
            pad(title, 20),
            (pad(words, wide), style),
            (fit(say(decides.text), max(4, width - 22 - wide)), "dim") if decides is not None else "",
        )
        return Item(state.key, [row], line=f"{title}: {words}")

    def _said(self, width: int) -> Iterator[list[Item]]:
        """What stands behind the verdict: left out, accepted, not verified, measured, assumed."""
        session = self.session
        outcomes = session.results.outcomes.values() if session.results is not None else ()
        checks = [check for outcome in outcomes for check in outcome.checks]
        engine, places = session.inherited
        labels = COMMA.join(label_of(session.data, named_key(session.data, place)) for place in places)
        title = plural("{n} value is still {engine}'s", "{n} values are still {engine}'s", n=len(places), engine=engine)
        yield self._part(title, [(str(places[0][0]), labels)] if places else [], width)
        reaches = list(felt(session.results)) if session.results is not None else []
        yield self._part(Text("the driver feels"), reaches, width)
        stays = list(remaining(session.results)) if session.results is not None else []
        yield self._part(Text("stays ({n})", n=len(stays)), stays, width)
        without = [
            (step, Text("{step}, by {whom}: {reason}", step=_title(step), whom=_whom(reason), reason=reason))
            for step, reason in session.design.without
        ]
        yield self._part(Text("left out ({n})", n=len(without)), without, width)
        accepted = [
            (c.id, Text("{check}: {reason}", check=c.name, reason=c.accepted))
            for c in checks
            if c.verdict == "accepted"
        ]
        yield self._part(Text("accepted ({n})", n=len(accepted)), accepted, width)
        unknown: dict[str, list[Check]] = {}  # what is not given → what can not be judged without it
        for check in checks:
            if check.verdict == "not_verified":
                unknown.setdefault(", ".join(_wanting(check)), []).append(check)
        lacking = [
            (
                mine[0].id,
                plural(
                    "{lack}: {check}",
                    "{lack}: {check} and {more} more",
                    n=len(mine),
                    lack=self._lack(mine, {check.id: check.name for check in checks}),
                    check=mine[0].name,
                    more=len(mine) - 1,
                ),
            )
            for mine in _joined(unknown.values())
        ]
        title = Text("not verified: {findings}", findings=findings_of(list(unknown.values())))
        yield self._part(title, lacking, width)
        held = [check for check in checks if check.verdict == "pass"]
        taken = Counter(what for check in held for what in check.taken)
        holding = [("", plural("{what}: {n} check", "{what}: {n} checks", n=n, what=what)) for what, n in taken.items()]
        title = Text("holds by what is assumed ({n})", n=len(holding))
        yield self._folded(HELD, title, holding, width)
        # how many hold by a formula that it puts out of its range
        beyond = Counter(method for check in held for method in outside(check, checks))
        stretched = [
            (method.id, plural("{what}: {n} check", "{what}: {n} checks", n=n, what=method.name))
            for method, n in beyond.items()
        ]
        title = Text("holds outside the validity of a formula ({n})", n=len(stretched))
        yield self._folded(STRETCHED, title, stretched, width)
        odd = [(session.design.step_of(oddity.key), oddity.words) for oddity in unusual(session.design, checks=checks)]
        yield self._part(Text("not usual ({n})", n=len(odd)), odd, width)
        values = session.values()
        measured = [
            (
                session.design.step_of(row.value),
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
        yield self._folded(ASSUMED, Text("assumed ({n})", n=len(notes)), [("", note) for note in notes], width)
        uncounted = [("", text) for text in not_counted(session.design)]
        yield self._folded(NOT_COUNTED, Text("not counted ({n})", n=len(uncounted)), uncounted, width)

    def _folded(self, key: str, title: Text, rows: list[tuple[str, Text]], width: int) -> list[Item]:
        if not rows:
            return []
        unfolded = key in self.unfolded
        mark = self.app.signs.mark("unfolded" if unfolded else "folded")
        head = Content.styled(f"{self.app.say(title)} {mark}", "bold")
        return [Item(key, [head]), *(self._part(title, rows, width)[1:] if unfolded else [])]

    def _lack(self, checks: Sequence[Check], names: Mapping[str, Text]) -> Text:
        """What is not given, and which checks of the method put them outside the validity of their formula."""
        keys = dict.fromkeys(key for check in checks for key in check.missing)
        missing = [Text("{input} is not given", input=self._labels(tuple(keys)))] if keys else []
        ids = dict.fromkeys(method for check in checks for method in check.outside)
        methods = COMMA.join(names.get(method, Name(method)) for method in ids)
        outside = [Text("outside validity, {methods}", methods=methods)] if methods else []
        return SEMICOLON.join([*missing, *outside] or [Text("closer to its limit than can be told")])

    def _labels(self, keys: tuple[str, ...]) -> Text:
        labels = [self.app.say(label_of(self.session.data, key)) for key in keys]
        return COMMA.join(map(Name, not_repeated(labels)))

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


def _joined(groups: Iterable[Sequence[Check]]) -> list[list[Check]]:
    """Those of one step that lack the same, if only in part: it is said once."""
    joined: list[tuple[set[str], list[Check]]] = []
    for group in groups:
        checks, lack = list(group), {check.id.partition(".")[0] + key for check in group for key in _wanting(check)}
        for other in [other for other in joined if other[0] & lack]:
            joined.remove(other)
            checks, lack = [*other[1], *checks], lack | other[0]
        joined.append((lack, checks))
    return [checks for _, checks in joined]


def _wanting(check: Check) -> tuple[str, ...]:
    return (*check.missing, *check.outside)


def _bulleted(text: str, width: int) -> Iterator[tuple[str, str]]:
    for n, row in enumerate(wrap(text, max(8, width - 4))):
        yield ("    " if n else "  · "), row


def _whom(reason: str) -> Text:
    return Text("the program, until you say so in the step") if reason in OF_PROGRAM else Text("you")


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
    """Gives the key of a step or the id of a check to go to, the id of an action, or None.  `work`: the main screen,
    which saves; `unfolded`: what is shown of what is folded."""

    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [
        *(bound(id, "give('')") for id in ("leave", "close")),
        *(bound(id, f"give('{id}')") for id in GIVEN),
        bound("save", "app.save"),
        bound("not_counted", f"unfold('{NOT_COUNTED}')"),
        bound("go_on", "choose"),
        bound("down", "move(1)"),
        bound("up", "move(-1)"),
    ]

    def __init__(self, work: WorkbenchPanes, unfolded: str = "") -> None:
        super().__init__()
        self.work, self.session, self.unfolded = work, work.session, unfolded

    def compose(self) -> ComposeResult:
        yield Static(id="ready-title")
        yield Closing(self.session)
        yield Static(id="ready-keys")

    def show_keys(self) -> None:
        """The last row: what Enter does with the row under the cursor, and the other keys."""
        say, enter = self.app.say, self.query_one(Closing).enter
        shown = [(id, word) for id, word in KEYS if not (id == "drive" and self.work.no_drive())]
        parts = [f"{say(self.app.shown_key(id))} {say(word)}" for id, word in shown]
        parts = [f"{say(self.app.shown_key('go_on'))} {say(enter)}", *parts] if enter else parts
        while len(" · ".join(parts)) > self.size.width - 2 and len(parts) > 2:
            del parts[-2]  # the last leads back
        self.query_one("#ready-keys", Static).update(Content.styled(" " + " · ".join(parts), "dim"), layout=False)

    def on_item_list_moved(self, event: ItemList.Moved) -> None:
        event.stop()
        self.show_keys()

    def on_mount(self) -> None:
        self.query_one(Closing).focus()
        if self.unfolded:
            self.call_after_refresh(self.action_unfold, self.unfolded)

    def on_resize(self) -> None:
        self.show_title()
        self.show_keys()

    def show_title(self) -> None:
        """The design and its verdict at both ends of the first row."""
        say, signs, name = self.app.say, self.app.signs, self.session.design.name
        title = f" {say(Text('Ready'))}: {name}" if whole_of(self.session).ready else f" {name}"
        room = max(8, self.size.width - min(len(title), self.size.width // 5) - 5)
        words = fit(say(ready_words(self.session)), room)
        state, colour, _ = verdict_of(self.session)
        end = Content.assemble((f"{signs.mark(state)} {words} ", signs.style(colour)))
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

    def action_unfold(self, key: str) -> None:
        self.query_one(Closing).unfold(key)

    def action_move(self, by: int) -> None:
        self.query_one(Closing).move(by)
