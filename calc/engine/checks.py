# SPDX-License-Identifier: Apache-2.0
"""The checks of the engine: crank ratio, even firing, the gas, the irregularity of its speed."""

import math
from collections.abc import Iterator
from itertools import combinations

from ..sheet.check import Check, CheckRule
from ..sheet.quantity import declared, dotted
from ..sheet.text import Text
from ..sheet.value import based_on
from .crank import DUST, TURN
from .cycle import WIDE, widest_gap
from .gas import GasInputs
from .inputs import CRANK_RATIO, EngineInputs
from .result import EngineResult, TorqueResult

EVEN = math.radians(1.0)  # a firing interval may be so far from the even one
IRREGULAR = 0.05
NO_PRESSURE = 0.1e6  # Pa: a mean pressure of no engine, against which that of nought is held

SPEED_IRREGULARITY = CheckRule(
    dotted("engine", TorqueResult.speed_irregularity),
    "method",
    "The formula holds for small irregularities only.",
    Text("Speed irregularity"),
    "<=",
    source=Text(
        "rule of this program after machine handbooks, from memory: ΔE = J·ω²·δ_s holds for small δ_s; running "
        "drives are kept well below 1/20"
    ),
    advice=Text("A larger inertia of the flywheel lowers it in proportion."),
    value_id=dotted("engine", TorqueResult.speed_irregularity),
    moved_by=(dotted("engine", EngineInputs.flywheel_inertia),),
)
GAS_WORK = CheckRule(
    "engine.gas.work",
    "method",
    "An engine that gives no work has wrong data of its gas.",
    Text("Indicated work of a cycle"),
    ">",
    "J",
    Text("energy: an engine gives work"),
    Text(
        "The gas takes more work than it gives: look at peak pressure and compression ratio, or at the table of "
        "pressure."
    ),
    zero="0.1 MPa times the displacement of a cylinder",
    value_id=dotted("engine", TorqueResult.indicated_work),
    moved_by=(
        dotted("engine", EngineInputs.gas, GasInputs.peak_pressure),
        dotted("engine", EngineInputs.gas, GasInputs.compression_ratio),
    ),
)
RATED_POWER = CheckRule(
    "engine.rated_power",
    "limit",
    "Power that no gas gives: one of the two numbers is wrong.",
    Text("Brake mean effective pressure, against the indicated one"),
    "<=",
    "bar",
    Text("energy: a crank gives no more than its gas"),
    Text("Correct the rated power, or the gas: what the crank gives is what the gas gives less the friction."),
    role="self",
    zero="0.1 MPa",
    value_id=dotted("engine", declared(EngineResult).brake_mean_pressure),
    limit_id=dotted("engine", TorqueResult.indicated_mean_pressure),
    moved_by=(dotted("engine", EngineInputs.rated_power),),
    short=Text("power"),
)
GAS_GAP = CheckRule(
    "engine.gas.gap",
    "method",
    "A straight line across a wide gap decides the torque: it concerns the data.",
    Text("Largest gap in the table of indicated pressure"),
    "<=",
    "°",
    Text("rule of this program: a straight line is taken across a gap"),
    Text("Give points at least every 60° of the whole cycle."),
    moved_by=(dotted("engine", EngineInputs.gas, GasInputs.pressure),),
)
BORES = CheckRule(
    "engine.bores",
    "limit",
    "Bores that overlap can not be made.",
    Text("Distance of the axes of the nearest cylinders of a bank"),
    unit="mm",
    source=Text("geometry: two bores side by side"),
    advice=Text("It must exceed the bore by the wall between them."),
    role="physics",
    moved_by=(
        dotted("engine", EngineInputs.cylinder_pitch),
        dotted("engine", EngineInputs.axial_positions),
        dotted("engine", EngineInputs.bore),
    ),
    short=Text("bores"),
    of_input=True,
)
LAMBDA_USUAL = CheckRule(
    "engine.crank.lambda_usual",
    "advice",
    "The usual range of vehicle engines; any crank ratio is computed exactly.",
    Text("Crank ratio λ"),
    "in",
    source=Text(
        "Finotti 2013, 2.1, and mechanics textbook, 48.3.3: usual 0.22 to 0.30; Finotti 2013, 2.2.4: 0.2 to 0.3"
    ),
    value_id=dotted("engine", declared(EngineResult).lambda_),
    moved_by=(dotted("engine", EngineInputs.rod_length), dotted("engine", EngineInputs.crank_radius)),
)
EVEN_FIRING = CheckRule(
    "engine.firing.even",
    "advice",
    "Uneven firing is a choice; it costs smoothness and breaks nothing.",
    Text("Deviation of a firing interval from the even one"),
    "<=",
    "°",
    Text("rule of this program: even firing within 1° (Finotti 2013, 2.4: interval 180°·strokes/N)"),
    Text(
        "This crank fires unevenly: the torque pulsates at lower orders. Crank angles that follow from a firing order "
        "are even."
    ),
    moved_by=(dotted("engine", EngineInputs.crank_angles), dotted("engine", EngineInputs.firing_order)),
)


def checks(engine: EngineInputs, e: EngineResult, turning: TorqueResult) -> Iterator[Check]:
    yield from _bores_checks(engine, e)
    yield from _gas_checks(engine, e, turning)
    if turning.speed_irregularity is not None:
        yield SPEED_IRREGULARITY(turning.speed_irregularity, IRREGULAR)
    yield _crank_ratio_check(e)
    yield _firing_check(e)


def _bores_checks(engine: EngineInputs, e: EngineResult) -> Iterator[Check]:
    """Of cylinders in one direction, whose axes may be offset from the crank's by unlike lengths; only where there is
    no wall between them, or hardly one."""
    places = zip(e.crank.z.tolist(), engine.offsets, e.crank.psi.tolist())
    pairs = combinations(places, 2)
    apart = [math.hypot(z - z_2, d - d_2) for (z, d, psi), (z_2, d_2, psi_2) in pairs if abs(psi - psi_2) < DUST]
    if apart and (check := BORES(based_on(min(apart), e.crank.z), engine.bore)).open:
        yield check


def _gas_checks(engine: EngineInputs, e: EngineResult, turning: TorqueResult) -> Iterator[Check]:
    """Whether the gas gives work, no less than the crank gives, and whether its table has gaps."""
    if turning.indicated_work is not None:
        yield GAS_WORK(turning.indicated_work, 0.0, scale=NO_PRESSURE * e.displacement / engine.cylinders)
    if turning.indicated_mean_pressure is not None and e.brake_mean_pressure is not None:
        yield RATED_POWER(e.brake_mean_pressure, turning.indicated_mean_pressure, scale=NO_PRESSURE)
    if engine.gas is not None and engine.gas.pressure and turning.cycle is not None:
        _, gap = widest_gap(turning.cycle.corners, turning.cycle.length)
        yield GAS_GAP(based_on(gap, turning.cycle.corners), WIDE)


def _crank_ratio_check(e: EngineResult) -> Check:
    """Of the cylinder that is furthest from what is usual."""
    lam = max(
        (cylinder.lambda_ for cylinder in (e.cylinder or {}).values()),
        default=e.lambda_,
        key=lambda ratio: abs(ratio - sum(CRANK_RATIO) / 2),
    )
    if lam < CRANK_RATIO[0]:
        advice = Text("A rod longer than usual: less second order, but a heavier rod and a taller engine.")
    else:
        advice = Text(
            "A longer rod lowers λ and with it every second-order force and couple. The range is a guide, no limit: "
            "the R753IE4 of Finotti 2013, 2.5.3.1, lies above it with 0.3282."
        )
    return LAMBDA_USUAL(lam, CRANK_RATIO, advice=advice)


def _firing_check(e: EngineResult) -> Check:
    """Of the interval that is furthest from the even one."""
    even, shortest, longest = e.firing_interval, e.firing_interval_shortest, e.firing_interval_longest
    assert even is not None and shortest is not None and longest is not None
    uneven = max(longest - even, even - shortest)
    return EVEN_FIRING(based_on(uneven if uneven > DUST * TURN else 0.0, even, longest, shortest), EVEN)
