# SPDX-License-Identifier: Apache-2.0
"""Results as plain text and as JSON: every number of the screen is here too."""

import math
from collections.abc import Sequence
from typing import Any

from calc.design_file import Document
from calc.sheet.check import SIGNS, Check
from calc.sheet.number import short
from calc.sheet.step import Outcome
from calc.solve import TITLES, Results
from calc.version import VERSION

WORDS = {"pass": "pass", "warn": "warn", "fail": "FAIL", "blocked": "blocked", "not_asked": "not asked", "no_solution": "NO SOLUTION"}


def sign(verdict: str) -> str:
    """A sign and a word: `✗ FAIL`."""
    return f"{SIGNS[verdict]} {WORDS[verdict]}"


def print_results(results: Results, step: str | None = None) -> None:
    """Every step with its values and checks, then the summary."""
    for key, outcome in results.outcomes.items():
        if outcome.state != "not_asked" and step in (None, key):
            _print_step(outcome)
    print_summary(results, step)


def _print_step(outcome: Outcome) -> None:
    print(f"{TITLES[outcome.key]}   {sign(outcome.verdict)}" + (f": {outcome.reason}" if outcome.reason else ""))
    for value in outcome.values():
        print(f"  {value.id:<58} {short(value.shown, 6):>14} {value.unit:<9} {value.label}")
    for erratum in outcome.errata:
        print(f"  source differs: {erratum.about} {short(erratum.source_value)} {erratum.unit} ({erratum.source}). {erratum.why}")
    for note in outcome.notes:
        print(f"  note: {note}")
    for check in outcome.checks:
        print(f"  {check_line(check)}")
    print()


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
            needs = f"{short(check.value)} {check.unit}".rstrip() + f", needs {check.limit_text()} ({check.margin_text()})"
            print(f"{sign(verdict)}  {check.name}: {needs}. {check.advice}".rstrip())
            if verdict == "fail":
                print(f"        {check.id} · {check.source}")


def results_json(document: Document, results: Results, step: str | None = None, changes: Sequence[str] = ()) -> dict[str, Any]:
    """The one JSON object of `check --json`; a number that is not finite is null."""
    shown = [o for key, o in results.outcomes.items() if step in (None, key)]
    return {
        "schema": 1,
        "program": "contralbero",
        "version": VERSION,
        "design": {"name": results.design.name, "sha256": document.sha256, "set": list(changes)},
        "values": {v.id: {"value": _finite(v.shown), "unit": v.unit, "label": v.label} for o in shown for v in o.values()},
        "checks": [
            {
                "id": c.id,
                "kind": c.kind,
                "name": c.name,
                "value": _finite(c.value),
                "sense": c.sense,
                "limit": list(c.limit) if isinstance(c.limit, tuple) else c.limit,
                "unit": c.unit,
                "margin": _finite(c.margin),
                "verdict": c.verdict,
                "source": c.source,
                "advice": c.advice,
            }
            for o in shown
            for c in o.checks
        ],
        "steps": {o.key: o.verdict for o in shown},
        "errata": [
            {"about": e.about, "label": e.label, "source_value": _finite(e.source_value), "unit": e.unit, "source": e.source, "why": e.why}
            for o in shown
            for e in o.errata
        ],
        "notes": {o.key: list(o.notes) for o in shown if o.notes},
        "reasons": {o.key: o.reason for o in shown if o.reason},
    }


def _finite(number: float) -> float | None:
    return number if math.isfinite(number) else None
