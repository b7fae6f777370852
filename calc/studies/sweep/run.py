# SPDX-License-Identifier: Apache-2.0
"""The run of a sweep: designs by chunks, in any order and any process, as many of them at once as go one way.

Chunks keep no state and are computed once.  A chunk that is kept is taken over by the next run of the same sweep, so
that one that was ended goes on where it stood."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any, ParamSpec, TypeVar

import numpy as np

from ...bearings.routes.side_by_side import COMPARED
from ...design.model import Design
from ...design.toml_file import Document, design
from ...sheet.arrays import Array, BoolArray
from ...sheet.check import THIN_MARGIN, Check, step_verdict, worst
from ...sheet.errors import BadInput, InputError
from ...sheet.lanes import Diverged, Lanes, Singly, abreast, designs_abreast, some_lanes, together_or_singly
from ...sheet.record import record
from ...sheet.reuse import Parts
from ...sheet.step import Outcome
from ...sheet.text import Text
from ...sheet.value import recorded
from ...solve import TITLES, Results, solve, steps
from ..processes import spread
from .inputs import Combination, SweepPlan, Varied, grid
from .table import Chunk, InMemory, Solved, Store, Swept, chunk_of, in_memory, reason_of

# --- many designs in one pass through the steps, as lanes (`calc.sheet.lanes`)
# Those that go different ways in as many passes as it takes.
#
# What can not be told of many at once (why a design has no solution), what fails for one of them, and what lies on a
# limit to its last digits is solved design by design.

P = ParamSpec("P")
R = TypeVar("R")
FEW = 8  # designs, which are as quick one by one
LAST_DIGITS = 1e-7  # of a limit: so near to it a verdict hangs on digits in which one design and many may differ
FAILS: tuple[type[Exception], ...] = (
    Exception,
)  # what many at once may fail at: each alone has its result, or says what is wrong
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
    """The places of designs that went one way, with what the steps gave them as lanes; None: they are to be solved one
    by one."""
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
                places = [n for n, chosen in zip(some, which) if chosen]
                given = {name: some_lanes(outcome, which) for name, outcome in done.items()}
                waiting.append((places, given, singly.some(which)))
        except FAILS:
            yield some, None
        else:
            yield some, outcomes


def solved(
    designs: Sequence[Design],
    step: str | None,
    wanted: frozenset[str],
    alone: Callable[[int], Solved],
    *,
    compared: bool,
) -> list[Solved]:
    """The rows of designs; `alone` solves the one at a place, `compared` as `calc.solve.solve` has it."""
    rows: dict[int, Solved] = {}
    for some, outcomes in passes(designs, compared=compared):
        if outcomes is not None:
            with suppress(*FAILS):
                rows |= {n: row for n, row in zip(some, _rows(outcomes, len(some), step, wanted)) if row is not None}
        rows |= {n: alone(n) for n in some if n not in rows}
    return [rows[n] for n in range(len(designs))]


def _rows(
    outcomes: Mapping[str, Outcome[Any]], count: int, step: str | None, wanted: frozenset[str]
) -> Iterator[Solved | None]:
    """One for each lane; None where it has to be solved alone, to say what stands in words or on which side of a limit
    it is."""
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
    margins: Array = np.nan_to_num(gap / size, nan=-np.inf, posinf=np.inf, neginf=-np.inf)
    return margins


def _one(check: Check, k: int) -> Check:
    """The check of one of the designs."""
    value, *limits = (x.data[k].item() if type(x) is Lanes else x for x in (check.value, *_limits(check)))
    return replace(check, value=value, limit=tuple(limits) if isinstance(check.limit, tuple) else limits[0])


# --- the run

MOST = 224  # designs of a chunk, which go through all steps at once: more would take more memory than they save time
CHUNKS, LEAST = 8, 48  # chunks at least, for processes to share, where each has so many designs
BESIDE = COMPARED | {"source", "model_spread"}  # of an id: a value that judges nothing
WORTH = 200  # designs from which a second process gains more than its start costs
Told = Callable[[int], None]  # designs that are done, those that were kept with them


@record
class Sweep:
    """What is asked for.  `step`: only this one's values and verdict; `wanted`: only these values."""

    document: Document
    plan: SweepPlan
    step: str | None = None
    wanted: tuple[str, ...] = ()

    @property
    def size(self) -> int:
        """Designs of a chunk, which hang on the sweep alone and not on the machine."""
        return min(MOST, max(LEAST, -(-self.plan.count // CHUNKS)))


def swept(asked: Sweep, store: Store, progress: Told | None = None, processes: int = 1, scheduler: str = "") -> None:
    """Fill the store with every chunk that it does not have.  Raises BadInput where a step or a value is asked for that
    there is not."""
    _known(asked)
    size = asked.size
    numbers = range(-(-asked.plan.count // size))
    waiting = [n for n in numbers if not store.has(n)]
    done = asked.plan.count - sum(min(size, asked.plan.count - n * size) for n in waiting)
    if progress is not None:
        progress(done)
    if asked.plan.count < WORTH:
        processes = 1
    for n, piece in spread(chunk, asked, waiting, processes, scheduler):
        store.keep(n, piece)
        done += len(piece.rows)
        if progress is not None:
            progress(done)


def sweep(document: Document, inputs: Sequence[Varied], step: str | None = None, wanted: Sequence[str] = ()) -> Swept:
    """Every combination of the varied inputs, the last one changing fastest.  One that is no design is a row with its
    reason."""
    asked, store = Sweep(document, grid(inputs), step, tuple(wanted)), InMemory()
    swept(asked, store)
    return in_memory(document, asked.plan.inputs, store)


def chunk(asked: Sweep, n: int) -> Chunk:
    """The designs of one chunk."""
    size = asked.size
    at = asked.plan.rows(n * size, (n + 1) * size)
    with recorded(False):
        return chunk_of(
            at, side_by_side(asked.document, asked.plan.inputs, at, asked.step, frozenset(asked.wanted)), asked.wanted
        )


def side_by_side(
    document: Document,
    inputs: Sequence[Varied],
    at: Sequence[Combination],
    step: str | None,
    wanted: frozenset[str] = frozenset(),
) -> list[Solved]:
    """All at once, as far as they go one way; else design by design.  `wanted`: only these values; none: all."""
    compared = not wanted or any(not BESIDE.isdisjoint(id.split(".")) for id in wanted)
    built = list(designs(document, inputs, at))
    sound = [_needed(entry, step) for entry in built if isinstance(entry, Design)]
    alone = _one_after_the_other(step, wanted, compared)
    rows = iter(solved(sound, step, wanted, lambda n: alone(sound[n]), compared=compared))
    return [next(rows) if isinstance(entry, Design) else entry for entry in built]


def one_by_one(
    document: Document,
    inputs: Sequence[Varied],
    at: Sequence[Combination],
    step: str | None,
    wanted: frozenset[str] = frozenset(),
) -> Iterator[Solved]:
    """Design by design."""
    alone = _one_after_the_other(step, wanted, compared=True)
    return (
        alone(_needed(entry, step)) if isinstance(entry, Design) else entry for entry in designs(document, inputs, at)
    )


def _one_after_the_other(step: str | None, wanted: frozenset[str], compared: bool) -> Callable[[Design], Solved]:
    """Solves a design; what it has like the one before it is taken over."""
    before: list[Results] = []

    def solved(design: Design) -> Solved:
        before[:] = [solve(design, before[0] if before else None, compared=compared)]
        return _solved(before[0], step, wanted)

    return solved


def designs(document: Document, inputs: Sequence[Varied], at: Sequence[Combination]) -> Iterator[Design | Solved]:
    """The designs of some combinations; of what is none a row that says why."""
    sound = document, design(document)
    for row in at:
        changed = document
        for variable, value in zip(inputs, row):
            if value is not None:
                changed = changed.with_value(variable.key, value)
        try:
            yield design(changed, sound)
        except BadInput as bad:
            yield Solved({}, {}, reason_of(bad.errors))


def _solved(results: Results, step: str | None, wanted: frozenset[str] = frozenset()) -> Solved:
    outcomes = [o for key, o in results.outcomes.items() if step in (None, key) and o.state != "not_asked"]
    values: dict[str, tuple[float | None, str]] = {v.id: (v.shown, v.unit) for o in outcomes for v in o.values(wanted)}
    return Solved(
        values, {o.key: o.verdict for o in outcomes}, "; ".join(f"{o.key}: {o.reason}" for o in outcomes if o.reason)
    )


def _needed(design: Design, step: str | None) -> Design:
    """Without the steps that the wanted one does not wait for."""
    if step in ("engine", "imbalance"):
        return replace(design, bearings=None, friction=None)
    return replace(design, friction=None) if step == "countershaft" else design


def _known(asked: Sweep) -> None:
    """Values are known by the design as it is, else by the first combination."""
    base = design(asked.document)
    if asked.step is not None and getattr(base, asked.step) is None:
        why = Text("is not asked in this design: it has no table [{step}]", step=asked.step)
        raise BadInput(asked.document.place, [InputError(0, "--step", asked.step, why)])
    if not asked.wanted:
        return
    known = _solved(solve(_needed(base, asked.step)), asked.step).values
    if not known.keys() >= set(asked.wanted):
        known |= next(one_by_one(asked.document, asked.plan.inputs, asked.plan.rows(0, 1), asked.step)).values
    if unknown := [id for id in asked.wanted if id not in known]:
        raise BadInput(
            asked.document.place, [InputError(0, "--values", id, _no_value(id, list(known))) for id in unknown]
        )


def _no_value(id: str, known: Sequence[str]) -> Text:
    from difflib import get_close_matches

    near = get_close_matches(id, known, 1, 0.4)
    return (
        Text("is no value of these designs")
        + (f'; did you mean "{near[0]}"?' if near else "")
        + " (`contralbero check FILE --all` prints them)"
    )
