# SPDX-License-Identifier: Apache-2.0
"""Numbers that are given outside what is usual: a unit or a digit that slipped, more often than a bold design."""

from collections.abc import Iterable, Iterator

from .addresses import join
from .design import STEPS, Design
from .repair.words import called
from .sheet.quantity import Quantity, keys
from .sheet.record import record
from .sheet.text import SEMICOLON, Amount, Text

KEYS = tuple(step.key for step in STEPS)


@record
class Unusual:
    """One input: its key, and the number furthest outside, in the unit of `about`, as the range is."""

    key: str
    about: Quantity
    number: float
    usual: tuple[float, float]

    @property
    def words(self) -> Text:
        low, high = self.usual
        return Text(
            "{input} {value} (usual {low} to {high})",
            input=called(self.key, self.about), value=Amount(self.number, self.about.unit), low=Amount(low), high=Amount(high),
        )  # fmt: skip


def unusual(design: Design, steps: Iterable[str] = KEYS) -> list[Unusual]:
    """In the order of the form.  Ranges are those that the form shows beside a field."""
    return [one for step in steps if (inputs := getattr(design, step)) is not None for one in _of(inputs, step)]


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
            beyond = [max(usual[0] - number, number - usual[1]) for number in numbers]
            if (most := max(beyond, default=0.0)) > 0:
                yield Unusual(here, about, numbers[beyond.index(most)], usual)


def listed(found: list[Unusual], most: int = 3) -> Text:
    """Of more than `most` the rest as a number."""
    first = SEMICOLON.join(one.words for one in found[:most])
    return first if len(found) <= most else Text("{names}; {more} more", names=first, more=len(found) - most)
