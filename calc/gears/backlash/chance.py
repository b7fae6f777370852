# SPDX-License-Identifier: Apache-2.0
"""Many trains by chance: all centre distances and tooth thicknesses at once, what play each train has, and how many can
jam.

Each part that can deviate takes every 4096th of its distribution once, in an order of its own: a Latin hypercube, which
tells a sum of deviations far better than numbers drawn freely do.  The orders come from a fixed generator, so that
every run meets the same trains; the parts of a stack are sorted first, so that they may be listed in any order.  Every
part is independent of the others, and the tooth thickness of a wheel is the same in both its meshes."""

from collections.abc import Mapping, Sequence
from functools import cache
from math import ceil

import numpy as np

from ...sheet.arrays import Array
from ...sheet.formula import formula
from ...sheet.record import record
from ...sheet.text import Text
from ...sheet.units import Metre, Metres, Number, Radian, Radians
from ...sheet.value import about, based_on
from ..tree import Tree
from .case import EVEN, BacklashCase
from .formulas import DUST

TRAINS = 4096
KEPT: Number = 0.99  # share of the trains that must turn freely
BY_CHANCE = Text("mathematics, {trains} trains by chance", trains=TRAINS)


@formula(
    "j_bn,p",
    Text("{by_chance}: normal backlash that a share of the trains keeps", by_chance=BY_CHANCE),
    unit="µm",
    shows="the largest backlash that the share p of the trains keeps",
)
def kept(j: Metres, p: Number) -> Metre:
    """`j` (trains,) in rising order."""
    size = j.size
    return float(j[size - ceil(p * size)])


@formula(
    "Δφ_p",
    Text("{by_chance}: free turn that a share of the trains keeps", by_chance=BY_CHANCE),
    shows="the smallest free turn that the share p of the trains does not exceed",
)
def not_exceeded(phi: Radians, p: Number) -> Radian:
    """`phi` (trains,) in rising order."""
    return float(phi[ceil(p * phi.size) - 1])


@formula("p_jam", BY_CHANCE, unit="%", shows="trains with a backlash below 0, over all trains")
def share_below_zero(j: Metres) -> Number:
    """`j` (trains,) in rising order."""
    return int(np.sum(j < -DUST)) / j.size


@record
class Chance:
    """What the trains by chance have; arrays in rising order."""

    smallest: dict[str, Array]  # backlash by mesh, the smallest over a turn; only where something varies
    best: dict[str, Metre]  # that 99 % keep, by the runouts that are given alone
    tightest: Array  # of each train, its smallest backlash
    phase: dict[str, Array]  # free turn of the wheel of each shaft


@cache
def _even(k: int) -> Array:
    """Middles of the 4096 equal parts of 0 to 1, in the k-th order: that of the numbers of SplitMix64 (Steele, Lea,
    Flood 2014)."""
    z = (np.arange(TRAINS, dtype=np.uint64) + np.uint64(k * TRAINS + 1)) * np.uint64(0x9E3779B97F4A7C15)
    for shift, factor in ((30, 0xBF58476D1CE4E5B9), (27, 0x94D049BB133111EB), (31, 1)):
        z = (z ^ (z >> np.uint64(shift))) * np.uint64(factor)
    numbers: Array = (np.argsort(z) + 0.5) / TRAINS
    return numbers


@cache
def deviate(kind: str, k: int) -> Array:
    """What a part of this kind shifts along the line of centres in each train, over half its field; a position takes k
    and k + 1."""
    if kind == EVEN:
        return 2 * _even(k) - 1
    cosine: Array = np.cos(2 * np.pi * _even(k))
    return cosine * np.sqrt(_even(k + 1)) if kind == "position" else cosine


def by_chance(
    cases: Sequence[BacklashCase], tree: Tree, ends: Sequence[str], lags: Mapping[str, Radian]
) -> Chance | None:
    """`ends`: the wheels whose free turn is asked for; `lags`: of the chains and belts, which is the same in every
    train.  None where nothing deviates."""
    used = 0

    def luck(kind: str = EVEN) -> Array:
        nonlocal used
        k, used = used, used + (2 if kind == "position" else 1)
        return deviate(kind, k)

    teeth: dict[str, Array | Metre] = {}
    for m in cases:
        for wheel, t in zip((m.driver, m.driven), m.teeth):
            if wheel.name not in teeth:
                half = (t.thickest - t.thinnest) / 2
                teeth[wheel.name] = t.middle + half * luck() if half else t.middle
    smallest: dict[str, Array] = {}
    best: dict[str, Metre] = {}
    backlash: dict[str, Array] = {}  # by mesh, none below 0
    every = []
    for m in cases:
        a: Array | Metre = m.mesh.centre_distance
        if m.stack is not None:
            for field, kind in sorted(zip(m.stack.fields.tolist(), m.stack.kinds)):
                a = a + field / 2 * luck(kind)
        elif m.mesh.centre_tolerance:
            a = a + m.mesh.centre_tolerance * luck()
        both = teeth[m.driver.name] + teeth[m.driven.name]
        loose, least = _backlash(m, a, both), _backlash(m, a - m.eccentricity, both)
        backlash[m.key] = np.maximum(loose, 0.0)
        if isinstance(least, np.ndarray):
            every.append(least)
            smallest[m.key] = based_on(np.sort(least), *_of(m))
            best[m.key] = kept.function(np.sort(_backlash(m, a - m.least_eccentricity, both)), KEPT)
    if not every:
        return None
    tightest = based_on(np.sort(np.min(every, axis=0)), *(_of(m) for m in cases))
    by_key = {m.key: m for m in cases}
    return Chance(smallest, best, tightest, {end: _free_turn(tree, end, by_key, backlash, lags) for end in ends})


def _free_turn(
    tree: Tree, end: str, cases: Mapping[str, BacklashCase], backlash: Mapping[str, Array], lags: Mapping[str, Radian]
) -> Array:
    """The free turn of a wheel in each train, in rising order, from the backlash of each mesh, none below 0."""
    turn: Array | float = 0.0
    of: list[object] = []
    for link in tree.way(end):
        z, z_end = tree.reduction(link, end)
        ratio = z / z_end
        if link.toothed:
            m = cases[link.key]
            per_backlash = ratio / np.cos(m.system.base_helix_angle) / (m.driven.base_diameter / 2)
            turn = turn + backlash[link.key] * per_backlash
            of += [*_of(m), z, z_end]
        elif link.key in lags:
            turn = turn + lags[link.key] * ratio
            of += [lags[link.key], z, z_end]
    return based_on(np.sort(np.broadcast_to(turn, TRAINS)), *of)


def _of(m: BacklashCase) -> tuple[object, ...]:
    """What the backlash of a mesh by chance depends on."""
    field = m.mesh.centre_tolerance if m.stack is None else m.stack.fields
    bases = m.driver.base_diameter, m.driven.base_diameter, m.system.base_pitch, m.system.base_helix_angle
    return m.mesh.centre_distance, field, m.teeth, m.runouts, *bases


def _backlash(m: BacklashCase, a: Array | Metre, both: Array | Metre) -> Array | Metre:
    """Exact, as by `backlash_of_bases`, without a tangent: this runs for every train, all (trains,) at once."""
    r = m.touching
    involute = np.sqrt(a * a - r * r) / r - np.arccos(r / a)
    j: Array | Metre = (m.system.base_pitch - both + 2 * r * involute) * np.cos(m.system.base_helix_angle)
    return j


def of_mesh(m: BacklashCase, chance: Chance | None) -> dict[str, float]:
    """The values of one mesh; none where nothing in it varies."""
    if chance is None or m.key not in chance.smallest:
        return {}
    j = chance.smallest[m.key]
    with about(Text("mesh {name}, by chance", name=m.name)):
        return dict(backlash_median=kept(j=j, p=0.5), backlash_99=kept(j=j, p=KEPT), share_jammed=share_below_zero(j=j))


def of_train(end: str, chance: Chance | None) -> dict[str, float]:
    """The values of the wheel of a shaft; none where nothing varies."""
    if chance is None:
        return {}
    phi = chance.phase[end]
    with about(Text("train, to {last}, by chance", last=end)):
        shares = {"median": 0.5, "95": 0.95, "99": 0.99}
        values = {f"phase_error_{name}": not_exceeded(phi=phi, p=p) for name, p in shares.items()}
        return dict(**values, share_jammed=share_below_zero(j=chance.tightest))
