# SPDX-License-Identifier: Apache-2.0
"""The train as a tree: which wheel drives which, from the first driver to the shafts.

A link is a mesh, or the chain or belt of a stage.  Every wheel but the first driver is driven by one link; it may drive
several.  Whatever is asked of a shaft follows the way from the first driver to the wheel that carries it."""

from collections.abc import Iterable, Sequence
from functools import cached_property, reduce
from operator import mul
from typing import Protocol, TypeVar

from ..sheet.record import record
from ..sheet.units import Number
from ..sheet.value import based_on


class Drives(Protocol):
    """What leads from one wheel to another."""

    @property
    def driver(self) -> str: ...

    @property
    def driven(self) -> str: ...


Driving = TypeVar("Driving", bound=Drives)


def first_of(links: Sequence[Drives]) -> str:
    """The first driver: the first one that nothing drives."""
    driven = {link.driven for link in links}
    return next((link.driver for link in links if link.driver not in driven), links[0].driver)


def in_flow(links: Iterable[Driving], first: str) -> tuple[Driving, ...]:
    """The links in the order in which the power flows, else as they are listed; those that no power reaches are left
    out."""
    waiting, reached, flow = list(links), {first}, list[Driving]()
    while (following := next((link for link in waiting if link.driver in reached), None)) is not None:
        waiting.remove(following)
        reached.add(following.driven)
        flow.append(following)
    return tuple(flow)


@record
class TrainLink:
    """`z_1`, `z_2`: teeth of its two wheels or sprockets.  `sense`: −1, they turn in opposite senses, as wheels in mesh
    do; +1, in the same one."""

    key: str  # what its values are called by
    title: str
    driver: str
    driven: str
    z_1: int
    z_2: int
    sense: int
    toothed: bool  # a mesh


@record
class Tree:
    """The links along the flow of power, one at least."""

    links: tuple[TrainLink, ...]

    @property
    def first(self) -> str:
        return self.links[0].driver

    @cached_property
    def driving(self) -> dict[str, TrainLink]:
        """The link that drives each wheel."""
        return {link.driven: link for link in self.links}

    @cached_property
    def by_key(self) -> dict[str, TrainLink]:
        return {link.key: link for link in self.links}

    def way(self, end: str) -> tuple[TrainLink, ...]:
        """The links from the first driver to a wheel."""
        way: tuple[TrainLink, ...] = ()
        while end in self.driving:
            way = (self.driving[end], *way)
            end = way[0].driver
        return way

    @cached_property
    def senses(self) -> dict[str, int]:
        """+1 for the wheels that turn as the first driver, −1 for the others."""
        senses = {self.first: 1}
        for link in self.links:
            senses[link.driven] = senses[link.driver] * link.sense
        return senses

    def reduction(self, link: TrainLink, end: str) -> tuple[Number, Number]:
        """Teeth z and z_end by which an angle of the wheel that `link` drives is reduced to `end`, behind it: by
        z/z_end.

        Wheels between two meshes cancel, so that without a chain these are the teeth of both wheels themselves."""
        above, below = [link.z_2], [link.z_2]
        way = self.way(end)
        for further in way[way.index(link) + 1 :]:
            if below[-1] == further.z_1:
                below[-1] = further.z_2
            else:
                above.append(further.z_1)
                below.append(further.z_2)
        return _product(above), _product(below)

    def turns(self, end: str) -> Number:
        """Of a wheel, in a turn of the first driver."""
        turns: Number = 1.0
        for link in self.way(end):
            turns = based_on(turns * link.z_1 / link.z_2, turns, link.z_1, link.z_2)
        return turns


def _product(teeth: list[int]) -> Number:
    return teeth[0] if len(teeth) == 1 else based_on(reduce(mul, teeth), *teeth)
