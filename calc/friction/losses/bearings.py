# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""What the bearings of a wheel lose: rolling bearings by Palmgren or SKF, the bush of an idler on its pin, seals.

Under radial load: Palmgren's two parts, or SKF's newer model where its constants could be read.

Palmgren's factors f_0 and f_1 are those of his tables as this program's makers remember them, for the middle of each
type: give those of the catalogue.  Of SKF's model the rolling and the sliding part are counted, not seals nor drag in
deep oil; its constants were read in public code that quotes the catalogue of 2013."""

import math

import numpy as np

from ...bearings.plain import formulas as f
from ...bearings.plain.film.table import eccentricity_from, film_at
from ...library.journal_rules import specific_load
from ...sheet.errors import NoSolution
from ...sheet.formula import formula
from ...sheet.functions import exp, largest, log10, pi, sin, single_or_many, sqrt
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

PALMGREN = Text("Palmgren 1957 (SKF catalogues to 1989, ISO/TR 14179-2)")
SKF = Text("SKF 2013")
MILLIMETRE: Metre = 1e-3
CENTISTOKE: SquareMetrePerSecond = 1e-6
ONE_RPM: RevPerSecond = 1 / 60
ONE_NEWTON: Newton = 1.0
NEWTON_MILLIMETRE: NewtonMetre = 1e-3

# f_0 in an oil bath and f_1, by type; from memory.
FACTORS = {
    "deep-groove-ball": (2.0, 0.0003),
    "angular-contact-ball": (3.3, 0.0005),
    "self-aligning-ball": (1.75, 0.0001),
    "cylindrical-roller": (3.0, 0.0003),
    "needle-roller": (12.0, 0.002),
    "spherical-roller": (5.0, 0.0004),
    "tapered-roller": (4.5, 0.0004),
}
SUPPLY = {"bath": 1.0, "mist": 0.5, "jet": 2.0}  # of f_0

# SKF: R_1 and S_1 by series, K_Z; deep-groove ball bearings without axial load; cylindrical roller bearings with cage.
BALLS = {
    "2": (4.4e-7, 2.00e-3), "3": (4.4e-7, 2.00e-3), "42": (5.4e-7, 3.00e-3), "43": (5.4e-7, 3.00e-3), "60": (4.1e-7,
    3.73e-3),
    "630": (4.1e-7, 3.73e-3), "62": (3.9e-7, 3.23e-3), "622": (3.9e-7, 3.23e-3), "63": (3.7e-7, 2.84e-3),
    "623": (3.7e-7, 2.84e-3),
    "64": (3.6e-7, 2.43e-3), "160": (4.3e-7, 4.63e-3), "161": (4.3e-7, 4.63e-3), "618": (4.7e-7, 6.50e-3),
    "619": (4.3e-7, 4.75e-3),
}  # fmt: skip
ROLLERS = {"4": (1.00e-6, 0.0015), "22": (1.40e-6, 0.0015)}
K_Z = {"deep-groove-ball": 3.1, "cylindrical-roller": 5.1}
MU_EHL = {"deep-groove-ball": 0.05, "cylindrical-roller": 0.02}  # full film; balls in synthetic oil 0.04
SYNTHETIC: Number = 0.04
STARVED = {"bath": 3e-8, "mist": 6e-8, "jet": 3e-8}  # K_rs


@formula("d_m", "geometry: mean diameter of a bearing", unit="mm")
def mean_diameter(d: Metre, D: Metre) -> Metre:
    return (d + D) / 2


# --- Palmgren


@formula(
    "M_0",
    Text("{palmgren}: torque without load; ν·n no less than 2000 mm²/s·rpm (160 for its power 2/3)", palmgren=PALMGREN),
)
def torque_of_oil(f_0: Number, nu: SquareMetrePerSecond, n: RevPerSecond, d_m: Metre) -> NewtonMetre:
    return (
        1e-7
        * f_0
        * largest((nu / CENTISTOKE * n / ONE_RPM) ** (2 / 3), 160.0)
        * (d_m / MILLIMETRE) ** 3
        * NEWTON_MILLIMETRE
    )


@formula("M_1", Text("{palmgren}: torque of the load, here radial", palmgren=PALMGREN))
def torque_of_load(f_1: Number, F: Newton, d_m: Metre) -> NewtonMetre:
    return f_1 * F * d_m


# --- SKF


@formula("G_rr", Text("{skf}: rolling, deep-groove ball bearing under radial load", skf=SKF))
def rolling_of_balls(R_1: Number, d_m: Metre, F: Newton) -> Number:
    return R_1 * (d_m / MILLIMETRE) ** 1.96 * (F / ONE_NEWTON) ** 0.54


@formula("G_sl", Text("{skf}: sliding, deep-groove ball bearing under radial load", skf=SKF))
def sliding_of_balls(S_1: Number, d_m: Metre, F: Newton) -> Number:
    return S_1 * (d_m / MILLIMETRE) ** -0.26 * (F / ONE_NEWTON) ** (5 / 3)


@formula("G_rr", Text("{skf}: rolling, cylindrical roller bearing under radial load", skf=SKF))
def rolling_of_rollers(R_1: Number, d_m: Metre, F: Newton) -> Number:
    return R_1 * (d_m / MILLIMETRE) ** 2.41 * (F / ONE_NEWTON) ** 0.31


@formula("G_sl", Text("{skf}: sliding, cylindrical roller bearing under radial load", skf=SKF), names={"S_1": "S_2"})
def sliding_of_rollers(S_1: Number, d_m: Metre, F: Newton) -> Number:
    return S_1 * d_m / MILLIMETRE * F / ONE_NEWTON


@formula("φ_ish", Text("{skf}: heat of the sheared inlet", skf=SKF))
def inlet_heat(n: RevPerSecond, d_m: Metre, nu: SquareMetrePerSecond) -> Number:
    return 1 / (1 + 1.84e-9 * (n / ONE_RPM * d_m / MILLIMETRE) ** 1.28 * (nu / CENTISTOKE) ** 0.64)


@formula(
    "φ_rs",
    Text("{skf}: oil pushed aside and starved; K_rs 3·10⁻⁸ in a bath of low level or a jet, 6·10⁻⁸ in mist", skf=SKF),
)
def starvation(K_rs: Number, nu: SquareMetrePerSecond, n: RevPerSecond, d: Metre, D: Metre, K_Z: Number) -> Number:
    return exp(-K_rs * nu / CENTISTOKE * n / ONE_RPM * (d + D) / MILLIMETRE * sqrt(K_Z / 2 * MILLIMETRE / (D - d)))


@formula("φ_bl", Text("{skf}: share of boundary lubrication", skf=SKF))
def boundary_share(n: RevPerSecond, nu: SquareMetrePerSecond, d_m: Metre) -> Number:
    return exp(-2.6e-8 * (n / ONE_RPM * nu / CENTISTOKE) ** 1.4 * d_m / MILLIMETRE)


@formula("μ_sl", Text("{skf}: friction of sliding, 0.12 at the boundary", skf=SKF))
def sliding_friction(phi_bl: Number, mu_EHL: Number) -> Number:
    return phi_bl * 0.12 + (1 - phi_bl) * mu_EHL


@formula("M", Text("{skf}: rolling and sliding", skf=SKF))
def torque_by_skf(
    phi_ish: Number,
    phi_rs: Number,
    G_rr: Number,
    nu: SquareMetrePerSecond,
    n: RevPerSecond,
    G_sl: Number,
    mu_sl: Number,
) -> NewtonMetre:
    return (phi_ish * phi_rs * G_rr * (nu / CENTISTOKE * n / ONE_RPM) ** 0.6 + G_sl * mu_sl) * NEWTON_MILLIMETRE


@formula("P_L", "definition: power of the torque, of several bearings", names={"N": "N_L"})
def bearing_power(N: Number, M: NewtonMetre, n: RevPerSecond) -> Watt:
    return N * M * 2 * pi * n


@formula("M", Text("{palmgren}: both parts", palmgren=PALMGREN))
def torque_by_palmgren(M_0: NewtonMetre, M_1: NewtonMetre) -> NewtonMetre:
    return M_0 + M_1


@formula("F_L", "rule of this program: the load shared evenly", unit="N")
def load_of_one(F: Newton, N: Number) -> Newton:
    return F / N


def power(bearing: RollingBearing, F: Newton, n: RevPerSecond, nu: SquareMetrePerSecond, base: str = "mineral") -> Watt:
    """What all bearings of one entry lose under the radial load F together, one or many; `base` of the oil."""
    d_m = mean_diameter(d=bearing.bore, D=bearing.outside_diameter)
    F_L = load_of_one(F=F, N=bearing.count)
    if bearing.method == "palmgren":
        usual_0, usual_1 = FACTORS[bearing.kind]
        f_0 = usual_0 * SUPPLY[bearing.lubrication] if bearing.f_0 is None else bearing.f_0
        f_1 = usual_1 if bearing.f_1 is None else bearing.f_1
        M_0, M_1 = torque_of_oil(f_0=f_0, nu=nu, n=n, d_m=d_m), torque_of_load(f_1=f_1, F=F_L, d_m=d_m)
        return bearing_power(N=bearing.count, M=torque_by_palmgren(M_0=M_0, M_1=M_1), n=n)
    balls = bearing.kind == "deep-groove-ball"
    known = BALLS if balls else ROLLERS if bearing.kind == "cylindrical-roller" else {}
    if bearing.series not in known:
        what, series = (
            Text("rolling bearing {name}: SKF's model", name=bearing.name),
            bearing.series or Text("not given"),
        )
        unread = Text("its constants for {kind} of series {series} could not be read", kind=bearing.kind, series=series)
        listed = Text(
            "deep-groove-ball {balls}; cylindrical-roller {rollers}", balls=", ".join(BALLS), rollers=", ".join(ROLLERS)
        )
        advice = Text('take method = "palmgren", or one of these series: {listed}', listed=listed)
        raise NoSolution(what, unread, advice)
    R_1, S_1 = known[bearing.series]
    mu_EHL = SYNTHETIC if balls and base != "mineral" else MU_EHL[bearing.kind]
    rolling, sliding = (rolling_of_balls, sliding_of_balls) if balls else (rolling_of_rollers, sliding_of_rollers)
    d, D, K_rs = bearing.bore, bearing.outside_diameter, STARVED[bearing.lubrication]
    phi_ish = inlet_heat(n=n, d_m=d_m, nu=nu)
    phi_rs = starvation(K_rs=K_rs, nu=nu, n=n, d=d, D=D, K_Z=K_Z[bearing.kind])
    G_rr, G_sl = rolling(R_1=R_1, d_m=d_m, F=F_L), sliding(S_1=S_1, d_m=d_m, F=F_L)
    mu_sl = sliding_friction(phi_bl=boundary_share(n=n, nu=nu, d_m=d_m), mu_EHL=mu_EHL)
    M = torque_by_skf(phi_ish=phi_ish, phi_rs=phi_rs, G_rr=G_rr, nu=nu, n=n, G_sl=G_sl, mu_sl=mu_sl)
    return bearing_power(N=bearing.count, M=M, n=n)


# --- the bush of an idler on its pin: full film, the load stands, the bush turns; the oil is that of the wheels
# The eccentricity is that of Reynolds' solution; a load too light for its table leaves the pin in the middle (Petroff).

NOTHING: Newton = 1e-9  # a load that no film feels
TABLE = Text("Reynolds 1886, full bearing with Swift–Stieber film end; this program's own solution, tabulated")


@formula("ε", TABLE, shows="ε from S(ε, l/d): table of Reynolds' solutions, inverted; lighter loads: 0")
def eccentricity(S: Number, b: Number) -> Number:
    eps = np.nan_to_num(eccentricity_from(np.asarray(S, dtype=float), b, outside="nan"))
    return single_or_many(eps)


@formula("φ", TABLE, shows="φ from the table of Reynolds' solutions at ε, l/d; π/2 where ε is 0")
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
