# SPDX-License-Identifier: Apache-2.0
"""One bearing with what is pressed in: its interference and its clearance before the film is solved, what follows for
the seat once it is, and the film as the split of shells passes."""

import numpy as np

from ....sheet.arrays import Array
from ....sheet.record import replace
from ....sheet.units import Celsius, Metre, Newton, Number
from ....sheet.value import based_on, untraced
from .. import formulas as film_by
from ..corners import CORNERS, assumed, corner_points
from ..film import split_line
from ..film.reynolds import ECCENTRICITY_RANGE
from ..routes.states import BearingCase, Film, OperatingPoint
from ..routes.thermal_balance import settled
from ..row import RELIEF, RELIEF_LENGTH
from ..speeds import TURNING
from . import formulas as f
from .result import PairResult, SeatResult, SelectResult, SplitResult
from .rings import Rings
from .seat import GUESSED, chosen, seated, states
from .stack import SeatStack, stack_of

CHOSEN_PASSES, CHOSEN_WITHIN = 6, 0.05  # until the hottest film of a chosen interference stays, in K


def sitting(seat: BearingCase, duty: OperatingPoint) -> BearingCase:
    """The same bearing with the interference of what is pressed in and the clearance that its parts make.

    An interference that is chosen holds where the film is hottest, which hangs on the clearance, and walls that are
    found allow for what the press does to the bore: until both stay."""
    if seat.rings is None:
        return replace(seat, clearance=_of_parts(seat))
    hot = duty.supply_temperature + GUESSED
    with untraced():
        for _ in range(CHOSEN_PASSES):
            before, seat = hot, _pressed(seat, duty, hot)
            hot = _hottest(seat, duty) if seat.rings is not None and seat.rings.chosen else hot
            if abs(hot - before) < CHOSEN_WITHIN:
                break
    row, select = seat.bearing, seat.inputs.select
    if seat.stack is not None:  # found without lines
        parts = row.journal, row.bore, row.wall, row.finished, None if select is None else select.clearance_band
        seat = replace(seat, clearance=based_on(seat.clearance, *parts))
    return _pressed(seat, duty, _based_on_film(hot, seat, duty))


def _based_on_film(hot: Celsius, seat: BearingCase, duty: OperatingPoint) -> Celsius:
    """The temperature of a film that was found without lines, with what it was found from."""
    inputs, row = seat.inputs, seat.bearing
    of = inputs.oil, inputs.viscosity, inputs.load_speed_ratio, inputs.bush_speed_ratio, inputs.speed
    supplied = inputs.supply_temperature, inputs.supply_pressure, inputs.hole_diameter, inputs.groove_width
    at_corners = inputs.viscosity_tolerance, inputs.journal_fit, inputs.seat_fit
    return based_on(hot, seat.clearance, row.diameter, row.length, duty.load, duty.speed, *of, *supplied, *at_corners)


def _pressed(seat: BearingCase, duty: OperatingPoint, hot: Celsius) -> BearingCase:
    """With bush and shells as they sit where the film is so hot."""
    row, inputs, rings = seat.bearing, seat.inputs, seat.rings
    assert rings is not None
    rings = chosen(rings, row, seat.clearance, duty.load, states(inputs, hot))
    if seat.stack is not None and seat.stack.pairs is not None:
        with untraced():
            stack = stack_of(row, inputs.select, rings.rise(row.diameter, seat.clearance))
        assert stack is not None and stack.walls is not None
        seat, rings = replace(seat, stack=stack), replace(rings, wall=sum(stack.walls) / 2)
    seat = replace(seat, rings=rings)
    return replace(seat, clearance=_of_parts(seat))


def _of_parts(seat: BearingCase) -> Metre:
    """The clearance: of its parts, where they make it, their middle."""
    if seat.stack is None:
        return seat.clearance
    least, most = seat.stack.clearances(seat.rings)
    return f.middle_clearance(g_min=least, g_max=most)


def _hottest(seat: BearingCase, duty: OperatingPoint) -> Celsius:
    """Highest mean temperature of the film over its corners; of the film where fits are not given.  The limit of the
    outlet where no film answers."""
    at = replace(duty, load=max(duty.load, 1.0))
    film = settled(*((seat, at) if assumed(seat) else corner_points(seat, at)))
    return _highest(film.mean_temperature, seat)


def _highest(temperatures: Array, seat: BearingCase) -> Celsius:
    """Of the corners under the load itself."""
    corners = np.atleast_1d(temperatures)[: len(CORNERS)]
    return float(np.nanmax(corners)) if np.isfinite(corners).any() else seat.inputs.outlet_temperature_limit


def seat_result(
    seat: BearingCase, load: Newton, duty: OperatingPoint, hot: Film, corner_films: Film[Array]
) -> SeatResult | None:
    """What follows from a film that is solved, and from those of its corners; None where nothing is pressed in."""
    if seat.rings is None:
        return None
    T = hot.mean_temperature
    if not assumed(seat):
        T = _based_on_film(_highest(corner_films.mean_temperature, seat), seat, duty)
    omega = film_by.angular_speed(n=duty.speed)
    at = states(seat.inputs, T)
    return seated(seat.rings, seat.bearing, seat.clearance, load, hot.friction_power, omega, at)


def select_result(stack: SeatStack | None, rings: Rings | None) -> SelectResult | None:
    """What every pair of classes leaves, and of how many shells; None where none are picked by classes."""
    if stack is None or stack.pairs is None:
        return None
    pairs = {
        f"{bore}_{journal}": PairResult(min=least, max=most)
        for bore, journal in stack.pairs
        for least, most in (stack.of_pair((bore, journal), rings),)
    }
    inserts = float(len({wall for _, wall, _ in stack.pairs.values()}))
    return SelectResult(inserts=based_on(inserts, *(pair.min for pair in pairs.values())), pair=pairs)


def split_result(seat: BearingCase, hot: Film, edge: Metre, ratio: Number) -> SplitResult | None:
    """The film as the split of shells passes under a load that turns with the journal; None where none passes.

    A relief or a film beyond what was marched is taken at its end, which leaves more film than there is."""
    row, inputs = seat.bearing, seat.inputs
    if row.seat != "shells" or seat.centred or inputs.load_speed_ratio != TURNING or inputs.bush_speed_ratio:
        return None
    t, a_r = (
        default if given is None else given
        for given, default in ((row.relief, RELIEF), (row.relief_length, RELIEF_LENGTH))
    )
    depth, arc = f.relief_depth(t=t, g=hot.clearance), f.relief_arc(a_r=a_r, d=row.diameter)
    eps = hot.eccentricity
    beyond = bool(t and a_r) and (arc > split_line.HALF_ARC_RANGE[1] or eps > ECCENTRICITY_RANGE[1])
    if beyond:
        arc = based_on(min(arc, split_line.HALF_ARC_RANGE[1]), arc)
        eps = based_on(min(eps, ECCENTRICITY_RANGE[1]), eps)
    share = split_line.share(eps=eps, b=ratio, depth=depth, arc=arc if t and a_r else 0.0)
    return SplitResult(share=share, film=f.film_at_split(h_edge=edge, h_0=hot.film, s_t=share), beyond=beyond)
