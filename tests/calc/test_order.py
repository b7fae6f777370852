# SPDX-License-Identifier: Apache-2.0
"""What is computed comes in one order, whatever order Python's sets have in a process: a report is set again from it,
byte for byte."""

import os
import subprocess
import sys

from tests.conftest import ROOT

SOLVED = """
import sys
from hashlib import sha256
from calc.design.toml_file import load
from calc.studies.shipped import DESIGNS
from calc.solve import solve
for path in sorted(DESIGNS.glob("*.toml")):
    results = solve(load(path)[1])
    for key, outcome in results.outcomes.items():
        whole = outcome.whole
        said = [f"{line.formula.symbol} {line.about} {line.value!r}" for line in whole.lines]
        said += [f"{c} {c.advice}" for c in whole.checks] + [str(x) for x in (*whole.notes, *whole.tables, *whole.values())]
        print(path.stem, key, sha256("\\n".join(said).encode()).hexdigest())
"""


def test_every_line_of_every_shipped_design_comes_in_one_order() -> None:
    runs = [
        subprocess.Popen(
            [sys.executable, "-c", SOLVED],
            cwd=ROOT,
            stdout=subprocess.PIPE,
            text=True,
            env={**os.environ, "PYTHONHASHSEED": seed},
        )
        for seed in ("1", "3")
    ]
    first, second = (run.communicate()[0].splitlines() for run in runs)
    assert len(first) > 90 and [(a, b) for a, b in zip(first, second, strict=True) if a != b] == []
