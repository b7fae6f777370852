# SPDX-License-Identifier: Apache-2.0
"""A ball between two flanks: where its centre stands and where it touches, and the preferred diameter that suits a wheel best."""

import math

from ...sheet.formula import formula
from ...sheet.text import Text
from ...sheet.trace import untraced
from ...sheet.units import Metre, Number
from ...sheet.value import based_on
from .. import formulas as f
from ..result import ToothSystem
from . import formulas as m
from .result import Seat

SOURCE = Text("DIN 3977, measuring pieces for cylindrical gears")
MILLIMETRES = (
    1, 1.1, 1.25, 1.4, 1.5, 1.75, 2, 2.25, 2.5, 2.75, 3, 3.25, 3.5, 3.75, 4, 4.25, 4.5, 5, 5.25, 5.5, 6, 6.5, 7, 7.5, 8, 9, 10, 10.5, 11,
    12, 14, 16, 18, 20, 22, 25, 28, 30, 35, 40, 45, 50,
)  # fmt: skip
PREFERRED: tuple[Metre, ...] = tuple(d / 1000 for d in MILLIMETRES)


@formula("D_M", SOURCE, unit="mm", shows="the preferred diameter nearest to D_y that touches the flank and stands proud of the tip")
def nearest_preferred(D: Metre, D_y: Metre) -> Metre:
    """`D` is the one that was found."""
    return D


def preferred_ball(
    system: ToothSystem, z: Number, s_t: Metre, d: Metre, d_b: Metre, flank: tuple[Metre, Metre], d_f: Metre, ideal: Metre
) -> Metre | None:
    """The preferred diameter nearest to `ideal` that touches between the circles `flank` and stands clear of the root and proud of the tip.

    None where there is no such diameter.
    """
    with untraced():
        for D in sorted(PREFERRED, key=lambda D: abs(D - ideal)):
            if suits(system, z, s_t, d, d_b, flank, d_f, D):
                break
            if not ideal / 3 < D < 3 * ideal:  # nothing beyond touches the flank near its middle
                return None
        else:
            return None
    return nearest_preferred(D=based_on(D, z, s_t, d, d_b, flank, d_f), D_y=ideal)


def suits(system: ToothSystem, z: Number, s_t: Metre, d: Metre, d_b: Metre, flank: tuple[Metre, Metre], d_f: Metre, D_M: Metre) -> bool:
    """Whether a ball touches both flanks between these circles, clear of the root and proud of the tip."""
    there = seat(system, z, s_t, d, d_b, D_M)
    return there is not None and flank[0] < there.d_y < flank[1] and there.d_K + D_M > flank[1] and there.d_K - D_M > d_f


def seat(system: ToothSystem, z: Number, s_t: Metre, d: Metre, d_b: Metre, D_M: Metre) -> Seat | None:
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
