# SPDX-License-Identifier: Apache-2.0
"""`contralbero report` and `export`: what leaves a design as a file.

report: the calculation report as a PDF or as a Word document, and the verdicts on the screen.  export: the results as
JSON or CSV, the shaft or the gears as a DXF drawing."""

import sys
from argparse import Namespace
from importlib.util import find_spec
from pathlib import Path

from assistant.results_text import print_summary
from assistant.session.exporting import KINDS, drawings, draws_gears, exported, gears_text, map_text, transfer_text
from assistant.session.saving import spare, write_asked
from calc.design.disk import read_file
from calc.design.limits import FRONT_BYTES
from calc.design.toml_file import Document, design, read
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import COMMA, Amount, Text
from calc.solve import Results, solve
from calc.studies.drive.front import NAME, Broken, picked

ENDINGS = ("pdf", "docx")
PACKAGES = {"python-docx": "docx", "pypdfium2": "pypdfium2"}  # of the extra `docx`, by what they are imported as


def run_report(asked: Namespace) -> int:
    source = Path(asked.file)
    document = read(source)
    kind, target = _target(asked, source)
    spare(target, asked.file)
    try:
        results = solve(design(document))
        if kind == "docx":
            from reports.docx.docx_file import write as write_docx

            write_docx(document, results, document.raw, target, depth=asked.depth, lang=asked.lang)
        else:
            from reports.report import write

            front = _front(source, document)
            write(document, results, document.raw, target, depth=asked.depth, lang=asked.lang, front=front)
    except OSError as error:
        raise BadInput(
            str(target),
            [
                InputError(
                    0,
                    "",
                    "",
                    Text(
                        "cannot be written: {reason}; choose another place with -o", reason=error.strerror or str(error)
                    ),
                )
            ],
        ) from None
    print_summary(results)
    print(f"\n{target}")
    return 0


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


def _target(asked: Namespace, source: Path) -> tuple[str, Path]:
    """What is to be written, and where.  What can not be is said before anything is solved."""
    target = Path(asked.output) if asked.output else None
    ending = target.suffix.lower().removeprefix(".") if target is not None else ""
    kind = asked.format or (ending if ending in ENDINGS else "pdf")
    if ending in ENDINGS and ending != kind:
        reason = Text("ends in .{ending}, but --format {kind} writes .{kind}", ending=ending, kind=kind)
        raise BadInput("contralbero report", [InputError(0, "-o", str(target), reason)])
    if kind == "docx":
        if asked.depth == "audit":
            reason = Text("is written as a PDF only: take --depth engineer, or leave --format out")
            raise BadInput("contralbero report", [InputError(0, "--depth", "audit", reason)])
        if missing := [package for package, module in PACKAGES.items() if find_spec(module) is None]:
            reason = Text(
                "needs {packages}: `pip install {packages}`; the PDF needs nothing more", packages=" ".join(missing)
            )
            raise BadInput("contralbero report", [InputError(0, "--format", "docx", reason)])
    return kind, target or Path(f"{source.stem}.{kind}")


# --- contralbero export

FINEST, COARSEST = 1e-3, 1e3  # chord error, µm: below, the file grows without use; above, no tooth is left


def run_export(asked: Namespace) -> int:
    target = Path(asked.output)
    kind = asked.kind or target.suffix.lower().removeprefix(".")
    document = read(asked.file)
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
    else:
        files = _drawings(asked, document, results) if kind == "dxf" else exported(target, document, results)
    for path, text in files.items():
        spare(path, asked.file)
        write_asked(path, text, inputs=[asked.file])
    print_summary(results)
    print("", *files, sep="\n")
    return 0


def _target_errors(kind: str, target: Path) -> list[InputError]:
    """What is wrong with the file that was asked for: its ending says what stands in it."""
    known = COMMA.join(Text(".{kind} ({what})", kind=name, what=what) for name, what in KINDS.items())
    ending = target.suffix
    if kind not in KINDS:
        fault = Text("the ending {ending} is not known", ending=ending) if ending else Text("has no ending")
        return [InputError(0, "-o", str(target), Text("{fault}; known are {endings}", fault=fault, endings=known))]
    if ending.lower() != f".{kind}":
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
