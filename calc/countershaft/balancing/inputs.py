# SPDX-License-Identifier: Apache-2.0
"""What the shop says of its balancing: the machine, where it counts angles from, its holes, and what it read.

Every key may be left out: the empty table asks for the sheet."""

import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

from ...sheet.quantity import choice, dotted, inputs, quantity, series, tables, text
from ...sheet.record import record
from ...sheet.text import COMMA, Amount, Name, Text

POINT = math.radians(118.0)  # of a usual twist drill
ENGINE, OF_MASS = "engine", "mass "  # the words of `zero`, the second before a name
MOST_HOLES = 12
SERIAL = re.compile(r"[A-Za-z0-9-]+")
SIMILAR = 1e-9  # m
WIDEST = 720  # degrees, of all angles here
ROUNDING = 1e-9  # rad


@inputs
class BalancingHole:
    """Where the shop may drill."""

    name: str = text("Name")
    z: float = quantity(
        "Position", "mm", within=(-5000, 5000), symbol="z_k", help="From mid-shaft, + towards the flywheel."
    )
    angle: float = quantity(
        "Angle",
        "°",
        within=(-WIDEST, WIDEST),
        symbol="phi_k",
        step=1,
        help="As those of the masses: with cylinder 1 at TDC, from up, in the sense of crank rotation.",
    )
    diameter: float = quantity("Diameter", "mm", up_to=200, symbol="d_c", help="Of the drill.")
    depth_max: float = quantity(
        "Greatest depth",
        "mm",
        up_to=500,
        symbol="h_c",
        help="Of the full diameter, from the outer radius; the drill's cone goes on from there.",
    )
    radius: float | None = quantity(
        "Outer radius there",
        "mm",
        default=None,
        up_to=1000,
        symbol="R",
        help="From which the depth counts. Left out: that of the shaft's outline at this place.",
    )
    point: float = quantity(
        "Point angle of the drill", "°", default=POINT, within=(60, 180), symbol="theta_c", help="180: flat."
    )


@inputs
class MachineReading:
    """What the machine read of one shaft, in both planes."""

    serial: str = text("Serial number", help="Letters, digits and hyphens.")
    front: float = quantity("Unbalance, front plane", "g·mm", within=(0, 1e8), help="At the first bearing.")
    front_: float = quantity(
        "its angle", "°", within=(-WIDEST, WIDEST), help="From the shop's zero, in the sense in which the shop counts."
    )
    rear: float = quantity("Unbalance, rear plane", "g·mm", within=(0, 1e8), help="At the last bearing.")
    rear_: float = quantity(
        "its angle", "°", within=(-WIDEST, WIDEST), help="From the shop's zero, in the sense in which the shop counts."
    )
    kind: str = choice(
        "What was read",
        "residual",
        "total",
        default="residual",
        help="residual: the machine, or compensating rings, took the target off. total: the target is still in it.",
    )

    @staticmethod
    def as_read(reading: dict[str, object]) -> dict[str, object]:
        """A serial number may be a number."""
        key = dotted(MachineReading.serial)
        return {**reading, key: str(reading[key])} if type(reading.get(key)) is int else reading

    def problems(self) -> Iterable[tuple[str, Text]]:
        if not SERIAL.fullmatch(self.serial):
            yield dotted(MachineReading.serial), Text("must be of letters, digits and hyphens")


@inputs
class LineCheck:
    """A state in which the end of the line turns the mounted shaft."""

    speed: float = quantity("Speed of the shaft", "rpm", within=(10, 30000), help="Of the shaft, not of the crank.")
    oil_temperature: float = quantity(
        "Oil temperature", "°C", within=(-40, 200), help="Of the oil that is fed to the bearings there."
    )


@inputs
class Balancing:
    """The balancing machine, its rings, the holes, what it read, and the checks at the end of the line."""

    speed: float = quantity(
        "Speed of the balancing machine",
        "rpm",
        default=500 / 60,
        within=(100, 3000),
        symbol="n_b",
        step=50,
        help="Of the shaft on the machine.",
        change=("slower balancing", "faster balancing"),
        repair="free",
    )
    zero: str = text(
        "Angles count from",
        default=ENGINE,
        help='engine: up with cylinder 1 at TDC. mass NAME ("mass front"): the middle of that mass. A number: an angle '
        "in degrees, as those of the masses.",
    )
    count: str = choice(
        "Angles count",
        "with",
        "against",
        default="with",
        help="The shaft's own rotation, in the engine.",
    )
    ring_positions: tuple[float, ...] | None = series(
        "Planes of the compensating rings",
        "mm",
        default=None,
        count=(2, 2),
        within=(-5000, 5000),
        help="[front, rear], from mid-shaft. Left out: at the outer bearings.",
    )
    ring_tolerance: tuple[float, ...] = series(
        "Standard error of a ring",
        "g·mm",
        default=(0.0,),
        count=(1, 2),
        within=(0, 1e6),
        help="In its plane; one number, or [front, rear].",
    )
    measurement_error: tuple[float, ...] = series(
        "Standard error of the machine",
        "g·mm",
        default=(0.0,),
        count=(1, 2),
        within=(0, 1e6),
        help="In a plane; one number, or [front, rear].",
    )
    machine_force: float | None = quantity(
        "Force that a pedestal bears",
        "N",
        default=None,
        up_to=1e6,
        help="Of the balancing machine, turning. Left out: not judged.",
    )
    holes: tuple[BalancingHole, ...] = tables(
        "Holes to drill",
        BalancingHole,
        default=(),
        help="At most 12. Left out: the calibration holes, shared by the masses, each mass's in a row along it.",
    )
    readings: tuple[MachineReading, ...] = tables("Readings", MachineReading, default=())
    line_checks: tuple[LineCheck, ...] = tables("Drag at the end of the line", LineCheck, default=())

    @staticmethod
    def as_read(table: dict[str, object]) -> dict[str, object]:
        """The zero may be a number: an angle."""
        key = dotted(Balancing.zero)
        number = type(table.get(key)) in (int, float)
        return {**table, key: repr(table[key])} if number else table

    @property
    def ring_tolerances(self) -> tuple[float, float]:
        """Front and rear."""
        return self.ring_tolerance[0], self.ring_tolerance[-1]

    @property
    def measurement_errors(self) -> tuple[float, float]:
        return self.measurement_error[0], self.measurement_error[-1]

    def zero_angle(self, angles: Mapping[str, float]) -> float | None:
        """Where the shop counts from [rad], as the masses' angles count; of masses by their names.  None: of none."""
        if self.zero == ENGINE:
            return 0.0
        try:
            degrees = float(self.zero)
        except ValueError:
            return angles.get(self.zero.removeprefix(OF_MASS), angles.get(self.zero))
        return math.radians(degrees) if abs(degrees) <= WIDEST else None

    def problems(self) -> Iterable[tuple[str, Text]]:
        rings = self.ring_positions
        if rings is not None and len(rings) == 2 and abs(rings[1] - rings[0]) < SIMILAR:
            yield dotted(Balancing.ring_positions), Text("must be two unlike planes")
        if len(self.holes) > MOST_HOLES:
            yield dotted(Balancing.holes), Text("at most {n} holes, has {count}", n=MOST_HOLES, count=len(self.holes))
        serials = [reading.serial for reading in self.readings]
        for i, serial in enumerate(serials):
            if serial in serials[:i]:
                there = Text("{name} is there already: each has a number of its own", name=Name(serial))
                yield dotted(Balancing.readings, i, MachineReading.serial), there


@record
class Stretch:
    """A given section of the shaft: where it begins and ends, its outer radius, and of a sector where its middle stands
    and half of what it spans."""

    start: float
    end: float
    radius: float
    middle: float | None
    half: float | None

    @property
    def sector(self) -> bool:
        return self.half is not None


def problems(
    table: Balancing, angles: Mapping[str, float], sections: Sequence[Stretch], outer_radius: float | None
) -> Iterator[tuple[str, Text]]:
    """What of the table does not go with its shaft: `angles` of its masses by their names, empty where they are found;
    its given sections; the outer radius of its sectors elsewhere."""
    if angles and table.zero_angle(angles) is None:
        of = ", ".join(f'"{OF_MASS}{name}"' for name in angles)
        yield (
            dotted(Balancing.zero),
            Text('must be "engine", an angle from -720 to 720 degrees, or one of {masses}', masses=of),
        )
    for i, hole in enumerate(table.holes):
        yield from ((dotted(Balancing.holes, i, key), why) for key, why in _hole(hole, sections, outer_radius))


def _hole(hole: BalancingHole, sections: Sequence[Stretch], outer_radius: float | None) -> Iterator[tuple[str, Text]]:
    """Of given sections: whether there is one, and how far out; what only solving tells is a check."""
    sectors = [section for section in sections if section.sector]
    there = [section for section in sectors or sections if section.start <= hole.z <= section.end]
    if sectors and not there:
        where = ", ".join(f"{s.start * 1e3:g} … {s.end * 1e3:g}" for s in sectors)
        yield dotted(BalancingHole.z), Text("lies in no sector; they are {where} mm", where=where)
    elif there and all(s.middle is not None and s.half is not None for s in there):
        reach = [(s.middle or 0.0, s.half or 0.0) for s in there]
        if not any(within(hole.angle, *each) for each in reach):
            where = COMMA.join(dict.fromkeys(from_to(*each) for each in reach))
            words = Text("must lie in the sector there, which goes {where}: outside of it is air", where=where)
            yield dotted(BalancingHole.angle), words
    R = hole.radius
    if R is None:
        R = there[0].radius if there else outer_radius
    if R is not None and hole.depth_max >= R:
        yield (
            dotted(BalancingHole.depth_max),
            Text("must stay below the outer radius there, {R} mm: a hole ends before the axis", R=_mm(R)),
        )
    if R is not None and hole.diameter >= 2 * R:
        yield dotted(BalancingHole.diameter), Text("must stay below the diameter there, {D} mm", D=_mm(2 * R))


def within(angle: float, middle: float, half: float) -> bool:
    """Whether a direction lies in a sector [rad]."""
    return abs(math.remainder(angle - middle, 2 * math.pi)) <= half + ROUNDING


def from_to(middle: float, half: float) -> Text:
    """Where a sector begins and ends, in the engine."""
    turn = 2 * math.pi
    at = middle % turn
    at -= turn if at + half > turn + ROUNDING else 0.0
    low, high = (Amount(round(math.degrees(angle), 6), "°", form="g") for angle in (at - half, at + half))
    return Text("from {low} to {high}", low=low, high=high)


def _mm(length: float) -> Amount:
    return Amount(length * 1000.0, form="g")
