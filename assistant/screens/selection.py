# SPDX-License-Identifier: Apache-2.0
"""Choosing from a ranked table.  The search runs aside and can be stopped; of the row under the cursor the whole design is solved before
it is taken, so that its price in the other steps is seen."""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from textual import work
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.message import Message
from textual.timer import Timer
from textual.widgets import Static

from calc.design.model import STEPS
from calc.design.toml_file import design
from calc.sheet.errors import BadInput, NoSolution
from calc.sheet.progress import Progress
from calc.sheet.text import EMPTY, Text

from ..changes import applied, locked_text, told
from ..offers.offer import Offer, offer
from ..session.session import Session
from ..session.solving import Answer, Job, run
from ..widgets.item_list import ItemList
from ..widgets.offer_list import OfferList
from ..widgets.text import wrap
from .searching import TITLES, Searching, mistakes_text

if TYPE_CHECKING:
    from calc.solve import Results


PAUSE = 0.15  # seconds that the cursor rests on a row before its design is solved
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
        take: bool  # Enter was pressed before the row was solved

    def __init__(self, session: Session, step: str) -> None:
        super().__init__()
        self.session, self.step = session, step
        self.offer: Offer | None = None
        self.previews: dict[int, Preview] = {}
        self._rest: Timer | None = None

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
        yield offer(self.step, self.session.design, self.session.name, progress)

    def show_found(self, found: Offer) -> None:
        self.offer = found
        self.query_one(OfferList).show(found)
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
        if self._rest is not None:
            self._rest.stop()
        if self.offer is None or not self.number:
            return
        if (known := self.previews.get(self.number)) is not None:
            self._show(known)
        else:
            self._rest = self.set_timer(PAUSE, self._solve_row)

    def _solve_row(self) -> None:
        if self.number:
            self._solve_aside(self.number, False)

    @work(thread=True, exclusive=True, group="preview", exit_on_error=False)
    def _solve_aside(self, number: int, take: bool) -> None:
        self.post_message(self.Previewed(self.previewed(number), take))

    def previewed(self, number: int) -> Preview:
        """The whole design with a row taken; runs in any thread."""
        assert self.offer is not None
        try:
            changes = tuple(self.offer.changes(number))
            made = design(applied(self.session.document, changes))
        except NoSolution as none:
            return Preview(number, why=none.text)
        except BadInput as bad:
            return Preview(number, why=mistakes_text(bad))
        answer: Answer = run(Job(0, made, self.session.results))
        return Preview(number, changes, answer.results, answer.failure)

    def on_choosing_previewed(self, event: Previewed) -> None:
        event.stop()
        self.previews[event.preview.number] = event.preview
        if event.preview.number == self.number:
            self._show(event.preview)
            if event.take:
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
        signs, before = self.app.signs, self.session.results
        now = {step.key: results.outcomes[step.key].verdict for step in STEPS}
        was = {key: before.outcomes[key].verdict for key in now} if before is not None else now
        counted = Counter(c.verdict for c in results.checks())
        were = Counter(c.verdict for c in before.checks()) if before is not None else counted
        counts = ", ".join(f"{counted[v]} {signs.word(v)} ({self.app.say(Text('now {n}', n=were[v]))})" for v in ("fail", "warn", "pass"))
        return [*self.verdict_rows(((key, was[key], now[key]) for key in now), "→"), Content.styled(counts, "dim")]

    # --- what the keys do
    def action_take(self) -> None:
        number = self.number
        if self.offer is None or not number:
            return
        preview = self.previews.get(number)
        if preview is None:
            self._solve_aside(number, True)
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
