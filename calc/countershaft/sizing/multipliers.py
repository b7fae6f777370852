# SPDX-License-Identifier: Apache-2.0
"""The lightest sectors in several stretches of a shaft, for force and couple in one direction; nothing here has a unit.

Each stretch carries one sector with one half-angle and free ends.  As in lengths.py the task is α = U/(k·z_max) and
Π = P/(k·z_max²), here along the common direction, and ζ = z/z_max, with z_max the farthest face.  With a multiplier for
each, the line h(ζ) = λ_F + λ_C·ζ says what a sector is worth at ζ: the least mass Σ γ·β that gives α and Π is the
largest value of

    λ_F·α + λ_C·Π − Σ max over ends and γ of ∫(|h|·sin γ − γ)dζ

A sector stands on the side that the sign of h says; where h changes it within a stretch, the stretch is cut there and
may carry two, opposed.  |h| is straight in each part: the sector begins at the end where it is larger and fills the
part, or ends where |h| = γ/sin γ.  The function is concave and has a slope everywhere, which is what is still missing
of α and Π: where nothing is missing, the sectors are the lightest of their kind, and no other search is needed.  They
are there whenever the stretches, filled to 90° on the sides that h says, can give more than is asked.  A sector that is
twisted along z, or several in a row, would save up to 2.5 % more."""

import math
from collections.abc import Callable, Iterable
from functools import lru_cache
from typing import NamedTuple

from ...sheet.formula import formula
from ...sheet.functions import acos, root, sin
from ...sheet.text import Text
from ...sheet.units import Number, Radian
from ...sheet.value import untraced

Stretches = tuple[tuple[float, float], ...]  # where each begins and ends, front to rear
FAR = 1e9  # multipliers beyond which every sector is at 90°, to the last digit
NO_SECTOR = 1e-12  # of the unbalance of one of length 1 at 90°: one below it is left out

LIGHTEST = Text("mathematics, least mass of one sector for each stretch, by Lagrange's multipliers")
OUTWARD = Text("{lightest}: where its part has the most of it", lightest=LIGHTEST)
FILLS = Text("{lightest}: of a sector that fills its part", lightest=LIGHTEST)
FREE = Text("{lightest}: of a sector with a free end", lightest=LIGHTEST)


@formula("h_o", OUTWARD, names={"lam_F": "λ_F", "lam_C": "λ_C", "zeta": "ζ_o"})
def worth(lam_F: Number, lam_C: Number, zeta: Number) -> Number:
    return abs(lam_F + lam_C * zeta)


@formula("γ", FILLS, names={"h": "h_o", "lam_C": "λ_C"})
def filled_half_angle(h: Number, lam_C: Number, beta_max: Number) -> Radian:
    return acos(1 / (h - abs(lam_C) * beta_max / 2))


@formula("β", FILLS)
def filled_length(beta_max: Number) -> Number:
    return beta_max


@formula("γ", FREE, shows="γ from (h_o + γ/sin γ)·cos γ = 2, Newton", names={"h": "h_o"})
def free_half_angle(h: Number) -> Radian:
    """Of h_o above 1.  The left side falls and bends down, so that each step stops short of the root; the start lies
    beyond it, by cos γ ≤ 1 − (2γ/π)² and γ·cot γ ≤ 1 − γ²/3."""
    gamma = min(math.sqrt((h - 1) / (4 * h / math.pi**2 + 1 / 3)), math.pi / 2)
    while True:
        sine, cosine = math.sin(gamma), math.cos(gamma)
        left = (h + gamma / sine) * cosine - 2
        # the slope of γ·cot γ; the difference has no digits left where γ is small
        of_cot = (sine * cosine - gamma) / sine**2 if gamma > 1e-4 else -2 / 3 * gamma
        nearer = gamma - left / (of_cot - h * sine)
        if not 0 < nearer < gamma:
            return gamma
        gamma = nearer


@formula("β", Text("{free}: up to where h = γ/sin γ", free=FREE), names={"h": "h_o", "lam_C": "λ_C"})
def free_length(h: Number, gamma: Radian, lam_C: Number) -> Number:
    return (h - gamma / sin(gamma)) / abs(lam_C)


def grown(h: float, lam_C: float, longest: float) -> tuple[float, float]:
    """Half-angle and length of the sector in a part of the given length, from its worth at the outer end (above 1)."""
    mean, least = h - abs(lam_C) * longest / 2, h - abs(lam_C) * longest
    if mean > 1:
        gamma = filled_half_angle(h=h, lam_C=lam_C, beta_max=longest)
        if gamma <= least * math.sin(gamma):
            return gamma, filled_length(beta_max=longest)
    gamma = free_half_angle(h=h)
    return gamma, free_length(h=h, gamma=gamma, lam_C=lam_C)


class Part(NamedTuple):
    """Of a stretch, where h has one sign: the end where a sector is worth most, the sense of ζ from there (+1 or −1),
    the length, and the side of the sector (+1 or −1)."""

    outer: float
    inward: float
    length: float
    side: float


def parts(lam_F: float, lam_C: float, where: Stretches) -> Iterable[Part]:
    """The parts in which a sector is worth its mass."""
    cut = -lam_F / lam_C if lam_C else math.inf
    for start, end in where:
        for low, high in ((start, cut), (cut, end)) if start < cut < end else ((start, end),):
            h_low, h_high = lam_F + lam_C * low, lam_F + lam_C * high
            outer, inward = (high, -1.0) if abs(h_high) > abs(h_low) else (low, 1.0)
            if max(abs(h_low), abs(h_high)) > 1:
                yield Part(outer, inward, high - low, math.copysign(1.0, h_low + h_high))


def supply(lam_F: float, lam_C: float, where: Stretches) -> tuple[float, float, float]:
    """α and Π of the lightest sectors at these multipliers, and their mass Σ γ·β."""
    alpha = product = mass = 0.0
    for part in parts(lam_F, lam_C, where):
        gamma, beta = grown(worth(lam_F=lam_F, lam_C=lam_C, zeta=part.outer), lam_C, part.length)
        unbalance = part.side * beta * math.sin(gamma)
        alpha += unbalance
        product += unbalance * (part.outer + part.inward * beta / 2)
        mass += gamma * beta
    return alpha, product, mass


def present(lam_F: float, lam_C: float, where: Stretches) -> list[Part]:
    """The parts that carry a sector, but for those that would carry next to none."""
    with untraced():
        return [part for part in parts(lam_F, lam_C, where) if _unbalance(lam_F, lam_C, part) > NO_SECTOR]


def _unbalance(lam_F: float, lam_C: float, part: Part) -> float:
    gamma, beta = grown(worth(lam_F=lam_F, lam_C=lam_C, zeta=part.outer), lam_C, part.length)
    return beta * math.sin(gamma)


def _most(lam_F: float, lam_C: float, where: Stretches) -> tuple[float, float]:
    """α and Π of all stretches filled to 90°, on the sides that h says."""
    cut = -lam_F / lam_C if lam_C else math.inf
    alpha = product = 0.0
    for start, end in where:
        middle = min(max(cut, start), end)
        for low, high in ((start, middle), (middle, end)):
            unbalance = math.copysign(high - low, lam_F + lam_C * (low + high) / 2)
            alpha += unbalance
            product += unbalance * (low + high) / 2
    return alpha, product


def _turned(alpha: float, product: float, across: Callable[[float], float]) -> float:
    """The direction of the multipliers, within 90° of the task's, where what is given has nothing across it."""
    towards = math.atan2(product, alpha)
    return root(across, towards - math.pi / 2, towards + math.pi / 2, tolerance=1e-15)


def utilisation(alpha: float, product: float, where: Stretches) -> float:
    """What is asked over the most that the stretches give in the same proportion: 1 is the limit of the envelope."""

    def across(theta: float) -> float:
        a, p = _most(math.cos(theta), math.sin(theta), where)
        return p * alpha - a * product

    theta = _turned(alpha, product, across)
    x, y = math.cos(theta), math.sin(theta)
    a, p = _most(x, y, where)
    return (alpha * x + product * y) / (a * x + p * y)


@lru_cache(maxsize=64)
def multipliers(alpha: float, product: float, where: Stretches) -> tuple[float, float]:
    """λ_F and λ_C of the lightest sectors that give α and Π, for a utilisation up to 1; remembered, since two formulas
    ask for them.

    In a given direction of (λ_F, λ_C) what the sectors give along it rises with the multipliers, from nothing: so far
    they go.  Over the directions what is then missing across changes its sign once.  Two bisections (Brent's) find
    both; Newton's method alone sticks where a single filled sector is left."""

    def reach(x: float, y: float) -> float:
        asked = alpha * x + product * y
        least = 1 / max(abs(x + y * face) for stretch in where for face in stretch)

        def missing(r: float) -> float:
            a, p, _ = supply(r * x, r * y, where)
            return a * x + p * y - asked

        if missing(least) >= 0:  # next to nothing is asked along it, or less
            return least
        near, far = least, 2 * least
        while missing(far) < 0:
            if far > FAR:
                return far
            near, far = far, 2 * far
        return root(missing, near, far, tolerance=1e-15)

    def across(theta: float) -> float:
        x, y = math.cos(theta), math.sin(theta)
        r = reach(x, y)
        a, p, _ = supply(r * x, r * y, where)
        return (p - product) * x - (a - alpha) * y

    with untraced():
        theta = _turned(alpha, product, across)
        x, y = math.cos(theta), math.sin(theta)
        r = reach(x, y)
    return r * x, r * y
