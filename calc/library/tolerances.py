# SPDX-License-Identifier: Apache-2.0
"""Limits and fits by ISO 286, what H7, f7 or IT7 mean for a diameter, and balance quality grades by ISO 21940-11.

ISO 286 as far as journals and their seats use it.

A field with a place ("H7", "e8") lies where its letter says; "IT7" is a width alone and lies half above and half below
the given size. Range: up to 500 mm, IT1 to IT16, holes C to H and JS, shafts c to h and js; for the rings of rolling
bearings also holes K M N P R and shafts j k m n p r, which are tight.  The numbers are the published ones
(`tables/iso_286.toml`)."""

import re
from bisect import bisect_left
from functools import cache

from ..sheet.formula import formula
from ..sheet.record import record
from ..sheet.text import Text
from ..sheet.units import UNITS, Kilogram, KilogramMetre, Metre, MetrePerSecond, RadPerSecond
from .table_file import bad_table, parsed, text_of_table

FILE = "iso_286.toml"
SOURCE = Text(
    "ISO 286-1:2010, tables of standard tolerances and fundamental deviations (as reprinted in public tables)"
)
SHAFTS = ("c", "d", "e", "f", "g", "h", "js")
HOLES = ("C", "D", "E", "F", "G", "H", "JS")
# with the grades that ISO 286 gives them
TIGHT_SHAFTS = {
    "j": range(5, 7),
    "k": range(3, 14),
    "m": range(3, 10),
    "n": range(3, 10),
    "p": range(3, 11),
    "r": range(3, 11),
}
TIGHT_HOLES = {"K": range(3, 9), "M": range(3, 9), "N": range(3, 9), "P": range(3, 8), "R": range(3, 8)}
OFTEN_USED = range(4, 8)  # grades of a shaft k that begins above its nominal size
SMALL = 3.0  # mm: up to here tight holes mirror tight shafts; M6 from 250 to 315 mm is the one exception, 2 µm
GRADES = range(1, 17)
LARGEST = 500.0  # mm
COARSE_ABOVE = 1.0  # mm: up to here ISO 286 gives no IT14 and coarser
ALLOWED = {
    "": Text(
        'a class like "H7" (holes C to H, JS), "f7" (shafts c to h, js), or a width alone like "IT7"; IT1 to IT16'
    ),
    "shaft": Text('a shaft\'s class like "f7" (c to h, js), or a width alone like "IT7"; IT1 to IT16'),
    "hole": Text('a hole\'s class like "H7" (C to H, JS), or a width alone like "IT7"; IT1 to IT16'),
    "shaft in a ring": Text('a shaft\'s class like "js6" (c to h, js, j5, j6, k, m, n, p, r)'),
    "hole for a ring": Text('a hole\'s class like "N7" (C to H, JS; K, M, N up to IT8; P, R up to IT7)'),
}
TIGHT = {"shaft in a ring": (SHAFTS, TIGHT_SHAFTS), "hole for a ring": (HOLES, TIGHT_HOLES)}
_WORD = re.compile(r"([A-Za-z]{1,2})([1-9]\d?)")
_UM = 1e6


@record
class ToleranceField:
    """A tolerance field.  `letter` None: a width without a place."""

    letter: str | None
    grade: int

    def __str__(self) -> str:
        return f"{self.letter or 'IT'}{self.grade}"


def parse(text: str, of: str = "") -> ToleranceField:
    """The field that a word means.  `of`: "shaft" or "hole" where only one of them may stand; a width alone always may.
    "shaft in a ring", "hole for a ring": of a rolling bearing, whose fit may be tight and has a place.

    Raises ValueError with what was given and what is allowed.
    """
    match = _WORD.fullmatch(text.strip())
    if of in TIGHT:
        letters, tight = TIGHT[of]
        known = match is not None and int(match[2]) in tight.get(match[1], GRADES if match[1] in letters else ())
    else:
        letters = ("IT", *{"shaft": SHAFTS, "hole": HOLES}.get(of, SHAFTS + HOLES))
        known = match is not None and match[1] in letters and int(match[2]) in GRADES
    if match is None or not known:
        raise ValueError(f'"{text}" is no tolerance class that is known here; allowed: {ALLOWED[of]}')
    return ToleranceField(None if match[1] == "IT" else match[1], int(match[2]))


def problem(text: str, of: str = "") -> Text | None:
    """Why a word is no tolerance field, with what is allowed; None where it is one."""
    try:
        parse(text, of)
    except ValueError:
        return Text("must be {allowed}", allowed=ALLOWED[of])
    return None


def tolerance(grade: int, diameter: Metre) -> Metre:
    """The width of a grade at a diameter.  Raises ValueError outside the table."""
    return _tolerance_um(grade, diameter) / _UM


def deviations(field: ToleranceField, diameter: Metre) -> tuple[Metre, Metre]:
    """Lower and upper deviation from the nominal size; of a width alone, and of js and JS, half of it below and half
    above."""
    width = _tolerance_um(field.grade, diameter)
    letter = (field.letter or "js").lower()
    if letter == "js":
        return -width / 2 / _UM, width / 2 / _UM
    if letter == "j":
        below = _row("below_um", str(field))[_range(_row("", "up_to_mm"), diameter)]
        return -below / _UM, (width - below) / _UM
    if letter in TIGHT_SHAFTS:
        near = _above_um(letter, diameter)
        if field.letter == letter:
            near = near if letter != "k" or field.grade in OFTEN_USED else 0.0
            return near / _UM, (near + width) / _UM
        if UNITS["mm"].shown(diameter) > SMALL:  # so that N7 with h6 grips like H7 with n6
            near -= width - _tolerance_um(field.grade - 1, diameter)
        return -(near + width) / _UM, -near / _UM
    fine = ("fine", letter) in _lines()
    near = _row("fine" if fine else "distance_um", letter)[_range(_row("fine" if fine else "", "up_to_mm"), diameter)]
    if field.letter == letter:
        return -(near + width) / _UM, (-near if near else 0.0) / _UM
    return near / _UM, (near + width) / _UM


def _above_um(letter: str, diameter: Metre) -> float:
    """From the nominal size up to a tight shaft, of k one of the grades that are often used."""
    fine = ("fine_above_um", letter) in _lines()
    ends = _row("fine" if fine else "", "up_to_mm")
    return _row("fine_above_um" if fine else "above_um", letter)[_range(ends, diameter)]


def ends_of_ranges() -> list[float]:
    """The upper end [mm] of each range within which every field has the same deviations."""
    return _row("fine", "up_to_mm")


def clearance_limits(journal: ToleranceField, seat: ToleranceField, diameter: Metre) -> tuple[Metre, Metre]:
    """Least and greatest change of the clearance by both fields: least hole less largest shaft, and the other way
    round.

    Two widths alone: the band about the nominal clearance.  Two classes with a place on the same nominal size: the
    clearance itself."""
    smallest, largest, bore, widest = (
        round(end * _UM, 6) for field in (journal, seat) for end in deviations(field, diameter)
    )
    return (bore - largest) / _UM, (widest - smallest) / _UM


def _tolerance_um(grade: int, diameter: Metre) -> float:
    if grade not in GRADES:
        raise ValueError(f"IT{grade}: allowed are IT1 to IT16")
    at, shown = _range(_row("", "up_to_mm"), diameter), UNITS["mm"].shown(diameter)
    if grade >= 14 and shown <= COARSE_ABOVE:
        raise ValueError(f"IT{grade} at {shown:g} mm: ISO 286 has IT14 and coarser only above 1 mm")
    return _row("tolerance_um", f"IT{grade}")[at]


def _range(ends: list[float], diameter: Metre) -> int:
    """The range of a diameter, each up to and including its end."""
    shown = UNITS["mm"].shown(diameter)
    if not 0 < shown <= LARGEST:
        raise ValueError(f"{shown:g} mm: allowed are diameters above 0 and up to {LARGEST:g} mm")
    return bisect_left(ends, shown)


@cache
def _lines() -> dict[tuple[str, str], str]:
    """The lines of the table by their section and their name, not yet read."""
    lines, section = {}, ""
    for line in text_of_table(FILE).splitlines():
        name, equals, _ = line.partition(" = ")
        if line.startswith("["):
            section = line[1:].partition("]")[0]
        elif equals and not line.startswith("#"):
            lines[section, name] = line
    return lines


@cache
def _row(section: str, name: str) -> list[float]:
    if (line := _lines().get((section, name))) is None:
        raise bad_table(FILE, [(f"{section}.{name}", "", Text("is missing"))])
    row: list[float] = parsed(FILE, line)[name]
    return row


# --- balance quality grades of ISO 21940-11, and the residual unbalance that one permits a rigid rotor

ISO = Text("ISO 21940-11")
BALANCE_GRADES = ("G0.4", "G1", "G2.5", "G6.3", "G16", "G40", "G100", "G250", "G630", "G1600", "G4000")


@formula(
    "U_per", Text("{iso}: permissible residual unbalance, from G = e_per·ω", iso=ISO), unit="g·mm", names={"G": "G_Q"}
)
def permitted_unbalance(G: MetrePerSecond, m_S: Kilogram, omega: RadPerSecond) -> KilogramMetre:
    """>>> permitted_unbalance(G=0.0063, m_S=9.034, omega=272.3)
    0.0002090128...
    """
    return G * m_S / omega


@formula("G_Q", Text("{iso}: balance quality grade, e_per·ω", iso=ISO), shows="number of the grade, in mm/s")
def grade_number(grade: str) -> MetrePerSecond:
    """G of a grade: "G6.3" is 6.3 mm/s."""
    return float(grade[1:]) / 1000


# --- what the program takes where a file says nothing


class Assumed(str):
    """Words that the program takes where a file says nothing: equal to none that a file gives, though these may read
    the same."""

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Assumed) and str.__eq__(self, other)

    def __ne__(self, other: object) -> bool:
        return not self == other

    __hash__ = str.__hash__


ASSUMED_FIT = Assumed("IT7")  # of a journal or a seat
