# SPDX-License-Identifier: Apache-2.0
"""The figures of this step: what is left over a turn, and over the speed range."""

import numpy as np

from ..imbalance.pictures import DRAWN
from ..sheet.step import Curve, Series
from .result import CountershaftResult
from .task import Task


def pictures(todo: Task, found: CountershaftResult) -> tuple[Curve, ...]:
    """All figures of the step."""
    parts = (
        ("couple", "N·m", todo.C, todo.C_against, found.couple_vector, todo.one_couple),
        ("force", "N", todo.F, todo.F_against, found.force_vector, todo.one_force),
    )
    return tuple(
        _residual(todo.order, word, unit, like, against, supplied)
        for word, unit, like, against, supplied, one in parts
        if max(abs(like), abs(against), abs(supplied)) > DRAWN * one
    )


def _residual(order: int, word: str, unit: str, like: complex, against: complex, supplied: complex) -> Curve:
    """What is left of the shaft's order, as the path over a turn, before and after the shaft."""
    theta = np.radians(np.arange(0, 361, 3.0))
    same, other = np.exp(-1j * theta), np.exp(1j * theta)
    alone = against * other + like * same
    after = against * other + (like + supplied) * same
    title = f"{'First' if order == 1 else 'Second'}-order {word} before and after the counter-shaft"
    return Curve(
        "residual" if word == "couple" else "residual_force", title, f"horizontal, {unit}", f"vertical, {unit}",
        (Series("before", alone.imag, alone.real), Series("after", after.imag, after.real)), equal=True,
    )  # fmt: skip
