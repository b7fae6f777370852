# SPDX-License-Identifier: Apache-2.0
"""The points on the path of contact, and what the two flanks are and do there.

A place is told by ρ_1, the radius of curvature of the driver's flank in the transverse section: 0 where the line of action touches its
base circle, T_1T_2 at that of the driven wheel.  A: contact begins; B: the pair before leaves; C: pitch point; D: the next pair comes;
E: contact ends.  The pair is loaded alone from B to D.  Speeds are those of the transverse section, as ISO and AGMA use them.
"""

from ..sheet.formula import formula
from ..sheet.functions import cos, modulus, pi
from ..sheet.text import Text
from ..sheet.units import Metre, MetrePerSecond, Number, Radian, RevPerSecond

GEOMETRY = Text("ISO 21771:2007")


@formula("ρ_B", "geometry: one base pitch before the end of contact", unit="mm")
def sole_contact_begins(rho_E: Metre, p_bt: Metre) -> Metre:
    return rho_E - p_bt


@formula("ρ_D", "geometry: one base pitch after the beginning of contact", unit="mm")
def sole_contact_ends(rho_A: Metre, p_bt: Metre) -> Metre:
    return rho_A + p_bt


@formula(
    "ρ_C", Text("{geometry}: the driver's radius of curvature at the pitch point", geometry=GEOMETRY), unit="mm", names={"T": "T_1T_2"}
)
def pitch_point(T: Metre, z_1: Number, z_2: Number) -> Metre:
    return T * z_1 / (z_1 + z_2)


@formula("ρ_2", Text("{geometry}: radius of curvature of the driven flank", geometry=GEOMETRY), unit="mm", names={"T": "T_1T_2"})
def driven_curvature(T: Metre, rho_1: Metre) -> Metre:
    return T - rho_1


@formula("ρ_rel", "ISO/TR 13989-1:2000 (6): relative radius of curvature, transverse", unit="mm")
def relative_radius(rho_1: Metre, rho_2: Metre) -> Metre:
    """>>> relative_radius(rho_1=0.009905, rho_2=0.01426)
    0.005845036...
    """
    return rho_1 * rho_2 / (rho_1 + rho_2)


@formula("ρ_n", "ISO/TR 15144-1:2014 (45), AGMA 925-A03: relative radius of curvature, normal to the contact line", unit="mm")
def normal_relative_radius(rho_rel: Metre, beta_b: Radian) -> Metre:
    return rho_rel / cos(beta_b)


@formula("v_r", "ISO/TR 15144-1:2014 (14), (15), AGMA 925-A03: rolling speed of a flank, along itself", names={"rho": "ρ_y"})
def rolling_speed(n: RevPerSecond, rho: Metre) -> MetrePerSecond:
    return 2 * pi * modulus(n) * rho


@formula("ε_1", "ISO/TR 15144-1:2014: contact ratio of the driver's addendum, recess", names={"rho_E": "ρ_E", "rho_C": "ρ_C"})
def recess_contact_ratio(rho_E: Metre, rho_C: Metre, p_bt: Metre) -> Number:
    return (rho_E - rho_C) / p_bt


@formula("ε_2", "ISO/TR 15144-1:2014: contact ratio of the driven wheel's addendum, approach")
def approach_contact_ratio(rho_C: Metre, rho_A: Metre, p_bt: Metre) -> Number:
    return (rho_C - rho_A) / p_bt
