# SPDX-License-Identifier: Apache-2.0
"""Two cylinders in place of two flanks: curvature, speeds and Hertzian contact at every position of the path.

Speeds are those of the transverse section along the flank, u = ω·ρ, as ISO and AGMA use them; the curvature is that of the section
normal to the contact line.  At the pitch point both surfaces have one speed and nothing slides.
"""

from ..sheet.formula import formula
from ..sheet.functions import cos, pi, sqrt
from ..sheet.record import record
from ..sheet.units import Metre, MetrePerSecond, NewtonPerMetre, Number, Pascal, Radian, RadPerSecond, RevPerSecond
from .mesh import MeshGeometry, require
from .path import AGMA, Path

HERTZ = "Hertz 1881, line contact, as generally published"


@formula("n_2", "ratio of the teeth", unit="rpm")
def wheel_speed(n: RevPerSecond, z_1: Number, z_2: Number) -> RevPerSecond:
    return n * z_1 / z_2


@formula("ω_1", "definition of angular speed")
def driver_speed(n_1: RevPerSecond) -> RadPerSecond:
    return 2 * pi * n_1


@formula("ω_2", "ratio of the teeth")
def driven_speed(omega_1: RadPerSecond, z_1: Number, z_2: Number) -> RadPerSecond:
    return omega_1 * z_1 / z_2


@formula("ρ_2", f"{AGMA}: radius of curvature of the driven flank, transverse; that of the driver is x", unit="mm")
def driven_curvature(C_F: Metre, x: Metre) -> Metre:
    return C_F - x


@formula("R", f"{AGMA}: relative radius of curvature, normal to the contact line", unit="mm")
def relative_curvature(x: Metre, rho_2: Metre, C_F: Metre, beta_b: Radian) -> Metre:
    return x * rho_2 / (C_F * cos(beta_b))


@formula("u_1", f"{AGMA}: speed of the driver's surface along the flank")
def driver_surface_speed(omega_1: RadPerSecond, x: Metre) -> MetrePerSecond:
    return omega_1 * x


@formula("u_2", f"{AGMA}: speed of the driven surface along the flank")
def driven_surface_speed(omega_2: RadPerSecond, rho_2: Metre) -> MetrePerSecond:
    return omega_2 * rho_2


@formula("V_s", f"{AGMA}: sliding speed")
def sliding_speed(u_1: MetrePerSecond, u_2: MetrePerSecond) -> MetrePerSecond:
    return abs(u_1 - u_2)


@formula("u_e", f"{AGMA}: entrainment speed, the mean of both surfaces")
def entrainment_speed(u_1: MetrePerSecond, u_2: MetrePerSecond) -> MetrePerSecond:
    return (u_1 + u_2) / 2


@formula("S", "definition of the slide-to-roll ratio")
def slide_to_roll(V_s: MetrePerSecond, u_e: MetrePerSecond) -> Number:
    return V_s / u_e


@formula("E_r", f"{HERTZ}; modulus of the film formulas", unit="GPa")
def reduced_modulus(nu_1: Number, E_1: Pascal, nu_2: Number, E_2: Pascal) -> Pascal:
    return 2 / ((1 - nu_1**2) / E_1 + (1 - nu_2**2) / E_2)


@formula("b_H", f"{HERTZ}: half width", unit="µm")
def half_width(w: NewtonPerMetre, R: Metre, E_r: Pascal) -> Metre:
    return sqrt(8 * w * R / (pi * E_r))


@formula("p_H", f"{HERTZ}: largest pressure", unit="MPa")
def hertz_pressure(w: NewtonPerMetre, E_r: Pascal, R: Metre) -> Pascal:
    return sqrt(w * E_r / (2 * pi * R))


@formula("p_m", f"{HERTZ}: mean pressure", unit="MPa")
def mean_pressure(p_H: Pascal) -> Pascal:
    return pi * p_H / 4


@record
class Motion:
    """What the positions have whatever the load: angular speed of the driver, curvature and surface speeds, common modulus."""

    omega_1: RadPerSecond
    R: Metre
    u_1: MetrePerSecond
    u_2: MetrePerSecond
    V_s: MetrePerSecond
    u_e: MetrePerSecond
    S: Number
    E_r: Pascal


def motion(mesh: MeshGeometry, path: Path, n_1: RevPerSecond) -> Motion:
    """The kinematics of a mesh whose driver turns at n_1."""
    require(f"mesh {mesh.title}: speed", n_1)
    omega_1 = driver_speed(n_1=n_1)
    omega_2 = driven_speed(omega_1=omega_1, z_1=mesh.driver.teeth, z_2=mesh.driven.teeth)
    rho_2 = driven_curvature(C_F=path.C_F, x=path.x)
    u_1 = driver_surface_speed(omega_1=omega_1, x=path.x)
    u_2 = driven_surface_speed(omega_2=omega_2, rho_2=rho_2)
    V_s = sliding_speed(u_1=u_1, u_2=u_2)
    u_e = entrainment_speed(u_1=u_1, u_2=u_2)
    return Motion(
        omega_1=omega_1, R=relative_curvature(x=path.x, rho_2=rho_2, C_F=path.C_F, beta_b=mesh.base_helix_angle), u_1=u_1, u_2=u_2,
        V_s=V_s, u_e=u_e, S=slide_to_roll(V_s=V_s, u_e=u_e),
        E_r=reduced_modulus(nu_1=mesh.driver.poisson, E_1=mesh.driver.E, nu_2=mesh.driven.poisson, E_2=mesh.driven.E),
    )  # fmt: skip
