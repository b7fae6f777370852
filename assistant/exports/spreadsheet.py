# SPDX-License-Identifier: Apache-2.0
"""A workbook for spreadsheet programs: inputs, results, checks, tables, loads at rated speed, runs, balancing."""

from assistant.exports.kinds import Made, Request
from assistant.exports.loads import lacks as without_loads
from calc.exchange.frame import date_of
from calc.exchange.loads import loads
from calc.exchange.workbook import workbook
from calc.locale import language
from reports.spreadsheet import workbook_bytes


def lacks(asked: Request) -> None:
    """Nothing: every design has inputs and results."""


def made(asked: Request) -> Made:
    results, engine = asked.results, asked.results.design.engine
    # at rated speed, as everything else of the workbook; the file of loads has the others
    found = loads(results, [engine.rated_speed]) if engine is not None and without_loads(asked) is None else None
    sheets = workbook(asked.document, results, found)
    return Made({asked.path: workbook_bytes(sheets, date_of(results.design), language(asked.lang))})
