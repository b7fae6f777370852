# SPDX-License-Identifier: Apache-2.0
"""The friction of a journal over a turn, where a standing load passes under the one that turns with it.

The load of the moment runs from F − R_0 to F + R_0; to second order in R_0/F the mean over a turn needs the slope and the curvature of
the friction over the load, which the own solution gives at loads a little below and above.
"""

from dataclasses import replace

import numpy as np

from ..sheet.arrays import each, many, one
from ..sheet.formula import formula
from ..sheet.record import record
from ..sheet.units import MetrePerSecond, Newton, Watt
from ..sheet.value import based_on
from .routes.balance import settled
from .routes.states import BearingCase, Film, OperatingPoint

APART = 0.05  # of the load: how far below and above
SECOND_ORDER = 0.5  # of the load: up to here a standing load counts as small


@formula(
    "P_f'", "mathematics: slope of the friction over the load, from the own solution beside it", shows="[P_f(1.05·F) − P_f(0.95·F)]/(0.1·F)"
)
def slope(P_below: Watt, P_above: Watt, F: Newton) -> MetrePerSecond:
    return (P_above - P_below) / (2 * APART * F)


@formula("F·P_f''", "mathematics: curvature of the friction, the same way", shows="[P_f(1.05·F) − 2·P_f(F) + P_f(0.95·F)]/(0.05²·F)")
def curvature(P_below: Watt, P_f: Watt, P_above: Watt, F: Newton) -> MetrePerSecond:
    return (P_above - 2 * P_f + P_below) / (APART**2 * F)


@formula(
    "P_f", "mathematics: mean over a turn under turning and standing load, each moment as if it stayed; second order in R_0/F",
    names={"P": "P_f,F", "S": "P_f'", "K": "(F·P_f'')"},
)  # fmt: skip
def over_a_turn(P: Watt, R_0: Newton, F: Newton, S: MetrePerSecond, K: MetrePerSecond) -> Watt:
    return P + R_0**2 / (4 * F) * (S + K)


@record
class Response:
    """How the friction of a journal answers to its load: of one operating point, or of many."""

    load: Newton
    friction_power: Watt
    slope: MetrePerSecond
    curvature: MetrePerSecond

    def power(self, R_0: Newton) -> Watt:
        return over_a_turn(P=self.friction_power, R_0=R_0, F=self.load, S=self.slope, K=self.curvature)


def loads_beside(seat: BearingCase, duty: OperatingPoint) -> tuple[BearingCase, OperatingPoint]:
    """A little less load, the load itself and a little more, along a last axis of their own; the duty's numbers may be arrays."""
    about = np.array((1 - APART, 1.0, 1 + APART))
    loads = (many(duty.load)[..., None] if np.ndim(duty.load) else duty.load) * about
    others = {name: each(many(x)[..., None]) if np.ndim(x) else x for name, x in vars(duty).items() if name != "load"}
    return seat, replace(duty, load=each(loads), **others)


def answered(film: Film, duty: OperatingPoint, friction_power: Watt | None = None) -> Response:
    """The answer at a duty, from the films at `loads_beside`.  `friction_power`: at that duty, where it is known; nan: no film is found."""
    power = many(film.friction_power)
    below, at, above = (each(power[..., i]) if power.ndim > 1 else one(power[i]) for i in range(3))
    P_f = at if friction_power is None else friction_power
    below, at, above = (based_on(P, friction_power, duty.load) for P in (below, at, above))  # found alike, of the same numbers
    return Response(load=duty.load, friction_power=P_f, slope=slope(P_below=below, P_above=above, F=duty.load),
        curvature=curvature(P_below=below, P_f=at, P_above=above, F=duty.load))  # fmt: skip


def response(seat: BearingCase, duty: OperatingPoint, friction_power: Watt | None = None) -> Response:
    """The answer at a duty, whose numbers may be arrays; `friction_power` as above."""
    return answered(settled(*loads_beside(seat, duty)), duty, friction_power)
