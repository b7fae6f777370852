# SPDX-License-Identifier: Apache-2.0
"""The list of steps, each with its state and the value that decides it; on a narrow screen as one row.

Sign, number and title, the state in words, the value that decides with its bar; at the end, whether all is ready."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from textual.content import Content
from textual.style import Style
from textual.widget import Widget

from calc.design.labels import Place
from calc.design.model import STEPS
from calc.sheet.text import EMPTY, SEMICOLON, Text, plural
from calc.sheet.verdict import TITLES
from calc.studies.ready import SOLVED, Readiness, StepState, readiness, whole

from ..actions import BY_ID
from ..base_app import BaseApp
from ..session.guide import title_of
from ..session.session import Session
from .item_list import Item, ItemList
from .signs import Signs
from .text import bar, fit, wrap

if TYPE_CHECKING:
    from calc.studies.headlines import Headline

READY = "ready"  # the key of the row behind the steps
QUIET = ("pass", "computed")  # states that their sign says
INDENT = "  "


def states_of(session: Session) -> tuple[StepState, ...]:
    """The state of every step of a design under edit; where it could not be solved, results of an earlier design do not
    count."""
    results = None if session.failure else session.verdicts
    return readiness(session.data, results, map(_dotted, session.reasons()))


def whole_of(session: Session) -> Readiness:
    """Whether a design under edit is ready, and what to say of it."""
    return whole(states_of(session), None if session.failure else session.verdicts)


def verdict_of(session: Session) -> tuple[str, str, Text]:
    """The state of a design under edit, the state whose colour it has, and the words for it: none before it is solved.
    Results of an earlier input say nothing of this one."""
    if lacking := session.lacking:
        return "needs", "needs", plural("{n} input to fill in", "{n} inputs to fill in", n=len(lacking))
    if not session.valid:
        return "invalid", "invalid", Text("input is not valid")
    if session.failure:
        return "fail", "fail", Text("not solved")
    if (results := session.verdicts) is None:
        return "waits", "waits", EMPTY
    return results.verdict, results.colour, results.words()


def worst_words(session: Session) -> Text:
    """`FAIL: 2 failed`: the state and the worst that is open; what else is, its steps and Ready say."""
    state, _, words = verdict_of(session)
    results = session.verdicts
    lost = results is None or any(o.state in ("blocked", "no_solution") for o in results.outcomes.values())
    if results is None or lost or state not in TITLES or len(results.counts.words) < 2:
        return words
    return Text("{state}: {open}", state=TITLES[state], open=results.counts.words[0][1])


def ready_words(session: Session) -> Text:
    """`FAIL: 2 failed; 2 steps left`, `PASS; 31 limits hold`."""
    words = verdict_of(session)[-1], whole_of(session).words
    return SEMICOLON.join([part for part in words if part])


def nothing_left(states: Sequence[StepState], key: str) -> bool:
    """Whether nothing is left to do in a step, or what is waits for a later one."""
    n = next(n for n, state in enumerate(states) if state.key == key)
    return states[n].done or (
        states[n].state == "not_verified" and any(later.state == "todo" for later in states[n + 1 :])
    )


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
        items.append(Item(READY, self._ready(width)))
        if sum(len(item.rows) + 1 for item in items) > self.size.height + 1:
            return items
        return [entry for item in items for entry in (item, Item("", [Content("")]))]

    def _step(self, n: int, state: StepState, width: int) -> list[Content]:
        signs: Signs = self.app.signs
        say, here, room = self.app.say, state.key == self.current, width - len(INDENT)
        title = fit(f"{n} {say(title_of(STEPS[n - 1], self.session.data))}", width - 4)
        end = signs.mark("here") if here else ""
        gap = " " * max(1, width - 2 - len(title) - len(end) - 1)
        style = signs.style(state.colour)
        loud = "dim" if state.colour in ("pass", "computed") else style
        words = wrap(say(open_), room) if state.colour not in QUIET and (open_ := self._open(state)) else []
        if state.state not in SOLVED:  # a reason, which is told in full elsewhere
            words = [fit(say(state.words), room)]
        rows = [
            Content.assemble(
                (signs.mark(state.state), style), " ", (title, "bold" if here else ""), gap, (end, "bold")
            ),
            *(Content.assemble(INDENT, (row, loud)) for row in words),
        ]
        if (shown := self._headline(state)) is not None:
            long, brief = (say(text).replace("→", signs.mark("then")) for text in (shown.text, shown.brief))
            rows += [Content(INDENT + row) for row in wrap(long if len(long) <= room else brief, room)]
            if shown.share is not None and shown.check is not None:
                check, verdict = shown.check, signs.style(shown.check.verdict)
                drawn = bar(check.value, *check.bounds, signs, verdict)
                rows.append(Content.assemble(INDENT, drawn, (f" {say(check.margin_text())}", verdict)))
        return rows

    def _open(self, state: StepState) -> Text:
        """The worst that is open in a step, by its number: what else is, its findings say.  Nothing where that is the
        one that its headline names."""
        results = self.session.verdicts
        if results is None or state.state not in SOLVED or not (open_ := results.outcomes[state.key].counts.words):
            return state.words
        shown = self._headline(state)
        named = shown is not None and shown.check is not None and shown.check.verdict == state.state == "not_verified"
        (_, words), count = open_[0], results.outcomes[state.key].counts.not_verified
        return EMPTY if named and count == 1 else words

    def _headline(self, state: StepState) -> "Headline | None":
        results = self.session.verdicts
        if results is None or state.state not in SOLVED:
            return None
        from calc.studies.headlines import headline  # with numpy

        return headline(results, state.key)

    def _ready(self, width: int) -> list[Content]:
        """The last row: whether all is done, or what is left."""
        signs, say, all_of_it = self.app.signs, self.app.say, whole_of(self.session)
        style = signs.style(all_of_it.state)
        return [
            Content.assemble(
                (signs.mark(all_of_it.state), style), " ", (say(Text("Ready")), "bold" if all_of_it.ready else "")
            ),
            Content.assemble(INDENT, (fit(say(all_of_it.words), width - len(INDENT)), style)),
        ]


# --- the steps in one row, for a narrow screen

BRIEF = {"countershaft": Text("Shaft"), "mounting": Text("Mounts")}  # where the row is short of room


class StepBar(Widget):
    app: BaseApp

    def __init__(self, session: Session) -> None:
        super().__init__(id="step-bar")
        self.session = session
        self.current = STEPS[0].key

    def render(self) -> Content:
        signs, states = self.app.signs, states_of(self.session)
        end = self.app.say(Text("Ready"))
        room = self.size.width - 3 * len(STEPS) - 1 - len(end) - 2  # of the titles
        titles = [self.app.say(title_of(step, self.session.data)) for step in STEPS]
        if sum(map(len, titles)) > room:
            several = {"countershaft": Text("Shafts")} if len(self.session.shafts) > 1 else {}
            brief = {**BRIEF, **several}
            titles = [self.app.say(brief.get(step.key, step.title)) for step in STEPS]
        longest = max(map(len, titles))
        while sum(min(len(title), longest) for title in titles) > room and longest > 3:
            longest -= 1
        parts: list[Content | str] = []
        for n, (state, title) in enumerate(zip(states, titles), 1):
            current = state.key == self.current
            text = Content.assemble(
                "[" if current else "" if n > 1 and states[n - 2].key == self.current else " ",
                str(n),
                (signs.mark(state.state), signs.style(state.colour)),
                (fit(title, longest, ""), "bold" if current else ""),
                "]" if current else "",
            )
            parts.append(text.stylize(Style.from_meta({"@click": f"screen.{BY_ID[f'step_{n}'].does}"})))
        all_of_it = whole_of(self.session)
        mark = signs.mark(all_of_it.state), signs.style(all_of_it.state)
        last = Content.assemble(" ", mark, (end, "bold" if all_of_it.ready else "dim"))
        parts.append(last.stylize(Style.from_meta({"@click": f"screen.{BY_ID['ready'].does}"})))
        return Content("").join(parts)
