# SPDX-License-Identifier: Apache-2.0
"""What several shafts cost:  python -m bench.shafts

The pair of the R754IE4, on three plain bearings each, over the one shaft of the R753IE4 on two: a whole solve in turn,
the best of each, and the calls of functions that it makes; and one pass in which its three films share the load.
Ceilings: 1.6 times by either; 0.3 ms a pass.
"""

import sys
from collections.abc import Callable
from functools import partial
from time import process_time
from types import FrameType

from bench.film import best
from calc.bearings.plain.as_support import film_law
from calc.countershaft.bending.carried import carried
from calc.countershaft.bending.condensed import of_beam
from calc.design.toml_file import load_design
from calc.solve import Results, solve
from calc.studies.shipped import DESIGNS

ROUNDS = 20
NAMES = ("r753ie4_gamma", "r754ie4_balance_shafts")


def calls(task: Callable[[], object]) -> int:
    """How many functions it calls, of Python and of others."""
    counted = 0

    def count(frame: FrameType, event: str, argument: object) -> None:
        nonlocal counted
        counted += event in ("call", "c_call")

    sys.setprofile(count)
    try:
        task()
    finally:
        sys.setprofile(None)
    return counted


def newton(results: Results) -> float:
    """Seconds of one pass of the first shaft."""
    view = next(iter(results.views.values()))
    shaft, bearings = view.shaft, view.outcomes["bearings"].result
    turning = of_beam(shaft.bending.model, shaft.omega)
    rows = bearings.bearings.values()
    laws = [film_law(r.seat, r.clearance_hot, r.hot.oil.mu, r.duty.effective_speed, 1) for r in rows]
    return best(lambda: carried(turning, laws), 20)


def main() -> None:
    made = {name: load_design(DESIGNS / f"{name}.toml") for name in NAMES}
    results = {name: solve(design) for name, design in made.items()}
    least = dict.fromkeys(NAMES, float("inf"))
    for _ in range(ROUNDS):
        for name, design in made.items():
            start = process_time()
            solve(design)
            least[name] = min(least[name], process_time() - start)
    counted = {name: calls(partial(solve, design)) for name, design in made.items()}
    one, several = NAMES
    for name in NAMES:
        print(f"{name:<24} {1e3 * least[name]:6.1f} ms   {counted[name]:8d} calls")
    print(f"{'several over one':<24} {least[several] / least[one]:6.2f} ×    {counted[several] / counted[one]:8.2f} ×")
    print(f"{'films share, a pass':<24} {1e3 * newton(results[several]):6.3f} ms")


if __name__ == "__main__":
    main()
