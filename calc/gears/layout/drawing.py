# SPDX-License-Identifier: Apache-2.0
"""The train seen along its axes, in true scale: circles of tips and of meshing, a spoke to tooth 1, walls and neighbours."""

from typing import TYPE_CHECKING

import numpy as np

from ...sheet.arrays import ComplexArray
from ...sheet.step import Curve, Series
from ..inputs import GearsInputs
from ..result import working_circles
from .result import LayoutResult

if TYPE_CHECKING:
    from ..result import TrainResult

MM = 1e3
AROUND = np.linspace(0, 2 * np.pi, 121)


def layout_curve(gears: GearsInputs, train: "TrainResult", layout: LayoutResult) -> Curve | None:
    """None where no wheel has a place.  Up is up, the crank turns clockwise."""
    placed = {name: wheel for name, wheel in layout.wheels.items() if wheel.position is not None}
    if not placed:
        return None
    series = []
    for name, wheel in placed.items():
        radii = [train.wheels[name].tip_diameter / 2, *_working_radii(train, name)]
        direction = np.exp(1j * (wheel.tooth_angle or 0.0))
        rings = [radius * direction * np.exp(1j * AROUND) for radius in radii]  # one line: each ring begins and ends at tooth 1
        series.append(_line(name, wheel.position + np.concatenate([*rings, [0.0]])))
    for wall in gears.walls:
        series.append(_line(wall.name, np.array([complex(*wall.from_), complex(*wall.to)])))
    for neighbour in gears.neighbours:
        series.append(_line(neighbour.name, complex(*neighbour.position) + neighbour.radius * np.exp(1j * AROUND)))
    return Curve("layout", "Layout of the train, cylinder 1 at TDC, crank clockwise", "side, mm", "up, mm", tuple(series), equal=True)


def _working_radii(train: "TrainResult", name: str) -> list[float]:
    """From the largest inwards; alike ones once."""
    found = [d_w / 2 for _, d_w, _ in working_circles(train.meshes, name)]
    return sorted({round(r, 5): r for r in found}.values(), reverse=True)


def _line(label: str, points: ComplexArray) -> Series:
    return Series(label, points.imag * MM, points.real * MM)
