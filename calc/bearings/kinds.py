# SPDX-License-Identifier: Apache-2.0
"""The kinds of bearings, by the word of a row's `kind`: KIND of the module `kind` in the room of that word.

A room is loaded when a design has such a bearing."""

from collections.abc import Iterator, Mapping
from functools import cache
from importlib import import_module
from typing import Any

from ..countershaft.rows import ROWS
from .support import Kind


@cache
def _kind(word: str) -> Kind[Any]:
    kind: Kind[Any] = import_module(f".{word}.kind", __package__).KIND
    return kind


class _Kinds(Mapping[str, Kind[Any]]):
    def __getitem__(self, word: str) -> Kind[Any]:
        return _kind(word)

    def __iter__(self) -> Iterator[str]:
        return iter(ROWS)

    def __len__(self) -> int:
        return len(ROWS)


KINDS: Mapping[str, Kind[Any]] = _Kinds()
