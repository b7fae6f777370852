# SPDX-License-Identifier: Apache-2.0
"""The corners of the tolerances: smallest and largest journal, smallest and largest seat, thinner and thicker oil, each
solved."""

from itertools import product
from typing import Any

import numpy as np

from ...countershaft.rows import called
from ...library.tolerances import Assumed, deviations, parse, tolerance
from ...sheet.arrays import Array
from ...sheet.linked_array import gathered, item
from ...sheet.quantity import result, value
from ...sheet.record import record, replace
from ...sheet.shown import Shown
from ...sheet.step import Table
from ...sheet.text import Amount, Text
from ...sheet.units import Celsius, Metre, Radian
from ...sheet.value import about, based_on, untraced
from ..inputs import BearingsInputs
from . import formulas as f
from .routes.routes import own_warm
from .routes.states import BearingCase, Film, OperatingPoint
from .routes.thermal_balance import closed

ENDS = (("smallest", -1), ("largest", 1))
OILS = (("thinner", -1), ("thicker", 1))
CORNERS = tuple(product(ENDS, ENDS, OILS))
NAMES = (  # in the order of CORNERS, written out: adjectives are inflected in other languages
    Text("smallest journal, smallest seat, thinner oil"),
    Text("smallest journal, smallest seat, thicker oil"),
    Text("smallest journal, largest seat, thinner oil"),
    Text("smallest journal, largest seat, thicker oil"),
    Text("largest journal, smallest seat, thinner oil"),
    Text("largest journal, smallest seat, thicker oil"),
    Text("largest journal, largest seat, thinner oil"),
    Text("largest journal, largest seat, thicker oil"),
)
COLUMNS = (
    ("clearance", Text("g"), "µm", 1e-6),
    ("clearance_cold", Text("g cold"), "µm", 1e-6),
    ("clearance_hot", Text("g hot"), "µm", 1e-6),
    ("film", Text("film"), "µm", 1e-6),
    ("film_edge", Text("at the edge"), "µm", 1e-6),
    ("film_double_load", Text("twice the load"), "µm", 1e-6),
    ("outlet_temperature", Text("T_out"), "°C", 1.0),
    ("friction_power", Text("P_f"), "W", 1.0),
)


@record
class Exact:
    """The worst of the corners of parts that have no tolerance where none is given; nan: one has no film."""

    clearance_cold: Metre
    film_edge: Metre
    outlet_temperature: Celsius


@result
class Corners(Shown):
    """The worst of the eight corners, each quantity for itself; None: a corner has no film."""

    clearance_min: Metre = value("Smallest clearance of the fits", "µm", "g_min")
    clearance_max: Metre = value("Largest clearance of the fits", "µm", "g_max")
    clearance_cold: Metre = value("Smallest clearance at the lowest temperature", "µm", "g_cold,min")
    film: Metre | None = value("Thinnest film of the corners", "µm", "h_0,min")
    film_edge: Metre | None = value("Thinnest film at the edge of the corners", "µm", "h_edge,min")
    film_double_load: Metre | None = value("Thinnest film at twice the load of the corners", "µm", "h_2F,min")
    outlet_temperature: Celsius | None = value("Hottest outlet of the corners", "°C", "T_out,max")
    names: tuple[str, ...]
    exact: Exact | None  # None: both fits are given
    columns: dict[str, Array]  # one array over the corners for each quantity above and more

    def worst(self, quantity: str) -> str:
        """The name of the corner that governs."""
        return self.names[_worst(quantity, self.columns[quantity])]


def limits(
    inputs: BearingsInputs, d: Metre, g: Metre, *, exact: bool = False, seat: BearingCase[Any] | None = None
) -> tuple[tuple[Metre, Metre], tuple[Metre, Metre]]:
    """Lower and upper deviation of the journal, and of the seat.  Fits without a place lie about the middle of
    clearance `g`.  `exact`: a fit that is not given has no width.  `seat`: one whose parts make its clearance has their
    limits instead."""
    if seat is not None and seat.stack is not None:
        with untraced():
            least, most = seat.stack.clearances(seat.rings)
        half = min(seat.stack.journal_width, most - least) / 2
        return (-half, half), (least + half, most - half)
    journal, hole = parse(inputs.journal_fit), parse(inputs.seat_fit)
    if journal.letter is not None and hole.letter is not None:
        return deviations(journal, d), deviations(hole, d)
    half_J, half_S = (
        0.0 if exact and isinstance(given, Assumed) else tolerance(fit.grade, d) / 2
        for given, fit in ((inputs.journal_fit, journal), (inputs.seat_fit, hole))
    )
    return (-half_J, half_J), (g - half_S, g + half_S)


def widths(inputs: BearingsInputs, d: Metre) -> tuple[Metre, Metre]:
    """Of the journal's and the seat's tolerance."""
    return tolerance(parse(inputs.journal_fit).grade, d), tolerance(parse(inputs.seat_fit).grade, d)


def corner_points(
    seat: BearingCase[Any], duty: OperatingPoint[Any], share: Array | None = None
) -> tuple[BearingCase[Any], OperatingPoint[Any]]:
    """Eight corners at the load, the eight at twice the load, and where a fit is assumed eight without it, at the load:
    clearance, viscosity factor and load of shape (16,) or (24,).  `share`: of the load at the middle of the tolerances,
    where the clearance moves it."""
    g, factor = corner_values(seat)
    clearances, loads = [g, g], [1.0, 2.0]
    if assumed(seat):
        clearances.append(corner_values(seat, exact=True)[0])
        loads.append(1.0)
    load = duty.load * np.repeat(loads, len(g))
    at_corners = replace(seat, clearance=np.concatenate(clearances), viscosity_factor=np.tile(factor, len(clearances)))
    return at_corners, replace(duty, load=load if share is None else load * share)


def corner_values(seat: BearingCase, *, exact: bool = False) -> tuple[Array, Array]:
    """Clearance at the reference temperature and viscosity factor of each corner, shape (8,)."""
    journal, hole = limits(seat.inputs, seat.bearing.diameter, seat.clearance, exact=exact, seat=seat)
    g = [hole[s > 0] - journal[j > 0] for (_, j), (_, s), _ in CORNERS]
    inputs = seat.inputs
    made_by = (seat.bearing.diameter, inputs.seat_fit, inputs.journal_fit) if seat.stack is None else ()
    numbers = based_on(gathered(g), seat.clearance, *made_by)
    return numbers, np.array([1 + o * seat.inputs.viscosity_tolerance for *_, (_, o) in CORNERS])


def corners(
    seat: BearingCase[Any],
    duty: OperatingPoint,
    slope: Radian,
    film: Film[Array],
    bearing: str = "bearing",
    loads: Array | None = None,
) -> Corners:
    """`film`: of the corner points; `loads`: theirs, where the clearance moves them.

    The worst corner of the film, of twice the load and of the heat is solved once more, line by line, under the name of
    the `bearing`."""
    inputs, d, l = seat.inputs, seat.bearing.diameter, seat.bearing.length
    (ei, es), (EI, ES) = limits(inputs, d, seat.clearance)
    if seat.stack is not None:
        least, most = seat.stack.clearances(seat.rings)
    elif _have_a_place(inputs):
        least = f.least_clearance_of_fits(EI=based_on(EI, inputs.seat_fit, d), es=based_on(es, inputs.journal_fit, d))
        most = f.most_clearance_of_fits(ES=based_on(ES, inputs.seat_fit, d), ei=based_on(ei, inputs.journal_fit, d))
    else:
        T_S, T_J = based_on(ES - EI, inputs.seat_fit, d), based_on(es - ei, inputs.journal_fit, d)
        least = f.least_clearance(g=seat.clearance, T_S=T_S, T_J=T_J)
        most = f.most_clearance(g=seat.clearance, T_S=T_S, T_J=T_J)
    g, _ = corner_values(seat)
    once, twice = slice(0, len(g)), slice(len(g), 2 * len(g))
    rise, h_0 = film.temperature_rise, film.film
    columns = {
        "clearance": g,
        "clearance_cold": replace(seat, clearance=g).clearance_at(inputs.lowest_temperature),
        "clearance_hot": np.where(np.isfinite(h_0[once]), film.clearance[once], np.nan),
        "film": h_0[once],
        "film_edge": h_0[once] - slope * l / 2,
        "film_double_load": h_0[twice],
        "outlet_temperature": duty.supply_temperature + rise[once],
        "friction_power": film.friction_power[once],
    }

    def solved(quantity: str, at: OperatingPoint, points: slice) -> Film | None:
        """The worst corner by lines of the calculation, at the rise that is known; None where it has no film."""
        if np.isnan(columns[quantity]).any():
            return None
        worst = _worst(quantity, columns[quantity])
        (_, j), (_, s), (_, o) = CORNERS[worst]
        clearance = least if j > s else most if s > j else item(g[worst])
        if loads is not None:
            at = replace(at, load=based_on(loads[points][worst].item(), at.load))
        factor = f.viscosity_factor(t_nu=inputs.viscosity_tolerance, o=float(o))
        return closed(
            own_warm, replace(seat, clearance=clearance, viscosity_factor=factor), at, rise[points][worst].item()
        )

    with about(Text("{bearing}, thinnest corner", bearing=bearing)):
        thinnest = solved("film_edge", duty, once)
    with about(Text("{bearing}, thinnest corner at twice the load", bearing=bearing)):
        doubled = solved("film_double_load", replace(duty, load=based_on(2 * duty.load, duty.load)), twice)
    with about(Text("{bearing}, hottest corner", bearing=bearing)):
        hottest = solved("outlet_temperature", duty, once)
    edge = None if thinnest is None else f.film_at_edge(h_0=thinnest.film, theta=slope, l=l)
    outlet = None
    if hottest is not None:
        outlet = f.outlet_temperature(T_in=duty.supply_temperature, Delta_T=hottest.temperature_rise)
    return Corners(
        clearance_min=least,
        clearance_max=most,
        clearance_cold=replace(seat, clearance=least).clearance_at(inputs.lowest_temperature),
        film=None if thinnest is None else thinnest.film,
        film_edge=edge,
        film_double_load=None if doubled is None else doubled.film,
        outlet_temperature=outlet,
        names=NAMES,
        exact=_exact(seat, duty, slope, film, slice(2 * len(g), None)) if assumed(seat) else None,
        columns=columns,
    )


def _exact(seat: BearingCase[Any], duty: OperatingPoint, slope: Radian, film: Film[Array], there: slice) -> Exact:
    g, _ = corner_values(seat, exact=True)
    with untraced():
        cold = replace(seat, clearance=np.asarray(g)).clearance_at(seat.inputs.lowest_temperature)
    return Exact(
        clearance_cold=float(cold.min()),
        film_edge=float(film.film[there].min() - slope * seat.bearing.length / 2),
        outlet_temperature=float(duty.supply_temperature + film.temperature_rise[there].max()),
    )


def _worst(quantity: str, numbers: Array) -> int:
    """The hottest, else the smallest; a corner without film is worst of all."""
    if np.isnan(numbers).any():
        return int(np.isnan(numbers).argmax())
    return int(numbers.argmax() if quantity == "outlet_temperature" else numbers.argmin())


def corners_table(place: str, corners: Corners, seat: BearingCase[Any]) -> Table:
    """All corners of one bearing; a cell without film is empty."""
    inputs = seat.inputs

    def cell(name: str, row: int, factor: float) -> float | None:
        number = float(corners.columns[name][row])
        return number / factor if np.isfinite(number) else None

    where = Text(" about the clearance at its reference temperature")
    if _have_a_place(inputs):
        where = Text(", as they make the clearance")
    fits = Text(
        "Journal {journal_fit}, seat {seat_fit}{where}",
        journal_fit=inputs.journal_fit,
        seat_fit=inputs.seat_fit,
        where=where,
    )
    if seat.stack is not None:
        fits = Text("Journal and seat by the limits of their parts")
    note = Text(
        "{fits}; oil ±{viscosity_tolerance} % of its viscosity.",
        fits=fits,
        viscosity_tolerance=Amount(inputs.viscosity_tolerance * 100, form="g"),
    )
    return Table(
        f"corners_{place}",
        Text("Corners of the tolerances, {place} bearing", place=called(place)),
        ((Text("corner"), ""), *((label, unit) for _, label, unit, _ in COLUMNS)),
        tuple((name, *(cell(key, i, factor) for key, _, _, factor in COLUMNS)) for i, name in enumerate(corners.names)),
        note,
        (f"bearings.{place}.corners.",),
    )


def assumed(seat: BearingCase[Any]) -> bool:
    """Whether what opens the corners of the clearance is not given."""
    inputs = seat.inputs
    if seat.stack is not None:
        return False
    return isinstance(inputs.journal_fit, Assumed) or isinstance(inputs.seat_fit, Assumed)


def _have_a_place(inputs: BearingsInputs) -> bool:
    """Whether both fits have a letter, and so make the clearance."""
    return all(parse(fit).letter is not None for fit in (inputs.journal_fit, inputs.seat_fit))
