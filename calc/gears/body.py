# SPDX-License-Identifier: Apache-2.0
"""The bodies of the wheels: what each weighs."""

from collections.abc import Mapping
from dataclasses import replace

from ..library.catalogue import Material
from ..sheet.formula import formula
from ..sheet.functions import pi
from ..sheet.step import Outcome
from ..sheet.text import Text
from ..sheet.trace import about, trace
from ..sheet.units import Kilogram, KilogramPerMetre3, Metre
from .inputs import GearsInputs
from .rating.influence import inner_diameter
from .result import TrainResult


@formula("m_W", "geometry: disc of the reference diameter, open inside its rim or its bore")
def wheel_mass(rho: KilogramPerMetre3, b: Metre, d: Metre, d_i: Metre) -> Kilogram:
    """>>> wheel_mass(rho=7860, b=0.015, d=0.054, d_i=0.0)
    0.27001...
    """
    return pi / 4 * rho * b * (d**2 - d_i**2)


def with_masses(outcome: Outcome[TrainResult], gears: GearsInputs, materials: Mapping[str, Material]) -> Outcome[TrainResult]:
    """The same outcome with the mass of each wheel."""
    train = outcome.solution
    wheels = {}
    with trace() as lines:
        for own in gears.wheels:
            wheel = train.wheels[own.name]
            with about(Text("wheel {name}, mass", name=own.name)):
                inside = inner_diameter(wheel.root_diameter, own.bore_diameter, own.rim_thickness)
                m = wheel_mass(rho=materials[wheel.material].density, b=wheel.face_width, d=wheel.reference_diameter, d_i=inside)
            wheels[own.name] = replace(wheel, mass=m)
    return replace(outcome, result=replace(train, wheels=wheels), lines=(*outcome.lines, *lines))
