# SPDX-License-Identifier: Apache-2.0
"""`contralbero export`: the results of a design as JSON or CSV, its shaft as a DXF drawing."""

import csv
import json
import math
from argparse import Namespace
from io import StringIO
from pathlib import Path

from assistant.plain import print_summary, results_json
from assistant.saving import write_asked
from calc.design_file import Document, design, read
from calc.sheet.errors import BadInput, InputError
from calc.solve import Results, solve

KINDS = {"dxf": "a drawing of the shaft", "csv": "the values", "json": "all results"}
HOW = "give [[countershaft.sections]], or core_radius_mm with the sizes of the journals ([bearings], or [[countershaft.journals]])"


def run(asked: Namespace) -> int:
    target = Path(asked.output)
    kind = asked.kind or target.suffix.lower().removeprefix(".")
    document = read(asked.file)
    wrong = _target_errors(kind, target)
    try:
        made = design(document)
    except BadInput as bad:
        raise BadInput(document.place, wrong + bad.errors) from None
    if wrong:
        raise BadInput("contralbero export", wrong)
    results = solve(made)
    text = {"json": results_text, "csv": values_text, "dxf": drawing_text}[kind](document, results)
    write_asked(target, text)
    print_summary(results)
    print(f"\n{target}")
    return 0


def _target_errors(kind: str, target: Path) -> list[InputError]:
    """What is wrong with the file that was asked for: its ending says what stands in it."""
    known = ", ".join(f".{name} ({what})" for name, what in KINDS.items())
    ending = target.suffix
    if kind not in KINDS:
        said = f"the ending {ending} is not known" if ending else "has no ending"
        return [InputError(0, "-o", str(target), f"{said}; known are {known}")]
    if ending.lower() != f".{kind}":
        said = f"ends in {ending}" if ending else "has no ending"
        return [InputError(0, "-o", str(target), f"{said}, but --{kind} writes .{kind}")]
    return []


def results_text(document: Document, results: Results) -> str:
    """The object that `check --json` prints."""
    return json.dumps(results_json(document, results), ensure_ascii=False, indent=1) + "\n"


def values_text(document: Document, results: Results) -> str:
    """A row for each value; a number that is not finite leaves its cell empty."""
    file = StringIO()
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow(("id", "value", "unit", "label", "symbol"))
    for value in results.values().values():
        rows.writerow((value.id, value.shown if math.isfinite(value.shown) else "", value.unit, value.label, value.symbol))
    return file.getvalue()


def drawing_text(document: Document, results: Results) -> str:
    """The shaft as a DXF file.  Raises BadInput where its outline is not known, with what to add."""
    shaft, found = results.design.countershaft, results.outcomes["countershaft"]
    if shaft is None:
        raise BadInput(document.place, [InputError(0, "countershaft", "", f"needed for a drawing: add [countershaft], and {HOW}")])
    if found.state != "solved":
        raise BadInput(document.place, [InputError(0, "countershaft", "", f"there is no shaft to draw: {found.reason}")])
    outline = found.result.outline
    if outline is None:
        why = "the shaft's outline is not known"
        raise BadInput(
            document.place,
            [InputError(0, "countershaft", "", f"{why}: {HOW}; `contralbero check {document.place} --step countershaft` tells more")],
        )
    from calc.countershaft.drawing import LAYERS, shaft_drawing
    from reports.dxf import dxf

    return dxf(shaft_drawing(outline, shaft.bearing_positions, results.design.name), LAYERS)
