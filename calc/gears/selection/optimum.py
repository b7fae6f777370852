# SPDX-License-Identifier: Apache-2.0
"""The free shifts that make the largest specific sliding least, and between which shifts every rule holds.

Shifts are looked for on the lattice of round numbers that can be written into a design.  One free shift: every point of
it is looked at.  Several: a grid that narrows around its best point, which follows that point until it stays."""

import math
from collections.abc import Iterable, Iterator, Mapping

import numpy as np

from ...sheet.arrays import Array
from ...sheet.errors import NoSolution
from ...sheet.quantity import described
from ...sheet.record import record
from ...sheet.search import Judged, governing, least, least_wanted, multiples, narrowed, stretch
from ...sheet.text import SEMICOLON, Amount, Small, Text
from ..inputs import GearsInputs
from ..result import ToothSystem
from ..wheel_inputs import Wheel
from .free_shifts import Freedom
from .states import HARD_CASE, UNDERCUT, USUAL, Bar, ShiftRule, States, judge, keeps, states

ROUND = 10_000  # points of the lattice per unit of the shift
HIGHEST = described(Wheel.profile_shift).high or 3.0  # shift coefficient: the end of its input
OTHERS = 1e-3  # weight of all meshes beside the largest sliding: it decides only what the largest leaves open
# points a side (odd), by the number of free shifts; there is no search for more
GRID = {1: 41, 2: 33, 3: 15, 4: 9, 5: 7}
KEPT = 40  # grids that are kept for another bar: each of four free shifts takes about 2 MB


@record
class ShiftCase:
    """`bars`: limits to choose by, the strictest first."""

    system: ToothSystem
    gears: GearsInputs
    bars: tuple[Bar, ...] = (HARD_CASE, USUAL)


@record
class Best:
    """A point of the lattice.  `margin`: the least of all rules there; negative: no point keeps them, and this misses
    by least.

    `wanted`: what is made least.
    """

    free: Mapping[str, float]
    margin: float
    wanted: float


@record
class Slice:
    """Every point of the lattice along one free shift, the others standing still.  `low`, `high`: wheels whose shift
    ends it."""

    freedom: Freedom
    leader: str
    t: Array
    states: States
    rules: list[Judged]
    low: str
    high: str


def evaluated(
    case: ShiftCase, freedom: Freedom, free: Mapping[str, float | Array], cuts: Mapping[str, float]
) -> States:
    return states(case.system, freedom.gears, freedom.shifts(free), cuts)


def ends(case: ShiftCase, freedom: Freedom) -> dict[str, tuple[float, float, str, str]]:
    states = evaluated(case, freedom, {name: freedom.start[name] for name in freedom.free}, {})
    return freedom.bounds(states.undercut_limit, HIGHEST)


def slice_of(
    case: ShiftCase, freedom: Freedom, at: Mapping[str, float] | None = None, bar: Bar = HARD_CASE
) -> Slice | None:
    """Along the first free shift, the others at `at`; None where undercut leaves nothing between its two ends."""
    leader = freedom.free[0]
    points = along(case, freedom, leader, at or {})
    if points is None:
        return None
    _, _, by_low, by_high = ends(case, freedom)[leader]
    return Slice(freedom, leader, *points, judge(points[1], case.system, bar), by_low, by_high)


def along(
    case: ShiftCase, freedom: Freedom, leader: str, at: Mapping[str, float] | None = None
) -> tuple[Array, States] | None:
    """Every point of the lattice along one free shift, the others at `at`, else as they are; None where undercut leaves
    none."""
    low, high, _, _ = ends(case, freedom)[leader]
    t = multiples(1, low * ROUND, high * ROUND) / ROUND
    others = {name: freedom.start[name] for name in freedom.free} if at is None else at
    return (t, evaluated(case, freedom, {**others, leader: t}, {})) if len(t) else None


def objective(states: States) -> Array:
    """The largest sliding, and what tells two equal ones apart."""
    meshes = np.array([states.largest_of(mesh) for mesh in states.contact_ratio])
    largest: Array = np.max(meshes, axis=0) + OTHERS * np.sum(meshes, axis=0)
    return largest


def best(
    case: ShiftCase,
    freedom: Freedom,
    cuts: Mapping[str, float],
    bar: Bar,
    near: Iterable[Mapping[str, float]] = (),
    known: dict[bytes, States] | None = None,
) -> Best | None:
    """None where undercut leaves no shift at all.  `near`: shifts beside which several free ones are looked for as
    well.

    `known`: grids that were evaluated with the same freedom and cuts for another bar; those of this one are put there.
    """
    grids = {} if known is None else known
    bounds = ends(case, freedom)
    low = np.array([math.ceil(bounds[name][0] * ROUND - 1e-6) for name in freedom.free])
    high = np.array([math.floor(bounds[name][1] * ROUND + 1e-6) for name in freedom.free])
    if (low > high).any():
        return None
    if len(freedom.free) == 1 and not cuts:
        along = slice_of(case, freedom, bar=bar)
        assert along is not None
        margin, wanted = least(along.rules), objective(along.states)
        i = least_wanted(wanted, margin)
        return Best({freedom.free[0]: float(along.t[i])}, float(margin[i]), float(wanted[i]))

    def evaluate(points: Array) -> tuple[Array, Array]:
        if (there := grids.get(key := points.tobytes())) is None:
            there = evaluated(case, freedom, dict(zip(freedom.free, points.T / ROUND)), cuts)
            if len(grids) < KEPT:
                grids[key] = there
        return keeps(there, case.system, bar), objective(there)

    side = GRID[len(freedom.free)]
    step = np.maximum(-(-(high - low) // (side - 1)), 1)
    starts = [((low + high) // 2, step)]
    for shifts in near:
        point = np.array([round(float(shifts[name]) * ROUND) for name in freedom.free])
        starts.append((np.clip(point, low, high), np.ones_like(step)))
    reached = [narrowed(evaluate, low, high, *start, side) for start in starts]
    reach = min(reached, key=lambda candidate: (0.0, candidate[2]) if candidate[1] >= 0 else (1.0, -candidate[1]))
    return Best(dict(zip(freedom.free, (reach[0] / ROUND).tolist())), *reach[1:])


def refined(case: ShiftCase, freedom: Freedom, at: float, bar: Bar) -> tuple[float, float]:
    """(shift, largest sliding) of the optimum between the points of the lattice next to one, for one free shift."""
    width = 1.0 / ROUND
    for _ in range(5):
        t = np.linspace(at - width, at + width, 101)
        states = evaluated(case, freedom, {freedom.free[0]: t}, {})
        i = least_wanted(objective(states), keeps(states, case.system, bar))
        at, width = float(t[i]), width / 40
    return at, float(states.largest[i])


# --- between which shifts each rule holds, and what is said where nothing keeps them all


@record
class Limit:
    """Where one rule holds along the free shift, around the optimum or nearest to it; None: nowhere.  `low`, `high`:
    what ends it."""

    rule: ShiftRule
    range: tuple[float, float] | None
    low: str
    high: str


def limits(along: Slice, i: int) -> Iterator[Limit]:
    for rule in dict.fromkeys(entry.rule for entry in along.rules):
        entries = [entry for entry in along.rules if entry.rule is rule]
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
    if x < along.states.undercut_limit[wheel] + 1e-3:
        return wheel
    return Text("{wheel} at x = {x}", wheel=wheel, x=Amount(x, digits=3))


def too_narrow(case: ShiftCase, way: Freedom) -> NoSolution:
    bounds = ends(case, way)
    leader = next((name for name in way.free if bounds[name][0] > bounds[name][1]), way.free[0])
    low, high, by_low, by_high = bounds[leader]
    return NoSolution(
        Text("no profile shift keeps all wheels from undercut"),
        Text(
            "shift of {leader}: {low_wheel} needs at least {low}, {high_wheel} at most {high}",
            leader=leader,
            low_wheel=by_low,
            low=Amount(low, form=".4f"),
            high_wheel=by_high,
            high=Amount(high, form=".4f"),
        ),
        Text("give a larger centre distance, more teeth, or a tool with a smaller addendum"),
    )


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
        "shift of {leader}, {low} to {high}, passes by {rules}. The nearest is {nearest}: {symbol} of {place} is "
        "{value}, needs {limit}",
        leader=along.leader,
        low=Amount(along.t[0], form=".4f"),
        high=Amount(along.t[-1], form=".4f"),
        rules=SEMICOLON.join(passes),
        nearest=Amount(along.t[i], form=".4f"),
        symbol=worst.rule.symbol,
        place=worst.where.name,
        value=float(worst.value[i]),
        limit=worst.rule.limit,
    )
    return NoSolution(Text("no profile shift keeps every rule"), tried, worst.rule.advice)
