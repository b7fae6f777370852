# SPDX-License-Identifier: Apache-2.0
"""The counter-shaft judged: what it leaves, how it bends, whether it fits; and what was assumed."""

import math

from ..sheet.check import Check, check
from ..sheet.functions import argument
from ..sheet.units import Metre
from .inputs import CountershaftInputs
from .result import CountershaftResult
from .task import Task

LEFT_OVER = 0.05  # share of the required couple that a good shaft may leave
SLOPE = 0.25e-3  # rad
THREADED = 0.2e-3  # m: clearance for threading in, where none is given in mode size
WORDS = {1: "First", 2: "Second"}


def checks(
    shaft: CountershaftInputs, todo: Task, found: CountershaftResult, journals: tuple[tuple[Metre, Metre], ...]
) -> tuple[Check, ...]:
    """All checks of the step."""
    return (*_residuals(todo, found), *_slopes(found), *_envelope(shaft, found, journals), *_supports(found), *_outline(shaft, todo, found))


def _residuals(todo: Task, found: CountershaftResult) -> tuple[Check, ...]:
    first = todo.order == 1
    couple = found.residual_order_1_couple if first else found.residual_order_2_couple
    force = found.residual_order_1_force if first else found.residual_order_2_force
    kind = "limit" if first else "advice"  # shafts at twice crank speed are for comfort, and often take a part only
    carries_force = abs(todo.F) > LEFT_OVER * todo.one_force
    alike = "Balance the masses against each other (mass times radius), so that only a couple remains."
    return (
        check(
            "countershaft.residual", f"{WORDS[todo.order]}-order couple left over", couple or 0.0, "<=",
            LEFT_OVER * (todo.couple or todo.one_couple), "N·m",
            "rule of this program: 5 % of the couple to be balanced, or of m·r·ω²·a where there is none",
            f"Aim at {todo.couple:.1f} N·m at {_direction(todo.C)}: the couple grows with mass, radius and arm of the eccentric masses.",
            kind=kind,
        ),
        check(
            "countershaft.residual_force", f"{WORDS[todo.order]}-order force left over", force or 0.0, "<=", LEFT_OVER * todo.one_force,
            "N", "rule of this program: 5 % of m·r·ω² of one cylinder",
            f"Aim at {abs(todo.F):.0f} N at {_direction(todo.F)}: the force grows with mass and radius." if carries_force else alike,
            kind=kind,
        ),
    )  # fmt: skip


def _direction(engine: complex) -> str:
    """Opposite to the engine's vector, in degrees."""
    return f"{math.degrees(argument(-engine)):.1f}°"


def _slopes(found: CountershaftResult) -> tuple[Check, ...]:
    return tuple(
        check(
            f"countershaft.slope_{place}", f"Slope of the {place} journal", slope, "<=", SLOPE, "mrad",
            "Finotti 2013, ch. 6: target of the engine's maker", "A stiffer shaft between its bearings: larger core, shorter span.",
        )
        for place, slope in (("front", found.slope_front), ("rear", found.slope_rear)) if slope is not None
    )  # fmt: skip


def _envelope(shaft: CountershaftInputs, found: CountershaftResult, journals: tuple[tuple[Metre, Metre], ...]) -> tuple[Check, ...]:
    """Whether the sectors can be threaded in, and end before the journals begin; also where they are too long to be drawn."""
    if not journals:
        return ()
    radii = [p.outer_radius for p in found.outline.pieces if p.what == "sector"] if found.outline is not None else []
    R = max(radii, default=shaft.outer_radius)
    made = []
    clearance = shaft.radial_clearance if shaft.radial_clearance is not None else THREADED if shaft.mode == "size" else None
    if clearance is not None and R is not None:
        room = max(d for d, _ in journals) / 2 - R
        made.append(
            check(
                "countershaft.envelope", "Room around the sectors in the largest seat", round(room, 9), ">=", clearance, "mm",
                "Finotti 2013, 4.1: the shaft is threaded in through its seat",
                "A smaller outer radius (and longer or wider sectors), or a larger journal.",
            )
        )  # fmt: skip
    if shaft.mode == "size" and shaft.half_length is not None:
        faces = [abs(z) - l / 2 for z, (_, l) in zip(shaft.bearing_positions, journals)]
        made.append(
            check(
                "countershaft.envelope_length", "Room between the sectors and the nearest journal",
                round(min(faces) - shaft.half_length, 9), ">=", 0.0, "mm", "the sectors end where the journals begin",
                "A smaller half_length_mm, or bearings further apart.",
            )
        )  # fmt: skip
    return tuple(made)


def _supports(found: CountershaftResult) -> tuple[Check, ...]:
    """Specific load and heat index of journals that are not part of [bearings]: a screening, without their film."""
    made = []
    for name, support in found.support.items():
        for what, label, value, limit, unit in (
            ("specific_load", "Specific load", support.specific_load, 5e6, "MPa"),
            ("heat_index", "Heat index", support.heat_index, 500e3 * 1000 / 60, "N·rpm/mm"),
        ):
            if value is not None:
                made.append(
                    check(
                        f"countershaft.support.{name}.{what}", f"{label}, support {name}", value, "<=", limit, unit,
                        "Finotti 2013, 3.2.3.1: the most that is accepted, with forced oil and cooling",
                        "A longer journal, or a larger one.", kind="advice",
                    )
                )  # fmt: skip
    return tuple(made)


def _outline(shaft: CountershaftInputs, todo: Task, found: CountershaftResult) -> tuple[Check, ...]:
    """Given sections against given masses: both must describe one shaft."""
    if found.outline_couple is None:
        return ()
    return (
        check(
            "countershaft.outline", "Couple of the outline beside that of the eccentric masses", found.outline_couple, "in",
            ((1 - LEFT_OVER) * found.couple, (1 + LEFT_OVER) * found.couple), "N·m",
            "rule of this program: within 5 %, else one of them is wrong",
            "Look at the sections' radii, half-angles and places: the bending is that of the outline.", kind="advice",
        ),
    )  # fmt: skip


def notes(shaft: CountershaftInputs, found: CountershaftResult) -> tuple[str, ...]:
    return (
        "The middle of the shaft is taken as the middle of the engine; for a pure couple its place does not matter.",
        "The reactions turn with the shaft; its weight and the gear force stand still and are given beside them.",
    )
