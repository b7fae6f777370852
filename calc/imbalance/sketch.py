# SPDX-License-Identifier: Apache-2.0
"""What shakes the engine, as a sketch: the force or the couple of an order over a turn, bare and as designed, at one
crank angle.

The arms of a picture are newtons or newton metres in place of metres; it says how many.  Up is up, the crank turns
clockwise."""

import cmath
import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from ..draw.drawing import CONTEXT, HIDDEN, OUTLINE, WORDS, Mark, Point, Polyline, Sketch, State, Words, judged
from ..sheet.quantity import dotted
from ..sheet.record import record
from ..sheet.text import Amount, Text
from ..sheet.units import Radian
from .curves import DRAWN, KINDS
from .inputs import ImbalanceInputs
from .orders import Order
from .result import ImbalanceResult

if TYPE_CHECKING:
    from ..design.model import Design
    from ..solve import Results

SHARE = dotted("imbalance", ImbalanceInputs.crank_balance_fraction)
CORNERS = 72  # of a locus
POINT = 0.03  # of the largest: a locus that is smaller is shown as a point
TITLES = {"couple": Text("couple of order {n}, N·m"), "force": Text("force of order {n}, N")}
NOTHING = 1e-3  # of the largest: what is left is called none
BARE, CRANK = Text("bare {peak}"), Text("counterweights {peak}")
SHAFT, SHAFTS, LEFT = Text("the shaft {peak}"), Text("the shafts {peak}"), Text("left {peak}")


@record
class VectorPair:
    """Two vectors of one order, one turning with the crank and one against it."""

    order: int
    forward: complex
    backward: complex

    def at(self, theta: Radian) -> complex:
        """Their sum at a crank angle; real is up, imaginary to the right."""
        return self.forward * cmath.exp(1j * self.order * theta) + self.backward * cmath.exp(-1j * self.order * theta)

    @property
    def peak(self) -> float:
        return abs(self.forward) + abs(self.backward)


def sketch(design: "Design", results: "Results", angle: Radian = 0.0) -> Sketch:
    """The forces and couples of orders 1 and 2 that there are, with the crank at an angle after TDC of cylinder 1."""
    result = results.outcomes["imbalance"].solution
    assert isinstance(result, ImbalanceResult)
    pictures = []
    for n in (1, 2):
        order = result.orders[f"order_{n}"]
        for kind, _, _, at in KINDS:
            bare, crank = VectorPair(n, *order.unbalanced[at : at + 2]), VectorPair(n, *order.vectors[at : at + 2])
            if bare.peak > DRAWN * (result.one_couple if kind == "couple" else result.one_force):
                supplied = SHAFTS if len(design.shafts) > 1 else SHAFT
                marks = tuple(_picture(bare, crank, *_shafts(results, n, order, at), supplied, angle))
                pictures.append(Sketch(marks, turning=True, title=Text(TITLES[kind].template, n=n)))
    if not pictures:
        return Sketch((Words(CONTEXT, (0.0, 0.0), Text("nothing of orders 1 and 2 is left"), side="centre"),))
    first, *others = pictures
    turned = Text("crank at {angle}", angle=Amount(round(math.degrees(angle)) % 360, "°"))
    return Sketch(first.primitives, (turned,), turning=True, title=first.title, beside=tuple(others))


def _shafts(results: "Results", n: int, order: Order, at: int) -> tuple[VectorPair | None, State]:
    """What the shafts supply of an order together, if one of them turns like it, and the verdict of what they leave;
    `at`: which of its vectors, those of the force or those of the couple."""
    left = results.left
    if left is None or n not in left.vectors:
        return None, ""
    found = left.vectors[n]
    forward, backward = found.couples if at else found.forces
    behind = ("_2", "_2_worse") if n > min(left.vectors) else ("",)
    ids = [f"countershaft.residual{'' if at else '_force'}{end}" for end in behind]
    state = judged(results.outcomes["countershaft"].checks, *ids)
    return VectorPair(n, forward - order.vectors[at], backward - order.vectors[at + 1]), state


def _picture(
    bare: VectorPair, crank: VectorPair, shaft: VectorPair | None, state: State, supplied: Text, angle: Radian
) -> Iterator[Mark]:
    """Loci and vectors around the origin, and what they are on their right."""
    reach = max(bare.peak, crank.peak)
    for x, y in ((0.05, 0.0), (0.0, 0.05)):
        yield Polyline(CONTEXT, ((-x * reach, -y * reach), (x * reach, y * reach)))
    shown: list[tuple[VectorPair, str, Text, str, State]] = [(bare, CONTEXT, BARE, "", "")]
    if abs(bare.forward - crank.forward) > POINT * bare.peak:
        shown.append((crank, HIDDEN if shaft is not None else OUTLINE, CRANK, SHARE, ""))
    if shaft is not None:
        left = VectorPair(crank.order, crank.forward + shaft.forward, crank.backward + shaft.backward)
        shown += [(shaft, OUTLINE, supplied, "countershaft", ""), (left, OUTLINE, LEFT, "", state)]
    paths = [[_point(pair.at(2 * math.pi * k / CORNERS / pair.order)) for k in range(CORNERS)] for pair, *_ in shown]
    right = max(0.3 * reach, *(x for path in paths for x, _ in path)) + 0.1 * reach
    for n, ((pair, layer, label, key, verdict), path) in enumerate(zip(shown, paths)):
        if pair.peak > POINT * reach:
            if pair is not shaft:
                yield Polyline(layer, tuple(path), closed=True, key=key, state=verdict)
            yield Polyline(layer, ((0.0, 0.0), _point(pair.at(angle))), arrow=True, key=key, state=verdict)
        y = reach * (0.75 - 0.5 * n)
        peak = Amount(pair.peak if pair.peak > NOTHING * reach else 0.0, digits=3)
        yield Polyline(layer, ((right, y), (right + 0.2 * reach, y)), key=key, state=verdict)
        words = CONTEXT if layer in (CONTEXT, HIDDEN) else WORDS
        yield Words(words, (right + 0.28 * reach, y), Text(label.template, peak=peak), key=key, state=verdict)


def _point(vector: complex) -> Point:
    return vector.imag, vector.real
