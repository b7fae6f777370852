# SPDX-License-Identifier: Apache-2.0
"""Backlash over temperature: housing and support carry the centres apart, each wheel grows by itself.

A wheel that grows evenly keeps its angles; its base circle, thickness and pitch grow alike.  Referred to the wheels the centre
distance changes by Δa_eff.  Wheels of different growth have base pitches that differ by some nanometres: the backlash is that of a tooth in
a space, exact, with the smaller pitch of the two.
"""

from collections.abc import Mapping
from typing import Any

from ...catalogue import Material
from ...sheet.formula import formula
from ...sheet.functions import cos, inv, smallest
from ...sheet.record import record
from ...sheet.trace import about
from ...sheet.units import Celsius, Kelvin, Metre, Number, PerKelvin, Radian
from .. import formulas as f
from ..inputs import GearsInputs
from .backlash import settled
from .meeting import Meeting

REFERENCE: Celsius = 20.0  # of all measures, ISO 1


@formula("T_W", "wheels warmer than the housing")
def wheel_temperature(T_H: Celsius, Delta_T: Kelvin) -> Celsius:
    return T_H + Delta_T


@formula("α_a", "expansion of the centre distance; λ_S: share of it that the support spans", unit="10⁻⁶/K")
def expansion_between_centres(alpha_H: PerKelvin, alpha_S: PerKelvin, lambda_S: Number) -> PerKelvin:
    return alpha_H * (1 - lambda_S) + alpha_S * lambda_S


@formula("ε_T", "linear expansion from 20 °C (ISO 1)")
def expansion(alpha: PerKelvin, T: Celsius) -> Number:
    return alpha * (T - REFERENCE)


@formula("ε_g", "expansion of both base circles together, which fixes the working pressure angle")
def expansion_of_wheels(eps_1: Number, eps_2: Number, d_b1: Metre, d_b2: Metre) -> Number:
    return (eps_1 * d_b1 + eps_2 * d_b2) / (d_b1 + d_b2)


@formula("Δa_eff", "change of the centre distance against the wheels", unit="µm")
def change_against_wheels(a_w: Metre, eps_a: Number, eps_g: Number) -> Metre:
    return a_w * (eps_a - eps_g) / (1 + eps_g)


@formula("a_eff", "centre distance referred to the wheels as they are at 20 °C", unit="mm")
def effective_centre(a: Metre, eps_a: Number, eps_g: Number) -> Metre:
    return a * (1 + eps_a) / (1 + eps_g)


@formula("j_bn,T", "normal backlash of wheels that have grown by ε; of a tooth in a space with the smaller base pitch", unit="µm")
def warm_backlash(
    p_bt: Metre, eps_1: Number, eps_2: Number, s_b1: Metre, s_b2: Metre, d_b1: Metre, d_b2: Metre, alpha_wt: Radian, beta_b: Radian
) -> Metre:
    return (
        (1 + smallest(eps_1, eps_2)) * p_bt
        - (1 + eps_1) * s_b1
        - (1 + eps_2) * s_b2
        + ((1 + eps_1) * d_b1 + (1 + eps_2) * d_b2) * inv(alpha_wt)
    ) * cos(beta_b)


@record
class State:
    name: str
    housing: Celsius
    wheels: Celsius


@record
class Expansions:
    """Of the centre distance of one mesh, and of its two wheels."""

    centres: PerKelvin
    driver: PerKelvin
    driven: PerKelvin


@record
class Grown:
    """Expansion of the centre distance, of each wheel, and of both base circles together."""

    centres: Number
    driver: Number
    driven: Number
    wheels: Number


@record
class AtState:
    """One mesh at one temperature and one pair of tooth thicknesses."""

    backlash: Metre
    pressure_angle: Radian
    centre_growth: Number
    wheel_growth: Number  # the smaller one


def states(gears: GearsInputs) -> tuple[State, State, State]:
    """Cold start; all warm; the wheels warmer than the housing."""
    cold, warm = gears.lowest_temperature, gears.running_temperature
    return (
        State("cold", cold, cold), State("running", warm, warm),
        State("wheels warmer", warm, wheel_temperature(T_H=warm, Delta_T=gears.wheels_warmer)),
    )  # fmt: skip


def expansions(m: Meeting, gears: GearsInputs, materials: Mapping[str, Material], housing: str | None) -> Expansions:
    """Without a housing material the housing grows as the driver does."""
    alpha_1, alpha_2 = materials[m.driver.material].expansion, materials[m.driven.material].expansion
    alpha_H = alpha_1 if housing is None else materials[housing].expansion
    share = m.inputs.support_share
    if not share or gears.support_material is None:
        return Expansions(alpha_H, alpha_1, alpha_2)
    support = materials[gears.support_material].expansion
    with about(f"mesh {m.name}"):
        return Expansions(expansion_between_centres(alpha_H=alpha_H, alpha_S=support, lambda_S=share), alpha_1, alpha_2)


def grown(m: Meeting, alpha: Expansions, T_housing: Any, T_wheels: Any) -> Grown:
    """At the temperatures of housing and wheels, numbers or arrays."""
    eps_a = expansion(alpha=alpha.centres, T=T_housing)
    eps_1, eps_2 = expansion(alpha=alpha.driver, T=T_wheels), expansion(alpha=alpha.driven, T=T_wheels)
    eps_g = expansion_of_wheels(eps_1=eps_1, eps_2=eps_2, d_b1=m.driver.base_diameter, d_b2=m.driven.base_diameter)
    return Grown(eps_a, eps_1, eps_2, eps_g)


def change(m: Meeting, by: Grown) -> Metre:
    return change_against_wheels(a_w=m.mesh.centre_distance, eps_a=by.centres, eps_g=by.wheels)


def at_state(m: Meeting, by: Grown, a: Metre, s_b1: Metre, s_b2: Metre) -> AtState:
    """`a`, `s_b1`, `s_b2`: centre distance and thicknesses at the base circles, at 20 °C."""
    a_eff = effective_centre(a=a, eps_a=by.centres, eps_g=by.wheels)
    m.must_mesh(a_eff, "temperature, with the tolerance and runout,")
    alpha_wt = f.working_pressure_angle(m.driver.base_diameter, m.driven.base_diameter, a_eff)
    return AtState(settled(warm(m, by, alpha_wt, s_b1, s_b2)), alpha_wt, 1 + by.centres, 1 + min(by.driver, by.driven))


def warm(m: Meeting, by: Grown, alpha_wt: Radian, s_b1: Metre, s_b2: Metre) -> Metre:
    """`alpha_wt`: at the effective centre distance."""
    return warm_backlash(
        p_bt=m.system.base_pitch, eps_1=by.driver, eps_2=by.driven, s_b1=s_b1, s_b2=s_b2, d_b1=m.driver.base_diameter,
        d_b2=m.driven.base_diameter, alpha_wt=alpha_wt, beta_b=m.system.base_helix_angle,
    )  # fmt: skip
