# SPDX-License-Identifier: Apache-2.0
"""The findings of a step: those of one cause in a row, the worst first; what is under the cursor is told in full; what
holds is folded."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import ClassVar

from rich.cells import cell_len
from textual import events
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.message import Message

from calc.design.key_results import judged, outside
from calc.design.labels import label_of
from calc.sheet.check import Check
from calc.sheet.deferred import Later
from calc.sheet.number import short
from calc.sheet.step import Outcome
from calc.sheet.text import COMMA, EMPTY, Amount, Name, Text, plural
from calc.sheet.verdict import TITLES, named, open_findings, severity

from ..session.wording import worded, words_shared
from .item_list import Item, ItemList
from .pane import short_of_room
from .text import bar, pad, wrap

VALUE, LIMIT, MARGIN = Text("Value"), Text("Limit"), Text("Margin")
GAP = 2  # cells between columns
SHARED = 2  # words that are worth leaving out where they were just said
SIGN = 2  # cells of the sign before a name
NAMES = 26  # cells of a name at least, beside columns of numbers
SOUGHT = "+"  # before the cause of a finding that somebody went to: it is named where others are counted
ADVICE, METHOD, HOLD = "advice", "method", "hold"  # the keys of the rows that fold
ADVISED = plural("{n} piece of advice", "{n} pieces of advice", n=0)
OF_METHOD = plural("{n} on the method", "{n} on the method", n=0)
NOTES = plural("{n} note", "{n} notes", n=0)
CAUTIONS = plural("{n} caution", "{n} cautions", n=0)
NOT_VERIFIED = plural("{n} not verified", "{n} not verified", n=0)
HOLDING = plural("{n} holds", "{n} hold", n=0)


def sorted_checks(checks: tuple[Check, ...]) -> list[Check]:
    """The worst first; equal ones as the step has them."""
    return sorted(checks, key=lambda c: severity(c)[:4])


@dataclass(frozen=True)
class CheckRow:
    """One finding, or the head of what is folded.  `others`: findings of the same cause that are folded behind it."""

    key: str
    check: Check | None = None
    others: int = 0
    inside: bool = False  # of a group, below its worst
    counted: bool = False  # with all of its verdict, by their number
    shared: int = 0  # words with which its name begins as the one above it
    head: Content | None = None
    worst: Check | None = None  # of those that its head stands for
    fold: str = ""  # the sign behind it


@dataclass(frozen=True)
class CheckColumns:
    """The cells of each column; without numbers only the margin stands behind the name."""

    name: int
    value: int
    limit: int
    margin: int

    @property
    def numbers(self) -> bool:
        return self.value > 0

    @property
    def wide(self) -> int:
        """All of them, with the sign before the name."""
        return SIGN + self.name + (self.value + self.limit + 2 * GAP if self.numbers else 0) + GAP + self.margin


class Checks(ItemList):
    """The key of an item is the id of its check, or the name of what is folded there."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("right", "unfold(True)", "Unfold", show=False),
        Binding("left", "unfold(False)", "Fold", show=False),
    ]

    @dataclass
    class Wants(Message):
        source: "Checks"
        check: Check

        @property
        def control(self) -> "Checks":
            return self.source

    class WantSlopes(Wants):
        """It should be said how far the inputs move this check."""

    class WantWays(Wants):
        """It should be looked for what would help it."""

    def __init__(self) -> None:
        super().__init__(id="checks-list")
        self.outcome: Outcome[object] | None = None
        self.unfolded: set[str] = set()  # causes, and ADVICE, METHOD, HOLD
        self.lead = EMPTY  # the sentence with which the step begins
        self.slopes: dict[str, Text] = {}  # id of a check → what moves it most
        self._clicked_at = ""
        self.offered = False  # what mends the step is said elsewhere on the screen, with its numbers

    def offer(self, offered: bool) -> None:
        if offered != self.offered:
            self.offered = offered
            self.rebuild()

    @property
    def brief(self) -> bool:
        """Whether of the finding under the cursor only its distance and what mends it is told, and of what is less bad
        only how many there are: beside other panes, until the findings have the focus."""
        return short_of_room(self) and self.screen.focused is not self

    def on_focus(self) -> None:
        self.rebuild()

    def on_blur(self) -> None:
        if self.is_attached:
            self.rebuild()

    def show(self, outcome: Outcome[object] | None, lead: Text = EMPTY) -> None:
        if outcome is not self.outcome:
            self.lead = lead
            if outcome is None or self.outcome is None or outcome.key != self.outcome.key:
                self.unfolded, self.cursor = set(), -1  # of another step the worst is looked at
            self.outcome, self.slopes = outcome, {}
            self.rebuild()

    def show_slopes(self, id: str, words: Text) -> None:
        """What moves a check most, as soon as it is known."""
        self.slopes[id] = words
        if id == self.key:
            self.rebuild()

    @property
    def check(self) -> Check | None:
        """The check under the cursor."""
        return self._by_id(self.key)

    @property
    def group(self) -> list[Check]:
        """What is open under the cursor: all findings of the cause where they are folded behind the worst, else the
        one."""
        check = self.check
        if check is None or self.outcome is None or (check.cause or check.id) in self.unfolded:
            return [check] if check is not None else []
        return [
            check,
            *(
                c
                for c in self.outcome.checks
                if c is not check and c.open and c.kind in KINDS_SHOWN and cause(c) == cause(check)
            ),
        ]

    def _by_id(self, id: str) -> Check | None:
        return next((c for c in self.outcome.checks if c.id == id), None) if self.outcome is not None else None

    # --- folding
    def go_to(self, key: str, *, top: bool = False) -> bool:
        if (check := self._by_id(key)) is not None and self.items:
            for fold in (f"{SOUGHT}{cause(check)}", fold_of(check)):
                if all(item.key != key for item in self.items):
                    self.unfolded |= {fold}
                    self.rebuild()
        return super().go_to(key, top=top)

    def action_unfold(self, unfold: bool) -> None:
        """Of what is under the cursor; folded, the cursor stays on what stands for it."""
        here, check = self.key, self.check
        fold = fold_of(check) if check is not None else here
        if fold and (fold in self.unfolded) is not unfold:
            self.unfolded ^= {fold}
            self.rebuild()
            if self.key != here:
                self.go_to(next(item.key for item in self.items if item.key == fold or self._inside(item.key, fold)))

    def _inside(self, id: str, fold: str) -> bool:
        check = self._by_id(id)
        return check is not None and fold_of(check) == fold

    def choose(self, clicked: bool = False) -> None:
        """Enter folds and unfolds, or explains a check; a click chooses it, and one more does so too."""
        if self.key in (ADVICE, METHOD, HOLD):
            self.action_unfold(self.key not in self.unfolded)
        elif not clicked or self.key == self._clicked_at:
            super().choose(clicked)

    def on_click(self, event: events.Click) -> None:
        self._clicked_at = self.key  # before this click, which the list deals with next

    def _move(self, index: int, *, top: bool = False) -> None:
        self.cursor = index
        self.rebuild()  # what is under the cursor is told in full
        super()._move(self.cursor, top=top)

    def rebuild(self) -> None:
        super().rebuild()
        if (check := self.check) is None:
            return
        if check.moved_by and check.id not in self.slopes:
            self.post_message(self.WantSlopes(self, check))
        if check.open and check.waits and not self.brief:
            self.post_message(self.WantWays(self, check))

    # --- content
    def _rows_of(self) -> list[CheckRow]:
        """What is listed, in its order."""
        assert self.outcome is not None
        checks = self.outcome.checks
        accepted = [CheckRow(check.id, check) for check in checks if check.verdict == "accepted"]
        rows = [*self._finding_rows(self.outcome), *accepted, CheckRow("", head=Content(""))]
        open_ones = [check for check in sorted_checks(checks) if check.open]
        notes = [check for check in open_ones if check.kind in (ADVICE, METHOD)]
        if self.brief and self.unfolded.isdisjoint((ADVICE, METHOD)):
            rows += self._folding_rows(ADVICE, notes, NOTES)
            return rows + self._folding_rows(HOLD, [check for check in checks if check.verdict == "pass"], HOLDING)
        rows += self._folding_rows(ADVICE, [check for check in open_ones if check.kind == "advice"], ADVISED)
        rows += self._folding_rows(METHOD, [check for check in open_ones if check.kind == "method"], OF_METHOD)
        rows += self._folding_rows(HOLD, [check for check in checks if check.verdict == "pass"], HOLDING)
        return rows

    def _finding_rows(self, outcome: Outcome[object]) -> list[CheckRow]:
        """The worst of each cause, before the others where they are unfolded; or that there is none."""
        groups = open_findings(outcome.checks)
        if not groups:
            return []
        if self.brief:
            named = [group for group in groups if group[0].verdict == groups[0][0].verdict or self._seen(group)]
            further = [check for group in groups if group not in named for check in group]
            return [*self._not_repeated(self._named_rows(named)), *self._counted_rows(further)]
        return self._named_rows(groups)

    def _seen(self, group: Sequence[Check]) -> bool:
        """Whether somebody has gone to a finding, or unfolded its group."""
        return not self.unfolded.isdisjoint((cause(group[0]), f"{SOUGHT}{cause(group[0])}"))

    def _not_repeated(self, rows: list[CheckRow]) -> list[CheckRow]:
        """`Smallest backlash central–idler`, `… idler–shaft`."""
        names = [self.app.say(row.check.name) if row.check is not None else "" for row in rows]
        return [replace(row, shared=words_shared(name, before)) for row, name, before in zip(rows, names, ["", *names])]

    def _counted_rows(self, checks: Sequence[Check]) -> list[CheckRow]:
        """How many there are of each verdict, with the worst margin, before anybody looks at them."""
        rows = []
        for verdict in dict.fromkeys(check.verdict for check in checks):
            alike = [check for check in checks if check.verdict == verdict]
            worst = min(alike, key=severity)
            rows.append(CheckRow(worst.id, worst, len(alike) - 1, counted=True))
        return rows

    def _named_rows(self, groups: Sequence[Sequence[Check]]) -> list[CheckRow]:
        rows: list[CheckRow] = []
        for worst, *others in groups:
            unfolded = cause(worst) in self.unfolded
            rows.append(CheckRow(worst.id, worst, 0 if unfolded else len(others)))
            rows += [CheckRow(check.id, check, inside=True) for check in others] if unfolded else []
        return rows

    def _folding_rows(self, key: str, checks: Sequence[Check], count: Text) -> list[CheckRow]:
        """How many there are, before them where they are unfolded."""
        if not checks:
            return []
        signs, unfolded = self.app.signs, key in self.unfolded
        words = self.app.say(plural(count.one, count.template, n=len(checks)))
        state = "pass" if key == HOLD else "note"
        fold = signs.mark("unfolded" if unfolded else "folded")
        worst = checks[0] if key != HOLD and not unfolded else None
        head = Content.assemble((f"{signs.mark(state)} ", signs.style(state)), (words, "dim"))
        inside = [CheckRow(check.id, check, inside=True) for check in checks] if unfolded else []
        return [CheckRow(key, head=head, worst=worst, fold=fold), *inside]

    def build(self, width: int) -> list[Item]:
        outcome, say = self.outcome, self.app.say
        if outcome is None:
            return []
        if not outcome.checks:
            texts = {
                "not_asked": Text("not built yet"),
                "solved": Text("This step has no limits of its own."),
            }
            text = say(texts[outcome.state]) if outcome.state in texts else outcome.reason
            return [Item("", [Content.styled(row, "dim") for row in wrap(text, max(1, width))])]
        rows = self._rows_of()
        columns = self._columns(rows, width)
        keys = [row.key for row in rows if row.key]
        chosen = self.key if self.key in keys else keys[0] if keys else ""
        reasons = [
            Item("", [Content(row) for row in wrap(say(text), max(1, width))])
            for text in (outcome.reason, self.lead)
            if text
        ]
        signs = self.app.signs
        words = TITLES[outcome.verdict] if self.brief and outcome.verdict in TITLES else outcome.words()
        verdict = wrap(f"{signs.mark(outcome.verdict)} {say(words)}", max(1, width), SIGN)
        items = [*reasons, Item("", [Content.styled(row, signs.style(outcome.colour)) for row in verdict])]
        items += [Item("", [self._head(columns)])] if columns.numbers else []
        for row in rows:
            if row.check is None:
                items.append(Item(row.key, [self._fold_row(row, columns, width)]))
                continue
            content = self._title_rows(row, columns)
            if row.key == chosen:
                content = [*content, *self._detail(row.check, width)]
            items.append(
                Item(row.key, content, say.part(Amount(row.check.value, row.check.unit)), self._line(row.check))
            )
        return items

    def _columns(self, rows: Sequence[CheckRow], width: int) -> CheckColumns:
        say = self.app.say
        checks = [row.check for row in rows if row.check is not None]

        def widest(head: Text, cell: Callable[[Check], str]) -> int:
            return max([len(say(head)), *(len(cell(check)) for check in checks)])

        margins = [say(check.margin_text()) for row in rows if (check := row.check or row.worst) is not None]
        margin = max(map(len, [say(MARGIN), *margins]))
        value, limit = widest(VALUE, lambda c: say.number(short(c.value))), widest(LIMIT, lambda c: say(c.limit_text()))
        room = width - SIGN - value - limit - margin - 3 * GAP
        if checks and room >= NAMES:
            longest = max(len(self._title(row)) for row in rows if row.check is not None)
            return CheckColumns(min(room, max(NAMES, longest + 2)), value, limit, margin)
        return CheckColumns(max(8, width - SIGN - GAP - margin), 0, 0, margin)

    def _fold_row(self, row: CheckRow, columns: CheckColumns, width: int) -> Content:
        """What stands for several checks, with the worst of them: its margin, and its name where that has room."""
        head = Content.assemble(row.head or "", (f" {row.fold}" if row.fold else "", "dim"))
        if row.worst is None:
            return head.truncate(width, ellipsis=True)
        name, margin = (self.app.say(text) for text in (row.worst.name, row.worst.margin_text()))
        room = columns.wide - head.cell_length - columns.margin - GAP
        named = f" {name}" if not self.brief and cell_len(name) < room else ""
        gap = " " * max(1, columns.wide - head.cell_length - cell_len(named) - cell_len(margin))
        return Content.assemble(head, (f"{named}{gap}{margin}", "dim")).truncate(width, ellipsis=True)

    def _head(self, columns: CheckColumns) -> Content:
        say = self.app.say
        name, value = f"{say(Text('Finding')):<{columns.name}}", f"{say(VALUE):>{columns.value}}"
        limit, margin = f"{say(LIMIT):<{columns.limit}}", f"{say(MARGIN):>{columns.margin}}"
        return Content.styled(" " * SIGN + (" " * GAP).join([name, value, limit, margin]), "dim")

    def _title(self, row: CheckRow) -> str:
        assert row.check is not None
        say = self.app.say
        title = say(row.check.name)
        if row.shared >= SHARED and row.key != self.key:  # that under the cursor is named in full
            title = " ".join([self.app.signs.mark("more"), *title.split(" ")[row.shared :]])
        if row.check.verdict == "accepted":
            return say(Text("{check}: accepted, {reason}", check=Name(title), reason=row.check.accepted))
        if row.counted and row.others:
            words = NOT_VERIFIED if row.check.verdict == "not_verified" else CAUTIONS
            return f"{say(plural(words.one, words.template, n=row.others + 1))} {self.app.signs.mark('folded')}"
        if row.others and self.brief:
            return f"{title} (×{row.others + 1})"
        if row.others:
            return say(Text("{name} ({n} checks)", name=Name(title), n=row.others + 1))
        return f"  {title}" if row.inside else title

    def _title_rows(self, row: CheckRow, columns: CheckColumns) -> list[Content]:
        """Sign and name, and its numbers where they have columns."""
        assert row.check is not None
        check, say, signs = row.check, self.app.say, self.app.signs
        verdict = judged(check)
        style = signs.style(verdict)
        names = wrap(self._title(row), columns.name, 2 if row.inside else 0)
        loud = "bold" if check.verdict in ("fail", "not_verified") else "" if check.open else "dim"
        parts: list[Content | tuple[str, str] | str] = [
            (pad(signs.mark(verdict), SIGN), style),
            (pad(names[0], columns.name), loud),
        ]
        if columns.numbers:
            parts += [" " * GAP, (f"{say.number(short(check.value)):>{columns.value}}", loud)]
            parts += [" " * GAP, (f"{say(check.limit_text()):<{columns.limit}}", "dim")]
        parts += [" " * GAP, (f"{say(check.margin_text()):>{columns.margin}}", style if check.open else "dim")]
        return [Content.assemble(*parts), *(Content.styled(" " * SIGN + name, loud) for name in names[1:])]

    def _detail(self, check: Check, width: int) -> list[Content]:
        """What there is to know of a check: how far it is from its limit, why, what moves it, what would help, and
        where it comes from."""
        say, signs = self.app.say, self.app.signs
        room, indent = max(12, width - SIGN - 2), " " * (SIGN + 1)
        held = Text(
            "{value} of {limit}",
            value=Amount(check.value, digits=3),
            limit=Amount(check.nearest[1], check.unit, digits=3),
        )
        against = Text(
            "{value}, needs {limit}", value=Amount(check.value, check.unit, digits=3), limit=check.limit_text()
        )
        style, ratio = signs.style(check.verdict), check.share
        first: list[Content | tuple[str, str] | str] = [indent, say(held if ratio is not None else against)]
        if ratio is not None:
            first += ["  ", bar(check.value, *check.bounds, signs, style), "  ", (say(check.margin_text()), style)]
        rows = [] if math.isnan(check.value) else [Content.assemble(*first)]

        def tell(words: str, style: str = "") -> None:
            rows.extend(Content.styled(indent + row, style) for row in wrap(worded(words, say), room) if row)

        advice = say(check.advice)
        if not isinstance(check.remedies, Later):
            advice = advice.removeprefix(say(check.ways_text())).strip()
        if self.brief:  # what comes next is no more than a key away
            if not (self.offered and check.verdict == "fail"):
                tell(advice or say(check.lack_text(self._label)))
            return rows
        if beyond := self._beyond(check):
            tell(say(Text("outside the validity of its formula: {methods}", methods=named(beyond))))
        if lack := check.lack_text(self._label):
            tell(say(lack))
        if advice:
            tell(advice)
        if check.open and check.waits:
            tell(say(Text("Looking for what would help …")), "dim")
        elif check.open and check.remedies:
            ways = Name("; ").join(remedy.words for remedy in check.remedies)
            tell(say(Text("for this check alone: {ways}", ways=ways)))
        if check.open and check.kind == "caution":
            tell(say(Text("{key} accepts it, with a reason.", key=self.app.shown_key("accept"))))
        if check.moved_by:
            inputs = COMMA.join(dict.fromkeys(self._label(key) for key in check.moved_by[:3]))
            tell(say(Text("most: {inputs}", inputs=self.slopes.get(check.id, inputs))))
        if check.source:
            tell(say(check.source), "dim")
        return rows

    def _beyond(self, check: Check) -> list[Check]:
        """What puts a check outside the validity of its formula."""
        return outside(check, self.outcome.checks) if self.outcome is not None else []

    def _label(self, key: str) -> Text:
        return label_of(self.app.session.data, key)

    def _line(self, check: Check) -> str:
        """The whole of it, to be copied."""
        line = Text(
            "{verdict}: {check} {value}, limit {limit}, margin {margin} [{source}]",
            verdict=self.app.signs.word(judged(check)),
            check=check.name,
            value=Amount(check.value, check.unit),
            limit=check.limit_text(),
            margin=check.margin_text(),
            source=check.source,
        )
        return self.app.say(line)


KINDS_SHOWN = ("limit", "caution")  # the kinds whose findings are not folded


def cause(check: Check) -> str:
    return check.cause or check.id


def fold_of(check: Check) -> str:
    """What unfolds a check: advice, the method or what holds; of a finding its cause."""
    if check.verdict == "pass":
        return HOLD
    return check.kind if check.open and check.kind in (ADVICE, METHOD) else cause(check)
