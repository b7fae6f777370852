# SPDX-License-Identifier: Apache-2.0
"""The bolts that hold the shaft's support to the block: preload by torque, pressure under the head, slip and
separation.

The load turns with the shaft.  At each end of the support a force Q of constant size sweeps through all directions: it
pulls the joint apart, presses it together and pushes it to either side within one turn.  The joint holds by friction
alone; locating pins, where there are any, are left out."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from ...sheet.check import Check, CheckRule
from ...sheet.formula import formula
from ...sheet.functions import atan, cos, largest, modulus, pi, sqrt, tan
from ...sheet.quantity import dotted, result, value
from ...sheet.text import Amount, Text
from ...sheet.units import (
    Metre,
    Newton,
    NewtonMetre,
    Number,
    Pascal,
    PhasorNewton,
    PhasorNewtonMetre,
    Radian,
    SquareMetre,
)
from ...sheet.value import about
from ..inputs import CountershaftInputs
from .inputs import STRENGTH, Bolts, nominal_diameter, pitch, pitch_diameter, root_diameter, stress_area

if TYPE_CHECKING:
    from ...library.catalogue import Material

# VDI 2230-1: α_A = 1.6 to 2.0 for a torque wrench and an estimated coefficient of friction.  Nothing is known of the
# wrench, so the unfavourable end is taken.
ALPHA_A = 2.0
NO_FORCE = 1e-6  # N: below it the shaft puts no force on its support

VDI = Text("VDI 2230-1")
SOURCE = Text("Finotti 2013, Table 6.1")
TURNING = Text("statics of a joint whose load turns through all directions")
LEAST = {"F_min": "F_V,min", "n": "n_b"}


# --- preload


@formula("α_h", Text("{vdi}: helix angle at the pitch diameter", vdi=VDI), names={"p": "P_h"})
def helix_angle(p: Metre, d_2: Metre) -> Radian:
    return atan(p / (pi * d_2))


@formula("ρ′", Text("{vdi}: angle of friction on flanks at 30°", vdi=VDI))
def friction_angle(mu: Number) -> Radian:
    return atan(mu / cos(pi / 6))


@formula("D_Km", Text("{vdi}: mean diameter of the bearing face of the head", vdi=VDI), unit="mm")
def mean_bearing_diameter(d_w: Metre, d_h: Metre) -> Metre:
    return (d_w + d_h) / 2


@formula("r_h", Text("{vdi}: radius of the friction under the head", vdi=VDI), unit="mm")
def friction_radius(d_w: Metre, d_h: Metre) -> Metre:
    return (d_w + d_h) / 4


@formula(
    "F_V",
    "statics: torque of a screw with friction in thread and under head, solved for the force (VDI 2230-1; Finotti "
    "2013, Table 6.1)",
    names={"T": "M_A", "rho": "ρ′"},
)
def preload(T: NewtonMetre, d_2: Metre, alpha_h: Radian, rho: Radian, mu: Number, r_h: Metre) -> Newton:
    """`rho` is the angle of friction on the flanks.

    >>> preload(T=45, d_2=0.009026, alpha_h=0.05285, rho=0.1377, mu=0.12, r_h=0.0065)
    27264.23...
    """
    return T / (d_2 / 2 * tan(alpha_h + rho) + mu * r_h)


@formula("F_V", Text("{vdi}: short form, for small angles", vdi=VDI), names={"T": "M_A", "p": "P_h"})
def preload_short(T: NewtonMetre, p: Metre, mu: Number, d_2: Metre, D_Km: Metre) -> Newton:
    return T / (0.159 * p + 0.578 * mu * d_2 + mu * D_Km / 2)


@formula("d_2", Text("{source}: pitch diameter", source=SOURCE), unit="mm", names={"p": "P_h"})
def pitch_diameter_source(D: Metre, p: Metre) -> Metre:
    return D - 0.64953 * p


@formula(
    "α_h", Text("{source}: helix angle at the nominal diameter, where no flank is", source=SOURCE), names={"p": "P_h"}
)
def helix_angle_source(p: Metre, D: Metre) -> Radian:
    return atan(p / (pi * D))


@formula("ρ′", Text("{source}: angle of friction without the flanks' inclination", source=SOURCE))
def friction_angle_source(mu: Number) -> Radian:
    return atan(mu)


@formula("r_h", Text("{source}: friction at the outer edge of the head", source=SOURCE), unit="mm")
def friction_radius_source(d_w: Metre) -> Metre:
    return d_w / 2


@formula(
    "F_V,min",
    Text(
        "{vdi}: least preload; tightening factor of a torque wrench with an estimated coefficient of friction, 1.6 to "
        "2.0",
        vdi=VDI,
    ),
)
def least_preload(F_V: Newton, alpha_A: Number) -> Newton:
    """F_V is taken as the largest preload, as it is with the smallest friction to be expected."""
    return F_V / alpha_A


@formula("p_h", Text("{vdi}: pressure under the head, hole not chamfered", vdi=VDI), unit="MPa")
def head_pressure(F_V: Newton, d_w: Metre, d_h: Metre) -> Pascal:
    return F_V / (pi / 4 * (d_w**2 - d_h**2))


@formula(
    "σ_z",
    "elasticity: preload over the stress area of the thread (ISO 898-1); torsion of tightening left out",
    unit="MPa",
)
def tensile_stress(F_V: Newton, A_s: SquareMetre) -> Pascal:
    """>>> tensile_stress(F_V=27270, A_s=5.799e-05)
    4702534...
    """
    return F_V / A_s


# --- the joint under the turning load


@formula(
    "z_m", "rule of this program: middle of the outer bearings, where the middle of the bolts is taken to be", unit="mm"
)
def middle(z_f: Metre, z_r: Metre) -> Metre:
    return (z_f + z_r) / 2


@formula("l_b", "geometry: distance of the outer bearings", unit="mm")
def bearing_span(z_f: Metre, z_r: Metre) -> Metre:
    return z_r - z_f


@formula("C_m", "statics: couple moved to the middle of the bolts")
def couple_about_middle(C_S: PhasorNewtonMetre, z_m: Metre, F_S: PhasorNewton) -> PhasorNewtonMetre:
    return C_S - z_m * F_S


@formula("Q_f", "statics of a rigid support: force and couple of the shaft shared by the front and rear bolts")
def force_front(F_S: PhasorNewton, C_m: PhasorNewtonMetre, l_b: Metre) -> Newton:
    return modulus(F_S / 2 - C_m / l_b)


@formula("Q_r", "statics of a rigid support: force and couple of the shaft shared by the front and rear bolts")
def force_rear(F_S: PhasorNewton, C_m: PhasorNewtonMetre, l_b: Metre) -> Newton:
    return modulus(F_S / 2 + C_m / l_b)


@formula("Q", "mathematics: the end that carries more")
def end_force(Q_f: Newton, Q_r: Newton) -> Newton:
    return largest(Q_f, Q_r)


@formula(
    "n_b",
    "rule of this program: half of the bolts at each end; of an odd number, the end that has one less",
    shows="whole part of N_b/2",
)
def bolts_at_an_end(N_b: Number) -> Number:
    return float(N_b // 2)


@formula(
    "S_sep",
    names=LEAST,
    source=Text(
        "{turning}: it pulls the joint apart; resilience of bolt and parts left out, which is on the safe side",
        turning=TURNING,
    ),
)
def safety_separation(n: Number, F_min: Newton, Q: Newton) -> Number:
    return n * F_min / Q


@formula("S_across", Text("{turning}: it stands across the bolts; friction by Coulomb", turning=TURNING), names=LEAST)
def safety_across(mu_T: Number, n: Number, F_min: Newton, Q: Newton) -> Number:
    return mu_T * n * F_min / Q


@formula(
    "S_slip",
    names=LEAST,
    source=Text(
        "{turning}: its worst direction, that which pulls apart and pushes aside, Q·(cos θ + sin θ/μ_T) at its largest",
        turning=TURNING,
    ),
)
def safety_slip(n: Number, F_min: Newton, Q: Newton, mu_T: Number) -> Number:
    return n * F_min / (Q * sqrt(1 + 1 / mu_T**2))


@formula("M_G", Text("{vdi}: torque in the shank, that of the thread", vdi=VDI), unit="N·m", names={"rho": "ρ′"})
def thread_torque(F_V: Newton, d_2: Metre, alpha_h: Radian, rho: Radian) -> NewtonMetre:
    return F_V * d_2 / 2 * tan(alpha_h + rho)


@formula("d_0", Text("{vdi}: diameter of the stress area", vdi=VDI), unit="mm")
def stress_diameter(d_2: Metre, d_3: Metre) -> Metre:
    return (d_2 + d_3) / 2


@formula("τ_M", Text("{vdi}: torsion of the shank while it is tightened", vdi=VDI), unit="MPa")
def torsion_stress(M_G: NewtonMetre, d_0: Metre) -> Pascal:
    return 16 * M_G / (pi * d_0**3)


@formula("σ_red", Text("{vdi}: equivalent stress while it is tightened, von Mises", vdi=VDI), unit="MPa")
def tightening_stress(sigma_z: Pascal, tau_M: Pascal) -> Pascal:
    return sqrt(sigma_z**2 + 3 * tau_M**2)


# --- results


@result
class BoltsResult:
    """One bolt, and the joint.  The safeties are None where the shaft puts no force on its support."""

    bolt_preload: Newton = value("Preload of a bolt", "N", "F_V", short=True)
    bolt_preload_vdi: Newton = value("Preload by VDI 2230", "N", "F_V")
    bolt_preload_vdi_short: Newton = value("Preload by the short form of VDI 2230", "N", "F_V")
    bolt_preload_source: Newton = value("Preload by the source's formula", "N", "F_V")
    bolt_preload_min: Newton = value("Least preload, by the scatter of torque tightening", "N", "F_V,min")
    bolt_head_pressure: Pascal = value("Pressure under a bolt's head", "MPa", "p_h", short=True)
    bolt_tensile_stress: Pascal = value("Tensile stress of a bolt by its preload", "MPa", "σ_z")
    bolt_tightening_stress: Pascal = value(
        "Equivalent stress of a bolt while it is tightened", "MPa", "σ_red", short=True
    )
    bolt_end_force: Newton = value("Turning force on the bolts of one end", "N", "Q")
    bolt_separation_safety: Number | None = value("Safety against separation", "", "S_sep", default=None, short=True)
    bolt_slip_across_safety: Number | None = value(
        "Safety against slip, load across the bolts", "", "S_across", default=None, short=True
    )
    bolt_slip_safety: Number | None = value(
        "Safety against slip while the load turns", "", "S_slip", default=None, short=True
    )
    support: "Material | None"
    property_class: str


def solve(
    bolts: Bolts,
    F_S: PhasorNewton,
    C_S: PhasorNewtonMetre,
    bearing_positions: tuple[Metre, ...],
    support: "Material | None" = None,
) -> BoltsResult:
    """The bolts of the support of one shaft.  `F_S` and `C_S` are the turning force and the couple about mid-shaft that
    it puts on its bearings; `support` is the material under the heads, where it is known."""
    T, mu, d_w, d_h = bolts.torque, bolts.friction, bolts.head_diameter, bolts.hole_diameter
    with about(Text("bolts")):
        D, p = nominal_diameter(designation=bolts.thread), pitch(designation=bolts.thread)
    with about(Text("bolts, VDI 2230")):
        d_2 = pitch_diameter(D=D, p=p)
        alpha_h, rho = helix_angle(p=p, d_2=d_2), friction_angle(mu=mu)
        F_vdi = preload(T=T, d_2=d_2, alpha_h=alpha_h, rho=rho, mu=mu, r_h=friction_radius(d_w=d_w, d_h=d_h))
        F_short = preload_short(T=T, p=p, mu=mu, d_2=d_2, D_Km=mean_bearing_diameter(d_w=d_w, d_h=d_h))
    with about(Text("bolts, source")):
        d_2s, alpha_s = pitch_diameter_source(D=D, p=p), helix_angle_source(p=p, D=D)
        rho_s = friction_angle_source(mu=mu)
        F_source = preload(T=T, d_2=d_2s, alpha_h=alpha_s, rho=rho_s, mu=mu, r_h=friction_radius_source(d_w=d_w))
    F_V = F_source if bolts.method == "source" else F_vdi
    with about(Text("bolts")):
        F_min = least_preload(F_V=F_V, alpha_A=ALPHA_A)
        pressure = head_pressure(F_V=F_V, d_w=d_w, d_h=d_h)
        d_3 = root_diameter(D=D, p=p)
        sigma = tensile_stress(F_V=F_V, A_s=stress_area(d_2=d_2, d_3=d_3))
        M_G = thread_torque(F_V=F_V, d_2=d_2, alpha_h=alpha_h, rho=rho)
        tau_M = torsion_stress(M_G=M_G, d_0=stress_diameter(d_2=d_2, d_3=d_3))
        tightened = tightening_stress(sigma_z=sigma, tau_M=tau_M)
        z_f, z_r = bearing_positions[0], bearing_positions[-1]
        l_b = bearing_span(z_f=z_f, z_r=z_r) if bolts.row_span is None else bolts.row_span
        C_m = couple_about_middle(C_S=C_S, z_m=middle(z_f=z_f, z_r=z_r), F_S=F_S)
        Q = end_force(Q_f=force_front(F_S=F_S, C_m=C_m, l_b=l_b), Q_r=force_rear(F_S=F_S, C_m=C_m, l_b=l_b))
        separation = across = slip = None
        if Q > NO_FORCE:
            n = bolts_at_an_end(N_b=bolts.count)
            separation = safety_separation(n=n, F_min=F_min, Q=Q)
            across = safety_across(mu_T=bolts.joint_friction, n=n, F_min=F_min, Q=Q)
            slip = safety_slip(n=n, F_min=F_min, Q=Q, mu_T=bolts.joint_friction)
    return BoltsResult(
        bolt_preload=F_V,
        bolt_preload_vdi=F_vdi,
        bolt_preload_vdi_short=F_short,
        bolt_preload_source=F_source,
        bolt_preload_min=F_min,
        bolt_head_pressure=pressure,
        bolt_tensile_stress=sigma,
        bolt_end_force=Q,
        bolt_separation_safety=separation,
        bolt_slip_across_safety=across,
        bolt_slip_safety=slip,
        bolt_tightening_stress=tightened,
        support=support,
        property_class=bolts.property_class,
    )


def _strength(support: "Material | None") -> tuple[Pascal, str] | None:
    """The strength of the support and its name; None where none is known."""
    if support is None:
        return None
    if support.tensile_strength is not None:
        return support.tensile_strength, Text("tensile strength")
    return (support.proof_stress, Text("proof stress")) if support.proof_stress is not None else None


BOLT_KEYS = "countershaft", CountershaftInputs.bolts
TORQUE = dotted(*BOLT_KEYS, Bolts.torque)
JOINT = (TORQUE, dotted(*BOLT_KEYS, Bolts.count), dotted(*BOLT_KEYS, Bolts.row_span))
SLIP = CheckRule(
    "countershaft.bolts.slip",
    "limit",
    "The support slides on its block and works the bolts loose.",
    Text("Safety against slip of the support while the load turns"),
    source=Text("rule of this program: the least preload must still hold the joint"),
    advice=Text("More or larger bolts, a larger torque, or rows of bolts further apart."),
    role="physics",
    demand=True,
    value_id=dotted("countershaft", BoltsResult.bolt_slip_safety),
    moved_by=JOINT,
)
SEPARATION = CheckRule(
    "countershaft.bolts.separation",
    "limit",
    "The support lifts off its block.",
    Text("Safety against separation of the support"),
    source=SLIP.source,
    advice=SLIP.advice,
    role="physics",
    demand=True,
    value_id=dotted("countershaft", BoltsResult.bolt_separation_safety),
    moved_by=JOINT,
)
BOLT_STRENGTH = CheckRule(
    "countershaft.bolts.strength",
    "limit",
    "The bolt yields while it is tightened.",
    sense="<=",
    unit="MPa",
    source=Text("VDI 2230-1: it must not yield; Rp0.2 of ISO 898-1 (VDI usually counts on 90 % of it)"),
    advice=Text("A smaller torque, a larger thread, or a higher property class."),
    role="physics",
    demand=True,
    value_id=dotted("countershaft", BoltsResult.bolt_tightening_stress),
    moved_by=(TORQUE,),
    proven=(),
)
HEAD_PRESSURE = CheckRule(
    "countershaft.bolts.pressure",
    "caution",
    "The seat yields and preload is lost; the joint is judged by itself, and limiting pressures scatter by two.",
    Text("Pressure under a bolt's head"),
    "<=",
    "MPa",
    advice=Text("A hardened washer or a flanged head: the seat yields and the preload falls with it."),
    demand=True,
    value_id=dotted("countershaft", BoltsResult.bolt_head_pressure),
    moved_by=(
        dotted(*BOLT_KEYS, Bolts.head_diameter),
        TORQUE,
        dotted(*BOLT_KEYS, Bolts.hole_diameter),
    ),
    proven=(),
)


def checks(joint: BoltsResult) -> Iterator[Check]:
    """Slip and separation at the least preload, pressure at the largest."""
    for rule, safety in ((SLIP, joint.bolt_slip_safety), (SEPARATION, joint.bolt_separation_safety)):
        if safety is not None:
            yield rule(safety, 1.0)
    name = Text("Stress of a bolt of class {property_class} while it is tightened", property_class=joint.property_class)
    limit = STRENGTH[joint.property_class] * 1e6
    yield BOLT_STRENGTH(joint.bolt_tightening_stress, limit, name=name)
    if joint.support is not None and (known := _strength(joint.support)) is not None:
        limit, strength = known
        source = Text(
            "rule of this program: {known} of {name}; limiting pressures in VDI 2230-1 (2003) are 0.76 to 1.52 times "
            "the tensile strength of an aluminium, and more for cast iron",
            known=strength,
            name=joint.support.name,
        )
        yield HEAD_PRESSURE(joint.bolt_head_pressure, limit, source=source)


def notes(bolts: Bolts, joint: BoltsResult) -> Iterator[Text]:
    """What was assumed."""
    yield Text(
        "Bolts: slip and separation are judged at the least preload, F_V/{alpha_a}: a torque wrench with an estimated "
        "coefficient of friction scatters by 1.6 to 2.0 (VDI 2230-1). Give the smallest friction to be expected; F_V "
        "is then the largest preload.",
        alpha_a=Amount(ALPHA_A, form="g"),
    )
    yield Text(
        "Bolts: the support is rigid and its joint in line with the force; embedding, the shaft's height above the "
        "joint, its weight, the gear force, locating pins and the thread's engagement in the block are left out."
    )
    if bolts.row_span is None:
        yield Text(
            "Bolts: their rows are taken to stand as far apart as the outer bearings; give row_span_mm where they do "
            "not."
        )
    if bolts.count % 2:
        yield Text(
            "Bolts: of {count} bolts, the end with {count2} is judged.", count=bolts.count, count2=bolts.count // 2
        )
    if joint.bolt_slip_safety is None:
        yield Text("Bolts: the shaft puts no force on its support, so slip and separation are not judged.")
    if _strength(joint.support) is None:
        yield Text("Bolts: no strength of the support is known, so the pressure under the head is not judged.")
