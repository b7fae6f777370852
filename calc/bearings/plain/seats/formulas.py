# SPDX-License-Identifier: Apache-2.0
"""A bush or shell in its housing: two rings pressed together, over temperature, and the clearance that they leave.

d_i: bore of the bush as assembled, d_o: bore of the housing, D: outside of a ring as stiff as the metal around it, all
at the reference temperature.  δ: diametral interference, below nought it is play.  The lining is counted as backing."""

from ....sheet.formula import formula
from ....sheet.functions import largest, pi, sqrt
from ....sheet.units import (
    Celsius,
    Metre,
    Newton,
    NewtonMetre,
    Number,
    Pascal,
    PerKelvin,
    PerPascal,
    Radian,
    RadPerSecond,
    Watt,
)

LAME = "elasticity: thick rings in plane stress (Lamé)"
NO_INTERFERENCE: Metre = 0.0


# --- two rings


@formula("d_i", "geometry: bore as assembled", unit="mm")
def assembled_bore(d_J: Metre, g: Metre) -> Metre:
    return d_J + g


@formula("d_o", "geometry: outside of bush or shells, pressed in", unit="mm")
def outside_of_bush(d_i: Metre, w: Metre) -> Metre:
    return d_i + 2 * w


@formula("D", "rule of this program: metal around the bore", unit="mm", names={"D_rel": "(D/d_o)"})
def housing_outside(D_rel: Number, d_o: Metre) -> Metre:
    return D_rel * d_o


@formula("k_B", f"{LAME}: compliance of the bush at its outside", names={"nu_B": "ν_B"})
def bush_compliance(d_o: Metre, d_i: Metre, nu_B: Number, E_B: Pascal) -> PerPascal:
    """Half the change of its outside diameter, over that diameter and the pressure."""
    return ((d_o**2 + d_i**2) / (d_o**2 - d_i**2) - nu_B) / E_B


@formula("k_H", f"{LAME}: compliance of the housing at its bore", names={"nu_H": "ν_H"})
def housing_compliance(D: Metre, d_o: Metre, nu_H: Number, E_H: Pascal) -> PerPascal:
    return ((D**2 + d_o**2) / (D**2 - d_o**2) + nu_H) / E_H


@formula("p", f"{LAME}: interference over what both rings give way; none where it is play", unit="MPa")
def press(delta: Metre, d_o: Metre, k_B: PerPascal, k_H: PerPascal) -> Pascal:
    return largest(delta, NO_INTERFERENCE) / (d_o * (k_B + k_H))


@formula("c_i", f"{LAME}: by which the bore of the bush closes", unit="µm")
def closing(p: Pascal, d_i: Metre, d_o: Metre, E_B: Pascal) -> Metre:
    return 2 * p * d_i * d_o**2 / (E_B * (d_o**2 - d_i**2))


@formula("g_H", f"{LAME}: by which the bore of the housing widens", unit="µm")
def housing_growth(p: Pascal, d_o: Metre, k_H: PerPascal) -> Metre:
    return p * d_o * k_H


@formula("σ_B", f"{LAME}: hoop stress at the bore of the bush", unit="MPa")
def bush_stress(p: Pascal, d_o: Metre, d_i: Metre) -> Pascal:
    return -2 * p * d_o**2 / (d_o**2 - d_i**2)


@formula("σ_H", f"{LAME}: hoop stress of the housing at its bore", unit="MPa")
def housing_tension(p: Pascal, D: Metre, d_o: Metre) -> Pascal:
    return p * (D**2 + d_o**2) / (D**2 - d_o**2)


@formula("σ_v", "elasticity: von Mises stress of hoop tension and pressure p", unit="MPa", names={"sigma_H": "σ_H"})
def housing_stress(sigma_H: Pascal, p: Pascal) -> Pascal:
    return sqrt(sigma_H**2 + sigma_H * p + p**2)


# --- shells


@formula(
    "δ",
    "statics: crush of each half over the half circumference, and what the checking load shortens the half by "
    "(uniform stress, no friction in the gauge)",
    unit="µm",
)
def interference_of_crush(c: Metre, F_c: Newton, d_o: Metre, E_B: Pascal, w: Metre, b: Metre) -> Metre:
    """`c`: excess of one half's outer length over half the bore's circumference, both halves alike.

    >>> interference_of_crush(c=30e-6, F_c=0, d_o=0.033, E_B=206e9, w=1.5e-3, b=0.02)
    1.9098593...e-05
    """
    return 2 * (c + F_c * pi * d_o / (2 * E_B * w * b)) / pi


# --- over temperature


@formula(
    "δ_T",
    "physics: interference at a temperature, by the expansion of bush and housing; χ, share of the housing's "
    "expansion held back by the block",
    unit="µm",
)
def interference_at(
    delta: Metre,
    d_o: Metre,
    alpha_B: PerKelvin,
    T_B: Celsius,
    alpha_H: PerKelvin,
    chi: Number,
    T_H: Celsius,
    T_ref: Celsius,
) -> Metre:
    return delta + d_o * (alpha_B * (T_B - T_ref) - alpha_H * (1 - chi) * (T_H - T_ref))


@formula(
    "d_iT",
    "physics: bore of the bush at a temperature: free it grows by itself, pressed it is closed",
    unit="mm",
)
def bore_at(d_i: Metre, c_i: Metre, alpha_B: PerKelvin, T_B: Celsius, T_ref: Celsius, c_T: Metre) -> Metre:
    """`c_i`: closing at the reference temperature, `c_T`: at this one."""
    return (d_i + c_i) * (1 + alpha_B * (T_B - T_ref)) - c_T


@formula("d_iT", "physics: bore of a seat in the housing itself at a temperature", unit="mm")
def own_bore_at(d_i: Metre, alpha_H: PerKelvin, chi: Number, T: Celsius, T_ref: Celsius) -> Metre:
    return d_i * (1 + alpha_H * (1 - chi) * (T - T_ref))


@formula("g_T", "geometry: bore less journal, each at its temperature", unit="µm")
def clearance_in(d_iT: Metre, d_J: Metre, alpha_J: PerKelvin, T: Celsius, T_ref: Celsius) -> Metre:
    """Negative: the journal is seized."""
    return d_iT - d_J * (1 + alpha_J * (T - T_ref))


@formula("α_eff", "physics: expansion of the assembled bore while the fit is tight", names={"s": "(c_i/δ)"})
def bore_expansion(alpha_B: PerKelvin, s: Number, d_o: Metre, d_i: Metre, alpha_H: PerKelvin, chi: Number) -> PerKelvin:
    """A thin wall in a stiff block follows the block, a thick one does not."""
    return alpha_B + s * (d_o / d_i) * (alpha_H * (1 - chi) - alpha_B)


@formula(
    "T_0",
    "physics: temperature at which the interference is used up, all parts alike warm: from there on where the "
    "housing grows more, down from there where it grows less",
)
def loose_at(T_ref: Celsius, delta: Metre, d_o: Metre, alpha_H: PerKelvin, chi: Number, alpha_B: PerKelvin) -> Celsius:
    return T_ref + delta / (d_o * (alpha_H * (1 - chi) - alpha_B))


# --- does it turn


@formula(
    "p_need",
    "statics, an estimate: pressure q·cos θ around the seat that carries the load and opens nowhere",
    unit="MPa",
)
def press_needed(F: Newton, d_o: Metre, l: Metre) -> Pascal:
    """>>> press_needed(F=2473, d_o=0.031, l=0.018)
    2821434.9...
    """
    return 2 * F / (pi * d_o * l)


@formula("M_h", "statics: friction that holds the bush, all around", unit="N·m", names={"mu_s": "μ_s"})
def holding_torque(mu_s: Number, p: Pascal, d_o: Metre, l: Metre) -> NewtonMetre:
    return mu_s * p * pi * d_o**2 * l / 2


@formula("M_f", "definition of power: torque of the film on the bush", unit="N·m")
def drag_torque(P_f: Watt, omega: RadPerSecond) -> NewtonMetre:
    return P_f / omega


@formula(
    "δ_need",
    "physics: interference at the reference temperature that leaves a pressure at another",
    unit="µm",
)
def interference_needed(
    p_need: Pascal,
    d_o: Metre,
    k_B: PerPascal,
    k_H: PerPascal,
    alpha_B: PerKelvin,
    T_B: Celsius,
    alpha_H: PerKelvin,
    chi: Number,
    T_H: Celsius,
    T_ref: Celsius,
) -> Metre:
    return p_need * d_o * (k_B + k_H) - d_o * (alpha_B * (T_B - T_ref) - alpha_H * (1 - chi) * (T_H - T_ref))


# --- the stack of parts


@formula("g", "geometry: bore less journal", unit="µm")
def clearance_direct(D_b: Metre, d_J: Metre) -> Metre:
    return D_b - d_J


@formula(
    "g",
    "geometry: housing bore less two walls less journal, and how much wider the seated bore stands",
    unit="µm",
)
def clearance_as_pressed(D_b: Metre, w: Metre, d_J: Metre, delta: Metre, c_i: Metre) -> Metre:
    return D_b - 2 * w - d_J + (delta - c_i)


@formula("g", "definition: the middle of what the parts leave", unit="µm")
def middle_clearance(g_min: Metre, g_max: Metre) -> Metre:
    return (g_min + g_max) / 2


# --- the split line


@formula("t/c", "definition: depth of the relief over the warm radial clearance")
def relief_depth(t: Metre, g: Metre) -> Number:
    return t / (g / 2)


@formula("a", "geometry: the arc of the relief on one side of the split, by the radius")
def relief_arc(a_r: Metre, d: Metre) -> Radian:
    return 2 * a_r / d


@formula("h_split", "computed here: the film at the edge, less what the split takes of the film", unit="µm")
def film_at_split(h_edge: Metre, h_0: Metre, s_t: Number) -> Metre:
    """>>> film_at_split(h_edge=4.7e-6, h_0=5.6e-6, s_t=0.78)
    3.468e-06
    """
    return h_edge - h_0 * (1 - s_t)
