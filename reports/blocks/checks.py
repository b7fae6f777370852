# SPDX-License-Identifier: Apache-2.0
"""Checks and errata as tables: value, limit, margin, verdict; the worst first where they are summed up."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from calc.design.labels import label_of
from calc.design.names import knows
from calc.library.publications import as_printed
from calc.sheet.check import Check
from calc.sheet.step import Erratum
from calc.sheet.text import COMMA, SEMICOLON, Amount, Name, Text
from calc.sheet.verdict import counts, open_findings, with_it

from ..context import Context
from ..typesetting.fonts import BOLD
from ..typesetting.pagination import Block
from ..typesetting.prose import CELL, HEADER, NOTE, STRONG, Style
from ..typesetting.tables import Cell, Column, Row, longest, table
from .words import STATE_COLOURS, verdict

VERDICT, LONG_VERDICT = 42.0, 62.0
LONG = ("not_verified", "accepted")
ROUNDS = 0.05  # per cent: less is written as none
SIGN = {state: Style(CELL.size, CELL.leading, BOLD, colour) for state, colour in STATE_COLOURS.items()}


def sign_style(context: Context, state: str) -> Cell:
    """The verdict in the heading of a proof."""
    return Cell(verdict(context.words, state), replace(STRONG, colour=STATE_COLOURS[state]))


def sign_cell(context: Context, state: str, colour: str = "") -> Cell:
    """`colour`: the state whose colour it has, where that is another."""
    return Cell(verdict(context.words, state), SIGN[colour or state])


def shown_value(context: Context, check: Check) -> str:
    return context.written(check.value, check.unit)


def name_of(context: Context, check: Check) -> str:
    """The check's name with the part that it judges."""
    whose = " ".join(context.belongs(check.id))
    advice = f" ({context.words['advice']})" if check.kind in ("advice", "method") else ""
    return f"{check.name}{'' if knows(check.name, whose) else f', {whose}'}{advice}"


def counted(context: Context, checks: Sequence[Check]) -> str:
    """How many of the limits and of the cautions hold, and what stands below them: what holds by a formula outside its
    validity, and open notes."""
    if not checks:
        return context.words["no_checks"]
    n, outside = counts(checks), sum(context.state(check) == "outside" for check in checks)
    words = [context.text("held", n=n.held)] if n.limits else []
    if n.held < n.limits:
        words[0] += " " + context.text("of_judged", count=n.limits - n.not_verified)
    if n.cautions_held:
        words.append(context.text("held_cautions", n=n.cautions_held))
    if outside:
        words.append(context.text("counted_outside", n=outside))
    words += [
        context.text(f"open_{kind}", n=count) for kind, count in (("advice", n.advice), ("method", n.method)) if count
    ]
    return "; ".join(words) or context.words["no_limits"]


def check_blocks(context: Context, checks: Sequence[Check]) -> list[Block]:
    """The checks of a step in their order, each with its source."""
    rows = []
    for check in checks:
        under = f"[{check.source}]" if check.source else ""
        under = f"{_accepted(context, check)} {under}" if check.verdict == "accepted" else under
        rows.append(_check_row(context, check, f"{under} {context.whole_id(check.id)}" if context.audit else under))
    return _check_table(context, rows, 2.0, checks)


def attention_blocks(context: Context, checks: Iterable[Check]) -> list[Block]:
    """What fails, is not verified or warns, the worst first, each cause by its worst check; then what the user
    accepted.

    Causes with the same advice stand together, and it under the last of them.
    """
    checks = list(checks)
    together: dict[tuple[str, str], list[tuple[Check, str]]] = {}
    for worst, *more in open_findings(checks):
        others = context.say(with_it(more)) if more else ""
        together.setdefault((worst.verdict, context.say(worst.to_do)), []).append((worst, others))
    rows = []
    for (_, advice), some in together.items():
        for check, others in some:
            parts = (lack_of(context, check), advice if check is some[-1][0] else "", others)
            rows.append(_check_row(context, check, " ".join(part for part in parts if part)))
    rows += [_check_row(context, check, _accepted(context, check)) for check in checks if check.verdict == "accepted"]
    return _check_table(context, rows, 4.0, checks)


def lack_of(context: Context, check: Check) -> str:
    """What is not given, by its names; the audit names every key in full, and what stands for it."""
    if context.audit or check.verdict in ("pass", "accepted") or not check.missing:
        return context.say(check.lack_text())
    keys = not_given(context, (check,))
    if not check.taken:
        return context.say(Text("Not given: {keys}.", keys=keys))
    return context.say(Text("Not given: {keys}. {ends}", keys=keys, ends=check.ends_text()))


def not_given(context: Context, checks: Iterable[Check]) -> Text:
    """The inputs that some checks lack, by their names; those of several elements together."""
    data, together = context.document.data, dict[str, tuple[Text, list[Text]]]()
    for key in dict.fromkeys(key for check in checks for key in check.missing):
        whole = label_of(data, key)
        label, place = whole.parts.get("label"), whole.parts.get("place")
        named = isinstance(label, Text) and place is not None
        label = label if isinstance(label, Text) and named else whole
        together.setdefault(str(label), (label, []))[1].extend([Name(str(place))] if named else [])
    return SEMICOLON.join(
        Text("{label} of {place}", label=label, place=COMMA.join(places)) if places else label
        for label, places in together.values()
    )


def _accepted(context: Context, check: Check) -> str:
    return context.say(Text("Accepted: {reason}", reason=check.accepted))


def _check_row(context: Context, check: Check, under: str) -> Row:
    name = Cell(name_of(context, check), under=(under, CELL))
    return (
        sign_cell(context, check.verdict),
        name,
        shown_value(context, check),
        context.say(check.limit_text()),
        context.say(check.margin_text()),
    )


def _check_table(context: Context, rows: list[Row], gap: float, checks: Sequence[Check]) -> list[Block]:
    w = context.words
    wide = LONG_VERDICT if any(c.verdict in LONG for c in checks) else VERDICT
    columns = (
        Column(w["verdict"], width=wide),
        Column(w["check"]),
        Column(w["value"], "r"),
        Column(w["limit"], "r"),
        Column(w["margin"], "r"),
    )
    return table(columns, rows, gap=gap) if rows else []


def wrong_here(context: Context, errata: Iterable[Erratum]) -> list[Erratum]:
    """Those whose numbers differ in this design, in the digits that are shown."""
    return [e for e in errata if (off := _deviation(context, e)) is None or abs(off) >= ROUNDS]


def _deviation(context: Context, e: Erratum) -> float | None:
    """Of the source's number from ours, in per cent; None where that says nothing."""
    ours = context.values.get(e.about)
    if ours is None or ours.unit != e.unit or not ours.shown:
        return None
    return (e.source_value / ours.shown - 1) * 100


def errata_blocks(context: Context, errata: Iterable[Erratum], *, short: bool = False) -> list[Block]:
    """Where a source is wrong: its value beside ours, and why; `short`: the reason once for all that have it, in its
    first sentence."""
    w = context.words
    together: dict[str, list[Erratum]] = {}
    for n, erratum in enumerate(wrong_here(context, errata)):
        together.setdefault(erratum.why.partition(". ")[0].rstrip(".") if short else str(n), []).append(erratum)
    rows: list[Row] = []
    for why, some in together.items():
        for e in some:
            under = (
                ""
                if short and e is not some[-1]
                else f"{why}. [{e.source}]"
                if short
                else f"{e.why} {_as_printed(context, e)} {context.whole_id(e.about)}"
            )
            rows.append(_erratum_row(context, e, under))
    last = max(50.0, longest(w["deviation"], HEADER))
    columns = (
        Column(w["quantity"]),
        Column(w["source_value"], "r"),
        Column(w["our_value"], "r"),
        Column(w["deviation"], "r", width=last),
    )
    return table(columns, rows) if rows else []


def _as_printed(context: Context, e: Erratum) -> str:
    """The line itself, where it is known, its source, and who may be wrong."""
    line, who = as_printed(*e.at)
    return f"“{line}” [{e.source}; {context.say(who)}]" if line else f"[{e.source}]"


def _erratum_row(context: Context, e: Erratum, under: str) -> Row:
    ours, off = context.values.get(e.about), _deviation(context, e)
    mine = context.written(ours.shown, ours.unit) if ours is not None else "–"
    deviation = context.say.part(Amount(off, "%", form="+.1f")) if off is not None else "–"
    whose = " ".join(context.belongs(e.about))
    label = e.label if knows(e.label, whose) else f"{e.label}, {whose}"
    return Cell(label, under=(under, NOTE)), context.written(e.source_value, e.unit), mine, deviation
