# SPDX-License-Identifier: Apache-2.0
"""The counter-shaft as given: its couple, what it leaves of the imbalance, what its supports carry."""

import math
from typing import Any

import numpy as np

from ..imbalance.pictures import DRAWN
from ..imbalance.remedies import roll_torque
from ..imbalance.solve import ImbalanceResult
from ..sheet.check import Check, check
from ..sheet.quantity import result, value
from ..sheet.step import Curve, Outcome, Series
from ..sheet.trace import trace
from ..sheet.units import Kilogram, KilogramMetre, Newton, NewtonMetre, Radian, RadPerSecond
from . import formulas as f
from .inputs import CountershaftInputs

LEFT_OVER = 0.05  # share of the required couple that a good shaft may leave


@result
class CountershaftResult:
    """What the shaft supplies, leaves over and puts on its supports."""

    couple: NewtonMetre = value("Couple of the shaft as designed", "N·m", "C_S")
    couple_phase: Radian = value("its phase, cylinder 1 at TDC", "°")
    residual_order_1_couple: NewtonMetre = value("First-order couple left over", "N·m", "C_1,res")
    residual_order_1_force: Newton = value("First-order force left over", "N", "F_1,res")
    static_unbalance: KilogramMetre = value("Static unbalance of the shaft", "g·mm", "ΣU")
    force: Newton = value("Rotating force of the shaft", "N", "F_S")
    reaction_front: Newton = value("Reaction of the front bearing", "N", "R_f")
    reaction_rear: Newton = value("Reaction of the rear bearing", "N", "R_r")
    eccentric_mass: Kilogram = value("Eccentric masses together", "kg", "Σm")
    roll_torque: NewtonMetre | None = value("Roll torque of its force beside the crank", "N·m", "T_roll", default=None)
    force_vector: complex  # F_S and C_S, cylinder 1 at TDC
    couple_vector: complex
    slope_front: Radian | None = value("Slope of the front journal, as given", "mrad", "θ_f", default=None)
    slope_rear: Radian | None = value("Slope of the rear journal, as given", "mrad", "θ_r", default=None)


def _slope_checks(slopes: tuple[Radian, ...] | None) -> tuple[Check, ...]:
    return tuple(
        check(
            f"countershaft.slope_{place}", f"Slope of the {place} journal", slope, "<=", 0.25e-3, "mrad",
            "Finotti 2013, ch. 6: target of the engine's maker", "A stiffer shaft between its bearings: larger core, shorter span.",
        )
        for place, slope in zip(("front", "rear"), (slopes[0], slopes[-1]) if slopes else ())
    )  # fmt: skip


def _column(shaft: CountershaftInputs, name: str) -> Any:
    """One number of every eccentric mass, as an array."""
    return np.array([getattr(part, name) for part in shaft.masses])


def solve(shaft: CountershaftInputs, imbalance: ImbalanceResult, omega: RadPerSecond, slopes: tuple[Radian, ...] | None = None) -> Outcome:
    """Check a shaft of given masses against the couple that the engine asks for.  `omega` is the crank's rated angular speed.

    `slopes` are those of the journals where they are known from elsewhere; the bending itself is not computed yet.
    """
    m, e, gamma, z = (_column(shaft, name) for name in ("mass", "radius", "angle", "z"))
    z_f, z_r = shaft.bearing_positions
    F_forward, F_backward, C_forward, C_backward = imbalance.orders["order_1"].vectors
    with trace() as lines:
        C_S = f.shaft_couple(omega=omega, m=m, e=e, z=z, gamma=gamma)
        couple = f.couple(C_S=C_S)
        phase = f.couple_phase(C_S=C_S)
        F_S = f.shaft_force(omega=omega, m=m, e=e, gamma=gamma)
        force = f.force(F_S=F_S)
        together = f.eccentric_mass(m=m)
        unbalance = f.static_unbalance(F_S=force, omega=omega)
        left = f.residual_backward(C_b=C_backward, C_S=C_S)
        residual = f.residual_couple(C_f=C_forward, C_b=left)
        residual_force = f.residual_force(F_f=F_forward, F_b=F_backward, F_S=F_S)
        roll = roll_torque(p=complex(*shaft.axis), F=F_S) if shaft.axis is not None else None
        R_r = f.reaction_rear(C_S=C_S, z_f=z_f, F_S=F_S, z_r=z_r)
        R_f = f.reaction_front(F_S=F_S, R_r=R_r)
        rear, front = f.reaction(R=R_r), f.reaction(R=R_f)
    result = CountershaftResult(
        couple=couple,
        couple_phase=phase,
        residual_order_1_couple=residual,
        residual_order_1_force=residual_force,
        static_unbalance=unbalance,
        force=force,
        reaction_front=front,
        reaction_rear=rear,
        eccentric_mass=together,
        roll_torque=roll,
        force_vector=F_S,
        couple_vector=C_S,
        slope_front=slopes[0] if slopes else None,
        slope_rear=slopes[-1] if slopes else None,
    )
    needed = imbalance.required_couple
    checks = (
        check(
            "countershaft.residual",
            "First-order couple left over",
            residual,
            "<=",
            LEFT_OVER * (needed or imbalance.one_couple),
            "N·m",
            "rule of this program: 5 % of the couple to be balanced, or of m·r·ω²·a where there is none",
            f"Aim at {needed:.1f} N·m at {math.degrees(imbalance.required_couple_phase):.1f}°: "
            "the couple grows with mass, radius and arm of the eccentric masses.",
        ),
        check(
            "countershaft.residual_force",
            "First-order force left over",
            residual_force,
            "<=",
            LEFT_OVER * imbalance.one_force,
            "N",
            "rule of this program: 5 % of m·r·ω² of one cylinder",
            "Balance the masses against each other (mass times radius), so that only a couple remains.",
        ),
        *_slope_checks(slopes),
    )
    curves = tuple(
        _residual(word, unit, before, supplied)
        for word, unit, before, supplied, one in (
            ("couple", "N·m", (C_forward, C_backward), C_S, imbalance.one_couple),
            ("force", "N", (F_forward, F_backward), F_S, imbalance.one_force),
        )
        if max(abs(before[0]), abs(before[1]), abs(supplied)) > DRAWN * one
    )  # fmt: skip
    notes = (
        "The middle of the shaft is taken as the middle of the engine; for a pure couple its place does not matter.",
        "The reactions turn with the shaft; its weight and the gear force stand still and are not added here.",
    )
    return Outcome("countershaft", result=result, checks=checks, lines=tuple(lines), curves=curves, notes=notes)


def _residual(word: str, unit: str, before: tuple[complex, complex], supplied: complex) -> Curve:
    """What is left of first order, as the path over a turn, before and after the shaft."""
    theta = np.radians(np.arange(0, 361, 3.0))
    forward, backward = np.exp(1j * theta), np.exp(-1j * theta)
    alone = before[0] * forward + before[1] * backward
    after = before[0] * forward + (before[1] + supplied) * backward
    return Curve(
        "residual" if word == "couple" else "residual_force", f"First-order {word} before and after the counter-shaft",
        f"horizontal, {unit}", f"vertical, {unit}",
        (Series("before", alone.imag, alone.real), Series("after", after.imag, after.real)), equal=True,
    )  # fmt: skip
