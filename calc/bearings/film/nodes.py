# SPDX-License-Identifier: Apache-2.0
"""The stored nodes of the oil film and the polynomials between them; `table` says what is stored, and is what to call.

The table (`tables/film_table.npy`, written by `build_table`) holds, over x = atanh ε and y = ln(l/d), a bicubic spline of each
quantity as value and derivatives at its nodes.
"""

import math
from bisect import bisect_right
from functools import cache, lru_cache
from pathlib import Path
from typing import Generic, Literal, Protocol, TypeAlias, cast

import numpy as np

from ...sheet.arrays import Array, IndexArray
from ...sheet.record import record
from ...sheet.text import EMPTY, Amount, Text
from . import short_bearing
from .reynolds import Value

Outside: TypeAlias = Literal["raise", "nan"]

TABLE = Path(__file__).parents[2] / "library" / "tables" / "film_table.npy"
QUANTITIES = ("ln(So/So_short)", "phi", "Q", "Qs/Q", "P/pmax", "ln(C_rr/C_rr,short)")

SLACK = 1e-9  # relative: a value this far outside, from rounding, counts as the limit


class FilmRangeError(ValueError):
    """A film outside the table."""

    def __init__(self, quantity: str, value: float, low: float, high: float, more: str = "") -> None:
        at, least, most = (Amount(number, form=".6g") for number in (value, low, high))
        message = Text(
            "{quantity} {value} is outside the film table, {low} to {high}{more}",
            quantity=quantity,
            value=at,
            low=least,
            high=most,
            more=more,
        )
        super().__init__(message)
        self.quantity, self.value, self.low, self.high = quantity, value, low, high


@record
class FilmPoint(Generic[Value]):
    """The film at one eccentricity and l/d, or at many: then every field is an array."""

    eccentricity: Value  # ε = e/c
    sommerfeld: Value  # S = (r/c)²·μ·N/P, N in revolutions per second
    attitude: Value  # φ, from the load line to the narrowest film, rad
    friction: Value  # f* = (r/c)·f
    flow: Value  # Q/(r·c·N·l), through the widest film
    side_flow_ratio: Value  # Qs/Q
    pressure_ratio: Value  # P/p_max
    radial_damping: Value  # C_rr·c·ω/F of a journal that moves along its eccentricity


class _Short(Protocol):
    """A formula of the short bearing without its line of the calculation: the table's splines are taken over it, at one place or many."""

    def __call__(self, *, eps: Value, b: float = ...) -> Value: ...


_load, _damping = cast(_Short, short_bearing.sommerfeld_din.function), cast(_Short, short_bearing.radial_damping.function)


def short_bearing_load(eccentricity: Value) -> Value:
    """So/(l/d)² of the infinitely short bearing with half a film: ε·√(π²·(1 − ε²) + 16·ε²)/(2·(1 − ε²)²)  (Ocvirk 1952)."""
    return _load(eps=eccentricity, b=1.0)


def short_bearing_slope(eccentricity: Value) -> Value:
    """d ln(short_bearing_load)/d(atanh ε)."""
    square = eccentricity**2
    bend = 16.0 - math.pi**2
    slope: Value = (1.0 - square) * (1.0 / eccentricity + bend * eccentricity / (math.pi**2 + bend * square)) + 4.0 * eccentricity
    return slope


def short_bearing_damping(eccentricity: Value) -> Value:
    """C_rr·c·ω/F of the infinitely short bearing with half a film."""
    return _damping(eps=eccentricity)


# The table ------------------------------------------------------------------------------------------------------------------


@record
class Table:
    eccentricities: Array  # at the nodes
    length_ratios: Array
    x: Array  # atanh ε at the nodes
    y: Array  # ln(l/d)
    x_list: list[float]  # the same as plain numbers, for bisect
    y_list: list[float]
    short: Array  # ln(short_bearing_load) at the nodes
    rows: Array  # [node of y: value, d/dy; node of x: value, d/dx; quantity], pairs in sequence


@record
class Column:
    """The table at one l/d: cubics in x."""

    values: Array  # [node of x: value, d/dx; quantity], pairs in sequence
    loads: list[float]  # ln(So/(l/d)²) at the nodes of x, increasing


@cache
def film_nodes() -> Table:
    stored = np.load(TABLE)[()]
    eccentricities, length_ratios, rows = stored["eccentricity"], stored["length_ratio"], stored["rows"]
    x, y = np.arctanh(eccentricities), np.log(length_ratios)
    short = np.log(short_bearing_load(eccentricities))
    return Table(eccentricities, length_ratios, x, y, x.tolist(), y.tolist(), short, rows)


@lru_cache(maxsize=128)
def column_at(length_ratio: float) -> Column:
    """Raises FilmRangeError outside the table."""
    table = film_nodes()
    y = math.log(within("length ratio l/d", length_ratio, table.length_ratios))
    node = min(bisect_right(table.y_list, y), len(table.y_list) - 1) - 1
    step = table.y_list[node + 1] - table.y_list[node]
    weights = np.array(hermite((y - table.y_list[node]) / step, step))
    four = table.rows[2 * node : 2 * node + 4]
    values = (weights @ four.reshape(4, -1)).reshape(four.shape[1:])
    values.setflags(write=False)
    return Column(values, (values[::2, 0] + table.short).tolist())


def hermite(part: Value, step: Value) -> tuple[Value, Value, Value, Value]:
    """Weights of value and derivative at the left node, then at the right one; `part` of the cell from 0 to 1."""
    rest = 1.0 - part
    return rest * rest * (1.0 + 2.0 * part), part * rest * rest * step, part * part * (3.0 - 2.0 * part), -part * part * rest * step


def hermite_slope(part: Value, step: Value) -> tuple[Value, Value, Value, Value]:
    """The derivatives of those weights over the variable itself."""
    rest = 1.0 - part
    value = 6.0 * part * rest / step
    return -value, rest * (1.0 - 3.0 * part), value, part * (3.0 * part - 2.0)


def cubic(left: Value, left_slope: Value, right: Value, right_slope: Value) -> tuple[Value, Value]:
    """Second and third coefficient of the Hermite polynomial in the part of the cell."""
    return 3.0 * (right - left) - 2.0 * left_slope - right_slope, 2.0 * (left - right) + left_slope + right_slope


def within(quantity: str, value: float, nodes: Array) -> float:
    low, high = float(nodes[0]), float(nodes[-1])
    if not low * (1.0 - SLACK) <= value <= high * (1.0 + SLACK):
        raise FilmRangeError(quantity, value, low, high)
    return min(max(value, low), high)


def cells(nodes: Array, positions: Array) -> tuple[IndexArray, tuple[Array, Array, Array, Array]]:
    """The cell of each position, and the weights of its nodes; a nan gives nan weights in some cell."""
    cell = np.minimum(np.maximum(np.searchsorted(nodes, positions, side="right") - 1, 0), nodes.size - 2)
    step = nodes[cell + 1] - nodes[cell]
    return cell, hermite((positions - nodes[cell]) / step, step)


def clipped(quantity: str, values: Array, low: float | Array, high: float | Array, outside: Outside, more: Array | None = None) -> Array:
    """The values with those outside low to high made nan, or an error that names the first of them."""
    wrong = ~((values >= low * (1.0 - SLACK)) & (values <= high * (1.0 + SLACK)))
    if outside == "raise" and wrong.any():
        at = np.unravel_index(int(wrong.argmax()), wrong.shape)
        lowest, highest = (float(np.broadcast_to(limit, wrong.shape)[at]) for limit in (low, high))
        place = EMPTY
        if more is not None:
            place = Text(" at l/d {broadcast_to}", broadcast_to=Amount(float(np.broadcast_to(more, wrong.shape)[at]), form=".6g"))
        count = Text(" ({sum} of {size} values are outside)", sum=int(wrong.sum()), size=wrong.size)
        raise FilmRangeError(quantity, float(values[at]), lowest, highest, place + count)
    return np.where(wrong, np.nan, np.minimum(np.maximum(values, low), high))
