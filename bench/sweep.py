# SPDX-License-Identifier: Apache-2.0
"""Sweeps against single solves, and their memory: `python -m bench.sweep [DESIGNS]`.

The imbalance alone, whole designs (imbalance to friction) on all cores, and the memory of the program while the table
grows.  Rows of the whole designs are held to what `check` gives.  Seconds are those of all processors together.
Ceilings: a whole design at most 1.15 × one untraced solve with its parsing, memory flat."""

import csv
import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from calc.design.toml_file import design, read
from calc.sheet.value import recorded
from calc.solve import solve
from calc.studies.sweep import varied
from calc.studies.sweep.inputs import sampled

ROOT = Path(__file__).parents[1]
DESIGN = str(ROOT / "designs" / "r753ie4_gamma.toml")
OVER = [
    "engine.rated_speed_rpm=1500:2600",
    "engine.rod_length_mm=155:170",
    "bearings.front.length_mm=26:36",
    "friction.oil_temperature_C=70:110",
]
DIGITS = 1e-11
ALONE = 40  # designs that are solved one by one to compare with
WANTED = ["imbalance.required_couple", "bearings.front.film", "friction.total_loss"]


def swept(count: int, out: Path, *more: str) -> tuple[float, float]:
    """Seconds of all processors that a sweep takes, and the most memory of one of its processes so far, MB."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    words = [sys.executable, "-m", "assistant", "sweep", DESIGN, "--hypercube", str(count), "-o", str(out), *more]
    subprocess.run(words, check=True, capture_output=True, cwd=ROOT, env={**os.environ, "PYTHONPATH": str(ROOT)})
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return seconds, after.ru_maxrss / 1024


def one_alone() -> float:
    """Seconds of a processor of one solve with its parsing, the mean over some designs of the sweep."""
    document = read(Path(DESIGN))
    inputs = varied(document, OVER, drawn=True)
    rows = sampled(inputs, ALONE, hypercube=True).rows(0, ALONE)
    with recorded(False):
        solve(design(document), compared=False)  # what is made once
        begun = time.process_time()
        for row in rows:
            changed = document
            for variable, number in zip(inputs, row):
                changed = changed.with_value(variable.key, number)
            solve(design(changed), compared=False)
    return (time.process_time() - begun) / ALONE


def main() -> None:
    count, cores = int(sys.argv[1]) if len(sys.argv) > 1 else 1000, os.cpu_count() or 1
    print(f"load of the machine before: {os.getloadavg()[0]:.1f}")
    alone = one_alone()
    print(f"one whole design alone: {alone * 1e3:.1f} ms")
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "table.csv"
        seconds, memory = swept(count, out, "--vary", *OVER[:2], "--step", "imbalance", "--values", WANTED[0])
        print(f"imbalance of {count} engines: {seconds:.1f} s, {memory:.0f} MB")
        for designs in (count // 4, count):
            seconds, memory = swept(designs, out, "--vary", *OVER, "--values", *WANTED)
            print(
                f"{designs} whole designs on {cores} cores: {seconds:.1f} s, a design {seconds / designs / alone:.2f} x one "
                f"alone, {memory:.0f} MB"
            )
        rows = list(csv.DictReader(out.read_text(encoding="utf-8").splitlines()))
        for row in (rows[0], rows[count // 2], rows[-1]):
            keys = [one.partition("=")[0] for one in OVER]
            words = [
                sys.executable,
                "-m",
                "assistant",
                "check",
                DESIGN,
                "--json",
                "--set",
                *(f"{key}={row[key]}" for key in keys),
            ]
            done = subprocess.run(
                words, capture_output=True, text=True, cwd=ROOT, env={**os.environ, "PYTHONPATH": str(ROOT)}
            )
            values = json.loads(done.stdout)["values"]
            apart = max(abs(float(row[f"{id} [{values[id]['unit']}]"]) / values[id]["value"] - 1) for id in WANTED)
            assert apart < DIGITS, apart
    print(
        f"first, middle and last row as `check` has them, to {DIGITS:g}; load of the machine after: "
        f"{os.getloadavg()[0]:.1f}"
    )


if __name__ == "__main__":
    main()
