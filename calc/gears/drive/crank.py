# SPDX-License-Identifier: Apache-2.0
"""How the crank turns, and the first driver with it: from the torque on the crank, from an irregularity that is given,
or from one that is taken where nothing is known.

α = Re Σ α_n·e^{inε} in rad/s², n orders on the crank, ε = ωt its angle.  ω in the torque and in ε is constant: that is
wrong by about the irregularity itself.  The train turns with the crank, its inertia counts in J_E; the variable part of
the crank train's own inertia counts in the torque and not in J_E."""

import math
from collections.abc import Sequence
from typing import Annotated

import numpy as np

from ...engine.gas_torque import order_word
from ...engine.inputs import EngineInputs
from ...engine.load import CrankTorque
from ...engine.operation import CrankTwist
from ...library.table_file import house_table
from ...sheet.arrays import Array, ComplexArray
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.functions import modulus, pi, power
from ...sheet.linked_array import elements
from ...sheet.record import record
from ...sheet.text import Amount, Text
from ...sheet.units import (
    Hertz,
    KilogramMetre2,
    Metre,
    NewtonMetre,
    Number,
    Numbers,
    PhasorNewtonMetres,
    Radian,
    RadiansPerSecond,
    RadPerSecond,
    RadPerSecond2,
    RevPerSecond,
)
from ...sheet.value import based_on
from .motion import Motion, peak

PhasorRadPerSecond2 = Annotated[complex, "rad/s²"]
PhasorRadiansPerSecond2 = Annotated[ComplexArray, "rad/s²"]
PhasorMetresPerSecond2 = Annotated[ComplexArray, "m/s²"]
PhasorStiffness = Annotated[complex, "N·m"]  # in a radian

OF_TWIST = {"Omega": "Ω", "k": "k_t"}
SHOWN = 6  # orders of the acceleration, the lowest


# --- formulas


@formula("ω'_n", "dynamics, moment of momentum: the torque above its mean turns flywheel and train")
def acceleration(t_n: PhasorNewtonMetres, J_E: KilogramMetre2) -> PhasorRadiansPerSecond2:
    return t_n / J_E


@formula(
    "x''_n",
    "kinematics: of the first driver along the line of action, i_1 its speed over the crank's",
    names={"alpha_n": "ω'_n"},
    meanings={"r_b1": "Base radius of the first driver", "i_1": "Turns of the first driver in a turn of the crank"},
)
def along_line(alpha_n: PhasorRadiansPerSecond2, r_b1: Metre, i_1: Number) -> PhasorMetresPerSecond2:
    return r_b1 * i_1 * alpha_n


@formula(
    "δ_s",
    "dynamics, flywheel: (ω_max − ω_min)/ω of the series, the same as ΔE/(J_E·ω²)",
    shows="(max − min over the cycle of Σ Re{ω'_n·e^{inε}/(i·n)})/ω²",
)
def irregularity(alpha_n: PhasorRadiansPerSecond2, n: Numbers, omega: RadPerSecond, cycle: Radian) -> Number:
    least, most = extremes(alpha_n, n, cycle, integrals=1)
    return float(most[0] - least[0]) / omega**2


@formula(
    "ω'_max", "mathematics: largest of the series, by a parabola through three points", shows="max Σ Re{ω'_n·e^{inε}}"
)
def largest_acceleration(alpha_n: PhasorRadiansPerSecond2, n: Numbers, cycle: Radian) -> RadPerSecond2:
    return float(extremes(alpha_n, n, cycle)[1][0])


@formula(
    "ω'_min", "mathematics: smallest of the series, by a parabola through three points", shows="min Σ Re{ω'_n·e^{inε}}"
)
def smallest_acceleration(alpha_n: PhasorRadiansPerSecond2, n: Numbers, cycle: Radian) -> RadPerSecond2:
    return float(extremes(alpha_n, n, cycle)[0][0])


@formula("ω̂'_n", "mathematics: amplitude of one order of the acceleration", names={"alpha_n": "ω'_n"})
def amplitude(alpha_n: PhasorRadPerSecond2) -> RadPerSecond2:
    return modulus(alpha_n)


@formula(
    "ω̂'_n",
    "kinematics: an irregularity of one order n, ω·(1 + δ_s/2·sin nε)",
    names={"delta": "δ_s", "n": "n_o"},
    meanings={
        "delta": "Irregularity of the crank",
        "n": "Order of the irregularity",
        "omega": "Angular speed of the crank",
    },
)
def of_irregularity(delta: Number, n: Number, omega: RadPerSecond) -> RadPerSecond2:
    """>>> of_irregularity(delta=0.05, n=1.5, omega=94.25)
    333.1148...
    """
    return delta / 2 * n * omega**2


@formula(
    "k_t",
    "dynamics, two masses: twisting stiffness with its loss, from their own frequency",
    names={"f": "f_t", "zeta": "ζ_t"},
)
def twist_stiffness(f: Hertz, J_n: KilogramMetre2, J_f: KilogramMetre2, zeta: Number) -> PhasorStiffness:
    """`J_n`, `J_f`: of the mass at the nose and of all behind it."""
    return power(2 * pi * f, 2) * J_n * J_f / (J_n + J_f) * (1 + 2j * zeta)


@formula("ω'_n", "dynamics, two masses: of the mass on which all the torque acts", names=OF_TWIST)
def where_it_acts(
    t_n: PhasorNewtonMetres, k: PhasorStiffness, Omega: RadiansPerSecond, J: KilogramMetre2, J_o: KilogramMetre2
) -> PhasorRadiansPerSecond2:
    """`J` of this mass, `J_o` of the other; Ω = n·ω."""
    return -(Omega**2) * t_n * (k - Omega**2 * J_o) / ((k - Omega**2 * J) * (k - Omega**2 * J_o) - k**2)


@formula(
    "ω'_n", "dynamics, two masses: of the mass beyond the twist, where all the torque acts on the other", names=OF_TWIST
)
def beyond_twist(
    t_n: PhasorNewtonMetres, k: PhasorStiffness, Omega: RadiansPerSecond, J: KilogramMetre2, J_o: KilogramMetre2
) -> PhasorRadiansPerSecond2:
    return -(Omega**2) * t_n * k / ((k - Omega**2 * J) * (k - Omega**2 * J_o) - k**2)


# --- extremes of a series


def extremes(a: ComplexArray, n: Array, cycle: Radian, integrals: int = 0) -> tuple[Array, Array]:
    """The least and the most over the cycle of Re Σ a_n·e^{inε}/(i·n)^integrals, of one series (N,) or many (P, N)."""
    a = np.atleast_2d(a)
    series = Motion(np.asarray(n), a, np.ones(len(a)), float(cycle))
    y = series.on_nodes(series.period, integrals)
    return -peak(-y), peak(y)


# --- from the torque


def motion(
    torque: CrankTorque,
    speeds: Array,
    J_E: KilogramMetre2,
    r_b1: Metre,
    i_1: Number = 1.0,
    *,
    twist: CrankTwist | None = None,
    nose: bool = False,
) -> Motion:
    """Of the first driver at the speeds of the torque, in 1/s; `i_1`: its speed over the crank's, > 0.

    `nose`: the train is driven from there and not from the flywheel.  A crank that twists has its torque somewhere
    between its ends.  Both are computed, and at each point that place is taken whose whole motion lets go harder, with
    the larger max(−x₀''): any share between the two gives no more.  Raises NoSolution where the nose has more inertia
    than there is."""
    omega = based_on(2 * np.pi * np.asarray(speeds, dtype=float), speeds)
    if twist is None:
        alpha = acceleration(t_n=torque.t, J_E=J_E)
    else:
        if (wrong := twist_problem(twist, J_E)) is not None:
            raise NoSolution(Text("the twist of the crank"), wrong)
        front, rear = twisted(torque.t, torque.orders, omega, J_E, twist, nose=nose)
        falls = [extremes(place, torque.orders, torque.cycle)[0] for place in (front, rear)]
        alpha = based_on(np.where((falls[0] <= falls[1])[:, None], front, rear), front, rear)
    a = along_line(alpha_n=alpha, r_b1=r_b1, i_1=i_1)
    return Motion(torque.orders, a, omega, torque.cycle)


def twist_problem(twist: CrankTwist, J_E: KilogramMetre2) -> Text | None:
    """What is wrong with the inertia at the nose."""
    if twist.nose_inertia < J_E:
        return None
    J = Amount(float(J_E), "kg·m²", form=".4g")
    return Text("nose_inertia_kgm2 must be below the inertia of flywheel and train, {J}", J=J)


def twisted(
    t: ComplexArray, orders: Array, omega: Array, J_E: KilogramMetre2, twist: CrankTwist, *, nose: bool
) -> tuple[ComplexArray, ComplexArray]:
    """α_n of one end of the crank (P, N) with all the torque at the front, and with all of it at the rear."""
    J_n = twist.nose_inertia
    J_f = based_on(J_E - J_n, J_E, J_n)
    k = twist_stiffness(f=twist.frequency, J_n=J_n, J_f=J_f, zeta=twist.damping_ratio)
    Omega = based_on(orders * np.asarray(omega)[:, None], omega)
    own, other = (J_n, J_f) if nose else (J_f, J_n)
    here = where_it_acts(t_n=t, k=k, Omega=Omega, J=own, J_o=other)
    beyond = beyond_twist(t_n=t, k=k, Omega=Omega, J=own, J_o=other)
    return (here, beyond) if nose else (beyond, here)


# --- from an irregularity


@record
class UnevenRow:
    """An irregularity (ω_max − ω_min)/ω of one order on the crank, at a speed in 1/s."""

    speed: RevPerSecond
    delta: Number
    order: Number


def firing_order(engine: EngineInputs) -> Number:
    """How often a cylinder fires in a turn of the crank."""
    return based_on(2 * engine.cylinders / engine.strokes, engine.cylinders, engine.strokes)


def default_row(engine: EngineInputs, idle: RevPerSecond) -> UnevenRow:
    """What is taken where neither gas with flywheel nor an irregularity are known: that at idle speed."""
    usual = house_table("engine_motion.toml")["irregularity"]["idle"]
    delta = based_on(float(usual[min(engine.cylinders, len(usual)) - 1]), engine.cylinders)
    return UnevenRow(idle, delta, firing_order(engine))


def given_accelerations(rows: Sequence[UnevenRow], speeds: Array) -> tuple[Array, ComplexArray]:
    """Orders, and α_n at the speeds (P, N): linear over speed between the rows, outside them that of the nearest; one
    order, or where rows are of several each by itself."""
    rows = sorted(rows, key=lambda row: row.speed)
    orders = np.array(sorted({float(row.order) for row in rows}))
    sizes = [
        of_irregularity(delta=row.delta, n=row.order, omega=based_on(2 * math.pi * row.speed, row.speed))
        for row in rows
    ]
    at = np.array([row.speed for row in rows], dtype=float)
    each = [
        np.interp(speeds, at, [size if row.order == order else 0.0 for row, size in zip(rows, sizes)])
        for order in orders
    ]
    return orders, based_on(np.stack(each, -1).astype(complex), *sizes)


def given_motion(rows: Sequence[UnevenRow], speeds: Array, cycle: Radian, r_b1: Metre, i_1: Number = 1.0) -> Motion:
    """Of the first driver by an irregularity that is given, or taken; `cycle`: of the engine."""
    orders, alpha = given_accelerations(rows, np.asarray(speeds, dtype=float))
    omega = based_on(2 * np.pi * np.asarray(speeds, dtype=float), speeds)
    return Motion(orders, along_line(alpha_n=alpha, r_b1=r_b1, i_1=i_1), omega, float(cycle))


# --- what is published of one operating point


@record
class CrankMotion:
    """Of the rigid crank; `orders`: amplitudes of the lowest, by their words: 1_5, 3 …"""

    irregularity: Number
    up: RadPerSecond2
    down: RadPerSecond2
    orders: dict[str, RadPerSecond2]
    mean_torque: NewtonMetre | None


def published(
    alpha_n: ComplexArray, n: Array, speed: RevPerSecond, cycle: Radian, mean_torque: NewtonMetre | None = None
) -> CrankMotion:
    """Of one series (N,): of `acceleration` of the torque at one point, or of `given_accelerations`."""
    omega = based_on(2 * math.pi * speed, speed)
    return CrankMotion(
        irregularity=irregularity(alpha_n=alpha_n, n=n, omega=omega, cycle=cycle),
        up=largest_acceleration(alpha_n=alpha_n, n=n, cycle=cycle),
        down=smallest_acceleration(alpha_n=alpha_n, n=n, cycle=cycle),
        orders={
            order_word(order): amplitude(alpha_n=phasor)
            for order, phasor in zip(n[:SHOWN].tolist(), elements(alpha_n[:SHOWN]))
        },
        mean_torque=mean_torque,
    )
