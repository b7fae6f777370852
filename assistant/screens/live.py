# SPDX-License-Identifier: Apache-2.0
"""The screen as it is always solved: in another thread, one solve at a time, the answer dropped if it comes too late."""

import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

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

SLOW = 0.3  # a solve that takes longer dims what stands there; sooner it would only flicker
FRAMES = 0.04  # seconds in which the verdicts are painted, before anything else is done
SEEK = 1.0  # seconds from then until a remedy is looked for: a step of that can not be stopped half-way
AHEAD = 0.4  # seconds after the last results until the calculations of the other steps are written out


@dataclass(frozen=True)
class Page:
    """What is written out of an outcome in a language: its whole, its calculation, its curves and tables."""

    outcome: Outcome
    say: Language
    whole: Outcome
    sheet: Sheet
    leaves: tuple[Curve | Table, ...]


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
    class Written(Message):
        """The calculation of a step is written out."""

        results: "Results" = field(repr=False)

    @dataclass
    class Mended(Message):
        """A remedy was found, or that there is none."""

        step: str
        results: "Results" = field(repr=False)
        remedy: "Remedy" = field(repr=False)

    def __init__(self) -> None:
        super().__init__()
        self.remedies: dict[str, tuple[Results, Remedy]] = {}  # step → its remedy, and the results that it mends
        self.pages: dict[str, Page] = {}  # step → what was written of it last
        self._solving = False
        self._slow: Timer | None = None
        self._ahead: Timer | None = None

    @property
    def stands(self) -> bool:
        """Whether all parts of the screen are there: not while it is made anew, or taken down at the end."""
        raise NotImplementedError

    def show_verdicts(self) -> None:
        """What the results say in a few words: shown first, and at once."""
        raise NotImplementedError

    def show_written(self) -> None:
        """The calculation, the curves and whatever else takes a moment to be made."""
        raise NotImplementedError

    def show_state(self) -> None:
        raise NotImplementedError

    def solve(self) -> None:
        """Solve what is to be solved, one at a time; an edit in the meantime stops it, and it begins once more."""
        if self._solving:
            return
        job = self.session.job()
        if job is None:
            self.query_one(TopLine).slow = False
            if self.session.current:
                self._go_ahead()  # what stopped for an entry that was not understood
            return
        self._solving = True
        self._slow = self.set_timer(SLOW, self._say_slow)
        self._solve_aside(job, self.session)

    def set_stale(self, stale: bool) -> None:
        """Dim the results that do not belong to what the fields say."""
        for results in (Checks, Calculation, TableList):
            self.query_one(results).set_stale(stale)

    def _say_slow(self) -> None:
        if self._solving and self.stands:
            self.query_one(TopLine).slow = True
            self.query_one(TopLine).refresh()
            self.set_stale(True)

    @work(thread=True, group="solve", exit_on_error=False, description="solve")
    def _solve_aside(self, job: Job, session: Session) -> None:
        def stop() -> bool:
            return job.stop() or self.session is not session  # another design was opened

        self.post_message(self.Solved(run(replace(job, stop=stop)), session))

    def write_out(self) -> None:
        """Show the calculation of the step: at once where it is written already, else as soon as another thread has written it."""
        results = self.session.results
        if results is None:
            return
        if self.written(results, self.step):
            self.show_written()
            self._go_ahead()
        else:
            self._page_aside(results, self.step)

    @work(thread=True, exclusive=True, group="page", exit_on_error=False, description="page")
    def _page_aside(self, results: "Results", step: Step) -> None:
        from ..widgets import plot  # noqa: F401  loaded here, so that the screen need not wait for it

        worker = get_current_worker()
        self.write(results, step, lambda: worker.is_cancelled or not self.is_attached)
        if not worker.is_cancelled:
            self.post_message(self.Written(results))

    def on_live_written(self, event: Written) -> None:
        event.stop()
        if self.stands and event.results is self.session.results:
            self.write_out()

    def written(self, results: "Results", step: Step) -> bool:
        """Whether what is written of a step is of these results, and in the user's language."""
        page = self.pages.get(step.key)
        return page is not None and page.outcome is results.outcomes[step.key] and page.say is self.app.say

    @property
    def page(self) -> Page | None:
        """What stands there of the step, if it is of the results as they are."""
        results, page = self.session.results, self.pages.get(self.step.key)
        if results is None or page is None or not self.written(results, self.step):
            return None
        return page if self.query_one(Calculation).sheet is page.sheet else None

    def write(self, results: "Results", step: Step, stop: Callable[[], bool]) -> None:
        """Write a step out and break it into rows, unless that is done; runs in any thread, until it is told to stop."""
        from ..sheets import sheet

        outcome, say = results.outcomes[step.key], self.app.say
        try:
            if not self.written(results, step):
                try:
                    whole = said(outcome.whole, say)
                    made = sheet(whole, STEPS.index(step) + 1, say, stop)
                    values = () if whole.result is None else (values_table(whole, say),)
                    page = Page(outcome, say, whole, made, (*whole.curves, *whole.tables, *values))
                except Cancelled:
                    return
                except Exception as error:  # a line that can not be written must not stop the session
                    why = say(f"The calculation can not be written out: {type(error).__name__}: {error}")
                    page = Page(outcome, say, outcome, Sheet(notes=(why,)), ())
                if stop():
                    return
                self.pages[step.key] = page
            self.query_one(Calculation).prepare(self.pages[step.key].sheet, stop)
        except (NoMatches, Cancelled):  # the screen is just being made anew, or nobody waits for it any more
            pass

    def _go_ahead(self) -> None:
        """Soon, if nothing else is to be done: the calculations of the other steps, and a remedy."""
        if self._ahead is not None:
            self._ahead.stop()
        self._ahead = self.set_timer(AHEAD, self._think_ahead)

    def _think_ahead(self) -> None:
        if not self.stands:
            return
        self._write_ahead()
        self._ahead = self.set_timer(SEEK, self.seek_remedy)

    def _idle(self, results: "Results | None") -> bool:
        """Whether nothing has happened since these results: what goes on behind the screen stops at the next key, to make room."""
        return self.is_attached and not self._solving and self.session.results is results and self.session.current

    @work(thread=True, exclusive=True, group="ahead", exit_on_error=False, description="ahead")
    def _write_ahead(self) -> None:
        results = self.session.results

        def stop() -> bool:
            time.sleep(0.0005)  # between two lines a key may come, and need not wait
            return not self._idle(results)

        for step in STEPS:
            if results is None or stop():
                return
            self.write(results, step, stop)

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
            if worker.is_cancelled or not self._idle(results):
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
        if self.stands:
            self.show_remedy()

    def show_remedy(self) -> None:
        raise NotImplementedError

    def on_live_solved(self, event: Solved) -> None:
        event.stop()
        self._solving = False
        if self._slow is not None:
            self._slow.stop()
        if event.session is self.session:
            self.session.accept(event.answer)
        if not self.stands:  # it is solved again as soon as it does
            return
        if self.session.job() is not None:  # edited in the meantime
            self.solve()
            return
        self.query_one(TopLine).slow = False
        self.set_stale(not self.session.current)
        self.show_verdicts()
        self.set_timer(FRAMES, self.follow_up)

    def follow_up(self) -> None:
        """What may be shown a moment after the verdicts."""
        if self.stands:
            self.show_state()
            self.write_out()
