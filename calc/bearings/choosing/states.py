# SPDX-License-Identifier: Apache-2.0
"""Candidates of one bearing in the states that govern, all at once, and the rules on them.

Of the eight corners of the tolerances four can govern: the widest and the narrowest clearance, each with the thinner oil, for the film;
the narrowest with the thicker oil for the heat; and the film again at twice the load.  What is offered is judged once more at all eight.
Where tolerances are only assumed, a candidate may also be judged as it is given, as the limits of the step do.
"""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from ...lubricant import Lubricant
from ...sheet.record import record
from ...sheet.units import UNITS, Metre, Radian
from .. import formulas as f
from ..corners import widths
from ..routes import supply
from ..routes.balance import HOTTEST, settled
from ..routes.states import Duty, Seat
from .room import Room
from .rules import Judged, Rule, judged

# name, clearance (+1 widest, −1 narrowest), oil (+1 thicker, −1 thinner), times the load
STATES = (
    ("as given", 0, 0, 1.0),
    ("smallest journal, largest seat, thinner oil", 1, -1, 1.0),
    ("largest journal, smallest seat, thinner oil", -1, -1, 1.0),
    ("largest journal, smallest seat, thicker oil", -1, 1, 1.0),
    ("smallest journal, largest seat, thinner oil", 1, -1, 2.0),
    ("largest journal, smallest seat, thinner oil", -1, -1, 2.0),
    ("as given", 0, 0, 2.0),
)  # fmt: skip
AS_GIVEN, ONCE, TWICE = 0, slice(0, 4), slice(4, 6)
AS_GIVEN_TWICE = 6
NARROWEST = 3
ROUGHNESSES = (0.6e-6, 0.4e-6, 0.3e-6, 0.2e-6)  # Ra; rule of this program
SAME = 1e-10  # m
BALANCED = 1e-5  # relative, of the rise: enough for a film to seven digits
HOT = 45.0  # K: three times the rise that may be chosen; what lies between is still needed to draw a curve through


@record
class Task:
    """One bearing of the design, at one diameter: what it carries, what it has to keep, and what it is now.

    `length`, `clearance` and `diameter` are those of the design.  `speed_factor`: least speed over the speed of transition, which the
    surface speed alone decides.  `corners` False: judged as given, only that the clearance is left when cold at the worst corner too.
    `level`: by how many steps its surfaces are smoother than the design's.
    """

    place: str
    seat: Seat
    duty: Duty
    rules: dict[str, Rule]
    room: Room
    speed_factor: float
    length: Metre
    clearance: Metre
    diameter: Metre
    corners: bool = True
    level: int = 0

    def with_oil(self, oil: Lubricant, fed: str, fits: tuple[str, str] | None = None) -> "Task":
        seat = self.seat
        inputs = replace(seat.inputs, oil=oil.oil.name, supply=fed)
        if fits is not None:
            inputs = replace(inputs, journal_fit=fits[0], seat_fit=fits[1])
        return replace(self, seat=replace(seat, lubricant=oil, inputs=inputs))

    def smoother(self) -> Iterator["Task"]:
        """The same with its own surfaces, then with ever smoother ones."""
        bearing, film = self.seat.bearing, self.rules["film_edge"]
        yield self
        for level, (Ra_1, Ra_2) in enumerate(smoother(bearing.journal_roughness, bearing.housing_roughness), 1):
            asked = f.kreisle_film(k_R=self.seat.inputs.roughness_ratio, Ra_1=Ra_1, Ra_2=Ra_2)
            rule = replace(film, check=replace(film.check, limit=UNITS["µm"].shown(asked)))
            surfaces = replace(bearing, journal_roughness=Ra_1, housing_roughness=Ra_2)
            yield replace(self, seat=replace(self.seat, bearing=surfaces), rules={**self.rules, "film_edge": rule}, level=level)


def smoother(Ra_1: Metre, Ra_2: Metre) -> Iterator[tuple[Metre, Metre]]:
    """Smoother surfaces of journal and seat, step by step: the journal first, which is ground, then the seat.  Rule of this program."""
    for step in ROUGHNESSES:
        if step < Ra_1 - SAME:
            Ra_1 = step
            yield Ra_1, Ra_2
        if step < Ra_2 - SAME:
            Ra_2 = step
            yield Ra_1, Ra_2


@record
class States:
    """Films of candidates: the first axis is that of STATES, the others those of length and clearance."""

    length: Any
    clearance: Any
    film: Any
    rise: Any
    viscosity: Any
    power: Any  # as given
    flow: Any  # as given


def solved(task: Task, length: Any, clearance: Any, *, all_rises: bool = True) -> States:
    """Candidates in every state; `length` and `clearance` are broadcast against each other.  nan where there is no film.

    `all_rises` False: sooner, with nan as well where the rise is far beyond what may be chosen.
    """
    l, g = np.broadcast_arrays(np.asarray(length, dtype=float), np.asarray(clearance, dtype=float))
    axes = (slice(None), *(None,) * l.ndim)
    side, oil, times = (np.array([row[n] for row in STATES], dtype=float)[axes] for n in (1, 2, 3))
    seat, duty = task.seat, task.duty
    band: Any = sum(widths(seat.inputs, seat.bearing.diameter)) / 2
    lengths: Any = l[None]
    clearances: Any = g[None] + side * band
    factor: Any = 1 + oil * seat.inputs.viscosity_tolerance
    load: Any = duty.load * times
    at = replace(seat, bearing=replace(seat.bearing, length=lengths), clearance=clearances, viscosity_factor=factor)
    with np.errstate(all="ignore"):
        film = settled(at, replace(duty, load=load), hottest=HOTTEST if all_rises else HOT, tolerance=BALANCED)
    power: Any = film.friction_power
    flow: Any = film.oil_flow
    return States(
        l, g, film.film, film.temperature_rise, np.broadcast_to(film.oil.mu, np.shape(film.film)), power[AS_GIVEN], flow[AS_GIVEN]
    )


def judge(task: Task, states: States, slope: Radian) -> list[Judged]:
    """Every rule on candidates that are solved.  `slope`: of the journal in its seat."""
    seat, duty, rule = task.seat, task.duty, task.rules
    inputs, d = seat.inputs, seat.bearing.diameter
    l, g = states.length, states.clearance
    lands = supply.lands(inputs)
    bare: Any = l if lands == 1 else l - (inputs.groove_width or 0.0)
    with np.errstate(all="ignore"):
        once, twice, rise, viscosity, second = states.film[ONCE], states.film[TWICE], states.rise[ONCE], states.viscosity[ONCE], TWICE.start
        if not task.corners:
            once, rise, viscosity = states.film[:1], states.rise[:1], states.viscosity[:1]
            twice, second = states.film[AS_GIVEN_TWICE:], AS_GIVEN_TWICE
        thinnest: Any = once.min(axis=0)
        edge = f.film_at_edge(h_0=thinnest, theta=slope, l=l)
        p = f.specific_load(F=duty.load, d=d, l=bare)
        n_T: Any = f.transition_speed(p=p, mu=viscosity, d=d)
        least: Any = f.least_speed(k=task.speed_factor, n_T=n_T.max(axis=0))
        cold = replace(seat, clearance=g - sum(widths(inputs, d)) / 2).clearance_at(inputs.lowest_temperature)
        left = cold if task.corners else replace(seat, clearance=g).clearance_at(inputs.lowest_temperature)
        ratio = f.length_ratio(l=bare / 2 if lands == 2 else bare, d=d)
        hottest: Any = rise.max(axis=0)
        found = [
            judged(rule["film_edge"], edge, state=_where(once, "min")),
            judged(rule["film_edge_trumpler"], edge, state=_where(once, "min")),
            judged(rule["film_double_load"], twice.min(axis=0), state=_where(twice, "min") + second),
            judged(rule["temperature_rise"], hottest, state=_where(rise, "max")),
            judged(rule["temperature"], f.outlet_temperature(T_in=duty.supply_temperature, Delta_T=hottest), state=_where(rise, "max")),
            judged(rule["specific_load"], p),
            judged(rule["heat_index"], f.heat_index(F=duty.load, n=duty.speed, l=l)),
            judged(rule["length_ratio"], ratio),
            judged(rule["length_ratio_usual"], ratio),
            judged(rule["transition"], np.full(least.shape, duty.effective_speed), least, _where(n_T, "max")),
            judged(rule["clearance_cold"], left, state=NARROWEST if task.corners else AS_GIVEN),
        ]
        if not task.corners:
            found.append(judged(rule["clearance_cold_corner"], cold, state=NARROWEST))
    return found


def _where(numbers: Any, way: str) -> Any:
    """The index of the governing state; one without film is the worst."""
    filled = np.where(np.isnan(numbers), -np.inf if way == "min" else np.inf, numbers)
    return filled.argmin(axis=0) if way == "min" else filled.argmax(axis=0)


def mckee(task: Task, states: States) -> Any:
    """ZN/P as given, in cP·rpm/psi: a mark, it binds nothing."""
    inputs = task.seat.inputs
    bare: Any = states.length if supply.lands(inputs) == 1 else states.length - (inputs.groove_width or 0.0)
    p = f.specific_load(F=task.duty.load, d=task.seat.bearing.diameter, l=bare)
    return f.mckee_number(mu=states.viscosity[AS_GIVEN], n_h=task.duty.effective_speed, p=p)


def margins(found: list[Judged]) -> Any:
    """The least margin of every candidate over all rules."""
    return np.min([one.margin for one in found], axis=0)
