# SPDX-License-Identifier: Apache-2.0
"""The shaft from its eccentric masses, in the order of Finotti 2013, 4.1.

Vectors are complex numbers as in the imbalance step: real up, imaginary 90° further in the sense of crank rotation,
cylinder 1 at TDC.  They turn with the shaft, against the crank.  z from mid-shaft, + towards the flywheel."""

from ..sheet.formula import formula
from ..sheet.functions import argument, cis, conj, cos, joined, modulus, pi, resultant, sqrt, tan, total
from ..sheet.text import Text
from ..sheet.units import (
    Kilogram,
    KilogramMetre,
    KilogramPerMetre,
    Metre,
    MetrePerSecond2,
    Newton,
    NewtonMetre,
    NewtonPerMetre,
    Number,
    PhasorKilogramMetre,
    PhasorKilogramMetre2,
    PhasorNewton,
    PhasorNewtonMetre,
    Radian,
    RadPerSecond,
    RevPerSecond,
    Watt,
)

TABLE_4_1 = Text("Finotti 2013, 4.1 (with ω², not ω as printed there)")
# of the shaft; z and φ alone are those of the crank's throws
MASSES = {"m": "m_i", "e": "e_i", "z": "z_i", "gamma": "φ_i"}


@formula(
    "F_S",
    TABLE_4_1,
    names=MASSES | {"omega": "ω_S"},
    meanings={
        "m": "Eccentric masses",
        "e": "Radii of the centres of gravity",
        "gamma": "Directions of the eccentric masses",
    },
)
def shaft_force(omega: RadPerSecond, m: Kilogram, e: Metre, gamma: Radian) -> PhasorNewton:
    """The rotating force that the shaft puts on its supports: what its masses do not balance statically."""
    return omega**2 * resultant(m * e * cis(gamma))


@formula(
    "F_i",
    "dynamics: centrifugal force of each eccentric mass; below zero for what is removed",
    names=MASSES | {"omega": "ω_S"},
)
def mass_force(omega: RadPerSecond, m: Kilogram, e: Metre, gamma: Radian) -> PhasorNewton:
    return omega**2 * m * e * cis(gamma)


@formula("n_S", "definition of angular speed", unit="rpm", names={"omega": "ω_S"})
def revolutions(omega: RadPerSecond) -> RevPerSecond:
    return omega / (2 * pi)


@formula("R", "geometry: the largest seat, less the clearance for threading in", unit="mm")
def widest(d: Metre, c_R: Metre) -> Metre:
    return d / 2 - c_R


@formula(
    "C_S",
    TABLE_4_1,
    names=MASSES | {"omega": "ω_S"},
    meanings={
        "m": "Eccentric masses",
        "e": "Radii of the centres of gravity",
        "z": "Places of the eccentric masses",
        "gamma": "Directions of the eccentric masses",
    },
)
def shaft_couple(omega: RadPerSecond, m: Kilogram, e: Metre, z: Metre, gamma: Radian) -> PhasorNewtonMetre:
    return omega**2 * resultant(m * e * z * cis(gamma))


@formula("M_i", TABLE_4_1, names=MASSES | {"omega": "ω_S"})
def mass_moment(omega: RadPerSecond, m: Kilogram, e: Metre, z: Metre) -> NewtonMetre:
    """The moment of one mass about mid-shaft.

    >>> mass_moment(omega=272.2714, m=2.691, e=0.018676, z=-0.077671)
    289.37...
    """
    return omega**2 * m * e * abs(z)


@formula("N_p", "mathematics: sum over the list of parts", names={"n": "n_p"}, meanings={"n": "Number of each part"})
def part_count(n: Number) -> Number:
    return total(n)


@formula("ω_S", "kinematics: speed of the shaft", names={"i": "i"})
def shaft_speed(i: Number, omega: RadPerSecond) -> RadPerSecond:
    """>>> shaft_speed(i=-1, omega=272.3)
    272.3
    """
    return abs(i) * omega


@formula("F_S", "mathematics, main masses and further elements together", names={"F_m": "F_m", "F_x": "F_x"})
def whole_force(F_m: PhasorNewton, F_x: PhasorNewton) -> PhasorNewton:
    return joined(F_m, F_x)


@formula("C_S", "mathematics, main masses and further elements together")
def whole_couple(C_m: PhasorNewtonMetre, C_x: PhasorNewtonMetre) -> PhasorNewtonMetre:
    return joined(C_m, C_x)


@formula("ΣU", "dynamics, static unbalance: rotating force over ω²", unit="g·mm", names={"omega": "ω_S"})
def static_unbalance(F_S: Newton, omega: RadPerSecond) -> KilogramMetre:
    """>>> static_unbalance(F_S=6.806, omega=272.3)
    9.179027...e-05
    """
    return F_S / omega**2


@formula("Σm", "mathematics: sum of the eccentric masses", names=MASSES)
def eccentric_mass(m: Kilogram) -> Kilogram:
    return total(m)


@formula("R_B", "statics: reaction of one of two bearings, by moments about the other (Finotti 2013, 3.2.3.1)")
def lever_reaction(C_S: PhasorNewtonMetre, z_o: Metre, F_S: PhasorNewton, z_B: Metre) -> PhasorNewton:
    """The force of the support at z_B on the shaft, the other one at z_o; it turns with the shaft."""
    return -(C_S - z_o * F_S) / (z_B - z_o)


@formula("F", "mathematics, modulus of the vector", names={"R": "R_i"})
def reaction(R: PhasorNewton) -> Newton:
    return modulus(R)


@formula("∠R", "mathematics: direction of a reaction, cylinder 1 at TDC", names={"R": "R_i"})
def reaction_phase(R: PhasorNewton) -> Radian:
    return argument(R)


@formula("|C_S|", "mathematics, modulus of the vector")
def couple(C_S: PhasorNewtonMetre) -> NewtonMetre:
    return modulus(C_S)


@formula("∠C_S", "mathematics, direction of the vector while cylinder 1 stands at TDC")
def couple_phase(C_S: PhasorNewtonMetre) -> Radian:
    return argument(C_S)


@formula("|F_S|", "mathematics, modulus of the vector")
def force(F_S: PhasorNewton) -> Newton:
    return modulus(F_S)


@formula("C_res", "mathematics: sum of the shaft's couple and the engine's that turns like it", names={"C_like": "C"})
def residual_vector(C_like: PhasorNewtonMetre, C_S: PhasorNewtonMetre) -> PhasorNewtonMetre:
    return joined(C_like, C_S)


@formula("F_res", "mathematics: sum of the shaft's force and the engine's that turns like it", names={"F_like": "F"})
def residual_force_vector(F_like: PhasorNewton, F_S: PhasorNewton) -> PhasorNewton:
    return joined(F_like, F_S)


@formula("C̄_S", "geometry, a shaft mirrored in the vertical plane, turning the other way", names={"C_S": "C_S"})
def mirrored_couple(C_S: PhasorNewtonMetre) -> PhasorNewtonMetre:
    return conj(C_S)


@formula("F̄_S", "geometry, a shaft mirrored in the vertical plane, turning the other way")
def mirrored_force(F_S: PhasorNewton) -> PhasorNewton:
    return conj(F_S)


@formula("ΔF_O", "mathematics: length of the difference of both forces", names={"F_O": "F_O", "F_S": "F_S"})
def force_deviation(F_O: PhasorNewton, F_S: PhasorNewton) -> Newton:
    return modulus(F_O - F_S)


@formula("ΔC_O", "mathematics: length of the difference of both couples")
def couple_deviation(C_O: PhasorNewtonMetre, C_S: PhasorNewtonMetre) -> NewtonMetre:
    return modulus(C_O - C_S)


@formula(
    "ΔC_S",
    "mathematics: part of the shaft's couple along the required one, beyond it",
    names={"C_req": "C_req"},
    meanings={"C_req": "Couple that the counter-shaft must supply"},
)
def couple_beyond(C_S: PhasorNewtonMetre, C_req: PhasorNewtonMetre) -> NewtonMetre:
    """Above zero: the shaft is too heavy by so much, which drilling can take away."""
    return modulus(C_S) * cos(argument(C_S) - argument(C_req)) - modulus(C_req)


# --- a shaft that is late

LATE = Text("kinematics: a shaft late by δ, in its own angle; σ_S = 1 with the crank, −1 against it")


@formula(
    "F_S,δ",
    LATE,
    names={"sigma": "σ_S", "delta": "δ_S"},
    meanings={"sigma": "Sense of the shaft's rotation, 1 or −1", "delta": "Angle by which the shaft is late"},
)
def late_force(F_S: PhasorNewton, sigma: Number, delta: Radian) -> PhasorNewton:
    """A vector that turns backward is F·e^(−iωt): a lag is e^(+iδ) there.  Early: δ below zero."""
    return F_S * cis(-sigma * delta)


@formula(
    "C_S,δ",
    Text("{late}; its couple too large by s", late=LATE),
    names={"s": "s_C", "sigma": "σ_S", "delta": "δ_S"},
    meanings={
        "s": "Excess of the couple, as a share",
        "sigma": "Sense of the shaft's rotation, 1 or −1",
        "delta": "Angle by which the shaft is late",
    },
)
def late_couple(C_S: PhasorNewtonMetre, s: Number, sigma: Number, delta: Radian) -> PhasorNewtonMetre:
    return C_S * (1 + s) * cis(-sigma * delta)


# --- what is asked of a shaft to be sized


@formula(
    "U_req",
    "dynamics: opposite to the engine's force that turns like the shaft, which over-design exceeds",
    unit="kg·mm",
    names={"F_like": "F", "omega": "ω_S"},
)
def asked_unbalance(x_o: Number, F_like: PhasorNewton, omega: RadPerSecond) -> PhasorKilogramMetre:
    return -(1 + x_o) * F_like / omega**2


@formula(
    "P_req",
    "dynamics: opposite to the engine's couple that turns like the shaft, which over-design exceeds",
    unit="kg·mm²",
    names={"C_like": "C", "omega": "ω_S"},
)
def asked_product(x_o: Number, C_like: PhasorNewtonMetre, omega: RadPerSecond) -> PhasorKilogramMetre2:
    return -(1 + x_o) * C_like / omega**2


# --- what stands still

GEAR = Text("statics, components of the tooth force at the reference circle of a helical wheel")
G: MetrePerSecond2 = 9.80665


@formula("G_S", "definition: weight, g = 9.80665 m/s²", names={"G": "g"})
def weight(m_S: Kilogram) -> Newton:
    """>>> weight(m_S=9.034)
    88.59327...
    """
    return m_S * G


@formula("q_G", "definition: weight per length", names={"mu": "ρ_l", "G": "g"})
def line_weight(mu: KilogramPerMetre) -> NewtonPerMetre:
    return mu * G


@formula(
    "G_B",
    "statics: lever about the other bearing",
    names={"z_S": "z_S"},
    meanings={"z_S": "Place of the centre of gravity"},
)
def lever_weight(G_S: Newton, z_S: Metre, z_o: Metre, z_B: Metre) -> Newton:
    """On the bearing at z_B, of two, the other one at z_o."""
    return G_S * (z_S - z_o) / (z_B - z_o)


@formula("T", "definition: power over angular speed", meanings={"n": "Speed of the shaft"})
def gear_torque(P: Watt, n: RevPerSecond) -> NewtonMetre:
    """>>> gear_torque(P=220.2, n=43.33)
    0.8088141...
    """
    return P / (2 * pi * n)


@formula("F_t", GEAR)
def gear_tangential(T: NewtonMetre, d: Metre) -> Newton:
    """>>> gear_tangential(T=0.8089, d=0.05389)
    30.02041...
    """
    return 2 * T / d


@formula("F_r", GEAR)
def gear_radial(F_t: Newton, alpha_n: Radian, beta: Radian) -> Newton:
    """>>> gear_radial(F_t=30.02, alpha_n=0.3491, beta=0.3825)
    11.77874...
    """
    return F_t * tan(alpha_n) / cos(beta)


@formula("F_a", GEAR)
def gear_axial(F_t: Newton, beta: Radian) -> Newton:
    """>>> gear_axial(F_t=30.02, beta=0.3825)
    12.07747...
    """
    return F_t * tan(beta)


@formula(
    "R_G",
    "statics: levers of the tooth force about the other bearing; the thrust adds its tilting couple in the radial "
    "plane, taken for the worse",
)
def lever_gear(F_t: Newton, F_r: Newton, F_a: Newton, d: Metre, z_G: Metre, z_o: Metre, z_B: Metre) -> Newton:
    """On the bearing at z_B, of two, the other one at z_o."""
    return sqrt((F_t * (z_G - z_o)) ** 2 + (F_r * abs(z_G - z_o) + F_a * d / 2) ** 2) / abs(z_B - z_o)


PULL = Text("statics, all in line: a bound, since the strands' directions are not known")


@formula("F_K", Text("{pull}; what pulls, and the force of the tensioner in both strands", pull=PULL))
def strands_pull(F_t: Newton, F_S: Newton) -> Newton:
    """Of a chain or belt on the shaft of its sprocket.  What its own mass does as it turns its strands carry
    themselves.

    >>> strands_pull(F_t=120.0, F_S=50.0)
    220.0
    """
    return F_t + 2 * F_S


@formula("F_K", PULL, names={"F": "F_K,0", "F_K": "F_K,i"})
def pulls_together(F: Newton, F_K: Newton) -> Newton:
    return F + F_K


@formula("R_K", "statics: lever of the pull of chains and belts about the other bearing")
def lever_pull(F_K: Newton, z_G: Metre, z_o: Metre, z_B: Metre) -> Newton:
    """On the bearing at z_B, of two, the other one at z_o."""
    return F_K * abs(z_G - z_o) / abs(z_B - z_o)


@formula("R_K", "statics: what the pull puts on a bearing, by the stiffness of shaft and films")
def pull_shared(G_F: Number, F_K: Newton) -> Newton:
    """`G_F`: what 1 N at the wheel puts there."""
    return G_F * F_K


@formula("R_G", Text("{pull}; tooth force and pull", pull=PULL), names={"R": "R_T"})
def with_pull(R: Newton, R_K: Newton) -> Newton:
    return R + R_K


@formula("G_B", "statics: what the weight puts on a bearing, by the stiffness of shaft and films", names={"G_u": "G_u"})
def weight_shared(G_u: Newton) -> Newton:
    """`G_u`: of the bearing on the shaft, positive up; the other way round."""
    return -G_u


@formula("R_0", "statics, weight and tooth force in line: a bound, since the wheels' places are not known")
def stationary(G_B: Newton, R_G: Newton) -> Newton:
    return abs(G_B) + R_G


@formula(
    "R_0",
    "statics: weight and bores by their directions; tooth force and tolerances, whose directions are open, in line",
    names={"G_B": "G_u"},
)
def stationary_shared(G_B: Newton, R_o: PhasorNewton, R_G: Newton, R_c: Newton) -> Newton:
    """On one of more than two bearings; G_B up, R_o up and 90° further in the sense of the crank."""
    return modulus(G_B + R_o) + R_G + R_c


@formula("R_max", "statics: the turning and the standing part in line, once a turn", names={"R": "F"})
def reaction_peak(R: Newton, R_0: Newton) -> Newton:
    return R + R_0


# --- the support


@formula(
    "w",
    "Finotti 2013, 4.2: the support's outside stays, its seat grows",
    unit="mm",
    names={"w": "w_w"},
    meanings={"return": "Wall of the support beside the bearing"},
)
def wall_beside(w: Metre, d: Metre, D_w: Metre) -> Metre:
    return w - (d - D_w) / 2


@formula(
    "c_R",
    "geometry: room of a piece of the shaft in an opening that it passes",
    unit="mm",
    meanings={"D_b": "Diameter of the opening"},
)
def room_on_the_way(D_b: Metre, R: Metre) -> Metre:
    """>>> room_on_the_way(D_b=0.0403, R=0.019976)
    0.000174...
    """
    return D_b / 2 - R


@formula(
    "n_1/n_max",
    "definition: first critical speed over the highest speed of the shaft",
    meanings={"n_max": "Highest speed of the shaft"},
)
def critical_share(n_1: RevPerSecond, n_max: RevPerSecond) -> Number:
    return n_1 / n_max
