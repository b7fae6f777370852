# SPDX-License-Identifier: Apache-2.0
"""Curves of a bearing: its film over speed and clearance, and charts of the literature with the design's own point."""

import math
from collections.abc import Callable, Iterable, Iterator
from functools import cache, partial
from typing import Any

import numpy as np

from ...countershaft.rows import called
from ...library.catalogue import oils
from ...library.lubricant import Lubricant
from ...sheet.arrays import Array
from ...sheet.errors import NoSolution
from ...sheet.functions import root
from ...sheet.record import replace
from ...sheet.step import Curve, Series, axis_label
from ...sheet.text import Amount, Name, Text
from ...sheet.value import unlinked, untraced
from ..result import BearingsResult
from .corners import corner_values
from .film import reynolds, table
from .film.reynolds import ECCENTRICITY_RANGE, LENGTH_RATIO_RANGE
from .film.table import ECCENTRICITIES, FilmPoint, FilmRangeError, film_at
from .result import PlainResult
from .routes.routes import own_warm
from .routes.states import BearingCase, Film, OperatingPoint, resized
from .routes.supply import lands
from .routes.thermal_balance import balanced, settled
from .speeds import at_speeds

POINTS = 25
SHARES = np.linspace(0.4, 2.0, POINTS)  # of the design's clearance


def curves(place: str, r: PlainResult) -> tuple[Curve, ...]:
    return _over_speed(place, r), _over_clearance(place, r)


def in_films(found: BearingsResult) -> Iterator[Curve]:
    """The line of the shaft in its films, between the clearances; under a couple it goes round as a cone."""
    if found.line is None:
        return
    z, way = found.line
    rows = list(found.bearings.values())
    places = np.array([r.row.position for r in rows]) * 1e3
    gap = np.array([r.running_clearance for r in rows]) / 2 * 1e6
    largest = way[np.abs(way).argmax()]
    turned = way * np.conj(largest) / (np.abs(largest) or 1.0) * 1e6
    series = (
        Series(Text("in the plane of the largest way"), z * 1e3, turned.real),
        Series(Text("across it"), z * 1e3, turned.imag),
        Series(Text("clearance"), places, gap),
        Series(Text("clearance, other side"), places, -gap),
    )
    title = Text("Line of the shaft in its films at rated speed; it goes round with the shaft")
    yield Curve("in_films", title, axis_label("from mid-shaft", "mm"), axis_label("way of the axis", "µm"), series)


SAME = 1e-3  # relative: oil that is no other


def _over_speed(place: str, r: PlainResult) -> Curve:
    rpm, film = np.array(r.sweep.speeds) * 60, np.array(r.sweep.films) * 1e6
    edge = (r.film - r.film_edge) * 1e6
    series = [Series(Text("mid-bearing"), rpm, film), Series(Text("at the edge"), rpm, film - edge)]
    at_corners = _films_at_corners(r) * 1e6 - edge
    known = np.isfinite(at_corners).all(axis=0)
    if band := bool(np.count_nonzero(known) > 1):
        thinnest, thickest = at_corners[:, known].min(axis=0), at_corners[:, known].max(axis=0)
        series += [Series(Text("thinnest corner"), rpm[known], thinnest)]
        series += [Series(Text("thickest corner"), rpm[known], thickest)]
    title = Text(
        "Smallest film of the {place} bearing over speed, warm; corners of its tolerances at the edge",
        place=called(place),
    )
    if _other_oil(r):
        title = Text("{title}. Curves: the bench run's oil; point: the oil that is supplied", title=title)
    return Curve(
        f"film_{place}",
        title,
        axis_label("speed", "rpm"),
        axis_label("h_0", "µm"),
        tuple(series),
        limits=((Text("Kreisle"), r.kreisle_film * 1e6),),
        point=(r.duty.speed * 60, r.film_edge * 1e6),
        fails=r.film_edge < r.kreisle_film,
        band=band,
        short=1,
    )


def _other_oil(r: PlainResult) -> bool:
    """Whether the oil over the speeds is another one at the speed of the design than that which is supplied there."""
    order = np.argsort(r.sweep.speeds)
    taken = r.duty.supply_temperature, r.duty.supply_pressure
    for x, values in zip(taken, (r.sweep.temperatures, r.sweep.pressures)):
        there = np.interp(r.duty.speed, np.array(r.sweep.speeds)[order], np.array(values)[order])
        if abs(there - x) > SAME * abs(x):
            return True
    return False


def _films_at_corners(r: PlainResult) -> Array:
    """The smallest film at each corner of the tolerances and each speed; nan where there is none."""
    sweep, (g, factor) = r.sweep, corner_values(r.seat)
    count = len(sweep.speeds)
    seat: BearingCase[Any] = r.seat
    seat = replace(seat, clearance=np.repeat(np.asarray(g), count), viscosity_factor=np.repeat(factor, count))
    speeds, temperatures, pressures = (
        np.tile(row, len(factor)) for row in (sweep.speeds, sweep.temperatures, sweep.pressures)
    )
    film = settled(seat, at_speeds(r.seat, sweep.rated, r.duty, speeds, temperatures, pressures)).film
    return film.reshape(len(factor), count)


def clearance_points(seat: BearingCase[Any], duty: OperatingPoint[Any]) -> tuple[BearingCase[Any], OperatingPoint[Any]]:
    """More and less clearance, all else as designed: at the load, then at twice the load."""
    load = np.repeat([duty.load, 2 * duty.load], POINTS)
    return replace(seat, clearance=np.tile(seat.clearance * SHARES, 2)), replace(duty, load=load)


def over_clearance(r: PlainResult) -> Film[Array]:
    """The films at `clearance_points`."""
    return settled(*clearance_points(r.seat, r.duty))


def _over_clearance(place: str, r: PlainResult) -> Curve:
    film, edge = over_clearance(r).film, r.film - r.film_edge
    clearance = r.clearance * SHARES * 1e6
    series = (
        Series(Text("at the edge"), clearance, (film[:POINTS] - edge) * 1e6),
        Series(Text("twice the load"), clearance, film[POINTS:] * 1e6),
    )
    limits = ((Text("Kreisle"), r.kreisle_film * 1e6), (Text("Trumpler"), r.trumpler_film * 1e6))
    T_ref = Amount(r.seat.inputs.clearance_reference_temperature, form="g")
    title = Text(
        "Film of the {place} bearing over its clearance at {clearance_reference_temperature} °C",
        place=called(place),
        clearance_reference_temperature=T_ref,
    )
    return Curve(
        f"film_over_clearance_{place}",
        title,
        axis_label("clearance", "µm"),
        axis_label("h", "µm"),
        series,
        limits=limits,
        point=(r.clearance * 1e6, r.film_edge * 1e6),
        fails=r.film_edge < r.kreisle_film,
    )


# --- charts of the literature on plain bearings, each with this design's own point
# Made when somebody looks.  The pressure around, what clearance and length do, the chart of Raimondi and Boyd with
# its band, the friction over the duty, the oils.

PUBLISHED_RATIOS = (1.0, 0.5, 0.25)  # l/d of the curves of 1958, beside the infinitely long bearing
RATIOS = np.linspace(0.2, 2.0, 19)  # of the lengths that are tried: up to the end of the table of films
LOADS = np.geomspace(0.05e6, 50e6, 61)  # Pa, specific, of those that are tried
OILS = ("0W-20", "5W-30", "10W-40", "15W-40")
AS_DESIGNED = Text("as designed")
OVER_DESIGN = Text("over that of the design")
EFFECTS = (Text("smallest film"), Text("largest pressure"), Text("temperature rise"))
LG_S = Text("lg S")


def charts(results: dict[str, PlainResult]) -> Iterator[Curve]:
    """Every chart that can be drawn: where a film has no solution its chart is left out, and the others stay."""
    first = next(iter(results.values()))
    makers: list[Callable[[], Iterable[Curve]]] = []
    for place, r in results.items():
        makers += [partial(_clearance, place, r), partial(_length, place, r)]
        if r.seat.inputs.supply != "axial_groove":  # the film of a bearing without grooves
            makers += [partial(_pressure, place, r), partial(_allowable, place, r), partial(_raimondi_boyd, place, r)]
            makers += [partial(_duty, place, r), partial(_further_charts, place, r)]
    makers += [partial(_oils, first), partial(_bench, first)]
    for make in makers:
        try:
            with untraced():
                some = tuple(make())
        except (NoSolution, ArithmeticError, ValueError):
            continue
        yield from some


def _pressure(place: str, r: PlainResult) -> Iterator[Curve]:
    """Around the middle plane, and along where it is largest: as designed, with the journal's slope, and parted by a
    groove around, where each half carries half of the load."""
    inputs, length = r.seat.inputs, r.seat.bearing.length * 1e3
    groove = (inputs.groove_width or 0.0) * 1e3 if lands(inputs) == 2 else 0.0
    films = {AS_DESIGNED: (_film(r.eccentricity, r.length_ratio), lands(inputs), length - groove)}
    if inputs.supply != "groove":
        try:
            half = _film(table.eccentricity_from(float(r.sommerfeld), r.length_ratio / 2), r.length_ratio / 2)
            films[Text("parted by a groove around")] = half, 2, length
        except FilmRangeError:
            pass  # so short a half carries this load at no eccentricity of the table
    scale = r.hot.oil.mu * 2 * math.pi * r.duty.effective_speed / r.relative_clearance**2 / 1e6
    mean, where = (Text("specific load"), r.specific_load / 1e6), dict(place=called(place))
    around, along = [], []
    for label, (film, parts, bare) in films.items():
        # from the load's direction, in the sense of the journal's rotation
        angle = np.degrees(film.theta - math.pi + film.attitude)
        around.append(Series(label, angle, film.pressure * scale))
        z = np.append(-film.z[::-1], film.z[1:])
        p = np.append(film.pressure_along[::-1], film.pressure_along[1:]) * scale
        half_length = bare / 2 / parts
        middles = (0.0,) if parts == 1 else (half_length - length / 2, length / 2 - half_length)
        along.append(Series(label, np.concatenate([m + z * half_length for m in middles]), np.tile(p, parts)))
    if lands(inputs) == 1 and (sloping := _sloping(r)) is not None:
        label = Text("sloping, {slope}", slope=Amount((r.film - r.film_edge) / length * 2e6, "mrad", form=".2g"))
        along.insert(1, Series(label, sloping.z * length / 2, sloping.pressure_along * scale))
    from_load, pressure = axis_label("angle from the load", "°"), axis_label("p", "MPa")
    title = Text("Film pressure around the {place} bearing, in the plane of its largest", **where)
    yield Curve(f"pressure_around_{place}", title, from_load, pressure, tuple(around), (mean,))
    title = Text("Film pressure along the {place} bearing, where it is largest", **where)
    yield Curve(f"pressure_along_{place}", title, axis_label("z", "mm"), pressure, tuple(along), (mean,))


def _sloping(r: PlainResult) -> reynolds.MisalignedFilm | None:
    """The film that carries the same load with the journal's slope; None: it has none, or so much that an edge leaves
    the range."""
    tilt = (r.film - r.film_edge) / (r.clearance_hot / 2)
    # at the same ε it carries more
    low, high = (tilt + ECCENTRICITY_RANGE[0], min(float(r.eccentricity), ECCENTRICITY_RANGE[1] - tilt))

    def missing(eccentricity: float) -> float:
        return math.log(reynolds.solve_misaligned(eccentricity, tilt, r.length_ratio).sommerfeld / r.sommerfeld)

    if tilt <= 0 or high <= low or missing(high) > 0 or missing(low) < 0:
        return None
    return reynolds.solve_misaligned(root(missing, low, high, tolerance=1e-4), tilt, r.length_ratio)


def _film(eccentricity: float, length_ratio: float) -> reynolds.FilmSolution:
    return reynolds.solve_film(
        float(np.clip(eccentricity, *ECCENTRICITY_RANGE)), float(np.clip(length_ratio, *LENGTH_RATIO_RANGE))
    )


def _clearance(place: str, r: PlainResult) -> Iterator[Curve]:
    over, clearance = over_clearance(r), r.clearance * SHARES * 1e6
    pressure = np.asarray(over.largest_pressure) / r.film_pressure_max
    effects = over.film / r.film, pressure, over.temperature_rise / r.temperature_rise
    series = tuple(Series(label, clearance, effect[:POINTS]) for label, effect in zip(EFFECTS, effects))
    title = Text("What the clearance of the {place} bearing does", place=called(place))
    yield Curve(f"clearance_effects_{place}", title, axis_label("clearance", "µm"), OVER_DESIGN, series)


def _length(place: str, r: PlainResult) -> Iterator[Curve]:
    """Longer and thinner, shorter and thicker, with the same projected area and relative clearance."""
    bearing, points = r.seat.bearing, []
    area, psi = bearing.diameter * bearing.length, r.clearance / bearing.diameter
    for ratio in RATIOS:
        d = math.sqrt(area / ratio)
        other = replace(unlinked(bearing), diameter=d, length=ratio * d, clearance=psi * d, clearance_factor=None)
        seat = replace(unlinked(r.seat), bearing=other, clearance=psi * d)
        try:
            film = balanced(own_warm, seat, unlinked(r.duty), 1e-6)
            pressure = (film.largest_pressure or 0.0) / r.film_pressure_max
            points.append((ratio, film.film / r.film, pressure, film.temperature_rise / r.temperature_rise))
        except (NoSolution, ArithmeticError, ValueError):
            continue  # so short a bearing carries the load at no eccentricity of the table
    ratios, *effects = np.array(points).T if points else np.zeros((4, 0))
    title = Text("What the length of the {place} bearing does at the same projected area", place=called(place))
    series = tuple(Series(label, ratios, effect) for label, effect in zip(EFFECTS, effects))
    yield Curve(f"length_effects_{place}", title, Text("l/d"), OVER_DESIGN, series)


def _allowable(place: str, r: PlainResult) -> Iterator[Curve]:
    """The specific load at which the film at the edge is as thin as Kreisle lets it be, over the length of this
    journal, all else as designed: parallel it rises with the length, a journal that slopes loses its edges."""
    bearing, inputs = unlinked(r.seat.bearing), r.seat.inputs
    d, count = bearing.diameter, lands(inputs)
    groove = (inputs.groove_width or 0.0) if count == 2 else 0.0
    supplied = max(width or 0.0 for width in (inputs.hole_diameter, inputs.groove_width, inputs.pocket_width))
    l = RATIOS * count * d + groove
    l = l[l > supplied]
    duty: OperatingPoint[Any] = unlinked(r.duty)
    at = resized(unlinked(r.seat), length=l[None])
    h_0 = settled(at, replace(duty, load=LOADS[:, None] * d * (l - groove))).film
    slope, ratios = (r.film - r.film_edge) * 2 / bearing.length, (l - groove) / count / d
    cases = [(Text("parallel"), 0.0)]
    if slope > 0:
        cases.append((Text("sloping, {slope}", slope=Amount(slope * 1e3, "mrad", form=".2g")), slope))
    series = []
    for label, theta in cases:
        edge = h_0 - theta * l / 2
        there = np.isfinite(edge)
        p = [
            np.interp(-r.kreisle_film, -edge[on, j], LOADS[on], left=np.nan, right=np.nan)
            for j, on in enumerate(there.T)
            if on.any()
        ]
        series.append(Series(label, ratios[there.any(axis=0)], np.array(p) / 1e6))
    series.append(Series(AS_DESIGNED, np.array([r.length_ratio]), np.array([r.specific_load / 1e6])))
    title = Text("Specific load that the {place} bearing bears over its l/d", place=called(place))
    yield Curve(f"allowable_load_{place}", title, Text("l/d"), axis_label("p", "MPa"), tuple(series))


def _raimondi_boyd(place: str, r: PlainResult) -> Iterator[Curve]:
    series = [Series(label, np.log10(film.sommerfeld), 1 - ECCENTRICITIES) for label, film in _published(r)]
    series += _band()
    series.append(Series(AS_DESIGNED, np.array([math.log10(r.sommerfeld)]), np.array([1 - r.eccentricity])))
    title = Text("Chart of Raimondi and Boyd with the {place} bearing, warm", place=called(place))
    yield Curve(f"raimondi_boyd_chart_{place}", title, LG_S, Text("h₀/c"), tuple(series))


def _published(r: PlainResult) -> list[tuple[Text, FilmPoint[Array]]]:
    """The films of the published l/d and of the design's own."""
    ratios = dict.fromkeys((*PUBLISHED_RATIOS, round(float(r.length_ratio), 4)))
    return [(Text("l/d = {ratio}", ratio=float(ratio)), film_at(ECCENTRICITIES, ratio)) for ratio in ratios]


def _further_charts(place: str, r: PlainResult) -> Iterator[Curve]:
    """The other charts of 1958: friction, flow, side flow and pressure over S, with the design's point on the line of
    its length."""
    design_film = film_at(float(r.eccentricity), float(np.clip(r.length_ratio, *LENGTH_RATIO_RANGE)))
    where = dict(place=called(place))
    parts = (
        ("friction", Text("lg f*, f* = (r/c)·f"), Text("Raimondi and Boyd: friction, {place} bearing", **where)),
        ("flow", Text("Q/(r·c·n·l)"), Text("Raimondi and Boyd: flow, {place} bearing", **where)),
        ("side_flow_ratio", Text("Q_s/Q"), Text("Raimondi and Boyd: side flow, {place} bearing", **where)),
        ("pressure_ratio", Text("p/p_max"), Text("Raimondi and Boyd: pressure, {place} bearing", **where)),
    )
    films = _published(r)
    for name, label, title in parts:
        scale = np.log10 if name == "friction" else np.asarray
        lines = [Series(label, np.log10(film.sommerfeld), scale(getattr(film, name))) for label, film in films]
        point = scale(np.array([getattr(design_film, name)]))
        lines.append(Series(AS_DESIGNED, np.array([math.log10(r.sommerfeld)]), point))
        yield Curve(f"raimondi_boyd_{name}_{place}", title, LG_S, label, tuple(lines))


@cache
def _band() -> list[Series]:
    """Where the load is largest, and where the friction is least, for bearings of all lengths."""
    lengths, lines = np.linspace(PUBLISHED_RATIOS[-1], 1.5, 15), []
    for share_of, label in (
        (table.share_of_largest_load, Text("largest load")),
        (table.share_of_least_friction, Text("least friction")),
    ):
        share = np.array([share_of(b=float(length)) for length in lengths])
        S = film_at(np.clip(1 - share, *ECCENTRICITY_RANGE), lengths).sommerfeld
        lines.append(Series(label, np.log10(S), share))
    return lines


def _duty(place: str, r: PlainResult) -> Iterator[Curve]:
    """f over ZN/P: along the line of this bearing's relative clearance, down to where its film is as thin as its
    roughness."""
    film = film_at(ECCENTRICITIES, float(np.clip(r.length_ratio, *LENGTH_RATIO_RANGE)))
    thick = (1 - ECCENTRICITIES) * r.clearance_hot / 2 >= r.kreisle_film / 3
    zn_p = r.mckee_number * film.sommerfeld / r.sommerfeld
    shown = thick & (zn_p < 10 * r.mckee_number)
    line = Series(Text("full film"), zn_p[shown], (r.relative_clearance * film.friction)[shown])
    point = Series(AS_DESIGNED, np.array([r.mckee_number]), np.array([r.friction_coefficient]))
    title = Text("Friction of the {place} bearing over its duty (McKee; Stribeck)", place=called(place))
    bounds = ((Text("thick film up to"), 0.012), (Text("thick film from"), 0.002))
    yield Curve(f"stribeck_{place}", title, Text("ZN/P, cP·rpm/psi"), Text("f"), (line, point), bounds)


def _oils(r: PlainResult) -> Iterator[Curve]:
    """Kinematic viscosity over temperature: the design's oil and usual ones."""
    lubricant, known = r.seat.lubricant, oils()
    T = np.linspace(40.0, 150.0, 23)
    shown = {lubricant.oil.name: lubricant} | {name: Lubricant(known[name]) for name in OILS if name in known}
    series = tuple(
        Series(Name(name), T, np.log10([oil.at(float(t)).nu * 1e6 for t in T])) for name, oil in shown.items()
    )
    title = Text("Viscosity of the oil over its temperature")
    yield Curve("viscosity_of_oils", title, axis_label("temperature", "°C"), Text("lg ν, mm²/s"), series)


def _bench(r: PlainResult) -> Iterator[Curve]:
    """The oil supplied over the speed, of the engine's bench run."""
    if r.sweep.bench:
        rpm, speed = np.array(r.sweep.speeds) * 60, axis_label("speed", "rpm")
        line = Series(Text("bench run"), rpm, np.array(r.sweep.temperatures))
        title = Text("Oil supplied over the speed, by the bench run")
        yield Curve("oil_temperature_over_speed", title, speed, axis_label("T_in", "°C"), (line,))
        line = Series(Text("bench run"), rpm, np.array(r.sweep.pressures) / 1e5)
        title = Text("Pressure of the oil supplied, by the bench run")
        yield Curve("oil_pressure_over_speed", title, speed, axis_label("p_s", "bar"), (line,))
