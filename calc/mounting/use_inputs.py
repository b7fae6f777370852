# SPDX-License-Identifier: Apache-2.0
"""Where vibration is looked at, and at which speeds the engine runs."""

from ..sheet.quantity import choice, inputs, quantity, series, text
from .mount_inputs import PLACE

DAY = 24.0  # h


@inputs
class Point:
    """A place where vibration is looked at."""

    name: str = text("Name", help="Letters, digits and -.")
    position: tuple[float, ...] = series("Position", "mm", count=(3, 3), low=-20000, high=20000, symbol="r", help=PLACE)
    on: str = choice("Stands on", "engine", "chassis", default="engine")
    role: str = choice(
        "What it is",
        "machine",
        "seat",
        "hand",
        default="machine",
        help="seat, hand: what a person feels there is weighted as ISO 2631-1 and ISO 5349-1 ask.",
    )


@inputs
class Operation:
    """A speed at which the engine runs, and its gas there where it differs from that of [engine.gas]."""

    name: str = text("Name", help="Letters, digits and -.")
    speed: float = quantity("Speed", "rpm", above=0, high=30000, symbol="n", help="Of the crank.")
    hours: float | None = quantity("Hours a day", default=None, low=0, high=DAY, symbol="T", help="For the daily exposure.")
    peak_pressure: float | None = quantity(
        "Peak pressure",
        "bar",
        default=None,
        above=0,
        high=1000,
        symbol="p_max",
        help="At this speed, absolute; left out: that of [engine.gas].",
    )
    intake_pressure: float | None = quantity(
        "Intake pressure",
        "bar",
        default=None,
        above=0,
        high=100,
        symbol="p_in",
        help="At this speed, absolute; left out: that of [engine.gas].",
    )
    exhaust_pressure: float | None = quantity(
        "Exhaust pressure",
        "bar",
        default=None,
        above=0,
        high=100,
        symbol="p_ex",
        help="At this speed, absolute; left out: that of [engine.gas].",
    )
    crankcase_pressure: float | None = quantity(
        "Crankcase pressure",
        "bar",
        default=None,
        low=0,
        high=100,
        symbol="p_case",
        help="At this speed, absolute; left out: that of [engine.gas].",
    )
    constant_pressure_angle: float | None = quantity(
        "Peak pressure held for", "°", default=None, low=0, high=90, symbol="epsilon_p", help="Crank angle after TDC."
    )

    @property
    def has_gas(self) -> bool:
        """Whether the row says something of the gas: it is a node then, between which other speeds lie."""
        return any(getattr(self, key) is not None for key in GAS)


GAS = ("peak_pressure", "intake_pressure", "exhaust_pressure", "crankcase_pressure", "constant_pressure_angle")
