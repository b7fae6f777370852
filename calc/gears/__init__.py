# SPDX-License-Identifier: Apache-2.0
"""The gear train: geometry, measures, backlash, its place in the engine, profile, rating, and a search for shifts."""

from typing import TYPE_CHECKING

from ..sheet.lazy import lazy

__all__ = ["centre_distance", "contact_stress", "solve_pair", "span", "tip_diameter", "transverse_contact_ratio"]

if TYPE_CHECKING:
    from .formulas import centre_distance, tip_diameter, transverse_contact_ratio
    from .measures.formulas import span
    from .rating.stress import contact_stress
    from .solve import solve_pair
else:
    __getattr__ = lazy(
        __name__,
        {
            "centre_distance": ".formulas",
            "contact_stress": ".rating.stress",
            "solve_pair": ".solve",
            "span": ".measures.formulas",
            "tip_diameter": ".formulas",
            "transverse_contact_ratio": ".formulas",
        },
    )
