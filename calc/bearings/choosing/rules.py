# SPDX-License-Identifier: Apache-2.0
"""What a bearing that is offered has to keep, at the worst corner of its tolerances.

The limits are those of the step's own checks, read off the checks of the design itself and written nowhere again.  Three are this
program's own rules for choosing: the rise of temperature, the cold clearance that must be left, and Trumpler's film at the edge too.
"""

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import numpy as np

from ...sheet.check import Check, check
from ...sheet.record import record
from ...sheet.units import UNITS, Kelvin, Metre

LARGEST_RISE: Kelvin = 15.0
LEAST_COLD: Metre = 20e-6
OWN = "rule of this program for choosing"
EXACT = 1e-9  # of the limit: a margin that is negative by rounding only


@record
class Rule:
    """One constraint: the check it is taken from or made of.  `of_candidate`: its limit is each candidate's own."""

    key: str
    check: Check
    of_candidate: bool = False

    @property
    def name(self) -> str:
        """Without the place."""
        return self.check.name.rsplit(",", 1)[0]


@record
class Judged:
    """A rule on any number of candidates: value and limit in the shown unit, margin as that of a check, and the state that governs."""

    rule: Rule
    value: Any
    limit: Any
    margin: Any
    state: Any

    def at(self, index: Any) -> tuple[Check, int]:
        """The check of one candidate, and its governing state (−1: it has none)."""
        limit = self.limit if isinstance(self.limit, tuple) else float(np.broadcast_to(self.limit, self.margin.shape)[index])
        value = float(np.broadcast_to(self.value, self.margin.shape)[index])
        return replace(self.rule.check, value=value, limit=limit), int(np.broadcast_to(self.state, self.margin.shape)[index])


def rules(place: str, checks: Iterable[Check]) -> dict[str, Rule]:
    """The constraints of one bearing, by their key, from the checks of a solved design."""
    known = {c.id: c for c in checks}
    found = {}
    for key in ("film_edge", "film_double_load", "temperature", "specific_load", "heat_index", "length_ratio", "length_ratio_usual"):
        found[key] = Rule(key, known[f"bearings.{place}.{key}"])
    found["transition"] = Rule("transition", known[f"bearings.{place}.transition"], of_candidate=True)
    edge, doubled = found["film_edge"].check, found["film_double_load"].check
    at, where = f"bearings.{place}", f", {place}"
    found["film_edge_trumpler"] = Rule(
        "film_edge_trumpler",
        replace(doubled, id=f"{at}.film_edge_trumpler", name="Film at the edge by Trumpler" + where, advice=edge.advice),
    )
    found["temperature_rise"] = Rule(
        "temperature_rise",
        check(f"{at}.temperature_rise", "Temperature rise" + where, 0.0, "<=", LARGEST_RISE, "K", OWN, found["temperature"].check.advice),
    )
    cold = known[f"{at}.clearance_cold"]
    found["clearance_cold"] = Rule("clearance_cold", check(cold.id, cold.name, 0.0, ">=", LEAST_COLD, "µm", OWN, cold.advice))
    found["clearance_cold_corner"] = Rule("clearance_cold_corner", known[f"{at}.clearance_cold_corner"])
    return found


def judged(rule: Rule, value: Any, limit: Any = None, state: Any = -1) -> Judged:
    """A rule on candidates, from values in SI; `limit`, in SI as well, where it is that of each candidate.  No number: −∞ is its margin."""
    units = UNITS[rule.check.unit]
    shown = np.asarray(units.all_shown(value))
    bound: Any = rule.check.limit if limit is None else units.all_shown(limit)
    if isinstance(bound, tuple):
        low, high = bound
        to_low, to_high = shown - low, high - shown
        margin = np.where(to_low <= to_high, to_low / (abs(low) or 1.0), to_high / (abs(high) or 1.0))
    else:
        gap = shown - bound if rule.check.sense in (">=", ">") else bound - shown
        margin = gap / np.where(bound == 0, 1.0, np.abs(bound))
    margin = np.where(np.abs(margin) <= EXACT, 0.0, margin)
    return Judged(rule, shown, bound, np.where(np.isnan(margin), -np.inf, margin), state)
