# SPDX-License-Identifier: Apache-2.0
"""A workbook for spreadsheet programs: a sheet each, tables one below another, numbers as numbers.

No formula, no macro, no link: whatever a text begins with, it is written as text.  xlsxwriter is loaded here alone, and
asked for by the extra `xlsx`."""

import math
from collections.abc import Sequence
from datetime import datetime
from functools import cache
from io import BytesIO
from typing import TYPE_CHECKING

from calc.exchange.workbook import Cell, Sheet
from calc.locale import Language
from calc.sheet.step import Table

if TYPE_CHECKING:
    from xlsxwriter import Workbook
    from xlsxwriter.worksheet import Worksheet

NARROWEST, WIDEST = 9, 60  # characters of a column
LONGEST = 32767  # characters that a cell may hold


def workbook_bytes(sheets: Sequence[Sheet], date: str, say: Language) -> bytes:
    """The file, the same bytes for the same sheets; `date`: the day that it says it was made, YYYY-MM-DD."""
    from xlsxwriter import Workbook

    out = BytesIO()
    plain = {"strings_to_formulas": False, "strings_to_urls": False, "strings_to_numbers": False}
    book = Workbook(out, {"in_memory": True, **plain})
    book.set_properties({"created": datetime.fromisoformat(date)})
    pages = _Pages(book, say)
    for page in sheets:
        pages.add(page)
    book.close()
    return out.getvalue()


class _Pages:
    """The sheets of a workbook that is being written, and its formats."""

    def __init__(self, book: "Workbook", say: Language) -> None:
        self.book, self.say = book, say
        self.title = book.add_format({"bold": True, "font_size": 13})
        self.head = book.add_format({"bold": True, "bottom": 1})
        self.format = cache(lambda shown: book.add_format({"num_format": shown}))

    def add(self, page: Sheet) -> None:
        sheet, row, alone = self.book.add_worksheet(self.say(page.title)), 0, len(page.tables) == 1
        for table in page.tables:
            if not alone:
                sheet.write_string(row, 0, self.say(table.title), self.title)
                row += 1
            row = self._table(sheet, row, table) + 1
        if alone:
            sheet.freeze_panes(1, 1)
            sheet.autofilter(0, 0, len(page.tables[0].rows), len(page.tables[0].columns) - 1)
        for column, width in enumerate(_widths(page.tables, self.say)):
            sheet.set_column(column, column, width)

    def _table(self, sheet: "Worksheet", row: int, table: Table) -> int:
        """A table from a row on; the row behind it."""
        if any(label for label, _ in table.columns):
            for column, (label, unit) in enumerate(table.columns):
                sheet.write_string(row, column, _headed(label, unit, self.say), self.head)
            row += 1
        for cells in table.rows:
            for column, cell in enumerate(cells):
                self._cell(sheet, row, column, cell)
            row += 1
        if table.note:
            sheet.write_string(row, 0, self.say(table.note)[:LONGEST])
            row += 1
        return row

    def _cell(self, sheet: "Worksheet", row: int, column: int, cell: Cell) -> None:
        if isinstance(cell, str):
            sheet.write_string(row, column, self.say(cell)[:LONGEST])
        elif cell is not None and math.isfinite(cell):
            sheet.write_number(row, column, float(cell), self.format(_shown(cell)))


def _shown(number: float) -> str:
    """How a cell shows a number: by six digits, a whole one as it is; the cell itself keeps all of them."""
    if number == int(number) and abs(number) < 1e7:
        return "0"
    power = math.floor(math.log10(abs(number)))
    return f"0.{'0' * (5 - power)}" if -4 <= power < 5 else "0" if power == 5 else "0.00000E+00"


def _headed(label: str, unit: str, say: Language) -> str:
    return f"{say(label)} [{unit}]" if unit and label else say(label) or unit


def _widths(tables: Sequence[Table], say: Language) -> list[int]:
    """Of each column, by the texts in it; long ones are not followed to their end."""
    widths = [NARROWEST] * max(len(table.columns) for table in tables)
    for table in tables:
        heads = [_headed(label, unit, say) for label, unit in table.columns]
        for cells in (heads, *table.rows):
            for column, cell in enumerate(cells):
                if isinstance(cell, str):
                    widths[column] = max(widths[column], min(len(say(cell)) + 2, WIDEST))
    return widths
