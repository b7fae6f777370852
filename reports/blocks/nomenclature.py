# SPDX-License-Identifier: Apache-2.0
"""The nomenclature at the end: every symbol of a chapter with its meaning, its unit and the first page on which it stands.

Symbols are noted as they are set, in formulas, tables of values and inputs; nothing is listed by hand.
"""

from __future__ import annotations

import re
from itertools import takewhile
from math import isclose
from typing import TYPE_CHECKING

from calc.design.addresses import quantities, quantity_of, value_at
from calc.sheet.errors import BadInput
from calc.sheet.expression import result, symbol, symbol_of
from calc.sheet.quantity import Quantity
from calc.sheet.trace import Line
from calc.sheet.value import leaves, link_of

from ..setting.boxes import text
from ..setting.flow import Block, heading, paragraph
from ..formula_words import BY_NAME
from ..paper import WIDTH
from ..setting.prose import GROUP, NOTE, lines, run
from ..setting.symbols import BETWEEN, Symbol
from ..setting.typeset import symbol as set_symbol

if TYPE_CHECKING:
    from ..context import Context
    from ..setting.pen import Pen

COLUMNS, GUTTER = 2, 10.0
EACH = (WIDTH - (COLUMNS - 1) * GUTTER) / COLUMNS
SYMBOL, UNIT, PAGE = 30.0, 26.0, 11.0  # width of what stands beside a meaning
MEANING = EACH - SYMBOL - UNIT - PAGE - 4.0
CUTS = (", ", " (", ": ")  # where a meaning may end
PREPOSITION = 3  # letters at most


def noted(context: Context, name: str, label: str, unit: str) -> str:
    """Note a symbol of a table, which says what it means; the engineer's report has only those of formulas."""
    return _noted(context, name, label, unit) if context.audit else ""


def _noted(context: Context, name: str, meaning: str, unit: str) -> str:
    """Note a symbol of the chapter at hand; gives the name under which its page is found."""
    if not name or not context.chapter:
        return ""
    return context.symbols.setdefault((context.chapter, name), Symbol(context.chapter, name, meaning, unit)).indexed


def noted_line(context: Context, line: Line) -> str:
    """Note the symbols of a formula: that of its result, and those in it whose origin is known."""
    names = [_noted(context, symbol_of(line), *_meaning(context, line))]
    formula = line.formula
    for parameter, value in line.arguments.items() if not formula.shows else ():
        written = formula.names.get(parameter) or symbol(parameter)
        known = context.symbols.get((context.chapter, written))
        if known is not None:
            names.append(known.indexed)
        elif (told := _origin(context, written, value)) is not None:
            names.append(_noted(context, written, *told))
    return BETWEEN.join(filter(None, dict.fromkeys(names)))


def _meaning(context: Context, line: Line) -> tuple[str, str]:
    """What a line gives: the value of this symbol, or what its source says that it is; and its unit."""
    name, unit = symbol_of(line), result(line)[1]
    if label := _labels(context).get((context.chapter, name)):
        return label, unit
    if (id := context.chains.value_of.get(line)) is not None and context.values[id].symbol == name:
        return context.say(context.values[id].label), unit
    _, _, told = context.say(line.formula.source).partition(": ")
    return _short(told) if told else context.say(BY_NAME[line.formula.__name__]), unit


def _short(words: str) -> str:
    """What a source says first; without what follows a mark, where it is too long for a line."""
    words = words.partition("; ")[0]
    while run(words, NOTE).width > MEANING and (cut := max(map(words.rfind, CUTS))) > 8:
        words = words[:cut]
    return words


def _origin(context: Context, name: str, value: object) -> tuple[str, str] | None:
    """What an argument is, where it comes from one line or one input."""
    found = leaves(link_of(value))
    if len(found) != 1:
        return None
    if isinstance(found[0], Line):
        return _meaning(context, found[0])
    try:
        about = quantity_of(context.document.data, found[0])
    except BadInput:
        return None
    own = found[0].startswith(f"{context.chapter}.") and about.symbol and symbol(about.symbol) == name
    if not own and not _same(value, value_at(context.document.data, found[0]), about):
        return None  # what is made of an input is something else: the tolerance of a diameter
    return (not own and _labels(context).get((context.chapter, name))) or context.say(about.label), about.unit


def _same(value: object, given: object, about: Quantity) -> bool:
    """Whether an argument is an input as it is given, or one of its numbers; what is left out is not compared."""
    if given is None or isinstance(given, str) or not isinstance(value, (int, float)):
        return True
    numbers = [one for one in (given if isinstance(given, list) else [given]) if isinstance(one, (int, float))]
    return any(isclose(value, about.units.inside(one), rel_tol=1e-9) for one in numbers)


def _labels(context: Context) -> dict[tuple[str, str], str]:
    """What the values and inputs with a symbol are called, by chapter and symbol; "its place" goes on from another name."""
    if not context.labels:
        named = [(value.id, value.symbol, value.label) for value in context.values.values()]
        named += [(key, symbol(about.symbol) if about.symbol else "", about.label) for key, about in quantities(context.document.data)]
        for id, name, label in named:
            if name and not label[:1].islower():
                of, told = (id.partition(".")[0], name), context.say(label)
                context.labels[of] = _in_common(context.labels.get(of, told), told, id)
    return context.labels


def _in_common(one: str, other: str, id: str) -> str:
    """What a symbol is called without the part that it is of, the form factor of each wheel; `id`: of the value that is called `other`."""
    own, words = one.split(), other.split()
    same = [a for a, b in takewhile(lambda pair: pair[0].strip(",") == pair[1].strip(","), zip(own, words))]
    if one == other or len(same) == len(words) or words[len(same)].strip(",") not in re.split(r"[._]", id):
        return one
    while same and len(same[-1]) <= PREPOSITION:
        del same[-1]
    return " ".join(same).rstrip(",") if len(same) > 1 else one


def nomenclature_blocks(context: Context) -> list[Block]:
    """The symbols of each chapter in two columns, row by row."""
    made = paragraph(context.words["nomenclature_note"], NOTE, gap=1.0) if context.symbols else []
    for number, step, _ in context.steps():
        own = sorted((one for one in context.symbols.values() if one.chapter == step.key), key=_order)
        rows = [_Entry(one) for one in own]
        if rows:
            made += heading(f"{number}  {context.say(step.title)}", GROUP, gap=3.0, after=0.0)
            made += [_row(rows[n : n + COLUMNS]) for n in range(0, len(rows), COLUMNS)]
    return made


def _order(one: Symbol) -> tuple[bool, str, str]:
    """Latin letters before Greek ones, each with its capital."""
    base = one.name.lstrip("|∠ΔΣ(")
    return base[:1] > "z", base.casefold(), one.name


class _Entry:
    """One symbol with what it means."""

    def __init__(self, one: Symbol) -> None:
        self.one, self.symbol = one, set_symbol(one.name, NOTE.size)
        self.at = max(SYMBOL, self.symbol.width + 3.0)
        self.unit = text(one.unit, NOTE.size, NOTE.face, NOTE.colour)
        self.right = EACH - PAGE - max(UNIT, self.unit.width + 2.0)
        self.meaning = lines(one.meaning[:1].upper() + one.meaning[1:], NOTE, self.right - 3.0 - self.at)

    def draw(self, pen: Pen, x: float, y: float) -> None:
        base = y - 0.78 * NOTE.leading
        pen.put(self.symbol, x, base)
        for n, line in enumerate(self.meaning):
            pen.put(line, x + self.at, base - n * NOTE.leading)
        pen.put(self.unit, x + self.right, base)
        if pages := pen.places.get(self.one.indexed):
            number = text(str(pages[0]), NOTE.size, NOTE.face, NOTE.colour)
            pen.put(number, x + EACH - number.width, base)
            pen.link(x, base - 2.0, EACH, NOTE.leading, f"page-{pages[0]}", self.one.name)


def _row(entries: list[_Entry]) -> Block:
    def draw(pen: Pen, y: float) -> None:
        for n, entry in enumerate(entries):
            entry.draw(pen, n * (EACH + GUTTER), y)

    return Block(max(len(entry.meaning) for entry in entries) * NOTE.leading, draw)
