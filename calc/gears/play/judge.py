# SPDX-License-Identifier: Apache-2.0
"""What is judged on the play of a train, what would just pass, and what was assumed."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from ...sheet.check import Check, check
from ...sheet.units import Metre, Number
from ..inputs import GearsInputs
from .backlash import GUIDE
from .chance import BY_CHANCE
from .meeting import Meeting
from .result import PlayResult
from .temperature import AtState, Expansions

if TYPE_CHECKING:
    from ..result import WheelResult


def checks(gears: GearsInputs, m: Meeting, play: PlayResult, smallest: Sequence[AtState]) -> list[Check]:
    """`smallest`: the states cold, warm and wheels warmer at the smallest backlash."""
    id = f"gears.{m.key}"
    found = _over_temperature(gears, m, smallest)
    if play.backlash_min_runout is not None:
        closest = 2 * math.sqrt(1 - (m.touching / m.closest) ** 2) * math.cos(m.system.base_helix_angle)  # the slope is least there
        found.append(
            check(
                f"{id}.backlash_runout", f"Smallest backlash with runout {m.name}", play.backlash_min_runout, ">=", 0.0, "µm",
                "teeth must not jam where both wheels stand closest", remedy(m, -play.backlash_min_runout, closest),
            )
        )  # fmt: skip
    low = m.mesh.backlash_min
    found.append(
        check(
            f"{id}.backlash_guide", f"Smallest backlash {m.name}, recommended", low, ">=", play.backlash_recommended, "µm", GUIDE,
            "Take as much as is missing off the span of the teeth (gears.wheels.NAME.span_allowance_um): the guide is for industrial "
            "gears, and more backlash turns the last wheel further out of phase.",
            kind="advice",
        )
    )  # fmt: skip
    if play.backlash_99 is not None:
        found.append(
            check(
                f"{id}.backlash_chance", f"Backlash {m.name} that 99 % of the trains keep", play.backlash_99, ">=", 0.0, "µm",
                f"rule of this program: {BY_CHANCE}, of which 99 % turn freely at 20 °C", remedy(m, -play.backlash_99, None), kind="advice",
            )
        )  # fmt: skip
    if play.centre_tolerance_rss is not None and m.inputs.tolerance is not None:
        found.append(
            check(
                f"{id}.stack", f"Parts between the centres {m.name}, root of squares (±)", play.centre_tolerance_rss, "<=",
                m.inputs.tolerance, "µm", "the tolerance of the centre distance must hold what its parts add up to",
                f"Give {m.place}.tolerance_um at least {_up(play.centre_tolerance_rss)}, or smaller fields to the parts.", kind="advice",
            )
        )  # fmt: skip
    if play.backlash_min_worst is not None:
        reach = play.centre_tolerance_worst or 0.0
        found.append(
            check(
                f"{id}.backlash_worst", f"Smallest backlash {m.name}, all parts at their worst", play.backlash_min_worst, ">=", 0.0, "µm",
                f"worst case: the centres ±{reach * 1e6:.4g} µm", remedy(m, -play.backlash_min_worst, None), kind="advice",
            )
        )  # fmt: skip
    return found


def _over_temperature(gears: GearsInputs, m: Meeting, smallest: Sequence[AtState]) -> list[Check]:
    """A limit where the design itself says what is between the centres, else advice."""
    kind = "limit" if gears.housing_material is not None or m.inputs.support_share else "advice"
    cold, warm, warmer = smallest
    T_min, T_H = gears.lowest_temperature, gears.running_temperature
    tight, said = (warm, f"all at {T_H:g} °C") if warm.backlash <= warmer.backlash else (
        warmer, f"housing at {T_H:g} °C, wheels {gears.wheels_warmer:g} K warmer"
    )  # fmt: skip
    also = ", with runout" if m.runouts else ", without runout"
    return [
        check(
            f"gears.{m.key}.backlash_{word}", f"Smallest backlash {m.name}, {word}", at.backlash, ">=", 0.0, "µm",
            f"teeth must not jam at any temperature: {where}{also}", remedy(m, -at.backlash, _slope(m, at), at.wheel_growth), kind=kind,
        )
        for word, at, where in (("cold", cold, f"cold start, all at {T_min:g} °C"), ("warm", tight, said))
    ]  # fmt: skip


def _slope(m: Meeting, at: AtState) -> Number:
    """Backlash per centre distance at 20 °C; it rises with the distance, so that what it asks for at the closest one is enough."""
    return 2 * math.sin(at.pressure_angle) * math.cos(m.system.base_helix_angle) * at.centre_growth


def remedy(m: Meeting, missing: Metre, slope: Number | None, growth: Number = 1.0) -> str:
    instead = " in place of contributors_mm" if m.inputs.contributors else ""
    return freed((m.driver, m.driven), m.mesh.centre_tolerance, f"{m.place}.tolerance_um{instead}", missing, slope, growth)


def freed(
    wheels: "tuple[WheelResult, WheelResult]", tolerance: Metre, place: str, missing: Metre, slope: Number | None, growth: Number = 1.0
) -> str:
    """What would just pass: an allowance of the span acts micrometre for micrometre, the centre distance by `slope` (None: not offered)."""
    if missing <= 0:
        return "It holds; an allowance of the span (gears.wheels.NAME.span_allowance_um) gives more."
    less = math.ceil(missing / growth * 1e6 - 1e-6)
    thick = max(wheels, key=lambda wheel: wheel.allowance[0] if wheel.allowance else 0.0)
    upper, lower = (round(end * 1e6, 6) for end in thick.allowance or (0.0, 0.0))
    new = f"[{upper - less:g}, {lower - less:g}]"  # the field of the allowance stays as wide as it is
    advice = f"Take {less} µm more off the span of the teeth, for example gears.wheels.{thick.name}.span_allowance_um = {new}"
    held = 0.0 if slope is None else tolerance - missing / slope
    if held > 1e-6:
        advice += f"; or hold the centre distance to ±{math.floor(held * 1e6):g} µm ({place})"
    return advice + "."


def _up(length: Metre) -> str:
    return f"{math.ceil(length * 1e6 - 1e-6):g}"


def notes(gears: GearsInputs, known: Sequence[tuple[Meeting, Expansions]], housing: str | None, chance: bool) -> tuple[str, ...]:
    said = []
    if housing is None:
        said.append("Housing material: not given; chosen: it grows as the driver of each mesh.")
    elif gears.housing_material is None:
        said.append(
            f"Housing material: not given; chosen: {housing}, that of the bearings. The cold and warm backlash is then only advice."
        )
    if gears.support_material is not None and not any(m.inputs.support_share for m, _ in known):
        said.append("gears.support_material acts on no mesh: none has a support_share.")
    if chance:
        said.append(
            f"Backlash by chance: {BY_CHANCE}, always the same ones, at 20 °C; allowances, bare tolerances and fields without a kind "
            "even between their limits, a position even in its circle, a fit on the wall of its clearance and a runout in any "
            "direction; all independent."
        )
    if any(m.runouts is None for m, _ in known):
        tight = ", ".join(m.name for m, _ in known if m.runouts is None)
        said.append(f"Runout of the teeth: not given for {tight}: left out of their backlash (gears.wheels.NAME.runout_um).")
    return tuple(said)
