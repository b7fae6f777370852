# SPDX-License-Identifier: Apache-2.0
"""Friction of the meshes, the other losses of the train, and the power balance of the whole drive."""

from typing import TYPE_CHECKING

from ..sheet.offered import offer

if TYPE_CHECKING:
    from .inputs import FrictionInputs as FrictionInputs
    from .losses.turning_masses import mass_loss as mass_loss
    from .mesh.loss import MeshLoss as MeshLoss
    from .models import schlenk as schlenk
    from .result import FrictionResult as FrictionResult
    from .solve import solve_loss as solve_loss

offer(globals())
