# SPDX-License-Identifier: Apache-2.0
"""The first row: the file and its state, how many checks pass, warn and fail, and how long it took."""

from collections import Counter

from textual.content import Content
from textual.widget import Widget

from calc.sheet.text import Amount, Text

from ..base_app import BaseApp
from ..session import Session
from .wrap import fit

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
        counts = Counter(check.verdict for check in session.results.checks()) if session.results is not None else Counter()
        dim = "dim " if session.results is not None and not session.current else ""
        right: list[Content | tuple[str, str] | str] = []
        for verdict in ("pass", "warn", "fail"):
            if verdict == "pass" or counts[verdict]:
                word = "" if short else f" {signs.word(verdict)}"
                right += [(f"{counts[verdict]} {signs.mark(verdict)}{word}", dim + signs.style(verdict)), "  "]
        if session.results is None:
            right = []
        if not session.valid:
            time = say(Text("input is not valid"))
        elif session.failure:
            time = say(Text("not solved"))
        elif self.slow or not session.current:
            time = f"{signs.mark('solving')} {say(Text('solving'))}"
        else:
            time = say(Text("solved in {time}", time=Amount(session.seconds * 1000, "ms", form=".0f")))
        if width < FEWEST:
            time, right = say(Text("needs {n} columns", n=FEWEST)), []  # which must be seen
        if self.app.writing:
            right += [(say(self.app.writing), "bold"), "  "]
        right.append((f"{time:>18}" if not short else time, "dim"))
        end = Content.assemble(*right, " ")
        state = self.state(short)
        room = max(8, width - end.cell_length - 2 - (0 if short else 15) - (len(state) + 2 if state else 0))
        start = Content.assemble(
            ("" if short else " Contralbero   "), " " if short else "", (fit(session.name, room), "bold"), f" {state}" if state else "",
        )  # fmt: skip
        return Content.assemble(start, " " * max(1, width - start.cell_length - end.cell_length), end)
