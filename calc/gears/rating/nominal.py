# SPDX-License-Identifier: Apache-2.0
"""Nominal stresses of one mesh, K = 1, with the factors that make them."""

from collections.abc import Mapping
from functools import cache

from ...catalogue import Material
from ...sheet.quantity import Described
from ...sheet.units import Newton, Number, Pascal
from ..result import MeshResult, ToothSystem, WheelResult
from . import stress as s
from .tooth_form import ToothForm, tooth_form

FORM = ("form_factor", "stress_correction", "notch_parameter")


@cache
def described(wheel: str) -> tuple[Described, ...]:
    """What is said of a wheel's nominal root stress, and of its FORM."""
    return (
        Described(f"Nominal root stress of {wheel}, K = 1", "MPa", "σ_F0"), Described(f"Form factor of {wheel}", "", "Y_F"),
        Described(f"Stress correction factor of {wheel}", "", "Y_S"), Described(f"Notch parameter of {wheel}", "", "q_s"),
    )  # fmt: skip


def contact(
    system: ToothSystem, mesh: MeshResult, driver: WheelResult, driven: WheelResult, F_t: Newton, materials: Mapping[str, Material]
) -> dict[str, Number]:
    small, large = (driver, driven) if driver.teeth <= driven.teeth else (driven, driver)
    one, two = materials[small.material], materials[large.material]
    Z_H = s.zone_factor(system.base_helix_angle, mesh.working_pressure_angle, system.transverse_pressure_angle)
    Z_eps = s.contact_ratio_factor(mesh.transverse_contact_ratio, mesh.overlap_ratio)
    Z_beta = s.helix_factor_contact(system.beta)
    sigma_H0 = s.contact_stress(
        Z_H=Z_H, E_c=s.contact_modulus(one.poisson, one.E, two.poisson, two.E), Z_eps=Z_eps, Z_beta=Z_beta, F_t=F_t,
        d_1=small.pitch_diameter, b=mesh.face_width, u=large.teeth / small.teeth,
    )  # fmt: skip
    return {"zone_factor": Z_H, "contact_ratio_factor": Z_eps, "helix_factor": Z_beta, "contact_stress": sigma_H0}


def root(system: ToothSystem, mesh: MeshResult, wheel: WheelResult, F_t: Newton, edition: int) -> tuple[ToothForm, Pascal, Number]:
    """(its form, σ_F0, Y_β) of one wheel of a mesh."""
    form = tooth_form(system, wheel, mesh.transverse_contact_ratio)
    b, eps_beta = mesh.face_width, mesh.overlap_ratio
    if edition < 2019:
        Y_beta = s.helix_factor_root(eps_beta, system.beta)
        return form, s.root_stress(F_t, b, system.m_n, form.Y_F, form.Y_S, Y_beta), Y_beta
    eps_alphan = s.virtual_contact_ratio(mesh.transverse_contact_ratio, system.base_helix_angle)
    f_eps = s.load_distribution(eps_beta, eps_alphan) if eps_alphan < 2 else s.load_distribution_high(eps_beta, eps_alphan)
    Y_beta = s.helix_factor_root_2019(eps_beta, system.beta)
    return form, s.root_stress_2019(F_t, b, system.m_n, form.Y_F, f_eps, form.Y_S, Y_beta), Y_beta
