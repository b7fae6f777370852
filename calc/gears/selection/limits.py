# SPDX-License-Identifier: Apache-2.0
"""Between which shifts each rule holds, and what is said where nothing keeps them all."""

from collections.abc import Iterator

import numpy as np

from ...sheet.errors import NoSolution
from ...sheet.record import record
from ...sheet.search import Judged, governing, least, stretch
from ...sheet.text import SEMICOLON, Amount, Small, Text
from .free_shifts import Freedom
from .optimum import Case, Slice, ends
from .rules import UNDERCUT, Rule


@record
class Limit:
    """Where one rule holds along the free shift, around the optimum or nearest to it; None: nowhere.  `low`, `high`: what ends it."""

    rule: Rule
    range: tuple[float, float] | None
    low: str
    high: str


def limits(along: Slice, i: int) -> Iterator[Limit]:
    for rule in dict.fromkeys(one.rule for one in along.rules):
        entries = [one for one in along.rules if one.rule is rule]
        run = stretch(least(entries) >= 0, i)
        if run is None:
            yield Limit(rule, None, "", "")
            continue
        inner = 0 < run[0], run[1] < len(along.t) - 1
        low = _stopped(entries, run[0] - 1) if inner[0] else _end(along, "low")
        high = _stopped(entries, run[1] + 1) if inner[1] else _end(along, "high")
        if rule is not UNDERCUT:
            low, high = low if inner[0] else "", high if inner[1] else ""
        yield Limit(rule, (float(along.t[run[0]]), float(along.t[run[1]])), low, high)


def _stopped(entries: list[Judged], i: int) -> str:
    place: str = governing(entries, i).where.name
    return place


def _end(along: Slice, side: str) -> str:
    """The wheel that ends the slice: by undercut, or by the end of what can be given."""
    wheel, i = (along.low, 0) if side == "low" else (along.high, -1)
    x = float(along.states.shifts[wheel][i])
    return wheel if x < along.states.undercut_limit[wheel] + 1e-3 else Text("{wheel} at x = {x}", wheel=wheel, x=Amount(x, digits=3))


def too_narrow(case: Case, way: Freedom) -> NoSolution:
    bounds = ends(case, way)
    leader = next((name for name in way.free if bounds[name][0] > bounds[name][1]), way.free[0])
    low, high, by_low, by_high = bounds[leader]
    return NoSolution(
        Text("no profile shift keeps all wheels from undercut"),
        Text("shift of {leader}: {low_wheel} needs at least {low}, {high_wheel} at most {high}", leader=leader, low_wheel=by_low,
             low=Amount(low, form=".4f"), high_wheel=by_high, high=Amount(high, form=".4f")),
        Text("give a larger centre distance, more teeth, or a tool with a smaller addendum"),
    )  # fmt: skip


def nothing(along: Slice) -> NoSolution:
    """The rules that stop it from both sides, and the shift that misses by least."""
    i = int(np.argmax(least(along.rules)))
    worst = governing(along.rules, i)
    passes = []
    for limit in limits(along, i):
        rule = Small(limit.rule.name)
        if limit.range is None:
            passes.append(Text("{rule}: nowhere", rule=rule))
        elif limit.low or limit.high:
            low, high = (Amount(x, form=".4f") for x in limit.range)
            passes.append(Text("{rule}: from {low} to {high}", rule=rule, low=low, high=high))
    tried = Text(
        "shift of {leader}, {low} to {high}, passes by {rules}. The nearest is {nearest}: {symbol} of {place} is {value}, needs {limit}",
        leader=along.leader, low=Amount(along.t[0], form=".4f"), high=Amount(along.t[-1], form=".4f"), rules=SEMICOLON.join(passes),
        nearest=Amount(along.t[i], form=".4f"), symbol=worst.rule.symbol, place=worst.where.name, value=float(worst.value[i]),
        limit=worst.rule.limit,
    )  # fmt: skip
    return NoSolution(Text("no profile shift keeps every rule"), tried, worst.rule.advice)
