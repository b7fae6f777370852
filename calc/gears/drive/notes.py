# SPDX-License-Identifier: Apache-2.0
"""What the drive over speed rests on, in words: what is not known of the engine, and how good its forces are."""

from collections.abc import Iterator

import numpy as np

from ...sheet.text import COMMA, Amount, Text
from ..inputs import GearsInputs
from ..result import TrainResult
from . import orders
from .curves import load_words
from .result import HARDEST, IDLE, DriveResult

MOVED = 0.005  # share of a torque by which it is said to have moved
PEAK_SEEN = 0.02  # share of the force by which a strike between the judged speeds is said to be harder
REFLECTED = 0.3  # of the inertia on the crank: a train with more of it acts back
ACCURACY = Text(
    "Forces of strikes are some low to some high, never one number: held against a chain of elastic teeth, 240 random "
    "trains with three dampings, the low one fits a train whose shaft is heavy and last, and is no lower bound; the "
    "high one is passed in 12 % of the meshes, then by 13 % in the median. No measurement of such a train is public."
)


def notes(gears: GearsInputs, train: TrainResult, drive: DriveResult) -> Iterator[Text]:
    source, work = drive.drive.source, drive.drive.work
    yield ACCURACY
    yield from _between_judged(drive)
    if drive.assumed:
        yield Text(
            "How the crank turns is not known: {taken}. Give the gas and the inertia of the flywheel.",
            taken=drive.drive.taken,
        )
    elif higher := list(_higher(train, drive)):
        # for one version, in which these numbers have moved
        yield Text(
            "The dynamic torque is the largest over speeds and loads; up to version 0.2 it was that at rated speed: "
            "{meshes}.",
            meshes=COMMA.join(higher),
        )
    if not drive.drive.drag_known:
        yield Text("No drag is known: the flanks are held by nothing, and the ratio of inertia to drag has no value.")
    elif gears.power is not None and work.shafts:
        yield Text(
            "The power of the train holds no flanks together here, since what takes it is not known: a pump belongs "
            "to the loads of its shaft."
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
                "add; give the twist of the crank."
            )
    if IDLE not in drive.at:
        yield Text(
            "Idle without load is not known, so that nothing is graded, and no scissor gear judged: give an "
            "operation of the engine without load."
        )
    influences = {
        key: K
        for key, mesh in train.meshes.items()
        if mesh.rating is not None and (K := mesh.rating.influence) is not None
    }
    found = {key: mesh.over_speed for key, mesh in train.meshes.items() if mesh.over_speed is not None}
    yield from orders.notes(gears, train, found, influences)
    springs = [mesh.over_speed.scissor for mesh in train.meshes.values() if mesh.over_speed is not None]
    if lost := [spring.loss for spring in springs if spring is not None and spring.loss is not None]:
        yield Text(
            "The springs of scissor gears cost up to {loss} in their meshes at rated speed, which is not in the sum of "
            "the losses of the step Friction.",
            loss=Amount(sum(map(float, lost)), "W", digits=2),
        )
    yield Text(
        "Strikes are without rebound, at steady speed, of rigid bodies; oil squeezed between flanks would take speed "
        "off light wheels."
    )


def _between_judged(drive: DriveResult) -> Iterator[Text]:
    """How much harder the strikes are at a speed of the map than at those that are judged; S_H falls with the root of
    the force, S_F with the force."""
    judged = float(drive.survey.impacts.high[drive.at[HARDEST]].max(initial=0.0))
    map_ = drive.drive.drawn()
    forces = map_.impacts.high.max(axis=1, initial=0.0)
    p = int(np.argmax(forces))
    if not judged or (more := float(forces[p]) / judged) < 1 + PEAK_SEEN:
        return
    yield Text(
        "The teeth are judged under the strikes of {count} speeds from idle to rated speed; between these some are "
        "harder: {u} and {F} by the high estimate at {n}, {load}. That is {more} more force, and a safety under "
        "strikes up to {contact} lower against pitting, up to {bending} against tooth breakage.",
        count=drive.survey.each_speed.size,
        u=Amount(float(map_.impacts.speed[p].max()) * 1e3, "mm/s", form=".0f"),
        F=Amount(float(forces[p]), "N", form=".0f"),
        n=Amount(float(map_.speeds[p]) * 60, "rpm", form=".0f"),
        load=load_words(drive.drive.source, float(map_.loads[p])),
        more=Amount(100 * (more - 1), "%", form=".0f"),
        contact=Amount(100 * (1 - more**-0.5), "%", form=".0f"),
        bending=Amount(100 * (1 - 1 / more), "%", form=".0f"),
    )


def _higher(train: TrainResult, drive: DriveResult) -> Iterator[Text]:
    """The meshes whose dynamic torque is higher over the range than at rated speed, with both."""
    for key, of in drive.torques.of.items():
        if of.at_rated is not None and of.dynamic > (1 + MOVED) * of.at_rated:
            yield Text(
                "{pair} {now}, not {before}",
                pair=train.tree.by_key[key].title,
                now=Amount(of.dynamic, "N·m", form=".3g"),
                before=Amount(of.at_rated, "N·m", form=".3g"),
            )
