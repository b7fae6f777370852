# SPDX-License-Identifier: Apache-2.0
"""The forces on one crankpin, what the two main journals beside it carry, and the stresses.

Tangential: in the sense of rotation.  Radial: positive towards the crank axis.  The pin is loaded at its middle and the throw rests on the
middles of its two journals, which the textbooks take as simple supports.
"""

from ..sheet.formula import formula
from ..sheet.functions import cos, pi, power, sqrt, tan, total
from ..sheet.text import Text
from ..sheet.units import Kilogram, Metre, Newton, NewtonMetre, Number, Pascal, Radian, RadPerSecond

ROD = Text("statics of the slider-crank (Finotti 2013, 2.2.1)")
BEAM = Text("statics, simply supported throw, pin loaded at its middle (mechanics textbook, 48.7)")
NOTCH = Text("Norton, app. of stress-concentration factors, after Peterson: shouldered round shaft, D/d = 2")


# --- forces -----------------------------------------------------------------------------------------------------------------
@formula("F", Text("{rod}: force on the piston", rod=ROD))
def piston_force(F_G: Newton, F_I: Newton) -> Newton:
    return F_G + F_I


@formula("F_R", Text("{rod}: force in the rod, positive in compression", rod=ROD))
def rod_force(F: Newton, beta: Radian) -> Newton:
    return F / cos(beta)


@formula("F_N", Text("{rod}: side thrust on the liner", rod=ROD))
def side_thrust(F: Newton, beta: Radian) -> Newton:
    return F * tan(beta)


@formula("F_t", Text("{rod}: tangential force at the pin, torque over crank radius", rod=ROD))
def tangential_force(F: Newton, v_rel: Number) -> Newton:
    return F * v_rel


@formula("F_r", Text("{rod}: radial part of the rod's force, less the centrifugal force of its rotating mass", rod=ROD))
def radial_force(S: Newton, alpha: Radian, beta: Radian, M_rot: Kilogram, r: Metre, omega: RadPerSecond) -> Newton:
    return S * cos(alpha + beta) - M_rot * r * omega**2


@formula("ΣF", "mathematics: sum of the two rods on one pin")
def both_rods(F: Newton, F_other: Newton) -> Newton:
    return F + F_other


@formula("R", Text("{beam}: reaction of a main journal, half the pin's force", beam=BEAM))
def reaction(F_t: Newton, F_r: Newton) -> Newton:
    return sqrt(F_t**2 + F_r**2) / 2


@formula("T_v", "statics, torque through the front journal: sum over the cylinders on the throws in front")
def torque_in_front(F_t: Newton, r: Metre) -> NewtonMetre:
    return total(F_t) * r


# --- moments ----------------------------------------------------------------------------------------------------------------
@formula("L", Text("{beam}: distance of the journals' middles", beam=BEAM), unit="mm")
def span(l_j: Metre, t_w: Metre, l_p: Metre) -> Metre:
    return l_j + 2 * t_w + l_p


@formula("M_p", Text("{beam}: bending moment at the pin's middle, both planes", beam=BEAM))
def pin_bending(R: Newton, L: Metre) -> NewtonMetre:
    return R * L / 2


@formula("M_pf", Text("{beam}: bending moment at the pin's fillet", beam=BEAM))
def pin_fillet_bending(R: Newton, l_j: Metre, t_w: Metre) -> NewtonMetre:
    return R * (l_j / 2 + t_w)


@formula("M_j", Text("{beam}: bending moment at the journal's edge to the web", beam=BEAM))
def journal_bending(R: Newton, l_j: Metre) -> NewtonMetre:
    return R * l_j / 2


@formula("T_p", Text("{beam}: torsion of the pin, by the front journal's reaction and the torque from the throws in front", beam=BEAM))
def pin_torsion(F_t: Newton, r: Metre, T_v: NewtonMetre) -> NewtonMetre:
    return F_t * r / 2 + T_v


@formula("T_j", "statics, torque behind the throw: its own and that of the throws in front")
def journal_torsion(F_t: Newton, r: Metre, T_v: NewtonMetre) -> NewtonMetre:
    return F_t * r + T_v


# --- stresses ---------------------------------------------------------------------------------------------------------------
@formula("σ", "elasticity: elementary bending of a solid round section, nominal", unit="MPa")
def bending_stress(M: NewtonMetre, d: Metre) -> Pascal:
    return 32 * M / (pi * d**3)


@formula("τ", "elasticity: elementary torsion of a solid round section, nominal", unit="MPa")
def torsion_stress(T: NewtonMetre, d: Metre) -> Pascal:
    return 16 * T / (pi * d**3)


@formula("σ_v", "elasticity: equivalent stress after von Mises, bending and torsion", unit="MPa")
def von_mises(sigma: Pascal, tau: Pascal) -> Pascal:
    return sqrt(sigma**2 + 3 * tau**2)


@formula("ρ/d", "definition: relative fillet radius")
def relative_fillet(rho: Metre, d: Metre) -> Number:
    return rho / d


@formula("K_b", Text("{notch}, bending", notch=NOTCH))
def notch_bending(rho_d: Number) -> Number:
    return 0.90879 * power(rho_d, -0.28598)


@formula("K_t", Text("{notch}, torsion", notch=NOTCH))
def notch_torsion(rho_d: Number) -> Number:
    return 0.86331 * power(rho_d, -0.23865)


@formula("σ_vk", "elasticity: equivalent stress after von Mises at the fillet, elastic", unit="MPa")
def notch_stress(K_b: Number, sigma: Pascal, K_t: Number, tau: Pascal) -> Pascal:
    return sqrt((K_b * sigma) ** 2 + 3 * (K_t * tau) ** 2)
