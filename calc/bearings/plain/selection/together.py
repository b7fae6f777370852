# SPDX-License-Identifier: Apache-2.0
"""More than two bearings, which share the load of their shaft by their films: all of them alike first, then each alone,
by the same objective as two.

A bearing that is changed changes what every other carries.  So the share is found anew over the lengths and clearances,
at a few of them and taken between these in a straight line; what is offered has been through the step itself.  Oil,
supply, surfaces and fits stay: they are of all shafts."""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence

import numpy as np

from ....countershaft.result import CountershaftResult
from ....countershaft.rows import BearingRow, called
from ....sheet.arrays import Array
from ....sheet.check import Check, CheckRule, Kind
from ....sheet.errors import NoSolution
from ....sheet.progress import Progress, tell
from ....sheet.record import record, replace
from ....sheet.search import first, least
from ....sheet.step import Table
from ....sheet.text import EMPTY, SEMICOLON, Amount, Text
from ....sheet.units import Metre, Number, Radian, Watt
from ...result import BearingsResult
from ...sharing import shared
from ...solve import condensed
from ...support import Support
from ..film.table import FilmRangeError
from ..routes.states import resized
from ..solve import PlainSupport
from . import tables
from .grid import FEW, KEPT, OF_FILM, CandidateField, clearances, lengths
from .ranking import ORDERS, CandidateRow, Order, Pick, Slopes, Wanted, picks
from .search import AT_CORNERS, STIFFER, Settled, slopes_of
from .states import BearingTask, against, letter_of, size, solved
from .variants import (
    SelectionCase,
    Solution,
    Variant,
    crossings,
    diameters,
    solved_or_probed,
    tasks_of,
    tied,
    variants,
)
from .writing import with_row

NODES = 4  # lengths, and clearances, at which the share is found
LOOKED = 6  # diameters that are looked at, from the smallest that carries the load on
# of what kinds a row has to keep every rule, one after the other: where it can, it mends the cautions of the design
KINDS: tuple[tuple[Kind, ...], ...] = (("limit", "caution"), ("limit",))
# of a film, asked one after the other, where the step itself refuses what has less; rule of this program
SPARE = (KEPT, 0.1, 0.2)
ALL_ALIKE = Text("all alike")
AS_IT_IS = Text("as it is")


@record
class AskedRules:
    """What a row has to keep: every rule of these `kinds`, and the `rules` of each judged bearing that is changed."""

    kinds: tuple[Kind, ...]
    rules: Mapping[str, frozenset[CheckRule]]


@record
class SharedRow:
    """A row that the step has passed.  `which` bearings it changes, of which `row` is; `every`: all that are judged,
    with the loads that they then carry; `by`: the least margin by the rules that are asked."""

    which: Text
    row: CandidateRow
    every: tuple[Pick, ...]
    by: Check

    @property
    def power(self) -> Watt:
        return sum(pick.power for pick in self.every)

    @property
    def wanted(self) -> Wanted:
        return self.row.wanted._replace(power=np.asarray(self.power))


@record
class SharedFound:
    """What there is to choose.  `corners`: whether the rows keep the rules at the corners of the tolerances, or as
    given.  `stays`: why no other diameter is looked at; empty: others are.  `left_out`: rules that are not asked, as
    the design does not keep them.  `refused`: what has no row, and why.  `named`: what the rows are called where others
    stand among them; empty: by their numbers."""

    case: SelectionCase
    now: SharedRow | None
    rows: tuple[SharedRow, ...]
    slopes: dict[str, Radian]
    asked: AskedRules
    left_out: tuple[Check, ...]
    corners: bool
    stays: Text
    refused: tuple[Text, ...]
    named: tuple[int, ...] = ()

    def no(self, number: int) -> int:
        """What a row is called."""
        return self.named[number - 1] if self.named else number


@record
class MovedTogether:
    """Bearings that are changed together, and the candidates: of every judged bearing a field over the same lengths and
    clearances of those that are `moved`."""

    which: Text
    moved: tuple[str, ...]
    fields: Mapping[str, CandidateField]

    def margin(self, slopes: Slopes, asked: AskedRules, spare: Number = KEPT) -> Array:
        """The least of all, of a film less what is to be spare of it; of bearings that stay only what a limit asks."""
        return least(
            replace(limit, margin=limit.margin - spare) if rule in OF_FILM else limit
            for place, field in self.fields.items()
            for rule, limit in field.judged(slopes[place]).items()
            if rule.kind == "limit" or (place in self.moved and rule in asked.rules[place])
        )

    def wanted(self) -> Wanted:
        """Of all bearings the power; of those that it changes the rest."""
        every = [Wanted.of(field) for field in self.fields.values()]
        moved = [Wanted.of(self.fields[place]) for place in self.moved]
        power = np.sum([one.power for one in every], axis=0)
        return Wanted(*(np.sum(numbers, axis=0) for numbers in zip(*moved)))._replace(power=power)

    def as_given(self) -> "MovedTogether":
        """The same, judged as they are given and not at the corners of the tolerances."""
        fields = dict[str, CandidateField]()
        for place, field in self.fields.items():
            task, l, g = replace(field.task, corners=False), field.states.length, field.states.clearance
            fields[place] = CandidateField(task, field.variant, solved(task, l, g, all_rises=False))
        return replace(self, fields=fields)

    def picked(self, at: tuple[np.intp, ...], slopes: Slopes) -> tuple[Pick, ...]:
        """One candidate: of the bearings that it changes."""
        return tuple(_pick(self.fields[place], at, slopes[place]) for place in self.moved)


def search(case: SelectionCase, aim: str = "loss", progress: Progress | None = None) -> SharedFound:
    """Rows to choose from.  `aim`: "loss", "size", "film".

    Raises NoSolution where there are none, with what comes nearest and what stops it."""
    slopes, variant = slopes_of(case), variants(case)[0]
    there = solved_or_probed(case, case.rows)
    own = tasks_of(case, there)
    if not own:
        raise NoSolution(Text("none of the bearings carries a load that is judged"), EMPTY, STIFFER)
    stays = next(filter(None, (tied(case, row) for row in case.rows)), EMPTY)
    tasks, every = own, _as_they_are(own, slopes)
    groups = list(_groups(case, own, there, variant, not stays, _asked(every, KINDS[-1]), progress))
    refused, rows = list[Text](), list[SharedRow]()
    for corners in (True,) if case.bearings.fits_given else (True, False):
        if not corners:
            tasks = {place: replace(task, corners=False) for place, task in own.items()}
            groups, every = [group.as_given() for group in groups], _as_they_are(tasks, slopes)
        for kinds in KINDS:
            refused, asked = [], _asked(every, kinds)
            rows = list(_rows(case, groups, variant, slopes, asked, ORDERS[aim], refused, progress))
            if (own_row := _as_it_is(case, variant, every, slopes, asked)) is not None:
                rows = [own_row, *(one for one in rows if tables.changed(one.row))]
            if rows:
                break
        if rows:
            break
    if not rows:
        raise NoSolution(Text("no bearings keep every rule of the search"), SEMICOLON.join(refused[:2]), STIFFER)
    left_out = tuple(c for pick in every for c in pick.checks if c.rule not in asked.rules[pick.task.place])
    solved_now = all(pick.power == pick.power for pick in every)
    now = CandidateRow("now", variant, every)
    rows.sort(key=lambda row: tuple(map(float, ORDERS[aim](row.wanted))))
    return SharedFound(
        case,
        SharedRow(EMPTY, now, now.picks, _governing(now.picks, asked)) if solved_now else None,
        tuple(rows),
        slopes,
        asked,
        left_out,
        all(task.corners for task in tasks.values()),
        stays,
        tuple(refused),
    )


def _as_it_is(
    case: SelectionCase,
    variant: Variant,
    every: tuple[Pick, ...],
    slopes: dict[str, Radian],
    asked: AskedRules,
) -> SharedRow | None:
    """The design as a row of its own; None where it does not keep what is asked."""
    if not all(pick.power == pick.power for pick in every) or _governing(every, asked).margin < 0:
        return None
    settled = confirmed(case, CandidateRow("offered", variant, every), slopes, asked, last=True)
    if settled.row is None:
        return None
    picked = settled.row.picks
    return SharedRow(AS_IT_IS, settled.row, picked, _governing(picked, asked))


def _as_they_are(tasks: Mapping[str, BearingTask], slopes: Slopes) -> tuple[Pick, ...]:
    return tuple(picks(task, [task.length], [task.clearance], slopes[place])[0] for place, task in tasks.items())


def _asked(every: Iterable[Pick], kinds: tuple[Kind, ...]) -> AskedRules:
    """Rules of these kinds, and of the others those that the design itself keeps: a fast shaft has some that no bearing
    of it can keep."""
    rules = {
        pick.task.place: frozenset(c.rule for c in pick.checks if c.rule.kind in kinds or c.margin >= 0)
        for pick in every
    }
    return AskedRules(kinds, rules)


def _governing(picked: Iterable[Pick], asked: AskedRules) -> Check:
    """The least margin by the rules that are asked."""
    return min(
        (c for pick in picked for c in pick.checks if c.rule in asked.rules[pick.task.place]), key=lambda c: c.margin
    )


def confirmed(
    case: SelectionCase, row: CandidateRow, slopes: dict[str, Radian], asked: AskedRules, *, last: bool = False
) -> Settled:
    """A row through the solution itself, with what each bearing then carries.  `last`: no step after the bearings is
    solved."""
    inputs, rows = with_row(case, row)
    results = case.solve(inputs, rows, last=last)
    seen = case.seen(results)
    there, again = seen.outcomes["bearings"], slopes_of(case, results, slopes)
    if there.state != "solved":
        return Settled(None, again, (), there.reason, results)
    own = {pick.task.place: pick.task for pick in row.picks}
    tasks = tasks_of(case, seen, rows, own)
    picked = tuple(
        picks(replace(tasks[place], corners=own[place].corners), [p.length], [p.clearance], again[place])[0]
        for place, p in zip(own, row.picks)
        if place in tasks
    )
    failing = [c for c in (*there.checks, *crossings(seen)) if c.verdict == "fail"]
    former = case.seen(case.results).outcomes["bearings"]
    were = {c.id: min(c.margin, 0.0) for c in former.checks if former.verdict not in ("fail", "no_solution")}
    cautions = [c for c in there.checks if c.rule.kind == "caution"]
    failing += [c for c in cautions if c.margin < (0.0 if "caution" in asked.kinds else were.get(c.id, -math.inf))]
    if row.corners:
        failing += [c for c in there.checks if c.rule in AT_CORNERS and c.verdict != "fail" and not c.margin >= 0]
    if picked and (worst := _governing(picked, asked)).margin < 0:
        failing.append(worst)
    if failing or len(picked) < len(row.picks):
        return Settled(None, again, (), against(failing[0]) if failing else Text("it carries next to nothing"), results)
    return Settled(replace(row, picks=picked), again, results=results)


def _groups(
    case: SelectionCase,
    own: Mapping[str, BearingTask],
    there: Solution,
    variant: Variant,
    free: bool,
    asked: AskedRules,
    progress: Progress | None,
) -> Iterator[MovedTogether]:
    """All alike, at the design's own diameters and at each other, then each alone at its own."""
    yield from _group(case, ALL_ALIKE, own, there, variant, tuple(own), asked)
    most = max(own.values(), key=lambda task: task.duty.load)
    row = next(row for row in case.rows if row.name == most.place)
    for n, d in enumerate(diameters(case, row, most)[:LOOKED] if free else ()):
        tell(progress, 0.1 + 0.4 * n / LOOKED, ALL_ALIKE)
        rows = tuple(_thicker(row, d) for row in case.rows)
        try:
            other = solved_or_probed(case, rows)
        except NoSolution:
            continue
        tasks = tasks_of(case, other, rows, own)
        yield from _group(case, ALL_ALIKE, tasks, other, variant, tuple(tasks), asked)
    for place in own if len(own) > 1 else ():
        yield from _group(case, Text("{place} alone", place=called(place)), own, there, variant, (place,), asked)


def _thicker(row: BearingRow, d: Metre) -> BearingRow:
    """A row with another diameter, and as much metal around it."""
    outer = None if row.housing_outer is None else row.housing_outer + d - row.diameter
    return replace(row, diameter=d, housing_outer=outer)


def _group(
    case: SelectionCase,
    which: Text,
    tasks: Mapping[str, BearingTask],
    there: Solution,
    variant: Variant,
    moved: tuple[str, ...],
    asked: AskedRules,
) -> Iterator[MovedTogether]:
    """Its candidates; nothing where no length is left."""
    first_task = tasks[moved[0]]
    of_each = [set(np.round(_lengths(tasks[place]), 9)) for place in moved]
    l = np.array(sorted(set.intersection(*of_each)))
    g = clearances(first_task, FEW)
    if any(task.alike and (place in moved) != first_task.alike for place, task in tasks.items()):
        g = np.array([first_task.clearance])  # classes are of all that are picked by them
    if not l.size or not g.size:
        return
    loads = _loads(case, tasks, there, moved, l, g)
    shape = (g.size, l.size)
    fields = {}
    for place, task in tasks.items():
        under = task.under(loads[place])  # with what it carries as each candidate
        l_here = np.broadcast_to(l if place in moved else task.length, shape)
        g_here = np.broadcast_to(g[:, None] if place in moved else task.clearance, shape)
        fields[place] = CandidateField(under, variant, solved(under, l_here, g_here, all_rises=False))
    yield MovedTogether(which, moved, fields)


def _lengths(task: BearingTask) -> Array:
    """In its room, or as long as it is."""
    longest = task.room.longest
    room = replace(task.room, longest=None if longest is None else max(longest, task.length))
    return lengths(replace(task, room=room), in_room=True)


def _loads(
    case: SelectionCase,
    tasks: Mapping[str, BearingTask],
    there: Solution,
    moved: tuple[str, ...],
    l: Array,
    g: Array,
) -> dict[str, Array]:
    """What each bearing carries over clearances down and lengths across; nan where the films find no common place."""
    found, shaft = there.result(BearingsResult), there.result(CountershaftResult)
    assert found is not None
    rows = tuple(r.row for r in found.bearings.values())
    turning = condensed(case.bearings, rows, shaft)
    if turning is None or case.shaft is None:
        return {place: np.full((g.size, l.size), task.duty.load) for place, task in tasks.items()}
    sense = -1 if (case.shaft.speed_ratio or 1.0) < 0 else 1
    duty = next(iter(found.plain.values())).duty
    at_l, at_g = (np.linspace(x[0], x[-1], min(NODES, x.size)) for x in (l, g))
    at_nodes = np.full((len(found.bearings), at_g.size, at_l.size), np.nan)
    for i, j in np.ndindex(at_g.size, at_l.size):
        seats = {
            name: replace(resized(r.seat, length=float(at_l[j])), clearance=float(at_g[i]), centred=False)
            if name in moved
            else replace(resized(r.seat, length=tasks[name].length), clearance=tasks[name].clearance)
            if name in tasks
            else r.seat
            for name, r in found.plain.items()
        }
        supports: list[Support] = [
            PlainSupport(seats[name], found.plain[name].metal) if name in seats else before
            for name, before in zip(found.bearings, found.supports)
        ]
        try:
            at_nodes[:, i, j] = np.abs(shared(turning, supports, duty, sense).carried.load)
        except (NoSolution, FilmRangeError):
            continue
    across = np.array([[np.interp(l, at_l, row) for row in of_bearing] for of_bearing in at_nodes])
    every = np.array([[np.interp(g, at_g, column) for column in of_bearing.T] for of_bearing in across])
    return {name: every[n].T for n, name in enumerate(found.bearings) if name in tasks}


def _rows(
    case: SelectionCase,
    groups: Sequence[MovedTogether],
    variant: Variant,
    slopes: dict[str, Radian],
    asked: AskedRules,
    order: Order,
    refused: list[Text],
    progress: Progress | None,
) -> Iterator[SharedRow]:
    """The first of all alike at each diameter, and of each alone, by an order."""
    written: list[tuple[tuple[str, Metre, Metre, Metre], ...]] = []
    for n, group in enumerate(groups):
        tell(progress, 0.5 + 0.5 * n / len(groups), group.which)
        settled, picked, why = _settled(case, group, variant, slopes, asked, order)
        if settled is None:
            if why not in refused:
                refused.append(why)
            continue
        sizes = tuple((pick.task.place, pick.diameter, pick.length, pick.clearance) for pick in picked)
        if sizes not in written:
            written.append(sizes)
            yield settled


def _settled(
    case: SelectionCase,
    group: MovedTogether,
    variant: Variant,
    slopes: dict[str, Radian],
    asked: AskedRules,
    order: Order,
) -> tuple[SharedRow | None, tuple[Pick, ...], Text]:
    """The first of a group that the step passes; else why there is none."""
    why, wanted = EMPTY, order(group.wanted())
    for spare in SPARE:
        at = first(group.margin(slopes, asked, spare) >= 0, *wanted)
        if at is None:
            break
        picked = group.picked(at, slopes)
        settled = confirmed(case, CandidateRow("offered", variant, picked), slopes, asked, last=True)
        if settled.row is not None:
            by = _governing(settled.row.picks, asked)
            return SharedRow(group.which, settled.row, _every(case, settled, group), by), picked, EMPTY
        why = settled.why
    if why:
        return None, (), Text("{which}: {why}", which=group.which, why=why)
    return None, (), Text("{which}: {why}", which=group.which, why=_stopped(group, slopes, asked))


def _stopped(group: MovedTogether, slopes: Slopes, asked: AskedRules) -> Text:
    """What stops the candidate that comes nearest."""
    margin = group.margin(slopes, asked)
    if not np.isfinite(margin).any():
        return Text("no film carries what it would have to")
    at = np.unravel_index(int(margin.argmax()), margin.shape)
    near = group.picked(at, slopes)
    parts = dict(limit=against(_governing(near, asked)), size=size(near[0].length, near[0].clearance))
    return Text("{limit} at {size}", **parts)


def _pick(field: CandidateField, at: tuple[np.intp, ...], slope: float) -> Pick:
    """A candidate of a field under the load that it has there."""
    load = float(np.asarray(field.task.duty.load)[at])
    faster = replace(field.task.faster, load=float(np.asarray(field.task.faster.load)[at]))
    task = replace(field.task, duty=replace(field.task.duty, load=load), faster=faster)
    return picks(task, [field.states.length[at]], [field.states.clearance[at]], slope)[0]


def _every(case: SelectionCase, settled: Settled, group: MovedTogether) -> tuple[Pick, ...]:
    """All bearings that are judged, as they run with a row that has passed."""
    assert settled.row is not None and settled.results is not None
    changed = {pick.task.place: pick for pick in settled.row.picks}
    others = {place: field.task for place, field in group.fields.items() if place not in changed}
    now = tasks_of(case, case.seen(settled.results), at_own=others) if others else {}
    return tuple(
        changed[place]
        if place in changed
        else picks(replace(now[place], corners=task.corners), [task.length], [task.clearance], settled.slopes[place])[0]
        for place, task in ((place, field.task) for place, field in group.fields.items())
        if place in changed or place in now
    )


# --- what is shown and said


def choices_table(found: SharedFound, top: int) -> Table:
    """The design as it is, then the first `top` rows."""
    title = Text("Bearings that share the load of their shaft and keep every rule of the search")
    if not found.corners:
        title = Text("No row keeps every rule of the search at every corner: these keep them as given")
    shown = [(Text("now"), found.now)] if found.now is not None else []
    shown += [(Text("{n}", n=found.no(n)), row) for n, row in enumerate(found.rows, 1) if found.no(n) <= top]
    sizes = [(Text("{letter} d×l×g", letter=letter_of(row.name)), "mm, mm, µm") for row in found.case.rows]
    columns = ((tables.NUMBER, ""), (Text("changed"), ""), *sizes, (tables.POWER, "W"), (tables.EDGE, "µm"))
    columns += ((Text("margin"), "%"), (Text("by"), ""))
    cells = tuple(_cells(found, number, row) for number, row in shown)
    note = Text(
        "d diameter, l length, g diametral clearance; a blank stays as it is. P_f: friction power of all the "
        "bearings of the shaft that are judged. h_edge: the thinnest film at the edge. margin: the least of the "
        "bearings that change, under the load that they then carry, and by which rule."
    )
    return Table("bearings", title, columns, cells, note)


def _cells(found: SharedFound, number: Text, row: SharedRow) -> tuple[str | float | None, ...]:
    changed = {pick.task.place: pick for pick in row.row.picks}
    sizes = [_size(changed[bearing.name]) if bearing.name in changed else "" for bearing in found.case.rows]
    film = min(pick.film_edge for pick in row.every)
    numbers = (tables.rounded(row.power, 4), tables.rounded(film * 1e6, 3), tables.rounded(row.by.margin * 100, 3))
    return (number, row.which, *sizes, *numbers, tables.short_name(row.by))


def _size(pick: Pick) -> Text:
    d, l, g = pick.diameter * 1e3, pick.length * 1e3, round(pick.clearance * 1e6, 1)
    return Text("{d}×{l}×{g}", d=Amount(d), l=Amount(l), g=Amount(g))


def summary(found: SharedFound) -> tuple[Text, ...]:
    """What the first row changes."""
    row = found.rows[0].row
    if not (change := tables.changed(row)):
        return (Text("Row {n} is the design as it is: it keeps the rules of the search.", n=found.no(1)),)
    return (Text("Row {n}: {which}: {change}.", n=found.no(1), which=found.rows[0].which, change=change),)


def notes(found: SharedFound) -> tuple[Text, ...]:
    """What was looked at, and what has no row."""
    how = Text(
        "All bearings alike, at each diameter that is looked at, and each alone with the others as they are, the least "
        "friction first. What each carries is found anew for every row by the step itself; oil, supply, "
        "fits and surfaces stay."
    )
    said = [how]
    if found.stays:
        said.append(Text("Diameters stay as they are: {why}.", why=found.stays))
    if found.left_out:
        which = SEMICOLON.join(map(against, found.left_out))
        said.append(Text("Not asked, as the design does not keep them either: {which}.", which=which))
    if found.refused:
        said.append(Text("Without a row: {which}.", which=SEMICOLON.join(found.refused)))
    return tuple(said)
