# SPDX-License-Identifier: Apache-2.0
"""What the sketches of several steps ask for: the verdict of a part, a round exaggeration, and the picture of what is not known yet."""

import math
from collections.abc import Iterable
from typing import Protocol

from .check import Check
from ..draw.drawing import Sketch, State
from .text import Text


class Awaited(Protocol):
    """The outcome of a step, solved or not."""

    @property
    def reason(self) -> Text: ...


def judged(checks: Iterable[Check], *ids: str) -> State:
    """The worst verdict of the checks with these ids, or whose ids go on after a dot."""
    found = {c.verdict for c in checks if any(c.id == id or c.id.startswith(f"{id}.") for id in ids)}
    return "fail" if "fail" in found else "warn" if "warn" in found else ""


def awaited(outcome: Awaited) -> Sketch:
    """No picture yet, and what it waits for."""
    return Sketch(notes=(outcome.reason or Text("The picture waits for the results."),))


def rounded(factor: float) -> float:
    """The largest of 1, 1.5, 2, 3, 5, 7, 10, 15, … that is no more than this; as well below 1."""
    decade = 10.0 ** math.floor(math.log10(factor))
    return max((n * decade for n in (1, 1.5, 2, 3, 5, 7) if n * decade <= factor * (1 + 1e-9)), default=decade)
