# SPDX-License-Identifier: Apache-2.0
"""What it costs to carry along the oil that is thrown onto the teeth."""

from ...sheet.formula import formula
from ...sheet.functions import pi
from ...sheet.units import CubicMetrePerSecond, KilogramPerMetre3, Metre, MetrePerSecond, RevPerSecond, Watt


@formula("v_t", "definition of the speed of the reference circle")
def pitch_line_speed(r: Metre, n: RevPerSecond) -> MetrePerSecond:
    return 2 * pi * r * n


@formula("P_J", "dynamics: momentum of the oil that leaves with the speed of the teeth (Butsch 1989, ISO/TR 14179-2)")
def thrown_oil(rho: KilogramPerMetre3, Q: CubicMetrePerSecond, v_t: MetrePerSecond, v_j: MetrePerSecond) -> Watt:
    return rho * Q * v_t * (v_t - v_j)
