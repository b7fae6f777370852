# SPDX-License-Identifier: Apache-2.0
"""The loads of a journal that stand still while the main one turns, what they do to the film, and to its friction.

They are the shaft's weight and the force of its gear.  Two answers: the film under the largest load of the turn as if
it stayed, and the orbit that the journal makes about its place in the turning load's frame by the film's stiffness and
damping, to first order.  The orbit may come closer: a force across the load pushes the journal along its seat, towards
the narrowest film.  The thinner of the two is judged."""

from collections.abc import Iterator
from typing import Any, Generic

import numpy as np

from ...countershaft.rows import ROW, BearingRow, called, titled
from ...library import journal_rules as rules
from ...sheet.arrays import Array, BoolArray, Value
from ...sheet.check import Check, CheckRule
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.functions import single_or_many
from ...sheet.quantity import dotted
from ...sheet.record import record, replace
from ...sheet.text import Amount, Text
from ...sheet.units import MetrePerSecond, Newton, Watt
from ...sheet.value import about, based_on, untraced
from ..inputs import BearingsInputs
from . import formulas as f
from .as_support import runs_centred
from .checks import FILM_EDGE_STANDING, edge_missing, lost_at_edge, on_bearing
from .film.dynamics import orbit
from .result import PlainResult, StandingResult
from .routes.routes import own_warm
from .routes.states import BearingCase, Film, OperatingPoint
from .routes.thermal_balance import balanced, settled
from .seats.checks import BUSH_STRESS, SEAT_FRETTING, SEAT_PRESS, SEAT_STRESS, SEAT_TURN
from .seats.formulas import press_needed
from .seats.result import SeatResult
from .seats.seat import chosen, seated
from .suitability import DIAMETER, LENGTH

PRESSED = (SEAT_PRESS, SEAT_FRETTING, SEAT_TURN, SEAT_STRESS, BUSH_STRESS)  # on the largest load of a turn

SMALL = 0.5  # of the turning load: an orbit of first order; rule of this program


START_LOAD = CheckRule(
    "bearings.B.start_load",
    "caution",
    "Trumpler's criterion against wear at every start, before a film is there.",
    Text("Specific load at the start"),
    "<=",
    "MPa",
    rules.TRUMPLER + Text(": on the load at the start, here the standing part alone (his own 300 psi are 2.07 MPa)"),
    Text("A larger or longer journal."),
    demand=True,
    value_id=dotted("bearings", "B", StandingResult.load_at_start),
    moved_by=(LENGTH, DIAMETER),
)


STANDING_SHARE = CheckRule(
    "bearings.B.standing_share",
    "method",
    "What stands is added to what turns as a small part of it.",
    Text("Standing over turning load"),
    "<=",
    source=Text("rule of this program: an orbit of first order"),
    advice=Text("The film under the largest load of the turn, as if it stayed, is the one to look at."),
    moved_by=(dotted(ROW, BearingRow.offset), dotted("bearings", BearingsInputs.coaxiality)),
)


def more_pressed(bearing: PlainResult, peak: Newton) -> SeatResult | None:
    """The seat under the largest load of a turn, which asks more of its fit; an interference that is chosen is so much
    larger."""
    seat, row = bearing.seat_, bearing.seat.bearing
    if seat is None:
        return None
    if not seat.rings.chosen:
        with untraced():
            fit = seat.rings.fit(row.diameter, bearing.clearance)
        return replace(seat, press_needed=press_needed(F=peak, d_o=fit.d_o, l=row.length))
    rings = chosen(seat.rings, row, bearing.clearance, peak, seat.temperatures)
    omega = f.angular_speed(n=bearing.duty.speed)
    return seated(rings, row, bearing.clearance, peak, bearing.friction_power, omega, seat.temperatures)


def standing(bearing: PlainResult, R_0: float, place: str, notes: list[Text]) -> StandingResult:
    peak = f.load_peak(F=bearing.load, R_0=R_0)
    at_start = f.load_at_start(R_0=R_0, d=bearing.seat.bearing.diameter, l=bearing.seat.bearing.length)
    film_peak = film_orbit = amplitude = equal = None
    at_peak, seat = replace(bearing.duty, load=peak), bearing.seat
    if seat.centred and not runs_centred(seat, at_peak):
        seat = replace(seat, centred=False)
    try:
        film_peak = balanced(own_warm, seat, at_peak).film
    except NoSolution as none:
        words = Text(
            "{place} bearing: no film is found for the largest load of the turn ({none}).",
            place=titled(place),
            none=none.text,
        )
        notes.append(words)
    if bearing.seat.inputs.load_speed_ratio == 1.0 and bearing.load > 0:
        equal = f.speed_of_equal_loads(n=bearing.duty.speed, R_0=R_0, R=bearing.load)
    if R_0 < SMALL * bearing.load or _share_is_judged(bearing):
        path = orbit(bearing.dynamics, R_0, bearing.attitude_angle, bearing.duty, bearing.seat)
        amplitude, film_orbit = path.amplitude, f.film_over_turn(h_0=bearing.film, a_n=path.film_loss)
    return StandingResult(
        standing_load=R_0,
        load_peak=peak,
        film_load_peak=film_peak,
        film_orbit=film_orbit,
        orbit_amplitude=amplitude,
        speed_of_equal_loads=equal,
        load_at_start=at_start,
    )


def _share_is_judged(bearing: PlainResult) -> bool:
    """Whether a check says that a standing load is too large for an orbit of first order, which is then shown all the
    same: without it more load would seem to leave more film."""
    shared = bearing.on_shaft is not None and bearing.on_shaft.standing_stiffness is not None
    return shared and not bearing.seat.centred


def standing_checks(place: str, bearing: PlainResult, part: StandingResult) -> Iterator[Check]:
    yield on_bearing(START_LOAD, place, part.load_at_start, rules.TRUMPLER_START_LOAD)
    if _share_is_judged(bearing):
        yield on_bearing(STANDING_SHARE, place, part.standing_load / bearing.load, SMALL)
    edge = None  # where no film carries the largest load, the check fails
    if part.film_load_peak is not None:
        thinnest = min(h for h in (part.film_load_peak, part.film_orbit) if h is not None)
        with about(Text("{place} bearing, standing part of the load", place=called(place))):
            edge = f.film_at_edge_of_another(h_x=thinnest, h_0=bearing.film, h_edge=bearing.film_edge)
    missing = edge_missing(bearing, edge)
    lost = lost_at_edge(bearing)
    yield on_bearing(FILM_EDGE_STANDING, place, edge, bearing.kreisle_film, missing=missing, base=lost)


# --- the friction of a journal over a turn, where a standing load passes under the one that turns with it
# The load of the moment runs from F − R_0 to F + R_0; to second order in R_0/F the mean over a turn needs the slope and
# the curvature of the friction over the load, which the own solution gives at loads a little below and above.

APART = 0.05  # of the load: how far below and above
SECOND_ORDER = 0.5  # of the load: up to here a standing load counts as small


@formula(
    "P_f'",
    "mathematics: slope of the friction over the load, from the own solution beside it",
    shows="[P_f(1.05·F) − P_f(0.95·F)]/(0.1·F)",
)
def slope(P_below: Watt, P_above: Watt, F: Newton) -> MetrePerSecond:
    return (P_above - P_below) / (2 * APART * F)


@formula(
    "F·P_f''",
    "mathematics: curvature of the friction, the same way",
    shows="[P_f(1.05·F) − 2·P_f(F) + P_f(0.95·F)]/(0.05²·F)",
)
def curvature(P_below: Watt, P_f: Watt, P_above: Watt, F: Newton) -> MetrePerSecond:
    return (P_above - 2 * P_f + P_below) / (APART**2 * F)


@formula(
    "P_f",
    "mathematics: mean over a turn under turning and standing load, each moment as if it stayed; second order in R_0/F",
    names={"P": "P_f,F", "S": "P_f'", "K": "(F·P_f'')"},
)
def over_a_turn(P: Watt, R_0: Newton, F: Newton, S: MetrePerSecond, K: MetrePerSecond) -> Watt:
    return P + R_0**2 / (4 * F) * (S + K)


@record
class Response(Generic[Value]):
    """How the friction of a journal answers to its load: of one operating point, or of many."""

    load: Value  # N
    friction_power: Value  # W
    slope: Value  # m/s
    curvature: Value  # m/s

    @property
    def unsteady(self) -> bool:
        """Whether at some point no film is found beside the load."""
        return not np.all(np.isfinite(self.slope + self.curvature))

    def power(self, R_0: Value) -> Value:
        return over_a_turn(P=self.friction_power, R_0=R_0, F=self.load, S=self.slope, K=self.curvature)

    def under(self, R_0: Any) -> Any:
        """The friction over a turn with R_0 standing; where nothing is known of that, the friction without."""
        if not np.any(np.isfinite(self.slope + self.curvature)):
            return self.friction_power
        P_f = self.power(R_0)
        return np.where(np.isfinite(P_f), P_f, self.friction_power) if self.unsteady else P_f

    def only(self, some: BoolArray) -> "Response[Any]":
        """Some of many operating points."""
        return Response(**{name: x[some] if np.ndim(x) else x for name, x in vars(self).items()})

    def note(self, place: str, R_0: Any) -> Text | None:
        """What is rough where the load R_0 stands."""
        if self.unsteady:
            return Text(
                "{place} journal: no film is found 5 % beside its load; its friction is that of the turning load.",
                place=titled(place),
            )
        if R_0 > SECOND_ORDER * self.load:
            percent = Amount(R_0 / self.load * 100, form=".0f")
            return Text(
                "{place} journal: {share}; the mean over a turn, of second order in it, is rough.",
                place=titled(place),
                share=Text("the standing load is {standing_load} % of the turning one", standing_load=percent),
            )
        return None


def loads_beside(seat: BearingCase[Any], duty: OperatingPoint[Any]) -> tuple[BearingCase[Any], OperatingPoint[Any]]:
    """A little less load, the load itself and a little more, along a last axis of their own; the duty's numbers may be
    arrays."""
    about = np.array((1 - APART, 1.0, 1 + APART))
    loads = (duty.load[..., None] if np.ndim(duty.load) else duty.load) * about
    others = {name: x[..., None] if np.ndim(x) else x for name, x in vars(duty).items() if name != "load"}
    return seat, replace(duty, load=loads, **others)


def answered(film: Film[Array], duty: OperatingPoint[Any], friction_power: Any = None) -> Response[Any]:
    """The answer at a duty, from the films at `loads_beside`.  `friction_power` [W]: at that duty, where it is known;
    nan: no film is found."""
    below, at, above = (single_or_many(film.friction_power[..., i]) for i in range(3))
    P_f = at if friction_power is None else friction_power
    # found alike, of the same numbers
    below, at, above = (based_on(P, friction_power, duty.load) for P in (below, at, above))
    return Response(
        load=duty.load,
        friction_power=P_f,
        slope=slope(P_below=below, P_above=above, F=duty.load),
        curvature=curvature(P_below=below, P_f=at, P_above=above, F=duty.load),
    )


def response(seat: BearingCase[Any], duty: OperatingPoint[Any], friction_power: Any = None) -> Response[Any]:
    """The answer at a duty, whose numbers may be arrays; `friction_power` as above."""
    return answered(settled(*loads_beside(seat, duty)), duty, friction_power)
