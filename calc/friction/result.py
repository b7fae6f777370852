# SPDX-License-Identifier: Apache-2.0
"""What the friction step publishes, and the sums that close its balance."""

from typing import Annotated

from ..sheet.formula import formula
from ..sheet.functions import pi
from ..sheet.quantity import group, result, value
from ..sheet.units import Kelvin, NewtonMetre, Number, PascalSecond, RevPerSecond, Watt
from .loss import Case, MeshLoss
from .regressions import Regression

KilogramPerSecond = Annotated[float, "kg/s"]
KilogramPerJoule = Annotated[float, "kg/J"]


@formula("ΣP_VZ", "sum over the meshes, one after the other", names={"P": "ΣP_VZ"})
def and_mesh(P: Watt, P_VZ: Watt) -> Watt:
    return P + P_VZ


@formula("ΣP_W", "sum over the wheels, one after the other", names={"P": "ΣP_W"})
def and_windage(P: Watt, P_W: Watt) -> Watt:
    return P + P_W


@formula("ΣP_X", "sum over the wheels, one after the other", names={"P": "ΣP_X"})
def and_other_loss(P: Watt, P_X: Watt) -> Watt:
    return P + P_X


@formula("P", "sum of all losses of the train")
def total_loss(P_B: Watt, P_VZ: Watt, P_W: Watt, P_X: Watt) -> Watt:
    return P_B + P_VZ + P_W + P_X


@formula("T", "definition of torque")
def torque(P: Watt, n: RevPerSecond) -> NewtonMetre:
    return P / (2 * pi * n)


@formula("m_B", "definition of the specific fuel consumption", unit="g/h")
def fuel(b_e: KilogramPerJoule, P: Watt) -> KilogramPerSecond:
    return b_e * P


@result
class MeshResult:
    """One mesh: what is judged, and beside it the source's model and three regressions, all at the same power."""

    judged: MeshLoss = group(spread=True)
    power_in: Watt = value("Power that the mesh takes in", "W", "P_in")
    power_out: Watt = value("Power that the mesh passes on", "W", "P_out")
    ohlendorf_loss_factor: Number = value("Loss factor by Ohlendorf", "", "H_V")
    bulk_rise: Kelvin = value("Estimated warming of the teeth above the oil", "K", "ΔT_b")
    source: MeshLoss = group()
    by_regime: MeshLoss | None = group()
    schlenk: Regression = group()
    xu_kahraman: Regression | None = group()
    benedict_kelley: Regression = group()
    case: Case


@result
class WheelResult:
    """One wheel."""

    speed: RevPerSecond = value("Speed of the wheel", "rpm", "n")
    windage: Watt = value("Windage of the wheel", "W", "P_W")
    other_loss: Watt = value("Other losses carried by the wheel", "W", "P_X")


@result
class FrictionResult:
    """All meshes, all wheels and the closed balance."""

    meshes: dict[str, MeshResult] = group(spread=True)
    wheels: dict[str, WheelResult] = group(spread=True)
    oil_viscosity: PascalSecond = value("Viscosity of the oil between the teeth", "mPa·s", "η_0")
    bearing_loss: Watt | None = value("Bearings of the counter-shaft", "W", "P_B")
    mesh_loss: Watt = value("All meshes", "W", "ΣP_VZ")
    windage_loss: Watt = value("Windage of all wheels", "W", "ΣP_W")
    other_loss: Watt = value("Other losses", "W", "ΣP_X")
    total_loss: Watt = value("Sum of the losses", "W", "P")
    crank_power: Watt = value("Power at the first driver", "W", "P_1")
    crank_torque: NewtonMetre = value("Torque at the first driver", "N·m", "T_1")
    delivered_power: Watt | None = value("Power that the last wheel delivers", "W")
    fuel: KilogramPerSecond | None = value("Fuel that the losses cost", "g/h")
    residual: Watt  # of the balance
