# SPDX-License-Identifier: Apache-2.0
"""Where the motion of the crank comes from, and the train that it moves: what can be surveyed at any speed and load."""

import math
from collections.abc import Callable, Mapping
from functools import partial
from typing import Protocol

from ...engine.inputs import EngineInputs
from ...engine.load import CrankTorque, crank_torque
from ...engine.operation import GasRow
from ...engine.result import EngineResult
from ...sheet.arrays import Array
from ...sheet.record import record
from ...sheet.text import EMPTY, Amount, Text
from ...sheet.units import KilogramMetre2, Metre, Number, RevPerSecond, Watt
from ...sheet.value import based_on, untraced
from ..inputs import GearsInputs
from .crank import UnevenRow, given_motion, motion
from .line import ShaftBody, TrainOnLine
from .motion import Motion
from .spring import Spring
from .survey import DRAWN, JUDGED, Drags, Survey, grid, survey


class Balance(Protocol):
    """The closed balance of the friction, as far as the drive asks it."""

    def sources(self, wheel: str) -> tuple[object, ...]:
        """What the drag of a wheel stands on."""

    def drags(self, ratio: Array) -> dict[str, Array]:
        """The drag torque of every wheel and sprocket in N·m at `ratio` times the speeds of the balance; none where
        these are not known."""

    def loss_on(self, key: str, P: Watt, b: Metre) -> Watt:
        """What a mesh loses of a power on a part of its face width."""


@record
class CrankAtWork:
    """The engine as the drive sees it.

    `ratio`: speed of the first driver over that of the crank; `rows`: what is said of the gas at speeds and loads;
    `front`: whether the first wheel stands at the nose, None: not known; `shafts` by their names, those whose inertia
    is known; `friction`: the closed balance, None: no drag is known."""

    engine: EngineInputs
    e: EngineResult
    rows: tuple[GasRow, ...]
    idle: RevPerSecond
    ratio: Number
    front: bool | None
    shafts: Mapping[str, ShaftBody]
    friction: Balance | None


@record
class Source:
    """Where the motion of the crank comes from: a torque on flywheel and train, or an irregularity.

    `loads`: those that can be told apart, one where they are all alike; `assumed`: a default stands for it."""

    work: CrankAtWork
    gears: GearsInputs
    J_E: KilogramMetre2 | None
    rows: tuple[UnevenRow, ...]
    loads: tuple[float, ...]
    nose: bool
    r_1: Metre

    @property
    def assumed(self) -> bool:
        return self.J_E is None and not said(self.gears)

    def points(self, count: int = JUDGED) -> tuple[Array, Array]:
        """Speeds from idle to rated with every load."""
        idle, rated = self.work.idle, self.work.engine.rated_speed
        speeds, loads = grid(float(idle), float(rated), self.loads, count)
        return based_on(speeds, idle, rated), loads

    def torque(self, speeds: Array, loads: Array) -> CrankTorque:
        work = self.work
        return crank_torque(work.engine, work.e, work.rows, speeds, loads, idle=work.idle)

    def moved(self, speeds: Array, loads: Array, torque: CrankTorque | None = None) -> Motion:
        """Of the first driver; `torque`: at these points, where it is there already."""
        i_1 = abs(self.work.ratio)
        if self.J_E is None:
            return given_motion(self.rows, speeds, self.work.engine.strokes * math.pi, self.r_1, i_1)
        torque = self.torque(speeds, loads) if torque is None else torque
        return motion(torque, speeds, self.J_E, self.r_1, i_1, twist=self.work.engine.crank_twist, nose=self.nose)


def said(gears: GearsInputs) -> bool:
    """Whether the design gives an irregularity."""
    return gears.speed_irregularity is not None or bool(gears.drive is not None and gears.drive.irregularity)


@record
class Drive:
    """What `over_speed` knows: for maps, remedies and pictures, which survey it at other points."""

    work: CrankAtWork
    line: TrainOnLine
    source: Source
    drags: Drags
    springs: Mapping[int, Spring]
    drag_known: bool

    def survey(self, speeds: Array, loads: Array, corner: str = "nominal") -> Survey:
        return survey(self.source.moved, self.line, self.drags, self.springs, speeds, loads, corner)

    def drag_sources(self, wheel: str) -> tuple[object, ...]:
        """What the drag of a wheel stands on: what was measured of it, else the friction."""
        given, friction = self.source.gears.drive, self.work.friction
        rows = [row.torque for row in given.drag if row.wheel == wheel] if given is not None else []
        return tuple(rows) if rows or friction is None else friction.sources(wheel)

    @property
    def taken(self) -> Text:
        """What stands for the motion of the crank where nothing is given."""
        row = self.source.rows[0] if self.source.rows else None
        if row is None:
            return EMPTY
        return Text(
            "an irregularity of {delta} at idle, {n}",
            delta=Amount(row.delta * 100, "%"),
            n=Amount(row.speed * 60, "rpm", form=".0f"),
        )

    def lost(self, key: str) -> Callable[[Watt, Metre], Watt] | None:
        """What a mesh loses of a power by the friction of the closed balance, over a part of its face width."""
        friction = self.work.friction
        return None if friction is None else partial(friction.loss_on, key)

    def drawn(self) -> Survey:
        """The map."""
        with untraced():
            return self.survey(*self.source.points(DRAWN))
