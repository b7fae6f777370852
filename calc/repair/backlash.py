# SPDX-License-Identifier: Apache-2.0
"""Teeth that jam: as many whole micrometres off the spans of the wheels as free every pair at its smallest backlash."""

import math

from ..design.locks import locked
from ..sheet.changes import Changes, whole
from ..sheet.check import Check
from ..sheet.errors import NoSolution
from ..sheet.progress import Progress, tell
from ..sheet.text import Amount, Text
from ..studies.repair.state import State

KINDS = ("backlash", "backlash_cold", "backlash_warm", "backlash_runout")
ROUNDS = 4  # a wheel grows with temperature, so that its allowance does not act to the last micrometre
MOST = 1000  # µm off one pair: beyond, the backlash is not that of its tolerances


def repair(state: State, failing: tuple[Check, ...], progress: Progress | None = None) -> State:
    """Raises NoSolution where thinner teeth do not free a pair."""
    for n in range(ROUNDS):
        tell(progress, n / ROUNDS, Text("backlash"))
        jammed = [c for c in state.failing("gears") if c.id.rpartition(".")[2] in KINDS]
        if not jammed:
            return state
        missing: dict[str, int] = {}
        for one in jammed:
            if not -one.value < MOST:
                value = Amount(one.value, "µm")
                raise NoSolution(Text("{check} is {value}: thinner teeth alone do not free the pair", check=one.name, value=value))
            mesh = one.id.split(".")[1]
            missing[mesh] = max(missing.get(mesh, 0), math.ceil(-one.value - 1e-6))
        state = state.with_changes(_thinner(state, missing))
    raise NoSolution(Text("thinner teeth do not free the pair: look at measured sizes and centre distances"))


def _thinner(state: State, missing: dict[str, int]) -> Changes:
    """Each micrometre comes off the wheel that frees the most pairs by it, of several the one with the thickest teeth."""
    gears = state.design.gears
    assert gears is not None
    pairs = {mesh.key: (mesh.driver, mesh.driven) for mesh in gears.meshes}
    free = [wheel for wheel in gears.wheels if not locked(state.document.data, f"gears.wheels.{wheel.name}.span_allowance_um")]
    given = {wheel.name: [round(end * 1e6, 6) for end in wheel.span_allowance or (0.0, 0.0)] for wheel in free}
    if stuck := next((mesh for mesh in missing if not given.keys() & set(pairs[mesh])), None):
        raise NoSolution(Text("the span allowances of {driver} and {driven} are locked", driver=pairs[stuck][0], driven=pairs[stuck][1]))
    left, less = dict(missing), dict.fromkeys(given, 0)

    def use(wheel: str) -> tuple[int, float]:
        return sum(more > 0 and wheel in pairs[mesh] for mesh, more in left.items()), given[wheel][0] - less[wheel]

    while any(more > 0 for more in left.values()):
        best = max(given, key=use)
        less[best] += 1
        left = {mesh: more - (best in pairs[mesh]) for mesh, more in left.items()}
    less = {name: n for name, n in less.items() if n}
    return {f"gears.wheels.{name}.span_allowance_um": [whole(end - n) for end in given[name]] for name, n in less.items()}
