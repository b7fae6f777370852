# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""Hertz's contact of one element with its raceways: of a ball an ellipse, of a roller a line.

Elliptic integrals by the arithmetic-geometric mean, of parameter 1 − 1/x², x the ratio of the ellipse's axes."""

from functools import cache
from typing import Any

import numpy as np

from ...sheet.arrays import Array
from ...sheet.formula import formula
from ...sheet.functions import modulus, pi, single_or_many, sqrt
from ...sheet.text import Text
from ...sheet.units import Metre, Newton, Number, Pascal, PerMetre

HERTZ = Text("Hertz 1881")
MODULUS: Pascal = 207e9  # steel of rolling bearings as in ISO/TS 16281; that of shafts and seats is their material's
POISSON: Number = 0.3
PLANE: Pascal = MODULUS / (1 - POISSON**2)

# --- elliptic integrals and the axes of an ellipse

MEANS = 7  # passes of the mean: enough for x up to 10⁴
LONGEST = 6.0  # ln x: far beyond any groove
POINTS = 3000


def elliptic(x: Any) -> tuple[Any, Any]:
    """Complete elliptic integrals of the first and the second kind, of parameter 1 − 1/x², x ≥ 1."""
    x = np.asarray(x, dtype=float)
    a, g, missing, power = np.ones_like(x), 1 / x, (1 - x**-2) / 2, 0.5
    for _ in range(MEANS):
        a, g, half = (a + g) / 2, np.sqrt(a * g), (a - g) / 2
        power *= 2
        missing = missing + power * half**2
    first = np.pi / (2 * a)
    return first, first * (1 - missing)


@cache
def _axes_by_curvature() -> tuple[Array, Array]:
    """artanh of the difference of the curvatures over their sum, and ln x, from a circle on."""
    ln_x = np.linspace(1e-3, LONGEST, POINTS)
    square = np.exp(2 * ln_x)
    first, second = elliptic(np.exp(ln_x))
    t = ((square + 1) * second - 2 * first) / ((square - 1) * second)
    return np.concatenate([[0.0], np.arctanh(t)]), np.concatenate([[0.0], ln_x])


@formula(
    "χ",
    Text("{hertz}: ratio of the axes of the ellipse", hertz=HERTZ),
    shows="χ > 1 with ((χ² + 1)·ℰ − 2·K_E)/((χ² − 1)·ℰ) = F_ρ, by table",
)
def axis_ratio(t: Number) -> Number:
    """>>> axis_ratio(t=0.0)
    1.0
    """
    return single_or_many(np.exp(np.interp(np.arctanh(np.asarray(t, dtype=float)), *_axes_by_curvature())))


@formula("K_E", "mathematics: complete elliptic integral of the first kind, parameter 1 − 1/χ²", shows="K_E(1 − 1/χ²)")
def elliptic_first(x: Number) -> Number:
    return single_or_many(elliptic(x)[0])


@formula("ℰ", "mathematics: complete elliptic integral of the second kind, parameter 1 − 1/χ²", shows="ℰ(1 − 1/χ²)")
def elliptic_second(x: Number) -> Number:
    return single_or_many(elliptic(x)[1])


# --- a ball in its groove


@formula(
    "ρ_1",
    "geometry: curvature along the inner raceway",
    names={"gamma": "γ"},
    meanings={"D_w": "Diameter of the rolling elements"},
)
def curvature_inner(D_w: Metre, gamma: Number) -> PerMetre:
    return 2 / D_w * (1 + gamma / (1 - gamma))


@formula("ρ_1", "geometry: curvature along the outer raceway", meanings={"D_w": "Diameter of the rolling elements"})
def curvature_outer(D_w: Metre, gamma: Number) -> PerMetre:
    return 2 / D_w * (1 - gamma / (1 + gamma))


@formula(
    "ρ_2",
    "geometry: curvature across the groove",
    meanings={"D_w": "Diameter of the rolling elements", "f_r": "Radius of the groove over the diameter of the balls"},
)
def curvature_across(D_w: Metre, f_r: Number) -> PerMetre:
    return 2 / D_w - 1 / (f_r * D_w)


@formula("Σρ", "geometry: sum of the curvatures")
def curvature(rho_1: PerMetre, rho_2: PerMetre) -> PerMetre:
    return rho_1 + rho_2


@formula("F_ρ", Text("{hertz}: difference of the curvatures over their sum", hertz=HERTZ), names={"S": "Σρ"})
def curvature_difference(rho_1: PerMetre, rho_2: PerMetre, S: PerMetre) -> Number:
    return modulus(rho_1 - rho_2) / S


@formula(
    "b",
    Text("{hertz}: shorter half axis", hertz=HERTZ),
    unit="mm",
    names={"E_2": "ℰ", "Q": "Q_w", "x": "χ", "E_r": "E'", "S": "Σρ"},
    meanings={"E_r": "Modulus of both bodies together"},
)
def half_axis(E_2: Number, Q: Newton, x: Number, E_r: Pascal, S: PerMetre) -> Metre:
    return (6 * E_2 * Q / (pi * x * E_r * S)) ** (1 / 3)


@formula("p_H", Text("{hertz}: largest pressure of an ellipse", hertz=HERTZ), unit="MPa", names={"Q": "Q_w", "x": "χ"})
def ellipse_pressure(Q: Newton, x: Number, b: Metre) -> Pascal:
    return 1.5 * Q / (pi * x * b**2)


@formula(
    "δ_1",
    Text("{hertz}: approach of ball and raceway", hertz=HERTZ),
    unit="µm",
    names={"E_1": "K_E", "E_2": "ℰ", "Q": "Q_w", "x": "χ", "E_r": "E'", "S": "Σρ"},
    meanings={"Q": "Load on a rolling element", "E_r": "Modulus of both bodies together"},
)
def approach(E_1: Number, S: PerMetre, E_2: Number, Q: Newton, x: Number, E_r: Pascal) -> Metre:
    return E_1 * (9 * S / (2 * E_2) * (Q / (pi * x * E_r)) ** 2) ** (1 / 3)


@formula(
    "Q_p",
    Text("{hertz}: load of the ball that makes this pressure", hertz=HERTZ),
    names={"p": "p_H", "E_2": "ℰ", "x": "χ", "E_r": "E'", "S": "Σρ"},
    meanings={"p": "Contact pressure", "E_r": "Modulus of both bodies together"},
)
def load_at_pressure(x: Number, E_2: Number, p: Pascal, E_r: Pascal, S: PerMetre) -> Newton:
    return 32 / 3 * pi * x * E_2**2 * p**3 / (E_r * S) ** 2


class BallContact:
    """One ball on one raceway: the curvatures, the ratio of the axes and its elliptic integrals."""

    def __init__(self, D_w: Any, gamma: Any, f_r: Any, inner: bool) -> None:
        rho_1 = curvature_inner(D_w=D_w, gamma=gamma) if inner else curvature_outer(D_w=D_w, gamma=gamma)
        rho_2 = curvature_across(D_w=D_w, f_r=f_r)
        self.S = curvature(rho_1=rho_1, rho_2=rho_2)
        self.x = axis_ratio(t=curvature_difference(rho_1=rho_1, rho_2=rho_2, S=self.S))
        self.E_1, self.E_2 = elliptic_first(x=self.x), elliptic_second(x=self.x)

    def pressure(self, Q: Any) -> Any:
        b = half_axis(E_2=self.E_2, Q=Q, x=self.x, E_r=PLANE, S=self.S)
        return ellipse_pressure(Q=Q, x=self.x, b=b)

    def approach(self, Q: Newton) -> Any:
        return approach(E_1=self.E_1, S=self.S, E_2=self.E_2, Q=Q, x=self.x, E_r=PLANE)

    def load(self, p: Pascal) -> Any:
        return load_at_pressure(x=self.x, E_2=self.E_2, p=p, E_r=PLANE, S=self.S)


# --- a roller on the inner raceway, the narrower of the two


@formula(
    "b",
    Text("{hertz}: half the width of the line", hertz=HERTZ),
    unit="mm",
    names={"Q": "Q_w", "E_r": "E'"},
)
def line_width(Q: Newton, L_we: Metre, E_r: Pascal, D_w: Metre, F_w: Metre) -> Metre:
    return sqrt(8 * Q / (pi * L_we * E_r * (2 / D_w + 2 / F_w)))


@formula("p_H", Text("{hertz}: largest pressure of a line", hertz=HERTZ), unit="MPa", names={"Q": "Q_w"})
def line_pressure(Q: Newton, L_we: Metre, b: Metre) -> Pascal:
    return 2 * Q / (pi * L_we * b)


@formula("z_τ", Text("{hertz}: depth of the largest shear stress under a line", hertz=HERTZ), unit="mm")
def shear_depth(b: Metre) -> Metre:
    return 0.786 * b
