# SPDX-License-Identifier: Apache-2.0
"""Curves of a bearing: its film over the speeds and over the clearance it could have."""

from dataclasses import replace
from typing import Any

import numpy as np

from ..sheet.step import Curve, Series
from .result import BearingResult
from .routes.states import Duty, Seat

POINTS = 25
SHARES = np.linspace(0.4, 2.0, POINTS)  # of the design's clearance


def curves(place: str, r: BearingResult) -> tuple[Curve, ...]:
    return _over_speed(place, r), _over_clearance(place, r)


def _over_speed(place: str, r: BearingResult) -> Curve:
    rpm, film = np.array(r.sweep.speeds) * 60, np.array(r.sweep.films) * 1e6
    edge = (r.film - r.film_edge) * 1e6
    return Curve(
        f"film_{place}", f"Smallest film of the {place} bearing over speed, warm", "speed, rpm", "h_0, µm",
        (Series("mid-bearing", rpm, film), Series("at the edge", rpm, film - edge)), limits=(("Kreisle", r.kreisle_film * 1e6),),
    )  # fmt: skip


def clearance_points(seat: Seat, duty: Duty) -> tuple[Seat, Duty]:
    """More and less clearance, all else as designed: at the load, then at twice the load."""
    g: Any = np.tile(seat.clearance * SHARES, 2)
    load: Any = np.repeat([duty.load, 2 * duty.load], POINTS)
    return replace(seat, clearance=g), replace(duty, load=load)


def _over_clearance(place: str, r: BearingResult) -> Curve:
    film: Any = r.over_clearance.film
    shown, edge = r.clearance * SHARES * 1e6, r.film - r.film_edge
    series = (Series("at the edge", shown, (film[:POINTS] - edge) * 1e6), Series("twice the load", shown, film[POINTS:] * 1e6))
    limits = (("Kreisle", r.kreisle_film * 1e6), ("Trumpler", r.trumpler_film * 1e6))
    title = f"Film of the {place} bearing over its clearance at {r.seat.inputs.clearance_reference_temperature:g} °C"
    return Curve(f"film_over_clearance_{place}", title, "clearance, µm", "h, µm", series, limits=limits)
