# SPDX-License-Identifier: Apache-2.0
"""What the plain bearings of all shafts share: their oil, its supply, housing and temperatures."""

from collections.abc import Iterable
from math import pi
from typing import ClassVar

from ...countershaft.rows import BearingRow, called
from ...library import journal_rules as rules
from ...library import tolerances as fits
from ...library.catalogue import Oil
from ...library.tolerances import ASSUMED_FIT, Assumed
from ...sheet.quantity import as_in, choice, described, dotted, inputs, quantity, series, table, text
from ...sheet.record import replace
from ...sheet.text import Amount, Text
from ...sheet.units import Radian
from ..row import ASKED_ELSEWHERE, LEAST_METAL, more_metal
from .materials import DEFAULT_APPLICATION, bush_problem
from .row import PlainRow, near
from .seats.classes import Select

# of the journal's speed: below, the load turns at half the speed of the surfaces; rule of this program
LEAST_SPEED_SHARE = 0.02

SLOPE_TAKEN: Radian = 0.1e-3  # of the journal in its seat, where nothing is known of it; rule of this program

# the folds of the form
MATERIALS = Text("Materials and fits")
BY_CLASSES = Text("Classes")


@inputs
class PlainInputs:
    """Oil, supply, housing and temperatures of the bearings; each has its sizes in its row of [[shafts.bearings]]."""

    REFUSED: ClassVar[dict[str, Text]] = dict.fromkeys(
        ("front", "rear", dotted(BearingRow.slope)), Text("stands in a row of [[shafts.bearings]] since schema 2")
    )

    oil: str = text(
        "Oil",
        help="A name from the table of oils or from [[oil]].",
        change=("thinner oil", "thicker oil", "another oil"),
        catalogue="oils",
        decides=1,
        taken_by=("friction",),
    )
    supply_temperature: float = quantity(
        "Supply temperature",
        "°C",
        within=(-40, 200),
        symbol="T_in",
        step=1,
        rule_of_thumb=(70, 130),
        help="Of the oil in the gallery before the bearing.",
        repair="asked",
        decides=2,
        taken_by=("friction",),
    )
    supply_pressure: float = quantity(
        "Supply pressure",
        "bar",
        default=ASKED_ELSEWHERE,
        within=(0, 100),
        symbol="p_s",
        step=0.1,
        rule_of_thumb=(1, 6),
        help="Of the oil in the gallery, above ambient.",
        change=("less oil pressure", "more oil pressure"),
        repair="free",
    )
    supply: str = as_in(BearingRow.supply, default=ASKED_ELSEWHERE)
    hole_diameter: float | None = as_in(BearingRow.hole_diameter, default=None)
    housing_material: str = as_in(BearingRow.housing_material, fold=MATERIALS, taken_by=("gears",))
    housing_stiffness: float | None = quantity(
        "Stiffness of the housing",
        "N/mm",
        default=None,
        up_to=1e9,
        symbol="K_H",
        rule_of_thumb=(1e5, 1e7),
        help="Under one bearing, radially, for the critical speed on the films. Left out: rigid.",
        fold=MATERIALS,
    )
    groove_width: float | None = as_in(BearingRow.groove_width, default=None)
    pocket_width: float | None = as_in(BearingRow.pocket_width, default=None)
    groove_arc: tuple[float, ...] | None = as_in(
        BearingRow.groove_arc, default=None, help="Angles from the load, 180 opposite to it. Left out: all round."
    )
    supply_angle: float = as_in(BearingRow.supply_angle, default=pi)
    pocket_length: float | None = as_in(BearingRow.pocket_length, default=None)
    axial_groove_angles: tuple[float, ...] | None = as_in(BearingRow.axial_groove_angles, default=None)
    axial_groove_width: float | None = as_in(BearingRow.axial_groove_width, default=None)
    axial_groove_length: float | None = as_in(BearingRow.axial_groove_length, default=None)
    lubrication: str = choice(
        "Lubrication",
        *rules.LUBRICATIONS,
        default=rules.COOLED,
        source="Finotti 2013, Table 3.1",
        help="The row of the source's table that the heat index is held against: how the oil comes, and what cools.",
    )
    housing_temperature: float | None = quantity(
        "Housing temperature",
        "°C",
        default=None,
        within=(-40, 200),
        symbol="T_H",
        step=5,
        help="Of the metal around bushes and shells while the engine is hot. Left out: that of the film.",
        repair="asked",
        fold=MATERIALS,
    )
    select: Select | None = table("Shells by classes", Select, default=None, fold=BY_CLASSES)
    expansion_restraint: float = quantity(
        "Expansion held back",
        default=0.0,
        within=(0, 1),
        symbol="chi",
        step=0.05,
        help="Share of the housing's thermal expansion that the block holds back.",
        fold=MATERIALS,
    )
    bush_material: str | None = as_in(
        BearingRow.bush_material,
        default=None,
        help="A name from the table of bearing materials. Left out: the journal runs on the housing itself.",
        fold=MATERIALS,
    )
    journal_material: str | None = text(
        "Journal material",
        default=None,
        help="Left out: that of the counter-shaft.",
        catalogue="materials",
        fold=MATERIALS,
    )
    application: str = text(
        "Application",
        default=DEFAULT_APPLICATION,
        help="The row of the table of usual loads to be held against.",
        catalogue="applications",
        fold=MATERIALS,
    )
    clearance_reference_temperature: float = quantity(
        "Clearance given at",
        "°C",
        default=20.0,
        within=(-60, 250),
        symbol="T_ref",
        source="ISO 1: 20 °C",
        help="Temperature at which bore and journal have their measures.",
        repair="asked",
        fold=MATERIALS,
    )
    lowest_temperature: float = quantity(
        "Lowest temperature",
        "°C",
        default=-20.0,
        within=(-60, 60),
        symbol="T_low",
        rule_of_thumb=(-40, 0),
        help="Cold start: the clearance must still be there.",
        repair="asked",
    )
    outlet_temperature_limit: float = quantity(
        "Outlet temperature limit",
        "°C",
        default=135.0,
        within=(50, 250),
        symbol="T_lim",
        usual=(rules.TRUMPLER_TEMPERATURE, 135),
        source="Finotti 2013, 5.5.1: Trumpler, engine manual",
        help="Highest temperature of the oil that leaves.",
    )
    journal_fit: str = as_in(BearingRow.journal_fit, default=ASSUMED_FIT, fold=MATERIALS)
    seat_fit: str = as_in(BearingRow.seat_fit, default=ASSUMED_FIT, fold=MATERIALS)
    viscosity_tolerance: float = quantity(
        "Viscosity tolerance ±",
        "%",
        default=0.1,
        within=(0, 50),
        symbol="t_nu",
        step=1,
        usual=(0, 10),
        source="ISO 3448: a grade ±10 % at 40 °C",
        help="How far the oil may be from its own viscosity.",
    )
    speed: float | None = quantity(
        "Journal speed",
        "rpm",
        default=None,
        up_to=1e5,
        symbol="n",
        step=50,
        help="Speed of the journal. Left out: that of the counter-shaft.",
        repair="asked",
    )
    load_speed_ratio: float = quantity(
        "Speed of the load over the journal's",
        default=1.0,
        within=(-10, 10),
        symbol="i_F",
        step=0.5,
        source="ISO 7902-1",
        help="1: the load turns with the shaft, as that of eccentric masses. 0: it stands. At ½ no film is built up.",
    )
    bush_speed_ratio: float = quantity(
        "Speed of the bush over the journal's",
        default=0.0,
        within=(-10, 10),
        symbol="i_B",
        step=0.5,
        source="ISO 7902-1",
        help="How fast the bush turns with the journal; 0: the seat stands.",
    )
    speed_range: tuple[float, ...] | None = series(
        "Speed range",
        "rpm",
        default=None,
        count=(2, 2),
        up_to=1e5,
        symbol="n",
        help="From and to, at the design's oil supply. Left out: the engine's bench run, else 0.4 to 1 of the speed.",
        repair="asked",
    )
    overspeed: float = quantity(
        "Overspeed",
        "%",
        default=0.1,
        within=(0, 50),
        symbol="s",
        step=1,
        usual=(5, 20),
        source="rule of this program",
        help="How far the highest speed may be passed over: the film is solved there too.",
    )
    coaxiality: float = quantity(
        "Coaxiality of the bores",
        "µm",
        default=0.0,
        within=(0, 1000),
        symbol="t",
        step=5,
        source="rule of thumb, from what makers allow: 0.02 mm",
        help="Diameter of the zone in which the axes of all bores lie, makers allow 20; on more than two bearings a "
        "shaft is loaded by bores out of line.",
        fold=MATERIALS,
    )
    roughness_ratio: float = quantity(
        "Rt/Ra",
        default=7.5,
        within=(1, 30),
        symbol="k_R",
        usual=(6, 7.5),
        source="Kreisle, after Finotti 2013, 5.5.3",
        help="Peak-to-valley over mean roughness of both surfaces.",
        fold=MATERIALS,
    )
    viscosity_law: str = choice(
        "Viscosity law",
        "walther",
        "d341",
        default="walther",
        help="walther: ν + 0.6, as in the source. d341: ν + 0.7, ASTM D341.",
    )
    viscosity: float | None = quantity(
        "Dynamic viscosity at every temperature",
        "mPa·s",
        default=None,
        up_to=1e6,
        symbol="mu_given",
        help="Constant, as in textbooks (1 cP is 1 mPa·s, 1 µreyn 6.895), in the bearings only. Left out: by the "
        "oil's own law.",
    )

    def in_bearings(self, oil: Oil) -> Oil:
        """An oil as it is in the bearings: with their viscosity at every temperature, where that is given."""
        if self.viscosity is None:
            return oil
        return replace(oil, nu40=None, nu100=None, viscosities=(), viscosity=self.viscosity)

    @property
    def fits_given(self) -> bool:
        """Whether the tolerances are the design's own; else the program assumed them."""
        return not (isinstance(self.journal_fit, Assumed) and isinstance(self.seat_fit, Assumed))

    def plain_problems(self) -> Iterable[tuple[str, Text]]:
        yield from self.of_seat()
        if abs(1 + self.bush_speed_ratio - 2 * self.load_speed_ratio) < LEAST_SPEED_SHARE:
            why = Text(
                "the load would turn at half the speed of the surfaces, where no film is built up; must be away from "
                "{bush_speed_ratio} by {least_speed_share} or more",
                bush_speed_ratio=Amount((1 + self.bush_speed_ratio) / 2, form="g"),
                least_speed_share=Amount(LEAST_SPEED_SHARE / 2, form="g"),
            )
            yield dotted(PlainInputs.load_speed_ratio), why
        if self.bush_speed_ratio == 1:
            why = Text("a bush that turns with the journal does not slide on it; anything but 1 is allowed")
            yield dotted(PlainInputs.bush_speed_ratio), why
        if self.speed_range is not None and self.speed_range[0] >= self.speed_range[1]:
            yield dotted(PlainInputs.speed_range), Text("must rise: from, to")

    def of_seat(self) -> Iterable[tuple[str, Text]]:
        """What is wrong with supply and seat, whose keys may stand in a row as well."""
        hole, groove, pocket, axial_length = self._widths
        axial: tuple[tuple[str, object], ...] = (
            (dotted(PlainInputs.axial_groove_angles), self.axial_groove_angles),
            (dotted(PlainInputs.axial_groove_width), self.axial_groove_width),
            axial_length,
        )
        needs = {"hole": (hole,), "shaft": (hole,), "groove": (groove,), "pocket": (pocket,), "axial_groove": axial}
        for key, given in needs.get(self.supply, ()):
            if given is None:
                yield key, Text('needed with supply = "{supply}"', supply=self.supply)
        if self.supply == "axial_groove" and self.load_speed_ratio != self.bush_speed_ratio:
            why = Text(
                "a load that sweeps over axial grooves has no steady film: they need load_speed_ratio = "
                "bush_speed_ratio"
            )
            yield dotted(PlainInputs.supply), why
        if self.groove_arc and self.groove_arc[0] >= self.groove_arc[1]:
            yield dotted(PlainInputs.groove_arc), Text("must rise: from, to")
        for name, of in (("journal_fit", "shaft"), ("seat_fit", "hole")):
            if (wrong := fits.problem(getattr(self, name), of)) is not None:
                yield name, wrong
        if self.bush_material is not None and (wrong := bush_problem(self.bush_material)) is not None:
            yield dotted(PlainInputs.bush_material), wrong

    @property
    def _widths(self) -> tuple[tuple[str, float | None], ...]:
        """What takes its width of the length of a bearing, by key."""
        return (
            (dotted(PlainInputs.hole_diameter), self.hole_diameter),
            (dotted(PlainInputs.groove_width), self.groove_width),
            (dotted(PlainInputs.pocket_width), self.pocket_width),
            (dotted(PlainInputs.axial_groove_length), self.axial_groove_length),
        )

    @property
    def widest_supply(self) -> float:
        """The widest, along the bearing, of what may bring the oil; 0: nothing has a width."""
        return max(width or 0.0 for _, width in self._widths)

    def _placed(self, row: PlainRow) -> bool:
        """Whether the fits of a bearing say where their fields lie, so that a clearance follows from them."""
        pairs = ((row.journal_fit or self.journal_fit, "shaft"), (row.seat_fit or self.seat_fit, "hole"))
        return all(fits.problem(fit, of) is None and fits.parse(fit).letter is not None for fit, of in pairs)

    def beside(self, row: BearingRow) -> Iterable[tuple[str, Text]]:
        """What these inputs do not allow of a bearing whose size is known, by their own keys."""
        angles, arc = self.axial_groove_angles, self.axial_groove_width
        if self.supply == "axial_groove" and angles is not None and arc is not None:
            turns = sorted(angle % (2 * pi) for angle in angles)
            apart = min(b - a for a, b in zip(turns, [*turns[1:], turns[0] + 2 * pi]))
            if apart <= 2 * arc / row.diameter:
                why = Text("the grooves of the {place} bearing overlap", place=called(row.name))
                yield dotted(PlainInputs.axial_groove_angles), why
        for key, width in self._widths:
            if width is not None and width >= row.length:
                why = Text(
                    "must be smaller than the length of the {place} bearing, {length}",
                    place=called(row.name),
                    length=Amount(row.length * 1e3, "mm"),
                )
                yield key, why

    def asked_of_plain(self, row: PlainRow) -> Iterable[tuple[str, Text]]:
        """What a plain bearing that these inputs judge still lacks, by the keys of its row."""
        for key, there in (
            (BearingRow.diameter, row.diameter),
            (BearingRow.length, row.length),
            (BearingRow.journal_roughness, row.journal_roughness),
            (BearingRow.housing_roughness, row.housing_roughness),
        ):
            if there is None:
                yield dotted(key), Text("is missing; needs {allowed}", allowed=described(key).allowed())
        sorted_ = self.select is not None and row.seat == "shells"
        if row.ringed and row.wall is None and not sorted_:
            yield dotted(BearingRow.wall), Text('needed with seat = "{seat}"', seat=row.seat)
        if sorted_:
            yield from self._by_classes(row)
        elif row.journal is not None and not row.limited:
            yield dotted(BearingRow.journal), Text("needs bore_mm beside it: both make the clearance")
        elif row.clearance is None and row.clearance_factor is None and not row.limited and not self._placed(row):
            letters = Text("journal_fit and seat_fit with their letters (f7, H7)")
            yield (
                dotted(BearingRow.clearance),
                Text("give clearance_um or clearance_factor, or journal_mm and bore_mm, or {letters}", letters=letters),
            )

    def _by_classes(self, row: PlainRow) -> Iterable[tuple[str, Text]]:
        """Shells whose clearance the classes make."""
        assert self.select is not None
        made = Text("leave it out: the classes of [bearings.select] make the clearance")
        for key, there in (
            (BearingRow.clearance, row.clearance),
            (BearingRow.clearance_factor, row.clearance_factor),
            (BearingRow.journal_fit, row.journal_fit),
            (BearingRow.seat_fit, row.seat_fit),
        ):
            if there is not None:
                yield dotted(key), made
        if row.wall is not None:
            yield dotted(BearingRow.wall), Text("leave it out: the walls are those of [bearings.select]")
        bores = self.select.bores
        if row.housing_outer is not None and bores and row.housing_outer <= bores[-1][1] + LEAST_METAL:
            yield dotted(BearingRow.housing_outer), more_metal(bores[-1][1])
        for limited, limits, classes in (
            (BearingRow.journal, row.journal, self.select.journals),
            (BearingRow.bore, row.bore, self.select.bores),
        ):
            if limits is not None and classes and not limits[0] <= classes[0][0] <= classes[-1][1] <= limits[-1]:
                yield dotted(limited), Text("the classes of [bearings.select] must lie within it")
        if row.diameter and self.select.journals and not near(row.diameter, self.select.journals):
            yield dotted(BearingRow.diameter), Text("is not the size of the journal classes of [bearings.select]")
