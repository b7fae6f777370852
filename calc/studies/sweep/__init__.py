# SPDX-License-Identifier: Apache-2.0
"""Many designs at once: inputs over lists, grids, a Latin hypercube or their tolerances; a design is a row."""

from .inputs import SweepPlan, Varied, grid, listed, sampled, toleranced, varied
from .run import Sweep, sweep, swept
from .table import Swept

__all__ = [
    "Sweep",
    "SweepPlan",
    "Swept",
    "Varied",
    "grid",
    "listed",
    "sampled",
    "sweep",
    "swept",
    "toleranced",
    "varied",
]
