# SPDX-License-Identifier: Apache-2.0
"""How long the two sectors of least mass are, for any force and couple; nothing here has a unit.

A sector of half-angle γ and length b has the unbalance k·b·sin γ and a mass that goes with b·γ.  Over the half-length
z_max the task is α = U/(k·z_max) and Π = P/(k·z_max²), the lengths are β = b/z_max; the outer faces stand at ±1.  For
lengths β_f, β_r the two conditions (force, couple) leave one pair of unbalances, and so of sin γ:

    s_r = |Π + (1 − β_f/2)·α| / (β_r·D)     s_f = |Π − (1 − β_r/2)·α| / (β_f·D)     D = 2 − (β_f + β_r)/2

Both must stay at or below 1.  What makes the search safe: where a pair of lengths serves, both may be made longer by
the same amount (up to 1) and still serve.  Proof: with U_f, U_r before and 2d more length each, U_r' = ((Δ − d)·U_r −
d·U_f)/(Δ − 2d); by |U_i| ≤ k·b_i this is at most k·(b_r + 2d) whenever b_f + b_r + 2d ≤ 2·z_max.  So the envelope
serves at all only if it does with one sector of full length, where the larger of s_f and s_r has a single minimum over
the other length: that minimum is the utilisation u, and u ≤ 1 is feasible.

All functions take arrays of tasks, a row each.
"""

from collections.abc import Callable
from functools import lru_cache

import numpy as np

from ...sheet.arrays import Array, BoolArray, ComplexArray, IndexArray

# the last search ends when the lengths are known to this; the mass is level there, so it is known far better
CLOSE = 1e-7
ROUNDS = 60
LEVEL = 1e-9  # of the mass: a gain by which the window becomes smaller all the same
TINY = 1e-300  # in place of no length: what is asked of it is then far beyond 1
LINE = np.linspace(0.0, 1.0, 97)  # of a search along a line
ROW = np.linspace(0.0, 1.0, 21)  # of the grid
WINDOW = np.linspace(-1.0, 1.0, 13)
Task = tuple[Array, Array, Array]


def task(alpha: complex | ComplexArray, product: complex | ComplexArray) -> Task:
    """α turned onto the real axis: |α|, and the parts of Π along and across it; arrays of one axis."""
    a, p = np.broadcast_arrays(np.atleast_1d(alpha), np.atleast_1d(product))
    size = np.abs(a)
    turned = p * np.where(size > 0, np.conj(a) / np.maximum(size, TINY), 1.0)
    return size, turned.real + 0.0, turned.imag + 0.0


def shares(asked: Task, front: Array, rear: Array) -> tuple[Array, Array]:
    """sin γ that front and rear sector need (above 1: impossible); their lengths have a row for each task."""
    a, along, across = (part.reshape(-1, *(1,) * (front.ndim - 1)) for part in asked)
    D = 2 - (front + rear) / 2
    f, r = np.hypot(along - (1 - rear / 2) * a, across), np.hypot(along + (1 - front / 2) * a, across)
    return f / (np.maximum(front, TINY) * D), r / (np.maximum(rear, TINY) * D)


def amount(asked: Task, front: Array, rear: Array) -> Array:
    """Mass of both sectors over its unit, Σ β·γ; infinite where they can not be."""
    s_f, s_r = shares(asked, front, rear)
    mass = front * np.arcsin(np.minimum(s_f, 1)) + rear * np.arcsin(np.minimum(s_r, 1))
    return np.where(np.maximum(s_f, s_r) <= 1, mass, np.inf)


def utilisation(alpha: complex | ComplexArray, product: complex | ComplexArray) -> Array:
    """The least largest sin γ that serves: 1 is the limit of the envelope.  It is proportional to force and couple
    together."""
    least: Array = _edge_minima(task(alpha, product))[1].min(-1)
    return least


def lengths(alpha: complex | ComplexArray, product: complex | ComplexArray) -> tuple[Array, Array, Array]:
    """β_f and β_r of least mass together, NaN where the envelope is too small; the utilisation."""
    asked = task(alpha, product)
    best, worst = _edge_minima(asked)
    fits = worst <= 1
    rows = np.flatnonzero(fits.any(-1))
    front = np.full(len(best), np.nan)
    rear = front.copy()
    if rows.size:
        front[rows], rear[rows] = _least((asked[0][rows], asked[1][rows], asked[2][rows]), best[rows], fits[rows])
    return front, rear, worst.min(-1)


def serves_whole(alpha: complex, product: complex) -> bool:
    """Whether two sectors of full length, which meet at mid-shaft, serve."""
    whole = np.ones((1, 1))
    return bool(np.maximum(*shares(task(alpha, product), whole, whole)).max() <= 1)


@lru_cache(maxsize=64)
def least_lengths(alpha: complex, product: complex) -> tuple[float, float, float]:
    """The same for one task, remembered: three formulas ask for it."""
    front, rear, u = lengths(alpha, product)
    return float(front[0]), float(rear[0]), float(u[0])


# --- the edges: one sector of full length


def _edges(t: Array) -> tuple[Array, Array]:
    """Lengths (front, rear) on the two edges (second axis), on which one sector has its full length and the other t."""
    front, rear = np.ones_like(t), np.ones_like(t)
    front[:, 0], rear[:, 1] = t[:, 0], t[:, 1]
    return front, rear


def _worst(asked: Task, t: Array) -> Array:
    return np.maximum(*shares(asked, *_edges(t)))


def _edge_minima(asked: Task) -> tuple[Array, Array]:
    """The shorter length where the larger sin γ is least, and that sin γ, on each edge."""
    start, width = np.zeros((len(asked[0]), 2)), np.ones((len(asked[0]), 2))
    while True:
        t = start[..., None] + width[..., None] * LINE
        w = _worst(asked, t)
        i = w.argmin(-1)
        if width[0, 0] < 1e-13:
            return _taken(t, i), _taken(w, i)
        start = _taken(t, np.minimum(np.maximum(i - 1, 0), len(LINE) - 3))
        width = width * (2 / (len(LINE) - 1))


def _taken(x: Array, i: IndexArray) -> Array:
    """Of each row along the last axis the element i."""
    n = x.shape[-1]
    return x.reshape(-1, n)[np.arange(i.size), i.ravel()].reshape(i.shape)


def _reach(inside: Array, outside: Array, serves: Callable[[Array], BoolArray], steps: Array, rounds: int) -> Array:
    """How far from `inside`, which serves, towards `outside` it still does."""
    for _ in range(rounds):
        t = inside[..., None] + (outside - inside)[..., None] * steps
        good = serves(t)
        good[..., 0] = True
        i = np.logical_and.accumulate(good, -1).sum(-1)
        inside, outside = _taken(t, i - 1), _taken(t, np.minimum(i, len(steps) - 1))
    return inside


# --- between them: the least mass


def _least(asked: Task, best: Array, fits: BoolArray) -> tuple[Array, Array]:
    """A grid over all that serves: along each edge, and from there both sectors shorter.  Then closer around its least
    mass."""
    from_, to = (_reach(best, np.full_like(best, end), lambda t: _worst(asked, t) <= 1, LINE, 5) for end in (0.0, 1.0))
    # closer where the lengths are short, and their effect large
    t = from_[..., None] + (to - from_)[..., None] * ROW**2
    front, rear = _edges(t)

    def both_shorter(x: Array) -> BoolArray:
        return np.maximum(*shares(asked, front[..., None] - x, rear[..., None] - x)) <= 1

    most = _reach(np.zeros_like(t), t, both_shorter, ROW, 4)
    x = most[..., None] * (1 - (1 - ROW) ** 3)
    f, r = front[..., None] - x, rear[..., None] - x
    n, N = len(best), len(ROW)
    mass = np.where(fits[..., None, None], amount(asked, f, r), np.inf)
    starts = np.stack(
        [  # a sector that does next to nothing makes a second minimum, mostly on an edge
            mass.reshape(n, -1).argmin(-1),
            mass[:, 0, :, 0].argmin(-1) * N,
            N * N + mass[:, 1, :, 0].argmin(-1) * N,
        ],
        -1,
    )
    every = np.arange(n)[:, None]
    edge, column = np.divmod(starts // N, N)
    f, r = f.reshape(n, -1)[every, starts], r.reshape(n, -1)[every, starts]
    short = 5 * np.maximum(np.minimum(f, r), TINY)
    along = np.clip(most[every, edge, column] / short, 1e-6, 1)
    across = np.clip((to - from_)[every, edge] / short, 1e-6, 1)
    many = np.repeat(asked[0], 3), np.repeat(asked[1], 3), np.repeat(asked[2], 3)
    f, r = (x.reshape(n, 3) for x in _closer(many, f.ravel(), r.ravel(), along.ravel(), across.ravel()))
    i = amount(asked, f, r).argmin(-1)
    return _taken(f, i), _taken(r, i)


def _closer(asked: Task, f: Array, r: Array, along: Array, across: Array) -> tuple[Array, Array]:
    """A window around the best, both lengths in proportion and against each other.

    It becomes smaller where the best lies well inside, larger where it lies at the rim.
    """
    n, every, middle = len(f), np.arange(len(f)), len(WINDOW) // 2
    before = np.full(n, np.inf)
    for _ in range(ROUNDS):
        d, o = np.exp(along[:, None] * WINDOW)[:, :, None], np.exp(across[:, None] * WINDOW)[:, None, :]
        front = np.minimum(f[:, None, None] * d * o, 1)
        rear = np.minimum(r[:, None, None] * d / o, 1)
        mass = amount(asked, front, rear).reshape(n, -1)
        i = mass.argmin(-1)
        f, r = front.reshape(n, -1)[every, i], rear.reshape(n, -1)[every, i]
        row, column = np.divmod(i, len(WINDOW))
        level = mass[every, i] >= before * (1 - LEVEL)  # it wanders where a length does not matter
        along, across = (
            np.where(level | (off <= middle // 2), width / 3, np.where(off == middle, np.minimum(3 * width, 1), width))
            for width, off in ((along, abs(row - middle)), (across, abs(column - middle)))
        )
        before = mass[every, i]
        if max(along.max(), across.max()) < CLOSE:
            break
    return f, r
