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
            here = {place: reason for place, reason in reasons.items() if place and place[0] == self.step}
            place, reason = next(iter((here or reasons).items()))
            step = "" if here else self._title(str(place[0]) if place else "")
            more = "  " + say(f"({len(reasons)} in all)") if len(reasons) > 1 else ""
            what = key_at(place) or say("the design")
            return "invalid", f"{step}{what}: {say(reason)}{more}. {say('The results are those of the last valid input.')}"
        if session.failure:
            return "fail", session.failure
        if session.results is None:
            return "solving", say("solving …")
        outcome = session.results.outcomes[self.step]
        if outcome.state in ("blocked", "no_solution"):
            return outcome.state, say(outcome.reason)
        checks = sorted_checks(outcome.checks)
        if checks and checks[0].verdict != "pass":
            bad = sum(c.verdict != "pass" for c in checks)
            return checks[0].verdict, self._check(checks[0]) + ("  " + say(f"({bad} of {len(checks)} checks here)") if bad > 1 else "")
        outcomes = [(other.key, session.results.outcomes[other.key]) for other in STEPS]
        worst = [(key, found[0]) for key, other in outcomes if (found := sorted_checks(other.checks))]
        for key, check in worst:
            if check.verdict == "fail":
                return "fail", self._title(key) + self._check(check)
        for key, other in outcomes:
            if other.state in ("blocked", "no_solution"):
                return other.state, self._title(key) + say(other.reason)
        for key, check in worst:
            if check.verdict == "warn":
                return "warn", self._title(key) + self._check(check)
        return "pass", say("every check passes")

    def _title(self, key: str) -> str:
        return next((f"{n} {self.app.say(step.title)}: " for n, step in enumerate(STEPS, 1) if step.key == key), "")

    def _check(self, check: Check) -> str:
        value = f"{short(check.value)} {check.unit}".rstrip()
        say = self.app.say
        advice = say(check.advice)
        advice = f". {advice}" if advice else ""
        needs = say("only just" if check.narrow else "should be" if check.kind == "advice" else "needs")
        return f"{say(check.name)} {value}, {needs} {say(check.limit_text())}{advice}"

    def offer(self) -> str:
        """What a key would mend of the step that fails."""
        if self.remedy is None or not self.session.valid:
            return ""
        key, say = self.app.shown_key("mend"), self.app.say
        if not self.remedy.changes:
            found = "; ".join(f"{say(one.name)}: {say(one.why)}" for one in self.remedy.left)
            return f"{say('No remedy was found')}: {found}"
        where = "" if self.trouble == self.step else self._title(self.trouble)
        mends = say(f"{key} mends it")
        then = self.app.signs.mark("then")
        return f"{where}{mends}: {say(self.remedy.words).replace('→', then)} {then} {say(self.remedy.said)}"

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
