# SPDX-License-Identifier: Apache-2.0
"""What is judged on the play of a train, what would just pass, and what was assumed."""

import math
from collections.abc import Iterator, Sequence
from functools import partial

from ...sheet.check import Check
from ...sheet.functions import cos, sin
from ...sheet.quantity import dotted
from ...sheet.remedy import Change, Remedy, change, remedy
from ...sheet.shim_check import check
from ...sheet.text import EMPTY, Amount, Text
from ...sheet.units import Metre, Number
from ..inputs import GearsInputs, Mesh
from ..result import WheelResult
from ..wheel_inputs import Wheel
from .case import BacklashCase
from .chance import BY_CHANCE
from .formulas import GUIDE, PlayResult
from .temperature import AtState, Expansions


def checks(gears: GearsInputs, m: BacklashCase, play: PlayResult, smallest: Sequence[AtState]) -> Iterator[Check]:
    """`smallest`: the states cold, warm, wheels warmer and warming up at the smallest backlash."""
    id = f"gears.{m.key}"
    yield from _temperature_checks(gears, m, smallest)
    if play.backlash_min_runout is not None:
        name = Text("Smallest backlash with runout {name}", name=m.name)
        source = Text("teeth must not jam where both wheels stand closest")
        # the slope is least where the wheels stand closest
        slope = 2 * math.sqrt(1 - (m.touching / m.closest) ** 2) * math.cos(m.system.base_helix_angle)
        yield _no_jam(m, "runout", name, play.backlash_min_runout, source, slope)
    low = m.mesh.backlash_min
    yield check(
        f"{id}.backlash_guide",
        Text("Smallest backlash {name}, recommended", name=m.name),
        low,
        ">=",
        play.backlash_recommended,
        "µm",
        GUIDE,
        Text("The guide is for industrial gears, and more backlash turns the last wheel further out of phase."),
        remedies=partial(_freed, m, play.backlash_recommended - low, None),
    )
    if play.backlash_99 is not None:
        name = Text("Backlash {name} that 99 % of the trains keep", name=m.name)
        source = Text("rule of this program: {by_chance}, of which 99 % turn freely at 20 °C", by_chance=BY_CHANCE)
        yield _no_jam(m, "chance", name, play.backlash_99, source)
    if play.centre_tolerance_rss is not None and m.inputs.tolerance is not None:
        yield check(
            f"{id}.stack",
            Text("Parts between the centres {name}, root of squares (±)", name=m.name),
            play.centre_tolerance_rss,
            "<=",
            m.inputs.tolerance,
            "µm",
            Text("mathematics: the tolerance of the centre distance must hold what its parts add up to"),
            Text("Smaller fields of the parts help as well."),
            index=m.index,
            remedies=partial(_wider, m, play.centre_tolerance_rss),
        )
    if play.backlash_min_worst is not None:
        name = Text("Smallest backlash {name}, all parts at their worst", name=m.name)
        reach = Amount((play.centre_tolerance_worst or 0.0) * 1000000.0, form=".4g")
        source = Text("geometry, worst case: the centres ±{reach} µm", reach=reach)
        yield _no_jam(m, "worst", name, play.backlash_min_worst, source)


def _no_jam(
    m: BacklashCase,
    word: str,
    name: Text,
    j_bn: Metre,
    source: Text,
    slope: Number | None = None,
    growth: Number = 1.0,
    advice: Text = EMPTY,
    missing: tuple[str, ...] = (),
) -> Check:
    """That a backlash is not below 0; `slope` and `growth` as of `freed`."""
    ways, id = partial(_freed, m, -j_bn, slope, growth), f"gears.{m.key}.backlash_{word}"
    return check(id, name, j_bn, ">=", 0.0, "µm", source, advice, index=m.index, missing=missing, remedies=ways)


def _temperature_checks(gears: GearsInputs, m: BacklashCase, smallest: Sequence[AtState]) -> Iterator[Check]:
    """Not verified where the design does not say itself what is between the centres."""
    missing: tuple[str, ...] = ()
    advice = EMPTY
    if gears.housing_material is None and not m.inputs.support_share:
        missing = (dotted("gears", GearsInputs.housing_material),)
        advice = Text("Taken: the housing of the bearings, else that it grows as the driver.")
    cold, warm, warmer, warming = smallest
    T_min, T_H, more = (
        Amount(T, form="g") for T in (gears.lowest_temperature, gears.running_temperature, gears.wheels_warmer)
    )
    tight, where = warm, Text("all at {t_h} °C", t_h=T_H)
    if warm.backlash > warmer.backlash:
        tight, where = warmer, Text("housing at {t_h} °C, wheels {wheels_warmer} K warmer", t_h=T_H, wheels_warmer=more)
    also = Text(", with runout") if m.runouts else Text(", without runout")
    at_start = Text("cold start, all at {t_min} °C", t_min=T_min)
    still_cold = Text("housing still at {t_min} °C, wheels {wheels_warmer} K warmer", t_min=T_min, wheels_warmer=more)
    for word, label, at, place in (
        ("cold", Text("Smallest backlash {name}, cold", name=m.name), cold, at_start),
        ("warm", Text("Smallest backlash {name}, warm", name=m.name), tight, where),
        ("warming", Text("Smallest backlash {name}, warming up", name=m.name), warming, still_cold),
    ):
        source = Text("geometry, teeth must not jam at any temperature: {where}{also}", where=place, also=also)
        # backlash per centre distance at 20 °C; it rises with the distance: what it asks for at the closest is enough
        slope = 2 * sin(at.pressure_angle) * cos(m.system.base_helix_angle) * at.centre_growth
        yield _no_jam(m, word, label, at.backlash, source, slope, at.wheel_growth, advice, missing)


def freed(
    wheels: tuple[WheelResult, WheelResult],
    mesh: Mesh,
    index: int,
    tolerance: Metre,
    missing: Metre,
    slope: Number | None,
    growth: Number = 1.0,
) -> tuple[Remedy, ...]:
    """What would just pass: an allowance of the span acts micrometre for micrometre, the centre distance by `slope`
    (None: not offered).

    Where the parts between the centres are known, no smaller tolerance is offered: it hangs on them.
    """
    if not missing > 0:
        return ()
    less = math.ceil(missing / growth * 1e6 - 1e-6)
    thick = max(wheels, key=lambda wheel: wheel.allowance[0] if wheel.allowance else 0.0)
    # the field of the allowance stays as wide as it is
    ends = [round(end * 1e6 - less, 6) for end in thick.allowance or (0.0, 0.0)]
    off = remedy(
        change(Wheel, dotted("gears", GearsInputs.wheels, thick.name, Wheel.span_allowance), ends, place=thick.name),
        effect=Text("{less} µm more off the span of its teeth", less=less),
    )
    held = 0.0 if slope is None else tolerance - missing / slope
    return (off, remedy(*_tolerance(mesh, index, math.floor(held * 1e6)))) if held > 1e-6 and not mesh.stack else (off,)


def _freed(m: BacklashCase, missing: Metre, slope: Number | None, growth: Number = 1.0) -> tuple[Remedy, ...]:
    return freed((m.driver, m.driven), m.inputs, m.index, m.mesh.centre_tolerance, missing, slope, growth)


def _wider(m: BacklashCase, reach: Metre) -> tuple[Remedy, ...]:
    return (remedy(*_tolerance(m.inputs, m.index, math.ceil(reach * 1e6 - 1e-6), ">=")),)


def _tolerance(mesh: Mesh, index: int, tolerance: float, bound: str = "") -> list[Change]:
    """Another tolerance of the centre distance, in µm; it takes the place of contributors that are summed."""
    place, here = mesh.title, dotted("gears", GearsInputs.meshes, index)
    instead = [change(Mesh, dotted(here, Mesh.contributors), None, place=place)] if mesh.contributors else []
    return [change(Mesh, dotted(here, Mesh.tolerance), tolerance, place=place, bound=bound), *instead]


# --- what is assumed where the play does not follow from what is given


def notes(
    gears: GearsInputs, known: Sequence[tuple[BacklashCase, Expansions]], housing: str | None, chance: bool
) -> Iterator[Text]:
    if housing is None:
        yield Text("Housing material: not given; chosen: it grows as the driver of each mesh.")
    elif gears.housing_material is None:
        yield Text(
            "Housing material: not given; chosen: {housing}, that of the bearings. The cold and warm backlash is then "
            "not verified.",
            housing=housing,
        )
    if gears.support_material is not None and not any(m.inputs.support_share for m, _ in known):
        yield Text("gears.support_material acts on no mesh: none has a support_share.")
    if chance:
        yield Text(
            "Backlash by chance: {by_chance}, always the same ones, at 20 °C; allowances, bare tolerances and fields "
            "without a kind even between their limits, a position even in its circle, a fit on the wall of its "
            "clearance and a runout in any direction; all independent.",
            by_chance=BY_CHANCE,
        )
    if tight := [m.name for m, _ in known if m.runouts is None]:
        yield Text(
            "Runout of the teeth: not given for {tight}: left out of their backlash (gears.wheels.NAME.runout_um).",
            tight=", ".join(tight),
        )
