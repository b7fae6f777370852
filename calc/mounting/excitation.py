# SPDX-License-Identifier: Apache-2.0
"""What drives the body: forces and moments of every order about the crank's origin, as real phasors of x, y and z.

a(t) = Re{â·e^{inωt}}, t = 0 at the firing TDC of cylinder 1; n in halves for a four-stroke engine.  A vector of the
imbalance step that turns backward enters conjugated: without that the vertical couple of a three-cylinder would lie
flat."""

from typing import Annotated

import numpy as np

from ..engine.gas_torque import index
from ..imbalance.orders import Order
from ..sheet.arrays import Array, ComplexArray
from ..sheet.formula import formula
from ..sheet.functions import cis, conj, modulus
from ..sheet.units import (
    NewtonMetre,
    Number,
    PhasorNewton,
    PhasorNewtonMetre,
    PhasorNewtonMetres,
    PhasorNewtons,
    Radian,
)
from ..sheet.value import based_on

REAL = "kinematics: a vector that turns forward and one that turns backward, as phasors of their components"


# --- vectors that turn


@formula("X̂", REAL, names={"p": "F⁺", "m": "F⁻"})
def vertical(p: PhasorNewton, m: PhasorNewton) -> PhasorNewton:
    """Of the vectors that turn forward and backward, real up."""
    return p + conj(m)


@formula("Ŷ", REAL, names={"p": "F⁺", "m": "F⁻"})
def horizontal(p: PhasorNewton, m: PhasorNewton) -> PhasorNewton:
    return -1j * (p - conj(m))


@formula(
    "M̂_x",
    "statics: a force to the side, towards the flywheel, turns the engine against its vertical axis",
    names={"p": "C⁺", "m": "C⁻"},
)
def moment_about_x(p: PhasorNewtonMetre, m: PhasorNewtonMetre) -> PhasorNewtonMetre:
    return 1j * (p - conj(m))


@formula(
    "M̂_y",
    "statics: a force upward, towards the flywheel, turns the engine about its lateral axis",
    names={"p": "C⁺", "m": "C⁻"},
)
def moment_about_y(p: PhasorNewtonMetre, m: PhasorNewtonMetre) -> PhasorNewtonMetre:
    return p + conj(m)


# --- the counter-shaft


@formula(
    "q_S,1",
    "mathematics: a couple against what is left of it by a shaft whose couple is too large by s and late by δ",
    names={"s": "s_C", "delta": "δ_S"},
)
def first_order_ratio(s: Number, delta: Radian) -> Number:
    return 1 / modulus(1 - (1 + s) * cis(delta))


@formula("q_S,1", "mathematics: a couple against what the shaft as designed leaves of it")
def couple_ratio(C: PhasorNewtonMetre, C_left: PhasorNewtonMetre) -> Number:
    return modulus(C) / modulus(C_left)


@formula("T_n", "mathematics: amplitude of one order of the torque on the crank")
def amplitude(t_n: PhasorNewtonMetre) -> NewtonMetre:
    return modulus(t_n)


# --- about the centre of gravity


@formula("M̂_G", "statics: the same force and moment about the centre of gravity", shows="M̂ − r_G × F̂")
def about_gravity(
    F: PhasorNewtons, M: PhasorNewtonMetres, r_G: Annotated[tuple[float, ...], "m"]
) -> PhasorNewtonMetres:
    moment: ComplexArray = M - np.cross(np.asarray(r_G), F)
    return moment


def strength(F: ComplexArray, M: ComplexArray, rho: float) -> Array:
    """How strong each order is, a force taken at the radius of gyration: |M| + ρ·|F|."""
    sizes: Array = np.linalg.norm(M, axis=-1) + rho * np.linalg.norm(F, axis=-1)
    return sizes


# --- from the vectors of the imbalance step, order by order, to the wrench about the crank's origin

Moving = tuple[ComplexArray, ComplexArray, ComplexArray, ComplexArray]  # F⁺ F⁻ C⁺ C⁻ of every order


def moving(n: Array, orders: dict[str, Order], *, bare: bool) -> Moving:
    """F⁺ F⁻ C⁺ C⁻ of every order; `bare`: with no share of the reciprocating masses on the crank."""
    placed = np.zeros((4, n.size), dtype=complex)
    sources = []
    for word, order in orders.items():
        vectors = order.unbalanced if bare else order.vectors
        placed[:, index(n, float(word.removeprefix("order_")))] = vectors
        sources.append(vectors)
    return tuple(based_on(part, *(four[i] for four in sources)) for i, part in enumerate(placed))  # type: ignore[return-value]


def turning_wrench(moving: Moving, roll: ComplexArray) -> ComplexArray:
    """Forces and moments about the origin from the vectors that turn (orders, 6)."""
    F_f, F_b, C_f, C_b = (part for part in moving)
    X, Y = vertical(p=F_f, m=F_b), horizontal(p=F_f, m=F_b)
    M_x, M_y = moment_about_x(p=C_f, m=C_b), moment_about_y(p=C_f, m=C_b)
    zero = np.zeros(roll.size, dtype=complex)
    return based_on(np.stack([X, Y, zero, M_x, M_y, roll], -1), X, Y, M_x, M_y, roll)
