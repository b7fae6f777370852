# SPDX-License-Identifier: Apache-2.0
"""The influence factors of one mesh, ISO 6336-1: K_V and K_Hα, K_Fα by method B, K_Hβ, K_Fβ by method C.

The formulas are those of 2006 and of 2019 alike; the misalignment f_ma from the grade is that of 2019, the larger one,
for both.  Below about 100 N/mm the factors grow because small deviations meet a small load; they stay finite, but they
are no longer what the standard was made for, and a check says so."""

from collections.abc import Mapping

from ...library.catalogue import Material
from ...sheet.errors import NoSolution
from ...sheet.record import record
from ...sheet.text import Amount, Text
from ...sheet.units import (
    KilogramPerMetre,
    KilogramPerMetre3,
    Metre,
    MetrePerSecond,
    Newton,
    NewtonPerMetre,
    Number,
    Pascal,
)
from ...sheet.value import about
from ..limits import mm
from ..result import MeshResult, ToothSystem, WheelResult
from . import distribution as k
from . import dynamic as v
from .result import Deviations, Influence
from .stress import contact_ratio_factor, virtual_teeth


@record
class WheelOfPair:
    """What one wheel brings: its geometry, its solid, its flanks.

    `kind`: the class of ISO 6336-5 (Eh, IF, NT…, NV…, St, V, GTS, GGG, GGG(ferr.), GG).  `inner_diameter`: of the disc
    that stands for it, 0 for a solid one.  `sigma_Hlim` makes the running in of soft flanks, and the relief of grades 1
    to 5."""

    wheel: WheelResult
    E: Pascal
    density: KilogramPerMetre3
    kind: str
    sigma_Hlim: Pascal
    inner_diameter: Metre


Pair = tuple[WheelOfPair, WheelOfPair]  # the wheel with fewer teeth, which is wheel 1 of the standard, and the other


def inner_diameter(root_diameter: Metre, bore: Metre | None, rim: Metre | None) -> Metre:
    """The inside of the disc that stands for a wheel: of its rim where one is given, else its bore, else 0."""
    if rim is not None and 2 * rim < root_diameter:
        inside = v.inside_of_rim(d_f=root_diameter, s_R=rim)
        return inside if bore is None else max(bore, inside)
    return bore if bore is not None else 0.0


def must_leave_teeth(wheel: WheelResult, inside: Metre) -> Metre:
    """The inside of its disc.  Raises NoSolution where it reaches the root of its teeth."""
    if inside < wheel.root_diameter:
        return inside
    raise NoSolution(
        Text(
            "wheel {name}: its bore ({inner_diameter} mm) leaves nothing of its teeth",
            name=wheel.name,
            inner_diameter=mm(inside, ".4g"),
        ),
        advice=Text(
            "gears.wheels.{name}.bore_diameter_mm must be below {d_m} mm",
            name=wheel.name,
            d_m=mm(wheel.root_diameter, ".4f"),
        ),
    )


def influence(
    system: ToothSystem,
    mesh: MeshResult,
    driver: WheelOfPair,
    driven: WheelOfPair,
    *,
    F_t: Newton,
    K_A: Number,
    grade: Number,
    f_sh: Metre = 0.0,
    f_ma: Metre | None = None,
    C_a: Metre | None = None,
    Z_eps: Number | None = None,
    like: Influence | None = None,
) -> Influence:
    """All factors of a mesh.

    `like`: of the same mesh at the same speed under another load; what no load changes is taken from it.
    `f_ma`: misalignment by manufacture; None: from the grade.  `C_a`: tip relief that is ground; None: none.

    K_Hβ is that of the load as it is.  DIN 3990-11 takes at least 100 N/mm for its own form of it; ISO 6336-1 has no
    such floor, and with it the peak of the load over the face width would fall with the load in place of with its root.
    Both are shown."""
    pair = (driver, driven) if driver.wheel.teeth <= driven.wheel.teeth else (driven, driver)
    one, two = (side.wheel for side in pair)
    name = Text("mesh {pair}", pair=mesh.title)
    if not F_t > 0 or not K_A > 0:
        raise NoSolution(
            Text("{name}: no load, so no influence factors", name=name),
            tried=Text("F_t = {f_t} N, K_A = {k_a}", f_t=Amount(F_t, form="g"), k_a=Amount(K_A, form="g")),
            advice=Text("give a torque"),
        )
    eps_alpha, eps_gamma = mesh.transverse_contact_ratio, mesh.total_contact_ratio
    if like is None:
        with about(name):
            speed = k.pitch_line_velocity(d=one.pitch_diameter, n=one.speed)
        dev = _deviations(system, mesh, pair, grade, f_ma, speed)
    else:
        speed, dev = like.pitch_line_velocity, like.deviations
    with about(Text("{name}, stiffness", name=name)):
        w = k.line_load(F_t=F_t, K_A=K_A, b=mesh.face_width)
        c_full = _stiffness(system, name, pair) if like is None else like.full_stiffness
        c_one = v.light_load_stiffness(c=c_full, w=w) if w < v.LIGHT else c_full
        c_gamma_alpha = v.mesh_stiffness(c=c_one, eps_alpha=eps_alpha)
        c_gamma_beta = v.face_stiffness(c_gamma_alpha=c_gamma_alpha)
    with about(Text("{name}, dynamic factor", name=name)):
        m_red = v.reduced_mass(m_1=_mass(pair[0]), m_2=_mass(pair[1])) if like is None else like.reduced_mass
        n_E1 = v.resonance_speed(z_1=one.teeth, c_gamma_alpha=c_gamma_alpha, m_red=m_red)
        N = v.resonance_ratio(n_1=one.speed, n_E1=n_E1)
        N_S = v.lower_resonance(w=w) if w < v.LIGHT else 0.85
        B = v.Excitation(
            v.pitch_parameter(c=c_one, f_pb=dev.f_pb, y_p=dev.y_p, w=w),
            v.profile_parameter(c=c_one, f_falpha=dev.f_falpha, y_f=dev.y_f, w=w),
            _relief(c_one, pair, grade, C_a, w),
        )
        K_V = v.dynamic_factor(B, eps_gamma, N, N_S)
    misaligned = (f_sh, dev.f_ma, dev.f_Hbeta)
    with about(Text("{name}, face load factor", name=name)):
        w_m = k.mean_load(w=w, K_V=K_V)
        K_Hbeta, share, F_betay = _face_load(pair, speed, misaligned, w_m, c_gamma_beta)
        r = min(k.slenderness(b=mesh.face_width, d_a=x.tip_diameter, d_f=x.root_diameter) for x in (one, two))
        K_Fbeta = k.face_factor_root(K_Hbeta=K_Hbeta, N_F=k.root_exponent(r=r))
    at_100 = None
    if w_m < v.LIGHT:
        with about(Text("{name}, face load factor at 100 N/mm", name=name)):
            stiff = v.face_stiffness(c_gamma_alpha=v.mesh_stiffness(c=c_full, eps_alpha=eps_alpha))
            at_100, _, _ = _face_load(pair, speed, misaligned, v.LIGHT, stiff)
    with about(Text("{name}, transverse load factor", name=name)):
        f, y = (dev.f_pb, dev.y_p) if dev.f_pb >= dev.f_falpha else (dev.f_falpha, dev.y_f)
        q_alpha = k.relative_deviation(c_gamma_alpha=c_gamma_alpha, f=f, y_alpha=y, w_m=w_m, K_Hbeta=K_Hbeta)
        K_alpha = (k.pair_factor if eps_gamma <= 2 else k.pair_factor_high)(eps_gamma=eps_gamma, q_alpha=q_alpha)
        Z = contact_ratio_factor(eps_alpha=eps_alpha, eps_beta=mesh.overlap_ratio) if Z_eps is None else Z_eps
        most_H = k.pair_limit_flank(eps_gamma=eps_gamma, eps_alpha=eps_alpha, Z_eps=Z)
        most_F = k.pair_limit_root(eps_gamma=eps_gamma, eps_alpha=eps_alpha)
        K_Halpha = k.pair_factor_flank(K_alpha=K_alpha, K_max=most_H)
        K_Falpha = k.pair_factor_root(K_alpha=K_alpha, K_max=most_F)
    return Influence(
        line_load=w,
        dynamic_factor=K_V,
        face_load_factor_flank=K_Hbeta,
        face_load_factor_root=K_Fbeta,
        face_load_factor_at_100=at_100,
        transverse_load_factor_flank=K_Halpha,
        transverse_load_factor_root=K_Falpha,
        transverse_load_factor_flank_max=most_H,
        transverse_load_factor_root_max=most_F,
        contact_width_share=share,
        resonance_ratio=N,
        resonance_speed=n_E1,
        reduced_mass=m_red,
        deviations=dev,
        full_stiffness=c_full,
        single_stiffness=c_one,
        mesh_stiffness=c_gamma_alpha,
        mesh_stiffness_face=c_gamma_beta,
        pitch_line_velocity=speed,
        base_pitch_deviation=dev.f_pb,
        profile_form_deviation=dev.f_falpha,
        manufacturing_misalignment=dev.f_ma,
        effective_misalignment=F_betay,
        speed_range=v.speed_range(N, N_S),
        lower_resonance=N_S,
        misalignment_given=f_ma is not None,
        out_of_range=tuple(k.out_of_range(system.m_n, mesh.face_width, one.pitch_diameter, two.pitch_diameter)),
    )


def _deviations(
    system: ToothSystem, mesh: MeshResult, pair: Pair, grade: Number, f_ma: Metre | None, speed: MetrePerSecond
) -> Deviations:
    """Of both wheels the larger; a wheel that is smaller in diameter is never the worse one of the same grade."""

    def graded(side: WheelOfPair) -> Text:
        name, A = side.wheel.name, Amount(grade, form="g")
        return Text("wheel {name} of mesh {pair}, grade {grade}", name=name, pair=mesh.title, grade=A)

    slopes = []
    for side in pair:
        with about(graded(side)):
            slope = k.helix_slope_tolerance(d=side.wheel.pitch_diameter, b=side.wheel.face_width, A=grade)
            slopes.append(k.rounded(f=slope))
    worse = max(pair, key=lambda side: side.wheel.pitch_diameter)
    with about(graded(worse)):
        f_pT = k.rounded(f=k.single_pitch_tolerance(d=worse.wheel.pitch_diameter, m_n=system.m_n, A=grade))
        f_pb = k.base_pitch_deviation(f_pT=f_pT, alpha_t=system.transverse_pressure_angle)
        f_falpha = k.rounded(f=k.profile_form_tolerance(m_n=system.m_n, A=grade))
    with about(Text("mesh {pair}, running in", pair=mesh.title)):
        if f_ma is None:
            f_ma = k.mesh_misalignment(f_Hbeta1=slopes[0], f_Hbeta2=slopes[1])
        y_p, y_f = (
            _mean_run_in([k.running_in(f, s.kind, s.sigma_Hlim, speed) for s in _unlike(pair)])
            for f in (f_pb, f_falpha)
        )
    return Deviations(f_pb, f_falpha, f_ma, max(slopes), y_p, y_f)


def _unlike(pair: Pair) -> tuple[WheelOfPair, ...]:
    """Both wheels, or one where their flanks are alike."""
    one, two = pair
    return (one,) if (one.kind, one.sigma_Hlim) == (two.kind, two.sigma_Hlim) else pair


def _mean_run_in(y: list[Metre]) -> Metre:
    return y[0] if len(y) == 1 else k.mean_run_in(y_1=y[0], y_2=y[1])


def _stiffness(system: ToothSystem, name: Text, pair: Pair) -> Pascal:
    """c' from 100 N/mm on."""
    one, two = ((side.E, side.wheel) for side in pair)
    return _single_stiffness(system, name, one, two)


def _single_stiffness(
    system: ToothSystem, name: Text, small: tuple[Pascal, WheelResult], large: tuple[Pascal, WheelResult]
) -> Pascal:
    """The same by moduli and wheels, the one with fewer teeth first."""
    (E_1, one), (E_2, two) = small, large
    z_n1, z_n2 = (virtual_teeth(wheel.teeth, system.base_helix_angle, system.beta) for wheel in (one, two))
    q = v.tooth_compliance(z_n1=z_n1, z_n2=z_n2, x_1=one.profile_shift, x_2=two.profile_shift)
    C_B = v.basic_rack_factor(h_fP=system.h_fP, alpha_n=system.alpha_n)
    if q <= 0 or C_B <= 0:
        shift_sum = Amount(one.profile_shift + two.profile_shift, form=".4g")
        raise NoSolution(
            Text(
                "{name}: no stiffness by ISO 6336-1 (q' = {q} mm·µm/N, C_B = {c_b})",
                name=name,
                q=Amount(q * 1e9, form=".4g"),
                c_b=Amount(C_B, form=".4g"),
            ),
            tried=Text("x_1 + x_2 = {profile_shift}; the formula holds from −0.5 to 2", profile_shift=shift_sum),
            advice=Text("give smaller profile shifts, more teeth, or a usual tool (addendum 1.25)"),
        )
    return v.single_stiffness(v.theoretical_stiffness(q), C_B, system.beta, v.modulus_ratio(E_1, E_2))


def full_stiffness(
    system: ToothSystem, mesh: MeshResult, wheels: Mapping[str, WheelResult], materials: Mapping[str, Material]
) -> Pascal:
    """c_γα of a mesh from 100 N/mm on, whether its wheels have a strength class or not."""
    sides = [(materials[wheels[name].material].E, wheels[name]) for name in (mesh.driver, mesh.driven)]
    (E_1, one), (E_2, two) = sorted(sides, key=lambda side: side[1].teeth)
    name = Text("mesh {pair}", pair=mesh.title)
    return v.mesh_stiffness(
        c=_single_stiffness(system, name, (E_1, one), (E_2, two)), eps_alpha=mesh.transverse_contact_ratio
    )


def _mass(side: WheelOfPair) -> KilogramPerMetre:
    """Of one wheel, reduced to the line of action."""
    wheel = side.wheel
    inside = must_leave_teeth(wheel, side.inner_diameter)
    d_m = v.mean_diameter(d_a=wheel.tip_diameter, d_f=wheel.root_diameter)
    return v.wheel_mass(rho=side.density, d_m=d_m, d_i=inside, d_b=wheel.base_diameter)


def _relief(c_one: Pascal, pair: Pair, grade: Number, C_a: Metre | None, w: NewtonPerMetre) -> Number:
    """B_k: 1 for the coarser grades; else of the ground relief, or of the one that running in makes."""
    if grade >= v.COARSE:
        return 1.0
    if C_a is None:
        reliefs = [v.run_in_relief(sigma_Hlim=side.sigma_Hlim) for side in _unlike(pair)]
        C_a = reliefs[0] if len(reliefs) == 1 else v.mean_relief(C_a1=reliefs[0], C_a2=reliefs[1])
    return v.relief_parameter(c=c_one, C_a=C_a, w=w)


def _face_load(
    pair: Pair, speed: MetrePerSecond, misaligned: tuple[Metre, Metre, Metre], w_m: NewtonPerMetre, c_gamma_beta: Pascal
) -> tuple[Number, Number, Metre]:
    """(K_Hβ, b_cal/b, F_βy); `misaligned`: f_sh, f_ma and the larger f_Hβ."""
    f_sh, f_ma, f_Hbeta = misaligned
    F_betax = k.initial_misalignment(f_sh=f_sh, f_ma=f_ma, F_min=k.least_misalignment(w_m=w_m, f_Hbeta=f_Hbeta))
    y_beta = _mean_run_in([k.running_in_beta(F_betax, side.kind, side.sigma_Hlim, speed) for side in _unlike(pair)])
    F_betay = k.effective_misalignment(F_betax=F_betax, y_beta=y_beta)
    xi = k.relative_misalignment(F_betay=F_betay, c_gamma_beta=c_gamma_beta, w_m=w_m)
    K_Hbeta = k.face_factor_whole(xi=xi) if xi <= 1 else k.face_factor_part(xi=xi)
    return K_Hbeta, k.contact_share(xi=xi), F_betay
