# SPDX-License-Identifier: Apache-2.0
"""What the runs of a design come to: for each column a verdict, its values, a check, a figure and a table.

All of it is made when somebody looks: the design is solved at every node."""

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from ..measurements.residuals import METHOD, Residuals, residuals
from ..sheet.arrays import Array
from ..sheet.check import Check, Missing
from ..sheet.curve import Curve, MeasuredPoints, Series, axis_label
from ..sheet.quantity import Described, Published, Stated, dotted, published
from ..sheet.record import record, replace
from ..sheet.step import Table
from ..sheet.text import COMMA, EMPTY, SEMICOLON, SPACE, Amount, Name, Text, plural
from ..sheet.units import UNITS
from .model import Design
from .predicted_runs import Solve, Solved, Target, predictions, targets

MEASURED = "measured"  # how the ids of values and checks begin
DIFFERENCES = {"°C": "K"}  # the unit of a difference, where it is another


@record
class ColumnResult:
    """One column of a run beside what is predicted of it."""

    target: Target
    predicted: Array
    found: Residuals
    step: str  # the key of the step that it is of
    title: Text  # of that step
    accepted: str = ""

    @property
    def id(self) -> str:
        return self.target.id

    @property
    def unit(self) -> str:
        """Of residuals."""
        return DIFFERENCES.get(self.target.unit, self.target.unit)

    @property
    def nodes(self) -> int:
        """At which something was measured."""
        return int(np.isfinite(self.target.y).sum())

    @property
    def lost(self) -> int:
        """Of them those at which nothing is predicted."""
        return self.nodes - self.found.used

    @property
    def weightless(self) -> int:
        """Of those that are compared the ones whose uncertainty is 0, beside others that have one: they have no part in
        χ²."""
        sigma = self.target.sigma
        if sigma is None or self.found.chi2_reduced is None:
            return 0
        return int((np.isfinite(self.found.r) & ~(sigma > 0)).sum())

    @property
    def words(self) -> Text:
        """`P agrees, bias −1.2 W (7 nodes)`."""
        parts = [Text("{column} {verdict}", column=Name(self.target.column), verdict=self.found.words)]
        if self.found.bias is not None:
            bias = Amount(self.found.bias, self.unit, form="+.3g")
            parts.append(Text("bias {bias}", bias=bias))
        if self.accepted:
            parts.append(Text("accepted: {reason}", reason=Name(self.accepted)))
        nodes = plural("{n} node", "{n} nodes", n=self.nodes)
        if self.lost:
            nodes += Text(", at {n} of them nothing is predicted", n=self.lost)
        if self.weightless:
            nodes += Text(", {n} of them not judged: their uncertainty is 0", n=self.weightless)
        return Text("{words} ({nodes})", words=COMMA.join(parts), nodes=nodes)

    @property
    def sentence(self) -> Text:
        """The verdict, and by what."""
        found, unit = self.found, self.unit
        if not found.used:
            return Text("Nothing is predicted at any node of {column}.", column=Name(self.target.column))
        words = [
            Text(
                "{column} ({step}: {label}) {verdict}: predicted less measured is {bias} in the mean, {rms} rms, "
                "over {nodes}.",
                column=Name(self.target.column),
                step=self.title,
                label=self.target.label,
                verdict=found.words,
                bias=Amount(found.bias or 0.0, unit, form="+.3g"),
                rms=Amount(found.rms or 0.0, unit, form=".3g"),
                nodes=plural("{n} node", "{n} nodes", n=found.used),
            )
        ]
        if found.chi2_reduced is not None and found.judged_by is not None:
            low, high = found.judged_by
            words.append(
                Text(
                    "χ² over the number of nodes is {chi}; 95 % of what the uncertainties give by chance is {low} to "
                    "{high}.",
                    chi=Amount(found.chi2_reduced, form=".3g"),
                    low=Amount(low, form=".3g"),
                    high=Amount(high, form=".3g"),
                )
            )
        if self.lost:
            words.append(plural("At {n} node nothing is predicted.", "At {n} nodes nothing is predicted.", n=self.lost))
        if self.weightless:
            words.append(
                plural(
                    "{n} node has no part in χ²: its uncertainty is 0.",
                    "{n} nodes have no part in χ²: their uncertainty is 0.",
                    n=self.weightless,
                )
            )
        return SPACE.join(words)

    def numbers(self) -> dict[str, Stated]:
        """The values, by the last words of their ids."""
        found, inside = self.found, UNITS[self.unit].inside
        of = Text("{run}, {column}", run=Name(self.target.run), column=Name(self.target.column))
        listed = [
            ("bias", "Predicted less measured, {of}", self.unit, found.bias),
            ("rms", "Residual, rms, {of}", self.unit, found.rms),
            ("chi2_reduced", "χ² over the number of nodes, {of}", "", found.chi2_reduced),
            ("used", "Nodes that are compared, {of}", "", float(found.used)),
            ("runs_z", "Runs of the residuals, in standard deviations from chance, {of}", "", found.runs_z),
        ]
        return {
            name: Stated(Described(Text(label, of=of), unit), inside(number))
            for name, label, unit, number in listed
            if number is not None
        }

    @property
    def check(self) -> Check:
        """Of the kind method: a measurement judges the calculation, never the part."""
        found, at = self.found, (self.target.run, self.target.column)
        name = Text("{run}: {column}", run=Name(self.target.run), column=Name(self.target.column))
        missing = None
        if found.chi2_reduced is None:
            missing = Missing((dotted(Design.measurements, self.target.run),), (), "none", "none")
        made = METHOD(
            found.chi2_reduced,
            found.judged_by or (0.0, 1.0),
            at=at,
            name=Text("{name} {verdict}", name=name, verdict=found.words),
            value_id=f"{self.id}.chi2_reduced" if found.chi2_reduced is not None else "",
            missing=missing,
        )
        return replace(made, cause=self.step, accepted=self.accepted)

    # --- what is drawn, and the table
    @property
    def curve(self) -> Curve:
        """What is predicted over speed, the points with their bars on it."""
        x, there = self.target.nodes.speed * 60, np.isfinite(self.target.y)
        y, bars = self.target.y[there], self._bars[there]
        points = MeasuredPoints(Text("measured"), x[there], y, bars, self.found.r[there])
        return Curve(
            self.id,
            Text(
                "{run}: {column}, {label}, measured (points) on what is predicted (line)",
                run=Name(self.target.run),
                column=Name(self.target.column),
                label=self.target.label,
            ),
            axis_label("Crank speed", "rpm"),
            Text("{label}, {unit}", label=self.target.label, unit=self.target.unit)
            if self.target.unit
            else self.target.label,
            (Series(Text("predicted"), x[there], self.predicted[there]),),
            measured=points,
            stack=self.id,
        )

    @property
    def strip(self) -> Curve:
        """The residuals below it, with the same bars."""
        x, there = self.target.nodes.speed * 60, np.isfinite(self.found.r)
        points = MeasuredPoints(Text("residual"), x[there], self.found.r[there], self._bars[there], self.found.r[there])
        title = (
            Text("Predicted less measured, {unit}", unit=self.unit) if self.unit else Text("Predicted less measured")
        )
        return Curve(
            f"{self.id}.residual",
            Text("Predicted less measured"),
            axis_label("Crank speed", "rpm"),
            title,
            (Series(EMPTY, x[there], np.zeros(int(there.sum()))),),
            measured=points,
            stack=self.id,
        )

    @property
    def _bars(self) -> Array:
        """One standard uncertainty either way, the common one with it."""
        sigma, common = self.target.sigma, self.target.common
        nothing = np.full(self.target.y.shape, np.nan)
        if sigma is None:
            return nothing
        whole: Array = np.hypot(sigma, common if common is not None else 0.0)
        return whole

    @property
    def table(self) -> Table:
        """Node by node."""
        target, nodes = self.target, self.target.nodes
        unit, conditions = target.unit, target.conditions
        columns = [(Text("Speed"), "rpm"), *((Name(key), "") for key in conditions), (Text("Rows"), "")]
        columns += [(Text("Measured"), unit), (Text("Uncertainty"), self.unit)]
        if target.common is not None:
            columns.append((Text("Common"), self.unit))
        columns += [(Text("Predicted"), unit), (Text("Predicted less measured"), self.unit), (Text("Residual"), "σ")]
        rows = []
        for i in np.flatnonzero(np.isfinite(target.y)).tolist():
            sigma = None if target.sigma is None else _number(target.sigma[i])
            r = _number(self.found.r[i])
            row: list[str | float | None] = [float(nodes.speed[i]) * 60]
            row += [float(numbers[i]) for numbers in conditions.values()]
            row += [float(nodes.rows[i]), float(target.y[i]), sigma]
            if target.common is not None:
                row.append(_number(target.common[i]))
            row += [_number(self.predicted[i]), r, r / sigma if r is not None and sigma else None]
            rows.append(tuple(row))
        named = dict(run=Name(target.run), column=Name(target.column), label=target.label)
        title = Text("{run}: {column}, {label}", **named)
        return Table(f"{self.id}.nodes", title, tuple(columns), tuple(rows), self.sentence)


def _number(x: float) -> float | None:
    return float(x) if np.isfinite(x) else None


@record
class RunResults:
    """All runs of a design: of each the columns whose values the design has."""

    design: Design
    columns: tuple[ColumnResult, ...]

    def of_step(self, step: str) -> list[ColumnResult]:
        return [column for column in self.columns if column.step == step]

    def of_run(self, run: str) -> list[ColumnResult]:
        return [column for column in self.columns if column.target.run == run]

    @cached_property
    def values(self) -> tuple[Published, ...]:
        """`measured.RUN.COLUMN.bias` and the others."""
        tree: dict[str, dict[str, Any]] = {}
        for column in self.columns:
            tree.setdefault(column.target.run, {})[column.target.column] = column.numbers()
        return tuple(published(tree, MEASURED))

    @cached_property
    def checks(self) -> tuple[Check, ...]:
        return tuple(column.check for column in self.columns)

    def lines(self, step: str | None = None) -> Iterator[Text]:
        """One a run: `drag-run: P agrees, bias −1.2 W (7 nodes)`; `step`: what is of that alone."""
        for run in self.design.measurements:
            found = self.of_run(run.name)
            words = [column.words for column in found if step in (None, column.step)]
            known = {column.target.column for column in found}
            for name, column in zip(run.column_names, run.columns):
                if name not in known and step in (None, self.design.step_of(column.value[0])):
                    words.append(Text("{column} waits for a step without a solution", column=Name(name)))
            if words:
                yield Text("{run}: {columns}", run=Name(run.name), columns=SEMICOLON.join(words))


def run_results(design: Design, solved: Solved, solve: Solve) -> RunResults:
    """Solve a design at the nodes of its runs, and compare.  `solved`: its results as it is."""
    wanted = targets(design, solved)
    reasons = dict(design.accepted)
    found = []
    for target, predicted in zip(wanted, predictions(design, wanted, solve, solved)):
        column = target.nodes.columns[target.column]
        compared = residuals(predicted, column, target.y, target.sigma, target.common)
        step = design.step_of(target.value[0])
        found.append(ColumnResult(target, predicted, compared, step, design.title(step), reasons.get(target.id, "")))
    return RunResults(design, tuple(found))


def with_runs_of(design: Design, others: Sequence[Design]) -> Design:
    """A design with the runs of others too, of one name those of the first."""
    measurements = {run.name: (run, rows) for each in (design, *others[::-1]) for run, rows in _pairs(each)}
    measurements |= {run.name: (run, rows) for run, rows in _pairs(design)}
    both = tuple(measurements.values())
    return replace(design, measurements=tuple(run for run, _ in both), runs=tuple(rows for _, rows in both))


def _pairs(design: Design) -> Iterator[tuple[Any, Any]]:
    yield from zip(design.measurements, design.runs)
