# SPDX-License-Identifier: Apache-2.0
"""The results of a step as tables: parts with the same results (order 1, order 2; front, rear) beside each other.

After them the tables that the step itself has put together.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import groupby

from calc.sheet.number import DIGITS
from calc.sheet.quantity import Published
from calc.sheet.step import Outcome, Table
from calc.sheet.text import Amount

from ..context import Context
from ..typesetting.fonts import WIDTH
from ..typesetting.pagination import Block
from ..typesetting.prose import CELL, HEADER, KEY, run
from ..typesetting.tables import GAP, GUTTER, Cell, Column, named_table, natural, noted_below, table
from ..typesetting.typeset import symbol
from .nomenclature import noted

ACROSS = 7
PART = 50.0  # width in which the name of a part stands above its numbers, on more lines where it is longer
NUMBERS = 56.0  # most width of values in a table of two halves
CLOSE = 4.0  # before values and units in such a table
LEAST_WORDS = 60.0  # width that a column of words needs in a table of many
VECTORS = ("N", "N·m", "°", "kg·mm", "kg·mm²")
LEAST, MOST = 1e-3, 1e7  # of a column's largest number: others have powers of ten
ALIKE = 0.6  # share of results in common, with their names and units, that puts two parts beside each other


@dataclass(slots=True)
class _Part:
    """The results under one address."""

    prefix: str
    name: str
    values: dict[str, Published] = field(default_factory=dict)

    @property
    def zero(self) -> bool:
        return all(v.shown == 0 for v in self.values.values())


def there(values: Iterable[Published]) -> Iterator[Published]:
    """Without the forces and couples that are 0, and the phases behind them: shafts of forces have no couple."""
    length = 1.0
    for value in values:
        length = length if value.id.endswith("_phase") else value.shown
        if length or value.unit not in VECTORS:
            yield value


def value_blocks(context: Context, outcome: Outcome[object], values: Iterable[Published]) -> list[Block]:
    """Values of a step.  What is zero throughout is named, not tabulated, unless everything is asked for."""
    parts: dict[str, _Part] = {}
    for value in values:
        prefix, _, name = value.id.removeprefix(f"{outcome.key}.").rpartition(".")
        parts.setdefault(prefix, _Part(prefix, ", ".join(context.belongs(value.id)))).values[name] = value
    nothing = [p for p in parts.values() if p.zero and p.prefix and not context.audit]
    zero = [p.name for p in nothing]
    blocks: list[Block] = []
    told = [p for p in parts.values() if p not in nothing]
    if (context.shafts or context.shaft) and not context.audit:
        for part in told:
            part.values = {value.id.rpartition(".")[2]: value for value in there(part.values.values())}
    for cluster in _clusters(p for p in told if p.values):
        if len(cluster) == 1:
            blocks += _single(context, cluster[0])
        else:
            for start in range(0, len(cluster), ACROSS):
                blocks += _beside(context, cluster[start : start + ACROSS], zero)
    if zero:
        blocks = noted_below(blocks, context.text("zero_values", names=" · ".join(dict.fromkeys(zero))), gap=3.0)
    return blocks


def _clusters(parts: Iterable[_Part]) -> list[list[_Part]]:
    clusters: list[list[_Part]] = []
    for part in parts:
        names = {(n, v.unit, v.label) for n, v in part.values.items()}
        for cluster in clusters:
            first = {(n, v.unit, v.label) for n, v in cluster[0].values.items()}
            if part.prefix and cluster[0].prefix and len(names & first) >= ALIKE * max(len(names), len(first)):
                cluster.append(part)
                break
        else:
            clusters.append([part])
    return clusters


def _symbol(context: Context, value: Published) -> Cell:
    if not value.symbol:
        return Cell()
    return Cell(
        box=symbol(value.symbol, CELL.size), indexed=noted(context, value.symbol, context.say(value.label), value.unit)
    )


def _named(context: Context, values: Iterable[Published]) -> Iterator[tuple[Published, Cell]]:
    """Values with their names; one that begins with a small letter ("its phase") goes on from the last that does
    not."""
    head = ""
    for value in values:
        name = context.say(value.label)
        goes_on = value.label[:1].islower()
        head = head if goes_on else name
        yield value, Cell(name, indexed=f"{head}: {name}" if goes_on else name)


def _single(context: Context, part: _Part) -> list[Block]:
    w = context.words
    columns = (
        Column(w["quantity"], width=186.0),
        Column(w["symbol"], width=48.0),
        Column(w["value"], "r", width=56.0),
        Column(w["unit"], width=44.0),
        Column(w["id"]),
    )
    together = groupby(part.values.values(), lambda v: (v.symbol.partition("_")[0], v.unit) if v.symbol else v.id)
    written = [text for _, some in together for text in _of_one_symbol(context, [v.shown for v in some])]
    rows = [
        (name, _symbol(context, v), text, v.unit, Cell(context.whole_id(v.id), KEY))
        for (v, name), text in zip(_named(context, part.values.values()), written)
    ]
    title = part.name[:1].upper() + part.name[1:]
    return (
        named_table(title, columns, rows) if context.audit else paired_table(context, title, [row[:4] for row in rows])
    )


def paired_table(context: Context, title: str, rows: Sequence[tuple[str | Cell, ...]]) -> list[Block]:
    """Quantities with symbol, value and unit, or without symbol, two beside each other: down the left half, then down
    the right."""
    if len(rows) < 2:
        return named_table(title, _paired(context, rows), rows)
    half = -(-len(rows) // 2)
    both = [(*left, *right) for left, right in zip(rows[:half], [*rows[half:], ("",) * len(rows[0])])]
    head, *narrow = _paired(context, rows)
    return named_table(title, (head, *narrow, replace(head, before=GUTTER), *narrow), both)


def _paired(context: Context, rows: Sequence[tuple[str | Cell, ...]]) -> tuple[Column, ...]:
    """Columns of half the width of a page: as narrow as symbol, value and unit can be, the rest for what they are
    called."""
    w = context.words
    narrow = [Column(w["symbol"]), Column(w["value"], "r", before=CLOSE), Column(w["unit"], before=CLOSE)]
    narrow = narrow[4 - len(rows[0]) :]
    cells = [[cell if isinstance(cell, Cell) else Cell(cell) for cell in column] for column in list(zip(*rows))[1:]]
    narrow = [replace(column, width=min(_words_width(column, some), NUMBERS)) for column, some in zip(narrow, cells)]
    taken = sum((column.width or 0.0) + column.before for column in narrow)
    return Column(w["quantity"], width=(WIDTH - GUTTER) / 2 - taken), *narrow


def _beside(context: Context, parts: list[_Part], zero: list[str]) -> list[Block]:
    """`zero`: takes the names of what is zero in all of these parts."""
    w = context.words
    all_values: dict[str, Published] = {}
    for part in parts:
        for name, value in part.values.items():
            all_values.setdefault(name, value)
    rows: list[tuple[str | Cell, ...]] = []
    for name, (value, cell) in zip(all_values, _named(context, all_values.values())):
        numbers = in_column(context, [p.values[name].shown if name in p.values else None for p in parts])
        cells = [number or "–" for number in numbers]
        if not context.audit and all(c in ("0", "–") for c in cells):
            zero.append(f"{cell.indexed} ({'; '.join(p.name for p in parts)})")
            continue
        rows.append((cell, _symbol(context, value), *cells, value.unit))
    names = [Column(p.name, "r") for p in parts]
    under = [[Cell(str(row[i])) for row in rows] for i in range(2, 2 + len(parts))]
    narrow = [
        replace(
            column,
            width=max(min(_one_line(column.header), PART), _longest(column), *(natural(cell, column) for cell in some)),
        )
        for column, some in zip(names, under)
    ]
    columns = (Column(w["quantity"]), Column(w["symbol"], width=44.0), *narrow, Column(w["unit"], width=40.0))
    return table(columns, rows, gap=6.0) if rows else []


# --- the step's own tables


def table_blocks(context: Context, tables: Iterable[Table]) -> list[Block]:
    """What belongs side by side: numbers to the right, words to the left; a note in small type below."""
    blocks: list[Block] = []
    for shown in tables:
        rows = _cells(context, shown)
        columns = [_headed(shown, i, [row[i] for row in rows], _one_line) for i in range(len(shown.columns))]
        if (
            sum(c.width or _words_width(c, [row[i] for row in rows]) for i, c in enumerate(columns))
            + GAP * len(columns)
            > WIDTH
        ):
            columns = [_headed(shown, i, [row[i] for row in rows], _two_lines) for i in range(len(shown.columns))]
        for n, some in enumerate(_fitting(columns)):
            title = context.text("two", name=shown.title) if n else shown.title
            fixed = [columns[i].width for i in some]
            # A table of numbers alone ends with its last column.
            width = min(WIDTH, sum(w or 0.0 for w in fixed) + GAP * (len(some) - 1) + 0.01) if all(fixed) else WIDTH
            cells = [[row[i] for i in some] for row in rows] or [[Cell()] * len(some)]
            blocks += named_table(title, [columns[i] for i in some], cells, width=width)
        if shown.note:
            blocks = noted_below(blocks, shown.note)
    return blocks


def _cells(context: Context, shown: Table) -> list[list[Cell]]:
    """What a table says; the numbers of a column that has a unit with the same decimals."""
    columns = []
    for (_, unit), each in zip(shown.columns, zip(*shown.rows)):
        numbers = [cell for cell in each if not (cell is None or isinstance(cell, str))]
        texts = iter(in_column(context, numbers) if unit else map(context.written, numbers))
        columns.append(
            [
                Cell()
                if cell is None
                else Cell(cell, align="l")
                if isinstance(cell, str)
                else Cell(next(texts), align="r")
                for cell in each
            ]
        )
    return [list(row) for row in zip(*columns)]


def _cell(cell: str | float | None, texts: Iterator[str]) -> Cell:
    if cell is None:
        return Cell()
    return Cell(cell, align="l") if isinstance(cell, str) else Cell(next(texts), align="r")


def _of_one_symbol(context: Context, numbers: list[float]) -> list[str]:
    """Neighbours of one size with the same decimals; others, and those of more digits than are shown, each as it is
    said elsewhere."""
    sizes = [abs(x) for x in numbers]
    if len(numbers) > 1 and max(sizes) < 10 * min(sizes) and max(sizes) < 10**DIGITS:
        return in_column(context, numbers, 0)
    return [context.written(x) for x in numbers]


def in_column(context: Context, numbers: Sequence[float | None], beyond: int = 3) -> list[str]:
    """Numbers of one quantity below or beside each other with the same decimals: as many as show four digits of the
    largest and three of the smallest, but no more than so many `beyond` the former; of whole numbers none.  A number
    that they would make nought stands with its own digits; so do all where powers of ten lie between them."""
    sizes = [abs(x) for x in numbers if x is not None and math.isfinite(x) and x]
    if not sizes or not LEAST <= max(sizes) < MOST or any(isinstance(x, bool) for x in numbers):
        return ["" if x is None else context.written(x) for x in numbers]
    of_largest = DIGITS - 1 - math.floor(math.log10(max(sizes)))
    of_smallest = DIGITS - 2 - math.floor(math.log10(min(sizes)))
    decimals = max(0, min(max(of_largest, of_smallest), of_largest + beyond))
    while decimals and all(_ends(x, decimals - 1) for x in sizes):
        decimals -= 1

    def written(x: float | None) -> str:
        if x is None:
            return ""
        if not math.isfinite(x) or 0 < abs(x) < 0.5 * 10.0**-decimals:
            return context.written(x)
        return context.say.part(Amount(x, form=f".{decimals}f"))

    return [written(x) for x in numbers]


def _ends(x: float, decimals: int) -> bool:
    """Whether a number has no more decimals."""
    return abs(x - round(x, decimals)) <= 1e-9 * x


def _headed(shown: Table, i: int, made: Sequence[Cell], header: Callable[[str], float]) -> Column:
    """A column of a table; one of numbers is as wide as they and its header need, so that no number is broken."""
    label, unit = shown.columns[i]
    words = f"{label}, {unit}" if unit else label
    cells = [row[i] for row in shown.rows]
    if not any(isinstance(cell, (int, float)) for cell in cells) and (not unit or any(cells)):
        return Column(words)
    column = Column(words, "r")
    return replace(column, width=max([header(words), *(natural(cell, column) for cell in made if cell.align != "l")]))


def _words_width(column: Column, cells: list[Cell]) -> float:
    """The width in which nothing of a column of words wraps."""
    return max([_one_line(column.header), *(natural(cell, column) for cell in cells)])


def _one_line(header: str) -> float:
    return run(header, HEADER).width


def _longest(column: Column) -> float:
    """The width of the longest word of a header; a name of several parts ends at each of its dashes."""
    return max((run(word, HEADER).width for word in re.split(r"(?<=[-–])|\s+", column.header) if word), default=0.0)


def _two_lines(header: str) -> float:
    """The width in which a header stands on two lines at most."""
    words = header.split()
    return min(
        (max(run(" ".join(part), HEADER).width for part in (words[:n], words[n:])) for n in range(1, len(words))),
        default=run(header, HEADER).width,
    )


def _fitting(columns: list[Column]) -> list[list[int]]:
    """The columns of each of the tables that a wide one is divided into, about as wide as each other; the first column,
    which names the rows, stands in all."""
    if not columns:
        return []
    wide = [column.width or LEAST_WORDS for column in columns]
    division = parts = _filled(wide, WIDTH)
    room = WIDTH
    while len(parts) == len(division) > 1 and room > WIDTH / 2:
        division, room = parts, room - 10.0
        parts = _filled(wide, room)
    return division


def _filled(wide: list[float], room: float) -> list[list[int]]:
    """The columns of each part when every part takes as many as there is room for."""
    parts = [[0]]
    filled = wide[0]
    for i, needed in enumerate(wide[1:], 1):
        if filled + GAP + needed > room and len(parts[-1]) > 1:
            parts.append([0])
            filled = wide[0]
        parts[-1].append(i)
        filled += GAP + needed
    return parts
