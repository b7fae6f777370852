# SPDX-License-Identifier: Apache-2.0
"""At the head of a form: what is to be decided in this step, and what a good answer looks like or, where a check fails, what to try."""

from textual.content import Content
from textual.widgets import Static

from calc.sheet.text import Text

from ..base_app import BaseApp
from ..guide import GUIDES
from ..session import Session


class GuideText(Static):
    app: BaseApp

    def __init__(self, session: Session, step: str) -> None:
        super().__init__(classes="guide")
        self.session, self.step = session, step
        self._shown: Text | None = None

    def on_mount(self) -> None:
        self.redraw()

    def redraw(self) -> None:
        say = self.app.say
        guide, results = GUIDES[self.step], self.session.results
        fails = results is not None and results.outcomes[self.step].verdict in ("fail", "no_solution")
        word, text = (Text("Try"), guide.trying) if fails else (Text("Good"), guide.good)
        self.display = self.app.guiding
        if word != self._shown:
            self._shown = word
            self.update(
                Content.assemble((f"{say(Text('Decide'))}: ", "bold"), f"{say(guide.decide)}\n", (f"{say(word)}: ", "bold"), say(text))
            )
