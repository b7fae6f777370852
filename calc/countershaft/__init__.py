# SPDX-License-Identifier: Apache-2.0
"""The counter-rotating shaft: what it supplies, what its supports carry, how it bends, is sized, made and mounted."""

from typing import TYPE_CHECKING

from ..sheet.lazy import lazy

__all__ = ["permitted_unbalance", "sector_area", "sector_mass", "size_sectors", "specific_load"]

if TYPE_CHECKING:
    from ..library.journal_rules import specific_load
    from ..library.tolerances import permitted_unbalance
    from .outline import sector_area, sector_mass
    from .sizing.sectors import pair as size_sectors
else:
    __getattr__ = lazy(
        __name__,
        {
            "permitted_unbalance": "..library.tolerances",
            "sector_area": ".outline",
            "sector_mass": ".outline",
            "size_sectors": ".sizing.sectors:pair",
            "specific_load": "..library.journal_rules",
        },
    )
