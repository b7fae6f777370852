# SPDX-License-Identifier: Apache-2.0
"""What the imbalance step gives: the orders, what the counter-shaft must supply, the remedies."""

from typing import Generic

from ..sheet.arrays import Value
from ..sheet.quantity import group, result, value
from ..sheet.shown import Shown
from ..sheet.text import Text
from ..sheet.units import Newton, NewtonMetre
from .orders import Order
from .remedies import BalancingRemedy, Counterweight
from .shaft_pair import ShaftPair
from .throws import Throws
from .webs import WebsResult


@result
class ImbalanceResult(Shown, Generic[Value]):
    """All orders, what the counter-shaft must supply, and the remedies."""

    orders: dict[str, Order[Value]] = group(spread=True, short=("order_1", "order_2"), leads=("order_2",))
    required_couple: Value = value(
        "Couple that the counter-shaft must supply",
        "N·m",
        "C_S",
        short=True,
        page_one=1,
        headline=1,
        taken_by=("countershaft", "gears"),
    )
    required_couple_phase: Value = value("its phase, cylinder 1 at TDC", "°", short=True, taken_by=("countershaft",))
    required_unbalance_product: Value = value("Unbalance times arm of the counter-shaft", "kg·mm²", "U·Δz", short=True)
    required_force: Value | None = value(
        "Force that the counter-shaft must supply",
        "N",
        "F_S",
        default=None,
        short=True,
        page_one=2,
        headline=2,
        taken_by=("countershaft", "gears"),
    )
    required_force_phase: Value | None = value(
        "its phase, cylinder 1 at TDC", "°", default=None, short=True, taken_by=("countershaft",)
    )
    required_unbalance: Value | None = value("Unbalance of the counter-shaft", "kg·mm", "U", default=None, short=True)
    mistiming_force_per_degree: Value | None = value(
        "Force left per degree of mistiming", "N", default=None, short=True
    )
    mistiming_force_per_tooth: Value | None = value(
        "Force left per tooth of mistiming at the shaft's wheel", "N", default=None, short=True
    )
    mistiming_per_degree: Value = value("Couple left per degree of mistiming", "N·m", short=True)
    mistiming_per_tooth: Value | None = value(
        "Couple left per tooth of mistiming at the shaft's wheel", "N·m", default=None, short=True
    )
    remedy: dict[str, BalancingRemedy] = group(
        words="remedy",
        key_words={
            "backward_shaft": Text("backward shaft"),
            "crank": Text("crank"),
            "crank_and_shafts": Text("crank and shafts"),
            "first_order_pair": Text("first order pair"),
            "four_shafts": Text("four shafts"),
            "second_order_shafts": Text("second order shafts"),
        },
    )
    shaft_pair: ShaftPair | None = group(default=None)
    counterweight: dict[str, Counterweight] | None = group(
        default=None, words="counterweight", key_words={"front": Text("front"), "rear": Text("rear")}
    )
    throw: Throws = group(words="throw")
    webs: WebsResult | None = group(spread=True, default=None)
    required: complex  # the vector
    whole: tuple[complex, complex]  # force and couple of counterweights for the whole reciprocating mass
    one_force: Newton  # m·r·ω² of one cylinder, and its couple over one pitch: what is left is measured against them
    one_couple: NewtonMetre
