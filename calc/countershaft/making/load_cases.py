# SPDX-License-Identifier: Apache-2.0
"""The loads of the support for finite elements, as Finotti 2013, 4.7 (in chapter 6), takes them: four instants of a turn, bolts tight.

The stresses that they give come back as `bolt_stress` and `load_stress` of the support; its bolts are judged for every direction.
"""

import cmath
import math

from ...sheet.step import Table
from ...sheet.text import EMPTY, Amount, Text
from .. import formulas as f
from ..inputs import CountershaftInputs
from ..result import CountershaftResult

CASES = 4  # a quarter of a turn apart


def table(shaft: CountershaftInputs, result: CountershaftResult) -> list[Table]:
    """Forces of the shaft on both its bearings, the front one's upwards first; none where they have more supports or carry nothing."""
    if len(shaft.bearing_positions) != 2 or not result.reaction_front:
        return []
    z_f, z_r = shaft.bearing_positions
    on_shaft = f.reaction_rear(C_S=result.couple_vector, z_f=z_f, F_S=result.force_vector, z_r=z_r)
    rear, front = -on_shaft, result.force_vector + on_shaft
    upwards = abs(front) / front
    preload = float(result.bolts.bolt_preload) if result.bolts is not None else None
    rows = []
    for n in range(CASES):
        turn = upwards * cmath.exp(2j * math.pi * n / CASES)
        forces = (part for force in (front * turn, rear * turn) for part in (force.real, force.imag))
        rows.append((n + 1, 360.0 * n / CASES, *(round(x, 9) + 0.0 for x in forces), *(() if preload is None else (preload,))))
    columns = [(Text("case"), ""), (Text("direction, front"), "°"), (Text("front, up"), "N"), (Text("front, side"), "N"),
        (Text("rear, up"), "N"), (Text("rear, side"), "N")]  # fmt: skip
    bolts = EMPTY
    if shaft.bolts is not None:
        columns.append((Text("each bolt"), "N"))
        bolts = Text(" Each of the {count} bolts presses with its preload.", count=shaft.bolts.count)
    speed = Amount(result.omega / (2 * math.pi) * 60, form=".4g")
    note = Text(
        "Forces of the shaft on its bearings at {n} rpm, at four instants of a turn (Finotti 2013, 4.7, in chapter 6, spreads each over "
        "60° of its seat); side is 90° further in the sense of crank rotation. Weight and gear force are left out, as there.{bolts} The "
        "stresses that finite elements find with them belong to [countershaft.support].", n=speed, bolts=bolts)  # fmt: skip
    return [Table("support_loads", Text("Load cases of the support"), tuple(columns), tuple(rows), note)]
