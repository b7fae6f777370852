# SPDX-License-Identifier: Apache-2.0
"""`contralbero check`: solve a design and print its verdicts, main values and findings, or all that it gives."""

import json
import shlex
import sys
from argparse import Namespace
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from assistant.fits_text import print_fits, with_fits
from assistant.named_files import each, files_of, many, read_design
from assistant.results_text import errors_json, print_results, print_runs, results_json, state_words
from calc.design.addresses import Table, address, every, parse_assignment
from calc.design.limits import SEARCH_SECONDS
from calc.design.locks import standing
from calc.design.model import STEPS, Design
from calc.design.toml_file import Document, design
from calc.design.upgrade import current
from calc.sheet.errors import BadInput, Cancelled, InputError
from calc.sheet.progress import at_most
from calc.sheet.text import Text
from calc.sheet.verdict import named
from calc.solve import Results, solve

if TYPE_CHECKING:
    from calc.studies.fit_results import DesignFit

TRIES = 40  # designs that may be solved for checks that no search is made for: about a second


def run_check(asked: Namespace) -> int:
    """Of several files one block each; the exit code is the worst of theirs."""
    known_step(asked.step)
    names, changes = list(asked.files), list(asked.changes)
    while not asked.files and changes and "=" not in changes[-1]:
        names.insert(0, changes.pop())  # `check --set KEY=VALUE FILE`
    if not names:
        raise BadInput(
            "contralbero check",
            [InputError(0, "", "", Text("needs a design; usage: contralbero check FILE… [--set KEY=VALUE …]"))],
        )
    files = files_of(names)
    if not many(names, files):
        code, about = _check(asked, files[0], changes)
        if asked.json:
            _print_json(about)
        return code
    objects: list[dict[str, Any]] = []

    def work(file: str) -> int:
        if not asked.json and not asked.quiet:
            print(f"{'' if file is files[0] else chr(10)}{file}")
        code, about = _check(asked, file, changes, f"{file}: " if asked.quiet else "")
        objects.append({"file": file, **about})
        return code

    code = each(files, work, lambda file, bad: objects.append({"file": file, "errors": errors_json(bad)}))
    if asked.json:
        _print_json(objects)
    return code


def _print_json(found: object) -> None:
    print(json.dumps(found, ensure_ascii=False, indent=1))


def _check(asked: Namespace, file: str, changes: Sequence[str], before: str = "") -> tuple[int, dict[str, Any]]:
    """One design; gives its exit code and its JSON, which is empty where nobody asked for it."""
    document, changed_design = changed(read_design(file), changes)
    results = solve(changed_design)
    results.demand_runs(document)
    state = results.verdict if asked.step is None else results.outcomes[asked.step].verdict
    code = exit_code(state, asked.strict)
    if asked.json:
        found = results_json(document, results, asked.step, changes, measured=True)
        return code, with_fits(found, _fits(document, results, asked))
    if asked.quiet:
        print(f"{before}{state_words(results, asked.step)}")
        return code, {}
    print_results(results, asked.step, everything=not asked.short, findings=asked.all)
    if asked.step is None and not asked.all:
        print(
            f"\nall values, tables and checks: --all, or --step {'|'.join(step.key for step in changed_design.asked())}"
        )
    sys.stdout.flush()  # the verdicts are there before the nodes of runs are solved, and before the search ends
    print_runs(results, asked.step, tables=asked.all or asked.step is not None)
    sys.stdout.flush()
    print_fits(changed_design, _fits(document, results, asked), whole=asked.all)
    sys.stdout.flush()
    if state in EXITS:
        print("\n" + "\n".join(nearest_passing(document, results, file, changes, asked.step, short=asked.short)))
    return code, {}


def _fits(document: Document, results: Results, asked: Namespace) -> "Mapping[str, DesignFit | Text]":
    """The fits that are asked for; none without --fits."""
    if not asked.fits or not results.design.fits:
        return {}
    from calc.studies.fits import fits_of  # which a check without any does not load

    return fits_of(document, results)


def nearest_passing(
    document: Document,
    results: Results,
    file: str,
    changes: Sequence[str],
    step: str | None = None,
    *,
    short: bool = False,
) -> list[str]:
    """What would make a failing design pass, in words; then, as the last line, the command that checks it so.

    `changes` are already in the document.  Where not all can be repaired, the last line says what still fails and why.
    """
    # the searches for better parts, which a check that passes does not load
    from calc.studies.repair.nearest import nearest
    from calc.studies.repair.state import warned

    try:
        repair = nearest(document, results, progress=at_most(SEARCH_SECONDS), only=step, tries=TRIES)
    except Cancelled:
        return [
            Text("no passing design found in {seconds} s; --step STEP looks for one step alone", seconds=SEARCH_SECONDS)
        ]
    kept = {change.partition("=")[0] for change in repair.changes}
    all_changes = [*(change for change in changes if not set_by(document.data, change) <= kept), *repair.changes]
    kept_as = [f"kept as locked: {key} ({reason})" for key, reason in standing(document.data).items()]
    asked = ["--step", step] if step is not None else []
    command = shlex.join(["contralbero", "check", file, "--set", *all_changes, *asked, *(["--short"] if short else [])])
    if not repair.left:
        after = repair.results if step is None else repair.results.outcomes[step]
        warnings = [
            warning for warning in warned(results, repair.results) if step is None or warning.id.startswith(f"{step}.")
        ]
        then = [f"with new warnings: {named(warnings)}"] if warnings else []
        if after.verdict in ("pass", "warn", "computed"):
            then += [f"then {after.words()}"] if after.verdict == "warn" else []
            return [*kept_as, f"to pass: {repair.words}", *then, f"nearest passing design: {command}"]
        mends = f"for no limit to fail: {repair.words}"
        return [*kept_as, mends, *then, f"then {after.words()}", f"nearest design in which no limit fails: {command}"]
    lines = [f"repairs a part: {repair.words}", f"a part of the way: {command}"] if repair.changes else []
    lines += [f"still fails: {unmended.id}: {unmended.why}" for unmended in repair.left[1:]]
    first = repair.left[0]
    return [*kept_as, *lines, f"no passing design found: {first.id} still fails: {first.why}"]


def set_by(data: Table, change: str) -> set[str]:
    """The keys of today that a KEY=VALUE sets."""
    return {current(data, key) for key in every(data, parse_assignment(change)[0])}


def known_step(step: str | None) -> None:
    """Raises BadInput where there is no such step."""
    keys = [known.key for known in STEPS]
    if step is not None and step not in keys:
        raise BadInput(
            "--step", [InputError(0, "", step, Text("is no step; the steps are {steps}", steps=", ".join(keys)))]
        )


def changed(document: Document, changes: Iterable[str]) -> tuple[Document, Design]:
    """The document with every KEY=VALUE applied, and its design; all that is wrong is named at once."""
    errors: list[InputError] = []
    asked: dict[str, str] = {}  # keys with the places of elements, and as the user names them
    for change in changes:
        key, value = parse_assignment(change)
        try:
            document = document.with_value(key, value)
        except BadInput as bad:
            errors += [replace(e, key=f"--set {e.key}") for e in bad.errors]
            continue
        with suppress(BadInput):  # of an element that has another name now
            asked[".".join(map(str, address(document.data, key, whole=True)))] = key

    def as_asked(error: InputError) -> InputError:
        return replace(error, key=asked[error.key], called="") if error.key in asked else error

    try:
        changed_design = design(document)
    except BadInput as bad:
        raise BadInput(document.place, errors + [as_asked(e) for e in bad.errors]) from None
    if errors:
        raise BadInput(document.place, errors)
    return document, changed_design


EXITS = {"no_solution": 3, "fail": 1}
DONE = ("pass", "computed", "not_asked")


def exit_code(state: str, strict: bool = False) -> int:
    """Of a state: 1 where a limit fails, 3 where there is no solution.  `strict`: 4 where nothing fails, but not all
    that is asked holds."""
    return EXITS.get(state, 4 if strict and state not in DONE else 0)
