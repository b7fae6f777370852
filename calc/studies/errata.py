# SPDX-License-Identifier: Apache-2.0
"""What is wrong in the documents that this program grew out of: tables/errata.toml, with the right values computed."""

import math
import tomllib
from collections.abc import Iterator
from functools import cache

from ..design.toml_file import design, read
from ..library.catalogue import TABLES
from ..sheet.number import short
from ..sheet.record import record
from ..sheet.text import with_unit
from ..solve import Results, solve
from .shipped import DESIGNS

DIGITS = 4  # of a right number: as many as the documents print


@record
class Misprint:
    """One error of a source.  `design` and `value`: where this program has the right number; `sum`: arithmetic that
    shows it."""

    source: str
    place: str  # section, equation, table or figure
    lines: str  # of the document's plain text
    about: str
    printed: str
    right: str
    why: str
    design: str = ""
    value: str = ""
    sum: str = ""

    @property
    def command(self) -> str:
        """What a reader types to see the right number worked out; empty where the source itself shows the error."""
        return f"contralbero explain designs/{self.design} {self.value}" if self.value else ""


def documents() -> dict[str, str]:
    """The documents by the short names of the register, each with what it is."""
    return {name: about["title"] for name, about in _tables()[0].items()}


def misprints(source: str = "") -> Iterator[Misprint]:
    """All that is known to be wrong, or what is wrong in one document."""
    for row in _tables()[1]:
        if not source or row["source"] == source:
            yield _misprint(**row)


def _misprint(
    source: str,
    place: str,
    lines: str,
    about: str,
    printed: str,
    why: str,
    right: str = "",
    design: str = "",
    value: str = "",
    sum: str = "",
    unit: str = "",
) -> Misprint:
    numbers = {}
    if sum:
        numbers["sum"] = with_unit(short(worked_out(sum), DIGITS), unit)
    if value:
        found = _solved(design).values()[value]
        numbers["value"] = with_unit(short(found.shown, DIGITS), found.unit)
    right = (right or ("{value}" if value else "{sum}")).format_map(numbers)
    return Misprint(source, place, lines, about, printed.format_map(numbers), right, why, design, value, sum)


def worked_out(arithmetic: str) -> float:
    """The value of a row's `sum`.  The table is part of the program, so it may be evaluated; it knows `math` and
    nothing else."""
    return float(eval(arithmetic, {"__builtins__": {}}, vars(math)))


@cache
def _tables() -> tuple[dict[str, dict[str, str]], list[dict[str, str]]]:
    """What is said of each document, and the rows."""
    data = tomllib.loads((TABLES / "errata.toml").read_text(encoding="utf-8"))
    return data["source"], data["row"]


@cache
def _solved(name: str) -> Results:
    return solve(design(read(DESIGNS / name)))
