# SPDX-License-Identifier: Apache-2.0
"""The film over the engine's speeds: where it is thinnest is found, not assumed."""

import math
from dataclasses import replace

import numpy as np

from ..engine.inputs import BenchPoint
from ..sheet.errors import NoSolution
from ..sheet.record import record
from ..sheet.step import Curve, Series
from ..sheet.trace import untraced
from .routes import Duty, Seat, balanced, own_warm

STEPS_WITHOUT_BENCH = 12
SLOWEST = 0.4  # of the rated speed


@record
class Sweep:
    speeds: tuple[float, ...]
    films: tuple[float, ...]
    thinnest_speed: float | None  # None where no row has a film in the range of the table
    thinnest_film: float | None

    def curve(self, place: str, limit: float, edge: float) -> Curve:
        """`edge`: what the journal's slope takes from the film at the bearing's edge."""
        rpm, film = np.array(self.speeds) * 60, np.array(self.films) * 1e6
        return Curve(
            f"film_{place}", f"Smallest film of the {place} bearing over speed, warm", "speed, rpm", "h_0, µm",
            (Series("mid-bearing", rpm, film), Series("at the edge", rpm, film - edge * 1e6)), limits=(("Kreisle", limit * 1e6),),
        )  # fmt: skip


def sweep(seat: Seat, load: float, rated: float, bench: tuple[BenchPoint, ...], duty: Duty) -> Sweep:
    """The film at each row of the bench run, or over 0.4 to 1 of the rated speed with the design's oil supply.

    The load grows with the square of the speed; the clearance is made once and warm at each speed's temperature.  Rows above the
    rated speed are run without load on the engine: they are shown, and do not govern.
    """
    rows = sorted((row.speed, row.oil_temperature, row.oil_pressure) for row in bench)
    if not any(row[0] <= rated * (1 + 1e-9) for row in rows):
        steps = np.linspace(SLOWEST, 1, STEPS_WITHOUT_BENCH).tolist()
        rows = [(rated * x, duty.supply_temperature, duty.supply_pressure) for x in steps] + rows
    found = []
    with untraced():
        for speed, temperature, pressure in rows:
            at = replace(
                duty,
                load=load * (speed / rated) ** 2,
                speed=speed,
                effective_speed=duty.effective_speed * speed / rated,
                supply_temperature=temperature,
                supply_pressure=pressure,
            )
            try:
                found.append((speed, balanced(own_warm, seat, at, tolerance=1e-5).film))
            except NoSolution:
                found.append((speed, math.nan))  # shown as a gap: overloaded, or hardly loaded
    governing = [row for row in found if row[0] <= rated * (1 + 1e-9) and math.isfinite(row[1])]
    thinnest = min(governing, key=lambda row: row[1], default=(None, None))
    return Sweep(tuple(s for s, _ in found), tuple(h for _, h in found), *thinnest)
