"""Designs for the tests of the bearings: others with values changed, and bearings that stand alone."""

import math

from calc.design.toml_file import Document, design, read
from calc.solve import solve
from tests.calc.countershaft.bending import cases
from tests.conftest import DESIGNS, SCREENED

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


# --- shafts on more than two bearings, of the reference data


def on_bearings(name, *, speed_ratio=2.0, rows=(), **changes):
    """The shaft of a case with films under an engine at whose rated speed it turns as fast as there, with the oil of
    one viscosity and seats that keep their clearance; `rows`: changes by the bearings' names."""
    case = cases.SHARE[name]
    rho, omega = case["rho"], 2 * math.pi * case["speed_rpm"] / 60
    sections, masses = [], []
    for start, end, R, r_0, half, angle in case["pieces"]:
        sections.append({"from_mm": start, "to_mm": end, "outer_radius_mm": R})
        if half is None:
            continue
        sections[-1] |= {"core_radius_mm": r_0, "half_angle_deg": half, "angle_deg": angle}
        gamma, ring, cubes = math.radians(half), (R**2 - r_0**2) / 1e6, (R**3 - r_0**3) / 1e9
        mass = rho * gamma * ring * (end - start) / 1e3
        radius = 2 / 3 * cubes * math.sin(gamma) / (gamma * ring) * 1e3
        at = {"angle_deg": angle, "z_mm": (start + end) / 2}
        masses.append({"name": f"sector-{len(masses) + 1}", "mass_kg": mass, "radius_mm": radius, **at})
    bearings = [
        {"name": row, "position_mm": z, "diameter_mm": law["d_mm"], "length_mm": law["l_mm"]}
        | {"clearance_um": law["c_um"], **ROUGHNESS, **dict(rows).get(row, {})}
        for row, z, law in zip(case["names"], case["supports_mm"], case["laws"])
    ]
    shaft = {"name": "shaft", "mode": "given", "material": "as there", "speed_ratio": speed_ratio, "masses": masses}
    shaft |= {"sector_effectiveness": case["eta"], "sections": sections, "bearings": [_given(row) for row in bearings]}
    steel = {"name": "as there", "E_GPa": case["E_GPa"], "poisson": case["nu"], "density_kgm3": rho}
    steel |= {"expansion_1e6_K": 11.0, "kind": "steel"}
    engine = read(DESIGNS / f"{SCREENED}.toml").data["engine"]
    engine = engine | {"rated_speed_rpm": omega * 30 / math.pi / abs(speed_ratio)}
    films = {key: TABLE[key] for key in ("oil", "supply_temperature_C", "supply", "hole_diameter_mm")}
    films |= {"supply_pressure_bar": 4.0, "viscosity_mPas": case["laws"][0]["mu_mPas"], "housing_material": "as there"}
    films |= {"coaxiality_um": case.get("coaxiality_um", 0.0), **changes}
    data = {"schema": 2, "name": name, "material": [steel], "engine": engine, "imbalance": {}, "shafts": [shaft]}
    return Document(data | {"bearings": _given(films)}, f"{name}.toml")
