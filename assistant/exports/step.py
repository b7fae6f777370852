# SPDX-License-Identifier: Apache-2.0
"""Shafts and wheels as solids for CAD, by the extra `cad`: shafts one file each, as drawings, a twin where it is
another part than its original; one wheel; or all of them where they stand."""

from collections.abc import Iterator
from pathlib import Path

from assistant.exports.drawing import named, no_outline, views
from assistant.exports.kinds import Made, Request
from assistant.exports.solids import NO_ALLOWANCE, Solids
from assistant.exports.weights import changed, table
from calc.countershaft.outline import Outline
from calc.countershaft.twins import Resolved
from calc.design.model import Design
from calc.exchange.frame import date_of
from calc.exchange.places import shaft_axes
from calc.gears.inputs import GearsInputs
from calc.sheet.errors import BadInput, InputError
from calc.sheet.quantity import dotted
from calc.sheet.text import COMMA, Amount, Name, Text
from reports.step.kernel import WrongKernel, step_file
from reports.step.module import module_parts

SOLID = Text("a solid")
DENSITY = Text("density is not in the file")


def lacks(asked: Request) -> InputError | None:
    design, options = asked.results.design, asked.options
    wheels_alone = options.get("wheel") or (options.get("module") and design.countershaft is None)
    if wheels_alone or options.get("teeth"):
        if design.gears is None:
            return InputError(0, "gears", "", Text("needed for wheels: add [gears]"))
        if asked.results.train is None:
            reason = asked.results.outcomes["gears"].reason
            return InputError(0, "gears", "", Text("there are no wheels: {reason}", reason=reason))
    if wheels_alone:
        return next(_nowhere(asked), None) if options.get("module") else None
    if design.countershaft is None and design.gears is not None:
        names = ", ".join(wheel.name for wheel in design.gears.wheels)
        reason = Text("there is no shaft; --wheel NAME writes a wheel: {wheels}", wheels=names)
        return InputError(0, "--step", "", reason)
    only = {shaft.of or shaft.name for shaft in design.resolved if shaft.name == options.get("shaft")}
    seen = ((name, view) for name, view in views(asked.results) if not only or name in ("", *only))
    wrong = (lacking for name, view in seen if (lacking := no_outline(asked, view, name, SOLID)))
    return next(wrong, next(_nowhere(asked), None) if options.get("module") else None)


def made(asked: Request) -> Made:
    if wrong := list(_wrong(asked)):
        raise BadInput("contralbero export", wrong)
    kind = _wheel if asked.options.get("wheel") else _module if asked.options.get("module") else _shafts
    try:
        files, said = kind(asked, Solids(asked))
    except WrongKernel as wrong_kernel:
        raise BadInput("contralbero export", [InputError(0, "--step", "", wrong_kernel.reason)]) from None
    return Made(files, (*said, Text("The {density}.", density=DENSITY)))


Written = tuple[dict[Path, str | bytes], list[Text]]


def _shafts(asked: Request, solids: Solids) -> Written:
    files: dict[Path, str | bytes] = {}
    said: list[Text] = []
    name = asked.options.get("shaft")
    shafts = [shaft for shaft in solids.design.resolved if name in (None, shaft.name)]
    for shaft in shafts:
        if len(shafts) > 1 and (same := solids.same_part(shaft)) is not None:
            said.append(same)
            continue
        solid = solids.shaft(shaft)
        path = named(asked.path, shaft.name) if len(shafts) > 1 else asked.path
        words = "of a single part: origin on its own axis at mid-shaft, turned as at TDC of cylinder 1"
        drilled = "drilled to the greatest depth" if solid.holes else "undrilled"
        files[path] = step_file(
            [solid.part], path.name, date_of(solids.design), _words(solids, drilled, words, *_teeth(solids))
        )
        said += [*table([(solid, shaft.name)]), *solids.not_drilled(shaft), *_left_out(shaft, solids.drawn(shaft)[0])]
        if solids.teeth:
            said += changed(solid, solids.with_blank(shaft))
    return files, said


def _wheel(asked: Request, solids: Solids) -> Written:
    name = str(asked.options["wheel"])
    solid = solids.wheel(name)
    words = (
        "of a single part: origin on its own axis in the middle of its face, turned as at TDC of cylinder 1 where the "
        "layout has its teeth"
    )
    kind = ["a blank of the reference diameter"] if solids.blank else _teeth(solids)
    content = step_file([solid.part], asked.path.name, date_of(solids.design), _words(solids, *kind, words))
    said = [*table([(solid, name)])]
    if not solids.blank:
        said += changed(solid, Solids(asked, blank=True).wheel(name))
    return {asked.path: content}, said


def _module(asked: Request, solids: Solids) -> Written:
    """Every shaft, and every wheel that no shaft has in its own part."""
    axes, places, said = shaft_axes(solids.results), solids.places, list[Text]()
    shafts, wheels, on, blanks = [], [], {}, list[Text]()
    for shaft in solids.design.resolved:
        solid = solids.shaft(shaft)
        shafts.append((solid, axes[shaft.name]))
        said += [*solids.not_drilled(shaft), *_left_out(shaft, solids.drawn(shaft)[0])]
        if (wheel := solids.wheel_on(shaft)) is not None:
            on[wheel] = shaft
            if solids.teeth:
                change = changed(solid, solids.with_blank(shaft))
                said += [Text("{shaft}: {words}", shaft=Name(shaft.name), words=words) for words in change]
            elif solids.has_wheel(shaft) and not solids.blank:
                blanks.append(Text("wheel of {shaft}: blank", shaft=Name(shaft.name)))
    train = solids.train.wheels if solids.train is not None else {}
    for name in train:
        if name in places and not (name in on and solids.has_wheel(on[name])):
            solid = solids.beside(name, solids.drawn(on[name])[0]) if name in on else solids.wheel(name)
            wheels.append((solid, places[name]))
    parts = module_parts(shafts, wheels, solids.frame)
    weighed = [solid for solid, _ in (*shafts, *wheels)]
    said = [*table([(solid, part.name) for solid, part in zip(weighed, parts)]), *said]
    if blanks:
        said.append(
            Text("{blanks}, which cuts into the teeth of its mate; --teeth cuts its teeth.", blanks=COMMA.join(blanks))
        )
    if left := [name for name in train if name not in places]:
        names = COMMA.join(Name(name) for name in left)
        said.append(Text("Left out, since where they stand is not known: {names}; give position_mm.", names=names))
    kind = ["wheels as blanks of the reference diameter"] if solids.blank else [*_teeth(solids), *map(str, blanks)]
    words = _words(solids, *kind, "each part where it stands, with cylinder 1 at TDC")
    content = step_file(parts, asked.path.name, date_of(solids.design), words, solids.design.name)
    return {asked.path: content}, said


# --- what is wrong


def _wrong(asked: Request) -> Iterator[InputError]:
    """What the options ask for and is not to be had, all at once.  That only one of --shaft, --wheel and --module is
    asked for the command line says."""
    solids, options = Solids(asked), asked.options
    shaft, wheel, module = (options.get(key) for key in ("shaft", "wheel", "module"))
    wheels = list(solids.train.wheels) if solids.train is not None else []
    shafts = [one.name for one in solids.design.resolved]
    if shaft is not None and shaft not in shafts:
        reason = Text("is no shaft; the shafts are {names}", names=", ".join(shafts))
        yield InputError(0, "--shaft", str(shaft), reason)
    if wheel is not None and wheel not in wheels:
        reason = Text("is no wheel; the wheels are {wheels}", wheels=", ".join(wheels))
        yield InputError(0, "--wheel", str(wheel), reason)
    if solids.teeth and (wheel or solids.blank):
        other = "--wheel" if wheel else "--blank"
        yield InputError(
            0, "--teeth", "", Text("puts teeth on the shaft's own wheel: give it without {key}", key=other)
        )
    if options.get("drilled") and (wheel or not shafts):
        yield InputError(0, "--drilled", "", Text("is for shafts: give it without --wheel, of a design with a shaft"))
    if solids.blank and not (wheel or module):
        yield InputError(0, "--blank", "", Text("is for wheels: give --wheel NAME or --module with it"))
    if solids.end:
        if solids.blank or not (wheel or module or solids.teeth):
            yield InputError(0, "--allowance", solids.end, Text("is for teeth: give --wheel NAME, --module or --teeth"))
        carried = [solids.wheel_on(one) for one in solids.design.resolved if shaft in (None, one.name)]
        asked_for = [wheel] if wheel else wheels if module else carried
        yield from solids.lacks_end([name for name in asked_for if name in wheels])
    if solids.teeth and not module:
        for one in solids.design.resolved:
            if shaft in (None, one.name) and solids.wheel_on(one) is None:
                yield InputError(0, "--teeth", "", Text("no wheel of the train sits on {shaft}", shaft=Name(one.name)))


def _nowhere(asked: Request) -> Iterator[InputError]:
    """Of which shafts the axis is not known; of a train alone, whether of all wheels."""
    design, axes = asked.results.design, shaft_axes(asked.results)
    for shaft in design.resolved:
        if shaft.name not in axes:
            reason = Text("where {shaft} stands is not known: give axis_mm = [up, side]", shaft=Name(shaft.name))
            yield InputError(0, dotted(Design.shafts, shaft.name), "", reason)
    if not design.resolved and not Solids(asked).places:
        reason = Text("where the wheels stand is not known: give position_mm")
        yield InputError(0, dotted("gears", GearsInputs.wheels), "", reason)


# --- what is said


def _words(solids: Solids, *words: str) -> list[str]:
    """What the header says."""
    return [
        solids.design.name,
        *words,
        str(solids.frame.words),
        "products of inertia beside it are -integral XY dm, about the centre of gravity",
        str(DENSITY),
    ]


def _teeth(solids: Solids) -> list[str]:
    if not (solids.teeth or solids.options.get("wheel") or solids.options.get("module")):
        return []
    return [f"teeth at allowance {solids.end or NO_ALLOWANCE}"]


def _left_out(shaft: Resolved, shape: Outline) -> Iterator[Text]:
    """What counts as points in the results and is no part of the solid."""
    points = [*(shaft.inputs.masses if shape.plain else ()), *shaft.inputs.extras]
    if points:
        names = COMMA.join(
            Text("{name} ({mass})", name=Name(point.name), mass=Amount(point.mass, "kg")) for point in points
        )
        yield Text("{shaft}: no part of the solid: {names}.", shaft=Name(shaft.name), names=names)
