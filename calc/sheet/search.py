# SPDX-License-Identifier: Apache-2.0
"""One search for whatever has to be chosen: candidates, limits, ranking, and why the neighbours fail.

It knows nothing of engines.  A step says its variables (multiples of a step), its limits (those of its own
checks) and what it wants least of.  Candidates come in two kinds, and each has its evaluation:

- many at once, as arrays: `judged` puts a limit on all of them, `least` and `first` choose, `stretch` and `narrowed`
  find how far it goes;
- one after the other, where each costs a whole solution: `first_good`, `crossing` and `least_whole` try as few as they
  can, and keep to a `Budget`.
"""

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any, Generic, TypeVar

import numpy as np

from .arrays import Array, BoolArray
from .progress import Progress, tell
from .record import record
from .text import EMPTY, Text

T = TypeVar("T")
R = TypeVar("R")

DUST = 1e-9  # of the limit: a margin that is negative by rounding only


# --- candidates


def multiples(step: float, low: float, high: float, extra: Iterable[float] = ()) -> Array:
    """Whole multiples of a step from `low` to `high`, in order; shape (n,).

    `extra` numbers stand in the place of a multiple that they equal but for rounding, else between them.
    """
    steps: Array = np.multiply(np.arange(math.ceil(low / step - 1e-6), math.floor(high / step + 1e-6) + 1), step)
    given = list(extra)
    for number in given:
        steps = steps[np.abs(steps - number) > step * 1e-5]
    return np.sort(np.append(steps, given)) if given else steps


def rounded(low: float, high: float) -> float:
    """The number of the fewest digits that lies beyond `low` and not beyond `high`, seen from `low`."""
    for digits in range(-3, 7):
        unit = 10.0**-digits
        n = math.floor(high / unit + 1e-9) if high > low else math.ceil(high / unit - 1e-9)
        x = round(n * unit, max(digits, 0))
        rising = low < x <= high * (1 + 1e-12)
        falling = (high * (1 - 1e-12) if high > 0 else high) <= x < low
        if rising if high > low else falling:
            return x
    return high


def beside(number: float, step: float) -> tuple[float, float]:
    """The whole multiples of a step below and above a number, each more than half a step away."""
    below, above = math.floor(number / step - 0.5 - 1e-6), math.ceil(number / step + 0.5 + 1e-6)
    return round(below * step, 12), round(above * step, 12)


# --- many candidates at once

FAR = 8  # grids of one step that follow their best point before it is taken to be far


@record
class Judged:
    """One limit on any number of candidates: value, limit and margin, arrays of one shape (or numbers).  `margin` is
    that of a check, −∞ where there is no number.  `rule`: whatever the step calls the limit by; `where`: what governs
    it, in the step's own terms."""

    rule: Any  # the step's own class, as `where`
    value: Array
    limit: float | tuple[float, float] | Array
    margin: Array
    where: Any = None


def judged(
    rule: object, value: Array, limit: float | tuple[float, float] | Array, sense: str = ">=", where: object = None
) -> Judged:
    """`value` against `limit` (a number, (low, high), or one for each candidate), both in one unit."""
    if isinstance(limit, tuple):
        low, high = limit
        margin = np.minimum(value - low, high - value) / ((high - low) or 1.0)
    else:
        gap = value - limit if sense in (">=", ">") else limit - value
        margin = gap / np.where(limit == 0, 1.0, np.abs(limit))
    margin = np.where(np.abs(margin) <= DUST, 0.0, margin)
    return Judged(rule, value, limit, np.where(np.isnan(margin), -np.inf, margin), where)


def least(limits: Iterable[Judged]) -> Array:
    """The least margin of all limits, candidate by candidate."""
    margin: Array = np.min(np.array([limit.margin for limit in limits]), axis=0)
    return margin


def governing(limits: Iterable[Judged], index: int) -> Judged:
    """The limit with the least margin of one candidate."""
    return min(limits, key=lambda limit: float(limit.margin[index]))


def first(kept: BoolArray, *wanted: Array) -> tuple[np.intp, ...] | None:
    """The index of the candidate that is kept with the least of what is wanted, and of equal ones the least of the
    next; None: none is."""
    if not kept.any():
        return None
    orders = [np.where(kept, numbers, np.inf).ravel() for numbers in reversed(wanted)]
    return np.unravel_index(np.lexsort(orders)[0], kept.shape)


def stretch(kept: BoolArray, i: int) -> tuple[int, int] | None:
    """First and last index of the stretch of kept candidates around i, or nearest to it; None: none is kept."""
    held = np.flatnonzero(kept)
    if not len(held):
        return None
    i = int(held[np.argmin(np.abs(held - i))])
    fails = np.flatnonzero(~kept)
    before, after = fails[fails < i], fails[fails > i]
    return (int(before[-1]) + 1 if len(before) else 0), (int(after[0]) - 1 if len(after) else len(kept) - 1)


def narrowed(
    evaluate: Callable[[Array], tuple[Array, Array]], low: Array, high: Array, centre: Array, step: Array, side: int
) -> tuple[Array, float, float]:
    """The best point of a lattice of whole numbers between `low` and `high` (each of shape (axes,)), its margin and
    what is wanted.

    A grid of `side` points an axis (odd) follows its best point until it stays, then halves its step, down to 1; where
    that point is far it doubles its step.  `evaluate` gives margins and what is wanted least of points of shape (n,
    axes); where no point keeps the limits the largest margin is sought."""
    followed = 0
    offsets = np.stack(np.meshgrid(*[np.arange(side) - side // 2] * len(low), indexing="ij"), -1).reshape(-1, len(low))
    while True:
        points = np.clip(centre + offsets * step, low, high)
        margin, wanted = evaluate(points)
        middle, i = len(points) // 2, least_wanted(wanted, margin)
        if wanted[i] < wanted[middle] if margin[middle] >= 0 else margin[i] > margin[middle]:
            centre = points[i]
            followed += 1
            if followed == FAR:  # with the step of a look nearby a far end would take thousands of grids
                followed, step = 0, step * 2
        elif (step == 1).all():
            return centre, float(margin[middle]), float(wanted[middle])
        else:
            followed, step = 0, np.maximum(step // 2, 1)


def least_wanted(wanted: Array, margin: Array) -> int:
    """The index of the candidate that keeps every limit with the least of what is wanted; where none does, the one that
    misses by least."""
    kept = margin >= 0
    return int(np.argmin(np.where(kept, wanted, np.inf))) if kept.any() else int(np.argmax(margin))


# --- one candidate after the other


@dataclass
class Budget:
    """How many candidates may still be evaluated whole: all parts of a search share one."""

    left: int

    def spend(self) -> bool:
        """Whether there is one left, which is then gone."""
        if self.left <= 0:
            return False
        self.left -= 1
        return True


@record
class Trial(Generic[R]):
    """What one candidate gives, and its rank: 0 needs no better one.  `result` None: it fails, and `why`."""

    result: R | None
    rank: float = 0
    why: Text = EMPTY


def first_good(
    candidates: Iterable[T],
    evaluate: Callable[[T], Trial[R]],
    progress: Progress | None = None,
    what: str = "",
    most: int | None = None,
) -> Trial[R]:
    """The first of rank 0, else the first of the least rank; where all fail, with the reason of the last.

    `most`: how many are tried.
    """
    best: Trial[R] = Trial(None)
    tried = list(candidates)[:most]
    for n, candidate in enumerate(tried):
        tell(progress, n / len(tried), what)
        trial = evaluate(candidate)
        if trial.result is None:
            best = best if best.result is not None else trial
        elif best.result is None or trial.rank < best.rank:
            best = trial
        if best.result is not None and best.rank == 0:
            break
    return best


STRIDES = 12  # towards the smallest change
SHORTENED, HALVED = 2, 5  # times that the stretch around it is made shorter, by its slope and where it has none
SHORT = 0.03  # of a change: a shorter stretch stays


def crossing(
    score: Callable[[float], float], start: float, first: float, farthest: float, step: float, near: float = 0.0
) -> tuple[float, float] | float:
    """Of changes whose score rises with them, the largest that is known to leave it below zero and the smallest that
    does not; where none does, the one that comes nearest.

    `score`: no number where a change is not allowed or has none.  `start`: that of no change; `first`: the change that
    is tried first, by which the next is told; `step`: the least from one to the next; `near`: how close both ends need
    to be.
    """
    low, at_low, high = 0.0, start, first
    nearest, most = 0.0, start
    for _ in range(STRIDES):
        here = score(high)
        if here >= 0:
            return closer(score, low, high, at_low, here, near)
        if here > most + DUST:
            nearest, most = high, here
        if math.isnan(here) and not math.isnan(at_low):  # too far: half of it
            if high - low < 2 * step:
                break
            high = (low + high) / 2
            continue
        rise = (here - at_low) / (high - low)
        if rise <= 0 or high == farthest:
            break
        low, at_low = high, here
        high = min(farthest, low + max(-1.05 * here / rise, step) if rise > 0 else 3 * low)
    return nearest


def closer(
    score: Callable[[float], float], low: float, high: float, at_low: float, at_high: float, near: float = 0.0
) -> tuple[float, float]:
    """A shorter stretch between two changes, of which the second has a score of zero or more: by its slope where both
    have a score, else by halves."""
    for _ in range(HALVED if math.isnan(at_low) else SHORTENED):
        if high - low <= max(near, SHORT * high):
            break
        sloped = 1.05 * at_low / (at_low - at_high)
        middle = low + (0.5 if math.isnan(sloped) else max(0.2, min(0.9, sloped))) * (high - low)
        if (here := score(middle)) >= 0:
            high, at_high = middle, here
        else:
            low, at_low = middle, here
    return low, high


def least_whole(evaluate: Callable[[int], R | None], low: int, high: int) -> R | None:
    """What the least whole number from `low` to `high` gives that gives anything, where every larger one does too."""
    best = evaluate(high) if high >= low else None
    while best is not None and low < high:
        middle = (low + high) // 2
        result = evaluate(middle)
        best, low, high = (best, middle + 1, high) if result is None else (result, low, middle)
    return best
