# SPDX-License-Identifier: Apache-2.0
"""`contralbero export`: the results of a design as JSON or CSV, its shaft or its gears as a DXF drawing."""

import csv
import json
import math
from argparse import Namespace
from io import StringIO
from pathlib import Path
from typing import TYPE_CHECKING

from assistant.plain import print_summary, results_json
from assistant.saving import write_asked
from calc.design_file import Document, design, read
from calc.sheet.errors import BadInput, InputError
from calc.solve import Results, solve

if TYPE_CHECKING:
    from calc.gears.inputs import GearsInputs
    from calc.gears.result import TrainResult

KINDS = {"dxf": "a drawing of the shaft or of the gears", "csv": "the values", "json": "all results"}
HOW = "give [[countershaft.sections]], or core_radius_mm with the sizes of the journals ([bearings], or [[countershaft.journals]])"
FINEST, COARSEST = 1e-3, 1e3  # chord error, µm: below, the file grows without use; above, no tooth is left


def run(asked: Namespace) -> int:
    target = Path(asked.output)
    kind = asked.kind or target.suffix.lower().removeprefix(".")
    document = read(asked.file)
    wrong = _target_errors(kind, target) + _drawing_errors(asked, kind)
    try:
        made = design(document)
    except BadInput as bad:
        raise BadInput(document.place, wrong + bad.errors) from None
    if wrong:
        raise BadInput("contralbero export", wrong)
    results = solve(made)
    if kind == "dxf":
        text = _drawing(asked, document, results)
    else:
        text = {"json": results_text, "csv": values_text}[kind](document, results)
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


def _drawing_errors(asked: Namespace, kind: str) -> list[InputError]:
    """What is wrong with the options of a drawing."""
    given = {"--gear": asked.gear, "--gears": asked.gears or None, "--chord-error": asked.chord_error}
    found = []
    if kind in KINDS and kind != "dxf":
        found = [InputError(0, key, "", f"is for a drawing (--dxf), not for .{kind}") for key, what in given.items() if what is not None]
    error = asked.chord_error
    if error is not None and not FINEST <= error <= COARSEST:
        found.append(InputError(0, "--chord-error", f"{error:g}", f"must lie between {FINEST:g} and {COARSEST:g} µm"))
    return found


def _drawing(asked: Namespace, document: Document, results: Results) -> str:
    """The shaft, or the gears where they are asked for or are all there is."""
    design = results.design
    if asked.gear is not None or asked.gears or (design.countershaft is None and design.gears is not None):
        return gears_text(document, results, asked.gear, asked.chord_error)
    if asked.chord_error is not None:
        raise BadInput("contralbero export", [InputError(0, "--chord-error", "", "is for gears: ask for --gear WHEEL or --gears")])
    return drawing_text(document, results)


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
        raise BadInput(
            document.place, [InputError(0, "countershaft", "", f"needed for a drawing: add [countershaft], and {HOW}; or [gears]")]
        )
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


def gears_text(document: Document, results: Results, wheel: str | None = None, chord_error: float | None = None) -> str:
    """One wheel with its table of data, or the whole train, as a DXF file.  `chord_error` in µm."""
    from calc.gears.profile.drawing import LAYERS, train_drawing, wheel_drawing
    from calc.gears.profile.outline import CHORD_ERROR
    from reports.dxf import dxf

    train, gears, name = _train(document, results, wheel), results.design.gears, results.design.name
    error = CHORD_ERROR if chord_error is None else chord_error * 1e-6
    if wheel is not None:
        return dxf(wheel_drawing(train, wheel, name, gears, error), LAYERS)
    assert gears is not None
    return dxf(train_drawing(train, name, _positions(train, gears), gears.tooth_angle, error), LAYERS)


def _positions(train: "TrainResult", gears: "GearsInputs") -> dict[str, tuple[float, float]]:
    """Where the axes stand, as far as it is known: found with the layout, or given."""
    found = {w.name: (w.position[0], w.position[1]) for w in gears.wheels if w.position is not None}
    placed = train.layout.wheels if train.layout is not None else {}
    return found | {name: (w.position.real, w.position.imag) for name, w in placed.items() if w.position is not None}


def _train(document: Document, results: Results, wheel: str | None) -> "TrainResult":
    """The solved train.  Raises BadInput where there is none, or not the wheel."""
    found = results.outcomes["gears"]
    if results.design.gears is None:
        raise BadInput(document.place, [InputError(0, "gears", "", "needed for a drawing of the gears: add [gears]")])
    if found.result is None:
        raise BadInput(document.place, [InputError(0, "gears", "", f"there are no gears to draw: {found.reason}")])
    train: TrainResult = found.result
    if wheel is not None and wheel not in train.wheels:
        raise BadInput("contralbero export", [InputError(0, "--gear", wheel, f"is no wheel; the wheels are {', '.join(train.wheels)}")])
    return train
