# SPDX-License-Identifier: Apache-2.0
"""What several checks come to: how many are open, the state of a step and of a design, and the words for both."""

import math
from collections.abc import Iterable, Sequence
from typing import Literal

from .check import KINDS, ORDER, URGENT, Check
from .record import record
from .text import COMMA, SEMICOLON, Text, plural

# --- how many

COUNTED = ("failed", "not_verified", "cautions", "narrow", "accepted")  # in the order of the words


@record
class Counts:
    """How many checks: `limits` there are, of which `failed`, are `not_verified` or hold by a `narrow` margin;
    `cautions` that are open, and those that hold; `accepted` ones; open `advice` and notes on the `method`."""

    limits: int
    failed: int
    not_verified: int
    cautions: int
    narrow: int
    accepted: int
    advice: int
    method: int
    cautions_held: int

    @property
    def words(self) -> tuple[tuple[str, Text], ...]:
        """`2 failed`, `3 cautions`: what is open, or accepted, with the name of its count; zeros left out."""
        words = (
            plural("{n} failed", "{n} failed", n=self.failed),
            plural("{n} not verified", "{n} not verified", n=self.not_verified),
            plural("{n} caution", "{n} cautions", n=self.cautions),
            plural("{n} narrow", "{n} narrow", n=self.narrow),
            plural("{n} accepted", "{n} accepted", n=self.accepted),
        )
        return tuple([(name, text) for name, text in zip(COUNTED, words, strict=True) if getattr(self, name)])

    @property
    def held(self) -> int:
        """Limits that were judged and hold."""
        return self.limits - self.failed - self.not_verified


def counts(checks: Iterable[Check]) -> Counts:
    """Of these checks, each counted by itself."""
    verdicts = [(check.kind, check.verdict) for check in checks]
    limits = [verdict for kind, verdict in verdicts if kind == "limit"]
    open_ = [kind for kind, verdict in verdicts if kind != "limit" and verdict not in ("pass", "accepted")]
    return Counts(
        len(limits),
        limits.count("fail"),
        limits.count("not_verified"),
        open_.count("caution"),
        limits.count("warn"),
        sum(verdict == "accepted" for _, verdict in verdicts),
        open_.count("advice"),
        open_.count("method"),
        verdicts.count(("caution", "pass")),
    )


# --- the state of a step, and of a design

State = Literal["no_solution", "blocked", "not_asked", "fail", "not_verified", "not_judged", "computed", "warn", "pass"]
TITLES: dict[str, Text] = {
    "no_solution": Text("NO SOLUTION"),
    "blocked": Text("BLOCKED"),
    "not_asked": Text("NOT ASKED"),
    "fail": Text("FAIL"),
    "not_verified": Text("NOT VERIFIED"),
    "not_judged": Text("NOT JUDGED"),
    "computed": Text("COMPUTED"),
    "warn": Text("WARN"),
    "pass": Text("PASS"),
}


def judging(check: Check) -> bool:
    """Whether it is a limit that judges the design, not its data."""
    return check.kind == "limit" and check.role in ("physics", "chosen")


def step_state(checks: Sequence[Check], *, computes: bool = False) -> State:
    """Of a step that is solved.  `computes`: it is there for its numbers, and need not judge anything."""
    n = counts(checks)
    if n.failed:
        return "fail"
    if n.not_verified:
        return "not_verified"
    if not any(map(judging, checks)):
        if not computes:
            return "not_judged"
        if not n.cautions:
            return "computed"
    return "warn" if n.cautions or n.narrow else "pass"


def design_state(checks: Iterable[Check], steps: Iterable[str]) -> State:
    """Of a whole design: of all checks, and of the states of its steps."""
    checks, steps = list(checks), list(steps)
    if "no_solution" in steps:
        return "no_solution"
    state = step_state(checks)
    return "not_verified" if "blocked" in steps and state != "fail" else state


def verdict_words(state: str, n: Counts, lost: Sequence[Text] = ()) -> Text:
    """`FAIL: 2 failed, 3 cautions`: the state and what is open.  `lost`: the steps without a solution, or blocked."""
    open_ = COMMA.join([*lost, *(words for _, words in n.words)])
    return Text("{state}: {open}", state=TITLES[state], open=open_) if open_ else TITLES[state]


def colour_state(state: str, n: Counts) -> str:
    """The state whose colour it has: what nobody judged looks open as soon as something is."""
    return "warn" if state == "not_judged" and n.cautions else state


def closest(checks: Iterable[Check]) -> Check | None:
    """The limit or caution that is kept by least, or missed by most, a limit that fails before all cautions; None where
    none was judged.  Limits that may be used up, and those of data against themselves, come close by their nature."""
    among = [
        check
        for check in checks
        if (check.kind == "caution" or judging(check))
        and not check.exact
        and check.finding != "not_verified"
        and math.isfinite(check.margin)
    ]
    return min(among, key=lambda check: (check.finding != "fail", check.margin), default=None)


# --- checks in order, and under their causes


def grouped(checks: Iterable[Check]) -> list[tuple[Check, ...]]:
    """Checks under their causes, doubts of the input before all, then the worst kind and verdict first; within a group
    the worst first.

    A group stands where its worst check does.  Checks of one kind and verdict keep their order, the limit that is
    missed furthest first."""
    groups: dict[str, list[Check]] = {}
    for check in checks:
        groups.setdefault(check.cause or check.id, []).append(check)
    ordered = (tuple(sorted(group, key=severity)) for group in groups.values())
    return sorted(ordered, key=lambda group: severity(group[0])[:4])


def with_it(checks: Sequence[Check], most: int = 3) -> Text:
    """What else of a group is open beside its worst: as what it counts, and by name."""
    numbers = COMMA.join([words for _, words in counts(checks).words])
    return Text("With it {numbers}: {names}", numbers=numbers, names=named(checks, most))


def named(checks: Sequence[Check], most: int = 3) -> Text:
    """Checks by name and margin; of more than `most` the rest as a number."""
    first = SEMICOLON.join(Text("{name} ({margin})", name=c.name, margin=c.margin_text()) for c in checks[:most])
    return first if len(checks) <= most else Text("{names}; {more} more", names=first, more=len(checks) - most)


def severity(check: Check) -> tuple[bool, bool, int, int, float]:
    """What sorts checks: open ones before those that hold or are accepted, doubts of the input before what follows from
    it, then by kind, then the worst verdict first."""
    margin = -math.inf if math.isnan(check.margin) else check.margin
    return not check.open, not check.rule.of_input, KINDS.index(check.kind), -ORDER.index(check.verdict), margin


def open_findings(checks: Iterable[Check]) -> list[tuple[Check, ...]]:
    """What somebody has to look at, under its causes: what page, screen and command line list, and count, alike."""
    groups = [tuple([check for check in group if check.verdict in URGENT]) for group in grouped(checks)]
    return [group for group in groups if group]


def findings_of(groups: Sequence[Sequence[Check]]) -> Text:
    """`3 findings (7 checks)`: how many causes are listed, and how many checks stand under them."""
    checks = sum(map(len, groups))
    findings = plural("{n} finding", "{n} findings", n=len(groups))
    if checks == len(groups):
        return findings
    return Text("{findings} ({checks})", findings=findings, checks=plural("{n} check", "{n} checks", n=checks))
