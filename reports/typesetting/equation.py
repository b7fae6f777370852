# SPDX-License-Identifier: Apache-2.0
"""One formula with its numbers: symbol = formula = numbers = value, the source beside it.

A formula that is used for several parts (front and rear bearing, order 1 to 8) stands once, with a line of numbers for
each part under it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from calc.locale import Language
from calc.sheet.expression import Shown, plain, respelled, result, show, symbol_of, symbols_put_in, text
from calc.sheet.text import Name, with_unit
from calc.sheet.value import Equation, Line

from ..blocks.nomenclature import noted_line
from ..context import Context
from .boxes import BETWEEN, Box, row, space
from .boxes import text as text_box
from .fonts import WIDTH, clean
from .pagination import Block, Formula
from .prose import CELL, NOTE, SOURCE
from .prose import lines as text_lines
from .tags import FORMULA, Tag
from .typeset import SetPiece, formula, lines, symbol

if TYPE_CHECKING:
    from .pen import Pen

SIZE = 9.4
LEAD = 2.4  # between the lines of one formula
GAP = 5.0  # between formulas
SOURCE_WIDTH = 140.0
COLUMN = WIDTH - SOURCE_WIDTH - 14.0  # of the formulas
SIGN = 36.0  # where the equals sign stands, unless labels need more
PARTS = 4  # shown with their numbers
MOST = 4  # lines of one formula for one part
LISTED = 24  # further values
APART = 12.0  # of a number and the further values behind it
TALL = 1.7 * SIZE  # a line of numbers that is no taller is short


@dataclass(frozen=True, slots=True)
class Label:
    """Whose calculation a line is, in the report's language: a part ("front bearing"), and which of its calculations
    ("twice the load")."""

    part: str
    variant: str = ""

    def text(self) -> str:
        return f"{self.part}, {self.variant}" if self.variant else self.part


Labelled = tuple[Label, Line]


@dataclass(frozen=True, slots=True)
class Place:
    """The one element of arrays that is followed through a calculation, and what it is called."""

    index: tuple[int, ...]
    words: str


@dataclass(slots=True)
class EquationEntry:
    """One formula with its lines, each with the part it was computed for."""

    formula: Equation
    lines: list[Labelled]
    places: Mapping[Line, Place] = field(default_factory=dict)  # of its lines whose values are arrays
    taken: Mapping[Line, int] = field(default_factory=dict)  # digits with which others take the values of lines
    parts: int = PARTS  # of them with their numbers, the others with their values
    full: bool = False  # whether all parts have their numbers


def column_of_signs(entries: list[EquationEntry]) -> float:
    """Where the equals signs of formulas stand that have the labels of their parts before them."""
    full = {lines[0][0] for entry in entries for lines in list(_parts(entry.lines).values())[:PARTS]}
    return min(max(SIGN, max(text_box(label.text(), NOTE.size).width for label in full) + 8.0), 0.34 * COLUMN)


def entry_blocks(
    entry: EquationEntry, source: str, sign: float, *, labelled: bool, context: Context, gap: float = GAP
) -> list[Block]:
    """A formula with its lines of numbers.

    Of each part ("front bearing") the first calculation stands with its numbers; its others ("front bearing, twice the
    load") with their values only.  Of more than two parts only the first is written out, unless the numbers fit on a
    line."""
    called = symbols_put_in([line for _, line in entry.lines])
    first = shown(entry.lines[0][1], context.say, entry, called)
    alike = len({symbol_of(line) for _, line in entry.lines}) == 1
    name = first.symbol if alike else entry.formula.symbol
    indexed = BETWEEN.join(dict.fromkeys(noted_line(context, line, name, called) for _, line in entry.lines))
    head = symbol(name, SIZE)
    sign = max(sign, head.width + 4.0)
    if len(entry.lines) == 1 and not labelled:
        copied = f"{spoken(first)} {_copied_numbers(first)}"
        whole = [("", line) for line in _whole(first, sign)]
        alone = _block(head, whole, sign, source, copied, Formula(first, (("", first),), "", source), gap=gap)
        return [replace(alone, indexed=indexed)]
    rows: list[tuple[str, Box]] = [("", line) for line in _formula_lines(first, sign)]
    parts = list(_parts(entry.lines).values())
    groups: list[tuple[list[tuple[str, Box]], list[str], list[tuple[str, Shown]], str]] = []
    rest: list[Labelled] = []
    for n, calculations in enumerate(parts):
        if n >= entry.parts and not entry.full:
            rest += calculations
            continue
        own_rows, words, others, numbers = _calculated(calculations, sign, context.say, entry, labelled=labelled)
        if n and len(parts) > 2 and not entry.full and (len(own_rows) > 1 or own_rows[0][1].height > TALL):
            rest += calculations
            continue
        more = _others(others, own_rows, numbers, context)
        groups.append((_with_others(own_rows, more, sign), [*words, more], numbers, more))
    if more := _others(rest, [], [], context, written=entry.lines[0][0].variant):
        own_rows, words, numbers, before = groups.pop()
        groups.append(
            (_with_others(own_rows, more, sign), [*words, more], numbers, " ".join(filter(None, (before, more))))
        )
    (own_rows, words, numbers, more), *later = groups
    content = Formula(first, tuple(numbers), more, source)
    apart = "; " if numbers[0][0] else " "
    copied = spoken(first) + apart + _copied(words)
    first_block = _block(head, rows + own_rows, sign, source, copied, content, gap=gap)
    return [
        replace(first_block, indexed=indexed),
        *(
            _block(None, own_rows, sign, "", _copied(words), Formula(None, tuple(numbers), more, ""), gap=LEAD)
            for own_rows, words, numbers, more in later
        ),
    ]


def _calculated(
    calculations: list[Labelled], sign: float, say: Language, entry: EquationEntry, *, labelled: bool
) -> tuple[list[tuple[str, Box]], list[str], list[Labelled], list[tuple[str, Shown]]]:
    """The first calculation of a part with its numbers: its rows, the same as words, the part's other calculations, and
    its lines."""
    full = calculations[0][0]
    rows: list[tuple[str, Box]] = []
    words: list[str] = []
    said: set[str] = set()
    others: list[Labelled] = []
    lines: list[tuple[str, Shown]] = []
    for label, line in calculations:
        if label != full or len(words) >= MOST:
            others.append((label, line))
        elif (again := spoken_numbers(shown_line := shown(line, say, entry))) not in said:
            name = label.text() if labelled and not words else ""
            said.add(again)
            words.append(_copied_numbers(shown_line, name))
            lines.append((name, shown_line))
            rows += [(name if i == 0 else "", r) for i, r in enumerate(_number_lines(shown_line, sign))]
    return rows, words, others, lines


def _with_others(rows: list[tuple[str, Box]], more: str, sign: float) -> list[tuple[str, Box]]:
    """The rows of a part with the values of its other calculations: behind its last number where there is room, else
    below."""
    if not more:
        return rows
    more_lines, (label, last) = text_lines(more, NOTE, COLUMN - sign, 12), rows[-1]
    if len(more_lines) == 1 and last.width + APART + more_lines[0].width <= COLUMN - sign:
        return [*rows[:-1], (label, row([last, more_lines[0]], APART))]
    return [*rows, *(("", line) for line in more_lines)]


def _parts(labelled: list[Labelled]) -> dict[str, list[Labelled]]:
    """The lines by part."""
    parts: dict[str, list[Labelled]] = {}
    for label, line in labelled:
        parts.setdefault(label.part, []).append((label, line))
    return parts


def _others(
    rest: list[Labelled],
    rows: list[tuple[str, Box]],
    numbers: list[tuple[str, Shown]],
    context: Context,
    written: str = "",
) -> str:
    """The further calculations of a part by their values; what says the same as the one in full is left out.

    Those of other parts are of the kind that is `written` out above, "twice the load", unless they say another.
    """
    known = {with_unit(line.value, line.unit) for _, line in numbers}
    by_part: dict[str, dict[str, None]] = {}
    seen: set[tuple[str, str]] = set()  # a part's values: what a variant has in common with the part is not repeated
    unit = ""
    for label, line in rest:
        value, of = result(line)
        value = context.say.number(value)
        if with_unit(value, of) not in known:
            if label.variant and (label.part, value) in seen:
                continue
            seen.add((label.part, value))
            variant = "" if label.variant == written else label.variant
            by_part.setdefault("" if rows else label.part, {})[f"{variant} {value}".strip()] = None
            unit = of
    if not by_part:
        return ""
    listed = [f"{part} {', '.join(values)}".strip() for part, values in by_part.items()]
    more = f"; {context.text('more', count=len(listed) - LISTED)}" if len(listed) > LISTED else ""
    return context.text("others", values=with_unit("; ".join(listed[:LISTED]), unit) + more)


def spoken(line: Shown) -> str:
    """The formula of a line as plain text, for whoever copies it."""
    if line.formula is None:
        return f"{plain(line.symbol)}: {line.shows}"
    return plain(line.symbol) if _named_alike(line) else f"{plain(line.symbol)} = {text(line.formula)}"


def _named_alike(line: Shown) -> bool:
    """Whether a value is called what it is, |C| or l/d, which need not be said twice."""
    return line.formula is not None and text(line.formula) == plain(line.symbol)


def spoken_numbers(line: Shown) -> str:
    value = f"= {line.result}"
    return value if line.numbers is None else f"= {text(line.numbers)} {value}"


def _copied_numbers(line: Shown, part: str = "") -> str:
    """All that stands on a line of numbers: whose they are, and of which place."""
    return f"{f'{part}: ' if part else ''}{spoken_numbers(line)} {line.where}".strip()


def _copied(words: list[str]) -> str:
    """What stands below each other as one line."""
    return "; ".join(filter(None, words))


def _equals(pieces: list[SetPiece]) -> list[SetPiece]:
    """Pieces after an equals sign, before which a line may break at best."""
    return [SetPiece(row([text_box("=", SIZE), space(0.28 * SIZE)]), 0.0), *pieces]


def _value(line: Shown) -> list[SetPiece]:
    words = line.result
    boxes = [text_box("=", SIZE), space(0.28 * SIZE), text_box(words, SIZE)]
    if line.where:
        boxes += [space(6.0), text_box(line.where, NOTE.size, colour=NOTE.colour)]
    return [SetPiece(space(0.34 * SIZE)), SetPiece(row(boxes), -0.5)]


def shown(line: Line, say: Language, entry: EquationEntry, called: Mapping[str, str] | None = None) -> Shown:
    """A line of an entry as the report shows it; `called`: the symbols of the values that stand in its formula."""
    place = entry.places.get(line)
    shown_line = show(line, place.index if place else None, called, entry.taken.get(line, 0))
    number = say.number
    where = place.words if place and shown_line.where else say(shown_line.where)
    return replace(
        shown_line,
        shows=Name(say(replace(shown_line, given=number(shown_line.given)).how)),
        given="",
        where=Name(where),
        value=number(shown_line.value),
        degrees=number(shown_line.degrees),
        formula=shown_line.formula and respelled(shown_line.formula, number),
        numbers=shown_line.numbers and respelled(shown_line.numbers, number),
    )


def _formula_lines(line: Shown, sign: float) -> list[Box]:
    width = COLUMN - sign
    if line.formula is None:
        return text_lines(line.shows, CELL, width)
    inner = width - 1.2 * SIZE
    return _hung(lines(_equals(formula(line.formula, SIZE, inner)), width))


def _number_lines(line: Shown, sign: float) -> list[Box]:
    width = COLUMN - sign
    if line.numbers is None:
        return [row([p.box for p in _value(line)[1:]])]
    return _hung(lines([*_equals(formula(line.numbers, SIZE, width - 1.2 * SIZE)), *_value(line)], width))


def _whole(line: Shown, sign: float) -> list[Box]:
    """Formula, numbers and value: on one line where they fit."""
    width = COLUMN - sign
    if line.formula is None or line.numbers is None:
        return [*_formula_lines(line, sign), *_number_lines(line, sign)]
    same = _named_alike(line)
    head = [] if same else _equals(formula(line.formula, SIZE, width - 1.2 * SIZE))
    tail = [*_equals(formula(line.numbers, SIZE, width - 1.2 * SIZE)), *_value(line)]
    both = [*head, *([] if same else [SetPiece(space(0.34 * SIZE))]), *tail]
    if sum(p.box.width for p in both) <= width:
        return [row([p.box for p in both])]
    return [*_hung(lines(head, width)), *_hung(lines(tail, width))]


def _hung(set_lines: list[Box]) -> list[Box]:
    """Lines after the first go in a little, behind the equals sign."""
    indent = 1.1 * SIZE
    hung = set_lines[:1]
    for line in set_lines[1:]:
        starts_equal = bool(line.marks) and line.marks[0][0] == "text" and line.marks[0][3] == "="
        hung.append(line if starts_equal or line.width + indent > COLUMN else row([space(indent), line]))
    return hung


def _block(
    head: Box | None, rows: list[tuple[str, Box]], sign: float, source: str, words: str, content: Formula, *, gap: float
) -> Block:
    """One formula as a block: its lines below each other, the source to the right."""
    beside = text_lines(source, SOURCE, SOURCE_WIDTH) if source else []
    labels = [text_lines(label, NOTE, sign - 6.0, 3) if label else [] for label, _ in rows]
    bases: list[float] = []
    y = labelled = 0.0  # where the next row begins, and where the label above it ends: beside rows that have none
    for i, (_, line) in enumerate(rows):
        up, down = (
            max(line.up, 0.76 * SIZE, head.up if head is not None and i == 0 else 0.0),
            max(line.down, 0.24 * SIZE),
        )
        y = (max(y, labelled + LEAD) if labels[i] and labelled else y) + up
        bases.append(y)
        if labels[i]:
            labelled = y + (len(labels[i]) - 1) * NOTE.leading + 0.24 * SIZE
        y += down + (LEAD if i < len(rows) - 1 else 0.0)
    y = max(y, labelled)
    lift = bases[0] - SOURCE.size * 0.76
    height = max(y, (lift if lift > 0 else 0.0) + len(beside) * SOURCE.leading)
    words = clean(words)
    start = ("begin", 0.0, 0.0, words)

    def draw(pen: Pen, top: float) -> None:
        pen.put(Box(0.0, 0.0, 0.0, (start,)), 0.0, top)
        if head is not None:
            pen.put(head, 0.0, top - bases[0])
        for (_, line), label, base in zip(rows, labels, bases):
            for i, part in enumerate(label):
                pen.put(part, 0.0, top - base - i * NOTE.leading)
            pen.put(line, sign, top - base)
        pen.put(Box(0.0, 0.0, 0.0, (("end", 0.0, 0.0),)), 0.0, top)
        with pen.tagged(Tag("P")):
            for i, part in enumerate(beside):
                pen.put(part, WIDTH - SOURCE_WIDTH, top - lift - i * SOURCE.leading - 0.76 * SOURCE.size)

    return Block(height, draw, gap, content=content, tag=Tag(FORMULA, alt=words))
