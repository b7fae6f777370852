# SPDX-License-Identifier: Apache-2.0
"""What a bearing is judged by."""

import math
from collections.abc import Callable, Iterator
from functools import partial

from ..library.catalogue import Oil
from ..library.journal_rules import (
    DESIGN_FACTOR,
    FINOTTI,
    FULL_FILM_FRICTION,
    LENGTH_RATIO,
    LUBRICATIONS,
    N_RPM_MM,
    RISE,
    SPECIFIC_LOAD,
    STABLE_FILM,
    SUPPLY_WIDTH,
    TRUMPLER,
    TRUMPLER_TEMPERATURE,
    USUAL_LENGTH_RATIO,
    USUAL_SPECIFIC_LOAD,
)
from ..library.oils import BEYOND_ROWS, LAW_RANGE, MORE_ROWS, OTHER_OIL, VISCOSITIES
from ..library.tolerances import clearance_limits, parse
from ..sheet.check import Check, check
from ..sheet.quantity import dotted
from ..sheet.remedy import Remedy, by_key, down, up
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
    source = Text("given in the design") if oil.source == "the user" else Name(oil.source)
    return check(
        "bearings.oil_pumping",
        Text("Lowest temperature, oil still pumped"),
        inputs.lowest_temperature,
        ">=",
        max(limits),
        "°C",
        source,
        Text("An oil of a lower winter grade, or no start so cold."),
    )


def checks(place: str, r: BearingResult, slope: float) -> Iterator[Check]:
    """`slope`: of the journal in its seat, rad."""
    bearing, inputs = r.seat.bearing, r.seat.inputs
    bearing_check, longer = partial(_bearing_check, place), partial(_longer, place, bearing)
    lands = supply.lands(inputs)
    groove = (inputs.groove_width or 0.0) if lands > 1 else 0.0
    kreisle, oiled = (
        Text("Kreisle, after Finotti 2013, 5.5.3: Rt of both surfaces, Rt = k·Ra"),
        LUBRICATIONS[inputs.lubrication],
    )
    yield bearing_check(
        "film_edge",
        Text("Film at the edge"),
        r.film_edge,
        ">=",
        r.kreisle_film,
        "µm",
        kreisle,
        Text(
            "Lengthen the bearing, lower the clearance or the roughness, stiffen the shaft (slope), or take a thicker "
            "oil."
        ),
    )
    yield bearing_check(
        "film_double_load",
        Text("Film at twice the load"),
        r.film_double_load,
        ">=",
        r.trumpler_film,
        "µm",
        DESIGN_FACTOR,
        Text("Lengthen the bearing (a few millimetres are enough), or lower the clearance."),
    )
    yield bearing_check(
        "film_trumpler",
        Text("Film by Trumpler"),
        r.film,
        ">=",
        r.trumpler_film,
        "µm",
        TRUMPLER,
        Text("Lengthen the bearing, lower the clearance, or take a thicker oil."),
    )
    if r.thinnest_film is not None:
        slowest = Amount((r.speed_of_thinnest_film or 0.0) * 60)
        label = Text(
            "Film at the edge over the speeds, thinnest at {speed_of_thinnest_film} rpm", speed_of_thinnest_film=slowest
        )
        edge = f.film_at_edge_of_another(h_x=r.thinnest_film, h_0=r.film, h_edge=r.film_edge)
        yield bearing_check(
            "film_edge_speeds",
            label,
            edge,
            ">=",
            r.kreisle_film,
            "µm",
            kreisle,
            Text("As for the film at the edge; or keep away from this speed."),
        )
    yield bearing_check(
        "temperature",
        Text("Outlet temperature"),
        r.outlet_temperature,
        "<=",
        inputs.outlet_temperature_limit,
        "°C",
        Text("given in the design: its limit (the engine maker's manual, Finotti 2013, 5.5.1)"),
        Text("More oil (larger hole, more pressure, more clearance) or cooler oil."),
    )
    yield bearing_check(
        "temperature_trumpler",
        Text("Outlet temperature by Trumpler"),
        r.outlet_temperature,
        "<=",
        TRUMPLER_TEMPERATURE,
        "°C",
        TRUMPLER + Text(", who rounds his 250 °F (121 °C)"),
        Text("Acceptance rests on the engine maker's own limit; cooler supply oil would keep Trumpler's 120 °C."),
    )
    yield bearing_check(
        "temperature_rise_usual",
        Text("Temperature rise, usual"),
        r.temperature_rise,
        "<=",
        RISE[1],
        "K",
        Text("Finotti 2013, 5.5.2: 15 to 20 °C for conditions that stay"),
        Text("More oil, or a thinner one."),
    )
    for key, label, p_limit in (
        ("specific_load", Text("Specific load"), SPECIFIC_LOAD),
        ("specific_load_usual", Text("Specific load, usual"), USUAL_SPECIFIC_LOAD),
    ):
        yield bearing_check(
            key,
            label,
            r.specific_load,
            "<=",
            p_limit,
            "MPa",
            FINOTTI,
            Text("A larger journal helps as well."),
            remedies=longer(r.specific_load / p_limit, groove),
        )
    low, high = Amount(oiled.usual[0]), Amount(oiled.usual[1], "N·rpm/mm")
    row = Text("Finotti 2013, Table 3.1: {kind}, {low} to {high}", kind=oiled.title, low=low, high=high)
    if oiled.most is not None:
        row += Text(", beyond it by how much is cooled, up to {most}", most=Amount(oiled.most, "N·rpm/mm"))
    heat = [("heat_index", Text("Heat index"), oiled.limit)]
    if oiled.most is not None:
        heat.append(("heat_index_usual", Text("Heat index, usual"), oiled.usual[1] * N_RPM_MM))
    for key, label, W_limit in heat:
        yield bearing_check(
            key,
            label,
            r.heat_index,
            "<=",
            W_limit,
            "N·rpm/mm",
            row,
            Text("A longer bearing carries off more heat."),
            remedies=longer(r.heat_index / W_limit),
        )
    yield bearing_check(
        "clearance_cold",
        _when_cold(inputs),
        r.clearance_cold,
        ">",
        0.0,
        "µm",
        Text("physics: seizure of a journal that shrinks less than its seat"),
        Text("The journal seizes when cold: more clearance, or a housing that expands like the journal."),
    )
    for key, label, ratios, source in (
        ("length_ratio", Text("Length ratio l/d"), LENGTH_RATIO, FINOTTI),
        ("length_ratio_usual", Text("Length ratio l/d, usual"), USUAL_LENGTH_RATIO, Text("Finotti 2013, 5.5.2")),
    ):
        yield bearing_check(
            key,
            label,
            r.length_ratio,
            "in",
            ratios,
            "",
            source,
            Text("Change length or diameter."),
            remedies=_within(place, bearing, ratios, lands, groove),
        )
    yield bearing_check(
        "film_band",
        Text("Place of the film in its band"),
        r.film_band,
        "in",
        (0.0, 1.0),
        "%",
        RAIMONDI_BOYD,
        Text("Below 0 less clearance carries more and rubs less at the same film; above 100 % more clearance does."),
    )
    yield bearing_check(
        "transition",
        Text("Speed above mixed friction"),
        r.duty.effective_speed,
        ">=",
        r.least_speed,
        "rpm",
        Text(f.least_speed.source),
        Text("A thicker or cooler oil, or a lower specific load."),
    )
    yield bearing_check(
        "mckee",
        Text("McKee number, cP·rpm/psi"),
        r.mckee_number,
        ">=",
        STABLE_FILM,
        "",
        Text("McKee & McKee 1932, after Finotti 2013, 5.4.1; 30 is the transition"),
        Text("A thicker or cooler oil, or a lower specific load, for a stable film."),
    )
    if r.routes_spread is not None:
        yield bearing_check(
            "routes_spread",
            Text("Spread of the routes"),
            r.routes_spread,
            "<=",
            SPREAD,
            "%",
            Text("rule of this program: 15 % on the clearance as given and with the oil of the own solution"),
            _outside(r),
        )
    if (h_lim := least_film(bearing.diameter, r.surface_speed)) is not None:
        yield bearing_check(
            "film_edge_usual",
            Text("Film at the edge against h_lim"),
            r.film_edge,
            ">=",
            h_lim,
            "µm",
            Text("ISO 7902-3, in its manner"),
            Text("Lengthen the bearing or lower the clearance."),
        )
    yield bearing_check(
        "misalignment",
        Text("Slope over the length"),
        slope * bearing.length,
        "<=",
        0.3 * r.film,
        "µm",
        Text("rule of this program: 0.3·h₀"),
        Text("Stiffen the shaft between its bearings."),
    )
    yield bearing_check(
        "friction_regime",
        Text("Coefficient of friction"),
        r.friction_coefficient,
        "in",
        FULL_FILM_FRICTION,
        "",
        Text("Finotti 2013, 5.4.1: full film"),
        Text("Outside the usual range of a full film: look at film and clearance."),
    )
    if not r.seat.lubricant.constant:
        yield bearing_check(
            "viscosity_range", Text("Oil viscosity"), r.hot.oil.nu, "in", VISCOSITIES, "mm²/s", LAW_RANGE, OTHER_OIL
        )
    if (reach := r.seat.lubricant.reach) is not None:
        yield bearing_check(
            "oil_rows",
            Text("Film temperature within the rows of the oil"),
            r.hot.mean_temperature,
            "in",
            reach,
            "°C",
            BEYOND_ROWS,
            MORE_ROWS,
        )
    if r.seat.lubricant.polymer_thickened:
        yield bearing_check(
            "shear_rate",
            Text("Shear rate in the narrowest gap"),
            r.shear_rate,
            "<=",
            SHEAR_THINNING,
            "1/s",
            Text("rule of this program: onset of the thinning of polymer-thickened oils, from memory"),
            Text(
                "A multigrade oil loses up to {share} of its viscosity here, by which the film at the edge falls to "
                "{edge}: take the "
                "viscosity at high shear (HTHS).",
                share=Amount(100 * LOST_BY_SHEAR, "%"),
                edge=told_when_thinned(r),
            ),
        )
    yield from _corner_checks(place, r)
    if (clearances := _fits(r)) is not None:
        yield bearing_check(
            "fit",
            Text("Clearance made by the fits"),
            r.clearance,
            "in",
            clearances,
            "µm",
            Text("ISO 286"),
            Text(
                "{journal_fit} in {seat_fit} makes other clearances: choose other fits, or leave the clearance out.",
                journal_fit=inputs.journal_fit,
                seat_fit=inputs.seat_fit,
            ),
        )
    if inputs.supply != "groove":
        widths = {"pocket": inputs.pocket_width, "axial_groove": inputs.axial_groove_length}
        width = widths.get(inputs.supply, inputs.hole_diameter) or 0.0
        yield bearing_check(
            "supply_range",
            Text("Width of the oil supply over the length"),
            width / bearing.length,
            "in",
            SUPPLY_WIDTH,
            "",
            Text("Finotti 2013, Table 5.1 (DIN 31652-2): range of the supply factors"),
            Text("Outside, the flow through the hole or pocket is not to be trusted."),
        )


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


def _longer(place: str, bearing: BearingInputs, times: float, bare: float = 0.0) -> Callable[[], tuple[Remedy, ...]]:
    """A bearing so many times as long, but for what of its length is `bare` and stays."""
    key = dotted("bearings", place, BearingInputs.length)

    def ways() -> tuple[Remedy, ...]:
        length = up(bare + (bearing.length - bare) * times) if math.isfinite(times) else None
        return by_key(BearingInputs, key, length, place=IN_WORDS[place], bound=">=")()

    return ways


def _within(
    place: str, bearing: BearingInputs, ratios: tuple[float, float], lands: int, groove: float
) -> Callable[[], tuple[Remedy, ...]]:
    """The nearest length with a ratio l/d between the two: of each land, where a groove parts the bearing."""

    def ways() -> tuple[Remedy, ...]:
        low, high = (lands * ratio * bearing.diameter + groove for ratio in ratios)
        short_ = bearing.length < low
        key, length = dotted("bearings", place, BearingInputs.length), up(low) if short_ else down(high)
        return by_key(BearingInputs, key, length, place=IN_WORDS[place], bound=">=" if short_ else "<=")()

    return ways


def _when_cold(inputs: BearingsInputs) -> Text:
    return Text("Clearance at {lowest_temperature} °C", lowest_temperature=Amount(inputs.lowest_temperature))


def _fits(r: BearingResult) -> tuple[float, float] | None:
    """Least and most clearance of the fits; None where one of them has no place."""
    journal, seat = (parse(fit) for fit in (r.seat.inputs.journal_fit, r.seat.inputs.seat_fit))
    if journal.letter is None or seat.letter is None:
        return None
    return clearance_limits(journal, seat, r.seat.bearing.diameter)


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
    for key, column, label, value, sense, limit, unit, source, advice in (
        (
            "film_edge",
            "film_edge",
            Text("Film at the edge"),
            c.film_edge,
            ">=",
            r.kreisle_film,
            "µm",
            Text("Kreisle, after Finotti 2013, 5.5.3"),
            Text("A longer bearing, closer fits or a smoother surface."),
        ),
        (
            "film_double_load",
            "film_double_load",
            Text("Film at twice the load"),
            c.film_double_load,
            ">=",
            r.trumpler_film,
            "µm",
            DESIGN_FACTOR,
            Text("A longer bearing, or closer fits."),
        ),
        (
            "temperature",
            "outlet_temperature",
            Text("Outlet temperature"),
            c.outlet_temperature,
            "<=",
            inputs.outlet_temperature_limit,
            "°C",
            Text("given in the design: its limit"),
            Text("More clearance at the tight end, or more oil."),
        ),
        (
            "clearance_cold",
            "clearance_cold",
            _when_cold(inputs),
            c.clearance_cold,
            ">",
            0.0,
            "µm",
            Text("physics: seizure when cold"),
            Text("More clearance, or closer fits."),
        ),
    ):
        corner = c.worst(column)
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
