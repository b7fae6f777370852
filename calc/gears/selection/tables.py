# SPDX-License-Identifier: Apache-2.0
"""What was found, as tables, and the keys that put a row into a design file."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from ...sheet.record import replace
from ...sheet.remedy import Changes
from ...sheet.step import Table
from ...sheet.text import COMMA, EMPTY, SPACE, Amount, Name, Text, listed, plural
from ..inputs import Mesh, mesh_key, wheel_key
from ..wheel_inputs import Wheel
from .free_shifts import Freedom
from .optimum import GRID
from .rattle import RattleOfRows
from .search import ShiftRow, ShiftsFound
from .states import CLEARANCE, CONTACT, FILLET, HARD_CASE, HARDENED, TIP, USUAL, Place

Cells = tuple[str | float | None, ...]
NUMBER, NOW, WHAT, LARGEST, OF = Text("no."), Text("now"), Text("what"), Text("max |ζ_A|"), Text("of")
VERDICT = ((LARGEST, ""), (OF, ""), (Text("margin"), "%"), (Text("by"), ""))
BARS = {  # by which limits a row is judged: its word in a column, and what it stands for
    "hardened": (Text("hardened"), Text("the usual limits and that of case-hardened tips")),
    "usual": (Text("usual"), Text("the usual limits")),
    "as now": (Text("as now"), Text("limits no lower than the design as it is, which stands below the usual ones")),
}

EXPLAIN = Text(
    "x: profile shifts. max |ζ_A|: the largest specific sliding at the start of contact, of which wheel/in mesh with "
    "which. margin: the least of all rules, and by which (of undercut: the shift above it, in hundredths)."
)


def _columns(*labels: Text) -> list[tuple[Text, str]]:
    return [(label, "") for label in labels]


def _shifts_of(wheels: Sequence[str]) -> list[tuple[Text, str]]:
    return _columns(*(Text("x {wheel}", wheel=name) for name in wheels))


def choices_table(result: ShiftsFound, top: int, rattle: RattleOfRows | None = None) -> Table:
    """The design as it is, then the optimum of each way to leave shifts free; `rattle`: what each does at idle."""
    title = Text("No shift keeps every rule with the tips as they are")
    if result.optima:
        title = Text("Profile shifts with the least largest specific sliding")
    rows = _now(result) + _numbered(result, result.optima[:top])
    return _rows_table(result, "shifts", title, rows, EXPLAIN, rattle)


def wants_table(result: ShiftsFound) -> Table | None:
    """What each pair alone would have, and what that does to the train."""
    if not result.wants:
        return None
    wheels = [w.name for w in result.case.gears.wheels]
    columns = [
        *_columns(NUMBER, Text("pair")),
        *_shifts_of(wheels),
        *_columns(Text("its own max |ζ_A|"), LARGEST, OF, Text("breaks")),
    ]
    cells: list[Cells] = []
    for row in result.wants:
        pair_largest = _round(float(row.states.largest_of(row.wants)[0]), 3)
        breaks = EMPTY if row.passes else _stopped(row)
        shifts = (_shift(row, name) for name in wheels)
        cells.append((result.number(row), row.name, *shifts, pair_largest, _round(row.largest, 3), _of(row.of), breaks))
    title = Text(
        "What each pair alone would want ({way}), and the largest sliding of the train with it",
        way=result.along.freedom.name,
    )
    return Table("wants", title, tuple(columns), tuple(cells))


def around_table(result: ShiftsFound, rattle: RattleOfRows | None = None) -> Table | None:
    """Round shifts beside the optimum."""
    if not result.around:
        return None
    leader, way = result.along.leader, result.along.freedom
    title = Text("Round shifts of {wheel} around the optimum ({way})", wheel=leader, way=way.name)
    others = [name for name in way.free if name != leader]
    note = Text("The shift of {wheels} as in the optimum.", wheels=listed(others)) if others else EMPTY
    return _rows_table(result, "around", title, _numbered(result, result.around), note, rattle)


def first_rows(table: Table | None, top: int) -> Table | None:
    """A table up to its `top` numbered rows, and how many more there are."""
    numbered = [n for n, row in enumerate(table.rows) if str(row[0]).isdigit()] if table is not None else []
    if table is None or len(numbered) <= top:
        return table
    more = Text("{n} more; --top N shows more.", n=len(numbered) - top)
    note = Text(" ").join([table.note, more]) if table.note else more
    return replace(table, rows=table.rows[: numbered[top]], note=note)


def _now(result: ShiftsFound) -> list[tuple[str, ShiftRow]]:
    return [(NOW, result.now)] if result.now else []


def _numbered(result: ShiftsFound, rows: Sequence[ShiftRow]) -> list[tuple[str, ShiftRow]]:
    return [(result.number(row), row) for row in rows]


def _rows_table(
    result: ShiftsFound,
    id: str,
    title: Text,
    rows: list[tuple[str, ShiftRow]],
    note: Text,
    rattle: RattleOfRows | None,
) -> Table:
    wheels = [w.name for w in result.case.gears.wheels]
    columns = [*_columns(NUMBER, WHAT), *_shifts_of(wheels), *VERDICT]
    cells: list[Cells] = [(n, row.name, *(_shift(row, name) for name in wheels), *_verdict(row)) for n, row in rows]
    if rattle is not None and rattle.known:
        columns.append((Text("idle"), ""))
        cells = [(*cell, rattle.cell(row)) for cell, (_, row) in zip(cells, rows)]
        note = SPACE.join(filter(None, (note, rattle.note(rows))))
    return _with_bars(Table(id, title, tuple(columns), tuple(cells), note), [row for _, row in rows])


def _with_bars(table: Table, rows: list[ShiftRow]) -> Table:
    """The limits that each row keeps, of which its margin is: in a column of their own, in the note where they are the
    same."""
    kept = [_kept(row) for row in rows]
    bars = [bar for bar in BARS if bar in kept]
    if len(bars) > 1:
        kinds = Text("; ").join(Text("{word}: {limits}", word=BARS[bar][0], limits=BARS[bar][1]) for bar in bars)
        note = Text("keeps: {kinds}.", kinds=kinds)
        cells = tuple((*row, BARS[bar][0] if bar else EMPTY) for row, bar in zip(table.rows, kept))
        table = replace(table, columns=(*table.columns, (Text("keeps"), "")), rows=cells)
    else:
        note = Text("All numbered rows keep {limits}.", limits=BARS[bars[0]][1]) if bars else EMPTY
    return replace(table, note=SPACE.join(filter(None, (table.note, note))))


def _verdict(row: ShiftRow) -> Cells:
    return (_round(row.largest, 3), _of(row.of), _round(row.margin * 100, 1), _stopped(row))


def _stopped(row: ShiftRow) -> Text:
    return Text("{rule} {place}", rule=row.least.rule.brief, place=row.least.where.name)


def _kept(row: ShiftRow) -> str:
    if not row.passes:
        return ""
    return "hardened" if row.bar == HARD_CASE else "usual" if row.bar == USUAL else "as now"


def _shift(row: ShiftRow, wheel: str) -> float:
    return round(float(row.states.shifts[wheel][0]), 5)


def _of(place: Place) -> str:
    """`crank/central`: the wheel that slides, and its mate."""
    return f"{place[1]}/{_mate(*place)}"


def _mate(mesh: str, wheel: str) -> str:
    one, two = mesh.split("_")
    return two if wheel == one else one


def _round(number: float, digits: int) -> float | None:
    return round(number, digits) if np.isfinite(number) else None


def sliding_table(result: ShiftsFound, top: int) -> Table:
    """Every mesh of the first rows and of the design as it is."""
    columns = [*_columns(NUMBER, Text("mesh")), (Name("a_w"), "mm")]
    columns += _columns(Text("ζ_A driver"), Text("ζ_A driven"), Text("ζ_B driver"), Text("ζ_B driven"), Name("ε_α"))
    columns += _columns(Name("s_an/m_n"), Text("above fillet/m_n"), Name("c/m_n"))
    cells: list[Cells] = []
    for n, row in _now(result) + _numbered(result, (*result.optima, *result.wants)[:top]):
        for i, key in enumerate(row.states.contact_ratio):
            cells.append((n if i == 0 else "", *_mesh_cells(result, row, key)))
    note = Text(
        "Signed, negative in the dedendum: A at the start of contact, B at the lowest point of single contact. The "
        "last three: the less of both wheels; above fillet: (d_N − d_Ff)/2 of the thinnest tooth."
    )
    return Table("sliding", Text("Specific sliding in every mesh"), tuple(columns), tuple(cells), note)


def _mesh_cells(result: ShiftsFound, row: ShiftRow, key: str) -> Cells:
    s, m_n, pair = row.states, result.case.system.m_n, key.split("_")
    at: list[Place] = [(key, wheel) for wheel in pair]
    zeta = [float(s.sliding[p][0]) for p in at] + [float(s.sliding_lpstc[p][0]) for p in at]
    s_an = min(float(s.tip_thickness[w][0]) for w in pair)
    lengths = s_an, *(min(float(by[p][0]) for p in at) for by in (s.margin, s.clearance))
    ratio, a_w = float(s.contact_ratio[key][0]), float(s.distances[key][0])
    numbers = *zeta, ratio, *(length / m_n for length in lengths)
    return key.replace("_", "–"), _round(a_w * 1e3, 4), *(_round(x, 3) for x in numbers)


def limits_table(result: ShiftsFound) -> Table:
    """Between which shifts each rule holds."""
    rows: list[Cells] = []
    for limit in result.limits:
        needs = Text("{symbol} ≥ {limit}", symbol=limit.rule.symbol, limit=Amount(limit.rule.limit, form="g"))
        ends: Cells = (None, Text("nowhere"), None, "")
        if limit.range:
            ends = limit.range[0], limit.low, limit.range[1], limit.high
        rows.append((limit.rule.name, needs, *ends))
    leader, way = result.along.leader, result.along.freedom.name
    start = Text("x {wheel} from", wheel=leader)
    columns = _columns(Text("rule"), Text("needs"), start, Text("stopped by"), Text("to"), Text("stopped by "))
    note = Text(
        "Around the optimum, or nearest to it. Where nothing is named the rule holds to the end of undercut, or x = 3."
    )
    title = Text("Where each rule stops the shift of {wheel} ({way})", wheel=leader, way=way)
    return Table("limits", title, tuple(columns), tuple(rows), note)


def cuts_now_table(result: ShiftsFound) -> Table | None:
    """Tip cuts one by one, the shifts as they are: what each does to both wheels."""
    if result.now is None:
        return None
    columns = [*_columns(NUMBER, Text("cut")), (Name("k"), "mm")]
    columns += _columns(Text("mate"), Text("ζ_A cut"), Text("ζ_A mate"), Text("ζ_B cut"), Text("ζ_B mate"), Name("ε_α"))
    columns += [(Text("s_an cut"), "mm"), (Text("d_Nf mate"), "mm"), (Text("c mate"), "mm"), (LARGEST, "")]
    cells: list[Cells] = []
    for wheel in result.case.gears.wheels:
        rows: list[tuple[str, float, ShiftRow]] = [
            (result.number(row), row.cuts[wheel.name], row) for row in result.cut_now if wheel.name in row.cuts
        ]
        rows.append((NOW, wheel.tip_shortening, result.now))
        for n, k, row in sorted(rows, key=lambda entry: entry[1]):
            meshes = [key for key in row.states.contact_ratio if wheel.name in key.split("_")]
            for i, key in enumerate(meshes):
                largest = _round(row.largest, 3)
                start: Cells = (n, wheel.name, round(k * 1e3, 6)) if i == 0 else ("", "", None)
                cells.append((*start, *_cut_cells(row, key, wheel.name), largest if i == 0 else None))
    note = Text(
        "One wheel is cut at a time. c: at the root of the mate. max |ζ_A|: of the whole train. A row without number "
        "breaks a rule."
    )
    title = Text("Tip cuts with the shifts as they are: what they do to both wheels")
    return Table("tip_cuts_now", title, tuple(columns), tuple(cells), note)


def _cut_cells(row: ShiftRow, key: str, wheel: str) -> Cells:
    s, mate = row.states, _mate(key, wheel)
    place, other = (key, wheel), (key, mate)
    zeta = (s.sliding[place], s.sliding[other], s.sliding_lpstc[place], s.sliding_lpstc[other], s.contact_ratio[key])
    lengths = (s.tip_thickness[wheel], s.sap_diameter[other], s.clearance[other])
    return (mate, *(_round(float(x[0]), 3) for x in zeta), *(_round(float(x[0]) * 1e3, 3) for x in lengths))


def cuts_best_table(result: ShiftsFound, top: int) -> Table | None:
    """Tip cuts with the shift that is then the best."""
    if not result.cut_best:
        return None
    free = result.along.freedom.free
    columns = [*_columns(NUMBER, Text("cut")), (Name("k"), "mm"), *_shifts_of(free), *VERDICT]
    cells: list[Cells] = []
    for row in result.cut_best[:top]:
        k, shifts = round(row.cuts[row.name] * 1e3, 6), (_shift(row, name) for name in free)
        cells.append((result.number(row), row.name, k, *shifts, *_verdict(row)))
    left = len(result.cut_best) - len(cells)
    note = Text(
        "One wheel is cut at a time, the others as they are; only cuts that lower the largest sliding, or keep "
        "stricter limits."
    )
    note += Text(" {n} more; --top N shows more.", n=left) if left else EMPTY
    title = Text("Tip cuts with their best shift ({way})", way=result.along.freedom.name)
    return _with_bars(Table("tip_cuts_best", title, tuple(columns), tuple(cells), note), list(result.cut_best[:top]))


# --- words


def summary(result: ShiftsFound) -> tuple[Text, ...]:
    """Which shifts are free, in each way."""
    words = []
    for way in result.freedoms:
        more = EMPTY
        if way.held:
            titles = ((result.case.gears.meshes[i].title, Amount(a * 1e3, form=".3f")) for i, a in way.held.items())
            held = (Text("{mesh} at {a} mm", mesh=title, a=a) for title, a in titles)
            more = Text(" Held: {distances}.", distances=COMMA.join(held))
        elif opened := [m.title for m in way.gears.meshes if m.centre_distance is None]:
            more = Text(" The centre distance {meshes} follows without backlash.", meshes=", ".join(opened))
        if way.name in result.refused:
            more += Text(" Nothing passes so.")
        elif way.name in result.no_better:
            more += Text(" Nothing better so.")
        words.append(Text("{way}: {free}", way=way.name, free=way.words) + more)
    words += [
        Text("{way}: not searched, more than {n} shifts are free.", way=way, n=max(GRID)) for way in result.unsought
    ]
    if result.exact is not None:
        x, zeta = Amount(result.exact[0], form=".6f"), Amount(result.exact[1], form=".5f")
        words.append(
            Text(
                "Before rounding the optimum of {way} is x {wheel} = {x}: max |ζ_A| = {zeta}.",
                way=result.along.freedom.name,
                wheel=result.along.leader,
                x=x,
                zeta=zeta,
            )
        )
    return tuple(words)


def notes(result: ShiftsFound) -> Iterator[Text]:
    yield Text(
        "Kept by numbered rows: x ≥ x_min, s_an ≥ {tip}·m_n, ε_α ≥ {contact}, start of contact {fillet}·m_n above the "
        "fillet of the thinnest tooth, and c ≥ {clearance}·m_n.",
        tip=TIP.limit,
        contact=CONTACT.limit,
        fillet=FILLET.limit,
        clearance=CLEARANCE.limit,
    )
    if below := [n for n, row in enumerate(result.all, 1) if not row.usual]:
        lower = []
        for rule, usual in zip(result.case.bars[-1], USUAL):
            if rule is not usual:
                limits = {"limit": Amount(rule.limit, form=".4g"), "usual": usual.limit}
                lower.append(Text("{symbol} ≥ {limit} instead of {usual}", symbol=rule.symbol, **limits))
        yield Text(
            "The design itself is below that. No worse than it ({limits}): {rows}.",
            limits=COMMA.join(lower),
            rows=_rows(below),
        )
    limit = HARDENED.limit
    tips = [min(float(s[0]) for s in row.states.tip_thickness.values()) for row in result.all]
    if thin := [n for n, s_an in enumerate(tips, 1) if s_an / result.case.system.m_n < limit]:
        yield Text("Tips under {limit}·m_n, not for case-hardened teeth: {rows}.", limit=limit, rows=_rows(thin))
    else:
        yield Text("All have tips for case-hardened teeth ({limit}·m_n).", limit=limit)
    yield Text(
        "Shifts are multiples of 0.0001. What follows from a centre distance or from the design's own rules has no key "
        "in the file."
    )
    yield Text(
        "Spans, sizes over balls, backlash and root stresses change with the shifts: `contralbero check FILE --step "
        "gears` shows them."
    )


def _rows(numbers: list[int]) -> Text:
    return plural("row {rows}", "rows {rows}", n=len(numbers), rows=", ".join(map(str, numbers)))


def changes(row: ShiftRow) -> Changes:
    """The keys that put a row into a design; shifts that would contradict it go."""
    cuts = {wheel_key(name, Wheel.tip_shortening): round(k * 1e3, 6) for name, k in row.cuts.items()}
    return cuts | (freed(row.freedom, row.free) if row.freedom is not None else {})


def freed(way: Freedom, free: Mapping[str, float]) -> Changes:
    """The keys of free shifts: those that would contradict them go, distances that were held are given."""
    shifts = {wheel_key(name, Wheel.profile_shift): round(x, 4) for name, x in free.items()}
    held = {mesh_key(i, Mesh.centre_distance): round(a * 1e3, 3) for i, a in way.held.items()}
    return dict.fromkeys(way.removed) | shifts | held


def changed(row: ShiftRow) -> Text:
    """`x central = 0.0873, tip cut idler 0.3 mm`."""
    words = [Text("x {wheel} = {x}", wheel=name, x=Amount(x, form=".4f")) for name, x in row.free.items()]
    if row.freedom is not None:
        held = ((row.freedom.gears.meshes[i].title, Amount(a * 1e3, form=".3f")) for i, a in row.freedom.held.items())
        words += [Text("{mesh} {a} mm", mesh=mesh, a=a) for mesh, a in held]
    cuts = ((name, Amount(k * 1e3, "mm", form="g")) for name, k in row.cuts.items())
    return COMMA.join(words + [Text("tip cut {wheel} {k}", wheel=name, k=k) for name, k in cuts])
