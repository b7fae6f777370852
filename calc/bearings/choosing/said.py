# SPDX-License-Identifier: Apache-2.0
"""What is said about the rows: two or three lines before the tables, a list behind them."""

from dataclasses import replace

from ...sheet.number import short
from .grid import SAME, USUAL_FACTORS, widest_usual
from .ranking import Row, picks
from .room import short_mm
from .search import Found
from .settling import said
from .states import ROUGHNESSES
from .tables import changed
from .variants import DIAMETERS, PLACES

RULES = (
    "{rows}, at the worst corner of the tolerances: the film at the edge by Kreisle and by Trumpler, Trumpler's film at twice the "
    "load, outlet temperature, a rise of 15 K, specific load, heat index, l/d within its limits and the usual ones, the speed above "
    "mixed friction, and 20 µm of clearance at the lowest temperature."
)
AS_GIVEN = (
    "{rows} keep all that as given, and at the corners of the tolerances, which are only assumed, some clearance when cold; the other "
    "checks at the corners may warn. With fits given in the design they would fail."
)


def summary(found: Found) -> tuple[str, ...]:
    """What fails now, what nearest is, and by how much the room is missed."""
    words = [f"The design as it is FAILS {c.id}: {said(c)}." for c in found.crossing]
    if found.kind in ("given", "none"):
        words.append(_missed(found))
    if not found.rows:
        return tuple(words)
    first = found.rows[0]
    if first.what != "nearest":
        why = next((why for v, why in found.refused if v is found.variants[0]), "; ".join(found.dropped) or "no film")
        return (*words, f"No row has the design's own oil and supply: {why}.")
    own = found.variants[0]
    change = ", ".join(
        part for part in (
            f"oil {first.variant.oil}" if first.variant.oil != own.oil else "",
            f"supply by {first.variant.supply}" if first.variant.supply != own.supply else "", changed(first),
        ) if part
    )  # fmt: skip
    if change:
        words.append(f"Row 1 is nearest to the design: {change}." + (_at_corners(found, first) if found.kind == "given" else ""))
    else:
        words.append("Row 1 is the design as it is: it keeps every rule" + (" as given." if found.kind == "given" else "."))
    return tuple(words)


def _missed(found: Found) -> str:
    """Which journal has how much room, and by how much the nearest is too long."""
    tried = f"not with Ra down to {short(ROUGHNESSES[-1] * 1e6)} µm, nor with fits two grades closer"
    rooms = {place: found.tasks[place][0].room.longest for place in PLACES}
    if not found.beyond:
        return f"Nothing of any length keeps every rule, {tried}."
    row, number = found.beyond[0], len(found.rows) + 1
    places = [place for place, x in zip(PLACES, row.too_long) if x > 0]
    room = " and ".join(f"the {place} journal has room for {short_mm(rooms[place] or 0.0)} mm" for place in places)
    miss = " and ".join(f"{short_mm(x)} mm ({place})" for place, x in zip(PLACES, row.too_long) if x > 0)
    return f"Nothing that fits keeps every rule: {room}, and the nearest that does (row {number}) is {miss} too long; {tried}."


def _at_corners(found: Found, row: Row) -> str:
    """The worst corner of a row that is judged as given."""
    slopes = found.slopes_of_row(1)
    there = [picks(replace(one.task, corners=True), [one.length], [one.clearance], slopes[p])[0] for p, one in zip(PLACES, row.both)]
    below = [c for one in there for c in one.checks if c.margin < 0 and not c.id.endswith("clearance_cold")]
    return f" Below at a corner: {'; '.join(map(said, below))}." if below else ""


def notes(found: Found) -> tuple[str, ...]:
    """A list: what is kept, the room, what was looked at, what else fails, and what was refused."""
    made = [RULES.format(rows="Every row keeps")]
    if found.kind == "given":
        n, last, end = len(found.rows), len(found.rows) + len(found.beyond), len(found.all)
        first = f"Rows {n + 1} to {last} keep" if found.beyond else "To keep would be"
        pareto = f" and {last + 1} to {end}" if found.pareto else ""
        made = [RULES.format(rows=first), AS_GIVEN.format(rows=f"Rows 1 to {n}{pareto}")]
    for place in PLACES:
        room = found.tasks[place][0].room
        if room.longest is None:
            made.append(f"Room of the {place} journal: {room.why}.")
        else:
            made.append(f"Room of the {place} journal: {short_mm(room.longest)} mm; {room.why}.")
    if found.beyond:
        made.append(
            "A journal that is too long asks for sectors that give way: their masses moved, a shorter half_length_mm, or the true shape as "
            "[[countershaft.sections]]. Of these rows each is the shortest of its oil and supply; until the shaft gives way, "
            "countershaft.crossing fails with them."
        )
    made += found.diameters
    if any(len(some) > 1 for some in found.tasks.values()):
        made.append(
            f"Diameters stand {', '.join(f'{share * 100:+.0f}' for share in DIAMETERS).replace('-', '−')} % beside the design's; another "
            "supply takes the one that needs least power with the design's own supply and the same oil, and the design's."
        )
    made.append(
        f"Lengths stand on half millimetres, clearances on 5 µm up to those of the factor K = {USUAL_FACTORS[1]:g} (the greatest that is "
        "usual; the step's advice on the relative clearance, clearance_usual, may warn before), and the design's own beside them. Powers "
        "within 0.1 W are taken as alike: the smaller change goes first."
    )
    beyond = [p for p in PLACES if any(one.clearance > widest_usual(one.task) + SAME for one in (getattr(r, p) for r in found.rows))]
    if beyond:
        where = " and ".join(beyond)
        made.append(f"Some clearances of the {where} bearing are wider than K = {USUAL_FACTORS[1]:g} makes them, for the cold or the heat.")
    if found.placed:
        made.append(
            "The design's fits have a place and so make the clearance: a row with another one takes their widths alone (IT7 for f7)."
        )
    if found.verified:
        made.append(f"Rows 1 to {found.verified} are solved as whole designs; the others when they are taken.")
    made += [_elsewhere(found, id) for id in dict.fromkeys(c.id for checks in found.elsewhere.values() for c in checks)]
    if found.dropped:
        made.append(f"Dropped once the whole design was solved: {'; '.join(found.dropped)}.")
    return (*made, *_refused(found))


def _refused(found: Found) -> list[str]:
    """Oils without a row: each with its reason by the design's supply, by another the thickest one's."""
    made = []
    for supply in dict.fromkeys(v.supply for v, _ in found.refused):
        rows = [(v.oil, why) for v, why in found.refused if v.supply == supply]
        if supply == found.variants[0].supply:
            made.append(f"Without a row by {supply}: {'; '.join(f'{oil} ({why})' for oil, why in rows)}.")
        else:
            made.append(f"Without a row by {supply}: {', '.join(oil for oil, _ in rows)} ({rows[0][0]}: {rows[0][1]}).")
    return made


def _elsewhere(found: Found, id: str) -> str:
    """With which of the solved rows a limit of another step fails, and by how much with the first."""
    there = {number: c for number, checks in found.elsewhere.items() for c in checks if c.id == id}
    first = next(iter(there.values()))
    return f"Another step then fails, with row {', '.join(map(str, there))}: {id} ({said(first)})."


def hidden(found: Found, top: int) -> str:
    """Which rows are not shown, and how to see them."""
    last = len(found.rows) + len(found.beyond)
    if top >= last:
        return ""
    words = f"Rows {top + 1} to {last}: --top {last}"
    beyond = max(top, len(found.rows)) + 1
    return words + (f" (from {beyond} on too long for their room)." if found.rows and found.beyond else ".")
