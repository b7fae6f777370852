# SPDX-License-Identifier: Apache-2.0
"""What a clearance is made of as tables: the parts of the stack, and which shell goes with which pair of classes."""

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from ....countershaft.rows import called
from ....sheet.quantity import dotted
from ....sheet.record import record
from ....sheet.step import Table
from ....sheet.text import SEMICOLON, Amount, Text
from ....sheet.units import Metre
from ....sheet.value import untraced
from .classes import Range
from .result import SelectResult
from .stack import SeatStack

if TYPE_CHECKING:
    from ..routes.states import BearingCase

LEAST, MOST, MIDDLE = Text("least"), Text("most"), Text("middle")


@record
class StackPart:
    """One part of a clearance: it counts `times`, below nought against it.  `field`: by how much it opens the
    clearance, of parts that are sorted that of the widest class."""

    name: Text
    times: int
    least: Metre
    most: Metre
    field: Metre

    @property
    def term(self) -> Text:
        """With its sign, as it stands in the sum."""
        if self.times == 1:
            return Text("+ {part}", part=self.name)
        return Text("− {part}", part=self.name) if self.times == -1 else Text("− 2 × {part}", part=self.name)


def ends_of(seat: "BearingCase[Any]") -> Range:
    """Least and most clearance of all parts that may come together."""
    assert seat.stack is not None
    with untraced():
        return seat.stack.clearances(seat.rings)


def stack_parts(seat: "BearingCase[Any]") -> list[StackPart]:
    """From the outside inwards; at the end by how much wider the seated bore stands.  Of shells by classes: of the pair
    with the least clearance."""
    stack, row = seat.stack, seat.bearing
    assert stack is not None
    name = Text("bore of the seat") if not row.ringed else Text("housing bore")
    if stack.walls is None and row.ringed:
        name = Text("finished bore")
    bore, walls, journal = _one(seat)
    parts = [StackPart(name, 1, *bore, bore[1] - bore[0])]
    if walls is not None:
        parts.append(StackPart(Text("wall"), -2, *walls, 2 * (walls[1] - walls[0])))
    parts.append(StackPart(Text("journal"), -1, *journal, journal[1] - journal[0]))
    if walls is not None and seat.rings is not None:
        least, most = clearance_of(seat)
        rise = least - bore[0] + 2 * walls[1] + journal[1], most - bore[1] + 2 * walls[0] + journal[0]
        parts.append(StackPart(Text("rise of the bore by the press"), 1, *rise, rise[1] - rise[0]))
    return parts


def pair_of(seat: "BearingCase[Any]") -> tuple[int, int] | None:
    """Of shells by classes the pair that is shown: that with the least clearance."""
    stack = seat.stack
    return None if stack is None or stack.pairs is None else stack.governing(seat.rings)[0]


def _one(seat: "BearingCase[Any]") -> tuple[Range, Range | None, Range]:
    stack, pair = seat.stack, pair_of(seat)
    assert stack is not None
    return (stack.bore, stack.walls, stack.journal) if pair is None or stack.pairs is None else stack.pairs[pair]


def clearance_of(seat: "BearingCase[Any]") -> Range:
    """Least and most clearance of the parts that are shown."""
    stack, pair = seat.stack, pair_of(seat)
    assert stack is not None
    with untraced():
        return stack.end(pair, seat.rings, 0), stack.end(pair, seat.rings, 1)


def squares(parts: list[StackPart]) -> Metre:
    """Field of the clearance by the root of the squares of its parts' fields."""
    return math.hypot(*(part.field for part in parts))


def seat_tables(place: str, seat: "BearingCase[Any]", select: SelectResult | None) -> Iterator[Table]:
    """Nothing of a seat that says nothing."""
    if seat.stack is not None:
        yield _stack_table(place, seat)
    if select is not None and seat.stack is not None:
        yield _classes_table(place, seat.stack, select)


def size(length: Metre, digits: int = 4) -> Text:
    """A length in mm, written to the tenth of a micrometre."""
    return Text("{size}", size=Amount(length * 1e3, form=f".{digits}f"))


def _microns(field: Metre) -> float:
    """To the tenth, as the sizes beside it."""
    return round(field * 1e6, 1) + 0.0


def _stack_table(place: str, seat: "BearingCase[Any]") -> Table:
    parts, (least, most) = stack_parts(seat), clearance_of(seat)
    rows = [(part.term, size(part.least), size(part.most), _microns(part.field)) for part in parts]
    field, middle = squares(parts), (least + most) / 2
    ends = (Text("= clearance, worst case"), size(least), size(most), _microns(most - least))
    low, high = middle - field / 2, middle + field / 2
    root = (Text("= clearance, root of squares about the middle"), size(low), size(high), _microns(high - low))
    note = Text("Assembled at {T}.", T=Amount(seat.inputs.clearance_reference_temperature, "°C"))
    if (pair := pair_of(seat)) is not None:
        low, high = ends_of(seat)
        note = Text(
            "{assembled} Bore class {bore} with journal class {journal}, which has the least clearance; all pairs: "
            "{low} to {high}.",
            assembled=note,
            bore=str(pair[0]),
            journal=str(pair[1]),
            low=Amount(low * 1e6, form=".1f"),
            high=Amount(high * 1e6, "µm", form=".1f"),
        )
    return Table(
        f"stack_{place}",
        Text("What the clearance is made of, {place} bearing", place=called(place)),
        ((Text("part"), ""), (LEAST, "mm"), (MOST, "mm"), (Text("field in the clearance"), "µm")),
        (*rows, ends, root),
        note,
        short=True,
    )


# --- shells by classes


def limits_of(limits: Range) -> Text:
    return Text("{least} to {most}", least=size(limits[0], 3), most=size(limits[1], 3))


def _classes_table(place: str, stack: SeatStack, select: SelectResult) -> Table:
    assert stack.pairs is not None
    words = stack.shells
    bores, journals = (dict.fromkeys(pair[n] for pair in stack.pairs) for n in (0, 1))
    head = tuple(
        (Text("{n}: {limits}", n=n, limits=limits_of(stack.pairs[next(iter(bores)), n][2])), "") for n in journals
    )
    rows = tuple(
        (
            Text("{n}: {limits}", n=bore, limits=limits_of(stack.pairs[bore, next(iter(journals))][0])),
            *(_cell(words[stack.pairs[bore, n][1]], select, f"{bore}_{n}") for n in journals),
        )
        for bore in bores
    )
    walls = (Text("{colour} {limits}", colour=word, limits=limits_of(wall)) for wall, word in words.items())
    return Table(
        f"classes_{place}",
        Text("Shells by classes, {place} bearing", place=called(place)),
        ((Text("bore / journal, mm"), ""), *head),
        rows,
        Text(
            "Clearance at the middle interference. Shells by their wall in mm, colours by this program: {walls}.",
            walls=SEMICOLON.join(walls),
        ),
        (f"{dotted('bearings', place)}.select.",),
        short=True,
    )


def _cell(colour: Text, select: SelectResult, pair: str) -> Text:
    least, most = (Amount(g * 1e6, form=".1f") for g in (select.pair[pair].min, select.pair[pair].max))
    return Text("{colour}, {least} to {most} µm", colour=colour, least=least, most=most)
