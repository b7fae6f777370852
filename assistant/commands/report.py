# SPDX-License-Identifier: Apache-2.0
"""`contralbero report` and `export`: what leaves a design as a file.

report: the calculation report as a PDF or as a Word document, and the verdicts on the screen.  export: the results as
JSON or CSV, the shaft or the gears as a DXF drawing."""

import sys
from argparse import Namespace
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path

from assistant.commands.check import exit_code
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
from assistant.session.exporting import KINDS, drawings, draws_gears, exported, gears_text, map_text, transfer_text
from assistant.session.saving import spare
from calc.design.disk import read_file
from calc.design.limits import FRONT_BYTES
from calc.design.toml_file import Document, design
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import COMMA, Amount, Text
from calc.solve import Results, solve
from calc.studies.drive.front import NAME, Broken, picked

ENDINGS = ("pdf", "docx")
PACKAGES = {"python-docx": "docx", "pypdfium2": "pypdfium2"}  # of the extra `docx`, by what they are imported as


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
    if missing := [package for package, module in PACKAGES.items() if find_spec(module) is None]:
        reason = Text(
            "needs {packages}: `pip install {packages}`; the PDF needs nothing more", packages=" ".join(missing)
        )
        raise BadInput("contralbero report", [InputError(0, "--format", "docx", reason)])


# --- contralbero export

FINEST, COARSEST = 1e-3, 1e3  # chord error, µm: below, the file grows without use; above, no tooth is left


def run_export(asked: Namespace) -> int:
    target = Path(asked.output)
    to_standard = asked.output == STANDARD
    kind = asked.kind or target.suffix.lower().removeprefix(".")
    document = read_design(asked.file)
    if not to_standard:
        spare(target, asked.file)
    wrong = _target_errors(kind, target) + _drawing_errors(asked, kind)
    try:
        parsed = design(document)
    except BadInput as bad:
        raise BadInput(document.place, wrong + bad.errors) from None
    if wrong:
        raise BadInput("contralbero export", wrong)
    results = solve(parsed)
    if asked.transfer:
        files = {target: transfer_text(document, results)}
    elif asked.map:
        files = {target: map_text(document, results)}
    elif kind == "dxf":
        files = _drawings(asked, document, results)
    else:
        files = exported(target.with_name(f"{target.name}.{kind}") if to_standard else target, document, results)
    if to_standard:
        if len(files) > 1:
            reason = Text("takes one drawing, and this design has {n} shafts; give a file", n=len(files))
            raise BadInput("contralbero export", [InputError(0, "-o", STANDARD, reason)])
        put(STANDARD, next(iter(files.values())))
        with spoken(STANDARD):
            if not asked.quiet:
                print_summary(results)
        return 0
    for path, text in files.items():
        put(str(path), text, [asked.file])
    if not asked.quiet:
        print_summary(results)
        print()
    print(*files, sep="\n")
    return 0


def _target_errors(kind: str, target: Path) -> list[InputError]:
    """What is wrong with the file that was asked for: its ending says what stands in it."""
    known = COMMA.join(Text(".{kind} ({what})", kind=name, what=what) for name, what in KINDS.items())
    ending = target.suffix
    if str(target) == STANDARD and kind not in KINDS:
        return [InputError(0, "-o", STANDARD, Text("has no ending; give --json, --csv or --dxf"))]
    if kind not in KINDS:
        fault = Text("the ending {ending} is not known", ending=ending) if ending else Text("has no ending")
        return [InputError(0, "-o", str(target), Text("{fault}; known are {endings}", fault=fault, endings=known))]
    if str(target) != STANDARD and ending.lower() != f".{kind}":
        fault = Text("ends in {ending}", ending=ending) if ending else Text("has no ending")
        return [InputError(0, "-o", str(target), Text("{fault}, but --{kind} writes .{kind}", fault=fault, kind=kind))]
    return []


def _drawing_errors(asked: Namespace, kind: str) -> list[InputError]:
    """What is wrong with the options of a drawing."""
    of_drawings = {"--gear": asked.gear, "--gears": asked.gears or None, "--chord-error": asked.chord_error}
    errors = []
    if kind in KINDS and kind != "dxf":
        reason = Text("is for a drawing (--dxf), not for .{kind}", kind=kind)
        errors = [InputError(0, key, "", reason) for key, what in of_drawings.items() if what is not None]
    for key, given in (("--transfer", asked.transfer), ("--map", asked.map)):
        if given and kind != "csv":
            errors.append(InputError(0, key, "", Text("is for a table (--csv), not for .{kind}", kind=kind)))
    error = asked.chord_error
    if error is not None and not FINEST <= error <= COARSEST:
        reason = Text(
            "must lie between {finest} and {coarsest}", finest=Amount(FINEST), coarsest=Amount(COARSEST, "µm")
        )
        errors.append(InputError(0, "--chord-error", f"{error:g}", reason))
    return errors


def _drawings(asked: Namespace, document: Document, results: Results) -> dict[Path, str]:
    """The shafts, or the gears where they are asked for or are all there is."""
    target = Path(asked.output)
    if asked.gear is not None or asked.gears or draws_gears(results):
        return {target: gears_text(document, results, asked.gear, asked.chord_error)}
    if asked.chord_error is not None:
        raise BadInput(
            "contralbero export",
            [InputError(0, "--chord-error", "", Text("is for gears: ask for --gear WHEEL or --gears"))],
        )
    return drawings(target, document, results)
