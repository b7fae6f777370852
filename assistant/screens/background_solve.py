# SPDX-License-Identifier: Apache-2.0
"""The screen as it is always solved: in another thread, one solve at a time, the answer dropped if it comes too
late."""

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING

from textual.css.query import NoMatches
from textual.timer import Timer
from textual.worker import get_current_worker

from calc.design.model import STEPS
from calc.locale import Language
from calc.locale.language import said
from calc.sheet.errors import Cancelled
from calc.sheet.step import Curve, Outcome, Step, Table
from calc.sheet.text import Name, Text

from ..session.calculation import CalculationSheet, values_table
from ..session.session import Session
from ..session.solving import Answer, Job, run
from .host import Host

if TYPE_CHECKING:
    from calc.design.toml_file import Document
    from calc.solve import Results
    from calc.studies.repair.nearest import NearestRemedy


SLOW = 0.3  # a solve that takes longer dims what stands there; sooner it would only flicker
# seconds after a key until results are painted: the next key of who types on comes sooner, and need not wait for that
PAUSE = 0.08
FRAMES = 0.04  # seconds in which the verdicts are painted, before anything else is done
REST = (
    0.9  # seconds after a key in which whatever goes on behind the screen rests: what the key does needs the processor
)
HIDDEN = 0.2  # seconds until a calculation that is not on the screen is written out
SEEK = 1.0  # seconds from then until a remedy is looked for: a step of that can not be stopped half-way
AHEAD = 0.4  # seconds after the last results until the calculations of the other steps are written out


@dataclass(frozen=True)
class Page:
    """What is written out of an outcome in a language: its whole, its calculation, its curves and tables."""

    outcome: Outcome[object]
    say: Language
    whole: Outcome[object]
    sheet: CalculationSheet
    leaves: tuple[Curve | Table, ...]


def rest(host: Host) -> None:
    """Asked in another thread, again and again, by what nobody waits for: between two lines a key may come, and need
    not wait."""
    time.sleep(0.0005)
    while host.is_attached and time.monotonic() < host.app.struck + REST:
        time.sleep(0.02)


class BackgroundSolve:
    """Keeps the results of a screen's session up to date, and what is written of them."""

    def __init__(self, host: Host) -> None:
        self._host = host
        self.remedies: dict[
            str, tuple[Results, NearestRemedy]
        ] = {}  # step → its remedy, and the results that it is a remedy for
        self._sought: dict[str, Results] = {}  # step → the results that a remedy is or was looked for
        self.pages: dict[str, Page] = {}  # step → what was written of it last
        self._solving = False
        self._slow: Timer | None = None
        self._ahead: Timer | None = None
        self._page: Timer | None = None

    def begin(self) -> None:
        """Another design is entered: nothing that was written holds for it."""
        self.pages = {}
        for timer in (self._ahead, self._page):
            if timer is not None:
                timer.stop()

    def solve(self) -> None:
        """Solve what is to be solved, one at a time; an edit in the meantime stops it, and it begins once more."""
        if self._solving:
            return
        host = self._host
        job = host.session.job()
        if job is None:
            host.set_slow(False)
            if host.session.current:
                self._go_ahead()  # what stopped for an entry that was not understood
            return
        self._solving = True
        self._slow = host.set_timer(SLOW, self._say_slow)
        host.in_thread("solve", partial(self._solve, job, host.session), exclusive=False)

    def _say_slow(self) -> None:
        if self._solving and self._host.stands:
            self._host.set_slow(True)
            self._host.refresh_top_line()
            self._host.set_stale(True)

    def _solve(self, job: Job, session: Session) -> None:
        """Runs in another thread."""

        def stop() -> bool:
            return job.stop() or self._host.session is not session  # another design was opened

        self._host.call_later(self._solved, run(replace(job, stop=stop)), session)

    def _solved(self, answer: Answer, session: Session) -> None:
        host = self._host
        self._solving = False
        if self._slow is not None:
            self._slow.stop()
        if session is host.session:
            session.accept(answer)
        if not host.stands:  # it is solved again as soon as it does
            return
        if host.session.job() is not None:  # edited in the meantime
            self.solve()
            return
        if (pause := host.app.struck + PAUSE - time.monotonic()) > 0:
            host.set_timer(pause, self._show)
        else:
            self._show()

    def _show(self) -> None:
        host = self._host
        if not host.stands or self._solving or host.session.job() is not None:  # edited in the meantime
            return
        host.set_slow(False)
        host.set_stale(not host.session.current)
        host.show_verdicts()
        host.set_timer(FRAMES, self._follow_up)

    def _follow_up(self) -> None:
        """What may be shown a moment after the verdicts."""
        if self._host.stands:
            self._host.show_state()
            self._host.show_picture()
            self.write_out()

    # --- the calculation, written out
    def write_out(self) -> None:
        """Show the calculation of the step: at once where it is written already, else as soon as another thread has
        written it.

        One that is not on the screen is written a little later: what is there is painted first.
        """
        host = self._host
        results = host.session.results
        if results is None:
            return
        if self.written(results, host.step):
            host.show_written()
            self._go_ahead()
            return
        if self._page is not None:
            self._page.stop()
        write = partial(host.in_thread, "page", partial(self._write_page, results, host.step))
        if host.pane_layout.written:
            write()
        else:
            self._page = host.set_timer(HIDDEN, write)

    def _write_page(self, results: "Results", step: Step) -> None:
        """Runs in another thread."""
        from ..widgets import plot  # noqa: F401  loaded here, so that the screen need not wait for it

        worker = get_current_worker()
        host = self._host
        self.write(
            results, step, lambda: worker.is_cancelled or not host.is_attached or host.session.results is not results
        )
        if not worker.is_cancelled:
            self._host.call_later(self._wrote_page, results)

    def _wrote_page(self, results: "Results") -> None:
        if self._host.stands and results is self._host.session.results:
            self.write_out()

    def written(self, results: "Results", step: Step) -> bool:
        """Whether what is written of a step is of these results, and in the user's language."""
        page = self.pages.get(step.key)
        return page is not None and page.outcome is results.outcomes[step.key] and page.say is self._host.app.say

    @property
    def page(self) -> Page | None:
        """What stands there of the step, if it is of the results as they are."""
        host = self._host
        results, page = host.session.results, self.pages.get(host.step.key)
        if results is None or page is None or not self.written(results, host.step):
            return None
        return page if host.calculation.sheet is page.sheet else None

    def write(self, results: "Results", step: Step, stop: Callable[[], bool]) -> None:
        """Write a step out and break it into rows, unless that is done; runs in any thread, until it is told to
        stop."""
        from ..session.calculation import sheet

        outcome, say = results.outcomes[step.key], self._host.app.say
        try:
            if not self.written(results, step):
                try:
                    whole = said(results.traced(stop).outcomes[step.key].whole, say)
                    calculation = sheet(whole, STEPS.index(step) + 1, say, stop)
                    values = () if whole.result is None else (values_table(whole, say),)
                    page = Page(outcome, say, whole, calculation, (*whole.curves, *whole.tables, *values))
                except Cancelled:
                    return
                except Exception as error:  # a line that can not be written must not stop the session
                    why = Name(
                        say(
                            Text(
                                "The calculation can not be written out: {kind}: {error}",
                                kind=type(error).__name__,
                                error=str(error),
                            )
                        )
                    )
                    page = Page(outcome, say, outcome, CalculationSheet(notes=(why,)), ())
                if stop():
                    return
                if not self.written(results, step):  # else another thread was sooner, and its page may stand there
                    self.pages[step.key] = page
            self._host.calculation.prepare(self.pages[step.key].sheet, stop)
        except (NoMatches, Cancelled):  # the screen is just being made anew, or nobody waits for it any more
            pass

    def _go_ahead(self) -> None:
        """Soon, if nothing else is to be done: the calculations of the other steps, and a remedy."""
        if self._ahead is not None:
            self._ahead.stop()
        self._ahead = self._host.set_timer(AHEAD, self._think_ahead)

    def _think_ahead(self) -> None:
        if not self._host.stands:
            return
        self._host.in_thread("ahead", self._write_ahead)
        self._ahead = self._host.set_timer(SEEK, self.seek_remedy)

    def _idle(self, results: "Results | None") -> bool:
        """Whether nothing has happened since these results: what goes on behind the screen stops at the next key, to
        make room."""
        host = self._host
        return host.is_attached and not self._solving and host.session.results is results and host.session.current

    def _write_ahead(self) -> None:
        """Runs in another thread."""
        results = self._host.session.results

        def stop() -> bool:
            rest(self._host)
            return not self._idle(results)

        for step in STEPS:
            if results is None or stop():
                return
            self.write(results, step, stop)

    # --- remedies
    @property
    def _troubles(self) -> list[str]:
        """The steps whose limits fail: this one first, then in the order of the screen."""
        host = self._host
        results = host.session.results
        if results is None or not host.session.current:
            return []
        steps = dict.fromkeys((host.step, *STEPS))
        return [step.key for step in steps if results.outcomes[step.key].verdict in ("fail", "no_solution")]

    @property
    def trouble(self) -> str:
        """The first of them; empty where none fails."""
        return next(iter(self._troubles), "")

    @property
    def remedy(self) -> "NearestRemedy | None":
        """The remedy for that step, if it is known already."""
        results, known = self.remedies.get(self.trouble, (None, None))
        return known if results is not None and results is self._host.session.results else None

    def seek_remedy(self) -> None:
        """Look for a remedy for each step that fails, while nothing else is to be done: it is there when the step is
        opened."""
        session = self._host.session
        results = session.results
        if results is None:
            return
        for step in self._troubles:
            if self._sought.get(step) is not results:
                self._sought[step] = results
                self._host.in_thread(f"remedy-{step}", partial(self._seek, step, session.document, results))

    def _seek(self, step: str, document: "Document", results: "Results") -> None:
        """Runs in another thread."""
        from calc.studies.repair.nearest import remedy

        worker = get_current_worker()

        def progress(share: float, what: str) -> None:
            rest(self._host)
            if (
                worker.is_cancelled or not self._idle(results) or not self._host.is_current
            ):  # a list of remedies has its own search
                raise Cancelled

        try:
            nearest = remedy(document, step, results, progress)
        except Cancelled:
            self._host.call_later(self._stopped_seeking, step, results)
            return
        except Exception as error:  # a mistake of the program must not stop the session
            self._host.app.log(f"no remedy: {type(error).__name__}: {error}")
            return
        self._host.call_later(self._found_remedy, step, results, nearest)

    def _stopped_seeking(self, step: str, results: "Results") -> None:
        """It is looked for once more when somebody asks again."""
        if self._sought.get(step) is results:
            del self._sought[step]

    def _found_remedy(self, step: str, results: "Results", remedy: "NearestRemedy") -> None:
        self.remedies[step] = (results, remedy)
        if self._host.stands:
            self._host.show_remedy()
