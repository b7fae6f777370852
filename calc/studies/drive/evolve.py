# SPDX-License-Identifier: Apache-2.0
"""The search without proof: NSGA-II over whole solutions, where films and shafts can not be combined on arrays.

A force beside the couple, further elements, axial grooves, loads that are given: each candidate is solved whole, and
its limits are the constraints.  What comes out passes as anything else that is shown; that nothing better exists is not
known, and is not said. Deb, Pratap, Agarwal & Meyarivan 2002, A fast and elitist multiobjective genetic algorithm:
NSGA-II; by pymoo, an extra."""

from collections.abc import Callable
from importlib.util import find_spec
from typing import Any

import numpy as np

from ...bearings.plain.selection.grid import WIDEST
from ...bearings.result import BearingsResult
from ...countershaft.rows import BearingRow
from ...design.toml_file import design
from ...library.journal_rules import USUAL_LENGTH_RATIO
from ...sheet.arrays import Array
from ...sheet.errors import NoSolution
from ...sheet.extras import needs
from ...sheet.text import Text
from ...sheet.value import recorded
from ...solve import Results, solve
from .combinations import no_rows
from .front import front, representatives
from .problem import Problem, across, along
from .search import FrontFound, FrontTable
from .solved_drive import Sized, Whole, whole

POPULATION = 40
EVALUATIONS = 1600  # whole solutions; the command line has its own
LENGTH_STEP, CLEARANCE_STEP = 0.5, 5.0  # mm, µm
NARROWEST = 0.5e-3  # of the diameter
ABOUT = 0.1  # of the range of each variable: how far half of the first points lie about the design as it is
NEEDS = needs("search")


def may(problem: Problem) -> Text | None:
    """Why not even this way can search a design; None: it can."""
    shaft = problem.shaft
    if shaft.sections:
        return Text("the sections of the shaft are given: leave them out, and the sectors are sized")
    if len(shaft.bearing_positions) != 2:
        return Text("the shaft has more than two supports: no sectors are sized for it")
    return None


def installed() -> bool:
    """Whether the package is there with which it searches."""
    return find_spec("pymoo") is not None


def evolved(
    problem: Problem,
    evaluations: int = EVALUATIONS,
    seed: int = 1,
    progress: Callable[[int, int, int], None] | None = None,
    enough: Callable[[], bool] = bool,
) -> FrontFound:
    """The best of some whole solutions, and where none passes what they break.  `progress`: how many are done, of how
    many, how many pass. `enough`, asked after each of them, ends it.

    Raises NoSolution where pymoo is not installed, or the shaft is none that is sized.
    """
    if (why := may(problem)) is not None:
        raise NoSolution(Text("no drive can be searched for"), why)
    try:
        from pymoo.algorithms.moo.nsga2 import NSGA2
        from pymoo.core.problem import Problem as Pymoo
        from pymoo.operators.crossover.sbx import SBX
        from pymoo.operators.mutation.pm import PM
        from pymoo.optimize import minimize
    except ImportError:
        why = Text("this drive is searched by trying whole solutions, which {needs}", needs=NEEDS)
        raise NoSolution(why) from None
    space = Space(problem)

    class _Drives(Pymoo):  # type: ignore[misc]
        """Numbers from 0 to 1, each a place in the values of one variable."""

        def __init__(self) -> None:
            super().__init__(n_var=space.variables, n_obj=len(problem.objectives), n_ieq_constr=1, xl=0.0, xu=1.0)

        def _evaluate(self, x: Array, out: dict[str, Array], *args: object, **more: object) -> None:
            scored = []
            for row in x:
                if space.known and enough():
                    raise _Enough
                scored.append(space.scored(row))
            out["F"], out["G"] = np.array([score[0] for score in scored]), np.array([[score[1]] for score in scored])
            if progress is not None:
                progress(len(space.known), evaluations, len(space.passing))

    algorithm = NSGA2(
        pop_size=POPULATION,
        sampling=space.first(np.random.default_rng(seed)),
        crossover=SBX(prob=0.9, eta=10),
        mutation=PM(eta=15),
        eliminate_duplicates=True,
    )
    try:
        minimize(_Drives(), algorithm, ("n_eval", evaluations), seed=seed)
    except _Enough:
        pass
    except KeyboardInterrupt:
        if not space.known:
            raise
    return space.found()


class _Enough(Exception):
    """The time is up."""


class Space:
    """The variables of a problem, and every drive of them that was solved whole."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        self.known: dict[tuple[Any, ...], tuple[Whole, Array, float]] = {}
        self.before: Results | None = None
        self.width = self._width()

    @property
    def variables(self) -> int:
        return 9

    @property
    def passing(self) -> list[Whole]:
        return [drive for drive, _, _ in self.known.values() if not drive.broken]

    def _width(self) -> float:
        """The width of the supply in mm, which a journal must be longer than."""
        base = self.problem.base
        assert base.bearings is not None
        return max(base.bearings.of(row).widest_supply for row in base.rows) * 1e3

    def first(self, by_chance: np.random.Generator) -> Array:
        """The points to begin with: the design as it is, some about it, and as many anywhere."""
        points = by_chance.random((POPULATION, self.variables))
        near = self.own() + ABOUT * (2 * by_chance.random((POPULATION // 2, self.variables)) - 1)
        points[: len(near)] = np.clip(near, 0.0, 1.0)
        points[0] = self.own()
        return points

    def own(self) -> Array:
        """The point that comes nearest to the design as it is, with the first of its choices."""
        problem, sizes, keys = self.problem, self.problem.sizes, self.problem.keys
        with recorded(False):
            self.before = solve(design(problem.start), self.before)
        seen = problem.seen(self.before).result(BearingsResult)
        rows = {row.name: row for row in problem.base.rows}
        seats = sizes[keys.of_bearing(problem.seat, BearingRow.diameter)] or ()
        seat, small = (across(rows[place]) * 1e3 for place in (problem.seat, problem.small))
        below = self._below(seat)
        core = (problem.shaft.core_radius or 0.0) * 1e3
        point = [0.0, 0.0, _share(sizes[keys.core] or (), core), _share(seats, seat), _share(below, small)]
        for place in keys.places:
            d, l = across(rows[place]) * 1e3, along(rows[place]) * 1e3
            given, (low, high) = sizes[keys.of_bearing(place, BearingRow.length)], self._lengths(d)
            film = seen.plain.get(place) if seen is not None else None
            psi = NARROWEST if film is None else film.clearance / rows[place].diameter
            point += [
                _share(given, l) if given else (l - low) / (high - low),
                (psi - NARROWEST) / (WIDEST - NARROWEST),
            ]
        return np.clip(point, 0.0, 1.0)

    def _below(self, seat: float) -> tuple[float, ...]:
        """The diameters of the smaller journal, with the largest as it is, mm."""
        most = self.problem.seats({self.problem.seat: seat})
        small = self.problem.keys.of_bearing(self.problem.small, BearingRow.diameter)
        return tuple(d for d in self.problem.sizes[small] or () if d <= most + 1e-9)

    def _lengths(self, d: float) -> tuple[float, float]:
        """The shortest and the longest journal of a diameter, mm."""
        low, high = (ratio * d for ratio in USUAL_LENGTH_RATIO)
        return max(low, self.width + LENGTH_STEP), high

    def sized(self, x: Array) -> Sized:
        """The drive at a point: class, surfaces, core, diameters, then of each journal l/d and clearance over
        diameter."""
        problem, sizes, keys = self.problem, self.problem.sizes, self.problem.keys
        seat = _at(sizes[keys.of_bearing(problem.seat, BearingRow.diameter)] or (), x[3])
        below = self._below(seat)
        diameter = {problem.seat: seat, problem.small: _at(below or (seat,), x[4])}
        length, clearance = {}, {}
        for place, (u, v) in zip(keys.places, ((x[5], x[6]), (x[7], x[8]))):
            if place in problem.rolling:
                _, length[place], _ = problem.rolling[place]
                clearance[place] = 0.0
                continue
            d, given = diameter[place], sizes[keys.of_bearing(place, BearingRow.length)]
            low, high = self._lengths(d)
            steps = min(round((low + u * (high - low)) / LENGTH_STEP), int(high / LENGTH_STEP + 1e-9))
            length[place] = _at(given, u) if given else steps * LENGTH_STEP
            clearance[place] = round((NARROWEST + v * (WIDEST - NARROWEST)) * d * 1e3 / CLEARANCE_STEP) * CLEARANCE_STEP
        return Sized(
            _at(tuple(problem.classes), x[0]),
            _at(sizes[keys.core] or (), x[2]),
            diameter,
            length,
            clearance,
            _at(problem.surfaces, x[1]),
        )

    def scored(self, x: Array) -> tuple[Array, float]:
        """Objectives, each to be small, and by how much the limits are broken."""
        sized = self.sized(x)
        key = (
            str(sized.choices),
            sized.core,
            *sized.diameter.values(),
            *sized.length.values(),
            *sized.clearance.values(),
            sized.surface,
        )
        if key not in self.known:
            drive, results = whole(self.problem, sized, self.before)
            self.before = results or self.before
            self.known[key] = drive, _row(self.problem, drive), drive.lacks
        _, row, broken = self.known[key]
        return row, broken

    def found(self) -> FrontFound:
        problem, every = self.problem, list(self.known.values())
        good = [(drive, row) for drive, row, _ in every if not drive.broken]
        units = np.array([problem.units[name] for name in problem.objectives])
        rows = np.array([row for _, row in good]).reshape(-1, len(problem.objectives))
        kept = front(np.round(rows, 9)) if len(good) else np.zeros(0, dtype=int)
        chosen = representatives(rows[kept], units, problem.rows)
        drives = sorted(
            (good[int(kept[n])][0] for n in chosen), key=lambda drive: (drive.objectives["power"], str(drive.changes))
        )
        worst = sorted((entry for entry in every if entry[0].broken), key=lambda entry: entry[2])[:10]
        known = FrontTable(no_rows(), np.zeros(0, dtype=int), rows[kept], len(every), ())
        return FrontFound(
            problem, known, tuple(drives), tuple(drive for drive, _, _ in worst), len(problem.classes), proved=False
        )


def _at(values: tuple[Any, ...], share: float) -> Any:
    return values[min(int(share * len(values)), len(values) - 1)]


def _share(values: tuple[float, ...], there: float) -> float:
    """The middle of the place among the values that is nearest to one."""
    return (min(range(len(values)), key=lambda n: abs(values[n] - there)) + 0.5) / len(values) if values else 0.0


def _row(problem: Problem, drive: Whole) -> Array:
    if not drive.objectives:
        return np.full(len(problem.objectives), 1e9)
    return np.array([(-1 if name == "margin" else 1) * drive.objectives[name] for name in problem.objectives])
