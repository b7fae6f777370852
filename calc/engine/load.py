# SPDX-License-Identifier: Apache-2.0
"""The torque on the crank at any speed and load, order by order.

Two lines over the speed say the pressures of the cycle, that of full load and that without brake load; between them
each pressure, and the angle for which the peak is held, is linear in the load, and the torque follows anew.  Where no
row says it, the line without brake load is solved: its indicated mean pressure, gas exchange included, is that of the
engine's friction.  That pressure is linear in the pressures of the cycle, so that no search is needed."""

import math
from collections.abc import Callable, Sequence
from dataclasses import fields

import numpy as np

from ..library.table_file import house_table
from ..sheet.arrays import Array, BoolArray, ComplexArray
from ..sheet.errors import NoSolution
from ..sheet.formula import formula
from ..sheet.linked_array import gathered
from ..sheet.record import record, replace
from ..sheet.text import Amount, Text
from ..sheet.units import (
    KilogramPerMetre,
    KilogramPerMetre3,
    MetrePerSecond,
    NewtonMetres,
    Number,
    Numbers,
    Pascal,
    PascalSecond,
    PhasorNewtonMetres,
    Radian,
    Radians,
    RevPerSecond,
)
from ..sheet.value import based_on, untraced
from .crank import firing
from .cycle import MixedCycle
from .gas import GasInputs
from .gas_torque import Basis, all_cylinders, basis, expansion_from, integer, of_table, one_cylinder, orders_of
from .inputs import EngineInputs
from .operation import GasRow
from .result import EngineResult
from .torque import closed, prepare

ORDERS = 24.0  # on the crank, at least
FIRINGS = 16  # of the firing order
THERE = 1e-9  # of the cylinders: an order in which they leave less is none
UNTHROTTLED = 14.0  # compression ratio from which on the fuel alone makes the load
# rule of this program for the cycle without brake load
ATMOSPHERE, ABOVE_INTAKE, EXHAUST = 1.0e5, 0.05e5, 1.05e5  # Pa
HELD = math.radians(4.0)
PEAK = 0.8, 20.0  # of the end of compression
INTAKE = 0.1e5, 3.0e5  # Pa


# --- formulas


@formula(
    "S_p",
    "kinematics: mean speed of the piston, that at rated speed by the speed",
    meanings={"n": "Speed of the crank"},
)
def piston_speed(u_m: MetrePerSecond, n: RevPerSecond, n_r: RevPerSecond) -> MetrePerSecond:
    return u_m * n / n_r


@formula(
    "p_mf",
    "Heywood 1988, ch. 13: mean pressure of friction over speed, a_mf + b_mf·n + c_mf·n² + d_mf·S_p², fitted to the "
    "engine by κ",
    unit="bar",
    names={"kappa": "κ", "a": "a_mf", "b": "b_mf", "c": "c_mf", "d": "d_mf"},
    meanings={
        "n": "Speed of the crank",
        "a": "Constant of the rule of friction",
        "b": "Slope of the rule of friction over the speed",
        "c": "Factor of the speed squared in the rule of friction",
        "d": "Factor of the piston's speed squared in the rule of friction",
    },
)
def friction_pressure(
    kappa: Number,
    n: RevPerSecond,
    S_p: MetrePerSecond,
    a: Pascal,
    b: PascalSecond,
    c: KilogramPerMetre,
    d: KilogramPerMetre3,
) -> Pascal:
    """Of diesel engines and petrol engines, of which the numbers differ.

    >>> friction_pressure(kappa=1.0, n=15.0, S_p=3.21, a=75000.0, b=2880.0, c=0.0, d=400.0)
    122321.64
    """
    return kappa * (a + b * n + c * n**2 + d * S_p**2)


@formula(
    "κ",
    "rule of this program: what the rated power leaves of the indicated pressure, over the rule of friction",
    meanings={"p_mi": "Indicated mean pressure at rated power", "p_mf": "Mean pressure of friction by the rule"},
)
def friction_factor(p_mi: Pascal, p_me: Pascal, p_mf: Pascal) -> Number:
    return (p_mi - p_me) / p_mf


@formula(
    "p_mi,0",
    "rule of this program: what a row without load has above the rule of friction stays",
    unit="bar",
    meanings={
        "p_mi_r": "Indicated mean pressure of the row that is given",
        "p_mf_r": "Mean pressure of friction at the speed of that row",
    },
)
def indicated_without_load(p_mf: Pascal, p_mi_r: Pascal, p_mf_r: Pascal) -> Pascal:
    """`p_mi_r`, `p_mf_r`: of the row that is given, and of the rule at its speed."""
    return p_mf + (p_mi_r - p_mf_r)


@formula(
    "p_max,0",
    "energy: the indicated mean pressure is linear in the pressures of the cycle; the peak that gives it",
    unit="bar",
    meanings={
        "p_in": "Pressure of the intake",
        "p_ex": "Pressure of the exhaust",
        "k_max": "Mean pressure by that of the peak",
        "k_in": "Mean pressure by that of intake and compression",
        "k_ex": "Mean pressure by that of the exhaust",
    },
)
def peak_without_load(p_mi: Pascal, p_in: Pascal, p_ex: Pascal, k_max: Number, k_in: Number, k_ex: Number) -> Pascal:
    """`k_max`, `k_in`, `k_ex`: mean pressure by 1 Pa of the peak, of intake with compression, of exhaust."""
    return (p_mi - k_in * p_in - k_ex * p_ex) / k_max


@formula(
    "p_in,0",
    "energy: the indicated mean pressure is linear in the pressures of the cycle; the throttled intake that gives it",
    unit="bar",
    names={"ratio": "p_max/p_in"},
)
def intake_without_load(p_mi: Pascal, p_ex: Pascal, ratio: Number, k_max: Number, k_in: Number, k_ex: Number) -> Pascal:
    """`ratio`: of peak to intake pressure, which the throttle leaves as it is."""
    return (p_mi - k_ex * p_ex) / (k_in + ratio * k_max)


@formula(
    "T_m", "energy: mean torque of the gas of all cylinders; inertia adds nothing", shows="N·Re(t_0)/2, t_0 of one"
)
def mean_of_cylinders(t_0: PhasorNewtonMetres, N: Number) -> NewtonMetres:
    mean: Array = N * t_0.real / 2
    return mean


@formula(
    "t_n",
    "mathematics: Fourier analysis of the torque diagram, straight lines between its rows",
    shows="2/(ε_T·n²)·Σ s_j·(e^(−i·n·ε_j+1) − e^(−i·n·ε_j)), s_j the slopes",
)
def of_diagram(angles: Radians, T: NewtonMetres, period: Radian, n: Numbers) -> PhasorNewtonMetres:
    epsilon, torque = closed(angles, T, period)
    slopes = np.diff(torque) / np.diff(epsilon)
    turned = np.diff(np.exp(-1j * n[:, None] * epsilon), axis=1)
    harmonics: ComplexArray = (turned @ slopes) * 2 / (period * n**2)
    return harmonics


# --- the pressures of the cycle, as arrays over operating points


@record
class GasKeys:
    """Absolute pressures of the cycle in Pa, and the angle for which the peak is held, of P operating points."""

    p_max: Array
    p_in: Array
    p_ex: Array
    p_case: Array
    eps_p: Array

    def towards(self, other: "GasKeys", share: Array) -> "GasKeys":
        """Linear between two."""
        return GasKeys(*(a + share * (b - a) for a, b in zip(self.every, other.every)))

    @property
    def every(self) -> tuple[Array, ...]:
        return tuple(getattr(self, field.name) for field in fields(self))


@record
class GasLine:
    """The pressures over speed: linear between K speeds, which ascend, the ends held."""

    speeds: Array
    keys: GasKeys

    def at(self, n: Array) -> GasKeys:
        return GasKeys(*(np.asarray(np.interp(n, self.speeds, key), dtype=float) for key in self.keys.every))


@record
class CrankTorque:
    """On the crank at P operating points: T = T_m + Σ Re{t_n·e^{inε}}, gas and inertia, N orders that are there.

    `keys`: the pressures of the cycle, None where they are given as a table or diagram, which has one load only."""

    orders: Array
    t: ComplexArray  # (P, N) in N·m
    mean: Array  # (P,) in N·m
    cycle: Radian
    notes: tuple[Text, ...]
    keys: GasKeys | None


# --- the torque


def crank_torque(
    engine: EngineInputs,
    e: EngineResult,
    rows: Sequence[GasRow],
    speeds: Array,
    loads: Array,
    *,
    idle: RevPerSecond,
) -> CrankTorque:
    """Of an engine whose gas or torque is given, at speeds in 1/s and loads from 0 to 1 (both (P,)).

    `rows`: what is said of the gas at a speed and load.  Raises NoSolution where a load below 1 is asked for and
    nothing says, or gives, the cycle without brake load."""
    assert e.torque is not None
    if engine.gas is None:
        return _of_diagram(engine, speeds)
    with untraced():
        cycle = prepare(engine, e, engine.gas)
    n, inertia = _orders(engine, e)
    fires = firing(engine, e.crank).angles
    of_masses = inertia * ((speeds / float(engine.rated_speed)) ** 2)[:, None]
    of_masses = based_on(of_masses, e.torque.harmonics, e.angular_speed, speeds)
    every = np.append(0.0, n)
    keys: GasKeys | None = None
    if isinstance(cycle.given, MixedCycle):
        cylinder = Cylinder(engine, e, cycle.given, basis(engine, e, cycle, every))
        keys, notes = _keys(cylinder, engine.gas, rows, speeds, loads, idle)
        one = cylinder.harmonics(keys)
    else:
        one = np.tile(of_table(engine, e, cycle, every), (speeds.size, 1))
        notes = (ONE_LOAD,)
    no_spread = np.zeros(engine.cylinders)
    t = all_cylinders(t_one=based_on(one[:, 1:], one), t_inertia=of_masses, spread=no_spread, fires=fires, n=n)
    mean = mean_of_cylinders(t_0=based_on(one[:, 0], one), N=engine.cylinders)
    return CrankTorque(n, t, mean, float(cycle.length), notes, keys)


ONE_LOAD = Text("The gas is given for one load only and taken as given at every speed: idle is then not known.")


def highest_order(engine: EngineInputs) -> float:
    """Up to which order the torque on the crank is taken."""
    return max(FIRINGS * 2 * engine.cylinders / engine.strokes, ORDERS)


def _orders(engine: EngineInputs, e: EngineResult) -> tuple[Array, ComplexArray]:
    """Those in which the cylinders leave something, and the torque of the masses in them, at rated speed."""
    assert e.torque is not None
    n = orders_of(engine.strokes, highest_order(engine))
    inertia = integer(e.torque.harmonics, n)
    left = np.abs(np.exp(-1j * n[:, None] * firing(engine, e.crank).angles).sum(1))
    there = (left > THERE * engine.cylinders) | (inertia != 0)
    return n[there], inertia[there]


def _of_diagram(engine: EngineInputs, speeds: Array) -> CrankTorque:
    """The diagram has gas and inertia together, and stands for every speed and load."""
    rows, cycle = engine.torque, engine.strokes * math.pi
    assert rows, "no gas and no diagram: there is no torque"
    period = engine.torque_period if engine.torque_period is not None else cycle
    angles, T = gathered(row.angle for row in rows), gathered(row.torque for row in rows)
    n: Array = np.arange(1, math.floor(highest_order(engine) * period / (2 * math.pi)) + 1, dtype=float) * (
        2 * math.pi / period
    )
    t = of_diagram(angles=angles, T=T, period=period, n=n)
    epsilon, torque = closed(angles, T, period)
    mean = float(np.sum((torque[1:] + torque[:-1]) * np.diff(epsilon)) / 2 / period)
    turns = cycle / period
    length = cycle if abs(turns - round(turns)) < THERE * turns else period
    return CrankTorque(
        n, based_on(np.tile(t, (speeds.size, 1)), t), np.full(speeds.size, mean), float(length), (ONE_LOAD,), None
    )


@record
class Cylinder:
    """One cylinder of the mixed cycle, whose torque is linear in the pressures; the first order of `basis` is 0."""

    engine: EngineInputs
    e: EngineResult
    given: MixedCycle
    basis: Basis

    def parts(self, eps_p: Array) -> ComplexArray:
        """What 1 Pa does, of every operating point (P, 5, 1 + N)."""
        engine = self.engine
        return based_on(self.basis.parts(eps_p), engine.bore, engine.crank_radius, engine.rod_length, engine.gas)

    def harmonics(self, keys: GasKeys) -> ComplexArray:
        """t_0, twice the mean, and t_n (P, 1 + N) in N·m."""
        p_2 = keys.p_max * expansion_from(self.engine, self.e, self.given, keys.eps_p)
        p_max, p_in, p_ex, p_case, _ = keys.every
        parts = self.parts(keys.eps_p)
        return one_cylinder(basis=parts, p_max=p_max, p_2=p_2, p_ex=p_ex, p_in=p_in, p_case=p_case)

    def mean_pressures(self, eps_p: Array) -> tuple[Array, Array, Array]:
        """Indicated mean pressure by 1 Pa of the peak, of the intake with its compression, and of the exhaust."""
        parts = self.parts(eps_p)
        mean = parts[:, :, 0].real / 2
        by_torque = self.engine.strokes * math.pi * self.engine.cylinders / float(self.e.displacement)
        k_max = mean[:, 0] + mean[:, 1] * expansion_from(self.engine, self.e, self.given, eps_p)
        by = (k_max * by_torque, mean[:, 3] * by_torque, mean[:, 2] * by_torque)
        return based_on(by[0], parts), based_on(by[1], parts), based_on(by[2], parts)

    def mean_pressure(self, keys: GasKeys) -> Array:
        """Indicated, over the whole working cycle with its gas exchange, in Pa."""
        k_max, k_in, k_ex = self.mean_pressures(keys.eps_p)
        pressure: Array = k_max * keys.p_max + k_in * keys.p_in + k_ex * keys.p_ex
        return pressure


def _keys(
    cylinder: Cylinder, gas: GasInputs, rows: Sequence[GasRow], n: Array, loads: Array, idle: RevPerSecond
) -> tuple[GasKeys, tuple[Text, ...]]:
    """The pressures at every operating point, and what was taken for them."""
    full, notes = full_load(cylinder, gas, rows, idle)
    if any(0 < row.load < 1 for row in rows):
        notes += (PART_LOAD,)
    at_full = full.at(n)
    if np.all(loads == 1.0):
        return _linked(at_full, at_full, gas, rows), notes
    at_none, more = no_load(cylinder, gas, [row for row in rows if row.load == 0], full, n)
    return _linked(at_none.towards(at_full, loads), at_none, gas, rows), notes + more


PART_LOAD = Text("Rows of part load do not count here: the gas lies linearly between that of no load and of full load.")


def _linked(keys: GasKeys, at_none: GasKeys, gas: GasInputs, rows: Sequence[GasRow]) -> GasKeys:
    """They rest on what is solved without load, and on all that is said of the gas."""
    return GasKeys(*(based_on(key, none, gas, *rows) for key, none in zip(keys.every, at_none.every)))


def _given(cylinder: Cylinder, gas: GasInputs, rows: Sequence[GasRow]) -> GasLine:
    """What rows say, ascending; what they leave out is that of [engine.gas]."""
    engine, e, rows = cylinder.engine, cylinder.e, sorted(rows, key=lambda row: row.speed)
    with untraced():
        cycles = [prepare(engine, e, replace(gas, **row.changes)) for row in rows] or [prepare(engine, e, gas)]
    mixed = [cycle.given for cycle in cycles]
    values: list[list[float]] = [
        [float(g.p_max), float(g.p_in), float(g.p_ex), float(cycle.crankcase), float(g.eps_p)]
        for cycle, g in zip(cycles, mixed)
        if isinstance(g, MixedCycle)
    ]
    speeds = np.array([float(row.speed) for row in rows] or [float(engine.rated_speed)])
    return GasLine(speeds, GasKeys(*np.array(values).T))


# --- full load


def full_load(
    cylinder: Cylinder, gas: GasInputs, rows: Sequence[GasRow], idle: RevPerSecond
) -> tuple[GasLine, tuple[Text, ...]]:
    """The line of full load: its rows, else [engine.gas] at rated speed.  Towards idle a charged engine loses its
    boost where no row says what it has there."""
    line = _given(cylinder, gas, [row for row in rows if row.load == 1])
    boost = house_table("engine_motion.toml")["boost"]
    lowest, p_in = float(line.speeds[0]), float(line.keys.p_in[0])
    knee = min(boost["full_down_to"] * float(cylinder.engine.rated_speed), lowest)
    p_idle = boost["idle_intake_bar"] * 1e5
    if lowest <= idle or p_in <= p_idle or knee <= idle:
        return line, ()
    p_max, _, _, p_case, eps_p = (float(key[0]) for key in line.keys.every)
    at_idle = (p_max * p_idle / p_in, p_idle, boost["idle_exhaust_bar"] * 1e5, p_case, eps_p)
    before = [idle] if knee == lowest else [idle, knee]
    keys = (
        np.concatenate([[value], key[:1], key] if knee < lowest else [[value], key])
        for value, key in zip(at_idle, line.keys.every)
    )
    note = Text(
        "At full load the boost is taken to fall below {knee}, to {p} at idle speed: no row says what it has there.",
        knee=Amount(knee * 60, "rpm", form=".0f"),
        p=Amount(p_idle / 1e5, "bar", form="g"),
    )
    return GasLine(np.append(np.array(before, dtype=float), line.speeds), GasKeys(*keys)), (note,)


# --- no brake load


def no_load(
    cylinder: Cylinder, gas: GasInputs, rows: Sequence[GasRow], full: GasLine, n: Array
) -> tuple[GasKeys, tuple[Text, ...]]:
    """The pressures without brake load: between its rows, from the one row on, or solved.  Raises NoSolution."""
    line = _given(cylinder, gas, rows)
    if len(rows) > 1 or (rows and cylinder.engine.strokes == 2):
        return line.at(n), ()
    if cylinder.engine.strokes == 2:
        raise NoSolution(
            Text("the no-load cycle of a two-stroke is not solved"),
            advice=Text("give an [[engine.operation]] row with load_percent = 0"),
        )
    friction, fitted = friction_of(cylinder, gas, full)
    p_mf = friction(n)
    at_full, free = full.at(n), unthrottled(gas)
    if rows:
        row = line.at(n)
        own = float(cylinder.mean_pressure(line.keys)[0])
        p_mi = indicated_without_load(p_mf=p_mf, p_mi_r=own, p_mf_r=float(friction(line.speeds)[0]))
        follows = Text("Without brake load the gas follows the friction of the engine, from the row that is given")
        return _solved(cylinder, row, row.p_max / row.p_in, p_mi, n, free), (_said(follows, fitted),)
    if free:
        p_in = np.minimum(at_full.p_in, ATMOSPHERE)
        start = replace(at_full, p_in=p_in, p_ex=p_in + ABOVE_INTAKE, eps_p=np.minimum(at_full.eps_p, HELD))
    else:
        start = replace(at_full, p_ex=np.full(n.size, EXHAUST))
    overcomes = Text("Without brake load the gas is that which overcomes the friction of the engine")
    return _solved(cylinder, start, at_full.p_max / at_full.p_in, p_mf, n, free), (_said(overcomes, fitted),)


def _said(what: Text, fitted: float | None) -> Text:
    if fitted is None:
        return Text("{what}; friction by a rule of practice.", what=what)
    return Text("{what}; friction by a rule of practice times {kappa}, which the rated power asks for.",
                what=what, kappa=Amount(fitted, form=".3g"))  # fmt: skip


def unthrottled(gas: GasInputs) -> bool:
    """Whether the fuel alone makes the load."""
    if gas.charge is not None:
        return gas.charge == "unthrottled"
    return gas.compression_ratio is not None and gas.compression_ratio >= UNTHROTTLED


def friction_of(cylinder: Cylinder, gas: GasInputs, full: GasLine) -> tuple[Callable[[Array], Array], float | None]:
    """The mean pressure of friction over speeds in 1/s, and the factor by which the rated power fits it to the engine;
    None where that is not given, or leaves nothing."""
    row = house_table("engine_motion.toml")["friction"]["unthrottled" if unthrottled(gas) else "throttled"]
    a, d = row["constant_bar"] * 1e5, row["piston_bar"] * 1e5
    b, c = row["speed_bar"] * 1e5 * 60 / 1000, row["square_bar"] * 1e5 * (60 / 1000) ** 2

    def rule(n: Array, kappa: float = 1.0) -> Array:
        S_p = piston_speed(u_m=cylinder.e.mean_piston_speed, n=n, n_r=cylinder.engine.rated_speed)
        pressure: Array = friction_pressure(kappa=kappa, n=n, S_p=S_p, a=a, b=b, c=c, d=d)
        return pressure

    p_me = cylinder.e.brake_mean_pressure
    if p_me is None:
        return rule, None
    rated = np.array([float(cylinder.engine.rated_speed)])
    with untraced():
        p_mi, p_mf = float(cylinder.mean_pressure(full.at(rated))[0]), float(rule(rated)[0])
    if p_mi <= p_me:
        return rule, None
    kappa = friction_factor(p_mi=p_mi, p_me=p_me, p_mf=p_mf)
    return (lambda n: rule(n, kappa)), kappa


def _solved(cylinder: Cylinder, start: GasKeys, ratio: Array, p_mi: Array, n: Array, free: bool) -> GasKeys:
    """The cycle whose indicated mean pressure is p_mi: by its peak, or throttled by its intake with a peak that keeps
    its ratio to it.  Raises NoSolution where that leaves what an engine can have."""
    k_max, k_in, k_ex = cylinder.mean_pressures(start.eps_p)
    if free:
        p_max = peak_without_load(p_mi=p_mi, p_in=start.p_in, p_ex=start.p_ex, k_max=k_max, k_in=k_in, k_ex=k_ex)
        assert cylinder.engine.gas is not None and cylinder.engine.gas.compression_ratio is not None
        p_c = start.p_in * float(cylinder.engine.gas.compression_ratio) ** float(cylinder.given.n_c)
        _within((p_max >= PEAK[0] * p_c) & (p_max <= PEAK[1] * p_c), Text("no peak pressure"), p_mi, n)
        return replace(start, p_max=p_max)
    p_in = intake_without_load(p_mi=p_mi, p_ex=start.p_ex, ratio=ratio, k_max=k_max, k_in=k_in, k_ex=k_ex)
    _within((p_in >= INTAKE[0]) & (p_in <= INTAKE[1]), Text("no intake pressure"), p_mi, n)
    return replace(start, p_in=p_in, p_max=ratio * p_in)


def _within(can: BoolArray, what: Text, p_mi: Array, n: Array) -> None:
    if can.all():
        return
    i = int(np.argmin(can))
    raise NoSolution(
        Text(
            "{what} gives the friction pressure of {p} at {n}",
            what=what,
            p=Amount(float(p_mi[i]) / 1e5, "bar", form=".3g"),
            n=Amount(float(n[i]) * 60, "rpm", form=".0f"),
        ),
        advice=Text("give the row of load 0"),
    )
