# SPDX-License-Identifier: Apache-2.0
"""The search for whole drives as ratios to one whole solution: `python -m bench.design`.

Films, shafts and combinations a second on one core; a class, the shipped search, the first drive that passes, memory.
"""

import resource
import time
from pathlib import Path

import numpy as np

from calc.design.toml_file import design, load, read
from calc.solve import solve
from calc.studies.drive.classes import tables_of
from calc.studies.drive.combinations import class_front, combinations
from calc.studies.drive.search import asked, search
from calc.studies.drive.shafts import shafts

DESIGNS = Path(__file__).parents[1] / "designs"


def timed(what, count=3):
    """The least of some runs, and what the last gave."""
    best, found = np.inf, None
    for _ in range(count):
        start = time.perf_counter()
        found = what()
        best = min(best, time.perf_counter() - start)
    return best, found


def main() -> None:
    document, made = load(DESIGNS / "r753ie4_sized.toml")
    before = solve(made)
    moved = design(document.with_value("bearings.rear.length_mm", 30.0))
    one, _ = timed(lambda: solve(moved, before), 9)
    print(f"one whole solution, of which what is alike is taken over: {one * 1e3:.0f} ms")
    problem, _ = asked(read(DESIGNS / "r753ie4_drive.toml"), {})
    seconds, (drive, sizes) = timed(lambda: tables_of(problem, problem.classes[0]))
    films = sum(f.power.size for some in sizes.films.values() for f in some)
    print(
        f"tables of one class: {films:,} sizes of journals in {seconds:.2f} s, {films * 6 / seconds:,.0f} films/s "
        f"({seconds / one:.0f} x)"
    )
    l_f, l_r = np.arange(0.015, 0.045, 0.0005), np.arange(0.022, 0.06, 0.0005)
    seconds, found = timed(lambda: shafts(drive, sizes.core, l_f, l_r, 0.086, 0.086))
    print(f"shafts: {found.mass.size / seconds:,.0f} a second")
    seconds, rows = timed(lambda: class_front(drive, sizes), 1)
    count = combinations(sizes)
    rate = f"{count / seconds:.2g} a second"
    print(f"one class, {count:.2g} combinations: {seconds:.2f} s, {rate}, front {len(rows):,} ({seconds / one:.0f} x)")
    start, first = time.perf_counter(), []
    whole = search(problem, 1, solving=lambda n, of: first.append(time.perf_counter()) if n == 1 else None)
    seconds = time.perf_counter() - start
    print(
        f"{len(problem.classes)} classes, {whole.table.combinations:.2g} combinations, {len(whole.drives)} drives "
        f"solved whole:"
    )
    print(
        f"  {seconds:.0f} s in one process ({seconds / one:.0f} x), the first drive that passes after "
        f"{first[0] - start:.0f} s"
    )
    print(
        f"  {len(whole.dropped)} rows dropped; memory "
        f"{resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024:.0f} MB"
    )


if __name__ == "__main__":
    main()
