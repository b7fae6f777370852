# SPDX-License-Identifier: Apache-2.0
"""The corners of the tolerances: smallest and largest journal, smallest and largest seat, thinner and thicker oil, each solved."""

from dataclasses import replace
from itertools import product
from typing import Any

import numpy as np

from ..fits import deviations, parse
from ..sheet.quantity import result, value
from ..sheet.step import Table
from ..sheet.units import Celsius, Metre, Watt
from . import formulas as f
from .inputs import BearingsInputs
from .routes.states import Duty, Film, Seat

ENDS = (("smallest", -1), ("largest", 1))
OILS = (("thinner", -1), ("thicker", 1))
CORNERS = tuple(product(ENDS, ENDS, OILS))
NAMES = tuple(f"{j} journal, {s} seat, {o} oil" for (j, _), (s, _), (o, _) in CORNERS)


@result
class Corners:
    """The worst of the eight corners, each quantity for itself; `names` and `films` hold all of them."""

    clearance_min: Metre = value("Smallest clearance of the fits", "µm", "g_min")
    clearance_max: Metre = value("Largest clearance of the fits", "µm", "g_max")
    clearance_cold: Metre = value("Smallest clearance at the lowest temperature", "µm", "g_cold")
    film: Metre = value("Thinnest film of the corners", "µm", "h_0")
    film_edge: Metre = value("Thinnest film at the edge of the corners", "µm", "h_edge")
    film_double_load: Metre = value("Thinnest film at twice the load of the corners", "µm", "h_2F")
    outlet_temperature: Celsius = value("Hottest outlet of the corners", "°C", "T_out")
    friction_power: Watt = value("Largest friction power of the corners", "W", "P_f")
    names: tuple[str, ...]
    columns: dict[str, Any]  # one array over the corners for each quantity above and more

    def worst(self, quantity: str) -> str:
        """The name of the corner that governs: the hottest, else the smallest; a corner without film is worst of all."""
        numbers = self.columns[quantity]
        if np.isnan(numbers).any():
            return self.names[int(np.isnan(numbers).argmax())]
        return self.names[int(numbers.argmax() if quantity == "outlet_temperature" else numbers.argmin())]


def widths(inputs: BearingsInputs, d: Metre) -> tuple[Metre, Metre]:
    """Of the journal's and the seat's tolerance."""
    (low_J, high_J), (low_S, high_S) = (deviations(parse(fit), d) for fit in (inputs.journal_fit, inputs.seat_fit))
    return high_J - low_J, high_S - low_S


def corner_points(seat: Seat, duty: Duty) -> tuple[Seat, Duty]:
    """Eight corners at the load, then the eight at twice the load."""
    g, thickness = _corners(seat)
    both: Any = np.tile(g, 2)
    thick: Any = np.tile(thickness, 2)
    load: Any = duty.load * np.repeat([1.0, 2.0], len(g))
    return replace(seat, clearance=both, viscosity_factor=thick), replace(duty, load=load)


def _corners(seat: Seat) -> tuple[Any, Any]:
    """Clearance at the reference temperature and viscosity factor of each."""
    T_J, T_S = widths(seat.inputs, seat.bearing.diameter)
    g = [seat.clearance + (s * T_S - j * T_J) / 2 for (_, j), (_, s), _ in CORNERS]
    return np.array(g), np.array([1 + o * seat.inputs.viscosity_tolerance for *_, (_, o) in CORNERS])


def corners(seat: Seat, duty: Duty, edge: float, film: Film) -> Corners:
    """`film`: of the corner points.  `edge`: what the slope takes from the film at the edge."""
    T_J, T_S = widths(seat.inputs, seat.bearing.diameter)
    least = f.least_clearance(g=seat.clearance, T_S=T_S, T_J=T_J)
    most = f.most_clearance(g=seat.clearance, T_S=T_S, T_J=T_J)
    g, _ = _corners(seat)
    once, twice = slice(0, len(g)), slice(len(g), None)
    rise: Any = film.temperature_rise
    h_0: Any = film.film
    warm: Any = film.clearance
    power: Any = film.friction_power
    columns = {
        "clearance": g,
        "clearance_cold": np.asarray(replace(seat, clearance=g).clearance_at(seat.inputs.lowest_temperature)),
        "clearance_hot": np.where(np.isfinite(h_0[once]), warm[once], np.nan),
        "film": h_0[once],
        "film_edge": h_0[once] - edge,
        "film_double_load": h_0[twice],
        "outlet_temperature": duty.supply_temperature + rise[once],
        "friction_power": power[once],
    }
    return Corners(
        clearance_min=least,
        clearance_max=most,
        clearance_cold=f.smallest_of_corners(x=columns["clearance_cold"]),
        film=f.smallest_of_corners(x=columns["film"]),
        film_edge=f.smallest_of_corners(x=columns["film_edge"]),
        film_double_load=f.smallest_of_corners(x=columns["film_double_load"]),
        outlet_temperature=f.hottest_of_corners(T=columns["outlet_temperature"]),
        friction_power=f.largest_power_of_corners(P=columns["friction_power"]),
        names=NAMES,
        columns=columns,
    )


COLUMNS = (
    ("clearance", "g", "µm", 1e-6), ("clearance_cold", "g cold", "µm", 1e-6), ("clearance_hot", "g hot", "µm", 1e-6),
    ("film", "h_0", "µm", 1e-6), ("film_edge", "h_edge", "µm", 1e-6), ("film_double_load", "h_2F", "µm", 1e-6),
    ("outlet_temperature", "T_out", "°C", 1.0), ("friction_power", "P_f", "W", 1.0),
)  # fmt: skip


def corners_table(place: str, found: Corners, inputs: BearingsInputs) -> Table:
    """All corners of one bearing; a cell without film is empty."""

    def cell(name: str, row: int, factor: float) -> float | None:
        number = float(found.columns[name][row])
        return number / factor if np.isfinite(number) else None

    return Table(
        f"corners_{place}",
        f"Corners of the tolerances, {place} bearing",
        (("corner", ""), *((label, unit) for _, label, unit, _ in COLUMNS)),
        tuple((name, *(cell(key, i, factor) for key, _, _, factor in COLUMNS)) for i, name in enumerate(found.names)),
        f"Journal {inputs.journal_fit}, seat {inputs.seat_fit} about the clearance at its reference temperature; oil ± "
        f"{inputs.viscosity_tolerance * 100:g} % of its viscosity.",
        (f"bearings.{place}.corners.",),
    )
