# SPDX-License-Identifier: Apache-2.0
"""What a bearing is judged by."""

import math
from collections.abc import Callable, Iterator
from functools import partial

from ..library import journal_rules as rules
from ..library.catalogue import Oil
from ..library.oils import BEYOND_ROWS, LAW_RANGE, MORE_ROWS, OTHER_OIL, VISCOSITIES
from ..library.tolerances import clearance_limits, parse
from ..sheet.check import Check
from ..sheet.quantity import dotted
from ..sheet.remedy import Remedy, by_key, down, up
from ..sheet.shim_check import check
from ..sheet.text import EMPTY, SEMICOLON, Amount, Name, Text
from ..sheet.units import Metre
from . import formulas as f
from .film.table import RAIMONDI_BOYD
from .inputs import IN_WORDS, BearingInputs, BearingsInputs
from .result import BearingResult
from .routes import supply
from .routes.routes import ROUTES
from .routes.side_by_side import SPREAD

# Least film by journal diameter and surface speed, in the manner of ISO 7902-3 (from memory), in m.
SPEEDS = (1.0, 3.0, 10.0, 30.0)
LEAST_FILM = ((0.063, (3e-6, 4e-6, 5e-6, 7e-6, 10e-6)), (0.160, (4e-6, 5e-6, 7e-6, 9e-6, 12e-6)))

SHEAR_THINNING = 1e5  # 1/s
LOST_BY_SHEAR = 0.3  # of its viscosity, at the most, by a multigrade oil at 150 °C and 10⁶ 1/s; from memory


def least_film(d: float, u: float) -> float | None:
    """h_lim of a journal from 24 to 160 mm; None outside."""
    column = sum(u > limit for limit in SPEEDS)
    return next((row[column] for up_to, row in LEAST_FILM if d <= up_to), None) if d >= 0.024 else None


def oil_check(inputs: BearingsInputs, oil: Oil) -> Check | None:
    """What the oil itself bears: it has to flow at a cold start."""
    limits = [T for T in (oil.pumping_limit, oil.pour_point) if T is not None]
    if not limits:
        return None
    label = Text("Lowest temperature, oil still pumped")
    source = Text("given in the design") if oil.source == "the user" else Name(oil.source)
    advice = Text("An oil of a lower winter grade, or no start so cold.")
    return check("bearings.oil_pumping", label, inputs.lowest_temperature, ">=", max(limits), "°C", source, advice)


def checks(place: str, r: BearingResult, slope: float) -> Iterator[Check]:
    """`slope`: of the journal in its seat, rad."""
    bearing, inputs, lubricant = r.seat.bearing, r.seat.inputs, r.seat.lubricant
    bearing_check, lengthened = partial(_bearing_check, place), partial(_lengthened, place, bearing)
    lands = supply.lands(inputs)
    groove = (inputs.groove_width or 0.0) if lands > 1 else 0.0

    kreisle = Text("Kreisle, after Finotti 2013, 5.5.3: Rt of both surfaces, Rt = k·Ra")
    advice = Text(
        "Lengthen the bearing, lower the clearance or the roughness, stiffen the shaft (slope), or take a thicker oil."
    )
    yield bearing_check("film_edge", Text("Film at the edge"), r.film_edge, ">=", r.kreisle_film, "µm", kreisle, advice)
    label = Text("Film at twice the load")
    advice = Text("Lengthen the bearing (a few millimetres are enough), or lower the clearance.")
    yield bearing_check(
        "film_double_load", label, r.film_double_load, ">=", r.trumpler_film, "µm", rules.DESIGN_FACTOR, advice
    )
    advice = Text("Lengthen the bearing, lower the clearance, or take a thicker oil.")
    yield bearing_check(
        "film_trumpler", Text("Film by Trumpler"), r.film, ">=", r.trumpler_film, "µm", rules.TRUMPLER, advice
    )
    if r.thinnest_film is not None:
        label = Text(
            "Film at the edge over the speeds, thinnest at {speed_of_thinnest_film} rpm",
            speed_of_thinnest_film=Amount((r.speed_of_thinnest_film or 0.0) * 60),
        )
        edge = f.film_at_edge_of_another(h_x=r.thinnest_film, h_0=r.film, h_edge=r.film_edge)
        advice = Text("As for the film at the edge; or keep away from this speed.")
        yield bearing_check("film_edge_speeds", label, edge, ">=", r.kreisle_film, "µm", kreisle, advice)

    limit = inputs.outlet_temperature_limit
    source = Text("given in the design: its limit (the engine maker's manual, Finotti 2013, 5.5.1)")
    advice = Text("More oil (larger hole, more pressure, more clearance) or cooler oil.")
    yield bearing_check(
        "temperature", Text("Outlet temperature"), r.outlet_temperature, "<=", limit, "°C", source, advice
    )
    label, limit = Text("Outlet temperature by Trumpler"), rules.TRUMPLER_TEMPERATURE
    source = rules.TRUMPLER + Text(", who rounds his 250 °F (121 °C)")
    advice = Text("Acceptance rests on the engine maker's own limit; cooler supply oil would keep Trumpler's 120 °C.")
    yield bearing_check("temperature_trumpler", label, r.outlet_temperature, "<=", limit, "°C", source, advice)
    label, limit = Text("Temperature rise, usual"), rules.RISE[1]
    source = Text("Finotti 2013, 5.5.2: 15 to 20 °C for conditions that stay")
    advice = Text("More oil, or a thinner one.")
    yield bearing_check("temperature_rise_usual", label, r.temperature_rise, "<=", limit, "K", source, advice)

    advice = Text("A larger journal helps as well.")
    for key, label, limit in (
        ("specific_load", Text("Specific load"), rules.SPECIFIC_LOAD),
        ("specific_load_usual", Text("Specific load, usual"), rules.USUAL_SPECIFIC_LOAD),
    ):
        longer = lengthened(groove + (bearing.length - groove) * (r.specific_load / limit))
        yield bearing_check(key, label, r.specific_load, "<=", limit, "MPa", rules.FINOTTI, advice, remedies=longer)
    oiled = rules.LUBRICATIONS[inputs.lubrication]
    low, high = Amount(oiled.usual[0]), Amount(oiled.usual[1], "N·rpm/mm")
    source = Text("Finotti 2013, Table 3.1: {kind}, {low} to {high}", kind=oiled.title, low=low, high=high)
    heat = [("heat_index", Text("Heat index"), oiled.limit)]
    if oiled.most is not None:
        source += Text(", beyond it by how much is cooled, up to {most}", most=Amount(oiled.most, "N·rpm/mm"))
        heat.append(("heat_index_usual", Text("Heat index, usual"), oiled.usual[1] * rules.N_RPM_MM))
    advice = Text("A longer bearing carries off more heat.")
    for key, label, limit in heat:
        longer = lengthened(bearing.length * (r.heat_index / limit))
        yield bearing_check(key, label, r.heat_index, "<=", limit, "N·rpm/mm", source, advice, remedies=longer)

    source = Text("physics: seizure of a journal that shrinks less than its seat")
    advice = Text("The journal seizes when cold: more clearance, or a housing that expands like the journal.")
    yield bearing_check("clearance_cold", _when_cold(inputs), r.clearance_cold, ">", 0.0, "µm", source, advice)
    usual, advice = Text("Finotti 2013, 5.5.2"), Text("Change length or diameter.")
    for key, label, ratios, source in (
        ("length_ratio", Text("Length ratio l/d"), rules.LENGTH_RATIO, rules.FINOTTI),
        ("length_ratio_usual", Text("Length ratio l/d, usual"), rules.USUAL_LENGTH_RATIO, usual),
    ):
        # of each land, where a groove parts the bearing
        within = lengthened(*(lands * ratio * bearing.diameter + groove for ratio in ratios))
        yield bearing_check(key, label, r.length_ratio, "in", ratios, "", source, advice, remedies=within)
    label = Text("Place of the film in its band")
    advice = Text(
        "Below 0 less clearance carries more and rubs less at the same film; above 100 % more clearance does."
    )
    yield bearing_check("film_band", label, r.film_band, "in", (0.0, 1.0), "%", RAIMONDI_BOYD, advice)
    label, n = Text("Speed above mixed friction"), r.duty.effective_speed
    source, advice = Text(f.least_speed.source), Text("A thicker or cooler oil, or a lower specific load.")
    yield bearing_check("transition", label, n, ">=", r.least_speed, "rpm", source, advice)
    label = Text("McKee number, cP·rpm/psi")
    source = Text("McKee & McKee 1932, after Finotti 2013, 5.4.1; 30 is the transition")
    advice = Text("A thicker or cooler oil, or a lower specific load, for a stable film.")
    yield bearing_check("mckee", label, r.mckee_number, ">=", rules.STABLE_FILM, "", source, advice)
    if r.routes_spread is not None:
        label = Text("Spread of the routes")
        source = Text("rule of this program: 15 % on the clearance as given and with the oil of the own solution")
        yield bearing_check("routes_spread", label, r.routes_spread, "<=", SPREAD, "%", source, _outside(r))
    if (h_lim := least_film(bearing.diameter, r.surface_speed)) is not None:
        label, source = Text("Film at the edge against h_lim"), Text("ISO 7902-3, in its manner")
        advice = Text("Lengthen the bearing or lower the clearance.")
        yield bearing_check("film_edge_usual", label, r.film_edge, ">=", h_lim, "µm", source, advice)
    label, source = Text("Slope over the length"), Text("rule of this program: 0.3·h₀")
    advice = Text("Stiffen the shaft between its bearings.")
    yield bearing_check("misalignment", label, slope * bearing.length, "<=", 0.3 * r.film, "µm", source, advice)
    label, source = Text("Coefficient of friction"), Text("Finotti 2013, 5.4.1: full film")
    advice = Text("Outside the usual range of a full film: look at film and clearance.")
    yield bearing_check(
        "friction_regime", label, r.friction_coefficient, "in", rules.FULL_FILM_FRICTION, "", source, advice
    )

    if not lubricant.constant:
        yield bearing_check(
            "viscosity_range", Text("Oil viscosity"), r.hot.oil.nu, "in", VISCOSITIES, "mm²/s", LAW_RANGE, OTHER_OIL
        )
    if (reach := lubricant.reach) is not None:
        label, T = Text("Film temperature within the rows of the oil"), r.hot.mean_temperature
        yield bearing_check("oil_rows", label, T, "in", reach, "°C", BEYOND_ROWS, MORE_ROWS)
    if lubricant.polymer_thickened:
        label = Text("Shear rate in the narrowest gap")
        source = Text("rule of this program: onset of the thinning of polymer-thickened oils, from memory")
        advice = Text(
            "A multigrade oil loses up to {share} of its viscosity here, by which the film at the edge falls to "
            "{edge}: take the viscosity at high shear (HTHS).",
            share=Amount(100 * LOST_BY_SHEAR, "%"),
            edge=told_when_thinned(r),
        )
        yield bearing_check("shear_rate", label, r.shear_rate, "<=", SHEAR_THINNING, "1/s", source, advice)
    yield from _corner_checks(place, r)
    journal, seat = parse(inputs.journal_fit), parse(inputs.seat_fit)
    if journal.letter is not None and seat.letter is not None:
        clearances = clearance_limits(journal, seat, bearing.diameter)
        label, source = Text("Clearance made by the fits"), Text("ISO 286")
        advice = Text(
            "{journal_fit} in {seat_fit} makes other clearances: choose other fits, or leave the clearance out.",
            journal_fit=inputs.journal_fit,
            seat_fit=inputs.seat_fit,
        )
        yield bearing_check("fit", label, r.clearance, "in", clearances, "µm", source, advice)
    if inputs.supply != "groove":
        widths = {"pocket": inputs.pocket_width, "axial_groove": inputs.axial_groove_length}
        width = (widths.get(inputs.supply, inputs.hole_diameter) or 0.0) / bearing.length
        label = Text("Width of the oil supply over the length")
        source = Text("Finotti 2013, Table 5.1 (DIN 31652-2): range of the supply factors")
        advice = Text("Outside, the flow through the hole or pocket is not to be trusted.")
        yield bearing_check("supply_range", label, width, "in", rules.SUPPLY_WIDTH, "", source, advice)


def _bearing_check(
    place: str,
    key: str,
    label: Text,
    value: float | None,
    sense: str,
    limit: float | tuple[float, float],
    unit: str,
    source: Text,
    advice: Text,
    *,
    remedies: Callable[[], tuple[Remedy, ...]] | None = None,
) -> Check:
    """A check on one bearing; a value that is None, since there is no film, keeps no limit."""
    name = Text("{what}, {place}", what=label, place=IN_WORDS[place])
    number = math.nan if value is None else value
    return check(f"bearings.{place}.{key}", name, number, sense, limit, unit, source, advice, remedies=remedies)


def _lengthened(
    place: str, bearing: BearingInputs, low: Metre, high: Metre = math.inf
) -> Callable[[], tuple[Remedy, ...]]:
    """The nearest length between the two; none where the least is not finite."""

    def ways() -> tuple[Remedy, ...]:
        key, shorter = dotted("bearings", place, BearingInputs.length), bearing.length <= low
        length = None if not math.isfinite(low) else up(low) if shorter else down(high)
        return by_key(BearingInputs, key, length, place=IN_WORDS[place], bound=">=" if shorter else "<=")()

    return ways


def _when_cold(inputs: BearingsInputs) -> Text:
    return Text("Clearance at {lowest_temperature} °C", lowest_temperature=Amount(inputs.lowest_temperature))


def edge_when_thinned(r: BearingResult) -> Metre:
    """The film at the edge of an oil that has lost by shear what a multigrade can."""
    return r.thinned - (r.film - r.film_edge)


def told_when_thinned(r: BearingResult) -> Amount | Text:
    edge = edge_when_thinned(r)
    return Text("nothing") if math.isnan(edge) else Amount(edge * 1e6, "µm")


def _outside(r: BearingResult) -> Text:
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


def _corner_checks(place: str, r: BearingResult) -> Iterator[Check]:
    """The limits once more at the worst corner of the tolerances, given or assumed."""
    c, inputs = r.corners, r.seat.inputs
    doubled, hottest = Text("Film at twice the load"), inputs.outlet_temperature_limit
    kreisle, given = Text("Kreisle, after Finotti 2013, 5.5.3"), Text("given in the design: its limit")
    seizure = Text("physics: seizure when cold")
    smoother = Text("A longer bearing, closer fits or a smoother surface.")
    longer, closer = Text("A longer bearing, or closer fits."), Text("More clearance, or closer fits.")
    more_oil = Text("More clearance at the tight end, or more oil.")
    for key, label, value, sense, limit, unit, source, advice in (
        ("film_edge", Text("Film at the edge"), c.film_edge, ">=", r.kreisle_film, "µm", kreisle, smoother),
        ("film_double_load", doubled, c.film_double_load, ">=", r.trumpler_film, "µm", rules.DESIGN_FACTOR, longer),
        ("temperature", Text("Outlet temperature"), c.outlet_temperature, "<=", hottest, "°C", given, more_oil),
        ("clearance_cold", _when_cold(inputs), c.clearance_cold, ">", 0.0, "µm", seizure, closer),
    ):
        corner = c.worst("outlet_temperature" if key == "temperature" else key)
        yield _bearing_check(
            place,
            f"{key}_corner",
            Text("{title} at the worst corner", title=label),
            value,
            sense,
            limit,
            unit,
            Text("{source}; corner: {corner}", source=source, corner=corner),
            Text("Worst corner: {corner}. {advice}", corner=corner, advice=advice),
        )
