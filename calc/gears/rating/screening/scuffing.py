# SPDX-License-Identifier: Apache-2.0
"""Scuffing by the flash temperature (Blok), ISO/TR 13989-1:2000, and the whole screening of one mesh.

The hottest contact is held against the oil's limit; the standard is since then ISO/TS 6336-20.

The flash temperature is written with the load, the speeds and the radii of the point itself; with equal materials it is
the standard's μ_m·X_M·X_J·X_G·(X_Γ·w_Bt)^0.75·v_t^0.5/a^0.25 with X_M = E_r^0.25/B_M and the full angle factor of part
2.  K_Bγ multiplies the load as in DIN 3990-4 and in part 2, on the safe side."""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from ....library.catalogue import Material
from ....library.contact import half_width
from ....sheet.arrays import Array, Value
from ....sheet.errors import NoSolution
from ....sheet.formula import formula
from ....sheet.functions import cos, largest, modulus, power, sin, smallest, sqrt
from ....sheet.text import Amount, Text
from ....sheet.units import (
    Celsius,
    Kelvin,
    Kelvins,
    Metre,
    MetrePerSecond,
    Metres,
    Newton,
    NewtonPerMetre,
    Number,
    Pascal,
    PascalSecond,
    Radian,
)
from ....sheet.value import about, based_on, untraced
from ...result import MeshResult, ToothSystem, WheelResult
from .load import OilBath, Screening, ScreeningLoad, ThermalProduct, load_of
from .micropitting import film
from .path import Path, PathPoint

ISO = Text("ISO/TR 13989-1:2000")
NOTHING: Metre = 0.0
METRE_PER_SECOND: MetrePerSecond = 1.0
MICROMETRE: Metre = 1e-6
MILLIMETRE: Metre = 1e-3
NEWTON_PER_MILLIMETRE: NewtonPerMetre = 1e3
MILLIPASCAL_SECOND: PascalSecond = 1e-3
ONE_KELVIN: Kelvin = 1.0
EIGHTY: Celsius = 80.0
FASTEST: MetrePerSecond = 50.0  # of the pitch line, beyond which friction falls no further
DEFLECTION: Metre = 50e-6
NAMES = {"T_oil": "Θ_oil", "T_flm": "Θ_flm", "T_M": "Θ_M", "T_fl": "Θ_fl,max", "T_S": "Θ_S", "T_B": "Θ_B,max"}
LOAD_STAGE: Number = 10.0  # rule of this program: engine oils usually pass beyond it


@formula(
    "X_L",
    Text("{iso} (27): lubricant factor; X is 1 for mineral oil, 0.8 PAO, 0.7 PAG", iso=ISO),
    names={"X": "X_base", "eta": "η_oil"},
    meanings={"X": "Factor of the base oil"},
)
def lubricant_factor(X: Number, eta: PascalSecond) -> Number:
    return X * power(eta / MILLIPASCAL_SECOND, -0.05)


@formula("X_R", Text("{iso} (28): roughness factor", iso=ISO))
def roughness_factor(Ra: Metre) -> Number:
    return power(Ra / MICROMETRE, 0.25)


@formula(
    "v_gΣC", Text("{iso} (26): sum of the rolling speeds at the pitch point; pitch line no faster than 50 m/s", iso=ISO)
)
def sum_of_speeds(v_C: MetrePerSecond, alpha_wt: Radian) -> MetrePerSecond:
    return 2 * smallest(v_C, FASTEST * sin(alpha_wt))


@formula("μ_m", Text("{iso} (25): mean coefficient of friction", iso=ISO), names={"v": "v_gΣC", "rho_relC": "ρ_rel,C"})
def mean_friction(w_Bt: NewtonPerMetre, v: MetrePerSecond, rho_relC: Metre, X_L: Number, X_R: Number) -> Number:
    return 0.060 * power(w_Bt / NEWTON_PER_MILLIMETRE / (v / METRE_PER_SECOND * rho_relC / MILLIMETRE), 0.2) * X_L * X_R


@formula("C_eff", Text("{iso} (B.1): tip relief that the load calls for", iso=ISO), unit="µm", names={"c_gamma": "c_γ"})
def deflection(K_A: Number, F_t: Newton, b: Metre, alpha_t: Radian, c_gamma: Pascal) -> Metre:
    return K_A * F_t / (b * cos(alpha_t) * c_gamma)


@formula(
    "X_J",
    Text("{iso} (45) to (48): approach factor, no tip relief: the shock before the pitch point", iso=ISO),
    meanings={"rho_1": "Radius of curvature of the driver there", "g_alpha": "Length of the path of contact"},
)
def approach_factor(C_eff: Metre, rho_C: Metre, rho_1: Metre, g_alpha: Metre) -> Number:
    return 1 + C_eff / DEFLECTION * (largest(rho_C - rho_1, NOTHING) / g_alpha) ** 3


@formula(
    "w", "statics: load per length of the contact line of one pair", unit="N/mm", names={"X": "X_Γ", "K_Bgamma": "K_Bγ"}
)
def local_load(X: Number, K_Bgamma: Number, w_t: NewtonPerMetre) -> NewtonPerMetre:
    return X * K_Bgamma * w_t


@formula(
    "Θ_fl",
    "Blok 1937; ISO/TR 13989-1:2000 (5) and (A.5) in the speeds of both flanks",
    names={"b_1": "b_M1", "b_2": "b_M2"},
)
def flash_temperature(
    mu_m: Number,
    X_J: Number,
    w: NewtonPerMetre,
    v_1: MetrePerSecond,
    v_2: MetrePerSecond,
    b_1: ThermalProduct,
    b_2: ThermalProduct,
    b_H: Metre,
) -> Kelvin:
    return 1.11 * mu_m * X_J * w * modulus(v_1 - v_2) / ((sqrt(b_1 * v_1) + sqrt(b_2 * v_2)) * sqrt(2 * b_H))


@formula(
    "Θ_flm",
    Text("{iso} (24): mean flash temperature", iso=ISO),
    shows="mean of Θ_fl along the path of contact, from A to E",
)
def mean_flash_temperature(T_fl: Kelvins, rho_1: Metres) -> Kelvin:
    flash, place = np.asarray(T_fl), np.asarray(rho_1)
    area = np.sum((flash[1:] + flash[:-1]) * np.diff(place)) / 2
    return float(area / (place[-1] - place[0]))


@formula(
    "X_mp",
    Text("{iso} (23): a wheel with more than one mate is heated by each", iso=ISO),
    names={"n_p": "n_p"},
    meanings={"n_p": "Mates of the wheel"},
)
def multiple_path_factor(n_p: Number) -> Number:
    return (1 + n_p) / 2


@formula(
    "Θ_M", Text("{iso} (22): bulk temperature", iso=ISO), names=NAMES, meanings={"X_S": "Factor of the lubrication"}
)
def bulk_temperature(T_oil: Celsius, X_S: Number, X_mp: Number, T_flm: Kelvin) -> Celsius:
    return T_oil + 0.47 * X_S * X_mp * T_flm


@formula("Θ_B,max", Text("{iso} (2): highest contact temperature", iso=ISO), names=NAMES)
def contact_temperature(T_M: Celsius, T_fl: Kelvin) -> Celsius:
    return T_M + T_fl


@formula(
    "Θ_S",
    Text("{iso} (99): scuffing temperature from the load stage of the FZG test A/8.3/90", iso=ISO),
    names={"S": "S_FZG"},
    meanings={"S": "Load stage of the FZG test"},
)
def scuffing_temperature(X_W: Number, X_L: Number, S: Number) -> Celsius:
    return EIGHTY + (0.85 + 1.4 * X_W) * X_L * S**2 * ONE_KELVIN


@formula("S_B", Text("{iso} (100): safety against scuffing", iso=ISO), names=NAMES)
def safety(T_S: Celsius, T_oil: Celsius, T_B: Celsius) -> Number:
    return (T_S - T_oil) / (T_B - T_oil)


@formula("ΔΘ_S", Text("{iso}, 10.5: the margin as a difference", iso=ISO), names=NAMES)
def margin(T_S: Celsius, T_B: Celsius) -> Kelvin:
    return T_S - T_B


def flash(
    path: Path,
    load: ScreeningLoad,
    oil: OilBath,
    alpha_t: Radian,
    places: PathPoint[Array],
    n_p: Number,
    S_FZG: Number,
    X_W: Number,
    c_gamma: Pascal,
) -> dict[str, Any]:
    """The flash temperature along the path, and once more where it is highest, as fields of `Screening`; `places` are
    the points, then the samples of the path."""
    X_L = lubricant_factor(X=oil.X_L, eta=oil.eta)
    X_R = roughness_factor(Ra=load.Ra)
    v = sum_of_speeds(v_C=path.v_C, alpha_wt=path.mesh.working_pressure_angle)
    mu_m = mean_friction(w_Bt=load.w_Bt, v=v, rho_relC=path.rho_relC, X_L=X_L, X_R=X_R)
    C_eff = deflection(K_A=load.K_A, F_t=load.F_t, b=path.mesh.face_width, alpha_t=alpha_t, c_gamma=c_gamma)
    with untraced():
        temperatures = _local(path, load, mu_m, C_eff, places)
    points = len(path.marks())
    along = based_on(temperatures[points:], mu_m, C_eff, load, path.depends_on)
    rho_1 = places.rho_1[points:]
    hottest = based_on(rho_1[np.argmax(along)].item(), path.A, path.B, path.D, path.E)
    T_fl = _local(path, load, mu_m, C_eff, path.at(hottest))
    T_flm = mean_flash_temperature(T_fl=along, rho_1=based_on(rho_1, path.A, path.E))
    T_M = bulk_temperature(T_oil=oil.T_oil, X_S=oil.X_S, X_mp=multiple_path_factor(n_p=n_p), T_flm=T_flm)
    T_B = contact_temperature(T_M=T_M, T_fl=T_fl)
    T_S = scuffing_temperature(X_W=X_W, X_L=X_L, S=S_FZG)
    return dict(
        flash_temperature_max=T_fl,
        friction_flash=mu_m,
        bulk_temperature_flash=T_M,
        contact_temperature_max=T_B,
        scuffing_temperature=T_S,
        scuffing_safety=safety(T_S=T_S, T_oil=oil.T_oil, T_B=T_B),
        scuffing_margin=margin(T_S=T_S, T_B=T_B),
        flash=along,
    )


def _local(path: Path, load: ScreeningLoad, mu_m: Number, C_eff: Metre, at: PathPoint[Value]) -> Value:
    X_J = approach_factor(C_eff=C_eff, rho_C=path.C, rho_1=at.rho_1, g_alpha=based_on(path.E - path.A, path.E, path.A))
    w = local_load(X=at.X, K_Bgamma=load.K_Bgamma, w_t=load.w_t)
    b_H = half_width(w=w, rho_n=at.rho_n, E_r=load.E_r)
    return flash_temperature(mu_m=mu_m, X_J=X_J, w=w, v_1=at.v_1, v_2=at.v_2, b_1=load.b_1, b_2=load.b_2, b_H=b_H)


# --- the screening of one mesh: its film and its flash temperature at the load that its load factors make

# rule of this program: Annex A of ISO/TR 15144-1, read from its figure by public code, has 0.06 to 0.6 by oil
PERMISSIBLE_FILM = 0.3


def screening(
    system: ToothSystem,
    mesh: MeshResult,
    driver: WheelResult,
    driven: WheelResult,
    *,
    F_t: Newton,
    oil: OilBath,
    materials: Mapping[str, Material],
    roughness: tuple[Metre, Metre],
    load_factor: Number,
    application_factor: Number,
    accuracy_grade: Number,
    mates: Number,
    load_stage: Number | None,
    structural_factor: Number,
    mesh_stiffness: Pascal,
    permissible_film: Number | None,
) -> Screening:
    """Film and flash temperature of a mesh.

    F_t is the nominal tangential force at the reference circle; `load_factor` is K_A·K_V·K_Hβ·K_Hα,
    `application_factor` K_A alone; `oil` from `oil_bath`, once for all meshes; `roughness` Ra of driver and driven;
    `mates` the most that one of both wheels has (2 for an idler); `structural_factor` X_W of the steel; `load_stage`
    that of the FZG test A/8.3/90 at which the oil scuffs and `permissible_film` λ_GFP from a test of the oil, where
    None those of the rules of this program.
    """
    title, alpha_t = mesh.title, system.transverse_pressure_angle
    for what, number in (
        (Text("the tangential force"), F_t),
        (Text("the speed"), abs(driver.speed)),
        (Text("the flank roughness"), min(roughness)),
    ):
        if not number > 0:
            raise NoSolution(
                Text("screening of mesh {title}: {what} is {number}", title=title, what=what, number=Amount(number)),
                advice=Text("film and flash temperature need load, speed and roughness"),
            )
    stage = LOAD_STAGE if load_stage is None else load_stage
    with about(Text("screening of mesh {title}", title=title)):
        path = Path(system, mesh, driver, driven, accuracy_grade)
        one, two, b = materials[driver.material], materials[driven.material], mesh.face_width
        eps_gamma, K_A = mesh.total_contact_ratio, application_factor
        load = load_of(F_t, load_factor, K_A, b, alpha_t, eps_gamma, one, two, roughness)
        with untraced():
            samples = path.samples()
            places = path.at(np.concatenate([list(path.marks().values()), samples]))
    with about(Text("film of mesh {title}", title=title)):
        thin = film(path, load, oil, places)
    with about(Text("flash temperature of mesh {title}", title=title)):
        hot = flash(path, load, oil, alpha_t, places, mates, stage, structural_factor, mesh_stiffness)
    return Screening(
        **thin,
        **hot,
        title=title,
        permissible_film=PERMISSIBLE_FILM if permissible_film is None else permissible_film,
        permissible_given=permissible_film is not None,
        load_stage=stage,
        load_stage_given=load_stage is not None,
        line_load=load.w_Bt,
        pitch_line_speed=math.pi * abs(driver.speed) * mesh.working_diameter_driver,
        oil_temperature=oil.T_oil,
        method_applies=path.shared_by_two,
        way=samples - path.C,
    )
