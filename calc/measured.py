# SPDX-License-Identifier: Apache-2.0
"""What was measured of a design: a row of [[measured]]; `prediction.py` lays it beside what is predicted.

[[measured]]
value = "bearings.front.oil_flow"      # the id of a value, or the key of an input
speed_rpm = 2000                       # left out: the design's own speed
is = 0.52
unit = "L/min"
uncertainty = 0.05                     # in the same unit
note = "bench, 12 October"
"""

from collections.abc import Iterable

from .sheet.quantity import inputs, quantity, text
from .sheet.text import Text
from .sheet.units import UNITS


@inputs
class Measured:
    """One row of [[measured]]."""

    value: str = text("Value", help="The id of a value, as `check --all` prints it, or the key of an input.")
    speed: float | None = quantity("Speed", "rpm", above=0, high=30000, default=None, help="Left out: the design's own speed.")
    is_: float = quantity("Measured", help="In the unit of the row.")
    unit: str = text("Unit", default="", help="That in which the value is shown.")
    uncertainty: float | None = quantity("Uncertainty", low=0, default=None, help="In the unit of the row.")
    note: str = text("Note", default="", help="Instrument, date, conditions.")

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.unit not in UNITS:
            yield "unit", Text('"{unit}" is no unit that values are shown in', unit=self.unit)

    @property
    def step(self) -> str:
        return self.value.partition(".")[0]
