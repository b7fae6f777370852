# SPDX-License-Identifier: Apache-2.0
"""The chapter of a drive picked from a front.

What was searched, where it stands, what each objective costs there, what binds it."""

from __future__ import annotations

from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from calc.locale.language import in_language
from calc.sheet.check import Check
from calc.sheet.step import Curve, Series, Table
from calc.sheet.text import Amount, Text
from calc.studies.drive.front import UNITS, Picked
from calc.studies.drive.output import LABELS, power_of_ten, proof_of, ranges

from ..context import Context
from ..figures.figures import figure_blocks
from ..figures.plots import Plots
from ..typesetting.pagination import Block, bullet, heading, paragraph
from ..typesetting.prose import BODY, SECTION
from .checks import check_blocks
from .values import table_blocks

if TYPE_CHECKING:
    pass

BINDING = 6  # limits with the least margins


def front_figure(context: Context, picked: Picked, plots: Plots) -> list[Block]:
    """Where the drive stands on its front, if that is one of power and mass."""
    if "power" not in picked.names or "mass" not in picked.names or len(picked.line("mass", "power")) <= 1:
        return []
    context.figures += 1
    return figure_blocks([(context.figures, _curve(picked))], context.words["figure"], plots)


def drive_blocks(context: Context, picked: Picked, figure: list[Block]) -> list[Block]:
    """Everything of the chapter below its title."""
    say = context.say
    proof = proof_of(picked.proved, picked.combinations, picked.done, picked.classes)
    intro = Text(
        "Drive {n} of {count} that were solved whole; {combinations} combinations were searched. {proof}",
        n=picked.number,
        count=len(picked.rows),
        combinations=power_of_ten(picked.combinations),
        proof=proof,
    )
    blocks = paragraph(say(intro), BODY)
    blocks += heading(say(Text("What was varied")), SECTION, gap=8.5, after=1.0)
    blocks += [block for line in ranges(picked.sizes, picked.choices) for block in bullet(say(line))]
    blocks += figure
    blocks += table_blocks(context, _said(context, [_neighbours(picked), *_costs(picked)]))
    binding = _binding(context, picked)
    if binding:
        blocks += heading(say(Text("What binds it")), SECTION, gap=8.5, after=1.0)
        blocks += check_blocks(context, binding)
    return blocks


def _said(context: Context, tables: list[Table]) -> list[Table]:
    return [in_language(table, context.say) for table in tables]


def _curve(picked: Picked) -> Curve:
    """The drives that no other beats in power and mass, and where this one stands."""
    line = picked.line("mass", "power")
    mass, power = (picked.mine[picked.names.index(name)] for name in ("mass", "power"))
    front = Series(Text("no drive is lighter with less power"), line[:, 0], line[:, 1])
    return Curve(
        "drive_front",
        Text("Front of power and mass; the point is this drive"),
        Text("shaft, kg"),
        Text("power at the crank, W"),
        (front,),
        point=(float(mass), float(power)),
    )


def _neighbours(picked: Picked) -> Table:
    columns = ((Text("no."), ""), *((LABELS[name], UNITS[name][0]) for name in picked.names))
    rows = [(float(n), *(float(f"{x:.6g}") for x in picked.rows[n - 1])) for n in picked.nearest()]
    note = Text("The drives nearest to number {n}, which is this one.", n=picked.number)
    return Table("drive_neighbours", Text("Around it on the front"), columns, tuple(rows), note)


def _costs(picked: Picked) -> list[Table]:
    rows: list[tuple[str | float | None, ...]] = [
        (
            Text("{gain} of {wanted}", gain=Amount(gain, UNITS[wanted][0]), wanted=LABELS[wanted]),
            Text("{loss} of {paid}", loss=Amount(loss, UNITS[paid][0]), paid=LABELS[paid]),
            Text("{slope}", slope=Amount(loss / gain, f"{UNITS[paid][0]}/{UNITS[wanted][0]}")),
        )
        for wanted, gain, paid, loss in picked.costs()
    ]
    if not rows:
        return []
    columns = ((Text("better by"), ""), (Text("costs"), ""), (Text("that is"), ""))
    note = Text(
        "From this drive to the next one along the front of each two objectives, whatever the others then are; only "
        "where it stands on it."
    )
    return [Table("drive_costs", Text("What each objective costs in another"), columns, tuple(rows), note)]


def _binding(context: Context, picked: Picked) -> list[Check]:
    """The limits of this drive with the least margins, findings that were limits of the search among them."""

    def binds(check: Check) -> bool:
        asked = any(fnmatchcase(check.id, p) for p in picked.limits) and not any(
            fnmatchcase(check.id, p) for p in picked.waived
        )
        return (check.kind == "limit" or asked) and check.verdict != "not_verified" and check.margin == check.margin

    checks = [check for check in context.results.checks() if binds(check)]
    return sorted(checks, key=lambda check: check.margin)[:BINDING]
