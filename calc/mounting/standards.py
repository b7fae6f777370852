# SPDX-License-Identifier: Apache-2.0
"""What standards say of vibration: which of them applies to this engine, grades of severity, what people feel."""

from functools import cache
from typing import Any

import numpy as np

from ..library.table_file import TableRow, house_table
from ..sheet.arrays import Array, ComplexArray
from ..sheet.formula import formula
from ..sheet.functions import largest, modulus, sqrt
from ..sheet.record import record
from ..sheet.text import Text
from ..sheet.units import (
    Hertz,
    Metre,
    MetrePerSecond,
    MetrePerSecond2,
    MetresPerSecond2,
    Number,
    Numbers,
    PhasorHertz,
    PhasorNumber,
    RevPerSecond,
    Watt,
)

# --- the tables, from `calc/library/tables/vibration.toml`
# Each row there names its source and how sure it is.


def table() -> TableRow:
    return house_table("vibration.toml")


@record
class Filter:
    """A frequency weighting by the corner frequencies and quality factors of its transfer function."""

    f_1: float
    f_2: float
    f_3: float
    f_4: float
    Q_4: float
    steps: tuple[float, float, float, float] | None  # f_5, Q_5, f_6, Q_6


@cache
def weighting(name: str) -> Filter:
    row = next(row for row in table()["weighting"] if row["name"] == name)
    f, Q = row["f"], row["Q"]
    steps = (f[4], Q[1], f[5], Q[2]) if len(f) > 4 else None
    return Filter(f_1=f[0], f_2=f[1], f_3=f[2], f_4=f[3], Q_4=Q[0], steps=steps)


# --- the severity of a machine's vibration
# Grades, and first of all which standard has anything to say of this engine.

NOT_ROAD = Text(
    'ISO 10816-6 "does not apply to machines installed in road vehicles (e.g. trucks, passenger cars, self-propelling '
    "construction "
    'machinery and tractors)": the grade is information, no verdict.'
)
NOT_SMALL = Text("ISO 10816-6 is for reciprocating machines above 100 kW: the grade is information, no verdict.")
NOT_BOTH = Text(
    'ISO 10816-6 is for reciprocating machines above 100 kW and "does not apply to machines installed in road '
    "vehicles (e.g. trucks, "
    'passenger cars, self-propelling construction machinery and tractors)": this engine is out twice; the grade is '
    "information, no verdict."
)
WITHIN = Text("ISO 10816-6 applies: a reciprocating machine above 100 kW that stands in no road vehicle.")
NO_CLASS = Text("No class of the machine is given: the grade is not judged.")
COMPRESSORS = Text(
    "ISO 20816-8 is for reciprocating compressor systems on rigid foundations, drivers excluded: it never applies to "
    "an engine."
)
GENERAL = Text("ISO 20816-1 is the general part and has no limits for engines.")
SET = Text("ISO 8528-9 applies to the engine of this generating set: 0.72 mm, 45 mm/s, 28 m/s², rms.")
SET_NOT_PRINTED = Text("ISO 8528-9 prints no limits for a generating set of this speed and power: not asked.")
LOWER_BOUND = Text(
    "The model sees only what the rigid body does of the 2 to 1000 Hz that severity is measured over: its grade is a "
    "lower bound."
)
ROAD = ("construction-machine", "tractor", "road")
SMALLEST = 100e3  # W


@record
class Scope:
    """Which standard judges the engine, and what is to be said first of all."""

    iso_10816: bool
    iso_8528: bool
    sentences: tuple[Text, ...]


def scope(application: str, power: Watt | None, speed: RevPerSecond, machine_class: int | None) -> Scope:
    """`power`: rated; where it is not known the engine counts as small."""
    small, on_road = power is None or power <= SMALLEST, application in ROAD
    within = not small and not on_road
    notes = [WITHIN if within else NOT_BOTH if small and on_road else NOT_ROAD if on_road else NOT_SMALL]
    if within and machine_class is None:
        notes.append(NO_CLASS)
    printed = application == "generating-set" and power is not None and _printed(speed * 60, power / 1e3)
    if application == "generating-set":
        notes.append(SET if printed else SET_NOT_PRINTED)
    return Scope(within, printed, (*notes, COMPRESSORS, GENERAL, LOWER_BOUND))


def _printed(rpm: float, kW: float) -> bool:
    """Whether limits are printed: at 2000 rpm and more, or up to 100 kW, there are none."""
    rows = table()["generating_set_range"]
    return any(row["low_rpm"] <= rpm < row["high_rpm"] and row["low_kW"] < kW <= row["high_kW"] for row in rows)


@formula(
    "grade",
    "ISO 10816-6:1995, table 1 (from memory)",
    shows="the highest that displacement, velocity or acceleration of any axis asks for",
)
def grade(s: Metre, v: MetrePerSecond, a: MetrePerSecond2) -> Number:
    """Of each axis along the last one; the largest counts."""
    t = table()["severity"]
    first, step, grades = t["exponent_first"], t["exponent_step"], np.asarray(t["grades"])
    limits = 1e-3 * 10.0 ** (first + step * np.arange(len(grades) - 1))
    two_pi = 2 * np.pi
    sizes = np.maximum(
        np.maximum(np.asarray(v), np.asarray(s) * two_pi * t["corner_low_Hz"]),
        np.asarray(a) / (two_pi * t["corner_high_Hz"]),
    )
    worst = sizes.max(-1)
    graded: Any = np.where(np.isfinite(worst), grades[np.searchsorted(limits, worst * (1 - 1e-12))], np.nan)
    return graded if graded.ndim else float(graded)


def in_band(f: Array) -> Array:
    """Which frequencies count for severity."""
    low, high = table()["severity"]["band_Hz"]
    band: Array = (f >= low) & (f <= high)
    return band


def zone_limit(machine_class: int) -> float:
    """The grade up to which zone A/B of a class reaches."""
    return float(next(row["limits"][0] for row in table()["severity_class"] if row["class"] == machine_class))


# --- what people feel: the weightings of ISO 2631-1 and ISO 5349-1 as transfer functions
# At the frequency of each line.
#
# They are never taken from the tables of third-octaves: one of these has 0.212 for W_d at 10 Hz, where the function
# gives 0.2017.

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
    level = np.sqrt(np.sum(np.square(np.asarray(W) * np.abs(a)), -1) / 2)
    return level if level.ndim else float(level)


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
def whole_body(a: MetresPerSecond2, T: Numbers) -> MetrePerSecond2:
    """`a`: (operations, axes), `T` hours of each."""
    energy = np.sqrt(np.sum(np.square(a) * np.asarray(T)[:, None], 0) / 8)
    return largest(largest(1.4 * float(energy[0]), 1.4 * float(energy[1])), float(energy[2]))


@formula(
    "A(8)",
    "Directive 2002/44/EC, annex A with ISO 5349-1: total value of a day, referred to 8 h",
    unit="m/s²",
    shows="√(Σ a_v²·T/8 h)",
)
def hand_arm(a: MetresPerSecond2, T: Numbers) -> MetrePerSecond2:
    return float(np.sqrt(np.sum(np.square(a) * np.asarray(T)) / 8))


def weights(name: str, f: Array) -> Array:
    """W_k, W_d ("Wk", "Wd") or W_h at any frequencies."""
    by: Filter = weighting(name)
    s = 1j * np.asarray(f, dtype=float)
    step: ComplexArray | complex = upward_step(s, *by.steps) if by.steps is not None else 1.0 + 0j
    return weight(high_pass(s, by.f_1), low_pass(s, by.f_2), transition(s, by.f_3, by.Q_4, by.f_4), step)
