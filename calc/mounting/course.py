# SPDX-License-Identifier: Apache-2.0
"""The level of a seat over speed, every variant of the balancing."""

import math

import numpy as np

from ..sheet.arrays import Array, ComplexArray
from ..sheet.record import record
from .drive import Drive
from .levels import point_weights, seat_axes
from .system import System, decomposed, gain, moves, respond_at
from .use_inputs import Point


@record
class Course:
    """The level of one seat over speed: (variants, speeds) all orders together, and each order of `half` and `shaft` (speeds, orders)."""

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


def course(s: System, drive: Drive, point: Point, speeds: Array, torque: ComplexArray) -> Course:
    """What a seat feels over speed.  Variants differ in the orders of the shaft alone, so only these are solved for each; orders that
    nothing drives are not solved at all."""
    wrench, half = drive.wrench(speeds, torque), drive.variants.index("half")
    driven = sorted({*np.flatnonzero(np.asarray(wrench[:, :, half]).any(axis=(0, 2))).tolist(), *drive.apart})
    apart = [driven.index(n) for n in drive.apart]
    of_half, of_each = np.asarray(wrench[:, driven, half : half + 1]), np.asarray(wrench[:, list(drive.apart)])
    common, own = _weighted(s, point, np.asarray(speeds)[:, None] * drive.orders[driven], (of_half, of_each), (slice(None), apart))
    squares = np.zeros((len(speeds), len(drive.variants), drive.orders.size))
    squares[:, :, driven] = common[:, None, :, 0] ** 2
    squares[:, :, list(drive.apart)] = np.swapaxes(own, 1, 2) ** 2
    by_order = {name: np.sqrt(squares[:, i]) for i, name in enumerate(drive.variants) if name in ("half", "shaft")}
    return Course(
        np.asarray(speeds), drive.orders, drive.variants, np.sqrt(squares.sum(-1)).T, by_order, (s.source, wrench, point.position)
    )


def _weighted(s: System, point: Point, f: Array, wrenches: tuple[ComplexArray, ...], orders: tuple[slice | list[int], ...]) -> list[Array]:
    """Root mean square, weighted, all three axes, of each of some wrenches (speeds, its orders, variants); `f`: (speeds, orders)."""
    Omega, P = 2 * math.pi * f, _felt_rows(s, point)
    sizes = point_weights(point, f)[:, 0].swapaxes(1, 2) * (Omega**2)[:, :, None]  # (speeds, orders, 3)
    found = []
    if s.constant:
        _, whole = s.mount_stiffness(Omega.ravel()[:1])
        d = decomposed(s.stiffness(whole, Omega.ravel()[:1])[0], s.M)
        gains = gain(d.values, Omega.ravel()).reshape(*f.shape, -1)
        moved = [((one @ d.left.T) * gains[:, which, None, :]) @ (P @ d.right).T for one, which in zip(wrenches, orders)]
    else:
        moved = [
            (respond_at(s, Omega[:, which].ravel(), one.reshape(-1, *one.shape[2:])) @ P.T).reshape(*one.shape[:3], 3)
            for one, which in zip(wrenches, orders)
        ]
    for u, which in zip(moved, orders):
        a = np.abs(u) * sizes[:, which, None, :]
        found.append(np.sqrt((a**2).sum(-1) / 2))
    return found


def _felt_rows(s: System, point: Point) -> Array:
    rows = moves(s, point)
    if point.role == "hand":
        return rows
    turned: Array = (seat_axes(s.mounting) * np.asarray(s.mounting.seat_transmissibility)[:, None]) @ rows
    return turned
