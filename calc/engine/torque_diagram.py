# SPDX-License-Identifier: Apache-2.0
"""What a torque diagram gives: mean, extremes and fluctuation of the energy; straight lines between its rows, closed over its period."""

import math
from typing import TypedDict

import numpy as np

from ..sheet.arrays import Array, each
from ..sheet.formula import formula
from ..sheet.linked_array import gathered
from ..sheet.step import Curve, Series, axis_label
from ..sheet.text import Amount, Text
from ..sheet.units import KilogramMetre2, NewtonMetre, Number, Radian, RadPerSecond, Watt
from . import torque_formulas as t
from .torque_inputs import TorquePoint

AREA = Text("mathematics: area of the torque diagram over its period, straight lines between its rows")


class OfDiagram(TypedDict):
    """What the diagram gives of a `TorqueResult`."""

    torque_peak: NewtonMetre
    torque_peak_angle: Radian
    mean_torque: NewtonMetre
    indicated_power: Watt
    energy_fluctuation: NewtonMetre
    torque_highest: NewtonMetre
    torque_lowest: NewtonMetre
    speed_irregularity: Number | None


@formula("T_m", AREA, shows="∮T dε over the period")
def mean(angles: Radian, T: NewtonMetre, period: Radian) -> NewtonMetre:
    epsilon, torque = closed(angles, T, period)
    return float(np.sum((torque[1:] + torque[:-1]) * np.diff(epsilon)) / 2 / period)


@formula("ΔE", AREA, shows="max − min over the period of ∫(T − T_m)dε, which is largest and smallest where T passes T_m")
def fluctuation(angles: Radian, T: NewtonMetre, T_m: NewtonMetre, period: Radian) -> NewtonMetre:
    epsilon, torque = closed(angles, T, period)
    over = torque - T_m
    passes = np.flatnonzero(over[:-1] * over[1:] < 0)
    at = epsilon[passes] + (epsilon[passes + 1] - epsilon[passes]) * over[passes] / (over[passes] - over[passes + 1])
    order = np.argsort(np.append(epsilon, at), kind="stable")
    x, y = np.append(epsilon, at)[order], np.append(over, np.zeros(at.size))[order]
    energy = np.append(0.0, np.cumsum((y[1:] + y[:-1]) * np.diff(x) / 2))
    return float(energy.max() - energy.min())


@formula("ε_max", "mathematics: row of the torque diagram with the largest amount of torque", shows="its crank angle")
def place(epsilon: Radian) -> Radian:
    return epsilon


def closed(angles: Radian, T: NewtonMetre, period: Radian) -> tuple[Array, Array]:
    """The rows over one whole period, the first once more at its end."""
    epsilon, torque = np.asarray(angles), np.asarray(T)
    if period - (epsilon[-1] - epsilon[0]) > 1e-9:
        return np.append(epsilon, epsilon[0] + period), np.append(torque, torque[0])
    return epsilon, torque


def solve(rows: tuple[TorquePoint, ...], period: Radian, omega: RadPerSecond, J: KilogramMetre2 | None) -> tuple[OfDiagram, Curve, Text]:
    """Values, figure and note of a torque diagram; `J`: of the flywheel."""
    angles = each(gathered(row.angle for row in rows))
    T = each(gathered(row.torque for row in rows))
    T_m = mean(angles=angles, T=T, period=period)
    Delta_E = fluctuation(angles=angles, T=T, T_m=T_m, period=period)
    T_highest, T_lowest = t.highest(T=T), t.lowest(T=T)
    largest = int(np.argmax(np.abs(np.asarray(T))))
    found = OfDiagram(
        torque_peak=t.amount(T=rows[largest].torque), torque_peak_angle=place(epsilon=rows[largest].angle),
        mean_torque=T_m, indicated_power=t.indicated_power(T_m=T_m, omega=omega), energy_fluctuation=Delta_E,
        torque_highest=T_highest, torque_lowest=T_lowest,
        speed_irregularity=None if J is None else t.speed_irregularity(Delta_E=Delta_E, J=J, omega=omega),
    )  # fmt: skip
    epsilon, torque = closed(angles, T, period)
    curve = Curve(
        "torque", Text("Torque about the crank as given"), axis_label("crank angle after the firing of cylinder 1", "°"),
        axis_label("T", "N·m"), (Series(Text("total"), np.degrees(epsilon), torque),), limits=((Text("mean"), T_m),),
    )  # fmt: skip
    repeats = Text("The torque is that of the diagram as given, of gas and inertia together, which repeats every {length}°.",
        length=Amount(math.degrees(period), form="g"))  # fmt: skip
    return found, curve, repeats
