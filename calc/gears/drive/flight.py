# SPDX-License-Identifier: Apache-2.0
"""Bodies that fly between two flanks and strike without rebound: many at once, event by event.

A lane is one body at one operating point.  y = x_driver − x_driven lies between 0, the driving flank, and −J, the coast
flank.  What presses, p = x'' + g, holds the body on the driving flank where it is above 0, on the coast flank where it
is below.  A body lets go where p changes sign against its flank, flies with y'' = p, strikes the first flank that it
reaches, and stays there where p presses it to it; else it lets go at once.

Time is counted in steps between the nodes of the motion: speeds are in metres a step, accelerations in metres a
step²."""

from functools import cached_property

import numpy as np

from ...sheet.arrays import Array, BoolArray, IndexArray
from ...sheet.record import record

EVENTS = 8  # without an orbit that closes by then all of them count
PERIODS = 200  # of the motion, for one flight: what has met no flank by then meets none
HALVINGS, NEWTONS = 6, 3  # of the panel in which a flank is met; where it is but grazed the halvings stand
SAME_PHASE = 1e-6  # of the period


@record
class Wave:
    """Motions on the nodes of their period, R of them; each about its own mean."""

    jerk: Array  # (R, K) in m/step³
    a: Array  # (R, K) in m/step²
    v: Array  # (R, K) in m/step
    x: Array  # (R, K) in m

    @cached_property
    def a_twice(self) -> Array:
        return np.concatenate((self.a, self.a), 1)

    @cached_property
    def x_twice(self) -> Array:
        return np.concatenate((self.x, self.x), 1)


def _period_from(twice: Array, row: IndexArray, start: IndexArray) -> Array:
    """(L, K): a period of a row from a node on, out of two periods (R, 2K)."""
    K = twice.shape[1] // 2
    period: Array = twice.reshape(-1)[(row * 2 * K + start % K)[:, None] + np.arange(K)]
    return period


@record
class Events:
    """Of L lanes, E events each: a letting-go, a flight, a strike.  What did not come about is NaN, its flank 0."""

    let_go: Array  # (L, E + 1) in steps: the last is where it would go on
    at: Array  # (L, E) in steps: the strike
    left: IndexArray  # (L, E + 1): the flank that it lets go of, 1 driving, −1 coast
    flank: IndexArray  # (L, E): the flank that is struck
    slope: Array  # (L, E) y' at the strike, in m/step
    press: Array  # (L, E) p at the strike, in m/step²
    first: IndexArray  # (L,): the orbit has the events from here
    last: IndexArray  # (L,): to here, this one left out
    closes: BoolArray  # (L,): False: no orbit, all events stand for it


def events(wave: Wave, row: IndexArray, g: Array, J: Array) -> Events:
    """From the driving flank where it is pressed most, until a body lets go of the same flank at the same phase again.

    `row` (L,) of the wave, g (L,) in m/step² and J > 0 (L,) in m of each lane; where p has one sign alone
    at all nodes there is no event."""
    L, K = row.size, wave.a.shape[1]
    let_go, at, slope, press = (np.full((L, EVENTS + more), np.nan) for more in (1, 0, 0, 0))
    left, flank = np.zeros((L, EVENTS + 1), int), np.zeros((L, EVENTS), int)
    first, last, closes = np.zeros(L, int), np.zeros(L, int), np.zeros(L, bool)
    left[:, 0] = 1
    let_go[:, 0] = _letting_go(wave, row, g, left[:, 0], np.argmax(wave.a, 1)[row].astype(float))
    lanes = np.flatnonzero(np.isfinite(let_go[:, 0]))  # those that have not closed yet
    for e in range(EVENTS):
        rows, gs = row[lanes], g[lanes]
        t, to, speed, p = _flight(wave, rows, gs, J[lanes], let_go[lanes, e], left[lanes, e])
        if (lost := to == 0).any():
            lanes, rows, gs, t, to, speed, p = (of[~lost] for of in (lanes, rows, gs, t, to, speed, p))
        at[lanes, e], flank[lanes, e], slope[lanes, e], press[lanes, e] = t, to, speed, p
        stays = to * p > 0
        again = t.copy()
        again[stays] = _letting_go(wave, rows[stays], gs[stays], to[stays], t[stays])
        apart = np.abs(((again[:, None] - let_go[lanes, : e + 1]) / K + 0.5) % 1 - 0.5)
        alike = (apart < SAME_PHASE) & (left[lanes, : e + 1] == to[:, None])
        closed = alike.any(1)
        let_go[lanes, e + 1], left[lanes, e + 1], last[lanes] = again, to, e + 1
        first[lanes[closed]] = np.argmax(alike, 1)[closed]
        closes[lanes[closed]] = True
        lanes = lanes[~closed]
        if not lanes.size:
            break
    E = max(int(last.max(initial=0)), 1)
    return Events(
        let_go[:, : E + 1], at[:, :E], left[:, : E + 1], flank[:, :E], slope[:, :E], press[:, :E], first, last, closes
    )


def _letting_go(wave: Wave, row: IndexArray, g: Array, side: IndexArray, since: Array) -> Array:
    """When p next changes sign against a flank that it presses; NaN: at no node."""
    K = wave.a.shape[1]
    start = np.ceil(since).astype(int)
    against = side[:, None] * (_period_from(wave.a_twice, row, start) + g[:, None]) < 0
    turns, node = against.any(1), start + np.argmax(against, 1)
    a, b = (node - 1) % K, node % K
    p = Cubic.between(wave.a[row, a] + g, wave.a[row, b] + g, wave.jerk[row, a], wave.jerk[row, b])
    return np.where(turns, node - 1 + p.crossing(0.0, -side, np.maximum(since - node + 1, 0.0)), np.nan)


def _flight(
    wave: Wave, row: IndexArray, g: Array, J: Array, since: Array, side: IndexArray
) -> tuple[Array, IndexArray, Array, Array]:
    """Time and flank of the strike (0: none), y' and p there."""
    K = wave.a.shape[1]
    start = np.floor(since).astype(int)
    v_0, x_0 = (_at(f, d, row, start, since - start) for f, d in ((wave.v, wave.a), (wave.x, wave.v)))
    y_0 = np.where(side > 0, 0.0, -J) - x_0
    node, to = np.zeros(row.size, int), np.zeros(row.size, int)
    lanes = np.arange(row.size)
    for period in range(PERIODS):
        tau = (1 + period * K + np.arange(K)) - (since - start)[lanes, None]
        y = _period_from(wave.x_twice, row[lanes], start[lanes] + 1) + y_0[lanes, None]
        y += tau * (0.5 * g[lanes, None] * tau - v_0[lanes, None])
        over, under = y > 0, y < -J[lanes, None]
        if period == 0:  # at the first node the flank that is left is met by rounding alone
            over[:, 0] &= side < 0
            under[:, 0] &= side > 0
        outside = over | under
        out = np.argmax(outside, 1)
        met = outside[np.arange(lanes.size), out]
        where = lanes[met]
        node[where] = start[where] + 1 + period * K + out[met]
        to[where] = np.where(over[met, out[met]], 1, -1)
        lanes = lanes[~met]
        if not lanes.size:
            break
    # the last panel: y and its slope at both of its ends
    ends = [(n % K, n - since) for n in (node - 1, node)]
    y_a, y_b = (y_0 + wave.x[row, n] + tau * (0.5 * g * tau - v_0) for n, tau in ends)
    w_a, w_b = (wave.v[row, n] - v_0 + g * tau for n, tau in ends)
    s = Cubic.between(y_a, y_b, w_a, w_b).crossing(np.where(to > 0, 0.0, -J), to, np.maximum(since - node + 1, 0.0))
    at = node - 1 + s
    speed = _at(wave.v, wave.a, row, node - 1, s) - v_0 + g * (at - since)
    return at, to, speed, _at(wave.a, wave.jerk, row, node - 1, s) + g


def _at(nodes: Array, slopes: Array, row: IndexArray, start: IndexArray, s: Array) -> Array:
    """A share s behind a node."""
    a, b = start % nodes.shape[1], (start + 1) % nodes.shape[1]
    return Cubic.between(nodes[row, a], nodes[row, b], slopes[row, a], slopes[row, b]).at(s)


@record
class Cubic:
    """Hermite's, between two nodes."""

    c: tuple[Array, Array, Array, Array]  # of 1, s, s², s³

    @classmethod
    def between(cls, f_0: Array, f_1: Array, d_0: Array, d_1: Array) -> "Cubic":
        """From the values and the slopes at both."""
        rise = f_1 - f_0
        return cls((f_0, d_0, 3 * rise - 2 * d_0 - d_1, d_0 + d_1 - 2 * rise))

    def at(self, s: Array) -> Array:
        c_0, c_1, c_2, c_3 = self.c
        return c_0 + s * (c_1 + s * (c_2 + s * c_3))

    def crossing(self, level: Array | float, side: IndexArray, low: Array) -> Array:
        """Where it is first beyond a level, above (side 1) or below (−1), from `low` on to the second node."""
        c_0, c_1, c_2, c_3 = self.c
        beyond = Cubic((side * (c_0 - level), side * c_1, side * c_2, side * c_3))
        step = 1.0 - low
        for _ in range(HALVINGS):
            step = 0.5 * step
            middle = low + step
            low = np.where(beyond.at(middle) > 0, low, middle)
        s, (_, c_1, c_2, c_3) = low + step, beyond.c
        for _ in range(NEWTONS):
            slope = c_1 + s * (2 * c_2 + 3 * s * c_3)
            s = np.clip(s - np.where(slope > 0, beyond.at(s), 0.0) / np.where(slope > 0, slope, 1.0), low, low + step)
        return s
