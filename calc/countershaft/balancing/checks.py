# SPDX-License-Identifier: Apache-2.0
"""Whether a shaft that was read passes, whether the machine can tell, and whether the holes have room."""

import math
from collections.abc import Iterator, Sequence
from itertools import combinations

import numpy as np

from ...sheet.arrays import Array
from ...sheet.check import Check, CheckRule, Missing
from ...sheet.quantity import dotted
from ...sheet.remedy import by_key, digits
from ...sheet.text import SEMICOLON, Amount, Name, Text
from ...sheet.units import UNITS, Metre
from ..inputs import ShaftInputs
from ..rows import SHAFT
from .inputs import Balancing
from .result import PLANES, BalancingPlane, BalancingResult, Drill
from .solve import counted_error

TABLE = dotted(SHAFT, ShaftInputs.balancing)
SPEED, ERROR, RING = (
    dotted(TABLE, key) for key in (Balancing.speed, Balancing.measurement_error, Balancing.ring_tolerance)
)
MACHINE = Text("ISO 21940-14, from memory: the error of the machine on either side of what is permitted")
RING_SHARE, ERROR_SHARE = 0.2, 0.3  # of the smaller permitted unbalance; rules of this program

READING = CheckRule(
    "countershaft.balancing.reading.N",
    "limit",
    "A shaft out of its tolerance leaves more than its drawing allows.",
    unit="g·mm",
    source=MACHINE,
    sense="<=",
    role="chosen",
    exact=True,
    advice=Text("Another hole where none reaches, or deeper ones."),
    moved_by=(dotted(TABLE, Balancing.holes), dotted(SHAFT, ShaftInputs.balance_grade), ERROR),
)
FORCE = CheckRule(
    "countershaft.balancing.machine",
    "caution",
    "Rings, or a machine that compensates, take the force off the pedestal.",
    Text("Force on a pedestal of the balancing machine, without compensation"),
    "<=",
    "N",
    Text("given in the design: what a pedestal bears"),
    Text("Or compensating rings."),
    demand=True,
    moved_by=(SPEED, dotted(TABLE, Balancing.machine_force)),
)
RINGS = CheckRule(
    "countershaft.balancing.ring",
    "caution",
    "The rings are taken for the shaft: their error is one of every shaft.",
    Text("Standard error of a compensating ring"),
    "<=",
    "g·mm",
    Text("rule of this program: 20 % of the smaller permitted unbalance"),
    Text("Closer rings."),
    moved_by=(RING,),
)
ERRORS = CheckRule(
    "countershaft.balancing.error",
    "caution",
    "The machine can tell of fewer shafts whether they pass.",
    Text("Error of machine and ring together"),
    "<=",
    "g·mm",
    Text("rule of this program: 30 % of the smaller permitted unbalance"),
    Text("A better machine, or closer rings."),
    moved_by=(ERROR, RING),
)
ROOM = CheckRule(
    "countershaft.balancing.holes",
    "limit",
    "A hole weakens the core, breaks out of its sector or runs into another one.",
    unit="mm",
    source=Text("geometry: metal around the holes to drill, at their greatest depth with the drill's cone"),
    advice=Text("Less depth, or another place."),
    role="physics",
    zero="outer radius",
    moved_by=(
        dotted(TABLE, Balancing.holes),
        dotted(SHAFT, ShaftInputs.holes),
        dotted(SHAFT, ShaftInputs.core_radius),
    ),
)


def checks(found: BalancingResult) -> Iterator[Check]:
    table = found.inputs
    for serial, reading in found.reading.items():
        if reading.told is not None:
            yield reading_check(found, serial)
    if table.machine_force is not None:
        force = max(plane.machine_force for plane in found.planes)
        n = table.speed * math.sqrt(table.machine_force / force) if force else table.speed
        slower = digits(math.floor(UNITS["rpm"].shown(n)), 6)
        yield FORCE(force, table.machine_force, remedies=by_key(Balancing, SPEED, slower, bound="<="))
    known = [plane.permitted for plane in found.planes if plane.permitted is not None]
    if len(known) == len(found.planes):
        if any(ring := [plane.ring_error for plane in found.planes]):
            yield RINGS(max(ring), RING_SHARE * min(known))
        if any(error := [plane.error for plane in found.planes]):
            yield ERRORS(max(error), ERROR_SHARE * min(known))
    drills = [*(hole.drill for hole in found.hole.values()), *found.outside]
    if drills:
        room, words, R = least_room(drills)
        yield ROOM(room, 0.0, name=words, scale=R)


def reading_check(found: BalancingResult, serial: str) -> Check:
    """By the plane that decides: it fails in one plane, or passes in both; between, this machine can not tell."""
    reading = found.reading[serial]
    name = Text("Unbalance of {serial} after drilling", serial=Name(serial))
    rank = {"pass": 0, "between": 1, "fail": 2}
    left = (reading.front, reading.rear)

    def decides(n: int) -> tuple[int, float]:
        assert reading.told is not None  # where what is permitted is known
        return rank[reading.told[n]], left[n] / _permitted(found.planes[n])

    n = max((0, 1), key=decides)
    plane, words = found.planes[n], PLANES[n]
    where = Text("{name}, {plane}", name=name, plane=words)
    if reading.told is None or reading.told[n] != "between":
        return READING(left[n], _permitted(plane), at=serial, name=where)
    error = counted_error(plane)
    unsure = Missing((), (), max(left[n] - error, 0.0), left[n] + error)  # nothing is lacking but a better machine
    shown = Amount(UNITS["g·mm"].shown(error), "g·mm", form=".3g")
    cannot = Text(
        "This machine can't tell: what is left is within its error, ± {error}, of what is permitted. A better machine, "
        "closer rings, or deeper holes.",
        error=shown,
    )
    return READING(left[n], _permitted(plane), at=serial, name=where, missing=unsure, advice=cannot)


def _permitted(plane: BalancingPlane) -> float:
    assert plane.permitted is not None
    return plane.permitted


# --- room around the holes


def least_room(drills: Sequence[Drill]) -> tuple[Metre, Text, Metre]:
    """The least metal around any hole, below zero where it breaks out, whose it is, and the outer radius there; first
    of those that would be in the air: their drill, wholly beside the metal."""
    if aside := [drill for drill in drills if drill.outside is not None]:
        said = SEMICOLON.join(outside_words(drill) for drill in aside)
        worst = min(aside, key=_beside)
        return _beside(worst), said, worst.R
    found = [room for drill in drills for room in _rooms(drill)]
    for one, other in combinations(drills, 2):
        apart = segments_apart(*_axis(one), *_axis(other)) - (one.diameter + other.diameter) / 2
        words = Text("Metal between holes {one} and {other}", one=Name(one.name), other=Name(other.name))
        found.append((apart, words, one.R))
    return min(found, key=lambda room: room[0])


def outside_words(drill: Drill) -> Text:
    """Of a hole that would be in the air."""
    assert drill.outside is not None
    return Text("Hole {name} is {where}", name=Name(drill.name), where=drill.outside)


def _beside(drill: Drill) -> Metre:
    """How far a hole in the air is off its sector, below zero, with its own radius."""
    if drill.half is None:
        return -drill.diameter / 2
    off = abs(math.remainder(drill.angle - drill.middle, 2 * math.pi)) - drill.half
    return -drill.R * math.sin(min(off, math.pi / 2)) - drill.diameter / 2


def _rooms(drill: Drill) -> Iterator[tuple[Metre, Text, Metre]]:
    name, a, R = Name(drill.name), drill.diameter / 2, drill.R
    bottom = R - drill.depth
    tip = bottom - a / math.tan(drill.point / 2)
    yield tip - drill.core, Text("Metal under hole {name}, below its cone", name=name), R
    along = min(drill.z - drill.start, drill.end - drill.z)
    if math.isfinite(along):
        yield along - a, Text("Metal beside hole {name}, along its sector", name=name), R
    if drill.half is not None and math.pi - drill.half > 1e-9:
        aside = drill.half - abs(math.remainder(drill.angle - drill.middle, 2 * math.pi))
        wide = bottom * math.sin(min(aside, math.pi / 2))
        yield wide - a, Text("Metal beside hole {name}, across its sector", name=name), R


def _axis(drill: Drill) -> tuple[Array, Array]:
    """The axis of a hole, from the outer radius to the end of its full diameter."""
    way = np.array([math.cos(drill.angle), math.sin(drill.angle), 0.0])
    at = np.array([0.0, 0.0, drill.z])
    return at + drill.R * way, at + max(drill.R - drill.depth, 0.0) * way


def segments_apart(p: Array, q: Array, r: Array, s: Array) -> Metre:
    """The distance of the segments p–q and r–s: inside both where the common normal ends there, else at an end."""
    d, e, w = q - p, s - r, p - r
    a, b, c, f, g = (float(np.dot(x, y)) for x, y in ((d, d), (d, e), (e, e), (d, w), (e, w)))
    det = a * c - b * b
    pairs: list[tuple[float, float]] = []
    if det > 1e-12 * a * c:
        pairs.append(((b * g - c * f) / det, (a * g - b * f) / det))
    ends = [(t, (b * t + g) / c) for t in (0.0, 1.0)] + [((b * u - f) / a, u) for u in (0.0, 1.0)]
    within = [(t, u) for t, u in pairs if 0 <= t <= 1 and 0 <= u <= 1]
    within += [(min(max(t, 0.0), 1.0), min(max(u, 0.0), 1.0)) for t, u in ends]
    return float(min(np.linalg.norm(w + t * d - u * e) for t, u in within))
