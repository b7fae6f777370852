# SPDX-License-Identifier: Apache-2.0
"""Where the throws stand: crank angles, axial positions and banks of any engine."""

import math
from typing import Any

import numpy as np

from ..sheet.arrays import Array
from ..sheet.record import record
from .inputs import USUAL_ORDERS, EngineInputs


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
    bank = np.asarray(engine.bank_of_cylinder if engine.bank_of_cylinder is not None else _banks(engine.layout, n))
    opening = math.pi if engine.layout == "boxer" else (engine.bank_angle or 0.0)
    psi = np.where(bank == 1, opening / 2, -opening / 2) if engine.layout != "inline" else np.zeros(n)
    if engine.crank_angles is not None:
        phi = np.asarray(engine.crank_angles)
    else:
        order = engine.firing_order or USUAL_ORDERS[n]
        if engine.firing_order is None:
            chosen.append(f"Firing order {'-'.join(map(str, order))} chosen: the usual one of an inline engine with {n} cylinders.")
        place = np.empty(n)
        place[np.asarray(order) - 1] = np.arange(n)
        phi = psi - place * math.pi * engine.strokes / n
        phi = (phi - phi[0]) % (2 * math.pi)
    if engine.axial_positions is not None:
        z = np.asarray(engine.axial_positions)
    else:
        row = np.arange(n) // 2 if engine.layout == "vee" else np.arange(n)
        z = (row - (row[0] + row[-1]) / 2) * engine.cylinder_pitch
    return Crank(phi, z, psi, float(psi[0]) + tdc_angle, tuple(chosen))


def _banks(layout: str, n: int) -> Any:
    """Cylinders alternate between the banks, 0 first; an inline engine has bank 0 only."""
    return np.zeros(n) if layout == "inline" else np.arange(n) % 2.0
