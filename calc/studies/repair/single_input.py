# SPDX-License-Identifier: Apache-2.0
"""One number at a time: the smallest relative change of a single input by which a check holds and nothing that held
fails.

First every number is moved a little, to see which way it helps and how far it would have to go; the most promising are
then moved until the check holds, and the change is halved down to what is just enough.  What a design asks for (speeds,
temperatures, limits) stays."""

import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ...design.addresses import as_list, quantities, value_at
from ...design.locks import locked
from ...sheet.check import Check
from ...sheet.errors import BadInput, NoSolution
from ...sheet.progress import Progress, tell
from ...sheet.quantity import Quantity
from ...sheet.remedy import Changes, digits
from ...sheet.search import Budget, allowed, rounded, smallest
from ...sheet.step import Outcome
from ...sheet.text import Text
from .state import RepairState, broken, repaired

PROBE = 0.02  # relative change by which every number is moved to see what it does
FARTHEST = 10.0  # relative change that is still believed, where a small one says how far to go
GROWN = (0.3, 1.02, 1.4, 3.0, 8.0)  # times that change
BLIND = (0.05, 0.15, 0.4, 1.0, 2.0)  # relative changes tried where a small one tells nothing
CLOSE = 5  # halvings of the change
BEST = 5  # numbers that are moved all the way

ASKED = re.compile(
    r".*(temperature_C|rpm|power_kW|load_N|life_h|application_factor|_stress_MPa|density_kgm3|deflection_limit_mm)"
)  # what a design asks for
# What the maker of a design is free to move, by step; the keys that move a check are added.
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
    "mounting": r"mounts\..*\.(stiffness_N_mm|position_mm|turned_deg)",
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

    def moved(self, change: float) -> Changes | None:
        """The key after a relative change; None where it is not allowed."""
        return self.written([self.at(x, change) for x in self.now])

    def at(self, x: float, change: float) -> float:
        if self.whole:
            return x + math.copysign(max(1.0, math.floor(abs(x * change) + 0.5)), change)
        return x * (1 + change) if x else change * 10 * (self.about.step or 0.1)

    def written(self, numbers: list[float]) -> Changes | None:
        if not allowed(self.about, numbers):
            return None
        values = [round(x) if self.whole else digits(x) for x in numbers]
        return {self.key: values[0] if self.alone else values}


class _Search:
    """Tries whole designs, each once, while the budget lasts.  `checks`: those that are to hold; none: the step finds
    no solution."""

    def __init__(
        self, state: RepairState, step: str, checks: tuple[Check, ...], progress: Progress | None, budget: Budget
    ) -> None:
        self.state, self.step, self.checks, self.progress, self.budget = state, step, checks, progress, budget
        self.ids = {c.id for c in checks}
        self.first = max(budget.left, 1)
        self.known: dict[str, RepairState | None] = {}

    def tried(self, number: Number, changes: Changes | None) -> RepairState | None:
        """The design with a change; solved no further than to a check that does not hold."""
        name = str(changes)
        if changes is None or (name not in self.known and not self.budget.spend()):
            return None
        if name not in self.known:
            tell(self.progress, 1 - self.budget.left / self.first, number.key)
            try:
                self.known[name] = self.state.with_changes(changes, enough=self._fails)
            except BadInput:
                self.known[name] = None
        return self.known[name]

    def _fails(self, outcome: Outcome[object]) -> bool:
        """Whether it is decided that the checks do not hold: all of them are known, and some fail."""
        if outcome.key != self.step or self.step == "imbalance":  # whose checks change once the shaft is known
            return False
        if not self.ids:
            return outcome.state == "no_solution"
        known = {c.id: c.verdict for c in outcome.checks if c.id in self.ids}
        return known.keys() == self.ids and "fail" in known.values()

    def holds(self, tried: RepairState | None) -> bool:
        return tried is not None and repaired(self.state, tried, self.step, self.ids)

    def passes(self, tried: RepairState | None) -> bool:
        """And nothing that held before fails."""
        return tried is not None and self.holds(tried) and not broken(self.state, tried)

    def margin(self, tried: RepairState | None) -> float:
        """The least of the checks that are to hold; no number where one has none."""
        there = {c.id: c.margin for c in tried.outcome(self.step).checks} if tried is not None else {}
        margins = [there.get(c.id, math.nan) for c in self.checks]
        return math.nan if not margins or any(map(math.isnan, margins)) else min(margins)


def repair(
    state: RepairState, step: str, checks: tuple[Check, ...], budget: Budget, progress: Progress | None = None
) -> RepairState:
    """All these checks by one number.  Raises NoSolution where no single one helps, or not within the budget."""
    search, named = _Search(state, step, checks, progress, budget), _named(checks)
    numbers = list(_numbers(state, step, checks, named))
    best: tuple[float, RepairState] | None = None
    for n, (not_named, need, sign, number) in enumerate(
        sorted(_hopes(search, numbers, named), key=lambda hope: hope[:2])
    ):
        if best is not None and (n >= BEST or best[0] <= GROWN[0] * need or (named and not_named)):
            break
        known = math.isfinite(search.margin(state)) and need < FARTHEST
        moved = _moved(search, number, sign, [max(need, PROBE / 4) * grown for grown in GROWN] if known else BLIND)
        if moved is not None and (best is None or moved[0] < best[0]):
            best = moved
    if best is not None:
        return best[1]
    if not numbers:
        raise NoSolution(Text("there is no number to change"))
    if budget.left > 0:
        raise NoSolution(Text("no single number of the step repairs it"))
    raise NoSolution(Text("no single number of the step repairs it; the search was ended there"))


def _hopes(search: _Search, numbers: list[Number], named: set[str]) -> Iterator[tuple[bool, float, float, Number]]:
    """Of every number: whether it is not named, the relative change that is needed as far as a small one tells, and its
    sign."""
    now = search.margin(search.state)
    for number in numbers:
        last = not _is_named(number.key, named)
        small, tried = next(
            ((x, search.tried(number, c)) for x in (PROBE, -PROBE) if (c := number.moved(x)) is not None), (0.0, None)
        )
        gain = search.margin(tried) - now
        if search.passes(tried):
            yield last, PROBE, math.copysign(1.0, small), number
        elif gain == gain and gain != 0 and PROBE * -now / abs(gain) <= FARTHEST:
            yield last, PROBE * -now / abs(gain), math.copysign(1.0, gain * small), number
        elif gain != 0:  # no number, or all but nothing
            far = BLIND[1] if gain != gain else FARTHEST
            yield last, far, 1.0, number
            yield last, far, -1.0, number


def _moved(search: _Search, number: Number, sign: float, guesses: Sequence[float]) -> tuple[float, RepairState] | None:
    """The smallest change of one number by which the checks hold, and the design with it; None where others then
    fail."""
    ends = smallest(lambda change: search.holds(search.tried(number, number.moved(sign * change))), guesses, CLOSE)
    if ends is None:
        return None
    low, high = ends
    best = search.tried(number, number.moved(sign * high))
    if best is None or not search.passes(best):
        return None
    for start, end in ((low, high), (high, 2 * high - low)):  # a round number within the last half, or just beyond
        changes = number.written([rounded(number.at(x, sign * start), number.at(x, sign * end)) for x in number.now])
        if (tried := search.tried(number, changes)) is not None and search.passes(tried):
            return high, tried
    return high, best


def _numbers(state: RepairState, step: str, checks: tuple[Check, ...], named: set[str]) -> Iterator[Number]:
    """Those that are named first, then those of the step that are free and given, of the same bearing or wheel before
    others."""
    free = re.compile(FREE[step])
    every = [
        (key, about) for key, about in quantities(state.document.data) if about.kind in ("number", "integer", "series")
    ]
    first = [
        entry
        for entry in every
        if entry[0] in named or (entry[0].startswith(f"{step}.") and _is_named(entry[0], named))
    ]
    rest = [
        entry
        for entry in every
        if entry[0].startswith(f"{step}.") and free.fullmatch(entry[0][len(step) + 1 :]) and entry not in first
    ]
    near = {part for c in checks for part in c.id.split(".")[1].split("_")}
    rest.sort(key=lambda entry: not near & set(entry[0].split(".")))
    for key, about in [*first, *rest]:
        given = value_at(state.document.data, key)
        if (given is None and key not in named) or locked(state.document.data, key):
            continue
        standing = [0.0] if given is None else as_list(given)
        numbers = tuple([float(x) for x in standing if isinstance(x, (int, float)) and not isinstance(x, bool)])
        if numbers and len(numbers) == len(standing):
            yield Number(key, numbers, not isinstance(given, list) and about.kind != "series", about)


def _named(checks: tuple[Check, ...]) -> set[str]:
    """Keys that the remedies of the checks change, or that move them; that of a table stands for the numbers in it."""
    keys = {key for c in checks for remedy in c.remedies for key, _ in remedy.changes} | {
        key for c in checks for key in c.moved_by
    }
    return {key for key in keys if not ASKED.fullmatch(key)}


def _is_named(key: str, named: set[str]) -> bool:
    return key in named or any(key.startswith(f"{table}.") for table in named)
