# SPDX-License-Identifier: Apache-2.0
"""What stands around the wheels, how much room each has, and the checks of reach, room and assembly.

Two wheels in a row between placed ones get the free angle with the most room; more of them are proposed an arc."""

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from ...sheet.arrays import Array, ComplexArray
from ...sheet.check import Check, CheckRule, Missing
from ...sheet.quantity import dotted
from ...sheet.record import record, replace
from ...sheet.remedy import Remedy, by_key, change, remedy
from ...sheet.text import EMPTY, Amount, Name, Text, alternatives, listed
from ...sheet.units import Metre, Number, Radian
from ...sheet.value import about, based_on
from ..inputs import GearsInputs, Mesh, mesh_key, wheel_key
from ..limits import mm
from ..result import MeshResult, TrainResult
from ..wheel_inputs import Wheel
from . import formulas as f
from .result import MeshLayout

FREE = math.inf  # the clearance of a wheel that has nothing near it
COARSE, FINE = 180, 65  # directions of the scan, and of the one about its best
WELL_WITHIN = 0.85  # of what wheels span at most: nearer to it a small error moves them far
HALVINGS, NEAR = 50, 1e-9  # of the curvature of an arc, and m within which it then meets its end
DUST = 1e-12  # stretched or folded, the circles only touch


class Clearance(NamedTuple):
    """The smallest one of a kind: "wall", "neighbour" or "wheel"."""

    g: Metre
    kind: str
    to: str


@record
class Room:
    """Walls, neighbours, and how far each wheel reaches.  Points are complex: up + i·side from the crank's axis."""

    walls: tuple[tuple[str, complex, complex], ...]
    neighbours: tuple[tuple[str, complex, Metre], ...]
    swept: dict[str, Metre]
    mates: dict[str, set[str]]

    def others(self, wheel: str, places: dict[str, complex]) -> list[tuple[str, complex, Metre]]:
        """The wheels that it does not mesh with: name, place, reach."""
        return [
            (name, q, self.swept[name]) for name, q in places.items() if name != wheel and name not in self.mates[wheel]
        ]

    def around(self, wheel: str, p: complex, places: dict[str, complex]) -> Metre:
        """The smallest clearance of a wheel at a point; `places`: of the other wheels."""
        return float(self.around_all(wheel, np.array(p), places))

    def around_all(self, wheel: str, p: ComplexArray, places: dict[str, complex]) -> Array:
        """The same for points of any shape."""
        r_s = self.swept[wheel]
        least: Array = np.full(p.shape, FREE)
        for _, a, b in self.walls:
            share = np.clip(((p - a) * (b - a).conjugate()).real / abs(b - a) ** 2, 0.0, 1.0)
            least = np.minimum(least, np.abs(p - a - share * (b - a)) - r_s)
        for _, q, r in (*self.neighbours, *self.others(wheel, places)):
            least = np.minimum(least, np.abs(p - q) - r_s - r)
        return least


def at(place: Sequence[Metre]) -> complex:
    """A place that is given: up from the crank, and to the side."""
    return based_on(complex(*place), place)


def room(gears: GearsInputs, train: TrainResult) -> Room:
    mates: dict[str, set[str]] = {w.name: set() for w in gears.wheels}
    tolerances: dict[str, list[Metre]] = {w.name: [] for w in gears.wheels}
    for mesh in train.meshes.values():
        for wheel, mate in ((mesh.driver, mesh.driven), (mesh.driven, mesh.driver)):
            mates[wheel].add(mate)
            tolerances[wheel].append(mesh.centre_tolerance)
    swept = {}
    for w in gears.wheels:
        upper = w.tip_diameter_tolerance[0] if w.tip_diameter_tolerance else 0.0
        largest = based_on(max(tolerances[w.name]), *tolerances[w.name])
        with about(Text("wheel {name}, room", name=w.name)):
            swept[w.name] = f.swept_radius(
                d_a=train.wheels[w.name].tip_diameter, E_da=upper, F_r=w.runout or 0.0, T_a=largest
            )
    walls = tuple((wall.name, at(wall.from_), at(wall.to)) for wall in gears.walls)
    return Room(walls, tuple((n.name, at(n.position), n.radius) for n in gears.neighbours), swept, mates)


def clearances(wheel: str, places: dict[str, complex], room: Room) -> dict[str, Clearance]:
    """The smallest clearance of each kind, line by line, of a wheel in its place; kinds of which there is nothing are
    left out."""
    p, r_s, free = places[wheel], room.swept[wheel], {}
    with about(Text("wheel {wheel}, room", wheel=wheel)):
        if room.walls:
            name, a, b = min(room.walls, key=lambda wall: f.wall_distance.function(p, wall[1], wall[2]))
            h = f.wall_distance(p=p, w_1=a, w_2=b)
            free["wall"] = Clearance(f.wall_clearance(h=h, r_s=r_s), "wall", name)
        for kind, things in (("neighbour", room.neighbours), ("wheel", room.others(wheel, places))):
            if things:
                name, q, r = min(things, key=lambda thing: abs(thing[1] - p) - thing[2])
                free[kind] = Clearance(f.round_clearance(c=f.axes_apart(p_1=p, p_3=q), r_s=r_s, r=r), kind, name)
    return free


# --- two wheels in a row between two placed ones: the free angle with the most room, by a scan that is refined about
# its best point


def most_room(
    room: Room, places: dict[str, complex], chain: tuple[str, str, str, str], a: tuple[Metre, Metre, Metre]
) -> tuple[Radian, float, Metre] | None:
    """(direction of the first open wheel from its placed neighbour, side of the second, clearance of the tighter one).

    None where no direction was found in which both wheels reach.  The coarse scan holds the stretched and the folded
    position."""
    first, one, two, last = chain
    p, q = places[first], places[last]
    toward = math.atan2((q - p).imag, (q - p).real)
    step, best = 2 * math.pi / COARSE, None
    phi: Array = toward + step * np.arange(COARSE, dtype=float)
    for _ in range(2):
        clearance = _clearances(room, places, (one, two), p, q, phi, a)
        top = int(clearance.argmax())
        widest = float(clearance.flat[top])
        if widest == -math.inf:
            return best
        side, angle = divmod(top, phi.size)
        if best is None or widest > best[2]:
            best = float(phi[angle]), (1.0, -1.0)[side], widest
        phi = np.linspace(best[0] - step, best[0] + step, FINE)
    return best


def _clearances(
    room: Room,
    places: dict[str, complex],
    names: tuple[str, str],
    p: complex,
    q: complex,
    phi: Array,
    a: tuple[Metre, Metre, Metre],
) -> Array:
    """Of the tighter wheel, one row for each side; −∞ where the wheels do not reach each other."""
    sides = np.array([[1j], [-1j]])
    one, two = names
    A = p + a[0] * np.exp(1j * phi)
    way = q - A
    c2 = np.abs(way) ** 2
    u = (c2 + a[1] ** 2 - a[2] ** 2) / 2  # times c
    square = a[1] ** 2 * c2 - u**2
    v = np.sqrt(np.maximum(square, 0.0))
    with np.errstate(divide="ignore", invalid="ignore"):  # on the second axis the first has no direction to it
        B = A + (u + sides * v) * (way / c2)
    tighter = np.minimum(room.around_all(one, A, places), room.around_all(two, B, places))
    return np.where((c2 > 0) & (square >= -DUST * a[1] ** 2 * c2), tighter, -math.inf)


# --- more wheels in a row between two placed ones: a place for them all, on an arc


def to_give(wheels: Sequence[str]) -> Sequence[str]:
    """Those of three and more open wheels in a row whose places fix all, or leave two that find theirs."""
    return wheels[1:-1:2]


def bowed(room: Room, places: dict[str, complex], row: Sequence[str], a: Sequence[Metre]) -> dict[str, complex]:
    """The places to give of a row on an arc through its ends, bowed to the side where the tightest of them has more
    room, and well within what the wheels between them span; `a`: the distance from each wheel of the row to the next.
    None where there is no such arc."""
    p, q, names = places[row[0]], places[row[-1]], to_give(row[1:-1])
    ends = [0, *(row.index(name) for name in names), len(a)]
    spans = [sum(a[start:end]) for start, end in pairwise(ends)]
    c = abs(q - p)
    drawn_in = max(WELL_WITHIN, c / sum(spans))
    if (shape := _arc(tuple(min(drawn_in * span, c) for span in spans), c)) is None:
        return {}

    def least(there: dict[str, complex]) -> Metre:
        return min(room.around(name, place, places | there) for name, place in there.items())

    sides = (shape, shape.conjugate())
    return max((dict(zip(names, p + (q - p) / side[-1] * side)) for side in sides), key=least)


def _arc(a: tuple[Metre, ...], c: Metre) -> ComplexArray | None:
    """The corners of a row of chords `a` of one circle, from 0, where the last stands `c` off the first: the curvature
    halved down to."""
    low, high = 0.0, 2 / max(a)
    corners: ComplexArray = np.cumsum(a) + 0j
    for _ in range(HALVINGS):
        curvature = (low + high) / 2
        turns = 2 * np.arcsin(np.array(a) * curvature / 2)
        corners = np.cumsum(a * np.exp(1j * (np.cumsum(turns) - turns / 2)))
        if abs(corners[-1]) > c and sum(turns) < 2 * math.pi:
            low = curvature
        else:
            high = curvature
    return corners if c > 0 and abs(abs(corners[-1]) - c) < NEAR else None


# --- whether the wheels reach each other in their places, have room there, and can be put together

USUAL_CLEARANCE: Metre = 1e-3  # rule of this program
HERE = dotted("gears", GearsInputs.wheels, "W", Wheel.position)
TEETH = dotted("gears", GearsInputs.wheels, "W", Wheel.teeth)
SHAFT_AXIS = "shafts.S.axis_mm"

REACH = CheckRule(
    "gears.W.position",
    "limit",
    "The wheel between two axes does not reach both.",
    sense="in",
    unit="mm",
    source=Text("geometry: two circles about the fixed axes, with the working centre distances"),
    role="self",
    moved_by=(TEETH,),
)
AXIS = CheckRule(
    "gears.W.axis",
    "limit",
    "The last wheel does not stand on the shaft that it turns.",
    sense="<=",
    unit="µm",
    source=Text("rule of this program: the last wheel stands on the counter-shaft, within 10⁻³ m_n"),
    role="self",
    moved_by=(HERE, SHAFT_AXIS),
)
DISTANCE = CheckRule(
    "gears.M.position",
    "limit",
    "Wheels that do not stand at their centre distance do not mesh as computed.",
    sense="<=",
    unit="µm",
    source=Text("rule of this program: the tolerance of the centre distance, at least 10⁻³ m_n"),
    role="self",
    moved_by=(
        dotted("gears", GearsInputs.meshes, "#", Mesh.centre_distance),
        dotted("gears", GearsInputs.wheels, "DRIVER", Wheel.position),
        dotted("gears", GearsInputs.wheels, "DRIVEN", Wheel.position),
    ),
)
CLEARANCE = CheckRule(
    "gears.W.clearance",
    "limit",
    "The wheel runs into what stands beside it.",
    unit="mm",
    source=Text(
        "geometry: tip circle with its upper deviation, half the runout and the tolerance of the axis, at rest and cold"
    ),
    role="physics",
    zero="1 mm, its usual limit",
    moved_by=(HERE, TEETH),
    short=Text("wall"),
)
CLEARANCE_USUAL = CheckRule(
    "gears.W.clearance_usual",
    "advice",
    "The usual room.",
    unit="mm",
    source=Text("rule of this program: 1 mm"),
    cause=CLEARANCE.id,
    moved_by=(HERE, TEETH),
)
HUNTING = CheckRule(
    "gears.M.hunting",
    "advice",
    "Good practice that spreads the wear.",
    sense="<=",
    source=Text("mathematics, hunting tooth: every tooth meets every tooth where the numbers have no common factor"),
    value_id=dotted("gears", "M", MeshLayout.common_factor),
    moved_by=(
        dotted("gears", GearsInputs.wheels, "DRIVER", Wheel.teeth),
        dotted("gears", GearsInputs.wheels, "DRIVEN", Wheel.teeth),
    ),
)
ASSEMBLY = CheckRule(
    "gears.train.assembly",
    "caution",
    "The wheel does not pass the seat; it may be fixed after the shaft is inserted.",
    unit="mm",
    source=Text(
        "geometry: the wheel passes through the seat of the journal where the shaft is inserted along its axis; "
        "diametral"
    ),
    zero="1 mm",
    moved_by=("shafts.S.bearings.*.diameter_mm", dotted("gears", GearsInputs.normal_module)),
)
SHAFT_ASSEMBLY = replace(ASSEMBLY, id="gears.N.assembly")  # of one of several shafts


def reach_check(
    wheel: str, what: Text, first: str, second: str, c: Metre, low: Metre, high: Metre, tolerance: Metre
) -> Check:
    """Of two placed axes `c` apart, which `what` can span from `low` to `high`."""
    limits = max(low - tolerance, 0.0), high + tolerance
    if c > limits[1]:
        do = Text(
            "bring them at least {c} mm closer, or give larger centre distances or more teeth between them",
            c=mm(c - high),
        )
    elif c < limits[0]:
        do = Text("set them at least {low} mm further apart, or make the centre distances more alike", low=mm(low - c))
    else:
        do = Text("near a limit small errors of the axes move the wheel between them far")
    advice = Text(
        "{first} and {second} must stand {low} to {high} mm apart for {what} to reach both: {do}.",
        first=first,
        second=second,
        low=mm(low, digits=6),
        high=mm(high, digits=6),
        what=what,
        do=do,
    )
    name = Text("Distance {first} to {second} that {what} spans", first=first, second=second, what=what)
    return REACH(c, limits, at=wheel, name=name, advice=advice)


def unplaced_check(wheels: Sequence[str], proposed: Mapping[str, complex]) -> Check:
    """Of three and more wheels in a row that have no place, though they reach."""
    given = to_give(wheels)
    keys = {name: wheel_key(name, Wheel.position) for name in given}

    def places() -> tuple[Remedy, ...]:
        mm = {name: [round(part * 1e3, 2) for part in (p.real, p.imag)] for name, p in proposed.items()}
        changes = [change(Wheel, keys[name], mm[name], place=name) for name in given if name in mm]
        return (remedy(*changes),) if changes else ()

    name = Text("Clearance of {wheels}", wheels=listed(map(Name, wheels)))
    missing = Missing(tuple(keys.values()), (), "holds", "none")
    return CLEARANCE(
        None, 0.0, at=given[0], name=name, advice=EMPTY, scale=USUAL_CLEARANCE, missing=missing, remedies=places
    )


def axis_check(last: str, off: Metre, limit: Metre) -> Check:
    """`off`: between the given position of the last wheel and the axis of the counter-shaft."""
    name = Text("Position of {last} from the axis of the counter-shaft", last=last)
    effect = Text("the axis of the counter-shaft gives it")
    left_out = by_key(Wheel, wheel_key(last, Wheel.position), None, place=last, effect=effect)
    return AXIS(off, limit, at=last, name=name, remedies=left_out)


def distance_check(
    key: str, index: int, mesh: MeshResult, c: Metre, error: Metre, limit: Metre, given: list[str]
) -> Check:
    """Of two axes that stand `c` apart; `given`: which of both wheels have a given position."""
    advice = Text(
        "The axes stand {c} mm apart, the centre distance is {centre_distance} mm.",
        c=mm(c, ".4f"),
        centre_distance=mm(mesh.centre_distance, ".4f"),
    )
    if given:
        advice += Text(" Or move {wrong}.", wrong=alternatives(given))
    name = Text("Axes of {driver} and {driven} off their centre distance", driver=mesh.driver, driven=mesh.driven)
    as_placed = by_key(Mesh, mesh_key(index, Mesh.centre_distance), round(c * 1e3, 4), place=mesh.title)
    return DISTANCE(error, limit, at=key, name=name, advice=advice, index=index, remedies=as_placed)


def clearance_checks(
    wheel: str, free: dict[str, Clearance], order: Sequence[str], chosen: bool, axes: Mapping[str, str]
) -> Iterator[Check]:
    """Of the tightest place around a wheel.  Two wheels that come too near each other are judged once, at the later
    one.  `axes`: of the wheels that stand where their shafts do, the keys of these axes."""
    clearances = [c for c in free.values() if c.kind != "wheel" or order.index(c.to) < order.index(wheel)]
    if not clearances:
        return
    tight = min(clearances, key=lambda c: c.g)
    what = tight.to
    if tight.kind != "neighbour":
        what = Text("wall {to}", to=tight.to) if tight.kind == "wall" else Text("wheel {to}", to=tight.to)
    name = Text("Clearance of {wheel} to {what}", wheel=wheel, what=what)
    move = Text("move {wheel} or {what} apart", wheel=wheel, what=what)
    more = Text(" by {g} mm", g=mm(-tight.g)) if tight.g < 0 else ""
    if chosen:
        move, more = Text("give {wheel} another place", wheel=wheel), ""
    advice = Text(
        "The tip circle needs more room: {move}{missing}, or give it fewer teeth or a smaller shift.",
        move=move,
        missing=more,
    )
    if chosen and tight.kind != "wheel":
        advice += Text(" `choose FILE gears` tries its teeth.")
    moved = [axes[one] for one in (wheel, tight.to if tight.kind == "wheel" else "") if one in axes]
    by = (*moved, wheel_key(wheel, Wheel.teeth)) if moved else None
    yield CLEARANCE(tight.g, 0.0, at=wheel, name=name, advice=advice, scale=USUAL_CLEARANCE, moved_by=by)
    usual = Text("{name}, usual", name=name)
    yield CLEARANCE_USUAL(tight.g, USUAL_CLEARANCE, at=wheel, name=usual, advice=advice, moved_by=by)


def hunting_check(key: str, mesh: MeshResult, z_1: int, z_2: int, factor: Number, turns: Number) -> Check:
    """`factor`: common one of both numbers of teeth; `turns`: of the driver until the same teeth meet."""
    advice = Text("Numbers of teeth without a common factor spread the wear.")
    if factor > 1:
        advice = Text(
            "Every tooth of {driver} meets only {z_2} of the {z_22} teeth of {driven}, and one fault returns after "
            "{turns} turns of {driver}: numbers of teeth without a common factor spread the wear (the teeth of an "
            "idler do not change the ratio).",
            driver=mesh.driver,
            z_2=Amount(z_2 / factor, form="g"),
            z_22=z_2,
            driven=mesh.driven,
            turns=Amount(turns, form="g"),
        )
    wheels = {"driver": mesh.driver, "z_1": z_1, "driven": mesh.driven, "z_2": z_2}
    name = Text("Common factor of the teeth {driver} {z_1}, {driven} {z_2}", **wheels)
    return HUNTING(factor, 1.0, at=key, name=name, advice=advice)


def insertion_check(wheel: str, seat: Text, gap: Metre, shaft: str = "") -> Check:
    """`shaft`: the name of the shaft, where there are several."""
    more = Text(", give that journal {gap} mm more", gap=mm(-gap, ".4g")) if gap < 0 else ""
    name = Text("Gap between {wheel} and the seat of the {seat} journal", wheel=wheel, seat=seat)
    advice = Text(
        "Where {wheel} does not pass through the seat of the {seat} journal{more}, cut its tip, fix it after the "
        "shaft is inserted, or split the support.",
        wheel=wheel,
        seat=seat,
        more=more,
    )
    rule, at = (SHAFT_ASSEMBLY, (shaft,)) if shaft else (ASSEMBLY, ())
    return rule(gap, 0.0, at=at, name=name, advice=advice, scale=USUAL_CLEARANCE)
