# SPDX-License-Identifier: Apache-2.0
"""How long a whole report takes, as a ratio to a script that imports the same libraries and draws the same figures once.

python bench/report.py [DESIGN] [ROUNDS]

The runs take turns, so that a slower moment of the machine hits all of them.  We aim at: engineer under 2.5 s, and at most 1.6 × the
script; under 1 MB; a formula under 2 ms.
"""

import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).parent.parent
FIGURES = """
import gc, io, pickle, sys
gc.disable()
import numpy, matplotlib.figure, matplotlib.backend_bases, reportlab.pdfgen.canvas, reportlab.pdfbase.ttfonts
import calc.design_file, calc.solve, calc.explain, reports.report
from reports.letters import FACES, widths
from reports.page import Pen
from reports.plots import Plots, plot
for face in FACES:
    widths(face)
curves = pickle.load(open(sys.argv[1], "rb"))
canvas = reportlab.pdfgen.canvas.Canvas(io.BytesIO())
for curve in curves:
    plot(Plots(), Pen(canvas, {}, {}), curve, 50.0, 50.0, 240.0, 170.0)
    canvas.showPage()
canvas.save()
"""
REPORT = """
import gc, sys
gc.disable()
from pathlib import Path
from calc.design_file import design, parse
from calc.solve import solve
from reports.report import write
raw = Path(sys.argv[1]).read_bytes()
document = parse(raw, "design.toml")
write(document, solve(design(document)), raw, Path(sys.argv[2]), depth=sys.argv[3])
"""
DRAWN = """
import pickle, sys
from pathlib import Path
from calc.design_file import load
from calc.languages import language
from calc.solve import solve
from reports.context import Context
document, design = load(sys.argv[1])
results = solve(design)
results = results.whole() if sys.argv[3] == "audit" else results
context = Context(document, results, "", sys.argv[3], language("en"))
curves = [curve for _, _, outcome in context.steps() for _, curve in context.number(outcome.curves) if sys.argv[3] != "summary"]
pickle.dump(curves, open(sys.argv[2], "wb"))
print(len(curves))
"""
FORMULAS = """
import gc, sys, time
gc.disable()
from calc.design_file import load
from calc.languages import language
from calc.solve import solve
from reports import derivation
from reports.context import Context
from reports.letters import FACES, widths
document, design = load(sys.argv[1])
context = Context(document, solve(design), "", "engineer", language("en"))
count, set_one = 0, derivation._entry
def counted(*given, **named):
    global count
    count += 1
    return set_one(*given, **named)
derivation._entry = counted
for face in FACES:
    widths(face)
chosen = [(step, context.lines(step.key)) for _, step, _ in context.steps()]
start = time.perf_counter()
for step, lines in chosen:
    derivation.derivation(context, step, lines, len(lines))
print(f"{count} formulas, {1000 * (time.perf_counter() - start) / count:.2f} ms each")
"""


def run(code: str, *arguments: str) -> str:
    return subprocess.run([sys.executable, "-c", code, *arguments], cwd=ROOT, check=True, capture_output=True, text=True).stdout.strip()


def seconds(code: str, *arguments: str) -> float:
    start = time.perf_counter()
    run(code, *arguments)
    return time.perf_counter() - start


def main() -> None:
    design = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "designs" / "r753ie4_gamma.toml")
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    with tempfile.TemporaryDirectory() as folder:
        for depth in ("summary", "engineer", "audit"):
            curves, target = str(Path(folder) / "curves"), Path(folder) / f"{depth}.pdf"
            drawn = run(DRAWN, design, curves, depth)
            pairs = [(seconds(REPORT, design, str(target), depth), seconds(FIGURES, curves)) for _ in range(rounds)]
            ours, script = (min(pair[n] for pair in pairs) for n in (0, 1))
            size = target.stat().st_size / 1e3
            script_s = f"script with its {drawn} figures {script:.2f} s"
            print(f"{depth:<9} {ours:5.2f} s   {script_s}   ratio {ours / script:.2f}   {size:5.0f} kB")
        print(run(FORMULAS, design))


if __name__ == "__main__":
    main()
