# SPDX-License-Identifier: Apache-2.0
"""Runs of the bench: what was measured over speed, as nodes with their uncertainty, and what their residuals come to.

The room knows no design.  What it takes to hold a run against one stands above it:

- `inputs.py`: [[measurements]], as a design has them (`design.measurements`);
- `reading.py`, `rows.py`: a file, and its rows that are used (`design.runs`, read with the design by
  `design/run_files.py`);
- `nodes.py`: the rows as nodes, each with mean, standard uncertainty and the error that all share;
- `residuals.py`: what predicted less measured comes to: bias, χ², runs, verdict;
- `design/predicted_runs.py`: what a design gives at the nodes.

For a fit, in `design/predicted_runs.py` (`solve` is that of `calc.solve`, `solved` its results of the design as it is):

    wanted = targets(design, solved, ["drag-run"])  # one Target a column: y, sigma, common node by node, in its unit
    changed = changed_design(design, {"shafts.shaft.bearings.front.clearance_um": 95.0, "….clearance_factor": None})
    rows = predictions(changed, wanted, solve)  # one array a target, NaN where the design finds no solution

sigma and common are None where none is given; `common` has the sign that an error of all nodes together would have.
"""
