# SPDX-License-Identifier: Apache-2.0
"""What the pairing of journal and seat is judged by: p·v, the share of what is allowed, the turns of the load, the duty of a full film."""

from ...sheet.formula import formula
from ...sheet.units import MetrePerSecond, Number, Pascal, PascalMetrePerSecond, PascalSecond, RevPerSecond, Second


@formula("p·u", "definition of p·v: specific load times surface speed", unit="MPa·m/s")
def load_times_speed(p: Pascal, u: MetrePerSecond) -> PascalMetrePerSecond:
    return p * u


@formula("p/p_zul", "definition: share of the allowable specific load of the bearing material", unit="%")
def load_share(p: Pascal, p_zul: Pascal) -> Number:
    return p / p_zul


@formula(
    "p·u/(p·v)_zul",
    "definition: share of the allowable p·v of the bearing material",
    unit="%",
    names={"pu": "(p·u)", "pv_zul": "(p·v)_zul"},
)
def load_times_speed_share(pu: PascalMetrePerSecond, pv_zul: PascalMetrePerSecond) -> Number:
    return pu / pv_zul


@formula("N_L", "kinematics: a load that turns with the shaft passes every point of the seat once a turn", names={"L": "L_h"})
def load_cycles(n: RevPerSecond, L: Second) -> Number:
    """How often each point of the seat sees the largest film pressure in a life."""
    return n * L


@formula(
    "μ·n/p", "Chirone & Vullo 1979, after Finotti 2013, Fig. 5.16: duty of a full film; a pure number with n in revolutions per second"
)
def film_duty(mu: PascalSecond, n_h: RevPerSecond, p: Pascal) -> Number:
    """Not the source's 1.7·10⁻⁶, which it quotes for McKee's limit by a wrong conversion; 30 cP·rpm/psi are 7.25·10⁻⁸."""
    return mu * n_h / p
