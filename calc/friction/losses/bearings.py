# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""What the bearings of a wheel lose: rolling bearings by Palmgren or SKF, the bush of an idler on its pin, seals.

Under radial load: Palmgren's two parts, or SKF's newer model where its constants could be read.

The formulas of both stand in `calc/bearings/rolling/torque.py`.  Palmgren's factors f_0 and f_1 are those of his tables
as this program's makers remember them, for the middle of each type: give those of the catalogue."""

import math

import numpy as np

from ...bearings.plain import formulas as f
from ...bearings.plain.film.table import eccentricity_from, film_at
from ...bearings.rolling import torque as t
from ...bearings.rolling.geometry import mean_diameter
from ...bearings.rolling.torque import torque_by_palmgren, torque_of_load, torque_of_oil
from ...library.journal_rules import specific_load
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.functions import largest, log10, pi, sin, single_or_many, sqrt
from ...sheet.text import Amount, Text
from ...sheet.units import (
    Celsius,
    Kelvin,
    Metre,
    MetrePerSecond,
    Newton,
    NewtonMetre,
    Number,
    PascalSecond,
    Radian,
    RevPerSecond,
    SquareMetrePerSecond,
    Watt,
)
from ..inputs import PlainBearing, RollingBearing

MILLIMETRE: Metre = 1e-3
CENTISTOKE: SquareMetrePerSecond = 1e-6
ONE_RPM: RevPerSecond = 1 / 60
ELEMENTS = {"deep-groove-ball": "ball", "cylindrical-roller": "roller"}  # of which SKF's constants are known


@formula("P_L", "definition: power of the torque, of several bearings", names={"N": "N_L"})
def bearing_power(N: Number, M: NewtonMetre, n: RevPerSecond) -> Watt:
    return N * M * 2 * pi * n


@formula("F_L", "rule of this program: the load shared evenly", unit="N")
def load_of_one(F: Newton, N: Number) -> Newton:
    return F / N


def power(bearing: RollingBearing, F: Newton, n: RevPerSecond, nu: SquareMetrePerSecond, base: str = "mineral") -> Watt:
    """What all bearings of one entry lose under the radial load F together, one or many; `base` of the oil."""
    d_m = mean_diameter(d=bearing.bore, D=bearing.outside_diameter)
    F_L = load_of_one(F=F, N=bearing.count)
    if bearing.method == "palmgren":
        usual_0, usual_1 = t.constants("palmgren")[bearing.kind]
        f_0 = usual_0 * t.SUPPLY[bearing.lubrication] if bearing.f_0 is None else bearing.f_0
        f_1 = usual_1 if bearing.f_1 is None else bearing.f_1
        M_0, M_1 = torque_of_oil(f_0=f_0, nu=nu, n=n, d_m=d_m), torque_of_load(f_1=f_1, F=F_L, d_m=d_m)
        return bearing_power(N=bearing.count, M=torque_by_palmgren(M_0=M_0, M_1=M_1), n=n)
    R_1, S_1 = _by_skf(bearing)
    d, D, oil = bearing.bore, bearing.outside_diameter, bearing.lubrication
    M = t.skf_torque(ELEMENTS[bearing.kind], R_1, S_1, d, D, d_m, oil, base, F_L, n, nu)
    return bearing_power(N=bearing.count, M=M, n=n)


def _by_skf(bearing: RollingBearing) -> tuple[Number, Number]:
    """R_1 and S_1 of a series.  NoSolution where they are not known."""
    skf = t.constants("skf")
    known = skf[ELEMENTS[bearing.kind]]["series"] if bearing.kind in ELEMENTS else {}
    if bearing.series not in known:
        what, series = (
            Text("rolling bearing {name}: SKF's model", name=bearing.name),
            bearing.series or Text("not given"),
        )
        unread = Text("its constants for {kind} of series {series} could not be read", kind=bearing.kind, series=series)
        listed = Text(
            "deep-groove-ball {balls}; cylindrical-roller {rollers}",
            balls=", ".join(skf["ball"]["series"]),
            rollers=", ".join(skf["roller"]["series"]),
        )
        advice = Text('take method = "palmgren", or one of these series: {listed}', listed=listed)
        raise NoSolution(what, unread, advice)
    R_1, S_1 = known[bearing.series]
    return R_1, S_1


# --- the bush of an idler on its pin: full film, the load stands, the bush turns; the oil is that of the wheels
# The eccentricity is that of Reynolds' solution; a load too light for its table leaves the pin in the middle (Petroff).

NOTHING: Newton = 1e-9  # a load that no film feels
TABLE = Text("Reynolds 1886, full bearing with Swift–Stieber film end; this program's own solution, tabulated")


@formula(
    "ε", TABLE, shows="ε from S(ε, l/d): table of Reynolds' solutions, inverted; lighter loads: 0", names={"b": "l/d"}
)
def eccentricity(S: Number, b: Number) -> Number:
    eps = np.nan_to_num(eccentricity_from(np.asarray(S, dtype=float), b, outside="nan"))
    return single_or_many(eps)


@formula("φ", TABLE, shows="φ from the table of Reynolds' solutions at ε, l/d; π/2 where ε is 0", names={"b": "l/d"})
def attitude(eps: Number, b: Number) -> Radian:
    angle = np.nan_to_num(film_at(np.asarray(eps, dtype=float), b, outside="nan").attitude, nan=math.pi / 2)
    return single_or_many(angle)


@formula(
    "P_L",
    "hydrodynamics: shear of the full film and its pressure (identity of Reynolds' solution); at ε = 0 Petroff's law "
    "of 1883",
)
def friction_power(
    u: MetrePerSecond, eta: PascalSecond, d: Metre, l: Metre, psi: Number, eps: Number, F: Newton, phi: Radian
) -> Watt:
    return u * (2 * pi * eta * u * l / (psi * sqrt(1 - eps**2)) + psi * F * eps / 2 * sin(phi))


def plain_bearing_power(bearing: PlainBearing, F: Newton, n: RevPerSecond, eta: PascalSecond) -> Watt:
    """The friction of one bush under the load F, one or many.  NoSolution where no film carries it."""
    d, l = bearing.diameter, bearing.length
    where = Text("plain bearing {name}", name=bearing.name)
    b, psi = f.length_ratio(l=l, d=d), f.relative_clearance(g=bearing.clearance, d=d)
    if not 0.1 <= b <= 2:
        length = Text("its length is {b} diameters", b=Amount(b, form=".3g"))
        raise NoSolution(where, length, Text("choose a length between 0.1 and 2 diameters"))
    u = f.surface_speed(d=d, n=n)
    p = specific_load(F=largest(F, NOTHING), d=d, l=l)
    S = f.sommerfeld(mu=eta, n_h=n, p=p, psi=psi)
    least = film_at(0.98, b).sommerfeld
    if np.any(np.asarray(S) < least):
        tried = Text(
            "S = {min} under {max} N, the table ends at {least} (ε = 0.98)",
            min=Amount(float(np.min(S)), form=".3g"),
            max=Amount(float(np.max(F)), form=".4g"),
            least=Amount(least, form=".3g"),
        )
        what = Text("{where}: no film carries its load", where=where)
        raise NoSolution(what, tried, Text("a larger bush, less clearance, or a thicker oil"))
    eps = eccentricity(S=S, b=b)
    return friction_power(u=u, eta=eta, d=d, l=l, psi=psi, eps=eps, F=F, phi=attitude(eps=eps, b=b))


# --- radial shaft seals: two published rules, by diameter and speed alone, or also by the oil

ONE_WATT: Watt = 1.0
ONE_KELVIN: Kelvin = 1.0


@formula("P_D", "Freudenberg Simrit, as in ISO/TR 14179-2:2001: one radial shaft seal")
def simrit(d_sh: Metre, n: RevPerSecond) -> Watt:
    return 7.69e-6 * (d_sh / MILLIMETRE) ** 2 * (n / ONE_RPM) * ONE_WATT


@formula(
    "P_D",
    "Linke 2010: one radial shaft seal in oil; no less than nothing where thin oil is hot",
    names={"nu_40": "ν_40"},
)
def linke(T_oil: Celsius, nu_40: SquareMetrePerSecond, d_sh: Metre, n: RevPerSecond) -> Watt:
    return (
        largest(145 - 1.6 * T_oil / ONE_KELVIN + 350 * log10(log10(nu_40 / CENTISTOKE + 0.8)), 0.0)
        * 1e-7
        * (d_sh / MILLIMETRE) ** 2
        * (n / ONE_RPM)
        * ONE_WATT
    )


@formula("P_D", "mathematics: several seals of one size", names={"P": "P_D"})
def several(N: Number, P: Watt) -> Watt:
    return N * P
