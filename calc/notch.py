# SPDX-License-Identifier: Apache-2.0
"""Notch factors: how far the elastic stress at a fillet exceeds the nominal one.

Shouldered round shaft in bending, after the curves that Pilkey fitted to Peterson's charts.  The nominal stress is that of the smaller
diameter, σ = 32·M/(π·d³).  Valid for 0.1 ≤ t/r ≤ 20, t the height of the shoulder; at t/r = 2 the two
fits lie 0.1 to 1.4 % apart up to 2t/D = 0.7, 3 % at 0.9.
"""

from .sheet.formula import formula
from .sheet.functions import sqrt
from .sheet.text import Text
from .sheet.units import Metre, Number, Pascal

PETERSON = Text("Pilkey, chart 3.10: shouldered round shaft, bending")
FIT = (0.1, 20.0)  # of t/r
BRANCH = 2.0  # of t/r, where the second fit begins


@formula("ξ", "definition, t/r: height of the shoulder over the radius of its fillet")
def step_over_fillet(D: Metre, d: Metre, r: Metre) -> Number:
    return (D - d) / (2 * r)


@formula("ζ", "definition, 2·t/D: height of the shoulder over the larger radius")
def relative_step(D: Metre, d: Metre) -> Number:
    return (D - d) / D


@formula("K_t", Text("{peterson}, t/r up to 2", peterson=PETERSON), names={"x": "ξ", "y": "ζ"})
def low_shoulder(x: Number, y: Number) -> Number:
    """x = t/r from 0.1 to 2, y = 2t/D."""
    return (
        0.947 + 1.206 * sqrt(x) - 0.131 * x
        + (0.022 - 3.405 * sqrt(x) + 0.915 * x) * y
        + (0.869 + 1.777 * sqrt(x) - 0.555 * x) * y**2
        + (-0.810 + 0.422 * sqrt(x) - 0.260 * x) * y**3
    )  # fmt: skip


@formula("K_t", Text("{peterson}, t/r from 2 to 20", peterson=PETERSON), names={"x": "ξ", "y": "ζ"})
def high_shoulder(x: Number, y: Number) -> Number:
    """x = t/r from 2 to 20, y = 2t/D."""
    return (
        1.232 + 0.832 * sqrt(x) - 0.008 * x
        + (-3.813 + 0.968 * sqrt(x) - 0.260 * x) * y
        + (7.423 - 4.868 * sqrt(x) + 0.869 * x) * y**2
        + (-3.839 + 3.070 * sqrt(x) - 0.600 * x) * y**3
    )  # fmt: skip


@formula("σ_k", "elasticity: elastic stress at the fillet, notch factor times nominal stress", unit="MPa")
def notch_stress(K_t: Number, sigma: Pascal) -> Pascal:
    """>>> notch_stress(K_t=2.353, sigma=9918000)
    2333705...
    """
    return K_t * sigma


def shoulder_bending(D: Metre, d: Metre, r: Metre) -> tuple[Number, Number]:
    """t/r and K_t of a shoulder from the diameter D down to d.  Outside `FIT` the factor is an extrapolation: the caller says so."""
    x = step_over_fillet(D=D, d=d, r=r)
    y = relative_step(D=D, d=d)
    return x, low_shoulder(x=x, y=y) if x <= BRANCH else high_shoulder(x=x, y=y)
