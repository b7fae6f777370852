# SPDX-License-Identifier: Apache-2.0
"""Rolling bearings as a kind of support: how one is made from its row, and what is shown of all of a shaft together."""

from collections.abc import Iterable, Mapping

from ...countershaft.result import CountershaftResult
from ...countershaft.rows import BearingRow
from ...sheet.text import Text
from ...sheet.units import Newton
from ..inputs import BearingsInputs
from ..support import Kind, Solids, Task
from .bearing import RollingBearing, RollingSupport
from .notes import notes
from .solve import case_of


class Rolling(Kind[RollingBearing]):
    def support(
        self, row: BearingRow, inputs: BearingsInputs, solids: Solids, load: Newton, task: Task
    ) -> RollingSupport:
        return RollingSupport(case_of(row, inputs, solids))

    def notes(
        self, inputs: BearingsInputs, solved: CountershaftResult | None, results: Mapping[str, RollingBearing]
    ) -> Iterable[Text]:
        return notes(inputs, results)
