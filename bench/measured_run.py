# SPDX-License-Identifier: Apache-2.0
"""Makes designs/measured_drag.csv anew: `python -m bench.measured_run`.

It is no measurement: drag and oil flow of solution gamma as the program predicts them with clearances of 95 and 75 µm,
with noise from a seed.  Where the model moves, it moves with it."""

import math
from pathlib import Path

import numpy as np

from calc.design.disk import write_file
from calc.design.predicted import at_speed
from calc.design.predicted_runs import changed_design
from calc.design.toml_file import load_design
from calc.sheet.value import recorded
from calc.solve import solve
from calc.studies.shipped import DESIGNS

FILE = DESIGNS / "measured_drag.csv"
SEED = 753
SPEEDS = (900, 1200, 1500, 1800, 2100, 2400, 2600)  # rpm
CLEARANCES = {"front": 95.0, "rear": 75.0}  # µm
DRAG, DRAG_SHARE, FLOW = 2.0, 0.016, 0.05  # standard uncertainties: W, of what is shown, L/min
HEAD = """# SYNTHETIC: made by the program from r753ie4_gamma with clearances 95 and 75 um, noise seed 753; no measurement
# oil and its pressure as the engine's bench run has them; made by bench/measured_run.py
speed;drag_power;sd_drag;oil_flow
rpm;W;W;L/min
"""


def run() -> str:
    """The file."""
    design, rng, rows = load_design(DESIGNS / "r753ie4_gamma.toml"), np.random.default_rng(SEED), [HEAD]
    for name, clearance in CLEARANCES.items():
        key = f"shafts.shaft.bearings.{name}."
        design = changed_design(design, {f"{key}clearance_um": clearance, f"{key}clearance_factor": None})
    with recorded(False):
        for speed in SPEEDS:
            values = solve(at_speed(design, speed / 60, {}), compared=False).values()
            drag = values["friction.bearing_loss"].shown
            flow = sum(values[f"bearings.{name}.oil_flow"].shown for name in CLEARANCES)
            sd = math.hypot(DRAG, DRAG_SHARE * drag)
            drag, flow = drag + sd * rng.standard_normal(), flow + FLOW * rng.standard_normal()
            rows.append(f"{speed};{drag:.3f};{sd:.3f};{flow:.4f}\n")
    return "".join(rows)


if __name__ == "__main__":
    write_file(Path(FILE), run().encode())
    print(FILE)
