# SPDX-License-Identifier: Apache-2.0
"""The rows of the search as tables, why not one step further, and what is said about them.

Each neighbour of a row has the rule that refuses it, or what it costs."""

import math
from collections.abc import Iterable, Iterator, Sequence

from ....countershaft.rows import called
from ....library.makers import journals
from ....sheet.check import Check, CheckRule
from ....sheet.number import short
from ....sheet.record import record, replace
from ....sheet.search import beside
from ....sheet.step import Table
from ....sheet.text import COMMA, EMPTY, SEMICOLON, Amount, Name, Text, listed, plural
from ....sheet.units import Watt
from ...result import BearingsResult
from ..checks import (
    CLEARANCE_COLD,
    CLEARANCE_COLD_CORNER,
    FILM_EDGE,
    FILM_EDGE_SHEARED,
    FILM_EDGE_SPLIT,
    FILM_OVERSPEED,
    FILM_PRESSURE,
    LENGTH_RATIO,
    SPECIFIC_LOAD,
    TEMPERATURE,
)
from ..suitability import MATERIAL_LOAD
from .grid import LENGTH_STEP, SAME, clearance_step
from .grid import WIDEST as WIDEST_CLEARANCE
from .ranking import CandidateRow, Pick, Slopes, picks
from .search import BearingsFound
from .states import (
    OUTLET_RESERVE,
    RATIO,
    ROUGHNESSES,
    TIGHT,
    TIGHTEST,
    WIDEST,
    against,
    letter_of,
    mm,
    short_mm,
    value_of,
)
from .variants import SUPPLY, Variant, thinner, tied

EXPLAINED = 3  # rows whose neighbours are shown
EXPLAIN = Text(
    "F front, R rear bearing: d×l journal, g diametral clearance. P_f: friction power of both. h/h_K: thinner film of "
    "both at the edge at the worst corner, over what their roughness asks for. T_out: hottest oil that leaves. margin: "
    "the least of all rules, and by which."
)
RULES: dict[CheckRule, Text] = {
    FILM_EDGE: Name("h_edge"),
    FILM_EDGE_SHEARED: Text("sheared"),
    FILM_EDGE_SPLIT: Text("split"),
    FILM_OVERSPEED: Text("overspeed"),
    TEMPERATURE: Text("outlet"),
    SPECIFIC_LOAD: Name("p"),
    MATERIAL_LOAD: Name("p"),
    FILM_PRESSURE: Name("p_max"),
    LENGTH_RATIO: Name("l/d"),
    CLEARANCE_COLD: Text("cold g"),
    CLEARANCE_COLD_CORNER: Text("cold g"),
}
CORNERS = {  # where the name is longer than a column can bear
    WIDEST: Text("widest fit, thinner oil"),
    TIGHTEST: Text("tightest fit, thinner oil"),
    TIGHT: Text("tightest fit, thicker oil"),
}
AIMS = {
    "loss": Text("the least friction first"),
    "size": Text("the smallest first"),
    "film": Text("the least friction for ever more film"),
}
NUMBER, TOO_LONG, ASKS = Text("no."), Text("too long"), Text("asks for")
OIL, SUPPLIED, PRESSED = Text("oil"), Text("supply"), Text("press hot")
POWER, EDGE, OUTLET = Name("P_f"), Name("h_edge"), Name("T_out")

Cells = tuple[str | float | None, ...]


def titles(choices: BearingsFound) -> tuple[Text, Text]:
    """Of the rows that fit, and of those that are too long."""
    known = any(some[0].room.longest is not None for some in choices.tasks.values())
    keeps = Text("Bearings that keep every rule of the search (their room is not known)")
    if known:
        keeps = Text("Bearings that fit and keep every rule of the search")
    of = {
        "all": Text("{keeps}: {aim}", keeps=keeps, aim=AIMS[choices.aim]),
        "given": Text("No bearing that fits keeps every rule of the search at every corner: these keep them as given"),
        "none": Text("No bearing fits: those that keep every rule are too long for their room"),
    }[choices.kind]
    if choices.crossing:
        fail = choices.crossing[0].id
        of = {
            "all": Text("The design FAILS {check}. {keeps}", check=fail, keeps=keeps),
            "given": Text("The design FAILS {check}. Those that fit keep its rules only as given", check=fail),
            "none": Text("The design FAILS {check}. No bearing fits", check=fail),
        }[choices.kind]
    return of, Text("Bearings that keep every rule of the search and are too long for their room")


def choices_table(choices: BearingsFound, top: int) -> Table:
    """The design as it is, then the first `top` rows; where none fits, those that are too long."""
    if choices.aim == "film" and choices.pareto:
        return pareto_table(choices)
    numbers = [n for n in range(1, len(choices.rows) + 1) if choices.no(n) <= top]
    if not choices.rows:
        numbers = [n for n, _ in enumerate(choices.beyond[:top], 1)]
    return _rows_table("bearings", titles(choices)[0], choices, numbers, now=True)


def beyond_table(choices: BearingsFound, top: int) -> Table | None:
    """Rows that are too long for the room, numbered on, so many that `top` are shown in all."""
    shown = choices.beyond[: max(top - len(choices.rows), 0)] if choices.rows else ()
    if not shown:
        return None
    numbers = [n for n, _ in enumerate(shown, len(choices.rows) + 1)]
    return _rows_table("too_long", titles(choices)[1], choices, numbers, now=False)


def _rows_table(id: str, title: Text, choices: BearingsFound, numbers: Sequence[int], *, now: bool) -> Table:
    """The rows of these numbers among all."""
    shown: list[tuple[str, CandidateRow]] = [(Text("now"), choices.now)] if now and choices.now is not None else []
    press = [_press_hot(choices, number) for number in (*(0 for _ in shown), *numbers)]
    shown += [(str(choices.no(number)), choices.all[number - 1]) for number in numbers]
    of = [row for _, row in shown]
    extra = _extra(of)
    columns = [(NUMBER, ""), (OIL, ""), (SUPPLIED, ""), *_size_columns(of)]
    columns += [(POWER, "W"), (Name("h/h_K"), ""), (OUTLET, "°C")]
    if any(press):
        columns.append((PRESSED, "MPa"))
    columns += [(Text("margin"), "%"), (Text("by"), "")]
    if extra:
        columns.append((extra, "mm" if extra == TOO_LONG else ""))
    cells = tuple(_cells(number, row, p if any(press) else -1.0, extra) for (number, row), p in zip(shown, press))
    return Table(id, title, tuple(columns), cells, EXPLAIN if now else EMPTY)


def _press_hot(choices: BearingsFound, number: int) -> float | None:
    """The least pressure of what is pressed in where the film is hottest, in MPa, of a row that was solved whole."""
    results = choices.solved.get(number) if number else choices.case.seen(choices.case.results)
    found = None if results is None else results.result(BearingsResult)
    seats = [] if found is None else [b.seat_ for b in found.plain.values() if b.seat_ is not None]
    return min((seat.press_hot / 1e6 for seat in seats), default=None)


def _extra(rows: list[CandidateRow]) -> Text:
    """What has to be said of some row beside its sizes."""
    return TOO_LONG if any(any(row.too_long) for row in rows) else ASKS if any(map(_asks, rows)) else EMPTY


def _size_columns(rows: Sequence[CandidateRow]) -> list[tuple[Text, str]]:
    columns: list[tuple[Text, str]] = []
    for pick in rows[0].picks if rows else ():
        letter = letter_of(pick.task.place)
        columns += [(Text("{letter} d×l", letter=letter), "mm"), (Text("{letter} g", letter=letter), "µm")]
    return columns


def _sizes(row: CandidateRow) -> Cells:
    cells: list[str | float | None] = []
    for pick in row.picks:
        cells.append(Text("{d}×{l}", d=short_mm(pick.diameter), l=short_mm(pick.length)))
        cells.append(rounded(pick.clearance * 1e6, 3))
    return tuple(cells)


def _cells(number: str, row: CandidateRow, press: float | None, extra: Text) -> Cells:
    """`press` below zero: no row has one."""
    worse = min(row.picks, key=lambda pick: pick.margin)
    numbers = (min(pick.film_edge / pick.film_asked for pick in row.picks), max(pick.outlet for pick in row.picks))
    of_press = () if press is not None and press < 0 else (None if press is None else rounded(press, 3),)
    by = Text("{rule} {letter}", rule=short_name(worse.governing), letter=letter_of(worse.task.place))
    cells: Cells = (*_first_cells(number, row), rounded(row.power, 4), *(rounded(x, 4) for x in numbers), *of_press)
    cells = (*cells, rounded(worse.margin * 100, 3), by)
    return (*cells, _too_long(row) if extra == TOO_LONG else _asks(row)) if extra else cells


def _first_cells(number: str, row: CandidateRow) -> Cells:
    return (number, row.variant.oil, SUPPLY[row.variant.supply], *_sizes(row))


def _too_long(row: CandidateRow) -> Text:
    return Text(" ").join(
        Text("{a} {b}", a=letter_of(pick.task.place), b=Amount(x * 1e3, form=".1f"))
        for pick, x in zip(row.picks, row.too_long)
        if x > 0
    )


def _asks(row: CandidateRow) -> Text:
    """Smoother surfaces and closer fits that a row needs."""
    words: list[str] = []
    for pick in row.picks:
        if pick.task.level:
            letter, b = letter_of(pick.task.place), pick.task.seat.bearing
            both = Amount(b.journal_roughness * 1e6), Amount(b.housing_roughness * 1e6)
            words.append(Text("{letter} Ra {journal}/{seat}", letter=letter, journal=both[0], seat=both[1]))
    return COMMA.join([*words, *(["/".join(row.variant.fits)] if row.variant.fits else [])])


def short_name(check: Check) -> Text:
    """Its word in a column, else its name."""
    return RULES.get(check.rule, check.name)


def rounded(number: float, digits: int = 6) -> float | None:
    return float(f"{number:.{digits}g}") if abs(number) < float("inf") else None


def changed(row: CandidateRow) -> Text:
    """`front length 27.5 → 31 mm, rear clearance 90 → 80 µm`; empty where nothing changes but oil and supply."""
    words: list[Text] = []
    for pick in row.picks:
        task, b, place = pick.task, pick.task.seat.bearing, pick.task.place
        for what, now, to, factor, unit in (
            (Text("diameter"), task.diameter, pick.diameter, 1e-3, "mm"),
            (Text("length"), task.length, pick.length, 1e-3, "mm"),
            (Text("clearance"), task.clearance, pick.clearance, 1e-6, "µm"),
        ):
            if abs(to - now) > 1e-9 * now:
                ends = Amount(now / factor), Amount(to / factor, unit)
                words.append(
                    Text("{place} {what} {now} → {to}", place=called(place), what=what, now=ends[0], to=ends[1])
                )
        if task.level:
            both = Amount(b.journal_roughness * 1e6, "µm"), Amount(b.housing_roughness * 1e6, "µm")
            words.append(
                Text(
                    "{place} Ra {journal} (journal), {seat} (seat)",
                    place=called(place),
                    journal=both[0],
                    seat=both[1],
                )
            )
    if row.variant.fits:
        words.append(Text("fits {fits}", fits="/".join(row.variant.fits)))
    return COMMA.join(words)


# --- why not one step further


@record
class Neighbour:
    """One bearing of a row with one thing changed, or both with another oil.  `more`: the power that it costs."""

    place: Text
    change: Text
    instead: Pick
    of: Pick
    more: Watt
    oil: str = ""


def neighbours(row: CandidateRow, variants: tuple[Variant, ...], slopes: Slopes) -> Iterator[Neighbour]:
    """Of each bearing: one step shorter, one tighter, one wider, and the next thinner oil; a step is the grid's."""
    for chosen in row.picks:
        l, g, place = chosen.length, chosen.clearance, chosen.task.place
        (shorter, _), step = beside(l, LENGTH_STEP), clearance_step(chosen.diameter)
        # clearances that limits of parts make are counted from the design's own
        tighter, wider = beside(g, step) if chosen.task.field is None else (g - step, g + step)
        steps = (
            (Text("l {now} → {to}", now=Amount(l * 1e3), to=Amount(shorter * 1e3, "mm")), shorter, g),
            (Text("g {now} → {to}", now=Amount(g * 1e6), to=Amount(tighter * 1e6, "µm")), l, tighter),
            (Text("g {now} → {to}", now=Amount(g * 1e6), to=Amount(wider * 1e6, "µm")), l, wider),
        )
        changes, lengths, clearances = zip(*(step for step in steps if min(step[1:]) > 0))
        for change, pick in zip(changes, picks(chosen.task, lengths, clearances, slopes[place])):
            yield Neighbour(called(place), change, pick, chosen, pick.power - chosen.power)
    oil = thinner(list(variants), replace(row.variant, fits=None), row.picks[0].task.duty.supply_temperature)
    if oil is not None:  # in both bearings, which share it; the worse of them says
        every = []
        for chosen in row.picks:
            task = chosen.task.with_oil(oil.lubricant, oil.supply)
            every.append((picks(task, [chosen.length], [chosen.clearance], slopes[task.place])[0], chosen))
        worse, of = min(every, key=lambda pair: pair[0].margin)
        more = sum(pick.power - chosen.power for pick, chosen in every)
        yield Neighbour(Text("both"), Text("oil {oil}", oil=oil.oil), worse, of, more, oil.oil)


def outside(neighbour: Neighbour) -> Text:
    """Which bound of the search the step passes; empty: none."""
    to, of = neighbour.instead, neighbour.of
    if neighbour.oil or to.clearance <= max(of.clearance, WIDEST_CLEARANCE * of.diameter + SAME):
        return EMPTY
    return Name(f"≤ {WIDEST_CLEARANCE * 1e3:g} ‰")


def neighbours_table(choices: BearingsFound) -> Table:
    """For the first rows: what lies one step outside, and why it is not offered."""
    shown = (choices.rows or choices.beyond)[:EXPLAINED]
    rows = [
        (str(choices.no(number)), neighbour.place, neighbour.change, *_outcome(choices, row, neighbour))
        for number, row in enumerate(shown, 1)
        for neighbour in neighbours(row, choices.variants, choices.slopes_of_row(number))
    ]
    columns = (
        NUMBER,
        Text("bearing"),
        Text("one step"),
        Text("stopped by"),
        Text("value"),
        Text("needs"),
        Text("corner"),
    )
    note = Text(
        "One thing changed at a time. A step that passes is not offered where it costs power, or goes further from "
        "the design, or past the "
        "end of the search; with a thinner oil other sizes are better still: see its row."
    )
    title = Text("The neighbours of the first {n} rows", n=len(shown))
    return Table("neighbours", title, tuple((label, "") for label in columns), tuple(rows), note)


def _outcome(choices: BearingsFound, row: CandidateRow, neighbour: Neighbour) -> Cells:
    """What stops it, the value, the limit and the corner; or what it costs, and which bound of the search it passes."""
    c = neighbour.instead.governing
    if neighbour.instead.margin < 0:
        digits = 4 if f"≥ {short(c.value)} {c.unit}" != c.limit_text() else 6  # a miss that four digits would hide
        corner = neighbour.instead.corner
        return short_name(c), value_of(c, digits), c.limit_text(), CORNERS.get(corner, corner)
    more = Amount(abs(neighbour.more), "W", form=".2g")
    words = Text("passes, {power} less", power=more)
    if neighbour.more >= 0:
        words = Text("passes, {power} more", power=more)
    wanted = (neighbour.oil, row.variant.supply)
    of_oil = (n for n, other in enumerate(choices.rows, 1) if (other.variant.oil, other.variant.supply) == wanted)
    if n := next(of_oil, 0):
        words = Text("{words} (row {n})", words=words, n=choices.no(n))
    bound = outside(neighbour)
    return (Text("end of the search") if bound else "", words, bound, "")


def pareto_table(choices: BearingsFound) -> Table:
    """More film for more power: numbered on from the rows, so that these can be taken as well."""
    extra = _extra(list(choices.pareto))
    columns = [
        (NUMBER, ""),
        (OIL, ""),
        (SUPPLIED, ""),
        *_size_columns(choices.pareto),
        (POWER, "W"),
        (EDGE, "µm"),
    ]
    columns += [(extra, "mm" if extra == TOO_LONG else "")] if extra else []
    rows = []
    for number, row in enumerate(choices.pareto, len(choices.rows) + len(choices.beyond) + 1):
        last = (_too_long(row) if extra == TOO_LONG else _asks(row),) if extra else ()
        rows.append(
            (*_first_cells(str(choices.no(number)), row), rounded(row.power, 4), rounded(row.film * 1e6, 3), *last)
        )
    note = Text("h_edge: the thinner of both. Between two rows lies no candidate with less power for its film.")
    title = Text("Pareto set: power against film")
    if not choices.rows:
        title = Text("Pareto set: power against film, whatever the room")
    elif choices.kind == "given":
        title = Text("Pareto set: power against film, of those that keep every rule as given")
    return Table("pareto", title, tuple(columns), tuple(rows), note)


# --- what is said about the rows
# Two or three lines before the tables, a list behind them.


def summary(choices: BearingsFound) -> tuple[Text, ...]:
    """What fails now, what the first row changes and saves, and by how much the room is missed."""
    words = [Text("The design as it is FAILS {id}: {limit}.", id=c.id, limit=against(c)) for c in choices.crossing]
    if choices.kind in ("given", "none"):
        words.append(_missed(choices))
    if not choices.rows:
        return tuple(words)
    first, own_variant, now = choices.rows[0], choices.variants[0], choices.now
    change = [
        Text("oil {oil}", oil=first.variant.oil) if first.variant.oil != own_variant.oil else EMPTY,
        Text("supply by {supply}", supply=SUPPLY[first.variant.supply])
        if first.variant.supply != own_variant.supply
        else EMPTY,
        changed(first),
    ]
    if any(change):
        power = Text("{power}", power=Amount(first.power, "W", digits=3))
        if now is not None:
            power = Text("{power} in place of {now}", power=power, now=Amount(now.power, "W", digits=3))
        words.append(
            Text("Row {n}: {change}; {power}.", n=choices.no(1), change=COMMA.join(filter(None, change)), power=power)
        )
        if choices.kind == "given":
            words.append(_at_corners(choices, first))
    elif choices.kind == "given":
        words.append(Text("Row {n} is the design as it is: it keeps every rule as given.", n=choices.no(1)))
    else:
        words.append(Text("Row {n} is the design as it is: it keeps every rule of the search.", n=choices.no(1)))
    if choices.own > 1:
        n = choices.no(choices.own)
        words.append(Text("With the design's own oil, supply and surfaces: row {n}.", n=n))
    elif not choices.own:
        dropped = SEMICOLON.join(choices.dropped) or Text("where the bearings stand, smoother surfaces are needed")
        why = next((why for v, why in choices.refused if v is own_variant), dropped)
        words.append(Text("No row has the design's own oil, supply and surfaces: {why}.", why=why))
    return tuple(filter(None, [*words, _makers(choices)]))


def _makers(choices: BearingsFound) -> Text:
    """Which row stands nearest to a journal that a maker prints for this assembly and ratio; empty where none does."""
    shaft = choices.case.shaft
    if shaft is None or shaft.assembly is None or not shaft.speed_ratio:
        return EMPTY
    printed = [one for one in journals(shaft.speed_ratio, shaft.assembly) if one.journal.diameter]
    near = [
        (abs(math.log(max(pick.diameter for pick in row.picks) / (one.journal.diameter or 1.0))), n, i)
        for n, row in enumerate(choices.rows, 1)
        for i, one in enumerate(printed)
    ]
    if not near:
        return EMPTY
    _, n, i = min(near)
    d = Amount(round((printed[i].journal.diameter or 0.0) * 1e3, 1), "mm")
    return Text(
        "Nearest to what makers print for this assembly stands row {n}: {engine}, {d}.",
        n=choices.no(n),
        engine=printed[i].sheet.name,
        d=d,
    )


def _missed(choices: BearingsFound) -> Text:
    """Which journal has how much room, and by how much the nearest is too long."""
    Ra = Amount(ROUGHNESSES[-1] * 1e6, "µm")
    if not choices.beyond:
        return Text(
            "Nothing of any length keeps every rule, not with Ra down to {Ra}, nor with fits two grades closer.", Ra=Ra
        )
    row, number = choices.beyond[0], len(choices.rows) + 1
    long = [(pick.task.place, x) for pick, x in zip(row.picks, row.too_long) if x > 0]
    spaces = [(place, mm(choices.tasks[place][0].room.longest or 0.0)) for place, _ in long]
    rooms = [Text("the {place} journal has room for {room}", place=called(p), room=space) for p, space in spaces]
    return Text(
        "Nothing that fits keeps every rule: {room}, and the nearest that does (row {number}) is {miss} too long; "
        "not with Ra down to "
        "{Ra}, nor with fits two grades closer.",
        room=listed(rooms),
        number=choices.no(number),
        miss=listed(Text("{x} ({place})", x=mm(x), place=called(place)) for place, x in long),
        Ra=Ra,
    )


def _at_corners(choices: BearingsFound, row: CandidateRow) -> Text:
    """The worst corner of a row that is judged as given."""
    slopes = choices.slopes_of_row(1)
    there = [
        picks(replace(pick.task, corners=True), [pick.length], [pick.clearance], slopes[pick.task.place])[0]
        for pick in row.picks
    ]
    below = [c for pick in there for c in pick.checks if c.margin < 0 and c.rule is not CLEARANCE_COLD]
    return Text("Below at a corner: {limits}.", limits=SEMICOLON.join(map(against, below))) if below else EMPTY


def notes(choices: BearingsFound) -> tuple[Text, ...]:
    """A list: what is kept, the room, what was looked at, what else fails, and what was refused."""
    return (*_kept(choices), *_rooms(choices), *_diameters(choices), *_searched(choices), *_refused(choices))


def _kept(choices: BearingsFound) -> Iterator[Text]:
    n, last, end = len(choices.rows), len(choices.rows) + len(choices.beyond), len(choices.all)
    rows = Text("Every plain row keeps") if choices.behind else Text("Every row keeps")
    if choices.kind == "given":
        rows = Text("To keep would be")
        if choices.beyond:
            rows = Text("Rows {a} to {b} keep", a=choices.no(n + 1), b=choices.no(last))
    yield Text(
        "{rows}, at the worst corner of the tolerances: the film at the edge, {reserve} below the limit of the oil "
        "that leaves, and a twentieth of the clearance at the lowest temperature; as given, the film at the edge "
        "with the oil thinned by shear, at overspeed and as the split of shells passes, what the seat carries, a slope "
        "of 0.25 mrad, and l/d from {least} to {most} where the diameter is free.",
        rows=rows,
        reserve=Amount(OUTLET_RESERVE, "K"),
        least=Amount(RATIO[0]),
        most=Amount(RATIO[1]),
    )
    if choices.kind == "given":
        numbers = [*range(1, n + 1), *range(last + 1, end + 1)]
        rows = Text("Rows {runs}", runs=_runs(choices.no(number) for number in numbers))
        yield Text(
            "{rows} keep all that as given, and at the corners of the tolerances, which are only assumed, some "
            "clearance when cold; the "
            "other checks at the corners may warn. With fits given in the design they would fail.",
            rows=rows,
        )


def _rooms(choices: BearingsFound) -> Iterator[Text]:
    for place, tasks in choices.tasks.items():
        room = tasks[0].room
        if room.longest is None:
            yield Text("Room of the {place} journal: {why}.", place=called(place), why=room.why)
        else:
            yield Text(
                "Room of the {place} journal: {room}; {why}.",
                place=called(place),
                room=mm(room.longest),
                why=room.why,
            )
    if choices.beyond:
        yield Text(
            "A journal that is too long asks for sectors that give way: their masses moved, a shorter half_length_mm, "
            "or the true shape as "
            "[[shafts.sections]]. Of these rows each is the shortest of its oil and supply; until the shaft "
            "gives way, "
            "countershaft.crossing fails with them."
        )


def _diameters(choices: BearingsFound) -> Iterator[Text]:
    """What ties them, or which were looked at, and where the best row stands at their end."""
    for n, row in enumerate(choices.case.rows):
        place = row.name
        if len(choices.tasks[place]) == 1:
            why = tied(choices.case, row) or Text("no other carries the load")
            yield Text("The {place} diameter stays as it is: {why}.", place=called(place), why=why)
            continue
        looked = sorted(task.size for task in choices.tasks[place])
        free = Text(
            "The {place} diameter is free: {diameters} mm are looked at, nothing between.",
            place=called(place),
            diameters=COMMA.join(Text("{d}", d=short_mm(d)) for d in looked),
        )
        if ends := {found.picks[n].diameter for found in choices.rows[:1]} & {looked[-1]}:
            free += Text(" {d}, in the first row, is the end of it: beyond may be better.", d=mm(ends.pop()))
        yield free
    if any(len(some) > 1 for some in choices.tasks.values()):
        yield Text(
            "The first oil and supply that passes is looked at with every diameter, other oils with those beside its "
            "best, other supplies with its best."
        )


def _searched(choices: BearingsFound) -> Iterator[Text]:
    yield Text(
        "Of least friction are those within 1 % of each other alike: the smaller bearing goes first, then the smaller "
        "change. Lengths stand on half millimetres, clearances on 5 µm, of journals below 45 mm on 2 µm, up to "
        "{widest} ‰ of the diameter, and the design's own beside them.",
        widest=Amount(WIDEST_CLEARANCE * 1e3),
    )
    if any(some[0].field is not None for some in choices.tasks.values()):
        yield Text(
            "Limits of the parts keep their widths and move: with the diameter; with the clearance the journal, or "
            "the walls of shells that are found."
        )
    if choices.placed:
        yield Text(
            "The design's fits have a place and so make the clearance: a row with another one takes their widths "
            "alone (IT7 for f7)."
        )
    if choices.verified:
        said = rows_of([choices.no(number) for number in choices.verified])
        yield Text("Solved as whole designs: {rows}; the others are when they are taken.", rows=said)
    for id in dict.fromkeys(c.id for checks in choices.elsewhere.values() for c in checks):
        there = {number: c for number, checks in choices.elsewhere.items() for c in checks if c.id == id}
        numbers, first = COMMA.join(str(choices.no(number)) for number in there), next(iter(there.values()))
        yield Text("Then open, with row {rows}: {id} ({limit}).", rows=numbers, id=id, limit=against(first))
    if choices.dropped:
        yield Text("Dropped once the whole design was solved: {rows}.", rows=SEMICOLON.join(choices.dropped))


def rows_of(numbers: list[int]) -> Text:
    """`rows 1 to 4 and 7`."""
    return plural("row {rows}", "rows {rows}", n=len(numbers), rows=_runs(numbers))


def _runs(numbers: Iterable[int]) -> Text:
    runs: list[list[int]] = []
    for n in sorted(numbers):
        if runs and n == runs[-1][1] + 1:
            runs[-1][1] = n
        else:
            runs.append([n, n])
    return listed(Text("{a} to {b}", a=a, b=b) if a < b else str(a) for a, b in runs)


def _refused(choices: BearingsFound) -> Iterator[Text]:
    """Oils without a row: each with its reason by the design's supply, by another the thickest one's."""
    for supply in dict.fromkeys(v.supply for v, _ in choices.refused):
        rows = [(v.oil, why) for v, why in choices.refused if v.supply == supply]
        if supply == choices.variants[0].supply:
            oils = SEMICOLON.join(Text("{oil} ({why})", oil=oil, why=why) for oil, why in rows)
        else:
            names = COMMA.join(oil for oil, _ in rows)
            oils = Text("{oils} ({oil}: {why})", oils=names, oil=rows[0][0], why=rows[0][1])
        yield Text("Without a row by {supply}: {oils}.", supply=SUPPLY[supply], oils=oils)


def hidden(choices: BearingsFound, top: int) -> Text:
    """Which rows are not shown, and how to see them."""
    last = len(choices.rows) + len(choices.beyond)
    if top >= last:
        return EMPTY
    beyond = max(top, len(choices.rows)) + 1
    if choices.rows and choices.beyond:
        return Text("Rows {a} to {b}: --top {b} (from {c} on too long for their room).", a=top + 1, b=last, c=beyond)
    return Text("Rows {a} to {b}: --top {b}.", a=top + 1, b=last)
