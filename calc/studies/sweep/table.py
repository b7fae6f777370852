# SPDX-License-Identifier: Apache-2.0
"""The table of a sweep: as CSV, as Parquet, or in memory; written chunk by chunk, so that it may be larger than the memory."""

import csv
from collections import Counter
from collections.abc import Iterator, Sequence
from importlib import import_module
from pathlib import Path
from typing import Any, TextIO

from ...design.addresses import quantity_of
from ...design.toml_file import Document
from ...sheet.check import worst
from ...sheet.errors import NoSolution
from ...sheet.record import record
from ...sheet.text import Text
from .inputs import Varied
from ...sweep.kept import Store
from ...sweep.row import Cell, Chunk, Row

REASON = "reason"
NO_DESIGN = "bad_input"  # in place of a verdict


@record
class Swept:
    """`header` of the columns and the rows under it: inputs that were varied, values in shown units, verdicts.  None: no such value."""

    header: tuple[str, ...]
    rows: list[list[Cell]]
    verdicts: list[str]

    def write(self, file: TextIO) -> None:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(self.header)
        writer.writerows(self.rows)


@record
class Columns:
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

    def lines(self, one: Chunk) -> Iterator[list[Cell]]:
        """The designs of a chunk under these columns."""
        cells, verdicts = _places(self.units, one.units), _places(self.steps, one.steps)
        for row in one.rows:
            values = [None if n is None else row.cells[n] for n in cells]
            judged = [None if n is None else row.verdicts[n] for n in verdicts]
            yield [*row.at, *values, *judged, *([row.reason or None] if self.reasons else [])]


def _places(wanted: Sequence[str] | dict[str, str], there: Sequence[str] | dict[str, str]) -> list[int | None]:
    place = {name: n for n, name in enumerate(there)}
    return [place.get(name) for name in wanted]


def columns(document: Document, inputs: Sequence[Varied], store: Store) -> Columns:
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
    keys = tuple(one.key for one in inputs)
    words = frozenset(key for key in keys if quantity_of(document.data, key).kind in ("text", "choice", "date"))
    return Columns(keys, words, units, tuple(steps), reasons)


def verdict_of(row: Row) -> str:
    """The worst of its steps; of what is no design that it is none."""
    judged = [verdict for verdict in row.verdicts if verdict is not None]
    return worst(judged) if judged else NO_DESIGN


def in_memory(document: Document, inputs: Sequence[Varied], store: Store) -> Swept:
    found = columns(document, inputs, store)
    chunks = [store.chunk(n) for n in range(len(store))]
    lines = [line for one in chunks for line in found.lines(one)]
    return Swept(found.header, lines, [verdict_of(row) for one in chunks for row in one.rows])


def write_csv(file: TextIO, document: Document, inputs: Sequence[Varied], store: Store) -> Counter[str]:
    """The table as CSV; gives how many designs have which verdict."""
    found, counts = columns(document, inputs, store), Counter[str]()
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(found.header)
    for n in range(len(store)):
        one = store.chunk(n)
        writer.writerows(found.lines(one))
        counts.update(map(verdict_of, one.rows))
    return counts


def parquet() -> Any:
    """pyarrow, which an extra installs.  Raises NoSolution."""
    try:
        return import_module("pyarrow"), import_module("pyarrow.parquet")
    except ImportError:
        raise NoSolution(Text("a Parquet file needs pyarrow, which the extra `contralbero[parquet]` installs")) from None


def write_parquet(path: Path, document: Document, inputs: Sequence[Varied], store: Store) -> Counter[str]:
    """The same table as Parquet: numbers as doubles, a group of rows for each chunk."""
    arrow, files = parquet()
    found, counts = columns(document, inputs, store), Counter[str]()
    texts = len(found.header) - len(found.steps) - found.reasons
    kinds = [arrow.string() if name in found.words or n >= texts else arrow.float64() for n, name in enumerate(found.header)]
    schema = arrow.schema(list(zip(found.header, kinds)))
    with files.ParquetWriter(path, schema) as writer:
        for n in range(len(store)):
            one = store.chunk(n)
            by_column = zip(*found.lines(one))
            arrays = [arrow.array(column, kind, from_pandas=False) for column, kind in zip(by_column, kinds)]
            writer.write_table(arrow.Table.from_arrays(arrays, schema=schema))
            counts.update(map(verdict_of, one.rows))
    return counts
