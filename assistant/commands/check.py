# SPDX-License-Identifier: Apache-2.0
"""`contralbero check` and `contralbero explain`: the results of a design, and the way that leads to one of them.

check: solves a design and prints its verdicts, main values and findings, or all that it gives.  explain: prints the
chain of formulas that leads to one value, back to the inputs."""

import sys
from argparse import Namespace
from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any

from assistant.commands.published import reference_lines
from assistant.results_text import print_results, results_json
from calc.design.addresses import address, parse_assignment, value_at
from calc.design.key_results import outside
from calc.design.limits import SEARCH_SECONDS
from calc.design.model import STEPS, Design
from calc.design.toml_file import Document, design, load, read
from calc.design.toml_file import design as design_of
from calc.library.publications import resolved
from calc.sheet.check import named
from calc.sheet.errors import BadInput, Cancelled, InputError
from calc.sheet.number import short
from calc.sheet.progress import at_most
from calc.sheet.step import Outcome
from calc.sheet.text import Text
from calc.sheet.value import Line
from calc.solve import Results, solve
from calc.studies.explain import Chains, Link, chain, origin, shortened

TRIES = 40  # designs that may be solved for checks that no search is made for: about a second


def run_check(asked: Namespace) -> int:
    known_step(asked.step)
    file, changes = asked.file, list(asked.changes)
    if file is None and changes and "=" not in changes[-1]:
        file = changes.pop()  # `check --set KEY=VALUE FILE`
    if file is None:
        raise BadInput(
            "contralbero check",
            [InputError(0, "", "", Text("needs a design; usage: contralbero check FILE [--set KEY=VALUE …]"))],
        )
    document, changed_design = changed(read(file), changes)
    results = solve(changed_design)
    verdict = exit_code(results.outcomes.values() if asked.step is None else [results.outcomes[asked.step]])
    if asked.json:
        import json

        print(
            json.dumps(
                results_json(document, results, asked.step, changes, measured=True), ensure_ascii=False, indent=1
            )
        )
    else:
        print_results(results, asked.step, everything=not asked.short, findings=asked.all)
        if asked.step is None and not asked.all:
            print(
                f"\nall values, tables and checks: --all, or --step "
                f"{'|'.join(step.key for step in changed_design.asked())}"
            )
        sys.stdout.flush()  # the verdicts are there before the search ends
        if verdict:
            print("\n" + "\n".join(nearest_passing(document, results, file, changes, asked.step, short=asked.short)))
    return verdict


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
    import shlex  # for a design that fails only

    from calc.design.locks import standing
    from calc.sheet.check import named
    from calc.studies.repair.nearest import nearest
    from calc.studies.repair.state import warned

    try:
        repair = nearest(document, results, progress=at_most(SEARCH_SECONDS), only=step, tries=TRIES)
    except Cancelled:
        return [
            Text("no passing design found in {seconds} s; --step STEP looks for one step alone", seconds=SEARCH_SECONDS)
        ]
    kept = {change.partition("=")[0] for change in repair.changes}
    all_changes = [*(change for change in changes if change.partition("=")[0].strip() not in kept), *repair.changes]
    kept_as = [f"kept as locked: {key} ({reason})" for key, reason in standing(document.data).items()]
    asked = ["--step", step] if step is not None else []
    command = shlex.join(["contralbero", "check", file, "--set", *all_changes, *asked, *(["--short"] if short else [])])
    if not repair.left:
        warnings = [
            warning for warning in warned(results, repair.results) if step is None or warning.id.startswith(f"{step}.")
        ]
        then = [f"with new warnings: {named(warnings)}"] if warnings else []
        return [*kept_as, f"to pass: {repair.words}", *then, f"nearest passing design: {command}"]
    lines = [f"repairs a part: {repair.words}", f"a part of the way: {command}"] if repair.changes else []
    lines += [f"still fails: {unmended.id}: {unmended.why}" for unmended in repair.left[1:]]
    first = repair.left[0]
    return [*kept_as, *lines, f"no passing design found: {first.id} still fails: {first.why}"]


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
    try:
        changed_design = design(document)
    except BadInput as bad:
        raise BadInput(document.place, errors + [replace(e, key=asked.get(e.key, e.key)) for e in bad.errors]) from None
    if errors:
        raise BadInput(document.place, errors)
    return document, changed_design


def exit_code(outcomes: Iterable[Outcome[object]]) -> int:
    """1 where a limit fails, 3 where a step found no solution."""
    verdicts = {outcome.verdict for outcome in outcomes}
    return 3 if "no_solution" in verdicts else 1 if "fail" in verdicts else 0


# --- contralbero explain


def run_explain(asked: Namespace) -> int:
    document, design = load(asked.file)
    return _explain(asked, document, design)


def _scenario(asked: Namespace, document: Document, design: Design) -> int:
    """A scenario is the design with its keys set: that one is explained."""
    from calc.friction.studies.scenarios import as_design

    friction = design.friction
    assert friction is not None
    scenario = next(s for s in friction.scenarios if asked.value.startswith(f"friction.scenarios.{s.name}."))
    name, rest = scenario.name, asked.value.removeprefix(f"friction.scenarios.{scenario.name}.")
    changes = as_design(friction, scenario, design.bearings is not None)
    for key, value in changes.items():
        document = document.with_value(key, value)
    if not asked.json:
        assignments = ", ".join(
            f"{key} left out" if value is None else f"{key} = {value}" for key, value in changes.items()
        )
        print(f"scenario {name}: the design with {assignments or 'nothing changed'}\n")
    return _explain(Namespace(**{**vars(asked), "value": f"friction.{rest}"}), document, design_of(document))


def _explain(asked: Namespace, document: Document, design: Design) -> int:
    results = solve(design, traced=True)
    values = results.values()
    if asked.value not in values and (given := _given(document.data, asked.value)) is not None:
        print(f"{asked.value} = {given}   an input of the design file")
        return 0
    if asked.value not in values:
        from difflib import get_close_matches

        for check in results.checks():
            if check.id == asked.value:
                chains = Chains(results)
                head = (
                    f"{check.id}: {check.name}, {short(check.value)} {check.unit}".rstrip()
                    + f", needs {check.limit_text()}."
                )
                if (judged := chains.behind(check)) is not None:
                    if not asked.json:
                        print(f"{head} Its value:\n")
                    return _explain(Namespace(**{**vars(asked), "value": judged}), document, design)
                lines, taken = chains.of_check(check)
                return _print_chain(
                    asked, design, f"{head} {check.source}", lines, ", ".join(taken), ", ".join(check.moved_by)
                )
        step = results.outcomes.get(asked.value.partition(".")[0])
        if step is not None and step.state != "solved":
            state = step.state.replace("not_asked", "not used").replace("_", " ")
            why = step.reason or Text("the design does not use it")
            reason = Text("its step has no values: {state}: {why}", state=state, why=why)
            raise BadInput(document.place, [InputError(0, asked.value, "", reason)])
        near = get_close_matches(asked.value, list(values), 3, 0.4)
        hint = (
            Text("did you mean {ids}?", ids=", ".join(near))
            if near
            else Text("`contralbero check FILE --all` lists the values")
        )
        raise BadInput(
            document.place, [InputError(0, asked.value, "", Text("is not a value of this design; {hint}", hint=hint))]
        )
    if asked.value.startswith("friction.scenarios."):
        return _scenario(asked, document, design)
    value = values[asked.value]
    head = f"{value.id} = {short(value.shown, 6)} {value.unit}   {value.label}{_beyond(results, value.id)}"
    return _print_chain(asked, design, head, chain(results, asked.value), origin(results, asked.value))


def _beyond(results: Results, id: str) -> str:
    """What puts the checks on a value, that hold, outside the validity of its formula; a line of its own."""
    checks = results.outcomes[id.partition(".")[0]].checks
    judged_by = [check for check in checks if check.value_id == id and check.verdict == "pass"]
    methods = list(dict.fromkeys(method for check in judged_by for method in outside(check, checks)))
    return f"\nIts check holds by a formula outside its validity: {named(methods)}" if methods else ""


def _print_chain(
    asked: Namespace, design: Design, head: str, lines: list[Link], taken: str | None, moved: str = ""
) -> int:
    """`taken`: the inputs of a number that no line gave; `moved`: those that move it."""
    from calc.sheet.expression import line_json, line_text

    if asked.json:
        import json

        print(
            json.dumps(
                [line_json(link.line) | {"inputs": list(link.inputs)} | _provenance(link.line) for link in lines],
                ensure_ascii=False,
                indent=1,
            )
        )
        return 0
    print(f"{head}\n")
    for link in lines:
        formula, numbers, source = line_text(link.line)
        print(f"{formula}\n    {numbers}\n    {source}" + (f"   [{link.line.about}]" if link.line.about else ""))
        for key in shortened(link.inputs, design):
            print(f"    ← {key}")
    for n, line in enumerate(reference_lines(link.line.formula.source for link in lines)):
        print(line if n else f"\nSources\n{line}")
    if not lines:
        other = f"moved by the inputs: {moved}" if moved else "no recorded formula returns this number itself"
        print(f"taken from the inputs: {taken}" if taken else other)
    return 0


def _provenance(line: Line) -> dict[str, Any]:
    """What stands behind the source of a line: its kind, or the publications that it names, and how we know them."""
    origin = resolved(line.formula.source)
    return {
        "kind": origin.kind,
        "publications": [
            {
                "name": c.name,
                "title": c.publication.title,
                "edition": c.publication.edition,
                "status": c.publication.status,
                "known": str(c.known),
                "places": list(c.places),
            }
            for c in origin.citations
        ],
    }


def _given(data: dict[str, Any], key: str) -> Any:
    """What the design file says under a key, None where it is no key or is left out."""
    try:
        return value_at(data, key)
    except BadInput:
        return None
