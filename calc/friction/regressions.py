# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""Three published regressions of tooth friction, shown beside the model of this program.  Nothing is judged by them.

Schlenk: one mean coefficient from the state at the pitch point; from tests of loaded gears, line loads above 150 N/mm.
Xu and Kahraman: local, from many runs of a mixed EHL solver; Hertzian pressures of some 0.5 to 2.5 GPa, roughness below about 1 µm.
Benedict and Kelley: local, from disc tests of 1961; kept within 0.01 and 0.2.
A train that only drives a counter-shaft carries far less than any of the three was fitted to.
"""

import math

from ..sheet.formula import formula
from ..sheet.functions import exp, largest, log10, smallest
from ..sheet.quantity import result, value
from ..sheet.units import Metre, MetrePerSecond, NewtonPerMetre, Number, Pascal, PascalSecond, Watt
from .contact import hertz_pressure
from .loss import Case, loss_factor, mean_friction, sliding_loss
from .path import at_pitch_point, line_load, transverse_force

MILLIPASCAL_SECOND: PascalSecond = 1e-3
MICROMETRE: Metre = 1e-6
MILLIMETRE: Metre = 1e-3
ONE_METRE: Metre = 1.0
METRE_PER_SECOND: MetrePerSecond = 1.0
NEWTON_PER_MILLIMETRE: NewtonPerMetre = 1e3
NEWTON_PER_METRE: NewtonPerMetre = 1.0
GIGAPASCAL: Pascal = 1e9
SLOWEST: MetrePerSecond = 1e-9  # keeps the logarithm finite at the pitch point
LOWEST_LINE_LOAD: NewtonPerMetre = 150e3
ROUGHEST: Metre = 2e-6

XU = "Xu and Kahraman 2005, as generally published"


@formula("μ_m", "Schlenk 1994, as generally published (X_L = 1, mineral oil); line load no less than 150 N/mm", names={"v_SumC": "v_ΣC"})
def schlenk(w_t: NewtonPerMetre, v_SumC: MetrePerSecond, rho_C: Metre, eta_0: PascalSecond, Ra: Metre) -> Number:
    return (
        0.048 * (largest(w_t, LOWEST_LINE_LOAD) / NEWTON_PER_MILLIMETRE / (v_SumC / METRE_PER_SECOND * rho_C / MILLIMETRE)) ** 0.2
        * (eta_0 / MILLIPASCAL_SECOND) ** -0.05 * (Ra / MICROMETRE) ** 0.25
    )  # fmt: skip


@formula("f", f"{XU}: exponent", names={"S": "SR", "sigma": "σ"})
def xu_kahraman_exponent(S: Number, p_H: Pascal, eta_0: PascalSecond, sigma: Metre) -> Number:
    return (
        -8.916465 - 0.354068 * S * p_H / GIGAPASCAL * log10(eta_0 / MILLIPASCAL_SECOND)
        + 2.812084 * exp(-S * p_H / GIGAPASCAL * log10(eta_0 / MILLIPASCAL_SECOND)) + 0.620305 * exp(sigma / MICROMETRE)
    )  # fmt: skip


@formula("μ_XK", XU, names={"S": "SR"})
def xu_kahraman(f: Number, p_H: Pascal, S: Number, u_e: MetrePerSecond, eta_0: PascalSecond, R: Metre) -> Number:
    return (
        exp(f) * (p_H / GIGAPASCAL) ** 1.03303 * S**1.036077 * (u_e / METRE_PER_SECOND) ** -0.100601
        * (eta_0 / MILLIPASCAL_SECOND) ** 0.752755 * (R / ONE_METRE) ** -0.390958
    )  # fmt: skip


@formula("μ_BK", "Benedict and Kelley 1961, as generally published; kept within 0.01 and 0.2", names={"V_T": "V_Σ"})
def benedict_kelley(w: NewtonPerMetre, eta_0: PascalSecond, V_s: MetrePerSecond, V_T: MetrePerSecond) -> Number:
    return smallest(
        largest(
            0.0127 * log10(
                29.66 * w / NEWTON_PER_METRE
                / (eta_0 / MILLIPASCAL_SECOND * largest(V_s, SLOWEST) / METRE_PER_SECOND * (V_T / METRE_PER_SECOND) ** 2)
            ),
            0.01,
        ),
        0.2,
    )  # fmt: skip


@formula("P_VZ", "definition of the mean coefficient of friction")
def loss_of_mean_friction(P: Watt, mu_m: Number, H_V: Number) -> Watt:
    return P * mu_m * H_V


@result
class Regression:
    loss: Watt = value("Power lost in the mesh", "W", "P_VZ")
    friction_mean: Number = value("Mean coefficient of friction", "", "μ_m")


def of_schlenk(c: Case, P: Watt, H_V: Number) -> Regression:
    """With the loss factor of Ohlendorf, for which it was made."""
    F_bt = transverse_force(P=P, omega_1=c.motion.omega_1, r_b1=c.mesh.driver.base_radius)
    u_C, R_C = at_pitch_point(c.motion.u_e), at_pitch_point(c.motion.R)
    mu_m = schlenk(w_t=F_bt / c.mesh.face_width, v_SumC=2 * u_C, rho_C=R_C, eta_0=c.oil.eta_0, Ra=c.Ra)
    return Regression(friction_mean=mu_m, loss=loss_of_mean_friction(P=P, mu_m=mu_m, H_V=H_V))


def of_xu_kahraman(c: Case, P: Watt) -> Regression | None:
    """None where it runs away: flanks so rough that its exponential does, or pressures far outside its runs."""
    if c.sigma > ROUGHEST:
        return None
    w, w_f = _load(c, P)
    p_H = hertz_pressure(w=w_f, E_r=c.motion.E_r, R=c.motion.R)
    f = xu_kahraman_exponent(S=c.motion.S, p_H=p_H, eta_0=c.oil.eta_0, sigma=c.sigma)
    found = _summed(c, P, w, xu_kahraman(f=f, p_H=p_H, S=c.motion.S, u_e=c.motion.u_e, eta_0=c.oil.eta_0, R=c.motion.R))
    return found if math.isfinite(found.loss) else None


def of_benedict_kelley(c: Case, P: Watt) -> Regression:
    w, w_f = _load(c, P)
    return _summed(c, P, w, benedict_kelley(w=w_f, eta_0=c.oil.eta_0, V_s=c.motion.V_s, V_T=2 * c.motion.u_e))


def _load(c: Case, P: Watt) -> tuple[NewtonPerMetre, NewtonPerMetre]:
    return line_load(c.mesh, c.path, transverse_force(P=P, omega_1=c.motion.omega_1, r_b1=c.mesh.driver.base_radius))


def _summed(c: Case, P: Watt, w: NewtonPerMetre, mu: Number) -> Regression:
    P_s = sliding_loss(s=c.path.weight, mu=mu, w=w, V_s=c.motion.V_s)
    H_VL = loss_factor(s=c.path.weight, w=w, V_s=c.motion.V_s, P=P)
    return Regression(friction_mean=mean_friction(P_s=P_s, P=P, H_VL=H_VL), loss=P_s)
