# SPDX-License-Identifier: Apache-2.0
"""What the bearing step publishes."""

from ...sheet.arrays import Array
from ...sheet.quantity import group, result, value, values
from ...sheet.shown import Shown
from ...sheet.text import Name, Text
from ...sheet.units import (
    Celsius,
    CubicMetrePerSecond,
    Kelvin,
    Metre,
    MetrePerSecond,
    Newton,
    NewtonPerMetreSecond,
    Number,
    Pascal,
    PascalMetrePerSecond,
    PascalSecond,
    Radian,
    RevPerSecond,
    Watt,
)
from ..support import OnShaftResult
from .corners import Corners
from .film.dynamics import Dynamics
from .routes.routes import ROUTES
from .routes.side_by_side import RouteResultBeside
from .routes.states import BearingCase, Film, OperatingPoint
from .seats.result import SeatResult, SelectResult, SplitResult
from .speeds import Sweep


@result
class RouteResult(Shown):
    """What one route finds, in thermal balance."""

    film: Metre = value("Smallest film", "µm", "h_0")
    eccentricity: Number = value("Eccentricity ratio", "", "ε")
    sommerfeld: Number = value("Sommerfeld number (S; ISO, Falz: So)", "", "S")
    friction_variable: Number = value("Friction variable", "", "f*")
    friction_coefficient: Number = value("Coefficient of friction", "", "f")
    friction_power: Watt = value("Friction power", "W", "P_f")
    temperature_rise: Kelvin = value("Temperature rise", "K", "ΔT")
    oil_flow: CubicMetrePerSecond = value("Oil flow", "L/min", "Q")
    side_flow: CubicMetrePerSecond | None = value("of it carried out by the turning film", "L/min", "Q_1", default=None)
    supply_flow: CubicMetrePerSecond | None = value("of it driven by the supply pressure", "L/min", "Q_2", default=None)
    attitude_angle: Radian | None = value("Attitude angle", "°", "φ", default=None)
    film_pressure_max: Pascal | None = value("Largest film pressure", "MPa", "p_max", default=None)


ROUTE_WORDS = {name: route.brief for name, route in ROUTES.items()} | {"din31652": Name("DIN 31652")}
AT_ALL: tuple[Celsius, ...] = (-20.0, 20.0, 100.0)  # of all parts alike, where the clearance is told
FORMER_NAMES = {name: route.former for name, route in ROUTES.items() if route.former}


def route_result(film: Film) -> RouteResult:
    return RouteResult(
        film=film.film,
        eccentricity=film.eccentricity,
        sommerfeld=film.sommerfeld,
        friction_variable=film.friction_variable,
        friction_coefficient=film.friction_coefficient,
        friction_power=film.friction_power,
        temperature_rise=film.temperature_rise,
        oil_flow=film.oil_flow,
        side_flow=film.side_flow,
        supply_flow=film.supply_flow if film.side_flow is not None else None,
        attitude_angle=film.attitude,
        film_pressure_max=film.largest_pressure,
    )


@result
class StandingResult(Shown):
    """The part of the load that stands still while the rest turns: weight and gear force."""

    standing_load: Newton = value("Standing part of the load, at most", "N", "R_0")
    load_peak: Newton = value("Largest load over a turn", "N", "R_max")
    film_load_peak: Metre | None = value("Film under the largest load, as if it stayed", "µm", "h_R", default=None)
    film_orbit: Metre | None = value(
        "Smallest film over a turn, by the film's stiffness and damping", "µm", "h_orb", default=None
    )
    orbit_amplitude: Metre | None = value("Largest excursion of the journal over a turn", "µm", "a_o", default=None)
    speed_of_equal_loads: RevPerSecond | None = value(
        "Speed at which the turning load is as large", "rpm", "n_0", default=None
    )
    load_at_start: Pascal = value("Specific load at the start", "MPa", "p_0")


def _degrees(at: str) -> Text:
    """A temperature of `AT_ALL` as it is read."""
    return Name(at.replace("-", "−"))


@result
class PlainResult(Shown):
    """One bearing as judged, and beside it the routes on the clearance as given."""

    film: Metre = value("Smallest film", "µm", "h_0", short=True, headline=2)
    film_edge: Metre = value(
        "Film at the bearing's edge", "µm", "h_edge", short=True, page_one=1, worst="least", each=True, headline=1
    )
    film_double_load: Metre | None = value("Film at twice the load", "µm", "h_2F", default=None, short=True)
    film_sheared: Metre | None = value(
        "Film at the edge, oil thinned by shear", "µm", "h_edge,κ", default=None, short=True
    )
    film_overspeed: Metre | None = value("Film at the edge at overspeed", "µm", "h_edge,s", default=None, short=True)
    speed_of_thinnest_film: RevPerSecond | None = value(
        "Speed of the thinnest film over the speeds", "rpm", default=None
    )
    thinnest_film: Metre | None = value("Thinnest film over the speeds", "µm", default=None)
    eccentricity: Number = value("Eccentricity ratio", "", "ε", short=True)
    film_share_least_friction: Number = value("Film over radial clearance at the least friction", "", "(h_0/c)_f")
    film_share_largest_load: Number = value("the same at the largest load", "", "(h_0/c)_F")
    film_band: Number = value("Film's place between least friction and largest load", "%", "b_f")
    attitude_angle: Radian = value("Attitude angle", "°", "φ", short=True)
    sommerfeld: Number = value("Sommerfeld number", "", "S", short=True)
    friction_coefficient: Number = value("Coefficient of friction", "", "f", short=True)
    friction_power: Watt = value("Friction power", "W", "P_f", short=True, taken_by=("friction",))
    oil_flow: CubicMetrePerSecond = value("Oil flow", "L/min", "Q", short=True)
    side_flow: CubicMetrePerSecond | None = value("of it carried out by the turning film", "L/min", "Q_1", default=None)
    supply_flow: CubicMetrePerSecond | None = value("of it driven by the supply pressure", "L/min", "Q_2", default=None)
    feed_blocked_arc: Radian | None = value("Arc where the film's pressure holds the supply back", "°", default=None)
    temperature_rise: Kelvin = value("Temperature rise", "K", "ΔT", short=True)
    outlet_temperature: Celsius = value("Outlet temperature", "°C", "T_out", short=True, page_one=2)
    film_pressure_max: Pascal = value("Largest film pressure", "MPa", "p_max", short=True)
    clearance: Metre = value("Clearance at its reference temperature", "µm", "g", short=True)
    clearance_hot: Metre = value("Clearance at the film's mean temperature", "µm", "g_hot", short=True)
    clearance_cold: Metre = value("Clearance at the lowest temperature", "µm", "g_cold", short=True)
    clearances: dict[str, Metre] = values(
        "Clearance with all parts at {row} °C", "µm", "g_*", id="clearance_at.*", called=_degrees, sign=_degrees
    )
    relative_clearance: Number = value("Relative clearance, warm", "‰", "ψ")
    load: Newton = value("Load", "N", "F", short=True)
    specific_load: Pascal = value("Specific load", "MPa", "p", short=True)
    pressure_velocity: PascalMetrePerSecond = value("Specific load times speed", "MPa·m/s", "p·u")
    heat_index: NewtonPerMetreSecond = value("Heat index", "N·rpm/mm", "W", short=True)
    surface_speed: MetrePerSecond = value("Surface speed", "m/s", "u", short=True)
    shear_rate: RevPerSecond = value("Shear rate in the narrowest gap", "1/s", "γ̇")
    shear_factor: Number | None = value("Share of the viscosity left at this shear rate", "", "κ", default=None)
    length_ratio: Number = value("Length ratio", "", "l/d")
    transition_speed: RevPerSecond = value("Transition to mixed friction", "rpm", "n_T")
    least_speed: RevPerSecond = value("Least speed for a full film", "rpm", "n_min", short=True)
    least_speed_uncapped: RevPerSecond = value("the same with the rule carried on above 10 m/s", "rpm")
    mckee_number: Number = value("McKee number, cP·rpm/psi", "", "ZN/P")
    duty_number: Number = value("Duty number", "", "μ·n/p")
    kreisle_film: Metre = value("Film asked for by roughness (Kreisle)", "µm", "h_K", short=True)
    trumpler_film: Metre = value("Film asked for by Trumpler", "µm", "h_T", short=True)
    routes_spread: Number | None = value("Spread of the routes' films at the same oil", "%", default=None)
    routes: dict[str, RouteResult] = group(
        spread=True, renamed=FORMER_NAMES, key_words=ROUTE_WORDS
    )  # those that have an answer
    corners: Corners = group(words="corners")
    seat_: SeatResult | None = group(words="seat", default=None)
    select: SelectResult | None = group(words="classes", default=None)
    split: SplitResult | None = group(words="split line", default=None)
    dynamics: Dynamics = group(words="dynamics")
    standing: StandingResult | None = group(spread=True, default=None)
    on_shaft: OnShaftResult | None = group(spread=True, default=None)
    hot: Film
    seat: BearingCase
    duty: OperatingPoint
    faster: OperatingPoint  # at overspeed
    sweep: Sweep
    side: RouteResultBeside
    beside: Film[Array]  # at a little less and a little more load
    slope: Radian | None  # of the journal in its seat; None: not known, and taken
    hths: PascalSecond | None  # viscosity of the oil at high shear; None: it does not thin by it, as far as is known
