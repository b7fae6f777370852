# SPDX-License-Identifier: Apache-2.0
"""Where the wheels of a train stand along the engine."""

from collections.abc import Mapping

from ..design.model import Design
from ..gears.result import TrainResult
from ..sheet.units import Metre


def wheel_planes(design: Design, train: TrainResult, on_shafts: Mapping[str, Metre]) -> dict[str, Metre]:
    """The middle of every wheel, from mid-engine: as given, or its shaft's, else that of a wheel in mesh with it, else
    that of the first one that is known; empty where none is.

    `on_shafts`: of wheels and sprockets on shafts, by their names."""
    given = {wheel.name: float(wheel.z) for wheel in design.gears.wheels if wheel.z is not None} if design.gears else {}
    z = {**on_shafts, **given}
    pairs = [(mesh.driver, mesh.driven) for mesh in train.meshes.values()]
    for pair in pairs * len(pairs):
        for a, b in (pair, pair[::-1]):
            if a in z:
                z.setdefault(b, z[a])
    return {name: z.get(name, next(iter(z.values()))) for name in (*train.wheels, *z)} if z else {}
