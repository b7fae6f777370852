# SPDX-License-Identifier: Apache-2.0
"""What is assumed where the play of a train does not follow from what is given."""

from collections.abc import Sequence

from ...sheet.text import Text
from ..inputs import GearsInputs
from .case import BacklashCase
from .chance import BY_CHANCE
from .temperature import Expansions


def notes(gears: GearsInputs, known: Sequence[tuple[BacklashCase, Expansions]], housing: str | None, chance: bool) -> tuple[Text, ...]:
    notes = []
    if housing is None:
        notes.append(Text("Housing material: not given; chosen: it grows as the driver of each mesh."))
    elif gears.housing_material is None:
        notes.append(Text(
            "Housing material: not given; chosen: {housing}, that of the bearings. The cold and warm backlash is then not verified.",
            housing=housing,
        ))  # fmt: skip
    if gears.support_material is not None and not any(m.inputs.support_share for m, _ in known):
        notes.append(Text("gears.support_material acts on no mesh: none has a support_share."))
    if chance:
        notes.append(Text(
            "Backlash by chance: {by_chance}, always the same ones, at 20 °C; allowances, bare tolerances and fields without a kind even "
            "between their limits, a position even in its circle, a fit on the wall of its clearance and a runout in any direction; all "
            "independent.",
            by_chance=BY_CHANCE,
        ))  # fmt: skip
    if any(m.runouts is None for m, _ in known):
        tight = ", ".join(m.name for m, _ in known if m.runouts is None)
        notes.append(
            Text("Runout of the teeth: not given for {tight}: left out of their backlash (gears.wheels.NAME.runout_um).", tight=tight)
        )
    return tuple(notes)
