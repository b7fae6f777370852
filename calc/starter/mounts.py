# SPDX-License-Identifier: Apache-2.0
"""The engine on four mounts at its corners: mass and size by rule of thumb, to be weighed and measured; stiffness for its six modes to lie
between the road's frequency and what shakes at idle."""

import math

from ..design.toml_file import Document, design
from ..engine.inputs import EngineInputs
from ..engine.result import EngineResult
from ..mounting.result import MountingResult
from ..sheet.errors import NoSolution
from ..sheet.text import EMPTY, Text
from ..sheet.units import Metre
from ..solve import Results, solve
from ..studies.starter.writing import Section, mm, table, up

PER_LITRE = 110.0  # kg
IDLE, SLOWEST, FASTEST = 0.33, 700.0, 1000.0  # share of the rated speed; rpm
SHEAR = 0.45  # stiffness across a mount of rubber over that in compression
FIRST = 100.0  # N/mm, to be scaled: every frequency goes with the root


def mounting(document: Document, results: Results) -> list[Section]:
    """Raises NoSolution where the engine is not known."""
    engine, known = results.design.engine, results.result(EngineResult)
    if engine is None or known is None:
        raise NoSolution(Text("what stands on the mounts is not known"), EMPTY, Text("give [engine] first"))
    mass = up(PER_LITRE * known.displacement * 1e3, 5.0)
    made = _sections(engine, mass, FIRST)
    solved = solve(design(Document({**document.data, **table(made)})), results).result(MountingResult)
    return _sections(engine, mass, up(FIRST * _scale(solved), 1.0)) if solved is not None else made


def _scale(solved: MountingResult) -> float:
    """From the first stiffness to the middle of the window, as it is seen on a scale of ratios."""
    window = solved.window
    highest = [ceiling.highest_factor for ceiling in (window.half, window.shaft) if ceiling is not None]
    return math.sqrt(window.lowest_factor * min(highest)) if highest else window.lowest_factor


def _size(engine: EngineInputs) -> tuple[Metre, Metre, Metre]:
    """Up, to the side, along the crank; a bank that leans gives of its height to the side."""
    in_a_row = max(engine.bank_of_cylinder.count(bank) for bank in (1, 2)) if engine.bank_of_cylinder else engine.cylinders
    leaning = {"inline": 0.0, "boxer": math.pi / 2}.get(engine.layout, (engine.bank_angle or 0.0) / 2)
    reach = 2.5 * (2 * engine.crank_radius + engine.rod_length)
    height = max(reach * math.cos(leaning), 4 * engine.bore)
    width, length = 5 * engine.bore + reach * math.sin(leaning), (in_a_row + 2) * engine.cylinder_pitch
    return up(height, 10e-3), up(width, 10e-3), up(length, 10e-3)


def _sections(engine: EngineInputs, mass: float, stiffness: float) -> list[Section]:
    height, width, length = _size(engine)
    idle = min(FASTEST, max(SLOWEST, up(IDLE * engine.rated_speed * 60, 50.0)))
    across = up(SHEAR * stiffness, 1.0)
    under: list[Section] = [
        ("[[mounting.mounts]]", {
            "name": (f"{end}-{side}", ""),
            "position_mm": ([mm(-2 * engine.crank_radius), mm(y * width / 2), mm(z * 0.4 * length)], "assumed: corners, below the crank"),
            "stiffness_N_mm": ([stiffness, across, across], "assumed: the modes between the road and what shakes at idle"),
        })
        for end, z in (("front", -1), ("rear", 1)) for side, y in (("left", -1), ("right", 1))
    ]  # fmt: skip
    return [
        ("[mounting]", {
            "mass_kg": (mass, "assumed: 110 kg a litre, with liquids and flywheel; weigh it"),
            "centre_of_gravity_mm": ([mm(up(0.12 * height, 5e-3)), 0.0, 0.0], "assumed: above the crank, midway"),
            "dimensions_mm": ([mm(height), mm(width), mm(length)], "assumed from stroke, rod, bore and pitch; the inertia follows"),
            "idle_speed_rpm": (idle, "assumed: a third of the rated speed, 700 to 1000 rpm"),
        }),
        *under,
        ("[[mounting.points]]", {
            "name": ("top", ""),
            "position_mm": ([mm(up(0.7 * height, 5e-3)), 0.0, 0.0], "assumed: on the head"),
        }),
    ]  # fmt: skip
