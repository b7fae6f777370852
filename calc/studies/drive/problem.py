# SPDX-License-Identifier: Apache-2.0
"""The problem of a search for whole drives: the values of every variable, what must hold and what is wanted.

Values are those of [optimise.vary] or by rule; what is wrong with those that are given is said."""

import math
from collections.abc import Iterable, Mapping, Sequence
from fnmatch import fnmatchcase
from itertools import product
from typing import Any

from ...bearings.inputs import BearingsInputs
from ...bearings.plain.checks import (
    CLEARANCE_COLD_CORNER,
    FILM_DOUBLE_LOAD,
    FILM_EDGE_CORNER,
    FILM_EDGE_SPEEDS,
    FILM_EDGE_STANDING,
    FILM_TRUMPLER,
    LENGTH_RATIO_USUAL,
    SUPPLY_RANGE,
    TEMPERATURE_CORNER,
)
from ...bearings.plain.selection.variants import SUPPLIES, placed
from ...bearings.result import BearingsResult
from ...countershaft.checks import FILLET_ROOM, GEAR_SEAT, JOURNAL_SLOPE, RIGID
from ...countershaft.inputs import THREADED, ShaftInputs
from ...countershaft.making.inputs import ShaftSupport
from ...countershaft.making.parts import SUPPORT_WALL
from ...countershaft.making.scatter import SCATTER_RESIDUAL
from ...countershaft.making.unbalance import HOLES_RANGE
from ...countershaft.rows import BearingRow, called
from ...design.addresses import address, every, quantity_of, step_at, value_at
from ...design.locks import locked
from ...design.model import Design
from ...design.other_tables import OBJECTIVES, OptimiseInputs
from ...design.toml_file import Document, design
from ...design.upgrade import MANY, SLOPES, current, own_key
from ...gears.backlash.checks import BACKLASH_CHANCE
from ...gears.checks import CONTACT_RATIO_USUAL
from ...gears.measures.solve import SPAN_WIDTH
from ...gears.rating.checks import SAFETY_BENDING_USUAL, SAFETY_CONTACT_USUAL
from ...library.tolerances import GRADES, tolerance
from ...library.tolerances import problem as fit_problem
from ...sheet.check import Check
from ...sheet.errors import BadInput, InputError, NoSolution
from ...sheet.quantity import dotted
from ...sheet.record import record, replace
from ...sheet.remedy import Changes
from ...sheet.search import multiples
from ...sheet.text import COMMA, EMPTY, Name, Text
from ...sheet.units import Metre
from ...solve import Results, solve

CORE_SHARE = (0.25, 0.55)  # of the outer radius, and a tenth of it about the design's own; rule of this program
SEAT_REACH = 6.0  # mm beyond the design's; rule of this program
LEAST_SEAT = 0.75  # of the design's; rule of this program
STEP = 0.5  # mm
ROOM = 0.1  # mm about the gear's tip in its seat
WIDER = (1.1, 1.2, 1.3, 1.4)  # times its outer radius, of a shaft that passes no seat; rule of this program
LEAST_SHARE = 0.6  # of the design's smaller journal, where no gear goes through its seat; rule of this program
MOST_CLASSES = 500
MOST_VALUES = 1000  # of one range


OIL, SUPPLY_KEY = dotted(Design.bearings, BearingsInputs.oil), dotted(Design.bearings, BearingsInputs.supply)
BOTH_FITS = (dotted(Design.bearings, BearingsInputs.journal_fit), dotted(Design.bearings, BearingsInputs.seat_fit))
FITS, SURFACES = (
    dotted(Design.bearings, "fits"),
    dotted(Design.bearings, "surfaces"),
)  # several keys that are chosen as one: words of the search
IN_STEPS = Text("is chosen in steps of 5 µm between what is left cold and the usual factor")
WIDTHS = Text(
    'must be pairs of widths, journal and seat: ["IT6", "IT7"]; the clearance is searched for, and a fit with a place '
    "makes it"
)


def across(row: BearingRow) -> Metre:
    """What a bearing takes of the shaft."""
    size = row.on_shaft
    assert size is not None  # asked of the file
    return size[0]


def along(row: BearingRow) -> Metre:
    """Its width."""
    size = row.on_shaft
    assert size is not None
    return size[1]


def passed(row: BearingRow) -> Metre:
    """The diameter of what the sectors pass, of its seat; of one in a flange that comes later that of the journal."""
    opening = row.opening()
    return opening if math.isfinite(opening) else across(row)


@record
class DriveKeys:
    """What a design calls the sizes of its drive: keys of its own shaft and of that shaft's two bearings."""

    design: Design

    @property
    def places(self) -> tuple[str, str]:
        """The names of the bearings, front to rear."""
        return self.design.rows[0].name, self.design.rows[-1].name

    @property
    def on_films(self) -> tuple[str, ...]:
        """Those of them that are searched: what rolls stays as it is."""
        return tuple(row.name for row in (self.design.rows[0], self.design.rows[-1]) if row.fed())

    def of_bearing(self, place: str, field: object) -> str:
        return self.design.own_key(ShaftInputs.bearings, place, field)

    @property
    def core(self) -> str:
        return self.design.own_key(ShaftInputs.core_radius)

    @property
    def outer(self) -> str:
        return self.design.own_key(ShaftInputs.outer_radius)

    @property
    def material(self) -> str:
        return self.design.own_key(ShaftInputs.material)

    @property
    def sizes(self) -> tuple[str, ...]:
        both = (BearingRow.diameter, BearingRow.length)
        return (self.core, *(self.of_bearing(place, size) for place in self.on_films for size in both))

    @property
    def tied(self) -> dict[str, Text]:
        """What follows from other sizes, and how."""
        largest = Text("follows from the largest journal, less the clearance for threading in")
        return {
            **({self.outer: largest} if self.design.own is not None and self.design.own.passes_seats else {}),
            self.design.own_key(ShaftInputs.half_length): Text("follows from the longer journal, less two fillets"),
            **{self.of_bearing(place, BearingRow.clearance): IN_STEPS for place in self.on_films},
        }

    @property
    def slopes(self) -> tuple[str, ...]:
        return (SLOPES, *(self.of_bearing(place, BearingRow.slope) for place in self.places))

    @property
    def within(self) -> dict[str, str]:
        """Keys that a drive is given with another one."""
        others = dict.fromkeys(BOTH_FITS, FITS)
        for place in self.on_films:
            for surface in (BearingRow.journal_roughness, BearingRow.housing_roughness):
                others[self.of_bearing(place, surface)] = SURFACES
            factor, clearance = BearingRow.clearance_factor, BearingRow.clearance
            others[self.of_bearing(place, factor)] = self.of_bearing(place, clearance)
        return others


class Variables:
    """The values of every variable, and what is wrong with those that are given."""

    def __init__(self, start: Document, design: Design, own: OptimiseInputs, tip: float | None) -> None:
        assert design.countershaft is not None and design.bearings is not None
        self.start, self.own, self.tip = start, own, tip
        self.shaft, self.bearings = design.countershaft, design.bearings
        self.keys, self.rows = DriveKeys(design), (design.rows[0], design.rows[-1])
        self.vary = self._by_own_keys(own.vary if isinstance(own.vary, dict) else {})
        self.errors: list[InputError] = []
        self.notes: list[Text] = []
        first, last = self.rows
        self.small, self.seat = (first, last) if passed(last) >= passed(first) else (last, first)
        if not self.keys.on_films:
            self.notes.append(Text("There is no film to vary: the bearings roll, and stay as they are."))
        for row in self.rows if self.keys.on_films else ():
            if not row.fed():
                self.notes.append(Text("The {place} bearing rolls, and stays as it is.", place=called(row.name)))
        tied, slopes = self.keys.tied, self.keys.slopes
        for key in self.vary:
            if key in tied:
                self.wrong(key, Text("can not be varied: it {why}", why=tied[key]))
            elif key in slopes:
                self.wrong(key, Text("can not be varied: it is that of each shaft's own bending"))
            elif (within := self.keys.within.get(key)) is not None and (within != SURFACES or self._surfaces_vary()):
                self.wrong(key, Text("can not be varied: it is set with {key}", key=Name(within)))

    def _by_own_keys(self, vary: Mapping[str, Any]) -> dict[str, Any]:
        """The values by the keys of the design, of which some may be those of schema 1; a * over the bearings is each
        of both, where it is of what a drive sizes."""
        sized = {*self.keys.sizes, *self.keys.tied, *self.keys.slopes, *self.keys.within}
        by_key: dict[str, Any] = {}
        for key, values in vary.items():
            own = current(self.start.data, key)
            each = every(self.start.data, own)
            by_key |= dict.fromkeys(each if sized.intersection(each) else [own], values)
        return by_key

    def wrong(self, key: str, why: Text, value: object = "") -> None:
        lines, vary = self.start.lines, dotted(Design.optimise, OptimiseInputs.vary)
        name = f"{vary}.{key}"
        line = lines.get(name, lines.get(vary, 0))
        self.errors.append(InputError(line, self._as_written(name), str(value), why))

    def _as_written(self, key: str) -> str:
        """What the file calls a key, which may be one of schema 1."""
        return own_key(self.start.former.was, key) if self.start.former is not None else key

    def values(self, key: str, otherwise: Sequence[float]) -> tuple[float, ...]:
        """Numbers of a key: those that are given, else those of the rule."""
        given = self.vary.get(key)
        if given is None:
            return tuple(otherwise)
        if given == "fixed":
            now = value_at(self.start.data, key)
            return (float(now),) if isinstance(now, (int, float)) else ()
        numbers = given if isinstance(given, list) else _range(given)
        if not all(isinstance(x, (int, float)) and not isinstance(x, bool) for x in numbers):
            self.wrong(key, Text("must be numbers"), given)
            return tuple(otherwise)
        if len(numbers) > MOST_VALUES:
            self.wrong(key, Text("asks for {n} values; at most {most}", n=len(numbers), most=MOST_VALUES))
            return tuple(otherwise)
        for x in (min(numbers), max(numbers)):
            self._allowed(key, x)
        return tuple(sorted(set(map(float, numbers))))

    def _allowed(self, key: str, value: object) -> None:
        """A value as the design file would take it."""
        try:
            design(self.start.with_value(key, value))
        except BadInput as bad:
            own_errors = [e for e in bad.errors if e.key == key or f"{e.key}.".startswith(self._places(key))]
            if own_errors or step_at(self.start.data, key) not in ("countershaft", "bearings"):
                self.wrong(key, (own_errors or bad.errors)[0].reason, value)

    def _places(self, key: str) -> tuple[str, ...]:
        """How the keys of its errors begin, in either schema: elements of arrays by index; of what is said of all
        bearings, at them."""
        data, there = self.start.data, self.keys.design.own_key(ShaftInputs.bearings) if key in MANY else key
        places = [".".join(map(str, address(data, each, whole=True))) for each in every(data, there)]
        return tuple(f"{where}." for place in places for where in (place, self._as_written(place)))

    def sizes(self) -> dict[str, tuple[float, ...] | None]:
        d_seat, d_small = passed(self.seat) * 1e3, across(self.small) * 1e3
        R = self._outer * 1e3
        core, widest = (self.shaft.core_radius or 0.0) * 1e3 / R, max(self._radii())
        most = min(d_seat + SEAT_REACH, self._widest_seat(), (self.own.most or {}).get("seat_mm", float("inf")))
        through = self._gear_through_small
        least = through + 2 * ROOM if through is not None else LEAST_SHARE * d_small
        seat_key, small_key = self._diameters()
        seats = self.values(seat_key, _steps(LEAST_SEAT * d_seat, most)) if self.seat.fed() else (d_seat,)
        seats = tuple(d for d in seats if d <= most + 1e-9)
        sizes: dict[str, tuple[float, ...] | None] = {
            self.keys.core: self.values(
                self.keys.core,
                _steps(
                    max(min(CORE_SHARE[0], core - 0.1), 0.05) * R, min(max(CORE_SHARE[1], core + 0.1), 0.95) * widest
                ),
            ),
            seat_key: seats if self.seat.fed() else (across(self.seat) * 1e3,),
            small_key: (d_small,),
        }
        if self.small.fed():
            sizes[small_key] = self.values(small_key, _steps(least, max(seats, default=0.0)))
        for row in self.rows:
            if not row.fed():
                sizes[self.keys.of_bearing(row.name, BearingRow.length)] = (along(row) * 1e3,)
                continue
            key = self.keys.of_bearing(row.name, BearingRow.length)
            sizes[key] = self.values(key, ()) if key in self.vary else None
        for key in self.keys.sizes:
            if (why := locked(self.start.data, key)) and key not in self.vary:
                sizes[key] = self.values(key, ()) if self.vary.setdefault(key, "fixed") else None
                self.notes.append(Text("{key} stays, as locked: {why}.", key=key, why=why))
        return sizes

    @property
    def _outer(self) -> float:
        """The outer radius of the sectors as designed, m."""
        if not self.shaft.passes_seats and self.shaft.outer_radius is not None:
            return self.shaft.outer_radius
        threaded = THREADED if self.shaft.radial_clearance is None else self.shaft.radial_clearance
        return passed(self.seat) / 2 - threaded

    def _radii(self) -> list[float]:
        """The outer radii that are looked at, mm: of a shaft that passes its seats that which follows from them."""
        R, given = self._outer * 1e3, self.vary.get(self.keys.outer)
        if self.shaft.passes_seats or given == "fixed":
            return [R]
        if given is None:
            return [R, *(round(R * share / STEP) * STEP for share in WIDER)]
        return [x for x in (given if isinstance(given, list) else _range(given)) if isinstance(x, (int, float))] or [R]

    def bounded(self) -> dict[str, tuple[bool, bool]]:
        seat_key, small_key = self._diameters()
        most = min(self._widest_seat(), (self.own.most or {}).get("seat_mm", float("inf")))
        through = self._gear_through_small is not None and small_key not in self.vary
        return {self.keys.core: (False, False), seat_key: (False, most < float("inf")), small_key: (through, True)}

    def _diameters(self) -> tuple[str, str]:
        """The keys of the larger journal's and of the smaller one's."""
        seat, small = (self.keys.of_bearing(row.name, BearingRow.diameter) for row in (self.seat, self.small))
        return seat, small

    @property
    def _gear_through_small(self) -> float | None:
        """The tip diameter of the gear, mm, where it goes through the smaller journal's seat: it comes from the
        front."""
        return self.tip if self.shaft.passes_seats and self.small is self.rows[0] else None

    def _widest_seat(self) -> float:
        support = self.shaft.support
        if support is None or support.wall is None or support.wall_at_seat is None:
            return float("inf")
        return (support.wall_at_seat + 2 * (support.wall - support.least_wall)) * 1e3

    def choices(self) -> dict[str, tuple[Any, ...]]:
        """The values of every key that makes classes."""
        by_rule = self._choices_by_rule()
        elsewhere = (*by_rule, *self.keys.sizes, *self.keys.tied, SURFACES)
        further = [key for key in self.vary if key not in elsewhere]
        options = {key: self._options(key, by_rule.get(key, [])) for key in (*by_rule, *further)}
        options = {key: values for key, values in options.items() if values}
        count = math.prod(map(len, options.values()))
        if count > MOST_CLASSES:
            self.wrong("", Text("makes {n} classes; at most {most}: vary less at once", n=count, most=MOST_CLASSES))
        if len(by_rule[FITS]) == 1 and FITS not in self.vary:
            self.notes.append(Text("The fits stay: no price says what closer ones cost."))
        return options

    def _choices_by_rule(self) -> dict[str, list[Any]]:
        """What is looked at where the design does not say it, the design's own first; of a locked key that alone."""
        shaft, bearings = self.shaft, self.bearings
        others = [a.material for a in shaft.cost.alternatives] if shaft.cost is not None else []
        fits = [str(bearings.journal_fit), str(bearings.seat_fit)]
        supplies = [s for s, width in SUPPLIES.items() if getattr(bearings, width) is not None and s != bearings.supply]
        by_rule: dict[str, list[Any]] = {
            self.keys.material: [shaft.material, *(m for m in others if m != shaft.material)],
            OIL: [bearings.oil],
            SUPPLY_KEY: [bearings.supply, *supplies] if self.keys.on_films else [],
            FITS: [fits, *(p.value for p in self.own.price if p.what == "fit" and p.value != fits)],
        }
        if not shaft.passes_seats:
            by_rule[self.keys.outer] = self._radii()
        for key, values in by_rule.items():
            if key != FITS and (why := locked(self.start.data, key)):
                del values[1:]
                if key != OIL:
                    self.notes.append(Text("{key} stays, as locked: {why}.", key=key, why=why))
        return by_rule

    def _options(self, key: str, by_rule: Sequence[Any]) -> tuple[Any, ...]:
        """The values of one key, each looked at whether the design could have it: as given, fixed, or by rule."""
        given = self.vary.get(key)
        if given is None or given == "fixed":
            values = tuple(by_rule[: 1 if given == "fixed" else None])
        else:
            values = tuple(given if isinstance(given, list) else _range(given))
        if given is not None or key == FITS:
            for value in values:
                self._check_choice(key, value)
        return values

    def _check_choice(self, key: str, value: object) -> None:
        if key == FITS:
            if not (isinstance(value, list) and len(value) == 2 and all(isinstance(x, str) for x in value)):
                self.wrong(key, WIDTHS, value)
            elif (why := fit_problem(value[0], "shaft") or fit_problem(value[1], "hole")) is not None:
                self.wrong(key, why, value)
            elif placed(replace(self.bearings, journal_fit=value[0], seat_fit=value[1])) is not None:
                self.wrong(key, WIDTHS, value)
            return
        try:
            quantity_of(self.start.data, key)
        except BadInput as bad:
            self.wrong(key, bad.errors[0].reason)
            return
        self._allowed(key, value)

    def _surfaces_vary(self) -> bool:
        given = self.vary.get(SURFACES)
        return given != "fixed" and (given is not None or any(p.what == "surface" for p in self.own.price))

    def surfaces(self) -> tuple[tuple[float, float] | None, ...]:
        given = self.vary.get(SURFACES)
        if given == "fixed":
            return (None,)
        priced = [p.value for p in self.own.price if p.what == "surface"]
        pairs: list[Any] = given if isinstance(given, list) else priced
        for pair in pairs:
            if not (
                isinstance(pair, list)
                and len(pair) == 2
                and all(isinstance(x, (int, float)) and 0 < x <= 50 for x in pair)
            ):
                self.wrong(SURFACES, Text("must be pairs of Ra in µm, journal and seat: [0.4, 0.6]"), pair)
                return (None,)
        if not pairs:
            self.notes.append(Text("The surfaces stay: no price says what smoother ones cost."))
        as_designed = [(row.journal_roughness * 1e6, row.housing_roughness * 1e6) for row in self.rows if row.fed()]
        if not as_designed:
            return (None,)
        surfaces: list[tuple[float, float] | None] = [] if isinstance(given, list) else [None]
        same = as_designed[0] == as_designed[-1]
        for a, b in pairs:
            pair = (float(a), float(b))
            if not (same and None in surfaces and all(abs(x - y) < 1e-9 for x, y in zip(pair, as_designed[0]))):
                surfaces.append(pair)
        return tuple(surfaces)


def _range(span: Mapping[str, float]) -> list[float]:
    count = (span["to"] - span["from"]) / span["step"]
    if count > MOST_VALUES:
        return [span["from"]] * (MOST_VALUES + 1)
    return [round(span["from"] + n * span["step"], 9) for n in range(int(count + 1e-9) + 1)]


def _steps(low: float, high: float) -> tuple[float, ...]:
    return tuple(round(x, 6) for x in multiples(STEP, low, high).tolist()) if high >= low else ()


# --- what is searched over, what must hold and what is wanted
# Read off the design and its [optimise], with the rules of this program beside.
#
# A class is one choice of everything that changes films or loads as a whole: material, oil, supply, fits, and any other
# key that is varied. Within it core, diameters, lengths, clearances and surfaces are combined.  Outer radius and
# half-length of the sectors follow from the journals (ties); the outer radius of a shaft that passes no seat is one of
# the choices that make classes.

# what is no limit, or one of the corners alone, and is to be kept all the same
LIMITS = tuple(
    rule.pattern
    for rule in (
        FILM_EDGE_CORNER,
        FILM_DOUBLE_LOAD,
        TEMPERATURE_CORNER,
        CLEARANCE_COLD_CORNER,
        FILM_EDGE_SPEEDS,
        FILM_EDGE_STANDING,
        FILM_TRUMPLER,
        LENGTH_RATIO_USUAL,
        SUPPLY_RANGE,
        JOURNAL_SLOPE,
        RIGID,
        GEAR_SEAT,
        FILLET_ROOM,
        HOLES_RANGE,
        SCATTER_RESIDUAL,
        SUPPORT_WALL,
        BACKLASH_CHANCE,
        CONTACT_RATIO_USUAL,
        SPAN_WIDTH,
        SAFETY_CONTACT_USUAL,
        SAFETY_BENDING_USUAL,
    )
)
MARGIN_OF = (FILM_EDGE_CORNER, FILM_DOUBLE_LOAD, FILM_EDGE_STANDING, JOURNAL_SLOPE)
MARGINS = (0.0, 0.05, 0.1, 0.2, 0.3)
UNITS = {"power": ("W", 10.0), "mass": ("kg", 0.5), "seat": ("mm", 1.0), "price": ("EUR", 3.0), "margin": ("%", 10.0)}


@record
class Problem:
    """`start`: the document with a shaft that is sized, by the changes `began` of the one that is asked about.
    `base`: its design, with the shaft in view that is searched.  `sizes`: the values of every size by its key, mm,
    None: by the rule of lengths.

    `choices`: the values of everything else; `surfaces`: pairs of Ra, journal and seat, µm; None: as designed.  `seat`:
    the bearing of the largest journal, by its name.  `most`: hard ends by objective, in its unit; margin is a least.
    `cycle`: speed over the rated one, and share of the time; empty: the rated speed alone.  `bounded`: whether the low
    and the high end of a range of sizes is a limit of the design itself.  `said`: what was chosen here."""

    start: Document
    began: Changes
    base: Design
    sizes: dict[str, tuple[float, ...] | None]
    choices: dict[str, tuple[Any, ...]]
    surfaces: tuple[tuple[float, float] | None, ...]
    seat: str
    objectives: tuple[str, ...]
    margins: tuple[float, ...]
    most: dict[str, float]
    limits: tuple[str, ...]
    waived: tuple[str, ...]
    units: dict[str, float]
    cycle: tuple[tuple[float, float], ...]
    bounded: dict[str, tuple[bool, bool]]
    rows: int
    seed: int
    said: tuple[Text, ...]

    @property
    def classes(self) -> list[Changes]:
        """The choices of every class, in the order of their lists."""
        return [dict(zip(self.choices, values)) for values in product(*self.choices.values())]

    @property
    def keys(self) -> DriveKeys:
        return DriveKeys(self.base)

    @property
    def small(self) -> str:
        """The name of the other bearing."""
        first, last = self.keys.places
        return first if self.seat == last else last

    @property
    def shaft(self) -> ShaftInputs:
        assert self.base.countershaft is not None
        return self.base.countershaft

    @property
    def rolling(self) -> dict[str, tuple[float, float, float]]:
        """Of the bearings that stay as they are: diameter and width on the shaft, and what passes their seats, mm."""
        ends = (self.base.rows[0], self.base.rows[-1])
        return {row.name: (across(row) * 1e3, along(row) * 1e3, passed(row) * 1e3) for row in ends if not row.fed()}

    def seats(self, diameter: Mapping[str, float]) -> float:
        """The largest seat that the sectors pass, mm."""
        rolling = self.rolling
        return max(rolling[place][2] if place in rolling else d for place, d in diameter.items())

    @property
    def threaded(self) -> float:
        """The clearance for threading in, mm."""
        clearance = self.shaft.radial_clearance
        return (THREADED if clearance is None else clearance) * 1e3

    @property
    def fillet(self) -> float:
        """mm; 0: none is asked."""
        return (self.shaft.fillet_radius or 0.0) * 1e3

    def seen(self, results: Results) -> Results:
        """Results with the shaft in view that is searched."""
        return results.views[self.base.own_name]

    def binds(self, id: str) -> bool:
        """Whether a finding is a limit here."""
        return any(fnmatchcase(id, pattern) for pattern in self.limits) and not any(
            fnmatchcase(id, pattern) for pattern in self.waived
        )

    def broken(self, checks: Iterable[Check]) -> list[Check]:
        """What a drive does not keep: limits that fail, and findings that are limits here."""
        return [c for c in checks if c.verdict == "fail" or (self.binds(c.id) and not c.margin >= 0)]

    def margin(self, checks: Iterable[Check]) -> float:
        """The least margin of the films and the slopes, %."""
        return min(
            (c.margin * 100 for c in checks if c.rule in MARGIN_OF),
            default=float("nan"),
        )

    def price(self, choices: Mapping[str, Any], surface: tuple[float, float] | None) -> float | None:
        """Of a piece, in EUR: its material with the tooling over a year, and what the rest adds; None: nothing is known
        of it."""
        return price(self.base, choices, surface)


def price(design: Design, choices: Mapping[str, Any], surface: tuple[float, float] | None) -> float | None:
    assert design.countershaft is not None
    cost = design.countershaft.cost
    material = choices.get(DriveKeys(design).material, design.countershaft.material)
    alternative = next((a for a in cost.alternatives if a.material == material), None) if cost is not None else None
    if alternative is None or cost is None:
        return None
    total = alternative.piece + alternative.tooling / cost.pieces_per_year
    chosen = {
        "fit": choices.get(FITS),
        "surface": list(surface) if surface is not None else None,
        "material": [material],
        "supply": [choices.get(SUPPLY_KEY)],
        "oil": [choices.get(OIL)],
    }
    return total + sum(entry.piece for entry in _optimise(design).price if chosen[entry.what] == entry.value)


def _optimise(design: Design) -> OptimiseInputs:
    return design.optimise or OptimiseInputs()


# --- reading


def searched(document: Document, design: Design, overrides: Mapping[str, object] = {}) -> str:
    """The name of the shaft that is searched; empty where there is none.  Raises BadInput where it is not known which,
    or where it has other than two bearings."""
    views, key = design.views, dotted(Design.optimise, OptimiseInputs.shaft)
    name = overrides.get("shaft", _optimise(design).shaft)
    twin = next((shaft for shaft in design.shafts if shaft.name == name and shaft.is_twin), None)
    names = ", ".join(views)
    why = EMPTY
    if twin is not None:
        why = Text("is as {name}: search that", name=Name(twin.mirrors or twin.repeats or ""))
    elif name is not None and name not in views:
        why = Text("is no shaft of this design; there are {names}", names=names)
    elif name is None and len(views) > 1:
        why = Text("there are several shafts: name one of {names} (--shaft)", names=names)
    own = str(name or next(iter(views), ""))
    rows = views[own].rows if own in views else ()
    if not why and len(rows) > 2:
        asked = f"choose FILE bearings --shaft {own}" if len(views) > 1 else "choose FILE bearings"
        why = Text("{n} bearings: not searched whole yet; `{command}` is", n=len(rows), command=asked)
    if why:
        raise BadInput(document.place, [InputError(document.lines.get(key, 0), key, str(name or ""), why)])
    return own


def problem(
    document: Document, tip: float | None, overrides: Mapping[str, object] = {}, shaft: str | None = None
) -> Problem:
    """`tip`: diameter of the gear on the shaft in mm, None where there is none; `overrides`: the command line's keys of
    [optimise], which go before the file's; `shaft`: which is searched, as `searched` gives it.  Raises BadInput with
    everything that is wrong."""
    whole = design(document)
    name = searched(document, whole, overrides) if shaft is None else shaft
    base = whole.views.get(name, whole)
    file = _optimise(base)
    merged: dict[str, Any] = {
        key: {**(getattr(file, key) or {}), **override} if isinstance(override, dict) else override
        for key, override in overrides.items()
    }
    inputs: OptimiseInputs = replace(file, **merged)
    errors = [
        InputError(document.lines.get(f"optimise.{key}", 0), f"optimise.{key}", "", why)
        for key, why in inputs.problems()
    ]
    errors += [
        InputError(0, dotted(table), "", Text("is needed: a drive has a shaft on two bearings"))
        for table, there in ((Design.shafts, base.countershaft), (Design.bearings, base.bearings))
        if there is None
    ]
    if (own := base.countershaft) is not None:
        as_searched = (
            (ShaftInputs.bore_diameter, not own.bore_diameter),
            (ShaftInputs.sector_material, own.sector_material is None),
        )
        alone = Text("is not searched: its shafts are solid, of one material")
        errors += [InputError(0, base.own_key(field), "", alone) for field, holds in as_searched if not holds]
    if len(base.rows) > 2:
        three = Text("has {n} rows: a drive is searched whole on two bearings alone", n=len(base.rows))
        errors.append(InputError(0, base.own_key(ShaftInputs.bearings), "", three))
    if errors:
        raise BadInput(document.place, errors)
    began, words = _sized(base)
    start = document
    for key, value in began.items():
        start = start.with_value(key, value)
    base = design(start).views[name]
    assert base.countershaft is not None and base.bearings is not None
    if len(base.shafts) > 1 or len(whole.views) > 1:
        words.append(_of_shaft(whole, base))
    variables = Variables(start, base, inputs, tip)
    sizes, choices, surfaces = variables.sizes(), variables.choices(), variables.surfaces()
    if variables.errors:
        raise BadInput(document.place, variables.errors)
    objectives = tuple(
        objective for objective in OBJECTIVES if inputs.objectives is None or objective in inputs.objectives
    )
    known = [dict(zip(choices, values)) for values in product(*choices.values())]
    most = {key.rpartition("_")[0]: float(bound) for key, bound in (inputs.most or {}).items()}
    if "price" in (*objectives, *most) and any(price(base, choice, None) is None for choice in known):
        objectives = _without_price(document, objectives, most)
        variables.notes.append(Text("The price is left out: [shafts.cost] does not have it of every material."))
    least = (inputs.least or {}).get("margin_percent", 0.0) / 100
    margins = tuple(dict.fromkeys([least, *(m for m in MARGINS if m > least)])) if "margin" in objectives else (least,)
    limits, waived = (*LIMITS, *(inputs.limits or ())), tuple(inputs.waive or ())
    return Problem(
        start=start,
        began=began,
        base=base,
        sizes=sizes,
        choices=choices,
        surfaces=surfaces,
        seat=variables.seat.name,
        objectives=objectives,
        margins=margins,
        most=most | {"margin": least * 100},
        limits=limits,
        waived=waived,
        units={key: UNITS[key][1] for key in objectives},
        cycle=_cycle(base, inputs),
        bounded=variables.bounded(),
        rows=inputs.rows,
        seed=inputs.seed,
        said=(*words, *variables.notes),
    )


def _of_shaft(design: Design, base: Design) -> Text:
    """Which of several shafts is searched."""
    twins = [Name(shaft.name) for shaft in base.shafts if shaft.is_twin]
    searched = {shaft.name for shaft in base.shafts}
    others = [Name(shaft.name) for shaft in design.shafts if shaft.name not in searched]
    said = Text("The shaft {name} is searched", name=Name(base.own_name))
    if twins:
        said += Text("; its twins follow: {names}", names=COMMA.join(twins))
    if others:
        said += Text("; the others stay as they are: {names}", names=COMMA.join(others))
    return said + Text(".")


def _without_price(document: Document, objectives: tuple[str, ...], most: Mapping[str, float]) -> tuple[str, ...]:
    """Where the price of some material is not known.  Raises BadInput where nothing else is wanted, or the price is
    bounded."""
    left = tuple(objective for objective in objectives if objective != "price")
    wrong = [key for key, needed in (("objectives", not left), ("most.price_EUR", "price" in most)) if needed]
    if wrong:
        why = Text("needs the price of every material: give each a row in shafts.cost.alternatives")
        raise BadInput(
            document.place,
            [InputError(document.lines.get(f"optimise.{key}", 0), f"optimise.{key}", "", why) for key in wrong],
        )
    return left


def _cycle(design: Design, inputs: OptimiseInputs) -> tuple[tuple[float, float], ...]:
    """Raises BadInput where the speed of the drive is not the engine's to change."""
    bearings, gears, engine = design.bearings, design.gears, design.engine
    fixed = (bearings is not None and bearings.speed is not None) or (gears is not None and gears.speed is not None)
    if not inputs.cycle:
        parts = [(row.speed, row.hours) for row in (engine.operation if engine is not None else ()) if row.hours]
        if engine is None or fixed or not parts:
            return ()
        whole = sum(hours for _, hours in parts)
        return tuple((speed / engine.rated_speed, hours / whole) for speed, hours in parts)
    if engine is None or fixed:
        why = Text("needs [engine], and no speed of its own in [bearings] or [gears]")
        cycle = dotted(Design.optimise, OptimiseInputs.cycle)
        raise BadInput("design", [InputError(0, cycle, "", why)])
    hours = sum(point.hours for point in inputs.cycle)
    return tuple((point.speed / engine.rated_speed, point.hours / hours) for point in inputs.cycle)


def _sized(design: Design) -> tuple[Changes, list[Text]]:
    """What makes of it a design with a shaft that is sized, its fits written so that their corners are judged; and in
    words."""
    shaft, bearings, keys = design.countershaft, design.bearings, DriveKeys(design)
    assert shaft is not None and bearings is not None
    notes: list[Text] = []
    start: Changes = {}
    seat = max(map(passed, design.rows))
    R = seat / 2 - (THREADED if shaft.radial_clearance is None else shaft.radial_clearance)
    if not shaft.passes_seats and shaft.outer_radius is not None:
        R = shaft.outer_radius
    half = min(abs(row.position) - along(row) / 2 for row in design.rows)
    if shaft.mode != "size" and not shaft.sections:
        start[design.own_key(ShaftInputs.outer_radius)] = round(R * 1e3, 6)
        if shaft.core_radius is None:
            start[keys.core] = round(0.4 * R * 1e3, 6)
        half -= 2 * (shaft.fillet_radius or 0.0)
        start[design.own_key(ShaftInputs.half_length)] = round(half * 1e3, 6)
        start[design.own_key(ShaftInputs.mode)] = "size"
        notes.append(Text("The masses are sized anew within the envelope of the journals (mode = size)."))
    sloped = [row.name for row in design.rows if row.slope is not None]
    if sloped:
        start |= {keys.of_bearing(name, BearingRow.slope): None for name in sloped}
        notes.append(Text("The slopes that are given are left out: those of each shaft's own bending are taken."))
    fits = (str(bearings.journal_fit), str(bearings.seat_fit))
    widths = placed(bearings)
    start |= dict(zip(BOTH_FITS, widths or fits))
    if any(row.limited or (bearings.select is not None and row.seat == "shells") for row in design.rows):
        of_parts, words = _clearances(design, keys)
        start |= of_parts
        notes.append(words)
    if widths:
        notes.append(
            Text(
                "The fits {own} make the clearance; here it is searched for, with their widths, {widths}.",
                own=Name("/".join(fits)),
                widths=Name("/".join(widths)),
            )
        )
    support = shaft.support
    if support is not None and support.wall is not None and support.wall_at_seat is None:
        start[design.own_key(ShaftInputs.support, ShaftSupport.wall_at_seat)] = round(seat * 1e3, 6)
        notes.append(
            Text(
                "The wall beside the largest seat is taken as that of the design's own seat, {seat} mm.",
                seat=f"{seat * 1e3:g}",
            )
        )
    return start, notes


def _clearances(design: Design, keys: DriveKeys) -> tuple[Changes, Text]:
    """Clearances as numbers in place of limits and classes of parts, with tolerances as wide; and in words."""
    found = solve(design).view(design.originals[0]).result(BearingsResult)
    if found is None:
        raise NoSolution(
            Text("the bearings"), EMPTY, Text("a design whose bearings are solved, to begin the search at")
        )
    start: Changes = {dotted(Design.bearings, BearingsInputs.select): None}
    grades = []
    for row in design.rows:
        r = found.plain.get(row.name)
        if r is None or (stack := r.seat.stack) is None:
            continue
        out = {BearingRow.journal: row.journal, BearingRow.finished: row.finished, BearingRow.bore: row.bore}
        start |= {keys.of_bearing(row.name, key): None for key, there in out.items() if there is not None}
        if row.bore_ == "finished":
            start[keys.of_bearing(row.name, BearingRow.bore_)] = None
        if row.ringed and r.seat.rings is not None and row.wall is None:
            start[keys.of_bearing(row.name, BearingRow.wall)] = round(r.seat.rings.wall * 1e3, 3)
        start[keys.of_bearing(row.name, BearingRow.clearance)] = round(r.clearance * 1e6, 1)
        field = r.corners.clearance_max - r.corners.clearance_min - stack.journal_width
        grades.append([_grade(width, row.diameter) for width in (stack.journal_width, field)])
    widest = [f"IT{max(column)}" for column in zip(*grades)]
    start |= dict(zip(BOTH_FITS, widest))
    words = Text(
        "Limits and classes of the parts make the clearance; here it is searched for, with tolerances about as wide, "
        "{fits}.",
        fits=Name("/".join(widest)),
    )
    return start, words


def _grade(width: Metre, diameter: Metre) -> int:
    """The grade whose tolerance comes nearest to a width."""
    return min(GRADES, key=lambda grade: abs(tolerance(grade, diameter) - width))
