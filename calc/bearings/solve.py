# SPDX-License-Identifier: Apache-2.0
"""The bearings of a shaft: what each carries, and each as its kind judges it."""

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from ..countershaft.bending.condensed import Condensed, of_beam
from ..countershaft.formulas import reaction
from ..countershaft.result import CountershaftResult
from ..countershaft.rows import BearingRow, called, row_key
from ..countershaft.twins import How
from ..engine.inputs import EngineInputs
from ..engine.operation import BenchPoint
from ..library.catalogue import Material, Oil
from ..library.lubricant import Lubricant
from ..sheet.arrays import Array
from ..sheet.check import Check, CheckRule
from ..sheet.errors import NoSolution
from ..sheet.linked_array import elements
from ..sheet.record import replace
from ..sheet.remedy import by_key
from ..sheet.step import Outcome
from ..sheet.text import EMPTY, Text
from ..sheet.units import Metre, Number, Radian, Second
from ..sheet.value import about, based_on, trace, untraced
from .inputs import BearingsInputs
from .kinds import KINDS
from .lives import life_together
from .plain.checks import SLOPE, oil_check
from .plain.inputs import SLOPE_TAKEN
from .plain.solve import operating_point
from .plain.speeds import TURNING, of_journals
from .result import BearingsResult
from .sharing import on_films, on_shaft, shared, support_checks, turned_over
from .support import Carrying, OperatingPoint, ShaftInView, Solids, Support, Task, Told, by_row
from .told import of_kinds, shown

SLOPE_GIVEN = CheckRule(
    "bearings.B.slope_given",
    "caution",
    "The film at the edge is judged with a smaller slope than the shaft takes.",
    unit="mrad",
    source=Text("elasticity: bending of the stepped shaft, with the stiffness share of its sectors"),
    zero="the slope that is taken where none is known, 0.1 mrad",
    cause="bearings.slope_given",
    moved_by=(SLOPE,),
)


class BearingMaterials(NamedTuple):
    """What the bearings of a shaft run with: their oil, the material of the journals; front to rear that of the housing
    at each, and that of a bush in it."""

    oil: Oil
    journal: Material
    housings: tuple[Material, ...]
    backings: tuple[Material, ...]
    shaft_bore: Metre = 0.0


def solve(
    bearings: BearingsInputs,
    rows: tuple[BearingRow, ...],
    shaft: CountershaftResult | None,
    engine: EngineInputs | None,
    solids: BearingMaterials,
    *,
    speed_ratio: Number | None,
    how: How = "own",
    assembly: str | None = None,
    life: Second | None = None,
    compared: bool = True,
) -> Outcome[BearingsResult]:
    """The bearings of a shaft, front to rear, under the loads given, or the shaft's reactions, which turn with it and
    grow with its speed squared; more than two share them by their laws and its bending.

    `speed_ratio`: of the shaft to the crank.  `how`: the bearings may be those of its mirror image, whose films are
    the same turned over.  `assembly`: how the shaft comes into its seats, where that is said.  `life`: that of the
    gears, where it is given.  `compared`: with the other routes to the film beside the one that judges.
    """
    speed, bench = bearings.speed, tuple[BenchPoint, ...]()
    if engine is not None:
        rated, bench = of_journals(engine, speed_ratio)
        speed = rated if speed is None else speed
    assert speed is not None
    task = Task(speed, speed_ratio, bench, engine.operation if engine is not None else (), life, compared)
    outline = None if shaft is None else shaft.outline
    view, zone = ShaftInView(assembly, speed_ratio, speed, len(rows), outline), bearings.coaxiality
    results: dict[str, Carrying] = {}
    all_checks: list[Check] = []  # of each bearing at once: they have lines of their own
    with trace() as lines:
        with about(Text("oil")):
            lubricant = Lubricant(solids.oil, bearings.viscosity_law)
        supports: list[Support] = []
        with untraced():
            duty = operating_point(bearings, 0.0, speed)
        for row, housing, backing in zip(rows, solids.housings, solids.backings):
            made_of = Solids(lubricant, solids.journal, housing, backing, solids.shaft_bore)
            supports.append(KINDS[row.kind].support(row, bearings.of(row), made_of, _load(row, shaft), task))
        turning, films = condensed(bearings, rows, shaft), None
        sense = -1 if speed_ratio is not None and speed_ratio < 0 else 1
        if turning is not None and len(rows) > 2:
            films = shared(turning, supports, duty, sense)
            films = on_films(turning, films, supports, duty)
            with about(Text("shaft on its films")):
                loads = [reaction(R=P) for P in elements(films.carried.load)]
        else:
            loads = [_load(row, shaft) for row in rows]
        supports = _some_centred(supports, loads, duty)
        shares = dict[str, Array]()
        if turning is not None and films is not None:
            for kind in _kinds(rows):
                shares |= KINDS[kind].shares(turning, films, supports, duty)
        spans = dict[str, slice]()
        for support, load in zip(supports, loads):
            place, begun = support.row.name, len(lines)
            with about(Text("{place} bearing", place=called(place))):
                results[place] = support.solved(load, _slope(support.row, shaft), shares.get(place), task)
                all_checks += by_row(support.row, [*results[place].checks()])
            spans[place] = slice(begun, len(lines))
        told = Told(bearings, shaft, view, spans)
        result = BearingsResult(bearings=results, supports=tuple(supports), told=told)
        if shaft is not None:
            result = on_shaft(result, shaft, turning, films, sense, zone)
            result = turned_over(result) if how == "mirrors" else result
        result = replace(result, system_life=life_together(result.bearings.values()))
    all_checks += _slope_checks(shaft, results)
    all_checks += support_checks(result, films, shaft, zone)
    results = result.bearings
    for kind, those in of_kinds(results).items():
        all_checks += KINDS[kind].checks(those, view)
        all_checks += KINDS[kind].renewed(those, result.system_life)
    if (pumping_check := oil_check(bearings, solids.oil)) is not None:
        all_checks.append(pumping_check)
    return Outcome(
        "bearings",
        result=result,
        checks=tuple(all_checks),
        lines=tuple(lines),
        **shown(told, result, results),
    )


def _kinds(rows: tuple[BearingRow, ...]) -> list[str]:
    """The kinds that there are, in their order."""
    return [kind for kind in KINDS if any(row.kind == kind for row in rows)]


def _load(bearing: BearingRow, shaft: CountershaftResult | None) -> float:
    """As given, else the reaction of the shaft there."""
    if bearing.load is not None:
        return bearing.load
    return 0.0 if shaft is None else shaft.loads[bearing.name]


def condensed(
    bearings: BearingsInputs, rows: tuple[BearingRow, ...], shaft: CountershaftResult | None
) -> Condensed | None:
    """The turning shaft as its films know it; None where it is not known how it bends, where a load is given, which
    rules, and where the load does not turn with the journals in seats that stand."""
    if shaft is None or shaft.bending is None or any(row.load is not None for row in rows):
        return None
    if bearings.load_speed_ratio != TURNING or bearings.bush_speed_ratio != 0:
        return None
    turning = of_beam(shaft.bending.model, shaft.omega)
    return replace(turning, f_c=based_on(turning.f_c, shaft.bending.reactions))


def _some_centred(supports: list[Support], loads: list[float], duty: OperatingPoint[Any]) -> list[Support]:
    """The bearings, with those that carry next to nothing as centred.  Where all do, none has a film that is judged."""
    centred = [support.centred_under(replace(duty, load=load)) for support, load in zip(supports, loads)]
    if not all(centred):
        return [support.as_centred() if here else support for support, here in zip(supports, centred)]
    if max(loads) <= 0:
        advice = Text("give the counter-shaft eccentric masses that balance a couple")
        place = called(supports[0].row.name)
        raise NoSolution(Text("the {place} bearing carries no load", place=place), EMPTY, advice)
    return supports


def _slope(bearing: BearingRow, shaft: CountershaftResult | None) -> Radian | None:
    """As given, else as the bending of the shaft has it there; None where neither is known."""
    return bearing.slope if bearing.slope is not None or shaft is None else shaft.slopes.get(bearing.name)


def _slope_checks(shaft: CountershaftResult | None, results: Mapping[str, Carrying]) -> Iterator[Check]:
    """Slopes that are given, held against those of the shaft as this design bends it: what stands on them stands on the
    given ones."""
    if shaft is None or shaft.bending is None:
        return  # where nothing bends, the shaft has its slopes from here
    for place, r in results.items():
        slope, bent = r.row.slope, shaft.slopes.get(place)
        if bent is None or slope is None:
            continue
        left_out = by_key(BearingRow, row_key(place, BearingRow.slope), None, effect=r.slope_effect(bent))
        label = Text("Slope as given, {place}, against that of the shaft's bending", place=called(place))
        yield SLOPE_GIVEN(slope, bent, at=place, name=label, scale=SLOPE_TAKEN, remedies=left_out)
