# SPDX-License-Identifier: Apache-2.0
"""The journal on its film as a spring and damper: eight coefficients, the threshold of stability, the orbit.

The orbit is that under a standing force.  First every formula as a line of the calculation, then what is solved with
them.

The seat is round, so that the film's force depends on the eccentricity alone and turns with the line of centres: the
four stiffnesses follow from So(ε) and φ(ε).  A line of centres that turns acts like a slower drag, ω − 2·dφ/dt, which
gives the damping across; the matrix of damping is symmetric; only the damping along the eccentricity asks for a
solution of its own (`reynolds.radial_damping`).

Coordinates: X along the load, Y 90° further in the sense in which the film is dragged past the load.  A load that turns
with the shaft is looked at from its own frame: there the seat turns backward, so that "further" is against the shaft,
and all speeds are those of the effective speed |n_J + n_B − 2·n_F|.

Range: that of `table`; motions small against the smallest film.  The film is fed at its widest place, wherever the
journal goes. Accuracy: 1e-3 in the stiffnesses and damping of the table.

Sources: J. W. Lund, ASME J. Tribology 109 (1987) 37-41 (the coefficients and what they are used for); J. W. Lund,
Self-excited, stationary whirl orbits of a journal in a sleeve bearing, thesis, Rensselaer 1966 (threshold of the rigid
shaft)."""

from typing import Any, Generic

import numpy as np

from ....sheet.arrays import Value
from ....sheet.formula import formula
from ....sheet.functions import cos, modulus, pi, sin, sqrt
from ....sheet.quantity import result, value
from ....sheet.record import record
from ....sheet.shown import Shown
from ....sheet.text import Text
from ....sheet.units import (
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
)
from ....sheet.value import based_on
from .. import formulas as f
from ..routes.states import BearingCase, Film, OperatingPoint
from . import table
from .grooved import film_at

# --- the formulas
# X points along the load, Y 90° further in the sense in which the film is dragged; K_ij and C_ij are the force on the
# film along i for a displacement or velocity along j.  g is the diametral clearance, ω the effective hydrodynamic
# speed.

TABLE = Text("Reynolds 1886, full bearing with Swift–Stieber film end; this program's own solution, tabulated")
TURNED = Text(
    "hydrodynamics, displaced journal: the film's force turns with the line of centres (rotational symmetry of the "
    "seat)"
)
WHIRL = Text("hydrodynamics, a moving line of centres acts as the effective speed ω − 2·dφ/dt; damping is symmetric")
SCALE = Text("definition of the dimensionless coefficient, k = K·c/F and c = C·c·ω/F")
LUND = Text("Lund 1966, Self-excited stationary whirl orbits of a journal in a sleeve bearing: rigid shaft")
FRAME = Text(
    "(K + i·Ω·C)·x = F_0 in the load's frame, where F_0 = R_0·(1, −i) turns at Ω; the shaft's acceleration seen from "
    "that frame"
)
IMPEDANCE = Text("dynamics: impedance of film and mass; {frame}", frame=FRAME)
MOTION = Text("dynamics: motion of the journal about its place under the load; {frame}", frame=FRAME)
Impedance = PhasorNewtonPerMetre


# --- dimensionless, over the load


@formula(
    "(ln So)'", TABLE, shows="d ln So/dε at constant l/d, from the table of Reynolds' solutions", names={"b": "l/d"}
)
def load_slope(eps: Number, b: Number) -> Number:
    return table.traced_film_slopes(eps, b)[0]


@formula("φ'", TABLE, shows="dφ/dε at constant l/d, from the table of Reynolds' solutions", names={"b": "l/d"})
def attitude_slope(eps: Number, b: Number) -> Number:
    return table.traced_film_slopes(eps, b)[1]


@formula(
    "c_rr",
    TABLE,
    shows="squeeze solution (12·∂h/∂t, film region of the static state), from the table at ε, l/d",
    names={"b": "l/d"},
)
def radial_damping(eps: Number, b: Number) -> Number:
    """C_rr·c·ω/F of a journal that moves along its eccentricity."""
    return table.traced_film_at(eps, b).radial_damping


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


# --- with their units


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


# --- stability


@formula("k_eq", LUND)
def equivalent_stiffness(
    k_xx: Number, k_xy: Number, k_yx: Number, k_yy: Number, c_xx: Number, c_xy: Number, c_yy: Number
) -> Number:
    return (k_xx * c_yy + k_yy * c_xx - k_xy * c_xy - k_yx * c_xy) / (c_xx + c_yy)


@formula("γ²", LUND)
def whirl_ratio_squared(
    k_eq: Number, k_xx: Number, k_xy: Number, k_yx: Number, k_yy: Number, c_xx: Number, c_xy: Number, c_yy: Number
) -> Number:
    """Square of the whirl's frequency over ω at the threshold, for a load that stands; negative: no mass makes the
    shaft unstable."""
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
    "dynamics: Routh–Hurwitz on m·(s² − 2·Ω·J·s − Ω²) + C·s + K, the shaft's motion seen from the load, past which "
    "what stands turns at Ω",
    shows="smallest mass at which a root s of |m·(s² − 2·Ω·J·s − Ω²) + C·s + K| = 0 reaches the imaginary axis",
)
def critical_mass_turning(
    k_xx: Number,
    k_xy: Number,
    k_yx: Number,
    k_yy: Number,
    c_xx: Number,
    c_xy: Number,
    c_yy: Number,
    F: Newton,
    g: Metre,
    omega: RadPerSecond,
    Omega: RadPerSecond,
) -> Kilogram:
    """The bearing's share of a rigid shaft's mass beyond which its place under the turning load is lost; infinite where
    none is.

    At Ω = 0 this is Lund's.  J turns by 90° from X to Y.  One bearing at a time.
    """
    f = -Omega / omega  # the load's own speed
    det = k_xx * k_yy - k_xy * k_yx
    # coefficients of s³ to s⁰, those of s³ and s⁴ without their factors m and m²; polynomials of m over F/(c·ω²),
    # highest power first
    a3 = c_xx + c_yy
    a2 = np.array([2 * f**2, k_xx + k_yy, c_xx * c_yy - c_xy**2])
    a1 = np.array([-(f**2) * a3 - 2 * f * (k_xy - k_yx), c_xx * k_yy + c_yy * k_xx - c_xy * (k_xy + k_yx)])
    a0 = np.array([f**4, -(f**2) * (k_xx + k_yy), det])
    hurwitz = a3 * np.convolve(a1, a2) - np.append(np.convolve(a1, a1) + a3**2 * a0, 0.0)
    roots = np.concatenate([np.roots(hurwitz), np.roots(a0)])
    real = roots.real[(np.abs(roots.imag) < 1e-9 * np.abs(roots)) & (roots.real > 0)]
    return float(real.min(initial=np.inf)) * F / (g / 2 * omega**2)


@formula("n_c", "dynamics, rigid shaft at the present eccentricity: threshold speed over speed is √(m_c/m)", unit="rpm")
def threshold_speed(n_h: RevPerSecond, m_c: Kilogram, m: Kilogram) -> RevPerSecond:
    """For a load that stands."""
    return n_h * sqrt(m_c / m)


# --- orbit


@formula(
    "Ω",
    "kinematics: speed of a force that stands still, seen from the turning load, positive in the sense in which the "
    "film is dragged",
    meanings={"sense": "Sense in which the film is dragged, 1 or −1"},
)
def relative_speed(sense: Number, n_F: RevPerSecond) -> RadPerSecond:
    return -sense * 2 * pi * n_F


@formula("Z_xx", IMPEDANCE, meanings={"m": "Mass that the journal carries along"})
def impedance_xx(K_xx: NewtonPerMetre, C_xx: NewtonSecondPerMetre, Omega: RadPerSecond, m: Kilogram) -> Impedance:
    return K_xx + 1j * Omega * C_xx - 2 * m * Omega**2


@formula("Z_xy", IMPEDANCE, meanings={"m": "Mass that the journal carries along"})
def impedance_xy(K_xy: NewtonPerMetre, C_xy: NewtonSecondPerMetre, Omega: RadPerSecond, m: Kilogram) -> Impedance:
    return K_xy + 1j * Omega * C_xy + 2j * m * Omega**2


@formula("Z_yx", IMPEDANCE, meanings={"m": "Mass that the journal carries along"})
def impedance_yx(K_yx: NewtonPerMetre, C_xy: NewtonSecondPerMetre, Omega: RadPerSecond, m: Kilogram) -> Impedance:
    return K_yx + 1j * Omega * C_xy - 2j * m * Omega**2


@formula("Z_yy", IMPEDANCE, meanings={"m": "Mass that the journal carries along"})
def impedance_yy(K_yy: NewtonPerMetre, C_yy: NewtonSecondPerMetre, Omega: RadPerSecond, m: Kilogram) -> Impedance:
    return K_yy + 1j * Omega * C_yy - 2 * m * Omega**2


@formula("x", MOTION, unit="µm")
def motion_x(R_0: Newton, Z_xx: Impedance, Z_xy: Impedance, Z_yx: Impedance, Z_yy: Impedance) -> PhasorMetre:
    return R_0 * (Z_yy + 1j * Z_xy) / (Z_xx * Z_yy - Z_xy * Z_yx)


@formula("y", MOTION, unit="µm")
def motion_y(R_0: Newton, Z_xx: Impedance, Z_xy: Impedance, Z_yx: Impedance, Z_yy: Impedance) -> PhasorMetre:
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


# --- the coefficients and the orbit of one bearing


@record
class Coefficients(Generic[Value]):
    """K_ij·c/F and C_ij·c·ω/F; floats, or arrays of many bearings.  c_yx is c_xy."""

    k_xx: Value
    k_xy: Value
    k_yx: Value
    k_yy: Value
    c_xx: Value
    c_xy: Value
    c_yy: Value


@result
class Dynamics(Shown, Generic[Value]):
    """Stiffness and damping of the film as judged, and the mass of shaft it can hold.

    `critical_mass` None: no mass makes the shaft unstable.  `whirl_ratio` and `threshold_speed` are there for a load
    that stands; under a load that turns with the shaft the threshold is that of the place in the load's frame, which no
    single speed marks, since the load grows with it."""

    stiffness_xx: Value = value("Stiffness along the load", "N/m", "K_xx")
    stiffness_xy: Value = value("Stiffness along the load, displaced across it", "N/m", "K_xy")
    stiffness_yx: Value = value("Stiffness across the load, displaced along it", "N/m", "K_yx")
    stiffness_yy: Value = value("Stiffness across the load", "N/m", "K_yy")
    damping_xx: Value = value("Damping along the load", "N·s/m", "C_xx")
    damping_xy: Value = value("Damping along the load, moving across it", "N·s/m", "C_xy")
    damping_yx: Value = value("Damping across the load, moving along it", "N·s/m", "C_yx")
    damping_yy: Value = value("Damping across the load", "N·s/m", "C_yy")
    whirl_ratio: Number | None = value("Whirl at the threshold over the speed", "", "γ", default=None)
    critical_mass: Kilogram | None = value(
        "Mass of shaft on this bearing that its film just holds", "kg", "m_c", default=None
    )
    threshold_speed: RevPerSecond | None = value("Speed at which the shaft begins to whirl", "rpm", "n_c", default=None)


@record
class Orbit(Generic[Value]):
    """The journal's ellipse about its place in the load's frame, to first order; floats or arrays."""

    amplitude: Value  # half the length
    minor: Value  # half the width
    film_loss: Value  # how far it comes towards the narrowest film


def coefficients(eps: Value, b: Value, phi: Value | None = None) -> Coefficients[Value]:
    """The coefficients over the load at ε and l/d; `phi`: φ where a line of the calculation has it already.  Floats or
    arrays.

    Raises FilmRangeError outside the table.
    """
    phi = table.attitude_angle(eps=eps, b=b) if phi is None else phi
    q, a = load_slope(eps=eps, b=b), attitude_slope(eps=eps, b=b)
    c_rr = radial_damping(eps=eps, b=b)
    return Coefficients(
        k_xx=k_xx(q=q, phi=phi),
        k_xy=k_xy(q=q, phi=phi),
        k_yx=k_yx(eps=eps, phi=phi, a=a),
        k_yy=k_yy(eps=eps, phi=phi, a=a),
        c_xx=c_xx(c_rr=c_rr, eps=eps, phi=phi),
        c_xy=c_xy(c_rr=c_rr, eps=eps, phi=phi),
        c_yy=c_yy(c_rr=c_rr, eps=eps, phi=phi),
    )


def dynamics(
    hot: Film, duty: OperatingPoint, seat: BearingCase, ratio: Number, *, mass: Kilogram | None = None
) -> Dynamics:
    """The film as a spring and damper.  `ratio`: l/d of the film (of one land, where a groove parts it); `mass`: the
    bearing's share of the shaft's, for the threshold speed."""
    F, g, eps = duty.load, hot.clearance, hot.eccentricity
    if seat.grooves is None:
        k = coefficients(eps, ratio, hot.attitude)
    else:  # a film that axial grooves bound does not turn with the line of centres
        at, names = film_at(eps, ratio, seat.grooves), Coefficients.__dataclass_fields__
        k = Coefficients(**{name: grooved_coefficient(value=getattr(at, name), eps=eps, b=ratio) for name in names})
    omega = f.angular_speed(n=duty.effective_speed)
    n_F, sense = _load_speed(duty, seat)
    whirl = heaviest = threshold = None
    if n_F == 0.0:
        k_eq = equivalent_stiffness(**vars(k))
        square = whirl_ratio_squared(k_eq, **vars(k))
        if square > 0:
            whirl = whirl_ratio(square=square)
            heaviest = critical_mass(k_eq=k_eq, square=square, F=F, g=g, omega=omega)
            threshold = None if mass is None else threshold_speed(n_h=duty.effective_speed, m_c=heaviest, m=mass)
    else:
        Omega = relative_speed(sense=sense, n_F=n_F)
        heaviest = critical_mass_turning(**vars(k), F=F, g=g, omega=omega, Omega=Omega)
        heaviest = None if heaviest == float("inf") else heaviest
    across = damping_xy(c_xy=k.c_xy, F=F, g=g, omega=omega)
    return Dynamics(
        stiffness_xx=stiffness_xx(k_xx=k.k_xx, F=F, g=g),
        stiffness_xy=stiffness_xy(k_xy=k.k_xy, F=F, g=g),
        stiffness_yx=stiffness_yx(k_yx=k.k_yx, F=F, g=g),
        stiffness_yy=stiffness_yy(k_yy=k.k_yy, F=F, g=g),
        damping_xx=damping_xx(c_xx=k.c_xx, F=F, g=g, omega=omega),
        damping_xy=across,
        damping_yx=across,
        damping_yy=damping_yy(c_yy=k.c_yy, F=F, g=g, omega=omega),
        whirl_ratio=whirl,
        critical_mass=heaviest,
        threshold_speed=threshold,
    )


def orbit(film: Dynamics[Value], R_0: Value, phi: Value, duty: OperatingPoint, seat: BearingCase[Any]) -> Orbit[Value]:
    """What a force that stands still does to a journal that is held by a turning load at the attitude angle φ."""
    n_F, sense = _load_speed(duty, seat)
    return orbit_of(film, R_0, relative_speed(sense=sense, n_F=n_F), phi)


def orbit_of(film: Dynamics[Value], R_0: Value, Omega: RadPerSecond, phi: Value, mass: Kilogram = 0.0) -> Orbit[Value]:
    """The same for a force that turns at Ω in the load's frame, positive in the sense in which the film is dragged.

    The shaft's inertia: what stands still is not accelerated, so that of the ellipse only the part that turns against
    the force counts, with 4·Ω²·m: one part in a hundred of the stiffness for a balance shaft of some kilograms on films
    of 10 µm, hence mass 0 unless given."""
    Z_xx = impedance_xx(K_xx=film.stiffness_xx, C_xx=film.damping_xx, Omega=Omega, m=mass)
    Z_xy = impedance_xy(K_xy=film.stiffness_xy, C_xy=film.damping_xy, Omega=Omega, m=mass)
    Z_yx = impedance_yx(K_yx=film.stiffness_yx, C_xy=film.damping_yx, Omega=Omega, m=mass)
    Z_yy = impedance_yy(K_yy=film.stiffness_yy, C_yy=film.damping_yy, Omega=Omega, m=mass)
    x = motion_x(R_0=R_0, Z_xx=Z_xx, Z_xy=Z_xy, Z_yx=Z_yx, Z_yy=Z_yy)
    y = motion_y(R_0=R_0, Z_xx=Z_xx, Z_xy=Z_xy, Z_yx=Z_yx, Z_yy=Z_yy)
    return Orbit(amplitude=major_axis(x=x, y=y), minor=minor_axis(x=x, y=y), film_loss=film_loss(x=x, y=y, phi=phi))


def _load_speed(duty: OperatingPoint, seat: BearingCase[Any]) -> tuple[RevPerSecond, Number]:
    """The load's speed n_F, and +1 where n_J + n_B − 2·n_F is positive, −1 where the film is dragged against the
    journal's sense."""
    i_F, i_B = seat.inputs.load_speed_ratio, seat.inputs.bush_speed_ratio
    n_F = duty.speed if i_F == 1.0 else based_on(i_F * duty.speed, i_F, duty.speed)
    return n_F, 1.0 if 1.0 + i_B - 2.0 * i_F > 0.0 else -1.0
