# SPDX-License-Identifier: Apache-2.0
"""The counter-rotating shaft: its eccentric masses and its supports."""

from collections.abc import Iterable

from ..sheet.quantity import choice, inputs, quantity, series, tables, text


@inputs
class EccentricMass:
    """One eccentric mass of the shaft."""

    name: str = text("Name")
    mass: float = quantity("Mass", "kg", low=0, high=1000, symbol="m")
    radius: float = quantity("Radius of its centre of gravity", "mm", low=0, high=1000, symbol="e")
    angle: float = quantity(
        "Angle", "°", low=-720, high=720, symbol="gamma", step=1, help="With cylinder 1 at TDC, from up, in the sense of crank rotation."
    )
    z: float = quantity("Position", "mm", low=-5000, high=5000, symbol="z", help="From mid-shaft, + towards the flywheel.")


@inputs
class CountershaftInputs:
    """The shaft: its masses and where it is carried."""

    mode: str = choice("Mode", "given", default="given", help="given: the eccentric masses below are checked.")
    material: str = text("Material", help="A name from the table of materials or from [[material]].")
    speed_ratio: float = quantity(
        "Speed ratio to the crank", default=-1.0, low=-1, high=-1, symbol="i", help="−1: crank speed, opposite sense."
    )
    bearing_positions: tuple[float, ...] = series(
        "Bearing positions",
        "mm",
        count=(2, 2),
        low=-5000,
        high=5000,
        symbol="z",
        help="Middle of the front and of the rear journal, from mid-shaft.",
    )
    axis: tuple[float, ...] | None = series(
        "Axis from the crank's", "mm", optional=True, count=(2, 2), low=-5000, high=5000, symbol="p_S",
        help="[up, side], side 90° further in the sense of crank rotation. Beside the crank a force of the shaft raises a roll torque.",
    )  # fmt: skip
    masses: tuple[EccentricMass, ...] = tables("Eccentric masses", EccentricMass)

    def problems(self) -> Iterable[tuple[str, str]]:
        if len(self.bearing_positions) == 2 and self.bearing_positions[0] >= self.bearing_positions[1]:
            yield "bearing_positions_mm", "the rear bearing must lie behind the front one: [z_front, z_rear] with z_front < z_rear"
        if not self.masses:
            yield "masses", "needs at least one [[countershaft.masses]]"
