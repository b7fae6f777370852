# SPDX-License-Identifier: Apache-2.0
"""A dialog whose rows a long search finds in another thread: how far it is, what it gives, and what each row does to every step."""

from collections.abc import Iterable, Iterator
from typing import ClassVar, Generic, TypeVar

from textual import work
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.screen import ModalScreen
from textual.widgets import Static
from textual.worker import get_current_worker

from calc.design.model import OPTIONAL, STEPS
from calc.sheet.errors import BadInput, Cancelled, NoSolution
from calc.sheet.progress import Progress
from calc.sheet.text import EMPTY, SEMICOLON, Text

from ..base_app import BaseApp
from ..session.solving import mistake
from ..widgets.item_list import ItemList
from .once import Once

TITLES = {step.key: step.title for step in STEPS}

Chosen = TypeVar("Chosen")
Found = TypeVar("Found")


def mistakes_text(bad: BadInput) -> Text:
    """Every mistake with its key, in one row."""
    return SEMICOLON.join(Text("{key}: {reason}", key=e.key, reason=e.reason) if e.key else e.reason for e in bad.errors)


class Searching(Once, ModalScreen[Chosen], Generic[Chosen, Found]):
    """Gives what was chosen.  `STATE`: the row that tells the search; `BAR`: cells of its progress; `BEHIND`: what stands behind that."""

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

    def show_found(self, found: Found) -> None:
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
            for found in self.search(progress):
                self.call_later(self._found, number, found)
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

    def _found(self, number: int, found: Found) -> None:
        if number == self._round:
            self.show_found(found)

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
            arrow = f"{signs.mark(was)} {then} " if was != now else ""
            part = Content.assemble(f"{say(TITLES[key])} {arrow}", (f"{signs.mark(now)} {signs.word(now)}", signs.style(now)))
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
