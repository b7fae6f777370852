# SPDX-License-Identifier: Apache-2.0
"""`contralbero new`, `schema`, `completion` and `help`: what is made once, and how the rest is used.

A design of a shipped engine or a shipped design as it is, the JSON Schema by which editors complete and check a design,
the script by which a shell completes commands."""

import os
import sys
from argparse import Namespace
from difflib import get_close_matches
from pathlib import Path

from assistant.extras import demand
from assistant.named_files import STANDARD, demand_ending, put
from assistant.usage import COMMANDS, parser
from calc.design.addresses import as_list, parse_assignment
from calc.design.model import Design, step_of
from calc.design.schema import schema_text
from calc.design.toml_file import read
from calc.sheet.errors import BadInput, InputError, NoSolution
from calc.sheet.quantity import dotted
from calc.sheet.text import Text
from calc.studies.shipped import designs, engine_alone, engine_design, engines, shipped_name

# --- contralbero help [COMMAND]


def run_help(asked: Namespace) -> int:
    if asked.topic is None:
        parser().print_help()
    elif asked.topic in COMMANDS:
        parser(asked.topic).parse_args([asked.topic, "--help"])  # which ends here
    else:
        near = get_close_matches(asked.topic, COMMANDS, 1)
        hint = Text("did you mean {near}?", near=near[0]) if near else Text("`contralbero help` lists them")
        reason = Text("is no command; {hint}", hint=hint)
        raise BadInput("contralbero help", [InputError(0, "", asked.topic, reason)])
    return 0


# --- contralbero completion SHELL


def run_completion(asked: Namespace) -> int:
    demand("completion", "argcomplete", "completion")
    from argcomplete.shell_integration import shellcode

    print(shellcode(["contralbero"], shell=asked.shell))
    return 0


# --- contralbero schema
# The JSON Schema of a design file, by which editors complete and check it, or of the results.


def run_schema(asked: Namespace) -> int:
    if asked.results:
        from assistant.results_schema import schema_text as results_text

        text = results_text()
    else:
        text = schema_text(asked.schema)
    output = asked.output or STANDARD
    if output != STANDARD:
        demand_ending(output, "json")
    put(output, text)
    if output != STANDARD:
        print(output)
    return 0


# --- contralbero new


def run_new(asked: Namespace) -> int:
    shipped = engines()
    if asked.list:
        rows = [(name, engine.name, engine.what, engine.source) for name, engine in shipped.items()]
        widths = [max(map(len, column)) for column in zip(*rows)]
        for row in rows:
            print("  ".join(f"{cell:<{width}}" for cell, width in zip(row, widths)).rstrip())
        return 0
    if asked.example is not None:
        return _example(asked)
    errors: list[InputError] = []
    if asked.engine not in shipped:
        unknown = Text("is not shipped; `contralbero new --list` lists {engines}", engines=", ".join(shipped))
        errors.append(InputError(0, "--engine", asked.engine, unknown))
    errors += _no_target(asked.file)
    changes = dict[str, object]()
    for assignment in asked.changes:
        try:
            key, value = parse_assignment(assignment)
        except BadInput as bad:
            errors += bad.errors
            continue
        if key != dotted(Design.name) and step_of(key, judged=True) != "engine":
            errors.append(InputError(0, key, "", Text("is no key of the engine; change it in the file")))
        else:
            changes[key] = value
    if asked.engine in shipped:
        try:
            engine_alone(asked.engine, changes)
        except BadInput as bad:
            errors += bad.errors
    if errors:
        raise BadInput("contralbero new", errors)
    try:
        text = engine_design(asked.engine, asked.arrangement, changes, asked.mounts)
    except NoSolution as none:
        print(f"no solution: {none.text}", file=sys.stderr)
        return 3
    put(asked.file, text, new=True)
    if asked.file != STANDARD:
        print(Path(asked.file))
    return 0


def _no_target(file: str | None) -> list[InputError]:
    """What is wrong with the name of the file to write."""
    if file is None:
        return [InputError(0, "FILE", "", Text("needs the name of the file to write, like my_engine.toml"))]
    if file != STANDARD and os.path.lexists(file):
        return [InputError(0, file, "", Text("exists already and is left alone; choose another name"))]
    return []


def _example(asked: Namespace) -> int:
    """A shipped design, byte for byte: who has installed the program has no folder `designs/`."""
    known = {shipped_name(path): path for path in designs()}
    name = asked.example.removeprefix("designs/").removesuffix(".toml")  # as the documents write it
    errors = _no_target(asked.file)
    if name not in known:
        unknown = Text("is no shipped design; they are {names}", names=", ".join(known))
        errors.append(InputError(0, "--example", asked.example, unknown))
    for option, given in (("--arrangement", asked.arrangement), ("--set", asked.changes), ("--mounts", asked.mounts)):
        if given:
            reason = Text("is for an engine; an example is written as it is: change it with `contralbero set`")
            errors.append(InputError(0, option, "", reason))
    if errors:
        raise BadInput("contralbero new", errors)
    runs = {} if asked.file == STANDARD else _runs_beside(known[name], Path(asked.file))
    there = [str(target) for target in runs.values() if os.path.lexists(target)]
    if there:
        exists = Text("exists already and is left alone; write the design, which names it, into another folder")
        raise BadInput("contralbero new", [InputError(0, target, "", exists) for target in there])
    put(asked.file, known[name].read_bytes(), new=True)
    for source, target in runs.items():
        put(str(target), source.read_bytes(), new=True)
    if asked.file != STANDARD:
        print(asked.file, *runs.values(), sep="\n")
    return 0


def _runs_beside(example: Path, file: Path) -> dict[Path, Path]:
    """The files of the runs of an example, each with where it goes."""
    runs = read(example).data.get(dotted(Design.measurements), [])
    names = dict.fromkeys(str(run["file"]) for run in as_list(runs) if isinstance(run, dict))
    return {example.with_name(name): file.with_name(name) for name in names}
