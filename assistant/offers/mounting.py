# SPDX-License-Identifier: Apache-2.0
"""Mounts to choose from: stiffness, shear ratio and inclination of front and rear, the purest modes first."""

from calc.design.model import Design
from calc.mounting.result import MountingResult
from calc.mounting.selection import changes, choices, table
from calc.sheet.errors import NoSolution
from calc.sheet.progress import Progress
from calc.sheet.text import Amount, Text
from calc.solve import solve

from .offer import Offer

NEEDS = ("engine", "imbalance", "mounting")
WHY = Text("the mounts are sought for the engine of [mounting] and what drives it")


def offer(made: Design, file: str, progress: Progress | None = None) -> Offer:
    assert made.mounting is not None
    mounting, results = made.mounting, solve(made)
    result = results.result(MountingResult)
    if result is None:
        raise NoSolution(Text("mounts can be chosen once the step is solved"), results.outcomes["mounting"].reason)
    room, found = choices(mounting, result, progress)

    def said(number: int) -> Text:
        one = found[number - 1]
        return Text(
            "now has mounts whose purest mode keeps {most} and whose most mixed keeps {least} of its energy",
            most=Amount(100 * float(one.energies.max()), "%", digits=3), least=Amount(100 * float(one.energies.min()), "%", digits=3),
        )  # fmt: skip

    return Offer(
        count=len(found),
        table=lambda top: table(found, room, top),
        keys=lambda number: changes(found[number - 1], mounting, room),
        said=said,
        hint=Text("`--apply N` writes stiffness and inclination of every mount into the design; `--top N` shows more."),
    )
