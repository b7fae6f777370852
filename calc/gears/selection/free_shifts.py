# SPDX-License-Identifier: Apache-2.0
"""Which profile shifts of a train are free, and how the others follow from them.

Wheels that a given centre distance ties together share one free shift: the mate's is the sum less it.  A mesh without
centre distance leaves one more free; it can be held where it is now, left to what the design chooses, or freed."""

from collections.abc import Mapping
from contextlib import suppress

from ...sheet.arrays import Array
from ...sheet.errors import NoSolution
from ...sheet.record import record, replace
from ...sheet.text import COMMA, Amount, Text, listed, plural
from ...sheet.units import Metre
from ..inputs import GearsInputs, wheel_key
from ..layout.positions import NO_AXES, Axes, axes_apart
from ..result import ToothSystem
from ..train import Train, settle
from ..wheel_inputs import Wheel

STARTS = (None, 0.0, 0.25, 0.5, 1.0)  # shifts at which the train is settled once; None: that of the design
STEP = 1e-3  # by which a free shift is moved to see who follows
HELD = 6  # digits of a held centre distance in metres: 1 µm, as drawings have it
SAME = 1e-12


@record
class Freedom:
    """One way to leave shifts free.  `gears`: the design put so; `removed`: keys of shifts that then follow; `held`:
    distances by mesh.

    The shift of a wheel is `start` + `sign`·(free shift − its start); `follows` names the free wheel, None where the
    shift is fixed."""

    key: str
    name: Text  # of a row
    words: Text  # what is free, and what follows
    gears: GearsInputs
    free: tuple[str, ...]
    start: Mapping[str, float]
    follows: Mapping[str, str | None]
    sign: Mapping[str, int]
    removed: tuple[str, ...]
    held: Mapping[int, Metre]

    def shifts(self, free: Mapping[str, float | Array]) -> dict[str, float | Array]:
        """The shift of every wheel, numbers or arrays."""
        shifts: dict[str, float | Array] = {}
        for name, x in self.start.items():
            shifts[name] = x
            if (leader := self.follows[name]) is not None:
                follower = x + self.sign[name] * (free[leader] - self.start[leader])
                shifts[name] = free[leader] if leader == name else follower
        return shifts

    def contains(self, other: "Freedom") -> bool:
        """Whether all that the other can reach can be reached so: where every distance is free no way has more."""
        return self.key == "free" and other.key != "free"

    def bounds(self, lowest: Mapping[str, float], highest: float) -> dict[str, tuple[float, float, str, str]]:
        """For each free shift (low, high, wheel that makes the low, wheel that makes the high): no wheel below its
        lowest or too high."""
        bounds = {}
        for leader in self.free:
            ends: tuple[list[tuple[float, str]], list[tuple[float, str]]] = ([], [])
            for name, x in self.start.items():
                if self.follows[name] == leader:
                    at = [self.start[leader] + self.sign[name] * (end - x) for end in (lowest[name], highest)]
                    ends[0].append((min(at), name))
                    ends[1].append((max(at), name))
            low, high = max(ends[0]), min(ends[1])
            bounds[leader] = (low[0], high[0], low[1], high[1])
        return bounds


def settled(gears: GearsInputs, system: ToothSystem) -> Train | None:
    """The train as it is; None where its shifts and distances contradict each other."""
    try:
        return settle(gears, system)
    except NoSolution:
        return None


def freedoms(gears: GearsInputs, system: ToothSystem, axes: Axes = NO_AXES) -> tuple[Freedom, ...]:
    """All ways, the one that is nearest to the design first.  Raises NoSolution where a given centre distance can not
    be.

    A distance between two given axes is not left free where it can be held."""
    parts = tied(gears)
    if len(parts) == 1:
        return (_freedom("train", Text("train"), gears, system, parts),)
    ways, now, apart = [], settled(gears, system), axes_apart(gears, axes)
    given = [part for part in parts if _given(gears, part)] or parts[:1]
    if len(given) < len(parts):
        designed = _freedom("designed", Text("as the design"), gears, system, given)
        ways.append(replace(designed, name=_copied(designed, gears, given)))
    if now is not None:
        held = {
            i: round(apart.get(i, now.distances[m.key]), HELD)
            for i, m in enumerate(gears.meshes)
            if m.centre_distance is None
        }
        meshes = tuple(replace(m, centre_distance=held.get(i, m.centre_distance)) for i, m in enumerate(gears.meshes))
        name = Text("distance held") if len(held) == 1 else Text("distances held")
        whole = tied(fixed := replace(gears, meshes=meshes))
        with suppress(NoSolution):  # two given axes may be too far apart, or too near, for the shifts that are tried
            ways.append(replace(_freedom("held", name, fixed, system, whole), held=held))
    name = Text("distance free") if len(parts) == 2 else Text("distances free")
    ways.append(_freedom("free", name, gears, system, parts))
    return tuple(way for way in ways if all(way.gears.meshes[i].centre_distance for i in apart)) or tuple(ways)


def tied(gears: GearsInputs) -> list[tuple[str, ...]]:
    """Wheels whose shifts hang together by given centre distances, in the order of the design."""
    part = {w.name: i for i, w in enumerate(gears.wheels)}
    for mesh in gears.meshes:
        if mesh.centre_distance is not None:
            one, two = part[mesh.driver], part[mesh.driven]
            part = {name: one if i == two else i for name, i in part.items()}
    return [tuple(name for name, i in part.items() if i == n) for n in dict.fromkeys(part.values())]


def _given(gears: GearsInputs, part: tuple[str, ...]) -> list[str]:
    return [w.name for w in gears.wheels if w.name in part and w.profile_shift is not None]


def _freedom(
    key: str, name: Text, gears: GearsInputs, system: ToothSystem, free_parts: list[tuple[str, ...]]
) -> Freedom:
    given = {n for part in free_parts for n in _given(gears, part)}
    free = tuple((_given(gears, part) or list(part))[0] for part in free_parts)
    bare = replace(
        gears, wheels=tuple(replace(w, profile_shift=None) if w.name in given - set(free) else w for w in gears.wheels)
    )
    train, at = _settled_somewhere(bare, system, free)
    follows: dict[str, str | None] = dict.fromkeys(train.shifts)
    sign = dict.fromkeys(train.shifts, 0)
    for leader in free:
        moved = settle(_at(bare, {**at, leader: at[leader] + STEP}), system)
        for wheel, x in train.shifts.items():
            if step := round((moved.shifts[wheel] - x) / STEP):
                follows[wheel], sign[wheel] = leader, step
    removed = tuple(wheel_key(w.name, Wheel.profile_shift) for w in gears.wheels if w.name in given - set(free))
    start = {w.name: train.shifts[w.name] for w in gears.wheels}
    followers = [w for w, leader in follows.items() if leader is not None and w != leader]
    return Freedom(key, name, _words(free, followers), _at(bare, at), free, start, follows, sign, removed, {})


def _words(free: tuple[str, ...], followers: list[str]) -> Text:
    words = plural("free is the shift of {wheels}", "free are the shifts of {wheels}", n=len(free), wheels=listed(free))
    if not followers:
        return Text("{free}.", free=words)
    names = COMMA.join(followers)
    return plural("{free}; {names} follows.", "{free}; {names} follow.", n=len(followers), free=words, names=names)


def _at(gears: GearsInputs, shifts: Mapping[str, float]) -> GearsInputs:
    return replace(
        gears, wheels=tuple(replace(w, profile_shift=shifts.get(w.name, w.profile_shift)) for w in gears.wheels)
    )


def _settled_somewhere(
    gears: GearsInputs, system: ToothSystem, free: tuple[str, ...]
) -> tuple[Train, dict[str, float]]:
    shifts = {w.name: w.profile_shift or 0.0 for w in gears.wheels}
    for n, start in enumerate(STARTS):
        at = {name: shifts[name] if start is None else start for name in free}
        try:
            return settle(_at(gears, at), system), at
        except NoSolution:
            if n == len(STARTS) - 1:
                raise
    raise AssertionError


def _copied(freedom: Freedom, gears: GearsInputs, given: list[tuple[str, ...]]) -> Text:
    """`crank as shaft`: what the design chooses for the wheels that nothing ties."""
    teeth = {w.name: w.teeth for w in gears.wheels}
    led = {name for part in given for name in part}
    for name, x in freedom.start.items():
        for other in led if name not in led else ():
            if teeth[other] == teeth[name] and abs(freedom.start[other] - x) < SAME:
                return Text("{wheel} as {other}", wheel=name, other=other)
    return next(
        Text("{wheel} at {x}", wheel=name, x=Amount(x, form="g"))
        for name, x in freedom.start.items()
        if name not in led
    )
