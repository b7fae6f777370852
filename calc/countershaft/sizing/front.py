# SPDX-License-Identifier: Apache-2.0
"""The least mass of the sectors against their outer radius, a line a material: what a larger seat saves."""

from collections.abc import Mapping

import numpy as np

from ...sheet.arrays import distinct, each, many
from ...sheet.step import Curve, Series, axis_label
from ...sheet.text import Name, Text
from ...sheet.trace import untraced
from ...sheet.units import Metre, PhasorKilogramMetre, PhasorKilogramMetre2
from ..inputs import Extra
from . import cost_formulas as f
from .formulas import radius_needed
from .sectors import TooSmall, masses, remainder, size

POINTS = 25  # of a front


def front_curve(U: PhasorKilogramMetre, P: PhasorKilogramMetre2, omega: float, R: Metre, r_0: Metre, z_max: Metre,
    densities: Mapping[str, float], extras: tuple[Extra, ...] = ()) -> Curve | None:  # fmt: skip
    """Least mass of the sectors against their outer radius, from the smallest that serves to that of the envelope; a line a material.

    `U`, `P`: asked of the whole shaft.  None where no material fits into the envelope; one that does not has no line.
    """
    names = sorted(densities, key=lambda name: -densities[name])
    heavy = densities[names[0]]
    with untraced():
        left = remainder(U, P, extras)
        try:
            u = size(*left, omega, heavy, R, r_0, z_max).utilisation
        except TooSmall:
            return None
        start = radius_needed(R=R, r_0=r_0, u=u) * (1 + 1e-9)
        ends = [f.radius_for(R=R, r_0=r_0, rho=densities[name], rho_m=heavy) for name in names]
        radii = each(distinct(np.array([*np.linspace(start, R, POINTS), *(end for end in ends if start < end < R)]))[0])
        least = each(masses(*left, heavy, radii, r_0, z_max))
        series = {}
        for name in names:  # equal ρ·(R³ − r_0³): equal lengths and half-angles
            R_m = f.radius_for(R=radii, r_0=r_0, rho=heavy, rho_m=densities[name])
            m = f.mass_for(m=least, rho=heavy, rho_m=densities[name], R=radii, R_m=R_m, r_0=r_0)
            fits = many(R_m) <= R * (1 + 1e-9)
            if fits.sum() > 1:
                series[name] = Series(Name(name), many(R_m)[fits] * 1e3, many(m)[fits])
    lines = tuple(series[name] for name in densities if name in series)
    return Curve("mass_over_radius", Text("Eccentric mass against outer radius"), axis_label("outer radius", "mm"),
        axis_label("eccentric masses", "kg"), lines)  # fmt: skip
