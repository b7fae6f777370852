# SPDX-License-Identifier: Apache-2.0
"""Tables of the drive over speed, its sentence and its map: what every mesh carries at idle and where the train strikes
hardest, and how good those forces are."""

from collections.abc import Iterator

from ...sheet.quantity import ValueKey
from ...sheet.record import record
from ...sheet.step import Table
from ...sheet.text import EMPTY, Amount, Name, Text, listed
from ...sheet.units import Newton, Number, Watt
from ..result import TrainResult
from .checks import grade_letter, grade_limits, grade_of
from .curves import MM_S, RPM, load_words
from .notes import ACCURACY
from .orders import orders_table
from .result import HARDEST, IDLE, DriveResult, MeshAt, MeshOverSpeed

FLANKS = {0: EMPTY, 1: Text(" on one flank"), 2: Text(" on both flanks")}


def tables(train: TrainResult, drive: DriveResult) -> Iterator[Table]:
    if drive.meshes:
        yield over_speed_table(train, drive)
        yield orders(train, drive)
        yield chain_table()


def over_speed_table(train: TrainResult, drive: DriveResult) -> Table:
    """Every mesh at idle and where a strike has the largest force.  The safeties, by the high and by the low force,
    are the least of both points."""
    rows = []
    for key, mesh in train.meshes.items():
        if (over := mesh.over_speed) is None:
            continue
        for op in (op for op in (IDLE, HARDEST) if op in over.operations):
            at = over.operations[op]
            grade = grade_letter(grade_of(at.impact_speed))
            idle = Text("{pair}, idle: {grade}", pair=mesh.title, grade=grade)
            where = idle if op == IDLE else Text("{pair}, largest force", pair=mesh.title)
            safeties = _safeties(train, key, over) if op == HARDEST else (None, None)
            u, force = at.impact_speed * MM_S, _force(at)
            rows.append((where, u, force, at.impact_power, at.separation, *safeties))
    columns = (
        (Text("mesh, at, grade"), ""),
        (Text("hardest strike"), "mm/s"),
        (Text("force, low to high"), "N"),
        (Text("power, about"), "W"),
        (Text("Γ"), ""),
        (Text("S_H"), ""),
        (Text("S_F"), ""),
    )
    hardest, n = point_words(drive, HARDEST), drive.survey.each_speed.size
    title = Text(
        "Strikes of the flanks at the largest force of the {n} speeds judged ({hardest})", n=n, hardest=hardest
    )
    if IDLE in drive.at:
        title = Text(
            "Strikes of the flanks at idle ({idle}) and at the largest force of the {n} speeds judged ({hardest})",
            idle=point_words(drive, IDLE),
            n=n,
            hardest=hardest,
        )
    return Table("drive_over_speed", title, columns, tuple(rows), ACCURACY, short=True)


def point_words(drive: DriveResult, op: str) -> Text:
    """`900 rpm, no load`."""
    p = drive.at[op]
    n = Amount(float(drive.survey.speeds[p]) * RPM, "rpm", form=".0f")
    return Text("{n}, {load}", n=n, load=load_words(drive.drive.source, float(drive.survey.loads[p])))


def _force(at: MeshAt) -> Text | None:
    if not at.impact_force:
        return None
    return between(at.impact_force_low, at.impact_force)


def between(low: Number, high: Number, unit: str = "", digits: int = 3) -> Text:
    """Of what is known between two estimates: never one number."""
    return Text("{low} to {high}", low=Amount(low, digits=digits), high=Amount(high, unit, digits=digits))


def _safeties(train: TrainResult, key: str, over: MeshOverSpeed) -> tuple[Text | None, Text | None]:
    """Of a mesh against pitting, of its weaker wheel against breakage; under the high and under the low force."""
    mesh = train.meshes[key]
    S_H = (over.strike_safety_contact, over.strike_safety_contact_low)
    struck = [of for name in (mesh.driver, mesh.driven) if (of := train.wheels[name].strikes) is not None]
    S_F = (
        min((S for of in struck if (S := of.strike_safety_bending) is not None), default=None),
        min((S for of in struck if (S := of.strike_safety_bending_low) is not None), default=None),
    )
    high_low = [
        Text("{high} to {low}", high=Amount(high, form=".2f"), low=Amount(low, form=".2f"))
        if high is not None and low is not None
        else None
        for high, low in (S_H, S_F)
    ]
    return high_low[0], high_low[1]


def orders(train: TrainResult, drive: DriveResult) -> Table:
    """Harmonics of the meshes at idle and at rated speed, the firings of an engine that fires evenly beside."""
    engine, motion = drive.drive.work.engine, drive.survey.motion
    alike = round(motion.cycle / motion.period)
    return orders_table(
        train,
        drive.meshes,
        drive.idle_speed,
        engine.rated_speed,
        engine.cylinders if alike == engine.cylinders else None,
        engine.strokes,
    )


# --- how good the forces are

CHAIN: tuple[tuple[Text, str, str, str, str], ...] = (
    (Text("R753IE4, idle, no load"),
     "1765 1765 1765", "2941 3006 2938", "1669–2042, 1625–1869, 1590–1972", "0.93 / 0.11–0.20"),
    (Text("R753IE4, 1500 rpm, full load"),
     "2956 2915 2901", "4760 4861 4755", "2876–3543, 2825–3312, 2769–3510", "3.9 / 0.7–1.0"),
    (Text("R753IE4, rated speed, full load"),
     "2790 2522 2369", "3954 4040 3950", "2329–2783, 2447–2730, 2318–2694", "6.0 / 0.6–0.8"),
    (Text("inline-4, two shafts in a row"), "882 642", "943 1346", "696–790, 665–872", "0.17 / 0.07–0.14"),
    (Text("1.33 and 0.5 kg in a row, Γ 3.1, 0.90"), "718 228", "718 603", "479–572, 274–438", "0.06 / 0.02–0.05"),
    (Text("1.33 and 1.33 kg in a row, Γ 2.0, 1.05"), "907 413", "907 864", "517–745, 455–688", "0.08 / 0.06–0.09"),
    (Text("3, 1.3 and 0.4 kg in a row"),
     "961 666 332", "976 1996 1153", "662–810, 705–1017, 485–717", "0.23 / 0.10–0.18"),
)  # fmt: skip


HELD = Text(
    "Mesh by mesh; the chain is a finer model of our own, with dampings of 0.05 to 0.4 and steps of 4 µs. In 240 "
    "random trains with 618 struck meshes its largest force was, over the low estimate, 0.60 at least, 0.78, 1.18 and "
    "2.8 (5 %, median, 95 %), 11 at most; over the high one 0.16, 0.52, 0.78, 1.18 and 1.87."
)


def chain_table() -> Table:
    """Low and high estimate beside a chain of elastic teeth at three dampings, mesh by mesh."""
    columns = (
        (Text("train"), ""),
        (Text("low"), "N"),
        (Text("high"), "N"),
        (Text("chain of elastic teeth, all dampings"), "N"),
        (Text("power: this program / chain"), "W"),
    )
    rows = tuple((words, *map(Name, cells)) for words, *cells in CHAIN)
    title = Text("How good the forces are: held against a chain of elastic teeth")
    return Table("drive_accuracy", title, columns, rows, HELD)


# --- in one sentence


def sentence(train: TrainResult, *, brief: bool = False) -> Text | None:
    """`Rattle at idle, no load: B, strikes at 58 mm/s on both flanks (A up to 35, B up to 70); teeth then carry some
    1.8 to 3.0 kN`, and on what default it rests; `brief`: without that and what stands in brackets.  None where there
    is no drive."""
    drive = train.drive
    if drive is None or not drive.meshes:
        return None
    if drive.jams:
        return Text("Rattle at idle: not graded, {pairs} jam at mid-tolerance.", pairs=listed(map(Name, drive.jams)))
    if IDLE not in drive.at or drive.grade is None or drive.impact_speed is None:
        return Text("Rattle at idle: not known without brake load; give an operation of the engine without load.")
    A, B = (Amount(u * MM_S, form=".0f") for u in grade_limits())
    idle = [mesh.operations[IDLE] for mesh in drive.meshes.values()]
    hardest = max(idle, key=lambda at: at.impact_speed)
    if not hardest.impact_speed:
        words = Text("Rattle at idle, no load: A, the flanks stay closed.")
    else:
        long = Text(
            "Rattle at idle, no load: {grade}, strikes at {u}{flanks} (A up to {A}, B up to {B}); teeth then carry "
            "some {force}."
        )
        short = Text("Rattle at idle, no load: {grade}, strikes at {u}{flanks}; teeth then carry some {force}.")
        words = Text(
            (short if brief else long).template,
            grade=grade_letter(drive.grade),
            u=Amount(hardest.impact_speed * MM_S, "mm/s", form=".0f"),
            flanks=FLANKS[round(hardest.flanks)],
            A=A,
            B=B,
            force=kilonewtons(max(at.impact_force_low for at in idle), max(at.impact_force for at in idle)),
        )
    if not drive.assumed or brief:
        return words
    return Text(
        "{words} This rests on {taken}, a default that knows no load: give the gas and the inertia of the flywheel.",
        words=words,
        taken=drive.drive.taken,
    )


def kilonewtons(low: Newton, high: Newton) -> Text:
    """With one decimal from 1 kN on, below in N."""
    if high < 1e3:
        return between(low, high, "N", digits=2)
    return Text("{low} to {high}", low=Amount(low / 1e3, form=".1f"), high=Amount(high / 1e3, "kN", form=".1f"))


@record
class Worst:
    """What the train has at one point: its hardest strike, its forces from low to high, the power of all strikes."""

    u: Number
    low: Newton
    high: Newton
    power: Watt


def worst(drive: DriveResult, op: str) -> Worst:
    at = [mesh.operations[op] for mesh in drive.meshes.values()]
    return Worst(
        u=max(of.impact_speed for of in at),
        low=max(of.impact_force_low for of in at),
        high=max(of.impact_force for of in at),
        power=sum(of.impact_power for of in at),
    )


# --- the map, as a file has it

MAP = (
    (MeshAt.separation, 1.0),
    (MeshAt.least_force, 1.0),
    (MeshAt.impact_speed, MM_S),
    (MeshAt.impact_force_low, 1.0),
    (MeshAt.impact_force, 1.0),
    (MeshAt.impact_power, 1.0),
)


def map_rows(drive: DriveResult) -> tuple[tuple[str, ...], list[list[float]]]:
    """Header and rows: every speed with every load, and what each mesh has there."""
    of, line = drive.drive.drawn(), drive.drive.line
    meshes = [i for i, link in enumerate(line.links) if link.toothed]
    names = [_named(field) for field, _ in MAP]
    header = ("speed [rpm]", "load [%]", *(f"{line.links[i].key}.{name}" for i in meshes for name in names))
    hits = of.impacts
    by_name = (of.closed.separation, of.closed.least, hits.speed, hits.low, hits.high, hits.power)
    rows = []
    for p in range(of.speeds.size):
        cells = [float(values[p, i]) * unit for i in meshes for values, (_, unit) in zip(by_name, MAP)]
        rows.append([float(of.speeds[p]) * RPM, 100.0 * float(of.loads[p]), *cells])
    return header, rows


def _named(field: object) -> str:
    """As the values are called, with the unit behind."""
    assert isinstance(field, ValueKey), field
    return f"{field.key} [{field.about.unit}]" if field.about.unit else field.key
