# SPDX-License-Identifier: Apache-2.0
"""Times of the mounts:  python -m bench.mounting

The whole step of the shipped design (modes, statics, four operations, five variants, run-up of the seat), the map of
171 speeds, 16 orders and five variants by itself, and the search for mounts; against np.exp of 100 000 numbers in the
same run."""

from time import perf_counter

import numpy as np

from bench.film import best
from calc.design import step_inputs
from calc.design.toml_file import design, read
from calc.mounting import solve as mounting
from calc.mounting.seat_vibration import courses
from calc.mounting.selection import choices
from calc.sheet.value import recorded
from calc.solve import solve
from calc.studies.shipped import DESIGNS


def main() -> None:
    made = design(read(DESIGNS / "r753ie4_mounting.toml"))
    outcomes = solve(made).outcomes
    own = {made.countershaft.name: outcomes["countershaft"]}
    shafts = step_inputs.shafts_on_engine(made, own, outcomes["gears"])
    given, engine = made.mounting, made.engine
    assert given is not None and engine is not None
    numbers = np.linspace(0, 1, 100_000)
    unit = best(lambda: np.exp(numbers), 20)
    with recorded(False):
        whole = best(
            lambda: mounting.solve(given, engine, outcomes["engine"].solution, outcomes["imbalance"].solution, shafts),
            10,
        )
        result = outcomes["mounting"].solution
        run_up = best(lambda: courses(given, result.system, result.drive, ()), 10)
        start = perf_counter()
        choices(given, result)
        search = perf_counter() - start
    for name, time in (("step", whole), ("map", run_up), ("search", search)):
        print(f"{name:<8} {1e3 * time:8.1f} ms {time / unit:10.0f} × np.exp of 100 000")


if __name__ == "__main__":
    main()
