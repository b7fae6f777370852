# SPDX-License-Identifier: Apache-2.0
"""How the crank moves the train, and the train as bodies on one line, as arrays over many operating points.

Bodies are measured in metres along the transverse line of action: x = r_b·θ, each in its own sense of rotation.  Wheels
in mesh have equal x whatever their ratio; an idler is one mass.  The motion of the first driver is given: the train
does not act back on it but through its inertia."""

import math
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from ...sheet.arrays import Array, BoolArray, ComplexArray
from ...sheet.record import record, replace
from ...sheet.units import Radian

FEWEST_NODES, NODES_A_WAVE = 120, 15
FITS, FINEST = 1e-6, 20  # of a step; denominator of an order that fits into no cycle
TURN = 2 * math.pi


@record
class Motion:
    """Of the first driver along its line of action, at P operating points: x₀'' = Re Σ a_n·e^{inε}, ε = ωt the angle of
    the crank."""

    orders: Array  # (N,) on the crank: ½, 1, 1½ …, those that are there
    a: ComplexArray  # (P, N) in m/s²
    omega: Array  # (P,) of the crank, in rad/s
    cycle: Radian  # of the engine: 4π, or 2π of a two-stroke

    @cached_property
    def period(self) -> Radian:
        """The angle of the crank after which the motion repeats itself: a part of the cycle, or where orders are given
        that do not fit into it, what all of them fit into."""
        there = self.orders[np.any(self.a != 0, axis=0)]
        steps = there * self.cycle / TURN
        if np.all(np.abs(steps - np.round(steps)) < FITS):
            return self.cycle / int(np.gcd.reduce(np.round(steps).astype(int))) if there.size else self.cycle
        given = [Fraction(float(order)).limit_denominator(FINEST) for order in there]
        whole = math.lcm(*(order.denominator for order in given))
        return TURN * whole / math.gcd(*(int(order * whole) for order in given))

    def nodes(self, period: Radian) -> Array:
        """Angles of the crank over a period, K of them, the end left out."""
        highest = round(float(self.orders[-1]) * period / (2 * math.pi))
        count = max(FEWEST_NODES, NODES_A_WAVE * highest)
        return np.arange(count, dtype=np.float64) * (period / count)

    def over(self, epsilon: Array, integrals: int = 0) -> Array:
        """x₀'' at angles of the crank (P, K); integrated once, v, or twice, x, over time, each about its own
        mean; −1: its rate, m/s³."""
        angles, a = self.orders[:, None] * epsilon, self._integrated(integrals)
        # not by a product of matrices, whose library waits for threads that a busy machine does not give
        of: Array = np.einsum("pn,nk->pk", a.real, np.cos(angles)) - np.einsum("pn,nk->pk", a.imag, np.sin(angles))
        return of

    def on_nodes(self, period: Radian, integrals: int = 0) -> Array:
        """The same on the nodes of a period that it fits into, by a fast Fourier transform."""
        there = np.any(self.a != 0, axis=0)
        count, waves = self.nodes(period).size, np.round(self.orders[there] * period / TURN).astype(int)
        spectrum = np.zeros((self.omega.size, count // 2 + 1), dtype=complex)
        spectrum[:, waves] = self._integrated(integrals)[:, there] * (count / 2)
        return np.fft.irfft(spectrum, count)

    def _integrated(self, integrals: int) -> ComplexArray:
        a: ComplexArray = self.a / (1j * self.orders * self.omega[:, None]) ** integrals
        return a

    def at(self, points: Any) -> "Motion":
        """The motion of some of the points, as numpy chooses rows."""
        return Motion(self.orders, self.a[points], self.omega[points], self.cycle)


def peak(values: Array) -> Array:
    """The largest along the last axis, equal steps of one period, by the parabola through the largest and both of its
    neighbours."""
    k = np.argmax(values, -1)[..., None]
    before, at, after = (np.take_along_axis(values, (k + i) % values.shape[-1], -1)[..., 0] for i in (-1, 0, 1))
    bend = before - 2 * at + after
    return at - np.divide((after - before) ** 2, 8 * bend, out=np.zeros_like(at), where=bend < 0)


@record
class Bodies:
    """The train: every mesh, chain or belt with the body that it drives, B of them, those that drive before those that
    are driven; each reckoned at its own mesh.

    ρ: base radius of the wheel by which a body drives over that of the wheel by which it is driven; behind it x₀'' is
    ρ times as large, M and D there count ρ² and ρ times."""

    parent: tuple[int, ...]  # index of the body that drives; −1: the first driver
    rho: Array  # (B,)
    toothed: tuple[bool, ...]  # False: a chain or belt, which has no backlash, no flanks and no stiffness here
    mass: Array  # (B,) own J/r_b² in kg
    drag: Array  # (P, B) own T_d/r_b in N
    backlash: Array  # (B,) or (P, B) along the line of action in m; where it is not above 0 nothing strikes
    width: Array  # (B,) in m
    stiffness: Array  # (B,) c_γα of 100 N/mm and more, in Pa
    gravity: ComplexArray | None = None  # (P, B): what gravity turns it by, Re{G·e^{i·order·ε}}, in N
    gravity_order: Array | None = None  # (B,) on the crank
    sprung: BoolArray | None = None  # (P, B): meshes that a split gear holds closed

    def at(self, points: Any) -> "Bodies":
        """The train at some of the points, as numpy chooses rows."""
        backlash = self.backlash if self.backlash.ndim == 1 else self.backlash[points]
        gravity = None if self.gravity is None else self.gravity[points]
        sprung = None if self.sprung is None else self.sprung[points]
        return replace(self, drag=self.drag[points], backlash=backlash, gravity=gravity, sprung=sprung)

    @cached_property
    def before(self) -> BoolArray:
        """(B, B): [i, d], body i is on the path from the first driver to d; d is on its own."""
        path = np.eye(len(self.parent), dtype=bool)
        for d, parent in enumerate(self.parent):
            if parent >= 0:
                path[:, d] |= path[:, parent]
        return path

    @cached_property
    def ratio(self) -> Array:
        """(B,): x₀'' at the mesh of a body over that of the first driver, Πρ of its path."""
        product: Array = np.prod(np.where(self.before, self.rho[:, None], 1.0), 0)
        return product

    @cached_property
    def lever(self) -> Array:
        """(B, B): [i, d], Πρ from body i to d behind it; 0 where d is not behind i."""
        return np.where(self.before, self.ratio / self.ratio[:, None], 0.0)
