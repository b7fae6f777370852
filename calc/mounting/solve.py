# SPDX-License-Identifier: Apache-2.0
"""The engine on its mounts: modes, statics, and what is felt at every operation without shafts, with them, and with
some of them off."""

from functools import partial

from ..engine.inputs import EngineInputs
from ..engine.result import EngineResult
from ..imbalance.result import ImbalanceResult
from ..sheet.arrays import Array
from ..sheet.check import Check
from ..sheet.deferred import Later
from ..sheet.linked_array import gathered
from ..sheet.quantity import Stated
from ..sheet.record import replace
from ..sheet.step import Outcome
from ..sheet.text import Text
from ..sheet.value import trace, untraced
from . import body, modal, statics
from .checks import checks, inertia_check
from .curves import curves, tables
from .inputs import MountingInputs
from .levels import levels
from .notes import honest, notes
from .operations import existing, felt_order_1, operations
from .result import MountingResult, Tree, described, with_worst
from .seat_vibration import course_values, courses, critical, crossings, exposure
from .system import system
from .wrenches import EngineWrenches, ShaftOnEngine, drive, operating


def solve(
    mounting: MountingInputs,
    engine: EngineInputs,
    e: EngineResult,
    imbalance: ImbalanceResult,
    shafts: tuple[ShaftOnEngine, ...],
) -> Outcome[MountingResult]:
    """`shafts`: the balance shafts as designed, twins too."""
    with trace() as lines:
        driven = drive(mounting, engine, e, imbalance, shafts)
        result = values(mounting, driven, body.inertia(mounting))
        at_ends = _at_ends(mounting, driven) if mounting.inertia is None else ()
        all_checks = tuple(checks(mounting, engine, result, at_ends))
        if at_ends:
            result, box_check = _over_boxes(mounting, engine, result, at_ends, all_checks)
            all_checks = (*all_checks, box_check)
    return Outcome(
        "mounting",
        result=result,
        checks=all_checks,
        lines=tuple(lines),
        curves=Later(partial(curves, result)),
        tables=Later(partial(tables, mounting, result)),
        notes=Later(lambda: notes(mounting, engine, result)),
        reason=honest(result),
    )


def values(mounting: MountingInputs, driven: EngineWrenches, J: Array) -> MountingResult:
    """Every number of the step, of an engine with this inertia tensor."""
    free = system(mounting, J, frame=False)
    m = modal.matrices(mounting, free, J)
    mode_values = modal.of_modes(m)
    rest = statics.at_rest(mounting, free)
    rows = operating(mounting, driven.engine)
    speeds = gathered(speed for _, speed, _ in rows)
    torque = driven.torque(speeds)
    whole = free if mounting.chassis is None else system(mounting, J)
    lines = levels(whole, driven, speeds, torque)
    frequency, there = modal.frequencies(m, mode_values), existing(driven, lines)
    rows_critical = crossings(mounting, driven, there, frequency)
    over_speed, at_critical = courses(mounting, whole, driven, [n for _, _, n in rows_critical])
    out = statics.output(mounting, driven, speeds)
    result = MountingResult(
        frequency=frequency,
        energy=modal.energies(m),
        modes=mode_values,
        roll_axis=modal.roll_axis(m),
        with_chassis=modal.with_chassis(whole) if mounting.chassis is not None else None,
        static=statics.published(mounting, rest, out),
        window=modal.window(mounting, driven, m, mode_values),
        focal=modal.focal(mounting),
        critical=critical(rows_critical, at_critical),
        operations=operations(driven, lines, whole, rows, torque, there),
        teeth={},
        felt_order_1=felt_order_1(driven),
        range=course_values(over_speed),
        own=driven.own,
        speeds={name: (speed, hours) for name, speed, hours in rows},
        mode_data=m.found,
        stiffness=(m.K, m.M),
        system=whole,
        drive=driven,
        levels=lines,
        rest=rest,
        output=out,
        courses=over_speed,
    )
    return with_worst(replace(result, exposure=exposure(mounting, result)))


def _at_ends(mounting: MountingInputs, driven: EngineWrenches) -> tuple[MountingResult, ...]:
    """The engine as light and as heavy to turn as its box may make it."""
    with untraced():
        return tuple(values(mounting, driven, body.inertia(mounting, share)) for share in (body.LEAST, body.MOST))


def _over_boxes(
    mounting: MountingInputs,
    engine: EngineInputs,
    result: MountingResult,
    at_ends: tuple[MountingResult, ...],
    all_checks: tuple[Check, ...],
) -> tuple[MountingResult, Check]:
    """The result with the range of every frequency, and the check of the verdicts that hang on the estimate of the
    inertia."""
    with untraced():
        kept = [{c.id: c.holds for c in checks(mounting, engine, case)} for case in at_ends]
    lowest = described(Text("Lowest frequency over the range of the inertia"), "Hz")
    highest = described(Text("Highest frequency over the range of the inertia"), "Hz")
    span: Tree = {}
    for dof in body.DOFS:
        ends = [case.frequency[dof].number for case in (result, *at_ends)]
        span[dof] = {"lowest": Stated(lowest, min(ends)), "highest": Stated(highest, max(ends))}
    flips = [c.name for c in all_checks if any(end.get(c.id, c.holds) != c.holds for end in kept)]
    return replace(result, frequency_range=span), inertia_check(flips)
