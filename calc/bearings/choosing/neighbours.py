# SPDX-License-Identifier: Apache-2.0
"""Why not one step further: the neighbours of a row, each with the rule that refuses it, or with what it costs."""

import math
from dataclasses import replace

from ...sheet.number import short
from ...sheet.record import record
from ...sheet.units import Metre, Watt
from .grid import CLEARANCE_STEP, SAME, USUAL_FACTORS, WIDEST, widest_usual
from .ranking import Pick, Row, Slopes, picks
from .states import Task
from .variants import HALF_MILLIMETRE, PLACES, Variant, thinner


@record
class Neighbour:
    """One bearing of a row with one thing changed, or both with another oil.  `more`: the power that it costs."""

    place: str
    change: str
    instead: Pick
    of: Pick
    more: Watt
    oil: str = ""


def neighbours(row: Row, tasks: dict[str, list[Task]], variants: tuple[Variant, ...], slopes: Slopes) -> list[Neighbour]:
    """Of each bearing: one step shorter, one tighter, one wider, and the next thinner oil."""
    found = []
    for place, one in zip(PLACES, row.both):
        l, g = one.length, one.clearance
        steps = (
            ("length", l, _below(l, HALF_MILLIMETRE), 1e-3, "mm"),
            ("clearance", g, _below(g, CLEARANCE_STEP), 1e-6, "µm"),
            ("clearance", g, -_below(-g, CLEARANCE_STEP), 1e-6, "µm"),
        )
        sizes = [(to if what == "length" else l, to if what == "clearance" else g) for what, _, to, _, _ in steps]
        kept = [n for n, size in enumerate(sizes) if min(size) > 0]
        made = picks(one.task, [sizes[n][0] for n in kept], [sizes[n][1] for n in kept], slopes[place])
        for n, pick in zip(kept, made):
            what, now, to, factor, unit = steps[n]
            found.append(Neighbour(place, f"{what} {short(now / factor)} → {short(to / factor)} {unit}", pick, one, pick.power - one.power))
    oil = thinner(list(variants), replace(row.variant, fits=None), row.front.task.duty.supply_temperature)
    if oil is not None:  # in both bearings, which share it; the worse of them says
        both = []
        for place, one in zip(PLACES, row.both):
            task = one.task.with_oil(oil.lubricant, oil.supply)
            pick = picks(task, [one.length], [one.clearance], slopes[place])[0]
            both.append(Neighbour(place, "oil", pick, one, pick.power - one.power))
        worse = min(both, key=lambda n: n.instead.margin)
        found.append(replace(worse, place="both", change=f"oil {oil.oil}", more=sum(n.more for n in both), oil=oil.oil))
    return found


def outside(one: Neighbour) -> str:
    """Which bound of the search the step passes; empty: none."""
    to, of = one.instead, one.of
    if one.oil or to.clearance <= of.clearance:
        return ""
    usual = widest_usual(of.task)
    if of.clearance <= usual + SAME:
        return f"K ≤ {USUAL_FACTORS[1]:g}" if to.clearance > usual + SAME else ""
    return f"≤ {WIDEST * 1e3:g} ‰" if to.clearance > WIDEST * of.diameter + SAME else ""


def _below(number: Metre, step: Metre) -> Metre:
    """The next whole step that is more than half of one below."""
    return round(math.floor(number / step - 0.5 - 1e-6) * step, 12)
