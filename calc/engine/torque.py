# SPDX-License-Identifier: Apache-2.0
"""The torque about the crank: of the inertia always, of the gas where a cycle, a pressure or a diagram is given.

In order: what any torque gives, the formulas, the torque at any crank angles, its curves, a torque given as a diagram.

Torque is positive in the sense of rotation.  The block feels the opposite, and with an offset cylinder the moment of
the inertia force, which acts along the cylinder's axis, at the distance d from the crank's.  ε is the crank angle after
the firing of cylinder 1. Cylinder k then stands ε − f_k after its own firing, which is the same as α_k = θ + φ_k − ψ_k
with θ the angle of throw 1 from up."""

import math
from typing import overload

import numpy as np

from ..sheet.arrays import Array, ComplexArray, Num
from ..sheet.deferred import Later, Many
from ..sheet.formula import formula
from ..sheet.functions import modulus, pi, resultant
from ..sheet.linked_array import elements, gathered, item
from ..sheet.quantity import Described, Stated
from ..sheet.record import replace
from ..sheet.step import Curve, Series, axis_label
from ..sheet.text import Amount, Text
from ..sheet.units import (
    CubicMetre,
    KilogramMetre2,
    Metre,
    Newton,
    NewtonMetre,
    NewtonMetres,
    Number,
    Pascal,
    PhasorNewtonMetre,
    PhasorNewtonMetres,
    Radian,
    Radians,
    RadPerSecond,
    Watt,
)
from ..sheet.value import about, based_on, untraced
from . import cycle as c
from . import formulas as f
from .cycle import TURN, Cycle
from .gas import COMPRESSION, CRANKCASE, EXHAUST, EXPANSION, HELD, INTAKE, GasInputs
from .inputs import EngineInputs
from .result import EngineResult, TorqueResult

# --- the gas of an engine's cylinders: its cycle from what the design says, and what is taken for numbers left out


def prepare(engine: EngineInputs, e: EngineResult, gas: GasInputs) -> Cycle:
    """The cycle of an engine's cylinders, with what was taken for numbers left out."""
    length = based_on(engine.strokes * math.pi, engine.strokes)
    notes: list[Text] = []

    def taken(given: float | None, otherwise: float, words: str) -> float:
        if given is None:
            notes.append(Text("{words} taken, since none is given.", words=words))
        return otherwise if given is None else given

    crankcase = taken(gas.crankcase_pressure, CRANKCASE, Text("A crankcase pressure of 1.0 bar"))
    if gas.pressure:
        angles = gathered(point.angle for point in gas.pressure)
        pressures = gathered(point.pressure for point in gas.pressure)
        corners = based_on(np.sort(np.mod(angles, length)), angles)
        from_, gap = c.widest_gap(corners, length)
        if gap > c.WIDE:
            start, end = math.degrees(from_), math.degrees(from_ + gap)
            notes.append(
                Text(
                    "The pressure table has no point between {start}° and {end}°: a straight line is taken there.",
                    start=Amount(start, form=".4g"),
                    end=Amount(end, form=".4g"),
                )
            )
        return Cycle(length, crankcase, corners, (angles, pressures), tuple(notes))
    assert gas.peak_pressure is not None and gas.compression_ratio is not None
    p_in = taken(gas.intake_pressure, INTAKE, Text("An intake pressure of 1.0 bar"))
    p_ex = p_in
    if engine.strokes == 4:
        p_ex = taken(gas.exhaust_pressure, EXHAUST, Text("An exhaust pressure of 1.1 bar"))
    else:
        notes.append(Text("The ports of the two-stroke engine are neglected: expansion and compression reach to BDC."))
    n_c = taken(gas.compression_exponent, COMPRESSION, Text("A compression exponent of 1.35"))
    n_e = taken(gas.expansion_exponent, EXPANSION, Text("An expansion exponent of 1.28"))
    eps_p = taken(gas.constant_pressure_angle, HELD, Text("A peak pressure held for 10° of crank angle"))
    eps_bdc = c.dead_centre_angle(delta=e.delta, lam=e.lambda_)
    h_c = c.clearance_height(s=e.stroke, eps_c=gas.compression_ratio)
    p_c = c.compression_end(p_in=p_in, eps_c=gas.compression_ratio, n_c=n_c)
    alpha = c.crank_angle(phi_0=e.tdc_angle, epsilon=eps_p)
    beta = f.rod_angle(lam=e.lambda_, alpha=alpha, delta=e.delta)
    x_p = c.piston_way(r=engine.crank_radius, lam=e.lambda_, phi_0=e.tdc_angle, alpha=alpha, beta=beta)
    corners = np.array(sorted({0.0, eps_p, eps_bdc, length - TURN, length - TURN + eps_bdc}))
    corners = based_on(corners, eps_p, eps_bdc, engine.strokes)
    given = c.MixedCycle(e.stroke, gas.peak_pressure, p_in, p_ex, n_c, n_e, eps_p, eps_bdc, h_c, x_p)
    return Cycle(length, crankcase, corners, given, tuple(notes), p_c)


ORDERS = 8
POINTS = 720  # over a turn, for the inertia torque
SMALL = 1e-9  # of the largest: an order so small is dust
DRAWN = math.radians(1.0)
WORK = Text("energy, indicated work of the cycle: virtual work of the gas force")


# --- what a torque over the crank angle gives, whether of the gas or of a diagram


@formula("T_hi", "mathematics: largest of the points of the cycle, its corners among them", shows="largest T(ε)")
def highest(T: NewtonMetres) -> NewtonMetre:
    return float(T.max())


@formula("T_lo", "mathematics: smallest of the points of the cycle, its corners among them", shows="smallest T(ε)")
def lowest(T: NewtonMetres) -> NewtonMetre:
    return float(T.min())


@formula("|T|", "mathematics: amount of the torque at the crank angle where it is largest")
def amount(T: NewtonMetre) -> NewtonMetre:
    return modulus(T)


@formula("P_i", "definition of power", unit="kW")
def indicated_power(T_m: NewtonMetre, omega: RadPerSecond) -> Watt:
    return T_m * omega


@formula("δ_s", "dynamics: speed irregularity (ω_max − ω_min)/ω_m of a flywheel, ΔE = J·ω²·δ_s")
def speed_irregularity(Delta_E: NewtonMetre, J: KilogramMetre2, omega: RadPerSecond) -> Number:
    return Delta_E / (J * omega**2)


# --- formulas


@formula("T_I", "mathematics, sum over the cylinders: torque of the inertia forces")
def inertia_torque(T_k: NewtonMetre) -> NewtonMetre:
    return resultant(T_k)


@formula("ΣF_I", "mathematics, sum over the cylinders: inertia forces along their axes")
def inertia_sum(F_k: Newton) -> Newton:
    return resultant(F_k)


@formula("T_G", "mathematics, sum over the cylinders: torque of the gas forces")
def gas_torque(T_k: NewtonMetre) -> NewtonMetre:
    return resultant(T_k)


@formula("T", "mathematics: sum of the gas and inertia torques")
def whole_torque(T_G: NewtonMetre, T_I: NewtonMetre) -> NewtonMetre:
    return T_G + T_I


@formula(
    "T_R",
    "dynamics, moment of momentum of piston and crank: reaction on the block, with the inertia force on the offset "
    "cylinder's axis",
)
def reaction(T: NewtonMetre, d: Metre, F_I: Newton) -> NewtonMetre:
    """`T` on the crank, `F_I` towards the crank along the axis of the cylinder, which lies d further in the sense of
    rotation."""
    return -T + d * F_I


@formula("T_R", "mathematics, sum over the cylinders: torque reaction on the block")
def reaction_sum(T_k: NewtonMetre) -> NewtonMetre:
    return resultant(T_k)


@formula(
    "t_n",
    "mathematics, Fourier analysis of one cylinder's inertia torque, each cylinder turned by its firing angle "
    "(two terms: Den Hartog, ch. 5)",
    shows="t_1 … t_8 of T_k over one turn, times Σ e^(−i·n·f_k)",
    names={"fires": "f"},
)
def torque_harmonics(T_k: NewtonMetres, fires: Radians) -> PhasorNewtonMetres:
    """Complex amplitudes of orders 1 to 8, from equally spaced points over one turn."""
    return _turned_harmonics(T_k, fires)


def _turned_harmonics(T_k: Array, fires: Array) -> ComplexArray:
    turned = np.exp(-1j * np.arange(1, ORDERS + 1)[:, None] * fires)
    single = (np.fft.rfft(T_k, axis=0) * (2 / len(T_k)))[1 : ORDERS + 1]
    harmonics = single * resultant(turned) if np.ndim(single) == 1 else resultant(single * turned)
    return np.where(np.abs(harmonics) < 1e-12 * np.max(np.abs(T_k), initial=0.0), 0.0, harmonics)


@formula(
    "t_n",
    "mathematics: Fourier analysis of the inertia torque of each cylinder, turned by its firing angle",
    shows="Σ e^(−i·n·f_k)·t_1 … t_8 of T_k over one turn",
    names={"fires": "f"},
)
def torque_harmonics_of_unlike(T_k: NewtonMetres, fires: Radians) -> PhasorNewtonMetres:
    """`T_k`: at the points of a turn, of each cylinder from its own dead centre."""
    return _turned_harmonics(T_k, fires)


@formula("T_n", "mathematics: amplitude of one order of the inertia torque")
def harmonic_amplitude(t_n: PhasorNewtonMetre) -> NewtonMetre:
    return modulus(t_n)


@formula("W_i", Text("{work}, one cylinder", work=WORK), shows="∮ F_G·r·v_rel dε over the cycle")
def indicated_work(T_k: NewtonMetres, epsilon: Radians) -> NewtonMetre:
    """From the gas torque of one cylinder at the points of the cycle."""
    return float(c.running(epsilon, T_k)[-1])


@formula("p_mi", "definition of the indicated mean pressure", unit="bar")
def mean_pressure(W_i: NewtonMetre, N: Number, V_h: CubicMetre) -> Pascal:
    return W_i * N / V_h


@formula("T_m", Text("{work}, per radian of the cycle; inertia adds nothing", work=WORK))
def mean_torque(N: Number, W_i: NewtonMetre, strokes: Number) -> NewtonMetre:
    return N * W_i / (pi * strokes)


@formula(
    "ΔE",
    "dynamics, flywheel: largest fluctuation of the energy about its mean course",
    shows="max − min over the cycle of ∫(T − T_m)dε",
)
def energy_fluctuation(epsilon: Radians, T: NewtonMetres, T_m: NewtonMetre) -> NewtonMetre:
    energy = c.running(epsilon, T - T_m)
    return c.highest(epsilon, energy)[1] + c.highest(epsilon, -energy)[1]


# --- torque at any crank angles


@overload
def at(engine: EngineInputs, e: EngineResult, gas: None, fires: Num, epsilon: Num) -> tuple[None, Array, Array]: ...
@overload
def at(engine: EngineInputs, e: EngineResult, gas: Cycle, fires: Num, epsilon: Num) -> tuple[Array, Array, Array]: ...
def at(
    engine: EngineInputs, e: EngineResult, gas: Cycle | None, fires: Num, epsilon: Num
) -> tuple[Array | None, Array, Array]:
    """Gas torque (None without gas), inertia torque and inertia force of each cylinder (last axis) at crank angles
    ε."""
    length = gas.length if gas else TURN
    M_alt: Num = e.reciprocating_mass
    r: Num = engine.crank_radius
    lam: Num = e.lambda_
    delta: Num = e.delta
    phi_0: Num = e.tdc_angle
    if e.unlike is not None and np.ndim(fires):  # of one cylinder the mean mass, where they differ
        M_alt, r, lam = e.unlike.reciprocating, e.unlike.radius, e.unlike.lambda_
        delta, phi_0 = e.unlike.delta, e.unlike.tdc_angle
    angle = c.own_angle(epsilon=epsilon, fires=fires, cycle=length)
    alpha = c.crank_angle(phi_0=phi_0, epsilon=angle)
    beta = f.rod_angle(lam=lam, alpha=alpha, delta=delta)
    v_rel = f.relative_speed(alpha=alpha, beta=beta)
    a_rel = f.relative_acceleration(alpha=alpha, beta=beta, lam=lam)
    F_I = c.inertia_force(M_alt=M_alt, omega=e.angular_speed, r=r, a_rel=a_rel)
    T_I = c.torque_of(F=F_I, r=r, v_rel=v_rel)
    if gas is None:
        return None, T_I, F_I
    x = c.piston_way(r=r, lam=lam, phi_0=phi_0, alpha=alpha, beta=beta)
    F_G = c.gas_force(p=gas.pressure(angle, x), p_case=gas.crankcase, D=engine.bore)
    return c.torque_of(F=F_G, r=r, v_rel=v_rel), T_I, F_I


def solve(
    engine: EngineInputs, e: EngineResult, fires: Array, gas: GasInputs | None, J: KilogramMetre2 | None
) -> tuple[TorqueResult, Many[Curve], tuple[Text, ...]]:
    """The torque of one engine.  `fires`: the crank angles, after cylinder 1's, at which the cylinders fire [rad],
    over the cycle; `J`: of the flywheel."""
    inertia, curve = _inertia(engine, e, fires)
    notes = [
        Text(
            "The torque reaction on the block is no matter of balancing: no masses on crank or shafts change it in "
            "the mean."
        )
    ]
    if any(engine.offsets):
        notes.append(
            Text(
                "With the offset the inertia force, on the cylinder's axis, adds its moment about the crank's to the "
                "torque reaction."
            )
        )
    if gas is None:
        notes.append(Text("No gas is given: the torque is that of the inertia forces alone."))
        return inertia, (curve,), tuple(notes)
    with about(Text("gas cycle")):
        cycle = prepare(engine, e, gas)
    notes += cycle.notes
    notes.append(Text("The torque is the indicated one: friction, valve gear and auxiliaries are not taken off."))
    if J is not None:
        notes.append(
            Text(
                "Beside the flywheel's the inertia of the crank train is neglected; the load takes the mean torque "
                "all the time."
            )
        )
    result = _gas(engine, e, fires, cycle, J, inertia)
    return result, Later(lambda: _curves(engine, e, fires, cycle, result)), tuple(notes)


def _inertia(engine: EngineInputs, e: EngineResult, fires: Array) -> tuple[TorqueResult, Curve]:
    """Harmonics, peak and curve of the inertia torque, which is the same turn by turn: from one cylinder, or each, over
    a turn."""
    epsilon = np.arange(POINTS + 1, dtype=float) * (TURN / POINTS)
    d = engine.cylinder_offset if e.unlike is None else e.unlike.offset
    with about(Text("inertia torque of one cylinder")):
        if e.unlike is None:
            _, cylinder_torque, F_I = at(engine, e, None, 0.0, epsilon[:-1])
        else:
            _, cylinder_torque, F_I = at(engine, e, None, np.zeros(engine.cylinders), epsilon[:-1, None])
        on_block = reaction(T=cylinder_torque, d=d, F_I=F_I)
    turned = np.exp(-1j * np.arange(POINTS // 2 + 1)[:, None] * fires)

    def together(T_k: Array) -> Array:
        spectrum = np.fft.rfft(T_k, axis=0)
        whole = np.fft.irfft(spectrum * turned.sum(1) if e.unlike is None else (spectrum * turned).sum(1), POINTS)
        return np.append(whole, whole[0])

    whole, block = together(cylinder_torque), together(on_block)
    with about(Text("largest inertia torque")):
        _, T_I, _ = at(engine, e, None, fires, based_on(c.first_highest(epsilon, c.amounts(whole)), cylinder_torque))
        peak = amount(T=item(inertia_torque(T_k=T_I)))
    with about(Text("largest torque reaction of the inertia forces")):
        _, T_I, F_I = at(engine, e, None, fires, based_on(c.first_highest(epsilon, c.amounts(block)), on_block))
        peak_block = amount(T=item(reaction_sum(T_k=reaction(T=T_I, d=d, F_I=F_I))))
    transformed = torque_harmonics if e.unlike is None else torque_harmonics_of_unlike
    with about(Text("inertia torque")):
        t = transformed(T_k=cylinder_torque, fires=fires)
        orders = _amplitudes(t, Text("Inertia torque"), "T_")
    with about(Text("torque reaction of the inertia forces")):
        t_block = transformed(T_k=on_block, fires=fires)
        block_orders = _amplitudes(t_block, Text("Torque reaction of the inertia forces"), "T_RI,")
    curve = Curve(
        "torque",
        Text("Inertia torque about the crank over one turn"),
        axis_label("crank angle after TDC of cylinder 1", "°"),
        axis_label("T", "N·m"),
        (
            Series(Text("on the crank"), np.degrees(epsilon[::2]), whole[::2]),
            Series(Text("on the block"), np.degrees(epsilon[::2]), block[::2]),
        ),
    )
    return TorqueResult(
        inertia_torque_peak=peak,
        inertia_torque=orders,
        harmonics=elements(t),
        reaction_inertia_peak=peak_block,
        reaction_inertia=block_orders,
        reaction_harmonics=elements(t_block),
        cycle=None,
    ), curve


def _amplitudes(t: ComplexArray, words: str, symbol: str) -> dict[str, Stated]:
    return {
        f"order_{n}": Stated(
            Described(Text("{words}, order {n}", words=words, n=n), "N·m", f"{symbol}{n}"), harmonic_amplitude(t_n=t_n)
        )
        for n, t_n in enumerate(elements(t), 1)
        if abs(t_n) > SMALL * abs(t).max()
    }


def _gas(
    engine: EngineInputs, e: EngineResult, fires: Array, cycle: Cycle, J: KilogramMetre2 | None, inertia: TorqueResult
) -> TorqueResult:
    """What the gas gives beside the inertia forces: work, peaks, mean and fluctuation."""
    epsilon = c.points(cycle, fires)
    with about(Text("all cylinders over the cycle")):
        of_gas, of_inertia, force = at(engine, e, cycle, fires, epsilon[:, None])
        gas_only = gas_torque(T_k=of_gas)
        whole = whole_torque(T_G=gas_only, T_I=inertia_torque(T_k=of_inertia))
    with untraced():
        best = _angle_of_peak(engine, e, cycle, fires, epsilon, gas_only, inertia=False)
        on_block = reaction(T=whole, d=engine.cylinder_offset, F_I=force.sum(-1))
        best_block = c.first_highest(epsilon, c.amounts(on_block))
    best, best_block = based_on(best, gas_only), based_on(best_block, whole, force)
    with about(Text("cylinder 1 over its cycle")):
        cylinder_torque, _, _ = at(engine, e, cycle, item(fires[0]), epsilon)  # its corners are among the points
    W_i = indicated_work(T_k=cylinder_torque, epsilon=epsilon)
    T_m = mean_torque(N=engine.cylinders, W_i=W_i, strokes=engine.strokes)
    with about(Text("largest gas torque")):
        T_G_k = at(engine, e, cycle, fires, best)[0]
        peak_gas = amount(T=item(gas_torque(T_k=T_G_k)))
    best = based_on(_angle_of_peak(engine, e, cycle, fires, epsilon, whole, inertia=True), whole)
    with about(Text("largest torque")):
        T_G_k, T_I_k, _ = at(engine, e, cycle, fires, best)
        peak = amount(T=whole_torque(T_G=item(gas_torque(T_k=T_G_k)), T_I=item(inertia_torque(T_k=T_I_k))))
    with about(Text("largest torque reaction")):
        T_G_k, T_I_k, F_k = at(engine, e, cycle, fires, best_block)
        both = whole_torque(T_G=item(gas_torque(T_k=T_G_k)), T_I=item(inertia_torque(T_k=T_I_k)))
        peak_block = amount(T=reaction(T=both, d=engine.cylinder_offset, F_I=item(inertia_sum(F_k=F_k))))
    with about(Text("all cylinders over the cycle")):
        T_hi, T_lo = highest(T=whole), lowest(T=whole)
    Delta_E = energy_fluctuation(epsilon=epsilon, T=whole, T_m=T_m)
    return replace(
        inertia,
        speed_irregularity=None if J is None else speed_irregularity(Delta_E=Delta_E, J=J, omega=e.angular_speed),
        reaction_peak=peak_block,
        gas_torque_peak=peak_gas,
        torque_peak=peak,
        torque_peak_angle=best,
        compression_end_pressure=cycle.compression_end,
        indicated_work=W_i,
        indicated_mean_pressure=mean_pressure(W_i=W_i, N=engine.cylinders, V_h=e.displacement),
        mean_torque=T_m,
        indicated_power=indicated_power(T_m=T_m, omega=e.angular_speed),
        energy_fluctuation=Delta_E,
        torque_highest=T_hi,
        torque_lowest=T_lo,
        cycle=cycle,
    )


def _angle_of_peak(
    engine: EngineInputs, e: EngineResult, cycle: Cycle, fires: Array, epsilon: Array, torque: Array, *, inertia: bool
) -> float:
    """Where the amount of the gas torque, or of the whole, is largest: between the points, or at a corner that is one
    of them."""
    size = c.amounts(torque)
    between = c.first_highest(epsilon, size)
    with untraced():
        T_G, T_I, _ = at(engine, e, cycle, fires, between)
    peak = c.amounts(T_G.sum() + (T_I.sum() if inertia else 0.0))
    return between if peak >= size.max() else float(epsilon[size.argmax()])


# --- curves


def _curves(
    engine: EngineInputs, e: EngineResult, fires: Array, cycle: Cycle, result: TorqueResult
) -> tuple[Curve, ...]:
    epsilon = np.arange(round(cycle.length / DRAWN) + 1, dtype=float) * DRAWN
    degrees = np.degrees(epsilon)
    with untraced():
        T_G, T_I, F_I = (part.sum(-1) for part in at(engine, e, cycle, fires, epsilon[:, None]))
        on_block = reaction(T=T_G + T_I, d=engine.cylinder_offset, F_I=F_I)
        alpha = e.tdc_angle + epsilon
        beta = f.rod_angle(lam=e.lambda_, alpha=alpha, delta=e.delta)
        x = c.piston_way(r=engine.crank_radius, lam=e.lambda_, phi_0=e.tdc_angle, alpha=alpha, beta=beta)
        p = cycle.pressure(epsilon, x)
    assert result.mean_torque is not None
    torque = Curve(
        "torque",
        Text("Torque about the crank over the cycle"),
        axis_label("crank angle after the firing of cylinder 1", "°"),
        axis_label("T", "N·m"),
        (
            Series(Text("gas"), degrees, T_G),
            Series(Text("inertia"), degrees, T_I),
            Series(Text("total"), degrees, T_G + T_I),
            Series(Text("on the block"), degrees, on_block),
        ),
        limits=((Text("mean"), result.mean_torque),),
    )
    pressure = Curve(
        "pressure",
        Text("Pressure in a cylinder over its cycle"),
        axis_label("crank angle after its firing", "°"),
        axis_label("p", "bar"),
        (Series(Text("p"), degrees, p / 1e5),),
    )
    return torque, pressure


# --- what a torque diagram gives: mean, extremes and fluctuation of the energy
# Straight lines between its rows, closed over its period.

AREA = Text("mathematics: area of the torque diagram over its period, straight lines between its rows")


@formula("T_m", AREA, shows="∮T dε over the period")
def mean(angles: Radians, T: NewtonMetres, period: Radian) -> NewtonMetre:
    epsilon, torque = closed(angles, T, period)
    return float(np.sum((torque[1:] + torque[:-1]) * np.diff(epsilon)) / 2 / period)


@formula(
    "ΔE", AREA, shows="max − min over the period of ∫(T − T_m)dε, which is largest and smallest where T passes T_m"
)
def fluctuation(angles: Radians, T: NewtonMetres, T_m: NewtonMetre, period: Radian) -> NewtonMetre:
    epsilon, torque = closed(angles, T, period)
    over = torque - T_m
    passes = np.flatnonzero(over[:-1] * over[1:] < 0)
    at = epsilon[passes] + (epsilon[passes + 1] - epsilon[passes]) * over[passes] / (over[passes] - over[passes + 1])
    order = np.argsort(np.append(epsilon, at), kind="stable")
    x, y = np.append(epsilon, at)[order], np.append(over, np.zeros(at.size))[order]
    energy = np.append(0.0, np.cumsum((y[1:] + y[:-1]) * np.diff(x) / 2))
    return float(energy.max() - energy.min())


@formula("ε_max", "mathematics: row of the torque diagram with the largest amount of torque", shows="its crank angle")
def place(epsilon: Radian) -> Radian:
    return epsilon


def closed(angles: Array, T: Array, period: Radian) -> tuple[Array, Array]:
    """The rows over one whole period, the first once more at its end."""
    epsilon, torque = np.asarray(angles), np.asarray(T)
    if period - (epsilon[-1] - epsilon[0]) > 1e-9:
        return np.append(epsilon, epsilon[0] + period), np.append(torque, torque[0])
    return epsilon, torque


def solve_diagram(engine: EngineInputs, e: EngineResult, inertia: TorqueResult) -> tuple[TorqueResult, Curve, Text]:
    """The values of the engine's torque diagram beside those of its inertia forces; figure and note of it."""
    rows, omega, J = engine.torque, e.angular_speed, engine.flywheel_inertia
    cycle = based_on(engine.strokes * math.pi, engine.strokes)
    period = engine.torque_period if engine.torque_period is not None else cycle
    angles = gathered(row.angle for row in rows)
    T = gathered(row.torque for row in rows)
    T_m = mean(angles=angles, T=T, period=period)
    Delta_E = fluctuation(angles=angles, T=T, T_m=T_m, period=period)
    largest = rows[int(np.argmax(np.abs(np.asarray(T))))]
    result = replace(
        inertia,
        torque_highest=highest(T=T),
        torque_lowest=lowest(T=T),
        torque_peak=amount(T=largest.torque),
        torque_peak_angle=place(epsilon=largest.angle),
        mean_torque=T_m,
        indicated_power=indicated_power(T_m=T_m, omega=omega),
        energy_fluctuation=Delta_E,
        speed_irregularity=None if J is None else speed_irregularity(Delta_E=Delta_E, J=J, omega=omega),
    )
    epsilon, torque = closed(angles, T, period)
    curve = Curve(
        "torque",
        Text("Torque about the crank as given"),
        axis_label("crank angle after the firing of cylinder 1", "°"),
        axis_label("T", "N·m"),
        (Series(Text("total"), np.degrees(epsilon), torque),),
        limits=((Text("mean"), T_m),),
    )
    repeats = Text(
        "The torque is that of the diagram as given, of gas and inertia together, which repeats every {length}°.",
        length=Amount(math.degrees(period), form="g"),
    )
    return result, curve, repeats
