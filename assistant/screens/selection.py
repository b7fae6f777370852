# SPDX-License-Identifier: Apache-2.0
"""Choosing from a ranked table.  The search runs aside and can be stopped; of the row under the cursor the whole design is solved before
it is taken, so that its price in the other steps is seen."""

from collections import Counter
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from textual import work
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.message import Message
from textual.screen import ModalScreen
from textual.timer import Timer
from textual.widgets import Static
from textual.worker import get_current_worker

from calc.design import STEPS
from calc.design_file import design
from calc.sheet.errors import BadInput, Cancelled, NoSolution
from calc.sheet.text import EMPTY, SEMICOLON, Text

from ..base_app import BaseApp
from ..changes import applied, locked_text, told
from ..offers.offer import Offer, offer
from ..session import Session
from ..solving import Answer, Job, mistake, run
from ..widgets.item_list import ItemList
from ..widgets.offer_list import OfferList
from ..widgets.wrap import wrap
from .once import Once

if TYPE_CHECKING:
    from calc.solve import Results


PAUSE = 0.15  # seconds that the cursor rests on a row before its design is solved
HINT = Text("Enter takes the row (undo takes it back), ↑ ↓ go through the rows, Esc goes back")
BAR = 30  # cells


@dataclass(frozen=True)
class Preview:
    """A row, as changes of keys, and what the whole design then gives; or why it can not be taken."""

    number: int
    changes: tuple[str, ...] = ()
    results: "Results | None" = None
    why: Text = EMPTY


def _refused(preview: Preview) -> Text:
    return Text("Row {n} can not be taken: {reason}", n=preview.number, reason=preview.why)


def mistakes_text(bad: BadInput) -> Text:
    """Every mistake with its key, in one row."""
    return SEMICOLON.join(Text("{key}: {reason}", key=e.key, reason=e.reason) if e.key else e.reason for e in bad.errors)


class Choosing(Once, ModalScreen[tuple[str, ...] | None]):
    """Gives the changes of the row that was taken, as KEY=VALUE."""

    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape,q", "leave", "Close", show=False),
        Binding("enter", "take", "Take the row", show=False),
        Binding("down,j", "move(1)", "Down", show=False),
        Binding("up,k", "move(-1)", "Up", show=False),
        Binding("y", "copy('value')", "Copy the row", show=False),
        Binding("Y", "copy('line')", "Copy the row with its columns", show=False),
    ]

    @dataclass
    class Progress(Message):
        share: float
        what: str

    @dataclass
    class Found(Message):
        offer: Offer | None
        why: Text = EMPTY

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
        title = next(s.title for s in STEPS if s.key == self.step)
        with Vertical(classes="dialog -tall -whole"):
            yield Static(Content.styled(self.app.say(title), "bold"), id="choosing-title")
            yield Static(id="choosing-state")
            yield OfferList()
            yield Static(id="choosing-preview")
            yield Static(Content.styled(self.app.say(HINT), "dim"))

    def on_mount(self) -> None:
        self.query_one(OfferList).focus()
        self.say(self.app.say(Text("searching …")))
        self._search()

    def say(self, text: str) -> None:
        state = self.query_one("#choosing-state", Static)
        state.update(Content(text))
        state.display = bool(text)

    @property
    def room(self) -> int:
        return max(20, self.app.size.width - 8)

    # --- searching
    @work(thread=True, group="choosing", exit_on_error=False)
    def _search(self) -> None:
        worker = get_current_worker()

        def progress(share: float, what: str) -> None:
            if worker.is_cancelled:
                raise Cancelled
            self.post_message(self.Progress(share, what))

        try:
            found = offer(self.step, self.session.design, self.session.name, progress)
            self.post_message(self.Found(found))
        except Cancelled:
            pass
        except BadInput as bad:
            self.post_message(self.Found(None, mistakes_text(bad)))
        except NoSolution as none:
            self.post_message(self.Found(None, none.text))
        except Exception as error:  # a mistake of the program must not take the user's work with it
            self.post_message(self.Found(None, mistake(error)))

    def on_choosing_progress(self, event: Progress) -> None:
        event.stop()
        if self.offer is None:
            full, empty = ("#", ".") if self.app.ascii else ("█", "░")
            done = round(event.share * BAR)
            say = self.app.say
            bar = f"{full * done}{empty * (BAR - done)} {event.share:4.0%}"
            self.say(f"{say(Text('searching …'))}  {bar}  {say(event.what)}   {say(Text('Esc stops'))}")

    def on_choosing_found(self, event: Found) -> None:
        event.stop()
        if event.offer is None:
            self.say(self.app.say(Text("Nothing to choose: {reason}", reason=event.why)))
            return
        self.offer = event.offer
        self.say("")
        self.query_one(OfferList).show(event.offer)
        self.query_one(OfferList).focus()

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
        parts: list[Content] = []
        for step in STEPS:
            verdict = results.outcomes[step.key].verdict
            was = before.outcomes[step.key].verdict if before is not None else verdict
            arrow = f"{signs.mark(was)} → " if was != verdict else ""
            parts.append(
                Content.assemble(
                    f"{self.app.say(step.title)} {arrow}", (f"{signs.mark(verdict)} {signs.word(verdict)}", signs.style(verdict))
                )
            )
        counted = Counter(c.verdict for c in results.checks())
        were = Counter(c.verdict for c in before.checks()) if before is not None else counted
        counts = ", ".join(f"{counted[v]} {signs.word(v)} ({self.app.say(Text('now {n}', n=were[v]))})" for v in ("fail", "warn", "pass"))
        lines, line = [], Content("")
        for part in parts:
            if line.cell_length + part.cell_length + 3 > self.room:
                lines.append(line)
                line = Content("")
            line = Content.assemble(line, "   " if line else "", part)
        return [*lines, line, Content.styled(counts, "dim")]

    # --- what the keys do
    def action_move(self, by: int) -> None:
        self.query_one(OfferList).move(by)

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

    def action_leave(self) -> None:
        """Stops a search that is going on."""
        self.workers.cancel_node(self)
        self.dismiss(None)
