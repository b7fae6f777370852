# SPDX-License-Identifier: Apache-2.0
"""`contralbero record` and `contralbero replay`: what a design and edits of it come to, kept in a file and compared
later.

A replay may be a stranger's: the reports that it asks for are new files beside it, or take the place of reports of this
program."""

import json
import os
import time
from argparse import Namespace
from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import tomli_w

from assistant.commands.check import changed
from assistant.named_files import (
    STANDARD,
    demand_ending,
    each,
    files_of,
    is_folder,
    many,
    put,
    read_design,
    spoken,
    standard_input,
    targets_in,
)
from assistant.results_text import errors_json
from assistant.session.recording import Recording
from assistant.session.saving import asked_for, edited_text, write_asked
from calc.design import replay
from calc.design.addresses import parse_assignment
from calc.design.disk import read_file, write_file
from calc.design.limits import DESIGN_BYTES, PDF_BYTES
from calc.design.toml_file import Document, design, parsed
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text
from calc.sheet.version import VERSION
from calc.sheet.visible import visible
from calc.solve import Results, solve

# --- contralbero record


def run_record(asked: Namespace) -> int:
    """A replay of each design; one of a file begins with that file, as it is when it is replayed."""
    files = files_of(asked.files)
    folder = asked.output is None or is_folder(asked.output, many(asked.files, files))
    if len(files) > 1 and not folder:
        reason = Text("is one file, for {n} designs; give a folder", n=len(files))
        raise BadInput("contralbero record", [InputError(0, "-o", asked.output, reason)])
    if folder:
        targets = targets_in(asked.output, files, "-replay.toml" if asked.output is None else ".toml")
    else:
        targets = {file: asked.output for file in files}
        if asked.output != STANDARD:
            demand_ending(asked.output, "toml")
    return each(files, lambda file: _record(file, targets[file], asked), lambda file, bad: None)


def _record(file: str, target: str, asked: Namespace) -> int:
    if target != STANDARD and os.path.lexists(target):
        reason = Text("exists already and is left alone; `contralbero replay --update` brings it up to date")
        raise BadInput(target, [InputError(0, "", "", reason)])
    start = read_design(file)
    _, edited = changed(start, asked.changes)  # what is wrong with any edit is said at once
    recording, document = Recording(start.data), start
    for change in asked.changes:
        document = document.with_value(*parse_assignment(change))
        with suppress(BadInput):  # a design only together with the next edit, whose step it then is
            design(document)
            recording.edited(document.data)
            recording.close()
    results = solve(edited)
    text = recording.text(results, None if file == STANDARD else _from(file, target))
    put(target, text, [file], new=True)
    with spoken(target):
        if target != STANDARD:
            print(target if asked.quiet else f"{target}: {results.words()}")
    return 0


def _from(file: str, target: str) -> str:
    """Where a design is, seen from the folder of its replay."""
    home = Path() if target == STANDARD else Path(target).parent
    try:
        return Path(os.path.relpath(file, home)).as_posix()
    except ValueError:  # on another drive
        return Path(file).resolve().as_posix()


# --- contralbero replay


@dataclass
class Played:
    """What came out of one replay file."""

    file: str
    compared: Sequence[replay.Compared] = ()
    updated: Sequence[replay.Compared] = ()
    seconds: float = 0.0
    wrong: BadInput | None = None  # it could not be played
    failed: list[replay.Compared] = field(init=False)

    def __post_init__(self) -> None:
        self.failed = [c for c in self.compared if not c.agrees and c not in self.updated]

    @property
    def agrees(self) -> bool:
        return self.wrong is None and bool(self.compared) and not self.failed


def run_replay(asked: Namespace) -> int:
    files = files_of(asked.files)
    if asked.junit not in (None, STANDARD):
        demand_ending(asked.junit, "xml", option="--junit")
    if asked.json and asked.junit == STANDARD:
        raise BadInput("contralbero replay", [InputError(0, "--junit", STANDARD, Text("--json is written there"))])
    if asked.update and STANDARD in files:
        reason = Text("standard input can not be updated; name the file")
        raise BadInput("contralbero replay", [InputError(0, "--update", STANDARD, reason)])
    played: list[Played] = []

    def work(file: str) -> int:
        one = _play(file, asked.update, quiet=asked.quiet or asked.json)
        played.append(one)
        if not asked.json and not (asked.quiet and one.agrees and not one.updated):
            _print(one, asked.all)
        return 0 if one.agrees else 1

    with spoken(asked.junit):
        code = each(files, work, lambda file, bad: played.append(Played(file, wrong=bad)))
    if asked.junit is not None:
        put(asked.junit, junit(played), files)
    if asked.json:
        about = {"schema": 1, "program": "contralbero", "version": VERSION, "agrees": code == 0}
        print(json.dumps(about | {"replays": [_json(one) for one in played]}, ensure_ascii=False, indent=1))
    return code


def _play(file: str, update: bool, quiet: bool) -> Played:
    raw = parsed(standard_input(DESIGN_BYTES), STANDARD) if file == STANDARD else None
    script = replay.load(file) if raw is None else replay.script(raw)
    for step in script.steps:
        if "report" in step:
            _replaced(replay.target(script, step))
    began = time.monotonic()
    compared = replay.run(script, solve, partial(_report, quiet=quiet))
    updated = _update(script, replay.moved(compared)) if update else []
    return Played(file, compared, updated, time.monotonic() - began)


def _print(one: Played, everything: bool) -> None:
    agree = Text("{n} of {all} as expected", n=len(one.compared) - len(one.failed), all=len(one.compared))
    print(f"{one.file}: {agree if one.compared else Text('nothing was compared: it has no [[expect]]')}")
    for c in one.updated:
        print(f"  {c.about}: {c.expected} → {c.found}")
    for c in one.compared if everything else one.failed:
        if c not in one.updated:
            print(f"  {c.text}")


def _json(one: Played) -> dict[str, Any]:
    """A replay with all that it compared; `errors`: why it could not be played."""
    if one.wrong is not None:
        return {"file": one.file, "agrees": False, "errors": errors_json(one.wrong)}
    compared = [
        {
            "about": c.about,
            "expected": c.expected,
            "found": c.found,
            "agrees": c.agrees,
            "updated": c in one.updated,
            "kind": c.kind,
            "source": c.source,
        }
        for c in one.compared
    ]
    return {"file": one.file, "agrees": one.agrees, "compared": compared}


def junit(played: Iterable[Played]) -> bytes:
    """JUnit XML: a suite for each replay, a case for each expectation; an error where a replay could not be played."""
    root = ElementTree.Element("testsuites", name="contralbero")
    for one in played:
        problems = {"failures": len(one.failed), "errors": int(one.wrong is not None or not one.compared)}
        counts = {"tests": max(len(one.compared), 1), **problems}
        attributes = {"name": one.file, "time": f"{one.seconds:.3f}", **counts}
        suite = ElementTree.SubElement(
            root, "testsuite", {key: visible(str(value)) for key, value in attributes.items()}
        )
        if not one.compared:
            case = ElementTree.SubElement(suite, "testcase", name="replay", classname=visible(one.file))
            why = str(one.wrong) if one.wrong is not None else "nothing was compared: it has no [[expect]]"
            ElementTree.SubElement(case, "error", message=visible(why.partition("\n")[0])).text = visible(
                why, lines=True
            )
        for c in one.compared:
            case = ElementTree.SubElement(suite, "testcase", name=visible(c.about), classname=visible(one.file))
            if c in one.failed:
                message = visible(f"{c.found}, expected {c.expected}")
                ElementTree.SubElement(case, "failure", message=message).text = visible(c.text)
    ElementTree.indent(root)
    return b'<?xml version="1.0" encoding="utf-8"?>\n' + ElementTree.tostring(root, encoding="unicode").encode() + b"\n"


def _update(script: replay.Script, moved: dict[int, replay.Compared]) -> list[replay.Compared]:
    """Writes into the replay what its recorded expectations have come to; comments stay."""
    if moved:
        changes = [(("expect", n, c.under), c.now) for n, c in moved.items()]
        write_asked(Path(script.place), edited_text(script.raw.decode("utf-8"), changes), expected=script.raw)
    return [*moved.values()]


def _report(document: Document, results: Results, path: Path, quiet: bool) -> None:
    from reports.report import render

    if not quiet:
        print(Text("writes {path}", path=str(path)), flush=True)
    old = _replaced(path)
    pdf = render(document, results, tomli_w.dumps(document.data).encode("utf-8"))
    with asked_for(path):
        write_file(path, pdf, expected=old, new=old is None)


def _replaced(path: Path) -> bytes | None:
    """The report that stands where one is to be written, None where nothing does.  Raises BadInput for anything
    else."""
    with asked_for(path):
        if not path.is_symlink() and not path.exists():
            return None
        raw = read_file(path, PDF_BYTES)
    from reports.pdf.attach import is_report

    if path.is_symlink() or not is_report(raw):
        reason = Text(
            "is there, and is no report as this program writes it; a replay leaves it alone: move it away, or run it "
            "elsewhere"
        )
        raise BadInput(str(path), [InputError(0, "", "", reason)])
    return raw
