# SPDX-License-Identifier: Apache-2.0
"""Rows of one speed and equal conditions as one node, at which the design is solved.

A node has the mean of its rows.  Its uncertainty is that of a row, the root mean square of theirs, and not over √n: it
is mostly systematic; but at least the standard deviation of the mean."""

from collections.abc import Mapping

import numpy as np

from ..sheet.arrays import Array
from ..sheet.record import record
from .inputs import NODES
from .rows import ColumnRows, RunRows

SPEED, KELVIN, SHARE = 0.005, 0.5, 0.01  # of the first row of a node: speed, temperatures, other conditions


@record
class ColumnNodes:
    """A column node by node, NaN where no row has it, in its own unit: mean, standard uncertainty, the one that all
    share (None: not given), and how many rows it had and had not."""

    y: Array
    sigma: Array | None
    common: Array | None
    unit: str | None
    rows: int
    empty: int


@record
class Nodes:
    """A run at its nodes, in order of speed.  `speed` [1/s], `conditions` by the keys of inputs, in SI, `rows`: how
    many each has."""

    name: str
    speed: Array
    conditions: Mapping[str, Array]
    rows: Array
    columns: Mapping[str, ColumnNodes]


def nodes_of(run: RunRows, temperatures: frozenset[str] = frozenset()) -> Nodes:
    """`temperatures`: the keys of conditions that are temperatures."""
    speed = np.asarray(run.speed)
    conditions = {key: np.asarray(values) for key, values in run.conditions.items()}
    groups = _groups(speed, conditions, temperatures)
    if len(groups) > NODES:
        groups = _bins(speed)
    groups.sort(key=lambda rows: float(speed[rows].mean()))
    return Nodes(
        run.name,
        np.array([speed[rows].mean() for rows in groups]),
        {key: np.array([values[rows].mean() for rows in groups]) for key, values in conditions.items()},
        np.array([len(rows) for rows in groups]),
        {name: _column(column, groups) for name, column in run.columns.items()},
    )


def _groups(speed: Array, conditions: Mapping[str, Array], temperatures: frozenset[str]) -> list[list[int]]:
    """Rows by the node that they belong to, from the slowest on: each to one whose first row is like it; no further
    than to one node more than may be."""
    groups: list[list[int]] = []
    for row in np.argsort(speed, kind="stable").tolist():
        near = (group for group in reversed(groups) if speed[row] <= speed[group[0]] * (1 + SPEED))
        own = next((group for group in near if _alike(row, group[0], conditions, temperatures)), None)
        if own is not None:
            own.append(row)
        elif len(groups) > NODES:
            break
        else:
            groups.append([row])
    return groups


def _alike(row: int, first: int, conditions: Mapping[str, Array], temperatures: frozenset[str]) -> bool:
    return all(
        abs(x[row] - x[first]) <= (KELVIN if key in temperatures else SHARE * abs(x[first]))
        for key, x in conditions.items()
    )


def _bins(speed: Array) -> list[list[int]]:
    """Rows by equal bins of speed."""
    low, high = float(speed.min()), float(speed.max())
    place = np.minimum(((speed - low) / ((high - low) or 1.0) * NODES).astype(int), NODES - 1)
    return [np.flatnonzero(place == n).tolist() for n in range(NODES) if (place == n).any()]


def _column(column: ColumnRows, groups: list[list[int]]) -> ColumnNodes:
    y = np.asarray(column.y)
    sigma, common = (None if x is None else np.asarray(x) for x in (column.sigma, column.common))
    there = np.isfinite(y) & (np.isfinite(sigma) if sigma is not None else True)
    there &= np.isfinite(common) if common is not None else True
    rows = [np.asarray(group)[there[group]] for group in groups]

    def of_nodes(what: Array | None, mean: object) -> Array | None:
        return None if what is None else np.array([mean(what[some]) if some.size else np.nan for some in rows])  # type: ignore[operator]

    means, common_means = of_nodes(y, np.mean), of_nodes(common, np.mean)
    own = of_nodes(sigma, lambda x: np.sqrt(np.mean(np.square(x))))
    if own is not None:
        of_mean = [np.std(y[some], ddof=1) / np.sqrt(some.size) if some.size > 1 else 0.0 for some in rows]
        own = np.maximum(own, of_mean)
    assert means is not None
    used = int(there.sum())
    return ColumnNodes(means, own, common_means, column.unit, used, y.size - used)
