# SPDX-License-Identifier: Apache-2.0
"""The chain of recorded lines that leads to a value.

A value is linked to the line that made it, and an argument to the line or the input it came from, by identity: the very object that a
formula returned is the one that the next formula was given.
"""

from collections.abc import Iterator
from dataclasses import dataclass, fields, is_dataclass
from typing import Any

import numpy as np

from .design import Design
from .sheet.quantity import keys
from .sheet.trace import Line
from .solve import Results

SHORT = 64  # elements of an array that single numbers are taken from


@dataclass(frozen=True)
class Link:
    """One line of a chain and the inputs that enter it directly, as keys of the design file."""

    line: Line
    inputs: tuple[str, ...]


def chain(results: Results, value_id: str) -> list[Link]:
    """The lines that lead to a value, in the order in which they were computed; empty for a value taken straight from an input."""
    lines = [line for outcome in results.outcomes.values() for line in outcome.lines]
    made = {id(line.value): number for number, line in enumerate(lines)}
    equal = {line.value: number for number, line in enumerate(lines) if isinstance(line.value, (float, complex))}
    parts = list(_parts(lines))

    def maker(x: Any, before: int = len(lines)) -> int | None:
        """The line that made a number: the very object, or else the array that it is taken from."""
        number = made.get(id(x))
        if number is None and isinstance(x, (float, complex)) and not _common(x):
            number = equal.get(x, before)
            if number >= before:
                number = next((n for n, array in reversed(parts) if n < before and np.any(array == x)), None)
        return number if number is not None and number < before else None

    start = maker(results.values()[value_id].inside)
    inputs: dict[int, list[tuple[str, str]]] = {}
    for identity, origin_key, symbol in (*_inputs(results.design), *((number, key, "") for number, key in _named(results.design))):
        inputs.setdefault(identity, []).append((origin_key, symbol))
    columns = list(_columns(results.design))
    wanted: set[int] = set()
    todo = [] if start is None else [start]
    while todo:
        number = todo.pop()
        if number not in wanted:
            wanted.add(number)
            todo += [m for a in lines[number].arguments.values() if (m := maker(a, number)) is not None]

    counts = list(_counts(results.design))

    def origin(name: str, argument: Any) -> str | None:
        """The key of an argument that comes straight from the file; an array may be a column of an array of tables."""
        if isinstance(argument, np.ndarray):
            return next((key for key, column in columns if _is(argument, column)), None)
        if isinstance(argument, int):  # whole numbers are one object wherever they stand: their name tells them apart
            return next((key for key, names, number in counts if name in names and number == argument), None)
        found = inputs.get(id(argument), [])  # numbers that the program takes by default may be one object: the symbol tells them apart
        return next((key for key, symbol in found if symbol == name), found[0][0] if found else None)

    return [
        Link(line, tuple(key for name, a in line.arguments.items() if id(a) not in made and (key := origin(name, a))))
        for line in (lines[n] for n in sorted(wanted))
    ]


def _is(argument: Any, column: tuple[float, ...]) -> bool:
    """Whether an array is a column of the design, or begins with one that is long enough to be told apart."""
    if len(column) < 2 and not any(column):
        return False
    return np.array_equal(argument if len(column) < 3 else argument[: len(column)], column)


def _parts(lines: list[Line]) -> Iterator[tuple[int, Any]]:
    """The lines whose value is a short array, of which single numbers are taken on."""
    for number, line in enumerate(lines):
        if isinstance(line.value, np.ndarray) and line.value.ndim == 1 and line.value.size <= SHORT:
            yield number, line.value


def _common(x: complex) -> bool:
    """Whether a number is one that turns up anywhere: 0, 1, ½ …"""
    return abs(x - complex(round(x.real, 3), round(x.imag, 3))) < 1e-12


def _counts(design: Design) -> Iterator[tuple[str, tuple[str, ...], int]]:
    """Each whole number of the steps: its key, the names that it has in formulas, and itself."""
    for step in design.asked():
        inputs = getattr(design, step.key)
        for key in keys(_class(inputs)).values():
            if key.about.kind == "integer" and (number := getattr(inputs, key.attribute)) is not None:
                yield f"{step.key}.{key.key}", (key.about.symbol, key.attribute), number


def _columns(inputs: Any, prefix: str = "") -> Iterator[tuple[str, tuple[float, ...]]]:
    """Each number of an array of tables as a column: `countershaft.masses.*.mass_kg`."""
    for key in keys(_class(inputs)).values():
        content = getattr(inputs, key.attribute)
        here = f"{prefix}{key.key}"
        if is_dataclass(content):
            yield from _columns(content, f"{here}.")
        elif key.about.kind in ("series", "integers") and content:
            yield here, content
        elif key.about.kind == "tables" and content:
            for part in keys(_class(content[0])).values():
                if part.about.kind == "number":
                    yield f"{here}.*.{part.key}", tuple(getattr(item, part.attribute) for item in content)


def origin(results: Results, value_id: str) -> str | None:
    """The key of a value that is an input itself."""
    wanted = id(results.values()[value_id].inside)
    return next((key for number, key, _ in _inputs(results.design) if number == wanted), None)


def _named(design: Design) -> Iterator[tuple[int, str]]:
    """The numbers that a name brings in: an oil's, a material's."""
    oils, materials = design.oils, design.materials
    for step in design.asked():
        inputs = getattr(design, step.key)
        if step.key == "engine" and inputs.throw is not None and (steel := materials.get(inputs.throw.material)) is not None:
            yield id(steel.proof_stress), f"engine.throw.material ({steel.name})"
        for attribute in ("oil", "material", "housing_material"):
            name = getattr(inputs, attribute, None)
            known = oils.get(name) if attribute == "oil" else materials.get(name)  # type: ignore[arg-type]
            for f in fields(known) if known is not None else ():
                if isinstance(number := getattr(known, f.name), float):
                    yield id(number), f"{step.key}.{attribute} ({name})"


def _inputs(inputs: Any, prefix: str = "") -> Iterator[tuple[int, str, str]]:
    """The identity of every number of the design, its key and its symbol."""
    by_attribute = {key.attribute: key.key for key in keys(_class(inputs)).values()}
    symbols = {key.attribute: key.about.symbol for key in keys(_class(inputs)).values()}
    for f in fields(inputs):
        content = getattr(inputs, f.name)
        key = f"{prefix}.{by_attribute.get(f.name, f.name)}" if prefix else by_attribute.get(f.name, f.name)
        if is_dataclass(content):
            yield from _inputs(content, key)
        elif isinstance(content, tuple) and content and is_dataclass(content[0]):
            for i, part in enumerate(content):
                yield from _inputs(part, f"{key}.{getattr(part, 'name', i)}")
        elif isinstance(content, (float, tuple)) and content != ():
            yield id(content), key, symbols.get(f.name, "")
            if isinstance(content, tuple):
                yield from ((id(item), key, "") for item in content if isinstance(item, float))


def _class(inputs: Any) -> Any:
    return type(inputs)
