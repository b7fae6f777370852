# SPDX-License-Identifier: Apache-2.0
"""The sheet for the balancing machine: a page for each shaft that asks for one, or its numbers as CSV."""

from assistant.exports.kinds import Made, Request
from calc.design.model import Design
from calc.locale.language import language
from calc.sheet.errors import InputError
from calc.sheet.quantity import dotted
from calc.sheet.text import Text
from calc.studies.balancing import asked
from calc.studies.balancing_table import csv_text


def lacks(wanted: Request) -> InputError | None:
    design, results = wanted.results.design, wanted.results
    shafts = [shaft for shaft in design.shafts if shaft.balancing is not None]
    if not design.shafts:
        add = Text("needed for the balancing sheet: add [[shafts]], with the empty table [shafts.balancing] below it")
        return InputError(0, dotted(Design.shafts), "", add)
    if not shafts:
        add = Text("needed for the balancing sheet: the empty table [shafts.balancing] below its [[shafts]] is enough")
        return InputError(0, dotted(Design.shafts), "", add)
    if not asked(results):
        outcome = results.outcomes["countershaft"]
        reason = outcome.reason or Text("its zero is no mass of the shaft")
        key = dotted(Design.shafts, shafts[0].name, "balancing")
        return InputError(0, key, "", Text("there is no balancing sheet: {reason}", reason=reason))
    return None


def made(wanted: Request) -> Made:
    if wanted.ending == "csv":
        text = csv_text(wanted.results, wanted.document.sha256, language(wanted.lang))
        return Made({wanted.path: text})
    from reports.balancing_sheet import render  # with reportlab

    return Made({wanted.path: render(wanted.document, wanted.results, lang=wanted.lang)})
