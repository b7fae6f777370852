# SPDX-License-Identifier: Apache-2.0
"""What people feel of a vibration: the weightings of ISO 2631-1 and ISO 5349-1 as transfer functions, at the frequency of each line.

They are never taken from the tables of third-octaves: one of these has 0.212 for W_d at 10 Hz, where the function gives 0.2017.
"""

import numpy as np

from ..sheet.arrays import Array, each, many
from ..sheet.formula import formula
from ..sheet.functions import largest, modulus, sqrt
from ..sheet.units import Hertz, MetrePerSecond2, Number, PhasorHertz, PhasorNumber
from .tables import Filter, weighting

ISO = "ISO 8041: transfer functions of the frequency weightings"


@formula("H_h", ISO, names={"s": "s_f"})
def high_pass(s: PhasorHertz, f_1: Hertz) -> PhasorNumber:
    """`s` = i·f."""
    return s**2 / (s**2 + sqrt(2.0) * f_1 * s + f_1**2)


@formula("H_l", ISO, names={"s": "s_f"})
def low_pass(s: PhasorHertz, f_2: Hertz) -> PhasorNumber:
    return 1 / (1 + sqrt(2.0) * s / f_2 + (s / f_2) ** 2)


@formula("H_t", ISO, names={"s": "s_f"})
def transition(s: PhasorHertz, f_3: Hertz, Q_4: Number, f_4: Hertz) -> PhasorNumber:
    return (1 + s / f_3) / (1 + s / (Q_4 * f_4) + (s / f_4) ** 2)


@formula("H_s", ISO, names={"s": "s_f"})
def upward_step(s: PhasorHertz, f_5: Hertz, Q_5: Number, f_6: Hertz, Q_6: Number) -> PhasorNumber:
    return (f_5 / f_6) ** 2 * (1 + s / (Q_5 * f_5) + (s / f_5) ** 2) / (1 + s / (Q_6 * f_6) + (s / f_6) ** 2)


@formula("W", "ISO 8041: amount of the transfer function at the frequency of the line")
def weight(H_h: PhasorNumber, H_l: PhasorNumber, H_t: PhasorNumber, H_s: PhasorNumber) -> Number:
    return modulus(H_h * H_l * H_t * H_s)


@formula("a_w", "ISO 2631-1, 6.2: weighted acceleration of all orders, rms", shows="√(Σ (W_n·|â_n|)²/2)", unit="m/s²")
def weighted(W: Number, a: MetrePerSecond2) -> MetrePerSecond2:
    """Of the lines along the last axis."""
    found = np.sqrt(np.sum(np.square(np.asarray(W) * np.abs(a)), -1) / 2)
    return each(found) if found.ndim else float(found)


@formula(
    "a_v",
    "ISO 2631-1, 6.5 and ISO 5349-1: vibration total value of the three axes",
    unit="m/s²",
    names={"x": "a_w,x", "y": "a_w,y", "z": "a_w,z"},
)
def total_value(x: MetrePerSecond2, y: MetrePerSecond2, z: MetrePerSecond2) -> MetrePerSecond2:
    return sqrt(x**2 + y**2 + z**2)


@formula(
    "A(8)",
    "Directive 2002/44/EC, annex B with ISO 2631-1: worst axis of a day, referred to 8 h",
    unit="m/s²",
    shows="max{1.4·x, 1.4·y, z} of √(Σ a_w²·T/8 h)",
)
def whole_body(a: MetrePerSecond2, T: Number) -> MetrePerSecond2:
    """`a`: (operations, axes), `T` hours of each."""
    energy = np.sqrt(np.sum(np.square(a) * np.asarray(T)[:, None], 0) / 8)
    return largest(largest(1.4 * float(energy[0]), 1.4 * float(energy[1])), float(energy[2]))


@formula(
    "A(8)", "Directive 2002/44/EC, annex A with ISO 5349-1: total value of a day, referred to 8 h", unit="m/s²", shows="√(Σ a_v²·T/8 h)"
)
def hand_arm(a: MetrePerSecond2, T: Number) -> MetrePerSecond2:
    return float(np.sqrt(np.sum(np.square(a) * np.asarray(T)) / 8))


def weights(name: str, f: Array) -> Array:
    """W_k, W_d ("Wk", "Wd") or W_h at any frequencies."""
    by: Filter = weighting(name)
    s = each(1j * np.asarray(f, dtype=float))
    step: complex = upward_step(s, *by.steps) if by.steps is not None else 1.0 + 0j
    return many(weight(high_pass(s, by.f_1), low_pass(s, by.f_2), transition(s, by.f_3, by.Q_4, by.f_4), step))
