# SPDX-License-Identifier: Apache-2.0
"""The sheet for the balancing machine: one page, which the machine's operator reads standing.

At the top what is written in by hand, below it the views (balancing_views.py), then tables, each for one question."""

import cmath
import math
from typing import TYPE_CHECKING

from ..sheet.text import COMMA, EMPTY, Amount, Name, Text
from ..sheet.units import UNITS, KilogramMetre, Metre, Radian
from .annotations import LETTER, Leaf
from .balancing_views import A4, GAP, TURN, WIDE, BalanceSheet, shop, views
from .drawing import FRAME, TABLE, VISIBLE
from .lettering import width
from .sizes import Say, alone, millimetres, number
from .workshop_sheet import BLOCK_TOP, LEFT, LOW, PAD, STAMP, DrawnPart, Release, WorkshopSheet, stamp, title_block

if TYPE_CHECKING:
    from ..countershaft.balancing.result import HoleTakes, ReadingResult
    from ..design.other_tables import DocumentControl

HAND = 10.0  # height of what is filled in by hand
ROW, CLOSE = 5.0, 4.4  # of the tables; closer where there is much to say
LEAST_VIEW, MOST_VIEW = 62.0, 80.0
MANY, EACH_ROW = 99, 5  # rows of a table, holes in a row of the readings
PLANES = Text("I, front"), Text("II, rear")
WORTH_SAYING = 0.05  # of what is permitted


def balancing_sheet(
    of: BalanceSheet, part: DrawnPart, control: "DocumentControl", release: Release, say: Say
) -> WorkshopSheet:
    """The page; marks in metres from its lower left corner."""
    page = Leaf()
    page.box(FRAME, LEFT, LOW, A4.right, A4.top)
    _by_hand(page, say)
    low, top = BLOCK_TOP + STAMP + GAP, A4.top - HAND
    row, tables = _fitting(of, top - low - LEAST_VIEW - GAP, say)
    room = top - low - sum(_height(table, row) + GAP for table in tables)
    high = min(max(room - GAP, LEAST_VIEW), MOST_VIEW)
    views(page, of, top, high, say)
    y = top - high - GAP
    spare = max(room - GAP - high, 0.0) / max(len([t for t in tables if t]), 1)
    for table in tables:
        for x, head, rows, columns in table:
            block = Leaf()
            block.table(rows, columns, head, row)
            page.add(block, LEFT + x, y)
        y -= _height(table, row) + (min(GAP + spare, 2 * GAP) if table else 0.0)
    facts = {"scale": "–", "material": part.material, "mass": part.mass, "sheet": part.sheet}
    title_block(page, A4, control, part, say(Text("Balancing sheet")), facts, say)
    stamp(page, A4, release, say)
    return WorkshopSheet(part.title, A4, 1.0, (), tuple(page.marks), (0.0, 0.0))


def _fitting(of: BalanceSheet, room: float, say: Say) -> tuple[float, "list[Tables]"]:
    """The height of a row, and the tables with as many readings as there is room for; at last with less of the end of
    the line."""
    ways = [(ROW, 4, MANY), (ROW, 2, MANY), *((CLOSE, n, MANY) for n in (4, 2, 1)), *((CLOSE, 1, n) for n in (5, 3, 1))]
    for row, readings, lines in ways:
        tables = [
            _targets(of, say),
            _holes(of, say),
            _not_drilled(of, say),
            *_read(of, readings, say),
            _line(of, lines, say),
        ]
        if sum(_height(table, row) + GAP for table in tables) <= room:
            break
    return row, tables


def _by_hand(page: Leaf, say: Say) -> None:
    """Three fields along the upper edge, and the verdict."""
    fields = (Text("Serial number"), 60.0), (Text("Date"), 35.0), (Text("Name"), 50.0), (Text("Passes: yes / no"), 35.0)
    x, low = LEFT, A4.top - HAND
    page.line(VISIBLE, (LEFT, low), (A4.right, low))
    for label, wide in fields:
        page.words(say(label), x + PAD, A4.top - PAD - LETTER, layer=TABLE)
        x += wide
        if x < A4.right:
            page.line(TABLE, (x, low), (x, A4.top))


# --- the tables: (x, head, rows, widths) side by side

Tables = list[tuple[float, str, list[tuple[str, ...]], tuple[float, ...]]]


def _height(tables: Tables, row: float) -> float:
    return max((row * (len(rows) + bool(head)) for _, head, rows, _ in tables), default=0.0)


def _fitted(rows: list[tuple[str, ...]], wide: float, grows: int = 0, least: float = 12.0) -> tuple[float, ...]:
    """The widths of columns: each as wide as what stands in it, and an equal part of what is left; where there is not
    room enough the one that `grows` is cut, down to its `least`, then the widest one."""
    own = [max(width(cells[i], LETTER) for cells in rows) + 3.2 for i in range(len(rows[0]))]
    own[grows] = max(own[grows], least)
    spare = wide - sum(own)
    if spare >= 0:
        return tuple(x + spare / len(own) for x in own)
    own[grows] = max(own[grows] + spare, least)
    widest = max(range(len(own)), key=lambda i: own[i] if i != grows else 0.0)
    own[widest] += wide - sum(own)
    return tuple(own)


def _even(columns: int) -> tuple[float, ...]:
    """To be written in by hand."""
    return (18.0, *([(WIDE - 18.0) / (columns - 1)] * (columns - 1)))


def _row(say: Say, *cells: Text) -> tuple[str, ...]:
    return tuple(say(cell) for cell in cells)


def gmm(U: KilogramMetre) -> Text:
    """Four digits: what a machine shows."""
    shown = UNITS["g·mm"].shown(U)
    return alone(number(shown, max(0, 3 - math.floor(math.log10(abs(shown)))) if shown else 0))


def at_angle(alpha: Radian | None) -> Text:
    return Text("–") if alpha is None else Text("{angle}°", angle=number(math.degrees(alpha), 1))


def _targets(of: BalanceSheet, say: Say) -> Tables:
    """Target and permitted; and the rings."""
    found = of.found
    rows = [_row(say, Text("Plane"), Text("Target, g·mm"), Text("at"), Text("Permitted, g·mm"), Text("Force, N"))]
    for plane, name in zip(found.planes, PLANES):
        permitted = Text("not known") if plane.permitted is None else down(plane.permitted)
        force = alone(number(plane.machine_force, 1))
        rows.append(_row(say, name, gmm(plane.target), at_angle(plane.shop_angle), permitted, force))
    rings = [_row(say, Text("Ring"), Text("g·mm"), Text("at"), Text("z, mm"))]
    for ring, name in zip(found.rings, (Text("front"), Text("rear"))):
        rings.append(_row(say, name, gmm(ring.unbalance), at_angle(ring.shop_angle), alone(millimetres(ring.z, 1))))
    rpm = number(UNITS["rpm"].shown(found.inputs.speed), 0)
    head = say(Text("Target, at {n} rpm on the machine", n=rpm))
    return [
        (0.0, head, rows, _fitted(rows, 110.0)),
        (113.0, say(Text("Compensating rings")), rings, _fitted(rings, 67.0)),
    ]


def down(U: KilogramMetre) -> Text:
    """Rounded down: never more than is permitted."""
    shown = UNITS["g·mm"].shown(U)
    digits = 10.0 ** (math.floor(math.log10(shown)) - 2) if shown > 0 else 1.0
    return alone(Amount(float(f"{math.floor(shown / digits + 1e-9) * digits:.3g}"), form=".12g"))


def _holes(of: BalanceSheet, say: Say) -> Tables:
    """Each hole with its depth for every tenth of what it can take."""
    found = of.found
    if not found.hole:
        return []
    shares = [alone(Amount(10.0 * n, form="g")) for n in range(1, 11)]
    rows = [_row(say, Text("Hole"), Text("at"), Text("z, mm"), Text("⌀"), Text("g·mm"), *shares)]
    for n, hole in enumerate(found.hole.values(), 1):
        drill = hole.drill
        alpha = _once(of, drill.angle)
        depths = [depth_words(hole, h) for h in hole.depths]
        name = Text("{n}  {name}", n=n, name=Name(drill.name))
        size = (
            at_angle(alpha),
            alone(millimetres(drill.z, 1)),
            alone(millimetres(drill.diameter, 1)),
            _three(hole.most),
        )
        rows.append(_row(say, name, *size, *depths))
    least = max(hole.least_depth for hole in found.hole.values())
    head = say(
        Text(
            "Holes: the most that each takes, and how deep for % of it (–: below {h} mm, the drill's own curve)",
            h=millimetres(least, 1),
        )
    )
    return [(0.0, head, rows, _fitted(rows, WIDE))]


def _not_drilled(of: BalanceSheet, say: Say) -> Tables:
    """Holes that would be in the air."""
    rows = [_row(say, Name(drill.name), drill.outside or EMPTY) for drill in of.found.outside]
    return [(0.0, say(Text("Not drilled, in the air")), rows, (30.0, WIDE - 30.0))] if rows else []


def depth_words(hole: "HoleTakes", h: Metre) -> Text:
    """A depth; a dash where the drill would not be wholly in."""
    if h < hole.least_depth:
        return Text("–")
    return alone(Amount(UNITS["mm"].shown(h), form=".1f"))


def _read(of: BalanceSheet, most: int, say: Say) -> "tuple[Tables, Tables]":
    """What was read, which holes go how deep, and what is left; what no hole takes, since drilling only takes away.
    Without readings two lines to write them in."""
    found, rows, unreached = of.found, [], []
    plane = [Text("I, g·mm"), Text("at"), Text("II, g·mm"), Text("at")]
    rows.append(_row(say, Text("Serial"), *plane, Text("drill hole: depth, mm"), Text("left, I / II"), Text("verdict")))
    numbers = {name: n for n, name in enumerate(found.hole, 1)}
    for read in found.inputs.readings[:most]:
        told = found.reading[read.serial]
        deep = [say(_drilled(n, found.hole[name], told)) for name, n in numbers.items() if told.hole[name].number]
        parts = [" · ".join(deep[i : i + EACH_ROW]) for i in range(0, len(deep), EACH_ROW)] or [say(Text("none"))]
        left = Text("{a} / {b}", a=_three(told.front), b=_three(told.rear))
        cells = (gmm(read.front), at_angle(read.front_ % TURN), gmm(read.rear), at_angle(read.rear_ % TURN))
        words = _row(say, Name(read.serial), *cells), _row(say, left, verdict_words(told))
        rows.append((*words[0], parts[0], *words[1]))
        rows += [("", "", "", "", "", part, "", "") for part in parts[1:]]
        if lost := _lost(of, told):
            unreached.append(_row(say, Name(read.serial), COMMA.join(lost)))
    if (more := len(found.inputs.readings) - most) > 0:
        rows.append((say(Text("and {n} more", n=more)), *[""] * 7))
    blank = not found.inputs.readings
    rows += [(say(words), *[""] * 7) for words in (Text("read"), Text("drilled")) if blank]
    columns = (20.0, 19.0, 14.0, 19.0, 14.0, 46.0, 26.0, 22.0) if blank else _fitted(rows, WIDE, grows=5)
    head = say(Text("Left because no hole is there, however deep"))
    return (
        [(0.0, say(Text("Readings, and what they ask to be drilled")), rows, columns)],
        [(0.0, head, unreached, (30.0, WIDE - 30.0))] if unreached else [],
    )


def _lost(of: BalanceSheet, told: "ReadingResult") -> list[Text]:
    """What no hole takes in each plane, where it is worth saying."""
    return [
        Text("{plane}: {U} g·mm at {angle}", plane=name, U=_three(abs(U)), angle=at_angle(_once(of, cmath.phase(U))))
        for plane, U, name in zip(of.found.planes, told.unreached, (Name("I"), Name("II")))
        if plane.permitted is not None and abs(U) > WORTH_SAYING * plane.permitted
    ]


def _once(of: BalanceSheet, phi: Radian) -> Radian:
    """The shop's angle, from 0 to 360°."""
    alpha = shop(of, phi) % TURN
    return 0.0 if TURN - alpha < 1e-9 else alpha


def _three(U: KilogramMetre) -> Text:
    return alone(number(float(f"{UNITS['g·mm'].shown(U):.3g}"), 9))


def _drilled(n: int, hole: "HoleTakes", told: "ReadingResult") -> Text:
    """The number of a hole and its depth; one that would be no deeper than the drill's own curve, below that."""
    h = told.hole[hole.drill.name].number
    if h < hole.least_depth:
        return Text("{n}: < {h}", n=n, h=millimetres(hole.least_depth, 1))
    return Text("{n}: {h}", n=n, h=depth_words(hole, h))


def verdict_words(told: "ReadingResult") -> Text:
    if told.told is None:
        return Text("not judged")
    if "fail" in told.told:
        return Text("out of tolerance")
    return Text("not decided") if "between" in told.told else Text("in tolerance")


def _line(of: BalanceSheet, most: int, say: Say) -> Tables:
    """What the end of the line measures."""
    rows = [_row(say, Text("End of line"), Text("shall be"), Text("measured"))]
    rows += [_row(say, row.what, row.shall, EMPTY) for row in of.line[:most]]
    if len(of.line) > most:
        rows.append(_row(say, Text("and {n} more", n=len(of.line) - most), EMPTY, EMPTY))
    return [(0.0, "", rows, _fitted(rows, WIDE, grows=2, least=30.0))] if of.line else []
