# SPDX-License-Identifier: Apache-2.0
"""The counter-shaft judged: what it leaves, how it bends, whether it fits; and what was assumed."""

import math

from ..sheet.check import Check, check
from ..sheet.functions import argument
from ..sheet.units import Metre
from .bending.shaft import SLOPE_LIMIT
from .inputs import CountershaftInputs
from .result import CountershaftResult
from .standing import Gear
from .task import LEFT_OVER, WORDS, Task


def checks(
    shaft: CountershaftInputs, todo: Task, found: CountershaftResult, journals: tuple[tuple[Metre, Metre], ...], gear: Gear | None
) -> tuple[Check, ...]:
    """All checks of the step but those of its making."""
    fits = _envelope(shaft, found, journals, gear)
    return (*_residuals(shaft, todo, found), *_slopes(found), *fits, *_supports(found), *_outline(todo, found))


def _residuals(shaft: CountershaftInputs, todo: Task, found: CountershaftResult) -> tuple[Check, ...]:
    first = todo.order == 1
    couple = (found.residual_order_1_couple if first else found.residual_order_2_couple) or 0.0
    force = (found.residual_order_1_force if first else found.residual_order_2_force) or 0.0
    alike = "Balance the masses against each other (mass times radius), so that only a couple remains."
    each = "each of both shafts " if shaft.pair == "yes" else ""
    aim_couple = (
        f"Aim at {todo.couple:.1f} N·m at {_direction(todo.C)}: the couple of {each or 'the shaft '}grows with mass, radius and arm."
    )
    aim_force = f"Aim at {abs(todo.F):.0f} N at {_direction(todo.F)}: the force of {each or 'the shaft '}grows with mass and radius."

    def one(key: str, word: str, left: float, limit: float, before: float, unit: str, source: str, advice: str) -> Check:
        # shafts at twice crank speed are for comfort and often take a part only; they fail where they make it worse
        kind = "limit" if first or left > max(before, limit) else "advice"
        return check(
            f"countershaft.{key}", f"{WORDS[todo.order]}-order {word} left over", left, "<=", limit, unit, source, advice, kind=kind
        )

    return (
        one(
            "residual", "couple", couple, todo.may_leave, abs(todo.C) + abs(todo.C_against), "N·m",
            "rule of this program: 5 % of the couple to be balanced, or of m·r·ω²·a where there is none", aim_couple,
        ),
        one(
            "residual_force", "force", force, LEFT_OVER * todo.one_force, abs(todo.F) + abs(todo.F_against), "N",
            "rule of this program: 5 % of m·r·ω² of one cylinder", aim_force if abs(todo.F) > LEFT_OVER * todo.one_force else alike,
        ),
    )  # fmt: skip


def _direction(engine: complex) -> str:
    """Opposite to the engine's vector, in degrees."""
    return f"{math.degrees(argument(-engine)):.1f}°"


def _slopes(found: CountershaftResult) -> tuple[Check, ...]:
    return tuple(
        check(
            f"countershaft.slope_{place}", f"Slope of the {place} journal", slope, "<=", SLOPE_LIMIT, "mrad",
            "Finotti 2013, ch. 6: target of the engine's maker",
            "A stiffer shaft between its bearings: larger core (core_radius_mm), shorter span (bearing_positions_mm).",
        )
        for place, slope in (("front", found.slope_front), ("rear", found.slope_rear)) if slope is not None
    )  # fmt: skip


def _envelope(
    shaft: CountershaftInputs, found: CountershaftResult, journals: tuple[tuple[Metre, Metre], ...], gear: Gear | None
) -> tuple[Check, ...]:
    """Whether sectors and gear can be threaded in, and the sectors end before the journals begin; also where they can not be drawn."""
    if not journals:
        return ()
    seats = shaft.bearing_positions
    parts = [p for p in found.outline.pieces if p.what in ("sector", "full")] if found.outline is not None else []
    radii = [p.outer_radius for p in parts if not any(p.start < z < p.end for z in seats)]  # those at a bearing are journals
    R = max(radii, default=shaft.outer_radius)
    made = []
    clearance = shaft.radial_clearance if shaft.radial_clearance is not None else 0.0 if shaft.mode == "size" else None
    if clearance is not None and R is not None:
        room = max(d for d, _ in journals) / 2 - R
        made.append(
            check(
                "countershaft.envelope", "Room around the sectors in the largest seat", round(room, 9), ">=", clearance, "mm",
                "Finotti 2013, 4.1: the shaft is threaded in through its seat",
                "A smaller outer radius (and longer or wider sectors), or a larger journal.",
            )
        )  # fmt: skip
    if clearance is not None and gear is not None:
        made.append(
            check(
                "countershaft.gear_seat", "Room around the gear's tip in the front seat",
                round((journals[0][0] - gear.tip_diameter) / 2, 9), ">", 0.0, "mm",
                "Finotti 2013, 4.1: the gear goes through the front seat with the shaft",
                "A larger front journal, fewer teeth or a smaller module.", kind="advice",
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


def _outline(todo: Task, found: CountershaftResult) -> tuple[Check, ...]:
    """Given sections against given masses: both must describe one shaft."""
    if found.outline_couple_deviation is None or found.outline_force_deviation is None:
        return ()
    source = "rule of this program: within 5 %, else masses and sections are not of one shaft"
    advice = "Look at radii, half-angles, angles and places of the sections: the bending is that of the outline."
    couple, force = LEFT_OVER * max(found.couple, todo.may_leave), LEFT_OVER * max(found.force, todo.one_force)
    return (
        check(
            "countershaft.outline", "Couple of the given sections, off that of the masses", found.outline_couple_deviation, "<=", couple,
            "N·m", source, advice,
        ),
        check(
            "countershaft.outline_force", "Force of the given sections, off that of the masses", found.outline_force_deviation, "<=", force,
            "N", source, advice,
        ),
    )  # fmt: skip


def notes(shaft: CountershaftInputs, journals: tuple[tuple[Metre, Metre], ...]) -> tuple[str, ...]:
    said = [
        "The middle of the shaft is taken as the middle of the engine; for a pure couple its place does not matter.",
        "The reactions turn with the shaft. Its weight and the gear force stand still: on two bearings they are given beside, where known.",
    ]
    if shaft.mode == "given" and shaft.radial_clearance is None and journals:
        said.append("Whether the shaft can be threaded through its seats is not judged: give radial_clearance_mm where it has to be.")
    return tuple(said)
