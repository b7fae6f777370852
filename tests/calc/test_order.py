# SPDX-License-Identifier: Apache-2.0
"""What is computed comes in one order, whatever order Python's sets have in a process: a report is set again from it,
byte for byte.  And the order in which a design lists its masses, wheels, points … changes no number of it, but where the
docs say what the order means."""

import math
import os
import subprocess
import sys
from collections.abc import Iterator
from copy import deepcopy
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from calc.design.toml_file import Document, design, read
from calc.sheet.value import recorded
from calc.solve import solve
from calc.studies.shipped import DESIGNS
from tests.conftest import ROOT, SHIPPED

SOLVED = """
import sys
from hashlib import sha256
from calc.design.toml_file import load
from calc.studies.shipped import designs
from calc.solve import solve
for path in (path for path in designs() if path.match(sys.argv[1])):
    results = solve(load(path)[1])
    for key, outcome in results.outcomes.items():
        whole = outcome.whole
        said = [f"{line.formula.symbol} {line.about} {line.value!r}" for line in whole.lines]
        said += [f"{c} {c.advice}" for c in whole.checks] + [str(x) for x in (*whole.notes, *whole.tables, *whole.values())]
        print(path.stem, key, sha256("\\n".join(said).encode()).hexdigest())
"""


@pytest.mark.parametrize("designs", ["r754*.toml", pytest.param("*.toml", marks=pytest.mark.slow)])
def test_every_line_of_every_shipped_design_comes_in_one_order(designs: str) -> None:
    runs = [
        subprocess.Popen(
            [sys.executable, "-c", SOLVED, designs],
            cwd=ROOT,
            stdout=subprocess.PIPE,
            text=True,
            env={**os.environ, "PYTHONHASHSEED": seed},
        )
        for seed in ("1", "3")
    ]
    first, second = (run.communicate()[0].splitlines() for run in runs)
    assert len(first) >= 6 and [(a, b) for a, b in zip(first, second, strict=True) if a != b] == []


# --- the order of arrays

Place = tuple[str | int, ...]
ORDERED = {"meshes": "along the flow of power", "journals": "front to rear"}


def arrays(at: Any, place: Place = ()) -> Iterator[tuple[Place, list[Any]]]:
    """Every array of tables or words whose order means nothing.  Those of numbers are vectors, stand front to rear or by
    cylinder; [optimise] says what a search does, and no number of the design."""
    if isinstance(at, list):
        if len(at) > 1 and place[-1] not in ORDERED and isinstance(at[0], dict | str):
            yield place, at
        for i, element in enumerate(at):
            yield from arrays(element, (*place, i))
    elif isinstance(at, dict) and place != ("optimise",):
        for key, value in at.items():
            yield from arrays(value, (*place, key))


def reordered(document: Document, place: Place, array: list[Any]) -> Document:
    data = deepcopy(document.data)
    here: Any = data
    for part in place[:-1]:
        here = here[part]
    here[place[-1]] = array
    return replace(document, data=data)


def numbers(document: Document) -> dict[str, Any]:
    """Every value, check and state of a design."""
    with recorded(False):
        results = solve(design(document))
    found: dict[str, Any] = {id: value.shown for id, value in results.values().items()}
    for check in results.checks():
        found |= {f"{check.id}: value": check.value, f"{check.id}: verdict": check.verdict}
        found[f"{check.id}: limit"] = check.limit
    return found | {step: outcome.verdict for step, outcome in results.outcomes.items()}


def moved(a: dict[str, Any], b: dict[str, Any]) -> list[tuple[str, Any, Any]]:
    return [(id, a.get(id), b.get(id)) for id in sorted(a.keys() | b.keys()) if not _same(a.get(id), b.get(id))]


def _same(a: Any, b: Any) -> bool:
    """The same number, but for the rounding of a sum in another order."""
    if isinstance(a, float) and isinstance(b, float):
        return math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-9) or (math.isnan(a) and math.isnan(b))
    return bool(a == b)


def two_of_each() -> Document:
    """The mounting design with two of what no shipped design has twice."""
    document = read(DESIGNS / "r753ie4_mounting.toml")
    data = deepcopy(document.data)
    shaft, gears, friction, mounting = data["shafts"][0], data["gears"], data["friction"], data["mounting"]
    # a wheel whose eccentrics do not stand opposite each other has no tooth at the same angle to both
    shaft["extras"] = [
        {"name": "sensor", "mass_kg": 0.02, "radius_mm": 12.0, "angle_deg": 40.0, "z_mm": 20.0},
        {"name": "key", "mass_kg": -0.01, "radius_mm": 14.0, "angle_deg": 0.0, "z_mm": -30.0},
    ]
    gears["neighbours"] = [
        {"name": "screw", "position_mm": [40.0, -90.0], "radius_mm": 6.0},
        {"name": "gallery", "position_mm": [-90.0, -20.0], "radius_mm": 9.0},
    ]
    friction["other_losses"] = [{"name": "idler", "power_W": 12.5}, {"name": "seal", "power_W": 3.25}]
    data["imbalance"]["unbalances"] = [
        {"name": "pulley", "unbalance_kgmm": 0.2, "angle_deg": 30.0, "z_mm": -250.0},
        {"name": "flywheel", "unbalance_kgmm": 0.3, "angle_deg": 200.0, "z_mm": 240.0},
    ]
    mounting["points"].append(
        {"name": "mate", "on": "chassis", "role": "seat", "position_mm": [80.0, 600.0, 1150.0]},
    )
    return replace(document, data=data)


def test_the_order_of_an_array_changes_no_number() -> None:
    document = two_of_each()
    here, lists = numbers(document), dict(arrays(document.data))
    of = [("shafts", 0, "masses"), ("shafts", 0, "extras"), ("gears", "wheels"), ("gears", "neighbours")]
    of += [("gears", "meshes", 1, "stack"), ("mounting", "mounts"), ("mounting", "points")]
    of += [("friction", "other_losses"), ("imbalance", "unbalances")]
    for place in of:
        assert moved(here, numbers(reordered(document, place, lists[place][::-1]))) == [], place


def test_the_numbering_of_the_cylinders_changes_no_number() -> None:
    """Cylinders 2 and 3 change their numbers, with all that names them; the first stays, from whose TDC angles count."""
    document = read(DESIGNS / "r753ie4_gamma.toml")
    data = deepcopy(document.data)
    engine, imbalance, pitch = data["engine"], data["imbalance"], data["engine"]["cylinder_pitch_mm"]
    angles, places = dict(enumerate((0, 240, 120), 1)), dict(enumerate((-pitch, 0.0, pitch), 1))
    swap = {1: 1, 2: 3, 3: 2}
    engine["crank_angles_deg"] = [angles[swap[n]] for n in (1, 2, 3)]
    engine["axial_positions_mm"] = [places[swap[n]] for n in (1, 2, 3)]
    engine["firing_order"] = [swap[n] for n in engine["firing_order"]]
    imbalance["crank_bodies_throw_at_tdc"] = swap[imbalance["crank_bodies_throw_at_tdc"]]
    for body in imbalance["crank_bodies"]:
        if "pin" in body:
            body["pin"] = swap[body["pin"]]
    assert moved(numbers(document), numbers(replace(document, data=data))) == []


@pytest.mark.slow
@pytest.mark.parametrize("path", [*SHIPPED, None], ids=lambda path: path.stem if path else "two")
def test_no_array_of_a_shipped_design_has_a_first(path: Path | None) -> None:
    """Every array of every shipped design backwards, and its first element set last."""
    document = read(path) if path is not None else two_of_each()
    here = numbers(document)
    for where, array in arrays(document.data):
        for other in (array[::-1], [*array[1:], array[0]]):
            assert moved(here, numbers(reordered(document, where, other))) == [], where
