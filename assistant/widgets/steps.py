# SPDX-License-Identifier: Apache-2.0
"""The list of steps: sign, number and title, the state in words, and the value that decides with its bar; at the end, whether it is ready."""

from textual.content import Content

from calc.design import STEPS
from calc.headlines import headline
from calc.ready import StepState, ready, readiness
from calc.sheet.text import Text, plural

from ..places import Place
from ..session import Session
from .bar import bar
from .item_list import Item, ItemList
from .signs import Signs
from .wrap import fit

READY = "ready"  # the key of the row behind the steps


def states_of(session: Session) -> tuple[StepState, ...]:
    """The state of every step of a design under edit."""
    return readiness(session.data, session.results, map(_dotted, session.reasons()))


def _dotted(place: Place) -> str:
    return ".".join(map(str, place))


class Steps(ItemList):
    """The key of an item is the key of its step, or READY."""

    def __init__(self, session: Session) -> None:
        super().__init__(id="steps-list")
        self.session = session
        self.current = STEPS[0].key

    def build(self, width: int) -> list[Item]:
        states = states_of(self.session)
        items = [Item(state.key, self._step(n, state, width)) for n, state in enumerate(states, 1)]
        items.append(Item(READY, self._ready(states, width)))
        if sum(len(item.rows) + 1 for item in items) > self.size.height + 1:
            return items
        return [one for item in items for one in (item, Item("", [Content("")]))]

    def _step(self, n: int, state: StepState, width: int) -> list[Content]:
        signs: Signs = self.app.signs
        say, here = self.app.say, state.key == self.current
        title = fit(f"{n} {say(STEPS[n - 1].title)}", width - 4)
        end = signs.mark("here") if here else ""
        gap = " " * max(1, width - 2 - len(title) - len(end) - 1)
        style = signs.style(state.state)
        loud = style if state.state in ("needs", "fail", "not_verified", "warn") else "dim"
        rows = [
            Content.assemble((signs.mark(state.state), style), " ", (title, "bold" if here else ""), gap, (end, "bold")),
            Content.assemble("    ", (fit(say(state.words), width - 4), loud)),
        ]
        results = self.session.results
        shown = headline(results, state.key) if results is not None and state.state in ("fail", "not_verified", "warn", "ready") else None
        if shown is not None:
            rows.append(Content.assemble("    ", (fit(say(shown.text), width - 4), "")))
            if shown.share is not None and shown.check is not None:
                verdict = signs.style(shown.check.verdict)
                rows.append(Content.assemble("    ", bar(shown.share, signs, verdict), (f" {say(shown.check.margin_text())}", verdict)))
        return rows

    def _ready(self, states: tuple[StepState, ...], width: int) -> list[Content]:
        """The last row: whether all is done, or how many steps are left."""
        signs, say, done = self.app.signs, self.app.say, ready(states)
        left = sum(not state.done for state in states)
        mark = "ready" if done else "todo"
        words = Text("every limit holds") if done else plural("{n} step left", "{n} steps left", n=left)
        style = signs.style(mark)
        return [
            Content.assemble((signs.mark(mark), style), "   ", (say(Text("Ready")), "bold" if done else "")),
            Content.assemble("    ", (fit(say(words), width - 4), style if done else "dim")),
        ]


