# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""The power that one mesh loses, and what stands for its path: every formula of it, once."""

from collections.abc import Callable

import numpy as np

from ...sheet.arrays import Array, each, one
from ...sheet.formula import formula
from ...sheet.functions import along
from ...sheet.text import Text
from ...sheet.units import Celsius, Metre, MetrePerSecond, NewtonPerMetre, Number, Pascal, Watt, WattPerMetre
from .mixed import THESIS


@formula(
    "P_s",
    Text("{thesis}, eq. 3: mean over a mesh cycle of the friction power of all lines in contact", thesis=THESIS),
    names={"s": "Δs", "mu": "μ_z"},
)
def sliding_loss(s: Metre, mu: Number, w: NewtonPerMetre, V_s: MetrePerSecond) -> Watt:
    """s is the length of line for which a position stands; w is the load without its floor."""
    return along(s * mu * w * V_s)


@formula("P_R", "mathematics, mean over a mesh cycle of the rolling power; [IR]: share of Δs where the rigid isoviscous film governs",
    names={"s": "Δs", "r": "[IR]"})  # fmt: skip
def rolling_loss(s: Metre, q_R: WattPerMetre, r: Number) -> Watt:
    return along(s * q_R * r)


@formula(
    "P_RE",
    "mathematics: mean over a mesh cycle of the estimated rolling power of an EHL film; shown, not added",
    names={"s": "Δs", "r": "[IR]"},
)
def rolling_estimate(s: Metre, q_E: WattPerMetre, r: Number) -> Watt:
    return along(s * q_E * (1 - r))


@formula("P_VZ", "mathematics: sum of sliding and rolling")
def mesh_loss(P_s: Watt, P_R: Watt) -> Watt:
    return P_s + P_R


@formula("H_VL", Text("{thesis}, eq. 6: loss factor, the load shared along the path", thesis=THESIS), names={"s": "Δs"})
def loss_factor(s: Metre, w: NewtonPerMetre, V_s: MetrePerSecond, P: Watt) -> Number:
    return along(s * w * V_s) / P


@formula("μ_m", "definition of the mean coefficient of friction")
def mean_friction(P_s: Watt, P: Watt, H_VL: Number) -> Number:
    return P_s / (P * H_VL)


@formula("η_Z", Text("definition of the efficiency ({thesis}, eq. 1, prints the loss ratio under this name)", thesis=THESIS))
def efficiency(P_VZ: Watt, P: Watt) -> Number:
    """>>> efficiency(P_VZ=4.55, P=224.8)
    0.9797597...
    """
    return 1 - P_VZ / P


# --- single numbers of a whole path ------------------------------------------------------------------------------------------
@formula(
    "P_R", "rule of this program: without a rigid isoviscous film no rolling is counted", shows="no position has a rigid isoviscous film"
)
def no_rolling_loss() -> Watt:
    return 0.0


def extreme(which: Callable[..., Array], x: float) -> float:
    """The smallest or largest along the path."""
    found = which(x, axis=-1)
    return each(found) if found.ndim else one(each(found))


@formula("h_min", "definition: smallest along the path", unit="µm", shows="smallest h along the path")
def thinnest_film(h: Metre) -> Metre:
    return extreme(np.min, h)


@formula("λ_min", "definition: smallest along the path", shows="smallest λ along the path")
def least_film_ratio(lam: Number) -> Number:
    return extreme(np.min, lam)


@formula("p_H,max", "definition: largest along the path", unit="MPa", shows="largest p_H along the path")
def largest_pressure(p_H: Pascal) -> Pascal:
    return extreme(np.max, p_H)


@formula("p_C", "definition: the pressure of a spur pair where it rolls without sliding", unit="MPa", shows="p_H at the pitch point C")
def pressure_at_pitch_point(p_H: Pascal) -> Pascal:
    return p_H


@formula("T_f,max", "definition: largest along the path", shows="largest T_f along the path")
def hottest_film(T_f: Celsius) -> Celsius:
    return extreme(np.max, T_f)


@formula("De_max", "definition: largest along the path", shows="largest De along the path")
def largest_deborah(De: Number) -> Number:
    return extreme(np.max, De)


@formula("s_IR", "definition: share of the length of line whose film is rigid and isoviscous", unit="%", names={"s": "Δs", "r": "[IR]"})
def rigid_share(s: Metre, r: Number) -> Number:
    return along(s * r) / along(s)
