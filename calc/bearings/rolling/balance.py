# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""The heat of a rolling bearing and the oil that takes it: its temperature, its loss, the speeds and the least load.

The bearing gives its heat to what is around it as in the reference state of ISO 15312, 50 K above it.  Oil that flows
through carries more off: the temperature is an upper estimate, and a lower one of the viscosity.

One bearing as numbers, or many of one type, of many loads, speeds and oils, as arrays that broadcast."""

from collections.abc import Callable
from typing import Annotated, Any, Generic, Literal

import numpy as np

from ...sheet.arrays import Array, Num, Value
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.functions import along, largest, pi, single_or_many
from ...sheet.record import record
from ...sheet.text import Amount, Text
from ...sheet.units import (
    Celsius,
    CubicMetrePerSecond,
    JoulePerKilogramKelvin,
    Kelvin,
    KilogramPerMetre3,
    Metre,
    Newton,
    Number,
    RevPerSecond,
    SquareMetre,
    SquareMetrePerSecond,
    Watt,
)
from ...sheet.value import converged, recorded, unlinked, untraced
from .torque import SKF, Friction, Series, constants, load_factor, of_series, torque_of_load, two_part_torque

WattPerKelvin = Annotated[float, "W/K"]
WattPerSquareMetre = Annotated[float, "W/m²"]

ISO_15312 = Text("ISO 15312, from memory")
MILLIMETRE: Metre = 1e-3
CENTISTOKE: SquareMetrePerSecond = 1e-6
ONE_RPM: RevPerSecond = 1 / 60
ONE_NEWTON: Newton = 1.0
REFERENCE_FLUX: WattPerSquareMetre = 0.016e6
REFERENCE_RISE: Kelvin = 50.0
REFERENCE_AREA: SquareMetre = 0.05
REFERENCE_VISCOSITY: SquareMetrePerSecond = 12e-6
JET_RISE: Kelvin = 15.0
HOTTEST: Kelvin = 400.0  # above the oil: no balance is looked for beyond
RISES = np.concatenate([[0.0], HOTTEST / 2.0 ** np.arange(6, -1, -1)])  # where one is looked for first
PASSES, NEAR = 60, 1e-9  # at most, and K by which the last one may move: the next would move a millionth of that
STEPS = 8  # of Newton's method
SLOW: RevPerSecond = 1e-3


# --- the heat that the surface gives off


@formula(
    "A",
    Text("{iso}: surface of a bearing that gives off heat", iso=ISO_15312),
    meanings={"B": "Width of the bearing", "d": "Bore of the bearing", "D": "Outside diameter of the bearing"},
)
def heat_surface(B: Metre, d: Metre, D: Metre) -> SquareMetre:
    return pi * B * (D + d)


@formula("(h·A)", Text("{iso}: heat flow of the reference state, over its 50 K", iso=ISO_15312))
def heat_conductance(A: SquareMetre) -> WattPerKelvin:
    """>>> heat_conductance(A=3.63e-3)
    1.1616...
    """
    return REFERENCE_FLUX / REFERENCE_RISE * A


@formula(
    "T_b",
    "conservation of energy: the surface gives off what the torque makes",
    shows="T_b at which (h·A)·(T_b − T_oil) = 2·π·n·M(ν(T_b)), by false position",
)
def running_temperature(T_b: Celsius) -> Celsius:
    """The temperature itself, found from all that the torque depends on."""
    return T_b


@formula(
    "P_f",
    "conservation of energy: heat that the surface gives off, all of the friction",
    names={"hA": "(h·A)"},
    meanings={"T_oil": "Temperature of the oil"},
)
def heat_given_off(hA: WattPerKelvin, T_b: Celsius, T_oil: Celsius) -> Watt:
    return hA * (T_b - T_oil)


@formula(
    "P_f",
    "definition: mean of the duty, by the hours of its rows",
    names={"w": "w_i", "P_i": "P_f,i"},
    meanings={"w": "Share of each row in the hours"},
)
def loss_of_duty(w: Number, P_i: Watt) -> Watt:
    """w: share of each row in the hours."""
    return along(w * P_i)


@record
class HeatBalance(Generic[Value]):
    """A bearing that carries off what it makes, and the oil in it at its temperature."""

    temperature: Value  # °C
    viscosity: Value  # m²/s
    torque: Value  # N·m
    loss: Value  # W


def heat_balance(
    friction: Friction[Value],
    F: Value,
    n: Value,
    T_oil: Value,
    hA: Value,
    viscosity: Callable[[Value], Value],
    outside: Literal["raise", "nan"] = "raise",
) -> HeatBalance[Value]:
    """The state in which the heat given off is the friction: under the mean load F [N] at n [1/s] in oil of T_oil [°C].

    `viscosity`: m²/s at °C, of numbers and arrays (`Lubricant.nu`).  Where there is no balance below T_oil + 400 K:
    NoSolution, or with `outside` = "nan" not a number."""
    T_b: Any = balanced_temperature(friction, F, n, T_oil, hA, viscosity)
    if outside == "raise":
        asked(T_b, F, n, T_oil)
    return carried_off(friction, F, n, T_oil, hA, viscosity, T_b)


def balanced_temperature(
    friction: Friction[Value], F: Value, n: Value, T_oil: Value, hA: Value, viscosity: Callable[[Value], Value]
) -> Value:
    """The temperature alone, °C, without a line; not a number where there is no balance.

    The coolest of several, which are found where their rises over the oil lie a factor of two apart: far below 0 °C a
    starved bearing may run cool or warm.  By false position: the answer stays between two temperatures as in halving,
    and the one that stays is given less weight the less the last step brought (Anderson and Björck 1973), so that some
    six passes take the place of fifty."""
    cold, made, plain_F, plain_n, plain_hA = unlinked((T_oil, friction, F, n, hA))

    def excess(T: Any) -> Any:
        return 2 * pi * plain_n * made.torque(plain_F, plain_n, viscosity(T)) - plain_hA * (T - cold)

    with untraced(), recorded(False), np.errstate(invalid="ignore", over="ignore", divide="ignore"):
        here: Any = cold + 0.0 * (plain_F + plain_n + plain_hA + made.mean_diameter)  # of the shape of all together
        rises = RISES.reshape(-1, *np.ones(np.ndim(here), dtype=int))
        first = excess(here + rises)
        enough = first[1:] <= 0
        after, none = 1 + np.argmax(enough, axis=0)[None], ~enough.any(axis=0)

        def at(which: Any) -> tuple[Any, Any]:
            return here + RISES[which[0]], np.take_along_axis(first, which, 0)[0]

        (there, of_there), (here, of_here) = at(after), at(after - 1)
        for _ in range(PASSES):
            T = here - of_here * (there - here) / (of_there - of_here)
            T = np.where(np.isfinite(T), T, here)  # nothing is made, and nothing given off
            of_T = excess(T)
            crossed = of_T * of_here < 0
            weight = 1 - of_T / of_here
            weight = np.where(weight > 0, weight, 0.5)
            there = np.where(crossed, here, there)
            of_there = np.where(crossed, of_here, of_there * weight)
            moved = np.where(none, 0.0, np.abs(T - here))
            here, of_here = T, of_T
            if not np.any(moved > NEAR):
                break
    T_b: Any = single_or_many(np.where(none, np.nan, here))
    found: Value = T_b
    return found


def carried_off(
    friction: Friction[Value],
    F: Value,
    n: Value,
    T_oil: Value,
    hA: Value,
    viscosity: Callable[[Value], Value],
    T_b: Value,
) -> HeatBalance[Value]:
    """The state at the temperature that `balanced_temperature` found: all that is made is given off."""

    def carried(T: Value) -> HeatBalance[Value]:
        nu = viscosity(T)
        loss = heat_given_off(hA=hA, T_b=T, T_oil=T_oil)
        return HeatBalance(temperature=T, viscosity=nu, torque=friction.torque(F, n, nu), loss=loss)

    return converged(running_temperature, T_b, carried, lambda state: (state.torque, n, hA, T_oil))


def asked(T_b: Num, F: Num, n: Num, T_oil: Num) -> None:
    """Raises NoSolution where one of these temperatures is none."""
    none = ~np.isfinite(np.asarray(T_b, dtype=float))
    if none.any():
        raise _no_balance(none, F, n, T_oil)


def _no_balance(none: Any, F: Num, n: Num, T_oil: Num) -> NoSolution:
    """What is said of the first point that has none."""
    points = np.broadcast_arrays(none, *(np.asarray(x, dtype=float) for x in (F, n, T_oil)))
    load, speed, oil = (x[points[0]][0].item() for x in points[1:])
    tried = Text(
        "under {load} N at {speed} rpm in oil of {oil} °C it would be more than {rise} K above its oil",
        load=Amount(load, form=".4g"),
        speed=Amount(speed * 60, form=".4g"),
        oil=Amount(oil, form=".4g"),
        rise=Amount(HOTTEST, form=".0f"),
    )
    advice = Text("lower the speed or the load, cool the oil, or give it a jet and say what heat leaves by heat_W_K")
    return NoSolution(Text("a rolling bearing does not carry off the heat of its friction"), tried, advice)


# --- speeds


@formula("F_r", Text("{iso}: reference load of a radial bearing", iso=ISO_15312))
def reference_load(C_0: Newton) -> Newton:
    return 0.05 * C_0


@formula("Φ_r", Text("{iso}: heat flow of the reference state, less for each mm² of large bearings", iso=ISO_15312))
def reference_heat(A: SquareMetre) -> Watt:
    return REFERENCE_FLUX * A * (largest(A, REFERENCE_AREA) / REFERENCE_AREA) ** -0.34


@formula(
    "n_θr",
    Text("{iso}: thermal speed rating, the torque by INA", iso=ISO_15312),
    shows="n at which 2·π·n·M(F_r, 12 mm²/s) = Φ_r, both parts in a bath, by Newton's method",
    unit="rpm",
)
def thermal_speed(f_0: Number, f_1: Number, F: Newton, d_m: Metre, Phi: Watt) -> RevPerSecond:
    """On the logarithms of heat and speed, between which the slope is 1 + ⅔ of the oil's share of the torque."""

    def of_oil(n: Any) -> Any:
        return two_part_torque(f_0=f_0, nu=REFERENCE_VISCOSITY, n=n, d_m=d_m, f_1=0.0, F=0.0)

    with untraced():
        of_load = torque_of_load(f_1=f_1, F=F, d_m=d_m)
        n: Any = Phi / (2 * pi * (of_oil(SLOW) + of_load))  # with the least that oil takes: faster than the answer
        for _ in range(STEPS):
            M = of_oil(n) + of_load
            n = n * (Phi / (2 * pi * n * M)) ** (1 / (1 + 2 / 3 * of_oil(n) / M))
    return single_or_many(np.asarray(n))


def reference_speed(friction: Friction[Value], B: Value) -> Value:
    """The speed at which a bearing in a bath (`friction_of(…, lubrication="bath")`) is 50 K above what is around it."""
    C_0 = friction.static_rating
    assert C_0 is not None
    F = reference_load(C_0=C_0)
    f_1 = load_factor(F=F, C_0=C_0) if friction.f_1 is None else friction.f_1
    Phi = reference_heat(A=heat_surface(B=B, d=friction.bore, D=friction.outside))
    return thermal_speed(f_0=friction.f_0, f_1=f_1, F=F, d_m=friction.mean_diameter, Phi=Phi)


@formula("(n·d_m)", "definition: speed factor of a rolling bearing, in rpm·mm")
def speed_factor(n: RevPerSecond, d_m: Metre) -> Number:
    return n / ONE_RPM * d_m / MILLIMETRE


@formula(
    "n_lim",
    Text("{skf}: limiting speed, by what the type's n·d_m may be", skf=SKF),
    unit="rpm",
    meanings={"X": "What speed times mean diameter may be"},
)
def limiting_speed(X: Number, d_m: Metre) -> RevPerSecond:
    return X * ONE_RPM * MILLIMETRE / d_m


def largest_speed_factor(type: str, series: str) -> float:
    """What n·d_m may be [rpm·mm]; of one's own roller bearing that of needles."""
    number: float = constants("speed")["own_roller" if (type, series) == ("roller", "own") else type]
    return number


# --- the least load, under which elements roll and do not slide


@formula(
    "F_min",
    Text("{skf}: minimum load of a deep-groove ball bearing", skf=SKF),
    names={"k_r": "k_min"},
    meanings={"k_r": "Factor of the least load"},
)
def minimum_load_of_balls(k_r: Number, nu: SquareMetrePerSecond, n: RevPerSecond, d_m: Metre) -> Newton:
    """>>> minimum_load_of_balls(k_r=0.025, nu=12e-6, n=43.33, d_m=38.5e-3)
    36.72...
    """
    return 1000 * k_r * (nu / CENTISTOKE * n / ONE_RPM / 1000) ** (2 / 3) * (d_m / MILLIMETRE / 100) ** 2 * ONE_NEWTON


@formula(
    "F_min", Text("{skf}: minimum load of a cylindrical roller bearing", skf=SKF), names={"n_r": "n_θr", "k_r": "k_min"}
)
def minimum_load_of_rollers(k_r: Number, n: RevPerSecond, n_r: RevPerSecond, d_m: Metre) -> Newton:
    return 1000 * k_r * (6 + 4 * n / n_r) * (d_m / MILLIMETRE / 100) ** 2 * ONE_NEWTON


@formula("F_min", Text("{skf}: minimum load as a share of the dynamic rating", skf=SKF), names={"x": "x_C", "C": "C_r"})
def minimum_load_by_rating(x: Number, C: Newton) -> Newton:
    return x * C


def minimum_load(
    type: str, series: Series, d_m: Value, n: Value, nu: Value, reference_speed: Value, dynamic_rating: Value
) -> Value:
    """The least load at n [1/s] and ν [m²/s], to be held against the mean of the turning load and the weight."""
    least = constants("least_load")
    if series == "own":
        return minimum_load_by_rating(x=least["share"][f"own_{type}"], C=dynamic_rating)
    if type == "ball":
        return minimum_load_of_balls(k_r=of_series(least["ball"], series), nu=nu, n=n, d_m=d_m)
    if type == "roller":
        return minimum_load_of_rollers(k_r=of_series(least["roller"], series), n=n, n_r=reference_speed, d_m=d_m)
    return minimum_load_by_rating(x=least["share"][type], C=dynamic_rating)


def minimum_load_speed(n: Array, F: Array, F_min: Array) -> Any:
    """The lowest speed from which the load stays above the least one, by the speeds of a sweep in the last axis, in
    rising order, linear between two; not a number where the load is too small at the last of them."""
    margin = np.asarray(F) - np.asarray(F_min)
    speeds = np.broadcast_to(n, margin.shape)
    fails = ~(margin >= 0)
    last = margin.shape[-1] - 1 - np.argmax(fails[..., ::-1], axis=-1)  # the last speed at which it fails
    after = np.minimum(last + 1, margin.shape[-1] - 1)

    def at(x: Array, place: Any) -> Array:
        return np.take_along_axis(x, place[..., None], -1)[..., 0]

    step = at(margin, after) - at(margin, last)
    with np.errstate(invalid="ignore", divide="ignore"):
        between = at(speeds, last) - at(margin, last) / step * (at(speeds, after) - at(speeds, last))
    holds = np.where(fails[..., -1], np.nan, between)
    return single_or_many(np.where(fails.any(-1), holds, speeds[..., 0]))


# --- oil


@formula(
    "Q_jet",
    "rule of this program: oil that carries the loss off, 15 K warmer than it came",
    unit="L/min",
    names={"P": "P_f"},
)
def jet_flow(P: Watt, rho: KilogramPerMetre3, c_p: JoulePerKilogramKelvin) -> CubicMetrePerSecond:
    """>>> jet_flow(P=40, rho=810, c_p=2250)
    1.463...e-06
    """
    return P / (rho * c_p * JET_RISE)
