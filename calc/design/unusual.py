# SPDX-License-Identifier: Apache-2.0
"""Numbers that are given outside what is usual: a unit or a digit that slipped, more often than a bold design."""

from collections.abc import Iterable, Sequence
from typing import Any

from ..sheet.quantity import Quantity, given
from ..sheet.record import record
from ..sheet.text import EMPTY, SEMICOLON, Amount, Text, plural
from .model import STEP_KEYS, Design
from .names import called

SHOWN = 4


@record
class Unusual:
    """One input: its key, and the number furthest outside, in the unit of `about`, as the range is; `beyond`: by so
    many ranges."""

    key: str
    about: Quantity
    number: float
    usual: tuple[float, float]
    beyond: float

    @property
    def words(self) -> Text:
        low, high = self.usual
        return Text(
            "{input} {value} (usual {low} to {high})",
            input=called(self.key, self.about),
            value=Amount(self.number, self.about.unit),
            low=Amount(low),
            high=Amount(high),
        )


def unusual(design: Design, steps: Iterable[str] = STEP_KEYS) -> list[Unusual]:
    """The furthest outside first.  Ranges are those that the form shows beside a field."""
    tables = [(step, table) for step in steps if (table := getattr(design, step)) is not None]
    outliers = [
        outlier
        for step, table in tables
        for key, about, content in given(table, step, named=True)
        if (outlier := _outlier(key, about, content)) is not None
    ]
    return sorted(outliers, key=lambda outlier: -outlier.beyond)


def _outlier(key: str, about: Quantity, content: Any) -> Unusual | None:
    if (usual := about.usual) is None:
        return None
    numbers = [about.units.shown(x) for x in (content if isinstance(content, tuple) else (content,))]
    beyond = [max(usual[0] - number, number - usual[1]) / (usual[1] - usual[0]) for number in numbers]
    most = max(beyond, default=0.0)
    return Unusual(key, about, numbers[beyond.index(most)], usual, most) if most > 0 else None


def told(outliers: Sequence[Unusual], most: int = SHOWN) -> Text:
    """Of more than `most` the rest as a number; empty where there are none."""
    if not outliers:
        return EMPTY
    inputs = SEMICOLON.join(outlier.words for outlier in outliers[:most])
    if len(outliers) > most:
        inputs = Text("{names}; {more} more", names=inputs, more=len(outliers) - most)
    return plural(
        "{n} input is not usual: {inputs}", "{n} inputs are not usual: {inputs}", n=len(outliers), inputs=inputs
    )
