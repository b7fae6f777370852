# SPDX-License-Identifier: Apache-2.0
"""The search itself: inputs and results in, rows to choose from out.  What is offered has been through the whole solution once more."""

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from ...sheet.check import Check
from ...sheet.errors import NoSolution
from ...sheet.number import short
from ...sheet.record import record
from ...sheet.units import Radian
from ..inputs import BearingsInputs
from .case import Case
from .grid import Field, field
from .ranking import Fields, Pick, Row, Slopes, closest, least_power, nearest, pareto, picks
from .states import Task
from .variants import PLACES, Variant, tasks, tied, variants

TRIES = 3  # of a row whose slopes, read again from the shaft's bending, stop it
CORNER = "_corner"  # how the checks at the worst corner are called; where the fits are assumed, they only advise
VERIFIED = 6  # rows that are solved as whole designs before they are shown; the others when they are taken


@record
class Found:
    """What there is to choose.  `rows`: numbered from 1, the nearest first, then the least power by oil and supply, then the Pareto set.

    `now`: the design as it is, None where it has no film.  `refused`: variants without a row, with what stops them.
    `slopes`: those of the design, then those that the solved rows were judged with.  `diameters`: what is done about them, in words.
    `elsewhere`: by row number, limits of other steps that fail with it and did not before.
    """

    now: Row | None
    rows: tuple[Row, ...]
    pareto: tuple[Row, ...]
    tasks: dict[str, list[Task]]
    variants: tuple[Variant, ...]
    slopes: tuple[dict[str, Radian], ...]
    diameters: str
    refused: tuple[tuple[Variant, str], ...]
    dropped: tuple[str, ...]
    elsewhere: dict[int, tuple[Check, ...]]
    verified: int

    @property
    def all(self) -> tuple[Row, ...]:
        return (*self.rows, *self.pareto)

    def slopes_of_row(self, number: int) -> dict[str, Radian]:
        return self.slopes[number if number < len(self.slopes) else 0]


def search(case: Case) -> Found:
    """Rows to choose from for the bearings of a design.

    Raises NoSolution where nothing keeps all rules, with what comes nearest and what stops it.
    """
    bearings, offered, slopes = tasks(case), variants(case), slopes_of(case, case.results)
    too_thin: dict[tuple[str, str, int], float] = {}
    every = [(variant, fields_of(variant, bearings, slopes, supply=offered[0].supply, too_thin=too_thin)) for variant in offered]
    kept: list[tuple[Variant, Fields]] = []
    best: list[Row] = []
    refused: list[tuple[Variant, str]] = []
    dropped: list[Settled] = []
    for variant, fields in every:
        pair = least_power(fields, slopes)
        if pair is None:
            refused.append((variant, _stopped(closest(fields, slopes)) if all(fields.values()) else _left_out(variant, too_thin)))
        else:
            kept.append((variant, fields))
            best.append(Row("least power", variant, *pair))
    if not best:
        raise _nothing(every, slopes)
    first = nearest(every[0][1], slopes)
    rows: list[Settled] = []
    if first is not None:
        settled = settle(case, Row("nearest", offered[0], *first), every[0][1], slopes)
        (rows if settled.row is not None else dropped).append(settled)
    by_variant = {id(variant): fields for variant, fields in every}
    waiting = [Settled(row, slopes) for row in best]
    done: list[Settled] = []
    while waiting and len(rows) < VERIFIED:
        waiting.sort(key=_rank)
        one = waiting.pop(0)
        assert one.row is not None
        if one in done:  # still the least after its slopes were read again
            rows.append(one)
            continue
        settled = settle(case, one.row, by_variant[id(one.row.variant)], slopes)
        if settled.row is None:
            dropped.append(settled)
        else:
            done.append(settled)
            waiting.append(settled)
    if not rows:
        what = "no bearings pass once the whole design is solved with them"
        raise NoSolution(what, "; ".join(one.why for one in dropped[:2]), "stiffen the shaft, or widen its envelope")
    shown = tuple(one.row for one in (*rows, *sorted(waiting, key=_rank)) if one.row is not None)
    return Found(
        as_is(bearings, offered[0], slopes), shown, tuple(pareto(kept, slopes)), bearings, tuple(offered),
        (slopes, *(one.slopes for one in rows)), _diameters(case, bearings), tuple(refused), tuple(one.why for one in dropped),
        {number: one.broken for number, one in enumerate(rows, 1) if one.broken}, len(rows),
    )  # fmt: skip


def _rank(one: "Settled") -> tuple[float, float]:
    assert one.row is not None
    return one.row.power, one.row.change


def nearest_passing(case: Case) -> Row | None:
    """The smallest change of lengths and clearances that keeps every rule, with the design's oil and supply; None: there is none."""
    variant, slopes = variants(case)[0], slopes_of(case, case.results)
    fields = fields_of(variant, tasks(case), slopes, supply=variant.supply)
    pair = nearest(fields, slopes)
    return None if pair is None else settle(case, Row("nearest", variant, *pair), fields, slopes).row


def fields_of(
    variant: Variant,
    bearings: dict[str, list[Task]],
    slopes: Slopes,
    *,
    supply: str,
    too_thin: dict[tuple[str, str, int], float] | None = None,
) -> dict[str, list[Field]]:
    """Other diameters are looked at with the design's own supply only.

    `too_thin`: by supply, place and diameter the viscosity of oils whose film passes nowhere; a thinner one is not looked at any more.
    """
    known = too_thin if too_thin is not None else {}
    found: dict[str, list[Field]] = {place: [] for place in PLACES}
    for place in PLACES:
        for n, task in enumerate(bearings[place] if variant.supply == supply else bearings[place][:1]):
            key, mu = (variant.supply, place, n), variant.lubricant.at(task.duty.supply_temperature).mu
            if mu < known.get(key, 0.0):
                continue
            made = field(task, variant, slopes[place])
            if made is None:
                continue
            found[place].append(made)
            if not made.holds(slopes[place]).any():
                known[key] = max(mu, known.get(key, 0.0))
    return found


def slopes_of(case: Case, results: Any, before: dict[str, Radian] | None = None) -> dict[str, Radian]:
    """As given, else of the shaft's bending; where its outline is not known any more, as before; zero where it never was."""
    own = case.bearings
    if own.slope is not None:
        return {"front": own.slope[0], "rear": own.slope[-1]}
    shaft = results.outcomes["countershaft"].result
    if shaft is None or shaft.slope_front is None or shaft.slope_rear is None:
        return before or dict.fromkeys(PLACES, 0.0)
    return {"front": shaft.slope_front, "rear": shaft.slope_rear}


def with_row(own: BearingsInputs, row: Row) -> BearingsInputs:
    """The design's bearings as a row has them."""
    made: dict[str, Any] = {}
    for place, one in zip(PLACES, row.both):
        b = getattr(own, place)
        if one.clearance != one.task.clearance or one.diameter != one.task.diameter:
            b = replace(b, clearance=one.clearance, clearance_factor=None)
        made[place] = replace(b, length=one.length, diameter=one.diameter)
    return replace(own, oil=row.variant.oil, supply=row.variant.supply, **made)


@record
class Settled:
    """A row after the whole solution: as it is then judged, with the slopes read there, and the limits of other steps that it breaks.

    `row` None: it does not pass, and `why`.
    """

    row: Row | None
    slopes: dict[str, Radian]
    broken: tuple[Check, ...] = ()
    why: str = ""


def confirmed(case: Case, row: Row, slopes: dict[str, Radian]) -> Settled:
    """A row through the whole solution, as it stands."""
    before = {c.id for c in case.results.checks() if c.verdict == "fail"}
    made = case.solve(with_row(case.bearings, row))
    there = made.outcomes["bearings"]
    again = slopes_of(case, made, slopes)
    front, rear = (_again(one, again[place]) for place, one in zip(PLACES, row.both))
    failing = [c for c in there.checks if c.verdict == "fail" or (c.id.endswith(CORNER) and c.verdict != "pass" and not c.margin >= 0)]
    failing += [one.governing for one in (front, rear) if one.margin < 0]
    if there.state != "solved" or failing:
        why = said(failing[0]) if failing else there.reason
        return Settled(None, again, (), f"{row.variant.oil}, {row.variant.supply}: {why}")
    others = (c for key, o in made.outcomes.items() if key != "bearings" for c in o.checks)
    return Settled(replace(row, front=front, rear=rear), again, tuple(c for c in others if c.verdict == "fail" and c.id not in before))


def settle(case: Case, row: Row, fields: Fields, slopes: dict[str, Radian]) -> Settled:
    """A row through the whole solution; where the slopes that are read there stop it, it is chosen anew with them."""
    choose = nearest if row.what == "nearest" else least_power
    found = confirmed(case, row, slopes)
    for _ in range(TRIES):
        if found.row is not None:
            break
        slopes = {place: max(slopes[place], found.slopes[place]) for place in PLACES}
        pair = choose(fields, slopes)
        if pair is None:
            break
        found = confirmed(case, replace(row, front=pair[0], rear=pair[1]), slopes)
    return found


def _again(one: Pick, slope: Radian) -> Pick:
    return picks(one.task, [one.length], [one.clearance], slope)[0]


def _diameters(case: Case, bearings: dict[str, list[Task]]) -> str:
    """What ties them, or which were looked at."""
    words = []
    for place in PLACES:
        if len(bearings[place]) == 1:
            words.append(f"{place} as it is ({tied(case, case.results, place) or 'no other has an answer'})")
        else:
            looked = sorted(task.seat.bearing.diameter for task in bearings[place])
            words.append(f"{place} free, {short(looked[0] * 1e3)} to {short(looked[-1] * 1e3)} mm looked at in {len(looked)} steps")
    return "; ".join(words) + "."


def as_is(bearings: dict[str, list[Task]], variant: Variant, slopes: dict[str, Radian]) -> Row | None:
    """The design as it stands, judged by the same rules; None where a bearing has no film."""
    both = []
    for place in PLACES:
        task = bearings[place][0].with_oil(variant.lubricant, variant.supply)
        both += picks(task, [task.length], [task.clearance], slopes[place])
    return Row("now", variant, *both) if all(one.power == one.power for one in both) else None


def said(check: Check) -> str:
    """`film at the edge, front, 8.2 µm, needs ≥ 9 µm`."""
    value = f"{short(check.value)} {check.unit}".rstrip() if check.value == check.value else "no film"
    return f"{check.name[0].lower()}{check.name[1:]}: {value}, needs {check.limit_text()}"


def _stopped(both: tuple[Pick, Pick] | None) -> str:
    if both is None:
        return "no length is left between l/d, oil supply and room, or no clearance between the cold one and the usual factor K"
    worse = min(both, key=lambda one: one.margin)
    return f"{said(worse.governing)} at {short(worse.length * 1e3)} mm and {short(worse.clearance * 1e6)} µm"


def _left_out(variant: Variant, too_thin: dict[tuple[str, str, int], float]) -> str:
    """Why a variant was not even looked at."""
    if any(supply == variant.supply for supply, _, _ in too_thin):
        return "a thicker oil has too thin a film already"
    return _stopped(None)


def _nothing(every: Iterable[tuple[Variant, Fields]], slopes: dict[str, Radian]) -> NoSolution:
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
