# SPDX-License-Identifier: Apache-2.0
"""What a designation means: `size_of("NU 205")` is the outline of that bearing, with what is usual inside it.

Outlines are those of the standards (`library/tables/rolling_bearings.toml`), without a maker's ratings.  Nothing here
needs numpy: designs are read with it."""

import re
from collections.abc import Iterator, Mapping
from difflib import get_close_matches
from functools import cache
from itertools import product
from typing import Any, Generic, Literal

from ...library.table_file import TableRow, house_table
from ...sheet.arrays import Value
from ...sheet.record import record, replace
from ...sheet.text import SPACE, Text
from ...sheet.units import UNITS, Metre

FILE = "rolling_bearings.toml"

Elements = Literal["ball", "roller"]
Type = Literal["ball", "roller", "needle", "cup", "cage"]  # needle: with machined rings; cup: drawn; cage: no ring

BALLS = ("60", "62", "63")
ROLLERS = ("10", "2", "3", "22", "23")  # series of NU and NJ
OUTLINE = {"10": "60", "2": "62", "3": "63", "22": "22", "23": "23"}  # of rollers: the row that has their outline
CUP_WIDTHS = range(6, 61)  # mm
LARGEST: Metre = 0.5  # of a cage: as far as tolerances go


class UnknownSize(ValueError):
    """A designation that is none here: `text` says what is allowed, and the nearest that there is."""

    def __init__(self, text: Text) -> None:
        self.text = text
        super().__init__(text)


@record
class Usual:
    """What is usual inside bearings of one kind, as numbers without a unit (see the table), and the rating factor b_m.

    None where nothing is usual: of a bearing of one's own, of the length of balls.  `thrust_factor`, `thrust_from`: Y
    and e of flanged rollers.  `spread`: of the ratings that are computed from it, over catalogues'."""

    rating: Any  # a number, or an array of many
    mass: Any
    diameter: Any = None
    pitch: Any = None
    filling: Any = None
    length: Any = None
    thrust_factor: Any = None
    thrust_from: Any = None
    spread: str = ""


@record
class BearingSize(Generic[Value]):
    """The outline of a bearing, in m: of one, or of many of one type (`geometry.stacked`).

    `series`: 60 62 63; 10 2 3 22 23 of cylindrical rollers; NA49, RNA49, HK, K; or own.  `bore`: of the inner ring,
    else the raceway on the shaft, F_w; `outside`: of the outer ring or cup, else that over the elements, E_w."""

    designation: str
    type: Type
    series: str
    bore: Value
    outside: Value
    width: Value
    usual: Usual
    raceway: Value | None = None  # F_w of needles
    inner_ring: bool = True
    flanged: bool = False  # carries thrust: NJ

    @property
    def elements(self) -> Elements:
        return "ball" if self.type == "ball" else "roller"

    @property
    def own(self) -> bool:
        return self.series == "own"


def size_of(designation: str) -> BearingSize:
    """The bearing that a designation means; blanks and case do not count.  Raises UnknownSize."""
    word = "".join(designation.split()).upper().replace("×", "X")
    for pattern, made in _KINDS.items():
        if match := re.fullmatch(pattern, word, re.ASCII):
            size: BearingSize = made(*match.groups())
            return size
    raise UnknownSize(_unknown(designation, word))


@cache
def every_size() -> tuple[BearingSize, ...]:
    """The grid of a search: all bore codes of all series, drawn cups in their usual widths; cages are the user's."""
    return tuple(size_of(name) for name in _names())


@cache
def listed_cages() -> tuple[BearingSize, ...]:
    """Needle cages that a maker lists."""
    return tuple(size_of(f"K{name}") for name in _table()["cages"]["sizes"])


def own_size(elements: Elements, bore: Metre, outside: Metre, width: Metre) -> BearingSize:
    """A bearing of one's own with both rings: its outline, of which nothing is usual."""
    return BearingSize("own", elements, "own", bore, outside, width, _usual(f"own_{elements}"))


# --- the kinds, each by the parts of its designation


def _ball(series: str, code: str) -> BearingSize:
    row, at = _outline(series), _code(series, code)
    outline = (_bore(at), _mm(row["outside_mm"][at]), _mm(row["width_mm"][at]))
    return BearingSize(series + code, "ball", series, *outline, _usual("ball"))


def _roller(form: str, series: str, code: str) -> BearingSize:
    row, at = _outline(OUTLINE[series]), _code(form + series, code)
    outline = (_bore(at), _mm(row["outside_mm"][at]), _mm(row["width_mm"][at]))
    usual = _usual("roller_10" if series == "10" else "roller")
    if form == "NJ":
        thrust = _table()["thrust"]["roller_wide" if series in ("22", "23") else "roller"]
        usual = replace(usual, thrust_factor=thrust["Y"], thrust_from=thrust["e"])
    return BearingSize(form + series + code, "roller", series, *outline, usual, flanged=form == "NJ")


def _needle(without: str, code: str) -> BearingSize:
    row, series = _outline("NA49"), f"{without}NA49"
    at = _code(series, code)
    raceway, outside, width = (_mm(row[key][at]) for key in ("raceway_mm", "outside_mm", "width_mm"))
    bore = raceway if without else _bore(at)
    return BearingSize(series + code, "needle", series, bore, outside, width, _usual("needle"), raceway, not without)


def _cup(raceway: str, width: str) -> BearingSize:
    row = _table()["cups"]
    known = [f"{F_w:.0f}" for F_w in row["raceway_mm"]]
    if raceway not in known or int(width) not in CUP_WIDTHS:
        raise UnknownSize(
            Text(
                "HK{raceway}{width}: drawn cups are HK, F_w and the width, two digits each; F_w is one of {known} mm, "
                "the width {least} to {most} mm",
                raceway=raceway,
                width=width,
                known=", ".join(known),
                least=f"{CUP_WIDTHS[0]:02}",
                most=f"{CUP_WIDTHS[-1]}",
            )
        )
    F_w, outside = _mm(int(raceway)), _mm(row["outside_mm"][known.index(raceway)])
    return BearingSize(f"HK{raceway}{width}", "cup", "HK", F_w, outside, _mm(int(width)), _usual("cup"), F_w, False)


def _cage(inside: str, outside: str, width: str) -> BearingSize:
    name = f"K{inside}x{outside}x{width}"
    F_w, E_w, B = (_mm(float(part)) for part in (inside, outside, width))
    if not 0 < F_w < E_w <= LARGEST or not 0 < B <= LARGEST:
        raise UnknownSize(
            Text(
                "{name}: of K F_w x E_w x B, E_w is larger than F_w, and none is 0 or above {most} mm: K25x30x20",
                name=name,
                most=f"{UNITS['mm'].shown(LARGEST):.0f}",
            )
        )
    return BearingSize(name, "cage", "K", F_w, E_w, B, _usual("cage"), F_w, False)


_NUMBER = r"(\d+(?:\.\d+)?)"
_KINDS: dict[str, Any] = {  # Any: each takes the groups of its pattern
    r"(60|62|63)(\d\d)": _ball,
    r"(NU|NJ)(10|22|23|2|3)(\d\d)": _roller,
    r"(R?)NA49(\d\d)": _needle,
    r"HK(\d\d)(\d\d)": _cup,
    rf"K{_NUMBER}X{_NUMBER}X{_NUMBER}": _cage,
}


def _code(series: str, code: str) -> int:
    """The place of a bore code in the table."""
    codes: list[str] = _table()["bore_codes"]
    if code not in codes:
        bores = ", ".join(f"{word} {bore:.0f}" for word, bore in zip(codes, _table()["bores_mm"]))
        raise UnknownSize(
            Text(
                "{series}{code}: {code} is no bore code that is known here; codes and bores in mm: {bores} (the "
                "nearest is {near})",
                series=series,
                code=code,
                near=series + (codes[0] if code < codes[0] else codes[-1]),
                bores=bores,
            )
        )
    return codes.index(code)


def _unknown(designation: str, word: str) -> Text:
    """What is said of a word that is of none of the forms."""
    allowed = Text(
        '"{word}" is no bearing that is known here; allowed are 60, 62, 63, NU or NJ with 10, 2, 3, 22 or 23, NA49 and '
        "RNA49 with a bore code of 02 to 12, HK with F_w and width, K25x30x20, and own",
        word=designation,
    )
    near = get_close_matches(word, _names(), n=1)
    return SPACE.join((allowed, Text("(the nearest is {name})", name=near[0]))) if near else allowed


@cache
def _names() -> tuple[str, ...]:
    return tuple(_designations())


def _designations() -> Iterator[str]:
    table = _table()
    forms = (*BALLS, *(form + series for form, series in product(("NU", "NJ"), ROLLERS)), "NA49", "RNA49")
    yield from (form + code for form, code in product(forms, table["bore_codes"]))
    cups = table["cups"]
    yield from (f"HK{F_w:.0f}{width:.0f}" for F_w, width in product(cups["raceway_mm"], cups["widths_mm"]))


# --- the table


def _table() -> TableRow:
    return house_table(FILE)


def _outline(series: str) -> Mapping[str, list[float]]:
    row: Mapping[str, list[float]] = _table()["outline"][series]
    return row


def _bore(at: int) -> Metre:
    return _mm(_table()["bores_mm"][at])


def _mm(shown: float) -> Metre:
    return UNITS["mm"].inside(shown)


@cache
def _usual(kind: str) -> Usual:
    row = _table()["inside"][kind]
    return Usual(**{key: number for key, number in row.items() if key not in ("source", "confidence")})
