# SPDX-License-Identifier: Apache-2.0
"""The sums over losses of one kind, one after the other: of the entries on a wheel, and of all wheels and meshes."""

from ...sheet.formula import formula
from ...sheet.text import Text
from ...sheet.units import Watt

ON = Text("mathematics, sum over what a wheel carries of it, one after the other")
OVER = Text("mathematics, sum over the wheels, one after the other")
OVER_SHAFTS = Text("mathematics: sum over the shafts, one after the other")


@formula("P_C", ON, names={"P": "P_C,0"})
def churning_on_wheel(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula("P_J", ON, names={"P": "P_J,0"})
def thrown_oil_on_wheel(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula("P_D", ON, names={"P": "P_D,0"})
def seals_on_wheel(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula("P_L", ON, names={"P": "P_L,0"})
def bearings_on_wheel(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula("P_X", "given in the design: no other loss is carried by the wheel", shows="0")
def no_other_loss() -> Watt:
    return 0.0


@formula("P_X", ON, names={"P": "P_X,0"})
def other_losses_on_wheel(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula("P_B", OVER_SHAFTS, names={"P": "P_B,0", "P_i": "P_B,i"})
def shafts(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula("P_M,min", OVER_SHAFTS, names={"P": "P_M,min,0", "P_i": "P_M,min,i"})
def least_of_masses(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula("P_M,max", OVER_SHAFTS, names={"P": "P_M,max,0", "P_i": "P_M,max,i"})
def most_of_masses(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula("P_M", OVER_SHAFTS, names={"P": "P_M,0", "P_i": "P_M,i"})
def masses(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula("P_D,max", OVER_SHAFTS, names={"P": "P_D,max,0", "P_i": "P_D,max,i"})
def dips(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula("P_C", "mathematics: sum over what hangs on the shafts, one after the other", names={"P": "P_C,0"})
def carried(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula("ΣP_VZ", "mathematics: sum over the meshes, one after the other", names={"P": "ΣP_VZ,0", "P_i": "P_VZ"})
def meshes(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula("ΣP_K", "mathematics: sum over the chains and belts, one after the other", names={"P": "ΣP_K,0", "P_i": "P_K"})
def stages(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula("P", "mathematics: with what the chains and belts lose", names={"P": "P_0"})
def with_stages(P: Watt, P_K: Watt) -> Watt:
    return P + P_K


@formula("P", "mathematics: with what the turning masses lose", names={"P": "P_0"})
def with_masses(P: Watt, P_M: Watt) -> Watt:
    return P + P_M


@formula("ΣP_W", OVER, names={"P": "ΣP_W,0", "P_i": "P_W"})
def windage(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula("ΣP_C", OVER, names={"P": "ΣP_C,0", "P_i": "P_C"})
def churning(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula("ΣP_J", OVER, names={"P": "ΣP_J,0", "P_i": "P_J"})
def thrown_oil(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula("ΣP_D", OVER, names={"P": "ΣP_D,0", "P_i": "P_D"})
def seals(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula("ΣP_L", OVER, names={"P": "ΣP_L,0", "P_i": "P_L"})
def bearings(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula("ΣP_X", OVER, names={"P": "ΣP_X,0", "P_i": "P_X"})
def other_losses(P: Watt, P_i: Watt) -> Watt:
    return P + P_i


@formula(
    "P",
    "mathematics: sum of all losses of the train; what it does not have counts 0",
    meanings={
        "P_B": "Bearings of the counter-shaft",
        "P_C": "Churning of all wheels",
        "P_J": "Thrown oil of all wheels",
        "P_D": "Seals of all wheels",
        "P_L": "Bearings of all wheels",
    },
)
def total_loss(P_B: Watt, P_VZ: Watt, P_W: Watt, P_C: Watt, P_J: Watt, P_D: Watt, P_L: Watt, P_X: Watt) -> Watt:
    return P_B + P_VZ + P_W + P_C + P_J + P_D + P_L + P_X
