# SPDX-License-Identifier: Apache-2.0
"""Bearings as supports of a shaft that turns with its load: what they carry where its journal is displaced.

They are laws as `countershaft.carried` asks for them, in the frame of the shaft."""

import math
from dataclasses import replace
from functools import cached_property

from ..countershaft.bending.carried import Hold
from ..sheet.functions import power
from ..sheet.record import record
from ..sheet.text import Amount, Text
from ..sheet.units import Metre, Newton, Number, PascalSecond, RevPerSecond
from .film.table import eccentricity_from, film_hold

CENTRED, FARTHEST = 0.02, 0.98  # ε: the ends of the film table
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

    def _held(self, eps: Number) -> Hold:
        S, load_slope, attitude, turning = film_hold(eps, self.l / self.d)
        F, radius, sense = self.scale / S, self.c / 2, self.sense
        return Hold(F, F * load_slope / radius, F / (eps * radius), sense * attitude, sense * turning / radius)

    def hold(self, e: Metre) -> Hold:
        eps = 2 * e / self.c
        if eps > CENTRED:
            return self._held(eps)
        k = self.centred.secant
        return Hold(k * e, k, k, self.centred.attitude)

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
