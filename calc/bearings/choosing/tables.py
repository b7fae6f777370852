# SPDX-License-Identifier: Apache-2.0
"""What was found, as tables, and the keys that put a row into a design file."""

import json

from ...sheet.number import short
from ...sheet.step import Table
from ..inputs import BearingsInputs
from .neighbours import neighbours, outside
from .ranking import Pick, Row
from .room import short_mm
from .search import Found
from .settling import fits_to_write, writes_clearance
from .variants import PLACES

EXPLAINED = 3  # rows whose neighbours are shown
LETTERS = dict(zip(PLACES, "FR"))
EXPLAIN = (
    "F front, R rear bearing: l length, g diametral clearance, d diameter. P_f: friction power of both. h_edge, h_2F: thinner film of both "
    "at the edge, and at twice the load. rise: of the oil. ZN/P: McKee's number, cP·rpm/psi; it binds nothing (150 is advice). margin: the "
    "least of all rules, and by which."
)
RULES = {
    "film_edge": "h_edge", "film_edge_trumpler": "h_edge T", "film_double_load": "h_2F", "temperature": "outlet",
    "temperature_rise": "rise", "specific_load": "p", "heat_index": "heat", "length_ratio": "l/d", "length_ratio_usual": "l/d",
    "transition": "speed",
    "clearance_cold": "cold g", "clearance_cold_corner": "cold g",
}  # fmt: skip
CORNERS = {"smallest journal, largest seat": "widest fit", "largest journal, smallest seat": "tightest fit"}

Cells = tuple[str | float | None, ...]


def titles(found: Found) -> tuple[str, str]:
    """Of the rows that fit, and of those that are too long."""
    known = any(some[0].room.longest is not None for some in found.tasks.values())
    fit = "Bearings that fit and keep every rule" if known else "Bearings that keep every rule (their room is not known)"
    of = {
        "all": fit + ": the nearest, then the least power of each oil and supply",
        "fits": fit + f" with closer fits, {'/'.join(found.rows[0].variant.fits or ())}" if found.rows else fit,
        "given": "No bearing that fits keeps every rule: these keep every limit as given, not at every corner",
        "none": "No bearing fits: those that keep every rule are too long for their room",
    }[found.kind]
    if found.crossing:
        brief = {"all": fit, "fits": fit + " with closer fits", "given": "Those that fit keep the limits only as given"}
        of = f"The design FAILS {found.crossing[0].id}. {brief.get(found.kind, 'No bearing fits')}"
    return of, "Bearings that keep every rule and are too long for their room"


def choices_table(found: Found, top: int) -> Table:
    """The design as it is, then the first `top` rows; where none fits, those that are too long."""
    first = titles(found)[0]
    if not found.rows:
        return _rows_table("bearings", first, found, found.beyond[:top], 1, now=True)
    return _rows_table("bearings", first, found, found.rows[:top], 1, now=True)


def beyond_table(found: Found, top: int) -> Table | None:
    """Rows that are too long for the room, numbered on, so many that `top` are shown in all."""
    shown = found.beyond[: max(top - len(found.rows), 0)] if found.rows else ()
    return _rows_table("too_long", titles(found)[1], found, shown, len(found.rows) + 1, now=False) if shown else None


def _rows_table(id: str, title: str, found: Found, rows: tuple[Row, ...], first: int, *, now: bool) -> Table:
    shown = [("now", found.now)] if now and found.now is not None else []
    shown += [(str(number), row) for number, row in enumerate(rows, first)]
    of = [row for _, row in shown]
    wide = any(one.diameter != one.task.diameter for row in of for one in row.both)
    columns = [("no.", ""), ("oil", ""), ("supply", ""), *_size_columns(wide)]
    columns += [("P_f", "W"), ("h_edge", "µm"), ("h_2F", "µm"), ("rise", "K"), ("ZN/P", ""), ("margin", "%"), ("by", "")]
    extra = _extra(of)
    if wide and extra:
        columns.remove(("ZN/P", ""))  # what binds nothing makes room
    if extra:
        columns.append((extra, "mm" if extra == "too long" else ""))
    return Table(id, title, tuple(columns), tuple(_cells(number, row, wide, extra) for number, row in shown), EXPLAIN if now else "")


def _extra(rows: list[Row]) -> str:
    """What has to be said of some row beside its sizes."""
    return "too long" if any(any(row.too_long) for row in rows) else "asks for" if any(map(_asks, rows)) else ""


def _size_columns(wide: bool) -> list[tuple[str, str]]:
    return [column for letter in LETTERS.values() for column in ((f"{letter} d×l" if wide else f"{letter} l", "mm"), (f"{letter} g", "µm"))]


def _sizes(row: Row, wide: bool) -> Cells:
    cells: list[str | float | None] = []
    for one in row.both:
        cells.append(f"{short_mm(one.diameter)}×{short_mm(one.length)}" if wide else _rounded(one.length * 1e3, 4))
        cells.append(_rounded(one.clearance * 1e6, 3))
    return tuple(cells)


def _cells(number: str, row: Row, wide: bool, extra: str) -> Cells:
    worse = min(row.both, key=lambda one: one.margin)
    numbers = (row.power, row.film * 1e6, min(one.film_double_load for one in row.both) * 1e6, max(one.rise for one in row.both))
    mckee = () if wide and extra else (min(one.mckee for one in row.both),)
    marks = (*mckee, round(worse.margin * 100, 1))
    by = f"{RULES[worse.governing.id.rsplit('.', 1)[1]]} {LETTERS[PLACES[row.both.index(worse)]]}"
    cells: Cells = (number, row.variant.oil, row.variant.supply, *_sizes(row, wide))
    cells = (*cells, _rounded(row.power, 4), *(_rounded(x, 3) for x in (*numbers[1:], *marks)), by)
    if extra == "too long":
        return (*cells, " ".join(f"{letter} {x * 1e3:.1f}" for letter, x in zip(LETTERS.values(), row.too_long) if x > 0))
    return (*cells, _asks(row)) if extra else cells


def _asks(row: Row) -> str:
    """Smoother surfaces and closer fits that a row needs."""
    words = []
    for letter, one in zip(LETTERS.values(), row.both):
        if one.task.level:
            b = one.task.seat.bearing
            words.append(f"{letter} Ra {short(b.journal_roughness * 1e6)}/{short(b.housing_roughness * 1e6)}")
    return ", ".join([*words, *(["/".join(row.variant.fits)] if row.variant.fits else [])])


def _rounded(number: float, digits: int = 6) -> float | None:
    return float(f"{number:.{digits}g}") if abs(number) < float("inf") else None


def changed(row: Row) -> str:
    """`front length 27.5 → 31 mm, rear clearance 90 → 80 µm`; empty where nothing changes but oil and supply."""
    words = []
    for place, one in zip(PLACES, row.both):
        own = one.task
        for what, now, to, factor, unit in (
            ("diameter", own.diameter, one.diameter, 1e-3, "mm"), ("length", own.length, one.length, 1e-3, "mm"),
            ("clearance", own.clearance, one.clearance, 1e-6, "µm"),
        ):  # fmt: skip
            if abs(to - now) > 1e-9 * now:
                words.append(f"{place} {what} {short(now / factor)} → {short(to / factor)} {unit}")
        if own.level:
            b = own.seat.bearing
            words.append(f"{place} Ra {short(b.journal_roughness * 1e6)} µm (journal), {short(b.housing_roughness * 1e6)} µm (seat)")
    if row.variant.fits:
        words.append(f"fits {'/'.join(row.variant.fits)}")
    return ", ".join(words)


def neighbours_table(found: Found) -> Table:
    """For the first rows: what lies one step outside, and why it is not offered."""
    shown = (found.rows or found.beyond)[:EXPLAINED]
    rows: list[Cells] = []
    for number, row in enumerate(shown, 1):
        for one in neighbours(row, found.tasks, found.variants, found.slopes_of_row(number)):
            c = one.instead.governing
            if one.instead.margin < 0:
                digits = 4 if f"≥ {short(c.value)} {c.unit}" != c.limit_text() else 6  # a miss that four digits would hide
                value = f"{short(c.value, digits)} {c.unit}".rstrip() if c.value == c.value else "no film"
                rule = c.id.rsplit(".", 1)[1]
                rows.append((str(number), one.place, _brief(one.change), rule, value, c.limit_text(), _corner(one.instead)))
                continue
            bound = outside(one)
            words = f"passes, {abs(one.more):.2g} W {'more' if one.more >= 0 else 'less'}"
            wanted = (one.oil, row.variant.supply)
            same = (n for n, other in enumerate(found.rows, 1) if (other.variant.oil, other.variant.supply) == wanted)
            words += f" (row {n})" if (n := next(same, 0)) else ""
            rows.append((str(number), one.place, _brief(one.change), "end of the search" if bound else "", words, bound, ""))
    columns = (("no.", ""), ("bearing", ""), ("one step", ""), ("stopped by", ""), ("value", ""), ("needs", ""), ("corner", ""))
    note = (
        "One thing changed at a time. A step that passes is not offered where it costs power, or goes further from the design, or past the "
        "end of the search; with a thinner oil other sizes are better still: see its row."
    )
    return Table("neighbours", f"The neighbours of the first {len(shown)} rows", columns, tuple(rows), note)


def _brief(change: str) -> str:
    """With the letters of the first table."""
    return change.replace("length ", "l ").replace("clearance ", "g ").replace("diameter ", "d ")


def _corner(one: Pick) -> str:
    words = one.corner
    for long, brief in CORNERS.items():
        words = words.replace(long, brief)
    return words


def pareto_table(found: Found) -> Table:
    """More film for more power: numbered on from the rows, so that these can be taken as well."""
    wide = any(one.diameter != one.task.diameter for row in found.pareto for one in row.both)
    columns = [("no.", ""), ("oil", ""), ("supply", ""), *_size_columns(wide), ("P_f", "W"), ("h_edge", "µm")]
    extra = _extra(list(found.pareto))
    if extra:
        columns.append((extra, "mm" if extra == "too long" else ""))
    rows = []
    for number, row in enumerate(found.pareto, len(found.rows) + len(found.beyond) + 1):
        full = _cells(str(number), row, wide, extra)
        rows.append((*full[:7], _rounded(row.power, 4), _rounded(row.film * 1e6, 3), *(full[-1:] if extra else ())))
    note = "h_edge: the thinner of both. Between two rows lies no candidate with less power for its film."
    title = "Pareto set: power against film"
    if not found.rows:
        title += ", whatever the room"
    elif found.kind == "given":
        title += ", of those that keep every limit as given"
    return Table("pareto", title, tuple(columns), tuple(rows), note)


def changes(row: Row, own: BearingsInputs) -> list[str]:
    """The keys that put a row into a design with these bearings, as KEY=VALUE; a clearance that stays keeps its key."""
    words = []
    for place, one in zip(PLACES, row.both):
        at = f"bearings.{place}"
        if one.diameter != one.task.diameter:
            words.append(f"{at}.diameter_mm={_number(one.diameter, 1e-3)}")
        if one.length != one.task.length:
            words.append(f"{at}.length_mm={_number(one.length, 1e-3)}")
        if writes_clearance(one, row, own):
            words += [f"{at}.clearance_factor=", f"{at}.clearance_um={_number(one.clearance, 1e-6)}"]
        if one.task.level:
            b = one.task.seat.bearing
            words.append(f"{at}.journal_roughness_um={_number(b.journal_roughness, 1e-6)}")
            words.append(f"{at}.housing_roughness_um={_number(b.housing_roughness, 1e-6)}")
    for key, fit in zip(("journal_fit", "seat_fit"), fits_to_write(row, own) or ()):
        words.append(f"bearings.{key}={json.dumps(fit)}")
    if row.variant.oil != own.oil:
        words.append(f"bearings.oil={json.dumps(row.variant.oil, ensure_ascii=False)}")
    if row.variant.supply != own.supply:
        words.append(f"bearings.supply={json.dumps(row.variant.supply)}")
    return words


def _number(inside: float, factor: float) -> str:
    return repr(float(f"{inside / factor:.9g}"))
