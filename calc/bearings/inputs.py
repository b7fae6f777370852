# SPDX-License-Identifier: Apache-2.0
"""What the bearings of all shafts share: oil, housing and temperatures, and what those of each kind are asked."""

from collections.abc import Iterable

from ..countershaft.rows import BearingRow
from ..sheet.quantity import Key, described, dotted, inputs, keys
from ..sheet.record import replace
from ..sheet.text import Text
from .plain.inputs import PlainInputs
from .rolling.inputs import RollingInputs


@inputs
class BearingsInputs(RollingInputs, PlainInputs):
    """Oil, supply, housing and temperatures of the bearings; each has its sizes in its row of [[shafts.bearings]]."""

    def of(self, row: BearingRow) -> "BearingsInputs":
        """The inputs as they hold for one bearing: what its row says of supply and seat itself rules there."""
        own = {entry.attribute: getattr(row, entry.attribute) for entry in ruled_by(row)}
        return replace(self, **own) if own else self

    def problems(self) -> Iterable[tuple[str, Text]]:
        yield from self.plain_problems()
        yield from self.rolling_problems()

    def asked_of(self, row: BearingRow) -> Iterable[tuple[str, Text]]:
        """What a bearing that these inputs judge still lacks, by the keys of its row."""
        if row.fed():
            yield from row.idle()
            yield from self.asked_of_plain(row)

    def asked_by(self, rows: Iterable[BearingRow]) -> Iterable[tuple[str, Text]]:
        """What these bearings ask of these inputs, by their own keys: of those that are fed, how the oil comes."""
        if not any(row.fed() for row in rows):
            return
        for key, there in (
            (BearingsInputs.supply_pressure, self.supply_pressure),
            (BearingsInputs.supply, self.supply),
        ):
            if there is None:
                yield dotted(key), Text("is missing; needs {allowed}", allowed=described(key).allowed())


# of what all share what a row may say for its bearing alone
OF_ROWS = tuple(entry for key, entry in keys(BearingRow).items() if key in keys(PlainInputs))


def ruled_by(row: BearingRow) -> list[Key]:
    """What of that a row says."""
    return [entry for entry in OF_ROWS if getattr(row, entry.attribute) is not None]
