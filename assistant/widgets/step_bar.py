# SPDX-License-Identifier: Apache-2.0
"""The steps in one row, for a narrow screen."""

from textual.content import Content
from textual.style import Style
from textual.widget import Widget

from calc.design import STEPS

from ..actions import BY_ID
from ..base_app import BaseApp
from ..session import Session
from .steps import state_of
from .wrap import fit


class StepBar(Widget):
    app: BaseApp

    def __init__(self, session: Session) -> None:
        super().__init__(id="step-bar")
        self.session = session
        self.current = STEPS[0].key

    def render(self) -> Content:
        signs = self.app.signs
        wrong = {str(place[0]) for place in self.session.reasons() if place}
        outcomes = self.session.results.outcomes if self.session.results is not None else {}
        titles = [self.app.say(step.title) for step in STEPS]
        spare = self.size.width - 1 - sum(len(title) + 4 for title in titles)
        longest = max(map(len, titles))
        room = longest
        while spare < 0 and room > 3:  # shorten the longest titles first
            room -= 1
            spare = self.size.width - 1 - sum(min(len(title), room) + 4 for title in titles)
        parts: list[Content | str] = []
        for n, (step, title) in enumerate(zip(STEPS, titles), 1):
            state = state_of(self.session, outcomes.get(step.key), step.key, wrong)
            here = step.key == self.current
            mark = signs.mark(state) if outcomes or state == "invalid" else signs.mark("solving")
            text = Content.assemble(
                "[" if here else " ",
                str(n),
                (mark, signs.style(state)),
                (fit(title, room, ""), "bold" if here else ""),
                "]" if here else " ",
            )
            parts.append(text.stylize(Style.from_meta({"@click": f"screen.{BY_ID[f'step_{n}'].does}"})))
        return Content("").join(parts)
