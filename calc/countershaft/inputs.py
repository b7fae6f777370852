# SPDX-License-Identifier: Apache-2.0
"""The counter-rotating shaft: its eccentric masses or the envelope to size it in, its outline, its supports, its
making."""

import math
from collections.abc import Iterable
from itertools import pairwise

from ..library.tolerances import BALANCE_GRADES
from ..sheet.quantity import choice, described, dotted, inputs, integer, keys, quantity, series, table, tables, text
from ..sheet.text import Amount, Text
from .balancing.inputs import Balancing, Stretch
from .balancing.inputs import problems as balancing_problems
from .making.inputs import Bolts, Cost, FurtherBolts, FurtherDrain, OilDrain, Part, ShaftSupport
from .rows import ASKED_ELSEWHERE, OF_ORIGINAL, BearingRow, said_in

THREADED = 0.2e-3  # m: clearance for threading in, where the program chooses the radius; rule of this program
ANGLE = Text("With cylinder 1 at TDC, from up, in the sense of crank rotation.")
FROM_MID_SHAFT = Text("From mid-shaft, + towards the flywheel.")

# words that follow the step in the ids of values and checks, where the name of a shaft stands too
NO_NAMES = (
    "all", "alternative", "balancing", "bolts", "co2", "couple", "drain", "envelope", "fatigue", "fillet", "force",
    "fuel", "holes", "inertia", "journals", "mass", "residual", "roll", "scatter", "scenarios", "sector", "shafts",
    "support", "train", "utilisation", "weight",
)  # fmt: skip

# the folds of the form
AROUND = Text("Cover, and what hangs on the shaft")
SUPPORT = Text("Support, drain, cost")
LAID_IN = ("split", "caps", "module")  # ways of assembly in which nothing has to pass a seat


@inputs
class EccentricMass:
    """One eccentric mass of the shaft."""

    name: str = text("Name")
    mass: float = quantity(
        "Mass",
        "kg",
        within=(0, 1000),
        symbol="m_i",
        rule_of_thumb=(0.05, 20),
        help="Mass of this eccentric part of the shaft.",
        change=("lighter mass", "heavier mass"),
        repair="free",
    )
    radius: float = quantity(
        "Radius of its centre of gravity",
        "mm",
        within=(0, 1000),
        symbol="e_i",
        help="Distance of its centre of gravity from the shaft's axis.",
        change=("mass further in", "mass further out"),
        repair="free",
    )
    angle: float = quantity(
        "Angle",
        "°",
        within=(-720, 720),
        symbol="phi_i",
        step=1,
        help=ANGLE,
        change=("mass turned", "mass turned"),
        repair="free",
    )
    z: float = quantity(
        "Position",
        "mm",
        within=(-5000, 5000),
        symbol="z_i",
        help=FROM_MID_SHAFT,
        change=("mass elsewhere", "mass elsewhere"),
        repair="free",
    )


@inputs
class Extra(EccentricMass):
    """An element beside the main masses: a hole in a journal (mass below zero), material ahead of the gear."""

    mass: float = quantity(
        "Mass",
        "kg",
        within=(-1000, 1000),
        symbol="m_i",
        help="Mass of the element; below zero it is removed, as by a hole.",
        repair="free",
    )


@inputs
class Section:
    """A stretch of the shaft: a full cylinder, or with a half-angle an eccentric sector on its core."""

    from_: float = quantity("From", "mm", within=(-5000, 5000), help=FROM_MID_SHAFT)
    to: float = quantity("Up to", "mm", within=(-5000, 5000), help=FROM_MID_SHAFT)
    outer_radius: float = quantity(
        "Outer radius",
        "mm",
        up_to=1000,
        symbol="R",
        help="Radius of the cylinder, or outer radius of the sector.",
        repair="free",
    )
    core_radius: float | None = quantity(
        "Core radius",
        "mm",
        default=None,
        within=(0, 1000),
        symbol="r_0",
        help="Radius of the core inside a sector. Left out: 0.",
        repair="free",
    )
    half_angle: float | None = quantity(
        "Half-angle of the sector",
        "°",
        default=None,
        up_to=180,
        symbol="gamma",
        help="Half of the angle that the sector spans. Left out: a full cylinder.",
        repair="free",
    )
    angle: float | None = quantity("Angle of the sector's middle", "°", default=None, within=(-720, 720), help=ANGLE)

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.to <= self.from_:
            yield dotted(Section.to), Text("must lie behind from_mm: a section has a length above zero")
        if self.half_angle is None:
            for name, key in (("core_radius", dotted(Section.core_radius)), ("angle", dotted(Section.angle))):
                if getattr(self, name) is not None:
                    yield key, Text("belongs to a sector: give half_angle_deg too, or leave it out")
        elif self.angle is None:
            yield dotted(Section.angle), Text("needed with half_angle_deg: where the sector's middle stands")
        if self.core_radius is not None and self.core_radius >= self.outer_radius:
            yield dotted(Section.core_radius), Text("must be smaller than outer_radius_mm")


@inputs
class Holes:
    """Radial holes drilled into the eccentric masses to calibrate the shaft."""

    diameter: float = quantity(
        "Diameter",
        "mm",
        up_to=200,
        symbol="d_c",
        source="Finotti 2013, 4.1",
        help="Diameter of a radial hole by which the shaft is calibrated.",
        repair="free",
        brief="diameter",
    )
    depth: float = quantity(
        "Greatest depth",
        "mm",
        up_to=500,
        symbol="h_c",
        source="Finotti 2013, 4.1",
        help="Of the full diameter, from the outer radius; the cone of a drill of 118° goes on from there.",
        change=("shallower holes", "deeper holes"),
        repair="free",
    )
    count: int = integer(
        "Holes on the whole shaft",
        within=(1, 1000),
        symbol="N_c",
        help="Shared evenly by the eccentric masses.",
        change=("fewer holes", "more holes"),
        repair="free",
    )


@inputs
class Scatter:
    """What production makes of the drawing: standard deviations."""

    mass: float = quantity(
        "Mass of each eccentric mass", "g", within=(0, 1e5), help="Standard deviation of the mass, for each by itself."
    )
    radius: float = quantity(
        "Radius of its centre of gravity",
        "mm",
        within=(0, 100),
        help="Standard deviation of the radius, for each mass by itself.",
    )
    angle: float = quantity(
        "Its angle", "°", within=(0, 90), help="Standard deviation of the angle, for each mass by itself."
    )
    z: float = quantity(
        "Its position",
        "mm",
        within=(0, 1000),
        help="Standard deviation of the place along the shaft, for each mass by itself.",
    )
    timing: float = quantity(
        "Timing of the whole shaft by its teeth",
        "°",
        default=0.0,
        within=(0, 90),
        help="Standard deviation of an angle that is common to all its masses.",
    )
    shafts: int = integer(
        "Shafts to try",
        default=10_000,
        within=(100, 1_000_000),
        help="How many shafts are drawn by chance; more give steadier results.",
    )
    seed: int = integer(
        "Seed of the random numbers", default=1, within=(0, 2**31), help="The same seed draws the same shafts again."
    )


NO_ORDER = Text(
    "no shaft balances this order, must be -1, 1, -2 or 2: half orders are of the gas torque, which no rotating mass "
    "takes, and those above 2 are lived with; a pump or a cam at 0.5 is a wheel, not a shaft"
)


@inputs
class ShaftLoad:
    """What hangs on the shaft, a pump: it takes a power that the train carries and does not lose."""

    name: str = text("Name")
    power: float = quantity(
        "Power",
        "kW",
        within=(0, 1e4),
        symbol="P_C",
        help="What it takes at the speed of the design, which is the rated one unless another is given.",
        change=("less of it", "more of it"),
        repair="asked",
    )
    speed_exponent: float = quantity(
        "Exponent of the speed",
        default=3.0,
        within=(0, 5),
        symbol="m_C",
        step=0.5,
        usual=(1, 3),
        source="physics, similarity: of given pressure 1, of pressure that grows with the square of speed 3",
        help="Its power goes with this power of the speed.",
    )
    wheel: str | None = text(
        "Wheel that drives it",
        default=None,
        help="A wheel of the train; where the wheel of the shaft drives that, its teeth push the shaft. Left out: it "
        "turns with the shaft, and no force of it is known.",
    )


@inputs
class ShaftInputs:
    """A balance shaft: its masses or its envelope, where it is carried, and how it is made and mounted."""

    name: str = text("Name", help="By which the design calls the shaft: left, right, lower.")
    mode: str = choice(
        "Mode",
        "given",
        "size",
        "bearings",
        default="given",
        help="given: the eccentric masses below are checked. size: the lightest pair of sectors in the envelope is "
        "found. bearings: only its bearings are asked, under loads that are given.",
        decides=1,
    )
    mirrors: str | None = text(
        "Mirrors",
        default=None,
        help="The name of an earlier shaft whose mirror image this one is: it turns the other way and carries as much.",
    )
    repeats: str | None = text(
        "Repeats",
        default=None,
        help="The name of an earlier shaft that this one is once more, with the same sense, about an axis of its own.",
    )
    material: str = text(
        "Material",
        default=ASKED_ELSEWHERE,
        help="A name from the table of materials or from [[material]].",
        change=("another steel",),
        catalogue="materials",
    )
    speed_ratio: float = quantity(
        "Speed ratio to the crank",
        default=ASKED_ELSEWHERE,
        within=(-100, 100),
        symbol="i",
        source="Finotti 2013, 2.3.3",
        help="−1: crank speed, opposite sense; 1, 2 and −2.",
    )
    axis: tuple[float, ...] | None = series(
        "Axis from the crank's",
        "mm",
        default=None,
        count=(2, 2),
        within=(-5000, 5000),
        symbol="p_S",
        help="[up, side], side 90° further in the sense of crank rotation. Beside the crank a force of the shaft "
        "raises a roll torque.",
        change=("another place beside the crank", "another place beside the crank"),
    )
    masses: tuple[EccentricMass, ...] = tables(
        "Eccentric masses", EccentricMass, default=(), decides=9, where=(mode, "given")
    )
    extras: tuple[Extra, ...] = tables("Further elements", Extra, default=())
    outer_radius: float | None = quantity(
        "Outer radius of the sectors",
        "mm",
        default=None,
        up_to=1000,
        brief="sector radius",
        symbol="R",
        step=0.5,
        rule_of_thumb=(15, 120),
        help="What may still be threaded through the largest seat. Needed for mode size; else the largest journal "
        "less the clearance.",
        change=("smaller envelope", "larger envelope"),
        repair="free",
        decides=2,
        where=(mode, "size"),
    )
    core_radius: float | None = quantity(
        "Core radius",
        "mm",
        default=None,
        within=(0, 1000),
        symbol="r_0",
        step=0.5,
        rule_of_thumb=(6, 80),
        help="Radius of the shaft between and inside the sectors.",
        change=("thinner core", "stiffer shaft"),
        repair="free",
        decides=3,
        where=(mode, "size"),
    )
    half_length: float | None = quantity(
        "Half-length",
        "mm",
        default=None,
        up_to=5000,
        symbol="z_max",
        step=1,
        rule_of_thumb=(30, 600),
        help="Outer faces of the sectors from mid-shaft. Needed for mode size.",
        change=("shorter shaft", "longer shaft"),
        repair="free",
        decides=4,
        where=(mode, "size"),
    )
    overdesign: float = quantity(
        "Couple beyond the required one",
        "%",
        default=0.0,
        within=(-50, 50),
        symbol="x_o",
        usual=(0, 5),
        source="rule of this program, by the holes",
        help="Mode size: what drilling takes away again.",
        change=("less beyond what is asked", "more beyond what is asked"),
        where=(mode, "size"),
    )
    radial_clearance: float | None = quantity(
        "Clearance for threading in",
        "mm",
        default=None,
        within=(0, 50),
        symbol="c_R",
        rule_of_thumb=(0.2, 5),
        help="Between sectors and largest seat. Left out: none asked; in mode given the shaft is not threaded through "
        "a seat.",
        where=(mode, "size"),
    )
    gap: float | None = quantity(
        "Gap at inner bearings",
        "mm",
        default=None,
        within=(0, 1000),
        symbol="g_B",
        help="Mode size: no sector within half of it on either side of the middle of an inner bearing. Left out: the "
        "length of its journal, and two fillets on either side.",
        change=("narrower gap", "wider gap"),
        where=(mode, "size"),
    )
    share: float | None = quantity(
        "Share of the task",
        "%",
        default=None,
        within=(1, 100),
        symbol="w_s",
        help="Mode size: of what the engine and the given shafts of this ratio leave. Left out: equal shares of all "
        "shafts of this ratio that are sized, twins counted.",
        change=("smaller share", "larger share"),
        where=(mode, "size"),
    )
    assembly: str | None = choice(
        "Assembly",
        "threaded",
        *LAID_IN,
        "cartridge",
        default=None,
        help="threaded: all passes the largest seat. split, caps, module: laid in, nothing has to pass. cartridge: "
        "through the bore of the carrier of an outer bearing, which comes along. Left out: threaded in mode size or "
        "with a clearance for threading in, else not asked.",
    )
    insert_from: str | None = choice(
        "Comes in from",
        "front",
        "rear",
        default=None,
        help="Of a shaft that is threaded or comes with its carrier. Left out: from the side with more room.",
    )
    bore_diameter: float = quantity(
        "Bore through it",
        "mm",
        default=0.0,
        within=(0, 2000),
        symbol="d_b",
        step=0.5,
        help="Of a hollow shaft, along its whole length; smaller than its core.",
        change=("narrower bore", "wider bore"),
        repair="free",
    )
    sector_material: str | None = text(
        "Sectors' material",
        default=None,
        help="Tungsten segments, welded weights: its density is that of the sectors alone. Left out: the shaft's.",
        change=("other sectors",),
        catalogue="materials",
    )
    sections: tuple[Section, ...] = tables("Outline for bending", Section, default=())
    fillet_radius: float | None = quantity(
        "Fillet at the shoulders",
        "mm",
        default=None,
        up_to=100,
        symbol="rho_f",
        rule_of_thumb=(0.5, 5),
        help="Its radius. Left out: no notch stress.",
        change=("smaller fillet", "larger fillet"),
        repair="free",
    )
    fem_stress: float | None = quantity(
        "Largest stress, von Mises, by finite elements",
        "MPa",
        default=None,
        within=(0, 10000),
        source="Finotti 2013, 4.6 (in chapter 6)",
        help="Of the shaft at its highest speed; the limit is the proof stress of its material.",
        repair="asked",
    )
    fem_principal_stress: float | None = quantity(
        "Largest principal stress, by finite elements",
        "MPa",
        default=None,
        within=(0, 10000),
        source="Finotti 2013, 4.6 (in chapter 6)",
        help="Of the shaft at its highest speed; every run-up is a cycle of fatigue.",
        repair="asked",
    )
    sector_effectiveness: float = quantity(
        "Stiffness share of the sectors",
        default=0.2,
        within=(0.1, 1),
        symbol="eta",
        step=0.05,
        usual=(0.2, 0.4),
        source="Finotti 2013, 4.6 (in chapter 6), by fit to its slopes",
        help="Of their full section; 1 is optimistic, 0.2 honest.",
    )
    gear_z: float | None = quantity(
        "Middle of the gear",
        "mm",
        default=None,
        within=(-5000, 5000),
        symbol="z_G",
        help="From mid-shaft, + towards the flywheel. Left out: ahead of the front journal, against it.",
        repair="free",
    )
    balance_grade: str = choice(
        "Balance quality grade",
        *BALANCE_GRADES,
        default="G6.3",
        help="ISO 21940-11, which lists no balance shafts: machinery in general G6.3, crank drives that are inherently "
        "balanced G16 (rigidly mounted) and G40, inherently unbalanced ones G250 and G630.",
        fold=SUPPORT,
    )
    covered: str = choice(
        "Cover",
        "open",
        "shell",
        default="open",
        help="shell: close around the sectors, and dry inside: the mist turns along, and no oil at rest reaches them.",
        fold=AROUND,
    )
    shell_gap: float | None = quantity(
        "Gap between sectors and shell",
        "mm",
        default=None,
        up_to=500,
        symbol="t_S",
        rule_of_thumb=(1, 5),
        help="Radial, between their outer radius and the shell.",
        change=("closer shell", "wider shell"),
        repair="free",
        where=(covered, "shell"),
    )
    loads: tuple[ShaftLoad, ...] = tables(
        "What hangs on the shaft", ShaftLoad, default=(), help="Pumps that the shaft or its train drives.", fold=AROUND
    )
    holes: Holes | None = table("Calibration holes", Holes, default=None, fold=SUPPORT)
    balancing: Balancing | None = table(
        "Balancing sheet",
        Balancing,
        default=None,
        help="The empty table asks for it: targets, permitted unbalance, rings and holes, in the shop's angles.",
        fold=SUPPORT,
    )
    scatter: Scatter | None = table("Production scatter", Scatter, default=None, fold=SUPPORT)
    bolts: Bolts | None = table("Bolts of the support", Bolts, default=None, fold=SUPPORT)
    further_bolts: tuple[FurtherBolts, ...] = tables("Further bolts", FurtherBolts, default=(), fold=SUPPORT)
    support: ShaftSupport | None = table("Support", ShaftSupport, default=None, fold=SUPPORT)
    oil_drain: OilDrain | None = table("Oil drain", OilDrain, default=None, fold=SUPPORT)
    further_drains: tuple[FurtherDrain, ...] = tables("Further oil drains", FurtherDrain, default=(), fold=SUPPORT)
    cost: Cost | None = table("Cost", Cost, default=None, fold=SUPPORT)
    parts: tuple[Part, ...] = tables(
        "Parts of the assembly", Part, default=(), help="They are counted, for designs to be compared.", fold=SUPPORT
    )
    bearings: tuple[BearingRow, ...] = tables("Bearings", BearingRow, default=())

    paired: bool = False  # whether another shaft of the design mirrors it, and turns the other way: the design says so

    @staticmethod
    def as_read(shaft: dict[str, object]) -> dict[str, object]:
        """A shaft of which nothing is said but its bearings, with their loads, is there for these alone."""
        rows, mode = shaft.get(dotted(ShaftInputs.bearings)), dotted(ShaftInputs.mode)
        if not isinstance(rows, list) or not rows or not shaft.keys() <= {*map(dotted, OF_BEARINGS)}:
            return shaft
        loaded = all(isinstance(row, dict) and dotted(BearingRow.load) in row for row in rows)
        return {**shaft, mode: "bearings"} if loaded else shaft

    @property
    def is_twin(self) -> bool:
        """Whether it is the mirror image of another, or that once more."""
        return self.mirrors is not None or self.repeats is not None

    @property
    def bearing_positions(self) -> tuple[float, ...]:
        """Where its bearings stand, front to rear."""
        return tuple(row.position for row in self.bearings)

    @property
    def _placed(self) -> bool:
        """Whether the bearings have their places: what is missing is said as such, and nothing follows from it."""
        return len(self.bearings) > 1 and None not in self.bearing_positions

    @property
    def journals(self) -> tuple[tuple[float, float], ...]:
        """Diameter and length of its journals, front to rear; empty where one of them is not known."""
        sizes = tuple(size for row in self.bearings if (size := row.on_shaft) is not None)
        return sizes if len(sizes) == len(self.bearings) else ()

    @property
    def openings(self) -> tuple[float, ...]:
        """The diameters that its seats leave to what comes in through them, front to rear, infinite where nothing has
        to; empty where one of them is not known."""
        return tuple(row.opening() for row in self.bearings) if self.journals else ()

    @property
    def of_sectors(self) -> str:
        """The material of its sectors."""
        return self.sector_material or self.material

    @property
    def passes_seats(self) -> bool:
        """Whether all of it goes through its seats, its wheel too; also where nothing is said of that."""
        return self.assembly in (None, "threaded")

    @property
    def seat(self) -> float | None:
        """The diameter of what the sectors have to pass on the way in: of the largest seat, or of a carrier; None
        where nothing has to be passed, or it is not known."""
        if self.assembly in LAID_IN:
            return None
        if self.assembly == "cartridge":
            return max((row.carrier_bore[0] for row in self.bearings if row.carrier_bore is not None), default=None)
        largest = max(self.openings, default=math.inf)
        return largest if math.isfinite(largest) else None

    @property
    def room_asked(self) -> float | None:
        """The radial clearance that is asked on the way in; None where nothing is asked."""
        if self.assembly in LAID_IN or (
            self.assembly is None and self.radial_clearance is None and self.mode != "size"
        ):
            return None
        return self.radial_clearance if self.radial_clearance is not None else 0.0

    @property
    def seat_asked(self) -> float:
        """The least diameter of the largest seat, through which the sectors have to pass; 0 where they pass none."""
        if self.room_asked is None or self.assembly == "cartridge" or self.outer_radius is None:
            return 0.0
        return 2 * (self.outer_radius + self.room_asked)

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.name in NO_NAMES or (self.name.isascii() and self.name.isdigit()):
            words = Text("must not be figures alone, nor one of {words}", words=", ".join(NO_NAMES))
            yield dotted(ShaftInputs.name), words
        if self.is_twin:
            yield from self._twin()
            return
        if self.mode != "bearings":
            for key, given in ((ShaftInputs.material, self.material), (ShaftInputs.speed_ratio, self.speed_ratio)):
                if given is None:
                    yield dotted(key), Text("is missing; needs {allowed}", allowed=described(key).allowed())
        elif self.masses:
            yield dotted(ShaftInputs.masses), Text('do not go with mode = "bearings", whose loads are given')
        if not 2 <= len(self.bearings) <= 9:
            count = len(self.bearings)
            yield dotted(ShaftInputs.bearings), Text("needs 2 to 9 rows [[shafts.bearings]]; has {count}", count=count)
        if self.covered == "shell" and self.shell_gap is None:
            yield dotted(ShaftInputs.shell_gap), Text('needed with covered = "shell"')
        if self.covered != "shell" and self.shell_gap is not None:
            yield dotted(ShaftInputs.shell_gap), Text('leave it out, or say covered = "shell"')
        for i, row in enumerate(self.bearings):
            yield from ((dotted(ShaftInputs.bearings, i, key), why) for key, why in row.of_others())
        yield from self._seats()
        if self.mode == "bearings":
            return
        for i, row in enumerate(self.bearings):
            if row.standing_load is not None:
                known = Text("leave it out: the shaft knows what stands on its bearings")
                yield dotted(ShaftInputs.bearings, i, BearingRow.standing_load), known
            if row.position is None:
                needs = Text("is missing; needs {allowed}", allowed=described(BearingRow.position).allowed())
                yield dotted(ShaftInputs.bearings, i, BearingRow.position), needs
        if self.speed_ratio is not None and self.speed_ratio not in (-2.0, -1.0, 1.0, 2.0):
            yield dotted(ShaftInputs.speed_ratio), NO_ORDER
        if self.holes is not None and self.outer_radius is not None and self.holes.depth >= self.outer_radius:
            R = _mm(self.outer_radius)
            yield (
                dotted(ShaftInputs.holes, Holes.depth),
                Text("must stay below outer_radius_mm, {outer_radius} mm: a hole ends before the axis", outer_radius=R),
            )
        if self.balancing is not None:
            angles = {mass.name: mass.angle for mass in self.masses} if self.mode == "given" else {}
            there = [Stretch(s.from_, s.to, s.outer_radius, s.angle, s.half_angle) for s in self.sections]
            wrong = balancing_problems(self.balancing, angles, there, self.outer_radius)
            yield from ((dotted(ShaftInputs.balancing, key), why) for key, why in wrong)
        yield from self._envelope()
        yield from self._sections()
        if self._placed:
            yield from self._places()

    def _twin(self) -> Iterable[tuple[str, Text]]:
        """A twin has little of its own."""
        if self.mirrors is not None and self.repeats is not None:
            yield dotted(ShaftInputs.repeats), Text("leave it out beside mirrors: a shaft is a twin of one kind")
        if self.mirrors is None and self.axis is None:
            yield dotted(ShaftInputs.axis), Text("needed with repeats: two shafts can not turn about one axis")
        theirs = Text("is that of its original, {name}: leave it out here", name=self.mirrors or self.repeats)
        for key, entry in keys(ShaftInputs).items():
            if key not in TWIN and getattr(self, entry.attribute) != entry.field.default:
                yield key, theirs
        for i, row in enumerate(self.bearings):
            of_original = [entry.key for entry in said_in(row) if entry.key in OF_ORIGINAL]
            yield from ((dotted(ShaftInputs.bearings, i, key), theirs) for key in of_original)

    def _envelope(self) -> Iterable[tuple[str, Text]]:
        if self.mode == "given" and not self.masses:
            yield dotted(ShaftInputs.masses), Text("needs at least one [[shafts.masses]]")
        if self.mode == "size":
            yield from self._gaps()
            needed = Text('needed with mode = "size"; `choose FILE countershaft` finds the envelope')
            for name in ("outer_radius", "core_radius", "half_length"):
                if getattr(self, name) is None:
                    yield f"{name}_mm", needed
        if self.outer_radius is not None and self.core_radius is not None and self.core_radius >= self.outer_radius:
            yield dotted(ShaftInputs.core_radius), Text("must be smaller than outer_radius_mm")
        if self.core_radius is not None and self.bore_diameter >= 2 * self.core_radius and self.bore_diameter:
            yield dotted(ShaftInputs.bore_diameter), Text("must be smaller than the core, twice core_radius_mm")

    def _gaps(self) -> Iterable[tuple[str, Text]]:
        """Beside inner bearings the sectors keep a gap."""
        if self.gap is not None and self.half_length is not None and self.gap >= 2 * self.half_length:
            yield dotted(ShaftInputs.gap), Text("must be smaller than twice half_length_mm: it leaves no sectors")
        if self.gap is None and any(not row.sized for row in self.bearings[1:-1]):
            yield dotted(ShaftInputs.gap), Text("needed where an inner bearing has no length_mm, or give that")

    def _seats(self) -> Iterable[tuple[str, Text]]:
        """How the shaft comes into its seats."""
        if self.assembly in LAID_IN and self.radial_clearance is not None:
            laid_in = Text(
                'leave it out with assembly = "{assembly}": nothing has to pass a seat', assembly=self.assembly
            )
            yield dotted(ShaftInputs.radial_clearance), laid_in
        for i, row in enumerate(self.bearings):
            if (undivided := self.seat_problem(row)) is not None:
                yield dotted(ShaftInputs.bearings, i, BearingRow.seat), undivided
            if row.carrier is not None and row.carrier_bore is None:
                key = dotted(ShaftInputs.bearings, i, BearingRow.carrier)
                yield key, Text("needs carrier_bore_mm beside it: the bore that the carrier fills")
        carriers = {i: row.carrier_bore for i, row in enumerate(self.bearings) if row.carrier_bore is not None}
        for i in carriers:
            key = dotted(ShaftInputs.bearings, i, BearingRow.carrier_bore)
            if self.assembly != "cartridge":
                yield key, Text('belongs to assembly = "cartridge"')
            elif 0 < i < len(self.bearings) - 1:
                yield key, Text("belongs to an outer bearing, through whose bore the shaft comes in")
        if self.assembly == "cartridge" and not carriers:
            needed = Text('needed with assembly = "cartridge": the bore that the carrier of an outer bearing fills')
            yield dotted(ShaftInputs.bearings, 0, BearingRow.carrier_bore), needed

    def seat_problem(self, row: BearingRow) -> Text | None:
        """Why a bearing can not have its seat on this shaft; where its bearings alone are asked, the way of assembly
        may be left open."""
        left_open = self.mode == "bearings" and self.assembly is None
        if row.seat != "shells" or self.assembly in LAID_IN or left_open:
            return None
        return Text('half shells go in with a divided housing; assembly = "split", "caps" or "module"')

    @property
    def _known(self) -> bool:
        """Whether every section has its place: one that is missing is said as such, and nothing follows from it."""
        return all(math.isfinite(s.from_) and math.isfinite(s.to) for s in self.sections)

    def _sections(self) -> Iterable[tuple[str, Text]]:
        if not self._known:
            return
        ordered = sorted(range(len(self.sections)), key=lambda i: self.sections[i].from_)
        for i, k in pairwise(ordered):
            gap = self.sections[k].from_ - self.sections[i].to
            if abs(gap) > 1e-9:
                what = Text("crosses") if gap < 0 else Text("leaves a gap behind")
                yield (
                    dotted(ShaftInputs.sections, k, Section.from_),
                    Text(
                        "{what} section {i}, which ends at {to} mm; the shaft is one piece",
                        what=what,
                        i=i,
                        to=_mm(self.sections[i].to),
                    ),
                )

    def _places(self) -> Iterable[tuple[str, Text]]:
        """Journals and masses must lie on the shaft: its sections, or else between its outer bearings."""
        falls = [i for i, (a, b) in enumerate(pairwise(self.bearing_positions), 1) if b <= a]
        for i in falls:
            rise = Text("must lie behind the row before it: the rows rise from front to rear")
            yield dotted(ShaftInputs.bearings, i, BearingRow.position), rise
        if falls or not self._known:
            return
        masses = [(dotted(ShaftInputs.masses, i, EccentricMass.z), mass.z) for i, mass in enumerate(self.masses)]
        if not self.sections:
            start, end = self.bearing_positions[0], self.bearing_positions[-1]
            where = Text("the span of the bearings")
            hint = Text("; an overhung one needs [[shafts.sections]] that reach it, or stands in [[shafts.extras]]")
            outside = Text(
                "lies outside {where}, from {start} to {end} mm{hint}",
                where=where,
                start=_mm(start),
                end=_mm(end),
                hint=hint,
            )
            yield from ((key, outside) for key, z in masses if not start <= z <= end)
            return
        start, end = min(s.from_ for s in self.sections), max(s.to for s in self.sections)
        outside = Text("lies outside the shaft's sections, from {start} to {end} mm", start=_mm(start), end=_mm(end))
        rows = enumerate(self.bearings)
        placed = [(dotted(ShaftInputs.bearings, i, BearingRow.position), row.position) for i, row in rows]
        placed += [(dotted(ShaftInputs.gear_z), self.gear_z)] if self.gear_z is not None else []
        placed += [(dotted(ShaftInputs.extras, i, Extra.z), extra.z) for i, extra in enumerate(self.extras)]
        yield from ((key, outside) for key, z in (*placed, *masses) if not start <= z <= end)


def _mm(length: float) -> Amount:
    """A length in m as an Amount of mm, for a sentence that names the unit."""
    return Amount(length * 1000.0, form="g")


# what a twin has of its own; of its bearings what their rows say, by the names of its original's
OWN = ShaftInputs.name, ShaftInputs.mirrors, ShaftInputs.repeats, ShaftInputs.axis, ShaftInputs.loads
TWIN = tuple(map(dotted, (*OWN, ShaftInputs.bearings)))
# what a shaft may say that is there for its bearings alone
OF_BEARINGS = ShaftInputs.name, ShaftInputs.bearings, ShaftInputs.assembly
