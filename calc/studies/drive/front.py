# SPDX-License-Identifier: Apache-2.0
"""Fronts: which rows no other row beats, a few that stand for all, and one drive picked from the file of a front.

A drive is picked from front.json: its neighbours, and what each objective costs in the others where it stands.  The
file may be anybody's: what it says is taken for no result.  It names objectives and drives; the design itself is solved
as always."""

import json
from collections.abc import Mapping
from typing import Any

import numpy as np

from ...design.addresses import Table as Data
from ...design.addresses import value_at
from ...design.limits import FRONT_BYTES
from ...design.other_tables import OBJECTIVES
from ...sheet.arrays import Array, BoolArray, IndexArray
from ...sheet.errors import BadInput
from ...sheet.record import record

# --- which rows no other row beats in everything, and a few that stand for all
# Rows are arrays of shape (rows, objectives), all of them to be as small as can be.

BLOCK = 512


def front(rows: Array) -> IndexArray:
    """The places of the rows that no other beats (is nowhere larger and somewhere smaller); of equal rows the first.
    Rising."""
    order = np.lexsort(rows.T[::-1])  # a row can only be beaten by one before it
    kept = np.zeros((0, rows.shape[1]))
    places: list[IndexArray] = []
    for start in range(0, len(order), BLOCK):
        at = order[start : start + BLOCK]
        block = rows[at]
        if len(kept):
            alive = np.ones(len(block), dtype=bool)
            for k in range(0, len(kept), 2048):
                alive &= ~_beaten(block, kept[k : k + 2048]).any(axis=1)
            at, block = at[alive], block[alive]
        first = ~np.tril(_beaten(block, block), -1).any(axis=1)
        kept = np.concatenate([kept, block[first]])
        places.append(at[first])
    return np.sort(np.concatenate(places)) if places else np.zeros(0, dtype=int)


def _beaten(rows: Array, others: Array) -> BoolArray:
    """[row, other]: whether the other is nowhere larger."""
    beaten: BoolArray = np.logical_and.reduce([others[None, :, n] <= rows[:, None, n] for n in range(rows.shape[1])])
    return beaten


def lower_left(x: Array, y: Array) -> IndexArray:
    """The same of two objectives, in the order of the first."""
    order = np.lexsort((y, x))
    best = np.minimum.accumulate(y[order])
    first = np.ones(order.size, dtype=bool)
    first[1:] = y[order][1:] < best[:-1]
    chosen: IndexArray = order[first]
    return chosen


def representatives(rows: Array, units: Array, count: int) -> list[int]:
    """The best of every objective, the knee, then ever the row that is worst represented: what it lacks beside the
    nearest chosen one, in units, in its worst objective (additive ε)."""
    if not len(rows):
        return []
    scaled = rows / units
    chosen = list(
        dict.fromkeys([int(np.lexsort((scaled.sum(1), scaled[:, n]))[0]) for n in range(rows.shape[1])] + [knee(rows)])
    )
    lacks = np.full(len(rows), np.inf)
    for place in chosen:
        lacks = np.minimum(lacks, (scaled[place] - scaled).max(1))
    while len(chosen) < min(count, len(rows)):
        place = int(lacks.argmax())
        if lacks[place] <= 0:
            break
        chosen.append(place)
        lacks = np.minimum(lacks, (scaled[place] - scaled).max(1))
    return chosen[:count]


def knee(rows: Array) -> int:
    """The row nearest to the best of everything at once, each objective over its own range."""
    low, high = rows.min(0), rows.max(0)
    return int((((rows - low) / np.where(high > low, high - low, 1.0)) ** 2).sum(1).argmin())


# --- one drive of a front, as front.json has it

NAME = "front.json"
MOST_DRIVES = 2000
LONGEST = 120  # letters of a word of it
MOST_WORDS = 100
SHOWN = 12  # drives of the report's table
UNITS = {"power": ("W", 10.0), "mass": ("kg", 0.5), "seat": ("mm", 1.0), "price": ("€", 3.0), "margin": ("%", 10.0)}


class Broken(ValueError):
    """Why a file is no front."""


@record
class Picked:
    """`number` of the drive, from 1; `rows`: the objectives of every drive, a column for each of `names`, in their
    units.

    `limits`, `waived`: patterns of findings that were limits; `sizes` and `choices`: what was varied; `proved`,
    `combinations`, `done` of the `classes`: what the front is the front of."""

    number: int
    names: tuple[str, ...]
    rows: Array
    limits: tuple[str, ...]
    waived: tuple[str, ...]
    sizes: dict[str, tuple[float, ...] | None]
    choices: dict[str, tuple[str, ...]]
    proved: bool
    combinations: int
    done: int
    classes: int

    @property
    def mine(self) -> Array:
        row: Array = self.rows[self.number - 1]
        return row

    def nearest(self, count: int = SHOWN) -> list[int]:
        """Numbers of the drives nearest to this one, itself among them, in the order of the front."""
        units = np.array([UNITS[name][1] for name in self.names])
        far = np.abs((self.rows - self.mine) / units).max(1)
        return sorted((np.argsort(far, kind="stable")[:count] + 1).tolist())

    def line(self, first: str, second: str) -> Array:
        """The drives that no other beats in two of the objectives: rows of both, in the order of the first."""
        x, y = (self._small(name) for name in (first, second))
        line: Array = self.rows[lower_left(x, y)][:, [self.names.index(first), self.names.index(second)]]
        return line

    def _small(self, name: str) -> Array:
        column: Array = self.rows[:, self.names.index(name)]
        return -column if name == "margin" else column

    def costs(self) -> list[tuple[str, float, str, float]]:
        """What more of one objective costs in another, along the front of the two: (wanted, its gain, paid, its loss),
        from this drive to the next one that is better in the first.  Only where this drive stands on that front."""
        trades = []
        for wanted in self.names:
            for paid in self.names:
                if wanted == paid:
                    continue
                x, y = self._small(wanted), self._small(paid)
                order = lower_left(x, y)
                at = np.flatnonzero(order == self.number - 1)
                if at.size and at[0] > 0:
                    other = int(order[at[0] - 1])
                    gain, loss = float(x[self.number - 1] - x[other]), float(y[other] - y[self.number - 1])
                    if gain > 0 and loss > 0:
                        trades.append((wanted, gain, paid, loss))
        return trades


def searched(raw: bytes) -> tuple[str, int]:
    """The hash of the design that a front was searched for, and how many drives it has.  Raises Broken."""
    try:
        about = json.loads(raw)
        design, drives = about["design"], about["drives"]
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        raise Broken(f"is no front: {type(error).__name__}") from None
    if not isinstance(design, str) or not isinstance(drives, list) or len(drives) > MOST_DRIVES:
        raise Broken("names drives that there are not")
    return design, len(drives)


def picked(raw: bytes, data: Data) -> Picked | None:
    """The drive that a design is of the front in a file; None: it is none of its drives.  Raises Broken where the file
    is no front."""
    if len(raw) > FRONT_BYTES:
        raise Broken(f"has {len(raw)} bytes; a front has at most {FRONT_BYTES}")
    try:
        about = json.loads(raw)
        names = tuple(about["objectives"])
        drives = about["drives"]
        if not names or set(names) - set(OBJECTIVES) or not isinstance(drives, list) or len(drives) > MOST_DRIVES:
            raise Broken("names objectives or drives that there are not")
        rows = np.array(
            [[float(drive["objectives"][name]) for name in names] for drive in drives], dtype=float
        ).reshape(-1, len(names))
        if not np.isfinite(rows).all():
            raise Broken("has objectives that are no numbers")
        number = next((n for n, drive in enumerate(drives, 1) if _is(data, drive["changes"])), None)
        sizes = {
            _word(key): None if values is None else tuple(map(float, values))[:MOST_DRIVES]
            for key, values in about["sizes_mm"].items()
        }
        choices = {_word(key): tuple(map(_word, values))[:MOST_WORDS] for key, values in about["choices"].items()}
        proved = bool(about["proved"])
        combinations, done, classes = (int(about[key]) for key in ("combinations", "classes_done", "classes"))
        patterns = [tuple(map(_word, about.get(key, ())))[:MOST_WORDS] for key in ("limits", "waived")]
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError, OverflowError) as error:
        raise error if isinstance(error, Broken) else Broken(f"is no front: {type(error).__name__}") from None
    if number is None:
        return None
    return Picked(number, names, rows, patterns[0], patterns[1], sizes, choices, proved, combinations, done, classes)


def _is(data: Data, changes: Mapping[str, Any]) -> bool:
    """Whether a design has all that makes a drive."""
    try:
        return bool(changes) and all(value_at(data, key) == value for key, value in changes.items())
    except BadInput:
        return False


def _word(value: object) -> str:
    """A word of the file, a pair as it is written."""
    return ("/".join(map(str, value)) if isinstance(value, list) else str(value))[:LONGEST]
