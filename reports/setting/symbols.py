# SPDX-License-Identifier: Apache-2.0
"""A symbol of a chapter, and the name under which its pages are found among all that is indexed."""

from dataclasses import dataclass

SIGN = "§"  # what the name of a symbol begins with; no value is called so
BETWEEN = "\n"  # several names of one block


@dataclass(frozen=True, slots=True)
class Symbol:
    """What a symbol stands for in a chapter."""

    chapter: str  # key of the step
    name: str
    meaning: str
    unit: str

    @property
    def indexed(self) -> str:
        return f"{SIGN}{self.chapter}{SIGN}{self.name}"
