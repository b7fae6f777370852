# SPDX-License-Identifier: Apache-2.0
"""What a design gives to other programs: its results as JSON or CSV, its shaft or its gears as a DXF drawing.  And its
report."""

import csv
import json
import math
from collections.abc import Iterable, Sequence
from io import StringIO
from pathlib import Path
from typing import TYPE_CHECKING

from assistant.extras import demand
from assistant.results_text import results_json
from assistant.session.saving import Draft, write_asked
from calc.countershaft.result import CountershaftResult
from calc.design.model import Design
from calc.design.toml_file import Document
from calc.gears.drive.tables import map_rows
from calc.gears.profile.drawing import LAYERS, train_drawing, wheel_drawing
from calc.gears.profile.outline import CHORD_ERROR
from calc.gears.result import TrainResult
from calc.mounting.operations import rows as transfer_rows
from calc.mounting.result import MountingResult
from calc.sheet.errors import BadInput, InputError
from calc.sheet.progress import Progress
from calc.sheet.quantity import dotted
from calc.sheet.text import Text
from calc.solve import Results
from calc.studies.drawings import sheets, wheel_sheet
from reports.dxf import dxf, sheet_dxf, wheel_dxf

if TYPE_CHECKING:
    from calc.gears.inputs import GearsInputs

KINDS = {"dxf": Text("a drawing of the shaft or of the gears"), "csv": Text("the values"), "json": Text("all results")}
HOW = Text("give [[shafts.sections]], or core_radius_mm with diameter_mm and length_mm of each [[shafts.bearings]]")


def write_draft(
    path: Path, draft: Draft, gears: bool = False, progress: Progress | None = None, lang: str = "en"
) -> None:
    """Write the file that its ending says: the report as .pdf, else one of the kinds.  Raises BadInput, OSError,
    Cancelled."""
    document, results = draft.solved()
    if path.suffix.lower() == ".pdf":
        from reports.report import write  # with matplotlib and reportlab

        write(document, results, document.raw, path, depth="engineer", lang=lang, progress=progress)
    else:
        for target, text in exported(path, document, results, gears).items():
            write_asked(target, text, inputs=[document.place])


def exported(path: Path, document: Document, results: Results, gears: bool = False) -> dict[Path, str]:
    """The text of the file that its ending says.  A drawing is that of the shaft, of several one each that is no twin;
    of the train where `gears` says so, or where there is no shaft.

    Raises BadInput where there is nothing to draw, with what to add.
    """
    kind = path.suffix.lower().removeprefix(".")
    if kind == "json":
        return {path: results_text(document, results)}
    if kind == "csv":
        return {path: values_text(document, results)}
    if gears or draws_gears(results):
        return {path: gears_text(document, results)}
    return drawings(path, document, results)


def drawings(path: Path, document: Document, results: Results) -> dict[Path, str]:
    """The shaft as a DXF file; of several each that is no twin by itself, `-left` behind the name of the file.  Raises
    BadInput where there is none to draw."""
    views = results.views
    if len(views) < 2:
        return {path: drawing_text(document, next(iter(views.values()), results))}
    return {path.with_stem(f"{path.stem}-{name}"): drawing_text(document, view, name) for name, view in views.items()}


def draws_gears(results: Results) -> bool:
    """The gears are all there is to draw."""
    return results.design.countershaft is None and results.design.gears is not None


def results_text(document: Document, results: Results) -> str:
    """The object that `check --json` prints."""
    return json.dumps(results_json(document, results, measured=True), ensure_ascii=False, indent=1) + "\n"


def values_text(document: Document, results: Results) -> str:
    """A row for each value; a number that is not finite leaves its cell empty."""
    file = StringIO()
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow(("id", "value", "unit", "label", "symbol"))
    for id, value in results.values().items():
        rows.writerow((id, value.shown if math.isfinite(value.shown) else "", value.unit, value.label, value.symbol))
    return file.getvalue()


def transfer_text(document: Document, results: Results) -> str:
    """How every point of the engine's mounting moves under unit forces and moments, over frequency."""
    mounting = results.result(MountingResult)
    if mounting is None or not mounting.system.mounting.points:
        reason = Text("needed with [[mounting.points]] for transfer functions")
        raise BadInput(document.place, [InputError(0, "mounting", "", reason)])
    return _csv(*transfer_rows(mounting))


def map_text(document: Document, results: Results) -> str:
    """What every mesh carries at 60 speeds and each load: inertia over drag, least force of closed flanks, speed, low
    and high force and power of its strikes."""
    train = results.train
    if train is None or train.drive is None or not train.drive.meshes:
        reason = Text("needed, with [engine], for the map of the drive over speed")
        raise BadInput(document.place, [InputError(0, "gears", "", reason)])
    return _csv(*map_rows(train.drive))


def _csv(header: Sequence[str], numbers: Iterable[Sequence[float]]) -> str:
    """What is not finite leaves its cell empty."""
    file = StringIO()
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(header)
    writer.writerows([f"{x:.9g}" if math.isfinite(x) else "" for x in row] for row in numbers)
    return file.getvalue()


def drawing_text(document: Document, results: Results, name: str = "") -> str:
    """The shaft in view as a DXF file; `name`: of one of several.  Raises BadInput where its outline is not known, with
    what to add."""
    demand("dxf", "ezdxf", "dxf")
    shaft, outcome = results.design.countershaft, results.outcomes["countershaft"]
    key = dotted(Design.shafts, name) if name else "countershaft"
    if shaft is None:
        raise BadInput(
            document.place,
            [
                InputError(
                    0,
                    key,
                    "",
                    Text("needed for a drawing: add [[shafts]], and {how}; or [gears]", how=HOW),
                )
            ],
        )
    if outcome.state != "solved":
        raise BadInput(
            document.place,
            [InputError(0, key, "", Text("there is no shaft to draw: {reason}", reason=outcome.reason))],
        )
    solved = results.result(CountershaftResult)
    outline = solved.outline if solved is not None else None
    if outline is None:
        raise BadInput(
            document.place,
            [
                InputError(
                    0,
                    key,
                    "",
                    Text(
                        "the shaft's outline is not known: {how}; `contralbero check {file} --step countershaft` "
                        "tells more",
                        how=HOW,
                        file=document.place,
                    ),
                )
            ],
        )
    return sheet_dxf(sheets(results, data=document.data, sha256=document.sha256)[0])


def gears_text(document: Document, results: Results, wheel: str | None = None, chord_error: float | None = None) -> str:
    """One wheel with its teeth and its sheet, or the whole train, as a DXF file.  `chord_error` in µm."""
    demand("dxf", "ezdxf", "dxf")
    train, gears, name = _train(document, results, wheel), results.design.gears, results.design.name
    error = CHORD_ERROR if chord_error is None else chord_error * 1e-6
    if wheel is not None:
        sheet = wheel_sheet(results, wheel, document.data, document.sha256)
        return wheel_dxf(wheel_drawing(train, wheel, name, gears, error), LAYERS, sheet)
    assert gears is not None
    return dxf(train_drawing(train, name, _positions(train, gears), gears.tooth_angle, error), LAYERS)


def _positions(train: "TrainResult", gears: "GearsInputs") -> dict[str, tuple[float, float]]:
    """Where the axes stand, as far as it is known: found with the layout, or given."""
    positions = {w.name: (w.position[0], w.position[1]) for w in gears.wheels if w.position is not None}
    placed = train.layout.wheels if train.layout is not None else {}
    return positions | {
        name: (w.position.real, w.position.imag) for name, w in placed.items() if w.position is not None
    }


def _train(document: Document, results: Results, wheel: str | None) -> "TrainResult":
    """The solved train.  Raises BadInput where there is none, or not the wheel."""
    train = results.result(TrainResult)
    if results.design.gears is None:
        raise BadInput(
            document.place, [InputError(0, "gears", "", Text("needed for a drawing of the gears: add [gears]"))]
        )
    if train is None:
        reason = results.outcomes["gears"].reason
        raise BadInput(
            document.place, [InputError(0, "gears", "", Text("there are no gears to draw: {reason}", reason=reason))]
        )
    if wheel is not None and wheel not in train.wheels:
        raise BadInput(
            "contralbero export",
            [
                InputError(
                    0, "--gear", wheel, Text("is no wheel; the wheels are {wheels}", wheels=", ".join(train.wheels))
                )
            ],
        )
    return train
