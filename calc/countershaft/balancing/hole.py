# SPDX-License-Identifier: Apache-2.0
"""What a drill takes of a cylinder along a radius: mass and unbalance, exactly, and how deep it goes for a wanted
unbalance.

The drill has the radius a and a cone of the point angle θ; its full diameter goes to the depth h, counted on the hole's
axis from the outer radius R.  All of its full diameter must be in: below the least depth it is shallower than the
curve of the surface that it enters by."""

from math import cos, sin

from ...sheet.formula import formula
from ...sheet.functions import pi, sqrt, tan
from ...sheet.text import Text
from ...sheet.units import Kilogram, KilogramMetre, KilogramPerMetre3, Metre, Radian

HOLES = Text("geometry, a radial hole by a drill with its cone into a cylinder (Finotti 2013, 4.1, has it flat)")
NAMES = {"theta": "θ_c", "a": "a_c", "q": "q_h", "l": "l_c"}
_MEANINGS = {
    "rho": "Density",
    "R": "Outer radius at the hole",
    "a": "Radius of the drill",
    "q": "Distance of the hole's full diameter from the axis",
    "l": "Length of the drill's cone",
    "theta": "Point angle of the drill",
}


def _of(*names: str) -> dict[str, str]:
    return {name: _MEANINGS[name] for name in names}


POINTS = 64  # of the mean over the drill's circle; it is smooth and periodic, so that they give all digits


@formula("a_c", "geometry: radius of the drill", unit="mm", names={"d": "d_c"}, meanings={"d": "Diameter of a hole"})
def drill_radius(d: Metre) -> Metre:
    return d / 2


@formula("l_c", Text("{holes}: its cone", holes=HOLES), unit="mm", names=NAMES, meanings=_of("a", "theta"))
def cone_length(a: Metre, theta: Radian) -> Metre:
    """>>> cone_length(a=0.007, theta=118 * pi / 180)
    0.0042060243...
    """
    return a / tan(theta / 2)


@formula("q_h", Text("{holes}: where its full diameter ends", holes=HOLES), unit="mm", names={"h": "h_c"})
def bottom_radius(R: Metre, h: Metre) -> Metre:
    return R - h


@formula("h_c,min", Text("{holes}: the depth from which the drill is wholly in", holes=HOLES), unit="mm", names=NAMES)
def least_depth(R: Metre, a: Metre) -> Metre:
    """>>> least_depth(R=0.0405, a=0.007)
    0.0006095249...
    """
    return R - sqrt(R**2 - a**2)


@formula(
    "R_c,m",
    Text("{holes}: mean distance of the surface over the hole from the plane through the axis", holes=HOLES),
    shows="R·₂F₁(−½, ½; 2; a²/R²)",
    unit="mm",
    names=NAMES,
    meanings=_of("R", "a") | {"return": "Mean height of the surface over a hole"},
)
def mean_surface(R: Metre, a: Metre) -> Metre:
    """∬ √(R² − y²) over the drill's circle, by its area: R·(1 − a²/8R² − a⁴/64R⁴ − …)."""
    turns = [2 * pi * n / POINTS for n in range(POINTS)]
    mean: float = sum(2 * cos(t) ** 2 * (1 - (a / R * sin(t)) ** 2) ** 0.5 for t in turns) / POINTS
    return R * mean


@formula(
    "m_c",
    Text("{holes}: what it takes away", holes=HOLES),
    unit="g",
    names=NAMES | {"R_m": "R_c,m"},
    meanings=_of("rho", "a", "q", "l"),
)
def hole_mass(rho: KilogramPerMetre3, a: Metre, R_m: Metre, q: Metre, l: Metre) -> Kilogram:
    return rho * pi * a**2 * (R_m - q + l / 3)


@formula(
    "ΔU",
    Text("{holes}: unbalance taken away", holes=HOLES),
    unit="g·mm",
    names=NAMES,
    meanings=_of("rho", "a", "R", "q", "l"),
)
def hole_unbalance(rho: KilogramPerMetre3, a: Metre, R: Metre, q: Metre, l: Metre) -> KilogramMetre:
    return rho * pi * a**2 * ((R**2 - a**2 / 4 - q**2) / 2 + l / 3 * (q - l / 4))


@formula(
    "h_k",
    Text("{holes}: its depth for an unbalance, the inverse", holes=HOLES),
    unit="mm",
    names=NAMES | {"U": "u_k"},
    meanings=_of("rho", "a", "R", "l") | {"U": "Unbalance that a hole takes"},
)
def depth_for(U: KilogramMetre, rho: KilogramPerMetre3, a: Metre, R: Metre, l: Metre) -> Metre:
    """The depth of the full diameter.  Below the least depth, and below zero for less than the cone alone would take,
    it is the formula's and no hole's: see `least_depth`."""
    return R - l / 3 - sqrt(l**2 / 9 - (2 * U / (rho * pi * a**2) - R**2 + a**2 / 4 + l**2 / 6))
