# SPDX-License-Identifier: Apache-2.0
"""The engine as a rigid body on its mounts: mass, mounts, the frame, where it is felt and at which speeds it runs.

In order: the inertia tensor, mounts and frame, points and operations, the inputs of the step, words."""

import math
from collections.abc import Iterable, Iterator

from ..engine.operation import OfGas
from ..engine.operation import Operation as EngineOperation
from ..sheet.arrays import Array
from ..sheet.quantity import as_in, choice, dotted, inputs, integer, meant, quantity, series, table, tables, text
from ..sheet.text import COMMA, Amount, Text

# --- the inertia tensor of a rigid body, and whether a body can have it

DUST = 1e-9  # of the sum of two principal moments: a thin disc has exactly the third


def tensor(diagonal: tuple[float, ...], coupling: tuple[float, ...] | None, integral: bool = False) -> Array:
    """The tensor from its diagonal and [J_xy, J_yz, J_zx]; `integral`: these are given as ∫xy dm, with the other
    sign."""
    import numpy as np  # the form is painted without it

    xy, yz, zx = coupling if coupling is not None else (0.0, 0.0, 0.0)
    off = np.array([[0.0, xy, zx], [xy, 0.0, yz], [zx, yz, 0.0]])
    matrix: Array = np.diag(np.asarray(diagonal, dtype=float)) + (-off if integral else off)
    return matrix


def problem(diagonal: tuple[float, ...], coupling: tuple[float, ...] | None, integral: bool = False) -> Text | None:
    """Why no body can have these moments of inertia; None where one can."""
    if len(diagonal) != 3 or (coupling is not None and len(coupling) != 3):
        return None  # said already
    import numpy as np

    J = tensor(diagonal, coupling, integral)
    if not np.isfinite(J).all():
        return None
    first, second, third = np.linalg.eigvalsh(J).tolist()
    if first > 0 and third <= (first + second) * (1 + DUST):
        return None
    moments = COMMA.join(Text("{J}", J=Amount(x, form=".4g")) for x in (first, second, third))
    if first <= 0:
        return Text(
            "no body has it: its principal moments are {moments} kg·m², and each must be above 0", moments=moments
        )
    return Text(
        "no body has it: of its principal moments {moments} kg·m² the largest exceeds the sum of the others",
        moments=moments,
    )


# --- what an engine stands on: its mounts, and the frame of the machine below them

PLACE = "In engine axes, [up, side, to the flywheel], from mid-engine on the crank's axis."

# the folds of the form
MOUNTS = Text("More of the mounts")
FRAME = Text("Frame, points, operations")


@inputs
class Mobility:
    """One row of a measured mobility of the foundation: velocity over force, complex, in engine axes."""

    frequency: float = quantity("Frequency", "Hz", up_to=10000, symbol="f", help="Rising from row to row.")
    x: tuple[float, ...] = series(
        "Mobility up", "mm/s/N", default=(0.0, 0.0), count=(2, 2), help="[real, imaginary part]."
    )
    y: tuple[float, ...] = series(
        "Mobility to the side", "mm/s/N", default=(0.0, 0.0), count=(2, 2), help="[real, imaginary part]."
    )
    z: tuple[float, ...] = series(
        "Mobility fore and aft", "mm/s/N", default=(0.0, 0.0), count=(2, 2), help="[real, imaginary part]."
    )


@inputs
class Mount:
    """A mount of the engine.  Its stiffness is static; what turns it into the dynamic one stands beside."""

    name: str = text("Name", help="Letters, digits and -.", decides=5)
    position: tuple[float, ...] = series(
        "Position", "mm", count=(3, 3), within=(-10000, 10000), symbol="r", help=PLACE, repair="asked", decides=6
    )
    stiffness: tuple[float, ...] = series(
        "Static stiffness",
        "N/mm",
        count=(3, 3),
        up_to=1e7,
        symbol="k",
        help="Along the mount's own axes; the first is its compression.",
        repair="free",
        decides=7,
    )
    dynamic_ratio: float = quantity(
        "Dynamic over static stiffness",
        default=1.3,
        up_to=10,
        symbol="d",
        rule_of_thumb=(1.1, 1.8),
        help="Natural rubber of 40, 50, 60, 70 Shore A: about 1.1, 1.2, 1.35, 1.6.",
    )
    loss_factor: float | None = quantity(
        "Loss factor",
        default=None,
        within=(0, 10),
        symbol="eta",
        rule_of_thumb=(0.03, 0.2),
        help="Natural rubber of 40, 50, 60, 70 Shore A: about 0.05, 0.08, 0.12, 0.16. Left out: 0.1, or none beside "
        "damping.",
    )
    damping: float | None = quantity(
        "Viscous damping",
        "N·s/mm",
        default=None,
        within=(0, 1e4),
        symbol="c",
        help="Along each own axis, instead of a loss factor.",
    )
    turned: tuple[float, ...] | None = series(
        "Turned by",
        "°",
        default=None,
        count=(3, 3),
        within=(-360, 360),
        help="[a, b, c] about the fixed axes: first x (up), then y (side), then z (crank).",
        repair="free",
    )
    frequency_dependence: str = choice(
        "Frequency dependence",
        "none",
        "fractional",
        default="none",
        help="fractional: the stiffness rises with frequency as much as its constant loss factor asks for.",
    )
    foundation: tuple[float, ...] | None = series(
        "Foundation's stiffness",
        "N/mm",
        default=None,
        count=(1, 3),
        up_to=1e9,
        symbol="k_f",
        help="Below the mount, along the mount's own axes; one number for all three.",
    )
    foundation_loss: float | None = quantity(
        "Foundation's loss factor",
        default=None,
        within=(0, 10),
        symbol="eta_f",
        help="Of the foundation itself; left out: 0.",
    )
    mobility: tuple[Mobility, ...] = tables(
        "Foundation's mobility",
        Mobility,
        default=(),
        help="Measured at the foot, over frequency; each foot by itself, without cross mobility.",
    )
    deflection_limit: float | None = quantity(
        "Largest deflection",
        "mm",
        default=None,
        up_to=1000,
        help="Along each own axis, static, mean torque and vibration together.",
        repair="asked",
    )

    @property
    def eta(self) -> float:
        """The loss factor that counts: given, or that of ordinary rubber where there is no damper."""
        return self.loss_factor if self.loss_factor is not None else 0.0 if self.damping is not None else 0.1

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.loss_factor is not None and self.damping is not None:
            yield dotted(Mount.damping), Text("excludes loss_factor; leave one of the two out")
        if self.frequency_dependence == "fractional" and self.damping is not None:
            yield (
                dotted(Mount.frequency_dependence),
                Text("fractional goes with a loss factor, not with damping_Ns_mm; leave one of the two out"),
            )
        yield from loss_problems(self.loss_factor, "loss_factor")
        yield from loss_problems(self.foundation_loss, "foundation_loss")
        if self.foundation is None and self.foundation_loss is not None:
            yield dotted(Mount.foundation_loss), Text("needs foundation_N_mm, whose loss it is")
        if self.foundation is not None and len(self.foundation) == 2:
            yield dotted(Mount.foundation), Text("has 2 entries; needs one, or one for each of the three own axes")
        if self.foundation is not None and self.mobility:
            yield dotted(Mount.mobility), Text("excludes foundation_N_mm; leave one of the two out")
        frequencies = [row.frequency for row in self.mobility]
        if frequencies != sorted(set(frequencies)):
            yield dotted(Mount.mobility), Text("its frequencies must rise from row to row")


@inputs
class Support:
    """What carries the frame: a tyre, a mount of the cab.  Its stiffness is the dynamic one."""

    name: str = text("Name", help="Letters, digits and -.")
    position: tuple[float, ...] = series(
        "Position", "mm", count=(3, 3), within=(-20000, 20000), symbol="r", help=PLACE, repair="asked"
    )
    stiffness: tuple[float, ...] = series(
        "Dynamic stiffness", "N/mm", count=(3, 3), up_to=1e9, symbol="k", help="Along its own axes."
    )
    loss_factor: float | None = quantity(
        "Loss factor",
        default=None,
        within=(0, 10),
        symbol="eta",
        help="Of the support; left out: 0.1, or none beside damping.",
    )
    damping: float | None = quantity(
        "Viscous damping", "N·s/mm", default=None, within=(0, 1e4), symbol="c", help="Instead of a loss factor."
    )
    turned: tuple[float, ...] | None = series(
        "Turned by",
        "°",
        default=None,
        count=(3, 3),
        within=(-360, 360),
        help="[a, b, c] about the fixed axes: first x, then y, then z.",
    )

    @property
    def eta(self) -> float:
        return self.loss_factor if self.loss_factor is not None else 0.0 if self.damping is not None else 0.1

    def problems(self) -> Iterable[tuple[str, Text]]:
        if self.loss_factor is not None and self.damping is not None:
            yield dotted(Support.damping), Text("excludes loss_factor; leave one of the two out")
        yield from loss_problems(self.loss_factor, "loss_factor")


@inputs
class Move:
    """How far a place moves in a mode of the frame of unit modal mass."""

    name: str = text("Mount, point or support", help="Its name.")
    move: tuple[float, ...] = series(
        "Moves by", count=(3, 3), within=(-100, 100), symbol="phi", help="In engine axes, in 1/√kg."
    )


@inputs
class FrameMode:
    """A mode of the elastic frame, to unit modal mass.  A place that its shape does not name does not move in it."""

    frequency: float = quantity("Frequency", "Hz", up_to=1000, symbol="f", help="Of the frame without the engine.")
    loss_factor: float = quantity(
        "Loss factor", default=0.05, within=(0, 10), symbol="eta", help="Of the mode; left out: 0.05."
    )
    shape: tuple[Move, ...] = tables("Shape", Move)

    def problems(self) -> Iterable[tuple[str, Text]]:
        yield from loss_problems(self.loss_factor, "loss_factor")


@inputs
class Chassis:
    """The frame of the machine: a second rigid body on its own supports, and what it bends by."""

    mass: float = quantity("Mass", "kg", up_to=1e7, symbol="m_c", help="Without the engine.")
    centre_of_gravity: tuple[float, ...] = series(
        "Centre of gravity", "mm", count=(3, 3), within=(-20000, 20000), help=PLACE
    )
    inertia: tuple[float, ...] = series(
        "Inertia",
        "kg·m²",
        count=(3, 3),
        up_to=1e9,
        symbol="J_c",
        help="About the axes through its centre of gravity.",
    )
    inertia_coupling: tuple[float, ...] | None = series(
        "Coupling entries",
        "kg·m²",
        default=None,
        count=(3, 3),
        within=(-1e9, 1e9),
        help="[J_xy, J_yz, J_zx] of the tensor, −∫xy dm.",
    )
    supports: tuple[Support, ...] = tables("Supports", Support)
    modes: tuple[FrameMode, ...] = tables("Modes of the frame", FrameMode, default=())

    def problems(self) -> Iterable[tuple[str, Text]]:

        if (reason := problem(self.inertia, self.inertia_coupling)) is not None:
            yield dotted(Chassis.inertia), reason
        if not self.supports:
            yield dotted(Chassis.supports), Text("needs at least one support: a frame that nothing carries falls")


def loss_problems(eta: float | None, key: str) -> Iterable[tuple[str, Text]]:
    if eta is not None and eta >= 1:
        yield key, Text("must stay below 1: beyond it a mount is no spring")


# --- where vibration is looked at, and at which speeds the engine runs

DAY = 24.0  # h


@inputs
class Point:
    """A place where vibration is looked at."""

    name: str = text("Name", help="Letters, digits and -.")
    position: tuple[float, ...] = series(
        "Position", "mm", count=(3, 3), within=(-20000, 20000), symbol="r", help=PLACE, repair="asked"
    )
    on: str = choice("Stands on", "engine", "chassis", default="engine")
    role: str = choice(
        "What it is",
        "machine",
        "seat",
        "hand",
        default="machine",
        help="seat, hand: what a person feels there is weighted as ISO 2631-1 and ISO 5349-1 ask.",
    )


@inputs
class Operation(OfGas):
    """A speed at which the engine runs, and its gas there where it differs from that of [engine.gas]."""

    name: str = text("Name", help="Letters, digits and -.")
    speed: float = quantity(
        "Speed", "rpm", up_to=30000, symbol="n", rule_of_thumb=(300, 13000), help="Of the crank.", repair="asked"
    )
    hours: float | None = quantity(
        "Hours a day", default=None, within=(0, DAY), symbol="T", help="For the daily exposure."
    )
    peak_pressure: float | None = as_in(EngineOperation.peak_pressure, default=None)
    intake_pressure: float | None = as_in(EngineOperation.intake_pressure, default=None)
    exhaust_pressure: float | None = as_in(EngineOperation.exhaust_pressure, default=None)
    crankcase_pressure: float | None = as_in(EngineOperation.crankcase_pressure, default=None)
    constant_pressure_angle: float | None = as_in(EngineOperation.constant_pressure_angle, default=None)


# --- the step

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


def _foremost(points: Iterable[Point]) -> Point | None:
    return min(points, key=lambda point: (point.position[::-1], point.name), default=None)


@inputs
class MountingInputs:
    """Mass, inertia and mounts of the engine; below them the ground or a frame."""

    mass: float = quantity(
        "Mass",
        "kg",
        up_to=1e6,
        symbol="m",
        help="Engine with liquids, flywheel, and what is bolted to it.",
        decides=1,
    )
    centre_of_gravity: tuple[float, ...] = series(
        "Centre of gravity", "mm", count=(3, 3), within=(-10000, 10000), symbol="r_G", help=PLACE, decides=2
    )
    inertia: tuple[float, ...] | None = series(
        "Inertia",
        "kg·m²",
        default=None,
        count=(3, 3),
        up_to=1e7,
        symbol="J",
        help="[J_x, J_y, J_z] about the axes through the centre of gravity: yaw, pitch, roll.",
        decides=3,
    )
    inertia_coupling: tuple[float, ...] | None = series(
        "Coupling entries",
        "kg·m²",
        default=None,
        count=(3, 3),
        within=(-1e7, 1e7),
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
        up_to=20000,
        help="[up, side, along the crank]: for an estimate of the inertia where it is not known.",
    )
    idle_speed: float = quantity(
        "Idle speed",
        "rpm",
        up_to=30000,
        symbol="n_idle",
        rule_of_thumb=(500, 1800),
        help="At which isolation is judged.",
        repair="asked",
        decides=4,
    )
    up: tuple[float, ...] = series(
        "Direction upward",
        default=(1.0, 0.0, 0.0),
        count=(3, 3),
        within=(-1, 1),
        help="In engine axes; weight acts against it.",
    )
    forward: tuple[float, ...] = series(
        "Direction forward", default=(0.0, 0.0, 1.0), count=(3, 3), within=(-1, 1), help="In engine axes, of the seat."
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
    machine_class: int | None = integer(
        "Machine class", default=None, within=(1, 7), help="Of ISO 10816-6; left out: no verdict."
    )
    power: float | None = quantity(
        "Power",
        "kW",
        default=None,
        up_to=1e6,
        help="For the scope of the standards; left out: the rated one.",
        repair="asked",
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
        within=(-1e7, 1e7),
        symbol="T_out",
        help="Where it leaves the body; left out: the mean torque of the gas.",
    )
    output_ratio: float = quantity(
        "Ratio of the output",
        default=1.0,
        within=(-1000, 1000),
        symbol="i_out",
        help="Torque of the output over that of the crank.",
    )
    cylinder_spread: tuple[float, ...] | None = series(
        "Spread of the cylinders",
        "%",
        default=None,
        count=(1, 24),
        within=(-100, 100),
        symbol="epsilon_k",
        help="Of their gas torque: one number is a standard deviation, else one for each cylinder.",
    )
    scatter_couple: float | None = quantity(
        "Error of the shaft's couple",
        "%",
        default=None,
        within=(-100, 100),
        symbol="s",
        help="For the variant scatter; left out: from [shafts.scatter].",
    )
    late: float | None = quantity(
        "The shaft is late by",
        "°",
        default=None,
        within=(-180, 180),
        symbol="delta",
        help="For the variant scatter; left out: from the scatter of its angle and the backlash of the train.",
    )
    road_frequency: float = quantity(
        "Road frequency", "Hz", default=6.0, within=(0, 1000), symbol="f_road", help="No mode should lie below it."
    )
    rigid_up_to: float = quantity(
        "Rigid up to", "Hz", default=120.0, up_to=10000, help="Above it engine or frame bend."
    )
    seat_transmissibility: tuple[float, ...] = series(
        "Transmissibility of the seat",
        default=(1.0, 1.0, 1.0),
        count=(3, 3),
        within=(0, 10),
        help="[forward, side, up]; 1: what is felt is that of the rail.",
    )
    mounts: tuple[Mount, ...] = tables("Mounts", Mount, fold=MOUNTS)
    chassis: Chassis | None = table("Chassis", Chassis, default=None, fold=FRAME)
    points: tuple[Point, ...] = tables(
        "Points",
        Point,
        default=(),
        fold=FRAME,
        help="Where it is felt. The foremost seat, and the foremost point of the engine, stand for the others.",
    )
    operation: tuple[Operation, ...] = tables(
        "Operations",
        Operation,
        default=(),
        help="Left out: those of [[engine.operation]], without its hours, which are no hours a day; else idle and "
        "rated.",
        fold=FRAME,
    )

    @property
    def integral(self) -> bool:
        return self.inertia_sign == "integral"

    @property
    def seat(self) -> Point | None:
        """Of several seats the foremost, of two abreast that on the side below zero."""
        return _foremost(point for point in self.points if point.role == "seat")

    @property
    def engine_point(self) -> Point | None:
        """The foremost point on the engine."""
        return _foremost(point for point in self.points if point.on == "engine")

    def problems(self) -> Iterable[tuple[str, Text]]:
        if not FEWEST <= len(self.mounts) <= MOST:
            count = len(self.mounts)
            yield (
                dotted(MountingInputs.mounts),
                Text("are {count}; needs from {fewest} to {most}", count=count, fewest=FEWEST, most=MOST),
            )
        yield from self._inertia()
        yield from self._directions()
        yield from self._names()
        for i, point in enumerate(self.points):
            if point.on == "chassis" and self.chassis is None:
                yield dotted(MountingInputs.points, i, Point.on), Text("needs [mounting.chassis], on which it stands")
        hours = sum(row.hours for row in self.operation if row.hours is not None)
        if hours > DAY:
            yield dotted(MountingInputs.operation), Text("their hours are {hours} together; a day has 24", hours=hours)
        if self.output_torque is not None and self.torque_path == "inside":
            yield (
                dotted(MountingInputs.output_torque),
                Text('belongs to torque_path = "off_body"; leave it out, or the path'),
            )

    def _inertia(self) -> Iterator[tuple[str, Text]]:
        if self.inertia is not None and self.dimensions is not None:
            yield dotted(MountingInputs.dimensions), Text("excludes inertia_kgm2; leave one of the two out")
        if self.inertia is None and self.dimensions is None:
            yield dotted(MountingInputs.inertia), Text("is missing; give it, or dimensions_mm for an estimate")
        if self.inertia is None and self.inertia_coupling is not None:
            yield dotted(MountingInputs.inertia_coupling), Text("needs inertia_kgm2, whose coupling it is")
        if self.inertia is not None:
            if (reason := problem(self.inertia, self.inertia_coupling, self.integral)) is not None:
                yield dotted(MountingInputs.inertia), reason

    def _directions(self) -> Iterator[tuple[str, Text]]:
        if len(self.up) != 3 or len(self.forward) != 3:
            return
        if not any(self.up):
            yield dotted(MountingInputs.up), Text("must be a direction, like [1, 0, 0]")
            return
        (a, b, c), (d, e, f) = self.up, self.forward
        across = math.hypot(b * f - c * e, c * d - a * f, a * e - b * d)
        if across <= 1e-6 * math.hypot(*self.up) * max(math.hypot(*self.forward), 1e-12):
            yield dotted(MountingInputs.forward), Text("must be a direction that is not that of up")

    def _names(self) -> Iterator[tuple[str, Text]]:
        taken = {mount.name for mount in self.mounts}
        for i, point in enumerate(self.points):
            if point.name in taken:
                yield (
                    dotted(MountingInputs.points, i, Point.name),
                    Text("is that of a mount; every place needs a name of its own"),
                )
            taken.add(point.name)
        for i, support in enumerate(self.chassis.supports if self.chassis is not None else ()):
            if support.name in taken:
                yield (
                    dotted(MountingInputs.chassis, Chassis.supports, i, Support.name),
                    Text("is that of a mount or point; every place needs a name of its own"),
                )
            taken.add(support.name)
        for i, row in enumerate(self.operation):
            if row.name in RESERVED:
                yield (
                    dotted(MountingInputs.operation, i, Operation.name),
                    Text("stands for something else in the names of values; take another"),
                )
        for m, mode in enumerate(self.chassis.modes if self.chassis is not None else ()):
            for i, place in enumerate(mode.shape):
                if place.name and place.name not in taken:
                    yield (
                        dotted(MountingInputs.chassis, Chassis.modes, m, FrameMode.shape, i, Move.name),
                        _no_place(place.name, sorted(taken)),
                    )


def _no_place(name: str, places: list[str]) -> Text:
    return Text("is no mount, point or support") + (meant(name, places) or Text("; there are ") + ", ".join(places))


# --- what the ways of balancing an engine on its mounts, and its motions, are called

VARIANT_WORDS = {
    "bare": Text("nothing balanced"),
    "half": Text("half on the crank"),
    "shaft": Text("with the shaft"),
    "scatter": Text("with the shaft as it scatters"),
    "tooth": Text("with the shaft one tooth late"),
}
SEVERAL_WORDS = VARIANT_WORDS | {
    "shaft": Text("with the shafts"),
    "scatter": Text("with the shafts as they scatter"),
    "tooth": Text("one tooth off, the worst"),
}
DOF_WORDS = {
    "bounce": Text("bounce"),
    "lateral": Text("lateral"),
    "fore_aft": Text("fore and aft"),
    "yaw": Text("yaw"),
    "pitch": Text("pitch"),
    "roll": Text("roll"),
}
