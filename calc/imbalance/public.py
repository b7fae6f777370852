# SPDX-License-Identifier: Apache-2.0
"""The imbalance of an engine from Python, in SI: `from calc import imbalance`."""

from ..engine.inputs import EngineInputs
from ..engine.solve import values as engine_values
from .formulas import couple_per_degree, unbalance_product
from .inputs import ImbalanceInputs
from .result import ImbalanceResult
from .solve import values

__all__ = ["ImbalanceInputs", "couple_per_degree", "solve_imbalance", "unbalance_product"]


def solve_imbalance(
    engine: EngineInputs, crank_balance_fraction: float = 0.5, kinematics: str = "exact"
) -> ImbalanceResult:
    """Forces and couples of orders 1 to 8, and what a counter-shaft must supply.

    `crank_balance_fraction`: share of the reciprocating mass that the crank's own counterweights carry.  `kinematics`:
    "exact" or "two_term".  A number of the engine may be an array, an engine each; so are the results."""
    inputs = ImbalanceInputs(crank_balance_fraction=crank_balance_fraction, kinematics=kinematics)
    return values(inputs, engine, engine_values(engine))
