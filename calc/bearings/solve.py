# SPDX-License-Identifier: Apache-2.0
"""Both bearings: judged by the program's own solution on the warm clearance, beside three other routes to the film."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from ..catalogue import Material, Oil
from ..countershaft.result import CountershaftResult
from ..engine.inputs import BenchPoint, EngineInputs
from ..fits import deviations, parse
from ..lubricant import Lubricant
from ..sheet.check import Check, check
from ..sheet.errors import NoSolution
from ..sheet.step import Outcome
from ..sheet.trace import about, trace
from ..sheet.units import Metre, Number, Radian, RevPerSecond
from . import formulas as f
from .checks import checks
from .corners import corner_points, corners, corners_table
from .film import short_bearing as short
from .film.dynamics import dynamics
from .inputs import BearingInputs, BearingsInputs
from .pairing.data import application, running_surface
from .pairing.formulas import film_duty, load_times_speed
from .pairing.pairing import Journal, Running, application_checks, reference_table
from .pairing.pairing import checks as pairing_checks
from .pairing.pairing import table as bushes_table
from .pictures import clearance_points, curves
from .remarks import errata, notes
from .result import BearingResult, BearingsResult, route_result
from .routes import supply
from .routes.balance import balanced, settled_together
from .routes.routes import own_warm
from .routes.side_by_side import routes_table, side_by_side
from .routes.states import Duty, Film, Seat
from .sweep import TURNING, Sweep, sweep, sweep_points
from .turn import loads_beside

PLACES = ("front", "rear")


def solve(
    bearings: BearingsInputs, shaft: CountershaftResult | None, engine: EngineInputs | None, oil: Oil, journal: Material, housing: Material
) -> Outcome:
    """Front and rear bearing under the loads given, or the shaft's reactions, which turn with it and grow with its speed squared."""
    speed = bearings.speed if bearings.speed is not None else engine.rated_speed if engine is not None else 0.0
    bench = engine.bench if engine is not None else ()
    results: dict[str, BearingResult] = {}
    tables = []
    with trace() as lines:
        with about("oil"):
            lubricant = Lubricant(oil, bearings.viscosity_law)
        for place in PLACES:
            with about(f"{place} bearing"):
                bearing: BearingInputs = getattr(bearings, place)
                seat = Seat(bearing, bearings, lubricant, clearance_of(bearings, bearing, speed), journal.expansion, housing.expansion)
                load = _load(place, bearing, shaft)
                slope = _slope(place, bearings, shaft)
                results[place] = _bearing(place, seat, load, slope, speed, bench)
            tables += [routes_table(place, results[place].side), corners_table(place, results[place].corners, bearings)]
    found = tuple(c for place, r in results.items() for c in (*checks(place, r, _slope(place, bearings, shaft)), *_pairing(place, r)))
    found += tuple(_slopes_given(bearings, shaft))
    surface = bearings.bush_material or bearings.housing_material
    runs = {place: Running(r.specific_load, r.pressure_velocity, r.outlet_temperature) for place, r in results.items()}
    tables.append(bushes_table(runs, surface))
    sizes = {place: (r.seat.bearing.diameter, r.seat.bearing.length) for place, r in results.items()}
    tables.append(reference_table(Journal(place, *sizes[place], speed, r.load) for place, r in results.items()))
    return Outcome(
        "bearings",
        result=BearingsResult(bearings=results),
        checks=found,
        lines=tuple(lines),
        curves=tuple(c for place, r in results.items() for c in curves(place, r)),
        tables=tuple(tables),
        errata=tuple(e for place, r in results.items() for e in errata(place, r)),
        notes=notes(bearings, shaft, results),
    )


def _pairing(place: str, r: BearingResult) -> Iterator[Check]:
    """Advice by what the journal runs on, and by what bearings of this application usually carry."""
    inputs, bearing = r.seat.inputs, r.seat.bearing
    surface = running_surface(inputs.bush_material, inputs.housing_material)
    if surface is not None:
        yield from pairing_checks(place, surface, r.specific_load, r.pressure_velocity, r.outlet_temperature)
    yield from application_checks(
        place, application(inputs.application), p=r.specific_load, pv=r.pressure_velocity, mu=r.hot.oil.mu, mu_n_over_p=r.duty_number,
        psi=r.clearance / bearing.diameter, l_over_d=r.length_ratio,
    )  # fmt: skip


def clearance_of(inputs: BearingsInputs, bearing: BearingInputs, speed: RevPerSecond) -> Metre:
    """As given, by the factor K, or the middle of the fits."""
    if bearing.clearance is not None:
        return bearing.clearance
    if bearing.clearance_factor is not None:
        return f.clearance_by_factor(K=bearing.clearance_factor, d=bearing.diameter, u=f.surface_speed(d=bearing.diameter, n=speed))
    (ei, es), (EI, ES) = (deviations(parse(fit), bearing.diameter) for fit in (inputs.journal_fit, inputs.seat_fit))
    return f.clearance_of_fits(EI=EI, ES=ES, ei=ei, es=es)


def _load(place: str, bearing: BearingInputs, shaft: CountershaftResult | None) -> float:
    if bearing.load is not None:
        return bearing.load
    load: float = 0.0 if shaft is None else shaft.reaction_front if place == "front" else shaft.reaction_rear
    if load <= 0:
        raise NoSolution(f"the {place} bearing carries no load", "", "give the counter-shaft eccentric masses that balance a couple")
    return load


def _slope(place: str, inputs: BearingsInputs, shaft: CountershaftResult | None) -> float:
    """As given, else as the counter-shaft's bending has it; zero where neither is known."""
    at = 0 if place == "front" else -1
    if inputs.slope is not None:
        return inputs.slope[at]
    if shaft is None or shaft.slope_front is None or shaft.slope_rear is None:
        return 0.0
    return (shaft.slope_front, shaft.slope_rear)[at]


def _slopes_given(inputs: BearingsInputs, shaft: CountershaftResult | None) -> Iterator[Check]:
    """Slopes that are given, held against those of the shaft as this design bends it."""
    if inputs.slope is None or shaft is None or shaft.slope_front is None or shaft.slope_rear is None:
        return
    for place, at, bent in (("front", 0, shaft.slope_front), ("rear", -1, shaft.slope_rear)):
        if bent is not inputs.slope[at]:  # where nothing bends, the shaft has them from here
            yield check(
                f"bearings.{place}.slope_given", f"Slope as given, {place}, against that of the shaft's bending", inputs.slope[at], ">=",
                bent, "mrad", "bending of the stepped shaft, with the stiffness share of its sectors",
                "Take out bearings.slope_mrad: the slope is then that of the bending, and the film at the edge follows it.", kind="advice",
            )  # fmt: skip


def _duty(inputs: BearingsInputs, load: float, speed: RevPerSecond) -> Duty:
    n_B = f.bush_speed(i_B=inputs.bush_speed_ratio, n_J=speed) if inputs.bush_speed_ratio else 0.0
    n_F = speed if inputs.load_speed_ratio == 1 else f.load_speed(i_F=inputs.load_speed_ratio, n_J=speed)
    n_h = f.effective_speed(n_J=speed, n_B=n_B, n_F=n_F)
    slides = 1.0 if n_F in (0.0, speed) and not n_B else f.sliding_ratio(n_J=speed, n_B=n_B, n_h=n_h)
    return Duty(load, speed, n_h, slides, inputs.supply_temperature, inputs.supply_pressure)


def _bearing(place: str, seat: Seat, load: float, slope: float, speed: RevPerSecond, bench: tuple[BenchPoint, ...]) -> BearingResult:
    inputs, bearing = seat.inputs, seat.bearing
    d, l = bearing.diameter, bearing.length
    n_s = f.sliding_speed(n_J=speed, n_B=inputs.bush_speed_ratio * speed) if inputs.bush_speed_ratio else speed
    u = f.surface_speed(d=d, n=n_s)
    duty = _duty(inputs, load, speed)
    with about(f"{place} bearing, judged"):
        hot = balanced(own_warm, seat, duty)
        edge = f.film_at_edge(h_0=hot.film, theta=slope, l=l)
        # a groove parts the bearing into two lands: p, l/d and the speeds are those of the lands
        lands = supply.lands(inputs)
        bare = l if lands == 1 else l - (inputs.groove_width or 0.0)
        p = f.specific_load(F=load, d=d, l=bare)
        W = f.heat_index(F=load, n=speed, l=l)
        pv = load_times_speed(p=p, u=u)
        n_T = f.transition_speed(p=p, mu=hot.oil.mu, d=d)
        least = f.least_speed(k=3.0 if u < 3 else min(u, 10.0), n_T=n_T)
        uncapped = f.least_speed_uncapped(u=u, n_T=n_T)
        mckee = f.mckee_number(mu=hot.oil.mu, n_h=duty.effective_speed, p=p)
        number = film_duty(mu=hot.oil.mu, n_h=duty.effective_speed, p=p)
        kreisle = f.kreisle_film(k_R=inputs.roughness_ratio, Ra_1=bearing.journal_roughness, Ra_2=bearing.housing_roughness)
        trumpler = f.trumpler_film(d=d)
        outlet = f.outlet_temperature(T_in=inputs.supply_temperature, Delta_T=hot.temperature_rise)
        shear = f.shear_rate(u=u, h_0=hot.film)
        cold = seat.clearance_at(inputs.lowest_temperature)
    ratio = f.length_ratio(l=bare / 2 if lands == 2 else bare, d=d)
    with about(f"{place} bearing, oil supply"):
        blocked = _blocked_arc(inputs, duty, hot, ratio)
    side = side_by_side(place, seat, duty, ratio)
    with about(f"{place} bearing, dynamics"):
        moving = dynamics(hot, duty, seat, ratio)
    twice = replace(duty, load=2 * load)
    asked = (
        corner_points(seat, duty), sweep_points(seat, speed, bench, duty), clearance_points(seat, duty), (seat, twice),
        loads_beside(seat, duty),
    )  # fmt: skip
    at_corners, over_speeds, over_clearance, at_twice, beside = settled_together(asked)
    with about(f"{place} bearing, twice the load"):
        doubled = _at_known_rise(seat, twice, at_twice)
    with about(f"{place} bearing, corners of the tolerances"):
        found = corners(seat, duty, slope, at_corners, f"{place} bearing")
    swept = sweep(speed, inputs, bool(bench), asked[1][1], over_speeds)
    with about(f"{place} bearing, speed of the thinnest film"):
        thinnest = _thinnest(seat, duty, swept)
    routes: dict[str, Any] = {name: route_result(film) for name, film in side.films.items()}
    return BearingResult(
        film=hot.film,
        film_edge=edge,
        film_double_load=doubled.film if doubled else None,
        speed_of_thinnest_film=swept.thinnest_speed,
        thinnest_film=None if thinnest is None else thinnest.film,
        eccentricity=hot.eccentricity,
        attitude_angle=hot.attitude or 0.0,
        sommerfeld=hot.sommerfeld,
        friction_coefficient=hot.friction_coefficient,
        friction_power=hot.friction_power,
        oil_flow=hot.oil_flow,
        side_flow=hot.side_flow,
        supply_flow=hot.supply_flow if hot.side_flow is not None else None,
        feed_blocked_arc=blocked,
        temperature_rise=hot.temperature_rise,
        outlet_temperature=outlet,
        film_pressure_max=hot.largest_pressure or 0.0,
        clearance=seat.clearance,
        clearance_hot=hot.clearance,
        clearance_cold=cold,
        relative_clearance=hot.relative_clearance,
        load=load,
        specific_load=p,
        pressure_velocity=pv,
        heat_index=W,
        surface_speed=u,
        shear_rate=shear,
        length_ratio=ratio,
        transition_speed=n_T,
        least_speed=least,
        least_speed_uncapped=uncapped,
        mckee_number=mckee,
        duty_number=number,
        kreisle_film=kreisle,
        trumpler_film=trumpler,
        routes_spread=side.spread,
        **routes,
        corners=found,
        dynamics=moving,
        hot=hot,
        seat=seat,
        duty=duty,
        sweep=swept,
        side=side,
        over_clearance=over_clearance,
        beside=beside,
    )


def _thinnest(seat: Seat, duty: Duty, swept: Sweep) -> Film | None:
    """The film at the speed where it is thinnest, by lines of the calculation, at the rise that is known."""
    if swept.thinnest is None:
        return None
    at = swept.thinnest
    n = swept.speeds[at]
    load = f.load_at_speed(F=duty.load, n=n, n_0=duty.speed) if seat.inputs.load_speed_ratio == TURNING else duty.load
    slower = replace(
        duty, load=load, speed=n, effective_speed=duty.effective_speed * (n / duty.speed),
        supply_temperature=swept.temperatures[at], supply_pressure=swept.pressures[at],
    )  # fmt: skip
    return own_warm(seat, slower, swept.rises[at])


def _at_known_rise(seat: Seat, duty: Duty, known: Film) -> Film | None:
    """The one film that is known, by lines of the calculation; None where no film carries the load: the check on it fails."""
    rise: Any = known.temperature_rise
    return own_warm(seat, duty, float(rise[0])) if np.isfinite(rise[0]) else None


def _blocked_arc(inputs: BearingsInputs, duty: Duty, hot: Film, ratio: Number) -> Radian | None:
    """Over which angles the film holds the supply back; asked where the load sweeps over a hole or pocket."""
    if inputs.supply == "groove" or supply.keeps_its_angle(inputs) or duty.supply_pressure <= 0:
        return None
    eps = hot.eccentricity
    theta_m = short.angle_of_largest_pressure(eps=eps)
    largest = short.largest_relative_pressure(eps=eps, b=ratio, theta_m=theta_m)
    omega = f.angular_speed(n=duty.effective_speed)
    p_max = f.short_bearing_pressure(mu=hot.oil.mu, omega=omega, psi=hot.relative_clearance, largest=largest)
    return short.blocked_arc(eps=eps, p_s=duty.supply_pressure, p_max=p_max)
