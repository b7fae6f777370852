# SPDX-License-Identifier: Apache-2.0
"""The rows of a run that are used: speed, conditions, and of each column what it says and how surely.

Also as CSV, as a report has them inside: read again, they are the same rows."""

import csv
import io
import math
import re
from collections.abc import Callable, Iterable, Mapping
from difflib import get_close_matches

from ..sheet.quantity import dotted
from ..sheet.record import record
from ..sheet.text import Text
from ..sheet.units import UNITS
from .inputs import Condition, MeasuredColumn, Measurement
from .reading import RunFile, Unread, named
from .units import canonical, conversion

SHOWN = 12  # columns of a file that are named
ROOT_2 = math.sqrt(2.0)
KEPT = "# rows used of a file with sha256 {digest}, {lost} left out\n"  # first line of what a report has inside
DIGEST = re.compile(rb"# rows used of a file with sha256 ([0-9a-f]{64}), ([0-9]{1,5}) left out\r?\n")
Problem = tuple[str, Text]  # the key in the table of the run, and what is wrong there


@record
class ColumnRows:
    """A column row by row, NaN where nothing was measured, in `unit` (None: that of its value): what it says, its
    standard uncertainty of a row, and the one that all rows share, signed as an error of all together would be; None
    where none is given."""

    y: tuple[float, ...]
    sigma: tuple[float, ...] | None
    common: tuple[float, ...] | None
    unit: str | None


@record
class RunRows:
    """A run as it is used: of its rows those with a speed.  `conditions`: by the keys of inputs, in SI; `lost`: how
    many rows have no speed above 0, or no condition; `kept`: all of it as CSV."""

    name: str
    file: str
    sha256: str
    speed: tuple[float, ...]  # 1/s
    conditions: Mapping[str, tuple[float, ...]]
    columns: Mapping[str, ColumnRows]
    lost: int
    kept: bytes

    def __eq__(self, other: object) -> bool:
        return isinstance(other, RunRows) and (self.name, self.kept) == (other.name, other.kept)

    __hash__ = None  # type: ignore[assignment]


def rows_of(
    run: Measurement, file: RunFile, unit_of_key: Callable[[str], str], kept: bytes = b""
) -> tuple[RunRows | None, list[Problem]]:
    """The rows of a run in its file, or what is wrong with either.  `unit_of_key`: that of an input, in which a
    condition is where the file says none; `kept`: the bytes of a file that a report has inside."""
    reader = _Rows(run, file)
    n = len(file.lines)
    if run.speed is not None:
        speed = [run.speed] * n
    else:
        speed = reader.numbers(dotted(Measurement.speed_), run.speed_ or "", "rpm")
        speed = [x / 60 for x in speed]
    conditions = {}
    for i, condition in enumerate(run.conditions):
        here = dotted(Measurement.conditions, i, Condition.column)
        unit = unit_of_key(condition.key)
        shown = reader.numbers(here, condition.column, unit)
        conditions[condition.key] = [UNITS[unit].inside(x) for x in shown]
    columns = {name: reader.column(i, column) for i, (name, column) in enumerate(zip(run.column_names, run.columns))}
    if reader.problems:
        return None, reader.problems
    used = [i for i in range(n) if speed[i] > 0 and all(math.isfinite(x[i]) for x in conditions.values())]
    if not any(math.isfinite(column.y[i]) for column in columns.values() for i in used):
        return None, [(dotted(Measurement.file), Text("has no row with a speed above 0 and a number beside it"))]
    whole = DIGEST.match(kept)
    digest, lost = (whole[1].decode(), int(whole[2])) if whole else (file.sha256, n - len(used))
    return RunRows(
        run.name,
        run.file,
        digest,
        tuple(speed[i] for i in used),
        {key: tuple(x[i] for i in used) for key, x in conditions.items()},
        {name: _of_rows(column, used) for name, column in columns.items()},
        lost,
        _csv(run, file, used, KEPT.format(digest=digest, lost=lost)),
    ), []


def _of_rows(column: ColumnRows, used: list[int]) -> ColumnRows:
    def some(x: tuple[float, ...] | None) -> tuple[float, ...] | None:
        return None if x is None else tuple(x[i] for i in used)

    return ColumnRows(tuple(column.y[i] for i in used), some(column.sigma), some(column.common), column.unit)


def _tuple(x: list[float] | None) -> tuple[float, ...] | None:
    return None if x is None else tuple(x)


class _Rows:
    """Columns of a file by what the run says of them; what is wrong is collected."""

    def __init__(self, run: Measurement, file: RunFile) -> None:
        self.run, self.file = run, file
        self.problems: list[Problem] = []

    def plain(self, key: str, column: str) -> list[float]:
        """A column as it stands; NaN where it is not there, which is a problem."""
        nothing = [math.nan] * len(self.file.lines)
        if column not in self.file.columns:
            near = get_close_matches(column, list(self.file.columns), 1)
            others = ", ".join(map(named, list(self.file.columns)[:SHOWN]))
            known = (
                Text('; did you mean "{near}"?', near=named(near[0]))
                if near
                else Text("; there are {others}", others=others)
            )
            no_column = Text("{file} has no such column", file=self.run.file) + known
            self.problems.append((key, no_column))
            return nothing
        try:
            return self.file.numbers(column)
        except Unread as wrong:
            self.problems.append((key, Text("{file}: {wrong}", file=self.run.file, wrong=wrong.text)))
            return nothing

    def numbers(self, key: str, column: str, into: str) -> list[float]:
        """The same in a unit of this program."""
        numbers = self.plain(key, column)
        unit = self.file.units.get(column, into)
        if unit == into:
            return numbers
        how = conversion(unit, into)
        if how is None:
            other = Text(
                "is in {unit} by the line of units of {file}; needs {into}, or a unit of its dimension",
                unit=named(unit),
                file=self.run.file,
                into=into or "1",
            )
            self.problems.append((key, other))
            return numbers
        factor, zero = how
        return [factor * (x + zero) for x in numbers]

    def column(self, i: int, about: MeasuredColumn) -> ColumnRows:
        where = dotted(Measurement.columns, i)
        y = self.plain(dotted(where, MeasuredColumn.column), about.column)
        unit = self._unit(where, about)
        shares = [
            (about.uncertainty_, about.uncertainty, about.uncertainty_column, MeasuredColumn.uncertainty_column),
            (
                about.uncertainty_common_,
                about.uncertainty_common,
                about.uncertainty_common_column,
                MeasuredColumn.uncertainty_common_column,
            ),
        ]
        own, shared = (self._uncertainty(y, where, *each) for each in shares)
        common = about.uncertainty_common
        if (
            shared is not None
            and common is not None
            and about.uncertainty_common_ is None
            and not (about.uncertainty_common_column)
        ):
            shared = [common * x for x in y]  # a factor that is wrong is wrong with the sign of what it multiplies
        if about.peak:
            y = [x / ROOT_2 for x in y]
            own, shared = (None if each is None else [x / ROOT_2 for x in each] for each in (own, shared))
        return ColumnRows(tuple(y), _tuple(own), _tuple(shared), unit)

    def _unit(self, where: str, about: MeasuredColumn) -> str | None:
        """The unit of a column: what the run says, which must be what the file says, if that says any."""
        file_unit = self.file.units.get(about.column)
        if about.unit is None:
            return file_unit
        unit = canonical(about.unit)
        if file_unit is not None and file_unit != unit:
            other = Text(
                "is {file_unit} by the line of units of {file}", file_unit=named(file_unit), file=self.run.file
            )
            self.problems.append((dotted(where, MeasuredColumn.unit), other))
        return unit

    def _uncertainty(
        self, y: list[float], where: str, size: float | None, share: float | None, column: str | None, key: object
    ) -> list[float] | None:
        if size is None and share is None and column is None:
            return None
        squares = [(size or 0.0) ** 2 + ((share or 0.0) * x) ** 2 for x in y]
        if column is not None:
            here = dotted(where, key)
            more = self.plain(here, column)
            for row, sigma in enumerate(more):
                if sigma < 0:
                    negative = Text("{file}: line {line}: is below 0", file=self.run.file, line=self.file.lines[row])
                    self.problems.append((here, negative))
                    break
            squares = [a + b * b for a, b in zip(squares, more)]
        return [math.sqrt(square) for square in squares]


# --- as CSV again


def _csv(run: Measurement, file: RunFile, used: Iterable[int], head: str) -> bytes:
    """The columns that are used, row by row, in the units of the file."""
    wanted = [run.speed_, *(condition.column for condition in run.conditions)]
    for about in run.columns:
        wanted += [about.column, about.uncertainty_column, about.uncertainty_common_column]
    names = list(dict.fromkeys(name for name in wanted if name))
    columns = [file.numbers(name) for name in names]
    written = io.StringIO()
    written.write(head)
    writer = csv.writer(written, quoting=csv.QUOTE_NONNUMERIC, lineterminator="\n")
    writer.writerow(names)
    if any(name in file.units for name in names):
        writer.writerow([file.units.get(name, "") for name in names])
    for row in used:
        numbers = [float(column[row]) for column in columns]
        if any(math.isfinite(x) for x in numbers):
            writer.writerow([x if math.isfinite(x) else "" for x in numbers])
    return written.getvalue().encode()
