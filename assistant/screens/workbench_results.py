# SPDX-License-Identifier: Apache-2.0
"""The main screen as it is always solved, and what is seen of that: in another thread, one solve at a time, the answer
dropped if it comes too late; its calculation, remedies and slopes in their turn, while nobody types."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING

from textual.css.query import NoMatches
from textual.timer import Timer
from textual.widget import AwaitMount
from textual.worker import get_current_worker

from calc.design.addresses import asks
from calc.design.labels import SHAFTS, Place, content_at
from calc.design.model import STEPS
from calc.locale import Language
from calc.locale.language import in_language, said
from calc.sheet.check import URGENT, Check
from calc.sheet.errors import BadInput, Cancelled
from calc.sheet.progress import waited_for
from calc.sheet.step import OF_SHAFTS, Curve, Outcome, Step, Table
from calc.sheet.text import EMPTY, Name, Text
from calc.sheet.verdict import findings_of, open_findings

from ..base_app import TYPING
from ..session.calculation import VALUES, CalculationSheet, sheet, slopes_of_check, slopes_of_input, values_table
from ..session.guide import no_choice
from ..session.places import SITS_ON, WHEELS, named_key
from ..session.session import Session
from ..session.solving import Answer, Job, run
from ..widgets.calculation import Calculation
from ..widgets.field import Field
from ..widgets.form import Form, Taken
from ..widgets.headings import ArrayHeading, Fold, TableHeading
from ..widgets.lines import FooterLine, MessageLine, TopLine
from ..widgets.pane import Pane
from ..widgets.picture import Picture
from ..widgets.radio import Radio
from ..widgets.rows import FieldHelp
from ..widgets.steps import StepBar, Steps
from ..widgets.table_list import TableList
from .workbench_panes import WorkbenchPanes

if TYPE_CHECKING:
    from calc.design.toml_file import Document
    from calc.solve import Results
    from calc.studies.repair.nearest import NearestRemedy

SLOW = 0.3  # seconds of a solve until what stands there is dimmed: sooner it would flicker at every key
KEEP = 1.5  # seconds from the first edit that is not kept aside until all of them are: so much work a crash may take
MOVED = 5  # inputs that are moved for a check


@dataclass(frozen=True)
class Page:
    """What is written out of an outcome in a language: its whole, its calculation, its curves and tables."""

    outcome: Outcome[object]
    say: Language
    whole: Outcome[object]
    sheet: CalculationSheet
    leaves: tuple[Curve | Table, ...]


def runs_known(results: "Results") -> bool:
    """Whether the nodes of its runs are solved."""
    return "runs" in vars(results)


class WorkbenchResults(WorkbenchPanes):
    """`remedies`: step → its remedy, and the results that it is a remedy for.  `pages`: step → what was written of it
    last."""

    def __init__(self, session: Session) -> None:
        self._solving = False
        self._slow: Timer | None = None
        self._keep: Timer | None = None
        self._quiet_timers: dict[str, Timer] = {}  # what waits until nobody types
        self._mounting: AwaitMount | None = None  # the form of a further step
        super().__init__(session)

    def begin(self, session: Session) -> None:
        """Enter a design: nothing that was written holds for it."""
        super().begin(session)
        self.remedies: dict[str, tuple[Results, NearestRemedy]] = {}
        self._sought: dict[str, Results] = {}  # step → the results that a remedy is or was looked for
        self.pages: dict[str, Page] = {}
        self._slopes: tuple[Results | None, dict[str, Text]] = (None, {})  # of checks and inputs, by id and key
        self._unchosen: tuple[Results, Results] | None = None  # without [imbalance]: its own results, and those with it
        self._complaints: set[Place] = set()  # fields whose mistake is shown
        self._leaves: tuple[int, int, tuple[Curve | Table, ...]] = (0, 0, ())  # of a page and a shaft, those in view
        self._run_leaves: tuple[int, Language | None, str, tuple[Curve | Table, ...]] = (0, None, "", ())
        for timer in (self._keep, *self._quiet_timers.values()):
            if timer is not None:
                timer.stop()
        self._keep = None

    # --- in its time
    def when_quiet(self, what: str, do: Callable[[], object]) -> None:
        """Do what nobody waits for once nobody has typed for a while; asked for again, it waits anew."""
        self._stop_waiting(what)
        self._quiet_timers[what] = self.set_timer(TYPING, partial(self._now_if_quiet, what, do))

    def _now_if_quiet(self, what: str, do: Callable[[], object]) -> None:
        if self.app.typing:
            self.when_quiet(what, do)
        elif self.stands:
            self.call_later(do)

    def _stop_waiting(self, what: str) -> None:
        if (timer := self._quiet_timers.pop(what, None)) is not None:
            timer.stop()

    def edited(self) -> None:
        """The design has changed: solve, say what is not accepted, and keep the edit aside, each in its time."""
        self.solve()
        self.call_after_refresh(self._show_edit)  # the key is painted first
        if self._keep is None:
            self._keep = self.set_timer(KEEP, self._keep_now)

    def _show_edit(self) -> None:
        if self.stands:
            self.show_state()

    def _keep_now(self) -> None:
        """In another thread; a disk may be slow."""
        self._keep = None
        self.in_thread("keep", self._keep_aside)

    def _keep_aside(self) -> None:
        """Runs in another thread."""
        self.session.autosave()
        self.call_later(self.refresh_top_line)

    # --- solving
    def solve(self) -> None:
        """Solve what is to be solved, one at a time; an edit in the meantime stops it, and it begins once more."""
        if self._solving:
            return
        job = self.session.brief_job() or self.session.job()
        if job is None:
            self.query_one(TopLine).slow = False
            if self.session.current:
                self._go_ahead()  # what stopped for an entry that was not understood
            return
        self._solving = True
        self._slow = self.set_timer(SLOW, self._say_slow)
        self.in_thread("solve", partial(self._solve, job, self.session), exclusive=False)

    def _say_slow(self) -> None:
        if self._solving and self.stands:
            self.query_one(TopLine).slow = True
            self.refresh_top_line()
            self._set_stale(True)

    def _solve(self, job: Job, session: Session) -> None:
        """Runs in another thread."""

        def stop() -> bool:
            return job.stop() or self.session is not session  # another design was opened

        self.call_later(self._solved, run(replace(job, stop=stop)), session)

    def _solved(self, answer: Answer, session: Session) -> None:
        self._solving = False
        if self._slow is not None:
            self._slow.stop()
        if session is self.session:
            session.accept(answer)
        if not self.stands:  # it is solved again as soon as it does
            return
        if answer.brief and session.judged:
            self.call_later(self._show_ahead)
        elif self.session.job() is not None:  # edited in the meantime, or only judged and that failed
            self.solve()
        else:
            self.call_later(self._show)  # behind the keys that wait, of which the next may be an edit

    def _show_ahead(self) -> None:
        """The verdicts, ahead of the results."""
        if not self.stands or self._solving:  # edited in the meantime
            return
        self.checks.set_stale(False)
        self.show_verdicts()
        self.after_paint(self._go_on_solving)

    def _go_on_solving(self) -> None:
        if self.stands:
            self.solve()
            self.show_state()

    def _show(self) -> None:
        if not self.stands or self._solving or self.session.job() is not None:  # edited in the meantime
            return
        self.query_one(TopLine).slow = False
        self._set_stale(not self.session.current)
        self.show_verdicts()
        self.after_paint(self._follow_up)

    def _follow_up(self) -> None:
        """What may be shown a moment after the verdicts."""
        if self.stands:
            self.show_state()
            self.show_picture()
            self.write_out()

    def _set_stale(self, stale: bool) -> None:
        """Dim the results that do not belong to what the fields say."""
        for results in (Calculation, TableList):
            self.query_one(results).set_stale(stale)
        self.checks.set_stale(stale and not self.session.judged)

    # --- the calculation, written out
    def write_out(self) -> None:
        """Show the calculation of the step: at once where it is written already, else as soon as another thread has
        written it.

        One that is not on the screen is written once nobody types: what is there is painted first."""
        results = self.session.results
        if results is None:
            return
        if self._is_written(results, self.step):
            self.show_written()
            self._go_ahead()
            return
        write = partial(self.in_thread, "page", partial(self._write_page, results, self.step))
        if {"calculation", "curve"}.isdisjoint(self.shown_panes):
            self.when_quiet("page", write)
        else:
            self._stop_waiting("page")
            self.after_paint(write)

    def _write_page(self, results: "Results", step: Step) -> None:
        """Runs in another thread."""
        from ..widgets import plot  # noqa: F401  loaded here, so that the screen need not wait for it

        worker = get_current_worker()
        self._write_step(
            results, step, lambda: worker.is_cancelled or not self.is_attached or self.session.results is not results
        )
        if not worker.is_cancelled:
            self.call_later(self._wrote_page, results)

    def _wrote_page(self, results: "Results") -> None:
        if self.stands and results is self.session.results:
            self.write_out()

    def _is_written(self, results: "Results", step: Step) -> bool:
        """Whether what is written of a step is of these results, and in the user's language."""
        page = self.pages.get(step.key)
        return page is not None and page.outcome is results.outcomes[step.key] and page.say is self.app.say

    @property
    def page(self) -> Page | None:
        """What stands there of the step, if it is of the results as they are."""
        results, page = self.session.results, self.pages.get(self.step.key)
        if results is None or page is None or not self._is_written(results, self.step):
            return None
        return page if self.calculation.sheet is page.sheet else None

    def _write_step(self, results: "Results", step: Step, stop: Callable[[], bool]) -> None:
        """Write a step out and break it into rows, unless that is done; runs in any thread, until it is told to
        stop."""
        outcome, say = results.outcomes[step.key], self.app.say
        try:
            if not self._is_written(results, step):
                try:
                    whole = said(results.outcomes[step.key].whole, say)
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
                if not self._is_written(results, step):  # else another thread was sooner, and its page may stand there
                    self.pages[step.key] = page
            self.calculation.prepare(self.pages[step.key].sheet, stop)
        except (NoMatches, Cancelled):  # the screen is just being made anew, or nobody waits for it any more
            pass

    def _go_ahead(self) -> None:
        """While nobody types: the calculations of the other steps, and a remedy."""
        self.when_quiet("ahead", self._think_ahead)

    def _think_ahead(self) -> None:
        if self.stands:
            self.in_thread("ahead", self._write_ahead)
            self.seek_remedy()
            self.seek_runs()

    def _idle(self, results: "Results | None") -> bool:
        """Whether nothing has happened since these results: what goes on behind the screen stops at the next edit, to
        make room."""
        return self.is_attached and not self._solving and self.session.results is results and self.session.current

    def _write_ahead(self) -> None:
        """Runs in another thread."""
        results = self.session.results

        def stop() -> bool:
            self.app.rest(self)
            return not self._idle(results)

        for step in STEPS:
            if results is None or stop():
                return
            self._write_step(results, step, stop)

    # --- runs of the bench
    def seek_runs(self) -> None:
        """Solve the nodes of the runs, while nothing else is to be done; what is wrong with them is told."""
        results = self.session.results
        if results is None or not results.design.runs or runs_known(results) or not self.session.current:
            return
        try:
            results.demand_runs(self.session.document)
        except BadInput as bad:
            self.app.tell(bad.errors[0].reason)
        self.in_thread("runs", partial(self._solve_runs, results))

    def _solve_runs(self, results: "Results") -> None:
        """Runs in another thread."""
        worker = get_current_worker()

        def go_on() -> None:
            self.app.rest(self)
            if worker.is_cancelled or not self._idle(results):
                raise Cancelled

        try:
            with waited_for(go_on):
                results.runs  # noqa: B018  solved now, and kept with the results
        except Cancelled:
            return
        except Exception as error:  # a mistake of the program must not stop the session
            self.app.log(f"no runs: {type(error).__name__}: {error}")
            return
        self.call_later(self._solved_runs, results)

    def _solved_runs(self, results: "Results") -> None:
        if self.stands and results is self.session.results:
            self.show_verdicts()
            self.show_written()

    # --- remedies
    @property
    def _troubles(self) -> list[str]:
        """The steps whose limits fail: this one first, then in the order of the screen."""
        results = self.session.results
        if results is None or not self.session.current:
            return []
        steps = dict.fromkeys((self.step, *STEPS))
        return [step.key for step in steps if results.outcomes[step.key].verdict in ("fail", "no_solution")]

    @property
    def trouble(self) -> str:
        """The first of them; empty where none fails."""
        return next(iter(self._troubles), "")

    @property
    def remedy(self) -> "NearestRemedy | None":
        """The remedy for that step, if it is known already."""
        return self.known_remedy(self.trouble)

    def known_remedy(self, step: str) -> "NearestRemedy | None":
        """That of any step; none while the results are not those of the design as it is."""
        results, known = self.remedies.get(step, (None, None))
        return known if self.session.current and results is self.session.results else None

    def seek_remedy(self) -> None:
        """Look for a remedy for each step that fails, while nothing else is to be done: it is there when the step is
        opened."""
        results = self.session.results
        if results is None:
            return
        for step in self._troubles:
            if self._sought.get(step) is not results:
                self._sought[step] = results
                self.in_thread(f"remedy-{step}", partial(self._seek, step, self.session.document, results))

    def _seek(self, step: str, document: "Document", results: "Results") -> None:
        """Runs in another thread."""
        from calc.studies.repair.nearest import remedy

        worker = get_current_worker()

        def progress(share: float, what: str) -> None:
            self.app.rest(self)
            # a list of remedies has its own search
            if worker.is_cancelled or not self._idle(results) or not self.is_current:
                raise Cancelled

        try:
            with waited_for(lambda: progress(0.0, "")):
                nearest = remedy(document, step, results, progress)
        except Cancelled:
            self.call_later(self._stopped_seeking, step, results)
            return
        except Exception as error:  # a mistake of the program must not stop the session
            self.app.log(f"no remedy: {type(error).__name__}: {error}")
            return
        self.call_later(self._found_remedy, step, results, nearest)

    def _stopped_seeking(self, step: str, results: "Results") -> None:
        """It is looked for once more when somebody asks again."""
        if self._sought.get(step) is results:
            del self._sought[step]

    def _found_remedy(self, step: str, results: "Results", remedy: "NearestRemedy") -> None:
        self.remedies[step] = (results, remedy)
        if self.stands:
            self.show_remedy()

    # --- slopes: how far the inputs move a check, and what an input moves
    def want_slopes(self, check: Check) -> None:
        """Show the findings how far the inputs move this check, now or as soon as it is known."""
        if (known := self._known_slopes(check.id)) is not None:
            self.checks.show_slopes(check.id, known)
        else:
            self._seek_slopes("check", check.id)

    def want_ways(self, check: Check) -> None:
        """Look for what would help a check, and show it with the findings."""
        self.when_quiet("ways", partial(self.in_thread, "ways", partial(self._make_ways, check)))

    def _make_ways(self, check: Check) -> None:
        """Runs in another thread."""
        tuple(check.remedies)
        self.call_later(self._made_ways)

    def _made_ways(self) -> None:
        if self.stands:
            self.checks.rebuild()

    def _moved_by(self, key: str) -> Text:
        """What an input moves most, "film at the edge, front +0.45 µm per mm"; where it is not known it is looked for,
        and the foot of the form then shown anew."""
        if (known := self._known_slopes(key)) is None:
            self._seek_slopes("key", key)
        return known or EMPTY

    def _known_slopes(self, name: str) -> Text | None:
        if not self.session.current:
            return None
        if self._slopes[0] is not self.session.results:
            self._slopes = self.session.results, {}
        return self._slopes[1].get(name)

    def _seek_slopes(self, kind: str, name: str) -> None:
        """Of the last that is wanted: who runs through a list does not want all of it."""
        if self.session.current and self.session.results is not None:
            self.when_quiet(f"slopes of a {kind}", partial(self._begin_slopes, kind, name))

    def _begin_slopes(self, kind: str, name: str) -> None:
        results = self.session.results
        if self.stands and self.session.current and results is not None:
            self.in_thread(f"slopes of a {kind}", partial(self._find_slopes, name, self.session.document, results))

    def _find_slopes(self, name: str, document: "Document", results: "Results") -> None:
        """Runs in another thread."""
        from calc.studies.explain import effects, moved_by  # which brings the solver with it

        worker = get_current_worker()

        def stop() -> bool:
            self.app.rest(self)
            return worker.is_cancelled or results is not self.session.results

        check = next((check for check in results.checks() if check.id == name), None)
        try:
            if check is not None:
                words = slopes_of_check(document.data, check, effects(document, results, [check], MOVED, stop)[name])
            else:
                words = slopes_of_input(document.data, name, moved_by(document, results, name, stop))
        except Cancelled:
            return
        except Exception as error:  # a mistake of the program must not stop the session
            self.app.log(f"no slopes: {type(error).__name__}: {error}")
            return
        self.call_later(self._found_slopes, name, check is not None, results, words)

    def _found_slopes(self, name: str, check: bool, results: "Results", words: Text) -> None:
        if not self.stands or results is not self.session.results:
            return
        self._slopes = results, self._slopes[1] if results is self._slopes[0] else {}
        self._slopes[1][name] = words
        if check and words:
            self.checks.show_slopes(name, words)
        elif words:
            self.show_help()

    # --- showing the results
    def show_verdicts(self) -> None:
        """The checks and verdicts: first, and at once."""
        results = self.session.verdicts
        outcome, first = None, None
        if results is not None:
            from calc.studies.headlines import lead  # with numpy

            outcome = said(self._with_runs(results.outcomes[self.step.key]), self.app.say)
            first = lead(results, self.step.key, brief=True)
        self.checks.show(outcome, first or EMPTY)
        self._title_findings()
        self.refresh_top_line()  # the last line of the screen follows: what lies between two lines is painted with them

    def _with_runs(self, outcome: Outcome[object]) -> Outcome[object]:
        """With the checks of the runs of the step, once their nodes are solved."""
        results = self.session.results
        if results is None or not self.session.current or not runs_known(results) or results.runs is None:
            return outcome
        checks = tuple(column.check for column in results.runs.of_step(outcome.key))
        return replace(outcome, checks=(*outcome.checks, *checks)) if checks else outcome

    def _title_findings(self) -> None:
        """How many findings there are; beside other panes they say so themselves."""
        outcome = self.checks.outcome
        findings = open_findings(outcome.checks) if outcome is not None and not self.has_class("-wide") else []
        self.pane_named("checks").set_title(right=self.app.say(findings_of(findings)) if findings else "")

    def show_state(self) -> None:
        """Everything but the results: mistakes, verdicts of the steps, the message line."""
        complete = self._show_mistakes()
        self.pane_named("inputs").set_title(self.form_title())
        self.refresh_top_line()
        if complete:
            self.show_remedy()
            self.query_one(Steps).rebuild()
            self.query_one(StepBar).refresh()

    def _show_mistakes(self) -> bool:
        """Show which fields are not accepted, and dim the results; whether that is all that there is to say.

        A field that is being typed into gets a moment before it complains: False.
        """
        session = self.session
        reasons = session.reasons()
        here = self.form.here()
        late = {place for place in reasons if place == here and place not in self._complaints}
        self.form.refresh_fields({place: reason for place, reason in reasons.items() if place not in late})
        self._complaints = set(reasons) - late
        if late:
            self.when_quiet("complain", self._complain)
        else:
            self._stop_waiting("complain")
        self._set_stale(session.results is not None and not late and (not session.valid or bool(session.failure)))
        return not late

    def _complain(self) -> None:
        if self.stands:
            self._complaints = set(self.session.reasons())
            self.show_state()

    def show_remedy(self) -> None:
        session = self.session
        if session.valid and not session.current and session.results is not None:
            return  # what stands there stays until there are results: it would only flicker
        line = self.query_one(MessageLine)
        line.trouble, line.remedy = self.trouble, self.remedy
        line.redraw()
        self.checks.offer(line.beside and self.trouble == self.step.key and bool(line.offer()))
        self.show_keys()

    def show_finding(self) -> None:
        """The message line speaks of the finding under the cursor, while the findings have the focus, else of what is
        to do and how to get there from here."""
        if not self.stands:  # at the end of the program
            return
        line, checks = self.query_one(MessageLine), self.checks
        before, line.finding = line.finding, checks.key if checks.has_focus else ""
        line.redraw()
        if line.finding not in ("", before) and (shaft := self.session.shaft_of_finding(line.finding)) is not None:
            self.look_at(shaft)  # once: from there another may be leafed to

    def show_written(self) -> None:
        """The calculation, the curves and whatever else takes a moment to be prepared."""
        self.show_picture()
        page = self.pages.get(self.step.key)
        self.calculation.show(page.sheet if page is not None else CalculationSheet())
        leaves = (*self._in_view(page), *self._of_runs()) if page is not None else ()
        self.curve_pane.show(self.step.key, leaves, page is None)
        self.form.refresh_taken()
        self.show_keys()

    def _of_runs(self) -> tuple[Curve | Table, ...]:
        """The curve and the table of each column of a run that is of this step, once its nodes are solved."""
        results, say, key = self.session.results, self.app.say, self.step.key
        if results is None or not runs_known(results):
            return ()
        if self._run_leaves[:3] != (id(results), say, key):
            columns = results.runs.of_step(key) if results.runs is not None else []
            made = tuple(in_language(leaf, say) for column in columns for leaf in (column.curve, column.table))
            self._run_leaves = (id(results), say, key, made)
        return self._run_leaves[-1]

    def _in_view(self, page: Page) -> tuple[Curve | Table, ...]:
        """What a page has of all shafts and of the one in view: values of that alone; the curves and tables of a twin
        are its original's, but for bearings of its own."""
        session = self.session
        if not self.leafs:
            return page.leaves
        if self._leaves[:2] != (id(page), session.shaft):
            here, own = session.shafts[session.shaft], session.own(page.outcome.key)
            others = [name for name in session.shafts if name not in (here, own)]
            leaves = [leaf for leaf in page.leaves if leaf.id.partition(".")[0] not in others]
            hidden = tuple(f"{page.outcome.key}.{name}." for name in session.shafts if name != here)
            self._leaves = (
                id(page),
                session.shaft,
                tuple(
                    replace(leaf, rows=tuple(row for row in leaf.rows if not str(row[-1]).startswith(hidden)))
                    if isinstance(leaf, Table) and leaf.id == VALUES
                    else leaf
                    for leaf in leaves
                ),
            )
        return self._leaves[-1]

    def look_at(self, shaft: int) -> None:
        """Put another shaft in view, with its wheel; where a field of the one before has the focus, the same of this
        one gets it."""
        session, form = self.session, self.form
        if shaft == session.shaft:
            return
        before, session.shaft = session.original, shaft
        chosen = self.curve_pane.chosen
        for step, id in chosen.items():
            if id.startswith(f"{before}."):
                chosen[step] = f"{session.original}.{id.removeprefix(f'{before}.')}"
        wheels = content_at(session.data, WHEELS) or []
        name, here = session.shafts[shaft], form.here()
        for n in (n for n, wheel in enumerate(wheels) if wheel.get(SITS_ON) == name):
            form.chosen[WHEELS] = n  # in step 5: the wheel that drives it
        if here is not None and len(here) > 1 and here[:1] == SHAFTS:
            form.rebuild((*SHAFTS, session.shaft, *here[2:]))
        else:
            form.refresh_fields(session.reasons())
        self.pane_named("inputs").set_title(self.form_title())
        self.show_written()

    def show_picture(self) -> None:
        """The picture of the step, with what the edited field changes lit."""
        field, results = self._field, self._pictured()
        lit = named_key(self.session.data, field.place) if field is not None else ""
        of_shaft = self.leafs and self.step.key in OF_SHAFTS
        self.pane_named("picture").set_title(right=self.session.own(self.step.key) if of_shaft else "")
        self.query_one(Picture).show(self.step.key, results.design if results is not None else None, results, lit)

    def _pictured(self) -> "Results | None":
        """The results, of several shafts with that in view alone; where it is asked which balancing, and none is chosen
        yet, with the usual counterweights."""
        session = self.session
        results = session.view(self.step.key) if self.step.key in OF_SHAFTS else session.results
        if results is None or self.step.key != "imbalance" or "imbalance" in session.data or not session.current:
            return results
        if self._unchosen is None or self._unchosen[0] is not results:
            from calc.studies.starter.balancing import with_imbalance

            self._unchosen = results, with_imbalance(session.document, results)
        return self._unchosen[1]

    def set_out(self) -> None:
        super().set_out()
        if self._whole and self.is_mounted:
            self._title_findings()
            self.show_keys()

    def refresh_top_line(self) -> None:
        super().refresh_top_line()
        if self._whole:
            self.show_keys()

    @property
    def _whole(self) -> bool:
        """Whether what the last line and the titles tell of is there: at the end it goes before they do."""
        try:
            return self.stands and self.checks.is_attached and self.curve_pane.is_attached
        except NoMatches:
            return False

    def show_keys(self) -> None:
        """The footer leaves out first what does nothing here."""
        pane, results = self.curve_pane, self.session.results
        sound = self.session.valid and results is not None and all(c.verdict not in URGENT for c in results.checks())
        unseen = self.wide and "curve" not in self.shown_panes
        idle = {
            "variant": unseen or pane.curve is None or (len(pane.curve.variants) < 2 and not pane.walks),
            "curve": len(pane.leaves) < 2,
            "trouble": sound,
            "fix": sound,
            "choose": bool(no_choice(self.step.key, self.session.data)),
            "undo": not self.session.history.begun,
            "redo": not self.session.history.undone,
            "save": not self.session.dirty,
        }
        self.query_one(FooterLine).show(tuple(id for id, nothing in idle.items() if nothing), leafs=self.leafs)

    def show_help(self) -> None:
        """The foot of the form: about the field that has the focus."""
        if not self.stands or self.form_of(self.step) is None:  # another form may just be on its way
            return
        source, say, foot = self._field or self.focused, self.app.say, self.query_one(FieldHelp)
        self.show_picture()
        if isinstance(source, Field):
            moves = self._moved_by(named_key(self.session.data, source.place))
            foot.show(*source.explained(), say(Text("Moves {moved}.", moved=moves)) if moves else "")
        elif isinstance(source, (ArrayHeading, TableHeading, Fold, Radio, Taken)):
            foot.show(*source.explained())
        elif source is not None and self.pane == "inputs":
            foot.show("", say(Text("Tab ↓: to the fields")))
        else:
            foot.show("", "")

    @property
    def _field(self) -> Field | None:
        form = self.form_of(self.step)
        return form.field if form is not None else None

    # --- the step that is shown
    def show_step(self) -> None:
        """The parts that name the step."""
        steps, bar = self.query_one(Steps), self.query_one(StepBar)
        steps.current = bar.current = self.query_one(MessageLine).step = self.step.key
        self.query_one("#inputs", Pane).set_title(self.form_title())
        self.show_verdicts()
        self.show_written()
        self.show_state()
        self.write_out()
        steps.go_to(self.step.key)
        self.show_remedy()
        self.seek_remedy()
        self.when_quiet("form", self._make_form)

    async def open_step(self, step: Step, focus: Place | None = None, *, stay: bool = False) -> None:
        """Show another step, with the focus on a field if one had it before; `stay` leaves the focus where it is.

        Of a step that the design does not have the inputs are shown, which say how to go on."""
        if step is not self.step:
            self._put_back_stray()
        if not asks(self.session.data, step.key):
            self.at_pane("inputs")
        idle = focus is None and isinstance(self.focused, Form)
        inside = not stay and (self.pane == "inputs" or focus is not None)
        if focus is not None and len(focus) > 1 and focus[:1] == SHAFTS:
            self.look_at(int(focus[1]))
        before = self.step
        with self.app.batch_update():
            if step is not before:
                if self.pane == "inputs":
                    self.set_focus(None, scroll_visible=False)
                self.form.display = False
                self.step = step
                await self._show_form(step)
                if not self.stands:  # the end came before the form
                    return
            if inside and idle:
                self.set_focus(self.form, scroll_visible=False)
            elif inside:
                self.form.focus_place(focus, at_once=True)  # before the picture, in which its field is lit
            if step is not before:
                self.show_step()

    async def _show_form(self, step: Step) -> None:
        """The form of a step, made where it has none yet."""
        if (form := self.form_of(step)) is None:
            await self._add_form(Form(step, self.session))
            return
        if self._mounting is not None:  # that of this step, maybe
            await self._mounting
        form.display = True

    def _add_form(self, form: Form) -> AwaitMount:
        return self.query_one("#forms").mount(form)

    async def _make_form(self) -> None:
        """The form of a further step, hidden, so that the step opens at once: it takes a tenth of a second."""
        if not self.stands:
            return
        at = STEPS.index(self.step)
        steps = (step for step in (*STEPS[at:], *STEPS[:at]) if not step.optional)
        step = next((step for step in steps if self.form_of(step) is None), None)
        if step is None:
            return
        if not self.is_current:
            self.when_quiet("form", self._make_form)
            return
        form = Form(step, self.session)
        form.display = False
        self._mounting = self._add_form(form)
        await self._mounting
        self._mounting = None
        self.call_after_refresh(self._now_if_quiet, "form", self._make_form)

    def _put_back_stray(self) -> None:
        """A step is gone to past a lone digit, with no Enter after it: the number stays as it was."""
        if (field := self.form.field) is not None and field.stray:
            stays = Text(
                "{label} stays {was}: {digit} was not accepted (Enter or Tab accept it)",
                label=field.about.label,
                was=Name(field.was),
                digit=Name(field.box.value),
            )
            field.restore()
            self.app.tell(stays)
