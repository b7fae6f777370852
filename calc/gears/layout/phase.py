# SPDX-License-Identifier: Apache-2.0
"""Which teeth meet: hunting, the angle of every wheel's teeth with cylinder 1 at TDC, and the marks by which a train is
assembled.

In the middle of the face width.  Teeth are numbered in the sense of crank rotation, from tooth 1: of the first driver
that of gears.tooth_angle_deg, of the wheel on a shaft the one nearest the eccentric, of the others the one nearest to
up."""

import math
from collections.abc import Mapping
from typing import NamedTuple

from ...sheet.text import Text
from ...sheet.units import Number, Radian
from ...sheet.value import about
from ..result import MeshResult, TrainResult
from . import formulas as f

TURN = 2 * math.pi


class Mark(NamedTuple):
    """One mesh with cylinder 1 at TDC: a tooth of the driver between two teeth of the driven wheel."""

    driver: str
    driven: str
    tooth: int
    off: Radian  # of that tooth from the line of centres
    between: tuple[int, int]


class Phase(NamedTuple):
    teeth: dict[str, Radian]  # the middle of tooth 1
    marks: list[Mark]
    offsets: dict[str, Radian]  # from the eccentric of a shaft to tooth 1 of the wheel on it


def hunting(train: TrainResult, mesh: MeshResult) -> tuple[Number, Number]:
    """(common factor of the teeth, turns of the driver until the same teeth meet) of one mesh."""
    z_1, z_2 = train.wheels[mesh.driver].teeth, train.wheels[mesh.driven].teeth
    with about(Text("mesh {pair}, teeth that meet", pair=mesh.title)):
        factor = f.common_factor(z_1=z_1, z_2=z_2)
        return factor, f.turns_to_repeat(z_2=z_2, g_z=factor)


def phase(
    train: TrainResult,
    directions: Mapping[str, Radian],
    known: Mapping[str, Radian],
    eccentrics: Mapping[str, Radian],
) -> Phase:
    """Along the meshes whose line of centres is known; `directions` of those, by mesh.  `known`: of a tooth of the
    wheels from which it begins; behind a chain or a belt none is.  `eccentrics`: directions of the shafts' masses, by
    the wheel on each shaft."""
    offsets: dict[str, Radian] = {}
    teeth, marks = dict(known), []
    for link in train.tree.links:
        if link.driver not in teeth or link.key not in directions:
            continue
        mesh, gamma, z_1, z_2 = train.meshes[link.key], directions[link.key], link.z_1, link.z_2
        with about(Text("wheel {driven}, teeth", driven=mesh.driven)):
            theta = f.meshing_tooth(theta_1=teeth[mesh.driver], gamma=gamma, z_1=z_1, z_2=z_2)
            psi = eccentrics.get(mesh.driven, 0.0)
            delta = f.nearest_tooth(theta=theta, psi=psi, tau=f.angular_pitch(z=z_2))
            teeth[mesh.driven] = f.tooth_one(psi=psi, delta=delta)
        if mesh.driven in eccentrics:
            offsets[mesh.driven] = delta
        marks.append(_mark(mesh, teeth, gamma, z_1, z_2))
    return Phase(teeth, marks, offsets)


def _mark(mesh: MeshResult, teeth: Mapping[str, Radian], gamma: Radian, z_1: int, z_2: int) -> Mark:
    pitch_1, pitch_2 = TURN / z_1, TURN / z_2
    ahead = round((gamma - teeth[mesh.driver]) / pitch_1)
    off = teeth[mesh.driver] + ahead * pitch_1 - gamma
    space = gamma + math.pi - off * z_1 / z_2  # its middle takes that tooth
    before = round((space - pitch_2 / 2 - teeth[mesh.driven]) / pitch_2)
    return Mark(mesh.driver, mesh.driven, ahead % z_1 + 1, off, (before % z_2 + 1, (before + 1) % z_2 + 1))
