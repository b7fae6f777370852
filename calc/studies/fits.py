# SPDX-License-Identifier: Apache-2.0
"""The fits of a design: inputs found from its runs of the bench.

The model of a fit is the program itself, solved at every node of its runs with the free inputs changed."""

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from ..bearings.plain.row import PlainRow
from ..design.addresses import quantity_of, value_at
from ..design.labels import label_of
from ..design.model import Design
from ..design.names import published
from ..design.predicted_runs import Target, changed_design, predictions, targets
from ..design.toml_file import Document, design, mistaken
from ..measurements.fit_inputs import FitInputs, FreeInput
from ..measurements.fit_words import FreeName
from ..measurements.fitting import OF_DESIGN, FitRows, Floats, FreeNumber, fitted
from ..mounting.inputs import Mount, Support
from ..sheet.errors import BadInput, InputError, NoSolution
from ..sheet.progress import Progress, part, tell
from ..sheet.quantity import described, dotted
from ..sheet.step import Outcome
from ..sheet.text import COMMA, Amount, Text, plural
from ..solve import Results, solve
from .fit_results import DesignFit

# inputs of one thing, of which a table has one at most
EXCLUSIVE = (
    (PlainRow.clearance, PlainRow.clearance_factor),
    (PlainRow.crush, PlainRow.interference),
    (Mount.damping, Mount.loss_factor),
    (Support.damping, Support.loss_factor),
)


def fits_of(document: Document, results: Results, progress: Progress | None = None) -> dict[str, DesignFit | Text]:
    """All fits of a design by their names, in its order; of one that ended on its way why."""
    found: dict[str, DesignFit | Text] = {}
    fits = results.design.fits
    for n, fit in enumerate(fits):
        try:
            found[fit.name] = fit_of(document, fit.name, results, part(progress, n / len(fits), (n + 1) / len(fits)))
        except NoSolution as none:
            found[fit.name] = none.text
    return found


def fit_of(
    document: Document, name: str, results: Results | None = None, progress: Progress | None = None
) -> DesignFit:
    """The fit of that name.  `results`: of the design, where they are known.

    Raises BadInput for what keeps it from being begun, NoSolution for a design on its way that can not be predicted at
    a node."""
    fit, place, base = _named(document, name)
    results = results or solve(base)
    results.demand_runs(document)
    return _Fitting(document, base, fit, place, results).solved(progress)


def _named(document: Document, name: str) -> tuple[FitInputs, str, Design]:
    base = design(document)
    for n, fit in enumerate(base.fits):
        if fit.name == name:
            return fit, dotted(Design.fits, n), base
    known = ", ".join(fit.name for fit in base.fits)
    there = Text("there are {names}", names=known) if known else Text("there is none: add [[fits]]")
    raise BadInput(document.place, [InputError(0, "NAME", name, Text("is no fit of this design; ") + there)])


class _Fitting:
    """A fit on its way: its free inputs in the units of their keys, its rows in those of their values."""

    def __init__(self, document: Document, base: Design, fit: FitInputs, place: str, results: Results) -> None:
        self.document, self.base, self.fit, self.place, self.results = document, base, fit, place, results
        self.runs = tuple(base.runs_of(fit))
        keys = [row.key for row in fit.free]
        self.replaced = tuple(other for key in keys for other in _replaced(document, key) if other not in keys)
        self.names = tuple(
            FreeName(key, label_of(document.data, key), quantity_of(document.data, key).unit) for key in keys
        )
        self.free = tuple(
            FreeNumber(row.key, row.low, row.high, self._start(row), row.prior, row.prior_sd) for row in fit.free
        )
        self.early = False  # whether what is wanted is known before the gears are rated
        self.asked_more = False  # whether a solve had not what is wanted, so that another was asked for
        self._solved: dict[tuple[float, bool], Results] = {}  # what a change leaves as it is, is taken over

    def _start(self, row: FreeInput) -> float:
        """Where the search begins: as given, else what the design has, else in the middle."""
        if row.start is not None:
            return row.start
        there = self._now(row)
        return there if there is not None and row.low <= there <= row.high else (row.low + row.high) / 2

    def _now(self, row: FreeInput) -> float | None:
        """What the design has, given or computed."""
        there = value_at(self.document.data, row.key)
        if there is None and (chosen := published(self.results, row.key)) is not None:
            there = chosen.shown
        return float(there) if isinstance(there, (int, float)) else None

    def solved(self, progress: Progress | None) -> DesignFit:
        self._demand_designs()
        wanted, left_out = self._wanted()
        rows, data, more = self._rows(wanted)
        count = data.measured.size + sum(free.prior is not None for free in self.free)
        if count <= len(self.free):
            few = Text(
                "has {rows} rows, those of priors among them, for {free} free inputs: needs more rows, or fewer inputs",
                rows=count,
                free=len(self.free),
            )
            raise self._bad(dotted(self.place, FitInputs.free), few)
        model = _Model(self, wanted, rows, progress)
        result = fitted(model, data, self.free, OF_DESIGN)
        if self.early and not self._same_early(result.values, wanted):
            self.early = False
            result = fitted(model, data, self.free, OF_DESIGN)
        return DesignFit(
            self.fit.name,
            self.runs,
            self.names,
            tuple(map(self._now, self.fit.free)),
            self.replaced,
            {target.id: int(some.sum()) for target, some in zip(wanted, rows)},
            wanted[0].unit if len({target.unit for target in wanted}) == 1 else "",
            (*left_out, *more),
            result,
        )

    def changed(self, numbers: Iterable[float]) -> Design:
        """The design with the free inputs at these numbers."""
        free = {name.key: float(number) for name, number in zip(self.names, numbers)}
        return changed_design(self.base, {**dict.fromkeys(self.replaced), **free})

    def predicted(self, numbers: Iterable[float], wanted: Sequence[Target]) -> list[Floats]:
        return predictions(self.changed(numbers), wanted, self._solve)

    def _solve(self, design: Design, before: Results | None = None, *, compared: bool = False) -> Results:
        self.asked_more |= compared
        early = self.early and not compared
        at = design.engine.rated_speed if design.engine is not None else 0.0, early
        known = self._solved.get(at)
        if known is None or compared or known.design != design:
            self._solved[at] = solve(design, known, compared=compared, enough=_has_friction if early else None)
        return self._solved[at]

    def _same_early(self, numbers: Iterable[float], wanted: Sequence[Target]) -> bool:
        """Whether what is wanted is the same where a solve ends with the friction, before the gears are rated."""
        at = tuple(numbers)
        found = []
        for self.early in (False, True):
            self.asked_more = False
            found.append(self.predicted(at, wanted))
        return not self.asked_more and all(np.array_equal(a, b, equal_nan=True) for a, b in zip(*found))

    def _bad(self, key: str, *reasons: Text) -> BadInput:
        wrong = mistaken(self.document, [(key, reason) for reason in reasons])
        assert wrong is not None
        return wrong

    def _demand_designs(self) -> None:
        """Raises BadInput where the design can not have a free input at its start, or at an end of its range."""
        start = {free.name: free.start for free in self.free}
        ends = [(i, name, x) for i, f in enumerate(self.free) for name, x in (("low", f.low), ("high", f.high))]
        for i, end, number in [(0, "start", self.free[0].start), *ends]:
            document = self.document
            for key, x in {**dict.fromkeys(self.replaced), **start, self.free[i].name: number}.items():
                document = document.with_value(key, x)
            try:
                design(document, (self.document, self.base))
            except BadInput as bad:
                wrong = [
                    Text("{key}: {reason}", key=error.called or error.key, reason=error.reason) for error in bad.errors
                ]
                raise self._bad(dotted(self.place, FitInputs.free, i, end), *wrong) from None

    def _wanted(self) -> tuple[list[Target], list[Text]]:
        """The columns that are fitted, and what is said of others.  Raises BadInput where they can not stand
        together."""
        wanted = targets(self.base, self.results, self.runs)
        known, free = [t for t in wanted if t.sigma is not None], [t for t in wanted if t.sigma is None]
        of = dotted(self.place, FitInputs.of)
        if known and free:
            mixed = Text(
                "has columns with and without uncertainty, whose weights can not be compared: give one of {columns}, "
                "or put it in a run of its own",
                columns=", ".join(target.id for target in free),
            )
            raise self._bad(of, mixed)
        if len({target.unit for target in free}) > 1:
            unlike = Text(
                "has columns without uncertainty in unlike units, whose weights can not be compared: give an "
                "uncertainty of each of {columns}",
                columns=", ".join(target.id for target in free),
            )
            raise self._bad(of, unlike)
        for i, row in enumerate(self.fit.free):
            if free and row.prior is not None:
                weight = Text("a prior has no weight beside columns without uncertainty: give that of the columns")
                raise self._bad(dotted(self.place, FitInputs.free, i, FreeInput.prior), weight)
        there = {target.id for target in wanted}
        runs = (run for run in self.base.measurements if run.name in self.runs)
        lost = [id for run in runs for id in run.column_ids if id not in there]
        return wanted, [Text("{column} is left out: this design has no such value", column=column) for column in lost]

    def _rows(self, wanted: Sequence[Target]) -> tuple[list[NDArray[np.bool_]], FitRows, list[Text]]:
        """Which nodes of each column are fitted, what was measured there, and what is said of others."""
        at = [free.start for free in self.free]
        self.early = self._same_early(at, wanted)
        start = self.predicted(at, wanted)
        rows, said = [], []
        for target, there in zip(wanted, start):
            measured = np.isfinite(target.y)
            weightless = measured & ~(target.sigma > 0) if target.sigma is not None else np.zeros_like(measured)
            unsolved = measured & ~np.isfinite(there)
            for lost, why in (
                (weightless, Text("their uncertainty is 0")),
                (unsolved & ~weightless, Text("the design has no such value there where the fit begins")),
            ):
                if n := int(lost.sum()):
                    parts = dict(column=target.id, why=why)
                    said.append(
                        plural(
                            "{n} node of {column} is left out: {why}",
                            "{n} nodes of {column} are left out: {why}",
                            n,
                            **parts,
                        )
                    )
            rows.append(measured & ~weightless & ~unsolved)
        y = _joined([target.y for target in wanted], rows)
        if any(target.sigma is None for target in wanted):
            return rows, FitRows(y), said
        sigma = _joined([target.sigma for target in wanted if target.sigma is not None], rows)
        zero = [np.zeros(target.y.shape) for target in wanted]
        common = tuple(
            _joined([*zero[:n], target.common, *zero[n + 1 :]], rows)
            for n, target in enumerate(wanted)
            if target.common is not None
        )
        return rows, FitRows(y, sigma, tuple(b for b in common if b.any())), said


class _Model:
    """What the design predicts in the rows of a fit, of several sets of its free inputs."""

    def __init__(
        self, fitting: _Fitting, wanted: Sequence[Target], rows: Sequence[NDArray[np.bool_]], progress: Progress | None
    ) -> None:
        self.fitting, self.wanted, self.rows, self.progress = fitting, wanted, rows, progress
        self.done = 0

    def __call__(self, points: Sequence[Floats]) -> list[Floats]:
        return [self.at(numbers) for numbers in points]

    def at(self, numbers: Floats) -> Floats:
        names, usual = self.fitting.names, 12 * (1 + 2 * len(numbers))
        at = COMMA.join(_at(name, number) for name, number in zip(names, numbers))
        tell(self.progress, 1 - 0.5 ** (2 * self.done / usual), Text("with {at}", at=at))
        found = self.fitting.predicted(numbers, self.wanted)
        self.done += 1
        for target, there, some in zip(self.wanted, found, self.rows):
            lost = some & ~np.isfinite(there)
            if lost.any():
                speed = Amount(float(target.nodes.speed[lost][0]) * 60, "rpm")
                raise NoSolution(
                    Text("with {at} the design has no {column} at {speed}", at=at, column=target.id, speed=speed),
                    advice=Text("narrow the ranges of the fit, so that the design has one everywhere in them"),
                )
        return _joined(found, self.rows)


def _has_friction(outcome: Outcome[object]) -> bool:
    return outcome.key == dotted(Design.friction)


def _at(name: FreeName, number: float) -> Text:
    return Text("{label} {value}", label=name.label, value=Amount(number, name.unit))


def _joined(columns: Sequence[Floats], rows: Sequence[NDArray[np.bool_]]) -> Floats:
    return np.concatenate([column[some] for column, some in zip(columns, rows)]) if columns else np.array([])


def _replaced(document: Document, key: str) -> list[str]:
    """The keys that stand in a table and can not stand beside this one."""
    about, table = quantity_of(document.data, key), key.rpartition(".")[0]
    others = []
    for pair in EXCLUSIVE:
        if about in map(described, pair):
            others += [dotted(table, field) for field in pair if described(field) is not about]
    return [other for other in others if value_at(document.data, other) is not None]
