# SPDX-License-Identifier: Apache-2.0
"""The files of [[measurements]]: beside the design or below its folder, and nowhere else, whatever a name or a link
says."""

import errno
import os
from collections.abc import Iterable, Mapping
from functools import lru_cache
from pathlib import Path

from ..measurements.inputs import BYTES, Condition, Measurement, file_problem
from ..measurements.reading import RunFile, Unread, read_run
from ..measurements.rows import RunRows, rows_of
from ..sheet.inputs_at import content_at
from ..sheet.quantity import dotted
from ..sheet.text import Amount, Text
from .disk import read_file
from .model import Design

KEPT = 8  # files, read once while they do not change


def read_runs(
    design: Design, folder: Path, files: Mapping[str, bytes]
) -> tuple[tuple[RunRows, ...], Iterable[tuple[str, Text]]]:
    """The runs of a design, and what is wrong with them, by key.

    `folder`: of the design; `files`: what stands for them, by the names of runs, as a report has them
    inside, or of files."""
    found: list[RunRows] = []
    problems: list[tuple[str, Text]] = []
    for n, run in enumerate(design.measurements):
        if file_problem(run.file) is not None:
            continue  # said already
        here = dotted(Design.measurements, n)
        try:
            kept, file = _file(run, folder, files)
        except Unread as why:
            problems.append((dotted(here, Measurement.file), why.text))
            continue
        rows, wrong = _rows(design, run, kept, file)
        problems += [(dotted(here, key), reason) for key, reason in wrong]
        if rows is not None:
            found.append(rows)
            problems += [(dotted(here, key), reason) for key, reason in _beyond(design, run, rows)]
    return tuple(found), problems


_Found = tuple[RunRows | None, list[tuple[str, Text]]]
_known: dict[str, tuple[tuple[Measurement, dict[str, str]], RunFile, _Found]] = {}


def _rows(design: Design, run: Measurement, kept: bytes, file: RunFile) -> _Found:
    """The rows of a run, made once for all designs that say the same of the same file, and in which its conditions have
    the same units: one that lacks such an input has none."""
    says = run, {condition.key: _unit(design, condition.key) for condition in run.conditions}
    before, of, found = _known.get(run.name, (None, None, (None, [])))
    if before == says and of is file:
        return found
    found = rows_of(run, file, lambda key: says[1][key], kept)
    if len(_known) >= KEPT:
        _known.clear()
    _known[run.name] = says, file, found
    return found


def _unit(design: Design, key: str) -> str:
    about = content_at(design, key)[1]
    return about.unit if about is not None else ""


def _beyond(design: Design, run: Measurement, rows: RunRows) -> Iterable[tuple[str, Text]]:
    """Conditions that the input can not have."""
    for i, condition in enumerate(run.conditions):
        about = content_at(design, condition.key)[1]
        for number in (min(rows.conditions[condition.key]), max(rows.conditions[condition.key])):
            if about is not None and not about.allows(shown := about.units.shown(number)):
                beyond = Text(
                    "{file} has {number}; {key} must be {allowed}",
                    file=run.file,
                    number=Amount(shown, about.unit),
                    key=condition.key,
                    allowed=about.allowed(),
                )
                yield dotted(Measurement.conditions, i, Condition.column), beyond
                break


def _file(run: Measurement, folder: Path, files: Mapping[str, bytes]) -> tuple[bytes, RunFile]:
    """Its rows, and the bytes that a report has kept of it: of those alone it is believed what file they were of."""
    name = run.file
    if (raw := files.get(run.name, files.get(name))) is not None:
        return raw, read_run(raw, ".csv")
    path = os.path.realpath(folder / name)
    inside = os.path.realpath(folder)
    if os.path.commonpath([path, inside]) != inside:
        raise Unread(Text("leads out of the folder of the design by a link; put the file beside the design"))
    try:
        about = os.stat(path)
        return b"", _read(path, Path(name).suffix.lower(), about.st_mtime_ns, about.st_size)
    except OSError as error:
        raise Unread(_not_read(error, folder)) from None


@lru_cache(KEPT)
def _read(path: str, ending: str, changed: int, size: int) -> RunFile:
    """`changed`, `size`: by which it is told whether it is still the same."""
    return read_run(read_file(path, BYTES), ending)


def _not_read(error: OSError, folder: Path) -> Text:
    where = str(folder) if folder.name else folder.resolve().name or str(folder.resolve())  # "." says nothing
    if error.errno == errno.ENOENT:
        return Text("is not there; it is looked for in {folder}", folder=where)
    return Text("cannot be read in {folder}: {why}", folder=where, why=error.strerror or str(error))
