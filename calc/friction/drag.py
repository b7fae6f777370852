# SPDX-License-Identifier: Apache-2.0
"""What every wheel needs to turn over speed, its shaft with it, without what its meshes lose: the drag that holds its
flanks together.

Mesh losses are none of it: they vanish when the flanks part."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from ..sheet.arrays import Array
from ..sheet.record import record, replace
from ..sheet.units import Metre, Watt
from ..sheet.value import untraced
from .journals import OnShaft, journals_at
from .losses.wheels import unloaded
from .power_balance import TrainDrive, end_of, masses_of, shaft_loss
from .result import FrictionResult


@record
class OverSpeed:
    """What a closed balance knows of other speeds and powers."""

    balance: FrictionResult

    def sources(self, wheel: str) -> tuple[object, ...]:
        return drag_sources(self.balance, wheel)

    def drags(self, ratio: Array) -> dict[str, Array]:
        return drags(self.balance, ratio)

    def loss_on(self, key: str, P: Watt, b: Metre) -> Watt:
        """What a mesh loses of a power on a part of its face width, at the speed of the balance."""
        drive: TrainDrive = self.balance.drive
        return drive.loss_on(key, P, b)


def drags(balance: FrictionResult, ratio: Array) -> dict[str, Array]:
    """The drag torque of every wheel and sprocket in N·m at speeds that are `ratio` times that of the balance, its oil
    as warm; nan where a journal has no film in the range of its table.

    The teeth load bearings as they do in the balance, by the square of the speed.  What hangs on a shaft counts; what a
    train without shafts delivers is a constant torque."""
    d: TrainDrive = balance.drive
    on: Mapping[str, OnShaft] = balance.on
    T: Any = np.full(ratio.shape, float(d.T_oil))  # as many operating points as there are ratios
    r: Any = ratio
    with untraced(), np.errstate(all="ignore"):
        ends = {
            name: end_of(d.friction, end.wheel, on[name], journals_at(on[name], r, T)) for name, end in d.ends.items()
        }
        first = d.wheels[d.first].speed * r
        wheels = unloaded(d.friction, d.links, d.lubricant, T, first, d.last)
        at = replace(d, wheels=wheels, T_oil=T, ends=ends, masses=masses_of(d.friction, ends))
        taken = balance.meshes | balance.stages
        loads: dict[str, Watt] = {name: link.power_in * r**2 for name, link in taken.items()}
        needed: dict[str, Any] = {name: sum(wheel.parts()) + np.zeros(r.shape) for name, wheel in at.wheels.items()}
        for name, (_, loss) in at.bearings(loads).items():
            needed[name] += np.ravel(loss)
        for name, end in ends.items():
            teeth = balance.at_teeth(end.wheel)
            needed[end.wheel] += shaft_loss(end.journals, None if teeth is None else teeth * r**2, loads)
            needed[end.wheel] += np.ravel(at.masses[name].mass_loss) if name in at.masses else 0.0
        for hung in at.hung:
            needed[hung.wheel] += hung.power
        if balance.delivered_power is not None:
            needed[d.last] += balance.delivered_power * r
        return {name: P / (2 * np.pi * np.abs(at.wheels[name].speed)) for name, P in needed.items()}


def drag_sources(balance: FrictionResult, wheel: str) -> tuple[object, ...]:
    """What the drag of a wheel stands on: the bearings of its shaft and the parts of its own."""
    d: TrainDrive = balance.drive
    on: Mapping[str, OnShaft] = balance.on
    bearings = [
        bearing.friction_power
        for name, end in d.ends.items()
        if end.wheel == wheel
        for bearing in on[name].bearings.bearings.values()
    ]
    return (*bearings, *d.wheels[wheel].parts())
