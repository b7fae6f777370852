# SPDX-License-Identifier: Apache-2.0
"""Two cylinders in place of two flanks: curvature and speeds at every position of the path, and the modulus of both together.

Speeds are those of the transverse section along the flank, as ISO and AGMA use them; the curvature is that of the section
normal to the contact line.  At the pitch point both surfaces have one speed and nothing slides, to the last digit.
"""

from ...contact.hertz import reduced_modulus
from ...contact.line import driven_curvature, normal_relative_radius, relative_radius, rolling_speed
from ...sheet.formula import formula
from ...sheet.functions import pi
from ...sheet.record import record
from ...sheet.text import Text
from ...sheet.units import Metre, MetrePerSecond, Number, Pascal, RadPerSecond, RevPerSecond
from .geometry import MeshGeometry, column, require
from .path import AGMA, Path


@formula("n_2", "kinematics, ratio of the teeth", unit="rpm")
def wheel_speed(n: RevPerSecond, z_1: Number, z_2: Number) -> RevPerSecond:
    return n * z_1 / z_2


@formula("ω_1", "definition of angular speed")
def driver_speed(n_1: RevPerSecond) -> RadPerSecond:
    return 2 * pi * n_1


@formula("ω_2", "kinematics, ratio of the teeth")
def driven_speed(omega_1: RadPerSecond, z_1: Number, z_2: Number) -> RadPerSecond:
    return omega_1 * z_1 / z_2


@formula("V_s", "kinematics: |u_1 − u_2|, written by the distance from the pitch point, where it is 0", names={"x": "ρ_1"})
def sliding_speed(omega_1: RadPerSecond, omega_2: RadPerSecond, x: Metre, rho_C: Metre) -> MetrePerSecond:
    return (omega_1 + omega_2) * abs(x - rho_C)


@formula("u_e", Text("{agma}: entrainment speed, the mean of both surfaces", agma=AGMA))
def entrainment_speed(u_1: MetrePerSecond, u_2: MetrePerSecond) -> MetrePerSecond:
    return (u_1 + u_2) / 2


@formula("S", "definition of the slide-to-roll ratio")
def slide_to_roll(V_s: MetrePerSecond, u_e: MetrePerSecond) -> Number:
    return V_s / u_e


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
    """The kinematics of a mesh whose driver turns at n_1, one speed or many."""
    n = column(require(Text("mesh {title}: speed", title=mesh.title), n_1))
    omega_1 = driver_speed(n_1=n)
    n_2 = wheel_speed(n=n, z_1=mesh.driver.teeth, z_2=mesh.driven.teeth)
    omega_2 = driven_speed(omega_1=omega_1, z_1=mesh.driver.teeth, z_2=mesh.driven.teeth)
    rho_2 = driven_curvature(T=path.C_F, rho_1=path.x)
    u_1, u_2 = rolling_speed(n=n, rho=path.x), rolling_speed(n=n_2, rho=rho_2)
    V_s = sliding_speed(omega_1=omega_1, omega_2=omega_2, x=path.x, rho_C=path.C_C)
    u_e = entrainment_speed(u_1=u_1, u_2=u_2)
    return Motion(
        omega_1=omega_1, R=normal_relative_radius(rho_rel=relative_radius(rho_1=path.x, rho_2=rho_2), beta_b=mesh.base_helix_angle),
        u_1=u_1, u_2=u_2, V_s=V_s, u_e=u_e, S=slide_to_roll(V_s=V_s, u_e=u_e),
        E_r=reduced_modulus(nu_1=mesh.driver.poisson, E_1=mesh.driver.E, nu_2=mesh.driven.poisson, E_2=mesh.driven.E),
    )  # fmt: skip
