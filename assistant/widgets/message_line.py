# SPDX-License-Identifier: Apache-2.0
"""What matters most now: why the input is not accepted, what a step waits for, or the worst check with its advice."""

from typing import TYPE_CHECKING

from textual.content import Content
from textual.widget import Widget

from calc.design import STEPS
from calc.sheet.check import Check
from calc.sheet.number import short

from ..places import key_at
from ..session import Session
from .checks import sorted_checks
from .wrap import fit, wrap

if TYPE_CHECKING:
    from calc.remedies.remedy import Remedy

    from ..app import ContralberoApp

ROWS = 2


class MessageLine(Widget):
    app: "ContralberoApp"

    def __init__(self, session: Session) -> None:
        super().__init__(id="message-line")
        self.session = session
        self.step = STEPS[0].key
        self.trouble = ""  # the step that fails
        self.remedy: Remedy | None = None  # what mends it, as soon as it is known

    def message(self) -> tuple[str, str]:
        """The state and the text."""
        session = self.session
        reasons = session.reasons()
        if reasons:
            here = {place: reason for place, reason in reasons.items() if place and place[0] == self.step}
            place, reason = next(iter((here or reasons).items()))
            step = "" if here else self._title(str(place[0]) if place else "")
            more = f"  ({len(reasons)} in all)" if len(reasons) > 1 else ""
            return "invalid", f"{step}{key_at(place) or 'the design'}: {reason}{more}. The results are those of the last valid input."
        if session.failure:
            return "fail", session.failure
        if session.results is None:
            return "solving", "solving …"
        outcome = session.results.outcomes[self.step]
        if outcome.state in ("blocked", "no_solution"):
            return outcome.state, outcome.reason
        checks = sorted_checks(outcome.checks)
        if checks and checks[0].verdict != "pass":
            bad = sum(c.verdict != "pass" for c in checks)
            return checks[0].verdict, self._check(checks[0]) + (f"  ({bad} of {len(checks)} checks here)" if bad > 1 else "")
        outcomes = [(other.key, session.results.outcomes[other.key]) for other in STEPS]
        worst = [(key, found[0]) for key, other in outcomes if (found := sorted_checks(other.checks))]
        for key, check in worst:
            if check.verdict == "fail":
                return "fail", self._title(key) + self._check(check)
        for key, other in outcomes:
            if other.state in ("blocked", "no_solution"):
                return other.state, self._title(key) + other.reason
        for key, check in worst:
            if check.verdict == "warn":
                return "warn", self._title(key) + self._check(check)
        return "pass", "every check passes"

    def _title(self, key: str) -> str:
        return next((f"{n} {step.title}: " for n, step in enumerate(STEPS, 1) if step.key == key), "")

    def _check(self, check: Check) -> str:
        value = f"{short(check.value)} {check.unit}".rstrip()
        advice = (
            f": {check.advice[:1].lower()}{check.advice[1:]}"
            if check.advice[1:2].islower()
            else f": {check.advice}"
            if check.advice
            else ""
        )
        needs = "should be" if check.kind == "advice" else "needs"
        return f"{check.name} {value}, {needs} {check.limit_text()}{advice}"

    def offer(self) -> str:
        """What a key would mend of the step that fails."""
        if self.remedy is None or not self.session.valid or not self.session.current:
            return ""
        key = self.app.shown_key("mend")
        if not self.remedy.changes:
            return "No remedy was found: " + "; ".join(f"{one.name}: {one.why}" for one in self.remedy.left)
        where = "" if self.trouble == self.step else self._title(self.trouble)
        return f"{where}{key} mends it: {self.remedy.words} {self.app.signs.mark('then')} {self.remedy.said}"

    def render(self) -> Content:
        state, text = self.message()
        signs = self.app.signs
        if state != "invalid" and (offer := self.offer()):
            width = max(10, self.size.width - 4)
            rows = [fit(text, width), fit(offer, width)]
            return Content.assemble((f" {signs.mark(state)} {rows[0]}", signs.style(state)), f"\n   {rows[1]}")
        rows = wrap(text, max(10, self.size.width - 4), 0)
        if len(rows) > ROWS:
            rows[ROWS - 1] = fit(rows[ROWS - 1] + " " + rows[ROWS], max(10, self.size.width - 4))
        mark = signs.mark(state)
        lines = [f" {mark} {rows[0]}", *(f"   {row}" for row in rows[1:ROWS])]
        return Content("\n").join(Content.styled(line, signs.style(state)) for line in lines)
