# SPDX-License-Identifier: Apache-2.0
"""A ranked table for the user to choose from."""

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module

from calc.design import Design
from calc.sheet.errors import BadInput, InputError
from calc.sheet.progress import Progress
from calc.sheet.step import Table

CHOICES = {
    "engine": "firing orders, the one that leaves least first",
    "countershaft": "shafts in the envelope, the lightest first",
    "bearings": "plain bearings that pass at every corner, the nearest and the least power first",
    "gears": "profile shifts and tip cuts, the least specific sliding first",
}


@dataclass(frozen=True)
class Offer:
    """What was found: how many rows, the table of the first of them, and for each row (from 1) the keys to write and what is then said.

    `summary`: lines under the table's title; `notes`: a list behind all tables; `hidden`: which rows are not among the first.
    """

    count: int
    table: Callable[[int], Table]
    changes: Callable[[int], list[str]]
    said: Callable[[int], str]
    hint: str
    beside: Callable[[int], tuple[Table, ...]] = lambda top: ()  # further tables, beside so many rows of the first
    summary: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    hidden: Callable[[int], str] = lambda top: ""


def offer(step: str, design: Design, file: str, progress: Progress | None = None) -> Offer:
    """Search.  Raises BadInput where the design lacks what the search needs, NoSolution where there is nothing to offer; `progress`
    may raise `Cancelled`."""
    room = import_module(f"assistant.offers.{step}")
    missing = next((key for key in room.NEEDS if getattr(design, key) is None), None)
    if missing is not None:
        raise BadInput(file, [InputError(0, missing, "", f"needed: {room.WHY}")])
    found: Offer = room.offer(design, file, progress)
    return found
