# SPDX-License-Identifier: Apache-2.0
"""Backlash over temperature: housing and support carry the centres apart, each wheel grows by itself."""

import math
from collections.abc import Mapping
from typing import Generic

from ...library.catalogue import Material
from ...sheet.arrays import Value
from ...sheet.errors import NoSolution
from ...sheet.record import record, replace
from ...sheet.text import Text
from ...sheet.units import Celsius, Kelvin, Metre, Number, PerKelvin, Radian
from ...sheet.value import about
from .. import formulas as f
from ..inputs import GearsInputs
from . import formulas as b
from .case import BacklashCase

ALUMINIUM = "EN AC-43100"  # of what housings are cast of, what grows the most


@record
class ThermalState:
    name: Text
    housing: Celsius
    wheels: Celsius


@record
class Expansions:
    """Of the centre distance of one mesh, and of its two wheels."""

    centres: PerKelvin
    driver: PerKelvin
    driven: PerKelvin


@record
class Grown(Generic[Value]):
    """Expansion of the centre distance, of each wheel, and of both base circles together."""

    centres: Value
    driver: Value
    driven: Value
    wheels: Value


@record
class AtState:
    """One mesh at one temperature and one pair of tooth thicknesses."""

    backlash: Metre
    pressure_angle: Radian
    centre_growth: Number
    wheel_growth: Number  # the smaller one


def states(gears: GearsInputs, warmer: Kelvin) -> tuple[ThermalState, ThermalState, ThermalState, ThermalState]:
    """Cold start; all warm; the wheels warmer than the housing; and so in a housing that is still cold."""
    cold, warm = gears.lowest_temperature, gears.running_temperature
    first, then = (b.wheel_temperature(T_H=T, Delta_T=warmer) for T in (cold, warm))
    return (
        ThermalState(Text("cold"), cold, cold),
        ThermalState(Text("running"), warm, warm),
        ThermalState(Text("wheels warmer"), warm, then),
        ThermalState(Text("warming up"), cold, first),
    )


def expansions(
    m: BacklashCase, gears: GearsInputs, materials: Mapping[str, Material], housing: str | None
) -> Expansions:
    """Without a housing material the housing grows as the driver does."""
    alpha_1, alpha_2 = materials[m.driver.material].expansion, materials[m.driven.material].expansion
    alpha_H = alpha_1 if housing is None else materials[housing].expansion
    share = m.inputs.support_share
    if not share or gears.support_material is None:
        return Expansions(alpha_H, alpha_1, alpha_2)
    support = materials[gears.support_material].expansion
    with about(Text("mesh {name}", name=m.name)):
        alpha_a = b.expansion_between_centres(alpha_H=alpha_H, alpha_S=support, lambda_S=share)
    return Expansions(alpha_a, alpha_1, alpha_2)


def housing_open(gears: GearsInputs, m: BacklashCase) -> bool:
    """Whether nobody says what is between the centres."""
    return gears.housing_material is None and not m.inputs.support_share


def housings(
    gears: GearsInputs, m: BacklashCase, alpha: Expansions, materials: Mapping[str, Material]
) -> tuple[Expansions, ...]:
    """The one that is given, or is taken; where nobody names it, also those that grow as the driver and as
    aluminium."""
    ends = (alpha.driver, materials[ALUMINIUM].expansion) if housing_open(gears, m) else ()
    return alpha, *(replace(alpha, centres=end) for end in ends)


def grown(m: BacklashCase, alpha: Expansions, T_housing: Value, T_wheels: Value) -> Grown[Value]:
    """At the temperatures of housing and wheels [°C]."""
    eps_a = b.expansion(alpha=alpha.centres, T=T_housing)
    eps_1, eps_2 = b.expansion(alpha=alpha.driver, T=T_wheels), b.expansion(alpha=alpha.driven, T=T_wheels)
    eps_g = b.expansion_of_wheels(eps_1=eps_1, eps_2=eps_2, d_b1=m.driver.base_diameter, d_b2=m.driven.base_diameter)
    return Grown(eps_a, eps_1, eps_2, eps_g)


def change(m: BacklashCase, by: Grown[float]) -> Metre:
    return b.change_against_wheels(a_w=m.mesh.centre_distance, eps_a=by.centres, eps_g=by.wheels)


def at_state(m: BacklashCase, by: Grown[float], a: Metre, s_b1: Metre, s_b2: Metre) -> AtState:
    """`a`, `s_b1`, `s_b2`: centre distance and thicknesses at the base circles, at 20 °C."""
    a_eff = b.effective_centre(a=a, eps_a=by.centres, eps_g=by.wheels)
    m.must_mesh(a_eff, Text("temperature, with the tolerance and runout,"))
    alpha_wt = f.working_pressure_angle(m.driver.base_diameter, m.driven.base_diameter, a_eff)
    return AtState(warm(m, by, alpha_wt, s_b1, s_b2), alpha_wt, 1 + by.centres, 1 + min(by.driver, by.driven))


def smallest(m: BacklashCase, alpha: Expansions, state: ThermalState, a: Metre) -> Metre:
    """Backlash of the thickest teeth at a centre distance at 20 °C; −∞ where the base circles overlap."""
    try:
        return at_state(
            m, grown(m, alpha, state.housing, state.wheels), a, *(tooth.thickest for tooth in m.teeth)
        ).backlash
    except NoSolution:
        return -math.inf


def warm(m: BacklashCase, by: Grown[Value], alpha_wt: Value, s_b1: Metre, s_b2: Metre) -> Value:
    """`alpha_wt`: at the effective centre distance."""
    p_bt, beta_b = m.system.base_pitch, m.system.base_helix_angle
    d_b1, d_b2 = m.driver.base_diameter, m.driven.base_diameter
    return b.warm_backlash(p_bt, by.driver, by.driven, s_b1, s_b2, d_b1, d_b2, alpha_wt, beta_b)
