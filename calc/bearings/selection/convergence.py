# SPDX-License-Identifier: Apache-2.0
"""A row put into the design and solved as a whole: whether it holds there, and what else then fails."""

from dataclasses import replace

from ...countershaft.result import CountershaftResult
from ...sheet.changes import Changes, applied, digits
from ...sheet.check import Check
from ...sheet.record import record
from ...sheet.text import EMPTY, Text
from ...sheet.units import Radian
from ..inputs import BearingsInputs
from .case import Case, Solution
from .ranking import Fields, Pick, Row, Slopes, best, by_change, by_power
from .variants import drawn, placed
from .words import PLACES, against

TRIES = 3  # of a row whose slopes, read again from the shaft's bending, stop it
CORNER = "_corner"  # how the checks at the worst corner are called; where the fits are assumed, they only advise
CROSSING = "countershaft.crossing"


@record
class Settled:
    """A row after the whole solution: as it is then judged, with the slopes read there, and the limits of other steps that it breaks.

    `row` None: it does not pass, and `why`.  `results`: of the whole design with it.
    """

    row: Row | None
    slopes: dict[str, Radian]
    broken: tuple[Check, ...] = ()
    why: Text = EMPTY
    results: Solution | None = None


def confirmed(case: Case, row: Row, slopes: dict[str, Radian]) -> Settled:
    """A row through the whole solution, as it stands."""
    before = {c.id for c in case.results.checks() if c.verdict == "fail"} - {CROSSING}
    results = case.solve(with_row(case.bearings, row))
    there = results.outcomes["bearings"]
    again = slopes_of(case, results, slopes)
    front, rear = (one.with_slope(again[place]) for place, one in zip(PLACES, row.both))
    failing = [c for c in there.checks if c.verdict == "fail"]
    if row.corners:
        failing += [c for c in there.checks if c.id.endswith(CORNER) and c.verdict != "fail" and not c.margin >= 0]
    failing += [one.governing for one in (front, rear) if one.margin < 0]
    others = [c for key, o in results.outcomes.items() if key != "bearings" for c in o.checks if c.verdict == "fail" and c.id not in before]
    if not any(row.too_long):
        failing += [c for c in others if c.id == CROSSING]
    if there.state != "solved" or failing:
        why = against(failing[0]) if failing else there.reason
        return Settled(None, again, (), Text("{row}: {why}", row=row.variant.name, why=why), results)
    return Settled(replace(row, front=front, rear=rear), again, tuple(others), results=results)


def settle(case: Case, row: Row, fields: Fields, slopes: dict[str, Radian]) -> Settled:
    """A row through the whole solution; where the slopes that are read there stop it, it is chosen anew with them."""
    order = by_change if row.what == "nearest" else by_power
    settled = confirmed(case, row, slopes)
    for _ in range(TRIES):
        if settled.row is not None:
            break
        steeper = {place: max(slopes[place], settled.slopes[place]) for place in PLACES}
        pair = best(fields, steeper, order) if steeper != slopes else None
        if pair is None:
            break
        slopes = steeper
        settled = confirmed(case, replace(row, front=pair[0], rear=pair[1]), slopes)
    return settled


def slopes_of(case: Case, results: Solution | None = None, before: Slopes | None = None) -> dict[str, Radian]:
    """As given, else of the shaft's bending; where its outline is not known any more, as before; zero where it never was."""
    own = case.bearings
    if own.slope is not None:
        return {"front": own.slope[0], "rear": own.slope[-1]}
    shaft = (results or drawn(case)).result(CountershaftResult)
    if shaft is None or shaft.slope_front is None or shaft.slope_rear is None:
        return dict(before or dict.fromkeys(PLACES, 0.0))
    return {"front": shaft.slope_front, "rear": shaft.slope_rear}


def with_row(own: BearingsInputs, row: Row) -> BearingsInputs:
    """The design's bearings as a row has them: as they then stand in the file."""
    return applied(own, changes(row, own), "bearings.")


def changes(row: Row, own: BearingsInputs) -> Changes:
    """The keys that put a row into a design with these bearings; a clearance that stays keeps its key."""
    written: Changes = {}
    fits = fits_to_write(row, own)
    for place, one in zip(PLACES, row.both):
        at, b = f"bearings.{place}", one.task.seat.bearing
        if one.diameter != one.task.diameter:
            written[f"{at}.diameter_mm"] = digits(one.diameter / 1e-3)
        if one.length != one.task.length:
            written[f"{at}.length_mm"] = digits(one.length / 1e-3)
        if _moved(one) or fits is not None:  # factor K or fits would make another clearance of a new diameter or fit
            written |= {f"{at}.clearance_factor": None, f"{at}.clearance_um": digits(one.clearance / 1e-6)}
        if one.task.level:
            written[f"{at}.journal_roughness_um"] = digits(b.journal_roughness / 1e-6)
            written[f"{at}.housing_roughness_um"] = digits(b.housing_roughness / 1e-6)
    if fits is not None:
        written |= {"bearings.journal_fit": fits[0], "bearings.seat_fit": fits[1]}
    if row.variant.oil != own.oil:
        written["bearings.oil"] = row.variant.oil
    if row.variant.supply != own.supply:
        written["bearings.supply"] = row.variant.supply
    return written


def fits_to_write(row: Row, own: BearingsInputs) -> tuple[str, str] | None:
    """Closer fits; or widths for fits with a place, which would make another clearance than the row's.  None: they stay."""
    return row.variant.fits or (placed(own) if any(map(_moved, row.both)) else None)


def _moved(one: Pick) -> bool:
    return one.clearance != one.task.clearance or one.diameter != one.task.diameter
