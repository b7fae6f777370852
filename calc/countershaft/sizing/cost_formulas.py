# SPDX-License-Identifier: Apache-2.0
"""What another material changes: the sectors' radius, mass and wall, and the cost."""

from ...sheet.formula import formula
from ...sheet.functions import pi, power
from ...sheet.text import Text
from ...sheet.units import Euro, Kilogram, KilogramPerMetre3, Metre, Number

SAME = Text("geometry, same couple at the same length and half-angle: density times the difference of the cubed radii stays")
COST = Text("Finotti 2013, 4.2: cost of the first year")


@formula("R'", SAME, unit="mm", names={"rho_m": "ρ'"})
def radius_for(R: Metre, r_0: Metre, rho: KilogramPerMetre3, rho_m: KilogramPerMetre3) -> Metre:
    return power(r_0**3 + rho / rho_m * (R**3 - r_0**3), 1 / 3)


@formula("ΔD", "geometry: the seat through which the shaft is threaded grows with the sectors", unit="mm", names={"R_m": "R'"})
def bore_growth(R_m: Metre, R: Metre) -> Metre:
    return 2 * (R_m - R)


@formula("Σm'", "geometry, same length and half-angle: as density and squared radii", names={"m": "Σm", "rho_m": "ρ'", "R_m": "R'"})
def mass_for(m: Kilogram, rho: KilogramPerMetre3, rho_m: KilogramPerMetre3, R: Metre, R_m: Metre, r_0: Metre) -> Kilogram:
    return m * rho_m * (R_m**2 - r_0**2) / (rho * (R**2 - r_0**2))


@formula(
    "m_S'",
    "rule of this program: sectors, the rest by its density, and the largest journal's growth",
    names={"m_new": "Σm'", "m": "Σm", "rho_m": "ρ'", "d_m": "d'"},
)
def whole_mass(
    m_new: Kilogram, m_S: Kilogram, m: Kilogram, rho_m: KilogramPerMetre3, rho: KilogramPerMetre3, d_m: Metre, d: Metre, l: Metre
) -> Kilogram:
    """`m_new`, `m`: the sectors in the other and in the design's own material; d', d and l: the journal in the seat that grows."""
    return m_new + (m_S - m) * rho_m / rho + rho_m * pi / 4 * (d_m**2 - d**2) * l


@formula("Δm", "mathematics: whole shaft in this material less the design's own; below zero: lighter", unit="g", names={"m_new": "m_S'"})
def mass_difference(m_new: Kilogram, m_S: Kilogram) -> Kilogram:
    return m_new - m_S


@formula("d'", "geometry: the journal grows with its seat", unit="mm", names={"dD": "ΔD"})
def grown(d: Metre, dD: Metre) -> Metre:
    return d + dD


@formula("w'", "geometry: the support's outside stays, its seat grows", unit="mm", names={"R_m": "R'"})
def wall_left(w: Metre, R_m: Metre, R: Metre) -> Metre:
    return w - (R_m - R)


@formula("K_1", Text("{cost}: tooling, development and pieces", cost=COST), names={"c": "c_P"})
def first_year(K_T: Euro, K_D: Euro, N: Number, c: Euro) -> Euro:
    return K_T + K_D + N * c


@formula(
    "N_e", "mathematics: pieces at which both cost the same", names={"K": "K_T + K_D", "K_a": "K_T' + K_D'", "c_a": "c_P'", "c": "c_P"}
)
def break_even(K: Euro, K_a: Euro, c: Euro, c_a: Euro) -> Number:
    """Of tooling and development K and cost of a piece c, of the design's material and of the alternative."""
    return (K_a - K) / (c - c_a)


@formula(
    "K_D,e", "mathematics: development at which the alternative costs as much in the first year", names={"K_1a": "K_1'", "K_Da": "K_D'"}
)
def bearable_development(K_1: Euro, K_1a: Euro, K_Da: Euro) -> Euro:
    """Above it the alternative is the dearer one; below zero: it is so without any."""
    return K_1 - (K_1a - K_Da)


@formula("K", "mathematics: what is paid before the first piece")
def before_first_piece(K_T: Euro, K_D: Euro) -> Euro:
    return K_T + K_D
