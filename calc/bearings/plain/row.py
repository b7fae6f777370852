# SPDX-License-Identifier: Apache-2.0
"""What a row of [[shafts.bearings]] says of a plain bearing: its size, its clearance, how the journal sits, its oil."""

from collections.abc import Iterable, Sequence

from ...library import journal_rules as rules
from ...sheet.quantity import choice, dotted, inputs, keys, quantity, series, text
from ...sheet.text import Amount, Text
from ..row import ASKED_ELSEWHERE, LEAST_METAL, OF_ITS_OWN, SEAT, SupportRow, more_metal

# of what brings the oil, over the length, for guide texts
USUAL_WIDTH = {"low": Amount(rules.SUPPLY_WIDTH[0]), "high": Amount(rules.SUPPLY_WIDTH[1])}
RELIEF, RELIEF_LENGTH = 8e-6, 2.5e-3  # m, of shells at the split, where not given; from memory, confidence low
KIND = SupportRow.kind


@inputs
class PlainRow(SupportRow):
    """One journal in its seat."""

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
        where=(KIND, "plain"),
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
        where=(KIND, "plain"),
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
        where=(KIND, "plain"),
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
        where=(KIND, "plain"),
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
        where=(KIND, "plain"),
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
        where=(KIND, "plain"),
    )
    seat: str = choice(
        "Seat",
        "direct",
        "bush",
        "shells",
        default="direct",
        help="direct: in the housing itself. bush: a ring pressed in. shells: two halves between housing and cap.",
        fold=SEAT,
        where=(KIND, "plain"),
    )
    journal: tuple[float, ...] | None = series(
        "Limits of the journal",
        "mm",
        default=None,
        count=(2, 2),
        up_to=1000,
        symbol="d_J",
        help="Least and most. With bore_mm they make the clearance, and fits are left out.",
        fold=SEAT,
        where=(KIND, "plain"),
    )
    wall: tuple[float, ...] | None = series(
        "Wall",
        "mm",
        default=None,
        count=(1, 2),
        within=(0.5, 10),
        symbol="w",
        help="One number, or least and most: of the bush, or of a shell at its crown, lining included.",
        where=(seat, "bush", "shells"),
        fold=SEAT,
    )
    bore_: str = choice(
        "Running bore",
        "as_pressed",
        "finished",
        default="as_pressed",
        help="as_pressed: as housing and wall leave it. finished: cut to finished_mm after pressing.",
        where=(seat, "bush"),
        fold=SEAT,
    )
    finished: tuple[float, ...] | None = series(
        "Finished bore",
        "mm",
        default=None,
        count=(2, 2),
        up_to=1000,
        symbol="D_f",
        help="Least and most of the running bore, cut after pressing.",
        where=(bore_, "finished"),
        fold=SEAT,
    )
    interference: tuple[float, ...] | None = series(
        "Interference",
        "µm",
        default=None,
        count=(2, 2),
        within=(0, 1000),
        symbol="delta",
        rule_of_thumb=(5, 150),
        help="Least and most: outside of the bush less bore, both free, at the reference temperature. Left out: what "
        "holds the bush.",
        where=(seat, "bush", "shells"),
        fold=SEAT,
    )
    crush: tuple[float, ...] | None = series(
        "Crush of a shell",
        "µm",
        default=None,
        count=(2, 2),
        within=(0, 1000),
        symbol="c",
        rule_of_thumb=(10, 200),
        help="Least and most: by how much one half's outer length exceeds half the bore's circumference.",
        where=(seat, "shells"),
        fold=SEAT,
    )
    crush_load: float = quantity(
        "Checking load of the crush",
        "N",
        default=0.0,
        within=(0, 1e6),
        symbol="F_c",
        help="Under which the crush was measured.",
        where=(seat, "shells"),
        fold=SEAT,
    )
    spread: float | None = quantity(
        "Free spread of a shell",
        "µm",
        default=None,
        within=(-1000, 5000),
        symbol="s_f",
        help="Its free outside less the bore; above nought it holds itself in the housing.",
        where=(seat, "shells"),
        fold=SEAT,
    )
    relief: float | None = quantity(
        "Relief at the split",
        "µm",
        default=None,
        within=(0, 100),
        symbol="r",
        help="How far a shell stands back at its parting line. Left out: 8.",
        where=(seat, "shells"),
        fold=SEAT,
    )
    relief_length: float | None = quantity(
        "Length of the relief",
        "mm",
        default=None,
        within=(0, 20),
        symbol="a_r",
        help="Along the shell, to each side of its parting line. Left out: 2.5.",
        where=(seat, "shells"),
        fold=SEAT,
    )
    split_angle: float = quantity(
        "Plane of the joint",
        "°",
        default=0.0,
        within=(-90, 90),
        symbol="gamma_s",
        step=15,
        help="0: horizontal. For the drawing, and for loads that stand.",
        fold=SEAT,
        where=(KIND, "plain"),
    )
    backing: str = text(
        "Backing",
        default="strip",
        help="A material from the table or from [[material]]: what bush or shell are made of under their lining.",
        catalogue="materials",
        where=(seat, "bush", "shells"),
        fold=SEAT,
    )
    retained: str = choice(
        "Held by",
        "press",
        "pin",
        default="press",
        help="pin: a pin or shoulder holds it although the press is gone; a tab does not.",
        where=(seat, "bush", "shells"),
        fold=SEAT,
    )
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
        where=(KIND, "plain"),
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
        where=(KIND, "plain"),
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
        where=(KIND, "plain"),
    )
    journal_fit: str | None = text(
        "Journal fit",
        help="ISO 286: f7 and the like, or a bare width, IT7. It opens the corners of the clearance.",
        change=("closer fits", "wider fits", "closer fits"),
        default=None,
        fold=OF_ITS_OWN,
        where=(KIND, "plain"),
    )

    def place(self) -> tuple[float, float] | None:
        return None if self.diameter is None or self.length is None else (self.diameter, self.length)

    def least_opening(self) -> float:
        if self.finished is not None:
            return self.finished[0]
        if self.bore is None:
            return self.diameter
        if not self.ringed:
            return self.bore[0]
        return self.bore[0] - 2 * self.wall[-1] if self.wall is not None else self.diameter

    def size_keys(self) -> tuple[str, ...]:
        return dotted(PlainRow.diameter), dotted(PlainRow.length)

    def size_words(self) -> Text:
        return Text(
            "⌀{diameter} × {length}", diameter=Amount(self.diameter * 1e3), length=Amount(self.length * 1e3, "mm")
        )

    def fed(self) -> bool:
        return True

    @property
    def limited(self) -> bool:
        """Whether the limits of journal and bore make the clearance."""
        return self.journal is not None and (self.bore is not None or self.finished is not None)

    @property
    def _wall(self) -> float:
        """Of what is pressed in, at most."""
        return self.wall[-1] if self.ringed and self.wall is not None else 0.0

    @property
    def ringed(self) -> bool:
        """Whether something is pressed into the housing."""
        return self.seat != "direct"

    def kind_problems(self) -> Iterable[tuple[str, Text]]:
        if self.bore is not None and len(self.bore) != 2:
            yield dotted(PlainRow.bore), Text("must be a list of numbers, least and most")
            return
        if self.clearance is not None and self.clearance_factor is not None:
            both = Text(
                "give either clearance_um or clearance_factor, one of the two; `--set ….{row}.clearance_factor=` takes "
                "that out",
                row=self.name,
            )
            yield dotted(PlainRow.clearance), both
        if self.clearance is not None and self.diameter is not None and self.clearance >= 0.1 * self.diameter:
            yield dotted(PlainRow.clearance), Text("must stay below a tenth of the diameter")
        if self.diameter is not None:
            around = max(self.diameter, self.bore[-1] if self.bore is not None else self.diameter + 2 * self._wall)
            held = Text("must be larger than {seat}: the carrier holds the seat", seat=Amount(around * 1e3, "mm"))
            for carrier, size in ((PlainRow.carrier_bore, self.carrier_bore), (PlainRow.carrier, self.carrier)):
                if size is not None and size[0] <= around:
                    yield dotted(carrier), held
        yield from self._limits()
        yield from self._seat()

    def _limits(self) -> Iterable[tuple[str, Text]]:
        """Pairs of least and most, and what they leave to say."""
        for key, pair in (
            (PlainRow.journal, self.journal),
            (PlainRow.bore, self.bore),
            (PlainRow.wall, self.wall),
            (PlainRow.finished, self.finished),
            (PlainRow.interference, self.interference),
            (PlainRow.crush, self.crush),
            (PlainRow.carrier_bore, self.carrier_bore),
            (PlainRow.carrier, self.carrier),
        ):
            if pair is not None and pair[0] > pair[-1]:
                yield dotted(key), Text("least before most")
        if self.limited:
            instead = Text("leave it out: journal_mm and the bore make the clearance")
            for other, there in (
                (PlainRow.clearance, self.clearance),
                (PlainRow.clearance_factor, self.clearance_factor),
                (PlainRow.journal_fit, self.journal_fit),
                (PlainRow.seat_fit, self.seat_fit),
            ):
                if there is not None:
                    yield dotted(other), instead
        for key, pair in ((PlainRow.journal, self.journal), (PlainRow.finished, self.finished)):
            if pair is not None and self.diameter is not None and not near(self.diameter, (pair,)):
                yield (
                    dotted(key),
                    Text(
                        "is not the size of diameter_mm, {diameter}",
                        diameter=Amount(self.diameter * 1e3, "mm", form="g"),
                    ),
                )
        yield from self._bore()

    def _bore(self) -> Iterable[tuple[str, Text]]:
        """Whether the running bore goes with the journal, and the housing's with the walls too."""
        finished = self.finished if self.seat == "bush" else None
        running = ((PlainRow.finished, finished), (PlainRow.bore, None if self.ringed else self.bore))
        for key, bore in running:
            if bore is not None and self.journal is None:
                yield dotted(key), Text("needs journal_mm beside it: both make the clearance")
            elif bore is not None and self.journal is not None and sum(bore) <= sum(self.journal):
                yield dotted(key), Text("must be larger than journal_mm")
        if self.bore is None or self.diameter is None:
            return
        if not self.ringed and not near(self.diameter, (self.bore,)):
            size = Amount(self.diameter * 1e3, "mm", form="g")
            yield dotted(PlainRow.bore), Text("is not the size of diameter_mm, {diameter}", diameter=size)
        if not self.ringed or self.wall is None:
            return
        walls = self.wall[0] + self.wall[-1]
        if self.journal is not None and self.finished is None and _leaves(self.bore, self.journal) < walls - SET:
            yield dotted(PlainRow.bore), Text("leaves no clearance: two walls and journal_mm are larger")
        elif not near(d := self.diameter + 2 * self.wall[-1], (self.bore,)):
            size = Amount(d * 1e3, "mm", form="g")
            yield dotted(PlainRow.bore), Text("is not the size of diameter_mm and two walls, {size}", size=size)

    def idle(self) -> Iterable[tuple[str, Text]]:
        """What says nothing with its seat; of the bearing of a twin as it is with what its original has."""
        for key, words in SAYS_WITH.items():
            entry = keys(PlainRow)[key]
            if self.seat and self.seat not in words and getattr(self, entry.attribute) != entry.field.default:
                of = " or ".join(f'seat = "{word}"' for word in words)
                yield key, Text("belongs to {seats}", seats=of)

    def _seat(self) -> Iterable[tuple[str, Text]]:
        """What seat, bush and shells need."""
        if self.crush is not None and self.interference is not None:
            yield dotted(PlainRow.crush), Text("give either crush_um or interference_um, one of the two")
        if self.bore_ == "finished" and self.finished is None:
            yield dotted(PlainRow.finished), Text('needed with bore = "finished"')
        if self.bore_ != "finished" and self.finished is not None and self.seat == "bush":
            yield dotted(PlainRow.finished), Text('belongs to bore = "finished"')
        if self.housing_outer is not None and self.ringed and self.diameter is not None and self.wall is not None:
            bore = self.bore[-1] if self.bore is not None else self.diameter + 2 * self.wall[-1]
            if self.housing_outer <= bore + LEAST_METAL:
                yield dotted(PlainRow.housing_outer), more_metal(bore)


def _leaves(bore: tuple[float, ...], journal: tuple[float, ...]) -> float:
    """Between their middles, in diameter."""
    return (sum(bore) - sum(journal)) / 2


def near(diameter: float, limits: Sequence[tuple[float, ...]]) -> bool:
    """Whether a diameter is meant by limits, the first and the last of their classes: within a hundredth of itself.
    One that is no number, of which that is said, is."""
    return not (diameter < limits[0][0] - diameter / 100 or diameter > limits[-1][-1] + diameter / 100)


SET = 40e-6  # m: by so much, at most, a seated bore stands wider than housing and walls leave it

# what says nothing but with these seats
RINGED = ("bush", "shells")
SAYS_WITH = {
    **dict.fromkeys(
        map(
            dotted,
            (
                PlainRow.wall,
                PlainRow.interference,
                PlainRow.housing_outer,
                PlainRow.backing,
                PlainRow.retained,
            ),
        ),
        RINGED,
    ),
    **dict.fromkeys(map(dotted, (PlainRow.bore_, PlainRow.finished)), ("bush",)),
    **dict.fromkeys(
        map(
            dotted,
            (
                PlainRow.crush,
                PlainRow.crush_load,
                PlainRow.spread,
                PlainRow.relief,
                PlainRow.relief_length,
            ),
        ),
        ("shells",),
    ),
}


PRESSES = {"interference", "crush"}  # what may say how a bush is pressed
