# SPDX-License-Identifier: Apache-2.0
"""Reynolds' equation for a bearing with axial grooves or pockets, where the film begins and ends at its feed.

The feeds keep their angle to the load.  In order: the feeds, the solution, the table of solutions for daily use, the
lines of the calculation.

The plain bearing of `reynolds` draws its oil in at the widest film, wherever the journal goes, so that its force turns
with the line of centres.  Grooves stand where they were cut: the film between them is a pad of its own, and all eight
coefficients must be found.

Film h = 1 − x·cos α − y·sin α over c, α from the load in the sense in which the film is dragged, (x, y) the journal's
place over c; the equation, its film end (Swift–Stieber) and the nodes are those of `reynolds`.  In a groove or pocket
the pressure is that of the feed. Where the journal stands follows from ε by turning the line of centres until the force
lies along the load.  Stiffness and damping are central differences of the force over small displacements and
velocities, each with a film end of its own.

Against Someya's data book (two grooves of 10° at ±90° to the load): see `tests/calc/bearings/plain/test_grooved.py`."""

import math
from collections.abc import Callable
from functools import cache, lru_cache
from typing import Any, Generic, NamedTuple

import numpy as np

from ....sheet.arrays import Array, Value
from ....sheet.arrays import BoolArray as Mask
from ....sheet.formula import formula
from ....sheet.functions import root
from ....sheet.record import record, replace
from ....sheet.text import Text
from ....sheet.units import Number, Radian
from .reynolds import (
    ECCENTRICITY_RANGE,
    EDGE_CLUSTERING,
    ITERATION_LIMIT,
    UNIFORM_SHARE,
    film_integrals,
    links,
    push_of,
    solved_where_active,
)
from .table import FilmRangeError, short_bearing_load

# --- where the oil comes into a film that begins and ends there


class Feed(NamedTuple):
    """A groove or pocket along the bearing.  Two of one size at one place are the same, so that films are found again
    by their feeds."""

    angle: float  # of its middle, from the load in the sense in which the film is dragged, rad
    arc: float  # around, rad
    share: float = 1.0  # of the bearing's length


@record
class Feeds:
    """All of one bearing."""

    feeds: tuple[Feed, ...]


# --- the solution

LEVELS = (4, 2, 1)  # coarser than the finest grid by
TURN_TOLERANCE = 1e-9  # relative, of the attitude angle
NUDGE = 0.02  # of the narrowest film: how far the journal is displaced for its stiffness
# of c·ω·ε·√(1 − ε²): how fast it moves for its damping.  Slower, the film's end stays in its cell, and the damping
# wanders with its place there; faster, the force is no longer a straight line of the velocity
SPEED = 0.025
RATES = ("k_xx", "k_xy", "k_yx", "k_yy", "c_xx", "c_xy", "c_yx", "c_yy")


@record
class GroovedFilm:
    """One state of a film with its feed, dimensionless as in `reynolds.FilmSolution`; stiffness K·c/F, damping
    C·c·ω/F."""

    eccentricity: float
    length_ratio: float
    sommerfeld: float
    attitude: float
    friction: float  # sheared oil everywhere but in the feeds
    side_flow: float  # Q_s/(r·c·N·l): what leaves over both edges
    pressure_ratio: float
    k_xx: float
    k_xy: float
    k_yx: float
    k_yy: float
    c_xx: float
    c_xy: float
    c_yx: float
    c_yy: float


@record
class _Grid:
    alpha: Array  # from the load
    theta: Array  # from the widest film
    around: Array
    across: Array
    film: Array
    conductance: Array
    drag: Array
    sideways: Array
    fixed: Mask  # nodes in a feed, and the two ends


@record
class _Force:
    along: float  # ∬Π·cos α over half the length
    aside: float  # ∬Π·sin α
    side_flow: float
    peak: float


def solve_grooved(
    eccentricity: float,
    length_ratio: float,
    feeds: tuple[Feed, ...],
    *,
    feed_pressure: float = 0.0,
    cells: tuple[int, int] = (192, 12),
) -> GroovedFilm:
    """The film at ε, l/d with axial grooves, and its coefficients, all without dimensions.  Numbers alone.

    `feeds`: the grooves, all of one length; `feed_pressure`: over μ·ω·(r/c)²; `cells`: around and along.  Raises
    ValueError outside 0.02 <= ε <= 0.98."""
    _require(eccentricity, feeds)
    states: list[Array] = []
    phi = math.atan2(math.pi * math.sqrt(1 - eccentricity**2), 4 * eccentricity)
    for coarser in LEVELS:
        force = _force_of(length_ratio, feeds, feed_pressure, (cells[0] // coarser, max(cells[1] // coarser, 4)))
        phi = _attitude(force, eccentricity, phi)
        if coarser <= 2:
            states.append(_state(force, eccentricity, phi))
    coarse, fine = states
    phi, load, side_flow, peak, *stiffness = (fine + (fine - coarse) / 3)[:8].tolist()
    # the film's end moves from node to node: what that does to the damping is no power of the step, to be taken out
    rates = (*(k / load for k in stiffness), *(fine[8:] / fine[1]).tolist())
    So = load / 2
    return GroovedFilm(
        eccentricity=eccentricity,
        length_ratio=length_ratio,
        sommerfeld=1 / (2 * math.pi * So),
        attitude=phi,
        friction=sheared(eccentricity, phi, feeds) / (2 * So) + eccentricity / 2 * math.sin(phi),
        side_flow=side_flow,
        pressure_ratio=load / 2 / peak,
        **dict(zip(RATES, rates)),
    )


def _require(eccentricity: float, feeds: tuple[Feed, ...]) -> None:
    low, high = ECCENTRICITY_RANGE
    if not low <= eccentricity <= high:
        raise ValueError(f"eccentricity ratio {eccentricity:g}: Reynolds' equation is solved from {low:g} to {high:g}")
    if not feeds or len({feed.share for feed in feeds}) > 1:
        raise ValueError("one feed or more, all of one length")
    if overlap(feeds):
        raise ValueError("the feeds overlap")


def overlap(feeds: tuple[Feed, ...]) -> bool:
    turns = sorted((feed.angle % (2 * math.pi), feed.arc) for feed in feeds)
    after = [*turns[1:], (turns[0][0] + 2 * math.pi, turns[0][1])]
    return any(angle + arc / 2 >= other - next_arc / 2 for (angle, arc), (other, next_arc) in zip(turns, after))


Force = Callable[[float, float, float, float], _Force]


def _force_of(length_ratio: float, feeds: tuple[Feed, ...], feed_pressure: float, cells: tuple[int, int]) -> Force:
    """The force of the film for the journal's place and velocity, each along and across the load; starts from the film
    before."""
    before: list[Array] = []

    def force(x: float, y: float, v_x: float = 0.0, v_y: float = 0.0) -> _Force:
        grid = _grid(math.hypot(x, y), math.atan2(y, x), length_ratio, feeds, cells)
        squeeze = -v_x * np.cos(grid.alpha) - v_y * np.sin(grid.alpha)
        pressure = _pressure(grid, squeeze, feed_pressure, before[-1] if before else None)
        before[:] = [pressure]
        return _integrals(grid, pressure)

    return force


def _attitude(force: Force, eccentricity: float, phi: float) -> float:
    """The angle nearest to `phi` at which no force stands across the load.  The force turns about as far as the line of
    centres does, but on one grid by jumps, and beside a groove under the load hardly: the zero is first enclosed."""

    @cache
    def across(angle: float) -> float:
        components = force(eccentricity * math.cos(angle), eccentricity * math.sin(angle), 0.0, 0.0)
        return math.atan2(components.aside, components.along)

    back = 2 * across(phi)
    while across(phi) * across(phi - back) > 0:
        back *= 2
        if abs(back) > math.pi:
            raise ArithmeticError(Text("no attitude angle found"))
    return root(across, phi, phi - back, tolerance=TURN_TOLERANCE)


def _state(force: Force, eccentricity: float, phi: float) -> Array:
    """φ, load, side flow, largest pressure, and the eight rates of the force."""
    x, y = eccentricity * math.cos(phi), eccentricity * math.sin(phi)
    at_rest = force(x, y, 0.0, 0.0)
    step, speed = NUDGE * (1 - eccentricity), SPEED * eccentricity * math.sqrt(1 - eccentricity**2)
    rates = []
    for d_x, d_y, v_x, v_y, size in (
        (step, 0, 0, 0, step),
        (0, step, 0, 0, step),
        (0, 0, speed, 0, speed),
        (0, 0, 0, speed, speed),
    ):
        ahead, behind = force(x + d_x, y + d_y, v_x, v_y), force(x - d_x, y - d_y, -v_x, -v_y)
        rates.append([(ahead.along - behind.along) / (2 * size), (ahead.aside - behind.aside) / (2 * size)])
    (k_xx, k_yx), (k_xy, k_yy), (c_xx, c_yx), (c_xy, c_yy) = rates
    load = math.hypot(at_rest.along, at_rest.aside)
    return np.array([phi, load, at_rest.side_flow, at_rest.peak, k_xx, k_xy, k_yx, k_yy, c_xx, c_xy, c_yx, c_yy])


def sheared(eccentricity: float, phi: float, feeds: tuple[Feed, ...]) -> float:
    """∫dα/h over the land, the feeds' share of the length left out."""
    shear = 2 * math.pi / math.sqrt(1 - eccentricity**2)
    for feed in feeds:
        from_widest = math.pi - phi + feed.angle
        start, end = (_gamma(from_widest + side * feed.arc / 2, eccentricity) for side in (-1, 1))
        shear -= feed.share * (end - start) / math.sqrt(1 - eccentricity**2)  # ∫dθ/h = γ/√(1 − ε²)
    return shear


def _gamma(theta: float, eccentricity: float) -> float:
    """Sommerfeld's angle of θ, whole turns kept."""
    turns = round(theta / (2 * math.pi))
    rest = theta - 2 * math.pi * turns
    half = math.atan2(
        math.sqrt(1 - eccentricity) * math.sin(rest / 2), math.sqrt(1 + eccentricity) * math.cos(rest / 2)
    )
    return 2 * half + 2 * math.pi * turns


def _turn(gamma: float, spread: float) -> float:
    """The turn whose spread is γ: turn − spread·sin(turn) = γ."""
    turn = gamma
    for _ in range(50):
        error = turn - spread * math.sin(turn) - gamma
        turn -= error / (1 - spread * math.cos(turn))
        if abs(error) < 1e-14:
            break
    return turn


def _grid(
    eccentricity: float, phi: float, length_ratio: float, feeds: tuple[Feed, ...], cells: tuple[int, int]
) -> _Grid:
    """From the middle of the first feed once round; a node on every edge of a feed, between them as in `reynolds`."""
    narrow = 1.0 - eccentricity**2
    spread = 1.0 - 1.0 / (1.0 - UNIFORM_SHARE + UNIFORM_SHARE * math.sqrt((1.0 + eccentricity) / (1.0 - eccentricity)))
    ordered = sorted(feeds, key=lambda feed: (feed.angle - feeds[0].angle) % (2 * math.pi))
    start = math.pi - phi + feeds[0].angle
    edges, in_feed = [start], [True]
    for feed in ordered:
        middle = start + (feed.angle - feeds[0].angle) % (2 * math.pi)
        if feed is not feeds[0]:
            edges.append(middle - feed.arc / 2)
            in_feed.append(True)
        edges.append(middle + feed.arc / 2)
        in_feed.append(False)
    edges += [start + 2 * math.pi - feeds[0].arc / 2, start + 2 * math.pi]
    in_feed.append(True)
    turns = [_turn(_gamma(edge, eccentricity), spread) for edge in edges]

    pieces = [0.0]
    fixed = [True]
    weights = [0.0]
    for a, b, fed in zip(turns, turns[1:], in_feed):
        count = 2 * max(1, round(cells[0] / 2 * (b - a) / (2 * math.pi)))
        steps = np.linspace(a, b, count + 1)
        half = (b - a) / count / 2
        weights[-1] += half
        weights += [2 * half] * (count - 1) + [half]
        pieces = [*(pieces if len(pieces) > 1 else [a]), *steps[1:].tolist()]
        fixed[-1] = fixed[-1] or fed
        fixed += [fed] * count
    turn = np.array(pieces)
    gamma = turn - spread * np.sin(turn)
    film = narrow / (1.0 - eccentricity * np.cos(gamma))
    theta = 2.0 * np.arctan2(
        math.sqrt(1.0 + eccentricity) * np.sin(gamma / 2), math.sqrt(1.0 - eccentricity) * np.cos(gamma / 2)
    )
    around = np.array(weights) * (1.0 - spread * np.cos(turn)) * film / math.sqrt(narrow)
    square, cube = film_integrals(gamma, eccentricity)
    conductance = 1.0 / np.diff(cube)
    drag = 6.0 * np.diff(square) * conductance

    z = nodes_across(feeds[0].share, cells[1])
    gap = np.diff(z)
    across = 0.5 * (np.append(gap, 0.0) + np.append(0.0, gap))
    sideways = (film**3 * around / length_ratio**2)[:, None] / gap
    held = np.array(fixed)[:, None] & (z[:-1] <= feeds[0].share + 1e-12)
    held[0] = held[-1] = True
    return _Grid(theta - math.pi + phi, theta, around, across, film, conductance, drag, sideways, held)


def nodes_across(share: float, cells: int) -> Array:
    """From the middle to the edge, closer towards the edge; one on the end of a pocket."""
    if share >= 1.0:
        return np.tanh(np.linspace(0.0, EDGE_CLUSTERING, cells + 1)) / math.tanh(EDGE_CLUSTERING)
    inner = min(max(round(cells * share / 2) * 2, 2), cells - 2)
    towards = np.tanh(np.linspace(0.0, EDGE_CLUSTERING, inner + 1)) / math.tanh(EDGE_CLUSTERING) * share
    beyond = share + (1 - share) * 0.5 * (1 - np.cos(np.linspace(0.0, math.pi, cells - inner + 1)))
    return np.append(towards, beyond[1:])


def _pressure(grid: _Grid, squeeze: Array, feed_pressure: float, guess: Array | None) -> Array:
    """Π at all nodes: the complementarity problem of `reynolds`, with nodes that are held."""
    inner = grid.across[:-1]
    aside = grid.sideways[1:-1]
    along, diagonal = links(grid.conductance, inner, aside)
    source = (-np.diff(grid.drag) - 12.0 * (squeeze * grid.around)[1:-1])[:, None] * inner

    pressure = np.zeros((grid.theta.size, grid.across.size))
    pressure[:, :-1] = np.where(grid.fixed, feed_pressure, 0.0)
    free = ~grid.fixed[1:-1]
    inside = pressure[1:-1, :-1]
    held = pressure.copy()
    from_held = push_of(held, along, aside, np.zeros_like(source))
    if guess is not None and guess.shape == pressure.shape:
        active = free & (guess[1:-1, :-1] > 0.0)
    else:
        active = free & (source > 0.0)
    round_off = 1e-11 * float(np.abs(source).max())
    for _ in range(ITERATION_LIMIT):
        inside[:] = np.where(
            free,
            solved_where_active(active, diagonal, along[1:-1], aside[:, :-1], source + from_held),
            held[1:-1, :-1],
        )
        corrected = free & np.where(active, inside > 0.0, push_of(pressure, along, aside, source) > round_off)
        if np.array_equal(corrected, active):
            return pressure
        active = corrected
    raise ArithmeticError(Text("no film found on {size} nodes around", size=grid.theta.size))


def _integrals(grid: _Grid, pressure: Array) -> _Force:
    per_angle = pressure @ grid.across * grid.around
    leaving = float((grid.sideways[:, -1] * pressure[:, -2]).sum())
    # the half cell at the edge, where Π = 0 but the film still narrows: what its drag loses over every stretch of film
    whole = pressure[:, -2] > 0.0
    begins, ends = np.flatnonzero(np.diff(whole.astype(int)) == 1), np.flatnonzero(np.diff(whole.astype(int)) == -1)
    wedge = float(grid.drag[begins].sum() - grid.drag[ends].sum()) * float(grid.across[-1])
    return _Force(
        along=float(per_angle @ np.cos(grid.alpha)),
        aside=float(per_angle @ np.sin(grid.alpha)),
        side_flow=math.pi / 6.0 * (leaving + wedge),
        peak=float(pressure.max()),
    )


# --- the film with its feed in daily use
# Solutions of `solve_grooved` at some eccentricities of one bearing, and cubics between them.
#
# A table of its own for each l/d and each set of feeds, made when it is first asked for (two seconds) and kept.  The
# feed's pressure is left out of the film's own.  Where the film's end meets a groove the coefficients bend sharply, and
# beside it the journal may wander by 25° over a few hundredths of ε: there the nodes are halved until they agree.

NODES = 13  # even in atanh ε, at first
HALVINGS = 7
AGREED = 2e-3  # of ln S, rad of φ, and of √(c_xx·c_yy) in the damping: what a new node may be off the cubic
SETTLED = (0, 1, -3, -2, -1)  # the columns that are asked
FINE = 4001  # places at which S is laid out for its inversion
SOURCE = Text("Reynolds 1886, bearing with axial grooves, Swift–Stieber film end; this program's own solution")


@record
class GroovedTable:
    """Over x = atanh ε: values at the nodes and their slopes, [node, quantity]; ln(So/So_short) first."""

    x: Array
    values: Array
    slopes: Array
    fine_x: Array
    fine_load: Array  # ln So at fine_x, nowhere falling

    def at(self, x: Array) -> Array:
        return _cubic(self.x, self.values, self.slopes, x)


def _cubic(x: Array, values: Array, slopes: Array, at: Array) -> Array:
    cell = np.clip(np.searchsorted(x, at, side="right") - 1, 0, x.size - 2)
    width = (x[cell + 1] - x[cell])[..., None]
    t = (at - x[cell])[..., None] / width
    rise = values[cell + 1] - values[cell]
    bend = (1 - t) * (slopes[cell] * width - rise) - t * (slopes[cell + 1] * width - rise)
    cubic: Array = values[cell] + t * rise + t * (1 - t) * bend
    return cubic


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
    values = np.array([_row(at, length_ratio, feeds) for at in x.tolist()])
    between = (x[1:] + x[:-1]) / 2
    for _ in range(HALVINGS):
        if not between.size:
            break
        guess = _cubic(x, values, _slopes(x, values), between)
        new = np.array([_row(at, length_ratio, feeds) for at in between.tolist()])
        scale = np.ones_like(new)
        scale[:, -3:] = np.sqrt(new[:, -3] * new[:, -1])[:, None]
        off = (np.abs(new - guess) / scale)[:, SETTLED].max(axis=1) > AGREED
        at = np.searchsorted(x, between)
        half = (x[at] - x[at - 1]) / 4
        x, values = np.insert(x, at, between), np.insert(values, at, new, axis=0)
        between = np.stack([between - half, between + half], axis=1)[off].ravel()
    fine = np.linspace(x[0], x[-1], FINE)
    table = GroovedTable(x, values, _slopes(x, values), fine, np.zeros(0))
    load = table.at(fine)[:, 0] + np.log(length_ratio**2 * short_bearing_load(np.tanh(fine)))
    # where it falls for a while, the journal stands at the smallest ε that carries it
    return replace(table, fine_load=np.maximum.accumulate(load))


def _slopes(x: Array, values: Array) -> Array:
    slopes: Array = np.gradient(values, x, axis=0, edge_order=2)
    return slopes


def _row(x: float, length_ratio: float, feeds: tuple[Feed, ...]) -> list[float]:
    low, high = ECCENTRICITY_RANGE
    eps = min(max(math.tanh(x), low), high)
    film = solve_grooved(eps, length_ratio, feeds)
    load = -math.log(2 * math.pi * film.sommerfeld * length_ratio**2 * short_bearing_load(eps))
    land = sheared(eps, film.attitude, feeds) / (2 * math.pi / math.sqrt(1 - eps**2))
    rates = (film.k_xx, film.k_xy, film.k_yx, film.k_yy, film.c_xx, (film.c_xy + film.c_yx) / 2, film.c_yy)
    return [load, film.attitude, film.side_flow, film.pressure_ratio, land, *(k * eps * (1 - eps) for k in rates)]


def eccentricity_from(sommerfeld: Value, length_ratio: float, feeds: Feeds, *, outside: str = "raise") -> Value:
    """ε at S; floats or arrays.  Outside ε 0.02 to 0.98: FilmRangeError, or with outside="nan" a nan."""
    table = grooved_table(float(length_ratio), feeds.feeds)
    S = np.asarray(sommerfeld, dtype=float)
    with np.errstate(all="ignore"):
        load = -np.log(2 * math.pi * S)
    inside = (load >= table.fine_load[0]) & (load <= table.fine_load[-1])
    if outside == "raise" and not inside.all():
        low, high = (math.exp(-table.fine_load[at]) / (2 * math.pi) for at in (-1, 0))
        raise FilmRangeError(Text("Sommerfeld number S"), float(S[~inside][0]) if S.ndim else float(S), low, high)
    eps: Any = np.where(inside, np.tanh(np.interp(np.nan_to_num(load), table.fine_load, table.fine_x)), np.nan)
    return eps if S.ndim else float(eps)  # type: ignore[return-value]


def film_at(eccentricity: Value, length_ratio: float, feeds: Feeds) -> GroovedPoint[Value]:
    """The film at ε; nan gives nan."""
    table = grooved_table(float(length_ratio), feeds.feeds)
    eps: Array = np.asarray(eccentricity, dtype=float)
    values: Array = np.moveaxis(table.at(np.arctanh(eps)), -1, 0)
    S = np.exp(-values[0]) / (2 * math.pi * length_ratio**2 * short_bearing_load(eps))
    film: Any = (eps, S, *values[1:5], *(values[5:] / (eps * (1 - eps))))
    if not eps.ndim:
        film = map(float, film)
    return GroovedPoint(*film)


# --- as lines of the calculation


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
