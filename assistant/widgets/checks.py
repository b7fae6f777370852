# SPDX-License-Identifier: Apache-2.0
"""The checks of a step: verdict, name, value, limit, margin.  What fails stands first."""

from textual.content import Content

from calc.sheet.check import Check, severity
from calc.sheet.number import short
from calc.sheet.step import Outcome
from calc.sheet.text import Amount, Text

from .item_list import Item, ItemList
from .wrap import pad, wrap

MARGIN_WIDTH = 8  # cells at least
VALUE, LIMIT, MARGIN = Text("Value"), Text("Limit"), Text("Margin")
GAP = 2


def sorted_checks(checks: tuple[Check, ...]) -> list[Check]:
    """The worst first; equal ones as the step has them."""
    return sorted(checks, key=lambda c: severity(c)[:3])


class Checks(ItemList):
    """The key of an item is the id of its check."""

    def __init__(self) -> None:
        super().__init__(id="checks-list")
        self.outcome: Outcome[object] | None = None

    def show(self, outcome: Outcome[object] | None) -> None:
        if outcome is not self.outcome:
            self.outcome = outcome
            self.rebuild()

    def build(self, width: int) -> list[Item]:
        outcome, say = self.outcome, self.app.say
        width = max(width, 30)  # what is too narrow is cut off
        if outcome is None:
            return []
        if not outcome.checks:
            texts = {"not_asked": Text("This design does not use this step."), "solved": Text("This step has no limits of its own.")}
            text = say(texts[outcome.state]) if outcome.state in texts else outcome.reason
            return [Item("", [Content.styled(row, "dim") for row in wrap(text, width)])]
        checks, indent = sorted_checks(outcome.checks), self._indent
        value_width = max(len(say(VALUE)), *(len(say.number(short(c.value))) for c in checks))
        limit_width = max(len(say(LIMIT)), *(len(say(c.limit_text())) for c in checks))
        margin_width = max(MARGIN_WIDTH, *(len(say(c.margin_text())) for c in checks))
        name_width = width - indent - value_width - limit_width - margin_width - 2 * GAP
        roomy = name_width >= 12 and all(len(wrap(c.name, name_width)) <= 2 for c in checks)
        if roomy:
            start = " " * indent + say(Text("Check")).ljust(name_width)
            head = f"{start}{'':{GAP}}{say(VALUE):>{value_width}}{'':{GAP}}{say(LIMIT):<{limit_width}}{say(MARGIN):>{margin_width}}"
        else:
            head = f"{'':<{indent}}{say(Text('Check, value and limit')):<{width - indent - margin_width}}{say(MARGIN):>{margin_width}}"
        items = [Item("", [Content.styled(head, "dim")])]
        for check in checks:
            rows = self._wide(check, name_width, value_width, limit_width, margin_width) if roomy else self._two(check, width, margin_width)
            value = Amount(check.value, check.unit)
            judged = Text(
                "{verdict}: {check} {value}, limit {limit}, margin {margin} [{source}]",
                verdict=self.app.signs.word(check.verdict),
                check=check.name,
                value=value,
                limit=check.limit_text(),
                margin=check.margin_text(),
                source=check.source,
            )
            items.append(Item(check.id, rows, say.part(value), say(judged)))
        return items

    @property
    def _verdicts(self) -> set[str]:
        return {check.verdict for check in self.outcome.checks} if self.outcome is not None else set()

    @property
    def _indent(self) -> int:
        """The cells of the verdict: a sign and the longest word."""
        return 3 + max(len(self.app.signs.word(verdict)) for verdict in {"pass", "warn", "fail", *self._verdicts})

    def _start(self, check: Check) -> tuple[str, str]:
        signs = self.app.signs
        return pad(f"{signs.mark(check.verdict)} {signs.word(check.verdict)}", self._indent), signs.style(check.verdict)

    def _wide(self, check: Check, name_width: int, value_width: int, limit_width: int, margin_width: int) -> list[Content]:
        """One row, where the names fit beside the numbers."""
        (start, style), say = self._start(check), self.app.say
        indent = self._indent
        names = wrap(check.name, name_width)
        loud = style if check.open else ""
        first = Content.assemble(
            (start, style), pad(names[0], name_width), " " * GAP, (f"{say.number(short(check.value)):>{value_width}}", loud), " " * GAP,
            (f"{say(check.limit_text()):<{limit_width}}", "dim"), (f"{say(check.margin_text()):>{margin_width}}", style),
        )  # fmt: skip
        return [first, *(Content(" " * indent + name) for name in names[1:])]

    def _two(self, check: Check, width: int, margin_width: int) -> list[Content]:
        """The name in one row, the numbers in the next."""
        start, style = self._start(check)
        indent = self._indent
        room = width - indent - margin_width
        names = wrap(check.name, room - 1)
        loud = style if check.open else ""
        first = Content.assemble((start, style), pad(names[0], room), (f"{self.app.say(check.margin_text()):>{margin_width}}", style))
        limit, say = check.limit_text(), self.app.say
        numbers = Content.assemble(" " * indent, (say.number(short(check.value)), loud), (f"   {say(limit)}", "dim"))
        return [first, *(Content(" " * indent + name) for name in names[1:]), numbers]
