# SPDX-License-Identifier: Apache-2.0
"""How long a whole report takes, as a ratio to a script that imports the same libraries and draws the same figures
once.

python bench/report.py [DESIGN] [ROUNDS]

Times are those of the processor.  The runs take turns, so that a slower moment of the machine hits all of them; a ratio
is the median of those of the single turns.  Ceiling: the engineer report at most 2.2 × the script."""

import os
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import median

ROOT = Path(__file__).parent.parent
DEPTHS = ("summary", "engineer", "audit")
FIGURES = """
import io, pickle, sys
import numpy, matplotlib.figure, matplotlib.backend_bases, reportlab.pdfgen.canvas, reportlab.pdfbase.ttfonts
import calc.design.toml_file, calc.solve, calc.studies.explain, reports.report
from reports.typesetting.fonts import FACES, widths
from reports.typesetting.pen import Pen
from calc.locale import language
from reports.figures.plots import Plots, plot
for face in FACES:
    widths(face)
curves = pickle.load(open(sys.argv[1], "rb"))
canvas = reportlab.pdfgen.canvas.Canvas(io.BytesIO())
for curve in curves:
    plot(Plots(language("en")), curve, 240.0, 170.0).place(Pen(canvas, {}, {}), 0.0, 50.0)
    canvas.showPage()
canvas.save()
"""
DRAWN = """
import pickle, sys
from pathlib import Path
from calc.design.toml_file import load
from calc.locale import language
from calc.solve import solve
from reports.context import Context
document, design = load(sys.argv[1])
results = solve(design)
results = results.whole() if sys.argv[3] == "audit" else results
context = Context(document, results, "", sys.argv[3], language("en"))
curves = [curve for _, _, outcome in context.steps() for _, curve in context.number(outcome) if sys.argv[3] != "summary"]
pickle.dump(curves, open(sys.argv[2], "wb"))
print(len(curves))
"""
FORMULAS = """
import sys, time
from calc.design.toml_file import load
from calc.locale import language
from calc.solve import solve
from reports.blocks.chapter import derivation
from reports.context import Context
from reports.typesetting.fonts import FACES, widths
document, design = load(sys.argv[1])
context = Context(document, solve(design), "", "audit", language("en"))
for face in FACES:
    widths(face)
chosen = [(step, list(outcome.lines)) for _, step, outcome in context.steps()]
count = sum(len(lines) for _, lines in chosen)
start = time.perf_counter()
for step, lines in chosen:
    derivation(context, step, lines)
print(f"{count} formulas, {1000 * (time.perf_counter() - start) / count:.2f} ms each")
"""


def run(code: str, *arguments: str) -> str:
    return subprocess.run(
        [sys.executable, "-c", code, *arguments], cwd=ROOT, check=True, capture_output=True, text=True
    ).stdout.strip()


def seconds(*command: str) -> float:
    """Processor time of a child."""
    child = subprocess.Popen([sys.executable, *command], cwd=ROOT, stdout=subprocess.DEVNULL)
    _, status, used = os.wait4(child.pid, 0)
    assert status == 0, command
    return used.ru_utime + used.ru_stime


def report(design: str, target: Path, depth: str) -> float:
    return seconds("-m", "assistant", "report", design, "-o", str(target), "--depth", depth)


def main() -> None:
    design = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "designs" / "r753ie4_gamma.toml")
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    with tempfile.TemporaryDirectory() as folder:
        for depth in DEPTHS:
            curves, target = str(Path(folder) / "curves"), Path(folder) / f"{depth}.pdf"
            drawn = run(DRAWN, design, curves, depth)
            turns = [(report(design, target, depth), seconds("-c", FIGURES, curves)) for _ in range(rounds)]
            ours, script = (median(turn[n] for turn in turns) for n in range(2))
            print(
                f"{depth:<9} {ours:5.2f} s, {target.stat().st_size / 1e3:.0f} kB; script with its {drawn} figures "
                f"{script:.2f} s: ratio {median(own / other for own, other in turns):.2f}"
                + (", ceiling 2.2" if depth == "engineer" else "")
            )
        print(run(FORMULAS, design))


if __name__ == "__main__":
    main()
