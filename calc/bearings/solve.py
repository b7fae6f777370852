# SPDX-License-Identifier: Apache-2.0
"""The bearings of a shaft: judged by the program's own solution on the warm clearance, beside the other routes to the
film."""

from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from ..countershaft.bending.condensed import Condensed, of_beam
from ..countershaft.formulas import reaction
from ..countershaft.result import CountershaftResult
from ..countershaft.rows import BearingRow, called, row_key
from ..countershaft.twins import How
from ..engine.inputs import BenchPoint, EngineInputs
from ..library.catalogue import Material, Oil, materials, oils
from ..library.journal_rules import heat_index, specific_load, speed_factor
from ..library.lubricant import Lubricant
from ..library.oils import high_shear
from ..library.tolerances import deviations, parse
from ..sheet.arrays import Array
from ..sheet.check import Check, CheckRule
from ..sheet.deferred import Later
from ..sheet.errors import NoSolution
from ..sheet.linked_array import elements, gathered, item
from ..sheet.quantity import dotted
from ..sheet.remedy import by_key
from ..sheet.step import Curve, Further, Outcome, Table
from ..sheet.text import EMPTY, Amount, Text
from ..sheet.units import Celsius, Metre, Newton, Number, Pascal, Radian, RevPerSecond
from ..sheet.value import about, based_on, trace, untraced
from .as_supports import at_corners, on_films, on_shaft, runs_centred, shared, support_checks, turned_over
from .inputs import SLOPE_TAKEN, BearingsInputs, ruled_by
from .makers import maker_checks, makers_table, own_journal
from .plain import formulas as f
from .plain.checks import SLOPE, checks, oil_check
from .plain.corners import corner_points, corners, corners_table
from .plain.curves import charts, curves, in_films
from .plain.film import short_bearing as short
from .plain.film import table as optimum
from .plain.film.dynamics import dynamics
from .plain.loads import loads_beside
from .plain.materials import application, running_surface
from .plain.notes import errata, notes
from .plain.routes import supply
from .plain.routes.routes import ROUTES, own_cold, own_warm
from .plain.routes.side_by_side import judged_alone, routes_table, side_by_side
from .plain.routes.states import BearingCase, Film, OperatingPoint
from .plain.routes.thermal_balance import balanced, closed, settled_together
from .plain.seats.seat import rings_of
from .plain.seats.sitting import seat_result, select_result, sitting, split_result
from .plain.seats.stack import stack_of
from .plain.seats.tables import seat_tables
from .plain.seats.warm import seat_curves, warm_table
from .plain.speeds import TURNING, Sweep, highest_speed, of_journals, sweep, sweep_points
from .plain.suitability import (
    Journal,
    Running,
    application_checks,
    film_asked,
    film_duty,
    load_times_speed,
    material_checks,
    reference_table,
)
from .plain.suitability import table as bushes_table
from .result import AT_ALL, BearingResult, BearingsResult, route_result

SLOPE_GIVEN = CheckRule(
    "bearings.B.slope_given",
    "caution",
    "The film at the edge is judged with a smaller slope than the shaft takes.",
    unit="mrad",
    source=Text("elasticity: bending of the stepped shaft, with the stiffness share of its sectors"),
    zero="the slope that is taken where none is known, 0.1 mrad",
    cause="bearings.slope_given",
    moved_by=(SLOPE,),
)


HTHS_TEMPERATURE: Celsius = 150.0  # at which the viscosity at high shear is measured, SAE J300


class BearingMaterials(NamedTuple):
    """What the bearings of a shaft run with: their oil, the material of the journals; front to rear that of the housing
    at each, and that of a bush in it."""

    oil: Oil
    journal: Material
    housings: tuple[Material, ...]
    backings: tuple[Material, ...]


def solve(
    bearings: BearingsInputs,
    rows: tuple[BearingRow, ...],
    shaft: CountershaftResult | None,
    engine: EngineInputs | None,
    solids: BearingMaterials,
    *,
    speed_ratio: Number | None,
    how: How = "own",
    assembly: str | None = None,
    compared: bool = True,
) -> Outcome[BearingsResult]:
    """The bearings of a shaft, front to rear, under the loads given, or the shaft's reactions, which turn with it and
    grow with its speed squared; more than two share them by their films and its bending.

    `speed_ratio`: of the shaft to the crank.  `how`: the bearings may be those of its mirror image, whose films are
    the same turned over.  `assembly`: how the shaft comes into its seats, where that is said.  `compared`: with the
    other routes to the film beside the one that judges.
    """
    speed, bench = bearings.speed, tuple[BenchPoint, ...]()
    if engine is not None:
        rated, bench = of_journals(engine, speed_ratio)
        speed = rated if speed is None else speed
    assert speed is not None
    results: dict[str, BearingResult] = {}
    all_checks: list[Check] = []  # of each bearing at once: they have lines of their own
    with trace() as lines:
        with about(Text("oil")):
            lubricant = Lubricant(solids.oil, bearings.viscosity_law)
        seats = []
        with untraced():
            duty = operating_point(bearings, 0.0, speed)
        for bearing, housing, backing in zip(rows, solids.housings, solids.backings):
            own, stack = bearings.of(bearing), stack_of(bearing, bearings.select)
            d = bearing.diameter
            with about(Text("{place} bearing", place=called(bearing.name))):
                rings = rings_of(bearing, own, stack, backing, housing, d)
                clearance = clearance_of(bearings, bearing, speed) if stack is None else 0.0
            expansions = solids.journal.expansion, housing.expansion
            seat = BearingCase(bearing, own, lubricant, clearance, *expansions, stack=stack, rings=rings)
            with about(Text("{place} bearing, seat", place=called(bearing.name))):
                seats.append(sitting(seat, replace(duty, load=_load(bearing, shaft))))
        turning, films = condensed(bearings, rows, shaft), None
        sense = -1 if speed_ratio is not None and speed_ratio < 0 else 1
        if turning is not None and len(rows) > 2:
            films = shared(turning, seats, duty, sense)
            films = on_films(turning, films, seats, duty)
            with about(Text("shaft on its films")):
                loads = [reaction(R=P) for P in elements(films.carried.load)]
        else:
            loads = [_load(bearing, shaft) for bearing in rows]
        seats = _some_centred(seats, loads, duty)
        shares = at_corners(turning, films, seats, duty) if turning is not None and films is not None else {}
        for seat, load, housing in zip(seats, loads, solids.housings):
            place = seat.bearing.name
            with about(Text("{place} bearing", place=called(place))):
                slope, share = _slope(seat.bearing, shaft), shares.get(place)
                results[place] = _bearing(place, seat, load, slope, speed, bench, share, compared=compared)
                of_bearing = [*checks(place, results[place], housing)]
                all_checks += _by_row(seat.bearing, [*of_bearing, *_material_checks(place, results[place])])
        result = BearingsResult(bearings=results)
        if shaft is not None:
            result = on_shaft(result, shaft, turning, films, sense)
            result = turned_over(result) if how == "mirrors" else result
    all_checks += _slope_checks(shaft, results)
    all_checks += support_checks(result, films, shaft)
    all_checks += maker_checks(results, assembly, speed_ratio)
    if (pumping_check := oil_check(bearings, solids.oil)) is not None:
        all_checks.append(pumping_check)
    results = result.bearings
    return Outcome(
        "bearings",
        result=result,
        checks=tuple(all_checks),
        lines=tuple(lines),
        curves=Later(lambda: _curves(result)),
        tables=Later(lambda: _tables(results, speed, assembly, speed_ratio)),
        errata=Later(lambda: (e for place, r in results.items() for e in errata(place, r))),
        notes=Later(lambda: notes(bearings, shaft, results)),
        further=lambda: Further(curves=Later(lambda: charts(results))),
    )


def _by_row(row: BearingRow, found: list[Check]) -> list[Check]:
    """The checks of one bearing; what its row says of supply and seat itself moves them in place of what all share."""
    own = {dotted("bearings", entry): row_key(row.name, entry) for entry in ruled_by(row)}
    return [check.in_place(lambda key: (own.get(key, key),)) for check in found] if own else found


def _curves(result: BearingsResult) -> Iterator[Curve]:
    for place, r in result.bearings.items():
        yield from curves(place, r)
    yield from in_films(result)
    for place, r in result.bearings.items():
        yield from seat_curves(place, r)


def _tables(
    results: dict[str, BearingResult], speed: RevPerSecond, assembly: str | None, ratio: Number | None
) -> Iterator[Table]:
    for place, r in results.items():
        yield routes_table(place, r.side)
        yield corners_table(place, r.corners, r.seat)
        yield from seat_tables(place, r.seat, r.select)
        yield from warm_table(place, r, AT_ALL[:2])
    runs = {place: Running(r.specific_load, r.pressure_velocity, r.outlet_temperature) for place, r in results.items()}
    yield bushes_table(runs, [r.seat.inputs.bush_material or r.seat.inputs.housing_material for r in results.values()])
    sizes = {place: (r.seat.bearing.diameter, r.seat.bearing.length) for place, r in results.items()}
    yield reference_table(Journal(place, *sizes[place], speed, r.load) for place, r in results.items())
    beside_makers = makers_table([own_journal(place, r) for place, r in results.items()], assembly, ratio)
    if beside_makers is not None:
        yield beside_makers


def _material_checks(place: str, r: BearingResult) -> Iterator[Check]:
    """Advice by what the journal runs on, and by what bearings of this application usually carry."""
    inputs, bearing = r.seat.inputs, r.seat.bearing
    surface = running_surface(inputs.bush_material, inputs.housing_material)
    if surface is not None and (inputs.bush_material is not None or not bearing.ringed):
        T_in = inputs.supply_temperature
        yield from material_checks(place, surface, r.specific_load, r.pressure_velocity, r.outlet_temperature, T_in)
    yield from application_checks(
        place,
        application(inputs.application),
        p=r.specific_load,
        pv=r.pressure_velocity,
        mu=r.hot.oil.mu,
        mu_n_over_p=r.duty_number,
        psi=r.clearance / bearing.diameter,
        l_over_d=r.length_ratio,
    )


def clearance_of(inputs: BearingsInputs, bearing: BearingRow, speed: RevPerSecond) -> Metre:
    """As given, by the factor K, or the middle of the fits."""
    if bearing.clearance is not None:
        return bearing.clearance
    if bearing.clearance_factor is not None:
        return f.clearance_by_factor(
            K=bearing.clearance_factor, d=bearing.diameter, u=f.surface_speed(d=bearing.diameter, n=speed)
        )
    inputs = inputs.of(bearing)
    (ei, es), (EI, ES) = (
        tuple(based_on(x, fit, bearing.diameter) for x in deviations(parse(fit), bearing.diameter))
        for fit in (inputs.journal_fit, inputs.seat_fit)
    )
    return f.clearance_of_fits(EI=EI, ES=ES, ei=ei, es=es)


def _load(bearing: BearingRow, shaft: CountershaftResult | None) -> float:
    """As given, else the reaction of the shaft there."""
    if bearing.load is not None:
        return bearing.load
    return 0.0 if shaft is None else shaft.loads[bearing.name]


def condensed(
    bearings: BearingsInputs, rows: tuple[BearingRow, ...], shaft: CountershaftResult | None
) -> Condensed | None:
    """The turning shaft as its films know it; None where it is not known how it bends, where a load is given, which
    rules, and where the load does not turn with the journals in seats that stand."""
    if shaft is None or shaft.bending is None or any(row.load is not None for row in rows):
        return None
    if bearings.load_speed_ratio != TURNING or bearings.bush_speed_ratio != 0:
        return None
    turning = of_beam(shaft.bending.model, shaft.omega)
    return replace(turning, f_c=based_on(turning.f_c, shaft.bending.reactions))


def _some_centred(seats: list[BearingCase], loads: list[float], duty: OperatingPoint) -> list[BearingCase]:
    """The bearings, with those that carry next to nothing as centred.  Where all do, none has a film that is judged."""
    centred = [load <= 0 or runs_centred(seat, replace(duty, load=load)) for seat, load in zip(seats, loads)]
    if not all(centred):
        return [replace(seat, centred=True) if here else seat for seat, here in zip(seats, centred)]
    if max(loads) <= 0:
        advice = Text("give the counter-shaft eccentric masses that balance a couple")
        place = called(seats[0].bearing.name)
        raise NoSolution(Text("the {place} bearing carries no load", place=place), EMPTY, advice)
    return seats


def _slope(bearing: BearingRow, shaft: CountershaftResult | None) -> Radian | None:
    """As given, else as the bending of the shaft has it there; None where neither is known."""
    return bearing.slope if bearing.slope is not None or shaft is None else shaft.slopes.get(bearing.name)


def _slope_checks(shaft: CountershaftResult | None, results: dict[str, BearingResult]) -> Iterator[Check]:
    """Slopes that are given, held against those of the shaft as this design bends it: what stands on them stands on the
    given ones."""
    if shaft is None or shaft.bending is None:
        return  # where nothing bends, the shaft has its slopes from here
    for place, r in results.items():
        slope, bent = r.seat.bearing.slope, shaft.slopes.get(place)
        if bent is None or slope is None:
            continue
        with untraced():
            edge = f.film_at_edge(h_0=r.film, theta=bent, l=r.seat.bearing.length)
        effect = Text(
            "then that of the bending: film at the edge {edge}, needs {least}",
            edge=Amount(edge * 1e6, "µm"),
            least=Amount(r.kreisle_film * 1e6, "µm"),
        )
        left_out = by_key(BearingRow, row_key(place, BearingRow.slope), None, effect=effect)
        label = Text("Slope as given, {place}, against that of the shaft's bending", place=called(place))
        yield SLOPE_GIVEN(slope, bent, at=place, name=label, scale=SLOPE_TAKEN, remedies=left_out)


def operating_point(inputs: BearingsInputs, load: float, speed: RevPerSecond) -> OperatingPoint:
    i_B, i_F = inputs.bush_speed_ratio, inputs.load_speed_ratio
    n_B = f.bush_speed(i_B=i_B, n_J=speed) if i_B else based_on(0.0, i_B)
    n_F = based_on(speed, speed, i_F) if i_F == 1 else f.load_speed(i_F=i_F, n_J=speed)
    n_h = f.effective_speed(n_J=speed, n_B=n_B, n_F=n_F)
    slides = based_on(1.0, i_B, i_F)
    if n_B or n_h != speed:
        slides = f.sliding_ratio(n_J=speed, n_B=n_B, n_h=n_h)
    return OperatingPoint(load, speed, n_h, slides, inputs.supply_temperature, inputs.supply_pressure)


def _bearing(
    place: str,
    seat: BearingCase,
    load: float,
    slope: Radian | None,
    speed: RevPerSecond,
    bench: tuple[BenchPoint, ...],
    share: Array | None,
    *,
    compared: bool,
) -> BearingResult:
    inputs, bearing = seat.inputs, seat.bearing
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
    beside = compared and not seat.centred  # other methods have no film of a journal that runs centred
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
    return BearingResult(
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


def solve_film(
    *,
    diameter: Metre,
    length: Metre,
    clearance: Metre,
    load: Newton,
    speed: RevPerSecond,
    oil: str | Oil,
    supply_temperature: Celsius,
    supply_pressure: Pascal = 3e5,
    hole_diameter: Metre = 4e-3,
    load_speed_ratio: Number = 1.0,
    journal: str = "steel",
    housing: str = "steel",
    warm: bool = True,
) -> Film:
    """The film of one bearing in thermal balance, by this program's own solution of Reynolds' equation.

    `clearance`: diametral, at 20 °C.  `speed`: of the journal, revolutions per second.  `oil`: a name of the table, or
    an Oil. `load_speed_ratio`: 1, the load turns with the shaft; 0, it stands.  `journal`, `housing`: materials, by
    whose expansion the clearance changes (`warm` False: it keeps its size).  Raises NoSolution where there is no film.
    """
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
    row = oils()[oil] if isinstance(oil, str) else oil
    inputs = BearingsInputs(
        oil=row.name,
        supply_temperature=supply_temperature,
        supply_pressure=supply_pressure,
        supply="hole",
        hole_diameter=hole_diameter,
        housing_material=housing,
        load_speed_ratio=load_speed_ratio,
    )
    known = materials()
    case = BearingCase(bearing, inputs, Lubricant(row), clearance, known[journal].expansion, known[housing].expansion)
    return balanced(own_warm if warm else own_cold, case, operating_point(inputs, load, speed))
