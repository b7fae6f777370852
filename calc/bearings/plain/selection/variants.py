# SPDX-License-Identifier: Apache-2.0
"""What is searched over: the bearings as the design has them, the oils, the supplies, and where free the diameters."""

import re
from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import Protocol, TypeVar

import numpy as np

from ....countershaft.inputs import LAID_IN, ShaftInputs
from ....countershaft.outline import CROSSING
from ....countershaft.result import CountershaftResult
from ....countershaft.rows import BearingRow, called
from ....library import tolerances as fits
from ....library.catalogue import Oil
from ....library.journal_rules import LENGTH_RATIO, specific_load
from ....library.lubricant import Lubricant
from ....sheet.check import Check
from ....sheet.errors import NoSolution
from ....sheet.record import record, replace
from ....sheet.search import least
from ....sheet.step import Outcome
from ....sheet.text import EMPTY, Text
from ....sheet.units import Metre
from ...inputs import BearingsInputs
from ...result import BearingsResult
from ..checks import SPECIFIC_LOAD
from ..result import PlainResult
from ..seats.rings import Rings
from ..solve import clearance_of
from ..suitability import MATERIAL_LOAD
from .states import ALWAYS_TIGHT, RATIO, BearingTask, passes_split, room, rules

# --- what the search is given
# The bearings as they are, what stands around them, and how to solve the whole with others.

R = TypeVar("R")


class Solution(Protocol):
    """The results of a design, as far as the search looks into them."""

    @property
    def outcomes(self) -> Mapping[str, Outcome[object]]: ...
    @property
    def views(self) -> "Mapping[str, Solution]": ...
    def checks(self) -> Iterable[Check]: ...
    def result(self, kind: type[R]) -> R | None: ...


@record
class SelectionCase:
    """`results` are those of the design as it is, with all its shafts.  `solve`: the same with other bearings.

    `name`: of the shaft whose bearings they are; `ids`: how those of their checks begin; `rows`: front to rear;
    `place`: the key that they stand under; `own_oils`: names that the design has given itself; `gear_tip`: tip diameter
    of the gear on the shaft, `gear_bore` its bore; None where they are not known."""

    bearings: BearingsInputs
    name: str
    ids: str
    rows: tuple[BearingRow, ...]
    place: str
    shaft: ShaftInputs | None
    oils: Mapping[str, Oil]
    own_oils: tuple[str, ...]
    gear_tip: Metre | None
    results: Solution
    solve: "Solve"
    gear_bore: Metre | None = None

    def seen(self, results: Solution) -> Solution:
        """Results with its shaft in view."""
        return results.views[self.name]


def with_own_oil(case: SelectionCase) -> SelectionCase:
    """The same with no other oil to choose: that of the bearings is held."""
    return replace(case, oils={case.bearings.oil: case.oils[case.bearings.oil]})


class Solve(Protocol):
    """The design with other bearings.  `last`: no step after the bearings is solved."""

    def __call__(self, bearings: BearingsInputs, rows: tuple[BearingRow, ...], *, last: bool = False) -> Solution: ...


# --- the variants

ENGINE_OIL = re.compile(r"(SAE \d+W?|\d+W-\d+)\b")  # names by SAE J300, with or without a maker's behind them
SUPPLIES = {"hole": "hole_diameter", "shaft": "hole_diameter", "groove": "groove_width", "pocket": "pocket_width"}
SUPPLY = {
    "hole": Text("hole"),
    "shaft": Text("shaft"),
    "groove": Text("groove"),
    "pocket": Text("pocket"),
    "axial_groove": Text("axial grooves"),
}
# mm, offered where nothing ties the diameter; rule of this program: as shells and bars come
STANDARD = (*range(16, 37, 2), 38, 40, 42, 45, 48, *range(50, 101, 5), *range(110, 201, 10))
LARGER = 2.5  # times the smallest that carries the load, or the design's: no larger one is looked at
SHORT = 0.1  # of the diameter: journals that leave room for everything beside them
FINEST = 5  # IT grade of a ground journal: closer ones are not asked for; rule of this program
# l/d and ψ; rule of this program
PROBES = ((0.5, 1.5e-3), (0.5, 2.5e-3), (0.75, 1.5e-3), (0.75, 2.5e-3), (0.3, 1.5e-3))


@record
class Variant:
    """An oil and a way to supply it.  `fits`: closer ones of journal and seat; None: the design's own."""

    oil: str
    supply: str
    lubricant: Lubricant
    fits: tuple[str, str] | None = None

    @property
    def name(self) -> Text:
        row = Text("{oil}, {supply}", oil=self.oil, supply=SUPPLY[self.supply])
        return Text("{row}, {fits}", row=row, fits="/".join(self.fits)) if self.fits else row


def tasks(case: SelectionCase) -> dict[str, list[BearingTask]]:
    """Each bearing at each diameter that is looked at, the design's own first.  Raises NoSolution where they can not be
    known."""
    only_two(case)
    if other := next((row for row in case.rows if not row.fed()), None):
        without = Text("the {place} bearing runs on none", place=called(other.name))
        advice = Text("`contralbero choose FILE bearings` ranks all kinds")
        raise NoSolution(Text("only bearings on a film of oil are searched here"), without, advice)
    if any(case.bearings.of(row).supply == "axial_groove" for row in case.rows):
        what = Text("the search for bearings does not know films between axial grooves")
        raise NoSolution(what, EMPTY, Text("search with a hole, then set the grooves"))
    by_place = {place: [task] for place, task in own_tasks(case).items()}
    for row in case.rows:
        if not tied(case, row):
            (own,) = by_place[row.name]
            by_place[row.name] += [at_diameter(case, own, d) for d in diameters(case, row, own)]
    return by_place


def diameters(case: SelectionCase, row: BearingRow, own: BearingTask) -> list[Metre]:
    """Those that are offered beside the design's own: not below the bore of the wheel beside it, nor what carries the
    load when as long as may be."""
    least_of_all = max(
        case.gear_bore or 0.0 if row is case.rows[0] else 0.0, case.shaft.bore_diameter if case.shaft else 0.0
    )
    loads = [own.rules[rule] for rule in (SPECIFIC_LOAD, MATERIAL_LOAD) if rule in own.rules]
    found: list[Metre] = []
    for d in (n / 1000 for n in STANDARD):
        p = specific_load(F=own.duty.load, d=d, l=RATIO[1] * d)
        carries = not loads or float(least(load.on(np.asarray(p)) for load in loads)) >= 0
        if d >= least_of_all and carries and d <= max(LARGER * (found or [d])[0], own.size):
            found.append(d)
    return [d for d in found if abs(d - own.size) > 1e-9]


def at_diameter(case: SelectionCase, own: BearingTask, d: Metre) -> BearingTask:
    """One bearing at another diameter, with the room that it then has."""
    shaft = case.seen(drawn(case)).result(CountershaftResult)
    return replace(own.at_diameter(d), room=room(case.shaft, shaft, own.place, d))


def own_tasks(case: SelectionCase) -> dict[str, BearingTask]:
    """Each plain bearing at the design's own diameter.  Raises NoSolution where what it carries can not be known."""
    only_two(case)
    solved = solved_or_probed(case, case.rows)
    return {row.name: _task(case, row, solved) for row in case.rows if row.fed()}


def only_two(case: SelectionCase) -> None:
    """Raises NoSolution where the bearings share their load, so that none can be chosen for itself."""
    if len(case.rows) != 2:
        three = Text("the shaft has {n}, which share its load", n=len(case.rows))
        advice = Text("choose them: `contralbero choose FILE bearings`")
        raise NoSolution(Text("only the bearings of a shaft that has two are searched here"), three, advice)


def tasks_of(
    case: SelectionCase,
    solved: Solution,
    rows: tuple[BearingRow, ...] = (),
    at_own: Mapping[str, BearingTask] | None = None,
) -> dict[str, BearingTask]:
    """Each bearing of a solved design that carries enough to be judged.  `rows`: as they are there, else those of the
    design; `at_own`: the tasks of the design, whose sizes a change counts from."""
    there = solved.result(BearingsResult)
    assert there is not None
    films = there.plain
    loaded = [row for row in rows or case.rows if row.name in films and not films[row.name].seat.centred]
    return {row.name: _task(case, row, solved, (at_own or {}).get(row.name)) for row in loaded}


def tied(case: SelectionCase, row: BearingRow) -> Text:
    """What ties the diameter of a journal; empty where nothing does.

    The largest seat lets the sectors through where they are small enough for it, the front one the gear.
    """
    shaft = case.shaft
    if shaft is None:
        return EMPTY
    if shaft.sections:
        return Text("the sections of the shaft have it")
    if shaft.assembly in LAID_IN:
        return EMPTY
    drawing = case.seen(drawn(case)).result(CountershaftResult)
    outline = drawing.outline if drawing is not None else None
    radii = [p.outer_radius for p in outline.pieces if p.what == "sector"] if outline is not None else []
    R = max(radii, default=shaft.outer_radius)
    if R is None:
        return Text("the shaft's outline is not known")
    d = row.diameter
    if R <= d / 2 + 1e-9 and d >= max(other.opening() for other in case.rows):
        return Text("the sectors are threaded in through its seat")
    if row is case.rows[0] and case.gear_tip is not None and case.gear_tip < d:
        return Text("the gear goes through its seat")
    return EMPTY


def solved_or_probed(case: SelectionCase, rows: tuple[BearingRow, ...]) -> Solution:
    """Results, with the shaft in view, in which its bearings have an answer: those of the design, else of one with
    other lengths and clearances.

    Only loads, speeds and limits are taken from them, which do not depend on either.
    """
    results = case.seen(case.results if rows is case.rows else case.solve(case.bearings, rows, last=True))
    outcome = results.outcomes["bearings"]
    if outcome.state == "solved":
        return results
    if outcome.state == "blocked":
        raise NoSolution(Text("the bearings are not solved yet"), outcome.reason, Text("solve the steps before"))
    for ratio, psi in PROBES:
        probed = case.seen(case.solve(case.bearings, tuple(_probe(ratio, psi, row) for row in rows), last=True))
        if probed.outcomes["bearings"].state == "solved":
            return probed
    what, advice = (
        Text("no bearing can be chosen: the step has no answer"),
        Text("look at load, speed and supply first"),
    )
    raise NoSolution(what, outcome.reason, advice)


def _probe(ratio: float, psi: float, b: BearingRow) -> BearingRow:
    if not b.fed():
        return b
    return replace(b, length=ratio * b.diameter, clearance=psi * b.diameter, clearance_factor=None)


def _task(case: SelectionCase, bearing: BearingRow, solved: Solution, at_own: BearingTask | None = None) -> BearingTask:
    """`at_own`: the same bearing at the design's diameter, whose length and clearance are those that a change counts
    from."""
    there = solved.result(BearingsResult)
    assert there is not None  # what `solved_or_probed` gave
    place, bearings = bearing.name, case.bearings
    result = there.plain[place]
    space = room(case.shaft, case.seen(drawn(case)).result(CountershaftResult), place, bearing.diameter)
    # a clearance that is searched for is not that of the fits: they are taken as widths about it
    widths = placed(bearings)
    about = replace(bearings, journal_fit=widths[0], seat_fit=widths[1]) if widths else bearings
    stack, field = result.seat.stack, None
    if stack is not None:
        least_g, most_g = stack.clearances(result.seat.rings)
        field = most_g - least_g
    seat = replace(result.seat, bearing=bearing, inputs=about, stack=None, rings=_free(result.seat.rings))
    if at_own is not None:
        l, g, d = at_own.length, at_own.clearance, at_own.diameter
    else:
        l, g, d = bearing.length, _clearance(bearings, bearing, result), bearing.diameter
    alike = bearings.select is not None and bearing.seat == "shells"
    if alike and bearings.select is not None and bearings.select.walls_mm is None:  # what the walls are found for
        g = (bearings.select.clearance_band[0] + bearings.select.clearance_band[-1]) / 2
    ratio = (LENGTH_RATIO[0], RATIO[1]) if tied(case, bearing) else RATIO
    split = passes_split(bearing, bearings.of(bearing))
    limits = rules(place, solved.outcomes["bearings"].checks, ratio, split=split)
    return BearingTask(place, seat, result.duty, result.faster, limits, space, l, g, d, field, alike)


def _free(rings: Rings | None) -> Rings | None:
    """For any diameter and clearance.  An interference that is chosen holds at every state, whatever it then is."""
    if rings is None:
        return None
    kept = (ALWAYS_TIGHT, ALWAYS_TIGHT) if rings.chosen else rings.interference
    return replace(rings, bore=None, journal=None, interference=kept)


def _clearance(inputs: BearingsInputs, bearing: BearingRow, result: PlainResult) -> float:
    """The design's own, whatever clearance the bearing was solved with."""
    if bearing.clearance is not None:
        return bearing.clearance
    if result.seat.bearing.clearance is None or result.seat.stack is not None:
        return result.seat.clearance
    return clearance_of(inputs, bearing, result.duty.speed)  # the design itself has no film


def drawn(case: SelectionCase) -> Solution:
    """Results with an outline of the shaft: those of the design, else with journals so short that they cross nothing,
    where that helps."""
    results = case.results
    seen = case.seen(results)
    if case.shaft is None or seen.result(CountershaftResult) is None or not crossings(seen):
        return results
    return _with_short_journals(case)


@lru_cache(maxsize=1)
def _with_short_journals(case: SelectionCase) -> Solution:
    short = tuple(replace(row, length=SHORT * row.diameter) if row.fed() else row for row in case.rows)
    shortened = case.solve(case.bearings, short, last=True)
    return case.results if crossings(case.seen(shortened)) else shortened


def crossings(results: Solution) -> list[Check]:
    """Pieces of the shaft in view that overlap."""
    checks = results.outcomes["countershaft"].checks
    return [c for c in checks if c.rule is CROSSING and c.verdict == "fail"]


def placed(bearings: BearingsInputs) -> tuple[str, str] | None:
    """The widths alone of fits that both have a place, which makes the clearance; None: they have none."""
    fields = [fits.parse(bearings.journal_fit), fits.parse(bearings.seat_fit)]
    return None if any(field.letter is None for field in fields) else (f"IT{fields[0].grade}", f"IT{fields[1].grade}")


def closer_fits(bearings: BearingsInputs) -> list[tuple[str, str]]:
    """Fits of journal and seat by one grade closer and by two, up to IT5; widths about the clearance where they have a
    place."""
    widths = placed(bearings)
    if widths is not None:
        bearings = replace(bearings, journal_fit=widths[0], seat_fit=widths[1])
    fields = [fits.parse(bearings.journal_fit), fits.parse(bearings.seat_fit)]
    closer: list[tuple[str, str]] = []
    for steps in (1, 2):
        grades = [max(min(field.grade, FINEST), field.grade - steps) for field in fields]
        words = tuple(f"{field.letter or 'IT'}{grade}" for field, grade in zip(fields, grades))
        if words not in [(bearings.journal_fit, bearings.seat_fit), *closer]:
            closer.append((words[0], words[1]))
    return closer


def variants(case: SelectionCase) -> list[Variant]:
    """The design's oil and supply first, then every engine oil, thickest first, with every supply that the design has
    the width for."""
    bearings = case.bearings
    lubricants = {name: Lubricant(bearings.in_bearings(oil), bearings.viscosity_law) for name, oil in case.oils.items()}
    others = bearings.viscosity is None  # else every oil has the same viscosity
    oils = [n for n in lubricants if n == bearings.oil or (others and (n in case.own_oils or ENGINE_OIL.match(n)))]
    oils.sort(key=lambda name: (name != bearings.oil, -lubricants[name].at(bearings.supply_temperature).mu))
    supplies = [
        bearings.supply,
        *(s for s, width in SUPPLIES.items() if s != bearings.supply and getattr(bearings, width) is not None),
    ]
    return [Variant(name, fed, lubricants[name]) for fed in supplies for name in oils]


def thinner(offered: list[Variant], than: Variant, T: float) -> Variant | None:
    """The next thinner oil with the same supply, at a temperature."""
    mine = than.lubricant.at(T).mu
    below = [v for v in offered if v.supply == than.supply and v.fits == than.fits and v.lubricant.at(T).mu < mine]
    return max(below, key=lambda v: v.lubricant.at(T).mu, default=None)
