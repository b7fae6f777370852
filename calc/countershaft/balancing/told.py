# SPDX-License-Identifier: Apache-2.0
"""The balancing sheet as a part of the shaft's step: its notes and tables."""

from collections.abc import Iterable, Iterator

from ...sheet.step import Table
from ...sheet.text import COMMA, Name, Text
from ...sheet.units import UNITS
from ..inputs import EccentricMass, ShaftInputs
from .checks import outside_words
from .inputs import Balancing
from .result import BalancingResult
from .solve import STEPS

mm, gmm = UNITS["mm"].shown, UNITS["g·mm"].shown


def no_zero(table: Balancing, masses: Iterable[EccentricMass]) -> Text:
    """Why there is no sheet: of a shaft that is sized the masses are found."""
    names = COMMA.join(Name(mass.name) for mass in masses)
    return Text(
        "No balancing sheet: it counts from {zero}, which is no mass; they are {names}.",
        zero=Name(table.zero),
        names=names,
    )


def notes(shaft: ShaftInputs, found: BalancingResult) -> Iterator[Text]:
    yield Text(
        "A balance shaft is out of balance on purpose: the machine has to find the target, and the permitted unbalance "
        "is the circle around it. Both turn with the shaft."
    )
    if found.reading and found.front.permitted is None:
        yield Text("Readings are not judged: what is permitted needs the mass of the whole shaft.")
    asked = len(found.inputs.holes)
    there = len(found.hole) + len(found.outside)
    if there < asked or (not there and shaft.holes is not None):
        yield Text(
            "Holes to drill: left out where the radius is not known from which they go: give radius_mm, or the outline "
            "of the shaft."
        )
    for drill in found.outside:
        yield Text("{hole}: it is not drilled.", hole=outside_words(drill))


def tables(found: BalancingResult) -> Iterator[Table]:
    """How deep each hole goes for its share of what it can take."""
    if not found.hole:
        return
    shares = [n / STEPS for n in range(1, STEPS + 1)]
    columns = ((Text("hole"), ""), (Text("most"), "g·mm"), *((Text("{n} %", n=round(100 * x)), "mm") for x in shares))
    rows = tuple(
        (Name(name), gmm(hole.most), *(mm(h) if h >= hole.least_depth else None for h in hole.depths))
        for name, hole in found.hole.items()
    )
    note = Text(
        "Depth of the full diameter for each share of the most. Empty: shallower than the drill's own curve, where the "
        "drill is not wholly in; drill so little in steps, and measure again."
    )
    yield Table("hole_depths", Text("Depths of the holes"), columns, rows, note)
