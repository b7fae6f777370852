# SPDX-License-Identifier: Apache-2.0
"""Figures and tables of the mounts: the level of a seat over speed, orders beside each other, forces, modes.

Orders with and without the shaft."""

from collections.abc import Iterator

import numpy as np

from ..sheet.arrays import Array
from ..sheet.record import record
from ..sheet.step import Curve, Series, Table, axis_label
from ..sheet.text import Amount, Name, Text
from .body import DOFS
from .inputs import DOF_WORDS, MountingInputs
from .result import MountingResult
from .standards import table


def curves(result: MountingResult) -> tuple[Curve, ...]:
    """What there is to draw: of a design without a seat the forces alone."""
    return (*seat_over_speed(result), *orders_at(result), forces(result))


def seat_over_speed(result: MountingResult) -> Iterator[Curve]:
    """The weighted level of each seat from idle to rated, one line for each variant; limits: perception and comfort."""
    limits = (
        (Text("felt by half of all people"), table()["perception"]["peak_m_s2"] / np.sqrt(2)),
        (Text("comfort"), next(row["above_m_s2"] for row in table()["comfort"] if row["above_m_s2"])),
    )
    words = result.drive.words
    for seat, c in result.courses.items():
        lines = tuple(Series(words[variant], c.speeds * 60, c.total[v]) for v, variant in enumerate(c.variants))
        title = Text("Weighted acceleration at {seat} over speed", seat=Name(seat))
        x_label, y_label = axis_label("speed", "rpm"), axis_label("a_w", "m/s²")
        yield Curve(f"seat_{seat}", title, x_label, y_label, lines, limits, short=1)


def orders_at(result: MountingResult) -> Iterator[Curve]:
    """Bars by order at each operation, half beside shaft: order 1 goes, the firing order stays."""
    for seat, weight in result.levels.weight.items():
        a = np.abs(result.levels.acceleration[seat])
        sizes = np.sqrt(((weight * a) ** 2).sum(2) / 2)  # (operations, variants, orders)
        shown = np.flatnonzero((sizes > 1e-9 * sizes.max(initial=0.0)).any((0, 1)))
        names = tuple(Text("{n}", n=Amount(float(result.drive.orders[i]))) for i in shown)
        place = np.arange(1, shown.size + 1, dtype=float)
        for i, (operation, (speed, _)) in enumerate(result.speeds.items()):
            series = tuple(
                Series(result.drive.words[variant], place, sizes[i, result.drive.variants.index(variant), shown])
                for variant in ("half", "shaft")
                if variant in result.drive.variants
            )
            rpm = Amount(speed * 60, "rpm", digits=4)
            title = Text(
                "Orders at {seat}, {operation}, {speed}", seat=Name(seat), operation=Name(operation), speed=rpm
            )
            id, x_label, y_label = f"orders_{seat}_{operation}", Text("order"), axis_label("a_w", "m/s²")
            yield Curve(id, title, x_label, y_label, series, bars=True, names=names, short=2)


def forces(result: MountingResult) -> Curve:
    """The force of each mount at each operation, half beside shaft."""
    names = tuple(Name(mount.name) for mount in result.system.mounting.mounts)
    place = np.arange(1, len(names) + 1, dtype=float)
    F = np.sqrt((np.abs(result.levels.force) ** 2).sum((-1, -2)) / 2)  # (operations, variants, mounts)
    series = tuple(
        Series(
            Text("{operation}, {variant}", operation=Name(operation), variant=result.drive.words[variant]),
            place,
            F[i, result.drive.variants.index(variant)],
        )
        for i, operation in enumerate(result.speeds)
        for variant in ("half", "shaft")
        if variant in result.drive.variants
    )
    title, x_label, y_label = Text("Forces of the mounts"), Text("mount"), axis_label("F", "N")
    return Curve("mount_forces", title, x_label, y_label, series, bars=True, names=names, short=3)


# --- tables


def tables(mounting: MountingInputs, result: MountingResult) -> tuple[Table, ...]:
    """What is felt, the modes with their energies, the mounts at rest."""
    teeth = (teeth_table(mounting, result),) if result.teeth else ()
    return (felt_table(mounting, result), *teeth, mode_table(result), rest_table(mounting, result))


def felt_table(mounting: MountingInputs, result: MountingResult) -> Table:
    """Variants by operations: the foremost seat, the foremost point of the engine, the forces of the mounts."""
    seat, engine = (point and point.name for point in (mounting.seat, mounting.engine_point))
    rows = [
        (
            Name(name),
            result.drive.words[variant],
            _shown(result.leaf(f"{name}.{variant}.{seat}.weighted"), 1.0),
            _shown(result.leaf(f"{name}.{variant}.{engine}.velocity"), 1e3),
            _shown(result.leaf(f"{name}.{variant}.force_sum"), 1.0),
        )
        for name in result.speeds
        for variant in result.drive.shown
    ]
    columns = (
        (Text("operation"), ""),
        (Text("variant"), ""),
        (Text("seat, weighted"), "m/s²"),
        (Text("engine"), "mm/s"),
        (Text("mounts"), "N"),
    )
    note = Text(
        "Root mean squares of all orders. Half over shaft gives three ratios at every operation, and never one for the "
        "engine."
    )
    return Table("felt", Text("What is felt"), columns, tuple(rows), note, short=True)


def teeth_table(mounting: MountingInputs, result: MountingResult) -> Table:
    """Of several shafts which of them one tooth off is felt how: row by row, the worst first."""
    seat, engine = (point and point.name for point in (mounting.seat, mounting.engine_point))
    rows = [
        (
            Name(name),
            result.drive.off[row].words,
            _shown(of_row[seat].weighted, 1.0) if seat is not None else None,
            _shown(of_row[engine].velocity, 1e3) if engine is not None else None,
            _shown(of_row["force_sum"].number, 1.0) if "force_sum" in of_row else None,
        )
        for name, tree in result.teeth.items()
        for row, of_row in tree.items()
    ]
    columns = (
        (Text("operation"), ""),
        (Text("one tooth off"), ""),
        (Text("seat, weighted"), "m/s²"),
        (Text("engine"), "mm/s"),
        (Text("mounts"), "N"),
    )
    note = Text("Of each number the largest of its column stands among what is felt as one tooth off, the worst.")
    return Table("felt_teeth", Text("What is felt one tooth off"), columns, tuple(rows), note)


def _shown(x: float | None, factor: float) -> float | None:
    return None if x is None else float(x) * factor


def mode_table(result: MountingResult) -> Table:
    """Mode by mode its frequency, and where its energy stands."""
    modes = result.mode_data
    rows: tuple[tuple[str | float | None, ...], ...] = tuple(
        (
            modes.words(i),
            float(modes.frequencies[i]),
            result.modes[f"mode_{i + 1}"].loss_factor * 1.0,
            *(round(100 * float(E), 1) + 0.0 for E in modes.energy[:, i]),
        )
        for i in range(6)
    )
    energies = ((DOF_WORDS[dof], "%") for dof in DOFS)
    columns = ((Text("mode"), ""), (Text("frequency"), "Hz"), (Text("loss"), ""), *energies)
    title = Text("Modes of the engine on rigid ground and their energies")
    note = Text(
        "Rows and columns add up to 100 %; a single entry may be negative where the body has products of inertia."
    )
    return Table("modes", title, columns, rows, note, short=True)


def rest_table(mounting: MountingInputs, result: MountingResult) -> Table:
    """Mount by mount what it carries and how far it gives."""
    rows = tuple(
        (Name(mount.name), result.static[mount.name].load * 1.0, result.static[mount.name].deflection * 1e3)
        for mount in mounting.mounts
    )
    columns = ((Text("mount"), ""), (Text("carries"), "N"), (Text("gives"), "mm"))
    return Table("rest", Text("Mounts under the weight"), columns, rows, covers=("mounting.static.",))


# --- pictures: modes in space, and the map of speed and order


@record
class ModePicture:
    """A mode as it moves: places at rest and their displacements at phase 0 (places, 3), in m, the largest of them 1.

    `corners`: of a box that stands for the engine, `mounts`: where they hold it, `centre`: of gravity.
    """

    words: Text
    frequency: float
    corners: Array
    corner_moves: Array
    mounts: Array
    mount_moves: Array
    centre: Array
    roll_axis: Array


def mode_pictures(mounting: MountingInputs, result: MountingResult) -> tuple[ModePicture, ...]:
    """All six, slowest first.  The box is that of the dimensions, else what the mounts and points of the engine
    span."""
    corners = box(mounting)
    centre = np.asarray(mounting.centre_of_gravity)
    mounts = np.array([mount.position for mount in mounting.mounts])
    axis = np.array([stated.number for stated in result.roll_axis.direction.values()])
    pictures = []
    for i in range(6):
        moves = [_moves(places - centre, result.mode_data.shapes[:, i]) for places in (corners, mounts)]
        size = max(float(np.abs(part).max()) for part in moves)
        corner_moves, mount_moves = moves[0] / size, moves[1] / size
        words, f = result.mode_data.words(i), float(result.mode_data.frequencies[i])
        pictures.append(ModePicture(words, f, corners, corner_moves, mounts, mount_moves, centre, axis))
    return tuple(pictures)


def box(mounting: MountingInputs) -> Array:
    """Eight corners about the engine."""
    places = [mount.position for mount in mounting.mounts] + [
        point.position for point in mounting.points if point.on == "engine"
    ]
    low, high = np.min(places, axis=0), np.max(places, axis=0)
    if mounting.dimensions is not None:
        centre, half = np.asarray(mounting.centre_of_gravity), np.asarray(mounting.dimensions) / 2
        low, high = centre - half, centre + half
    return np.array([[x, y, z] for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])])


def _moves(arms: Array, shape: Array) -> Array:
    moves: Array = shape[:3] + np.cross(shape[3:], arms)
    return moves
