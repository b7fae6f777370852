# SPDX-License-Identifier: Apache-2.0
"""The chapter of a drive picked from a front: what was searched, where it stands, what each objective costs there, what binds it."""

from fnmatch import fnmatchcase

from calc.studies.drive.front import UNITS, Picked
from calc.studies.drive.output import LABELS, power_of_ten, proof_of, ranges
from calc.sheet.check import Check
from calc.sheet.step import Curve, Series, Table
from calc.sheet.text import Amount, Text

from .blocks.checks import check_blocks
from .context import Context
from .figures.figures import figure_blocks
from .setting.flow import Block, bullet, heading, paragraph
from .figures.plots import Plots
from .setting.prose import BODY, SECTION
from .blocks.values import table_blocks

BINDING = 6  # limits with the least margins


def front_figure(context: Context, one: Picked, plots: Plots) -> list[Block]:
    """Where the drive stands on its front, if that is one of power and mass."""
    if "power" not in one.names or "mass" not in one.names or len(one.line("mass", "power")) <= 1:
        return []
    context.figures += 1
    return figure_blocks([(context.figures, _curve(one))], context.words["figure"], plots)


def drive_blocks(context: Context, one: Picked, figure: list[Block]) -> list[Block]:
    """Everything of the chapter below its title."""
    say = context.say
    proof = proof_of(one.proved, one.combinations, one.done, one.classes)
    intro = Text("Drive {n} of {count} that were solved whole; {combinations} combinations were searched. {proof}",
        n=one.number, count=len(one.rows), combinations=power_of_ten(one.combinations), proof=proof)  # fmt: skip
    made = paragraph(say(intro), BODY)
    made += heading(say(Text("What was varied")), SECTION, gap=8.5, after=1.0)
    made += [block for line in ranges(one.sizes, one.choices) for block in bullet(say(line))]
    made += figure
    made += table_blocks(context, _said(context, [_neighbours(one), *_costs(one)]))
    binding = _binding(context, one)
    if binding:
        made += heading(say(Text("What binds it")), SECTION, gap=8.5, after=1.0)
        made += check_blocks(context, binding)
    return made


def _said(context: Context, tables: list[Table]) -> list[Table]:
    from calc.languages.outcome import in_language

    return [in_language(one, context.say) for one in tables]


def _curve(one: Picked) -> Curve:
    """The drives that no other beats in power and mass, and where this one stands."""
    line = one.line("mass", "power")
    mass, power = (one.mine[one.names.index(name)] for name in ("mass", "power"))
    front = Series(Text("no drive is lighter with less power"), line[:, 0], line[:, 1])
    return Curve("drive_front", Text("Front of power and mass; the point is this drive"), Text("shaft, kg"), Text("power at the crank, W"),
        (front,), point=(float(mass), float(power)))  # fmt: skip


def _neighbours(one: Picked) -> Table:
    columns = ((Text("no."), ""), *((LABELS[name], UNITS[name][0]) for name in one.names))
    rows = [(float(n), *(float(f"{x:.6g}") for x in one.rows[n - 1])) for n in one.nearest()]
    note = Text("The drives nearest to number {n}, which is this one.", n=one.number)
    return Table("drive_neighbours", Text("Around it on the front"), columns, tuple(rows), note)


def _costs(one: Picked) -> list[Table]:
    rows: list[tuple[str | float | None, ...]] = [
        (Text("{gain} of {wanted}", gain=Amount(gain, UNITS[wanted][0]), wanted=LABELS[wanted]),
         Text("{loss} of {paid}", loss=Amount(loss, UNITS[paid][0]), paid=LABELS[paid]),
         Text("{slope}", slope=Amount(loss / gain, f"{UNITS[paid][0]}/{UNITS[wanted][0]}")))
        for wanted, gain, paid, loss in one.costs()
    ]  # fmt: skip
    if not rows:
        return []
    columns = ((Text("better by"), ""), (Text("costs"), ""), (Text("that is"), ""))
    note = Text(
        "From this drive to the next one along the front of each two objectives, whatever the others then are; only where it stands on it."
    )
    return [Table("drive_costs", Text("What each objective costs in another"), columns, tuple(rows), note)]


def _binding(context: Context, one: Picked) -> list[Check]:
    """The limits of this drive with the least margins, findings that were limits of the search among them."""

    def binds(check: Check) -> bool:
        asked = any(fnmatchcase(check.id, p) for p in one.limits) and not any(fnmatchcase(check.id, p) for p in one.waived)
        return (check.kind == "limit" or asked) and check.verdict != "not_verified" and check.margin == check.margin

    found = [check for check in context.results.checks() if binds(check)]
    return sorted(found, key=lambda check: check.margin)[:BINDING]
