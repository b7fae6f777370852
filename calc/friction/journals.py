# SPDX-License-Identifier: Apache-2.0
"""The journals of the counter-shaft at the end of the train: their friction follows from the power that the shaft's
gear takes in.

The eccentric masses load them with a force that turns; weight and gear force stand still.  The friction of the turning
load is that of the bearings step; what the standing part adds over a turn closes with the power of the train, which
makes the gear force."""

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from ..bearings.result import BearingsResult
from ..bearings.support import Answer
from ..countershaft.inputs import ShaftInputs
from ..countershaft.result import CountershaftResult, Standing
from ..countershaft.rows import called
from ..countershaft.supports import Gear, Sprocket, standing_of
from ..countershaft.supports import ShaftDrive as GearDrive
from ..library.lubricant import Lubricant
from ..sheet.arrays import BoolArray, Num
from ..sheet.formula import formula
from ..sheet.functions import along
from ..sheet.linked_array import gathered
from ..sheet.text import Text
from ..sheet.units import Newton, RevPerSecond, Watt
from ..sheet.value import about, untraced
from .result import JournalResult

NO_LOADS: Mapping[str, Watt] = {}


class OnShaft(NamedTuple):
    """What the friction step is told of the counter-shaft; without `shaft`, of bearings whose loads are given."""

    bearings: BearingsResult
    shaft: CountershaftResult | None
    inputs: ShaftInputs | None
    gear: Gear | None
    sprockets: tuple[Sprocket, ...] = ()

    @property
    def speed(self) -> RevPerSecond:
        """Of the shaft, in the bearings step."""
        return next(iter(self.bearings.bearings.values())).speed

    @property
    def turns(self) -> bool:
        """Whether a standing load passes under the turning one, as far as that is known: a shaft on two bearings, or
        one that bends."""
        if self.shaft is None or self.inputs is None:
            return False
        return len(self.inputs.bearing_positions) == 2 or self.bearings.stands is not None


@formula("P_B", "mathematics: sum of the journals' friction, as judged", names={"P": "P_f"})
def bearing_loss(P: Watt) -> Watt:
    return along(P)


class Journals:
    """The journals at one operating point or at many (`speed` of the shaft and `answers` then hold arrays)."""

    def __init__(self, on: OnShaft, answers: dict[str, Answer], speed: Any) -> None:
        self.on, self.answers, self.speed = on, answers, speed

    def only(self, some: BoolArray) -> "Journals":
        """Some of many operating points."""
        return Journals(self.on, {place: one.only(some) for place, one in self.answers.items()}, self.speed[some])

    def standing(self, P: Watt | None, loads: Mapping[str, Watt]) -> Standing | None:
        """What stands still where the shaft's gear takes in the power P, meshes, chains and belts the `loads`."""
        if not self.on.turns or self.on.inputs is None or self.on.shaft is None:
            return None
        strands = tuple((one, loads[one.stage]) for one in self.on.sprockets if one.stage in loads)
        drive = None if P is None and not strands else GearDrive(P, self.speed, strands)
        with about(Text("standing part of the load, in the balance")):
            b = self.on.bearings
            return standing_of(self.on.shaft, self.on.inputs, self.on.gear, drive, b.stands, b)

    def sum(self, journals: dict[str, JournalResult]) -> Watt:
        losses = [journal.friction_power for journal in journals.values()]
        many = any(map(np.ndim, losses))  # operating points
        P: Any = np.stack(np.broadcast_arrays(*losses), axis=-1) if many else gathered(losses)
        P_B: Watt = bearing_loss(P=P)
        return P_B

    def journals(self, P: Watt | None, loads: Mapping[str, Watt] = NO_LOADS) -> dict[str, JournalResult]:
        stands = self.standing(P, loads)
        journals = {}
        for place, answer in self.answers.items():
            R_0: Newton | None = None
            if stands is not None:
                R_0 = stands.stationary.get(place)
            if R_0 is None:
                P_f = answer.friction_power
            else:
                with about(Text("{place} bearing, over a turn", place=called(place))):
                    P_f = answer.under(R_0)
            journals[place] = JournalResult(standing_load=R_0, friction_power=P_f)
        return journals

    def notes(self, journals: dict[str, JournalResult]) -> Iterator[Text]:
        for place, journal in journals.items():
            if journal.standing_load is not None:
                if (note := self.answers[place].note(place, journal.standing_load)) is not None:
                    yield note


def journals_of(on: OnShaft) -> Journals:
    """At the speed and load of the bearings step."""
    answers = {place: bearing.answer(turns=on.turns) for place, bearing in on.bearings.bearings.items()}
    return Journals(on, answers, on.speed)


def journals_at(on: OnShaft, ratio: Num, T: Num, lubricant: Lubricant | None = None) -> Journals:
    """At speeds `ratio` times that of the design, loads that turn growing with its square, and supply temperatures T,
    one each or arrays.

    `lubricant`: left out, that of the bearings.
    """
    with untraced():
        answers = {place: one.answer_at(ratio, T, lubricant) for place, one in on.bearings.bearings.items()}
    return Journals(on, answers, on.speed * ratio)
