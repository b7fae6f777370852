# SPDX-License-Identifier: Apache-2.0
"""What of a design an engineer looks at first: the results of the first page, and which of its verdicts
stand on a formula outside its validity.

Which results, curves and tables stand in a short report, they say themselves (`short=`, `page_one=`).  Checks stand
here by the ids of their rows in `calc/library/tables/checks.md`, where `*` stands for anything."""

import re
from collections.abc import Iterable, Mapping
from fnmatch import translate
from functools import cache
from operator import attrgetter

from ..sheet.check import Check, pattern_of
from ..sheet.quantity import Published, dotted
from .model import STEP_KEYS, Design

# A check of a method that is passed over → the checks whose numbers are then outside of what their formula is made for
VALIDITY: dict[str, tuple[str, ...]] = {
    "engine.throw.fillet_journal": ("engine.throw.fatigue", "engine.throw.notch_stress_journal"),
    "engine.throw.fillet_pin": ("engine.throw.fatigue", "engine.throw.notch_stress_pin"),
    "countershaft.fillet": ("countershaft.fatigue", "countershaft.notch_stress"),
    "bearings.B.friction_regime": ("bearings.B.film*", "bearings.B.temperature*"),
    "bearings.B.supply_range": ("bearings.B.temperature*",),
    "bearings.B.oil_rows": ("bearings.B.film*", "bearings.B.temperature*"),
    "bearings.B.viscosity_range": ("bearings.B.film*", "bearings.B.temperature*"),
    "gears.M.line_load": ("gears.M.safety_contact*", "gears.W.safety_bending*"),
    "gears.M.notch_W": ("gears.W.safety_bending*",),
    "gears.M.shift_sum": ("gears.M.safety_contact*", "gears.W.safety_bending*", "gears.M.resonance"),
    "gears.train.root_roughness": ("gears.W.safety_bending*",),
}


@cache
def _any_of(patterns: tuple[str, ...]) -> re.Pattern[str]:
    """What matches ids of one of these patterns, of none nothing; a `*` stands for no more than one part of an id."""
    return re.compile("|".join(translate(pattern).replace(".*", "[^.]*") for pattern in patterns) or "(?!)")


Line = tuple[str, int, str]  # a line of the first page: its step, its place there, and the part that it is of


def key_results(values: Mapping[str, Published]) -> dict[Line, Published]:
    """The results of the first page by its lines, each of the part where it is worst; no imbalance that the engine does
    not have."""
    lines: dict[Line, list[Published]] = {}
    for v in values.values():
        if v.page_one and v.shown == v.shown:
            part = v.id.rpartition(".")[0] if v.about.each else ""
            lines.setdefault((v.id.partition(".")[0], v.page_one, part), []).append(v)
    worst = {}
    for line in sorted(lines, key=lambda line: (STEP_KEYS.index(line[0]), line[1])):  # of one place each as it comes
        values_of_line = lines[line]
        worst[line] = (min if is_least(values_of_line[0]) else max)(values_of_line, key=attrgetter("shown"))
    return {line: v for line, v in worst.items() if v.shown or line[0] != dotted(Design.imbalance)}


def is_least(v: Published) -> bool:
    """Whether the least of such results is the worst."""
    return v.about.worst == "least"


def concerns(method: str, check: str) -> bool:
    """Whether a check of a method, passed over, puts a check of the same part outside the validity of its formula.

    Of the same part: both are of one bearing, mesh or wheel, or one is of all; a wheel is part of its meshes."""
    if not _any_of(VALIDITY.get(pattern_of(method), ())).fullmatch(pattern_of(check)):
        return False
    of, part = method.split(".")[1:-1], check.split(".")[1:-1]
    return not of or not part or "train" in of or of[0] == part[0] or part[0] in of[0].split("_")


def stretched(checks: Iterable[Check]) -> list[Check]:
    """The checks of the method among these that put others outside the validity of their formulas."""
    missed = [check for check in checks if check.kind == "method" and not check.holds]
    return [check for check in missed if pattern_of(check.id) in VALIDITY]


def outside(check: Check, checks: Iterable[Check]) -> list[Check]:
    """The checks of the method, among those of its step, that put a check outside the validity of its formula."""
    return [method_check for method_check in stretched(checks) if concerns(method_check.id, check.id)]


def judged(check: Check, checks: Iterable[Check]) -> str:
    """The verdict of a check; one that holds by a formula outside its validity is not called a pass.  `checks`: of its
    step."""
    return "outside" if check.verdict == "pass" and outside(check, checks) else check.verdict
