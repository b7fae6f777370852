# SPDX-License-Identifier: Apache-2.0
"""The oil film against micropitting, ISO/TR 15144-1:2014 and ISO/TS 6336-22:2018, method B: its thickness over the
roughness.

The film is that of Dowson and Higginson with the oil at the temperature of the teeth, corrected for the heat of sliding
(S_GF).  Unmodified profiles, external wheels.  Tests behind it: modules 3 to 11 mm, 8 to 60 m/s; results agree with
others above 2 m/s (scope of ISO/TS 6336-22:2018)."""

from typing import Any

import numpy as np

from ....library import contact as teeth
from ....sheet.arrays import Array, Value
from ....sheet.formula import formula
from ....sheet.functions import cos, modulus, pi, power, sqrt
from ....sheet.record import record
from ....sheet.text import Text
from ....sheet.units import (
    Celsius,
    Kelvin,
    Metre,
    MetrePerSecond,
    NewtonPerMetre,
    Number,
    Pascal,
    PascalSecond,
    PerPascal,
    Radian,
)
from ....sheet.value import untraced
from .load import OilBath, ScreeningLoad, ThermalProduct, transmitted_power
from .path import Path, PathPoint

ISO = Text("ISO/TR 15144-1:2014")
ZERO: Celsius = 273.0  # as the standard rounds it
THIRTY_EIGHT: Celsius = 311.0
FALL: Celsius = 516.0
UNRELIEVED: Number = 1.0  # X_Ca of a profile without tip relief
HOTTEST: Celsius = 500.0  # pressure-viscosity law: it vanishes at 510 °C


# --- the film


@formula(
    "α_Θ",
    Text("{iso} (8): pressure-viscosity coefficient at a temperature", iso=ISO),
    names={"alpha_38": "α_38", "T": "Θ"},
)
def pressure_viscosity_at(alpha_38: PerPascal, T: Celsius) -> PerPascal:
    return alpha_38 * (1 + FALL * (1 / (T + ZERO) - 1 / THIRTY_EIGHT))


@formula("G_M", Text("{iso} (5): material parameter", iso=ISO))
def material_parameter(alpha_M: PerPascal, E_r: Pascal) -> Number:
    return alpha_M * E_r


@formula("U_Y", Text("{iso} (12): velocity parameter", iso=ISO), names={"eta_M": "η_M"})
def velocity_parameter(
    eta_M: PascalSecond, v_1: MetrePerSecond, v_2: MetrePerSecond, E_r: Pascal, rho_n: Metre
) -> Number:
    return eta_M * (v_1 + v_2) / (2 * E_r * rho_n)


@formula("p_dyn", Text("{iso} (24) to (26): Hertzian pressure with all load factors", iso=ISO), unit="MPa")
def hertz_pressure(E_r: Pascal, w_t: NewtonPerMetre, X: Number, rho_n: Metre, beta_b: Radian) -> Pascal:
    return sqrt(E_r * w_t * X / (2 * pi * rho_n * cos(beta_b)))


@formula("W_Y", Text("{iso} (22): load parameter", iso=ISO))
def load_parameter(p_dyn: Pascal, E_r: Pascal) -> Number:
    return 2 * pi * p_dyn**2 / E_r**2


@formula("Θ_fl", Text("{iso} (80): local flash temperature", iso=ISO), names={"b_1": "b_M1", "b_2": "b_M2"})
def local_flash_temperature(
    mu_m: Number,
    p_dyn: Pascal,
    v_1: MetrePerSecond,
    v_2: MetrePerSecond,
    b_1: ThermalProduct,
    b_2: ThermalProduct,
    rho_n: Metre,
    E_r: Pascal,
) -> Kelvin:
    return (
        sqrt(pi)
        / 2
        * mu_m
        * p_dyn
        * modulus(v_1 - v_2)
        / (sqrt(b_1 * v_1) + sqrt(b_2 * v_2))
        * sqrt(8 * rho_n * p_dyn / E_r)
    )


@formula("Θ_B", Text("{iso} (79): local contact temperature", iso=ISO), names={"T_M": "Θ_M", "T_fl": "Θ_fl"})
def contact_temperature(T_M: Celsius, T_fl: Kelvin) -> Celsius:
    return T_M + T_fl


@formula(
    "S_GF",
    Text("{iso} (27): sliding parameter", iso=ISO),
    names={"eta_B": "η_B", "eta_M": "η_M"},
    meanings={"eta_B": "Viscosity of the oil at the flank"},
)
def sliding_parameter(alpha_B: PerPascal, eta_B: PascalSecond, alpha_M: PerPascal, eta_M: PascalSecond) -> Number:
    return alpha_B * eta_B / (alpha_M * eta_M)


@formula("h_Y", Text("{iso} (4): film thickness (there 1600, from mm to µm)", iso=ISO), unit="µm")
def film_thickness(rho_n: Metre, G_M: Number, U_Y: Number, W_Y: Number, S_GF: Number) -> Metre:
    return 1.6 * rho_n * power(G_M, 0.6) * power(U_Y, 0.7) * power(W_Y, -0.13) * power(S_GF, 0.22)


@formula("λ_GF", Text("{iso} (2): specific film thickness", iso=ISO))
def specific_film(h_Y: Metre, Ra: Metre) -> Number:
    return h_Y / Ra


@record
class WarmOil:
    """The oil at the temperature of the teeth."""

    oil: OilBath
    mu_m: Number
    T_M: Celsius
    alpha_M: PerPascal
    eta_M: PascalSecond
    G_M: Number


def film(path: Path, load: ScreeningLoad, oil: OilBath, places: PathPoint[Array]) -> dict[str, Any]:
    """The specific film thickness at the points of method B, the least of which counts, and along the path, as fields
    of `Screening`.

    `places` are the points, then the samples of the path."""
    warm, marks = _warm_oil(path, load, oil), path.marks()
    values: dict[str, Any] = dict(friction_film=warm.mu_m, bulk_temperature_film=warm.T_M)
    with untraced():
        thickness, _ = _local(path, load, warm, places)
    if thickness is not None:
        place = list(marks)[np.argmin(thickness[: len(marks)])]
        h, p_dyn = _local(path, load, warm, path.at(marks[place]))
        assert h is not None
        values |= dict(specific_film_min=specific_film(h_Y=h, Ra=load.Ra), film_min=h, film_pressure=p_dyn)
        values |= dict(film_place=place, specific_film=thickness[len(marks) :] / load.Ra)
    return values


def _warm_oil(path: Path, load: ScreeningLoad, oil: OilBath) -> WarmOil:
    """Friction, bulk temperature, and the oil at that temperature."""
    X_R, v_SumC = teeth.roughness_factor(Ra=load.Ra, rho_nC=path.rho_nC), teeth.sum_of_speeds(v_C=path.v_C)
    mu_m = teeth.mean_friction(
        w_t=load.w_t, K_Bgamma=load.K_Bgamma, v_SumC=v_SumC, rho_nC=path.rho_nC, eta=oil.eta, X_R=X_R, X_L=oil.X_L
    )
    eps_alpha, z_1, z_2, beta_b = path.eps_alpha, path.driver.teeth, path.driven.teeth, path.beta_b
    if eps_alpha < 2:
        H_v = teeth.ohlendorf_loss_factor(
            eps_1=path.eps_1, eps_2=path.eps_2, eps_alpha=eps_alpha, z_1=z_1, z_2=z_2, beta_b=beta_b
        )
    else:
        H_v = teeth.ohlendorf_loss_factor_high(eps_alpha=eps_alpha, z_1=z_1, z_2=z_2, beta_b=beta_b)
    P = transmitted_power(F_t=load.F_t, d=path.driver.pitch_diameter, n=path.n_1)
    a, b = path.mesh.centre_distance, path.mesh.face_width
    rise = teeth.bulk_rise(P=P, mu_m=mu_m, H_v=H_v, a=a, b=b, X_S=oil.X_S, X_Ca=UNRELIEVED)
    T_M = teeth.bulk_temperature(T_oil=oil.T_oil, Delta_T=rise)
    alpha_M = pressure_viscosity_at(alpha_38=oil.alpha_38, T=T_M)
    return WarmOil(oil, mu_m, T_M, alpha_M, oil.lubricant.at(T_M).mu, material_parameter(alpha_M=alpha_M, E_r=load.E_r))


def _local(path: Path, load: ScreeningLoad, warm: WarmOil, at: PathPoint[Value]) -> tuple[Value | None, Value]:
    """The film at a point or at many, and its Hertzian pressure; no film where a contact is too hot for the law of the
    oil."""
    p_dyn = hertz_pressure(E_r=load.E_r, w_t=load.w_t, X=at.X, rho_n=at.rho_n, beta_b=path.beta_b)
    T_fl = local_flash_temperature(
        mu_m=warm.mu_m, p_dyn=p_dyn, v_1=at.v_1, v_2=at.v_2, b_1=load.b_1, b_2=load.b_2, rho_n=at.rho_n, E_r=load.E_r
    )
    T_B = contact_temperature(T_M=warm.T_M, T_fl=T_fl)
    if np.max(T_B) > HOTTEST:
        return None, p_dyn
    with untraced():
        eta_B = warm.oil.lubricant.at(T_B).mu
    alpha_B = pressure_viscosity_at(alpha_38=warm.oil.alpha_38, T=T_B)
    S_GF = sliding_parameter(alpha_B=alpha_B, eta_B=eta_B, alpha_M=warm.alpha_M, eta_M=warm.eta_M)
    U_Y = velocity_parameter(eta_M=warm.eta_M, v_1=at.v_1, v_2=at.v_2, E_r=load.E_r, rho_n=at.rho_n)
    W_Y = load_parameter(p_dyn=p_dyn, E_r=load.E_r)
    return film_thickness(rho_n=at.rho_n, G_M=warm.G_M, U_Y=U_Y, W_Y=W_Y, S_GF=S_GF), p_dyn
