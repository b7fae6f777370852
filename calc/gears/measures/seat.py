# SPDX-License-Identifier: Apache-2.0
"""A ball between two flanks: where its centre stands and where it touches."""

import math
from typing import TYPE_CHECKING

from ...sheet.record import record
from ...sheet.units import Metre, Number, Radian
from .. import formulas as f
from . import formulas as m

if TYPE_CHECKING:
    from ..result import ToothSystem


@record
class Seat:
    """`alpha_K`: pressure angle at its centre, on the circle `d_K`; `d_y`: the circle on which it touches."""

    alpha_K: Radian
    d_K: Metre
    d_y: Metre


def seat(system: "ToothSystem", z: Number, s_t: Metre, d: Metre, d_b: Metre, D_M: Metre) -> Seat | None:
    """None where the ball lies on the root, or would touch below the base circle, where there is no flank."""
    beta_b = system.base_helix_angle
    involute = m.ball_involute(s_t=s_t, d=d, alpha_t=system.transverse_pressure_angle, D_M=D_M, d_b=d_b, beta_b=beta_b, z=z)
    if involute <= 0:
        return None
    alpha_K = f.angle_of_involute(involute=involute)
    if d_b * math.tan(alpha_K) <= D_M * math.cos(beta_b):
        return None
    d_K = m.ball_centre_diameter(d_b=d_b, alpha_K=alpha_K)
    return Seat(alpha_K, d_K, m.ball_contact_diameter(d_b=d_b, alpha_K=alpha_K, D_M=D_M, beta_b=beta_b))
