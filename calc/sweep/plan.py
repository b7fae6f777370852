# SPDX-License-Identifier: Apache-2.0
"""Which designs are computed, in which order: each is known by its place alone, so that a run may begin anywhere."""

from collections.abc import Sequence
from functools import lru_cache
from math import prod
from statistics import NormalDist

import numpy as np

from ..sheet.arrays import Array
from ..sheet.errors import BadInput, InputError
from ..sheet.record import record
from ..sheet.text import Text
from ..studies.sweep.inputs import MOST_ROWS, Value, Varied

Combination = tuple[Value | None, ...]  # the values of the varied inputs; None: as the design has it
SIGMAS = 3.0  # standard deviations from the middle of a tolerance to its ends


@record
class Plan:
    """`count` designs over some inputs: `way` is "grid", "list", "hypercube" or "monte-carlo"."""

    way: str
    inputs: tuple[Varied, ...]
    count: int
    seed: int = 0
    combinations: tuple[Combination, ...] = ()  # of a list

    def rows(self, start: int, stop: int) -> list[Combination]:
        """The combinations from one place up to another."""
        stop = min(stop, self.count)
        if self.way == "list":
            return list(self.combinations[start:stop])
        if self.way == "grid":
            return [self._of_grid(n) for n in range(start, stop)]
        shares = [_shares(self.way, self.count, self.seed, n)[start:stop].tolist() for n in range(len(self.inputs))]
        return [tuple(_drawn(one, share) for one, share in zip(self.inputs, row)) for row in zip(*shares)]

    def _of_grid(self, n: int) -> Combination:
        """Every combination, the last input changing fastest."""
        found: list[Value] = []
        for one in reversed(self.inputs):
            n, place = divmod(n, len(one.values))
            found.append(one.values[place])
        return tuple(reversed(found))


def grid(inputs: Sequence[Varied], place: str = "--vary") -> Plan:
    """Every combination of the values."""
    return Plan("grid", tuple(inputs), _allowed(prod(len(one.values) for one in inputs), place))


def sampled(inputs: Sequence[Varied], count: int, seed: int = 1, *, hypercube: bool) -> Plan:
    """Designs at random; with `hypercube` so that each of `count` equal parts of every input's range has one design."""
    option = "--hypercube" if hypercube else "--monte-carlo"
    errors = [InputError(0, option, str(count), Text("must be a number of designs, 1 or more"))] if count < 1 else []
    if errors := errors + ([InputError(0, "--seed", str(seed), Text("must be 0 or more"))] if seed < 0 else []):
        raise BadInput("sweep", errors)
    return Plan("hypercube" if hypercube else "monte-carlo", tuple(inputs), _allowed(count, option), seed)


def _allowed(rows: int, option: str) -> int:
    if rows > MOST_ROWS:
        why = Text("asks for {rows} designs; at most {most_rows} at once", rows=rows, most_rows=MOST_ROWS)
        raise BadInput("sweep", [InputError(0, option, "", why)])
    return rows


@lru_cache(64)
def _shares(way: str, count: int, seed: int, place: int) -> Array:
    """Where in its range each design has one input, from 0 to 1; every input has a stream of its own."""
    stream = np.random.Generator(np.random.PCG64([seed, place]))
    inside = stream.random(count)
    return (stream.permutation(count) + inside) / count if way == "hypercube" else inside


def _drawn(one: Varied, share: float) -> Value:
    if one.values:
        return one.values[min(int(share * len(one.values)), len(one.values) - 1)]
    low, high = one.ends
    if one.whole:
        return min(int(low + share * (high - low + 1)), int(high))
    if one.normal:  # cut off at the ends of the tolerance: parts beyond them are not let through
        out = NORMAL.cdf(-SIGMAS)
        share = (NORMAL.inv_cdf(out + share * (1 - 2 * out)) / SIGMAS + 1) / 2
    return low + min(max(share, 0.0), 1.0) * (high - low)


NORMAL = NormalDist()
