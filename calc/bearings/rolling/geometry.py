# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="no-any-return"
"""What is inside a rolling bearing: its elements as given, and as is usual where nobody says; its raceways and mass.

All of one bearing, or of many of one type as arrays."""

from collections.abc import Iterable, Sequence
from dataclasses import fields
from typing import Any, Generic

import numpy as np

from ...sheet.arrays import Array, BoolArray, Value
from ...sheet.formula import formula
from ...sheet.functions import asin, cos, floor, pi, smallest
from ...sheet.record import record, replace
from ...sheet.text import Text
from ...sheet.units import Kilogram, KilogramPerMetre3, Metre, Number, Radian
from .sizes import BearingSize, Elements, Usual

FITTED = Text("rule of this program: fitted to catalogues, an estimate")
STEEL: KilogramPerMetre3 = 7850.0
EVERYWHERE = 0.52  # radius of a groove over D_w
OF_BALLS = 198  # ° of the pitch circle, which balls fill


@record
class Inside(Generic[Value]):
    """What is inside: the elements of a bearing of one row, in m."""

    elements: Elements
    count: Value  # Z
    diameter: Value  # D_w
    pitch: Value  # D_pw
    length: Value | None = None  # L_we of rollers
    contact_angle: float = 0.0  # rad
    groove_inner: float = EVERYWHERE  # radius over D_w, of balls
    groove_outer: float = EVERYWHERE

    @property
    def roller_length(self) -> Value:
        """L_we, which rollers have."""
        assert self.length is not None
        return self.length


# --- what is usual


@formula("D_w", Text("{fitted}: diameter of the elements by the space between the rings", fitted=FITTED), unit="mm")
def element_diameter(k_w: Number, D: Metre, d: Metre) -> Metre:
    return k_w * (D - d)


@formula("D_pw", Text("{fitted}: pitch diameter", fitted=FITTED), unit="mm")
def pitch_between(k_p: Number, D: Metre, d: Metre) -> Metre:
    return k_p * (D + d) / 2


@formula("D_pw", "geometry: pitch diameter of needles", unit="mm")
def pitch_on_raceway(F_w: Metre, D_w: Metre) -> Metre:
    return F_w + D_w


@formula("Z", Text("{fitted}: as many balls as an eccentric ring lets in", fitted=FITTED))
def count_of_balls(D_w: Metre, D_pw: Metre) -> Number:
    return floor(1 + OF_BALLS * pi / 180 / (2 * asin(D_w / D_pw)))


@formula("Z", Text("{fitted}: as many rollers as a cage lets stand on the pitch circle", fitted=FITTED))
def count_of_rollers(k_Z: Number, D_pw: Metre, D_w: Metre) -> Number:
    return floor(k_Z * pi * D_pw / D_w)


@formula("Z", "rule of this program: a cage in two halves has a roller less at each joint", names={"Z": "Z_whole"})
def count_of_split_cage(Z: Number) -> Number:
    return Z - 2


@formula("L_we", Text("{fitted}: effective length of rollers", fitted=FITTED), unit="mm")
def element_length(k_l: Number, B: Metre) -> Metre:
    return k_l * B


def diameters_of(size: BearingSize[Any], D_w: Any = None, D_pw: Any = None) -> tuple[Any, Any]:
    """D_w and D_pw, m, as given, else as is usual; of a bearing of one's own D_w is given."""
    usual, inner = size.usual, size.bore if size.raceway is None else size.raceway
    if D_w is None:
        D_w = element_diameter(k_w=usual.diameter, D=size.outside, d=inner)
    if D_pw is None and size.raceway is not None:
        D_pw = pitch_on_raceway(F_w=inner, D_w=D_w)
    elif D_pw is None:
        D_pw = pitch_between(k_p=1.0 if usual.pitch is None else usual.pitch, D=size.outside, d=size.bore)
    return D_w, D_pw


def inside_of(
    size: BearingSize[Any],
    *,
    split_cage: bool = False,
    count: Any = None,
    diameter: Any = None,
    length: Any = None,
    pitch: Any = None,
    contact_angle: Radian = 0.0,
    groove_inner: Number = EVERYWHERE,
    groove_outer: Number = EVERYWHERE,
) -> Inside[Any] | None:
    """The elements as they are given, in m and rad, the rest as is usual of such a size and of what is given.

    None of a bearing of one's own that does not say its elements: their number, diameter and, of rollers, length."""
    usual = size.usual
    if size.own and (count is None or diameter is None or (length is None and size.elements == "roller")):
        return None
    D_w, D_pw = diameters_of(size, diameter, pitch)
    Z = count
    if Z is None:
        balls = size.elements == "ball"
        Z = count_of_balls(D_w=D_w, D_pw=D_pw) if balls else count_of_rollers(k_Z=usual.filling, D_pw=D_pw, D_w=D_w)
        Z = count_of_split_cage(Z=Z) if split_cage else Z
    if size.elements == "ball":
        return Inside("ball", Z, D_w, D_pw, None, contact_angle, groove_inner, groove_outer)
    L_we = length
    if L_we is None:
        L_we = element_length(k_l=usual.length, B=size.width)
    return Inside("roller", Z, D_w, D_pw, L_we)


def overlap(inside: Inside[Any]) -> bool | BoolArray:
    """Whether so many elements have no place beside one another."""
    return inside.count * asin(smallest(inside.diameter / inside.pitch, 1.0)) > pi


# --- what follows


@formula(
    "γ",
    "ISO 281: diameter of the elements over the pitch diameter, seen along the contact",
    names={"alpha": "α_0"},
    meanings={
        "D_w": "Diameter of the rolling elements",
        "alpha": "Contact angle",
        "D_pw": "Pitch diameter of the rolling elements",
    },
)
def gamma(D_w: Metre, alpha: Radian, D_pw: Metre) -> Number:
    return D_w * cos(alpha) / D_pw


@formula(
    "d_m",
    "geometry: mean diameter of a bearing",
    unit="mm",
    meanings={"d": "Bore of the bearing", "D": "Outside diameter of the bearing"},
)
def mean_diameter(d: Metre, D: Metre) -> Metre:
    return (d + D) / 2


@formula(
    "F_w",
    "geometry: diameter of the inner raceway",
    unit="mm",
    meanings={"D_pw": "Pitch diameter of the rolling elements", "D_w": "Diameter of the rolling elements"},
)
def inner_raceway(D_pw: Metre, D_w: Metre) -> Metre:
    return D_pw - D_w


@formula(
    "E_w",
    "geometry: diameter of the outer raceway",
    unit="mm",
    meanings={"D_pw": "Pitch diameter of the rolling elements", "D_w": "Diameter of the rolling elements"},
)
def outer_raceway(D_pw: Metre, D_w: Metre) -> Metre:
    return D_pw + D_w


@formula("m_B", Text("{fitted}: so much of its outline is steel", fitted=FITTED))
def bearing_mass(k_m: Number, D: Metre, d: Metre, B: Metre) -> Kilogram:
    return k_m * pi / 4 * (D**2 - d**2) * B * STEEL


def mass_of(size: BearingSize[Any]) -> Any:
    """The mass of a bearing, kg."""
    return bearing_mass(k_m=size.usual.mass, D=size.outside, d=size.bore, B=size.width)


def gamma_of(inside: Inside[Any]) -> Any:
    return gamma(D_w=inside.diameter, alpha=inside.contact_angle, D_pw=inside.pitch)


# --- many at once


def alike(sizes: Iterable[BearingSize]) -> list[list[BearingSize]]:
    """The sizes by what may be stacked."""
    groups: dict[tuple[object, ...], list[BearingSize]] = {}
    for size in sizes:
        groups.setdefault(_kind(size), []).append(size)
    return list(groups.values())


def _kind(size: BearingSize) -> tuple[object, ...]:
    return size.type, size.own, size.inner_ring, size.flanged


def stacked(sizes: Sequence[BearingSize]) -> BearingSize[Array]:
    """Many bearings of one type, with or without inner ring, as columns: one bearing a row, so that duty rows lie along
    the last axis.  Its designation and series are those of the first."""
    first = sizes[0]
    if len(alike(sizes)) != 1:
        raise ValueError("bearings of several types do not stack")

    def column(of: Sequence[Any], name: str) -> Array | None:
        numbers = [getattr(row, name) for row in of]
        return None if None in numbers else np.array(numbers)[:, None]

    usual = [size.usual for size in sizes]
    keys = [one.name for one in fields(Usual)]
    factors: dict[str, Any] = {name: column(usual, name) for name in keys if name != "spread"}
    outline: dict[str, Any] = {name: column(sizes, name) for name in ("bore", "outside", "width", "raceway")}
    columns: Any = replace(first, usual=replace(first.usual, **factors), **outline)
    many: BearingSize[Array] = columns
    return many
