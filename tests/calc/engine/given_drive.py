"""Engines and cases of the drive that an independent program computed: tests/reference/drive.json."""

import json
from functools import cache
from pathlib import Path

from calc.engine.gas import GasInputs
from calc.engine.inputs import EngineInputs
from calc.engine.operation import GasRow
from calc.engine.solve import solve

ROWS = json.loads((Path(__file__).parents[2] / "reference" / "drive.json").read_text(encoding="utf-8"))["given"]


def cases(begins, *ids):
    """Rows of the file whose case begins so, with one of these ids where they are named."""
    rows = [row for row in ROWS if row["case"].startswith(begins) and (not ids or row["id"] in ids)]
    assert rows, begins
    return rows


def gas_of(given, **changes):
    """[engine.gas] of a case."""
    return GasInputs(
        peak_pressure=given["p_max"],
        compression_ratio=given["ratio"],
        intake_pressure=given["p_in"],
        exhaust_pressure=given["p_ex"],
        crankcase_pressure=given["p_case"],
        compression_exponent=given["n_c"],
        expansion_exponent=given["n_e"],
        constant_pressure_angle=given["held"],
        **changes,
    )


def row_of(given, speed, load):
    """A row that says all of the gas."""
    return GasRow(
        speed,
        load,
        dict(
            peak_pressure=given["p_max"],
            intake_pressure=given["p_in"],
            exhaust_pressure=given["p_ex"],
            crankcase_pressure=given["p_case"],
            constant_pressure_angle=given["held"],
        ),
    )


@cache
def _engine(r, L, bore, m_rec, strokes, cylinders, rated, gas, rated_power):
    engine = EngineInputs(
        name="given",
        layout="inline",
        cylinders=cylinders,
        strokes=strokes,
        bore=bore,
        crank_radius=r,
        rod_length=L,
        cylinder_pitch=0.11,
        reciprocating_masses=(m_rec,),
        rotating_masses=(0.0,),
        rated_speed=rated,
        rated_power=rated_power,
        gas=gas,
    )
    return engine, solve(engine).result


def engine_of(given, gas, rated=2600 / 60, rated_power=None):
    """The engine of a case and its result, with this gas."""
    g = given["engine"]
    return _engine(
        g["r"], g["L"], g["bore"], g["m_rec"], g["strokes"], len(g["firing"]), rated, gas_of(gas), rated_power
    )
