# SPDX-License-Identifier: Apache-2.0
"""The kinds of bearings, by the word of a row's `kind`: KIND of the module `kind` in the room of that word."""

from importlib import import_module
from typing import Any

from ..countershaft.rows import ROWS
from .support import Kind

KINDS: dict[str, Kind[Any]] = {word: import_module(f".{word}.kind", __package__).KIND for word in ROWS}
