# SPDX-License-Identifier: Apache-2.0
"""The thermal balance: the temperature rise that a film makes is the rise it was given.

The difference of the two falls with the assumed rise, so that a bracket finds the one answer; a fixed point need not.
`balanced` closes one bearing by any route and traces its last state; `settled` closes any number of bearings at once by
the own solution."""

import math
from collections.abc import Callable, Iterable, Sequence
from functools import cache
from typing import Any

import numpy as np

from ....library.lubricant import OilState
from ....sheet.arrays import Array, IndexArray, Num
from ....sheet.errors import NoSolution, text_of
from ....sheet.functions import root
from ....sheet.progress import go_on
from ....sheet.record import replace
from ....sheet.text import Amount, Text
from ....sheet.value import converged, recorded, recorder, unlinked, untraced
from .. import formulas as f
from ..film.table import FilmRangeError
from . import supply
from .routes import Route, own_cold, own_warm
from .states import BearingCase, Film, OperatingPoint, OutsideBalance, Seized, resized

HOTTEST = 200.0  # K above the supply: no rise beyond is looked for
BREAKS_DOWN = 1e-3  # K: a film that is gone so close above the last that was found, with heat left over, has no balance
# K: rises at which a film is looked for whose oil is too thick without any
PROBES = (10.0, 50.0, 100.0, 150.0, 175.0, HOTTEST)
HALVINGS = 20
ITERATION_LIMIT = 60
ALMOST = 1e-3  # relative, of a rise: what is closed in on to no more has no balance


def balanced(route: Route, seat: BearingCase, duty: OperatingPoint, tolerance: float = 1e-13) -> Film:
    """The film whose heat leaves with the oil.  Only this state is traced.

    Raises NoSolution where the load can not be carried, with what was tried, or where the rise passes 200 K.  Of a
    viscosity that no heat changes the film is then the one at 200 K, and its heat that of no balance.
    """

    @cache  # the ends of the bracket are asked for more than once, and the film of the answer
    def film_at(rise: float) -> Film:
        return route(seat, duty, rise)

    def excess(rise: float) -> float:
        return film_at(rise).temperature_rise - rise

    with untraced():
        try:
            low = _begins(excess)
            # warmer oil makes less heat: the rise ends below what colder oil made
            high = min(low + excess(low) + 1e-6, HOTTEST)
            rise = root(excess, low, _reachable(excess, low, high), tolerance=tolerance)
        except (FilmRangeError, Seized, OutsideBalance) as error:
            if not (isinstance(error, OutsideBalance) and error.end is None and seat.lubricant.constant):
                raise NoSolution(*_reason(seat, duty, error)) from None
            rise = math.inf
    lines = recorder.get() is not None
    return closed(route, seat, duty, rise) if lines or rise > HOTTEST else film_at(rise)


def closed(route: Route, seat: BearingCase, duty: OperatingPoint, rise: float) -> Film:
    """The film at the rise that closes its balance, by lines of the calculation; above 200 K, of a viscosity that no
    heat changes, the one at 200 K."""
    if rise > HOTTEST:
        return route(seat, duty, HOTTEST)
    return converged(f.closing_rise, rise, lambda known: route(seat, duty, known), lambda film: film.temperature_rise)


def _reason(seat: BearingCase, duty: OperatingPoint, error: ValueError) -> tuple[Text, Text, Text]:
    """What was looked for, what came out, and what to do: too much load, too little, or a bearing too short or long."""
    at = Text("{load} N at {speed} rpm", load=Amount(duty.load, form=".4g"), speed=Amount(duty.speed * 60, form=".4g"))
    if duty.effective_speed < duty.speed * (1 - 1e-9):
        dragged = Amount(duty.effective_speed * 60, form=".4g")
        at += Text(" (as dragged between load and surfaces, {effective_speed} rpm)", effective_speed=dragged)
    under, tried = Text("under {at}", at=at), text_of(error)
    if isinstance(error, OutsideBalance):
        advice = Text("lower the load, lengthen the bearing, give it less clearance, more oil or cooler oil")
        if not isinstance(error.end, FilmRangeError):
            advice = Text(
                "give it more clearance when warm (a larger clearance, a housing held back less), more oil, or cooler "
                "oil"
            )
        return Text("the heat of the film under {at} is not carried away", at=at), tried, advice
    if isinstance(error, Seized):
        return tried, under, Text("give it more clearance")
    if isinstance(error, FilmRangeError) and "l/d" in error.quantity:
        what = Text("the film of this bearing is not in the table ({error})", error=tried)
        advice = Text("choose a length between 0.1 and 2 diameters")
        if supply.lands(seat.inputs) == 2:
            what = Text("the film of the lands beside the groove is not in the table ({error})", error=tried)
            advice = Text(
                "a narrower groove or a longer bearing, so that each land is at least a tenth of the diameter long"
            )
        return what, under, advice
    if isinstance(error, FilmRangeError) and error.value > error.high:
        advice = Text("the load is too small for this clearance and oil: more clearance, or a thinner or warmer oil")
        return Text("the journal runs nearly centred under {at}", at=at), tried, advice
    advice = Text("lower the load, lengthen the bearing, or take a thicker oil")
    return Text("no film carries {at}", at=at), tried, advice


def _begins(excess: Callable[[float], float]) -> float:
    """A rise that has an answer with heat left over: none, else where oil that is too thick for the table has warmed
    enough."""
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
            if excess(above) > 0:
                return above
            middle = (below + above) / 2
            below, above = (below, middle) if _answers(excess, middle) else (middle, above)
        raise  # what the thick oil makes of heat is carried away before it is in the table


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
                raise OutsideBalance(
                    Text("the oil would warm by more than {hottest} K", hottest=Amount(HOTTEST, form="g"))
                )
        except (FilmRangeError, Seized) as gone:
            high, end = (low + high) / 2, gone
    raise OutsideBalance(Text("the film is gone before its heat and the oil's flow are in balance"), end)


def settled(
    seat: BearingCase[Any],
    duty: OperatingPoint[Any],
    *,
    warm: bool = True,
    hottest: float = HOTTEST,
    tolerance: float = 1e-7,
) -> Film[Array]:
    """The same for arrays: any number of `seat` and `duty` may be one, broadcast against the others.  nan where there
    is no film; of a viscosity that no heat changes the film at 200 K where more heat is left.

    Regula falsi after Anderson & Björck 1973 on all points that are not done; a point without film at the upper end of
    its bracket is closed in on from below.  `hottest`: no rise beyond is looked for."""
    seat, duty = unlinked(seat), unlinked(duty)
    route = own_warm if warm else own_cold
    shape = np.broadcast_shapes(*(np.shape(x) for x in _numbers(seat, duty)))
    seat, duty = _each(seat, duty, lambda x: np.broadcast_to(x, shape).ravel())
    every = np.arange(math.prod(shape))

    def film_at(rise: Array, some: IndexArray) -> Film[Array]:
        asked = (seat, duty) if some.size == every.size else _each(seat, duty, lambda x: x[some])
        return route(*asked, rise)

    def excess(rise: Array, some: IndexArray) -> Array:
        go_on()
        return np.asarray(film_at(rise, some).temperature_rise - rise)

    low, high = np.zeros(every.size), np.full(every.size, hottest)
    f_high, before = np.full(every.size, np.nan), np.zeros(every.size)
    rise = np.full(every.size, np.nan)
    with recorded(False), untraced(), np.errstate(all="ignore"):
        cold = film_at(low, every)
        f_low = np.array(cold.temperature_rise - low)
        opened = cold.clearance > 0  # a journal that is seized before it turns does not come to turn
        film = _over(cold, lambda _: np.full(every.size, np.nan))  # as it was last found at every point
        thick = every[~np.isfinite(f_low) & opened]
        low[thick], f_low[thick] = _first(excess, thick, hottest)
        live = every[f_low > 0]
        high[live] = np.minimum(low[live] + 2 * f_low[live] + 1e-6, hottest)
        f_high[live] = excess(high[live], live)
        short = live[f_high[live] > 0]
        high[short] = hottest
        if short.size:
            f_high[short] = excess(high[short], short)
        hotter = live[f_high[live] > 0]
        left = live[~(f_high[live] > 0)]
        for _ in range(ITERATION_LIMIT):
            if not left.size:
                break
            a, b, f_a, f_b = low[left], high[left], f_low[left], f_high[left]
            secant = b - f_b * (b - a) / (f_b - f_a)
            x = np.where((secant > a) & (secant < b), secant, 0.5 * (a + b))
            go_on()
            tried = film_at(x, left)
            _put(film, left, tried)
            f_x = tried.temperature_rise - x
            rise[left] = x
            up = f_x > 0  # the lower end moves up
            side = np.where(up, 1.0, -1.0)
            shrink = np.where(up, 1 - f_x / f_a, 1 - f_x / f_b)
            shrink = np.where(np.isfinite(shrink) & (shrink > 0), shrink, 0.5)
            shrink = np.where(side == before[left], shrink, 1.0)  # an end that stays twice has its value scaled down
            before[left] = side
            low[left], high[left] = np.where(up, x, a), np.where(up, b, x)
            f_low[left], f_high[left] = np.where(up, f_x, f_a * shrink), np.where(up, f_b * shrink, f_x)
            gone = ~np.isfinite(f_high[left]) & (high[left] - low[left] <= BREAKS_DOWN)
            left = left[~(gone | (np.abs(f_x) <= tolerance * (1 + x)) | (b - a <= tolerance))]
        unbalanced = np.zeros(every.size, dtype=bool)
        if hotter.size and seat.lubricant.constant and hottest == HOTTEST:
            rise[hotter], unbalanced[hotter] = HOTTEST, True
            _put(film, hotter, film_at(rise[hotter], hotter))
        there = np.abs(film.temperature_rise - rise) <= ALMOST * (1 + rise)
        there |= unbalanced
    return _over(film, lambda x: np.where(there, x, np.nan).reshape(shape))


def _first(excess: Callable[[Array, IndexArray], Array], thick: IndexArray, hottest: float) -> tuple[Array, Array]:
    """The same as `_begins` for all points whose oil is too thick without a rise, with their excess; not above zero:
    there is none."""
    above, f_above = np.full(thick.size, np.nan), np.full(thick.size, np.nan)
    for rise in (*(rise for rise in PROBES if rise < hottest), hottest):
        todo = np.flatnonzero(np.isnan(above))
        if not todo.size:
            break
        f = excess(np.full(todo.size, rise), thick[todo])
        above[todo], f_above[todo] = np.where(np.isfinite(f), rise, np.nan), f
    below = np.zeros(thick.size)
    # the balance lies below the probe: look for heat left over between there and where oil is too thick
    for _ in range(HALVINGS):
        todo = np.flatnonzero(f_above <= 0)
        if not todo.size:
            break
        middle = (below[todo] + above[todo]) / 2
        f = excess(middle, thick[todo])
        answers = np.isfinite(f)
        above[todo], f_above[todo] = np.where(answers, middle, above[todo]), np.where(answers, f, f_above[todo])
        below[todo] = np.where(answers, below[todo], middle)
    return above, f_above


def settled_together(asked: Sequence[tuple[BearingCase[Any], OperatingPoint[Any]]]) -> list[Film[Array]]:
    """`settled` for several questions about one bearing, or bearings of one size, in one call, each of its own length:
    all but the arrays is that of the first."""
    seat, duty = asked[0]
    sizes = [max(np.size(x) for x in _numbers(*question)) for question in asked]

    def joined(numbers: Iterable[Any]) -> Array:
        return np.concatenate([np.broadcast_to(x, (size,)) for x, size in zip(numbers, sizes)])

    clearance, factor = joined(s.clearance for s, _ in asked), joined(_factor(s) for s, _ in asked)
    varied = {name: joined(getattr(d, name) for _, d in asked) for name in vars(duty) if name != "sliding_ratio"}
    film = settled(replace(seat, clearance=clearance, viscosity_factor=factor), replace(duty, **varied))
    ends = np.cumsum(sizes).tolist()
    parts = [slice(end - size, end) for size, end in zip(sizes, ends)]
    return [_over(film, lambda x, part=part: x[part]) for part in parts]  # type: ignore[misc]


def _factor(seat: BearingCase[Any]) -> Any:
    return 1.0 if seat.viscosity_factor is None else seat.viscosity_factor


def _numbers(seat: BearingCase[Any], duty: OperatingPoint[Any]) -> tuple[Num, ...]:
    of_duty = duty.load, duty.speed, duty.supply_temperature, duty.supply_pressure
    return seat.bearing.diameter, seat.bearing.length, seat.clearance, _factor(seat), *of_duty


def _each(
    seat: BearingCase[Any], duty: OperatingPoint[Any], change: Callable[[Array], Array]
) -> tuple[BearingCase[Any], OperatingPoint[Any]]:
    """Case and operating point with their arrays changed; numbers stay."""

    def changed(x: Any) -> Any:
        return change(x) if np.ndim(x) else x

    seat = resized(seat, diameter=changed(seat.bearing.diameter), length=changed(seat.bearing.length))
    if seat.rings is not None:
        seat = replace(seat, rings=replace(seat.rings, outside=changed(seat.rings.outside)))
    asked = {name: changed(x) for name, x in vars(duty).items()}
    factor = None if seat.viscosity_factor is None else changed(seat.viscosity_factor)
    return replace(seat, clearance=changed(seat.clearance), viscosity_factor=factor), OperatingPoint(**asked)


def _put(film: Film[Array], some: IndexArray, found: Film[Array]) -> None:
    """Write what was found at some points into the arrays of a film."""
    for of, more in ((film, found), (film.oil, found.oil)):
        for name, x in vars(of).items():
            if isinstance(x, np.ndarray):
                x[some] = getattr(more, name)


def _over(film: Film[Array], change: Callable[[Array], Array]) -> Film[Array]:
    """A film with its arrays changed, those of its oil too; what it does not have stays None."""
    numbers = {name: change(x) for name, x in vars(film).items() if name != "oil" and x is not None}
    return Film(oil=OilState(*(change(x) for x in vars(film.oil).values())), **numbers)
