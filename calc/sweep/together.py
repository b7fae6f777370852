# SPDX-License-Identifier: Apache-2.0
"""The imbalance step of many designs in one call on arrays."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields, is_dataclass, replace
from typing import TypeVar

import numpy as np

from ..addresses import address
from ..design import Design
from ..design_file import Document, number_mistakes
from ..engine import solve as engine
from ..engine.inputs import EngineInputs
from ..imbalance import checks as imbalance_checks
from ..imbalance import solve as imbalance
from ..imbalance.inputs import ImbalanceInputs
from ..sheet.arrays import Array
from ..sheet.check import step_verdict
from ..sheet.errors import InputError
from ..sheet.quantity import Key, keys, published
from ..step_inputs import shaft_axis, shaft_teeth
from .inputs import Varied
from .plan import Combination
from .row import Solved, reason_of

T = TypeVar("T")


def vectorised(base: Design, inputs: Sequence[Varied], step: str | None) -> bool:
    """Whether all rows can be computed in one call: the imbalance step alone, over plain numbers of engine and crank."""
    if step != "imbalance" or base.engine is None or base.imbalance is None or base.engine.unlike:
        return False
    plain = {f"engine.{k}" for k, about in keys(EngineInputs).items() if about.about.kind == "number"} | {
        "imbalance.crank_balance_fraction"
    }
    if base.imbalance.crank_bodies:
        plain.discard("engine.cylinder_pitch_mm")  # the bobs are found for one pitch at a time
    return all(v.key in plain for v in inputs)


def together(document: Document, base: Design, inputs: Sequence[Varied], grid: Sequence[Combination]) -> list[Solved]:
    """Every combination that is an engine in one call; the others with what is wrong in them."""
    assert base.engine is not None and base.imbalance is not None
    known = [_known(document, one.key) for one in inputs]
    found: list[Solved | None] = []
    sound: list[Combination] = []
    for at in grid:
        errors = [e for (_, key), one, value in zip(known, inputs, at) for e in number_mistakes(document, key.about, one.key, value)]
        if not errors:
            row: dict[str, dict[str, object]] = {"engine": {}, "imbalance": {}}
            for (table, key), value in zip(known, at):
                row[table][key.attribute] = key.about.units.inside(float(value or 0))
            errors = [InputError(0, f"engine.{key}", "", reason) for key, reason in _with(base.engine, row["engine"]).problems()]
        found.append(Solved({}, {}, reason_of(errors)) if errors else None)
        if not errors:
            sound.append(at)
    good = iter(_solved(base, known, sound) if sound else ())
    return [one or next(good) for one in found]


def _known(document: Document, key: str) -> tuple[str, Key]:
    """The table of an input, and what is known of it."""
    table, name = address(document.data, key)
    return str(table), keys(EngineInputs if table == "engine" else ImbalanceInputs)[str(name)]


def _solved(base: Design, known: Sequence[tuple[str, Key]], grid: Sequence[Combination]) -> Iterator[Solved]:
    assert base.engine is not None and base.imbalance is not None
    changed: dict[str, dict[str, Array]] = {"engine": {}, "imbalance": {}}
    for n, (table, key) in enumerate(known):
        changed[table][key.attribute] = np.array([key.about.units.inside(float(at[n] or 0)) for at in grid])
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
        yield Solved(one_row, {"imbalance": step_verdict(judged_by)})


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
