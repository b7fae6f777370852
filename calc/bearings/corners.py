# SPDX-License-Identifier: Apache-2.0
"""The corners of the tolerances: smallest and largest journal, smallest and largest seat, thinner and thicker oil, each solved."""

from dataclasses import replace
from itertools import product
from typing import Any

import numpy as np

from ..fits import deviations, parse, tolerance
from ..sheet.quantity import result, value
from ..sheet.step import Table
from ..sheet.trace import about
from ..sheet.units import Celsius, Metre, Radian
from . import formulas as f
from .inputs import BearingsInputs
from .routes.routes import own_warm
from .routes.states import Duty, Film, Seat

ENDS = (("smallest", -1), ("largest", 1))
OILS = (("thinner", -1), ("thicker", 1))
CORNERS = tuple(product(ENDS, ENDS, OILS))
NAMES = (  # in the order of CORNERS, written out: adjectives are inflected in other languages
    "smallest journal, smallest seat, thinner oil", "smallest journal, smallest seat, thicker oil",
    "smallest journal, largest seat, thinner oil", "smallest journal, largest seat, thicker oil",
    "largest journal, smallest seat, thinner oil", "largest journal, smallest seat, thicker oil",
    "largest journal, largest seat, thinner oil", "largest journal, largest seat, thicker oil",
)  # fmt: skip


@result
class Corners:
    """The worst of the eight corners, each quantity for itself; None: a corner has no film."""

    clearance_min: Metre = value("Smallest clearance of the fits", "µm", "g_min")
    clearance_max: Metre = value("Largest clearance of the fits", "µm", "g_max")
    clearance_cold: Metre = value("Smallest clearance at the lowest temperature", "µm", "g_cold")
    film: Metre | None = value("Thinnest film of the corners", "µm", "h_0")
    film_edge: Metre | None = value("Thinnest film at the edge of the corners", "µm", "h_edge")
    film_double_load: Metre | None = value("Thinnest film at twice the load of the corners", "µm", "h_2F")
    outlet_temperature: Celsius | None = value("Hottest outlet of the corners", "°C", "T_out")
    names: tuple[str, ...]
    columns: dict[str, Any]  # one array over the corners for each quantity above and more

    def worst(self, quantity: str) -> str:
        """The name of the corner that governs."""
        return self.names[_worst(quantity, self.columns[quantity])]


def limits(inputs: BearingsInputs, d: Metre, g: Metre) -> tuple[tuple[Metre, Metre], tuple[Metre, Metre]]:
    """Lower and upper deviation of the journal, and of the seat.  Fits without a place lie about the middle of clearance `g`."""
    journal, seat = parse(inputs.journal_fit), parse(inputs.seat_fit)
    if journal.letter is not None and seat.letter is not None:
        return deviations(journal, d), deviations(seat, d)
    half_J, half_S = tolerance(journal.grade, d) / 2, tolerance(seat.grade, d) / 2
    return (-half_J, half_J), (g - half_S, g + half_S)


def widths(inputs: BearingsInputs, d: Metre) -> tuple[Metre, Metre]:
    """Of the journal's and the seat's tolerance."""
    return tolerance(parse(inputs.journal_fit).grade, d), tolerance(parse(inputs.seat_fit).grade, d)


def corner_points(seat: Seat, duty: Duty) -> tuple[Seat, Duty]:
    """Eight corners at the load, then the eight at twice the load."""
    g, thickness = _corners(seat)
    both: Any = np.tile(g, 2)
    thick: Any = np.tile(thickness, 2)
    load: Any = duty.load * np.repeat([1.0, 2.0], len(g))
    return replace(seat, clearance=both, viscosity_factor=thick), replace(duty, load=load)


def _corners(seat: Seat) -> tuple[Any, Any]:
    """Clearance at the reference temperature and viscosity factor of each."""
    journal, hole = limits(seat.inputs, seat.bearing.diameter, seat.clearance)
    g = [hole[s > 0] - journal[j > 0] for (_, j), (_, s), _ in CORNERS]
    return np.array(g), np.array([1 + o * seat.inputs.viscosity_tolerance for *_, (_, o) in CORNERS])


def corners(seat: Seat, duty: Duty, slope: Radian, film: Film, bearing: str = "bearing") -> Corners:
    """`film`: of the corner points.  The worst corner of the film, of twice the load and of the heat is solved once more, line by line,
    under the name of the `bearing`."""
    (ei, es), (EI, ES) = limits(seat.inputs, seat.bearing.diameter, seat.clearance)
    if parse(seat.inputs.journal_fit).letter is None or parse(seat.inputs.seat_fit).letter is None:
        least = f.least_clearance(g=seat.clearance, T_S=ES - EI, T_J=es - ei)
        most = f.most_clearance(g=seat.clearance, T_S=ES - EI, T_J=es - ei)
    else:
        least = f.least_clearance_of_fits(EI=EI, es=es)
        most = f.most_clearance_of_fits(ES=ES, ei=ei)
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
        "film_edge": h_0[once] - slope * seat.bearing.length / 2,
        "film_double_load": h_0[twice],
        "outlet_temperature": duty.supply_temperature + rise[once],
        "friction_power": power[once],
    }

    def solved(quantity: str, at: Duty, points: slice) -> Film | None:
        """The worst corner by lines of the calculation, at the rise that is known; None where it has no film."""
        numbers = columns[quantity]
        if np.isnan(numbers).any():
            return None
        worst = _worst(quantity, numbers)
        (_, j), (_, s), (_, o) = CORNERS[worst]
        clearance = least if j > s else most if s > j else float(g[worst])
        factor = f.viscosity_factor(t_nu=seat.inputs.viscosity_tolerance, o=float(o))
        return own_warm(replace(seat, clearance=clearance, viscosity_factor=factor), at, float(rise[points][worst]))

    with about(f"{bearing}, thinnest corner"):
        thinnest = solved("film_edge", duty, once)
    with about(f"{bearing}, thinnest corner at twice the load"):
        doubled = solved("film_double_load", replace(duty, load=2 * duty.load), twice)
    with about(f"{bearing}, hottest corner"):
        hottest = solved("outlet_temperature", duty, once)
    edge = None if thinnest is None else f.film_at_edge(h_0=thinnest.film, theta=slope, l=seat.bearing.length)
    outlet = None if hottest is None else f.outlet_temperature(T_in=duty.supply_temperature, Delta_T=hottest.temperature_rise)
    return Corners(
        clearance_min=least,
        clearance_max=most,
        clearance_cold=replace(seat, clearance=least).clearance_at(seat.inputs.lowest_temperature),
        film=None if thinnest is None else thinnest.film,
        film_edge=edge,
        film_double_load=None if doubled is None else doubled.film,
        outlet_temperature=outlet,
        names=NAMES,
        columns=columns,
    )


def _worst(quantity: str, numbers: Any) -> int:
    """The hottest, else the smallest; a corner without film is worst of all."""
    if np.isnan(numbers).any():
        return int(np.isnan(numbers).argmax())
    return int(numbers.argmax() if quantity == "outlet_temperature" else numbers.argmin())


COLUMNS = (
    ("clearance", "g", "µm", 1e-6), ("clearance_cold", "g cold", "µm", 1e-6), ("clearance_hot", "g hot", "µm", 1e-6),
    ("film", "film", "µm", 1e-6), ("film_edge", "at the edge", "µm", 1e-6), ("film_double_load", "twice the load", "µm", 1e-6),
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
        f"Journal {inputs.journal_fit}, seat {inputs.seat_fit}{_where(inputs)}; oil ±{inputs.viscosity_tolerance * 100:g} % "
        "of its viscosity.",
        (f"bearings.{place}.corners.",),
    )


def _where(inputs: BearingsInputs) -> str:
    placed = all(parse(fit).letter is not None for fit in (inputs.journal_fit, inputs.seat_fit))
    return ", as they make the clearance" if placed else " about the clearance at its reference temperature"
