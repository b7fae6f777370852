# SPDX-License-Identifier: Apache-2.0
"""Two elastic cylinders pressed together along a line, in place of two flanks."""

from ..sheet.formula import formula
from ..sheet.functions import pi, sqrt
from ..sheet.units import Metre, NewtonPerMetre, Number, Pascal

HERTZ = "Hertz 1881, line contact, as generally published"


@formula("E_r", f"{HERTZ}; ISO/TR 15144-1:2014 (6), ISO/TR 13989-1:2000 (A.10): reduced modulus of elasticity", unit="GPa")
def reduced_modulus(nu_1: Number, E_1: Pascal, nu_2: Number, E_2: Pascal) -> Pascal:
    return 2 / ((1 - nu_1**2) / E_1 + (1 - nu_2**2) / E_2)


@formula("b_H", f"{HERTZ}: half the width of the contact", unit="µm")
def half_width(w: NewtonPerMetre, rho_n: Metre, E_r: Pascal) -> Metre:
    return sqrt(8 * w * rho_n / (pi * E_r))


@formula("p_H", f"{HERTZ}: largest pressure", unit="MPa")
def hertz_pressure(w: NewtonPerMetre, E_r: Pascal, rho_n: Metre) -> Pascal:
    return sqrt(w * E_r / (2 * pi * rho_n))


@formula("p_m", f"{HERTZ}: mean pressure", unit="MPa")
def mean_pressure(p_H: Pascal) -> Pascal:
    return pi * p_H / 4
