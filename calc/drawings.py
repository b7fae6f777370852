# SPDX-License-Identifier: Apache-2.0
"""What of a solved design is drawn: the shaft, and beside it the data of its wheels."""

from .countershaft.result import CountershaftResult
from .gears.result import TrainResult
from .sheet.drawing import Primitive
from .sheet.step import Table
from .sheet.text import EMPTY, Name, Text
from .solve import Results


def shaft(results: Results) -> tuple[Primitive, ...]:
    """The counter-shaft as lines, arcs, words and dimensions; nothing where its outline is not known."""
    from .countershaft.drawing import shaft_drawing

    asked, found = results.design.countershaft, results.result(CountershaftResult)
    if asked is None or found is None or found.outline is None:
        return ()
    return shaft_drawing(found.outline, asked.bearing_positions, results.design.name, Text("not to scale"))


def wheels(results: Results) -> Table | None:
    """The data of every wheel as they stand on its drawing, with limits where the design gives them; lengths in mm."""
    from .gears.profile.drawing import data_table

    train, gears = results.result(TrainResult), results.design.gears
    if train is None or gears is None:
        return None
    data = {name: dict(data_table(train, name, gears)) for name in train.wheels}
    labels = dict.fromkeys(label for rows in data.values() for label in rows)
    rows = tuple((label, *(rows.get(label, "–").replace("-", "−") for rows in data.values())) for label in labels)
    return Table("drawing_data", Text("Data of the wheels, lengths in mm"), ((EMPTY, ""), *((Name(name), "") for name in data)), rows)
