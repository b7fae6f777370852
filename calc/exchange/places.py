# SPDX-License-Identifier: Apache-2.0
"""Where the shafts and the wheels of a design stand, and how their teeth stand there with cylinder 1 at TDC: in the
axes of the design, as far as it says so."""

import cmath
import math
from collections.abc import Mapping

from ..design import step_inputs as h
from ..gears.inputs import GearsInputs
from ..gears.layout.phase import phase
from ..gears.result import TrainResult
from ..sheet.record import record
from ..sheet.units import Metre, Radian
from ..sheet.value import recorded
from ..solve import Results
from .frame import frame_of

HANDS = {"right": 1, "left": -1, "": 0}  # of a helix, by how it turns about +Z along it


@record
class WheelPlace:
    """`axis`: from the crank's, up and side; `z`: of the middle of its face from mid-engine; `tooth`: the middle of one
    of its teeth there, from up in the sense of crank rotation."""

    axis: complex
    z: Metre
    tooth: Radian


def shaft_axes(results: Results) -> dict[str, complex]:
    """From the crank's, up and side, by shaft: given, else where the wheel stands that carries it."""
    design, train = results.design, results.train
    axes = h.shaft_axes(design)
    laid = train.layout.wheels if train is not None and train.layout is not None else {}
    for name, turn in (train.shafts if train is not None else {}).items():
        if turn.wheel in laid and (position := laid[turn.wheel].position) is not None:
            axes.setdefault(name, position)
    return axes


def wheel_places(results: Results) -> dict[str, WheelPlace]:
    """Of every wheel whose axis is known; the others are not there."""
    train, gears = results.train, results.design.gears
    if train is None or gears is None or train.layout is None:
        return {}
    axes = {name: wheel.position for name, wheel in train.layout.wheels.items() if wheel.position is not None}
    planes, teeth, hands = planes_of(results), _teeth(train, gears, axes), gears.hands()
    turn = frame_of(results.design).turn
    first = planes.get(train.tree.first, next(iter(planes.values()), 0.0))
    places = {}
    for name, axis in axes.items():
        # the layout has the teeth of all wheels in one plane: a helix whose wheel stands in another is further on there
        turned = HANDS[hands.get(name, "")] * helix(train, name) * (planes[name] - first)
        places[name] = WheelPlace(axis, planes[name], teeth[name] + turn * turned)
    return places


def helix(train: TrainResult, name: str) -> float:
    """By how much the teeth of a wheel turn along its axis: radians a metre, without their sense."""
    return 2 * math.tan(train.system.beta) / train.wheels[name].reference_diameter


def _teeth(train: TrainResult, gears: GearsInputs, axes: Mapping[str, complex]) -> dict[str, Radian]:
    """A tooth of each wheel: where the layout has its first, else one that meshes; behind a chain or a belt, and of
    wheels that mesh with none in its place, up."""
    directions = {
        key: cmath.phase(axes[mesh.driven] - axes[mesh.driver])
        for key, mesh in train.meshes.items()
        if mesh.driver in axes and mesh.driven in axes
    }
    behind = {stage.driven: 0.0 for stage in train.stages.values()}
    with recorded(False):
        found = phase(train, directions, {**behind, train.tree.first: gears.tooth_angle}, {}).teeth
    laid = train.layout.wheels if train.layout is not None else {}
    known = {name: laid[name].tooth_angle for name in axes if laid[name].tooth_angle is not None}
    return {name: known.get(name, found.get(name, 0.0)) or 0.0 for name in axes}


def planes_of(results: Results) -> dict[str, Metre]:
    """Where along the crank the middle of each wheel stands; at mid-engine where that is known of none."""
    return known_planes(results) or dict.fromkeys(results.train.wheels if results.train is not None else (), 0.0)


def known_planes(results: Results) -> dict[str, Metre]:
    """The middle of every wheel and sprocket, from mid-engine: as given, or its shaft's, else that of a wheel in mesh
    with it, else that of the first one that is known; empty where none is."""
    train = results.train
    if train is None:
        return {}
    z = dict[str, Metre]()
    for shaft in h.turning(results.design):
        solved, turn = results.view(shaft.name).shaft, train.shafts.get(shaft.name)
        if turn is not None and solved is not None and solved.wheel is not None:
            z[turn.wheel] = float(solved.wheel)
    gears = results.design.gears
    z |= {wheel.name: float(wheel.z) for wheel in gears.wheels if wheel.z is not None} if gears is not None else {}
    pairs = [(mesh.driver, mesh.driven) for mesh in train.meshes.values()]
    for pair in pairs * len(pairs):
        for a, b in (pair, pair[::-1]):
            if a in z:
                z.setdefault(b, z[a])
    return {name: z.get(name, next(iter(z.values()))) for name in (*train.wheels, *z)} if z else {}
