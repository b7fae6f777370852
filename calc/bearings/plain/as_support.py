# SPDX-License-Identifier: Apache-2.0
"""A plain bearing as a support of a shaft that turns with its load: what its film carries where its journal is
displaced.

The law is one that `countershaft.bending.carried` asks for, in the frame of the shaft."""

from collections.abc import Sequence
from functools import cached_property
from typing import Any

import numpy as np

from ...countershaft.bending.carried import AnyLaw, Hold, Law, Rigid, carried, carried_near
from ...countershaft.bending.condensed import Condensed
from ...sheet.arrays import Array
from ...sheet.errors import NoSolution
from ...sheet.record import record, replace
from ...sheet.text import Amount, Text
from ...sheet.units import Metre, Newton, Number, PascalSecond, RevPerSecond
from ...sheet.value import based_on, untraced
from ..support import Shared
from .corners import corner_points
from .film.table import CENTRED, FilmRangeError, eccentricity_from, film_hold
from .routes import supply
from .routes.routes import own_warm
from .routes.states import BearingCase, OperatingPoint
from .routes.thermal_balance import balanced, settled, settled_together

FARTHEST = 0.98  # ε: the end of the film table
BEGUN = 0.9  # ε: no film is thinner where a solution is looked for first
FULL = 0.97  # ε: a film that is hardly able to carry more


@record
class FilmLaw:
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

    def softer(self, share: Number) -> "FilmLaw":
        return self

    def said(self, name: str, e: Metre) -> Text:
        c = Amount(self.c * 1e6, "µm")
        if 2 * e > FULL * self.c:
            return Text("bearing {name}, clearance {c}, would have to carry more than its film can", name=name, c=c)
        return Text("bearing {name}: clearance {c}", name=name, c=c)


WARM = 1e-9  # of the rise of a film: far below what the loads may move


def told_law(law: FilmLaw, seat: BearingCase, duty: OperatingPoint[Any]) -> FilmLaw:
    """The same film with what its numbers were found from."""
    d, length, T = seat.bearing.diameter, seat.bearing.length, duty.supply_temperature
    c, mu = based_on(law.c, seat.clearance, d, T), based_on(law.mu, seat.lubricant.oil, T)
    return replace(law, d=d, l=based_on(law.l, length), c=c, mu=mu, n=based_on(law.n, duty.speed))


def film_law(seat: BearingCase, c: Metre, mu: PascalSecond, n: RevPerSecond, sense: int) -> FilmLaw:
    """The film of a bearing that runs with the clearance c and the viscosity μ."""
    lands = supply.lands(seat.inputs)
    length = supply.bare_length(seat.inputs, seat.bearing.length) / lands
    return FilmLaw(seat.bearing.diameter, length, c, mu, n, sense, lands)


def as_supplied(seat: BearingCase, duty: OperatingPoint, sense: int = 1) -> FilmLaw:
    """The film with the oil as it is supplied."""
    T = duty.supply_temperature
    return film_law(seat, seat.clearance_at(T), seat.oil_at(T).mu, duty.effective_speed, sense)


def runs_centred(seat: BearingCase, duty: OperatingPoint, supplied: FilmLaw | None = None) -> bool:
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


def warm_law(seat: BearingCase, duty: OperatingPoint[Any], supplied: FilmLaw, before: AnyLaw, sense: int) -> AnyLaw:
    """In the heat that it makes under the load of `duty`; where it finds no balance, the law `before`, at first that of
    the oil as it is supplied."""
    least = replace(seat, centred=True)
    try:
        film = balanced(own_warm, least if runs_centred(seat, duty, supplied) else seat, duty, tolerance=WARM)
    except NoSolution:
        balanced(own_warm, least, duty)  # says why, where it would not even run centred
        return before
    return film_law(seat, film.clearance, film.oil.mu, duty.effective_speed, sense)


def _alike(a: BearingCase, b: BearingCase) -> bool:
    """Whether two bearings are of one size, fed alike and in seats of one material."""
    return (
        (a.bearing.diameter, a.bearing.length) == (b.bearing.diameter, b.bearing.length)
        and a.inputs == b.inputs
        and a.housing_expansion == b.housing_expansion
    )


def at_corners(
    shaft: Condensed, films: Shared, seats: Sequence[BearingCase | None], duty: OperatingPoint[Any]
) -> dict[str, Array]:
    """By the bearing, its load at the corners of its own tolerances, the others at their middle, over its load there;
    None: one of another kind, which keeps its law.

    Each corner's heat is that of the middle's load.  Where a corner has no film, the load stays.  What runs centred is
    left out."""
    loads = np.abs(np.asarray(films.carried.load))
    known = {i: seat for i, seat in enumerate(seats) if seat is not None and not seat.centred and loads[i] > 0}
    rows, columns = [*known], [i for i, seat in enumerate(seats) if seat is not None]
    if not rows:
        return {}
    laws = {i: law for i, law in enumerate(films.laws) if isinstance(law, FilmLaw)}
    others: dict[int, Law] = {}
    for i, other in enumerate(films.laws):
        if isinstance(other, Rigid):
            return {}  # it holds its place, whatever the others do
        if i not in laws:
            others[i] = other
    asked = [(corner_points(known[i], duty)[0], replace(duty, load=loads[i])) for i in rows]
    with untraced():
        alike = all(_alike(known[i], known[rows[0]]) for i in rows)
        warm = settled_together(asked) if alike else [settled(*question) for question in asked]
        their = np.repeat(rows, [film.film.size for film in warm])  # the bearing of each corner
        every = np.arange(their.size)
        d, l, c_m, mu_m, lands = np.array([(law.d, law.l, law.c, law.mu, law.lands) for law in laws.values()]).T
        c, mu = (np.tile(x, (their.size, 1)) for x in (c_m, mu_m))
        column = np.searchsorted(columns, their)
        for x, corners in ((c, [film.clearance for film in warm]), (mu, [film.oil.mu for film in warm])):
            there = np.concatenate(corners)
            x[every, column] = np.where(np.isfinite(there), there, x[every, column])
        law = replace(laws[columns[0]], d=d, l=l, c=c, mu=mu, lands=lands)  # type: ignore[arg-type]  # arrays, for `hold_many` alone

        def hold(e: Array) -> Hold[Array]:
            if not others:
                return law.hold_many(e)
            held = [np.empty(e.shape) for _ in range(5)]
            for x, found in zip(held, law.hold_many(e[:, columns])):
                x[:, columns] = found
            for i, other in others.items():
                for x, found in zip(held, other.hold_many(e[:, i])):
                    x[:, i] = found
            return Hold(*held)

        begun = np.tile(films.carried.x, (their.size, 1))
        begun[:, columns] = films.carried.x[columns] * (c / c_m)
        P, found = carried_near(shaft, hold, begun)
        share = np.abs(P)[every, their] / loads[their]
        for k in np.flatnonzero(~found).tolist():  # too far from the middle: with shorter steps
            i, at = their[k], column[k]
            alone = replace(laws[i], c=c[k, at].item(), mu=mu[k, at].item())
            share[k] = abs(carried(shaft, [*films.laws[:i], alone, *films.laws[i + 1 :]]).load[i]) / loads[i]
    return {known[i].bearing.name: share[their == i] for i in rows}
