# SPDX-License-Identifier: Apache-2.0
"""The least mass of the sectors against their outer radius, a line a material: what a larger seat saves."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from ...sheet.step import Curve, Series
from ...sheet.trace import untraced
from ...sheet.units import Metre, PhasorKilogramMetre, PhasorKilogramMetre2
from ..inputs import Extra
from . import cost_formulas as f
from .formulas import radius_needed
from .sectors import TooSmall, masses, remainder, size

POINTS = 25  # of a front


def front_curve(
    U: PhasorKilogramMetre, P: PhasorKilogramMetre2, omega: float, R: Metre, r_0: Metre, z_max: Metre, densities: Mapping[str, float],
    extras: tuple[Extra, ...] = (),
) -> Curve | None:  # fmt: skip
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
        start: Any = radius_needed(R=R, r_0=r_0, u=u) * (1 + 1e-9)
        ends = [f.radius_for(R=R, r_0=r_0, rho=densities[name], rho_m=heavy) for name in names]
        radii: Any = np.unique([*np.linspace(start, R, POINTS), *(end for end in ends if start < end < R)])
        least: Any = masses(*left, heavy, radii, r_0, z_max)
        series = {}
        for name in names:  # equal ρ·(R³ − r_0³): equal lengths and half-angles
            R_m: Any = f.radius_for(R=radii, r_0=r_0, rho=heavy, rho_m=densities[name])
            m: Any = f.mass_for(m=least, rho=heavy, rho_m=densities[name], R=radii, R_m=R_m, r_0=r_0)
            fits = R_m <= R * (1 + 1e-9)
            if fits.sum() > 1:
                series[name] = Series(name, R_m[fits] * 1e3, m[fits])
    lines = tuple(series[name] for name in densities if name in series)
    return Curve("mass_over_radius", "Eccentric mass against outer radius", "outer radius, mm", "eccentric masses, kg", lines)
