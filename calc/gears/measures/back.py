# SPDX-License-Identifier: Apache-2.0
"""From a measured size back to the tooth: the generating shift that it means, and the change of the span, which is the allowance.

All routes lead over the generating shift x_E, so that they can be compared.  A chordal thickness is taken at the reference circle:
the calliper stands at the height above the chord, from a tip circle of the nominal diameter.
"""

from ...sheet.formula import formula
from ...sheet.functions import asin, cos, inv, pi, sin, tan
from ...sheet.units import Metre, Number, Radian
from ..formulas import ISO


@formula("x_E", f"{ISO}: generating shift of a measured span, from the base tangent length", names={"W": "W_K"})
def shift_of_span(W: Metre, m_n: Metre, alpha_n: Radian, K: Number, z: Number, alpha_t: Radian) -> Number:
    return (W / (m_n * cos(alpha_n)) - pi * (K - 0.5) - z * inv(alpha_t)) / (2 * tan(alpha_n))


@formula("d_K", f"{ISO}: circle of the centres, from the size over opposite balls or pins", unit="mm")
def centres_opposite(M: Metre, D_M: Metre) -> Metre:
    return M - D_M


@formula("d_K", f"{ISO}: circle of the centres, from the size over balls (spur: or pins), odd number of teeth", unit="mm")
def centres_odd(M: Metre, D_M: Metre, z: Number) -> Metre:
    return (M - D_M) / cos(pi / (2 * z))


@formula("s_t", f"{ISO}: transverse tooth thickness at the reference circle, from the circle of the centres", unit="mm")
def thickness_of_centres(d: Metre, alpha_K: Radian, alpha_t: Radian, D_M: Metre, d_b: Metre, beta_b: Radian, z: Number) -> Metre:
    return d * (inv(alpha_K) - inv(alpha_t) - D_M / (d_b * cos(beta_b)) + pi / z)


@formula("x_E", f"{ISO}: generating shift of a transverse tooth thickness at the reference circle")
def shift_of_thickness(s_t: Metre, beta: Radian, m_n: Metre, alpha_n: Radian) -> Number:
    return (s_t * cos(beta) / m_n - pi / 2) / (2 * tan(alpha_n))


@formula("ψ", f"{ISO}: half angle of the tooth on the virtual wheel, from a chordal thickness at the reference circle")
def angle_of_chord(s_c: Metre, z_v: Number, m_n: Metre) -> Radian:
    return asin(s_c / (z_v * m_n))


@formula("x_E", f"{ISO}: generating shift of a half angle on the virtual wheel")
def shift_of_half_angle(psi: Radian, z_v: Number, alpha_n: Radian) -> Number:
    return (psi * z_v - pi / 2) / (2 * tan(alpha_n))


@formula("E_W", f"{ISO}: change of the span that a generating shift means", unit="µm")
def span_change(x_E: Number, x: Number, m_n: Metre, alpha_n: Radian) -> Metre:
    return 2 * (x_E - x) * m_n * sin(alpha_n)
