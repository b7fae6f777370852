# SPDX-License-Identifier: Apache-2.0
"""How long all bearings that fatigue live together."""

from collections.abc import Iterable, Sequence
from typing import Any, cast

from ..sheet.check import Check
from ..sheet.linked_array import gathered
from ..sheet.text import Text
from ..sheet.units import Second
from ..sheet.value import about
from .kinds import KINDS
from .result import BearingsResult
from .support import Carrying


def life_together(bearings: Iterable[Carrying]) -> Second | None:
    """Of bearings of one shaft or of several; None where none of them fatigues."""
    known = [one for bearing in bearings if (one := bearing.survival()) is not None]
    if not known:
        return None
    from .rolling.life import system_life  # with the room of what fatigues, which is there now

    with about(Text("all rolling bearings")):
        life: Any = system_life(L=gathered([life for life, _ in known]), e=gathered([spread for _, spread in known]))
    return cast("Second", life)


def lives_of_all(shafts: Sequence[BearingsResult]) -> tuple[Second | None, tuple[Check, ...]]:
    """The same of all shafts, and what is judged of it."""
    every = {(n, place): r for n, shaft in enumerate(shafts) for place, r in shaft.bearings.items()}
    life = life_together(every.values())
    words = dict.fromkeys(r.row.kind for r in every.values())
    those = {word: {f"{n}.{place}": r for (n, place), r in every.items() if r.row.kind == word} for word in words}
    return life, tuple(check for word in words for check in KINDS[word].renewed(those[word], life))
