# SPDX-License-Identifier: Apache-2.0
"""What a bearing that is offered has to keep, at the worst corner of its tolerances.

The limits are those of the step's own checks, read off the checks of the design itself and written nowhere again.  Three are kept for
choosing alone: the rise of temperature, the cold clearance that must be left, and Trumpler's film at the edge too.
The relative clearance that is usual for the application is kept wherever film, heat and cold clearance leave something with it.
"""

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from ...library.journal_rules import RISE
from ...sheet.check import Check
from ...sheet.record import record
from ...sheet.search import Judged, judged
from ...sheet.text import Text
from ...sheet.units import UNITS, Metre
from .words import PLACE

LEAST_COLD: Metre = 20e-6
OWN = Text("rule of this program for choosing")
RISES = Text("Finotti 2013, 5.5.2: 15 to 20 °C; for choosing the lower")
READ = ("film_edge", "film_double_load", "temperature", "specific_load", "heat_index", "length_ratio", "length_ratio_usual", "transition",
        "clearance_cold_corner")  # fmt: skip
USUAL = "clearance_usual"  # advice, and known of most applications only

Index = int | tuple[np.intp, ...]  # of one of many candidates


@record
class Rule:
    """One constraint: the check that it is taken from, or made of."""

    key: str
    check: Check

    def on(self, value: float, limit: float | None = None, where: object = -1) -> Judged:
        """Candidates by this rule, from values in SI; `limit`, in SI as well, where it is that of each candidate.  `where`: the index of
        the task's state that governs, or its name; −1: it has none."""
        units = UNITS[self.check.unit]
        bound = self.check.limit if limit is None else units.all_shown(limit)
        return judged(self, np.asarray(units.all_shown(value)), bound, self.check.sense, where)


def check_of(one: Judged, index: Index) -> Check:
    """The check of one candidate."""
    limit = one.limit if isinstance(one.limit, tuple) else float(np.broadcast_to(one.limit, one.margin.shape)[index])
    judged_one: Check = replace(one.rule.check, value=float(np.broadcast_to(one.value, one.margin.shape)[index]), limit=limit)
    return judged_one


def rules(place: str, checks: Iterable[Check]) -> dict[str, Rule]:
    """The constraints of one bearing, by their key, from the checks of a solved design."""
    at, known = f"bearings.{place}", {c.id: c for c in checks}
    edge, doubled, hot, cold = (known[f"{at}.{key}"] for key in ("film_edge", "film_double_load", "temperature", "clearance_cold"))
    trumpler = Text("Film at the edge by Trumpler, {place}", place=PLACE[place])
    rise = Text("Temperature rise, {place}", place=PLACE[place])
    own = {
        "film_edge_trumpler": replace(doubled, id=f"{at}.film_edge_trumpler", name=trumpler, advice=edge.advice),
        "temperature_rise": replace(hot, id=f"{at}.temperature_rise", name=rise, limit=RISE[0], unit="K", source=RISES),
        "clearance_cold": replace(cold, sense=">=", limit=UNITS["µm"].shown(LEAST_COLD), source=OWN),
    }
    if (usual := known.get(f"{at}.{USUAL}")) is not None:
        own[USUAL] = usual
    return {key: Rule(key, one) for key, one in ({key: known[f"{at}.{key}"] for key in READ} | own).items()}
