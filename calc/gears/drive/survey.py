# SPDX-License-Identifier: Apache-2.0
"""A train over speeds and loads: closed forces and strikes at every point, as arrays.

One survey is made for what is judged (12 speeds, three loads), another where a map is drawn."""

from collections.abc import Callable, Mapping
from functools import cached_property

import numpy as np

from ...sheet.arrays import Array, BoolArray
from ...sheet.record import record, replace
from ...sheet.units import Number
from .forces import Impacts, impacts
from .line import TrainOnLine
from .motion import Bodies, Motion
from .spring import Spring, sprung
from .strikes import Closed, Strikes, closed, fly

JUDGED, DRAWN = 12, 60  # speeds from idle to rated
LOADS = 0.0, 0.5, 1.0
FULL = (1.0,)
CORNERS: Mapping[str, Number] = {"nominal": 1.0, "most": 0.7, "least": 1.3}  # of the drag: rule of this program


@record
class Drags:
    """Drag on the line of action of every body (S, B) at rising speeds (S,) of the crank, linear between them."""

    speeds: Array
    of: Array

    def at(self, speeds: Array) -> Array:
        return np.stack([np.interp(speeds, self.speeds, D) for D in self.of.T], axis=-1)


@record
class Survey:
    """P operating points of the crank: speeds in 1/s, loads 0 to 1, and what the train does there."""

    speeds: Array  # (P,)
    loads: Array  # (P,)
    motion: Motion
    closed: Closed
    strikes: Strikes
    impacts: Impacts
    bodies: Bodies

    @cached_property
    def each_speed(self) -> Array:
        """The speeds, each once, rising."""
        return np.unique(self.speeds, return_index=True)[0]  # without an index it loads a package, for 20 ms

    def at(self, speed: float, load: float) -> int:
        """The point nearest to a speed and load."""
        return int(np.argmin(np.abs(self.speeds / speed - 1) + np.abs(self.loads - load)))


MotionAt = Callable[[Array, Array], Motion]  # of speeds and loads


def grid(idle: float, rated: float, loads: tuple[float, ...], count: int = JUDGED) -> tuple[Array, Array]:
    """Every speed with every load, speed by speed."""
    speeds, at = np.meshgrid(np.linspace(idle, rated, count), np.array(loads), indexing="ij")
    return speeds.ravel(), at.ravel()


def survey(
    motion: MotionAt,
    line: TrainOnLine,
    drags: Drags,
    springs: Mapping[int, Spring],
    speeds: Array,
    loads: Array,
    corner: str = "nominal",
) -> Survey:
    """`springs`: by the index of their mesh; a mesh is held closed where its spring is strong enough at the largest
    running backlash."""
    moved = motion(speeds, loads)
    bodies = line.bodies(drags.at(speeds), corner, CORNERS[corner])
    of = closed(moved, bodies)
    if springs:
        held: BoolArray = np.zeros(of.least.shape, dtype=bool)
        for i, spring in springs.items():
            held[:, i] = sprung(spring.given, spring.backlash, spring.radius, of.least[:, i])
        bodies = replace(bodies, sprung=held)
        of = closed(moved, bodies)
    strikes = fly(moved, bodies, of)
    return Survey(speeds, loads, moved, of, strikes, impacts(moved, bodies, of, strikes), bodies)
