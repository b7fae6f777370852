# SPDX-License-Identifier: Apache-2.0
"""`contralbero compare`: two designs side by side: what the comparison comes to, the inputs that differ, the rest when
asked for."""

import json
import sys
import textwrap
from argparse import Namespace
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

from assistant.named_files import STANDARD, demand_ending, files_of, put, read_design, spoken
from assistant.results_text import LINE, finite, sign, table_lines
from assistant.session.saving import spare
from calc.design.model import STEPS
from calc.design.predicted import compared_table
from calc.design.toml_file import Document, design
from calc.sheet.check import Check
from calc.sheet.errors import BadInput
from calc.sheet.step import Table
from calc.sheet.text import Text, plural
from calc.sheet.version import VERSION
from calc.sheet.visible import visible
from calc.solve import Results, solve
from calc.studies.compare import EQUAL, CheckDifference, Comparison, KeyResult, ValueDifference, compare
from calc.studies.compare_runs import compared_runs
from calc.studies.compare_tables import (
    Names,
    check_table,
    input_table,
    moved_table,
    result_table,
    sentences,
    value_table,
    verdict_table,
)

if TYPE_CHECKING:
    from calc.design.run_results import RunResults

MOST = 8  # verdicts that moved
LONGEST = 24  # characters of a name above a column
Sides = tuple[tuple[Document, Results], tuple[Document, Results]]


def run_compare(asked: Namespace) -> int:
    """What is wrong with either file is said at once."""
    files_of([asked.a, asked.b])  # standard input is one of them at most
    if asked.output and asked.output != STANDARD:
        spare(Path(asked.output), asked.a, asked.b)
        demand_ending(asked.output, "pdf")
    solved, wrong = [], []
    for name in (asked.a, asked.b):
        try:
            document = read_design(name)
            solved.append((document, design(document)))
        except BadInput as bad:
            wrong.append(str(bad))
    if wrong:
        print("\n".join(dict.fromkeys(wrong)), file=sys.stderr)
        return 2
    (a, made_a), (b, made_b) = solved
    sides = ((a, solve(made_a)), (b, solve(made_b)))
    for document, results in sides:
        results.demand_runs(document)
    comparison = compare(a.data, b.data, sides[0][1], sides[1][1])
    if asked.output:
        return _write(sides, comparison, asked.output, asked.lang, asked.all)
    if asked.json:
        print(json.dumps(comparison_json(sides, comparison), ensure_ascii=False, indent=1, default=str))  # a date
    elif asked.quiet:
        _print_conclusion(sides, comparison)
    else:
        print("\n".join(text(sides, comparison, asked.all)))
    return 0


def _print_conclusion(sides: Sides, comparison: Comparison) -> None:
    names = column_names(*(Path(document.place).stem for document, _ in sides))
    print("\n".join(sentences(comparison, names, sign)) if not comparison.equal else EQUAL)


def _write(sides: Sides, comparison: Comparison, output: str, lang: str, everything: bool) -> int:
    from reports.comparison import render

    names = column_names(*(Path(document.place).stem for document, _ in sides))
    put(output, render(*sides, comparison, names, lang=lang, everything=everything), [d.place for d, _ in sides])
    with spoken(output):
        _print_conclusion(sides, comparison)
        if output != STANDARD:
            print(f"\n{output}")
    return 0


# --- text


def text(sides: Sides, comparison: Comparison, everything: bool) -> Iterator[str]:
    """Which designs, what the comparison comes to, the inputs; `everything`: then all verdicts, checks and values that
    differ."""
    names = column_names(*(Path(document.place).stem for document, _ in sides))
    wide = max(map(len, names))
    for name, (document, results) in zip(names, sides):
        yield visible(f"{name:<{wide}}  {results.design.name}   {document.place}".rstrip())
    yield ""
    if comparison.equal:
        yield EQUAL
        return
    yield from sentences(comparison, names, sign)
    (_, a), (_, b) = sides
    measured = compared_table((a.design, a.predicted), (b.design, b.predicted), names)
    tables = [
        moved_table(comparison, names, sign, 0 if everything else MOST),
        result_table(comparison, names),
        measured,
        compared_runs(*_runs(sides), names),
    ]
    for table in [*tables, input_table(comparison.inputs, names, full=everything)]:
        if table is not None and table.rows:
            yield from _table(table)
        elif table is not None and table.note:
            yield from ("", *textwrap.wrap(table.note, LINE))
    if everything:
        yield from _table(verdict_table(comparison, names, sign))
        if comparison.checks:
            yield from _table(check_table(comparison.checks, names, sign))
        for step in STEPS:
            if of_step := [d for d in comparison.values if d.step == step.key]:
                yield from _table(
                    value_table(step.key, Text("{step}: values that differ", step=step.title), of_step, names)
                )
    else:
        yield ""
        checks = plural("{n} check", "{n} checks", n=len(comparison.checks))
        values = plural("{n} value", "{n} values", n=len(comparison.values))
        yield Text("What differs in all: {checks}, {values}; --all lists them.", checks=checks, values=values)


def column_names(a: str, b: str) -> Names:
    """The names of the files, where they tell the designs apart and are not too long."""
    return (a, b) if a != b and max(len(a), len(b)) <= LONGEST else ("A", "B")


def _table(table: Table) -> Iterator[str]:
    yield ""
    yield from table_lines(table)


# --- JSON


def comparison_json(sides: Sides, comparison: Comparison) -> dict[str, Any]:
    """All that differs.  `in` says which design has a check or a value; a number that is not finite is null."""
    return {
        "schema": 1,
        "program": "contralbero",
        "version": VERSION,
        "designs": [{"file": d.place, "name": results.design.name, "sha256": d.sha256} for d, results in sides],
        "equal": comparison.equal,
        "conclusion": {
            "verdict": dict(zip("ab", comparison.whole)),
            "counts": {side: asdict(results.counts) for side, (_, results) in zip("ab", sides)},
            "results": [_key_result(result) for result in comparison.results],
        },
        "inputs": [{"key": d.key, "label": d.label, "unit": d.unit, "a": d.a, "b": d.b} for d in comparison.inputs],
        "steps": {v.step: {"a": v.a.verdict, "b": v.b.verdict, "moved": v.moved} for v in comparison.verdicts},
        "checks": [
            {
                "id": d.id,
                "name": d.name,
                "moved": d.moved,
                "in": _where(d),
                "a": _check(d.a, d.before),
                "b": _check(d.b, d.after),
            }
            for d in comparison.checks
        ],
        "values": [
            {
                "id": d.id,
                "label": d.label,
                "unit": d.unit,
                "in": _where(d),
                "relative": finite(d.relative),
                "a": finite(d.a),
                "b": finite(d.b),
            }
            for d in comparison.values
        ],
        "measurements": {side: _runs_json(runs) for side, runs in zip("ab", _runs(sides))},
    }


def _runs(sides: Sides) -> tuple["RunResults | None", "RunResults | None"]:
    """The runs of both on both."""
    (_, a), (_, b) = sides
    return a.runs_with(b), b.runs_with(a)


def _runs_json(runs: "RunResults | None") -> dict[str, Any]:
    """What each column comes to, by its id."""
    return {
        column.id: {
            "verdict": column.found.verdict,
            "unit": column.unit,
            "bias": finite(column.found.bias),
            "rms": finite(column.found.rms),
            "chi2_reduced": finite(column.found.chi2_reduced),
            "used": column.found.used,
        }
        for column in (runs.columns if runs is not None else ())
    }


def _key_result(result: KeyResult) -> dict[str, Any]:
    """Of each design the part where it is worst."""
    sides = {side: v and {"id": v.id, "value": finite(v.shown)} for side, v in (("a", result.a), ("b", result.b))}
    return {"label": result.either.label, "unit": result.either.unit, **sides, "better": result.better}


def _where(d: CheckDifference | ValueDifference) -> str:
    return "both" if d.both else "a" if d.b is None else "b"


def _check(check: Check | None, judged: str) -> dict[str, Any] | None:
    if check is None:
        return None
    return {
        "value": finite(check.value),
        "sense": check.sense,
        "limit": list(check.limit) if isinstance(check.limit, tuple) else check.limit,
        "unit": check.unit,
        "margin": finite(check.margin),
        "kind": check.kind,
        "verdict": check.verdict,
        "outside": judged == "outside",
    }
