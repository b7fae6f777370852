# SPDX-License-Identifier: Apache-2.0
"""The engine: masses, kinematics and the harmonics of the piston's acceleration, firing, and the torque about its crank."""

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from ..catalogue import Material
from ..sheet.arrays import Array, ComplexArray, each, many, phasors
from ..sheet.check import Check, check
from ..sheet.formula import formula
from ..sheet.functions import modulus, pi
from ..sheet.later import Later
from ..sheet.linked_array import elements
from ..sheet.quantity import Described, Stated, group, result, value
from ..sheet.step import Curve, Outcome, Table
from ..sheet.text import Amount, Text
from ..sheet.trace import about, trace
from ..sheet.units import CubicMetre, Kilogram, Metre, MetrePerSecond, MetrePerSecond2, Number, Pascal, PhasorNumber, Radian, RadPerSecond
from ..sheet.value import based_on
from . import curves as train
from . import formulas as f
from . import torque, torque_diagram
from .crank import Crank, column, crank, firing, pin_of_cylinder
from .cycle import WIDE, widest_gap
from .firing import DUST, TURN, Firing
from .inputs import CRANK_RATIO, EngineInputs
from .masses import UnlikeMasses, masses

if TYPE_CHECKING:
    from .throw import ThrowResult

ORDERS = range(1, 9)
IRREGULAR = 0.05
TURNED = "inertia_torque"  # the figure of the inertia torque, where that of the whole is given
EVEN = math.radians(1.0)  # a firing interval may be so far from the even one


@result
class EngineResult:
    """Masses, kinematics and harmonics of an engine."""

    reciprocating_mass: Kilogram = value("Reciprocating mass per cylinder", "g", "M_alt")
    rotating_mass: Kilogram = value("Rotating mass per cylinder", "g", "M_rot")
    lambda_: Number = value("Crank ratio", "", "λ")
    delta: Number = value("Offset ratio", "", "δ")
    angular_speed: RadPerSecond = value("Angular speed", "rad/s", "ω")
    tdc_angle: Radian = value("Crank angle at TDC", "°", "φ_0")
    stroke: Metre = value("Stroke", "mm", "s")
    displacement: CubicMetre = value("Displacement", "cm³", "V_h")
    mean_piston_speed: MetrePerSecond = value("Mean piston speed", "m/s", "u_m")
    brake_mean_pressure: Pascal | None = value("Brake mean effective pressure", "bar", "p_me", default=None)
    piston_speed_max: MetrePerSecond = value("Largest piston speed", "m/s", "v_max")
    piston_speed_max_angle: Radian = value("Crank angle of the largest piston speed", "°", "α_v")
    acceleration_max: MetrePerSecond2 = value("Largest piston acceleration", "m/s²", "a_max")
    acceleration_min: MetrePerSecond2 = value("Smallest piston acceleration", "m/s²", "a_min")
    acceleration_min_angle: Radian = value("Crank angle of the smallest acceleration", "°")
    firing_interval: Radian | None = value("Firing interval, on average", "°", "Δ", default=None)
    firing_interval_shortest: Radian | None = value("Shortest firing interval", "°", default=None)
    firing_interval_longest: Radian | None = value("Longest firing interval", "°", default=None)
    harmonic: dict[str, Stated] | None = group(default=None)
    torque: "torque.TorqueResult | None" = group(spread=True, default=None)
    throw: "ThrowResult | None" = group(default=None)
    crank: Crank
    unlike: UnlikeMasses | None  # where the masses differ from cylinder to cylinder
    harmonics: tuple[complex, ...]  # c_1 … c_8 of a/(ω² r), exact
    two_term: tuple[complex, ...]


@formula("c_n", "Fourier analysis of the exact acceleration over one turn (Finotti 2013, 2.1, exact form)", shows="c_1 … c_8 of a/(ω²·r)")
def harmonics(a: Number) -> PhasorNumber:
    """a/(ω² r) = Re Σ c_n e^{inα}: the complex amplitudes of orders 1 to 8, from equally spaced points over one turn (last axis)."""
    points = many(a)
    spectrum: ComplexArray = np.fft.rfft(points)[..., 1 : len(ORDERS) + 1] * 2 / points.shape[-1]
    spectrum.real[np.abs(spectrum.real) < 1e-12] = 0.0
    spectrum.imag[np.abs(spectrum.imag) < 1e-12] = 0.0
    return each(spectrum)


def points(lam: Number, delta: Number) -> int:
    """How many crank angles carry the whole acceleration: its harmonics fall like e^(−nη) with cosh η = (1 − |δ|)/λ."""
    eta = np.arccosh(np.min((1 - np.abs(delta)) / lam))
    return int(2 ** np.ceil(np.log2(min(65536.0, 8 + 80 / max(eta, 1e-6)))))


@formula("Δ", "Finotti 2013, 2.4: firing interval 180°·strokes/N")
def firing_interval(strokes: Number, N: Number) -> Radian:
    return pi * strokes / N


@formula(
    "Δ_min",
    "kinematics, crank angles between one firing and the next, over the working cycle",
    shows="the shortest of the firing intervals",
)
def shortest_interval(gaps: Radian, phi: Radian) -> Radian:
    return float(np.min(gaps))


@formula(
    "Δ_max", "kinematics, crank angles between one firing and the next, over the working cycle", shows="the longest of the firing intervals"
)
def longest_interval(gaps: Radian, phi: Radian) -> Radian:
    return float(np.max(gaps))


def _peak(y: Array) -> tuple[Number, Radian]:
    """The largest value over a turn and its angle: the best of the points, then Newton's method on their Fourier series."""
    size = y.shape[-1]
    n = np.arange(size // 2 + 1)
    c = np.fft.rfft(y) * np.where((n == 0) | (n == size // 2), 1.0, 2.0) / size
    at = np.argmax(y, -1) * (2 * np.pi / size)
    for _ in range(5):  # from within half a point: 0.05, 2e-3, 4e-6, 1e-11 rad
        term = c * np.exp(1j * n * at[..., None])
        slope, bend = np.sum(-n * term.imag, -1), np.sum(-(n**2) * term.real, -1)
        at = at - np.clip(slope / np.where(bend < 0, bend, -np.inf), -2 / size, 2 / size)
    highest = np.sum((c * np.exp(1j * n * at[..., None])).real, -1)
    return (each(highest), each(at % (2 * np.pi))) if y.ndim > 1 else (float(highest), float(at) % (2 * np.pi))


@formula("max", "mathematics: largest value over the turn", shows="the largest of the points, refined on their Fourier series")
def turn_highest(y: Number) -> Number:
    return _peak(many(y))[0]


def _fastest(y: Array) -> tuple[Number, Radian]:
    """The largest magnitude over a turn and its angle; of two alike the first.  An offset makes one of the two strokes the quicker."""
    (down, at_down), (up, at_up) = _peak(y), _peak(-y)
    first = down >= up * (1 - 1e-12)
    if y.ndim == 1:
        return (down, at_down) if first else (up, at_up)
    return each(np.where(first, down, up)), each(np.where(first, at_down, at_up))


@formula("max", "mathematics: largest magnitude over the turn", shows="the largest magnitude of the points, refined on their series")
def turn_fastest(y: Number) -> Number:
    return _fastest(many(y))[0]


@formula("min", "mathematics: smallest value over the turn", shows="the smallest of the points, refined on their Fourier series")
def turn_lowest(y: Number) -> Number:
    return -_peak(many(-y))[0]


def values(engine: EngineInputs) -> EngineResult:
    """Masses, kinematics and harmonics.  A number of the engine may be an array, an engine each: so are the results."""
    reciprocating, rotating, unlike = masses(engine)
    lam = f.crank_ratio(r=engine.crank_radius, L=engine.rod_length)
    delta = f.offset_ratio(d=engine.cylinder_offset, L=engine.rod_length)
    omega = f.angular_speed(n=engine.rated_speed)
    phi_0 = f.tdc_angle(delta=delta, lam=lam)
    stroke = f.stroke(L=engine.rod_length, r=engine.crank_radius, d=engine.cylinder_offset)
    volume = f.displacement(N=engine.cylinders, D=engine.bore, s=stroke)
    mean_speed = f.mean_piston_speed(s=stroke, n=engine.rated_speed)
    p_me, P_e = None, engine.rated_power
    if P_e is not None:
        p_me = f.brake_mean_pressure(P_e=P_e, strokes=engine.strokes, V_h=volume, n=engine.rated_speed)
    alpha = each(np.arange(size := points(lam, delta), dtype=float) * (2 * np.pi / size))
    beta = f.rod_angle(lam=column(lam), alpha=alpha, delta=column(delta))
    speed = f.relative_speed(alpha=alpha, beta=beta)
    exact = f.relative_acceleration(alpha=alpha, beta=beta, lam=column(lam))
    fastest = f.piston_speed(v_rel=turn_fastest(y=speed), omega=omega, r=engine.crank_radius)
    at_fastest = f.angle_of_fastest(v_rel=speed, alpha=based_on(_fastest(many(speed))[1], speed))
    a_max = f.acceleration(a_rel=turn_highest(y=exact), omega=omega, r=engine.crank_radius)
    a_min = f.acceleration(a_rel=turn_lowest(y=exact), omega=omega, r=engine.crank_radius)
    at_lowest = f.angle_of_smallest(a_rel=exact, alpha=based_on(_peak(many(-exact))[1], exact))
    spectrum = phasors(harmonics(exact))
    return EngineResult(
        reciprocating_mass=reciprocating, rotating_mass=rotating, lambda_=lam, delta=delta, angular_speed=omega, tdc_angle=phi_0,
        stroke=stroke, displacement=volume, mean_piston_speed=mean_speed, brake_mean_pressure=p_me, piston_speed_max=fastest,
        piston_speed_max_angle=at_fastest, acceleration_max=a_max, acceleration_min=a_min, acceleration_min_angle=at_lowest,
        crank=crank(engine, phi_0), unlike=unlike,
        harmonics=elements(spectrum) if spectrum.ndim == 1 else tuple(np.moveaxis(spectrum, -1, 0)),
        two_term=(based_on(1 - 1j * delta, delta), based_on(lam + 0j, lam), *([0j] * (len(ORDERS) - 2))),
    )  # fmt: skip


def solve(engine: EngineInputs, materials: Mapping[str, Material] | None = None) -> Outcome[EngineResult]:
    """One engine: what `values` gives, when it fires, and the torque about its crank."""
    with trace() as lines:
        e = values(engine)
        fires = firing(engine, e.crank)
        interval = firing_interval(strokes=engine.strokes, N=engine.cylinders)
        gaps, phi = each(fires.intervals), each(e.crank.phi)
        shortest, longest = shortest_interval(gaps=gaps, phi=phi), longest_interval(gaps=gaps, phi=phi)
        with about(Text("torque")):
            turning, curves, notes = torque.solve(engine, e, fires.angles, engine.gas, engine.flywheel_inertia)
            if engine.torque:
                turning, curves, notes = _given_torque(engine, e, turning, curves[0], notes[0])
        with about(Text("harmonics of the piston's acceleration")):
            named = _harmonics(e)
        stressed, checks, more, tables = _throw(engine, e, fires, turning, materials or {})
    e = replace(
        e, firing_interval=interval, firing_interval_shortest=shortest, firing_interval_longest=longest, torque=turning, throw=stressed,
        harmonic=named,
    )  # fmt: skip

    def drawn() -> tuple[Curve, ...]:
        return train.curves(engine.crank_radius, e.angular_speed, e.lambda_, e.delta, e.reciprocating_mass, e.harmonics)

    return Outcome(
        "engine", result=e, checks=(*_checks(engine, e, turning), *checks), lines=tuple(lines),
        curves=Later(lambda: (*drawn(), *curves)),
        tables=Later(lambda: (_crank_table(engine, e, fires), *tables)),
        notes=(*_notes(engine, e, fires), *notes, *more),
    )  # fmt: skip


def _given_torque(
    engine: EngineInputs, e: EngineResult, turning: torque.TorqueResult, turned: Curve, note: Text
) -> tuple[torque.TorqueResult, tuple[Curve, ...], tuple[Text, ...]]:
    """What a torque diagram gives, beside the torque of the inertia forces and its figure."""
    cycle = based_on(engine.strokes * np.pi, engine.strokes)
    period = engine.torque_period if engine.torque_period is not None else cycle
    found, curve, repeats = torque_diagram.solve(engine.torque, period, e.angular_speed, engine.flywheel_inertia)
    return replace(turning, **found), (curve, replace(turned, id=TURNED)), (note, repeats)


def _throw(
    engine: EngineInputs, e: EngineResult, fires: Firing, turning: torque.TorqueResult, materials: Mapping[str, Material]
) -> "tuple[ThrowResult | None, tuple[Check, ...], tuple[Text, ...], tuple[Table, ...]]":
    """Stresses of a crank throw, where one is described."""
    if engine.throw is None:
        return None, (), (), ()
    from . import throw

    return throw.solve(engine, e, fires.angles, engine.gas, engine.throw, materials, turning.cycle)


@formula("|c_n|", "mathematics: amplitude of one order of a/(ω²·r)")
def harmonic_amplitude(c_n: PhasorNumber) -> Number:
    return modulus(c_n)


def _harmonics(e: EngineResult) -> dict[str, Stated]:
    """The orders of the piston's acceleration over ω²·r, those that there are."""
    return {
        f"order_{n}": Stated(Described(Text("Piston acceleration over ω²·r, order {n}", n=n), "", f"c_{n}"), harmonic_amplitude(c_n=c))
        for n, c in zip(ORDERS, e.harmonics) if c
    }  # fmt: skip


def _crank_table(engine: EngineInputs, e: EngineResult, fires: Firing) -> Table:
    """Cylinder by cylinder, where everything stands: what the layout was taken for."""
    pin = pin_of_cylinder(engine, e.crank)
    degrees = [np.round(np.degrees(x), 4) + 0.0 for x in (e.crank.psi, e.crank.phi, fires.angles)]
    rows = tuple(
        (float(k + 1), float(degrees[0][k]), float(degrees[1][k]), float(pin[k] + 1), float(e.crank.z[k]) * 1e3, float(degrees[2][k]))
        for k in range(engine.cylinders)
    )
    return Table(
        "crank", Text("The crank and its cylinders"),
        ((Text("cylinder"), ""), (Text("bank"), "°"), (Text("throw"), "°"), (Text("pin"), ""), (Text("z"), "mm"), (Text("fires at"), "°")),
        rows,
        Text("Bank from up, throw from that of cylinder 1, both in the sense of rotation; z from mid-engine towards the flywheel."),
    )  # fmt: skip


def _checks(engine: EngineInputs, e: EngineResult, turning: torque.TorqueResult) -> tuple[Check, ...]:
    assert e.firing_interval is not None and e.firing_interval_shortest is not None and e.firing_interval_longest is not None
    uneven = max(e.firing_interval_longest - e.firing_interval, e.firing_interval - e.firing_interval_shortest)
    uneven = based_on(uneven if uneven > DUST * TURN else 0.0, e.firing_interval, e.firing_interval_longest, e.firing_interval_shortest)
    usual = Text("Finotti 2013, 2.1, and mechanics textbook, 48.3.3: usual 0.22 to 0.30; Finotti 2013, 2.2.4: 0.2 to 0.3")
    longer = (
        Text("A rod longer than usual: less second order, but a heavier rod and a taller engine.")
        if e.lambda_ < CRANK_RATIO[0]
        else Text(
            "A longer rod lowers λ and with it every second-order force and couple. The range is a guide, no limit: the R753IE4 of "
            "Finotti 2013, 2.5.3.1, lies above it with 0.3282."
        )
    )
    rule = Text("rule of this program: even firing within 1° (Finotti 2013, 2.4: interval 180°·strokes/N)")
    advice = Text("This crank fires unevenly: the torque pulsates at lower orders. Crank angles that follow from a firing order are even.")
    gas: list[Check] = []
    if turning.indicated_work is not None:
        gas.append(
            check(
                "engine.gas.work", Text("Indicated work of a cycle"), turning.indicated_work, ">", 0.0, "J",
                Text("energy: an engine gives work"),
                Text("The gas takes more work than it gives: look at peak pressure and compression ratio, or at the table of pressure."),
            )
        )  # fmt: skip
    if engine.gas is not None and engine.gas.pressure and turning.cycle is not None:
        _, gap = widest_gap(turning.cycle.corners, turning.cycle.length)
        gap = based_on(gap, turning.cycle.corners)
        gas.append(
            check(
                "engine.gas.gap", Text("Largest gap in the table of indicated pressure"), gap, "<=", WIDE, "°",
                Text("rule of this program: a straight line is taken across a gap"),
                Text("Give points at least every 60° of the whole cycle."),
            )
        )  # fmt: skip
    if turning.speed_irregularity is not None:
        gas.append(
            check(
                "engine.speed_irregularity", Text("Speed irregularity"), turning.speed_irregularity, "<=", IRREGULAR, "",
                Text(
                    "rule of this program after machine handbooks, from memory: ΔE = J·ω²·δ_s holds for small δ_s; running drives are kept "
                    "well below 1/20"
                ),
                Text("A larger inertia of the flywheel lowers it in proportion."),
            )
        )  # fmt: skip
    return (
        *gas,
        check("engine.crank.lambda_usual", Text("Crank ratio λ"), e.lambda_, "in", CRANK_RATIO, "", usual, longer),
        check(
            "engine.firing.even",
            Text("Deviation of a firing interval from the even one"),
            uneven,
            "<=",
            EVEN,
            "°",
            rule,
            advice,
        ),
    )


def _notes(engine: EngineInputs, e: EngineResult, fires: Firing) -> tuple[Text, ...]:
    notes = list(e.crank.chosen)
    if engine.cylinders > 1:
        degrees = [round(math.degrees(gap), 3) for gap in fires.intervals]
        even = max(degrees) - min(degrees) < 1e-3
        notes += [fires.chosen] if fires.chosen else []
        notes.append(
            Text("Fires {map}, ", map="-".join(map(str, fires.order)))
            + (
                Text("every {degrees}°.", degrees=Amount(degrees[0], form="g"))
                if even
                else Text("after {what}°: unevenly.", what="-".join(f"{d:g}" for d in degrees))
            )
        )
    notes.append(Text("The rod is replaced by two masses; the couple of its own inertia (J_G ≠ m·X₁·X₂) is neglected."))
    if engine.rod_cg_to_big_end is None and engine.rod_mass is not None:
        notes.append(Text("The rod's centre of gravity is not given: one third of it is taken as reciprocating."))
    return tuple(notes)
