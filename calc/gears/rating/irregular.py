# SPDX-License-Identifier: Apache-2.0
"""What the irregular motion of the crank adds to the torques of a train."""

from collections.abc import Mapping, Sequence

from ...sheet.record import record
from ...sheet.units import NewtonMetre, Number


@record
class MeshTorques:
    """What the irregular motion of the crank adds at the driver of one mesh, chain or belt, over the range of speeds
    and loads.

    `dynamic`: the largest by inertia, where the crank speeds up; `slowing`: where it slows down most, at each operating
    point, `share` of the mean torque of the balance that is there at its speed.  `at_rated`: that at rated speed and
    full load, which alone was rated with up to version 0.2."""

    dynamic: NewtonMetre
    slowing: Sequence[NewtonMetre]
    share: Sequence[Number]
    at_rated: NewtonMetre | None = None


@record
class Irregular:
    """The same of all of them; `assumed`: a default stands for the motion of the crank."""

    of: Mapping[str, MeshTorques]
    assumed: bool
