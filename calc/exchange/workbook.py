# SPDX-License-Identifier: Apache-2.0
"""What a workbook has of a design: its summary, inputs, values, checks and tables, a sheet each, as tables of numbers
and texts.  Numbers stand in their shown unit and in full; nothing is a formula, which would not be the program's."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from ..design.addresses import value_at
from ..design.model import TITLES as STEP_TITLES
from ..sheet.check import Check
from ..sheet.quantity import Published, Quantity, given
from ..sheet.record import record
from ..sheet.step import Table
from ..sheet.text import Name, Text
from ..sheet.verdict import TITLES
from ..sheet.version import VERSION
from .loads_text import COLUMNS, cells

if TYPE_CHECKING:
    from ..design.toml_file import Document
    from ..solve import Results
    from .loads import Loads

Cell = str | float | None
APART = {"measured": "Measurements", "hole_depths": "Balancing"}  # tables of steps on a sheet of their own
WORDED = range(1, 4)  # columns of the loads that hold words
VERDICTS = TITLES | {"note": Text("note"), "accepted": Text("accepted")}


@record
class Sheet:
    """A page of the workbook: its tables stand one below another."""

    title: Text
    tables: tuple[Table, ...]


def workbook(document: "Document", results: "Results", found: "Loads | None" = None) -> tuple[Sheet, ...]:
    """The sheets of a solved design, in their order; those without a row are left out.  `found`: its loads."""
    by_page: dict[str, list[Table]] = {"Tables": [], "Measurements": [], "Balancing": [_balancing(results)]}
    for outcome in results.outcomes.values():
        for table in outcome.whole.tables:
            by_page[APART.get(table.id.rpartition(".")[2], "Tables")].append(table)
    by_page["Measurements"] += [column.table for column in results.runs.columns] if results.runs is not None else []
    pages = (
        Sheet(Text("Summary"), (_design(document, results), _verdicts(results))),
        Sheet(Text("Inputs"), (_inputs(document, results),)),
        Sheet(Text("Results"), (_values("values", Text("Results"), results.values()),)),
        Sheet(Text("Checks"), (_checks(results),)),
        Sheet(Text("Tables"), tuple(by_page["Tables"])),
        Sheet(Text("Loads"), (_loads(found),) if found is not None else ()),
        Sheet(Text("Measurements"), tuple(by_page["Measurements"])),
        Sheet(Text("Balancing"), tuple(by_page["Balancing"])),
    )
    return tuple(page for page in pages if any(table.rows for table in page.tables))


def _loads(found: "Loads") -> Table:
    """As the CSV of the loads has them: numbers as numbers, an empty cell where there is none."""
    rows = tuple(
        tuple(Name(cell) if n in WORDED else float(cell) if cell else None for n, cell in enumerate(cells(row)))
        for row in found.rows
    )
    return _table("loads", Text("Loads"), tuple((Name(name), "") for name in COLUMNS), rows)


def _balancing(results: "Results") -> Table:
    values = {id: value for id, value in results.values().items() if ".balancing." in id}
    return _values("balancing", Text("Balancing"), values)


def _design(document: "Document", results: "Results") -> Table:
    rows: tuple[tuple[Cell, ...], ...] = (
        (Text("Design"), Name(results.design.name)),
        (Text("File"), Name(document.place.replace("\\", "/").rpartition("/")[2])),
        ("SHA-256", Name(document.sha256)),
        (Text("Program"), Name(f"contralbero {VERSION}")),
        (Text("Verdict"), results.words()),
    )
    return _table("design", Text("The design"), (("", ""), ("", "")), rows)


def _verdicts(results: "Results") -> Table:
    rows = tuple(
        (STEP_TITLES[outcome.key], outcome.words(), outcome.reason or None) for outcome in results.outcomes.values()
    )
    columns = ((Text("Step"), ""), (Text("Verdict"), ""), (Text("Why"), ""))
    return _table("verdicts", Text("Its steps"), columns, rows)


def _inputs(document: "Document", results: "Results") -> Table:
    columns = ((Text("Key"), ""), (Text("Value"), ""), (Text("Unit"), ""), (Text("Default"), ""), (Text("Input"), ""))
    rows = tuple(
        (
            Name(key),
            _content(about, content),
            Name(about.unit) or None,
            None if value_at(document.data, key) is not None else Text("default"),
            about.label,
        )
        for path, about, content in given(results.design, "", named=True)
        for key in (path.removeprefix("."),)
        if content != ()
    )
    return _table("inputs", Text("Inputs"), columns, rows)


def _content(about: Quantity, content: object) -> Cell:
    if isinstance(content, bool):
        return Text("yes") if content else Text("no")
    if isinstance(content, (int, float)):
        return float(about.units.shown(content))
    if isinstance(content, (tuple, list)):
        return Name(", ".join(_written(about, element) for element in content))
    return Name(str(content))


def _written(about: Quantity, element: object) -> str:
    return repr(about.units.shown(element)) if isinstance(element, float) else str(element)


def _values(id: str, title: Text, values: Mapping[str, Published]) -> Table:
    columns = ((Text("Id"), ""), (Text("Value"), ""), (Text("Unit"), ""), (Text("Symbol"), ""), (Text("Label"), ""))
    rows = tuple(
        (Name(name), value.shown, Name(value.unit) or None, Name(value.symbol) or None, value.label)
        for name, value in values.items()
    )
    return _table(id, title, columns, rows)


def _checks(results: "Results") -> Table:
    columns = (
        (Text("Id"), ""),
        (Text("Check"), ""),
        (Text("Kind"), ""),
        (Text("Value"), ""),
        (Text("Least allowed"), ""),
        (Text("Most allowed"), ""),
        (Text("Unit"), ""),
        (Text("Margin"), "%"),
        (Text("Verdict"), ""),
        (Text("Source"), ""),
    )
    return _table("checks", Text("Checks"), columns, tuple(map(_check, results.checks())))


def _check(check: Check) -> tuple[Cell, ...]:
    low, high = check.bounds
    return (
        Name(check.id),
        check.name,
        Name(check.kind),
        check.value,
        low,
        high,
        Name(check.unit) or None,
        100 * check.margin,
        VERDICTS[check.verdict],
        check.source or None,
    )


def _table(
    id: str, title: Text, columns: tuple[tuple[Text | str, str], ...], rows: tuple[tuple[Cell, ...], ...]
) -> Table:
    return Table(id, title, tuple((Text(label), unit) for label, unit in columns), rows)
