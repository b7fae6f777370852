# SPDX-License-Identifier: Apache-2.0
"""Where the throws stand: crank angles, axial positions and banks of any engine."""

import math
from typing import Any

import numpy as np

from ..sheet.arrays import Array
from ..sheet.formula import formula
from ..sheet.record import record
from ..sheet.units import Metre, Number, Radian
from .inputs import USUAL_ORDERS, EngineInputs


@formula("φ", "Finotti 2013, 2.4: even firing, throw k at ψ_k − i_k·180°·strokes/N", shows="φ from ψ − i·π·strokes/N, counted from throw 1")
def throw_angles(psi: Radian, i: Number, strokes: Number, N: Number) -> Radian:
    """The angle of every throw, leading throw 1; i is the place of each cylinder in the firing order."""
    phi: Any = psi - i * math.pi * strokes / N
    return (phi - phi[0]) % (2 * math.pi)


@formula("z", "equal pitch, counted from mid-engine towards the flywheel", shows="z from the cylinders' places times the pitch a")
def axial_positions(k: Number, a: Metre) -> Metre:
    row: Any = k
    return (row - (row.min() + row.max()) / 2) * a


@record
class Crank:
    """One entry per cylinder: φ angle of its throw from throw 1 [rad], z axial position [m], ψ direction of its bank [rad].

    `theta_0` is the angle of throw 1 from up while cylinder 1 stands at its TDC.  `chosen` says what the program decided.
    """

    phi: Array
    z: Array
    psi: Array
    theta_0: float
    chosen: tuple[str, ...]


def crank(engine: EngineInputs, tdc_angle: float) -> Crank:
    """The crank of an engine from its crank angles, or from the firing order of an evenly firing engine.

    Angles lead cylinder 1 in the sense of rotation; z = 0 is mid-engine, + towards the flywheel.  Source of the even-firing
    rule: firing interval 180°·strokes/cylinders, throw k at ψ_k − i_k·Δ (Finotti 2013, 2.4).
    """
    n = engine.cylinders
    chosen: list[str] = []
    bank: Any = np.asarray(engine.bank_of_cylinder if engine.bank_of_cylinder is not None else _banks(engine.layout, n))
    opening = math.pi if engine.layout == "boxer" else (engine.bank_angle or 0.0)
    psi: Any = np.where(bank == 1, opening / 2, -opening / 2) if engine.layout != "inline" else np.zeros(n)
    if engine.crank_angles is not None:
        phi: Any = np.asarray(engine.crank_angles)
    else:
        order = engine.firing_order or USUAL_ORDERS[n]
        if engine.firing_order is None:
            chosen.append(f"Firing order {'-'.join(map(str, order))} chosen: the usual one of an inline engine with {n} cylinders.")
        place: Any = np.empty(n)
        place[np.asarray(order) - 1] = np.arange(n)
        phi = throw_angles(psi=psi, i=place, strokes=engine.strokes, N=n)
    if engine.axial_positions is not None:
        z: Any = np.asarray(engine.axial_positions)
    else:
        row: Any = _rows(bank) if engine.layout == "vee" else np.arange(n)
        z = axial_positions(k=row, a=engine.cylinder_pitch)
    return Crank(phi, z, psi, float(psi[0]) + tdc_angle, tuple(chosen))


def _rows(bank: Any) -> Any:
    """Cylinders of a vee engine side by side: the first of either bank, the second …; their stagger is neglected."""
    return np.array([int(np.sum(bank[:k] == b)) for k, b in enumerate(bank)])


def _banks(layout: str, n: int) -> Any:
    """Cylinders alternate between the banks, 0 first; an inline engine has bank 0 only."""
    return np.zeros(n) if layout == "inline" else np.arange(n) % 2.0
