# SPDX-License-Identifier: Apache-2.0
"""What the teeth do to their wheels: the mean force at the pitch point, and the orders that the crank's motion adds.

Thrust is + along the axis of the crank's rotation, as `gears.W.thrust`."""

from collections.abc import Iterator, Sequence
from math import cos, tan

import numpy as np

from ..gears.drive.result import DriveResult
from ..gears.drive.strikes import closed
from ..gears.layout.formulas import force_on_driven, force_on_driver, thrust_on_driven, thrust_on_driver
from ..gears.result import MeshResult, TrainResult
from ..sheet.arrays import BoolArray, ComplexArray
from ..sheet.record import record
from ..sheet.text import COMMA, Name, Text
from ..sheet.units import Metre, Newton, Number, PhasorMetre, PhasorNewton, Radian, RevPerSecond
from .load_rows import Book, LoadRow
from .places import HANDS

HIGHEST = 8.0  # order, as of the engine


@record
class MeshForce:
    """What a mesh does to its driver, at its pitch point `at`; the driven wheel has the opposite."""

    mesh: MeshResult
    at: PhasorMetre
    gamma: Radian
    turn: Number  # of the driver, 1 as the crank
    hand: Number  # of the driver, 1 right, -1 left, 0 spur
    across: PhasorNewton
    thrust: Newton

    def of(self, F_bt: complex) -> tuple[complex, complex, complex]:
        """Up, side, thrust on the driver of another force along the transverse line of action, or of its phasor."""
        alpha, beta = self.mesh.working_pressure_angle, self.mesh.working_helix_angle
        across, thrust = on_driver(1.0, tan(alpha), tan(beta), self.gamma, self.turn, self.hand)
        F_t = F_bt * cos(alpha)
        return F_t * across.real, F_t * across.imag, F_t * thrust


def on_driver(
    F_t: Newton, F_r: Newton, F_a: Newton, gamma: Radian, turn: Number, hand: Number
) -> tuple[PhasorNewton, Newton]:
    """The force of the driven wheel on the driver, across its axis and along it.

    `gamma`: from the driver's axis to the driven wheel's; `turn`: 1 where the driver turns as the crank, else -1;
    `hand` of the driver: 1 right, -1 left, 0 spur.

    >>> on_driver(30.0169, 11.7759, 12.0764, 2.6179939, 1.0, 1.0)
    ((25.2...+20.1...j), 12.0764)
    """
    across = force_on_driver(F_2=force_on_driven(F_rw=F_r, F_tw=F_t, gamma=gamma, s=turn))
    return complex(across), float(thrust_on_driver(F_x2=thrust_on_driven(F_a=F_a, s=turn, h=hand)))


def meshes(train: TrainResult, hands: dict[str, str]) -> dict[str, MeshForce | None]:
    """Of every mesh whose forces are known; None where the line of centres is not."""
    if train.forces is None:
        return {}
    layout, found = train.layout, dict[str, MeshForce | None]()
    for key, forces in train.forces.meshes.items():
        mesh = train.meshes[key]
        gamma = layout.meshes[key].line_of_centres if layout is not None else None
        position = layout.wheels[mesh.driver].position if layout is not None else None
        if gamma is None or position is None:
            found[key] = None
            continue
        turn = float(train.tree.senses[mesh.driver])
        hand = HANDS[hands.get(mesh.driver, "")]
        F_t, F_r, F_a = forces.working_tangential_force, forces.working_radial_force, forces.axial_force or 0.0
        across, thrust = on_driver(float(F_t), float(F_r), float(F_a), float(gamma), turn, hand)
        at = complex(position) + mesh.working_diameter_driver / 2 * np.exp(1j * float(gamma))
        found[key] = MeshForce(mesh, complex(at), float(gamma), turn, hand, across, thrust)
    return found


@record
class MeshOrders:
    """Of every mesh, by the order on the crank, the phasor of the force along the transverse line of action at some
    speeds and full load while its flanks stay closed, + on the driving flank; `part`: where they do not."""

    forces: dict[str, dict[float, ComplexArray]]
    part: dict[str, BoolArray]

    def at(self, key: str, n: int) -> dict[float, complex]:
        """Of one mesh at one of the speeds; empty where its flanks part."""
        if key not in self.forces or self.part[key][n]:
            return {}
        return {order: complex(F[n]) for order, F in self.forces[key].items()}


def mesh_orders(drive: DriveResult, speeds: Sequence[RevPerSecond]) -> MeshOrders:
    """F = M·x'' + D, less what gravity turns the bodies by: exact for closed flanks, and linear in the motion."""
    by, at, load = drive.drive, np.array(speeds), np.full(len(speeds), max(drive.drive.source.loads))
    motion, bodies = by.source.moved(at, load), by.line.bodies(by.drags.at(at), "nominal")
    of = closed(motion, bodies)
    forces: dict[str, dict[float, ComplexArray]] = {}
    for b, link in enumerate(by.line.links):
        if not link.toothed:
            continue
        by_order: dict[float, ComplexArray] = {
            order: of.mass[b] * bodies.ratio[b] * a for order, a in zip(motion.orders.tolist(), motion.a.T)
        }
        if bodies.gravity is not None and bodies.gravity_order is not None:
            for d, order in enumerate(bodies.gravity_order.tolist()):
                if order > 0:
                    of_gravity = -bodies.lever[b, d] * bodies.gravity[:, d]
                    by_order[order] = by_order.get(order, 0.0) + of_gravity
        forces[link.key] = {n: by_order[n] for n in sorted(by_order) if n <= HIGHEST and np.any(by_order[n])}
    return MeshOrders(forces, {link.key: of.parts[:, b] for b, link in enumerate(by.line.links) if link.toothed})


def orders_of(book: Book, train: TrainResult, speeds: Sequence[RevPerSecond]) -> MeshOrders | None:
    """The same of a train over speed, with what is not in them; None where the drive or all places are not known."""
    placed = (
        {key for key, mesh in train.layout.meshes.items() if mesh.line_of_centres is not None} if train.layout else ()
    )
    if train.drive is None or not placed:
        return None
    found = mesh_orders(train.drive, speeds)
    if train.drive.assumed:
        book.notes["motion"] = Text("the orders of the rows mesh: how unevenly the crank turns is assumed")
    for key, part in found.part.items():
        if key in placed and part.any():
            book.left_out[f"parts {key}"] = Text(
                "the orders of the mesh {mesh} where its flanks part and strike, which no order describes: at {speeds} "
                "rpm",
                mesh=Name(train.meshes[key].title),
                speeds=COMMA.join(Name(f"{speed * 60:g}") for speed, here in zip(speeds, part) if here),
            )
    return found


def mesh_rows(
    book: Book, key: str, force: MeshForce, z: Metre, speed: RevPerSecond, orders: dict[float, complex]
) -> Iterator[LoadRow]:
    """On the driver and on the driven wheel: what is transmitted, and `orders` along the line of action."""
    mesh, turn = force.mesh, book.frame.turn
    at = book.frame.place(force.at.real, force.at.imag, z)
    every: dict[float, tuple[complex, complex, complex]] = {0.0: (force.across.real, force.across.imag, force.thrust)}
    every |= {order: force.of(F_bt) for order, F_bt in orders.items() if F_bt}
    for order, (up, side, thrust) in every.items():
        for wheel, sign in ((mesh.driver, 1.0), (mesh.driven, -1.0)):
            vector = book.frame.vector(sign * up, sign * side, sign * thrust * turn)
            yield LoadRow(speed, "mesh", key, f"wheel {wheel}", order, at, vector)
