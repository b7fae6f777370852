# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""How long a rolling bearing lives: by its load, by oil, dirt and fatigue limit, over the rows of a duty, and all
bearings together.

Lives are those that one in ten does not reach, in s.  Bearings as floats or as columns, duty rows along the last axis.
Validity of a_ISO: κ from 0.1 to 4, taken at these ends beyond them."""

from typing import Any

import numpy as np

from ...library.table_file import TableRow, house_table
from ...sheet.formula import formula
from ...sheet.functions import along, largest, power, single_or_many, smallest
from ...sheet.record import record
from ...sheet.text import Text
from ...sheet.units import Metre, Newton, Number, RevPerSecond, Second, SquareMetrePerSecond
from .contact import Springs, displacement, reach
from .contamination import WORDS
from .load import Races
from .ratings import Ratings
from .sizes import FILE, Elements
from .zone import EXPONENTS

ISO = Text("ISO 281:2007")
NOTHING: Newton = 1e-9  # a load that no bearing feels, in place of none
MILLIMETRE: Metre = 1e-3
CENTISTOKE: SquareMetrePerSecond = 1e-6
ONE_RPM: RevPerSecond = 1 / 60
SLOW: RevPerSecond = 1000 / 60  # below it ν_1 follows another power of n
KAPPA = (0.1, 4.0)
LARGE: Metre = 0.1  # D_pw from which on e_C is that of large bearings
STEPS = 6  # of Newton's method, on logarithms: four reach the last digits

# --- one row


@formula(
    "L_10",
    Text("{iso}: life by the load alone", iso=ISO),
    unit="h",
    names={"C": "C_r", "p": "p_L"},
    meanings={"p": "Exponent of the life over the load", "n": "Speed", "P": "Equivalent load"},
)
def life_by_load(n: RevPerSecond, C: Newton, P: Newton, p: Number) -> Second:
    return 1e6 / n * power(C / largest(P, NOTHING), p)


@formula(
    "ν_1",
    Text("{iso}: viscosity that parts the surfaces, from 1000 rpm on", iso=ISO),
    unit="mm²/s",
    meanings={"D_pw": "Pitch diameter of the rolling elements", "n": "Speed"},
)
def needed_viscosity(n: RevPerSecond, D_pw: Metre) -> SquareMetrePerSecond:
    return 4500 * (n / ONE_RPM) ** -0.5 * (D_pw / MILLIMETRE) ** -0.5 * CENTISTOKE


@formula(
    "ν_1",
    Text("{iso}: viscosity that parts the surfaces, below 1000 rpm", iso=ISO),
    unit="mm²/s",
    meanings={"n": "Speed", "D_pw": "Pitch diameter of the rolling elements"},
)
def needed_viscosity_slow(n: RevPerSecond, D_pw: Metre) -> SquareMetrePerSecond:
    return 45000 * (n / ONE_RPM) ** -0.83 * (D_pw / MILLIMETRE) ** -0.5 * CENTISTOKE


@formula("κ", Text("{iso}: viscosity ratio", iso=ISO), governs="min", meanings={"nu_1": "Viscosity that is needed"})
def viscosity_ratio(nu: SquareMetrePerSecond, nu_1: SquareMetrePerSecond) -> Number:
    return nu / nu_1


@formula("k", Text("{iso}: viscosity ratio that counts", iso=ISO), names={"kappa": "κ"})
def counted_ratio(kappa: Number) -> Number:
    return smallest(largest(kappa, 0.1), 4.0)


@formula("e_C", Text("{iso}, annex A: oil with on-line filter", iso=ISO), names={"c": "c_C", "a": "a_C"})
def contamination_filtered(a: Number, k: Number, D_pw: Metre, c: Number) -> Number:
    return largest(
        smallest(a * k**0.68 * (D_pw / MILLIMETRE) ** 0.55, 1.0) * (1 - c / (D_pw / MILLIMETRE) ** (1 / 3)), 0.0
    )


@formula(
    "X_u",
    Text("{iso}: fatigue limit over load, less by dirt", iso=ISO),
    meanings={"e_C": "Factor of contamination", "P": "Equivalent load"},
)
def fatigue_share(e_C: Number, C_u: Newton, P: Newton) -> Number:
    return e_C * C_u / largest(P, NOTHING)


# 50 is the most that a_ISO may be: what is less than 500^(−1/9.3) counts as that
@formula(
    "a_ISO",
    Text("{iso}: balls, at most 50", iso=ISO),
    names={"c": "c_k", "s": "s_k"},
    governs="min",
    meanings={"c": "Constant of the viscosity ratio", "s": "Exponent of the viscosity ratio"},
)
def life_factor_of_balls(c: Number, k: Number, s: Number, X_u: Number) -> Number:
    return 0.1 * power(
        largest(1 - largest(2.5671 - c / power(k, s), 0.0) ** 0.83 * X_u ** (1 / 3), 500 ** (-1 / 9.3)), -9.3
    )


@formula("a_ISO", Text("{iso}: rollers, at most 50", iso=ISO), names={"c": "c_k", "s": "s_k"}, governs="min")
def life_factor_of_rollers(c: Number, k: Number, s: Number, X_u: Number) -> Number:
    return 0.1 * power(largest(1 - largest(1.5859 - c / power(k, s), 0.0) * X_u**0.4, 500 ** (-1 / 9.185)), -9.185)


# c of balls and of rollers, and s, for κ below 0.4, below 1, and from there on.  The ones between join at 0.4 and at 1
# with the exponent 0.19087 alone; public code has 0.019087 for balls, with which a_ISO would jump.
BANDS = (0.4, 1.0)
C_K: dict[Elements, tuple[float, ...]] = {"ball": (2.2649, 1.9987, 1.9987), "roller": (1.3993, 1.2348, 1.2348)}
S_K = (0.054381, 0.19087, 0.071739)


def needed_viscosity_of(D_pw: Any, n: Any) -> Any:
    """ν_1 at the speed n."""
    slow = np.asarray(n) < SLOW
    if not slow.any():
        return needed_viscosity(n=n, D_pw=D_pw)
    if slow.all():
        return needed_viscosity_slow(n=n, D_pw=D_pw)
    return np.where(slow, needed_viscosity_slow(n=n, D_pw=D_pw), needed_viscosity(n=n, D_pw=D_pw))


def contamination(cleanliness: str, D_pw: Any, k: Any) -> Any:
    """e_C by the word or by the class of the oil's filter; k: the viscosity ratio that counts."""
    table = house_table(FILE)
    if cleanliness in WORDS:
        small, large = table["contamination"][cleanliness]
        return single_or_many(np.asarray(np.where(np.asarray(D_pw) < LARGE, small, large) + 0.0 * np.asarray(k)))
    a, c = table["filtered"][cleanliness]
    return contamination_filtered(a=a, k=k, D_pw=D_pw, c=c)


def life_factor(elements: Elements, k: Any, X_u: Any) -> Any:
    """a_ISO; k: the viscosity ratio that counts."""
    at = np.searchsorted(BANDS, k, side="right")
    c, s = (single_or_many(np.asarray(np.asarray(row)[at])) for row in (C_K[elements], S_K))
    factor = life_factor_of_balls if elements == "ball" else life_factor_of_rollers
    return factor(c=c, k=k, s=s, X_u=X_u)


# --- the rows of a duty, and all bearings


@formula(
    "a_1",
    Text("{iso}: fewer than one in ten may fail", iso=ISO),
    shows="a_1 by table, linear in between",
    meanings={"return": "Life factor for reliability"},
)
def reliability_factor(R: Number) -> Number:
    """R: of bearings that reach the life, 0.9 to 0.999."""
    row: TableRow = house_table(FILE)["reliability"]
    return float(np.interp(100 * R, row["percent"], row["a_1"]))


@formula(
    "L",
    "Palmgren: each row takes its share of the life (Miner 1945)",
    unit="h",
    names={"w": "w_i", "L_i": "L_i"},
    meanings={"w": "Share of each row in the hours", "return": "Life over the duty cycle"},
)
def life_of_duty(w: Number, L_i: Second) -> Second:
    """w: share of each row in the hours."""
    return 1 / along(w / L_i)


@formula("L_nm", Text("{iso}: life with a_1 and a_ISO", iso=ISO), unit="h", governs="min")
def modified_life(a_1: Number, a_ISO: Number, L_10: Second) -> Second:
    return a_1 * a_ISO * L_10


@formula(
    "L_s",
    Text("{iso}: all bearings live", iso=ISO),
    shows="L_s with Σ (L_s/L_i)^{e_i} = 1, by Newton's method",
    unit="h",
)
def system_life(L: Second, e: Number) -> Second:
    """L and e: the lives of the bearings and the spread of each (10/9 balls, 9/8 rollers), along the last axis."""
    lives, spread = np.asarray(L, dtype=float), np.asarray(e, dtype=float)
    L_s = lives.min(axis=-1)  # longer than the answer
    for _ in range(STEPS):
        failed = (L_s[..., None] / lives) ** spread
        L_s = L_s * np.sum(failed, axis=-1) ** (-np.sum(failed, axis=-1) / np.sum(failed * spread, axis=-1))
    return single_or_many(np.asarray(L_s))


@record
class Lives:
    """What the rows of a duty make of a bearing's life: κ, e_C and a_ISO, L_10 and a_1·a_ISO·L_10 in s; a number a
    row."""

    kappa: Any
    contamination: Any
    factor: Any
    basic: Any
    modified: Any


def lives(
    elements: Elements, D_pw: Any, ratings: Ratings, P: Any, n: Any, nu: Any, cleanliness: str, a_1: Number = 1.0
) -> Lives:
    """The life at each load P and speed n, 1/s, in oil of viscosity ν, m²/s, where the elements roll."""
    kappa = viscosity_ratio(nu=nu, nu_1=needed_viscosity_of(D_pw, n))
    k = counted_ratio(kappa=kappa)
    e_C = contamination(cleanliness, D_pw, k)
    a_ISO = life_factor(elements, k, fatigue_share(e_C=e_C, C_u=ratings.fatigue, P=P))
    L_10 = life_by_load(n=n, C=ratings.dynamic, P=P, p=EXPONENTS[elements].p)
    return Lives(kappa, e_C, a_ISO, L_10, modified_life(a_1=a_1, a_ISO=a_ISO, L_10=L_10))


@formula(
    "P_s",
    "ISO/TS 16281, from memory: load with the zone that the clearance leaves",
    names={"r": "P_ref/P_ref,0"},
    meanings={"P": "Equivalent load"},
)
def load_with_clearance(P: Newton, r: Number) -> Newton:
    """r: P_ref of the zone over that without clearance."""
    return r * P


def with_clearance(races: Races, springs: Springs, P: Any, F_m: Any, stands: Any) -> Any:
    """P as the zone at the clearance of the springs makes it; `stands`: where the larger load stands on the inner ring.

    The rings are taken as rigid: a life with it is a lower bound for clearances of 0 and above.  Light preload spreads
    the load better than no clearance does: P is up to 3.8 % less then."""
    known = dict(Z=springs.count, K_1=springs.contact, elements=springs.elements)
    eps = reach(s=springs.gap, delta=displacement(F=F_m, s=springs.gap, **known))
    return load_with_clearance(P=P, r=races.over_reference(eps, stands, springs.gap < 0))
