# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""How a rolling bearing sits between shaft and housing: fits, and the clearance that they and the warmth leave it.

The load turns with the shaft: it stands on the inner ring, whose fit may be loose, and sweeps the outer ring, which has
to be held.  All clearances are diametral.  A drawn cup and what has no inner ring roll on the shaft itself, a cage in
the bore of the housing too.  Centrifugal growth is below 0.3 µm at 12 000 rpm and 40 mm and is left out.

One bearing as numbers, or many of one type as arrays."""

from bisect import bisect_left
from collections.abc import Sequence
from functools import cache
from typing import Any, Generic, Literal

import numpy as np

from ...library.catalogue import Material, shipped_materials
from ...library.table_file import TableRow, house_table
from ...library.tolerances import ToleranceField, deviations, ends_of_ranges, parse
from ...sheet.arrays import Value
from ...sheet.formula import formula
from ...sheet.functions import largest
from ...sheet.record import record
from ...sheet.units import UNITS, Celsius, Kelvin, Metre, Number, Pascal, PerKelvin

LAME = "elasticity: thick rings in plane stress (Lamé)"
# rings, and a shaft of which nothing else is known: the row "steel" of the materials
RING_EXPANSION: PerKelvin = 11.5e-6
RING_MODULUS: Pascal = 206e9
RING_POISSON: Number = 0.3
NO_INTERFERENCE: Metre = 0.0
NO_DIFFERENCE: Kelvin = 0.0
ROOM: Celsius = 20.0  # at which parts have their measures
RING_RISE: Kelvin = 5.0  # of shaft and inner ring over the outer one; IKO: 5 to 10 K, 15 to 20 K at high speed
LEAST_SCALE: Metre = 1e-6
WALL = 2.0  # outside of the metal around a seat, over its bore, where not given

CLASSES = ("CN", "C3", "C4", "C5")
FieldPoint = Literal["least", "middle", "most"]  # of the clearance, between the ends of all tolerance fields
Span = tuple[Value, Value]  # lower and upper end

CLOSED = {"dd_F": "Δd_F", "dd_E": "Δd_E"}


# --- formulas


@formula(
    "U_i,T",
    "physics: interference of the inner ring at a temperature",
    unit="µm",
    names={"U": "U_i"},
    meanings={
        "U": "Interference of the inner ring as fitted",
        "d": "Bore of the bearing",
        "T": "Temperature of the fit",
    },
)
def interference_on_shaft(U: Metre, alpha_J: PerKelvin, d: Metre, T: Celsius) -> Metre:
    return U + (alpha_J - RING_EXPANSION) * d * (T - ROOM)


@formula(
    "U_o,T",
    "physics: interference of the outer ring at a temperature; χ, share of the housing's expansion held back",
    unit="µm",
    names={"U": "U_o", "alpha_H": "α_H"},
    meanings={
        "U": "Interference of the outer ring as fitted",
        "alpha_H": "Thermal expansion of the housing",
        "D": "Outside diameter of the bearing",
        "T": "Temperature of the fit",
    },
)
def interference_in_seat(U: Metre, alpha_H: PerKelvin, chi: Number, D: Metre, T: Celsius) -> Metre:
    """>>> interference_in_seat(U=-4e-6, alpha_H=21.5e-6, chi=0, D=0.052, T=110)
    -5.08...e-05
    """
    return U - (alpha_H - RING_EXPANSION) * (1 - chi) * D * (T - ROOM)


@formula(
    "Δd_F",
    f"{LAME}: by which the raceway of the inner ring grows, on a shaft of the same steel with a bore d_b",
    unit="µm",
    names={"U": "U_i,T"},
    meanings={"d": "Bore of the bearing"},
)
def inner_ring_growth(U: Metre, d: Metre, d_F: Metre, d_b: Metre) -> Metre:
    """>>> inner_ring_growth(U=10e-6, d=0.025, d_F=0.0315, d_b=0)
    7.93...e-06
    """
    return largest(U, NO_INTERFERENCE) * (d / d_F) * (1 - (d_b / d) ** 2) / (1 - (d_b / d_F) ** 2)


@formula(
    "p",
    f"{LAME}: pressure of the seat",
    unit="MPa",
    names={"U": "U_o,T", "nu_H": "ν_H"},
    meanings={
        "D": "Outside diameter of the bearing",
        "D_h": "Outside diameter of the housing",
        "E_H": "Modulus of elasticity of the housing",
        "nu_H": "Poisson's ratio of the housing",
    },
)
def seat_pressure(U: Metre, D: Metre, d_E: Metre, D_h: Metre, E_H: Pascal, nu_H: Number) -> Pascal:
    """`D_h`: outside of a ring as stiff as the metal around the seat."""
    return largest(U, NO_INTERFERENCE) / (
        D / RING_MODULUS * ((D**2 + d_E**2) / (D**2 - d_E**2) - RING_POISSON)
        + D / E_H * ((D_h**2 + D**2) / (D_h**2 - D**2) + nu_H)
    )


@formula(
    "Δd_E",
    f"{LAME}: by which the raceway of the outer ring closes",
    unit="µm",
    meanings={"D": "Outside diameter of the bearing"},
)
def outer_ring_closing(p: Pascal, d_E: Metre, D: Metre) -> Metre:
    return 2 * p * d_E / (RING_MODULUS * (1 - (d_E / D) ** 2))


@formula(
    "g",
    "physics: a raceway of the shaft grows otherwise than steel",
    unit="µm",
    names={"d_F": "F_w"},
)
def widening_by_journal(alpha_J: PerKelvin, d_F: Metre, T: Celsius) -> Metre:
    return (RING_EXPANSION - alpha_J) * d_F * (T - ROOM)


@formula(
    "g",
    "rule of this program: a drawn cup follows its housing, over F_w; physics: and the raceway of the shaft its steel",
    unit="µm",
    names={"d_F": "F_w", "alpha_H": "α_H"},
)
def widening_of_cup(alpha_H: PerKelvin, chi: Number, alpha_J: PerKelvin, d_F: Metre, T: Celsius) -> Metre:
    return ((alpha_H - RING_EXPANSION) * (1 - chi) - (alpha_J - RING_EXPANSION)) * d_F * (T - ROOM)


@formula(
    "G_r",
    "geometry: what fits and warmth leave of the clearance of two rings",
    unit="µm",
    names=CLOSED,
    meanings={"G_0": "Clearance as made", "Delta_T": "Excess of the inner ring over the outer"},
)
def clearance_of_rings(G_0: Metre, dd_F: Metre, dd_E: Metre, Delta_T: Kelvin, d_E: Metre) -> Metre:
    return G_0 - dd_F - dd_E - RING_EXPANSION * Delta_T * d_E


@formula("G_r", "geometry: what fits and warmth leave of the clearance on the shaft itself", unit="µm", names=CLOSED)
def clearance_on_shaft(G_0: Metre, g: Metre, dd_E: Metre, Delta_T: Kelvin, d_E: Metre) -> Metre:
    return G_0 + g - dd_E - RING_EXPANSION * Delta_T * d_E


# --- tables


def _table() -> TableRow:
    return house_table("rolling_fits.toml")


def _stepped(ends: Sequence[float], numbers: Sequence[float], d: Value) -> Value:
    """The number of the range, its end included, in which each diameter [m] lies; not a number beyond the last."""
    known: Any = np.array([*numbers, np.nan])
    if not isinstance(d, float):
        return known[np.searchsorted(ends, np.round(np.asarray(d) * 1e3, 9))]
    return known[bisect_left(ends, UNITS["mm"].shown(d))].item()


@cache
def _by_range(field: ToleranceField) -> tuple[list[float], list[float], list[float]]:
    """Ends of the ranges [mm] and both deviations in them [m]."""
    ends = ends_of_ranges()
    low, high = zip(*(deviations(field, end / 1e3) for end in ends))
    return ends, list(low), list(high)


def limits(field: ToleranceField, d: Value) -> Span[Value]:
    """Lower and upper deviation [m] by ISO 286, of one diameter or of many."""
    if isinstance(d, float):
        return deviations(field, d)
    ends, low, high = _by_range(field)
    return _stepped(ends, low, d), _stepped(ends, high, d)


def ring_limits(part: Literal["bore", "outside"], d: Value) -> Span[Value]:
    """Lower and upper deviation [m] of a ring of class Normal."""
    row = _table()[part]
    below = _stepped(row["up_to_mm"], row["lower"], d)
    return below / 1e6, 0.0 * below


def free_clearance(elements: str, clearance_class: str, d: Value) -> Span[Value] | None:
    """Least and most clearance [m] before mounting, by the bore; None (of many: not a number) outside the table."""
    row = _table()["clearance"][elements]
    ends: list[float] = row["up_to_mm"]
    spans: list[list[float]] = row[clearance_class]
    low = [np.nan, *(span[0] / 1e6 for span in spans)]
    high = [np.nan, *(span[1] / 1e6 for span in spans)]
    ranges = [row["above_mm"], *ends]
    found = _stepped(ranges, low, d), _stepped(ranges, high, d)
    return None if isinstance(d, float) and np.isnan(found[0]) else found


def usual_fits(type: str, inner_ring: bool) -> tuple[str, str]:
    """Of shaft and seat, where nothing is said: the hole around a cage is its raceway."""
    usual, rings = _table()["default"], inner_ring and type in ("ball", "roller", "needle")
    seat: str = _table()["bore_without_ring"]["cage"] if type == "cage" else usual["seat"]
    return usual["shaft" if rings else "raceway"], seat


# --- how one bearing sits, or many of a type


@record
class Fits(Generic[Value]):
    """Tolerance fields that meet, each from its loose to its tight end [m].

    `free`: the clearance before mounting, lower and upper, on the shaft itself that of raceway and shaft; None where no
    table has it.  `on_shaft`, `in_seat`: interference at 20 °C, loosest and tightest; None where no ring sits."""

    free: Span[Value] | None
    on_shaft: Span[Value] | None
    in_seat: Span[Value] | None


def fields_of(
    type: str, inner_ring: bool, shaft_fit: str | None, seat_fit: str | None
) -> tuple[ToleranceField, ToleranceField]:
    """The fields of its place on the shaft and of its seat, as given, else the usual ones.  Raises ValueError where a
    word is no tolerance class."""
    shaft, seat = usual_fits(type, inner_ring)
    return parse(shaft_fit or shaft, "shaft in a ring"), parse(seat_fit or seat, "hole for a ring")


def fits_of(
    type: str,
    d: Value,
    D: Value,
    *,
    inner_ring: bool = True,
    shaft_fit: str | None = None,
    seat_fit: str | None = None,
    clearance_class: str | None = None,
    clearance: Span[Value] | None = None,
) -> Fits[Value]:
    """What meets where a bearing is mounted: `d` its bore, else F_w; `D` its outside, of a cage E_w [m].

    Left out, fits and class are the usual ones; `clearance` [m] replaces the class.  The outside of a drawn cup is
    taken as a ring's.  Raises ValueError where a word is no tolerance class."""
    usual = _table()["default"]
    rings = inner_ring and type in ("ball", "roller", "needle")
    on_shaft, seat = fields_of(type, inner_ring, shaft_fit, seat_fit)
    shaft, hole, in_seat = limits(on_shaft, d), limits(seat, D), None
    if type != "cage":
        outside = ring_limits("outside", D)
        in_seat = outside[0] - hole[1], outside[1] - hole[0]
    if rings:
        bore = ring_limits("bore", d)
        elements = "ball" if type == "ball" else "roller"
        free = clearance or free_clearance(elements, clearance_class or usual["clearance_class"], d)
        return Fits(free, (shaft[0] - bore[1], shaft[1] - bore[0]), in_seat)
    raceway = hole
    if type != "cage":
        raceway = limits(parse(_table()["bore_without_ring"][type], "hole for a ring"), d)
    return Fits(clearance or (raceway[0] - shaft[1], raceway[1] - shaft[0]), None, in_seat)


def at_place(span: Span[Value], place: FieldPoint) -> Value:
    """One end of a span, or its middle."""
    low, high = span
    return low if place == "least" else high if place == "most" else (low + high) / 2


@record
class Mounting(Generic[Value]):
    """A bearing in its place: outline and raceways [m], fits, the metal around its seat and its journal.

    `inner_raceway`: d_F, `outer_raceway`: d_E, over and under the elements; None where these are not known.
    `housing_outer`: outside of a ring as stiff as the metal around the seat, left out twice the seat's bore.  A seat in
    an insert is that of its steel."""

    type: str
    bore: Value
    outside: Value
    inner_raceway: Value | None
    outer_raceway: Value | None
    fits: Fits[Value]
    housing_expansion: Value | float
    housing_modulus: Value | float
    housing_poisson: Value | float
    restraint: Value | float = 0.0
    housing_outer: Value | float | None = None
    journal_expansion: Value | float = RING_EXPANSION
    shaft_bore: Value | float = 0.0

    def interference_on_shaft(self, T: Value | float, place: FieldPoint = "middle") -> Any:
        """Of the inner ring at T [°C]: where the clearance is least the tightest.  None without an inner ring."""
        if self.fits.on_shaft is None:
            return None
        U = at_place(self.fits.on_shaft, _OTHER[place])
        return interference_on_shaft(U=U, alpha_J=self.journal_expansion, d=self.bore, T=T)

    def grip(self, T: Value | float, place: FieldPoint = "most") -> Any:
        """Interference of the outer ring or the cup in its seat at T [°C], by default the loosest; None of a cage.

        Below nought the ring creeps under the load that sweeps it.  A cup that is loose turns, and its clearance is an
        upper estimate."""
        if self.fits.in_seat is None:
            return None
        U, D = at_place(self.fits.in_seat, _OTHER[place]), self.outside
        return interference_in_seat(U=U, alpha_H=self.housing_expansion, chi=self.restraint, D=D, T=T)

    def clearance(self, T: Value | float, ring_rise: Value | float = RING_RISE, place: FieldPoint = "middle") -> Any:
        """The diametral clearance [m] at T [°C] of housing and outer ring, the inner one `ring_rise` [K] above it; None
        where it is not known before mounting."""
        d_F, d_E = self.inner_raceway, self.outer_raceway
        if self.fits.free is None or d_F is None or d_E is None:
            return None
        G_0 = at_place(self.fits.free, place)
        closing: Any = 0.0
        if self.type not in ("cup", "cage"):
            D = self.outside
            D_h = WALL * D if self.housing_outer is None else self.housing_outer
            E_H, nu_H = self.housing_modulus, self.housing_poisson
            p = seat_pressure(U=self.grip(T, place), D=D, d_E=d_E, D_h=D_h, E_H=E_H, nu_H=nu_H)
            closing = outer_ring_closing(p=p, d_E=d_E, D=D)
        U_i = self.interference_on_shaft(T, place)
        if U_i is not None:
            growth = inner_ring_growth(U=U_i, d=self.bore, d_F=d_F, d_b=self.shaft_bore)
            return clearance_of_rings(G_0=G_0, dd_F=growth, dd_E=closing, Delta_T=ring_rise, d_E=d_E)
        alpha_J = self.journal_expansion
        if self.type == "cup":
            alpha_H, chi = self.housing_expansion, self.restraint
            g = widening_of_cup(alpha_H=alpha_H, chi=chi, alpha_J=alpha_J, d_F=self.bore, T=T)
        else:
            g = widening_by_journal(alpha_J=alpha_J, d_F=self.bore, T=T)
        return clearance_on_shaft(G_0=G_0, g=g, dd_E=closing, Delta_T=ring_rise, d_E=d_E)


_OTHER: dict[FieldPoint, FieldPoint] = {
    "least": "most",
    "middle": "middle",
    "most": "least",
}  # an interference takes clearance


def metal_of_seat(housing: Material, held: str) -> Material:
    """What the outer ring sits in: the housing itself, or where it is `held` by an "insert" that is cast in, steel."""
    return shipped_materials()["steel"] if held == "insert" else housing


@record
class Clearances:
    """What a bearing has between its elements and raceways [m], and how its outer ring is held; each None where it is
    not known.

    running, least, most: at the bearing's temperature; frozen: the least at the lowest temperature, rings alike; start:
    the least at 20 °C, the shaft warm already; mounted: the middle at 20 °C.  grip_hot: the loosest fit of the outer
    ring at the bearing's temperature; grip_mounted: its middle at 20 °C."""

    running: Any
    least: Any
    most: Any
    frozen: Any
    start: Any
    mounted: Any
    grip_hot: Any
    grip_mounted: Any

    @property
    def scale(self) -> Any:
        """What a margin of a clearance is a share of."""
        return None if self.mounted is None else np.maximum(np.abs(self.mounted), LEAST_SCALE)

    @property
    def grip_scale(self) -> Any:
        return None if self.grip_mounted is None else np.maximum(self.grip_mounted, LEAST_SCALE)


def clearances(
    mounting: Mounting[Value], T_b: Value | float, lowest: float, ring_rise: float = RING_RISE
) -> Clearances:
    """All that is published of one bearing, or of many, at its temperature T_b and at the `lowest` one [°C]."""
    return Clearances(
        running=mounting.clearance(T_b, ring_rise),
        least=mounting.clearance(T_b, ring_rise, "least"),
        most=mounting.clearance(T_b, ring_rise, "most"),
        frozen=mounting.clearance(lowest, NO_DIFFERENCE, "least"),
        start=mounting.clearance(ROOM, ring_rise, "least"),
        mounted=mounting.clearance(ROOM, NO_DIFFERENCE),
        grip_hot=mounting.grip(T_b),
        grip_mounted=mounting.grip(ROOM, "middle"),
    )
