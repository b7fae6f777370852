# SPDX-License-Identifier: Apache-2.0
"""At which speeds and loads the engine runs, wherever a design says it: one reader for all steps."""

from ..engine.inputs import EngineInputs
from ..engine.operation import GasRow, changes, near_idle
from ..library.table_file import house_table
from ..mounting.inputs import MountingInputs
from ..sheet.units import RevPerSecond
from ..sheet.value import based_on


def idle_speed(engine: EngineInputs, mounting: MountingInputs | None) -> RevPerSecond:
    """Given for the engine, else for its mounts, else a share of the rated speed, and never above that."""
    if engine.idle_speed is not None:
        return engine.idle_speed
    if mounting is not None:
        return mounting.idle_speed
    rated, usual = engine.rated_speed, house_table("engine_motion.toml")["idle"]
    idle: float = min(max(usual["share"] * rated, usual["from_rpm"] / 60), usual["up_to_rpm"] / 60, rated)
    return based_on(idle, rated)


def operations(engine: EngineInputs, mounting: MountingInputs | None) -> tuple[GasRow, ...]:
    """The rows that say something of the gas: those of [[engine.operation]], where there are none those of
    [[mounting.operation]], of which one near idle speed is without load and every other at full load."""
    if rows := tuple(GasRow(row.speed, row.load, changes(row)) for row in engine.operation if row.has_gas):
        return rows
    if mounting is None:
        return ()
    idle = mounting.idle_speed
    return tuple(
        GasRow(row.speed, 0.0 if near_idle(row.speed, idle) else 1.0, changes(row))
        for row in mounting.operation
        if row.has_gas
    )
