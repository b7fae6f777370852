# SPDX-License-Identifier: Apache-2.0
"""The counter-rotating shaft: what it supplies, what its supports carry, how it bends, is sized, made and mounted."""

from typing import TYPE_CHECKING

from ..sheet.offered import offer

if TYPE_CHECKING:
    from ..library.journal_rules import specific_load as specific_load
    from ..library.tolerances import permitted_unbalance as permitted_unbalance
    from .bending.carried import Rigid as Rigid
    from .bending.carried import Spring as Spring
    from .bending.carried import carried as carried
    from .bending.condensed import at_rest as at_rest
    from .bending.condensed import condensed as condensed
    from .bending.condensed import standing_on as standing_on
    from .inputs import ShaftInputs as ShaftInputs
    from .outline import sector_area as sector_area
    from .outline import sector_mass as sector_mass
    from .result import CountershaftResult as CountershaftResult
    from .sizing.by_hand import size_sectors as size_sectors
    from .sizing.by_hand import size_stretches as size_stretches
    from .sizing.stretches import stretches as stretches
    from .sums import OrderVectors as OrderVectors
    from .sums import SystemShaft as SystemShaft
    from .sums import together as together

offer(globals())
