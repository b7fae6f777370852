# SPDX-License-Identifier: Apache-2.0
"""The counter-shaft judged: what it leaves, how it bends, whether it fits; and what was assumed."""

import math

from ..imbalance.solve import ImbalanceResult
from ..sheet.check import Check, check
from ..sheet.units import Metre
from .inputs import CountershaftInputs
from .result import CountershaftResult
from .task import Task

LEFT_OVER = 0.05  # share of the required couple that a good shaft may leave
SLOPE = 0.25e-3  # rad
WORDS = {1: "First", 2: "Second"}


def checks(
    shaft: CountershaftInputs, todo: Task, imbalance: ImbalanceResult, found: CountershaftResult, journals: tuple[tuple[Metre, Metre], ...]
) -> tuple[Check, ...]:
    """All checks of the step."""
    return (*_residuals(todo, imbalance, found), *_slopes(found))


def _residuals(todo: Task, imbalance: ImbalanceResult, found: CountershaftResult) -> tuple[Check, ...]:
    couple = found.residual_order_1_couple if todo.order == 1 else found.residual_order_2_couple
    force = found.residual_order_1_force if todo.order == 1 else found.residual_order_2_force
    needed = todo.couple
    aim = math.degrees(math.atan2(-todo.C.imag, -todo.C.real))
    return (
        check(
            "countershaft.residual", f"{WORDS[todo.order]}-order couple left over", couple or 0.0, "<=",
            LEFT_OVER * (needed or todo.one_couple), "N·m",
            "rule of this program: 5 % of the couple to be balanced, or of m·r·ω²·a where there is none",
            f"Aim at {needed:.1f} N·m at {aim:.1f}°: the couple grows with mass, radius and arm of the eccentric masses.",
        ),
        check(
            "countershaft.residual_force", f"{WORDS[todo.order]}-order force left over", force or 0.0, "<=", LEFT_OVER * todo.one_force,
            "N", "rule of this program: 5 % of m·r·ω² of one cylinder",
            "Balance the masses against each other (mass times radius), so that only a couple remains.",
        ),
    )  # fmt: skip


def _slopes(found: CountershaftResult) -> tuple[Check, ...]:
    return tuple(
        check(
            f"countershaft.slope_{place}", f"Slope of the {place} journal", slope, "<=", SLOPE, "mrad",
            "Finotti 2013, ch. 6: target of the engine's maker", "A stiffer shaft between its bearings: larger core, shorter span.",
        )
        for place, slope in (("front", found.slope_front), ("rear", found.slope_rear)) if slope is not None
    )  # fmt: skip


def notes(shaft: CountershaftInputs, found: CountershaftResult) -> tuple[str, ...]:
    return (
        "The middle of the shaft is taken as the middle of the engine; for a pure couple its place does not matter.",
        "The reactions turn with the shaft; its weight and the gear force stand still and are given beside them.",
    )
