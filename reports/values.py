# SPDX-License-Identifier: Apache-2.0
"""The results of a step as tables: parts with the same results (order 1, order 2; front, rear) beside each other."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from calc.sheet.number import short
from calc.sheet.quantity import Published
from calc.sheet.step import Outcome

from .context import Context
from .flow import Block, paragraph
from .prose import CELL, NOTE
from .tables import Cell, Column, Row, named_table, table
from .typeset import symbol

ACROSS = 6
ALIKE = 0.6  # share of results in common that puts two parts beside each other


@dataclass(slots=True)
class _Part:
    """The results under one address."""

    prefix: str
    values: dict[str, Published] = field(default_factory=dict)

    @property
    def zero(self) -> bool:
        return all(v.shown == 0 for v in self.values.values())

    @property
    def name(self) -> str:
        return self.prefix.replace("_", " ").replace(".", ", ")


def value_blocks(context: Context, outcome: Outcome) -> list[Block]:
    """All values of a step.  What is zero throughout is named, not tabulated, unless everything is asked for."""
    parts: dict[str, _Part] = {}
    for value in outcome.values():
        prefix, _, name = value.id.removeprefix(f"{outcome.key}.").rpartition(".")
        parts.setdefault(prefix, _Part(prefix)).values[name] = value
    nothing = [p for p in parts.values() if p.zero and p.prefix and not context.audit]
    made: list[Block] = []
    for cluster in _clusters(p for p in parts.values() if p not in nothing):
        if len(cluster) == 1:
            made += _single(context, cluster[0])
        else:
            for start in range(0, len(cluster), ACROSS):
                made += _beside(context, cluster[start : start + ACROSS])
    if nothing:
        made += paragraph(context.words["zero_values"].format(names="; ".join(p.name for p in nothing)), NOTE, gap=3.0)
    return made


def _clusters(parts: Iterable[_Part]) -> list[list[_Part]]:
    clusters: list[list[_Part]] = []
    for part in parts:
        names = {(n, v.unit) for n, v in part.values.items()}
        for cluster in clusters:
            first = {(n, v.unit) for n, v in cluster[0].values.items()}
            if part.prefix and cluster[0].prefix and len(names & first) >= ALIKE * max(len(names), len(first)):
                cluster.append(part)
                break
        else:
            clusters.append([part])
    return clusters


def _symbol(value: Published) -> Cell:
    return Cell(box=symbol(value.symbol, CELL.size)) if value.symbol else Cell()


def _single(context: Context, part: _Part) -> list[Block]:
    w = context.words
    columns = (
        Column(w["quantity"], width=186.0), Column(w["symbol"], width=48.0), Column(w["value"], "r", width=56.0),
        Column(w["unit"], width=44.0), Column(w["id"]),
    )  # fmt: skip
    rows: list[Row] = [(v.label, _symbol(v), short(v.shown), v.unit, Cell(v.id, NOTE)) for v in part.values.values()]
    return named_table(_title(part), columns, rows)


def _title(part: _Part) -> str:
    return part.name[:1].upper() + part.name[1:]


def _beside(context: Context, parts: list[_Part]) -> list[Block]:
    w = context.words
    named: dict[str, Published] = {}
    for part in parts:
        for name, value in part.values.items():
            named.setdefault(name, value)
    columns = (Column(w["quantity"]), Column(w["symbol"]), *(Column(p.name, "r") for p in parts), Column(w["unit"], width=40.0))
    rows: list[Row] = []
    for name, value in named.items():
        cells = [short(p.values[name].shown) if name in p.values else "–" for p in parts]
        if not context.audit and all(c in ("0", "–") for c in cells):
            continue
        rows.append((value.label, _symbol(value), *cells, value.unit))
    return table(columns, rows, gap=6.0) if rows else []
