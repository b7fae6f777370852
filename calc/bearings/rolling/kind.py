# SPDX-License-Identifier: Apache-2.0
"""Rolling bearings as a kind of support: how one is made from its row, and what is shown of all of a shaft together."""

from collections.abc import Iterable, Iterator, Mapping

from ...countershaft.outline import Outline
from ...countershaft.result import CountershaftResult
from ...countershaft.rows import BearingRow, row_key
from ...draw.annotations import SheetTable
from ...draw.drawing import Sketch
from ...draw.sizes import Say
from ...sheet.check import Check
from ...sheet.step import Curve, Table
from ...sheet.text import Text
from ...sheet.units import Metre, Newton, Second
from ..inputs import BearingsInputs
from ..support import Kind, ShaftInView, Solids, Task, TurnedJournal, on_bearing
from .bearing import RollingBearing, RollingSupport
from .checks import ASSEMBLY, LOCATING, SYSTEM_LIFE, life_asked
from .curves import curves, tables
from .notes import notes
from .on_drawing import on_drawing, turned
from .sketch import pictures
from .solve import case_of


class Rolling(Kind[RollingBearing]):
    def support(
        self, row: BearingRow, inputs: BearingsInputs, solids: Solids, load: Newton, task: Task
    ) -> RollingSupport:
        return RollingSupport(case_of(row, inputs, solids))

    def checks(self, results: Mapping[str, RollingBearing], shaft: ShaftInView) -> Iterator[Check]:
        if len(results) == shaft.bearings:
            located = sum(r.row.locates for r in results.values())
            yield LOCATING(float(located), 1.0, moved_by=tuple(row_key(place, BearingRow.locates) for place in results))
        for place, r in results.items():
            if shaft.outline is not None and not r.row.split_cage:
                ends = on_the_way(shaft.outline, r.row.position)
                if ends is not None:
                    yield on_bearing(ASSEMBLY, place, r.case.size.bore, ends)

    def renewed(self, results: Mapping[str, RollingBearing], system_life: Second | None) -> Iterator[Check]:
        if system_life is not None and len(results) > 1:
            one = next(iter(results.values()))
            yield SYSTEM_LIFE(system_life, life_asked(one.case.inputs, one.task.life))

    def curves(self, results: Mapping[str, RollingBearing]) -> Iterator[Curve]:
        return curves(results)

    def tables(self, results: Mapping[str, RollingBearing], shaft: ShaftInView) -> Iterator[Table]:
        return tables(results)

    def pictures(self, results: Mapping[str, RollingBearing], checks: dict[str, Check]) -> dict[str, Sketch]:
        return pictures(results, checks)

    def turned(self, row: BearingRow, inputs: BearingsInputs) -> TurnedJournal:
        return turned(row, inputs)

    def on_drawing(
        self, results: Mapping[str, RollingBearing], inputs: BearingsInputs, say: Say
    ) -> Iterator[SheetTable]:
        return on_drawing(results, inputs, say)

    def notes(
        self, inputs: BearingsInputs, solved: CountershaftResult | None, results: Mapping[str, RollingBearing]
    ) -> Iterable[Text]:
        return notes(inputs, None if solved is None else solved.outline, results)


def on_the_way(outline: Outline, z: Metre, mounted: tuple[str, ...] = ("gear",)) -> Metre | None:
    """The largest diameter that a ring passes from that end of the shaft from which it has more room to its place at z;
    None where nothing lies beyond it at one end.  `mounted`: pieces that come later, or have another size then."""
    beyond = [piece for piece in outline.pieces if piece.what not in mounted and not piece.start <= z <= piece.end]
    front = [2 * piece.outer_radius for piece in beyond if piece.end <= z]
    rear = [2 * piece.outer_radius for piece in beyond if piece.start >= z]
    return None if not front or not rear else min(max(front), max(rear))


KIND = Rolling()
