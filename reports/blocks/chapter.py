# SPDX-License-Identifier: Apache-2.0
"""The chapter of a step in the report: findings, their proofs, what holds, key values; and every traced line.

At its end what the step stands on."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace

from calc.sheet.check import SIGNS, Check
from calc.sheet.quantity import Published, dotted
from calc.sheet.step import OF_SHAFTS, Outcome, Step
from calc.sheet.text import Amount, Name, Text
from calc.sheet.value import Line
from calc.sheet.verdict import findings_of, grouped

from ..context import Context
from ..typesetting.equation import SIGN, EquationEntry, Label, Labelled, entry_blocks
from ..typesetting.pagination import Block, bullet, heading, paragraph
from ..typesetting.prose import BODY, GROUP, NOTE
from ..typesetting.tables import Column, Row, noted_below, table
from .checks import counted, name_of, shown_value, sign_cell
from .inputs import input_blocks, remarks
from .proof import proof_blocks, proofs
from .values import table_blocks, there, value_blocks

VERDICT, LONG_VERDICT = 46.0, 66.0
EARLY = ("verdicts_of", "notes", "tables")
AT_A_GLANCE = ("tables", "figures")
LONG = ("not_verified", "accepted", "outside")

Parts = tuple[tuple[str, Callable[[], list[Block]]], ...]


def chapter_parts(context: Context, number: str, step: Step, outcome: Outcome[object], figures: list[Block]) -> Parts:
    """The parts of a chapter in their order, each by the word that heads it."""
    proven = {check.id for proof in proofs(context, outcome.checks) for check in proof.checks}
    values = [value for value in context.values_of(step) if value.short]
    parts: Parts = (
        ("verdicts_of", lambda: finding_blocks(context, outcome)),
        ("proofs", lambda: proof_blocks(context, number, step, outcome)),
        (
            "kept_checks",
            lambda: kept_blocks(context, [check for check in outcome.checks if check.holds and check.id not in proven]),
        ),
        ("key_values", lambda: value_blocks(context, outcome, values)),
        ("figures", lambda: figures),
        ("tables", lambda: table_blocks(context, [t for t in outcome.tables if t.short])),
        ("inputs", lambda: input_blocks(context, step)),
        (
            "notes",
            lambda: remarks(context, step.key) + [b for note in outcome.notes for b in bullet(note, BODY, gap=0.7)],
        ),
    )
    if context.shafts and step.key in OF_SHAFTS:  # of all together, which is seen at a glance
        parts = parts if outcome.checks else parts[1:]
        return tuple(sorted(parts, key=lambda part: AT_A_GLANCE.index(part[0]) if part[0] in AT_A_GLANCE else 2))
    if not outcome.reason:
        return parts
    # what is said of the step as a whole is read with what it rests on and what it comes to, before anything is proven
    return tuple(sorted(parts, key=lambda part: EARLY.index(part[0]) if part[0] in EARLY else len(EARLY)))


def finding_blocks(context: Context, outcome: Outcome[object]) -> list[Block]:
    """How the step came out, and what is open or accepted, one line a cause, the worst first."""
    groups = [group for group in grouped(outcome.checks) if any(check.verdict != "pass" for check in group)]
    listed = f" {context.say(findings_of([[c for c in g if c.verdict != 'pass'] for g in groups]))}:" if groups else ""
    summary = f"{verdict_words(context, outcome)}{listed}"
    reason = paragraph(context.say(outcome.reason), BODY, gap=2.0, keep=True) if outcome.reason else []
    blocks = reason + paragraph(summary, BODY, gap=1.0, keep=True) if outcome.state == "solved" else []
    rows: list[Row] = []
    for group in groups:
        worst, *more = [check for check in group if check.verdict != "pass"]
        name = name_of(context, worst) + (f" ({context.text('more_twins', count=len(more))})" if more else "")
        rows.append(_row(context, worst, name))
    return blocks + (table(_columns(context, outcome.checks), rows) if rows else [])


def verdict_words(context: Context, outcome: Outcome[object]) -> str:
    words = f"{SIGNS[outcome.verdict]} {context.say(outcome.words())}"
    return f"{words}. {counted(context, outcome.checks).capitalize()}."


def kept_blocks(context: Context, checks: list[Check]) -> list[Block]:
    """What holds and is not proven: twins on one line, by the one that comes closest to its limit; of advice and method
    the number."""
    twins: dict[str, list[Check]] = {}
    hard = [check for check in checks if check.kind in ("limit", "caution")]
    for check in hard:
        twins.setdefault(check.rule.id, []).append(check)
    rows: list[Row] = []
    for group in twins.values():
        by_gap = all(check.told_by_gap for check in group)  # as its margin is said, whatever else it is a share of
        least = min(group, key=lambda check: check.gap if by_gap else check.margin)
        name = name_of(context, least)
        if len(group) > 1:
            name += f" ({context.text('more_twins', count=len(group) - 1)})"
        rows.append(_row(context, least, name, _range(context, group)))
    blocks = table(_columns(context, hard), rows) if rows else []
    if blocks and len(hard) < len(checks):
        blocks = noted_below(blocks, context.text("soft_hold", n=len(checks) - len(hard)))
    return blocks


def _range(context: Context, group: list[Check]) -> str:
    """The values of twins from the least to the greatest."""
    low, high = (f(group, key=lambda check: check.value) for f in (min, max))
    if shown_value(context, low) == shown_value(context, high):
        return shown_value(context, low)
    return context.say(Text("{low} to {high}", low=Amount(low.value), high=Amount(high.value, high.unit)))


def _row(context: Context, check: Check, name: str, value: str = "") -> Row:
    cells = value or shown_value(context, check), context.say(check.limit_text()), context.say(check.margin_text())
    return sign_cell(context, context.state(check)), name, *cells


def _columns(context: Context, checks: Iterable[Check]) -> tuple[Column, ...]:
    w = context.words
    numbers = (Column(w[key], "r") for key in ("value", "limit", "margin"))
    wide = LONG_VERDICT if any(context.state(check) in LONG for check in checks) else VERDICT
    return (Column(w["verdict"], width=wide), Column(w["check"]), *numbers)


# --- a step that each of several shafts has for itself


def of_all(context: Context, step: Step, outcome: Outcome[object]) -> Outcome[object]:
    """What of it is of no shaft alone."""
    of_shafts = _own_lines(context, step)
    of_shafts.update(line for name in context.shafts for line in _twin_lines(context, step, outcome, name))
    return replace(
        outcome,
        checks=tuple(check for check in outcome.checks if context.tells(check.id)),
        lines=tuple(line for line in outcome.lines if line not in of_shafts),
        curves=tuple(curve for curve in outcome.curves if not _whose(context, curve.id)),
        tables=tuple(table for table in outcome.tables if not _whose(context, table.id)),
        key_curves=(),
        notes=(),
        errata=(),
        proposals=(),
    )


def of_one(context: Context, whole: Outcome[object], outcome: Outcome[object], name: str) -> Outcome[object]:
    """What of it is of one shaft; figures say its name, since they may stand elsewhere."""
    return replace(
        outcome,
        curves=tuple(curve for curve in whole.curves if _whose(context, curve.id) == name),
        key_curves=tuple(curve for curve in whole.key_curves if _whose(context, curve.id) == name),
    )


def _whose(context: Context, id: str) -> str:
    """The shaft that a curve or table of the step is of; none of all together."""
    name = id.partition(".")[0]
    return name if name in context.shafts else ""


def _own_lines(context: Context, step: Step) -> set[Line]:
    """The lines of all shafts that have a section of their own."""
    results = context.original or context.results
    views = [results.view(shaft.name) for shaft in context.design.shafts]
    return {line for view in views for line in view.outcomes[step.key].lines}


def _values_of(context: Context, step: Step, name: str) -> list[Published]:
    return [value for value in context.values.values() if value.id.startswith(f"{dotted(step.key, name)}.")]


def _twin_lines(context: Context, step: Step, outcome: Outcome[object], name: str) -> list[Line]:
    """The lines behind the values of a twin that are not its original's."""
    behind = {link.line for value in _values_of(context, step, name) for link in context.chains.of(value.id)}
    own = _own_lines(context, step)
    return [line for line in outcome.lines if line in behind and line not in own]


def twin_blocks(context: Context, step: Step, outcome: Outcome[object], name: str) -> list[Block]:
    """What a twin is, and what it gives; all else is its original's.  The audit has every value of its own."""
    twin = next(shaft for shaft in context.design.resolved if shaft.name == name)
    values = _values_of(context, step, name)
    how = f"{twin.how}_own" if "bearings" in context.results.of_shafts.get(name, {}) else twin.how
    words = paragraph(
        context.text(how, of=Name(str(twin.of)), ratio=Amount(twin.inputs.speed_ratio)), BODY, gap=1.0, keep=True
    )
    if context.audit:
        lines = _twin_lines(context, step, outcome, name)
        return words + derivation(context, step, lines) + value_blocks(context, outcome, values)
    told = [
        Text("{label} {value}", label=value.label, value=Amount(value.shown, value.unit))
        for value in there(values)
        if value.short
    ]
    return words + paragraph(context.say(Name(" · ").join(told)) + ".", BODY, gap=1.0)


# --- every traced line of a step as it was computed, in its order: what the audit has


def derivation(context: Context, step: Step, traced: list[Line]) -> list[Block]:
    """The blocks of the formulas of a step."""
    if not traced:
        return []
    blocks = paragraph(f"{context.words['substitution']} {context.words['ranges']}", NOTE, gap=1.0, keep=True)
    labels = {about: Label(*context.say.halves(about)) for about in dict.fromkeys(line.about for line in traced)}
    for about, entries in _runs([(labels[line.about], line) for line in traced]):
        if about:
            blocks += heading(about[:1].upper() + about[1:], GROUP, gap=7.0, after=1.0)
        for entry in entries:
            blocks += entry_blocks(
                entry, context.cite(entry.formula.source, step), SIGN, labelled=False, context=context
            )
    return blocks


def _runs(traced: list[Labelled]) -> Iterable[tuple[str, list[EquationEntry]]]:
    """Every line for itself, under the part whose calculation it is."""
    entries: list[EquationEntry] = []
    about = traced[0][0]
    for label, line in traced:
        if label != about:
            yield about.text(), entries
            entries, about = [], label
        entries.append(EquationEntry(line.formula, [(label, line)]))
    yield about.text(), entries
