# SPDX-License-Identifier: Apache-2.0
"""How the engine runs: one table of speed, load, hours, gas and oil, from which the other steps read; and the twist of
its crank.

In order: a row, the bench run, the crank's twist, what is wrong with rows, what rows say of the gas."""

from collections.abc import Iterator, Sequence
from typing import Any

from ..sheet.quantity import dotted, inputs, quantity, text
from ..sheet.record import record
from ..sheet.text import Text
from ..sheet.units import Number, RevPerSecond
from .gas import GasInputs

GAS_KEYS = ("peak_pressure", "intake_pressure", "exhaust_pressure", "crankcase_pressure", "constant_pressure_angle")


class OfGas:
    """A row that may say something of the gas at its speed."""

    __slots__ = ()
    speed: float

    @property
    def has_gas(self) -> bool:
        """Whether it does: it is a node then, between which other speeds lie."""
        return any(getattr(self, key) is not None for key in GAS_KEYS)


@inputs
class Operation(OfGas):
    """How the engine runs at a speed and load: its gas where that differs from [engine.gas], for how long, with which
    oil."""

    name: str = text("Name", help="idle, cruise, rated or any other word.")
    speed: float = quantity("Speed", "rpm", up_to=1e5, symbol="n", help="Of the crank.", repair="asked")
    load: float = quantity(
        "Load",
        "%",
        default=1.0,
        within=(0, 100),
        symbol="p",
        help="Of the full load at this speed: 0 no brake load.",
        repair="asked",
    )
    hours: float | None = quantity(
        "Hours",
        default=None,
        up_to=1e9,
        symbol="w",
        help="In any unit: their shares count. Left out: not a part of the bearings' duty.",
        repair="asked",
    )
    oil_temperature: float | None = quantity(
        "Oil temperature",
        "°C",
        default=None,
        within=(-40, 200),
        symbol="T_oil",
        help="Where it reaches the bearings. Left out: their supply_temperature_C.",
        repair="asked",
    )
    oil_pressure: float | None = quantity(
        "Oil pressure",
        "bar",
        default=None,
        within=(0, 100),
        symbol="p_s",
        rule_of_thumb=(1, 6),
        help="In the main gallery, above ambient; with the temperature a row of the bench run.",
    )
    peak_pressure: float | None = quantity(
        "Peak pressure",
        "bar",
        default=None,
        up_to=1000,
        symbol="p_max",
        rule_of_thumb=(10, 220),
        help="At this speed, absolute; left out: that of [engine.gas].",
    )
    intake_pressure: float | None = quantity(
        "Intake pressure",
        "bar",
        default=None,
        up_to=100,
        symbol="p_in",
        rule_of_thumb=(0.3, 3.5),
        help="At this speed, absolute; left out: that of [engine.gas].",
    )
    exhaust_pressure: float | None = quantity(
        "Exhaust pressure",
        "bar",
        default=None,
        up_to=100,
        symbol="p_ex",
        rule_of_thumb=(1, 4),
        help="At this speed, absolute; left out: that of [engine.gas].",
    )
    crankcase_pressure: float | None = quantity(
        "Crankcase pressure",
        "bar",
        default=None,
        within=(0, 100),
        symbol="p_case",
        help="At this speed, absolute; left out: that of [engine.gas].",
    )
    constant_pressure_angle: float | None = quantity(
        "Peak pressure held for", "°", default=None, within=(0, 90), symbol="epsilon_p", help="Crank angle after TDC."
    )


@inputs
class BenchPoint:
    """One row of a bench run: the main gallery's oil at a speed."""

    speed: float = quantity(
        "Speed",
        "rpm",
        within=(1, 30000),
        symbol="n",
        help="Speed of the crank in this row of the bench run.",
        repair="asked",
    )
    oil_temperature: float = quantity(
        "Oil temperature",
        "°C",
        within=(-40, 200),
        symbol="T_in",
        rule_of_thumb=(60, 140),
        help="Oil in the main gallery at this speed.",
        repair="asked",
    )
    oil_pressure: float = quantity(
        "Oil pressure",
        "bar",
        within=(0, 100),
        symbol="p_s",
        rule_of_thumb=(1, 6),
        help="Oil in the main gallery at this speed, above ambient.",
    )


@inputs
class CrankTwist:
    """The first torsional mode of the crank: two masses, the nose before, all else behind."""

    frequency: float = quantity(
        "Frequency of the twist",
        "Hz",
        up_to=10000,
        symbol="f_t",
        rule_of_thumb=(150, 800),
        help="Of the first torsional mode of the crank with flywheel and pulley.",
    )
    nose_inertia: float = quantity(
        "Inertia at the nose",
        "kg·m²",
        up_to=1e5,
        symbol="J_n",
        rule_of_thumb=(0.001, 5),
        help="What swings at the front: below that of flywheel and train.",
    )
    damping_ratio: float = quantity(
        "Damping ratio",
        default=0.03,
        within=(0, 0.3),
        symbol="zeta_t",
        help="Of this mode.",
    )


# --- what is wrong with rows


def operation_problems(rows: Sequence[Operation], gas: GasInputs | None, strokes: int) -> Iterator[tuple[str, Text]]:
    """With keys of [[engine.operation]]."""
    taken: dict[tuple[float, float], str] = {}
    for i, row in enumerate(rows):
        if (other := taken.setdefault((row.speed, row.load), row.name)) != row.name:
            reason = Text('speed and load are those of "{other}": every row has one of its own', other=other)
            yield dotted(i, Operation.speed), reason
        if row.has_gas and (gas is None or gas.pressure):
            yield f"{i}", Text("its pressures need [engine.gas] with a peak pressure, of which they are changes")
        if row.exhaust_pressure is not None and strokes == 2:
            reason = Text("belongs to a four-stroke engine; a two-stroke has no exhaust stroke: leave it out")
            yield dotted(i, Operation.exhaust_pressure), reason


# --- what rows say of the gas

NEAR_IDLE = 0.05  # of idle speed: a row so near is one of idle


@record
class GasRow:
    """The gas at a speed and load, as it is given; None: that of [engine.gas]."""

    speed: RevPerSecond
    load: Number  # 0 to 1
    changes: dict[str, Any]  # by the fields of GasInputs


def near_idle(speed: RevPerSecond, idle: RevPerSecond) -> bool:
    """Whether a row at this speed is one of idle."""
    return abs(speed - idle) <= NEAR_IDLE * idle


def changes(row: OfGas) -> dict[str, Any]:
    """What a row says of the gas, by the fields of GasInputs."""
    return {key: value for key in GAS_KEYS if (value := getattr(row, key)) is not None}


def over_speed(rows: Sequence[Operation], idle: RevPerSecond) -> tuple[Operation, ...]:
    """One row for each speed, ascending, where a step knows of no load: near idle speed that of the least load,
    elsewhere that of the most."""
    by_speed: dict[float, Operation] = {}
    for row in sorted(rows, key=lambda row: (row.speed, -row.load)):
        if near_idle(row.speed, idle):
            by_speed[row.speed] = row
        else:
            by_speed.setdefault(row.speed, row)
    return tuple(by_speed.values())
