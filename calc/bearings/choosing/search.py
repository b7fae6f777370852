# SPDX-License-Identifier: Apache-2.0
"""The search itself: inputs and results in, rows to choose from out.  What is offered first has been through the whole solution once more.

In this order: what fits the room on the shaft by its sizes, by another oil, another supply, smoother surfaces; then by closer fits; then
what keeps the limits as given, where a corner of tolerances that are only assumed is passed; and beside it what is too long for the room.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import islice

from ...sheet.check import Check
from ...sheet.errors import NoSolution
from ...sheet.number import short
from ...sheet.progress import Progress, part, tell
from ...sheet.record import record
from ...sheet.units import Metre, Radian
from .case import Case
from .grid import Field, alike, field, passing
from .ranking import (
    Fields,
    Pick,
    Row,
    Slopes,
    best_diameters,
    closest,
    least_power,
    nearest,
    pareto,
    picks,
    rank_of_nearest,
    shortest,
)
from .room import short_mm
from .settling import Settled, said, settle, slopes_of
from .states import Task
from .variants import PLACES, Variant, closer_fits, crossings, placed, tasks, tied, variants

VERIFIED = 4  # rows that are solved as whole designs before they are shown; the others when they are taken
NEAREST = 3  # that are tried as whole designs, until one holds

Every = Sequence[tuple[Variant, Fields]]
Thin = dict[tuple[str, str, float], float]  # by supply, place and diameter: viscosity of oils whose film passes nowhere


@record
class Found:
    """What there is to choose.  `rows`: numbered from 1, the nearest first, then the least power by oil and supply; they fit the shaft.

    `kind`: "all" they keep every rule; "fits" the same with closer fits; "given" the limits as given, not every corner; "none".
    `beyond`: rows that keep every rule and are too long for the room, numbered on; then `pareto`.
    `now`: the design as it is, None where it has no film.  `refused`: variants without a row, with what stops them.
    `slopes`: those of the design, then those that the solved rows were judged with.  `diameters`: what is done about them, in words.
    `elsewhere`: by row number, limits of other steps that fail with it and did not before.  `crossing`: what overlaps now.
    `placed`: whether the fits of the design have a place.
    """

    kind: str
    now: Row | None
    rows: tuple[Row, ...]
    beyond: tuple[Row, ...]
    pareto: tuple[Row, ...]
    tasks: dict[str, list[Task]]
    variants: tuple[Variant, ...]
    slopes: tuple[dict[str, Radian], ...]
    diameters: tuple[str, ...]
    refused: tuple[tuple[Variant, str], ...]
    dropped: tuple[str, ...]
    elsewhere: dict[int, tuple[Check, ...]]
    crossing: tuple[Check, ...]
    placed: bool
    verified: int

    @property
    def all(self) -> tuple[Row, ...]:
        return (*self.rows, *self.beyond, *self.pareto)

    def slopes_of_row(self, number: int) -> dict[str, Radian]:
        return self.slopes[number if number <= self.verified else 0]


def search(case: Case, progress: Progress | None = None) -> Found:
    """Rows to choose from for the bearings of a design.

    Raises NoSolution where nothing keeps all rules, with what comes nearest and what stops it.
    """
    bearings, offered, slopes = tasks(case), variants(case), slopes_of(case)
    too_thin: Thin = {}
    every: list[tuple[Variant, Fields]] = []
    of_oil: dict[str, dict[str, Metre]] = {}
    for n, variant in enumerate(offered):
        tell(progress, 0.5 * n / len(offered), str(variant))
        there = fields_of(variant, _promising(bearings, of_oil.get(variant.oil)), slopes, too_thin=too_thin)
        every.append((variant, there))
        if variant.supply == offered[0].supply and (best := best_diameters(there, slopes)) is not None:
            of_oil[variant.oil] = best
    dropped: list[str] = []
    of: Every = []
    kind, of = "all", [(variant, in_room(fields, slopes)) for variant, fields in every]
    rows = _settled(case, of, slopes, dropped, part(progress, 0.5, 0.6))
    able = all(any(one.carries(slopes[place]) for _, fields in every for one in fields[place]) for place in PLACES)
    fits = closer_fits(case.bearings) if able and not rows else []
    for n, closer in enumerate(fits):
        here = part(progress, 0.6 + 0.2 * n / len(fits), 0.6 + 0.2 * (n + 1) / len(fits))
        kind, of = "fits", short_fields([replace(one, fits=closer) for one in offered], bearings, slopes, part(here, 0.0, 0.5))
        rows = _settled(case, of, slopes, dropped, part(here, 0.5, 1.0))
        if rows:
            break
    if able and not rows and not case.bearings.fits_given:
        kind, of = "given", short_fields(offered, as_given(bearings), slopes, part(progress, 0.8, 0.9))
        rows = _settled(case, of, slopes, dropped, part(progress, 0.9, 1.0))
    found = [one.row for one in rows if one.row is not None]
    own = {id(row.variant) for row in found} if kind == "all" else set()
    pairs = ((variant, shortest(fields, slopes)) for variant, fields in every if id(variant) not in own)
    beyond = [row for variant, pair in pairs if pair for row in (Row("too long", variant, *pair),) if any(row.too_long)]
    beyond.sort(key=lambda row: (max(row.too_long), row.power))
    if not found and not beyond:
        if dropped:
            raise NoSolution("no bearings pass in the whole design", "; ".join(dropped[:2]), "stiffen the shaft, or widen its envelope")
        raise nothing(every, slopes)
    shown = {id(row.variant) for row in (*found, *beyond)}
    refused = [
        (v, _stopped(closest(fields, slopes)) if all(fields.values()) else _left_out(v, too_thin))
        for v, fields in every if id(v) not in shown
    ]  # fmt: skip
    verified = min(len(rows), VERIFIED)
    return Found(
        kind if found else "none", as_is(bearings, offered[0], slopes), tuple(found), tuple(beyond),
        tuple(pareto(of if found else every, slopes)), bearings, tuple(offered), (slopes, *(one.slopes for one in rows[:verified])),
        _diameters(case, bearings, found), tuple(refused), tuple(dropped),
        {number: one.broken for number, one in enumerate(rows, 1) if one.broken}, tuple(crossings(case.results)),
        placed(case.bearings) is not None, verified,
    )  # fmt: skip


def nearest_passing(case: Case) -> Row | None:
    """The smallest change that fits and keeps every rule with the design's oil, supply and fits; None: there is none."""
    variant, slopes = variants(case)[0], slopes_of(case)
    fields = in_room(fields_of(variant, tasks(case), slopes, short=True), slopes)
    pair = nearest(fields, slopes)
    return None if pair is None else settle(case, Row("nearest", variant, *pair), fields, slopes).row


def fields_of(
    variant: Variant, bearings: dict[str, list[Task]], slopes: Slopes, *, too_thin: Thin | None = None, short: bool = False
) -> dict[str, list[Field]]:
    """`too_thin` gathers oils whose film passes nowhere; a thinner one is not looked at any more.

    `short`: only lengths in the room, and no rear bearing where no front one has a film that passes.
    """
    known = too_thin if too_thin is not None else {}
    found: dict[str, list[Field]] = {place: [] for place in PLACES}
    for place in PLACES:
        held = False
        for task in bearings[place]:
            key, mu = (variant.supply, place, task.seat.bearing.diameter), variant.lubricant.at(task.duty.supply_temperature).mu
            if mu < known.get(key, 0.0):
                continue
            twin = next(
                (one for one in found["front"] if place == "rear" and alike(one.task, task) and slopes["front"] == slopes["rear"]), None
            )
            made = twin.of(task) if twin is not None else field(task, variant, slopes[place], short)
            if made is None:
                continue
            found[place].append(made)
            if made.holds(slopes[place]).any():
                held = True
            elif not made.hot(slopes[place]):
                known[key] = max(mu, known.get(key, 0.0))
        if short and not held:
            break
    return found


def _promising(bearings: dict[str, list[Task]], best: dict[str, Metre] | None) -> dict[str, list[Task]]:
    """Of all diameters the design's own and, where it is known, the one that needs least power with the design's supply."""
    if best is None:
        return bearings
    return {place: [t for n, t in enumerate(some) if n == 0 or t.seat.bearing.diameter == best[place]] for place, some in bearings.items()}


def in_room(fields: Fields, slopes: Slopes) -> dict[str, list[Field]]:
    """What fits, with its own surfaces, and where these are too rough with ever smoother ones until some candidate passes."""
    found: dict[str, list[Field]] = {place: [] for place in PLACES}
    for place in PLACES:
        for one in (inside for outside in fields[place] if (inside := outside.in_room()) is not None):
            levels = one.smoother() if one.holds(slopes[place]).any() else [one]
            first = next((n for n, level in enumerate(levels, 1) if passing(level.judged(slopes[place])).any()), 1)
            found[place] += islice(levels, first)
    return found


def as_given(bearings: dict[str, list[Task]]) -> dict[str, list[Task]]:
    """The same tasks, judged as they are given and not at the corners of the tolerances."""
    return {place: [replace(task, corners=False) for task in some] for place, some in bearings.items()}


def short_fields(
    offered: Sequence[Variant], bearings: dict[str, list[Task]], slopes: Slopes, progress: Progress | None = None
) -> Every:  # fmt: skip
    """Of every variant what fits, and that alone."""
    thin: Thin = {}
    found: list[tuple[Variant, Fields]] = []
    for n, variant in enumerate(offered):
        tell(progress, n / len(offered), str(variant))
        found.append((variant, in_room(fields_of(variant, bearings, slopes, too_thin=thin, short=True), slopes)))
    return found


def nearest_settled(case: Case, every: Every, slopes: dict[str, Radian], dropped: list[str]) -> Settled | None:
    """The nearest row of all variants that holds in the whole design.

    Preferred is what changes sizes alone, then oil, then supply, then surfaces.
    """
    near = []
    for variant, fields in every:
        rank = rank_of_nearest(fields, slopes)
        if rank is not None:
            level, change, power = rank
            near.append((level, variant.supply != case.bearings.supply, variant.oil != case.bearings.oil, change, power, variant, fields))
    for *_, variant, fields in sorted(near, key=lambda one: one[:5])[:NEAREST]:
        pair = nearest(fields, slopes)
        assert pair is not None
        settled = settle(case, Row("nearest", variant, *pair), fields, slopes)
        if settled.row is not None:
            return settled
        dropped.append(settled.why)
    return None


def _settled(
    case: Case, every: Every, slopes: dict[str, Radian], dropped: list[str], progress: Progress | None = None
) -> list[Settled]:  # fmt: skip
    """Rows of every variant that has candidates: the nearest, then by power; the first few solved as whole designs."""
    by_variant = {id(variant): fields for variant, fields in every}
    best = [Row("least power", variant, *pair) for variant, fields in every if (pair := least_power(fields, slopes)) is not None]
    tell(progress, 0.0, "the nearest row in the whole design")
    first = nearest_settled(case, every, slopes, dropped)
    rows = [] if first is None else [first]
    waiting = [Settled(row, slopes) for row in best]
    done: list[Settled] = []
    while waiting and len(rows) < VERIFIED:
        waiting.sort(key=_rank)
        one = waiting.pop(0)
        assert one.row is not None
        if one in done:  # still the least after its slopes were read again
            rows.append(one)
            continue
        tell(progress, len(done) / VERIFIED, f"{one.row.variant} in the whole design")
        settled = settle(case, one.row, by_variant[id(one.row.variant)], slopes)
        if settled.row is None:
            dropped.append(settled.why)
        else:
            done.append(settled)
            waiting.append(settled)
    return [*rows, *sorted(waiting, key=_rank)] if rows else []


def _rank(one: Settled) -> tuple[int, float, float]:
    """Smoother surfaces are the dearer ones; then power."""
    assert one.row is not None
    return one.row.level, one.row.power, one.row.change


def _diameters(case: Case, bearings: dict[str, list[Task]], rows: Sequence[Row]) -> tuple[str, ...]:
    """What ties them, or which were looked at, and where the best row stands at their end."""
    words = []
    for n, place in enumerate(PLACES):
        if len(bearings[place]) == 1:
            words.append(f"The {place} diameter stays as it is: {tied(case, case.results, place) or 'no other has an answer'}.")
            continue
        looked = sorted(task.seat.bearing.diameter for task in bearings[place])
        said = f"The {place} diameter is free: {', '.join(short_mm(d) for d in looked)} mm are looked at, nothing between."
        ends = {row.both[n].diameter for row in rows[:2]} & {looked[0], looked[-1]}
        if ends:
            said += f" {short_mm(ends.pop())} mm, in the first rows, is the end of it: beyond may be better."
        words.append(said)
    return tuple(words)


def as_is(bearings: dict[str, list[Task]], variant: Variant, slopes: Slopes) -> Row | None:
    """The design as it stands, judged by the same rules; None where a bearing has no film."""
    both = []
    for place in PLACES:
        task = bearings[place][0].with_oil(variant.lubricant, variant.supply)
        both += picks(task, [task.length], [task.clearance], slopes[place])
    return Row("now", variant, *both) if all(one.power == one.power for one in both) else None


def _stopped(both: tuple[Pick, Pick] | None) -> str:
    if both is None:
        return "no length is left between l/d, oil supply and room, or no clearance between the cold one and the usual factor K"
    worse = min(both, key=lambda one: one.margin)
    return f"{said(worse.governing)} at {short(worse.length * 1e3)} mm and {short(worse.clearance * 1e6)} µm"


def _left_out(variant: Variant, too_thin: Thin) -> str:
    """Why a variant was not even looked at."""
    if any(supply == variant.supply for supply, _, _ in too_thin):
        return "a thicker oil has too thin a film already"
    return _stopped(None)


def nothing(every: Every, slopes: Slopes) -> NoSolution:
    """What comes nearest over all oils and supplies, and what stops it."""
    best = [(min(one.margin for one in both), variant, both) for variant, fields in every if (both := closest(fields, slopes)) is not None]
    if not best:
        return NoSolution(
            "no bearing is left to look at",
            _stopped(None),
            "more room for the journals, a narrower oil supply, or a smaller journal",
        )
    _, variant, both = max(best, key=lambda row: row[0])
    worse = min(both, key=lambda one: one.margin)
    sizes = ", ".join(
        f"{place} {short(one.length * 1e3)} mm long with {short(one.clearance * 1e6)} µm" for place, one in zip(PLACES, both)
    )  # fmt: skip
    corner = f" (corner: {worse.corner})" if worse.corner else ""
    return NoSolution(
        "no bearings keep every rule", f"nearest: {variant.oil}, {variant.supply}, {sizes}, stopped by {said(worse.governing)}{corner}",
        worse.governing.advice,
    )  # fmt: skip
