# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""What a bearing is rated at, from what is inside it: C and its shares of both races, C_0, C_u.

The constants of the standards belong to N and mm.  Grooves closer than those of the standards do not raise a rating."""

from typing import Any

from ...sheet.formula import formula
from ...sheet.functions import cos, largest, smallest
from ...sheet.record import record
from ...sheet.text import Text
from ...sheet.units import Metre, Newton, Number, Pascal, Radian
from ...sheet.value import based_on
from .geometry import Inside, gamma_of
from .hertz import BallContact
from .sizes import Elements

ISO = Text("ISO 281 and ISO/TR 1281-1, from memory")
ISO_STATIC = Text("ISO 76")
ISO_RACES = Text("ISO/TS 16281, from memory")
MILLIMETRE: Metre = 1e-3
ONE_NEWTON: Newton = 1.0
NEWTON_PER_SQUARE_MILLIMETRE: Pascal = 1e6
OF_BALLS: Pascal = 4200e6  # what a ball and its groove bear standing
INNER, OUTER, OUTER_STATIC = 0.52, 0.52, 0.53  # grooves of the standards: radius over D_w

# --- dynamic


@formula(
    "X",
    Text("{iso}: balls, load of the inner race that lives as long as the outer", iso=ISO),
    meanings={"k_X": "Constant of the ratio of the races"},
)
def race_ratio_of_balls(k_X: Number, gamma: Number, f_i: Number, f_e: Number) -> Number:
    """k_X is 1.04 in the rating, 1.044 in the loads of the races."""
    return k_X * ((1 - gamma) / (1 + gamma)) ** 1.72 * (f_i * (2 * f_e - 1) / (f_e * (2 * f_i - 1))) ** 0.41


@formula("X", Text("{iso}: rollers, load of the inner race that lives as long as the outer", iso=ISO))
def race_ratio_of_rollers(k_X: Number, gamma: Number) -> Number:
    """k_X is 1.04 in the rating, 1.038 in the loads of the races."""
    return k_X * ((1 - gamma) / (1 + gamma)) ** (143 / 108)


@formula("f_c", Text("{iso}: balls", iso=ISO))
def factor_of_balls(f_i: Number, gamma: Number, X: Number) -> Number:
    return (
        0.41
        * 98.0665
        * 0.95
        * (2 * f_i / (2 * f_i - 1)) ** 0.41
        * gamma**0.3
        * (1 - gamma) ** 1.39
        / (1 + gamma) ** (1 / 3)
        * (1 + X ** (10 / 3)) ** -0.3
    )


@formula("f_c", Text("{iso}: rollers", iso=ISO))
def factor_of_rollers(gamma: Number, X: Number) -> Number:
    return (
        0.377
        * 551.13373
        * 0.83
        * gamma ** (2 / 9)
        * (1 - gamma) ** (29 / 27)
        / (1 + gamma) ** 0.25
        * (1 + X**4.5) ** (-2 / 9)
    )


@formula(
    "C_r",
    Text("{iso}: one row of balls; beyond 25.4 mm 3.647·D_w^1.4", iso=ISO),
    unit="kN",
    names={"alpha": "α_0"},
    meanings={
        "b_m": "Factor of today's steels and making",
        "alpha": "Contact angle",
        "Z": "Number of rolling elements",
        "D_w": "Diameter of the rolling elements",
    },
)
def rating_of_balls(b_m: Number, f_c: Number, alpha: Radian, Z: Number, D_w: Metre) -> Newton:
    return (
        b_m
        * f_c
        * cos(alpha) ** 0.7
        * Z ** (2 / 3)
        * smallest((D_w / MILLIMETRE) ** 1.8, 3.647 * (D_w / MILLIMETRE) ** 1.4)
        * ONE_NEWTON
    )


@formula("C_r", Text("{iso}: one row of rollers", iso=ISO), unit="kN")
def rating_of_rollers(b_m: Number, f_c: Number, L_we: Metre, Z: Number, D_w: Metre) -> Newton:
    return b_m * f_c * (L_we / MILLIMETRE) ** (7 / 9) * Z**0.75 * (D_w / MILLIMETRE) ** (29 / 27) * ONE_NEWTON


# --- static


@formula(
    "f_0",
    Text("{iso}: a fifth of the load at 4200 MPa on the race that reaches it first", iso=ISO_STATIC),
    meanings={"D_w": "Diameter of the rolling elements"},
)
def static_factor(Q_i: Newton, Q_e: Newton, D_w: Metre) -> Number:
    return smallest(Q_i, Q_e) / (5 * D_w**2 * NEWTON_PER_SQUARE_MILLIMETRE)


@formula(
    "C_0",
    Text("{iso}: one row of balls", iso=ISO_STATIC),
    unit="kN",
    names={"alpha": "α_0"},
    meanings={"Z": "Number of rolling elements", "D_w": "Diameter of the rolling elements", "alpha": "Contact angle"},
)
def static_of_balls(f_0: Number, Z: Number, D_w: Metre, alpha: Radian) -> Newton:
    return f_0 * NEWTON_PER_SQUARE_MILLIMETRE * Z * D_w**2 * cos(alpha)


@formula("C_0", Text("{iso}: one row of rollers", iso=ISO_STATIC), unit="kN")
def static_of_rollers(gamma: Number, Z: Number, L_we: Metre, D_w: Metre) -> Newton:
    return 44 * NEWTON_PER_SQUARE_MILLIMETRE * (1 - gamma) * Z * L_we * D_w


# --- fatigue limit; a raceway that is the shaft itself


@formula(
    "C_u",
    "ISO 281:2007: balls, less on a pitch diameter beyond 100 mm",
    unit="kN",
    meanings={"D_pw": "Pitch diameter of the rolling elements"},
)
def limit_of_balls(C_0: Newton, D_pw: Metre) -> Newton:
    return C_0 / 22 * smallest(100 * MILLIMETRE / D_pw, 1.0) ** 0.5


@formula("C_u", "ISO 281:2007: rollers, less on a pitch diameter beyond 100 mm", unit="kN")
def limit_of_rollers(C_0: Newton, D_pw: Metre) -> Newton:
    return C_0 / 8.2 * smallest(100 * MILLIMETRE / D_pw, 1.0) ** 0.3


@formula("f_H", "rule of this program: after the (HV/800)² of Harris 2001; full from 670 HV on")
def hardness_factor(HV: Number) -> Number:
    return smallest((HV / 670) ** 2, 1.0)


@formula("C_r", "definition: the raceway on the shaft is softer", unit="kN", names={"C": "C_r,hard"})
def dynamic_on_shaft(f_H: Number, C: Newton) -> Newton:
    return f_H * C


@formula("C_0", "definition: the raceway on the shaft is softer", unit="kN", names={"C_0": "C_0,hard"})
def static_on_shaft(f_H: Number, C_0: Newton) -> Newton:
    return f_H * C_0


@record
class Ratings:
    """What a bearing carries, N (numbers, or arrays of many).  f_0: of balls, for their thrust."""

    dynamic: Any
    static: Any
    fatigue: Any
    f_0: Any = None


def computed(inside: Inside[Any], b_m: Any, HV: Any = None) -> Ratings:
    """The ratings by the standards; b_m: `size.usual.rating`; HV: of the raceway, where that is the shaft."""
    gamma, f_0 = gamma_of(inside), None
    Z, D_w, alpha = inside.count, inside.diameter, inside.contact_angle
    if inside.elements == "ball":
        f_i, f_e = counted_grooves(inside)
        f_c = factor_of_balls(f_i=f_i, gamma=gamma, X=race_ratio_of_balls(k_X=1.04, gamma=gamma, f_i=f_i, f_e=f_e))
        C = rating_of_balls(b_m=b_m, f_c=f_c, alpha=alpha, Z=Z, D_w=D_w)
        Q_i = BallContact(D_w, gamma, f_i, inner=True).load(OF_BALLS)
        Q_e = BallContact(D_w, gamma, largest(f_e, OUTER_STATIC), inner=False).load(OF_BALLS)
        f_0 = static_factor(Q_i=Q_i, Q_e=Q_e, D_w=D_w)
        C_0 = static_of_balls(f_0=f_0, Z=Z, D_w=D_w, alpha=alpha)
    else:
        f_c = factor_of_rollers(gamma=gamma, X=race_ratio_of_rollers(k_X=1.04, gamma=gamma))
        C = rating_of_rollers(b_m=b_m, f_c=f_c, L_we=inside.roller_length, Z=Z, D_w=D_w)
        C_0 = static_of_rollers(gamma=gamma, Z=Z, L_we=inside.roller_length, D_w=D_w)
    if HV is not None:
        f_H = hardness_factor(HV=HV)
        C, C_0 = dynamic_on_shaft(f_H=f_H, C=C), static_on_shaft(f_H=f_H, C_0=C_0)
    return Ratings(C, C_0, fatigue_limit(inside.elements, C_0, inside.pitch), f_0)


def counted_grooves(inside: Inside[Any]) -> tuple[Any, Any]:
    """Radius over D_w of both grooves, as ratings count it: closer ones do not raise them."""
    f_i, f_e = inside.groove_inner, inside.groove_outer
    return based_on(largest(f_i, INNER), f_i), based_on(largest(f_e, OUTER), f_e)


def fatigue_limit(elements: Elements, C_0: Any, D_pw: Any) -> Any:
    """C_u by the static rating that rules, the catalogue's where it is given."""
    limit = limit_of_balls if elements == "ball" else limit_of_rollers
    return limit(C_0=C_0, D_pw=D_pw)
