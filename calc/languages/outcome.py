# SPDX-License-Identifier: Apache-2.0
"""What a step gave, with all its texts in another language.  Numbers, ids and symbols are those of the original."""

from dataclasses import replace

from ..sheet.check import Check
from ..sheet.quantity import Quantity
from ..sheet.step import Curve, Erratum, Outcome, Series, Table, Turning
from .language import Language


def said(outcome: Outcome, say: Language) -> Outcome:
    """The outcome in a language.  What is made only when it is asked for (`further`) is left out: pass `outcome.whole`."""
    if say.code == "en":
        return outcome
    return replace(
        outcome,
        checks=tuple(_check(check, say) for check in outcome.checks),
        lines=tuple(line._replace(about=say(line.about)) for line in outcome.lines),
        curves=tuple(_curve(curve, say) for curve in outcome.curves),
        tables=tuple(said_table(table, say) for table in outcome.tables),
        errata=tuple(_erratum(erratum, say) for erratum in outcome.errata),
        proposals=tuple(map(say, outcome.proposals)),
        notes=tuple(map(say, outcome.notes)),
        reason=say(outcome.reason),
        further=None,
    )


def _check(check: Check, say: Language) -> Check:
    return replace(check, name=say(check.name), advice=say(check.advice), source=say(check.source))


def _erratum(erratum: Erratum, say: Language) -> Erratum:
    return replace(erratum, label=say(erratum.label), source=say(erratum.source), why=say(erratum.why))


def said_table(table: Table, say: Language) -> Table:
    """A table with its title, heads, words and note in a language."""
    return replace(
        table,
        title=say(table.title),
        columns=tuple((say(label), unit) for label, unit in table.columns),
        rows=tuple(tuple(say(cell) if isinstance(cell, str) else cell for cell in row) for row in table.rows),
        note=say(table.note),
    )


def _curve(curve: Curve, say: Language) -> Curve:
    return replace(
        curve,
        title=say(curve.title),
        x_label=_axis(curve.x_label, say),
        y_label=_axis(curve.y_label, say),
        series=tuple(_series(series, say) for series in curve.series),
        limits=tuple((say(name), limit) for name, limit in curve.limits),
        names=tuple(map(say, curve.names)),
        variants=tuple(map(say, curve.variants)),
        turning=tuple(_turning(turning, say) for turning in curve.turning),
        along=(say(curve.along[0]), *curve.along[1:]) if curve.along else curve.along,
    )


def _axis(label: str, say: Language) -> str:
    """A name and, behind the last comma, its unit."""
    name, comma, unit = label.rpartition(", ")
    return f"{say(name)}, {unit}" if comma and say(label) == label else say(label)


def _series(series: Series, say: Language) -> Series:
    return replace(series, label=say(series.label), variant=say(series.variant))


def _turning(turning: Turning, say: Language) -> Turning:
    return replace(turning, names=tuple(map(say, turning.names)), variant=say(turning.variant))


def said_quantity(about: Quantity, say: Language) -> Quantity:
    """The description of an input in a language."""
    return about if say.code == "en" else replace(about, label=say(about.label), help=say(about.help))
