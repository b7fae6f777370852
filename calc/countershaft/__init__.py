# SPDX-License-Identifier: Apache-2.0
"""The counter-rotating shaft: what it supplies, what its supports carry."""

from typing import TYPE_CHECKING

from ..sheet.lazy import lazy

__all__ = ["permitted_unbalance", "sector_area", "sector_mass", "size_sectors", "specific_load"]

if TYPE_CHECKING:
    from .public import permitted_unbalance, sector_area, sector_mass, size_sectors, specific_load
else:
    __getattr__ = lazy(__name__, __all__)
