# SPDX-License-Identifier: Apache-2.0
"""One solve, as a question that another thread can be given and an answer that it gives back."""

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from calc.design.model import Design
from calc.sheet.errors import Cancelled
from calc.sheet.progress import waited_for
from calc.sheet.text import EMPTY, Text

from ..output import kept

if TYPE_CHECKING:
    from calc.solve import Results


@dataclass(frozen=True)
class Job:
    """What a solve needs, to be run in another thread."""

    generation: int
    design: Design = field(repr=False)  # they are large, and a screen may want to name this in its log
    before: "Results | None" = field(repr=False)
    stop: Callable[[], bool] = field(default=bool, repr=False)  # whether nobody waits for the answer any more
    brief: bool = False  # for the verdicts alone: without lines and other methods, which is half of the work


@dataclass(frozen=True)
class Answer:
    """What a solve gave, a `brief` one for the verdicts alone.  There are no results where it was stopped, or where
    `failure` says that the program itself went wrong."""

    generation: int
    results: "Results | None" = field(repr=False)
    seconds: float
    failure: Text = EMPTY
    brief: bool = False


def mistake(error: Exception) -> Text:
    """What is told of a mistake of the program, which must not take the user's work with it; its trace is kept."""
    words = Text("the program made a mistake: {kind}: {error}", kind=type(error).__name__, error=str(error))
    trace = kept(error)
    return words if trace is None else Text("{mistake}; its trace is in {path}", mistake=words, path=str(trace))


def run(job: Job) -> Answer:
    """Solve.  The numerics are loaded here, not at the start of the program."""
    started = time.perf_counter()
    try:
        from calc.sheet.value import recorded
        from calc.solve import solve

        def go_on() -> None:
            if job.stop():
                raise Cancelled

        with waited_for(go_on), recorded(not job.brief):
            results = solve(job.design, job.before, compared=not job.brief)  # which asks between its parts
        results.values()  # gathered here, so that the screen need not wait for it
    except Cancelled:
        return Answer(job.generation, None, 0.0, brief=job.brief)
    except Exception as error:  # a mistake of the program must not take the user's work with it
        return Answer(job.generation, None, 0.0, mistake(error), job.brief)
    return Answer(job.generation, results, time.perf_counter() - started, brief=job.brief)
