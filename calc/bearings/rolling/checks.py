# SPDX-License-Identifier: Apache-2.0
"""What a rolling bearing is judged by."""

from collections.abc import Iterator

from ...countershaft.inputs import ShaftInputs
from ...countershaft.rows import ROW, SHAFT, BearingRow, row_key
from ...sheet.check import Check, CheckRule, Missing
from ...sheet.quantity import dotted
from ...sheet.text import Amount, Text
from ...sheet.units import Celsius, Metre, Number, RevPerSecond, Second
from ...sheet.value import based_on, untraced
from ..formulas import load_at_speed
from ..inputs import BearingsInputs
from ..plain.inputs import SLOPE_TAKEN
from ..plain.speeds import SLOWEST
from ..result import BearingsResult
from ..support import Task, on_bearing
from .clearance import ROOM
from .geometry import gamma_of
from .raceway import HARDNESS, ROUGHNESS, case_depth_needed, largest_slope
from .result import RollingResult
from .solve import LoadedBearing, largest_speed, least_loads

RULE = Text("rule of this program")
SIZE, SHAFT_FIT, SEAT_FIT = (dotted(ROW, key) for key in (BearingRow.size, BearingRow.shaft_fit, BearingRow.seat_fit))
CLASS, HELD = dotted(ROW, BearingRow.clearance_class), dotted(ROW, BearingRow.outer_ring_held)
OIL, T_IN = dotted("bearings", BearingsInputs.oil), dotted("bearings", BearingsInputs.supply_temperature)
CLEAN, LIFE_H = dotted("bearings", BearingsInputs.cleanliness), dotted("bearings", BearingsInputs.life)
RATING = dotted(ROW, BearingRow.dynamic_rating)
HOUSING = dotted("bearings", BearingsInputs.housing_material)
SLOPE, CORE = dotted(ROW, BearingRow.slope), dotted(SHAFT, ShaftInputs.core_radius)
ASSUMED_LIFE: Second = 5000.0 * 3600
LEAST_SAFETY = {"ball": 1.0, "roller": 1.5, "needle": 1.5, "cage": 1.5, "cup": 3.0}
CAGE_LIMIT: dict[str, Celsius] = {"polyamide": 120.0, "steel": 150.0}
HOTTEST: Celsius = 200.0
KNOWN_RATIOS: tuple[Number, Number] = (0.1, 4.0)  # κ
LARGEST_ELEMENTS: Number = 0.4  # γ
RARE: Number = 0.02  # of the hours: less of them is rare
WITHIN: Number = 2.0  # both torques agree within this factor
MICRON: Metre = 1e-6


def _of(field: object) -> str:
    return dotted("bearings", "B", field)


LIFE = CheckRule(
    "bearings.B.life",
    "limit",
    "The raceways flake before the life that is asked.",
    Text("Life"),
    unit="h",
    source=Text("ISO 281:2007, the rows of the duty by Miner"),
    advice=Text("The next size, cleaner or cooler oil."),
    role="chosen",
    decides=True,
    value_id=_of(RollingResult.life),
    moved_by=(SIZE, LIFE_H, CLEAN, T_IN, OIL, RATING),
    short=Text("life"),
)
LIFE_ASSUMED = CheckRule(
    "bearings.B.life_assumed",
    "caution",
    "The same against a life that nobody gave.",
    Text("Life, against one that is assumed"),
    unit="h",
    source=Text("ISO 281:2007, the rows of the duty by Miner; asked: that of the gears, else 5000 h"),
    advice=Text("The next size, cleaner or cooler oil; or say the life that is asked."),
    decides=True,
    value_id=_of(RollingResult.life),
    moved_by=(SIZE, LIFE_H, CLEAN, T_IN, OIL, RATING),
    short=Text("life"),
)
LIFE_REFERENCE = CheckRule(
    "bearings.B.life_reference",
    "caution",
    "Clearance narrows the loaded zone: rigid rings in this clearance live so long, a lower bound.",
    Text("Life with the clearance, a lower bound"),
    unit="h",
    source=Text("ISO/TS 16281, from memory: rigid rings at the running clearance"),
    advice=Text("A smaller clearance class, a housing that expands less, the next size."),
    value_id=_of(RollingResult.life_reference),
    moved_by=(CLASS, SEAT_FIT, HOUSING, SIZE),
    short=Text("life with clearance"),
)
STATIC_SAFETY = CheckRule(
    "bearings.B.static_safety",
    "limit",
    "A shock at overspeed marks the raceways.",
    Text("Static safety"),
    source=Text("SKF 2013: ball 1, roller 1.5, drawn cup 3; ISO 76"),
    advice=Text("The next size."),
    role="physics",
    value_id=_of(RollingResult.static_safety),
    moved_by=(SIZE, dotted("bearings", BearingsInputs.shock_factor), dotted("bearings", BearingsInputs.overspeed)),
    short=Text("static"),
)
SPEED_FACTOR = CheckRule(
    "bearings.B.speed_factor",
    "limit",
    "Cage and elements do not stand the speed.",
    Text("Speed over the limiting speed"),
    "<=",
    "rpm",
    Text("rule of this program: n·d_m by type, from printed limiting speeds, or the limiting speed that is given"),
    Text("Another type, or a smaller size."),
    role="physics",
    demand=True,
    moved_by=(SIZE, dotted(ROW, BearingRow.limiting_speed)),
    short=Text("speed"),
)
RUNNING_TEMPERATURE = CheckRule(
    "bearings.B.running_temperature",
    "caution",
    "The cage softens; the temperature is an upper estimate, since oil that flows through carries more off.",
    Text("Temperature of the bearing, hottest of its duty"),
    "<=",
    "°C",
    Text("ISO 15312's reference state; cage of polyamide 120 °C, of steel 150 °C"),
    Text("A jet, cooler oil, a steel cage."),
    value_id=_of(RollingResult.running_temperature),
    moved_by=(dotted(ROW, BearingRow.cage), T_IN, dotted(ROW, BearingRow.heat), SIZE),
    short=Text("temperature"),
)
CLEARANCE_LEAST = CheckRule(
    "bearings.B.clearance_least",
    "limit",
    "The elements jam between the rings as it runs.",
    Text("Least clearance as it runs"),
    unit="µm",
    source=Text("elasticity: fits and warmth of the rings, at the tight ends of all fields"),
    advice=Text("A larger clearance class, a looser fit."),
    role="physics",
    zero="the clearance as mounted",
    value_id=_of(RollingResult.clearance_least),
    moved_by=(CLASS, SHAFT_FIT, SEAT_FIT),
    short=Text("clearance"),
)
CLEARANCE_START = CheckRule(
    "bearings.B.clearance_start",
    "limit",
    "The shaft warms before the housing: the elements jam at the start.",
    Text("Least clearance at 20 °C, the shaft warm already"),
    unit="µm",
    source=Text("elasticity: fits and warmth of the rings, at the tight ends of all fields"),
    advice=Text("A larger clearance class, a looser fit, an insert of steel."),
    role="physics",
    zero="the clearance as mounted",
    value_id=_of(RollingResult.clearance_start),
    moved_by=(CLASS, SEAT_FIT, SHAFT_FIT, HELD),
    short=Text("clearance at start"),
)
CLEARANCE_FROZEN = CheckRule(
    "bearings.B.clearance_frozen",
    "caution",
    "Aluminium grips the ring hardest in the cold; how hard it turns there is not known.",
    Text("Least clearance at the lowest temperature"),
    unit="µm",
    source=Text("elasticity: fits and warmth of the rings, at the tight ends of all fields"),
    advice=Text("A larger clearance class, or an insert of steel."),
    zero="the clearance as mounted",
    value_id=_of(RollingResult.clearance_cold),
    moved_by=(CLASS, SEAT_FIT, HELD, dotted("bearings", BearingsInputs.lowest_temperature)),
    short=Text("clearance cold"),
)
GRIP_HOT = CheckRule(
    "bearings.B.grip_hot",
    "limit",
    "The outer ring loses its fit and creeps under the load that sweeps it.",
    Text("Loosest fit of the outer ring as it runs"),
    unit="µm",
    source=Text("physics: thermal expansion of the seat and the ring"),
    advice=Text("An insert of steel, a pin, an adhesive; in bare aluminium no fit of a ring holds hot."),
    role="physics",
    zero="its mean interference at 20 °C",
    value_id=_of(RollingResult.grip_hot),
    moved_by=(HELD, SEAT_FIT, HOUSING),
    short=Text("grip"),
)
GRIP_HOT_HELD = CheckRule(
    "bearings.B.grip_hot_held",
    "advice",
    "The outer ring is loose as it runs, and is held otherwise: what holds it is not designed here.",
    Text("Loosest fit of an outer ring that is held otherwise"),
    unit="µm",
    source=Text("physics: thermal expansion of the seat and the ring"),
    advice=Text("See that what holds it carries the friction and the slip."),
    zero="its mean interference at 20 °C",
    value_id=_of(RollingResult.grip_hot),
    moved_by=(HELD, SEAT_FIT),
)
SLOPE_MOST = CheckRule(
    "bearings.B.slope",
    "limit",
    "The journal stands too much aslant: edges of rollers and raceways are overloaded.",
    Text("Slope of the journal"),
    "<=",
    "mrad",
    Text("SKF 2013: permissible misalignment by type"),
    Text("A ball bearing, or a stiffer shaft."),
    role="physics",
    demand=True,
    moved_by=(CORE, SIZE, SLOPE),
    short=Text("slope"),
)
SLOPE_NEAR = CheckRule(
    "bearings.B.slope_near",
    "caution",
    "The journal stands aslant by more than half of what the type bears.",
    Text("Slope of the journal, half of what is allowed"),
    "<=",
    "mrad",
    RULE,
    Text("A ball bearing, or a stiffer shaft."),
    demand=True,
    cause=SLOPE_MOST.id,
    moved_by=(CORE, SIZE, SLOPE),
    short=Text("slope over half"),
)
MINIMUM_LOAD = CheckRule(
    "bearings.B.minimum_load",
    "caution",
    "Too little load: the elements slide and smear the raceways.",
    Text("Load over the duty, where it is least against the minimum load"),
    unit="N",
    source=Text("SKF 2013: minimum load by type; weight and turning load alone"),
    advice=Text("A ball bearing, or a smaller size."),
    moved_by=(SIZE, dotted(ROW, BearingRow.minimum_load)),
    short=Text("minimum load"),
)
MINIMUM_LOAD_RARE = CheckRule(
    "bearings.B.minimum_load_rare",
    "advice",
    "The same in a part of the duty that is rare, or at the slowest speed that is not in it.",
    Text("Load at the slowest speeds against the minimum load"),
    unit="N",
    source=Text("SKF 2013: minimum load by type; weight and turning load alone"),
    advice=Text("A ball bearing, or a smaller size."),
    moved_by=(SIZE, dotted(ROW, BearingRow.minimum_load)),
)
THRUST = CheckRule(
    "bearings.B.thrust",
    "limit",
    "The flanges carry more thrust than they are made for.",
    Text("Thrust over the equivalent load"),
    "<=",
    source=Text("SKF 2013: F_a ≤ 0.5·P of NJ"),
    advice=Text("Let a ball bearing locate the shaft."),
    role="physics",
    demand=True,
    moved_by=(dotted(ROW, BearingRow.locates), SIZE),
)
RACEWAY_HARDNESS = CheckRule(
    "bearings.B.raceway_hardness",
    "caution",
    "A softer shaft flakes earlier than the ratings say.",
    Text("Hardness of the raceway on the shaft"),
    unit="HV",
    source=Text("INA, IKO, SKF: 58 HRC"),
    advice=Text("Harden the raceway."),
    moved_by=(dotted(ROW, BearingRow.raceway_hardness),),
)
RACEWAY_CASE = CheckRule(
    "bearings.B.raceway_case",
    "caution",
    "The case breaks into the core under the elements.",
    Text("Depth of the hard case"),
    unit="mm",
    source=Text("INA, from memory: 0.078·D_w, at least 0.3 mm"),
    advice=Text("A deeper case; 0.1·D_w bears the static load on a core of 350 HV (SKF)."),
    moved_by=(dotted(ROW, BearingRow.case_depth),),
)
RACEWAY_ROUGHNESS = CheckRule(
    "bearings.B.raceway_roughness",
    "caution",
    "A rough raceway shortens the life and wears the cage.",
    Text("Roughness Ra of the raceway on the shaft"),
    "<=",
    "µm",
    Text("INA, IKO, SKF: 0.2 µm up to 80 mm"),
    Text("Grind the raceway."),
    moved_by=(dotted(ROW, BearingRow.raceway_roughness),),
)
RACEWAY_SEAT = CheckRule(
    "bearings.B.raceway_seat",
    "limit",
    "Needles without a ring need a hardened bore.",
    Text("Hardened bore for the needles, 1: there is one"),
    source=Text("INA: raceway of 58 HRC on both sides"),
    advice=Text('A drawn cup HK, or a sleeve of hardened steel (outer_ring_held = "insert").'),
    role="physics",
    exact=True,
    moved_by=(HELD, HOUSING, SIZE),
)
ASSEMBLY = CheckRule(
    "bearings.B.assembly",
    "limit",
    "The ring does not pass the shaft on the way to its place.",
    Text("Bore of the ring over what it passes of the shaft"),
    unit="mm",
    source=Text("geometry: from the end of the shaft that has more room; a wheel may be mounted later"),
    advice=Text("A larger bore, a thinner end of the shaft, a split cage."),
    role="physics",
    exact=True,
    moved_by=(SIZE, CORE),
    short=Text("assembly"),
)
VISCOSITY_RATIO = CheckRule(
    "bearings.B.viscosity_ratio",
    "advice",
    "The surfaces are not parted by the oil.",
    Text("Viscosity ratio"),
    source=Text("ISO 281:2007"),
    advice=Text("A thicker or cooler oil; a_ISO counts it."),
    value_id=_of(RollingResult.viscosity_ratio),
    moved_by=(OIL, T_IN),
)
VISCOSITY_RATIO_OUTSIDE = CheckRule(
    "bearings.B.viscosity_ratio_outside",
    "method",
    "ISO 281 knows viscosity ratios of 0.1 to 4: beyond them a_ISO is that of the nearer end.",
    Text("Viscosity ratio, against the range of ISO 281"),
    "in",
    source=Text("ISO 281:2007"),
    moved_by=(OIL, T_IN),
)
FRICTION_SPREAD = CheckRule(
    "bearings.B.friction_spread",
    "method",
    "Two published formulas of the friction are far apart: the loss is known less well.",
    Text("Larger torque over the smaller, of both formulas"),
    "<=",
    source=Text("SKF 2013; INA's two parts; rule of this program"),
    moved_by=(SIZE, OIL),
)
RATING_ESTIMATE = CheckRule(
    "bearings.B.rating_estimate",
    "method",
    "A rating is computed from the typical inside of such a bearing: an estimate.",
    Text("Ratings that are computed, and not the catalogue's"),
    "<=",
    source=Text("ISO 281, ISO 76 with typical inside"),
    advice=Text("Give dynamic_rating_kN and static_rating_kN of the catalogue."),
    zero="one rating",
    moved_by=(RATING, dotted(ROW, BearingRow.static_rating)),
)
TEMPERATURE_OUTSIDE = CheckRule(
    "bearings.B.temperature_outside",
    "method",
    "Beyond 200 °C neither rings nor formulas are known.",
    Text("Temperature of the bearing, against what is known"),
    "<=",
    "°C",
    RULE,
    moved_by=(T_IN,),
)
GEOMETRY_OUTSIDE = CheckRule(
    "bearings.B.geometry_outside",
    "method",
    "Elements so large for their pitch circle are beyond the tables of ISO 281 and ISO 76.",
    Text("Diameter of the elements over the pitch diameter, γ"),
    "<=",
    source=Text("ISO 281, ISO 76: their tables end there"),
    moved_by=(dotted(ROW, BearingRow.element_diameter), dotted(ROW, BearingRow.pitch_diameter)),
)
REFERENCE_SPEED = CheckRule(
    "bearings.B.reference_speed",
    "advice",
    "Above the reference speed the bearing warms by more than 50 K without oil that cools it.",
    Text("Speed over the thermal reference speed"),
    "<=",
    "rpm",
    Text("ISO 15312, torque by INA's two parts"),
    Text("A smaller size, a jet."),
    demand=True,
    limit_id=_of(RollingResult.reference_speed),
    moved_by=(SIZE,),
)
SYSTEM_LIFE = CheckRule(
    "bearings.system_life",
    "caution",
    "All rolling bearings together reach their life less often than each.",
    Text("Life of all rolling bearings together"),
    unit="h",
    source=Text("ISO 281: Σ (L_s/L_i)^e = 1"),
    advice=Text("The next size of the bearing that lives shortest."),
    value_id=dotted("bearings", BearingsResult.system_life),
    moved_by=(LIFE_H, CLEAN, dotted("bearings", BearingsInputs.supply_temperature)),
)
LOCATING = CheckRule(
    "bearings.locating",
    "caution",
    "Nothing holds the shaft along its axis.",
    Text("Bearings that locate the shaft"),
    source=Text("statics"),
    advice=Text("locates = true of a ball bearing or NJ; or a thrust face that is not designed here."),
    exact=True,
    moved_by=(dotted("shafts", "*", "bearings", "*", BearingRow.locates),),
)


def slowest_speed(inputs: BearingsInputs, task: Task) -> RevPerSecond:
    """The slowest at which the shaft runs: of the range that is given, of the bench run, else as it is assumed."""
    if inputs.speed_range is not None:
        return inputs.speed_range[0]
    return min([point.speed for point in task.bench], default=SLOWEST * task.speed)


# what `rolling_checks` asks of one bearing
OF_ONE = {rule.id for rule in [*globals().values()] if isinstance(rule, CheckRule) and ".B." in rule.id} - {ASSEMBLY.id}


def life_asked(inputs: BearingsInputs, gears: Second | None) -> Second:
    if inputs.life is not None:
        return inputs.life
    return ASSUMED_LIFE if gears is None else gears


def rolling_checks(place: str, r: LoadedBearing) -> Iterator[Check]:
    """What is asked of one bearing."""
    case, row, inputs, size = r.case, r.case.row, r.case.inputs, r.case.size
    asked = life_asked(inputs, r.task.life)
    if r.life is not None:
        yield on_bearing(LIFE if inputs.life is not None else LIFE_ASSUMED, place, r.life, asked)
        yield on_bearing(LIFE_REFERENCE, place, r.life_reference, asked, missing=_inside_missing(place, r))
    if r.static_safety is not None:
        yield on_bearing(STATIC_SAFETY, place, r.static_safety, LEAST_SAFETY[size.type])
    fastest = r.task.speed
    if r.rows is not None and r.rows.n.max() > fastest:
        fastest = based_on(float(r.rows.n.max()), r.rows.n)
    yield on_bearing(SPEED_FACTOR, place, fastest, largest_speed(case))
    hottest = row.temperature_limit if row.temperature_limit is not None else CAGE_LIMIT[row.cage]
    of_value = RUNNING_TEMPERATURE.value_id.replace(".B.", f".{place}.") if r.hottest == r.running_temperature else ""
    T_in = inputs.supply_temperature
    yield on_bearing(RUNNING_TEMPERATURE, place, r.hottest, hottest, base=T_in, value_id=of_value)
    if r.hottest > HOTTEST:
        yield on_bearing(TEMPERATURE_OUTSIDE, place, r.hottest, HOTTEST)
    yield from _clearance_checks(place, r)
    yield from _slope_checks(place, r)
    yield from _load_checks(place, r)
    if not size.inner_ring:
        yield from _raceway_checks(place, r)
    yield on_bearing(VISCOSITY_RATIO, place, r.viscosity_ratio, 1.0)
    low, high = KNOWN_RATIOS
    if not low <= r.viscosity_ratio <= high:
        yield on_bearing(VISCOSITY_RATIO_OUTSIDE, place, r.viscosity_ratio, KNOWN_RATIOS)
    if case.inside is not None:
        with untraced():
            ratio = gamma_of(case.inside)
        if ratio > LARGEST_ELEMENTS:
            yield on_bearing(GEOMETRY_OUTSIDE, place, ratio, LARGEST_ELEMENTS)
    if r.torque and r.torque_two_part:
        spread = r.torque / r.torque_two_part
        yield on_bearing(FRICTION_SPREAD, place, max(spread, 1 / spread), WITHIN)
    given = (row.dynamic_rating, row.static_rating)
    yield on_bearing(RATING_ESTIMATE, place, float(given.count(None)), 0.0, scale=1.0)
    if r.reference_speed is not None:
        yield on_bearing(REFERENCE_SPEED, place, r.task.speed, r.reference_speed)


def of_one(check: Check, place: str) -> bool:
    """Whether it is one of these on that bearing."""
    return check.rule.id in OF_ONE and check.id == check.rule.of(place)


def _inside_missing(place: str, r: LoadedBearing) -> Missing | None:
    """What is not given of a bearing whose clearance nobody knows: its inside, else the clearance before mounting."""
    if r.gap is not None:
        return None
    row = r.case.row
    needed: list[tuple[object, object]] = [(BearingRow.clearance_limits, row.clearance_limits)]
    if r.case.inside is None:
        needed = [
            (BearingRow.element_count, row.element_count),
            (BearingRow.element_diameter, row.element_diameter),
        ]
        if r.case.size.elements == "roller":
            needed.append((BearingRow.element_length, row.element_length))
    return Missing(tuple(row_key(place, key) for key, given in needed if given is None), (), "none", "none")


def _clearance_checks(place: str, r: LoadedBearing) -> Iterator[Check]:
    missing, scale = _inside_missing(place, r), MICRON if r.gap is None else float(r.gap.scale)
    for rule, value in (
        (CLEARANCE_LEAST, r.clearance_least),
        (CLEARANCE_START, r.clearance_start),
        (CLEARANCE_FROZEN, r.clearance_cold),
    ):
        yield on_bearing(rule, place, value, 0.0, scale=scale, missing=missing)
    if r.grip_hot is not None and r.load >= r.standing_load:
        with untraced():
            scale = max(float(r.case.mounting.grip(ROOM, "middle")), MICRON)
        rule = GRIP_HOT if r.case.row.outer_ring_held == "fit" else GRIP_HOT_HELD
        yield on_bearing(rule, place, r.grip_hot, 0.0, scale=scale)


def _slope_checks(place: str, r: LoadedBearing) -> Iterator[Check]:
    most, missing, slope = largest_slope(r.case.size.type, r.case.size.series), None, r.slope
    if slope is None:
        slope = SLOPE_TAKEN
        taken = Text("{slope}", slope=Amount(SLOPE_TAKEN * 1e3, "mrad"))
        missing = Missing((row_key(place, BearingRow.slope),), (taken,), 0.0, "none")
    yield on_bearing(SLOPE_MOST, place, slope, most, missing=missing)
    if missing is None:
        yield on_bearing(SLOPE_NEAR, place, slope, most / 2)


def _load_checks(place: str, r: LoadedBearing) -> Iterator[Check]:
    """Whether the elements roll: over the duty, and at the slowest speeds."""
    shares = [1.0] if r.rows is None else r.rows.share.tolist()
    often = [row for row, share in zip(r.carries, shares) if share > RARE]
    rare = [row for row, share in zip(r.carries, shares) if share <= RARE]
    if r.rows is None:  # nobody says how often it turns slowly
        n, case = slowest_speed(r.case.inputs, r.task), r.case
        with untraced():
            turning = load_at_speed(F=r.load, n=n, n_0=r.task.speed)
            load, least = least_loads(case, turning, r.stands.weight, n, case.inputs.supply_temperature)
        rare = [(float(load), float(least))]
    for rule, rows in ((MINIMUM_LOAD, often), (MINIMUM_LOAD_RARE, rare)):
        if rows:
            load, needed = min(rows, key=lambda row: row[0] / row[1])
            yield on_bearing(rule, place, load, needed)
    F_a = r.axial
    if r.case.size.flanged and F_a > 0:
        yield on_bearing(THRUST, place, F_a / r.equivalent_load if r.equivalent_load > 0 else None, 0.5)


def _raceway_checks(place: str, r: LoadedBearing) -> Iterator[Check]:
    """What the shaft, and of a cage the housing, have to be as raceways."""
    row, inside = r.case.row, r.case.inside
    yield on_bearing(RACEWAY_HARDNESS, place, row.raceway_hardness, HARDNESS)
    if inside is not None:
        with untraced():
            needed = case_depth_needed(D_w=inside.diameter)
        missing = None
        if row.case_depth is None:
            missing = Missing((row_key(place, BearingRow.case_depth),), (), "none", "none")
        yield on_bearing(RACEWAY_CASE, place, row.case_depth, needed, missing=missing)
    yield on_bearing(RACEWAY_ROUGHNESS, place, row.raceway_roughness, ROUGHNESS)
    if r.case.size.type == "cage":
        hard = r.case.solids.housing.kind == "steel" or row.outer_ring_held == "insert"
        yield on_bearing(RACEWAY_SEAT, place, float(hard), 1.0)
