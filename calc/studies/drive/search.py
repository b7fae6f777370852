# SPDX-License-Identifier: Apache-2.0
"""The whole search: every class, over processes where asked, their fronts joined, and rows solved whole until enough of
them stand for all.

A class is the unit of work: it keeps no state, gives the same rows wherever it runs, and its result may be kept in a
file, so that a run that was ended goes on where it stood.  Whatever the order in which classes come back, what is
offered depends on the problem alone."""

import hashlib
import json
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np

from ...design.disk import read_file, write_file
from ...design.limits import PART_BYTES
from ...design.step_inputs import shaft_gear
from ...design.toml_file import Document, design
from ...gears.result import TrainResult
from ...library.tolerances import parse
from ...sheet.arrays import Array
from ...sheet.errors import NoSolution
from ...sheet.record import record
from ...sheet.text import EMPTY, Text
from ...sheet.version import VERSION
from ...solve import Results, solve
from ..processes import spread
from .classes import ClassFront, NotClosed, class_of, sized
from .combinations import DriveRows, joined, no_rows
from .front import front, representatives
from .problem import FITS, Problem, searched
from .problem import problem as problem_of
from .solved_drive import Sized, Whole, whole

NEIGHBOURS = 3  # of a row that fails when it is solved whole, are tried in its place
NEAR = 16  # rows among which the neighbours of one are looked for
FIRST = 4  # rows that are solved whole to find a first drive that passes
HOPELESS = 6  # rows that fail whole by one and the same check: nothing that is varied moves it
# classes that are done, what they have given together, and the last one's name
Told = Callable[[int, "FrontTable", str], None]


@record
class FrontTable:
    """The front of all classes on arrays, from which whole solutions are chosen.  `objectives`: a column each, to be as
    small as can be."""

    rows: DriveRows
    of: Array  # the class of each row
    objectives: Array
    combinations: int
    refused: tuple[tuple[int, Text], ...]  # classes without rows, and why

    def __len__(self) -> int:
        return len(self.rows)


@record
class FrontFound:
    """`drives`: those that pass, solved whole, least power first; `dropped`: rows that did not.  `done`: of the
    classes.

    `proved`: whether the front is that of every combination; else it is what a search came to."""

    problem: Problem
    table: FrontTable
    drives: tuple[Whole, ...]
    dropped: tuple[Whole, ...]
    done: int
    proved: bool = True

    @property
    def whole(self) -> bool:
        return self.done == len(self.problem.classes)


def asked(document: Document, overrides: dict[str, object]) -> tuple[Problem, Results]:
    """The problem of a design, and the design solved as it is."""
    base = design(document)
    searched(document, base, overrides)  # which it is, is said before anything is solved
    results = solve(base)
    return asked_of(document, results, overrides), results


def asked_of(document: Document, results: Results, overrides: Mapping[str, object] = {}) -> Problem:
    """The same of a design that is solved already."""
    name = searched(document, results.design, overrides)
    gear = shaft_gear(results.design, results.result(TrainResult), name)
    return problem_of(document, gear.tip_diameter * 1e3 if gear is not None else None, overrides, name)


# --- the classes


def one_class(problem: Problem, n: int) -> ClassFront:
    """One class; why it has no rows where its loads or its envelope have no solution."""
    try:
        return class_of(problem, problem.classes[n])
    except NotClosed:
        raise
    except NoSolution as none:
        return ClassFront(no_rows(), 0, (0.0, 1.0), why=none.text)


def classes(
    problem: Problem,
    processes: int = 1,
    parts: Path | None = None,
    scheduler: str = "",
    pulse: Callable[[], None] | None = None,
) -> Iterator[tuple[int, ClassFront]]:
    """Every class as it is done.  `parts`: a folder in which results are kept and looked for; `scheduler`: address of a
    dask one; `pulse`: called while processes are waited for."""
    waiting = []
    for n in promising(problem):
        if (known := _kept(problem, n, parts)) is not None:
            yield n, known
        else:
            waiting.append(n)
    for n, class_front in spread(partial(one_class, problem), int, waiting, processes, scheduler, pulse):
        _keep(problem, n, class_front, parts)
        yield n, class_front


def promising(problem: Problem) -> list[int]:
    """The numbers of the classes, those of the closest fits first: if any of them passes, these do."""
    grades = [sum(parse(fit).grade for fit in choices[FITS]) for choices in problem.classes]
    return sorted(range(len(grades)), key=lambda n: grades[n])


# --- what is kept


def key(problem: Problem) -> str:
    """What a kept result holds for: the values of the design, what is varied, the program's version."""
    what = [
        VERSION,
        problem.start.data,
        problem.sizes,
        problem.choices,
        problem.surfaces,
        problem.margins,
        problem.limits,
        problem.waived,
        problem.cycle,
    ]
    return hashlib.sha256(json.dumps(what, sort_keys=True, default=str).encode()).hexdigest()[:16]


def _kept(problem: Problem, n: int, parts: Path | None) -> ClassFront | None:
    """A result that is whole and of this problem; None: it is to be done."""
    if parts is None:
        return None
    try:
        raw = read_file(parts / f"{key(problem)}-{n}.npz", PART_BYTES)
        with np.load(BytesIO(raw), allow_pickle=False) as file:
            if sum(part.file_size for part in file.zip.infolist()) > PART_BYTES:
                return None  # packed by somebody else
            rows = DriveRows(**{name: file[name] for name in DriveRows.__dataclass_fields__})
            if len({len(column) for column in vars(rows).values()}) != 1:
                return None
            count, c, a, wheels = (float(x) for x in file["about"])
            return ClassFront(
                rows, int(count), (c, a), wheels, Text("{why}", why=str(file["why"])) if str(file["why"]) else EMPTY
            )
    except Exception:
        # a file that was cut off or written over, in any of the ways in which zipfile, zlib and numpy say so
        return None


def _keep(problem: Problem, n: int, class_front: ClassFront, parts: Path | None) -> None:
    if parts is None:
        return
    parts.mkdir(parents=True, exist_ok=True)
    path = parts / f"{key(problem)}-{n}.npz"
    buffer = BytesIO()
    np.savez(
        buffer,
        about=np.array([class_front.combinations, *class_front.crank, class_front.wheels]),
        why=np.array(str(class_front.why)),
        **vars(class_front.rows),
    )
    write_file(path, buffer.getvalue())


# --- the front


def table(problem: Problem, done: dict[int, ClassFront]) -> FrontTable:
    """The rows of all classes that no other beats in the objectives, within their hard ends."""
    parts, of, columns = [no_rows()], [np.zeros(0)], [np.zeros((0, len(problem.objectives)))]
    for n in sorted(done):
        class_front = done[n]
        if len(class_front.rows):
            parts.append(class_front.rows)
            of.append(np.full(len(class_front.rows), n))
            columns.append(_objectives(problem, n, class_front))
    rows, which, objectives = joined(parts), np.concatenate(of).astype(int), np.concatenate(columns)
    kept = front(objectives) if len(rows) else np.zeros(0, dtype=int)
    refused = tuple((n, class_front.why) for n, class_front in sorted(done.items()) if not len(class_front.rows))
    return FrontTable(
        rows.at(kept),
        which[kept],
        objectives[kept],
        sum(class_front.combinations for class_front in done.values()),
        refused,
    )


def _objectives(problem: Problem, n: int, class_front: ClassFront) -> Array:
    """Column by column, margin with its sign turned; what lies beyond a hard end is infinite."""
    rows, (c, a), choices = class_front.rows, class_front.crank, problem.classes[n]
    prices = np.array([problem.price(choices, surface) or 0.0 for surface in problem.surfaces])
    known = {
        "power": c + a * rows.power,
        "mass": rows.mass + class_front.wheels,
        "seat": rows.seat * 1e3,
        "price": prices[rows.surface.astype(int)],
        "margin": -rows.margin * 100,
    }
    beyond = np.zeros(len(rows), dtype=bool)
    for name, bound in problem.most.items():
        beyond |= known[name] > (bound if name != "margin" else -bound) + 1e-6
    columns: Array = np.stack([known[name] for name in problem.objectives], 1)
    columns[beyond] = np.inf
    return columns


def _sized(problem: Problem, known: FrontTable, place: int) -> Sized:
    return sized(problem, problem.classes[int(known.of[place])], known.rows, place)


def solved(
    problem: Problem,
    known: FrontTable,
    progress: Callable[[int, int], None] | None = None,
    enough: Callable[[], bool] = bool,
) -> tuple[list[Whole], list[Whole]]:
    """Rows that stand for all, solved whole, and those that were dropped.  A row that fails gives its place to its
    neighbours.

    A KeyboardInterrupt, or `enough` once there is a drive, ends it with those that there are by then."""
    wanted = _wanted(problem, known, problem.rows)
    scaled = known.objectives / _units(problem)
    drives: dict[int, Whole] = {}
    dropped: list[Whole] = []
    lacks: dict[int, float] = {}  # of every row that was solved
    before: Results | None = None
    try:
        for count, first in enumerate(wanted):
            if progress is not None:
                progress(count, len(wanted))
            if not drives and len(dropped) >= HOPELESS and set.intersection(*(set(drive.broken) for drive in dropped)):
                break
            if drives and enough():
                break
            place: int | None = first
            for _ in range(NEIGHBOURS + 1):
                if place is None:
                    break
                drive, results = whole(problem, _sized(problem, known, place), before)
                before, lacks[place] = results or before, drive.lacks
                if not drive.broken:
                    drives[place] = drive
                    break
                dropped.append(drive)
                place = _instead(scaled, first, set(wanted), lacks)
    except KeyboardInterrupt:
        if not drives:
            raise
    return _exact_front(problem, list(drives.values())), dropped


def _units(problem: Problem) -> Array:
    return np.array([problem.units[name] for name in problem.objectives])


def _wanted(problem: Problem, known: FrontTable, count: int) -> list[int]:
    """The places of rows that stand for all."""
    finite = np.flatnonzero(np.isfinite(known.objectives).all(1))
    return [int(finite[n]) for n in representatives(known.objectives[finite], _units(problem), count)]


def _instead(scaled: Array, first: int, wanted: set[int], lacks: Mapping[int, float]) -> int | None:
    """In the place of a row that fails: of its neighbours that are neither wanted nor solved the one that should lack
    least, by the row nearest to it that was solved, and of these the nearest; None: there is none."""
    far = np.abs(scaled - scaled[first]).max(1)
    near = [
        int(n)
        for n in np.argsort(far, kind="stable")[:NEAR]
        if np.isfinite(far[n]) and n not in wanted and n not in lacks
    ]
    done = list(lacks)

    def should_lack(place: int) -> float:
        return lacks[done[int(np.abs(scaled[done] - scaled[place]).max(1).argmin())]]

    return min(near, key=lambda n: (should_lack(n), far[n]), default=None)


def first_passing(problem: Problem, known: FrontTable) -> Whole | None:
    """A drive that passes, of a few rows that stand for all; None: not one of these."""
    for place in _wanted(problem, known, FIRST):
        drive, _ = whole(problem, _sized(problem, known, place))
        if not drive.broken:
            return drive
    return None


def _exact_front(problem: Problem, drives: list[Whole]) -> list[Whole]:
    """Those that no other beats in the numbers of the whole solutions, least power first."""
    if not drives:
        return []
    rows = np.array(
        [[(-1 if name == "margin" else 1) * drive.objectives[name] for name in problem.objectives] for drive in drives]
    )
    kept = [drives[int(n)] for n in front(np.round(rows, 9))]
    return sorted(kept, key=lambda drive: (drive.objectives["power"], drive.objectives["mass"], str(drive.changes)))


def search(
    problem: Problem,
    processes: int = 1,
    parts: Path | None = None,
    progress: Told | None = None,
    solving: Callable[[int, int], None] | None = None,
    scheduler: str = "",
    stop: Callable[[], bool] = bool,
    first: Callable[[Whole], None] | None = None,
    enough: Callable[[], bool] = bool,
    pulse: Callable[[], None] | None = None,
) -> FrontFound:
    """The front of whole drives.  `stop`, asked after each class, or a KeyboardInterrupt ends the classes; what is
    known by then is solved whole and given, until `enough`, asked after each drive.  `first` is told the first drive
    that is known to pass."""
    done: dict[int, ClassFront] = {}
    passing: Whole | None = None
    try:
        for n, class_front in classes(problem, processes, parts, scheduler, pulse):
            done[n] = class_front
            known = table(problem, done)
            if progress is not None:
                progress(len(done), known, named(problem.classes[n]))
            if first is not None and passing is None and (passing := first_passing(problem, known)) is not None:
                first(passing)
            if stop():
                break
    except KeyboardInterrupt:
        if not done:
            raise
    known = table(problem, done)
    drives, dropped = solved(problem, known, solving, enough)
    return FrontFound(problem, known, tuple(drives), tuple(dropped), len(done))


def named(choices: dict[str, Any]) -> str:
    """A class in a few words: its choices."""
    return ", ".join("/".join(map(str, value)) if isinstance(value, list) else str(value) for value in choices.values())
