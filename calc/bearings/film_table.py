# SPDX-License-Identifier: Apache-2.0
"""The oil film of a plain bearing from a stored table: microseconds instead of the milliseconds of `reynolds`.

The table (`tables/film_table.npy`, written by `build_film_table`) holds, over x = atanh ε and y = ln(l/d), the bicubic spline
of five quantities as value and derivatives at its nodes: ln(So/So_short), φ, Q, Qs/Q and P/p_max.  Between nodes the Hermite
polynomial gives back that spline.  So_short is the closed form of the short bearing, which carries nearly all the variation,
and f* follows from S and φ by `reynolds.friction_variable`.

Accuracy against the direct solution on the same grid, anywhere in the range: 5e-5 in S and f*, 2e-5 in Q (relative), 2e-5 rad in φ,
2e-5 in Qs/Q and 5e-5 in P/p_max.
Range: 0.02 <= ε <= 0.98 and 0.1 <= l/d <= 2; outside, a `FilmRangeError`, never an extrapolation.

Sources: O. Reynolds (1886); H. W. Swift (1932) and W. Stieber (1933) for the end of the film; the quantities as A. A. Raimondi
and J. Boyd, ASLE Transactions 1 (1958) 159-209; the short bearing: F. W. Ocvirk, NACA TN 2808 (1952).
"""

import math
from bisect import bisect_right
from functools import cache, lru_cache
from pathlib import Path
from typing import Any, Generic, Literal, TypeAlias, overload

import numpy as np

from ..sheet.arrays import Array, IndexArray
from ..sheet.record import record
from . import short_bearing
from .reynolds import Value, friction_variable

Outside: TypeAlias = Literal["raise", "nan"]

TABLE = Path(__file__).parents[1] / "tables" / "film_table.npy"
QUANTITIES = ("ln(So/So_short)", "phi", "Q", "Qs/Q", "P/pmax")

SLACK = 1e-9  # relative: a value this far outside, from rounding, counts as the limit
STEP_LIMIT = 1e-9  # Newton's last step, in parts of a table cell; its error is the square of this
ITERATION_LIMIT = 60


class FilmRangeError(ValueError):
    """A film outside the table."""

    def __init__(self, quantity: str, value: float, low: float, high: float, more: str = "") -> None:
        super().__init__(f"{quantity} {value:.6g} is outside the film table, {low:.6g} to {high:.6g}{more}")
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


@overload
def film_at(eccentricity: float, length_ratio: float, *, outside: Outside = ...) -> FilmPoint[float]: ...
@overload
def film_at(eccentricity: Array, length_ratio: Array | float, *, outside: Outside = ...) -> FilmPoint[Array]: ...
@overload
def film_at(eccentricity: float, length_ratio: Array, *, outside: Outside = ...) -> FilmPoint[Array]: ...
def film_at(eccentricity: Any, length_ratio: Any, *, outside: Outside = "raise") -> Any:
    """The film at eccentricity ε and length ratio l/d.  Arrays are broadcast; two scalars give floats.

    Outside the table: `FilmRangeError`, or with outside="nan" a nan at the points concerned.
    """
    if _scalar(eccentricity) and _scalar(length_ratio):
        return _film_scalar(float(eccentricity), float(length_ratio), outside)
    return _film_array(*_broadcast(eccentricity, length_ratio), outside)


@overload
def eccentricity_from(sommerfeld: float, length_ratio: float, *, outside: Outside = ...) -> float: ...
@overload
def eccentricity_from(sommerfeld: Array, length_ratio: Array | float, *, outside: Outside = ...) -> Array: ...
@overload
def eccentricity_from(sommerfeld: float, length_ratio: Array, *, outside: Outside = ...) -> Array: ...
def eccentricity_from(sommerfeld: Any, length_ratio: Any, *, outside: Outside = "raise") -> Any:
    """The eccentricity ε that carries the load: the table's S(ε, l/d), strictly decreasing in ε, turned round.

    Newton's method within one cell of the table, never leaving the bracket.  Arrays are broadcast; two scalars give a float.
    Outside the table: `FilmRangeError`, or with outside="nan" a nan at the points concerned.
    """
    if _scalar(sommerfeld) and _scalar(length_ratio):
        return _eccentricity_scalar(float(sommerfeld), float(length_ratio), outside)
    return _eccentricity_array(*_broadcast(sommerfeld, length_ratio), outside)


@overload
def sommerfeld_range(length_ratio: float) -> tuple[float, float]: ...
@overload
def sommerfeld_range(length_ratio: Array) -> tuple[Array, Array]: ...
def sommerfeld_range(length_ratio: Any) -> Any:
    """The lowest and highest S of the table at l/d: those of ε = 0.98 and ε = 0.02."""
    low, high = _table().eccentricities[[0, -1]]
    return film_at(high, length_ratio).sommerfeld, film_at(low, length_ratio).sommerfeld


def short_bearing_load(eccentricity: Value) -> Value:
    """So/(l/d)² of the infinitely short bearing with half a film: ε·√(π²·(1 − ε²) + 16·ε²)/(2·(1 − ε²)²)  (Ocvirk 1952)."""
    one_long: Any = short_bearing.sommerfeld_din.function  # no line of the calculation: the table's spline is taken over it
    load: Value = one_long(eps=eccentricity, b=1.0)
    return load


def _short_bearing_slope(eccentricity: Value) -> Value:
    """d ln(short_bearing_load)/d(atanh ε)."""
    square = eccentricity**2
    bend = 16.0 - math.pi**2
    slope: Value = (1.0 - square) * (1.0 / eccentricity + bend * eccentricity / (math.pi**2 + bend * square)) + 4.0 * eccentricity
    return slope


# The table ------------------------------------------------------------------------------------------------------------------


@record
class _Table:
    eccentricities: Array  # at the nodes
    length_ratios: Array
    x: Array  # atanh ε at the nodes
    y: Array  # ln(l/d)
    x_list: list[float]  # the same as plain numbers, for bisect
    y_list: list[float]
    short: Array  # ln(short_bearing_load) at the nodes
    rows: Array  # [node of y: value, d/dy; node of x: value, d/dx; quantity], pairs in sequence


@record
class _Column:
    """The table at one l/d: cubics in x."""

    values: Array  # [node of x: value, d/dx; quantity], pairs in sequence
    loads: list[float]  # ln(So/(l/d)²) at the nodes of x, increasing


@cache
def _table() -> _Table:
    stored = np.load(TABLE)[()]
    eccentricities, length_ratios, rows = stored["eccentricity"], stored["length_ratio"], stored["rows"]
    x, y = np.arctanh(eccentricities), np.log(length_ratios)
    short = np.log(short_bearing_load(eccentricities))
    return _Table(eccentricities, length_ratios, x, y, x.tolist(), y.tolist(), short, rows)


@lru_cache(maxsize=128)
def _column(length_ratio: float) -> _Column:
    """Raises FilmRangeError outside the table."""
    table = _table()
    y = math.log(_within("length ratio l/d", length_ratio, table.length_ratios))
    node = min(bisect_right(table.y_list, y), len(table.y_list) - 1) - 1
    step = table.y_list[node + 1] - table.y_list[node]
    weights = np.array(_hermite((y - table.y_list[node]) / step, step))
    four = table.rows[2 * node : 2 * node + 4]
    values = (weights @ four.reshape(4, -1)).reshape(four.shape[1:])
    values.setflags(write=False)
    return _Column(values, (values[::2, 0] + table.short).tolist())


def _hermite(part: Value, step: Value) -> tuple[Value, Value, Value, Value]:
    """Weights of value and derivative at the left node, then at the right one; `part` of the cell from 0 to 1."""
    rest = 1.0 - part
    return rest * rest * (1.0 + 2.0 * part), part * rest * rest * step, part * part * (3.0 - 2.0 * part), -part * part * rest * step


def _cubic(left: Value, left_slope: Value, right: Value, right_slope: Value) -> tuple[Value, Value]:
    """Second and third coefficient of the Hermite polynomial in the part of the cell."""
    return 3.0 * (right - left) - 2.0 * left_slope - right_slope, 2.0 * (left - right) + left_slope + right_slope


def _within(quantity: str, value: float, nodes: Array) -> float:
    low, high = float(nodes[0]), float(nodes[-1])
    if not low * (1.0 - SLACK) <= value <= high * (1.0 + SLACK):
        raise FilmRangeError(quantity, value, low, high)
    return min(max(value, low), high)


# One point ------------------------------------------------------------------------------------------------------------------


def _film_scalar(eccentricity: float, length_ratio: float, outside: Outside) -> FilmPoint[float]:
    try:
        column = _column(length_ratio)
        table = _table()
        inside = _within("eccentricity ratio", eccentricity, table.eccentricities)
    except FilmRangeError:
        if outside == "nan":
            return FilmPoint(*(math.nan,) * 7)
        raise
    x = math.atanh(inside)
    node = min(bisect_right(table.x_list, x), len(table.x_list) - 1) - 1
    step = table.x_list[node + 1] - table.x_list[node]
    weights = np.array(_hermite((x - table.x_list[node]) / step, step))
    load, attitude, flow, side_flow_ratio, pressure_ratio = (weights @ column.values[2 * node : 2 * node + 4]).tolist()
    sommerfeld = math.exp(-load) / (2.0 * math.pi * length_ratio**2 * short_bearing_load(inside))
    friction = friction_variable(inside, sommerfeld, math.sin(attitude))
    return FilmPoint(inside, sommerfeld, attitude, friction, flow, side_flow_ratio, pressure_ratio)


def _eccentricity_scalar(sommerfeld: float, length_ratio: float, outside: Outside) -> float:
    try:
        column = _column(length_ratio)
        low, high = (math.exp(-load) / (2.0 * math.pi * length_ratio**2) for load in (column.loads[-1], column.loads[0]))
        if not low * (1.0 - SLACK) <= sommerfeld <= high * (1.0 + SLACK):
            raise FilmRangeError("Sommerfeld number S", sommerfeld, low, high, f" at l/d {length_ratio:.6g}")
    except FilmRangeError:
        if outside == "nan":
            return math.nan
        raise
    table = _table()
    target = -math.log(2.0 * math.pi * length_ratio**2 * min(max(sommerfeld, low), high))
    node = min(max(bisect_right(column.loads, target), 1), len(column.loads) - 1) - 1
    x, step = table.x_list[node], table.x_list[node + 1] - table.x_list[node]
    left, left_slope, right, right_slope = column.values[2 * node : 2 * node + 4, 0].tolist()
    left_slope, right_slope = step * left_slope, step * right_slope
    second, third = _cubic(left, left_slope, right, right_slope)

    start, end = 0.0, 1.0
    part = (target - column.loads[node]) / (column.loads[node + 1] - column.loads[node])
    part = min(max(part, start), end)
    for _ in range(ITERATION_LIMIT):
        eccentricity = math.tanh(x + part * step)
        error = left + part * (left_slope + part * (second + part * third)) + math.log(short_bearing_load(eccentricity)) - target
        slope = left_slope + part * (2.0 * second + 3.0 * part * third) + step * _short_bearing_slope(eccentricity)
        if error < 0.0:
            start = part
        else:
            end = part
        before, part = part, part - error / slope
        if not start <= part <= end:
            part = 0.5 * (start + end)
        if abs(part - before) < STEP_LIMIT:
            break
    return min(max(math.tanh(x + part * step), float(table.eccentricities[0])), float(table.eccentricities[-1]))


# Many points ----------------------------------------------------------------------------------------------------------------


def _scalar(value: Any) -> bool:
    return isinstance(value, float | int) or np.ndim(value) == 0


def _broadcast(first: float | Array, second: float | Array) -> tuple[Array, Array]:
    one, two = np.broadcast_arrays(np.asarray(first, dtype=np.float64), np.asarray(second, dtype=np.float64))
    return one, two


def _clipped(quantity: str, values: Array, low: Any, high: Any, outside: Outside, more: Array | None = None) -> Array:
    """The values with those outside low to high made nan, or an error that names the first of them."""
    wrong = ~((values >= low * (1.0 - SLACK)) & (values <= high * (1.0 + SLACK)))
    if outside == "raise" and wrong.any():
        at = np.unravel_index(int(wrong.argmax()), wrong.shape)
        lowest, highest = (float(np.broadcast_to(limit, wrong.shape)[at]) for limit in (low, high))
        place = "" if more is None else f" at l/d {more[at]:.6g}"
        count = f" ({int(wrong.sum())} of {wrong.size} values are outside)"
        raise FilmRangeError(quantity, float(values[at]), lowest, highest, place + count)
    return np.where(wrong, np.nan, np.clip(values, low, high))


def _cells(nodes: Array, positions: Array) -> tuple[IndexArray, tuple[Array, Array, Array, Array]]:
    """The cell of each position, and the weights of its nodes; a nan gives nan weights in some cell."""
    cell = np.clip(np.searchsorted(nodes, positions, side="right") - 1, 0, nodes.size - 2)
    step = nodes[cell + 1] - nodes[cell]
    return cell, _hermite((positions - nodes[cell]) / step, step)


def _film_array(eccentricity: Array, length_ratio: Array, outside: Outside) -> FilmPoint[Array]:
    table = _table()
    eccentricity = _clipped("eccentricity ratio", eccentricity, table.eccentricities[0], table.eccentricities[-1], outside)
    length_ratio = _clipped("length ratio l/d", length_ratio, table.length_ratios[0], table.length_ratios[-1], outside)
    eccentricity = np.where(np.isnan(length_ratio), np.nan, eccentricity)
    cell, across = _cells(table.x, np.arctanh(eccentricity))
    row, along = _cells(table.y, np.log(length_ratio))
    values = np.zeros((*eccentricity.shape, len(QUANTITIES)))
    for i in range(4):
        for j in range(4):
            values += (along[i] * across[j])[..., None] * table.rows[2 * row + i, 2 * cell + j]
    load, attitude, flow, side_flow_ratio, pressure_ratio = np.moveaxis(values, -1, 0)
    sommerfeld = np.exp(-load) / (2.0 * math.pi * length_ratio**2 * short_bearing_load(eccentricity))
    friction = friction_variable(eccentricity, sommerfeld, np.sin(attitude))
    return FilmPoint(eccentricity, sommerfeld, attitude, friction, flow, side_flow_ratio, pressure_ratio)


def _eccentricity_array(sommerfeld: Array, length_ratio: Array, outside: Outside) -> Array:
    table = _table()
    length_ratio = _clipped("length ratio l/d", length_ratio, table.length_ratios[0], table.length_ratios[-1], outside)
    row, along = _cells(table.y, np.log(length_ratio))

    def at(pair: IndexArray) -> Array:  # ln(So/So_short), or its slope, at a node of x
        total: Array = sum(along[i] * table.rows[2 * row + i, pair, 0] for i in range(4))
        return total

    ends = (at(np.full_like(row, 2 * node)) + table.short[node] for node in (table.x.size - 1, 0))
    low, high = (np.exp(-load) / (2.0 * math.pi * length_ratio**2) for load in ends)
    sommerfeld = _clipped("Sommerfeld number S", sommerfeld, low, high, outside, more=length_ratio)
    target = -np.log(2.0 * math.pi * length_ratio**2 * sommerfeld)

    cell, beyond = np.zeros_like(row), np.full_like(row, table.x.size - 1)
    for _ in range((table.x.size - 1).bit_length()):
        middle = (cell + beyond) // 2
        above = at(2 * middle) + table.short[middle] <= target
        cell, beyond = np.where(above, middle, cell), np.where(above, beyond, middle)
    cell = np.minimum(cell, table.x.size - 2)

    x, step = table.x[cell], table.x[cell + 1] - table.x[cell]
    left, left_slope, right, right_slope = at(2 * cell), step * at(2 * cell + 1), at(2 * cell + 2), step * at(2 * cell + 3)
    second, third = _cubic(left, left_slope, right, right_slope)
    start, end = np.zeros_like(x), np.ones_like(x)
    part = np.clip((target - left - table.short[cell]) / (right - left + table.short[cell + 1] - table.short[cell]), 0.0, 1.0)
    for _ in range(ITERATION_LIMIT):
        eccentricity = np.tanh(x + part * step)
        error = left + part * (left_slope + part * (second + part * third)) + np.log(short_bearing_load(eccentricity)) - target
        slope = left_slope + part * (2.0 * second + 3.0 * part * third) + step * _short_bearing_slope(eccentricity)
        start, end = np.where(error < 0.0, part, start), np.where(error < 0.0, end, part)
        before, part = part, part - error / slope
        part = np.where((part < start) | (part > end), 0.5 * (start + end), part)
        if not (np.abs(part - before) >= STEP_LIMIT).any():
            break
    return np.clip(np.tanh(x + part * step), table.eccentricities[0], table.eccentricities[-1])
