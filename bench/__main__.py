# SPDX-License-Identifier: Apache-2.0
"""Every ratio in one run: `python -m bench [--write] [NAME …]`; 10 to 20 minutes on two cores that nothing else takes.

With names only these are measured, and written in place of what docs/speed.md has of them.

One measurement after the other, each in a process of its own; what it prints is what stands in docs/speed.md
(`--write`), below the machine that it was taken on.  Against ROSS and GEARpie, which are no dependencies of this
program, a measurement is started by hand: how stands in its file."""

import ast
import os
import platform
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

HERE = Path(__file__).parent
TABLE = HERE.parent / "docs" / "speed.md"
MEASURED: dict[str, tuple[str, ...]] = {
    "startup": (),
    "report": (),
    "session": ("3",),
    "balance": (),
    "sizing": (),
    "scatter": (),
    "film": (),
    "bearings": (),
    "selection": (),
    "gears": (),
    "friction": (),
    "drive": (),
    "mounting": (),
    "shafts": (),
    "links": (),
    "sweep": ("10000",),
    "design": (),
}
BY_HAND = ("beam_against_ross", "film_against_ross")
HEAD = """# Speed

Made by `python -m bench --write`. Times depend on the machine, ratios less: each is taken within one run, against what stands beside it
(a bare interpreter, `import numpy`, `np.exp` of 100 000 numbers, the same by a plain loop, the same by another program). What a
measurement aims at stands with it; what is not reached is printed like the rest.

{machine}

Against other programs, which have to be installed: {by_hand} (ROSS) and `bench/friction.py --gearpie FOLDER` (GEARpie) say how.
"""


def machine() -> str:
    """What it was measured on."""
    cpuinfo = Path("/proc/cpuinfo")
    names = (
        [line.partition(":")[2].strip() for line in cpuinfo.read_text().splitlines() if line.startswith("model name")]
        if cpuinfo.exists()
        else []
    )
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    libraries = ", ".join(
        f"{name} {version(name)}" for name in ("numpy", "scipy", "textual", "reportlab", "matplotlib")
    )
    system = f"{platform.system()}, Python {platform.python_version()}"
    return f"Measured on {names[0] if names else platform.machine()}, {cores} cores; {system}, {libraries}."


def about(name: str) -> str:
    """What a measurement says of itself."""
    return (ast.get_docstring(ast.parse((HERE / f"{name}.py").read_text(encoding="utf-8"))) or "").strip()


def measured(name: str) -> str:
    """What it prints, also where it fails."""
    print(f"\n== {name}", flush=True)
    process = subprocess.Popen(
        [sys.executable, "-m", f"bench.{name}", *MEASURED[name]],
        cwd=HERE.parent,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    said = []
    for line in process.stdout or ():
        print(line, end="", flush=True)
        said.append(line.rstrip())
    if process.wait():
        said.append(f"ended with {process.returncode}")
    return "\n".join(said)


def main(*arguments: str) -> int:
    names = [name for name in arguments if name != "--write"] or list(MEASURED)
    if unknown := [name for name in names if name not in MEASURED]:
        print(f"no measurement {', '.join(unknown)}; there are {', '.join(MEASURED)}", file=sys.stderr)
        return 2
    print(machine())
    known = written() if names != list(MEASURED) else {}
    known |= {name: f"{about(name)}\n\n```text\n{measured(name)}\n```" for name in names}
    if "--write" in arguments:
        head = HEAD.format(machine=machine(), by_hand=" and ".join(f"`bench/{name}.py`" for name in BY_HAND))
        parts = [f"\n## {name}\n\n{known[name]}\n" for name in MEASURED if name in known]
        TABLE.write_text(head + "".join(parts), encoding="utf-8")
    return 0


def written() -> dict[str, str]:
    """What the page has of each measurement."""
    _, *parts = TABLE.read_text(encoding="utf-8").split("\n## ") if TABLE.exists() else [""]
    return {name: text.strip() for name, _, text in (part.partition("\n") for part in parts)}


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
