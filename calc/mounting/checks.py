# SPDX-License-Identifier: Apache-2.0
"""The checks of the mounts: whether they hold, give too much, isolate, keep the modes apart, and what is felt.

In order: what a person has of it, the modes, the mounts."""

import math
from collections.abc import Iterator, Sequence
from itertools import product

import numpy as np

from ..engine.inputs import EngineInputs
from ..sheet.check import Check
from ..sheet.shim_check import check
from ..sheet.text import COMMA, EMPTY, Amount, Name, Text
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
    if result.exposure is None:
        return
    day, limits = result.exposure.get(result.own, {}), table()["exposure"]
    roles = {point.role for point in result.system.mounting.points}
    for id, role, label in (
        ("whole_body", "seat", Text("Daily exposure of the whole body")),
        ("hand_arm", "hand", Text("Daily exposure of hand and arm")),
    ):
        if id not in day and role not in roles:
            continue
        a, value_id = day[id].number if id in day else math.nan, f"mounting.exposure.{result.own}.{id}"
        limit, action = limits[f"{id}_limit"], limits[f"{id}_action"]
        yield check(f"mounting.exposure.{id}", label, a, "<=", limit, "m/s²", DIRECTIVE, value_id=value_id)
        label = Text("{words}, action value", words=label)
        yield check(f"mounting.exposure.{id}_action", label, a, "<=", action, "m/s²", DIRECTIVE, value_id=value_id)


def severity_checks(mounting: MountingInputs, engine: EngineInputs, result: MountingResult) -> Iterator[Check]:
    judged = scope(
        mounting.application, mounting.power or engine.rated_power, engine.rated_speed, mounting.machine_class
    )
    machine = [point.name for point in mounting.points if point.on == "engine" and point.role == "machine"]
    for name, point in product(result.speeds, machine):
        place = f"{name}.{result.own}.{point}"
        value_id, limit = "", 1.0
        if judged.iso_10816 and mounting.machine_class is not None:
            value_id, limit = f"mounting.{place}.grade", zone_limit(mounting.machine_class)
            value = result.leaf(f"{place}.grade")
            source = Text("ISO 10816-6:1995, zone A/B of the class (from memory)")
        elif judged.iso_8528:
            t = table()["generating_set"]
            limits = t["displacement_mm"] * 1e-3, t["velocity_mm_s"] * 1e-3, t["acceleration_m_s2"]
            sizes = [result.leaf(f"{place}.{kind}") for kind in ("displacement", "velocity", "acceleration")]
            shares = [size / limit for size, limit in zip(sizes, limits) if size is not None]
            value = max(shares) if len(shares) == len(sizes) else None
            source = Text("ISO 8528-9:1995 as reprinted by Lloyd's Register: the largest of three over its limit")
        else:
            return
        label = Text("Severity at {point}, {name}", point=Name(point), name=Name(name))
        yield check(
            f"mounting.{name}.{point}.severity", label, _or_nan(value), "<=", limit, "", source, value_id=value_id
        )


def _or_nan(level: float | None) -> float:
    """What is not there, at an undamped resonance, fails."""
    return math.nan if level is None else level


def comfort_checks(mounting: MountingInputs, result: MountingResult) -> Iterator[Check]:
    seats = [point.name for point in mounting.points if point.role == "seat"]
    limit = next(row["above_m_s2"] for row in table()["comfort"] if row["above_m_s2"])
    for name in result.speeds if seats else ():
        levels = [(_or_nan(result.leaf(f"{name}.{result.own}.{seat}.weighted")), seat) for seat in seats]
        a, seat = max(levels, key=lambda row: (math.isnan(row[0]), row[0]))
        label = Text("Weighted acceleration at {seat}, {name}", seat=Name(seat), name=Name(name))
        value_id = f"mounting.{name}.{result.own}.{seat}.weighted"
        yield check(f"mounting.{name}.comfort", label, a, "<=", limit, "m/s²", COMFORT, value_id=value_id)


# --- the modes: below what drives the engine, above the road, apart from each other and from operations

RULE = Text("rule of this program: mounts of a multi-cylinder engine in practice")
ISOLATION = Text("dynamics of vibration isolation: it begins √2 above a mode")
ROAD = Text("rule of this program: what the ground excites stays below the modes of the engine")
KEPT, APART = 0.85, 0.10


def mode_checks(mounting: MountingInputs, result: MountingResult) -> Iterator[Check]:
    ceiling = result.window.shaft if result.has_shaft else result.window.half
    advice = window_advice(result)
    for dof in DOFS:
        f, value_id = result.frequency[dof].number, f"mounting.frequency.{dof}"
        if ceiling is not None:
            limit = based_on(
                ceiling.lowest_order * float(mounting.idle_speed) / math.sqrt(2.0),
                ceiling.lowest_order,
                mounting.idle_speed,
            )
            label = Text("Mode {dof} below what drives it at idle", dof=DOF_WORDS[dof])
            yield check(f"mounting.separation.{dof}", label, f, "<=", limit, "Hz", ISOLATION, advice, value_id=value_id)
        label, limit = Text("Mode {dof} above the road's", dof=DOF_WORDS[dof]), mounting.road_frequency
        yield check(f"mounting.road.{dof}", label, f, ">=", limit, "Hz", ROAD, value_id=value_id)
    advice = focal_advice(result)
    for dof in ("roll", "bounce"):
        label, energy = Text("Energy of the mode {dof} in it", dof=DOF_WORDS[dof]), result.energy[dof].number
        value_id = f"mounting.energy.{dof}"
        yield check(f"mounting.decoupling.{dof}", label, energy, ">=", KEPT, "%", RULE, advice, value_id=value_id)
    label, share = Text("Largest share of a mode in the torque roll axis"), result.roll_axis.decoupling
    yield check("mounting.roll_axis.decoupling", label, share, ">=", KEPT, "%", RULE)


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
        yield check(f"mounting.critical.{name}", label, apart, ">=", APART, "%", RULE, advice, value_id="")


# --- all of the step


def checks(mounting: MountingInputs, engine: EngineInputs, result: MountingResult) -> Iterator[Check]:
    """All of them but that of the estimated inertia."""
    lowest = result.modes["mode_1"].frequency
    label, source = Text("Slowest mode: the mounts hold the engine"), Text("statics: six motions, six springs")
    yield check("mounting.supported", label, lowest, ">", 0.0, "Hz", source)
    yield from _deflection_checks(mounting, result)
    yield from exposure_checks(result)
    yield from mode_checks(mounting, result)
    yield from critical_checks(mounting, engine, result)
    yield from severity_checks(mounting, engine, result)
    yield from comfort_checks(mounting, result)
    source = Text("statics: rubber should not be pulled at rest")
    advice = Text("Move it towards the centre of gravity, or turn it.")
    for mount in mounting.mounts:
        label, load = Text("Weight on the mount {name}", name=Name(mount.name)), result.static[mount.name].load
        yield check(f"mounting.lifted.{mount.name}", label, load, ">=", 0.0, "N", source, advice)
    yield from _range_checks(mounting, result)
    yield from _shaft_checks(result)


def _deflection_checks(mounting: MountingInputs, result: MountingResult) -> Iterator[Check]:
    """At rest, under the mean torque and vibrating, along each own axis: the largest of all operations."""
    v = result.drive.variants.index(result.own)
    source, advice = Text("given in the design: room of the mount"), Text("Stiffen the mount, or give it more room.")
    for j, mount in enumerate(mounting.mounts):
        if mount.deflection_limit is None:
            continue
        swing = peaks(result.levels.deflection[:, v, j])  # (operations, axes)
        standing = np.abs(result.rest.deflection[j]) + np.abs(np.outer(result.output, result.rest.by_torque[j]))
        most = based_on(float((swing + standing).max()), result.levels.source, mount.stiffness)
        label, limit = Text("Largest deflection of the mount {name}", name=Name(mount.name)), mount.deflection_limit
        yield check(f"mounting.{mount.name}.deflection", label, most, "<=", limit, "mm", source, advice)


def _range_checks(mounting: MountingInputs, result: MountingResult) -> Iterator[Check]:
    """Whether the body is still rigid where the strongest order of the seat lies."""
    seat = next((point.name for point in mounting.points if point.role == "seat"), None)
    if seat is None:
        return
    W, a = result.levels.weight[seat], result.levels.acceleration[seat]
    v = result.drive.variants.index(result.own)
    sizes = ((W[:, 0] * np.abs(a[:, v])) ** 2).sum(1)  # (operations, orders)
    if not np.isfinite(sizes).all():
        return
    f = max(float(result.levels.frequency[i, sizes[i].argmax()]) for i in range(len(sizes)))
    label, value = Text("Frequency of the strongest order at the seat"), based_on(f, result.levels.source)
    source = Text("rule of this program: validity of the model, engine and frame bend above it")
    yield check("mounting.rigid_range", label, value, "<=", mounting.rigid_up_to, "Hz", source)


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
    label = Text("Smallest of all felt ratios, half over shaft")
    source = Text("rule of this program: a shaft that is late or too heavy makes it worse")
    yield check("mounting.shaft_helps", label, ratio, ">=", 1.0, "", source, value_id=value_id)


def inertia_check(flips: Sequence[Text]) -> Check:
    advice = Text("These hang on it: {named}. Give inertia_kgm2.", named=COMMA.join(flips)) if flips else EMPTY
    label = Text("Verdicts that turn between half and nine tenths of a full box")
    source = Text("assumed: the inertia is estimated from the overall dimensions")
    return check("mounting.inertia_range", label, float(len(flips)), "<=", 0.0, "", source, advice)
