# SPDX-License-Identifier: Apache-2.0
"""Many trains by chance: all centre distances and tooth thicknesses at once, what play each train has, and how many can jam.

Each part that can deviate takes every 4096th of its distribution once, in an order of its own: a Latin hypercube, which tells a sum of
deviations far better than numbers drawn freely do.  The orders come from a fixed generator, so that every run meets the same trains.
Every part is independent of the others, and the tooth thickness of a wheel is the same in both its meshes.
"""

from collections.abc import Mapping, Sequence
from functools import cache
from math import ceil
from typing import TYPE_CHECKING, Any

import numpy as np

from ...sheet.arrays import Array
from ...sheet.formula import formula
from ...sheet.record import record
from ...sheet.trace import about
from ...sheet.units import Metre, Number, Radian
from .backlash import DUST
from .meeting import Meeting
from .stack import EVEN

if TYPE_CHECKING:
    from ..result import WheelResult

TRAINS = 4096
BY_CHANCE = f"{TRAINS} trains by chance"


@formula("j_bn,p", f"{BY_CHANCE}, order statistics", unit="µm", shows="the largest backlash that the share p of the trains keeps")
def kept(j: Metre, p: Number) -> Metre:
    """`j` in rising order."""
    ordered: Any = j
    return ordered[ordered.size - ceil(p * ordered.size)].item()


@formula("Δφ_p", f"{BY_CHANCE}, order statistics", shows="the smallest free turn that the share p of the trains does not exceed")
def not_exceeded(phi: Radian, p: Number) -> Radian:
    """`phi` in rising order."""
    ordered: Any = phi
    return ordered[ceil(p * ordered.size) - 1].item()


@formula("p_jam", BY_CHANCE, unit="%", shows="trains with a backlash below 0, over all trains")
def share_below_zero(j: Metre) -> Number:
    """`j` in rising order."""
    ordered: Any = j
    return int(np.searchsorted(ordered, -DUST)) / ordered.size


@record
class Chance:
    """What the trains by chance have; arrays in rising order."""

    smallest: dict[str, Array]  # backlash by mesh, the smallest over a turn; only where something varies
    tightest: Array  # of each train, its smallest backlash
    phase: Array  # free turn of the last wheel


@cache
def _even(k: int) -> Array:
    """Middles of the 4096 equal parts of 0 to 1, in the k-th order: that of the numbers of SplitMix64 (Steele, Lea, Flood 2014)."""
    z = (np.arange(TRAINS, dtype=np.uint64) + np.uint64(k * TRAINS + 1)) * np.uint64(0x9E3779B97F4A7C15)
    for shift, factor in ((30, 0xBF58476D1CE4E5B9), (27, 0x94D049BB133111EB), (31, 1)):
        z = (z ^ (z >> np.uint64(shift))) * np.uint64(factor)
    numbers: Array = (np.argsort(z) + 0.5) / TRAINS
    return numbers


@cache
def deviate(kind: str, k: int) -> Array:
    """What a part of this kind shifts along the line of centres in each train, over half its field; a position takes k and k + 1."""
    if kind == EVEN:
        return 2 * _even(k) - 1
    cosine: Array = np.cos(2 * np.pi * _even(k))
    return cosine * np.sqrt(_even(k + 1)) if kind == "position" else cosine


def by_chance(meetings: Sequence[Meeting], wheels: "Mapping[str, WheelResult]", way: Sequence[str], last: str) -> Chance | None:
    """`way`: keys of the meshes to the `last` wheel.  None where nothing deviates."""
    used = 0

    def luck(kind: str = EVEN) -> Array:
        nonlocal used
        k, used = used, used + (2 if kind == "position" else 1)
        return deviate(kind, k)

    teeth: dict[str, Any] = {}
    for m in meetings:
        for wheel, t in zip((m.driver, m.driven), m.teeth):
            if wheel.name not in teeth:
                half = (t.thickest - t.thinnest) / 2
                teeth[wheel.name] = t.middle + half * luck() if half else t.middle
    smallest, every, turn = {}, [], 0.0
    for m in meetings:
        a: Any = m.mesh.centre_distance
        if m.stack is not None:
            for kind, field in zip(m.stack.kinds, m.stack.fields.tolist()):
                a = a + field / 2 * luck(kind)
        elif m.mesh.centre_tolerance:
            a = a + m.mesh.centre_tolerance * luck()
        both = teeth[m.driver.name] + teeth[m.driven.name]
        loose = least = _backlash(m, a, both)
        if m.runouts:
            least = _backlash(m, a - m.eccentricity, both)
        if m.key in way:
            ratio = wheels[m.driven.name].teeth / wheels[last].teeth
            turn = turn + np.maximum(loose, 0.0) * (ratio / np.cos(m.system.base_helix_angle) / (m.driven.base_diameter / 2))
        if isinstance(least, np.ndarray):
            every.append(least)
            smallest[m.key] = np.sort(least)
    if not every:
        return None
    tightest: Any = np.sort(np.min(every, axis=0))
    phase: Any = np.sort(np.broadcast_to(turn, TRAINS))
    return Chance(smallest, tightest, phase)


def _backlash(m: Meeting, a: Any, both: Any) -> Any:
    """Exact, as by `backlash_of_bases`, without a tangent: this runs for every train."""
    r = m.touching
    involute: Any = np.sqrt(a * a - r * r) / r - np.arccos(r / a)
    return (m.system.base_pitch - both + 2 * r * involute) * np.cos(m.system.base_helix_angle)


def of_mesh(m: Meeting, chance: Chance | None) -> dict[str, Any]:
    """The values of one mesh; none where nothing in it varies."""
    ordered: Any = None if chance is None else chance.smallest.get(m.key)
    if ordered is None:
        return {}
    with about(f"mesh {m.name}, by chance"):
        return dict(backlash_median=kept(j=ordered, p=0.5), backlash_99=kept(j=ordered, p=0.99), share_jammed=share_below_zero(j=ordered))


def of_train(last: str, chance: Chance | None) -> dict[str, Any]:
    if chance is None:
        return {}
    phi: Any = chance.phase
    tightest: Any = chance.tightest
    with about(f"train, to {last}, by chance"):
        return dict(
            phase_error_median=not_exceeded(phi=phi, p=0.5), phase_error_95=not_exceeded(phi=phi, p=0.95),
            phase_error_99=not_exceeded(phi=phi, p=0.99), share_jammed=share_below_zero(j=tightest),
        )  # fmt: skip
