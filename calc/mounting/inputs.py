# SPDX-License-Identifier: Apache-2.0
"""The engine as a rigid body on its mounts: what it weighs, what it stands on, where it is felt and at which speeds it runs."""

import math
from collections.abc import Iterable, Iterator

from ..sheet.quantity import THUMB, choice, inputs, integer, quantity, series, table, tables
from ..sheet.text import Text
from .mount_inputs import PLACE, Chassis, Mount
from .use_inputs import DAY, Operation, Point

FEWEST, MOST = 3, 8  # mounts
RESERVED = (
    "frequency",
    "energy",
    "static",
    "window",
    "focal",
    "critical",
    "range",
    "exposure",
    "supported",
    "separation",
    "road",
    "decoupling",
    "lifted",
)


@inputs
class MountingInputs:
    """Mass, inertia and mounts of the engine; below them the ground or a frame."""

    mass: float = quantity("Mass", "kg", above=0, high=1e6, symbol="m", help="Engine with liquids, flywheel, and what is bolted to it.")
    centre_of_gravity: tuple[float, ...] = series("Centre of gravity", "mm", count=(3, 3), low=-10000, high=10000, symbol="r_G", help=PLACE)
    inertia: tuple[float, ...] | None = series(
        "Inertia",
        "kg·m²",
        default=None,
        count=(3, 3),
        above=0,
        high=1e7,
        symbol="J",
        help="[J_x, J_y, J_z] about the axes through the centre of gravity: yaw, pitch, roll.",
    )
    inertia_coupling: tuple[float, ...] | None = series(
        "Coupling entries",
        "kg·m²",
        default=None,
        count=(3, 3),
        low=-1e7,
        high=1e7,
        symbol="J_xy",
        help="[J_xy, J_yz, J_zx] of the tensor, −∫xy dm; left out: 0.",
    )
    inertia_sign: str = choice(
        "Sign of the coupling entries",
        "tensor",
        "integral",
        default="tensor",
        help="integral: they are given as ∫xy dm, as some programs print them.",
    )
    dimensions: tuple[float, ...] | None = series(
        "Overall dimensions",
        "mm",
        default=None,
        count=(3, 3),
        above=0,
        high=20000,
        help="[up, side, along the crank]: for an estimate of the inertia where it is not known.",
    )
    idle_speed: float = quantity(
        "Idle speed", "rpm", above=0, high=30000, symbol="n_idle", usual=(500, 1800), source=THUMB, help="At which isolation is judged."
    )
    up: tuple[float, ...] = series(
        "Direction upward", default=(1.0, 0.0, 0.0), count=(3, 3), low=-1, high=1, help="In engine axes; weight acts against it."
    )
    forward: tuple[float, ...] = series(
        "Direction forward", default=(0.0, 0.0, 1.0), count=(3, 3), low=-1, high=1, help="In engine axes, of the seat."
    )
    rotation_seen_from_front: str = choice(
        "Rotation seen from the front",
        "clockwise",
        "anticlockwise",
        default="clockwise",
        help="Decides drawings and the words left and right, no number.",
    )
    application: str = choice(
        "Application",
        "construction-machine",
        "tractor",
        "road",
        "stationary",
        "generating-set",
        "marine",
        default="construction-machine",
        help="Decides which standards for machines apply.",
    )
    machine_class: int | None = integer("Machine class", default=None, low=1, high=7, help="Of ISO 10816-6; left out: no verdict.")
    power: float | None = quantity(
        "Power", "kW", default=None, above=0, high=1e6, help="For the scope of the standards; left out: the rated one."
    )
    torque_path: str = choice(
        "Where the mean torque goes",
        "inside",
        "off_body",
        default="inside",
        help="inside: what it drives is bolted to the engine. off_body: the mounts carry it.",
    )
    output_torque: float | None = quantity(
        "Output torque",
        "N·m",
        default=None,
        low=-1e7,
        high=1e7,
        symbol="T_out",
        help="Where it leaves the body; left out: the mean torque of the gas.",
    )
    output_ratio: float = quantity(
        "Ratio of the output", default=1.0, low=-1000, high=1000, symbol="i_out", help="Torque of the output over that of the crank."
    )
    cylinder_spread: tuple[float, ...] | None = series(
        "Spread of the cylinders",
        "%",
        default=None,
        count=(1, 24),
        low=-100,
        high=100,
        symbol="epsilon_k",
        help="Of their gas torque: one number is a standard deviation, else one for each cylinder.",
    )
    scatter_couple: float | None = quantity(
        "Error of the shaft's couple",
        "%",
        default=None,
        low=-100,
        high=100,
        symbol="s",
        help="For the variant scatter; left out: from [countershaft.scatter].",
    )
    late: float | None = quantity(
        "The shaft is late by",
        "°",
        default=None,
        low=-180,
        high=180,
        symbol="delta",
        help="For the variant scatter; left out: from the scatter of its angle and the backlash of the train.",
    )
    road_frequency: float = quantity(
        "Road frequency", "Hz", default=6.0, low=0, high=1000, symbol="f_road", help="No mode should lie below it."
    )
    rigid_up_to: float = quantity("Rigid up to", "Hz", default=120.0, above=0, high=10000, help="Above it engine or frame bend.")
    seat_transmissibility: tuple[float, ...] = series(
        "Transmissibility of the seat",
        default=(1.0, 1.0, 1.0),
        count=(3, 3),
        low=0,
        high=10,
        help="[forward, side, up]; 1: what is felt is that of the rail.",
    )
    mounts: tuple[Mount, ...] = tables("Mounts", Mount)
    chassis: Chassis | None = table("Chassis", Chassis, default=None)
    points: tuple[Point, ...] = tables("Points", Point, default=())
    operation: tuple[Operation, ...] = tables("Operations", Operation, default=(), help="Left out: idle and rated.")

    @property
    def integral(self) -> bool:
        return self.inertia_sign == "integral"

    def problems(self) -> Iterable[tuple[str, Text]]:
        if not FEWEST <= len(self.mounts) <= MOST:
            count = len(self.mounts)
            yield "mounts", Text("are {count}; needs from {fewest} to {most}", count=count, fewest=FEWEST, most=MOST)
        yield from self._inertia()
        yield from self._directions()
        yield from self._names()
        for i, point in enumerate(self.points):
            if point.on == "chassis" and self.chassis is None:
                yield f"points.{i}.on", Text("needs [mounting.chassis], on which it stands")
        hours = sum(row.hours for row in self.operation if row.hours is not None)
        if hours > DAY:
            yield "operation", Text("their hours are {hours} together; a day has 24", hours=hours)
        if self.output_torque is not None and self.torque_path == "inside":
            yield "output_torque_Nm", Text('belongs to torque_path = "off_body"; leave it out, or the path')

    def _inertia(self) -> Iterator[tuple[str, Text]]:
        if self.inertia is not None and self.dimensions is not None:
            yield "dimensions_mm", Text("excludes inertia_kgm2; leave one of the two out")
        if self.inertia is None and self.dimensions is None:
            yield "inertia_kgm2", Text("is missing; give it, or dimensions_mm for an estimate")
        if self.inertia is None and self.inertia_coupling is not None:
            yield "inertia_coupling_kgm2", Text("needs inertia_kgm2, whose coupling it is")
        if self.inertia is not None:
            from .tensor import problem  # brings numpy with it

            if (reason := problem(self.inertia, self.inertia_coupling, self.integral)) is not None:
                yield "inertia_kgm2", reason

    def _directions(self) -> Iterator[tuple[str, Text]]:
        if len(self.up) != 3 or len(self.forward) != 3:
            return
        if not any(self.up):
            yield "up", Text("must be a direction, like [1, 0, 0]")
            return
        (a, b, c), (d, e, f) = self.up, self.forward
        across = math.hypot(b * f - c * e, c * d - a * f, a * e - b * d)
        if across <= 1e-6 * math.hypot(*self.up) * max(math.hypot(*self.forward), 1e-12):
            yield "forward", Text("must be a direction that is not that of up")

    def _names(self) -> Iterator[tuple[str, Text]]:
        taken = {mount.name for mount in self.mounts}
        for i, point in enumerate(self.points):
            if point.name in taken:
                yield f"points.{i}.name", Text("is that of a mount; every place needs a name of its own")
            taken.add(point.name)
        for i, support in enumerate(self.chassis.supports if self.chassis is not None else ()):
            if support.name in taken:
                yield f"chassis.supports.{i}.name", Text("is that of a mount or point; every place needs a name of its own")
            taken.add(support.name)
        for i, row in enumerate(self.operation):
            if row.name in RESERVED:
                yield f"operation.{i}.name", Text("stands for something else in the names of values; take another")
        for m, mode in enumerate(self.chassis.modes if self.chassis is not None else ()):
            for i, place in enumerate(mode.shape):
                if place.name and place.name not in taken:
                    yield f"chassis.modes.{m}.shape.{i}.name", _no_place(place.name, taken)


def _no_place(name: str, places: Iterable[str]) -> Text:
    from difflib import get_close_matches

    near = get_close_matches(name, list(places), 1)
    unknown = Text("is no mount, point or support")
    return unknown + (Text('; did you mean "{near}"?', near=near[0]) if near else Text("; there are ") + ", ".join(places))
