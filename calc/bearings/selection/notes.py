# SPDX-License-Identifier: Apache-2.0
"""What is said about the rows: two or three lines before the tables, a list behind them."""

from collections.abc import Iterator
from dataclasses import replace

from ...library.journal_rules import RISE
from ...sheet.text import COMMA, EMPTY, SEMICOLON, Amount, Text, listed, plural
from .grid import SAME, USUAL_FACTORS, widest_usual
from .ranking import Row, picks
from .rules import LEAST_COLD
from .search import Found
from .states import ROUGHNESSES
from .tables import changed
from .variants import DIAMETERS, SUPPLY, tied
from .words import PLACE, PLACES, against, mm, short_mm


def summary(found: Found) -> tuple[Text, ...]:
    """What fails now, what nearest is, and by how much the room is missed."""
    words = [Text("The design as it is FAILS {id}: {limit}.", id=c.id, limit=against(c)) for c in found.crossing]
    if found.kind in ("given", "none"):
        words.append(_missed(found))
    if not found.rows:
        return tuple(words)
    first, own = found.rows[0], found.variants[0]
    if first.what != "nearest":
        why = next((why for v, why in found.refused if v is own), SEMICOLON.join(found.dropped) or Text("no film"))
        return (*words, Text("No row has the design's own oil and supply: {why}.", why=why))
    change = [
        Text("oil {oil}", oil=first.variant.oil) if first.variant.oil != own.oil else EMPTY,
        Text("supply by {supply}", supply=SUPPLY[first.variant.supply]) if first.variant.supply != own.supply else EMPTY, changed(first),
    ]  # fmt: skip
    if any(change):
        nearest = Text("Row 1 is nearest to the design: {change}.", change=COMMA.join(filter(None, change)))
        words.append(nearest + (_at_corners(found, first) if found.kind == "given" else EMPTY))
    elif found.kind == "given":
        words.append(Text("Row 1 is the design as it is: it keeps every limit as given."))
    else:
        words.append(Text("Row 1 is the design as it is: it keeps every limit."))
    return tuple(words)


def _missed(found: Found) -> Text:
    """Which journal has how much room, and by how much the nearest is too long."""
    Ra = Amount(ROUGHNESSES[-1] * 1e6, "µm")
    if not found.beyond:
        return Text("Nothing of any length keeps every limit, not with Ra down to {Ra}, nor with fits two grades closer.", Ra=Ra)
    row, number = found.beyond[0], len(found.rows) + 1
    long = [(place, x) for place, x in zip(PLACES, row.too_long) if x > 0]
    rooms = [
        Text("the {place} journal has room for {room}", place=PLACE[place], room=mm(found.tasks[place][0].room.longest or 0.0))
        for place, _ in long
    ]
    return Text(
        "Nothing that fits keeps every limit: {room}, and the nearest that does (row {number}) is {miss} too long; not with Ra down to "
        "{Ra}, nor with fits two grades closer.",
        room=listed(rooms), number=number, miss=listed(Text("{x} ({place})", x=mm(x), place=PLACE[place]) for place, x in long), Ra=Ra,
    )  # fmt: skip


def _at_corners(found: Found, row: Row) -> Text:
    """The worst corner of a row that is judged as given."""
    slopes = found.slopes_of_row(1)
    there = [picks(replace(one.task, corners=True), [one.length], [one.clearance], slopes[p])[0] for p, one in zip(PLACES, row.both)]
    below = [c for one in there for c in one.checks if c.margin < 0 and not c.id.endswith("clearance_cold")]
    return Text(" Below at a corner: {limits}.", limits=SEMICOLON.join(map(against, below))) if below else EMPTY


def notes(found: Found) -> tuple[Text, ...]:
    """A list: what is kept, the room, what was looked at, what else fails, and what was refused."""
    return (*_kept(found), *_rooms(found), *_diameters(found), *_searched(found), *_refused(found))


def _kept(found: Found) -> Iterator[Text]:
    n, last, end = len(found.rows), len(found.rows) + len(found.beyond), len(found.all)
    rows = Text("Every row keeps")
    if found.kind == "given":
        rows = Text("Rows {a} to {b} keep", a=n + 1, b=last) if found.beyond else Text("To keep would be")
    yield Text(
        "{rows}, at the worst corner of the tolerances: the film at the edge by Kreisle and by Trumpler, Trumpler's film at twice the "
        "load, outlet temperature, a rise of {rise}, specific load, heat index, l/d within its limits and the usual ones, the speed above "
        "mixed friction, and {cold} of clearance at the lowest temperature.",
        rows=rows, rise=Amount(RISE[0], "K"), cold=Amount(LEAST_COLD * 1e6, "µm"))  # fmt: skip
    if found.kind == "given":
        rows = Text("Rows 1 to {n} and {a} to {b}", n=n, a=last + 1, b=end) if found.pareto else Text("Rows 1 to {n}", n=n)
        yield Text(
            "{rows} keep all that as given, and at the corners of the tolerances, which are only assumed, some clearance when cold; the "
            "other checks at the corners may warn. With fits given in the design they would fail.",
            rows=rows,
        )


def _rooms(found: Found) -> Iterator[Text]:
    for place in PLACES:
        room = found.tasks[place][0].room
        if room.longest is None:
            yield Text("Room of the {place} journal: {why}.", place=PLACE[place], why=room.why)
        else:
            yield Text("Room of the {place} journal: {room}; {why}.", place=PLACE[place], room=mm(room.longest), why=room.why)
    if found.beyond:
        yield Text(
            "A journal that is too long asks for sectors that give way: their masses moved, a shorter half_length_mm, or the true shape as "
            "[[countershaft.sections]]. Of these rows each is the shortest of its oil and supply; until the shaft gives way, "
            "countershaft.crossing fails with them."
        )


def _diameters(found: Found) -> Iterator[Text]:
    """What ties them, or which were looked at, and where the best row stands at their end."""
    for n, place in enumerate(PLACES):
        if len(found.tasks[place]) == 1:
            why = tied(found.case, place) or Text("no other has an answer")
            yield Text("The {place} diameter stays as it is: {why}.", place=PLACE[place], why=why)
            continue
        looked = sorted(task.seat.bearing.diameter for task in found.tasks[place])
        free = Text("The {place} diameter is free: {diameters} mm are looked at, nothing between.", place=PLACE[place],
            diameters=COMMA.join(Text("{d}", d=short_mm(d)) for d in looked))  # fmt: skip
        ends = {row.both[n].diameter for row in found.rows[:2]} & {looked[0], looked[-1]}
        yield free + (Text(" {d}, in the first rows, is the end of it: beyond may be better.", d=mm(ends.pop())) if ends else EMPTY)
    if any(len(some) > 1 for some in found.tasks.values()):
        shares = COMMA.join(Text("{share}", share=Amount(share * 100, form="+.0f")) for share in DIAMETERS)
        yield Text(
            "Diameters stand {shares} % beside the design's; another supply takes the one that needs least power with the design's own "
            "supply and the same oil, and the design's.",
            shares=shares,
        )


def _searched(found: Found) -> Iterator[Text]:
    K = USUAL_FACTORS[1]
    yield Text(
        "Lengths stand on half millimetres, clearances on 5 µm up to those of the factor K = {K} (the greatest that is usual), and the "
        "design's own beside them. Powers within 0.1 W are taken as alike: the smaller change goes first.",
        K=K,
    )
    beyond = [PLACE[p] for p in PLACES if any(one.clearance > widest_usual(one.task) + SAME for one in (getattr(r, p) for r in found.rows))]
    if beyond:
        where = listed(beyond)
        yield Text(
            "Some clearances of the {places} bearing are wider than K = {K} makes them, for the cold or the heat.", places=where, K=K
        )
    unusual = {n: c for n, row in enumerate(found.all, 1) for one in row.both if (c := one.unusual) is not None}
    if unusual:
        yield Text(
            "The relative clearance of the application, {limit} (clearance_usual), goes before a wider one. Not kept, since film, heat and "
            "cold clearance leave nothing so narrow, or for less power in the Pareto set: {rows}.",
            limit=next(iter(unusual.values())).limit_text(), rows=rows_of(list(unusual)))  # fmt: skip
    if found.placed:
        yield Text(
            "The design's fits have a place and so make the clearance: a row with another one takes their widths alone (IT7 for f7)."
        )
    if found.verified:
        yield Text("Rows 1 to {n} are solved as whole designs; the others when they are taken.", n=found.verified)
    for id in dict.fromkeys(c.id for checks in found.elsewhere.values() for c in checks):
        there = {number: c for number, checks in found.elsewhere.items() for c in checks if c.id == id}
        numbers, first = COMMA.join(map(str, there)), next(iter(there.values()))
        yield Text("Another step then fails, with row {rows}: {id} ({limit}).", rows=numbers, id=id, limit=against(first))
    if found.dropped:
        yield Text("Dropped once the whole design was solved: {rows}.", rows=SEMICOLON.join(found.dropped))


def rows_of(numbers: list[int]) -> Text:
    """`rows 1 to 4 and 7`."""
    runs: list[list[int]] = []
    for n in numbers:
        if runs and n == runs[-1][1] + 1:
            runs[-1][1] = n
        else:
            runs.append([n, n])
    parts = [Text("{a} to {b}", a=a, b=b) if a < b else str(a) for a, b in runs]
    return plural("row {rows}", "rows {rows}", n=len(numbers), rows=listed(parts))


def _refused(found: Found) -> Iterator[Text]:
    """Oils without a row: each with its reason by the design's supply, by another the thickest one's."""
    for supply in dict.fromkeys(v.supply for v, _ in found.refused):
        rows = [(v.oil, why) for v, why in found.refused if v.supply == supply]
        if supply == found.variants[0].supply:
            oils = SEMICOLON.join(Text("{oil} ({why})", oil=oil, why=why) for oil, why in rows)
        else:
            names = COMMA.join(oil for oil, _ in rows)
            oils = Text("{oils} ({oil}: {why})", oils=names, oil=rows[0][0], why=rows[0][1])
        yield Text("Without a row by {supply}: {oils}.", supply=SUPPLY[supply], oils=oils)


def hidden(found: Found, top: int) -> Text:
    """Which rows are not shown, and how to see them."""
    last = len(found.rows) + len(found.beyond)
    if top >= last:
        return EMPTY
    beyond = max(top, len(found.rows)) + 1
    if found.rows and found.beyond:
        return Text("Rows {a} to {b}: --top {b} (from {c} on too long for their room).", a=top + 1, b=last, c=beyond)
    return Text("Rows {a} to {b}: --top {b}.", a=top + 1, b=last)
