# SPDX-License-Identifier: Apache-2.0
"""Where the axes stand: given, found by two circles, or chosen where a chain of two wheels leaves one angle free.

A wheel between two placed ones stands where the circles of its centre distances cross: twice, or never.  Two open wheels in a row
can turn about their ends like a linkage: the place with the most room is taken.  What nothing fixes gets no place.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import product
from typing import TYPE_CHECKING

from ...sheet.check import Check, check
from ...sheet.number import short
from ...sheet.trace import about, untraced
from ...sheet.units import Metre
from ..inputs import GearsInputs
from . import formulas as f
from .room import Room
from .scan import most_room

if TYPE_CHECKING:
    from ..result import MeshResult, TrainResult

SOURCE = "two circles about the fixed axes, with the working centre distances"
SAME = 1e-9  # m: two points that are no further apart are one
TIED = 1e-9  # m: so little more room does not tell two places apart
FAR = 100.0  # m: as good as nothing near
MOST = 6  # wheels whose two places each are tried in all combinations


@dataclass(slots=True)
class Placing:
    """The places of the wheels, and how each came to it."""

    p: dict[str, complex] = field(default_factory=dict)
    by: dict[str, str] = field(default_factory=dict)
    checks: list[Check] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    solutions: list[tuple[str, str, complex, Metre, bool]] = field(default_factory=list)  # wheel, between, place, clearance, chosen

    def put(self, wheel: str, p: complex, by: str) -> None:
        self.p[wheel], self.by[wheel] = p, by


@dataclass(slots=True)
class Between:
    """An open wheel and two placed neighbours of it: c apart; `tolerance` within which their distance may miss the range."""

    wheel: str
    first: str
    second: str
    a_12: Metre
    a_23: Metre
    tolerance: Metre
    others: list[tuple[str, Metre]]  # further placed neighbours


def allowed(train: "TrainResult", mesh: "MeshResult") -> Metre:
    """How far given axes may miss a centre distance: its tolerance, at least 10⁻³ m_n (rule of this program)."""
    return max(mesh.centre_tolerance, 1e-3 * train.system.m_n)


def place(gears: GearsInputs, train: "TrainResult", room: Room, shaft_axis: complex | None) -> Placing:
    placing = Placing()
    _anchors(gears, train, placing, shaft_axis)
    if not placing.p:
        placing.notes.append(
            "Positions of the wheels are not given: nothing is said about clearances, assembly phase and included angles. They follow "
            "from countershaft.axis_mm or gears.wheels.NAME.position_mm."
        )
        return placing
    meshes = tuple(train.meshes.values())
    beside = {w.name: _neighbours(w.name, meshes) for w in gears.wheels}
    failed: set[str] = set()
    while True:
        still = [w.name for w in gears.wheels if w.name not in placing.p and w.name not in failed]
        singles = [one for name in still if (one := _between(name, beside[name], placing, train)) is not None]
        if singles:
            failed |= _settle(singles, placing, room)
            continue
        pair = _open_pair(still, beside, placing)
        if pair is None:
            break
        if not _swing(*pair, beside, placing, room, train):
            failed |= set(pair)
    if open_ := [w.name for w in gears.wheels if w.name not in placing.p]:
        placing.notes.append(
            f"{', '.join(open_)}: no place, since nothing fixes it or its neighbours are out of reach: "
            f"give gears.wheels.{open_[0]}.position_mm."
        )
    _contradictions(train, placing, {w.name for w in gears.wheels if w.position is not None})
    return placing


def _anchors(gears: GearsInputs, train: "TrainResult", placing: Placing, shaft_axis: complex | None) -> None:
    """What is given: positions of wheels, the axis of the counter-shaft for the last one, and the crank's for the first."""
    first, last = gears.meshes[0].driver, gears.meshes[-1].driven
    for wheel in gears.wheels:
        if wheel.position is not None:
            placing.put(wheel.name, complex(*wheel.position), "given")
    if shaft_axis is not None:
        if last in placing.p:
            limit = 1e-3 * train.system.m_n
            placing.checks.append(
                check(
                    f"gears.{last}.axis", f"Position of {last} from the axis of the counter-shaft", abs(placing.p[last] - shaft_axis),
                    "<=", limit, "µm", "the last wheel stands on the counter-shaft; 10⁻³ m_n is a rule of this program",
                    f"Leave out gears.wheels.{last}.position_mm: countershaft.axis_mm gives it.",
                )
            )  # fmt: skip
        else:
            placing.put(last, shaft_axis, "counter-shaft")
    if placing.p and first not in placing.p:
        placing.put(first, 0j, "crank")


def _neighbours(name: str, meshes: tuple["MeshResult", ...]) -> dict[str, "MeshResult"]:
    return {m.driver if m.driven == name else m.driven: m for m in meshes if name in (m.driver, m.driven)}


def _between(name: str, beside: Mapping[str, "MeshResult"], placing: Placing, train: "TrainResult") -> Between | None:
    placed = [(mate, mesh) for mate, mesh in beside.items() if mate in placing.p]
    if len(placed) < 2:
        return None
    (first, m_1), (second, m_2), *others = placed
    tolerance = allowed(train, m_1) + allowed(train, m_2)
    return Between(name, first, second, m_1.centre_distance, m_2.centre_distance, tolerance, [(w, m.centre_distance) for w, m in others])


# --- one open wheel --------------------------------------------------------------------------------------------------------
def _settle(singles: list[Between], placing: Placing, room: Room) -> set[str]:
    """Every wheel that has two placed neighbours; returns those that can not reach both."""
    found: dict[str, list[tuple[complex, float]]] = {}
    by_name = {one.wheel: one for one in singles}
    for one in singles:
        if sides := _reach(one, placing):
            found[one.wheel] = [(_solve(one, placing, s), s) for s in sides]
    names = list(found)
    for group in [names] if len(names) <= MOST else [[name] for name in names]:
        _choose(group, found, by_name, placing, room)
    return set(by_name) - set(found)


def _reach(one: Between, placing: Placing) -> tuple[float, ...]:
    """The sides on which the circles cross, none where they miss each other; the check says by how much."""
    c = abs(placing.p[one.second] - placing.p[one.first])
    low, high = abs(one.a_12 - one.a_23), one.a_12 + one.a_23
    placing.checks.append(_reach_check(f"gears.{one.wheel}.position", one.wheel, one.first, one.second, c, low, high, one.tolerance))
    if c < SAME:
        placing.notes.append(f"{one.first} and {one.second} have one axis: {one.wheel} can stand in any direction from it.")
        return ()
    if not low - one.tolerance <= c <= high + one.tolerance:
        return ()
    if c > high or c < low:
        miss = c - high if c > high else low - c
        placing.notes.append(
            f"The centre distances of {one.wheel} miss {one.first} and {one.second} by {short(miss * 1e6)} µm, within the tolerance: "
            "it is set on their line of centres."
        )
        return (0.0,)
    return (1.0, -1.0) if one.a_12**2 > f.chord_foot.function(c, one.a_12, one.a_23) ** 2 else (0.0,)


def _reach_check(id: str, what: str, first: str, second: str, c: Metre, low: Metre, high: Metre, tolerance: Metre) -> Check:
    limits = max(low - tolerance, 0.0), high + tolerance
    if c > limits[1]:
        do = f"bring them at least {short((c - high) * 1e3)} mm closer, or give larger centre distances or more teeth between them"
    elif c < limits[0]:
        do = f"set them at least {short((low - c) * 1e3)} mm further apart, or make the centre distances more alike"
    else:
        do = "near a limit small errors of the axes move the wheel between them far"
    advice = f"{first} and {second} must stand {short(low * 1e3, 6)} to {short(high * 1e3, 6)} mm apart for {what} to reach both: {do}."
    return check(id, f"Distance {first} to {second} that {what} spans", c, "in", limits, "mm", SOURCE, advice)


def _solve(one: Between, placing: Placing, s: float) -> complex:
    p_1, p_3 = placing.p[one.first], placing.p[one.second]
    c, gamma = f.axes_apart(p_1=p_1, p_3=p_3), f.line_of_centres(p_1=p_1, p_3=p_3)
    u = f.chord_foot(c=c, a_12=one.a_12, a_23=one.a_23)
    if not s or one.a_12**2 <= u**2:
        return f.on_line(p_1=p_1, gamma=gamma, u=u)
    return f.on_two_circles(p_1=p_1, gamma=gamma, u=u, v=f.half_chord(a_12=one.a_12, u=u), s=s)


def _choose(
    names: list[str], found: Mapping[str, list[tuple[complex, float]]], singles: Mapping[str, Between], placing: Placing, room: Room
) -> None:
    """The combination of places that fits further neighbours best, and then has the most room at its tightest wheel."""

    def rank(points: tuple[tuple[complex, float], ...]) -> tuple[int, list[int]]:
        there = {**placing.p, **{name: p for name, (p, _) in zip(names, points)}}
        miss = sum(abs(abs(there[n] - placing.p[w]) - a) for n in names for w, a in singles[n].others)
        return -round(miss / SAME), sorted(round(min(room.around(n, there[n], there), FAR) / TIED) for n in names)

    best = max(product(*(found[name] for name in names)), key=rank)
    there = {**placing.p, **{name: p for name, (p, _) in zip(names, best)}}
    for name, (_, s) in zip(names, best):
        one = singles[name]
        between = f"{one.first} and {one.second}"
        for other, side in found[name]:
            clearance = room.around(name, other, {**there, name: other})
            placing.solutions.append((name, between, other, clearance, side == s))
        with about(f"wheel {name}, place"):
            placing.put(name, _solve(one, placing, s), "two circles")
        placing.notes.append(_said(one, placing.p[name], [r for r in placing.solutions if r[0] == name]))


def _said(one: Between, p: complex, rows: list[tuple[str, str, complex, Metre, bool]]) -> str:
    where = f"{one.wheel} between {one.first} and {one.second}: [{p.real * 1e3:.4f}, {p.imag * 1e3:.4f}] mm"
    if len(rows) < 2:
        return f"{where}, on their line of centres."
    room = {chosen: clearance for *_, clearance, chosen in rows}
    if one.others:
        return f"{where}, of two places that which fits the other wheels that it meshes with."
    if not math.isfinite(room[True]) or abs(room[True] - room[False]) <= 2 * TIED:
        return f"{where}, of two places the one further in the sense of crank rotation: nothing near them tells them apart."
    return f"{where}, of two places the one with more room: {short(room[True] * 1e3)} mm, the other {short(room[False] * 1e3)} mm."


# --- two open wheels in a row ----------------------------------------------------------------------------------------------
def _open_pair(still: list[str], beside: Mapping[str, Mapping[str, "MeshResult"]], placing: Placing) -> tuple[str, str] | None:
    held = [name for name in still if any(mate in placing.p for mate in beside[name])]
    return next(((one, other) for one in held for other in beside[one] if other in held), None)


def _swing(
    one: str, two: str, beside: Mapping[str, Mapping[str, "MeshResult"]], placing: Placing, room: Room, train: "TrainResult"
) -> bool:
    """Both wheels at the free angle that leaves the tighter of them the most room; False where they can not reach."""
    first = next(mate for mate in beside[one] if mate in placing.p)
    last = next(mate for mate in beside[two] if mate in placing.p)
    m_1, m_2, m_3 = beside[one][first], beside[one][two], beside[two][last]
    a_1, a_2, a_3 = m_1.centre_distance, m_2.centre_distance, m_3.centre_distance
    c, high = abs(placing.p[last] - placing.p[first]), a_1 + a_2 + a_3
    low = max(2 * max(a_1, a_2, a_3) - high, 0.0)
    placing.checks.append(_reach_check(f"gears.{one}.position", f"{one} and {two}", first, last, c, low, high, 0.0))
    if not low <= c <= high:
        return False
    with untraced():
        chosen = most_room(room, placing.p, (first, one, two, last), (a_1, a_2, a_3))
    if chosen is None:
        return False
    phi, s, clearance = chosen
    with about(f"wheel {one}, place"):
        placing.put(one, f.on_circle(p_1=placing.p[first], a_12=a_1, phi=phi), "chosen")
    with about(f"wheel {two}, place"):
        between = Between(two, one, last, a_2, a_3, allowed(train, m_2) + allowed(train, m_3), [])
        placing.put(two, _solve(between, placing, s), "chosen")
    places = " and ".join(f"{n} [{placing.p[n].real * 1e3:.4f}, {placing.p[n].imag * 1e3:.4f}] mm" for n in (one, two))
    placing.notes.append(
        f"{one} and {two} between {first} and {last}: one angle is free; chosen: {places}, where the tighter of them has the most room, "
        f"{short(clearance * 1e3)} mm. Walls and neighbours that are not given are not heeded: give gears.wheels.{one}.position_mm."
    )
    return True


# --- what is given and does not fit ----------------------------------------------------------------------------------------
def _contradictions(train: "TrainResult", placing: Placing, given: set[str]) -> None:
    """Meshes between placed wheels whose distance is not the centre distance."""
    for i, (key, mesh) in enumerate(train.meshes.items()):
        if mesh.driver not in placing.p or mesh.driven not in placing.p:
            continue
        p_1, p_3 = placing.p[mesh.driver], placing.p[mesh.driven]
        fixed = all(placing.by[name] in ("given", "crank", "counter-shaft") for name in (mesh.driver, mesh.driven))
        if not fixed and abs(abs(p_3 - p_1) - mesh.centre_distance) <= SAME:
            continue
        with about(f"mesh {mesh.driver}–{mesh.driven}, place"):
            c = f.axes_apart(p_1=p_1, p_3=p_3)
            error = f.distance_error(c=c, a_w=mesh.centre_distance)
        wrong = [name for name in (mesh.driver, mesh.driven) if name in given]
        advice = f"The axes stand {c * 1e3:.4f} mm apart, the centre distance is {mesh.centre_distance * 1e3:.4f} mm: "
        advice += f"give gears.meshes.{i}.centre_distance_mm = {c * 1e3:.4f}"
        advice += f", or move {' or '.join(wrong)} (position_mm)." if wrong else "."
        placing.checks.append(
            check(
                f"gears.{key}.position", f"Axes of {mesh.driver} and {mesh.driven} off their centre distance", error, "<=",
                allowed(train, mesh), "µm", "tolerance of the centre distance, at least 10⁻³ m_n (rule of this program)", advice,
            )
        )  # fmt: skip
