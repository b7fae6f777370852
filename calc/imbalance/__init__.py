# SPDX-License-Identifier: Apache-2.0
"""Forces and couples of every order, forward and backward; crank webs and bobs, and remedies that balance."""

from typing import TYPE_CHECKING

from ..sheet.lazy import lazy

__all__ = ["ImbalanceInputs", "couple_per_degree", "solve_imbalance", "unbalance_product"]

if TYPE_CHECKING:
    from .formulas import couple_per_degree, unbalance_product
    from .inputs import ImbalanceInputs
    from .solve import solve_imbalance
else:
    __getattr__ = lazy(
        __name__,
        {
            "ImbalanceInputs": ".inputs",
            "couple_per_degree": ".formulas",
            "solve_imbalance": ".solve",
            "unbalance_product": ".formulas",
        },
    )
