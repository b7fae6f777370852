# SPDX-License-Identifier: Apache-2.0
"""Candidates of one bearing in the states that govern, all at once; the rules on them, and the room on the shaft.

In order: words of the search, the rules, the room of a journal, the states.

Of the eight corners of the tolerances four can govern: the widest and the narrowest clearance, each with the thinner
oil, for the film; the narrowest with the thicker oil for the heat; and the film again at twice the load.  What is
offered is judged once more at all eight.  Where tolerances are only assumed, a candidate may also be judged as it is
given, as the limits of the step do."""

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from ...countershaft.inputs import ShaftInputs
from ...countershaft.result import CountershaftResult
from ...countershaft.rows import called
from ...countershaft.sizing.stretches import gap_of
from ...library import journal_rules
from ...library.journal_rules import RISE, heat_index, specific_load, speed_factor
from ...library.lubricant import Lubricant
from ...sheet.arrays import Array, IndexArray, Num
from ...sheet.check import DEGREES, Check, CheckRule
from ...sheet.errors import NoSolution
from ...sheet.linked_array import column
from ...sheet.record import record
from ...sheet.search import Judged, judged
from ...sheet.text import EMPTY, Amount, Name, Small, Text
from ...sheet.units import UNITS, Metre, Radian, RevPerSecond
from .. import formulas as f
from ..checks import (
    CLEARANCE_COLD,
    CLEARANCE_COLD_CORNER,
    FILM_DOUBLE_LOAD,
    FILM_EDGE,
    FILM_EDGE_TRUMPLER,
    HEAT_INDEX,
    LENGTH_RATIO,
    LENGTH_RATIO_USUAL,
    SPECIFIC_LOAD,
    TEMPERATURE,
    TEMPERATURE_RISE_USUAL,
    TRANSITION,
    named_at,
    on_bearing,
)
from ..corners import widths
from ..routes import supply
from ..routes.states import BearingCase, OperatingPoint, resized
from ..routes.thermal_balance import HOTTEST, settled
from ..suitability import CLEARANCE_USUAL, film_asked

# --- words that the search uses over and over


LETTERS = {"front": Text("F"), "middle": Text("M"), "rear": Text("R")}


def letter_of(place: str) -> Text:
    """What a bearing is called in the head of a column."""
    return LETTERS.get(place, EMPTY) or Name(place)


def mm(length: Metre) -> Amount:
    """A length to a hundredth of a millimetre."""
    return Amount(round(length * 1e3, 2), "mm")


def short_mm(length: Metre) -> Amount:
    """The same without its unit."""
    return Amount(round(length * 1e3, 2))


def value_of(check: Check, digits: int = 4) -> Text:
    if check.value != check.value:
        return Text("no film")
    return Text("{value}", value=Amount(check.value, check.unit, digits=digits))


def against(check: Check) -> Text:
    """`film at the edge, front: 8.2 µm, needs ≥ 9 µm`."""
    return Text(
        "{check}: {value}, needs {limit}", check=Small(check.name), value=value_of(check), limit=check.limit_text()
    )


def size(length: Metre, clearance: Metre) -> Text:
    return Text("{length} and {clearance}", length=Amount(length * 1e3, "mm"), clearance=Amount(clearance * 1e6, "µm"))


# --- what a bearing that is offered has to keep, at the worst corner of its tolerances
# The limits are those of the step's own checks, whatever their kind, and written nowhere again.  Three are kept for
# choosing alone: the rise of temperature, the cold clearance that must be left, and Trumpler's film at the edge too.
# The relative clearance that is usual is kept wherever film, heat and cold clearance leave something with it.

LEAST_COLD: Metre = 20e-6
OWN = Text("rule of this program for choosing")
RISES = Text("Finotti 2013, 5.5.2: 15 to 20 °C; for choosing the lower")
READ = (
    FILM_EDGE,
    FILM_DOUBLE_LOAD,
    TEMPERATURE,
    HEAT_INDEX,
    TRANSITION,
    CLEARANCE_COLD,
    CLEARANCE_COLD_CORNER,
    CLEARANCE_USUAL,
)

Index = int | tuple[np.intp, ...]  # of one of many candidates


@record
class BearingRule:
    """One constraint: the check that it is taken from, or made of."""

    check: Check

    @property
    def declared(self) -> CheckRule:
        return self.check.rule

    def on(self, value: Num, limit: Num | None = None, where: object = -1) -> Judged:
        """Candidates by this rule, from values in SI; `limit`, in SI as well, where it is that of each candidate.
        `where`: the index of the task's state that governs, or its name; −1: it has none."""
        units = UNITS[self.check.unit]
        bound = self.check.limit if limit is None else units.all_shown(np.asarray(limit))
        scale = DEGREES if self.check.unit == "°C" else None
        return judged(self, units.all_shown(np.asarray(value)), bound, self.check.sense, where, scale)


def check_of(judgement: Judged, index: Index) -> Check:
    """The check of one candidate."""
    shape, limit = judgement.margin.shape, judgement.limit
    if not isinstance(limit, tuple):
        limit = float(np.broadcast_to(limit, shape)[index])
    check: Check = judgement.rule.check
    return replace(check, value=float(np.broadcast_to(judgement.value, shape)[index]), limit=limit)


def rules(place: str, checks: Iterable[Check]) -> dict[CheckRule, BearingRule]:
    """The constraints of one bearing, by the declarations of their checks, from the checks of a solved design.

    Raises NoSolution where it carries next to nothing, so that nothing of its film is judged."""
    by_id = {c.id: c for c in checks}
    if any(rule.of(place) not in by_id for rule in READ):
        idle = Text("the {row} bearing carries next to nothing", row=called(place))
        raise NoSolution(idle, Text("its film is not judged"), Text("look at the masses of the shaft first"))
    known = {rule: by_id[rule.of(place)].but(missing=(), taken=(), at_best=None, at_worst=None) for rule in READ}
    known[CLEARANCE_COLD] = known[CLEARANCE_COLD].but(sense=">=", limit=UNITS["µm"].shown(LEAST_COLD), source=OWN)
    trumpler, nought = known[FILM_DOUBLE_LOAD].nearest[1], math.nan  # what is judged are the candidates
    made = (
        on_bearing(SPECIFIC_LOAD, place, nought, journal_rules.SPECIFIC_LOAD),
        on_bearing(LENGTH_RATIO, place, nought, journal_rules.LENGTH_RATIO),
        on_bearing(LENGTH_RATIO_USUAL, place, nought, journal_rules.USUAL_LENGTH_RATIO),
        on_bearing(FILM_EDGE_TRUMPLER, place, nought, UNITS["µm"].inside(trumpler)),
        TEMPERATURE_RISE_USUAL(
            nought,
            RISE[0],
            at=place,
            name=named_at(Text("Temperature rise"), place),
            source=RISES,
            advice=TEMPERATURE.advice,
        ),
    )
    return {check.rule: BearingRule(check) for check in (*known.values(), *made)}


# --- how long the journals may be beside the sectors, as far as the shaft is known
# A journal grows to both sides of its place.  Its room binds, whether the outline of the shaft is given, sized, or put
# together from the masses; what is longer is offered apart, since the sectors would have to give way.

SAME_JOURNAL = 1e-6  # m: a stretch of the shaft this much thinner than the journal is still the journal


@record
class JournalRoom:
    """The longest journal that fits; None: not known."""

    longest: Metre | None
    why: Text


def room(given: ShaftInputs | None, shaft: CountershaftResult | None, place: str, d: Metre) -> JournalRoom:
    """The room of a journal, of diameter d.

    The gear stands against the front journal and moves with it, unless its place is given.
    """
    if given is None:
        return JournalRoom(None, Text("no counter-shaft is given, so that the room for the journals is not known"))
    z = next(row.position for row in given.bearings if row.name == place)
    inner = given.bearings[0].position < z < given.bearings[-1].position
    if given.mode == "size" and inner:
        if given.gap is None:
            return JournalRoom(None, Text("the sectors leave an inner journal what it needs"))
        why = Text("the sectors leave {gap} there (gap_mm), with two fillets on either side", gap=mm(given.gap))
        return JournalRoom(given.gap - gap_of(l=0.0, r=given.fillet_radius or 0.0), why)
    if given.mode == "size" and given.half_length is not None:
        reach = Amount(given.half_length * 1e3, "mm", form="g")
        why = Text("the sectors reach to ±{half_length} (half_length_mm)", half_length=reach)
        return JournalRoom(2 * (abs(z) - given.half_length), why)
    if given.sections:
        return _of_sections(given, z, d)
    if shaft is None or shaft.outline is None:
        why = Text("the outline of the shaft is not known, and so neither is the room for the journals")
        return JournalRoom(None, why)
    journal = next((p for p in shaft.outline.pieces if p.what == "journal" and p.start <= z <= p.end), None)
    fixed = ("sector", "full", "journal") if given.gear_z is None else ("sector", "full", "journal", "gear")
    faces = [
        min(abs(z - p.start), abs(z - p.end)) for p in shaft.outline.pieces if p.what in fixed and p is not journal
    ]
    if not faces:
        return JournalRoom(None, Text("nothing stands beside the journal"))
    why = Text(
        "a sector drawn from its mass begins {distance} from the {place} one's middle",
        distance=Amount(min(faces) * 1e3, "mm"),
        place=called(place),
    )
    return JournalRoom(2 * min(faces), why)


def _of_sections(given: ShaftInputs, z: Metre, d: Metre) -> JournalRoom:
    """Along the given sections: the stretch about the journal's place that is a full cylinder and not thinner than the
    journal."""
    rows = sorted(given.sections, key=lambda section: section.from_)
    wide = [not row.half_angle and row.outer_radius >= d / 2 - SAME_JOURNAL for row in rows]
    here = next((i for i, row in enumerate(rows) if row.from_ <= z <= row.to), None)
    if here is None or not wide[here]:
        return JournalRoom(None, Text("the given sections have no cylinder of the journal's diameter at its place"))
    first = last = here
    while first > 0 and wide[first - 1]:
        first -= 1
    while last + 1 < len(rows) and wide[last + 1]:
        last += 1
    return JournalRoom(2 * min(z - rows[first].from_, rows[last].to - z), Text("the shaft's sections leave no more"))


# --- the candidates in every state

Lengths = float | Sequence[float] | Array


@record
class FilmState:
    """`side` of the clearance (+1 widest, −1 narrowest), of the `oil`'s viscosity (+1 thicker, −1 thinner), and times
    the load."""

    name: Text
    side: int = 0
    oil: int = 0
    times: float = 1.0


WIDEST = Text("smallest journal, largest seat, thinner oil")
TIGHTEST = Text("largest journal, smallest seat, thinner oil")
TIGHT = Text("largest journal, smallest seat, thicker oil")
NOMINAL = Text("as given")
AT_CORNERS = (
    FilmState(NOMINAL),
    FilmState(WIDEST, 1, -1),
    FilmState(TIGHTEST, -1, -1),
    FilmState(TIGHT, -1, 1),
    FilmState(WIDEST, 1, -1, 2.0),
    FilmState(TIGHTEST, -1, -1, 2.0),
)
AS_GIVEN = (FilmState(NOMINAL), FilmState(NOMINAL, times=2.0))
ROUGHNESSES = (0.6e-6, 0.4e-6, 0.3e-6, 0.2e-6)  # Ra; rule of this program
SAME = 1e-10  # m
BALANCED = 1e-5  # relative, of the rise: enough for a film to seven digits
HOT = 45.0  # K: three times the rise that may be chosen; what lies between is still needed to draw a curve through


@record
class BearingTask:
    """One bearing of the design, at one diameter: what it carries, what it has to keep, and what it is now.

    `length`, `clearance` and `diameter` are those of the design.  `speed_factor`: least speed over the speed of
    transition, which the surface speed alone decides.  `corners` False: judged as given, only that the clearance is
    left when cold at the worst corner too. `level`: by how many steps its surfaces are smoother than the design's."""

    place: str
    seat: BearingCase
    duty: OperatingPoint
    rules: dict[CheckRule, BearingRule]
    room: JournalRoom
    speed_factor: float
    length: Metre
    clearance: Metre
    diameter: Metre
    corners: bool = True
    level: int = 0

    @property
    def states(self) -> tuple[FilmState, ...]:
        """The first is as given; those at twice the load stand last."""
        return AT_CORNERS if self.corners else AS_GIVEN

    def with_oil(self, oil: Lubricant, fed: str, fits: tuple[str, str] | None = None) -> "BearingTask":
        """The same with another oil, supply and fits of all bearings; what its row says itself stays."""
        seat = self.seat
        inputs = replace(seat.inputs, oil=oil.oil.name, supply=fed)
        if fits is not None:
            inputs = replace(inputs, journal_fit=fits[0], seat_fit=fits[1])
        return replace(self, seat=replace(seat, lubricant=oil, inputs=inputs.of(seat.bearing)))

    def at_diameter(self, d: Metre) -> "BearingTask":
        """The same journal at another diameter, under the same load; its room is that of the one it was made for."""
        rules, asked = self.rules, UNITS["µm"].shown(f.trumpler_film(d=d))
        changed = {
            rule: BearingRule(rules[rule].check.but(limit=asked)) for rule in (FILM_DOUBLE_LOAD, FILM_EDGE_TRUMPLER)
        }
        seat = replace(self.seat, bearing=replace(self.seat.bearing, diameter=d))
        factor = speed_factor(f.surface_speed(d=d, n=self.sliding_speed))
        return replace(self, seat=seat, rules={**rules, **changed}, speed_factor=factor, diameter=d)

    @property
    def sliding_speed(self) -> RevPerSecond:
        """Of the journal on its seat."""
        duty, i_B = self.duty, self.seat.inputs.bush_speed_ratio
        return f.sliding_speed(n_J=duty.speed, n_B=i_B * duty.speed) if i_B else duty.speed

    def smoother(self) -> Iterator["BearingTask"]:
        """The same with its own surfaces, then with ever smoother ones."""
        bearing, film = self.seat.bearing, self.rules[FILM_EDGE].check
        yield self
        for level, (Ra_1, Ra_2) in enumerate(smoother(bearing.journal_roughness, bearing.housing_roughness), 1):
            asked = film_asked(self.seat.inputs, Ra_1, Ra_2)
            rule = BearingRule(film.but(limit=UNITS["µm"].shown(asked)))
            surfaces = replace(bearing, journal_roughness=Ra_1, housing_roughness=Ra_2)
            yield replace(
                self, seat=replace(self.seat, bearing=surfaces), rules={**self.rules, FILM_EDGE: rule}, level=level
            )


def smoother(Ra_1: Metre, Ra_2: Metre) -> Iterator[tuple[Metre, Metre]]:
    """Smoother surfaces of journal and seat, step by step: the journal first, which is ground, then the seat.  Rule of
    this program."""
    for step in ROUGHNESSES:
        if step < Ra_1 - SAME:
            Ra_1 = step
            yield Ra_1, Ra_2
        if step < Ra_2 - SAME:
            Ra_2 = step
            yield Ra_1, Ra_2


@record
class States:
    """Films of candidates, in SI: arrays whose first axis is that of the task's states, the others those of length and
    clearance; `power` and `flow` of the first state alone."""

    length: Array
    clearance: Array
    film: Array
    rise: Array
    viscosity: Array
    power: Array
    flow: Array

    def among(self, part: slice) -> "States":
        """Some of the candidates, along the last axis."""
        return States(*(numbers[..., part] for numbers in vars(self).values()))


def solved(task: BearingTask, length: Lengths, clearance: Lengths, *, all_rises: bool = True) -> States:
    """Candidates in every state; `length` and `clearance` are broadcast against each other.  nan where there is no
    film.

    `all_rises` False: sooner, with nan as well where the rise is far beyond what may be chosen.
    """
    l, g = np.broadcast_arrays(np.asarray(length, dtype=float), np.asarray(clearance, dtype=float))
    axes = (slice(None), *(None,) * l.ndim)
    side, oil, times = (column(task.states, name)[axes] for name in ("side", "oil", "times"))
    seat: BearingCase[Any] = task.seat
    duty: OperatingPoint[Any] = task.duty
    band = sum(widths(seat.inputs, seat.bearing.diameter)) / 2
    at = replace(
        resized(seat, length=l[None]),
        clearance=g[None] + side * band,
        viscosity_factor=1 + oil * seat.inputs.viscosity_tolerance,
    )
    loaded, hottest = replace(duty, load=duty.load * times), HOTTEST if all_rises else HOT
    with np.errstate(all="ignore"):
        film = settled(at, loaded, hottest=hottest, tolerance=BALANCED)
    viscosity = np.broadcast_to(film.oil.mu, np.shape(film.film))
    rise, power, flow = film.temperature_rise, film.friction_power[0], film.oil_flow[0]
    return States(l, g, film.film, rise, viscosity, power, flow)


def judge(task: BearingTask, states: States, slope: Radian) -> list[Judged]:
    """Every rule on candidates that are solved.  `slope`: of the journal in its seat."""
    seat: BearingCase[Any] = task.seat
    duty, rule = task.duty, task.rules
    inputs, d = seat.inputs, seat.bearing.diameter
    l, g = states.length, states.clearance
    bare = supply.bare_length(inputs, states.length)
    once = sum(state.times == 1 for state in task.states)
    with np.errstate(all="ignore"):
        films, doubled, rise = states.film[:once], states.film[once:], states.rise[:once]
        edge = f.film_at_edge(h_0=films.min(axis=0), theta=slope, l=l)
        p = specific_load(F=duty.load, d=d, l=bare)
        n_T = f.transition_speed(p=p, mu=states.viscosity[:once], d=d)
        least = f.least_speed(k=task.speed_factor, n_T=n_T.max(axis=0))
        cold = replace(seat, clearance=g - sum(widths(inputs, d)) / 2).clearance_at(inputs.lowest_temperature)
        left = cold if task.corners else replace(seat, clearance=g).clearance_at(inputs.lowest_temperature)
        ratio = f.length_ratio(l=bare / 2 if supply.lands(inputs) == 2 else bare, d=d)
        hottest, warmest = rise.max(axis=0), _where(rise, "max")
        outlet = f.outlet_temperature(T_in=duty.supply_temperature, Delta_T=hottest)
        judged = [
            rule[FILM_EDGE].on(edge, where=_where(films, "min")),
            rule[FILM_EDGE_TRUMPLER].on(edge, where=_where(films, "min")),
            rule[FILM_DOUBLE_LOAD].on(doubled.min(axis=0), where=_where(doubled, "min") + once),
            rule[TEMPERATURE_RISE_USUAL].on(hottest, where=warmest),
            rule[TEMPERATURE].on(outlet, where=warmest),
            rule[SPECIFIC_LOAD].on(p),
            rule[HEAT_INDEX].on(heat_index(F=duty.load, n=duty.speed, l=l)),
            rule[LENGTH_RATIO].on(ratio),
            rule[LENGTH_RATIO_USUAL].on(ratio),
            rule[TRANSITION].on(np.full(np.shape(least), duty.effective_speed), least, _where(n_T, "max")),
            rule[CLEARANCE_COLD].on(left, where=TIGHT if task.corners else -1),
        ]
        return judged if task.corners else [*judged, rule[CLEARANCE_COLD_CORNER].on(cold, where=TIGHT)]


def usual(task: BearingTask, clearance: Array) -> Judged:
    """The relative clearance against what is usual."""
    return task.rules[CLEARANCE_USUAL].on(f.relative_clearance(g=clearance, d=task.seat.bearing.diameter))


def without_rise(task: BearingTask) -> Judged:
    """The outlet temperature of oil that leaves as it enters."""
    return task.rules[TEMPERATURE].on(f.outlet_temperature(T_in=task.duty.supply_temperature, Delta_T=0.0))


def _where(numbers: Array, way: str) -> IndexArray:
    """The index of the governing state; one without film is the worst."""
    filled = np.where(np.isnan(numbers), -np.inf if way == "min" else np.inf, numbers)
    governing: IndexArray = filled.argmin(axis=0) if way == "min" else filled.argmax(axis=0)
    return governing


def mckee(task: BearingTask, states: States) -> Array:
    """ZN/P as given, in cP·rpm/psi: a mark, it binds nothing."""
    bare = supply.bare_length(task.seat.inputs, states.length)
    p = specific_load(F=task.duty.load, d=task.seat.bearing.diameter, l=bare)
    return f.mckee_number(mu=states.viscosity[0], n_h=task.duty.effective_speed, p=p)
