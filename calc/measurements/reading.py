# SPDX-License-Identifier: Apache-2.0
"""The file of a run: its columns by name, as text or numbers, with the units that it says and the line of each row.

Its bytes come through the guarded door of designs (`design/run_files.py`)."""

import csv
import hashlib
import io
import math
import re
from collections import Counter
from collections.abc import Mapping, Sequence
from importlib import import_module
from typing import Any

from ..sheet.extras import needs
from ..sheet.quantity import LARGEST, SMALLEST
from ..sheet.record import record
from ..sheet.text import Text
from ..sheet.visible import visible
from .inputs import ROWS
from .units import canonical

COLUMNS, LONGEST = 500, 40  # the letters of a name that are printed
SEPARATORS = (";", "\t", ",")
COMMA = re.compile(r"[+-]?\d+,\d+([eE][+-]?\d+)?")
POINT = re.compile(r"[+-]?(\d+\.\d*|\.\d+)([eE][+-]?\d+)?")
NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
QUOTED = re.compile(r'"[^"]*"')
EMPTY_CELLS = ("", "nan")


def named(words: str) -> str:
    """What stands in a file of somebody else, as it may be printed."""
    return visible(words[:LONGEST])


class Unread(Exception):
    """Why a file is no run; `text` says it."""

    def __init__(self, text: Text) -> None:
        super().__init__(str(text))
        self.text = text


@record
class RunFile:
    """A file as it was read.  `units`: of the columns that it says them of; `lines`: in which line each row stands, 0
    where it has none; `decimal`: the sign before decimals."""

    sha256: str
    columns: Mapping[str, Sequence[str] | Sequence[float]]
    units: Mapping[str, str]
    lines: Sequence[int]
    decimal: str = "."

    def numbers(self, column: str) -> list[float]:
        """A column as numbers, NaN where nothing stands.  Raises Unread for what is no number, with its line."""
        cells: Sequence[str | float] = self.columns[column]
        return [self._number(column, cell, row) for row, cell in enumerate(cells)]

    def _number(self, column: str, cell: str | float, row: int) -> float:
        if isinstance(cell, str):
            word = cell.strip()
            if word.lower() in EMPTY_CELLS:
                return math.nan
            if not NUMBER.fullmatch(point := word.replace(",", ".") if self.decimal == "," else word):
                is_none = Text(
                    'line {line}: "{cell}" in column {column} is no number; leave the cell empty where nothing was '
                    "measured",
                    line=self.lines[row],
                    cell=named(cell),
                    column=named(column),
                )
                raise Unread(is_none)
            cell = point
        number = float(cell)
        if math.isinf(number):
            raise Unread(Text("line {line}: column {column} is infinite", line=self.lines[row], column=named(column)))
        if number and not SMALLEST <= abs(number) <= LARGEST:
            beyond = Text(
                "line {line}: column {column}: a number must be 0 or of a size from 1e-30 to 1e30",
                line=self.lines[row],
                column=named(column),
            )
            raise Unread(beyond)
        return number


def read_run(raw: bytes, ending: str) -> RunFile:
    """The run in the bytes of a file, by its ending (`.csv`).  Raises Unread."""
    if not raw.strip():
        raise Unread(Text("is empty"))
    digest = hashlib.sha256(raw).hexdigest()
    if ending == ".parquet":
        return _parquet(raw, digest)
    return _tdms(raw, digest) if ending == ".tdms" else read_csv(raw, digest)


# --- text


def read_csv(raw: bytes, digest: str = "") -> RunFile:
    """Lines of cells: a header, perhaps a line of units, rows.  `#` begins a line that is skipped."""
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = raw.decode("latin-1")
    lines = [
        (n, line) for n, line in enumerate(text.splitlines(), 1) if line.strip() and not line.lstrip().startswith("#")
    ]
    if not lines:
        raise Unread(Text("has no line but comments"))
    if len(lines) - 2 > ROWS:
        raise Unread(_too_many(len(lines) - 1))
    separator = _separator(lines[0][1])
    (_, header), *rows = [(n, _cells(line, separator)) for n, line in lines]
    names = _names(header)
    units: dict[str, str] = {}
    if rows and _of_units(rows[0][1]):
        units = {name: canonical(unit) for name, unit in zip(names, rows[0][1]) if unit.strip()}
        del rows[0]
    if len(rows) > ROWS:
        raise Unread(_too_many(len(rows)))
    if not rows:
        raise Unread(Text("has a header and no row"))
    for n, row in rows:
        if len(row) > len(names) and any(cell.strip() for cell in row[len(names) :]):
            more = Text("line {line} has {count} cells, the header {names}", line=n, count=len(row), names=len(names))
            raise Unread(more)
    decimal = _decimal(rows, separator)
    columns = {name: [row[i] if i < len(row) else "" for _, row in rows] for i, name in enumerate(names) if name}
    return RunFile(digest, columns, units, [n for n, _ in rows], decimal)


def _too_many(count: int) -> Text:
    return Text("has {count} rows; at most {most} are read: give means over time", count=count, most=f"{ROWS:,}")


def _separator(header: str) -> str:
    bare = QUOTED.sub("", header)
    return max(SEPARATORS, key=bare.count)  # of as many of two the first


def _cells(line: str, separator: str) -> list[str]:
    try:
        return [cell.strip() for cell in next(csv.reader([line], delimiter=separator, skipinitialspace=True))]
    except csv.Error as error:  # a cell of a hundred thousand letters
        raise Unread(Text("can not be read as CSV: {why}", why=str(error))) from None


def _names(header: Sequence[str]) -> list[str]:
    if len(header) > COLUMNS:
        raise Unread(Text("has {count} columns; at most {most} are read", count=len(header), most=COLUMNS))
    twice = [name for name, count in Counter(filter(None, header)).items() if count > 1]
    if twice:
        raise Unread(Text("has the column {name} twice; give each a name of its own", name=named(twice[0])))
    return list(header)


def _of_units(cells: Sequence[str]) -> bool:
    """Whether they are a line of units, and not a row; one in which nothing was measured is a row."""
    return any(cell.lower() not in EMPTY_CELLS for cell in cells) and not any(map(_numeric, cells))


def _numeric(cell: str) -> bool:
    word = cell.strip()
    return bool(NUMBER.fullmatch(word) or COMMA.fullmatch(word))


def _decimal(rows: Sequence[tuple[int, Sequence[str]]], separator: str) -> str:
    """The sign before decimals; Unread where both stand in one file."""
    first: dict[str, int] = {}
    for n, row in rows:
        for cell in row:
            if separator != "," and COMMA.fullmatch(cell):
                first.setdefault(",", n)
            elif POINT.fullmatch(cell):
                first.setdefault(".", n)
    if len(first) == 2:
        comma, point = first[","], first["."]
        mixed = Text(
            "has decimals with a comma (line {comma}) and with a point (line {point}); write all of them alike",
            comma=comma,
            point=point,
        )
        raise Unread(mixed)
    return next(iter(first), ".")


# --- by extras


def _demand(extra: str, *modules: str) -> list[Any]:
    try:
        return [import_module(module) for module in modules]
    except ImportError:
        raise Unread(needs(extra)) from None


def _parquet(raw: bytes, digest: str) -> RunFile:
    (files,) = _demand("parquet", "pyarrow.parquet")
    try:
        file = files.ParquetFile(io.BytesIO(raw))
        if file.metadata.num_rows > ROWS:
            raise Unread(_too_many(file.metadata.num_rows))
        names = _names([str(name) for name in file.schema_arrow.names])
        table = file.read()
        columns = {name: _floats(table.column(i).to_pylist()) for i, name in enumerate(names)}
    except Unread:
        raise
    except Exception as error:  # whatever such a library raises of a broken file
        raise Unread(_broken("Parquet", error)) from None
    return RunFile(digest, columns, {}, range(1, len(next(iter(columns.values()), ())) + 1))


def _tdms(raw: bytes, digest: str) -> RunFile:
    (nptdms,) = _demand("tdms", "nptdms")
    columns: dict[str, list[float]] = {}
    units: dict[str, str] = {}
    try:
        with nptdms.TdmsFile.open(io.BytesIO(raw)) as file:
            for channel in (channel for group in file.groups() for channel in group.channels()):
                if len(channel) > ROWS:
                    raise Unread(_too_many(len(channel)))
                if channel.name in columns:
                    twice = Text("has the channel {name} in two groups; keep one of them", name=named(channel.name))
                    raise Unread(twice)
                columns[channel.name] = _floats(list(channel[:]))
                if unit := str(channel.properties.get("unit_string", "")).strip():
                    units[channel.name] = canonical(unit)
    except Unread:
        raise
    except Exception as error:
        raise Unread(_broken("TDMS", error)) from None
    longest = max(map(len, columns.values()), default=0)
    filled = {name: cells + [math.nan] * (longest - len(cells)) for name, cells in columns.items()}
    return RunFile(digest, filled, units, range(1, longest + 1))


def _broken(kind: str, error: Exception) -> Text:
    return Text("can not be read as {kind}: {why}", kind=kind, why=visible(str(error)[:120]) or type(error).__name__)


def _floats(cells: Sequence[Any]) -> list[float]:
    """Numbers; what is none is NaN: a column of words is asked for by nobody."""
    found = []
    for cell in cells:
        try:
            found.append(math.nan if cell is None or isinstance(cell, str) else float(cell))
        except (TypeError, ValueError):
            found.append(math.nan)
    return found
