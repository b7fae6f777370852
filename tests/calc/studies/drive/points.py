# SPDX-License-Identifier: Apache-2.0
"""Single drives out of the tables of a class: what these say of one, and the same drive solved whole."""

from dataclasses import dataclass, field, replace

import numpy as np

from calc.bearings.plain.routes.thermal_balance import settled
from calc.bearings.result import BearingsResult
from calc.countershaft.result import CountershaftResult
from calc.sheet.value import untraced
from calc.studies.drive.classes import tables_of
from calc.studies.drive.search import asked
from calc.studies.drive.shafts import journal_mass, journal_slopes, shafts
from calc.studies.drive.solved_drive import Sized, journals_power, whole

PLACES = ("front", "rear")


@dataclass
class Point:
    """One drive: its core, and of each journal the table with the places of length and clearance; m."""

    core: float
    journals: tuple
    surface: int = 0

    def sized(self, problem, choices):
        mm, um = lambda x: round(float(x) * 1e3, 6), lambda x: round(float(x) * 1e6, 6)
        of = dict(zip(PLACES, self.journals))
        return Sized(
            choices,
            mm(self.core),
            {p: mm(f.task.diameter) for p, (f, _, _) in of.items()},
            {p: mm(f.length[i]) for p, (f, i, _) in of.items()},
            {p: um(f.clearance[j]) for p, (f, _, j) in of.items()},
            problem.surfaces[self.surface],
        )


@dataclass
class Said:
    """What the tables say: whether it passes at no margin, what it lacks of slope (below 0: what is left), slopes,
    mass, power."""

    passes: bool
    lacks: float
    slopes: tuple
    mass: float
    power: float


class Class:
    """A class of a problem with its tables."""

    def __init__(self, document, said, n=0):
        self.problem, _ = asked(document, said)
        self.choices = self.problem.classes[n]
        with untraced():
            self.drive, self.sizes = tables_of(self.problem, self.choices)
        self.before = None

    def said(self, point, margin=0.0):
        (f, i_f, j_f), (r, i_r, j_r) = point.journals
        d_f, d_r = f.task.diameter, r.task.diameter
        l_f, l_r = np.array([f.length[i_f]]), np.array([r.length[i_r]])
        with untraced(), np.errstate(all="ignore"):
            shaft = shafts(self.drive, np.array([point.core]), (l_f, l_r), max(d_f, d_r))
            own = [journal_slopes(self.drive, n, d, l) for n, (d, l) in enumerate(((d_f, l_f), (d_r, l_r)))]
        journals = journal_mass(self.drive, d_f, l_f)[0] + journal_mass(self.drive, d_r, l_r)[0]
        mass = float(shaft.mass[0, 0, 0] + journals)
        still = [shaft.slopes[n][0, 0, 0] + own[0][n][0] + own[1][n][0] for n in (0, 1)]
        slopes = tuple(float(self.drive.turning(n, mass, still[n])) for n in (0, 1))
        borne = [
            t.bears(self.sizes.asked(t, point.surface), margin, self.sizes.limit)[j, i] for t, i, j in point.journals
        ]
        lacks = max((s - b) / self.sizes.limit for s, b in zip(slopes, borne))
        fits = bool(shaft.fits[0, 0, 0]) and lacks == lacks
        return Said(
            fits and lacks <= 0, lacks if fits else np.inf, slopes, mass, float(f.power[j_f, i_f] + r.power[j_r, i_r])
        )

    def random(self, rng):
        """A drive of the ranges whose journals each bear some slope in some shaft."""
        tables = {place: [f for f in self.sizes.films[place] if self._bearing(f).any()] for place in PLACES}
        while True:
            f, r = (tables[place][rng.integers(len(tables[place]))] for place in PLACES)
            big, small = (r, f) if self.sizes.seat == "rear" else (f, r)
            if small.task.diameter <= big.task.diameter + 1e-9:
                break
        return Point(
            float(rng.choice(self.sizes.core)),
            (self._place(f, rng), self._place(r, rng)),
            int(rng.integers(len(self.sizes.surfaces))),
        )

    def _bearing(self, table):
        return table.kept & (table.bears(self.sizes.asked(table, 0), 0.0, self.sizes.limit) > 0)

    def _place(self, table, rng):
        places = np.argwhere(self._bearing(table))
        j, i = places[rng.integers(len(places))]
        return table, int(i), int(j)

    def near(self, rng, passes, tries=5000):
        """One that passes, or that misses by not much; None: none was found."""
        for _ in range(tries):
            point = self.random(rng)
            said = self.said(point)
            if said.passes if passes else 0 < said.lacks < 0.15:
                return point, said
        return None

    def whole(self, point):
        one, results = whole(self.problem, point.sized(self.problem, self.choices), self.before)
        self.before = results or self.before
        return one, results


@dataclass
class Differences:
    """Of what tables say from what the whole solution says, of some drives.

    The tables know each journal under the load that the shaft of the class's start puts on it, which bends otherwise.
    `load`: by how much that is more than the drive's own; `film`: power of a journal, W, under the load of its table
    both ways; `power` of both journals under what each way has for load; `mass`, `slopes`.  But for `film` shares."""

    load: list = field(default_factory=list)
    film: list = field(default_factory=list)
    power: list = field(default_factory=list)
    mass: list = field(default_factory=list)
    slopes: list = field(default_factory=list)

    def small(self, slope):
        """As docs/drive.md promises; `slope`: by how much one may be above, it is never below."""
        return (
            max(map(abs, self.film)) <= 0.003
            and -2e-4 <= min(self.load)
            and max(self.load) <= 1e-3
            and -2e-5 <= min(self.power)
            and max(self.power) <= 3e-4
            and max(map(abs, self.mass)) <= 1e-6
            and -1e-9 <= min(self.slopes)
            and max(self.slopes) <= slope
        )

    def __str__(self):
        return ", ".join(f"{name} {min(some):.3g} to {max(some):.3g}" for name, some in vars(self).items())

    def add(self, point, said, results):
        shaft, bearings = results.result(CountershaftResult), results.result(BearingsResult).bearings
        for place, (table, i, j) in zip(PLACES, point.journals):
            r, load = bearings[place], table.task.duty.load
            with untraced():
                alike = settled(r.seat, replace(r.duty, load=np.array([load])))
            self.load.append(load / r.load - 1)
            self.film.append(float(table.power[j, i] - alike.friction_power[0]))
        self.power.append(said.power / journals_power(results) - 1)
        self.mass.append(said.mass / shaft.mass - 1)
        self.slopes += [a / b - 1 for a, b in zip(said.slopes, shaft.slopes.values(), strict=True)]


def compared(of, count, seed=0):
    """Random drives by both ways: how often they agree and, of those that fail whole alone, on what; and how they
    differ."""
    rng, both, misses, differences = np.random.default_rng(seed), {True: 0, False: 0}, [], Differences()
    for n in range(count):
        found = of.near(rng, n % 2 == 0) or of.near(rng, n % 2 == 1)
        assert found is not None
        point, said = found
        one, results = of.whole(point)
        if one.objectives:
            differences.add(point, said, results)
        if said.passes == (not one.broken):
            both[said.passes] += 1
        else:
            misses.append((said.passes, one.broken, one.changes))
    return both, misses, differences
