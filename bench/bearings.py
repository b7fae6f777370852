# SPDX-License-Identifier: Apache-2.0
"""Times of the bearing step:  python -m bench.bearings

The thermal balance of many bearings at once against one after the other, and the whole step with its corners, sweep and
routes, against np.exp of 100 000 numbers in the same run."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from bench.film import best
from calc.bearings import solve as bearings
from calc.bearings.plain.routes.routes import own_warm
from calc.bearings.plain.routes.thermal_balance import balanced, settled
from calc.design.toml_file import design, read
from calc.solve import solve

DESIGN = Path(__file__).parents[1] / "designs" / "r753ie4_gamma.toml"
MANY, FEW = 20_000, 100


def main() -> None:
    results = solve(design(read(DESIGN)))
    arguments = results.parts["bearings.solve"][0]
    front = results.outcomes["bearings"].result.bearings["front"]
    random = np.random.default_rng(0)
    loads: Any = random.uniform(300, 3000, MANY)
    clearances: Any = random.uniform(50e-6, 150e-6, MANY)
    lengths: Any = random.uniform(15e-3, 50e-3, MANY)
    seat = replace(front.seat, clearance=clearances, bearing=replace(front.seat.bearing, length=lengths))
    duty = replace(front.duty, load=loads)

    def one_by_one() -> None:
        for load, g in zip(loads[:FEW].tolist(), clearances[:FEW].tolist()):
            balanced(own_warm, replace(front.seat, clearance=g), replace(front.duty, load=load))

    exponents = random.uniform(-1.0, 1.0, 100_000)
    baseline = best(lambda: np.exp(exponents), 20)
    loop = best(one_by_one, 1, 3) / FEW
    vectorised = best(lambda: settled(seat, duty), 1, 3) / MANY
    rows = (
        ("thermal balance, one after the other, per point", loop),
        (f"thermal balance, {MANY} lengths, clearances and loads, per point", vectorised),
        ("whole step: both bearings, routes, corners, sweep, curves", best(lambda: bearings.solve(*arguments[:4]), 3)),
    )
    print(f"{'np.exp of 100 000 numbers (baseline)':66s}{baseline * 1e6:12.1f} µs")
    for title, seconds in rows:
        print(f"{title:66s}{seconds * 1e6:12.1f} µs{seconds / baseline:12.3f}")
    print(f"{'one after the other over all at once':66s}{loop / vectorised:12.1f} ×")


if __name__ == "__main__":
    main()
