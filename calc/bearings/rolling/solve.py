# SPDX-License-Identifier: Apache-2.0
"""One rolling bearing: what it is made of; its load, life, friction and clearance at rated speed and over its duty."""

import math
from collections.abc import Iterator
from typing import Any, cast

import numpy as np

from ...countershaft.rows import BearingRow, called
from ...engine.operation import Operation
from ...library.lubricant import Lubricant
from ...sheet.arrays import Array
from ...sheet.functions import largest
from ...sheet.linked_array import elements, gathered, item
from ...sheet.quantity import result
from ...sheet.record import record
from ...sheet.text import Text
from ...sheet.units import Celsius, Metre, Newton, Number, Radian, RevPerSecond, Second
from ...sheet.value import about, based_on, untraced
from ..formulas import load_at_speed, load_peak
from ..inputs import BearingsInputs
from ..support import Solids, StandingLoads, Task
from . import ratings as r
from .balance import (
    HeatBalance,
    asked,
    balanced_temperature,
    carried_off,
    heat_balance,
    heat_conductance,
    heat_surface,
    jet_flow,
    largest_speed_factor,
    limiting_speed,
    loss_of_duty,
    minimum_load,
    minimum_load_speed,
    reference_speed,
    speed_factor,
)
from .clearance import Clearances, Mounting, clearances, fits_of, metal_of_seat
from .contact import (
    Springs,
    contact_constant,
    displacement,
    largest_load,
    load_zone,
    pass_frequency,
    pressure_of,
    reach,
    stiffness,
)
from .geometry import Inside, gamma_of, inner_raceway, mass_of, mean_diameter, outer_raceway
from .inputs import Duty
from .life import Lives, life_of_duty, lives, reliability_factor, with_clearance
from .load import (
    Races,
    equivalent,
    friction_mean_of,
    means_of,
    on_ring,
    races_of,
    ring_factor_of,
    static_load,
    static_safety,
)
from .result import DutyRowResult, RollingResult
from .sizes import BearingSize
from .torque import Friction, friction_of
from .zone import EXPONENTS

NOTHING: Newton = 1e-9  # a load that no element feels
SLOWEST, FASTEST, SPEEDS = 0.1, 1.1, 21  # of the rated speed: where the least load is looked for


@record
class RollingCase:
    """One rolling bearing with all that does not depend on its load, its speed and its oil.

    `inside`: None of one of its own of which only the ratings are known; what follows from it is None then too.
    `computed`: the ratings of the standards with it.  `outline_speed`: reference speed, 1/s."""

    row: BearingRow
    inputs: BearingsInputs
    lubricant: Lubricant
    solids: Solids
    size: BearingSize[float]
    inside: Inside[float] | None
    ratings: r.Ratings
    computed: r.Ratings | None
    friction: Friction[float]
    heat: float  # W/K
    reference: RevPerSecond
    mean_diameter: Metre
    mounting: Mounting[float]
    contact: Newton | None
    races: Races | None

    @property
    def pitch(self) -> Metre:
        return self.mean_diameter if self.inside is None else self.inside.pitch

    def nu(self, T: Any) -> Any:
        return self.lubricant.nu(T)

    def springs(self, gap: Any) -> Springs | None:
        """Its elements with a clearance, m; None where they are not known."""
        if self.inside is None or gap is None:
            return None
        return Springs(self.inside.elements, self.inside.count, self.contact, gap)

    def warm(self, F: Any, n: Any, T_oil: Any) -> HeatBalance[Any]:
        """Where it carries off what it makes under the mean load F."""
        return heat_balance(self.friction, F, n, T_oil, self.heat, self.nu)

    def temperatures(self, F: Any, n: Any, T_oil: Any) -> Any:
        """The temperatures at which it does, without a line; not a number where it does not."""
        return balanced_temperature(self.friction, F, n, T_oil, self.heat, self.nu)

    def clearances(self, T_b: Celsius) -> Clearances | None:
        if self.inside is None or self.mounting.fits.free is None:
            return None
        return clearances(self.mounting, T_b, self.inputs.lowest_temperature, self.inputs.ring_temperature)

    def grip(self, T_b: Celsius) -> Metre | None:
        """The loosest fit of its outer ring or cup; None of a cage."""
        grip: Metre | None = self.mounting.grip(T_b)
        return grip


def case_of(row: BearingRow, inputs: BearingsInputs, solids: Solids) -> RollingCase:
    size, inside = row.outline, row.inside
    assert size is not None  # asked of the file
    place = called(row.name)
    d, D, B = (based_on(x, row.size) for x in (size.bore, size.outside, size.width))
    with about(Text("{place} bearing, ratings", place=place)):
        HV = None if size.inner_ring else row.raceway_hardness
        computed = None if inside is None else r.computed(inside, size.usual.rating, HV)
        d_m = mean_diameter(d=d, D=D)
        C, C_0 = row.dynamic_rating, row.static_rating
        if computed is not None:
            C, C_0 = (known if known is not None else x for known, x in ((C, computed.dynamic), (C_0, computed.static)))
        assert C is not None and C_0 is not None  # asked of the file
        C_u = row.fatigue_limit
        if C_u is None and computed is not None and row.static_rating is None:
            C_u = computed.fatigue
        elif C_u is None:
            C_u = r.fatigue_limit(size.elements, C_0, d_m if inside is None else inside.pitch)
        ratings = r.Ratings(C, C_0, C_u, None if computed is None else computed.f_0)
    with about(Text("{place} bearing, friction", place=place)):
        what: dict[str, Any] = dict(
            static_rating=C_0, base=solids.lubricant.oil.base, f_0=row.palmgren_f0, f_1=row.palmgren_f1
        )
        friction: Friction[float] = friction_of(
            size.type, size.series, d, D, B, lubrication=inputs.rolling_lubrication, **what
        )
        heat = row.heat
        if heat is None:
            heat = heat_conductance(A=heat_surface(B=B, d=d, D=D))
    with about(Text("{place} bearing, speed", place=place)):
        in_bath: Friction[float] = friction_of(size.type, size.series, d, D, B, lubrication="bath", **what)
        reference = reference_speed(in_bath, B)
    with about(Text("{place} bearing, fits", place=place)):
        metal = metal_of_seat(solids.housing, row.outer_ring_held)
        fits = fits_of(
            size.type,
            d,
            D,
            inner_ring=size.inner_ring,
            shaft_fit=row.shaft_fit,
            seat_fit=row.seat_fit,
            clearance_class=row.clearance_class,
            clearance=None if row.clearance_limits is None else (row.clearance_limits[0], row.clearance_limits[1]),
        )
        raceways: dict[str, Any] = dict(inner_raceway=None, outer_raceway=None)
        if inside is not None:
            raceways = dict(
                inner_raceway=inner_raceway(D_pw=inside.pitch, D_w=inside.diameter),
                outer_raceway=outer_raceway(D_pw=inside.pitch, D_w=inside.diameter),
            )
        mounting = Mounting(
            type=size.type,
            bore=d,
            outside=D,
            **raceways,
            fits=fits,
            housing_expansion=metal.expansion,
            housing_modulus=metal.E,
            housing_poisson=metal.poisson,
            restraint=inputs.expansion_restraint,
            housing_outer=row.housing_outer,
            journal_expansion=solids.journal.expansion,
            shaft_bore=solids.shaft_bore,
        )
    contact = races = None
    if inside is not None:
        with about(Text("{place} bearing, stiffness", place=place)):
            contact = contact_constant(inside)
        with about(Text("{place} bearing, load on its races", place=place)):
            races = races_of(inside)
    return RollingCase(
        row=row,
        inputs=inputs,
        lubricant=solids.lubricant,
        solids=solids,
        size=size,
        inside=inside,
        ratings=ratings,
        computed=computed,
        friction=friction,
        heat=heat,
        reference=reference,
        mean_diameter=d_m,
        mounting=mounting,
        contact=contact,
        races=races,
    )


# --- the duty


@record
class Rows:
    """What a bearing has to do, a number a row: speed of the shaft 1/s, share of the hours, oil °C, load that stands
    besides N, factor on the load that turns."""

    names: tuple[str, ...]
    n: Array
    share: Array
    T_oil: Array
    extra: Array
    factor: Array
    road: tuple[float | None, ...]  # m/s


def rows_of(inputs: BearingsInputs, task: Task) -> Rows | None:
    """The duty as it is given, else by the operation of the engine; None where neither is: rated speed alone."""
    given: list[Duty | Operation] = [*inputs.duty] or [row for row in task.operation if row.hours]
    if not given:
        return None
    ratio = abs(task.ratio) if task.ratio is not None else 1.0
    hours = np.array([row.hours or 0.0 for row in given])
    T_in = inputs.supply_temperature
    duties = [row if isinstance(row, Duty) else None for row in given]
    return Rows(
        names=tuple(row.name for row in given),
        n=gathered([based_on(row.speed * ratio, row.speed, task.ratio) for row in given]),
        share=based_on(hours / hours.sum(), *(row.hours for row in given)),
        T_oil=gathered([T_in if row.oil_temperature is None else row.oil_temperature for row in given]),
        extra=gathered([0.0 if row is None else row.extra_load for row in duties]),
        factor=gathered([1.0 if row is None else row.load_factor for row in duties]),
        road=tuple(None if row is None else row.road_speed for row in duties),
    )


# --- one state, or a row of them


@record
class State:
    """What a bearing does at one point, or at a row of them."""

    F_1: Any
    F_2: Any
    F_m: Any
    F_f: Any
    P: Any
    heat: HeatBalance[Any]
    lives: Lives


def state(case: RollingCase, n: Any, F_1: Any, F_2: Any, F_a: Newton, T_oil: Any, a_1: Number, T_b: Any) -> State:
    """Under F_1 that turns and F_2 that stands, N, at n, 1/s, with oil of T_oil, °C, which warms it to T_b."""
    elements = case.size.elements
    F_m, F_f = means_of(F_1, F_2, EXPONENTS[elements].p)
    P = on_ring(case.races, F_m, F_1 >= F_2)
    if F_a > 0:
        P = equivalent(case.size, case.ratings, P, F_a)
    asked(T_b, F_f, n, T_oil)
    heat: HeatBalance[Any] = carried_off(case.friction, F_f, n, T_oil, case.heat, case.nu, T_b)
    some = largest(P, NOTHING) if np.ndim(P) or P <= 0 else P
    return State(
        F_1, F_2, F_m, F_f, P, heat, lives(
            elements, case.pitch, case.ratings, some, n, heat.viscosity, case.inputs.cleanliness, a_1
        ),
    )  # fmt: skip


def with_gap(case: RollingCase, at: State, n: Any, gap: Metre | None, a_1: Number) -> Lives | None:
    """The life with the zone that the clearance leaves."""
    springs = case.springs(gap)
    if springs is None or case.races is None:
        return None
    P = with_clearance(case.races, springs, largest(at.P, NOTHING), largest(at.F_m, NOTHING), at.F_1 >= at.F_2)
    return lives(case.size.elements, case.pitch, case.ratings, P, n, at.heat.viscosity, case.inputs.cleanliness, a_1)


@result
class LoadedBearing(RollingResult):
    """A rolling bearing under its load, and what its numbers were found from.

    `stands`: what does not turn with the shaft; `axial`: along the shaft, on this bearing; `gap`: its clearances;
    `slope`: of the journal, None where nobody knows it."""

    case: RollingCase
    task: Task
    stands: StandingLoads
    rows: Rows | None
    gap: Clearances | None
    axial: Newton
    slope: Radian | None
    carries: tuple[tuple[Newton, Newton], ...]  # in each row of the duty, else at rated speed: the load, and the least

    hottest: Celsius  # of the rated point and the rows of the duty

    @property
    def row(self) -> BearingRow:
        return self.case.row


@record
class WarmPoints:
    """What it does at rated speed, in the rows of its duty, and at the speeds of a sweep, one after the other."""

    T_b: Array  # °C; not a number where it does not carry off its heat
    speeds: Array  # of the sweep alone
    rows: slice
    sweep: slice


def warm_points(case: RollingCase, F: Newton, stands: StandingLoads, rows: Rows | None, task: Task) -> WarmPoints:
    """All temperatures at once."""
    n, T_oil = float(task.speed), float(case.inputs.supply_temperature)
    speeds = np.linspace(SLOWEST, FASTEST, SPEEDS) * n
    swept = speeds if case.row.minimum_load is None and case.size.type == "ball" else speeds[:0]
    more: Any = [np.zeros(0)] * 4 if rows is None else [rows.n, rows.T_oil, rows.extra, rows.factor]
    none = np.zeros(len(swept))
    points, oil, extra, factor = (
        np.concatenate([[rated], row, sweep])
        for rated, row, sweep in zip((n, T_oil, 0.0, 1.0), more, (swept, none + T_oil, none, none + 1))
    )
    with untraced():
        F_f = friction_mean_of(factor * load_at_speed(F=float(F), n=points, n_0=n), float(stands.all) + extra)
        T_b = np.atleast_1d(case.temperatures(F_f, points, oil))
    count = len(more[0])
    return WarmPoints(T_b, speeds, slice(1, 1 + count), slice(1 + count, None))


def solve(case: RollingCase, F: Newton, stands: StandingLoads, slope: Radian | None, task: Task) -> dict[str, Any]:
    """The bearing under F that turns with the shaft and what stands, over its duty: the fields of a LoadedBearing."""
    row, inputs, n, place = case.row, case.inputs, task.speed, called(case.row.name)
    rows, T_oil = rows_of(inputs, task), inputs.supply_temperature
    F_a = row.axial_load if row.axial_load is not None else stands.axial if row.locates else 0.0
    found = warm_points(case, F, stands, rows, task)
    with about(Text("{place} bearing, duty", place=place)):
        a_1 = reliability_factor(R=inputs.reliability)
    with about(Text("{place} bearing, at rated speed", place=place)):
        rated = state(case, n, F, stands.all, F_a, T_oil, a_1, found.T_b[0].item())
        S_0 = None
        P_0 = static_load(k_s=inputs.shock_factor, F_1=F, o=inputs.overspeed, F_2=stands.all)
        if P_0 > 0:
            S_0 = static_safety(C_0=case.ratings.static, P_0=P_0)
        T_b, nu = rated.heat.temperature, rated.heat.viscosity
        least = least_load(case, n, nu)
        oil = case.lubricant.at(T_oil)
        jet = jet_flow(P=rated.heat.loss, rho=oil.rho, c_p=oil.cp)
        factor = speed_factor(n=n, d_m=case.mean_diameter)
    with about(Text("{place} bearing, clearance", place=place)):
        gap = case.clearances(T_b)
        grip = case.grip(T_b) if gap is None else gap.grip_hot
    running = None if gap is None else gap.running
    n_rows: Any = n
    share, done = None, rated
    with about(Text("{place} bearing, duty", place=place)):
        if rows is not None:
            n_rows, share = rows.n, rows.share
            F_1 = load_at_speed(F=F, n=rows.n, n_0=n)
            F_1 = based_on(rows.factor * F_1, rows.factor, F_1)
            F_2 = based_on(stands.all + rows.extra, stands.all, rows.extra)
            done = state(case, rows.n, F_1, F_2, F_a, rows.T_oil, a_1, found.T_b[found.rows])
        basic = _miner(share, done.lives.basic, done.P)
        life = _miner(share, done.lives.modified, done.P)
        at_gap = with_gap(case, done, n_rows, running, a_1)
        reference = None if at_gap is None else _miner(share, at_gap.modified, done.P)
        loss = rated.heat.loss if share is None else loss_of_duty(w=share, P_i=done.heat.loss)
    elastic: dict[str, Any] = {}
    springs = case.springs(running)
    if case.inside is not None:
        with about(Text("{place} bearing, stiffness", place=place)):
            if springs is not None and rated.F_m > 0:
                elastic = _elastic(case.inside, springs, rated.F_m)
            elastic["pass_frequency"] = pass_frequency(Z=case.inside.count, n=n, gamma=gamma_of(case.inside))
    with untraced():
        carries = _carries(case, F, stands, done, n_rows, n)
        slow = _least_speed(case, F, stands, found, n)
        torques = case.friction.by_two_parts(rated.F_f, n, nu), case.friction.by_palmgren(rated.F_f, n, nu)
        mass = mass_of(case.size)
    by_name = {} if rows is None else dict(zip(rows.names, _by_row(done)))
    computed = case.computed
    return dict(
        case=case,
        task=task,
        stands=stands,
        rows=rows,
        gap=gap,
        axial=F_a,
        slope=slope,
        carries=carries,
        hottest=max(T_b, item(done.heat.temperature[done.heat.temperature.argmax()])) if rows is not None else T_b,
        life=life,
        life_basic=basic,
        life_reference=reference,
        friction_power=rated.heat.loss,
        duty_loss=loss,
        running_temperature=T_b,
        load=F,
        standing_load=stands.all,
        load_peak=load_peak(F=F, R_0=stands.all),
        mean_load=rated.F_m,
        friction_load=rated.F_f,
        ring_factor=ring_factor_of(case.races) if F >= stands.all else 1.0,
        equivalent_load=rated.P,
        dynamic_rating=case.ratings.dynamic,
        static_rating=case.ratings.static,
        fatigue_limit=case.ratings.fatigue,
        dynamic_rating_computed=None if computed is None else computed.dynamic,
        static_rating_computed=None if computed is None else computed.static,
        viscosity_ratio=rated.lives.kappa,
        contamination_factor=rated.lives.contamination,
        life_factor=rated.lives.factor if rated.P > 0 else None,
        static_safety=S_0,
        torque=rated.heat.torque,
        torque_two_part=torques[0],
        torque_palmgren=torques[1],
        speed_factor=factor,
        reference_speed=case.reference,
        minimum_load=least,
        minimum_load_speed=slow,
        clearance_running=running,
        clearance_least=None if gap is None else gap.least,
        clearance_most=None if gap is None else gap.most,
        clearance_cold=None if gap is None else gap.frozen,
        clearance_start=None if gap is None else gap.start,
        clearance_mounted=None if gap is None else gap.mounted,
        grip_hot=grip,
        seat_diameter=case.size.outside,
        bearing_mass=mass,
        oil_flow=0.0,
        jet_flow=jet,
        duty=by_name,
        **elastic,
    )


def _miner(share: Array | None, L: Any, P: Any) -> Second | None:
    """The life over the duty; None where nothing loads the bearing."""
    if not np.any(np.asarray(P) > 0):
        return None
    life: Any = L if share is None else life_of_duty(w=share, L_i=L)
    return cast(Second, life)


def _by_row(done: State) -> Iterator[DutyRowResult]:
    every = (done.heat.loss, done.P, done.lives.basic, done.lives.kappa, done.lives.factor)
    for loss, P, basic, kappa, a_ISO in zip(*map(elements, every)):
        yield DutyRowResult(
            loss=loss,
            equivalent_load=P,
            life_basic=basic if P > 0 else None,
            viscosity_ratio=kappa,
            life_factor=a_ISO if P > 0 else None,
        )


def _elastic(inside: Inside[float], springs: Springs, F_m: Newton) -> dict[str, Any]:
    """How the elements share the load, and what that does to them."""
    sizes: dict[str, Any] = dict(Z=inside.count, K_1=springs.contact, s=springs.gap, elements=inside.elements)
    delta = displacement(F=F_m, **sizes)
    Q = F_m if springs.alone(delta) else largest_load(
        K_1=springs.contact, delta=delta, s=springs.gap, n_c=EXPONENTS[inside.elements].n
    )  # fmt: skip
    pressure, depth = pressure_of(inside, Q)
    return dict(
        stiffness=stiffness(delta=delta, **sizes),
        load_zone=load_zone(eps=reach(s=springs.gap, delta=delta)),
        contact_pressure=pressure,
        shear_depth=depth,
    )


# --- the least load: of what turns and of the weight, since no other load is there for sure


def least_load(case: RollingCase, n: Any, nu: Any) -> Any:
    """What it has to carry at least at n, 1/s, in oil of ν, m²/s, as it is in the bearing."""
    if case.row.minimum_load is not None:
        return case.row.minimum_load
    size = case.size
    return minimum_load(size.type, size.series, case.mean_diameter, n, nu, case.reference, case.ratings.dynamic)


def _carries(
    case: RollingCase, F: Newton, stands: StandingLoads, done: State, n_rows: Any, n: RevPerSecond
) -> tuple[tuple[Newton, Newton], ...]:
    loads = friction_mean_of(done.F_1, stands.weight + 0.0 * done.F_1)
    both = np.broadcast_arrays(*np.atleast_1d(loads, least_load(case, n_rows, done.heat.viscosity)))
    return tuple(zip(*(x.tolist() for x in both)))


def _least_speed(
    case: RollingCase, F: Newton, stands: StandingLoads, found: WarmPoints, n: RevPerSecond
) -> RevPerSecond | None:
    """The lowest speed from which the load is large enough; None: not at the fastest."""
    speeds, T_b = found.speeds, found.T_b[found.sweep]
    loads = friction_mean_of(F * (speeds / n) ** 2, stands.weight + 0.0 * speeds)
    least = least_load(case, speeds, case.nu(T_b) if len(T_b) else 0.0)
    slow = float(minimum_load_speed(speeds, loads, least + 0.0 * loads))
    return slow if math.isfinite(slow) else None


def least_loads(case: RollingCase, F_1: Any, weight: Newton, n: Any, T_oil: Any) -> tuple[Any, Any]:
    """The mean load of what turns and the weight, and what it has to be at least."""
    F_f = friction_mean_of(F_1, weight + 0.0 * F_1)
    nu = case.warm(F_f, n, T_oil).viscosity if case.size.type == "ball" else 0.0
    return F_f, least_load(case, n, nu) + 0.0 * F_f


def largest_speed(case: RollingCase) -> RevPerSecond:
    """The speed up to which the bearing may turn: the maker's, else by n·d_m of its type."""
    if case.row.limiting_speed is not None:
        return case.row.limiting_speed
    return limiting_speed(X=largest_speed_factor(case.size.type, case.size.series), d_m=case.mean_diameter)
