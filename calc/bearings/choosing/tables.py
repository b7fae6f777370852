# SPDX-License-Identifier: Apache-2.0
"""What was found, as tables, and the keys that put a row into a design file."""

import json

from ...sheet.number import short
from ...sheet.step import Table
from .grid import SAME, widest_usual
from .neighbours import neighbours
from .ranking import Pick, Row
from .search import Found, said
from .variants import PLACES

EXPLAINED = 3  # rows whose neighbours are shown
RULES = (
    "Every row keeps, at the worst corner of the tolerances: the film at the edge by Kreisle and by Trumpler, Trumpler's film at twice the "
    "load, outlet temperature, a rise of 15 K, specific load, heat index, l/d within its limits and the usual ones, the speed above "
    "mixed friction, and 20 µm of clearance at the lowest temperature. ZN/P is shown, and binds nothing (150 is advice)."
)
SIZES = (("l", "mm", "length", 1e-3), ("g", "µm", "clearance", 1e-6))
NUMBERS = (("h_edge", "µm", "film_edge", 1e-6), ("h_2F", "µm", "film_double_load", 1e-6))


def choices_table(found: Found, top: int) -> Table:
    """The design as it is, then the first `top` rows."""
    sizes = _sizes(found)
    columns = [("no.", ""), ("", ""), ("oil", ""), ("supply", "")]
    columns += [(f"{place} {label}", unit) for place in PLACES for label, unit, _, _ in sizes]
    columns += [("P_f", "W")] + [(f"{place} {label}", unit) for label, unit, _, _ in NUMBERS for place in PLACES]
    columns += [("rise", "K"), ("flow", "L/min"), ("ZN/P", ""), ("margin", "%"), ("of", "")]
    rows = [_cells("", row, sizes) for row in (found.now,) if row is not None]
    rows += [_cells(str(number), row, sizes) for number, row in enumerate(found.rows[:top], 1)]
    return Table(
        "bearings", "Bearings that keep every rule, the least power of each oil and supply", tuple(columns), tuple(rows), _note(found)
    )


def _sizes(found: Found) -> tuple[tuple[str, str, str, float], ...]:
    """Diameters are shown where one is changed."""
    changed_diameter = any(one.diameter != one.task.diameter for row in found.all for one in row.both)
    return (("d", "mm", "diameter", 1e-3), *SIZES) if changed_diameter else SIZES


def _cells(number: str, row: Row, sizes: tuple[tuple[str, str, str, float], ...]) -> tuple[str | float | None, ...]:
    worse = min(row.both, key=lambda one: one.margin)
    place = PLACES[row.both.index(worse)]
    cells: list[str | float | None] = [number, row.what, row.variant.oil, row.variant.supply]
    cells += [_rounded(getattr(one, name) / factor) for one in row.both for _, _, name, factor in sizes]
    cells += [_rounded(row.power, 4)] + [_rounded(getattr(one, name) / factor, 3) for _, _, name, factor in NUMBERS for one in row.both]
    cells += [_rounded(max(one.rise for one in row.both), 3), _rounded(sum(one.flow for one in row.both) * 6e4, 3)]
    cells += [_rounded(min(one.mckee for one in row.both), 3), _rounded(worse.margin * 100, 2)]
    return (*cells, f"{worse.governing.id.rsplit('.', 1)[1]}, {place}")


def _rounded(number: float, digits: int = 6) -> float | None:
    return float(f"{number:.{digits}g}") if abs(number) < float("inf") else None


def _note(found: Found) -> str:
    said_first = []
    if found.rows and found.rows[0].what == "nearest":
        change = changed(found.rows[0])
        said_first.append(f"1 is nearest to the design: {change}." if change else "1 is the design as it is: it keeps every rule.")
    else:
        mine = found.variants[0]
        why = next((why for v, why in found.refused if v is mine), "; ".join(found.dropped) or "no film")
        said_first.append(f"No row has the design's own oil and supply: {why}.")
    notes = [*said_first, RULES]
    for place in PLACES:
        task = found.tasks[place][0]
        if task.room.longest is None:
            notes.append(f"Room of the {place} journal: {task.room.why}.")
        elif task.room.binds:
            notes.append(f"Room of the {place} journal: up to {short(task.room.longest * 1e3)} mm, {task.room.why}.")
        elif any(getattr(row, place).length > task.room.longest + 1e-9 for row in found.rows):
            notes.append(
                f"The {place} journal has room for {short(task.room.longest * 1e3)} mm: {task.room.why}. A longer one asks for sectors "
                "that give way: their masses moved, or the true shape as [[countershaft.sections]]."
            )
    notes.append(f"Diameters: {found.diameters}")
    notes.append(
        "Lengths on half millimetres, clearances on 5 µm up to the usual factor K, and the design's own; other diameters with the design's "
        f"supply only. Rows 1 to {found.verified} are solved as whole designs; the others when they are taken."
    )
    beyond = [p for p in PLACES if any(one.clearance > widest_usual(one.task) + SAME for one in (getattr(r, p) for r in found.rows))]
    if beyond:
        where = " and ".join(beyond)
        notes.append(f"Some clearances of the {where} bearing are wider than the usual factor K makes them, for the cold or the heat.")
    notes += [_elsewhere(found, id) for id in dict.fromkeys(c.id for checks in found.elsewhere.values() for c in checks)]
    if found.dropped:
        notes.append(f"Dropped once the whole design was solved: {'; '.join(found.dropped)}.")
    notes += _refused(found)
    return " ".join(notes)


def _refused(found: Found) -> list[str]:
    """Oils without a row: each with its reason by the design's supply, by another the thickest one's."""
    notes = []
    for supply in dict.fromkeys(v.supply for v, _ in found.refused):
        rows = [(v.oil, why) for v, why in found.refused if v.supply == supply]
        if supply == found.variants[0].supply:
            notes.append(f"Without a row by {supply}: {'; '.join(f'{oil} ({why})' for oil, why in rows)}.")
        else:
            notes.append(f"Without a row by {supply}: {', '.join(oil for oil, _ in rows)} ({rows[0][0]}: {rows[0][1]}).")
    return notes


def _elsewhere(found: Found, id: str) -> str:
    """With which of the solved rows a limit of another step fails, and by how much with the first."""
    there = {number: c for number, checks in found.elsewhere.items() for c in checks if c.id == id}
    first = next(iter(there.values()))
    return f"Another step then fails, with row {', '.join(map(str, there))}: {id} ({said(first)})."


def changed(row: Row) -> str:
    """`front length 27.5 → 31 mm, rear clearance 90 → 80 µm`; empty where nothing changes."""
    words = []
    for place, one in zip(PLACES, row.both):
        own = one.task
        for what, now, to, factor, unit in (
            ("diameter", own.diameter, one.diameter, 1e-3, "mm"), ("length", own.length, one.length, 1e-3, "mm"),
            ("clearance", own.clearance, one.clearance, 1e-6, "µm"),
        ):  # fmt: skip
            if abs(to - now) > 1e-9 * now:
                words.append(f"{place} {what} {short(now / factor)} → {short(to / factor)} {unit}")
    return ", ".join(words)


def neighbours_table(found: Found) -> Table:
    """For the first rows: what lies one step outside, and why it is not offered."""
    rows: list[tuple[str | float | None, ...]] = []
    for number, row in enumerate(found.rows[:EXPLAINED], 1):
        for one in neighbours(row, found.tasks, found.variants, found.slopes_of_row(number)):
            c = one.instead.governing
            if one.instead.margin < 0:
                value = f"{short(c.value)} {c.unit}".rstrip() if c.value == c.value else "no film"
                rows.append((str(number), one.place, one.change, c.id.rsplit(".", 1)[1], value, c.limit_text(), one.instead.corner))
            else:
                more = one.instead.power - one.of.power
                words = f"keeps every rule: {abs(more):.2g} W {'more' if more >= 0 else 'less'}"
                words += ", beyond the usual clearance" if one.instead.clearance > widest_usual(one.of.task) + SAME else ""
                rows.append((str(number), one.place, one.change, "", words, "", ""))
    columns = (("no.", ""), ("bearing", ""), ("one step", ""), ("stopped by", ""), ("value", ""), ("needs", ""), ("corner", ""))
    note = "One thing changed at a time. A step that keeps every rule is not offered where it costs power, or goes further from the design."
    return Table("neighbours", f"The neighbours of the first {min(EXPLAINED, len(found.rows))} rows", columns, tuple(rows), note)


def pareto_table(found: Found) -> Table:
    """More film for more power: numbered on from the rows, so that these can be taken as well."""
    columns = [("no.", ""), ("oil", ""), ("supply", "")]
    sizes = _sizes(found)
    columns += [(f"{place} {label}", unit) for place in PLACES for label, unit, _, _ in sizes] + [("P_f", "W"), ("h_edge", "µm")]
    rows = []
    for number, row in enumerate(found.pareto, len(found.rows) + 1):
        cells = [_rounded(getattr(one, name) / factor) for one in row.both for _, _, name, factor in sizes]
        rows.append((str(number), row.variant.oil, row.variant.supply, *cells, _rounded(row.power, 4), _rounded(row.film * 1e6, 3)))
    note = "h_edge: the thinner of both, at the edge and the worst corner. Between two rows lies no candidate with less power for its film."
    return Table("pareto", "Pareto set: power against film", tuple(columns), tuple(rows), note)


def changes(row: Row, oil: str, supply: str) -> list[str]:
    """The keys that put a row into a design of this oil and supply, as KEY=VALUE; a clearance that stays keeps its key."""
    words = []
    for place, one in zip(PLACES, row.both):
        at = f"bearings.{place}"
        if one.diameter != one.task.diameter:
            words.append(f"{at}.diameter_mm={_number(one.diameter, 1e-3)}")
        if one.length != one.task.length:
            words.append(f"{at}.length_mm={_number(one.length, 1e-3)}")
        if _moved(one):
            words += [f"{at}.clearance_factor=", f"{at}.clearance_um={_number(one.clearance, 1e-6)}"]
    if row.variant.oil != oil:
        words.append(f"bearings.oil={json.dumps(row.variant.oil, ensure_ascii=False)}")
    if row.variant.supply != supply:
        words.append(f"bearings.supply={json.dumps(row.variant.supply)}")
    return words


def _moved(one: Pick) -> bool:
    """Whether the clearance has to be written: it changed, or the factor K would make another one of a new diameter."""
    return one.clearance != one.task.clearance or one.diameter != one.task.diameter


def _number(inside: float, factor: float) -> str:
    return repr(float(f"{inside / factor:.9g}"))
