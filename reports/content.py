# SPDX-License-Identifier: Apache-2.0
"""What a block of a report says, beside how it is drawn: for whoever sets the same report elsewhere (`reports.docx.docx_file`).

A block without content goes on with the one before it, or only adorns the page.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from calc.sheet.expression import Shown

    from .setting.prose import Style


class Content:
    """Of any kind: one of those below, or the rows of a table."""


@dataclass(frozen=True, slots=True)
class Heading(Content):
    """`level`: 0 for the title of the whole, 1 for a chapter."""

    words: str
    level: int


@dataclass(frozen=True, slots=True)
class Words(Content):
    """A paragraph."""

    words: str
    style: Style
    bullet: bool = False


@dataclass(frozen=True, slots=True)
class Formula(Content):
    """A formula, and below it its numbers for each part, by the part's name; `more`: further values in words.

    `first`: the line that stands for all; None where the formula stood in the block before.
    """

    first: Shown | None
    lines: tuple[tuple[str, Shown], ...]
    more: str
    source: str


@dataclass(frozen=True, slots=True)
class Picture(Content):
    """What is drawn, with its captions; these stand at its lower end, as high as `below`."""

    captions: tuple[str, ...] = ()
    below: float = 0.0
