# SPDX-License-Identifier: Apache-2.0
"""Where the chunks of a sweep are until the table is written: in memory, or in a folder, where they outlive a run that is killed."""

import hashlib
import json
from contextlib import suppress
from pathlib import Path
from typing import Protocol

from ..design.toml_file import Document
from ..sheet.record import record
from ..version import VERSION
from .plan import Plan
from .row import Chunk, Row


class Store(Protocol):
    """Chunks by their numbers, from 0 on."""

    def has(self, n: int) -> bool: ...
    def keep(self, n: int, one: Chunk) -> None: ...
    def head(self, n: int) -> Chunk: ...
    def chunk(self, n: int) -> Chunk: ...
    def __len__(self) -> int: ...


class InMemory:
    """A store for as long as the program runs."""

    def __init__(self) -> None:
        self.chunks: dict[int, Chunk] = {}

    def has(self, n: int) -> bool:
        return n in self.chunks

    def keep(self, n: int, one: Chunk) -> None:
        self.chunks[n] = one

    def chunk(self, n: int) -> Chunk:
        return self.chunks[n]

    head = chunk

    def __len__(self) -> int:
        return len(self.chunks)


@record
class InFolder:
    """A file for each chunk, whole at every moment: what the chunk is of in its first line, a design in each line after it.

    `key`: what the chunks hold for; those of another sweep are left alone.
    """

    folder: Path
    key: str

    def _file(self, n: int) -> Path:
        return self.folder / f"{self.key}-{n}.jsonl"

    def has(self, n: int) -> bool:
        """Whether the chunk is there and whole."""
        try:
            self.chunk(n)
        except (OSError, ValueError, KeyError, TypeError):
            return False
        return True

    def keep(self, n: int, one: Chunk) -> None:
        lines = [{"units": one.units, "steps": one.steps, "count": len(one.rows), "reasons": any(row.reason for row in one.rows)}]
        text = "\n".join(map(json.dumps, [*lines, *([row.at, row.cells, row.verdicts, row.reason] for row in one.rows)]))
        self.folder.mkdir(parents=True, exist_ok=True)
        draft = self._file(n).with_suffix(".new")
        draft.write_text(text, encoding="utf-8")
        draft.replace(self._file(n))

    def head(self, n: int) -> Chunk:
        """The chunk without its designs, one that stands for those with a reason excepted."""
        with open(self._file(n), encoding="utf-8") as file:
            about = json.loads(file.readline())
        rows = (Row((), (), (), "some"),) if about["reasons"] else ()
        return Chunk(about["units"], tuple(about["steps"]), rows)

    def chunk(self, n: int) -> Chunk:
        first, *rest = self._file(n).read_text(encoding="utf-8").splitlines()
        about = json.loads(first)
        rows = tuple([Row(tuple(at), tuple(cells), tuple(verdicts), reason) for at, cells, verdicts, reason in map(json.loads, rest)])
        if len(rows) != about["count"]:
            raise ValueError("is cut off")
        return Chunk(about["units"], tuple(about["steps"]), rows)

    def __len__(self) -> int:
        return sum(1 for _ in self.folder.glob(f"{self.key}-*.jsonl"))

    def clear(self) -> None:
        """Take away what is kept, once the table is written."""
        with suppress(OSError):
            for file in self.folder.glob(f"{self.key}-*"):
                file.unlink()
            self.folder.rmdir()  # unless it has chunks of another sweep


def key_of(document: Document, plan: Plan, step: str | None, wanted: tuple[str, ...]) -> str:
    """What kept chunks hold for: the values of the design, what is varied, what is asked, the program's version."""
    what = [VERSION, document.data, vars(plan) | {"inputs": [vars(one) for one in plan.inputs]}, step, wanted]
    return hashlib.sha256(json.dumps(what, sort_keys=True, default=str).encode()).hexdigest()[:16]
