# SPDX-License-Identifier: Apache-2.0
"""One bearing of a shaft: a row of [[shafts.bearings]], front to rear.  What a row needs is asked by the whole design:
all of it where [bearings] judges the films, else its name and its place alone."""

from collections.abc import Iterable
from typing import Any

from ..library import journal_rules as rules
from ..library.journal_rules import IN_WORDS as IN_WORDS
from ..library.journal_rules import called as called
from ..library.journal_rules import titled as titled
from ..sheet.quantity import choice, dotted, inputs, quantity, series, text
from ..sheet.text import Text

# keys of a shaft's inputs, of those of one of its bearings and of all of them, the names left open
SHAFT, ROW, EACH_ROW = "shafts.S", "shafts.S.bearings.B", "shafts.S.bearings.*"
ASKED_ELSEWHERE: Any = None  # left out by the file's own rules; where it is needed, the whole design says so


def row_key(row: str, field: object = "") -> str:
    """The key of one of the bearings, by its name, or of one of its inputs."""
    return dotted(SHAFT, "bearings", row, field) if field else dotted(SHAFT, "bearings", row)


def sign(row: str) -> str:
    """What stands for it in a symbol: f and r for front and rear."""
    return {"front": "f", "middle": "m", "rear": "r"}.get(row, row)


@inputs
class BearingRow:
    """One journal in its seat."""

    name: str = text("Name", help="front, middle, rear or any other word; not figures alone.", decides=5)
    position: float = quantity(
        "Position",
        "mm",
        default=ASKED_ELSEWHERE,
        within=(-5000, 5000),
        symbol="z_B",
        help="Middle of the journal from mid-shaft, + towards the flywheel; the rows rise from front to rear.",
        change=("shorter span", "longer span"),
        repair="free",
        decides=6,
    )
    kind: str = choice("Kind", "plain", default="plain", help="plain: a journal in its seat, on a film of oil.")
    diameter: float = quantity(
        "Journal diameter",
        "mm",
        default=ASKED_ELSEWHERE,
        up_to=1000,
        symbol="d",
        step=0.5,
        rule_of_thumb=(15, 120),
        help="Diameter of the journal; a larger one carries more and rubs more.",
        change=("smaller journal", "larger journal"),
        repair="free",
        brief="diameter",
        decides=7,
    )
    length: float = quantity(
        "Length",
        "mm",
        default=ASKED_ELSEWHERE,
        up_to=1000,
        symbol="l",
        step=0.5,
        source="Finotti 2013, 5.5.2",
        help=Text(
            "Along the shaft; {usual}. More length: lower specific load, thicker film.", usual=rules.USUAL_LENGTH
        ),
        change=("shorter journal", "longer journal"),
        repair="free",
        decides=8,
    )
    clearance: float | None = quantity(
        "Clearance (diametral)",
        "µm",
        default=None,
        within=(0.1, 5000),
        symbol="g",
        step=1,
        source="makers of balance shafts; Finotti 2013, 5.5.2: ψ 1 ‰ very precise, 2 ‰ ordinary, 4 ‰ coarse",
        help=Text(
            "Bore minus journal at the reference temperature; {usual}. Left out: by clearance_factor or the fits.",
            usual=rules.USUAL_CLEARANCE,
        ),
        change=("smaller clearance", "larger clearance"),
        repair="free",
        brief="clearance",
        decides=9,
    )
    clearance_factor: float | None = quantity(
        "Clearance factor K",
        default=None,
        within=(0.01, 10),
        symbol="K",
        step=0.05,
        usual=(0.4, 0.8),
        source="Finotti 2013, 5.5.2",
        help="Clearance g = K·d·u^¼ in mm, m and m/s.",
        change=("smaller clearance", "larger clearance"),
        repair="free",
        decides=10,
    )
    load: float | None = quantity(
        "Load",
        "N",
        default=None,
        up_to=1e7,
        symbol="F",
        step=50,
        help="Radial load on the journal. Left out: the reaction of the shaft.",
        repair="asked",
    )
    offset: tuple[float, ...] | None = series(
        "Bore off the line",
        "µm",
        default=None,
        count=(2, 2),
        within=(-1000, 1000),
        symbol="g_B",
        help="Up, and 90° further in the sense of the crank: the bore of an inner bearing off the line of the outer "
        "two.",
    )
    journal_roughness: float = quantity(
        "Roughness Ra, journal",
        "µm",
        default=ASKED_ELSEWHERE,
        within=(0, 50),
        symbol="Ra_1",
        step=0.1,
        rule_of_thumb=(0.1, 0.8),
        help="Mean roughness; the film must clear its peaks.",
        change=("smoother surfaces", "rougher surfaces"),
        repair="free",
    )
    housing_roughness: float = quantity(
        "Roughness Ra, seat",
        "µm",
        default=ASKED_ELSEWHERE,
        within=(0, 50),
        symbol="Ra_2",
        step=0.1,
        rule_of_thumb=(0.1, 1.6),
        help="Mean roughness; the film must clear its peaks.",
        change=("smoother surfaces", "rougher surfaces"),
        repair="free",
    )
    slope: float | None = quantity(
        "Slope of the journal",
        "mrad",
        default=None,
        within=(0, 20),
        symbol="theta",
        usual=(0, rules.SLOPE * 1e3),
        source="Finotti 2013, 4.6 (in chapter 6)",
        help="In its seat. Left out: by bending, else 0.1.",
        change=("smaller slope", "larger slope", "slope of the shaft's bending"),
        repair="asked",
    )

    carrier_bore: float | None = quantity(
        "Bore for its carrier",
        "mm",
        default=None,
        up_to=2000,
        symbol="D_c",
        step=0.5,
        help='With assembly = "cartridge": the bore of the block that the carrier of an outer bearing fills; through '
        "it the shaft comes in.",
        change=("smaller carrier", "larger carrier"),
        repair="free",
    )

    @property
    def in_words(self) -> Text:
        """Its name inside a sentence."""
        return called(self.name)

    @property
    def sized(self) -> bool:
        """Whether the size of its journal is known."""
        return self.diameter is not None and self.length is not None

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.name.isascii() and self.name.isdigit():
            yield dotted(BearingRow.name), Text("must not be figures alone, by which elements are counted")
        if self.clearance is not None and self.clearance_factor is not None:
            yield dotted(BearingRow.clearance), Text("give either clearance_um or clearance_factor, one of the two")
        if self.clearance is not None and self.diameter is not None and self.clearance >= 0.1 * self.diameter:
            yield dotted(BearingRow.clearance), Text("must stay below a tenth of the diameter")
        if self.carrier_bore is not None and self.diameter is not None and self.carrier_bore <= self.diameter:
            yield dotted(BearingRow.carrier_bore), Text("must be larger than the diameter: the carrier holds its seat")
