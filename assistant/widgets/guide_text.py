# SPDX-License-Identifier: Apache-2.0
"""At the head of a form: what is to be decided in this step, and what a good answer looks like or, where a check fails, what to try."""

from typing import TYPE_CHECKING

from textual.content import Content
from textual.widgets import Static

from ..guide import GUIDES
from ..session import Session

if TYPE_CHECKING:
    from ..app import ContralberoApp


class GuideText(Static):
    app: "ContralberoApp"

    def __init__(self, session: Session, step: str) -> None:
        super().__init__(classes="guide")
        self.session, self.step = session, step
        self._shown = ""

    def on_mount(self) -> None:
        self.redraw()

    def redraw(self) -> None:
        guide, results = GUIDES[self.step], self.session.results
        fails = results is not None and results.outcomes[self.step].verdict in ("fail", "no_solution")
        word, text = ("Try", guide.trying) if fails else ("Good", guide.good)
        self.display = self.app.guiding
        if word != self._shown:
            self._shown = word
            self.update(Content.assemble(("Decide: ", "bold"), f"{guide.decide}\n", (f"{word}: ", "bold"), text))
