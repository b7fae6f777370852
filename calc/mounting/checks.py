# SPDX-License-Identifier: Apache-2.0
"""The checks of the mounts: whether they hold, give too much, isolate, keep the modes apart, and what is felt.

In order: what a person has of it, the modes, the mounts."""

import math
from collections.abc import Iterator, Sequence

import numpy as np

from ..engine.inputs import EngineInputs
from ..sheet.check import Check, check
from ..sheet.text import COMMA, Amount, Name, Text
from ..sheet.value import based_on
from .body import DOFS
from .inputs import DOF_WORDS, MountingInputs
from .levels import peaks
from .operations import existing
from .result import MountingResult
from .standards import scope, table, zone_limit
from .wrenches import operating

# --- what is felt: the day of a driver, comfort at the seat, severity at the machine

DIRECTIVE = Text("Directive 2002/44/EC; the engine's share only, travel over ground comes on top")
COMFORT = Text("ISO 2631-1, annex C: not uncomfortable")


def exposure_checks(result: MountingResult) -> Iterator[Check]:
    day = (result.exposure or {}).get(result.own, {})
    limits = table()["exposure"]
    for id, label in (
        ("whole_body", Text("Daily exposure of the whole body")),
        ("hand_arm", Text("Daily exposure of hand and arm")),
    ):
        if result.exposure is None or (id not in day and not _asked(result, id)):
            continue
        a = day[id].number if id in day else math.nan
        value_id = f"mounting.exposure.{result.own}.{id}"
        yield check(
            f"mounting.exposure.{id}", label, a, "<=", limits[f"{id}_limit"], "m/s²", DIRECTIVE, value_id=value_id
        )
        yield check(
            f"mounting.exposure.{id}_action",
            Text("{words}, action value", words=label),
            a,
            "<=",
            limits[f"{id}_action"],
            "m/s²",
            DIRECTIVE,
            value_id=value_id,
        )


def _asked(result: MountingResult, id: str) -> bool:
    role = "seat" if id == "whole_body" else "hand"
    return any(point.role == role for point in result.system.mounting.points)


def severity_checks(mounting: MountingInputs, engine: EngineInputs, result: MountingResult) -> Iterator[Check]:
    judged = scope(
        mounting.application, mounting.power or engine.rated_power, engine.rated_speed, mounting.machine_class
    )
    machine = [point.name for point in mounting.points if point.on == "engine" and point.role == "machine"]
    for name in result.speeds:
        for point in machine:
            label = Text("Severity at {point}, {name}", point=Name(point), name=Name(name))
            place = f"{name}.{result.own}.{point}"
            if judged.iso_10816 and mounting.machine_class is not None:
                grade = result.leaf(f"{place}.grade")
                yield check(
                    f"mounting.{name}.{point}.severity",
                    label,
                    math.nan if grade is None else grade,
                    "<=",
                    zone_limit(mounting.machine_class),
                    "",
                    Text("ISO 10816-6:1995, zone A/B of the class (from memory)"),
                    value_id=f"mounting.{place}.grade",
                )
            elif judged.iso_8528:
                t = table()["generating_set"]
                sizes = [
                    (result.leaf(f"{place}.{kind}"), limit)
                    for kind, limit in (
                        ("displacement", t["displacement_mm"] * 1e-3),
                        ("velocity", t["velocity_mm_s"] * 1e-3),
                        ("acceleration", t["acceleration_m_s2"]),
                    )
                ]
                worst = max((x / limit for x, limit in sizes if x is not None), default=math.nan)
                yield check(
                    f"mounting.{name}.{point}.severity",
                    label,
                    worst if all(x is not None for x, _ in sizes) else math.nan,
                    "<=",
                    1.0,
                    "",
                    Text("ISO 8528-9:1995 as reprinted by Lloyd's Register: the largest of three over its limit"),
                    value_id="",
                )


def comfort_checks(mounting: MountingInputs, result: MountingResult) -> Iterator[Check]:
    seats = [point.name for point in mounting.points if point.role == "seat"]
    limit = next(row["above_m_s2"] for row in table()["comfort"] if row["above_m_s2"])
    for name in result.speeds if seats else ():
        levels = [(result.leaf(f"{name}.{result.own}.{seat}.weighted"), seat) for seat in seats]
        a, seat = max(
            ((math.nan if a is None else a, seat) for a, seat in levels), key=lambda row: (row[0] != row[0], row[0])
        )
        yield check(
            f"mounting.{name}.comfort",
            Text("Weighted acceleration at {seat}, {name}", seat=Name(seat), name=Name(name)),
            a,
            "<=",
            limit,
            "m/s²",
            COMFORT,
            value_id=f"mounting.{name}.{result.own}.{seat}.weighted",
        )


# --- the modes: below what drives the engine, above the road, apart from each other and from operations

RULE = Text("rule of this program: mounts of a multi-cylinder engine in practice")
ISOLATION = Text("dynamics of vibration isolation: it begins √2 above a mode")
KEPT, APART = 0.85, 0.10


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
        return Text(
            "All stiffnesses times {low} to {high} would do.", low=Amount(low, digits=3), high=Amount(high, digits=3)
        )
    ratio, least = (
        Amount(result.window.spread, digits=3),
        Amount(result.window.spread * math.sqrt(high / low), digits=3),
    )
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
        yield check(
            f"mounting.critical.{name}",
            Text(
                "Nearest critical speed at {name}: {dof}, order {order}",
                name=Name(name),
                dof=DOF_WORDS[dof],
                order=Amount(order),
            ),
            based_on(abs(n / float(speed) - 1), result.frequency[dof].number, speed),
            ">=",
            APART,
            "%",
            RULE,
            Text("It stands at {n}.", n=Amount(n * 60, "rpm", digits=4)),
            value_id="",
        )


# --- all of the step


def checks(mounting: MountingInputs, engine: EngineInputs, result: MountingResult) -> Iterator[Check]:
    """All of them but that of the estimated inertia."""
    lowest = result.modes["mode_1"].frequency
    yield check(
        "mounting.supported",
        Text("Slowest mode: the mounts hold the engine"),
        lowest,
        ">",
        0.0,
        "Hz",
        Text("statics: six motions, six springs"),
    )
    yield from _deflection_checks(mounting, result)
    yield from exposure_checks(result)
    yield from mode_checks(mounting, result)
    yield from critical_checks(mounting, engine, result)
    yield from severity_checks(mounting, engine, result)
    yield from comfort_checks(mounting, result)
    for mount in mounting.mounts:
        yield check(
            f"mounting.lifted.{mount.name}",
            Text("Weight on the mount {name}", name=Name(mount.name)),
            result.static[mount.name].load,
            ">=",
            0.0,
            "N",
            Text("statics: rubber should not be pulled at rest"),
            Text("Move it towards the centre of gravity, or turn it."),
        )
    if (range_check := _range_check(mounting, result)) is not None:
        yield range_check
    if (shaft_check := _shaft_check(result)) is not None:
        yield shaft_check


def _deflection_checks(mounting: MountingInputs, result: MountingResult) -> Iterator[Check]:
    """At rest, under the mean torque and vibrating, along each own axis: the largest of all operations."""
    v = result.drive.variants.index(result.own)
    for j, mount in enumerate(mounting.mounts):
        if mount.deflection_limit is None:
            continue
        swing = peaks(result.levels.deflection[:, v, j])  # (operations, axes)
        standing = np.abs(result.rest.deflection[j]) + np.abs(np.outer(result.output, result.rest.by_torque[j]))
        most = float((swing + standing).max())
        yield check(
            f"mounting.{mount.name}.deflection",
            Text("Largest deflection of the mount {name}", name=Name(mount.name)),
            based_on(most, result.levels.source, mount.stiffness),
            "<=",
            mount.deflection_limit,
            "mm",
            Text("given in the design: room of the mount"),
            Text("Stiffen the mount, or give it more room."),
        )


def _range_check(mounting: MountingInputs, result: MountingResult) -> Check | None:
    """Whether the body is still rigid where the strongest order of the seat lies."""
    seat = next((point.name for point in mounting.points if point.role == "seat"), None)
    if seat is None:
        return None
    W, a = result.levels.weight[seat], result.levels.acceleration[seat]
    v = result.drive.variants.index(result.own)
    sizes = ((W[:, 0] * np.abs(a[:, v])) ** 2).sum(1)  # (operations, orders)
    if not np.isfinite(sizes).all():
        return None
    f = max(float(result.levels.frequency[i, sizes[i].argmax()]) for i in range(len(sizes)))
    return check(
        "mounting.rigid_range",
        Text("Frequency of the strongest order at the seat"),
        based_on(f, result.levels.source),
        "<=",
        mounting.rigid_up_to,
        "Hz",
        Text("rule of this program: validity of the model, engine and frame bend above it"),
    )


def _shaft_check(result: MountingResult) -> Check | None:
    if not result.has_shaft:
        return None
    ratios = [
        (number, f"mounting.{name}.{id}")
        for name in result.speeds
        for id in ("felt_seat", "felt_engine", "felt_force")
        if (number := result.leaf(f"{name}.{id}")) is not None
    ]
    if not ratios:
        return None
    ratio, value_id = min(ratios)
    return check(
        "mounting.shaft_helps",
        Text("Smallest of all felt ratios, half over shaft"),
        ratio,
        ">=",
        1.0,
        "",
        Text("rule of this program: a shaft that is late or too heavy makes it worse"),
        value_id=value_id,
    )


def inertia_check(flips: Sequence[Text]) -> Check:
    named = COMMA.join(flips)
    advice = Text("These hang on it: {named}. Give inertia_kgm2.", named=named) if flips else Text("")
    return check(
        "mounting.inertia_range",
        Text("Verdicts that turn between half and nine tenths of a full box"),
        float(len(flips)),
        "<=",
        0.0,
        "",
        Text("assumed: the inertia is estimated from the overall dimensions"),
        advice,
    )
