# SPDX-License-Identifier: Apache-2.0
"""Results as plain text and as JSON: every number of the screen is here too."""

import math
import textwrap
from collections.abc import Sequence
from typing import Any

from calc.design_file import Document
from calc.sheet.check import SIGNS, Check
from calc.sheet.number import short
from calc.sheet.step import Outcome, Table
from calc.solve import TITLES, Results
from calc.version import VERSION

DIGITS = 6
WIDE = 32  # characters of a cell of words in a table; a longer one goes on in the next line
LINE = 112  # of a table's note
NARROW = 12  # characters that a column's label may have on one line in any case
WORDS = {"pass": "pass", "warn": "warn", "fail": "FAIL", "blocked": "blocked", "not_asked": "not asked", "no_solution": "NO SOLUTION"}

VECTORS = ("N", "N·m", "°", "kg·mm", "kg·mm²")  # units of vectors: one without length says nothing by its number or its phase


def sign(verdict: str) -> str:
    """A sign and a word: `✗ FAIL`."""
    return f"{SIGNS[verdict]} {WORDS[verdict]}"


def print_results(results: Results, step: str | None = None, *, everything: bool = True) -> None:
    """Every step with its values and checks, then the summary.  `everything`: vectors of no length as well, which say nothing."""
    for key, outcome in results.outcomes.items():
        if outcome.state != "not_asked" and step in (None, key):
            _print_step(outcome.whole, everything)
    print_summary(results, step)


def _print_step(outcome: Outcome, everything: bool) -> None:
    print(f"{TITLES[outcome.key]}   {sign(outcome.verdict)}" + (f": {outcome.reason}" if outcome.reason else ""))
    left_out, length = 0, 1.0
    for value in outcome.values():
        length = length if value.id.endswith("_phase") else value.shown
        if not everything and length == 0 and value.unit in VECTORS:
            left_out += 1
            continue
        print(f"  {value.id:<58} {short(value.shown, DIGITS):>14} {value.unit:<9} {value.label}")
    if left_out:
        print(f"  {left_out} forces, couples and phases that are zero are left out")
    for table in outcome.tables:
        print()
        for line in table_lines(table):
            print(f"  {line}".rstrip())
    for proposal in outcome.proposals:
        print(f"  proposed: {proposal}")
    for erratum in outcome.errata:
        print(f"  source differs: {erratum.about} {short(erratum.source_value)} {erratum.unit} ({erratum.source}). {erratum.why}")
    for note in outcome.notes:
        print(f"  note: {note}")
    for check in outcome.checks:
        print(f"  {check_line(check)}")
    print()


def table_lines(table: Table) -> list[str]:
    """A table as text: its title, its columns under label and unit, its note.  Words are wrapped, numbers never."""
    rows = [[_cell(cell) for cell in row] for row in table.rows]
    heads, widths, numeric = [], [], []
    for i, (label, unit) in enumerate(table.columns):
        wide = max((len(line) for row in rows for line in row[i]), default=0)
        head = textwrap.wrap(label, max(wide, NARROW), break_long_words=False) + ([unit] if unit else [])
        heads.append(head)
        widths.append(max([wide, *map(len, head)]))
        column = [row[i] for row in table.rows]
        numeric.append(any(isinstance(c, (int, float)) for c in column) or (bool(unit) and not any(column)))
    tall = max(map(len, heads), default=0)
    lines = [table.title, *_row([[""] * (tall - len(head)) + head for head in heads], widths, numeric), "  ".join("─" * w for w in widths)]
    for row, given in zip(rows, table.rows):
        lines += _row(row, widths, [isinstance(cell, (int, float)) for cell in given])
    return [lines[0], *(f"  {line}" for line in [*lines[1:], *textwrap.wrap(table.note, LINE, break_long_words=False)])]


def _cell(cell: str | float | None) -> list[str]:
    """The lines of one cell of a table."""
    if isinstance(cell, str):
        return textwrap.wrap(cell, WIDE, break_long_words=False, break_on_hyphens=False)
    return [] if cell is None else [short(cell, DIGITS)]


def _row(cells: list[list[str]], widths: list[int], right: list[bool]) -> list[str]:
    """Cells beside each other, in as many lines as the tallest has; some stand to the right of their column."""
    made = []
    for n in range(max(map(len, cells), default=0)):
        parts = [cell[n] if n < len(cell) else "" for cell in cells]
        made.append("  ".join(p.rjust(w) if r else p.ljust(w) for p, w, r in zip(parts, widths, right)).rstrip())
    return made


def check_line(check: Check) -> str:
    value = f"{short(check.value):>9} {check.unit:<9} {check.limit_text():<22} {check.margin_text():>8}"
    return f"{sign(check.verdict):<7} {check.id:<42} {value}  {check.name}"


def print_summary(results: Results, step: str | None = None) -> None:
    """The verdict of each step, then what fails and why, with advice: failures first."""
    shown = [o for key, o in results.outcomes.items() if step in (None, key)]
    for outcome in shown:
        reason = f"  {outcome.reason}" if outcome.reason else ""
        print(f"{TITLES[outcome.key]:<14} {sign(outcome.verdict)}{reason}")
    for verdict in ("fail", "warn"):
        found = [c for o in shown for c in o.checks if c.verdict == verdict]
        if found:
            print()
        for check in found:
            value = f"{short(check.value)} {check.unit}".rstrip()
            needs = f"{'only just' if check.narrow else 'needs'} {check.limit_text()} ({check.margin_text()})"
            print(f"{sign(verdict)}  {check.name}: {value}, {needs}. {check.advice}".rstrip())
            if verdict == "fail":
                print(f"        {check.id} · {check.source}")


def results_json(document: Document, results: Results, step: str | None = None, changes: Sequence[str] = ()) -> dict[str, Any]:
    """The one JSON object of `check --json`; a number that is not finite is null."""
    shown = [o.whole for key, o in results.outcomes.items() if step in (None, key)]
    return {
        "schema": 1,
        "program": "contralbero",
        "version": VERSION,
        "design": {"name": results.design.name, "sha256": document.sha256, "set": list(changes)},
        "values": {v.id: {"value": finite(v.shown), "unit": v.unit, "label": v.label} for o in shown for v in o.values()},
        "tables": {f"{o.key}.{t.id}": table_json(t) for o in shown for t in o.tables},
        "checks": [
            {
                "id": c.id,
                "kind": c.kind,
                "name": c.name,
                "value": finite(c.value),
                "sense": c.sense,
                "limit": list(c.limit) if isinstance(c.limit, tuple) else c.limit,
                "unit": c.unit,
                "margin": finite(c.margin),
                "verdict": c.verdict,
                "source": c.source,
                "advice": c.advice,
            }
            for o in shown
            for c in o.checks
        ],
        "steps": {o.key: o.verdict for o in shown},
        "errata": [
            {"about": e.about, "label": e.label, "source_value": finite(e.source_value), "unit": e.unit, "source": e.source, "why": e.why}
            for o in shown
            for e in o.errata
        ],
        "proposals": {o.key: list(o.proposals) for o in shown if o.proposals},
        "notes": {o.key: list(o.notes) for o in shown if o.notes},
        "reasons": {o.key: o.reason for o in shown if o.reason},
    }


def table_json(table: Table) -> dict[str, Any]:
    """A table with its cells as they are: words, numbers in the unit of their column, null."""
    return {
        "title": table.title,
        "columns": [{"label": label, "unit": unit} for label, unit in table.columns],
        "rows": [[finite(cell) if isinstance(cell, (int, float)) else cell for cell in row] for row in table.rows],
        "note": table.note,
    }


def finite(number: float | None) -> float | None:
    return number if number is not None and math.isfinite(number) else None
