# SPDX-License-Identifier: Apache-2.0
"""Times of choosing bearings:  python -m bench.choosing

A candidate is a length and a clearance in six states of its tolerances and load.  Beside the time of each stands its ratio to a plain loop
over `balanced`, one film after the other.  Budget: a whole search below 3 s.
"""

from dataclasses import replace
from functools import partial
from pathlib import Path

from bench.film import best
from calc.bearings.choosing.grid import field
from calc.bearings.choosing.search import nearest_passing, search
from calc.bearings.choosing.states import STATES, solved
from calc.bearings.choosing.variants import tasks, variants
from calc.bearings.routes.balance import balanced
from calc.bearings.routes.routes import own_warm
from calc.choosing import bearings_case
from calc.design_file import design, read
from calc.solve import solve

DESIGNS = Path(__file__).parent.parent / "designs"


def main() -> None:
    made = design(read(DESIGNS / "r753ie4_gamma.toml"))
    case = bearings_case(made, solve(made))
    variant = variants(case)[0]
    task = tasks(case)["rear"][0]
    some = field(task, variant, 0.0)
    assert some is not None
    l, g = some.states.length, some.states.clearance

    def plain() -> None:
        for n in range(0, l.size, l.size // 10):
            seat = replace(task.seat, bearing=replace(task.seat.bearing, length=float(l.flat[n])), clearance=float(g.flat[n]))
            balanced(own_warm, seat, task.duty)

    loop = best(plain, 3) / len(range(0, l.size, l.size // 10)) * len(STATES)
    print(f"{'a plain loop, per candidate':44s}{loop * 1e6:12.1f} µs")
    for title, seconds in (
        (f"{l.size} candidates, each solved", best(lambda: solved(task, l, g), 3) / l.size),
        (f"{l.size} candidates, as the search has them", best(lambda: field(task, variant, 0.0), 3) / l.size),
    ):
        print(f"{title:44s}{seconds * 1e6:12.1f} µs   ratio {loop / seconds:8.1f}")
    for name in ("gamma", "beta", "sized"):
        made = design(read(DESIGNS / f"r753ie4_{name}.toml"))
        case = bearings_case(made, solve(made))
        print(f"{'the whole search, ' + name:44s}{best(partial(search, case), 1):12.2f} s")
        print(f"{'the nearest only, ' + name:44s}{best(partial(nearest_passing, case), 1):12.2f} s")


if __name__ == "__main__":
    main()
