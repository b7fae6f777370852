# SPDX-License-Identifier: Apache-2.0
"""The losses of the closed balance over speed and oil temperature, all points at once; and what they cost in fuel and
CO₂.

The journals' load grows with the square of the speed, their oil comes at the temperature of the map; other losses that
are given stay. A train alone carries its torque at every speed."""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from ...sheet.arrays import Array
from ...sheet.errors import NoSolution
from ...sheet.record import record, replace
from ...sheet.step import Curve, Series, Table, axis_label
from ...sheet.text import Amount, Text
from ...sheet.units import Celsius, RevPerSecond, Watt
from ...sheet.value import untraced
from ..inputs import FrictionInputs
from ..journals import Journals, OnShaft, journals_at
from ..mesh.loss import HELICAL_POINTS, SPUR_POINTS, STRIPS
from ..power_balance import Ends, Losses, TrainDrive, drive, end_of, losses_of, shaft_loss
from ..result import carbon_dioxide, fuel

SPEEDS = 7
SLOWEST = 0.4  # of the speed of the design
COOLER, STEPS, WARMER = 40.0, 4, 10.0  # K: the temperatures around that of the design
COLDEST, HOTTEST = -20.0, 160.0
GRAM_PER_HOUR = 1e-3 / 3600
BOUND = Text(
    "Clearances as made; rolling as an upper bound, which in cold oil lies far above what a real inlet rolls; other "
    "losses that are given "
    "stay. With fewer positions than the balance: within some 0.1 % of it, 2 % where a film changes its regime."
)
AS_OIL = Text(" Teeth as warm as the oil: the measured bulk temperature is that of one point.")


@record
class Map:
    """Losses at speeds (rows) and oil temperatures (columns) in W; nan where there is no balance, `missing` says
    why."""

    speeds: Array
    temperatures: Array
    journals: Array
    mesh: Array
    wheels: Array
    masses: Array
    missing: str

    @property
    def total(self) -> Array:
        return self.journals + self.mesh + self.wheels + self.masses


def axes(friction: FrictionInputs, T: Celsius, n: RevPerSecond) -> tuple[Array, Array]:
    """Speeds and temperatures of the map; both hold those of the design, unless others are asked for."""
    low, high = friction.map_speeds or (SLOWEST * n, n)
    speeds = np.linspace(min(low, high), max(low, high), SPEEDS)
    if friction.map_temperatures is not None:
        return speeds, np.array(sorted(set(friction.map_temperatures)))
    around = np.array([T - COOLER, T - COOLER / 2, T, T + WARMER])
    return speeds, around[(around == T) | ((around >= COLDEST) & (around <= HOTTEST))]


def over_speed_and_temperature(d: TrainDrive, power: Watt | None, on: Mapping[str, OnShaft]) -> Map:
    """The map of a train whose design point is `d`."""
    n = d.wheels[d.first].speed
    speeds, temperatures = axes(d.friction, d.T_oil, n)
    grid_n, grid_T = (x.ravel() for x in np.meshgrid(speeds, temperatures, indexing="ij"))
    ratio = grid_n / n
    journals: dict[str, Journals] = {}
    good = np.ones(grid_n.shape, dtype=bool)
    with untraced(), np.errstate(all="ignore"):
        for name, shaft in on.items():
            journals[name] = journals_at(shaft, ratio, grid_T)
            good &= np.isfinite(shaft_loss(journals[name], None))
    parts = {name: np.full(grid_n.size, np.nan) for name in ("journals", "mesh", "wheels", "masses")}
    missing, bad = "", int((~good).sum())
    if bad:
        missing = Text(
            "at {sum} of {size} points a journal has no film in the range of its table", sum=bad, size=good.size
        )
    if good.any():
        try:
            ends = {
                name: end_of(d.friction, end.wheel, on[name], journals[name].only(good)) for name, end in d.ends.items()
            }
            losses = _losses(d, power, ends, ratio[good], grid_T[good])
            for name, values in parts.items():
                values[good] = getattr(losses, name)
        except NoSolution as none:
            missing = str(none)
    shape = speeds.size, temperatures.size
    by_name = {name: x.reshape(shape) for name, x in parts.items()}
    return Map(speeds=speeds, temperatures=temperatures, missing=missing, **by_name)


def _losses(d: TrainDrive, power: Watt | None, ends: Ends, ratio: Any, T: Any) -> Losses:
    spur = all(mesh.spur for mesh in d.meshes.values())
    friction = replace(d.friction, bulk_temperature=None)  # what was measured once says nothing elsewhere
    with untraced(), np.errstate(all="ignore"):
        speeds = d.wheels[d.first].speed * ratio
        points = SPUR_POINTS if spur else HELICAL_POINTS
        at_all = drive(
            friction, d.links, d.lubricant, T, speeds, ends, d.forces, d.lubrication, points=points, strips=STRIPS
        )
        return losses_of(at_all, None if power is None else power * ratio)


# --- shown


def pictures(loss_map: Map, d: TrainDrive) -> tuple[tuple[Curve, ...], tuple[Table, ...], tuple[Text, ...]]:
    """A line over the speeds for every temperature; the tables of losses, of fuel and of CO₂; what is missing."""
    if not np.isfinite(loss_map.total).any():
        return (), (), (Text("No map of losses over speed and temperature: {missing}.", missing=loss_map.missing),)
    rpm, total = loss_map.speeds * 60, loss_map.total
    labels = [Text("{T}", T=Amount(T, "°C")) for T in loss_map.temperatures.tolist()]
    n_label = axis_label("n of the first driver", "rpm")

    def lines(values: Array) -> tuple[Series, ...]:
        return tuple(Series(label, rpm, values[:, i]) for i, label in enumerate(labels))

    def by_speed(id: str, title: Text, unit: str, values: Array, note: Text) -> Table:
        columns = ((Text("n"), "rpm"), *((label, unit) for label in labels))
        rows = ((float(n), *(x if math.isfinite(x) else None for x in row)) for n, row in zip(rpm, values.tolist()))
        return Table(id, title, columns, tuple(rows), note)

    at = int(np.argmin(np.abs(loss_map.temperatures - d.T_oil)))
    parts = tuple(
        Series(label, rpm, part[:, at])
        for label, part in (
            (Text("journals of the counter-shaft"), loss_map.journals),
            (Text("meshes"), loss_map.mesh),
            (Text("wheels"), loss_map.wheels),
            (Text("turning masses"), loss_map.masses),
        )
        if np.any(part[:, at] != 0)
    )
    of_losses, of_parts = (
        Text("Power lost over speed and oil temperature"),
        Text("What loses it, oil at {labels}", labels=labels[at]),
    )
    curves = [
        Curve("over_speed", of_losses, n_label, axis_label("P", "W"), lines(total)),
        Curve("over_speed_parts", of_parts, n_label, axis_label("P", "W"), parts),
    ]
    note = BOUND + (AS_OIL if d.friction.bulk_temperature is not None else "")
    tables = [by_speed("map", of_losses, "W", total, note)]
    b_e, e_CO2 = d.friction.specific_fuel_consumption, d.friction.co2_per_fuel
    if b_e is not None:
        with untraced():
            m_B = fuel(b_e=b_e, P=total)
            m_CO2 = carbon_dioxide(e_CO2=e_CO2, m_B=m_B)
        of_fuel, burnt = Text("Fuel that the losses cost"), m_B / GRAM_PER_HOUR
        curves.append(Curve("over_speed_fuel", of_fuel, n_label, axis_label("m_B", "g/h"), lines(burnt)))
        note = Text("At {b_e} g/kWh at every point of the map.", b_e=Amount(b_e * 3600000000.0))
        tables.append(by_speed("map_fuel", of_fuel, "g/h", burnt, note))
        note = Text("{co2_per_fuel} kg per kg of fuel, burnt completely.", co2_per_fuel=Amount(e_CO2))
        tables.append(by_speed("map_co2", Text("CO₂ of that fuel"), "g/h", m_CO2 / GRAM_PER_HOUR, note))
    missing = (Text("Map of losses: {missing}.", missing=loss_map.missing),) if loss_map.missing else ()
    return tuple(curves), tuple(tables), missing
