"""A design of engine, imbalance and counter-shaft alone, and how the tests change it; a shaft to draw."""

import copy
import math

from calc.countershaft.outline import Outline, Piece, outline
from calc.countershaft.rows import BearingRow
from calc.design.toml_file import Document, design, read
from calc.solve import solve
from tests.conftest import DESIGNS, GAMMA

START = read(GAMMA).data
OMEGA = 2 * math.pi * 2600 / 60
FRONT = {"name": "front", "mass_kg": 2.691, "radius_mm": 18.676, "angle_deg": 210.0, "z_mm": -77.671}
REAR = {"name": "rear", "mass_kg": 2.688, "radius_mm": 18.731, "angle_deg": 30.0, "z_mm": 75.968}
JOURNALS = [{"diameter_mm": 59.5, "length_mm": 27.5}, {"diameter_mm": 81.0, "length_mm": 26.5}]
# of which the hand calculations of these tests are
STEEL = {
    "name": "20CrNi4",
    "E_GPa": 206.0,
    "poisson": 0.29,
    "density_kgm3": 7860.0,
    "expansion_1e6_K": 11.5,
    "kind": "steel",
}
NAMES = {
    1: ["front"],
    2: ["front", "rear"],
    3: ["front", "middle", "rear"],
}  # of so many bearings, as an upgrade has them


def rows(journals=(), places=(-167.5, 167.5)):
    """The rows [[shafts.bearings]] of a design, front to rear; without the sizes of their journals they have places
    alone."""
    sizes = journals or [{}] * len(places)
    return [{"name": name, "position_mm": z, **size} for name, z, size in zip(NAMES[len(places)], places, sizes)]


def bearing_rows(places, journals=()):
    """The same as the program has them: places, diameters and lengths in m."""
    sizes = [dict(zip(("diameter", "length"), size)) for size in journals] or [{}] * len(places)
    return tuple(BearingRow(name=name, position=z, **d) for name, z, d in zip(NAMES[len(places)], places, sizes))


SEATED = rows(JOURNALS)
TWIN = {"name": "twin", "mirrors": "shaft"}
ENVELOPE = {"outer_radius_mm": 43.0, "core_radius_mm": 15.0, "half_length_mm": 150.0}


def document(design_name=None, imbalance=None, twin=None, **shaft):
    """The source's shaft alone, or the shaft of another design, with its keys changed; None takes one out.  `twin`:
    with a mirror image or without, where that is not as in the design."""
    data = copy.deepcopy(START if design_name is None else read(DESIGNS / f"{design_name}.toml").data)
    own, *twins = data["shafts"]
    if design_name is None:
        own = {"name": "shaft", "mode": "given", "material": "20CrNi4", "speed_ratio": -1, "bearings": rows()}
        own["masses"] = [FRONT, REAR]
    elif "bearings" in data:  # which judges them; what only that needs stands in no design without
        own["bearings"] = [{key: row[key] for key in ("name", "position_mm")} for row in own["bearings"]]
    own = {key: value for key, value in {**own, **shaft}.items() if value is not None}
    twins = twins if twin is None else [TWIN] * twin
    kept = {key: data[key] for key in ("schema", "name", "material", "engine", "imbalance") if key in data}
    if design_name is None:
        kept["material"] = [*kept["material"], STEEL]
    kept["imbalance"] = {**kept["imbalance"], **(imbalance or {})}
    return Document({**kept, "shafts": [own, *twins]})


def outcome(*arguments, **shaft):
    return solve(design(document(*arguments, **shaft))).outcomes["countershaft"]


def result(*arguments, **shaft):
    made = outcome(*arguments, **shaft)
    assert made.state == "solved", made.reason
    return made.result


def verdicts(made):
    return {check.id.removeprefix("countershaft."): check.verdict for check in made.checks}


# --- a shaft to draw
UP = math.radians(210)
POSITIONS = (-0.1675, 0.1675)


def piece(start, end, radius, what, half_angle=None, angle=0.0, core=0.0):
    return Piece(
        start * 1e-3, end * 1e-3, radius * 1e-3, core * 1e-3, half_angle and math.radians(half_angle), angle, what
    )


def drawn_shaft(front=70.0, rear=110.0) -> Outline:
    """Two opposed sectors between journals, a gear ahead."""
    return outline(
        (
            piece(-196.25, -181.25, 29.35, "gear"),
            piece(-181.25, -153.75, 29.75, "journal"),
            piece(-153.75, -152, 15, "core"),
            piece(-152, -1, 40.3, "sector", front, UP, 15),
            piece(-1, 1, 15, "core"),
            piece(1, 152, 40.3, "sector", rear, UP - math.pi, 15),
            piece(152, 154.25, 15, "core"),
            piece(154.25, 180.75, 40.5, "journal"),
        ),
        derived=True,
    )
