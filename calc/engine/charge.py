# SPDX-License-Identifier: Apache-2.0
"""The gas of an engine's cylinders: its cycle from what the design says, and what is taken for numbers left out."""

import math

import numpy as np

from ..sheet.arrays import distinct
from ..sheet.linked_array import gathered
from ..sheet.text import Amount, Text
from ..sheet.value import based_on
from . import formulas as f
from .cycle import TURN, WIDE, Cycle, MixedCycle, clearance_height, compression_end, crank_angle, dead_centre_angle, piston_way, widest_gap
from .gas import COMPRESSION, CRANKCASE, EXHAUST, EXPANSION, HELD, INTAKE, GasInputs
from .inputs import EngineInputs
from .result import EngineResult


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
        from_, gap = widest_gap(corners, length)
        if gap > WIDE:
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
    eps_bdc = dead_centre_angle(delta=e.delta, lam=e.lambda_)
    h_c = clearance_height(s=e.stroke, eps_c=gas.compression_ratio)
    p_c = compression_end(p_in=p_in, eps_c=gas.compression_ratio, n_c=n_c)
    alpha = crank_angle(phi_0=e.tdc_angle, epsilon=eps_p)
    beta = f.rod_angle(lam=e.lambda_, alpha=alpha, delta=e.delta)
    x_p = piston_way(r=engine.crank_radius, lam=e.lambda_, phi_0=e.tdc_angle, alpha=alpha, beta=beta)
    corners = distinct(np.array([0.0, eps_p, eps_bdc, length - TURN, length - TURN + eps_bdc]))[0]
    corners = based_on(corners, eps_p, eps_bdc, engine.strokes)
    given = MixedCycle(e.stroke, gas.peak_pressure, p_in, p_ex, n_c, n_e, eps_p, eps_bdc, h_c, x_p)
    return Cycle(length, crankcase, corners, given, tuple(notes), p_c)
