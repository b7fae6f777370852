# SPDX-License-Identifier: Apache-2.0
"""The film with its feed in daily use: solutions of `grooved` at some eccentricities of one bearing, and splines between them.

A table of its own for each l/d and each set of feeds, made when it is first asked for (three quarters of a second) and kept.  The feed's
pressure is left out of the film's own.  Against grids four times as fine: 1e-3 in S and φ, 2e-3 in the side flow, 1e-2 in the stiffness,
4e-2 in the damping.
"""

import math
from functools import lru_cache
from typing import Generic, overload

import numpy as np

from ...sheet.arrays import Array
from ...sheet.formula import formula
from ...sheet.record import record
from ...sheet.text import Text
from ...sheet.units import Number, Radian
from .feeds import Feed, Feeds
from .grooved import sheared, solve_grooved
from .nodes import FilmRangeError, short_bearing_load
from .reynolds import ECCENTRICITY_RANGE, Value

NODES = 25  # even in atanh ε
CELLS = (96, 16)
FINE = 4001  # places at which S is laid out for its inversion
SOURCE = Text("Reynolds 1886, bearing with axial grooves, Swift–Stieber film end; this program's own solution")


@record
class GroovedTable:
    """Splines over x = atanh ε: values at the nodes and their second derivatives, [node, quantity]; ln(So/So_short) first."""

    x: Array
    values: Array
    bends: Array
    fine_x: Array
    fine_load: Array  # ln So at fine_x, rising

    def at(self, x: Array) -> Array:
        cell = np.clip(np.searchsorted(self.x, x, side="right") - 1, 0, self.x.size - 2)
        step = self.x[1] - self.x[0]
        right = ((x - self.x[cell]) / step)[..., None]
        left = 1.0 - right
        found: Array = left * self.values[cell] + right * self.values[cell + 1]
        found += step**2 / 6 * ((left**3 - left) * self.bends[cell] + (right**3 - right) * self.bends[cell + 1])
        return found


@record
class GroovedPoint(Generic[Value]):
    """As in `grooved.GroovedFilm`."""

    eccentricity: Value
    sommerfeld: Value
    attitude: Value
    side_flow: Value
    pressure_ratio: Value
    sheared: Value  # ∫dθ/h where there is land, over that of the whole circumference
    k_xx: Value
    k_xy: Value
    k_yx: Value
    k_yy: Value
    c_xx: Value
    c_xy: Value
    c_yy: Value


@lru_cache(maxsize=32)
def grooved_table(length_ratio: float, feeds: tuple[Feed, ...]) -> GroovedTable:
    low, high = ECCENTRICITY_RANGE
    x = np.linspace(math.atanh(low), math.atanh(high), NODES)
    rows = []
    for eps in np.tanh(x).tolist():
        film = solve_grooved(min(max(eps, low), high), length_ratio, feeds, cells=CELLS)
        load = -math.log(2 * math.pi * film.sommerfeld * length_ratio**2 * short_bearing_load(eps))
        rates = (film.k_xx, film.k_xy, film.k_yx, film.k_yy, film.c_xx, (film.c_xy + film.c_yx) / 2, film.c_yy)
        land = sheared(eps, film.attitude, feeds) / (2 * math.pi / math.sqrt(1 - eps**2))
        rows.append([load, film.attitude, film.side_flow, film.pressure_ratio, land, *(rate * eps * (1 - eps) for rate in rates)])
    values = np.array(rows)
    fine = np.linspace(x[0], x[-1], FINE)
    table = GroovedTable(x, values, _bends(values, x[1] - x[0]), fine, np.zeros(0))
    return GroovedTable(x, values, table.bends, fine, table.at(fine)[:, 0] + np.log(length_ratio**2 * short_bearing_load(np.tanh(fine))))


def _bends(values: Array, step: float) -> Array:
    """Second derivatives of the spline whose third derivative does not jump at the last nodes but one."""
    n = values.shape[0]
    matrix = np.diag(np.full(n, 4.0)) + np.diag(np.ones(n - 1), 1) + np.diag(np.ones(n - 1), -1)
    matrix[0, :3] = matrix[-1, :-4:-1] = 1.0, -2.0, 1.0
    right = np.zeros_like(values)
    right[1:-1] = 6 * (values[2:] - 2 * values[1:-1] + values[:-2]) / step**2
    return np.asarray(np.linalg.solve(matrix, right))


@overload
def eccentricity_from(sommerfeld: float, length_ratio: float, feeds: Feeds, *, outside: str = ...) -> float: ...
@overload
def eccentricity_from(sommerfeld: Array, length_ratio: float, feeds: Feeds, *, outside: str = ...) -> Array: ...
def eccentricity_from(sommerfeld: float | Array, length_ratio: float, feeds: Feeds, *, outside: str = "raise") -> float | Array:
    """ε at S; floats or arrays.  Outside ε 0.02 to 0.98: FilmRangeError, or with outside="nan" a nan."""
    table = grooved_table(float(length_ratio), feeds.feeds)
    S = np.asarray(sommerfeld, dtype=float)
    with np.errstate(all="ignore"):
        load = -np.log(2 * math.pi * S)
    inside = (load >= table.fine_load[0]) & (load <= table.fine_load[-1])
    if outside == "raise" and not inside.all():
        low, high = (math.exp(-table.fine_load[at]) / (2 * math.pi) for at in (-1, 0))
        raise FilmRangeError(Text("Sommerfeld number S"), float(S[~inside][0]) if S.ndim else float(S), low, high)
    eps = np.where(inside, np.tanh(np.interp(np.nan_to_num(load), table.fine_load, table.fine_x)), np.nan)
    return eps if S.ndim else float(eps)


@overload
def film_at(eccentricity: float, length_ratio: float, feeds: Feeds) -> GroovedPoint[float]: ...
@overload
def film_at(eccentricity: Array, length_ratio: float, feeds: Feeds) -> GroovedPoint[Array]: ...
def film_at(eccentricity: float | Array, length_ratio: float, feeds: Feeds) -> GroovedPoint[float] | GroovedPoint[Array]:
    """The film at ε; nan gives nan."""
    table = grooved_table(float(length_ratio), feeds.feeds)
    eps = np.asarray(eccentricity, dtype=float)
    values = np.moveaxis(table.at(np.arctanh(eps)), -1, 0)
    S = np.exp(-values[0]) / (2 * math.pi * length_ratio**2 * short_bearing_load(eps))
    found = [eps, S, *values[1:5], *(values[5:] / (eps * (1 - eps)))]
    return GroovedPoint(*found) if eps.ndim else GroovedPoint(*map(float, found))


# --- as lines of the calculation --------------------------------------------------------------------------------------------
@formula("ε", SOURCE, shows="ε from S(ε) of the film with its grooves, inverted")
def eccentricity(S: Number, b: Number, grooves: Feeds) -> Number:
    return eccentricity_from(S, b, grooves)


@formula("φ", SOURCE, shows="φ of the film with its grooves at ε")
def attitude_angle(eps: Number, b: Number, grooves: Feeds) -> Radian:
    return film_at(eps, b, grooves).attitude


@formula("Q_s*", SOURCE, shows="Q_s* = Q_s/(r·c·n·l) of the film with its grooves at ε")
def relative_side_flow(eps: Number, b: Number, grooves: Feeds) -> Number:
    return film_at(eps, b, grooves).side_flow


@formula("p/p_max", SOURCE, shows="p/p_max of the film with its grooves at ε")
def pressure_ratio(eps: Number, b: Number, grooves: Feeds) -> Number:
    return film_at(eps, b, grooves).pressure_ratio


@formula("λ", SOURCE, shows="∫dθ/h over the land between the grooves, over that of the whole circumference, at ε")
def sheared_share(eps: Number, b: Number, grooves: Feeds) -> Number:
    return film_at(eps, b, grooves).sheared
