# SPDX-License-Identifier: Apache-2.0
"""A row put into the design and solved whole: only these are shown, and their numbers are those of the whole
solution."""

import math
from collections.abc import Mapping
from typing import Any

from ...bearings.result import BearingsResult
from ...countershaft.inputs import ShaftInputs
from ...countershaft.result import CountershaftResult
from ...countershaft.rows import BearingRow
from ...design.model import Design
from ...design.toml_file import Document, design
from ...engine.inputs import EngineInputs
from ...friction.result import FrictionResult
from ...gears.result import TrainResult
from ...sheet.check import Check
from ...sheet.errors import BadInput
from ...sheet.quantity import dotted
from ...sheet.record import record
from ...sheet.remedy import Changes, digits
from ...sheet.units import Kilogram, Watt
from ...sheet.value import recorded
from ...sheet.verdict import counts
from ...solve import Results, solve
from .problem import BOTH_FITS, FITS, Problem

LARGE = 1e3  # a step without solution, and a hard end that is passed over, are lacks as large as this
LEAST_LACK = 0.01  # of whatever is broken: by the less the fewer it is


@record
class Sized:
    """The sizes of one drive in the units of their keys, with the choices of its class."""

    choices: Changes
    core: float
    diameter: dict[str, float]
    length: dict[str, float]
    clearance: dict[str, float]
    surface: tuple[float, float] | None


@record
class Whole:
    """A drive as the program solves it.  `objectives` by name, in their units; `broken`: what it does not keep, empty
    for one that passes; `open`: how many other findings stay open; `lacks`: by how much of 1 its limits are passed
    over, all of them together."""

    sized: Sized
    changes: Changes
    document: Document
    objectives: dict[str, float]
    broken: tuple[str, ...]
    open: int
    lacks: float = 0.0


def chosen(choices: Mapping[str, Any]) -> Changes:
    """The keys of a class as they stand in a design: fits are two of them."""
    changes = {key: value for key, value in choices.items() if key != FITS}
    if (fits := choices.get(FITS)) is not None:
        changes |= dict(zip(BOTH_FITS, fits))
    return changes


def changes(problem: Problem, sized: Sized) -> Changes:
    """Every key that makes the design this drive; the ties are followed here."""
    changed, keys, base = chosen(sized.choices), problem.keys, problem.base
    changed[keys.core] = digits(sized.core)
    half = min(abs(row.position) * 1e3 - sized.length[row.name] / 2 for row in base.rows) - 2 * problem.fillet
    if problem.shaft.passes_seats:
        changed[keys.outer] = digits(problem.seats(sized.diameter) / 2 - problem.threaded)
    changed[base.own_key(ShaftInputs.half_length)] = digits(half)
    for place in keys.on_films:
        here: dict[object, float | None] = {
            BearingRow.diameter: digits(sized.diameter[place]),
            BearingRow.length: digits(sized.length[place]),
            BearingRow.clearance_factor: None,
            BearingRow.clearance: digits(sized.clearance[place]),
        }
        if sized.surface is not None:
            here |= {
                BearingRow.journal_roughness: sized.surface[0],
                BearingRow.housing_roughness: sized.surface[1],
            }
        changed |= {keys.of_bearing(place, field): value for field, value in here.items()}
    return changed


def written(problem: Problem, sized: Sized) -> tuple[Document, Changes]:
    """The document of a drive, and the keys in which it differs from the start."""
    changed = changes(problem, sized)
    document = problem.start
    for key, value in changed.items():
        document = document.with_value(key, value)
    return document, changed


def whole(problem: Problem, sized: Sized, before: Results | None = None) -> tuple[Whole, Results | None]:
    """Solved as any design; `before`: results of another row, of which what is alike is taken over."""
    document, changed = written(problem, sized)
    try:
        with recorded(False):
            results = solve(design(document), before)
    except BadInput as bad:
        return Whole(sized, changed, document, {}, tuple(e.key for e in bad.errors), 0, LARGE), None
    stopped = tuple(key for key, outcome in results.outcomes.items() if outcome.state in ("no_solution", "blocked"))
    checks = list(results.checks())
    fail = problem.broken(checks)
    broken = tuple(c.id for c in fail)
    objectives = {} if stopped else measured(problem, document, results, checks, sized)
    over = tuple(
        f"optimise.most.{key}"
        for key, bound in problem.most.items()
        if objectives and _beyond(key, objectives.get(key), bound)
    )
    n = counts(checks)
    lacks = sum(map(_lack, fail)) + LARGE * len({*stopped, *over} - set(broken))
    return Whole(
        sized, changed, document, objectives, (*stopped, *broken, *over), n.cautions + n.narrow + n.not_verified, lacks
    ), results


def _lack(broken: Check) -> float:
    return LARGE if math.isnan(broken.margin) else min(max(-broken.margin, 0.0), LARGE) + LEAST_LACK


def _beyond(key: str, value: float | None, bound: float) -> bool:
    if value is None:
        return False
    return value < bound - 1e-9 if key == "margin" else value > bound + 1e-9


def measured(
    problem: Problem, document: Document, results: Results, checks: list[Check], sized: Sized
) -> dict[str, float]:
    """The objectives that are known, in their units."""
    watts = mean_power(problem, document, results) if problem.cycle else power(results)
    objectives = {
        "power": watts,
        "mass": mass(problem.seen(results)),
        "seat": problem.seats(sized.diameter),
        "margin": problem.margin(checks),
    }
    cost = problem.price(sized.choices, sized.surface)
    return objectives if cost is None else objectives | {"price": cost}


def mean_power(problem: Problem, document: Document, results: Results) -> Watt:
    """Over the duty cycle: the drive solved at each of its speeds, which changes no size."""
    rated = problem.base.engine.rated_speed * 60 if problem.base.engine is not None else 0.0
    key, mean, before = dotted(Design.engine, EngineInputs.rated_speed), 0.0, results
    for ratio, share in problem.cycle:
        with recorded(False):
            before = solve(design(document.with_value(key, digits(rated * ratio))), before)
        solved = all(before.outcomes[key].state in ("solved", "not_asked") for key in ("bearings", "friction"))
        mean += share * power(before) if solved else float("inf")
    return mean


def mass(results: Results) -> Kilogram:
    """Of the shaft in view with its gear, and of its twins, and of all other wheels."""
    shaft = results.result(CountershaftResult)
    assert shaft is not None and shaft.mass is not None
    return len(results.design.shafts) * float(shaft.mass) + other_wheels(results)


def other_wheels(results: Results) -> Kilogram:
    """Of the train, but for those on the shafts, which are weighed with them."""
    train = results.result(TrainResult)
    if train is None:
        return 0.0
    on_shafts = {turn.wheel for turn in train.shafts.values()}
    return float(sum(wheel.mass or 0.0 for name, wheel in train.wheels.items() if name not in on_shafts))


def power(results: Results) -> Watt:
    """What the drive takes from the crank; without a train what the journals of all shafts rub."""
    published = results.value(FrictionResult.crank_power)
    if published is not None:
        return float(published.inside)
    return sum(journals_power(results.view(shaft.name)) for shaft in results.design.shafts)


def journals_power(results: Results) -> Watt:
    """Of both journals of the shaft in view."""
    bearings = results.result(BearingsResult)
    assert bearings is not None
    return float(sum(bearing.friction_power for bearing in bearings.bearings.values()))
