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
        shown = [
            (n, step, self.app.say(step.title), state)
            for n, (step, state) in enumerate(zip(STEPS, states), 1)
            if not step.optional or state.state != "not_asked" or step.key == self.current
        ]
        titles = [title for _, _, title, _ in shown]
        end = self.app.say(Text("Ready"))
        width = self.size.width - len(end) - 2
        room = max(map(len, titles))

        def cells(room: int) -> int:
            return sum(4 + (len(title) if step.key == self.current else min(len(title), room)) for _, step, title, _ in shown)

        while cells(room) > width and room > 3:  # shorten the longest titles first, never that of this step
            room -= 1
        parts: list[Content | str] = []
        for n, step, title, state in shown:
            current = step.key == self.current
            text = Content.assemble(
                "[" if current else " ",
                str(n),
                (signs.mark(state.state), signs.style(state.state)),
                (title if current else fit(title, room, ""), "bold" if current else ""),
                "]" if current else " ",
            )
            parts.append(text.stylize(Style.from_meta({"@click": f"screen.{BY_ID[f'step_{n}'].does}"})))
        mark = "ready" if ready(states) else "todo"
        last = Content.assemble(" ", (signs.mark(mark), signs.style(mark)), (end, "bold" if mark == "ready" else "dim"))
        parts.append(last.stylize(Style.from_meta({"@click": f"screen.{BY_ID['ready'].does}"})))
        return Content("").join(parts)
