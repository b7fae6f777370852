# SPDX-License-Identifier: Apache-2.0
"""The influence factors of one mesh, ISO 6336-1: K_V and K_Hα, K_Fα by method B, K_Hβ, K_Fβ by method C.

The formulas are those of 2006 and of 2019 alike; the misalignment f_ma from the grade is that of 2019, the larger one, for both.  Below
about 100 N/mm the factors grow because small deviations meet a small load; they stay finite, but they are no longer what the standard was
made for, and a check says so.
"""

from typing import TYPE_CHECKING

from ...sheet.errors import NoSolution
from ...sheet.quantity import result, value
from ...sheet.record import record
from ...sheet.trace import about
from ...sheet.units import KilogramPerMetre, KilogramPerMetre3, Metre, MetrePerSecond, Newton, NewtonPerMetre, Number, Pascal, RevPerSecond
from . import deviations as d
from . import distribution as k
from . import dynamic as v
from . import stiffness as c
from .stress import contact_ratio_factor, virtual_teeth

if TYPE_CHECKING:
    from ..result import MeshResult, ToothSystem, WheelResult


@record
class Side:
    """What one wheel brings: its geometry, its solid, its flanks.

    `kind`: the class of ISO 6336-5 (Eh, IF, NT…, NV…, St, V, GTS, GGG, GGG(ferr.), GG).  `inner_diameter`: of the disc that stands for
    it, 0 for a solid one.  `sigma_Hlim` makes the running in of soft flanks, and the relief of grades 1 to 5.
    """

    wheel: "WheelResult"
    E: Pascal
    density: KilogramPerMetre3
    kind: str = "Eh"
    sigma_Hlim: Pascal = 1500e6
    inner_diameter: Metre = 0.0


@result
class Influence:
    """How much more than the nominal load the teeth carry, and what that follows from."""

    line_load: NewtonPerMetre = value("Load per face width, F_t·K_A/b", "N/mm", "w")
    dynamic_factor: Number = value("Dynamic factor", "", "K_V")
    face_load_factor_flank: Number = value("Face load factor, flank", "", "K_Hβ")
    face_load_factor_root: Number = value("Face load factor, root", "", "K_Fβ")
    face_load_factor_at_100: Number | None = value("Face load factor, flank, if the load were 100 N/mm", "", "K_Hβ,100", default=None)
    transverse_load_factor_flank: Number = value("Transverse load factor, flank", "", "K_Hα")
    transverse_load_factor_root: Number = value("Transverse load factor, root", "", "K_Fα")
    transverse_load_factor_flank_max: Number = value("Transverse load factor, flank: its limit, one pair carries all", "", "K_Hα,max")
    transverse_load_factor_root_max: Number = value("Transverse load factor, root: its limit, one pair carries all", "", "K_Fα,max")
    contact_width_share: Number = value("Share of the face width that touches", "%", "b_cal/b")
    resonance_ratio: Number = value("Speed over that of the main resonance", "", "N")
    resonance_speed: RevPerSecond = value("Main resonance, speed of the smaller wheel", "rpm", "n_E1")
    single_stiffness: Pascal = value("Single stiffness, GPa = N/(mm·µm)", "GPa", "c'")
    mesh_stiffness: Pascal = value("Mesh stiffness, GPa = N/(mm·µm)", "GPa", "c_γα")
    mesh_stiffness_face: Pascal = value("Mesh stiffness along the face width, GPa = N/(mm·µm)", "GPa", "c_γβ")
    pitch_line_velocity: MetrePerSecond = value("Speed at the reference circle", "m/s", "v")
    base_pitch_deviation: Metre = value("Deviation of the base pitch, larger of both", "µm", "f_pb")
    profile_form_deviation: Metre = value("Deviation of the profile form, larger of both", "µm", "f_fα")
    manufacturing_misalignment: Metre = value("Mesh misalignment by manufacture", "µm", "f_ma")
    effective_misalignment: Metre = value("Misalignment after running in", "µm", "F_βy")
    reduced_mass: KilogramPerMetre  # m_red
    speed_range: str
    lower_resonance: Number  # N_S, where the main resonance begins
    out_of_range: tuple[str, ...]  # sizes without a tolerance in ISO 1328-1
    misalignment_given: bool


@record
class _Deviations:
    f_pb: Metre
    f_falpha: Metre
    f_ma: Metre
    f_Hbeta: Metre
    y_p: Metre
    y_f: Metre


def inner_diameter(root_diameter: Metre, bore: Metre | None, rim: Metre | None) -> Metre:
    """The inside of the disc that stands for a wheel: of its rim where one is given, else its bore, else 0."""
    if rim is not None:
        if 2 * rim < root_diameter:
            inside = c.inside_of_rim(d_f=root_diameter, s_R=rim)
            return inside if bore is None else max(bore, inside)
    return bore if bore is not None else 0.0


def influence(
    system: "ToothSystem",
    mesh: "MeshResult",
    driver: Side,
    driven: Side,
    *,
    F_t: Newton,
    K_A: Number,
    grade: Number,
    f_sh: Metre = 0.0,
    f_ma: Metre | None = None,
    C_a: Metre | None = None,
    Z_eps: Number | None = None,
) -> Influence:
    """All factors of a mesh.  Wheel 1 of the standard is the one with fewer teeth.

    `f_ma`: misalignment by manufacture; None: from the grade.  `C_a`: tip relief that is ground; None: none.

    K_Hβ is that of the load as it is.  DIN 3990-11 takes at least 100 N/mm for its own form of it; ISO 6336-1 has no such floor, and with
    it the peak of the load over the face width would fall with the load in place of with its root.  Both are shown.
    """
    small, large = (driver, driven) if driver.wheel.teeth <= driven.wheel.teeth else (driven, driver)
    one, two = small.wheel, large.wheel
    name = f"mesh {mesh.driver}–{mesh.driven}"
    if not F_t > 0 or not K_A > 0:
        raise NoSolution(f"{name}: no load, so no influence factors", tried=f"F_t = {F_t:g} N, K_A = {K_A:g}", advice="give a torque")
    eps_alpha, eps_gamma = mesh.transverse_contact_ratio, mesh.total_contact_ratio
    with about(name):
        speed = d.pitch_line_velocity(d=one.pitch_diameter, n=one.speed)
    dev = _deviations(system, mesh, small, large, grade, f_ma, speed)
    with about(f"{name}, stiffness"):
        w = k.line_load(F_t=F_t, K_A=K_A, b=mesh.face_width)
        c_full = _stiffness(system, name, small, large)
        c_one = c.light_load_stiffness(c=c_full, w=w) if w < c.LIGHT else c_full
        c_gamma_alpha = c.mesh_stiffness(c=c_one, eps_alpha=eps_alpha)
        c_gamma_beta = c.face_stiffness(c_gamma_alpha=c_gamma_alpha)
    with about(f"{name}, dynamic factor"):
        m_red = c.reduced_mass(m_1=_mass(small), m_2=_mass(large))
        n_E1 = c.resonance_speed(z_1=one.teeth, c_gamma_alpha=c_gamma_alpha, m_red=m_red)
        N = c.resonance_ratio(n_1=one.speed, n_E1=n_E1)
        N_S = c.lower_resonance(w=w) if w < c.LIGHT else 0.85
        B = v.Excitation(
            v.pitch_parameter(c=c_one, f_pb=dev.f_pb, y_p=dev.y_p, w=w),
            v.profile_parameter(c=c_one, f_falpha=dev.f_falpha, y_f=dev.y_f, w=w),
            _relief(c_one, small, large, grade, C_a, w),
        )
        K_V = v.dynamic_factor(B, eps_gamma, N, N_S)
    bent = (f_sh, dev.f_ma, dev.f_Hbeta)
    with about(f"{name}, face load factor"):
        w_m = k.mean_load(w=w, K_V=K_V)
        K_Hbeta, share, F_betay = _face_load(small, large, speed, bent, w_m, c_gamma_beta)
        r = min(k.slenderness(b=mesh.face_width, d_a=x.tip_diameter, d_f=x.root_diameter) for x in (one, two))
        K_Fbeta = k.face_factor_root(K_Hbeta=K_Hbeta, N_F=k.root_exponent(r=r))
    at_100 = None
    if w_m < c.LIGHT:
        with about(f"{name}, face load factor at 100 N/mm"):
            at_100 = _face_load(small, large, speed, bent, c.LIGHT, _at_100(c_full, eps_alpha))[0]
    with about(f"{name}, transverse load factor"):
        f, y = (dev.f_pb, dev.y_p) if dev.f_pb >= dev.f_falpha else (dev.f_falpha, dev.y_f)
        q_alpha = k.relative_deviation(c_gamma_alpha=c_gamma_alpha, f=f, y_alpha=y, w_m=w_m, K_Hbeta=K_Hbeta)
        K_alpha = (k.pair_factor if eps_gamma <= 2 else k.pair_factor_high)(eps_gamma=eps_gamma, q_alpha=q_alpha)
        Z = contact_ratio_factor(eps_alpha=eps_alpha, eps_beta=mesh.overlap_ratio) if Z_eps is None else Z_eps
        most_H = k.pair_limit_flank(eps_gamma=eps_gamma, eps_alpha=eps_alpha, Z_eps=Z)
        most_F = k.pair_limit_root(eps_gamma=eps_gamma, eps_alpha=eps_alpha)
        K_Halpha = k.pair_factor_flank(K_alpha=K_alpha, K_max=most_H)
        K_Falpha = k.pair_factor_root(K_alpha=K_alpha, K_max=most_F)
    return Influence(
        line_load=w, dynamic_factor=K_V, face_load_factor_flank=K_Hbeta, face_load_factor_root=K_Fbeta, face_load_factor_at_100=at_100,
        transverse_load_factor_flank=K_Halpha, transverse_load_factor_root=K_Falpha, transverse_load_factor_flank_max=most_H,
        transverse_load_factor_root_max=most_F, contact_width_share=share, resonance_ratio=N, resonance_speed=n_E1, reduced_mass=m_red,
        single_stiffness=c_one, mesh_stiffness=c_gamma_alpha, mesh_stiffness_face=c_gamma_beta, pitch_line_velocity=speed,
        base_pitch_deviation=dev.f_pb, profile_form_deviation=dev.f_falpha, manufacturing_misalignment=dev.f_ma,
        effective_misalignment=F_betay, speed_range=v.speed_range(N, N_S), lower_resonance=N_S,
        misalignment_given=f_ma is not None,
        out_of_range=tuple(d.out_of_range(system.m_n, mesh.face_width, one.pitch_diameter, two.pitch_diameter)),
    )  # fmt: skip


def _deviations(
    system: "ToothSystem", mesh: "MeshResult", small: Side, large: Side, grade: Number, f_ma: Metre | None, speed: MetrePerSecond
) -> _Deviations:
    """Of both wheels the larger; a wheel that is smaller in diameter is never the worse one of the same grade."""
    slopes = []
    for side in (small, large):
        with about(f"wheel {side.wheel.name} of mesh {mesh.driver}–{mesh.driven}, grade {grade:g}"):
            slopes.append(d.rounded(f=d.helix_slope_tolerance(d=side.wheel.pitch_diameter, b=side.wheel.face_width, A=grade)))
    worse = max((small, large), key=lambda side: side.wheel.pitch_diameter)
    with about(f"wheel {worse.wheel.name} of mesh {mesh.driver}–{mesh.driven}, grade {grade:g}"):
        f_pT = d.rounded(f=d.single_pitch_tolerance(d=worse.wheel.pitch_diameter, m_n=system.m_n, A=grade))
        f_pb = d.base_pitch_deviation(f_pT=f_pT, alpha_t=system.transverse_pressure_angle)
        f_falpha = d.rounded(f=d.profile_form_tolerance(m_n=system.m_n, A=grade))
    with about(f"mesh {mesh.driver}–{mesh.driven}, running in"):
        if f_ma is None:
            f_ma = d.mesh_misalignment(f_Hbeta1=slopes[0], f_Hbeta2=slopes[1])
        y_p, y_f = (
            _of_both(*(d.running_in(f, side.kind, side.sigma_Hlim, speed) for side in _different(small, large))) for f in (f_pb, f_falpha)
        )
    return _Deviations(f_pb, f_falpha, f_ma, max(slopes), y_p, y_f)


def _different(small: Side, large: Side) -> tuple[Side, ...]:
    """Both wheels, or one where their flanks are alike."""
    return (small,) if (small.kind, small.sigma_Hlim) == (large.kind, large.sigma_Hlim) else (small, large)


def _of_both(y_1: Metre, y_2: Metre | None = None) -> Metre:
    return y_1 if y_2 is None else d.mean_run_in(y_1=y_1, y_2=y_2)


def _stiffness(system: "ToothSystem", name: str, small: Side, large: Side) -> Pascal:
    """c' from 100 N/mm on."""
    one, two = small.wheel, large.wheel
    z_n1 = virtual_teeth(z=one.teeth, beta_b=system.base_helix_angle, beta=system.beta)
    z_n2 = virtual_teeth(z=two.teeth, beta_b=system.base_helix_angle, beta=system.beta)
    q = c.tooth_compliance(z_n1=z_n1, z_n2=z_n2, x_1=one.profile_shift, x_2=two.profile_shift)
    C_B = c.basic_rack_factor(h_fP=system.h_fP, alpha_n=system.alpha_n)
    if q <= 0 or C_B <= 0:
        raise NoSolution(
            f"{name}: no stiffness by ISO 6336-1 (q' = {q * 1e9:.4g} mm·µm/N, C_B = {C_B:.4g})",
            tried=f"x_1 + x_2 = {one.profile_shift + two.profile_shift:.4g}; the formula holds from −0.5 to 2",
            advice="give smaller profile shifts, more teeth, or a usual tool (addendum 1.25)",
        )
    return c.single_stiffness(c_th=c.theoretical_stiffness(q=q), C_B=C_B, beta=system.beta, e=c.modulus_ratio(E_1=small.E, E_2=large.E))


def _mass(side: Side) -> KilogramPerMetre:
    wheel = side.wheel
    d_m = c.mean_diameter(d_a=wheel.tip_diameter, d_f=wheel.root_diameter)
    if side.inner_diameter >= d_m:
        raise NoSolution(
            f"wheel {wheel.name}: its bore ({side.inner_diameter * 1e3:.4g} mm) leaves nothing of its teeth",
            advice=f"gears.wheels.{wheel.name}.bore_diameter_mm must be below {d_m * 1e3:.4f} mm",
        )
    return c.wheel_mass(rho=side.density, d_m=d_m, d_i=side.inner_diameter, d_b=wheel.base_diameter)


def _relief(c_one: Pascal, small: Side, large: Side, grade: Number, C_a: Metre | None, w: NewtonPerMetre) -> Number:
    """B_k: 1 for the coarser grades; else of the ground relief, or of the one that running in makes."""
    if grade >= v.COARSE:
        return 1.0
    if C_a is None:
        reliefs = [v.run_in_relief(sigma_Hlim=side.sigma_Hlim) for side in _different(small, large)]
        C_a = reliefs[0] if len(reliefs) == 1 else v.mean_relief(C_a1=reliefs[0], C_a2=reliefs[1])
    return v.relief_parameter(c=c_one, C_a=C_a, w=w)


def _at_100(c_full: Pascal, eps_alpha: Number) -> Pascal:
    """c_γβ from 100 N/mm on."""
    return c.face_stiffness(c_gamma_alpha=c.mesh_stiffness(c=c_full, eps_alpha=eps_alpha))


def _face_load(
    small: Side, large: Side, speed: MetrePerSecond, bent: tuple[Metre, Metre, Metre], w_m: NewtonPerMetre, c_gamma_beta: Pascal
) -> tuple[Number, Number, Metre]:
    """(K_Hβ, b_cal/b, F_βy); `bent`: f_sh, f_ma and the larger f_Hβ."""
    f_sh, f_ma, f_Hbeta = bent
    F_betax = k.initial_misalignment(f_sh=f_sh, f_ma=f_ma, F_min=k.least_misalignment(w_m=w_m, f_Hbeta=f_Hbeta))
    y_beta = _of_both(*(d.running_in_beta(F_betax, side.kind, side.sigma_Hlim, speed) for side in _different(small, large)))
    F_betay = k.effective_misalignment(F_betax=F_betax, y_beta=y_beta)
    xi = k.relative_misalignment(F_betay=F_betay, c_gamma_beta=c_gamma_beta, w_m=w_m)
    K_Hbeta = k.face_factor_whole(xi=xi) if xi <= 1 else k.face_factor_part(xi=xi)
    return K_Hbeta, k.contact_share(xi=xi), F_betay
