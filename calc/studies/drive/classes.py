# SPDX-License-Identifier: Apache-2.0
"""One class: its films and shafts, and the front of all their combinations.  It keeps no state: the same rows wherever
it runs."""

from collections.abc import Callable
from typing import Any

import numpy as np

from ...bearings.plain.checks import FILM_EDGE_SPEEDS, FILM_EDGE_STANDING, LENGTH_RATIO_USUAL, SUPPLY_RANGE
from ...bearings.plain.selection.grid import LENGTH_STEP
from ...bearings.plain.selection.states import BearingTask
from ...bearings.plain.selection.variants import Variant, own_tasks
from ...bearings.result import BearingsResult
from ...countershaft.checks import FILLET_ROOM, GEAR_SEAT, JOURNAL_SLOPE
from ...countershaft.result import CountershaftResult
from ...countershaft.rows import BearingRow
from ...design.model import Design
from ...design.step_inputs import bearings_case, shaft_gear
from ...design.toml_file import Document, design
from ...gears.result import TrainResult
from ...library.journal_rules import LENGTH_RATIO, USUAL_LENGTH_RATIO
from ...library.lubricant import Lubricant
from ...sheet.arrays import Array
from ...sheet.errors import BadInput, NoSolution
from ...sheet.record import record, replace
from ...sheet.step import Outcome
from ...sheet.text import EMPTY, Text
from ...sheet.units import Kilogram
from ...sheet.value import recorded, untraced
from ...solve import Results, solve
from .combinations import DriveRows, Sizes, class_front, combinations
from .films import Beside, Films, StandingTask, Stands, films, least_length, lengths, without_film
from .problem import Problem, across, along, passed
from .shafts import ShaftSurroundings, with_turning
from .solved_drive import Sized, journals_power, other_wheels, whole, written

PURE = 1e-6  # of the couple over the span: a force below it is none
ADVICE = (LENGTH_RATIO_USUAL, SUPPLY_RANGE)  # findings on a bearing that the tables know
UM = 1e-6
TINY = 1e-9
PROBED = 1.5  # ‰ of the diameter: a clearance that most journals have a film with


@record
class ClassFront:
    """What one class gives.  `combinations` that were looked at; `crank`: crank power over that of both journals,
    intercept and slope; `wheels`: mass of those that are not on the shaft."""

    rows: DriveRows
    combinations: int
    crank: tuple[float, float]
    wheels: Kilogram = 0.0
    why: Text = EMPTY  # where it has no rows


def based(problem: Problem, choices: dict[str, Any]) -> Document:
    """The document of a class with sizes that solve if any do: the largest seat, the shortest journals, the smallest
    core."""
    keys, bearings = problem.keys, problem.base.bearings
    diameter = {
        place: max(problem.sizes[keys.of_bearing(place, BearingRow.diameter)] or (0.0,)) for place in keys.places
    }
    assert bearings is not None
    wide = max(bearings.of(row).widest_supply for row in problem.base.rows) * 1e3
    length = {place: round(max(USUAL_LENGTH_RATIO[0] * d, wide + 1.0), 1) for place, d in diameter.items()}
    clearance = {place: round(PROBED * d, 1) for place, d in diameter.items()}
    sized = Sized(choices, min(problem.sizes[keys.core] or (0.0,)), diameter, length, clearance, None)
    document, _ = written(problem, sized)
    return document


def not_closed(design: Design, results: Results) -> Text:
    """Why the front can not be found on arrays and proved; empty where it can."""
    shaft, bearings, solved = design.countershaft, design.bearings, results.result(CountershaftResult)
    assert shaft is not None and bearings is not None
    if len(shaft.bearing_positions) != 2:
        return Text("the shaft has more than two supports")
    if shaft.sections:
        return Text("the sections of the shaft are given")
    if not shaft.passes_seats:
        return Text("the shaft passes no seat that its outer radius would follow from")
    if shaft.extras or (
        shaft.gear_z is not None and shaft.bearing_positions[0] < shaft.gear_z < shaft.bearing_positions[1]
    ):
        return Text("further elements stand on the shaft")
    if any(bearings.of(row).supply == "axial_groove" for row in design.rows):
        return Text("films between axial grooves are not known on arrays")
    if any(row.load is not None for row in design.rows):
        return Text("loads of the bearings are given")
    if (
        solved is not None
        and solved.force * (shaft.bearing_positions[1] - shaft.bearing_positions[0]) > PURE * solved.couple
    ):
        return Text("the shaft takes a force beside the couple")
    return EMPTY


def class_of(problem: Problem, choices: dict[str, Any]) -> ClassFront:
    """The front of one class on arrays.  Raises NoSolution where its loads can not be known, or the closed form does
    not hold."""
    with untraced():
        design, results = _solved(problem, choices)
        drive, sizes = _put(problem, design, results)
        rows, count, wheels = class_front(drive, sizes), combinations(sizes), other_wheels(results)
        if not len(rows):
            return ClassFront(rows, count, (0.0, 1.0), wheels, Text("no combination bears its slopes with its films"))
        return ClassFront(rows, count, _line(problem, choices, rows), wheels)


def class_with(problem: Problem, choices: dict[str, Any]) -> DriveRows:
    """Its rows alone."""
    return class_front(*tables_of(problem, choices))


def tables_of(problem: Problem, choices: dict[str, Any]) -> tuple[ShaftSurroundings, Sizes]:
    """What is combined in a class."""
    return _put(problem, *_solved(problem, choices))


def _put(problem: Problem, design: Design, results: Results) -> tuple[ShaftSurroundings, Sizes]:
    drive = drive_of(design, results, problem.binds(FILLET_ROOM.id))
    return drive, sizes_of(problem, design, results, drive)


def _solved(
    problem: Problem, choices: dict[str, Any], enough: Callable[[Outcome[object]], bool] | None = None
) -> tuple[Design, Results]:
    """With the shaft in view that is searched; `enough` ends the solution early, as in `solve`."""
    try:
        class_design = design(based(problem, choices))
    except BadInput as bad:
        raise NoSolution(
            Text("no sizes in the ranges make a design"), Text("{why}", why=str(bad.errors[0].reason))
        ) from None
    with recorded(False):
        results = solve(class_design, enough=enough)
    results = problem.seen(results)
    if (shaft := results.outcomes["countershaft"]).state != "solved":
        raise NoSolution(Text("even the largest envelope of the ranges does not hold the couple"), shaft.reason)
    if why := not_closed(results.design, results):
        raise NotClosed(why)
    return results.design, results


def without_proof(problem: Problem) -> Text | None:
    """Why no front of this drive can be proved; None where it can, as far as the shaft of its first class says."""
    try:
        _solved(problem, problem.classes[0], lambda outcome: outcome.key == "countershaft")
    except NotClosed as why:
        return why.text
    except NoSolution:
        pass
    return None


class NotClosed(NoSolution):
    """The closed form does not hold: `text` says why."""


def drive_of(design: Design, results: Results, filleted: bool = True) -> ShaftSurroundings:
    """`filleted`: whether a gap between two shoulders must be none, or hold its fillets."""
    shaft, solved = design.countershaft, results.result(CountershaftResult)
    assert shaft is not None and solved is not None
    gear = shaft_gear(design, results.result(TrainResult), shaft.name)
    first, last = shaft.bearings
    seat = max(passed(first), passed(last))
    clearance = seat / 2 - (shaft.outer_radius or 0.0)
    drive = ShaftSurroundings(
        design.materials[shaft.material],
        float(solved.couple),
        abs(float(solved.omega)),
        (first.position, last.position),
        clearance,
        shaft.fillet_radius or 0.0,
        shaft.sector_effectiveness,
        (gear.diameter, gear.face_width) if gear else None,
        filleted,
        gear_z=shaft.gear_z,
        holes=shaft.holes,
    )
    if not solved.slopes:
        return drive
    sizes = (across(first), across(last)), (along(first), along(last))
    slopes = solved.slopes[first.name], solved.slopes[last.name]
    return with_turning(drive, shaft.core_radius or 0.0, *sizes, slopes, seat)


def sizes_of(problem: Problem, design: Design, results: Results, drive: ShaftSurroundings) -> Sizes:
    assert design.bearings is not None
    bearings, keys = design.bearings, problem.keys
    tasks = own_tasks(bearings_case(design, solve, results)) if keys.on_films else {}
    variant = Variant(
        bearings.oil,
        bearings.supply,
        Lubricant(bearings.in_bearings(design.oils[bearings.oil]), bearings.viscosity_law),
    )
    seats = np.array(problem.sizes[keys.of_bearing(problem.seat, BearingRow.diameter)] or (0.0,)) * 1e-3
    core = np.array(problem.sizes[keys.core] or (0.0,)) * 1e-3
    rolling = {row.name: row for row in design.rows if not row.fed()}
    widest = passed(rolling[problem.seat]) if problem.seat in rolling else float(seats.max())
    R, r_0 = widest / 2 - drive.clearance, float(core.min())
    longest = {place: drive.longest(n, R, r_0) for n, place in enumerate(keys.places)}
    by_place = {
        place: _as_they_are(problem, rolling[place], results)
        if place in rolling
        else _over_diameters(
            problem, place, tasks[place], variant, longest[place], _beside(problem, place, design, results)
        )
        for place in keys.places
    }
    gear = shaft_gear(design, results.result(TrainResult), problem.shaft.name)
    if gear is not None and problem.binds(GEAR_SEAT.id):  # it goes through the first seat
        first, _ = keys.places
        by_place[first] = [films for films in by_place[first] if films.opening > gear.tip_diameter + TINY]
    limit = next(c.limit for c in results.checks() if c.rule is JOURNAL_SLOPE)
    assert isinstance(limit, float)
    surfaces = tuple(_surface(surface, design) for surface in problem.surfaces)
    return Sizes(core, surfaces, problem.margins, limit * 1e-3, problem.seat, by_place)


def _beside(problem: Problem, place: str, design: Design, results: Results) -> Beside:
    """The films that are limits beside those of the corners; what stands still is that of the class's own start."""
    bench = design.engine.gallery if design.engine is not None else ()
    given = design.bearings is not None and design.bearings.speed_range is not None
    over = bench if bench or given or problem.binds(FILM_EDGE_SPEEDS.of(place)) else None
    bearings, shaft = results.result(BearingsResult), results.result(CountershaftResult)
    part = bearings.plain[place].standing if bearings is not None else None
    if bearings is None or part is None or shaft is None or not problem.binds(FILM_EDGE_STANDING.of(place)):
        return Beside(over)
    weight = shaft.standing.weights.get(place, 0.0) if shaft.standing is not None else 0.0
    return Beside(over, Stands(weight, part.standing_load - weight, bearings.bearings[place].friction_power))


def _surface(pair: tuple[float, float] | None, design: Design) -> dict[str, tuple[float, float]]:
    """Ra of journal and seat of each bearing."""
    if pair is not None:
        return {row.name: (pair[0] * UM, pair[1] * UM) for row in design.rows}
    return {row.name: (row.journal_roughness, row.housing_roughness) for row in design.rows}


def _as_they_are(problem: Problem, row: BearingRow, results: Results) -> list[Films]:
    """The one size of a bearing that stays as it is, with what it rubs."""
    solved = results.result(BearingsResult)
    if solved is None:
        raise NoSolution(Text("the bearings"), results.outcomes["bearings"].reason)
    r = solved.bearings[row.name]
    power = r.friction_power
    if problem.cycle:
        ratio, share = (np.array(column) for column in zip(*problem.cycle))
        power = float(np.sum(share * r.answer_at(ratio, r.supply_temperature + 0.0 * ratio, None).under(0.0)))
    return [without_film(StandingTask(row.name, across(row), passed(row)), along(row), power)]


def _over_diameters(
    problem: Problem, place: str, task: BearingTask, variant: Variant, longest: float, beside: Beside
) -> list[Films]:
    advice = [rule for rule in ADVICE if problem.binds(rule.of(place))]
    ratios = USUAL_LENGTH_RATIO if LENGTH_RATIO_USUAL in advice else LENGTH_RATIO
    keys = problem.keys
    given = problem.sizes[keys.of_bearing(place, BearingRow.length)]
    kept_films: list[Films] = []
    for d in problem.sizes[keys.of_bearing(place, BearingRow.diameter)] or ():
        # the design's own clearance is not one of the steps
        at = replace(task.at_diameter(d * 1e-3), diameter=d * 1e-3, clearance=0.0)
        l = (
            lengths(at, longest, ratios)
            if given is None
            else _within(np.array(given) * 1e-3, least_length(at) - LENGTH_STEP, longest)
        )
        if (
            l.size
            and (films_here := films(at, variant, l, advice, problem.cycle, beside)) is not None
            and films_here.kept.any()
        ):
            kept_films.append(films_here)
    return kept_films


def _within(length: Array, above: float, longest: float) -> Array:
    return length[(length > above) & (length <= longest + 1e-9)]


def sized(problem: Problem, choices: dict[str, Any], rows: DriveRows, n: int) -> Sized:
    """One row in the units of the keys."""

    def of_each(sizes: Array, unit: float) -> dict[str, float]:
        return {place: round(float(x) * unit, 6) for place, x in zip(problem.keys.places, sizes[n])}

    return Sized(
        choices,
        round(float(rows.core[n]) * 1e3, 6),
        of_each(rows.diameter, 1e3),
        of_each(rows.length, 1e3),
        of_each(rows.clearance, 1e6),
        problem.surfaces[int(rows.surface[n])],
    )


def _line(problem: Problem, choices: dict[str, Any], rows: DriveRows) -> tuple[float, float]:
    """Crank power is a straight line over the power of both journals: through two rows that are solved whole."""
    points = []
    for n in dict.fromkeys([int(rows.power.argmin()), int(rows.power.argmax())]):
        drive, results = whole(problem, sized(problem, choices, rows, n))
        if results is not None and drive.objectives:
            own = float(rows.power[n]) if problem.cycle else journals_power(problem.seen(results))
            points.append((own, drive.objectives["power"]))
    if len(points) == 2 and points[1][0] > points[0][0]:
        slope = (points[1][1] - points[0][1]) / (points[1][0] - points[0][0])
        return points[0][1] - slope * points[0][0], slope
    return (points[0][1] - points[0][0], 1.0) if points else (0.0, 1.0)
