# SPDX-License-Identifier: Apache-2.0
"""A workbook: inputs, results, checks and tables of a design, for spreadsheet programs."""

from assistant.exports.kinds import Made, Request
from calc.exchange.frame import date_of
from calc.exchange.workbook import workbook
from calc.locale import language
from reports.spreadsheet import workbook_bytes


def lacks(asked: Request) -> None:
    """Nothing: every design has inputs and results."""


def made(asked: Request) -> Made:
    sheets = workbook(asked.document, asked.results)
    return Made({asked.path: workbook_bytes(sheets, date_of(asked.results.design), language(asked.lang))})
