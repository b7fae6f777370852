# SPDX-License-Identifier: Apache-2.0
"""Where the wheels stand, how their teeth come together, and what loads their axes: one function per equation.

A point is a complex number: its real part up from the crank's axis, its imaginary part 90° further in the sense of
crank rotation; directions and angles of teeth are counted from up in that sense.  1 is the driver, 2 the driven wheel
of a mesh."""

import math

from ...sheet.formula import formula
from ...sheet.functions import argument, cis, conj, cos, imag, joined, modulus, pi, resultant, sqrt, tan
from ...sheet.text import Text
from ...sheet.units import (
    Metre,
    Newton,
    NewtonMetre,
    Newtons,
    Number,
    PhasorMetre,
    PhasorNewton,
    PhasorNewtonMetre,
    Radian,
)
from ..formulas import ISO

PLANE = Text("geometry in the plane")
TEETH = Text("geometry of meshing involute teeth")
NUMBERS = Text("mathematics of whole tooth numbers")
STATICS = Text("statics, equilibrium of a wheel")
ROOM = Text("geometry, room around a turning wheel, worst case")


# --- positions


@formula(
    "a_13",
    Text("{plane}: distance of two axes", plane=PLANE),
    unit="mm",
    meanings={"p_1": "Place of the first centre", "p_3": "Place of the third centre"},
)
def axes_apart(p_1: PhasorMetre, p_3: PhasorMetre) -> Metre:
    return modulus(p_3 - p_1)


@formula(
    "γ",
    Text("{plane}: direction of the line of centres, from up in the sense of crank rotation", plane=PLANE),
    meanings={"p_1": "Place of the first centre"},
)
def line_of_centres(p_1: PhasorMetre, p_3: PhasorMetre) -> Radian:
    return argument(p_3 - p_1)


@formula("l_u", Text("{plane}, two circles: foot of their common chord on the line of centres", plane=PLANE), unit="mm")
def chord_foot(c: Metre, a_12: Metre, a_23: Metre) -> Metre:
    return (c**2 + a_12**2 - a_23**2) / (2 * c)


@formula("l_v", Text("{plane}, two circles: half their common chord", plane=PLANE), unit="mm", names={"u": "l_u"})
def half_chord(a_12: Metre, u: Metre) -> Metre:
    return sqrt(a_12**2 - u**2)


@formula(
    "p_2",
    Text("{plane}, two circles: s = +1 is the point further in the sense of crank rotation, −1 the other", plane=PLANE),
    unit="mm",
    names={"u": "l_u", "v": "l_v"},
    meanings={"s": "Side of the line of centres, 1 or −1"},
)
def on_two_circles(p_1: PhasorMetre, gamma: Radian, u: Metre, v: Metre, s: Number) -> PhasorMetre:
    return p_1 + u * cis(gamma) + s * v * cis(gamma + pi / 2)


@formula(
    "p_2",
    Text(
        "{plane}: the circles only touch, or miss each other within the tolerance: the foot on the line of centres",
        plane=PLANE,
    ),
    unit="mm",
    names={"u": "l_u"},
)
def on_line(p_1: PhasorMetre, gamma: Radian, u: Metre) -> PhasorMetre:
    return p_1 + u * cis(gamma)


@formula("p_2", Text("{plane}: a point of a circle, in a direction that is free", plane=PLANE), unit="mm")
def on_circle(p_1: PhasorMetre, a_12: Metre, phi: Radian) -> PhasorMetre:
    return p_1 + a_12 * cis(phi)


@formula("p_up", Text("{plane}: its part that points up", plane=PLANE), unit="mm", shows="Re p")
def up(p: PhasorMetre) -> Metre:
    return p.real


@formula(
    "p_side",
    Text("{plane}: its part 90° further in the sense of crank rotation", plane=PLANE),
    unit="mm",
    names={"p": "p_i"},
    meanings={"p": "Place of the centre"},
)
def side(p: PhasorMetre) -> Metre:
    return imag(p)


@formula(
    "δ_a",
    Text("{plane}: how far the distance of two axes is from the working centre distance", plane=PLANE),
    unit="µm",
    names={"c": "a_13"},
)
def distance_error(c: Metre, a_w: Metre) -> Metre:
    return modulus(c - a_w)


@formula(
    "φ",
    Text("{plane}: angle between the lines of centres to the neighbours on both sides", plane=PLANE),
    meanings={"p_1": "Place of the first centre"},
)
def included_angle(p_1: PhasorMetre, p_2: PhasorMetre, p_3: PhasorMetre) -> Radian:
    return modulus(argument((p_3 - p_2) * conj(p_1 - p_2)))


# --- clearances


@formula(
    "r_s",
    Text("{room}: tip with its upper deviation, half the runout, tolerance of the axis", room=ROOM),
    unit="mm",
    meanings={
        "F_r": "Runout of the teeth",
        "T_a": "Tolerance of the centre distance (±)",
        "E_da": "Upper deviation of the tip diameter",
    },
)
def swept_radius(d_a: Metre, E_da: Metre, F_r: Metre, T_a: Metre) -> Metre:
    return d_a / 2 + E_da / 2 + F_r / 2 + T_a


@formula(
    "l_w",
    Text("{plane}: distance of a point from a straight wall of finite length", plane=PLANE),
    unit="mm",
    shows="least distance of p from w_1 w_2",
)
def wall_distance(p: PhasorMetre, w_1: PhasorMetre, w_2: PhasorMetre) -> Metre:
    along = (p - w_1) * (w_2 - w_1).conjugate()
    share = min(max(along.real / abs(w_2 - w_1) ** 2, 0.0), 1.0)
    return abs(p - w_1 - share * (w_2 - w_1))


@formula("g", Text("{room}: to a wall", room=ROOM), unit="mm", names={"h": "l_w"})
def wall_clearance(h: Metre, r_s: Metre) -> Metre:
    return h - r_s


@formula("g", Text("{room}: to something round of radius r", room=ROOM), unit="mm", names={"c": "a_13"})
def round_clearance(c: Metre, r_s: Metre, r: Metre) -> Metre:
    return c - r_s - r


@formula(
    "g_J",
    "geometry, shaft inserted axially: seat of the journal over the largest tip circle of the wheel, diametral",
    unit="mm",
)
def insertion_gap(d_J: Metre, d_a: Metre, E_da: Metre) -> Metre:
    return d_J - d_a - E_da


# --- which teeth meet


@formula(
    "g_z",
    Text("{numbers}: a common factor of two wheels in mesh; 1: every tooth meets every tooth", numbers=NUMBERS),
    shows="gcd(z_1, z_2)",
)
def common_factor(z_1: Number, z_2: Number) -> Number:
    """>>> common_factor(z_1=25, z_2=36)
    1.0
    """
    return float(math.gcd(int(z_1), int(z_2)))


@formula(
    "N_m", Text("{numbers}: turns of the driver until the same teeth meet again, lcm(z_1, z_2)/z_1", numbers=NUMBERS)
)
def turns_to_repeat(z_2: Number, g_z: Number) -> Number:
    return z_2 / g_z


@formula(
    "N_M",
    Text("{numbers}: turns of the first driver until the marks of all wheels meet again", numbers=NUMBERS),
    shows="smallest N for which N·z_1/z is a whole number for every wheel",
)
def marks_period(z_1: Number, z: tuple[int, ...]) -> Number:
    return float(math.lcm(*(teeth // math.gcd(int(z_1), teeth) for teeth in z)))


# --- assembly phase


@formula("τ", "geometry, angular pitch: the step in which a wheel can be meshed anew")
def angular_pitch(z: Number) -> Radian:
    return 2 * pi / z


@formula(
    "θ_2",
    Text(
        "{teeth}: z_1·(θ_1 − γ) + z_2·(θ_2 − γ − π) = π, a tooth of one wheel in a space of the other; θ_2 is one of "
        "its teeth",
        teeth=TEETH,
    ),
)
def meshing_tooth(theta_1: Radian, gamma: Radian, z_1: Number, z_2: Number) -> Radian:
    return gamma + pi + (pi - z_1 * (theta_1 - gamma)) / z_2


@formula(
    "δ_E",
    Text("{teeth}: from a direction to the middle of the nearest tooth, within half a pitch", teeth=TEETH),
    shows="θ − ψ, less its whole pitches τ",
)
def nearest_tooth(theta: Radian, psi: Radian, tau: Radian) -> Radian:
    """Midway between two teeth: the one further in the sense of crank rotation; 1e-9 of a pitch keeps dust from
    deciding that."""
    pitches = (theta - psi) / tau
    return (pitches - math.ceil(pitches - 0.5 - 1e-9)) * tau


@formula(
    "θ_z",
    Text("{teeth}: middle of the tooth that is nearest to a direction", teeth=TEETH),
    names={"delta": "δ_E"},
    meanings={"psi": "Direction from which the tooth is sought"},
)
def tooth_one(psi: Radian, delta: Radian) -> Radian:
    return psi + delta


@formula(
    "ε_z", "geometry: error of phase, where a tooth is set on the axis of the eccentric instead", names={"delta": "δ_E"}
)
def error_of_tooth(delta: Radian) -> Radian:
    return modulus(delta)


@formula(
    "ε_s",
    "geometry: error of phase, where the middle of a space is set on the axis of the eccentric instead",
    names={"delta": "δ_E"},
)
def error_of_space(tau: Radian, delta: Radian) -> Radian:
    return tau / 2 - modulus(delta)


# --- forces


@formula("F_tw", Text("{iso}: tangential force at the working circle of the driver", iso=ISO))
def tangential_force(T_1: NewtonMetre, d_w1: Metre) -> Newton:
    return 2 * T_1 / d_w1


@formula("F_rw", Text("{iso}: radial force at the working circle; it drives the wheels apart", iso=ISO))
def radial_force(F_tw: Newton, alpha_wt: Radian) -> Newton:
    return modulus(F_tw) * tan(alpha_wt)


@formula("F_a", Text("{iso}: axial force; the same at the working and the reference circle", iso=ISO))
def axial_force(F_tw: Newton, beta_w: Radian) -> Newton:
    return F_tw * tan(beta_w)


@formula("F_bt", Text("{iso}: force in the transverse plane, along the line of action", iso=ISO))
def transverse_force(F_tw: Newton, alpha_wt: Radian) -> Newton:
    return modulus(F_tw) / cos(alpha_wt)


@formula(
    "F_2",
    Text(
        "{statics}: of the driver on the driven wheel; s = +1 where the driver turns as the crank, else −1",
        statics=STATICS,
    ),
    meanings={"s": "Sense of the driver's rotation, 1 as the crank"},
)
def force_on_driven(F_rw: Newton, F_tw: Newton, gamma: Radian, s: Number) -> PhasorNewton:
    return F_rw * cis(gamma) + s * F_tw * cis(gamma + pi / 2)


@formula("F_1", Text("{statics}: of the driven wheel on the driver, equal and opposite", statics=STATICS))
def force_on_driver(F_2: PhasorNewton) -> PhasorNewton:
    return -F_2


@formula("F_W", Text("{statics}: vector sum of the forces of two meshes", statics=STATICS))
def wheel_force(F_1: PhasorNewton, F_2: PhasorNewton) -> PhasorNewton:
    return joined(F_1, F_2)


@formula("F_B", Text("{statics}: load of the wheel's bearing, transverse", statics=STATICS))
def bearing_force(F_W: PhasorNewton) -> Newton:
    return modulus(F_W)


@formula("ψ_B", Text("{statics}: direction of that load, from up in the sense of crank rotation", statics=STATICS))
def force_direction(F_W: PhasorNewton) -> Radian:
    return argument(F_W)


@formula("F_B,max", Text("{statics}: both meshes pull the same way", statics=STATICS))
def bearing_force_most(F_bt1: Newton, F_bt2: Newton) -> Newton:
    return F_bt1 + F_bt2


@formula("F_B,min", Text("{statics}: the meshes pull against each other", statics=STATICS))
def bearing_force_least(F_bt1: Newton, F_bt2: Newton) -> Newton:
    return modulus(joined(F_bt1, -F_bt2))


@formula(
    "F_x2",
    Text(
        "{statics}: on the driven wheel, + along the axis of the crank's rotation; s_β = +1: driver right-handed, −1: "
        "left-handed. A right-handed driver is pushed along the axis of its own rotation, its mate the other way",
        statics=STATICS,
    ),
    names={"h": "s_β"},
    meanings={"s": "Sense of the driver's rotation, 1 as the crank", "h": "Hand of the driver, 1 right, −1 left"},
)
def thrust_on_driven(F_a: Newton, s: Number, h: Number) -> Newton:
    return -s * h * F_a


@formula("F_x1", Text("{statics}: on the driver, equal and opposite", statics=STATICS))
def thrust_on_driver(F_x2: Newton) -> Newton:
    return -F_x2


@formula(
    "F_x",
    Text("{statics}: thrust of all meshes of a wheel", statics=STATICS),
    names={"F_m": "F_x,m"},
    meanings={"F_m": "Axial force of the other mesh"},
)
def thrust(F_m: Newtons) -> Newton:
    return resultant(F_m)


@formula("ψ", Text("{plane}: direction of the pitch point from the axis of the driven wheel", plane=PLANE))
def back_to_driver(gamma: Radian) -> Radian:
    return gamma + pi


@formula(
    "C_K",
    Text(
        "{statics}: r × F, the axial force on its arm from the wheel's axis to the pitch point; ψ is the direction of "
        "the arm",
        statics=STATICS,
    ),
)
def tilting(F_x: Newton, d_w: Metre, psi: Radian) -> PhasorNewtonMetre:
    return F_x * d_w / 2 * cis(psi - pi / 2)


@formula(
    "C_K",
    Text("{statics}: vector sum of the couples of two meshes", statics=STATICS),
    names={"C_1": "C_K1", "C_2": "C_K2"},
)
def tilting_sum(C_1: PhasorNewtonMetre, C_2: PhasorNewtonMetre) -> PhasorNewtonMetre:
    return joined(C_1, C_2)


@formula(
    "M_K", Text("{statics}: couple that tilts the wheel, to be carried by the length of its bearing", statics=STATICS)
)
def tilting_couple(C_K: PhasorNewtonMetre) -> NewtonMetre:
    return modulus(C_K)


@formula("M_K", Text("{statics}: couple that tilts a wheel, of one mesh alone", statics=STATICS))
def tilting_of_one(F_x: Newton, d_w: Metre) -> NewtonMetre:
    return modulus(F_x) * d_w / 2


@formula(
    "M_K,max",
    Text("{statics}: both couples about the same line", statics=STATICS),
    names={"M_1": "M_K1", "M_2": "M_K2"},
)
def tilting_most(M_1: NewtonMetre, M_2: NewtonMetre) -> NewtonMetre:
    return M_1 + M_2


@formula(
    "M_K,min", Text("{statics}: the couples against each other", statics=STATICS), names={"M_1": "M_K1", "M_2": "M_K2"}
)
def tilting_least(M_1: NewtonMetre, M_2: NewtonMetre) -> NewtonMetre:
    return modulus(M_1 - M_2)
