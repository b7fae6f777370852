# SPDX-License-Identifier: Apache-2.0
"""The thermal balance of very many candidates, each only as far as a choice asks for it.

A rise far beyond what may be chosen is not closed in on: such a candidate has no film here.  Points that are done are not solved again.
"""

from dataclasses import replace
from typing import Any

import numpy as np

from ...sheet.trace import untraced
from ...sheet.units import Kelvin
from ..routes.routes import own_warm
from ..routes.states import Duty, Film, Seat

HOTTEST: Kelvin = 45.0  # three times the rise that may be chosen: what lies between is still needed to draw a curve through
ITERATION_LIMIT = 40
ALMOST = 1e-3  # relative, of a rise: what is closed in on to no more has no balance


def closed(seat: Seat, duty: Duty, tolerance: float) -> Film:
    """Film of all points at their rise; nan where there is none up to the hottest.

    Regula falsi between no rise and the hottest.  Without an answer at the cold end (oil so thick that the journal is centred) the bracket
    is halved upwards, without one at the hot end (the film is gone) downwards.
    """
    l, g, factor, load = np.broadcast_arrays(seat.bearing.length, seat.clearance, seat.viscosity_factor, duty.load)  # type: ignore[arg-type]
    shape, flat = l.shape, [x.ravel() for x in (l, g, factor, load)]

    def film(rise: Any, some: Any) -> Film:
        length, clearance, thick, force = (x[some] for x in flat)
        at = replace(seat, bearing=replace(seat.bearing, length=length), clearance=clearance, viscosity_factor=thick)
        return own_warm(at, replace(duty, load=force), rise)

    def excess(rise: Any, some: Any) -> Any:
        made: Any = film(rise, some).temperature_rise
        return made - rise

    every = np.arange(l.size)
    low, high = np.zeros(l.size), np.full(l.size, HOTTEST)
    with untraced(), np.errstate(all="ignore"):
        f_low = excess(low, every)
        high = np.where(f_low > 0, np.minimum(2 * f_low + 1e-6, HOTTEST), HOTTEST)
        f_high = excess(high, every)
        cold = np.isfinite(f_low)
        lost = ~(cold | np.isfinite(f_high)) | (f_high > 0) | (f_low <= 0)
        side = np.zeros(l.size)
        rise = np.where(lost, np.nan, 0.0)
        left = every[~lost]
        for _ in range(ITERATION_LIMIT):
            if not left.size:
                break
            a, b, f_a, f_b = low[left], high[left], f_low[left], f_high[left]
            secant = b - f_b * (b - a) / (f_b - f_a)
            x = np.where((secant > a) & (secant < b), secant, 0.5 * (a + b))
            f_x = excess(x, left)
            rise[left] = x
            up = np.where(np.isfinite(f_x), f_x > 0, ~cold[left])  # the lower end moves up
            shrink = np.where(up, 1 - f_x / f_a, 1 - f_x / f_b)
            shrink = np.where(np.isfinite(shrink) & (shrink > 0), shrink, 0.5)
            shrink = np.where(side[left] == np.where(up, 1.0, -1.0), shrink, 1.0)  # an end that stays twice has its value scaled down
            side[left] = np.where(up, 1.0, -1.0)
            low[left], high[left] = np.where(up, x, a), np.where(up, b, x)
            f_low[left], f_high[left] = np.where(up, f_x, f_a * shrink), np.where(up, f_b * shrink, f_x)
            done = (np.abs(f_x) <= tolerance * (1 + x)) | (b - a <= tolerance)
            left = left[~done]
        made = film(rise, every)
        balance: Any = made.temperature_rise
        there = np.abs(balance - rise) <= ALMOST * (1 + rise)

    def shaped(numbers: Any) -> Any:
        return np.where(there, numbers, np.nan).reshape(shape)

    numbers: dict[str, Any] = {n: shaped(getattr(made, n)) for n in ("film", "temperature_rise", "friction_power", "oil_flow")}
    return replace(made, oil=replace(made.oil, mu=shaped(made.oil.mu)), **numbers)
