# SPDX-License-Identifier: Apache-2.0
"""One number at a time: the smallest relative change of a single input by which a check holds and nothing that held fails.

First every number is moved a little, to see which way it helps and how far it would have to go; the most promising are then moved until
the check holds, and the change is halved down to what is just enough.  What a design asks for (speeds, temperatures, limits) stays.
"""

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass

from ..design_file import quantities, value_at
from ..sheet.check import Check
from ..sheet.errors import BadInput, NoSolution
from ..sheet.progress import Progress, tell
from ..sheet.quantity import Quantity
from .state import State, Tries, broken, mended

PROBE = 0.02  # relative change by which every number is moved to see what it does
FARTHEST = 10.0  # relative change that is still believed, where a small one says how far to go
GROWN = (0.3, 1.02, 1.4, 3.0, 8.0)  # times that change
BLIND = (0.05, 0.15, 0.4, 1.0, 2.0)  # relative changes tried where a small one tells nothing
CLOSE = 5  # halvings of the change
BEST = 5  # numbers that are moved all the way
ADDRESS = re.compile(r"[a-z][a-z_]*(?:\.[A-Za-z0-9_-]+)*")

# What the maker of a design is free to move, by step; keys that the advice of a check names are added.
FREE = {
    "engine": r"throw\..*|flywheel_inertia_kgm2",
    "imbalance": r"crank_balance_fraction|counterweight_.*|bob_mass_kg|unbalances\..*\.(unbalance_kgmm|angle_deg)",
    "countershaft": (
        r"(masses|extras)\..*|sections\..*\.(outer_radius_mm|core_radius_mm|half_angle_deg)|bearing_positions_mm|outer_radius_mm|"
        r"core_radius_mm|half_length_mm|fillet_radius_mm|gear_z_mm|journals\..*|holes\..*|bolts\.(torque_Nm|head_diameter_mm|"
        r"hole_diameter_mm|row_span_mm|count)|support\.wall_mm|oil_drain\..*"
    ),
    "bearings": (
        r"(front|rear)\.(diameter_mm|length_mm|clearance_um|clearance_factor|journal_roughness_um|housing_roughness_um)|"
        r"supply_pressure_bar|hole_diameter_mm|groove_width_mm|pocket_width_mm|pocket_length_mm"
    ),
    "gears": (
        r"wheels\..*\.(teeth|profile_shift|tip_shortening_mm|span_allowance_um|tip_diameter_tolerance_um|rim_thickness_mm|"
        r"position_mm|hardness_HV)|"
        r"meshes\..*\.(centre_distance_mm|tolerance_um)|tool_addendum|tool_tip_radius|ball_diameter_mm|helix_angle_deg"
    ),
    "friction": r"flank_roughness_um",
}


@dataclass(frozen=True)
class Number:
    """One input: where it stands, what it is now (a number, or several that move together), and its description."""

    key: str
    now: tuple[float, ...]
    alone: bool
    about: Quantity

    @property
    def whole(self) -> bool:
        return self.about.kind == "integer"

    def moved(self, change: float) -> str | None:
        """KEY=VALUE after a relative change; None where it is not allowed."""
        return self.written([self.at(x, change) for x in self.now])

    def at(self, x: float, change: float) -> float:
        if self.whole:
            return x + math.copysign(max(1.0, math.floor(abs(x * change) + 0.5)), change)
        return x * (1 + change) if x else change * 10 * (self.about.step or 0.1)

    def written(self, numbers: list[float]) -> str | None:
        low, high, above = self.about.low, self.about.high, self.about.above
        if any((low is not None and x < low) or (high is not None and x > high) or (above is not None and x <= above) for x in numbers):
            return None
        said = [str(round(x)) if self.whole else repr(float(f"{x:.9g}")) for x in numbers]
        return f"{self.key}={said[0] if self.alone else '[' + ', '.join(said) + ']'}"


class _Search:
    """Tries whole designs, each once, while `tries` last.  `checks`: those that are to hold; none: the step finds no solution."""

    def __init__(self, state: State, step: str, checks: tuple[Check, ...], progress: Progress | None, tries: Tries) -> None:
        self.state, self.step, self.checks, self.progress, self.tries = state, step, checks, progress, tries
        self.first = max(tries.left, 1)
        self.known: dict[str, State | None] = {}

    def made(self, number: Number, changes: str | None) -> State | None:
        if changes is None or (changes not in self.known and self.tries.left <= 0):
            return None
        if changes not in self.known:
            tell(self.progress, 1 - self.tries.left / self.first, number.key)
            self.tries.left -= 1
            try:
                self.known[changes] = self.state.with_changes([changes])
            except BadInput:
                self.known[changes] = None
        return self.known[changes]

    def holds(self, made: State | None) -> bool:
        return made is not None and mended(self.state, made, self.step, [c.id for c in self.checks])

    def passes(self, made: State | None) -> bool:
        """And nothing that held before fails."""
        return made is not None and self.holds(made) and not broken(self.state, made)

    def margin(self, made: State | None) -> float:
        """The least of the checks that are to hold; no number where one has none."""
        there = [made.check(self.step, c.id) for c in self.checks] if made is not None else []
        margins = [math.nan if c is None else c.margin for c in there]
        return math.nan if not margins or any(math.isnan(x) for x in margins) else min(margins)


def mend(state: State, step: str, checks: tuple[Check, ...], tries: Tries, progress: Progress | None = None) -> State:
    """All these checks by one number.  Raises NoSolution where no single one helps, or not within the tries."""
    search = _Search(state, step, checks, progress, tries)
    numbers = list(_numbers(state, step, checks))
    hopes: list[tuple[float, float, Number]] = []  # relative change that is needed, its sign, and of which number
    now = search.margin(state)
    for number in numbers:
        small, made = next(((x, search.made(number, c)) for x in (PROBE, -PROBE) if (c := number.moved(x)) is not None), (0.0, None))
        gain = search.margin(made) - now
        if search.passes(made):
            hopes.append((PROBE, math.copysign(1.0, small), number))
        elif gain == gain and gain != 0 and PROBE * -now / abs(gain) <= FARTHEST:
            hopes.append((PROBE * -now / abs(gain), math.copysign(1.0, gain * small), number))
        elif gain != 0:  # no number, or all but nothing
            far = BLIND[1] if gain != gain else FARTHEST
            hopes += [(far, 1.0, number), (far, -1.0, number)]
    named = _named(checks)
    hopes.sort(key=lambda one: (not _is_named(one[2].key, named), one[0]))
    best: tuple[float, State] | None = None
    for n, (need, sign, number) in enumerate(hopes):
        if best is not None and (n >= BEST or best[0] <= GROWN[0] * need or (named and not _is_named(number.key, named))):
            break
        found = _moved(search, number, sign, need if math.isfinite(now) and need < FARTHEST else None)
        if found is not None and (best is None or found[0] < best[0]):
            best = found
    if best is None:
        within = "" if tries.left > 0 else "; the search was ended there"
        raise NoSolution(f"no single number of the step mends it{within}" if numbers else "there is no number to change")
    return best[1]


def _moved(search: _Search, number: Number, sign: float, need: float | None) -> tuple[float, State] | None:
    """The smallest change of one number by which the checks hold, and the design with it; None where others then fail."""
    low, high = 0.0, math.inf
    for change in BLIND if need is None else [max(need, PROBE / 4) * grown for grown in GROWN]:
        if search.holds(search.made(number, number.moved(sign * change))):
            high = change
            break
        low = change
    if math.isinf(high):
        return None
    for _ in range(CLOSE):
        middle = (low + high) / 2
        if search.holds(search.made(number, number.moved(sign * middle))):
            high = middle
        else:
            low = middle
    best = search.made(number, number.moved(sign * high))
    if best is None or not search.passes(best):
        return None
    for start, end in ((low, high), (high, 2 * high - low)):  # a round number within the last half, or just beyond
        rounded = search.made(number, number.written([_round(number.at(x, sign * start), number.at(x, sign * end)) for x in number.now]))
        if rounded is not None and search.passes(rounded):
            return high, rounded
    return high, best


def _round(low: float, high: float) -> float:
    """The number of the fewest digits that lies beyond `low` and not beyond `high`, seen from `low`."""
    for digits in range(-3, 7):
        unit = 10.0**-digits
        n = math.floor(high / unit + 1e-9) if high > low else math.ceil(high / unit - 1e-9)
        found = round(n * unit, max(digits, 0))
        if (low < found <= high * (1 + 1e-12)) if high > low else (high * (1 - 1e-12) <= found < low if high > 0 else high <= found < low):
            return found
    return high


def _numbers(state: State, step: str, checks: tuple[Check, ...]) -> Iterator[Number]:
    """Those that the advice names first, then those of the step that are free and given, of the same bearing or wheel before others."""
    free = re.compile(FREE[step])
    named = _named(checks)
    every = [(key, about) for key, about in quantities(state.document.data) if about.kind in ("number", "integer", "series")]
    first = [one for one in every if one[0] in named or (one[0].startswith(f"{step}.") and _is_named(one[0], named))]
    rest = [one for one in every if one[0].startswith(f"{step}.") and free.fullmatch(one[0][len(step) + 1 :]) and one not in first]
    near = {part for c in checks for part in c.id.split(".")[1].split("_")}
    rest.sort(key=lambda one: not near & set(one[0].split(".")))
    for key, about in [*first, *rest]:
        given = value_at(state.document.data, key)
        if given is None and key not in named:
            continue
        alone = not isinstance(given, list)
        numbers = [0.0] if given is None else [given] if alone else given
        if all(isinstance(x, (int, float)) and not isinstance(x, bool) for x in numbers) and numbers:
            yield Number(key, tuple(float(x) for x in numbers), alone and about.kind != "series", about)


def _named(checks: tuple[Check, ...]) -> set[str]:
    """Words of the advice that may be keys."""
    return {word for c in checks for word in ADDRESS.findall(c.advice)}


def _is_named(key: str, named: set[str]) -> bool:
    return key in named or key.rpartition(".")[2] in named
