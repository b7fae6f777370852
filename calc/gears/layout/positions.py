# SPDX-License-Identifier: Apache-2.0
"""Where the axes stand: given, found by two circles, or chosen where a chain of two wheels leaves one angle free.

A wheel between two placed ones stands where the circles of its centre distances cross: twice, or never.  Two open
wheels in a row can turn about their ends like a linkage: the place with the most room is taken.  More of them get no
place, but whether they span the distance of their ends is judged all the same."""

import math
from collections.abc import Iterable, Iterator, Mapping
from itertools import pairwise, product

from ...sheet.check import Check
from ...sheet.record import record
from ...sheet.text import Amount, Name, Text, listed
from ...sheet.units import Metre
from ...sheet.value import about, based_on, untraced
from ..inputs import GearsInputs
from ..limits import mm
from ..result import MeshResult, TrainResult
from . import formulas as f
from .room import Room, at, axis_check, bowed, distance_check, most_room, reach_check, unplaced_check

SAME = 1e-9  # m: two points that are no further apart are one
TIED = 1e-9  # m: so little more room does not tell two places apart
FAR = 100.0  # m: as good as nothing near
MOST = 6  # wheels whose two places each are tried in all combinations
Mates = Mapping[str, MeshResult]  # the meshes of a wheel by its mates
Axes = Mapping[str, complex]  # of the shafts that have a given one, from the crank's, by their names
NO_AXES: Axes = {}


class Placing:
    """The places of the wheels, and how each came to it."""

    def __init__(self) -> None:
        self.p: dict[str, complex] = {}
        self.by: dict[str, Text] = {}
        self.checks: list[Check] = []
        self.notes: list[Text] = []
        self.solutions: list[tuple[str, str, complex, Metre, bool]] = []  # wheel, between, place, clearance, chosen

    def put(self, wheel: str, p: complex, by: Text) -> None:
        self.p[wheel], self.by[wheel] = p, by


@record
class Between:
    """An open wheel and two placed neighbours of it: c apart; `tolerance` within which their distance may miss the
    range."""

    wheel: str
    first: str
    second: str
    a_12: Metre
    a_23: Metre
    tolerance: Metre
    others: list[tuple[str, Metre]]  # further placed neighbours


def allowed(train: TrainResult, mesh: MeshResult) -> Metre:
    """How far given axes may miss a centre distance: its tolerance, at least 10⁻³ m_n (rule of this program)."""
    return max(mesh.centre_tolerance, 1e-3 * train.system.m_n)


def place(gears: GearsInputs, train: TrainResult, room: Room, axes: Mapping[str, complex]) -> Placing:
    """`axes`: of the shafts that have a given one, from the crank's, by the wheel on each."""
    placing = Placing()
    _anchors(gears, train, placing, axes)
    if not placing.p:
        placing.notes.append(
            Text(
                "Positions of the wheels are not given: nothing is said about clearances, assembly phase and included "
                "angles. They follow from the axis of the shaft or the position of a wheel."
            )
        )
        return placing
    along = [name for name in gears.along if name in train.wheels]
    beside: dict[str, dict[str, MeshResult]] = {name: {} for name in along}  # the meshes of a wheel by its mates
    for mesh in train.meshes.values():
        beside[mesh.driver][mesh.driven] = beside[mesh.driven][mesh.driver] = mesh
    failed: set[str] = set()
    while True:
        still = [name for name in along if name not in placing.p and name not in failed]
        idlers = [idler for name in still if (idler := _between(name, beside[name], placing, train)) is not None]
        if idlers:
            failed |= _settle(idlers, placing, room)
            continue
        pair = _open_pair(still, beside, placing)
        if pair is None:
            break
        if not _swing(*pair, beside, placing, room, train):
            failed |= set(pair)
    rows = [*_rows(along, failed, beside, placing)]
    _judge(rows, beside, placing, room)
    in_rows = {name for row in rows for name in row}
    if open_ := [name for name in along if name not in placing.p and name not in in_rows]:
        placing.notes.append(
            Text(
                "{open}: no place, since nothing fixes it or its neighbours are out of reach: give "
                "the position of {open2}.",
                open=", ".join(open_),
                open2=open_[0],
            )
        )
    _contradictions(train, placing, {w.name for w in gears.wheels if w.position is not None})
    return placing


def _anchors(gears: GearsInputs, train: TrainResult, placing: Placing, axes: Mapping[str, complex]) -> None:
    """What is given: positions of wheels, the axes of the shafts for the wheels on them, and the crank's for the
    first."""
    for wheel in gears.wheels:
        if wheel.position is not None:
            placing.put(wheel.name, at(wheel.position), Text("given"))
    for name, axis in axes.items():
        if name in placing.p:
            placing.checks.append(axis_check(name, abs(placing.p[name] - axis), 1e-3 * train.system.m_n))
        elif name in train.wheels:
            placing.put(name, axis, Text("counter-shaft"))
    if placing.p and gears.first not in placing.p and gears.first in train.wheels:
        placing.put(gears.first, 0j, Text("crank"))


def axes_apart(gears: GearsInputs, axes: Axes) -> dict[int, Metre]:
    """The distance of the axes of each mesh, by its number, whose wheels both have a given place."""
    first, placed = gears.first, {gears.carrier(shaft): axis for shaft, axis in axes.items()}
    placed |= {wheel.name: at(wheel.position) for wheel in gears.wheels if wheel.position is not None}
    placed = {first: 0j} | placed if placed else placed
    return {
        i: abs(placed[m.driven] - placed[m.driver])
        for i, m in enumerate(gears.meshes)
        if m.driver in placed and m.driven in placed
    }


def _between(name: str, beside: Mates, placing: Placing, train: TrainResult) -> Between | None:
    placed = [(mate, mesh) for mate, mesh in beside.items() if mate in placing.p]
    if len(placed) < 2:
        return None
    (first, m_1), (second, m_2), *others = placed
    tolerance, further = allowed(train, m_1) + allowed(train, m_2), [(w, m.centre_distance) for w, m in others]
    return Between(name, first, second, m_1.centre_distance, m_2.centre_distance, tolerance, further)


# --- one open wheel


def _settle(idlers: list[Between], placing: Placing, room: Room) -> set[str]:
    """Every wheel that has two placed neighbours; returns those that can not reach both."""
    by_name = {idler.wheel: idler for idler in idlers}
    sides = {name: _sides(idler, placing) for name, idler in by_name.items()}
    places = {name: [(_solve(by_name[name], placing, s), s) for s in sides[name]] for name in by_name if sides[name]}
    names = list(places)
    for group in [names] if len(names) <= MOST else [[name] for name in names]:
        _choose(group, places, by_name, placing, room)
    return set(by_name) - set(places)


def _sides(idler: Between, placing: Placing) -> tuple[float, ...]:
    """The sides on which the circles cross, none where they miss each other; the check says by how much."""
    names = {"wheel": idler.wheel, "first": idler.first, "second": idler.second}
    c, tolerance = abs(placing.p[idler.second] - placing.p[idler.first]), idler.tolerance
    low, high = abs(idler.a_12 - idler.a_23), idler.a_12 + idler.a_23
    wheel, first, second = idler.wheel, idler.first, idler.second
    placing.checks.append(reach_check(wheel, Name(wheel), first, second, c, low, high, tolerance))
    if c < SAME:
        placing.notes.append(
            Text("{first} and {second} have one axis: {wheel} can stand in any direction from it.", **names)
        )
        return ()
    if not low - tolerance <= c <= high + tolerance:
        return ()
    if c > high or c < low:
        miss = Amount((c - high if c > high else low - c) * 1e6)
        placing.notes.append(
            Text(
                "The centre distances of {wheel} miss {first} and {second} by {miss} µm, within the tolerance: it is "
                "set on their line of centres.",
                **names,
                miss=miss,
            )
        )
        return (0.0,)
    return (1.0, -1.0) if idler.a_12**2 > f.chord_foot.function(c, idler.a_12, idler.a_23) ** 2 else (0.0,)


def _solve(idler: Between, placing: Placing, s: float) -> complex:
    """The crossing of the circles on the side `s`; 0: on the line of centres."""
    p_1, p_3 = placing.p[idler.first], placing.p[idler.second]
    c, gamma = f.axes_apart(p_1=p_1, p_3=p_3), f.line_of_centres(p_1=p_1, p_3=p_3)
    u = f.chord_foot(c=c, a_12=idler.a_12, a_23=idler.a_23)
    if not s or idler.a_12**2 <= u**2:
        return f.on_line(p_1=p_1, gamma=gamma, u=u)
    return f.on_two_circles(p_1=p_1, gamma=gamma, u=u, v=f.half_chord(a_12=idler.a_12, u=u), s=s)


def _choose(
    names: list[str],
    places: Mapping[str, list[tuple[complex, float]]],
    idlers: Mapping[str, Between],
    placing: Placing,
    room: Room,
) -> None:
    """The combination of places that fits further neighbours best, and then has the most room at its tightest wheel."""

    def rank(points: tuple[tuple[complex, float], ...]) -> tuple[int, list[int]]:
        there = {**placing.p, **{name: p for name, (p, _) in zip(names, points)}}
        miss = sum(abs(abs(there[n] - placing.p[w]) - a) for n in names for w, a in idlers[n].others)
        return -round(miss / SAME), sorted(round(min(room.around(n, there[n], there), FAR) / TIED) for n in names)

    best = max(product(*(places[name] for name in names)), key=rank)
    there = {**placing.p, **{name: p for name, (p, _) in zip(names, best)}}
    for name, (_, s) in zip(names, best):
        idler = idlers[name]
        between = Text("{first} and {second}", first=idler.first, second=idler.second)
        free = {side == s: room.around(name, other, {**there, name: other}) for other, side in places[name]}
        placing.solutions += [(name, between, other, free[side == s], side == s) for other, side in places[name]]
        with about(Text("wheel {name}, place", name=name)):
            placing.put(name, _solve(idler, placing, s), Text("two circles"))
        placing.notes.append(_choice(idler, placing.p[name], free))


def _choice(idler: Between, p: complex, free: Mapping[bool, Metre]) -> Text:
    """`free`: the room at the place that was chosen (True), and at the other if there is one."""
    where = Text(
        "{wheel} between {first} and {second}: [{real}, {imag}] mm",
        wheel=idler.wheel,
        first=idler.first,
        second=idler.second,
        real=mm(p.real, ".4f"),
        imag=mm(p.imag, ".4f"),
    )
    if len(free) < 2:
        return Text("{where}, on their line of centres.", where=where)
    if idler.others:
        return Text("{where}, of two places that which fits the other wheels that it meshes with.", where=where)
    if not math.isfinite(free[True]) or abs(free[True] - free[False]) <= 2 * TIED:
        return Text(
            "{where}, of two places the one further in the sense of crank rotation: "
            "nothing near them tells them apart.",
            where=where,
        )
    return Text(
        "{where}, of two places the one with more room: {room} mm, the other {room2} mm.",
        where=where,
        room=mm(free[True]),
        room2=mm(free[False]),
    )


# --- two open wheels in a row


def _open_pair(still: list[str], beside: Mapping[str, Mates], placing: Placing) -> tuple[str, str] | None:
    held = [name for name in still if any(mate in placing.p for mate in beside[name])]
    return next(((wheel, mate) for wheel in held for mate in beside[wheel] if mate in held), None)


def _swing(one: str, two: str, beside: Mapping[str, Mates], placing: Placing, room: Room, train: TrainResult) -> bool:
    """Both wheels at the free angle that leaves the tighter of them the most room; False where they can not reach."""
    first = next(mate for mate in beside[one] if mate in placing.p)
    last = next(mate for mate in beside[two] if mate in placing.p)
    m_1, m_2, m_3 = beside[one][first], beside[one][two], beside[two][last]
    a_1, a_2, a_3 = m_1.centre_distance, m_2.centre_distance, m_3.centre_distance
    c, high = abs(placing.p[last] - placing.p[first]), a_1 + a_2 + a_3
    low = max(2 * max(a_1, a_2, a_3) - high, 0.0)
    placing.checks.append(reach_check(one, Text("{one} and {two}", one=one, two=two), first, last, c, low, high, 0.0))
    if not low <= c <= high:
        return False
    with untraced():
        chosen = most_room(room, placing.p, (first, one, two, last), (a_1, a_2, a_3))
    if chosen is None:
        return False
    phi, s, clearance = chosen
    phi = based_on(phi, placing.p[first], placing.p[last], a_1, a_2, a_3)
    with about(Text("wheel {one}, place", one=one)):
        placing.put(one, f.on_circle(p_1=placing.p[first], a_12=a_1, phi=phi), Text("chosen"))
    with about(Text("wheel {two}, place", two=two)):
        between = Between(two, one, last, a_2, a_3, allowed(train, m_2) + allowed(train, m_3), [])
        placing.put(two, _solve(between, placing, s), Text("chosen"))
    placed = ((name, placing.p[name]) for name in (one, two))
    places = listed(
        Text("{n} [{real}, {imag}] mm", n=name, real=mm(p.real, ".4f"), imag=mm(p.imag, ".4f")) for name, p in placed
    )
    placing.notes.append(
        Text(
            "{one} and {two} between {first} and {last}: one angle is free; chosen: {places}, where the tighter of "
            "them has the most room, {clearance} mm. Walls and neighbours that are not given are not heeded: give "
            "the position of {one}.",
            one=one,
            two=two,
            first=first,
            last=last,
            places=places,
            clearance=mm(clearance),
        )
    )
    return True


# --- three and more open wheels in a row


def _rows(
    along: list[str], failed: Iterable[str], beside: Mapping[str, Mates], placing: Placing
) -> Iterator[tuple[str, ...]]:
    """The rows of open wheels between two placed ones, these at their ends."""
    ways: list[tuple[str, ...]] = [
        (end, name) for end in along if end in placing.p for name in beside[end] if name not in placing.p
    ]
    while ways:
        way = ways.pop(0)
        for mate in beside[way[-1]]:
            if mate in way or way[-1] in failed:
                continue
            if mate not in placing.p:
                ways.append((*way, mate))
            elif along.index(way[0]) < along.index(mate):
                yield (*way, mate)


def _judge(rows: Iterable[tuple[str, ...]], beside: Mapping[str, Mates], placing: Placing, room: Room) -> None:
    """Whether each row spans the distance of its ends; where it does, its wheels could stand in many places, of which
    one is proposed."""
    proposed: dict[str, complex] = {}
    for row in rows:
        first, *names, last = row
        if names[0] in proposed:  # of two branches
            names.reverse()
        a = tuple(beside[wheel][mate].centre_distance for wheel, mate in pairwise(row))
        c, high = abs(placing.p[last] - placing.p[first]), sum(a)
        low = max(2 * max(a) - high, 0.0)
        placing.checks.append(reach_check(names[0], listed(map(Name, row[1:-1])), first, last, c, low, high, 0.0))
        if not low <= c <= high:
            continue
        with untraced():
            proposed |= bowed(room, placing.p | proposed, row, a)
        placing.checks.append(unplaced_check(row[1:-1], proposed))


# --- what is given and does not fit


def _contradictions(train: TrainResult, placing: Placing, given: set[str]) -> None:
    """Meshes between placed wheels whose distance is not the centre distance."""
    for i, (key, mesh) in enumerate(train.meshes.items()):
        pair = mesh.driver, mesh.driven
        if not all(name in placing.p for name in pair):
            continue
        p_1, p_3 = (placing.p[name] for name in pair)
        fixed = all(placing.by[name] in ("given", "crank", "counter-shaft") for name in pair)
        if not fixed and abs(abs(p_3 - p_1) - mesh.centre_distance) <= SAME:
            continue
        with about(Text("mesh {pair}, place", pair=mesh.title)):
            c = f.axes_apart(p_1=p_1, p_3=p_3)
            error = f.distance_error(c=c, a_w=mesh.centre_distance)
        placing.checks.append(
            distance_check(key, i, mesh, c, error, allowed(train, mesh), [name for name in pair if name in given])
        )
