# SPDX-License-Identifier: Apache-2.0
"""A ranked table for the user to choose from."""

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module

from calc.design.model import Design
from calc.sheet.changes import Changes, assignments
from calc.sheet.errors import BadInput, InputError
from calc.sheet.progress import Progress
from calc.sheet.step import Table
from calc.sheet.text import EMPTY, Text

CHOICES = {
    "engine": Text("firing orders, the one that leaves least first"),
    "countershaft": Text("shafts in the envelope, the lightest first"),
    "bearings": Text("plain bearings that pass at every corner, the nearest and the least power first"),
    "gears": Text("profile shifts and tip cuts, the least specific sliding first; teeth of an idler between walls"),
    "mounting": Text("mounts that decouple the modes between the road's frequency and idle, the purest first"),
}


@dataclass(frozen=True)
class Offer:
    """What was found: how many rows, the table of the first of them, and for each row (from 1) its keys and what is then said.

    `summary`: lines under the table's title; `notes`: a list behind all tables; `hidden`: which rows are not among the first.
    """

    count: int
    table: Callable[[int], Table]
    keys: Callable[[int], Changes]
    said: Callable[[int], Text]
    hint: Text
    beside: Callable[[int], tuple[Table, ...]] = lambda top: ()  # further tables, beside so many rows of the first
    summary: tuple[Text, ...] = ()
    notes: tuple[Text, ...] = ()
    hidden: Callable[[int], Text] = lambda top: EMPTY

    def changes(self, number: int) -> list[str]:
        """What writes a row into the design, as KEY=VALUE.  Raises NoSolution where the row does not hold after all."""
        return assignments(self.keys(number))


def offer(step: str, design: Design, file: str, progress: Progress | None = None) -> Offer:
    """Search.  Raises BadInput where the design lacks what the search needs, NoSolution where there is nothing to offer; `progress`
    may raise `Cancelled`."""
    room = import_module(f"assistant.offers.{step}")
    missing = next((key for key in room.NEEDS if getattr(design, key) is None), None)
    if missing is not None:
        raise BadInput(file, [InputError(0, missing, "", Text("needed: {why}", why=room.WHY))])
    found: Offer = room.offer(design, file, progress)
    return found
