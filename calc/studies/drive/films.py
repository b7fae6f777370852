# SPDX-License-Identifier: Apache-2.0
"""One journal over diameter, length and clearance: what it rubs, and the slope that its film still bears.

The films and the rules are those of the search for bearings, in its states at the corners of the tolerances.  Only the film at the edge
knows the slope, and it does so in closed form: h − θ·l/2 ≥ (1 + margin)·h_K.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ...bearings import formulas as f
from ...bearings.routes import supply
from ...bearings.routes.states import OperatingPoint
from ...bearings.selection.grid import FEW, KEPT, LENGTH_STEP, OF_FILM, WIDEST, clearances, field_over, widest_usual
from ...bearings.selection.states import Task, judge
from ...bearings.selection.variants import SUPPLIES, Variant
from ...bearings.speeds import at_speeds
from ...library.journal_rules import SUPPLY_WIDTH
from ...sheet.arrays import Array, BoolArray
from ...sheet.record import record
from ...sheet.search import multiples
from ...sheet.units import Metre, Number, Radian
from ...optimise.other_films import Beside, over_a_turn, over_speeds

ALWAYS = ("temperature", "specific_load", "heat_index", "length_ratio", "transition")  # rules that do not know the slope


@record
class Films:
    """One journal at one diameter; arrays: clearances down, lengths across.

    `power` as given; `once` and `twice`: thinnest film of all corners, at the load and at twice the load; `kept`: every rule that knows
    neither slope nor margin.
    """

    task: Task
    length: Array  # (n,)
    clearance: Array  # (m,)
    power: Array
    once: Array
    twice: Array
    kept: BoolArray
    double: Metre  # what the film must keep at twice the load
    turn: Array | None = None  # thinnest film over a turn with what stands still; None: it binds nothing
    speeds: Array | None = None  # the same over the speeds, which margins are not counted of

    def bears(self, h_K: Metre, margin: Number, limit: Radian) -> Array:
        """The slope that each candidate bears with a margin on all its films and on the slope itself; −∞ where it bears none."""
        thinnest = self.once if self.turn is None else np.minimum(self.once, self.turn)
        slope = np.minimum(2 * (thinnest - (1 + margin) * h_K) / self.length, (1 - margin) * limit)
        if self.speeds is not None:
            slope = np.minimum(slope, 2 * (self.speeds - h_K) / self.length)
        bearing: Array = np.where(self.kept & (self.twice >= (1 + margin) * self.double * (1 + KEPT)) & (slope >= 0), slope, -np.inf)
        return bearing


def asked_film(task: Task, surfaces: tuple[Metre, Metre]) -> Metre:
    """The film that keeps the peaks of both surfaces apart, with what the cubic between lengths may be off."""
    return f.kreisle_film(k_R=task.seat.inputs.roughness_ratio, Ra_1=surfaces[0], Ra_2=surfaces[1]) * (1 + KEPT)


Cycle = Sequence[tuple[float, float]]
NOTHING = Beside()


def films(task: Task, variant: Variant, length: Array, advice: Sequence[str], cycle: Cycle = (), beside: Beside = NOTHING) -> Films | None:
    """`task` at its diameter with its oil, supply and fits; `advice`: names of findings that are limits.  None: no candidate is left.

    `cycle`: speeds over the rated one with their shares, over which the power is a mean; `beside`: films that are limits beside.

    Clearances up to the usual factor; where none of these has a film that passes, up to the widest of the search for bearings.
    """
    found = _films(task, variant, length, clearances(task, widest_usual(task)), advice, beside)
    if found is None or not found.kept.any():
        found = _films(task, variant, length, clearances(task, WIDEST * task.diameter, FEW), advice, beside)
    return found if found is None or not cycle else replace(found, power=_mean_power(found, variant, cycle))


def _mean_power(found: Films, variant: Variant, cycle: Cycle) -> Array:
    """Over the cycle, with the oil as it is supplied at the rated speed; not a number where a speed has no film."""
    task, mean = found.task, np.zeros(found.power.shape)
    for ratio, share in cycle:
        duty = task.duty
        at = at_speeds(
            task.seat, duty.speed, duty, each_of(duty.speed * ratio), each_of(duty.supply_temperature), each_of(duty.supply_pressure)
        )
        slower = replace(task, duty=OperatingPoint(**{name: float(np.ravel(x)[0]) for name, x in vars(at).items()}), corners=False)
        field = field_over(slower, variant, found.length, found.clearance)
        assert field is not None
        mean += share * np.broadcast_to(field.states.power, mean.shape)
    return np.where(np.isnan(mean), np.inf, mean)


def each_of(number: float) -> Array:
    return np.array([number])


def _films(task: Task, variant: Variant, length: Array, g: Array, advice: Sequence[str], beside: Beside) -> Films | None:
    field = field_over(task, variant, length, g)
    if field is None:
        return None
    states = field.states
    once = sum(state.times == 1 for state in task.states)
    wanted = (*ALWAYS, *(key for key in task.rules if key in advice))
    with np.errstate(all="ignore"):
        judged = {one.rule.key: one.margin for one in judge(task, states, 0.0) if one.rule.key in wanted}
    shape = states.film.shape[1:]
    kept = np.ones(shape, dtype=bool)
    for key, margin in judged.items():
        kept &= np.broadcast_to(margin, shape) >= (KEPT if key in OF_FILM else 0.0)
    if "supply_range" in advice and (width := _supply_width(task)) is not None:
        kept &= (width / length >= SUPPLY_WIDTH[0]) & (width / length <= SUPPLY_WIDTH[1])
    thin, thin_twice = (np.where(np.isnan(x), -np.inf, x).min(axis=0) for x in (states.film[:once], states.film[once:]))
    turn = speeds = None
    if beside.standing is not None:
        turn = np.where(np.isnan(film := over_a_turn(task, length, g, beside.standing)), np.inf, film)
    if beside.bench is not None:
        speeds = over_speeds(task, variant, length, g, thin, beside.bench)
    return Films(
        task, length, g, np.broadcast_to(states.power, shape), thin, thin_twice, kept, f.trumpler_film(d=task.diameter), turn, speeds
    )


def lengths(task: Task, longest: Metre, ratios: tuple[Number, Number]) -> Array:
    """Whole steps within l/d `ratios`, those of each land where a groove parts the film, and up to the longest that the sectors leave."""
    inputs, d, shortest = task.seat.inputs, task.diameter, least_length(task)
    lands = supply.lands(inputs)
    lost = (inputs.groove_width or 0.0) if lands == 2 else 0.0
    low, high = (lands * ratio * d + lost for ratio in ratios)
    return multiples(LENGTH_STEP, max(low, shortest), min(high, longest))


def least_length(task: Task) -> Metre:
    """A step more than whatever the design has the width of."""
    inputs = task.seat.inputs
    return max(getattr(inputs, name) or 0.0 for name in (*SUPPLIES.values(), "axial_groove_length")) + LENGTH_STEP


def _supply_width(task: Task) -> Metre | None:
    """Of hole or pocket; None of a groove."""
    inputs = task.seat.inputs
    width: Metre | None = getattr(inputs, SUPPLIES[inputs.supply])
    return None if inputs.supply == "groove" else width
