# SPDX-License-Identifier: Apache-2.0
"""Nominal stresses of one mesh, K = 1, with the factors that make them: those of the contact, and the form of each tooth from its tool."""

from collections.abc import Mapping

from ...library.catalogue import Material
from ...sheet.errors import NoSolution
from ...sheet.record import record
from ...sheet.text import Amount, Text
from ...sheet.units import Metre, Newton, Number, Pascal, Radian
from ..result import MeshResult, ToothSystem, WheelResult
from . import stress as s
from .result import ToothForm

ADVICE = Text("give more teeth, a larger profile shift, or a usual tool (addendum 1.25, tip radius 0.38)")


@record
class Contact:
    """Nominal contact stress of a mesh, and its factors."""

    Z_H: Number
    Z_eps: Number
    Z_beta: Number
    sigma_H0: Pascal


@record
class Root:
    """Nominal root stress of one wheel in a mesh, with its form and the helix angle factor."""

    form: ToothForm
    sigma_F0: Pascal
    Y_beta: Number


@record
class Section:
    """The critical section at the 30° tangents, in modules."""

    z_n: Number
    G: Number
    theta: Radian
    chord: Number
    q_s: Number


def contact(
    system: ToothSystem, mesh: MeshResult, driver: WheelResult, driven: WheelResult, F_t: Newton, materials: Mapping[str, Material]
) -> Contact:
    small, large = (driver, driven) if driver.teeth <= driven.teeth else (driven, driver)
    one, two = materials[small.material], materials[large.material]
    Z_H = s.zone_factor(system.base_helix_angle, mesh.working_pressure_angle, system.transverse_pressure_angle)
    Z_eps = s.contact_ratio_factor(mesh.transverse_contact_ratio, mesh.overlap_ratio)
    Z_beta = s.helix_factor_contact(system.beta)
    E_c, u = s.contact_modulus(one.poisson, one.E, two.poisson, two.E), large.teeth / small.teeth
    return Contact(Z_H, Z_eps, Z_beta, s.contact_stress(Z_H, E_c, Z_eps, Z_beta, F_t, small.pitch_diameter, mesh.face_width, u))


def root(system: ToothSystem, mesh: MeshResult, wheel: WheelResult, F_t: Newton, edition: int) -> Root:
    form = tooth_form(system, wheel, mesh.transverse_contact_ratio)
    b, eps_beta = mesh.face_width, mesh.overlap_ratio
    if edition < 2019:
        Y_beta = s.helix_factor_root(eps_beta, system.beta)
        return Root(form, s.root_stress(F_t, b, system.m_n, form.Y_F, form.Y_S, Y_beta), Y_beta)
    eps_alphan = s.virtual_contact_ratio(mesh.transverse_contact_ratio, system.base_helix_angle)
    f_eps = s.load_distribution(eps_beta, eps_alphan) if eps_alphan < 2 else s.load_distribution_high(eps_beta, eps_alphan)
    Y_beta = s.helix_factor_root_2019(eps_beta, system.beta)
    return Root(form, s.root_stress_2019(F_t, b, system.m_n, form.Y_F, f_eps, form.Y_S, Y_beta), Y_beta)


def tooth_form(system: ToothSystem, wheel: WheelResult, eps_alpha: Number) -> ToothForm:
    cut = section(system, wheel)
    alpha_en, gamma_e, arm = lever(system, wheel, cut, load_circle(system, wheel, cut.z_n, eps_alpha))
    Y_F = s.form_factor(arm, alpha_en, gamma_e, cut.chord, system.alpha_n)
    return ToothForm(Y_F, s.stress_correction(s.slenderness(cut.chord, arm), cut.q_s), cut.q_s)


def section(system: ToothSystem, wheel: WheelResult) -> Section:
    z_n = s.virtual_teeth(wheel.teeth, system.base_helix_angle, system.beta)
    E = s.tool_half_width(system.m_n, system.h_fP, system.alpha_n, system.s_pr, system.rho_aP0)
    G = s.tool_corner_height(system.rho_aP0, system.h_fP, wheel.profile_shift)
    theta = s.tangent_angle(G, z_n, s.tool_corner_angle(z_n, E, system.m_n))
    chord = s.root_chord(z_n, theta, G, system.rho_aP0)
    rho_F = s.fillet_radius(system.rho_aP0, G, theta, z_n)
    if chord <= 0 or rho_F <= 0:
        raise _outside(wheel, Text("the teeth have no section at the 30° tangents"))
    return Section(z_n, G, theta, chord, s.notch_parameter(chord, rho_F))


def load_circle(system: ToothSystem, wheel: WheelResult, z_n: Number, eps_alpha: Number) -> Metre:
    """d_en, where the load acts at the outer point of single contact."""
    d_an = s.virtual_tip_diameter(system.m_n, z_n, wheel.tip_diameter, wheel.pitch_diameter)
    d_bn = s.virtual_base_diameter(system.m_n, z_n, system.alpha_n)
    if d_an <= d_bn:
        raise _outside(wheel, Text("its tip lies inside the base circle of the virtual wheel"))
    return s.load_diameter(d_an, d_bn, system.m_n, system.alpha_n, s.virtual_contact_ratio(eps_alpha, system.base_helix_angle))


def lever(system: ToothSystem, wheel: WheelResult, cut: Section, d_en: Metre) -> tuple[Radian, Radian, Number]:
    """(α_en, γ_e, h_Fe/m_n) of a load on the circle d_en."""
    d_bn = s.virtual_base_diameter(system.m_n, cut.z_n, system.alpha_n)
    if d_en <= d_bn:
        raise _outside(wheel, Text("the load acts inside the base circle of the virtual wheel"))
    alpha_en = s.load_pressure_angle(d_bn, d_en)
    gamma_e = s.load_tooth_angle(wheel.profile_shift, system.alpha_n, cut.z_n, alpha_en)
    arm = s.lever_arm(gamma_e, alpha_en, d_en, system.m_n, cut.z_n, cut.theta, cut.G, system.rho_aP0)
    if arm <= 0:
        raise _outside(wheel, Text("the load acts below the critical section"))
    return alpha_en, gamma_e, arm


def _outside(wheel: WheelResult, why: Text) -> NoSolution:
    what = Text(
        "wheel {name} (z {teeth}, x {profile_shift}): outside the tooth form of ISO 6336-3, {why}", name=wheel.name, teeth=wheel.teeth,
        profile_shift=Amount(wheel.profile_shift, form=".4g"), why=why,
    )  # fmt: skip
    return NoSolution(what, advice=ADVICE)
