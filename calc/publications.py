# SPDX-License-Identifier: Apache-2.0
"""What the publications are that the sources name in short."""

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
