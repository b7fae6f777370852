# SPDX-License-Identifier: Apache-2.0
"""What the relief of half shells at their split line leaves of the film under a load that turns, from a stored table.

Half shells are thinned beside both split lines: the relief is deepest at the line and runs out linearly on either side,
over its half arc.  A load that stands is put where the split is not; a load that turns passes both lines every turn,
and where the land is missing under the thinnest film the journal sinks towards the seat, to rise again behind.

share = least film over the turn / film without relief, both 1 − e/c of the journal's middle.  Stored is ln(1 − share)
over atanh ε, ln(l/d), ln δ and ln a, with the half arc a and the depth over the film there is, δ = depth/(c·(1 − ε)),
over which bearings answer alike at every ε.  Between its nodes it is linear, so that a deeper or longer relief never
leaves more; from the first nodes downwards the loss goes with δ and with a, to exactly 0 without relief.  (The loss and
not the share has the logarithm, since the share reaches 0.)

Where the share is 0 the journal dips into the relief itself, and the edges of the land carry it: no film is left.

Range: 0.02 <= ε <= 0.98, 0.1 <= l/d <= 2 and half arcs of 0 to 1 rad; outside, a `FilmRangeError`.  Any depth: a relief
deeper than 200 films is a groove to the film and counts as 200.  Rigid shells, constant viscosity, no mass of the
journal.  `build_split_line` has the equation, and how the table is made.

Sources: O. Reynolds (1886); H. W. Swift (1932) and W. Stieber (1933) for the end of the film."""

import math
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from ....sheet.arrays import Array, IndexArray, Num, Value
from ....sheet.formula import formula
from ....sheet.record import record
from ....sheet.text import Text
from ....sheet.units import Number, Radian
from .reynolds import ECCENTRICITY_RANGE, LENGTH_RATIO_RANGE
from .table import ECCENTRICITY, Outside, clipped

TABLE = Path(__file__).parents[3] / "library" / "tables" / "split_line.npy"
SOURCE = Text(
    "Reynolds 1886: share of the film that is left as two split lines pass under a turning load, Swift–Stieber film "
    "end; this program's own march over the turn, tabulated"
)
DEPTH_RANGE = (0.1, 200.0)  # δ at the nodes
HALF_ARC_RANGE = (0.04, 1.0)  # rad
NAMES = (
    ECCENTRICITY,
    Text("length ratio l/d"),
    Text("depth of the relief over the clearance"),
    Text("half arc of the relief, rad"),
)
RANGES = (ECCENTRICITY_RANGE, LENGTH_RATIO_RANGE, (0.0, math.inf), (0.0, HALF_ARC_RANGE[1]))
LOW, HIGH = np.array(RANGES).T[..., None]
SMALL_RELIEF = np.array([[DEPTH_RANGE[0]], [HALF_ARC_RANGE[0]]])
AXES = 4
CORNERS = 2**AXES


@record
class SplitLineTable:
    """Nodes even in each of the four variables, and ln(1 − share) there."""

    first: Array  # of each variable, [variable, 1]
    step: Array  # between its nodes, [variable, 1]
    last_cell: Array  # [variable, 1]
    stride: IndexArray  # in `values` of the next node, [variable]
    corner: IndexArray  # in `values`, of the corners of a cell, [2, 2, 2, 2] as one row from its low one
    values: Array  # as one row


@cache
def split_line_table() -> SplitLineTable:
    stored = np.load(TABLE)[()]
    values, ends = stored["values"].astype(np.float64), stored["ends"]
    count = np.array(values.shape)
    stride = np.cumprod([1, *values.shape[:0:-1]])[::-1]
    corner = (np.indices((2,) * AXES).reshape(AXES, CORNERS) * stride[:, None]).sum(axis=0)
    step = (ends[:, 1] - ends[:, 0]) / (count - 1)
    return SplitLineTable(ends[:, :1], step[:, None], count[:, None] - 2, stride, corner, values.ravel())


def variables(places: Array) -> Array:
    """ε, l/d, δ and a, [variable, …], as the variables in which the nodes are even."""
    return np.concatenate([np.arctanh(places[:1]), np.log(places[1:])])


# --- the share


def share_at(eccentricity: Value, length_ratio: Num, depth: Num, half_arc: Num, *, outside: Outside = "raise") -> Value:
    """Least film over the turn / film without relief, 0 to 1.  Arrays are broadcast; four scalars give a float.

    `eccentricity`: of the film without relief; `depth` of the relief at the split line, over the radial clearance c;
    `half_arc`: its length on one side of the line over the radius, 2·length/d, rad.  No depth or no arc: 1.
    Outside the table: `FilmRangeError`, or with outside="nan" a nan at the points concerned."""
    table = split_line_table()
    given = eccentricity, length_ratio, depth, half_arc
    shape: tuple[int, ...] = np.broadcast(*given).shape
    places: Array = np.empty((AXES, *(shape or (1,))))
    for place, values in zip(places, given):
        place[...] = values
    places = places.reshape(AXES, -1)
    if not ((places >= LOW) & (places <= HIGH)).all():
        limits = zip(NAMES, places, RANGES)
        places = np.stack([clipped(name, place, low, high, outside) for name, place, (low, high) in limits])
    places[2] = np.minimum(places[2] / (1.0 - places[0]), DEPTH_RANGE[1])
    at_nodes = places.copy()
    at_nodes[2:] = np.maximum(places[2:], SMALL_RELIEF)
    small = (places[2:] / at_nodes[2:]).prod(axis=0)
    place = (variables(at_nodes) - table.first) / table.step
    cell = np.fmin(np.fmax(place, 0.0), table.last_cell).astype(np.intp)  # of a nan any
    part = place - cell
    corners = table.values[table.corner[:, None] + table.stride @ cell]
    for along in part:  # the first halves stand at the low node, the others at the high one
        low, high = corners[: len(corners) // 2], corners[len(corners) // 2 :]
        corners = low + along * (high - low)
    left = np.maximum(0.0, 1.0 - small * np.exp(corners[0]))
    result: Any = left.reshape(shape) if shape else float(left[0])
    return result  # type: ignore[no-any-return]


@formula(
    "s_t",
    SOURCE,
    shows="least film over the turn / film without relief: table of marches at ε, l/d, t/c, a",
    names={"b": "l/d"},
)
def share(eps: Number, b: Number, depth: Number, arc: Radian) -> Number:
    """What a load that turns keeps of its film over the split lines.  `depth` of the relief over the radial clearance;
    `arc`: half of it, 2·length/d.

    >>> share(eps=0.802, b=0.643, depth=0.53, arc=0.286)
    0.5...
    """
    return share_at(eps, b, depth, arc)
