# SPDX-License-Identifier: Apache-2.0
"""`contralbero check`: solve a design and print values, checks and verdicts."""

from argparse import Namespace
from collections.abc import Iterable

from assistant.plain import print_results, results_json
from calc.design import STEPS
from calc.design_file import Document, design, parse_assignment, read
from calc.sheet.errors import BadInput, InputError
from calc.sheet.step import Outcome
from calc.solve import solve


def run(asked: Namespace) -> int:
    keys = [step.key for step in STEPS]
    if asked.step is not None and asked.step not in keys:
        raise BadInput("--step", [InputError(0, "", asked.step, "is no step; the steps are " + ", ".join(keys))])
    document = with_changes(read(asked.file), asked.changes)
    results = solve(design(document))
    if asked.json:
        import json

        print(json.dumps(results_json(document, results, asked.step), ensure_ascii=False, indent=1))
    else:
        print_results(results, asked.step)
    return exit_code(results.outcomes.values() if asked.step is None else [results.outcomes[asked.step]])


def with_changes(document: Document, changes: Iterable[str]) -> Document:
    """The document with every KEY=VALUE applied; all wrong ones are named at once."""
    errors: list[InputError] = []
    for change in changes:
        try:
            document = document.with_value(*parse_assignment(change))
        except BadInput as bad:
            errors += bad.errors
    if errors:
        raise BadInput("--set", errors)
    return document


def exit_code(outcomes: Iterable[Outcome]) -> int:
    """1 where a limit fails, 3 where a step found no solution."""
    verdicts = {outcome.verdict for outcome in outcomes}
    return 3 if "no_solution" in verdicts else 1 if "fail" in verdicts else 0
