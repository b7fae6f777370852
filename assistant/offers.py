# SPDX-License-Identifier: Apache-2.0
"""What can be chosen for a step: a ranked table of rows that pass.  Used by `contralbero choose` and by the session."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from difflib import get_close_matches
from typing import Any

from calc.bearings import choice as kinds
from calc.bearings import choice_tables as kind_tables
from calc.bearings.choice import plain_case
from calc.bearings.inputs import BearingsInputs
from calc.bearings.plain.selection import search as bearing_search
from calc.bearings.plain.selection import tables as bearing_tables
from calc.bearings.plain.selection import together
from calc.bearings.plain.selection.search import BearingsFound, Settled
from calc.bearings.plain.selection.variants import SUPPLY, SelectionCase, with_own_oil
from calc.bearings.plain.selection.writing import bearing_changes
from calc.countershaft.sizing import choices as sizing
from calc.countershaft.sums import SystemShaft
from calc.design.model import Design
from calc.design.step_inputs import bearings_case, given_beside, rolling_places, shaft_axes, sized_alike
from calc.engine import solve as engine
from calc.engine.inputs import EngineInputs
from calc.gears.selection import idler
from calc.gears.selection import search as gear_search
from calc.gears.selection import tables as gear_tables
from calc.gears.selection.rattle import RattleOfRows
from calc.imbalance import solve as imbalance
from calc.imbalance.firing_orders import as_designed, crank_words, firing_orders, orders_table
from calc.mounting import selection as mounts
from calc.mounting.result import MountingResult
from calc.sheet.errors import BadInput, InputError, NoSolution
from calc.sheet.progress import Progress, part
from calc.sheet.quantity import dotted
from calc.sheet.remedy import Changes, assignments
from calc.sheet.step import OF_SHAFTS, Table
from calc.sheet.text import EMPTY, Amount, Name, Text
from calc.sheet.verdict import severity
from calc.solve import Results, solve
from calc.studies.repair.nearest import NearestRemedy

from .session.guide import CHOICE_NEEDS


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


def nothing(number: int) -> Changes:
    return {}


NOTHING = Offer(0, lambda top: Table("choices", EMPTY, (), ()), nothing, lambda n: EMPTY, EMPTY)


def with_nearest(offer: Offer, nearest: NearestRemedy) -> Offer:
    """The same, headed by the remedy of the step that F5 has too: the nearest design in which its limits hold."""
    number = offer.count + 1
    columns = ((Text("no."), ""), (Text("change"), ""), (Text("then"), ""))
    table = Table(
        "nearest",
        Text("Nearest to the design, as the list of remedies has it"),
        columns,
        ((number, nearest.words, nearest.said),),
    )
    return replace(
        offer,
        count=number,
        table=lambda top: table,
        keys=lambda n: nearest.made if n == number else offer.keys(n),
        said=lambda n: nearest.said if n == number else offer.said(n),
        beside=lambda top: (offer.table(top), *offer.beside(top)) if offer.count else (),
    )


Held = Callable[[str], str]  # why an input is held; empty where a search may move it
OIL = dotted(Design.bearings, BearingsInputs.oil)


def not_held(key: str) -> str:
    """Nothing is: every row is shown, and what it changes of what is locked is said beside it."""
    return ""


def _engine(design: Design, file: str, progress: Progress | None = None) -> Offer:
    """Firing orders to choose from, ranked by what they leave."""
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


def _countershaft(design: Design, file: str, progress: Progress | None = None, name: str = "") -> Offer:
    """Counter-shafts to choose from, for one shaft of the design and its twins: radii and materials in its envelope,
    the lightest first."""
    shaft = design.views[name].countershaft
    assert design.engine is not None and design.imbalance is not None and shaft is not None
    room = sizing.envelope(shaft, file)
    materials = sizing.candidates(shaft, design.materials, file)
    e = engine.values(design.engine)
    i, alike = imbalance.values(design.imbalance, design.engine, e), sized_alike(design, shaft.name)
    beside = _beside(design, name)
    selection = sizing.choices(shaft, i, e.angular_speed, room, materials, progress, alike, beside)

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
        table=lambda top: sizing.choices_table(selection, top, room),
        keys=lambda number: sizing.changes(selection.shafts[number - 1], room),
        said=said,
        hint=Text(
            "`--apply N` writes mode, material and envelope of the N-th shaft into the design; `--top N` shows more."
        ),
    )


def _beside(design: Design, name: str) -> tuple[SystemShaft, ...]:
    """The given shafts beside one that is to be sized."""
    if len(design.originals) == 1:
        return ()
    return given_beside(
        design, name, {other: view.outcomes["countershaft"] for other, view in solve(design).views.items()}
    )


def _bearings(
    design: Design,
    file: str,
    progress: Progress | None = None,
    name: str = "",
    aim: str = "loss",
    results: Results | None = None,
    held: Held = not_held,
) -> Offer:
    """Bearings to choose from, for one shaft of the design and its twins: lengths, clearances, oils and supplies that
    fit the shaft and keep every rule at the worst corner."""
    assert design.bearings is not None
    case = bearings_case(design, solve, results, name)
    if held(OIL):
        case = with_own_oil(case)
    return _plain(_search_plain(case, aim, progress)) if aim == "film" else _kinds(design, case, aim, progress)


def _search_plain(case: SelectionCase, aim: str, progress: Progress | None) -> kinds.PlainFound:
    """Of more than two bearings, which share their load, sizes and clearances alone."""
    if len(case.rows) == 2:
        return bearing_search.search(case, aim, progress)
    return together.search(case, aim, progress)


def _plain(found: kinds.PlainFound) -> Offer:
    """Plain ones alone, by the numbers that they have among themselves."""
    return _of_two(found) if isinstance(found, BearingsFound) else _sharing(found)


def _kinds(design: Design, case: SelectionCase, aim: str, progress: Progress | None) -> Offer:
    """Plain and rolling bearings in one table; what is told of the plain ones alone beside it."""
    places = rolling_places(design, case.results, case.name)
    selection: kinds.PlainFound | None = None
    why = EMPTY
    try:
        begun = plain_case(case, places)
        selection = _search_plain(begun, aim, part(progress, 0.0, 0.7))
        selection = selection if begun is case else replace(selection, now=None)
    except NoSolution as none:
        why = none.text
    choice = kinds.choice(case, places, selection, why, aim, part(progress, 0.7, 1.0))
    plain = None if choice.plain is None else _plain(choice.plain)
    own = choice.plain is not None and choice.plain.case is case  # its rows are changes of the design itself

    def taken(number: int) -> Changes:
        n = choice.row(number).plain
        if n and plain is not None and own:
            return plain.keys(n)
        row = choice.row(number)
        if number not in choice.verified:
            settled = kinds.confirmed(case, row)
            if settled.why:
                raise NoSolution(Text("row {row} does not pass", row=number), settled.why, Text("take another row"))
        return kinds.changes(case, row)

    def said(number: int) -> Text:
        n = choice.row(number).plain
        return plain.said(n) if n and plain is not None and own else kind_tables.written(choice, number)

    def beside(top: int) -> tuple[Table, ...]:
        fits = kind_tables.fits_table(choice, top)
        of_plain = (plain.table(top), *plain.beside(top)) if plain is not None else ()
        named = (replace(t, id="plain") if t.id == "bearings" else t for t in of_plain if t.rows)
        return (*((fits,) if fits else ()), *named)

    return Offer(
        count=choice.count,
        table=lambda top: kind_tables.choices_table(choice, top),
        keys=taken,
        said=said,
        hint=Text("`--apply N` writes the N-th row, of every table with numbers, into the design."),
        beside=beside,
        summary=(*kind_tables.summary(choice), *(plain.summary if plain is not None and own else ())),
        notes=(*kind_tables.notes(choice), *(plain.notes if plain is not None else ())),
        hidden=lambda top: kind_tables.hidden(choice, top),
    )


def _of_two(selection: BearingsFound) -> Offer:
    case = selection.case

    def taken(number: int) -> Changes:
        """Rows that were not solved as whole designs are so now."""
        row = selection.all[number - 1]
        if number not in selection.verified:
            _confirm(bearing_search.confirmed(case, row, selection.slopes[0]), selection.no(number))
        return bearing_changes(row, case)

    def written(number: int) -> Text:
        row = selection.all[number - 1]
        words = Text(
            "now has the bearings of row {row} ({change}; {oil}, {supply}): {power}",
            row=selection.no(number),
            oil=row.variant.oil,
            change=bearing_tables.changed(row) or Text("lengths and clearances as they were"),
            supply=SUPPLY[row.variant.supply],
            power=Amount(row.power, "W"),
        )
        return Text("{row}; its journals are too long for their room", row=words) if any(row.too_long) else words

    def beside(top: int) -> tuple[Table, ...]:
        too_long = bearing_tables.beyond_table(selection, top)
        return (
            *((too_long,) if too_long else ()),
            bearing_tables.neighbours_table(selection),
            bearing_tables.pareto_table(selection),
        )

    return Offer(
        count=len(selection.all),
        table=lambda top: bearing_tables.choices_table(selection, top),
        keys=taken,
        said=written,
        hint=Text("`--apply N` writes the N-th row, of every table with numbers, into the design."),
        beside=beside,
        summary=bearing_tables.summary(selection),
        notes=bearing_tables.notes(selection),
        hidden=lambda top: bearing_tables.hidden(selection, top),
    )


def _sharing(selection: together.SharedFound) -> Offer:
    case = selection.case

    def taken(number: int) -> Changes:
        row = selection.rows[number - 1].row
        _confirm(together.confirmed(case, row, selection.slopes, selection.asked), selection.no(number))
        return bearing_changes(row, case)

    def written(number: int) -> Text:
        chosen = selection.rows[number - 1]
        return Text(
            "now has the bearings of row {row} ({change}): {power}",
            row=selection.no(number),
            change=bearing_tables.changed(chosen.row) or Text("lengths and clearances as they were"),
            power=Amount(chosen.power, "W"),
        )

    return Offer(
        count=len(selection.rows),
        table=lambda top: together.choices_table(selection, top),
        keys=taken,
        said=written,
        hint=Text("`--apply N` writes the N-th row into the design; `--top N` shows more."),
        summary=together.summary(selection),
        notes=together.notes(selection),
    )


def _confirm(settled: Settled, number: int) -> None:
    """Raises NoSolution where a row does not pass in the whole design."""
    if settled.row is None:
        raise NoSolution(Text("row {row} does not pass", row=number), settled.why, Text("take another row"))


def _gears(design: Design, file: str, progress: Progress | None = None) -> Offer:
    """Profile shifts, tip cuts and the teeth of an idler to choose from, every rule of the teeth kept."""
    assert design.gears is not None
    axes = shaft_axes(design)
    selection = gear_search.search(design.gears, part(progress, 0.0, 0.9), axes)
    teeth = idler.idlers(design.gears, axes, part(progress, 0.9, 1.0))
    rattle = RattleOfRows(design.gears, solve(design).train)
    shifts, others = selection.all, [row for rows in teeth for row in idler.passed(rows)]

    def keys(number: int) -> Changes:
        return (
            gear_tables.changes(shifts[number - 1])
            if number <= len(shifts)
            else others[number - 1 - len(shifts)].changes
        )

    def said(number: int) -> Text:
        if number > len(shifts):
            return idler.written(others[number - 1 - len(shifts)])
        row = shifts[number - 1]
        return Text(
            "now has the gears of row {row} ({change}): largest specific sliding {sliding}",
            row=number,
            change=gear_tables.changed(row),
            sliding=Amount(row.largest, form=".3f"),
        )

    def beside(top: int) -> tuple[Table, ...]:
        first, idler_tables = len(shifts) + 1, []
        for rows in teeth:
            idler_tables.append(idler.idler_table(rows, first, top))
            first += len(idler.passed(rows))
        tables = (
            *idler_tables,
            gear_tables.sliding_table(selection, top),
            gear_tables.first_rows(gear_tables.wants_table(selection), top),
            gear_tables.first_rows(gear_tables.around_table(selection, rattle), top),
            gear_tables.limits_table(selection),
            gear_tables.first_rows(gear_tables.cuts_now_table(selection), top),
            gear_tables.cuts_best_table(selection, top),
        )
        return tuple(table for table in tables if table is not None)

    return Offer(
        count=len(shifts) + len(others),
        table=lambda top: gear_tables.choices_table(selection, top, rattle),
        keys=keys,
        said=said,
        hint=Text("`--apply N` writes the N-th row, of every table with numbers, into the design."),
        beside=beside,
        summary=gear_tables.summary(selection),
        notes=tuple(gear_tables.notes(selection)),
    )


def _mounting(design: Design, file: str, progress: Progress | None = None) -> Offer:
    """Mounts to choose from: stiffness, shear ratio and inclination of front and rear, the purest modes first."""
    assert design.mounting is not None
    mounting, results = design.mounting, solve(design)
    result = results.result(MountingResult)
    if result is None:
        raise NoSolution(Text("mounts can be chosen once the step is solved"), results.outcomes["mounting"].reason)
    room, ranked = mounts.choices(mounting, result, progress)

    def said(number: int) -> Text:
        choice = ranked[number - 1]
        return Text(
            "now has mounts whose purest mode keeps {most} and whose most mixed keeps {least} of its energy",
            most=Amount(100 * float(choice.energies.max()), "%", digits=3),
            least=Amount(100 * float(choice.energies.min()), "%", digits=3),
        )

    return Offer(
        count=len(ranked),
        table=lambda top: mounts.table(ranked, room, top),
        keys=lambda number: mounts.changes(ranked[number - 1], mounting, room),
        said=said,
        hint=Text("`--apply N` writes stiffness and inclination of every mount into the design; `--top N` shows more."),
    )


Search = Callable[..., Offer]
OFFERS: dict[str, tuple[Text, Search]] = {  # by step: why it needs its tables, and the search
    "engine": (Text("firing orders are ranked by what they leave of the imbalance"), _engine),
    "countershaft": (
        Text("the shaft is sized for what the engine's crank leaves, in the envelope of its table [[shafts]]"),
        _countershaft,
    ),
    "bearings": (Text("there is nothing to choose a bearing for"), _bearings),
    "gears": (Text("there are no gears to choose shifts for"), _gears),
    "mounting": (
        Text("the mounts are sought for the engine of [mounting] and what drives it"),
        _mounting,
    ),
}


def offer(
    step: str,
    design: Design,
    file: str,
    progress: Progress | None = None,
    shaft: str | None = None,
    aim: str | None = None,
    results: Results | None = None,
    held: Held = not_held,
) -> Offer:
    """Search; `shaft`: of which of several shafts, else of that whose limits are the worst; `aim`: what bearings are
    chosen for, "loss", "size" or "film"; `results`: where the design is solved already; `held`: what no row may change,
    as far as a search knows of it.  Raises BadInput where the
    design lacks what the search needs, NoSolution where there is nothing to offer; `progress` may raise `Cancelled`."""
    why, search = OFFERS[step]
    missing = next((key for key in CHOICE_NEEDS[step] if getattr(design, key) is None), None)
    if missing is not None:
        raise BadInput(file, [InputError(0, missing, "", Text("needed: {why}", why=why))])
    if shaft is not None:
        _known(step, design, shaft)
    if aim is not None and step != "bearings":
        raise BadInput("--for", [InputError(0, "", aim, Text("is for bearings alone"))])
    if step not in OF_SHAFTS:
        return search(design, file, progress)
    aimed: dict[str, Any] = {} if aim is None else {"aim": aim}
    if step == "bearings":
        aimed |= {"results": results, "held": held}
    found = search(design, file, progress, name := shaft or _worst(step, design), **aimed)
    if len(design.originals) == 1:
        return found
    twins = [Name(twin.name) for twin in design.shafts if name in (twin.mirrors, twin.repeats)]
    names = Text(" and ").join([Name(name), *twins])
    said = Text("Of the shaft {names}.", names=names)
    if shaft is None:
        said = Text("Of the shaft {names}, whose limits are the worst; --shaft NAME takes another.", names=names)
    return replace(found, summary=(said, *found.summary))


def _worst(step: str, design: Design) -> str:
    """The shaft whose step has no solution, else the worst limit."""
    first, *others = design.originals
    if not others:
        return first

    def worst(results: Results) -> tuple[bool, object]:
        outcome = results.outcomes[step]
        return outcome.state == "solved", min(map(severity, outcome.checks), default=())

    views = solve(design).views
    return min(views, key=lambda name: worst(views[name]))


def _known(step: str, design: Design, shaft: str) -> None:
    """Raises BadInput where there is no such shaft, or the step is of none."""
    twin = next((each for each in design.shafts if each.name == shaft and each.is_twin), None)
    if step not in OF_SHAFTS:
        why = Text("is for countershaft and bearings alone")
    elif twin is not None:
        why = Text("is as {name}: choose for that", name=Name(twin.mirrors or twin.repeats or ""))
    elif shaft not in design.originals:
        why = Text("is no shaft of this design; there are {names}", names=", ".join(design.originals))
        if near := get_close_matches(shaft, [each.name for each in design.shafts], 1):
            why = Text('is no shaft of this design; did you mean "{near}"?', near=near[0])
    else:
        return
    raise BadInput("contralbero choose", [InputError(0, "--shaft", shaft, why)])
