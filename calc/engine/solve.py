# SPDX-License-Identifier: Apache-2.0
"""The engine: masses, kinematics and the harmonics of the piston's acceleration."""

from typing import Any

import numpy as np

from ..sheet.check import check
from ..sheet.formula import formula
from ..sheet.quantity import result, value
from ..sheet.step import Curve, Outcome, Series
from ..sheet.trace import trace, untraced
from ..sheet.units import CubicMetre, Kilogram, Metre, MetrePerSecond, MetrePerSecond2, Number, Radian, RadPerSecond
from . import formulas as f
from .crank import Crank, crank
from .inputs import EngineInputs

ORDERS = range(1, 9)
POINTS = 2880
DRAWN = 8  # every eighth point


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
    piston_speed_max: MetrePerSecond = value("Largest piston speed", "m/s", "v_max")
    acceleration_max: MetrePerSecond2 = value("Largest piston acceleration", "m/s²", "a_max")
    acceleration_min: MetrePerSecond2 = value("Smallest piston acceleration", "m/s²", "a_min")
    acceleration_min_angle: Radian = value("Crank angle of the smallest acceleration", "°")
    crank: Crank
    harmonics: tuple[complex, ...]  # c_1 … c_8 of a/(ω² r), exact
    two_term: tuple[complex, ...]


@formula(
    "c_n",
    "Fourier analysis of the exact acceleration over one turn (Finotti 2013, 2.1, exact form)",
    shows="c_1 … c_8 from 2880 points of a/(ω²·r)",
)
def harmonics(a: Number) -> Number:
    """a/(ω² r) = Re Σ c_n e^{inα}: the complex amplitudes of orders 1 to 8, from equally spaced points over one turn."""
    spectrum = np.fft.rfft(a)[1 : len(ORDERS) + 1] * 2 / np.size(a)
    spectrum.real[np.abs(spectrum.real) < 1e-12] = 0.0
    spectrum.imag[np.abs(spectrum.imag) < 1e-12] = 0.0
    return spectrum  # type: ignore[return-value]


def _peak(y: Any) -> tuple[float, float]:
    """The largest of equally spaced points over a turn and its angle, refined by a parabola through three points."""
    k = int(np.argmax(y))
    a, b, c = y[k - 1], y[k], y[(k + 1) % y.size]
    shift = 0.5 * (a - c) / (a - 2 * b + c)
    return float(b - 0.25 * (a - c) * shift), float((k + shift) * 2 * np.pi / y.size)


def solve(engine: EngineInputs) -> Outcome:
    """Masses, kinematics and harmonics of one engine."""
    with trace() as lines:
        if engine.rod_cg_to_big_end is None:
            rod = f.rod_reciprocating_mass_by_thirds(M_B=engine.rod_mass)
        else:
            rod = f.rod_reciprocating_mass(M_B=engine.rod_mass, X_2=engine.rod_cg_to_big_end, L=engine.rod_length)
        reciprocating = f.reciprocating_mass(M_P=engine.piston_mass, M_ra=rod)
        rotating = f.rotating_mass(M_shell=engine.crankpin_bearing_mass, M_B=engine.rod_mass, M_ra=rod)
        lam = f.crank_ratio(r=engine.crank_radius, L=engine.rod_length)
        delta = f.offset_ratio(d=engine.cylinder_offset, L=engine.rod_length)
        omega = f.angular_speed(n=engine.rated_speed)
        phi_0 = f.tdc_angle(delta=delta, lam=lam)
        stroke = f.stroke(L=engine.rod_length, r=engine.crank_radius, d=engine.cylinder_offset)
        volume = f.displacement(N=engine.cylinders, D=engine.bore, s=stroke)
        mean_speed = f.mean_piston_speed(s=stroke, n=engine.rated_speed)
        alpha: Any = np.arange(POINTS) * (2 * np.pi / POINTS)
        beta = f.rod_angle(lam=lam, alpha=alpha, delta=delta)
        speed = f.relative_speed(alpha=alpha, beta=beta)
        exact: Any = f.relative_acceleration(alpha=alpha, beta=beta, lam=lam)
        highest, _ = _peak(exact)
        lowest, angle = _peak(-exact)
        fastest = f.piston_speed(v_rel=_peak(speed)[0], omega=omega, r=engine.crank_radius)
        a_max = f.acceleration(a_rel=highest, omega=omega, r=engine.crank_radius)
        a_min = f.acceleration(a_rel=-lowest, omega=omega, r=engine.crank_radius)
        at_lowest = f.angle_of_smallest(a_rel=exact, alpha=angle)
        spectrum: Any = harmonics(exact)
        throws = crank(engine, phi_0)
    with untraced():
        two_term: Any = f.relative_acceleration_two_term(alpha=alpha, lam=lam, delta=delta)
    result = EngineResult(
        reciprocating_mass=reciprocating, rotating_mass=rotating, lambda_=lam, delta=delta, angular_speed=omega, tdc_angle=phi_0,
        stroke=stroke, displacement=volume, mean_piston_speed=mean_speed, piston_speed_max=fastest, acceleration_max=a_max,
        acceleration_min=a_min, acceleration_min_angle=at_lowest, crank=throws,
        harmonics=tuple(complex(c) for c in spectrum), two_term=(1 - 1j * delta, complex(lam), *([0j] * (len(ORDERS) - 2))),
    )  # fmt: skip
    scale = omega**2 * engine.crank_radius
    degrees = np.degrees(alpha)[::DRAWN]
    curve = Curve(
        "acceleration", "Piston acceleration over one turn", "crank angle α, °", "a, m/s²",
        (Series("exact", degrees, exact[::DRAWN] * scale), Series("two terms", degrees, two_term[::DRAWN] * scale)),
    )  # fmt: skip
    checks = (
        check(
            "engine.crank.lambda_usual", "Crank ratio λ", lam, "in", (0.20, 0.33), "", "usual range of vehicle engines (Finotti 2013, 2.1)",
            "A longer rod lowers λ and with it every second-order force and couple.", kind="advice",
        ),
    )  # fmt: skip
    notes = (*result.crank.chosen, "The rod is replaced by two masses; the couple of its own inertia (J_G ≠ m·X₁·X₂) is neglected.")
    if engine.rod_cg_to_big_end is None:
        notes += ("The rod's centre of gravity is not given: one third of it is taken as reciprocating.",)
    return Outcome("engine", result=result, checks=checks, lines=tuple(lines), curves=(curve,), notes=notes)
