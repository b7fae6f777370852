# SPDX-License-Identifier: Apache-2.0
"""The journal on its film as a spring and damper: eight coefficients, the threshold of stability, the orbit under a standing force.

The seat is round, so that the film's force depends on the eccentricity alone and turns with the line of centres: the four stiffnesses
follow from So(ε) and φ(ε).  A line of centres that turns acts like a slower drag, ω − 2·dφ/dt, which gives the damping across; the
matrix of damping is symmetric; only the damping along the eccentricity asks for a solution of its own (`reynolds.radial_damping`).

Coordinates: X along the load, Y 90° further in the sense in which the film is dragged past the load.  A load that turns with the shaft
is looked at from its own frame: there the seat turns backward, so that "further" is against the shaft, and all speeds are those of the
effective speed |n_J + n_B − 2·n_F|.

Range: that of `table`; motions small against the smallest film.  The film is fed at its widest place, wherever the journal goes.
Accuracy: 1e-3 in the stiffnesses and damping of the table.

Sources: J. W. Lund, ASME J. Tribology 109 (1987) 37-41 (the coefficients and what they are used for); J. W. Lund, Self-excited,
stationary whirl orbits of a journal in a sleeve bearing, thesis, Rensselaer 1966 (threshold of the rigid shaft).
"""

from ...sheet.quantity import result, value
from ...sheet.record import record
from ...sheet.units import Kilogram, Metre, Newton, NewtonPerMetre, NewtonSecondPerMetre, Number, Radian, RadPerSecond, RevPerSecond
from ...sheet.value import based_on
from .. import formulas as f
from ..routes.states import BearingCase, Film, OperatingPoint
from . import dynamics_formulas as d
from . import tabulated


@record
class Coefficients:
    """K_ij·c/F and C_ij·c·ω/F; floats, or arrays of many bearings.  c_yx is c_xy."""

    k_xx: Number
    k_xy: Number
    k_yx: Number
    k_yy: Number
    c_xx: Number
    c_xy: Number
    c_yy: Number


@result
class Dynamics:
    """Stiffness and damping of the film as judged, and the mass of shaft it can hold.

    `critical_mass` None: no mass makes the shaft unstable.  `whirl_ratio` and `threshold_speed` are there for a load that stands; under a
    load that turns with the shaft the threshold is that of the place in the load's frame, which no single speed marks, since the load
    grows with it.
    """

    stiffness_xx: NewtonPerMetre = value("Stiffness along the load", "N/m", "K_xx")
    stiffness_xy: NewtonPerMetre = value("Stiffness along the load, displaced across it", "N/m", "K_xy")
    stiffness_yx: NewtonPerMetre = value("Stiffness across the load, displaced along it", "N/m", "K_yx")
    stiffness_yy: NewtonPerMetre = value("Stiffness across the load", "N/m", "K_yy")
    damping_xx: NewtonSecondPerMetre = value("Damping along the load", "N·s/m", "C_xx")
    damping_xy: NewtonSecondPerMetre = value("Damping along the load, moving across it", "N·s/m", "C_xy")
    damping_yx: NewtonSecondPerMetre = value("Damping across the load, moving along it", "N·s/m", "C_yx")
    damping_yy: NewtonSecondPerMetre = value("Damping across the load", "N·s/m", "C_yy")
    whirl_ratio: Number | None = value("Whirl at the threshold over the speed", "", "γ", default=None)
    critical_mass: Kilogram | None = value("Mass of shaft on this bearing that its film just holds", "kg", "m_c", default=None)
    threshold_speed: RevPerSecond | None = value("Speed at which the shaft begins to whirl", "rpm", "n_c", default=None)


@record
class Orbit:
    """The journal's ellipse about its place in the load's frame, to first order; floats or arrays."""

    amplitude: Metre  # half the length
    minor: Metre  # half the width
    film_loss: Metre  # how far it comes towards the narrowest film


def coefficients(eps: Number, b: Number, phi: Radian | None = None) -> Coefficients:
    """The coefficients over the load at ε and l/d; `phi`: φ where a line of the calculation has it already.  Floats or arrays.

    Raises FilmRangeError outside the table.
    """
    phi = tabulated.attitude_angle(eps=eps, b=b) if phi is None else phi
    q, a = d.load_slope(eps=eps, b=b), d.attitude_slope(eps=eps, b=b)
    c_rr = d.radial_damping(eps=eps, b=b)
    return Coefficients(
        k_xx=d.k_xx(q=q, phi=phi), k_xy=d.k_xy(q=q, phi=phi), k_yx=d.k_yx(eps=eps, phi=phi, a=a), k_yy=d.k_yy(eps=eps, phi=phi, a=a),
        c_xx=d.c_xx(c_rr=c_rr, eps=eps, phi=phi), c_xy=d.c_xy(c_rr=c_rr, eps=eps, phi=phi), c_yy=d.c_yy(c_rr=c_rr, eps=eps, phi=phi),
    )  # fmt: skip


def dynamics(hot: Film, duty: OperatingPoint, seat: BearingCase, ratio: Number, *, mass: Kilogram | None = None) -> Dynamics:
    """The film as a spring and damper.  `ratio`: l/d of the film (of one land, where a groove parts it); `mass`: the bearing's share of
    the shaft's, for the threshold speed."""
    k = coefficients(hot.eccentricity, ratio, hot.attitude) if seat.grooves is None else _between_grooves(hot, seat, ratio)
    F, g = duty.load, hot.clearance
    omega = f.angular_speed(n=duty.effective_speed)
    n_F, sense = _load_speed(duty, seat)
    whirl = heaviest = threshold = None
    film = dict(k_xx=k.k_xx, k_xy=k.k_xy, k_yx=k.k_yx, k_yy=k.k_yy, c_xx=k.c_xx, c_xy=k.c_xy, c_yy=k.c_yy)
    if n_F == 0.0:
        k_eq = d.equivalent_stiffness(**film)
        square = d.whirl_ratio_squared(k_eq=k_eq, **film)
        if square > 0:
            whirl = d.whirl_ratio(square=square)
            heaviest = d.critical_mass(k_eq=k_eq, square=square, F=F, g=g, omega=omega)
            threshold = None if mass is None else d.threshold_speed(n_h=duty.effective_speed, m_c=heaviest, m=mass)
    else:
        heaviest = d.critical_mass_turning(**film, F=F, g=g, omega=omega, Omega=d.relative_speed(sense=sense, n_F=n_F))
        heaviest = None if heaviest == float("inf") else heaviest
    across = d.damping_xy(c_xy=k.c_xy, F=F, g=g, omega=omega)
    return Dynamics(
        stiffness_xx=d.stiffness_xx(k_xx=k.k_xx, F=F, g=g), stiffness_xy=d.stiffness_xy(k_xy=k.k_xy, F=F, g=g),
        stiffness_yx=d.stiffness_yx(k_yx=k.k_yx, F=F, g=g), stiffness_yy=d.stiffness_yy(k_yy=k.k_yy, F=F, g=g),
        damping_xx=d.damping_xx(c_xx=k.c_xx, F=F, g=g, omega=omega), damping_xy=across, damping_yx=across,
        damping_yy=d.damping_yy(c_yy=k.c_yy, F=F, g=g, omega=omega), whirl_ratio=whirl, critical_mass=heaviest, threshold_speed=threshold,
    )  # fmt: skip


def _between_grooves(hot: Film, seat: BearingCase, ratio: Number) -> Coefficients:
    """Of a film that axial grooves bound, which does not turn with the line of centres."""
    from .grooved_table import film_at

    grooves = seat.grooves
    assert grooves is not None
    at = film_at(hot.eccentricity, ratio, grooves)
    names = ("k_xx", "k_xy", "k_yx", "k_yy", "c_xx", "c_xy", "c_yy")
    found = {name: d.grooved_coefficient(value=getattr(at, name), eps=hot.eccentricity, b=ratio) for name in names}
    return Coefficients(**found)


def orbit(film: Dynamics, R_0: Newton, phi: Radian, duty: OperatingPoint, seat: BearingCase) -> Orbit:
    """What a force that stands still does to a journal that is held by a turning load at the attitude angle φ."""
    n_F, sense = _load_speed(duty, seat)
    return orbit_of(film, R_0, d.relative_speed(sense=sense, n_F=n_F), phi)


def orbit_of(film: Dynamics, R_0: Newton, Omega: RadPerSecond, phi: Radian, mass: Kilogram = 0.0) -> Orbit:
    """The same for a force that turns at Ω in the load's frame, positive in the sense in which the film is dragged.

    The shaft's inertia: what stands still is not accelerated, so that of the ellipse only the part that turns against the force counts,
    with 4·Ω²·m: one part in a hundred of the stiffness for a balance shaft of some kilograms on films of 10 µm, hence mass 0 unless given.
    """
    Z_xx = d.impedance_xx(K_xx=film.stiffness_xx, C_xx=film.damping_xx, Omega=Omega, m=mass)
    Z_xy = d.impedance_xy(K_xy=film.stiffness_xy, C_xy=film.damping_xy, Omega=Omega, m=mass)
    Z_yx = d.impedance_yx(K_yx=film.stiffness_yx, C_xy=film.damping_yx, Omega=Omega, m=mass)
    Z_yy = d.impedance_yy(K_yy=film.stiffness_yy, C_yy=film.damping_yy, Omega=Omega, m=mass)
    x = d.motion_x(R_0=R_0, Z_xx=Z_xx, Z_xy=Z_xy, Z_yx=Z_yx, Z_yy=Z_yy)
    y = d.motion_y(R_0=R_0, Z_xx=Z_xx, Z_xy=Z_xy, Z_yx=Z_yx, Z_yy=Z_yy)
    return Orbit(amplitude=d.major_axis(x=x, y=y), minor=d.minor_axis(x=x, y=y), film_loss=d.film_loss(x=x, y=y, phi=phi))


def _load_speed(duty: OperatingPoint, seat: BearingCase) -> tuple[RevPerSecond, Number]:
    """The load's speed n_F, and +1 where n_J + n_B − 2·n_F is positive, −1 where the film is dragged against the journal's sense."""
    i_F, i_B = seat.inputs.load_speed_ratio, seat.inputs.bush_speed_ratio or 0.0
    return duty.speed if i_F == 1.0 else based_on(i_F * duty.speed, i_F, duty.speed), 1.0 if 1.0 + i_B - 2.0 * i_F > 0.0 else -1.0
