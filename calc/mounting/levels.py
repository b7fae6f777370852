# SPDX-License-Identifier: Apache-2.0
"""What a steady state is where it is looked at: displacement, velocity, acceleration, what people feel, forces.

First at one speed, then of a seat over speed."""

import math
from functools import cache
from typing import Any

import numpy as np

from ..sheet.arrays import Array, ComplexArray
from ..sheet.formula import formula
from ..sheet.functions import sqrt
from ..sheet.record import record
from ..sheet.units import Metre, MetrePerSecond, MetrePerSecond2, Newton, NewtonMetre, Newtons, Number
from ..sheet.value import based_on
from . import standards
from .inputs import MountingInputs, Point
from .system import System, decomposed, gain, moves, respond, respond_at, transmitted
from .wrenches import EngineWrenches

CIRCLE = 720  # points over the cycle, for the largest deflection
NONE_BELOW = 1e-9  # of the largest order: there is no such order


RMS = "mathematics: root mean square of the orders"


@formula("s", RMS, shows="√(Σ |ŝ_n|²/2)", unit="mm")
def displacement(s: Metre) -> Metre:
    """Here and below: of the lines along the last axis."""
    return _rms(s)


@formula("v", RMS, shows="√(Σ |v̂_n|²/2)", unit="mm/s")
def velocity(v: MetrePerSecond) -> MetrePerSecond:
    return _rms(v)


@formula("a", RMS, shows="√(Σ |â_n|²/2)", unit="m/s²")
def acceleration(a: MetrePerSecond2) -> MetrePerSecond2:
    return _rms(a)


@formula("F", RMS, shows="√(Σ |F̂_n|²/2)", unit="N")
def force(F: Newton) -> Newton:
    return _rms(F)


def _rms(x: float) -> float:
    rms = np.sqrt(np.sum(np.square(np.abs(x)), -1) / 2)
    return rms if rms.ndim else float(rms)


@formula(
    "s", "mathematics: root of the sum of squares of three axes", unit="mm", names={"x": "s_x", "y": "s_y", "z": "s_z"}
)
def total_displacement(x: Metre, y: Metre, z: Metre) -> Metre:
    return sqrt(x**2 + y**2 + z**2)


@formula(
    "v",
    "mathematics: root of the sum of squares of three axes",
    unit="mm/s",
    names={"x": "v_x", "y": "v_y", "z": "v_z"},
)
def total_velocity(x: MetrePerSecond, y: MetrePerSecond, z: MetrePerSecond) -> MetrePerSecond:
    return sqrt(x**2 + y**2 + z**2)


@formula(
    "a",
    "mathematics: root of the sum of squares of three axes",
    unit="m/s²",
    names={"x": "a_x", "y": "a_y", "z": "a_z"},
)
def total_acceleration(x: MetrePerSecond2, y: MetrePerSecond2, z: MetrePerSecond2) -> MetrePerSecond2:
    return sqrt(x**2 + y**2 + z**2)


KINDS: tuple[tuple[Any, Any], ...] = (
    (displacement, total_displacement),
    (velocity, total_velocity),
    (acceleration, total_acceleration),
)


@formula("ΣF", "mathematics: root of the sum of squares of the mounts' rms forces", shows="√(Σ F_j²)")
def force_sum(F: Newtons) -> Newton:
    return float(np.sqrt(np.sum(np.square(F), -1)))


@formula(
    "δ_peak",
    "kinematics: largest over the cycle and the three own axes",
    shows="max over ε of |Re Σ δ̂_n·e^(inε)|",
    unit="mm",
)
def deflection_peak(delta: Metre) -> Metre:
    """Of lines of orders 1, 2, … of the cycle (…, axes, orders)."""
    peak = peaks(np.asarray(delta)).max(-1)
    return peak if peak.ndim else float(peak)


@formula(
    "T_M",
    "definition of the transmissibility: what the mounts pass on about the centre of gravity over what drives the "
    "engine",
    names={"M": "M̂_G"},
    meanings={"M_t": "Moment that the mounts pass on"},
)
def moment_transmissibility(M_t: NewtonMetre, M: NewtonMetre) -> Number:
    return M_t / M


@formula(
    "T_F",
    "definition of the transmissibility: what the mounts pass on over what drives the engine",
    meanings={"F_t": "Force that the mounts pass on"},
)
def force_transmissibility(F_t: Newton, F: Newton) -> Number:
    return F_t / F


@formula(
    "q_S",
    "definition: level with half on the crank over that with the shaft",
    meanings={
        "half": "Level with half of the reciprocating masses on the crank",
        "shaft": "Level with the counter-shaft",
    },
)
def felt_ratio(half: Number, shaft: Number) -> Number:
    return half / shaft


def peaks(delta: ComplexArray) -> Array:
    """The largest amount over the cycle of each row of lines along the last axis."""
    flat = delta.reshape(-1, delta.shape[-1])
    y = np.abs(np.hstack([flat.real, -flat.imag]) @ _circle(delta.shape[-1]))
    if not np.isfinite(y).all():
        return np.where(np.isfinite(y).all(-1), y.max(-1), np.nan).reshape(delta.shape[:-1])
    row, i = np.arange(len(y)), y.argmax(-1)
    before, top, after = y[row, i - 1], y[row, i], y[row, (i + 1) % CIRCLE]
    bend = 2 * top - before - after  # the top of the parabola through the largest point and its neighbours
    largest: Array = top + np.where(bend > 0, (after - before) ** 2 / (8 * np.where(bend > 0, bend, 1.0)), 0.0)
    return largest.reshape(delta.shape[:-1])


@cache
def _circle(orders: int) -> Array:
    """Cosines over sines of the orders at the points of the cycle."""
    angles = 2 * math.pi / CIRCLE * np.arange(1, orders + 1)[:, None] * np.arange(CIRCLE)
    return np.vstack([np.cos(angles), np.sin(angles)])


def seat_axes(mounting: MountingInputs) -> Array:
    """Rows: forward, to the side, up, in engine axes."""
    up = np.asarray(mounting.up, dtype=float) / np.linalg.norm(mounting.up)
    forward = np.asarray(mounting.forward, dtype=float)
    forward = forward - (forward @ up) * up
    forward /= np.linalg.norm(forward)
    return np.stack([forward, np.cross(up, forward), up])


@record
class Levels:
    """All lines of some speeds (speeds, variants, …, orders): what everything that is published is taken from.

    `motion`: displacement, velocity and acceleration of the points (speeds, variants, points, 3 kinds, 3 axes, orders);
    `felt`: weighted acceleration of seats and hands in their axes, by name; `force` and `deflection`: of the mounts
    (speeds, variants, mounts, 3, orders)."""

    speeds: Array
    frequency: Array  # (speeds, orders), Hz
    wrench: ComplexArray  # (speeds, orders, variants, 6)
    motion: ComplexArray
    acceleration: dict[str, ComplexArray]
    weight: dict[str, Array]  # (speeds, 1, 3, orders) of each seat and hand
    force: ComplexArray
    deflection: ComplexArray
    passed_on: tuple[ComplexArray, ComplexArray]  # force and moment (speeds, variants, orders, 3)
    source: ComplexArray  # q̂, from which all of it comes, with the place of a point
    places: dict[str, object]

    @property
    def band(self) -> Array:
        """Which lines count for severity (speeds, 1, 1, 1, 1, orders)."""
        return standards.in_band(self.frequency)[:, None, None, None, None, :]


def levels(s: System, drive: EngineWrenches, speeds: Array, torque: ComplexArray) -> Levels:
    """At some speeds, all variants and orders."""
    S, O, V = len(speeds), drive.orders.size, len(drive.variants)
    Omega, wrench = drive.frequencies(speeds), drive.wrench(speeds, torque)
    r = respond(s, Omega, based_on(wrench.reshape(S * O, V, 6), wrench))
    points = s.mounting.points
    P = np.stack([moves(s, point) for point in points]) if points else np.zeros((0, 3, s.size))
    u = _ordered(np.einsum("pac,fvc->fvpa", P, np.asarray(r.q)), S)
    w = (2j * math.pi * np.asarray(speeds)[:, None] * drive.orders)[:, None, None, None, :]
    motion = np.stack([u, w * u, w * w * u], axis=3)
    of_people = [(i, point) for i, point in enumerate(points) if point.role != "machine"]
    felt = {point.name: _felt(s.mounting, point, motion[:, :, i, 2]) for i, point in of_people}
    f = Omega.reshape(S, O) / (2 * math.pi)
    weight = {point.name: point_weights(point, f) for _, point in of_people}
    F_t, M_t = (part.reshape(S, O, V, 3).swapaxes(1, 2) for part in transmitted(s, r))
    return Levels(
        np.asarray(speeds),
        f,
        wrench,
        motion,
        felt,
        weight,
        _ordered(np.moveaxis(r.force, 0, 2), S),
        _ordered(np.moveaxis(r.deflection, 0, 2), S),
        (F_t, M_t),
        r.q,
        {point.name: point.position for point in points},
    )


def _ordered(x: ComplexArray, S: int) -> ComplexArray:
    """(speeds·orders, variants, things, axes) with the orders along the last axis."""
    return np.ascontiguousarray(np.moveaxis(x.reshape(S, len(x) // S, *x.shape[1:]), 1, -1))


def _felt(mounting: MountingInputs, point: Point, a: ComplexArray) -> ComplexArray:
    """The acceleration (…, 3, orders) in the axes in which a person has it: of a seat behind its own
    transmissibility."""
    if point.role == "hand":
        return a
    turned: ComplexArray = np.einsum("ij,...jo->...io", _through_the_seat(mounting), a)
    return np.ascontiguousarray(turned)


def _through_the_seat(mounting: MountingInputs) -> Array:
    rows: Array = seat_axes(mounting) * np.asarray(mounting.seat_transmissibility)[:, None]
    return rows


def point_weights(point: Point, f: Array) -> Array:
    """(speeds, 1, 3, orders)."""
    names = ("Wh", "Wh", "Wh") if point.role == "hand" else ("Wd", "Wd", "Wk")
    # in their order, which that of traced lines follows
    by = {name: standards.weights(name, f) for name in dict.fromkeys(names)}
    return np.stack([by[name] for name in names], axis=1)[:, None]


# --- the level of a seat over speed, every variant of the balancing


@record
class Course:
    """The level of one seat over speed: (variants, speeds) all orders together, and each order of `half` and `shaft`
    (speeds, orders)."""

    speeds: Array
    orders: Array
    variants: tuple[str, ...]
    total: Array
    by_order: dict[str, Array]
    source: object  # what the levels come of

    def part(self, which: slice) -> "Course":
        """The same at some of its speeds."""
        by_order = {name: levels[which] for name, levels in self.by_order.items()}
        return Course(self.speeds[which], self.orders, self.variants, self.total[:, which], by_order, self.source)


def course(s: System, drive: EngineWrenches, point: Point, speeds: Array, torque: ComplexArray) -> Course:
    """What a seat feels over speed.  Variants differ in the orders of the shaft alone, so only these are solved for
    each; orders that nothing drives are not solved at all."""
    wrench, half = drive.wrench(speeds, torque), drive.variants.index("half")
    driven = sorted({*np.flatnonzero(np.asarray(wrench[:, :, half]).any(axis=(0, 2))).tolist(), *drive.apart})
    apart = [driven.index(n) for n in drive.apart]
    of_half, of_each = np.asarray(wrench[:, driven, half : half + 1]), np.asarray(wrench[:, list(drive.apart)])
    f = np.asarray(speeds)[:, None] * drive.orders[driven]
    common, separate = _weighted(s, point, f, (of_half, of_each), (slice(None), apart))
    squares = np.zeros((len(speeds), len(drive.variants), drive.orders.size))
    squares[:, :, driven] = common[:, None, :, 0] ** 2
    squares[:, :, list(drive.apart)] = np.swapaxes(separate, 1, 2) ** 2
    by_order = {name: np.sqrt(squares[:, i]) for i, name in enumerate(drive.variants) if name in ("half", "shaft")}
    total, source = np.sqrt(squares.sum(-1)).T, (s.source, wrench, point.position)
    if drive.off:
        total = np.vstack([total[: -len(drive.off)], total[-len(drive.off) :].max(0)])
    return Course(np.asarray(speeds), drive.orders, drive.shown, total, by_order, source)


def _weighted(
    s: System, point: Point, f: Array, wrenches: tuple[ComplexArray, ...], orders: tuple[slice | list[int], ...]
) -> list[Array]:
    """Root mean square, weighted, all three axes, of each of some wrenches (speeds, its orders, variants); `f`:
    (speeds, orders)."""
    Omega, P = 2 * math.pi * f, _felt_rows(s, point)
    sizes = point_weights(point, f)[:, 0].swapaxes(1, 2) * (Omega**2)[:, :, None]  # (speeds, orders, 3)
    if s.constant:
        _, whole = s.mount_stiffness(Omega.ravel()[:1])
        d = decomposed(s.stiffness(whole, Omega.ravel()[:1])[0], s.M)
        gains = gain(d.values, Omega.ravel()).reshape(*f.shape, -1)
    rms = []
    for wrench, which in zip(wrenches, orders):
        if s.constant:
            u = ((wrench @ d.left.T) * gains[:, which, None, :]) @ (P @ d.right).T
        else:
            q = respond_at(s, Omega[:, which].ravel(), wrench.reshape(-1, *wrench.shape[2:]))
            u = (q @ P.T).reshape(*wrench.shape[:3], 3)
        a = np.abs(u) * sizes[:, which, None, :]
        rms.append(np.sqrt((a**2).sum(-1) / 2))
    return rms


def _felt_rows(s: System, point: Point) -> Array:
    rows = moves(s, point)
    return rows if point.role == "hand" else _through_the_seat(s.mounting) @ rows
