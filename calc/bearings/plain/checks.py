# SPDX-License-Identifier: Apache-2.0
"""What a bearing is judged by."""

import math
from collections.abc import Callable, Iterator
from typing import Any

from ...countershaft.inputs import ShaftInputs
from ...countershaft.rows import ROW, SHAFT, BearingRow, called, row_key
from ...library import journal_rules as rules
from ...library.catalogue import Material, Oil, proof_of
from ...library.journal_rules import named_at
from ...library.oils import BEYOND_ROWS, LAW_RANGE, MORE_ROWS, OTHER_OIL, VISCOSITIES
from ...library.tolerances import Assumed, clearance_limits, parse
from ...sheet.check import Check, CheckRule, Missing
from ...sheet.quantity import dotted
from ...sheet.remedy import Remedy, by_key, down, up
from ...sheet.text import EMPTY, SEMICOLON, Amount, Name, Text
from ...sheet.units import Metre
from ...sheet.value import about
from ..inputs import BearingsInputs
from . import formulas as f
from .corners import Corners
from .film.table import RAIMONDI_BOYD
from .inputs import SLOPE_TAKEN
from .materials import running_surface
from .result import PlainResult, RouteResult
from .routes import supply
from .routes.routes import ROUTES
from .routes.side_by_side import SPREAD
from .row import RELIEF, RELIEF_LENGTH
from .seats.checks import seat_checks, unknown_check
from .seats.result import SplitResult
from .suitability import DIAMETER, LENGTH, MATERIAL_TEMPERATURE, OIL, SUPPLY_TEMPERATURE

# Least film by journal diameter and surface speed, in the manner of ISO 7902-3 (from memory), in m.
SPEEDS = (1.0, 3.0, 10.0, 30.0)
LEAST_FILM = ((0.063, (3e-6, 4e-6, 5e-6, 7e-6, 10e-6)), (0.160, (4e-6, 5e-6, 7e-6, 9e-6, 12e-6)))

SHEAR_THINNING = 1e5  # 1/s
OUTSIDE = 1.3  # how well films and rises are known outside the range of their formulas; rule of this program


def least_film(d: float, u: float) -> float | None:
    """h_lim of a journal from 24 to 160 mm; None outside."""
    column = sum(u > limit for limit in SPEEDS)
    return next((row[column] for up_to, row in LEAST_FILM if d <= up_to), None) if d >= 0.024 else None


# --- what is judged

GAP = dotted(ROW, BearingRow.clearance)
CLEARANCE = (GAP, dotted(ROW, BearingRow.clearance_factor))
ROUGHNESSES = (
    dotted(ROW, BearingRow.journal_roughness),
    dotted(ROW, BearingRow.housing_roughness),
)
FITS = (dotted("bearings", BearingsInputs.journal_fit), dotted("bearings", BearingsInputs.seat_fit))
SLOPE = dotted(ROW, BearingRow.slope)
CORE = dotted(SHAFT, ShaftInputs.core_radius)
SUPPLY_PRESSURE = dotted("bearings", BearingsInputs.supply_pressure)
HOLE = dotted("bearings", BearingsInputs.hole_diameter)
ASKED = dotted("bearings", "B", PlainResult.kreisle_film)
KREISLE = Text("Kreisle, after Finotti 2013, 5.5.3: Rt of both surfaces, Rt = k·Ra; what runs in: rule of this program")

FILM_EDGE = CheckRule(
    "bearings.B.film_edge",
    "limit",
    "The journal touches its seat at the edge and wears.",
    Text("Film at the edge"),
    unit="µm",
    source=KREISLE,
    advice=Text(
        "Lengthen the bearing, lower the clearance or the roughness, stiffen the shaft (slope), or take a thicker oil."
    ),
    role="physics",
    value_id=dotted("bearings", "B", PlainResult.film_edge),
    limit_id=ASKED,
    moved_by=(LENGTH, *ROUGHNESSES, *CLEARANCE, CORE, OIL),
    short=Text("film"),
    decides=True,
)
FILM_EDGE_RANGE = CheckRule(
    "bearings.B.film_edge_range",
    "limit",
    "The journal touches its seat at a speed that the engine runs at.",
    unit="µm",
    source=KREISLE,
    advice=Text("As for the film at the edge; or keep away from this speed."),
    role="physics",
    cause=FILM_EDGE.id,
    limit_id=ASKED,
    moved_by=(LENGTH, *ROUGHNESSES, dotted("bearings", BearingsInputs.speed_range)),
    short=Text("film"),
    decides=True,
)
FILM_EDGE_SPEEDS = CheckRule(
    "bearings.B.film_edge_speeds",
    "caution",
    "The rated speed holds, another one of a range that is only assumed does not.",
    unit="µm",
    source=KREISLE,
    advice=Text("As for the film at the edge; or keep away from this speed."),
    cause=FILM_EDGE.id,
    limit_id=ASKED,
    moved_by=(LENGTH, *ROUGHNESSES, dotted("bearings", BearingsInputs.speed_range)),
)
FILM_EDGE_STANDING = CheckRule(
    "bearings.B.film_edge_standing",
    "caution",
    "The turning load holds; weight and gear force are added by a first-order estimate.",
    Text("Film at the edge over a turn, with the standing load"),
    unit="µm",
    source=Text("Kreisle, after Finotti 2013, 5.5.3, on the turning and the standing load together"),
    advice=Text("As for the film at the edge; the standing part is weight and gear force."),
    cause=FILM_EDGE.id,
    limit_id=ASKED,
    moved_by=(LENGTH, *ROUGHNESSES),
)
FILM_EDGE_SHEARED = CheckRule(
    "bearings.B.film_edge_sheared",
    "caution",
    "The same film with the oil as thin as high shear makes it, which is known less well.",
    Text("Film at the edge, oil thinned by shear"),
    unit="µm",
    source=KREISLE + Text("; viscosity at high shear: SAE J300, least of the grade, from memory"),
    advice=Text("As for the film at the edge; or give the viscosity of the oil at high shear (HTHS)."),
    cause=FILM_EDGE.id,
    value_id=dotted("bearings", "B", PlainResult.film_sheared),
    limit_id=ASKED,
    moved_by=(LENGTH, *ROUGHNESSES, *CLEARANCE, OIL),
)
FILM_EDGE_SPLIT = CheckRule(
    "bearings.B.film_edge_split",
    "caution",
    "Where shells stand back at their split the film is thinner each time the turning load passes.",
    Text("Film at the edge as the split passes under the load"),
    unit="µm",
    source=KREISLE + Text("; the split: march over a turn by Reynolds' equation, rigid shells, constant viscosity"),
    advice=Text("A bush, which has no split, or a shorter and shallower relief; else as for the film at the edge."),
    cause=FILM_EDGE.id,
    value_id=dotted("bearings", "B", "split", SplitResult.film),
    limit_id=ASKED,
    moved_by=(dotted(ROW, BearingRow.relief), dotted(ROW, BearingRow.relief_length), LENGTH, *ROUGHNESSES),
)
FILM_OVERSPEED = CheckRule(
    "bearings.B.film_overspeed",
    "caution",
    "The reserve of a load that grows with the speed: the journal touches its seat when the engine runs away.",
    unit="µm",
    source=KREISLE,
    advice=Text("As for the film at the edge."),
    cause=FILM_EDGE.id,
    value_id=dotted("bearings", "B", PlainResult.film_overspeed),
    limit_id=ASKED,
    moved_by=(LENGTH, *ROUGHNESSES, *CLEARANCE, dotted("bearings", BearingsInputs.overspeed)),
)
FILM_EDGE_CORNER = CheckRule(
    "bearings.B.film_edge_corner",
    "caution",
    "The worst of the tolerances touches, the bearing of the drawing does not.",
    Text("Film at the edge at the worst corner"),
    unit="µm",
    source=Text("Kreisle, after Finotti 2013, 5.5.3"),
    advice=Text("A longer bearing, closer fits or a smoother surface."),
    cause=FILM_EDGE.id,
    value_id=dotted("bearings", "B", "corners", Corners.film_edge),
    limit_id=ASKED,
    moved_by=(LENGTH, *ROUGHNESSES, *FITS),
)
FILM_EDGE_USUAL = CheckRule(
    "bearings.B.film_edge_usual",
    "advice",
    "A general figure by diameter and speed; the roughness of these surfaces decides.",
    Text("Film at the edge against h_lim"),
    unit="µm",
    source=Text("ISO 7902-3, in its manner"),
    advice=Text("Lengthen the bearing or lower the clearance."),
    cause=FILM_EDGE.id,
    value_id=dotted("bearings", "B", PlainResult.film_edge),
    moved_by=(LENGTH, *CLEARANCE),
)
FILM_DOUBLE_LOAD = CheckRule(
    "bearings.B.film_double_load",
    "advice",
    "A load that turns doubles only at 1.41 times the speed, where the film gains too: overspeed judges that.",
    Text("Film at twice the load"),
    unit="µm",
    source=rules.DESIGN_FACTOR,
    advice=Text("Lengthen the bearing (a few millimetres are enough), or lower the clearance."),
    value_id=dotted("bearings", "B", PlainResult.film_double_load),
    limit_id=dotted("bearings", "B", PlainResult.trumpler_film),
    moved_by=(LENGTH, *CLEARANCE, OIL),
    short=Text("film, 2 F"),
)
FILM_TRUMPLER = CheckRule(
    "bearings.B.film_trumpler",
    "advice",
    "A line fitted to large machines, which knows no roughness.",
    Text("Film by Trumpler"),
    unit="µm",
    source=rules.TRUMPLER,
    advice=Text("Lengthen the bearing, lower the clearance, or take a thicker oil."),
    cause=FILM_DOUBLE_LOAD.id,
    value_id=dotted("bearings", "B", PlainResult.film),
    limit_id=dotted("bearings", "B", PlainResult.trumpler_film),
    moved_by=(LENGTH, *CLEARANCE, OIL),
)
FILM_PRESSURE = CheckRule(
    "bearings.B.film_pressure",
    "limit",
    "The surface of the seat yields under the film.",
    Text("Largest film pressure"),
    sense="<=",
    unit="MPa",
    advice=Text("Lengthen the bearing, take a larger journal or a stronger seat."),
    role="physics",
    value_id=dotted("bearings", "B", PlainResult.film_pressure_max),
    moved_by=(LENGTH, DIAMETER, dotted("bearings", BearingsInputs.housing_material)),
    short=Text("pressure"),
)
FILM_BAND = CheckRule(
    "bearings.B.film_band",
    "advice",
    "A band that the source recommends; the film itself has its own limits.",
    Text("Place of the film in its band"),
    "in",
    "%",
    RAIMONDI_BOYD,
    Text("Below 0 less clearance carries more and rubs less at the same film; above 100 % more clearance does."),
    value_id=dotted("bearings", "B", PlainResult.film_band),
    moved_by=(*CLEARANCE, OIL),
)
TEMPERATURE = CheckRule(
    "bearings.B.temperature",
    "limit",
    "The oil fails beyond it: limit of the engine's maker.",
    Text("Outlet temperature"),
    "<=",
    "°C",
    Text("given in the design: its limit (the engine maker's manual, Finotti 2013, 5.5.1)"),
    Text("More oil (larger hole, more pressure, more clearance) or cooler oil."),
    role="physics",
    value_id=dotted("bearings", "B", PlainResult.outlet_temperature),
    moved_by=(SUPPLY_TEMPERATURE, HOLE, SUPPLY_PRESSURE, *CLEARANCE),
    short=Text("oil"),
)
TEMPERATURE_CORNER = CheckRule(
    "bearings.B.temperature_corner",
    "caution",
    "The worst of the tolerances runs too hot, the bearing of the drawing does not.",
    Text("Outlet temperature at the worst corner"),
    "<=",
    "°C",
    Text("given in the design: its limit"),
    Text("More clearance at the tight end, or more oil."),
    cause=TEMPERATURE.id,
    value_id=dotted("bearings", "B", "corners", Corners.outlet_temperature),
    moved_by=(GAP, SUPPLY_TEMPERATURE, *FITS),
)
TEMPERATURE_TRUMPLER = CheckRule(
    "bearings.B.temperature_trumpler",
    "advice",
    "A general figure; the engine maker's own limit decides.",
    Text("Outlet temperature by Trumpler"),
    "<=",
    "°C",
    rules.TRUMPLER + Text(", who rounds his 250 °F (121 °C)"),
    Text("Acceptance rests on the engine maker's own limit; cooler supply oil would keep Trumpler's 120 °C."),
    cause="bearings.temperature_trumpler",
    value_id=dotted("bearings", "B", PlainResult.outlet_temperature),
    moved_by=(SUPPLY_TEMPERATURE, HOLE, SUPPLY_PRESSURE),
)
TEMPERATURE_RISE_USUAL = CheckRule(
    "bearings.B.temperature_rise_usual",
    "advice",
    "A rule for conditions that stay; the heat balance closes at any rise, and the outlet temperature has its limit.",
    Text("Temperature rise, usual"),
    "<=",
    "K",
    Text("Finotti 2013, 5.5.2: 15 to 20 °C for conditions that stay"),
    Text("More oil, or a thinner one."),
    cause=TEMPERATURE.id,
    value_id=dotted("bearings", "B", PlainResult.temperature_rise),
    moved_by=(HOLE, SUPPLY_PRESSURE, GAP, OIL),
    short=Text("oil rise"),
)
SPECIFIC_LOAD = CheckRule(
    "bearings.B.specific_load",
    "caution",
    "One maker accepted no more for steel in bare aluminium; a lined seat is judged by its material.",
    Text("Specific load"),
    "<=",
    "MPa",
    rules.FINOTTI,
    Text("A larger journal helps as well."),
    demand=True,
    value_id=dotted("bearings", "B", PlainResult.specific_load),
    moved_by=(LENGTH, DIAMETER),
    short=Text("load"),
)
SPECIFIC_LOAD_USUAL = CheckRule(
    "bearings.B.specific_load_usual",
    "advice",
    "The usual range.",
    Text("Specific load, usual"),
    "<=",
    "MPa",
    rules.FINOTTI,
    Text("A larger journal helps as well."),
    demand=True,
    cause=SPECIFIC_LOAD.id,
    value_id=dotted("bearings", "B", PlainResult.specific_load),
    moved_by=(LENGTH, DIAMETER),
)
HEAT_INDEX = CheckRule(
    "bearings.B.heat_index",
    "advice",
    "An old table of cooling; the heat balance is solved, and the outlet temperature has its limit.",
    Text("Heat index"),
    "<=",
    "N·rpm/mm",
    advice=Text("A longer bearing carries off more heat."),
    demand=True,
    value_id=dotted("bearings", "B", PlainResult.heat_index),
    moved_by=(LENGTH,),
    short=Text("heat"),
)
CLEARANCE_COLD = CheckRule(
    "bearings.B.clearance_cold",
    "limit",
    "The journal seizes in the cold.",
    sense=">",
    unit="µm",
    source=Text("physics: seizure of a journal that shrinks less than its seat"),
    advice=Text("The journal seizes when cold: more clearance, or a housing that expands like the journal."),
    role="physics",
    zero="the clearance at its reference temperature",
    value_id=dotted("bearings", "B", PlainResult.clearance_cold),
    moved_by=(*CLEARANCE, dotted("bearings", BearingsInputs.housing_material)),
    short=Text("cold gap"),
)
CLEARANCE_COLD_CORNER = CheckRule(
    "bearings.B.clearance_cold_corner",
    "limit",
    "A part within its drawing seizes in the cold.",
    sense=">",
    unit="µm",
    source=Text("physics: seizure when cold"),
    advice=Text("More clearance, or closer fits."),
    role="physics",
    zero="the clearance at its reference temperature",
    cause=CLEARANCE_COLD.id,
    value_id=dotted("bearings", "B", "corners", Corners.clearance_cold),
    moved_by=(GAP, *FITS),
    short=Text("cold gap"),
)
LENGTH_RATIO = CheckRule(
    "bearings.B.length_ratio",
    "advice",
    "The source accepts no bearing beyond it; the film is solved from 0.1 to 2.",
    Text("Length ratio l/d"),
    "in",
    source=rules.FINOTTI,
    advice=Text("Change length or diameter."),
    value_id=dotted("bearings", "B", PlainResult.length_ratio),
    moved_by=(LENGTH, DIAMETER),
    short=Text("length ratio"),
)
LENGTH_RATIO_USUAL = CheckRule(
    "bearings.B.length_ratio_usual",
    "advice",
    "The usual range.",
    Text("Length ratio l/d, usual"),
    "in",
    source=Text("Finotti 2013, 5.5.2"),
    advice=Text("Change length or diameter."),
    value_id=dotted("bearings", "B", PlainResult.length_ratio),
    moved_by=(LENGTH, DIAMETER),
)
TRANSITION = CheckRule(
    "bearings.B.transition",
    "advice",
    "An empirical rule, held at 10 m/s beyond its range; the film over the speeds is the same question solved.",
    Text("Speed above mixed friction"),
    unit="rpm",
    source=Text(f.least_speed.source),
    advice=Text("A thicker or cooler oil, or a lower specific load."),
    limit_id=dotted("bearings", "B", PlainResult.least_speed),
    moved_by=(OIL, SUPPLY_TEMPERATURE, LENGTH),
    short=Text("speed"),
)
MCKEE = CheckRule(
    "bearings.B.mckee",
    "advice",
    "A rule of thumb with five times the number of the transition, which is judged by itself.",
    Text("McKee number, cP·rpm/psi"),
    source=Text("McKee & McKee 1932, after Finotti 2013, 5.4.1; 30 is the transition"),
    advice=Text("A thicker or cooler oil, or a lower specific load, for a stable film."),
    value_id=dotted("bearings", "B", PlainResult.mckee_number),
    moved_by=(OIL, SUPPLY_TEMPERATURE, LENGTH),
)
MISALIGNMENT = CheckRule(
    "bearings.B.misalignment",
    "advice",
    "A rule of this program on the slope; the film at the edge judges it.",
    Text("Slope over the length"),
    "<=",
    "µm",
    Text("rule of this program: 0.3·h₀"),
    Text("Stiffen the shaft between its bearings."),
    cause=FILM_EDGE.id,
    moved_by=(CORE, LENGTH, SLOPE),
)
FIT = CheckRule(
    "bearings.B.fit",
    "caution",
    "The fits make another clearance than the one that is judged.",
    Text("Clearance made by the fits"),
    "in",
    "µm",
    Text("ISO 286"),
    value_id=dotted("bearings", "B", PlainResult.clearance),
    moved_by=(*FITS, GAP),
)
ROUTES_SPREAD = CheckRule(
    "bearings.B.routes_spread",
    "method",
    "How far other methods are off says nothing of the part.",
    Text("Spread of the routes"),
    "<=",
    "%",
    Text(
        "rule of this program: {most} % on the clearance as given and with the oil of the own solution",
        most=Amount(SPREAD * 100),
    ),
    cause="bearings.routes_spread",
    value_id=dotted("bearings", "B", PlainResult.routes_spread),
)
SHEAR_RATE = CheckRule(
    "bearings.B.shear_rate",
    "method",
    "Beyond it a multigrade oil is thinner than its law: the film is solved once more with that.",
    Text("Shear rate in the narrowest gap"),
    "<=",
    "1/s",
    Text("rule of this program: onset of the thinning of polymer-thickened oils, from memory"),
    Text("The film is solved once more with the viscosity at high shear (HTHS)."),
    cause="bearings.shear_rate",
    value_id=dotted("bearings", "B", PlainResult.shear_rate),
    moved_by=(OIL, dotted("bearings", BearingsInputs.viscosity_tolerance)),
)
FRICTION_REGIME = CheckRule(
    "bearings.B.friction_regime",
    "method",
    "Outside it the full film, on which the solution stands, is doubtful.",
    Text("Coefficient of friction"),
    "in",
    source=Text("Finotti 2013, 5.4.1: full film"),
    advice=Text("Outside the usual range of a full film: look at film and clearance."),
    value_id=dotted("bearings", "B", RouteResult.friction_coefficient),
    moved_by=(GAP, OIL),
)
FILMS = (
    FILM_EDGE,
    FILM_EDGE_RANGE,
    FILM_EDGE_SPEEDS,
    FILM_EDGE_STANDING,
    FILM_EDGE_SHEARED,
    FILM_EDGE_SPLIT,
    FILM_OVERSPEED,
    FILM_EDGE_CORNER,
    FILM_EDGE_USUAL,
    FILM_DOUBLE_LOAD,
    FILM_TRUMPLER,
)
HEAT = (TEMPERATURE, TEMPERATURE_CORNER, TEMPERATURE_TRUMPLER, TEMPERATURE_RISE_USUAL, MATERIAL_TEMPERATURE)
SUPPLY_RANGE = CheckRule(
    "bearings.B.supply_range",
    "method",
    "Outside it the formula of the flow is an extrapolation.",
    Text("Width of the oil supply over the length"),
    "in",
    source=Text("Finotti 2013, Table 5.1 (DIN 31652-2): range of the supply factors"),
    advice=Text("Outside, the flow through the hole or pocket is not to be trusted: the rise is taken 1.3 times."),
    moved_by=(HOLE, dotted("bearings", BearingsInputs.pocket_width), LENGTH),
    weakens=tuple([(rule, OUTSIDE) for rule in HEAT]),
)
OIL_ROWS = CheckRule(
    "bearings.B.oil_rows",
    "method",
    "Beyond the rows of the oil its viscosity is an extrapolation.",
    Text("Film temperature within the rows of the oil"),
    "in",
    "°C",
    BEYOND_ROWS,
    MORE_ROWS,
    moved_by=(SUPPLY_TEMPERATURE, OIL),
    weakens=tuple([(rule, OUTSIDE) for rule in FILMS]),
)
VISCOSITY_RANGE = CheckRule(
    "bearings.B.viscosity_range",
    "method",
    "Outside it the viscosity is an extrapolation.",
    Text("Oil viscosity"),
    "in",
    "mm²/s",
    LAW_RANGE,
    OTHER_OIL,
    moved_by=(OIL, SUPPLY_TEMPERATURE),
    weakens=tuple([(rule, OUTSIDE) for rule in FILMS]),
)
OIL_PUMPING = CheckRule(
    "bearings.oil_pumping",
    "caution",
    "Below it the bearings run dry after a cold start until the oil is warm.",
    Text("Lowest temperature, oil still pumped"),
    unit="°C",
    advice=Text("An oil of a lower winter grade, or no start so cold."),
    moved_by=(dotted("bearings", BearingsInputs.lowest_temperature), OIL),
)


# --- the checks


def oil_check(inputs: BearingsInputs, oil: Oil) -> Check | None:
    """What the oil itself bears: it has to flow at a cold start."""
    limits = [T for T in (oil.pumping_limit, oil.pour_point) if T is not None]
    if not limits:
        return None
    source = Text("given in the design") if oil.source == "the user" else Name(oil.source)
    return OIL_PUMPING(inputs.lowest_temperature, max(limits), source=source)


def on_bearing(
    rule: CheckRule, place: str, value: float | None, limit: float | tuple[float, float], **more: Any
) -> Check:
    """A check on one bearing, under the name of its rule."""
    return rule(value, limit, at=place, name=named_at(rule.name, place), **more)


def checks(place: str, r: PlainResult, housing: Material) -> Iterator[Check]:
    """Of one bearing; `housing`: what a bare seat is of.  The film of a journal that runs centred is not judged."""
    bearing, inputs, lubricant = r.seat.bearing, r.seat.inputs, r.seat.lubricant
    if not r.seat.centred:
        yield from _film_checks(place, r)
    yield from _seat_checks(place, r, housing)

    T_in = inputs.supply_temperature
    for rule, limit in (
        (TEMPERATURE, inputs.outlet_temperature_limit),
        (TEMPERATURE_TRUMPLER, rules.TRUMPLER_TEMPERATURE),
    ):
        yield on_bearing(rule, place, r.outlet_temperature, limit, base=T_in)
    yield on_bearing(TEMPERATURE_RISE_USUAL, place, r.temperature_rise, rules.RISE[1])

    oiled = rules.LUBRICATIONS[inputs.lubrication]
    low, high = Amount(oiled.usual[0]), Amount(oiled.usual[1], "N·rpm/mm")
    source = Text("Finotti 2013, Table 3.1: {kind}, {low} to {high}", kind=oiled.title, low=low, high=high)
    if oiled.most is not None:
        source += Text(", beyond it by how much is cooled, up to {most}", most=Amount(oiled.most, "N·rpm/mm"))
    longer = _lengthened(place, bearing, bearing.length * (r.heat_index / oiled.limit))
    yield on_bearing(HEAT_INDEX, place, r.heat_index, oiled.limit, source=source, remedies=longer)
    if not r.seat.centred:
        yield on_bearing(FILM_BAND, place, r.film_band, (0.0, 1.0))
        yield on_bearing(TRANSITION, place, r.duty.effective_speed, r.least_speed)
        yield on_bearing(MCKEE, place, r.mckee_number, rules.STABLE_FILM)
        yield on_bearing(FRICTION_REGIME, place, r.friction_coefficient, rules.FULL_FILM_FRICTION)
    if r.routes_spread is not None:
        yield on_bearing(ROUTES_SPREAD, place, r.routes_spread, SPREAD, advice=_outside(r))
    tilt = (SLOPE_TAKEN if r.slope is None else r.slope) * bearing.length
    yield on_bearing(MISALIGNMENT, place, tilt, 0.3 * r.film)

    if not lubricant.constant:
        yield on_bearing(VISCOSITY_RANGE, place, r.hot.oil.nu, VISCOSITIES)
    if (reach := lubricant.reach) is not None:
        yield on_bearing(OIL_ROWS, place, r.hot.mean_temperature, reach)
    if lubricant.polymer_thickened:
        yield on_bearing(SHEAR_RATE, place, r.shear_rate, SHEAR_THINNING)
    yield from _corner_checks(place, r)
    band = None if inputs.select is None else inputs.select.clearance_band
    yield from seat_checks(place, bearing, r.seat_, r.select, band)
    if (unknown := unknown_check(place, bearing, housing, inputs, r.clearance, r.hot.mean_temperature)) is not None:
        yield unknown
    journal, seat = parse(inputs.journal_fit), parse(inputs.seat_fit)
    if journal.letter is not None and seat.letter is not None and r.seat.stack is None:
        clearances = clearance_limits(journal, seat, bearing.diameter)
        advice = Text(
            "{journal_fit} in {seat_fit} makes other clearances: choose other fits, or leave the clearance out.",
            journal_fit=inputs.journal_fit,
            seat_fit=inputs.seat_fit,
        )
        yield on_bearing(FIT, place, r.clearance, clearances, advice=advice)
    if inputs.supply != "groove":
        widths = {"pocket": inputs.pocket_width, "axial_groove": inputs.axial_groove_length}
        width = (widths.get(inputs.supply, inputs.hole_diameter) or 0.0) / bearing.length
        yield on_bearing(SUPPLY_RANGE, place, width, rules.SUPPLY_WIDTH)


def _film_checks(place: str, r: PlainResult) -> Iterator[Check]:
    lost = lost_at_edge(r)
    yield on_bearing(FILM_EDGE, place, r.film_edge, r.kreisle_film, missing=edge_missing(r, r.film_edge), base=lost)
    yield on_bearing(FILM_DOUBLE_LOAD, place, r.film_double_load, r.trumpler_film)
    yield on_bearing(FILM_TRUMPLER, place, r.film, r.trumpler_film)
    rule = FILM_EDGE_RANGE if r.sweep.given else FILM_EDGE_SPEEDS
    if r.sweep.lost is not None:
        label = Text("Film at the edge over the speeds, none at {speed} rpm", speed=Amount(r.sweep.lost * 60))
        yield rule(None, r.kreisle_film, at=place, name=named_at(label, place))
    elif r.thinnest_film is not None:
        label = Text(
            "Film at the edge over the speeds, thinnest at {speed_of_thinnest_film} rpm",
            speed_of_thinnest_film=Amount((r.speed_of_thinnest_film or 0.0) * 60),
        )
        with about(Text("{place} bearing, at the edge over the speeds", place=called(place))):
            edge = f.film_at_edge_of_another(h_x=r.thinnest_film, h_0=r.film, h_edge=r.film_edge)
        missing = edge_missing(r, edge)
        yield rule(edge, r.kreisle_film, at=place, name=named_at(label, place), missing=missing, base=lost)
    if r.shear_factor is not None:
        yield on_bearing(
            FILM_EDGE_SHEARED,
            place,
            r.film_sheared,
            r.kreisle_film,
            missing=edge_missing(r, r.film_sheared, unsheared=r.film_edge),
            base=lost,
        )
    if r.split is not None:
        missing = _split_missing(r, r.split.film)
        yield on_bearing(FILM_EDGE_SPLIT, place, r.split.film, r.kreisle_film, missing=missing, base=lost)
    label = Text(
        "Film at the edge at {overspeed} % overspeed", overspeed=Amount(r.seat.inputs.overspeed * 100, form="g")
    )
    yield FILM_OVERSPEED(
        r.film_overspeed,
        r.kreisle_film,
        at=place,
        name=named_at(label, place),
        missing=edge_missing(r, r.film_overspeed),
        base=lost,
    )
    if (h_lim := least_film(r.seat.bearing.diameter, r.surface_speed)) is not None:
        yield on_bearing(FILM_EDGE_USUAL, place, r.film_edge, h_lim, base=lost)


def _seat_checks(place: str, r: PlainResult, housing: Material) -> Iterator[Check]:
    """What the seat carries, the length of the bearing, and the clearance that the cold leaves."""
    bearing, inputs = r.seat.bearing, r.seat.inputs
    lands = supply.lands(inputs)
    groove = bearing.length - supply.bare_length(inputs, bearing.length)
    yield from _pressure_checks(place, r, housing)
    bare = inputs.bush_material is None and not bearing.ringed
    rule, limit = (SPECIFIC_LOAD, rules.SPECIFIC_LOAD) if bare else (SPECIFIC_LOAD_USUAL, rules.USUAL_SPECIFIC_LOAD)
    longer = _lengthened(place, bearing, groove + (bearing.length - groove) * (r.specific_load / limit))
    yield on_bearing(rule, place, r.specific_load, limit, remedies=longer)
    # what the source accepts, and within that what it calls usual: of one source one verdict
    low, high = rules.LENGTH_RATIO
    accepted, usual = low <= r.length_ratio <= high, rules.USUAL_LENGTH_RATIO
    rule, ratios = (LENGTH_RATIO_USUAL, rules.USUAL_LENGTH_RATIO) if accepted else (LENGTH_RATIO, rules.LENGTH_RATIO)
    # of each land, where a groove parts the bearing
    within = _lengthened(place, bearing, *(lands * ratio * bearing.diameter + groove for ratio in usual))
    yield on_bearing(rule, place, r.length_ratio, ratios, remedies=within)
    name = named_at(_when_cold(inputs), place)
    yield CLEARANCE_COLD(r.clearance_cold, 0.0, at=place, name=name, scale=r.clearance)


def _pressure_checks(place: str, r: PlainResult, housing: Material) -> Iterator[Check]:
    """The film's pressure on bare metal, and on a lining whose yield stress is known."""
    p, bush = r.film_pressure_max, r.seat.inputs.bush_material
    strength, missing = Text("elasticity, proof stress of {name}", name=housing.name), None
    if bush is not None:
        lining = running_surface(bush, housing.name)
        if lining is None or lining.yield_ is None:
            return
        limit, strength = lining.yield_, Text("yield stress of {name}: {source}", name=bush, source=Text(lining.source))
    elif r.seat.rings is not None:  # of which the lining is not known
        return
    elif housing.proof_stress is None and housing.tensile_strength is not None:
        limit = housing.tensile_strength
        strength = Text("elasticity, tensile strength of {name}, which has no proof stress", name=housing.name)
    else:
        limit, missing = proof_of(housing.proof_stress, p)
    yield on_bearing(FILM_PRESSURE, place, p, limit, source=strength, missing=missing)


def lost_at_edge(r: PlainResult) -> Metre:
    """What the slope leaves at the edge where there is no film between: known, however well the film is."""
    return r.film_edge - r.film


# --- what is not given


def edge_missing(
    r: PlainResult,
    edge: Metre | None,
    *,
    unsheared: Metre | None = None,
    exact: Metre | None = None,
) -> Missing | None:
    """What a film at the edge stands on that the design does not give; None: it gives all.

    `unsheared`: that film of an oil that loses nothing by shear, where the viscosity at high shear matters; `exact`:
    that of parts without the tolerances that are not given, None where all are."""
    keys, taken, best = [], [], math.nan if edge is None else edge
    if unsheared is not None and r.seat.lubricant.oil.hths is None:
        keys.append(dotted("oil", Oil.hths))
        hths = Amount((r.hths or math.nan) * 1e3, "mPa·s")
        taken.append(Text("viscosity at high shear {hths}, the least of the grade", hths=hths))
        best = unsheared
    if exact is not None:
        keys += fits_missing(r)
        taken.append(Text("IT7 for what has no fit"))
        best = exact
    if r.slope is None:
        keys.append(row_key(r.seat.bearing.name, BearingRow.slope))
        taken.append(Text("slope {slope}", slope=Amount(SLOPE_TAKEN * 1e3, "mrad")))
        best += r.film - r.film_edge
    return Missing(tuple(keys), tuple(taken), best, math.nan if edge is None else edge) if keys else None


def _split_missing(r: PlainResult, film: Metre) -> Missing | None:
    """The same, and the relief where it is not given: at best there is none."""
    missing, row = edge_missing(r, film), r.seat.bearing
    reliefs = ((BearingRow.relief, row.relief), (BearingRow.relief_length, row.relief_length))
    if r.split is not None and r.split.beyond:
        length = row_key(row.name, BearingRow.relief_length)
        taken = Text("a relief and a film at the end of what was marched")
        return Missing((length,), (taken,), film if missing is None else missing.best, "none")
    keys = tuple(row_key(row.name, key) for key, given in reliefs if given is None)
    if not keys or r.split is None:
        return missing
    taken = Text("relief {t} over {a}", t=Amount(RELIEF * 1e6, "µm"), a=Amount(RELIEF_LENGTH * 1e3, "mm"))
    best = film + r.film * (1 - r.split.share)
    if missing is None:
        return Missing(keys, (taken,), best, film)
    of_slope = r.film - r.film_edge if r.slope is None else 0.0
    return Missing((*missing.keys, *keys), (*missing.taken, taken), best + of_slope, film)


def fits_missing(r: PlainResult) -> list[str]:
    """The keys of the fits that are assumed."""
    inputs = r.seat.inputs
    return [key for key, fit in zip(FITS, (inputs.journal_fit, inputs.seat_fit)) if isinstance(fit, Assumed)]


def _corner_checks(place: str, r: PlainResult) -> Iterator[Check]:
    """The limits once more at the worst corner of the tolerances, given or assumed."""
    c, inputs, exact = r.corners, r.seat.inputs, r.corners.exact
    taken = (Text("IT7 for what has no fit"),)
    keys = tuple(fits_missing(r))

    def corner_check(rule: CheckRule, what: Text, column: str, *judged: Any, **more: Any) -> Check:
        corner = c.worst(column)
        return rule(
            *judged,
            at=place,
            name=named_at(what, place),
            source=Text("{source}; corner: {corner}", source=rule.source, corner=corner),
            advice=Text("Worst corner: {corner}. {advice}", corner=corner, advice=rule.advice),
            **more,
        )

    if not r.seat.centred:
        film = edge_missing(r, c.film_edge, exact=None if exact is None else exact.film_edge)
        yield corner_check(
            FILM_EDGE_CORNER,
            FILM_EDGE_CORNER.name,
            "film_edge",
            c.film_edge,
            r.kreisle_film,
            missing=film,
            base=lost_at_edge(r),
        )
    heat = cold = None
    if exact is not None:
        hot = math.nan if c.outlet_temperature is None else c.outlet_temperature
        heat = Missing(keys, taken, exact.outlet_temperature, hot)
        cold = Missing(keys, taken, exact.clearance_cold, c.clearance_cold)
    yield corner_check(
        TEMPERATURE_CORNER,
        TEMPERATURE_CORNER.name,
        "outlet_temperature",
        c.outlet_temperature,
        inputs.outlet_temperature_limit,
        missing=heat,
        base=inputs.supply_temperature,
    )
    label = Text("{title} at the worst corner", title=_when_cold(inputs))
    yield corner_check(
        CLEARANCE_COLD_CORNER, label, "clearance_cold", c.clearance_cold, 0.0, missing=cold, scale=r.clearance
    )


def _outside(r: PlainResult) -> Text:
    """Which routes are further off than the spread allows, by how much and why."""
    far_off = [
        Text(
            "{routes} is {film} % off: {reason}",
            routes=ROUTES[name].title,
            film=Amount(far * 100, form="+.0f"),
            reason=ROUTES[name].why_off(r.side.films[name], r.side.ratio),
        )
        for name, far in r.side.compared.items()
        if abs(far) > SPREAD
    ]
    return SEMICOLON.join([*far_off, Text("the own solution of Reynolds' equation judges.")]) if far_off else EMPTY


def _lengthened(
    place: str, bearing: BearingRow, low: Metre, high: Metre = math.inf
) -> Callable[[], tuple[Remedy, ...]]:
    """The nearest length between the two; none where the least is not finite."""

    def ways() -> tuple[Remedy, ...]:
        if not math.isfinite(low):
            return ()
        key, shorter = row_key(place, BearingRow.length), bearing.length <= low
        length = up(low) if shorter else down(high)
        return by_key(BearingRow, key, length, place=called(place), bound=">=" if shorter else "<=")()

    return ways


def _when_cold(inputs: BearingsInputs) -> Text:
    return Text("Clearance at {lowest_temperature} °C", lowest_temperature=Amount(inputs.lowest_temperature))
