# SPDX-License-Identifier: Apache-2.0
"""Which flanks part, and when and how fast they strike: all operating points and bodies at once.

`closed`: the forces of flanks that stay closed, exact.  `fly`: strikes without rebound of every body whose own mesh
parts of itself, with all that is behind it, in the backlash of its whole path.  How a flight goes stands in
`flight.py`."""

from collections.abc import Sequence
from dataclasses import fields
from functools import cached_property
from typing import Any

import numpy as np

from ...sheet.arrays import Array, BoolArray, IndexArray
from ...sheet.formula import formula
from ...sheet.functions import along, power
from ...sheet.record import record
from ...sheet.text import Text
from ...sheet.units import (
    Kilogram,
    Metre,
    MetrePerSecond,
    MetrePerSecond2,
    MetrePerSecond3,
    Newton,
    Number,
    Radian,
    Second,
    Watt,
)
from ...sheet.value import untraced
from .flight import Events, Wave, events
from .motion import Bodies, Motion, peak

RULE = Text("rule of this program, flanks that strike without rebound")
ONE_FLANK = Text("dynamics: a body that is driven by one flank alone")

# backlash at which a limit of the strike speed is reached: over half the swing of the first driver
LEAST_SHARE, MOST_SHARE = 1e-4, 20.0
SECTIONS, FEWER, NARROWER = 48, 32, 1

# --- formulas


@formula(
    "Γ",
    Text("{one_flank}: inertia over drag; flanks part above 1", one_flank=ONE_FLANK),
    names={"M": "M_c", "D": "D_c", "a": "a_down"},
)
def separation(M: Kilogram, a: MetrePerSecond2, D: Newton) -> Number:
    """`a`: the largest −x₀'' at the mesh.

    >>> separation(M=10.0, a=12.0, D=60.0)
    2.0"""
    return M * a / D


@formula(
    "F_least",
    Text("{one_flank}: force along the line of action", one_flank=ONE_FLANK),
    names={"M": "M_c", "D": "D_c", "a": "a_down"},
)
def least_force(M: Kilogram, a: MetrePerSecond2, D: Newton) -> Newton:
    """`a`: the largest −x₀'' at the mesh.

    >>> least_force(M=10.0, a=12.0, D=60.0)
    -60.0"""
    return D - M * a


@formula(
    "F_most",
    Text("{one_flank}: force along the line of action", one_flank=ONE_FLANK),
    names={"M": "M_c", "D": "D_c", "a": "a_up"},
)
def most_force(M: Kilogram, a: MetrePerSecond2, D: Newton) -> Newton:
    """`a`: the largest x₀'' at the mesh."""
    return D + M * a


@formula(
    "W_u",
    Text("{rule}: kinetic energy that the strikes of an orbit take", rule=RULE),
    names={"M": "M_c", "T": "T_o", "u": "u_s"},
    meanings={"M": "Mass on the line of action", "u": "Speed of a strike", "T": "Length of the orbit"},
)
def impact_power(M: Kilogram, u: MetrePerSecond, T: Second) -> Watt:
    """`u`: the speeds of all strikes of an orbit, T its length.

    >>> round(impact_power(M=10.0, u=np.array([0.05, 0.03]), T=0.04), 6)
    0.425"""
    return M * along(u**2) / (2 * T)


@formula(
    "u_s",
    Text("{rule}: where the backlash is small, p falls in a straight line through 0", rule=RULE),
    unit="mm/s",
    names={"jerk": "I"},
)
def speed_by_jerk(jerk: MetrePerSecond3, J: Metre) -> MetrePerSecond:
    """Speed of a strike across a small backlash, from the rate at which p falls where the flanks part.

    >>> round(speed_by_jerk(jerk=1500.0, J=70e-6), 6)
    0.0321"""
    return power(jerk, 1 / 3) * power(6 * J, 2 / 3) / 2


@formula(
    "u_s",
    "rule of this program, flanks that strike without rebound: speed across the backlash of the way, where they meet",
    shows="v(t) − v(t_0) + g·(t − t_0) where x(t) − x(t_0) − v(t_0)·(t − t_0) + g·(t − t_0)²/2 reaches a flank",
    unit="mm/s",
)
def strike_speed(u: MetrePerSecond) -> MetrePerSecond:
    """The largest of an orbit, as the flight has it."""
    return u


# --- closed flanks


@record
class Closed:
    """What every mesh carries on its driving flank while it is closed; P points, B bodies."""

    mass: Array  # (B,) M_c of a body with all that is behind it, at its mesh, in kg
    drag: Array  # (P, B) D_c likewise, in N
    slowing: Array  # (P, B) the largest −x₀'' at each mesh, in m/s²
    speeding: Array  # (P, B) the largest x₀''
    least: Array  # (P, B) in N
    most: Array  # (P, B) in N
    separation: Array  # (P, B) Γ; inf where D_c is 0
    parts: BoolArray  # (P, B): of itself

    def at(self, points: Any) -> "Closed":
        """At some of the points, as numpy chooses rows."""
        return Closed(self.mass, *(getattr(self, f.name)[points] for f in fields(self)[1:]))


def closed(motion: Motion, bodies: Bodies) -> Closed:
    """Exact: F = M_c·x₀'' + D_c, less what gravity turns the bodies by.  A chain, and a mesh that a split gear holds,
    never part."""
    M, D = bodies.lever**2 @ bodies.mass, bodies.drag @ bodies.lever.T
    period = _period(motion, bodies)
    a_0 = motion.on_nodes(period)
    down, up = (peak(sign * a_0)[:, None] * bodies.ratio for sign in (-1, 1))
    with untraced(), np.errstate(divide="ignore", invalid="ignore"):
        Gamma = np.where(D > 0, separation(M, down, D), np.inf)
        if bodies.gravity is None:
            least, most = least_force(M, down, D), most_force(M, up, D)
        else:
            of_gravity = M[:, None] * _gravity(motion, bodies, M, motion.nodes(period), 0)
            F = (M * bodies.ratio)[:, None] * a_0[:, None] + D[..., None] - of_gravity
            least, most = -peak(-F), peak(F)
    parts = (least < 0) & np.array(bodies.toothed)
    if bodies.sprung is not None:
        parts &= ~bodies.sprung
    return Closed(M, D, down, up, least, most, Gamma, parts)


def _period(motion: Motion, bodies: Bodies) -> Radian:
    """That of the motion, with gravity of that of both: a shaft at an order of the firing keeps it short, so
    that its orbit closes soon; else it is the whole working cycle."""
    if bodies.gravity is None or bodies.gravity_order is None:
        return motion.period
    orders, a = np.append(motion.orders, bodies.gravity_order), np.append(motion.a, bodies.gravity, 1)
    return Motion(orders[orders > 0], a[:, orders > 0], motion.omega, motion.cycle).period


def _gravity(motion: Motion, bodies: Bodies, M: Array, epsilon: Array, integrals: int) -> Array:
    """(P, B, K): what gravity turns a body and all behind it by, over M_c, in m/s²; or its integrals over time."""
    assert bodies.gravity is not None and bodies.gravity_order is not None
    there = bodies.gravity_order > 0
    behind = (bodies.lever / M[:, None])[:, there]
    omega = np.repeat(motion.omega, behind.shape[0])
    a = (bodies.gravity[:, None, there] * behind).reshape(omega.size, behind.shape[1])
    of = Motion(bodies.gravity_order[there], a, omega, motion.cycle).over(epsilon, integrals)
    return of.reshape(motion.omega.size, behind.shape[0], -1)


# --- strikes


@record
class Strikes:
    """Of every body that parts of itself, E events each; P points, B bodies.  Events that are none have speed 0."""

    backlash: Array  # (P, B) J of the path in m, at the body's own mesh; 0 where it does not fly
    share: Array  # (P, B) J over half the driver's swing there
    let_go: Array  # (P, B, E + 1) angle of the crank in rad, rising; NaN: none
    left: IndexArray  # (P, B, E + 1) the flank that it lets go of: 1 driving, −1 coast, 0 none
    struck: Array  # (P, B, E) angle of the crank at the strike in rad
    flank: IndexArray  # (P, B, E) the flank that is struck
    speed: Array  # (P, B, E) u ≥ 0 at the body's own mesh, in m/s; 0 outside its orbit
    press: Array  # (P, B, E) p at the strike in m/s²; 0 outside its orbit
    first: IndexArray  # (P, B): the event with which the orbit begins
    orbit: Array  # (P, B) T_o in s; 0: no strike
    power: Array  # (P, B) W
    closes: BoolArray  # (P, B): the motion repeats itself within the events; else all of them are its orbit

    def at(self, points: Any) -> "Strikes":
        """At some of the points, as numpy chooses rows."""
        return Strikes(*(getattr(self, f.name)[points] for f in fields(self)))

    @cached_property
    def hardest(self) -> Array:
        """(P, B) of its own strikes, m/s."""
        of: Array = self.speed.max(-1, initial=0.0)
        return of


def fly(motion: Motion, bodies: Bodies, of: Closed) -> Strikes:
    """The strikes of all bodies at all points.  Where a backlash is not above 0 nothing flies in it, NaN included."""
    P, B = of.parts.shape
    j = np.broadcast_to(bodies.backlash, (P, B))
    flies = of.parts & (j > 0)
    J = np.where(flies, np.where(flies, j, 0.0) @ bodies.lever, 0.0)
    point, body = np.nonzero(flies)
    flown, orbit, u, p = _flown(motion, bodies, of, point, body, J[point, body])
    step = _step(motion, bodies)
    with untraced(), np.errstate(divide="ignore", invalid="ignore"):
        W = np.where(orbit > 0, impact_power(of.mass[body], u, orbit), 0.0)

    def spread(lanes: Any, nothing: float = 0.0) -> Any:
        every = np.full((P, B, *lanes.shape[1:]), nothing, lanes.dtype)
        every[point, body] = lanes
        return every

    swing = _swing(motion)[:, None] * bodies.ratio
    return Strikes(
        backlash=J,
        share=np.divide(J, swing, out=np.zeros((P, B)), where=swing > 0),
        let_go=spread(flown.let_go * step, np.nan),
        left=spread(flown.left),
        struck=spread(flown.at * step, np.nan),
        flank=spread(flown.flank),
        speed=spread(u),
        press=spread(p),
        first=spread(flown.first),
        orbit=spread(orbit),
        power=spread(W),
        closes=spread(flown.closes),
    )


def _flown(
    motion: Motion, bodies: Bodies, of: Closed, point: IndexArray, body: IndexArray, J: Array
) -> tuple[Events, Array, Array, Array]:
    """Of L lanes, named by their point and body, in the backlash J (L,) of their paths: the events, T_o (L,) in s, and
    u and p (L, E) of the strikes, 0 outside the orbit.

    All fly in metres of the first driver, so that they share its motion; with gravity each has its own."""
    period = _period(motion, bodies)
    epsilon = motion.nodes(period)
    step = float(epsilon[1])
    ratio, second = bodies.ratio[body], step / motion.omega[point]
    jerk, a, v, x = (motion.on_nodes(period, n) for n in (-1, 0, 1, 2))
    seconds, row = step / motion.omega[:, None], point
    if bodies.gravity is not None:
        jerk, a, v, x = (
            f[point] - _gravity(motion, bodies, of.mass, epsilon, n)[point, body] / ratio[:, None]
            for n, f in ((-1, jerk), (0, a), (1, v), (2, x))
        )
        seconds, row = second[:, None], np.arange(point.size)
    g = of.drag[point, body] / (of.mass[body] * ratio)
    flown = events(Wave(jerk * seconds**3, a * seconds**2, v * seconds, x), row, g * second**2, J / ratio)
    event, lane = np.arange(flown.at.shape[1]), np.arange(point.size)
    counts = (event >= flown.first[:, None]) & (event < flown.last[:, None])
    steps = flown.let_go[lane, flown.last] - flown.let_go[lane, flown.first]
    u = np.where(counts, np.abs(flown.slope), 0.0) * (ratio / second)[:, None]
    p = np.where(counts, flown.press, 0.0) * (ratio / second**2)[:, None]
    return flown, steps * second, u, p


def _step(motion: Motion, bodies: Bodies) -> Radian:
    """Between two nodes."""
    return float(motion.nodes(_period(motion, bodies))[1])


def _swing(motion: Motion) -> Array:
    """(P,): half the way of the first driver from one end to the other."""
    x = motion.on_nodes(motion.period, 2)
    return (peak(x) + peak(-x)) / 2


# --- the backlash at which strikes reach a speed


def quiet_backlash(motion: Motion, bodies: Bodies, body: int, u_limit: MetrePerSecond, point: int = 0) -> Metre | None:
    """The first backlash of a body's whole path, from 0 on, at which its own strikes reach a speed; along the line of
    action, at its own mesh.  None: its mesh does not part of itself, or its strikes never are so fast."""
    return quiet_backlashes(motion, bodies, body, (u_limit,), point)[0]


def quiet_backlashes(
    motion: Motion, bodies: Bodies, body: int, u_limits: Sequence[MetrePerSecond], point: int = 0
) -> tuple[Metre | None, ...]:
    """The same for several speeds at once.

    The first of 48 sections at whose end a limit is reached, then of 32 of that one, and a straight line
    through the last; to 1e-5.  The speed does not rise with the backlash everywhere, so that a bisection from both ends
    could find a later one."""
    motion, bodies = motion.at([point]), bodies.at([point])
    of = closed(motion, bodies)
    limits, swing = np.array(u_limits), float(_swing(motion)[0] * bodies.ratio[body])
    if not of.parts[0, body] or not swing:
        return (None,) * limits.size

    def speeds(shares: Array) -> Array:
        """Of the hardest strike across shares of the swing."""
        return _hardest_across(motion, bodies, of, body, (shares * swing).ravel()).reshape(shares.shape)

    shares = np.geomspace(LEAST_SHARE, MOST_SHARE, SECTIONS)[None]  # alike for all limits, then of each its own
    u = speeds(shares)
    reached = np.any(u >= limits[:, None], axis=1)
    low, high, slow, fast = _first_reached(shares, u, limits)
    for _ in range(NARROWER):
        shares = np.linspace(low, high, FEWER, axis=1)
        low, high, slow, fast = _first_reached(shares, speeds(shares), limits)
    found = low + (high - low) * np.clip((limits - slow) / np.where(fast > slow, fast - slow, 1.0), 0.0, 1.0)
    return tuple(float(share * swing) if there else None for share, there in zip(found, reached, strict=True))


def speed_over_backlash(motion: Motion, bodies: Bodies, body: int, J: Array, point: int = 0) -> Array:
    """The hardest of a body's own strikes over the backlash of its whole path, along the line of action; 0 where there
    is none, or where its mesh does not part of itself."""
    motion, bodies = motion.at([point]), bodies.at([point])
    of, u = closed(motion, bodies), np.zeros(J.size)
    if of.parts[0, body]:
        u[J > 0] = _hardest_across(motion, bodies, of, body, J[J > 0])
    return u


def _hardest_across(motion: Motion, bodies: Bodies, of: Closed, body: int, J: Array) -> Array:
    _, _, u, _ = _flown(motion, bodies, of, np.zeros(J.size, int), np.full(J.size, body), J)
    hardest: Array = u.max(-1)
    return hardest


def _first_reached(shares: Array, u: Array, limits: Array) -> tuple[Array, Array, Array, Array]:
    """The ends of the first section at whose end each limit is reached, and the speeds there."""
    shares, u = (np.broadcast_to(each, (limits.size, u.shape[1])) for each in (shares, u))
    k, each = np.maximum(np.argmax(u >= limits[:, None], 1), 1), np.arange(limits.size)
    return shares[each, k - 1], shares[each, k], u[each, k - 1], u[each, k]


# --- one lane in detail


def course(motion: Motion, bodies: Bodies, point: int, body: int) -> tuple[Array, Array, Array]:
    """ε of the crank over a working cycle (K,), there y of a body between its flanks, 0 … −J in m (K,), and the force
    in its mesh without the peaks of the strikes, in N (K,): on the coast flank it is below 0, in flight 0.

    A body that does not fly of itself stays on its driving flank.  An orbit that does not fit into a working cycle is
    shown from the letting-go with which it begins."""
    motion, bodies = motion.at([point]), bodies.at([point])
    of = closed(motion, bodies)
    strikes = fly(motion, bodies, of)
    epsilon = motion.nodes(motion.cycle)

    def ways(at: Array, integrals: int) -> Array:
        """x'' of what drives the body, less gravity; v; x."""
        own: Array = motion.over(at, integrals)[0] * bodies.ratio[body]
        if bodies.gravity is not None:
            own = own - _gravity(motion, bodies, of.mass, at, integrals)[0, body]
        return own

    M, g = of.mass[body], of.drag[0, body] / of.mass[body]
    if not strikes.orbit[0, body]:
        return epsilon, np.zeros(epsilon.size), M * (ways(epsilon, 0) + g)
    J, omega = strikes.backlash[0, body], motion.omega[0]
    let_go, at, left = strikes.let_go[0, body], strikes.struck[0, body], strikes.left[0, body]
    first, length = int(strikes.first[0, body]), strikes.orbit[0, body] * omega
    phase = (epsilon - let_go[first]) % motion.cycle % length + let_go[first]  # in the orbit
    y, F = np.zeros(epsilon.size), M * (ways(phase, 0) + g)
    for e in range(first, int(np.isfinite(at).sum())):
        tau, start = (phase - let_go[e]) / omega, let_go[e : e + 1]
        flight = (left[e] - 1) * J / 2 + ways(phase, 2) - ways(start, 2) - ways(start, 1) * tau + g * tau**2 / 2
        flies, rests = (phase >= let_go[e]) & (phase < at[e]), (phase >= at[e]) & (phase < let_go[e + 1])
        y = np.where(flies, np.clip(flight, -J, 0.0), np.where(rests, (left[e + 1] - 1) * J / 2, y))
        F = np.where(flies, 0.0, F)
    return epsilon, y, F
