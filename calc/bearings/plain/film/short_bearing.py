# SPDX-License-Identifier: Apache-2.0
"""The infinitely short bearing with half a film: Reynolds' equation with the pressure's flow around the shaft left out.

Pressure parabolic across, p ~ sin θ/(1 + ε·cos θ)³ around, only from the widest film (θ = 0) to the narrowest (θ = π).
The load comes out too high, against the direct solution within 2 % at l/d 0.1 and ε up to 0.2, 3 % at 0.5, and far too
high for l/d above a quarter at high ε: a route of comparison, and the shape of the pressure around the seat.

Sources: F. W. Ocvirk, NACA TN 2808 (1952); G. B. DuBois and F. W. Ocvirk, NACA Report 1157 (1953).
"""

import numpy as np

from ....sheet.arrays import Array
from ....sheet.formula import formula
from ....sheet.functions import acos, atan, cos, pi, sin, single_or_many, sqrt
from ....sheet.text import Text
from ....sheet.units import Number, Pascal, Radian

OCVIRK = Text("Ocvirk 1952: short bearing, half a film")
DUBOIS = Text("DuBois & Ocvirk 1953: short bearing, half a film")
STEP_LIMIT = 1e-12  # of Newton's method, relative
ITERATION_LIMIT = 100  # a supply pressure next to the peak asks for most: there Newton only halves the distance


@formula("So", OCVIRK, names={"b": "(l/d)"})
def sommerfeld_din(eps: Number, b: Number) -> Number:
    """So = P·ψ²/(μ·ω), for 0 < ε < 1."""
    return b**2 * eps * sqrt(pi**2 * (1 - eps**2) + 16 * eps**2) / (2 * (1 - eps**2) ** 2)


@formula("ε", DUBOIS, shows="ε from 1/(2π·S) = So(ε, l/d) of the short bearing, by Newton's method", names={"b": "l/d"})
def eccentricity(S: Number, b: Number) -> Number:
    """For any S > 0; float or array.

    With t = ε²/(1 − ε²) the load is (2·So/b²)² = t·(1 + t)²·(π² + 16·t).  Its logarithm over u = ln t is convex and
    rises with a slope between 1 and 4, so that Newton's method from the right of the root falls onto it and cannot
    miss."""
    y = 2 * np.log(1 / (pi * np.asarray(S, dtype=float) * np.square(b)))
    # where one term alone carries all: on the right of the root
    u = np.minimum(y - np.log(pi**2), (y - np.log(16.0)) / 4)
    for _ in range(ITERATION_LIMIT):
        t = np.exp(u)
        error = u + 2 * np.log1p(t) + np.log(pi**2 + 16 * t) - y
        step = error / (1 + 2 * t / (1 + t) + 16 * t / (pi**2 + 16 * t))
        u = u - step
        if not (np.abs(step) > STEP_LIMIT).any():
            break
    eps = 1 / np.sqrt(1 + np.exp(-u))
    return single_or_many(np.asarray(eps))


@formula("φ", OCVIRK)
def attitude_angle(eps: Number) -> Radian:
    """From the load line to the narrowest film, in the sense of rotation: 90° for a centred journal, 0 for one that
    touches."""
    return atan(pi * sqrt(1 - eps**2) / (4 * eps))


@formula("Q/(r·c·n·l)", OCVIRK)
def relative_flow(eps: Number) -> Number:
    """What is dragged through the widest film."""
    return pi * (1 + eps)


@formula("Q_s/(r·c·n·l)", OCVIRK)
def relative_side_flow(eps: Number) -> Number:
    """What leaves over both edges: the oil dragged through the widest film less that through the narrowest."""
    return 2 * pi * eps


@formula("Q_s/Q", OCVIRK)
def side_flow_share(eps: Number) -> Number:
    return 2 * eps / (1 + eps)


@formula("c_rr", OCVIRK + "; squeeze term 12·∂h/∂t in the same half film")
def radial_damping(eps: Number) -> Number:
    """C_rr·c·ω/F of a journal that moves along its eccentricity; from −∫cos²θ/h³ over the half film, π·(1 + 2ε²)/(2·(1
    − ε²)^2.5)."""
    return 2 * pi * (1 + 2 * eps**2) / (eps * sqrt(1 - eps**2) * sqrt(pi**2 * (1 - eps**2) + 16 * eps**2))


@formula("θ_m", Text("{ocvirk}; where sin θ/(1 + ε·cos θ)³ is largest", ocvirk=OCVIRK))
def angle_of_largest_pressure(eps: Number) -> Radian:
    """From the widest film: 90° for a centred journal, towards 180° for one that touches."""
    return acos((1 - sqrt(1 + 24 * eps**2)) / (4 * eps))


@formula("p_O/(μ·ω/ψ²)", Text("{ocvirk}; middle plane", ocvirk=OCVIRK), names={"b": "(l/d)", "theta_m": "θ_m"})
def largest_relative_pressure(eps: Number, b: Number, theta_m: Radian) -> Number:
    return 3 * b**2 * eps * sin(theta_m) / (1 + eps * cos(theta_m)) ** 3


@formula("p/p_max", "definition of the pressure ratio, short bearing", names={"largest": "(p_O/(μ·ω/ψ²))"})
def pressure_ratio(So: Number, largest: Number) -> Number:
    """Specific load over largest pressure."""
    return So / largest


@formula("p(θ)", Text("{ocvirk}; middle plane", ocvirk=OCVIRK), unit="MPa")
def middle_pressure(p_max: Pascal, eps: Number, theta: Radian, theta_m: Radian) -> Pascal:
    """θ from the widest film along the rotation, 0 to π; beyond the narrowest film there is no pressure (and here no
    meaning)."""
    return p_max * sin(theta) / sin(theta_m) * ((1 + eps * cos(theta_m)) / (1 + eps * cos(theta))) ** 3


def blocked_ends(eps: float | Array, share: float | Array) -> tuple[Array, Array]:
    """Where the pressure of the middle plane passes `share` of its peak, before and after it: θ from the widest film,
    rad.

    Nowhere (both ends at the peak) where the share is 1 or more; the whole half turn where it is 0.  In Sommerfeld's
    angle γ, 1 + ε·cos θ = (1 − ε²)/(1 − ε·cos γ), the shape is sin γ·(1 − ε·cos γ)², whose logarithm is concave:
    Newton's method from outside comes up to each end and cannot pass it."""
    eps, share = np.broadcast_arrays(np.asarray(eps, dtype=float), np.asarray(share, dtype=float))
    # d/dγ of the shape's logarithm vanishes where 3·ε·x² − x − 2·ε = 0, x = cos γ
    peak = np.arccos((1 - np.sqrt(1 + 24 * eps**2)) / (6 * eps))
    height = np.sin(peak) * (1 - eps * np.cos(peak)) ** 2
    level = np.log(np.clip(share, 1e-300, 1.0) * height)
    ends = []
    for sign, limit in ((1, peak), (-1, pi - peak)):  # from γ = 0 upwards, and from γ = π downwards
        e = sign * eps
        x = np.exp(level) / (1 + eps) ** 2  # sin γ <= γ and 1 − ε·cos γ <= 1 + ε: never beyond the end
        for _ in range(ITERATION_LIMIT):
            wide = 1 - e * np.cos(x)
            slope = 1 / np.tan(x) + 2 * e * np.sin(x) / wide
            step = (level - np.log(np.sin(x)) - 2 * np.log(wide)) / np.where(slope > 0, slope, np.inf)
            x = np.minimum(x + step, limit)
            if not (step > 1e-10).any():
                break
        x = np.where(share >= 1, limit, np.where(share <= 0, 0.0, x))
        gamma = x if sign > 0 else pi - x
        ends.append(2 * np.arctan2(np.sqrt((1 + eps) / (1 - eps)) * np.sin(gamma / 2), np.cos(gamma / 2)))
    return ends[0], ends[1]


@formula(
    "β_p",
    Text("{ocvirk}; its pressure in the middle plane", ocvirk=OCVIRK),
    shows="arc around the seat over which p(θ) of the middle plane exceeds p_s",
)
def blocked_arc(eps: Number, p_s: Pascal, p_max: Pascal) -> Radian:
    """The arc over which the film's own pressure keeps the supply out: 0 where p_s reaches p_max, half a turn where p_s
    is zero.

    `p_max` is best the short bearing's own largest pressure: the arc is then 5 to 9 % smaller than the direct
    solution's, at l/d 0.25 to 1, ε 0.5 to 0.87 and p_s of 0.4 under loads of 0.8 to 2 MPa.  With the finite bearing's
    lower peak it is 11 to 39 % too small, since the finite bearing's pressure falls more slowly from its peak.  Float
    or array."""
    first, last = blocked_ends(eps, p_s / p_max)
    arc = last - first
    return single_or_many(np.asarray(arc))
