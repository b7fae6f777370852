# SPDX-License-Identifier: Apache-2.0
"""From the vectors of the imbalance step, order by order, to the wrench of each order about the crank's origin."""

import numpy as np

from ..imbalance.orders import Order
from ..sheet.arrays import Array, ComplexArray, each, phasors
from ..sheet.value import based_on
from . import excitation as x

Moving = tuple[ComplexArray, ComplexArray, ComplexArray, ComplexArray]  # F⁺ F⁻ C⁺ C⁻ of every order


def index(n: Array, order: float) -> int:
    return int(np.argmin(np.abs(n - order)))


def integer(harmonics: tuple[complex, ...], n: Array) -> ComplexArray:
    """Harmonics of the turn at their places among the orders of the cycle."""
    found = np.zeros(n.size, dtype=complex)
    for order, one in enumerate(harmonics, 1):
        found[index(n, order)] = one
    return found


def moving(n: Array, orders: dict[str, Order], *, bare: bool) -> Moving:
    """F⁺ F⁻ C⁺ C⁻ of every order; `bare`: with no share of the reciprocating masses on the crank."""
    found = np.zeros((4, n.size), dtype=complex)
    sources = []
    for word, one in orders.items():
        vectors = one.unbalanced if bare else one.vectors
        found[:, index(n, float(word.removeprefix("order_")))] = vectors
        sources.append(vectors)
    return tuple(based_on(part, *(four[i] for four in sources)) for i, part in enumerate(found))  # type: ignore[return-value]


def turning_wrench(moving: Moving, roll: ComplexArray) -> ComplexArray:
    """Forces and moments about the origin from the vectors that turn (orders, 6)."""
    F_f, F_b, C_f, C_b = (each(part) for part in moving)
    X, Y = x.vertical(p=F_f, m=F_b), x.horizontal(p=F_f, m=F_b)
    M_x, M_y = x.moment_about_x(p=C_f, m=C_b), x.moment_about_y(p=C_f, m=C_b)
    zero = np.zeros(roll.size, dtype=complex)
    return based_on(np.stack([phasors(X), phasors(Y), zero, phasors(M_x), phasors(M_y), roll], -1), X, Y, M_x, M_y, roll)
