# SPDX-License-Identifier: Apache-2.0
"""The gear train as a sketch: its wheels where they stand, and beside them the teeth of the mesh with the least
backlash.

Up is up from the crank's axis, the crank turns clockwise.  Where the places of the axes are not known the wheels stand
in a row."""

from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING

from ..draw import drawing as draw
from ..sheet.check import Check
from ..sheet.errors import NoSolution
from ..sheet.quantity import dotted
from ..sheet.text import Amount, Name, Text
from ..sheet.units import Metre, Number
from ..sheet.value import untraced
from .backlash.checks import BACKLASH, BACKLASH_COLD, BACKLASH_WARM, BACKLASH_WARMING
from .checks import TIP_THICKNESS, UNDERCUT
from .curves import pitch_point_view
from .inputs import GearsInputs, Mesh
from .layout.curves import stage_lines
from .layout.room import CLEARANCE, REACH
from .measures.formulas import generating_shift
from .profile.drawing import in_row
from .profile.meshing import PENETRATION
from .profile.outline import Outline, regions
from .result import MeshResult, TrainResult
from .wheel_inputs import Wheel

if TYPE_CHECKING:
    from ..design.model import Design
    from ..solve import Results

FINE = 1e-2  # chord error of the teeth in modules, rule of this program: a dot is larger
GAP: Number = 0.3  # modules: the largest backlash is drawn no wider
# checks by which a mesh has no room for its teeth
JAMS = (BACKLASH, BACKLASH_COLD, BACKLASH_WARM, BACKLASH_WARMING, PENETRATION)
FAULTS = (CLEARANCE, REACH, UNDERCUT, TIP_THICKNESS)  # of a wheel
BELOW = 0.25  # of the tip radius: where the number of teeth stands below the name
ABOVE = 0.1  # of the largest tip diameter: how far above the wheels the distances stand
MOST: Number = 50  # the gap is exaggerated no more


def sketch(design: "Design", results: "Results") -> draw.Sketch:
    """The train of a design, and its tightest mesh."""
    outcome = results.outcomes["gears"]
    gears: GearsInputs | None = design.gears
    train = outcome.result
    if gears is None or not isinstance(train, TrainResult):
        return draw.awaited(outcome)
    checks = tuple(outcome.checks)
    placed = _placed(train)
    centres = placed or in_row(train)
    notes = [Text("a {distances} mm", distances=Text(", ").join(map(_distance, train.meshes.values())))]
    if not placed:
        notes = [Text("in a row"), Text("mm")]
    train_view = tuple(_train(gears, train, centres, checks, bool(placed)))
    if not train.meshes:
        return draw.Sketch(train_view)
    key = min(train.meshes, key=lambda key: train.meshes[key].backlash_min)
    try:
        with untraced():
            teeth, exaggerated = _teeth(train, key, checks)
    except NoSolution:
        return draw.Sketch(train_view, tuple(notes))
    if exaggerated > 1:
        notes.append(Text("gap × {factor}", factor=Amount(exaggerated)))
    return draw.Sketch(train_view, tuple(notes), beside=(teeth,))


def _placed(train: TrainResult) -> dict[str, complex] | None:
    """To the right and up, where every wheel has a place."""
    laid = train.layout.wheels if train.layout is not None else {}
    known = {name: complex(w.position.imag, w.position.real) for name, w in laid.items() if w.position is not None}
    if known.keys() != train.wheels.keys():
        return None
    sprockets = train.layout.sprockets if train.layout is not None else {}
    return known | {name: complex(p.imag, p.real) for name, p in sprockets.items()}


def _point(at: complex) -> draw.Point:
    return at.real, at.imag


# --- the train


def _train(
    gears: GearsInputs, train: TrainResult, centres: Mapping[str, complex], checks: tuple[Check, ...], placed: bool
) -> Iterator[draw.Mark]:
    jams = {key: draw.judged(checks, *(rule.of(key) for rule in JAMS)) for key in train.meshes}
    for name, wheel in train.wheels.items():
        at, tip = _point(centres[name]), wheel.tip_diameter / 2
        key = dotted("gears", GearsInputs.wheels, name)
        state = draw.judged(checks, *(rule.of(name) for rule in FAULTS))
        pitch = max((d for _, d, _ in train.mates(name)), default=wheel.reference_diameter) / 2
        yield draw.Area(draw.CONTEXT, (draw.round_outline(at, tip),), 0.3, key, state)
        yield draw.Arc(draw.OUTLINE, at, pitch, key=f"{key} {dotted('gears', GearsInputs.normal_module)}", state=state)
        yield draw.Words(draw.WORDS, at, Name(name), key=key, side="centre")
        z, below = Text("z {teeth}", teeth=wheel.teeth), (at[0], at[1] - BELOW * tip)
        yield draw.Words(draw.CONTEXT, below, z, key=dotted(key, Wheel.teeth), side="centre")
    for n, (key, mesh) in enumerate(train.meshes.items()):
        if jams[key]:  # a ring around the pitch point of teeth that have no room
            first, second = centres[mesh.driver], centres[mesh.driven]
            share = mesh.working_diameter_driver / (mesh.working_diameter_driver + mesh.working_diameter_driven)
            place, radius = _point(first + (second - first) * share), 0.12 * mesh.centre_distance
            yield draw.Arc(draw.OUTLINE, place, radius, key=dotted("gears", GearsInputs.meshes, n), state=jams[key])
    yield from _lines(train, centres, told=not placed)
    yield from _stages(train, centres)
    if placed:
        yield from _obstacles(gears)


def _stages(train: TrainResult, centres: Mapping[str, complex]) -> Iterator[draw.Mark]:
    """Chains and belts as lines around their sprockets; of a sprocket on the outer side its circle.  Sprockets that
    turn beside no wheel have their names."""
    for name in (name for name in centres if name not in train.wheels):
        yield draw.Words(draw.WORDS, _point(centres[name]), Name(name), side="centre")
    for name, line in stage_lines(train, centres):
        yield draw.Polyline(
            draw.HIDDEN, tuple(map(_point, line.tolist())), key=dotted("gears", GearsInputs.stages, name)
        )


def _lines(train: TrainResult, centres: Mapping[str, complex], told: bool) -> Iterator[draw.Mark]:
    """The lines of centres, and above wheels in a row their lengths."""
    if not train.meshes:
        return
    top = max(centres[name].imag + wheel.tip_diameter / 2 for name, wheel in train.wheels.items())
    above = top + ABOVE * max(wheel.tip_diameter for wheel in train.wheels.values())
    for n, mesh in enumerate(train.meshes.values()):
        first, second = centres[mesh.driver], centres[mesh.driven]
        key = dotted("gears", GearsInputs.meshes, n, Mesh.centre_distance)
        yield draw.Polyline(draw.AXIS, (_point(first), _point(second)), key=key)
        if told:
            yield draw.Words(
                draw.DIMENSIONS, ((first.real + second.real) / 2, above), _distance(mesh), key=key, side="centre"
            )


def _distance(mesh: MeshResult) -> Text:
    return Text("{distance}", distance=Amount(mesh.centre_distance * 1000))


def _obstacles(gears: GearsInputs) -> Iterator[draw.Mark]:
    """Walls and neighbours, given as [up, side]."""
    for wall in gears.walls:
        (up, side), (up_2, side_2) = wall.from_, wall.to
        yield draw.Polyline(
            draw.OUTLINE, ((side, up), (side_2, up_2)), key=dotted("gears", GearsInputs.walls, wall.name)
        )
    for other in gears.neighbours:
        (up, side), key = other.position, dotted("gears", GearsInputs.neighbours, other.name)
        yield draw.Area(draw.CONTEXT, (draw.round_outline((side, up), other.radius),), 0.15, key)
        yield draw.Arc(draw.HIDDEN, (side, up), other.radius, key=key)


# --- the teeth


def _teeth(train: TrainResult, key: str, checks: Iterable[Check]) -> tuple[draw.Sketch, Number]:
    """Teeth of both wheels at the pitch point, the driver's thinned by the backlash, and how much that is exaggerated.

    The backlash is that in the middle of the tolerances, or the smallest where that fails.  The flanks that carry
    touch, the gap is behind them.  Backlash below zero shows as teeth that run into each other."""
    mesh, system = train.meshes[key], train.system
    driver, driven = train.wheels[mesh.driver], train.wheels[mesh.driven]
    state = draw.judged(checks, *(rule.of(key) for rule in JAMS))
    smallest = mesh.backlash_min if train.play is None else train.play[key].backlash_min_runout
    gap = smallest if state else mesh.backlash_nominal
    factor = min(draw.rounded(GAP * system.m_n / abs(gap)), MOST) if gap else 1.0
    drawn = factor * gap
    shift = generating_shift(driver.profile_shift, -drawn, system.m_n, system.alpha_n)
    below, above = regions(system, driver, FINE * system.m_n, shift), regions(system, driven, FINE * system.m_n)
    roll = -max(0.0, drawn) / driver.base_diameter  # until its flanks touch; not at all into the mate
    under, over = pitch_point_view(mesh, (driver, below), (driven, above), roll)
    at = dotted("gears", GearsInputs.meshes, list(train.meshes).index(key))
    marks: list[draw.Mark] = [*_flank(under, -1, at, system.m_n), *_flank(over, 1, at, system.m_n)]
    low, high = min(y for mark in marks for _, y in _corners(mark)), max(y for mark in marks for _, y in _corners(mark))
    marks.append(
        draw.Words(
            draw.WORDS,
            (0.0, low - 0.6 * system.m_n),
            _backlash(mesh),
            key=f"{dotted(at, Mesh.tolerance)} {dotted(at, Mesh.centre_distance)}",
            state=state,
            side="centre",
        )
    )
    marks.append(draw.Polyline(draw.AXIS, ((0.0, low), (0.0, high))))
    return draw.Sketch(tuple(marks), title=Text("{pair}", pair=Name(mesh.title))), factor


def _flank(line: Outline, way: int, key: str, m_n: Metre) -> Iterator[draw.Mark]:
    """Teeth as a line, filled to a little behind their roots."""
    points = tuple(zip(line.real.tolist(), line.imag.tolist()))
    back = (min if way < 0 else max)(y for _, y in points) + way * 0.4 * m_n
    yield draw.Area(
        draw.OUTLINE, ((*points, (points[-1][0], back), (points[0][0], back)),), 0.3 if way < 0 else 0.5, key
    )
    yield draw.Polyline(draw.OUTLINE, points, key=key)


def _corners(mark: draw.Mark) -> Iterable[draw.Point]:
    return mark.points if isinstance(mark, draw.Polyline) else mark.outlines[0] if isinstance(mark, draw.Area) else ()


def _backlash(mesh: MeshResult) -> Text:
    low, high = Amount(mesh.backlash_min * 1e6, form=".0f"), Amount(mesh.backlash_max * 1e6, form=".0f")
    return Text("backlash {low} … {high} µm", low=low, high=high)
