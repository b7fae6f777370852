# SPDX-License-Identifier: Apache-2.0
"""The tables that come with the program, read from their files; a mistake in one is told with its line and its key.

A row is called by its place in the file (`row.3`, `company.clamps.0`), as its keys are in a design."""

import re
import tomllib
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import Any, NoReturn

from ..sheet.errors import BadTable, InputError
from ..sheet.text import Text
from ..sheet.toml_scan import key_lines

TABLES = Path(__file__).parent / "tables"
Mistake = tuple[str, str, Text]  # the place of a key in the file, what stands there, and what is allowed


class TableRow(dict[str, Any]):  # Any: what a TOML file holds
    """A table of a file.  A key that is asked for and does not stand there is a mistake of the file."""

    def __init__(self, content: Mapping[str, Any], file: str, place: str = "") -> None:
        inside = place and f"{place}."
        super().__init__({key: _rows(value, file, inside + key) for key, value in content.items()})
        self.file, self.place = file, place

    def __missing__(self, key: str) -> NoReturn:
        stands = Text("is missing; what stands here is {keys}", keys=", ".join(self))
        raise bad_table(self.file, [(f"{self.place}.{key}" if self.place else key, "", stands)])


def _rows(value: Any, file: str, place: str) -> Any:
    if isinstance(value, dict):
        return TableRow(value, file, place)
    if isinstance(value, list):
        return [_rows(item, file, f"{place}.{n}") for n, item in enumerate(value)]
    return value


def text_of_table(file: str) -> str:
    return (TABLES / file).read_text(encoding="utf-8")


@cache
def house_table(file: str) -> TableRow:
    """The whole of a file."""
    return TableRow(parsed(file, text_of_table(file)), file)


def parsed(file: str, text: str) -> dict[str, Any]:
    """The TOML of a file, or of a part of it.  Raises BadTable."""
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        try:
            tomllib.loads(text_of_table(file))  # in which the line can be told
        except tomllib.TOMLDecodeError as error:
            at = re.search(r"at line (\d+)", str(error))
            reason = Text("is not TOML: {reason}", reason=str(error))
            raise BadTable(str(TABLES / file), [InputError(int(at[1]) if at else 0, "", "", reason)]) from None
        raise


def bad_table(file: str, mistakes: Iterable[Mistake]) -> BadTable:
    """What is said of mistakes in a file, each with the line of its key, or of the nearest table around it."""
    lines = key_lines(text_of_table(file))
    errors = []
    for place, value, reason in mistakes:
        stands = place
        while stands and stands not in lines:
            stands = stands.rpartition(".")[0]
        errors.append(InputError(lines.get(stands, 0), place, value, reason))
    return BadTable(str(TABLES / file), errors)
