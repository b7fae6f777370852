# SPDX-License-Identifier: Apache-2.0
"""The steps in one row, for a narrow screen; at its end, whether the design is ready."""

from textual.content import Content
from textual.style import Style
from textual.widget import Widget

from calc.design import STEPS
from calc.ready import ready
from calc.sheet.text import Text

from ..actions import BY_ID
from ..base_app import BaseApp
from ..session import Session
from .steps import states_of
from .wrap import fit


class StepBar(Widget):
    app: BaseApp

    def __init__(self, session: Session) -> None:
        super().__init__(id="step-bar")
        self.session = session
        self.current = STEPS[0].key

    def render(self) -> Content:
        signs, states = self.app.signs, states_of(self.session)
        titles = [self.app.say(step.title) for step in STEPS]
        end = self.app.say(Text("Ready"))
        width = self.size.width - len(end) - 2
        spare = width - sum(len(title) + 4 for title in titles)
        longest = max(map(len, titles))
        room = longest
        while spare < 0 and room > 3:  # shorten the longest titles first
            room -= 1
            spare = width - sum(min(len(title), room) + 4 for title in titles)
        parts: list[Content | str] = []
        for n, (step, title, state) in enumerate(zip(STEPS, titles, states), 1):
            here = step.key == self.current
            text = Content.assemble(
                "[" if here else " ",
                str(n),
                (signs.mark(state.state), signs.style(state.state)),
                (fit(title, room, ""), "bold" if here else ""),
                "]" if here else " ",
            )
            parts.append(text.stylize(Style.from_meta({"@click": f"screen.{BY_ID[f'step_{n}'].does}"})))
        mark = "ready" if ready(states) else "todo"
        last = Content.assemble(" ", (signs.mark(mark), signs.style(mark)), (end, "bold" if mark == "ready" else "dim"))
        parts.append(last.stylize(Style.from_meta({"@click": f"screen.{BY_ID['ready'].does}"})))
        return Content("").join(parts)
