# SPDX-License-Identifier: Apache-2.0
"""Start-up as ratios: each command in turn with its baseline, A B A B …, so that a slower moment of the machine hits both.

    python bench/startup.py [RUNS]

Budgets: `--help` under 60 ms over bare Python; `check` at most 2.5 × `python -c "import numpy"`; `report` under 3 s.  Run it on a quiet
machine, with the program installed (`pip install .`): an installation in place compiles its modules anew where the environment
forbids Python to write bytecode (PYTHONDONTWRITEBYTECODE).
"""

import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import median
from time import perf_counter

ROOT = Path(__file__).parent.parent
DESIGN = ROOT / "designs" / "r753ie4_gamma.toml"
PROGRAM = [sys.executable, "-P", "-m", "assistant"]


def seconds(command: list[str], folder: str) -> float:
    start = perf_counter()
    subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=folder, check=False)
    return perf_counter() - start


def compare(name: str, command: list[str], baseline: list[str], runs: int, folder: str) -> None:
    pairs = [(seconds(command, folder), seconds(baseline, folder)) for _ in range(runs + 1)][1:]  # the first warms up
    ours, theirs = median(a for a, _ in pairs), median(b for _, b in pairs)
    print(
        f"{name:<8} {ours * 1e3:7.0f} ms   baseline {theirs * 1e3:6.0f} ms   over it {(ours - theirs) * 1e3:6.0f} ms   "
        f"ratio {median(a / b for a, b in pairs):5.2f}   best {min(a for a, _ in pairs) / min(b for _, b in pairs):5.2f}"
    )


def main() -> None:
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else 11
    bare, numpy = [sys.executable, "-P", "-c", "pass"], [sys.executable, "-P", "-c", "import numpy"]
    with tempfile.TemporaryDirectory() as folder:
        compare("--help", [*PROGRAM, "--help"], bare, runs, folder)
        compare("check", [*PROGRAM, "check", str(DESIGN)], numpy, runs, folder)
        compare("report", [*PROGRAM, "report", str(DESIGN)], bare, max(3, runs // 3), folder)


if __name__ == "__main__":
    main()
