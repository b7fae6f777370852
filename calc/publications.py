# SPDX-License-Identifier: Apache-2.0
"""The register of publications: the short names by which sources cite them, and what they are."""

import re
import tomllib
from functools import cache
from pathlib import Path

TABLE = Path(__file__).parent / "tables" / "publications.toml"


@cache
def _known() -> dict[str, str]:
    known: dict[str, str] = tomllib.loads(TABLE.read_text(encoding="utf-8"))["full"]
    return known


def full(name: str) -> str:
    """Author, title and place of a publication, or the title of a standard whatever its year; empty where it is not listed."""
    return _known().get(name) or _known().get(name.partition(":")[0], "")


def cited(source: str) -> str:
    """The publication of the register that a source names first, with the year of a standard if it gives one; empty where it names none."""
    name = _names().search(source)
    return name[0] if name is not None else ""


@cache
def _names() -> re.Pattern[str]:
    """Any of the short names, as a whole: "ISO 1" does not stand in "ISO 1328-1"."""
    names = "|".join(re.escape(name) for name in sorted(_known(), key=len, reverse=True))
    return re.compile(rf"(?<![\w-])(?:{names})(?::\d{{4}})?(?![\w-])")
