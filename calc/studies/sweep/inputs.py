# SPDX-License-Identifier: Apache-2.0
"""The inputs that are varied, read from their texts, and which designs they make in which order."""

import csv
import math
from collections.abc import Callable, Sequence
from functools import lru_cache
from io import StringIO
from itertools import islice
from math import prod
from statistics import NormalDist

import numpy as np

from ...design.addresses import Table, address, every, quantity_of, value_at, with_row
from ...design.disk import read_file
from ...design.limits import LIST_BYTES, LIST_COLUMNS, LIST_ROWS
from ...design.toml_file import Document
from ...design.upgrade import MANY, current
from ...sheet.arrays import Array
from ...sheet.errors import BadInput, InputError
from ...sheet.quantity import Quantity
from ...sheet.record import record, replace
from ...sheet.text import Text

Value = float | str
FLAGS = {"true": True, "false": False}
MOST_ROWS = 1_000_000
LONGEST = 60  # letters of a cell that are told
MOST_MISTAKES = 1000  # of a list, after which the rest is not looked at
FORM = Text("must be KEY=LOW:HIGH:NUMBER or KEY=VALUE,VALUE,…, like engine.rated_speed_rpm=1000:3000:21")
RANGE = Text("must be KEY=LOW:HIGH or KEY=VALUE,VALUE,…, like engine.rod_length_mm=150:170")
TOLERANCE = Text("must be KEY=DEVIATION or KEY=LOWER:UPPER, like shafts.shaft.bearings.front.clearance_um=5 for ±5 µm")


@record
class Varied:
    """One input and the values that it takes, in the unit of its key; or, drawn at random, `ends`: from one number to
    the other.

    `normal`: it is drawn as parts come out of a process whose tolerance is three standard deviations to each side.
    """

    key: str
    values: tuple[Value, ...] = ()
    ends: tuple[float, float] = (0.0, 0.0)
    normal: bool = False
    whole: bool = False


def varied(document: Document, texts: Sequence[str], *, drawn: bool = False) -> list[Varied]:
    """The inputs to vary.  `drawn`: at random, so that a range has no number of values.  Raises BadInput with
    everything that is wrong."""

    def one(key: str, spec: str, about: Quantity) -> Varied:
        whole = about.kind in ("integer", "integers")
        if drawn and spec.count(":") == 1 and "," not in spec:
            low, high = _ends(spec, RANGE)
            if whole and not (low.is_integer() and high.is_integer()):
                raise ValueError("must go from a whole number to another here")
            return Varied(key, ends=(low, high), whole=whole)
        return Varied(key, _values(spec, about))

    return _read(document, "--vary", texts, RANGE if drawn else FORM, one)


def toleranced(document: Document, texts: Sequence[str]) -> list[Varied]:
    """Inputs that scatter about what the design has, by their tolerances."""

    def one(key: str, spec: str, about: Quantity) -> Varied:
        nominal = value_at(document.data, key)
        if about.kind not in ("number", "series") or isinstance(nominal, bool) or not isinstance(nominal, (int, float)):
            raise ValueError("needs a number that the design gives, about which it scatters")
        lower, upper = _ends(spec if ":" in spec else f"-{spec}:{spec}", TOLERANCE)
        return Varied(key, ends=(nominal + lower, nominal + upper), normal=True)

    return _read(document, "--tolerance", texts, TOLERANCE, one)


def listed(document: Document, path: str) -> tuple[list[Varied], list[tuple[Value | None, ...]]]:
    """The designs of a CSV file: keys in its first line, then a design in each.  An empty cell is left as the design
    has it."""
    try:
        text = read_file(path, LIST_BYTES).decode("utf-8-sig")
        lines = list(islice(csv.reader(StringIO(text, newline="")), LIST_ROWS + 2))
    except UnicodeDecodeError as error:
        raise _bad(path, 0, Text("is no text in UTF-8 (byte {n}); save it again so", n=error.start)) from None
    except (OSError, csv.Error) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise _bad(path, 0, Text("cannot be read: {reason}", reason=reason)) from None
    if len(lines) < 2 or not lines[0]:
        raise _bad(path, 1, Text("needs keys in its first line, and a design in each line below it"))
    if len(lines) > LIST_ROWS + 1:
        raise _bad(path, 0, Text("has too many designs; at most {most} at once", most=f"{LIST_ROWS:,}"))
    if len(lines[0]) > LIST_COLUMNS:
        many = Text("has {count} columns; at most {most} inputs are varied", count=len(lines[0]), most=LIST_COLUMNS)
        raise _bad(path, 1, many)
    inputs = [Varied(key.strip()) for key in lines[0]]
    errors: list[InputError] = []
    kinds = [_about(document, column.key, errors) for column in inputs]
    inputs = inputs if errors else [Varied(current(document.data, column.key)) for column in inputs]
    if not errors and (twice := same_input(document, inputs)) is not None:
        errors.append(InputError(1, twice, "", Text("stands in two columns; each input has one")))
    rows: list[tuple[Value | None, ...]] = []
    for n, line in enumerate(lines[1:], 2):
        if len(errors) > MOST_MISTAKES:
            errors.append(InputError(n, "", "", Text("the rest was not looked at")))
            break
        if len(line) != len(inputs):
            cells = Text("has {count} cells; needs {low}", count=len(line), low=len(inputs))
            errors.append(InputError(n, "", "", cells))
            continue
        row: list[Value | None] = []
        for column, about, cell in zip(inputs, kinds, line):
            try:
                row.append(_value(cell.strip(), about) if cell.strip() else None)
            except ValueError as wrong:
                errors.append(InputError(n, column.key, cell[:LONGEST], Text("{wrong}", wrong=str(wrong))))
        rows.append(tuple(row))
    if errors:
        raise BadInput(path, errors)
    return inputs, rows


def same_input(document: Document, inputs: Sequence[Varied]) -> str | None:
    """The key of an input that another one of these is too, by whichever name of its element; None: all are
    different."""
    first: dict[tuple[str | int, ...], str] = {}
    data = document.data
    for variable in inputs:
        for key in every(document.data, variable.key):
            data = with_row(data, key)  # of a twin each bearing has a place of its own
            where = _place(data, key)
            if where in first:
                return first[where]
            first[where] = variable.key
    return None


def _place(data: Table, key: str) -> tuple[str | int, ...]:
    """Where an input stands; of one of schema 1 that has become many its key alone."""
    return (key,) if key in MANY else address(data, key)


def _about(document: Document, key: str, errors: list[InputError]) -> Quantity:
    try:
        return quantity_of(document.data, key)
    except BadInput as bad:
        errors += [replace(e, line=1) for e in bad.errors]
        return Quantity("text", Text(key))


def _bad(path: str, line: int, reason: Text) -> BadInput:
    return BadInput(path, [InputError(line, "", "", reason)])


def _read(
    document: Document,
    option: str,
    texts: Sequence[str],
    form: Text,
    read_input: Callable[[str, str, Quantity], Varied],
) -> list[Varied]:
    inputs: list[Varied] = []
    errors: list[InputError] = []
    for text in texts:
        key, equals, spec = (part.strip() for part in text.partition("="))
        try:
            about = quantity_of(document.data, key) if equals and spec else None
            if about is None:
                raise BadInput(option, [InputError(0, text, "", form)])
            key = current(document.data, key)
            variable = read_input(key, spec, about)
            single = about.count is not None and about.count[0] == 1  # where one number may stand for the list
            whole = about.kind in ("series", "integers") and not isinstance(_place(document.data, key)[-1], int)
            if whole and not single:
                raise ValueError(f"is a list; vary one of its numbers by its place, like {key}.0")
            if (twice := same_input(document, [*inputs, variable])) == key:
                raise ValueError("stands twice; give all its values at once")
            if twice is not None:
                raise ValueError(f"is {twice}, which stands here too")
            inputs.append(variable)
        except BadInput as bad:
            errors += [replace(e, key=f"{option} {e.key}") for e in bad.errors]
        except ValueError as wrong:
            errors.append(InputError(0, f"{option} {key}", spec, Text("{wrong}", wrong=str(wrong))))
    if errors:
        raise BadInput(document.place, errors)
    return inputs


def _ends(spec: str, form: Text) -> tuple[float, float]:
    try:
        low, high = map(float, spec.split(":"))
    except ValueError:
        raise ValueError(form.partition(", like")[0]) from None
    if not low < high or high - low == float("inf"):
        raise ValueError("must go from a lower number to a higher one")
    return low, high


def _value(cell: str, about: Quantity) -> Value:
    """What stands in one cell of a list."""
    if about.kind in ("text", "choice", "date"):
        return cell
    if ":" in cell or "," in cell:
        raise ValueError("must be one value; a point stands before decimals")
    return _values(cell, about)[0]


def _values(spec: str, about: Quantity) -> tuple[Value, ...]:
    """`1000:3000:21` or `1000,1500,2000`."""
    words = about.kind in ("text", "choice", "date", "flag")
    parts = [part.strip() for part in spec.split("," if "," in spec or words else ":")]
    if about.kind == "flag":
        if not set(parts) <= set(FLAGS):
            raise ValueError("must be true or false, or both: true,false")
        return tuple(FLAGS[part] for part in parts)
    if words:
        return tuple(parts)
    try:
        numbers = [float(part) for part in parts]
    except ValueError:
        raise ValueError(FORM.partition(", like")[0]) from None
    if ":" in spec:
        if len(numbers) != 3 or not numbers[2].is_integer() or numbers[2] < 1:
            raise ValueError("must be LOW:HIGH:NUMBER with a whole NUMBER of values, 1 or more")
        if numbers[2] > MOST_ROWS:
            raise ValueError(f"asks for {parts[2]} values; at most {MOST_ROWS} designs at once")
        if not math.isfinite(numbers[1] - numbers[0]):
            raise ValueError("must go from LOW to HIGH by a finite way; give two finite numbers")
        if numbers[2] == 1 and numbers[0] != numbers[1]:
            raise ValueError("one value can not reach from LOW to HIGH; ask for 2 or more, or give the value alone")
        numbers = np.linspace(numbers[0], numbers[1], int(numbers[2])).tolist()
    if about.kind in ("integer", "integers"):
        if not all(n.is_integer() for n in numbers):
            raise ValueError(f"must be whole numbers here; these are {', '.join(f'{n:g}' for n in numbers[:6])}")
        return tuple(int(n) for n in numbers)
    return tuple(numbers)


# --- which designs are computed, in which order
# Each is known by its place alone, so that a run may begin anywhere.

Combination = tuple[Value | None, ...]  # the values of the varied inputs; None: as the design has it
SIGMAS = 3.0  # standard deviations from the middle of a tolerance to its ends


@record
class SweepPlan:
    """`count` designs over some inputs: `way` is "grid", "list", "hypercube" or "monte-carlo"."""

    way: str
    inputs: tuple[Varied, ...]
    count: int
    seed: int = 0
    combinations: tuple[Combination, ...] = ()  # of a list

    def rows(self, start: int, stop: int) -> list[Combination]:
        """The combinations from one place up to another."""
        stop = min(stop, self.count)
        if self.way == "list":
            return list(self.combinations[start:stop])
        if self.way == "grid":
            return [self._of_grid(n) for n in range(start, stop)]
        shares = [_shares(self.way, self.count, self.seed, n)[start:stop].tolist() for n in range(len(self.inputs))]
        return [tuple(_drawn(variable, share) for variable, share in zip(self.inputs, row)) for row in zip(*shares)]

    def part(self, start: int, stop: int) -> "SweepPlan":
        """Those from one place up to another as a list, whose inputs have no values of their own."""
        rows = tuple(self.rows(start, stop))
        return SweepPlan("list", tuple(Varied(variable.key) for variable in self.inputs), len(rows), combinations=rows)

    def _of_grid(self, n: int) -> Combination:
        """Every combination, the last input changing fastest."""
        values: list[Value] = []
        for variable in reversed(self.inputs):
            n, place = divmod(n, len(variable.values))
            values.append(variable.values[place])
        return tuple(reversed(values))


def grid(inputs: Sequence[Varied], place: str = "--vary") -> SweepPlan:
    """Every combination of the values."""
    return SweepPlan("grid", tuple(inputs), _allowed(prod(len(variable.values) for variable in inputs), place))


def sampled(inputs: Sequence[Varied], count: int, seed: int = 1, *, hypercube: bool) -> SweepPlan:
    """Designs at random; with `hypercube` so that each of `count` equal parts of every input's range has one design."""
    option = "--hypercube" if hypercube else "--monte-carlo"
    errors = [InputError(0, option, str(count), Text("must be a number of designs, 1 or more"))] if count < 1 else []
    if errors := errors + ([InputError(0, "--seed", str(seed), Text("must be 0 or more"))] if seed < 0 else []):
        raise BadInput("sweep", errors)
    return SweepPlan("hypercube" if hypercube else "monte-carlo", tuple(inputs), _allowed(count, option), seed)


def _allowed(rows: int, option: str) -> int:
    if rows > MOST_ROWS:
        why = Text("asks for {rows} designs; at most {most_rows} at once", rows=rows, most_rows=MOST_ROWS)
        raise BadInput("sweep", [InputError(0, option, "", why)])
    return rows


@lru_cache(64)
def _shares(way: str, count: int, seed: int, place: int) -> Array:
    """Where in its range each design has one input, from 0 to 1; every input has a stream of its own."""
    stream = np.random.Generator(np.random.PCG64([seed, place]))
    inside = stream.random(count)
    return (stream.permutation(count) + inside) / count if way == "hypercube" else inside


def _drawn(variable: Varied, share: float) -> Value:
    if variable.values:
        return variable.values[min(int(share * len(variable.values)), len(variable.values) - 1)]
    low, high = variable.ends
    if variable.whole:
        return min(int(low + share * (high - low + 1)), int(high))
    if variable.normal:  # cut off at the ends of the tolerance: parts beyond them are not let through
        out = NORMAL.cdf(-SIGMAS)
        share = (NORMAL.inv_cdf(out + share * (1 - 2 * out)) / SIGMAS + 1) / 2
    return low + min(max(share, 0.0), 1.0) * (high - low)


NORMAL = NormalDist()
