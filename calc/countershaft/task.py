# SPDX-License-Identifier: Apache-2.0
"""What the shaft has to take: of the order of its speed, the vectors of the engine that turn like it."""

from ..imbalance.result import ImbalanceResult
from ..sheet.record import record
from ..sheet.text import Text
from ..sheet.units import Newton, NewtonMetre
from ..sheet.value import based_on
from .inputs import CountershaftInputs

LEFT_OVER = 0.05  # share of the couple to be balanced that a good shaft may leave
WORDS = {1: Text("First"), 2: Text("Second")}


@record
class ShaftTask:
    """The engine's vectors of one order, cylinder 1 at TDC: those that turn like the shaft, and those that turn against
    it.

    `one_force`, `one_couple`: m·r·ω² of one cylinder, and over one pitch, by which what is left is judged.
    """

    order: int
    F: complex
    C: complex
    F_against: complex
    C_against: complex
    one_force: Newton
    one_couple: NewtonMetre

    @property
    def may_leave(self) -> NewtonMetre:
        """The couple that a good shaft may leave: a share of the one to be balanced, or of m·r·ω²·a where there is
        none."""
        whole = self.couple or self.one_couple
        return based_on(LEFT_OVER * whole, whole)

    @property
    def force_may_be_left(self) -> Newton:
        """The force that it may leave, or bring in."""
        return based_on(LEFT_OVER * self.one_force, self.one_force)

    @property
    def out_of_reach(self) -> frozenset[str]:
        """Of couple and force those of which more turns against the shaft than may be left: no mass of a single shaft
        takes it."""
        against = (("couple", self.C_against, self.may_leave), ("force", self.F_against, self.force_may_be_left))
        return frozenset(word for word, vector, limit in against if abs(vector) > limit)

    @property
    def couple(self) -> NewtonMetre:
        """The couple that a shaft must supply to leave nothing of what turns like it."""
        return based_on(abs(self.C), self.C)


def task(shaft: CountershaftInputs, imbalance: ImbalanceResult) -> ShaftTask:
    """The task of a shaft at `speed_ratio` times crank speed."""
    order = round(abs(shaft.speed_ratio))
    F_f, F_b, C_f, C_b = imbalance.orders[f"order_{order}"].vectors
    if shaft.speed_ratio < 0:
        return ShaftTask(order, F_b, C_b, F_f, C_f, imbalance.one_force, imbalance.one_couple)
    return ShaftTask(order, F_f, C_f, F_b, C_b, imbalance.one_force, imbalance.one_couple)
