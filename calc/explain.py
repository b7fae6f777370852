# SPDX-License-Identifier: Apache-2.0
"""The chain of recorded lines that leads to a value.

A value is linked to the line that made it, and an argument to the line or the input it came from, by identity: the very object that a
formula returned is the one that the next formula was given.  Numbers that were taken out of an array, or put into one, are new objects:
they are found again by their value, as far as that tells them apart.
"""

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, is_dataclass
from heapq import heapify, heappop, heappush
from typing import Any

import numpy as np

from .design import Design
from .sheet.check import Check
from .sheet.quantity import Key, Published, keys
from .sheet.trace import Line
from .solve import Results

WORD = re.compile(r"[\w-]+")
SHORT = 64  # elements of an array that single numbers are looked for in
MATES = ("z_1", "z_2", "z_m", "z_d", "z_last")  # teeth of the wheels of a pair or a train
Origins = dict[int, list[tuple[str, str]]]  # identity of a number or text → its keys in the file, each with its symbol


@dataclass(frozen=True)
class Link:
    """One line of a chain and the inputs that enter it directly, as keys of the design file."""

    line: Line
    inputs: tuple[str, ...]


def chain(results: Results, value_id: str) -> list[Link]:
    """The lines that lead to a value, each behind those that it needs; empty for a value taken straight from an input."""
    return Chains(results).of(value_id)


def behind(check: Check, values: dict[str, Published]) -> str | None:
    """The value that a check is on: of the same step, with the same number and unit."""
    same = [v.id for v in values.values() if v.unit == check.unit and v.shown == check.value]
    places = (check.id.rpartition(".")[0], check.id.partition(".")[0])  # the object of the check, else its step
    return next((id for place in places for id in same if id.startswith(place + ".")), None)


def origin(results: Results, value_id: str) -> str | None:
    """The key of a value that is an input itself, or that a name brings in."""
    found = _origins(results.design).get(id(results.values()[value_id].inside))
    return found[0][0] if found else None


class Chains:
    """What the chains of one design's values are found by."""

    def __init__(self, results: Results) -> None:
        self.results = results
        self.values = results.values()
        told = [(line, step) for step, outcome in enumerate(results.outcomes.values()) for line in outcome.lines]
        self.lines, self.steps = [line for line, _ in told], [step for _, step in told]
        self.made: dict[int, list[int]] = {}  # identity of a result → its lines; more than one where a formula hands an argument on
        self.holds: dict[complex, list[int]] = {}  # number → the lines whose result it is, or whose result is a short array with it
        self.given: dict[int, int] = {}  # identity of a solution (no number) → the first line that it was given to
        for number, line in enumerate(self.lines):
            self.made.setdefault(id(line.value), []).append(number)
            for x in _numbers(line.value):
                self.holds.setdefault(x, []).append(number)
            for argument in line.arguments.values():
                if not isinstance(argument, (int, float, complex, str, tuple, np.ndarray)):
                    self.given.setdefault(id(argument), number)
        self.origins = _origins(results.design)
        self.columns = [column for column in _columns(results.design) if len(column[1]) > 1 or any(column[1])]
        self.longest = max((len(column) for _, column, _ in self.columns), default=0)
        self.counts = list(_counts(results.design))

    def of(self, value_id: str) -> list[Link]:
        """The chain of one value."""
        return self._links(self._made_by(value_id))

    def to(self, line: Line) -> list[Link]:
        """The chain of one line of the calculation; empty for a line of other results."""
        return self._links([n for n, other in enumerate(self.lines) if other is line][:1])

    def leading_to(self, value_ids: Iterable[str]) -> set[int]:
        """The numbers, among the lines of all steps in their order, of those that lead to any of these values."""
        return set(self._leading_to([n for id in value_ids for n in self._made_by(id)]))

    def _made_by(self, value_id: str) -> list[int]:
        """The line that gave a value; none where it is an input."""
        value = self.values[value_id]
        makers = self.made.get(id(value.inside), [])
        start = [n for n in makers if self.lines[n].formula.symbol == value.symbol] or makers
        if not start and id(value.inside) not in self.origins:
            start = self._holding(value.inside, value.symbol, len(self.lines))
        return start[-1:]

    def _links(self, todo: list[int]) -> list[Link]:
        return [Link(self.lines[n], tuple(self._inputs(n))) for n in _ordered(self._leading_to(todo))]

    def _leading_to(self, todo: list[int]) -> dict[int, set[int]]:
        """The lines that lead to some, and those themselves, each with the lines that it needs."""
        needs: dict[int, set[int]] = {}
        while todo:
            number = todo.pop()
            if number not in needs:
                arguments = self.lines[number].arguments
                needs[number] = {m for name, x in arguments.items() for m in self._makers(x, self._symbol(number, name), number)}
                todo += needs[number]
        return needs

    def _symbol(self, number: int, name: str) -> str:
        """The symbol of an argument, as the line shows it."""
        from .sheet.expression import symbol

        return self.lines[number].formula.names.get(name, symbol(name))

    def _makers(self, x: Any, symbol: str, before: int) -> list[int]:
        """The lines that an argument comes from: that which made the very object, or else those that made the numbers in it."""
        makers = self.made.get(id(x), [])
        if earlier := [n for n in makers if n < before]:
            return earlier[-1:]
        if id(x) in self.origins:
            return []
        if later := [n for n in makers if self.steps[n] != self.steps[before]]:  # a step that the screen shows further down
            return later[:1]
        if (first := self.given.get(id(x))) is not None:
            return [first] if first < before else []
        if isinstance(x, (np.ndarray, tuple)):
            if self._whole_columns(x):
                return []
            return [n for item in _numbers(x) for n in self._holding(item, symbol, before)]
        return self._holding(x, symbol, before)

    def _holding(self, x: Any, symbol: str, before: int) -> list[int]:
        """The last line whose result is this number or has it; numbers that turn up anywhere only where the symbol is the same."""
        if not isinstance(x, (float, complex)) or not x:
            return []
        found = [n for n in self.holds.get(x, ()) if n < before]
        same = [n for n in found if self.lines[n].formula.symbol == symbol]
        if _common(x):
            return same[-1:]
        single = [n for n in found if isinstance(self.lines[n].value, (float, complex))]
        return ([n for n in single if n in same] or single or same or found)[-1:]

    def _inputs(self, number: int) -> list[str]:
        """The keys of the arguments of a line that come straight from the file.

        Of several that may be meant, as with numbers that the program takes by default, that which the line's subject names ("wheel
        idler"), or else that which stands nearest to the line's other inputs.
        """
        line = self.lines[number]
        found = [self._keys(name, x, number) for name, x in line.arguments.items() if id(x) not in self.made]
        sure = [one[0] for one in found if len(one) == 1]
        subject = set(WORD.findall(line.about))

        def rank(key: str) -> tuple[int, int]:
            return len(subject.intersection(key.split("."))), max((_alike(key, other) for other in sure), default=0)

        chosen: list[str] = []
        for one in found:
            chosen += [max(one, key=rank)] if isinstance(one, tuple) and one else one  # a list: all of them are in the array
        return chosen

    def _keys(self, name: str, x: Any, number: int) -> list[str] | tuple[str, ...]:
        """The keys that an argument comes from (a list), or may come from (a tuple): defaults of the program may be one object."""
        if isinstance(x, int):  # whole numbers are one object wherever they stand: their name tells them apart
            return tuple(key for key, names, count in self.counts if name in names and count == x)
        if found := self.origins.get(id(x)):
            return tuple(dict.fromkeys([key for key, symbol in found if symbol == name] or [key for key, _ in found]))
        if isinstance(x, (np.ndarray, tuple)):
            if whole := self._whole_columns(x):
                return [next((key for key, symbol in whole if symbol == name), whole[0][0])]
            symbol_ = self._symbol(number, name)
            there = {item for item in _numbers(x) if not self._holding(item, symbol_, number)}
            return [key for key, column, symbol in self.columns if symbol == name and not there.isdisjoint(column)]
        return []

    def _whole_columns(self, x: Any) -> list[tuple[str, str]]:
        """The columns of the design that an array is, or begins with where they are long enough to be told apart; with their symbols."""
        if isinstance(x, np.ndarray) and x.ndim != 1:
            return []
        size, first = len(x), tuple(x[: self.longest].tolist() if isinstance(x, np.ndarray) else x[: self.longest])
        return [
            (key, symbol) for key, column, symbol in self.columns
            if first[: (n := len(column))] == column and (n == size or 2 < n < size)
        ]  # fmt: skip


def _ordered(needs: dict[int, set[int]]) -> Iterator[int]:
    """Lines as they were computed, but each behind those that it needs."""
    waits = {n: len(of) for n, of in needs.items()}
    wanted_by: dict[int, list[int]] = {n: [] for n in needs}
    for n, of in needs.items():
        for m in of:
            wanted_by[m].append(n)
    ready = [n for n, count in waits.items() if not count]
    heapify(ready)
    while ready:
        n = heappop(ready)
        yield n
        for m in wanted_by[n]:
            waits[m] -= 1
            if not waits[m]:
                heappush(ready, m)


def _numbers(x: Any) -> list[Any]:
    """The numbers of a result or an argument; none of a long array."""
    if isinstance(x, (float, complex)):
        return [x]
    if isinstance(x, np.ndarray):
        return x.tolist() if x.ndim == 1 and x.size <= SHORT and x.dtype.kind in "fc" else []
    return [item for item in x if isinstance(item, float)] if isinstance(x, tuple) and len(x) <= SHORT else []


def _common(x: complex) -> bool:
    """Whether a number is one that turns up anywhere: 0, 1, ½ …"""
    return abs(x - complex(round(x.real, 3), round(x.imag, 3))) < 1e-12


def _alike(key: str, other: str) -> int:
    """How many parts two keys have in common from their beginning."""
    parts = zip(key.split("."), other.split("."))
    return next((n for n, (a, b) in enumerate(parts) if a != b), min(key.count("."), other.count(".")) + 1)


# --- what the design says ---------------------------------------------------------------------------------------------------
def _tables(inputs: Any, prefix: str = "") -> Iterator[tuple[Any, str]]:
    """Every table of the design with its key; elements of arrays by name, else by index."""
    yield inputs, prefix
    for key in _keys_of(inputs):
        content, here = getattr(inputs, key.attribute), f"{prefix}.{key.key}" if prefix else key.key
        if is_dataclass(content):
            yield from _tables(content, here)
        elif key.about.kind == "tables":
            for i, part in enumerate(content):
                yield from _tables(part, f"{here}.{getattr(part, 'name', i)}")


def _keys_of(inputs: Any) -> Iterable[Key]:
    cls: Any = type(inputs)
    return keys(cls).values()


def _origins(design: Design) -> Origins:
    """Every number and text of the design, and the numbers that a name brings in: an oil's, a material's."""
    found: Origins = {}
    oils, materials = design.oils, design.materials
    named = []
    for inputs, prefix in _tables(design):
        for key in _keys_of(inputs):
            content, here = getattr(inputs, key.attribute), f"{prefix}.{key.key}" if prefix else key.key
            series = isinstance(content, tuple) and key.about.kind in ("series", "integers")
            if series or (isinstance(content, (float, str)) and content != ""):
                found.setdefault(id(content), []).append((here, key.about.symbol))
            if isinstance(content, tuple):
                for item in content:
                    if isinstance(item, float):
                        found.setdefault(id(item), []).append((here, ""))
            if isinstance(content, str) and key.attribute.endswith(("oil", "material")):
                known = (oils if key.attribute == "oil" else materials).get(content)
                if known is not None and known not in (*design.oil, *design.material):  # those are inputs themselves
                    named.append((known, f"{here} ({content})"))
    for known, here in named:
        for part in _keys_of(known):
            if isinstance(number := getattr(known, part.attribute), float):
                found.setdefault(id(number), []).append((here, part.about.symbol or part.attribute))
    return found


def _counts(design: Design) -> Iterator[tuple[str, tuple[str, ...], int]]:
    """Each whole number of the design: its key, the names that it has in formulas, and itself."""
    for inputs, prefix in _tables(design):
        for key in _keys_of(inputs):
            if key.about.kind == "integer" and (number := getattr(inputs, key.attribute)) is not None:
                names = (key.about.symbol, key.attribute, *(MATES if key.about.symbol == "z" else ()))
                yield f"{prefix}.{key.key}", names, number


def _columns(design: Design) -> Iterator[tuple[str, tuple[float, ...], str]]:
    """Each number of an array of tables as a column, `countershaft.masses.*.mass_kg`, each list, and the symbol of both."""
    for inputs, prefix in _tables(design):
        for key in _keys_of(inputs):
            content, here = getattr(inputs, key.attribute), f"{prefix}.{key.key}" if prefix else key.key
            if key.about.kind in ("series", "integers") and content:
                yield here, content, key.about.symbol
            elif key.about.kind == "tables" and content:
                for part in _keys_of(content[0]):
                    column = tuple(getattr(item, part.attribute) for item in content)
                    if part.about.kind == "number":
                        yield f"{here}.*.{part.key}", column, part.about.symbol
