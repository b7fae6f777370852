# SPDX-License-Identifier: Apache-2.0
"""Gas, idle speed and flywheel of an engine to begin with, by its kind: how its crank turns, and what the teeth of its
train carry, follow from them.

The pressures are usual ones and hold whatever the size of the engine; the flywheel is that with which it idles without
load as unevenly as is usual (`calc/library/tables/engine_motion.toml`)."""

import math

import numpy as np

from ...design.addresses import as_table
from ...design.model import SCHEMA, Design
from ...design.operations import idle_speed
from ...design.toml_file import Document, design
from ...engine.gas import GasInputs
from ...engine.inputs import EngineInputs
from ...engine.load import crank_torque
from ...engine.result import EngineResult
from ...gears.drive.crank import default_row, irregularity
from ...library.table_file import house_table
from ...sheet.errors import NoSolution
from ...sheet.quantity import dotted
from ...sheet.record import record
from ...sheet.units import KilogramMetre2, Number
from ...solve import solve
from .writing import Rows, Section, head, table, up

KEYS = (
    GasInputs.peak_pressure,
    GasInputs.compression_ratio,
    GasInputs.intake_pressure,
    GasInputs.exhaust_pressure,
    GasInputs.constant_pressure_angle,
)


@record
class Usual:
    """What [engine] has more, and the table of its gas where it gives none."""

    rows: Rows
    gas: list[Section]


def usual(engine: EngineInputs, document: Document, kind: str) -> Usual:
    """Of an engine and its document, what it does not give; no flywheel where the cycle without load is not solved.

    An engine that has other strokes than its kind, a torque diagram or unlike motions, is not told its gas."""
    known, of = house_table("engine_motion.toml")["usual"][kind], as_table(document.data[dotted(Design.engine)])
    words, rows, gas = known["words"], Rows(), list[Section]()
    slowest = dotted(EngineInputs.idle_speed)
    if engine.idle_speed is None and known[slowest] < 60 * engine.rated_speed:
        rows[EngineInputs.idle_speed] = (known[slowest], f"assumed: usual of {words}")
    alike = engine.strokes == (2 if kind == "two-stroke" else 4) and not engine.unlike_motions
    if engine.gas is None and not engine.torque and alike:
        pressures: Rows = {key: (known[dotted(key)], "assumed, as above") for key in KEYS if dotted(key) in known}
        pressures[KEYS[0]] = (known[dotted(KEYS[0])], f"assumed: usual of {words}")
        gas = [(head(Design.engine, EngineInputs.gas), pressures)]
    if engine.flywheel_inertia is None and (engine.gas is not None or gas):
        more = as_table(table([(head(Design.engine), rows), *gas])[dotted(Design.engine)])
        there = Document({"schema": SCHEMA, "name": "", dotted(Design.engine): {**of, **more}})
        J, delta = flywheel(there)
        if J is not None:
            rows[EngineInputs.flywheel_inertia] = (J, f"assumed: at idle it turns unevenly by {delta:g}, as is usual")
    return Usual(rows, gas)


def flywheel(document: Document) -> tuple[KilogramMetre2 | None, Number]:
    """The inertia, to two digits, with which an engine idles as unevenly as is usual of its number of cylinders; and
    that irregularity.  None where its cycle without load is not solved."""
    made = design(document)
    engine, known = made.engine, solve(made).result(EngineResult)
    assert engine is not None and known is not None
    idle = idle_speed(engine, None)
    delta = default_row(engine, idle).delta
    try:
        torque = crank_torque(engine, known, (), np.array([idle]), np.zeros(1), idle=idle)
    except NoSolution:
        return None, delta
    of_unit = irregularity(alpha_n=torque.t[0], n=torque.orders, omega=2 * math.pi * idle, cycle=torque.cycle)
    J = float(of_unit) / delta
    digit = 10.0 ** (math.floor(math.log10(J)) - 1)
    return round(up(J, digit), 9), delta
