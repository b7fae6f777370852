# SPDX-License-Identifier: Apache-2.0
"""The free shifts that make the largest specific sliding least, among those that keep every rule.

Shifts are looked for on the lattice of round numbers that can be written into a design.  One free shift: every point of it is
looked at.  Several: a grid that narrows around its best point, which follows that point until it stays.
"""

import math
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from ...sheet.arrays import Array
from ...sheet.record import record
from ..inputs import GearsInputs
from ..result import ToothSystem
from .freedom import Freedom
from .rules import HARD_CASE, USUAL, Bar, Judged, judged, least
from .states import States, states

ROUND = 10_000  # points of the lattice per unit of the shift
HIGHEST = 3.0  # shift coefficient: the end of its input
OTHERS = 1e-3  # weight of all meshes beside the largest sliding: it decides only what the largest leaves open
GRID = {1: 41, 2: 33, 3: 15, 4: 9, 5: 7}  # points a side (odd), by the number of free shifts; there is no search for more


@record
class Case:
    """`bars`: limits to choose by, the strictest first."""

    system: ToothSystem
    gears: GearsInputs
    bars: tuple[Bar, ...] = (HARD_CASE, USUAL)


@record
class Best:
    """A point of the lattice.  `margin`: the least of all rules there; negative: no point keeps them, and this misses by least.

    `wanted`: what is made least.
    """

    free: Mapping[str, float]
    margin: float
    wanted: float


@record
class Slice:
    """Every point of the lattice along one free shift, the others standing still.  `low`, `high`: wheels whose shift ends it."""

    freedom: Freedom
    leader: str
    t: Array
    states: States
    rules: list[Judged]
    low: str
    high: str


def evaluated(case: Case, freedom: Freedom, free: Mapping[str, Any], cuts: Mapping[str, float]) -> States:
    return states(case.system, freedom.gears, freedom.shifts(free), cuts)


def ends(case: Case, freedom: Freedom) -> dict[str, tuple[float, float, str, str]]:
    one = evaluated(case, freedom, {name: freedom.start[name] for name in freedom.free}, {})
    return freedom.bounds(one.undercut_limit, HIGHEST)


def slice_of(case: Case, freedom: Freedom, at: Mapping[str, float] | None = None, bar: Bar = HARD_CASE) -> Slice | None:
    """Along the first free shift, the others at `at`; None where undercut leaves nothing between its two ends."""
    leader = freedom.free[0]
    low, high, by_low, by_high = ends(case, freedom)[leader]
    t = np.arange(_up(low), _down(high) + 1) / ROUND
    if not len(t):
        return None
    found = evaluated(case, freedom, {**(at or {}), leader: t}, {})
    return Slice(freedom, leader, t, found, judged(found, case.system, bar), by_low, by_high)


def _up(low: float) -> int:
    return math.ceil(low * ROUND - 1e-6)


def _down(high: float) -> int:
    return math.floor(high * ROUND + 1e-6)


def objective(found: States) -> Array:
    """The largest sliding, and what tells two equal ones apart."""
    meshes = np.array([found.largest_of(mesh) for mesh in found.contact_ratio])
    return np.max(meshes, axis=0) + OTHERS * np.sum(meshes, axis=0)


def first(wanted: Array, margin: Array) -> int:
    """The element that keeps every rule with the least of what is wanted; where none does, the one that misses by least."""
    kept = margin >= 0
    return int(np.argmin(np.where(kept, wanted, np.inf))) if kept.any() else int(np.argmax(margin))


def best(case: Case, freedom: Freedom, cuts: Mapping[str, float], bar: Bar, near: Iterable[Mapping[str, float]] = ()) -> Best | None:
    """None where undercut leaves no shift at all.  `near`: shifts beside which several free ones are looked for as well."""
    found = ends(case, freedom)
    low = np.array([_up(found[name][0]) for name in freedom.free])
    high = np.array([_down(found[name][1]) for name in freedom.free])
    if (low > high).any():
        return None
    if len(freedom.free) == 1 and not cuts:
        made = slice_of(case, freedom, bar=bar)
        assert made is not None
        margin = least(made.rules)
        wanted = objective(made.states)
        i = first(wanted, margin)
        return Best({freedom.free[0]: float(made.t[i])}, float(margin[i]), float(wanted[i]))
    step = np.maximum(-(-(high - low) // (GRID[len(freedom.free)] - 1)), 1)
    starts = [((low + high) // 2, step)]
    for shifts in near:
        point = np.array([round(float(shifts[name]) * ROUND) for name in freedom.free])
        starts.append((np.clip(point, low, high), np.ones_like(step)))
    reached = [_narrowed(case, freedom, cuts, bar, low, high, *start) for start in starts]
    return min(reached, key=lambda one: (0.0, one.wanted) if one.margin >= 0 else (1.0, -one.margin))


def _narrowed(case: Case, freedom: Freedom, cuts: Mapping[str, float], bar: Bar, low: Any, high: Any, centre: Any, step: Any) -> Best:
    side = GRID[len(freedom.free)]
    offsets = np.stack(np.meshgrid(*[np.arange(side) - side // 2] * len(freedom.free), indexing="ij"), -1).reshape(-1, len(freedom.free))
    while True:
        points = np.clip(centre + offsets * step, low, high)
        found = evaluated(case, freedom, dict(zip(freedom.free, points.T / ROUND)), cuts)
        margin = least(judged(found, case.system, bar))
        wanted, middle = objective(found), len(points) // 2
        i = first(wanted, margin)
        better = wanted[i] < wanted[middle] if margin[middle] >= 0 else margin[i] > margin[middle]
        centre = points[i] if better else centre
        if not better:
            if (step == 1).all():
                return Best(dict(zip(freedom.free, (centre / ROUND).tolist())), float(margin[middle]), float(wanted[middle]))
            step = np.maximum(step // 2, 1)


def refined(case: Case, freedom: Freedom, at: float, bar: Bar) -> tuple[float, float]:
    """(shift, largest sliding) of the optimum between the points of the lattice next to one, for one free shift."""
    width = 1.0 / ROUND
    for _ in range(5):
        t = np.linspace(at - width, at + width, 101)
        found = evaluated(case, freedom, {freedom.free[0]: t}, {})
        i = first(objective(found), least(judged(found, case.system, bar)))
        at, width = float(t[i]), width / 40
    return at, float(found.largest[i])
