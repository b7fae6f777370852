# SPDX-License-Identifier: Apache-2.0
"""What the rating of a train works with: what is known around the gears, and what is the same for all meshes."""

from collections.abc import Mapping

from ...catalogue import Material
from ...lubricant import Lubricant
from ...sheet.formula import formula
from ...sheet.record import record
from ...sheet.trace import about
from ...sheet.units import Celsius, Metre, Number, SquareMetrePerSecond
from ..inputs import GearsInputs
from ..result import TrainResult
from .classes import StrengthClass, of_wheel
from .influence import Side as Body
from .influence import inner_diameter
from .load import Irregularity
from .screening.load import OilBath, oil_bath, structural_factor

RZ_PER_RA = 6.0  # ISO 6336-2: Ra = Rz/6
USUAL_RZ: Metre = 4e-6  # of ground flanks, where no roughness is given
REFERENCE_NU: SquareMetrePerSecond = 100e-6  # ISO 6336-2: Z_L is 1 at 100 mm²/s at 40 °C


@formula("Ra", "ISO 6336-2, as generally published: mean relation", unit="µm")
def mean_roughness(Rz: Metre) -> Metre:
    return Rz / RZ_PER_RA


@formula("Rz", "ISO 6336-2, as generally published: mean relation", unit="µm")
def peak_to_valley(Ra: Metre) -> Metre:
    return RZ_PER_RA * Ra


@record
class Around:
    """What the rating takes from outside the gears; what is None is not known."""

    uneven: Irregularity | None = None
    lubricant: Lubricant | None = None
    oil_temperature: Celsius | None = None
    flank_ra: tuple[Metre, Metre] | None = None  # Ra of driver and driven wheel


@record
class Desk:
    """What stays the same for all meshes.  A wheel without a strength class has no body: it is not rated."""

    gears: GearsInputs
    train: TrainResult
    materials: Mapping[str, Material]
    classes: dict[str, StrengthClass]
    bodies: dict[str, Body]
    structural: dict[str, Number]  # X_W of scuffing
    oil: OilBath | None
    nu_40: SquareMetrePerSecond
    flank_ra: tuple[Metre, Metre]
    flank_rz: Metre


def desk(gears: GearsInputs, train: TrainResult, materials: Mapping[str, Material], around: Around) -> Desk:
    classes, bodies = dict[str, StrengthClass](), dict[str, Body]()
    for w in gears.wheels:
        strength = of_wheel(w, materials[w.material].E, materials[w.material].proof_stress)
        if strength is None:
            continue
        classes[w.name] = strength
        wheel, solid = train.wheels[w.name], materials[w.material]
        inside = inner_diameter(wheel.root_diameter, w.bore_diameter, w.rim_thickness)
        bodies[w.name] = Body(wheel, solid.E, solid.density, strength.kind, strength.sigma_Hlim, inside)
    oil, nu_40, structural = None, REFERENCE_NU, dict[str, Number]()
    if around.lubricant is not None:
        nu_40 = around.lubricant.oil.nu40
        if around.oil_temperature is not None:
            oil = oil_bath(around.lubricant, around.oil_temperature, gears.lubrication)
            for name, strength in classes.items():
                with about(f"wheel {name}, strength class"):
                    structural[name] = structural_factor(kind=strength.kind)
    with about("roughness of the flanks"):
        if gears.flank_rz is not None or around.flank_ra is None:
            flank_rz = gears.flank_rz if gears.flank_rz is not None else USUAL_RZ
            ra = mean_roughness(Rz=flank_rz)
            flank_ra = (ra, ra)
        else:
            flank_ra = around.flank_ra
            flank_rz = peak_to_valley(Ra=max(flank_ra))
    return Desk(gears, train, materials, classes, bodies, structural, oil, nu_40, flank_ra, flank_rz)
