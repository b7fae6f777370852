"""Extreme but allowed values for the numeric fields of a design, and the outcomes that are clean.

Every field of the shipped designs at each of its extremes, where the tests take a share: `python -m
tests.hostile.extremes [DESIGN …]`."""

import math
import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager

from calc.design.addresses import quantities, value_at
from calc.design.toml_file import Document, design, read
from calc.sheet.errors import BadInput, NoSolution
from calc.sheet.quantity import Quantity
from calc.solve import solve
from calc.studies.shipped import designs, shipped_name

SECONDS = 30  # that one design may take; a solve takes a twentieth of one
TINY = (5e-324, 1e-300, 1e-29, 1e-9)  # the first two are no numbers that a design may have
HUGE = (1e9, 1e30, 1e300)
Field = tuple[str, Quantity]


def fields(document: Document) -> list[Field]:
    """Every number that a design has or may have, the numbers of a list one by one."""
    found: list[Field] = []
    for key, about in quantities(document.data):
        if about.kind in ("number", "integer"):
            found.append((key, about))
        elif about.kind in ("series", "integers") and isinstance(there := value_at(document.data, key), list):
            found += [(f"{key}.{n}", about) for n in range(len(there))]
    return found


def extremes(about: Quantity) -> tuple[float, ...]:
    """The ends of what is allowed, and numbers beside nought and far from it that lie within."""
    low = about.low if about.low is not None else about.above if about.above is not None else -math.inf
    high = about.high if about.high is not None else math.inf
    if about.kind in ("integer", "integers"):
        return tuple(
            sorted(
                {int(x) for x in (low, low + 1, high, high - 1, 0, 1, 10**6) if math.isfinite(x) and low <= x <= high}
            )
        )
    near = (
        (math.nextafter(low, math.inf), math.nextafter(high, -math.inf))
        if math.isfinite(low) and math.isfinite(high)
        else ()
    )
    candidates = {low, high, 0.0, *near, *TINY, *HUGE, *(-x for x in TINY + HUGE)}
    return tuple(sorted(x for x in candidates if math.isfinite(x) and low <= x <= high and not (x == about.above)))


def single(document: Document) -> list[tuple[str, float]]:
    """Every field at each of its extremes, one field at a time."""
    return [(key, value) for key, about in fields(document) for value in extremes(about)]


@contextmanager
def in_time(seconds: int) -> Iterator[None]:
    """Raises TimeoutError where the system can."""
    if not hasattr(signal, "SIGALRM"):
        yield
        return

    def late(*_: object) -> None:
        raise TimeoutError(f"longer than {seconds} s")

    before = signal.signal(signal.SIGALRM, late)
    signal.alarm(seconds)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


def faults(document: Document, changes: dict[str, float]) -> list[str]:
    """What is not clean about a design with some fields changed: a result that is no number, a word with "nan" in it, a
    limit of 0 without a scale, a crash."""
    for key, value in changes.items():
        document = document.with_value(key, value)
    try:
        with in_time(SECONDS):
            return _faults(document)
    except Exception as crash:  # whatever it is, it is a find
        import traceback

        last = traceback.extract_tb(crash.__traceback__)[-1]
        return [f"{type(crash).__name__} in {last.filename}:{last.lineno}: {crash}"]


def _faults(document: Document) -> list[str]:
    try:
        made = design(document)
    except BadInput as bad:
        return ["nan in bad input" for e in bad.errors if "nan" in str(e.reason).split()]
    found = []
    try:
        outcomes = solve(made).outcomes
    except NoSolution as none:
        return [f"NoSolution leaves solve: {none}"]
    for outcome in outcomes.values():
        whole = outcome.whole
        words = f"{whole.reason}".replace(",", " ").split()
        found += [f"{outcome.key}: reason has {w}" for w in ("nan", "inf", "−inf") if w in words]
        found += [f"{outcome.key}: {whole.reason}"] if "without a scale" in whole.reason else []
        found += [f"{v.id} = {v.shown}" for v in whole.values() if not math.isfinite(v.shown)]
        found += [
            f"check {c.id} = {c.value} passes"
            for c in whole.checks
            if not math.isfinite(c.value) and c.verdict == "pass"
        ]
        for table in whole.tables:
            cells = (cell for row in table.rows for cell in row if isinstance(cell, float))
            found += [f"table {whole.key}.{table.id}" for cell in cells if not math.isfinite(cell)][:1]
    return found


if __name__ == "__main__":
    all_ = {shipped_name(path): read(path) for path in designs()}
    for name in sys.argv[1:] or all_:
        cases = single(all_[name])
        found = [f"{name} {key}={value}: {bad}" for key, value in cases if (bad := faults(all_[name], {key: value}))]
        print(f"{name}: {len(cases)} cases, {len(found)} faults", *found, sep="\n", flush=True)
