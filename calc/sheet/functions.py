# SPDX-License-Identifier: Apache-2.0
"""The mathematical functions that formulas may use: `math` for a float, numpy for anything else.

They are typed float → float so that formulas stay readable to the type checker; arrays enter by the same door.
"""

import math
from collections.abc import Callable
from typing import TypeVar, cast

import numpy as np

from . import linked_array  # makes the links of arrays known
from .arrays import ComplexArray, has_lanes, one, phasors
from .value import LinkedFloat

pi = math.pi
N = TypeVar("N", float, complex)


def _several(x: object) -> bool:
    """Whether this is an array, or the numbers of many designs (`lanes.py`)."""
    return hasattr(x, "ndim") and not isinstance(x, (float, complex))


def _both(scalar: Callable[[float], float], vector: Callable[[float], float]) -> Callable[[float], float]:
    def function(x: float) -> float:
        return scalar(x) if type(x) is float or type(x) is LinkedFloat else vector(x)  # no numpy number: it has other last digits

    function.__name__ = scalar.__name__
    return function


sqrt = _both(math.sqrt, np.sqrt)
exp = _both(math.exp, np.exp)
ln = _both(math.log, np.log)
log10 = _both(math.log10, np.log10)
sin = _both(math.sin, np.sin)
cos = _both(math.cos, np.cos)
tan = _both(math.tan, np.tan)
asin = _both(math.asin, np.arcsin)
acos = _both(math.acos, np.arccos)
atan = _both(math.atan, np.arctan)
degrees = _both(math.degrees, np.degrees)
asinh = _both(math.asinh, np.arcsinh)


def inv(angle: float) -> float:
    """The involute function inv α = tan α − α."""
    return tan(angle) - angle


def cis(angle: float) -> complex:
    """The unit phasor e^{iα}."""
    plain = type(angle) in (float, LinkedFloat)
    return complex(math.cos(angle), math.sin(angle)) if plain else cast(complex, np.exp(1j * angle))


def conj(z: complex) -> complex:
    return z.conjugate()


def modulus(z: complex) -> float:
    return abs(z)


def imag(z: complex) -> float:
    """The part 90° further in the sense of crank rotation."""
    return z.imag


def argument(z: complex) -> float:
    """The angle of a phasor from "up", in the sense of crank rotation [rad]; 0 for a phasor of zero length.

    Parts below 1e-12 of the length are dust of the last digits: 180° and not −180°, 0° and not 4e-15°.
    """
    dust = 1e-12 * abs(z)
    if _several(z):
        return cast(float, np.arctan2(np.where(abs(z.imag) > dust, z.imag, 0.0), np.where(abs(z.real) > dust, z.real, 0.0)))
    return math.atan2(z.imag if abs(z.imag) > dust else 0.0, z.real if abs(z.real) > dust else 0.0)


def power(x: float, y: float) -> float:
    """x^y: Python's `x**y` may be complex for all that a type checker knows."""
    raised: float = x**y
    return raised


def total(x: N) -> N:
    """Sum over all elements (masses, points of contact, …)."""
    added: N = np.sum(x).item()
    return added


def along(x: float) -> float:
    """Sum over the last axis, the positions of a path: a float of one operating point, an array of many."""
    sums = np.sum(x, -1)
    added: float = sums if sums.ndim else sums.item()
    return added


def resultant(x: N) -> N:
    """Sum over the last axis: the cylinders of one engine, or of each of many.

    Vectors that cancel in a direction give 0 there, not the dust of the last digits.
    """
    return cast(N, _resultant(phasors(x) if _several(x) else np.asarray(x)))


def _resultant(x: ComplexArray) -> object:
    dust = 1e-12 * np.sum(np.abs(x), -1)
    if has_lanes(dust):
        found = np.sum(x, -1)
        if not np.iscomplexobj(found):
            return np.where(np.abs(found) <= dust, 0.0, found)
        real, imag = (np.where(np.abs(part) <= dust, 0.0, part) for part in (found.real, found.imag))
        return real + 1j * imag
    if x.ndim > 1:
        found = np.sum(x, -1)
        if not np.iscomplexobj(found):
            return np.where(np.abs(found) > dust, found, 0.0)
        found.real[np.abs(found.real) <= dust] = 0.0
        found.imag[np.abs(found.imag) <= dust] = 0.0
        return found
    one = np.sum(x).item()
    if isinstance(one, complex):
        return complex(one.real if abs(one.real) > dust else 0.0, one.imag if abs(one.imag) > dust else 0.0)
    return one if abs(one) > dust else abs(0.0 * one)  # NaN stays NaN


def joined(a: N, b: N) -> N:
    """Sum of two numbers or vectors; where they cancel, 0 and not the dust of the last digits."""
    added = a + b
    dust = 1e-12 * (abs(a) + abs(b))
    if _several(added):
        return cast(N, np.where(abs(added) > dust, added, 0.0))
    kept: object = added if abs(added) > dust else 0j if isinstance(added, complex) else 0.0
    return cast(N, kept)


def largest(a: float, b: float) -> float:
    return np.maximum(a, b) if _several(a) or _several(b) else max(a, b)


def smallest(a: float, b: float) -> float:
    return np.minimum(a, b) if _several(a) or _several(b) else min(a, b)


def rss(x: float) -> float:
    """Root of the sum of squares."""
    return sqrt(one(np.sum(np.square(x))))
