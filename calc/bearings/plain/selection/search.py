# SPDX-License-Identifier: Apache-2.0
"""The search for bearings itself: inputs and results in, rows to choose from out.

Least is wanted of the friction power of all bearings, rounded to 1 %, of equal ones the smallest bearing, of these the
smallest change.  What is offered first has been through the whole solution once more.

First what fits the room on the shaft; where nothing does, what keeps the limits as given, where a corner of tolerances
that are only assumed is passed; and beside it what is too long for the room."""

from collections.abc import Iterable, Iterator, Sequence

from ....countershaft.checks import JOURNAL_SLOPE
from ....countershaft.outline import CROSSING
from ....countershaft.result import CountershaftResult
from ....countershaft.rows import called
from ....sheet.check import Check
from ....sheet.errors import NoSolution
from ....sheet.progress import Progress, part, rising, tell
from ....sheet.record import record, replace
from ....sheet.text import COMMA, EMPTY, SEMICOLON, Text
from ....sheet.units import Metre, Number, Radian
from ..checks import CLEARANCE_COLD_CORNER, FILM_EDGE_CORNER, TEMPERATURE_CORNER
from ..inputs import SLOPE_TAKEN
from . import ranking
from .grid import CandidateField, fields, same_films
from .ranking import (
    ORDERS,
    CandidateRow,
    Fields,
    Order,
    Pick,
    Slopes,
    best,
    by_change,
    closest,
    places_of_best,
)
from .states import BearingTask, against, check_of, size, without_rise
from .variants import SelectionCase, Solution, Variant, closer_fits, crossings, drawn, placed, tasks, variants
from .writing import with_row

# --- a row put into the design and solved as a whole: whether it holds there, and what else then fails

# of a film, as a share of what it needs, one after the other, where the whole design refuses what has less: over the
# speeds, or with what stands still; rule of this program
SPARE = (0.0, 0.05, 0.1, 0.2, 0.4)
AT_CORNERS = (FILM_EDGE_CORNER, TEMPERATURE_CORNER, CLEARANCE_COLD_CORNER)


@record
class Settled:
    """A row after the whole solution: as it is then judged, with the slopes read there, and what it breaks:
    limits of other steps, and cautions of its own.

    `row` None: it does not pass, and `why`.  `results`: of the whole design with it.  `spare`: what its films had to
    have left.
    """

    row: CandidateRow | None
    slopes: dict[str, Radian]
    broken: tuple[Check, ...] = ()
    why: Text = EMPTY
    results: Solution | None = None
    spare: Number = 0.0


def confirmed(case: SelectionCase, row: CandidateRow, slopes: dict[str, Radian], *, strict: bool = False) -> Settled:
    """A row through the whole solution, as it stands.  `strict`: no caution may be open with it."""
    before = {c.id: c for c in case.results.checks() if c.verdict == "fail" and c.rule is not CROSSING}
    results = case.solve(*with_row(case, row))
    seen = case.seen(results)
    there = seen.outcomes["bearings"]
    again = slopes_of(case, results, slopes)
    picked = tuple(pick.solved(again[pick.task.place]) for pick in row.picks)
    failing = [c for c in there.checks if c.verdict == "fail"]
    if row.corners:
        failing += [c for c in there.checks if c.rule in AT_CORNERS and c.verdict != "fail" and not c.margin >= 0]
    cautions = [c for c in there.checks if c.kind == "caution" and c.open]
    failing += cautions if strict else []
    failing += [pick.governing for pick in picked if pick.margin < 0]
    failing += _steeper(case, seen)
    elsewhere = (c for c in results.checks() if c.verdict == "fail" and not c.id.startswith(case.ids))
    were_open = {c.id for c in case.seen(case.results).outcomes["bearings"].checks if c.kind == "caution" and c.open}
    others = [c for c in elsewhere if c.id not in before] + [c for c in cautions if c.id not in were_open]
    if not any(row.too_long):
        failing += crossings(seen)
    if there.state != "solved" or failing:
        why = against(failing[0]) if failing else there.reason
        return Settled(None, again, (), Text("{row}: {why}", row=row.variant.name, why=why), results)
    return Settled(replace(row, picks=picked), again, tuple(others), results=results)


def _steeper(case: SelectionCase, seen: Solution) -> list[Check]:
    """Slopes beyond what is accepted, and beyond what the design has already."""
    former = {c.id: c for c in case.seen(case.results).outcomes["countershaft"].checks if c.rule is JOURNAL_SLOPE}
    now = (c for c in seen.outcomes["countershaft"].checks if c.rule is JOURNAL_SLOPE and c.margin < 0)
    return [c for c in now if c.id not in former or c.margin < min(former[c.id].margin, 0.0) - 1e-9]


def settle(
    case: SelectionCase,
    variant: Variant,
    fields: Fields,
    slopes: dict[str, Radian],
    order: Order,
    spare: Number = 0.0,
    *,
    strict: bool = False,
) -> Settled | None:
    """The first row of an oil and supply by an order, through the whole solution; where the slopes that are read there
    stop it, or what only the whole knows, it is chosen anew with these, and with films that have more left.  None:
    there is no candidate."""
    what = "nearest" if order is by_change else "offered"
    settled: Settled | None = None
    tried: tuple[Pick, ...] = ()
    for more in (share for share in SPARE if share >= spare):
        for _ in range(2):
            picked = best(_with_spare(fields, more), slopes, order)
            if picked is None:
                return settled
            if _alike(picked, tried):
                break
            tried = picked
            settled = confirmed(case, CandidateRow(what, variant, picked), slopes, strict=strict)
            settled = replace(settled, spare=more)
            steeper = {place: max(slope, settled.slopes[place]) for place, slope in slopes.items()}
            if settled.row is not None or steeper == slopes:
                break
            slopes = steeper
        if settled is not None and settled.row is not None:
            break
    return settled


def _alike(some: tuple[Pick, ...], others: tuple[Pick, ...]) -> bool:
    """Whether bearings are of the same sizes and surfaces."""
    return bool(others) and all(
        (a.diameter, a.length, a.clearance, a.task.level) == (b.diameter, b.length, b.clearance, b.task.level)
        for a, b in zip(some, others)
    )


def _with_spare(fields: Fields, spare: Number) -> Fields:
    return (
        {place: [replace(field, spare=spare) for field in some] for place, some in fields.items()} if spare else fields
    )


def slopes_of(case: SelectionCase, results: Solution | None = None, before: Slopes | None = None) -> dict[str, Radian]:
    """As given, else of the shaft's bending; where its outline is not known any more, as before; taken where it never
    was."""
    shaft = case.seen(results or drawn(case)).result(CountershaftResult)
    bent = shaft.slopes if shaft is not None else {}
    known = before or dict.fromkeys((row.name for row in case.rows), SLOPE_TAKEN)
    return {row.name: row.slope if row.slope is not None else bent.get(row.name, known[row.name]) for row in case.rows}


# --- the search

VERIFIED = 2  # rows that are solved as whole designs before they are shown; the others when they are taken
NEAREST = 3  # that are tried as whole designs, until one holds
WHOLE = 3  # oils and supplies that are looked at with every diameter; the others beside the best of these
BESIDE = 1  # steps of the diameter on either side of it
STIFFER = Text("stiffen the shaft, or widen its envelope")

Tasks = dict[str, list[BearingTask]]
Every = Sequence[tuple[Variant, Fields]]


@record
class BearingsFound:
    """What there is to choose.  `rows`: numbered from 1, in the order of `aim`; they fit the shaft.

    `kind`: "all" they keep every rule; "given" the limits as given, not every corner; "none".  `beyond`: rows that keep
    every rule and are too long for the room, numbered on; then `pareto`.  `now`: the design as it is, None where it has
    no film.  `refused`: variants without a row, with what stops them.  `slopes`: by row number those that solved rows
    were judged with; 0: the others.  `own`: the number of the row with the design's own oil, supply and surfaces; 0:
    there is none.  `elsewhere`: by row number, what then is open and was not before: limits of other steps, cautions
    of the bearings.  `crossing`: what overlaps now.  `placed`: whether the fits of the design have a place.  `solved`:
    results of whole designs by row number, with their shaft in view.

    `named`: what `rows` are called where others stand among them, of which `behind` is the last; 0: there are none,
    and each is called by its number."""

    case: SelectionCase
    aim: str
    kind: str
    now: CandidateRow | None
    rows: tuple[CandidateRow, ...]
    beyond: tuple[CandidateRow, ...]
    pareto: tuple[CandidateRow, ...]
    tasks: Tasks
    variants: tuple[Variant, ...]
    slopes: dict[int, dict[str, Radian]]
    own: int
    refused: tuple[tuple[Variant, Text], ...]
    dropped: tuple[Text, ...]
    elsewhere: dict[int, tuple[Check, ...]]
    crossing: tuple[Check, ...]
    placed: bool
    solved: dict[int, Solution]
    named: tuple[int, ...] = ()
    behind: int = 0

    def no(self, number: int) -> int:
        """What a row is called."""
        if not self.behind:
            return number
        rows = len(self.rows)
        return self.named[number - 1] if number <= rows else self.behind + number - rows

    @property
    def all(self) -> tuple[CandidateRow, ...]:
        return (*self.rows, *self.beyond, *self.pareto)

    @property
    def verified(self) -> tuple[int, ...]:
        """The numbers of the rows that are solved as whole designs."""
        return tuple(number for number in self.slopes if number)

    def slopes_of_row(self, number: int) -> dict[str, Radian]:
        return self.slopes.get(number, self.slopes[0])


def search(case: SelectionCase, aim: str = "loss", progress: Progress | None = None) -> BearingsFound:
    """Rows to choose from for the bearings of a design.  `aim`: "loss", "size", "film".

    Raises NoSolution where nothing keeps all rules, with what comes nearest and what stops it.
    """
    bearings, offered, slopes = _possible(tasks(case)), variants(case), slopes_of(case)
    dropped, every = list[Text](), list[tuple[Variant, Fields]]()
    within, settled = list[tuple[Variant, Fields]](), list[Settled]()
    ways = _ways(case, [*offered, *(_closer(case, offered[0]) if _by_fits(bearings) else ())], bearings)
    ways = [way for way in ways if way[0] != "fits"]
    kind = ""
    for n, (kind, tried, asked) in enumerate(ways):  # noqa: B007
        here = part(progress, n / len(ways), (n + 1) / len(ways))
        tried_fields = _all_fields(case, tried, asked, slopes, ORDERS[aim], here)
        smooth: list[tuple[Variant, Fields]] = [(variant, with_surfaces(some)) for variant, some in tried_fields]
        within = [(variant, in_room(some)) for variant, some in smooth]
        every = every or smooth
        settled = _settled(case, within, slopes, ORDERS[aim], dropped, part(here, 0.6, 1.0))
        if settled:
            break
    else:
        kind, within = "none", every
    rows = [one.row for one in settled if one.row is not None]
    with_rows = {id(row.variant) for row in rows} if kind == "all" else set()
    beyond = _too_long([(variant, some) for variant, some in every if id(variant) not in with_rows], slopes)
    if not rows and not beyond:
        raise _none_whole(dropped) if dropped else nothing(every, slopes)
    general = settled[0].slopes if settled else slopes
    shown = {id(row.variant) for row in (*rows, *beyond)}
    first = offered[0]
    return BearingsFound(
        case,
        aim,
        kind,
        as_is(bearings, first, slopes, corners=kind != "given"),
        tuple(rows),
        tuple(beyond),
        tuple(ranking.pareto(within, general)),
        bearings,
        tuple(offered),
        {0: general} | {n: one.slopes for n, one in enumerate(settled, 1) if one.results is not None},
        next((n for n, row in enumerate(rows, 1) if row.variant is first and not row.level), 0),
        _refused([(variant, some) for variant, some in every if id(variant) not in shown], general),
        tuple(dropped),
        {number: one.broken for number, one in enumerate(settled, 1) if one.broken},
        tuple(crossings(case.seen(case.results))),
        placed(case.bearings) is not None,
        {n: case.seen(one.results) for n, one in enumerate(settled, 1) if one.results is not None},
    )


def best_as_supplied(case: SelectionCase) -> CandidateRow | None:
    """The least friction with the oil and the supply of the design, in the room on its shaft; not solved as a whole.

    None: nothing keeps all rules.  Raises NoSolution where the search knows no bearings like these."""
    bearings, (variant, *_), slopes = _possible(tasks(case)), variants(case), slopes_of(case)
    ((_, every),) = _all_fields(case, [variant], bearings, slopes, ORDERS["loss"], None)
    picked = best(with_surfaces(in_room(every)), slopes, ORDERS["loss"])
    return None if picked is None else CandidateRow("offered", variant, picked)


def _ways(case: SelectionCase, offered: list[Variant], bearings: Tasks) -> list[tuple[str, list[Variant], Tasks]]:
    """What is looked at, until something fits: the fits as they are, closer ones, then the limits as given where the
    fits are only assumed."""
    of_fits = _by_fits(bearings)
    ways = [("all", offered, bearings)]
    if of_fits:
        ways += [("fits", list(_closer(case, *offered)), bearings)]
    return [*ways, ("given", offered, as_given(bearings))] if of_fits and not case.bearings.fits_given else ways


def _by_fits(bearings: Tasks) -> bool:
    """Whether fits open the corners of every bearing, and not limits of its parts."""
    return all(task.field is None for some in bearings.values() for task in some)


def _closer(case: SelectionCase, *offered: Variant) -> Iterator[Variant]:
    """With closer fits."""
    return (replace(variant, fits=fits) for fits in closer_fits(case.bearings) for variant in offered)


def _all_fields(
    case: SelectionCase,
    offered: Sequence[Variant],
    bearings: Tasks,
    slopes: Slopes,
    order: Order,
    progress: Progress | None,
) -> list[tuple[Variant, Fields]]:
    """Of every variant all lengths, too long ones as well.  The first few at every diameter, until one has a bearing
    that fits; the others at those beside it, of another supply at those alone."""
    every: list[tuple[Variant, Fields]] = []
    near: Tasks | None = None  # beside the best
    same: Tasks | None = None  # of the best
    for n, variant in enumerate(offered):
        tell(progress, 0.6 * n / len(offered), variant.name)
        fed = variant.supply != offered[0].supply
        some = fields_of(variant, (same if fed else near) or bearings)
        every.append((variant, some))
        if near is None:
            found = places_of_best(with_surfaces(in_room(some)), slopes, order)
            if found is not None:
                sizes = {place: field.task.size for place, (field, _) in found.items()}
                near, same = _beside(bearings, sizes), _beside(bearings, sizes, 0)
            elif n + 1 == WHOLE and (nearest := closest(some, slopes)) is not None:
                sizes = {pick.task.place: pick.diameter for pick in nearest}
                near, same = _beside(bearings, sizes), _beside(bearings, sizes, 0)
    return every


def _beside(bearings: Tasks, diameters: dict[str, Metre], steps: int = BESIDE) -> Tasks:
    """The tasks of these diameters, and of the next smaller and larger ones."""
    near: Tasks = {}
    for place, some in bearings.items():
        rising_ = sorted(some, key=lambda task: task.size)
        at = next(n for n, task in enumerate(rising_) if task.size == diameters[place])
        near[place] = rising_[max(at - steps, 0) : at + steps + 1]
    return near


def _too_long(every: Every, slopes: Slopes) -> list[CandidateRow]:
    """Of each variant the row that needs the least more room, where it needs any."""
    pairs = [(variant, best(some, slopes, ranking.by_excess)) for variant, some in every]
    rows = [CandidateRow("too long", variant, picked) for variant, picked in pairs if picked]
    return sorted((row for row in rows if any(row.too_long)), key=lambda row: (max(row.too_long), row.power))


def _refused(every: Every, slopes: Slopes) -> tuple[tuple[Variant, Text], ...]:
    """Each variant with what stops it."""
    return tuple((variant, _stopped(closest(some, slopes) if all(some.values()) else None)) for variant, some in every)


def nearest_row(case: SelectionCase, progress: Progress | None = None, only: Sequence[Variant] = ()) -> Settled:
    """The one row that is nearest to the design: its sizes alone before other oils, supplies and surfaces, then closer
    fits.

    `only`: other variants are not looked at, nor closer fits.  Raises NoSolution with what comes nearest and what stops
    it."""
    progress = rising(progress)
    tell(progress, 0.0, Text("bearings"))
    bearings, slopes = _possible(tasks(case)), slopes_of(case)
    near = _beside(bearings, {place: some[0].size for place, some in bearings.items()})
    offered = list(only) or variants(case)
    ways = _ways(case, offered, near)
    dropped, every = list[Text](), list[tuple[Variant, Fields]]()
    for n, (_, tried, asked) in enumerate(ways[:1] if only else ways):
        here = part(progress, n / len(ways), (n + 1) / len(ways))
        short = list[tuple[Variant, Fields]]()
        settled = _nearest(case, _gathered(_short_fields(tried, asked, slopes, here), short), slopes, dropped)
        if settled is not None:
            return settled
        every = every or short
    raise _none_whole(dropped) if dropped else nothing(every, slopes)


def _gathered(
    some: Iterable[tuple[Variant, Fields]], into: list[tuple[Variant, Fields]]
) -> Iterator[tuple[Variant, Fields]]:
    for entry in some:
        into.append(entry)
        yield entry


def _possible(bearings: Tasks) -> Tasks:
    """The same.  Raises NoSolution where the oil enters hotter than it may leave: no film has to be solved to know that
    none passes."""
    for task in (each_task for some in bearings.values() for each_task in some):
        if (coolest := without_rise(task)).margin < 0:
            check = check_of(coolest, ())
            tried = Text("even without any rise: {limit}", limit=against(check))
            raise NoSolution(Text("no bearings keep every rule of the search"), tried, check.advice)
    return bearings


def fields_of(variant: Variant, bearings: Tasks, *, short: bool = False) -> dict[str, list[CandidateField]]:
    """`short`: only lengths in the room.  Bearings that are alike are solved once."""
    found: dict[str, list[CandidateField]] = {}
    for place, some in bearings.items():
        twin = next((other for other in found if same_films(bearings[other], some)), None)
        found[place] = fields(some, variant, short) if twin is None else _of(found[twin], some)
    return found


def _of(twins: list[CandidateField], tasks_here: list[BearingTask]) -> list[CandidateField]:
    """The candidates of a bearing whose films are those of another."""
    by_size = {task.size: task for task in tasks_here}
    return [
        replace(
            twin, task=by_size[twin.task.size].with_oil(twin.variant.lubricant, twin.variant.supply, twin.variant.fits)
        )
        for twin in twins
    ]


def in_room(fields: Fields) -> dict[str, list[CandidateField]]:
    """What fits."""
    return {
        place: [inside for candidates in some if (inside := candidates.in_room()) is not None]
        for place, some in fields.items()
    }


def with_surfaces(fields: Fields) -> dict[str, list[CandidateField]]:
    """With its own surfaces, and with the smoothest."""
    return {
        place: [one for candidates in some for one in _ends(list(candidates.smoother()))]
        for place, some in fields.items()
    }


def _ends(levels: list[CandidateField]) -> list[CandidateField]:
    return levels[:1] if len(levels) == 1 else [levels[0], levels[-1]]


def _smooth_enough(fields: Fields, slopes: Slopes) -> dict[str, list[CandidateField]]:
    """With its own surfaces and ever smoother ones, up to the first that lets some candidate pass."""
    smooth: dict[str, list[CandidateField]] = {place: [] for place in fields}
    for place, some in fields.items():
        for candidates in some:
            for level in candidates.smoother():
                smooth[place].append(level)
                if level.passing(slopes[place]).any():
                    break
    return smooth


def as_given(bearings: Tasks) -> Tasks:
    """The same tasks, judged as they are given and not at the corners of the tolerances."""
    return {place: [replace(task, corners=False) for task in some] for place, some in bearings.items()}


def _short_fields(
    offered: Sequence[Variant], bearings: Tasks, slopes: Slopes, progress: Progress | None = None
) -> Iterator[tuple[Variant, Fields]]:
    """Of every variant what fits, and that alone, one after the other."""
    for n, variant in enumerate(offered):
        tell(progress, 0.8 * n / len(offered), variant.name)
        yield variant, _smooth_enough(in_room(fields_of(variant, bearings, short=True)), slopes)


def _nearest(
    case: SelectionCase, every: Iterable[tuple[Variant, Fields]], slopes: dict[str, Radian], dropped: list[Text]
) -> Settled | None:
    """The nearest row of all variants that holds in the whole design."""
    for n, (variant, some) in enumerate(_by_nearness(case, every, slopes)):
        if n == NEAREST:
            break
        settled = settle(case, variant, some, slopes, by_change)
        assert settled is not None
        if settled.row is not None:
            return settled
        dropped.append(settled.why)
    return None


def _by_nearness(
    case: SelectionCase, every: Iterable[tuple[Variant, Fields]], slopes: Slopes
) -> Iterator[tuple[Variant, Fields]]:
    """Preferred is what changes sizes alone, then oil, then supply, then surfaces; then the smaller change.

    Variants come in this order, so that the next oil or supply is only solved where those before have nothing that
    holds."""
    waiting: list[tuple[tuple[float, ...], int, Variant, Fields]] = []
    bearings, stage = case.bearings, 0
    for n, (variant, some) in enumerate(every):
        fed, oil = variant.supply != bearings.supply, variant.oil != bearings.oil
        if (next_stage := 2 if fed else int(oil)) > stage:
            stage = next_stage
            waiting.sort(key=lambda entry: entry[:2])
            while waiting and waiting[0][0][0] == 0:
                yield waiting.pop(0)[2:]
        if (ranked := ranking.rank(some, slopes, by_change)) is not None:
            waiting.append(((ranked[0], fed, oil, *ranked[1:]), n, variant, some))
    for _, _, variant, some in sorted(waiting, key=lambda entry: entry[:2]):
        yield variant, some


def _settled(
    case: SelectionCase,
    every: Every,
    slopes: dict[str, Radian],
    order: Order,
    dropped: list[Text],
    progress: Progress | None = None,
) -> list[Settled]:
    """The first row of every variant, and of the design's own the first with its own surfaces, by the order; the first
    few solved as whole designs.

    What the whole design asks of the first that holds, slopes and spare film, is asked of all the others too."""
    spare, able = 0.0, list(every)
    while able:  # the design's own oil and supply first
        first = settle(case, *able[0], slopes, order, spare)
        if first is not None and first.row is not None:
            slopes = {place: max(slope, first.slopes[place]) for place, slope in slopes.items()}
            spare = first.spare
            break
        dropped += [first.why] if first is not None else []
        able = able[1:] if first is None or len(dropped) < NEAREST else []
    else:
        return []
    waiting = [(first, able[0][1])]
    for n, (variant, some) in enumerate(able):
        wanted = [some] if n else []
        if variant is every[0][0] and first.row is not None and first.row.level:
            wanted.append({place: [field for field in each if not field.task.level] for place, each in some.items()})
        for one in wanted:
            if (picked := best(_with_spare(one, spare), slopes, order)) is not None:
                waiting.append((Settled(CandidateRow("offered", variant, picked), slopes, spare=spare), one))
    rows: list[Settled] = []
    while waiting and len(rows) < VERIFIED:
        waiting.sort(key=lambda entry: _rank(entry[0], order))
        candidate, some = waiting.pop(0)
        assert candidate.row is not None
        if candidate.results is not None:
            rows.append(candidate)
            continue
        tell(progress, len(rows) / VERIFIED, Text("{row} in the whole design", row=candidate.row.variant.name))
        again = settle(case, candidate.row.variant, some, slopes, order, spare)
        assert again is not None
        if again.row is not None:
            waiting.append((again, some))
        else:
            dropped.append(again.why)
    return [*rows, *sorted((settled for settled, _ in waiting), key=lambda settled: _rank(settled, order))]


def _rank(settled: Settled, order: Order) -> tuple[float, ...]:
    """By the order; of rows that are alike in what is wanted first, those that open nothing."""
    assert settled.row is not None
    foremost, *others = map(float, order(settled.row.wanted))
    return foremost, float(len(settled.broken)), *others


def as_is(bearings: Tasks, variant: Variant, slopes: Slopes, *, corners: bool) -> CandidateRow | None:
    """The design as it stands, judged by the same rules as the rows, at the corners or as given; None where a bearing
    has no film."""
    every: list[Pick] = []
    for place, some in bearings.items():
        task = replace(some[0].with_oil(variant.lubricant, variant.supply), corners=corners)
        every += ranking.picks(task, [task.length], [task.clearance], slopes[place])
    return CandidateRow("now", variant, tuple(every)) if all(pick.power == pick.power for pick in every) else None


# --- why there is nothing


def _stopped(near: tuple[Pick, ...] | None) -> Text:
    if near is None:
        return Text("no length is left between l/d, oil supply and room")
    worse = min(near, key=lambda pick: pick.margin)
    return Text("{limit} at {size}", limit=against(worse.governing), size=size(worse.length, worse.clearance))


def _none_whole(dropped: list[Text]) -> NoSolution:
    return NoSolution(Text("no bearings pass in the whole design"), SEMICOLON.join(dropped[:2]), STIFFER)


def nothing(every: Every, slopes: Slopes) -> NoSolution:
    """What comes nearest over all oils and supplies, and what stops it."""
    nearest = [
        (min(pick.margin for pick in near), variant, near)
        for variant, fields in every
        if (near := closest(fields, slopes)) is not None
    ]
    if not nearest:
        advice = Text("more room for the journals, a narrower oil supply, or a smaller journal")
        return NoSolution(Text("no bearing is left to look at"), _stopped(None), advice)
    _, variant, near = max(nearest, key=lambda row: row[0])
    worse = min(near, key=lambda pick: pick.margin)
    sizes = COMMA.join(
        Text("{place} {size}", place=called(pick.task.place), size=size(pick.length, pick.clearance)) for pick in near
    )
    tried = Text(
        "nearest: {row}, {sizes}, stopped by {limit}", row=variant.name, sizes=sizes, limit=against(worse.governing)
    )
    if worse.corner:
        tried = Text("{tried} (corner: {corner})", tried=tried, corner=worse.corner)
    return NoSolution(Text("no bearings keep every rule of the search"), tried, worse.governing.advice)
