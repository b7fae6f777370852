# SPDX-License-Identifier: Apache-2.0
"""The friction of a mesh from Python, in SI: `from calc import friction`."""

import numpy as np

from ..gears.result import TrainResult
from ..library.catalogue import Oil, materials, oils
from ..library.lubricant import Lubricant
from ..sheet.units import Celsius, Metre, RevPerSecond, Watt
from .inputs import FrictionInputs
from .mesh.film import oil_at
from .mesh.loss import MeshLoss, case, losses, solve_mesh
from .models import schlenk
from .solve import meshes_of

__all__ = ["schlenk", "solve_loss"]


def solve_loss(
    pair: TrainResult,
    *,
    power: Watt,
    speed: RevPerSecond,
    oil: str | Oil,
    temperature: Celsius,
    flank_roughness: Metre = 0.8e-6,
) -> MeshLoss:
    """The loss of the first mesh of a train (`gears.solve_pair` makes one of two wheels), whose teeth have the oil's
    temperature.

    `power` into the driver, `speed` of the driver in revolutions per second; these two and `temperature` may be arrays
    of one length, an operating point each: so are the results then.  `flank_roughness`: Ra of both flanks."""
    mesh = next(iter(meshes_of(pair, materials()).values()))
    lubricant = Lubricant(oils()[oil] if isinstance(oil, str) else oil)
    inputs = FrictionInputs(flank_roughness=(flank_roughness,))
    if np.ndim(power) or np.ndim(speed) or np.ndim(temperature):
        return losses(inputs, mesh, lubricant, T=temperature, n_1=speed, P=power)
    return solve_mesh(case(inputs, mesh, oil_at(lubricant, temperature), speed), power, by_regime=True)
