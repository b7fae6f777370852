# SPDX-License-Identifier: Apache-2.0
"""How long all bearings that fatigue live together."""

from collections.abc import Iterable
from typing import Any, cast

from ..sheet.linked_array import gathered
from ..sheet.text import Text
from ..sheet.units import Second
from ..sheet.value import about
from .rolling.life import system_life
from .support import Carrying


def life_together(bearings: Iterable[Carrying]) -> Second | None:
    """Of bearings of one shaft or of several; None where none of them fatigues."""
    known = [one for bearing in bearings if (one := bearing.survival()) is not None]
    if not known:
        return None
    with about(Text("all rolling bearings")):
        life: Any = system_life(L=gathered([life for life, _ in known]), e=gathered([spread for _, spread in known]))
    return cast("Second", life)
