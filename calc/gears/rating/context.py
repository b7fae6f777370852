# SPDX-License-Identifier: Apache-2.0
"""What the rating of a train works with: what is known around the gears, and what is the same for all meshes."""

from collections.abc import Mapping

from ...library.catalogue import Material
from ...library.lubricant import Lubricant
from ...sheet.formula import formula
from ...sheet.record import record
from ...sheet.text import Text
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


@formula("Ra", "ISO 6336-2: mean relation", unit="µm")
def mean_roughness(Rz: Metre) -> Metre:
    return Rz / RZ_PER_RA


@formula("Rz", "ISO 6336-2: mean relation", unit="µm")
def peak_to_valley(Ra: Metre) -> Metre:
    return RZ_PER_RA * Ra


@record
class Surroundings:
    """What the rating takes from outside the gears; what is None is not known."""

    uneven: Irregularity | None = None
    lubricant: Lubricant | None = None
    oil_temperature: Celsius | None = None
    flank_ra: tuple[Metre, Metre] | None = None  # Ra of driver and driven wheel


@record
class RatingContext:
    """What stays the same for all meshes.  A wheel without a strength class has no body: it is not rated."""

    gears: GearsInputs
    train: TrainResult
    materials: Mapping[str, Material]
    classes: dict[str, StrengthClass]  # by wheel, as are the bodies and X_W of scuffing
    bodies: dict[str, Body]
    structural: dict[str, Number]
    oil: OilBath | None
    nu_40: SquareMetrePerSecond | None  # of the oil at 40 °C; None: not known, REFERENCE_NU is taken
    flank_ra: tuple[Metre, Metre]
    flank_rz: Metre


def rating_context(gears: GearsInputs, train: TrainResult, materials: Mapping[str, Material], around: Surroundings) -> RatingContext:
    classes, bodies = dict[str, StrengthClass](), dict[str, Body]()
    for w in gears.wheels:
        wheel, solid = train.wheels[w.name], materials[w.material]
        strength = of_wheel(w, solid.E, solid.proof_stress)
        if strength is not None:
            classes[w.name] = strength
            inside = inner_diameter(wheel.root_diameter, w.bore_diameter, w.rim_thickness)
            bodies[w.name] = Body(wheel, solid.E, solid.density, strength.kind, strength.sigma_Hlim, inside)
    oil, structural, lubricant = None, dict[str, Number](), around.lubricant
    if lubricant is not None and around.oil_temperature is not None:
        oil = oil_bath(lubricant, around.oil_temperature, gears.lubrication)
        for name, strength in classes.items():
            with about(Text("wheel {name}, strength class", name=name)):
                structural[name] = structural_factor(kind=strength.kind)
    with about(Text("roughness of the flanks")):
        if gears.flank_rz is None and around.flank_ra is not None:
            flank_ra, flank_rz = around.flank_ra, peak_to_valley(Ra=max(around.flank_ra))
        else:
            flank_rz = gears.flank_rz if gears.flank_rz is not None else USUAL_RZ
            flank_ra = (mean_roughness(Rz=flank_rz),) * 2
    nu_40 = lubricant.nu40 if lubricant is not None else None
    return RatingContext(gears, train, materials, classes, bodies, structural, oil, nu_40, flank_ra, flank_rz)
