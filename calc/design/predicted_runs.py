# SPDX-License-Identifier: Apache-2.0
"""What a design gives at the nodes of its runs: solved at each speed, with the conditions that the run had there.

`solve` stands above this room and is handed in; `Solved` is what it gives (`Results`)."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from ..measurements.inputs import MeasuredColumn, Measurement
from ..measurements.nodes import Nodes, nodes_of
from ..measurements.units import conversion, listed
from ..mounting.at_speeds import MEASURED, AtMeasuredSpeed, unit_of
from ..sheet.arrays import Array
from ..sheet.inputs_at import content_at, with_content
from ..sheet.quantity import Published, dotted, meant
from ..sheet.record import record, replace
from ..sheet.text import EMPTY, Name, Text
from ..sheet.value import recorded
from .model import Design
from .predicted import at_speed

Solved = Any
Solve = Callable[..., Solved]
PLUS = Text(" + ")


@record
class Target:
    """A column of a run, node by node in the unit of its value: what is to be predicted.  `y`, `sigma`, `common`: mean,
    standard uncertainty and the error that all nodes share (None: not given); NaN where nothing was measured.
    `conditions`: what inputs were, by their keys and in the units of these."""

    run: str
    column: str
    value: tuple[str, ...]  # ids of values or keys of inputs, whose sum it is
    unit: str
    label: Text
    nodes: Nodes
    conditions: Mapping[str, Array]
    y: Array
    sigma: Array | None
    common: Array | None

    @property
    def id(self) -> str:
        return f"measured.{self.run}.{self.column}"


class Source:
    """What the value of a column is in this design: its unit and label, and how it is read from what a node gives."""

    def __init__(self, design: Design, solved: Solved, id: str) -> None:
        self.id, self.problem, self.unit, self.label = id, EMPTY, "", Text("")
        values = solved.values()
        content, about = content_at(design, id)
        if id.startswith(MEASURED):
            found = unit_of(solved.outcomes["mounting"].result, id)
            if isinstance(found, Text):
                self.problem = found
            else:
                self.unit, self.label = found
        elif id in values:
            self.unit, self.label = values[id].unit, values[id].label
        elif about is not None and isinstance(content, (int, float)) and not isinstance(content, bool):
            self.unit, self.label = about.unit, about.label
        else:
            unsolved = solved.outcomes.get(design.step_of(id))
            if unsolved is not None and unsolved.state not in ("solved", "not_asked"):
                waits = Text("is not known while this step is not solved: {step}", step=design.step_of(id))
                self.problem = waits
            else:
                self.problem = Text("{id} is no value of this design, and no number in it", id=id) + meant(id, values)


def value_problems(design: Design, solved: Solved) -> Iterator[tuple[str, Text]]:
    """What is wrong with the columns of runs beside the values that there are: (key, reason).  Steps without a solution
    are no mistake of the run."""
    for n, run in enumerate(design.measurements):
        rows = next((rows for rows in design.runs if rows.name == run.name), None)
        for i, (column, name) in enumerate(zip(run.columns, run.column_names)):
            here = dotted(Design.measurements, n, Measurement.columns, i)
            sources = [Source(design, solved, id) for id in column.value]
            wrong = next((source.problem for source in sources if source.problem), None)
            if wrong is not None:
                states = {solved.outcomes[design.step_of(id)].state for id in column.value}
                if states <= {"solved", "not_asked"}:
                    yield dotted(here, MeasuredColumn.value), wrong
                continue
            units = {source.unit for source in sources}
            if len(units) > 1:
                unlike = Text("are in unlike units: {units}", units=", ".join(sorted(units)))
                yield dotted(here, MeasuredColumn.value), unlike
                continue
            if column.peak and not all("rms" in source.label for source in sources):
                yield dotted(here, MeasuredColumn.peak), Text("is for a value that is an rms, and this one is none")
            given = rows.columns[name].unit if rows is not None else None
            if given is not None and conversion(given, sources[0].unit) is None:
                other = Text(
                    "is of another dimension than the value, which is in {unit}; give one of {units}",
                    unit=sources[0].unit or "1",
                    units=listed(sources[0].unit),
                )
                if column.unit is None:  # the file says it, and nothing stands before the reason
                    other = Text("{given} {is_}", given=given or "1", is_=other)
                yield dotted(here, MeasuredColumn.unit), other


def targets(design: Design, solved: Solved, runs: Sequence[str] = ()) -> list[Target]:
    """The columns of these runs, none: of all, whose values the design has."""
    found = []
    for run, rows in zip(design.measurements, design.runs):
        if runs and run.name not in runs:
            continue
        inputs = {c.key: about for c in run.conditions if (about := content_at(design, c.key)[1]) is not None}
        nodes = nodes_of(rows, frozenset(key for key, about in inputs.items() if about.unit == "°C"))
        conditions = {key: about.units.all_shown(nodes.conditions[key]) for key, about in inputs.items()}
        for column, name in zip(run.columns, run.column_names):
            sources = [Source(design, solved, id) for id in column.value]
            here = nodes.columns[name]
            if any(source.problem or source.unit != sources[0].unit for source in sources):
                continue
            how = (1.0, 0.0) if here.unit is None else conversion(here.unit, sources[0].unit)
            if how is None:
                continue
            factor, zero = how
            found.append(
                Target(
                    run.name,
                    name,
                    column.value,
                    sources[0].unit,
                    sources[0].label if len(sources) == 1 else sum_label(sources),
                    nodes,
                    conditions,
                    factor * (here.y + zero),
                    None if here.sigma is None else abs(factor) * here.sigma,
                    None if here.common is None else factor * here.common,
                )
            )
    return found


def sum_label(sources: Sequence[Source]) -> Text:
    """Of what a sum is: `Oil flow, front + rear`, where the ids differ in one part alone; else all labels."""
    ids = [source.id.split(".") for source in sources]
    if len({len(id) for id in ids}) == 1 and len({str(source.label) for source in sources}) == 1:
        unlike = [parts for parts in zip(*ids) if len({*parts}) > 1]
        if len(unlike) == 1:
            return Text("{label}, {parts}", label=sources[0].label, parts=PLUS.join(map(Name, unlike[0])))
    return PLUS.join(source.label for source in sources)


def changed_design(design: Design, changes: Mapping[str, float | None]) -> Design:
    """The design with other numbers under these keys, each in the unit of its key; None leaves an input out.
    LookupError for a key that it has not."""
    for key, number in changes.items():
        about = content_at(design, key)[1]
        if about is None:
            raise LookupError(key)
        design = with_content(design, key, None if number is None else about.units.inside(number))
    return design


def predictions(
    design: Design,
    wanted: Sequence[Target],
    solve: Solve,
    solved: Solved = None,
    told: Callable[[float], None] | None = None,
) -> list[Array]:
    """What a design gives of each target, node by node in its unit; NaN where it finds no solution, or nothing was
    measured.

    `solved`: its results, where they are known.  `told` is told the share of the work that is done."""
    sheet = _Sheet(design, solve, solved)
    found = [np.full(target.y.shape, np.nan) for target in wanted]
    by_run: dict[str, list[int]] = {}
    for n, target in enumerate(wanted):
        by_run.setdefault(target.run, []).append(n)
    work = sum(wanted[some[0]].y.size for some in by_run.values())
    done = 0
    for some in by_run.values():
        nodes = wanted[some[0]].nodes
        for i in range(nodes.speed.size):
            here = [n for n in some if np.isfinite(wanted[n].y[i])]
            if here:
                for n, number in zip(here, sheet.at(nodes, i, [wanted[n].value for n in here])):
                    found[n][i] = number
            done += 1
            if told is not None:
                told(done / work)
    return found


class _Sheet:
    """A design at node after node: what one solve has in common with the next is taken over."""

    def __init__(self, design: Design, solve: Solve, solved: Solved) -> None:
        self.design = replace(design, measured=(), measurements=(), runs=())
        self.solve, self._solved = solve, solved
        self.before: Solved = None  # of the node before, of which unchanged parts are taken over
        self._at_nodes: dict[object, tuple[Design, Mapping[str, Published]]] = {}

    def solved(self) -> Solved:
        if self._solved is None:
            self._solved = self._solve(self.design, compared=True)
        return self._solved

    def _solve(self, design: Design, compared: bool = False) -> Solved:
        with recorded(False):
            return self.solve(design, self.before, compared=compared)

    @cached_property
    def _made(self) -> Any:
        """The values of which clearances are taken that are given as a factor; else none are needed."""
        rows = [row for view in self.design.views.values() for row in view.rows]
        if all(row.clearance_factor is None for row in rows):
            return {}
        return (self._solve(self.design) if self._solved is None else self._solved).values()

    def at(self, nodes: Nodes, i: int, wanted: Sequence[tuple[str, ...]]) -> list[float]:
        """What the design gives of these values at a node."""
        conditions = {key: float(numbers[i]) for key, numbers in nodes.conditions.items()}
        speed, ids = float(nodes.speed[i]), {id for value in wanted for id in value}
        felt = {id for id in ids if id.startswith(MEASURED)}
        numbers = self._felt(speed, conditions, felt) if felt else {}
        if ids - felt:
            numbers |= self._found(speed, conditions, ids - felt)
        return [float(sum(numbers[id] for id in value)) for value in wanted]

    def _found(self, speed: float, conditions: Mapping[str, float], ids: set[str]) -> dict[str, float]:
        """Of the design at that speed; two runs of one speed have one solve."""
        node = speed, tuple(sorted(conditions.items()))
        if node not in self._at_nodes:
            design = _under(at_speed(self.design, speed, self._made), conditions)
            self.before = self._solve(design)
            self._at_nodes[node] = design, self.before.values()
        design, values = self._at_nodes[node]
        # what other methods give beside those that judge
        if any(id not in values and id in self.solved().values() for id in ids):
            values = self._solve(design, compared=True).values()
            self._at_nodes[node] = design, values

        def number(id: str) -> float:
            if (there := values.get(id)) is not None:
                return float(there.shown)
            content, about = content_at(design, id)
            return about.units.shown(content) if about is not None and isinstance(content, (int, float)) else np.nan

        return {id: number(id) for id in ids}

    def _felt(self, speed: float, conditions: Mapping[str, float], ids: set[str]) -> dict[str, float]:
        """What mounts and points feel at that speed."""
        whole = self._solve(_under(self.design, conditions)) if conditions else self.solved()
        result = whole.outcomes["mounting"].result
        if result is None:
            return dict.fromkeys(ids, np.nan)
        there = AtMeasuredSpeed(result, speed)
        return {id: np.nan if (x := there.value(id)) is None else x for id in ids}


def _under(design: Design, conditions: Mapping[str, float]) -> Design:
    """A design with what inputs were on the bench, in SI."""
    for key, number in conditions.items():
        design = with_content(design, key, number)
    return design
