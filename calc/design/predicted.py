# SPDX-License-Identifier: Apache-2.0
"""What was measured, beside what is predicted at the same speed: the rows of [[measured]] as a table of each step."""

from collections.abc import Callable
from difflib import get_close_matches
from functools import partial

import numpy as np

from ..bearings.inputs import BearingsInputs
from ..bearings.plain.result import PlainResult
from ..countershaft.rows import BearingRow
from ..sheet.deferred import Later
from ..sheet.inputs_at import content_at
from ..sheet.quantity import Published, dotted
from ..sheet.record import replace
from ..sheet.step import Outcome, Table
from ..sheet.text import EMPTY, SPACE, Amount, Name, Text
from ..sheet.units import RevPerSecond
from .model import Design
from .other_tables import Measured

Values = dict[str, Published]
COLUMNS = (
    (Text("Value"), ""),
    (Text("Speed"), "rpm"),
    (Text("Measured"), ""),
    (Text("Uncertainty"), ""),
    (Text("Predicted"), ""),
    (Text("Unit"), ""),
    (Text("Deviation"), "%"),
    (Text("Verdict"), ""),
)
TITLE = Text("Measured beside predicted")
NO_VALUE = Text("this design has no such value")
NOT_THERE = Text("is not known at this speed")
NOTE = Text(
    "Deviation: predicted less measured, over measured. Inside: within the uncertainty of the measurement. An input is "
    "no prediction: what the design takes stands beside it. At another speed the design is solved again with its "
    "clearances as they are, and with the oil of the bench run at that speed where there is one."
)


class Predicted:
    """What a design gives at the speeds of its measurements, each solved once.  `at` solves a design and gives its
    values.  A row without a speed is one of the design as it stands."""

    def __init__(self, design: Design, values: Values, at: Callable[[Design], Values]) -> None:
        self._design, self._values, self._at = design, values, at
        self._solved: dict[float, tuple[Design, Values]] = {}

    def of(self, row: Measured) -> tuple[float | None, Text]:
        """The value of a row in its unit, or None and why there is none: of an input what the design takes."""
        speed, engine = row.speed, self._design.engine
        if speed is None or engine is None or as_it_stands(self._design, speed):
            return _predicted(row, self._design, self._values)
        if (
            row.value not in self._values
            and _input(self._design, row.value) is not None
            and not (row.value in BENCH and engine.gallery)
        ):
            return None, Text("is an input of no speed of its own: leave speed_rpm out")
        if speed not in self._solved:
            other = at_speed(self._design, speed, self._values)
            self._solved[speed] = other, self._at(other)
        # no film, or a share of the rated power
        if row.value in self._values and row.value not in self._solved[speed][1]:
            return None, NOT_THERE
        return _predicted(row, *self._solved[speed])

    def name(self, row: Measured) -> Text:
        """What was measured; an address that is none, as it stands."""
        value = self._values.get(row.value)
        if value is None:
            about = content_at(self._design, row.value)[1]
            return about.label if about is not None else Name(row.value)
        return Text("{label} ({id})", label=value.label, id=Name(row.value))

    def speed(self, row: Measured) -> float | None:
        """In rpm."""
        engine = self._design.engine
        speed = row.speed if row.speed is not None else engine.rated_speed if engine is not None else None
        return None if speed is None else speed * 60


def with_measured(
    design: Design, outcomes: dict[str, Outcome[object]], predicted: Callable[[], Predicted]
) -> dict[str, Outcome[object]]:
    """The outcomes, each with a table of what was measured of it, made when it is looked at."""
    steps = [design.step_of(row.value) for row in design.measured]
    for key in outcomes.keys() & steps:
        outcome, rows = outcomes[key], [row for row, step in zip(design.measured, steps) if step == key]
        if outcome.state == "solved":
            outcomes[key] = replace(outcome, tables=Later(partial(_tables, outcome, rows, predicted)))
    return outcomes


def _tables(outcome: Outcome[object], rows: list[Measured], predicted: Callable[[], Predicted]) -> tuple[Table, ...]:
    return measured_table(rows, predicted()), *outcome.tables


def measured_table(rows: list[Measured], predicted: Predicted) -> Table:
    notes = [Text("{value}: {note}.", value=predicted.name(row), note=row.note) for row in rows if row.note]
    cells, note = tuple(_row(row, predicted) for row in rows), SPACE.join([NOTE, *notes])
    return Table("measured", TITLE, COLUMNS, cells, note, short=True)


def compared_table(a: tuple[Design, Predicted], b: tuple[Design, Predicted], names: tuple[str, str]) -> Table | None:
    """What was measured of either design beside what both predict; None where nothing was."""
    rows = {(row.value, row.speed, row.is_): row for design, _ in (a, b) for row in design.measured}
    if not rows:
        return None
    columns = [(Text("Value"), ""), (Text("Speed"), "rpm"), (Text("Measured"), ""), (Text("Unit"), "")]
    columns += [column for name in names for column in ((Name(name), ""), (Text("Deviation"), "%"))]
    cells = []
    for row in rows.values():
        sides = [predicted.of(row)[0] for _, predicted in (a, b)]
        shown = [cell for side in sides for cell in (side, _deviation(side, row.is_))]
        speeds = {predicted.speed(row) for _, predicted in (a, b)}
        cells.append((Name(row.value), speeds.pop() if len(speeds) == 1 else None, row.is_, Name(row.unit), *shown))
    return Table("measured", TITLE, tuple(columns), tuple(cells))


def _row(row: Measured, predicted: Predicted) -> tuple[str | float | None, ...]:
    value, verdict = predicted.of(row)
    if value is not None and row.uncertainty is not None:
        off = abs(value - row.is_) - row.uncertainty
        verdict = Text("inside") if off <= 0 else Text("outside, by {off}", off=Amount(off, row.unit))
    deviation, name = _deviation(value, row.is_), predicted.name(row)
    return name, predicted.speed(row), row.is_, row.uncertainty, value, Name(row.unit), deviation, verdict


def _deviation(predicted: float | None, measured: float) -> float | None:
    return 100 * (predicted - measured) / abs(measured) if predicted is not None and measured else None


def _predicted(row: Measured, design: Design, values: Values) -> tuple[float | None, Text]:
    value = values.get(row.value)
    taken = _input(design, row.value) if value is None else None
    given = taken if value is None else (value.shown, value.unit)
    if given is None:
        near = get_close_matches(row.value, list(values), 1)
        return None, Text("this design has no such value; did you mean {near}?", near=near[0]) if near else NO_VALUE
    if given[1] != row.unit:
        return None, Text("is shown in {unit}: give it so", unit=given[1] or "1")
    if taken is not None:
        return None, Text("an input, taken as {value}", value=Amount(*taken))
    return given[0], EMPTY


def _input(design: Design, address: str) -> tuple[float, str] | None:
    """A number of the design by the key of the file, in the unit of that key."""
    here, about = content_at(design, address)
    return (about.units.shown(here), about.unit) if about is not None and isinstance(here, (int, float)) else None


BENCH = (
    dotted(Design.bearings, BearingsInputs.supply_temperature),
    dotted(Design.bearings, BearingsInputs.supply_pressure),
)  # the inputs whose content at a speed is that of the engine's bench run


def as_it_stands(design: Design, speed: RevPerSecond) -> bool:
    """Whether a design at this speed of its engine is the very design: at the rated one, unless its oil there is that
    of the bench run."""
    engine = design.engine
    if engine is None or speed != engine.rated_speed:
        return engine is None
    speeds = [row.speed for row in engine.gallery] if design.bearings is not None else []
    return not speeds or not min(speeds) <= speed <= max(speeds)


def at_speed(design: Design, speed: RevPerSecond, values: Values) -> Design:
    """The design at a speed of its engine: clearances as they were made, oil as the bench run had it there, below and
    above the run as at its nearest row; at a rated speed outside of the run the oil stays as it is given.

    `values`: those of the design, of which the clearances are taken."""
    assert design.engine is not None
    rated = design.engine.rated_speed
    power = design.engine.rated_power if speed == rated else None  # which is that of no other speed
    engine, bearings = replace(design.engine, rated_speed=speed, rated_power=power), design.bearings
    changed = replace(design, engine=engine, measured=())
    if bearings is None:
        return changed
    for name, view in design.views.items():
        ids = design.ids_of(dotted(Design.bearings), name)
        clearances = [values.get(dotted(ids, row.name, PlainResult.clearance)) for row in view.rows]
        if view.own is not None:
            changed = changed.with_shaft(replace(view.own, bearings=tuple(map(_as_made, view.rows, clearances))))
    if design.engine.gallery and not as_it_stands(design, speed):
        run = sorted(design.engine.gallery, key=lambda row: row.speed)
        speeds = [row.speed for row in run]
        temperature = float(np.interp(speed, speeds, [row.oil_temperature for row in run]))
        pressure = float(np.interp(speed, speeds, [row.oil_pressure for row in run]))
        bearings = replace(bearings, supply_temperature=temperature, supply_pressure=pressure)
    return replace(changed, bearings=bearings)


def _as_made(side: BearingRow, clearance: Published | None) -> BearingRow:
    """A bearing whose clearance does not follow the speed."""
    if side.clearance_factor is None or clearance is None:
        return side
    return replace(side, clearance=clearance.inside, clearance_factor=None)
