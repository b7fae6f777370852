# SPDX-License-Identifier: Apache-2.0
"""What a row of [[shafts.bearings]] says of a rolling bearing: its size, what is inside, how its rings sit."""

from collections.abc import Iterable
from functools import cached_property
from math import inf
from typing import TYPE_CHECKING

from ...sheet.quantity import choice, described, dotted, flag, inputs, integer, keys, quantity, series, text
from ...sheet.text import Amount, Text
from ...sheet.value import based_on
from ..row import LEAST_METAL, SupportRow, more_metal

if TYPE_CHECKING:
    from .geometry import Inside  # with numpy, which a form does not need
    from .sizes import BearingSize

KIND = SupportRow.kind
OWN = "own"
OWN_BORE = (5e-3, 0.2)  # m
SMALLEST = 1e-9  # m: less is rounding
INSIDE, RATINGS, FITS, RACEWAY = Text("Inside"), Text("Ratings"), Text("Rings and fits"), Text("Raceway on the shaft")
AXIAL = Text("a ball bearing (60, 62, 63) or NJ carries thrust")


@inputs
class RollingRow(SupportRow):
    """One rolling bearing in its place."""

    size: str | None = text(
        "Size",
        default=None,
        help="Its designation: 6205, NU205, NJ2304, NA4905, RNA4905, HK2520, K25x30x20; or own, with its outline.",
        where=(KIND, "rolling"),
        decides=7,
        change=("another size",),
    )
    elements: str | None = choice(
        "Elements", "ball", "roller", default=None, help="Of size = own.", where=(KIND, "rolling"), fold=INSIDE
    )
    outside_diameter: float | None = quantity(
        "Outside diameter",
        "mm",
        default=None,
        within=(5, 200),
        symbol="D",
        help="Of size = own; bore_mm beside it.",
        where=(KIND, "rolling"),
        fold=INSIDE,
        repair="asked",
    )
    width: float | None = quantity(
        "Width",
        "mm",
        default=None,
        within=(5, 200),
        symbol="B",
        help="Of size = own.",
        where=(KIND, "rolling"),
        fold=INSIDE,
        repair="asked",
    )
    element_count: int | None = integer(
        "Number of elements",
        default=None,
        within=(3, 60),
        symbol="Z",
        help="Balls, rollers or needles of the bearing. Left out: typical of the type, an estimate.",
        where=(KIND, "rolling"),
        fold=INSIDE,
        repair="asked",
    )
    element_diameter: float | None = quantity(
        "Diameter of an element",
        "mm",
        default=None,
        up_to=100,
        symbol="D_w",
        help="Of a ball, roller or needle. Left out: typical of the type, an estimate.",
        where=(KIND, "rolling"),
        fold=INSIDE,
        repair="asked",
    )
    element_length: float | None = quantity(
        "Effective length of a roller",
        "mm",
        default=None,
        up_to=200,
        symbol="L_we",
        help="Of the line on which a roller carries. Left out: typical of the type, an estimate.",
        where=(KIND, "rolling"),
        fold=INSIDE,
        repair="asked",
    )
    pitch_diameter: float | None = quantity(
        "Pitch diameter",
        "mm",
        default=None,
        up_to=300,
        symbol="D_pw",
        help="Of the elements' centres. Left out: typical of the type, an estimate.",
        where=(KIND, "rolling"),
        fold=INSIDE,
        repair="asked",
    )
    contact_angle: float = quantity(
        "Contact angle",
        "°",
        default=0.0,
        within=(0, 45),
        symbol="alpha",
        help="Of balls. Angular contact bearings carry thrust by themselves: they are not modelled.",
        where=(KIND, "rolling"),
        fold=INSIDE,
        repair="asked",
    )
    groove_inner: float = quantity(
        "Groove of the inner ring over D_w",
        default=0.52,
        within=(0.505, 0.6),
        symbol="f_i",
        help="Radius of the groove over the diameter of a ball.",
        where=(KIND, "rolling"),
        fold=INSIDE,
        repair="asked",
    )
    groove_outer: float = quantity(
        "Groove of the outer ring over D_w",
        default=0.52,
        within=(0.505, 0.6),
        symbol="f_e",
        help="Radius of the groove over the diameter of a ball.",
        where=(KIND, "rolling"),
        fold=INSIDE,
        repair="asked",
    )
    dynamic_rating: float | None = quantity(
        "Dynamic load rating",
        "kN",
        default=None,
        within=(0.1, 1000),
        symbol="C",
        help="Of the maker's catalogue. Left out: ISO 281 with the typical inside, an estimate.",
        where=(KIND, "rolling"),
        fold=RATINGS,
        repair="asked",
    )
    static_rating: float | None = quantity(
        "Static load rating",
        "kN",
        default=None,
        within=(0.1, 1000),
        symbol="C_0",
        help="Of the maker's catalogue. Left out: ISO 76 with the typical inside, an estimate.",
        where=(KIND, "rolling"),
        fold=RATINGS,
        repair="asked",
    )
    fatigue_limit: float | None = quantity(
        "Fatigue load limit",
        "kN",
        default=None,
        within=(0.001, 1000),
        symbol="C_u",
        help="Of the maker's catalogue. Left out: by C_0, ISO 281.",
        where=(KIND, "rolling"),
        fold=RATINGS,
        repair="asked",
    )
    split_cage: bool = flag(
        "Split cage",
        default=False,
        help="Of needle cages K: in two halves or with a clasp, so that nothing has to slide over the shaft.",
        where=(KIND, "rolling"),
        fold=INSIDE,
    )
    cage: str = choice(
        "Cage",
        "polyamide",
        "steel",
        default="polyamide",
        help="Polyamide: 120 °C; steel: 150 °C.",
        where=(KIND, "rolling"),
        fold=INSIDE,
    )
    locates: bool = flag(
        "Locates the shaft",
        default=False,
        help="Takes the shaft's thrust: a ball bearing or NJ; one of a shaft.",
        where=(KIND, "rolling"),
        decides=8,
    )
    standing_load: float | None = quantity(
        "Standing load",
        "N",
        default=None,
        within=(0, 1e7),
        symbol="F_2",
        help="Of a bearing that stands alone: what does not turn, weight and gear force. A shaft knows it.",
        where=(KIND, "rolling"),
        repair="asked",
    )
    axial_load: float | None = quantity(
        "Axial load",
        "N",
        default=None,
        within=(0, 1e7),
        symbol="F_a",
        help="On the bearing that locates. Left out: the thrust of the shaft's gear.",
        where=(KIND, "rolling"),
        repair="asked",
    )
    clearance_class: str = choice(
        "Clearance class",
        "CN",
        "C3",
        "C4",
        "C5",
        default="C3",
        help="Radial clearance before mounting, ISO 5753.",
        where=(KIND, "rolling"),
        fold=FITS,
    )
    clearance_limits: tuple[float, ...] | None = series(
        "Clearance before mounting",
        "µm",
        default=None,
        count=(2, 2),
        within=(-100, 1000),
        symbol="s_0",
        help="Least and most, in place of the class; a list under clearance_um says the same.",
        where=(KIND, "rolling"),
        fold=FITS,
    )
    shaft_fit: str | None = text(
        "Fit on the shaft",
        default=None,
        help="ISO 286. The load turns with the shaft: the inner ring may sit loose. Left out: js6; of a raceway on the "
        "shaft h5.",
        where=(KIND, "rolling"),
        fold=FITS,
        change=("looser on the shaft", "tighter on the shaft", "another fit on the shaft"),
    )
    outer_ring_held: str = choice(
        "Hold of the outer ring",
        "fit",
        "insert",
        "pin",
        "adhesive",
        "clamped",
        default="fit",
        help="fit: by its interference alone, which is judged. insert: a sleeve of iron or steel cast in, and judged; "
        "what a pin, an adhesive or a clamp carries is not.",
        where=(KIND, "rolling"),
        fold=FITS,
    )
    raceway_hardness: float = quantity(
        "Hardness of the raceway",
        "HV",
        default=700.0,
        within=(300, 900),
        symbol="H_V",
        rule_of_thumb=(670, 840),
        help="Of the shaft, where needles run on it.",
        where=(KIND, "rolling"),
        fold=RACEWAY,
    )
    raceway_roughness: float = quantity(
        "Roughness Ra of the raceway",
        "µm",
        default=0.2e-6,
        within=(0, 10),
        symbol="Ra_1",
        rule_of_thumb=(0.05, 0.2),
        help="Of the shaft, where needles run on it.",
        where=(KIND, "rolling"),
        fold=RACEWAY,
    )
    case_depth: float | None = quantity(
        "Depth of the hard case",
        "mm",
        default=None,
        within=(0, 20),
        symbol="h_c",
        help="Of the shaft, where needles run on it.",
        where=(KIND, "rolling"),
        fold=RACEWAY,
    )
    limiting_speed: float | None = quantity(
        "Limiting speed",
        "rpm",
        default=None,
        up_to=1e6,
        symbol="n_lim",
        help="Of the maker's catalogue. Left out: by n·d_m of the type.",
        where=(KIND, "rolling"),
        fold=RATINGS,
        repair="asked",
    )
    minimum_load: float | None = quantity(
        "Minimum load",
        "N",
        default=None,
        up_to=1e7,
        symbol="F_min",
        help="Below which the elements slip. Left out: by the type's rule.",
        where=(KIND, "rolling"),
        fold=RATINGS,
        repair="asked",
    )
    palmgren_f0: float | None = quantity(
        "Factor f0 of the two-part formula",
        default=None,
        up_to=100,
        symbol="f_0",
        help="Given: the friction is that of the two-part formula.",
        where=(KIND, "rolling"),
        fold=RATINGS,
        repair="asked",
    )
    palmgren_f1: float | None = quantity(
        "Factor f1 of the two-part formula",
        default=None,
        up_to=1,
        symbol="f_1",
        help="Given: the friction is that of the two-part formula.",
        where=(KIND, "rolling"),
        fold=RATINGS,
        repair="asked",
    )
    heat: float | None = quantity(
        "Heat carried off",
        "W/K",
        default=None,
        up_to=1e4,
        symbol="hA",
        help="Of the seat and the oil, over the oil's temperature. Left out: by the seat's surface, ISO 15312.",
        where=(KIND, "rolling"),
        fold=RATINGS,
        repair="asked",
    )
    temperature_limit: float | None = quantity(
        "Temperature limit",
        "°C",
        default=None,
        within=(50, 250),
        symbol="T_lim",
        help="Up to which rings and cage may be used. Left out: that of the cage.",
        where=(KIND, "rolling"),
        fold=RATINGS,
        repair="asked",
    )

    @cached_property
    def outline(self) -> "BearingSize[float] | None":
        """Its boundary dimensions; None where they are not known."""
        from .sizes import Elements, UnknownSize, own_size, size_of

        if self.size is None:
            return None
        if self.size.strip().casefold() == OWN:
            if self.elements is None or self.bore is None or self.outside_diameter is None or self.width is None:
                return None
            elements: Elements = "ball" if self.elements == "ball" else "roller"
            return own_size(elements, self.bore[0], self.outside_diameter, self.width)
        try:
            return size_of(self.size)
        except UnknownSize:
            return None

    @cached_property
    def inside(self) -> "Inside[float] | None":
        """What is inside, as given, else typical of its type; None of one of its own of which it is not known."""
        from .geometry import inside_of

        if self.outline is None:
            return None
        return inside_of(
            self.outline,
            split_cage=self.split_cage,
            count=self.element_count,
            diameter=self.element_diameter,
            length=self.element_length,
            pitch=self.pitch_diameter,
            groove_inner=self.groove_inner,
            groove_outer=self.groove_outer,
        )

    def place(self) -> tuple[float, float] | None:
        """Bore, or the raceway on the shaft, and width."""
        if (size := self.outline) is None:
            return None
        if size.own:
            assert self.bore is not None and self.width is not None
            return self.bore[0], self.width
        return based_on(size.bore, self.size), based_on(size.width, self.size)

    def opening(self) -> float:
        """That of its seat without the bearing; one that is clamped sits in a flange, mounted after the shaft."""
        assert self.outline is not None
        if self.outer_ring_held == "clamped":
            return inf
        return based_on(self.outline.outside, self.outside_diameter if self.outline.own else self.size)

    def size_keys(self) -> tuple[str, ...]:
        return (dotted(RollingRow.size),)

    def size_words(self) -> Text:
        size = self.outline
        assert size is not None
        if not size.own:
            return Text("{size}", size=size.designation)
        sizes = {
            name: Amount(x * 1e3, unit)
            for name, x, unit in (("d", size.bore, ""), ("D", size.outside, ""), ("B", size.width, "mm"))
        }
        return Text("{d}/{D} × {B}", **sizes)

    def kind_problems(self) -> Iterable[tuple[str, Text]]:
        from ...library import tolerances
        from .sizes import UnknownSize, size_of

        if self.size is None:
            yield dotted(RollingRow.size), Text('needed with kind = "rolling"; 6205, NU205, HK2520, …, or own')
            return
        own = self.size.strip().casefold() == OWN
        if own:
            yield from self._own()
        else:
            try:
                size_of(self.size)
            except UnknownSize as wrong:
                yield dotted(RollingRow.size), wrong.text
            for key, there in (
                (RollingRow.elements, self.elements),
                (RollingRow.bore, self.bore),
                (RollingRow.outside_diameter, self.outside_diameter),
                (RollingRow.width, self.width),
            ):
                if there is not None:
                    yield dotted(key), Text('belongs to size = "own"; {size} has its own', size=self.size)
        if (size := self.outline) is None:
            return
        if size.outside <= size.bore:
            yield dotted(RollingRow.outside_diameter if own else RollingRow.size), Text("must be larger than the bore")
            return
        if self.housing_outer is not None and self.housing_outer <= size.outside + LEAST_METAL:
            yield dotted(RollingRow.housing_outer), more_metal(size.outside)
        yield from self._thrust()
        yield from self._raceway()
        yield from self._elements()
        if self.contact_angle:
            alone = Text("an angular contact bearing carries thrust by itself; pairs are not modelled")
            yield dotted(RollingRow.contact_angle), alone
        if self.split_cage and size.type != "cage":
            yield dotted(RollingRow.split_cage), Text("belongs to a needle cage, K…")
        for key, fit, of in (
            (RollingRow.shaft_fit, self.shaft_fit, "shaft in a ring"),
            (RollingRow.seat_fit, self.seat_fit, "hole for a ring"),
        ):
            if fit is not None and (wrong_fit := tolerances.problem(fit, of)) is not None:
                yield dotted(key), wrong_fit
        if self.clearance_limits is not None and self.clearance_limits[0] > self.clearance_limits[1]:
            yield dotted(RollingRow.clearance_limits), Text("least before most")

    def _own(self) -> Iterable[tuple[str, Text]]:
        for key, there in (
            (RollingRow.elements, self.elements),
            (RollingRow.bore, self.bore),
            (RollingRow.outside_diameter, self.outside_diameter),
            (RollingRow.width, self.width),
        ):
            if there is None:
                yield dotted(key), Text('needed with size = "own"; needs {allowed}', allowed=described(key).allowed())
        if self.bore is not None and (len(self.bore) != 1 or not OWN_BORE[0] <= self.bore[0] <= OWN_BORE[1]):
            yield dotted(RollingRow.bore), Text("must be one number from 5 to 200 mm: the bore of the bearing")
        inside = [self.element_count, self.element_diameter, self.pitch_diameter]
        if self.elements == "roller":
            inside.append(self.element_length)
        if None in inside and (self.dynamic_rating is None or self.static_rating is None):
            missing = Text(
                "give element_count, element_diameter_mm, pitch_diameter_mm and of rollers element_length_mm, or both "
                "dynamic_rating_kN and static_rating_kN"
            )
            yield dotted(RollingRow.size), missing

    def _thrust(self) -> Iterable[tuple[str, Text]]:
        size = self.outline
        if size is None or size.type == "ball" or size.flanged:
            return
        none = Text("{size} carries no thrust; {others}", size=self.size or "", others=AXIAL)
        if self.locates:
            yield dotted(RollingRow.locates), none
        if self.axial_load:
            yield dotted(RollingRow.axial_load), none

    def _raceway(self) -> Iterable[tuple[str, Text]]:
        if self.outline is None or not self.outline.inner_ring:
            return
        for key in (RollingRow.raceway_hardness, RollingRow.raceway_roughness, RollingRow.case_depth):
            entry = keys(RollingRow)[dotted(key)]
            if getattr(self, entry.attribute) != entry.field.default:
                yield dotted(key), Text("belongs to a bearing without inner ring, whose raceway is the shaft")

    def _elements(self) -> Iterable[tuple[str, Text]]:
        """Whether the elements find room beside each other and between the rings."""
        from .geometry import diameters_of, overlap

        size, D_w = self.outline, self.element_diameter
        assert size is not None
        if self.element_length is not None and self.element_length >= size.width:
            wide = Amount(size.width * 1e3, "mm", form="g")
            yield dotted(RollingRow.element_length), Text("must be below {wide}, the width of the bearing", wide=wide)
        if D_w is not None and D_w >= (size.outside - size.bore) / 2:
            least = Amount((size.outside - size.bore) / 2 * 1e3, "mm")
            yield dotted(RollingRow.element_diameter), Text("must be below {least}, the room of the rings", least=least)
        elif D_w is None and size.own:
            return
        elif self.pitch_diameter is not None and not _between(size, *diameters_of(size, D_w, self.pitch_diameter)):
            ends = {"bore": Amount(size.bore * 1e3, form="g"), "outside": Amount(size.outside * 1e3, "mm", form="g")}
            why = Text("the elements must lie between {bore} and {outside}: D_pw − D_w and D_pw + D_w", **ends)
            yield dotted(RollingRow.pitch_diameter), why
        elif (inside := self.inside) is not None and overlap(inside):
            given = RollingRow.element_count if self.element_count is not None else RollingRow.element_diameter
            yield dotted(given), Text("the elements overlap: Z·asin(D_w/D_pw) must stay below π")


def _between(size: "BearingSize[float]", D_w: float, D_pw: float) -> bool:
    """Whether raceways over and under the elements lie between bore and outside."""
    return D_pw - D_w > size.bore - SMALLEST and D_pw + D_w < size.outside + SMALLEST
