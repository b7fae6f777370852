# SPDX-License-Identifier: Apache-2.0
"""Forces and couples of orders 1 to 8, what the crank takes of them, and what the counter-shaft must supply."""

import math
from dataclasses import replace
from typing import Any

import numpy as np

from ..engine.inputs import EngineInputs
from ..engine.solve import ORDERS, EngineResult
from ..sheet.check import Check, check
from ..sheet.quantity import group, result, value
from ..sheet.step import Curve, Erratum, Outcome, Series
from ..sheet.trace import about, trace
from ..sheet.units import KilogramMetre2, Newton, NewtonMetre, Number, Radian
from . import formulas as f
from .inputs import ImbalanceInputs

ALWAYS = (1, 2, 4, 6)  # orders that are shown even where they are zero
FIRST, SECOND = 0.05, 0.5  # shares of one cylinder's first- and second-order force that a good balance may leave


@result
class Order:
    """One order: the vectors turning with and against the crank at n times its speed, after the crank's own counterweights."""

    force_forward: Newton = value("Force turning forward", "N", "F⁺")
    force_forward_phase: Radian = value("its phase", "°")
    force_backward: Newton = value("Force turning backward", "N", "F⁻")
    force_backward_phase: Radian = value("its phase", "°")
    force_peak_vertical: Newton = value("Largest vertical force", "N", "F_V")
    force_peak_horizontal: Newton = value("Largest horizontal force", "N", "F_H")
    couple_forward: NewtonMetre = value("Couple turning forward", "N·m", "C⁺")
    couple_forward_phase: Radian = value("its phase", "°")
    couple_backward: NewtonMetre = value("Couple turning backward", "N·m", "C⁻")
    couple_backward_phase: Radian = value("its phase", "°")
    couple_peak_vertical: NewtonMetre = value("Largest vertical couple", "N·m", "C_V")
    couple_peak_horizontal: NewtonMetre = value("Largest horizontal couple", "N·m", "C_H")
    vectors: tuple[complex, complex, complex, complex]  # F⁺ F⁻ C⁺ C⁻
    two_term: "Order | None" = group(default=None)


@result
class ImbalanceResult:
    """All orders, and what the counter-shaft must supply."""

    orders: dict[str, Order] = group(spread=True)
    required_couple: NewtonMetre = value("Couple that the counter-shaft must supply", "N·m", "C_S")
    required_couple_phase: Radian = value("its phase, cylinder 1 at TDC", "°")
    required_unbalance_product: KilogramMetre2 = value("Unbalance times arm of the counter-shaft", "kg·mm²", "U·Δz")
    mistiming_per_degree: NewtonMetre = value("Couple left per degree of mistiming", "N·m")
    required: complex  # the vector
    one_force: Newton  # m·r·ω² of one cylinder, and its couple over one pitch: what is left is measured against them
    one_couple: NewtonMetre


def _order(n: int, c_n: Any, imbalance: ImbalanceInputs, engine: EngineInputs, e: EngineResult) -> Order:
    crank: Any = e.crank  # arrays enter the formulas here
    common: dict[str, Any] = dict(
        omega=e.angular_speed, m=e.reciprocating_mass, r=engine.crank_radius, theta_0=crank.theta_0, phi=crank.phi
    )
    F_f = f.force_forward(c_n=c_n, n=float(n), psi=crank.psi, **common)
    F_b = f.force_backward(c_n=c_n, n=float(n), psi=crank.psi, **common)
    C_f = f.couple_forward(c_n=c_n, n=float(n), z=crank.z, psi=crank.psi, **common)
    C_b = f.couple_backward(c_n=c_n, n=float(n), z=crank.z, psi=crank.psi, **common)
    if n == 1:
        kappa = imbalance.crank_balance_fraction
        dust = 1e-9 * e.reciprocating_mass * engine.crank_radius * e.angular_speed**2
        F_f = _clean(f.remaining_force(F_f, f.counterweight_force(kappa=kappa, **common)), dust)
        C_f = _clean(f.remaining_couple(C_f, f.counterweight_couple(kappa=kappa, z=crank.z, **common)), dust * engine.cylinder_pitch)
    return Order(
        force_forward=f.force_length(F=F_f),
        force_forward_phase=f.force_direction(F=F_f),
        force_backward=f.force_length(F=F_b),
        force_backward_phase=f.force_direction(F=F_b),
        force_peak_vertical=f.force_peak_vertical(F_f, F_b),
        force_peak_horizontal=f.force_peak_horizontal(F_f, F_b),
        couple_forward=f.couple_length(C=C_f),
        couple_forward_phase=f.couple_direction(C=C_f),
        couple_backward=f.couple_length(C=C_b),
        couple_backward_phase=f.couple_direction(C=C_b),
        couple_peak_vertical=f.couple_peak_vertical(C_f, C_b),
        couple_peak_horizontal=f.couple_peak_horizontal(C_f, C_b),
        vectors=(F_f, F_b, C_f, C_b),
    )


def _clean(vector: complex, dust: float) -> complex:
    """Two vectors that cancel leave the dust of the last digits, which would have a length and a phase."""
    return vector if abs(vector) > dust else 0j


def solve(imbalance: ImbalanceInputs, engine: EngineInputs, e: EngineResult, shaft: bool = True) -> Outcome:
    """The imbalance of an engine whose crank carries the given share of the reciprocating masses.

    `shaft`: the design has a counter-shaft, whose own step judges what is left of the backward couple.
    """
    orders: dict[str, Order] = {}
    judged = e.harmonics if imbalance.kinematics == "exact" else e.two_term
    with trace() as lines:
        for n in ORDERS:
            c_n = judged[n - 1]
            if not c_n and n not in ALWAYS:
                continue
            with about(f"order {n}"):
                solved = _order(n, c_n, imbalance, engine, e)
            if n <= 2:
                with about(f"order {n}, two terms"):
                    solved = replace(solved, two_term=_order(n, e.two_term[n - 1], imbalance, engine, e))
            orders[f"order_{n}"] = solved
        with about("counter-shaft"):
            required = f.required_couple(orders["order_1"].vectors[3])
            length = f.couple_length(C=required)
            phase = f.couple_direction(C=required)
            product = f.unbalance_product(C_S=length, omega=e.angular_speed)
            mistiming = f.couple_per_degree(C_S=length)
    one_force = e.reciprocating_mass * engine.crank_radius * e.angular_speed**2
    result = ImbalanceResult(
        orders=orders,
        required_couple=length,
        required_couple_phase=phase,
        required_unbalance_product=product,
        mistiming_per_degree=mistiming,
        required=required,
        one_force=one_force,
        one_couple=one_force * engine.cylinder_pitch,
    )
    return Outcome(
        "imbalance",
        result=result,
        checks=_checks(result, e.lambda_, shaft),
        lines=tuple(lines),
        curves=_curves(result),
        errata=_errata(imbalance, result),
        notes=(
            "Couples are taken about the middle of the engine; where a force is left as well, they hold about that plane only.",
            "The torque reaction about the crank axis can not be balanced by masses and is not part of this step.",
        ),
    )


def _checks(result: ImbalanceResult, lam: Number, shaft: bool) -> tuple[Check, ...]:
    """What is left, against the force of one cylinder's reciprocating mass and its couple over one pitch."""
    force, couple = result.one_force, result.one_couple
    first, second = result.orders["order_1"], result.orders["order_2"]
    own = "rule of this program, against m·r·ω² of one cylinder (couples: over one pitch)"
    forward = "A backward shaft can not take it: balance half of the reciprocating mass on the crank (fraction 0.5)."
    backward = "A couple-free shaft at −ω with this force, in the plane of the engine's middle, takes it."
    phase = math.degrees(result.required_couple_phase)
    counter = f"One shaft at −ω takes it: {result.required_couple:.1f} N·m at {phase:.1f}°; add [countershaft]."
    two = "A shaft at crank speed leaves it whole; two shafts at ±2ω would take it, a longer rod lowers it."

    def advice(name: str, label: str, value: float, limit: float, unit: str, what: str) -> Check:
        return check(f"imbalance.{name}", label, value, "<=", limit, unit, own, what, kind="advice")

    alone = advice("order_1.backward", "First-order couple turning backward", first.couple_backward, FIRST * couple, "N·m", counter)
    return (
        *(() if shaft else (alone,)),
        advice("order_1.forward", "First-order couple turning forward", first.couple_forward, FIRST * couple, "N·m", forward),
        advice("order_1.forward_force", "First-order force turning forward", first.force_forward, FIRST * force, "N", forward),
        advice("order_1.backward_force", "First-order force turning backward", first.force_backward, FIRST * force, "N", backward),
        advice("order_2.couple", "Second-order couple left", _peak_couple(second), SECOND * lam * couple, "N·m", two),
        advice("order_2.force", "Second-order force left", _peak_force(second), SECOND * lam * force, "N", two),
    )


def _peak_couple(order: Order) -> float:
    return max(order.couple_peak_vertical, order.couple_peak_horizontal)


def _peak_force(order: Order) -> float:
    return max(order.force_peak_vertical, order.force_peak_horizontal)


def _errata(imbalance: ImbalanceInputs, result: ImbalanceResult) -> tuple[Erratum, ...]:
    second = result.orders.get("order_2")
    if second is None or second.two_term is None or not second.two_term.couple_peak_vertical or not imbalance.crank_balance_fraction:
        return ()
    theirs = f.second_order_couple_of_finotti(kappa=imbalance.crank_balance_fraction, C_2=second.two_term.couple_peak_vertical)
    return (
        Erratum(
            "imbalance.order_2.couple_peak_vertical",
            "Second-order couple",
            float(theirs),
            "N·m",
            "method of Finotti 2013, 2.5.3.4",
            "The source takes only the mass that is not balanced on the crank. Counterweights turn at crank speed and leave order 2 "
            "untouched: the whole reciprocating mass acts.",
        ),
    )


def _curves(result: ImbalanceResult) -> tuple[Curve, ...]:
    theta = np.radians(np.arange(0, 361, 3.0))
    total_F, total_C = np.zeros(theta.size, complex), np.zeros(theta.size, complex)
    for name, order in result.orders.items():
        n = int(name.rpartition("_")[2])
        F_f, F_b, C_f, C_b = order.vectors
        forward, backward = np.exp(1j * n * theta), np.exp(-1j * n * theta)
        total_F += F_f * forward + F_b * backward
        total_C += C_f * forward + C_b * backward
    first = result.orders["order_1"].vectors
    locus = first[2] * np.exp(1j * theta) + first[3] * np.exp(-1j * theta)
    degrees = np.degrees(theta)
    turn = "crank angle from TDC of cylinder 1, °"
    return (
        Curve(
            "couples",
            "Couples of all orders over one turn",
            turn,
            "C, N·m",
            (Series("vertical", degrees, total_C.real), Series("horizontal", degrees, total_C.imag)),
        ),
        Curve(
            "forces",
            "Forces of all orders over one turn",
            turn,
            "F, N",
            (Series("vertical", degrees, total_F.real), Series("horizontal", degrees, total_F.imag)),
        ),
        Curve(
            "locus",
            "Locus of the first-order couple",
            "horizontal, N·m",
            "vertical, N·m",
            (Series("before the shaft", locus.imag, locus.real),),
            equal=True,
        ),
    )
