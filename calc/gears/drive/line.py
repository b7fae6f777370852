# SPDX-License-Identifier: Apache-2.0
"""The train on its line of action: a body for every link that drives one, in numbers that keep their links."""

from collections.abc import Mapping

import numpy as np

from ...sheet.arrays import Array
from ...sheet.record import record
from ...sheet.units import Kilogram, KilogramMetre2, Metre, Number, Radian
from ..tree import TrainLink
from .motion import Bodies


@record
class ShaftBody:
    """A shaft as the drive sees it.

    `J` on its axis, with its wheel where `with_wheel`; `U` its unbalance in kg·m, `angle` where that stands from up
    with cylinder 1 at TDC, in the sense of the crank; `ratio` its speed over the crank's, − against it."""

    J: KilogramMetre2
    with_wheel: bool
    U: float = 0.0
    angle: Radian = 0.0
    ratio: Number = 1.0


@record
class TrainOnLine:
    """The links of a train along the flow of power, each with the body that it drives, in numbers that keep their
    links: `radius` of the base circle at its mesh, or of the sprocket."""

    links: tuple[TrainLink, ...]
    parent: tuple[int, ...]
    rho: tuple[Number, ...]
    radius: tuple[Metre, ...]
    first_radius: Metre  # of the first driver
    J: tuple[KilogramMetre2, ...]
    mass: tuple[Kilogram, ...]
    width: tuple[Metre, ...]
    stiffness: tuple[float, ...]
    play: Mapping[str, tuple[Metre, ...]]  # along the line of action: "nominal", "most", "least"
    turns: tuple[Number, ...]  # in a turn of the first driver
    gravity: tuple[complex, ...]  # phasor of what gravity turns a body by, in N; 0 where it is not counted
    gravity_order: tuple[Number, ...]  # on the crank

    def index(self, key: str) -> int:
        return next(i for i, link in enumerate(self.links) if link.key == key)

    def path(self, i: int) -> tuple[int, ...]:
        """The links from the first driver to a body, its own last."""
        way: tuple[int, ...] = ()
        while i >= 0:
            way, i = (i, *way), self.parent[i]
        return way

    def bodies(self, drag: Array, play: str, factor: Number = 1.0) -> Bodies:
        """As arrays; `drag` (P, B), of which `factor` is taken."""
        of_gravity = any(self.gravity)
        return Bodies(
            gravity=np.tile(np.array(self.gravity), (len(drag), 1)) if of_gravity else None,
            gravity_order=np.array(self.gravity_order, dtype=float) if of_gravity else None,
            parent=self.parent,
            rho=np.array(self.rho, dtype=float),
            toothed=tuple(link.toothed for link in self.links),
            mass=np.array(self.mass, dtype=float),
            drag=drag * factor,
            backlash=np.array(self.play[play], dtype=float),
            width=np.array(self.width, dtype=float),
            stiffness=np.array(self.stiffness, dtype=float),
        )
