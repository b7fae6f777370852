# SPDX-License-Identifier: Apache-2.0
"""Firing: the order from the crank, the crank's use by an order, and how even the intervals are.

A cylinder fires at one of its top dead centres.  Angles are crank angles after the firing of cylinder 1, over the working cycle:
720° of a four-stroke engine, 360° of a two-stroke.  An offset cylinder shifts every dead centre alike and changes nothing here.
"""

import math
from dataclasses import replace

import numpy as np

from ..sheet.arrays import Array
from ..sheet.record import record
from ..sheet.text import EMPTY, Text

TURN = 2 * math.pi
DUST = 1e-9  # of a turn: two dead centres nearer than this are one


@record
class Firing:
    """`order` of the cylinders, numbered from 1; `angles` one per cylinder [rad]; `intervals` in the order, the last one to cylinder 1.

    `chosen`: what the crank and the order leave open, and how it was taken.
    """

    order: tuple[int, ...]
    angles: Array
    intervals: Array
    chosen: Text = EMPTY


def dead_centres(phi: Array, psi: Array) -> Array:
    """The crank angle after TDC of cylinder 1 at which each piston stands at TDC, from 0 up to a turn."""
    angle = (psi - phi - (psi[0] - phi[0])) % TURN
    return np.where(TURN - angle < DUST * TURN, 0.0, angle)


def in_order(phi: Array, psi: Array, strokes: int, order: tuple[int, ...]) -> Firing | None:
    """The firing of a crank in a given order; None where this crank can not fire so within one cycle."""
    k = np.asarray(order) - 1
    at = dead_centres(phi, psi)[k]
    gaps = (np.roll(at, -1) - at) % TURN
    gaps[(gaps < DUST * TURN) | (TURN - gaps < DUST * TURN)] = 0.0
    idle = round((strokes * math.pi - float(np.sum(gaps))) / TURN)  # whole turns that the dead centres leave over
    if idle < 0:
        return None
    chosen = EMPTY
    for _ in range(idle):  # pistons that stand at TDC together fire a turn apart; what is left lies before cylinder 1
        together = np.flatnonzero(gaps == 0.0)
        gaps[together[0] if together.size else -1] += TURN
        if not together.size and len(order) > 1:
            chosen = Text("The order leaves a whole turn without firing; it is taken before cylinder 1.")
    angles = np.empty(len(order))
    angles[k] = np.concatenate(([0.0], np.cumsum(gaps)[:-1]))
    return Firing(order, angles, gaps, chosen)


def most_even(phi: Array, psi: Array, strokes: int, usual: tuple[int, ...] = ()) -> Firing:
    """The most even of all firings that a crank allows; among equals the usual one, or else the first by number."""
    found = evenest(phi, psi, strokes, usual)
    said = Text(
        "The firing order is chosen: one of {count} equally even ways in which this crank can fire; give firing_order for another.",
        count=len(found),
    )
    return replace(found[0], chosen=said if len(found) > 1 else EMPTY)


def evenest(phi: Array, psi: Array, strokes: int, usual: tuple[int, ...] = ()) -> list[Firing]:
    """All the equally most even firings of a crank.  A four-stroke cylinder may fire at either of its two dead centres in the cycle."""
    cycle = strokes * math.pi
    n = phi.size
    ways = (strokes // 2) ** (n - 1)
    turns = (np.arange(ways)[:, None] >> np.arange(n - 1)[::-1]) & 1
    at = dead_centres(phi, psi) + TURN * np.column_stack([np.zeros(ways), turns])
    place = np.argsort(at, axis=1, kind="stable")
    sorted_ = np.take_along_axis(at, place, 1)
    gaps = np.diff(np.column_stack([sorted_, np.full(ways, cycle)]), axis=1)
    unevenness = np.abs(gaps - cycle / n).max(1)
    best = np.flatnonzero(unevenness <= unevenness.min() + 1e-9)
    orders = sorted((tuple((place[i] + 1).tolist()), i) for i in best)
    orders.sort(key=lambda found: found[0] != usual)
    return [Firing(order, at[i], gaps[i]) for order, i in orders]
