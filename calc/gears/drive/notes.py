# SPDX-License-Identifier: Apache-2.0
"""What the drive over speed rests on, in words: what is not known of the engine, and how good its forces are."""

from collections.abc import Iterator

from ...sheet.text import Amount, Text
from ..inputs import GearsInputs
from ..result import TrainResult
from . import orders
from .result import IDLE, DriveResult

REFLECTED = 0.3  # of the inertia on the crank: a train with more of it acts back
ACCURACY = Text(
    "Forces of strikes are some low to some high, never one number: held against a chain of elastic teeth, 240 random "
    "trains with three dampings, the low one fits a train whose shaft is heavy and last, and is no lower bound; the "
    "high one is passed in 12 % of the meshes, then by 13 % in the median. No measurement of such a train is public."
)


def notes(gears: GearsInputs, train: TrainResult, drive: DriveResult) -> Iterator[Text]:
    source, work = drive.drive.source, drive.drive.work
    yield ACCURACY
    if drive.assumed:
        yield Text(
            "How the crank turns is not known: {taken}. Give [engine.gas] and engine.flywheel_inertia_kgm2.",
            taken=drive.drive.taken,
        )
    if not drive.drive.drag_known:
        yield Text("No drag is known: the flanks are held by nothing, and the ratio of inertia to drag has no value.")
    elif gears.power is not None and work.shafts:
        yield Text(
            "gears.power_kW holds no flanks together here, since what takes it is not known: a pump belongs into "
            "[[shafts.loads]], of its shaft."
        )
    if source.J_E is not None:
        yield Text(
            "Beside flywheel and train nothing counts on the crank: its own inertia, gear and pulley are not known."
        )
        of_train = float(source.J_E) - float(work.engine.flywheel_inertia or 0.0)
        if of_train > REFLECTED * float(source.J_E):
            yield Text(
                "The train has {share} of the inertia on the crank: taken as given, its motion is too even.",
                share=Amount(100 * of_train / float(source.J_E), "%", form=".0f"),
            )
        if source.nose and work.engine.crank_twist is None:
            yield Text(
                "The train is driven from the nose of the crank, which is taken as rigid: torsional vibration would "
                "add; give [engine.crank_twist]."
            )
    if IDLE not in drive.at:
        yield Text(
            "Idle without load is not known, so that nothing is graded: give an [[engine.operation]] row of load 0."
        )
    influences = {
        key: K
        for key, mesh in train.meshes.items()
        if mesh.rating is not None and (K := mesh.rating.influence) is not None
    }
    found = {
        key: orders.MeshOrder(order=over.order, error_by_load=over.error_by_load if key in influences else None)
        for key, mesh in train.meshes.items()
        if (over := mesh.over_speed) is not None
    }
    yield from orders.notes(gears, train, found, influences)
    yield Text(
        "Strikes are without rebound, at steady speed, of rigid bodies; oil squeezed between flanks would take speed "
        "off light wheels."
    )
