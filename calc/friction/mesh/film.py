# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""The oil film between the flanks: which of four regimes makes it, and what the heat of the inlet takes from it.

    IR  isoviscous, rigid: light load; neither dents the steel nor thickens the oil      H = 4.896·U/W
    VR  piezoviscous, rigid: the pressure thickens the oil                               H = 1.66·g_V^(2/3)·U/W
    IE  isoviscous, elastic: soft bodies                                                 H = 3.10·g_E^0.8·U/W
    VE  piezoviscous, elastic: EHL, the usual regime of loaded gears                     Dowson-Toyoda

The thickest governs.  The friction source takes VE everywhere; at light load that is too thin by up to a factor of ten.

All are for fully flooded, smooth line contact, with the oil at the temperature of the teeth.
"""

from typing import Any

import numpy as np

from ...library.lubricant import Lubricant
from ...sheet.arrays import Array
from ...sheet.formula import formula
from ...sheet.functions import largest, sqrt
from ...sheet.record import record
from ...sheet.text import Text
from ...sheet.units import (
    Celsius,
    Metre,
    MetrePerSecond,
    NewtonPerMetre,
    Number,
    Pascal,
    PascalSecond,
    PerKelvin,
    PerPascal,
    WattPerMetreKelvin,
)
from ...sheet.value import based_on
from .path import Cells, Motion

EXPONENT: Number = 0.56  # of the materials' parameter, line contact
LEAST_FACTOR: Number = 0.05  # of the thermal reduction: below, its formula has left its range

JOHNSON = Text("Johnson 1970, regimes of fluid-film lubrication of line contacts")
TOYODA = Text("Dowson and Toyoda 1978, central film of line contacts")
GUPTA = Text("Gupta et al. 1992")


@formula("U", Text("{toyoda}: speed parameter", toyoda=TOYODA))
def speed_parameter(eta_0: PascalSecond, u_e: MetrePerSecond, E_r: Pascal, R: Metre) -> Number:
    return eta_0 * u_e / (E_r * R)


@formula("G", Text("{toyoda}: materials parameter", toyoda=TOYODA))
def materials_parameter(alpha: PerPascal, E_r: Pascal) -> Number:
    return alpha * E_r


@formula("W", Text("{toyoda}: load parameter", toyoda=TOYODA))
def load_parameter(w: NewtonPerMetre, E_r: Pascal, R: Metre) -> Number:
    return w / (E_r * R)


@formula("g_V", Text("{johnson}: viscosity parameter", johnson=JOHNSON))
def viscosity_group(W: Number, G: Number, U: Number) -> Number:
    return W**1.5 * G / sqrt(U)


@formula("g_E", Text("{johnson}: elasticity parameter", johnson=JOHNSON))
def elasticity_group(W: Number, U: Number) -> Number:
    return W / sqrt(U)


@formula("H_IR", Text("{johnson}: rigid bodies, constant viscosity (Martin 1916)", johnson=JOHNSON), governs="min")
def film_rigid_isoviscous(U: Number, W: Number) -> Number:
    return 4.896 * U / W


@formula("H_VR", Text("{johnson}: rigid bodies, viscosity rising with pressure (Blok)", johnson=JOHNSON), governs="min")
def film_rigid_piezoviscous(g_V: Number, U: Number, W: Number) -> Number:
    return 1.66 * g_V ** (2 / 3) * U / W


@formula("H_IE", Text("{johnson}: elastic bodies, constant viscosity (Herrebrugh)", johnson=JOHNSON), governs="min")
def film_elastic_isoviscous(g_E: Number, U: Number, W: Number) -> Number:
    return 3.10 * g_E**0.8 * U / W


@formula(
    "H_VE",
    Text("{toyoda} (the friction source credits Hamrock and Dowson)", toyoda=TOYODA),
    governs="min",
    names={"e": "n_G"},
    meanings={"e": "Exponent of the parameter of materials"},
)
def film_elastic_piezoviscous(G: Number, e: Number, U: Number, W: Number) -> Number:
    return 3.06 * G**e * U**0.69 * W**-0.10


@formula(
    "L_th",
    Text("{gupta}: thermal loading parameter, with the mean speed squared", gupta=GUPTA),
    names={"beta": "β_T"},
    meanings={"k_f": "Thermal conductivity of the oil"},
)
def thermal_loading(eta_0: PascalSecond, beta: PerKelvin, u_e: MetrePerSecond, k_f: WattPerMetreKelvin) -> Number:
    return eta_0 * beta * u_e**2 / k_f


@formula(
    "Φ_T", Text("{gupta}: reduction by the heat of the sheared inlet", gupta=GUPTA), governs="min", names={"L": "L_th"}
)
def thermal_reduction(p_H: Pascal, E_r: Pascal, L: Number, S: Number) -> Number:
    return (1 - 13.2 * p_H / E_r * L**0.42) / (1 + 0.213 * (1 + 2.23 * S**0.83) * L**0.64)


@formula("Φ", "rule of this program: the thermal reduction, no less than 0.05", governs="min")
def bounded_reduction(Phi_T: Number) -> Number:
    return largest(Phi_T, LEAST_FACTOR)


@formula("H", "Johnson 1970: the thickest of the four regimes governs", governs="min")
def governing_film(H_IR: Number, H_VR: Number, H_IE: Number, H_VE: Number) -> Number:
    return largest(largest(H_IR, H_VR), largest(H_IE, H_VE))


@formula(
    "h", "rule of this program: film of the governing regime, times the thermal reduction", unit="µm", governs="min"
)
def film_thickness(Phi: Number, H: Number, R: Metre) -> Metre:
    return Phi * H * R


@formula("h_0", "Martin 1916: rigid isoviscous film, without thermal reduction", unit="µm", governs="min")
def rigid_film(H_IR: Number, R: Metre) -> Metre:
    return H_IR * R


@record
class Oil:
    """What of the oil does not change while a mesh is solved: its state at the temperature of the teeth, and what of it
    is assumed.

    `thickening` is a factor on the pressure-viscosity coefficient, `Lambda` the limiting shear over the pressure.  Many
    operating points have T_m and all that follows from it as columns."""

    lubricant: Lubricant
    T_m: Any
    eta_0: Any
    alpha: Any
    beta: Any
    k_f: Any
    Lambda: Number
    thickening: Number | None

    def alpha_at(self, eta: Any) -> Any:
        alpha = self.lubricant.alpha(eta)
        return alpha if self.thickening is None else alpha * self.thickening

    def at(self, T_m: Celsius) -> "Oil":
        """The same oil at another temperature."""
        return oil_at(self.lubricant, T_m, self.Lambda, self.thickening)


def oil_at(lubricant: Lubricant, T_m: Celsius, Lambda: Number | None = None, thickening: Number | None = None) -> Oil:
    """`Lambda`: left out, that of the oil."""
    eta_0 = lubricant.at(T_m).mu
    alpha = lubricant.alpha(eta_0)
    return Oil(
        lubricant=lubricant,
        T_m=T_m,
        eta_0=eta_0,
        alpha=alpha if thickening is None else based_on(alpha * thickening, alpha, thickening),
        beta=lubricant.beta(T_m),
        k_f=lubricant.oil.conductivity,
        Lambda=lubricant.limiting_shear if Lambda is None else Lambda,
        thickening=thickening,
    )


@record
class MeshFilm:
    """The film at every position.  `lead` is the best of the other films over the rigid isoviscous one, `rigid` the
    share of the stretch for which the position stands in which that one governs."""

    h: Array
    h_0: Array  # where IR governs, its film before the thermal reduction
    Phi: Array
    G: Array
    U: Array
    W: Array
    rigid: Array
    lead: Array


def film(by_regime: bool, oil: Oil, motion: Motion, w: Array, p_H: Array, cells: Cells) -> MeshFilm:
    """The film by regime, or with the EHL formula everywhere."""
    U = speed_parameter(eta_0=oil.eta_0, u_e=motion.u_e, E_r=motion.E_r, R=motion.R)
    G = materials_parameter(alpha=oil.alpha, E_r=motion.E_r)
    W = load_parameter(w=w, E_r=motion.E_r, R=motion.R)
    H = H_VE = film_elastic_piezoviscous(G=G, e=EXPONENT, U=U, W=W)
    rigid: Array = np.zeros_like(w)
    lead = h_0 = rigid
    if by_regime:
        H_IR = film_rigid_isoviscous(U=U, W=W)
        H_VR = film_rigid_piezoviscous(g_V=viscosity_group(W=W, G=G, U=U), U=U, W=W)
        H_IE = film_elastic_isoviscous(g_E=elasticity_group(W=W, U=U), U=U, W=W)
        H = governing_film(H_IR=H_IR, H_VR=H_VR, H_IE=H_IE, H_VE=H_VE)
        h_0 = rigid_film(H_IR=H_IR, R=motion.R)
        regimes = H_IR, H_VR, H_IE, H_VE
        lead = np.maximum(np.maximum(H_VR, H_IE), H_VE) / H_IR
        rigid = based_on(cells.below_zero(np.log(lead)), *regimes)
        lead = based_on(lead, *regimes)
    L = thermal_loading(eta_0=oil.eta_0, beta=oil.beta, u_e=motion.u_e, k_f=oil.k_f)
    Phi_T = thermal_reduction(p_H=p_H, E_r=motion.E_r, L=L, S=motion.S)
    Phi = bounded_reduction(Phi_T=Phi_T)
    return MeshFilm(h=film_thickness(Phi=Phi, H=H, R=motion.R), h_0=h_0, Phi=Phi, G=G, U=U, W=W, rigid=rigid, lead=lead)
