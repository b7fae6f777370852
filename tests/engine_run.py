# SPDX-License-Identifier: Apache-2.0
"""A small design with a run beside it, quick to fit: an engine alone, whose mean piston speed says its crank radius and
whose largest acceleration says the rod's length too."""

from pathlib import Path

import numpy as np

SPEEDS = np.array([1000.0, 1700.0, 2400.0])  # rpm
RADIUS, ROD = "engine.crank_radius_mm", "engine.rod_length_mm"
TRUTH = {RADIUS: 52.0, ROD: 170.0}
ENGINE = """schema = 2
name = "an engine alone"

[engine]
name = "of three"
layout = "inline"
cylinders = 3
strokes = 4
bore_mm = 94.0
crank_radius_mm = 53.5          # {remark}
rod_length_mm = 163.0
cylinder_pitch_mm = 112.0
firing_order = [1, 3, 2]
piston_mass_g = 1178.0          # of a drawing
rod_mass_g = 1015.0
rod_cg_to_big_end_mm = 50.0
rated_speed_rpm = 2600.0
"""
RUN = """
[[measurements]]
name = "{name}"
file = "{name}.csv"
speed = "n"
columns = [{{ column = "x", value = "engine.{value}"{uncertainty} }}]
"""
BOTH = {"mean_piston_speed": 0.02, "acceleration_max": 8.0}  # standard uncertainties: m/s, m/s²


def predicted(value: str, radius: float, rod: float) -> np.ndarray:
    """By the formulas of any book, in SI from mm: the exact acceleration at top dead centre is r ω² (1 + r/l)."""
    r, l, n = radius / 1e3, rod / 1e3, SPEEDS / 60
    return 4 * r * n if value == "mean_piston_speed" else r * (2 * np.pi * n) ** 2 * (1 + r / l)


def engine_run(
    folder: Path,
    fits: str,
    values: dict[str, float] = BOTH,
    *,
    noise: int | None = None,
    known: bool = True,
    remark: str = "measured on one",
    more: str = "",
    truth: dict[str, float] = TRUTH,
) -> Path:
    """The design's file.  `values`: what is measured, a run each of the same name with - for _, with its uncertainty;
    `noise`: the seed of errors of that size, None: none; `known`: whether the design says the uncertainty."""
    chance = np.random.default_rng(noise)
    text = ENGINE.format(remark=remark) + more
    for value, sigma in values.items():
        numbers = predicted(value, truth[RADIUS], truth[ROD])
        if noise is not None:
            numbers = numbers + sigma * chance.standard_normal(numbers.size)
        rows = "".join(f"{n},{x!r}\n" for n, x in zip(SPEEDS.tolist(), numbers.tolist()))
        name = value.replace("_", "-")
        (folder / f"{name}.csv").write_text(f"n,x\n{rows}")
        text += RUN.format(name=name, value=value, uncertainty=f", uncertainty = {sigma}" if known else "")
    path = folder / "design.toml"
    path.write_text(text + fits)
    return path


def fits(*rows: str, of: str = "", name: str = "engine") -> str:
    free = ", ".join("{ " + row + " }" for row in rows)
    return f'\n[[fits]]\nname = "{name}"\n{of}free = [{free}]\n'


R_ROW, L_ROW = f'key = "{RADIUS}", low = 40, high = 60', f'key = "{ROD}", low = 120, high = 250'
