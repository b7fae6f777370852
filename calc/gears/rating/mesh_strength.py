# SPDX-License-Identifier: Apache-2.0
"""Strength against pitting and tooth breakage of one mesh, ISO 6336-2, -3 and -5, from its nominal stresses.

The stresses come in as nominal ones (K = 1) with the product of their load factors; the strength of every wheel follows
from its class, its life and its surface.  S_H and S_F are on stress; on load, S_H counts squared and S_F as it is."""

from collections.abc import Mapping
from functools import cache

from ...library.catalogue import Material
from ...sheet.errors import NoSolution
from ...sheet.quantity import Described, Stated
from ...sheet.record import record, replace
from ...sheet.text import Amount, Text
from ...sheet.units import Metre, MetrePerSecond, Newton, Number, Pascal, Radian, SquareMetrePerSecond
from ...sheet.value import about
from ..result import MeshResult, ToothSystem, WheelResult
from . import strength as iso6336
from . import stress as s
from .result import FlankFilm, MeshStrength, ToothForm, WheelStrength
from .strength import ContactStrength, RootStrength

S_H_LEAST, S_F_LEAST = 1.0, 1.4  # limits: the lower end of the usual range


@record
class MeshLoad:
    """What both wheels of a mesh share.

    `v`: at the pitch circle; `K_H`, `K_F`: products of the load factors; `nu_40`: the oil at 40 °C.
    """

    sigma_H0: Pascal
    K_H: Number
    K_F: Number
    alpha_wt: Radian
    eps_alpha: Number
    eps_alphan: Number
    eps_beta: Number
    m_n: Metre
    v: MetrePerSecond
    nu_40: SquareMetrePerSecond
    flank_rz: Metre
    root_rz: Metre
    grade: int


Row = tuple[str, Described, str]  # id, description and attribute of what is shown of each wheel
CONTACT: tuple[Row, ...] = (
    ("safety_contact", Described(Text("Safety against pitting of {wheel}, on stress"), "", "S_H"), "S_H"),
    ("rated_contact_stress", Described(Text("Contact stress of {wheel}"), "MPa", "σ_H"), "sigma_H"),
    ("pitting_limit", Described(Text("Pitting stress limit of {wheel}"), "MPa", "σ_HG"), "sigma_HG"),
    ("permissible_contact_stress", Described(Text("Permissible contact stress of {wheel}"), "MPa", "σ_HP"), "sigma_HP"),
    ("single_pair_factor", Described(Text("Single pair factor of {wheel}"), "", "Z_BD"), "Z_BD"),
    ("flank_life_factor", Described(Text("Life factor of {wheel}, flank"), "", "Z_NT"), "Z_NT"),
    ("work_hardening_factor", Described(Text("Work hardening factor of {wheel}"), "", "Z_W"), "Z_W"),
)
BENDING: tuple[Row, ...] = (
    (
        "safety_bending",
        Described(Text("Safety against tooth breakage of {wheel}"), "", "S_F", short=True, page_one=2, worst="least"),
        "S_F",
    ),
    ("rated_root_stress", Described(Text("Tooth root stress of {wheel}"), "MPa", "σ_F"), "sigma_F"),
    ("root_limit", Described(Text("Tooth root stress limit of {wheel}"), "MPa", "σ_FG"), "sigma_FG"),
    ("permissible_root_stress", Described(Text("Permissible root stress of {wheel}"), "MPa", "σ_FP"), "sigma_FP"),
    ("rim_factor", Described(Text("Rim thickness factor of {wheel}"), "", "Y_B"), "Y_B"),
    ("deep_tooth_factor", Described(Text("Deep tooth factor of {wheel}"), "", "Y_DT"), "Y_DT"),
    ("root_life_factor", Described(Text("Life factor of {wheel}, root"), "", "Y_NT"), "Y_NT"),
    ("notch_sensitivity", Described(Text("Relative notch sensitivity of {wheel}"), "", "Y_δrelT"), "Y_drelT"),
    ("surface_factor", Described(Text("Relative surface factor of {wheel}"), "", "Y_RrelT"), "Y_RrelT"),
    ("size_factor", Described(Text("Size factor of {wheel}, root"), "", "Y_X"), "Y_X"),
    ("mean_stress_factor", Described(Text("Factor of reversed load of {wheel}"), "", "Y_M"), "Y_M"),
)


def mesh_strength(
    driver: WheelStrength, driven: WheelStrength, load: MeshLoad, like: MeshStrength | None = None
) -> MeshStrength:
    """The strength of both wheels of a mesh, each line under the wheel's name.

    `like`: of the same mesh at the same speed and lives under another load; what no load changes is taken from it, and
    the numbers of the wheels are not listed once more."""
    sides, pair = (driver, driven), Text("mesh {name}–{name2}", name=driver.name, name2=driven.name)
    softer = min(driver.strength.sigma_Hlim, driven.strength.sigma_Hlim)
    if like is None:
        with about(Text("{pair}, film", pair=pair)):
            film = film_factors(softer, load, driver.base_diameter, driven.base_diameter)
    else:
        film = like.film
    contact, bending = {}, {}
    for i, (wheel, mate) in enumerate((sides, sides[::-1])):
        flank = None if like is None else like.contact[wheel.name]
        root = None if like is None or like.sides[i].loading != wheel.loading else like.bending[wheel.name]
        with about(Text("flank of {name} in {pair}", name=wheel.name, pair=pair)):
            contact[wheel.name] = _contact(wheel, mate, load, film, flank)
        with about(Text("root of {name} in {pair}, strength", name=wheel.name, pair=pair)):
            bending[wheel.name] = _bending(wheel, load, root)
    with about(pair):
        S_H = min((c.S_H for c in contact.values() if c.S_H is not None), default=None)
        on_load = None if S_H is None else iso6336.contact_safety_on_load(S_H=S_H)
    return MeshStrength(
        safety_contact=S_H,
        safety_contact_load=on_load,
        lubricant_factor=film.Z_L,
        velocity_factor=film.Z_v,
        roughness_factor=film.Z_R,
        wheels=_stated(contact, bending) if like is None else {},
        sides=sides,
        contact=contact,
        bending=bending,
        film=film,
    )


def film_factors(sigma_Hlim: Pascal, load: MeshLoad, d_b1: Metre, d_b2: Metre) -> FlankFilm:
    """`sigma_Hlim`: of the softer material."""
    C_ZL = iso6336.lubricant_coefficient(sigma_Hlim)
    rho = iso6336.relative_radius(d_b1, d_b2, load.alpha_wt)
    Z_L = iso6336.lubricant_factor(C_ZL, load.nu_40)
    Z_v = iso6336.velocity_factor(iso6336.velocity_coefficient(C_ZL), load.v)
    Rz_10 = iso6336.relative_roughness(load.flank_rz, load.flank_rz, rho)
    return FlankFilm(Z_L, Z_v, iso6336.roughness_factor(Rz_10, iso6336.roughness_coefficient(sigma_Hlim)), rho)


def single_pair(wheel: WheelStrength, mate: WheelStrength, load: MeshLoad) -> Number:
    """Z_B or Z_D of a wheel.  Outside 1 < ε_α < 2 no point has single contact: 1 (rule of this program)."""
    if not 1 < load.eps_alpha < 2:
        return 1.0
    t = iso6336.inner_curvature(wheel.tip_diameter, wheel.base_diameter, 1.0, wheel.teeth)
    t_m = iso6336.inner_curvature(mate.tip_diameter, mate.base_diameter, load.eps_alpha - 1, mate.teeth)
    if min(t, t_m) <= 0:
        raise NoSolution(
            Text("single pair factor Z_B, Z_D: the inner point of single contact lies on the base circle"),
            advice=Text("give more teeth, a larger profile shift, or cut less off the tip"),
        )
    return iso6336.single_pair_factor(iso6336.curvature_ratio(load.alpha_wt, t, t_m), load.eps_beta)


def _contact(
    wheel: WheelStrength, mate: WheelStrength, load: MeshLoad, film: FlankFilm, like: ContactStrength | None
) -> ContactStrength:
    """Stress and strength of one flank."""
    if like is not None:
        sigma_H = iso6336.contact_stress_of_wheel(like.Z_BD, load.sigma_H0, load.K_H)
        S_H = iso6336.contact_safety(like.sigma_HG, sigma_H) if sigma_H else None
        return replace(like, sigma_H=sigma_H, S_H=S_H)
    of, Rz = wheel.strength, load.flank_rz
    Z_BD, u = single_pair(wheel, mate, load), wheel.teeth / mate.teeth
    Z_W = iso6336.work_hardening(of, mate.strength, Rz, Rz, film.rho_red, load.v, load.nu_40, u)
    Z_NT = iso6336.flank_life(of.kind, wheel.cycles)
    sigma_H = iso6336.contact_stress_of_wheel(Z_BD, load.sigma_H0, load.K_H)
    sigma_HG = iso6336.pitting_limit(of.sigma_Hlim, Z_NT, film.Z_L, film.Z_v, film.Z_R, Z_W)
    sigma_HP = iso6336.permissible_contact_stress(sigma_HG, S_H_LEAST)
    S_H = iso6336.contact_safety(sigma_HG, sigma_H) if sigma_H else None
    return ContactStrength(Z_BD, Z_NT, Z_W, sigma_H, sigma_HG, sigma_HP, S_H)


def _bending(wheel: WheelStrength, load: MeshLoad, like: RootStrength | None) -> RootStrength:
    """Stress and strength of one root."""
    if like is not None:
        sigma_F = iso6336.root_stress_of_wheel(wheel.sigma_F0, like.Y_B, like.Y_DT, load.K_F)
        S_F = iso6336.bending_safety(like.sigma_FG, sigma_F) if sigma_F else None
        return replace(like, sigma_F=sigma_F, S_F=S_F)
    of, rho = wheel.strength, wheel.strength.slip_layer
    Y_B = iso6336.rim_factor(wheel.name, wheel.tooth_depth, wheel.rim)
    Y_DT = iso6336.deep_tooth_factor(load.grade, load.eps_alphan)
    if of.proof_stress is not None:
        rho = iso6336.slip_layer(of.proof_stress, float(of.kind == "St"))
    assert rho is not None  # every row of the table has one of the two
    Y_NT, Y_drelT = iso6336.root_life(of.kind, wheel.cycles), iso6336.notch_sensitivity(rho, wheel.q_s)
    a, b, least = iso6336.SIZE.get(of.kind, iso6336.SIZE_HARDENED)
    Y_RrelT, Y_X = iso6336.surface_factor(of.kind, load.root_rz), iso6336.size_factor(a, b, load.m_n, least)
    Y_M = iso6336.mean_stress_factor(wheel.loading)
    sigma_F = iso6336.root_stress_of_wheel(wheel.sigma_F0, Y_B, Y_DT, load.K_F)
    sigma_FG = iso6336.root_limit(of.sigma_Flim, iso6336.TEST_GEAR, Y_NT, Y_drelT, Y_RrelT, Y_X, Y_M)
    sigma_FP = iso6336.permissible_root_stress(sigma_FG, S_F_LEAST)
    S_F = iso6336.bending_safety(sigma_FG, sigma_F) if sigma_F else None
    return RootStrength(Y_B, Y_DT, Y_NT, Y_drelT, Y_RrelT, Y_X, Y_M, sigma_F, sigma_FG, sigma_FP, S_F)


def _stated(contact: Mapping[str, ContactStrength], bending: Mapping[str, RootStrength]) -> dict[str, Stated]:
    """Every number of each wheel under its name; a safety without load is left out."""
    stated = {}
    for wheel in contact:
        for strength, rows in ((contact[wheel], CONTACT), (bending[wheel], BENDING)):
            for id, words, attribute in _described(wheel, rows):
                if (number := getattr(strength, attribute)) is not None:
                    stated[id] = Stated(words, number)
    return stated


@cache
def _described(wheel: str, rows: tuple[Row, ...]) -> tuple[tuple[str, Described, str], ...]:
    return tuple(
        (f"{id}_{wheel}", replace(about, label=Text(about.label.template, wheel=wheel)), attribute)
        for id, about, attribute in rows
    )


# --- nominal stresses of one mesh, K = 1, with the factors that make them
# Those of the contact, and the form of each tooth from its tool.

ADVICE = Text("give more teeth, a larger profile shift, or a usual tool (addendum 1.25, tip radius 0.38)")


@record
class Contact:
    """Nominal contact stress of a mesh, and its factors."""

    Z_H: Number
    Z_eps: Number
    Z_beta: Number
    E_c: Pascal
    sigma_H0: Pascal


@record
class Root:
    """Nominal root stress of one wheel in a mesh, with its form and the helix angle factor."""

    form: ToothForm
    sigma_F0: Pascal
    Y_beta: Number
    f_eps: Number  # of the edition of 2019, else 1


@record
class ToothSection:
    """The critical section at the 30° tangents, in modules."""

    z_n: Number
    G: Number
    theta: Radian
    chord: Number
    q_s: Number


def nominal_contact(
    system: ToothSystem,
    mesh: MeshResult,
    driver: WheelResult,
    driven: WheelResult,
    F_t: Newton,
    materials: Mapping[str, Material],
    like: Contact | None = None,
) -> Contact:
    """`like`: that of another force."""
    small, large = (driver, driven) if driver.teeth <= driven.teeth else (driven, driver)
    if like is None:
        one, two = materials[small.material], materials[large.material]
        Z_H = s.zone_factor(system.base_helix_angle, mesh.working_pressure_angle, system.transverse_pressure_angle)
        Z_eps = s.contact_ratio_factor(mesh.transverse_contact_ratio, mesh.overlap_ratio)
        Z_beta = s.helix_factor_contact(system.beta)
        E_c = s.contact_modulus(one.poisson, one.E, two.poisson, two.E)
    else:
        Z_H, Z_eps, Z_beta, E_c = like.Z_H, like.Z_eps, like.Z_beta, like.E_c
    d, b, u = small.pitch_diameter, mesh.face_width, large.teeth / small.teeth
    return Contact(Z_H, Z_eps, Z_beta, E_c, s.contact_stress(Z_H, E_c, Z_eps, Z_beta, F_t, d, b, u))


def nominal_root(
    system: ToothSystem, mesh: MeshResult, wheel: WheelResult, F_t: Newton, edition: int, like: Root | None = None
) -> Root:
    """`like`: that of another force."""
    b, eps_beta, f_eps = mesh.face_width, mesh.overlap_ratio, 1.0
    if like is not None:
        form, Y_beta, f_eps = like.form, like.Y_beta, like.f_eps
    else:
        form = tooth_form(system, wheel, mesh.transverse_contact_ratio)
        if edition < 2019:
            Y_beta = s.helix_factor_root(eps_beta, system.beta)
        else:
            eps_alphan = s.virtual_contact_ratio(mesh.transverse_contact_ratio, system.base_helix_angle)
            f_eps = (s.load_distribution if eps_alphan < 2 else s.load_distribution_high)(eps_beta, eps_alphan)
            Y_beta = s.helix_factor_root_2019(eps_beta, system.beta)
    if edition < 2019:
        return Root(form, s.root_stress(F_t, b, system.m_n, form.Y_F, form.Y_S, Y_beta), Y_beta, f_eps)
    return Root(form, s.root_stress_2019(F_t, b, system.m_n, form.Y_F, f_eps, form.Y_S, Y_beta), Y_beta, f_eps)


def tooth_form(system: ToothSystem, wheel: WheelResult, eps_alpha: Number) -> ToothForm:
    cut, m_n, alpha_n = section(system, wheel), system.m_n, system.alpha_n
    d_an = s.virtual_tip_diameter(m_n, cut.z_n, wheel.tip_diameter, wheel.pitch_diameter)
    d_bn = s.virtual_base_diameter(m_n, cut.z_n, alpha_n)
    if d_an <= d_bn:
        raise _outside(wheel, Text("its tip lies inside the base circle of the virtual wheel"))
    # d_en, where the load acts at the outer point of single contact
    d_en = s.load_diameter(d_an, d_bn, m_n, alpha_n, s.virtual_contact_ratio(eps_alpha, system.base_helix_angle))
    alpha_en, gamma_e, arm = lever(system, wheel, cut, d_en)
    Y_F = s.form_factor(arm, alpha_en, gamma_e, cut.chord, system.alpha_n)
    return ToothForm(Y_F, s.stress_correction(s.slenderness(cut.chord, arm), cut.q_s), cut.q_s)


def section(system: ToothSystem, wheel: WheelResult) -> ToothSection:
    z_n = s.virtual_teeth(wheel.teeth, system.base_helix_angle, system.beta)
    E = s.tool_half_width(system.m_n, system.h_fP, system.alpha_n, system.s_pr, system.rho_aP0)
    G = s.tool_corner_height(system.rho_aP0, system.h_fP, wheel.profile_shift)
    theta = s.tangent_angle(G, z_n, s.tool_corner_angle(z_n, E, system.m_n))
    chord = s.root_chord(z_n, theta, G, system.rho_aP0)
    rho_F = s.fillet_radius(system.rho_aP0, G, theta, z_n)
    if min(chord, rho_F) <= 0:
        raise _outside(wheel, Text("the teeth have no section at the 30° tangents"))
    return ToothSection(z_n, G, theta, chord, s.notch_parameter(chord, rho_F))


def lever(system: ToothSystem, wheel: WheelResult, cut: ToothSection, d_en: Metre) -> tuple[Radian, Radian, Number]:
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
        "wheel {name} (z {teeth}, x {profile_shift}): outside the tooth form of ISO 6336-3, {why}",
        name=wheel.name,
        teeth=wheel.teeth,
        profile_shift=Amount(wheel.profile_shift, form=".4g"),
        why=why,
    )
    return NoSolution(what, advice=ADVICE)
