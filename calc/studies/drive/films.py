# SPDX-License-Identifier: Apache-2.0
"""One journal over diameter, length and clearance: what it rubs, and the slope that its film still bears.

The films and the rules are those of the search for bearings, in its states at the corners of the tolerances.  Only the
film at the edge knows the slope, and it does so in closed form: h − θ·l/2 ≥ (1 + margin)·h_K.

The load of a journal is that of the shaft the class starts from.  Each shaft bends otherwise, and what its own mass
adds to the load is another: up to 0.1 % of the load, and 0.03 % of the power."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ...bearings.plain import formulas as f
from ...bearings.plain.checks import SPECIFIC_LOAD, SUPPLY_RANGE, TEMPERATURE
from ...bearings.plain.film import dynamics as d
from ...bearings.plain.film.dynamics import Dynamics, coefficients, orbit
from ...bearings.plain.film.table import FilmRangeError
from ...bearings.plain.loads import SMALL
from ...bearings.plain.routes import supply
from ...bearings.plain.routes.states import BearingCase, Film, OperatingPoint, resized
from ...bearings.plain.routes.thermal_balance import settled
from ...bearings.plain.selection.grid import KEPT, LENGTH_STEP, OF_FILM, clearances, field_over, over_lengths
from ...bearings.plain.selection.states import BALANCED, HOT, BearingTask, judge
from ...bearings.plain.selection.variants import SUPPLIES, Variant
from ...bearings.plain.speeds import at_speeds, sweep_points
from ...bearings.plain.suitability import MATERIAL_LOAD, film_asked
from ...engine.operation import BenchPoint
from ...library.journal_rules import SUPPLY_WIDTH
from ...sheet.arrays import Array, BoolArray
from ...sheet.check import CheckRule
from ...sheet.record import record, replace
from ...sheet.search import multiples
from ...sheet.units import Metre, Newton, Number, Radian, Watt

# --- films beside those of the corners: over the speeds of the engine, and over a turn with what stands still
# What stands still is weight and gear force.
#
# Both are those of the nominal clearance.  Where they are thinner than at the corners, they say what slope a journal
# bears.

# of the film at the corners: speeds whose film is thicker than that at a few sizes are not looked at; rule of this
# program
NEAR = 1.05


@record
class Stands:
    """What stands still on a bearing of one shaft: of its weight and of its gear, whose force goes with the power of
    the journals."""

    weight: Newton
    gear: Newton
    power: Watt  # of this journal

    def at(self, power: Array) -> Array:
        """With another power of it, the other journal's in proportion."""
        load: Array = self.weight + self.gear * power / self.power
        return load


@record
class Beside:
    """`bench`: rows of the engine, None: films over the speeds are no limit; `standing`: what stands still, None:
    likewise."""

    bench: tuple[BenchPoint, ...] | None = None
    standing: Stands | None = None


def over_speeds(
    task: BearingTask, variant: Variant, length: Array, g: Array, corners: Array, bench: tuple[BenchPoint, ...]
) -> Array | None:
    """The thinnest film over the speeds that govern; None where that of the corners is thinner at every one of a few
    sizes."""
    rows, columns = (np.unique(np.linspace(0, n - 1, 2).astype(int)) for n in (g.size, length.size))
    seat, at = sweep_points(task.seat, task.duty.speed, bench, task.duty)
    rated = task.duty.speed if task.seat.inputs.speed_range is None else np.inf
    governs = at.speed <= rated * (1 + 1e-9)
    sizes = _sized(seat, length[columns][None, :, None], g[rows][:, None, None])
    with np.errstate(all="ignore"):
        films = np.where(governs, settled(sizes, at, hottest=HOT, tolerance=BALANCED).film, np.nan)
    films = np.where(np.isnan(films), np.inf, films)
    held = corners[np.ix_(rows, columns)]
    near = np.isfinite(films.min(-1)) & (films.min(-1) < NEAR * held) & np.isfinite(held)
    if not near.any():
        return None
    thinnest = np.full(corners.shape, np.inf)
    for n in np.unique(films.argmin(-1)[near]).tolist():
        point = OperatingPoint(**{name: float(np.broadcast_to(x, governs.shape)[n]) for name, x in vars(at).items()})
        field = field_over(replace(task, duty=point, corners=False), variant, length, g)
        assert field is not None
        film = np.broadcast_to(field.states.film[0], corners.shape)
        thinnest = np.fmin(thinnest, film)
    return thinnest


def over_a_turn(task: BearingTask, length: Array, g: Array, stands: Stands) -> Array:
    """The film over the orbit, as bearings/loads.py has it; where that is not known, under the largest load of
    the turn."""
    few, between = over_lengths(length)
    seat = _sized(task.seat, few[None, :], g[:, None])
    duty: OperatingPoint[Any] = task.duty
    load = duty.load
    with np.errstate(all="ignore"):
        film = settled(seat, duty, hottest=HOT, tolerance=BALANCED)
        standing = np.where(np.isfinite(film.film), stands.at(film.friction_power), 0.0)
        over = _over_orbit(film, task, seat, np.broadcast_to(few, standing.shape), standing)
        over = np.where(standing < SMALL * load, over, np.nan)
        if (unknown := np.isnan(over) & np.isfinite(film.film)).any():
            peak = settled(seat, replace(duty, load=load + standing), hottest=HOT, tolerance=BALANCED)
            over = np.where(unknown, peak.film, over)
    return between(over)


def _over_orbit(film: Film[Array], task: BearingTask, seat: BearingCase[Any], length: Array, standing: Array) -> Array:
    """Not a number where there is no film, or none of which stiffness and damping are known."""
    inputs, duty = seat.inputs, task.duty
    there = np.isfinite(film.film)
    over = np.full(there.shape, np.nan)
    eps, phi, h_0, g = (
        np.broadcast_to(x, there.shape)[there]
        for x in (film.eccentricity, film.attitude if film.attitude is not None else np.nan, film.film, film.clearance)
    )
    bare = supply.bare_length(inputs, length[there])
    ratio = f.length_ratio(l=bare / 2 if supply.lands(inputs) == 2 else bare, d=task.diameter)
    try:
        k = coefficients(eps, ratio, phi)
    except FilmRangeError:
        return over
    F, omega = duty.load, f.angular_speed(n=duty.effective_speed)
    across = d.damping_xy(c_xy=k.c_xy, F=F, g=g, omega=omega)
    moving = Dynamics(
        stiffness_xx=d.stiffness_xx(k_xx=k.k_xx, F=F, g=g),
        stiffness_xy=d.stiffness_xy(k_xy=k.k_xy, F=F, g=g),
        stiffness_yx=d.stiffness_yx(k_yx=k.k_yx, F=F, g=g),
        stiffness_yy=d.stiffness_yy(k_yy=k.k_yy, F=F, g=g),
        damping_xx=d.damping_xx(c_xx=k.c_xx, F=F, g=g, omega=omega),
        damping_xy=across,
        damping_yx=across,
        damping_yy=d.damping_yy(c_yy=k.c_yy, F=F, g=g, omega=omega),
    )
    over[there] = f.film_over_turn(h_0=h_0, a_n=orbit(moving, standing[there], phi, duty, seat).film_loss)
    return over


def _sized(seat: BearingCase[Any], l: Array, g: Array) -> BearingCase[Any]:
    return replace(resized(seat, length=l), clearance=g)


# --- the films at the corners, and what they bear

# rules that do not know the slope
ALWAYS = (TEMPERATURE, SPECIFIC_LOAD, MATERIAL_LOAD)


@record
class StandingTask:
    """A bearing that stays as it is and runs on no film: what it takes of the shaft, and what passes its seat."""

    place: str
    diameter: Metre
    opening: Metre


@record
class Films:
    """One journal at one diameter; arrays: clearances down, lengths across.

    `power` as given; `once`: thinnest film of all corners; `twice`: that at twice the load, as given; `kept`: every
    rule that knows neither slope nor margin."""

    task: "BearingTask | StandingTask"
    length: Array  # (n,)
    clearance: Array  # (m,)
    power: Array
    once: Array
    twice: Array
    kept: BoolArray
    double: Metre  # what the film must keep at twice the load
    turn: Array | None = None  # thinnest film over a turn with what stands still; None: it binds nothing
    speeds: Array | None = None  # the same over the speeds, which margins are not counted of

    @property
    def opening(self) -> Metre:
        """What passes its seat."""
        return self.task.opening if isinstance(self.task, StandingTask) else self.task.diameter

    def bears(self, h_K: Metre, margin: Number, limit: Radian) -> Array:
        """The slope that each candidate bears with a margin on all its films and on the slope itself; −∞ where it bears
        none."""
        thinnest = self.once if self.turn is None else np.minimum(self.once, self.turn)
        slope = np.minimum(2 * (thinnest - (1 + margin) * h_K) / self.length, (1 - margin) * limit)
        if self.speeds is not None:
            slope = np.minimum(slope, 2 * (self.speeds - h_K) / self.length)
        bearing: Array = np.where(
            self.kept & (self.twice >= (1 + margin) * self.double * (1 + KEPT)) & (slope >= 0), slope, -np.inf
        )
        return bearing


def without_film(task: StandingTask, length: Metre, power: Watt) -> Films:
    """Of a bearing that stays as it is: one size that bears every slope which a journal may have."""
    one, endless = np.ones((1, 1)), np.full((1, 1), np.inf)
    return Films(task, np.array([length]), np.zeros(1), power * one, endless, endless, one > 0, 0.0)


def asked_film(task: BearingTask | StandingTask, surfaces: tuple[Metre, Metre]) -> Metre:
    """The film that keeps the peaks of both surfaces apart, with what the cubic between lengths may be off."""
    if isinstance(task, StandingTask):
        return 0.0
    return film_asked(task.seat.inputs, *surfaces) * (1 + KEPT)


Cycle = Sequence[tuple[float, float]]
NOTHING = Beside()


def films(
    task: BearingTask,
    variant: Variant,
    length: Array,
    advice: Sequence[CheckRule],
    cycle: Cycle = (),
    beside: Beside = NOTHING,
) -> Films | None:
    """`task` at its diameter with its oil, supply and fits; `advice`: findings that are limits.  None: no
    candidate is left.

    `cycle`: speeds over the rated one with their shares, over which the power is a mean; `beside`: films that are
    limits beside.

    Clearances are those of the search for bearings."""
    result = _films(task, variant, length, clearances(task), advice, beside)
    return result if result is None or not cycle else replace(result, power=_mean_power(result, variant, cycle))


def _mean_power(films: Films, variant: Variant, cycle: Cycle) -> Array:
    """Over the cycle, with the oil as it is supplied at the rated speed; not a number where a speed has no film."""
    task, mean = films.task, np.zeros(films.power.shape)
    assert isinstance(task, BearingTask)
    for ratio, share in cycle:
        duty = task.duty
        at = at_speeds(
            task.seat,
            duty.speed,
            duty,
            each_of(duty.speed * ratio),
            each_of(duty.supply_temperature),
            each_of(duty.supply_pressure),
        )
        slower = replace(
            task, duty=OperatingPoint(**{name: float(np.ravel(x)[0]) for name, x in vars(at).items()}), corners=False
        )
        field = field_over(slower, variant, films.length, films.clearance)
        assert field is not None
        mean += share * np.broadcast_to(field.states.power, mean.shape)
    return np.where(np.isnan(mean), np.inf, mean)


def each_of(number: float) -> Array:
    return np.array([number])


def _films(
    task: BearingTask, variant: Variant, length: Array, g: Array, advice: Sequence[CheckRule], beside: Beside
) -> Films | None:
    field = field_over(task, variant, length, g)
    if field is None:
        return None
    # of twice the load no corner is asked for
    doubled = field_over(replace(task.under(2 * task.duty.load), corners=False), variant, length, g)
    assert doubled is not None
    states = field.states
    once = sum(not state.beside for state in task.states)
    wanted = (*ALWAYS, *advice)
    with np.errstate(all="ignore"):
        judged = {
            finding.rule.declared: finding.margin
            for finding in judge(task, states, 0.0)
            if finding.rule.declared in wanted
        }
    shape = states.film.shape[1:]
    kept = np.ones(shape, dtype=bool)
    for rule, margin in judged.items():
        kept &= np.broadcast_to(margin, shape) >= (KEPT if rule in OF_FILM else 0.0)
    if SUPPLY_RANGE in advice and (width := _supply_width(task)) is not None:
        kept &= (width / length >= SUPPLY_WIDTH[0]) & (width / length <= SUPPLY_WIDTH[1])
    thin, thin_twice = (
        np.where(np.isnan(x), -np.inf, x).min(axis=0) for x in (states.film[:once], doubled.states.film[:1])
    )
    turn = speeds = None
    if beside.standing is not None:
        turn = np.where(np.isnan(film := over_a_turn(task, length, g, beside.standing)), np.inf, film)
    if beside.bench is not None:
        speeds = over_speeds(task, variant, length, g, thin, beside.bench)
    return Films(
        task,
        length,
        g,
        np.broadcast_to(states.power, shape),
        thin,
        thin_twice,
        kept,
        f.trumpler_film(d=task.diameter),
        turn,
        speeds,
    )


def lengths(task: BearingTask, longest: Metre, ratios: tuple[Number, Number]) -> Array:
    """Whole steps within l/d `ratios`, those of each land where a groove parts the film, and up to the longest that the
    sectors leave."""
    inputs, d, shortest = task.seat.inputs, task.diameter, least_length(task)
    lands = supply.lands(inputs)
    lost = (inputs.groove_width or 0.0) if lands == 2 else 0.0
    low, high = (lands * ratio * d + lost for ratio in ratios)
    return multiples(LENGTH_STEP, max(low, shortest), min(high, longest))


def least_length(task: BearingTask) -> Metre:
    """A step more than whatever the design has the width of."""
    return task.seat.inputs.widest_supply + LENGTH_STEP


def _supply_width(task: BearingTask) -> Metre | None:
    """Of hole or pocket; None of a groove."""
    inputs = task.seat.inputs
    width: Metre | None = getattr(inputs, SUPPLIES[inputs.supply])
    return None if inputs.supply == "groove" else width
