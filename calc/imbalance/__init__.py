# SPDX-License-Identifier: Apache-2.0
"""Forces and couples of every order, forward and backward; crank webs and bobs, and remedies that balance."""

from typing import TYPE_CHECKING

from ..sheet.offered import offer

if TYPE_CHECKING:
    from .formulas import couple_per_degree as couple_per_degree
    from .formulas import unbalance_product as unbalance_product
    from .inputs import ImbalanceInputs as ImbalanceInputs
    from .result import ImbalanceResult as ImbalanceResult
    from .solve import solve_imbalance as solve_imbalance

offer(globals())
