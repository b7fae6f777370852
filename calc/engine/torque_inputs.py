# SPDX-License-Identifier: Apache-2.0
"""A torque over the crank angle that is given as a diagram, in place of the gas."""

from collections.abc import Iterator
from math import pi

from ..sheet.quantity import inputs, quantity
from ..sheet.text import Amount, Text

FEWEST_ROWS = 3
SAME_ANGLE = 1e-9  # rad


@inputs
class TorquePoint:
    """One row of a torque diagram."""

    angle: float = quantity("Crank angle", "°", low=-1440, high=1440, symbol="epsilon", help="After the firing of cylinder 1.")
    torque: float = quantity("Torque", "N·m", low=-1e9, high=1e9, symbol="T", help="Of the whole engine on its crank, + in its sense.")


def diagram_problems(rows: tuple[TorquePoint, ...], period: float | None, strokes: int, gas: bool) -> Iterator[tuple[str, Text]]:
    """What is wrong with a torque diagram, with keys of [engine]."""
    if not rows:
        if period is not None:
            yield "torque_period_deg", Text("belongs to a torque diagram, [[engine.torque]]; leave it out")
        return
    if gas:
        yield "torque", Text("the gas gives the torque already: leave out [[engine.torque]] or [engine.gas]")
    if len(rows) < FEWEST_ROWS:
        yield "torque", Text("has {count} rows; needs at least {fewest} over its period", count=len(rows), fewest=FEWEST_ROWS)
    length = period if period is not None else strokes * pi
    shown = Amount(length / pi * 180, form="g")
    for i, row in enumerate(rows):
        if i and row.angle <= rows[i - 1].angle:
            yield (
                f"torque.{i}.angle_deg",
                Text("must be above that of the row before; a jump takes two rows, a hundredth of a degree apart"),
            )
    if rows[-1].angle - rows[0].angle > length + SAME_ANGLE:
        yield f"torque.{len(rows) - 1}.angle_deg", Text("lies more than the period of {length}° behind the first row", length=shown)
    elif abs(rows[-1].angle - rows[0].angle - length) <= SAME_ANGLE and rows[-1].torque != rows[0].torque:
        yield (
            f"torque.{len(rows) - 1}.torque_Nm",
            Text("must be that of the first row, {length}° before it: the diagram closes", length=shown),
        )
