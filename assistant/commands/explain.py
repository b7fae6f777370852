# SPDX-License-Identifier: Apache-2.0
"""`contralbero explain`: the chain of formulas that leads to one value, back to the inputs."""

import json
import re
from argparse import Namespace
from collections.abc import Iterator
from difflib import get_close_matches
from textwrap import fill
from typing import Any

from assistant.commands.published import reference_lines
from assistant.named_files import read_design
from assistant.results_text import shaft_words
from calc.bearings.plain.result import PlainResult
from calc.bearings.support import OnShaftResult
from calc.countershaft.result import CountershaftResult
from calc.design.addresses import every, quantities, quantity_of, value_at
from calc.design.key_results import outside
from calc.design.model import Design
from calc.design.toml_file import Document
from calc.design.toml_file import design as design_of
from calc.design.upgrade import current
from calc.friction.inputs import FrictionInputs
from calc.friction.studies.scenarios import as_design
from calc.library.publications import resolved
from calc.sheet.errors import BadInput, InputError
from calc.sheet.expression import line_json, line_text
from calc.sheet.number import short
from calc.sheet.quantity import Published, Quantity, dotted
from calc.sheet.text import Text
from calc.sheet.value import Line
from calc.sheet.verdict import named
from calc.solve import Results, solve
from calc.studies.explain import Chains, Link, chain, origin, shortened

ORDER = re.compile(r"order_(\d)")
SHARED = (PlainResult.load, OnShaftResult.share, OnShaftResult.displacement, OnShaftResult.tilt)
SCENARIOS = dotted(Design.friction, FrictionInputs.scenarios)


def run_explain(asked: Namespace) -> int:
    document = read_design(asked.file)
    return _explain(asked, document, design_of(document))


def _scenario(asked: Namespace, document: Document, design: Design) -> int:
    """A scenario is the design with its keys set: that one is explained."""
    friction = design.friction
    assert friction is not None
    scenario = next(s for s in friction.scenarios if asked.value.startswith(f"{SCENARIOS}.{s.name}."))
    name, rest = scenario.name, asked.value.removeprefix(f"{SCENARIOS}.{scenario.name}.")
    changes = as_design(friction, scenario, design.bearings is not None)
    for key, value in changes.items():
        document = document.with_value(key, value)
    if not asked.json:
        assignments = ", ".join(
            f"{key} left out" if value is None else f"{key} = {value}" for key, value in changes.items()
        )
        print(f"scenario {name}: the design with {assignments or 'nothing changed'}\n")
    return _explain(Namespace(**{**vars(asked), "value": dotted(Design.friction, rest)}), document, design_of(document))


def _explain(asked: Namespace, document: Document, design: Design) -> int:
    results = solve(design)
    values = results.values()
    own = design.of_original(asked.value)
    an_input = _input(document.data, asked.value)
    if an_input is not None and own != asked.value and None in an_input[1].values():
        an_input = None  # of a bearing of a twin, which has that of its original
    if asked.value not in values and an_input is not None:
        about, given = an_input
        for key, content in given.items():
            print(f"{key} = {content}   an input" if content is not None else f"{key}   an input, left out")
        told = f"{about.label}{f', {about.unit}' if about.unit else ''}. {about.help}"
        print(fill(told, 116, initial_indent="    ", subsequent_indent="    "))
        return 0
    of_shaft = asked.value.startswith(dotted(Design.shafts))
    known = asked.value in values or results.check(asked.value) is not None
    if not known and own != asked.value:
        name, original = asked.value.split(".")[1], own.split(".")[1]
        mirrored = any(shaft.name == name and shaft.mirrors for shaft in design.shafts)
        if not asked.json:
            said = f"{asked.value}: that of {original}" + (", which it mirrors" if mirrored else "")
            said += ": angles turn over" if mirrored and of_shaft else ""
            print(f"{said}\n")
        return _explain(Namespace(**{**vars(asked), "value": own}), document, design)
    if asked.value not in values and of_shaft and (inner := _inside(document.data, asked.value)):
        for key, content in inner.items():
            print(f"{key} = {content}   an input" if content is not None else f"{key}   an input, left out")
        return 0
    if asked.value not in values:
        if (check := results.check(asked.value)) is not None:
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
    if asked.value.startswith(f"{SCENARIOS}."):
        return _scenario(asked, document, design)
    value = values[asked.value]
    head = f"{value.id} = {short(value.shown, 6)} {value.unit}   {value.label}{_beyond(results, value.id)}"
    head += "".join(f"\n  {part}" for part in (*_summed(results, value), *on_films(results, value)))
    return _print_chain(asked, design, head, chain(results, asked.value), origin(results, asked.value))


def _summed(results: Results, value: Published) -> Iterator[str]:
    """Of what all shafts give together those that are in it, each with its force and its couple."""
    design, found = results.design, ORDER.search(value.id)
    if len(design.shafts) < 2 or found is None or not value.id.startswith("countershaft."):
        return
    for shaft in design.resolved:
        if abs(shaft.inputs.speed_ratio) == int(found[1]):
            ids = [dotted("countershaft", shaft.name, x) for x in (CountershaftResult.force, CountershaftResult.couple)]
            there = [results.values()[id] for id in ids if id in results.values()]
            numbers = ", ".join(f"{v.id} {short(v.shown)} {v.unit}" for v in there)
            yield f"{shaft_words(shaft)}: {numbers}"


def on_films(results: Results, value: Published) -> Iterator[str]:
    """Of what the films of a shaft share: how each of them holds it."""
    if not any(value in results.values_of(field) for field in SHARED):
        return
    values, shaft = results.values(), _above(_above(value.id))
    for share in results.values_of(OnShaftResult.share):
        if _above(bearing := _above(share.id)) == shaft:
            said = [f"{short(share.shown)} of its load on pins"]
            for words, key in (("ε", PlainResult.eccentricity), ("clearance", PlainResult.clearance_hot)):
                if (there := values.get(dotted(bearing, key))) is not None:  # of those on a film
                    said.append(f"{words} {short(there.shown)} {there.unit}".rstrip())
            yield f"{bearing.rpartition('.')[2]}: {', '.join(said)}"


def _above(id: str) -> str:
    return id.rpartition(".")[0]


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
    if asked.json:
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


def _inside(data: dict[str, Any], key: str) -> dict[str, object]:
    """What the design file says at the keys of a table."""
    return {inner: value_at(data, inner) for inner, _ in quantities(data) if inner.startswith(f"{key}.")}


def _input(data: dict[str, Any], key: str) -> tuple[Quantity, dict[str, object]] | None:
    """What is known of the input at a key, and by its key of today, or of all that a * in it stands for, what the
    design file says there (None: left out); None: no input."""
    try:
        return quantity_of(data, key), {current(data, each): value_at(data, each) for each in every(data, key)}
    except BadInput:
        return None
