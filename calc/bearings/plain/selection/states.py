# SPDX-License-Identifier: Apache-2.0
"""Candidates of one bearing in the states that govern, all at once; the rules on them, and the room on the shaft.

In order: words of the search, the rules, the room of a journal, the states.

Of the eight corners of the tolerances three can govern: the widest and the narrowest clearance, each with the thinner
oil, for the film; the narrowest with the thicker oil for the heat.  Beside them stand, as given, the oil that shear has
thinned and the overspeed.  What is offered is judged once more at all eight.  Where tolerances are only assumed, a
candidate may also be judged as it is given, as the limits of the step do."""

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import numpy as np

from ....countershaft.inputs import ShaftInputs
from ....countershaft.result import CountershaftResult
from ....countershaft.rows import BearingRow, called
from ....countershaft.sizing.stretches import gap_of
from ....library.journal_rules import named_at, specific_load
from ....library.lubricant import Lubricant
from ....library.oils import high_shear
from ....sheet.arrays import Array, IndexArray, Num
from ....sheet.check import DEGREES, THIN_MARGIN, Check, CheckRule
from ....sheet.errors import NoSolution
from ....sheet.linked_array import column
from ....sheet.record import record, replace
from ....sheet.search import Judged, judged
from ....sheet.text import EMPTY, Amount, Name, Small, Text
from ....sheet.units import UNITS, Kelvin, Metre, Number, Radian
from ...inputs import BearingsInputs
from .. import formulas as f
from ..checks import (
    CLEARANCE_COLD,
    CLEARANCE_COLD_CORNER,
    FILM_EDGE,
    FILM_EDGE_SHEARED,
    FILM_EDGE_SPLIT,
    FILM_OVERSPEED,
    FILM_PRESSURE,
    LENGTH_RATIO,
    SPECIFIC_LOAD,
    TEMPERATURE,
    on_bearing,
)
from ..corners import widths
from ..film import split_line
from ..film.reynolds import ECCENTRICITY_RANGE
from ..routes import supply
from ..routes.states import BearingCase, OperatingPoint, resized
from ..routes.thermal_balance import HOTTEST, settled
from ..row import RELIEF, RELIEF_LENGTH
from ..seats import formulas as seats
from ..solve import HTHS_TEMPERATURE
from ..suitability import MATERIAL_LOAD, film_asked

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
# The limits of the step's own checks, and what the film has to keep with thinner oil and at overspeed, written nowhere
# again.  Three are kept for choosing alone: 5 K between outlet and its limit, a twentieth of the clearance left when
# cold, nearer to which these count as narrow, and l/d.

OUTLET_RESERVE: Kelvin = 5.0  # rule of this program for choosing: nearer, the limit counts as narrow
RATIO: tuple[Number, Number] = (0.5, 0.8)  # l/d; rule of this program for choosing, as makers of shells have it
OWN = Text("rule of this program for choosing")
READ = (FILM_EDGE, TEMPERATURE, CLEARANCE_COLD, CLEARANCE_COLD_CORNER)
EDGES = (FILM_EDGE, FILM_EDGE_SHEARED, FILM_EDGE_SPLIT, FILM_OVERSPEED)  # films at the edge that keep the peaks apart
OF_SEATS = (FILM_PRESSURE, SPECIFIC_LOAD, MATERIAL_LOAD)  # asked where the step asks them: by what the seat is of

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


def passes_split(row: BearingRow, inputs: BearingsInputs) -> bool:
    """Whether the load turns past the split of shells."""
    return row.seat == "shells" and inputs.load_speed_ratio != inputs.bush_speed_ratio


def rules(
    place: str, checks: Iterable[Check], ratio: tuple[Number, Number], *, split: bool = False
) -> dict[CheckRule, BearingRule]:
    """The constraints of one bearing, by the declarations of their checks, from the checks of a solved design.
    `ratio`: l/d, least and most; `split`: whether the load passes one.

    Raises NoSolution where it carries next to nothing, so that nothing of its film is judged."""
    by_id = {c.id: c for c in checks}
    if any(rule.of(place) not in by_id for rule in READ):
        idle = Text("the {row} bearing carries next to nothing", row=called(place))
        raise NoSolution(idle, Text("its film is not judged"), Text("look at the masses of the shaft first"))
    asked = [*READ, *(rule for rule in OF_SEATS if rule.of(place) in by_id)]
    known = {rule: replace(by_id[rule.of(place)], missing=(), taken=(), at_best=None, at_worst=None) for rule in asked}
    outlet, film = known[TEMPERATURE].nearest[1], UNITS["µm"].inside(known[FILM_EDGE].nearest[1])
    known[TEMPERATURE] = replace(known[TEMPERATURE], limit=outlet - OUTLET_RESERVE)
    nought = math.nan  # what is judged are the candidates
    made = (
        on_bearing(FILM_EDGE_SHEARED, place, nought, film),
        *((on_bearing(FILM_EDGE_SPLIT, place, nought, film),) if split else ()),
        FILM_OVERSPEED(nought, film, at=place, name=named_at(Text("Film at the edge at overspeed"), place)),
        on_bearing(LENGTH_RATIO, place, nought, ratio, source=OWN),
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
    """`side` of the clearance (+1 widest, −1 narrowest), of the `oil`'s viscosity (+1 thicker, −1 thinner).  `beside`
    the corners of the tolerances: "sheared" or "faster"."""

    name: Text
    side: int = 0
    oil: int = 0
    beside: str = ""


WIDEST = Text("smallest journal, largest seat, thinner oil")
TIGHTEST = Text("largest journal, smallest seat, thinner oil")
TIGHT = Text("largest journal, smallest seat, thicker oil")
NOMINAL = Text("as given")
# the sheared one last: it is found from the film as given
BESIDE = (FilmState(Text("overspeed"), beside="faster"), FilmState(Text("oil thinned by shear"), beside="sheared"))
AT_CORNERS = (FilmState(NOMINAL), FilmState(WIDEST, 1, -1), FilmState(TIGHTEST, -1, -1), FilmState(TIGHT, -1, 1))
ROUGHNESSES = (0.6e-6, 0.4e-6, 0.3e-6, 0.2e-6)  # Ra; rule of this program
SAME = 1e-10  # m
BALANCED = 1e-5  # relative, of the rise: enough for a film to seven digits
HOT = 45.0  # K above the supply: what is hotter is not looked at where many are
ALWAYS_TIGHT: Metre = 1e-3  # an interference that no state uses up


@record
class BearingTask:
    """One bearing of the design, at one diameter: what it carries, what it has to keep, and what it is now.

    `length`, `clearance` and `diameter` are those of the design.  `faster`: at overspeed.  `field`: of its clearance,
    where the limits of its parts make it; None: the fits do.  `alike`: its parts are picked by classes, so that all
    that are have one size.  `corners` False: judged as given, only that the clearance is left when cold at the worst
    corner too.  `level`: by how many steps its surfaces are smoother than the design's."""

    place: str
    seat: BearingCase
    duty: OperatingPoint
    faster: OperatingPoint
    rules: dict[CheckRule, BearingRule]
    room: JournalRoom
    length: Metre
    clearance: Metre
    diameter: Metre
    field: Metre | None = None
    alike: bool = False
    corners: bool = True
    level: int = 0

    @property
    def states(self) -> tuple[FilmState, ...]:
        """The first is as given; those beside the corners stand last."""
        corners = AT_CORNERS if self.corners else AT_CORNERS[:1]
        return (*corners, *(state for state in BESIDE if state.beside == "faster" or self.shear is not None))

    @property
    def shear(self) -> Number | None:
        """The least share of its viscosity that the oil keeps at high shear; None: all of it."""
        hths = high_shear(self.seat.lubricant)
        if hths is None:
            return None
        least: float = f.full_shear_factor(hths=hths, mu_150=self.seat.lubricant.at(HTHS_TEMPERATURE).mu)
        return least

    @property
    def half(self) -> Metre:
        """Half the field of the clearance."""
        return (sum(widths(self.seat.inputs, self.size)) if self.field is None else self.field) / 2

    @property
    def size(self) -> Metre:
        """The diameter that is looked at."""
        return self.seat.bearing.diameter

    @property
    def own_size(self) -> bool:
        """Whether that is the design's."""
        return self.size == self.diameter

    def with_oil(self, oil: Lubricant, fed: str, fits: tuple[str, str] | None = None) -> "BearingTask":
        """The same with another oil, supply and fits of all bearings; what its row says itself stays."""
        seat = self.seat
        inputs = replace(seat.inputs, oil=oil.oil.name, supply=fed)
        if fits is not None:
            inputs = replace(inputs, journal_fit=fits[0], seat_fit=fits[1])
        return replace(self, seat=replace(seat, lubricant=oil, inputs=inputs.of(seat.bearing)))

    def under(self, load: Any) -> "BearingTask":
        """The same under another load at its speed, or loads of all candidates."""
        more = load / self.duty.load
        return replace(
            self, duty=replace(self.duty, load=load), faster=replace(self.faster, load=self.faster.load * more)
        )

    def at_diameter(self, d: Metre) -> "BearingTask":
        """The same journal at another diameter, under the same load; its room, and the design's size, are those of the
        one it was made for."""
        return replace(self, seat=at_size(self.seat, d))

    def smoother(self) -> Iterator["BearingTask"]:
        """The same with its own surfaces, then with ever smoother ones."""
        bearing = self.seat.bearing
        yield self
        for level, (Ra_1, Ra_2) in enumerate(smoother(bearing.journal_roughness, bearing.housing_roughness), 1):
            asked = UNITS["µm"].shown(film_asked(self.seat.inputs, Ra_1, Ra_2))
            films = {
                rule: BearingRule(replace(self.rules[rule].check, limit=asked)) for rule in EDGES if rule in self.rules
            }
            surfaces = replace(bearing, journal_roughness=Ra_1, housing_roughness=Ra_2)
            yield replace(self, seat=replace(self.seat, bearing=surfaces), rules={**self.rules, **films}, level=level)


def at_size(seat: BearingCase[Any], d: Any) -> BearingCase[Any]:
    """The case of a bearing of another diameter, a number or an array of them, with as much metal around it."""
    rings, larger = seat.rings, d - seat.bearing.diameter
    if rings is not None and rings.outside is not None:
        seat = replace(seat, rings=replace(rings, outside=rings.outside + larger))
    return resized(seat, diameter=d)


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
    clearance; `power`, `flow`, `pressure` and the clearance `hot` of the first state alone."""

    length: Array
    clearance: Array
    film: Array
    rise: Array
    viscosity: Array
    power: Array
    flow: Array
    pressure: Array
    hot: Array

    def among(self, part: slice) -> "States":
        """Some of the candidates, along the last axis."""
        return States(*(numbers[..., part] for numbers in vars(self).values()))


FILM_NUMBERS = ("film", "rise", "viscosity", "power", "flow", "pressure", "hot")


def solved(task: BearingTask, length: Lengths, clearance: Lengths, *, all_rises: bool = True) -> States:
    """Candidates in every state; `length` and `clearance` are broadcast against each other.  nan where there is no
    film.

    `all_rises` False: sooner, with nan as well where the rise is far beyond what may be chosen.
    """
    l, g = np.broadcast_arrays(np.asarray(length, dtype=float), np.asarray(clearance, dtype=float))
    return solved_at(task, task.size, l, g, task.half, all_rises=all_rises)


def solved_at(task: BearingTask, d: Num, l: Array, g: Array, half: Num, *, all_rises: bool = True) -> States:
    """Candidates of one bearing whose diameters differ too, and the halves of their fields; all of one shape."""
    axes = (slice(None), *(None,) * l.ndim)
    plain = [state for state in task.states if state.beside != "sheared"]
    side, oil = (column(plain, name)[axes] for name in ("side", "oil"))
    faster = np.array([state.beside == "faster" for state in plain])[axes]
    seat = resized(at_size(task.seat, np.asarray(d)[None]), length=l[None])
    there, over = vars(task.duty), vars(task.faster)
    duty: OperatingPoint[Any] = replace(
        task.duty,
        **{name: np.where(faster, over[name], there[name]) for name in there if over[name] is not there[name]},
    )
    asked: dict[str, Any] = {"hottest": HOTTEST if all_rises else HOT, "tolerance": BALANCED}
    with np.errstate(all="ignore"):
        corners = replace(
            seat,
            clearance=g[None] + side * np.asarray(half)[None],
            viscosity_factor=1 + oil * seat.inputs.viscosity_tolerance,
        )
        films = [settled(corners, duty, **asked)]
        if (kappa := task.shear) is not None:
            u = f.surface_speed(d=d, n=task.duty.effective_speed * task.duty.sliding_ratio)
            factor = f.shear_factor(kappa=kappa, gamma=f.shear_rate(u=u, h_0=films[0].film[:1]))
            films.append(settled(replace(seat, clearance=g[None], viscosity_factor=factor), task.duty, **asked))
    film, rise = (np.concatenate([getattr(part, name) for part in films]) for name in ("film", "temperature_rise"))
    viscosity = np.concatenate([np.broadcast_to(part.oil.mu, np.shape(part.film)) for part in films])
    first = films[0]
    pressure = first.largest_pressure
    assert pressure is not None
    of_first = first.friction_power, first.oil_flow, pressure, np.broadcast_to(first.clearance, first.film.shape)
    return States(l, g, film, rise, viscosity, *(numbers[0] for numbers in of_first))


def judge(task: BearingTask, states: States, slope: Radian) -> list[Judged]:
    """Every rule on candidates that are solved.  `slope`: of the journal in its seat."""
    seat: BearingCase[Any] = task.seat
    duty, rule = task.duty, task.rules
    inputs, d = seat.inputs, task.size
    l, g = states.length, states.clearance
    bare = supply.bare_length(inputs, states.length)
    once = sum(not state.beside for state in task.states)
    with np.errstate(all="ignore"):
        films, rise = states.film[:once], states.rise[:once]
        p = specific_load(F=duty.load, d=d, l=bare)
        cold, cold_corner = (
            replace(seat, clearance=left).clearance_at(inputs.lowest_temperature) for left in (g, g - task.half)
        )
        ratio = f.length_ratio(l=bare / 2 if supply.lands(inputs) == 2 else bare, d=d)
        outlet = f.outlet_temperature(T_in=duty.supply_temperature, Delta_T=rise.max(axis=0))
        judged = [
            rule[FILM_EDGE].on(f.film_at_edge(h_0=films.min(axis=0), theta=slope, l=l), where=_where(films, "min")),
            rule[TEMPERATURE].on(outlet, where=_where(rise, "max")),
            rule[LENGTH_RATIO].on(ratio),
            rule[CLEARANCE_COLD].on(cold),
            rule[CLEARANCE_COLD_CORNER].on(cold_corner, THIN_MARGIN * g, where=TIGHT),
        ]
        for n, state in enumerate(task.states[once:], once):
            film = FILM_OVERSPEED if state.beside == "faster" else FILM_EDGE_SHEARED
            judged.append(rule[film].on(f.film_at_edge(h_0=states.film[n], theta=slope, l=l), where=n))
        if FILM_EDGE_SPLIT in rule:
            judged.append(rule[FILM_EDGE_SPLIT].on(_film_at_split(task, states, ratio, slope)))
        judged += [rule[load].on(p) for load in (SPECIFIC_LOAD, MATERIAL_LOAD) if load in rule]
        return [*judged, rule[FILM_PRESSURE].on(states.pressure)] if FILM_PRESSURE in rule else judged


def _film_at_split(task: BearingTask, states: States, ratio: Array, slope: Radian) -> Array:
    """As given, once the split passes; nan where the relief lies outside what was marched."""
    row, h_0 = task.seat.bearing, states.film[0]
    t, a_r = (RELIEF if row.relief is None else row.relief), row.relief_length
    share = split_line.share_at(
        np.maximum(f.eccentricity_of_film(h_0=h_0, g=states.hot), ECCENTRICITY_RANGE[0]),
        ratio,
        seats.relief_depth(t=t, g=states.hot),
        seats.relief_arc(a_r=RELIEF_LENGTH if a_r is None else a_r, d=task.size),
        outside="nan",
    )
    edge = f.film_at_edge(h_0=h_0, theta=slope, l=states.length)
    film: Array = seats.film_at_split(h_edge=edge, h_0=h_0, s_t=share)
    return film


def without_rise(task: BearingTask) -> Judged:
    """The outlet temperature of oil that leaves as it enters."""
    return task.rules[TEMPERATURE].on(f.outlet_temperature(T_in=task.duty.supply_temperature, Delta_T=0.0))


def _where(numbers: Array, way: str) -> IndexArray:
    """The index of the governing state; one without film is the worst."""
    filled = np.where(np.isnan(numbers), -np.inf if way == "min" else np.inf, numbers)
    governing: IndexArray = filled.argmin(axis=0) if way == "min" else filled.argmax(axis=0)
    return governing
