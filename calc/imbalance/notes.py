# SPDX-License-Identifier: Apache-2.0
"""What is to be known of the imbalance beside its numbers, and where the source goes wrong."""

from collections.abc import Iterable, Iterator

from ..sheet.quantity import declared, dotted
from ..sheet.step import Erratum
from ..sheet.text import Text
from ..sheet.units import Metre
from . import formulas as f
from .inputs import ImbalanceInputs
from .orders import Order
from .result import ImbalanceResult
from .shaft_pair import roll_notes
from .throws import balanced, verdict
from .webs import UNDRILLED

MIDDLE = Text(
    "Couples are taken about the middle of the engine; where a force is left as well, they hold about that plane only. "
    "A vertical couple is a pair of vertical forces, one at either end."
)

INHERENTLY = {
    True: Text(
        "ISO 21940-11, crank drives that are inherently balanced, as this one: G16 rigidly mounted, G40 elastically."
    ),
    False: Text(
        "ISO 21940-11, inherently unbalanced crank drives, as this one: G250 rigidly mounted, G630 elastically."
    ),
}


def notes(imbalance: ImbalanceInputs, pitch: Metre, result: ImbalanceResult, bobs: Iterable[Text]) -> Iterator[Text]:
    """`pitch`: of the cylinders; `bobs`: what is told of the bobs of the balancing machine."""
    yield verdict(result.throw, pitch, imbalance.rotating_balance_fraction)
    yield from bobs
    if imbalance.drill_radius is not None and (result.webs is None or result.webs.drilled_mass is None):
        yield UNDRILLED
    if result.webs is not None and result.webs.permitted_unbalance is not None:
        yield INHERENTLY[all(balanced(result.throw, pitch))]
    yield MIDDLE
    if result.shaft_pair is None:
        yield from roll_notes(imbalance)


def errata(imbalance: ImbalanceInputs, result: ImbalanceResult) -> Iterator[Erratum]:
    """Where the thesis goes wrong that this chain follows: for designs with its kind of shaft."""
    kappa, second = imbalance.crank_balance_fraction, result.orders["order_2"].two_term
    if kappa and second is not None and second.couple_peak_vertical:
        theirs = f.second_order_couple_of_finotti(kappa=kappa, C_2=second.couple_peak_vertical)
        yield Erratum(
            dotted("imbalance", "order_2", declared(Order).couple_peak_vertical),
            Text("Second-order couple"),
            float(theirs),
            "N·m",
            Text("method of Finotti 2013, 2.5.3.4"),
            Text(
                "The source takes only the mass that is not balanced on the crank. Counterweights turn at crank speed "
                "and leave order 2 untouched: the whole reciprocating mass acts."
            ),
            ("Finotti 2013", "1004-1013"),
        )
