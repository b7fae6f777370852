# SPDX-License-Identifier: Apache-2.0
"""`contralbero sweep`: many designs at once, a row of a table for each; a run that is ended goes on where it stood."""

import os
import sys
import time
from argparse import Namespace
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

from assistant.commands.check import changed, known_step
from assistant.extras import demand
from assistant.named_files import STANDARD, demand_ending, read_design
from assistant.results_text import sign
from assistant.session.saving import asked_for, spare
from calc.design.disk import demand_writable, write_file
from calc.design.model import Design
from calc.design.toml_file import Document
from calc.design.unusual import told, unusual
from calc.sheet.check import ORDER
from calc.sheet.errors import BadInput, InputError, NoSolution
from calc.sheet.text import Text
from calc.studies.sweep import Sweep, SweepPlan, grid, listed, sampled, swept, toleranced, varied
from calc.studies.sweep.inputs import same_input
from calc.studies.sweep.run import designs
from calc.studies.sweep.table import NO_DESIGN, InFolder, columns, key_of, write_csv, write_parquet

ENDINGS = ("csv", "parquet")
OFTEN = 2.0  # seconds between two lines of progress


def run_sweep(asked: Namespace) -> int:
    known_step(asked.step)
    output = None if asked.output == STANDARD else asked.output
    if output is not None:
        spare(Path(output), asked.file, *([asked.list] if asked.list is not None else []))
        if demand_ending(output, *ENDINGS) == "parquet":
            demand("parquet", "pyarrow", f"-o {output}")
    if asked.scheduler:
        demand("farm", "distributed", "--scheduler")
    document, _ = changed(read_design(asked.file), asked.changes)
    task = Sweep(document, plan(document, asked), asked.step, tuple(asked.values))
    processes = asked.processes if asked.processes is not None else os.cpu_count() or 1
    if processes < 1:
        raise BadInput("contralbero sweep", [InputError(0, "--processes", str(processes), Text("must be 1 or more"))])
    try:
        if output is not None:
            return _to_file(task, Path(output), asked, processes)
        with TemporaryDirectory(prefix="contralbero-") as folder:
            store = _store(task, Path(folder))
            with asked_for(store.folder):  # of temporary files, whose disk may be full
                swept(task, store, _progress(task, asked), processes, asked.scheduler or "")
            counts = write_csv(sys.stdout, document, task.plan.inputs, store)
        if not asked.quiet:
            print(_summary(counts, task), file=sys.stderr)
    except NoSolution as none:
        print(f"{asked.file}: {none}", file=sys.stderr)
        return 3
    return 0


def plan(document: Document, asked: Namespace) -> SweepPlan:
    """The designs that the options ask for."""

    def refuse(option: str, reason: Text) -> BadInput:
        return BadInput("contralbero sweep", [InputError(0, option, "", reason)])

    if asked.list is not None:
        if asked.vary or asked.tolerance:
            raise refuse("--list", Text("has all that is varied; leave out --vary and --tolerance"))
        inputs, rows = listed(document, asked.list)
        return SweepPlan("list", tuple(inputs), len(rows), combinations=tuple(rows))
    drawn = asked.hypercube if asked.hypercube is not None else asked.monte_carlo
    if asked.tolerance and drawn is None:
        raise refuse("--tolerance", Text("needs a number of designs: --monte-carlo N"))
    inputs = [*varied(document, asked.vary, drawn=drawn is not None), *toleranced(document, asked.tolerance)]
    if not inputs:
        raise refuse("--vary", Text("needs something to vary: --vary, --tolerance or --list"))
    if (twice := same_input(document, inputs)) is not None:
        raise refuse("--tolerance", Text("names an input that --vary has already: {key}", key=twice))
    return grid(inputs) if drawn is None else sampled(inputs, drawn, asked.seed, hypercube=asked.hypercube is not None)


class Progress:
    """How many designs are done and how long the rest will take, on stderr, where it takes longer than a moment."""

    def __init__(self, count: int) -> None:
        self.count, self.first, self.begun = count, -1, time.monotonic()
        self.last = self.begun

    def __call__(self, done: int) -> None:
        now = time.monotonic()
        if self.first < 0:
            self.first = done
            if 0 < done < self.count:
                print(
                    Text("{done} of {count} designs are known from the run before", done=done, count=self.count),
                    file=sys.stderr,
                )
            return
        if now - self.last < OFTEN or done <= self.first:
            return
        self.last = now
        left = f"{(self.count - done) * (now - self.begun) / (done - self.first):.0f}"
        print(
            Text("{done} of {count} designs, {left} s left", done=done, count=self.count, left=left),
            file=sys.stderr,
            flush=True,
        )


def _progress(task: Sweep, asked: Namespace) -> Callable[[int], None]:
    return (lambda done: None) if asked.quiet else Progress(task.plan.count)


def _store(task: Sweep, folder: Path) -> InFolder:
    return InFolder(folder, key_of(task.document, task.plan, task.step, task.wanted))


def _to_file(task: Sweep, path: Path, asked: Namespace, processes: int) -> int:
    """The chunks are kept beside the file until it is whole."""
    as_parquet = path.suffix.lower() == ".parquet"
    with asked_for(path):
        demand_writable(path)  # before anything is put beside it: a folder, or no name at all, has no such place
    store = _store(task, path.with_name(f"{path.name}.parts"))
    try:
        with store.shared():
            swept(task, store, _progress(task, asked), processes, asked.scheduler or "")
            draft = store.draft()
            if as_parquet:
                counts = write_parquet(draft, task.document, task.plan.inputs, store)
            else:
                with open(draft, "x", encoding="utf-8", newline="") as table:
                    counts = write_csv(table, task.document, task.plan.inputs, store)
            write_file(path, draft, inputs=[asked.file])
            draft.unlink()
            width = len(columns(task.document, task.plan.inputs, store).header)
    except KeyboardInterrupt:
        print(
            Text("what is done is kept in {folder}: the same command goes on from there", folder=str(store.folder)),
            file=sys.stderr,
        )
        raise
    except OSError as error:
        reason = Text("cannot be written: {reason}", reason=error.strerror or str(error))
        raise BadInput(str(path), [InputError(0, "", "", reason)]) from None
    store.clear()
    if not asked.quiet:
        print(_summary(counts, task))
    print(f"{path}: {width} columns")
    return 0


def _summary(counts: Counter[str], task: Sweep) -> str:
    """How many came out how, and what is not usual of the first design and the last."""
    words = [f"{counts[v]} {sign(v)}" for v in ORDER if counts[v]] + (
        [f"{counts[NO_DESIGN]} no design"] if counts[NO_DESIGN] else []
    )
    ends = [*task.plan.rows(0, 1), *task.plan.rows(task.plan.count - 1, task.plan.count)]
    odd = [
        oddity
        for end in designs(task.document, task.plan.inputs, ends)
        if isinstance(end, Design)
        for oddity in unusual(end)
    ]
    furthest = {oddity.key: oddity for oddity in sorted(odd, key=lambda entry: entry.beyond)}
    return "\n".join(filter(None, (f"{counts.total()} designs: " + ", ".join(words), told([*furthest.values()]))))
