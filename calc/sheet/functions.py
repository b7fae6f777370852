# SPDX-License-Identifier: Apache-2.0
"""The functions that formulas may use: those of `math` and numpy by one name, the zero of a function, erf.

A float goes to `math`, anything else to numpy.  They are typed float → float so that formulas stay readable to the type
checker; arrays enter by the same door."""

import math
from collections.abc import Callable
from typing import TypeVar, cast

import numpy as np

from .arrays import ComplexArray, phasors
from .value import LinkedFloat

pi = math.pi
N = TypeVar("N", float, complex)


def _several(x: object) -> bool:
    """Whether this is an array."""
    return hasattr(x, "ndim") and not isinstance(x, (float, complex))


def _both(scalar: Callable[[float], float], vector: Callable[[float], float]) -> Callable[[float], float]:
    def function(x: float) -> float:
        # no numpy number: it has other last digits
        return scalar(x) if type(x) is float or type(x) is LinkedFloat else vector(x)

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
        return cast(
            float, np.arctan2(np.where(abs(z.imag) > dust, z.imag, 0.0), np.where(abs(z.real) > dust, z.real, 0.0))
        )
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
    if x.ndim > 1:
        total = np.sum(x, -1)
        if not np.iscomplexobj(total):
            return np.where(np.abs(total) > dust, total, 0.0)
        total.real[np.abs(total.real) <= dust] = 0.0
        total.imag[np.abs(total.imag) <= dust] = 0.0
        return total
    scalar = np.sum(x).item()
    if isinstance(scalar, complex):
        return complex(scalar.real if abs(scalar.real) > dust else 0.0, scalar.imag if abs(scalar.imag) > dust else 0.0)
    return scalar if abs(scalar) > dust else abs(0.0 * scalar)  # NaN stays NaN


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
    return math.sqrt(np.sum(np.square(x)))


# --- the zero of a function in a bracket
# Ours because scipy.optimize costs half a second of import.


def root(function: Callable[[float], float], a: float, b: float, *, tolerance: float = 1e-12) -> float:
    """The zero of `function` between two points of opposite sign, by Brent's method (Brent 1973, ch. 4).

    A jump through zero counts as a zero.  `tolerance` is relative to the larger end of the bracket.  Raises ValueError
    where the signs do not differ."""
    f_a, f_b = function(a), function(b)
    if f_a * f_b > 0 or f_a != f_a or f_b != f_b:
        raise ValueError(f"no change of sign between {a:g} and {b:g}")
    close = tolerance * max(abs(a), abs(b))
    c, f_c = a, f_a
    step = before = b - a
    while True:
        if abs(f_c) < abs(f_b):
            a, b, c = b, c, b
            f_a, f_b, f_c = f_b, f_c, f_b
        middle = (c - b) / 2
        if f_b == 0 or abs(middle) <= close:
            return b
        if abs(before) < close or abs(f_a) <= abs(f_b):
            step = before = middle  # bisection
        else:
            s = f_b / f_a
            if a == c:  # secant
                p, q = 2 * middle * s, 1 - s
            else:  # inverse quadratic interpolation
                q, r = f_a / f_c, f_b / f_c
                p = s * (2 * middle * q * (q - r) - (b - a) * (r - 1))
                q = (q - 1) * (r - 1) * (s - 1)
            p, q = (p, -q) if p > 0 else (-p, q)
            if 2 * p < min(3 * middle * q - abs(close * q), abs(before * q)):
                before, step = step, p / q
            else:
                step = before = middle
        a, f_a = b, f_b
        b += step if abs(step) > close else (close if middle > 0 else -close)
        f_b = function(b)
        if f_b * f_c > 0:
            c, f_c = a, f_a
            step = before = b - a


# --- the error function for arrays, without scipy
# math.erf on a grid, with Hermite interpolation between; good to 6e-14.

STEPS = 1024  # per unit
LAST = 6  # erf(6) is 1 to the last digit

_GRID = np.arange(LAST * STEPS + 2) / STEPS
_VALUE = np.array([math.erf(x) for x in _GRID])
_SLOPE = 2 / math.sqrt(math.pi) * np.exp(-(_GRID**2)) / STEPS  # per step


def erf(x: float) -> float:
    """erf x; a float by `math`, an array by interpolation.  NaN stays NaN."""
    if type(x) in (float, LinkedFloat):
        return math.erf(x)
    size = np.abs(np.asarray(x, dtype=np.float64))
    place = np.fmin(size, LAST) * STEPS
    k = place.astype(np.intp)
    t = place - k
    left, right = _VALUE[k], _VALUE[k + 1]
    rise = right - left
    between = left + t * (
        _SLOPE[k] + t * (3 * rise - 2 * _SLOPE[k] - _SLOPE[k + 1] + t * (_SLOPE[k] + _SLOPE[k + 1] - 2 * rise))
    )
    return np.copysign(np.where(np.isnan(size), size, between), x)  # type: ignore[return-value]
