# SPDX-License-Identifier: Apache-2.0
"""Sizes over cylindrical pins, and over one ball or pin from the wheel's axis.

A pin in a tooth space touches both flanks where a ball of its diameter would: its centre line is the tangent of the helix that the
ball's centre would run along, at right angles to both flanks' normals.  It can slide along its space.  Between faces parallel to the
wheel's axis two pins lie flat where they are opposite each other, whatever the number of teeth; on a helical wheel with an odd number
they are then half an axial pitch apart, and a third pin in the next space, as far off to the other side, makes the seat firm.  A free
micrometer with two pins tilts and finds the smallest distance of the two centre lines instead, which is less.
"""

import math

from ...sheet.formula import formula
from ...sheet.functions import atan, cos, pi, sin, sqrt, tan
from ...sheet.units import Metre, Number, Radian
from ..formulas import ISO

OPPOSITE = f"{ISO}, from memory; agrees with centre lines of pins that lie flat between faces parallel to the axis"
SKEW = "geometry of two skew lines, tangents of the helix of the ball centres in opposite tooth spaces"


@formula("β_K", f"{ISO}: helix angle at the circle of the ball centres")
def helix_angle_at_centres(beta_b: Radian, alpha_K: Radian) -> Radian:
    return atan(tan(beta_b) / cos(alpha_K))


@formula("M_r", f"{ISO}: size over one ball or pin, from the wheel's axis", unit="mm")
def radial_size(d_K: Metre, D_M: Metre) -> Metre:
    return d_K / 2 + D_M / 2


@formula("M_dR", OPPOSITE, unit="mm")
def over_pins_opposite(d_K: Metre, D_M: Metre) -> Metre:
    """Even number of teeth, or any of a helical wheel."""
    return d_K + D_M


@formula("M_dR", f"{ISO}: size over two pins, spur wheel with an odd number of teeth", unit="mm")
def over_pins_odd_spur(d_K: Metre, z: Number, D_M: Metre) -> Metre:
    return d_K * cos(pi / (2 * z)) + D_M


@formula(
    "δ", f"{SKEW}: where their distance is smallest; odd number of teeth, β_K below 45°",
    shows="half the angle that two pins lack to be opposite: δ − tan²β_K·sin(2·δ)/2 = π/(2·z)",
)  # fmt: skip
def pin_angle(z: Number, beta_K: Radian) -> Radian:
    """The left side rises and is convex up to 90°: Newton's method, kept below that, falls steadily onto the root."""
    gap, half = math.pi / (2 * z), math.tan(beta_K) ** 2 / 2
    delta = gap
    for _ in range(60):
        step = (delta - half * math.sin(2 * delta) - gap) / (1 - 2 * half * math.cos(2 * delta))
        delta = min(delta - step, math.pi / 2)
        if abs(step) < 1e-15:
            break
    return delta


@formula("M_2R", f"{SKEW}: smallest size over two pins, odd number of teeth", unit="mm")
def over_two_pins(d_K: Metre, delta: Radian, beta_K: Radian, D_M: Metre) -> Metre:
    return d_K * cos(delta) * sqrt(1 + (tan(beta_K) * sin(delta)) ** 2) + D_M


@formula(
    "b_R", f"{SKEW}: face width that two opposite pins need, odd number of teeth: half an axial pitch and what the contact takes", unit="mm"
)
def pins_width(m_n: Metre, beta: Radian, D_M: Metre, beta_b: Radian) -> Metre:
    """Three pins need half an axial pitch more."""
    return pi * m_n / (2 * sin(beta)) + D_M * sin(beta_b)
