# SPDX-License-Identifier: Apache-2.0
"""The list of steps: sign, number, title, and the one value that stands for each."""

from textual.content import Content

from calc.design import STEPS
from calc.languages import Language
from calc.sheet.step import Outcome
from calc.sheet.text import Amount, Text

from ..session import Session
from .item_list import Item, ItemList
from .signs import Signs
from .wrap import fit

NUMBERS = {step.title: n for n, step in enumerate(STEPS, 1)}


def headline(session: Session, key: str, say: Language) -> str:
    """The value that stands for a step, or what it waits for."""
    from calc.sheet.expression import plain

    outcome = session.results.outcomes.get(key) if session.results is not None else None
    if outcome is None or key not in session.data:
        return say(Text("not used")) if key not in session.data else ""
    if outcome.state == "blocked":
        return say(outcome.reason)
    if outcome.state == "no_solution":
        return say(Text("no solution"))
    values = session.values()
    step = next(step for step in STEPS if step.key == key)
    if (id := step.headline(values)) is None:
        return ""
    value = values[id]
    number = say.part(Amount(value.shown, value.unit, digits=3))
    return f"{plain(value.symbol)} {number}" if value.symbol else number


def state_of(session: Session, outcome: Outcome[object] | None, key: str, wrong: set[str]) -> str:
    """The state of a step for its sign."""
    if key in wrong:
        return "invalid"
    if key not in session.data:
        return "not_asked"
    return outcome.verdict if outcome is not None else "blocked"


class Steps(ItemList):
    """The key of an item is the key of its step."""

    def __init__(self, session: Session) -> None:
        super().__init__(id="steps-list")
        self.session = session
        self.current = STEPS[0].key

    def build(self, width: int) -> list[Item]:
        signs: Signs = self.app.signs
        wrong = {str(place[0]) for place in self.session.reasons() if place}
        outcomes = self.session.results.outcomes if self.session.results is not None else {}
        items = []
        for n, step in enumerate(STEPS, 1):
            state = state_of(self.session, outcomes.get(step.key), step.key, wrong)
            here = step.key == self.current
            mark = signs.mark(state) if outcomes or state == "invalid" else signs.mark("solving")
            title = fit(f"{n} {self.app.say(step.title)}", width - 4)
            end = signs.mark("here") if here else ""
            gap = " " * max(1, width - 2 - len(title) - len(end) - 1)
            first = Content.assemble((mark, signs.style(state)), " ", (title, "bold" if here else ""), gap, (end, "bold"))
            items.append(
                Item(step.key, [first, Content.styled("    " + fit(headline(self.session, step.key, self.app.say), width - 4), "dim")])
            )
        return items
