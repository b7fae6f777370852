# SPDX-License-Identifier: Apache-2.0
"""The data of the teeth that stand on a drawing (ISO 1340, symbols of ISO 21771), and the notes on them."""

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from ..sheet.quantity import published
from ..sheet.text import COMMA, Name, Text
from ..sheet.units import UNITS, Metre, Radian
from . import defaults
from .annotations import COLUMNS, Rows, SheetTable
from .sizes import ALIKE, Say, alone, degrees, deviated, millimetres, number
from .turned import roughness, shaft_wheel

if TYPE_CHECKING:
    from ..friction.inputs import FrictionInputs
    from ..gears.inputs import GearsInputs
    from ..gears.rating.classes import StrengthClass
    from ..gears.result import TrainResult, WheelResult
    from ..solve import Results

HANDS = {"left": Text("left"), "right": Text("right")}
SIZE = 3  # decimals of a tooth's sizes
TOLERANCE = 1  # of its tolerances, µm
TURNED = 2  # of an angle at which it stands


def gear_table(results: "Results", wheel: "WheelResult", say: Say) -> SheetTable:
    return say(Text("Gear data: {name}", name=wheel.name)), gear_rows(results, wheel, say), COLUMNS


def gear_rows(results: "Results", wheel: "WheelResult", say: Say) -> Rows:
    """A label and what is said, in the order in which a gear is cut, measured and paired."""
    train, gears = results.train, results.design.gears
    assert train is not None and gears is not None
    rows = [*_teeth(train, wheel, gears), *_tolerances(wheel), *_sizes(wheel), *_mates(train, wheel)]
    if (friction := results.design.friction) is not None and (Ra := _flanks(friction, train, wheel.name)) is not None:
        rows.append((Text("Roughness of the flanks"), roughness(Ra)))
    rows += _strength(train, wheel.name)
    if wheel is shaft_wheel(results):
        rows += _where_teeth_stand(results, train, wheel)
    if (relief := gears.tip_relief) is not None:
        rows.append((Text("Tip relief"), _microns(relief)))
    return [(say(label), say(value)) for label, value in rows]


def _where_teeth_stand(results: "Results", train: "TrainResult", wheel: "WheelResult") -> Iterator[tuple[Text, Text]]:
    """Of the shaft that is drawn, and of each of its twins: a mirror image has its masses mirrored, and its teeth where
    the way of the power to it leaves them."""
    shaft, late = results.design.countershaft, None
    if shaft is not None and shaft.scatter is not None and shaft.scatter.timing:
        late = degrees(defaults.SIGMAS * shaft.scatter.timing, TURNED)

    def stands(tooth: Radian) -> Text:
        angle = degrees(tooth % (2 * math.pi), TURNED)
        return angle if late is None else Text("{angle} ±{late}", angle=angle, late=late)

    if (tooth := tooth_angle(train, wheel.name)) is not None:
        yield Text("A tooth at, cylinder 1 at TDC"), stands(tooth)
    for twin in results.design.resolved:
        if shaft is None or twin.of != shaft.name or (turn := train.shafts.get(twin.name)) is None:
            continue
        if (tooth := tooth_angle(train, turn.wheel)) is not None:
            yield Text("A tooth of {name} at, cylinder 1 at TDC", name=Name(twin.name)), stands(tooth)


def tooth_angle(train: "TrainResult", wheel: str) -> Radian | None:
    """The direction of the middle of a tooth, counted as those of the masses are; None: nobody has laid it out."""
    laid = train.layout.wheels if train.layout is not None else {}
    return laid[wheel].tooth_angle if wheel in laid else None


def strength_of(train: "TrainResult", wheel: str) -> "StrengthClass | None":
    """The class by which its teeth are judged, also where that is the program's choice; None: they are not judged."""
    rated = (mesh.rating.strength for mesh in train.meshes.values() if mesh.rating is not None)
    sides = (side for strength in rated if strength is not None for side in strength.sides)
    return next((side.strength for side in sides if side.name == wheel), None)


def _strength(train: "TrainResult", wheel: str) -> Iterator[tuple[Text, Text]]:
    """How its material is treated, and how hard its surface has to be."""
    if (strength := strength_of(train, wheel)) is None:
        return
    yield (
        Text("Heat treatment, ISO 6336-5"),
        Text("{name}, {quality}", name=Text(strength.name), quality=strength.quality),
    )
    least = strength.low if strength.hardness is None else strength.hardness
    low, high = number(least, 0), number(strength.high, 0)
    yield Text("Surface hardness"), Text("{low} to {high} {scale}", low=low, high=high, scale=strength.scale)


def _teeth(train: "TrainResult", wheel: "WheelResult", gears: "GearsInputs") -> Iterator[tuple[Text, Text]]:
    s = train.system
    yield Text("Normal module"), alone(millimetres(s.m_n, SIZE))
    yield Text("Number of teeth"), Text("{z}", z=wheel.teeth)
    yield Text("Normal pressure angle"), degrees(s.alpha_n, SIZE)
    if s.beta:
        hand = HANDS[gears.hands()[wheel.name]]
        yield Text("Helix angle, hand"), Text("{angle}, {hand}", angle=degrees(s.beta, SIZE), hand=hand)
    tool = Text("{h} / {rho} modules", h=number(s.h_aP0, SIZE), rho=number(s.rho_aP0, SIZE))
    yield Text("Tool: addendum, tip radius"), tool
    yield Text("Profile shift"), alone(number(wheel.profile_shift, 4))
    yield Text("Accuracy grade, ISO 1328-1:2013"), Text("{grade}", grade=gears.accuracy_grade)


def _tolerances(wheel: "WheelResult") -> Iterator[tuple[Text, Text]]:
    t = wheel.tolerances
    yield Text("Single pitch ±f_p, total pitch F_p"), _pair(t.single_pitch, t.total_pitch)
    yield Text("Profile F_α, helix F_β"), _pair(t.profile, t.helix)
    yield Text("Runout F_r, ISO 1328-2:1997"), _microns(t.runout)


def _microns(size: Metre) -> Text:
    return Text("{size} µm", size=number(UNITS["µm"].shown(size), TOLERANCE))


def _pair(first: Metre, other: Metre) -> Text:
    sizes = (number(UNITS["µm"].shown(size), TOLERANCE) for size in (first, other))
    return Text("{first}, {other} µm", **dict(zip(("first", "other"), sizes)))


def _sizes(wheel: "WheelResult") -> Iterator[tuple[Text, Text]]:
    yield Text("Reference diameter"), alone(millimetres(wheel.reference_diameter, SIZE))
    yield Text("Base diameter"), alone(millimetres(wheel.base_diameter, SIZE))
    yield Text("Root diameter"), _from_to(wheel.root_diameter, wheel.root_diameter_min, wheel.root_diameter_max)
    known = {value.id.removeprefix("."): value for value in published(wheel, "")}
    span = f"span_{round(wheel.span_teeth)}"
    if span in known:
        size = alone(number(known[span].shown, SIZE))
        if wheel.allowance is not None:
            size = deviated(size, min(wheel.allowance), max(wheel.allowance))
        yield Text("Span over {k} teeth", k=round(wheel.span_teeth)), size
    if wheel.over_balls is not None:
        label = Text("Size over balls ⌀{ball}", ball=millimetres(wheel.ball_diameter, SIZE))
        yield label, _from_to(wheel.over_balls, wheel.over_balls_min, wheel.over_balls_max)


def _from_to(size: float, low: float | None, high: float | None) -> Text:
    if low is None or high is None or abs(high - low) < ALIKE:
        return alone(millimetres(size, SIZE))
    return Text("{low} to {high}", low=millimetres(low, SIZE), high=millimetres(high, SIZE))


def _mates(train: "TrainResult", wheel: "WheelResult") -> Iterator[tuple[Text, Text]]:
    for mate, _, mesh in train.mates(wheel.name):
        yield Text("Mating wheel, teeth"), Text("{mate}, {z}", mate=Name(mate), z=train.wheels[mate].teeth)
        size, tolerance = alone(millimetres(mesh.centre_distance, SIZE)), mesh.centre_tolerance
        yield Text("Centre distance"), deviated(size, -tolerance, tolerance) if tolerance else size
        least, most = (number(UNITS["µm"].shown(j), 0) for j in (mesh.backlash_min, mesh.backlash_max))
        yield Text("Backlash, normal"), Text("{least} to {most} µm", least=least, most=most)


def _flanks(friction: "FrictionInputs", train: "TrainResult", wheel: str) -> float | None:
    """Ra of the flanks of one wheel: that of all, or that of its place in its first mesh."""
    Ra = friction.flank_roughness
    if len(Ra) == 1:
        return Ra[0]
    pairs = ((mesh.driver, mesh.driven) for mesh in train.meshes.values())
    return next((Ra[pair.index(wheel)] for pair in pairs if wheel in pair), None)


def tooth_notes(wheel: "WheelResult") -> Iterator[Text]:
    if extrapolated := wheel.tolerances.extrapolated:
        yield Text("ISO 1328-1 has no tolerances for {what}: they are extrapolated.", what=COMMA.join(extrapolated))
