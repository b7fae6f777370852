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


@dataclass(frozen=True)
class Link:
    """One line of a chain and the inputs that enter it directly, as keys of the design file."""

    line: Line
    inputs: tuple[str, ...]


def chain(results: Results, value_id: str) -> list[Link]:
    """The lines that lead to a value, in the order in which they were computed; empty for a value taken straight from an input."""
    lines = [line for outcome in results.outcomes.values() for line in outcome.lines]
    made = {id(line.value): number for number, line in enumerate(lines)}
    start = made.get(id(results.values()[value_id].inside))
    inputs = dict(_inputs(results.design)) | dict(_named(results.design))
    columns = list(_columns(results.design))
    wanted: set[int] = set()
    todo = [] if start is None else [start]
    while todo:
        number = todo.pop()
        if number not in wanted:
            wanted.add(number)
            todo += [made[id(a)] for a in lines[number].arguments.values() if made.get(id(a), number) < number]

    def origin(argument: Any) -> str | None:
        """The key of an argument that comes straight from the file; an array may be a column of an array of tables."""
        if isinstance(argument, np.ndarray):
            return next((key for key, column in columns if np.array_equal(argument, column)), None)
        return inputs.get(id(argument))

    return [
        Link(lines[n], tuple(key for a in lines[n].arguments.values() if id(a) not in made and (key := origin(a)))) for n in sorted(wanted)
    ]


def _columns(inputs: Any, prefix: str = "") -> Iterator[tuple[str, tuple[float, ...]]]:
    """Each number of an array of tables as a column: `countershaft.masses.*.mass_kg`."""
    for key in keys(_class(inputs)).values():
        content = getattr(inputs, key.attribute)
        here = f"{prefix}{key.key}"
        if is_dataclass(content):
            yield from _columns(content, f"{here}.")
        elif key.about.kind == "tables" and content:
            for part in keys(_class(content[0])).values():
                if part.about.kind == "number":
                    yield f"{here}.*.{part.key}", tuple(getattr(item, part.attribute) for item in content)


def origin(results: Results, value_id: str) -> str | None:
    """The key of a value that is an input itself."""
    return dict(_inputs(results.design)).get(id(results.values()[value_id].inside))


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


def _inputs(inputs: Any, prefix: str = "") -> Iterator[tuple[int, str]]:
    """The identity of every number of the design and its key."""
    by_attribute = {key.attribute: key.key for key in keys(_class(inputs)).values()}
    for f in fields(inputs):
        content = getattr(inputs, f.name)
        key = f"{prefix}.{by_attribute.get(f.name, f.name)}" if prefix else by_attribute.get(f.name, f.name)
        if is_dataclass(content):
            yield from _inputs(content, key)
        elif isinstance(content, tuple) and content and is_dataclass(content[0]):
            for i, part in enumerate(content):
                yield from _inputs(part, f"{key}.{getattr(part, 'name', i)}")
        elif isinstance(content, (float, tuple)) and content != ():
            yield id(content), key
            if isinstance(content, tuple):
                yield from ((id(item), key) for item in content)


def _class(inputs: Any) -> Any:
    return type(inputs)
