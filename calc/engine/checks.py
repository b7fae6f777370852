# SPDX-License-Identifier: Apache-2.0
"""The checks of the engine: crank ratio, even firing, the gas, the irregularity of its speed."""

import math
from collections.abc import Iterator

from ..sheet.check import Check
from ..sheet.shim_check import check
from ..sheet.text import Text
from ..sheet.value import based_on
from .crank import DUST, TURN
from .cycle import WIDE, widest_gap
from .inputs import CRANK_RATIO, EngineInputs
from .result import EngineResult, TorqueResult

IRREGULAR = 0.05
EVEN = math.radians(1.0)  # a firing interval may be so far from the even one


def checks(engine: EngineInputs, e: EngineResult, turning: TorqueResult) -> Iterator[Check]:
    yield from _gas_checks(engine, e, turning)
    if turning.speed_irregularity is not None:
        yield check(
            "engine.speed_irregularity",
            Text("Speed irregularity"),
            turning.speed_irregularity,
            "<=",
            IRREGULAR,
            "",
            Text(
                "rule of this program after machine handbooks, from memory: ΔE = J·ω²·δ_s holds for small δ_s; running "
                "drives are kept well below 1/20"
            ),
            Text("A larger inertia of the flywheel lowers it in proportion."),
        )
    yield _crank_ratio_check(e)
    yield _firing_check(e)


def _gas_checks(engine: EngineInputs, e: EngineResult, turning: TorqueResult) -> Iterator[Check]:
    """Whether the gas gives work, no less than the crank gives, and whether its table has gaps."""
    if turning.indicated_work is not None:
        yield check(
            "engine.gas.work",
            Text("Indicated work of a cycle"),
            turning.indicated_work,
            ">",
            0.0,
            "J",
            Text("energy: an engine gives work"),
            Text(
                "The gas takes more work than it gives: look at peak pressure and compression ratio, or at the "
                "table of pressure."
            ),
        )
    if turning.indicated_mean_pressure is not None and e.brake_mean_pressure is not None:
        yield check(
            "engine.rated_power",
            Text("Brake mean effective pressure, against the indicated one"),
            e.brake_mean_pressure,
            "<=",
            turning.indicated_mean_pressure,
            "bar",
            Text("energy: a crank gives no more than its gas"),
            Text("Correct the rated power, or the gas: what the crank gives is what the gas gives less the friction."),
        )
    if engine.gas is not None and engine.gas.pressure and turning.cycle is not None:
        _, gap = widest_gap(turning.cycle.corners, turning.cycle.length)
        yield check(
            "engine.gas.gap",
            Text("Largest gap in the table of indicated pressure"),
            based_on(gap, turning.cycle.corners),
            "<=",
            WIDE,
            "°",
            Text("rule of this program: a straight line is taken across a gap"),
            Text("Give points at least every 60° of the whole cycle."),
        )


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
    return check(
        "engine.crank.lambda_usual",
        Text("Crank ratio λ"),
        lam,
        "in",
        CRANK_RATIO,
        "",
        Text("Finotti 2013, 2.1, and mechanics textbook, 48.3.3: usual 0.22 to 0.30; Finotti 2013, 2.2.4: 0.2 to 0.3"),
        advice,
    )


def _firing_check(e: EngineResult) -> Check:
    """Of the interval that is furthest from the even one."""
    even, shortest, longest = e.firing_interval, e.firing_interval_shortest, e.firing_interval_longest
    assert even is not None and shortest is not None and longest is not None
    uneven = max(longest - even, even - shortest)
    uneven = based_on(uneven if uneven > DUST * TURN else 0.0, even, longest, shortest)
    return check(
        "engine.firing.even",
        Text("Deviation of a firing interval from the even one"),
        uneven,
        "<=",
        EVEN,
        "°",
        Text("rule of this program: even firing within 1° (Finotti 2013, 2.4: interval 180°·strokes/N)"),
        Text(
            "This crank fires unevenly: the torque pulsates at lower orders. Crank angles that follow from a firing "
            "order are even."
        ),
    )
