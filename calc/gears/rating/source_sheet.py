# SPDX-License-Identifier: Apache-2.0
"""The calculation sheet of Finotti 2013 for one pair, exactly as it computes, for the values that are wrong in it.

Wheel 1 is the driver, u = z_2/z_1 also below 1.  It reproduces Tables 4.5 and 4.6.
"""

from ...sheet.formula import formula
from ...sheet.functions import cos, pi, sin, sqrt
from ...sheet.units import Metre, Newton, NewtonMetre, Number, Pascal, Radian, RevPerSecond, Watt
from .. import formulas as f
from ..result import MeshResult, ToothSystem, WheelResult
from . import stress as s
from .tooth_form import ToothForm, lever, section

SHEET = "Finotti 2013, sheet of Tables 4.5 and 4.6"
E_OF_SHEET: Pascal = 2.1e12  # 210000 daN/mm², ten times that of steel


@formula("H_0", "Finotti 2013, Fig. 4.20: addendum of the tool in transverse modules (printed as mm)")
def transverse_addendum(h_aP0: Number, beta: Radian) -> Number:
    return h_aP0 * cos(beta)


@formula("T", f"{SHEET}: torque from power and speed of the train's first wheel, for every driver")
def torque(P: Watt, n: RevPerSecond) -> NewtonMetre:
    return P / (2 * pi * n)


@formula("σ_H,F", f"{SHEET} (wrong: E, β for β_b, and √cos β of the withdrawn edition)", unit="MPa")
def contact_stress(beta: Radian, alpha_wt: Radian, alpha_t: Radian, Z_eps: Number, F_t: Newton, d_1: Metre, b: Metre, u: Number) -> Pascal:
    return (
        sqrt(0.175 * E_OF_SHEET) * sqrt(2 * cos(beta) * cos(alpha_wt) / (cos(alpha_t) ** 2 * sin(alpha_wt)))
        * Z_eps * sqrt(cos(beta)) * sqrt(F_t / (d_1 * b) * (u + 1) / u)
    )  # fmt: skip


@formula("d_en,F", f"{SHEET} (wrong: the transverse height of the outer single contact, not that of the virtual wheel)", unit="mm")
def load_diameter(m_n: Metre, z_n: Number, d_D: Metre, d: Metre) -> Metre:
    return m_n * z_n + d_D - d


@formula("Y_F,F", f"{SHEET} (wrong: α_t for α_n)", names={"h": "h*_Fe", "s": "s*_Fn"})
def form_factor(h: Number, alpha_en: Radian, gamma_e: Radian, s: Number, alpha_t: Radian) -> Number:
    return 6 * h * cos(alpha_en - gamma_e) / (s**2 * cos(alpha_t))


@formula("α_tr", "Finotti 2013, Fig. 4.22 (wrong: the product of two angles in degrees stands for their sum); in degrees")
def ball_angle(alpha_wt: Radian, eta: Radian) -> Number:
    return (180 / pi) ** 2 * alpha_wt * eta


@formula("D_F", "Finotti 2013, Fig. 4.22: ball from the angle above", unit="mm")
def ball(d_w: Metre, beta_b: Radian, eta: Radian, alpha_tr: Radian) -> Metre:
    return d_w * cos(beta_b) * sin(eta) / cos(alpha_tr)


def sheet_contact(system: ToothSystem, mesh: MeshResult, driver: WheelResult, driven: WheelResult, F_t: Newton) -> Pascal:
    """σ_H of the sheet."""
    Z_eps = s.contact_ratio_factor(mesh.transverse_contact_ratio, mesh.overlap_ratio)
    u = driven.teeth / driver.teeth
    alpha_wt, alpha_t = mesh.working_pressure_angle, system.transverse_pressure_angle
    return contact_stress(system.beta, alpha_wt, alpha_t, Z_eps, F_t, driver.pitch_diameter, mesh.face_width, u)


def sheet_tooth_form(system: ToothSystem, wheel: WheelResult, sap_curvature: Metre) -> ToothForm:
    """Y_F and Y_S of the sheet; ρ at the outer single contact is that at the start of contact plus one base pitch."""
    cut = section(system, wheel)
    d_D = f.diameter_at(wheel.base_diameter, sap_curvature + system.base_pitch)
    alpha_en, gamma_e, arm = lever(system, wheel, cut, load_diameter(system.m_n, cut.z_n, d_D, wheel.pitch_diameter))
    Y_F = form_factor(arm, alpha_en, gamma_e, cut.chord, system.transverse_pressure_angle)
    return ToothForm(Y_F, s.stress_correction(s.slenderness(cut.chord, arm), cut.q_s), cut.q_s)


def sheet_root(system: ToothSystem, mesh: MeshResult, wheel: WheelResult, sap_curvature: Metre, F_t: Newton) -> Pascal:
    """σ_F of the sheet."""
    form = sheet_tooth_form(system, wheel, sap_curvature)
    Y_beta = s.helix_factor_root(mesh.overlap_ratio, system.beta)
    return s.root_stress(F_t, mesh.face_width, system.m_n, form.Y_F, form.Y_S, Y_beta)
