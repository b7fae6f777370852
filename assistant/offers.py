# SPDX-License-Identifier: Apache-2.0
"""What can be chosen for a step: a ranked table of rows that pass.  Used by `contralbero choose` and by the session."""

from collections.abc import Callable
from dataclasses import dataclass

from calc.design.model import Design
from calc.engine.inputs import EngineInputs
from calc.sheet.errors import BadInput, InputError, NoSolution
from calc.sheet.progress import Progress, part
from calc.sheet.quantity import dotted
from calc.sheet.remedy import Changes, assignments
from calc.sheet.step import Table
from calc.sheet.text import EMPTY, Amount, Text

CHOICES = {
    "engine": Text("firing orders, the one that leaves least first"),
    "countershaft": Text("shafts in the envelope, the lightest first"),
    "bearings": Text("plain bearings that pass at every corner, the nearest and the least power first"),
    "gears": Text("profile shifts and tip cuts, the least specific sliding first; teeth of an idler between walls"),
    "mounting": Text("mounts that decouple the modes between the road's frequency and idle, the purest first"),
}


@dataclass(frozen=True)
class Offer:
    """What was found: how many rows, the table of the first of them, and for each row (from 1) its keys and what is
    then said.

    `summary`: lines under the table's title; `notes`: a list behind all tables; `hidden`: which rows are not among the
    first."""

    count: int
    table: Callable[[int], Table]
    keys: Callable[[int], Changes]
    said: Callable[[int], Text]
    hint: Text
    beside: Callable[[int], tuple[Table, ...]] = lambda top: ()  # further tables, beside so many rows of the first
    summary: tuple[Text, ...] = ()
    notes: tuple[Text, ...] = ()
    hidden: Callable[[int], Text] = lambda top: EMPTY

    def changes(self, number: int) -> list[str]:
        """What writes a row into the design, as KEY=VALUE.  Raises NoSolution where the row does not hold after all."""
        return assignments(self.keys(number))


def _engine(design: Design, file: str, progress: Progress | None = None) -> Offer:
    """Firing orders to choose from, ranked by what they leave."""
    from calc.engine import solve as engine
    from calc.imbalance.firing_orders import as_designed, crank_words, firing_orders, orders_table

    assert design.engine is not None and design.imbalance is not None
    inputs, crank = design.engine, design.imbalance
    e = engine.values(inputs)
    orders = firing_orders(crank, inputs, e)

    def said(number: int) -> Text:
        choice = orders[number - 1]
        order = "-".join(map(str, choice.order))
        return Text("now fires {order} (crank angles {angles}°)", order=order, angles=crank_words(choice.crank_angles))

    return Offer(
        count=len(orders),
        table=lambda top: orders_table(orders, top, as_designed(crank, inputs, e), inputs),
        keys=lambda number: {
            dotted(Design.engine, EngineInputs.firing_order): list(orders[number - 1].order),
            dotted(Design.engine, EngineInputs.crank_angles): None,
        },
        said=said,
        hint=Text(
            "`--apply N` writes the N-th order into the design, and the crank angles out of it; `--top N` shows more."
        ),
    )


def _countershaft(design: Design, file: str, progress: Progress | None = None) -> Offer:
    """Counter-shafts to choose from: radii and materials in the envelope of the design, the lightest first."""
    from calc.countershaft.sizing.choices import candidates, changes, choices, choices_table, envelope
    from calc.engine import solve as engine
    from calc.imbalance import solve as imbalance

    assert design.engine is not None and design.imbalance is not None and design.countershaft is not None
    shaft = design.countershaft
    room = envelope(shaft, design.bearings, file)
    materials = candidates(shaft, design.materials, file)
    e = engine.values(design.engine)
    selection = choices(
        shaft, imbalance.values(design.imbalance, design.engine, e), e.angular_speed, room, materials, progress
    )

    def said(number: int) -> Text:
        candidate = selection.shafts[number - 1]
        return Text(
            "now sizes its shaft in {material} within an outer radius of {radius}: {mass}",
            material=candidate.material,
            radius=Amount(candidate.sized.outer_radius * 1e3, "mm", form="g"),
            mass=Amount(candidate.sized.mass, "kg"),
        )

    return Offer(
        count=len(selection.shafts),
        table=lambda top: choices_table(selection, top, room),
        keys=lambda number: changes(selection.shafts[number - 1], room),
        said=said,
        hint=Text(
            "`--apply N` writes mode, material and envelope of the N-th shaft into the design; `--top N` shows more."
        ),
    )


def _bearings(design: Design, file: str, progress: Progress | None = None) -> Offer:
    """Bearings to choose from: lengths, clearances, oils and supplies that fit the shaft and keep every rule at the
    worst corner."""
    from calc.bearings.selection.search import bearing_changes, confirmed, search
    from calc.bearings.selection.tables import (
        beyond_table,
        changed,
        choices_table,
        hidden,
        neighbours_table,
        notes,
        pareto_table,
        summary,
    )
    from calc.bearings.selection.variants import SUPPLY
    from calc.design.step_inputs import bearings_case
    from calc.solve import solve

    assert design.bearings is not None
    bearings = design.bearings
    case = bearings_case(design, solve)
    selection = search(case, progress=progress)

    def taken(number: int) -> Changes:
        """Rows that were not solved as whole designs are so now."""
        row = selection.all[number - 1]
        if number > selection.verified:
            settled = confirmed(case, row, selection.slopes[0])
            if settled.row is None:
                raise NoSolution(Text("row {row} does not pass", row=number), settled.why, Text("take another row"))
        return bearing_changes(row, bearings)

    def written(number: int) -> Text:
        row = selection.all[number - 1]
        words = Text(
            "now has the bearings of row {row} ({change}; {oil}, {supply}): {power}",
            row=number,
            oil=row.variant.oil,
            change=changed(row) or Text("lengths and clearances as they were"),
            supply=SUPPLY[row.variant.supply],
            power=Amount(row.power, "W"),
        )
        return Text("{row}; its journals are too long for their room", row=words) if any(row.too_long) else words

    def beside(top: int) -> tuple[Table, ...]:
        too_long = beyond_table(selection, top)
        return (*((too_long,) if too_long else ()), neighbours_table(selection), pareto_table(selection))

    return Offer(
        count=len(selection.all),
        table=lambda top: choices_table(selection, top),
        keys=taken,
        said=written,
        hint=Text("`--apply N` writes the N-th row, of every table with numbers, into the design."),
        beside=beside,
        summary=summary(selection),
        notes=notes(selection),
        hidden=lambda top: hidden(selection, top),
    )


def _gears(design: Design, file: str, progress: Progress | None = None) -> Offer:
    """Profile shifts, tip cuts and the teeth of an idler to choose from, every rule of the teeth kept."""
    from calc.design.step_inputs import shaft_axis
    from calc.gears.selection.idler import idler_table, idlers, passed, written
    from calc.gears.selection.search import search
    from calc.gears.selection.tables import (
        around_table,
        changed,
        changes,
        choices_table,
        cuts_best_table,
        cuts_now_table,
        limits_table,
        notes,
        sliding_table,
        summary,
        wants_table,
    )

    assert design.gears is not None
    axis = shaft_axis(design)
    selection = search(design.gears, part(progress, 0.0, 0.9), axis)
    teeth = idlers(design.gears, axis, part(progress, 0.9, 1.0))
    shifts, others = selection.all, [row for rows in teeth for row in passed(rows)]

    def keys(number: int) -> Changes:
        return changes(shifts[number - 1]) if number <= len(shifts) else others[number - 1 - len(shifts)].changes

    def said(number: int) -> Text:
        if number > len(shifts):
            return written(others[number - 1 - len(shifts)])
        row = shifts[number - 1]
        return Text(
            "now has the gears of row {row} ({change}): largest specific sliding {sliding}",
            row=number,
            change=changed(row),
            sliding=Amount(row.largest, form=".3f"),
        )

    def beside(top: int) -> tuple[Table, ...]:
        first, idler_tables = len(shifts) + 1, []
        for rows in teeth:
            idler_tables.append(idler_table(rows, first, top))
            first += len(passed(rows))
        tables = (
            *idler_tables,
            sliding_table(selection, top),
            wants_table(selection),
            around_table(selection),
            limits_table(selection),
            cuts_now_table(selection),
            cuts_best_table(selection, top),
        )
        return tuple(table for table in tables if table is not None)

    return Offer(
        count=len(shifts) + len(others),
        table=lambda top: choices_table(selection, top),
        keys=keys,
        said=said,
        hint=Text("`--apply N` writes the N-th row, of every table with numbers, into the design."),
        beside=beside,
        summary=summary(selection),
        notes=notes(selection),
    )


def _mounting(design: Design, file: str, progress: Progress | None = None) -> Offer:
    """Mounts to choose from: stiffness, shear ratio and inclination of front and rear, the purest modes first."""
    from calc.mounting.result import MountingResult
    from calc.mounting.selection import changes, choices, table
    from calc.solve import solve

    assert design.mounting is not None
    mounting, results = design.mounting, solve(design)
    result = results.result(MountingResult)
    if result is None:
        raise NoSolution(Text("mounts can be chosen once the step is solved"), results.outcomes["mounting"].reason)
    room, ranked = choices(mounting, result, progress)

    def said(number: int) -> Text:
        choice = ranked[number - 1]
        return Text(
            "now has mounts whose purest mode keeps {most} and whose most mixed keeps {least} of its energy",
            most=Amount(100 * float(choice.energies.max()), "%", digits=3),
            least=Amount(100 * float(choice.energies.min()), "%", digits=3),
        )

    return Offer(
        count=len(ranked),
        table=lambda top: table(ranked, room, top),
        keys=lambda number: changes(ranked[number - 1], mounting, room),
        said=said,
        hint=Text("`--apply N` writes stiffness and inclination of every mount into the design; `--top N` shows more."),
    )


Search = Callable[[Design, str, Progress | None], Offer]
OFFERS: dict[str, tuple[tuple[str, ...], Text, Search]] = {  # by step: which tables it needs, why, and the search
    "engine": (("engine", "imbalance"), Text("firing orders are ranked by what they leave of the imbalance"), _engine),
    "countershaft": (
        ("engine", "imbalance", "countershaft"),
        Text("the shaft is sized for what the engine's crank leaves, in the envelope of [countershaft]"),
        _countershaft,
    ),
    "bearings": (("bearings",), Text("there is nothing to choose a bearing for"), _bearings),
    "gears": (("gears",), Text("there are no gears to choose shifts for"), _gears),
    "mounting": (
        ("engine", "imbalance", "mounting"),
        Text("the mounts are sought for the engine of [mounting] and what drives it"),
        _mounting,
    ),
}


def offer(step: str, design: Design, file: str, progress: Progress | None = None) -> Offer:
    """Search.  Raises BadInput where the design lacks what the search needs, NoSolution where there is nothing to
    offer; `progress` may raise `Cancelled`."""
    needed, why, search = OFFERS[step]
    missing = next((key for key in needed if getattr(design, key) is None), None)
    if missing is not None:
        raise BadInput(file, [InputError(0, missing, "", Text("needed: {why}", why=why))])
    return search(design, file, progress)
