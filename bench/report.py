# SPDX-License-Identifier: Apache-2.0
"""How long a whole report takes, as a ratio to a process that only imports the same libraries.

python bench/report.py [DESIGN]
"""

import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).parent.parent
IMPORTS = """
import numpy, matplotlib.figure, matplotlib.backend_bases, reportlab.pdfgen.canvas, reportlab.pdfbase.ttfonts
import calc.design_file, calc.solve, calc.sheet.expression
"""
REPORT = """
import sys
from pathlib import Path
from calc.design_file import design, parse
from calc.solve import solve
from reports.report import write
raw = Path(sys.argv[1]).read_bytes()
document = parse(raw, "design.toml")
write(document, solve(design(document)), raw, Path(sys.argv[2]), depth=sys.argv[3])
"""


def best(code: str, *arguments: str, times: int = 5) -> float:
    """The shortest of a few runs in a fresh process, in seconds."""
    taken = []
    for _ in range(times):
        start = time.perf_counter()
        subprocess.run([sys.executable, "-c", code, *arguments], cwd=ROOT, check=True)
        taken.append(time.perf_counter() - start)
    return min(taken)


def main() -> None:
    design = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "designs" / "r753ie4_gamma.toml")
    imports = best(IMPORTS)
    print(f"imports alone       {imports:6.2f} s")
    with tempfile.TemporaryDirectory() as folder:
        for depth in ("summary", "engineer", "audit"):
            target = Path(folder) / f"{depth}.pdf"
            taken = best(REPORT, design, str(target), depth)
            print(f"{depth:<20}{taken:6.2f} s   ratio {taken / imports:4.2f}   {target.stat().st_size / 1e3:6.0f} kB")


if __name__ == "__main__":
    main()
