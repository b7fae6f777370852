# SPDX-License-Identifier: Apache-2.0
"""The run of a sweep: designs by chunks, in any order and any process; in a chunk one design after the other.

Chunks keep no state and are computed once.  A chunk that is kept is taken over by the next run of the same sweep, so
that one that was ended goes on where it stood."""

from collections.abc import Callable, Iterator, Sequence
from difflib import get_close_matches

from ...bearings.plain.routes.side_by_side import COMPARED
from ...design.model import Design
from ...design.toml_file import Document, design
from ...sheet.errors import BadInput, InputError
from ...sheet.record import record, replace
from ...sheet.text import Text
from ...sheet.value import recorded
from ...solve import Results, solve
from ..processes import spread
from .inputs import Combination, SweepPlan, Varied, grid
from .table import NO_DESIGN, SIZE, Chunk, InMemory, Solved, Store, Swept, chunk_of, in_memory, reason_of

BESIDE = COMPARED | {"source", "model_spread"}  # of an id: a value that judges nothing
WORTH = 100  # designs from which a second process gains more than its start costs
Told = Callable[[int], None]  # designs that are done, those that were kept with them


@record
class Sweep:
    """What is asked for.  `step`: only this one's values and verdict; `wanted`: only these values."""

    document: Document
    plan: SweepPlan
    step: str | None = None
    wanted: tuple[str, ...] = ()

    def piece(self, n: int) -> "Sweep":
        """The designs of one chunk, without all the others: it may go far."""
        return replace(self, plan=self.plan.part(n * SIZE, (n + 1) * SIZE))


def swept(asked: Sweep, store: Store, progress: Told | None = None, processes: int = 1, scheduler: str = "") -> None:
    """Fill the store with every chunk that it does not have.  Raises BadInput where a step or a value is asked for that
    there is not."""
    _known(asked)
    numbers = range(-(-asked.plan.count // SIZE))
    waiting = [n for n in numbers if not store.has(n)]
    done = asked.plan.count - sum(min(SIZE, asked.plan.count - n * SIZE) for n in waiting)
    if progress is not None:
        progress(done)
    if asked.plan.count < WORTH:
        processes = 1
    for n, piece in spread(chunk, asked.piece, waiting, processes, scheduler):
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


def chunk(piece: Sweep) -> Chunk:
    """The designs of one chunk."""
    at = piece.plan.combinations
    with recorded(False):
        rows = solved(piece.document, piece.plan.inputs, at, piece.step, frozenset(piece.wanted))
        return chunk_of(at, rows, piece.wanted)


def solved(
    document: Document,
    inputs: Sequence[Varied],
    at: Sequence[Combination],
    step: str | None,
    wanted: frozenset[str] = frozenset(),
) -> Iterator[Solved]:
    """Design after design; parts that are as in the one before are taken over.  `wanted`: only these values; none:
    all."""
    compared = not wanted or any(not BESIDE.isdisjoint(id.split(".")) for id in wanted)
    before: Results | None = None
    for entry in designs(document, inputs, at):
        if isinstance(entry, Design):
            before = solve(_needed(entry, step), before, compared=compared)
            yield _row(before, step, wanted)
        else:
            yield entry


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
            yield Solved({}, {}, NO_DESIGN, reason_of(bad.errors))


def _row(results: Results, step: str | None, wanted: frozenset[str] = frozenset()) -> Solved:
    outcomes = [o for key, o in results.outcomes.items() if step in (None, key) and o.state != "not_asked"]
    values: dict[str, tuple[float | None, str]] = {v.id: (v.shown, v.unit) for o in outcomes for v in o.values(wanted)}
    reason = "; ".join(f"{o.key}: {o.reason}" for o in outcomes if o.reason)
    verdict = results.verdict if step is None else results.outcomes[step].verdict
    return Solved(values, {o.key: o.verdict for o in outcomes}, verdict, reason)


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
    known = _row(solve(_needed(base, asked.step)), asked.step).values
    if not known.keys() >= set(asked.wanted):
        known |= next(solved(asked.document, asked.plan.inputs, asked.plan.rows(0, 1), asked.step)).values
    errors = []
    for id in (id for id in asked.wanted if id not in known):
        near = get_close_matches(id, known, 1, 0.4)
        meant = f'; did you mean "{near[0]}"?' if near else ""
        reason = Text("is no value of these designs") + meant + " (`contralbero check FILE --all` prints them)"
        errors.append(InputError(0, "--values", id, reason))
    if errors:
        raise BadInput(asked.document.place, errors)
