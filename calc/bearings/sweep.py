# SPDX-License-Identifier: Apache-2.0
"""The film over the speeds: where it is thinnest is found, not assumed."""

from dataclasses import replace
from typing import Any

import numpy as np

from ..engine.inputs import BenchPoint
from ..sheet.record import record
from .inputs import BearingsInputs
from .routes.states import Duty, Film, Seat

STEPS_WITHOUT_BENCH = 25
BETWEEN = 2  # further points between two rows of the bench run, its oil interpolated
SLOWEST = 0.4  # of the rated speed
TURNING = 1.0  # a load that turns with the journal is that of eccentric masses


@record
class Sweep:
    """Rows in order of speed.  The thinnest is None where no row that governs has a film in the range of the table."""

    speeds: tuple[float, ...]
    temperatures: tuple[float, ...]  # of the oil supplied
    pressures: tuple[float, ...]
    rises: tuple[float, ...]
    films: tuple[float, ...]
    friction: tuple[float, ...]
    thinnest: int | None  # the row
    thinnest_speed: float | None
    thinnest_film: float | None
    rated: float
    bench: bool  # its rows are those of the engine's bench run

    def gaps(self, place: str) -> str:
        """The speeds without a film in the range of the table; empty where each has one."""
        missing = [n for n, film in zip(self.speeds, self.films) if not np.isfinite(film)]
        if not missing:
            return ""
        span = f"from {min(missing) * 60:.0f} to {max(missing) * 60:.0f} rpm" if len(missing) > 1 else f"at {missing[0] * 60:.0f} rpm"
        return f"At {len(missing)} of the speeds, {span}, no film of the {place} bearing is found: the thinnest is that of the others."

    def why(self, place: str) -> str:
        """Why the thinnest film is not that of the highest speed; empty where it is."""
        if self.thinnest is None or self.thinnest_speed is None or self.thinnest_film is None:
            return ""
        last = max(i for i, film in enumerate(self.films) if np.isfinite(film))
        here = self.thinnest
        if last == here:
            return ""
        fastest = f"{self.speeds[last] * 60:.0f} rpm, whose oil comes at {self.temperatures[last]:.1f} °C"
        above = self.bench and self.speeds[last] > self.rated * (1 + 1e-9)
        unloaded = " (above the rated speed: run without load, it does not govern)" if above else ""
        return (
            f"The {place} bearing's film is thinnest at {self.thinnest_speed * 60:.0f} rpm, {self.thinnest_film * 1e6:.2f} µm with oil of "
            f"{self.temperatures[here]:.1f} °C, and not at {fastest}{unloaded}."
        )


def sweep_points(seat: Seat, rated: float, bench: tuple[BenchPoint, ...], duty: Duty) -> tuple[Seat, Duty]:
    """Each row of the bench run and between them, or a range of speed with the design's oil supply.

    A load that turns with the journal grows with the square of the speed, any other stays; the clearance is made once and warm at each
    speed's temperature.
    """
    speeds, temperatures, pressures = _rows(rated, bench, duty, seat.inputs)
    ratio = speeds / rated
    turns = seat.inputs.load_speed_ratio == TURNING
    return seat, replace(
        duty,
        load=duty.load * ratio**2 if turns else duty.load,
        speed=speeds,
        effective_speed=duty.effective_speed * ratio,
        supply_temperature=temperatures,
        supply_pressure=pressures,
    )


def sweep(rated: float, inputs: BearingsInputs, bench: bool, at: Duty, film: Film) -> Sweep:
    """`at`, `film`: the points.  Bench rows above the rated speed are run without load: they are shown, and do not govern."""
    speeds: Any = at.speed
    temperatures: Any = at.supply_temperature
    pressures: Any = at.supply_pressure
    h_0: Any = film.film
    rises: Any = film.temperature_rise
    power: Any = film.friction_power
    governing = np.where(speeds <= (rated if inputs.speed_range is None else np.inf) * (1 + 1e-9), h_0, np.nan)
    found = not np.isnan(governing).all()
    least = int(np.nanargmin(governing)) if found else 0
    return Sweep(
        tuple(speeds.tolist()), tuple(temperatures.tolist()), tuple(pressures.tolist()), tuple(rises.tolist()), tuple(h_0.tolist()),
        tuple(power.tolist()),
        least if found else None, float(speeds[least]) if found else None, float(governing[least]) if found else None, rated,
        inputs.speed_range is None and bench,
    )  # fmt: skip


def _rows(rated: float, bench: tuple[BenchPoint, ...], duty: Duty, inputs: BearingsInputs) -> tuple[Any, Any, Any]:
    """Speeds in order, with the temperature and pressure of the oil supplied."""
    rows = np.array(sorted((row.speed, row.oil_temperature, row.oil_pressure) for row in bench)).reshape(-1, 3)
    if inputs.speed_range is None and (rows[:, 0] <= rated * (1 + 1e-9)).any():
        place = np.linspace(0, len(rows) - 1, (len(rows) - 1) * (BETWEEN + 1) + 1)
        loaded = place <= (rows[:, 0] <= rated * (1 + 1e-9)).sum() - 1  # between a loaded and an unloaded row nothing is known
        place = place[loaded | (place == np.round(place))]
        return tuple(np.interp(place, np.arange(len(rows)), rows[:, i]) for i in range(3))
    low, high = inputs.speed_range or (SLOWEST * rated, rated)
    speeds = np.linspace(low, high, STEPS_WITHOUT_BENCH)
    if inputs.speed_range is None and len(rows):
        speeds = np.append(speeds, rows[:, 0])
    own = np.full(speeds.shape, 1.0)
    temperatures, pressures = duty.supply_temperature * own, duty.supply_pressure * own
    if inputs.speed_range is None and len(rows):
        temperatures[-len(rows) :], pressures[-len(rows) :] = rows[:, 1], rows[:, 2]
    return speeds, temperatures, pressures
