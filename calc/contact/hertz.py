# SPDX-License-Identifier: Apache-2.0
"""Two elastic cylinders pressed together along a line, in place of two flanks."""

from ..sheet.formula import formula
from ..sheet.functions import pi, sqrt
from ..sheet.text import Text
from ..sheet.units import Metre, NewtonPerMetre, Number, Pascal

HERTZ = Text("Hertz 1881, line contact")


@formula(
    "E_r", Text("{hertz}; ISO/TR 15144-1:2014 (6), ISO/TR 13989-1:2000 (A.10): reduced modulus of elasticity", hertz=HERTZ), unit="GPa"
)
def reduced_modulus(nu_1: Number, E_1: Pascal, nu_2: Number, E_2: Pascal) -> Pascal:
    """>>> reduced_modulus(nu_1=0.3, E_1=206000000000.0, nu_2=0.3, E_2=206000000000.0)
    2263736...
    """
    return 2 / ((1 - nu_1**2) / E_1 + (1 - nu_2**2) / E_2)


@formula("b_H", Text("{hertz}: half the width of the contact", hertz=HERTZ), unit="µm")
def half_width(w: NewtonPerMetre, rho_n: Metre, E_r: Pascal) -> Metre:
    """>>> half_width(w=69790, rho_n=0.004316, E_r=226400000000.0)
    5.820618...e-05
    """
    return sqrt(8 * w * rho_n / (pi * E_r))


@formula("p_H", Text("{hertz}: largest pressure", hertz=HERTZ), unit="MPa")
def hertz_pressure(w: NewtonPerMetre, E_r: Pascal, rho_n: Metre) -> Pascal:
    return sqrt(w * E_r / (2 * pi * rho_n))


@formula("p_m", Text("{hertz}: mean pressure", hertz=HERTZ), unit="MPa")
def mean_pressure(p_H: Pascal) -> Pascal:
    return pi * p_H / 4
