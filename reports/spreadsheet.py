# SPDX-License-Identifier: Apache-2.0
"""A workbook for spreadsheet programs: a sheet each, tables one below another, numbers as numbers.

No formula, no macro, no link: whatever a text begins with, it is written as text.  xlsxwriter is loaded here alone, and
asked for by the extra `xlsx`."""

import math
from collections.abc import Callable, Sequence
from datetime import datetime
from functools import cache
from io import BytesIO
from typing import TYPE_CHECKING

from calc.exchange.workbook import Cell, Sheet
from calc.locale import Language
from calc.sheet.step import Table

if TYPE_CHECKING:
    from xlsxwriter.format import Format
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
    title, head = book.add_format({"bold": True, "font_size": 13}), book.add_format({"bold": True, "bottom": 1})
    formats = cache(lambda shown: book.add_format({"num_format": shown}))
    for page in sheets:
        sheet = book.add_worksheet(say(page.title))
        row = 0
        for table in page.tables:
            row = _write(sheet, row, table, say, title if len(page.tables) > 1 else None, head, formats)
        if len(page.tables) == 1:
            sheet.freeze_panes(1, 1)
            sheet.autofilter(0, 0, len(page.tables[0].rows), len(page.tables[0].columns) - 1)
        for column, width in enumerate(_widths(page.tables, say)):
            sheet.set_column(column, column, width)
    book.close()
    return out.getvalue()


def _write(
    sheet: "Worksheet",
    row: int,
    table: Table,
    say: Language,
    title: "Format | None",
    head: "Format",
    formats: Callable[[str], "Format"],
) -> int:
    """A table from a row on, under its title; the row behind it and a gap."""
    if title is not None:
        sheet.write_string(row, 0, say(table.title), title)
        row += 1
    if any(label for label, _ in table.columns):
        for column, (label, unit) in enumerate(table.columns):
            sheet.write_string(row, column, _headed(label, unit, say), head)
        row += 1
    for cells in table.rows:
        for column, cell in enumerate(cells):
            _cell(sheet, row, column, cell, say, formats)
        row += 1
    if table.note:
        sheet.write_string(row, 0, say(table.note)[:LONGEST])
        row += 1
    return row + 1


def _cell(
    sheet: "Worksheet", row: int, column: int, cell: Cell, say: Language, formats: Callable[[str], "Format"]
) -> None:
    if isinstance(cell, str):
        sheet.write_string(row, column, say(cell)[:LONGEST])
    elif cell is not None and math.isfinite(cell):
        sheet.write_number(row, column, float(cell), formats(_shown(cell)))


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
