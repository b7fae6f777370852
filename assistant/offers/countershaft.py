# SPDX-License-Identifier: Apache-2.0
"""Counter-shafts to choose from: radii and materials in the envelope of the design, the lightest first."""

from calc.countershaft.sizing.choices import candidates, changes, choices, choices_table, envelope
from calc.design.model import Design
from calc.engine import solve as engine
from calc.imbalance import solve as imbalance
from calc.sheet.progress import Progress
from calc.sheet.text import Amount, Text

from .offer import Offer

NEEDS = ("engine", "imbalance", "countershaft")
WHY = Text("the shaft is sized for what the engine's crank leaves, in the envelope of [countershaft]")


def offer(made: Design, file: str, progress: Progress | None = None) -> Offer:
    assert made.engine is not None and made.imbalance is not None and made.countershaft is not None
    shaft = made.countershaft
    room = envelope(shaft, made.bearings, file)
    materials = candidates(shaft, made.materials, file)
    e = engine.values(made.engine)
    found = choices(shaft, imbalance.values(made.imbalance, made.engine, e), e.angular_speed, room, materials, progress)

    def said(number: int) -> Text:
        one = found.shafts[number - 1]
        return Text(
            "now sizes its shaft in {material} within an outer radius of {radius}: {mass}", material=one.material,
            radius=Amount(one.sized.outer_radius * 1e3, "mm", form="g"), mass=Amount(one.sized.mass, "kg"),
        )  # fmt: skip

    return Offer(
        count=len(found.shafts),
        table=lambda top: choices_table(found, top, room),
        keys=lambda number: changes(found.shafts[number - 1], room),
        said=said,
        hint=Text("`--apply N` writes mode, material and envelope of the N-th shaft into the design; `--top N` shows more."),
    )
