# SPDX-License-Identifier: Apache-2.0
"""The film over the engine's speeds: where it is thinnest is found, not assumed."""

from dataclasses import replace

import numpy as np

from ..engine.inputs import BenchPoint
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
    thinnest_speed: float
    thinnest_film: float

    def curve(self, place: str, limit: float) -> Curve:
        rpm, film = np.array(self.speeds) * 60, np.array(self.films) * 1e6
        return Curve(
            f"film_{place}", f"Smallest film of the {place} bearing over speed, warm", "speed, rpm", "h_0, µm",
            (Series("film", rpm, film),), limits=(("Kreisle", limit * 1e6),),
        )  # fmt: skip


def sweep(seat: Seat, load: float, rated: float, bench: tuple[BenchPoint, ...], duty: Duty) -> Sweep:
    """The film at each row of the bench run, or over 0.4 to 1 of the rated speed with the design's oil supply.

    The load grows with the square of the speed; the clearance is made once and warm at each speed's temperature.  Rows above the
    rated speed are run without load on the engine: they are shown, and do not govern.
    """
    if bench:
        rows = sorted((row.speed, row.oil_temperature, row.oil_pressure) for row in bench)
    else:
        rows = [(rated * x, duty.supply_temperature, duty.supply_pressure) for x in np.linspace(SLOWEST, 1, STEPS_WITHOUT_BENCH).tolist()]
    found = []
    with untraced():
        for speed, temperature, pressure in rows:
            at = replace(
                duty, load=load * (speed / rated) ** 2, speed=speed, effective_speed=duty.effective_speed * speed / rated,
                supply_temperature=temperature, supply_pressure=pressure,
            )  # fmt: skip
            found.append((speed, balanced(own_warm, seat, at, tolerance=1e-7).film))
    governing = [row for row in found if row[0] <= rated * (1 + 1e-9)] or found
    speed, film = min(governing, key=lambda row: row[1])
    return Sweep(tuple(s for s, _ in found), tuple(h for _, h in found), speed, film)
