# SPDX-License-Identifier: Apache-2.0
"""Friction of the meshes, the other losses of the train, and the power balance of the whole drive."""

from typing import TYPE_CHECKING

from ..sheet.lazy import lazy

__all__ = ["schlenk", "solve_loss"]

if TYPE_CHECKING:
    from .models import schlenk
    from .solve import solve_loss
else:
    __getattr__ = lazy(
        __name__,
        {
            "schlenk": ".models",
            "solve_loss": ".solve",
        },
    )
