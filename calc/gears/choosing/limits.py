# SPDX-License-Identifier: Apache-2.0
"""Between which shifts each rule holds, and what is said where nothing keeps them all."""

import numpy as np

from ...sheet.arrays import BoolArray
from ...sheet.errors import NoSolution
from ...sheet.number import short
from ...sheet.record import record
from .freedom import Freedom
from .optimum import Case, Slice, ends
from .rules import UNDERCUT, Judged, Rule, least


@record
class Limit:
    """Where one rule holds along the free shift, around the optimum or nearest to it; None: nowhere.  `low`, `high`: what ends it."""

    rule: Rule
    range: tuple[float, float] | None
    low: str
    high: str


def stretch(passing: BoolArray, i: int) -> tuple[int, int] | None:
    """First and last index of the passing stretch around i, or nearest to it."""
    kept = np.flatnonzero(passing)
    if not len(kept):
        return None
    i = int(kept[np.argmin(np.abs(kept - i))])
    fails = np.flatnonzero(~passing)
    before, after = fails[fails < i], fails[fails > i]
    return (int(before[-1]) + 1 if len(before) else 0), (int(after[0]) - 1 if len(after) else len(passing) - 1)


def limits(along: Slice, i: int) -> list[Limit]:
    found = []
    for rule in dict.fromkeys(one.rule for one in along.rules):
        entries = [one for one in along.rules if one.rule is rule]
        run = stretch(least(entries) >= 0, i)
        if run is None:
            found.append(Limit(rule, None, "", ""))
            continue
        inner = 0 < run[0], run[1] < len(along.t) - 1
        low = _stopped(entries, run[0] - 1) if inner[0] else _end(along, "low")
        high = _stopped(entries, run[1] + 1) if inner[1] else _end(along, "high")
        if rule is not UNDERCUT:
            low, high = low if inner[0] else "", high if inner[1] else ""
        found.append(Limit(rule, (float(along.t[run[0]]), float(along.t[run[1]])), low, high))
    return found


def _stopped(entries: list[Judged], i: int) -> str:
    return min(entries, key=lambda one: float(one.margin[i])).place


def _end(along: Slice, side: str) -> str:
    """The wheel that ends the slice: by undercut, or by the end of what can be given."""
    wheel, i = (along.low, 0) if side == "low" else (along.high, -1)
    x = float(along.states.shifts[wheel][i])
    return wheel if x < along.states.undercut_limit[wheel] + 1e-3 else f"{wheel} at x = {x:.3g}"


def too_narrow(case: Case, way: Freedom) -> NoSolution:
    found = ends(case, way)
    leader = next((name for name in way.free if found[name][0] > found[name][1]), way.free[0])
    low, high, by_low, by_high = found[leader]
    return NoSolution(
        "no profile shift keeps all wheels from undercut",
        f"shift of {leader}: {by_low} needs at least {low:.4f}, {by_high} at most {high:.4f}",
        "give a larger centre distance, more teeth, or a tool with a smaller addendum",
    )


def nothing(along: Slice) -> NoSolution:
    """The rules that stop it from both sides, and the shift that misses by least."""
    margin = least(along.rules)
    i = int(np.argmax(margin))
    worst = min(along.rules, key=lambda one: float(one.margin[i]))
    said = []
    for limit in limits(along, i):
        if limit.range is None:
            said.append(f"{limit.rule.name.lower()}: nowhere")
        elif limit.low or limit.high:
            said.append(f"{limit.rule.name.lower()}: from {limit.range[0]:.4f} to {limit.range[1]:.4f}")
    value = short(float(worst.value[i]))
    return NoSolution(
        "no profile shift keeps every rule",
        f"shift of {along.leader}, {along.t[0]:.4f} to {along.t[-1]:.4f}, passes by {'; '.join(said)}. The nearest is {along.t[i]:.4f}: "
        f"{worst.rule.symbol} of {worst.place} is {value}, needs {worst.rule.limit:g}",
        worst.rule.advice,
    )
