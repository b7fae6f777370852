# SPDX-License-Identifier: Apache-2.0
"""The checks of the modes: whether they lie below what drives the engine, above the road, apart from each other and from operations."""

import math
from collections.abc import Iterator

from ..engine.inputs import EngineInputs
from ..sheet.check import Check, check
from ..sheet.text import Amount, Name, Text
from ..sheet.value import based_on
from .body import DOFS
from .drive import operating
from .inputs import MountingInputs
from .result import MountingResult
from .words import DOF_WORDS

RULE = Text("rule of this program: mounts of a multi-cylinder engine in practice")
ISOLATION = Text("dynamics of vibration isolation: it begins √2 above a mode")
KEPT, APART = 0.85, 0.10


def mode_checks(mounting: MountingInputs, result: MountingResult) -> Iterator[Check]:
    ceiling = result.window.shaft if result.has_shaft else result.window.half
    advice = window_advice(result)
    for dof in DOFS:
        f = result.frequency[dof].number
        if ceiling is not None:
            limit = based_on(ceiling.lowest_order * float(mounting.idle_speed) / math.sqrt(2.0), ceiling.lowest_order, mounting.idle_speed)
            yield check(
                f"mounting.separation.{dof}",
                Text("Mode {dof} below what drives it at idle", dof=DOF_WORDS[dof]),
                f,
                "<=",
                limit,
                "Hz",
                ISOLATION,
                advice,
                value_id=f"mounting.frequency.{dof}",
            )
        yield check(
            f"mounting.road.{dof}",
            Text("Mode {dof} above the road's", dof=DOF_WORDS[dof]),
            f,
            ">=",
            mounting.road_frequency,
            "Hz",
            Text("rule of this program: what the ground excites stays below the modes of the engine"),
            value_id=f"mounting.frequency.{dof}",
        )
    for dof in ("roll", "bounce"):
        yield check(
            f"mounting.decoupling.{dof}",
            Text("Energy of the mode {dof} in it", dof=DOF_WORDS[dof]),
            result.energy[dof].number,
            ">=",
            KEPT,
            "%",
            RULE,
            focal_advice(result),
            value_id=f"mounting.energy.{dof}",
        )
    yield check(
        "mounting.roll_axis.decoupling",
        Text("Largest share of a mode in the torque roll axis"),
        result.roll_axis.decoupling,
        ">=",
        KEPT,
        "%",
        RULE,
    )


def window_advice(result: MountingResult) -> Text:
    """By which factor all stiffnesses would do, or why none does."""
    ceiling = result.window.shaft if result.has_shaft else result.window.half
    if ceiling is None:
        return Text("")
    low, high = result.window.lowest_factor, ceiling.highest_factor
    if low <= high:
        return Text("All stiffnesses times {low} to {high} would do.", low=Amount(low, digits=3), high=Amount(high, digits=3))
    ratio, least = Amount(result.window.spread, digits=3), Amount(result.window.spread * math.sqrt(high / low), digits=3)
    return Text(
        "No one factor of all stiffnesses does: the modes lie {ratio} apart and may lie {least} apart; spread the mounts, tilt them, "
        "or change their ratios: `choose FILE mounting` searches.",
        ratio=ratio,
        least=least,
    )


def focal_advice(result: MountingResult) -> Text:
    if result.focal is None or "angle" not in result.focal:
        return Text("`choose FILE mounting` searches for mounts that do.")
    return Text(
        "The front pair leaning inwards by {angle} would turn the engine about its centre of gravity.",
        angle=Amount(math.degrees(result.focal["angle"].number), "°", digits=3),
    )


def critical_checks(mounting: MountingInputs, engine: EngineInputs, result: MountingResult) -> Iterator[Check]:
    """Of operations with hours: how near the next critical speed is, of order 1, of the firing, and of order 2."""
    orders = result.drive.orders
    firing = 2.0 * engine.cylinders / engine.strokes
    from .operations import existing

    there = {float(orders[i]) for i in existing(result.drive, result.levels)}
    wanted = [order for order in dict.fromkeys((1.0, firing, 2.0)) if order in there]
    for name, speed, hours in operating(mounting, engine):
        if not hours or not wanted:
            continue
        rows = [(result.frequency[dof].number / order, dof, order) for dof in DOFS for order in wanted]
        n, dof, order = min(rows, key=lambda row: abs(row[0] / float(speed) - 1))
        yield check(
            f"mounting.critical.{name}",
            Text("Nearest critical speed at {name}: {dof}, order {order}", name=Name(name), dof=DOF_WORDS[dof], order=Amount(order)),
            based_on(abs(n / float(speed) - 1), result.frequency[dof].number, speed),
            ">=",
            APART,
            "%",
            RULE,
            Text("It stands at {n}.", n=Amount(n * 60, "rpm", digits=4)),
            value_id="",
        )
