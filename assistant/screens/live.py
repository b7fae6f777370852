# SPDX-License-Identifier: Apache-2.0
"""The screen as it is always solved: in another thread, one solve at a time, the answer dropped if it comes too late."""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from textual import work
from textual.css.query import NoMatches
from textual.message import Message
from textual.screen import Screen
from textual.timer import Timer
from textual.worker import get_current_worker

from calc.design import STEPS
from calc.languages import Language
from calc.languages.outcome import said
from calc.sheet.errors import Cancelled
from calc.sheet.step import Curve, Outcome, Step, Table

from ..session import Session
from ..sheets import Sheet, values_table
from ..solving import Answer, Job, run
from ..widgets.calculation import Calculation
from ..widgets.checks import Checks
from ..widgets.table_list import TableList
from ..widgets.top_line import TopLine

if TYPE_CHECKING:
    from calc.design_file import Document
    from calc.remedies.remedy import Remedy
    from calc.solve import Results

    from ..app import ContralberoApp

DEBOUNCE = 0.02  # seconds after the last key: a burst of a repeating key is one solve
SLOW = 0.15  # a solve that takes longer says so
AHEAD = 0.4  # seconds after the last results until the calculations of the other steps are written out


class Live(Screen[None]):
    """What a screen over a session needs to keep its results up to date."""

    app: "ContralberoApp"
    session: Session
    step: Step

    @dataclass
    class Solved(Message):
        """A solve in the other thread is done."""

        answer: Answer
        session: Session = field(repr=False)

    @dataclass
    class Mended(Message):
        """A remedy was found, or that there is none."""

        step: str
        results: "Results" = field(repr=False)
        remedy: "Remedy" = field(repr=False)

    def __init__(self) -> None:
        super().__init__()
        self.remedies: dict[str, tuple[Results, Remedy]] = {}  # step → its remedy, and the results that it mends
        self.sheets: dict[str, tuple[Any, Sheet]] = {}  # step → (its outcome, its calculation)
        self._said: dict[str, tuple[Outcome, Outcome]] = {}  # step → its outcome, and the same in the user's language
        self._say: Language | None = None
        self._leaves: tuple[Outcome | None, tuple[Curve | Table, ...]] = (None, ())
        self._solving = False
        self._debounce: Timer | None = None
        self._slow: Timer | None = None
        self._ahead: Timer | None = None

    def show_results(self) -> None:
        raise NotImplementedError

    def show_state(self) -> None:
        raise NotImplementedError

    def solve_soon(self) -> None:
        """Solve when no further key comes."""
        if self._debounce is not None:
            self._debounce.stop()
        self._debounce = self.set_timer(DEBOUNCE, self.solve)

    def solve(self) -> None:
        """Solve what is to be solved, one at a time; an edit in the meantime makes it solve once more."""
        if self._solving:
            return
        job = self.session.job()
        if job is None:
            self.query_one(TopLine).slow = False
            self.show_state()
            return
        self._solving = True
        self._slow = self.set_timer(SLOW, self._say_slow)
        self._solve_aside(job, self.session)

    def set_stale(self, stale: bool) -> None:
        """Dim the results that do not belong to what the fields say."""
        for results in (*self.query(Checks), *self.query(Calculation), *self.query(TableList)):
            results.set_stale(stale)

    def _say_slow(self) -> None:
        if self._solving:
            self.query_one(TopLine).slow = True
            self.query_one(TopLine).refresh()
            self.set_stale(True)

    @work(thread=True, group="solve", exit_on_error=False, description="solve")
    def _solve_aside(self, job: Job, session: Session) -> None:
        answer = run(job)
        try:
            from ..widgets import plot  # noqa: F401  loaded here, so that the screen need not wait for it

            if answer.results is not None and session is self.session:
                self.prepare(answer.results, self.step)
        finally:
            self.post_message(self.Solved(answer, session))

    def said(self, results: "Results", step: Step) -> Outcome:
        """The whole outcome of a step in the user's language; made once."""
        outcome, say = results.outcomes[step.key].whole, self.app.say
        known, made = self._said.get(step.key, (None, outcome))
        if known is not outcome or say is not self._say:
            made = said(outcome, say)
            self._said[step.key] = (outcome, made)
            self._say = say
        return made

    def leaves(self, outcome: Outcome) -> tuple[Curve | Table, ...]:
        """The curves and tables of a step, and the table of all its values."""
        known, made = self._leaves
        if known is not outcome:
            made = (*outcome.curves, *outcome.tables)
            if outcome.result is not None:
                made = (*made, values_table(outcome, self.app.say))
            self._leaves = (outcome, made)
        return made

    def prepare(self, results: "Results", step: Step) -> Sheet:
        """The calculation of a step, written out and broken into rows; kept as long as its outcome is the same.  Runs in any thread."""
        from ..sheets import sheet

        outcome = self.said(results, step)
        known, made = self.sheets.get(step.key, (None, Sheet()))
        if known is not outcome:
            try:
                made = sheet(outcome, STEPS.index(step) + 1, self.app.say)
            except Exception as error:  # a line that can not be written must not stop the session
                made = Sheet(notes=(f"The calculation can not be written out: {type(error).__name__}: {error}",))
            self.sheets[step.key] = (outcome, made)
        try:
            self.query_one(Calculation).prepare(made)
        except NoMatches:  # the screen is just being made anew
            pass
        return made

    def prepare_ahead(self) -> None:
        self._prepare_ahead()
        self.seek_remedy()

    @work(thread=True, exclusive=True, group="ahead", exit_on_error=False, description="prepare")
    def _prepare_ahead(self) -> None:
        """The calculations of the other steps, while nothing else is to be done."""
        for step in STEPS:
            results = self.session.results
            if results is None or self._solving or not self.is_attached:
                return
            self.prepare(results, step)

    # --- remedies
    @property
    def trouble(self) -> str:
        """The step whose limits fail: this one, else the first in the order of the screen; empty where none does."""
        results = self.session.results
        if results is None or not self.session.current:
            return ""
        return next((s.key for s in (self.step, *STEPS) if results.outcomes[s.key].verdict in ("fail", "no_solution")), "")

    @property
    def remedy(self) -> "Remedy | None":
        """What mends that step, if it is known already."""
        results, known = self.remedies.get(self.trouble, (None, None))
        return known if results is not None and results is self.session.results else None

    def seek_remedy(self) -> None:
        """Look for what mends the step that fails, while nothing else is to be done."""
        if (step := self.trouble) and self.remedy is None and self.session.results is not None:
            self._seek_aside(step, self.session.document, self.session.results)

    @work(thread=True, exclusive=True, group="remedy", exit_on_error=False, description="remedy")
    def _seek_aside(self, step: str, document: "Document", results: "Results") -> None:
        from calc.remedies.remedy import remedy

        worker = get_current_worker()

        def progress(share: float, what: str) -> None:
            if worker.is_cancelled or self.session.results is not results or not self.is_attached:
                raise Cancelled

        try:
            found = remedy(document, step, results, progress)
        except Cancelled:
            return
        except Exception as error:  # a mistake of the program must not stop the session
            self.log(f"no remedy: {type(error).__name__}: {error}")
            return
        self.post_message(self.Mended(step, results, found))

    def on_live_mended(self, event: Mended) -> None:
        event.stop()
        self.remedies[event.step] = (event.results, event.remedy)
        self.show_remedy()

    def show_remedy(self) -> None:
        raise NotImplementedError

    def on_live_solved(self, event: Solved) -> None:
        event.stop()
        self._solving = False
        if self._slow is not None:
            self._slow.stop()
        if event.session is self.session and self.session.accept(event.answer):
            self.query_one(TopLine).slow = False
            self.show_results()
        if self.session.job() is not None:
            self.solve()
            return
        self.query_one(TopLine).slow = False
        self.show_state()
        self.app.solves += 1
        if self._ahead is not None:
            self._ahead.stop()
        self._ahead = self.set_timer(AHEAD, self.prepare_ahead)
