# SPDX-License-Identifier: Apache-2.0
"""Shafts as solids for CAD, by the extra `cad`: of several one file each, as drawings; a twin has one of its own where
it is another part than its original."""

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path

from assistant.exports.drawing import named, no_outline, views
from assistant.exports.kinds import Made, Request
from calc.countershaft.balancing.inputs import Balancing
from calc.countershaft.balancing.solve import Made as Undrilled
from calc.countershaft.balancing.solve import drills
from calc.countershaft.outline import Outline
from calc.countershaft.twins import Resolved
from calc.exchange.frame import date_of, frame_of
from calc.sheet.errors import BadInput, InputError
from calc.sheet.text import COMMA, Amount, Name, Text
from calc.solve import Results
from reports.step.kernel import MODULE, WrongKernel, step_file
from reports.step.shaft import Hole, ShaftSolid, Weighed, mirrored, shaft_solid, turned_alike

EXTRA = Text('a STEP file needs the extra "cad": pip install "contralbero[cad]" (380 MB)')
DENSITY = Text("density is not in the file")


def lacks(asked: Request) -> InputError | None:
    if find_spec(MODULE) is None:
        return InputError(0, "", "", EXTRA)
    return next((wrong for name, view in views(asked.results) if (wrong := no_outline(asked, view, name))), None)


def made(asked: Request) -> Made:
    files: dict[Path, str | bytes] = {}
    said: list[Text] = []
    shafts = _asked_for(asked)
    try:
        for shaft in shafts:
            view = asked.results.view(shaft.name)
            shape, holes = _outline(view), _holes(asked, view)
            if shaft.how != "own":
                same = 0.0 if shaft.how == "repeats" else turned_alike(shape, holes)
                if same is not None and len(shafts) > 1:
                    said.append(_same_part(shaft, same))
                    continue
            if shaft.how == "mirrors":
                shape, holes = mirrored(shape), [replace(hole, angle=-hole.angle) for hole in holes]
            path = named(asked.path, shaft.name) if len(shafts) > 1 else asked.path
            rho = view.design.materials[shaft.inputs.material].density
            solid = shaft_solid(shaft.name, shape, rho, frame_of(asked.results.design), holes)
            files[path] = step_file([solid.part], path.name, date_of(asked.results.design), _words(asked, holes))
            said += [*_table(solid), *_left_out(shaft, shape)]
    except WrongKernel as wrong:
        raise BadInput("contralbero export", [InputError(0, "--step", "", wrong.reason)]) from None
    return Made(files, (*said, Text("The {density}.", density=DENSITY)))


# --- which shafts


def _asked_for(asked: Request) -> Sequence[Resolved]:
    """The shaft that is named, else all.  Raises BadInput where there is none of that name."""
    shafts, name = asked.results.design.resolved, asked.options.get("shaft")
    if name is None:
        return shafts
    chosen = [shaft for shaft in shafts if shaft.name == name]
    if not chosen:
        reason = Text("is no shaft; the shafts are {names}", names=", ".join(shaft.name for shaft in shafts))
        raise BadInput("contralbero export", [InputError(0, "--shaft", str(name), reason)])
    return chosen


def _outline(view: Results) -> Outline:
    assert view.shaft is not None and view.shaft.outline is not None  # as `lacks` has seen
    return view.shaft.outline


def _holes(asked: Request, view: Results) -> list[Hole]:
    """The holes of the balancing sheet at their greatest depth: as [shafts.balancing] places them, else the calibration
    holes, in a row along each mass.  Raises BadInput where there are none."""
    if not asked.options.get("drilled"):
        return []
    shaft, solved = view.design.countershaft, view.shaft
    assert shaft is not None and solved is not None
    made = Undrilled(solved.masses, solved.outline, shaft.outer_radius, 0.0, 0.0, None)
    holes = drills(shaft, shaft.balancing or Balancing(), made)
    if not holes:
        reason = Text(
            "needs holes to drill: add [shafts.holes] with diameter_mm, depth_mm and count, or "
            "[[shafts.balancing.holes]]"
        )
        raise BadInput("contralbero export", [InputError(0, "--drilled", "", reason)])
    return [Hole(o.name, o.z, o.angle, o.R, o.diameter, o.depth, o.point) for o in holes]


def _same_part(shaft: Resolved, turned: float) -> Text:
    turned = round(math.degrees(turned), 9)
    if not turned:
        return Text("{name} is the same part as {original}.", name=Name(shaft.name), original=Name(shaft.of or ""))
    return Text(
        "{name} is the same part as {original}, turned by {angle}.",
        name=Name(shaft.name),
        original=Name(shaft.of or ""),
        angle=Amount(turned, "°"),
    )


# --- what is said of it


def _words(asked: Request, holes: Sequence[Hole]) -> list[str]:
    """What the header says."""
    design = asked.results.design
    return [
        design.name,
        "drilled to the greatest depth" if holes else "undrilled",
        str(frame_of(design).words),
        "of a single part: origin on its own axis at mid-shaft, turned as at TDC of cylinder 1",
        "products of inertia beside it are -integral XY dm, about the centre of gravity",
        str(DENSITY),
    ]


COLUMNS = ("cm³", "kg", "X mm", "Y mm", "Z mm", "J_XX kg·mm²", "J_YY", "J_ZZ", "J_XY", "J_YZ", "J_ZX")


def _table(solid: ShaftSolid) -> Iterator[Text]:
    """A line for each solid, the whole, and the same by the program; then how far they are apart."""
    lines = [(one.name, _numbers(one)) for one in solid.solids]
    if len(lines) > 1:
        lines.append((str(Text("together")), _numbers(solid.whole)))
    if solid.holes:
        lines.append((str(Text("undrilled")), _numbers(solid.undrilled)))
    lines.append((str(Text("by the program")), _numbers(solid.by_program)))
    cells = [("", *COLUMNS), *((name, *(f"{x:.6g}" for x in row)) for name, row in lines)]
    widths = [max(map(len, column)) for column in zip(*cells)]
    for name, *numbers in cells:
        row = (number.rjust(width) for number, width in zip(numbers, widths[1:]))
        yield Name("  ".join((name.ljust(widths[0]), *row)))
    yield Text(
        "Deviation {share}; J about the centre of gravity, its products −∫XY dm.", share=f"{solid.deviation:.1e}"
    )


def _numbers(one: Weighed) -> list[float]:
    """As the columns have them; what is nothing beside its like is 0."""
    J = one.tensor
    tensor = [J[0, 0], J[1, 1], J[2, 2], J[0, 1], J[1, 2], J[2, 0]]
    return [one.volume * 1e-3, one.mass, *_rounded(one.centre), *_rounded(tensor)]


def _rounded(numbers: Iterable[float]) -> list[float]:
    numbers = [float(x) for x in numbers]
    dust = 1e-9 * max(map(abs, numbers))
    return [x if abs(x) > dust else 0.0 for x in numbers]


def _left_out(shaft: Resolved, shape: Outline) -> Iterator[Text]:
    """What counts as points in the results and is no part of the solid."""
    points = [*(shaft.inputs.masses if shape.plain else ()), *shaft.inputs.extras]
    if points:
        names = COMMA.join(
            Text("{name} ({mass})", name=Name(point.name), mass=Amount(point.mass, "kg")) for point in points
        )
        yield Text("{shaft}: no part of the solid: {names}.", shaft=Name(shaft.name), names=names)
