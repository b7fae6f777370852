# SPDX-License-Identifier: Apache-2.0
"""Teeth that are wrong in shape or jam: another shift, another tip cut, or thinner teeth.

Wrong are teeth that are undercut, pointed, that touch the fillet of their mate or hand over too late.

The rules are those of the search for shifts (`choose`).  That search looks for the least sliding; here every shift and
every cut is looked at alone, and the nearest to the design that keeps the rules is taken.  Where there is none, the
rows of that search."""

import math
from collections.abc import Iterator

import numpy as np

from ...design.locks import locked
from ...design.step_inputs import shaft_axes
from ...gears.backlash.checks import BACKLASH, BACKLASH_COLD, BACKLASH_WARM, BACKLASH_WARMING
from ...gears.inputs import GearsInputs, wheel_key
from ...gears.selection.free_shifts import freedoms, settled
from ...gears.selection.idler import idlers, passed
from ...gears.selection.optimum import ShiftCase, along
from ...gears.selection.search import ShiftRow, search
from ...gears.selection.states import USUAL, Bar, States, eased, judge, states
from ...gears.selection.tables import changes, freed
from ...gears.train import tooth_system
from ...gears.wheel_inputs import Wheel
from ...sheet.arrays import Array
from ...sheet.check import THIN_MARGIN, Check
from ...sheet.errors import NoSolution
from ...sheet.progress import Progress, part, tell
from ...sheet.record import replace
from ...sheet.remedy import Changes, whole
from ...sheet.search import first, least
from ...sheet.text import Amount, Text
from .state import RepairState, first_repaired

TRIED = 6  # designs, solved whole
CUT = 1e-5  # m: step of the tip cuts
DEEPEST = 1.0  # modules off a tip
MARGIN = 1e-6  # by which a rule is kept, so that the same number judged elsewhere keeps it too


def better_teeth(state: RepairState, failing: tuple[Check, ...], progress: Progress | None = None) -> RepairState:
    """Raises NoSolution where neither passes."""
    gears = state.design.gears
    assert gears is not None
    ids = [c.id for c in failing]
    tell(progress, 0.0, Text("profile shifts and tip cuts"))
    try:
        nearest = [change for *_, change in sorted(_nearest(gears), key=lambda entry: entry[:2])]
        return first_repaired(state, "gears", ids, nearest, part(progress, 0.1, 0.4), most=TRIED)
    except NoSolution:
        rows = search(gears, part(progress, 0.4, 0.8)).all
    rows = tuple(sorted((row for row in rows if row.passes), key=lambda row: _change(row, gears)))
    return first_repaired(state, "gears", ids, map(changes, rows), part(progress, 0.8, 1.0), most=TRIED)


def idler(state: RepairState, failing: tuple[Check, ...], progress: Progress | None = None) -> RepairState:
    """Other teeth of an idler that touches what stands beside it, or does not reach: the nearest number that passes."""
    gears = state.design.gears
    assert gears is not None
    rows = [
        row
        for idler_rows in idlers(gears, shaft_axes(state.design), part(progress, 0.0, 0.6))
        for row in passed(idler_rows)
    ]
    if not rows:
        raise NoSolution(Text("no other number of teeth of an idler is clear of what stands around the train"))
    now = {wheel.name: wheel.teeth for wheel in gears.wheels}
    rows.sort(key=lambda row: (abs(row.teeth - now[row.wheel]), row.largest))
    return first_repaired(
        state, "gears", [c.id for c in failing], [row.changes for row in rows], part(progress, 0.6, 1.0), most=TRIED
    )


def _nearest(gears: GearsInputs) -> Iterator[tuple[int, float, Changes]]:
    """Of every way to leave shifts free the nearest along each, and the nearest cut of each tip: which limits it keeps
    (the fewer the later), how far it goes, and its keys."""
    case = ShiftCase(tooth_system(gears), gears)
    now = settled(gears, case.system)
    there = None if now is None else states(case.system, gears, now.shifts)
    hard: Bar = tuple(replace(rule, limit=rule.hard) for rule in USUAL)  # type: ignore[assignment]
    easier = eased(there, case.system) if there is not None else None
    bars = [USUAL, *([easier] if easier is not None else []), hard]
    for way in freedoms(gears, case.system):
        for leader in way.free:
            start = way.start[leader]
            track = along(case, way, leader)
            for n, bar in enumerate(bars if track is not None else ()):
                if track is not None and (x := _first(case, track[1], bar, track[0], start)) is not None:
                    yield n, abs(x - start), freed(way, {leader: x})
    for wheel in gears.wheels if now is not None else ():
        cuts = np.asarray(np.arange(round(DEEPEST * case.system.m_n / CUT) + 1) * CUT, dtype=float)
        made_cuts = states(case.system, gears, now.shifts, {wheel.name: cuts}) if now is not None else None
        for n, bar in enumerate(bars if made_cuts is not None else ()):
            if made_cuts is not None and (k := _first(case, made_cuts, bar, cuts, wheel.tip_shortening)) is not None:
                change = abs(k - wheel.tip_shortening) / case.system.m_n
                yield n, change, {wheel_key(wheel.name, Wheel.tip_shortening): round(k * 1e3, 6)}


def _first(case: ShiftCase, states: States, bar: Bar, numbers: Array, start: float) -> float | None:
    kept = np.broadcast_to(least(judge(states, case.system, bar)) >= MARGIN, numbers.shape)
    index = first(kept, np.abs(numbers - start))
    return None if index is None else float(numbers[index])


def _change(row: ShiftRow, gears: GearsInputs) -> float:
    """From the design: the sum of the changes of all given shifts and, in modules, of all tip cuts; rule of this
    program."""
    shifts = sum(
        abs(float(row.states.shifts[w.name][0]) - w.profile_shift) for w in gears.wheels if w.profile_shift is not None
    )
    cuts = {wheel.name: wheel.tip_shortening for wheel in gears.wheels}
    return shifts + sum(abs(k - cuts[name]) for name, k in row.cuts.items()) / gears.module


# --- teeth that jam
# As many whole micrometres off the spans of the wheels as free every pair at its smallest backlash: by no narrow margin
# as it is, and with what is not given at its unfavourable end.

JAMMING = (BACKLASH, BACKLASH_COLD, BACKLASH_WARM, BACKLASH_WARMING)
ROUNDS = 4  # a wheel grows with temperature, so that its allowance does not act to the last micrometre
MOST = 1000  # µm off one pair: beyond, the backlash is not that of its tolerances


def free_backlash(state: RepairState, failing: tuple[Check, ...], progress: Progress | None = None) -> RepairState:
    """Raises NoSolution where thinner teeth do not free a pair."""
    for n in range(ROUNDS):
        tell(progress, n / ROUNDS, Text("backlash"))
        jammed = [c for c in state.outcome("gears").checks if c.rule in JAMMING and not c.holds]
        if not jammed:
            return state
        missing: dict[str, int] = {}
        for check in jammed:
            off = THIN_MARGIN * check.scale - check.value
            if isinstance(check.at_worst, float):
                off = max(off, -check.at_worst)
            if not off < MOST:
                value = Amount(check.value, "µm")
                raise NoSolution(
                    Text("{check} is {value}: thinner teeth alone do not free the pair", check=check.name, value=value)
                )
            mesh = check.id.split(".")[1]
            missing[mesh] = max(missing.get(mesh, 0), math.ceil(off - 1e-6))
        state = state.with_changes(_thinner(state, missing))
    raise NoSolution(Text("thinner teeth do not free the pair: look at measured sizes and centre distances"))


def _thinner(state: RepairState, missing: dict[str, int]) -> Changes:
    """Each micrometre comes off the wheel that frees the most pairs by it, of several the one with the thickest
    teeth."""
    gears = state.design.gears
    assert gears is not None
    pairs = {mesh.key: (mesh.driver, mesh.driven) for mesh in gears.meshes}
    free = [
        wheel for wheel in gears.wheels if not locked(state.document.data, wheel_key(wheel.name, Wheel.span_allowance))
    ]
    given = {wheel.name: [round(end * 1e6, 6) for end in wheel.span_allowance or (0.0, 0.0)] for wheel in free}
    if stuck := next((mesh for mesh in missing if not given.keys() & set(pairs[mesh])), None):
        raise NoSolution(
            Text(
                "the span allowances of {driver} and {driven} are locked",
                driver=pairs[stuck][0],
                driven=pairs[stuck][1],
            )
        )
    left, less = dict(missing), dict.fromkeys(given, 0)

    def use(wheel: str) -> tuple[int, float]:
        return sum(more > 0 and wheel in pairs[mesh] for mesh, more in left.items()), given[wheel][0] - less[wheel]

    while any(more > 0 for more in left.values()):
        best = max(given, key=use)
        less[best] += 1
        left = {mesh: more - (best in pairs[mesh]) for mesh, more in left.items()}
    return {
        wheel_key(name, Wheel.span_allowance): [whole(end - n) for end in given[name]] for name, n in less.items() if n
    }
