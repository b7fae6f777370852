# SPDX-License-Identifier: Apache-2.0
"""What was found, as tables and a curve, and the keys that put a row into a design file."""

from dataclasses import replace

import numpy as np

from ...sheet.step import Table
from ..inputs import GearsInputs
from .optimum import GRID
from .rules import CLEARANCE, CONTACT, FILLET, HARD_CASE, HARDENED, TIP, USUAL
from .search import Found, Row
from .states import Place

Cells = tuple[str | float | None, ...]
VERDICT = (("max |ζ_A|", ""), ("of", ""), ("margin", "%"), ("by", ""))
BARS = {
    "hardened": "the usual limits and that of case-hardened tips",
    "usual": "the usual limits",
    "as now": "limits no lower than the design as it is, which stands below the usual ones",
}

EXPLAIN = (
    "x: profile shifts. max |ζ_A|: the largest specific sliding at the start of contact, of which wheel/in mesh with which. margin: the "
    "least of all rules, and by which (of undercut: the shift above it, in hundredths)."
)


def choices_table(found: Found, top: int) -> Table:
    """The design as it is, then the optimum of each way to leave shifts free."""
    rows = ([("now", found.now)] if found.now else []) + [(found.number(row), row) for row in found.optima[:top]]
    title = (
        "Profile shifts with the least largest specific sliding" if found.optima else "No shift keeps every rule with the tips as they are"
    )
    return _rows_table(found, "shifts", title, rows, EXPLAIN)


def wants_table(found: Found) -> Table | None:
    """What each pair alone would have, and what that does to the train."""
    if not found.wants:
        return None
    wheels = [w.name for w in found.case.gears.wheels]
    columns = [("no.", ""), ("pair", ""), *((f"x {name}", "") for name in wheels)]
    columns += [("its own max |ζ_A|", ""), ("max |ζ_A|", ""), ("of", ""), ("breaks", "")]
    cells: list[Cells] = []
    for row in found.wants:
        own = _round(float(row.states.largest_of(row.wants)[0]), 3)
        breaks = "" if row.passes else f"{row.least.rule.brief} {row.least.place}"
        shifts = (_shift(row, name) for name in wheels)
        cells.append((found.number(row), row.name, *shifts, own, _round(row.largest, 3), _of(row.of), breaks))
    title = f"What each pair alone would want ({found.along.freedom.name}), and the largest sliding of the train with it"
    return Table("wants", title, tuple(columns), tuple(cells))


def around_table(found: Found) -> Table | None:
    """Round shifts beside the optimum."""
    if not found.around:
        return None
    rows = [(found.number(row), row) for row in found.around]
    title = f"Round shifts of {found.along.leader} around the optimum ({found.along.freedom.name})"
    others = [name for name in found.along.freedom.free if name != found.along.leader]
    return _rows_table(found, "around", title, rows, f"The shift of {' and '.join(others)} as in the optimum." if others else "")


def _rows_table(found: Found, id: str, title: str, rows: list[tuple[str, Row]], note: str) -> Table:
    wheels = [w.name for w in found.case.gears.wheels]
    columns = [("no.", ""), ("what", ""), *((f"x {name}", "") for name in wheels), *VERDICT]
    cells = [(n, row.name, *(_shift(row, name) for name in wheels), *_verdict(row)) for n, row in rows]
    return _with_bars(Table(id, title, tuple(columns), tuple(cells), note), [row for _, row in rows])


def _with_bars(table: Table, rows: list[Row]) -> Table:
    """The limits that each row keeps, of which its margin is: in a column of their own, in the note where they are the same."""
    kept = [_kept(row) for row in rows]
    bars = [bar for bar in BARS if bar in kept]
    if len(bars) > 1:
        note = f"keeps: {'; '.join(f'{bar}: {BARS[bar]}' for bar in bars)}."
        columns, cells = (*table.columns, ("keeps", "")), tuple((*row, bar) for row, bar in zip(table.rows, kept))
        table = replace(table, columns=columns, rows=cells)
    else:
        note = f"All numbered rows keep {BARS[bars[0]]}." if bars else ""
    return replace(table, note=f"{table.note} {note}".strip())


def _verdict(row: Row) -> Cells:
    stopped = f"{row.least.rule.brief} {row.least.place}"
    return (_round(row.largest, 3), _of(row.of), _round(row.margin * 100, 1), stopped)


def _kept(row: Row) -> str:
    if not row.passes:
        return ""
    return "hardened" if row.bar == HARD_CASE else "usual" if row.bar == USUAL else "as now"


def _shift(row: Row, wheel: str) -> float:
    return round(float(row.states.shifts[wheel][0]), 5)


def _of(place: Place) -> str:
    """`crank/central`: the wheel that slides, and its mate."""
    return f"{place[1]}/{_mate(*place)}"


def _mate(mesh: str, wheel: str) -> str:
    one, two = mesh.split("_")
    return two if wheel == one else one


def _round(number: float, digits: int) -> float | None:
    return round(number, digits) if np.isfinite(number) else None


def sliding_table(found: Found, top: int) -> Table:
    """Every mesh of the first rows and of the design as it is."""
    rows = ([("now", found.now)] if found.now else []) + [(found.number(row), row) for row in (*found.optima[:top], *found.wants)]
    columns = [("no.", ""), ("mesh", ""), ("a_w", "mm")]
    columns += [("ζ_A driver", ""), ("ζ_A driven", ""), ("ζ_B driver", ""), ("ζ_B driven", ""), ("ε_α", "")]
    columns += [("s_an/m_n", ""), ("above fillet/m_n", ""), ("c/m_n", "")]
    cells: list[Cells] = []
    for n, row in rows:
        cells += [(n if i == 0 else "", *_mesh_cells(found, row, key)) for i, key in enumerate(row.states.contact_ratio)]
    note = (
        "Signed, negative in the dedendum: A at the start of contact, B at the lowest point of single contact. The last three: the less of "
        "both wheels; above fillet: (d_N − d_Ff)/2 of the thinnest tooth."
    )
    return Table("sliding", "Specific sliding in every mesh", tuple(columns), tuple(cells), note)


def _mesh_cells(found: Found, row: Row, key: str) -> Cells:
    s, m_n, pair = row.states, found.case.system.m_n, key.split("_")
    at: list[Place] = [(key, wheel) for wheel in pair]
    zeta = [float(s.sliding[p][0]) for p in at] + [float(s.sliding_lpstc[p][0]) for p in at]
    lengths = (min(float(s.tip_thickness[w][0]) for w in pair), *(min(float(by[p][0]) for p in at) for by in (s.margin, s.clearance)))
    ratio, a_w = float(s.contact_ratio[key][0]), float(s.distances[key][0])
    return (key.replace("_", "–"), _round(a_w * 1e3, 4), *(_round(x, 3) for x in (*zeta, ratio, *(length / m_n for length in lengths))))


def limits_table(found: Found) -> Table:
    """Between which shifts each rule holds."""
    rows: list[Cells] = []
    for one in found.limits:
        low, high = one.range or (None, None)
        needs = f"{one.rule.symbol} ≥ {one.rule.limit:g}"
        rows.append(
            (one.rule.name, needs, low, one.low, high, one.high) if one.range else (one.rule.name, needs, None, "nowhere", None, "")
        )
    leader = found.along.leader
    columns = (("rule", ""), ("needs", ""), (f"x {leader} from", ""), ("stopped by", ""), ("to", ""), ("stopped by ", ""))
    note = "Around the optimum, or nearest to it. Where nothing is named the rule holds to the end of undercut, or x = 3."
    return Table("limits", f"Where each rule stops the shift of {leader} ({found.along.freedom.name})", columns, tuple(rows), note)


def cuts_now_table(found: Found) -> Table | None:
    """Tip cuts one by one, the shifts as they are: what each does to both wheels."""
    if found.now is None:
        return None
    columns = [("no.", ""), ("cut", ""), ("k", "mm"), ("mate", ""), ("ζ_A cut", ""), ("ζ_A mate", ""), ("ζ_B cut", ""), ("ζ_B mate", "")]
    columns += [("ε_α", ""), ("s_an cut", "mm"), ("d_Nf mate", "mm"), ("c mate", "mm"), ("max |ζ_A|", "")]
    cells: list[Cells] = []
    for wheel in found.case.gears.wheels:
        rows = [(found.number(row), row.cuts[wheel.name], row) for row in found.cut_now if wheel.name in row.cuts]
        rows.append(("now", wheel.tip_shortening, found.now))
        for n, k, row in sorted(rows, key=lambda one: one[1]):
            meshes = [key for key in row.states.contact_ratio if wheel.name in key.split("_")]
            for i, key in enumerate(meshes):
                largest = _round(row.largest, 3)
                start: Cells = (n, wheel.name, round(k * 1e3, 6)) if i == 0 else ("", "", None)
                cells.append((*start, *_cut_cells(row, key, wheel.name), largest if i == 0 else None))
    note = "One wheel is cut at a time. c: at the root of the mate. max |ζ_A|: of the whole train. A row without number breaks a rule."
    return Table("tip_cuts_now", "Tip cuts with the shifts as they are: what they do to both wheels", tuple(columns), tuple(cells), note)


def _cut_cells(row: Row, key: str, wheel: str) -> Cells:
    s, mate = row.states, _mate(key, wheel)
    own, other = (key, wheel), (key, mate)
    zeta = (s.sliding[own], s.sliding[other], s.sliding_lpstc[own], s.sliding_lpstc[other], s.contact_ratio[key])
    lengths = (s.tip_thickness[wheel], s.sap_diameter[other], s.clearance[other])
    return (mate, *(_round(float(x[0]), 3) for x in zeta), *(_round(float(x[0]) * 1e3, 3) for x in lengths))


def cuts_best_table(found: Found, top: int) -> Table | None:
    """Tip cuts with the shift that is then the best."""
    if not found.cut_best:
        return None
    free = found.along.freedom.free
    columns = [("no.", ""), ("cut", ""), ("k", "mm"), *((f"x {name}", "") for name in free), *VERDICT]
    cells = [
        (found.number(row), row.name, round(row.cuts[row.name] * 1e3, 6), *(_shift(row, name) for name in free), *_verdict(row))
        for row in found.cut_best[:top]
    ]
    left = len(found.cut_best) - len(cells)
    note = "One wheel is cut at a time, the others as they are; only cuts that lower the largest sliding, or keep stricter limits." + (
        f" {left} more; --top N shows more." if left else ""
    )
    title = f"Tip cuts with their best shift ({found.along.freedom.name})"
    return _with_bars(Table("tip_cuts_best", title, tuple(columns), tuple(cells), note), list(found.cut_best[:top]))


# --- words -----------------------------------------------------------------------------------------------------------------
def summary(found: Found) -> tuple[str, ...]:
    """Which shifts are free, in each way."""
    words = []
    for way in found.freedoms:
        held = [f"{_name(found.case.gears, i)} at {a * 1e3:.4f} mm" for i, a in way.held.items()]
        opened = [f"{m.driver}–{m.driven}" for m in way.gears.meshes if m.centre_distance is None]
        more = (
            f" Held: {', '.join(held)}."
            if held
            else f" The centre distance {', '.join(opened)} follows without backlash."
            if opened
            else ""
        )
        refused = " Nothing passes so." if way.name in found.refused else " Nothing better so." if way.name in found.no_better else ""
        words.append(f"{way.name}: {way.words[0].lower()}{way.words[1:]}{more}{refused}")
    words += [f"{name}: not searched, more than {max(GRID)} shifts are free." for name in found.unsought]
    if found.exact is not None:
        x, zeta = found.exact
        words.append(
            f"Before rounding the optimum of {found.along.freedom.name} is x {found.along.leader} = {x:.6f}: max |ζ_A| = {zeta:.5f}."
        )
    return tuple(words)


def notes(found: Found) -> tuple[str, ...]:
    kept = (
        f"s_an ≥ {TIP.limit:g}·m_n, ε_α ≥ {CONTACT.limit:g}, start of contact {FILLET.limit:g}·m_n above the fillet of the thinnest tooth"
    )
    said = [f"Kept by numbered rows: x ≥ x_min, {kept}, and c ≥ {CLEARANCE.limit:g}·m_n."]
    below = [n for n, row in enumerate(found.all, 1) if not row.usual]
    if below:
        pairs = [(one, usual) for one, usual in zip(found.case.bars[-1], USUAL) if one is not usual]
        lower = ", ".join(f"{one.symbol} ≥ {one.limit:.4g} instead of {usual.limit:g}" for one, usual in pairs)
        said.append(f"The design itself is below that. No worse than it ({lower}): {_rows(below)}.")
    thin = [n for n, row in enumerate(found.all, 1) if _thinnest(found, row) < HARDENED.limit]
    hard = f"{HARDENED.limit:g}·m_n"
    said.append(
        f"Tips under {hard}, not for case-hardened teeth: {_rows(thin)}." if thin else f"All have tips for case-hardened teeth ({hard})."
    )
    said.append(
        "Shifts are multiples of 0.0001. What follows from a centre distance or from the design's own rules has no key in the file."
    )
    said.append(
        "Spans, sizes over balls, backlash and root stresses change with the shifts: `contralbero check FILE --step gears` shows them."
    )
    return tuple(said)


def _rows(numbers: list[int]) -> str:
    return f"{'rows' if len(numbers) > 1 else 'row'} {', '.join(map(str, numbers))}"


def _thinnest(found: Found, row: Row) -> float:
    return min(float(s[0]) for s in row.states.tip_thickness.values()) / found.case.system.m_n


def _name(gears: GearsInputs, i: int) -> str:
    return f"{gears.meshes[i].driver}–{gears.meshes[i].driven}"


def changes(row: Row) -> list[str]:
    """The keys that put a row into a design, as KEY=VALUE; shifts that would contradict it go."""
    words = [f"gears.wheels.{name}.tip_shortening_mm={round(k * 1e3, 6)!r}" for name, k in row.cuts.items()]
    if row.freedom is not None:
        words += [f"{key}=" for key in row.freedom.removed]
        words += [f"gears.wheels.{name}.profile_shift={round(x, 4)!r}" for name, x in row.free.items()]
        words += [f"gears.meshes.{i}.centre_distance_mm={round(a * 1e3, 4)!r}" for i, a in row.freedom.held.items()]
    return words


def changed(row: Row) -> str:
    """`x central = 0.0873, tip cut idler 0.3 mm`."""
    words = [f"x {name} = {x:.4f}" for name, x in row.free.items()]
    if row.freedom is not None:
        words += [f"{_name(row.freedom.gears, i)} {a * 1e3:.4f} mm" for i, a in row.freedom.held.items()]
    return ", ".join(words + [f"tip cut {name} {k * 1e3:g} mm" for name, k in row.cuts.items()])
