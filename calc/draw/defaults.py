# SPDX-License-Identifier: Apache-2.0
"""What a drawing takes where the design says nothing: the draughtsman's choices, all in one place, and all said in the
notes of the sheet that they stand on.

They are usual ones, no rule of a standard but where one is named."""

from bisect import bisect_left
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from ..library.table_file import house_table
from ..library.tolerances import ToleranceField
from ..sheet.text import COMMA, EMPTY, Text
from ..sheet.units import UNITS, Metre
from .sizes import number

if TYPE_CHECKING:
    from ..countershaft.rows import BearingRow

TIP_FIELD = ToleranceField("h", 10)  # of tips: Finotti 2013, 4.5.2, has 0/−0.1 mm at 58 mm
BORE_FIELD = ToleranceField("H", 7)  # of the bore of a wheel
FORM = 0.25  # of the width of a journal's field: half of what its limits alone permit
RUNOUT = 0.5  # likewise, of a journal about the axis of the outer two
SIGMAS = 3  # so many standard deviations of the production scatter are the tolerance of masses and timing
FINEST: Metre = 1e-6
GENERAL = "ISO 2768-mK"
EDGES: Metre = 0.3e-3
ROUGHNESS: Metre = 3.2e-6


def general(length: Metre) -> tuple[Metre, Metre] | None:
    """The deviations that the general tolerance permits a length; None beyond its range."""
    row = house_table("iso_2768.toml")["medium"]
    place = bisect_left(row["up_to_mm"], UNITS["mm"].shown(length))
    if place == len(row["up_to_mm"]):
        return None
    deviation = row["deviation_mm"][place] * UNITS["mm"].factor
    return -deviation, deviation


def share(width: Metre, of: float) -> Metre:
    """A share of the width of a field, in whole micrometres, downwards, but no less than one."""
    return max(FINEST, int(width * of / FINEST + 1e-6) * FINEST)


def said() -> Text:
    """The note of every sheet."""
    return Text(
        "Draughtsman's choice elsewhere: general tolerances {general}; Ra {ra}; edges broken {edges}×45°.",
        general=GENERAL,
        ra=number(UNITS["µm"].shown(ROUGHNESS), 1),
        edges=number(UNITS["mm"].shown(EDGES), 1),
    )


def of_tips() -> Text:
    return Text("{field} of the tips", field=str(TIP_FIELD))


def of_zones(rows: "Iterable[BearingRow]", gear: bool) -> Iterator[Text]:
    """By which rules the geometrical tolerances of journals and gear are drawn."""
    inner = {getattr(row.outline, "inner_ring", None) for row in rows}  # None: of no rolling bearing
    forms = [
        Text("cylindricity a quarter of the journal's field") if None in inner else EMPTY,
        Text("cylindricity half of IT5 under rings") if True in inner else EMPTY,
        Text("cylindricity IT3 under needles") if False in inner else EMPTY,
        Text("run-out half of the journal's field") if inner else EMPTY,
        Text("tips as the teeth") if gear else EMPTY,
    ]
    if any(forms):
        yield Text("Draughtsman's choice of shape: {rules}.", rules=COMMA.join(filter(None, forms)))
