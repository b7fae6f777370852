# SPDX-License-Identifier: Apache-2.0
"""The figures of the crank train: the piston's way, speed and acceleration over a turn, and the forces of one
cylinder."""

import numpy as np

from ..sheet.arrays import Array
from ..sheet.step import Curve, Series, axis_label
from ..sheet.text import Text
from ..sheet.units import Metre, Newton
from ..sheet.value import untraced
from . import formulas as f
from .result import EngineResult

ANGLE = axis_label("crank angle α", "°")
FORMS = (Text("exact"), Text("two terms"))


def curves(r: Metre, e: EngineResult) -> tuple[Curve, ...]:
    """Way, speed and acceleration, exact beside the two terms of the textbooks, and what one cylinder puts on the
    block."""
    omega, lam, delta = e.angular_speed, e.lambda_, e.delta
    alpha = np.radians(np.arange(0.0, 361.0))
    with untraced():
        beta = f.rod_angle(lam=lam, alpha=alpha, delta=delta)
        motions = (
            (
                "acceleration",
                Text("Piston acceleration over one turn"),
                axis_label("a", "m/s²"),
                r * omega**2,
                f.relative_acceleration(alpha=alpha, beta=beta, lam=lam),
                f.relative_acceleration_two_term(alpha=alpha, lam=lam, delta=delta),
            ),
            (
                "speed",
                Text("Piston speed over one turn"),
                axis_label("v", "m/s"),
                r * omega,
                f.relative_speed(alpha=alpha, beta=beta),
                f.relative_speed_two_term(alpha=alpha, lam=lam, delta=delta),
            ),
            (
                "path",
                Text("Way of the piston from TDC over one turn"),
                axis_label("x", "mm"),
                r * 1e3,
                f.relative_path(alpha=alpha, beta=beta, lam=lam, delta=delta),
                f.relative_path_two_term(alpha=alpha, lam=lam, delta=delta),
            ),
        )
    degrees = np.degrees(alpha)
    drawn = [
        Curve(id, title, ANGLE, label, tuple(Series(words, degrees, y * scale) for words, y in zip(FORMS, forms)))
        for id, title, label, scale, *forms in motions
    ]
    return (*drawn, _forces(alpha, motions[0][4], e.reciprocating_mass * r * omega**2, e.harmonics))


def _forces(alpha: Array, relative: Array, scale: Newton, harmonics: tuple[complex, ...]) -> Curve:
    """The inertia force of one cylinder's reciprocating mass on the block: the first two orders, and all of them."""
    orders = (
        Series(Text("order {n}", n=n), np.degrees(alpha), scale * (harmonics[n - 1] * np.exp(1j * n * alpha)).real)
        for n in (1, 2)
    )
    return Curve(
        "cylinder_forces",
        Text("Inertia forces of one cylinder over one turn"),
        ANGLE,
        axis_label("force on the block, outwards", "N"),
        (*orders, Series(Text("all orders"), np.degrees(alpha), scale * relative)),
    )
