# SPDX-License-Identifier: Apache-2.0
"""`contralbero report`: the calculation report as a PDF or as a Word document, and the verdicts on the screen."""

import gc
import sys
from argparse import Namespace
from importlib.util import find_spec
from pathlib import Path

from assistant.session.saving import spare
from calc.design.toml_file import Document, design, read
from calc.design.disk import read_file
from calc.design.limits import FRONT_BYTES
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import Text
from reports.figures.draughtsman import draughtsman

ENDINGS = ("pdf", "docx")
PACKAGES = {"python-docx": "docx", "pypdfium2": "pypdfium2"}  # of the extra `docx`, by what they are imported as


def run(asked: Namespace) -> int:
    source = Path(asked.file)
    document = read(source)
    kind, target = _target(asked, source)
    spare(target, asked.file)
    draws = draughtsman() if kind == "pdf" and asked.depth != "summary" else None  # before what takes long to load
    from assistant.plain import print_summary
    from calc.solve import solve

    gc.disable()  # looking for garbage takes a tenth of a report, and hardly any is made
    try:
        results = solve(design(document), traced=True)
        if kind == "docx":
            from reports.docx.docx_file import write as write_docx

            write_docx(document, results, document.raw, target, depth=asked.depth, lang=asked.lang)
        else:
            from reports.report import write

            front = _front(source, document)
            write(document, results, document.raw, target, depth=asked.depth, lang=asked.lang, front=front, draws=draws)
    except OSError as error:
        raise BadInput(
            str(target),
            [InputError(0, "", "", Text("cannot be written: {reason}; choose another place with -o", reason=error.strerror or str(error)))],
        ) from None
    finally:
        gc.enable()
    print_summary(results)
    print(f"\n{target}")
    return 0


def _front(source: Path, document: Document) -> bytes | None:
    """The front beside a design that is one of its drives.  One that can not be read is said, and the report is written without it."""
    from calc.studies.drive.front import NAME, Broken, picked

    beside = source.with_name(NAME)
    if not beside.is_file():
        return None
    try:
        raw = read_file(beside, FRONT_BYTES)
        if picked(raw, document.data) is None:
            print(
                Text("{file}: has no drive with the values of this design; the report says nothing of it", file=str(beside)),
                file=sys.stderr,
            )
            return None
    except (OSError, Broken) as error:
        print(
            Text("{file}: {why}; the report says nothing of it", file=str(beside), why=getattr(error, "strerror", None) or str(error)),
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
            reason = Text("needs {packages}: `pip install {packages}`; the PDF needs nothing more", packages=" ".join(missing))
            raise BadInput("contralbero report", [InputError(0, "--format", "docx", reason)])
    return kind, target or Path(f"{source.stem}.{kind}")
