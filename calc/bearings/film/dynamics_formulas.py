# SPDX-License-Identifier: Apache-2.0
"""Stiffness, damping, stability and orbit of a journal on its film, as lines of the calculation.

X points along the load, Y 90° further in the sense in which the film is dragged; K_ij and C_ij are the force on the film along i for a
displacement or velocity along j.  g is the diametral clearance, ω the effective hydrodynamic speed.
"""

import numpy as np

from ...sheet.abreast import design_by_design
from ...sheet.formula import formula
from ...sheet.functions import cos, modulus, pi, sin, sqrt
from ...sheet.text import Text
from ...sheet.units import (
    Kilogram,
    Metre,
    Newton,
    NewtonPerMetre,
    NewtonSecondPerMetre,
    Number,
    PhasorMetre,
    PhasorNewtonPerMetre,
    Radian,
    RadPerSecond,
    RevPerSecond,
)  # fmt: skip
from . import tabulated

TABLE = Text("Reynolds 1886, full bearing with Swift–Stieber film end; this program's own solution, tabulated")
TURNED = Text("hydrodynamics, displaced journal: the film's force turns with the line of centres (rotational symmetry of the seat)")
WHIRL = Text("hydrodynamics, a moving line of centres acts as the effective speed ω − 2·dφ/dt; damping is symmetric")
SCALE = Text("definition of the dimensionless coefficient, k = K·c/F and c = C·c·ω/F")
LUND = Text("Lund 1966, Self-excited stationary whirl orbits of a journal in a sleeve bearing: rigid shaft")
FRAME = Text("(K + i·Ω·C)·x = F_0 in the load's frame, where F_0 = R_0·(1, −i) turns at Ω; the shaft's acceleration seen from that frame")
IMPEDANCE = Text("dynamics: impedance of film and mass; {frame}", frame=FRAME)
MOTION = Text("dynamics: motion of the journal about its place under the load; {frame}", frame=FRAME)


# --- dimensionless, over the load ---------------------------------------------------------------------------------------------
@formula("(ln So)'", TABLE, shows="d ln So/dε at constant l/d, from the table of Reynolds' solutions")
def load_slope(eps: Number, b: Number) -> Number:
    return tabulated.film_slopes(eps, b)[0]


@formula("φ'", TABLE, shows="dφ/dε at constant l/d, from the table of Reynolds' solutions")
def attitude_slope(eps: Number, b: Number) -> Number:
    return tabulated.film_slopes(eps, b)[1]


@formula("c_rr", TABLE, shows="squeeze solution (12·∂h/∂t, film region of the static state), from the table at ε, l/d")
def radial_damping(eps: Number, b: Number) -> Number:
    """C_rr·c·ω/F of a journal that moves along its eccentricity."""
    return tabulated.film_at(eps, b).radial_damping


@formula("k_xx", TURNED, names={"q": "(ln So)'"})
def k_xx(q: Number, phi: Radian) -> Number:
    return q * cos(phi)


@formula("k_xy", TURNED, names={"q": "(ln So)'"})
def k_xy(q: Number, phi: Radian) -> Number:
    return q * sin(phi)


@formula("k_yx", TURNED, names={"a": "φ'"})
def k_yx(eps: Number, phi: Radian, a: Number) -> Number:
    return -sin(phi) / eps - a * cos(phi)


@formula("k_yy", TURNED, names={"a": "φ'"})
def k_yy(eps: Number, phi: Radian, a: Number) -> Number:
    return cos(phi) / eps - a * sin(phi)


@formula("c_xx", WHIRL)
def c_xx(c_rr: Number, eps: Number, phi: Radian) -> Number:
    return c_rr * cos(phi) ** 2 + 2 * sin(phi) * (1 + cos(phi) ** 2) / eps


@formula("c_xy", WHIRL)
def c_xy(c_rr: Number, eps: Number, phi: Radian) -> Number:
    return c_rr * sin(phi) * cos(phi) - 2 * cos(phi) ** 3 / eps


@formula("c_yy", WHIRL)
def c_yy(c_rr: Number, eps: Number, phi: Radian) -> Number:
    return c_rr * sin(phi) ** 2 - 2 * sin(phi) * cos(phi) ** 2 / eps


@formula(
    "k",
    "Reynolds 1886, bearing with axial grooves: central differences of the film's force",
    shows="k or c of the film with its grooves at ε",
)
def grooved_coefficient(value: Number, eps: Number, b: Number) -> Number:
    """`value` is found from the others and the grooves."""
    return value


# --- with their units ---------------------------------------------------------------------------------------------------------
@formula("K_xx", SCALE)
def stiffness_xx(k_xx: Number, F: Newton, g: Metre) -> NewtonPerMetre:
    return k_xx * F / (g / 2)


@formula("K_xy", SCALE)
def stiffness_xy(k_xy: Number, F: Newton, g: Metre) -> NewtonPerMetre:
    return k_xy * F / (g / 2)


@formula("K_yx", SCALE)
def stiffness_yx(k_yx: Number, F: Newton, g: Metre) -> NewtonPerMetre:
    return k_yx * F / (g / 2)


@formula("K_yy", SCALE)
def stiffness_yy(k_yy: Number, F: Newton, g: Metre) -> NewtonPerMetre:
    return k_yy * F / (g / 2)


@formula("C_xx", SCALE)
def damping_xx(c_xx: Number, F: Newton, g: Metre, omega: RadPerSecond) -> NewtonSecondPerMetre:
    return c_xx * F / (g / 2 * omega)


@formula("C_xy", SCALE)
def damping_xy(c_xy: Number, F: Newton, g: Metre, omega: RadPerSecond) -> NewtonSecondPerMetre:
    """C_yx is the same."""
    return c_xy * F / (g / 2 * omega)


@formula("C_yy", SCALE)
def damping_yy(c_yy: Number, F: Newton, g: Metre, omega: RadPerSecond) -> NewtonSecondPerMetre:
    return c_yy * F / (g / 2 * omega)


# --- stability ----------------------------------------------------------------------------------------------------------------
@formula("k_eq", LUND)
def equivalent_stiffness(k_xx: Number, k_xy: Number, k_yx: Number, k_yy: Number, c_xx: Number, c_xy: Number, c_yy: Number) -> Number:
    return (k_xx * c_yy + k_yy * c_xx - k_xy * c_xy - k_yx * c_xy) / (c_xx + c_yy)


@formula("γ²", LUND)
def whirl_ratio_squared(
    k_eq: Number, k_xx: Number, k_xy: Number, k_yx: Number, k_yy: Number, c_xx: Number, c_xy: Number, c_yy: Number
) -> Number:
    """Square of the whirl's frequency over ω at the threshold, for a load that stands; negative: no mass makes the shaft unstable."""
    return ((k_eq - k_xx) * (k_eq - k_yy) - k_xy * k_yx) / (c_xx * c_yy - c_xy**2)


@formula("γ", LUND, names={"square": "γ²"})
def whirl_ratio(square: Number) -> Number:
    return sqrt(square)


@formula("m_c", LUND, names={"square": "γ²"})
def critical_mass(k_eq: Number, square: Number, F: Newton, g: Metre, omega: RadPerSecond) -> Kilogram:
    """The bearing's share of a rigid shaft's mass beyond which it whirls, for a load that stands."""
    return k_eq / square * F / (g / 2 * omega**2)


@formula(
    "m_c",
    "dynamics: Routh–Hurwitz on m·(s² − 2·Ω·J·s − Ω²) + C·s + K, the shaft's motion seen from the load, past which what stands turns at Ω",
    shows="smallest mass at which a root s of |m·(s² − 2·Ω·J·s − Ω²) + C·s + K| = 0 reaches the imaginary axis",
)
def critical_mass_turning(
    k_xx: Number, k_xy: Number, k_yx: Number, k_yy: Number, c_xx: Number, c_xy: Number, c_yy: Number, F: Newton, g: Metre,
    omega: RadPerSecond, Omega: RadPerSecond,
) -> Kilogram:  # fmt: skip
    """The bearing's share of a rigid shaft's mass beyond which its place under the turning load is lost; infinite where none is.

    At Ω = 0 this is Lund's.  J turns by 90° from X to Y.  One bearing at a time.
    """
    f = -Omega / omega  # the load's own speed
    return _least_mass(f, k_xx, k_xy, k_yx, k_yy, c_xx, c_xy, c_yy) * F / (g / 2 * omega**2)


@design_by_design
def _least_mass(
    f: Number, k_xx: Number, k_xy: Number, k_yx: Number, k_yy: Number, c_xx: Number, c_xy: Number, c_yy: Number
) -> Number:  # fmt: skip
    """The smallest mass, over F/(c·ω²), at which a root reaches the imaginary axis."""
    det = k_xx * k_yy - k_xy * k_yx
    # coefficients of s³ to s⁰, those of s³ and s⁴ without their factors m and m²; polynomials of m over F/(c·ω²), highest power first
    a3 = c_xx + c_yy
    a2 = np.array([2 * f**2, k_xx + k_yy, c_xx * c_yy - c_xy**2])
    a1 = np.array([-(f**2) * a3 - 2 * f * (k_xy - k_yx), c_xx * k_yy + c_yy * k_xx - c_xy * (k_xy + k_yx)])
    a0 = np.array([f**4, -(f**2) * (k_xx + k_yy), det])
    hurwitz = a3 * np.convolve(a1, a2) - np.append(np.convolve(a1, a1) + a3**2 * a0, 0.0)
    roots = np.concatenate([np.roots(hurwitz), np.roots(a0)])
    real = roots.real[(np.abs(roots.imag) < 1e-9 * np.abs(roots)) & (roots.real > 0)]
    return float(real.min(initial=np.inf))


@formula("n_c", "dynamics, rigid shaft at the present eccentricity: threshold speed over speed is √(m_c/m)", unit="rpm")
def threshold_speed(n_h: RevPerSecond, m_c: Kilogram, m: Kilogram) -> RevPerSecond:
    """For a load that stands."""
    return n_h * sqrt(m_c / m)


# --- orbit --------------------------------------------------------------------------------------------------------------------
@formula(
    "Ω", "kinematics: speed of a force that stands still, seen from the turning load, positive in the sense in which the film is dragged"
)
def relative_speed(sense: Number, n_F: RevPerSecond) -> RadPerSecond:
    return -sense * 2 * pi * n_F


@formula("Z_xx", IMPEDANCE)
def impedance_xx(K_xx: NewtonPerMetre, C_xx: NewtonSecondPerMetre, Omega: RadPerSecond, m: Kilogram) -> PhasorNewtonPerMetre:
    return K_xx + 1j * Omega * C_xx - 2 * m * Omega**2


@formula("Z_xy", IMPEDANCE)
def impedance_xy(K_xy: NewtonPerMetre, C_xy: NewtonSecondPerMetre, Omega: RadPerSecond, m: Kilogram) -> PhasorNewtonPerMetre:
    return K_xy + 1j * Omega * C_xy + 2j * m * Omega**2


@formula("Z_yx", IMPEDANCE)
def impedance_yx(K_yx: NewtonPerMetre, C_xy: NewtonSecondPerMetre, Omega: RadPerSecond, m: Kilogram) -> PhasorNewtonPerMetre:
    return K_yx + 1j * Omega * C_xy - 2j * m * Omega**2


@formula("Z_yy", IMPEDANCE)
def impedance_yy(K_yy: NewtonPerMetre, C_yy: NewtonSecondPerMetre, Omega: RadPerSecond, m: Kilogram) -> PhasorNewtonPerMetre:
    return K_yy + 1j * Omega * C_yy - 2 * m * Omega**2


@formula("x", MOTION, unit="µm")
def motion_x(
    R_0: Newton, Z_xx: PhasorNewtonPerMetre, Z_xy: PhasorNewtonPerMetre, Z_yx: PhasorNewtonPerMetre, Z_yy: PhasorNewtonPerMetre
) -> PhasorMetre:
    return R_0 * (Z_yy + 1j * Z_xy) / (Z_xx * Z_yy - Z_xy * Z_yx)


@formula("y", MOTION, unit="µm")
def motion_y(
    R_0: Newton, Z_xx: PhasorNewtonPerMetre, Z_xy: PhasorNewtonPerMetre, Z_yx: PhasorNewtonPerMetre, Z_yy: PhasorNewtonPerMetre
) -> PhasorMetre:
    return -R_0 * (1j * Z_xx + Z_yx) / (Z_xx * Z_yy - Z_xy * Z_yx)


@formula("a_o", "geometry, ellipse of the two motions: half its length", unit="µm")
def major_axis(x: PhasorMetre, y: PhasorMetre) -> Metre:
    return modulus(x + 1j * y) / 2 + modulus(x - 1j * y) / 2


@formula("b_o", "geometry, ellipse of the two motions: half its width", unit="µm")
def minor_axis(x: PhasorMetre, y: PhasorMetre) -> Metre:
    return modulus(modulus(x + 1j * y) - modulus(x - 1j * y)) / 2


@formula("a_n", "geometry: amplitude of the motion towards the narrowest film", unit="µm")
def film_loss(x: PhasorMetre, y: PhasorMetre, phi: Radian) -> Metre:
    """By how much the smallest film shrinks over a turn, to first order."""
    return modulus(x * cos(phi) + y * sin(phi))
