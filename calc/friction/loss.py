# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""The power that one mesh loses: friction along the path summed over all lines in contact, and rolling where it counts."""

import numpy as np

from ..sheet.errors import NoSolution
from ..sheet.formula import formula
from ..sheet.functions import cos, pi, total
from ..sheet.number import short
from ..sheet.quantity import result, value
from ..sheet.record import record
from ..sheet.units import Celsius, Kelvin, Metre, MetrePerSecond, NewtonPerMetre, Number, Pascal, Radian, RevPerSecond, Watt, WattPerMetre
from .contact import Motion, half_width, hertz_pressure, mean_pressure, motion
from .film import EXPONENT, Oil, film
from .inputs import FrictionInputs
from .mesh import MeshGeometry, require
from .path import Path, array, at_pitch_point, line_load, path, transverse_force
from .rolling import ehl_rolling_power, rigid_rolling_power
from .traction import combined_roughness, traction

THESIS = "gear friction thesis"
BULK: Kelvin = 7400.0
KILOWATT: Watt = 1e3
MILLIMETRE: Metre = 1e-3
MICROMETRE: Metre = 1e-6


@formula("P_s", f"{THESIS}: mean over a mesh cycle of the friction power of all lines in contact", names={"s": "Δs"})
def sliding_loss(s: Metre, mu: Number, w: NewtonPerMetre, V_s: MetrePerSecond) -> Watt:
    """s is the length of line for which a position stands; w is the load without its floor."""
    return total(s * mu * w * V_s)


@formula("P_R", "mean over a mesh cycle of the rolling power where the rigid isoviscous film governs", names={"s": "Δs", "r": "[IR]"})
def rolling_loss(s: Metre, q_R: WattPerMetre, r: Number) -> Watt:
    return total(s * q_R * r)


@formula("P_RE", "mean over a mesh cycle of the estimated rolling power of an EHL film; shown, not added", names={"s": "Δs"})
def rolling_estimate(s: Metre, q_E: WattPerMetre) -> Watt:
    return total(s * q_E)


@formula("P_VZ", "sum of sliding and rolling")
def mesh_loss(P_s: Watt, P_R: Watt) -> Watt:
    return P_s + P_R


@formula("H_VL", f"{THESIS}: loss factor, the load shared along the path", names={"s": "Δs"})
def loss_factor(s: Metre, w: NewtonPerMetre, V_s: MetrePerSecond, P: Watt) -> Number:
    return total(s * w * V_s) / P


@formula("μ_m", "definition of the mean coefficient of friction")
def mean_friction(P_s: Watt, P: Watt, H_VL: Number) -> Number:
    return P_s / (P * H_VL)


@formula("η_Z", f"definition of the efficiency ({THESIS}, eq. 1, prints the loss ratio under this name)")
def efficiency(P_VZ: Watt, P: Watt) -> Number:
    return 1 - P_VZ / P


# --- single numbers of a whole path ------------------------------------------------------------------------------------------
@formula("P_R", "without a rigid isoviscous film no rolling is counted", shows="no position has a rigid isoviscous film")
def no_rolling_loss() -> Watt:
    return float("0")


@formula("h_min", "definition: smallest along the path", unit="µm", shows="smallest h along the path")
def thinnest_film(h: Metre) -> Metre:
    return float(np.min(h))


@formula("λ_min", "definition: smallest along the path", shows="smallest λ along the path")
def least_film_ratio(lam: Number) -> Number:
    return float(np.min(lam))


@formula("p_H,max", "definition: largest along the path", unit="MPa", shows="largest p_H along the path")
def largest_pressure(p_H: Pascal) -> Pascal:
    return float(np.max(p_H))


@formula("T_f,max", "definition: largest along the path", shows="largest T_f along the path")
def hottest_film(T_f: Celsius) -> Celsius:
    return float(np.max(T_f))


@formula("De_max", "definition: largest along the path", shows="largest De along the path")
def largest_deborah(De: Number) -> Number:
    return float(np.max(De))


@formula("s_IR", "share of the length of line whose film is rigid and isoviscous", unit="%", names={"s": "Δs", "r": "[IR]"})
def rigid_share(s: Metre, r: Number) -> Number:
    return total(s * r) / total(s)


@formula("ΔT_b", "AGMA 925-A03, as generally published: teeth above oil; splash lubrication, no tip relief: X_S/(1.2·X_Ca) = 1")
def bulk_rise(P: Watt, mu_m: Number, H_VL: Number, a: Metre, b: Metre) -> Kelvin:
    return BULK * (P / KILOWATT * mu_m * H_VL / (a / MILLIMETRE * b / MILLIMETRE)) ** 0.72


@formula("H_V", "Ohlendorf 1958, as generally published: exact where two pairs share the load half and half")
def ohlendorf_loss_factor(u: Number, z_1: Number, beta_b: Radian, epsilon_alpha: Number, epsilon_1: Number, epsilon_2: Number) -> Number:
    return pi * (u + 1) / (z_1 * u * cos(beta_b)) * (1 - epsilon_alpha + epsilon_1**2 + epsilon_2**2)


@record
class Case:
    """A mesh at its speed with its oil: everything but the power that it carries."""

    mesh: MeshGeometry
    path: Path
    motion: Motion
    oil: Oil
    Ra: Metre  # mean of both flanks
    sigma: Metre
    mu_s: Number


def case(friction: FrictionInputs, mesh: MeshGeometry, oil: Oil, n_1: RevPerSecond, **fineness: int) -> Case:
    """What does not change with the power.  `fineness` of the path (points, strips) is for tests of convergence."""
    way = path(mesh, friction.load_sharing, **fineness)
    Ra_1, Ra_2 = friction.flank_roughness[0], friction.flank_roughness[-1]
    for Ra in (Ra_1, Ra_2):
        require("flank roughness", Ra)
    sigma = combined_roughness(Ra_1=Ra_1, Ra_2=Ra_2)
    if sigma == 0:
        smooth = f"{short(Ra_1 / MICROMETRE)} µm is so small that its square is 0"
        raise NoSolution("flank roughness", smooth, "give friction.flank_roughness_um of a real flank: 0.1 to 2 µm")
    mu_s = require("friction of the solids", friction.solid_friction, zero=True)
    return Case(mesh, way, motion(mesh, way, n_1), oil, (Ra_1 + Ra_2) / 2, sigma, mu_s)


@record
class Local:
    """What the curves show, along the strip in the middle of the face, by rising x."""

    x: Metre
    h: Metre
    lam: Number
    mu: Number
    q: WattPerMetre
    T_f: Celsius


@result
class MeshLoss:
    """The loss of one mesh by one model of the film."""

    loss: Watt = value("Power lost in the mesh", "W", "P_VZ")
    sliding_loss: Watt = value("by sliding", "W", "P_s")
    rolling_loss: Watt = value("by rolling", "W", "P_R")
    rolling_estimate: Watt | None = value("Rolling of an EHL film, an estimate that is not added", "W", "P_RE")
    efficiency: Number = value("Efficiency of the mesh", "", "η_Z")
    loss_factor: Number = value("Loss factor", "", "H_VL")
    friction_mean: Number = value("Mean coefficient of friction", "", "μ_m")
    film_min: Metre = value("Thinnest film", "µm", "h_min")
    lambda_min: Number = value("Smallest film over roughness", "", "λ_min")
    pressure_max: Pascal = value("Largest Hertzian pressure", "MPa", "p_H")
    temperature_max: Celsius = value("Hottest film", "°C", "T_f")
    deborah_max: Number = value("Largest Deborah number", "", "De")
    rigid_share: Number = value("Share of the path with a rigid isoviscous film", "%")
    load: Watt  # the power that was asked
    local: Local
    lead_at_pitch: Number  # film of the best other regime over the rigid isoviscous one; 0 where not asked
    thermal_reduction_min: Number


def solve_mesh(c: Case, P: Watt, by_regime: bool, exponent: Number = EXPONENT) -> MeshLoss:
    """The loss of a mesh that takes in the power P."""
    require(f"mesh {c.mesh.title}: power", P)
    s, m = c.path.weight, c.motion
    w, w_f = line_load(c.mesh, c.path, transverse_force(P=P, omega_1=m.omega_1, r_b1=c.mesh.driver.base_radius))
    b_H = half_width(w=w_f, R=m.R, E_r=m.E_r)
    p_H = hertz_pressure(w=w_f, E_r=m.E_r, R=m.R)
    f = film(by_regime, c.oil, m, w_f, p_H, exponent)
    t = traction(c.oil, m, f, w, w_f, mean_pressure(p_H=p_H), b_H, c.sigma, c.mu_s, c.path.x, f"mesh {c.mesh.title}")
    P_s = sliding_loss(s=s, mu=t.mu, w=w, V_s=m.V_s)
    estimate = None
    if not np.any(f.rigid):
        P_R = no_rolling_loss()
    else:
        P_R = rolling_loss(s=s, q_R=rigid_rolling_power(eta_0=c.oil.eta_0, u_e=m.u_e, R=m.R, h_0=f.h_0), r=f.rigid)
    if not by_regime:
        estimate = rolling_estimate(s=s, q_E=ehl_rolling_power(alpha=c.oil.alpha, G=f.G, U=f.U, W=f.W, R=m.R, Phi=f.Phi, u_e=m.u_e))
    P_VZ = mesh_loss(P_s=P_s, P_R=P_R)
    H_VL = loss_factor(s=s, w=w, V_s=m.V_s, P=P)
    return MeshLoss(
        loss=P_VZ, sliding_loss=P_s, rolling_loss=P_R, rolling_estimate=estimate, efficiency=efficiency(P_VZ=P_VZ, P=P), loss_factor=H_VL,
        friction_mean=mean_friction(P_s=P_s, P=P, H_VL=H_VL), film_min=thinnest_film(h=f.h), lambda_min=least_film_ratio(lam=t.lam),
        pressure_max=largest_pressure(p_H=p_H),
        temperature_max=hottest_film(T_f=t.T_f), deborah_max=largest_deborah(De=t.De),
        rigid_share=rigid_share(s=s, r=f.rigid),
        load=P, local=_local(c.path, f.h, t.lam, t.mu, t.q, t.T_f), lead_at_pitch=at_pitch_point(f.lead),
        thermal_reduction_min=float(np.min(f.Phi)),
    )  # fmt: skip


def _local(path: Path, *columns: float) -> Local:
    rows = np.asarray(path.x)
    middle = len(rows) // 2
    order = np.argsort(rows[middle], kind="stable")
    return Local(*(array(np.asarray(column)[middle][order]) for column in (path.x, *columns)))
