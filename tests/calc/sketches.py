# SPDX-License-Identifier: Apache-2.0
"""What is asked of every step's sketch: finite, and lit by fields that there are."""

import math
from collections.abc import Iterator

from calc.design.addresses import address
from calc.design.toml_file import Document, design
from calc.draw.drawing import Mark, Sketch, Words


def marks(sketch: Sketch) -> Iterator[Mark]:
    for picture in (sketch, *sketch.beside):
        yield from picture.primitives


def words(sketch: Sketch) -> list[str]:
    return [str(mark.text) for mark in marks(sketch) if isinstance(mark, Words)]


def lit(sketch: Sketch, key: str) -> list[Mark]:
    return [mark for mark in marks(sketch) if any(key == one or key.startswith(f"{one}.") for one in mark.key.split())]


def failing(sketch: Sketch) -> set[str]:
    return {mark.key for mark in marks(sketch) if mark.state == "fail"}


def check(sketch: Sketch, document: Document) -> None:
    """Raises BadInput at a key that is of no field."""
    assert sketch.primitives
    for picture in (sketch, *sketch.beside):
        assert all(map(math.isfinite, picture.box))
    asked = design(document)
    for key in {key for mark in marks(sketch) for words in mark.key.split() for key in asked.in_place(words)}:
        address(document.data, key, whole=True)
