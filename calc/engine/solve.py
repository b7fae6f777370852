# SPDX-License-Identifier: Apache-2.0
"""The engine: masses, kinematics and the harmonics of the piston's acceleration, firing, and the torque about its
crank."""

from collections.abc import Iterable, Mapping
from typing import Any, overload

import numpy as np

from ..library.catalogue import Material
from ..sheet.arguments import given_inputs
from ..sheet.arrays import Array, ComplexArray, Num
from ..sheet.check import Check
from ..sheet.deferred import Later
from ..sheet.formula import formula
from ..sheet.functions import largest, modulus, pi, single_or_many, smallest
from ..sheet.linked_array import elements, gathered
from ..sheet.quantity import Described, Stated
from ..sheet.record import replace
from ..sheet.step import Outcome, Table
from ..sheet.text import Text
from ..sheet.units import Number, Numbers, PhasorNumber, PhasorNumbers, Radian, Radians
from ..sheet.value import about, based_on, trace
from . import curves as engine_curves
from . import formulas as f
from . import throw, torque
from .checks import checks
from .crank import Firing, column, crank, firing, pin_of_cylinder
from .inputs import EngineInputs
from .notes import notes
from .result import Cylinder, EngineResult, ThrowResult

ORDERS = range(1, 9)
TURNED = "inertia_torque"  # the figure of the inertia torque, where that of the whole is given


@formula(
    "c_n",
    "Fourier analysis of the exact acceleration over one turn (Finotti 2013, 2.1, exact form)",
    shows="c_1 … c_8 of a/(ω²·r)",
)
def harmonics(a: Numbers) -> PhasorNumbers:
    """a/(ω² r) = Re Σ c_n e^{inα}: the complex amplitudes of orders 1 to 8, from equally spaced points over one turn
    (last axis)."""
    spectrum: ComplexArray = np.fft.rfft(a)[..., 1 : len(ORDERS) + 1] * 2 / a.shape[-1]
    real, imag = (np.where(np.abs(part) < 1e-12, 0.0, part) for part in (spectrum.real, spectrum.imag))
    return real + 1j * imag


def points(lam: Number, delta: Number) -> int:
    """How many crank angles carry the whole acceleration: its harmonics fall like e^(−nη) with cosh η = (1 − |δ|)/λ."""
    eta = np.arccosh(np.min((1 - np.abs(delta)) / lam))
    return int(2 ** np.ceil(np.log2(smallest(65536.0, 8 + 80 / largest(eta, 1e-6)))))


@formula("Δ", "Finotti 2013, 2.4: firing interval 180°·strokes/N")
def firing_interval(strokes: Number, N: Number) -> Radian:
    return pi * strokes / N


@formula(
    "Δ_min",
    "kinematics, crank angles between one firing and the next, over the working cycle",
    shows="the shortest of the firing intervals",
)
def shortest_interval(gaps: Radians, phi: Radians) -> Radian:
    return float(np.min(gaps))


@formula(
    "Δ_max",
    "kinematics, crank angles between one firing and the next, over the working cycle",
    shows="the longest of the firing intervals",
)
def longest_interval(gaps: Radians, phi: Radians) -> Radian:
    return float(np.max(gaps))


def _peak(y: Array) -> tuple[Number, Radian]:
    """The largest value over a turn and its angle: the best of the points, then Newton's method on their Fourier
    series."""
    size = y.shape[-1]
    n = np.arange(size // 2 + 1)
    c = np.fft.rfft(y) * np.where((n == 0) | (n == size // 2), 1.0, 2.0) / size
    at = np.argmax(y, -1) * (2 * np.pi / size)
    for _ in range(5):  # from within half a point: 0.05, 2e-3, 4e-6, 1e-11 rad
        term = c * np.exp(1j * n * at[..., None])
        slope, bend = np.sum(-n * term.imag, -1), np.sum(-(n**2) * term.real, -1)
        at = at - np.clip(slope / np.where(bend < 0, bend, -np.inf), -2 / size, 2 / size)
    highest = np.sum((c * np.exp(1j * n * at[..., None])).real, -1)
    return single_or_many(highest), single_or_many(at) % (2 * np.pi)


@formula(
    "max",
    "mathematics: largest value over the turn",
    shows="the largest of the points, refined on their Fourier series",
)
def turn_highest(y: Numbers) -> Number:
    return _peak(y)[0]


def _fastest(y: Array) -> tuple[Number, Radian]:
    """The largest magnitude over a turn and its angle; of two alike the first.  An offset makes one of the two strokes
    the quicker."""
    (down, at_down), (up, at_up) = _peak(y), _peak(-y)
    first = np.asarray(down >= up * (1 - 1e-12))
    return single_or_many(np.where(first, down, up)), single_or_many(np.where(first, at_down, at_up))


@formula(
    "max",
    "mathematics: largest magnitude over the turn",
    shows="the largest magnitude of the points, refined on their series",
)
def turn_fastest(y: Numbers) -> Number:
    return _fastest(y)[0]


@formula(
    "min",
    "mathematics: smallest value over the turn",
    shows="the smallest of the points, refined on their Fourier series",
)
def turn_lowest(y: Numbers) -> Number:
    return -_peak(-y)[0]


def values(engine: EngineInputs) -> EngineResult:
    """Masses, kinematics and harmonics.  A number of the engine may be an array, an engine each: so are the results."""
    reciprocating, rotating, of_each = f.masses(engine)
    cylinders = []
    for k, single in enumerate(f.alone(engine) if engine.unlike_motions else (), 1):
        with about(Text("cylinder {n}", n=k)):
            cylinders.append(values(single))
    lam = f.crank_ratio(r=engine.crank_radius, L=engine.rod_length)
    delta = f.offset_ratio(d=engine.cylinder_offset, L=engine.rod_length)
    omega = f.angular_speed(n=engine.rated_speed)
    phi_0 = f.tdc_angle(delta=delta, lam=lam)
    stroke = f.stroke(L=engine.rod_length, r=engine.crank_radius, d=engine.cylinder_offset)
    if cylinders:
        volume = f.displacement_of_unlike(D=engine.bore, s=gathered(cylinder.stroke for cylinder in cylinders))
    else:
        volume = f.displacement(N=engine.cylinders, D=engine.bore, s=stroke)
    mean_speed = f.mean_piston_speed(s=stroke, n=engine.rated_speed)
    p_me, P_e = None, engine.rated_power
    if P_e is not None:
        p_me = f.brake_mean_pressure(P_e=P_e, strokes=engine.strokes, V_h=volume, n=engine.rated_speed)
    alpha = np.arange(size := points(lam, delta), dtype=float) * (2 * np.pi / size)
    beta = f.rod_angle(lam=column(lam), alpha=alpha, delta=column(delta))
    speed = f.relative_speed(alpha=alpha, beta=beta)
    exact = f.relative_acceleration(alpha=alpha, beta=beta, lam=column(lam))
    fastest = f.piston_speed(v_rel=turn_fastest(y=speed), omega=omega, r=engine.crank_radius)
    at_fastest = f.angle_of_fastest(v_rel=speed, alpha=based_on(_fastest(speed)[1], speed))
    a_max = f.acceleration(a_rel=turn_highest(y=exact), omega=omega, r=engine.crank_radius)
    a_min = f.acceleration(a_rel=turn_lowest(y=exact), omega=omega, r=engine.crank_radius)
    at_lowest = f.angle_of_smallest(a_rel=exact, alpha=based_on(_peak(-exact)[1], exact))
    spectrum = harmonics(exact)
    c_n = elements(spectrum) if spectrum.ndim == 1 else tuple(np.moveaxis(spectrum, -1, 0))
    two_term = (based_on(1 - 1j * delta, delta), based_on(lam + 0j, lam), *([0j] * (len(ORDERS) - 2)))
    unlike = None
    if engine.unlike:
        unlike = f.Unlike(*of_each, engine.crank_radius, lam, c_n, two_term, delta, phi_0, engine.cylinder_offset)
    if cylinders:
        unlike = f.Unlike(
            *of_each,
            gathered(engine.radii),
            gathered(cylinder.lambda_ for cylinder in cylinders),
            _beside(cylinder.harmonics for cylinder in cylinders),
            _beside(cylinder.two_term for cylinder in cylinders),
            gathered(cylinder.delta for cylinder in cylinders),
            gathered(cylinder.tdc_angle for cylinder in cylinders),
            gathered(engine.offsets),
        )
    return EngineResult(
        reciprocating_mass=reciprocating,
        rotating_mass=rotating,
        lambda_=lam,
        delta=delta,
        angular_speed=omega,
        tdc_angle=phi_0,
        stroke=stroke,
        displacement=volume,
        mean_piston_speed=mean_speed,
        brake_mean_pressure=p_me,
        piston_speed_max=fastest,
        piston_speed_max_angle=at_fastest,
        acceleration_max=a_max,
        acceleration_min=a_min,
        acceleration_min_angle=at_lowest,
        crank=crank(engine, phi_0),
        unlike=unlike,
        harmonics=c_n,
        two_term=two_term,
        cylinder={str(k): _of_one(cylinder) for k, cylinder in enumerate(cylinders, 1)} or None,
    )


def _beside(of_each: Iterable[tuple[complex, ...]]) -> tuple[ComplexArray, ...]:
    """The harmonics of the cylinders side by side."""
    return tuple(based_on(np.array(c_n), *c_n) for c_n in zip(*of_each))


def _of_one(cylinder: EngineResult) -> Cylinder:
    return Cylinder(
        lambda_=cylinder.lambda_,
        stroke=cylinder.stroke,
        mean_piston_speed=cylinder.mean_piston_speed,
        piston_speed_max=cylinder.piston_speed_max,
        acceleration_max=cylinder.acceleration_max,
        acceleration_min=cylinder.acceleration_min,
    )


def solve(engine: EngineInputs, materials: Mapping[str, Material] | None = None) -> Outcome[EngineResult]:
    """One engine: what `values` gives, when it fires, and the torque about its crank."""
    with trace() as lines:
        e = values(engine)
        fires = firing(engine, e.crank)
        interval = firing_interval(strokes=engine.strokes, N=engine.cylinders)
        gaps, phi = fires.intervals, e.crank.phi
        shortest, longest = shortest_interval(gaps=gaps, phi=phi), longest_interval(gaps=gaps, phi=phi)
        with about(Text("torque")):
            turning, curves, assumed = torque.solve(engine, e, fires.angles, engine.gas, engine.flywheel_inertia)
            if engine.torque:
                turning, curve, repeats = torque.solve_diagram(engine, e, turning)
                curves, assumed = (curve, replace(curves[0], id=TURNED)), (assumed[0], repeats)
        with about(Text("harmonics of the piston's acceleration")):
            named = _harmonics(e)
        stressed: ThrowResult | None = None
        strength: tuple[Check, ...] = ()
        more: tuple[Text, ...] = ()
        tables: tuple[Table, ...] = ()
        if engine.throw is not None:
            stressed, strength, more, tables = throw.solve(
                engine, e, fires.angles, engine.gas, engine.throw, materials or {}, turning.cycle
            )
    e = replace(
        e,
        firing_interval=interval,
        firing_interval_shortest=shortest,
        firing_interval_longest=longest,
        torque=turning,
        throw=stressed,
        harmonic=named,
    )

    return Outcome(
        "engine",
        result=e,
        checks=(*checks(engine, e, turning), *strength),
        lines=tuple(lines),
        curves=Later(lambda: (*engine_curves.curves(engine.crank_radius, e), *curves)),
        tables=Later(lambda: (_crank_table(engine, e, fires), *tables)),
        notes=(*notes(engine, e, fires), *assumed, *more),
    )


@formula("|c_n|", "mathematics: amplitude of one order of a/(ω²·r)")
def harmonic_amplitude(c_n: PhasorNumber) -> Number:
    return modulus(c_n)


def _harmonics(e: EngineResult) -> dict[str, Stated]:
    """The orders of the piston's acceleration over ω²·r, those that there are."""
    return {
        f"order_{n}": Stated(
            Described(Text("Piston acceleration over ω²·r, order {n}", n=n), "", f"c_{n}"), harmonic_amplitude(c_n=c)
        )
        for n, c in zip(ORDERS, e.harmonics)
        if c
    }


def _crank_table(engine: EngineInputs, e: EngineResult, fires: Firing) -> Table:
    """Cylinder by cylinder, where everything stands: what the layout was taken for."""
    bank, throw, fires_at = (np.round(np.degrees(x), 4) + 0.0 for x in (e.crank.psi, e.crank.phi, fires.angles))
    columns = [
        (Text("cylinder"), "", np.arange(1.0, engine.cylinders + 1)),
        (Text("bank"), "°", bank),
        (Text("throw"), "°", throw),
        (Text("pin"), "", pin_of_cylinder(engine, e.crank) + 1.0),
        (Text("r"), "mm", np.array(engine.crank_radii or ()) * 1e3),
        (Text("z"), "mm", np.asarray(e.crank.z) * 1e3),
        (Text("fires at"), "°", fires_at),
    ]
    given = [column for column in columns if column[2].size]
    return Table(
        "crank",
        Text("The crank and its cylinders"),
        tuple((label, unit) for label, unit, _ in given),
        tuple(zip(*(numbers.tolist() for *_, numbers in given))),
        Text(
            "Bank from up, throw from that of cylinder 1, both in the sense of rotation; z from mid-engine towards "
            "the flywheel."
        ),
    )


# --- from Python, in SI: `from calc import engine`


@overload
def solve_engine(engine: EngineInputs) -> EngineResult[float]: ...
@overload
def solve_engine(engine: EngineInputs, **varied: Num) -> EngineResult[Array]: ...
def solve_engine(engine: EngineInputs, **varied: Any) -> EngineResult[Any]:
    """Masses, kinematics and harmonics of an engine.

    `engine`: in SI, as EngineInputs say.  `varied`: numbers of it that are others, by their names; they may be arrays
    of one length, an engine each: so are the results.  BadInput where a number lies outside of the range that it has in
    a design file."""
    return values(given_inputs("solve_engine", engine, varied))
