# SPDX-License-Identifier: Apache-2.0
"""The balancing sheets of a design as a table, for the machine's own program: lines with # of what is counted from
where, then id, value, unit, label, and a block for each reading."""

import cmath
import csv
from collections.abc import Iterator, Mapping
from io import StringIO
from typing import TYPE_CHECKING

from ..countershaft.balancing import formulas as f
from ..countershaft.balancing.result import PLANES, RINGS
from ..draw.balancing_views import BalanceSheet, LineRow, conditions
from ..draw.sizes import Say
from ..exchange.frame import number as exact
from ..sheet.quantity import published
from ..sheet.text import Name, Text
from ..sheet.units import UNITS, Radian
from ..sheet.version import VERSION
from ..sheet.visible import visible
from ..solve import Results
from .balancing import asked, page_of

if TYPE_CHECKING:
    from ..countershaft.balancing.inputs import MachineReading
    from ..countershaft.balancing.result import BalancingResult, HoleTakes, ReadingResult

COLUMNS = "id", "value", "unit", "label"
SIDES = "front", "rear"
Row = tuple[str, str, str, Text]

IN_ENGINE, BY_SHOP = Text("its angle in the engine, cylinder 1 at TDC"), Text("its angle as the shop counts")
ANGLES = Text(
    "shop_angle: as the shop counts, from its 0 (zero) in its sense, 0 to 360°; angle, target_angle: in the "
    "engine, from up with cylinder 1 at TDC, in the sense of the crank, also on a shaft that turns against it"
)
PLACES = Text(
    "z along the shaft from mid-shaft, + towards the flywheel; front and rear: the planes of the first and the last "
    "bearing; depth: of the full diameter, from the outer radius inwards; 0: not drilled"
)
UNBALANCE = Text(
    "a residual reading and what is left are what is beyond the target; a total reading has the target in it; what is "
    "permitted is the circle around the end of the target"
)
VERDICTS = Text("pass, fail, not_verified: this machine can not tell, not_judged: what is permitted is not known")
UNITS_LINE = Text("each row has its own; numbers have a decimal point; an empty value: there is none")


def csv_text(results: Results, sha256: str, say: Say = str) -> str:
    """An empty line stands before the block of each reading."""
    file, pages = StringIO(), {name: page_of(view, name) for name, view in asked(results).items()}
    for key, line in _head(results, pages, sha256, say):
        file.write(f"# {key}: {line}\n")
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow(COLUMNS)
    for n, block in enumerate(_blocks(results, pages)):
        if n:
            file.write("\n")
        rows.writerows((id, number, unit, say(label)) for id, number, unit, label in block)
    return file.getvalue()


def _head(results: Results, pages: Mapping[str, BalanceSheet], sha256: str, say: Say) -> Iterator[tuple[str, str]]:
    yield "program", f"Contralbero {VERSION}"
    yield "design", visible(results.design.name)
    yield "sha256", sha256
    yield from ((key, say(line)) for key, line in (("angles", ANGLES), ("places", PLACES), ("unbalance", UNBALANCE)))
    yield from (("verdict", say(VERDICTS)), ("units", say(UNITS_LINE)))
    for name, page in pages.items():
        zero, *sense = (say(line) for line in conditions(page))
        yield from ((f"zero, {name}", zero), *((f"sense, {name}", line) for line in sense))


def _blocks(results: Results, pages: Mapping[str, BalanceSheet]) -> list[list[Row]]:
    """Blocks of rows: of each shaft its sheet, and then one of each reading."""
    blocks = []
    for name, view in asked(results).items():
        shaft = view.shaft
        assert shaft is not None and shaft.balancing is not None
        found = shaft.balancing
        step = f"countershaft.{name}" if len(results.design.shafts) > 1 else "countershaft"
        sheet = f"{step}.balancing"
        own = {v.id: (v.id, exact(v.shown), v.unit, v.label) for v in published(found, sheet)}
        readings = tuple(f"{sheet}.reading.{serial}." for serial in found.reading)
        block = [row for id, row in own.items() if not id.startswith(readings)]
        if shaft.tolerance is not None:
            permitted = published(shaft.tolerance, step)
            block += [(v.id, exact(v.shown), v.unit, v.label) for v in permitted if v.unit == "g·mm"]
        block += _places(found, sheet)
        for hole in found.hole.values():
            block += _hole(found, hole, f"{sheet}.hole.{hole.drill.name}")
        for drill in found.outside:
            why = Text("Hole {name} is not drilled: {where}", name=Name(drill.name), where=drill.outside)
            block.append((f"{sheet}.hole.{drill.name}", "", "", why))
        for row in pages[name].line:
            block += _line(row, f"{sheet}.line.{row.key}")
        blocks.append(block)
        for read, of in zip(found.inputs.readings, readings):
            values = [row for id, row in own.items() if id.startswith(of)]
            blocks.append([*_read(read, of), *values, *_told(found, found.reading[read.serial], of)])
    return blocks


def _row(id: str, inside: float | None, unit: str, label: Text) -> Row:
    return id, "" if inside is None else exact(UNITS[unit].shown(inside)), unit, label


def _shop(found: "BalancingResult", phi: Radian) -> Radian:
    return f.shop_angle.function(s=found.sense, phi=phi, phi_0=found.zero)


def _places(found: "BalancingResult", sheet: str) -> Iterator[Row]:
    for key, plane, words in zip(SIDES, found.planes, PLANES):
        yield _row(f"{sheet}.{key}.z", plane.z, "mm", Text("Place of the {plane}", plane=words))
        error = Text("Standard error of machine and ring, {plane}", plane=words)
        yield _row(f"{sheet}.{key}.error", plane.error, "g·mm", error)
    for key, ring, words in zip(SIDES, found.rings, RINGS):
        yield _row(f"{sheet}.ring_{key}.z", ring.z, "mm", Text("Place of the {plane}", plane=words))


def _hole(found: "BalancingResult", hole: "HoleTakes", id: str) -> Iterator[Row]:
    """Its place and size, and how deep it goes for each share of the most."""
    drill = hole.drill
    yield _row(f"{id}.angle", f.once(drill.angle), "°", IN_ENGINE)
    yield _row(f"{id}.shop_angle", _shop(found, drill.angle), "°", BY_SHOP)
    for key, inside, unit, label in (
        ("z", drill.z, "mm", Text("its place")),
        ("diameter", drill.diameter, "mm", Text("its diameter")),
        ("outer_radius", drill.R, "mm", Text("from which its depth counts")),
        ("depth_max", drill.depth, "mm", Text("its greatest depth")),
        ("point", drill.point, "°", Text("point angle of the drill")),
        ("least_depth", hole.least_depth, "mm", Text("its least depth: below it the drill is not wholly in")),
    ):
        yield _row(f"{id}.{key}", inside, unit, label)
    shares = len(hole.depths)
    for n, depth in enumerate(hole.depths, 1):
        share = round(100 * n / shares)
        label = Text("its depth for {n} % of the most", n=share)
        if depth < hole.least_depth:
            label = Text("{depth}: shallower than the drill's own curve", depth=label)
        yield _row(f"{id}.depth_{share}", depth if depth >= hole.least_depth else None, "mm", label)


def _line(row: LineRow, id: str) -> Iterator[Row]:
    if not row.numbers:
        yield id, "", "", Text("{what}: {shall}", what=row.what, shall=row.shall)
    for key, inside, unit, label in row.numbers:
        yield _row(f"{id}.{key}", inside, unit, Text("{what}: {shall}", what=row.what, shall=label))


# --- a reading


def _read(read: "MachineReading", id: str) -> Iterator[Row]:
    yield f"{id}kind", read.kind, "", Text("What was read")
    sides = (read.front, read.front_), (read.rear, read.rear_)
    for key, (U, alpha), words in zip(SIDES, sides, PLANES):
        yield _row(f"{id}read_{key}", U, "g·mm", Text("As read, {plane}", plane=words))
        yield _row(f"{id}read_{key}.shop_angle", f.once(alpha), "°", BY_SHOP)


def _told(found: "BalancingResult", read: "ReadingResult", id: str) -> Iterator[Row]:
    """Where the rest stands, what no hole reaches of it, and whether it passes."""
    for key, U in zip(SIDES, read.left):
        yield from _angles(found, U, f"{id}{key}")
    for key, U, words in zip(SIDES, read.unreached, PLANES):
        label = Text("What no hole reaches, however deep, {plane}", plane=words)
        yield _row(f"{id}unreached_{key}", abs(U), "g·mm", label)
        yield from _angles(found, U, f"{id}unreached_{key}")
    yield f"{id}verdict_as_read", verdict(read.as_read), "", Text("Whether it passes as it was read")
    yield f"{id}verdict", verdict(read.told), "", Text("Whether it passes after drilling")


def _angles(found: "BalancingResult", U: complex, id: str) -> Iterator[Row]:
    phi = f.once(cmath.phase(U)) if U else None
    yield _row(f"{id}.angle", phi, "°", IN_ENGINE)
    yield _row(f"{id}.shop_angle", None if phi is None else _shop(found, phi), "°", BY_SHOP)


def verdict(told: "tuple[str, str] | None") -> str:
    """By both planes."""
    if told is None:
        return "not_judged"
    return "fail" if "fail" in told else "not_verified" if "between" in told else "pass"
