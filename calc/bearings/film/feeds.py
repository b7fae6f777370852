# SPDX-License-Identifier: Apache-2.0
"""Where the oil comes into a film that begins and ends there."""

from typing import NamedTuple

from ...sheet.record import record


class Feed(NamedTuple):
    """A groove or pocket along the bearing.  Two of one size at one place are the same, so that films are found again by their feeds."""

    angle: float  # of its middle, from the load in the sense in which the film is dragged, rad
    arc: float  # around, rad
    share: float = 1.0  # of the bearing's length


@record
class Feeds:
    """All of one bearing."""

    feeds: tuple[Feed, ...]
