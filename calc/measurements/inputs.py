# SPDX-License-Identifier: Apache-2.0
"""The table [[measurements]]: a run of the bench in a file beside the design, and which of its columns is which value.

[[measurements]]
name = "drag-run"
file = "drag.csv"                      # beside the design, or below it
speed = "n"                            # its column; or speed_rpm = 2600 for all rows
conditions = [{ column = "t_oil", key = "bearings.supply_temperature_C" }]
columns = [{ column = "P", value = "friction.bearing_loss", unit = "W", uncertainty_percent = 2 }]
"""

from collections.abc import Iterable
from pathlib import PurePosixPath

from ..sheet.quantity import dotted, flag, inputs, names, quantity, tables, text
from ..sheet.text import Text
from .units import alike, known, listed

ENDINGS = ("csv", "txt", "parquet", "tdms")
BYTES, ROWS, NODES = 20_000_000, 20_000, 60  # at most, of a file and of a run
MOST_COLUMNS, MOST_CONDITIONS, MOST_SUMMED = 20, 6, 12


@inputs
class Condition:
    """A column that says what an input was, row by row."""

    column: str = text("Column", help="Of the file.")
    key: str = text("Input", help="The key of an input, in whose unit the column is where the file says none.")


@inputs
class MeasuredColumn:
    """A column of a run beside the value that is predicted of it.

    The uncertainties are standard ones, added as squares: those of one row, which differ from row to row, and those
    that all rows have in common, as of a calibration."""

    name: str | None = text(
        "Name", default=None, help="In ids: letters, digits and -. Left out: the last word of the value."
    )
    column: str = text("Column", help="Of the file.")
    value: tuple[str, ...] = names(
        "Value",
        count=(1, MOST_SUMMED),
        help="The id of a value, or the key of an input; a list: of values whose sum was measured.",
    )
    unit: str | None = text(
        "Unit", default=None, help="Of the column. Left out: that of the file's line of units, else that of the value."
    )
    peak: bool = flag("Peaks", default=False, help="The column has peaks of what the value is the rms of.")
    uncertainty_: float | None = quantity("Uncertainty", low=0, default=None, help="Of a row, in the column's unit.")
    uncertainty: float | None = quantity(
        "Uncertainty, relative", "%", within=(0, 100), default=None, help="Of a row, of what it says."
    )
    uncertainty_column: str | None = text(
        "Column of the uncertainty", default=None, help="Of the file, in the column's unit."
    )
    uncertainty_common_: float | None = quantity(
        "Common uncertainty", low=0, default=None, help="That all rows share, in the column's unit."
    )
    uncertainty_common: float | None = quantity(
        "Common uncertainty, relative",
        "%",
        within=(0, 100),
        default=None,
        help="That all rows share, of what they say.",
    )
    uncertainty_common_column: str | None = text(
        "Column of the common uncertainty", default=None, help="Of the file, in the column's unit."
    )

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.unit is not None and not known(self.unit):
            near = alike(self.unit)
            there = Text('; did you mean "{near}"? Of that kind are known {units}', near=near, units=listed(near))
            yield dotted(MeasuredColumn.unit), Text("is no unit that is known here") + (there if near else Text(""))
        shared = (self.uncertainty_common_, self.uncertainty_common, self.uncertainty_common_column)
        own = (self.uncertainty_, self.uncertainty, self.uncertainty_column)
        if any(each is not None for each in shared) and all(each is None for each in own):
            needs = Text("a common uncertainty needs that of a row beside it: give uncertainty or uncertainty_percent")
            yield dotted(MeasuredColumn.column), needs


@inputs
class Measurement:
    """One run: its file, its speeds, its conditions, its columns."""

    name: str = text("Name", help="In ids: letters, digits and -.")
    file: str = text(
        "File",
        help="Beside the design, or below it: .csv or .txt; .parquet (extra parquet), .tdms (extra tdms). At most "
        "20 000 rows and 20 MB.",
    )
    speed_: str | None = text(
        "Column of the speed", default=None, help="Of the crank, in rpm where the file says none."
    )
    speed: float | None = quantity("Speed", "rpm", up_to=30000, default=None, help="Of all rows.")
    conditions: tuple[Condition, ...] = tables(
        "Conditions", Condition, default=(), help="Columns that say what inputs were, row by row."
    )
    columns: tuple[MeasuredColumn, ...] = tables("Columns", MeasuredColumn, help="What was measured.")

    def problems(self) -> Iterable[tuple[str, Text]]:
        if (wrong := file_problem(self.file)) is not None:
            yield dotted(Measurement.file), wrong
        if (self.speed is None) == (self.speed_ is None):
            yield (
                dotted(Measurement.speed_),
                Text("give the column of the speed, or speed_rpm for all rows: one of them"),
            )
        for field, most in ((Measurement.columns, MOST_COLUMNS), (Measurement.conditions, MOST_CONDITIONS)):
            count = len(getattr(self, dotted(field)))
            if count > most:
                yield dotted(field), Text("has {count} entries; at most {most}", count=count, most=most)
        if not self.columns:
            yield dotted(Measurement.columns), Text("is empty; name at least one column that was measured")
        keys = [condition.key for condition in self.conditions]
        for n, condition in enumerate(self.conditions):
            if condition.key in keys[:n]:
                yield dotted(Measurement.conditions, n, Condition.key), Text("is set by another condition already")
        called = [name for name in (column.name for column in self.columns) if name is not None]
        if len(set(called)) < len(called):
            return  # the reading says so
        for n, (column, name) in enumerate(zip(self.columns, self.column_names)):
            if column.name is None and not name:
                yield (
                    dotted(Measurement.columns, n, MeasuredColumn.name),
                    Text("needs a name: its value has none for it"),
                )

    @property
    def column_names(self) -> tuple[str, ...]:
        """What the columns are called in ids: as they say, else the last word of the value, numbered where several are
        called alike."""
        taken = {column.name for column in self.columns if column.name is not None}
        found: list[str] = []
        for column in self.columns:
            name = column.name
            if name is None:
                stem = _word(column.value[0]) if column.value else ""
                name, n = stem, 2
                while name in taken:
                    name, n = f"{stem}-{n}", n + 1
                taken.add(name)
            found.append(name)
        return tuple(found)

    @property
    def column_ids(self) -> tuple[str, ...]:
        """The ids of their checks, and how those of their values begin."""
        return tuple(f"measured.{self.name}.{column}" for column in self.column_names)


def _word(id: str) -> str:
    """The last word of an id as an id of another may have it: `oil-flow` of bearings.front.oil_flow."""
    return "".join(c if c.isascii() and c.isalnum() else "-" for c in id.rpartition(".")[2]).strip("-")


def file_problem(file: str) -> Text | None:
    """What is wrong with the name of a file, before anybody looks for it."""
    path = PurePosixPath(file)
    if not file or not file.isprintable() or "\\" in file or path.is_absolute() or ":" in file:
        return Text("must be the name of a file beside the design, or below it, like runs/drag.csv")
    if ".." in path.parts:
        return Text("must lie beside the design or below it: its name must not lead out by ..")
    if path.suffix.lower().removeprefix(".") not in ENDINGS:
        ending = path.suffix or Text("no ending")
        known_endings = ", ".join(f".{each}" for each in ENDINGS)
        return Text(
            "has the ending {ending}, which is not read; export it as CSV ({endings} are read)",
            ending=ending,
            endings=known_endings,
        )
    return None
