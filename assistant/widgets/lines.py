# SPDX-License-Identifier: Apache-2.0
"""What matters most now: why an input is not accepted, what a step waits for, or a finding, that under the cursor or the worst."""

from typing import TYPE_CHECKING

from textual.content import Content
from textual.widget import Widget

from calc.design.model import STEPS
from calc.design.key_values import judged
from calc.sheet.check import URGENT, Check
from calc.sheet.text import EMPTY, Amount, Text

from ..base_app import BaseApp
from ..session.places import label_of, named_key
from ..session.route import step_of
from ..session.session import Session
from .steps import nothing_left, states_of
from .text import fit, wrap

if TYPE_CHECKING:
    from calc.studies.repair.nearest import Remedy


ROWS = 2


class MessageLine(Widget):
    app: BaseApp

    def __init__(self, session: Session) -> None:
        super().__init__(id="message-line")
        self.session = session
        self.step = STEPS[0].key
        self.finding = ""  # the check under the cursor, where the findings have the focus
        self.trouble = ""  # the step that fails
        self.remedy: Remedy | None = None  # its remedy, as soon as it is known
        self._shown: tuple[str, ...] = ()

    def redraw(self) -> None:
        """Draw anew if there is something new to draw."""
        shown = (*self.message(), self.offer())
        if shown != self._shown:
            self._shown = shown
            self.refresh()

    def message(self) -> tuple[str, str]:
        """The state and the text."""
        session, say = self.session, self.app.say
        reasons = session.reasons()
        if reasons:
            mine = {place: reason for place, reason in reasons.items() if step_of(place) == self.step}
            place, reason = next(iter((mine or reasons).items()))
            step = "" if mine else self._title(step_of(place))
            text = Text(
                "{key}: {reason}",
                key=label_of(session.data, named_key(session.data, place)) if place else Text("the design"),
                reason=reason,
            )
            if len(reasons) > 1:
                text = Text("{mistake}  ({n} in all)", mistake=text, n=len(reasons))
            return "invalid", step + say(Text("{mistake}. The results are those of the last valid input.", mistake=text))
        if session.failure:
            return "fail", say(session.failure)
        if session.results is None:
            return "solving", say(Text("solving …"))
        outcome = session.results.outcomes[self.step]
        if outcome.state in ("blocked", "no_solution"):
            return outcome.state, say(outcome.reason)
        here = next((check for check in outcome.checks if check.id == self.finding), None)
        if here is not None:
            return judged(here, outcome.checks), self._check(here)
        states = states_of(session)
        todo = next((n for n, state in enumerate(states) if state.state == "todo"), None)
        ahead = Text("Enter goes on: {n} {step} is to do.", n=todo + 1, step=STEPS[todo].title) if todo is not None else EMPTY
        checks = outcome.checks
        if ahead and outcome.verdict == "not_verified" and nothing_left(states, self.step):
            return "todo", say(ahead)
        if checks and (first := outcome.causes[0][0]).verdict in URGENT:
            bad = sum(c.verdict in URGENT for c in checks)
            more = "  " + say(Text("({n} of {count} checks here)", n=bad, count=len(checks))) if bad > 1 else ""
            return first.verdict, self._check(first) + more
        outcomes = [(other.key, session.results.outcomes[other.key]) for other in STEPS]
        worst = [(key, other.causes[0][0]) for key, other in outcomes if other.checks]
        for key, check in worst:
            if check.verdict == "fail":
                return "fail", self._title(key) + self._check(check)
        for key, other in outcomes:
            if other.state in ("blocked", "no_solution"):
                return other.state, self._title(key) + say(other.reason)
        for key, check in worst:
            if check.verdict in URGENT:
                return check.verdict, self._title(key) + self._check(check)
        if ahead:
            return "todo", say(ahead)
        return "pass", say(Text("Nothing fails, no caution is open."))

    def _title(self, key: str) -> str:
        return next((f"{n} {self.app.say(step.title)}: " for n, step in enumerate(STEPS, 1) if step.key == key), "")

    def _check(self, check: Check) -> str:
        soft = check.kind in ("advice", "method")
        needs = Text("only just") if check.narrow else Text("should be") if soft else Text("needs")
        parts = {"check": check.name, "value": Amount(check.value, check.unit), "needs": needs, "limit": check.limit_text()}
        text = Text("{check} {value}, {needs} {limit}", **parts)
        return self.app.say(Text("{check}. {advice}", check=text, advice=check.advice) if check.advice else text)

    def offer(self) -> str:
        """Where to find what would help the step that fails, and the nearest design that passes."""
        if self.remedy is None or not self.session.valid:
            return ""
        key, say = self.app.shown_key("fix"), self.app.say
        where = "" if self.trouble == self.step else self._title(self.trouble)
        if not self.remedy.changes:
            return where + say(Text("{key} shows what would help", key=key))
        then = self.app.signs.mark("then")
        shown = Text("{key} shows what would help: {change}", key=key, change=self.remedy.words)
        return f"{where}{say(shown).replace('→', then)} {then} {say(self.remedy.said)}"

    def render(self) -> Content:
        state, text = self.message()
        signs = self.app.signs
        if state != "invalid" and (offer := self.offer()):
            width = max(10, self.size.width - 4)
            title = self._title(self.trouble)
            rows = [fit(text, width), fit(offer.removeprefix(title) if text.startswith(title) else offer, width)]
            return Content.assemble((f" {signs.mark(state)} {rows[0]}", signs.style(state)), f"\n   {rows[1]}")
        rows = wrap(text, max(10, self.size.width - 4), 0)
        if len(rows) > ROWS:
            rows[ROWS - 1] = fit(rows[ROWS - 1] + " " + rows[ROWS], max(10, self.size.width - 4))
        mark = signs.mark(state)
        lines = [f" {mark} {rows[0]}", *(f"   {row}" for row in rows[1:ROWS])]
        return Content("\n").join(Content.styled(line, signs.style(state)) for line in lines)
