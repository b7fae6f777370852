# SPDX-License-Identifier: Apache-2.0
"""Many designs in one pass through the steps, as lanes (`calc.sheet.lanes`); those that go different ways in as many passes as it takes.

What can not be told of many at once (why a design has no solution), what fails for one of them, and what lies on a limit to its last
digits is solved design by design.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any, ParamSpec, TypeVar

import numpy as np

from ..design.model import Design
from ..sheet.abreast import Singly, abreast, designs_abreast, some_lanes, together_or_singly
from ..sheet.arrays import Array, BoolArray
from ..sheet.check import THIN_MARGIN, Check, step_verdict, worst
from ..sheet.lanes import Diverged, Lanes
from ..sheet.parts import Parts
from ..sheet.step import Outcome
from ..sheet.trace import recorded
from ..solve import TITLES, steps
from .row import Solved

P = ParamSpec("P")
R = TypeVar("R")
FEW = 8  # designs, which are as quick one by one
LAST_DIGITS = 1e-7  # of a limit: so near to it a verdict hangs on digits in which one design and many may differ
FAILS: tuple[type[Exception], ...] = (Exception,)  # what many at once may fail at: each alone has its result, or says what is wrong
Pass = tuple[list[int], dict[str, Outcome[Any]], Singly]  # the places of the designs, and what is done of them


class _Parts(Parts):
    """Calls the parts of a pass; `done`: what they gave before some of the designs went another way."""

    def __init__(self, done: dict[str, Outcome[Any]]) -> None:
        super().__init__(TITLES, {}, stop=bool, enough=None)
        self.done = done

    def __call__(self, key: str, function: Callable[P, Outcome[R]], /, *args: P.args, **kwargs: P.kwargs) -> Outcome[R]:
        name = f"{key}.{function.__name__}"
        if name not in self.done:
            self.done[name] = together_or_singly(function)(*args, **kwargs)
        return self.done[name]


def passes(designs: Sequence[Design], *, compared: bool) -> Iterator[tuple[list[int], dict[str, Outcome[Any]] | None]]:
    """The places of designs that went one way, with what the steps gave them as lanes; None: they are to be solved one by one."""
    waiting: list[Pass] = [(list(range(len(designs))), {}, Singly([{}] * len(designs)))]
    while waiting:
        some, done, singly = waiting.pop()
        if len(some) <= FEW:
            yield some, None
            continue
        try:
            with designs_abreast(singly), recorded(False), np.errstate(divide="raise", over="raise", invalid="raise"):
                outcomes = steps(_Parts(done), abreast([designs[n] for n in some]), compared)
        except Diverged as apart:
            for which in (apart.some, ~apart.some):
                places = [n for n, one in zip(some, which) if one]
                given = {name: some_lanes(outcome, which) for name, outcome in done.items()}
                waiting.append((places, given, singly.some(which)))
        except FAILS:
            yield some, None
        else:
            yield some, outcomes


def solved(
    designs: Sequence[Design], step: str | None, wanted: frozenset[str], alone: Callable[[int], Solved], *, compared: bool
) -> list[Solved]:  # fmt: skip
    """The rows of designs; `alone` solves the one at a place, `compared` as `calc.solve.solve` has it."""
    rows: dict[int, Solved] = {}
    for some, outcomes in passes(designs, compared=compared):
        if outcomes is not None:
            with suppress(*FAILS):
                rows |= {n: row for n, row in zip(some, _rows(outcomes, len(some), step, wanted)) if row is not None}
        rows |= {n: alone(n) for n in some if n not in rows}
    return [rows[n] for n in range(len(designs))]


def _rows(outcomes: Mapping[str, Outcome[Any]], count: int, step: str | None, wanted: frozenset[str]) -> Iterator[Solved | None]:
    """One for each lane; None where it has to be solved alone, to say what stands in words or on which side of a limit it is."""
    asked = [outcome for key, outcome in outcomes.items() if step in (None, key) and outcome.state != "not_asked"]
    values = [(v.id, _cells(v.shown), v.unit) for outcome in asked for v in outcome.values(wanted)]
    near, verdicts = np.full(count, any(outcome.reason for outcome in asked)), {}
    for outcome in asked:
        verdicts[outcome.key], close = _verdicts(outcome, count)
        near |= close
    for k in range(count):
        cells = {id: (numbers[k] if type(numbers) is list else numbers, unit) for id, numbers, unit in values}
        yield None if near[k] else Solved(cells, {key: of[k] for key, of in verdicts.items()})


def _cells(shown: Any) -> Any:
    """A number of all, or a list of one for each, as one design has it."""
    return [float(f"{number:.14g}") for number in shown.data.tolist()] if type(shown) is Lanes else shown


def _verdicts(outcome: Outcome[Any], count: int) -> tuple[Sequence[str], BoolArray]:
    """The verdict of a step for each of the designs, and for which of them it hangs on last digits."""
    near = np.zeros(count, dtype=bool)
    if outcome.state != "solved":
        return [outcome.verdict] * count, near
    same: list[Check] = []
    apart: list[Sequence[str]] = []
    for check in outcome.checks:
        if not any(type(x) is Lanes for x in (check.value, *_limits(check))):
            same.append(check)
            continue
        margins = _margins(check)
        near |= (np.abs(margins) < LAST_DIGITS) | (np.abs(margins - THIN_MARGIN) < LAST_DIGITS)
        # passed over, kept narrowly, kept, each at a limit of 0 or another: a verdict each
        kinds = 2 * np.searchsorted((0.0, THIN_MARGIN), margins) + (_data(_limits(check)[-1]) == 0)
        if (kinds == kinds[0]).all():
            same.append(_one(check, 0))
        else:
            of_kind = {kind: step_verdict([_one(check, int(np.argmax(kinds == kind)))]) for kind in set(kinds.tolist())}
            apart.append([of_kind[kind] for kind in kinds.tolist()])
    common = step_verdict(same)
    return [worst((common, *others)) for others in zip(*apart)] if apart else [common] * count, near


def _limits(check: Check) -> tuple[Any, ...]:
    limits: tuple[Any, ...] = check.limit if isinstance(check.limit, tuple) else (check.limit,)
    return limits


def _data(x: Any) -> Any:
    return np.asarray(x.data if type(x) is Lanes else x)


def _margins(check: Check) -> Array:
    """`Check.margin` of each design; a value that is no number is passed over."""
    value, *limits = map(_data, (check.value, *_limits(check)))
    signs = (1.0, -1.0) if len(limits) == 2 else (1.0,) if check.sense in (">=", ">") else (-1.0,)
    gaps = [(sign * (value - limit), np.where(limit == 0, 1.0, np.abs(limit))) for sign, limit in zip(signs, limits)]
    gap, size = gaps[0]
    for other, its_size in gaps[1:]:
        gap, size = np.where(gap <= other, gap, other), np.where(gap <= other, size, its_size)
    found: Array = np.nan_to_num(gap / size, nan=-np.inf, posinf=np.inf, neginf=-np.inf)
    return found


def _one(check: Check, k: int) -> Check:
    """The check of one of the designs."""
    value, *limits = (x.data[k].item() if type(x) is Lanes else x for x in (check.value, *_limits(check)))
    return replace(check, value=value, limit=tuple(limits) if isinstance(check.limit, tuple) else limits[0])
