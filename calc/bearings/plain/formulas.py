# SPDX-License-Identifier: Apache-2.0
"""The journal in its seat: load, clearance, film, friction and heat.  g is the diametral clearance, ψ = g/d, n in 1/s.

Sommerfeld's number stands in both of its forms, S = μ·n/(P·ψ²) and So = P·ψ²/(μ·ω); So·S = 1/(2π) exactly.
"""

from ...sheet.formula import formula
from ...sheet.functions import largest, log10, modulus, pi, power, sin, smallest, sqrt
from ...sheet.units import (
    Celsius,
    CubicMetrePerSecond,
    JoulePerKilogramKelvin,
    Kelvin,
    KilogramPerMetre3,
    Metre,
    MetrePerSecond,
    Newton,
    Number,
    Pascal,
    PascalSecond,
    PerKelvin,
    Radian,
    RadPerSecond,
    RevPerSecond,
    Watt,
)
from ..formulas import angular_speed as angular_speed
from ..formulas import load_at_speed as load_at_speed
from ..formulas import load_peak as load_peak
from ..formulas import overspeed as overspeed
from ..formulas import speed_of_equal_loads as speed_of_equal_loads

ONE_METRE_PER_SECOND: MetrePerSecond = 1.0
ONE_PER_SECOND: RevPerSecond = 1.0
MILLI: Number = 1e-3
TRUMPLER_FILM: Metre = 5.08e-6
TRUMPLER_SLOPE: Number = 4e-5
TRANSITION: Metre = 1.7e-9
PSI: Pascal = 6894.757
CENTIPOISE_RPM_PER_PSI: Number = 1e-3 / 60 / PSI


@formula("u", "definition of the journal's surface speed", meanings={"n": "Speed"})
def surface_speed(d: Metre, n: RevPerSecond) -> MetrePerSecond:
    """>>> surface_speed(d=0.0595, n=43.33)
    8.099449...
    """
    return pi * d * n


@formula("l/d", "definition of the length ratio")
def length_ratio(l: Metre, d: Metre) -> Number:
    """>>> length_ratio(l=0.0275, d=0.0595)
    0.4621848...
    """
    return l / d


@formula("g", "Finotti 2013, 5.5.2: g = K·d·u^¼ with g in mm, d in m, u in m/s", unit="µm")
def clearance_by_factor(K: Number, d: Metre, u: MetrePerSecond) -> Metre:
    """>>> clearance_by_factor(K=0.8, d=0.0595, u=8.1)
    8.030234...e-05
    """
    return MILLI * K * d * power(u / ONE_METRE_PER_SECOND, 0.25)


@formula("g", "definition: the middle of the seat's tolerance less that of the journal's", unit="µm")
def clearance_of_fits(EI: Metre, ES: Metre, ei: Metre, es: Metre) -> Metre:
    return (EI + ES) / 2 - (ei + es) / 2


@formula(
    "g_min",
    "geometry, smallest seat on the largest journal; T: width of each tolerance",
    unit="µm",
    meanings={"T_S": "Width of the tolerance of the seat", "T_J": "Width of the tolerance of the journal"},
)
def least_clearance(g: Metre, T_S: Metre, T_J: Metre) -> Metre:
    return g - (T_S + T_J) / 2


@formula("g_min", "geometry: smallest seat on the largest journal, by the deviations of ISO 286", unit="µm")
def least_clearance_of_fits(EI: Metre, es: Metre) -> Metre:
    return EI - es


@formula("g_max", "geometry: largest seat on the smallest journal, by the deviations of ISO 286", unit="µm")
def most_clearance_of_fits(ES: Metre, ei: Metre) -> Metre:
    return ES - ei


@formula(
    "g_max",
    "geometry, largest seat on the smallest journal; T: width of each tolerance",
    unit="µm",
    meanings={"T_S": "Width of the tolerance of the seat", "T_J": "Width of the tolerance of the journal"},
)
def most_clearance(g: Metre, T_S: Metre, T_J: Metre) -> Metre:
    return g + (T_S + T_J) / 2


@formula("n_B", "definition: speed of the bush by its ratio to the journal's", unit="rpm")
def bush_speed(i_B: Number, n_J: RevPerSecond) -> RevPerSecond:
    return i_B * n_J


@formula("n_F", "definition: speed of the load vector by its ratio to the journal's", unit="rpm")
def load_speed(i_F: Number, n_J: RevPerSecond) -> RevPerSecond:
    return i_F * n_J


@formula(
    "g_T",
    "physics: clearance at a temperature, by the expansion of seat and journal; χ, share of the housing's expansion "
    "held back by the block",
    unit="µm",
    meanings={
        "alpha_H": "Thermal expansion of the seat",
        "alpha_J": "Thermal expansion of the journal",
        "T": "Temperature of journal and seat",
        "g": "Clearance at its reference temperature",
    },
)
def clearance_at(
    g: Metre, d: Metre, alpha_H: PerKelvin, chi: Number, alpha_J: PerKelvin, T: Celsius, T_ref: Celsius
) -> Metre:
    """The diametral clearance at a temperature from the one at its reference temperature; negative: the journal is
    seized.

    >>> clearance_at(g=8.03e-05, d=0.0595, alpha_H=2.15e-05, chi=0, alpha_J=1.15e-05, T=120.9, T_ref=20)
    0.0001403355
    """
    return g + d * (alpha_H * (1 - chi) - alpha_J) * (T - T_ref)


@formula("ψ", "definition of the relative clearance", unit="‰")
def relative_clearance(g: Metre, d: Metre) -> Number:
    """>>> relative_clearance(g=0.0001404, d=0.0595)
    0.002359663...
    """
    return g / d


@formula(
    "n_h",
    "ISO 7902-1: hydrodynamically effective speed of journal, bush and load vector",
    unit="rpm",
    meanings={"n_B": "Speed of the bush", "n_F": "Speed of the load vector"},
)
def effective_speed(n_J: RevPerSecond, n_B: RevPerSecond, n_F: RevPerSecond) -> RevPerSecond:
    """Zero where the load turns at half the journal's speed: no film is built up.  Load turning with the journal: as if
    it stood.

    >>> effective_speed(n_J=43.33, n_B=0, n_F=43.33)
    43.33
    """
    return modulus(n_J + n_B - 2 * n_F)


@formula(
    "S", "Raimondi & Boyd 1958: Sommerfeld number", meanings={"n_h": "Hydrodynamically effective speed of journal"}
)
def sommerfeld(mu: PascalSecond, n_h: RevPerSecond, p: Pascal, psi: Number) -> Number:
    """>>> sommerfeld(mu=0.007281, n_h=43.33, p=1043000, psi=0.002359)
    0.05435500...
    """
    return mu * n_h / (p * psi**2)


@formula("So", "ISO 7902-1 (DIN 31652-1): Sommerfeld number")
def sommerfeld_din(p: Pascal, psi: Number, mu: PascalSecond, omega: RadPerSecond) -> Number:
    """>>> sommerfeld_din(p=1043000, psi=0.002359, mu=0.007281, omega=272.3)
    2.927531...
    """
    return p * psi**2 / (mu * omega)


@formula(
    "ΔT",
    "energy, heat balance: all friction leaves with the oil",
    shows="ΔT at which the film's friction warms its oil by ΔT, bracketed",
    unit="K",
    meanings={"return": "Temperature rise of the oil"},
)
def closing_rise(Delta_T: Kelvin) -> Kelvin:
    """The rise itself, found from all that the film depends on."""
    return Delta_T


@formula("T_m", "Finotti 2013, 5.5.2: mean temperature of the film")
def mean_temperature(T_in: Celsius, Delta_T: Kelvin) -> Celsius:
    return T_in + Delta_T / 2


@formula("T_out", "definition: temperature of the oil that leaves")
def outlet_temperature(T_in: Celsius, Delta_T: Kelvin) -> Celsius:
    """>>> outlet_temperature(T_in=120, Delta_T=1.856)
    121.856
    """
    return T_in + Delta_T


@formula("h_0", "definition of the eccentricity ratio", unit="µm")
def film(g: Metre, eps: Number) -> Metre:
    """>>> film(g=0.0001404, eps=0.8638)
    9.561239...e-06
    """
    return g / 2 * (1 - eps)


@formula("e", "definition of the eccentricity ratio", unit="µm")
def displacement(eps: Number, g: Metre) -> Metre:
    return eps * g / 2


@formula("ε", "definition of the eccentricity ratio")
def eccentricity_of_film(h_0: Metre, g: Metre) -> Number:
    return 1 - 2 * h_0 / g


@formula("ε", "definition of the eccentricity ratio", names={"h_rel": "(h_0/c)"})
def eccentricity_of_relative_film(h_rel: Number) -> Number:
    return 1 - h_rel


@formula("f*", "Raimondi & Boyd 1958: friction variable f* = f/ψ")
def friction_variable_of(f: Number, psi: Number) -> Number:
    return f / psi


@formula("f*", "hydrodynamics: Couette shear of the full film and pressure term (identity of Reynolds' solution)")
def friction_variable(So: Number, eps: Number, phi: Radian) -> Number:
    return pi / (So * sqrt(1 - eps**2)) + eps / 2 * sin(phi)


@formula("n_s", "kinematics, speed of journal on bush: what is sheared", unit="rpm")
def sliding_speed(n_J: RevPerSecond, n_B: RevPerSecond) -> RevPerSecond:
    return modulus(n_J - n_B)


@formula("k_s", "kinematics: sliding speed of journal on bush over the hydrodynamic speed")
def sliding_ratio(n_J: RevPerSecond, n_B: RevPerSecond, n_h: RevPerSecond) -> Number:
    """One where the load stands or turns with either surface: then the shear is that of Reynolds' standing load."""
    return modulus(n_J - n_B) / n_h


@formula(
    "f*",
    "hydrodynamics: the same, the shear by the sliding speed and the pressure by the hydrodynamic one "
    "(balance of power in the load's frame)",
)
def friction_variable_sliding(So: Number, eps: Number, phi: Radian, k_s: Number) -> Number:
    return k_s**2 * pi / (So * sqrt(1 - eps**2)) + eps / 2 * sin(phi)


@formula("f*", "hydrodynamics: the same, sheared where there is land and not in the grooves", names={"land": "λ"})
def friction_variable_grooved(So: Number, eps: Number, phi: Radian, k_s: Number, land: Number) -> Number:
    return k_s**2 * land * pi / (So * sqrt(1 - eps**2)) + eps / 2 * sin(phi)


@formula("f", "Raimondi & Boyd 1958: friction variable f* = f/ψ", names={"f_v": "f*"})
def friction_coefficient(psi: Number, f_v: Number) -> Number:
    """>>> friction_coefficient(psi=0.002359, f_v=2.325)
    0.005484675...
    """
    return psi * f_v


@formula("P_f", "definition of power: of friction", meanings={"F": "Load"})
def friction_power(f: Number, F: Newton, u: MetrePerSecond) -> Watt:
    """>>> friction_power(f=0.005485, F=1707, u=8.1)
    75.83944...
    """
    return f * F * u


@formula("ΔT", "energy, heat balance: all friction leaves with the oil", unit="K")
def temperature_rise(P_f: Watt, rho: KilogramPerMetre3, c_p: JoulePerKilogramKelvin, Q: CubicMetrePerSecond) -> Kelvin:
    """>>> temperature_rise(P_f=75.84, rho=800.8, c_p=2358, Q=2.165e-05)
    1.855122...
    """
    return P_f / (rho * c_p * Q)


@formula(
    "p_max",
    "computed here: largest film pressure, from the table of Reynolds solutions",
    unit="MPa",
    names={"ratio": "(p/p_max)"},
)
def largest_pressure(p: Pascal, ratio: Number) -> Pascal:
    return p / ratio


@formula("γ̇", "definition: the largest mean shear rate, in the narrowest gap")
def shear_rate(u: MetrePerSecond, h_0: Metre) -> RevPerSecond:
    return u / h_0


@formula(
    "κ_full",
    "definition: viscosity at 150 °C and 10⁶ 1/s over that of the oil's own law, 1 at most",
    names={"hths": "μ_HTHS"},
    meanings={"hths": "Viscosity at high shear and 150 °C"},
)
def full_shear_factor(hths: PascalSecond, mu_150: PascalSecond) -> Number:
    """>>> full_shear_factor(hths=0.0035, mu_150=0.005)
    0.7
    """
    return smallest(1.0, hths / mu_150)


@formula(
    "κ",
    "rule of this program: an oil loses by shear from 10⁵ 1/s on, in proportion to lg γ̇, and all that it can at 10⁶",
    names={"kappa": "κ_full", "gamma": "γ̇"},
)
def shear_factor(kappa: Number, gamma: RevPerSecond) -> Number:
    """>>> shear_factor(kappa=0.7, gamma=1e5)
    1.0
    >>> shear_factor(kappa=0.7, gamma=2e6)
    0.7
    """
    return 1 + (kappa - 1) * smallest(largest(log10(gamma / ONE_PER_SECOND) - 5, 0.0), 1.0)


@formula("p_0", "dynamics, load at the start: the standing part alone", unit="MPa")
def load_at_start(R_0: Newton, d: Metre, l: Metre) -> Pascal:
    return R_0 / (d * l)


@formula(
    "p_O",
    "hydrodynamics: short bearing, for the pressure's shape around the seat",
    unit="MPa",
    names={"largest": "(p_O/(μ·ω/ψ²))"},
)
def short_bearing_pressure(mu: PascalSecond, omega: RadPerSecond, psi: Number, largest: Number) -> Pascal:
    return largest * mu * omega / psi**2


@formula(
    "k",
    "definition: factor of the viscosity at a corner of its tolerance; o is −1 where thinner, +1 where thicker",
    meanings={"o": "Corner of the tolerance, −1 thinner, 1 thicker"},
)
def viscosity_factor(t_nu: Number, o: Number) -> Number:
    return 1 + o * t_nu


@formula(
    "μ", "definition: viscosity at a corner of the oil's tolerance, or at high shear", unit="mPa·s", names={"mu": "μ_m"}
)
def viscosity_at_corner(mu: PascalSecond, k: Number) -> PascalSecond:
    return k * mu


@formula("h_orb", "geometry, smallest film over a turn: less the excursion towards the narrowest film", unit="µm")
def film_over_turn(h_0: Metre, a_n: Metre) -> Metre:
    return h_0 - a_n


# --- what is judged


@formula("h_edge", "geometry: film at the edge of a journal that stands at a slope in its seat", unit="µm")
def film_at_edge(h_0: Metre, theta: Radian, l: Metre) -> Metre:
    """>>> film_at_edge(h_0=9.559e-06, theta=0.0001563, l=0.0275)
    7.409875e-06
    """
    return h_0 - theta * l / 2


@formula("h_edge,x", "geometry: film at the edge of another speed or load, with the slope of the rated ones", unit="µm")
def film_at_edge_of_another(h_x: Metre, h_0: Metre, h_edge: Metre) -> Metre:
    """>>> film_at_edge_of_another(h_x=9.981e-06, h_0=9.559e-06, h_edge=7.41e-06)
    7.832e-06
    """
    return h_x - (h_0 - h_edge)


@formula(
    "h_K",
    "Kreisle, after Finotti 2013, 5.4.1 and 5.5.3: the film keeps the peaks Rt = k·Ra of both surfaces apart",
    unit="µm",
)
def kreisle_film(k_R: Number, Ra_1: Metre, Ra_2: Metre) -> Metre:
    """>>> kreisle_film(k_R=7.5, Ra_1=6e-07, Ra_2=6e-07)
    9e-06
    """
    return k_R * Ra_1 + k_R * Ra_2


@formula(
    "Ra_S'",
    "rule of this program: a lining that runs in gets as smooth as its journal, if it was not so before",
    unit="µm",
)
def roughness_run_in(Ra_1: Metre, Ra_2: Metre) -> Metre:
    """>>> roughness_run_in(Ra_1=2e-07, Ra_2=4e-07)
    2e-07
    """
    return smallest(Ra_1, Ra_2)


@formula("h_T", "Trumpler, after Finotti 2013, 5.5.1: 0.00508 mm + 4·10⁻⁵·d", unit="µm")
def trumpler_film(d: Metre) -> Metre:
    """>>> trumpler_film(d=0.0595)
    7.46e-06
    """
    return TRUMPLER_FILM + TRUMPLER_SLOPE * d


@formula(
    "n_T",
    "Finotti 2013, 5.5.3: transition to mixed friction, an empirical relation (1.7·10⁻⁹ m); Vogelpohl's",
    unit="rpm",
)
def transition_speed(p: Pascal, mu: PascalSecond, d: Metre) -> RevPerSecond:
    """>>> transition_speed(p=1043000, mu=0.007281, d=0.0595)
    4.092844...
    """
    return TRANSITION * p / (mu * d)


@formula(
    "n_min",
    "Finotti 2013, 5.5.3: n above 3·n_T below 3 m/s, above u·n_T from 3 to 10 m/s; held at 10 beyond, where no rule "
    "is given",
    unit="rpm",
    meanings={"k": "Least speed over that of the transition"},
)
def least_speed(k: Number, n_T: RevPerSecond) -> RevPerSecond:
    return k * n_T


@formula(
    "n_min", "rule of this program: the same rule without a limit above 10 m/s, where the source gives none", unit="rpm"
)
def least_speed_uncapped(u: MetrePerSecond, n_T: RevPerSecond) -> RevPerSecond:
    return largest(u / ONE_METRE_PER_SECOND, 3.0) * n_T


@formula(
    "Δh/h",
    "definition: distance of a route's film from that of Reynolds' equation, the oil as warm",
    unit="%",
    names={"reference": "h_R"},
)
def film_deviation(h_0: Metre, reference: Metre) -> Number:
    return modulus(h_0 / reference - 1)


@formula("ZN/P", "McKee & McKee 1932, after Finotti 2013, 5.4.1: in cP·rpm/psi", names={"n_h": "n"})
def mckee_number(mu: PascalSecond, n_h: RevPerSecond, p: Pascal) -> Number:
    return mu * n_h / p / CENTIPOISE_RPM_PER_PSI
