# SPDX-License-Identifier: Apache-2.0
"""The steps in one row, for a narrow screen; at its end, whether the design is ready."""

from textual.content import Content
from textual.style import Style
from textual.widget import Widget

from calc.design.model import STEPS
from calc.ready import ready
from calc.sheet.text import Text

from ..actions import BY_ID
from ..base_app import BaseApp
from ..session.session import Session
from .steps import states_of
from .text import fit

BRIEF = {"countershaft": Text("Shaft"), "mounting": Text("Mounts")}  # where the row is short of room


class StepBar(Widget):
    app: BaseApp

    def __init__(self, session: Session) -> None:
        super().__init__(id="step-bar")
        self.session = session
        self.current = STEPS[0].key

    def render(self) -> Content:
        signs, states = self.app.signs, states_of(self.session)
        shown = [
            (n, step, state)
            for n, (step, state) in enumerate(zip(STEPS, states), 1)
            if not step.optional or state.state != "not_asked" or step.key == self.current
        ]
        end = self.app.say(Text("Ready"))
        room = self.size.width - 3 * len(shown) - 1 - len(end) - 2  # of the titles
        titles = [self.app.say(step.title) for _, step, _ in shown]
        if sum(map(len, titles)) > room:
            titles = [self.app.say(BRIEF.get(step.key, step.title)) for _, step, _ in shown]
        longest = max(map(len, titles))
        while sum(min(len(title), longest) for title in titles) > room and longest > 3:
            longest -= 1
        parts: list[Content | str] = []
        for (n, step, state), title in zip(shown, titles):
            current = step.key == self.current
            text = Content.assemble(
                "[" if current else "" if parts and shown[n - 2][1].key == self.current else " ",
                str(n),
                (signs.mark(state.state), signs.style(state.state)),
                (fit(title, longest, ""), "bold" if current else ""),
                "]" if current else "",
            )
            parts.append(text.stylize(Style.from_meta({"@click": f"screen.{BY_ID[f'step_{n}'].does}"})))
        mark = "ready" if ready(states) else "todo"
        last = Content.assemble(" ", (signs.mark(mark), signs.style(mark)), (end, "bold" if mark == "ready" else "dim"))
        parts.append(last.stylize(Style.from_meta({"@click": f"screen.{BY_ID['ready'].does}"})))
        return Content("").join(parts)
