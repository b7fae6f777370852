# SPDX-License-Identifier: Apache-2.0
"""What the search is given: the bearings as they are, what stands around them, and how to solve the whole with others."""

from collections.abc import Iterable, Mapping
from typing import Protocol, TypeVar

from ...library.catalogue import Oil
from ...countershaft.inputs import CountershaftInputs
from ...sheet.check import Check
from ...sheet.record import record
from ...sheet.step import Outcome
from ...sheet.units import Metre
from ..inputs import BearingsInputs

R = TypeVar("R")


class Solution(Protocol):
    """The results of a design, as far as the search looks into them."""

    @property
    def outcomes(self) -> Mapping[str, Outcome[object]]: ...
    def checks(self) -> Iterable[Check]: ...
    def result(self, kind: type[R]) -> R | None: ...


@record
class Case:
    """`results` are those of the design as it is.  `solve`: the same with other bearings.

    `own_oils`: names that the design itself has given; `gear_tip`: tip diameter of the gear on the shaft, None where it is not known.
    """

    bearings: BearingsInputs
    shaft: CountershaftInputs | None
    oils: Mapping[str, Oil]
    own_oils: tuple[str, ...]
    gear_tip: Metre | None
    results: Solution
    solve: "Solve"


class Solve(Protocol):
    """The design with other bearings.  `last`: no step after the bearings is solved."""

    def __call__(self, bearings: BearingsInputs, *, last: bool = False) -> Solution: ...
