# SPDX-License-Identifier: Apache-2.0
"""What stands for what is not given, numbered, and what it puts at risk."""

from collections.abc import Iterable

from ..sheet.check import Check
from ..sheet.record import record
from ..sheet.text import EMPTY, SEMICOLON, Amount, Small, Text, plural


@record
class Assumption:
    """`words`: what is taken, `checks`: those that rest on it."""

    number: int
    words: Text
    checks: tuple[Check, ...]

    @property
    def name(self) -> str:
        return f"A{self.number}"

    @property
    def lost(self) -> tuple[Check, ...]:
        """The checks that do not hold where all that is assumed for them is as bad as it can be, but would at its best,
        the worst first."""
        lost = [check for check in self.checks if check.kept_at_worst is False and check.kept_at_best is not False]
        return tuple(sorted(lost, key=_left))

    @property
    def unknown(self) -> tuple[Check, ...]:
        """Those of which nobody knows how far they go."""
        return tuple(check for check in self.checks if check.at_worst == "none")

    @property
    def risk(self) -> Text:
        """What comes of it at its worst."""
        said = []
        if self.lost:
            worst, *others = self.lost
            more = plural("; {n} more", "; {n} more", n=len(others)) if others else EMPTY
            value = Amount(float(worst.at_worst or 0.0), worst.unit)  # a number, else it would not be among them
            limit = worst.limit_text()
            said.append(
                Text("{check} comes to {value}, needs {limit}", check=worst.name, value=value, limit=limit) + more
            )
        if self.unknown:
            said.append(Text("how far it goes nobody knows: {check}", check=Small(self.unknown[0].name)))
        if said:
            return SEMICOLON.join(said)
        if any(check.kept_at_best is False for check in self.checks):
            return Text("what fails on it fails at its best too")
        if all(check.at_worst == check.value for check in self.checks):
            return Text("all hold with it, which is taken as the unfavourable end")
        return Text("all hold at its worst too")


def _left(check: Check) -> float:
    """How far a check is from its limit at the worst, as a share of it; below 0 where it is passed over."""
    worst = check.at_worst
    low, high = check.bounds
    at = worst if isinstance(worst, (int, float)) else check.value
    gaps = [at - low] if low is not None else []
    gaps += [high - at] if high is not None else []
    return min(gaps) / (check.scale or 1.0)


def assumptions(checks: Iterable[Check]) -> tuple[Assumption, ...]:
    """In the order in which the checks rest on them; advice and notes on the method rest on none."""
    found: dict[str, tuple[Text, list[Check]]] = {}
    for check in checks:
        if check.kind in ("limit", "caution"):
            for words in check.taken:
                found.setdefault(str(words), (words, []))[1].append(check)
    return tuple(Assumption(n, words, tuple(some)) for n, (words, some) in enumerate(found.values(), 1))
