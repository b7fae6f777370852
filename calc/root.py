# SPDX-License-Identifier: Apache-2.0
"""The zero of a function in a bracket.  Ours because scipy.optimize costs half a second of import."""

from collections.abc import Callable


def root(function: Callable[[float], float], a: float, b: float, *, tolerance: float = 1e-12) -> float:
    """The zero of `function` between two points of opposite sign, by Brent's method (Brent 1973, ch. 4).

    A jump through zero counts as a zero.  `tolerance` is relative to the larger end of the bracket.  Raises ValueError where the
    signs do not differ.
    """
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
