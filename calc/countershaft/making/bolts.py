# SPDX-License-Identifier: Apache-2.0
"""The bolts that hold the shaft's support to the block: preload by torque, pressure under the head, slip and
separation.

The load turns with the shaft.  At each end of the support a force Q of constant size sweeps through all directions: it
pulls the joint apart, presses it together and pushes it to either side within one turn.  Of several shafts in one
support the forces of those that turn alike add as vectors.  Those that turn both ways, with Q⁺ and Q⁻, run along an
ellipse, whose longer half-axis is Q⁺ + Q⁻: of a shaft and its mirror image the vertical parts add and the sideways ones
cancel.  What of it pulls the joint apart and what pushes it aside depends on how the bolts point; where that is not
given, the longer half-axis is swept through all directions.  Of two orders the largest forces are added, a bound.  The
joint holds by friction alone; locating pins, where there are any, are left out."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ...sheet.check import Check, CheckRule, Missing
from ...sheet.formula import formula
from ...sheet.functions import atan, cis, conj, cos, joined, largest, modulus, pi, sqrt, tan
from ...sheet.quantity import dotted, result, value
from ...sheet.record import record, replace
from ...sheet.shown import Shown
from ...sheet.text import EMPTY, Amount, Name, Text, listed
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
from ...sheet.value import about, based_on, untraced
from ..inputs import ShaftInputs
from ..rows import SHAFT
from ..sums import SystemShaft
from .inputs import (
    FLANGE,
    FLANGES,
    HEXAGONS,
    PLAIN,
    PLAINEST,
    STRENGTH,
    Bolts,
    FurtherBolts,
    nominal_diameter,
    pitch,
    pitch_diameter,
    root_diameter,
    stress_area,
)

if TYPE_CHECKING:
    from ...library.catalogue import Material

# VDI 2230-1: α_A = 1.6 to 2.0 for a torque wrench and an estimated coefficient of friction.  Nothing is known of the
# wrench, so the unfavourable end is taken.
ALPHA_A = 2.0
# VDI 2230-1, R12: safety against slip where the load stands still, and where it comes from alternate sides
HOLDS_STANDING, HOLDS_TURNING = 1.2, 1.8
NO_FORCE = 1e-6  # N: below it the shaft puts no force on its support

VDI = Text("VDI 2230-1")
SOURCE = Text("Finotti 2013, Table 6.1")
TURNING = Text("statics of a joint whose load turns through all directions")
LEAST = {"F_min": "F_V,min", "n": "n_b"}


# --- the face under the head


@formula(
    "d_w",
    "rule of this program: face of a flanged head, by DIN 6921",
    unit="mm",
    names={"share": "d_w/D"},
    meanings={"share": "Face of the head over the thread's diameter"},
)
def flanged_face(share: Number, D: Metre) -> Metre:
    return share * D


@formula("d_w", "rule of this program: face of a plain hexagon head, by ISO 4017", unit="mm", names={"share": "d_w/s"})
def plain_face(share: Number, s: Metre) -> Metre:
    return share * s


@record
class Face:
    """The face under the head: as given, or as assumed with the smallest and the largest that it may be, and what was
    taken."""

    taken: Metre
    least: Metre | None = None
    most: Metre | None = None
    words: Text = EMPTY


def face(bolts: Bolts, D: Metre) -> Face:
    """A width across flats below that of a plain hexagon on this thread is that of a flanged head."""
    if bolts.head_diameter is not None:
        return Face(bolts.head_diameter)
    s = bolts.across_flats
    assert s is not None
    across, size = Amount(s * 1e3, "mm", form="g"), bolts.thread
    with about(Text("bolts, largest face")):
        most = flanged_face(share=FLANGES[1], D=D)
    if bolts.flanged:
        with about(Text("bolts, face")):
            taken = flanged_face(share=FLANGE, D=D)
        with about(Text("bolts, smallest face")):
            least = flanged_face(share=FLANGES[0], D=D)
        words = Text(
            "a flanged head with a face of {face}, since {across} across flats is below the {plain} mm of a plain "
            "hexagon on {thread}",
            face=Amount(taken * 1e3, "mm", form="g"),
            across=across,
            plain=Amount(HEXAGONS[round(D * 1e3, 6)], form="g"),
            thread=size,
        )
        return Face(taken, least, most, words)
    with about(Text("bolts, face")):
        taken = plain_face(share=PLAIN, s=s)
    with about(Text("bolts, smallest face")):
        least = plain_face(share=PLAINEST, s=s)
    words = Text(
        "a plain hexagon head of {across} across flats with a face of {face}; a flanged one has up to {most}",
        across=across,
        face=Amount(taken * 1e3, "mm", form=".3g"),
        most=Amount(most * 1e3, "mm", form="g"),
    )
    return Face(taken, least, most, words)


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
def preload(T: NewtonMetre, d_2: Metre, alpha_h: Radian, rho: Radian, mu_K: Number, r_h: Metre) -> Newton:
    """`rho` is the angle of friction on the flanks, `mu_K` the coefficient under the head.

    >>> preload(T=45, d_2=0.009026, alpha_h=0.05285, rho=0.1377, mu_K=0.12, r_h=0.0065)
    27264.23...
    """
    return T / (d_2 / 2 * tan(alpha_h + rho) + mu_K * r_h)


@formula("F_V", Text("{vdi}: short form, for small angles", vdi=VDI), names={"T": "M_A", "p": "P_h"})
def preload_short(T: NewtonMetre, p: Metre, mu: Number, d_2: Metre, mu_K: Number, D_Km: Metre) -> Newton:
    return T / (0.159 * p + 0.578 * mu * d_2 + mu_K * D_Km / 2)


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


@formula("r_h", Text("{source}: friction of the head at half of its width across flats", source=SOURCE), unit="mm")
def friction_radius_source(s: Metre) -> Metre:
    return s / 2


@formula(
    "F_V,min",
    Text(
        "{vdi}: least preload; tightening factor of a torque wrench with an estimated coefficient of friction, 1.6 to "
        "2.0",
        vdi=VDI,
    ),
    meanings={"alpha_A": "Tightening factor"},
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


@formula(
    "C_m",
    "statics: couple moved to the middle of the bolts",
    meanings={"C_S": "Couple of the shaft", "F_S": "Force of the shaft"},
)
def couple_about_middle(C_S: PhasorNewtonMetre, z_m: Metre, F_S: PhasorNewton) -> PhasorNewtonMetre:
    return C_S - z_m * F_S


@formula(
    "Q_f",
    "statics of a rigid support: force and couple of the shaft shared by the front and rear bolts",
    meanings={"F_S": "Force of the shaft"},
)
def force_front(F_S: PhasorNewton, C_m: PhasorNewtonMetre, l_b: Metre) -> Newton:
    return modulus(F_S / 2 - C_m / l_b)


@formula(
    "Q_r",
    "statics of a rigid support: force and couple of the shaft shared by the front and rear bolts",
    meanings={"F_S": "Force of the shaft"},
)
def force_rear(F_S: PhasorNewton, C_m: PhasorNewtonMetre, l_b: Metre) -> Newton:
    return modulus(F_S / 2 + C_m / l_b)


@formula("Q", "mathematics: the end that carries more")
def end_force(Q_f: Newton, Q_r: Newton) -> Newton:
    return largest(Q_f, Q_r)


@formula("F_S", "statics: forces of shafts that turn alike, on one support", names={"F_1": "F_S1", "F_2": "F_S2"})
def forces_alike(F_1: PhasorNewton, F_2: PhasorNewton) -> PhasorNewton:
    return joined(F_1, F_2)


@formula("C_S", "statics: couples of shafts that turn alike, on one support", names={"C_1": "C_S1", "C_2": "C_S2"})
def couples_alike(C_1: PhasorNewtonMetre, C_2: PhasorNewtonMetre) -> PhasorNewtonMetre:
    return joined(C_1, C_2)


MET = Text("mathematics: largest sum over a turn of forces that turn at unlike speeds")


@formula("Q_i", Text("{met}; of one speed both ways the longer half-axis of their ellipse, else a bound", met=MET))
def forces_met(Q_1: Newton, Q_2: Newton) -> Newton:
    return joined(Q_1, Q_2)


ALONG = Text("geometry: the part in one direction of what turns with the crank and against it, as a phasor")


@formula("F_β", ALONG, names={"F_f": "F_S⁺", "F_b": "F_S⁻", "beta": "β"})
def force_along(F_f: PhasorNewton, F_b: PhasorNewton, beta: Radian) -> PhasorNewton:
    """`beta` from up, in the sense of crank rotation.

    >>> force_along(F_f=100 + 0j, F_b=100 + 0j, beta=0.0)
    (200+0j)
    """
    return F_f * cis(-beta) + conj(F_b) * cis(beta)


@formula("C_β", ALONG, names={"C_f": "C_S⁺", "C_b": "C_S⁻", "beta": "β"})
def couple_along(C_f: PhasorNewtonMetre, C_b: PhasorNewtonMetre, beta: Radian) -> PhasorNewtonMetre:
    return C_f * cis(-beta) + conj(C_b) * cis(beta)


@formula("ρ_T", "statics: off the bolts, the direction in which a force makes the joint slip soonest")
def worst_angle(mu_T: Number) -> Radian:
    return atan(1 / mu_T)


@formula("Q", "mathematics: the side to which more acts")
def worse_side(Q_1: Newton, Q_2: Newton) -> Newton:
    return largest(Q_1, Q_2)


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
class BoltsResult(Shown):
    """One bolt, and the joint.  The safeties are None where nothing puts a force on it."""

    bolt_head_face: Metre | None = value("Face under a bolt's head, diameter assumed", "mm", "d_w", default=None)
    bolt_preload: Newton = value("Preload of a bolt", "N", "F_V", short=True)
    bolt_preload_vdi: Newton = value("Preload by VDI 2230", "N", "F_V")
    bolt_preload_vdi_short: Newton = value("Preload by the short form of VDI 2230", "N", "F_V")
    bolt_preload_source: Newton = value("Preload by the source's formula", "N", "F_V")
    bolt_preload_min: Newton = value("Least preload, by the scatter of torque tightening", "N", "F_V,min")
    bolt_head_pressure: Pascal = value("Pressure under a bolt's head", "MPa", "p_h", short=True)
    bolt_head_pressure_least: Pascal | None = value(
        "Pressure under a bolt's head, largest face that it may have", "MPa", "p_h", default=None
    )
    bolt_head_pressure_most: Pascal | None = value(
        "Pressure under a bolt's head, smallest face that it may have", "MPa", "p_h", default=None
    )
    bolt_tensile_stress: Pascal = value("Tensile stress of a bolt by its preload", "MPa", "σ_z")
    bolt_tightening_stress: Pascal = value(
        "Equivalent stress of a bolt while it is tightened", "MPa", "σ_red", short=True
    )
    bolt_end_force: Newton | None = value("Turning force on the bolts of one end", "N", "Q", default=None)
    bolt_separation_safety: Number | None = value("Safety against separation", "", "S_sep", default=None, short=True)
    bolt_slip_across_safety: Number | None = value(
        "Safety against slip, load across the bolts", "", "S_across", default=None, short=True
    )
    bolt_slip_safety: Number | None = value(
        "Safety against slip while the load turns", "", "S_slip", default=None, short=True
    )
    support: "Material | None"
    property_class: str
    face: Face
    carries: tuple[str, ...] | None  # as it is given
    best: "BoltsResult | None" = None  # the same with the bolts as they point best, where nobody says how they do


Vectors = tuple[PhasorNewton, PhasorNewtonMetre]
EACH_DEGREE: Any = np.radians(np.arange(180.0))  # Any: where formulas take one direction


def on_bearings(name: str, ratio: Number, positions: tuple[Metre, ...], reactions: Sequence[complex]) -> SystemShaft:
    """A shaft with the turning force, and the couple about mid-shaft, that it puts on its bearings; of a shaft that
    bends they are more than its own.  `reactions` of the supports on it, cylinder 1 at TDC."""
    F = based_on(-sum(reactions), *reactions)
    C = based_on(-sum(z * R for z, R in zip(positions, reactions)), *reactions)
    return SystemShaft(name, ratio, F, C)


def held(
    bolts: Bolts, tight: BoltsResult, shafts: Sequence[SystemShaft], bearing_positions: tuple[Metre, ...]
) -> BoltsResult:
    """The bolts of one support, as they are tightened, under what its `shafts` put on their bearings; the positions are
    those of the shaft that they stand at."""
    with about(Text("bolts")):
        z_f, z_r = bearing_positions[0], bearing_positions[-1]
        l_b = bearing_span(z_f=z_f, z_r=z_r) if bolts.row_span is None else bolts.row_span
        joint = _Joint(z_m=middle(z_f=z_f, z_r=z_r), l_b=l_b, turning=_alike(shafts))
        Q = joint.end_force(joint.turning.values())
        tight = replace(tight, bolt_end_force=Q)
        if Q <= NO_FORCE:
            return tight
        if not any(-ratio in joint.turning for ratio in joint.turning):  # its force is the same in all directions
            return _safeties(bolts, tight, Q, Q, Q)
        if bolts.direction is not None:
            return _safeties(bolts, tight, *joint.felt(bolts.direction, bolts.joint_friction))
        with untraced():
            best = _safeties(bolts, tight, *map(np.min, joint.felt(EACH_DEGREE, bolts.joint_friction)))
        return replace(_safeties(bolts, tight, Q, Q, Q), best=best)


def _alike(shafts: Sequence[SystemShaft]) -> dict[Number, Vectors]:
    """Force and couple of the shafts that turn alike, together, by their ratio."""
    turning: dict[Number, Vectors] = {}
    for shaft in sorted(shafts, key=lambda shaft: shaft.ratio):
        F, C = shaft.force, shaft.couple
        if shaft.ratio in turning:
            F_1, C_1 = turning[shaft.ratio]
            F, C = forces_alike(F_1=F_1, F_2=F), couples_alike(C_1=C_1, C_2=C)
        turning[shaft.ratio] = F, C
    return turning


@record
class _Joint:
    """The joint under what turns on it, by the ratio at which it turns."""

    z_m: Metre
    l_b: Metre
    turning: Mapping[Number, Vectors]

    def end_force(self, vectors: Iterable[Vectors]) -> Newton:
        """On the bolts of the end that carries more, where all vectors are at their largest."""
        ends = []
        for F, C in vectors:
            C_m = couple_about_middle(C_S=C, z_m=self.z_m, F_S=F)
            ends.append((force_front(F_S=F, C_m=C_m, l_b=self.l_b), force_rear(F_S=F, C_m=C_m, l_b=self.l_b)))
        (Q_f, Q_r), *others = ends
        for more_f, more_r in others:
            Q_f, Q_r = forces_met(Q_1=Q_f, Q_2=more_f), forces_met(Q_1=Q_r, Q_2=more_r)
        return end_force(Q_f=Q_f, Q_r=Q_r)

    def along(self, beta: Radian) -> Newton:
        """The same of what acts in one direction."""
        vectors = []
        for n in sorted({abs(ratio) for ratio in self.turning}):
            (F_f, C_f), (F_b, C_b) = (self.turning.get(sense * n, (0j, 0j)) for sense in (1, -1))
            vectors.append((force_along(F_f=F_f, F_b=F_b, beta=beta), couple_along(C_f=C_f, C_b=C_b, beta=beta)))
        return self.end_force(vectors)

    def felt(self, beta: Radian, mu_T: Number) -> tuple[Newton, Newton, Newton]:
        """Along bolts of this direction, across them, and in the worse of the two directions that pull apart and push
        aside."""
        rho = worst_angle(mu_T=mu_T)
        with about(Text("bolts, along them")):
            normal = self.along(beta)
        with about(Text("bolts, across them")):
            across = self.along(based_on(beta + pi / 2, beta))
        with about(Text("bolts, to one side of them")):
            one = self.along(based_on(beta + rho, beta, rho))
        with about(Text("bolts, to the other side of them")):
            other = self.along(based_on(beta - rho, beta, rho))
        return normal, across, worse_side(Q_1=one, Q_2=other)


def _safeties(bolts: Bolts, tight: BoltsResult, normal: Newton, across: Newton, aslant: Newton) -> BoltsResult:
    """Against what acts along the bolts, across them, and in the worst direction between; none where nothing acts."""
    n, F_min, mu_T = bolts_at_an_end(N_b=bolts.count), tight.bolt_preload_min, bolts.joint_friction
    separation = across_ = slip = None
    if normal > NO_FORCE:
        separation = safety_separation(n=n, F_min=F_min, Q=normal)
    if across > NO_FORCE:
        across_ = safety_across(mu_T=mu_T, n=n, F_min=F_min, Q=across)
    if aslant > NO_FORCE:
        slip = safety_slip(n=n, F_min=F_min, Q=aslant, mu_T=mu_T)
    return replace(tight, bolt_separation_safety=separation, bolt_slip_across_safety=across_, bolt_slip_safety=slip)


def solve_further(bolts: FurtherBolts, part: "Material | None" = None) -> BoltsResult:
    """Bolts beside those of the support, as those of a wheel's: all together hold the force across their joint."""
    with about(Text("bolts {name}", name=Name(bolts.name))):
        tight = tightened(bolts, part)
        if bolts.force is None or bolts.force <= NO_FORCE:
            return tight
        n = based_on(float(bolts.count), bolts.count)
        across = safety_across(mu_T=bolts.joint_friction, n=n, F_min=tight.bolt_preload_min, Q=bolts.force)
        return replace(tight, bolt_slip_across_safety=across)


def tightened(bolts: Bolts, support: "Material | None") -> BoltsResult:
    """One bolt without any load but its own."""
    T, mu, d_h = bolts.torque, bolts.friction, bolts.hole_diameter
    mu_K = mu if bolts.head_friction is None else bolts.head_friction
    with about(Text("bolts")):
        D, p = nominal_diameter(designation=bolts.thread), pitch(designation=bolts.thread)
    under = face(bolts, D)
    d_w = under.taken
    with about(Text("bolts, VDI 2230")):
        d_2 = pitch_diameter(D=D, p=p)
        alpha_h, rho = helix_angle(p=p, d_2=d_2), friction_angle(mu=mu)
        F_vdi = preload(T=T, d_2=d_2, alpha_h=alpha_h, rho=rho, mu_K=mu_K, r_h=friction_radius(d_w=d_w, d_h=d_h))
        D_Km = mean_bearing_diameter(d_w=d_w, d_h=d_h)
        F_short = preload_short(T=T, p=p, mu=mu, d_2=d_2, mu_K=mu_K, D_Km=D_Km)
    with about(Text("bolts, source")):
        d_2s, alpha_s = pitch_diameter_source(D=D, p=p), helix_angle_source(p=p, D=D)
        rho_s = friction_angle_source(mu=mu)
        r_s = friction_radius_source(s=d_w if bolts.across_flats is None else bolts.across_flats)
        F_source = preload(T=T, d_2=d_2s, alpha_h=alpha_s, rho=rho_s, mu_K=mu_K, r_h=r_s)
    F_V = F_source if bolts.method == "source" else F_vdi

    def pressure_on(d_w: Metre | None) -> Pascal | None:
        """Under a face of another size, which rubs at another radius."""
        if d_w is None:
            return None
        r_h = friction_radius(d_w=d_w, d_h=d_h)
        F = F_V if bolts.method == "source" else preload(T=T, d_2=d_2, alpha_h=alpha_h, rho=rho, mu_K=mu_K, r_h=r_h)
        return head_pressure(F_V=F, d_w=d_w, d_h=d_h)

    with about(Text("bolts, largest face")):
        lightly = pressure_on(under.most)
    with about(Text("bolts, smallest face")):
        heavily = pressure_on(under.least)
    with about(Text("bolts")):
        F_min = least_preload(F_V=F_V, alpha_A=ALPHA_A)
        pressure = head_pressure(F_V=F_V, d_w=d_w, d_h=d_h)
        d_3 = root_diameter(D=D, p=p)
        sigma = tensile_stress(F_V=F_V, A_s=stress_area(d_2=d_2, d_3=d_3))
        M_G = thread_torque(F_V=F_V, d_2=d_2, alpha_h=alpha_h, rho=rho)
        tau_M = torsion_stress(M_G=M_G, d_0=stress_diameter(d_2=d_2, d_3=d_3))
        tightened = tightening_stress(sigma_z=sigma, tau_M=tau_M)
    return BoltsResult(
        bolt_head_face=None if under.least is None else d_w,
        bolt_preload=F_V,
        bolt_preload_vdi=F_vdi,
        bolt_preload_vdi_short=F_short,
        bolt_preload_source=F_source,
        bolt_preload_min=F_min,
        bolt_head_pressure=pressure,
        bolt_head_pressure_least=lightly,
        bolt_head_pressure_most=heavily,
        bolt_tensile_stress=sigma,
        bolt_tightening_stress=tightened,
        support=support,
        property_class=bolts.property_class,
        face=under,
        carries=bolts.carries,
    )


def _strength(support: "Material | None") -> tuple[Pascal, str] | None:
    """The strength of the support and its name; None where none is known."""
    if support is None:
        return None
    if support.tensile_strength is not None:
        return support.tensile_strength, Text("tensile strength")
    return (support.proof_stress, Text("proof stress")) if support.proof_stress is not None else None


BOLT_KEYS = SHAFT, ShaftInputs.bolts
TORQUE = dotted(*BOLT_KEYS, Bolts.torque)
HEAD = dotted(*BOLT_KEYS, Bolts.head_diameter)
SPAN = dotted(*BOLT_KEYS, Bolts.row_span)
DIRECTION = dotted(*BOLT_KEYS, Bolts.direction)
WORST = Text("bolts that point where the joint holds worst")
JOINT = (TORQUE, dotted(*BOLT_KEYS, Bolts.count), SPAN)
SLIP = CheckRule(
    "countershaft.J.slip",
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
SLIP_VDI = CheckRule(
    "countershaft.J.slip_vdi",
    "caution",
    "Below it the joint may work under a load that turns; it slips at 1, which is the limit.",
    Text("Safety against slip while the load turns, as VDI 2230 asks for"),
    source=Text("VDI 2230-1, R12, from memory: 1.8 where the load comes from alternate sides, 1.2 where it stands"),
    advice=Text(
        "More or larger bolts, a larger torque, or rows of bolts further apart; or more friction of the joint, where "
        "it is known."
    ),
    demand=True,
    cause="countershaft.J.slip",
    value_id=dotted("countershaft", BoltsResult.bolt_slip_safety),
    moved_by=JOINT,
)
SEPARATION = CheckRule(
    "countershaft.J.separation",
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
    "countershaft.J.strength",
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
    "countershaft.J.pressure",
    "caution",
    "The seat yields and preload is lost; the joint is judged by itself, and limiting pressures scatter by two.",
    Text("Pressure under a bolt's head"),
    "<=",
    "MPa",
    advice=Text("A hardened washer or a flanged head: the seat yields and the preload falls with it."),
    demand=True,
    value_id=dotted("countershaft", BoltsResult.bolt_head_pressure),
    moved_by=(
        HEAD,
        TORQUE,
        dotted(*BOLT_KEYS, Bolts.hole_diameter),
    ),
)


def checks(joint: BoltsResult) -> Iterator[Check]:
    """Slip and separation at the least preload, pressure at the largest."""
    best = joint.best
    slip, separation = joint.bolt_slip_safety, joint.bolt_separation_safety
    for rule, safety, at_best, least in (
        (SLIP, slip, best and best.bolt_slip_safety, 1.0),
        (SLIP_VDI, slip, best and best.bolt_slip_safety, HOLDS_TURNING),
        (SEPARATION, separation, best and best.bolt_separation_safety, 1.0),
    ):
        if safety is not None:
            unknown = None if best is None else Missing((DIRECTION,), (WORST,), at_best or "holds", safety)
            yield rule(safety, least, at="bolts", missing=unknown)
    yield from _tightened_checks(joint, "bolts")


def further_checks(bolts: FurtherBolts, joint: BoltsResult) -> Iterator[Check]:
    """The same of bolts beside those of the support, whose load stands across the joint or turns."""
    at = dotted(ShaftInputs.further_bolts, bolts.name)
    key, id = dotted(SHAFT, at), dotted("countershaft", at)
    found = list(_tightened_checks(joint, at))
    if (safety := joint.bolt_slip_across_safety) is not None:
        least = HOLDS_TURNING if bolts.turns == "yes" else HOLDS_STANDING
        what = Text("Safety against slip of the joint")
        asked = Text("Safety against slip of the joint, as VDI 2230 asks for")
        found += [SLIP(safety, 1.0, at=at, name=what), SLIP_VDI(safety, least, at=at, name=asked)]
    across = dotted("countershaft", BoltsResult.bolt_slip_across_safety)
    for check in found:
        value = across if check.rule in (SLIP, SLIP_VDI) else check.value_id
        yield replace(
            check,
            name=Text("{what}, {bolts}", what=check.name, bolts=Name(bolts.name)),
            value_id=value.replace("countershaft", id),
            moved_by=tuple([m.replace(dotted(*BOLT_KEYS), key) for m in check.moved_by if m != SPAN]),
        )


def _tightened_checks(joint: BoltsResult, at: str) -> Iterator[Check]:
    name = Text("Stress of a bolt of class {property_class} while it is tightened", property_class=joint.property_class)
    limit = STRENGTH[joint.property_class] * 1e6
    yield BOLT_STRENGTH(joint.bolt_tightening_stress, limit, at=at, name=name)
    if joint.support is not None and (known := _strength(joint.support)) is not None:
        limit, strength = known
        source = Text(
            "rule of this program: {known} of {name}; limiting pressures in VDI 2230-1 (2003) are 0.76 to 1.52 times "
            "the tensile strength of an aluminium, and more for cast iron",
            known=strength,
            name=joint.support.name,
        )
        unknown = None
        if joint.face.least is not None:
            best, worst = joint.bolt_head_pressure_least, joint.bolt_head_pressure_most
            assert best is not None and worst is not None
            unknown = Missing((HEAD,), (joint.face.words,), best, worst)
        yield HEAD_PRESSURE(joint.bolt_head_pressure, limit, at=at, source=source, missing=unknown)


def notes(bolts: Bolts, joint: BoltsResult, shafts: Sequence[SystemShaft] = ()) -> Iterator[Text]:
    """What was assumed; `shafts`: all that they hold, where there are several."""
    if len(shafts) > 1:
        yield Text(
            "Bolts: they hold {names} together. The forces of those that turn alike add as vectors, those of one speed "
            "both ways as they meet, those of two orders at their largest, which is a bound. What they raise about an "
            "axis along the shafts is left out.",
            names=listed(Name(shaft.name) for shaft in shafts),
        )
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
    yield from face_notes(joint)
    if bolts.row_span is None:
        yield Text(
            "Bolts: their rows are taken to stand as far apart as the outer bearings; give the distance of the "
            "bolt rows along the shaft where they do not."
        )
    if bolts.count % 2:
        yield Text(
            "Bolts: of {count} bolts, the end with {count2} is judged.", count=bolts.count, count2=bolts.count // 2
        )
    if joint.bolt_slip_safety is None:
        yield Text("Bolts: the shaft puts no force on its support, so slip and separation are not judged.")
    if _strength(joint.support) is None:
        yield Text("Bolts: no strength of the support is known, so the pressure under the head is not judged.")


def face_notes(joint: BoltsResult) -> Iterator[Text]:
    """What was taken for the face under the head, where no check of the pressure says it."""
    if joint.face.least is not None and _strength(joint.support) is None:
        yield Text(
            "Bolts: the face under the head is assumed: {words}. Give the bearing diameter of the head, of "
            "flange or washer.",
            words=joint.face.words,
        )
