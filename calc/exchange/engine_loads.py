# SPDX-License-Identifier: Apache-2.0
"""What the engine without its balance shafts does to its block, and what its mounts pass on, order by order."""

from collections.abc import Iterator, Sequence

import numpy as np

from ..design.model import Design
from ..design.operations import idle_speed
from ..engine.result import EngineResult
from ..imbalance.result import ImbalanceResult
from ..mounting.inputs import MountingInputs
from ..mounting.levels import levels
from ..mounting.result import MountingResult
from ..mounting.wrenches import TOOTH, EngineWrenches, ShaftOnEngine, drive
from ..sheet.record import replace
from ..sheet.text import Text
from ..sheet.units import RevPerSecond
from .load_rows import Book, LoadRow

HALF = "half"
AT_ORIGIN = 0.0, 0.0, 0.0


def about_origin(
    design: Design, e: EngineResult, imbalance: ImbalanceResult, shafts: tuple[ShaftOnEngine, ...]
) -> EngineWrenches:
    """The wrenches of every variant about the origin, as the mounting step has them about the centre of gravity."""
    engine, mounting = design.engine, design.mounting
    assert engine is not None
    if mounting is None:
        idle = idle_speed(engine, None)
        mounting = MountingInputs(mass=1.0, centre_of_gravity=AT_ORIGIN, idle_speed=idle, mounts=())
    return drive(replace(mounting, centre_of_gravity=AT_ORIGIN), engine, e, imbalance, shafts)


def variant_of(driven: EngineWrenches, asked: str) -> str | None:
    """The variant by its own name: of several shafts one tooth off the case with the largest moments and forces at the
    orders of the shafts, a force at a metre's arm; None where the design has no such variant."""
    if asked != TOOTH or not driven.off:
        return asked if asked in driven.variants else None
    at_orders = np.asarray(driven.inertia)[:, list(driven.apart)]
    return max(driven.off, key=lambda name: float(np.linalg.norm(at_orders[driven.variants.index(name)])))


def engine_rows(book: Book, driven: EngineWrenches, speeds: Sequence[RevPerSecond]) -> Iterator[LoadRow]:
    """Of masses and gas about the origin, half of the reciprocating masses on the crank."""
    at = np.array(speeds)
    wrench = np.asarray(driven.wrench(at, driven.torque(at)))[:, :, driven.variants.index(HALF)]
    if driven.nodes is None:
        book.left_out["gas"] = Text("the gas: [engine.gas] is not given, so that the rows engine are of masses alone")
    for speed, of_speed in zip(speeds, wrench.tolist()):
        for order, six in zip(driven.orders.tolist(), of_speed):
            if any(six):
                force, moment = book.frame.vector(*six[:3]), book.frame.moment(*six[3:])
                yield LoadRow(speed, "engine", "origin", "block", order, AT_ORIGIN, force, moment)


def mount_rows(book: Book, result: MountingResult, variant: str, speeds: Sequence[RevPerSecond]) -> Iterator[LoadRow]:
    """What each mount does to what it stands on."""
    driven, mounting, at = result.drive, result.system.mounting, np.array(speeds)
    of, v = levels(result.system, driven, at, driven.torque(at)), driven.variants.index(variant)
    force, (F, M) = of.force[:, v], (part[:, v] for part in of.passed_on)
    centre = book.frame.place(*map(float, mounting.centre_of_gravity))
    places = [(mount.name, book.frame.place(*map(float, mount.position))) for mount in mounting.mounts]
    for n, speed in enumerate(speeds):
        for i, order in enumerate(driven.orders.tolist()):
            rows = [
                LoadRow(speed, "mount", name, "chassis", order, place, book.frame.vector(*force[n, j, :, i].tolist()))
                for j, (name, place) in enumerate(places)
                if force[n, j, :, i].any()
            ]
            passed_on = book.frame.vector(*F[n, i].tolist()), book.frame.moment(*M[n, i].tolist())
            book.closed(
                "mounts: what the mounting step passes on",
                rows,
                [LoadRow(speed, "", "", "", order, centre, *passed_on)],
            )
            yield from rows
