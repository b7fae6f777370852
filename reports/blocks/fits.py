# SPDX-License-Identifier: Apache-2.0
"""The fits of a design below what the bench measured: values and limits, what the runs determine, the sentence."""

from __future__ import annotations

from collections.abc import Mapping

from calc.design.model import Design
from calc.locale.language import in_language
from calc.measurements.fit_words import width_words
from calc.sheet.step import Table
from calc.sheet.text import COMMA, Amount, Name, Text, plural
from calc.studies.fit_results import DesignFit

from ..context import Context
from ..typesetting.pagination import Block, heading, paragraph
from ..typesetting.prose import BODY, NOTE, SECTION
from .values import table_blocks

COLUMNS = (
    (Text("Input"), ""),
    (Text("The design has"), ""),
    (Text("Value"), ""),
    (Text("Standard deviation"), ""),
    (Text("95 %, from"), ""),
    (Text("to"), ""),
    (Text("Unit"), ""),
)


def fit_blocks(context: Context, design: Design, made: Mapping[str, DesignFit | Text]) -> list[Block]:
    """Each fit; of one that is not made how it is."""
    say = context.say
    blocks: list[Block] = []
    for fit in design.fits:
        done = made.get(fit.name)
        blocks += heading(say(Text("Fit {name}", name=Name(fit.name))), SECTION, gap=8.5, after=1.0, need=80.0)
        if done is None:
            blocks += paragraph(say(_unmade(design.runs_of(fit), len(fit.free))), BODY)
        elif isinstance(done, DesignFit):
            blocks += paragraph(say(done.sentence), BODY)
            if done.result.verdict in ("identified", "at its bound"):
                blocks += table_blocks(context, [in_language(_table(done), say)])
            for words in (_numbers(done), *done.left_out):
                blocks += paragraph(say(words), NOTE)
        else:
            blocks += paragraph(say(done), BODY)
    return blocks


def _unmade(runs: list[str], inputs: int) -> Text:
    return Text(
        "{what} to be found from {runs}: the command contralbero fit and the audit report do so.",
        what=plural("{n} input is", "{n} inputs are", n=inputs),
        runs=COMMA.join(map(Name, runs)),
    )


def _table(fit: DesignFit) -> Table:
    rows: list[tuple[str | float | None, ...]] = []
    for i, name in enumerate(fit.names):
        now, value, (low, high) = fit.now[i], fit.applied(i), map(float, fit.result.limits[i])
        if i in fit.result.at_bound:
            rows.append((name.label, now, value, None, None, None, Name(name.unit)))
        else:
            rows.append((name.label, now, value, float(fit.result.sd[i]), low, high, Name(name.unit)))
    return Table(fit.id, Text("Fit {name}: {verdict}", name=Name(fit.name), verdict=fit.verdict), COLUMNS, tuple(rows))


def _numbers(fit: DesignFit) -> Text:
    """`χ² 0.342 a degree of freedom (12), width 0.109, correlation −0.98361`."""
    result = fit.result
    scatter = Text(
        "χ² {chi2} a degree of freedom ({dof})", chi2=Amount(result.variance, digits=3), dof=result.degrees_of_freedom
    )
    if not result.weighted:
        sd = Amount(result.variance**0.5, fit.unit, digits=3)
        scatter = Text("residuals of {sd}, {dof} degrees of freedom", sd=sd, dof=result.degrees_of_freedom)
    parts = [scatter, Text("width {width}", width=width_words(result, 3))]
    if result.correlation is not None:
        parts.append(Text("correlation {correlation}", correlation=Amount(result.correlation, digits=5)))
    runs = Text("of {runs}", runs=COMMA.join(map(Name, fit.runs)))
    return COMMA.join([*parts, runs])
