# SPDX-License-Identifier: Apache-2.0
"""What is judged on the play of a train, what would just pass, and what was assumed."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial

from ...sheet.check import THIN_MARGIN, Check, CheckRule, End, Missing
from ...sheet.functions import cos, sin
from ...sheet.quantity import dotted
from ...sheet.record import record
from ...sheet.remedy import Change, Remedy, change, remedy, up_um
from ...sheet.text import COMMA, Amount, Name, Text
from ...sheet.units import Metre, Number, Radian
from ...sheet.value import untraced
from ..inputs import GearsInputs, Mesh
from ..result import MeshResult, WheelResult
from ..wheel_inputs import Wheel
from . import temperature as t
from .case import BacklashCase, smallest_at
from .chance import BY_CHANCE, Chance
from .formulas import GUIDE, PlayResult, narrowest
from .temperature import AtState, Expansions

# --- what is judged

RECOMMENDED = "the recommended smallest backlash, by module and centre distance"
ALLOWANCES = (
    dotted("gears", GearsInputs.wheels, "DRIVER", Wheel.span_allowance),
    dotted("gears", GearsInputs.wheels, "DRIVEN", Wheel.span_allowance),
)
TOLERANCE = dotted("gears", GearsInputs.meshes, "#", Mesh.tolerance)
MORE = Text("Thinner teeth or a smaller centre tolerance give more.")

BACKLASH = CheckRule(
    "gears.M.backlash",
    "limit",
    "The teeth jam.",
    unit="µm",
    source=Text(
        "geometry: teeth must not jam at any combination of the tolerances where both wheels stand closest by their "
        "runout; all at 20 °C"
    ),
    advice=MORE,
    role="physics",
    zero=RECOMMENDED,
    value_id=dotted("gears", "M", PlayResult.backlash_min_runout),
    moved_by=(*ALLOWANCES, TOLERANCE, dotted("gears", GearsInputs.meshes, "#", Mesh.centre_distance)),
    short=Text("backlash"),
)
BACKLASH_COLD = CheckRule(
    "gears.M.backlash_cold",
    "limit",
    "The teeth jam in the cold.",
    unit="µm",
    advice=MORE,
    role="physics",
    zero=RECOMMENDED,
    cause=BACKLASH.id,
    value_id=dotted("gears", "M", PlayResult.backlash_cold),
    moved_by=(*ALLOWANCES, TOLERANCE, dotted("gears", GearsInputs.housing_material)),
    short=Text("cold backlash"),
)
BACKLASH_WARM = CheckRule(
    "gears.M.backlash_warm",
    "limit",
    "The teeth jam when warm.",
    unit="µm",
    advice=MORE,
    role="physics",
    zero=RECOMMENDED,
    cause=BACKLASH.id,
    moved_by=(*ALLOWANCES, TOLERANCE, dotted("gears", GearsInputs.housing_material)),
    short=Text("warm backlash"),
)
BACKLASH_WARMING = CheckRule(
    "gears.M.backlash_warming",
    "limit",
    "The teeth jam before the housing is as warm as they are: every start passes through it.",
    unit="µm",
    advice=MORE,
    role="physics",
    zero=RECOMMENDED,
    cause=BACKLASH.id,
    value_id=dotted("gears", "M", PlayResult.backlash_warming),
    moved_by=(*ALLOWANCES, TOLERANCE, dotted("gears", GearsInputs.wheels_warmer)),
    short=Text("backlash, warming up"),
)
BACKLASH_CHANCE = CheckRule(
    "gears.M.backlash_chance",
    "caution",
    "99 % of the trains that are made must turn freely.",
    unit="µm",
    source=Text("rule of this program: {by_chance}, of which 99 % turn freely at 20 °C", by_chance=BY_CHANCE),
    advice=MORE,
    zero=RECOMMENDED,
    cause=BACKLASH.id,
    value_id=dotted("gears", "M", PlayResult.backlash_99),
    moved_by=(*ALLOWANCES, TOLERANCE),
)
BACKLASH_WORST = CheckRule(
    "gears.M.backlash_worst",
    "caution",
    "All parts at their worst at once: hardly ever made.",
    unit="µm",
    advice=MORE,
    zero=RECOMMENDED,
    cause=BACKLASH.id,
    value_id=dotted("gears", "M", PlayResult.backlash_min_worst),
    moved_by=(*ALLOWANCES, dotted("gears", GearsInputs.meshes, "#", Mesh.stack)),
)
BACKLASH_GUIDE = CheckRule(
    "gears.M.backlash_guide",
    "advice",
    "A guide for industrial gears; more backlash turns the last wheel further out of phase.",
    unit="µm",
    source=GUIDE,
    advice=Text("The guide is for industrial gears, and more backlash turns the last wheel further out of phase."),
    cause="gears.backlash_guide",
    value_id=dotted("gears", "M", MeshResult.backlash_min),
    limit_id=dotted("gears", "M", PlayResult.backlash_recommended),
    moved_by=ALLOWANCES,
)
STACK = CheckRule(
    "gears.M.stack",
    "caution",
    "The parts add up to more than the tolerance that the backlash is judged with.",
    sense="<=",
    unit="µm",
    source=Text("mathematics: the tolerance of the centre distance must hold what its parts add up to"),
    advice=Text("Smaller fields of the parts help as well."),
    zero="what the parts add up to",
    value_id=dotted("gears", "M", PlayResult.centre_tolerance_rss),
    moved_by=(TOLERANCE, dotted("gears", GearsInputs.meshes, "#", Mesh.stack)),
)


@record
class JudgedMesh:
    """A mesh, its backlashes, and its states cold, warm, wheels warmer and warming up at the smallest backlash.

    `housings`: the expansions that are possible, several where nobody gives the material between the centres."""

    m: BacklashCase
    play: PlayResult
    smallest: Sequence[AtState]
    housings: tuple[Expansions, ...]


def checks(gears: GearsInputs, of: JudgedMesh, housing: str | None, chance: Chance | None) -> Iterator[Check]:
    """`housing`: the material between the centres that is taken, None: it grows as the driver."""
    m, play = of.m, of.play
    still = _not_given(gears, m)  # at 20 °C
    name = Text("Smallest backlash {pair} by its tolerances and runout", pair=m.name)
    slope = _slope(m, math.acos(m.touching / m.closest))  # it is least where the wheels stand closest
    least = play.backlash_min_runout
    at_best = _without_runout(m, m.mesh.centre_tolerance)
    yield _no_jam(BACKLASH, of, name, least, _missing(m, still, at_best, least), slope=slope)
    yield from _temperature_checks(gears, of, still | _not_given_warm(gears, m, housing))
    low = m.mesh.backlash_min
    yield BACKLASH_GUIDE(
        low,
        play.backlash_recommended,
        at=m.key,
        name=Text("Smallest backlash {name}, recommended", name=m.name),
        index=m.index,
        remedies=partial(_freed, m, play.backlash_recommended - low),
    )
    if play.backlash_99 is not None and chance is not None:
        name = Text("Backlash {name} that 99 % of the trains keep", name=m.name)
        lack = _missing(m, still, lambda: chance.best[m.key], play.backlash_99)
        yield _no_jam(BACKLASH_CHANCE, of, name, play.backlash_99, lack)
    if play.centre_tolerance_rss is not None and m.inputs.tolerance is not None:
        yield STACK(
            play.centre_tolerance_rss,
            m.inputs.tolerance,
            at=m.key,
            name=Text("Parts between the centres {name}, root of squares (±)", name=m.name),
            scale=play.centre_tolerance_rss,
            index=m.index,
            remedies=partial(_wider, m, play.centre_tolerance_rss),
        )
    if play.backlash_min_worst is not None and (apart := play.centre_tolerance_worst) is not None:
        name = Text("Smallest backlash {name}, all parts at their worst", name=m.name)
        reach = Amount(apart * 1e6, form=".4g")
        source = Text("geometry, worst case: the centres ±{reach} µm, with runout", reach=reach)
        lack = _missing(m, still, _without_runout(m, apart), play.backlash_min_worst)
        yield _no_jam(BACKLASH_WORST, of, name, play.backlash_min_worst, lack, source)


def _without_runout(m: BacklashCase, tolerance: Metre) -> Callable[[], Metre]:
    """The smallest backlash at 20 °C with the runouts that are given alone."""
    a_min = narrowest.function(m.mesh.centre_distance, tolerance)
    return lambda: smallest_at(m, a_min - m.least_eccentricity)


def _no_jam(
    rule: CheckRule,
    of: JudgedMesh,
    name: Text,
    j_bn: Metre,
    missing: Missing | None,
    source: Text | None = None,
    slope: Number | None = None,
    growth: Number = 1.0,
    value_id: str | None = None,
) -> Check:
    """That a backlash is not below 0.  `slope`, `growth`: as of `_freed`, which leaves no narrow margin, and frees
    the unfavourable end of what is not given."""
    m, short = of.m, -j_bn
    if rule.kind == "limit":
        short += THIN_MARGIN * of.play.backlash_recommended
    if missing is not None and isinstance(missing.worst, float) and math.isfinite(missing.worst):
        short = max(short, -missing.worst)
    return rule(
        j_bn,
        0.0,
        at=m.key,
        name=name,
        source=source,
        scale=of.play.backlash_recommended,
        index=m.index,
        value_id=value_id,
        missing=missing,
        remedies=partial(_freed, m, short, slope, growth),
    )


def _temperature_checks(gears: GearsInputs, of: JudgedMesh, missing: Mapping[str, Text]) -> Iterator[Check]:
    m = of.m
    cold, warm, warmer, warming = of.smallest
    T_min, T_H, more = (
        Amount(T, form="g") for T in (gears.lowest_temperature, gears.running_temperature, gears.warmer)
    )
    tight, where = warm, Text("all at {t_h} °C", t_h=T_H)
    tight_id = dotted("gears", m.key, PlayResult.backlash_running)
    if warm.backlash > warmer.backlash:
        tight, where = warmer, Text("housing at {t_h} °C, wheels {wheels_warmer} K warmer", t_h=T_H, wheels_warmer=more)
        tight_id = dotted("gears", m.key, PlayResult.backlash_warmer)
    at_start = Text("cold start, all at {t_min} °C", t_min=T_min)
    still_cold = Text("housing still at {t_min} °C, wheels {wheels_warmer} K warmer", t_min=T_min, wheels_warmer=more)

    def no_jam_at(
        rule: CheckRule,
        name: Text,
        at: AtState,
        place: Text,
        lack: Mapping[str, Text],
        state: int,
        value_id: str | None = None,
    ) -> Check:
        source = Text("geometry, teeth must not jam at any temperature: {where}, with runout", where=place)
        slope = _slope(m, at.pressure_angle) * at.centre_growth
        best, worst = (partial(_end, gears, of, state, best=best) for best in (True, False))
        lacking = _missing(m, lack, best, worst)
        return _no_jam(rule, of, name, at.backlash, lacking, source, slope, at.wheel_growth, value_id)

    name = Text("Smallest backlash {name}, cold", name=m.name)
    without_wheels = {key: word for key, word in missing.items() if key != WARMER}
    yield no_jam_at(BACKLASH_COLD, name, cold, at_start, without_wheels, 0)
    name = Text("Smallest backlash {name}, warm", name=m.name)
    # of both its states the one with warmer wheels, which never have more play
    yield no_jam_at(BACKLASH_WARM, name, tight, where, missing, 2, tight_id)
    name = Text("Smallest backlash {name}, warming up", name=m.name)
    yield no_jam_at(BACKLASH_WARMING, name, warming, still_cold, missing, 3)


# --- what is not given

WARMER = dotted("gears", GearsInputs.wheels_warmer)


def _not_given(gears: GearsInputs, m: BacklashCase) -> dict[str, Text]:
    """The keys that the backlash of a mesh needs and the design leaves out, each with what stands for it."""
    lack: dict[str, Text] = {}
    for wheel, F_r, given in zip((m.driver, m.driven), m.runouts, m.given_runouts):
        if given is None:
            grade = Text("runout {f_r} µm of grade {grade}", f_r=Amount(F_r * 1e6), grade=gears.accuracy_grade)
            lack[dotted("gears", GearsInputs.wheels, wheel.name, Wheel.runout)] = grade
    if _exact(m):
        lack[dotted("gears", GearsInputs.meshes, m.index, Mesh.tolerance)] = Text("an exact centre distance")
    for wheel in _unthinned(m):
        nominal = Text("0: the nominal tooth, the thickest")
        lack[dotted("gears", GearsInputs.wheels, wheel.name, Wheel.span_allowance)] = nominal
    return lack


def _not_given_warm(gears: GearsInputs, m: BacklashCase, housing: str | None) -> dict[str, Text]:
    """Those that it needs beside over temperature."""
    lack: dict[str, Text] = {}
    if t.housing_open(gears, m):
        taken = (
            Text("a housing that grows as the driver")
            if housing is None
            else Text("housing of {housing}, as of the bearings", housing=housing)
        )
        lack[dotted("gears", GearsInputs.housing_material)] = taken
    if gears.wheels_warmer is None:
        lack[WARMER] = Text("wheels {warmer} K warmer", warmer=Amount(gears.warmer, form="g"))
    return lack


def _exact(m: BacklashCase) -> bool:
    """Whether the centre distance has neither a tolerance nor parts."""
    return m.inputs.tolerance is None and m.stack is None


def _unthinned(m: BacklashCase) -> list[WheelResult]:
    return [wheel for wheel in (m.driver, m.driven) if wheel.allowance is None]


def _missing(
    m: BacklashCase, lack: Mapping[str, Text], best: Callable[[], Metre], worst: Metre | Callable[[], Metre]
) -> Missing | None:
    """`best`, `worst`: the backlash with all at their ends; thinner teeth would hold, and no tolerance has no end."""
    if not lack:
        return None
    with untraced():
        at_best: End = "holds" if _unthinned(m) else best()
        at_worst: End = "none" if _exact(m) else worst() if callable(worst) else float(worst)
    return Missing(tuple(lack), tuple(lack.values()), at_best, at_worst)


def _end(gears: GearsInputs, of: JudgedMesh, state: int, *, best: bool) -> Metre:
    """The smallest backlash in one of the thermal states with what is not given at one end."""
    m = of.m
    warmer = 0.0 if best and gears.wheels_warmer is None else gears.warmer
    e = m.least_eccentricity if best else m.eccentricity
    a = narrowest.function(m.mesh.centre_distance, m.mesh.centre_tolerance) - e
    backlashes = [t.smallest(m, alpha, t.states(gears, warmer)[state], a) for alpha in of.housings]
    return max(backlashes) if best else min(backlashes)


# --- what would just pass


def _slope(m: BacklashCase, pressure_angle: Radian) -> Number:
    """Backlash per centre distance at 20 °C.  It rises with the distance: what it asks for at the closest is enough."""
    return 2 * sin(pressure_angle) * cos(m.system.base_helix_angle)


def _freed(m: BacklashCase, short: Metre, slope: Number | None = None, growth: Number = 1.0) -> tuple[Remedy, ...]:
    """What takes a backlash that is `short` of what is asked just there: an allowance of the span acts micrometre for
    micrometre, times the `growth` of the wheels; the centre distance by `slope` (None: not offered).

    Where the parts between the centres are known, no smaller tolerance is offered: it hangs on them.
    """
    if not short > 0:
        return ()
    less = up_um(short / growth)
    thick = max((m.driver, m.driven), key=lambda wheel: wheel.allowance[0] if wheel.allowance else 0.0)
    # the field of the allowance stays as wide as it is
    ends = [round(end * 1e6 - less, 6) for end in thick.allowance or (0.0, 0.0)]
    off = remedy(
        change(Wheel, dotted("gears", GearsInputs.wheels, thick.name, Wheel.span_allowance), ends, place=thick.name),
        effect=Text("{less} µm more off the span of its teeth", less=less),
    )
    if slope is None or m.inputs.stack:
        return (off,)
    held = math.floor((m.mesh.centre_tolerance - short / slope) * 1e6)
    return (off, remedy(*_tolerance(m, held))) if held > 0 else (off,)


def _wider(m: BacklashCase, reach: Metre) -> tuple[Remedy, ...]:
    return (remedy(*_tolerance(m, up_um(reach), ">=")),)


def _tolerance(m: BacklashCase, tolerance: float, bound: str = "") -> list[Change]:
    """Another tolerance of the centre distance, in µm; it takes the place of contributors that are summed."""
    place, here = m.inputs.title, dotted("gears", GearsInputs.meshes, m.index)
    instead = [change(Mesh, dotted(here, Mesh.contributors), None, place=place)] if m.inputs.contributors else []
    return [change(Mesh, dotted(here, Mesh.tolerance), tolerance, place=place, bound=bound), *instead]


# --- what is assumed where the play does not follow from what is given


def notes(
    gears: GearsInputs, known: Sequence[tuple[BacklashCase, Expansions]], housing: str | None, chance: bool
) -> Iterator[Text]:
    if housing is None:
        yield Text("Housing material: not given; chosen: it grows as the driver of each mesh.")
    elif gears.housing_material is None:
        yield Text(
            "Housing material: not given; chosen: {housing}, that of the bearings. Over temperature the backlash is "
            "verified where it holds in a housing that grows as the driver, and in one of {aluminium}.",
            housing=housing,
            aluminium=t.ALUMINIUM,
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
    graded = {
        wheel.name: F_r
        for m, _ in known
        for wheel, F_r, given in zip((m.driver, m.driven), m.runouts, m.given_runouts)
        if given is None
    }
    if graded:
        yield Text(
            "Runout of the teeth: not given for {wheels}; chosen: that of accuracy grade {grade}, ISO 1328-2:1997 from "
            "memory.",
            wheels=COMMA.join(
                Text("{name} ({f_r} µm)", name=Name(name), f_r=Amount(F_r * 1e6)) for name, F_r in graded.items()
            ),
            grade=gears.accuracy_grade,
        )
