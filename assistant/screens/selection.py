# SPDX-License-Identifier: Apache-2.0
"""Choosing from a ranked table: the search that fills it, the list of its rows, and the dialog.

The search runs aside and can be stopped; of the row under the cursor the whole design is solved before it is taken, so
that its price in the other steps is seen."""

import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import islice
from typing import TYPE_CHECKING, ClassVar, Generic, TypeVar

from textual import events, work
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.message import Message
from textual.screen import ModalScreen
from textual.widgets import Static
from textual.worker import get_current_worker

from calc.design.addresses import Table as Data
from calc.design.addresses import value_at
from calc.design.labels import label_of
from calc.design.locks import locked
from calc.design.model import OPTIONAL, STEPS, TITLES
from calc.design.names import words as words_of
from calc.design.toml_file import design
from calc.locale.language import in_language
from calc.sheet.errors import BadInput, Cancelled, NoSolution
from calc.sheet.progress import Progress, part
from calc.sheet.remedy import Changes, assignments
from calc.sheet.step import OF_SHAFTS
from calc.sheet.text import EMPTY, SEMICOLON, Text, plural
from calc.studies.repair.effects import SideEffects, side_effects
from calc.studies.repair.nearest import NearestRemedy, remedy
from calc.studies.repair.options import QUICK

from ..actions import bound
from ..base_app import BaseApp
from ..offers import NOTHING, Offer, offer, with_nearest
from ..session.compare_with import Chosen
from ..session.editing import applied, held_words, locked_text, told
from ..session.session import Session
from ..session.solving import Answer, Job, mistake, run
from ..widgets.item_list import Item, ItemList
from ..widgets.table_list import Setter
from ..widgets.text import fit, wrap
from .compare import TAKEN, CompareScreen
from .dialogs import Once

if TYPE_CHECKING:
    from calc.solve import Results


# --- a dialog whose rows a long search finds in another thread
# How far it is, what it gives, and what each row does to every step.

Taken = TypeVar("Taken")
Found = TypeVar("Found")


def mistakes_text(bad: BadInput, data: Data) -> Text:
    """Every mistake with the label of its field, in one row."""
    return SEMICOLON.join(
        Text("{key}: {reason}", key=label_of(data, e.key), reason=e.reason) if e.key else e.reason for e in bad.errors
    )


SOON, SURE = 3.0, 0.05  # s, and the share of a search, before which nothing is said of the time that is left


def time_left(seconds: float, share: float) -> Text:
    """About how long a search still takes that came so far in so many seconds; empty where nobody can know yet."""
    if seconds < SOON or not SURE <= share < 1:
        return EMPTY
    left = seconds * (1 - share) / share
    if left >= 90:
        return Text("about {n} min left", n=round(left / 60))
    return Text("about {n} s left", n=max(1, round(left) if left < 10 else 5 * round(left / 5)))


class Searching(Once, ModalScreen[Taken], Generic[Taken, Found]):
    """Gives what was chosen.  `STATE`: the row that tells the search; `BAR`: cells of its progress; `BEHIND`: what
    stands behind that."""

    app: BaseApp
    session: Session
    STATE: ClassVar[str]
    BAR: ClassVar[int]
    BEHIND: ClassVar[Text] = EMPTY
    BINDINGS: ClassVar[list[BindingType]] = [
        bound("leave", "leave"),
        bound("save", "app.save"),
        bound("close", "leave"),
        bound("down", "move(1)"),
        bound("up", "move(-1)"),
    ]

    def __init__(self) -> None:
        super().__init__()
        self.searching = False
        self._begun = 0.0
        self._round = 0  # what an earlier search still sends is dropped

    # --- what a dialog says for itself
    def search(self, progress: Progress) -> Iterator[Found]:
        """What there is, one after the other; runs in another thread."""
        raise NotImplementedError

    def show_found(self, result: Found) -> None:
        raise NotImplementedError

    def show_end(self, failure: Text) -> None:
        """The search is over; `failure`: why it gave nothing, or no more."""
        raise NotImplementedError

    @property
    def room(self) -> int:
        """Cells of a row."""
        raise NotImplementedError

    # --- searching
    def begin(self) -> None:
        """Search, from the start again if need be."""
        self.searching = True
        self._begun = time.monotonic()
        self._round += 1
        self.show_state(self.app.say(Text("searching …")))
        self._search(self._round)

    @work(thread=True, exclusive=True, group="search", exit_on_error=False)
    def _search(self, number: int) -> None:
        worker = get_current_worker()

        def progress(share: float, what: str) -> None:
            if worker.is_cancelled:
                raise Cancelled
            self.call_later(self._progressed, number, share, what)

        failure = EMPTY
        try:
            for result in self.search(progress):
                self.call_later(self._found, number, result)
        except Cancelled:
            return
        except BadInput as bad:
            failure = mistakes_text(bad, self.session.data)
        except NoSolution as none:
            failure = none.text
        except Exception as error:  # a mistake of the program must not take the user's work with it
            failure = mistake(error)
        self.call_later(self._ended, number, failure)

    def _progressed(self, number: int, share: float, what: str) -> None:
        if number != self._round:
            return
        full, empty = ("#", ".") if self.app.ascii else ("█", "░")
        done, say = round(share * self.BAR), self.app.say
        bar = f"{full * done}{empty * (self.BAR - done)} {share:4.0%}"
        left = say(time_left(time.monotonic() - self._begun, share))
        told = [f"{say(Text('searching …'))}  {bar}", say(what), left, say(self.BEHIND)]
        self.show_state("  ".join(filter(None, told[:2])) + "".join(f"   {text}" for text in told[2:] if text))

    def _found(self, number: int, result: Found) -> None:
        if number == self._round:
            self.show_found(result)

    def _ended(self, number: int, failure: Text) -> None:
        if number == self._round:
            self.searching = False
            self.show_end(failure)

    def show_state(self, text: str) -> None:
        self.query_one(f"#{self.STATE}", Static).update(Content(text))

    # --- the row under the cursor
    def verdict_rows(self, verdicts: Iterable[tuple[str, str, str]], then: str) -> list[Content]:
        """For each step its verdict now, and as it would `then` be, side by side as far as there is room."""
        say, signs = self.app.say, self.app.signs
        rows, row = [], Content("")
        for key, was, now in verdicts:
            if key in OPTIONAL and was == now == "not_asked":
                continue
            arrow = f"{signs.mark(was)} {say(then)} " if was != now else ""
            part = Content.assemble(
                f"{say(TITLES[key])} {arrow}", (f"{signs.mark(now)} {signs.word(now)}", signs.style(now))
            )
            if row.cell_length + part.cell_length + 3 > self.room:
                rows.append(row)
                row = Content("")
            row = Content.assemble(row, "   " if row else "", part)
        return [*rows, row]

    def compare(self, name: Text, changes: Iterable[str], take: Callable[[], object]) -> None:
        """The design now → with a row taken; Enter there takes it."""
        document = applied(self.session.document, changes)
        row = Chosen(name, name, document.data, design(document))

        def done(result: str | None) -> None:
            if result == TAKEN:
                take()

        self.app.push_screen(CompareScreen(self.session, row, on=True), done)

    # --- what the keys do
    def action_move(self, by: int) -> None:
        self.query_one(ItemList).move(by)

    def action_leave(self) -> None:
        """Stops a search that is going on."""
        self.workers.cancel_node(self)
        self.dismiss(None)


# --- the ranked tables of an offer, below each other
# Each numbered row can be taken.

TOP = 40  # rows of a table
# rows of a screen from which there is room for prose beside a table, and for all of the row under the cursor
TALL = 30


class OfferList(ItemList):
    """The key of an item is the number of its row.  What can not be taken has no key."""

    BINDINGS: ClassVar[list[BindingType]] = [
        *ItemList.BINDINGS,
        Binding("shift+right", "columns(1)", "Columns to the right", show=False),
        Binding("shift+left", "columns(-1)", "Columns to the left", show=False),
    ]

    def __init__(self) -> None:
        super().__init__(id="offer-list")
        self.offer: Offer | None = None
        self._column = 1
        self._tall = True

    def on_resize(self, event: events.Resize) -> None:
        super().on_resize(event)
        if self._tall != (self.app.size.height >= TALL):
            self.rebuild()
        if self.cursor >= 0:  # what stands below it has grown
            self.call_after_refresh(lambda: self._move(self.cursor))

    def show(self, offer: Offer) -> None:
        self.offer = offer
        self.rebuild()

    def build(self, width: int) -> list[Item]:
        if (offer := self.offer) is None:
            return []
        items: list[Item] = []
        say = self.app.say
        self._tall = self.app.size.height >= TALL
        summary = [Item("", [Content(row) for row in wrap(say(words), width)]) for words in offer.summary]
        last, taken = 1, set[str]()
        for n, table in enumerate(in_language(raw_table, say) for raw_table in (offer.table(TOP), *offer.beside(TOP))):
            set_ = Setter(table, width, say, self._column)
            last = max(last, set_.last)
            part = say(Text("   ({columns}; Shift+→ ←)", columns=set_.part)) if set_.part else ""
            title = [Content.styled(row, "bold") for row in wrap(f"{table.title}{part}", width)]
            items.append(Item("", [Content(""), *title] if n else title))
            if not n and self._tall:
                items += summary
            items.append(Item("", set_.head()))
            numbered = bool(table.columns) and table.columns[0][0] == say(Text("no."))
            rows = set_.items()
            for item, cells in zip(rows, table.rows):
                first = cells[0] if numbered else None
                key = (
                    f"{first:g}"
                    if isinstance(first, (int, float))
                    else first
                    if isinstance(first, str) and first.isdigit()
                    else ""
                )
                items.append(Item("" if key in taken else key, item.rows, item.value, item.line))
                taken.add(key)
            items += [Item("", item.rows) for item in rows[len(table.rows) :]]
        if not self._tall:  # one came for the rows
            items += [Item("", [Content("")]), *summary]
        for text in ((offer.hidden(TOP),) if offer.hidden(TOP) else ()) + offer.notes:
            items.append(Item("", [Content.styled(row, "dim") for row in wrap(f"· {say(text)}", width, 2)]))
        self._column = min(self._column, last)
        return items

    def action_columns(self, by: int) -> None:
        """Leaf through the columns of tables that are too wide."""
        self._column = max(1, self._column + by)
        self.rebuild()


# --- the dialog of an offer

HINT = Text("Enter takes the row · ↑ ↓ rows · {compare} compares now → row · Esc back")


NAMED, FIRST = 8, 5  # changes of a row that are told one by one, and how many of more


@dataclass(frozen=True)
class Preview:
    """A row, as changes of keys, and what the whole design then gives; or why it can not be taken."""

    number: int
    changes: tuple[str, ...] = ()
    results: "Results | None" = None
    why: Text = EMPTY
    words: Text = EMPTY  # the changes, in the labels of the fields
    shut: Text = EMPTY  # what is locked that it would change
    side: SideEffects | None = None

    @property
    def warns(self) -> Text:
        """What it breaks and opens; empty where nothing, or where it can not be taken."""
        return self.side.words if self.side is not None else EMPTY


def _refused(preview: Preview) -> Text:
    return Text("Row {n} can not be taken: {reason}", n=preview.number, reason=preview.why)


class Choosing(Searching[tuple[str, ...] | None, Offer]):
    """Gives the changes of the row that was taken, as KEY=VALUE."""

    STATE, BAR, BEHIND = "choosing-state", 30, Text("Esc stops")
    BINDINGS: ClassVar[list[BindingType]] = [
        bound("go_on", "take"),
        bound("copy", "copy('value')"),
        bound("copy_line", "copy('line')"),
        bound("compare", "compare"),
    ]

    @dataclass
    class Previewed(Message):
        preview: Preview

    def __init__(self, session: Session, step: str, nearest: NearestRemedy | None = None) -> None:
        """`nearest`: the remedy of the step, where it is known."""
        super().__init__()
        self.session, self.step, self.nearest = session, step, nearest
        self.offer: Offer | None = None
        self.previews: dict[int, Preview] = {}
        self._solving = 0  # the row that is being solved
        self._wanted = 0  # the row on which Enter was pressed before it was solved

    def compose(self) -> ComposeResult:
        with Vertical(classes="dialog -tall -whole"):
            yield Static(Content.styled(self.app.say(self.headline), "bold"), id="choosing-title")
            yield Static(id="choosing-state")
            yield OfferList()
            yield Static(id="choosing-preview")
            yield Static(
                Content.styled(self.app.say(Text(HINT.template, compare=self.app.shown_letter("compare"))), "dim")
            )

    @property
    def headline(self) -> Text:
        return TITLES[self.step]

    def on_mount(self) -> None:
        self.query_one(OfferList).focus()
        self.begin()

    def show_state(self, text: str) -> None:
        super().show_state(text)
        self.query_one("#choosing-state").display = bool(text)

    @property
    def room(self) -> int:
        return max(20, self.app.size.width - 8)

    # --- searching
    def search(self, progress: Progress) -> Iterator[Offer]:
        session, step = self.session, self.step
        document, known = session.document, session.results if session.current else None
        nearest, begun = self.nearest, 0.0
        if nearest is None and known is not None and known.outcomes[step].verdict in ("fail", "no_solution"):
            nearest, begun = remedy(document, step, known, part(progress, 0.0, 0.3), tries=QUICK), 0.3
        shaft = session.original if step in OF_SHAFTS and session.original in session.design.originals else None
        try:
            result = offer(
                step,
                session.design,
                session.name,
                part(progress, begun, 1.0),
                shaft=shaft,
                results=known,
                held=lambda key: locked(document.data, key),
            )
        except NoSolution as none:
            if nearest is None or not nearest.mends:
                raise
            result = replace(NOTHING, notes=(Text("Nothing else to choose: {reason}", reason=none.text),))
        if nearest is not None and nearest.mends:
            result = with_nearest(result, nearest)
        shut = held_words(document, step)
        result = replace(result, summary=(*result.summary, *([shut] if shut else [])))
        # made here: some solve once more, for which the screen must neither wait nor end
        table, beside = result.table(TOP), result.beside(TOP)
        yield replace(result, table=lambda top: table, beside=lambda top: beside)

    def show_found(self, result: Offer) -> None:
        self.offer = result
        self.query_one(OfferList).show(result)
        self.query_one(OfferList).focus()

    def show_end(self, failure: Text) -> None:
        self.show_state(self.app.say(Text("Nothing to choose: {reason}", reason=failure)) if failure else "")

    # --- the row under the cursor
    @property
    def number(self) -> int:
        key = self.query_one(OfferList).key
        return int(key) if key else 0

    def on_item_list_moved(self, event: ItemList.Moved) -> None:
        event.stop()
        if self.offer is None or not self.number:
            return
        if self._wanted != self.number:
            self._wanted = 0
        if (known := self.previews.get(self.number)) is not None:
            self._show(known)
        elif self._solving != self.number:
            self._solving = self.number
            self._solve_aside(self.number)

    @work(thread=True, exclusive=True, group="preview", exit_on_error=False)
    def _solve_aside(self, number: int) -> None:
        """That of the next row which is not known stops this one."""
        worker = get_current_worker()
        preview = self.previewed(number, lambda: worker.is_cancelled)
        if not worker.is_cancelled:
            self.post_message(self.Previewed(preview))

    def previewed(self, number: int, stop: Callable[[], bool] = bool) -> Preview:
        """The whole design with a row taken; runs in any thread."""
        assert self.offer is not None
        try:
            keys = self.offer.keys(number)
            changes = tuple(assignments(keys))
            trial = design(applied(self.session.document, changes))
        except NoSolution as none:
            return Preview(number, why=none.text)
        except BadInput as bad:
            return Preview(number, why=mistakes_text(bad, self.session.data))
        except Exception as error:  # a mistake of the program must not take the user's work with it
            return Preview(number, why=mistake(error))
        before = self.session.results
        answer: Answer = run(Job(0, trial, before, stop))
        shut, words = locked_text(self.session.document, changes), self._words(keys)
        if answer.results is None or before is None or not self.session.current:
            return Preview(number, changes, answer.results, answer.failure, words, shut)
        return Preview(number, changes, answer.results, EMPTY, words, shut, side_effects(before, answer.results))

    def _words(self, keys: Changes) -> Text:
        """As remedies say it; of elements that only the changes make, by their keys."""
        document, results = self.session.document, self.session.results
        try:
            different = {key: value for key, value in keys.items() if value_at(document.data, key) != value}
            if results is None:
                return told(document, assignments(keys))
            given = {key: value for key, value in different.items() if value is not None}
            n = len(given) - FIRST if len(given) > NAMED else 0
            shown = dict(islice(given.items(), FIRST)) if n else different
            words = words_of(document, results, shown) if shown else EMPTY
        except BadInput:
            return told(document, assignments(keys))
        if not n:
            return words
        return plural("{changes} and {n} more input", "{changes} and {n} more inputs", n=n, changes=words)

    def on_choosing_previewed(self, event: Previewed) -> None:
        event.stop()
        self.previews[event.preview.number] = event.preview
        self._solving = 0
        if event.preview.number == self.number:
            self._show(event.preview)
            if self._wanted == self.number:
                self._wanted = 0
                self._take(event.preview, warned=False)

    def _show(self, preview: Preview) -> None:
        """What the row changes, and the verdicts of all six steps with it."""
        rows: list[Content] = []
        say = self.app.say
        if preview.results is None:
            rows = [Content(row) for row in wrap(say(_refused(preview)), self.room)]
        else:
            changes = preview.words or Text("the design as it is")
            text = Text("Row {n}: {changes}", n=preview.number, changes=changes)
            rows = [Content(row) for row in self._clipped(say(text).replace("→", self.app.signs.mark("then")), 2)]
            most = 2 if self.app.size.height >= TALL else 1
            for what, state in ((preview.shut, "blocked"), (preview.warns, self._colour(preview))):
                if what:
                    words = say(Text("Row {n}: {what}", n=preview.number, what=what))
                    lines = self._clipped(f"{self.app.signs.mark(state)} {words}", most)
                    rows += [Content.styled(row, self.app.signs.style(state)) for row in lines]
            rows += self._verdicts(preview.results)
        self.query_one("#choosing-preview", Static).update(Content("\n").join(rows))

    def _clipped(self, text: str, most: int) -> list[str]:
        rows = wrap(text, self.room, 2)
        return rows if len(rows) <= most else [*rows[: most - 1], fit(rows[most - 1] + " " + rows[most], self.room)]

    def _colour(self, preview: Preview) -> str:
        return "fail" if preview.side is not None and preview.side.breaks else "warn"

    def _verdicts(self, results: "Results") -> list[Content]:
        before = self.session.results
        now = {step.key: results.outcomes[step.key].verdict for step in STEPS}
        was = {key: before.outcomes[key].verdict for key in now} if before is not None else now
        counts = results.words()
        if self.app.size.height < TALL:  # the steps that it changes, and how it then stands
            changed = self.verdict_rows(((key, was[key], now[key]) for key in now if was[key] != now[key]), "→")
            return [*([row for row in changed if row]), Content.styled(self.app.say(counts), "dim")]
        if before is not None:
            counts = Text("{words} (now {were})", words=counts, were=before.words())
        return [
            *self.verdict_rows(((key, was[key], now[key]) for key in now), "→"),
            Content.styled(self.app.say(counts), "dim"),
        ]

    # --- what the keys do
    def action_take(self) -> None:
        number = self.number
        if self.offer is None or not number:
            return
        preview = self.previews.get(number)
        if preview is None:  # it is being solved since the cursor came there
            self._wanted = number
        else:
            self._take(preview, warned=True)

    def _take(self, preview: Preview, *, warned: bool) -> None:
        """`warned`: whether what it breaks and opens stood there when Enter was pressed."""
        if preview.results is None:
            self.app.tell(_refused(preview), "warning")
        elif preview.shut:
            text = Text(
                "Row {n} {changes}. {key} in the field unlocks it.",
                n=preview.number,
                changes=preview.shut,
                key=self.app.shown_key("lock"),
            )
            self.app.tell(text, "warning")
        elif preview.warns and not warned:
            self.app.tell(Text("Row {n}: {what}. Enter takes it.", n=preview.number, what=preview.warns), "warning")
        else:
            self.dismiss(preview.changes)

    def row_name(self, number: int) -> Text:
        return Text("row {n}", n=number)

    def action_compare(self) -> None:
        """The design as it is, and that of the row under the cursor."""
        preview = self.previews.get(self.number)
        if preview is None:
            self.app.tell(Text("It is still being solved."))
        elif preview.results is None:
            self.app.tell(_refused(preview), "warning")
        else:
            self.compare(self.row_name(preview.number), preview.changes, lambda: self._take(preview, warned=True))

    def on_item_list_chosen(self, event: ItemList.Chosen) -> None:
        event.stop()

    def action_copy(self, what: str) -> None:
        item = self.query_one(OfferList).item
        if item is not None:
            text = getattr(item, what) or item.line
            self.app.copy_to_clipboard(text)
            self.app.tell(Text("Copied: {text}", text=text))
