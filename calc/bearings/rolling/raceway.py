# SPDX-License-Identifier: Apache-2.0
"""What a shaft has to be where elements roll on it, and how far a journal may stand aslant in a bearing."""

from ...library.tolerances import tolerance
from ...sheet.formula import formula
from ...sheet.functions import largest
from ...sheet.text import Text
from ...sheet.units import Metre, Number, Radian
from .torque import INA, constants

# At least 58 HRC, at most this Ra up to 80 mm, roundness and parallelism by this grade: as INA, IKO and SKF print it.
HARDNESS: Number = 670.0  # HV
ROUGHNESS: Metre = 0.2e-6
ROUNDNESS = 3
SEAT_FORM = 5  # half of this grade is the cylindricity of a seat under a ring of class normal: SKF, from memory
LEAST_CASE: Metre = 0.3e-3


@formula("Eht_need", Text("{ina}: depth of the hardened case beneath a raceway", ina=INA), unit="mm")
def case_depth_needed(D_w: Metre) -> Metre:
    """>>> case_depth_needed(D_w=2.5e-3)
    0.0003
    """
    return largest(0.078 * D_w, LEAST_CASE)


def roundness_needed(F_w: Metre) -> Metre:
    """What roundness and parallelism of a raceway on the shaft may be."""
    return tolerance(ROUNDNESS, F_w)


def seat_form(d: Metre) -> Metre:
    """How far the seat of an inner ring may be from a cylinder."""
    return tolerance(SEAT_FORM, d) / 2


def largest_slope(type: str, series: str) -> Radian:
    """How far the journal may stand aslant in the bearing [rad]; half of it is near.

    One's own roller bearing as series 2; needles, drawn cups and cages alike."""
    slopes = constants("slope")
    if type == "ball":
        name = "ball"
    elif type == "roller":
        name = "wide_roller" if series in ("22", "23") else "roller"
    else:
        name = "needle"
    mrad: float = slopes[name]
    return mrad / 1000
