# SPDX-License-Identifier: Apache-2.0
"""How the crank is balanced, and with which kinematics the imbalance is judged."""

from ..sheet.quantity import choice, inputs, quantity


@inputs
class ImbalanceInputs:
    """What the crank takes of the reciprocating masses, and the kinematics that are judged."""

    crank_balance_fraction: float = quantity(
        "Share balanced on the crank", default=0.5, low=-1, high=2, usual=(0, 1), symbol="kappa", step=0.05,
        help="The crank's counterweights carry all rotating mass plus this share of the reciprocating mass. At ½ the first order "
        "that is left turns backwards only, and one counter-shaft can take it.",
    )  # fmt: skip
    kinematics: str = choice(
        "Kinematics",
        "exact",
        "two_term",
        default="exact",
        help="exact: harmonics of the true slider-crank. two_term: cos α + λ cos 2α, as in the textbooks.",
    )
