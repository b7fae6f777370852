# SPDX-License-Identifier: Apache-2.0
"""Numbers that are given outside what is usual: a unit or a digit that slipped, more often than a bold design.

What is a little outside is said in a note. What is far outside, or does not fit the other numbers, is a caution."""

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from statistics import median
from typing import Any

from ..bearings.inputs import BearingsInputs
from ..countershaft.inputs import ShaftInputs
from ..countershaft.rows import ROW, SHAFT, BearingRow, row_key
from ..engine.gas import COMPRESSION, INTAKE, GasInputs
from ..engine.inputs import EngineInputs
from ..gears.inputs import GearsInputs
from ..gears.wheel_inputs import Wheel
from ..mounting.inputs import Mount, MountingInputs, Point
from ..sheet.check import Check, CheckRule
from ..sheet.quantity import Quantity, described, dotted, given
from ..sheet.record import record, replace
from ..sheet.remedy import Change, Remedy, remedy, whole
from ..sheet.step import Outcome
from ..sheet.text import EMPTY, SEMICOLON, Amount, Name, Text, alternatives, plural
from .addresses import called, within
from .model import STEP_KEYS, Design

SHOWN = 4

FAR = 3.0  # times an end of the usual range: beyond it is far
FAR_KELVIN = 50.0  # the same of temperatures, whose zero is no zero
DEGREE = 180 / math.pi
# What a number may be wrong by, the most plausible first: a unit a thousand times larger, a digit, an inch; of speeds
# radians or turns a second.
SLIPS: dict[str, tuple[float, ...]] = {
    "mm": (1000.0, 10.0, 25.4),
    "rpm": (30 / math.pi, 60.0, 1000.0, 10.0),
    "°": (DEGREE,),
    "%": (100.0,),
    "": (100.0, 10.0, 1000.0),
    "10⁻⁶/K": (1e6, 10.0),
}
OTHER_SLIPS = (1000.0, 10.0)
READINGS = 2  # of one number, at most
MAKERS = Text("rule of thumb, from what makers build")


# --- one input by itself


@record
class Unusual:
    """One input: its key, and the number furthest outside, in the unit of `about`, as the range is; `beyond`: by so
    many ranges.  `far`: so far that it is a caution.  `content`: what is given, in SI."""

    key: str
    about: Quantity
    number: float
    usual: tuple[float, float]
    beyond: float
    far: bool
    content: Any
    shaft: str = ""  # the name of that of several that it is of

    @property
    def words(self) -> Text:
        low, high = self.usual
        input = called(self.key, self.about)
        return Text(
            "{input} {value} (usual {low} to {high})",
            input=Text("{name}: {words}", name=Name(self.shaft), words=input) if self.shaft else input,
            value=Amount(self.number, self.about.unit),
            low=Amount(low),
            high=Amount(high),
        )


def unusual(design: Design, steps: Iterable[str] = STEP_KEYS, checks: Iterable[Check] = ()) -> list[Unusual]:
    """The furthest outside first, without what one of the `checks` says already.  Ranges are those that the form shows
    beside a field."""
    known = {check.id for check in checks if check.rule.of_input}
    several = len(design.originals) > 1
    outliers = {x.key: x for step in steps for x in _of_step(design, step) if _id(design, step, x) not in known}
    found = [replace(x, shaft=design.shaft_of(x.key)) if several else x for x in outliers.values()]
    return sorted(found, key=lambda outlier: -outlier.beyond)


def _of_step(design: Design, step: str) -> Iterator[Unusual]:
    """Of its table, and of the materials of this design that it names."""
    names = set()
    for key, about, content in design.given(step):
        if about.catalogue:
            names.add(content)
        elif about.usual is not None:
            yield from _outlier(key, about, about.usual, content)
    for material in design.material:
        if material.name in names:
            for key, about, content in given(material, dotted(Design.material, material.name)):
                if about.usual is not None:
                    yield from _outlier(key, about, about.usual, content)


def _outlier(key: str, about: Quantity, usual: tuple[float, float], content: Any) -> Iterator[Unusual]:
    low, high = usual
    numbers = [about.units.shown(x) for x in (content if isinstance(content, tuple) else (content,))]
    far = [x for x in numbers if _times(x, usual, about.unit) > FAR]
    most = max(far or numbers, key=lambda x: max(low - x, x - high), default=low)
    if far or not low <= most <= high:
        yield Unusual(key, about, most, usual, max(low - most, most - high) / (high - low), bool(far), content)


def _times(number: float, usual: tuple[float, float], unit: str) -> float:
    """How far a number lies outside its usual range: more than 3 is far.

    Of a range above 0 it is how many times the nearer end: a rule of thumb is known to a factor of 3 at worst. Of one
    that reaches 0 or below it counts the widths of the range from its further end, and far is as well what would still
    be usual were it in a unit larger by 1000 (of angles, in radians; of per cent, as a share): 0.0002 mrad is far.
    Temperatures are far by 50 K. A 0 is never far: nobody writes it by a slip."""
    low, high = usual
    outside = max(low - number, number - high)
    if unit == "°C":
        return 1 + outside * (FAR - 1) / FAR_KELVIN
    if number == 0:
        return 0.0
    if low > 0:
        return max(low / number, number / high) if number > 0 else math.inf
    return max(1 + outside / (high - low), FAR * _least(usual, unit) / abs(number))


def _least(usual: tuple[float, float], unit: str) -> float:
    """Of a range that reaches 0: what would still be usual in a larger unit."""
    return max(map(abs, usual)) / SLIPS.get(unit, OTHER_SLIPS)[0] if unit else 0.0


FAR_OUTSIDE = {
    step: CheckRule(
        f"{step}.inputs.N",
        "caution",
        "A number so far from what is usual is a slip of unit or digit far more often than a bold design.",
        sense="in",
        of_input=True,
    )
    for step in STEP_KEYS
}


def _id(design: Design, step: str, outlier: Unusual) -> str:
    id, shaft = FAR_OUTSIDE[step].of(_at(outlier.key)), design.shaft_of(outlier.key)
    return design.ids_of(step, shaft) + id.removeprefix(step) if shaft else id


def _at(key: str) -> str:
    """Where an input stands in its step, or among the materials of the design."""
    return key if key.startswith(dotted(Design.material)) else ".".join(within(key))


def _far_check(step: str, outlier: Unusual) -> Check:
    about, (low, high), x = outlier.about, outlier.usual, outlier.number
    inside, small = about.units.inside, low <= x <= high  # small: usual, were it in a larger unit
    check = FAR_OUTSIDE[step](
        inside(abs(x) if small else x),
        inside(_least(outlier.usual, about.unit)) if small else (inside(low), inside(high)),
        at=_at(outlier.key),
        name=Text("Far from usual: {input}", input=called(outlier.key, about)),
        source=about.source,
        sense=">" if small else "in",
        unit=about.unit,
        moved_by=(outlier.key,),
    )
    return _asking(check, [(_changed(outlier, number),) for number in _meant(outlier)])


def _meant(outlier: Unusual) -> list[float]:
    """What may have been meant: the usual numbers that one of the slips leads to."""
    (low, high), x, unit = outlier.usual, outlier.number, outlier.about.unit
    slips = SLIPS.get(unit, OTHER_SLIPS)
    readings = [x * slips[0]] if low <= x <= high else [reading for slip in slips for reading in (x * slip, x / slip)]
    return [reading for reading in readings if low <= reading <= high][:READINGS]


def _changed(outlier: Unusual, number: float) -> Change:
    """With the number in its place; of a list all numbers, which are in one unit."""
    key, about = outlier.key, outlier.about
    if isinstance(outlier.content, tuple):
        share = number / outlier.number
        return _change(key, about, tuple([x * share for x in outlier.content]))
    return _change(key, about, about.units.inside(number))


# --- what was meant


def _change(key: str, about: Quantity, x: float | tuple[float, ...]) -> Change:
    """Of a key to a content in SI."""
    if isinstance(x, tuple):
        numbers = [whole(about.units.shown(each)) for each in x]
        words = SEMICOLON.join(Text("{x}", x=Amount(each)) for each in numbers)
        return Change(
            key, numbers, Text("{input} [{numbers}] {unit}", input=called(key, about), numbers=words, unit=about.unit)
        )
    number = whole(about.units.shown(x))
    return Change(key, number, Text("{input} {x}", input=called(key, about), x=Amount(number, about.unit, digits=4)))


Wanted = tuple[object, float | tuple[float, ...], tuple[object, ...]]  # a declared field, its content, its place
Reading = tuple[float, tuple[Wanted, ...]]  # the judged value, and the contents with which it is that


def _to(field: object, x: float | tuple[float, ...], *place: object) -> Wanted:
    """Words are made only where something is doubted, which it hardly ever is."""
    return field, x, place


def _in_words(wanted: Wanted) -> Change:
    field, x, place = wanted
    return _change(dotted(*place, field), described(field), x)


def _asking(check: Check, readings: Iterable[tuple[Change, ...]]) -> Check:
    """The check with what may have been meant, the most plausible first."""
    ways: list[Remedy] = [remedy(*changes) for changes in readings]
    if not ways:
        return check
    meant = Text("Did you mean {readings}?", readings=alternatives([way.words for way in ways]))
    return replace(check, remedies=tuple(ways), advice=meant)


def _doubted(
    rule: CheckRule, value: float, limit: float | tuple[float, float], *readings: Reading, at: str = ""
) -> Iterator[Check]:
    """Only where it does not hold, with those of the readings that make it hold."""
    check = rule(value, limit, at=at or ())
    if not check.holds:
        good = (wanted for x, wanted in readings if rule(x, limit, at=at or ()).holds)
        yield _asking(check, [tuple(map(_in_words, wanted)) for wanted in good])


# --- inputs that do not fit each other

ENGINE, BEARINGS, GEARS, MOUNTING = (
    Design.engine,
    Design.bearings,
    Design.gears,
    Design.mounting,
)

MASSES = CheckRule(
    "engine.inputs.masses",
    "caution",
    "Piston and rod that are swapped move every force, and nothing else shows it.",
    Text("Mass of the rod over that of the piston"),
    "in",
    source=Text(
        "rule of thumb, from the engines of this program: 1.07 to 1.43; 0.86 to 1.13 with the heavy pistons of diesels"
    ),
    advice=Text("Look whether piston and rod are swapped, or in another unit."),
    moved_by=(
        dotted(ENGINE, EngineInputs.piston_mass),
        dotted(ENGINE, EngineInputs.rod_mass),
        dotted(ENGINE, EngineInputs.bore),
    ),
    of_input=True,
)
HEAVY = 2450.0  # kg/m³: piston and rod over the cube of the bore, above which the piston is that of a diesel
LIGHT_RATIO, HEAVY_RATIO = (0.8, 1.6), (0.6, 1.15)

PISTON_SPEED = CheckRule(
    "engine.inputs.piston_speed",
    "caution",
    "Stroke and speed do not go together in any engine that is built.",
    Text("Mean piston speed at the rated speed"),
    "in",
    "m/s",
    source=MAKERS,
    advice=Text("Look at crank radius and rated speed: mm, and rpm of the crank."),
    moved_by=(dotted(ENGINE, EngineInputs.crank_radius), dotted(ENGINE, EngineInputs.rated_speed)),
    of_input=True,
)
PISTON_SPEEDS = (4.0, 30.0)  # m/s

CRANK = CheckRule(
    "engine.inputs.crank_ratio",
    "caution",
    "Crank and rod do not go together in any engine that is built: a stroke stands for its half, or a unit slipped.",
    Text("Crank radius over rod length"),
    "in",
    source=MAKERS,
    advice=Text("The crank radius is half the stroke; the rod is measured between its centres."),
    moved_by=(dotted(ENGINE, EngineInputs.crank_radius), dotted(ENGINE, EngineInputs.rod_length)),
    of_input=True,
)
CRANK_RATIOS = (0.15, 0.42)

STROKE = CheckRule(
    "engine.inputs.stroke_ratio",
    "caution",
    "Stroke and bore do not go together in any engine that is built: a radius stands for a diameter, or the reverse.",
    Text("Stroke over bore"),
    "in",
    source=MAKERS,
    advice=Text("The bore is a diameter, the crank radius is half the stroke."),
    moved_by=(dotted(ENGINE, EngineInputs.bore), dotted(ENGINE, EngineInputs.crank_radius)),
    of_input=True,
)
STROKE_RATIOS = (0.4, 1.8)

PITCH = CheckRule(
    "engine.inputs.cylinder_pitch",
    "caution",
    "Nobody sets cylinders in a row two bores apart.",
    Text("Cylinder pitch over bore"),
    "<=",
    source=MAKERS,
    advice=Text("The pitch is the distance of neighbouring cylinders of a row, the bore a diameter."),
    moved_by=(dotted(ENGINE, EngineInputs.cylinder_pitch), dotted(ENGINE, EngineInputs.bore)),
    of_input=True,
)
WIDEST_PITCH = 1.9

ROD_CG = CheckRule(
    "engine.inputs.rod_cg",
    "caution",
    "A rod is heavier at its big end: a centre of gravity beyond the middle is measured from the small one.",
    Text("Centre of gravity of the rod from the big end, over its length"),
    "in",
    source=MAKERS,
    advice=Text("It is measured from the centre of the big end."),
    moved_by=(dotted(ENGINE, EngineInputs.rod_cg_to_big_end), dotted(ENGINE, EngineInputs.rod_length)),
    of_input=True,
)
ROD_CGS = (0.1, 0.5)

CRANK_ANGLES = CheckRule(
    "engine.inputs.crank_angles",
    "caution",
    "Pins that stand less than 7° around cylinder 1 are given in radians.",
    Text("Largest crank angle"),
    ">",
    "°",
    source=Text("a whole turn is 2π radians"),
    advice=Text("Crank angles are in degrees."),
    moved_by=(dotted(ENGINE, EngineInputs.crank_angles),),
    of_input=True,
)
TURN = math.radians(2 * math.pi)  # 2π as if it were degrees

POWER = CheckRule(
    "engine.inputs.rated_power",
    "caution",
    "The displacement can not give this power at this speed: it is in another unit, or of another engine.",
    Text("Brake mean effective pressure by the rated power"),
    "in",
    "bar",
    source=MAKERS,
    advice=Text("Rated power is in kW (1 PS is 0.735 kW) and of the whole engine."),
    moved_by=(
        dotted(ENGINE, EngineInputs.rated_power),
        dotted(ENGINE, EngineInputs.rated_speed),
        dotted(ENGINE, EngineInputs.bore),
        dotted(ENGINE, EngineInputs.crank_radius),
    ),
    of_input=True,
)
MEAN_PRESSURES = (1.5e5, 32e5)  # Pa
PS = 0.73549875  # kW


BURNING = CheckRule(
    "engine.inputs.gas",
    "caution",
    "No gas burns to so many times what it is compressed to: one of the pressures is in another unit.",
    Text("Peak pressure over that at the end of compression"),
    "<=",
    source=Text("rule of thumb: 1.3 to 4"),
    advice=Text("Pressures are in bar, absolute."),
    moved_by=(
        dotted(ENGINE, EngineInputs.gas, GasInputs.peak_pressure),
        dotted(ENGINE, EngineInputs.gas, GasInputs.intake_pressure),
        dotted(ENGINE, EngineInputs.gas, GasInputs.compression_ratio),
    ),
    of_input=True,
)
MOST_BURNING = 6.0


def _engine(design: Design) -> Iterator[Check]:
    """The crank train: every ratio is of numbers that a maker prints."""
    engine = design.engine
    assert engine is not None
    D, r, L, a = engine.bore, engine.crank_radius, engine.rod_length, engine.cylinder_pitch
    n, piston, rod, X = engine.rated_speed, engine.piston_mass, engine.rod_mass, engine.rod_cg_to_big_end
    speeds = [(4 * r * x, (_to(EngineInputs.rated_speed, x, ENGINE),)) for x in (n * 30 / math.pi, n * 60)]
    yield from _doubted(PISTON_SPEED, 4 * r * n, PISTON_SPEEDS, *speeds)
    yield from _doubted(CRANK, r / L, CRANK_RATIOS, (r / 2 / L, (_to(EngineInputs.crank_radius, r / 2, ENGINE),)))
    diameter = (_to(EngineInputs.bore, 2 * D, ENGINE),)
    yield from _doubted(STROKE, 2 * r / D, STROKE_RATIOS, (r / D, diameter))
    if engine.layout == "inline" and engine.cylinders > 1 and a is not None:
        yield from _doubted(PITCH, a / D, WIDEST_PITCH, (a / (2 * D), diameter))
    if piston and rod:
        heavy = (piston + rod) / D**3 > HEAVY
        swapped = (_to(EngineInputs.piston_mass, rod, ENGINE), _to(EngineInputs.rod_mass, piston, ENGINE))
        yield from _doubted(MASSES, rod / piston, HEAVY_RATIO if heavy else LIGHT_RATIO, (piston / rod, swapped))
    if X:
        yield from _doubted(ROD_CG, X / L, ROD_CGS, (1 - X / L, (_to(EngineInputs.rod_cg_to_big_end, L - X, ENGINE),)))
    angles = engine.crank_angles
    if angles is not None and any(angles):
        largest = max(map(abs, angles))
        degrees = _to(EngineInputs.crank_angles, tuple([x * DEGREE for x in angles]), ENGINE)
        yield from _doubted(CRANK_ANGLES, largest, TURN, (largest * DEGREE, (degrees,)))
    if engine.rated_power is not None:
        cycles = engine.cylinders * n * 2 / engine.strokes  # in a second
        per_watt = 1 / (math.pi / 2 * D**2 * r * cycles)
        readings = [engine.rated_power * x for x in (1e-3, PS)]
        by_power = [(x * per_watt, (_to(EngineInputs.rated_power, x, ENGINE),)) for x in readings]
        yield from _doubted(POWER, engine.rated_power * per_watt, MEAN_PRESSURES, *by_power)
    if (gas := engine.gas) is not None and gas.peak_pressure and gas.compression_ratio:
        drawn = gas.intake_pressure if gas.intake_pressure is not None else INTAKE
        rise = gas.peak_pressure / (drawn * gas.compression_ratio**COMPRESSION)
        intake = _to(GasInputs.intake_pressure, 10 * drawn, ENGINE, EngineInputs.gas)
        in_bar: list[Reading] = [] if gas.intake_pressure is None else [(rise / 10, (intake,))]
        yield from _doubted(BURNING, rise, MOST_BURNING, *in_bar)


AXIS = CheckRule(
    "countershaft.inputs.axis",
    "caution",
    "A shaft that is nearer to the crank than its throw is struck by it.",
    Text("Distance of the shaft's axis from the crank's, over the crank radius"),
    ">=",
    source=Text("geometry: the crank pin turns there"),
    advice=Text("Both numbers are in mm."),
    moved_by=(dotted(SHAFT, ShaftInputs.axis), dotted(ENGINE, EngineInputs.crank_radius)),
    of_input=True,
)


def _countershaft(design: Design) -> Iterator[Check]:
    shaft, engine = design.countershaft, design.engine
    if shaft is not None and engine is not None and shaft.axis is not None:
        away = math.hypot(*shaft.axis) / engine.crank_radius
        in_metre = _to(ShaftInputs.axis, tuple([1e3 * x for x in shaft.axis]), SHAFT)
        yield from _doubted(AXIS, away, 1.0, *([(1e3 * away, (in_metre,))] if away < 1e-2 else []))


CORE = CheckRule(
    "bearings.inputs.B.core",
    "caution",
    "A journal that is long for its diameter, and thinner than the core of its shaft: its radius stands for it.",
    Text("Diameter of a long journal over that of the shaft's core"),
    ">=",
    source=Text("rule of thumb, from what makers build: thin journals are short"),
    advice=Text("Journals are given by their diameter, the core by its radius."),
    moved_by=(dotted(ROW, BearingRow.diameter), dotted(SHAFT, ShaftInputs.core_radius)),
    of_input=True,
)
LONG = 0.85  # diameters

LENGTH = CheckRule(
    "bearings.inputs.B.length",
    "caution",
    "No journal is so short or so long: a unit slipped.",
    Text("Journal length over its diameter"),
    "in",
    source=Text("rule of thumb, from what makers build: 0.3 to 1"),
    advice=Text("Length and diameter are in mm."),
    moved_by=(dotted(ROW, BearingRow.length), dotted(ROW, BearingRow.diameter)),
    of_input=True,
)
LENGTHS = (0.15, 2.0)
PLAIN_JOURNALS = (10e-3, 0.4)  # m: lengths and diameters that may have been meant

CLEARANCE = CheckRule(
    "bearings.inputs.B.clearance",
    "caution",
    "No journal runs so tight or so loose: a unit slipped, or a radial clearance stands for a diametral one.",
    Text("Clearance over the diameter"),
    "in",
    "‰",
    source=Text("rule of thumb, from what makers build: 0.5 to 4 ‰"),
    advice=Text("The clearance is diametral, in µm."),
    moved_by=(dotted(ROW, BearingRow.clearance), dotted(ROW, BearingRow.diameter)),
    of_input=True,
)
CLEARANCES = (0.2e-3, 10e-3)

LOAD = CheckRule(
    "bearings.inputs.B.load",
    "caution",
    "No journal carries so little or so much: a unit slipped.",
    Text("Load over length and diameter"),
    "in",
    "MPa",
    source=Text("rule of thumb, from what makers build: 1 to 20 MPa; a bare shaft weighs 0.02"),
    advice=Text("The load is in N."),
    moved_by=(dotted(ROW, BearingRow.load), dotted(ROW, BearingRow.length)),
    of_input=True,
)
LOADS = (0.01e6, 150e6)  # Pa

PRESSURE = CheckRule(
    "bearings.inputs.supply_pressure",
    "caution",
    "No pump holds so little at a journal: the pressure is in MPa.",
    Text("Pressure of the oil supplied"),
    ">=",
    "bar",
    source=MAKERS,
    advice=Text("It is in bar above ambient; 0 where nothing presses."),
    moved_by=(dotted(BEARINGS, BearingsInputs.supply_pressure),),
    of_input=True,
)
LEAST_PRESSURE = 1e5  # Pa

VISCOSITY = CheckRule(
    "bearings.inputs.viscosity",
    "caution",
    "No oil is so thin or so thick at a journal: a unit slipped.",
    Text("Viscosity at every temperature"),
    "in",
    "mPa·s",
    source=Text("rule of thumb: 2 mPa·s is a hot 0W-20, 1 Pa·s a cold gear oil"),
    advice=Text("It is in mPa·s, which is cP."),
    moved_by=(dotted(BEARINGS, BearingsInputs.viscosity),),
    of_input=True,
)
VISCOSITIES = (0.5e-3, 2.0)  # Pa·s


def _bearings(design: Design) -> Iterator[Check]:
    bearings, shaft = design.bearings, design.countershaft
    assert bearings is not None
    for bearing in design.rows:
        if bearing.diameter is None or bearing.length is None:
            continue
        yield from _journal(bearing.name, bearing, shaft.core_radius if shaft is not None else None)
    p, mu = bearings.supply_pressure, bearings.viscosity
    if p:
        mega = 10 * p
        yield from _doubted(PRESSURE, p, LEAST_PRESSURE, (mega, (_to(BearingsInputs.supply_pressure, mega, BEARINGS),)))
    if mu is not None:
        scaled = [(x, (_to(BearingsInputs.viscosity, x, BEARINGS),)) for x in (1e3 * mu, 1e-3 * mu)]
        yield from _doubted(VISCOSITY, mu, VISCOSITIES, *scaled)


def _journal(place: str, bearing: BearingRow, core: float | None) -> Iterator[Check]:
    d, l, g, F = bearing.diameter, bearing.length, bearing.clearance, bearing.load
    if core and l > LONG * d:
        doubled = (_to(BearingRow.diameter, 2 * d, row_key(place)),)
        yield from _doubted(CORE, d / (2 * core), 1.0, (d / core, doubled), at=place)
    sizes = [
        (ratio, (_to(field, x, row_key(place)),))
        for slip in (10.0, 0.1, 1000.0, 0.001, 25.4, 1 / 25.4)
        for ratio, field, x in (
            (slip * l / d, BearingRow.length, slip * l),
            (l / (slip * d), BearingRow.diameter, slip * d),
        )
        if PLAIN_JOURNALS[0] <= x <= PLAIN_JOURNALS[1]
    ]
    yield from _doubted(LENGTH, l / d, LENGTHS, *sizes, at=place)
    if g is not None:
        scaled = [(x / d, (_to(BearingRow.clearance, x, row_key(place)),)) for x in (1e3 * g, 10 * g, g / 10)]
        yield from _doubted(CLEARANCE, g / d, CLEARANCES, *scaled, at=place)
    if F is not None:
        kilo = 1e3 * F
        reading = (kilo / (l * d), (_to(BearingRow.load, kilo, row_key(place)),))
        yield from _doubted(LOAD, F / (l * d), LOADS, reading, at=place)


FACE = CheckRule(
    "gears.inputs.face_width",
    "caution",
    "No wheel is so thin or so broad: a unit slipped.",
    Text("Face width over the normal module"),
    "in",
    source=Text("rule of thumb: 6 to 40; a split wheel against backlash 2"),
    advice=Text("Both are in mm."),
    moved_by=(dotted(GEARS, GearsInputs.face_width), dotted(GEARS, GearsInputs.normal_module)),
    of_input=True,
)
WHEEL_FACE = CheckRule(
    "gears.inputs.W.face_width",
    "caution",
    "No wheel is so thin or so broad: a unit slipped.",
    Text("Face width of a wheel over the normal module"),
    "in",
    source=FACE.source,
    advice=FACE.advice,
    moved_by=(dotted(GEARS, GearsInputs.wheels, "W", Wheel.face_width), dotted(GEARS, GearsInputs.normal_module)),
    of_input=True,
)
FACES = (2.0, 60.0)

GEAR_POWER = CheckRule(
    "gears.inputs.power",
    "caution",
    "A train takes no more than its engine gives.",
    Text("Power of the train over that of the engine"),
    "<=",
    source=Text("energy: it comes from the engine"),
    advice=Text("Both are in kW."),
    moved_by=(dotted(GEARS, GearsInputs.power), dotted(ENGINE, EngineInputs.rated_power)),
    of_input=True,
)


def _gears(design: Design) -> Iterator[Check]:
    gears, engine = design.gears, design.engine
    assert gears is not None
    module, b = gears.module, gears.face_width
    wider = 10 * b
    yield from _doubted(FACE, b / module, FACES, (wider / module, (_to(GearsInputs.face_width, wider, GEARS),)))
    for wheel in gears.wheels:
        if (b_w := wheel.face_width) is not None:
            wider = 10 * b_w
            to_wider = (_to(Wheel.face_width, wider, GEARS, GearsInputs.wheels, wheel.name),)
            yield from _doubted(WHEEL_FACE, b_w / module, FACES, (wider / module, to_wider), at=wheel.name)
    P, rated = gears.power, engine.rated_power if engine is not None else None
    if P is not None and rated is not None:
        watt = P * 1e-3
        yield from _doubted(GEAR_POWER, P / rated, 1.0, (watt / rated, (_to(GearsInputs.power, watt, GEARS),)))


MASS = CheckRule(
    "mounting.inputs.mass",
    "caution",
    "No engine of this displacement is so light or so heavy: a unit slipped.",
    Text("Mass on the mounts over the displacement"),
    "in",
    "kg/m³",
    source=Text("rule of thumb: 60 to 250 kg a litre"),
    advice=Text("It is in kg."),
    moved_by=(dotted(MOUNTING, MountingInputs.mass),),
    of_input=True,
)
PER_LITRE = (15e3, 1000e3)  # kg/m³

GYRATION = CheckRule(
    "mounting.inputs.inertia",
    "caution",
    "Mass and inertia do not go together: a unit slipped.",
    Text("Radius of gyration"),
    "in",
    "mm",
    source=Text("rule of thumb: a quarter to a third of the size of a body"),
    advice=Text("Inertia is in kg·m², mass in kg."),
    moved_by=(dotted(MOUNTING, MountingInputs.inertia), dotted(MOUNTING, MountingInputs.mass)),
    of_input=True,
)
RADII = (0.03, 3.0)  # m

BOUNCE = CheckRule(
    "mounting.inputs.stiffness",
    "caution",
    "No mounts are so soft or so stiff for their mass: a unit slipped.",
    Text("Frequency of the mass on the mean stiffness of its mounts"),
    "in",
    "Hz",
    source=Text("rule of thumb: 4 to 30 Hz on rubber"),
    advice=Text("Stiffness is in N/mm."),
    moved_by=(dotted(MOUNTING, MountingInputs.mounts), dotted(MOUNTING, MountingInputs.mass)),
    of_input=True,
)
FREQUENCIES = (1.0, 100.0)  # Hz


PLACE = CheckRule(
    "mounting.inputs.N.place",
    "caution",
    "What is so near the origin and not in it is given in another unit.",
    Text("Distance from the middle of the crank"),
    ">=",
    "mm",
    source=Text("the origin is in the crank, where no mount has room"),
    advice=Text("Positions are in mm."),
    of_input=True,
)
NEAREST = 5e-3  # m

UNLIKE = CheckRule(
    "mounting.inputs.N.stiffness",
    "caution",
    "The mounts of an engine share its weight: one that is a hundred times as stiff as the others is in another unit.",
    Text("Stiffness over that of the other mounts"),
    "in",
    source=MAKERS,
    advice=Text("Stiffness is in N/mm."),
    of_input=True,
)
SHARES = (0.02, 50.0)  # of the median


def _mounting(design: Design) -> Iterator[Check]:
    mounting, engine = design.mounting, design.engine
    assert mounting is not None and engine is not None
    m, litres = mounting.mass, engine.cylinders * math.pi / 2 * engine.bore**2 * engine.crank_radius
    scaled = [(x / litres, (_to(MountingInputs.mass, x, MOUNTING),)) for x in (1e3 * m, 1e-3 * m)]
    yield from _doubted(MASS, m / litres, PER_LITRE, *scaled)
    if J := mounting.inertia:
        furthest = max(J, key=lambda x: _times(math.sqrt(x / m), RADII, "mm"))
        readings: list[Reading] = [
            (math.sqrt(furthest * x / m), (_to(MountingInputs.inertia, tuple([each * x for each in J]), MOUNTING),))
            for x in (1e-3, 1e-4, 1e-6)
        ]
        yield from _doubted(GYRATION, math.sqrt(furthest / m), RADII, *readings)
    for array, places in ((MountingInputs.mounts, mounting.mounts), (MountingInputs.points, mounting.points)):
        for place in places:
            if (r := math.hypot(*place.position)) > 0:
                in_metre = tuple([1e3 * x for x in place.position])
                field = Mount.position if isinstance(place, Mount) else Point.position
                reading = (1e3 * r, (_to(field, in_metre, MOUNTING, array, place.name),))
                for check in _doubted(PLACE, r, NEAREST, reading, at=place.name):
                    yield replace(check, moved_by=(dotted(MOUNTING, array, place.name, field),))
    for mount in mounting.mounts:
        others = median([sum(other.stiffness) for other in mounting.mounts])
        share = sum(mount.stiffness) / others if others else 1.0
        key = (MOUNTING, MountingInputs.mounts, mount.name)
        slipped = [
            (share * x, (_to(Mount.stiffness, tuple([x * k for k in mount.stiffness]), *key),)) for x in (1e-3, 1e3)
        ]
        for check in _doubted(UNLIKE, share, SHARES, *slipped, at=mount.name):
            yield replace(check, moved_by=(dotted(*key, Mount.stiffness), dotted(MOUNTING, MountingInputs.mounts)))
    if k := sum(sum(mount.stiffness) / len(mount.stiffness) for mount in mounting.mounts):
        yield from _doubted(BOUNCE, math.sqrt(k / m) / (2 * math.pi), FREQUENCIES)


# --- in the steps that they belong to


CROSSED: dict[str, Callable[[Design], Iterator[Check]]] = {
    dotted(ENGINE): _engine,
    "countershaft": _countershaft,
    dotted(BEARINGS): _bearings,
    dotted(GEARS): _gears,
    dotted(MOUNTING): _mounting,
}


def doubts(design: Design, step: str) -> tuple[Check, ...]:
    """The cautions on the inputs of a step: those far outside, and those that do not fit each other, but for what is
    far outside itself."""
    far = [_far_check(step, outlier) for outlier in _of_step(design, step) if outlier.far]
    known = {key for check in far for key in check.moved_by}
    crossed = CROSSED[step](design) if step in CROSSED else ()
    alone = []  # of those that share an input the one that knows what was meant
    for check in sorted(crossed, key=lambda check: not check.remedies):
        if known.isdisjoint(check.moved_by):
            alone.append(check)
            known.update(check.moved_by)
    return tuple([check.in_place(design.in_place) for check in (*far, *alone)])


def with_doubts(design: Design, outcomes: Iterable[Outcome[object]]) -> Iterator[Outcome[object]]:
    """The outcomes with the cautions on their inputs, which stand first; where a step has no solution they may say
    why."""
    for outcome in outcomes:
        checks = doubts(design, outcome.key) if outcome.state in ("solved", "no_solution") else ()
        yield replace(outcome, checks=checks + outcome.checks) if checks else outcome


# --- what is not usual, in words


def told(outliers: Sequence[Unusual], most: int = SHOWN) -> Text:
    """Of more than `most` the rest as a number; empty where there are none."""
    if not outliers:
        return EMPTY
    inputs = SEMICOLON.join(outlier.words for outlier in outliers[:most])
    if len(outliers) > most:
        inputs = Text("{names}; {more} more", names=inputs, more=len(outliers) - most)
    return plural(
        "{n} input is not usual: {inputs}", "{n} inputs are not usual: {inputs}", n=len(outliers), inputs=inputs
    )
