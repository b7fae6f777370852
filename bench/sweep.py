# SPDX-License-Identifier: Apache-2.0
"""Sweeps as designs a second, and their memory: `python -m bench.sweep [DESIGNS]`.

The imbalance on arrays, whole designs (imbalance to friction) on all cores, and the memory of the program while the
table grows.  Rows of the whole designs are held to what `check` gives. We aim at: 10,000 whole designs in 60 s on two
cores, memory flat."""

import csv
import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).parents[1]
DESIGN = str(ROOT / "designs" / "r753ie4_gamma.toml")
OVER = [
    "engine.rated_speed_rpm=1500:2600",
    "engine.rod_length_mm=155:170",
    "bearings.front.length_mm=26:36",
    "friction.oil_temperature_C=70:110",
]
DIGITS = 1e-11
WANTED = ["imbalance.required_couple", "bearings.front.film", "friction.total_loss"]


def swept(count: int, out: Path, *more: str) -> tuple[float, float]:
    """Seconds that a sweep takes, and the most memory of one of its processes so far, MB."""
    begun = time.perf_counter()
    words = [sys.executable, "-m", "assistant", "sweep", DESIGN, "--hypercube", str(count), "-o", str(out), *more]
    subprocess.run(words, check=True, capture_output=True, cwd=ROOT, env={**os.environ, "PYTHONPATH": str(ROOT)})
    return time.perf_counter() - begun, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024


def main() -> None:
    count, cores = int(sys.argv[1]) if len(sys.argv) > 1 else 1000, os.cpu_count() or 1
    print(f"load of the machine before: {os.getloadavg()[0]:.1f}")
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "table.csv"
        seconds, memory = swept(10_000, out, "--vary", *OVER[:2], "--step", "imbalance", "--values", WANTED[0])
        print(f"imbalance of 10,000 engines on arrays: {seconds:.1f} s, {memory:.0f} MB")
        for designs in (count // 4, count):
            seconds, memory = swept(designs, out, "--vary", *OVER, "--values", *WANTED)
            print(
                f"{designs} whole designs on {cores} cores: {seconds:.1f} s, {designs / seconds:.1f} a second, "
                f"{memory:.0f} MB"
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
