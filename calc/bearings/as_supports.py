# SPDX-License-Identifier: Apache-2.0
"""Bearings as supports of a shaft that turns with its load: what they carry where its journal is displaced, and how
the films of one shaft share its load.

The laws are those that `countershaft.carried` asks for, in the frame of the shaft."""

import math
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from ..countershaft.bending.carried import Carried, Hold, carried, carried_near
from ..countershaft.bending.condensed import Condensed
from ..countershaft.bending.formulas import cone, displaced, tilt_along, tilted
from ..countershaft.inputs import ShaftInputs
from ..countershaft.result import CountershaftResult
from ..countershaft.rows import ROW, SHAFT, BearingRow, called
from ..countershaft.supports import on_supports
from ..sheet.arrays import Array
from ..sheet.check import Check, CheckRule, Missing
from ..sheet.errors import NoSolution
from ..sheet.functions import argument, modulus, power
from ..sheet.linked_array import elements, gathered, item
from ..sheet.quantity import dotted
from ..sheet.record import record
from ..sheet.text import Amount, Text
from ..sheet.units import Metre, Newton, Number, PascalSecond, RevPerSecond
from ..sheet.value import about, based_on, untraced
from .inputs import BearingsInputs
from .plain import formulas as f
from .plain.checks import ASKED, CLEARANCE, CORE, FILM_EDGE, KREISLE, on_bearing
from .plain.corners import corner_points
from .plain.film.table import CENTRED, FilmRangeError, eccentricity_from, film_hold
from .plain.routes import supply
from .plain.routes.routes import own_warm
from .plain.routes.states import BearingCase, OperatingPoint
from .plain.routes.thermal_balance import balanced, settled, settled_together
from .plain.suitability import LENGTH
from .result import BearingResult, BearingsResult, OnShaftResult

FARTHEST = 0.98  # ε: the end of the film table
BEGUN = 0.9  # ε: no film is thinner where a solution is looked for first
FULL = 0.97  # ε: a film that is hardly able to carry more


@record
class Film:
    """An oil film under a load that turns with the journal: F = μ·n·d·l·(d/c)²/S(ε), ε = 2·e/c.

    d and l of the bearing, c its clearance (diametral), in m; c and μ, Pa·s, are those in which it runs; n the speed of
    the journal, 1/s; `sense`: +1 with the crank, −1 against it; `lands`: as many films of length l carry together.

    In the frame of the shaft the seat turns backwards, so that the journal lags its load by the attitude angle.  Below
    the smallest ε of the film table the film is a spring, with the angle that it has there: a journal that carries next
    to nothing runs centred.  Raises FilmRangeError where l/d, or ε, lies beyond the table."""

    d: Metre
    l: Metre
    c: Metre
    mu: PascalSecond
    n: RevPerSecond
    sense: int = 1
    lands: int = 1

    @cached_property
    def scale(self) -> Newton:
        """F·S."""
        return self.lands * self.mu * self.n * self.d * self.l * (self.d / self.c) ** 2

    @cached_property
    def centred(self) -> Hold:
        """At the smallest ε of the table; its load is the most that a centred journal carries."""
        return self._held(CENTRED)

    def _held(self, eps: Any) -> Hold[Any]:
        S, load_slope, attitude, turning = film_hold(eps, self.l / self.d)
        F, radius, sense = self.scale / S, self.c / 2, self.sense
        return Hold(F, F * load_slope / radius, F / (eps * radius), sense * attitude, sense * turning / radius)

    def hold(self, e: Metre) -> Hold:
        eps = 2 * e / self.c
        if eps > CENTRED:
            return self._held(eps)
        k = self.centred.secant
        return Hold(k * e, k, k, self.centred.attitude)

    def hold_many(self, e: Array) -> Hold[Array]:
        """The same of many journals at once, nan where the table ends."""
        held = self._held(np.maximum(2 * e / self.c, CENTRED))
        slope = np.where(2 * e / self.c > CENTRED, held.slope, held.secant)
        turning = np.where(slope == held.slope, held.turning, 0.0)
        return Hold(held.secant * e, slope, held.secant, held.attitude, turning)

    def begin(self, F: Newton) -> Metre:
        eps = eccentricity_from(self.scale / F, self.l / self.d, outside="nan")
        if eps <= BEGUN:
            return eps * self.c / 2
        return F / self.centred.secant if F < self.centred.force else BEGUN * self.c / 2

    def farthest(self, e: Metre) -> Metre:
        return min(FARTHEST * self.c / 2, (self.c / 2 + e) / 2)

    def softer(self, share: Number) -> "Film":
        return self

    def said(self, name: str, e: Metre) -> Text:
        c = Amount(self.c * 1e6, "µm")
        if 2 * e > FULL * self.c:
            return Text("bearing {name}, clearance {c}, would have to carry more than its film can", name=name, c=c)
        return Text("bearing {name}: clearance {c}", name=name, c=c)


@record
class Rolling:
    """A rolling bearing: F = K·(e − s/2)^n where the journal is farther from the middle than half its play s.

    K in N/m^n, s (`gap`, diametral) in m, not below 0."""

    K: float
    n: Number
    gap: Metre

    def hold(self, e: Metre) -> Hold:
        pressed = e - self.gap / 2
        if pressed <= 0.0:
            return Hold(0.0, 0.0, 0.0)
        F = self.K * power(pressed, self.n)
        return Hold(F, self.n * F / pressed, F / e)

    def begin(self, F: Newton) -> Metre:
        return self.gap / 2 + power(F / self.K, 1 / self.n)

    def farthest(self, e: Metre) -> Metre:
        return math.inf

    def softer(self, share: Number) -> "Rolling":
        return replace(self, K=share * self.K)

    def said(self, name: str, e: Metre) -> Text:
        return Text("bearing {name}: play {s}", name=name, s=Amount(self.gap * 1e6, "µm"))


# --- how the films of one shaft share what turns with it

NOTHING = 1e-9  # of the largest load: less is rounding
PASSES = 8
MEAN_FROM = 4  # from this pass on the loads are the mean of the last two
WARM = 1e-9  # of the rise of a film: far below what the loads may move
SETTLED = 1e-4  # of the largest load: by so little the loads may move in the last pass


@record
class Shared:
    """The films that share the load of a shaft, front to rear, and how it lies on them.

    `moved`: by how much the loads moved in the last pass, over the largest."""

    laws: tuple[Film, ...]
    carried: Carried
    moved: Number


def on_films(shaft: Condensed, films: Shared, seats: Sequence[BearingCase], duty: OperatingPoint[Any]) -> Shared:
    """The same films with what they share by lines of the calculation; what is rounding alone is nothing."""
    laws = [_found(*row, duty) for row in zip(films.laws, seats)]
    with about(Text("shaft on its films")):
        on = carried(shaft, laws, [seat.bearing.name for seat in seats], near=films.carried.x)
    carries = np.abs(on.load) > NOTHING * np.abs(on.load).max()
    load, x = (based_on(np.where(carries, z, 0.0), z) for z in (on.load, on.x))
    return replace(films, carried=replace(on, load=load, x=x))


def _found(law: Film, seat: BearingCase, duty: OperatingPoint[Any]) -> Film:
    """The same film with what its numbers were found from."""
    d, length, T = seat.bearing.diameter, seat.bearing.length, duty.supply_temperature
    c, mu = based_on(law.c, seat.clearance, d, T), based_on(law.mu, seat.lubricant.oil, T)
    return replace(law, d=d, l=based_on(law.l, length), c=c, mu=mu, n=based_on(law.n, duty.speed))


def film_law(seat: BearingCase, c: Metre, mu: PascalSecond, n: RevPerSecond, sense: int) -> Film:
    """The film of a bearing that runs with the clearance c and the viscosity μ."""
    lands = supply.lands(seat.inputs)
    length = supply.bare_length(seat.inputs, seat.bearing.length) / lands
    return Film(seat.bearing.diameter, length, c, mu, n, sense, lands)


def as_supplied(seat: BearingCase, duty: OperatingPoint, sense: int = 1) -> Film:
    """The film with the oil as it is supplied."""
    T = duty.supply_temperature
    return film_law(seat, seat.clearance_at(T), seat.oil_at(T).mu, duty.effective_speed, sense)


def runs_centred(seat: BearingCase, duty: OperatingPoint, supplied: Film | None = None) -> bool:
    """Whether the load is smaller than any of the film table, in the balance that the film then has.

    With the oil as it is `supplied` the table begins at a larger load, which is asked first."""
    if seat.grooves is not None:
        return False
    n = duty.effective_speed
    with untraced():
        try:
            if duty.load > (supplied or as_supplied(seat, duty)).centred.force:
                return False
            film = balanced(own_warm, replace(seat, centred=True), duty)
        except (FilmRangeError, NoSolution):
            return False
        return duty.load < film_law(seat, film.clearance, film.oil.mu, n, 1).centred.force


def shared(shaft: Condensed, seats: Sequence[BearingCase], duty: OperatingPoint[Any], sense: int) -> Shared:
    """Loads, the heat that they make in each film, the films that are so warm, and what they share: until the loads
    stay, eight passes at most.

    `duty`: speed and oil of all bearings; its load is not asked.  A film that finds no balance under its load keeps its
    last state, at first that of the oil as it is supplied."""
    names, n = [seat.bearing.name for seat in seats], duty.effective_speed

    def warm(seat: BearingCase, load: Newton, supplied: Film, before: Film) -> Film:
        asked = replace(duty, load=load)
        least = replace(seat, centred=True)
        try:
            film = balanced(own_warm, least if runs_centred(seat, asked, supplied) else seat, asked, tolerance=WARM)
        except NoSolution:
            balanced(own_warm, least, duty)  # says why, where it would not even run centred
            return before
        return film_law(seat, film.clearance, film.oil.mu, n, sense)

    with untraced():
        supplied = laws = [as_supplied(seat, duty, sense) for seat in seats]
        loads = np.abs(shaft.f_c)
        for n_pass in range(1, PASSES + 1):
            laws = [warm(*row) for row in zip(seats, loads.tolist(), supplied, laws)]
            on = carried(shaft, laws, names)
            now = np.abs(on.load)
            moved = float(np.abs(now - loads).max() / (now.max() or 1.0))
            if moved <= SETTLED:
                break
            loads = now if n_pass < MEAN_FROM else (now + loads) / 2
    return Shared(tuple(laws), on, moved)


def _alike(a: BearingCase, b: BearingCase) -> bool:
    """Whether two bearings are of one size, fed alike and in seats of one material."""
    return (
        (a.bearing.diameter, a.bearing.length) == (b.bearing.diameter, b.bearing.length)
        and a.inputs == b.inputs
        and a.housing_expansion == b.housing_expansion
    )


def at_corners(
    shaft: Condensed, films: Shared, seats: Sequence[BearingCase], duty: OperatingPoint[Any]
) -> dict[str, Array]:
    """By the bearing, its load at the corners of its own tolerances, the others at their middle, over its load there.

    Each corner's heat is that of the middle's load.  Where a corner has no film, the load stays.  What runs centred is
    left out."""
    loads = np.abs(np.asarray(films.carried.load))
    rows = [i for i, seat in enumerate(seats) if not seat.centred and loads[i] > 0]
    asked = [(corner_points(seats[i], duty)[0], replace(duty, load=loads[i])) for i in rows]
    with untraced():
        alike = bool(rows) and all(_alike(seats[i], seats[rows[0]]) for i in rows)
        warm = settled_together(asked) if alike else [settled(*question) for question in asked]
        their = np.repeat(rows, [film.film.size for film in warm])  # the bearing of each corner
        every = np.arange(their.size)
        d, l, c_m, mu_m, lands = np.array([(law.d, law.l, law.c, law.mu, law.lands) for law in films.laws]).T
        c, mu = (np.tile(x, (their.size, 1)) for x in (c_m, mu_m))
        for x, corners in ((c, [film.clearance for film in warm]), (mu, [film.oil.mu for film in warm])):
            there = np.concatenate(corners)
            x[every, their] = np.where(np.isfinite(there), there, x[every, their])
        law = replace(films.laws[0], d=d, l=l, c=c, mu=mu, lands=lands)  # type: ignore[arg-type]  # arrays, for `hold_many` alone
        P, found = carried_near(shaft, law.hold_many, films.carried.x * (c / c_m))
        share = np.abs(P)[every, their] / loads[their]
        for k in np.flatnonzero(~found).tolist():  # too far from the middle: with shorter steps
            i = their[k]
            alone = replace(films.laws[i], c=c[k, i].item(), mu=mu[k, i].item())
            share[k] = abs(carried(shaft, [*films.laws[:i], alone, *films.laws[i + 1 :]]).load[i]) / loads[i]
    return {seats[i].bearing.name: share[their == i] for i in rows}


# --- how the shaft lies in its films

JUDGED = 0.05  # of the largest load of rigid supports: below it a share says nothing


def on_shaft(
    found: BearingsResult, shaft: CountershaftResult, turning: Condensed | None, films: Shared | None, sense: int
) -> BearingsResult:
    """The same bearings with the place and the tilt of their journals, and what stands on more than two of them.

    `turning`: the shaft as its films know it, None where that is not known; `films`: those that share its load;
    `sense`: +1 with the crank, −1 against it."""
    if turning is not None:
        found = _lying(found, sense, turning, films)
    stiffness = np.inf if films is None else films.carried.stiffness
    positions = tuple(r.seat.bearing.position for r in found.bearings.values())
    stands = on_supports(shaft, positions, stiffness)
    if stands is None:
        return found
    zone = next(iter(found.bearings.values())).seat.inputs.coaxiality
    bearings = found.bearings
    if zone and films is not None:
        with about(Text("bores out of line")):
            loads = elements(stands.alignment(zone))
        bearings = {place: _out_of_line(place, r, R_c) for (place, r), R_c in zip(bearings.items(), loads)}
    return replace(found, stands=stands, bearings=bearings)


def turned_over(found: BearingsResult) -> BearingsResult:
    """The bearings of the mirror image of a shaft: as far off and as much aslant, in directions that are conjugate."""
    bearings = {}
    for place, r in found.bearings.items():
        if (lies := r.on_shaft) is not None:
            with about(Text("{place} bearing, in its film", place=called(place))):
                phases = lies.load_phase, lies.displacement_phase
                load, moved = (None if phi is None else f.mirrored_phase(phi=phi) for phi in phases)
            r = replace(r, on_shaft=replace(lies, load_phase=load, displacement_phase=moved))
        bearings[place] = r
    line = None if found.line is None else (found.line[0], found.line[1].conjugate())
    return replace(found, bearings=bearings, line=line)


def _lying(found: BearingsResult, sense: int, turning: Condensed, films: Shared | None) -> BearingsResult:
    """Two bearings: the loads of pins, the places by the bearings' own films; more: as they share."""
    rows = list(found.bearings.values())
    with about(Text("shaft in its films")):
        if films is None:
            ways = []
            for r in rows:
                e = f.displacement(eps=r.eccentricity, g=r.clearance_hot)
                ways.append(e * (r.load / r.duty.load) if r.seat.centred else e)
            P = turning.f_c
            x = displaced(P=P, e=gathered(ways), phi=sense * gathered(r.attitude_angle for r in rows))
        else:
            P, x = films.carried.load, films.carried.x
        theta = tilted(theta_0=turning.theta_0, Theta=turning.Theta, x=x)
        along = elements(tilt_along(theta=theta, x=x))
        half_angle = cone(x_f=item(x[0]), x_r=item(x[-1]), z_f=item(turning.z[0]), z_r=item(turning.z[-1]))
    pins = based_on(np.abs(turning.f_c), turning.f_c)
    bearings = {}
    for i, ((place, r), P_i, x_i, theta_i) in enumerate(zip(found.bearings.items(), *map(elements, (P, x, theta)))):
        with about(Text("{place} bearing, in its film", place=called(place))):
            share = None
            if films is not None and pins[i] >= JUDGED * pins.max():
                share = f.share(P=r.load, R=item(pins[i]))
            lies = OnShaftResult(
                load_phase=based_on(argument(P_i), P_i) if P_i else None,
                share=share,
                displacement=based_on(modulus(x_i), x_i),
                displacement_phase=based_on(argument(x_i), x_i) if x_i else None,
                tilt=based_on(modulus(theta_i), theta_i),
                tilt_along=along[i],
                film_edge_tilted=f.film_at_edge(h_0=r.film, theta=along[i], l=r.seat.bearing.length),
                standing_stiffness=None if films is None else item(films.carried.stiffness[i]),
            )
        bearings[place] = replace(r, on_shaft=lies)
    line = turning.nodes, turning.deflection(np.asarray(x))
    return replace(found, bearings=bearings, cone=half_angle, line=line)


def _out_of_line(place: str, r: BearingResult, R_c: Newton) -> BearingResult:
    """The same bearing with what its bores may add to its load; no film where none carries both."""
    assert r.on_shaft is not None
    film = None
    with about(Text("{place} bearing, bores out of line", place=called(place))):
        duty, seat = replace(r.duty, load=f.load_peak(F=r.load, R_0=R_c)), r.seat
    with untraced(), suppress(NoSolution):  # its check fails
        film = balanced(own_warm, replace(seat, centred=seat.centred and runs_centred(seat, duty)), duty).film
    return replace(r, on_shaft=replace(r.on_shaft, alignment_load=R_c, film_alignment=film))


# --- what is judged

AS_EDGE = Text("As for the film at the edge; or a stiffer core, which bends less, or less clearance, which tilts less.")
SHARES = (0.8, 1.25)  # of the load of rigid supports; rule of this program
TOO_SMALL = 0.05  # of the largest load of the shaft; rule of this program
SHARED_LOAD = Text("statics: K_c·x + P(x) = f_c, the films as supports of the shaft that bends")

SHARE = CheckRule(
    "bearings.B.share",
    "method",
    "Films and bending share the load otherwise than rigid supports: it stands on the clearances as they are.",
    Text("Load over that of rigid supports"),
    "in",
    source=Text("{statics}; range: rule of this program", statics=SHARED_LOAD),
    advice=Text("Clearances as they will be made, and the stiffness share of the sectors, decide what each carries."),
    value_id=dotted("bearings", "B", OnShaftResult.share),
    moved_by=(*CLEARANCE, CORE),
)
SHARE_SETTLED = CheckRule(
    "bearings.share_settled",
    "limit",
    "The loads and the heat that they make do not agree: what is said of the bearings is not theirs.",
    Text("Loads of the bearings in the last pass, moved by"),
    "<=",
    "%",
    Text("{statics}, with the heat of each film; rule of this program", statics=SHARED_LOAD),
    Text("Other clearances, or a bearing less."),
    role="self",
    exact=True,
    moved_by=(*CLEARANCE, CORE),
)
UNLOADED = CheckRule(
    "bearings.B.unloaded",
    "advice",
    "A bearing that carries next to nothing costs oil and friction; its film is not judged where the journal runs "
    "centred.",
    Text("Load of the bearing"),
    unit="N",
    source=Text("rule of this program: 5 % of the largest load of its shaft, and what a journal at ε = 0.02 carries"),
    advice=Text("Leave the bearing out, or place it where the shaft has load for it."),
    value_id=dotted("bearings", "B", BearingResult.load),
    moved_by=(dotted(ROW, BearingRow.position),),
)
FILM_EDGE_TILTED = CheckRule(
    "bearings.B.film_edge_tilted",
    "caution",
    "The shaft goes round in its clearances as a cone: the journal may stand more aslant than by its bending alone.",
    Text("Film at the edge, as the journal tilts in the films"),
    unit="µm",
    source=Text("{kreisle}; the tilt by the places of the journals in their films", kreisle=KREISLE),
    advice=AS_EDGE,
    cause=FILM_EDGE.id,
    value_id=dotted("bearings", "B", OnShaftResult.film_edge_tilted),
    limit_id=ASKED,
    moved_by=(*CLEARANCE, LENGTH, CORE),
)
ALIGNMENT = CheckRule(
    "bearings.B.alignment",
    "caution",
    "Bores that lie off the line of the others load the shaft's bearings, each as far as its tolerance lets it.",
    Text("Film at the edge under the load with that of the bores"),
    unit="µm",
    source=Text("{kreisle}; the load of the bores: statics, a bound", kreisle=KREISLE),
    advice=Text("A closer tolerance of the bores, or more clearance, which gives way."),
    cause=FILM_EDGE.id,
    limit_id=ASKED,
    moved_by=(dotted("bearings", BearingsInputs.coaxiality), *CLEARANCE, LENGTH),
)


def support_checks(found: BearingsResult, films: Shared | None, shaft: CountershaftResult | None) -> Iterator[Check]:
    """What is asked of bearings that carry one shaft together."""
    loads = {place: r.load for place, r in found.bearings.items()}
    seats = [r.seat for r in found.bearings.values()]
    out_of_line = any(seat.inputs.coaxiality or any(seat.bearing.offset or ()) for seat in seats)
    if films is not None:
        yield SHARE_SETTLED(films.moved, SETTLED)
    for place, r in found.bearings.items():
        least = r.duty.load if r.seat.centred else 0.0
        if len(loads) > 2:
            least = max(least, TOO_SMALL * max(loads.values()))
        if least:
            yield on_bearing(UNLOADED, place, r.load, least)
        lies = r.on_shaft
        if lies is None:
            if len(loads) > 2 and shaft is not None and shaft.bending is None:
                outline = Missing((dotted(SHAFT, ShaftInputs.sections),), (), "none", "none")
                yield on_bearing(SHARE, place, None, SHARES, missing=outline)
                if out_of_line:
                    yield on_bearing(ALIGNMENT, place, None, r.kreisle_film, missing=outline)
            continue
        if lies.share is not None:
            yield on_bearing(SHARE, place, lies.share, SHARES)
        if r.seat.bearing.slope is None and not r.seat.centred:
            yield on_bearing(FILM_EDGE_TILTED, place, lies.film_edge_tilted, r.kreisle_film)
        if lies.alignment_load is not None:
            edge = None
            if lies.film_alignment is not None:
                with untraced():
                    edge = f.film_at_edge_of_another(h_x=lies.film_alignment, h_0=r.film, h_edge=r.film_edge)
            yield on_bearing(ALIGNMENT, place, edge, r.kreisle_film)
