# SPDX-License-Identifier: Apache-2.0
"""Times of the search:  python -m bench.selection

The whole processes first, as ratios to `import numpy`: a `check` that passes, one that looks for the nearest passing
design, and designs for which there is none.  Then the search for bearings: a candidate is a length and a clearance in
six states of its tolerances and load, beside a plain loop over `balanced`, one film after the other.  Budgets: γ 4 ×
`import numpy`, a whole search for bearings below 3 s."""

import subprocess
import sys
from dataclasses import replace
from functools import partial
from pathlib import Path
from statistics import median
from time import perf_counter

from bench.film import best
from calc.bearings.plain.routes.routes import own_warm
from calc.bearings.plain.routes.thermal_balance import balanced
from calc.bearings.plain.selection.grid import field
from calc.bearings.plain.selection.search import nearest_row, search
from calc.bearings.plain.selection.states import AT_CORNERS, solved
from calc.bearings.plain.selection.variants import tasks, variants
from calc.design.step_inputs import bearings_case
from calc.design.toml_file import design, read
from calc.solve import solve

ROOT = Path(__file__).parent.parent
DESIGNS = ROOT / "designs"
RUNS = 7
CHECKS = {
    "check, passes": ("r753ie4_sized",),
    "check, nearest passing design (γ)": ("r753ie4_gamma",),
    "check, one number at a time": ("r753ie4_gamma", "countershaft.bolts.torque_Nm=5"),
    "check, no film at any size": ("r753ie4_gamma", "bearings.supply_temperature_C=140"),
    "check, nothing carries it": ("r753ie4_gamma", "engine.rated_speed_rpm=6000"),
}


def seconds(*command: str) -> float:
    start = perf_counter()
    subprocess.run(
        [sys.executable, *command], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=ROOT, check=False
    )
    return perf_counter() - start


def processes() -> None:
    """Each in turn with its baseline, so that a slower moment of the machine hits both."""
    for title, (name, *changes) in CHECKS.items():
        command = ["-m", "assistant", "check", str(DESIGNS / f"{name}.toml"), *(["--set", *changes] if changes else [])]
        pairs = [(seconds(*command), seconds("-c", "import numpy")) for _ in range(RUNS)]
        print(f"{title:44s}{median(a for a, _ in pairs):12.2f} s    ratio {median(a / b for a, b in pairs):8.1f}")


def main() -> None:
    processes()
    made = design(read(DESIGNS / "r753ie4_gamma.toml"))
    case = bearings_case(made, solve, solve(made))
    variant = variants(case)[0]
    task = tasks(case)["rear"][0]
    some = field(task, variant, 0.0)
    assert some is not None
    l, g = some.states.length, some.states.clearance

    def plain() -> None:
        for n in range(0, l.size, l.size // 10):
            seat = replace(
                task.seat, bearing=replace(task.seat.bearing, length=float(l.flat[n])), clearance=float(g.flat[n])
            )
            balanced(own_warm, seat, task.duty)

    loop = best(plain, 3) / len(range(0, l.size, l.size // 10)) * len(AT_CORNERS)
    print(f"{'a plain loop, per candidate':44s}{loop * 1e6:12.1f} µs")
    for title, time in (
        (f"{l.size} candidates, each solved", best(lambda: solved(task, l, g), 3) / l.size),
        (f"{l.size} candidates, as the search has them", best(lambda: field(task, variant, 0.0), 3) / l.size),
    ):
        print(f"{title:44s}{time * 1e6:12.1f} µs   ratio {loop / time:8.1f}")
    for name in ("gamma", "beta", "sized"):
        made = design(read(DESIGNS / f"r753ie4_{name}.toml"))
        results = solve(made)
        one = best(partial(solve, made), 3)
        case = bearings_case(made, solve, results)
        for title, call in ((f"the whole search, {name}", search), (f"the nearest only, {name}", nearest_row)):
            time = best(partial(call, case), 1)
            print(f"{title:44s}{time:12.2f} s    ratio to one solve {time / one:8.1f}")


if __name__ == "__main__":
    main()
