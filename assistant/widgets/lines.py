# SPDX-License-Identifier: Apache-2.0
"""The lines around the form: the message that matters most now, the first row with the file, the last with the keys.

The message is why an input is not accepted, what a step waits for, or a finding, that under the cursor or the worst."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from textual.content import Content
from textual.style import Style
from textual.widget import Widget

from calc.design.key_results import judged
from calc.design.labels import Place, label_of
from calc.design.model import STEPS
from calc.sheet.check import URGENT, Check
from calc.sheet.step import Outcome
from calc.sheet.text import COMMA, EMPTY, Amount, Name, Small, Text
from calc.studies.ready import StepState

from ..actions import ACTIONS, BY_ID, Action
from ..base_app import BaseApp
from ..session.guide import step_of, title_of
from ..session.places import described, named_key
from ..session.session import Session
from ..session.wording import not_repeated, worded
from .rows import RADIUS, TWICE
from .steps import nothing_left, ready_words, states_of, verdict_of, whole_of, worst_words
from .text import fit, wrap

if TYPE_CHECKING:
    from calc.solve import Results
    from calc.studies.repair.nearest import NearestRemedy


ROWS = 2


class MessageLine(Widget):
    app: BaseApp

    def __init__(self, session: Session, enter: Callable[[], str]) -> None:
        """`enter`: the step that Enter leads to now; empty where it does something else."""
        super().__init__(id="message-line")
        self.session, self.enter = session, enter
        self.step = STEPS[0].key
        self.finding = ""  # the check under the cursor, where the findings have the focus
        self.trouble = ""  # the step that fails
        self.remedy: NearestRemedy | None = None  # its remedy, as soon as it is known
        self.beside = False  # the findings of the step stand on the screen: what they say is not said twice
        self._shown: tuple[object, ...] = ()

    def redraw(self) -> None:
        """Draw anew if there is something new to draw."""
        shown = (*self.message(), self.offer(), self.beside)
        if shown != self._shown:
            self._shown = shown
            self.refresh()

    def message(self, *, brief: bool = False) -> tuple[str, str]:
        """The state and the text; `brief`: of a check without what is to be done about it."""
        session, say = self.session, self.app.say
        if lacking := session.lacking:
            labels = COMMA.join(map(self._label, sorted(lacking, key=_order)))
            return "needs", say(Text("To fill in before anything is solved: {fields}.", fields=labels))
        if reasons := session.reasons():
            return "invalid", self._mistake(reasons)
        if session.failure:
            return "fail", say(session.failure)
        if (results := session.verdicts) is None:
            return "solving", say(Text("solving …"))
        outcome = results.outcomes[self.step]
        if outcome.state in ("blocked", "no_solution"):
            return outcome.state, say(outcome.reason)
        chosen = next((check for check in outcome.checks if check.id == self.finding), None)
        if chosen is not None:
            return judged(chosen), self._check(chosen, brief)
        states = states_of(session)
        ahead = self._ahead(states)
        if ahead and outcome.verdict == "not_verified" and nothing_left(states, self.step):
            return "todo", say(ahead)
        if urgent := self._urgent_here(outcome, brief) or self._urgent_anywhere(results, brief):
            return urgent
        if ahead:
            return "todo", say(ahead)
        return whole_of(session).state, say(ready_words(session))

    def _label(self, place: Place) -> Text:
        """Of a field; the stroke stands there in place of the crank radius."""
        data = self.session.data
        return Small(TWICE.label) if place == RADIUS else label_of(data, named_key(data, place))

    def _mistake(self, reasons: Mapping[Place, Text]) -> str:
        """Why an input is not accepted: of this step, else of another one."""
        data = self.session.data
        mine = {place: reason for place, reason in reasons.items() if step_of(place, data) == self.step}
        place, reason = next(iter((mine or reasons).items()))
        step = "" if mine else self._title(step_of(place, data))
        mistake = Text(
            "{key}: {reason}",
            key=self._label(place) if place else Text("the design"),
            reason=reason,
        )
        if len(reasons) > 1:
            mistake = Text("{mistake}  ({n} in all)", mistake=mistake, n=len(reasons))
        if not self.session.blank:
            mistake = Text("{mistake}. The results are those of the last valid input.", mistake=mistake)
        return step + self.app.say(mistake)

    def _urgent_here(self, outcome: Outcome[object], brief: bool) -> tuple[str, str] | None:
        """The worst finding of this step, and how many there are."""
        if not outcome.checks or (worst := outcome.causes[0][0]).verdict not in URGENT:
            return None
        urgent, count = sum(check.verdict in URGENT for check in outcome.checks), len(outcome.checks)
        more = "  " + self.app.say(Text("({n} of {count} checks here)", n=urgent, count=count)) if urgent > 1 else ""
        return worst.verdict, self._check(worst, brief) + ("" if brief else more)

    def _urgent_anywhere(self, results: "Results", brief: bool) -> tuple[str, str] | None:
        """What fails in another step, else what is not solved, else what is open."""
        outcomes = [(step.key, results.outcomes[step.key]) for step in STEPS]
        worst = [(key, outcome.causes[0][0]) for key, outcome in outcomes if outcome.checks]
        for key, check in worst:
            if check.verdict == "fail":
                return "fail", self._title(key) + self._check(check, brief)
        for key, outcome in outcomes:
            if outcome.state in ("blocked", "no_solution"):
                return outcome.state, self._title(key) + self.app.say(outcome.reason)
        for key, check in worst:
            if check.verdict in URGENT:
                return check.verdict, self._title(key) + self._check(check, brief)
        return None

    def _title(self, key: str) -> str:
        data = self.session.data
        return next((f"{n} {self.app.say(title_of(s, data))}: " for n, s in enumerate(STEPS, 1) if s.key == key), "")

    def _ahead(self, states: Sequence[StepState]) -> Text:
        """The next step that is to do, with the key that leads there now, and the one that builds all of them; empty
        where none is."""
        todo = [n for n, state in enumerate(states, 1) if state.state == "todo"]
        if not todo:
            return EMPTY
        step = STEPS[todo[0] - 1]
        parts = {"n": todo[0], "step": title_of(step, self.session.data)}
        by_enter = self.enter() == step.key
        if not by_enter and step.key == self.step:
            ahead = Text("{n} {step} is to do.", **parts)
        else:
            key = self.app.shown_key("go_on" if by_enter else f"step_{todo[0]}")
            ahead = Text("{key} goes on: {n} {step} is to do.", key=key, **parts)
        if len(todo) == 1:
            return ahead
        key = self.app.shown_key("build_all")
        return Text("{ahead} {key} builds all {count} that are left by rules.", ahead=ahead, key=key, count=len(todo))

    def _check(self, check: Check, brief: bool = False) -> str:
        soft = check.kind in ("advice", "method")
        needs = Text("only just") if check.narrow else Text("should be") if soft else Text("needs")
        parts = {
            "check": check.name,
            "value": Amount(check.value, check.unit),
            "needs": needs,
            "limit": check.limit_text(),
        }
        text = Text("{check} {value}, {needs} {limit}", **parts)
        advice = check.advice if check.waits else check.to_do
        text = text if brief or not advice else Text("{check}. {advice}", check=text, advice=advice)
        return worded(self.app.say(text), self.app.say)

    def offer(self, width: int = 1000) -> str:
        """Where to find what would help the step that fails: the changes of the nearest design that passes, or as many
        of them as have room, never half of one."""
        if self.remedy is None or not self.session.valid:
            return ""
        key, say = self.app.shown_key("fix"), self.app.say
        where = "" if self.trouble == self.step else self._title(self.trouble)
        least = where + say(Text("{key} shows what would help", key=key))
        then = self.app.signs.mark("then")
        for words in self._shorter(self.remedy, whole=not where):
            longest = where + say(Text("{key}: {change}", key=key, change=words)).replace("→", then)
            if len(longest) <= width:
                return longest
        return least

    def _shorter(self, remedy: "NearestRemedy", whole: bool) -> Iterator[Text]:
        """What a remedy changes, and, `whole`, what the step then is; shorter and shorter."""
        parts = not_repeated([self.app.say(words) for words in remedy.each])
        for count in range(len(parts), 0, -1):
            words = COMMA.join([Name(part) for part in parts[:count]])
            if more := len(parts) - count:
                words = Text("{changes}, and {n} more for the whole step", changes=words, n=more)
            if whole:
                yield Text("{changes} → step {state}", changes=words, state=remedy.said)
            yield words

    def render(self) -> Content:
        signs, width = self.app.signs, max(10, self.size.width - 4)
        state, text = self.message(brief=self.beside)
        offer = self.offer(width) if state != "invalid" else ""
        if self.beside and offer:
            state, text, offer = "fail", offer, ""
        elif self.beside and self._stands_beside():
            state, text = "todo", self.app.say(self._ahead(states_of(self.session)))
        title = self._title(self.trouble)
        offer = offer.removeprefix(title) if text.startswith(title) else offer
        room = ROWS - bool(offer)
        if len(wrap(text, width)) > room:  # sooner the check alone than half of what is to be done about it
            state, text = self.message(brief=True)
        rows = wrap(text, width)
        if len(rows) > room:
            rows = [*rows[: room - 1], fit(" ".join(rows[room - 1 :]), width)]
        lines = [f" {signs.mark(state)} {rows[0]}" if text else "", *(f"   {row}" for row in rows[1:])]
        told = Content("\n").join(Content.styled(line, signs.style(state)) for line in lines)
        return Content.assemble(told, f"\n   {offer}") if offer else told

    def _stands_beside(self) -> bool:
        """Whether the message is the finding at the head of those of this step, or that under the cursor there."""
        results = self.session.verdicts
        if self.session.lacking or self.session.reasons() or self.session.failure or results is None:
            return False
        checks = results.outcomes[self.step].checks
        return bool(self.finding) or any(check.verdict in URGENT for check in checks)


def _order(place: Place) -> int:
    """Where a field stands in its form."""
    return TWICE.decides if place == RADIUS else described(place).decides


# --- the first row
# The file and its state, the verdict and how many steps are left, and how long it took.

FEWEST = 60  # columns in which everything can be seen
NAME = 12  # columns of the file's name at least, where what stands behind it can be shorter


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

    def _verdict(self, dim: str) -> list[tuple[str, str]]:
        """The words of the state, and whether it is ready or what is left."""
        signs, say, all_of_it = self.app.signs, self.app.say, whole_of(self.session)
        _, colour, words = verdict_of(self.session)
        if not words:
            return []
        if self.screen.has_class("-wide"):  # the list of the steps says the rest
            return [(say(worst_words(self.session)), dim + signs.style(colour))]
        verdict = say(words), dim + signs.style(colour)
        ready = say(Text("ready")), dim + signs.style(all_of_it.state)
        return [verdict, ready if all_of_it.ready else (say(all_of_it.words), "dim")]

    def render(self) -> Content:
        session, signs, say = self.session, self.app.signs, self.app.say
        width = self.size.width
        short = width < 100
        unsolved = not session.valid or bool(session.failure)
        dim = "dim " if session.results is not None and not session.judged and not unsolved else ""
        if unsolved:
            time = ""  # the words of the state say it
        elif session.judged and not session.current:
            time = say(Text("judged in {time}", time=Amount(session.seconds_ahead * 1000, "ms", form=".0f")))
        elif self.slow or not session.current:
            time = f"{signs.mark('solving')} {say(Text('solving'))}"
        else:
            time = say(Text("solved in {time}", time=Amount(session.seconds * 1000, "ms", form=".0f")))
        time = time if short or unsolved else f"{time:>18}"
        if width < FEWEST:  # which must be seen
            wordings = (
                Text("The window is too small: it needs {n} columns.", n=FEWEST),
                Text("needs {n} columns", n=FEWEST),
                Text("too small"),
            )
            fitting = [f" {say(wording)}" for wording in wordings if len(say(wording)) < width]
            return Content(fitting[0] if fitting else fit(say(wordings[-1]), width))
        verdict, state = self._verdict(dim), self.state(short)
        if self.app.writing:
            verdict = [*([] if short else verdict), (say(self.app.writing), "bold")]
        before = len(state) + 2 if state else 0
        when = [(time, "dim")] if time else []
        shorter = verdict if session.current else [*verdict[:1], *when]  # nobody needs to know how long it took
        for parts in ([*verdict, *when], shorter, verdict[:1] or when):
            end = Content.assemble(*(piece for part in parts for piece in (part, "  ")))
            if end.cell_length + before + NAME <= width:
                break
        room = max(8, width - end.cell_length - 1 - before)
        start = Content.assemble(
            " ",
            (fit(session.name, room), "bold"),
            f" {state}" if state else "",
        )
        return Content.assemble(start, " " * max(1, width - start.cell_length - end.cell_length), end)


# --- the last row
# The keys, as the table of actions and the user's key map have them.

# What goes first where there is not room for all, after what does nothing here.  F4 leads to the curve, and narrow to
# every pane.
SPARED = ("pane", "back", "quit", "variant", "curve", "choose", "trouble")
ALWAYS = 3  # of these, on a wide screen, where panes and steps stand in sight
SPARED_NARROW = (
    "variant",
    "redo",
    "choose",
    "pane",
    "quit",
    "back",
    "undo",
    "curve",
    "save",
    "report",
    "palette",
    "trouble",
    "fix",
)


class FooterLine(Widget):
    """Textual's own footer is made anew at every change of the focus; this one stands still."""

    app: BaseApp

    def __init__(self) -> None:
        super().__init__(id="footer-line")
        self.idle: tuple[str, ...] = ()  # actions that do nothing here
        self.leafs = False  # there are several shafts to leaf through

    def show(self, idle: tuple[str, ...], *, leafs: bool = False) -> None:
        if (idle, leafs) != (self.idle, self.leafs):
            self.idle, self.leafs = idle, leafs
            self.refresh()

    def render(self) -> Content:
        width = self.size.width
        wide = width >= 100
        spared = [*self.idle, *(SPARED if wide else SPARED_NARROW)]
        least = len(self.idle) + (ALWAYS if wide else 1)
        for gap, count in ((2, least), *((1, n) for n in range(least, len(spared) + 1))):
            shown = [a for a in ACTIONS if a.footer and a.id not in spared[:count] and (self.leafs or not a.first)]
            end = self._part(BY_ID["palette"]) if BY_ID["palette"] in shown else Content("")
            left = Content(" " * gap).join(self._part(a) for a in shown if a.id != "palette")
            if left.cell_length + (end.cell_length + 3 if end else 0) <= width:
                break
        start = " " if left.cell_length < width else ""
        gap = width - len(start) - left.cell_length - end.cell_length - 1
        return Content.assemble(start, left, " " * gap, end) if end else Content.assemble(start, left)

    def _part(self, action: Action) -> Content:
        say, key = self.app.say, self.app.shown_key(action.id)
        part = Content.assemble((say(key), "bold $footer-key-foreground"), " ", say(action.footer))
        return part.stylize(Style.from_meta({"@click": f"screen.{action.does}"}))
