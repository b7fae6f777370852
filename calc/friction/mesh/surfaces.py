# SPDX-License-Identifier: Apache-2.0
"""What of the flanks rubs, by the model that is judged and by the friction source's."""

from dataclasses import replace
from typing import Annotated

import numpy as np

from ...library.contact import mean_roughness
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.functions import cos
from ...sheet.record import record
from ...sheet.text import Amount, Text
from ...sheet.units import KelvinPerWatt, Metre, Number, Radian
from ..inputs import FrictionInputs
from .geometry import MeshGeometry, require
from .mixed import BOUNDARY, DRY, LOAD_SHARES, LoadShare, combined_roughness

KelvinMetrePerWatt = Annotated[float, "K·m/W"]
MICROMETRE: Metre = 1e-6


@formula("M", "definition: resistance of a wheel's body, per length of contact line")
def body_resistance(R_K: KelvinPerWatt, b: Metre, beta_b: Radian) -> KelvinMetrePerWatt:
    return R_K * b / cos(beta_b)


@record
class Surfaces:
    """How the flanks rub by one model: combined and mean roughness, friction of the solids and their share of the load; the viscosity law
    under pressure, and whether the film has only the pressure that it carries, by which α falls; resistance of the bodies."""

    sigma: Metre
    Ra: Metre
    mu_s: Number
    load_share: str
    roelands: bool
    relieved: bool
    M_1: KelvinMetrePerWatt
    M_2: KelvinMetrePerWatt

    @property
    def mixing(self) -> LoadShare:
        return LOAD_SHARES[self.load_share]


def surfaces_of(friction: FrictionInputs, mesh: MeshGeometry) -> tuple[Surfaces, Surfaces]:
    """As judged and as the friction source has them.  What the design says of solid friction and viscosity law counts for both."""
    Ra_1, Ra_2 = friction.flank_roughness[0], friction.flank_roughness[-1]
    for Ra in (Ra_1, Ra_2):
        require(Text("flank roughness"), Ra)
    sigma = combined_roughness(Ra_1=Ra_1, Ra_2=Ra_2)
    if np.any(sigma == 0):
        smooth = Text("{ra_1} µm is so small that its square is 0", ra_1=Amount(Ra_1 / MICROMETRE))
        raise NoSolution(Text("flank roughness"), smooth, Text("give friction.flank_roughness_um of a real flank: 0.1 to 2 µm"))
    mu_s, law = friction.solid_friction, friction.pressure_law
    if mu_s is not None:
        require(Text("friction of the solids"), mu_s, zero=True)
    M_1 = M_2 = 0.0
    if (bodies := friction.body_resistance) is not None:
        M_1, M_2 = (body_resistance(R_K=R_K, b=mesh.face_width, beta_b=mesh.base_helix_angle) for R_K in (bodies[0], bodies[-1]))
    judged = Surfaces(
        sigma=sigma, Ra=mean_roughness(Ra_1=Ra_1, Ra_2=Ra_2), mu_s=BOUNDARY if mu_s is None else mu_s, load_share=friction.load_share,
        roelands=law != "barus", relieved=True, M_1=M_1, M_2=M_2,
    )  # fmt: skip
    mu_s = DRY if mu_s is None else mu_s
    return judged, replace(judged, mu_s=mu_s, load_share="thesis", roelands=law == "roelands", relieved=False)
