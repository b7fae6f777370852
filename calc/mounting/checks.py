# SPDX-License-Identifier: Apache-2.0
"""The checks of the mounts: whether they hold, give too much, isolate, keep the modes apart, and what is felt.

In order: what a person has of it, the modes, the mounts."""

import math
from collections.abc import Iterator, Sequence
from itertools import product

import numpy as np

from ..countershaft.inputs import ShaftInputs
from ..countershaft.rows import SHAFT
from ..engine.inputs import EngineInputs
from ..sheet.check import Check, CheckRule, Missing
from ..sheet.quantity import dotted
from ..sheet.record import record
from ..sheet.text import COMMA, EMPTY, Amount, Name, Text
from ..sheet.value import based_on
from .body import BOX, DOFS
from .inputs import DOF_WORDS, MountingInputs
from .levels import peaks
from .operations import existing
from .result import Mode, MountingResult, RollAxis, StaticMount
from .standards import scope, table, zone_limit
from .statics import GRAVITY
from .wrenches import operating

MOUNTS = dotted("mounting", MountingInputs.mounts)
OPERATION = dotted("mounting", MountingInputs.operation)

# --- what is not given


def _not_given(engine: EngineInputs, levels: Sequence[float]) -> Missing | None:
    """Without gas the masses alone shake, and nobody knows by how much more the gas does.

    `levels`: what is judged, of the design, and where its inertia is an estimate at the far ends of that; the
    favourable end is what is taken."""
    keys, taken = [], []
    if engine.gas is None:
        keys.append(dotted("engine", EngineInputs.gas))
        taken.append(Text("the masses alone"))
    if len(levels) > 1:
        keys.append(dotted("mounting", MountingInputs.inertia))
        taken.append(Text("{share} of a full box", share=Amount(BOX)))
    if not keys:
        return None
    worst = max(map(float, levels), key=_resonance_last)
    return Missing(tuple(keys), tuple(taken), float(levels[0]), worst if engine.gas is not None else "none")


def _resonance_last(level: float) -> tuple[bool, float]:
    return math.isnan(level), level


# --- what is felt: the day of a driver, comfort at the seat, severity at the machine

DIRECTIVE = Text("Directive 2002/44/EC; the engine's share only, travel over ground comes on top")
EXPOSED = {"whole_body": Text("Daily exposure of the whole body"), "hand_arm": Text("Daily exposure of hand and arm")}
ROLES = {"whole_body": "seat", "hand_arm": "hand"}
EXPOSURE = {
    part: CheckRule(
        f"mounting.exposure.{part}",
        "limit",
        "The law forbids it: nobody may have more than the limit in a day.",
        label,
        "<=",
        "m/s²",
        DIRECTIVE,
        role="physics",
        demand=True,
        moved_by=(MOUNTS, OPERATION),
    )
    for part, label in EXPOSED.items()
}
ACTION = {
    part: CheckRule(
        f"mounting.exposure.{part}_action",
        "advice",
        "From the action value on the employer has to act.",
        Text("{words}, action value", words=label),
        "<=",
        "m/s²",
        DIRECTIVE,
        cause=EXPOSURE[part].id,
        moved_by=(MOUNTS, OPERATION),
    )
    for part, label in EXPOSED.items()
}
SEVERITY = CheckRule(
    "mounting.N.W.severity",
    "advice",
    "The rigid body is a lower bound, and the classes are from memory.",
    sense="<=",
    cause="mounting.severity",
    moved_by=(MOUNTS,),
)
COMFORT = CheckRule(
    "mounting.N.comfort",
    "advice",
    "Comfort is no matter of strength.",
    sense="<=",
    unit="m/s²",
    source=Text("ISO 2631-1, annex C: not uncomfortable"),
    cause="mounting.comfort",
    moved_by=(MOUNTS, dotted("mounting", MountingInputs.seat_transmissibility)),
)


def exposure_checks(engine: EngineInputs, cases: Sequence[MountingResult]) -> Iterator[Check]:
    result = cases[0]
    if result.exposure is None:
        return
    limits = table()["exposure"]
    roles = {point.role for point in result.system.mounting.points}
    for part, role in ROLES.items():
        if role not in roles:
            continue
        levels = [_exposure(case, part) for case in cases]
        value_id, lack = f"mounting.exposure.{result.own}.{part}", _not_given(engine, levels)
        yield EXPOSURE[part](levels[0], limits[f"{part}_limit"], value_id=value_id, missing=lack)
        yield ACTION[part](levels[0], limits[f"{part}_action"], value_id=value_id)


def _exposure(result: MountingResult, part: str) -> float:
    day = (result.exposure or {}).get(result.own, {})
    return day[part].number if part in day else math.nan


@record
class Severity:
    """What is judged at a point of the engine, as a share of its limit: of the set the worst of displacement, velocity
    and acceleration.  `shown`: what that is and what is allowed."""

    operation: str
    point: str
    value: float
    limit: float
    value_id: str
    source: Text
    shown: tuple[Amount, Amount]


GRADE = Text("ISO 10816-6:1995, zone A/B of the class (from memory)")
OF_SET = Text("ISO 8528-9:1995 as reprinted by Lloyd's Register: the largest of three over its limit")


def severities(mounting: MountingInputs, engine: EngineInputs, result: MountingResult) -> Iterator[Severity]:
    """At each operation and point of the machine; none where no standard judges the engine, or no class is given."""
    judged = scope(
        mounting.application, mounting.power or engine.rated_power, engine.rated_speed, mounting.machine_class
    )
    machine = [point.name for point in mounting.points if point.on == "engine" and point.role == "machine"]
    for name, point in product(result.speeds, machine):
        place = f"{name}.{result.own}.{point}"
        if judged.iso_10816 and mounting.machine_class is not None:
            limit, grade = zone_limit(mounting.machine_class), _or_nan(result.leaf(f"{place}.grade"))
            shown = Amount(grade), Amount(limit)
            yield Severity(name, point, grade, limit, f"mounting.{place}.grade", GRADE, shown)
        elif judged.iso_8528:
            t = table()["generating_set"]
            of_three = [
                (_or_nan(result.leaf(f"{place}.{kind}")) / part, limit, unit)
                for kind, limit, unit, part in (
                    ("displacement", t["displacement_mm"], "mm", 1e-3),
                    ("velocity", t["velocity_mm_s"], "mm/s", 1e-3),
                    ("acceleration", t["acceleration_m_s2"], "m/s²", 1.0),
                )
            ]
            size, limit, unit = max(of_three, key=lambda one: _resonance_last(one[0] / one[1]))
            shown = Amount(size, unit), Amount(limit, unit)
            yield Severity(name, point, size / limit, 1.0, "", OF_SET, shown)


def severity_checks(mounting: MountingInputs, engine: EngineInputs, result: MountingResult) -> Iterator[Check]:
    for one in severities(mounting, engine, result):
        label = Text("Severity at {point}, {name}", point=Name(one.point), name=Name(one.operation))
        at = (one.operation, one.point)
        yield SEVERITY(one.value, one.limit, at=at, name=label, source=one.source, value_id=one.value_id)


def _or_nan(level: float | None) -> float:
    """What is not there, at an undamped resonance, fails."""
    return math.nan if level is None else level


def comfort_checks(mounting: MountingInputs, result: MountingResult) -> Iterator[Check]:
    seats = [point.name for point in mounting.points if point.role == "seat"]
    limit = next(row["above_m_s2"] for row in table()["comfort"] if row["above_m_s2"])
    for name in result.speeds if seats else ():
        levels = [(_or_nan(result.leaf(f"{name}.{result.own}.{seat}.weighted")), seat) for seat in seats]
        a, seat = max(levels, key=lambda row: _resonance_last(row[0]))
        label = Text("Weighted acceleration at {seat}, {name}", seat=Name(seat), name=Name(name))
        value_id = f"mounting.{name}.{result.own}.{seat}.weighted"
        yield COMFORT(a, limit, at=name, name=label, value_id=value_id)


# --- the modes: below what drives the engine, above the road, apart from each other and from operations

RULE = Text("rule of this program: mounts of a multi-cylinder engine in practice")
KEPT, APART = 0.85, 0.10
FREQUENCY_OF_MODE = "mounting.frequency.N"
SEPARATION = CheckRule(
    "mounting.separation.N",
    "advice",
    "A mode near what drives it at idle is felt, and harms nothing.",
    sense="<=",
    unit="Hz",
    source=Text("dynamics of vibration isolation: it begins √2 above a mode"),
    cause="mounting.separation",
    value_id=FREQUENCY_OF_MODE,
    moved_by=(MOUNTS, dotted("mounting", MountingInputs.idle_speed)),
)
ROAD = CheckRule(
    "mounting.road.N",
    "advice",
    "The ground shakes an engine whose modes are as slow.",
    unit="Hz",
    source=Text("rule of this program: what the ground excites stays below the modes of the engine"),
    cause="mounting.road",
    zero="1 Hz",
    value_id=FREQUENCY_OF_MODE,
    moved_by=(MOUNTS, dotted("mounting", MountingInputs.road_frequency)),
)
DECOUPLING = CheckRule(
    "mounting.decoupling.N",
    "advice",
    "Coupled modes spread what drives one of them over all.",
    unit="%",
    source=RULE,
    cause="mounting.decoupling",
    value_id="mounting.energy.N",
    moved_by=(MOUNTS, dotted("mounting", MountingInputs.centre_of_gravity)),
)
ROLL_AXIS = CheckRule(
    dotted("mounting", "roll_axis", RollAxis.decoupling),
    "advice",
    "The firing torque turns the engine about this axis: one mode should take it.",
    Text("Largest share of a mode in the torque roll axis"),
    unit="%",
    source=RULE,
    cause="mounting.decoupling",
    value_id=dotted("mounting", "roll_axis", RollAxis.decoupling),
    moved_by=(MOUNTS, dotted("mounting", MountingInputs.inertia_coupling)),
)
CRITICAL = CheckRule(
    "mounting.critical.N",
    "advice",
    "A speed at which one works should stand apart from the critical ones.",
    unit="%",
    source=RULE,
    moved_by=(MOUNTS, OPERATION),
)


def mode_checks(mounting: MountingInputs, result: MountingResult) -> Iterator[Check]:
    ceiling = result.window.shaft if result.has_shaft else result.window.half
    advice = window_advice(result)
    for dof in DOFS:
        f = result.frequency[dof].number
        if ceiling is not None:
            limit = based_on(
                ceiling.lowest_order * float(mounting.idle_speed) / math.sqrt(2.0),
                ceiling.lowest_order,
                mounting.idle_speed,
            )
            label = Text("Mode {dof} below what drives it at idle", dof=DOF_WORDS[dof])
            yield SEPARATION(f, limit, at=dof, name=label, advice=advice)
        label = Text("Mode {dof} above the road's", dof=DOF_WORDS[dof])
        yield ROAD(f, mounting.road_frequency, at=dof, name=label, scale=1.0)
    advice = focal_advice(result)
    for dof in ("roll", "bounce"):
        label = Text("Energy of the mode {dof} in it", dof=DOF_WORDS[dof])
        yield DECOUPLING(result.energy[dof].number, KEPT, at=dof, name=label, advice=advice)
    yield ROLL_AXIS(result.roll_axis.decoupling, KEPT)


def window_advice(result: MountingResult) -> Text:
    """By which factor all stiffnesses would do, or why none does."""
    ceiling = result.window.shaft if result.has_shaft else result.window.half
    if ceiling is None:
        return EMPTY
    low, high = result.window.lowest_factor, ceiling.highest_factor
    if low <= high:
        return Text(
            "All stiffnesses times {low} to {high} would do.", low=Amount(low, digits=3), high=Amount(high, digits=3)
        )
    spread = result.window.spread
    ratio, least = Amount(spread, digits=3), Amount(spread * math.sqrt(high / low), digits=3)
    return Text(
        "No one factor of all stiffnesses does: the modes lie {ratio} apart and may lie {least} apart; spread the "
        "mounts, tilt them, "
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
    there = {float(orders[i]) for i in existing(result.drive, result.levels)}
    wanted = [order for order in dict.fromkeys((1.0, firing, 2.0)) if order in there]
    for name, speed, hours in operating(mounting, engine):
        if not hours or not wanted:
            continue
        rows = [(result.frequency[dof].number / order, dof, order) for dof in DOFS for order in wanted]
        n, dof, order = min(rows, key=lambda row: abs(row[0] / float(speed) - 1))
        at, mode = Name(name), DOF_WORDS[dof]
        label = Text("Nearest critical speed at {name}: {dof}, order {order}", name=at, dof=mode, order=Amount(order))
        apart = based_on(abs(n / float(speed) - 1), result.frequency[dof].number, speed)
        advice = Text("It stands at {n}.", n=Amount(n * 60, "rpm", digits=4))
        yield CRITICAL(apart, APART, at=name, name=label, advice=advice)


# --- the mounts, and the model

SUPPORTED = CheckRule(
    "mounting.supported",
    "limit",
    "An engine with a motion that no spring holds falls.",
    Text("Slowest mode: the mounts hold the engine"),
    ">",
    "Hz",
    Text("statics: six motions, six springs"),
    role="physics",
    zero="1 Hz",
    value_id=dotted("mounting", "mode_1", Mode.frequency),
    moved_by=(MOUNTS,),
)
DEFLECTION = CheckRule(
    "mounting.N.deflection",
    "limit",
    "The mount strikes its stop, or tears.",
    sense="<=",
    unit="mm",
    source=Text("given in the design: room of the mount"),
    advice=Text("Stiffen the mount, or give it more room."),
    role="chosen",
    demand=True,
    exact=True,
    moved_by=(MOUNTS, dotted("mounting", MountingInputs.mass)),
)
LIFTED = CheckRule(
    "mounting.lifted.N",
    "advice",
    "A mount that is pulled at rest lasts less.",
    unit="N",
    source=Text("statics: rubber should not be pulled at rest"),
    advice=Text("Move it towards the centre of gravity, or turn it."),
    zero="weight over the number of mounts",
    value_id=dotted("mounting", "static", "N", StaticMount.load),
    moved_by=(MOUNTS, dotted("mounting", MountingInputs.centre_of_gravity)),
)
RIGID_RANGE = CheckRule(
    "mounting.rigid_range",
    "method",
    "Above it the model leaves out how engine and frame bend.",
    Text("Frequency of the strongest order at the seat"),
    "<=",
    "Hz",
    Text("rule of this program: validity of the model, engine and frame bend above it"),
    moved_by=(dotted("mounting", MountingInputs.rigid_up_to),),
)
SHAFT_HELPS = CheckRule(
    "mounting.shaft_helps",
    "advice",
    "A shaft that makes it worse somewhere is to be known, and may be right elsewhere.",
    Text("Smallest of all felt ratios, half over shaft"),
    source=Text("rule of this program: a shaft that is late or too heavy makes it worse"),
    moved_by=(dotted(SHAFT, ShaftInputs.masses), MOUNTS),
)
INERTIA_RANGE = CheckRule(
    "mounting.inertia_range",
    "method",
    "Verdicts that hang on an estimate are not known.",
    Text("Verdicts that turn between half and nine tenths of a full box"),
    "<=",
    source=Text("assumed: the inertia is estimated from the overall dimensions"),
    exact=True,
    zero="1",
    moved_by=(dotted("mounting", MountingInputs.inertia), dotted("mounting", MountingInputs.dimensions)),
)


def checks(
    mounting: MountingInputs, engine: EngineInputs, result: MountingResult, at_ends: Sequence[MountingResult] = ()
) -> Iterator[Check]:
    """All of them but that of the estimated inertia.  `at_ends`: the same engine at the far ends of that estimate."""
    cases = (result, *at_ends)
    yield SUPPORTED(result.modes["mode_1"].frequency, 0.0, scale=1.0)
    yield from _deflection_checks(mounting, engine, cases)
    yield from exposure_checks(engine, cases)
    yield from mode_checks(mounting, result)
    yield from critical_checks(mounting, engine, result)
    yield from severity_checks(mounting, engine, result)
    yield from comfort_checks(mounting, result)
    fair_share = mounting.mass * GRAVITY / len(mounting.mounts)
    for mount in mounting.mounts:
        label, load = Text("Weight on the mount {name}", name=Name(mount.name)), result.static[mount.name].load
        yield LIFTED(load, 0.0, at=mount.name, name=label, scale=fair_share)
    yield from _range_checks(mounting, result)
    yield from _shaft_checks(result)


def _deflection_checks(
    mounting: MountingInputs, engine: EngineInputs, cases: Sequence[MountingResult]
) -> Iterator[Check]:
    for j, mount in enumerate(mounting.mounts):
        if mount.deflection_limit is None:
            continue
        levels = [_largest_deflection(case, j) for case in cases]
        most = based_on(levels[0], cases[0].levels.source, mount.stiffness)
        label, lack = Text("Largest deflection of the mount {name}", name=Name(mount.name)), _not_given(engine, levels)
        yield DEFLECTION(most, mount.deflection_limit, at=mount.name, name=label, missing=lack)


def _largest_deflection(result: MountingResult, j: int) -> float:
    """Of mount j, at rest, under the mean torque and vibrating, along each own axis: the largest of all operations."""
    v = result.drive.variants.index(result.own)
    swing = peaks(result.levels.deflection[:, v, j])  # (operations, axes)
    standing = np.abs(result.rest.deflection[j]) + np.abs(np.outer(result.output, result.rest.by_torque[j]))
    return float((swing + standing).max())


def _range_checks(mounting: MountingInputs, result: MountingResult) -> Iterator[Check]:
    """Whether the body is still rigid where the strongest order of the seat lies."""
    if mounting.seat is None:
        return
    W, a = result.levels.weight[mounting.seat.name], result.levels.acceleration[mounting.seat.name]
    v = result.drive.variants.index(result.own)
    sizes = ((W[:, 0] * np.abs(a[:, v])) ** 2).sum(1)  # (operations, orders)
    if not np.isfinite(sizes).all():
        return
    f = max(float(result.levels.frequency[i, sizes[i].argmax()]) for i in range(len(sizes)))
    yield RIGID_RANGE(based_on(f, result.levels.source), mounting.rigid_up_to)


def _shaft_checks(result: MountingResult) -> Iterator[Check]:
    ratios = [
        (number, f"mounting.{name}.{id}")
        for name in result.speeds
        for id in ("felt_seat", "felt_engine", "felt_force")
        if (number := result.leaf(f"{name}.{id}")) is not None
    ]
    if not result.has_shaft or not ratios:
        return
    ratio, value_id = min(ratios)
    yield SHAFT_HELPS(ratio, 1.0, value_id=value_id)


def inertia_check(flips: Sequence[Text]) -> Check:
    advice = Text("These hang on it: {named}. Give inertia_kgm2.", named=COMMA.join(flips)) if flips else EMPTY
    return INERTIA_RANGE(float(len(flips)), 0.0, advice=advice, scale=1.0)
