# SPDX-License-Identifier: Apache-2.0
"""Writes `tables/split_line.npy` from marches over the turn:  python -m calc.bearings.plain.film.build_split_line
(about ten minutes on two cores).

Needed only after a change of `reynolds`, of the march or of the nodes below.  The same code writes the same bytes.

The load turns with the journal past the seat.  In its frame, α from the load, time in 1/ω, film over c, pressure over
μ·ω/ψ², the journal stands at (x, y) and the seat runs backward:

    ∂/∂α(h³·∂p/∂α) + (d/l)²·∂/∂z(h³·∂p/∂z) = −6·∂h/∂α + 12·∂h/∂t,    h = 1 − x·cos α − y·sin α + r(α + t),

p >= 0 (Swift–Stieber), p = 0 at the edge z = 1 and, as in `reynolds`, where the smooth film is widest.  The relief r
is cut into the seat, so that ∂r/∂t = ∂r/∂α.  The film holds the load at every instant, ½·∬p·(cos α, sin α)dα·dz =
(So, 0) over half the length, which gives the velocity (ẋ, ẏ); the journal's mass is left out.

The nodes lie in the seat, σ = α + t, with one on every edge of the relief and its deepest line.  All terms but the
squeeze of the journal's motion are brought under one flux, F = h³·∂p/∂σ + 6·h_s − 6·r with the smooth part h_s of the
film, whose integrals between two nodes are Simpson's.  Pressure, film end and velocity are found together: for the
nodes that carry pressure, p = p₀ + ẋ·p₁ + ẏ·p₂ on one matrix, the two velocities from the load, and the guess of the
nodes is corrected until nothing changes.  (This is the least of a convex function, so that there is one answer.)"""

import math
import sys
from io import BytesIO
from itertools import product
from multiprocessing import Pool
from pathlib import Path

import numpy as np

from ....sheet.arrays import Array
from ....sheet.arrays import BoolArray as Mask
from ....sheet.record import record
from ....sheet.text import Text
from .grooved import nodes_across
from .reynolds import ECCENTRICITY_RANGE, ITERATION_LIMIT, LENGTH_RATIO_RANGE, links, push_of, solved_where_active
from .split_line import DEPTH_RANGE, HALF_ARC_RANGE, TABLE, variables
from .table import film_at

NODES = (6, 7, 11, 6)  # of ε, l/d, δ and a, where the turn is marched
CLOSER = 2  # nodes of the table, by this factor
CELLS = (144, 8)  # around the seat, and across half the length
STEP = math.radians(2.5)  # of the march
SETTLED, END = math.pi, 3.0 * math.pi  # the first passage is up to 3 % too good
CELLS_IN_RELIEF = 4  # on either side of a split line, at least
ROUND_OFF = 1e-11  # of the largest source: a push that is none
LEAST_LOSS = 1e-5  # a shallow relief may help as much as it harms


@record
class RelievedSeat:
    """The nodes of a seat with its relief, and what does not change while the load turns."""

    nodes: Array  # σ, from one split line minus its half arc, once round
    middles: Array  # of the gaps, each behind its node
    gap: Array
    around: Array  # weights of the nodes in ∫dσ
    relief: Array  # r at the nodes
    relief_between: Array  # at the middles
    inner: Array  # weights of the nodes across in ∫dz, without the edge
    aside: Array  # (d/l)²/Δz of each gap across


@record
class FilmMotion:
    """How the journal moves, and where the film carries pressure: where the next film is looked for."""

    velocity: Array  # (ẋ, ẏ)
    active: Mask  # [node around, node across]


def seat_with_relief(
    length_ratio: float, depth: float, half_arc: float, cells: tuple[int, int] = CELLS
) -> RelievedSeat:
    """A seat whose split lines lie at σ = ±π/2.  `depth` over c; `half_arc` above 0."""
    within = max(CELLS_IN_RELIEF, round(cells[0] * half_arc / (2.0 * math.pi)))
    beyond = max(2 * CELLS_IN_RELIEF, cells[0] // 2 - 2 * within)
    pieces = [
        np.linspace(start, end, count, endpoint=False)
        for start, end, count in (
            (-half_arc, 0.0, within),
            (0.0, half_arc, within),
            (half_arc, math.pi - half_arc, beyond),
        )
    ]
    from_line = np.concatenate(pieces)  # once round, both halves alike
    gap = np.diff(np.append(from_line, math.pi - half_arc))
    middles = from_line + 0.5 * gap
    gap_both = np.tile(gap, 2)
    z = nodes_across(1.0, cells[1])
    across = np.diff(z)
    return RelievedSeat(
        nodes=np.concatenate([from_line - 0.5 * math.pi, from_line + 0.5 * math.pi]),
        middles=np.concatenate([middles - 0.5 * math.pi, middles + 0.5 * math.pi]),
        gap=gap_both,
        around=0.5 * (gap_both + np.roll(gap_both, 1)),
        relief=np.tile(depth * np.maximum(0.0, 1.0 - np.abs(from_line) / half_arc), 2),
        relief_between=np.tile(depth * np.maximum(0.0, 1.0 - np.abs(middles) / half_arc), 2),
        inner=0.5 * (across + np.append(0.0, across[:-1])),
        aside=1.0 / (length_ratio**2 * across),
    )


def film_motion(
    seat: RelievedSeat, x: float, y: float, turned: float, load: float, before: FilmMotion, *, runs: bool = True
) -> FilmMotion | None:
    """The velocity of the journal at (x, y) over c with which the film holds the load So, along α = 0.

    `turned`: how far the load has turned past the seat, rad.  `runs`: the seat runs backward; False: load and seat
    stand, and the film is dragged as before past a relief that stands.  None where the journal touches an edge of the
    relief."""
    nodes = seat.nodes.size
    widest = int(np.argmin(x * np.cos(seat.nodes - turned) + y * np.sin(seat.nodes - turned)))
    ring = (widest + np.arange(nodes + 1)) % nodes  # once round, the widest film at both ends
    gaps = ring[:-1]
    alpha, between = seat.nodes[ring] - turned, seat.middles[gaps] - turned
    cosine, sine = np.cos(alpha), np.sin(alpha)
    smooth, smooth_between = 1.0 - x * cosine - y * sine, 1.0 - x * np.cos(between) - y * np.sin(between)
    film, film_between = smooth + seat.relief[ring], smooth_between + seat.relief_between[gaps]
    if film.min() <= 0.0:
        return None
    dragged = -1.0 if runs else 1.0
    cube, cube_between = film**-3, film_between**-3
    wedge = (smooth + dragged * seat.relief[ring]) * cube
    wedge_between = (smooth_between + dragged * seat.relief_between[gaps]) * cube_between
    simpson = seat.gap[gaps] / 6.0
    conductance = 1.0 / (simpson * (cube[:-1] + 4.0 * cube_between + cube[1:]))
    drag = 6.0 * conductance * simpson * (wedge[:-1] + 4.0 * wedge_between + wedge[1:])

    around = seat.around[ring]
    squeeze = 12.0 * (np.stack([cosine, sine]) * around)[:, 1:-1]  # of ẋ and ẏ
    aside = (film**3 * around)[1:-1, None] * seat.aside
    along, diagonal = links(conductance, seat.inner, aside)
    sources = np.concatenate([[np.diff(drag)], squeeze])[..., None] * seat.inner
    velocity, active = _held(along, aside, diagonal, sources, load, before.active[ring[1:-1]])
    everywhere = np.zeros_like(before.active)
    everywhere[ring[1:-1]] = active
    return FilmMotion(velocity, everywhere)


def _held(along: Array, aside: Array, diagonal: Array, sources: Array, load: float, active: Mask) -> tuple[Array, Mask]:
    """The velocity that the load asks for, and where there is pressure: the complementarity problem of `reynolds` with
    two more unknowns."""
    round_off = ROUND_OFF * float(np.abs(sources[0]).max())
    pressure = np.zeros((len(diagonal) + 2, diagonal.shape[1] + 1))
    inside = pressure[1:-1, :-1]
    for _ in range(ITERATION_LIMIT):
        carrying = np.flatnonzero(active.any(axis=1))
        first, end = int(carrying[0]), int(carrying[-1]) + 1
        film = slice(first, end)
        parts = solved_where_active(
            active[film], diagonal[film], along[first + 1 : end], aside[film, :-1], sources[:, film]
        )
        # ½·∬p·(cos α, sin α)dα·dz of each part, whose weights are those of the velocities' sources
        forces = np.einsum("ijk,ljk->li", parts, sources[1:, film]) / 24.0
        velocity = np.linalg.solve(forces[:, 1:], np.array([load, 0.0]) - forces[:, 0])
        inside[:] = 0.0
        inside[film] = parts[0] + velocity[0] * parts[1] + velocity[1] * parts[2]
        push = push_of(pressure, along, aside, sources[0] + velocity[0] * sources[1] + velocity[1] * sources[2])
        corrected = np.where(active, inside > 0.0, push > round_off)
        if np.array_equal(corrected, active):
            return velocity, active
        active = corrected
    raise ArithmeticError(Text("no film found on {size} nodes around", size=len(pressure)))


def smooth_place(eccentricity: float, length_ratio: float) -> tuple[float, float, float]:
    """x, y and So of the film without relief.  The film is dragged towards −α."""
    film = film_at(eccentricity, length_ratio)
    x, y = eccentricity * math.cos(film.attitude), -eccentricity * math.sin(film.attitude)
    return x, y, 1.0 / (2.0 * math.pi * film.sommerfeld)


def at_rest(seat: RelievedSeat, x: float, y: float, turned: float) -> FilmMotion:
    """A film to begin with: it carries pressure where it narrows."""
    narrows = x * np.sin(seat.nodes - turned) - y * np.cos(seat.nodes - turned) > 0.0
    return FilmMotion(np.zeros(2), np.repeat(narrows[:, None], seat.inner.size, axis=1))


def least_film_over_turn(
    eccentricity: float,
    length_ratio: float,
    depth: float,
    half_arc: float,
    *,
    cells: tuple[int, int] = CELLS,
    step: float = STEP,
    end: float = END,
) -> float:
    """The least 1 − e/c while the load passes both split lines, from the smooth place with both 90° off the load.

    Negative where the journal dips into the relief; where it then touches its edges, what was reached so far."""
    x, y, load = smooth_place(eccentricity, length_ratio)
    seat = seat_with_relief(length_ratio, depth, half_arc, cells)
    motion = at_rest(seat, x, y, 0.0)
    steps = math.ceil(end / step - 1e-9)
    step, least, last = end / steps, math.inf, np.zeros(2)
    for k in range(steps + 1):
        turned, film = k * step, 1.0 - math.hypot(x, y)
        if turned >= SETTLED - 1e-9 or film < 0.0:
            least = min(least, film)
        moved = film_motion(seat, x, y, turned, load, motion)
        if moved is None:
            return least
        motion = moved
        # Adams and Bashforth's second order
        move = step * (1.5 * motion.velocity - 0.5 * last if k else motion.velocity)
        x, y, last = x + float(move[0]), y + float(move[1]), motion.velocity
    return least


# --- the table


def axes() -> tuple[Array, ...]:
    """ε, l/d, δ and a at the nodes, which are even in their `variables`."""
    limits = np.array([ECCENTRICITY_RANGE, LENGTH_RATIO_RANGE, DEPTH_RANGE, HALF_ARC_RANGE])
    even = [np.linspace(low, high, nodes) for (low, high), nodes in zip(variables(limits).tolist(), NODES)]
    places = [np.tanh(even[0]), *map(np.exp, even[1:])]
    for nodes, ends in zip(places, limits):
        nodes[[0, -1]] = ends
    return tuple(places)


def losses(eccentricity: float, length_ratio: float, half_arc: float) -> list[float]:
    """1 − share at all depths of the table.  Over the film of a smooth seat with the same nodes, which takes out most
    of their error."""
    smooth = least_film_over_turn(eccentricity, length_ratio, 0.0, half_arc, end=2.0 * math.pi)
    depths = axes()[2] * (1.0 - eccentricity)
    return [
        1.0 - least_film_over_turn(eccentricity, length_ratio, depth, half_arc) / smooth for depth in depths.tolist()
    ]


def marched() -> Array:
    """The losses at all nodes."""
    eccentricities, length_ratios, _, half_arcs = (nodes.tolist() for nodes in axes())
    with Pool() as pool:
        rows = pool.starmap(losses, product(eccentricities, length_ratios, half_arcs), chunksize=1)
    return np.array(rows).reshape([NODES[at] for at in (0, 1, 3, 2)]).swapaxes(2, 3)


def never_falling(loss: Array) -> Array:
    """A deeper or longer relief is never taken to be better."""
    rising: Array = np.maximum.accumulate(np.maximum.accumulate(loss, axis=2), axis=3)
    return rising


def table_of(loss: Array) -> Array:
    """The table as one structured value: first and last node of each variable, and ln(1 − share) at nodes `CLOSER` than
    those of the march, from monotone cubics between them."""
    from scipy.interpolate import PchipInterpolator  # type: ignore[import-untyped]

    values = np.log(never_falling(np.maximum(loss, LEAST_LOSS)))
    for axis, count in enumerate(NODES):
        marched_at = np.linspace(0.0, 1.0, count)
        closer = np.linspace(0.0, 1.0, CLOSER * (count - 1) + 1)
        if axis == 0:  # a small loss goes with a power of ε
            low, high = map(math.atanh, ECCENTRICITY_RANGE)
            marched_at, closer = (
                np.log(eps / (1.0 - eps)) for eps in (np.tanh(low + at * (high - low)) for at in (marched_at, closer))
            )
            closer = np.clip(closer, marched_at[0], marched_at[-1])
        values = PchipInterpolator(marched_at, values, axis=axis)(closer)
    values = never_falling(values)
    table = np.zeros((), dtype=[("ends", "<f8", (len(NODES), 2)), ("values", "<f4", values.shape)])
    table["ends"] = variables(np.array([nodes[[0, -1]] for nodes in axes()]))
    table["values"] = values
    return table


def main(path: Path = TABLE) -> None:
    buffer = BytesIO()
    np.save(buffer, table_of(marched()), allow_pickle=False)
    path.write_bytes(buffer.getvalue())


if __name__ == "__main__":
    main(*(Path(argument) for argument in sys.argv[1:]))
