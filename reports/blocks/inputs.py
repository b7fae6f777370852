# SPDX-License-Identifier: Apache-2.0
"""The inputs of a step as tables: single quantities in rows, like parts (front and rear, wheels) in columns beside each
other."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import MISSING, dataclass, replace
from typing import Any

from calc.design.addresses import (
    Table,
    arrays_of,
    as_table,
    asked_keys,
    element_title,
    step_at,
    tables_of,
    value_at,
)
from calc.design.model import SHARED_OF_ROWS, Design
from calc.design.names import choice_word
from calc.design.upgrade import is_twin
from calc.locale import Language
from calc.sheet.expression import symbol as greek
from calc.sheet.number import SUPERSCRIPTS
from calc.sheet.quantity import Key, Quantity, keys
from calc.sheet.step import Step
from calc.sheet.text import Text
from calc.sheet.units import UNITS

from ..context import Context
from ..typesetting.pagination import Block, bullet, paragraph
from ..typesetting.prose import BODY, CELL, HEADER, KEY, NOTE
from ..typesetting.tables import Cell, Column, Row, longest, named_table, noted_below, table
from ..typesetting.typeset import symbol
from .nomenclature import noted
from .values import paired_table

ACROSS = 5  # parts beside each other
FLAT = 8  # a list of parts with at most so many quantities stands one part a row
# how a help begins to say, in each language, what the program does then
LEFT_OUT = re.compile(r"\b(?:Left out|Se omess[oaei]): ")
REMARK = 300  # characters of a comment that are printed
# how a comment begins, by which a reader knows it
ASSUMED = re.compile(r"(?:assum|estimat|guess|ipo[tz]|suppost|stima)", re.IGNORECASE)
LONG, ENDS = 6, 2  # of a list with more parts so many of either end are shown, unless everything is asked for


def exact(value: Any, *, rounded: bool = False) -> str:
    """A number as the file gives it, with a true minus and powers of ten; `rounded`: without the last digits of a
    conversion."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (list, tuple)):
        parts = [exact(v, rounded=rounded) for v in value]
        return "; ".join(f"[{part}]" if isinstance(v, (list, tuple)) else part for v, part in zip(value, parts))
    if not isinstance(value, (int, float)):
        return str(value)
    # + 0: minus nought is nought
    mantissa, _, power = (f"{value + 0:.12g}" if rounded else repr(value + 0)).partition("e")
    written = mantissa.replace("-", "−")
    return f"{written}·10{str(int(power)).translate(SUPERSCRIPTS)}" if power else written


PLAIN = re.compile(r"−?\d+(\.\d+)?")


def alike(texts: Sequence[str]) -> list[str]:
    """Numbers of one quantity as the file gives them, each with as many decimals as the one that has most; of whole
    numbers none."""
    fractions = [(found[1] or "").rstrip("0") if (found := PLAIN.fullmatch(text)) else "" for text in texts]
    most = max(map(len, fractions), default=0)

    def padded(text: str) -> str:
        if not PLAIN.fullmatch(text):
            return text
        whole, _, fraction = text.partition(".")
        fraction = fraction.rstrip("0")
        return f"{whole}.{fraction.ljust(most - 1, '0')}" if most > 1 else whole

    return [padded(text) for text in texts]


@dataclass(frozen=True, slots=True)
class _Given:
    """What a document says to one key, or what the program takes instead."""

    text: str = ""
    number: bool = False  # or several; any other text stands as the file has it
    default: bool = False
    left_out: bool = False
    nothing: bool = False  # and says nothing there, by a choice of the same table


def _given(key: Key, data: dict[str, Any]) -> _Given:
    if (value := data.get(key.key)) is not None:
        return _Given(_written(key.about, value), not isinstance(value, str))
    if key.about.where is not None and not key.about.where.holds(data):
        return _Given(left_out=True, nothing=True)
    default = key.field.default
    if default is None or default is MISSING or default == ():
        return _Given(left_out=True)
    if isinstance(default, float):
        default = UNITS[key.about.unit].shown(default)
    return _Given(_written(key.about, default, rounded=True), not isinstance(default, str), default=True)


def _written(about: Quantity, value: Any, *, rounded: bool = False) -> str:
    """A value as the file has it; a choice in a word."""
    if isinstance(value, bool):
        return Text("yes") if value else Text("no")
    return choice_word(value) if about.kind == "choice" and isinstance(value, str) else exact(value, rounded=rounded)


def _symbol(context: Context, about: Quantity) -> Cell:
    if not about.symbol:
        return Cell()
    name = greek(about.symbol)
    return Cell(box=symbol(name, CELL.size), indexed=noted(context, name, context.say(about.label), about.unit))


def _column(about: Quantity, say: Language) -> Column:
    """A column headed by label and unit; numbers to the right."""
    unit = f", {about.unit}" if about.unit else ""
    return Column(f"{say(about.label)}{unit}", "r" if about.kind in ("number", "integer") else "l")


def _left_out(key: Key, say: Language) -> str:
    """The label of a key that is left out, with what the help says about that."""
    explanation = LEFT_OUT.split(say(key.about.help))[-1].rstrip(".") if LEFT_OUT.search(key.about.help) else ""
    label = say(key.about.label)
    label = label if label[1:2].isupper() else label[:1].lower() + label[1:]
    return f"{label} ({explanation})" if explanation else label


def _part_name(cls: type | None, part: dict[str, Any], i: int, say: Language) -> str:
    """What a part of a list is called: its name, the wheels of a mesh, else its number."""
    if "driver" in part and "driven" in part:
        return f"{part['driver']}–{part['driven']}"
    return say(element_title(cls, str(part.get("name", i + 1))))


class _Tables:
    """Collects the tables of one step."""

    def __init__(self, context: Context, step: Step) -> None:
        self.context, self.step = context, step.key
        self.words, self.text, self.say, self.all = context.words, context.text, context.say, context.audit
        self.blocks: list[Block] = []
        self.left_out: list[str] = []
        self.default = False

    def plain(self, title: str, cls: type, data: dict[str, Any], prefix: str) -> None:
        """One table of inputs, and after it those inside it."""
        rows: list[tuple[str | Cell, ...]] = []
        inner: list[Key] = []
        for key in self.keys(cls, data):
            if key.about.kind in ("table", "tables"):
                inner.append(key)
                continue
            given = _given(key, data)
            if given.left_out:
                if not given.nothing:
                    self.left_out.append(_left_out(key, self.say))
                continue
            rows.append(
                (
                    self.say(key.about.label),
                    _symbol(self.context, key.about),
                    *self.values([given]),
                    key.about.unit,
                    Cell(f"{prefix}.{key.key}", KEY),
                )
            )
        if rows and not self.all:
            self.blocks += paired_table(self.context, title, [row[:4] for row in rows])
        elif rows:
            w = self.words
            columns = (
                Column(w["quantity"], width=138.0),
                Column(w["symbol"], width=42.0),
                Column(w["value"], "r", width=104.0),
                Column(w["unit"], width=40.0),
                Column(w["key"]),
            )
            self.blocks += named_table(title, columns, rows)
        self.inside(inner, data, prefix)

    def keys(self, cls: type, data: dict[str, Any]) -> list[Key]:
        """Those of a table that the step asks for."""
        return asked_keys(cls, data, self.context.document.data, self.step)

    def inside(self, inner: list[Key], data: dict[str, Any], prefix: str, whose: str = "") -> None:
        """Tables in a table: neighbours of one class stand beside each other.  `whose`: the part that they belong
        to."""

        def title(key: Key) -> str:
            return f"{self.say(key.about.label)}: {whose}" if whose else self.say(key.about.label)

        n = 0
        while n < len(inner):
            key = inner[n]
            content = data.get(key.key)
            if key.about.kind == "tables":
                named = [(_part_name(key.about.table, p, i, self.say), p) for i, p in enumerate(content or [])]
                self.parts(title(key), key.about.table, named, f"{prefix}.{key.key}")
                n += 1
                continue
            like = [k for k in inner[n:] if k.about.table is key.about.table and k.about.kind == "table"]
            n += len(like)
            asked = [k for k in like if data.get(k.key) is not None]
            if len(asked) > 1:
                self.parts("", key.about.table, [(self.say(k.about.label), data[k.key]) for k in asked], prefix)
            else:
                for k in asked:
                    self.plain(title(k), k.about.table, data[k.key], f"{prefix}.{k.key}")  # type: ignore[arg-type]

    def parts(self, title: str, cls: type | None, parts: list[tuple[str, dict[str, Any]]], prefix: str) -> None:
        """Like parts: as rows where they say little each, else as columns; the tables inside them follow."""
        if not parts or cls is None:
            return
        self.beside(title, cls, parts)
        inner = [key for key in self.keys(cls, {}) if key.about.kind in ("table", "tables")]
        for i, (name, data) in enumerate(parts):
            self.inside(inner, data, f"{prefix}.{data.get('name', i)}" if title else prefix, name)

    def beside(self, title: str, cls: type, parts: list[tuple[str, dict[str, Any]]]) -> None:
        total = len(parts)
        between = 0 if self.all or total <= LONG else total - 2 * ENDS
        parts = [*parts[:ENDS], *parts[-ENDS:]] if between else parts
        shown: list[tuple[Key, list[_Given]]] = []
        for key in self.keys(cls, {}):
            given = [_given(key, data) for _, data in parts]
            if key.key == "name" or key.about.kind in ("table", "tables"):
                continue
            if all(g.left_out for g in given):
                if (
                    not all(g.nothing for g in given) and key not in SHARED_OF_ROWS
                ):  # which is said of what all bearings share
                    self.left_out.append(_left_out(key, self.say))
            else:
                shown.append((key, given))
        if not shown:
            return
        if len(shown) <= FLAT and (len(parts) > ACROSS or len(shown) <= 3):
            self.rows(title, [name for name, _ in parts], shown, between)
        else:
            self.columns(title, [name for name, _ in parts], shown)
            if between:
                self.blocks = noted_below(self.blocks, self.between(between, total))

    def rows(self, title: str, names: list[str], shown: list[tuple[Key, list[_Given]]], between: int = 0) -> None:
        """One part a row; `between`: how many are left out in the middle."""
        head = [Column(""), *(_column(k.about, self.say) for k, _ in shown)]
        each = [self.values(given) for _, given in shown]
        rows: list[Row] = [(name, *(cells[i] for cells in each)) for i, name in enumerate(names)]
        if between:
            rows.insert(ENDS, (self.between(between, len(names) + between), *("…" for _ in shown)))
        self.blocks += named_table(title, head, rows)

    def between(self, count: int, total: int) -> str:
        return f"… {self.text('between', count=count, total=total)}"

    def columns(self, title: str, names: list[str], shown: list[tuple[Key, list[_Given]]]) -> None:
        w = self.words
        for start in range(0, len(names), ACROSS):
            some = names[start : start + ACROSS]
            wide = 104.0 if len(some) < 3 else None
            columns = (Column(name, "r", width=wide) for name in some)
            head = (Column(w["quantity"]), Column(w["symbol"], width=42.0), *columns, Column(w["unit"], width=30.0))
            rows: list[Row] = [
                (
                    self.say(k.about.label),
                    _symbol(self.context, k.about),
                    *self.values(given)[start : start + ACROSS],
                    k.about.unit,
                )
                for k, given in shown
            ]
            name = title if not start else self.text("two", name=title)
            self.blocks += named_table(name if title else "", head, rows)

    def values(self, given: Sequence[_Given]) -> list[Cell]:
        """Those of one quantity."""
        texts = alike([one.text if one.number else "" for one in given])
        return [self.value(replace(one, text=text) if one.number else one) for one, text in zip(given, texts)]

    def value(self, given: _Given) -> Cell:
        if given.left_out:
            return Cell("–")
        self.default |= given.default
        text = self.say.number(given.text) if given.number else self.say(given.text)
        return Cell(f"{text} *" if given.default else text)


def beside_own(rows: list[Table], shared: Table) -> list[Table]:
    """Bearings with what all share of supply and seat, where one of them has its own."""
    own = {entry.key for entry in SHARED_OF_ROWS if any(entry.key in row for row in rows)}
    return [{key: shared[key] for key in own & shared.keys()} | row for row in rows]


def input_blocks(context: Context, step: Step) -> list[Block]:
    """The inputs of one step, with what the program takes where the file says nothing."""
    data = context.document.data
    there = [table for table in tables_of(data, step) if context.asks(table[2])]
    arrays = []
    for about, elements, key in arrays_of(data, step):
        shaft = as_table(value_at(data, key.rpartition(".")[0], whole=True))
        if context.asks(key) and context.shaft in ("", shaft.get("name")):
            arrays.append((about, elements, key, is_twin(shaft)))
    if not there and not arrays:
        return []
    tables = _Tables(context, step)
    for cls, content, key in there:
        tables.plain(str(content.get("name", "")) if len(there) > 1 else "", cls, content, key)
    for about, elements, key, of_twin in arrays:
        said = list(tables.left_out)
        elements = elements if of_twin else beside_own(elements, as_table(data.get(step.key)))
        named = [(_part_name(about.table, part, i, context.say), part) for i, part in enumerate(elements)]
        tables.parts(context.say(about.label), about.table, named, key)
        if of_twin:
            tables.left_out = said  # it is as its original's
    w = context.words
    if tables.default:
        tables.blocks = noted_below(tables.blocks, w["defaults"], gap=3.0)
    if context.audit:
        tables.blocks += remarks(context, step.key)
    if tables.left_out and context.audit:
        tables.blocks += paragraph(
            context.text("left_out", names="; ".join(dict.fromkeys(tables.left_out))), CELL, gap=1.0
        )
    return tables.blocks


def remarks(context: Context, *tables: str) -> list[Block]:
    """What the author of the design says in the file beside the keys of tables; without an audit only what is
    assumed."""
    by_comment: dict[str, list[str]] = {}  # a comment → the keys beside which it stands
    for key, words in context.document.remarks.items():
        of_step = step_at(context.document.data, key)
        if of_step in tables and context.asks(key) and (context.audit or ASSUMED.match(words)):
            by_comment.setdefault(words if len(words) <= REMARK else f"{words[:REMARK]}…", []).append(
                _called(context, key)
            )
    listing = " · ".join(f"{'; '.join(called)} “{words}”" for words, called in by_comment.items())
    return bullet(context.text("remarks", remarks=listing), BODY, gap=0.7) if by_comment else []


def _called(context: Context, key: str) -> str:
    """A key by the label of its field, and by the parts that it is of: `Allowance of the span, idler`."""
    here: Any = context.document.data
    cls: type = Design
    called: list[str] = []
    for part in key.split("."):
        if isinstance(here, list):  # an element in place of its array
            here = here[int(part)]
            called[-1] = _part_name(cls, here, int(part), context.say)
            continue
        known, here = keys(cls).get(part), here.get(part) if isinstance(here, dict) else None
        # a table of free form has keys of its own
        called.append(part if known is None else context.say(known.about.label))
        cls = known.about.table or cls if known is not None else cls
    top = context.document.data.get(key.partition(".")[0])
    several = isinstance(top, list) and len(top) > 1  # shafts, else what it is of goes without saying
    return ", ".join(reversed(called if several else called[1:] or called))


# --- oils and materials


def used_materials(context: Context) -> tuple[list[Any], list[Any]]:
    """The oils and materials that the design names, in the order of their first naming."""
    design = context.design
    named: dict[str, str] = {}  # each with its catalogue

    def look(kind: type, here: Any) -> None:
        for part in here if isinstance(here, list) else [here]:
            for key, content in part.items():
                if (known := keys(kind).get(key)) is None:
                    continue
                if known.about.table is not None:
                    look(known.about.table, content)
                elif known.about.catalogue:
                    named.setdefault(content, known.about.catalogue)

    for _, step, _ in context.steps():
        there = list(tables_of(context.document.data, step))
        for cls, data, _ in there:
            look(cls, data)
        if not there:
            continue
        for key in keys(step.inputs).values():  # a default counts as named
            if key.about.catalogue and isinstance(key.field.default, str):
                named.setdefault(key.field.default, key.about.catalogue)
    if design.bearings is not None:  # what bushes and shells are of where the file does not say it
        for row in (row for shaft in design.shafts for row in shaft.bearings if row.ringed):
            named.setdefault(row.backing, "materials")
    oils, materials = design.oils, design.materials
    return (
        [oils[n] for n, catalogue in named.items() if catalogue == "oils" and n in oils],
        [materials[n] for n, catalogue in named.items() if catalogue != "oils" and n in materials],
    )


def material_blocks(context: Context) -> list[Block]:
    oils, materials = used_materials(context)
    return [
        *_catalogue(context, "oil", oils),
        *_catalogue(context, "material", materials),
        *remarks(context, "oil", "material"),
    ]


def _catalogue(context: Context, kind: str, entries: Sequence[Any]) -> list[Block]:
    if not entries:
        return []
    numbers = [
        key
        for key in keys(entries[0].__class__).values()
        if key.key not in ("name", "source")
        and key.about.kind != "tables"
        and any(getattr(e, key.attribute) is not None for e in entries)
    ]
    head = [Column(context.words[kind])]
    for key in numbers:
        column = _column(key.about, context.say)
        head.append(replace(column, width=max(52.0, longest(column.header, HEADER))))
    rows: list[Row] = []
    for entry in entries:
        cells: list[str | Cell] = [Cell(entry.name, under=(context.say(Text(entry.source)), NOTE))]
        for key in numbers:
            value = getattr(entry, key.attribute)
            known = UNITS[key.about.unit].shown(value) if isinstance(value, float) else value
            if known is None:
                cells.append("–")
            else:
                is_text = isinstance(known, str)
                cells.append(
                    context.say(_written(key.about, known))
                    if is_text
                    else context.say.number(exact(known, rounded=True))
                )
        rows.append(cells)
    return table(head, rows, gap=6.0)
