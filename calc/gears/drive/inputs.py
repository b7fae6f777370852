# SPDX-License-Identifier: Apache-2.0
"""What the drive over speed may be told beside the engine's gas and flywheel: at which end of the crank it hangs, and
what was measured."""

from collections.abc import Iterable

from ...sheet.quantity import choice, dotted, inputs, quantity, tables, text
from ...sheet.text import Amount, Text


@inputs
class IrregularityRow:
    """How unevenly the crank turns at one speed, as measured or as another program gives it."""

    speed: float = quantity("Speed", "rpm", up_to=1e5, symbol="n", help="Of the crank.", repair="asked")
    delta: float = quantity(
        "Irregularity",
        within=(0, 0.5),
        symbol="delta_s",
        rule_of_thumb=(0.005, 0.1),
        help="Largest less smallest speed over the mean.",
        repair="asked",
    )
    order: float | None = quantity(
        "Order",
        default=None,
        within=(0.5, 12),
        symbol="i",
        help="How often a turn of the crank it swings. Left out: the firing order of the engine.",
    )


@inputs
class DragRow:
    """What one wheel with its shaft needs to turn at one speed, measured without its mesh."""

    wheel: str = text("Wheel", help="One of gears.wheels, or a sprocket.")
    speed: float = quantity("Speed", "rpm", up_to=1e5, symbol="n", help="Of the crank.", repair="asked")
    torque: float = quantity(
        "Drag", "N·m", within=(0, 1e4), symbol="T_d", help="On the axis of that wheel.", repair="asked"
    )


@inputs
class DriveInputs:
    """How the first driver moves, and what resists behind it, where that is known better than the program has it."""

    driven_from: str | None = choice(
        "End of the crank that drives",
        "flywheel",
        "nose",
        default=None,
        help="Left out: where the wheel of the shaft stands, else the flywheel. It matters with [engine.crank_twist].",
    )
    irregularity: tuple[IrregularityRow, ...] = tables(
        "Irregularity of the crank",
        IrregularityRow,
        default=(),
        help="In place of that by gas and flywheel; acceleration is linear between the rows, constant outside.",
    )
    drag: tuple[DragRow, ...] = tables(
        "Drag of the wheels",
        DragRow,
        default=(),
        help="In place of that of the friction step, for the wheels that are named.",
    )

    def problems(self) -> Iterable[tuple[str, Text]]:
        for i, row in enumerate(self.irregularity):
            if any(row.speed == other.speed for other in self.irregularity[:i]):
                twice = Text("{n} rpm has a row already", n=Amount(row.speed * 60, form="g"))
                yield dotted(DriveInputs.irregularity, i, IrregularityRow.speed), twice
        for i, of in enumerate(self.drag):
            if any((of.wheel, of.speed) == (other.wheel, other.speed) for other in self.drag[:i]):
                twice = Text("{n} rpm has a row already of {wheel}", n=Amount(of.speed * 60, form="g"), wheel=of.wheel)
                yield dotted(DriveInputs.drag, i, DragRow.speed), twice
