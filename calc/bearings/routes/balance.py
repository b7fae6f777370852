# SPDX-License-Identifier: Apache-2.0
"""The thermal balance: the temperature rise that a film makes is the rise it was given.

The difference of the two falls with the assumed rise, so that a bracket finds the one answer; a fixed point need not.  `balanced`
closes one bearing by any route and traces its last state; `settled` closes any number of bearings at once by the own solution.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np

from ...lubricant import State
from ...root import root
from ...sheet.arrays import Array
from ...sheet.errors import NoSolution
from ...sheet.trace import untraced
from ..film.table import FilmRangeError
from . import supply
from .routes import Route, own_cold, own_warm
from .states import Duty, Film, OutsideBalance, Seat, Seized

HOTTEST = 200.0  # K above the supply: no rise beyond is looked for
BREAKS_DOWN = 1e-3  # K: a film that is gone so close above the last that was found, with heat left over, has no balance
PROBES = (10.0, 50.0, 100.0, 150.0, 175.0, HOTTEST)  # K: rises at which a film is looked for whose oil is too thick without any
HALVINGS = 20
ITERATION_LIMIT = 60


def balanced(route: Route, seat: Seat, duty: Duty, tolerance: float = 1e-10) -> Film:
    """The film whose heat leaves with the oil.  Only this state is traced.

    Raises NoSolution where the load can not be carried, with what was tried, or where the rise passes 200 K.
    """

    @cache  # the ends of the bracket are asked for more than once
    def excess(rise: float) -> float:
        return route(seat, duty, rise).temperature_rise - rise

    with untraced():
        try:
            low = _begins(excess)
            high = min(low + 2 * excess(low) + 1e-6, HOTTEST)
            rise = root(excess, low, _reachable(excess, low, high), tolerance=tolerance)
        except (FilmRangeError, Seized, OutsideBalance) as error:
            raise NoSolution(*_reason(seat, duty, error)) from None
    return route(seat, duty, rise)


def _reason(seat: Seat, duty: Duty, error: ValueError) -> tuple[str, str, str]:
    """What was looked for, what came out, and what to do: too much load, too little, or a bearing too short or long."""
    at = f"{duty.load:.4g} N at {duty.speed * 60:.4g} rpm"
    if duty.effective_speed < duty.speed * (1 - 1e-9):
        at += f" (as dragged between load and surfaces, {duty.effective_speed * 60:.4g} rpm)"
    if isinstance(error, OutsideBalance):
        remedy = "lower the load, lengthen the bearing, give it less clearance, more oil or cooler oil"
        if not isinstance(error.end, FilmRangeError):
            remedy = "give it more clearance when warm (a larger clearance, a housing held back less), more oil, or cooler oil"
        return f"the heat of the film under {at} is not carried away", str(error), remedy
    if isinstance(error, Seized):
        return str(error), f"under {at}", "give it more clearance"
    if isinstance(error, FilmRangeError) and "l/d" in error.quantity and supply.lands(seat.inputs) == 2:
        advice = "a narrower groove or a longer bearing, so that each land is at least a tenth of the diameter long"
        return f"the film of the lands beside the groove is not in the table ({error})", f"under {at}", advice
    if isinstance(error, FilmRangeError) and "l/d" in error.quantity:
        return f"the film of this bearing is not in the table ({error})", f"under {at}", "choose a length between 0.1 and 2 diameters"
    if isinstance(error, FilmRangeError) and error.value > error.high:
        return (
            f"the journal runs nearly centred under {at}",
            str(error),
            "the load is too small for this clearance and oil: more clearance, or a thinner or warmer oil",
        )
    return f"no film carries {at}", str(error), "lower the load, lengthen the bearing, or take a thicker oil"


def _begins(excess: Callable[[float], float]) -> float:
    """The lowest rise that has an answer with heat left over: none, else where oil that is too thick for the table has warmed enough."""
    try:
        excess(0.0)
        return 0.0
    except FilmRangeError as nearly_centred:
        if "l/d" in nearly_centred.quantity or nearly_centred.value < nearly_centred.low:
            raise
        above = next((rise for rise in PROBES if _answers(excess, rise)), None)
        if above is None:
            raise
        below = 0.0
        for _ in range(HALVINGS):
            middle = (below + above) / 2
            below, above = (below, middle) if _answers(excess, middle) else (middle, above)
        if excess(above) <= 0:  # what the thick oil makes of heat is carried away before it is in the table
            raise
        return above


def _answers(excess: Callable[[float], float], rise: float) -> bool:
    try:
        excess(rise)
    except (FilmRangeError, Seized):
        return False
    return True


def _reachable(excess: Callable[[float], float], low: float, high: float) -> float:
    """An upper end of the bracket at which the route still has an answer and the excess is negative."""
    end: ValueError | None = None
    for _ in range(40):
        try:
            if excess(high) <= 0:
                return high
            low, high = high, min(2 * high, HOTTEST)
            if low == HOTTEST:
                raise OutsideBalance(f"the oil would warm by more than {HOTTEST:g} K")
        except (FilmRangeError, Seized) as gone:
            high, end = (low + high) / 2, gone
    raise OutsideBalance("the film is gone before its heat and the oil's flow are in balance", end)


def settled(seat: Seat, duty: Duty, *, warm: bool = True, tolerance: float = 1e-7) -> Film:
    """The same for arrays: any number of `seat` and `duty` may be one, broadcast against the others.  nan where there is no film.

    Regula falsi after Anderson & Björck 1973 on all points at once; a point without film at the upper end of its bracket is
    closed in on from below.
    """
    route = own_warm if warm else own_cold
    shape = np.broadcast_shapes(*(np.shape(x) for x in _numbers(seat, duty)))
    film: Film

    def excess(rise: Array) -> Array:
        nonlocal film
        film = route(seat, duty, rise)  # type: ignore[arg-type]
        made: Any = film.temperature_rise
        return np.asarray(made - rise)

    with untraced(), np.errstate(all="ignore"):
        low = np.zeros(shape)
        f_low = excess(low)
        opened: Any = np.asarray(film.clearance) > 0  # a journal that is seized before it turns does not come to turn
        low, f_low = _first(excess, low, f_low, opened)
        high = np.minimum(low + 2 * f_low + 1e-6, HOTTEST)
        f_high = excess(high)
        short = f_high > 0
        if short.any():
            high = np.where(short, HOTTEST, high)
            f_high = excess(high)
        lost = ~np.isfinite(f_low) | (f_low <= 0) | (f_high > 0)
        before = np.full(shape, None)
        for _ in range(ITERATION_LIMIT):
            finite = np.isfinite(f_high)
            secant = high - f_high * (high - low) / (f_high - f_low)
            x = np.where(finite & (secant > low) & (secant < high), secant, 0.5 * (low + high))
            f_x = excess(x)
            lost = lost | (~np.isfinite(f_high) & (high - low <= BREAKS_DOWN))
            done = lost | (np.abs(f_x) <= tolerance * (1 + x)) | (high - low <= tolerance)
            if done.all():
                break
            above = f_x > 0
            shrink = np.where(above, 1 - f_x / f_low, 1 - f_x / f_high)
            shrink = np.where(np.isfinite(shrink) & (shrink > 0), shrink, 0.5)
            shrink = np.where(above == before, shrink, 1.0)  # an end that stays twice has its value scaled down
            before = above
            f_low, f_high = np.where(above, f_x, f_low * shrink), np.where(above, f_high * shrink, f_x)
            low, high = np.where(above, x, low), np.where(above, high, x)
        return _only(film, ~lost & (np.abs(f_x) <= 1e-3 * (1 + x)))


def _first(excess: Callable[[Array], Array], low: Array, f_low: Array, opened: Any) -> tuple[Array, Array]:
    """The same lower ends as `_begins` for all points at once; nan stays where there is none."""
    missing = ~np.isfinite(f_low) & opened
    above, f_above = np.full(low.shape, np.nan), np.full(low.shape, np.nan)
    if missing.any():
        for rise in PROBES:
            f = excess(np.where(missing, rise, low))
            found = missing & np.isnan(above) & np.isfinite(f)
            above, f_above = np.where(found, rise, above), np.where(found, f, f_above)
    there = np.isfinite(above)
    if not there.any():
        return low, f_low
    below = np.zeros(low.shape)
    for _ in range(HALVINGS):
        middle = (below + above) / 2
        f = excess(np.where(there, middle, low))
        answers = there & np.isfinite(f)
        above, f_above = np.where(answers, middle, above), np.where(answers, f, f_above)
        below = np.where(answers, below, middle)
    return np.where(there, above, low), np.where(there, f_above, f_low)


def settled_together(asked: Sequence[tuple[Seat, Duty]]) -> list[Film]:
    """`settled` for several questions about one bearing in one call, each of its own length: all but the arrays is that of the first."""
    seat, duty = asked[0]
    sizes = [max(np.size(x) for x in _numbers(*question)) for question in asked]

    def joined(of: Callable[[Seat, Duty], Any]) -> Any:
        return np.concatenate([np.broadcast_to(of(*question), (size,)) for question, size in zip(asked, sizes)])

    film = settled(
        replace(seat, clearance=joined(lambda s, _: s.clearance), viscosity_factor=joined(lambda s, _: _factor(s))),
        replace(
            duty, load=joined(lambda _, d: d.load), speed=joined(lambda _, d: d.speed),
            effective_speed=joined(lambda _, d: d.effective_speed), supply_temperature=joined(lambda _, d: d.supply_temperature),
            supply_pressure=joined(lambda _, d: d.supply_pressure),
        ),
    )  # fmt: skip
    ends = np.cumsum(sizes)
    return [_slice(film, slice(end - size, end), int(ends[-1])) for size, end in zip(sizes, ends.tolist())]


def _slice(film: Film, part: slice, size: int) -> Film:
    """Some of the points of a film."""

    def cut(number: Any) -> Any:
        return None if number is None else np.broadcast_to(number, (size,))[part]

    names = [name for name in film.__dataclass_fields__ if name != "oil"]
    oil = State(*(cut(x) for x in (film.oil.nu, film.oil.mu, film.oil.rho, film.oil.cp)))
    numbers: dict[str, Any] = {name: cut(getattr(film, name)) for name in names}
    return Film(oil=oil, **numbers)


def _factor(seat: Seat) -> float:
    return 1.0 if seat.viscosity_factor is None else seat.viscosity_factor


def _numbers(seat: Seat, duty: Duty) -> tuple[Any, ...]:
    b = seat.bearing
    return b.diameter, b.length, seat.clearance, _factor(seat), duty.load, duty.speed, duty.supply_temperature, duty.supply_pressure


def _only(film: Film, there: Any) -> Film:
    """The film with nan where it is not there."""
    names = ("eccentricity", "film", "friction_coefficient", "friction_power", "oil_flow", "temperature_rise", "mean_temperature")
    numbers: dict[str, Any] = {name: np.where(there, getattr(film, name), np.nan) for name in names}
    return replace(film, **numbers)
