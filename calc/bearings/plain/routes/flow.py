# SPDX-License-Identifier: Apache-2.0
"""How much oil passes: the side flow of the turning film, and what the supply pressure drives through.

Supply factors of DIN 31652-2 / ISO 7902-2 as tabulated in Finotti 2013, Table 5.1, with q_H and q_P in the denominator.
"""

from ....sheet.formula import formula
from ....sheet.functions import cos, ln, pi, sin
from ....sheet.text import Text
from ....sheet.units import (
    CubicMetrePerSecond,
    KilogramPerMetre3,
    Metre,
    Number,
    Pascal,
    PascalSecond,
    Radian,
    RadPerSecond,
    RevPerSecond,
)

TABLE = Text("Finotti 2013, Table 5.1 (DIN 31652-2), factor in the denominator")


@formula(
    "Q_1",
    "computed here: side flow of Reynolds' solution",
    unit="L/min",
    names={"Q_rel": "Q*", "share": "(Q_s/Q)"},
    meanings={"n_h": "Hydrodynamically effective speed of journal"},
)
def side_flow(Q_rel: Number, share: Number, d: Metre, g: Metre, n_h: RevPerSecond, l: Metre) -> CubicMetrePerSecond:
    return Q_rel * share * d * g * n_h * l / 4


@formula(
    "Q_1", "hydrodynamics: side flow of Reynolds' solution with its grooves", unit="L/min", names={"Q_rel": "Q_s*"}
)
def side_flow_grooved(Q_rel: Number, d: Metre, g: Metre, n_h: RevPerSecond, l: Metre) -> CubicMetrePerSecond:
    return Q_rel * d * g * n_h * l / 4


@formula(
    "q_1",
    "ISO 7902-2 (DIN 31652-2), side flow; within a few per cent of Reynolds' solution for l/d ≤ 1",
    names={"b": "(l/d)"},
)
def side_flow_factor(b: Number, eps: Number) -> Number:
    return (b - 0.223 * b**3) * eps / 4


@formula("Q_1", "ISO 7902-2 (DIN 31652-2), side flow", unit="L/min")
def side_flow_din(d: Metre, psi: Number, omega: RadPerSecond, q_1: Number) -> CubicMetrePerSecond:
    return d**3 * psi * omega * q_1


@formula("E", "hydrodynamics, hole or pocket in the seat, swept by a load that turns: mean of (h/c)³ over the turn")
def swept(eps: Number) -> Number:
    return 1 + 1.5 * eps**2


@formula("E", "hydrodynamics, hole opposite the load: (h/c)³ at the widest gap")
def opposite(eps: Number) -> Number:
    return (1 + eps) ** 3


@formula(
    "E",
    "hydrodynamics, hole or pocket at an angle to the load that stays: (h/c)³; 180° opposite, 0° in the load zone "
    "(Finotti 2013, Table 5.1)",
)
def at_angle(eps: Number, delta: Radian) -> Number:
    return (1 - eps * cos(delta)) ** 3


@formula("E", "geometry: several grooves, their sum", names={"one": "E_1", "more": "E_2"})
def together(one: Number, more: Number) -> Number:
    return one + more


@formula("x_l", "definition: width of hole or pocket over the length", names={"b": "b_s"})
def share_of_length(b: Metre, l: Metre) -> Number:
    return b / l


@formula("q", Text("{table}: q_H of a hole", table=TABLE), names={"x": "x_l"})
def hole_factor(x: Number) -> Number:
    return 1.204 + 0.368 * x - 1.046 * x**2 + 1.942 * x**3


@formula("q", Text("{table}: q_P of a pocket", table=TABLE), names={"x": "x_l"})
def pocket_factor(x: Number) -> Number:
    return 1.188 + 1.582 * x - 2.585 * x**2 + 5.563 * x**3


@formula("q_2", TABLE, names={"b": "b_s"})
def supply_factor(E: Number, l: Metre, b: Metre, q: Number) -> Number:
    """Hole (b its diameter) or pocket (b its width along the shaft)."""
    return pi / 48 * E / (ln(l / b) * q)


@formula("q_2", "hydrodynamics, full circumferential groove: flow through two lands of length (l − b_G)/2")
def groove_factor(eps: Number, d: Metre, l: Metre, b_G: Metre) -> Number:
    return pi / 24 * (1 + 1.5 * eps**2) * d / (l - b_G)


@formula("φ", "geometry: angle from the widest gap, taken opposite the load (DIN 31652-2)", unit="°")
def from_widest(delta: Radian) -> Radian:
    return delta - pi


@formula(
    "q_2", "Finotti 2013, Table 5.1 (DIN 31652-2): groove of part circumference at an angle to the load that stays"
)
def part_groove_factor(eps: Number, phi_A: Radian, phi_E: Radian, d: Metre, l: Metre, b_G: Metre) -> Number:
    """The integral of (h/c)³ from the angle phi_A to phi_E, both from the widest gap."""
    return (
        (
            (phi_E - phi_A) * (1 + 1.5 * eps**2)
            + (3 * eps + eps**3) * (sin(phi_E) - sin(phi_A))
            + 0.75 * eps**2 * (sin(2 * phi_E) - sin(2 * phi_A))
            - eps**3 / 3 * (sin(phi_E) ** 3 - sin(phi_A) ** 3)
        )
        / 48
        * d
        / (l - b_G)
    )


@formula("q_2", "hydrodynamics, groove of part circumference, swept by the load: its share of the full groove's mean")
def swept_part_groove_factor(eps: Number, delta_A: Radian, delta_E: Radian, d: Metre, l: Metre, b_G: Metre) -> Number:
    return (delta_E - delta_A) / 48 * (1 + 1.5 * eps**2) * d / (l - b_G)


@formula("Q_2", "ISO 7902-2 (DIN 31652-2), flow by supply pressure", unit="L/min")
def supply_flow(d: Metre, psi: Number, p_s: Pascal, mu: PascalSecond, q_2: Number) -> CubicMetrePerSecond:
    return d**3 * psi**3 * p_s / mu * q_2


@formula("Q", "mathematics: sum of both flows", unit="L/min")
def total_flow(Q_1: CubicMetrePerSecond, Q_2: CubicMetrePerSecond) -> CubicMetrePerSecond:
    return Q_1 + Q_2


@formula(
    "Q_s",
    "Finotti 2013, 5.5.2: flow of a pressure-fed bearing, with the full length where a groove would halve it",
    unit="L/min",
)
def groove_flow_of_finotti(
    p_s: Pascal, d: Metre, g: Metre, eps: Number, mu: PascalSecond, l: Metre
) -> CubicMetrePerSecond:
    return pi * p_s * d / 2 * (g / 2) ** 3 * (1 + 1.5 * eps**2) / (3 * mu * l)


@formula("p_eff", "hydrodynamics, feed through the shaft: the supply works against the centrifugal head", unit="bar")
def pressure_through_shaft(p_s: Pascal, rho: KilogramPerMetre3, omega: RadPerSecond, d: Metre) -> Pascal:
    return p_s - rho * omega**2 * (d / 2) ** 2 / 2
