# SPDX-License-Identifier: Apache-2.0
"""Many designs at once: some inputs are varied over a grid, and every value and verdict of each design is a row.

The imbalance step computes all its rows in one call on arrays; the others are solved design by design, what did not change taken over.
"""

import csv
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass, replace
from itertools import product
from typing import TextIO, TypeVar

import numpy as np

from .addresses import address, quantity_of
from .design import Design
from .design_file import Document, design
from .engine import solve as engine
from .engine.inputs import EngineInputs
from .imbalance import checks as imbalance_checks
from .imbalance import solve as imbalance
from .imbalance.inputs import ImbalanceInputs
from .sheet.arrays import Array
from .sheet.check import step_verdict, worst
from .sheet.errors import BadInput, InputError
from .sheet.quantity import keys, published
from .sheet.text import Text
from .solve import Results, solve
from .step_inputs import shaft_axis, shaft_teeth

T = TypeVar("T")
Cell = float | str | None
MOST_ROWS = 1_000_000
SHOWN_ERRORS = 20
FORM = Text("must be KEY=LOW:HIGH:NUMBER or KEY=VALUE,VALUE,…, like engine.rated_speed_rpm=1000:3000:21")


@dataclass(frozen=True)
class Varied:
    """One input and the values that it takes, in the unit of its key."""

    key: str
    values: tuple[float | str, ...]


@dataclass(frozen=True)
class Swept:
    """`header` of the columns and the rows under it: inputs that were varied, values in shown units, verdicts.  None: no such value."""

    header: tuple[str, ...]
    rows: list[list[Cell]]
    verdicts: list[str]

    def write(self, file: TextIO) -> None:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(self.header)
        writer.writerows(["" if cell is None else cell for cell in row] for row in self.rows)


def varied(document: Document, texts: Sequence[str]) -> list[Varied]:
    """The inputs to vary, from their texts.  Raises BadInput with everything that is wrong in them."""
    found: list[Varied] = []
    errors: list[InputError] = []
    for text in texts:
        key, equals, said = (part.strip() for part in text.partition("="))
        try:
            about = quantity_of(document.data, key) if equals and said else None
            if about is None:
                raise BadInput("--vary", [InputError(0, text, "", FORM)])
            values = _values(said, about.kind in ("integer", "integers"), about.kind in ("text", "choice"))
            one = about.count is not None and about.count[0] == 1  # where one number may stand for the list
            if about.kind in ("series", "integers") and not one and not isinstance(address(document.data, key)[-1], int):
                raise ValueError(f"is a list; vary one of its numbers by its place, like {key}.0")
            if any(other.key == key for other in found):
                raise ValueError("stands twice; give all its values at once")
            found.append(Varied(key, values))
        except BadInput as bad:
            errors += [replace(e, key=f"--vary {e.key}") for e in bad.errors]
        except ValueError as wrong:
            errors.append(InputError(0, f"--vary {key}", said, Text("{wrong}", wrong=str(wrong))))
    rows = int(np.prod([len(v.values) for v in found])) if found else 0
    if rows > MOST_ROWS:
        errors.append(
            InputError(0, "--vary", "", Text("asks for {rows} designs; at most {most_rows} at once", rows=rows, most_rows=MOST_ROWS))
        )
    if errors:
        raise BadInput(document.place, errors)
    return found


def _values(said: str, whole: bool, words: bool) -> tuple[float | str, ...]:
    """`1000:3000:21` or `1000,1500,2000`."""
    parts = [part.strip() for part in said.split("," if "," in said or words else ":")]
    if words:
        return tuple(parts)
    try:
        numbers = [float(part) for part in parts]
    except ValueError:
        raise ValueError(FORM.partition(", like")[0]) from None
    if ":" in said:
        if len(numbers) != 3 or numbers[2] != int(numbers[2]) or numbers[2] < 1:
            raise ValueError("must be LOW:HIGH:NUMBER with a whole NUMBER of values, 1 or more")
        if numbers[2] > MOST_ROWS:
            raise ValueError(f"asks for {parts[2]} values; at most {MOST_ROWS} designs at once")
        if numbers[2] == 1 and numbers[0] != numbers[1]:
            raise ValueError("one value can not reach from LOW to HIGH; ask for 2 or more, or give the value alone")
        numbers = np.linspace(numbers[0], numbers[1], int(numbers[2])).tolist()
    if whole:
        if any(n != round(n) for n in numbers):
            raise ValueError(f"must be whole numbers here; these are {', '.join(f'{n:g}' for n in numbers[:6])}")
        return tuple(int(n) for n in numbers)
    return tuple(numbers)


def sweep(document: Document, inputs: Sequence[Varied], step: str | None = None, wanted: Sequence[str] = ()) -> Swept:
    """Every combination of the varied inputs, the last one changing fastest.

    `step`: only this step's values and verdict; `wanted`: only these values.  Raises BadInput where a combination is no valid design.
    """
    grid = list(product(*(v.values for v in inputs)))
    base = design(document)
    if step is not None and getattr(base, step) is None:
        raise BadInput(
            document.place, [InputError(0, "--step", step, Text("is not asked in this design: it has no table [{step}]", step=step))]
        )
    rows = _together(document, base, inputs, grid) if _vectorised(base, inputs, step) else _each(document, inputs, grid, step)
    names: dict[str, None] = {}
    units: dict[str, str] = {}
    filled: list[tuple[dict[str, float | None], dict[str, str]]] = []
    for values, verdicts in rows:
        for id, (_, unit) in values.items():
            units.setdefault(id, unit)
        names |= dict.fromkeys(verdicts)
        filled.append(({id: number for id, (number, _) in values.items()}, verdicts))
    if unknown := [id for id in wanted if id not in units]:
        raise BadInput(document.place, [InputError(0, "--values", id, _no_value(id, units)) for id in unknown])
    ids = list(wanted) or list(units)
    header = (*(v.key for v in inputs), *(f"{id} [{units[id]}]" if units[id] else id for id in ids), *(f"verdict.{n}" for n in names))
    made = [[*at, *(values.get(id) for id in ids), *(verdicts.get(n) for n in names)] for at, (values, verdicts) in zip(grid, filled)]
    return Swept(header, made, [worst(list(verdicts.values())) for _, verdicts in filled])


Row = tuple[dict[str, tuple[float | None, str]], dict[str, str]]


def _each(document: Document, inputs: Sequence[Varied], grid: list[tuple[float | str, ...]], step: str | None) -> Iterator[Row]:
    """Design by design; all are checked before the first is solved."""
    designs, errors = [], []
    for at in grid:
        changed = document
        for v, value in zip(inputs, at):
            changed = changed.with_value(v.key, value)
        try:
            designs.append(design(changed))
        except BadInput as bad:
            errors += [InputError(0, f"{_words(inputs, at)}: {e.key}", e.value, e.reason) for e in bad.errors]
    _raise(document, errors)
    before: Results | None = None
    for one in designs:
        before = solve(_needed(one, step), before)
        outcomes = [o for key, o in before.outcomes.items() if step in (None, key) and o.state != "not_asked"]
        yield {v.id: (v.shown, v.unit) for o in outcomes for v in o.values()}, {o.key: o.verdict for o in outcomes}


def _needed(one: Design, step: str | None) -> Design:
    """Without the steps that the wanted one does not wait for."""
    if step in ("engine", "imbalance"):
        return replace(one, bearings=None, friction=None)
    return replace(one, friction=None) if step == "countershaft" else one


def _vectorised(base: Design, inputs: Sequence[Varied], step: str | None) -> bool:
    """Whether all rows can be computed in one call: the imbalance step alone, over plain numbers of engine and crank."""
    if step != "imbalance" or base.engine is None or base.imbalance is None or base.engine.unlike:
        return False
    plain = {f"engine.{k}" for k, about in keys(EngineInputs).items() if about.about.kind == "number"} | {
        "imbalance.crank_balance_fraction"
    }
    if base.imbalance.crank_bodies:
        plain.discard("engine.cylinder_pitch_mm")  # the bobs are found for one pitch at a time
    return all(v.key in plain for v in inputs)


def _together(document: Document, base: Design, inputs: Sequence[Varied], grid: list[tuple[float | str, ...]]) -> Iterator[Row]:
    """One call of the imbalance step on arrays."""
    assert base.engine is not None and base.imbalance is not None
    changed: dict[str, dict[str, Array]] = {"engine": {}, "imbalance": {}}
    for i, v in enumerate(inputs):
        table, key = address(document.data, v.key)
        about = keys(EngineInputs if table == "engine" else ImbalanceInputs)[str(key)]
        changed[str(table)][about.attribute] = np.array([about.about.units.inside(float(at[i])) for at in grid])
    errors = []
    for v in inputs:  # the range of every number once, by the ordinary path; then what only the whole engine can show
        for value in v.values:
            try:
                design(document.with_value(v.key, value))
            except BadInput as bad:
                errors += [InputError(0, f"--vary {v.key}", e.value, e.reason) for e in bad.errors if e.key == v.key]
    _raise(document, errors)
    for k, at in enumerate(grid):
        one = _with(base.engine, {name: float(column[k]) for name, column in changed["engine"].items()})
        errors += [InputError(0, f"{_words(inputs, at)}: engine.{key}", "", reason) for key, reason in one.problems()]
    _raise(document, errors)
    engines = _with(base.engine, changed["engine"])
    cranks = _with(base.imbalance, changed["imbalance"])
    e = engine.values(engines)
    found = imbalance.values(cranks, engines, e, shaft_teeth(base), shaft_axis(base))
    columns = {v.id: (_cells(np.broadcast_to(v.shown, len(grid))), v.unit) for v in published(found, "imbalance")}
    for n, c_n in enumerate(e.harmonics if base.imbalance.kinematics == "exact" else e.two_term, 1):
        if n not in imbalance.ALWAYS:  # an order that this engine does not have is not among its values
            there = np.broadcast_to(np.asarray(c_n) != 0, len(grid))
            for id, (cells, _) in columns.items():
                if id.startswith(f"imbalance.order_{n}."):
                    cells[:] = [cell if is_there else None for cell, is_there in zip(cells, there)]
    judged = replace(found, orders={n: replace(found.orders[n], two_term=None) for n in ("order_1", "order_2")}, webs=None)
    for k in range(len(grid)):
        one_row = {id: (numbers[k], unit) for id, (numbers, unit) in columns.items()}
        share = _at(cranks.crank_balance_fraction, k)
        judged_by = imbalance_checks.checks(_at(judged, k), _at(e.lambda_, k), share, base.countershaft is not None)
        yield one_row, {"imbalance": step_verdict(judged_by)}


def _cells(numbers: Array) -> list[float | None]:
    """The cells of a column; where a design has no such value (NaN: the axis of a circle) the cell is empty."""
    return [None if number != number else float(f"{number:.14g}") for number in numbers.tolist()]


def _with(record: T, attributes: Mapping[str, object]) -> T:
    """A record with other attributes; what is typed for one number may hold one of every row."""
    return type(record)(**{**vars(record), **attributes})


def _at(x: T, k: int) -> T:
    """The k-th of many results that were computed together."""
    if isinstance(x, np.ndarray):
        one: T = x[k].item()
        return one
    if is_dataclass(x) and not isinstance(x, type):
        return _with(x, {f.name: _at(getattr(x, f.name), k) for f in fields(x)})
    if isinstance(x, dict):
        return type(x)({name: _at(part, k) for name, part in x.items()})
    return type(x)(_at(part, k) for part in x) if isinstance(x, tuple) else x


def _words(inputs: Sequence[Varied], at: Sequence[float | str]) -> str:
    return ", ".join(f"{v.key}={value:g}" if isinstance(value, float) else f"{v.key}={value}" for v, value in zip(inputs, at))


def _raise(document: Document, errors: list[InputError]) -> None:
    if errors:
        more = [InputError(0, "", "", Text("… and {count} more", count=len(errors) - SHOWN_ERRORS))] if len(errors) > SHOWN_ERRORS else []
        raise BadInput(document.place, errors[:SHOWN_ERRORS] + more)


def _no_value(id: str, known: dict[str, str]) -> Text:
    from difflib import get_close_matches

    near = get_close_matches(id, list(known), 1, 0.4)
    return (
        Text("is no value of these designs")
        + (f'; did you mean "{near[0]}"?' if near else "")
        + " (`contralbero check FILE --all` prints them)"
    )
