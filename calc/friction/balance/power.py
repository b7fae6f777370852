# SPDX-License-Identifier: Apache-2.0
"""How the power flows through the train: from what its last wheel must deliver up to the first driver, or the other way round.

A mesh that must put out P_out takes in P_in = P_out + P_loss(P_in).  A wheel needs what its meshes take in, its own losses, and
what else it drives.  Meshes are listed along the flow; a wheel may drive several.

What a wheel needs may itself follow from the power: the force of the teeth loads the bearings of the idlers and the journals of the
counter-shaft.  All of it is one fixed point, of one operating point or of many at once.
"""

from collections.abc import Callable, Mapping

import numpy as np

from ...sheet.arrays import each, most, one
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.text import Amount, Text
from ...sheet.trace import untraced
from ...sheet.units import Number, Watt
from ..mesh.geometry import MeshGeometry, require

TOLERANCE = 1e-9  # of the power
PASSES = 40
MORE_POWER = Text("give more gears.power_kW, less speed, a narrower face, or a thinner oil")
LEFT: Number = 1e-2  # of the power: what a jump of the loss may leave between the power that loads a mesh and the one it takes in
FINE = 1e-9  # of the power: steps below it say nothing about a slope

Loss = Callable[[str, Watt], Watt]
Needs = Callable[[Mapping[str, Watt]], dict[str, Watt]]


@formula("P_in", "conservation of energy")
def power_in(P_out: Watt, P_VZ: Watt) -> Watt:
    return P_out + P_VZ


@formula("P_out", "conservation of energy")
def power_out(P_in: Watt, P_VZ: Watt) -> Watt:
    return P_in - P_VZ


@formula(
    "P_in", "conservation of energy: what the mesh before passes on, less what the wheel between them needs itself", names={"P": "P_Σ"}
)
def passed_on(P_out: Watt, P: Watt) -> Watt:
    return P_out - P


@formula(
    "P_out",
    "conservation of energy: what the last mesh passes on, less what the last wheel needs itself",
    names={"P_out": "P_mesh", "P": "P_Σ"},
)
def delivered(P_out: Watt, P: Watt) -> Watt:
    return P_out - P


# --- what a wheel needs ------------------------------------------------------------------------------------------------------
@formula("P_Σ", "mathematics: sum over what the wheel needs, one after the other", names={"P": "P_Σ,0"})
def and_need(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula("P_Σ", "energy: the last wheel also carries the bearings of the counter-shaft", names={"P": "P_Σ,0"})
def with_bearings(P: Watt, P_B: Watt) -> Watt:
    return P + P_B


@formula("P_Σ", "energy: the wheel also drives a mesh", names={"P": "P_Σ,0"})
def with_mesh(P: Watt, P_in: Watt) -> Watt:
    return P + P_in


# --- the fixed point ---------------------------------------------------------------------------------------------------------
class Guess:
    """The power of one mesh: P solves P = P_out + P_loss(P), the loss taken as a straight line through the last two passes, and after
    the first through none at no power."""

    def __init__(self) -> None:
        self.P: Watt | None = None
        self.loss: Watt = 0.0
        self.slope: Number = 0.0

    def at(self, P_out: Watt) -> Watt:
        if self.P is None:
            return P_out
        return (P_out + self.loss - self.slope * self.P) / (1 - self.slope)

    def learn(self, P: Watt, loss: Watt) -> None:
        if self.P is not None:
            step = P - self.P
            slope = (loss - self.loss) / np.where(step == 0, 1.0, step)
            self.slope = each(np.where(np.abs(step) > FINE * np.abs(P), np.clip(slope, -0.5, 0.9), self.slope))
        else:
            self.slope = each(np.clip(loss / P, 0.0, 0.9))  # most of a loss grows with the power
        self.P, self.loss = P, loss


def upstream(meshes: Mapping[str, MeshGeometry], loss: Loss, needs: Needs) -> dict[str, Watt]:
    """The power that loads each mesh; `needs` tells what each wheel needs besides its meshes, at the powers of the pass before.

    Where a position changes its regime the loss jumps by what it rolls, and P = P_in may fall into the jump, which no power solves; then
    the last pass stands if it is within 1 %, and a note says so.  The balance loses nothing by that: P_in always is P_out plus the
    loss that is published.
    """
    guesses = {name: Guess() for name in meshes}
    loads: dict[str, Watt] = {}
    with untraced():
        for _ in range(PASSES):
            carried, off, moved = needs(loads), {}, 0.0
            for name, mesh in reversed(list(meshes.items())):
                P_out = require(mesh.power, carried[mesh.driven.name])
                P = require(mesh.power, guesses[name].at(P_out))
                lost = loss(name, P)
                off[name] = most(np.abs(P_out + lost - P) / P)
                moved = max(moved, most(np.abs(P - loads.get(name, np.inf)) / P))
                guesses[name].learn(P, lost)
                loads[name] = P
                carried[mesh.driver.name] += P_out + lost
            if max(moved, *off.values()) <= TOLERANCE:
                return {name: _number(loads[name]) for name in meshes}
    name, worst = max(off.items(), key=lambda item: item[1])
    if worst <= LEFT:
        return {name: _number(loads[name]) for name in meshes}
    tried = Text(
        "off by {worst} % of {max} W after {passes} passes",
        worst=Amount(worst * 100, form=".3g"),
        max=Amount(float(np.max(loads[name])), form=".6g"),
        passes=PASSES,
    )
    raise NoSolution(Text("power balance of mesh {name}", name=name), tried, Text("less friction, or more power"))


def downstream(meshes: Mapping[str, MeshGeometry], loss: Loss, needs: Needs, P: Watt) -> dict[str, Watt]:
    """The same for a train whose first driver puts the power P into its mesh; each wheel drives one mesh."""
    before: dict[str, Watt] = {}
    with untraced():
        for _ in range(PASSES):
            loads = _down(meshes, loss, needs(before), P)
            if all(np.all(np.abs(loads[name] - before.get(name, np.nan)) <= TOLERANCE * P) for name in meshes):
                return loads
            before = loads
    raise NoSolution(Text("power balance of the train"), Text("not settled after {passes} passes", passes=PASSES), MORE_POWER)


def _down(meshes: Mapping[str, MeshGeometry], loss: Loss, needed: Mapping[str, Watt], P: Watt) -> dict[str, Watt]:
    wheel = next(iter(meshes.values())).driver.name
    loads: dict[str, Watt] = {}
    for name, mesh in meshes.items():
        if mesh.driver.name != wheel:
            branches = Text("the train branches, and the power of its first driver does not say how it divides")
            raise NoSolution(Text("mesh {title}", title=mesh.title), branches, Text("give one chain of wheels"))
        if np.any(P <= 0):
            nothing = Text("{min} W come in: what lies before it loses more than it gets", min=Amount(float(np.min(P)), form=".4g"))
            raise NoSolution(Text("mesh {title}: power", title=mesh.title), nothing, MORE_POWER)
        loads[name] = require(mesh.power, P)
        wheel = mesh.driven.name
        P = loads[name] - loss(name, loads[name]) - needed[wheel]
    return loads


def _number(x: Watt) -> Watt:
    return x if np.ndim(x) else one(x)
