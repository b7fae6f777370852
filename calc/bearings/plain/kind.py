# SPDX-License-Identifier: Apache-2.0
"""Plain bearings as a kind of support: how one is made from its row, and what is shown of all of a shaft together."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from ...countershaft.bending.condensed import Condensed
from ...countershaft.result import CountershaftResult
from ...countershaft.rows import BearingRow, called
from ...draw.annotations import SheetTable
from ...draw.drawing import Sketch
from ...draw.sizes import Say
from ...sheet.arrays import Array
from ...sheet.check import Check
from ...sheet.step import Curve, Erratum, Table
from ...sheet.text import Text
from ...sheet.units import Newton
from ...sheet.value import about
from ..inputs import BearingsInputs
from ..support import Kind, OperatingPoint, ShaftInView, Shared, Solids, Support, Task, TurnedJournal
from .as_support import at_corners
from .bearing import PlainBearing
from .corners import corners_table
from .curves import charts, curves
from .makers import maker_checks, makers_table, own_journal
from .notes import errata, notes
from .on_drawing import on_drawing, turned
from .result import AT_ALL
from .routes.side_by_side import routes_table
from .routes.states import BearingCase
from .seats.seat import rings_of
from .seats.sitting import sitting
from .seats.sketch import seat_sketches
from .seats.stack import stack_of
from .seats.tables import seat_tables
from .seats.warm import seat_curves, warm_table
from .sketch import pictures
from .solve import PlainSupport, clearance_of, operating_point
from .suitability import Journal, Running, reference_table
from .suitability import table as bushes_table


class Plain(Kind[PlainBearing]):
    def support(
        self, row: BearingRow, inputs: BearingsInputs, solids: Solids, load: Newton, task: Task
    ) -> PlainSupport:
        stack, place = stack_of(row, inputs.select), called(row.name)
        with about(Text("{place} bearing", place=place)):
            rings = rings_of(row, inputs, stack, solids.backing, solids.housing, row.diameter)
            clearance = clearance_of(inputs, row, task.speed) if stack is None else 0.0
        expansions = solids.journal.expansion, solids.housing.expansion
        case = BearingCase(row, inputs, solids.lubricant, clearance, *expansions, stack=stack, rings=rings)
        with about(Text("{place} bearing, seat", place=place)):
            return PlainSupport(sitting(case, operating_point(inputs, load, task.speed)), solids.housing)

    def shares(
        self, shaft: Condensed, shared: Shared, supports: Sequence[Support], duty: OperatingPoint[Any]
    ) -> dict[str, Array]:
        cases = [support.case if isinstance(support, PlainSupport) else None for support in supports]
        return at_corners(shaft, shared, cases, duty)

    def checks(self, results: Mapping[str, PlainBearing], shaft: ShaftInView) -> Iterator[Check]:
        return maker_checks(results, shaft.assembly, shaft.ratio)

    def curves(self, results: Mapping[str, PlainBearing]) -> Iterator[Curve]:
        for place, r in results.items():
            yield from curves(place, r)

    def seat_curves(self, results: Mapping[str, PlainBearing]) -> Iterator[Curve]:
        for place, r in results.items():
            yield from seat_curves(place, r)

    def charts(self, results: Mapping[str, PlainBearing]) -> Iterator[Curve]:
        return charts(dict(results))

    def tables(self, results: Mapping[str, PlainBearing], shaft: ShaftInView) -> Iterator[Table]:
        for place, r in results.items():
            yield routes_table(place, r.side)
            yield corners_table(place, r.corners, r.seat)
            yield from seat_tables(place, r.seat, r.select)
            yield from warm_table(place, r, AT_ALL[:2])
        runs = {
            place: Running(r.specific_load, r.pressure_velocity, r.outlet_temperature) for place, r in results.items()
        }
        surfaces = [r.seat.inputs.bush_material or r.seat.inputs.housing_material for r in results.values()]
        yield bushes_table(runs, surfaces)
        sizes = {place: (r.row.diameter, r.row.length) for place, r in results.items()}
        yield reference_table(Journal(place, *sizes[place], shaft.speed, r.load) for place, r in results.items())
        beside_makers = makers_table(
            [own_journal(place, r) for place, r in results.items()], shaft.assembly, shaft.ratio
        )
        if beside_makers is not None:
            yield beside_makers

    def pictures(self, results: Mapping[str, PlainBearing], checks: dict[str, Check]) -> dict[str, Sketch]:
        return pictures(results, checks)

    def sections(self, results: Mapping[str, PlainBearing], checks: dict[str, Check]) -> list[list[Sketch]]:
        return [*seat_sketches(results, checks)]

    def turned(self, row: BearingRow, inputs: BearingsInputs) -> TurnedJournal:
        return turned(row, inputs)

    def on_drawing(self, results: Mapping[str, PlainBearing], inputs: BearingsInputs, say: Say) -> Iterator[SheetTable]:
        return on_drawing(results, inputs, say)

    def notes(
        self, inputs: BearingsInputs, solved: CountershaftResult | None, results: Mapping[str, PlainBearing]
    ) -> Iterable[Text]:
        return notes(inputs, solved, results)

    def errata(self, results: Mapping[str, PlainBearing]) -> Iterable[Erratum]:
        return (erratum for place, r in results.items() for erratum in errata(place, r))


KIND = Plain()
