# SPDX-License-Identifier: Apache-2.0
"""Forces and couples of every order, forward and backward."""

from typing import TYPE_CHECKING

from ..sheet.lazy import lazy

__all__ = ["ImbalanceInputs", "couple_per_degree", "solve_imbalance", "unbalance_product"]

if TYPE_CHECKING:
    from .public import ImbalanceInputs, couple_per_degree, solve_imbalance, unbalance_product
else:
    __getattr__ = lazy(__name__, __all__)
