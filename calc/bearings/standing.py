# SPDX-License-Identifier: Apache-2.0
"""What stands still while the load turns, the shaft's weight and the force of its gear, and what it does to the film.

Two answers: the film under the largest load of the turn as if it stayed, and the orbit that the journal makes about its place in the
turning load's frame by the film's stiffness and damping, to first order.  The orbit may come closer: a force across the load
pushes the journal along its seat, towards the narrowest film.  The thinner of the two is judged.
"""

from dataclasses import replace

from ..countershaft.standing import Standing
from ..sheet.check import Check, check
from ..sheet.errors import NoSolution
from ..sheet.step import Outcome
from ..sheet.trace import about, trace
from . import formulas as f
from .checks import TRUMPLER
from .film.dynamics import orbit
from .result import BearingResult, StandingResult
from .routes.balance import balanced
from .routes.routes import own_warm

START = 300 * f.PSI
SMALL = 0.5  # of the turning load: an orbit of first order; rule of this program


def with_standing(outcome: Outcome, stands: Standing | None) -> Outcome:
    """The same outcome with the standing part of each bearing's load."""
    if stands is None or outcome.state != "solved" or stands.stationary_front is None or stands.stationary_rear is None:
        return outcome
    bearings, checks, notes = {}, list(outcome.checks), list(outcome.notes)
    with trace() as lines:
        for place, load in (("front", stands.stationary_front), ("rear", stands.stationary_rear)):
            one = outcome.result.bearings[place]
            with about(f"{place} bearing, standing part of the load"):
                part = _standing(one, load, place, notes)
            bearings[place] = replace(one, standing=part)
            checks += _checks(place, one, part)
    return replace(
        outcome, result=replace(outcome.result, bearings=bearings), checks=tuple(checks), lines=(*outcome.lines, *lines), notes=tuple(notes)
    )


def _standing(one: BearingResult, R_0: float, place: str, notes: list[str]) -> StandingResult:
    peak = f.load_peak(F=one.load, R_0=R_0)
    at_start = f.load_at_start(R_0=R_0, d=one.seat.bearing.diameter, l=one.seat.bearing.length)
    film_peak = film_orbit = amplitude = equal = None
    try:
        film_peak = balanced(own_warm, one.seat, replace(one.duty, load=peak)).film
    except NoSolution as none:
        notes.append(f"{place.capitalize()} bearing: no film is found for the largest load of the turn ({none}).")
    if one.seat.inputs.load_speed_ratio == 1.0:
        equal = f.speed_of_equal_loads(n=one.duty.speed, R_0=R_0, R=one.load)
    if R_0 < SMALL * one.load:
        path = orbit(one.dynamics, R_0, one)
        amplitude, film_orbit = path.amplitude, f.film_over_turn(h_0=one.film, a_n=path.film_loss)
    return StandingResult(
        standing_load=R_0, load_peak=peak, film_load_peak=film_peak, film_orbit=film_orbit, orbit_amplitude=amplitude,
        speed_of_equal_loads=equal, load_at_start=at_start,
    )  # fmt: skip


def _checks(place: str, one: BearingResult, part: StandingResult) -> list[Check]:
    found = [
        check(
            f"bearings.{place}.start_load", f"Specific load at the start, {place}", part.load_at_start, "<=", START, "MPa",
            TRUMPLER + ": 300 psi on the load at the start, here the standing part alone", "A larger or longer journal.", kind="advice",
        ),
    ]  # fmt: skip
    thinnest = min((h for h in (part.film_load_peak, part.film_orbit) if h is not None), default=None)
    if thinnest is not None:
        found.append(
            check(
                f"bearings.{place}.film_edge_standing", f"Film at the edge over a turn, with the standing load, {place}",
                thinnest - (one.film - one.film_edge), ">=", one.kreisle_film, "µm",
                "Kreisle, on the turning and the standing load together",
                "As for the film at the edge; the standing part is weight and gear force.", kind="advice",
            )
        )  # fmt: skip
    return found
