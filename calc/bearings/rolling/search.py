# SPDX-License-Identifier: Apache-2.0
"""Which rolling bearings would do in a place of a shaft: all sizes at once, and of each the fits that hold.

`candidates` judges every size by what does not hang on how it sits: life, static safety, speed, slope, loss.  `fitted`
then seeks, of one size, the least change of class, fits and how its outer ring is held, with which it neither jams nor
creeps.  The loads are those of the design as it is: another bearing changes the weight of the shaft's end a little,
which the whole design says once it is solved with it."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import fields
from itertools import product
from typing import Any, NamedTuple

import numpy as np

from ...countershaft.rows import BearingRow
from ...library.lubricant import Lubricant
from ...sheet.arrays import Array, BoolArray
from ...sheet.check import THIN_MARGIN, CheckRule
from ...sheet.record import record, replace
from ...sheet.text import Text
from ...sheet.units import Celsius, Kilogram, Metre, Newton, Number, Radian, Second, Watt
from ...sheet.value import untraced
from ..formulas import load_at_speed
from ..inputs import BearingsInputs
from ..row import LEAST_METAL
from ..support import Solids, StandingLoads, Task
from . import checks as c
from .balance import (
    heat_balance,
    heat_conductance,
    heat_surface,
    largest_speed_factor,
    limiting_speed,
    minimum_load,
    reference_speed,
)
from .clearance import CLASSES, Fits, Mounting, clearances, fits_of, metal_of_seat
from .geometry import alike, inner_raceway, inside_of, mass_of, mean_diameter, outer_raceway, stacked
from .life import life_of_duty, lives, reliability_factor
from .load import equivalent, friction_mean_of, races_of, radial_of, static_load, static_safety
from .raceway import largest_slope
from .ratings import computed
from .sizes import BearingSize, every_size, size_of
from .solve import rows_of
from .torque import friction_of
from .zone import EXPONENTS

SMALL: Metre = 1e-9
# In the order in which they are tried.  The load turns with the shaft: the outer ring has to be held tight, the inner
# one may sit loose.  Closer grades are tighter at their loose end without closing the bearing more.
SEATS = ("N6", "P6", "N5", "P7")
SHAFTS = {True: ("h6", "g6"), False: ("g5", "g6")}  # in an inner ring; as the raceway itself
HELD = "insert"
SEATED = Text(
    "The load turns with the shaft: it sweeps the outer ring, which has to be held, and stands on the inner one, which "
    "may sit loose. insert: a sleeve of steel cast into the light metal, which keeps the seat tight when hot."
)
GRIPPED = ("fit", HELD)  # a ring that nothing else holds


@record
class Place:
    """A bearing as it is sought: what it carries, what is around it, and what of its row stays.

    `bores`: least and largest diameter that it may take of the shaft.  `slope`: None where it is not known.
    `locates`: whether it takes the thrust of the shaft."""

    row: BearingRow
    inputs: BearingsInputs  # as they hold for it
    solids: Solids
    load: Newton
    stands: StandingLoads
    slope: Radian | None
    task: Task
    bores: tuple[Metre, Metre]
    locates: bool

    @property
    def lubricant(self) -> Lubricant:
        return self.solids.lubricant

    @property
    def axial(self) -> Newton:
        """What it would take along the shaft."""
        return self.stands.axial if self.locates else 0.0


@record
class Candidate:
    """One size in a place.  `temperature`: at the rated point; `loss`: over the duty.  `fails`: limits that it breaks,
    however it sits; `risks`: the cautions."""

    size: BearingSize[float]
    life: Second | None
    static_safety: Number
    loss: Watt
    temperature: Celsius
    mass: Kilogram
    fails: tuple[CheckRule, ...]
    risks: tuple[CheckRule, ...]

    @property
    def seat(self) -> Metre:
        return self.size.outside

    @property
    def area(self) -> float:
        """Of its outline, d·B: as that of a journal."""
        return self.size.bore * self.size.width


# --- all sizes


def sizes_for(place: Place) -> Iterator[BearingSize[float]]:
    """Those of the grid that may stand there, the design's own first: flanged rollers where the shaft is located, and
    what carries no thrust only where it is not."""
    own = place.row.outline if place.row.kind == "rolling" else None
    if own is not None and not own.own and (own.type == "ball" or own.flanged or not place.locates):
        yield own
    low, high = place.bores
    for size in every_size():
        if own is not None and size.designation == own.designation:
            continue
        fits = low - SMALL <= size.bore <= high + SMALL
        if fits and (size.type == "ball" or size.flanged == place.locates):
            yield size


def usual_sizes(place: Place) -> Iterator[BearingSize[float]]:
    """Balls and rollers alone, which need no hardened shaft and bear some slope."""
    return (size for size in sizes_for(place) if size.type in ("ball", "roller"))


def candidates(place: Place, sizes: Iterable[BearingSize[float]] | None = None) -> list[Candidate]:
    """Every size in that place, what passes first, then by its loss.  `sizes`: in place of those of the grid."""
    found: list[Candidate] = []
    with untraced(), np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        for group in alike(sizes_for(place) if sizes is None else sizes):
            found += _judged(place, group)
    return sorted(found, key=order)


def order(one: Candidate) -> tuple[bool, float, float]:
    loss = one.loss if one.loss == one.loss else float("inf")
    return bool(one.fails), loss, one.seat


def pareto(those: Sequence[Candidate]) -> list[Candidate]:
    """Of those that pass the ones that no other beats in loss, mass, seat and life at once."""

    def wanted(one: Candidate) -> tuple[float, ...]:
        return one.loss, one.mass, one.seat, -(one.life or float("inf"))

    passing = [one for one in those if not one.fails]
    return [
        one
        for one in passing
        if not any(
            wanted(other) != wanted(one) and all(a <= b for a, b in zip(wanted(other), wanted(one)))
            for other in passing
        )
    ]


def _judged(place: Place, group: Sequence[BearingSize[float]]) -> list[Candidate]:
    """Sizes of one type: a size a row, at the rated point and over the duty along it."""
    many, inputs, task = stacked(group), place.inputs, place.task
    series: Any = tuple((size.series,) for size in group)
    inside = inside_of(many, split_cage=place.row.split_cage if many.type == "cage" else False)
    assert inside is not None  # of no size of the grid
    ratings = computed(inside, many.usual.rating, None if many.inner_ring else place.row.raceway_hardness)
    d, D, B = many.bore, many.outside, many.width
    about: dict[str, Any] = dict(static_rating=ratings.static, base=place.lubricant.oil.base)
    friction = friction_of(many.type, series, d, D, B, lubrication=inputs.rolling_lubrication, **about)
    hA = heat_conductance(A=heat_surface(B=B, d=d, D=D))
    d_m = mean_diameter(d=d, D=D)
    at = _points(place)
    p = EXPONENTS[inside.elements].p
    P = radial_of(races_of(inside), at.F_1, at.F_2, p)
    if place.axial:
        P = equivalent(many, ratings, P, place.axial)
    heat = heat_balance(friction, friction_mean_of(at.F_1, at.F_2), at.n, at.T_oil, hA, place.lubricant.nu, "nan")
    a_1 = reliability_factor(R=inputs.reliability)
    every = lives(inside.elements, inside.pitch, ratings, P, at.n, heat.viscosity, inputs.cleanliness, a_1)
    life = life_of_duty(w=at.share, L_i=every.modified)
    P_0 = static_load(k_s=inputs.shock_factor, F_1=place.load, o=inputs.overspeed, F_2=place.stands.all)
    n_ref: Any = 0.0
    if many.type == "roller":
        n_ref = reference_speed(friction_of(many.type, series, d, D, B, lubrication="bath", **about), B)
    least = minimum_load(many.type, series, d_m, at.n, heat.viscosity, n_ref, ratings.dynamic)
    light = friction_mean_of(at.F_1, place.stands.weight + 0.0 * at.F_1) < least
    X = [largest_speed_factor(size.type, size.series) for size in group]
    fastest = limiting_speed(X=np.array(X)[:, None], d_m=d_m)
    slopes = np.array([[largest_slope(size.type, size.series)] for size in group])
    slope = 0.0 if place.slope is None else abs(place.slope)
    hottest = place.row.temperature_limit or max(c.CAGE_LIMIT.values())  # by the cage that is then chosen
    asked = c.life_asked(inputs, task.life)
    loaded, S_0 = bool(np.any(at.F_1 + at.F_2 > 0)), static_safety(C_0=ratings.static, P_0=P_0)
    shape = heat.loss.shape
    limits: dict[CheckRule, Any] = {
        c.LIFE: life >= asked if loaded else np.ones(len(group), dtype=bool),
        c.STATIC_SAFETY: S_0[:, 0] >= c.LEAST_SAFETY[many.type],
        c.SPEED_FACTOR: at.n.max() <= fastest[:, 0],
        c.SLOPE_MOST: slope <= slopes[:, 0],
    }
    if many.flanged and place.axial:
        limits[c.THRUST] = place.axial <= 0.5 * P[:, 0]
    often = at.share > c.RARE if at.share.sum() else np.ones_like(at.share, dtype=bool)
    cautions: dict[CheckRule, Any] = {
        c.MINIMUM_LOAD: ~np.any(np.broadcast_to(light, shape) & often, axis=1),
        c.RUNNING_TEMPERATURE: heat.temperature[:, 0] <= hottest,
        c.SLOPE_NEAR: slope <= slopes[:, 0] / 2,
    }
    loss, mass = np.sum(at.share * heat.loss, axis=1), mass_of(many)[:, 0]
    return [
        Candidate(
            size=size,
            life=float(life[i]) if loaded else None,
            static_safety=float(S_0[i, 0]),
            loss=float(loss[i]),
            temperature=float(heat.temperature[i, 0]),
            mass=float(mass[i]),
            fails=_broken(limits, i) if loss[i] == loss[i] else (*_broken(limits, i), c.TEMPERATURE_OUTSIDE),
            risks=_broken(cautions, i),
        )
        for i, size in enumerate(group)
    ]


class _Points(NamedTuple):
    """The rated point and behind it the duty; `share`: of the hours, of a rated point that is not in it 0."""

    n: Array
    F_1: Array
    F_2: Array
    T_oil: Array
    share: Array


def _points(place: Place) -> _Points:
    task, rows = place.task, rows_of(place.inputs, place.task)
    n, F, R_0, T = task.speed, place.load, place.stands.all, place.inputs.supply_temperature
    if rows is None:
        return _Points(*(np.array([x]) for x in (n, F, R_0, T, 1.0)))
    turning = rows.factor * load_at_speed(F=F, n=rows.n, n_0=n)
    columns = (rows.n, turning, R_0 + rows.extra, rows.T_oil, rows.share)
    return _Points(*(np.array([x, *column]) for x, column in zip((n, F, R_0, T, 0.0), columns)))


def _broken(judged: dict[CheckRule, BoolArray], i: int) -> tuple[CheckRule, ...]:
    return tuple(rule for rule, kept in judged.items() if not kept[i])


# --- how one sits


def as_rolling(place: Place, size: str) -> BearingRow:
    """The row of a place with a bearing of this size: what it says of plain ones is gone, and what is of a former size
    alone."""
    row, there = place.row, size_of(size)
    kept = set(_KEPT)
    if row.kind == "rolling":
        kept |= _KEPT_OF_ROLLING
        kept |= _RACEWAY if not there.inner_ring else set()
        kept |= {"split_cage"} if there.type == "cage" else set()
        kept |= {"axial_load"} if place.locates else set()
    said = {name: getattr(row, name) for name in kept}
    if row.housing_outer is not None and row.housing_outer <= there.outside + LEAST_METAL:
        del said["housing_outer"]
    return BearingRow(kind="rolling", size=there.designation, locates=place.locates, **said)


# what of a row stays with any bearing, with any rolling one, and with one that runs on the shaft itself
_KEPT = ("name", "position", "load", "offset", "slope", "carrier_bore", "carrier", "housing_outer", "housing_material")
_KEPT_OF_ROLLING = {"cage", "standing_load", "temperature_limit", "clearance_class", "outer_ring_held", "seat_fit"}
_RACEWAY = {"raceway_hardness", "raceway_roughness", "case_depth"}


class _Way(NamedTuple):
    """One way in which a bearing may sit."""

    clearance_class: str
    seat: str | None
    shaft: str | None
    held: str


def fitted(place: Place, row: BearingRow, T_b: Celsius) -> BearingRow | None:
    """The row of a rolling bearing with the least change of its class, its fits and how its outer ring is held with
    which clearances are left, as it runs at T_b and at the start, and the ring keeps its grip; None: there is none.
    Where some keep them with room to spare, of these.  Its cage is of steel where T_b asks for it.

    A ring that a pin, an adhesive or a clamp holds is not asked for its grip, nor one on which the load stands.  The
    inner ring, or the journal as a raceway, may sit looser where the load turns with the shaft."""
    size, inside = row.outline, row.inside
    if size is None or inside is None:
        return row
    turns = place.load >= place.stands.all
    raceways = dict(
        inner_raceway=inner_raceway(D_pw=inside.pitch, D_w=inside.diameter),
        outer_raceway=outer_raceway(D_pw=inside.pitch, D_w=inside.diameter),
    )
    for ways in _ways(row, size, turns):
        held = ways[0].held
        metal = metal_of_seat(place.solids.housing, held)
        with untraced():
            mounting: Mounting[Any] = Mounting(
                type=size.type,
                bore=size.bore,
                outside=size.outside,
                fits=_stacked([_fits(row, size, way) for way in ways]),
                housing_expansion=metal.expansion,
                housing_modulus=metal.E,
                housing_poisson=metal.poisson,
                restraint=place.inputs.expansion_restraint,
                housing_outer=row.housing_outer,
                journal_expansion=place.solids.journal.expansion,
                shaft_bore=place.solids.shaft_bore,
                **raceways,
            )
            gap = clearances(mounting, T_b, place.inputs.lowest_temperature, place.inputs.ring_temperature)
        holds, roomy = np.ones(len(ways), dtype=bool), np.ones(len(ways), dtype=bool)
        if gap.running is not None:
            least = np.minimum(gap.least, gap.start)
            holds &= least >= 0
            roomy &= least >= THIN_MARGIN * gap.scale
        if gap.grip_hot is not None and held in GRIPPED and turns:
            holds &= gap.grip_hot >= 0
            roomy &= gap.grip_hot >= THIN_MARGIN * gap.grip_scale
        if size.type == "cage":
            holds &= place.solids.housing.kind == "steel" or held == HELD
        if holds.any():
            way = ways[int(np.argmax(holds & roomy if (holds & roomy).any() else holds))]
            return replace(
                row,
                clearance_class=way.clearance_class,
                seat_fit=way.seat,
                shaft_fit=way.shaft,
                outer_ring_held=way.held,
                cage=_cage(row, T_b),
            )
    return None


def _cage(row: BearingRow, T_b: Celsius) -> str:
    """Of steel where polyamide gets too hot."""
    too_hot = row.temperature_limit is None and T_b > c.CAGE_LIMIT[row.cage]
    return "steel" if too_hot else row.cage


def _ways(row: BearingRow, size: BearingSize[float], turns: bool) -> Iterator[list[_Way]]:
    """Those that are tried, by how the ring is held, first as it is; each from the least change to the largest: of the
    class before the seat before the shaft."""
    classes = [row.clearance_class]
    if size.inner_ring and row.clearance_limits is None:
        classes += sorted(set(CLASSES) - {*classes}, key=lambda word: abs(_step(word) - _step(row.clearance_class)))
    seats = [row.seat_fit, *(SEATS if size.type != "cage" else ())]
    shafts = [row.shaft_fit, *(SHAFTS[size.inner_ring] if turns else ())]
    every = sorted(
        product(enumerate(shafts), enumerate(seats), classes),
        key=lambda way: way[0][0] + way[1][0] + abs(_step(way[2]) - _step(row.clearance_class)),
    )
    for held in dict.fromkeys((row.outer_ring_held, *((HELD,) if row.outer_ring_held == "fit" else ()))):
        yield [_Way(word, seat, shaft, held) for (_, shaft), (_, seat), word in every]


def _step(clearance_class: str) -> int:
    return CLASSES.index(clearance_class)


def _fits(row: BearingRow, size: BearingSize[float], way: _Way) -> Fits[float]:
    limits = row.clearance_limits
    return fits_of(
        size.type,
        size.bore,
        size.outside,
        inner_ring=size.inner_ring,
        shaft_fit=way.shaft,
        seat_fit=way.seat,
        clearance_class=way.clearance_class,
        clearance=None if limits is None else (limits[0], limits[1]),
    )


def _stacked(those: Sequence[Fits[float]]) -> Fits[Array]:
    """The same as arrays, a number a way."""

    def column(name: str) -> tuple[Array, Array] | None:
        spans = [getattr(one, name) for one in those]
        return None if None in spans else (np.array([a for a, _ in spans]), np.array([b for _, b in spans]))

    return Fits(**{one.name: column(one.name) for one in fields(Fits)})


# --- the best that sits


@record
class Seated:
    """A candidate, and its row as it sits."""

    candidate: Candidate
    row: BearingRow


def seated(place: Place, those: Iterable[Candidate], wanted: int) -> tuple[list[Seated], list[Candidate]]:
    """The first so many that pass and sit, in their order; and before the last of them those that would pass, and for
    which no fit does."""
    found, loose = list[Seated](), list[Candidate]()
    for one in those:
        if len(found) == wanted:
            break
        if one.fails:
            continue
        row = fitted(place, as_rolling(place, one.size.designation), one.temperature)
        if row is None:
            loose.append(one)
        else:
            found.append(Seated(one, row))
    return found, loose


# --- the nearest to a bearing that stands there

TRIED = 4  # other sizes


def nearest_rows(place: Place, T_b: Celsius) -> Iterator[BearingRow]:
    """The rolling bearing of a place as it may sit, then other sizes that pass as they sit, those of its type before
    the others and of each the nearest in its outline.  `T_b`: its temperature now."""
    row, own = place.row, place.row.outline
    if own is None:
        return
    if (sits := fitted(place, row, T_b)) is not None and sits != row:
        yield sits
    low, high = place.bores
    there = replace(place, locates=row.locates, bores=(min(low, own.bore), max(high, own.bore)))
    others = [one for one in candidates(there) if one.size.designation != own.designation]

    def apart(one: Candidate) -> tuple[bool, float]:
        pairs = ((one.size.bore, own.bore), (one.size.outside, own.outside), (one.size.width, own.width))
        return one.size.type != own.type, sum(abs(new / old - 1) for new, old in pairs)

    yield from (one.row for one in seated(there, sorted(others, key=apart), TRIED)[0])
