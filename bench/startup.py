# SPDX-License-Identifier: Apache-2.0
"""Start-up and solves as ratios of processor time (user and system), the least of several, each command in turn with
its baselines.

    python bench/startup.py [RUNS]                    of a checkout: PYTHONPATH=. python bench/startup.py

Processor time and not the clock, since other programs may share the machine.  Children may write bytecode, as those of
a user may.  Ceilings: `--help` at most 4 × bare Python, `check` of a design that passes at most 3 × `python -c "import
numpy"`.  Simplicity comes before a tenth of a second: what is below its ceiling is quick enough."""

import os
import subprocess
import sys
import tempfile
from pathlib import Path
from time import process_time

ROOT = Path(__file__).resolve().parent.parent
PASSES, FAILS = (str(ROOT / "designs" / f"{name}.toml") for name in ("r753ie4_sized", "r753ie4_gamma"))
PROGRAM = ["-m", "assistant"]
COMMANDS = {
    "bare": ["-c", "pass"],
    "numpy": ["-c", "import numpy"],
    "--help": [*PROGRAM, "--help"],
    "check, passes": [*PROGRAM, "check", PASSES],
    "check, fails": [*PROGRAM, "check", FAILS],
    "report": [*PROGRAM, "report", FAILS],
}
BASELINES = {"--help": "bare", "check, passes": "numpy", "check, fails": "numpy", "report": "numpy"}
CEILINGS = {"--help": 4.0, "check, passes": 3.0}


def seconds(arguments: list[str], folder: str) -> float:
    """Processor time of a child."""
    environment = {name: text for name, text in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    child = subprocess.Popen(
        [sys.executable, "-P", *arguments],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        cwd=folder,
        env=environment,
    )
    _, status, used = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    return used.ru_utime + used.ru_stime


def commands(runs: int) -> None:
    least = dict.fromkeys(COMMANDS, float("inf"))
    with tempfile.TemporaryDirectory() as folder:
        for run in range(runs + 1):
            for name, arguments in COMMANDS.items():
                took = seconds(arguments, folder)
                if run:  # the first compiles
                    least[name] = min(least[name], took)
    for name, took in least.items():
        of = BASELINES.get(name)
        ratio = f"  {took / least[of]:5.2f} × {of}" if of else ""
        ceiling = f", ceiling {CEILINGS[name]:g}" if name in CEILINGS else ""
        print(f"{name:<34}{took * 1e3:7.0f} ms{ratio}{ceiling}")


def solves(runs: int) -> None:
    """In this process: the first solve, a warm one, and again after a change of an input of the last step."""
    from calc.design.toml_file import design, read
    from calc.solve import Results, solve

    document = read(FAILS)
    designs = [design(document.with_value("friction.flank_roughness_um", [Ra, 0.6])) for Ra in (0.5, 0.6)]

    def timed(n: int, before: Results | None = None) -> tuple[float, Results]:
        start = process_time()
        found = solve(designs[n % 2], before)
        return process_time() - start, found

    first, found = timed(0)
    warm = min(timed(n)[0] for n in range(runs))
    again = []
    for n in range(1, runs + 1):
        took, found = timed(n, found)
        again.append(took)
    print(f"{'first solve in a process':<34}{first * 1e3:7.0f} ms  {first / warm:5.2f} × warm")
    print(f"{'warm solve':<34}{warm * 1e3:7.0f} ms")
    print(f"{'friction changed, solved again':<34}{min(again) * 1e3:7.0f} ms  {min(again) / warm:5.2f} × warm")


def main() -> None:
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else 11
    commands(runs)
    solves(runs)


if __name__ == "__main__":
    main()
