# SPDX-License-Identifier: Apache-2.0
"""The table of a sweep: one design a row; as CSV, as Parquet, or in memory.

It is written chunk by chunk, so that it may be larger than the memory."""

import csv
import errno
import hashlib
import json
import os
import time
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from importlib import import_module
from math import isfinite
from pathlib import Path
from typing import Any, Protocol, TextIO

from ...design.addresses import quantity_of
from ...design.disk import EVERY, lock, opened, read_file
from ...design.limits import CHUNK_BYTES, LOCK_SECONDS
from ...design.toml_file import Document
from ...sheet.errors import InputError, NoSolution
from ...sheet.extras import needs
from ...sheet.record import record, replace
from ...sheet.text import Text
from ...sheet.version import VERSION
from .inputs import Combination, SweepPlan, Varied

# --- one design of many, and many of them together as they are kept

Cell = float | str | None
NO_DESIGN = "bad_input"  # in place of a verdict


@record
class Solved:
    """`values`: number and unit by id; `verdicts` by step; `verdict`: the state of the design, or of the one step that
    is asked; `reason`: why it is no design, or which steps have no solution."""

    values: dict[str, tuple[float | None, str]]
    verdicts: dict[str, str]
    verdict: str
    reason: str = ""


@record
class SweepRow:
    """A design as it stands in the table, under the ids and steps of its chunk."""

    at: Combination
    cells: tuple[float | None, ...]
    verdicts: tuple[str | None, ...]
    verdict: str
    reason: str = ""


@record
class Chunk:
    """Designs that one process computes.  `units`: of the values by id; `steps`: those that have verdicts."""

    units: dict[str, str]
    steps: tuple[str, ...]
    rows: tuple[SweepRow, ...]


def chunk_of(grid: Sequence[Combination], solved: Iterable[Solved], wanted: Sequence[str]) -> Chunk:
    """Rows of all designs under the values that any of them has, or under those that are wanted."""
    designs = list(solved)
    units: dict[str, str] = {}
    steps: dict[str, None] = {}
    for design in designs:
        for id, (_, unit) in design.values.items():
            units.setdefault(id, unit)
        steps |= dict.fromkeys(design.verdicts)
    if wanted:
        units = {id: units[id] for id in wanted if id in units}
    rows = []
    for at, design in zip(grid, designs):
        numbers = [design.values.get(id, (None, ""))[0] for id in units]
        cells = tuple([x if x is not None and isfinite(x) else None for x in numbers])
        verdicts = tuple([design.verdicts.get(step) for step in steps])
        rows.append(SweepRow(at, cells, verdicts, design.verdict, design.reason))
    return Chunk(units, tuple(steps), tuple(rows))


def reason_of(errors: Iterable[InputError]) -> str:
    """All that is wrong with a combination, in one line."""
    return "; ".join(replace(error, line=0).text("").removeprefix(": ") for error in errors)


# --- where the chunks are until the table is written
# In memory, or in a folder, where they outlive a run that is killed.


class Store(Protocol):
    """Chunks by their numbers, from 0 on."""

    def has(self, n: int) -> bool: ...
    def keep(self, n: int, chunk: Chunk) -> None: ...
    def head(self, n: int) -> Chunk: ...
    def chunk(self, n: int) -> Chunk: ...
    def __len__(self) -> int: ...


class InMemory:
    """A store for as long as the program runs."""

    def __init__(self) -> None:
        self.chunks: dict[int, Chunk] = {}

    def has(self, n: int) -> bool:
        return n in self.chunks

    def keep(self, n: int, chunk: Chunk) -> None:
        self.chunks[n] = chunk

    def chunk(self, n: int) -> Chunk:
        return self.chunks[n]

    head = chunk

    def __len__(self) -> int:
        return len(self.chunks)


@record
class InFolder:
    """A file for each chunk, whole at every moment: what the chunk is of in its first line, a design in each line after
    it.

    `key`: what the chunks hold for; those of another sweep are left alone.
    """

    folder: Path
    key: str

    def _file(self, n: int) -> Path:
        return self.folder / f"{self.key}-{n}.jsonl"

    def draft(self) -> Path:
        """A file of this run alone, which `clear` takes away if it is killed."""
        return self.folder / f"{self.key}-{os.urandom(8).hex()}.new"

    def has(self, n: int) -> bool:
        """Whether the chunk is there and whole."""
        try:
            self.chunk(n)
        except (OSError, ValueError, LookupError, TypeError, AttributeError, RecursionError):
            return False
        return True

    def keep(self, n: int, chunk: Chunk) -> None:
        about = {"units": chunk.units, "steps": chunk.steps, "count": len(chunk.rows)}
        about["reasons"] = any(row.reason for row in chunk.rows)
        rows = [[row.at, row.cells, row.verdicts, row.verdict, row.reason] for row in chunk.rows]
        text = "\n".join(map(json.dumps, [about, *rows]))
        self.folder.mkdir(parents=True, exist_ok=True)
        draft = self.draft()
        with open(draft, "x", encoding="utf-8") as file:
            file.write(text)
        draft.replace(self._file(n))

    def head(self, n: int) -> Chunk:
        """The chunk without its designs, one that stands for those with a reason excepted."""
        with opened(self._file(n)) as file:
            about = json.loads(file.readline(CHUNK_BYTES))
        rows = (SweepRow((), (), (), NO_DESIGN, "some"),) if about["reasons"] else ()
        return Chunk(about["units"], tuple(about["steps"]), rows)

    def chunk(self, n: int) -> Chunk:
        first, *lines = read_file(self._file(n), CHUNK_BYTES).decode("utf-8").splitlines()
        about = json.loads(first)
        units, steps = dict(about["units"]), tuple(about["steps"])
        parts = map(json.loads, lines)
        rows = [SweepRow(tuple(at), tuple(cells), tuple(verdicts), *rest) for at, cells, verdicts, *rest in parts]
        if len(rows) != about["count"]:
            raise ValueError("is cut off")
        if any((len(row.cells), len(row.verdicts)) != (len(units), len(steps)) for row in rows):
            raise ValueError("has rows of other columns")
        return Chunk(units, steps, tuple(rows))

    def __len__(self) -> int:
        return sum(1 for _ in self.folder.glob(f"{self.key}-*.jsonl"))

    @contextmanager
    def shared(self) -> Iterator[None]:
        """The chunks stay while this run needs them, whichever run of the same sweep ends first: only the last one that
        is at them takes them away."""
        handle = self._at()
        try:
            yield
        finally:
            if handle is not None:
                os.close(handle)

    def _at(self) -> int | None:
        """The open file by which others see that a run is at these chunks; None where the system has no locks."""
        ends = time.monotonic() + LOCK_SECONDS
        while time.monotonic() < ends:
            self.folder.mkdir(parents=True, exist_ok=True)
            with suppress(FileNotFoundError):  # another takes the folder away
                handle = os.open(self._lock, os.O_RDWR | os.O_CREAT, 0o666)
                try:
                    if not lock(handle, shared=True):
                        os.close(handle)
                        return None
                    if os.path.samestat(os.fstat(handle), os.stat(self._lock)):
                        return handle
                except (BlockingIOError, FileNotFoundError):
                    time.sleep(EVERY)
                os.close(handle)
        raise TimeoutError(errno.ETIMEDOUT, Text("another run of this sweep takes its files away, and does not end"))

    @property
    def _lock(self) -> Path:
        return self.folder / f"{self.key}-lock"

    def clear(self) -> None:
        """Take away what is kept, once the table is written and no other run is at it."""
        with suppress(OSError):
            handle, alone = os.open(self._lock, os.O_RDWR | os.O_CREAT, 0o666), False
            try:
                alone = lock(handle)
                for file in self.folder.glob(f"{self.key}-*"):
                    if file != self._lock:
                        file.unlink()
                if alone:  # while it is held: who has opened it meanwhile sees that it is gone
                    self._lock.unlink()
            finally:
                os.close(handle)
            if not alone:
                self._lock.unlink()
            self.folder.rmdir()  # unless it has chunks of another sweep


SIZE = 48  # designs of a chunk, which a run that is ended begins again


def key_of(document: Document, plan: SweepPlan, step: str | None, wanted: tuple[str, ...]) -> str:
    """What kept chunks hold for: the values of the design, what is varied, what is asked, the program's version
    and how many designs a chunk has."""
    what = [
        VERSION,
        SIZE,
        document.data,
        vars(plan) | {"inputs": [vars(varied) for varied in plan.inputs]},
        step,
        wanted,
    ]
    return hashlib.sha256(json.dumps(what, sort_keys=True, default=str).encode()).hexdigest()[:16]


# --- the table

REASON = "reason"


@record
class Swept:
    """`header` of the columns and the rows under it: inputs that were varied, values in shown units, verdicts.  None:
    no such value."""

    header: tuple[str, ...]
    rows: list[list[Cell]]
    verdicts: list[str]

    def write(self, file: TextIO) -> None:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(self.header)
        writer.writerows(self.rows)


@record
class SweepColumns:
    """The columns of all chunks together.  `words`: the varied inputs that are words."""

    keys: tuple[str, ...]
    words: frozenset[str]
    units: dict[str, str]
    steps: tuple[str, ...]
    reasons: bool

    @property
    def header(self) -> tuple[str, ...]:
        named = (f"{id} [{unit}]" if unit else id for id, unit in self.units.items())
        return (*self.keys, *named, *(f"verdict.{step}" for step in self.steps), *([REASON] if self.reasons else []))

    def lines(self, chunk: Chunk) -> Iterator[list[Cell]]:
        """The designs of a chunk under these columns."""
        cells, verdicts = _places(self.units, chunk.units), _places(self.steps, chunk.steps)
        for row in chunk.rows:
            values = [None if n is None else row.cells[n] for n in cells]
            judged = [None if n is None else row.verdicts[n] for n in verdicts]
            yield [*row.at, *values, *judged, *([row.reason or None] if self.reasons else [])]


def _places(wanted: Sequence[str] | dict[str, str], there: Sequence[str] | dict[str, str]) -> list[int | None]:
    place = {name: n for n, name in enumerate(there)}
    return [place.get(name) for name in wanted]


def columns(document: Document, inputs: Sequence[Varied], store: Store) -> SweepColumns:
    """In the order in which the chunks bring them."""
    units: dict[str, str] = {}
    steps: dict[str, None] = {}
    reasons = False
    for n in range(len(store)):
        head = store.head(n)
        for id, unit in head.units.items():
            units.setdefault(id, unit)
        steps |= dict.fromkeys(head.steps)
        reasons = reasons or any(row.reason for row in head.rows)
    keys = tuple(varied.key for varied in inputs)
    words = frozenset(key for key in keys if quantity_of(document.data, key).kind in ("text", "choice", "date"))
    return SweepColumns(keys, words, units, tuple(steps), reasons)


def in_memory(document: Document, inputs: Sequence[Varied], store: Store) -> Swept:
    table_columns = columns(document, inputs, store)
    chunks = [store.chunk(n) for n in range(len(store))]
    lines = [line for chunk in chunks for line in table_columns.lines(chunk)]
    return Swept(table_columns.header, lines, [row.verdict for chunk in chunks for row in chunk.rows])


def write_csv(file: TextIO, document: Document, inputs: Sequence[Varied], store: Store) -> Counter[str]:
    """The table as CSV; gives how many designs have which verdict."""
    table_columns, counts = columns(document, inputs, store), Counter[str]()
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(table_columns.header)
    for n in range(len(store)):
        chunk = store.chunk(n)
        writer.writerows(table_columns.lines(chunk))
        counts.update(row.verdict for row in chunk.rows)
    return counts


def parquet() -> Any:
    """pyarrow, which an extra installs.  Raises NoSolution."""
    try:
        return import_module("pyarrow"), import_module("pyarrow.parquet")
    except ImportError:
        raise NoSolution(Text("a Parquet file {needs}", needs=needs("parquet"))) from None


def write_parquet(path: Path, document: Document, inputs: Sequence[Varied], store: Store) -> Counter[str]:
    """The same table as Parquet: numbers as doubles, a group of rows for each chunk."""
    arrow, files = parquet()
    table_columns, counts = columns(document, inputs, store), Counter[str]()
    texts = len(table_columns.header) - len(table_columns.steps) - table_columns.reasons
    kinds = [
        arrow.string() if name in table_columns.words or n >= texts else arrow.float64()
        for n, name in enumerate(table_columns.header)
    ]
    schema = arrow.schema(list(zip(table_columns.header, kinds)))
    with files.ParquetWriter(path, schema) as writer:
        for n in range(len(store)):
            chunk = store.chunk(n)
            by_column = zip(*table_columns.lines(chunk))
            arrays = [arrow.array(column, kind, from_pandas=False) for column, kind in zip(by_column, kinds)]
            writer.write_table(arrow.Table.from_arrays(arrays, schema=schema))
            counts.update(row.verdict for row in chunk.rows)
    return counts
