# SPDX-License-Identifier: Apache-2.0
"""Firing orders to choose from, ranked by what they leave."""

from calc.design.model import Design
from calc.engine import solve as engine
from calc.imbalance.firing_orders import as_designed, crank_words, firing_orders, orders_table
from calc.sheet.progress import Progress
from calc.sheet.text import Text

from .offer import Offer

NEEDS = ("engine", "imbalance")
WHY = Text("firing orders are ranked by what they leave of the imbalance")


def offer(made: Design, file: str, progress: Progress | None = None) -> Offer:
    assert made.engine is not None and made.imbalance is not None
    inputs, crank = made.engine, made.imbalance
    e = engine.values(inputs)
    found = firing_orders(crank, inputs, e)

    def said(number: int) -> Text:
        one = found[number - 1]
        order = "-".join(map(str, one.order))
        return Text("now fires {order} (crank angles {angles}°)", order=order, angles=crank_words(one.crank_angles))

    return Offer(
        count=len(found),
        table=lambda top: orders_table(found, top, as_designed(crank, inputs, e), inputs),
        keys=lambda number: {"engine.firing_order": list(found[number - 1].order), "engine.crank_angles_deg": None},
        said=said,
        hint=Text("`--apply N` writes the N-th order into the design, and the crank angles out of it; `--top N` shows more."),
    )
