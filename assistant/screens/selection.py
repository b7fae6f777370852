# SPDX-License-Identifier: Apache-2.0
"""Choosing from a ranked table: the search that fills it, the list of its rows, and the dialog.

The search runs aside and can be stopped; of the row under the cursor the whole design is solved before it is taken, so
that its price in the other steps is seen."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar, Generic, TypeVar

from textual import work
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.message import Message
from textual.screen import ModalScreen
from textual.widgets import Static
from textual.worker import get_current_worker

from calc.design.model import OPTIONAL, STEPS, TITLES
from calc.design.toml_file import design
from calc.locale.language import in_language
from calc.sheet.errors import BadInput, Cancelled, NoSolution
from calc.sheet.progress import Progress
from calc.sheet.step import OF_SHAFTS
from calc.sheet.text import EMPTY, SEMICOLON, Text

from ..base_app import BaseApp
from ..offers import Offer, offer
from ..session.editing import applied, locked_text, told
from ..session.session import Session
from ..session.solving import Answer, Job, mistake, run
from ..widgets.item_list import Item, ItemList
from ..widgets.table_list import Setter
from ..widgets.text import wrap
from .dialogs import Once

if TYPE_CHECKING:
    from calc.solve import Results


# --- a dialog whose rows a long search finds in another thread
# How far it is, what it gives, and what each row does to every step.

Chosen = TypeVar("Chosen")
Found = TypeVar("Found")


def mistakes_text(bad: BadInput) -> Text:
    """Every mistake with its key, in one row."""
    return SEMICOLON.join(
        Text("{key}: {reason}", key=e.key, reason=e.reason) if e.key else e.reason for e in bad.errors
    )


class Searching(Once, ModalScreen[Chosen], Generic[Chosen, Found]):
    """Gives what was chosen.  `STATE`: the row that tells the search; `BAR`: cells of its progress; `BEHIND`: what
    stands behind that."""

    app: BaseApp
    STATE: ClassVar[str]
    BAR: ClassVar[int]
    BEHIND: ClassVar[Text] = EMPTY
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape,q", "leave", "Close", show=False),
        Binding("down,j", "move(1)", "Down", show=False),
        Binding("up", "move(-1)", "Up", show=False),
    ]

    def __init__(self) -> None:
        super().__init__()
        self.searching = False
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
            failure = mistakes_text(bad)
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
        self.show_state(f"{say(Text('searching …'))}  {bar}  {say(what)}   {say(self.BEHIND)}".rstrip())

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

    def show(self, offer: Offer) -> None:
        self.offer = offer
        self.rebuild()

    def build(self, width: int) -> list[Item]:
        if (offer := self.offer) is None:
            return []
        items: list[Item] = []
        say = self.app.say
        last, taken = 1, set[str]()
        for n, table in enumerate(in_language(raw_table, say) for raw_table in (offer.table(TOP), *offer.beside(TOP))):
            set_ = Setter(table, width, say, self._column)
            last = max(last, set_.last)
            part = say(Text("   ({columns}; Shift+→ ←)", columns=set_.part)) if set_.part else ""
            title = [Content.styled(row, "bold") for row in wrap(f"{table.title}{part}", width)]
            items.append(Item("", [Content(""), *title] if n else title))
            if not n:
                items += [Item("", [Content(row) for row in wrap(say(words), width)]) for words in offer.summary]
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
        for text in ((offer.hidden(TOP),) if offer.hidden(TOP) else ()) + offer.notes:
            items.append(Item("", [Content.styled(row, "dim") for row in wrap(f"· {say(text)}", width, 2)]))
        self._column = min(self._column, last)
        return items

    def action_columns(self, by: int) -> None:
        """Leaf through the columns of tables that are too wide."""
        self._column = max(1, self._column + by)
        self.rebuild()


# --- the dialog of an offer

HINT = Text("Enter takes the row (undo takes it back), ↑ ↓ go through the rows, Esc goes back")


@dataclass(frozen=True)
class Preview:
    """A row, as changes of keys, and what the whole design then gives; or why it can not be taken."""

    number: int
    changes: tuple[str, ...] = ()
    results: "Results | None" = None
    why: Text = EMPTY


def _refused(preview: Preview) -> Text:
    return Text("Row {n} can not be taken: {reason}", n=preview.number, reason=preview.why)


class Choosing(Searching[tuple[str, ...] | None, Offer]):
    """Gives the changes of the row that was taken, as KEY=VALUE."""

    STATE, BAR, BEHIND = "choosing-state", 30, Text("Esc stops")
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("enter", "take", "Take the row", show=False),
        Binding("k", "move(-1)", "Up", show=False),
        Binding("y", "copy('value')", "Copy the row", show=False),
        Binding("Y", "copy('line')", "Copy the row with its columns", show=False),
    ]

    @dataclass
    class Previewed(Message):
        preview: Preview

    def __init__(self, session: Session, step: str) -> None:
        super().__init__()
        self.session, self.step = session, step
        self.offer: Offer | None = None
        self.previews: dict[int, Preview] = {}
        self._solving = 0  # the row that is being solved
        self._wanted = 0  # the row on which Enter was pressed before it was solved

    def compose(self) -> ComposeResult:
        with Vertical(classes="dialog -tall -whole"):
            yield Static(Content.styled(self.app.say(TITLES[self.step]), "bold"), id="choosing-title")
            yield Static(id="choosing-state")
            yield OfferList()
            yield Static(id="choosing-preview")
            yield Static(Content.styled(self.app.say(HINT), "dim"))

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
        session = self.session
        shaft = session.original if self.step in OF_SHAFTS and session.original in session.design.originals else None
        result = offer(self.step, session.design, session.name, progress, shaft=shaft)
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
            changes = tuple(self.offer.changes(number))
            trial = design(applied(self.session.document, changes))
        except NoSolution as none:
            return Preview(number, why=none.text)
        except BadInput as bad:
            return Preview(number, why=mistakes_text(bad))
        except Exception as error:  # a mistake of the program must not take the user's work with it
            return Preview(number, why=mistake(error))
        answer: Answer = run(Job(0, trial, self.session.results, stop))
        return Preview(number, changes, answer.results, answer.failure)

    def on_choosing_previewed(self, event: Previewed) -> None:
        event.stop()
        self.previews[event.preview.number] = event.preview
        self._solving = 0
        if event.preview.number == self.number:
            self._show(event.preview)
            if self._wanted == self.number:
                self.action_take()

    def _show(self, preview: Preview) -> None:
        """What the row changes, and the verdicts of all six steps with it."""
        rows: list[Content] = []
        say = self.app.say
        if preview.results is None:
            rows = [Content(row) for row in wrap(say(_refused(preview)), self.room)]
        else:
            changes = told(self.session.document, preview.changes) or Text("the design as it is")
            text = Text("Row {n}: {changes}", n=preview.number, changes=changes)
            rows = [Content(row) for row in wrap(say(text), self.room, 2)[:3]]
            if shut := locked_text(self.session.document, preview.changes):
                text = Text("Row {n} {changes}", n=preview.number, changes=shut)
                rows += [Content.styled(row, self.app.signs.style("warn")) for row in wrap(say(text), self.room, 2)]
            rows += self._verdicts(preview.results)
        self.query_one("#choosing-preview", Static).update(Content("\n").join(rows))

    def _verdicts(self, results: "Results") -> list[Content]:
        before = self.session.results
        now = {step.key: results.outcomes[step.key].verdict for step in STEPS}
        was = {key: before.outcomes[key].verdict for key in now} if before is not None else now
        counts = results.words()
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
        elif preview.results is None:
            self.app.tell(_refused(preview), "warning")
        else:
            self.dismiss(preview.changes)

    def on_item_list_chosen(self, event: ItemList.Chosen) -> None:
        event.stop()

    def action_copy(self, what: str) -> None:
        item = self.query_one(OfferList).item
        if item is not None:
            text = getattr(item, what) or item.line
            self.app.copy_to_clipboard(text)
            self.app.tell(Text("Copied: {text}", text=text))
