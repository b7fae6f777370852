# SPDX-License-Identifier: Apache-2.0
"""What the search is given: the bearings as they are, what stands around them, and how to solve the whole with others."""

from collections.abc import Mapping
from typing import Any, Protocol

from ...catalogue import Oil
from ...countershaft.inputs import CountershaftInputs
from ...sheet.record import record
from ...sheet.units import Metre
from ..inputs import BearingsInputs


@record
class Case:
    """`results` are those of the design as it is: its outcomes by step, and `checks()`.  `solve`: the same with other bearings.

    `own_oils`: names that the design itself has given; `gear_tip`: tip diameter of the gear on the shaft, None where it is not known.
    """

    bearings: BearingsInputs
    shaft: CountershaftInputs | None
    oils: Mapping[str, Oil]
    own_oils: tuple[str, ...]
    gear_tip: Metre | None
    results: Any
    solve: "Solve"


class Solve(Protocol):
    """The design with other bearings.  `last`: no step after the bearings is solved."""

    def __call__(self, bearings: BearingsInputs, *, last: bool = False) -> Any: ...
