# SPDX-License-Identifier: Apache-2.0
"""The friction step in the whole chain: its meshes from the geometry of the train, its load from the losses of the journals."""

from collections.abc import Mapping
from dataclasses import replace

from ..bearings.result import BearingsResult
from ..catalogue import Material, Oil
from ..gears.inputs import GearsInputs
from ..gears.result import TrainResult
from ..lubricant import Lubricant
from ..sheet.formula import formula
from ..sheet.step import Outcome
from ..sheet.trace import about, trace
from ..sheet.units import Celsius, RevPerSecond, Watt
from .inputs import FrictionInputs
from .mesh import MeshGeometry, WheelGeometry
from .solve import closure


@formula("P_B", "sum of both journals' friction, as judged", names={"P_front": "P_f,front", "P_rear": "P_f,rear"})
def bearing_loss(P_front: Watt, P_rear: Watt) -> Watt:
    return P_front + P_rear


def meshes_of(train: TrainResult, materials: Mapping[str, Material]) -> dict[str, MeshGeometry]:
    """The meshes of a train along the flow of power, with what friction needs of them."""
    wheels = {
        name: WheelGeometry(
            name=name, teeth=w.teeth, reference_radius=w.pitch_diameter / 2, base_radius=w.base_diameter / 2, tip_radius=w.tip_diameter / 2,
            face_width=w.face_width, E=materials[w.material].E, poisson=materials[w.material].poisson,
        )
        for name, w in train.wheels.items()
    }  # fmt: skip
    beta_b = train.system.base_helix_angle
    return {key: MeshGeometry(wheels[m.driver], wheels[m.driven], m.centre_distance, beta_b) for key, m in train.meshes.items()}


def solve(
    friction: FrictionInputs, gears: GearsInputs, train: TrainResult, bearings: BearingsResult | None, first_speed: RevPerSecond,
    oil: Oil, viscosity_law: str, oil_temperature: Celsius, materials: Mapping[str, Material],
) -> Outcome:  # fmt: skip
    """Losses of all meshes and the closed power balance.  `bearings` None: a train alone, whose first driver's power is given."""
    shaft_power: Watt | None = None
    with trace() as lines:
        with about("oil"):
            lubricant = Lubricant(oil, viscosity_law)
        if bearings is not None:
            shaft_power = bearing_loss(*(b.friction_power for b in bearings.bearings.values()))
    outcome = closure(
        friction, meshes_of(train, materials), lubricant, oil_temperature, shaft_power, first_speed,
        power=gears.power if bearings is None else None,
    )  # fmt: skip
    return replace(outcome, lines=(*lines, *outcome.lines), notes=(*outcome.notes, *_notes(gears, bearings is not None)))


def _notes(gears: GearsInputs, closed: bool) -> tuple[str, ...]:
    """What the given power means."""
    if not closed:
        return ("The power at the first driver is gears.power_kW, which its first mesh takes in, plus its own windage and other losses.",)
    if gears.power is not None:
        return ("gears.power_kW rates the teeth only; the losses are those of the closed balance.",)
    return ()
