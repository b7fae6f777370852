# SPDX-License-Identifier: Apache-2.0
"""The bush of an idler on its pin: full film, the load stands, the bush turns; the oil is that of the wheels.

The eccentricity is that of Reynolds' solution; a load too light for its table leaves the pin in the middle (Petroff).
"""

import math

import numpy as np

from ...bearings import formulas as f
from ...bearings.film.table import eccentricity_from, film_at
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.functions import largest, pi, sin, sqrt
from ...sheet.text import Amount, Text
from ...sheet.units import Metre, MetrePerSecond, Newton, Number, PascalSecond, Radian, RevPerSecond, Watt
from ..inputs import PlainBearing
from ..mesh.path import array

NOTHING: Newton = 1e-9  # a load that no film feels
TABLE = Text("Reynolds 1886, full bearing with Swift–Stieber film end; this program's own solution, tabulated")


@formula("ε", TABLE, shows="ε from S(ε, l/d): table of Reynolds' solutions, inverted; lighter loads: 0")
def eccentricity(S: Number, b: Number) -> Number:
    found = np.nan_to_num(eccentricity_from(np.asarray(S, dtype=float), b, outside="nan"))
    return array(found) if found.ndim else float(found)


@formula("φ", TABLE, shows="φ from the table of Reynolds' solutions at ε, l/d; π/2 where ε is 0")
def attitude(eps: Number, b: Number) -> Radian:
    found = np.nan_to_num(film_at(np.asarray(eps, dtype=float), b, outside="nan").attitude, nan=math.pi / 2)
    return array(found) if found.ndim else float(found)


@formula("P_L", "hydrodynamics: shear of the full film and its pressure (identity of Reynolds' solution); at ε = 0 Petroff's law of 1883")
def friction_power(u: MetrePerSecond, eta: PascalSecond, d: Metre, l: Metre, psi: Number, eps: Number, F: Newton, phi: Radian) -> Watt:
    return u * (2 * pi * eta * u * l / (psi * sqrt(1 - eps**2)) + psi * F * eps / 2 * sin(phi))


def power(bearing: PlainBearing, F: Newton, n: RevPerSecond, eta: PascalSecond) -> Watt:
    """The friction of one bush under the load F, one or many.  NoSolution where no film carries it."""
    d, l = bearing.diameter, bearing.length
    where = Text("plain bearing {name}", name=bearing.name)
    b, psi = f.length_ratio(l=l, d=d), f.relative_clearance(g=bearing.clearance, d=d)
    if not 0.1 <= b <= 2:
        raise NoSolution(
            where, Text("its length is {b} diameters", b=Amount(b, form=".3g")), Text("choose a length between 0.1 and 2 diameters")
        )
    u = f.surface_speed(d=d, n=n)
    p = f.specific_load(F=largest(F, NOTHING), d=d, l=l)
    S = f.sommerfeld(mu=eta, n_h=n, p=p, psi=psi)
    least = film_at(0.98, b).sommerfeld
    if np.any(np.asarray(S) < least):
        tried = Text(
            "S = {min} under {max} N, the table ends at {least} (ε = 0.98)",
            min=Amount(float(np.min(S)), form=".3g"),
            max=Amount(float(np.max(F)), form=".4g"),
            least=Amount(least, form=".3g"),
        )
        raise NoSolution(
            Text("{where}: no film carries its load", where=where), tried, Text("a larger bush, less clearance, or a thicker oil")
        )
    eps = eccentricity(S=S, b=b)
    return friction_power(u=u, eta=eta, d=d, l=l, psi=psi, eps=eps, F=F, phi=attitude(eps=eps, b=b))
