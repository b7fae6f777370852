# SPDX-License-Identifier: Apache-2.0
"""What the friction step publishes, and the sums that close its balance."""

from typing import Annotated, Any

from ..countershaft.rows import IN_WORDS
from ..sheet.formula import formula
from ..sheet.functions import pi
from ..sheet.quantity import group, result, value
from ..sheet.shown import Shown
from ..sheet.text import EMPTY, Text
from ..sheet.units import Celsius, Kelvin, Newton, NewtonMetre, Number, PascalSecond, RevPerSecond, Watt
from ..sheet.value import based_on
from .losses.turning_masses import MassLoss
from .losses.wheels import WheelResult
from .mesh.loss import MeshCase, MeshLoss
from .models import MODELS, Regression

KilogramPerSecond = Annotated[float, "kg/s"]
KilogramPerJoule = Annotated[float, "kg/J"]


@formula("T", "definition of torque")
def torque(P: Watt, n: RevPerSecond) -> NewtonMetre:
    return P / (2 * pi * n)


@formula("m_B", "definition of the specific fuel consumption", unit="g/h")
def fuel(b_e: KilogramPerJoule, P: Watt) -> KilogramPerSecond:
    return b_e * P


@formula("m_CO2", "physics: carbon of the fuel, burnt completely", unit="g/h", names={"e_CO2": "e_CO2"})
def carbon_dioxide(e_CO2: Number, m_B: KilogramPerSecond) -> KilogramPerSecond:
    return e_CO2 * m_B


@formula("P/P_e", "definition: losses of the train over the engine's rated power")
def engine_share(P: Watt, P_e: Watt) -> Number:
    return P / P_e


@formula("P_B/P_e", "definition: losses of the bearings of all shafts over the engine's rated power")
def bearing_share(P_B: Watt, P_e: Watt) -> Number:
    return P_B / P_e


@result
class MeshResult(Shown):
    """One mesh: what is judged, and beside it the source's model and the published ones, all at the same power."""

    judged: MeshLoss = group(spread=True)
    power_in: Watt = value("Power that the mesh takes in", "W", "P_in")
    power_out: Watt = value("Power that the mesh passes on", "W", "P_out")
    ohlendorf_loss_factor: Number = value("Loss factor by Ohlendorf", "", "H_v")
    bulk_rise: Kelvin = value("Estimated warming of the teeth above the oil", "K", "ΔT_b")
    source: MeshLoss | None = group(short=False, words="source")  # None: nothing was to be compared
    by_regime: MeshLoss | None = group(short=False)
    published_models: dict[str, Regression | None] = group(
        spread=True, key_words={name: model.brief for name, model in MODELS.items()}
    )
    model_spread: Number | None = value("Largest loss of all models over the smallest", "", "P_max/P_min")
    case: MeshCase


def by_regime(mesh: MeshResult) -> MeshLoss:
    """The loss by the regime that governs, judged or shown beside."""
    return mesh.by_regime or mesh.judged


@result
class StageLoss(Shown):
    """One chain or belt."""

    power_in: Watt = value("Power that the chain or belt takes in", "W", "P_in")
    power_out: Watt = value("Power that the chain or belt passes on", "W", "P_out")
    loss: Watt = value("Loss of the chain or belt", "W", "P_K")


DIPPED = "Loss of the turning masses in oil at rest, at most; not counted"


@result
class ShaftLoss(Shown):
    """One of several shafts."""

    bearing_loss: Watt = value("Bearings of the shaft", "W", "P_B")
    masses: MassLoss | None = group(spread=True)
    dip_loss_most: Watt | None = value(DIPPED, "W", "P_D,max")


@result
class JournalResult(Shown):
    """One journal of the counter-shaft in the balance: its friction over a turn, with what stands still beside the
    turning load."""

    standing_load: Newton | None = value("Standing load of the journal: weight and gear force", "N", "R_0")
    friction_power: Watt = value("Friction of the journal over a turn", "W", "P_f")


@result
class ScenarioMesh(Shown):
    """One mesh under the conditions of a scenario: judged, and by the source's model."""

    judged: MeshLoss = group(spread=True)
    source: MeshLoss | None = group(words="source")


@result
class ScenarioResult(Shown):
    """One scenario."""

    meshes: dict[str, ScenarioMesh] = group(spread=True)
    oil_viscosity: PascalSecond = value("Viscosity of the oil between the teeth", "mPa·s", "η_0")
    mesh_loss: Watt | None = value("All meshes", "W", "ΣP_VZ")
    bearing_loss: Watt | None = value("Bearings of the counter-shaft", "W", "P_B")
    mass_loss: Watt | None = value("Loss of the turning masses, counted", "W", "P_M")
    total_loss: Watt = value("Sum of the losses", "W", "P")
    share: Number | None = value("Losses over the power at the first driver", "%")
    crank_torque: NewtonMetre = value("Torque at the first driver", "N·m", "T_1")
    delivered_power: Watt | None = value("Power that the last wheel delivers", "W")
    about: Text = EMPTY  # oil, temperature, load sharing in words
    oil: str = ""
    figure: str = ""  # in which it is drawn
    temperature: Celsius


@result
class FrictionResult(Shown):
    """All meshes, all wheels and the closed balance."""

    meshes: dict[str, MeshResult] = group(spread=True)
    stages: dict[str, StageLoss] = group(spread=True)
    wheels: dict[str, WheelResult] = group(spread=True)
    shafts: dict[str, ShaftLoss] | None = group(spread=True, default=None)  # where there are several
    journals: dict[str, dict[str, JournalResult]] = group(  # by shaft
        words="journals", key_words=IN_WORDS, named="several"
    )
    scenarios: dict[str, ScenarioResult] | None = group(short=False, default=None, words="scenarios")
    oil_viscosity: PascalSecond = value("Viscosity of the oil between the teeth", "mPa·s", "η_0", short=True)
    bearing_loss: Watt | None = value("Bearings of the counter-shaft", "W", "P_B", short=True)
    masses: MassLoss | None = group(spread=True)  # of all shafts; None: not counted, or no sector is known
    dip_loss_most: Watt | None = value(DIPPED, "W", "P_D,max", short=True)
    mesh_loss: Watt | None = value("All meshes", "W", "ΣP_VZ", short=True)
    stage_loss: Watt | None = value("All chains and belts", "W", "ΣP_K")
    windage_loss: Watt | None = value("Windage of all wheels", "W", "ΣP_W", short=True)
    churning_loss: Watt | None = value("Churning of all wheels", "W", "ΣP_C")
    thrown_oil_loss: Watt | None = value("Oil thrown onto the wheels", "W", "ΣP_J")
    seal_loss: Watt | None = value("Shaft seals", "W", "ΣP_D")
    wheel_bearing_loss: Watt | None = value("Bearings of the wheels", "W", "ΣP_L")
    other_loss: Watt = value("Other losses", "W", "ΣP_X")
    total_loss: Watt = value("Sum of the losses", "W", "P", short=True, page_one=1, headline=1)
    engine_share: Number | None = value("Losses over the engine's rated power", "%", "P/P_e", default=None, short=True)
    bearing_share: Number | None = value(
        "Losses of the bearings of all shafts over the engine's rated power", "%", "P_B/P_e", default=None
    )
    crank_power: Watt = value("Power at the first driver", "W", "P_1")
    crank_torque: NewtonMetre = value("Torque at the first driver", "N·m", "T_1", short=True, page_one=2, headline=2)
    delivered_power: Watt | None = value("Power that the last wheel delivers", "W")
    carried_power: Watt | None = value("Power that hangs on the shafts, carried and not lost", "W", "P_C", short=True)
    fuel: KilogramPerSecond | None = value("Fuel that the losses cost", "g/h", "m_B", short=True)
    co2: KilogramPerSecond | None = value("CO₂ that the losses cost", "g/h", "m_CO2")
    residual: Watt  # of the balance
    drive: Any = None  # the TrainDrive that was balanced, and the shafts OnShaft that it turns, by name: see drag.py
    on: Any = None

    @property
    def mass_loss(self) -> Watt | None:
        """What the turning masses lose, as counted."""
        return None if self.masses is None else self.masses.mass_loss

    def at_teeth(self, wheel: str) -> Watt | None:
        """What the teeth of a wheel carry, as if all pushed one way: what it takes in by a mesh, and what its meshes
        pass on; None where it has none."""
        takes = [mesh.power_out for mesh in self.meshes.values() if mesh.case.mesh.driven.name == wheel]
        drives = [mesh.power_in for mesh in self.meshes.values() if mesh.case.mesh.driver.name == wheel]
        return based_on(sum(takes + drives), *takes, *drives) if takes or drives else None
