# SPDX-License-Identifier: Apache-2.0
"""Both bearings: judged by the program's own solution on the warm clearance, beside the source's two methods."""

from dataclasses import replace

from ..catalogue import Material, Oil
from ..countershaft.result import CountershaftResult
from ..engine.inputs import BenchPoint, EngineInputs
from ..lubricant import Lubricant
from ..sheet.errors import NoSolution
from ..sheet.quantity import group, result, value
from ..sheet.step import Erratum, Outcome
from ..sheet.trace import about, trace, untraced
from ..sheet.units import (
    Celsius,
    CubicMetrePerSecond,
    Kelvin,
    Metre,
    MetrePerSecond,
    NewtonPerMetreSecond,
    Number,
    Pascal,
    Radian,
    RevPerSecond,
    Watt,
)
from . import formulas as f
from .checks import checks
from .din31652 import film_heavily_loaded
from .inputs import BearingInputs, BearingsInputs
from .raimondi_boyd import OutsideCharts
from .routes import Duty, Film, Route, Seat, balanced, din31652, own_cold, own_warm, raimondi_boyd
from .sweep import Sweep, sweep


@result
class RouteResult:
    """What one route finds, in thermal balance."""

    film: Metre = value("Smallest film", "µm", "h_0")
    eccentricity: Number = value("Eccentricity ratio", "", "ε")
    sommerfeld: Number = value("Sommerfeld number (S; DIN: So)", "", "S")
    friction_variable: Number = value("Friction variable", "", "f*")
    friction_coefficient: Number = value("Coefficient of friction", "", "f")
    friction_power: Watt = value("Friction power", "W", "P_f")
    temperature_rise: Kelvin = value("Temperature rise", "K", "ΔT")
    oil_flow: CubicMetrePerSecond = value("Oil flow", "L/min", "Q")
    attitude_angle: Radian | None = value("Attitude angle", "°", "φ", default=None)


def _route(film: Film) -> RouteResult:
    return RouteResult(
        film=film.film,
        eccentricity=film.eccentricity,
        sommerfeld=film.sommerfeld,
        friction_variable=film.friction_variable,
        friction_coefficient=film.friction_coefficient,
        friction_power=film.friction_power,
        temperature_rise=film.temperature_rise,
        oil_flow=film.oil_flow,
        attitude_angle=film.attitude,
    )


@result
class BearingResult:
    """One bearing as judged, and beside it the routes on the clearance as given."""

    film: Metre = value("Smallest film", "µm", "h_0")
    film_edge: Metre = value("Film at the bearing's edge", "µm", "h_edge")
    film_double_load: Metre | None = value("Film at twice the load", "µm", "h_2F", default=None)
    speed_of_thinnest_film: RevPerSecond | None = value("Speed of the thinnest film over the bench run", "rpm", default=None)
    thinnest_film: Metre | None = value("Thinnest film over the bench run", "µm", default=None)
    eccentricity: Number = value("Eccentricity ratio", "", "ε")
    attitude_angle: Radian = value("Attitude angle", "°", "φ")
    sommerfeld: Number = value("Sommerfeld number", "", "S")
    friction_coefficient: Number = value("Coefficient of friction", "", "f")
    friction_power: Watt = value("Friction power", "W", "P_f")
    oil_flow: CubicMetrePerSecond = value("Oil flow", "L/min", "Q")
    temperature_rise: Kelvin = value("Temperature rise", "K", "ΔT")
    outlet_temperature: Celsius = value("Outlet temperature", "°C", "T_out")
    film_pressure_max: Pascal = value("Largest film pressure", "MPa", "p_max")
    clearance: Metre = value("Clearance at its reference temperature", "µm", "g")
    clearance_hot: Metre = value("Clearance at the film's mean temperature", "µm", "g_hot")
    clearance_cold: Metre = value("Clearance at the lowest temperature", "µm", "g_cold")
    relative_clearance: Number = value("Relative clearance, warm", "‰", "ψ")
    specific_load: Pascal = value("Specific load", "MPa", "p")
    heat_index: NewtonPerMetreSecond = value("Heat index", "N·rpm/mm", "W")
    surface_speed: MetrePerSecond = value("Surface speed", "m/s", "u")
    length_ratio: Number = value("Length ratio", "", "l/d")
    transition_speed: RevPerSecond = value("Transition to mixed friction", "rpm", "n_T")
    least_speed: RevPerSecond = value("Least speed for a full film", "rpm", "n_min")
    least_speed_uncapped: RevPerSecond = value("the same with the rule carried on above 10 m/s", "rpm")
    mckee_number: Number = value("McKee number, cP·rpm/psi", "", "ZN/P")
    kreisle_film: Metre = value("Film asked for by roughness (Kreisle)", "µm", "h_K")
    trumpler_film: Metre = value("Film asked for by Trumpler", "µm", "h_T")
    routes_spread: Number | None = value("Spread of the routes' films", "%", default=None)
    reynolds: RouteResult | None = group(default=None)
    raimondi_boyd: RouteResult | None = group(default=None)
    din31652: RouteResult | None = group(default=None)
    hot: Film
    sweep: Sweep


@result
class BearingsResult:
    """Front and rear bearing."""

    bearings: dict[str, BearingResult] = group(spread=True)


def solve(
    bearings: BearingsInputs, shaft: CountershaftResult, engine: EngineInputs, oil: Oil, journal: Material, housing: Material
) -> Outcome:
    """Front and rear bearing under the shaft's reactions, which turn with it at crank speed and grow with its square."""
    speed, bench = engine.rated_speed, engine.bench
    loads = shaft.reaction_front, shaft.reaction_rear
    slopes = bearings.slope or _bent(shaft)
    results: dict[str, BearingResult] = {}
    notes: list[str] = list(_notes(bearings, shaft))
    with trace() as lines:
        with about("oil"):
            lubricant = Lubricant(oil, bearings.viscosity_law)
        for place, bearing, load, slope in (("front", bearings.front, loads[0], slopes[0]), ("rear", bearings.rear, loads[1], slopes[-1])):
            with about(f"{place} bearing"):
                if load <= 0:
                    raise NoSolution(
                        f"the {place} bearing carries no load", "", "give the counter-shaft eccentric masses that balance a couple"
                    )
                results[place] = _bearing(place, bearings, bearing, load, slope, speed, bench, lubricant, journal, housing, notes)
    found = tuple(c for place, r in results.items() for c in checks(place, bearings, getattr(bearings, place), r, slopes, speed))
    errata = tuple(e for place, r in results.items() for e in _errata(place, r))
    curves = tuple(r.sweep.curve(place, r.kreisle_film, r.film - r.film_edge) for place, r in results.items())
    return Outcome(
        "bearings",
        result=BearingsResult(bearings=results),
        checks=found,
        lines=tuple(lines),
        curves=curves,
        errata=errata,
        notes=tuple(dict.fromkeys([*notes, *_bench_note(results)])),
    )


def _bearing(
    place: str,
    inputs: BearingsInputs,
    bearing: BearingInputs,
    load: float,
    slope: float,
    speed: float,
    bench: tuple[BenchPoint, ...],
    lubricant: Lubricant,
    journal: Material,
    housing: Material,
    notes: list[str],
) -> BearingResult:
    d, l = bearing.diameter, bearing.length
    u = f.surface_speed(d=d, n=speed)
    g = bearing.clearance if bearing.clearance is not None else f.clearance_by_factor(K=bearing.clearance_factor, d=d, u=u)
    seat = Seat(bearing, inputs, lubricant, g, journal.expansion, housing.expansion)
    n_h = f.effective_speed(n_J=speed, n_B=0.0, n_F=speed)
    duty = Duty(load, speed, n_h, inputs.supply_temperature, inputs.supply_pressure)

    with about(f"{place} bearing, judged"):
        hot = balanced(own_warm, seat, duty)
        edge = f.film_at_edge(h_0=hot.film, theta=slope, l=l)
        # a full groove parts the bearing into two lands: p, l/d and the speeds are those of the lands
        bare = l - (inputs.groove_width or 0.0) if inputs.supply == "groove" else l
        p = f.specific_load(F=load, d=d, l=bare)
        W = f.heat_index(F=load, n=speed, l=l)
        n_T = f.transition_speed(p=p, mu=hot.oil.mu, d=d)
        least = f.least_speed(k=3.0 if u < 3 else min(u, 10.0), n_T=n_T)
        uncapped = f.least_speed_uncapped(u=u, n_T=n_T)
        mckee = f.mckee_number(mu=hot.oil.mu, n_h=n_h, p=p)
        kreisle = f.kreisle_film(k_R=inputs.roughness_ratio, Ra_1=bearing.journal_roughness, Ra_2=bearing.housing_roughness)
        trumpler = f.trumpler_film(d=d)
        outlet = f.outlet_temperature(T_in=inputs.supply_temperature, Delta_T=hot.temperature_rise)
        cold = seat.clearance_at(inputs.lowest_temperature)
    with about(f"{place} bearing, twice the load"):
        doubled = _beside(own_warm, seat, replace(duty, load=2 * load), place, "twice the load", notes)
    with about(f"{place} bearing, clearance as given"):
        own = _beside(own_cold, seat, duty, place, "the clearance as given", notes)
    with about(f"{place} bearing, Raimondi & Boyd"):
        charts = _beside(raimondi_boyd, seat, duty, place, "Raimondi & Boyd's charts", notes)
    with about(f"{place} bearing, DIN 31652"):
        din = _beside(din31652, seat, duty, place, "DIN 31652", notes)
    others = [r.film for r in (charts, din) if r is not None]
    spread = max((f.film_deviation(h_0=h, reference=own.film) for h in others), default=None) if own else None
    swept = sweep(seat, load, speed, bench, duty)
    thinnest = None if swept.thinnest_film is None else f.smallest_over_speeds(film=swept.thinnest_film)
    return BearingResult(
        film=hot.film,
        film_edge=edge,
        film_double_load=doubled.film if doubled else None,
        speed_of_thinnest_film=swept.thinnest_speed,
        thinnest_film=thinnest,
        eccentricity=hot.eccentricity,
        attitude_angle=hot.attitude or 0.0,
        sommerfeld=hot.sommerfeld,
        friction_coefficient=hot.friction_coefficient,
        friction_power=hot.friction_power,
        oil_flow=hot.oil_flow,
        temperature_rise=hot.temperature_rise,
        outlet_temperature=outlet,
        film_pressure_max=hot.largest_pressure or 0.0,
        clearance=g,
        clearance_hot=hot.clearance,
        clearance_cold=cold,
        relative_clearance=hot.relative_clearance,
        specific_load=p,
        heat_index=W,
        surface_speed=u,
        length_ratio=f.length_ratio(l=bare / 2 if inputs.supply == "groove" else bare, d=d),
        transition_speed=n_T,
        least_speed=least,
        least_speed_uncapped=uncapped,
        mckee_number=mckee,
        kreisle_film=kreisle,
        trumpler_film=trumpler,
        routes_spread=spread,
        reynolds=_route(own) if own else None,
        raimondi_boyd=_route(charts) if charts else None,
        din31652=_route(din) if din else None,
        hot=hot,
        sweep=swept,
    )


def _beside(route: Route, seat: Seat, duty: Duty, place: str, name: str, notes: list[str]) -> Film | None:
    """A route that is only shown: outside its range there is no value, and a note says so."""
    try:
        return balanced(route, seat, duty)
    except (NoSolution, OutsideCharts) as outside:
        notes.append(f"{place.capitalize()} bearing: {name} gives no value here ({outside}).")
        return None


def _bent(shaft: CountershaftResult) -> tuple[Radian, ...]:
    """The slopes of the journals as the counter-shaft's bending gives them; zero where it is not known."""
    return (0.0,) if shaft.slope_front is None or shaft.slope_rear is None else (shaft.slope_front, shaft.slope_rear)


def _notes(inputs: BearingsInputs, shaft: CountershaftResult) -> tuple[str, ...]:
    found = [
        "The load turns with the shaft: in its frame the seat turns backwards, so Sommerfeld's number is that of a standing load. Every "
        "point of the seat sees the largest pressure once a turn (fatigue); the journal is loaded on one fixed arc (wear).",
        f"The clearance is taken as given at {inputs.clearance_reference_temperature:g} °C and judged at the film's mean temperature.",
        "The shaft's weight and the gear force stand still and are not part of the load.",
        "Multigrade oils thin at high shear rate; the viscosity laws do not know it.",
    ]
    if inputs.slope is not None:
        found.append("The slope of the journals is the one given here (slope_mrad), not that of the counter-shaft's bending.")
    elif shaft.slope_front is not None:
        found.append("The slope of the journals is that of the counter-shaft's bending, with the stiffness share of its sectors.")
    else:
        found.append("No slope of the journals is given: it is taken as zero, and the film at the edge is that of the middle.")
    if inputs.supply == "shaft":
        found.append("The feed hole turns with the shaft and is taken to lie opposite the load.")
    return tuple(found)


def _bench_note(results: dict[str, BearingResult]) -> tuple[str, ...]:
    if all(r.thinnest_film is None or r.thinnest_film <= r.film for r in results.values()):
        return ()
    return (
        "The film at the design's own supply is thinner than anywhere on the bench run, whose oil is cooler or whose load is smaller: "
        "the design's supply is the harder case, and it is judged.",
    )


def _errata(place: str, r: BearingResult) -> tuple[Erratum, ...]:
    """What the source's methods give for this bearing, where they leave out or mistake what matters."""
    found = []
    if r.raimondi_boyd is not None:
        found.append(
            Erratum(
                f"bearings.{place}.film",
                f"Smallest film, {place}",
                r.raimondi_boyd.film * 1e6,
                "µm",
                "method of Finotti 2013, 5.5.1, on the clearance as given",
                f"The thesis leaves thermal expansion out: its clearance of {r.clearance * 1e6:.1f} µm becomes "
                f"{r.clearance_hot * 1e6:.1f} µm when warm and {r.clearance_cold * 1e6:.1f} µm at the lowest temperature.",
            )
        )
    if r.din31652 is not None and 0.9 < r.din31652.sommerfeld <= 1:
        with untraced():
            wrong = film_heavily_loaded(r.clearance, r.din31652.sommerfeld, r.length_ratio)
        found.append(
            Erratum(
                f"bearings.{place}.din31652.film",
                f"Film by DIN 31652, {place}",
                wrong * 1e6,
                "µm",
                "method of Finotti 2013, Table 5.4: the branch of the first pass",
                f"So = {r.din31652.sommerfeld:.3f} is below 1, but the thesis keeps the formula for So > 1 of its first pass.",
            )
        )
    return tuple(found)
