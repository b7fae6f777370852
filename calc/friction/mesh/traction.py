# SPDX-License-Identifier: Apache-2.0
"""Friction between the flanks, and the temperature of the film that it makes and depends on.

Part ξ of the load rides on the roughness and rubs as solids do (`mixed.py`); the rest shears oil.  Between elastic
bodies the oil is squeezed to a thin hard layer of the width 2·b_H (Eyring, with a limit to its shear stress); between
rigid ones it stays thin and is sheared over a far wider gap.

Under pressure the oil thickens by Barus in the friction source's model, and by Roelands in the one that is judged,
where the stress of Eyring takes α as it is under that pressure, as in Arana et al. 2018 (there at the Hertzian
pressure, here at the mean one, which the viscosity has too).  Beside a viscometer from 0.6 to 1 GPa and 80 to 120 °C
the exponent is 4 to 23 % low by Roelands, 13 to 71 % high by Barus (tests/calc/friction/mesh/test_mixed.py).

The friction heat warms the film, warm oil rubs less: at every position the film temperature T_f is where both agree.
The skins of the teeth have the bulk temperature, unless the bodies' own resistance to heat is given (`loss.py`)."""

from collections.abc import Callable
from typing import Any

import numpy as np

from ...sheet.arrays import Array
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.functions import asinh, exp, ln, power, smallest, sqrt
from ...sheet.record import record, replace
from ...sheet.text import Amount, Text
from ...sheet.units import (
    Celsius,
    Metre,
    MetrePerSecond,
    NewtonPerMetre,
    Number,
    Pascal,
    PascalSecond,
    PerPascal,
    SquareMetrePerSecond,
    WattPerMetre,
    WattPerMetreKelvin,
)
from ...sheet.value import based_on, converged, untraced
from .film import MeshFilm, Oil
from .mixed import THESIS, KelvinMetrePerWatt, Surfaces, film_pressure, film_ratio, friction
from .path import Motion

# Steel of the friction source's method: 46 W/(m·K), 7830 kg/m³, 465 J/(kg·K); the screening takes the 45 and 440 of its
# standards.
STEEL_CONDUCTIVITY: WattPerMetreKelvin = 46.0
STEEL_DIFFUSIVITY: SquareMetrePerSecond = 46.0 / (7830.0 * 465.0)
SHEAR_MODULUS: Pascal = 1e9  # of an oil under pressure
STEEPEST: Number = 60.0  # of α·p in the exponent
ROELANDS_COMPLIANCE: PerPascal = 5.1e-9
PASCAL_SECOND: PascalSecond = 1.0

TOLERANCE = 1e-9  # K
SLACK = 1e-7  # K, above the highest temperature that can come out
HOTTEST: Celsius = 1500.0  # above, the law of the oil's density ends: it comes to 0 at 1553 °C
PASSES = 60

OLVER = Text("Olver 1991, Olver and Spikes 1998")


# --- the fluid's part


@formula("η", "Barus 1893: viscosity under the mean pressure; exponent no more than 60", unit="mPa·s")
def viscosity_under_pressure(eta_f: PascalSecond, alpha_f: PerPascal, p_m: Pascal) -> PascalSecond:
    return eta_f * exp(smallest(alpha_f * p_m, STEEPEST))


@formula("Z", "Roelands 1966: pressure-viscosity index from the coefficient α at no pressure")
def roelands_index(alpha_f: PerPascal, eta_f: PascalSecond) -> Number:
    return alpha_f / (ROELANDS_COMPLIANCE * (ln(eta_f / PASCAL_SECOND) + 9.67))


@formula("η", "Roelands 1966: viscosity under the mean pressure; exponent no more than 60", unit="mPa·s")
def viscosity_by_roelands(eta_f: PascalSecond, Z: Number, p_m: Pascal) -> PascalSecond:
    return eta_f * exp(
        smallest((ln(eta_f / PASCAL_SECOND) + 9.67) * ((1 + ROELANDS_COMPLIANCE * p_m) ** Z - 1), STEEPEST)
    )


@formula("α_p", "Roelands 1966: slope of ln η over the pressure, at the mean pressure", unit="1/GPa")
def slope_under_pressure(alpha_f: PerPascal, Z: Number, p_m: Pascal) -> PerPascal:
    """>>> slope_under_pressure(alpha_f=1.5e-08, Z=0.55, p_m=800000000.0)
    7.2185...e-09
    """
    return alpha_f * power(1 + ROELANDS_COMPLIANCE * p_m, Z - 1)


@formula(
    "τ_E",
    Text("{thesis}, eq. 47: Eyring stress, 2·Λ/α", thesis=THESIS),
    unit="MPa",
    meanings={"Lambda": "Limiting shear stress over the pressure"},
)
def eyring_stress(Lambda: Number, alpha_f: PerPascal) -> Pascal:
    return 2 * Lambda / alpha_f


@formula(
    "μ_EHL",
    Text(
        "{thesis}, eqs. 32 and 48: Eyring's law, no more than the limiting shear Λ of Bair and Winer",
        thesis=THESIS,
    ),
    meanings={"Lambda": "Limiting shear stress over the pressure"},
)
def fluid_friction(
    tau_E: Pascal, p_m: Pascal, eta: PascalSecond, V_s: MetrePerSecond, h: Metre, Lambda: Number
) -> Number:
    return smallest(tau_E / p_m * asinh(eta * V_s / (tau_E * h)), Lambda)


@formula(
    "μ_IR",
    "hydrodynamics, derived here: shear of a rigid isoviscous film over its whole gap, 2.849·η·V_s·√(R/h₀) per length",
)
def rigid_fluid_friction(eta_0: PascalSecond, V_s: MetrePerSecond, R: Metre, h_0: Metre, w_f: NewtonPerMetre) -> Number:
    return 2.849 * eta_0 * V_s * sqrt(R / h_0) / w_f


@formula(
    "a_IR",
    "hydrodynamics, rigid isoviscous film: half width over which it is sheared, about √(2·R·h₀) (order of magnitude)",
    unit="µm",
)
def sheared_half_width(R: Metre, h_0: Metre) -> Metre:
    return sqrt(2 * R * h_0)


@formula(
    "De", Text("{thesis}, eq. 35: Deborah number, relaxation time over time in the contact; G = 1 GPa", thesis=THESIS)
)
def deborah(eta: PascalSecond, u_e: MetrePerSecond, a: Metre) -> Number:
    """a: half width of the zone that is sheared, b_H of an elastic contact."""
    return eta * u_e / (SHEAR_MODULUS * 2 * a)


# --- temperatures


@formula("q", "definition: friction power per length of the contact line", names={"mu": "μ_z"})
def friction_power(mu: Number, w: NewtonPerMetre, V_s: MetrePerSecond) -> WattPerMetre:
    return mu * w * V_s


@formula(
    "B",
    Text("{olver}: resistance of a moving surface to heat, per length", olver=OLVER),
    meanings={"a_th": "Thermal diffusivity of the surface", "k_s": "Thermal conductivity of the surface"},
)
def transient_resistance(
    a_th: SquareMetrePerSecond, a: Metre, u: MetrePerSecond, k_s: WattPerMetreKelvin
) -> KelvinMetrePerWatt:
    return sqrt(a_th * a / u) / (2 * a * k_s)


@formula(
    "ε",
    Text(
        "{olver}: share of the heat that enters the driver; M, resistance of the bodies behind their skins, 0 unless "
        "given",
        olver=OLVER,
    ),
    meanings={"M_1": "Resistance of the driver's body to heat", "M_2": "Resistance of the driven body to heat"},
)
def heat_partition(
    B_1: KelvinMetrePerWatt, B_2: KelvinMetrePerWatt, M_1: KelvinMetrePerWatt, M_2: KelvinMetrePerWatt
) -> Number:
    return (1.06 * B_2 + M_2) / (1.06 * (B_1 + B_2) + M_1 + M_2)


@formula(
    "T_m",
    Text("{olver}: mean temperature of both skins, weighted by their speeds", olver=OLVER),
    names={"epsilon": "ε"},
)
def skin_temperature(
    T_b: Celsius,
    q: WattPerMetre,
    epsilon: Number,
    M_1: KelvinMetrePerWatt,
    M_2: KelvinMetrePerWatt,
    u_1: MetrePerSecond,
    u_2: MetrePerSecond,
) -> Celsius:
    return T_b + q * (u_1 * epsilon * M_1 + u_2 * (1 - epsilon) * M_2) / (u_1 + u_2)


@formula(
    "R_th",
    Text("{olver}: flash temperature of the surfaces and mean temperature across the film, per heat", olver=OLVER),
    meanings={"k_f": "Thermal conductivity of the oil"},
)
def film_resistance(
    epsilon: Number, B_1: KelvinMetrePerWatt, h: Metre, a: Metre, k_f: WattPerMetreKelvin
) -> KelvinMetrePerWatt:
    return 1.06 * epsilon * B_1 + h / (16 * a * k_f)


@formula("T_f", Text("{olver}: temperature of the film", olver=OLVER))
def film_temperature(T_m: Celsius, q: WattPerMetre, R_th: KelvinMetrePerWatt) -> Celsius:
    return T_m + q * R_th


@formula(
    "T_f",
    Text("{olver}: temperature of the film", olver=OLVER),
    shows="T_f at which the film rubs so much that it has T_f, secant steps",
)
def closing_film_temperature(T_f: Celsius) -> Celsius:
    """The temperature itself, found from all that the friction depends on."""
    return T_f


ADVICE = Text(
    'less power or speed, wider or smoother flanks, or another oil in this mesh; pressure_law = "barus", less '
    "body_resistance_K_W"
)


def settled(warmed: Callable[[Array], Array], T_m: Any, highest: Array, x: Array, subject: str) -> Array:
    """The temperature T = warmed(T) at every position, each by itself, of one operating point or of many.

    Warm oil rubs less, so warmed(T) − T falls and has one zero between T_m and `highest`.  Secant steps, kept inside
    the bracket; a slope flatter than −1 can not be and is taken as −1.  NoSolution names the worst position."""
    what = Text("{subject}: temperature of the film", subject=subject)
    before: Array = np.broadcast_to(T_m, np.shape(highest))
    gap_before = warmed(before) - before
    low, high = before, np.minimum(highest + SLACK, HOTTEST)
    T: Array = np.minimum(before + gap_before, HOTTEST)
    for _ in range(PASSES):
        gap = warmed(T) - T
        if np.all(np.abs(gap) <= TOLERANCE):  # NaN never is
            return T
        if np.any((gap > 0) & (T >= HOTTEST)):
            where = place(x, gap, int(np.argmax(np.where(T >= HOTTEST, gap, -np.inf))))
            tried = Text(
                "{where} it would be above {hottest} °C, where the laws of the oil end",
                where=where,
                hottest=Amount(HOTTEST, form="g"),
            )
            raise NoSolution(what, tried, ADVICE)
        low, high = np.where(gap > 0, T, low), np.where(gap < 0, T, high)
        step = T - before
        slope = np.minimum((gap - gap_before) / np.where(step == 0, 1.0, step), -1.0)
        before, gap_before = T, gap
        T = T - gap / slope
        T = np.where((T >= low) & (T <= high), T, (low + high) / 2)
    worst = int(np.nanargmax(np.where(np.isnan(gap), np.inf, np.abs(gap))))
    left, off = float(np.ravel(gap)[worst]), Text("the formulas give no number there")
    if np.isfinite(left):
        off = Text("off by {left} K after {passes} passes", left=Amount(left, form=".3g"), passes=PASSES)
    raise NoSolution(what, Text("{place}: {off}", place=place(x, gap, worst), off=off), ADVICE)


def place(x: Array, gap: Array, worst: int) -> str:
    """The position of one element, and of many operating points which it is."""
    point, position = divmod(worst, np.size(x))
    which = Text("operating point {point}, ", point=point) if gap.ndim > 1 else ""
    millimetres = Amount(float(np.ravel(x)[position]) * 1000.0, form=".4g")
    return Text("{which}{ravel} mm from T₁", which=which, ravel=millimetres)


# --- together


@record
class Traction:
    """Friction at every position: film over roughness, load share of the solids; coefficient, heat and its partition,
    film temperature, Deborah number."""

    lam: Array
    xi: Array
    mu: Array
    q: Array
    epsilon: Array
    T_f: Array
    De: Array


@record
class Contact:
    """What both laws are told: oil, motion, film; the load with and without its floor, pressure and half width; the
    flanks, the film over their roughness, their share of the load."""

    oil: Oil
    motion: Motion
    film: MeshFilm
    w: Array
    w_f: Array
    p_m: Array
    b_H: Array
    surfaces: Surfaces
    lam: Array
    xi: Array

    def traction(self, mu_f: Array, eta: Any, a: Array, epsilon: Array, R_th: Array) -> Traction:
        """What follows of the friction of the film, whose oil of the viscosity eta is sheared over the half width a."""
        mu = friction(xi=self.xi, mu_s=self.surfaces.mu_s, mu_f=mu_f)
        q = friction_power(mu=mu, w=self.w, V_s=self.motion.V_s)
        T_f = film_temperature(T_m=self.oil.T_m, q=q, R_th=R_th)
        De = deborah(eta=eta, u_e=self.motion.u_e, a=a)
        return Traction(lam=self.lam, xi=self.xi, mu=mu, q=q, epsilon=epsilon, T_f=T_f, De=De)


def traction(
    oil: Oil,
    motion: Motion,
    film: MeshFilm,
    w: Array,
    w_f: Array,
    p_m: Array,
    b_H: Array,
    s: Surfaces,
    x: Array,
    subject: str,
) -> Traction:
    """The friction at film temperature.  The heat comes from the load w as it is, pressure and film from w_f with its
    floor.

    Where the regime changes within the stretch of a position, both laws act, each on its share.
    """
    lam = film_ratio(h=film.h, sigma=s.sigma)
    xi = s.mixing.solid(lam, s.sigma, s.Ra)
    at = Contact(oil, motion, film, w, w_f, p_m, b_H, s, lam, xi)
    rigid = film.rigid
    if not np.any(rigid > 0):
        return _elastic(at, x, subject)
    thin = _rigid(at)
    if not np.any(rigid < 1):
        return thin
    thick = _elastic(at, x, subject)

    def mixed(by_thin: Array, by_thick: Array) -> Array:
        return based_on(rigid * by_thin + (1 - rigid) * by_thick, film.rigid, by_thin, by_thick)

    rubbing = ("mu", "q", "epsilon", "T_f", "De")
    return replace(thin, **{name: mixed(getattr(thin, name), getattr(thick, name)) for name in rubbing})


def _rigid(c: Contact) -> Traction:
    """Oil sheared over the whole gap of a rigid film, with the viscosity of the inlet: explicit."""
    m, film = c.motion, c.film
    mu_IR = rigid_fluid_friction(eta_0=c.oil.eta_0, V_s=m.V_s, R=m.R, h_0=film.h_0, w_f=c.w_f)
    a = sheared_half_width(R=m.R, h_0=film.h_0)
    epsilon, R_th = _heat(c, a)
    return c.traction(mu_IR, c.oil.eta_0, a, epsilon, R_th)


def _elastic(c: Contact, x: Array, subject: str) -> Traction:
    """Oil sheared between the flattened flanks, at the temperature that this makes; where no part of a stretch is
    elastic, at that of the teeth."""
    oil, m, film, s = c.oil, c.motion, c.film, c.surfaces
    epsilon, R_th = _heat(c, c.b_H)
    p_f = film_pressure(xi=c.xi, p_m=c.p_m) if s.relieved else c.p_m

    def at(T_f: Array) -> Traction:
        eta_f = oil.lubricant.at(T_f).mu
        alpha_f = oil.alpha_at(eta_f)
        if s.roelands:
            Z = roelands_index(alpha_f=alpha_f, eta_f=eta_f)
            eta = viscosity_by_roelands(eta_f=eta_f, Z=Z, p_m=p_f)
            alpha_p = slope_under_pressure(alpha_f=alpha_f, Z=Z, p_m=p_f) if s.relieved else alpha_f
        else:
            eta, alpha_p = viscosity_under_pressure(eta_f=eta_f, alpha_f=alpha_f, p_m=p_f), alpha_f
        tau_E = eyring_stress(Lambda=oil.Lambda, alpha_f=alpha_p)
        mu_f = fluid_friction(tau_E=tau_E, p_m=p_f, eta=eta, V_s=m.V_s, h=film.h, Lambda=oil.Lambda)
        return c.traction(mu_f, eta, c.b_H, epsilon, R_th)

    with untraced():
        there = np.asarray(film.rigid < 1)
        most = friction(xi=c.xi, mu_s=s.mu_s, mu_f=oil.Lambda)
        highest = oil.T_m + there * most * c.w * m.V_s * R_th
        T_f = settled(lambda T: oil.T_m + there * (at(T).T_f - oil.T_m), oil.T_m, highest, x, subject)
    return converged(closing_film_temperature, T_f, at, lambda rubs: rubs.T_f)


def _heat(c: Contact, a: Array) -> tuple[Array, Array]:
    """The share of the heat that enters the driver, and the film's warming per heat, where it is made over the half
    width a."""
    s, m = c.surfaces, c.motion
    B_1, B_2 = (transient_resistance(a_th=STEEL_DIFFUSIVITY, a=a, u=u, k_s=STEEL_CONDUCTIVITY) for u in (m.u_1, m.u_2))
    epsilon = heat_partition(B_1=B_1, B_2=B_2, M_1=s.M_1, M_2=s.M_2)
    return epsilon, film_resistance(epsilon=epsilon, B_1=B_1, h=c.film.h, a=a, k_f=c.oil.k_f)
