# SPDX-License-Identifier: Apache-2.0
"""The window of the nominal backlash of one way, as it is handed on."""

from collections.abc import Mapping

from ...sheet.record import record
from ...sheet.units import Metre


@record
class Window:
    """Of one way, by the body that strikes last on it.  `by_phase`: whether the phase error rules its upper end."""

    body: int
    nominal: Metre
    low: Metre
    high: Metre | None  # None: its strikes never reach grade B's limit, and nothing else bounds it
    quiet_a: Metre | None
    quiet_b: Metre | None
    by_phase: bool
    taken: Mapping[str, Metre]  # by mesh: what tolerance, runout and temperature take of it
    widened: Metre  # by how much the largest running backlash is above the nominal one
