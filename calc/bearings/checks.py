# SPDX-License-Identifier: Apache-2.0
"""What a bearing is judged by: limits that fail, advice that warns."""

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from ..fits import clearance_limits, parse
from ..sheet.check import Check, check
from ..sheet.number import short
from . import formulas as f
from .inputs import BearingsInputs
from .pairing.pairing import USUAL_LENGTH_RATIO
from .routes.side_by_side import ROUTES, SPREAD, reason

if TYPE_CHECKING:
    from .result import BearingResult

FINOTTI = "Finotti 2013, 3.2.3.1"
TRUMPLER = "Trumpler, after Finotti 2013, 5.6"
# Least film by journal diameter and surface speed, in the manner of ISO 7902-3 (as generally published), in m.
SPEEDS = (1.0, 3.0, 10.0, 30.0)
LEAST_FILM = ((0.063, (3e-6, 4e-6, 5e-6, 7e-6, 10e-6)), (0.160, (4e-6, 5e-6, 7e-6, 9e-6, 12e-6)))


SHEAR_THINNING = 1e5  # 1/s
POLYMER_THICKENED = -3.3  # slope of the viscosity line: flatter is a multigrade; rule of this program, tells those of its table apart


def least_film(d: float, u: float) -> float | None:
    """h_lim of a journal from 24 to 160 mm; None outside."""
    column = sum(u > limit for limit in SPEEDS)
    return next((row[column] for up_to, row in LEAST_FILM if d <= up_to), None) if d >= 0.024 else None


def checks(place: str, r: "BearingResult", slope: float) -> Iterator[Check]:
    bearing, inputs = r.seat.bearing, r.seat.inputs
    at = f"bearings.{place}"
    where = f", {place}"
    yield check(
        f"{at}.film_edge",
        "Film at the edge" + where,
        r.film_edge,
        ">=",
        r.kreisle_film,
        "µm",
        "Kreisle: Rt of both surfaces, Rt = k·Ra",
        "Lengthen the bearing, lower the clearance or the roughness, stiffen the shaft (slope), or take a thicker oil.",
    )
    yield check(
        f"{at}.film_double_load",
        "Film at twice the load" + where,
        math.nan if r.film_double_load is None else r.film_double_load,
        ">=",
        r.trumpler_film,
        "µm",
        TRUMPLER + ": n_d ≥ 2 on the running load",
        "Lengthen the bearing (a few millimetres are enough), or lower the clearance.",
    )
    yield check(
        f"{at}.film_trumpler",
        "Film by Trumpler" + where,
        r.film,
        ">=",
        r.trumpler_film,
        "µm",
        TRUMPLER,
        "Lengthen the bearing, lower the clearance, or take a thicker oil.",
        kind="advice",
    )
    if r.thinnest_film is not None:
        yield check(
            f"{at}.film_edge_speeds",
            f"Film at the edge over the speeds, thinnest at {short((r.speed_of_thinnest_film or 0.0) * 60)} rpm" + where,
            r.thinnest_film - (r.film - r.film_edge),
            ">=",
            r.kreisle_film,
            "µm",
            "Kreisle: Rt of both surfaces, Rt = k·Ra",
            "As for the film at the edge; or keep away from this speed.",
            kind="advice",
        )
    yield check(
        f"{at}.temperature",
        "Outlet temperature" + where,
        r.outlet_temperature,
        "<=",
        inputs.outlet_temperature_limit,
        "°C",
        "limit of the design (engine manual)",
        "More oil (larger hole, more pressure, more clearance) or cooler oil.",
    )
    yield check(
        f"{at}.temperature_trumpler",
        "Outlet temperature by Trumpler" + where,
        r.outlet_temperature,
        "<=",
        121.0,
        "°C",
        TRUMPLER,
        "Acceptance rests on the engine maker's own limit; cooler supply oil would keep Trumpler's 121 °C.",
        kind="advice",
    )
    yield check(
        f"{at}.specific_load",
        "Specific load" + where,
        r.specific_load,
        "<=",
        5e6,
        "MPa",
        FINOTTI,
        "Lengthen the bearing or take a larger journal.",
    )
    yield check(
        f"{at}.specific_load_usual",
        "Specific load, usual" + where,
        r.specific_load,
        "<=",
        2e6,
        "MPa",
        FINOTTI,
        "Lengthen the bearing or take a larger journal.",
        kind="advice",
    )
    yield check(
        f"{at}.heat_index",
        "Heat index" + where,
        r.heat_index,
        "<=",
        500_000 * 1000 / 60,
        "N·rpm/mm",
        "Finotti 2013, Table 3.1",
        "Lengthen the bearing.",
    )
    yield check(
        f"{at}.heat_index_usual",
        "Heat index, forced oil and cooling" + where,
        r.heat_index,
        "<=",
        240_000 * 1000 / 60,
        "N·rpm/mm",
        "Finotti 2013, Table 3.1",
        "Lengthen the bearing.",
        kind="advice",
    )
    yield check(
        f"{at}.clearance_cold",
        f"Clearance at {short(inputs.lowest_temperature)} °C" + where,
        r.clearance_cold,
        ">",
        0.0,
        "µm",
        "seizure of a journal that shrinks less than its seat",
        "The journal seizes when cold: more clearance, or a housing that expands like the journal.",
    )
    yield check(
        f"{at}.length_ratio", "Length ratio l/d" + where, r.length_ratio, "in", (0.2, 1.0), "", FINOTTI, "Change length or diameter."
    )
    yield check(
        f"{at}.length_ratio_usual",
        "Length ratio l/d, usual" + where,
        r.length_ratio,
        "in",
        USUAL_LENGTH_RATIO,
        "",
        "Finotti 2013, 5.5.2",
        "Change length or diameter.",
        kind="advice",
    )
    yield check(
        f"{at}.transition",
        "Speed above mixed friction" + where,
        r.duty.effective_speed,
        ">=",
        r.least_speed,
        "rpm",
        f.least_speed.source,
        "A thicker or cooler oil, or a lower specific load.",
    )
    yield check(
        f"{at}.mckee",
        "McKee number, cP·rpm/psi" + where,
        r.mckee_number,
        ">=",
        150.0,
        "",
        "McKee & McKee 1932; 30 is the transition",
        "A thicker or cooler oil, or a lower specific load, for a stable film.",
        kind="advice",
    )
    if r.routes_spread is not None:
        yield check(
            f"{at}.routes_spread",
            "Spread of the routes" + where,
            r.routes_spread,
            "<=",
            SPREAD,
            "%",
            "rule of this program, on the clearance as given",
            _outside(r),
            kind="advice",
        )
    if (h_lim := least_film(bearing.diameter, r.surface_speed)) is not None:
        yield check(
            f"{at}.film_edge_usual",
            "Film at the edge against h_lim" + where,
            r.film_edge,
            ">=",
            h_lim,
            "µm",
            "in the manner of ISO 7902-3, as generally published",
            "Lengthen the bearing or lower the clearance.",
            kind="advice",
        )
    yield check(
        f"{at}.misalignment",
        "Slope over the length" + where,
        slope * bearing.length,
        "<=",
        0.3 * r.film,
        "µm",
        "rule of this program: 0.3·h₀",
        "Stiffen the shaft between its bearings.",
        kind="advice",
    )
    yield check(
        f"{at}.friction_regime",
        "Coefficient of friction" + where,
        r.friction_coefficient,
        "in",
        (0.002, 0.012),
        "",
        "Finotti 2013, 5.6: full film",
        "Outside the usual range of a full film: look at film and clearance.",
        kind="advice",
    )
    yield check(
        f"{at}.viscosity_range",
        "Oil viscosity" + where,
        r.hot.oil.nu,
        "in",
        (2e-6, 0.1),
        "mm²/s",
        "range of the viscosity law",
        "Another oil grade or temperature.",
        kind="advice",
    )
    if r.seat.lubricant.C_1 > POLYMER_THICKENED:
        yield check(
            f"{at}.shear_rate",
            "Shear rate in the narrowest gap" + where,
            r.shear_rate,
            "<=",
            SHEAR_THINNING,
            "1/s",
            "onset of the thinning of polymer-thickened oils, as generally published",
            "A multigrade oil loses up to 30 % of its viscosity here: take that at high shear (HTHS), or the corners with thinner oil.",
            kind="advice",
        )
    yield from _corner_checks(at, where, r, inputs)
    if (made := _fits(r)) is not None:
        yield check(
            f"{at}.fit",
            "Clearance made by the fits" + where,
            r.clearance,
            "in",
            made,
            "µm",
            "ISO 286",
            f"{inputs.journal_fit} in {inputs.seat_fit} makes other clearances: choose other fits, or leave the clearance out.",
            kind="advice",
        )
    if inputs.supply != "groove":
        width = (inputs.pocket_width if inputs.supply == "pocket" else inputs.hole_diameter) or 0.0
        yield check(
            f"{at}.supply_range",
            "Width of the oil supply over the length" + where,
            width / bearing.length,
            "in",
            (0.05, 0.7),
            "",
            "range of the supply factors, DIN 31652-2",
            "Outside, the flow through the hole or pocket is not to be trusted.",
            kind="advice",
        )


def _fits(r: "BearingResult") -> tuple[float, float] | None:
    """Least and most clearance of the fits; None where one of them has no place."""
    journal, seat = (parse(fit) for fit in (r.seat.inputs.journal_fit, r.seat.inputs.seat_fit))
    if journal.letter is None or seat.letter is None:
        return None
    return clearance_limits(journal, seat, r.seat.bearing.diameter)


def _outside(r: "BearingResult") -> str:
    """Which routes are further off than the spread allows, by how much and why."""
    own = r.side.films["reynolds"].film
    said = [
        f"{ROUTES[name][0]} is {(r.side.films[name].film / own - 1) * 100:+.0f} % off: {reason(name, r.side)}"
        for name, far in r.side.deviations.items()
        if far > SPREAD
    ]
    return "; ".join([*said, "the own solution of Reynolds' equation judges"]).replace("-", "−") + "." if said else ""


def _corner_checks(at: str, where: str, r: "BearingResult", inputs: BearingsInputs) -> Iterator[Check]:
    """The limits once more at the worst corner of the tolerances.  Assumed tolerances advise; given ones judge."""
    c = r.corners
    kind = "limit" if inputs.fits_given else "advice"
    rows = (
        ("film_edge", "Film at the edge", c.film_edge, ">=", r.kreisle_film, "µm", "Kreisle",
         "A longer bearing, closer fits or a smoother surface."),
        ("film_double_load", "Film at twice the load", c.film_double_load, ">=", r.trumpler_film, "µm", TRUMPLER,
         "A longer bearing, or closer fits."),
        ("outlet_temperature", "Outlet temperature", c.outlet_temperature, "<=", inputs.outlet_temperature_limit, "°C",
         "limit of the design", "More clearance at the tight end, or more oil."),
        ("clearance_cold", f"Clearance at {short(inputs.lowest_temperature)} °C", c.clearance_cold, ">", 0.0, "µm", "seizure when cold",
         "More clearance, or closer fits."),
    )  # fmt: skip
    for name, title, number, sense, limit, unit, source, advice in rows:
        id = "temperature" if name == "outlet_temperature" else name
        corner = c.worst(name)
        yield check(
            f"{at}.{id}_corner", f"{title} at the worst corner{where}", math.nan if number is None else number, sense, limit, unit,
            f"{source}; corner: {corner}",
            f"Worst corner: {corner}. {advice}", kind=kind,
        )  # fmt: skip
