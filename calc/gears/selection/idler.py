# SPDX-License-Identifier: Apache-2.0
"""The teeth of an idler, and by them its place, where walls or neighbours stand around the train.

An idler's teeth do not change the ratio.  For each number of them the profile shifts stay as they are and its centre
distances follow; the layout then finds its place, and the checks of the geometry and of the layout say what is against
it."""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence

from ...sheet.check import ORDER, Check
from ...sheet.errors import NoSolution
from ...sheet.progress import Progress, tell
from ...sheet.quantity import described, keys
from ...sheet.record import record, replace
from ...sheet.remedy import Changes
from ...sheet.step import Table
from ...sheet.text import EMPTY, SEMICOLON, Amount, Text
from ...sheet.units import Metre, RevPerSecond
from ..inputs import GearsInputs, Mesh, mesh_key, wheel_key
from ..layout.positions import Axes
from ..layout.result import WheelLayout
from ..layout.solve import ShaftInTrain, layout
from ..solve import geometry
from ..train import tooth_system
from ..wheel_inputs import Wheel
from .free_shifts import HELD, settled
from .tables import NOW, NUMBER

PART = 3  # of the present teeth: by so many as this part of them more and fewer are tried
LEAST = int(described(Wheel.teeth).low or 1)
SPEED: RevPerSecond = 1.0  # geometry and layout judge nothing by it
OF_TEETH: tuple[object, ...] = (  # what is said of a wheel's teeth as they are
    Wheel.span_teeth,
    Wheel.measured_span,
    Wheel.measured_over_balls,
    Wheel.measured_over_pins,
    Wheel.measured_chordal_thickness,
)


@record
class Idler:
    """A wheel between two others, with one number of teeth.  `against`: what is open of its own checks, the worst
    first."""

    wheel: str
    teeth: int
    changes: Changes  # empty: the design as it is
    place: WheelLayout
    largest: float  # specific sliding at the start of contact, in its own meshes
    against: tuple[Check, ...]
    refused: Text = EMPTY  # why there is no such train

    @property
    def passes(self) -> bool:
        return self.place.position is not None and all(check.verdict != "fail" for check in self.against)

    @property
    def rank(self) -> tuple[bool, int, int, float]:
        """Those that pass, then the fewest warnings, then the fewest notes, then the least sliding."""
        warns, notes = (sum(check.verdict == verdict for check in self.against) for verdict in ("warn", "note"))
        return not self.passes, warns, notes, self.largest


def idlers(gears: GearsInputs, axes: Axes, progress: Progress | None = None) -> list[list[Idler]]:
    """The numbers of teeth of each wheel that drives and is driven and has no given place, the best first.

    None where nothing stands around the train, or where it has no place."""
    choices = []
    between = {mesh.driver for mesh in gears.meshes} & {mesh.driven for mesh in gears.meshes}
    between -= gears.carriers | {stage.driver for stage in gears.stages}
    for wheel in gears.wheels if gears.walls or gears.neighbours else ():
        if wheel.name in between and wheel.position is None:
            rows = sorted(_tried(gears, wheel, axes, progress), key=lambda row: row.rank)
            if any(row.place.position is not None for row in rows):
                choices.append(rows)
    return choices


def _tried(gears: GearsInputs, wheel: Wheel, axes: Axes, progress: Progress | None) -> Iterator[Idler]:
    now, name, system = wheel.teeth, wheel.name, tooth_system(gears)
    if (train := settled(gears, system)) is None:
        return
    given = {
        i: m.centre_distance
        for i, m in enumerate(gears.meshes)
        if name in (m.driver, m.driven) and m.centre_distance is not None
    }
    shifted = replace(gears, wheels=tuple(replace(w, profile_shift=train.shifts[w.name]) for w in gears.wheels))
    gone = dict.fromkeys(
        wheel_key(name, field)
        for field in keys(Wheel).values()
        if field in OF_TEETH and getattr(wheel, field.attribute) is not None
    )
    low, high = max(LEAST, now - now // PART), now + now // PART
    without_backlash = {n: settled(_with(shifted, name, n, dict.fromkeys(given)), system) for n in range(low, high + 1)}
    for teeth, free in without_backlash.items():
        tell(progress, (teeth - low) / (high + 1 - low), Text("{wheel} with {n} teeth", wheel=name, n=teeth))
        if teeth == now:
            yield _judged(gears, name, now, axes, {})
        elif free is not None and (present := without_backlash[now]) is not None:
            grown = {i: free.distances[key] - present.distances[key] for i in given for key in [gears.meshes[i].key]}
            apart = {i: round(a + grown[i], HELD) for i, a in given.items()}
            distances = {mesh_key(i, Mesh.centre_distance): round(a * 1e3, 3) for i, a in apart.items()}
            changes = {wheel_key(name, Wheel.teeth): teeth, **distances, **gone}
            yield _judged(_with(gears, name, teeth, apart), name, teeth, axes, changes)


def _with(gears: GearsInputs, name: str, teeth: int, apart: Mapping[int, Metre | None]) -> GearsInputs:
    """The train with other teeth of one wheel, nothing that was said of the old ones, and other centre distances."""
    bare = {
        w.name: replace(
            w,
            teeth=teeth,
            span_teeth=None,
            measured_span=None,
            measured_over_balls=None,
            measured_over_pins=None,
            measured_chordal_thickness=None,
        )
        for w in gears.wheels
        if w.name == name
    }
    meshes = tuple(replace(m, centre_distance=apart.get(i, m.centre_distance)) for i, m in enumerate(gears.meshes))
    return replace(gears, wheels=tuple(bare.get(w.name, w) for w in gears.wheels), meshes=meshes)


def _judged(gears: GearsInputs, name: str, teeth: int, axes: Axes, changes: Changes) -> Idler:
    try:
        outcome = geometry(gears, SPEED)
        placed = layout(gears, outcome.solution, {shaft: ShaftInTrain(axis) for shaft, axis in axes.items()})
    except NoSolution as none:
        return Idler(name, teeth, changes, WheelLayout(), math.inf, (), none.what)
    meshes = {key: mesh for key, mesh in outcome.solution.meshes.items() if name in (mesh.driver, mesh.driven)}
    sliding = [abs(zeta) for m in meshes.values() for zeta in (m.specific_sliding_driver, m.specific_sliding_driven)]
    names = {name, *meshes, *(wheel for wheel, there in placed.solution.wheels.items() if there.nearest == name)}
    against = [check for check in (*outcome.checks, *placed.checks) if check.open and check.id.split(".")[1] in names]
    against.sort(key=lambda check: -ORDER.index(check.verdict))
    return Idler(name, teeth, changes, placed.solution.wheels[name], max(sliding), tuple(against))


# --- as tables


def idler_table(rows: Sequence[Idler], first: int, top: int) -> Table:
    """The design, the numbers that pass, numbered from `first`, and those beside them, which do not."""
    passing = passed(rows)
    near = {row.teeth + n for row in rows if row.passes or not row.changes for n in (-1, 1)}
    failing = [row for row in rows if row.teeth in near and row.changes and not row.passes]
    cells = [_cells(NOW, row) for row in rows if not row.changes]
    cells += [_cells(str(first + n), row) for n, row in enumerate(passing[:top])]
    cells += [_cells("", row) for row in sorted(failing, key=lambda row: row.teeth)]
    title = Text("Teeth of {wheel}: its place, and what is against it", wheel=rows[0].wheel)
    legend = Text(
        "With the profile shifts as they are. up, side: its axis from the crank's; room: to the nearest thing that it "
        "does not mesh with. First the fewest warnings and notes, then the least sliding in its meshes. Rows without "
        "number fail; farther ones are left out."
    )
    left = len(passing) - top
    note = legend + Text(" {n} more; --top N shows more.", n=left) if left > 0 else legend
    place = (Text("up"), "mm"), (Text("side"), "mm"), (Text("room"), "mm"), (Text("to"), "")
    judged = (Text("its own max |ζ_A|"), ""), (Text("against it"), "")
    columns = (NUMBER, ""), (Text("teeth"), ""), *place, *judged
    return Table(f"teeth_{rows[0].wheel}", title, columns, tuple(cells), note)


def passed(rows: Iterable[Idler]) -> list[Idler]:
    """The rows that can be written."""
    return [row for row in rows if row.passes and row.changes]


def _cells(number: str, row: Idler) -> tuple[str | float | None, ...]:
    room = None if row.place.clearance is None else round(row.place.clearance * 1e3, 3)
    p = row.place.position
    at = (None, None) if p is None else (round(p.real * 1e3, 3), round(p.imag * 1e3, 3))
    why = SEMICOLON.join(check.name for check in row.against[:2])
    sliding = None if math.isinf(row.largest) else round(row.largest, 3)
    return number, row.teeth, *at, room, row.place.nearest, sliding, row.refused or why


def written(row: Idler) -> Text:
    """What is said of a row that is written."""
    room, to = Amount((row.place.clearance or 0.0) * 1e3, "mm", digits=3), row.place.nearest
    return Text("now has {wheel} with {n} teeth, {room} from {to}", wheel=row.wheel, n=row.teeth, room=room, to=to)
