# SPDX-License-Identifier: Apache-2.0
"""The oil film of a plain bearing from a stored table: microseconds instead of the milliseconds of `reynolds`.

In order: the stored nodes and their polynomials, the film at one point or at many, the same as lines of the
calculation, and the two films that Raimondi and Boyd mark on their chart.

Stored is, over x = atanh ε and y = ln(l/d), the bicubic spline of six quantities: ln(So/So_short), φ, Q, Qs/Q, P/p_max
and ln(C_rr/C_rr,short).  Between nodes the Hermite polynomial gives back that spline.  So_short and C_rr,short are the
closed forms of the short bearing, which carry nearly all the variation, and f* follows from S and φ by
`reynolds.friction_variable`.

Accuracy against the direct solution on the same grid, anywhere in the range: 5e-5 in S and f*, 2e-5 in Q (relative),
2e-5 rad in φ, 2e-5 in Qs/Q and 5e-5 in P/p_max.  C_rr: 1e-3 against a grid twice as fine, 2e-4 root mean square. Range:
0.02 <= ε <= 0.98 and 0.1 <= l/d <= 2; outside, a `FilmRangeError`, never an extrapolation.

Sources: O. Reynolds (1886); H. W. Swift (1932) and W. Stieber (1933) for the end of the film; the quantities as A. A.
Raimondi and J. Boyd, ASLE Transactions 1 (1958) 159-209; the short bearing: F. W. Ocvirk, NACA TN 2808 (1952)."""

import math
import operator
from bisect import bisect_right
from collections.abc import Callable, Iterable
from functools import cache, lru_cache
from pathlib import Path
from typing import Any, Generic, Literal, TypeAlias

import numpy as np

from ....sheet.arrays import Array, IndexArray, Num, Value
from ....sheet.formula import formula
from ....sheet.record import record
from ....sheet.text import EMPTY, Amount, Text
from ....sheet.units import Metre, Newton, Number, PascalSecond, Radian, RevPerSecond
from . import short_bearing
from .reynolds import friction_variable

# --- the stored nodes and the polynomials between them
# The table (`tables/film_table.npy`, written by `build_table`) holds each quantity as value and derivatives at its
# nodes.

Outside: TypeAlias = Literal["raise", "nan"]

TABLE = Path(__file__).parents[3] / "library" / "tables" / "film_table.npy"
QUANTITIES = ("ln(So/So_short)", "phi", "Q", "Qs/Q", "P/pmax", "ln(C_rr/C_rr,short)")

ECCENTRICITY = Text("eccentricity ratio")
CENTRED = 0.02  # ε: where the table begins
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


# the short bearing's formulas without their lines of the calculation, at one place or many
_load: Any = short_bearing.sommerfeld_din.function
_damping: Any = short_bearing.radial_damping.function


def short_bearing_load(eccentricity: Value) -> Value:
    """So/(l/d)² of the infinitely short bearing with half a film: ε·√(π²·(1 − ε²) + 16·ε²)/(2·(1 − ε²)²)  (Ocvirk
    1952)."""
    load: Value = _load(eps=eccentricity, b=1.0)
    return load


def short_bearing_slope(eccentricity: Value) -> Value:
    """d ln(short_bearing_load)/d(atanh ε)."""
    square = eccentricity**2
    bend = 16.0 - math.pi**2
    slope: Value = (1.0 - square) * (
        1.0 / eccentricity + bend * eccentricity / (math.pi**2 + bend * square)
    ) + 4.0 * eccentricity
    return slope


def short_bearing_damping(eccentricity: Value) -> Value:
    """C_rr·c·ω/F of the infinitely short bearing with half a film."""
    damping: Value = _damping(eps=eccentricity)
    return damping


# --- the table


@record
class FilmTable:
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
def film_nodes() -> FilmTable:
    stored = np.load(TABLE)[()]
    eccentricities, length_ratios, rows = stored["eccentricity"], stored["length_ratio"], stored["rows"]
    x, y = np.arctanh(eccentricities), np.log(length_ratios)
    short = np.log(short_bearing_load(eccentricities))
    return FilmTable(eccentricities, length_ratios, x, y, x.tolist(), y.tolist(), short, rows)


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
    return (
        rest * rest * (1.0 + 2.0 * part),
        part * rest * rest * step,
        part * part * (3.0 - 2.0 * part),
        -part * part * rest * step,
    )


def hermite_slope(part: Value, step: Value) -> tuple[Value, Value, Value, Value]:
    """The derivatives of those weights over the variable itself."""
    rest = 1.0 - part
    value = 6.0 * part * rest / step
    return -value, rest * (1.0 - 3.0 * part), value, part * (3.0 * part - 2.0)


Weights = Callable[[Array, Array], tuple[Array, Array, Array, Array]]


def cubic(left: Value, left_slope: Value, right: Value, right_slope: Value) -> tuple[Value, Value]:
    """Second and third coefficient of the Hermite polynomial in the part of the cell."""
    return 3.0 * (right - left) - 2.0 * left_slope - right_slope, 2.0 * (left - right) + left_slope + right_slope


def within(quantity: str, value: float, nodes: Array) -> float:
    low, high = float(nodes[0]), float(nodes[-1])
    if not low * (1.0 - SLACK) <= value <= high * (1.0 + SLACK):
        raise FilmRangeError(quantity, value, low, high)
    return min(max(value, low), high)


def cells(nodes: Array, positions: Array, weights: Weights = hermite) -> tuple[IndexArray, tuple[Array, ...]]:
    """The cell of each position, and the weights of its nodes; a nan gives nan weights in some cell."""
    cell = np.minimum(np.maximum(np.searchsorted(nodes, positions, side="right") - 1, 0), nodes.size - 2)
    step = nodes[cell + 1] - nodes[cell]
    return cell, weights((positions - nodes[cell]) / step, step)


def clipped(
    quantity: str, values: Array, low: float | Array, high: float | Array, outside: Outside, more: Array | None = None
) -> Array:
    """The values with those outside low to high made nan, or an error that names the first of them."""
    wrong = ~((values >= low * (1.0 - SLACK)) & (values <= high * (1.0 + SLACK)))
    if outside == "raise" and wrong.any():
        at = np.unravel_index(int(wrong.argmax()), wrong.shape)
        lowest, highest = (float(np.broadcast_to(limit, wrong.shape)[at]) for limit in (low, high))
        place = EMPTY
        if more is not None:
            place = Text(
                " at l/d {broadcast_to}", broadcast_to=Amount(float(np.broadcast_to(more, wrong.shape)[at]), form=".6g")
            )
        count = Text(" ({sum} of {size} values are outside)", sum=int(wrong.sum()), size=wrong.size)
        raise FilmRangeError(quantity, float(values[at]), lowest, highest, place + count)
    return np.where(wrong, np.nan, np.minimum(np.maximum(values, low), high))


# --- the film at any eccentricity and length

STEP_LIMIT = 1e-6  # Newton's last step, in parts of a table cell; the error behind it is its square
ITERATION_LIMIT = 60
ALL = slice(None)  # quantities of the table


def film_at(eccentricity: Value, length_ratio: Num, *, outside: Outside = "raise") -> FilmPoint[Value]:
    """The film at eccentricity ε and length ratio l/d, without dimensions, by the table of Reynolds' equation.  Arrays
    are broadcast, and give arrays; two numbers give numbers.

    Outside the table: `FilmRangeError`, or with outside="nan" a nan at the points concerned.
    """
    if _scalar(eccentricity) and _scalar(length_ratio):
        return _film_scalar(float(eccentricity), float(length_ratio), outside)
    return _film_array(*_many(eccentricity, length_ratio), outside)


def film_parts(eccentricity: Any, length_ratio: Any, *, outside: Outside = "raise") -> tuple[Any, Any, Any, Any]:
    """φ, Q/(r·c·N·l), Qs/Q and P/p_max: of `film_at` what a balance of heat asks for again and again."""
    if not (_scalar(eccentricity) and _scalar(length_ratio)):
        _, _, values = _read(*_many(eccentricity, length_ratio), outside)
        return values[..., 1], values[..., 2], values[..., 3], values[..., 4]
    try:
        _, (_, attitude, flow, side_flow_ratio, pressure_ratio, _) = _read_scalar(eccentricity, length_ratio)
    except FilmRangeError:
        if outside == "nan":
            return (math.nan,) * 4
        raise
    return attitude, flow, side_flow_ratio, pressure_ratio


def film_slopes(eccentricity: Value, length_ratio: Num, *, outside: Outside = "raise") -> tuple[Value, Value]:
    """d ln So/dε and dφ/dε of the table at constant l/d, rad: how load and its direction answer to a displaced
    journal."""
    eps, _, values = _read(*_many(eccentricity, length_ratio), outside, hermite_slope)
    per_eccentricity = 1.0 / (1.0 - eps**2)  # dx/dε
    load, attitude = (values[..., 0] + short_bearing_slope(eps)) * per_eccentricity, values[..., 1] * per_eccentricity
    slopes: tuple[Any, Any] = (load, attitude) if eps.ndim else (float(load), float(attitude))
    return slopes


def film_hold(eccentricity: Any, length_ratio: Any) -> tuple[Any, Any, Any, Any]:
    """S, d ln So/dε, φ and dφ/dε: of `film_at` and `film_slopes` what is asked for again and again.

    Outside the table one point raises FilmRangeError; of arrays nan."""
    if not (_scalar(eccentricity) and _scalar(length_ratio)):
        return _hold_array(*_many(eccentricity, length_ratio))
    column, table = column_at(length_ratio), film_nodes()
    eps = within(ECCENTRICITY, eccentricity, table.eccentricities)
    x = math.atanh(eps)
    node = min(bisect_right(table.x_list, x), len(table.x_list) - 1) - 1
    step = table.x_list[node + 1] - table.x_list[node]
    part = (x - table.x_list[node]) / step
    (So_0, phi_0), (So_1, phi_1), (So_2, phi_2), (So_3, phi_3) = column.values[2 * node : 2 * node + 4, :2].tolist()
    a, b, c, d = hermite(part, step)
    load, attitude = a * So_0 + b * So_1 + c * So_2 + d * So_3, a * phi_0 + b * phi_1 + c * phi_2 + d * phi_3
    sommerfeld = math.exp(-load) / (2.0 * math.pi * length_ratio**2 * short_bearing_load(eps))
    a, b, c, d = hermite_slope(part, step)
    load, turning = a * So_0 + b * So_1 + c * So_2 + d * So_3, a * phi_0 + b * phi_1 + c * phi_2 + d * phi_3
    per_eccentricity = 1.0 / (1.0 - eps**2)  # dx/dε
    return sommerfeld, (load + short_bearing_slope(eps)) * per_eccentricity, attitude, turning * per_eccentricity


def eccentricity_from(sommerfeld: Value, length_ratio: Num, *, outside: Outside = "raise") -> Value:
    """The eccentricity ε that carries the load: the table's S(ε, l/d), strictly decreasing in ε, turned round.

    Newton's method within one cell of the table, never leaving the bracket.  Arrays are broadcast; two scalars give a
    float. Outside the table: `FilmRangeError`, or with outside="nan" a nan at the points concerned."""
    eccentricity: Any
    if _scalar(sommerfeld) and _scalar(length_ratio):
        eccentricity = _eccentricity_scalar(float(sommerfeld), float(length_ratio), outside)
    else:
        eccentricity = _eccentricity_array(*_many(sommerfeld, length_ratio), outside)
    return eccentricity  # type: ignore[no-any-return]


# --- one point


def _read_scalar(eccentricity: float, length_ratio: float) -> tuple[float, list[float]]:
    """ε within the table, and its quantities there."""
    column, table = column_at(length_ratio), film_nodes()
    inside = within(ECCENTRICITY, eccentricity, table.eccentricities)
    x = math.atanh(inside)
    node = min(bisect_right(table.x_list, x), len(table.x_list) - 1) - 1
    step = table.x_list[node + 1] - table.x_list[node]
    weights = np.array(hermite((x - table.x_list[node]) / step, step))
    return inside, (weights @ column.values[2 * node : 2 * node + 4]).tolist()


def _film_scalar(eccentricity: float, length_ratio: float, outside: Outside) -> FilmPoint[Any]:
    try:
        inside, values = _read_scalar(eccentricity, length_ratio)
    except FilmRangeError:
        if outside == "nan":
            return FilmPoint(*(math.nan,) * 8)
        raise
    load, attitude, flow, side_flow_ratio, pressure_ratio, damping = values
    sommerfeld = math.exp(-load) / (2.0 * math.pi * length_ratio**2 * short_bearing_load(inside))
    friction = friction_variable(inside, sommerfeld, math.sin(attitude))
    damping = short_bearing_damping(inside) * math.exp(damping)
    return FilmPoint(inside, sommerfeld, attitude, friction, flow, side_flow_ratio, pressure_ratio, damping)


def _eccentricity_scalar(sommerfeld: float, length_ratio: float, outside: Outside) -> float:
    try:
        column = column_at(length_ratio)
        low, high = (
            math.exp(-load) / (2.0 * math.pi * length_ratio**2) for load in (column.loads[-1], column.loads[0])
        )
        if not low * (1.0 - SLACK) <= sommerfeld <= high * (1.0 + SLACK):
            raise FilmRangeError(
                Text("Sommerfeld number S"),
                sommerfeld,
                low,
                high,
                Text(" at l/d {length_ratio}", length_ratio=Amount(length_ratio, form=".6g")),
            )
    except FilmRangeError:
        if outside == "nan":
            return math.nan
        raise
    table = film_nodes()
    target = -math.log(2.0 * math.pi * length_ratio**2 * min(max(sommerfeld, low), high))
    node = min(max(bisect_right(column.loads, target), 1), len(column.loads) - 1) - 1
    x, step = table.x_list[node], table.x_list[node + 1] - table.x_list[node]
    left, left_slope, right, right_slope = column.values[2 * node : 2 * node + 4, 0].tolist()
    left_slope, right_slope = step * left_slope, step * right_slope
    second, third = cubic(left, left_slope, right, right_slope)

    start, end = 0.0, 1.0
    part = (target - column.loads[node]) / (column.loads[node + 1] - column.loads[node])
    part = min(max(part, start), end)
    for _ in range(ITERATION_LIMIT):
        eccentricity = math.tanh(x + part * step)
        error = (
            left
            + part * (left_slope + part * (second + part * third))
            + math.log(short_bearing_load(eccentricity))
            - target
        )
        slope = left_slope + part * (2.0 * second + 3.0 * part * third) + step * short_bearing_slope(eccentricity)
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


# --- many points


def _scalar(value: float | Array) -> bool:
    return isinstance(value, (float, int)) or np.ndim(value) == 0


def _many(first: float | Array, second: float | Array) -> tuple[Array, Array]:
    """The first as an array, the second broadcast to it; one l/d for all stays one, or becomes one."""
    first_array, two = np.asarray(first, dtype=np.float64), np.asarray(second, dtype=np.float64)
    if two.ndim and two.size and (two == two.flat[0]).all():
        first_array, two = np.broadcast_arrays(first_array, two)[0], two.ravel()[0]
    return (first_array, two) if two.ndim == 0 else tuple(np.broadcast_arrays(first_array, two))  # type: ignore[return-value]


def _sum(parts: Iterable[Array]) -> Array:
    return sum(parts)  # type: ignore[return-value]


def _reader(length_ratio: Array, outside: Outside) -> tuple[Array, Callable[[IndexArray, int | slice], Array]]:
    """l/d within the table, and `read(nodes, quantities)`: the table's rows at nodes of x, at the l/d of each point."""
    table = film_nodes()
    length_ratio = clipped(
        Text("length ratio l/d"), length_ratio, table.length_ratios[0], table.length_ratios[-1], outside
    )
    if length_ratio.ndim == 0 and not np.isnan(length_ratio):
        values = column_at(float(length_ratio)).values
        return length_ratio, lambda nodes, quantities: values[nodes, quantities]
    row, along = cells(table.y, np.log(length_ratio))

    def read(nodes: IndexArray, quantities: int | slice) -> Array:
        parts = (table.rows[2 * row + i, nodes, quantities] for i in range(4))
        return _sum(
            (weight if part.ndim == weight.ndim else weight[..., None]) * part for weight, part in zip(along, parts)
        )

    return length_ratio, read


def _read(
    eccentricity: Array, length_ratio: Array, outside: Outside, weights: Weights = hermite
) -> tuple[Array, Array, Array]:
    """ε and l/d within the table, and its quantities there, along the last axis."""
    table = film_nodes()
    eccentricity = clipped(ECCENTRICITY, eccentricity, table.eccentricities[0], table.eccentricities[-1], outside)
    length_ratio, read = _reader(length_ratio, outside)
    eccentricity = np.where(np.isnan(length_ratio), np.nan, eccentricity)
    cell, across = cells(table.x, np.arctanh(eccentricity), weights)
    return eccentricity, length_ratio, _sum(across[j][..., None] * read(2 * cell + j, ALL) for j in range(4))


def _film_array(eccentricity: Array, length_ratio: Array, outside: Outside) -> FilmPoint[Any]:
    eccentricity, length_ratio, values = _read(eccentricity, length_ratio, outside)
    load, attitude, flow, side_flow_ratio, pressure_ratio, damping = np.moveaxis(values, -1, 0)
    sommerfeld = np.exp(-load) / (2.0 * math.pi * length_ratio**2 * short_bearing_load(eccentricity))
    friction = friction_variable(eccentricity, sommerfeld, np.sin(attitude))
    damping = short_bearing_damping(eccentricity) * np.exp(damping)
    return FilmPoint(eccentricity, sommerfeld, attitude, friction, flow, side_flow_ratio, pressure_ratio, damping)


def _hold_array(eccentricity: Array, length_ratio: Array) -> tuple[Array, Array, Array, Array]:
    table = film_nodes()
    eps = clipped(ECCENTRICITY, eccentricity, table.eccentricities[0], table.eccentricities[-1], "nan")
    length_ratio, read = _reader(length_ratio, "nan")
    x = np.arctanh(eps)
    cell, across = cells(table.x, x)
    _, slopes = cells(table.x, x, hermite_slope)
    nodes = [[read(2 * cell + j, quantity) for j in range(4)] for quantity in range(2)]
    load, attitude = (_sum(map(operator.mul, across, of_one)) for of_one in nodes)
    load_slope, turning = (_sum(map(operator.mul, slopes, of_one)) for of_one in nodes)
    sommerfeld = np.exp(-load) / (2.0 * math.pi * length_ratio**2 * short_bearing_load(eps))
    per_eccentricity = 1.0 / (1.0 - eps**2)  # dx/dε
    return sommerfeld, (load_slope + short_bearing_slope(eps)) * per_eccentricity, attitude, turning * per_eccentricity


def _eccentricity_array(sommerfeld: Array, length_ratio: Array, outside: Outside) -> Array:
    table = film_nodes()
    length_ratio, read = _reader(length_ratio, outside)

    def at(nodes: IndexArray) -> Array:  # ln(So/So_short), or its slope, at a node of x
        return read(nodes, 0)

    first = np.zeros(np.shape(length_ratio), dtype=np.intp)
    ends = (at(first + 2 * node) + table.short[node] for node in (table.x.size - 1, 0))
    low, high = (np.exp(-load) / (2.0 * math.pi * length_ratio**2) for load in ends)
    sommerfeld = clipped(Text("Sommerfeld number S"), sommerfeld, low, high, outside, more=length_ratio)
    target = -np.log(2.0 * math.pi * length_ratio**2 * sommerfeld)

    if length_ratio.ndim == 0 and not np.isnan(length_ratio):
        cell = np.searchsorted(column_at(float(length_ratio)).loads, target, side="right") - 1
        cell = np.minimum(np.maximum(cell, 0), table.x.size - 2)
    else:
        cell = np.zeros(sommerfeld.shape, dtype=np.intp)
        beyond = cell + table.x.size - 1
        for _ in range((table.x.size - 1).bit_length()):
            middle = (cell + beyond) // 2
            above = at(2 * middle) + table.short[middle] <= target
            cell, beyond = np.where(above, middle, cell), np.where(above, beyond, middle)
        cell = np.minimum(cell, table.x.size - 2)

    x, step = table.x[cell], table.x[cell + 1] - table.x[cell]
    left, left_slope, right, right_slope = (at(2 * cell + k) for k in range(4))
    left_slope, right_slope = step * left_slope, step * right_slope
    second, third = cubic(left, left_slope, right, right_slope)
    start, end = np.zeros_like(x), np.ones_like(x)
    part = np.clip(
        (target - left - table.short[cell]) / (right - left + table.short[cell + 1] - table.short[cell]), 0.0, 1.0
    )
    for _ in range(ITERATION_LIMIT):
        eccentricity = np.tanh(x + part * step)
        error = (
            left
            + part * (left_slope + part * (second + part * third))
            + np.log(short_bearing_load(eccentricity))
            - target
        )
        slope = left_slope + part * (2.0 * second + 3.0 * part * third) + step * short_bearing_slope(eccentricity)
        start, end = np.where(error < 0.0, part, start), np.where(error < 0.0, end, part)
        before, part = part, part - error / slope
        part = np.where((part < start) | (part > end), 0.5 * (start + end), part)
        if not (np.abs(part - before) >= STEP_LIMIT).any():
            break
    return np.clip(np.tanh(x + part * step), table.eccentricities[0], table.eccentricities[-1])


# --- the film as lines of the calculation

SOURCE = Text("Reynolds 1886, full bearing with Swift–Stieber film end; this program's own solution, tabulated")
_film_at = lru_cache(maxsize=4)(film_at)  # five lines of a calculation ask for the same point
_film_slopes = lru_cache(maxsize=4)(film_slopes)


def traced_film_at(eps: Number, b: Number) -> FilmPoint[float]:
    return _film_at(eps, b) if _plain(eps, b) else film_at(eps, b)


def traced_film_slopes(eps: Number, b: Number) -> tuple[float, float]:
    return _film_slopes(eps, b) if _plain(eps, b) else film_slopes(eps, b)


def _plain(*numbers: object) -> bool:
    """No arrays, which can not be looked up."""
    return all([isinstance(number, (float, int)) for number in numbers])


@formula("ε", SOURCE, shows="ε from S(ε, l/d): table of Reynolds' solutions, inverted", names={"b": "l/d"})
def eccentricity(S: Number, b: Number) -> Number:
    """>>> eccentricity(S=0.05436, b=0.4622)
    0.8637773...
    """
    return eccentricity_from(S, b)


@formula(
    "F_c",
    Text("{source}: load of a journal that runs nearly centred", source=SOURCE),
    shows="μ·n·l·d/(S(ε, l/d)·ψ²) at ε = 0.02, where the table begins",
    names={"n_h": "n", "b": "l/d"},
)
def centred_load(mu: PascalSecond, n_h: RevPerSecond, d: Metre, l: Metre, psi: Number, b: Number) -> Newton:
    """The most that a journal carries which runs nearly centred: there the film is a spring.  `l`: of one land."""
    return mu * n_h * d * l / (traced_film_at(CENTRED, b).sommerfeld * psi**2)


@formula("φ", SOURCE, shows="φ from the table of Reynolds' solutions at ε, l/d", names={"b": "l/d"})
def attitude_angle(eps: Number, b: Number) -> Radian:
    """>>> attitude_angle(eps=0.8638, b=0.4622)
    0.4707118...
    """
    return traced_film_at(eps, b).attitude


@formula("Q*", SOURCE, shows="Q* = Q/(r·c·n·l) from the table of Reynolds' solutions at ε, l/d", names={"b": "l/d"})
def relative_flow(eps: Number, b: Number) -> Number:
    return traced_film_at(eps, b).flow


@formula("Q_s/Q", SOURCE, shows="Q_s/Q from the table of Reynolds' solutions at ε, l/d", names={"b": "l/d"})
def side_flow_share(eps: Number, b: Number) -> Number:
    return traced_film_at(eps, b).side_flow_ratio


@formula("p/p_max", SOURCE, shows="p/p_max from the table of Reynolds' solutions at ε, l/d", names={"b": "l/d"})
def pressure_ratio(eps: Number, b: Number) -> Number:
    return traced_film_at(eps, b).pressure_ratio


# --- between the largest load and the least friction
# The two films h₀/c that Raimondi and Boyd mark on their chart.
#
# With the smallest film h₀ held, c = h₀/(1 − ε): the load goes with (1 − ε)²/S, the coefficient of friction with f*/(1
# − ε).

ECCENTRICITIES = np.linspace(0.04, 0.97, 94)
RAIMONDI_BOYD = Text("Raimondi & Boyd 1958, chart of the smallest film")


@formula(
    "b_f",
    Text("{chart}: 0 at the least friction, 100 % at the largest load", chart=RAIMONDI_BOYD),
    unit="%",
    names={"eps": "ε", "share_f": "(h_0/c)_f", "share_F": "(h_0/c)_F"},
)
def place_in_band(eps: Number, share_f: Number, share_F: Number) -> Number:
    return (1 - eps - share_f) / (share_F - share_f)


@formula("(h_0/c)_F", RAIMONDI_BOYD, names={"b": "l/d"}, shows="where (1 − ε)²/S of this l/d is largest")
def share_of_largest_load(b: Number) -> Number:
    """Published for l/d 1, ½ and ¼, as read from the chart: 0.53, 0.43 and 0.27 (from memory of Shigley).

    >>> share_of_largest_load(b=1.0)
    0.53...
    """
    film = film_at(ECCENTRICITIES, b)
    return _summit((1 - ECCENTRICITIES) ** 2 / film.sommerfeld)


@formula("(h_0/c)_f", RAIMONDI_BOYD, names={"b": "l/d"}, shows="where f*/(1 − ε) of this l/d is smallest")
def share_of_least_friction(b: Number) -> Number:
    """Published for l/d 1, ½ and ¼, as read from the chart: 0.30, 0.12 and 0.03 (from memory of Shigley).

    >>> share_of_least_friction(b=1.0)
    0.33...
    """
    film = film_at(ECCENTRICITIES, b)
    return _summit(-film.friction / (1 - ECCENTRICITIES))


def _summit(y: Array) -> float:
    """h₀/c where y is largest, by the parabola through its three highest points; at an end of the range that end."""
    at = int(np.argmax(y))
    share = float(1 - ECCENTRICITIES[at])
    if at == 0 or at == len(y) - 1:
        return share
    below, middle, above = map(float, y[at - 1 : at + 2])
    step = float(ECCENTRICITIES[1] - ECCENTRICITIES[0])
    return share - step / 2 * (below - above) / (below - 2 * middle + above)
