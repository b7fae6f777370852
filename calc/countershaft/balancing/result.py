# SPDX-License-Identifier: Apache-2.0
"""What the balancing sheet has of a shaft, plane by plane, ring by ring, hole by hole, reading by reading."""

from typing import Literal

from ...sheet.quantity import Stated, group, result, value
from ...sheet.record import record
from ...sheet.shown import Shown
from ...sheet.text import Text
from ...sheet.units import KilogramMetre, KilogramPerMetre3, Metre, Newton, Number, Radian
from .inputs import Balancing

PLANES, RINGS = (Text("front plane"), Text("rear plane")), (Text("front ring"), Text("rear ring"))
Told = Literal["pass", "fail", "between"]  # of a plane: the machine's error leaves no answer between


@result
class BalancingPlane(Shown):
    """What the shaft has to have in a plane; the direction of no more than rounding is none."""

    target: KilogramMetre = value("Target unbalance in the plane", "g·mm", "U", short=True)
    target_angle: Radian | None = value(
        "its angle in the engine, cylinder 1 at TDC", "°", "φ_U", default=None, short=True
    )
    shop_angle: Radian | None = value("its angle as the shop counts", "°", "α", default=None, short=True)
    machine_force: Newton = value("Force on the pedestal of the machine, without compensation", "N", "F_b")
    vector: complex  # the target [kg·m]
    z: Metre
    permitted: KilogramMetre | None  # None: the mass of the shaft is not known
    error: KilogramMetre  # of machine and ring together
    ring_error: KilogramMetre


@result
class BalancingRing(Shown):
    """A ring that takes the target off while the shaft is balanced."""

    unbalance: KilogramMetre = value("Unbalance of the compensating ring", "g·mm", "U_R")
    angle: Radian | None = value("its angle in the engine, cylinder 1 at TDC", "°", "φ_R", default=None)
    shop_angle: Radian | None = value("its angle as the shop counts", "°", "α_R", default=None)
    vector: complex
    z: Metre


@record
class Drill:
    """A hole as it may be drilled: from radius R inwards, in a piece from `start` to `end` whose core has the radius
    `core` and whose sector stands at `middle` ± `half` (None: a full cylinder).  `outside`: why it would be in the air,
    where it would be."""

    name: str
    z: Metre
    angle: Radian
    diameter: Metre
    depth: Metre
    point: Radian
    R: Metre
    core: Metre
    start: Metre
    end: Metre
    middle: Radian
    half: Radian | None
    density: KilogramPerMetre3
    outside: Text | None = None


@result
class HoleTakes(Shown):
    """What one hole can take at its greatest depth."""

    most: KilogramMetre = value("Unbalance that the hole takes at its greatest depth", "g·mm", "u_max")
    drill: Drill
    cone: Metre
    least_depth: Metre
    shares: tuple[Number, Number]  # of what it takes, in the front and in the rear plane
    depths: tuple[Metre, ...]  # for 10, 20 … 100 % of the most; below the least depth the drill is not wholly in


@result
class ReadingResult(Shown):
    """What a reading asks to be drilled, and what is left then."""

    front: KilogramMetre = value("Unbalance left in the front plane", "g·mm", "U_left,f", short=True)
    rear: KilogramMetre = value("Unbalance left in the rear plane", "g·mm", "U_left,r", short=True)
    hole: dict[str, Stated] = group(words="hole")  # depths
    before: tuple[complex, complex]  # what is too much, as read, in front and rear plane [kg·m]
    left: tuple[complex, complex]
    unreached: tuple[complex, complex]  # what no hole reaches, however deep
    amounts: dict[str, KilogramMetre]
    as_read: tuple[Told, Told] | None  # None: nothing is known to be permitted
    told: tuple[Told, Told] | None


@result
class BalancingResult(Shown):
    """The sheet of a shaft; what its parts are called is said where the shaft's result has it."""

    front: BalancingPlane = group()
    rear: BalancingPlane = group()
    ring_front: BalancingRing = group()
    ring_rear: BalancingRing = group()
    hole: dict[str, HoleTakes] = group()
    reading: dict[str, ReadingResult] = group()
    outside: tuple[Drill, ...]  # holes that are asked for and would be in the air: they take nothing
    inputs: Balancing
    zero: Radian  # from which the shop counts, in the engine
    sense: Number  # 1 where it counts in the sense of crank rotation, −1 against it
    zero_words: Text

    @property
    def planes(self) -> tuple[BalancingPlane, BalancingPlane]:
        return self.front, self.rear

    @property
    def rings(self) -> tuple[BalancingRing, BalancingRing]:
        return self.ring_front, self.ring_rear
