# SPDX-License-Identifier: Apache-2.0
"""The film over the speeds: where it is thinnest is found, not assumed."""

from typing import Any

import numpy as np

from ...countershaft.rows import called
from ...engine.inputs import EngineInputs
from ...engine.operation import BenchPoint
from ...sheet.arrays import Array
from ...sheet.linked_array import elements, gathered, item, linked_array
from ...sheet.record import record, replace
from ...sheet.text import EMPTY, Amount, Text
from ...sheet.units import Number, RevPerSecond
from ...sheet.value import based_on, joined_links
from ..inputs import BearingsInputs
from .routes.states import BearingCase, Film, OperatingPoint

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
    rated: float
    governing: float  # the highest speed that governs
    bench: bool  # its rows are those of the engine's bench run
    given: bool  # the engine runs at these speeds: they are not assumed
    lost: float | None  # of those that govern and ask for more than the rated one, the first that no film carries

    def gaps(self, place: str) -> Text:
        """The speeds without a film in the range of the table; empty where each has one."""
        missing = [n for n, film in zip(self.speeds, self.films) if not np.isfinite(film)]
        if not missing:
            return EMPTY
        low, high = (Amount(n * 60, form=".0f") for n in (min(missing), max(missing)))
        span = Text("at {missing} rpm", missing=low)
        if len(missing) > 1:
            span = Text("from {missing} to {missing2} rpm", missing=low, missing2=high)
        return Text(
            "At {count} of the speeds, {span}, no film of the {place} bearing is found: the thinnest is that of the "
            "others.",
            count=len(missing),
            span=span,
            place=called(place),
        )

    def why(self, place: str) -> Text:
        """Why the thinnest film is not that of the highest speed; empty where it is."""
        here, last = self.thinnest, max((i for i, film in enumerate(self.films) if np.isfinite(film)), default=None)
        if here is None or last is None or here == last:
            return EMPTY
        speed, oil = Amount(self.speeds[last] * 60, form=".0f"), Amount(self.temperatures[last], form=".1f")
        fastest = Text("{speeds} rpm, whose oil comes at {temperatures} °C", speeds=speed, temperatures=oil)
        above = self.speeds[last] > self.governing * (1 + 1e-9)
        unloaded = Text(" (above the rated speed: run without load, it does not govern)") if above else ""
        return Text(
            "The {place} bearing's film is thinnest at {thinnest_speed} rpm, {thinnest_film} µm with oil of "
            "{temperatures} °C, and not at {fastest}{unloaded}.",
            place=called(place),
            thinnest_speed=Amount(self.speeds[here] * 60, form=".0f"),
            thinnest_film=Amount(self.films[here] * 1e6, form=".2f"),
            temperatures=Amount(self.temperatures[here], form=".1f"),
            fastest=fastest,
            unloaded=unloaded,
        )


def sweep_points(
    seat: BearingCase, rated: float, bench: tuple[BenchPoint, ...], duty: OperatingPoint
) -> tuple[BearingCase, OperatingPoint[Any]]:
    """Each row of the bench run and between them, or a range of speed with the design's oil supply.

    A load that turns with the journal grows with the square of the speed, any other stays; the clearance is made once
    and warm at each speed's temperature."""
    speeds, temperatures, pressures = _rows(rated, bench, duty, seat.inputs)
    return seat, at_speeds(seat, rated, duty, speeds, temperatures, pressures)


def at_speeds(
    seat: BearingCase, rated: float, duty: OperatingPoint[Any], speeds: Array, temperatures: Array, pressures: Array
) -> OperatingPoint[Any]:
    """The same bearing at other speeds with the oil that is supplied there."""
    ratio = speeds / rated
    turns = seat.inputs.load_speed_ratio == TURNING
    return replace(
        duty,
        load=(duty.load * ratio**2) if turns else duty.load,
        speed=speeds,
        effective_speed=duty.effective_speed * ratio,
        supply_temperature=temperatures,
        supply_pressure=pressures,
    )


def of_journals(engine: EngineInputs, speed_ratio: Number | None) -> tuple[RevPerSecond, tuple[BenchPoint, ...]]:
    """The rated speed and the bench run of an engine, which are the crank's, by the speed of the journals of a shaft;
    None: they turn as fast as the crank."""
    if speed_ratio is None or abs(speed_ratio) == 1:
        return engine.rated_speed, engine.gallery
    i = abs(speed_ratio)
    bench = [replace(row, speed=based_on(i * row.speed, row.speed, speed_ratio)) for row in engine.gallery]
    return based_on(i * engine.rated_speed, engine.rated_speed, speed_ratio), tuple(bench)


def highest_speed(rated: RevPerSecond, bench: tuple[BenchPoint, ...], inputs: BearingsInputs | None) -> RevPerSecond:
    """Of those that the engine runs at: rated, on the bench, or in the range that is given."""
    given = inputs.speed_range[1:] if inputs is not None and inputs.speed_range is not None else ()
    return max([rated, *(row.speed for row in bench), *given])


def sweep(
    rated: float, inputs: BearingsInputs, bench: tuple[BenchPoint, ...], at: OperatingPoint[Any], film: Film[Array]
) -> Sweep:
    """`at`, `film`: the points.  On bench rows above the rated speed the engine gives no torque: where the load is not
    that of turning masses, they are shown and do not govern."""
    speeds, temperatures, pressures = at.speed, at.supply_temperature, at.supply_pressure
    h_0, rises, power = film.film, film.temperature_rise, film.friction_power
    all_govern = inputs.speed_range is not None or inputs.load_speed_ratio == TURNING
    governs = speeds <= (np.inf if all_govern else rated * (1 + 1e-9))
    governing = np.where(governs, h_0, np.nan)
    thinnest = None if np.isnan(governing).all() else int(np.nanargmin(governing))
    at_thinnest = None
    if thinnest is not None:
        at_thinnest = based_on(item(speeds[thinnest]), speeds[thinnest], inputs.load_speed_ratio)
    # a load that turns grows faster than the film does; one that stays is carried less the slower it is
    heavier = speeds > rated if inputs.load_speed_ratio == TURNING else speeds < rated
    lost = np.asarray(speeds)[governs & heavier & np.isnan(h_0)]
    return Sweep(
        elements(speeds),
        elements(temperatures),
        elements(pressures),
        elements(rises),
        elements(h_0),
        elements(power),
        thinnest,
        at_thinnest,
        rated,
        float(np.max(speeds[governs])),
        inputs.speed_range is None and bool(bench),
        inputs.speed_range is not None or any(all_govern or row.speed <= rated * (1 + 1e-9) for row in bench),
        min(lost.tolist(), key=lambda speed: abs(speed - rated), default=None),
    )


def _rows(
    rated: float, bench: tuple[BenchPoint, ...], duty: OperatingPoint, inputs: BearingsInputs
) -> tuple[Array, Array, Array]:
    """Speeds in order, with the temperature and pressure of the oil supplied: three arrays of shape (n,)."""
    of_rows = (
        tuple(map(gathered, zip(*sorted((row.speed, row.oil_temperature, row.oil_pressure) for row in bench))))
        or (np.zeros(0),) * 3
    )
    rows = np.stack(of_rows, 1)
    with_bench, under_load = inputs.speed_range is None and len(rows) > 0, rows[:, 0] <= rated * (1 + 1e-9)
    if with_bench and under_load.any():
        place = np.linspace(0, len(rows) - 1, (len(rows) - 1) * (BETWEEN + 1) + 1)
        loaded = place <= under_load.sum() - 1  # between a loaded and an unloaded row nothing is known
        there = loaded | (place == np.round(place))
        speeds, temperatures, pressures = (_between(place[there], column) for column in of_rows)
        return speeds, temperatures, pressures
    low, high = inputs.speed_range or (SLOWEST * rated, rated)
    speeds = based_on(np.linspace(low, high, STEPS_WITHOUT_BENCH), low, high)
    T_in, p_s = duty.supply_temperature, duty.supply_pressure
    temperatures = based_on(np.full(speeds.shape, T_in), T_in)
    pressures = based_on(np.full(speeds.shape, p_s), p_s)
    if with_bench:
        speeds, temperatures, pressures = (
            gathered([*alone, *row]) for alone, row in zip((speeds, temperatures, pressures), of_rows)
        )
    return speeds, temperatures, pressures


def _between(place: Array, numbers: Array) -> Array:
    """Numbers of a row at whole and broken places, linear between, each with the links of those on either side of
    it."""
    parts = getattr(numbers, "parts", ())
    low, high = np.floor(place).astype(int), np.ceil(place).astype(int)
    links = tuple(joined_links((parts[i], parts[k])) for i, k in zip(low, high)) if parts else ()
    between: Array = linked_array(np.interp(place, np.arange(len(numbers)), numbers), joined_links(links), links)
    return between
