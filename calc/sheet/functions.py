# SPDX-License-Identifier: Apache-2.0
"""The functions that formulas may use: those of `math` and numpy by one name, the zero of a function, erf.

A float goes to `math`, anything else to numpy.  They are typed for numbers, as the formulas are that call them; those
that formulas of arrays call are typed for both."""

import math
from collections.abc import Callable
from typing import Any, Protocol, overload

import numpy as np

from .arrays import Array, ComplexArray, Num
from .value import LinkedFloat

pi = math.pi


class _Function(Protocol):
    """Of a number a number, of an array an array."""

    @overload
    def __call__(self, x: float, /) -> float: ...
    @overload
    def __call__(self, x: Array, /) -> Array: ...


def _both(scalar: Callable[[float], float], vector: Any) -> _Function:
    def function(x: Any) -> Any:
        # no numpy number: it has other last digits
        return scalar(x) if type(x) is float or type(x) is LinkedFloat else vector(x)

    function.__name__ = scalar.__name__
    return function


def _several(x: object) -> bool:
    """Whether this is an array."""
    return hasattr(x, "ndim") and not isinstance(x, (float, complex))


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


def _floor(x: float) -> float:
    return float(math.floor(x))


floor = _both(_floor, np.floor)


def inv(angle: float) -> float:
    """The involute function inv α = tan α − α."""
    return tan(angle) - angle


@overload
def cis(angle: float) -> complex: ...
@overload
def cis(angle: Array) -> ComplexArray: ...
def cis(angle: Any) -> Any:
    """The unit phasor e^{iα}."""
    plain = type(angle) in (float, LinkedFloat)
    return complex(math.cos(angle), math.sin(angle)) if plain else np.exp(1j * angle)


def conj(z: complex) -> complex:
    return z.conjugate()


@overload
def modulus(z: complex) -> float: ...
@overload
def modulus(z: Array) -> Array: ...
def modulus(z: Any) -> Any:
    return abs(z)


def real(z: complex) -> float:
    """The part up."""
    return z.real


def imag(z: complex) -> float:
    """The part 90° further in the sense of crank rotation."""
    return z.imag


def argument(z: complex) -> float:
    """The angle of a phasor from "up", in the sense of crank rotation [rad]; 0 for a phasor of zero length.

    Parts below 1e-12 of the length are dust of the last digits: 180° and not −180°, 0° and not 4e-15°.
    """
    dust = 1e-12 * abs(z)
    if _several(z):
        angles = np.arctan2(np.where(abs(z.imag) > dust, z.imag, 0.0), np.where(abs(z.real) > dust, z.real, 0.0))
        return single_or_many(angles)
    return math.atan2(z.imag if abs(z.imag) > dust else 0.0, z.real if abs(z.real) > dust else 0.0)


def power(x: float, y: float) -> float:
    """x^y: Python's `x**y` may be complex for all that a type checker knows."""
    raised: float = x**y
    return raised


@overload
def total(x: float | Array) -> float: ...
@overload
def total(x: complex | ComplexArray) -> complex: ...
def total(x: Any) -> Any:
    """Sum over all elements (masses, points of contact, …)."""
    return np.sum(x).item()


def single_or_many(x: Array) -> float:
    """An array without axes as the number that it is; one of many points stays, as in every formula."""
    number: float = x if x.ndim else x.item()  # type: ignore[assignment]
    return number


def along(x: Num) -> float:
    """Sum over the last axis, the positions of a path: a float of one operating point, an array of many."""
    return single_or_many(np.asarray(np.sum(x, -1)))


@overload
def resultant(x: float | Array) -> float: ...
@overload
def resultant(x: complex | ComplexArray) -> complex: ...
def resultant(x: Any) -> Any:
    """Sum over the last axis: the cylinders of one engine, or of each of many.

    Vectors that cancel in a direction give 0 there, not the dust of the last digits.
    """
    x = x if _several(x) else np.asarray(x)
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


@overload
def joined(a: float, b: float) -> float: ...
@overload
def joined(a: complex, b: complex) -> complex: ...
def joined(a: Any, b: Any) -> Any:
    """Sum of two numbers or vectors; where they cancel, 0 and not the dust of the last digits."""
    added = a + b
    dust = 1e-12 * (abs(a) + abs(b))
    if _several(added):
        return np.where(abs(added) > dust, added, 0.0)
    return added if abs(added) > dust else 0j if isinstance(added, complex) else 0.0


def largest(a: float, b: float) -> float:
    return np.maximum(a, b) if _several(a) or _several(b) else max(a, b)


def smallest(a: float, b: float) -> float:
    return np.minimum(a, b) if _several(a) or _several(b) else min(a, b)


def rss(x: Num) -> float:
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


@overload
def erf(x: float) -> float: ...
@overload
def erf(x: Array) -> Array: ...
def erf(x: Any) -> Any:
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
    return np.copysign(np.where(np.isnan(size), size, between), x)
