# SPDX-License-Identifier: Apache-2.0
"""A scripted session: a design, edits, and what is expected of the results."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Protocol, TypedDict, TypeGuard, get_args

from ..sheet.check import ORDER
from ..sheet.errors import BadInput, InputError, written
from ..sheet.number import short
from ..sheet.text import Text
from ..sheet.verdict import State
from .addresses import Table, value_at
from .disk import bare_name
from .limits import REPLAY_REPORTS, REPLAY_STEPS
from .model import SCHEMA, Design
from .toml_file import Document, current_document, design, read, read_as_it_is

if TYPE_CHECKING:
    from ..solve import Results

STEP = Text(
    'must be set = "KEY", to = VALUE, or unset = "KEY", or set = { "KEY" = VALUE, … } and unset = ["KEY", …] for '
    "several at once, "
    'or undo = true, or report = "out.pdf"'
)
RECORDED = "recorded"
KINDS = ("reference", RECORDED)
NAMED = ("value", "check", "step", "design")  # one of them says what an expectation is about
OF_DESIGN = [state for state in get_args(State) if state not in ("blocked", "not_asked", "computed")]
Report = Callable[[Document, "Results", Path], None]
Solve = Callable[[Design, "Results | None"], "Results"]  # a design, after an earlier one


class Complain(Protocol):
    """Notes what is wrong at a key of the replay, and the value that stands there."""

    def __call__(self, key: str, reason: Text, value: object = None) -> None: ...


class Step(TypedDict, total=False):
    """One [[step]] of a replay."""

    set: str | Table
    to: object
    unset: str | list[str]
    undo: bool
    report: str


Expect = TypedDict(
    "Expect",
    {
        "value": str,
        "check": str,
        "step": str,
        "design": str,
        "is": float,
        "unit": str,
        "rel": float,
        "abs": float,
        "verdict": str,
        "kind": str,
        "source": str,
        "after": int,
    },
    total=False,
)


@dataclass(frozen=True)
class Compared:
    """One expectation beside what came out.  `now`: what it would have to expect, under the key `under`; None where
    there is no such thing."""

    about: str
    expected: str
    found: str
    agrees: bool
    kind: str
    source: str
    under: str
    now: float | str | None

    @property
    def text(self) -> str:
        source = f"   [{self.source}]" if self.source else ""
        return f"{'✓' if self.agrees else '✗'} {self.about}: {self.found}, expected {self.expected}{source}"


@dataclass(frozen=True)
class Script:
    """A replay as its file has it."""

    place: str
    start: Document
    steps: tuple[Step, ...]
    expects: tuple[Expect, ...]
    lines: dict[str, int]
    raw: bytes


def load(path: Path | str) -> Script:
    """Read a replay file.  Raises BadInput with every error in it."""
    return script(read_as_it_is(path))  # the same care with files that are no TOML


def script(raw: Document) -> Script:
    """The replay in a TOML text, whose place is that of its file.  Raises BadInput with every error in it."""
    path, data, errors = Path(raw.place), raw.data, []

    def error(key: str, reason: Text, value: object = None) -> None:
        where = key
        while where and where not in raw.lines:
            where = where.rpartition(".")[0]
        errors.append(InputError(raw.lines.get(where, 1), key, "" if value is None else written(value), reason))

    for key in data:
        if key not in {"schema", "design", "step", "expect", "name", "note"}:
            error(key, Text("is not known; a replay has schema, name, note, design, [[step]] and [[expect]]"))
    if data.get("schema") not in (1, SCHEMA):
        error("schema", Text("must be 1 or {n}", n=SCHEMA))
    steps, expects = data.get("step", []), data.get("expect", [])
    for key, rows in (("step", steps), ("expect", expects)):
        if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
            error(key, Text("must be an array of tables: [[{key}]]", key=key))
            steps, expects = [], []
    assert isinstance(steps, list) and isinstance(expects, list)
    for what, count, most in (
        ("steps", len(steps), REPLAY_STEPS),
        ("steps that write a report", sum("report" in row for row in steps), REPLAY_REPORTS),
    ):
        if count > most:
            error("step", Text("has {count} {what}; a replay has at most {most}", count=count, what=what, most=most))
            steps = []
    for i, row in enumerate(steps):
        _check_step(f"step.{i}", row, error)
    for i, row in enumerate(expects):
        _check_expect(f"expect.{i}", row, len(steps), error)
    start: Document | None = None
    given = data.get("design")
    if isinstance(given, str) and not (given and given.isprintable()):
        error("design", Text("must be the path of a design file, in signs that can be printed"), given)
    elif isinstance(given, str):
        start = read(path.parent / given)
    elif isinstance(given, dict):
        lines = {k.removeprefix("design."): n for k, n in raw.lines.items() if k.startswith("design.")}
        start = current_document(Document(given, raw.place, lines, raw.raw))
    else:
        error("design", Text("is missing; needs the path of a design file, or a whole [design] table"))
    if not expects and "expect" not in data:
        error("expect", Text("is missing; a replay needs at least one [[expect]]"))
    if errors:
        raise BadInput(raw.place, errors)
    assert start is not None
    return Script(raw.place, start, tuple(steps), tuple(expects), raw.lines, raw.raw)


def _check_step(key: str, row: Table, error: Complain) -> None:
    for unknown in [key for key in row if key not in Step.__annotations__]:
        error(f"{key}.{unknown}", Text("is not known; a step has set and to, or unset, or undo, or report"))
    single, many = isinstance(row.get("set"), str), isinstance(row.get("set"), dict) and bool(row["set"])
    gone = row.get("unset")
    several = isinstance(gone, list) and bool(gone) and all(isinstance(name, str) for name in gone)
    kinds = ("set" in row or "unset" in row) + ("undo" in row) + ("report" in row)
    wrong = kinds != 1 or single != ("to" in row) or ("set" in row and not single and not many)
    if "unset" in row:
        wrong |= single or not (isinstance(gone, str) or several)
    name = row.get("report", "out.pdf")
    if wrong or not isinstance(name, str) or row.get("undo", True) is not True:
        error(key, STEP)
    elif not bare_name(name) or not name.lower().endswith(".pdf"):
        must = Text("must be the bare name of a PDF file, which is written beside the replay, like out.pdf")
        error(f"{key}.report", must, name)


def _check_expect(key: str, row: Table, steps: int, error: Complain) -> None:
    for unknown in [key for key in row if key not in Expect.__annotations__]:
        error(f"{key}.{unknown}", Text("is not known; an expectation has ") + ", ".join(sorted(Expect.__annotations__)))
    named = [row[name] for name in NAMED if name in row]
    if len(named) != 1 or not isinstance(named[0], str):
        error(key, Text("must name one value, check or step, or the state of the design"))
    if row.get("kind", RECORDED) not in KINDS:
        error(key, Text('needs kind = "reference" or "recorded"'))
    if "value" in row:
        if not _number(row.get("is")):
            error(key, Text("needs is = NUMBER"))
        tolerances = [row[name] for name in ("rel", "abs") if name in row]
        if not tolerances or not all(_number(t) and t >= 0 for t in tolerances):
            error(key, Text("needs a tolerance: rel or abs, a number of 0 or more"))
        if "kind" not in row:
            error(key, Text('needs kind = "reference" or "recorded"'))
        if row.get("kind") == "reference" and not row.get("source"):
            error(key, Text("a reference value needs its source"))
    elif "design" in row:
        if row["design"] not in OF_DESIGN or "verdict" in row:
            error(key, Text("needs design = one of ") + ", ".join(OF_DESIGN))
    elif row.get("verdict") not in ORDER:
        error(key, Text("needs verdict = one of ") + ", ".join(ORDER))
    after = row.get("after", steps)
    if not isinstance(after, int) or isinstance(after, bool) or not 0 <= after <= steps:
        error(f"{key}.after", Text("must be a step from 0 to {steps}", steps=steps))


def _number(x: object) -> TypeGuard[float]:
    return isinstance(x, (int, float)) and not isinstance(x, bool) and abs(x) < 1e300 and math.isfinite(x)


def run(script: Script, solve: Solve, report: Report | None = None) -> list[Compared]:
    """Play a script and compare; in the order of the expectations.

    `solve`: that of the program.  `report`: writes the PDFs that the script asks for, beside it."""
    history = [script.start]
    results = solve(design(script.start), None)
    compared: dict[int, Compared] = {}
    for number in range(len(script.steps) + 1):
        if number:
            step = script.steps[number - 1]
            if "set" in step or "unset" in step:
                history.append(_edited(script, number, history[-1], step))
            elif "undo" in step and len(history) > 1:
                history.pop()
            if "report" not in step:
                results = solve(design(history[-1]), results)
            elif report is not None:
                report(history[-1], results, target(script, step))
        for n, row in enumerate(script.expects):
            if row.get("after", len(script.steps)) == number:
                compared[n] = compare(results, row)
    return [compared[n] for n in sorted(compared)]


def moved(compared: list[Compared]) -> dict[int, Compared]:
    """The expectations that were recorded and do not come out any more, by their places: what they would have to
    expect is known."""
    return {n: c for n, c in enumerate(compared) if not c.agrees and c.kind == RECORDED and c.now is not None}


def target(script: Script, step: Step) -> Path:
    """The file that a step writes its report to."""
    return Path(script.place).with_name(step["report"])


def changes(step: Step) -> list[tuple[str, object]]:
    """What one step changes, in the order in which it is done: keys that it takes out (None), then keys that it
    sets."""
    gone, given = step.get("unset", []), step.get("set", {})
    taken = [(key, None) for key in ([gone] if isinstance(gone, str) else gone)]
    return [*taken, *([(given, step["to"])] if isinstance(given, str) else given.items())]


def played(document: Document, step: Step) -> Document:
    """The document with the changes of one step.  Raises BadInput where there is no such key; the design is not
    checked."""
    for key, value in changes(step):
        if value is None and value_at(document.data, key, whole=True) is None:
            raise BadInput(document.place, [InputError(0, key, "", Text("is not there, so it can not be taken out"))])
        document = document.with_value(key, value)
    return document


def _edited(script: Script, number: int, document: Document, step: Step) -> Document:
    """The document after one step; an edit that can not be made is an error of the replay file, at that step."""
    try:
        edited = played(document, step)
        design(edited)
    except BadInput as bad:
        line = script.lines.get(f"step.{number - 1}", 0)
        raise BadInput(script.place, [InputError(line, e.key, e.value, e.reason) for e in bad.errors]) from None
    return edited


def compare(results: "Results", row: Expect) -> Compared:
    """One expectation against results."""
    kind, source = row.get("kind", ""), row.get("source", "")
    if "design" in row:
        state = results.verdict
        return Compared("design", row["design"], state, state == row["design"], kind, source, "design", state)
    if "check" in row:
        check = results.check(row["check"])
        return _compared_verdict(row["check"], row, check.verdict if check else None, "no such check")
    if "step" in row:
        outcome = results.outcomes.get(row["step"])
        return _compared_verdict(row["step"], row, outcome.verdict if outcome else None, "no such step")
    name, expected, unit = row["value"], float(row["is"]), row.get("unit", "")
    value = results.values().get(name)
    tolerance = max(abs(row.get("rel", 0.0) * expected), row.get("abs", 0.0))
    text = f"{short(expected, 6)} ± {short(tolerance, 2)} {unit}".rstrip()
    if value is None:
        return Compared(name, text, "no such value", False, kind, source, "is", None)
    found = f"{short(value.shown, 6)} {value.unit}".rstrip()
    if value.unit != unit:
        return Compared(name, text, wrong_unit(value.unit, unit), False, kind, source, "unit", None)
    there = math.isfinite(value.shown)
    agrees = there and abs(value.shown - expected) <= tolerance * (1 + 1e-9)
    now = _rounded(value.shown, row) if there else None
    return Compared(name, text, found, agrees, kind, source, "is", now)


def wrong_unit(right: str, given: str) -> Text:
    """What is said of an expectation in another unit than that of its value: nothing was compared."""
    if not given:
        return Text('has no unit; the value is in {right}: write unit = "{right}"', right=right)
    if not right:
        return Text('the unit {given} is wrong; the value has none: write unit = ""', given=given)
    sentence = 'the unit {given} is wrong; the value is in {right}: write unit = "{right}", and the number in it'
    return Text(sentence, given=given, right=right)


def _compared_verdict(about: str, row: Expect, verdict: str | None, none: str) -> Compared:
    """A step that was said to pass may be one that only computes: before version 0.2 there was no word for it."""
    agrees = verdict == row["verdict"] or ("step" in row and (row["verdict"], verdict) == ("pass", "computed"))
    kind, source = row.get("kind", ""), row.get("source", "")
    return Compared(about, row["verdict"], verdict or none, agrees, kind, source, "verdict", verdict)


def _rounded(number: float, row: Expect) -> float:
    """With as few digits as leave nine tenths of the tolerance."""
    tolerance = max(abs(row.get("rel", 0.0) * number), row.get("abs", 0.0))
    rounded = (float(f"{number:.{digits}g}") for digits in range(4, 17))
    return next((x for x in rounded if abs(x - number) <= tolerance / 10), number)
