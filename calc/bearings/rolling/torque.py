# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""What turning a rolling bearing takes, under radial load: SKF's newer model, or two parts by Palmgren and by INA.

Of SKF's model the rolling and the sliding part are counted, not seals nor drag in deep oil: its constants for
deep-groove ball and cylindrical roller bearings alone are public.  The two-part formula has a part of the oil, f_0, and
one of the load, f_1; Palmgren's own factors are by type alone and stand by the bearings of wheels, INA's are by series.
All constants and how sure they are: `library/tables/rolling_friction.toml`.

One bearing as numbers, or many of one type, of many loads, speeds and oils, as arrays that broadcast."""

from collections.abc import Sequence
from typing import Any, Generic, Literal

import numpy as np

from ...library.table_file import TableRow, house_table
from ...sheet.arrays import Value
from ...sheet.formula import formula
from ...sheet.functions import exp, largest, sqrt
from ...sheet.record import record
from ...sheet.text import Text
from ...sheet.units import Metre, Newton, NewtonMetre, Number, RevPerSecond, SquareMetrePerSecond
from .geometry import mean_diameter

PALMGREN = Text("Palmgren 1957 (SKF catalogues to 1989, ISO/TR 14179-2)")
SKF = Text("SKF 2013")
INA = Text("INA, from memory")
MILLIMETRE: Metre = 1e-3
CENTISTOKE: SquareMetrePerSecond = 1e-6
ONE_RPM: RevPerSecond = 1 / 60
ONE_NEWTON: Newton = 1.0
NEWTON_MILLIMETRE: NewtonMetre = 1e-3

Elements = Literal["ball", "roller"]
Series = str | Sequence[str]
STARVED = {"bath": 3e-8, "splash": 3e-8, "jet": 3e-8, "mist": 6e-8}  # K_rs
SUPPLY = {"bath": 1.0, "splash": 1.0, "mist": 0.5, "jet": 2.0}  # of Palmgren's f_0
# what Palmgren's tables call a type
CALLED = {
    "ball": "deep-groove-ball",
    "roller": "cylindrical-roller",
    "needle": "needle-roller",
    "cup": "needle-roller",
    "cage": "needle-roller",
}


def constants(section: str) -> TableRow:
    """A section of the table of constants."""
    rows: TableRow = house_table("rolling_friction.toml")[section]
    return rows


def of_series(rows: TableRow, series: Series) -> Any:
    """The numbers of one series as they stand; of many series an array of each, of their shape."""
    if isinstance(series, str):
        return rows[series]
    words = np.asarray(series)
    rows_of_all = np.array([rows[name] for name in words.ravel()])
    return np.moveaxis(rows_of_all, 0, -1).reshape(*rows_of_all.shape[1:], *words.shape)


# --- Palmgren, and the same two parts with INA's factors


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


@formula(
    "G_rr",
    Text("{skf}: rolling, deep-groove ball bearing under radial load", skf=SKF),
    meanings={"R_1": "Constant of the rolling moment"},
)
def rolling_of_balls(R_1: Number, d_m: Metre, F: Newton) -> Number:
    return R_1 * (d_m / MILLIMETRE) ** 1.96 * (F / ONE_NEWTON) ** 0.54


@formula(
    "G_sl",
    Text("{skf}: sliding, deep-groove ball bearing under radial load", skf=SKF),
    meanings={"S_1": "Constant of the sliding moment"},
)
def sliding_of_balls(S_1: Number, d_m: Metre, F: Newton) -> Number:
    return S_1 * (d_m / MILLIMETRE) ** -0.26 * (F / ONE_NEWTON) ** (5 / 3)


@formula("G_rr", Text("{skf}: rolling, cylindrical roller bearing under radial load", skf=SKF))
def rolling_of_rollers(R_1: Number, d_m: Metre, F: Newton) -> Number:
    return R_1 * (d_m / MILLIMETRE) ** 2.41 * (F / ONE_NEWTON) ** 0.31


@formula("G_sl", Text("{skf}: sliding, cylindrical roller bearing under radial load", skf=SKF), names={"S_1": "S_2"})
def sliding_of_rollers(S_1: Number, d_m: Metre, F: Newton) -> Number:
    return S_1 * d_m / MILLIMETRE * F / ONE_NEWTON


@formula("φ_ish", Text("{skf}: heat of the sheared inlet", skf=SKF), meanings={"n": "Speed"})
def inlet_heat(n: RevPerSecond, d_m: Metre, nu: SquareMetrePerSecond) -> Number:
    return 1 / (1 + 1.84e-9 * (n / ONE_RPM * d_m / MILLIMETRE) ** 1.28 * (nu / CENTISTOKE) ** 0.64)


@formula(
    "φ_rs",
    Text("{skf}: oil pushed aside and starved; K_rs 3·10⁻⁸ in a bath of low level or a jet, 6·10⁻⁸ in mist", skf=SKF),
    meanings={
        "K_rs": "Constant of starved oil",
        "d": "Bore of the bearing",
        "D": "Outside diameter of the bearing",
        "K_Z": "Constant of the kind of bearing",
        "n": "Speed",
    },
)
def starvation(K_rs: Number, nu: SquareMetrePerSecond, n: RevPerSecond, d: Metre, D: Metre, K_Z: Number) -> Number:
    return exp(-K_rs * nu / CENTISTOKE * n / ONE_RPM * (d + D) / MILLIMETRE * sqrt(K_Z / 2 * MILLIMETRE / (D - d)))


@formula("φ_bl", Text("{skf}: share of boundary lubrication", skf=SKF), meanings={"n": "Speed"})
def boundary_share(n: RevPerSecond, nu: SquareMetrePerSecond, d_m: Metre) -> Number:
    return exp(-2.6e-8 * (n / ONE_RPM * nu / CENTISTOKE) ** 1.4 * d_m / MILLIMETRE)


@formula(
    "μ_sl",
    Text("{skf}: friction of sliding, 0.12 at the boundary", skf=SKF),
    meanings={"mu_EHL": "Coefficient of friction of a full film"},
)
def sliding_friction(phi_bl: Number, mu_EHL: Number) -> Number:
    return phi_bl * 0.12 + (1 - phi_bl) * mu_EHL


@formula("M", Text("{skf}: rolling and sliding", skf=SKF), meanings={"n": "Speed"})
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


@formula("M", Text("{palmgren}: both parts", palmgren=PALMGREN))
def torque_by_palmgren(M_0: NewtonMetre, M_1: NewtonMetre) -> NewtonMetre:
    return M_0 + M_1


@formula("f_1", Text("{ina}: factor of the load of a deep-groove ball bearing", ina=INA))
def load_factor(F: Newton, C_0: Newton) -> Number:
    return 0.0007 * sqrt(F / C_0)


@formula("f_0", Text("{ina}: factor of the oil of a drawn cup or a needle cage", ina=INA), names={"f": "f_B"})
def oil_factor(f: Number, B: Metre, F_w: Metre) -> Number:
    return f * B / (33 * MILLIMETRE + F_w)


@formula("M", Text("{ina}: a part of the oil, ν·n no less than 2000 mm²/s·rpm, and one of the load", ina=INA))
def two_part_torque(
    f_0: Number, nu: SquareMetrePerSecond, n: RevPerSecond, d_m: Metre, f_1: Number, F: Newton
) -> NewtonMetre:
    """>>> two_part_torque(f_0=12.41, nu=12e-6, n=43.33, d_m=28.5e-3, f_1=5e-4, F=1700)
    0.052694...
    """
    return (
        1e-7
        * f_0
        * largest(nu / CENTISTOKE * n / ONE_RPM, 2000.0) ** (2 / 3)
        * (d_m / MILLIMETRE) ** 3
        * NEWTON_MILLIMETRE
        + f_1 * F * d_m
    )


@formula(
    "M",
    "rule of this program: the larger of two models, since SKF's drag in deep oil is given as a diagram only",
    names={"M_1": "M_SKF", "M_2": "M_2"},
)
def larger_torque(M_1: NewtonMetre, M_2: NewtonMetre) -> NewtonMetre:
    return largest(M_1, M_2)


@formula("M", Text("{skf}: a constant coefficient of friction, an approximation", skf=SKF), names={"mu": "μ_P"})
def torque_by_rule(mu: Number, F: Newton, d: Metre) -> NewtonMetre:
    """>>> torque_by_rule(mu=0.0011, F=1700, d=0.025)
    0.023375...
    """
    return mu * F * d / 2


def skf_torque(
    elements: str,
    R_1: Value,
    S_1: Value,
    d: Value,
    D: Value,
    d_m: Value,
    lubrication: str,
    base: str,
    F: Value,
    n: Value,
    nu: Value,
) -> Value:
    """SKF's model as a whole, by its parts.  `base`: of the oil, "mineral" or another, which matters for balls."""
    balls = elements == "ball"
    known = constants("skf")[elements]
    rolling, sliding = (rolling_of_balls, sliding_of_balls) if balls else (rolling_of_rollers, sliding_of_rollers)
    mu_EHL = known["mu_EHL_other_base"] if balls and base != "mineral" else known["mu_EHL"]
    phi_ish = inlet_heat(n=n, d_m=d_m, nu=nu)
    phi_rs = starvation(K_rs=STARVED[lubrication], nu=nu, n=n, d=d, D=D, K_Z=known["K_Z"])
    G_rr, G_sl = rolling(R_1=R_1, d_m=d_m, F=F), sliding(S_1=S_1, d_m=d_m, F=F)
    mu_sl = sliding_friction(phi_bl=boundary_share(n=n, nu=nu, d_m=d_m), mu_EHL=mu_EHL)
    return torque_by_skf(phi_ish=phi_ish, phi_rs=phi_rs, G_rr=G_rr, nu=nu, n=n, G_sl=G_sl, mu_sl=mu_sl)


# --- one bearing, or many of a type


@record
class Friction(Generic[Value]):
    """What the torque follows from besides load F, speed n and viscosity ν: of one bearing, or of many of a type.

    `judged`: the model that counts, SKF's, the two parts, or the larger of them.  `f_1` is None where it follows from
    the load over the static rating, `R_1` and `S_1` where SKF's constants are not public."""

    type: str
    elements: Elements
    judged: Literal["skf", "two_part", "larger"]
    lubrication: str
    base: str
    bore: Value
    outside: Value
    mean_diameter: Value
    f_0: Value
    f_1: Value | None
    static_rating: Value | None = None
    R_1: Value | None = None
    S_1: Value | None = None

    def torque(self, F: Value, n: Value, nu: Value) -> Value:
        """The torque that counts [N·m] under the mean load F [N], at n [1/s] and ν [m²/s]."""
        if self.judged == "two_part":
            return self.by_two_parts(F, n, nu)
        if self.judged == "skf":
            return self.by_skf(F, n, nu)
        return larger_torque(M_1=self.by_skf(F, n, nu), M_2=self.by_two_parts(F, n, nu))

    def by_skf(self, F: Value, n: Value, nu: Value) -> Value:
        assert self.R_1 is not None and self.S_1 is not None, "a needle, or a bearing of one's own"
        d, D, d_m = self.bore, self.outside, self.mean_diameter
        return skf_torque(self.elements, self.R_1, self.S_1, d, D, d_m, self.lubrication, self.base, F, n, nu)

    def by_two_parts(self, F: Value, n: Value, nu: Value) -> Value:
        f_1 = self.f_1
        if f_1 is None:
            assert self.static_rating is not None
            f_1 = load_factor(F=F, C_0=self.static_rating)
        return two_part_torque(f_0=self.f_0, nu=nu, n=n, d_m=self.mean_diameter, f_1=f_1, F=F)

    def by_palmgren(self, F: Value, n: Value, nu: Value) -> Value:
        """By the factors that the bearings of wheels have: of needles four times INA's, an upper bound."""
        f_0, f_1 = constants("palmgren")[CALLED[self.type]]
        M_0 = torque_of_oil(f_0=f_0 * SUPPLY[self.lubrication], nu=nu, n=n, d_m=self.mean_diameter)
        return torque_by_palmgren(M_0=M_0, M_1=torque_of_load(f_1=f_1, F=F, d_m=self.mean_diameter))

    def by_rule(self, F: Value) -> Value:
        mu = constants("rule")[self.type if self.type in ("ball", "roller") else "needle"]
        return torque_by_rule(mu=mu, F=F, d=self.bore)


def friction_of(
    type: str,
    series: Series,
    d: Value,
    D: Value,
    B: Value,
    *,
    static_rating: Value | None = None,
    lubrication: str = "splash",
    base: str = "mineral",
    f_0: float | None = None,
    f_1: float | None = None,
) -> Friction[Value]:
    """The friction of a bearing by its type, series and outline [m]; `d`: of what has no inner ring F_w, `D`: of a cage
    E_w.  Many series of a type: a word for each element of the arrays.

    `lubrication`: splash, jet, mist or bath.  `f_0`, `f_1`: given ones replace the usual and make the two-part formula
    judged.  Ball bearings need `static_rating`, unless `f_1` is given."""
    rows = constants("two_part")[type]["series"]
    in_mist, in_oil, *usual_f_1 = of_series(rows, series)
    usual = in_mist if lubrication == "mist" else in_oil
    known_0: Any = f_0
    known_1: Any = f_1
    if known_0 is None:
        known_0 = oil_factor(f=usual, B=B, F_w=d) if type in ("cup", "cage") else usual
    if known_1 is None and usual_f_1:
        known_1 = usual_f_1[0]
    judged: Literal["skf", "two_part", "larger"] = "two_part"
    R_1 = S_1 = None
    if type in ("ball", "roller") and series != "own":
        R_1, S_1 = of_series(constants("skf")[type]["series"], series)
        if f_0 is None and f_1 is None:
            judged = "larger" if lubrication == "bath" else "skf"
    return Friction(
        type=type,
        elements="ball" if type == "ball" else "roller",
        judged=judged,
        lubrication=lubrication,
        base=base,
        bore=d,
        outside=D,
        mean_diameter=mean_diameter(d=d, D=D),
        f_0=known_0,
        f_1=known_1,
        static_rating=static_rating,
        R_1=R_1,
        S_1=S_1,
    )
