# SPDX-License-Identifier: Apache-2.0
"""What of a solved design is drawn: the shaft, and beside it the data of its wheels."""

from collections.abc import Mapping
from math import pi

from ..countershaft.result import CountershaftResult
from ..draw.annotations import Say
from ..draw.drawing import Arc, Primitive, Words
from ..draw.shaft_outline import shaft_drawing
from ..draw.workshop import shaft_sheet, wheel_sheets
from ..draw.workshop_sheet import PAPER, WorkshopSheet
from ..gears.profile.drawing import data_table, in_row, reach
from ..gears.result import TrainResult
from ..sheet.step import Table
from ..sheet.text import EMPTY, Name, Text
from ..solve import Results

__all__ = ["PAPER", "WorkshopSheet", "shaft", "sheets", "train", "wheels"]
NONE = Text("–")


def shaft(results: Results) -> tuple[Primitive, ...]:
    """The side view of the counter-shaft as lines; nothing where its outline is not known."""
    asked, solved = results.design.countershaft, results.result(CountershaftResult)
    if asked is None or solved is None or solved.outline is None:
        return ()
    return shaft_drawing(solved.outline, asked.bearing_positions)


def sheets(results: Results, say: Say = str, data: Mapping[str, object] | None = None) -> list[WorkshopSheet]:
    """The workshop drawings of what the design has: its shaft, or its wheels where it is of gears alone.

    `data`: of the design's file, for what it leaves to the program.
    """
    if results.design.countershaft is None:
        return wheel_sheets(results, say, data)
    sheet = shaft_sheet(results, say, data)
    return [] if sheet is None else [sheet]


def wheels(results: Results) -> Table | None:
    """The data of every wheel as they stand on its drawing, with limits where the design gives them; lengths in mm."""
    train, gears = results.result(TrainResult), results.design.gears
    if train is None or gears is None:
        return None
    data = {name: dict(data_table(train, name, gears)) for name in train.wheels}
    labels = dict.fromkeys(label for rows in data.values() for label in rows)
    rows = tuple((label, *(rows.get(label, NONE) for rows in data.values())) for label in labels)
    return Table(
        "drawing_data",
        Text("Data of the wheels, lengths in mm"),
        ((EMPTY, ""), *((Name(name), "") for name in data)),
        rows,
    )


def train(results: Results) -> tuple[Primitive, ...]:
    """The wheels of a train as circles, each beside its driver and with its name."""
    solved = results.result(TrainResult)
    if solved is None:
        return ()
    drawn: list[Primitive] = []
    for name, centre in in_row(solved).items():
        x, y, radius = centre.real, centre.imag, reach(solved, name)
        drawn += [Arc("OUTLINE", (x, y), radius, 0.0, 2 * pi), Arc("AXIS", (x, y), radius / 12, 0.0, 2 * pi)]
        drawn.append(Words("TEXT", (x, y - radius), Name(name), radius / 4))
    return tuple(drawn)
