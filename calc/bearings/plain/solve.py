# SPDX-License-Identifier: Apache-2.0
"""One plain bearing: judged by the program's own solution on the warm clearance, beside other routes to the film."""

from typing import Any, overload

import numpy as np

from ...countershaft.bending.carried import AnyLaw
from ...countershaft.rows import BearingRow, called
from ...library.catalogue import Material, Oil, materials, oils
from ...library.journal_rules import heat_index, specific_load, speed_factor
from ...library.lubricant import Lubricant
from ...library.oils import high_shear
from ...library.tolerances import deviations, parse
from ...sheet.arguments import check_arguments, demand_alike, named
from ...sheet.arrays import Array, Num
from ...sheet.linked_array import gathered, item
from ...sheet.record import record, replace
from ...sheet.text import Text
from ...sheet.units import Celsius, Metre, Newton, Number, Pascal, Radian, RevPerSecond
from ...sheet.value import about, based_on
from ..inputs import BearingsInputs
from ..support import OperatingPoint, Task
from . import formulas as f
from .as_support import FilmLaw, as_supplied, runs_centred, told_law, warm_law
from .bearing import PlainBearing
from .corners import corner_points, corners
from .film import short_bearing as short
from .film import table as optimum
from .film.dynamics import dynamics
from .inputs import SLOPE_TAKEN, PlainInputs
from .loads import loads_beside
from .result import AT_ALL, route_result
from .routes import supply
from .routes.routes import ROUTES, own_cold, own_warm
from .routes.side_by_side import judged_alone, side_by_side
from .routes.states import BearingCase, Film
from .routes.thermal_balance import balanced, closed, settled, settled_together
from .seats.sitting import seat_result, select_result, split_result
from .speeds import TURNING, Sweep, highest_speed, sweep, sweep_points
from .suitability import film_asked, film_duty, load_times_speed

HTHS_TEMPERATURE: Celsius = 150.0  # at which the viscosity at high shear is measured, SAE J300


def clearance_of(inputs: PlainInputs, bearing: BearingRow, speed: RevPerSecond) -> Metre:
    """As given, by the factor K, or the middle of the fits."""
    if bearing.clearance is not None:
        return bearing.clearance
    if bearing.clearance_factor is not None:
        return f.clearance_by_factor(
            K=bearing.clearance_factor, d=bearing.diameter, u=f.surface_speed(d=bearing.diameter, n=speed)
        )
    (ei, es), (EI, ES) = (
        tuple(based_on(x, fit, bearing.diameter) for x in deviations(parse(fit), bearing.diameter))
        for fit in (inputs.journal_fit, inputs.seat_fit)
    )
    return f.clearance_of_fits(EI=EI, ES=ES, ei=ei, es=es)


def operating_point(inputs: BearingsInputs, load: float, speed: RevPerSecond) -> OperatingPoint:
    i_B, i_F = inputs.bush_speed_ratio, inputs.load_speed_ratio
    n_B = f.bush_speed(i_B=i_B, n_J=speed) if i_B else based_on(0.0, i_B)
    n_F = based_on(speed, speed, i_F) if i_F == 1 else f.load_speed(i_F=i_F, n_J=speed)
    n_h = f.effective_speed(n_J=speed, n_B=n_B, n_F=n_F)
    slides = based_on(1.0, i_B, i_F)
    if n_B or np.any(n_h != speed):
        slides = f.sliding_ratio(n_J=speed, n_B=n_B, n_h=n_h)
    return OperatingPoint(load, speed, n_h, slides, inputs.supply_temperature, inputs.supply_pressure)


@record
class PlainSupport:
    """A plain bearing before its load is known; `metal`: around it."""

    case: BearingCase
    metal: Material

    @property
    def row(self) -> BearingRow:
        return self.case.bearing

    def law(self, duty: OperatingPoint[Any], sense: int) -> AnyLaw:
        return as_supplied(self.case, duty, sense)

    def warm_law(self, duty: OperatingPoint[Any], supplied: AnyLaw, before: AnyLaw, sense: int) -> AnyLaw:
        assert isinstance(supplied, FilmLaw)
        return warm_law(self.case, duty, supplied, before, sense)

    def told_law(self, law: AnyLaw, duty: OperatingPoint[Any]) -> AnyLaw:
        assert isinstance(law, FilmLaw)
        return told_law(law, self.case, duty)

    def centred_under(self, duty: OperatingPoint[Any]) -> bool:
        return duty.load <= 0 or runs_centred(self.case, duty)

    def as_centred(self) -> "PlainSupport":
        return replace(self, case=replace(self.case, centred=True))

    def solved(self, load: Newton, slope: Radian | None, share: Array | None, task: Task) -> PlainBearing:
        return solved(self.row.name, self.case, load, slope, share, task, self.metal)


def solved(
    place: str,
    seat: BearingCase,
    load: float,
    slope: Radian | None,
    share: Array | None,
    task: Task,
    metal: Material,
) -> PlainBearing:
    """One bearing under its load; `metal`: what a bare seat is of; `share`: its load at the corners over that."""
    inputs, bearing, speed, bench = seat.inputs, seat.bearing, task.speed, task.bench
    d, l = bearing.diameter, bearing.length
    i_B = inputs.bush_speed_ratio
    n_s = f.sliding_speed(n_J=speed, n_B=based_on(i_B * speed, i_B, speed)) if i_B else based_on(speed, speed, i_B)
    u = f.surface_speed(d=d, n=n_s)
    duty = operating_point(inputs, load, speed)
    theta = SLOPE_TAKEN if slope is None else slope
    with about(Text("{place} bearing, judged", place=called(place))):
        hot = balanced(own_warm, seat, duty)
        if seat.centred:  # what its film is found under
            duty = replace(duty, load=hot.specific_load * d * supply.bare_length(inputs, l))
        assert hot.attitude is not None and hot.largest_pressure is not None
        edge = f.film_at_edge(h_0=hot.film, theta=theta, l=l)
        # a groove parts the bearing into two lands: p, l/d and the speeds are those of the lands
        lands = supply.lands(inputs)
        bare = l if lands == 1 else based_on(supply.bare_length(inputs, l), l, inputs.groove_width)
        p = specific_load(F=load, d=d, l=bare)
        W = heat_index(F=load, n=speed, l=l)
        pv = load_times_speed(p=p, u=u)
        p_film = hot.specific_load if seat.centred else p
        n_T = f.transition_speed(p=p, mu=hot.oil.mu, d=d)
        least = f.least_speed(k=speed_factor(u), n_T=n_T)
        uncapped = f.least_speed_uncapped(u=u, n_T=n_T)
        mckee = f.mckee_number(mu=hot.oil.mu, n_h=duty.effective_speed, p=p_film)
        number = film_duty(mu=hot.oil.mu, n_h=duty.effective_speed, p=p_film)
        kreisle = film_asked(inputs, bearing.journal_roughness, bearing.housing_roughness)
        trumpler = f.trumpler_film(d=d)
        outlet = f.outlet_temperature(T_in=inputs.supply_temperature, Delta_T=hot.temperature_rise)
        shear = f.shear_rate(u=u, h_0=hot.film)
        cold = seat.clearance_at(inputs.lowest_temperature)
        at_all = {f"{T:g}": seat.clearance_at(T) for T in AT_ALL}
    ratio = f.length_ratio(l=based_on(bare / 2, bare) if lands == 2 else bare, d=d)
    with about(Text("{place} bearing, between largest load and least friction", place=called(place))):
        most, least_friction = optimum.share_of_largest_load(b=ratio), optimum.share_of_least_friction(b=ratio)
        band = optimum.place_in_band(eps=hot.eccentricity, share_f=least_friction, share_F=most)
    with about(Text("{place} bearing, oil supply", place=called(place))):
        blocked = _blocked_arc(inputs, duty, hot, ratio)
    beside = task.compared and not seat.centred  # other methods have no film of a journal that runs centred
    side = side_by_side(place, seat, duty, ratio) if beside else judged_alone(seat, ratio)
    with about(Text("{place} bearing, dynamics", place=called(place))):
        moving = dynamics(hot, duty, seat, ratio)
    twice = replace(duty, load=based_on(2 * load, load))
    speeds = sweep_points(seat, speed, bench, duty)
    with about(Text("{place} bearing, oil thinned by shear", place=called(place))):
        hths, thin = high_shear(seat.lubricant), seat
        if hths is not None:
            kappa = f.full_shear_factor(hths=hths, mu_150=seat.lubricant.at(HTHS_TEMPERATURE).mu)
            thin = replace(seat, viscosity_factor=f.shear_factor(kappa=kappa, gamma=shear))
    with about(Text("{place} bearing, overspeed", place=called(place))):
        n_over = f.overspeed(n=highest_speed(speed, bench, inputs), s=inputs.overspeed)
        faster = _at_speed(seat, duty, n_over, duty.supply_temperature, duty.supply_pressure)
    points = corner_points(seat, duty, share)
    corner_films, over_speeds, at_twice, loads_near, at_shear, at_over = settled_together(
        (points, speeds, (seat, twice), loads_beside(seat, duty), (thin, duty), (seat, faster))
    )
    sheared = over = None  # where no film carries the load, the check on it fails
    if hths is not None:
        with about(Text("{place} bearing, oil thinned by shear", place=called(place))):
            sheared = _edge(thin, duty, at_shear, theta)
    with about(Text("{place} bearing, overspeed", place=called(place))):
        over = _edge(seat, faster, at_over, theta)
    with about(Text("{place} bearing, twice the load", place=called(place))):
        rise = at_twice.temperature_rise[0].item()
        # where no film carries twice the load, the check on it fails
        doubled = closed(own_warm, seat, twice, rise) if np.isfinite(rise) and not seat.centred else None
    with about(Text("{place} bearing, corners of the tolerances", place=called(place))):
        of = Text("{place} bearing", place=called(place))
        at_worst = corners(seat, duty, theta, corner_films, of, None if share is None else points[1].load)
    with about(Text("{place} bearing, seat", place=called(place))):
        pressed = seat_result(seat, load, duty, hot, corner_films)
    with about(Text("{place} bearing, split line", place=called(place))):
        passed = split_result(seat, hot, edge, ratio)
    with about(Text("{place} bearing, classes", place=called(place))):
        selected = select_result(seat.stack, seat.rings)
    swept = sweep(speed, inputs, bench, speeds[1], over_speeds)
    with about(Text("{place} bearing, speed of the thinnest film", place=called(place))):
        thinnest = _thinnest(seat, duty, swept)
    return PlainBearing(
        film=hot.film,
        film_edge=edge,
        film_double_load=doubled.film if doubled else None,
        film_sheared=sheared,
        film_overspeed=over,
        speed_of_thinnest_film=swept.thinnest_speed,
        thinnest_film=None if thinnest is None else thinnest.film,
        eccentricity=hot.eccentricity,
        film_band=band,
        film_share_largest_load=most,
        film_share_least_friction=least_friction,
        attitude_angle=hot.attitude,
        sommerfeld=hot.sommerfeld,
        friction_coefficient=hot.friction_coefficient,
        friction_power=hot.friction_power,
        oil_flow=hot.oil_flow,
        side_flow=hot.side_flow,
        supply_flow=hot.supply_flow if hot.side_flow is not None else None,
        feed_blocked_arc=blocked,
        temperature_rise=hot.temperature_rise,
        outlet_temperature=outlet,
        film_pressure_max=hot.largest_pressure,
        clearance=seat.clearance,
        clearance_hot=hot.clearance,
        clearance_cold=cold,
        clearances=at_all,
        relative_clearance=hot.relative_clearance,
        load=load,
        specific_load=p,
        pressure_velocity=pv,
        heat_index=W,
        surface_speed=u,
        shear_rate=shear,
        shear_factor=thin.viscosity_factor,
        length_ratio=ratio,
        transition_speed=n_T,
        least_speed=least,
        least_speed_uncapped=uncapped,
        mckee_number=mckee,
        duty_number=number,
        kreisle_film=kreisle,
        trumpler_film=trumpler,
        routes_spread=side.spread,
        routes={
            name: route_result(side.films[name]) for name in sorted(side.films, key=lambda name: ROUTES[name].listed)
        },
        corners=at_worst,
        seat_=pressed,
        select=selected,
        split=passed,
        dynamics=moving,
        hot=hot,
        seat=seat,
        duty=duty,
        faster=faster,
        sweep=swept,
        side=side,
        beside=loads_near,
        slope=slope,
        hths=hths,
        metal=metal,
    )


def _thinnest(seat: BearingCase, duty: OperatingPoint, swept: Sweep) -> Film | None:
    """The film at the speed where it is thinnest, by lines of the calculation, at the rise that is known."""
    if swept.thinnest is None:
        return None
    n, T_in, p_s, rise = (
        item(gathered(row)[swept.thinnest]) for row in (swept.speeds, swept.temperatures, swept.pressures, swept.rises)
    )
    return closed(own_warm, seat, _at_speed(seat, duty, n, T_in, p_s), rise)


def _edge(seat: BearingCase, duty: OperatingPoint, film: Film[Array], slope: Radian) -> Metre | None:
    """The film at the edge by lines of the calculation, at the rise that is known; None where there is none."""
    rise = film.temperature_rise[0].item()
    if not np.isfinite(rise):
        return None
    return f.film_at_edge(h_0=closed(own_warm, seat, duty, rise).film, theta=slope, l=seat.bearing.length)


def _at_speed(seat: BearingCase, duty: OperatingPoint, n: RevPerSecond, T_in: Celsius, p_s: Pascal) -> OperatingPoint:
    """The same bearing at another speed, with the oil that is supplied there."""
    load = f.load_at_speed(F=duty.load, n=n, n_0=duty.speed) if seat.inputs.load_speed_ratio == TURNING else duty.load
    return replace(
        duty,
        load=load,
        speed=n,
        effective_speed=based_on(duty.effective_speed * (n / duty.speed), duty.effective_speed, n, duty.speed),
        supply_temperature=T_in,
        supply_pressure=p_s,
    )


def _blocked_arc(inputs: BearingsInputs, duty: OperatingPoint, hot: Film, ratio: Number) -> Radian | None:
    """Over which angles the film holds the supply back; asked where the load sweeps over a hole or pocket."""
    if inputs.supply == "groove" or supply.keeps_its_angle(inputs) or not duty.supply_pressure:
        return None
    eps = hot.eccentricity
    theta_m = short.angle_of_largest_pressure(eps=eps)
    largest = short.largest_relative_pressure(eps=eps, b=ratio, theta_m=theta_m)
    omega = f.angular_speed(n=duty.effective_speed)
    p_max = f.short_bearing_pressure(mu=hot.oil.mu, omega=omega, psi=hot.relative_clearance, largest=largest)
    return short.blocked_arc(eps=eps, p_s=duty.supply_pressure, p_max=p_max)


# --- from Python, in SI: `from calc import bearings`


@overload
def solve_film(  # type: ignore[overload-overlap]  # numbers give numbers, one array among them gives arrays
    *,
    diameter: Metre,
    length: Metre,
    clearance: Metre,
    load: Newton,
    speed: RevPerSecond,
    oil: str | Oil,
    supply_temperature: Celsius,
    supply_pressure: Pascal = ...,
    hole_diameter: Metre = ...,
    load_speed_ratio: Number = ...,
    journal: str = ...,
    housing: str = ...,
    warm: bool = ...,
) -> Film[float]: ...
@overload
def solve_film(
    *,
    diameter: Num,
    length: Num,
    clearance: Num,
    load: Num,
    speed: Num,
    oil: str | Oil,
    supply_temperature: Num,
    supply_pressure: Num = ...,
    hole_diameter: Metre = ...,
    load_speed_ratio: Number = ...,
    journal: str = ...,
    housing: str = ...,
    warm: bool = ...,
) -> Film[Array]: ...
def solve_film(
    *,
    diameter: Any,
    length: Any,
    clearance: Any,
    load: Any,
    speed: Any,
    oil: str | Oil,
    supply_temperature: Any,
    supply_pressure: Any = 3e5,
    hole_diameter: Metre = 4e-3,
    load_speed_ratio: Number = 1.0,
    journal: str = "steel",
    housing: str = "steel",
    warm: bool = True,
) -> Film[Any]:
    """The film of one bearing in thermal balance, by this program's own solution of Reynolds' equation.

    `diameter`, `length`: of the journal in the bearing [m].  `clearance`: diametral, at 20 °C [m].  `load` [N].
    `speed`: of the journal [revolutions per second].  `oil`: a name of the table, or an Oil.  `supply_temperature`
    [°C], `supply_pressure` [Pa], `hole_diameter` [m]: how the oil comes.  `load_speed_ratio`: 1, the load turns with
    the shaft; 0, it stands.  `journal`, `housing`: materials, by whose expansion the clearance changes (`warm` False:
    it keeps its size).

    All up to `supply_pressure` may be arrays, which are broadcast against each other: then every value of the film is
    an array of that shape, nan where there is no film.  Of numbers alone, NoSolution is raised there.  BadInput where
    an argument lies outside of the range that it has in a design file."""
    check_arguments(
        "solve_film",
        diameter=(BearingRow.diameter, diameter),
        length=(BearingRow.length, length),
        clearance=(BearingRow.clearance, clearance),
        load=(BearingRow.load, load),
        speed=(BearingsInputs.speed, speed),
        supply_temperature=(BearingsInputs.supply_temperature, supply_temperature),
        supply_pressure=(BearingsInputs.supply_pressure, supply_pressure),
        hole_diameter=(BearingsInputs.hole_diameter, hole_diameter),
        load_speed_ratio=(BearingsInputs.load_speed_ratio, load_speed_ratio),
    )
    demand_alike(
        "solve_film",
        most=0,
        diameter=diameter,
        length=length,
        clearance=clearance,
        load=load,
        speed=speed,
        supply_temperature=supply_temperature,
        supply_pressure=supply_pressure,
        hole_diameter=hole_diameter,
        load_speed_ratio=load_speed_ratio,
    )
    row = oil if isinstance(oil, Oil) else named("solve_film", "oil", oil, oils())
    of_journal, of_housing = (
        named("solve_film", argument, name, materials())
        for argument, name in (("journal", journal), ("housing", housing))
    )
    bearing = BearingRow(
        name="alone",
        position=0.0,
        diameter=diameter,
        length=length,
        clearance=clearance,
        load=load,
        journal_roughness=0.0,
        housing_roughness=0.0,
    )
    inputs = BearingsInputs(
        oil=row.name,
        supply_temperature=supply_temperature,
        supply_pressure=supply_pressure,
        supply="hole",
        hole_diameter=hole_diameter,
        housing_material=housing,
        load_speed_ratio=load_speed_ratio,
    )
    case = BearingCase(bearing, inputs, Lubricant(row), clearance, of_journal.expansion, of_housing.expansion)
    duty = operating_point(inputs, load, speed)
    if any(map(np.ndim, (diameter, length, clearance, load, speed, supply_temperature, supply_pressure))):
        return settled(case, duty, warm=warm, tolerance=1e-12)
    return balanced(own_warm if warm else own_cold, case, duty)
