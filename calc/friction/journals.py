# SPDX-License-Identifier: Apache-2.0
"""The journals of the counter-shaft at the end of the train: their friction follows from the power that the shaft's
gear takes in.

The eccentric masses load them with a force that turns; weight and gear force stand still.  The friction of the turning
load is that of the bearings step; what the standing part adds over a turn closes with the power of the train, which
makes the gear force."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from ..bearings.plain.loads import SECOND_ORDER, Response, answered, response
from ..bearings.plain.routes.states import OperatingPoint
from ..bearings.plain.speeds import TURNING
from ..bearings.result import BearingsResult
from ..countershaft.inputs import ShaftInputs
from ..countershaft.result import CountershaftResult, Standing
from ..countershaft.rows import called, titled
from ..countershaft.supports import Gear, Sprocket, standing_of
from ..countershaft.supports import ShaftDrive as GearDrive
from ..library.lubricant import Lubricant
from ..sheet.arrays import BoolArray, Num
from ..sheet.formula import formula
from ..sheet.functions import along
from ..sheet.linked_array import gathered
from ..sheet.text import Amount, Text
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
        return next(iter(self.bearings.bearings.values())).duty.speed

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
    """The journals at one operating point or at many (`speed` of the shaft and `responses` then hold arrays)."""

    def __init__(self, on: OnShaft, responses: dict[str, Response], speed: Any) -> None:
        self.on, self.responses, self.speed = on, responses, speed
        # at some point
        self.unsteady = {place: not np.all(np.isfinite(r.slope + r.curvature)) for place, r in responses.items()}

    def only(self, some: BoolArray) -> "Journals":
        """Some of many operating points."""
        parts = {
            place: Response(**{name: x[some] if np.ndim(x) else x for name, x in vars(r).items()})
            for place, r in self.responses.items()
        }
        return Journals(self.on, parts, self.speed[some])

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
        for place, answer in self.responses.items():
            R_0: Newton | None = None
            if stands is not None:
                R_0 = stands.stationary.get(place)
            P_f = answer.friction_power
            if R_0 is not None and np.any(np.isfinite(answer.slope + answer.curvature)):
                with about(Text("{place} bearing, over a turn", place=called(place))):
                    P_f = answer.power(R_0)
                if self.unsteady[place]:
                    P_f = np.where(np.isfinite(P_f), P_f, answer.friction_power)  # type: ignore[assignment]
            journals[place] = JournalResult(standing_load=R_0, friction_power=P_f)
        return journals

    def notes(self, journals: dict[str, JournalResult]) -> Iterator[Text]:
        for place, journal in journals.items():
            F = self.responses[place].load
            if journal.standing_load is None:
                continue
            if self.unsteady[place]:
                yield Text(
                    "{place} journal: no film is found 5 % beside its load; its friction is that of the turning load.",
                    place=titled(place),
                )
            elif journal.standing_load > SECOND_ORDER * F:
                percent = Amount(journal.standing_load / F * 100, form=".0f")
                yield Text(
                    "{place} journal: {share}; the mean over a turn, of second order in it, is rough.",
                    place=titled(place),
                    share=Text("the standing load is {standing_load} % of the turning one", standing_load=percent),
                )


def journals_of(on: OnShaft) -> Journals:
    """At the speed and load of the bearings step."""
    responses, speed = {}, 0.0
    for place, bearing in on.bearings.bearings.items():
        speed = bearing.duty.speed
        if on.turns:
            with about(Text("{place} bearing, over a turn", place=called(place))):
                responses[place] = answered(bearing.beside, bearing.duty, bearing.friction_power)
        else:
            P_f = bearing.friction_power
            responses[place] = Response(load=bearing.load, friction_power=P_f, slope=0.0, curvature=0.0)
    return Journals(on, responses, speed)


def journals_at(on: OnShaft, ratio: Num, T: Num, lubricant: Lubricant | None = None) -> Journals:
    """At speeds `ratio` times that of the design, loads that turn growing with its square, and supply temperatures T,
    one each or arrays.

    `lubricant`: left out, that of the bearings.
    """
    responses, speed = {}, 0.0
    with untraced():
        for place, bearing in on.bearings.bearings.items():
            turns = bearing.seat.inputs.load_speed_ratio == TURNING
            duty: OperatingPoint[Any] = bearing.duty
            duty = replace(
                duty,
                load=duty.load * (ratio**2 if turns else ratio**0),
                speed=duty.speed * ratio,
                effective_speed=duty.effective_speed * ratio,
                supply_temperature=T,
            )
            seat = bearing.seat if lubricant is None else replace(bearing.seat, lubricant=lubricant)
            responses[place], speed = response(seat, duty), duty.speed
    return Journals(on, responses, speed)
