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
from .state import State, broken, mended

SOLVES = 120  # of whole designs, at most
PROBE = 0.02  # relative change by which every number is moved to see what it does
FARTHEST = 2.0  # relative change that is still looked at
BLIND = (0.05, 0.15, 0.4)  # relative changes tried where a small one tells nothing
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
        r"hole_diameter_mm|row_span_mm)|support\.wall_mm|oil_drain\..*"
    ),
    "bearings": (
        r"(front|rear)\.(diameter_mm|length_mm|clearance_um|clearance_factor|journal_roughness_um|housing_roughness_um)|"
        r"supply_pressure_bar|hole_diameter_mm|groove_width_mm|pocket_width_mm|pocket_length_mm"
    ),
    "gears": (
        r"wheels\..*\.(profile_shift|tip_shortening_mm|face_width_mm|span_allowance_um|tip_diameter_tolerance_um|rim_thickness_mm|"
        r"position_mm|hardness_HV)|"
        r"meshes\..*\.(centre_distance_mm|tolerance_um)|face_width_mm|tool_addendum|tool_tip_radius|ball_diameter_mm|helix_angle_deg"
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

    def moved(self, change: float) -> str | None:
        """KEY=VALUE after a relative change; None where it is not allowed."""
        return self.written([self.at(x, change) for x in self.now])

    def at(self, x: float, change: float) -> float:
        return x * (1 + change) if x else change * 10 * (self.about.step or 0.1)

    def written(self, numbers: list[float]) -> str | None:
        low, high, above = self.about.low, self.about.high, self.about.above
        if any((low is not None and x < low) or (high is not None and x > high) or (above is not None and x <= above) for x in numbers):
            return None
        said = [repr(float(f"{x:.9g}")) for x in numbers]
        return f"{self.key}={said[0] if self.alone else '[' + ', '.join(said) + ']'}"


class _Search:
    """Tries whole designs, so many and no more.  `check`: the one that is to hold; None: the step finds no solution."""

    def __init__(self, state: State, step: str, check: Check | None, progress: Progress | None, solves: int) -> None:
        self.state, self.step, self.check, self.progress, self.solves = state, step, check, progress, solves
        self.tried = 0

    def made(self, number: Number, changes: str | None) -> State | None:
        if changes is None or self.tried >= self.solves:
            return None
        tell(self.progress, self.tried / self.solves, number.key)
        self.tried += 1
        try:
            return self.state.with_changes([changes])
        except BadInput:
            return None

    def passes(self, made: State | None) -> bool:
        ids = [self.check.id] if self.check else []
        return made is not None and mended(self.state, made, self.step, ids) and not broken(self.state, made)

    def margin(self, made: State | None) -> float:
        """Of the check that is to hold; no number where it has none."""
        if made is None or self.check is None:
            return math.nan
        there = made.check(self.step, self.check.id)
        return math.nan if there is None else there.margin


def mend(state: State, step: str, check: Check | None, progress: Progress | None = None, solves: int = SOLVES) -> State:
    """Raises NoSolution where no single number helps, or not within so many solves."""
    search = _Search(state, step, check, progress, solves)
    numbers = list(_numbers(state, step, check))
    hopes: list[tuple[float, float, Number]] = []  # relative change that is needed, its sign, and of which number
    best: tuple[float, State] | None = None
    now = check.margin if check is not None else math.nan
    for number in numbers:
        for small in (PROBE, -PROBE):
            changes = number.moved(small)
            if changes is None:
                continue
            made = search.made(number, changes)
            gain = search.margin(made) - now
            if gain == gain and gain != 0:
                hopes.append((PROBE * -now / abs(gain), math.copysign(1.0, gain * small), number))
            elif gain != gain:
                hopes += [(0.3, 1.0, number), (0.3, -1.0, number)]
            break
    hopes.sort(key=lambda one: one[0])
    for need, sign, number in [hope for hope in hopes if hope[0] <= FARTHEST][: BEST if math.isfinite(now) else None]:
        if best is not None and best[0] <= 0.5 * need:
            break
        found = _moved(search, number, sign, need if math.isfinite(now) else None)
        if found is not None and (best is None or found[0] < best[0]):
            best = found
    if best is None:
        within = f" within {solves} tries" if search.tried >= solves else ""
        raise NoSolution(f"no single number of the step mends it{within}" if numbers else "there is no number to change")
    return best[1]


def _moved(search: _Search, number: Number, sign: float, need: float | None) -> tuple[float, State] | None:
    """The smallest change of one number that passes, and the design with it."""
    low, found = 0.0, None
    for change in BLIND if need is None else [max(need, PROBE / 4) * grown for grown in (1.02, 1.3, 1.8, 3.0)]:
        made = search.made(number, number.moved(sign * change))
        if search.passes(made):
            found = change, made
            break
        low = change
        if made is None:
            break
    if found is None:
        return None
    high, best = found
    for _ in range(CLOSE):
        middle = (low + high) / 2
        made = search.made(number, number.moved(sign * middle))
        if search.passes(made):
            high, best = middle, made
        else:
            low = middle
    rounded = search.made(number, number.written([_round(number.at(x, sign * low), number.at(x, sign * high)) for x in number.now]))
    best = rounded if search.passes(rounded) else best
    assert best is not None
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


def _numbers(state: State, step: str, check: Check | None) -> Iterator[Number]:
    """Those that the advice names first, then those of the step that are free and given."""
    free = re.compile(FREE[step])
    named = set(ADDRESS.findall(check.advice)) if check is not None else set()
    every = [(key, about) for key, about in quantities(state.document.data) if about.kind in ("number", "series")]
    first = [one for one in every if one[0] in named or (one[0].startswith(f"{step}.") and one[0].rpartition(".")[2] in named)]
    rest = [one for one in every if one[0].startswith(f"{step}.") and free.fullmatch(one[0][len(step) + 1 :]) and one not in first]
    near = {check.id.split(".")[1]} if check is not None else set()
    rest.sort(key=lambda one: not near & set(one[0].split(".")))  # of the same bearing or wheel first
    for key, about in [*first, *rest]:
        given = value_at(state.document.data, key)
        if given is None and key not in named:
            continue
        alone = not isinstance(given, list)
        numbers = [0.0] if given is None else [given] if alone else given
        if all(isinstance(x, (int, float)) and not isinstance(x, bool) for x in numbers) and numbers:
            yield Number(key, tuple(float(x) for x in numbers), alone and about.kind != "series", about)
