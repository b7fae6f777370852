# SPDX-License-Identifier: Apache-2.0
"""What the links of numbers cost a solve: its time with them over that without, alternately, the best of each.

python bench/links.py [DESIGN]      (1.09 was measured on r753ie4_gamma, by instructions 401 and 438 million)
"""

import sys
from pathlib import Path
from time import process_time

import calc.sheet.formula as formula
from calc.design.toml_file import design, read
from calc.sheet.value import Line, recorder, subject, unlinked
from calc.solve import solve

ROUNDS = 40
LINKING = formula.Formula.__call__


def without_links(self, *args, **kwargs):
    value = self.function(*args, **kwargs)
    if (lines := recorder.get()) is not None:
        given = {**dict(zip(self.parameters, args)), **kwargs} if args else kwargs
        lines.append(Line(self, given, value, subject.get()))
    return value


def main() -> None:
    name = sys.argv[1] if len(sys.argv) > 1 else "r753ie4_gamma"
    linked = design(read(Path(__file__).parents[1] / "designs" / f"{name}.toml"))
    ways = {"with": (LINKING, linked), "without": (without_links, unlinked(linked))}
    best = dict.fromkeys(ways, float("inf"))
    for _ in range(ROUNDS):
        for way, (call, one) in ways.items():
            formula.Formula.__call__ = call
            start = process_time()
            solve(one)
            best[way] = min(best[way], process_time() - start)
    print(f"{name}: {best['with'] / best['without']:.2f}")


if __name__ == "__main__":
    main()
