# SPDX-License-Identifier: Apache-2.0
"""What is judged of the drive over speed: whether it rattles at idle, what strikes do to the teeth, whether the nominal
backlash has room between jam and rattle, and how far the method holds.

What holds with a default irregularity passes as assumed, what does not is not verified: nothing fails by a default."""

from collections.abc import Callable, Iterator, Mapping

from ...engine.inputs import EngineInputs
from ...library.table_file import house_table
from ...sheet.check import Check, CheckRule, Missing
from ...sheet.deferred import Later
from ...sheet.quantity import dotted
from ...sheet.remedy import Remedy
from ...sheet.text import Amount, Text
from ...sheet.units import Metre, MetrePerSecond, Number
from ..inputs import GearsInputs, Mesh
from ..rating.checks import MINIMUM_F, MINIMUM_H
from ..rating.mesh_strength import S_F_LEAST, S_H_LEAST
from ..wheel_inputs import Wheel
from .inputs import DriveInputs
from .result import IDLE, DriveResult, MeshAt, MeshOverSpeed, WheelStruck

YARDSTICK = Text(
    "rule of this program: A up to {a}, B up to {b}, from the backlash that makers print for balance shafts",
    a=Amount(house_table("rattle.toml")["grade"]["A"], "mm/s"),
    b=Amount(house_table("rattle.toml")["grade"]["B"], "mm/s"),
)
STRIKE = Text("rule of this program: strikes without rebound, between a soft and a stiff estimate of their force")
HIGHEST_IRREGULARITY = 0.15
FLYWHEEL = dotted("engine", EngineInputs.flywheel_inertia)
GAS = dotted("engine", EngineInputs.gas)
DISTANCE = dotted("gears", GearsInputs.meshes, "#", Mesh.centre_distance)
SCISSOR = dotted("gears", GearsInputs.meshes, "#", Mesh.scissor)
DRIVEN_FROM = dotted("gears", GearsInputs.drive, DriveInputs.driven_from)
FACE = dotted("gears", GearsInputs.face_width)
CLASS = dotted("gears", GearsInputs.wheels, "W", Wheel.gear_material)
ALLOWANCES = (
    dotted("gears", GearsInputs.wheels, "DRIVER", Wheel.span_allowance),
    dotted("gears", GearsInputs.wheels, "DRIVEN", Wheel.span_allowance),
)
MOVES = (FLYWHEEL, DISTANCE, *ALLOWANCES, SCISSOR, DRIVEN_FROM)


def grade_limits() -> tuple[MetrePerSecond, MetrePerSecond]:
    """The hardest strikes of grade A and of grade B at idle without load."""
    of = house_table("rattle.toml")["grade"]
    return of["A"] * 1e-3, of["B"] * 1e-3


def grade_of(u: MetrePerSecond) -> int:
    """1: A, 2: B, 3: C."""
    return 1 + sum(u > limit for limit in grade_limits())


def grade_letter(grade: Number) -> str:
    return "ABC"[round(grade) - 1]


RATTLE = CheckRule(
    "gears.M.rattle",
    "caution",
    "The flanks strike harder at idle than those of nearly every maker.",
    sense="<=",
    unit="mm/s",
    source=YARDSTICK,
    cause="gears.rattle",
    value_id=dotted("gears", "drive", DriveResult.impact_speed),
    moved_by=MOVES,
    short=Text("rattle"),
)
RATTLE_MOST = CheckRule(
    "gears.M.rattle_most",
    "advice",
    "An engine at the end of its tolerances rattles.",
    sense="<=",
    unit="mm/s",
    source=YARDSTICK,
    cause=RATTLE.cause,
    moved_by=MOVES,
)
STRIKE_CONTACT = CheckRule(
    "gears.M.strike_contact",
    "limit",
    "The flanks pit under their own strikes, even where these are reckoned soft.",
    source=Text("{strike}; {minimum}", strike=STRIKE, minimum=MINIMUM_H),
    role="physics",
    demand=True,
    cause="gears.strikes",
    value_id=dotted("gears", "M", MeshOverSpeed.strike_safety_contact_low),
    moved_by=(FLYWHEEL, DISTANCE, *ALLOWANCES, FACE),
)
STRIKE_CONTACT_MOST = CheckRule(
    "gears.M.strike_contact_most",
    "caution",
    "The truth lies between the soft and the stiff estimate.",
    source=STRIKE_CONTACT.source,
    demand=True,
    cause=STRIKE_CONTACT.cause,
    value_id=dotted("gears", "M", MeshOverSpeed.strike_safety_contact_most),
    moved_by=STRIKE_CONTACT.moved_by,
)
STRIKE_BENDING = CheckRule(
    "gears.W.strike_bending",
    "limit",
    "The teeth break under their own strikes, even where these are reckoned soft.",
    source=Text("{strike}; {minimum}", strike=STRIKE, minimum=MINIMUM_F),
    role="physics",
    demand=True,
    cause=STRIKE_CONTACT.cause,
    value_id=dotted("gears", "W", WheelStruck.strike_safety_bending_low),
    moved_by=(FLYWHEEL, FACE, CLASS),
)
STRIKE_BENDING_MOST = CheckRule(
    "gears.W.strike_bending_most",
    "caution",
    "The truth lies between the soft and the stiff estimate.",
    source=STRIKE_BENDING.source,
    demand=True,
    cause=STRIKE_BENDING.cause,
    value_id=dotted("gears", "W", WheelStruck.strike_safety_bending_most),
    moved_by=STRIKE_BENDING.moved_by,
)
BACKLASH_WINDOW = CheckRule(
    "gears.drive.backlash_window",
    "caution",
    "No nominal backlash both keeps the wheels from jamming and keeps them quiet.",
    sense="<=",
    unit="µm",
    source=Text("rule of this program: from below what tolerance, runout and temperature take, from above grade B"),
    value_id=dotted("gears", "drive", DriveResult.window_low),
    limit_id=dotted("gears", "drive", DriveResult.window_high),
)
IRREGULARITY_HIGH = CheckRule(
    "gears.drive.irregularity_high",
    "method",
    "Beyond it the motion is not the linear one that is reckoned with.",
    Text("Irregularity of the crank at idle"),
    "<=",
    "%",
    Text("rule of this program: the relative error of the acceleration is about the irregularity"),
    moved_by=(FLYWHEEL,),
)
REBOUND = CheckRule(
    "gears.drive.rebound",
    "method",
    "With more backlash than swing a strike that rebounds may be up to twice as hard.",
    Text("Backlash of a way over half the swing of the driver"),
    "<=",
    "",
    Text("rule of this program: own survey of 80 random trains with and without rebound"),
    moved_by=(FLYWHEEL,),
)
ASSUMED = CheckRule(
    "gears.drive.assumed",
    "method",
    "A default decides how hard the flanks strike.",
    Text("A default stands for the motion of the crank: 1 yes, 0 no"),
    "<=",
    source=Text("rule of this program: an irregularity by the number of cylinders, of one order and no load"),
    advice=Text(
        "Give the gas (peak pressure, compression ratio) and the inertia of the flywheel; or the irregularity as "
        "measured."
    ),
    zero="1, no number",
    value_id=dotted("gears", "drive", DriveResult.assumed),
    moved_by=(GAS, FLYWHEEL),
)
GIVE = GAS, FLYWHEEL


def lack(assumed: Number, taken: Text, worst: Number | None) -> Missing | None:
    """What is not given where a default stands for the motion of the crank: at its worst it is as taken."""
    return Missing(GIVE, (taken,), "holds", "none" if worst is None else worst) if assumed else None


def rattle_checks(
    drive: DriveResult,
    idle: Mapping[str, MeshAt],
    titles: Mapping[str, str],
    taken: Text,
    index: Mapping[str, int],
    for_b: Later[Remedy],
    for_a: Later[Remedy],
) -> Iterator[Check]:
    """Of the mesh that strikes hardest at idle without load, at mid-tolerance and at its largest backlash; with what
    brings it to grade B, and to A with B at the largest backlash."""
    quiet, loud = grade_limits()
    key = max(idle, key=lambda mesh: idle[mesh].impact_speed)
    u, name = idle[key].impact_speed, Text("Strikes of {pair} at idle, no load", pair=titles[key])
    missing = lack(drive.assumed, taken, u)
    for_grade = Text("{name}, for grade B", name=name)
    yield RATTLE(u, loud, at=key, name=for_grade, missing=missing, index=index[key], remedies=for_b)
    key = max(idle, key=lambda mesh: idle[mesh].impact_speed_most)
    most, of = idle[key].impact_speed_most, Text("Strikes of {pair} at idle, largest backlash", pair=titles[key])
    if u / quiet > most / loud:
        yield RATTLE_MOST(
            u, quiet, at=key, name=Text("{name}, for grade A", name=name), index=index[key], remedies=for_a
        )
    else:
        yield RATTLE_MOST(most, loud, at=key, name=of, index=index[key], remedies=for_a)


def strength_checks(
    drive: DriveResult,
    meshes: Mapping[str, MeshOverSpeed],
    wheels: Mapping[str, WheelStruck],
    titles: Mapping[str, str],
    taken: Text,
    index: Mapping[str, int],
    stronger: Callable[[str, str], Later[Remedy]],
) -> Iterator[Check]:
    """Of every mesh and wheel that is struck and has a strength class; `stronger`: what makes one strong enough under
    the "low" force, or the high one at the largest backlash, "most"."""
    for key, mesh in meshes.items():
        name = Text("Safety of {pair} against pitting under strikes", pair=titles[key])
        low, most = mesh.strike_safety_contact_low, mesh.strike_safety_contact_most
        if low is not None:
            soft, missing = Text("{name}, low force", name=name), lack(drive.assumed, taken, low)
            ways = stronger(key, "low")
            yield STRIKE_CONTACT(low, S_H_LEAST, at=key, name=soft, missing=missing, index=index[key], remedies=ways)
        if most is not None:
            hard, missing = Text("{name}, high force, largest backlash", name=name), lack(drive.assumed, taken, most)
            ways = stronger(key, "most")
            yield STRIKE_CONTACT_MOST(
                most, S_H_LEAST, at=key, name=hard, missing=missing, index=index[key], remedies=ways
            )
    for of, wheel in wheels.items():
        name = Text("Safety of {wheel} against tooth breakage under strikes", wheel=of)
        low, most = wheel.strike_safety_bending_low, wheel.strike_safety_bending_most
        if low is not None:
            soft, missing = Text("{name}, low force", name=name), lack(drive.assumed, taken, low)
            ways = stronger(of, "low")
            yield STRIKE_BENDING(low, S_F_LEAST, at=of, name=soft, missing=missing, remedies=ways)
        if most is not None:
            hard, missing = Text("{name}, high force, largest backlash", name=name), lack(drive.assumed, taken, most)
            ways = stronger(of, "most")
            yield STRIKE_BENDING_MOST(most, S_F_LEAST, at=of, name=hard, missing=missing, remedies=ways)


def method_checks(drive: DriveResult, shares: Mapping[str, Number]) -> Iterator[Check]:
    """How far the method holds; `shares`: backlash over half the swing at idle and where it is hardest."""
    if IDLE in drive.operations:
        yield IRREGULARITY_HIGH(drive.operations[IDLE].irregularity, HIGHEST_IRREGULARITY)
    if shares:
        yield REBOUND(max(shares.values()), 1.0)
    yield ASSUMED(drive.assumed, 0.0, scale=1.0)


def window_check(
    drive: DriveResult, low: Metre, high: Metre, governs: Text, opens: Text, remedies: Later[Remedy]
) -> Check:
    """Whether the window of the nominal backlash has room; both along the line of action, of one way."""
    return BACKLASH_WINDOW(
        low,
        high,
        name=Text("Least nominal backlash against the largest, {way}", way=governs),
        advice=opens,
        missing=lack(drive.assumed, drive.drive.taken, low),
        remedies=remedies,
    )
