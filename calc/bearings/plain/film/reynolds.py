# SPDX-License-Identifier: Apache-2.0
"""Reynolds' equation solved for a plain bearing of full circumference and finite length, level or sloping.

The exact way, some milliseconds per state; `table` keeps the results of this module for daily use.

Film h = c·(1 + ε·cos θ), θ from the widest film along the rotation; z = 2·y/l from the middle plane to the edge;
pressure p = μ·ω·(r/c)²·Π.  Then

    ∂/∂θ(h³·∂Π/∂θ) + (d/l)²·∂/∂z(h³·∂Π/∂z) = 6·dh/dθ,        Π = 0 at θ = 0 and at z = 1,

and the film ruptures where Swift and Stieber place it: Π >= 0 everywhere, and Π and its gradient vanish together.  In
discrete form this is a linear complementarity problem.  A primal-dual active set solves it: guess which nodes carry
pressure, solve for them, correct the guess, until nothing changes (two to five times).

Around the bearing the flow between two nodes is exact for constant flow (∫h⁻²dθ and ∫h⁻³dθ by Sommerfeld's
substitution), so the infinitely long bearing is exact at its nodes.  Each of three grids halves the steps of the one
before and starts from its pressure; the last two give Richardson's limit.  Against far finer grids: 1e-4 in S, f* and φ
at worst, 2e-5 root mean square; 3e-5 in the flows.

Sources: O. Reynolds, Phil. Trans. R. Soc. 177 (1886) 157; H. W. Swift, Proc. ICE 233 (1932) 267; W. Stieber, Das
Schwimmlager, VDI (1933); A. A. Raimondi and J. Boyd, ASLE Transactions 1 (1958) 159-209 (the dimensionless groups)."""

import math

import numpy as np

from ....sheet.arrays import Array, Value
from ....sheet.arrays import BoolArray as Mask
from ....sheet.record import record
from ....sheet.text import Amount, Text

ECCENTRICITY_RANGE = (0.02, 0.98)
LENGTH_RATIO_RANGE = (0.1, 2.0)  # and infinity

ITERATION_LIMIT = 100
# end of the grid: the infinitely long bearing ruptures at 1.43·π at the latest, a shorter one earlier
LAST_TURN = 1.5 * math.pi
UNIFORM_SHARE = 0.25  # of the nodes around: keeps the widest film resolved at high eccentricity
EDGE_CLUSTERING = 1.5  # nodes across crowd towards the edge as tanh does
REFINEMENTS = (4, 2, 1)
LONG_BEARING_REFINEMENT = 4  # one dimension costs nothing, so the infinitely long bearing gets more nodes


@record
class FilmSolution:
    """One state of the oil film, dimensionless.

    When to use: the truth for one pair (ε, l/d).  In loops use `table.film_at`.

    Assumptions: constant viscosity, steady load, parallel axes, 360° shell fed at the widest film without pressure.
    """

    eccentricity: float  # ε = e/c
    length_ratio: float  # l/d, or infinity
    sommerfeld: float  # S = (r/c)²·μ·N/P, N in revolutions per second
    attitude: float  # φ, from the load line to the narrowest film, rad
    friction: float  # f* = (r/c)·f, sheared oil over the whole circumference
    flow: float  # Q/(r·c·N·l), through the widest film
    side_flow_ratio: float  # Qs/Q, the share that leaves over the two edges
    pressure_ratio: float  # P/p_max
    theta: Array  # nodes from the widest film, 0 to 2π
    pressure: Array  # Π there, middle plane, finest grid (about 2e-3 from the limit)
    z: Array  # nodes from the middle plane, 0, to the edge, 1
    pressure_along: Array  # Π there, where it is largest around


@record
class _Grid:
    """The nodes, and all coefficients that follow from the film's shape alone."""

    theta: Array  # nodes around
    around: Array  # their weights in ∫dθ
    across: Array  # weights of the nodes across in ∫dz, the edge included
    film: Array  # h at the nodes around
    conductance: Array  # 1/∫h⁻³dθ between neighbours around
    drag: Array  # 6·∫h⁻²dθ/∫h⁻³dθ, the flow between neighbours without pressure
    sideways: Array  # (d/l)²·h³·weight over Δz, [node around, gap across]
    z: Array  # nodes across, from the middle plane to the edge


def friction_variable(eccentricity: Value, sommerfeld: Value, sine_of_attitude: Value) -> Value:
    """f* = (r/c)·f = π/(So·√(1 − ε²)) + (ε/2)·sin φ, with So = 1/(2π·S).

    Exact: moment of the shear over the full circumference (Couette part) plus that of the pressure gradient, by
    equilibrium of the film.  Counting sheared oil only where the film is whole would give 14 to 19 % less at usual
    working points."""
    friction: Value = (
        2.0 * math.pi**2 * sommerfeld / (1.0 - eccentricity**2) ** 0.5 + 0.5 * eccentricity * sine_of_attitude
    )
    return friction


def solve_film(eccentricity: float, length_ratio: float, *, cells: tuple[int, int] = (192, 16)) -> FilmSolution:
    """Solve the film of one bearing.

    Range: 0.02 <= ε <= 0.98; 0.1 <= l/d <= 2, or l/d infinite.  `cells` are those of the finest grid around and across
    (half the length), both multiples of 4.  Raises ValueError outside the range."""
    levels = _levels(eccentricity, length_ratio, cells)
    grid, pressure = levels[-1]
    cosine, sine, flow, side_flow, peak = _limit(*(_integrals(*level) for level in levels[-2:])).tolist()
    integral = math.hypot(cosine, sine)
    sommerfeld = 1.0 / (math.pi * integral)
    return FilmSolution(
        eccentricity=eccentricity,
        length_ratio=length_ratio,
        sommerfeld=sommerfeld,
        attitude=math.atan2(sine, -cosine),
        friction=friction_variable(eccentricity, sommerfeld, sine / integral),
        flow=flow,
        side_flow_ratio=side_flow / flow,
        pressure_ratio=0.5 * integral / peak,
        theta=np.append(grid.theta, 2.0 * math.pi),
        pressure=np.append(pressure[:, 0], 0.0),
        z=grid.z,
        pressure_along=pressure[int(pressure[:, 0].argmax())],
    )


def radial_damping(eccentricity: float, length_ratio: float, *, cells: tuple[int, int] = (192, 16)) -> float:
    """C_rr·ψ³/(2·μ·l): what the film holds against a journal that moves along its eccentricity, over its speed; not
    over the load.

    The squeeze term 12·∂h/∂t beside the wedge, the film's region held as in the static state: the same matrix, solved
    once more. Over So it is C_rr·c·ω/F.  Accuracy 1e-3 on the usual grid and 5e-4 on 384 by 32 cells; at l/d 0.1, where
    few nodes stand in the steep end of the film, 1e-2 and 7e-4."""
    levels = _levels(eccentricity, length_ratio, cells)
    return float(_limit(*(np.asarray(_squeezed(eccentricity, *level)) for level in levels[-2:])))


def _limit(coarse: Array, fine: Array) -> Array:
    """Richardson's limit of two grids, the finer one of half the steps."""
    limit: Array = fine + (fine - coarse) / 3.0
    return limit


def _levels(eccentricity: float, length_ratio: float, cells: tuple[int, int]) -> list[tuple[_Grid, Array]]:
    """The grids from coarse to fine, and Π on each."""
    _require(eccentricity, length_ratio, cells)
    if math.isinf(length_ratio):
        cells = (LONG_BEARING_REFINEMENT * cells[0], 1)
    pressure: Array | None = None
    levels = []
    for coarser in REFINEMENTS:
        grid = film_grid(eccentricity, length_ratio, cells[0] // coarser, max(cells[1] // coarser, 1))
        source = -np.diff(grid.drag)[:, None] * grid.across[:-1]
        active = None if pressure is None else _refined(pressure, grid.across.size)[1:-1, :-1] > 0.0
        aside = grid.sideways[1:-1]
        along, diagonal = links(grid.conductance, grid.across[:-1], aside)
        pressure = pressure_of(grid.theta, along, aside, diagonal, source, active)
        levels.append((grid, pressure))
    return levels


def _require(eccentricity: float, length_ratio: float, cells: tuple[int, int]) -> None:
    low, high = ECCENTRICITY_RANGE
    if not low <= eccentricity <= high:
        raise ValueError(f"eccentricity ratio {eccentricity:g}: Reynolds' equation is solved from {low:g} to {high:g}")
    low, high = LENGTH_RATIO_RANGE
    if not (low <= length_ratio <= high or length_ratio == math.inf):
        raise ValueError(
            f"length ratio l/d {length_ratio:g}: Reynolds' equation is solved from {low:g} to {high:g}, or infinite"
        )
    if cells[0] < 24 or cells[1] < 4 or cells[0] % 4 or cells[1] % 4:
        raise ValueError(f"cells {cells}: two multiples of 4, from (24, 4) up")


def film_grid(eccentricity: float, length_ratio: float, cells_around: int, cells_across: int) -> _Grid:
    """Nodes around: Sommerfeld's angle γ, 1 + ε·cos θ = (1 − ε²)/(1 − ε·cos γ), itself spread a little over the widest
    film."""
    narrow = 1.0 - eccentricity**2
    squeeze = math.sqrt((1.0 + eccentricity) / (1.0 - eccentricity))
    spread = 1.0 - 1.0 / (1.0 - UNIFORM_SHARE + UNIFORM_SHARE * squeeze)
    turn = np.linspace(0.0, LAST_TURN, cells_around + 1)
    gamma = turn - spread * np.sin(turn)
    theta = 2.0 * np.arctan2(squeeze * np.sin(0.5 * gamma), np.cos(0.5 * gamma))
    film = narrow / (1.0 - eccentricity * np.cos(gamma))

    around = turn[1] * (1.0 - spread * np.cos(turn)) * film / math.sqrt(narrow)
    around[0] *= 0.5
    around[-1] *= 0.5
    square, cube = film_integrals(gamma, eccentricity)
    conductance = 1.0 / np.diff(cube)
    drag = 6.0 * np.diff(square) * conductance

    if math.isinf(length_ratio):
        gap, across, sideways = np.ones(1), np.array([1.0, 0.0]), np.zeros((theta.size, 1))
    else:
        gap = np.diff(np.tanh(np.linspace(0.0, EDGE_CLUSTERING, cells_across + 1))) / math.tanh(EDGE_CLUSTERING)
        across = 0.5 * (np.append(gap, 0.0) + np.append(0.0, gap))
        sideways = (film**3 * around / length_ratio**2)[:, None] / gap
    return _Grid(theta, around, across, film, conductance, drag, sideways, np.append(0.0, np.cumsum(gap)))


def film_integrals(gamma: Array, eccentricity: float | Array) -> tuple[Array, Array]:
    """∫h⁻²dθ and ∫h⁻³dθ from the widest film to Sommerfeld's angle γ."""
    narrow, sine, cosine = 1.0 - eccentricity**2, np.sin(gamma), np.cos(gamma)
    square = (gamma - eccentricity * sine) / narrow**1.5
    cube = (
        (1.0 + 0.5 * eccentricity**2) * gamma - (2.0 - 0.5 * eccentricity * cosine) * eccentricity * sine
    ) / narrow**2.5
    return square, cube


def _refined(pressure: Array, nodes_across: int) -> Array:
    """The pressure of one grid at the nodes of the next, by halving the steps."""
    finer = np.empty((2 * pressure.shape[0] - 1, pressure.shape[1]))
    finer[::2] = pressure
    finer[1::2] = 0.5 * (pressure[1:] + pressure[:-1])
    if nodes_across == pressure.shape[1]:
        return finer
    finest = np.empty((finer.shape[0], nodes_across))
    finest[:, ::2] = finer
    finest[:, 1::2] = 0.5 * (finer[:, 1:] + finer[:, :-1])
    return finest


def links(conductance: Array, inner: Array, aside: Array) -> tuple[Array, Array]:
    """The matrix A: links around, and the diagonal, at the nodes where Π is not given.

    `conductance` of each gap around, `inner`: weights of the nodes across without the edge, `aside`: links across
    towards the edge, [node around, gap]."""
    along = conductance[:, None] * inner
    diagonal = along[1:] + along[:-1] + aside
    diagonal[:, 1:] += aside[:, :-1]
    return along, diagonal


def push_of(pressure: Array, along: Array, aside: Array, source: Array) -> Array:
    """b − A·Π without the diagonal's part: what lifts Π at each node where it is not given."""
    push: Array = source + along[1:] * pressure[2:, :-1] + along[:-1] * pressure[:-2, :-1] + aside * pressure[1:-1, 1:]
    push[:, 1:] += aside[:, :-1] * pressure[1:-1, :-2]
    return push


def pressure_of(
    theta: Array, along: Array, aside: Array, diagonal: Array, source: Array, active: Mask | None = None
) -> Array:
    """Π at the nodes around and across, zero at both ends around and at the last node across: the complementarity
    problem A·Π >= b, Π >= 0, Π·(A·Π − b) = 0 of one grid, b the `source`.

    `along`: links around, [gap, node across]; `aside`: from each node across to the next; `active`: where pressure is
    looked for first."""
    if active is None:
        active = np.broadcast_to(theta[1:-1, None] < 1.1 * math.pi, source.shape)
    round_off = 1e-11 * float(np.abs(source).max())
    pressure = np.zeros((theta.size, source.shape[1] + 1))
    inside = pressure[1:-1, :-1]
    for _ in range(ITERATION_LIMIT):
        whole = int(np.flatnonzero(active.any(axis=1))[-1]) + 1  # nodes around that the film can reach
        inside[:whole] = solved_where_active(
            active[:whole], diagonal[:whole], along[1:whole], aside[:whole, :-1], source[:whole]
        )
        inside[whole:] = 0.0
        corrected = np.where(active, inside > 0.0, push_of(pressure, along, aside, source) > round_off)
        if np.array_equal(corrected, active):
            if active[-1].any():
                end, size = Amount(theta[-2], form=".3f"), theta.size
                raise ArithmeticError(
                    Text(
                        "the film has not ruptured at {theta} rad, where the grid of {size} ends", theta=end, size=size
                    )
                )
            return pressure
        active = corrected
    raise ArithmeticError(
        Text(
            "no film found on {size} by {size2} nodes in {iteration_limit} corrections",
            size=theta.size,
            size2=pressure.shape[1],
            iteration_limit=ITERATION_LIMIT,
        )
    )


def _squeezed(eccentricity: float, grid: _Grid, pressure: Array) -> float:
    """−½·∬Π₁·cos θ (half length) with Π₁ for ∂h/∂t = cos θ, the film where it is without.

    The film ends somewhere within half a step of the first empty node.  Where, follows from the flow that the static
    pressure drives near its end, Π'·h³ = 6·dh/dθ·(s − θ); what a shift of the end changes, from the flow of Π₁ there
    (Hadamard)."""
    active = pressure[1:-1, :-1] > 0.0
    inner = grid.across[:-1]
    aside = grid.sideways[1:-1]
    along, diagonal = links(grid.conductance, inner, aside)
    source = -12.0 * (np.cos(grid.theta) * grid.around)[1:-1, None] * inner
    last = active.shape[0] - 1 - active[::-1].argmax(axis=0)
    whole = int(last.max()) + 1
    squeeze = solved_where_active(active[:whole], diagonal[:whole], along[1:whole], aside[:whole, :-1], source[:whole])

    rows, node = np.arange(inner.size), last + 1
    before = 0.5 * (grid.theta[node] + grid.theta[node - 1])
    flow = (pressure[node - 1, rows] - pressure[node, rows]) * grid.conductance[node - 1]
    end = before - flow / (6.0 * eccentricity * np.sin(before))
    half = 0.5 * (grid.theta[node + 1] - grid.theta[node])
    shift = np.clip(end - grid.theta[node + 1], -half, half)
    at_end = squeeze[last, rows] * grid.conductance[node]
    return float((squeeze * source[:whole]).sum() + (at_end**2 / grid.film[node + 1] ** 3 * shift) @ inner) / 24.0


def solved_where_active(active: Mask, diagonal: Array, along: Array, aside: Array, source: Array) -> Array:
    """Solve for the active nodes; the others are zero.  Symmetric and banded: Cholesky, nodes across numbered first.

    `source`: [around, across], or [source, around, across] of several on one matrix."""
    from scipy.linalg.lapack import dpbsv  # type: ignore[import-untyped]

    rows, columns = active.shape
    band = np.zeros((rows, columns, columns + 1))
    if columns > 1:
        band[:, :-1, 1] = np.where(active[:, :-1] & active[:, 1:], -aside, 0.0)
    band[:-1, :, columns] = np.where(active[:-1] & active[1:], -along, 0.0)
    band[:, :, 0] = np.where(active, diagonal, 1.0)
    right = np.where(active, source, 0.0).reshape(-1, rows * columns).T
    _, solution, failure = dpbsv(band.reshape(-1, columns + 1).T, right, lower=1, overwrite_ab=1, overwrite_b=1)
    if failure:
        raise ArithmeticError(
            Text(
                "banded Cholesky of {rows} by {columns} nodes failed at row {failure}",
                rows=rows,
                columns=columns,
                failure=failure,
            )
        )
    return np.asarray(solution.T, dtype=np.float64).reshape(source.shape)


def _integrals(grid: _Grid, pressure: Array) -> Array:
    """∬Π·cos θ, ∬Π·sin θ (half length), inlet flow, side flow (both Q/(r·c·N·l)) and the largest Π of the middle
    plane."""
    per_angle = pressure @ grid.across * grid.around
    cosine = per_angle @ np.cos(grid.theta)
    sine = per_angle @ np.sin(grid.theta)

    # Inlet: the flow between the first two nodes, and what has left sideways before it (growing from zero with θ).
    leaving = grid.sideways[:, -1] * pressure[:, -2]
    inner, edge = grid.across[:-1], grid.across[-1]
    inlet = (grid.drag[0] - grid.conductance[0] * pressure[1, :-1]) @ inner + 6.0 * grid.film[0] * edge
    inlet += leaving[1] / grid.around[1] * grid.theta[1] / 8.0
    # Side: over the last full cell, and the wedge of the half cell at the edge, where Π = 0 but the film still narrows.
    last = int(np.flatnonzero(pressure[:, -2])[-1])
    side = leaving.sum() + (6.0 * grid.film[0] - grid.drag[last]) * edge

    middle = pressure[:, 0]
    top = int(middle.argmax())
    slope = 0.5 * (middle[top + 1] - middle[top - 1])
    bend = middle[top + 1] - 2.0 * middle[top] + middle[top - 1]
    peak = middle[top] - 0.5 * slope**2 / bend  # parabola through the three highest nodes
    return np.array([cosine, sine, math.pi / 6.0 * inlet, math.pi / 6.0 * side, peak])


# --- a journal that slopes in its seat
# The pressure grows towards the edge where the film is thinner.
#
# The film h = c·(1 + (ε + τ·z)·cos θ), z from −1 at one edge to 1 at the other: the journal slopes in the plane of
# its narrowest film, which thins it most.  Every slice across is a plain bearing of eccentricity ε + τ·z, so that the
# flow around between two nodes is exact as above, whose equation, film end and nodes these are, over the whole length
# on one grid.  A moment holds the slope: the shaft's.


@record
class MisalignedFilm:
    """One state, dimensionless as in `reynolds.FilmSolution`."""

    sommerfeld: float
    z: Array  # nodes from edge to edge, −1 to 1
    pressure_along: Array  # Π there, at the angle where it is largest


def solve_misaligned(
    eccentricity: float, tilt: float, length_ratio: float, cells: tuple[int, int] = (96, 16)
) -> MisalignedFilm:
    """`eccentricity` in the middle, `tilt` τ: what the slope takes of the film at the edge, over the radial clearance.

    `cells` around, and across half of the length.  Raises ValueError where an edge leaves the range: there the film is
    narrowest opposite."""
    low, high = ECCENTRICITY_RANGE
    if not low * (1 - 1e-9) <= eccentricity - abs(tilt) <= eccentricity + abs(tilt) <= high * (1 + 1e-9):
        raise ValueError(
            f"eccentricity ratio {eccentricity:g} ± {abs(tilt):g}: a journal that slopes is solved from {low:g} to "
            f"{high:g}"
        )
    grid = film_grid(eccentricity, length_ratio, *cells)
    theta, z = grid.theta, np.append(-grid.z[::-1], grid.z[1:])
    gap = np.diff(z)
    across = 0.5 * (np.append(gap, 0.0) + np.append(0.0, gap))
    eps = eccentricity + tilt * z
    gamma = 2.0 * np.arctan2(
        np.sqrt(1.0 - eps) * np.sin(theta[:, None] / 2), np.sqrt(1.0 + eps) * np.cos(theta[:, None] / 2)
    )
    square, cube = film_integrals(gamma, eps)
    conductance = 1.0 / np.diff(cube, axis=0)
    drag = 6.0 * np.diff(square, axis=0) * conductance
    film = 1.0 + (eps[1:] + eps[:-1]) / 2 * np.cos(theta[:, None])
    sideways = (film**3 * (grid.around / length_ratio**2)[:, None] / gap)[1:-1]

    along, source = conductance[:, 1:-1] * across[1:-1], -np.diff(drag, axis=0)[:, 1:-1] * across[1:-1]
    diagonal = along[1:] + along[:-1] + sideways[:, 1:] + sideways[:, :-1]
    pressure = np.pad(pressure_of(theta, along, sideways[:, 1:], diagonal, source), ((0, 0), (1, 0)))
    per_angle = pressure @ across * grid.around
    load = math.hypot(float(per_angle @ np.cos(theta)), float(per_angle @ np.sin(theta))) / 2
    return MisalignedFilm(1.0 / (math.pi * load), z, pressure[int(pressure.max(axis=1).argmax())])
