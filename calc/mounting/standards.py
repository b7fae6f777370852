# SPDX-License-Identifier: Apache-2.0
"""The severity of a machine's vibration: grades, and first of all which standard has anything to say of this engine."""

import numpy as np

from ..sheet.arrays import Array, each
from ..sheet.formula import formula
from ..sheet.record import record
from ..sheet.text import Text
from ..sheet.units import Metre, MetrePerSecond, MetrePerSecond2, Number, RevPerSecond, Watt
from .tables import table

NOT_ROAD = Text(
    'ISO 10816-6 "does not apply to machines installed in road vehicles (e.g. trucks, passenger cars, self-propelling construction '
    'machinery and tractors)": the grade is information, no verdict.'
)
NOT_SMALL = Text("ISO 10816-6 is for reciprocating machines above 100 kW: the grade is information, no verdict.")
NOT_BOTH = Text(
    'ISO 10816-6 is for reciprocating machines above 100 kW and "does not apply to machines installed in road vehicles (e.g. trucks, '
    'passenger cars, self-propelling construction machinery and tractors)": this engine is out twice; the grade is information, no verdict.'
)
WITHIN = Text("ISO 10816-6 applies: a reciprocating machine above 100 kW that stands in no road vehicle.")
NO_CLASS = Text("No machine_class is given: the grade is not judged.")
COMPRESSORS = Text(
    "ISO 20816-8 is for reciprocating compressor systems on rigid foundations, drivers excluded: it never applies to an engine."
)
GENERAL = Text("ISO 20816-1 is the general part and has no limits for engines.")
SET = Text("ISO 8528-9 applies to the engine of this generating set: 0.72 mm, 45 mm/s, 28 m/s², rms.")
SET_NOT_PRINTED = Text("ISO 8528-9 prints no limits for a generating set of this speed and power: not asked.")
LOWER_BOUND = Text(
    "The model sees only what the rigid body does of the 2 to 1000 Hz that severity is measured over: its grade is a lower bound."
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
    said = [WITHIN if within else NOT_BOTH if small and on_road else NOT_ROAD if on_road else NOT_SMALL]
    if within and machine_class is None:
        said.append(NO_CLASS)
    printed = application == "generating-set" and power is not None and _printed(speed * 60, power / 1e3)
    if application == "generating-set":
        said.append(SET if printed else SET_NOT_PRINTED)
    return Scope(within, printed, (*said, COMPRESSORS, GENERAL, LOWER_BOUND))


def _printed(rpm: float, kW: float) -> bool:
    """Whether limits are printed: at 2000 rpm and more, or up to 100 kW, there are none."""
    rows = table()["generating_set_range"]
    return any(row["low_rpm"] <= rpm < row["high_rpm"] and row["low_kW"] < kW <= row["high_kW"] for row in rows)


@formula(
    "grade", "ISO 10816-6:1995, table 1 (from memory)", shows="the highest that displacement, velocity or acceleration of any axis asks for"
)
def grade(s: Metre, v: MetrePerSecond, a: MetrePerSecond2) -> Number:
    """Of each axis along the last one; the largest counts."""
    t = table()["severity"]
    first, step, grades = t["exponent_first"], t["exponent_step"], np.asarray(t["grades"])
    limits = 1e-3 * 10.0 ** (first + step * np.arange(len(grades) - 1))
    two_pi = 2 * np.pi
    sizes = np.maximum(
        np.maximum(np.asarray(v), np.asarray(s) * two_pi * t["corner_low_Hz"]), np.asarray(a) / (two_pi * t["corner_high_Hz"])
    )
    worst = sizes.max(-1)
    found = np.where(np.isfinite(worst), grades[np.searchsorted(limits, worst * (1 - 1e-12))], np.nan)
    return each(found) if found.ndim else float(found)


def in_band(f: Array) -> Array:
    """Which frequencies count for severity."""
    low, high = table()["severity"]["band_Hz"]
    band: Array = (f >= low) & (f <= high)
    return band


def zone_limit(machine_class: int) -> float:
    """The grade up to which zone A/B of a class reaches."""
    return float(next(row["limits"][0] for row in table()["severity_class"] if row["class"] == machine_class))
