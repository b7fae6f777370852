# SPDX-License-Identifier: Apache-2.0
"""The formulas of sizing: a pure couple in closed form, any pair of sectors, what would be needed, what it costs."""

import numpy as np

from ...sheet.arrays import Array
from ...sheet.formula import formula
from ...sheet.functions import (
    argument,
    asin,
    cis,
    cos,
    joined,
    modulus,
    pi,
    power,
    resultant,
    sin,
    single_or_many,
    smallest,
    sqrt,
)
from ...sheet.text import Text
from ...sheet.units import (
    Euro,
    Kilogram,
    KilogramMetre,
    KilogramMetre2,
    KilogramPerMetre3,
    Metre,
    NewtonMetre,
    Number,
    PhasorKilogramMetre,
    PhasorKilogramMetre2,
    PhasorNumber,
    Radian,
    RadPerSecond,
    SquareMetre,
)
from ..formulas import MASSES
from .lengths import least_lengths

LEAST = Text("mathematics, least mass of two equal opposed sectors, by Lagrange's multiplier on γ·b")
MOMENTS = Text("dynamics, equilibrium of unbalances and of their moments about mid-shaft")
SCALE = Text(
    "geometry: the couple of sectors of given length and half-angle goes with density and the difference of the cubed "
    "radii"
)
FACES = Text("geometry, sector with its outer face at the end of the envelope")


# --- what is asked of the sectors


@formula("ΣU_x", "mathematics: unbalance of the further elements", unit="kg·mm", names=MASSES)
def extra_unbalance(m: Kilogram, e: Metre, gamma: Radian) -> PhasorKilogramMetre:
    return resultant(m * e * cis(gamma))


@formula("P_x", "mathematics: unbalance times position of the further elements", unit="kg·mm²", names=MASSES)
def extra_product(m: Kilogram, e: Metre, z: Metre, gamma: Radian) -> PhasorKilogramMetre2:
    return resultant(m * e * z * cis(gamma))


@formula("U_s", "mathematics, what is left for the sectors", unit="kg·mm", names={"U_x": "ΣU_x"})
def unbalance_left(U: PhasorKilogramMetre, U_x: PhasorKilogramMetre) -> PhasorKilogramMetre:
    return joined(U, -U_x)


@formula("P_s", "mathematics, what is left for the sectors", unit="kg·mm²")
def product_left(P: PhasorKilogramMetre2, P_x: PhasorKilogramMetre2) -> PhasorKilogramMetre2:
    return joined(P, -P_x)


# --- two equal sectors: a pure couple


@formula("C", "dynamics: couple of an unbalance times distance", names={"P": "P_s", "omega": "ω_S"})
def couple_asked(P: PhasorKilogramMetre2, omega: RadPerSecond) -> NewtonMetre:
    return modulus(P) * omega**2


@formula(
    "K",
    Text("{least}: b·(z_max − b/2)·sin γ that the couple asks for", least=LEAST),
    unit="mm²",
    names={"omega": "ω_S"},
)
def couple_number(C: NewtonMetre, rho: KilogramPerMetre3, omega: RadPerSecond, R: Metre, r_0: Metre) -> SquareMetre:
    return C / (4 / 3 * rho * omega**2 * (R**3 - r_0**3))


@formula("u", Text("{least}: K over its limit, at 90° and b = z_max", least=LEAST))
def pair_utilisation(K: SquareMetre, z_max: Metre) -> Number:
    return 2 * K / z_max**2


def _relative(gamma: Array) -> Array:
    """2·h(γ) = 4·q·sin γ/(1 + q)², which rises from 0 to 1 at 90°."""
    q = 1 - gamma * np.cos(gamma) / np.sin(gamma)
    return 4 * q * np.sin(gamma) / (1 + q) ** 2


@formula("γ", LEAST, shows="γ from 2·q·sin γ/(1 + q)² = K/z_max² with q = 1 − γ·cot γ, by iteration")
def pair_half_angle(K: SquareMetre, z_max: Metre) -> Radian:
    """Between 0 and 90°, for K up to z_max²/2.

    arcsin of the cube root of the left side (doubled) is nearly a straight line in γ, with a slope between 0.86 and
    1.11: the difference itself is then a good step, also at the limit, where the left side is level."""
    u = np.minimum(2 * np.asarray(K, dtype=float) / z_max**2, 1.0)
    wanted = np.arcsin(np.cbrt(u))
    gamma = np.maximum(wanted, 1e-300)
    for _ in range(60):
        step = wanted - np.arcsin(np.minimum(np.cbrt(_relative(gamma)), 1.0))
        gamma = np.minimum(gamma + step, np.pi / 2)
        if not np.any(np.abs(step) > 1e-15):
            break
    return single_or_many(np.asarray(gamma))


@formula("κ_q", LEAST)
def pair_ratio(gamma: Radian) -> Number:
    return 1 - gamma * cos(gamma) / sin(gamma)


@formula("b", LEAST, unit="mm", names={"q": "κ_q"})
def pair_length(z_max: Metre, q: Number) -> Metre:
    return z_max * 2 * q / (1 + q)


CLOSED = Text("rule of this program: a gap between the sectors that does not hold two fillets is closed")


@formula("b", CLOSED, unit="mm")
def closed_length(z_max: Metre) -> Metre:
    return z_max


@formula("γ", Text("{closed}; half-angle of the couple at that length", closed=CLOSED))
def closed_half_angle(K: SquareMetre, z_max: Metre) -> Radian:
    return asin(smallest(1.0, 2 * K / z_max**2))


@formula("z_c", Text("{faces}: its middle", faces=FACES), unit="mm")
def pair_arm(z_max: Metre, b: Metre) -> Metre:
    return z_max - b / 2


@formula("C", "dynamics: couple of two equal unbalances opposite each other", names={"omega": "ω_S"})
def pair_couple(U: KilogramMetre, z_c: Metre, omega: RadPerSecond) -> NewtonMetre:
    return 2 * U * z_c * omega**2


@formula(
    "∠", "geometry, direction of the vector while cylinder 1 stands at TDC: that of the rear sector", names={"P": "P_s"}
)
def couple_direction(P: PhasorKilogramMetre2) -> Radian:
    return argument(P)


@formula(
    "∠", "geometry, the other side of the shaft: the front sector", meanings={"return": "Direction of the front sector"}
)
def opposite(angle: Radian) -> Radian:
    return angle + pi


# --- any two sectors


@formula("k", "geometry, largest unbalance of a sector per length, at a half-angle of 90°: g·mm per mm")
def unbalance_per_length(rho: KilogramPerMetre3, R: Metre, r_0: Metre) -> Kilogram:
    return 2 / 3 * rho * (R**3 - r_0**3)


@formula("α", "definition: unbalance asked of the sectors over that of one of full length at 90°", names={"U": "U_s"})
def force_number(U: PhasorKilogramMetre, k: Kilogram, z_max: Metre) -> PhasorNumber:
    return U / (k * z_max)


@formula("Π", "definition: unbalance times position asked of the sectors, by the same measure", names={"P": "P_s"})
def product_number(P: PhasorKilogramMetre2, k: Kilogram, z_max: Metre) -> PhasorNumber:
    return P / (k * z_max**2)


SEARCH = Text("mathematics, least mass of two sectors together, by search over both their lengths")


@formula(
    "u",
    "rule of this program: the least sin γ that the more loaded sector needs",
    shows="u = min over b_f, b_r of max(sin γ_f, sin γ_r)",
)
def utilisation(alpha: PhasorNumber, product: PhasorNumber) -> Number:
    return least_lengths(alpha, product)[2]


@formula("b_f", SEARCH, shows="b_f, with b_r, from the least Σ γ·b that gives U_s and P_s", unit="mm")
def front_length(alpha: PhasorNumber, product: PhasorNumber, z_max: Metre) -> Metre:
    return least_lengths(alpha, product)[0] * z_max


@formula("b_r", SEARCH, shows="b_r, with b_f, from the least Σ γ·b that gives U_s and P_s", unit="mm")
def rear_length(alpha: PhasorNumber, product: PhasorNumber, z_max: Metre) -> Metre:
    return least_lengths(alpha, product)[1] * z_max


@formula("z_f", Text("{faces}: its middle", faces=FACES), unit="mm", meanings={"return": "Place of the front sector"})
def front_place(b: Metre, z_max: Metre) -> Metre:
    return b / 2 - z_max


@formula("z_r", Text("{faces}: its middle", faces=FACES), unit="mm", meanings={"return": "Place of the rear sector"})
def rear_place(b: Metre, z_max: Metre) -> Metre:
    return z_max - b / 2


@formula("U_r", MOMENTS, unit="kg·mm", names={"P": "P_s", "U": "U_s"})
def rear_unbalance(P: PhasorKilogramMetre2, z_f: Metre, U: PhasorKilogramMetre, z_r: Metre) -> PhasorKilogramMetre:
    return (P - z_f * U) / (z_r - z_f)


@formula("U_f", MOMENTS, unit="kg·mm", names={"U": "U_s"})
def front_unbalance(U: PhasorKilogramMetre, U_r: PhasorKilogramMetre) -> PhasorKilogramMetre:
    return joined(U, -U_r)


@formula("γ", "geometry: half-angle of a sector of given unbalance and length")
def sector_half_angle(U: PhasorKilogramMetre, k: Kilogram, b: Metre) -> Radian:
    return asin(smallest(1.0, modulus(U) / (k * b)))


@formula("∠", "mathematics, direction of the vector while cylinder 1 stands at TDC")
def direction(U: PhasorKilogramMetre) -> Radian:
    return argument(U)


@formula("Σm", "mathematics: sum of both sectors")
def both_masses(m_f: Kilogram, m_r: Kilogram) -> Kilogram:
    return m_f + m_r


# --- what would be needed


@formula("C_max", Text("{least}: the couple at 90° and b = z_max", least=LEAST))
def possible_couple(C: NewtonMetre, u: Number) -> NewtonMetre:
    return C / u


@formula("R_min", SCALE, unit="mm")
def radius_needed(R: Metre, r_0: Metre, u: Number) -> Metre:
    """The outer radius at which the envelope is just used up."""
    return power(r_0**3 + u * (R**3 - r_0**3), 1 / 3)


@formula("z_min", "geometry: the largest couple goes with the square of the half-length", unit="mm")
def half_length_needed(z_max: Metre, u: Number) -> Metre:
    return z_max * sqrt(u)


@formula(
    "ΔP",
    "mathematics: what the couple of the sectors leaves to further elements",
    unit="kg·mm²",
    names={"omega": "ω_S"},
)
def product_missing(C: NewtonMetre, C_max: NewtonMetre, omega: RadPerSecond) -> KilogramMetre2:
    return (C - C_max) / omega**2


# --- what another material changes: the sectors' radius, mass and wall, and the cost

SAME = Text(
    "geometry, same couple at the same length and half-angle: density times the difference of the cubed radii stays"
)
COST = Text("Finotti 2013, 4.2: cost of the first year")


@formula("R'", SAME, unit="mm", names={"rho_m": "ρ'"}, meanings={"rho": "Density"})
def radius_for(R: Metre, r_0: Metre, rho: KilogramPerMetre3, rho_m: KilogramPerMetre3) -> Metre:
    return power(r_0**3 + rho / rho_m * (R**3 - r_0**3), 1 / 3)


@formula(
    "ΔD",
    "geometry: the seat through which the shaft is threaded grows with the sectors",
    unit="mm",
    names={"R_m": "R'"},
)
def bore_growth(R_m: Metre, R: Metre) -> Metre:
    return 2 * (R_m - R)


@formula(
    "Σm'",
    "geometry, same length and half-angle: as density and squared radii",
    names={"m": "Σm", "rho_m": "ρ'", "R_m": "R'"},
    meanings={"rho": "Density"},
)
def mass_for(
    m: Kilogram, rho: KilogramPerMetre3, rho_m: KilogramPerMetre3, R: Metre, R_m: Metre, r_0: Metre
) -> Kilogram:
    return m * rho_m * (R_m**2 - r_0**2) / (rho * (R**2 - r_0**2))


@formula(
    "m_S'",
    "rule of this program: sectors, the rest by its density, and the largest journal's growth",
    names={"m_new": "Σm'", "m": "Σm", "rho_m": "ρ'", "d_m": "d'"},
    meanings={
        "rho": "Density",
        "rho_m": "Density of the other material",
        "d": "Diameter of the journal in the design",
        "l": "Length of the journal",
    },
)
def whole_mass(
    m_new: Kilogram,
    m_S: Kilogram,
    m: Kilogram,
    rho_m: KilogramPerMetre3,
    rho: KilogramPerMetre3,
    d_m: Metre,
    d: Metre,
    l: Metre,
) -> Kilogram:
    """`m_new`, `m`: the sectors in the other and in the design's own material; d', d and l: the journal in the seat
    that grows."""
    return m_new + (m_S - m) * rho_m / rho + rho_m * pi / 4 * (d_m**2 - d**2) * l


@formula(
    "Δm",
    "mathematics: whole shaft in this material less the design's own; below zero: lighter",
    unit="g",
    names={"m_new": "m_S'"},
)
def mass_difference(m_new: Kilogram, m_S: Kilogram) -> Kilogram:
    return m_new - m_S


@formula(
    "d'",
    "geometry: the journal grows with its seat",
    unit="mm",
    names={"dD": "ΔD"},
    meanings={"dD": "Growth of the seat", "d": "Diameter of the journal in the design"},
)
def grown(d: Metre, dD: Metre) -> Metre:
    return d + dD


@formula("w'", "geometry: the support's outside stays, its seat grows", unit="mm", names={"R_m": "R'"})
def wall_left(w: Metre, R_m: Metre, R: Metre) -> Metre:
    return w - (R_m - R)


@formula("K_1", Text("{cost}: tooling, development and pieces", cost=COST), names={"c": "c_P"})
def first_year(K_T: Euro, K_D: Euro, N: Number, c: Euro) -> Euro:
    return K_T + K_D + N * c


@formula(
    "N_e",
    "mathematics: pieces at which both cost the same",
    names={"K": "K_T + K_D", "K_a": "K_T' + K_D'", "c_a": "c_P'", "c": "c_P"},
)
def break_even(K: Euro, K_a: Euro, c: Euro, c_a: Euro) -> Number:
    """Of tooling and development K and cost of a piece c, of the design's material and of the alternative."""
    return (K_a - K) / (c - c_a)


@formula(
    "K_D,e",
    "mathematics: development at which the alternative costs as much in the first year",
    names={"K_1a": "K_1'", "K_Da": "K_D'"},
)
def bearable_development(K_1: Euro, K_1a: Euro, K_Da: Euro) -> Euro:
    """Above it the alternative is the dearer one; below zero: it is so without any."""
    return K_1 - (K_1a - K_Da)


@formula("K", "mathematics: what is paid before the first piece")
def before_first_piece(K_T: Euro, K_D: Euro) -> Euro:
    return K_T + K_D
