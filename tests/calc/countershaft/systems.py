"""Systems of balance shafts of tests/data/shafts.json, and what is given of them."""

import json
import math
from functools import cache
from pathlib import Path

import numpy as np

from calc.countershaft import formulas as f
from calc.countershaft.inputs import EccentricMass, Scatter
from calc.countershaft.sums import OrderVectors, SystemShaft
from calc.design.toml_file import Document, design
from calc.solve import solve

DATA = json.loads((Path(__file__).parents[2] / "data" / "shafts.json").read_text(encoding="utf-8"))
CASES = DATA["cases"]


def rows(scatter: bool) -> list[dict]:
    """What is given of the cases that are whole designs: of their scatter, or all else."""
    return [row for row in DATA["given"] if row["case"] in CASES and (".scatter." in row["value"]) is scatter]


def called(row: dict) -> str:
    return f"{row['case']}-{row['value']}"


def tolerance(row: dict) -> dict:
    return {key: row[key] for key in ("rel", "abs") if key in row}


@cache
def engine(case: str) -> tuple[dict[int, OrderVectors], float]:
    """What the engine of a case gives by order, and its angular speed."""
    tables = {key: CASES[case][key] for key in ("engine", "imbalance")}
    outcomes = solve(design(Document({"schema": 1, "name": case, **tables}))).outcomes
    e, i = outcomes["engine"].result, outcomes["imbalance"].result
    return {
        n: OrderVectors(*i.orders[f"order_{n}"].vectors, e.torque.reaction_harmonics[n - 1]) for n in (1, 2)
    }, e.angular_speed


def masses(shaft: dict) -> tuple[EccentricMass, ...]:
    return tuple(
        EccentricMass(
            name=mass["name"],
            mass=mass["mass_kg"],
            radius=mass["radius_mm"] * 1e-3,
            angle=math.radians(mass["angle_deg"]),
            z=mass["z_mm"] * 1e-3,
        )
        for mass in shaft["masses"]
    )


def scatter(shaft: dict) -> Scatter | None:
    if "scatter" not in shaft:
        return None
    s = shaft["scatter"]
    angles = {name: math.radians(s[f"{name}_deg"]) for name in ("angle", "timing")}
    return Scatter(mass=s["mass_g"] * 1e-3, radius=s["radius_mm"] * 1e-3, z=s["z_mm"] * 1e-3, **angles)


def vectors(parts: tuple[EccentricMass, ...], omega: float) -> tuple[complex, complex]:
    """Force and couple of masses that turn at omega."""
    m, e, gamma, z = (np.array([getattr(part, name) for part in parts]) for name in ("mass", "radius", "angle", "z"))
    return f.shaft_force(omega, m, e, gamma), f.shaft_couple(omega, m, e, z, gamma)


def shafts(case: str) -> list[SystemShaft]:
    """The shafts of a case whose masses are given, twins made of them; a twin's wheel is like its original's."""
    omega, teeth = engine(case)[1], CASES[case].get("teeth", {})
    made: dict[str, SystemShaft] = {}
    for one in CASES[case]["shafts"]:
        axis = complex(*one["axis_mm"]) * 1e-3 if "axis_mm" in one else None
        if one.get("mirrors") in made:
            made[one["name"]] = made[one["mirrors"]].mirror_image(one["name"], axis)
        elif one.get("repeats") in made:
            made[one["name"]] = made[one["repeats"]].repeated(one["name"], axis)
        elif "masses" in one:
            ratio, z = one["speed_ratio"], teeth.get(one["name"])
            F, C = vectors(masses(one), abs(ratio) * omega)
            made[one["name"]] = SystemShaft(one["name"], ratio, F, C, axis, 2 * math.pi / z if z else None)
    return list(made.values())


def document(case: str) -> Document:
    """A case as a whole design: of every shaft that is no twin a material and two bearings beyond its masses, of each a
    wheel beside the crank's, where their teeth are given."""
    tables = {key: value for key, value in CASES[case].items() if key not in ("shafts", "teeth")}
    bearings = [{"name": "front", "position_mm": -200.0}, {"name": "rear", "position_mm": 200.0}]
    own = {"material": "42CrMo4", "bearings": bearings}
    tables["shafts"] = [shaft | own if "speed_ratio" in shaft else shaft for shaft in CASES[case]["shafts"]]
    if "teeth" in CASES[case]:
        tables["gears"] = train(CASES[case]["teeth"])
    return Document(tables)


def train(teeth: dict[str, int]) -> dict:
    """A wheel for each shaft, by its name, all of them driven by the crank's."""
    return {
        "normal_module_mm": 2.0,
        "pressure_angle_deg": 20.0,
        "helix_angle_deg": 0.0,
        "face_width_mm": 15.0,
        "wheels": [
            {"name": "crank", "teeth": 48},
            *({"name": f"wheel-{name}", "teeth": z, "shaft": name} for name, z in teeth.items()),
        ],
        "meshes": [{"driver": "crank", "driven": f"wheel-{name}"} for name in teeth],
    }
