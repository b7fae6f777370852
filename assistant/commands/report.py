# SPDX-License-Identifier: Apache-2.0
"""`contralbero report`: the calculation report as a PDF or as a Word document, and the verdicts on the screen."""

import sys
from argparse import Namespace
from collections.abc import Sequence
from pathlib import Path

from assistant.commands.check import exit_code
from assistant.extras import demand
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
    targets_in,
)
from assistant.results_text import print_summary
from assistant.session.saving import spare
from calc.design.disk import read_file
from calc.design.limits import FRONT_BYTES
from calc.design.toml_file import Document, design
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text
from calc.solve import solve
from calc.studies.drive.front import NAME, Broken, picked

ENDINGS = ("pdf", "docx")


def run_report(asked: Namespace) -> int:
    """Of several designs each by itself; with --fail the exit code is the worst that `check` has for them."""
    files = files_of(asked.files)
    several = many(asked.files, files)
    jobs = _jobs(asked, files, several)
    if not several:
        return _report(asked, files[0], *jobs[files[0]])

    def work(file: str) -> int:
        if not asked.quiet:
            print(f"{'' if file is files[0] else chr(10)}{file}")
        return _report(asked, file, *jobs[file])

    return each(files, work, lambda file, bad: None)


def _report(asked: Namespace, file: str, kind: str, target: str) -> int:
    document = read_design(file)
    if target != STANDARD:
        spare(Path(target), file)
    results = solve(design(document))
    results.demand_runs(document)
    from reports.report import inputs_of, render  # with matplotlib and reportlab

    if kind == "docx":
        from reports.docx.docx_file import render as render_docx

        content = render_docx(document, results, document.raw, depth=asked.depth, lang=asked.lang)
    else:
        front = _front(Path(file), document) if file != STANDARD else None
        content = render(document, results, document.raw, depth=asked.depth, lang=asked.lang, front=front)
    put(target, content, inputs_of(document, results))
    with spoken(target):
        if not asked.quiet:
            print_summary(results, asked.all)
            print()
        if target != STANDARD:
            print(target)
    return exit_code(results.verdict) if asked.fail else 0


def _front(source: Path, document: Document) -> bytes | None:
    """The front beside a design that is one of its drives.  One that can not be read is said, and the report is written
    without it."""
    beside = source.with_name(NAME)
    if not beside.is_file():
        return None
    try:
        raw = read_file(beside, FRONT_BYTES)
        if picked(raw, document.data) is None:
            print(
                Text(
                    "{file}: has no drive with the values of this design; the report says nothing of it",
                    file=str(beside),
                ),
                file=sys.stderr,
            )
            return None
    except (OSError, Broken) as error:
        print(
            Text(
                "{file}: {why}; the report says nothing of it",
                file=str(beside),
                why=getattr(error, "strerror", None) or str(error),
            ),
            file=sys.stderr,
        )
        return None
    return raw


def _jobs(asked: Namespace, files: Sequence[str], several: bool) -> dict[str, tuple[str, str]]:
    """What is to be written for each design, and where.  What can not be is said before anything is solved."""
    output = asked.output
    folder = output is None or is_folder(output, several)
    if len(files) > 1 and not folder:
        reason = Text("is one file, for {n} designs; give a folder", n=len(files))
        raise BadInput("contralbero report", [InputError(0, "-o", output, reason)])
    if folder or output == STANDARD:
        kind = asked.format or "pdf"
    else:
        spare(Path(output), *files)
        kind = demand_ending(output, *ENDINGS)
        if asked.format not in (None, kind):
            reason = Text("ends in .{ending}, but --format {kind} writes .{kind}", ending=kind, kind=asked.format)
            raise BadInput("contralbero report", [InputError(0, "-o", output, reason)])
    if kind == "docx":
        _demand_docx(asked)
    if not folder:
        return {file: (kind, output) for file in files}
    targets = targets_in(output, files, f".{kind}")
    return {file: (kind, target) for file, target in targets.items()}


def _demand_docx(asked: Namespace) -> None:
    if asked.depth == "audit":
        reason = Text("is written as a PDF only: take --depth engineer, or leave --format out")
        raise BadInput("contralbero report", [InputError(0, "--depth", "audit", reason)])
    for module in ("docx", "pypdfium2"):
        demand("docx", module, "--format docx")
