# SPDX-License-Identifier: Apache-2.0
"""Results as plain text and as JSON: every number of the screen is here too, the findings first."""

import math
import os
import sys
import textwrap
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict
from difflib import get_close_matches
from itertools import takewhile
from typing import TYPE_CHECKING, Any

from calc.countershaft.twins import Resolved
from calc.design.key_results import judged, outside
from calc.design.model import OPTIONAL
from calc.design.predicted import measured_table
from calc.design.toml_file import Document
from calc.design.unusual import SHOWN, Unusual, told, unusual
from calc.library.publications import as_printed
from calc.sheet.check import SIGNS, URGENT, Check, End
from calc.sheet.errors import BadInput
from calc.sheet.number import short
from calc.sheet.quantity import Published
from calc.sheet.record import replace
from calc.sheet.step import OF_SHAFTS, Outcome, Table, ignored
from calc.sheet.text import EMPTY, SEMICOLON, SPACE, Amount, Name, Text, plural
from calc.sheet.verdict import counts, findings_of, named, open_findings, severity, with_it
from calc.sheet.version import VERSION
from calc.solve import Results
from calc.studies.described import not_counted
from calc.studies.explain import Effect, effects
from calc.studies.headlines import heads, lead
from calc.studies.ready import limits_hold

if TYPE_CHECKING:
    from calc.design.run_results import ColumnResult
    from calc.measurements.rows import RunRows

# --- findings, as plain text that fits a screen
# Limits first, then cautions, each group of one cause by its worst check; advice and what concerns the method by
# their numbers and the worst of each.  `everything`: all of them in full.

WORDS = {
    "pass": "pass",
    "computed": "computed",
    "warn": "warn",
    "fail": "FAIL",
    "note": "note",
    "not_judged": "not judged",
    "not_verified": "not verified",
    "accepted": "accepted",
    "blocked": "blocked",
    "not_asked": "not used",
    "no_solution": "NO SOLUTION",
    "outside": "outside",
}
FINDINGS_LINE = 132  # characters of a line, and fewer on a terminal that has not so many
INDENT = " " * 8


def sign(verdict: str) -> str:
    """A sign and a word: `✗ FAIL`.  `outside`: it holds, by a formula outside its validity."""
    return f"{SIGNS['note' if verdict == 'outside' else verdict]} {WORDS[verdict]}"


def finding_lines(checks: Sequence[Check], everything: bool = False, odd: Sequence[Unusual] = ()) -> Iterator[str]:
    """How many findings there are, all that is open, and what the user accepted; `odd`: inputs that are not usual,
    which stand before what are notes."""
    notes = [check for check in sorted(checks, key=severity) if check.verdict == "note"]
    if findings := open_findings(checks):
        yield findings_of(findings)
    for worst, *others in findings:
        if everything:
            yield from (line for check in (worst, *others) for line in _whole_finding(check))
        else:
            yield from _finding(worst)
            yield from _with_it(worst, others)
    if everything:
        yield from (line for check in notes for line in _whole_finding(check))
    yield from _unusual(odd, len(odd) if everything else SHOWN)
    if not everything:
        yield from _counts("advice", [check for check in notes if check.kind == "advice"])
        yield from _counts("method", [check for check in notes if check.kind == "method"])
        yield from _outside(checks)
        yield from _assumed(checks)
    for check in checks:
        if check.verdict == "accepted":
            yield from _wrapped_finding(
                Text("{what}: {reason}", what=_judged(check), reason=check.accepted), f"{sign('accepted')}  "
            )


def _finding(check: Check) -> Iterator[str]:
    """What is judged, its id, and what decides: how far it goes with what is not given, and what would mend it."""
    yield from _headed(check)
    ways = check.ways_text()
    advice = ways if ways and check.to_do.startswith(ways) else check.to_do  # what is said beside them is for --all
    if words := [*filter(None, (_beyond(check), check.lack_in_short(), advice))]:
        yield from _wrapped_finding(SPACE.join(words))


def _whole_finding(check: Check) -> Iterator[str]:
    """The same with all that is known of it."""
    yield from _headed(check)
    if words := [*filter(None, (_beyond(check), check.lack_text(), check.to_do))]:
        yield from _wrapped_finding(SPACE.join(words))
    if check.source:
        yield from _wrapped_finding(check.source)


def _headed(check: Check) -> list[str]:
    return _wrapped_finding(f"{_judged(check)}  [{check.id}]", f"{sign(check.verdict)}  ")


def _beyond(check: Check) -> Text:
    return Text("Outside validity: {methods}.", methods=Name(", ".join(check.outside))) if check.outside else EMPTY


def _with_it(worst: Check, others: Sequence[Check]) -> list[str]:
    """What else is open of this cause, as many as stand in one line."""
    if not others:
        return []
    short_names = [replace(check, name=Name(_beside(check.name, worst.name))) for check in others]
    return _one_line([with_it(short_names, most) for most in range(len(others), 0, -1)])


def _beside(name: str, worst: str) -> str:
    """A name without the words with which another begins too; whole where nothing else is left."""
    words = name.split()
    pairs = zip(words, worst.split())
    shared = sum(1 for _ in takewhile(lambda pair: pair[0].strip(",") == pair[1].strip(","), pairs))
    return " ".join(words[shared:]) or name


def _one_line(texts: Sequence[str], start: str = INDENT) -> list[str]:
    """The first of the texts that fits into a line, else the last one."""
    wrapped = [_wrapped_finding(text, start) for text in texts]
    return next((lines for lines in wrapped if len(lines) == 1), wrapped[-1])


def _judged(check: Check) -> Text:
    """`Film at the edge, front: 7.411 µm, needs ≥ 9 µm (−18 %)`."""
    template = (
        "{name}: {value}, only just {limit} ({margin})"
        if check.narrow and check.verdict == "warn"
        else "{name}: {value}, needs {limit} ({margin})"
        if check.kind in ("limit", "caution")
        else "{name}: {value}, should be {limit} ({margin})"
    )
    value = Amount(check.value, check.unit)
    return Text(template, name=check.name, value=value, limit=check.limit_text(), margin=check.margin_text())


def _counts(kind: str, checks: Sequence[Check]) -> Iterator[str]:
    if not checks:
        return
    worst = named([min(checks, key=lambda check: check.margin if check.margin == check.margin else math.inf)])
    single, many = {
        "advice": ("{n} piece of advice: {worst}", "{n} pieces of advice; the furthest: {worst}"),
        "method": ("{n} note on the calculation: {worst}", "{n} notes on the calculation; the furthest: {worst}"),
    }[kind]
    yield from _wrapped_finding(plural(single, many, n=len(checks), worst=worst), f"{sign('note')}  ")


def _outside(checks: Sequence[Check]) -> Iterator[str]:
    """How many checks hold by a formula outside its validity, and what puts them there: of each kind the furthest."""
    beyond = [outside(check, checks) for check in checks if judged(check) == "outside"]
    if beyond:
        furthest: dict[str, Check] = {}
        for method in sorted((cause for group in beyond for cause in group), key=severity):
            furthest.setdefault(method.rule.id, method)
        single = "{n} check holds by a formula outside its validity: {methods}"
        many = "{n} checks hold by formulas outside their validity: {methods}"
        sentence = plural(single, many, n=len(beyond), methods=named([*furthest.values()]))
        yield from _wrapped_finding(sentence, f"{sign('note')}  ")


def _assumed(checks: Sequence[Check]) -> Iterator[str]:
    """How many checks hold by what stands for inputs that are not given, and what that is."""
    held = [check for check in checks if check.verdict == "pass" and check.taken]
    if held:
        taken = list(dict.fromkeys(words for check in held for words in check.taken))
        whole = plural("{n} check holds by what is assumed", "{n} checks hold by what is assumed", n=len(held))
        lengths = range(min(SHOWN, len(taken)), 0, -1)
        yield from _one_line([f"{whole}: {_first(taken, most)}" for most in lengths], f"{sign('note')}  ")


def _first(texts: Sequence[Text], most: int) -> Text:
    first = SEMICOLON.join(texts[:most])
    return first if len(texts) <= most else Text("{first}; {more} more", first=first, more=len(texts) - most)


def _unusual(odd: Sequence[Unusual], most: int) -> Iterator[str]:
    """The inputs outside what is usual, and their keys."""
    if odd:
        keys = ", ".join(oddity.key for oddity in odd[:most])
        yield from _wrapped_finding(f"{told(odd, most)}  [{keys}]", f"{sign('note')}  ")


def lost_acceptances(results: Results, step: str | None = None) -> Iterator[str]:
    """What is accepted in vain: a limit, or no check that the design, or the step, has; of a step that is not solved it
    may be one."""
    known = {check.id: check for check in results.checks()}
    waits = {key for key, outcome in results.outcomes.items() if outcome.state != "solved"}
    for id, _ in results.design.accepted:
        words = ignored(id, known.get(id))
        of_step = id.partition(".")[0]
        if words and of_step not in waits and step in (None, of_step) and id not in results.design.checked_later:
            near = [] if id in known else get_close_matches(id, known, 1)
            meant = Text("; did you mean {near}?", near=near[0]) if near else EMPTY
            yield from _wrapped_finding(words + meant, f"{sign('note')}  ")


def _wrapped_finding(text: str, start: str = INDENT) -> list[str]:
    """A number keeps its per cent on its line."""
    close = text.replace(" %", "\N{NO-BREAK SPACE}%")
    lines = textwrap.wrap(
        close, _width(), initial_indent=start, subsequent_indent=INDENT, break_long_words=False, break_on_hyphens=False
    )
    return [line.replace("\N{NO-BREAK SPACE}%", " %") for line in lines]


def _width() -> int:
    try:
        return max(60, min(FINDINGS_LINE, os.get_terminal_size(sys.stdout.fileno()).columns))
    except (ValueError, OSError):  # no terminal
        return FINDINGS_LINE


# --- steps, tables and values, and all of it as JSON

DIGITS = 6
HELD = ("pass", "warn", "not_judged")  # of which it is said what was judged, and what was not used
WIDE = 32  # characters of a cell of words in a table; a longer one goes on in the next line
LINE = 112  # of a table's note
NARROW = 12  # characters that a column's label may have on one line in any case

# units of vectors: one without length says nothing by its number or its phase
UNBROKEN = "\N{NO-BREAK SPACE}"  # a value and its unit stand in one line
VECTORS = ("N", "N·m", "°", "kg·mm", "kg·mm²")


def print_results(
    results: Results, step: str | None = None, *, everything: bool = True, findings: bool = False
) -> None:
    """A screen: the state, what is open, the verdict and two values of every step, what was measured beside what is
    predicted.

    `step`: only that, with all its values, tables, notes and checks before; `findings`: so of every step, every check
    that is open in full, and what is made only when asked for: the tables of studies, which take longer than the solve.
    `everything`: there vectors of no length as well, which say nothing."""
    print(state_words(results, step))
    for key, outcome in results.outcomes.items():
        if outcome.state != "not_asked" and (findings if step is None else step == key):
            _print_step(results, outcome.whole, everything)
    print_findings(results, step, findings)
    if results.design.measured and step is None and not findings:
        print("", *table_lines(measured_table(list(results.design.measured), results.predicted)), sep="\n")


def print_runs(results: Results, step: str | None = None, *, tables: bool = False) -> None:
    """A line for each run of the bench: what its columns come to beside what is predicted; `tables`: before them node
    by node.  `step`: of that alone."""
    if not results.design.runs or (runs := results.runs) is None:
        return
    lines = list(runs.lines(step))
    if lines:
        print()
    for column in runs.columns if tables else ():
        if step in (None, column.step):
            print(*table_lines(column.table), "", sep="\n")
    for line in lines:
        print(*_wrapped_finding(line, ""), sep="\n")


def state_words(results: Results, step: str | None = None) -> Text:
    """The state of the design, or of one step, and what is open: `WARN: 2 cautions`."""
    return results.words() if step is None else results.outcomes[step].words()


def _print_step(results: Results, outcome: Outcome[object], everything: bool) -> None:
    """Of several shafts first what is of all of them, then each under its name."""
    title, reason = results.design.title(outcome.key), outcome.reason
    print(f"{title}   {sign(outcome.verdict)}" + (f": {reason}" if reason else ""))
    shafts = results.design.resolved if len(results.design.shafts) > 1 and outcome.key in OF_SHAFTS else ()
    if (words := lead(results, outcome.key)) is not None:
        print(*_wrapped_finding(words, "  "), "", sep="\n")
    blocks: dict[str, list[Published]] = {"": [], **{f"{outcome.key}.{shaft.name}.": [] for shaft in shafts}}
    for value in outcome.values():
        blocks[next((way for way in blocks if way and value.id.startswith(way)), "")].append(value)
    _print_values(blocks.pop(""), everything)
    for shaft, values in zip(shafts, blocks.values()):
        if values:
            print(f"\n {shaft_words(shaft)}")
            _print_values(values, everything)
    for table in outcome.tables:
        print()
        for line in table_lines(table):
            print(f"  {line}".rstrip())
    for proposal in outcome.proposals:
        print(f"  proposed: {proposal}")
    for erratum in outcome.errata:
        print(
            f"  source differs: {erratum.about} {short(erratum.source_value)} {erratum.unit} ({erratum.source}). "
            f"{erratum.why}"
        )
    for note in outcome.notes:
        print(f"  note: {note}")
    for check in outcome.checks:
        print(f"  {check_line(check, judged(check))}")
        if lack := check.lack_text():
            print(f"{INDENT}{lack}")
    print()


def shaft_words(shaft: Resolved) -> Text:
    """Its name, and what it is: turning so fast, or a twin of another."""
    if shaft.how == "mirrors":
        return Text("{name}, mirrors {other}", name=Name(shaft.name), other=Name(shaft.of or ""))
    if shaft.how == "repeats":
        return Text("{name}, repeats {other}", name=Name(shaft.name), other=Name(shaft.of or ""))
    return Text("{name}, {ratio} × crank speed", name=Name(shaft.name), ratio=Amount(shaft.inputs.speed_ratio))


def _print_values(values: Iterable[Published], everything: bool) -> None:
    left_out, length = 0, 1.0
    for value in values:
        length = length if value.id.endswith("_phase") else value.shown
        if not everything and length == 0 and value.unit in VECTORS:
            left_out += 1
            continue
        print(f"  {value.id:<58} {short(value.shown, DIGITS):>14} {value.unit:<9} {value.label}")
    if left_out:
        print(f"  {left_out} forces, couples and phases that are zero are left out")


def table_lines(table: Table) -> list[str]:
    """A table as text: its title, its columns under label and unit, its note.  Words are wrapped, numbers never."""
    rows = [[_cell(cell) for cell in row] for row in table.rows]
    heads, widths, numeric = [], [], []
    for i, (label, unit) in enumerate(table.columns):
        wide = max((len(line) for row in rows for line in row[i]), default=0)
        head = _wrapped(label, max(wide, NARROW)) + ([unit] if unit else [])
        heads.append(head)
        widths.append(max([wide, *map(len, head)]))
        column = [row[i] for row in table.rows]
        numeric.append(any(isinstance(c, (int, float)) for c in column) or (bool(unit) and not any(column)))
    tall = max(map(len, heads), default=0)
    lines = [
        table.title,
        *_row([[""] * (tall - len(head)) + head for head in heads], widths, numeric),
        "  ".join("─" * w for w in widths),
    ]
    for row, given in zip(rows, table.rows):
        lines += _row(row, widths, [isinstance(cell, (int, float)) for cell in given])
    return [lines[0], *(f"  {line}" for line in [*lines[1:], *_wrapped(table.note, LINE)])]


def _cell(cell: str | float | None) -> list[str]:
    """The lines of one cell of a table."""
    if isinstance(cell, str):
        return _wrapped(cell, WIDE, break_on_hyphens=False)
    return [] if cell is None else [short(cell, DIGITS)]


def _wrapped(words: str, width: int, **how: bool) -> list[str]:
    """The words in lines of a width; most fit into one, which textwrap takes long to find."""
    if words and len(words) <= width and words == words.strip() and "\n" not in words:
        return [words]
    return textwrap.wrap(words, width, break_long_words=False, **how)  # type: ignore[arg-type]


def _row(cells: list[list[str]], widths: list[int], right: list[bool]) -> list[str]:
    """Cells beside each other, in as many lines as the tallest has; some stand to the right of their column."""
    lines = []
    for n in range(max(map(len, cells), default=0)):
        parts = [cell[n] if n < len(cell) else "" for cell in cells]
        lines.append("  ".join(p.rjust(w) if r else p.ljust(w) for p, w, r in zip(parts, widths, right)).rstrip())
    return lines


def check_line(check: Check, verdict: str) -> str:
    value = f"{short(check.value):>9} {check.unit:<9} {check.limit_text():<22} {check.margin_text():>8}"
    return f"{sign(verdict):<9} {check.id:<42} {value}  {check.name}"


def print_summary(results: Results, everything: bool = False) -> None:
    """The state of a design, what is open, and the verdict of each step."""
    print(results.words())
    print_findings(results, everything=everything)


def print_findings(results: Results, step: str | None = None, everything: bool = False) -> None:
    """What is open, then the verdict of each step with the values that stand for it: what stands last is what a
    terminal shows.

    `everything`: every check of a group, advice and method in full.
    """
    shown = {key: outcome for key, outcome in results.outcomes.items() if step in (None, key)}
    checks = [check for outcome in shown.values() for check in outcome.checks]
    if step is None and results.verdict in HELD:
        print(*_wrapped_finding(limits_hold(results), ""), sep="\n")
    odd = unusual(results.design, shown, checks)
    findings = [*finding_lines(checks, everything, odd), *lost_acceptances(results, step)]
    for line in [*findings, ""] if findings else []:
        print(line)
    print_steps(results, step)


def print_steps(results: Results, step: str | None = None) -> None:
    """The verdict of each step with the values that stand for it."""
    for key, outcome in results.outcomes.items():
        if step not in (None, key) or (key in OPTIONAL and outcome.state == "not_asked"):
            continue
        words = str(outcome.reason) or " · ".join(
            f"{head.id} {short(head.shown)} {head.unit}".rstrip().replace(" ", UNBROKEN)
            for head in heads(results, key)[:2]
        )
        first, *rest = [line.replace(UNBROKEN, " ") for line in _wrapped(words, LINE - 30)] or [""]
        print(
            f"{results.design.title(key):<14} {sign(outcome.verdict):<14} {first}".rstrip(),
            *(" " * 30 + line for line in rest),
            sep="\n",
        )


RESULTS = 2  # the number of the schema of the object; results_schema.py says what each field is


def results_json(
    document: Document, results: Results, step: str | None = None, changes: Sequence[str] = (), measured: bool = False
) -> dict[str, Any]:
    """The one JSON object of `check --json`; a number that is not finite is null.  `measured`: what the inputs do that
    move a check."""
    judged_part = results if step is None else results.outcomes[step]
    shown = [o.whole for key, o in results.outcomes.items() if step in (None, key)]
    runs = results.runs
    columns = [column for column in runs.columns if step in (None, column.step)] if runs is not None else []
    run_values = runs.values if runs is not None else ()
    run_checks = [column.check for column in columns]
    prefixes = tuple(f"{column.id}." for column in columns)
    counted = counts([*(check for o in shown for check in o.checks), *run_checks]) if run_checks else judged_part.counts
    moved = effects(document, results, [c for o in shown for c in o.checks if c.verdict in URGENT]) if measured else {}
    return {
        "schema": RESULTS,
        "program": "contralbero",
        "version": VERSION,
        "design": {"name": results.design.name, "sha256": document.sha256, "set": list(changes)},
        "verdict": judged_part.verdict,
        "counts": asdict(counted),
        "values": values_json(
            {id: v for id, v in results.values().items() if step is None or id.startswith(f"{step}.")}
            | {v.id: v for v in run_values if v.id.startswith(prefixes)}
        ),
        "tables": {f"{o.key}.{t.id}": table_json(t) for o in shown for t in o.tables},
        "checks": [
            *(check_json(c, moved.get(c.id)) for o in shown for c in o.checks),
            *(check_json(c, []) for c in run_checks),
        ],
        "measurements": {
            run.name: run_json(run, [column for column in columns if column.target.run == run.name])
            for run in results.design.runs
        },
        "fits": {
            fit.name: {"of": results.design.runs_of(fit), "free": [row.key for row in fit.free], "verdict": None}
            for fit in results.design.fits  # which take long, and are made where they are asked for
        },
        "steps": {o.key: o.verdict for o in shown},
        "errata": [
            {
                "about": e.about,
                "label": e.label,
                "source_value": finite(e.source_value),
                "unit": e.unit,
                "source": e.source,
                "why": e.why,
                "line": line,
                "who": who,
            }
            for o in shown
            for e in o.errata
            for line, who in [as_printed(*e.at)]
        ],
        "proposals": {o.key: list(o.proposals) for o in shown if o.proposals},
        "notes": {o.key: list(o.notes) for o in shown if o.notes},
        "unusual": [
            {"key": oddity.key, "value": oddity.number, "usual": list(oddity.usual), "unit": oddity.about.unit}
            for oddity in unusual(results.design, [o.key for o in shown], results.checks())
        ],
        "reasons": {o.key: o.reason for o in shown if o.reason},
        "not_counted": list(not_counted(results.design)),
    }


def values_json(values: Mapping[str, Published]) -> dict[str, Any]:
    """Values by their ids."""
    return {id: {"value": finite(v.shown), "unit": v.unit, "label": v.label} for id, v in values.items()}


def run_json(run: "RunRows", columns: "Sequence[ColumnResult]") -> dict[str, Any]:
    """A run of the bench beside what is predicted, column by column and node by node."""
    return {
        "file": run.file,
        "sha256": run.sha256,
        "rows": len(run.speed),
        "rows_left_out": run.lost,
        "columns": {column.target.column: _column_json(column) for column in columns},
    }


def _column_json(column: "ColumnResult") -> dict[str, Any]:
    target, found = column.target, column.found
    rows = target.nodes.columns[target.column]

    def at(numbers: Any, i: int) -> float | None:
        return None if numbers is None else finite(float(numbers[i]))

    return {
        "value": list(target.value),
        "unit": target.unit,
        "step": column.step,
        "verdict": found.verdict,
        "words": column.sentence,
        "accepted": column.accepted,
        "rows": rows.rows,
        "empty": rows.empty,
        "used": found.used,
        "not_predicted": column.lost,
        "bias": finite(found.bias),
        "rms": finite(found.rms),
        "chi2_reduced": finite(found.chi2_reduced),
        "chi2_range": None if found.judged_by is None else list(found.judged_by),
        "runs_z": finite(found.runs_z),
        "runs": found.runs,
        "nodes": [
            {
                "speed_rpm": float(target.nodes.speed[i]) * 60,
                "conditions": {key: float(numbers[i]) for key, numbers in target.conditions.items()},
                "rows": int(target.nodes.rows[i]),
                "measured": at(target.y, i),
                "uncertainty": at(target.sigma, i),
                "common": at(target.common, i),
                "predicted": at(column.predicted, i),
                "residual": at(found.r, i),
            }
            for i in range(len(target.y))
        ],
    }


def check_json(check: Check, moved: "Sequence[Effect] | None" = None) -> dict[str, Any]:
    """A check with everything that it knows.  `moved`: what the inputs do that move it, where it was measured."""
    measured = moved if moved is not None else [Effect(key, None, None, "") for key in check.moved_by]
    return {
        "id": check.id,
        "kind": check.kind,
        "role": check.role,
        "cause": check.cause or check.id,
        "name": check.name,
        "value": finite(check.value),
        "sense": check.sense,
        "limit": [*map(finite, check.limit)] if isinstance(check.limit, tuple) else finite(check.limit),
        "unit": check.unit,
        "gap": finite(check.gap),
        "scale": finite(check.scale),
        "margin": finite(check.margin),
        "utilisation": finite(check.utilisation),
        "finding": check.finding,
        "verdict": check.verdict,
        "outside": list(check.outside),
        "source": check.source,
        "advice": check.to_do,
        "judges": check.value_id,
        "against": check.limit_id,
        "moved_by": [{"key": e.key, "slope": e.slope, "gain": e.gain, "unit": e.unit} for e in measured],
        "remedies": [
            {"changes": dict(remedy.changes), "effect": remedy.effect, "words": remedy.words}
            for remedy in check.remedies
        ],
        "missing": list(check.missing),
        "taken": list(check.taken),
        "at_best": _end_json(check.at_best),
        "at_worst": _end_json(check.at_worst),
        "accepted": check.accepted,
    }


def _end_json(end: End | None) -> float | str | None:
    """The value there, "holds" or "none"; null where nothing is missing."""
    return end if isinstance(end, str) else finite(end)


def errors_json(bad: BadInput) -> list[dict[str, Any]]:
    """What was wrong with an input; `line` 0: of no line."""
    return [{"line": e.line, "key": e.called or e.key, "value": e.value, "reason": e.reason} for e in bad.errors]


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
