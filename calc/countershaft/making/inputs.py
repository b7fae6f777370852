# SPDX-License-Identifier: Apache-2.0
"""What the shaft is mounted with and what it costs: threads, support, bolts, oil drain, alternatives of material."""

import re
from collections.abc import Iterable
from math import pi

from ...sheet.errors import text_of
from ...sheet.formula import formula
from ...sheet.quantity import choice, dotted, inputs, integer, names, quantity, series, tables, text
from ...sheet.text import Amount, Text
from ...sheet.units import Metre, SquareMetre

# --- metric threads: the designation read, and the diameters of ISO 724 and ISO 898-1

# Coarse pitch of each nominal diameter, mm (ISO 261); of the pitches of a diameter it is the largest.
COARSE = {
    1.0: 0.25, 1.1: 0.25, 1.2: 0.25, 1.4: 0.3, 1.6: 0.35, 1.8: 0.35, 2.0: 0.4, 2.2: 0.45, 2.5: 0.45, 3.0: 0.5,
    3.5: 0.6, 4.0: 0.7,
    4.5: 0.75, 5.0: 0.8, 6.0: 1.0, 7.0: 1.0, 8.0: 1.25, 9.0: 1.25, 10.0: 1.5, 11.0: 1.5, 12.0: 1.75, 14.0: 2.0,
    16.0: 2.0, 18.0: 2.5,
    20.0: 2.5, 22.0: 2.5, 24.0: 3.0, 27.0: 3.0, 30.0: 3.5, 33.0: 3.5, 36.0: 4.0, 39.0: 4.0, 42.0: 4.5, 45.0: 4.5,
    48.0: 5.0, 52.0: 5.0,
    56.0: 5.5, 60.0: 5.5, 64.0: 6.0,
}  # fmt: skip
DIAMETERS = (1.0, 300.0)  # mm, smallest and largest of ISO 261
FINEST, LARGEST = 0.2, 8.0  # mm, pitches of ISO 261
DESIGNATION = re.compile(r"M *([0-9]+(?:\.[0-9]+)?)(?: *[x×] *([0-9]+(?:\.[0-9]+)?))?", re.IGNORECASE)


def thread(text: str) -> tuple[Metre, Metre]:
    """Nominal diameter and pitch of a metric thread: "M10", "M10x1.5", "M10×1.5".  Raises ValueError, which says what
    is allowed."""
    match = DESIGNATION.fullmatch(text.strip())
    if match is None:
        raise ValueError("must be a metric thread like M10 (coarse pitch of ISO 261) or M10x1.25, in mm")
    D, given = float(match[1]), match[2]
    if not DIAMETERS[0] <= D <= DIAMETERS[1]:
        raise ValueError(f"must be from M{DIAMETERS[0]:g} to M{DIAMETERS[1]:g} (ISO 261)")
    if given is None and D not in COARSE:
        raise ValueError(
            f"M{D:g} has no coarse pitch in ISO 261: give the pitch too, like M{D:g}x{max(_coarsest(D) / 2, FINEST):g}"
        )
    p = COARSE[D] if given is None else float(given)
    if not FINEST <= p <= _coarsest(D):
        raise ValueError(f"the pitch of M{D:g} must be from {FINEST:g} to {_coarsest(D):g} mm (ISO 261)")
    return D / 1000, p / 1000


def _coarsest(D: float) -> float:
    """The largest pitch of a diameter, mm; of one between those of ISO 261, that of the next."""
    return next((pitch for size, pitch in COARSE.items() if size >= D), LARGEST)


def thread_problem(text: str) -> Text | None:
    """What is wrong with a thread's designation; None where it can be read."""
    try:
        thread(text)
    except ValueError as e:
        return text_of(e)
    return None


@formula(
    "D",
    "ISO 261: nominal diameter, the first number of the thread's designation",
    shows="number behind M in the designation",
    unit="mm",
)
def nominal_diameter(designation: str) -> Metre:
    return thread(designation)[0]


@formula(
    "P_h",
    "ISO 261: pitch of the thread, as in its designation, else the coarse one",
    shows="number behind ×, or coarse pitch",
    unit="mm",
)
def pitch(designation: str) -> Metre:
    return thread(designation)[1]


@formula("d_2", "ISO 724: pitch diameter of the metric thread", unit="mm", names={"p": "P_h"})
def pitch_diameter(D: Metre, p: Metre) -> Metre:
    return D - 0.649519 * p


@formula("d_3", "ISO 898-1: root diameter of the thread, d_1 − H/6", unit="mm", names={"p": "P_h"})
def root_diameter(D: Metre, p: Metre) -> Metre:
    return D - 1.226869 * p


@formula("A_s", "ISO 898-1: nominal stress area of the thread", unit="mm²")
def stress_area(d_2: Metre, d_3: Metre) -> SquareMetre:
    return pi / 4 * ((d_2 + d_3) / 2) ** 2


# --- the inputs

# Width across flats of a hexagon head without flange, mm (ISO 4014, ISO 4017): on a narrower one there is a flange.
HEXAGONS = {5.0: 8.0, 6.0: 10.0, 8.0: 13.0, 10.0: 16.0, 12.0: 18.0, 14.0: 21.0, 16.0: 24.0, 20.0: 30.0, 24.0: 36.0}

# Faces under a head that is known by its width across flats s alone, or by its thread D: a flanged one by DIN 6921
# (least of the face from 1.95·D, outside of the flange up to 2.4·D) or by the small series of ISO 4162 (from 1.86·D), a
# plain hexagon by ISO 4017 (0.89·s to s)
FLANGE, FLANGES = 2.0, (1.85, 2.4)
PLAIN, PLAINEST = 0.95, 0.89

# Rp0.2 (4.6 to 5.8: Rel) of each property class, MPa: ISO 898-1, Table 3
STRENGTH = {"4.6": 240.0, "5.6": 300.0, "5.8": 420.0, "6.8": 480.0, "8.8": 640.0, "10.9": 940.0, "12.9": 1100.0}


@inputs
class Bolts:
    """The bolts that hold the support to the block."""

    thread: str = text("Thread", help="Metric, like M10x1.5; the coarse pitch may be left out: M10.")
    torque: float = quantity(
        "Tightening torque",
        "N·m",
        up_to=5000,
        symbol="M_A",
        step=1,
        source="VDI 2230-1",
        help="Torque with which each bolt is tightened; thread and head rub most of it away.",
        change=("less bolt torque", "more bolt torque"),
        repair="free",
    )
    friction: float = quantity(
        "Coefficient of friction, thread and head",
        within=(0.02, 0.5),
        symbol="mu",
        step=0.01,
        usual=(0.08, 0.16),
        source="VDI 2230-1, class B",
        help="Give the smallest expected. Where head_friction is given, this is the thread's alone.",
    )
    head_friction: float | None = quantity(
        "Coefficient of friction under the head",
        default=None,
        within=(0.02, 0.5),
        symbol="mu_K",
        step=0.01,
        usual=(0.08, 0.16),
        source="VDI 2230-1, class B",
        help="Where it differs from the thread's, as under a washer or on a coated face. Left out: that of the thread.",
    )
    head_diameter: float | None = quantity(
        "Bearing diameter of the head",
        "mm",
        default=None,
        up_to=200,
        symbol="d_w",
        source="VDI 2230-1",
        help="Outer diameter of the face that the head, its flange or the washer presses on. Left out: assumed from "
        "the width across flats.",
        change=("smaller bolt heads", "larger bolt heads"),
        repair="free",
    )
    across_flats: float | None = quantity(
        "Width across flats",
        "mm",
        default=None,
        up_to=200,
        symbol="s",
        source="Finotti 2013, Table 6.1",
        help="Of the spanner, which says no more of the face under the head than whether it is flanged. Its half is "
        "the radius at which the source's formula lets the head rub; left out, that of head_diameter_mm.",
    )
    hole_diameter: float = quantity(
        "Clearance hole",
        "mm",
        up_to=200,
        symbol="d_h",
        source="VDI 2230-1",
        help="Diameter of the hole that the bolt goes through, a little above the thread's.",
        change=("closer bolt holes", "wider bolt holes"),
        repair="free",
    )
    count: int = integer(
        "Number of bolts",
        within=(2, 64),
        symbol="N_b",
        help="Bolts that hold the support to the block, all alike.",
        change=("fewer bolts", "more bolts"),
        repair="free",
    )
    method: str = choice(
        "Torque to preload",
        "vdi",
        "source",
        default="vdi",
        help="vdi: flank angle and mean bearing radius, as in VDI 2230. source: Finotti 2013, Table 6.1. Both are "
        "shown.",
    )
    property_class: str = choice(
        "Property class",
        *STRENGTH,
        default="8.8",
        help="ISO 898-1; its proof strength judges the stress by tightening.",
    )
    joint_friction: float = quantity(
        "Coefficient of friction, support on block",
        default=0.12,
        within=(0.02, 0.8),
        symbol="mu_T",
        step=0.01,
        rule_of_thumb=(0.1, 0.3),
        help="Holds the support against sliding.",
    )
    row_span: float | None = quantity(
        "Distance of the bolt rows along the shaft",
        "mm",
        default=None,
        up_to=5000,
        symbol="l_b",
        help="Between the bolts at the front and those at the rear. Left out: that of the shaft's outer bearings.",
        repair="free",
    )
    carries: tuple[str, ...] | None = names(
        "Shafts that they carry",
        default=None,
        help="Names of the shafts whose bearings their support holds; the one that they stand at counts in any case. "
        "Left out: that one alone.",
    )
    direction: float | None = quantity(
        "Direction of the bolts",
        "°",
        default=None,
        within=(-360, 360),
        symbol="beta",
        help="Of their axis, from up in the sense of crank rotation: 0 where they hold the support from above or "
        "below, 90 from the side. It counts where shafts that turn both ways stand in one support. Left out: the "
        "joint is judged with the bolts as they point worst, and best.",
        repair="asked",
    )

    @property
    def flanged(self) -> bool:
        """Whether the width across flats is below that of a plain hexagon on this thread."""
        s, plain = self.across_flats, HEXAGONS.get(round(thread(self.thread)[0] * 1e3, 6))
        return s is not None and plain is not None and s * 1e3 < plain

    def problems(self) -> Iterable[tuple[str, Text]]:
        s, face = self.across_flats, self.head_diameter
        if face is None and s is None:
            yield dotted(Bolts.head_diameter), Text("is needed, or across_flats_mm, from which it is assumed")
        if (wrong := thread_problem(self.thread)) is not None:
            yield dotted(Bolts.thread), wrong
            return
        D = thread(self.thread)[0]
        if face is None and s is not None:
            face = FLANGES[0] * D if self.flanged else PLAINEST * s
        if face is not None and self.hole_diameter >= face:
            yield (
                dotted(Bolts.hole_diameter),
                Text(
                    "must be smaller than the face under the head, {d} mm at least, or the head bears on nothing",
                    d=Amount(face * 1000.0, form="g"),
                ),
            )
        if s is not None and s <= D:
            yield (
                dotted(Bolts.across_flats),
                Text("must be larger than the thread, {d} mm", d=Amount(D * 1000.0, form="g")),
            )
        if self.hole_diameter <= D:
            yield (
                dotted(Bolts.hole_diameter),
                Text("must be larger than the thread, {d} mm", d=Amount(D * 1000.0, form="g")),
            )


@inputs
class FurtherBolts(Bolts):
    """Bolts beside those of the support, as the screws that hold a wheel's pin to the block."""

    name: str = text("Name")
    force: float | None = quantity(
        "Force across the joint",
        "N",
        default=None,
        within=(0, 1e7),
        symbol="Q",
        help="On all of these bolts together, as the force of a wheel on its pin. Left out: slip is not judged.",
        repair="asked",
    )
    turns: str = choice(
        "The force turns",
        "no",
        "yes",
        default="no",
        help="Whether that force comes from alternate sides, or keeps its direction like that of a train's teeth.",
    )
    material: str | None = text(
        "Material under the heads",
        default=None,
        help="A name from the table of materials or from [[material]]. Left out: the pressure is not judged.",
        catalogue="materials",
    )

    def problems(self) -> Iterable[tuple[str, Text]]:
        yield from super().problems()
        for key, given in (
            (dotted(Bolts.row_span), self.row_span),
            (dotted(Bolts.carries), self.carries),
            (dotted(Bolts.direction), self.direction),
        ):
            if given is not None:
                yield key, Text("belongs to the bolts of the support: these hold their force together")


@inputs
class Clamp:
    """One spring band clamp."""

    nominal: float = quantity(
        "Nominal diameter",
        "mm",
        up_to=500,
        source="DIN 3021",
        help="Diameter by which the clamp is called; the hose end must not be smaller.",
        repair="free",
    )
    opening: float = quantity(
        "Largest opening",
        "mm",
        up_to=500,
        source="DIN 3021",
        help="Diameter to which the clamp opens; the hose end must pass.",
        repair="free",
    )

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.opening <= self.nominal:
            yield dotted(Clamp.opening), Text("must be larger than nominal_mm")


@inputs
class Union:
    """One pipe union."""

    thread: str = text("Thread", help="Like M18x1.5.")
    bore: float = quantity(
        "Bore",
        "mm",
        up_to=200,
        source="Finotti 2013, 4.4",
        help="Inner diameter; of the unions that fit the one with the widest bore is taken.",
        repair="free",
    )

    def problems(self) -> Iterable[tuple[str, Text]]:
        if (wrong := thread_problem(self.thread)) is not None:
            yield dotted(Union.thread), wrong


@inputs
class Sleeve:
    """One sleeve: its ring sits under the head of the union, its end takes the hose."""

    ring: float = quantity(
        "Inner diameter of the ring",
        "mm",
        up_to=200,
        symbol="d",
        source="Finotti 2013, 4.4",
        help="The union goes through it: not below the diameter of its thread.",
        repair="free",
    )
    bore: float = quantity(
        "Bore of the end",
        "mm",
        up_to=200,
        symbol="d1",
        source="Finotti 2013, 4.4",
        help="Inner diameter; of the sleeves that fit the one with the widest bore is taken.",
        repair="free",
    )
    end: float = quantity(
        "Outer diameter of the end",
        "mm",
        up_to=200,
        symbol="d2",
        source="Finotti 2013, 4.4",
        help="On which the hose sits.",
        repair="free",
    )

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.end <= self.bore:
            yield dotted(Sleeve.end), Text("must be larger than bore_mm")


@inputs
class OilDrain:
    """The hose, the union and the sleeve through which the support's oil runs back, and how steep the passage to it
    is."""

    hose_min: float = quantity(
        "Hose end, smallest outer diameter",
        "mm",
        up_to=500,
        symbol="D_min",
        source="Finotti 2013, 4.4",
        help="The clamp must still grip the hose end at this diameter.",
        repair="free",
    )
    hose_max: float = quantity(
        "Hose end, largest outer diameter",
        "mm",
        up_to=500,
        symbol="D_max",
        source="Finotti 2013, 4.4",
        help="The clamp must open to this diameter of the hose end.",
        repair="free",
    )
    thread: str = text("Thread of the hole in the block", help="Like M18x1.5.")
    clamps: tuple[Clamp, ...] = tables("Spring band clamps at hand", Clamp, default=())
    unions: tuple[Union, ...] = tables("Pipe unions at hand", Union, default=())
    sleeves: tuple[Sleeve, ...] = tables("Sleeves at hand", Sleeve, default=())
    slope: float | None = quantity(
        "Slope of the passage to the drain",
        "°",
        default=None,
        up_to=90,
        symbol="theta",
        step=1,
        source="Finotti 2013, 3.2.2",
        help="Least angle to the horizontal, machine level; 45° in the source.",
        repair="free",
    )
    tilt: float | None = quantity(
        "Largest tilt of the machine",
        "°",
        default=None,
        within=(0, 90),
        symbol="tau",
        step=1,
        source="Finotti 2013, 3.2.2",
        help="At which the oil must still leave, as on an excavator on a slope. Left out: not judged.",
        repair="free",
    )
    bore: float | None = quantity(
        "Narrowest bore of that passage",
        "mm",
        default=None,
        up_to=200,
        symbol="d_d",
        source="Finotti 2013, 4.4",
        help="Where it is narrowest. Left out: what runs off is not computed.",
        repair="free",
    )
    oil_share: tuple[float, ...] = series(
        "Share of the oil of each bearing",
        "%",
        default=(1.0, 1.0),
        count=(2, 2),
        within=(0, 100),
        symbol="x",
        help="[front, rear]: what of each bearing's oil this drain takes. Left out: all of both.",
        repair="free",
    )

    @property
    def element(self) -> str:
        """What it is called in the ids of its checks."""
        return "drain"

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.slope is None and (self.tilt is not None or self.bore is not None):
            yield dotted(OilDrain.slope), Text("needed with tilt_deg and bore_mm: how steep the passage is")
        if self.hose_max < self.hose_min:
            yield dotted(OilDrain.hose_max), Text("must not be below hose_min_mm")
        if (wrong := thread_problem(self.thread)) is not None:
            yield dotted(OilDrain.thread), wrong


@inputs
class FurtherDrain(OilDrain):
    """A drain beside the first."""

    name: str = text("Name")

    @property
    def element(self) -> str:
        return f"further_drains.{self.name}"


@inputs
class ShaftSupport:
    """The casting that carries the shaft: its wall beside the rear seat, and stresses found elsewhere (finite
    elements)."""

    material: str = text(
        "Material", help="A name from the table of materials or from [[material]].", catalogue="materials"
    )
    wall: float | None = quantity(
        "Wall beside the largest seat",
        "mm",
        default=None,
        up_to=200,
        symbol="w",
        source="Finotti 2013, 4.2",
        help="Metal left beside the largest seat, with the shaft of this design.",
        change=("thinner wall", "thicker wall"),
        repair="free",
    )
    wall_at_seat: float | None = quantity(
        "Seat with that wall",
        "mm",
        default=None,
        up_to=500,
        symbol="D_w",
        source="Finotti 2013, 4.2",
        help="A larger seat takes half of what it grows from wall_mm. Left out: wall_mm stands whatever the seat.",
    )
    least_wall: float = quantity(
        "Least wall",
        "mm",
        default=5e-3,
        up_to=200,
        symbol="w_min",
        source="Finotti 2013, 4.2",
        help="What the casting needs; 5 mm in sand-cast aluminium.",
    )
    bolt_stress: float | None = quantity(
        "Stress under the bolts' preload, von Mises",
        "MPa",
        default=None,
        within=(0, 10000),
        source="Finotti 2013, 4.7 (in chapter 6)",
        help="From finite elements; the limit is the proof stress of the material.",
        repair="asked",
    )
    load_stress: float | None = quantity(
        "Stress from the bearing loads alone, von Mises",
        "MPa",
        default=None,
        within=(0, 10000),
        source="Finotti 2013, 4.7 (in chapter 6)",
        help="From finite elements, without the bolts' preload; it turns with the shaft.",
        repair="asked",
    )
    load_stress_limit: float | None = quantity(
        "Limit of the stress from the loads",
        "MPa",
        default=None,
        up_to=10000,
        source="given in the design, by the fatigue strength of the casting",
        help="Stress that the support endures without end under the turning load; left out, fatigue is not judged.",
    )

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.wall_at_seat is not None and self.wall is None:
            yield dotted(ShaftSupport.wall_at_seat), Text("needs wall_mm: the wall that is left at this seat")


@inputs
class Part:
    """Parts of one kind in the assembly."""

    part: str = text("Part", help="What it is, in any words.")
    count: int = integer("Number", default=1, within=(1, 10000), help="How many of them the assembly has.")


@inputs
class Alternative:
    """What the shaft costs in one material."""

    material: str = text(
        "Material", help="A name from the table of materials or from [[material]].", catalogue="materials"
    )
    tooling: float = quantity(
        "Tooling", "€", within=(0, 1e9), source="Finotti 2013, 4.2", help="Cost of dies and fixtures, paid once."
    )
    piece: float = quantity(
        "Cost of a piece", "€", within=(0, 1e6), source="Finotti 2013, 4.2", help="Cost of one shaft in this material."
    )
    development: float = quantity(
        "Research and development",
        "€",
        default=0.0,
        within=(0, 1e9),
        source="Finotti 2013, 4.2",
        help="Cost of research and development, paid once.",
    )


@inputs
class Cost:
    """Yearly volume, and the alternatives to compare."""

    pieces_per_year: int = integer(
        "Pieces per year",
        within=(1, 10**9),
        symbol="N",
        source="Finotti 2013, 4.2",
        help="Shafts made in the first year, for which the cost is compared.",
    )
    alternatives: tuple[Alternative, ...] = tables("Alternatives", Alternative)

    def problems(self) -> Iterable[tuple[str, Text]]:
        names = [a.material for a in self.alternatives]
        if len(set(names)) < len(names):
            yield dotted(Cost.alternatives), Text("name each material once")
