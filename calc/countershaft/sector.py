# SPDX-License-Identifier: Apache-2.0
"""The cross-section of the shaft: a core of radius r_0 and on it a sector of half-angle γ out to the radius R.

Area and static moment are those of the sector alone, without the core; valid for 0 < γ ≤ π.  All formulas take arrays.
"""

from ..sheet.formula import formula
from ..sheet.functions import cos, pi, sin
from ..sheet.text import Text
from ..sheet.units import CubicMetre, Kilogram, KilogramMetre, KilogramPerMetre3, Metre, Metre4, Radian, SquareMetre

SECTOR = Text("geometry of the circular sector between the radii r_0 and R")


@formula("A", SECTOR, unit="mm²")
def sector_area(gamma: Radian, R: Metre, r_0: Metre) -> SquareMetre:
    """>>> sector_area(gamma=1.59, R=0.0405, r_0=0.015)
    0.002250247...
    """
    return gamma * (R**2 - r_0**2)


@formula("S", Text("{sector}: static moment of the sector about the axis", sector=SECTOR), unit="mm³")
def sector_moment(gamma: Radian, R: Metre, r_0: Metre) -> CubicMetre:
    """>>> sector_moment(gamma=1.336, R=0.043, r_0=0.018)
    4.776899...e-05
    """
    return 2 / 3 * sin(gamma) * (R**3 - r_0**3)


@formula("e", "geometry: centre of gravity of the sector from the axis", unit="mm")
def centre_of_gravity(S: CubicMetre, A: SquareMetre) -> Metre:
    """>>> centre_of_gravity(S=4.777e-05, A=0.002038)
    0.02343964...
    """
    return S / A


@formula("m", "geometry: mass of a sector of length b", unit="kg")
def sector_mass(rho: KilogramPerMetre3, A: SquareMetre, b: Metre) -> Kilogram:
    """>>> sector_mass(rho=7860, A=0.002038, b=0.1195)
    1.914232...
    """
    return rho * A * b


@formula("U", "geometry: unbalance of a sector of length b", unit="g·mm")
def sector_unbalance(rho: KilogramPerMetre3, S: CubicMetre, b: Metre) -> KilogramMetre:
    """>>> sector_unbalance(rho=7860, S=4.777e-05, b=0.1195)
    0.04486892...
    """
    return rho * S * b


@formula("A_tot", "geometry: sector and core", unit="mm²")
def whole_area(A: SquareMetre, r_0: Metre) -> SquareMetre:
    return A + pi * r_0**2


@formula("ȳ", "geometry: centre of gravity of sector and core from the axis", unit="mm")
def whole_centre(S: CubicMetre, A_tot: SquareMetre) -> Metre:
    return S / A_tot


@formula(
    "I_sym",
    "geometry: second moment of sector and core about their own centre, bending in the plane of symmetry",
    unit="mm⁴",
    names={"y": "ȳ"},
)
def sector_inertia(R: Metre, r_0: Metre, gamma: Radian, A_tot: SquareMetre, y: Metre) -> Metre4:
    """The smaller of the two main second moments."""
    return (R**4 - r_0**4) / 4 * (gamma + sin(gamma) * cos(gamma)) + pi * r_0**4 / 4 - A_tot * y**2


@formula("A", "geometry: full cylinder", unit="mm²")
def cylinder_area(R: Metre) -> SquareMetre:
    return pi * R**2


@formula("I", "geometry: second moment of a full cylinder", unit="mm⁴")
def cylinder_inertia(R: Metre) -> Metre4:
    return pi * R**4 / 4


@formula("I_p", "geometry, polar moment of sector and core about the axis; a full cylinder: γ = π", unit="mm⁴")
def polar_moment(gamma: Radian, R: Metre, r_0: Metre) -> Metre4:
    return gamma * (R**4 - r_0**4) / 2 + pi * r_0**4 / 2
