# SPDX-License-Identifier: Apache-2.0
"""The counter-shaft from Python, in SI: `from calc import countershaft`."""

from ..bearings.formulas import specific_load
from ..library.balance_quality import permitted_unbalance
from .outline import sector_area, sector_mass
from .sizing.sectors import pair as size_sectors

__all__ = ["permitted_unbalance", "sector_area", "sector_mass", "size_sectors", "specific_load"]
