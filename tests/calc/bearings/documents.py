"""Designs for the tests of the bearings: others with values changed, and bearings that stand alone."""

from calc.design.toml_file import Document, design
from calc.solve import solve

SIZES = {"diameter_mm": 60.0, "length_mm": 30.0, "clearance_um": 80.0, "load_N": 3000.0}
ROUGHNESS = {"journal_roughness_um": 0.4, "housing_roughness_um": 0.4}
TABLE = {
    "oil": "SAE 30",
    "supply_temperature_C": 60.0,
    "supply_pressure_bar": 2.0,
    "supply": "hole",
    "hole_diameter_mm": 5.0,
    "housing_material": "steel",
    "journal_material": "steel",
    "speed_rpm": 1500.0,
    "load_speed_ratio": 0.0,
}


def changed(document, **changes):
    """With other values: `front__length_mm` of that bearing, `supply` of all, `engine__rated_speed_rpm` of a step."""
    for key, value in changes.items():
        table, _, name = key.replace("__", ".").rpartition(".")
        place = f"shafts.shaft.bearings.{table}" if table in ("front", "rear") else table or "bearings"
        document = document.with_value(f"{place}.{name}", value)
    return document


def outcome(document, **changes):
    return solve(design(changed(document, **changes))).outcomes["bearings"]


def alone(**changes):
    """Two bearings without a shaft, an engine or gears, with other values as above; None takes one out."""
    rows = {
        name: {"name": name, "position_mm": z, **SIZES, **ROUGHNESS} for name, z in (("front", 0.0), ("rear", 1000.0))
    }
    table = dict(TABLE)
    for key, value in changes.items():
        place, _, name = key.rpartition("__")
        (rows[place] if place else table)[name] = value
    shaft = {"name": "shaft", "mode": "bearings", "bearings": [_given(row) for row in rows.values()]}
    return Document({"schema": 2, "name": "alone", "shafts": [shaft], "bearings": _given(table)}, "alone.toml")


def _given(table):
    return {key: value for key, value in table.items() if value is not None}
