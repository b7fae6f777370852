# SPDX-License-Identifier: Apache-2.0
"""Numbers that are given outside what is usual: a unit or a digit that slipped, more often than a bold design."""

from collections.abc import Iterable, Iterator, Sequence

from ..sheet.quantity import Quantity, keys
from ..sheet.record import record
from ..sheet.text import EMPTY, SEMICOLON, Amount, Text, plural
from .addresses import join
from .model import STEPS, Design
from .names import called

KEYS = tuple(step.key for step in STEPS)
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


def unusual(design: Design, steps: Iterable[str] = KEYS) -> list[Unusual]:
    """The furthest outside first.  Ranges are those that the form shows beside a field."""
    outliers = [
        outlier for step in steps if (inputs := getattr(design, step)) is not None for outlier in _of(inputs, step)
    ]
    return sorted(outliers, key=lambda outlier: -outlier.beyond)


def _of(inputs: object, prefix: str) -> Iterator[Unusual]:
    kind: type = type(inputs)
    for key in keys(kind).values():
        content, about, here = getattr(inputs, key.attribute), key.about, join(prefix, key.key)
        if content is None:
            continue
        if about.kind == "table":
            yield from _of(content, here)
        elif about.kind == "tables":
            for n, element in enumerate(content):
                yield from _of(element, join(here, getattr(element, "name", "") or str(n)))
        elif (usual := about.usual) is not None:
            numbers = [about.units.shown(x) for x in (content if isinstance(content, tuple) else (content,))]
            beyond = [max(usual[0] - number, number - usual[1]) / (usual[1] - usual[0]) for number in numbers]
            if (most := max(beyond, default=0.0)) > 0:
                yield Unusual(here, about, numbers[beyond.index(most)], usual, most)


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
