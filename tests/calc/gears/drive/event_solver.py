# SPDX-License-Identifier: Apache-2.0
"""One body between two flanks, event by event, at any instant of the motion: to hold the vectorised form against.

Shares nothing with it: the motion is a sum of cosines that is evaluated where it is asked for, every instant is found by
Brent's method, and a flight may begin with a speed."""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

A_WAVE = 60  # steps in the shortest wave
MANY = 40  # events without an orbit
LONGEST = 300  # periods of one flight


@dataclass
class Driver:
    """x'' = Re Σ a_n·e^{i·w_n·t}."""

    w: np.ndarray  # rad/s
    a: np.ndarray  # complex, m/s²
    period: float  # s

    def of(self, t, integrals):
        waves = np.exp(1j * np.multiply.outer(t, self.w))
        return (waves @ (self.a / (1j * self.w) ** integrals)).real

    @property
    def steps(self):
        shortest = 2 * np.pi / np.max(self.w)
        count = round(A_WAVE * self.period / shortest)
        return np.arange(1, count + 1) * (self.period / count)


@dataclass
class Strike:
    let_go: float
    left: int  # flank: 1 driving, −1 coast
    at: float
    flank: int
    speed: float  # y' before it, m/s
    press: float  # p, m/s²


def letting_go(driver, g, side, since):
    """The next instant at which p turns against the flank."""
    t = since + np.concatenate(([0.0], driver.steps))
    against = side * (driver.of(t, 0) + g) < 0
    k = int(np.argmax(against[1:])) + 1
    assert against[k]
    return brentq(lambda t: driver.of(t, 0) + g, t[k - 1], t[k], xtol=1e-15, rtol=1e-14)


def flight(driver, g, J, t_0, side, w=0.0):
    """From a flank at t_0 with y' = w: (instant, flank, y') of the strike."""
    x_0, v_0, y_0 = driver.of(t_0, 2), driver.of(t_0, 1) - w, 0.0 if side > 0 else -J

    def y(t):
        return y_0 + driver.of(t, 2) - x_0 - v_0 * (t - t_0) + g * (t - t_0) ** 2 / 2

    def slope(t):
        return driver.of(t, 1) - v_0 + g * (t - t_0)

    for n in range(LONGEST):
        first = driver.steps[0] / np.array([np.inf, 256, 64, 16, 4])  # flights may be short
        t = t_0 + n * driver.period + np.concatenate((first, driver.steps))
        out = np.where(y(t) > 0, 1, np.where(y(t) < -J, -1, 0))
        if n == 0:
            out[:2][out[:2] == side] = 0  # where it is just leaving
        turning = np.sign(slope(t))
        for k in range(1, len(t)):
            end, to = t[k], out[k]
            if not to and turning[k - 1] * turning[k] < 0 and (n or k > 1):  # beyond a flank and back between two steps
                top = brentq(slope, t[k - 1], t[k], xtol=1e-15, rtol=1e-14)
                end, to = top, 1 if y(top) > 0 else -1 if y(top) < -J else 0
            if to:
                wall = 0.0 if to > 0 else -J
                at = brentq(lambda t, wall=wall: y(t) - wall, t[k - 1], end, xtol=1e-16, rtol=1e-14)
                return at, int(to), float(slope(at))
    raise AssertionError("no flank is met")


def orbit(driver, g, J, events=MANY):
    """Without rebound, from the driving flank where p is largest: (strikes of the orbit, its length in s, how many events
    came before it; None: no orbit)."""
    t = np.concatenate(([0.0], driver.steps))
    left, since = 1, letting_go(driver, g, 1, t[np.argmax(driver.of(t, 0))])
    strikes = []
    for _ in range(events):
        at, flank, u = flight(driver, g, J, since, left)
        p = float(driver.of(at, 0)) + g
        strikes.append(Strike(since, left, at, flank, u, p))
        left, since = flank, letting_go(driver, g, flank, at) if flank * p > 0 else at
        for n, before in enumerate(strikes):
            apart = (since - before.let_go) / driver.period
            if before.left == left and abs(apart - round(apart)) < 1e-6:
                return strikes[n:], since - before.let_go, n
    return strikes, since - strikes[0].let_go, None
