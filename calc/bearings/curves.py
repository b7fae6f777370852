# SPDX-License-Identifier: Apache-2.0
"""Curves of a bearing: its film over the speeds and over the clearance it could have."""

from dataclasses import replace

import numpy as np

from ..sheet.arrays import Array, each, many
from ..sheet.step import Curve, Series, axis_label
from ..sheet.text import Amount, Text
from .corners import corner_values
from .inputs import IN_WORDS
from .result import BearingResult
from .routes.balance import settled
from .routes.states import BearingCase, Film, OperatingPoint
from .sweep import at_speeds

POINTS = 25
SHARES = np.linspace(0.4, 2.0, POINTS)  # of the design's clearance


def curves(place: str, r: BearingResult) -> tuple[Curve, ...]:
    return _over_speed(place, r), _over_clearance(place, r)


def _over_speed(place: str, r: BearingResult) -> Curve:
    rpm, film = np.array(r.sweep.speeds) * 60, np.array(r.sweep.films) * 1e6
    edge = (r.film - r.film_edge) * 1e6
    series = [Series(Text("mid-bearing"), rpm, film), Series(Text("at the edge"), rpm, film - edge)]
    at_corners = _films_at_corners(r) * 1e6 - edge
    known = np.isfinite(at_corners).all(axis=0)
    if band := bool(np.count_nonzero(known) > 1):
        ends = (
            (Text("thinnest corner"), at_corners.min(axis=0)),
            (Text("thickest corner"), at_corners.max(axis=0)),
        )
        series += [Series(label, rpm[known], y[known]) for label, y in ends]
    title = Text("Smallest film of the {place} bearing over speed, warm; corners of its tolerances at the edge", place=IN_WORDS[place])
    return Curve(f"film_{place}", title, axis_label("speed", "rpm"), axis_label("h_0", "µm"), tuple(series),
        limits=((Text("Kreisle"), r.kreisle_film * 1e6),), point=(r.duty.speed * 60, r.film_edge * 1e6),
        fails=r.film_edge < r.kreisle_film, band=band)  # fmt: skip


def _films_at_corners(r: BearingResult) -> Array:
    """The smallest film at each corner of the tolerances and each speed; nan where there is none."""
    sweep, (g, factor) = r.sweep, corner_values(r.seat)
    count = len(sweep.speeds)
    seat = replace(r.seat, clearance=each(np.repeat(np.asarray(g), count)), viscosity_factor=each(np.repeat(factor, count)))
    speeds, temperatures, pressures = (np.tile(row, len(factor)) for row in (sweep.speeds, sweep.temperatures, sweep.pressures))
    film = settled(seat, at_speeds(r.seat, sweep.rated, r.duty, speeds, temperatures, pressures)).film
    return many(film).reshape(len(factor), count)


def clearance_points(seat: BearingCase, duty: OperatingPoint) -> tuple[BearingCase, OperatingPoint]:
    """More and less clearance, all else as designed: at the load, then at twice the load."""
    load = np.repeat([duty.load, 2 * duty.load], POINTS)
    return replace(seat, clearance=each(np.tile(seat.clearance * SHARES, 2))), replace(duty, load=each(load))


def over_clearance(r: BearingResult) -> Film:
    """The films at `clearance_points`."""
    return settled(*clearance_points(r.seat, r.duty))


def _over_clearance(place: str, r: BearingResult) -> Curve:
    film, edge = many(over_clearance(r).film), r.film - r.film_edge
    clearance = r.clearance * SHARES * 1e6
    series = (
        Series(Text("at the edge"), clearance, (film[:POINTS] - edge) * 1e6),
        Series(Text("twice the load"), clearance, film[POINTS:] * 1e6),
    )
    limits = ((Text("Kreisle"), r.kreisle_film * 1e6), (Text("Trumpler"), r.trumpler_film * 1e6))
    T_ref = Amount(r.seat.inputs.clearance_reference_temperature, form="g")
    title = Text("Film of the {place} bearing over its clearance at {clearance_reference_temperature} °C", place=IN_WORDS[place],
        clearance_reference_temperature=T_ref)  # fmt: skip
    return Curve(f"film_over_clearance_{place}", title, axis_label("clearance", "µm"), axis_label("h", "µm"), series, limits=limits,
        point=(r.clearance * 1e6, r.film_edge * 1e6), fails=r.film_edge < r.kreisle_film)  # fmt: skip
