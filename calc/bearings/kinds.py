# SPDX-License-Identifier: Apache-2.0
"""The kinds of bearings, by the word of a row's `kind`."""

from typing import Any

from .plain.kind import Plain

# from .rolling.kind import Rolling
from .rolling.kind import Rolling
from .support import Kind

KINDS: dict[str, Kind[Any]] = {"plain": Plain(), "rolling": Rolling()}
