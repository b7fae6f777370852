# SPDX-License-Identifier: Apache-2.0
"""The search for bearings itself: inputs and results in, rows to choose from out.

What is offered first has been through the whole solution once more.

In this order: what fits the room on the shaft by its sizes, by another oil, another supply, smoother surfaces; then by
closer fits; then what keeps the limits as given, where a corner of tolerances that are only assumed is passed; and
beside it what is too long for the room."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import chain

from ...countershaft.outline import CROSSING
from ...countershaft.result import CountershaftResult
from ...countershaft.rows import BearingRow, called
from ...sheet.check import Check
from ...sheet.errors import NoSolution
from ...sheet.progress import Progress, part, rising, tell
from ...sheet.quantity import dotted
from ...sheet.record import record
from ...sheet.remedy import Changes, applied, digits
from ...sheet.text import COMMA, EMPTY, SEMICOLON, Text
from ...sheet.units import Metre, Radian
from ..checks import CLEARANCE_COLD_CORNER, FILM_EDGE_CORNER, TEMPERATURE_CORNER
from ..inputs import SLOPE_TAKEN, BearingsInputs
from . import ranking
from .grid import CandidateField, alike, field
from .ranking import CandidateRow, Fields, Pick, Slopes, best, by_change, by_power, closest
from .states import BearingTask, against, check_of, size, without_rise
from .variants import SelectionCase, Solution, Variant, closer_fits, crossings, drawn, placed, tasks, variants

# --- a row put into the design and solved as a whole: whether it holds there, and what else then fails

TRIES = 3  # of a row whose slopes, read again from the shaft's bending, stop it
AT_CORNERS = (FILM_EDGE_CORNER, TEMPERATURE_CORNER, CLEARANCE_COLD_CORNER)


@record
class Settled:
    """A row after the whole solution: as it is then judged, with the slopes read there, and the limits of other steps
    that it breaks.

    `row` None: it does not pass, and `why`.  `results`: of the whole design with it.
    """

    row: CandidateRow | None
    slopes: dict[str, Radian]
    broken: tuple[Check, ...] = ()
    why: Text = EMPTY
    results: Solution | None = None


def confirmed(case: SelectionCase, row: CandidateRow, slopes: dict[str, Radian]) -> Settled:
    """A row through the whole solution, as it stands."""
    before = {c.id for c in case.results.checks() if c.verdict == "fail" and c.rule is not CROSSING}
    results = case.solve(*with_row(case, row))
    seen = case.seen(results)
    there = seen.outcomes["bearings"]
    again = slopes_of(case, results, slopes)
    picked = tuple(pick.with_slope(again[pick.task.place]) for pick in row.picks)
    failing = [c for c in there.checks if c.verdict == "fail"]
    if row.corners:
        failing += [c for c in there.checks if c.rule in AT_CORNERS and c.verdict != "fail" and not c.margin >= 0]
    failing += [pick.governing for pick in picked if pick.margin < 0]
    elsewhere = (c for c in results.checks() if c.verdict == "fail" and not c.id.startswith(case.ids))
    others = [c for c in elsewhere if c.id not in before]
    if not any(row.too_long):
        failing += crossings(seen)
    if there.state != "solved" or failing:
        why = against(failing[0]) if failing else there.reason
        return Settled(None, again, (), Text("{row}: {why}", row=row.variant.name, why=why), results)
    return Settled(replace(row, picks=picked), again, tuple(others), results=results)


def settle(case: SelectionCase, row: CandidateRow, fields: Fields, slopes: dict[str, Radian]) -> Settled:
    """A row through the whole solution; where the slopes that are read there stop it, it is chosen anew with them."""
    order = by_change if row.what == "nearest" else by_power
    settled = confirmed(case, row, slopes)
    for _ in range(TRIES):
        if settled.row is not None:
            break
        steeper = {place: max(slope, settled.slopes[place]) for place, slope in slopes.items()}
        picked = best(fields, steeper, order) if steeper != slopes else None
        if picked is None:
            break
        slopes = steeper
        settled = confirmed(case, replace(row, picks=picked), slopes)
    return settled


def slopes_of(case: SelectionCase, results: Solution | None = None, before: Slopes | None = None) -> dict[str, Radian]:
    """As given, else of the shaft's bending; where its outline is not known any more, as before; taken where it never
    was."""
    shaft = case.seen(results or drawn(case)).result(CountershaftResult)
    bent = shaft.slopes if shaft is not None else {}
    known = before or dict.fromkeys((row.name for row in case.rows), SLOPE_TAKEN)
    return {row.name: row.slope if row.slope is not None else bent.get(row.name, known[row.name]) for row in case.rows}


def with_row(case: SelectionCase, row: CandidateRow) -> tuple[BearingsInputs, tuple[BearingRow, ...]]:
    """The design's bearings as a row has them: as they then stand in the file."""
    shared, own = _changes(row, case.bearings)
    return applied(case.bearings, shared), tuple(applied(there, own.get(there.name, {})) for there in case.rows)


def bearing_changes(row: CandidateRow, case: SelectionCase) -> Changes:
    """The keys that put a row into a design; a clearance that stays keeps its key."""
    shared, own = _changes(row, case.bearings)
    written = {f"{case.place}.{name}.{key}": value for name, some in own.items() for key, value in some.items()}
    return written | {dotted("bearings", key): value for key, value in shared.items()}


def _changes(row: CandidateRow, bearings: BearingsInputs) -> tuple[Changes, dict[str, Changes]]:
    """Of what all bearings share, and of each by its name; without the tables that they stand in."""
    own: dict[str, Changes] = {}
    fits = fits_to_write(row, bearings)
    for pick in row.picks:
        b, here = pick.task.seat.bearing, dict[object, float | None]()
        if pick.diameter != pick.task.diameter:
            here[BearingRow.diameter] = digits(pick.diameter / 1e-3)
        if pick.length != pick.task.length:
            here[BearingRow.length] = digits(pick.length / 1e-3)
        if _moved(pick) or fits is not None:  # factor K or fits would make another clearance of a new diameter or fit
            here |= {BearingRow.clearance_factor: None, BearingRow.clearance: digits(pick.clearance / 1e-6)}
        if pick.task.level:
            here[BearingRow.journal_roughness] = digits(b.journal_roughness / 1e-6)
            here[BearingRow.housing_roughness] = digits(b.housing_roughness / 1e-6)
        own[pick.task.place] = {dotted(field): value for field, value in here.items()}
    whole = dict[object, str]()
    if fits is not None:
        whole |= {BearingsInputs.journal_fit: fits[0], BearingsInputs.seat_fit: fits[1]}
    if row.variant.oil != bearings.oil:
        whole[BearingsInputs.oil] = row.variant.oil
    if row.variant.supply != bearings.supply:
        whole[BearingsInputs.supply] = row.variant.supply
    return {dotted(field): value for field, value in whole.items()}, own


def fits_to_write(row: CandidateRow, bearings: BearingsInputs) -> tuple[str, str] | None:
    """Closer fits; or widths for fits with a place, which would make another clearance than the row's.  None: they
    stay."""
    return row.variant.fits or (placed(bearings) if any(map(_moved, row.picks)) else None)


def _moved(pick: Pick) -> bool:
    return pick.clearance != pick.task.clearance or pick.diameter != pick.task.diameter


# --- the search

VERIFIED = 4  # rows that are solved as whole designs before they are shown; the others when they are taken
NEAREST = 3  # that are tried as whole designs, until one holds
STIFFER = Text("stiffen the shaft, or widen its envelope")

Tasks = dict[str, list[BearingTask]]
Every = Sequence[tuple[Variant, Fields]]
Thin = dict[tuple[str, str, float], float]  # by supply, place and diameter: viscosity of oils whose film passes nowhere


@record
class BearingsFound:
    """What there is to choose.  `rows`: numbered from 1, the nearest first, then the least power by oil and supply;
    they fit the shaft.

    `kind`: "all" they keep every rule; "fits" the same with closer fits; "given" the limits as given, not every corner;
    "none". `beyond`: rows that keep every rule and are too long for the room, numbered on; then `pareto`. `now`: the
    design as it is, None where it has no film.  `refused`: variants without a row, with what stops them. `slopes`:
    those of the design, then those that the solved rows were judged with. `elsewhere`: by row number, limits of other
    steps that fail with it and did not before.  `crossing`: what overlaps now. `placed`: whether the fits of the design
    have a place."""

    case: SelectionCase
    kind: str
    now: CandidateRow | None
    rows: tuple[CandidateRow, ...]
    beyond: tuple[CandidateRow, ...]
    pareto: tuple[CandidateRow, ...]
    tasks: Tasks
    variants: tuple[Variant, ...]
    slopes: tuple[dict[str, Radian], ...]
    refused: tuple[tuple[Variant, Text], ...]
    dropped: tuple[Text, ...]
    elsewhere: dict[int, tuple[Check, ...]]
    crossing: tuple[Check, ...]
    placed: bool
    verified: int

    @property
    def all(self) -> tuple[CandidateRow, ...]:
        return (*self.rows, *self.beyond, *self.pareto)

    def slopes_of_row(self, number: int) -> dict[str, Radian]:
        return self.slopes[number if number <= self.verified else 0]


def search(case: SelectionCase, progress: Progress | None = None) -> BearingsFound:
    """Rows to choose from for the bearings of a design.

    Raises NoSolution where nothing keeps all rules, with what comes nearest and what stops it.
    """
    bearings, offered, slopes = _possible(tasks(case)), variants(case), slopes_of(case)
    too_thin: Thin = {}
    every = _all_fields(offered, bearings, slopes, too_thin, progress)
    dropped: list[Text] = []
    kind, within, rows = _fitting(case, every, offered, bearings, slopes, dropped, progress)
    fitting = [settled.row for settled in rows if settled.row is not None]
    fitting_ids = {id(row.variant) for row in fitting} if kind == "all" else set()
    beyond = _too_long([(variant, fields) for variant, fields in every if id(variant) not in fitting_ids], slopes)
    if not fitting and not beyond:
        raise _none_whole(dropped) if dropped else nothing(every, slopes)
    shown = {id(row.variant) for row in (*fitting, *beyond)}
    verified = min(len(rows), VERIFIED)
    now = as_is(bearings, offered[0], slopes, corners=kind != "given")
    return BearingsFound(
        case,
        kind,
        now,
        tuple(fitting),
        tuple(beyond),
        tuple(ranking.pareto(within, slopes)),
        bearings,
        tuple(offered),
        (slopes, *(settled.slopes for settled in rows[:verified])),
        _refused([(variant, fields) for variant, fields in every if id(variant) not in shown], slopes, too_thin),
        tuple(dropped),
        {number: settled.broken for number, settled in enumerate(rows, 1) if settled.broken},
        tuple(crossings(case.seen(case.results))),
        placed(case.bearings) is not None,
        verified,
    )


def _all_fields(
    offered: Sequence[Variant], bearings: Tasks, slopes: Slopes, too_thin: Thin, progress: Progress | None
) -> list[tuple[Variant, Fields]]:
    """Of every variant all lengths, too long ones as well; with another supply only the diameters that are best with
    the design's."""
    every: list[tuple[Variant, Fields]] = []
    of_oil: dict[str, dict[str, Metre]] = {}
    for n, variant in enumerate(offered):
        tell(progress, 0.5 * n / len(offered), variant.name)
        fields = fields_of(variant, _promising(bearings, of_oil.get(variant.oil)), slopes, too_thin=too_thin)
        every.append((variant, fields))
        if variant.supply == offered[0].supply and (diameters := ranking.best_diameters(fields, slopes)) is not None:
            of_oil[variant.oil] = diameters
    return every


def _fitting(
    case: SelectionCase,
    every: Every,
    offered: list[Variant],
    bearings: Tasks,
    slopes: dict[str, Radian],
    dropped: list[Text],
    progress: Progress | None,
) -> tuple[str, Every, list[Settled]]:
    """The rows that fit the shaft, after their kind and the fields that they are taken from: of the first kind that has
    any; "none" after all the fields where none has."""
    within = [(variant, in_room(fields, slopes)) for variant, fields in every]
    if rows := _settled(case, within, slopes, dropped, part(progress, 0.5, 0.6)):
        return "all", within, rows
    carried = all(
        any(candidates.carries(slopes[place]) for _, fields in every for candidates in fields[place])
        for place in bearings
    )
    ways = _further(case, offered, bearings, slopes) if carried else []
    for n, (kind, tried, asked) in enumerate(ways):
        here = part(progress, 0.6 + 0.4 * n / len(ways), 0.6 + 0.4 * (n + 1) / len(ways))
        inside = list(short_fields(tried, asked, slopes, part(here, 0.0, 0.5)))
        if rows := _settled(case, inside, slopes, dropped, part(here, 0.5, 1.0)):
            return kind, inside, rows
    return "none", every, []


def _too_long(every: Every, slopes: Slopes) -> list[CandidateRow]:
    """Of each variant the row that needs the least more room, where it needs any."""
    pairs = [(variant, best(fields, slopes, ranking.by_excess)) for variant, fields in every]
    rows = [CandidateRow("too long", variant, picked) for variant, picked in pairs if picked]
    return sorted((row for row in rows if any(row.too_long)), key=lambda row: (max(row.too_long), row.power))


def _refused(every: Every, slopes: Slopes, too_thin: Thin) -> tuple[tuple[Variant, Text], ...]:
    """Each variant with what stops it, or why it was not even looked at."""
    return tuple(
        (variant, _stopped(closest(fields, slopes)) if all(fields.values()) else _left_out(variant, too_thin))
        for variant, fields in every
    )


def nearest_row(case: SelectionCase, progress: Progress | None = None, only: Sequence[Variant] = ()) -> Settled:
    """The one row that is nearest to the design, found as `search` finds its first, without all the others beside it.

    `only`: other variants are not looked at, nor closer fits.  Raises NoSolution with what comes nearest and what stops
    it."""
    progress = rising(progress)
    tell(progress, 0.0, Text("bearings"))
    bearings, slopes = _possible(tasks(case)), slopes_of(case)
    offered = list(only) or variants(case)
    fields = short_fields(offered, bearings, slopes, part(progress, 0.0, 0.3))
    first = next(fields)
    nearest = _nearest(case, [first], slopes, [])
    if nearest is not None and nearest.row is not None and nearest.row.level == 0:
        return nearest  # sizes alone: no other oil or supply goes before
    ways: list[Iterable[tuple[Variant, Fields]]] = [chain([first], fields)]
    if not only:
        further = _further(case, offered, bearings, slopes)
        ways = [] if not any(kind == "fits" for kind, *_ in further) and closer_fits(case.bearings) else ways
        shares = [0.3 + 0.7 * n / max(len(further), 1) for n in range(len(further) + 1)]
        ways += [
            short_fields(some, asked, slopes, part(progress, *ends))
            for (_, some, asked), *ends in zip(further, shares, shares[1:])
        ]
    dropped: list[Text] = []
    for way in ways:
        if (settled := _nearest(case, way, slopes, dropped)) is not None:
            return settled
    raise _none_whole(dropped) if dropped else nothing([first, *fields], slopes)


def _further(
    case: SelectionCase, offered: list[Variant], bearings: Tasks, slopes: Slopes
) -> list[tuple[str, list[Variant], Tasks]]:
    """What is looked at where nothing fits as the fits are: closer ones, then the limits as given where the fits are
    only assumed.

    The closest fits allow all that wider ones do: where no oil has a film that passes with these, no closer ones are
    looked at."""
    ways = [
        ("fits", [replace(variant, fits=fits) for variant in offered], bearings) for fits in closer_fits(case.bearings)
    ]
    if ways:
        thick = sorted(ways[-1][1], key=lambda variant: -variant.lubricant.at(case.bearings.supply_temperature).mu)
        if not any(_may_pass(fields, slopes) for _, fields in short_fields(thick, bearings, slopes)):
            ways = []
    return ways if case.bearings.fits_given else [*ways, ("given", offered, as_given(bearings))]


def _may_pass(fields: Fields, slopes: Slopes) -> bool:
    return all(any(candidates.holds(slopes[place]) for candidates in some) for place, some in fields.items())


def _possible(bearings: Tasks) -> Tasks:
    """The same.  Raises NoSolution where the oil enters hotter than it may leave: no film has to be solved to know that
    none passes."""
    for task in (each_task for some in bearings.values() for each_task in some):
        if (coolest := without_rise(task)).margin < 0:
            check = check_of(coolest, ())
            tried = Text("even without any rise: {limit}", limit=against(check))
            raise NoSolution(Text("no bearings keep every rule of the search"), tried, check.advice)
    return bearings


def fields_of(
    variant: Variant, bearings: Tasks, slopes: Slopes, *, too_thin: Thin | None = None, short: bool = False
) -> dict[str, list[CandidateField]]:
    """`too_thin` gathers oils whose film passes nowhere; a thinner one is not looked at any more.

    `short`: only lengths in the room, and no further bearing where one before has no film that passes.
    """
    known = too_thin if too_thin is not None else {}
    fields: dict[str, list[CandidateField]] = {place: [] for place in bearings}
    for place, tasks_there in bearings.items():
        held = False
        for task in tasks_there:
            key = (variant.supply, place, task.seat.bearing.diameter)
            mu = variant.lubricant.at(task.duty.supply_temperature).mu
            if mu < known.get(key, 0.0):
                continue
            same = (
                known_field
                for other, some in fields.items()
                for known_field in some
                if other != place and slopes[other] == slopes[place] and alike(known_field.task, task)
            )
            twin = next(same, None)
            candidates = twin.of(task) if twin is not None else field(task, variant, slopes[place], short)
            if candidates is None:
                continue
            fields[place].append(candidates)
            if candidates.holds(slopes[place]):
                held = True
            elif not candidates.hot(slopes[place]):
                known[key] = max(mu, known.get(key, 0.0))
        if short and not held:
            break
    return fields


def _promising(bearings: Tasks, diameters: dict[str, Metre] | None) -> Tasks:
    """Of all diameters the design's own and, where it is known, the one that needs least power with the design's
    supply."""
    if diameters is None:
        return bearings
    return {
        place: [t for n, t in enumerate(some) if n == 0 or t.seat.bearing.diameter == diameters[place]]
        for place, some in bearings.items()
    }


def in_room(fields: Fields, slopes: Slopes) -> dict[str, list[CandidateField]]:
    """What fits, with its own surfaces, and where these are too rough with ever smoother ones until some candidate
    passes."""
    inside: dict[str, list[CandidateField]] = {place: [] for place in fields}
    for place, found in fields.items():
        for candidates in (some for outside in found if (some := outside.in_room()) is not None):
            holds = candidates.holds(slopes[place])
            inside[place] += _smooth_enough(candidates, slopes[place]) if holds else [candidates]
    return inside


def _smooth_enough(candidates: CandidateField, slope: Radian) -> list[CandidateField]:
    """With its own surfaces and smoother ones, up to the first that lets some candidate pass; its own alone where none
    does."""
    levels = list[CandidateField]()
    for level in candidates.smoother():
        levels.append(level)
        if level.passing(slope).any():
            return levels
    return levels[:1]


def as_given(bearings: Tasks) -> Tasks:
    """The same tasks, judged as they are given and not at the corners of the tolerances."""
    return {place: [replace(task, corners=False) for task in some] for place, some in bearings.items()}


def short_fields(
    offered: Sequence[Variant], bearings: Tasks, slopes: Slopes, progress: Progress | None = None
) -> Iterator[tuple[Variant, Fields]]:
    """Of every variant what fits, and that alone, one after the other."""
    thin: Thin = {}
    for n, variant in enumerate(offered):
        tell(progress, 0.8 * n / len(offered), variant.name)
        yield variant, in_room(fields_of(variant, bearings, slopes, too_thin=thin, short=True), slopes)


def _nearest(
    case: SelectionCase,
    every: Iterable[tuple[Variant, Fields]],
    slopes: dict[str, Radian],
    dropped: list[Text],
    progress: Progress | None = None,
) -> Settled | None:
    """The nearest row of all variants that holds in the whole design."""
    for n, (variant, fields) in enumerate(_by_nearness(case, every, slopes)):
        if n == NEAREST:
            break
        tell(progress, n / NEAREST, Text("{row} in the whole design", row=variant.name))
        picked = best(fields, slopes, by_change)
        assert picked is not None
        settled = settle(case, CandidateRow("nearest", variant, picked), fields, slopes)
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
    for n, (variant, fields) in enumerate(every):
        fed, oil = variant.supply != bearings.supply, variant.oil != bearings.oil
        if (next_stage := 2 if fed else int(oil)) > stage:
            stage = next_stage
            waiting.sort(key=lambda entry: entry[:2])
            while waiting and waiting[0][0][0] == 0:
                yield waiting.pop(0)[2:]
        if (ranked := ranking.rank(fields, slopes, by_change)) is not None:
            waiting.append(((ranked[0], fed, oil, *ranked[1:]), n, variant, fields))
    for _, _, variant, fields in sorted(waiting, key=lambda entry: entry[:2]):
        yield variant, fields


def _settled(
    case: SelectionCase, every: Every, slopes: dict[str, Radian], dropped: list[Text], progress: Progress | None = None
) -> list[Settled]:
    """Rows of every variant that has candidates: the nearest, then by power; the first few solved as whole designs."""
    by_variant = {id(variant): fields for variant, fields in every}
    least = [
        CandidateRow("least power", variant, picked)
        for variant, fields in every
        if (picked := best(fields, slopes, by_power)) is not None
    ]
    nearest = _nearest(case, every, slopes, dropped, part(progress, 0.0, 0.3))
    rows = [] if nearest is None else [nearest]
    waiting = [Settled(row, slopes) for row in least]
    done: list[Settled] = []
    while waiting and len(rows) < VERIFIED:
        waiting.sort(key=_rank)
        candidate = waiting.pop(0)
        assert candidate.row is not None
        if candidate in done:  # still the least after its slopes were read again
            rows.append(candidate)
            continue
        doing = Text("{row} in the whole design", row=candidate.row.variant.name)
        tell(progress, 0.3 + 0.7 * len(done) / VERIFIED, doing)
        settled = settle(case, candidate.row, by_variant[id(candidate.row.variant)], slopes)
        if settled.row is None:
            dropped.append(settled.why)
        else:
            done.append(settled)
            waiting.append(settled)
    return [*rows, *sorted(waiting, key=_rank)] if rows else []


def _rank(settled: Settled) -> tuple[int, float, float]:
    """Smoother surfaces are the dearer ones; then power."""
    assert settled.row is not None
    return settled.row.level, settled.row.power, settled.row.change


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
        return Text(
            "no length is left between l/d, oil supply and room, or no clearance between the cold one and the usual "
            "factor K"
        )
    worse = min(near, key=lambda pick: pick.margin)
    return Text("{limit} at {size}", limit=against(worse.governing), size=size(worse.length, worse.clearance))


def _left_out(variant: Variant, too_thin: Thin) -> Text:
    """Why a variant was not even looked at."""
    if any(supply == variant.supply for supply, _, _ in too_thin):
        return Text("a thicker oil has too thin a film already")
    return _stopped(None)


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
