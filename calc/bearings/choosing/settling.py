# SPDX-License-Identifier: Apache-2.0
"""A row put into the design and solved as a whole: whether it holds there, and what else then fails."""

from dataclasses import replace
from typing import Any

from ...sheet.check import Check
from ...sheet.number import short
from ...sheet.record import record
from ...sheet.units import Radian
from ..inputs import BearingsInputs
from .case import Case
from .ranking import Fields, Pick, Row, Slopes, least_power, nearest, picks
from .variants import PLACES, drawn, placed

TRIES = 3  # of a row whose slopes, read again from the shaft's bending, stop it
CORNER = "_corner"  # how the checks at the worst corner are called; where the fits are assumed, they only advise
CROSSING = "countershaft.crossing"


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
    before = {c.id for c in case.results.checks() if c.verdict == "fail"} - {CROSSING}
    made = case.solve(with_row(case.bearings, row))
    there = made.outcomes["bearings"]
    again = slopes_of(case, made, slopes)
    front, rear = (_again(one, again[place]) for place, one in zip(PLACES, row.both))
    failing = [c for c in there.checks if c.verdict == "fail"]
    if row.corners:
        failing += [c for c in there.checks if c.id.endswith(CORNER) and c.verdict == "warn" and not c.margin >= 0]
    failing += [one.governing for one in (front, rear) if one.margin < 0]
    others = [c for key, o in made.outcomes.items() if key != "bearings" for c in o.checks if c.verdict == "fail" and c.id not in before]
    if not any(row.too_long):
        failing += [c for c in others if c.id == CROSSING]
    if there.state != "solved" or failing:
        why = said(failing[0]) if failing else there.reason
        return Settled(None, again, (), f"{row.variant}: {why}")
    return Settled(replace(row, front=front, rear=rear), again, tuple(others))


def settle(case: Case, row: Row, fields: Fields, slopes: dict[str, Radian]) -> Settled:
    """A row through the whole solution; where the slopes that are read there stop it, it is chosen anew with them."""
    choose = nearest if row.what == "nearest" else least_power
    found = confirmed(case, row, slopes)
    for _ in range(TRIES):
        if found.row is not None:
            break
        steeper = {place: max(slopes[place], found.slopes[place]) for place in PLACES}
        pair = choose(fields, steeper) if steeper != slopes else None
        if pair is None:
            break
        slopes = steeper
        found = confirmed(case, replace(row, front=pair[0], rear=pair[1]), slopes)
    return found


def _again(one: Pick, slope: Radian) -> Pick:
    return picks(one.task, [one.length], [one.clearance], slope)[0]


def slopes_of(case: Case, results: Any = None, before: Slopes | None = None) -> dict[str, Radian]:
    """As given, else of the shaft's bending; where its outline is not known any more, as before; zero where it never was."""
    own = case.bearings
    if own.slope is not None:
        return {"front": own.slope[0], "rear": own.slope[-1]}
    shaft = (results or drawn(case)).outcomes["countershaft"].result
    if shaft is None or shaft.slope_front is None or shaft.slope_rear is None:
        return dict(before or dict.fromkeys(PLACES, 0.0))
    return {"front": shaft.slope_front, "rear": shaft.slope_rear}


def with_row(own: BearingsInputs, row: Row) -> BearingsInputs:
    """The design's bearings as a row has them."""
    made: dict[str, Any] = {}
    for place, one in zip(PLACES, row.both):
        b, there = getattr(own, place), one.task.seat.bearing
        if writes_clearance(one, row, own):
            b = replace(b, clearance=one.clearance, clearance_factor=None)
        b = replace(b, length=one.length, diameter=one.diameter)
        made[place] = replace(b, journal_roughness=there.journal_roughness, housing_roughness=there.housing_roughness)
    written = fits_to_write(row, own)
    if written is not None:
        made |= {"journal_fit": written[0], "seat_fit": written[1]}
    return replace(own, oil=row.variant.oil, supply=row.variant.supply, **made)


def fits_to_write(row: Row, own: BearingsInputs) -> tuple[str, str] | None:
    """Closer fits; or widths for fits with a place, which would make another clearance than the row's.  None: they stay."""
    moved = any(one.clearance != one.task.clearance or one.diameter != one.task.diameter for one in row.both)
    return row.variant.fits or (placed(own) if moved else None)


def writes_clearance(one: Pick, row: Row, own: BearingsInputs) -> bool:
    """Whether it has to be written: it changed, or factor K or fits would make another one of a new diameter or fit."""
    moved = one.clearance != one.task.clearance or one.diameter != one.task.diameter
    return moved or fits_to_write(row, own) is not None


def said(check: Check) -> str:
    """`film at the edge, front, 8.2 µm, needs ≥ 9 µm`."""
    value = f"{short(check.value)} {check.unit}".rstrip() if check.value == check.value else "no film"
    return f"{check.name[0].lower()}{check.name[1:]}: {value}, needs {check.limit_text()}"
