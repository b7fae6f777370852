# SPDX-License-Identifier: Apache-2.0
"""The first row: the file and its state, what is open and how many steps are ready, and how long it took."""

from textual.content import Content
from textual.widget import Widget

from calc.ready import OPEN, tally
from calc.sheet.text import Amount, Text

from ..base_app import BaseApp
from ..session.session import Session
from .steps import states_of
from .text import fit

FEWEST = 60  # columns in which everything can be seen


class TopLine(Widget):
    app: BaseApp

    def __init__(self, session: Session) -> None:
        super().__init__(id="top-line")
        self.session = session
        self.slow = False  # a solve has taken long enough to say so

    def state(self, short: bool) -> str:
        """The state of the file."""
        session, signs, say = self.session, self.app.signs, self.app.say
        parts: list[str] = []
        if session.recording is not None:
            parts.append(f"{signs.mark('recording')} {say(Text('rec'))}")
        if session.dirty:
            parts.append(f"{signs.mark('edited')} {say(Text('edited'))}")
            if session.autosave_failure:
                parts.append(say(Text("not kept!")) if short else say(Text("can not be kept aside, save it")))
            elif session.autosaved is not None and not short:
                parts.append(say(Text("autosaved {time}", time=f"{session.autosaved:%H:%M}")))
        if session.read_only:
            parts.append(f"{signs.mark('read_only')} {say(Text('read-only'))}")
        if session.example and not session.dirty:
            parts.append(f"({say(Text('example'))})")
        return ", ".join(parts)

    def render(self) -> Content:
        session, signs, say = self.session, self.app.signs, self.app.say
        width = self.size.width
        short = width < 100
        dim = "dim " if session.results is not None and not session.current else ""
        right: list[Content | tuple[str, str] | str] = []
        if session.results is not None:
            found = tally(states_of(session), session.results)
            for state, words in found.words:
                text = f"{getattr(found, state)} {signs.mark(state)}" if short and state in OPEN else say(words)
                right += [(" " if short else " · ") if right else "", (text, dim + signs.style(state))]
            right.append("  ")
        if not session.valid:
            time = say(Text("input is not valid"))
        elif session.failure:
            time = say(Text("not solved"))
        elif self.slow or not session.current:
            time = f"{signs.mark('solving')} {say(Text('solving'))}"
        else:
            time = say(Text("solved in {time}", time=Amount(session.seconds * 1000, "ms", form=".0f")))
        if width < FEWEST:  # which must be seen
            told = (
                Text("The window is too small: it needs {n} columns.", n=FEWEST),
                Text("needs {n} columns", n=FEWEST),
                Text("too small"),
            )
            fitting = [f" {say(one)}" for one in told if len(say(one)) < width]
            return Content(fitting[0] if fitting else fit(say(told[-1]), width))
        if self.app.writing:
            right = [*([] if short else right), (say(self.app.writing), "bold"), "  "]
        right.append((f"{time:>18}" if not short else time, "dim"))
        end = Content.assemble(*right, " ")
        state = self.state(short)
        room = max(8, width - end.cell_length - 2 - (0 if short else 15) - (len(state) + 2 if state else 0))
        start = Content.assemble(
            ("" if short else " Contralbero   "), " " if short else "", (fit(session.name, room), "bold"), f" {state}" if state else "",
        )  # fmt: skip
        return Content.assemble(start, " " * max(1, width - start.cell_length - end.cell_length), end)
