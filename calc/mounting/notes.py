# SPDX-License-Identifier: Apache-2.0
"""What leads every result of the mounts: what the shaft takes and what it leaves; and what all of it rests on."""

import math
from collections.abc import Iterator

import numpy as np

from ..engine.inputs import EngineInputs
from ..sheet.arrays import Array
from ..sheet.text import EMPTY, Amount, Name, Small, Text
from .body import radius_of_gyration
from .checks import EXPOSED, GRADE, OF_SET, severities
from .inputs import MountingInputs
from .levels import NONE_BELOW
from .modal import NOTICED
from .result import MountingResult
from .standards import scope, table
from .statics import preload
from .wrenches import ShaftOnEngine


def honest(result: MountingResult) -> Text:
    """What the shaft takes and what it leaves, in a sentence with its numbers."""
    if not result.has_shaft:
        orders, sizes = result.drive.orders, _strengths(result)
        counted = [Text("{n}", n=Amount(float(n))) for n, size in zip(orders, sizes) if size > NOTICED * sizes.max()]
        return Text(
            "No shaft: with half on the crank the orders {orders} drive the engine, the strongest at {operation} is "
            "{strongest}.",
            orders=Text(", ").join(counted),
            operation=Name(next(iter(result.speeds))),
            strongest=Amount(float(orders[sizes.argmax()])),
        )
    return Text("{takes} {leaves}{felt}", takes=_takes(result), leaves=_leaves(result), felt=_felt(result))


def _takes(result: MountingResult) -> Text:
    n = Text(" and ").join([Text("{n}", n=Amount(n)) for n in result.drive.taken])
    if len(result.drive.taken) > 1:
        return Text("The shafts take what the masses have of orders {n} and nothing else:", n=n)
    if len(result.drive.shafts) > 1:
        return Text("The shafts take what the masses have of order {n} and nothing else:", n=n)
    if result.felt_order_1 is not None:
        return Text("The shaft takes the rocking couple of order {n} and nothing else:", n=n)
    return Text("The shaft takes what the masses have of order {n} and nothing else:", n=n)


def _leaves(result: MountingResult) -> Text:
    """The firing torque, and of the masses the strongest other order."""
    e = result.drive.engine
    firing = 2.0 * e.cylinders / e.strokes
    taken, masses = result.drive.taken, _strengths(result, of_masses=True)
    others = [
        (size, n)
        for size, n in zip(masses.tolist(), result.drive.orders.tolist())
        if n not in (*taken, firing) and size > NOTICED * masses.max()
    ]
    gas, strongest = result.drive.nodes is not None, Amount(max(others)[1]) if others else None
    if strongest is None:
        stays = Text("the firing torque of order {firing}, which one feels at idle, stays.", firing=Amount(firing))
        return stays if gas else Text("the gas is not given.")
    if not gas:
        return Text("order {n} stays, and the gas is not given.", n=strongest)
    return Text(
        "the firing torque of order {firing}, which one feels at idle, and order {n} stay.",
        firing=Amount(firing),
        n=strongest,
    )


def _felt(result: MountingResult) -> Text:
    """Of the foremost seat at the first and at the last operation; without one, of the forces in the mounts."""
    seat = result.system.mounting.seat
    first, last = next(iter(result.speeds)), list(result.speeds)[-1]
    place, unit = (f"{seat.name}.weighted", "m/s²") if seat is not None else ("force_sum", "N")
    a, b, c, d = (result.leaf(f"{name}.{variant}.{place}") for name in (first, last) for variant in ("half", "shaft"))
    if a is None or b is None or c is None or d is None:
        return EMPTY
    return Text(
        "{where} {a} → {b} {unit} at {first}, {c} → {d} at {last}.{worse}",
        where=Text(" At the seat") if seat is not None else Text(" In the mounts"),
        a=Amount(a, digits=3),
        b=Amount(b, digits=3),
        unit=unit,
        first=Name(first),
        c=Amount(c, digits=3),
        d=Amount(d, digits=3),
        last=Name(last),
        worse=_worse_here(result) if b > a or d > c else EMPTY,
    )


def _worse_here(result: MountingResult) -> Text:
    one = len(result.drive.shafts) == 1
    return Text(" Here the shaft makes it worse.") if one else Text(" Here the shafts make it worse.")


def _strengths(result: MountingResult, operation: int = 0, *, of_masses: bool = False) -> Array:
    """At an operation by its place, the first unless said."""
    M = result.stiffness[1]
    wrench = None if of_masses else np.asarray(result.levels.wrench)[operation]
    return result.drive.strengths(wrench, radius_of_gyration(float(M[0, 0]), M[3:, 3:]))


def loads(mounting: MountingInputs, engine: EngineInputs, result: MountingResult) -> Iterator[Text]:
    """What a person decides by: what drives the engine where its mounts pass on most, and what that comes to, at the
    machine by what severity is judged by, at the foremost seat, and over a day."""
    names = list(result.speeds)
    name = max(names, key=lambda name: result.leaf(f"{name}.{result.own}.force_sum") or math.inf)
    order = result.drive.orders[_strengths(result, names.index(name)).argmax()]
    passed_on = result.leaf(f"{name}.{result.own}.force_sum")
    speed = Amount(float(result.speeds[name][0]) * 60, "rpm")
    yield Text(
        "at {name}, {speed}, order {order} drives most; the mounts pass on {force}, rms",
        name=Name(name),
        speed=speed,
        order=Amount(float(order)),
        force=Amount(math.nan if passed_on is None else passed_on, "N"),
    )
    if found := [*severities(mounting, engine, result)]:
        worst = max(found, key=lambda one: math.inf if math.isnan(one.value) else one.value)
        yield Text(
            "severity at {point}, {name}: {value}, at most {limit} ({source})",
            point=Name(worst.point),
            name=Name(worst.operation),
            value=worst.shown[0],
            limit=worst.shown[1],
            source=STANDARDS[worst.source],
        )
    if (seat := mounting.seat) is not None:
        felt = {name: result.leaf(f"{name}.{result.own}.{seat.name}.weighted") for name in names}
        name = max(names, key=lambda name: felt[name] or 0.0)
        if (a := felt[name]) is not None:
            yield Text("at {seat}, {name}: {value}, weighted", seat=Name(seat.name), name=Name(name), value=_a(a))
    for part, words in EXPOSED.items():
        if (day := ((result.exposure or {}).get(result.own) or {}).get(part)) is not None:
            limit = table()["exposure"][f"{part}_limit"]
            yield Text("{words} {value}, at most {limit}", words=Small(words), value=_a(day.number), limit=_a(limit))


STANDARDS = {GRADE: Text("ISO 10816-6"), OF_SET: Text("ISO 8528-9")}


def _a(acceleration: float) -> Amount:
    return Amount(acceleration, "m/s²")


def notes(mounting: MountingInputs, engine: EngineInputs, result: MountingResult) -> Iterator[Text]:
    """The scope of the standards first."""
    yield from scope(
        mounting.application, mounting.power or engine.rated_power, engine.rated_speed, mounting.machine_class
    ).sentences
    yield Text("The daily exposure is the engine's share only: travel over ground dominates the true one.")
    yield from _worse(result)
    yield from _worst_tooth(result)
    yield from _assumed(mounting, engine, result)
    yield Text(
        "Not counted: valve gear, fan, fuel pump, the couple of the rods, whip of the crank, the gyroscopic couple "
        "(about 2 % at order 1), start and stop, which sweep through the modes."
    )
    yield Text(
        "The engine is a rigid body, rubber is linear: its stiffness does not fall with amplitude (Payne effect), and "
        "what the weight itself adds to the stiffness, {share} of that against tilting, is left out.",
        share=Amount(100 * preload(mounting, result.stiffness[0]), "%", digits=2),
    )


def _worse(result: MountingResult) -> Iterator[Text]:
    """A shaft that is late, or mistuned, and makes it worse: in the mounts, or where it is felt."""
    subjects = VARIANTS if len(result.drive.shafts) == 1 else SEVERAL
    for name, (speed, _) in result.speeds.items():
        rpm = Amount(speed * 60, "rpm")
        for id, place in (("felt_seat", Text("at the seat")), ("felt_engine", Text("at the engine"))):
            ratio = result.leaf(f"{name}.{id}")
            if ratio is not None and ratio < 1 - NONE_BELOW:
                yield Text(
                    "{words} makes it worse {place} at {name}, {speed}: half over shaft is {ratio}.",
                    words=subjects["shaft"],
                    place=place,
                    name=Name(name),
                    speed=rpm,
                    ratio=Amount(ratio, digits=3),
                )
        for variant, words in subjects.items():
            half, with_it = (result.leaf(f"{name}.{which}.force_sum") for which in ("half", variant))
            if half is not None and with_it is not None and with_it > half * (1 + NONE_BELOW):
                yield Text(
                    "{words} makes it worse at {name}, {speed}: the forces in the mounts rise from {half} to "
                    "{with_it}.",
                    words=words,
                    name=Name(name),
                    speed=rpm,
                    half=Amount(half, "N", digits=3),
                    with_it=Amount(with_it, "N", digits=3),
                )


VARIANTS = {
    "shaft": Text("The shaft"),
    "scatter": Text("The shaft as it scatters"),
    "tooth": Text("The shaft one tooth late"),
}
SEVERAL = {
    "shaft": Text("The set of shafts"),
    "scatter": Text("The set of shafts as it scatters"),
    "tooth": Text("The set of shafts one tooth off, at its worst,"),
}


def _worst_tooth(result: MountingResult) -> Iterator[Text]:
    """Which of the shafts one tooth off, and in which sense, is felt most: at the foremost seat, without one in the
    mounts."""
    seat = result.system.mounting.seat
    for name, rows in result.teeth.items():
        felt = {row: tree[seat.name].weighted if seat else tree["force_sum"].number for row, tree in rows.items()}
        if None not in felt.values():
            yield Text(
                "One tooth off, at {name} the worst {where} is: {row}.",
                name=Name(name),
                where=Text("at the seat") if seat else Text("in the mounts"),
                row=result.drive.off[max(felt, key=lambda row: felt[row] or 0.0)].words,
            )


def _assumed(mounting: MountingInputs, engine: EngineInputs, result: MountingResult) -> Iterator[Text]:
    yield from _of_gas(engine, result)
    if mounting.inertia is None:
        yield Text(
            "The inertia is that of {share} of a full box of the overall dimensions: own assumption, 50 to 90 % are "
            "shown as well.",
            share=Amount(70, "%"),
        )
    if mounting.cylinder_spread is not None and len(mounting.cylinder_spread) == 1 and engine.cylinders > 1:
        yield Text(
            "The spread of the cylinders is drawn once: evenly spaced quantiles of a normal distribution, in firing "
            "order."
        )
    for shaft in result.drive.shafts:
        if shaft.mirrors is None:
            yield from _of_shaft(mounting, shaft)
    yield from _of_mounts(mounting)
    yield from _of_modes(mounting, result)
    yield Text(
        "From memory: the grades of severity (medium confidence) and their classes (low), the perception and comfort "
        "of ISO 2631-1 (high)."
    )


def _of_gas(engine: EngineInputs, result: MountingResult) -> Iterator[Text]:
    """At which speeds it is known."""
    nodes = result.drive.nodes
    if nodes is None:
        yield Text("Without the gas only the masses drive the engine: the strongest excitation at idle is missing.")
        return
    outside = [Name(name) for name, (speed, _) in result.speeds.items() if nodes.outside(speed)]
    if outside:
        yield Text(
            "Outside of the speeds whose gas is given the nearest of them holds: {names}.",
            names=Text(", ").join(outside),
        )
    if engine.gas is not None and engine.gas.pressure:
        yield Text("The table of pressures holds at every speed.")


def _of_shaft(mounting: MountingInputs, shaft: ShaftOnEngine) -> Iterator[Text]:
    """Where its force acts, and how it scatters."""
    if shaft.axis is None and abs(shaft.force) > 0:
        yield Text(
            "The axis of the counter-shaft is not given: its force is taken to act at the crank, and rolls nothing."
        )
    if shaft.errors is None:
        yield Text("How the shaft scatters is not known: give by how much it is late and the error of its couple.")
    elif mounting.late is None and mounting.scatter_couple is None:
        yield Text("The shaft as it scatters: 95 % of its errors, as given, and the free turn of the train.")


def _of_mounts(mounting: MountingInputs) -> Iterator[Text]:
    """What they stand on, and their rubber."""
    if any(mount.mobility for mount in mounting.mounts):
        yield Text(
            "Each foot moves by its own mobility; what one foot does to another is not counted. The modes are those "
            "on rigid ground."
        )
    if any(mount.dynamic_ratio < 1 for mount in mounting.mounts):
        yield Text("A dynamic ratio below 1 is unusual: rubber is stiffer when it vibrates.")
    if all(mount.loss_factor is None and mount.damping is None for mount in mounting.mounts):
        yield Text("A loss factor of 0.1 taken for the mounts, since none is given.")


def _of_modes(mounting: MountingInputs, result: MountingResult) -> Iterator[Text]:
    """Up to which frequency a rigid body has them, and whether they are what their names say."""
    if any(frequency > mounting.rigid_up_to for frequency in result.levels.frequency.ravel()):
        yield Text(
            "Orders above {limit} are computed, and shown, but engine and frame bend there.",
            limit=Amount(mounting.rigid_up_to, "Hz"),
        )
    words = [result.mode_data.words(i) for i in range(6)]
    mixed = [mode for mode in words if mode.template.startswith("mixed")]
    if mixed:
        yield Text("Modes that are hardly what their name says: {mixed}.", mixed=Text("; ").join(mixed))
