# SPDX-License-Identifier: Apache-2.0
"""What of the results stands on the main screen, and what it says of the field that is being edited."""

from typing import TYPE_CHECKING

from calc.design.key_values import judged
from calc.locale.language import said
from calc.sheet.check import URGENT
from calc.sheet.text import Text, plural

from ..offers import CHOICES
from ..session.calculation import CalculationSheet
from ..session.places import named_key
from ..widgets.field import Field
from ..widgets.form import Taken
from ..widgets.headings import ArrayHeading, Fold, TableHeading
from ..widgets.lines import FooterLine, MessageLine
from ..widgets.picture import Picture
from ..widgets.radio import Radio
from ..widgets.rows import FieldHelp
from .background_solve import BackgroundSolve
from .host import Host
from .slopes import Slopes

if TYPE_CHECKING:
    from calc.solve import Results


class ResultsView:
    def __init__(self, host: Host, background: BackgroundSolve, slopes: Slopes) -> None:
        self._host, self._background, self._slopes = host, background, slopes
        self._unchosen: tuple[Results, Results] | None = (
            None  # of a design without [imbalance]: its own results, and those with it
        )

    def show_remedy(self) -> None:
        host, session = self._host, self._host.session
        if session.valid and not session.current and session.results is not None:
            return  # what stands there stays until there are results: it would only flicker
        line = host.query_one(MessageLine)
        line.trouble, line.remedy = self._background.trouble, self._background.remedy
        line.redraw()
        self.show_keys()

    def show_verdicts(self) -> None:
        host, results = self._host, self._host.session.results
        outcome = said(results.outcomes[host.step.key], host.app.say) if results is not None else None
        host.checks.show(outcome)
        if outcome is not None:
            good = sum(judged(c, outcome.checks) == "pass" for c in outcome.checks)
            count = len(outcome.checks)
            passing = plural("{passing} of {n} check passes", "{passing} of {n} checks pass", n=count, passing=good)
            host.pane_named("checks").set_title(right=host.app.say(passing) if count else "")
        host.refresh_top_line()  # the last line of the screen follows: what lies between two lines is painted with them

    def show_finding(self) -> None:
        """The message line speaks of the finding under the cursor, while the findings have the focus."""
        if not self._host.stands:  # at the end of the program
            return
        line, checks = self._host.query_one(MessageLine), self._host.checks
        line.finding = checks.key if checks.has_focus else ""
        line.redraw()

    def show_written(self) -> None:
        host = self._host
        self.show_picture()
        page = self._background.pages.get(host.step.key)
        host.calculation.show(page.sheet if page is not None else CalculationSheet())
        host.curve_pane.show(host.step.key, page.leaves if page is not None else (), page is None)
        host.form.refresh_taken()
        self.show_keys()

    def show_picture(self) -> None:
        """The picture of the step, with what the edited field changes lit."""
        session, field = self._host.session, self._field
        lit = named_key(session.data, field.place) if field is not None else ""
        results = self._pictured()
        self._host.query_one(Picture).show(
            self._host.step.key, results.design if results is not None else None, results, lit
        )

    def _pictured(self) -> "Results | None":
        """The results; where it is asked which balancing, and none is chosen yet, with the usual counterweights."""
        session = self._host.session
        results = session.results
        if results is None or self._host.step.key != "imbalance" or "imbalance" in session.data or not session.current:
            return results
        if self._unchosen is None or self._unchosen[0] is not results:
            from calc.studies.starter.balancing import with_imbalance

            self._unchosen = results, with_imbalance(session.document, results)
        return self._unchosen[1]

    def show_keys(self) -> None:
        """The footer leaves out first what does nothing here."""
        host, pane, results = self._host, self._host.curve_pane, self._host.session.results
        sound = host.session.valid and results is not None and all(c.verdict not in URGENT for c in results.checks())
        idle = {
            "variant": pane.curve is None or len(pane.curve.variants) < 2,
            "curve": len(pane.leaves) < 2,
            "trouble": sound,
            "fix": sound,
            "choose": host.step.key not in CHOICES,
        }
        host.query_one(FooterLine).show(tuple(id for id, nothing in idle.items() if nothing))

    def show_help(self) -> None:
        """The foot of the form: about the field that has the focus."""
        host = self._host
        if not host.stands or not self._opened:
            return
        source, say, foot = self._field or host.focused, host.app.say, host.query_one(FieldHelp)
        self.show_picture()
        if isinstance(source, Field):
            moves = self._slopes.of_key(named_key(host.session.data, source.place), lambda words: self.show_help())
            foot.show(*source.explained(), say(Text("Moves {moved}.", moved=moves)) if moves else "")
        elif isinstance(source, (ArrayHeading, TableHeading, Fold, Radio, Taken)):
            foot.show(*source.explained())
        elif source is not None and host.pane_layout.pane == "inputs":
            foot.show(
                say(Text("No field is being edited")),
                say(Text("letters act as keys; Tab or ↓ goes back to the fields.")),
            )
        else:
            foot.show("", "")

    @property
    def _opened(self) -> bool:
        """Whether the form of the step is there: another one may just be on its way."""
        return any(form.step is self._host.step for form in self._host.forms())

    @property
    def _field(self) -> Field | None:
        return self._host.form.field if self._opened else None
