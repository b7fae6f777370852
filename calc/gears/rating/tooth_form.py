# SPDX-License-Identifier: Apache-2.0
"""The form and stress correction factors of one wheel, from its tool and the contact ratio of its mesh."""

from typing import TYPE_CHECKING

from ...sheet.errors import NoSolution
from ...sheet.record import record
from ...sheet.units import Metre, Number, Radian
from . import stress as s

if TYPE_CHECKING:
    from ..result import ToothSystem, WheelResult


@record
class ToothForm:
    Y_F: Number
    Y_S: Number
    q_s: Number


@record
class Section:
    """The critical section at the 30° tangents, in modules."""

    z_n: Number
    G: Number
    theta: Radian
    chord: Number
    q_s: Number


def section(system: "ToothSystem", wheel: "WheelResult") -> Section:
    z_n = s.virtual_teeth(wheel.teeth, system.base_helix_angle, system.beta)
    E = s.tool_half_width(system.m_n, system.h_fP, system.alpha_n, system.s_pr, system.rho_aP0)
    G = s.tool_corner_height(system.rho_aP0, system.h_fP, wheel.profile_shift)
    theta = s.tangent_angle(G, z_n, s.tool_corner_angle(z_n, E, system.m_n))
    chord = s.root_chord(z_n, theta, G, system.rho_aP0)
    rho_F = s.fillet_radius(system.rho_aP0, G, theta, z_n)
    if chord <= 0 or rho_F <= 0:
        raise NoSolution(_outside(wheel, "the teeth have no section at the 30° tangents"), advice=ADVICE)
    return Section(z_n, G, theta, chord, s.notch_parameter(chord, rho_F))


def load_circle(system: "ToothSystem", wheel: "WheelResult", z_n: Number, eps_alpha: Number) -> Metre:
    d_an = s.virtual_tip_diameter(system.m_n, z_n, wheel.tip_diameter, wheel.pitch_diameter)
    d_bn = s.virtual_base_diameter(system.m_n, z_n, system.alpha_n)
    if d_an <= d_bn:
        raise NoSolution(_outside(wheel, "its tip lies inside the base circle of the virtual wheel"), advice=ADVICE)
    return s.load_diameter(d_an, d_bn, system.m_n, system.alpha_n, s.virtual_contact_ratio(eps_alpha, system.base_helix_angle))


def tooth_form(system: "ToothSystem", wheel: "WheelResult", eps_alpha: Number) -> ToothForm:
    cut = section(system, wheel)
    d_en = load_circle(system, wheel, cut.z_n, eps_alpha)
    alpha_en, gamma_e, arm = lever(system, wheel, cut, d_en)
    Y_F = s.form_factor(arm, alpha_en, gamma_e, cut.chord, system.alpha_n)
    return ToothForm(Y_F, s.stress_correction(s.slenderness(cut.chord, arm), cut.q_s), cut.q_s)


def lever(system: "ToothSystem", wheel: "WheelResult", cut: Section, d_en: Metre) -> tuple[Radian, Radian, Number]:
    """(α_en, γ_e, h_Fe/m_n) of a load on the circle d_en."""
    d_bn = s.virtual_base_diameter(system.m_n, cut.z_n, system.alpha_n)
    if d_en <= d_bn:
        raise NoSolution(_outside(wheel, "the load acts inside the base circle of the virtual wheel"), advice=ADVICE)
    alpha_en = s.load_pressure_angle(d_bn, d_en)
    gamma_e = s.load_tooth_angle(wheel.profile_shift, system.alpha_n, cut.z_n, alpha_en)
    arm = s.lever_arm(gamma_e, alpha_en, d_en, system.m_n, cut.z_n, cut.theta, cut.G, system.rho_aP0)
    if arm <= 0:
        raise NoSolution(_outside(wheel, "the load acts below the critical section"), advice=ADVICE)
    return alpha_en, gamma_e, arm


ADVICE = "give more teeth, a larger profile shift, or a usual tool (addendum 1.25, tip radius 0.38)"


def _outside(wheel: "WheelResult", why: str) -> str:
    return f"wheel {wheel.name} (z {wheel.teeth}, x {wheel.profile_shift:.4g}): outside the tooth form of ISO 6336-3, {why}"
