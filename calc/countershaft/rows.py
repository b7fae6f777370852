# SPDX-License-Identifier: Apache-2.0
"""One bearing of a shaft: a row of [[shafts.bearings]], front to rear.  What a row needs is asked by the whole design:
all of it where [bearings] judges the films, else its name and its place alone."""

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from ..library import journal_rules as rules
from ..library.journal_rules import IN_WORDS as IN_WORDS
from ..library.journal_rules import called as called
from ..library.journal_rules import titled as titled
from ..sheet.quantity import Key, choice, dotted, inputs, keys, quantity, series, text
from ..sheet.text import Amount, Text

# keys of a shaft's inputs, of those of one of its bearings and of all of them, the names left open
SHAFT, ROW, EACH_ROW = "shafts.S", "shafts.S.bearings.B", "shafts.S.bearings.*"
# of what brings the oil, over the length, for guide texts
USUAL_WIDTH = {"low": Amount(rules.SUPPLY_WIDTH[0]), "high": Amount(rules.SUPPLY_WIDTH[1])}
OF_ITS_OWN = Text("Supply and seat of its own")  # a fold of the form
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

    # of supply and seat, in place of what all bearings share
    supply: str | None = choice(
        "Oil supply",
        "hole",
        "groove",
        "pocket",
        "shaft",
        "axial_groove",
        help="hole, groove, pocket, axial_groove: in the seat. shaft: through holes in the journal, turning with the "
        "load.",
        default=None,
        fold=OF_ITS_OWN,
    )
    hole_diameter: float | None = quantity(
        "Oil hole diameter",
        "mm",
        within=(0.1, 200),
        symbol="d_H",
        source="DIN 31652-2",
        help=Text("Diameter of the oil hole; {low} to {high} of the bearing's length.", **USUAL_WIDTH),
        change=("narrower oil supply", "wider oil supply"),
        repair="free",
        where=(supply, "hole", "shaft"),
        default=None,
        fold=OF_ITS_OWN,
    )
    groove_width: float | None = quantity(
        "Groove width",
        "mm",
        within=(0, 500),
        symbol="b_G",
        source="DIN 31652-2",
        help="Width of the oil groove along the shaft; it carries no load.",
        change=("narrower oil supply", "wider oil supply"),
        repair="free",
        where=(supply, "groove"),
        default=None,
        fold=OF_ITS_OWN,
    )
    groove_arc: tuple[float, ...] | None = series(
        "Groove from and to",
        "°",
        count=(2, 2),
        within=(0, 360),
        symbol="delta_G",
        source="DIN 31652-2",
        help="Angles from the load, 180 opposite to it.",
        where=(supply, "groove"),
        default=None,
        fold=OF_ITS_OWN,
    )
    pocket_width: float | None = quantity(
        "Pocket width",
        "mm",
        within=(0.1, 500),
        symbol="b_P",
        source="DIN 31652-2",
        help=Text("Along the shaft; {low} to {high} of the bearing's length.", **USUAL_WIDTH),
        change=("narrower oil supply", "wider oil supply"),
        repair="free",
        where=(supply, "pocket"),
        default=None,
        fold=OF_ITS_OWN,
    )
    pocket_length: float | None = quantity(
        "Pocket length",
        "mm",
        within=(0.1, 500),
        symbol="l_P",
        help="Around the seat; the flow does not ask for it.",
        repair="free",
        where=(supply, "pocket"),
        default=None,
        fold=OF_ITS_OWN,
    )
    supply_angle: float | None = quantity(
        "Angle from load to supply",
        "°",
        within=(0, 180),
        symbol="delta",
        step=5,
        source="Finotti 2013, Table 5.1",
        help="Where hole or pocket keeps its angle to the load: 180 opposite, 0 in the load zone.",
        default=None,
        fold=OF_ITS_OWN,
    )
    axial_groove_angles: tuple[float, ...] | None = series(
        "Axial grooves at",
        "°",
        count=(1, 4),
        within=(0, 360),
        symbol="delta_A",
        help="Middles, from the load in the sense in which the film is dragged past it; [90, 270] for a split bearing.",
        where=(supply, "axial_groove"),
        default=None,
        fold=OF_ITS_OWN,
    )
    axial_groove_width: float | None = quantity(
        "Axial groove width",
        "mm",
        within=(0.1, 500),
        symbol="w_A",
        help="Around the seat; the film ends at its edges.",
        where=(supply, "axial_groove"),
        default=None,
        fold=OF_ITS_OWN,
    )
    axial_groove_length: float | None = quantity(
        "Axial groove length",
        "mm",
        within=(0.1, 1000),
        symbol="l_A",
        help="Along the shaft; shorter than the bearing, or the oil leaves at its ends.",
        where=(supply, "axial_groove"),
        default=None,
        fold=OF_ITS_OWN,
    )
    bush_material: str | None = text(
        "Bush material",
        help="A name from the table of bearing materials.",
        catalogue="bushes",
        default=None,
        fold=OF_ITS_OWN,
    )
    housing_material: str | None = text(
        "Housing material",
        help="A name from the table of materials or from [[material]].",
        change=("another housing",),
        catalogue="materials",
        default=None,
        fold=OF_ITS_OWN,
    )
    journal_fit: str | None = text(
        "Journal fit",
        help="ISO 286: f7 and the like, or a bare width, IT7. It opens the corners of the clearance.",
        change=("closer fits", "wider fits", "closer fits"),
        default=None,
        fold=OF_ITS_OWN,
    )
    seat_fit: str | None = text(
        "Seat fit",
        help="ISO 286: H7 and the like, or a bare field, IT7.",
        change=("closer fits", "wider fits", "closer fits"),
        default=None,
        fold=OF_ITS_OWN,
    )

    def with_own(self, twin: "BearingRow") -> "BearingRow":
        """The bearing of a twin: this one of its original, with what the twin's row says."""
        own = {entry.attribute: getattr(twin, entry.attribute) for entry in said_in(twin)}
        if not {"clearance", "clearance_factor"}.isdisjoint(own):  # one of the two, in place of what the original has
            own = {"clearance": None, "clearance_factor": None} | own
        return replace(self, **own)

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
            both = Text(
                "give either clearance_um or clearance_factor, one of the two; `--set ….{row}.clearance_factor=` takes "
                "that out",
                row=self.name,
            )
            yield dotted(BearingRow.clearance), both
        if self.clearance is not None and self.diameter is not None and self.clearance >= 0.1 * self.diameter:
            yield dotted(BearingRow.clearance), Text("must stay below a tenth of the diameter")
        if self.carrier_bore is not None and self.diameter is not None and self.carrier_bore <= self.diameter:
            yield dotted(BearingRow.carrier_bore), Text("must be larger than the diameter: the carrier holds its seat")


def said_in(row: BearingRow) -> list[Key]:
    """What a row says beside its name."""
    _, *entries = keys(BearingRow).values()
    return [entry for entry in entries if getattr(row, entry.attribute) != entry.field.default]


# what a bearing of a twin has of its original
SIZES = BearingRow.position, BearingRow.kind, BearingRow.diameter, BearingRow.length
OF_ORIGINAL = tuple(map(dotted, (*SIZES, BearingRow.offset, BearingRow.carrier_bore)))
