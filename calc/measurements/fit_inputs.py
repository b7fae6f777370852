# SPDX-License-Identifier: Apache-2.0
"""The table [[fits]]: which inputs are found from which runs, and between which bounds.

[[fits]]
name = "drag"
of = ["drag-run"]                      # left out: all runs
free = [{ key = "shafts.shaft.bearings.front.clearance_um", low = 50, high = 140, start = 80 }]
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence

from ..sheet.inputs_at import content_at
from ..sheet.quantity import Quantity, dotted, inputs, keys, meant, names, quantity, tables, text
from ..sheet.text import Text
from .inputs import Measurement

MOST_FREE = 4


@inputs
class FreeInput:
    """An input that is fitted, its numbers in the unit of its key."""

    key: str = text("Input", help="The key of an input that is a number.")
    low: float = quantity("Lowest", help="In the unit of the key, like the rest of the row.")
    high: float = quantity("Highest")
    start: float | None = quantity(
        "Start", default=None, help="Left out: what the design has where that lies in the range, else the middle of it."
    )
    prior: float | None = quantity("Prior", default=None, help="What is known of it without the measurements.")
    prior_sd: float | None = quantity("Standard deviation of the prior", above=0, default=None)

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.low >= self.high:
            yield dotted(FreeInput.high), Text("must be larger than low")
            return
        for field, number in ((FreeInput.start, self.start), (FreeInput.prior, self.prior)):
            if number is not None and not self.low <= number <= self.high:
                yield dotted(field), Text("must lie from low to high")
        if (self.prior is None) != (self.prior_sd is None):
            given = FreeInput.prior if self.prior_sd is None else FreeInput.prior_sd
            yield dotted(given), Text("prior and prior_sd stand together: give both, or leave both out")


@inputs
class FitInputs:
    """One fit."""

    name: str = text("Name", help="In ids: letters, digits and -.")
    of: tuple[str, ...] | None = names("Runs", default=None, help="Names of [[measurements]]. Left out: all of them.")
    free: tuple[FreeInput, ...] = tables("Free inputs", FreeInput, help="One to four.")

    def problems(self) -> Iterable[tuple[str, Text]]:
        if not 1 <= len(self.free) <= MOST_FREE:
            counts = dict(count=len(self.free), most=MOST_FREE)
            yield dotted(FitInputs.free), Text("has {count} inputs; needs 1 to {most}", **counts)
        keys = [row.key for row in self.free]
        for n, key in enumerate(keys):
            if key in keys[:n]:
                yield dotted(FitInputs.free, n, FreeInput.key), Text("is free already")
        for n, run in enumerate(self.of or ()):
            if run in (self.of or ())[:n]:
                yield dotted(FitInputs.of, n), Text("stands twice")


# --- beside the runs and the inputs of a design

Tables = Sequence[tuple[str, object]]  # the tables of inputs of a design, by the beginning of their keys


def fit_problems(fit: FitInputs, runs: Sequence[Measurement], tables: Tables) -> Iterable[tuple[str, Text]]:
    """Whether the runs of a fit are there, and its inputs are numbers that no condition of those runs sets."""
    known = [run.name for run in runs]
    if not known:
        yield dotted(FitInputs.of), Text("there is no run to fit to: add [[measurements]]")
    for i, name in enumerate(fit.of or ()):
        if known and name not in known:
            yield dotted(FitInputs.of, i), Text("is no run of this design") + meant(name, known)
    of = [run for run in runs if fit.of is None or run.name in fit.of]
    set_by = {condition.key: run.name for run in of for condition in run.conditions}
    for i, row in enumerate(fit.free):
        for key, reason in _free_problems(row, set_by, tables):
            yield dotted(FitInputs.free, i, key), reason


def _free_problems(row: FreeInput, set_by: Mapping[str, str], tables: Tables) -> Iterable[tuple[str, Text]]:
    """`set_by`: keys that conditions set, each with the run."""
    about = _described(row.key, tables)
    if about is None:
        numbers = [key for way, table in tables if table is not None for key in _numbers(table, way)]
        yield dotted(FreeInput.key), Text("is no input of this design") + meant(row.key, numbers)
    elif about.kind not in ("number", "integer"):
        must = Text("must be an input that is one number; this one is {allowed}", allowed=about.allowed())
        yield dotted(FreeInput.key), must
    elif about.kind == "integer":
        yield dotted(FreeInput.key), Text("is a whole number, which no fit moves by a little")
    elif row.key in set_by:
        yield dotted(FreeInput.key), Text("is set by a condition of {run}: it is known, not free", run=set_by[row.key])
    else:
        for field, number in ((FreeInput.low, row.low), (FreeInput.high, row.high)):
            if not about.allows(number):
                yield dotted(field), Text("{key} must be {allowed}", key=row.key, allowed=about.allowed())


def _described(key: str, tables: Tables) -> Quantity | None:
    """What is said of an input of a design; None where it has none of that key."""
    for way, table in tables:
        if table is not None and key.startswith(f"{way}."):
            return content_at(table, key.removeprefix(f"{way}."))[1]
    return None


def _numbers(table: object, way: str) -> Iterator[str]:
    """The keys of numbers in a table and in those below it, elements of arrays by their names."""
    kind: type = type(table)
    for key in keys(kind).values():
        here, content = dotted(way, key.key), getattr(table, key.attribute)
        if key.about.kind == "number":
            yield here
        elif key.about.kind == "table" and content is not None:
            yield from _numbers(content, here)
        elif key.about.kind == "tables":
            for n, element in enumerate(content):
                yield from _numbers(element, dotted(here, getattr(element, "name", "") or n))
