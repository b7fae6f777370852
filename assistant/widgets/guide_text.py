# SPDX-License-Identifier: Apache-2.0
"""At the head of a form: the question of the step, and what a good answer looks like or, where a check fails, what to try."""

from textual.content import Content
from textual.widgets import Static

from calc.sheet.text import Text

from ..base_app import BaseApp
from ..guide import GUIDES
from ..session.route import ROUTE
from ..session.session import Session


class GuideText(Static):
    app: BaseApp

    def __init__(self, session: Session, step: str) -> None:
        super().__init__(classes="guide")
        self.session, self.step = session, step
        self._shown: Text | None = None
        self._guiding = True

    def on_mount(self) -> None:
        self.redraw()

    def redraw(self) -> None:
        say = self.app.say
        guide, results = GUIDES[self.step], self.session.results
        fails = results is not None and results.outcomes[self.step].verdict in ("fail", "no_solution")
        word, text = (Text("Try"), guide.trying) if fails else (Text("Good"), guide.good)
        if word != self._shown or self.app.guiding != self._guiding:
            self._shown, self._guiding = word, self.app.guiding
            question = Content.styled(say(ROUTE[self.step].question), "bold")
            self.update(Content.assemble(question, f"\n{say(word)}: {say(text)}") if self._guiding else question)
