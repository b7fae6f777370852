# SPDX-License-Identifier: Apache-2.0
"""The search for shifts: a gear train in, rows to choose from out.

In this order: the optimum of each way to leave shifts free, what each pair alone would want, round shifts around the
optimum, tip cuts with the shifts as they are, and tip cuts with the shift that is then the best."""

from collections.abc import Mapping, Sequence

import numpy as np

from ...sheet.errors import NoSolution
from ...sheet.progress import Progress, part, tell
from ...sheet.record import record, replace
from ...sheet.search import Judged, governing, least, least_wanted, stretch
from ...sheet.text import EMPTY, Name, Text
from ..inputs import GearsInputs
from ..layout.positions import NO_AXES, Axes
from ..train import tooth_system
from ..wheel_inputs import Wheel
from .free_shifts import Freedom, freedoms, settled
from .optimum import GRID, Limit, ShiftCase, Slice, best, evaluated, limits, nothing, refined, slice_of, too_narrow
from .states import HARD_CASE, USUAL, Bar, Place, States, eased, judge, states

AROUND = 0.05  # step of the shift between the rows around the optimum
EACH_SIDE = 5  # of such rows
CUTS = 4  # steps of the tip cut that are looked at
GAIN = 5e-4  # of the largest sliding: less is no gain
CUT_STEP = 0.05  # of the module: the step of the tip cut, before it is made round


@record
class ShiftRow:
    """One train that can be written.  `freedom` None: the shifts as they are.  `cuts`: those that change.

    `least`: the rule with the least margin, and where.  `bar`: the limits that it is judged by.
    `wants`: the mesh that would have it so, where it is one alone.
    """

    name: Text
    freedom: Freedom | None
    free: Mapping[str, float]
    cuts: Mapping[str, float]
    states: States
    largest: float
    of: Place
    least: Judged
    bar: Bar
    wants: str = ""

    @property
    def margin(self) -> float:
        return float(self.least.margin[0])

    @property
    def passes(self) -> bool:
        return self.margin >= 0

    @property
    def usual(self) -> bool:
        """Whether it keeps the usual limits, and not only those that the design itself keeps."""
        return self.passes and self.bar in (HARD_CASE, USUAL)


@record
class ShiftsFound:
    """What there is to choose.  `now`: None where the design contradicts itself.  `along`: what limits, wants and curve
    belong to.

    Numbered through in this order: `optima`, `wants` that pass, `around`, `cut_now` that pass, `cut_best`.
    """

    case: ShiftCase
    freedoms: tuple[Freedom, ...]
    now: ShiftRow | None
    optima: tuple[ShiftRow, ...]
    wants: tuple[ShiftRow, ...]
    around: tuple[ShiftRow, ...]
    cut_now: tuple[ShiftRow, ...]
    cut_best: tuple[ShiftRow, ...]
    limits: tuple[Limit, ...]
    along: Slice
    exact: tuple[float, float] | None  # shift and largest sliding of the optimum along one free shift, unrounded
    refused: tuple[Text, ...]  # ways to leave shifts free in which nothing passes
    no_better: tuple[Text, ...]  # those in which something does, but nothing better than with less freedom
    unsought: tuple[Text, ...]  # those with more free shifts than are searched

    @property
    def all(self) -> tuple[ShiftRow, ...]:
        wants, cuts = (tuple(row for row in rows if row.passes) for rows in (self.wants, self.cut_now))
        return (*self.optima, *wants, *self.around, *cuts, *self.cut_best)

    def number(self, row: ShiftRow) -> str:
        return next((str(n) for n, entry in enumerate(self.all, 1) if entry is row), "")


def search(gears: GearsInputs, progress: Progress | None = None, axes: Axes = NO_AXES) -> ShiftsFound:
    """Raises NoSolution where no shift keeps every rule, with the rules that stop it."""
    case = ShiftCase(tooth_system(gears), gears)
    every = freedoms(gears, case.system, axes)
    ways = tuple(freedom for freedom in every if len(freedom.free) in GRID)
    if not ways:
        raise NoSolution(
            Text("more shifts are free than can be searched"), advice=Text("give the centre distances of the train")
        )
    train = settled(gears, case.system)
    now = None
    if train is not None:
        now = _row(case, Text("now"), None, {}, {}, states(case.system, gears, train.shifts))
    if now is not None and (bar := eased(now.states, case.system)) is not None:
        case = replace(case, bars=(*case.bars, bar))
    optima, passing = _offered(case, ways, progress)
    main = next((row for row in optima if len(row.free) == 1), optima[0] if optima else None)
    way, bar, nearest = _starting_point(case, ways, main)
    along = slice_of(case, way, nearest, bar)
    if along is None or nearest is None:
        raise too_narrow(case, way)
    cut_best = tuple(_cut_best(case, way, [row for row in optima if row.freedom is way], part(progress, 0.5, 1.0)))
    if not optima and not cut_best:
        raise nothing(along)
    i = int(np.argmin(np.abs(along.t - nearest[along.leader])))
    exact = refined(case, way, nearest[along.leader], bar) if main and len(way.free) == 1 else None
    return ShiftsFound(
        case=case,
        freedoms=ways,
        now=now,
        optima=tuple(optima),
        wants=tuple(_wants(case, along, nearest)),
        around=tuple(_around(case, along, nearest, i)),
        cut_now=tuple(_cut_now(case, now)),
        cut_best=cut_best,
        limits=tuple(limits(along, i)),
        along=along,
        exact=exact,
        refused=tuple(freedom.name for freedom in ways if freedom.name not in passing),
        no_better=tuple(
            way.name for way in ways if way.name in passing and not any(row.freedom is way for row in optima)
        ),
        unsought=tuple(freedom.name for freedom in every if freedom not in ways),
    )


def _offered(
    case: ShiftCase, ways: Sequence[Freedom], progress: Progress | None
) -> tuple[list[ShiftRow], frozenset[Text]]:
    """The optima of all ways that are better than those with less freedom, the least sliding first; and the names of
    the ways in which something passes."""
    offered: list[ShiftRow] = []
    passing: set[Text] = set()
    candidates = [GRID[len(way.free)] ** len(way.free) for way in ways]  # which is what takes the time
    work = [0.0, *np.cumsum(candidates)]
    for n, way in enumerate(ways):
        here = part(progress, 0.5 * work[n] / work[-1], 0.5 * work[n + 1] / work[-1])
        within = [row for row in offered if row.freedom is not None and way.contains(row.freedom)]
        rows = _optima(case, way, within=within, progress=here)
        if rows:
            passing.add(way.name)
        offered += [row for row in rows if not _beaten(case, row, within)]
    return sorted(offered, key=lambda row: (_shown(row), len(row.free))), frozenset(passing)


def _beaten(case: ShiftCase, row: ShiftRow, others: Sequence[ShiftRow]) -> bool:
    """Whether one of the others has less sliding within the same limits, or stricter ones."""
    return any(_shown(row) > _shown(other) for other in others if _keeps(case, other, row.bar))


def _starting_point(
    case: ShiftCase, ways: Sequence[Freedom], main: ShiftRow | None
) -> tuple[Freedom, Bar, Mapping[str, float] | None]:
    """Freedom, limits and free shifts about which is looked further: those of the main row; where nothing passes, what
    comes nearest with the least freedom, None where there is nothing."""
    way = main.freedom if main and main.freedom else min(ways, key=lambda way: len(way.free))
    if main:
        return way, main.bar, main.free
    bar = case.bars[-1]
    optimum = best(case, way, {}, bar)
    return way, bar, optimum.free if optimum else None


# --- rows


def _row(
    case: ShiftCase,
    name: Text,
    freedom: Freedom | None,
    free: Mapping[str, float],
    cuts: Mapping[str, float],
    states: States,
    wants: str = "",
) -> ShiftRow:
    """Judged by the strictest limits that it keeps; where it keeps none, by the usual ones."""
    for bar in (*case.bars, USUAL):
        rules = judge(states, case.system, bar)
        if float(least(rules)[0]) >= 0:
            break
    sliding = {at: abs(float(zeta[0])) for at, zeta in states.sliding.items()}
    of = max(sliding, key=lambda at: np.inf if np.isnan(sliding[at]) else sliding[at])
    return ShiftRow(name, freedom, free, cuts, states, float(states.largest[0]), of, governing(rules, 0), bar, wants)


def _shown(row: ShiftRow) -> float:
    """The largest sliding, without the digits that are those of round shifts."""
    return round(row.largest, 4)


def _keeps(case: ShiftCase, row: ShiftRow, bar: Bar) -> bool:
    """Whether a row that passes keeps these limits, or stricter ones."""
    return case.bars.index(row.bar) <= case.bars.index(bar)


def _optima(
    case: ShiftCase,
    way: Freedom,
    cuts: Mapping[str, float] | None = None,
    name: Text = EMPTY,
    within: Sequence[ShiftRow] = (),
    progress: Progress | None = None,
) -> list[ShiftRow]:
    """By the strictest limits that let something pass; then by each of the less strict ones that allow less sliding.

    `within`: rows of ways with less freedom, beside which is looked as well.
    """
    rows: list[ShiftRow] = []
    known: dict[bytes, States] = {}
    cuts, title = cuts or {}, name or way.name
    for n, bar in enumerate(case.bars):
        tell(progress, n / len(case.bars), title)
        beside = [row.states.shifts for row in within if _keeps(case, row, bar)]
        near = [{wheel: float(x[0]) for wheel, x in shifts.items()} for shifts in beside]
        optimum = best(case, way, cuts, bar, near, known)
        if optimum is not None and optimum.margin >= 0:
            row = _row(case, title, way, optimum.free, cuts, evaluated(case, way, optimum.free, cuts))
            if not rows or _shown(row) < _shown(rows[-1]):
                rows.append(row)
    return rows


def _along(case: ShiftCase, along: Slice, at: Mapping[str, float], t: float, name: Text, wants: str = "") -> ShiftRow:
    free = {**at, along.leader: t}
    return _row(case, name, along.freedom, free, {}, evaluated(case, along.freedom, free, {}), wants)


def _wants(case: ShiftCase, along: Slice, at: Mapping[str, float]) -> list[ShiftRow]:
    """The optimum of each pair alone, by its own rules."""
    rows = []
    for mesh in case.gears.meshes if len(case.gears.meshes) > 1 else ():
        key = mesh.key
        places = ((key, ""), (key, mesh.driver), (key, mesh.driven), ("", mesh.driver), ("", mesh.driven))
        own_rules = [rule for rule in along.rules if (rule.where.mesh, rule.where.wheel) in places]
        margin = least(own_rules)
        if (margin >= 0).any():
            t = float(along.t[least_wanted(along.states.largest_of(key), margin)])
            rows.append(_along(case, along, at, t, Name(f"{mesh.driver}–{mesh.driven}"), key))
    return rows


def _around(case: ShiftCase, along: Slice, at: Mapping[str, float], i: int) -> list[ShiftRow]:
    passing = stretch(least(along.rules) >= 0, i)
    if passing is None:
        return []
    low = max(along.t[passing[0]], along.t[i] - EACH_SIDE * AROUND)
    high = min(along.t[passing[1]], along.t[i] + EACH_SIDE * AROUND)
    n = np.arange(np.ceil(low / AROUND - 1e-6), np.floor(high / AROUND + 1e-6) + 1)
    return [
        _along(case, along, at, float(t), Text("round")) for t in np.round(n * AROUND, 4) + 0.0 if t != at[along.leader]
    ]


# --- tip cuts


def cut_steps(case: ShiftCase, wheel: Wheel) -> list[float]:
    """None, steps of a round part of the module, and that of the design."""
    wanted = CUT_STEP * case.system.m_n * 1e3
    size = 10.0 ** np.floor(np.log10(wanted))
    step = size * min((1, 2, 5, 10), key=lambda n: abs(np.log(n * size / wanted)))
    return sorted({round(float(n * step), 6) / 1e3 for n in range(CUTS + 1)} | {wheel.tip_shortening})


def _cut_now(case: ShiftCase, now: ShiftRow | None) -> list[ShiftRow]:
    rows = []
    for wheel in case.gears.wheels if now is not None else ():
        assert now is not None
        for k in cut_steps(case, wheel):
            if k != wheel.tip_shortening:
                cut_states = states(case.system, case.gears, now.states.shifts, {wheel.name: k})
                rows.append(_row(case, Name(wheel.name), None, {}, {wheel.name: k}, cut_states))
    return rows


def _cut_best(
    case: ShiftCase, way: Freedom, uncut: Sequence[ShiftRow], progress: Progress | None = None
) -> list[ShiftRow]:
    """Cuts by which the largest sliding is less than without them and by a smaller cut of the wheel, or which keep
    stricter limits."""
    rows = []
    for n, wheel in enumerate(case.gears.wheels):
        reached, steps = list(uncut), cut_steps(case, wheel)
        for i, k in enumerate(steps):
            tell(progress, (n + i / len(steps)) / len(case.gears.wheels), Text("tip cut of {wheel}", wheel=wheel.name))
            for row in _optima(case, way, {wheel.name: k}, Name(wheel.name)) if k != wheel.tip_shortening else ():
                if all(row.largest < other.largest - GAIN for other in reached if _keeps(case, other, row.bar)):
                    reached.append(row)
                    rows.append(row)
    return sorted(rows, key=lambda row: (not row.usual, row.largest))
