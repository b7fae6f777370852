# SPDX-License-Identifier: Apache-2.0
"""Tables of numbers as CSV: the values; the strikes of the gears over speed and load; how the points of the engine move
over frequency."""

import csv
import math
from collections.abc import Iterable, Sequence
from io import StringIO

from assistant.exports.kinds import Made, Request
from calc.gears.drive.tables import map_rows
from calc.mounting.operations import rows as transfer_rows
from calc.mounting.result import MountingResult
from calc.sheet.errors import InputError
from calc.sheet.text import Text
from calc.solve import Results


def lacks(asked: Request) -> InputError | None:
    if asked.options.get("transfer"):
        mounting = asked.results.result(MountingResult)
        if mounting is None or not mounting.system.mounting.points:
            reason = Text("needed with [[mounting.points]] for transfer functions")
            return InputError(0, "mounting", "", reason)
    if asked.options.get("map"):
        train = asked.results.train
        if asked.results.design.gears is not None and asked.results.design.engine is None:
            return InputError(0, "engine", "", Text("needed for the map of the drive over speed: add [engine]"))
        if train is None or train.drive is None or not train.drive.meshes:
            return InputError(0, "gears", "", Text("needed, with [engine], for the map of the drive over speed"))
    return None


def made(asked: Request) -> Made:
    return Made({asked.path: _text(asked)})


def _text(asked: Request) -> str:
    results = asked.results
    if asked.options.get("transfer"):
        mounting = results.result(MountingResult)
        assert mounting is not None
        return _table(*transfer_rows(mounting))
    if asked.options.get("map"):
        assert results.train is not None and results.train.drive is not None
        return _table(*map_rows(results.train.drive))
    return _values(results)


def _values(results: Results) -> str:
    """A row for each value; a number that is not finite leaves its cell empty."""
    rows = (
        (id, value.shown if math.isfinite(value.shown) else "", value.unit, value.label, value.symbol)
        for id, value in results.values().items()
    )
    return _csv(("id", "value", "unit", "label", "symbol"), rows)


def _table(header: Sequence[str], numbers: Iterable[Sequence[float]]) -> str:
    """What is not finite leaves its cell empty."""
    return _csv(header, ([f"{x:.9g}" if math.isfinite(x) else "" for x in row] for row in numbers))


def _csv(header: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    file = StringIO()
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(header)
    writer.writerows(rows)
    return file.getvalue()
