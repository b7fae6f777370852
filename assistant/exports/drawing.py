# SPDX-License-Identifier: Apache-2.0
"""The shaft or the gears as a DXF drawing: of several shafts one each that is no twin; the gears where they are asked
for, or where there is no shaft."""

from collections.abc import Iterator
from pathlib import Path

from assistant.exports.kinds import Made, Request
from calc.countershaft.result import CountershaftResult
from calc.design.model import Design
from calc.gears.inputs import GearsInputs
from calc.gears.profile.drawing import LAYERS, train_drawing, wheel_drawing
from calc.gears.profile.outline import CHORD_ERROR
from calc.gears.result import TrainResult
from calc.sheet.errors import BadInput, InputError
from calc.sheet.quantity import dotted
from calc.sheet.text import Amount, Text
from calc.solve import Results
from calc.studies.drawings import sheets, wheel_sheet
from reports.dxf import dxf, sheet_dxf, wheel_dxf

HOW = Text("give [[shafts.sections]], or core_radius_mm with diameter_mm and length_mm of each [[shafts.bearings]]")


FINEST, COARSEST = 1e-3, 1e3  # chord error, µm: below, the file grows without use; above, no tooth is left


def lacks(asked: Request) -> InputError | None:
    results = asked.results
    if _of_gears(asked):
        if results.design.gears is None:
            return InputError(0, "gears", "", Text("needed for a drawing of the gears: add [gears]"))
        if results.result(TrainResult) is None:
            reason = results.outcomes["gears"].reason
            return InputError(0, "gears", "", Text("there are no gears to draw: {reason}", reason=reason))
        return None
    return next((wrong for name, view in views(results) if (wrong := no_outline(asked, view, name))), None)


def made(asked: Request) -> Made:
    if _of_gears(asked):
        return Made({asked.path: _gears(asked)})
    if asked.options.get("chord_error") is not None:
        reason = Text("is for gears: ask for --gear WHEEL or --gears")
        raise BadInput("contralbero export", [InputError(0, "--chord-error", "", reason)])
    document = asked.document
    return Made(
        {
            named(asked.path, name): sheet_dxf(sheets(view, data=document.data, sha256=document.sha256)[0])
            for name, view in views(asked.results)
        }
    )


# --- shafts


def views(results: Results) -> Iterator[tuple[str, Results]]:
    """Of several shafts each that is no twin, by its name; a single one has none."""
    several = len(results.views) > 1
    for name, view in results.views.items() or [("", results)]:
        yield (name if several else ""), view


def named(path: Path, name: str) -> Path:
    """The file of one of several shafts: `-left` behind the name."""
    return path.with_stem(f"{path.stem}-{name}") if name else path


DRAWING = Text("a drawing")


def no_outline(asked: Request, view: Results, name: str = "", what: Text = DRAWING) -> InputError | None:
    """Why the outline of the shaft in view is not known, with what to add; `name`: of one of several; `what` it is
    needed for."""
    shaft, outcome = view.design.countershaft, view.outcomes["countershaft"]
    key = dotted(Design.shafts)
    if shaft is None:
        reason = Text("needed for {what}: add [[shafts]], and {how}; or [gears]", what=what, how=HOW)
        return InputError(0, key, "", reason)
    key = dotted(Design.shafts, name or view.design.resolved[0].name)
    if outcome.state != "solved":
        return InputError(0, key, "", Text("there is no shaft: {reason}", reason=outcome.reason))
    solved = view.result(CountershaftResult)
    if solved is None or solved.outline is None:
        reason = Text(
            "the shaft's outline is not known: {how}; `contralbero check {file} --step countershaft` tells more",
            how=HOW,
            file=asked.document.place,
        )
        return InputError(0, key, "", reason)
    return None


# --- gears


def _of_gears(asked: Request) -> bool:
    """The gears are asked for, or all there is to draw."""
    design = asked.results.design
    wanted = asked.options.get("gear") is not None or bool(asked.options.get("gears"))
    return wanted or (design.countershaft is None and design.gears is not None)


def _gears(asked: Request) -> str:
    """One wheel with its teeth and its sheet, or the whole train.  Raises BadInput for a wheel that there is not, or a
    chord error out of its range."""
    document, results = asked.document, asked.results
    gears, train, wheel = results.design.gears, results.result(TrainResult), asked.options.get("gear")
    assert gears is not None and train is not None
    given = asked.options.get("chord_error")  # in µm
    wrong = []
    if isinstance(given, float) and not FINEST <= given <= COARSEST:
        must = Text("must lie between {finest} and {coarsest}", finest=Amount(FINEST), coarsest=Amount(COARSEST, "µm"))
        wrong.append(InputError(0, "--chord-error", f"{given:g}", must))
    if wheel is not None and wheel not in train.wheels:
        reason = Text("is no wheel; the wheels are {wheels}", wheels=", ".join(train.wheels))
        wrong.append(InputError(0, "--gear", str(wheel), reason))
    if wrong:
        raise BadInput("contralbero export", wrong)
    error, name = given * 1e-6 if isinstance(given, float) else CHORD_ERROR, results.design.name
    if isinstance(wheel, str):
        sheet = wheel_sheet(results, wheel, document.data, document.sha256)
        return wheel_dxf(wheel_drawing(train, wheel, name, gears, error), LAYERS, sheet)
    return dxf(train_drawing(train, name, _positions(train, gears), gears.tooth_angle, error), LAYERS)


def _positions(train: TrainResult, gears: GearsInputs) -> dict[str, tuple[float, float]]:
    """Where the axes stand, as far as it is known: found with the layout, or given."""
    positions = {w.name: (w.position[0], w.position[1]) for w in gears.wheels if w.position is not None}
    placed = train.layout.wheels if train.layout is not None else {}
    return positions | {
        name: (w.position.real, w.position.imag) for name, w in placed.items() if w.position is not None
    }
