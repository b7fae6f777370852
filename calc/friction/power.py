# SPDX-License-Identifier: Apache-2.0
"""How the power flows through the train: from what its last wheel must deliver up to the first driver, or the other way round.

A mesh that must put out P_out takes in P_in = P_out + P_loss(P_in).  A wheel needs what its meshes take in, its own windage, and
what else it drives.  Meshes are listed along the flow; a wheel may drive several.
"""

from collections.abc import Callable, Mapping

from ..sheet.errors import NoSolution
from ..sheet.formula import formula
from ..sheet.trace import untraced
from ..sheet.units import Number, Watt
from .mesh import MeshGeometry, require

TOLERANCE = 1e-10  # of the power
PASSES = 40
MORE_POWER = "give more gears.power_kW, less speed, a narrower face, or a thinner oil"
LEFT: Number = 1e-3  # of the power: what a jump of the loss may leave

Loss = Callable[[str, Watt], Watt]


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


@formula("P_out", "conservation of energy: what the last mesh passes on, less what the last wheel needs itself", names={"P": "P_Σ"})
def delivered(P_out: Watt, P: Watt) -> Watt:
    return P_out - P


# --- what a wheel needs ------------------------------------------------------------------------------------------------------
@formula("P_Σ", "windage and other losses of the wheel")
def own_need(P_W: Watt, P_X: Watt) -> Watt:
    return P_W + P_X


@formula("P_Σ", "the last wheel also carries the bearings of the counter-shaft", names={"P": "P_Σ"})
def with_bearings(P: Watt, P_B: Watt) -> Watt:
    return P + P_B


@formula("P_Σ", "the wheel also drives a mesh", names={"P": "P_Σ"})
def with_mesh(P: Watt, P_in: Watt) -> Watt:
    return P + P_in


@formula("P_X", "no other loss is carried by the wheel", shows="0")
def no_other_loss() -> Watt:
    return float("0")


@formula("P_X", "the wheel also carries the other loss P")
def with_other_loss(P_X: Watt, P: Watt) -> Watt:
    return P_X + P


def settled(name: str, P_out: Watt, loss: Loss) -> tuple[Watt, Watt]:
    """The power P that loads a mesh which must put out P_out, and P_in = P_out + P_loss(P); secant steps from P_out.

    Where a position changes its regime the loss jumps by a little, and P = P_in may fall into the jump; then the last pass stands
    if it is within 0.1 %.  The balance loses nothing by that: P_in always is P_out plus the loss that is published.
    """
    with untraced():
        P, P_in, slope = P_out, P_out + loss(name, P_out), 0.0
        for _ in range(PASSES):
            step = (P_in - P) / (1 - slope)
            if abs(step) <= TOLERANCE * P:
                return P, P_in
            before, P = P_in, P + step
            P_in = P_out + loss(name, P)
            slope = min(max((P_in - before) / step, -0.5), 0.9)
    if abs(P_in - P) <= LEFT * P:
        return P, P_in
    tried = f"{P:.6g} W in, {P_out:.6g} W out: off by {P_in - P:.3g} W after {PASSES} passes"
    raise NoSolution(f"power balance of mesh {name}", tried, "less friction, or more power")


def upstream(meshes: Mapping[str, MeshGeometry], loss: Loss, needed: Mapping[str, Watt]) -> dict[str, Watt]:
    """The power that loads each mesh; `needed` is what each wheel drives besides its meshes."""
    carried = dict(needed)
    loads: dict[str, Watt] = {}
    for name, mesh in reversed(list(meshes.items())):
        P_out = require(f"mesh {mesh.title}: power", carried[mesh.driven.name])
        loads[name], P_in = settled(name, P_out, loss)
        carried[mesh.driver.name] += P_in
    return {name: loads[name] for name in meshes}


def downstream(meshes: Mapping[str, MeshGeometry], loss: Loss, needed: Mapping[str, Watt], P: Watt) -> dict[str, Watt]:
    """The same for a train whose first driver puts the power P into its mesh; each wheel drives one mesh."""
    wheel = next(iter(meshes.values())).driver.name
    loads: dict[str, Watt] = {}
    for name, mesh in meshes.items():
        if mesh.driver.name != wheel:
            branches = "the train branches, and the power of its first driver does not say how it divides"
            raise NoSolution(f"mesh {mesh.title}", branches, "give one chain of wheels")
        if P <= 0:
            nothing = f"{P:.4g} W come in: what lies before it loses more than it gets"
            raise NoSolution(f"mesh {mesh.title}: power", nothing, MORE_POWER)
        loads[name] = require(f"mesh {mesh.title}: power", P)
        wheel = mesh.driven.name
        P = loads[name] - loss(name, loads[name]) - needed[wheel]
    return loads
