# SPDX-License-Identifier: Apache-2.0
"""The loaded zone: how the load spreads over the elements of a bearing whose inner ring is pressed to one side.

An element at φ from the load carries q = [1 − (1 − cos φ)/(2ε)]^n of the one in the middle, nothing where that is below
0.  ε: how far the zone reaches, ½ without clearance, less with it, all round from 1 on.  Means are taken over the whole
turn: J_r of q·cos φ, J_w = (mean of q^w)^{1/w}."""

from functools import cache
from typing import Any, NamedTuple

import numpy as np

from ...sheet.arrays import Array
from ...sheet.formula import formula
from ...sheet.functions import single_or_many
from ...sheet.text import Text
from ...sheet.units import Number
from .sizes import Elements

INTEGRALS = Text("Harris 2001, load distribution, with the powers of ISO/TS 16281: zone integral")


class Exponents(NamedTuple):
    """What distinguishes balls from rollers in load and life."""

    p: float  # of life: (C/P)^p
    n: float  # of the contact: Q ∝ δ^n
    turns: float  # w of the race that turns under the load
    stands: float  # w of the race on which the load stands
    races: float  # u: how the loads of both races add up
    weibull: float  # e: spread of lives


EXPONENTS: dict[Elements, Exponents] = {
    "ball": Exponents(3.0, 3 / 2, 3.0, 10 / 3, 10 / 3, 10 / 9),
    "roller": Exponents(10 / 3, 10 / 9, 4.0, 4.5, 4.5, 9 / 8),
}

LEAST, MOST = 0.002, 1000.0  # ε of the table; beyond it J grows and falls as it does at its ends
POINTS = (1200, 800)  # to ε = 1, where the slopes bend, and from there on
ANGLES = 32
BEYOND = 60.0  # of ln ε, farther than any ε


@formula("J_r", INTEGRALS, shows="mean of q·cos φ over the turn at ε, by table")
def radial_integral(eps: Number, elements: Elements) -> Number:
    """>>> radial_integral(eps=0.5, elements="ball")
    0.22882...
    """
    return single_or_many(np.asarray(zone_of(elements).radial(eps)[0]))


@formula("J_t", INTEGRALS, shows="(mean of q^w over the turn)^(1/w) at ε, w = 3 of balls, 4 of rollers, by table")
def turning_integral(eps: Number, elements: Elements) -> Number:
    """Of a race that turns under the load."""
    return single_or_many(np.asarray(zone_of(elements).races(eps)[0]))


@formula("J_s", INTEGRALS, shows="(mean of q^w over the turn)^(1/w) at ε, w = 10/3 of balls, 4.5 of rollers, by table")
def standing_integral(eps: Number, elements: Elements) -> Number:
    """Of a race on which the load stands."""
    return single_or_many(np.asarray(zone_of(elements).races(eps)[1]))


@formula(
    "ε_1",
    "rule of this program: a race is no shorter under the load than one element is from the next",
    shows="Z·J_r(ε_1) = 1, by table; at most ½",
)
def narrowest(Z: Number, elements: Elements) -> Number:
    """The zone below which one element carries all: elements one after the other then load the races no less far."""
    zone = zone_of(elements)
    rising = zone.ln_eps <= np.log(0.5)
    return single_or_many(np.asarray(np.exp(np.interp(-np.log(Z), zone.J_r[rising], zone.ln_eps[rising]))))


class Zone(NamedTuple):
    """The integrals by ln ε: ln J_r and its slope, ln J_w of both races."""

    ln_eps: Array
    J_r: Array
    slope: Array
    J_turns: Array
    J_stands: Array

    def radial(self, eps: Any) -> Any:
        """J_r(ε), and d ln J_r/d ln ε."""
        at = _ln(eps)
        return np.exp(np.interp(at, self.ln_eps, self.J_r)), np.interp(at, self.ln_eps, self.slope)

    def races(self, eps: Any) -> Any:
        """J_w of a race that turns under the load, and of one on which it stands."""
        at = _ln(eps)
        return np.exp(np.interp(at, self.ln_eps, self.J_turns)), np.exp(np.interp(at, self.ln_eps, self.J_stands))


@cache
def zone_of(elements: Elements) -> Zone:
    """The integrals of balls, or of rollers."""
    x = EXPONENTS[elements]
    ends = np.log((LEAST, MOST))
    ln_eps = np.concatenate(
        [np.linspace(ends[0], 0.0, POINTS[0], endpoint=False), np.linspace(0.0, ends[1], POINTS[1])]
    )
    J = np.log(integrals(np.exp(ln_eps), x.n, (x.turns, x.stands)))
    slope = np.gradient(J[0], ln_eps)  # by central differences
    # towards 0 the zone narrows by √ε; far beyond 1 the load fades by 1/ε while all elements carry the same
    J = np.column_stack([J[:, 0] - BEYOND * np.array([1 / 2, 1 / 2 / x.turns, 1 / 2 / x.stands]), J, J[:, -1]])
    J[0, -1] -= BEYOND
    ln_eps = np.concatenate([[ln_eps[0] - BEYOND], ln_eps, [ln_eps[-1] + BEYOND]])
    return Zone(ln_eps, J[0], np.concatenate([[0.5], slope, [-1.0]]), J[1], J[2])


def integrals(eps: Array, n: float, w: tuple[float, ...]) -> Array:
    """J_r, and J_w for each w, of many ε: a row each.

    By the midpoint rule; over φ = ψ·sin(πu/2) where the zone ends at ψ, which makes smooth what begins there; good to
    1e-7, at ε = 1 to 1e-6."""
    part = (np.arange(ANGLES) + 0.5) / ANGLES
    psi, around = np.arccos(np.maximum(1 - 2 * eps, -1.0))[:, None], eps[:, None] >= 1
    phi = psi * np.where(around, part, np.sin(np.pi / 2 * part))
    weight = psi / np.pi / ANGLES * np.where(around, 1.0, np.pi / 2 * np.cos(np.pi / 2 * part))
    ln_q = n * np.log(np.maximum(1 - np.sin(phi / 2) ** 2 / eps[:, None], 1e-300))
    J_r = np.sum(weight * np.exp(ln_q) * np.cos(phi), axis=1)
    return np.array([J_r, *(np.sum(weight * np.exp(k * ln_q), axis=1) ** (1 / k) for k in w)])


def _ln(eps: Any) -> Any:
    with np.errstate(divide="ignore"):
        return np.log(eps)
