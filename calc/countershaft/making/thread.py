# SPDX-License-Identifier: Apache-2.0
"""Metric threads: the designation read, and the diameters of ISO 724 and ISO 898-1."""

import re
from math import pi

from ...sheet.errors import text_of
from ...sheet.formula import formula
from ...sheet.text import Text
from ...sheet.units import Metre, SquareMetre

# Coarse pitch of each nominal diameter, mm (ISO 261); of the pitches of a diameter it is the largest.
COARSE = {
    1.0: 0.25, 1.1: 0.25, 1.2: 0.25, 1.4: 0.3, 1.6: 0.35, 1.8: 0.35, 2.0: 0.4, 2.2: 0.45, 2.5: 0.45, 3.0: 0.5, 3.5: 0.6, 4.0: 0.7,
    4.5: 0.75, 5.0: 0.8, 6.0: 1.0, 7.0: 1.0, 8.0: 1.25, 9.0: 1.25, 10.0: 1.5, 11.0: 1.5, 12.0: 1.75, 14.0: 2.0, 16.0: 2.0, 18.0: 2.5,
    20.0: 2.5, 22.0: 2.5, 24.0: 3.0, 27.0: 3.0, 30.0: 3.5, 33.0: 3.5, 36.0: 4.0, 39.0: 4.0, 42.0: 4.5, 45.0: 4.5, 48.0: 5.0, 52.0: 5.0,
    56.0: 5.5, 60.0: 5.5, 64.0: 6.0,
}  # fmt: skip
DIAMETERS = (1.0, 300.0)  # mm, smallest and largest of ISO 261
FINEST, LARGEST = 0.2, 8.0  # mm, pitches of ISO 261
DESIGNATION = re.compile(r"M *([0-9]+(?:\.[0-9]+)?)(?: *[x×] *([0-9]+(?:\.[0-9]+)?))?", re.IGNORECASE)


def thread(text: str) -> tuple[Metre, Metre]:
    """Nominal diameter and pitch of a metric thread: "M10", "M10x1.5", "M10×1.5".  Raises ValueError, which says what is allowed."""
    match = DESIGNATION.fullmatch(text.strip())
    if match is None:
        raise ValueError("must be a metric thread like M10 (coarse pitch of ISO 261) or M10x1.25, in mm")
    D, given = float(match[1]), match[2]
    if not DIAMETERS[0] <= D <= DIAMETERS[1]:
        raise ValueError(f"must be from M{DIAMETERS[0]:g} to M{DIAMETERS[1]:g} (ISO 261)")
    if given is None and D not in COARSE:
        raise ValueError(f"M{D:g} has no coarse pitch in ISO 261: give the pitch too, like M{D:g}x{max(_coarsest(D) / 2, FINEST):g}")
    p = COARSE[D] if given is None else float(given)
    if not FINEST <= p <= _coarsest(D):
        raise ValueError(f"the pitch of M{D:g} must be from {FINEST:g} to {_coarsest(D):g} mm (ISO 261)")
    return D / 1000, p / 1000


def _coarsest(D: float) -> float:
    """The largest pitch of a diameter, mm; of one between those of ISO 261, that of the next."""
    return next((pitch for size, pitch in COARSE.items() if size >= D), LARGEST)


def thread_problem(text: str) -> Text | None:
    """What is wrong with a thread's designation; None where it can be read."""
    try:
        thread(text)
    except ValueError as e:
        return text_of(e)
    return None


@formula("D", "ISO 261: nominal diameter, the first number of the thread's designation", shows="number behind M in the designation",
    unit="mm")  # fmt: skip
def nominal_diameter(designation: str) -> Metre:
    return thread(designation)[0]


@formula("P_h", "ISO 261: pitch of the thread, as in its designation, else the coarse one", shows="number behind ×, or coarse pitch",
    unit="mm")  # fmt: skip
def pitch(designation: str) -> Metre:
    return thread(designation)[1]


@formula("d_2", "ISO 724: pitch diameter of the metric thread", unit="mm", names={"p": "P_h"})
def pitch_diameter(D: Metre, p: Metre) -> Metre:
    return D - 0.649519 * p


@formula("d_3", "ISO 898-1: root diameter of the thread, d_1 − H/6", unit="mm", names={"p": "P_h"})
def root_diameter(D: Metre, p: Metre) -> Metre:
    return D - 1.226869 * p


@formula("A_s", "ISO 898-1: nominal stress area of the thread", unit="mm²")
def stress_area(d_2: Metre, d_3: Metre) -> SquareMetre:
    return pi / 4 * ((d_2 + d_3) / 2) ** 2
