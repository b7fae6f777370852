# SPDX-License-Identifier: Apache-2.0
"""A workbook: inputs, results, checks, tables, loads, runs and balancing of a design, for spreadsheet programs."""

from assistant.exports.kinds import Made, Request
from assistant.exports.loads import lacks as without_loads
from calc.exchange.frame import date_of
from calc.exchange.loads import default_speeds, loads
from calc.exchange.workbook import workbook
from calc.locale import language
from reports.spreadsheet import workbook_bytes


def lacks(asked: Request) -> None:
    """Nothing: every design has inputs and results."""


def made(asked: Request) -> Made:
    results = asked.results
    found = None if without_loads(asked) is not None else loads(results, default_speeds(results.design))
    sheets = workbook(asked.document, results, found)
    return Made({asked.path: workbook_bytes(sheets, date_of(results.design), language(asked.lang))})
