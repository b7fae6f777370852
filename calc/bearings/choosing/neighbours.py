# SPDX-License-Identifier: Apache-2.0
"""Why not one step further: the neighbours of a row, each with the rule that refuses it, or with what it costs."""

import math

from ...sheet.record import record
from ...sheet.units import Metre
from .grid import CLEARANCE_STEP
from .ranking import Pick, Row, Slopes, picks
from .states import Task
from .variants import HALF_MILLIMETRE, PLACES, Variant, thinner


@record
class Neighbour:
    """One bearing of a row with one thing changed."""

    place: str
    change: str
    instead: Pick
    of: Pick


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
            found.append(Neighbour(place, f"{what} {now / factor:.6g} → {to / factor:.6g} {unit}", pick, one))
        oil = thinner(list(variants), row.variant, one.task.duty.supply_temperature)
        if oil is not None:
            task = one.task.with_oil(oil.lubricant, oil.supply)
            found.append(Neighbour(place, f"oil {oil.oil}", picks(task, [l], [g], slopes[place])[0], one))
    return found


def _below(number: Metre, step: Metre) -> Metre:
    """The next whole step that is more than half of one below."""
    return round(math.floor(number / step - 0.5 - 1e-6) * step, 12)
