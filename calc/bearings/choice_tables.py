# SPDX-License-Identifier: Apache-2.0
"""Plain and rolling bearings to choose from, as a table that a narrow terminal bears, and what is said about them."""

from collections.abc import Iterator

from ..countershaft.rows import called
from ..sheet.step import Table
from ..sheet.text import COMMA, EMPTY, SEMICOLON, Amount, Name, Text, listed
from ..sheet.units import UNITS
from .choice import ChoiceRow, KindsFound, Side, words_of
from .inputs import BearingsInputs
from .plain.selection.search import BearingsFound
from .plain.selection.states import against, letter_of
from .plain.selection.tables import NUMBER, rounded, rows_of
from .plain.selection.variants import SUPPLY
from .rolling.clearance import usual_fits
from .rolling.search import SEATED

TITLES = {
    "loss": Text("Plain and rolling bearings that pass: the least loss first"),
    "size": Text("Plain and rolling bearings that pass: the smallest seats first"),
}
EXPLAIN = Text(
    "Plain: d×l of the journal in mm. P_f: loss of all over the duty, oil as supplied. Seat: the largest bore in the "
    "housing. Life: of the rolling bearing that lives shortest; plain ones run on a film."
)
TYPES = {
    "ball": Text("ball bearings"),
    "roller": Text("cylindrical roller bearings"),
    "needle": Text("needle bearings"),
    "cup": Text("drawn cups"),
    "cage": Text("needle cages"),
}
HOUR = UNITS["h"]


def choices_table(choice: KindsFound, top: int) -> Table:
    """The design as it is, then the first `top` rows."""
    shown = [(str(n), row) for n, row in enumerate(choice.rows[:top], 1)]
    if choice.now is not None:
        shown = [(Text("now"), choice.now), *shown]
    columns = [(NUMBER, "")]
    columns += [(letter_of(row.name), "") for row in choice.case.rows]
    columns += [(Name("P_f"), "W"), (Text("mass"), "kg"), (Text("seat"), "mm"), (Text("life"), "h"), (Text("with"), "")]
    rows = tuple(
        (
            number,
            *(side.words for side in row.sides),
            rounded(row.loss, 4),
            rounded(row.mass, 3),
            rounded(row.seat * 1e3, 4),
            None if row.life is None else rounded(HOUR.shown(row.life), 3),
            _with(choice, row),
        )
        for number, row in shown
    )
    return Table("kinds", TITLES[choice.aim], tuple(columns), rows, EXPLAIN)


def _with(choice: KindsFound, row: ChoiceRow) -> Text:
    """Oil and supply of plain ones where they are others, and the cautions of rolling ones."""
    words: list[str] = []
    begun = choice.case.bearings if choice.plain is None else choice.plain.case.bearings
    if row.inputs.oil != begun.oil:
        words.append(row.inputs.oil)
    if "plain" in row.types and row.inputs.supply != begun.supply:
        words.append(SUPPLY[row.inputs.supply])
    if (row.inputs.journal_fit, row.inputs.seat_fit) != (begun.journal_fit, begun.seat_fit):
        words.append(f"{row.inputs.journal_fit}/{row.inputs.seat_fit}")
    words += dict.fromkeys(word for side in row.sides for word in side.cautions)
    return COMMA.join(words)


def fits_table(choice: KindsFound, top: int) -> Table | None:
    """How each rolling bearing of the first rows sits; None where there is none."""
    seen: dict[tuple[str, str], tuple[str | float | None, ...]] = {}
    for row in choice.rows[:top]:
        for side in row.sides:
            key = side.row.name, side.row.size or ""
            if side.type != "plain" and key not in seen:
                seen[key] = (called(side.row.name), Name(key[1]), *_sits(side))
    if not seen:
        return None
    columns = [Text("bearing"), Text("size"), Text("class"), Text("shaft"), Text("seat"), Text("ring held by")]
    columns += [Text("locates"), Text("cage")]
    title = Text("How the rolling bearings sit")
    return Table("fits", title, tuple((label, "") for label in columns), tuple(seen.values()), SEATED)


def _sits(side: Side) -> tuple[Text, ...]:
    row, size = side.row, side.row.outline
    assert size is not None
    shaft_fit, seat_fit = usual_fits(size.type, size.inner_ring)
    return (
        Name(row.clearance_class) if size.inner_ring else EMPTY,
        Name(row.shaft_fit or shaft_fit),
        Name(row.seat_fit or seat_fit),
        Name(row.outer_ring_held),
        Text("yes") if row.locates else EMPTY,
        Name(row.cage),
    )


def summary(choice: KindsFound) -> tuple[Text, ...]:
    """What the first row is and saves; which kinds have no row, and why."""
    words: list[Text] = []
    first, now = choice.rows[0], choice.now
    power = Text("{power}", power=Amount(first.loss, "W", digits=3))
    if now is not None:
        power = Text("{power} in place of {now}", power=power, now=Amount(now.loss, "W", digits=3))
    if now is not None and [side.row for side in now.sides] == [side.row for side in first.sides]:
        words.append(Text("Row 1 is the design as it is: {power}.", power=Amount(first.loss, "W", digits=3)))
    elif not first.plain:
        words.append(Text("Row 1: {row}; {power}.", row=words_of(first), power=power))
    if choice.plain is not None and choice.plain.case is not choice.case:
        words.append(_begun(choice, choice.plain.case.bearings))
    if choice.why_plain:
        words.append(Text("No plain row: {why}.", why=choice.why_plain))
    for type, why in choice.missing:
        none = Text("No row with {type}: {why}.", type=TYPES[type], why=why) if type else Text("{why}.", why=why)
        words.append(none)
    return tuple(filter(None, words))


def _begun(choice: KindsFound, inputs: BearingsInputs) -> Text:
    """How oil comes to plain bearings of a design that has no such, where the search has proposed it."""
    if inputs.supply == choice.case.bearings.supply and inputs.supply_pressure == choice.case.bearings.supply_pressure:
        return EMPTY
    return Text(
        "Plain rows are fed as is proposed: by {supply}, at {pressure}.",
        supply=SUPPLY[inputs.supply],
        pressure=Amount(inputs.supply_pressure / UNITS["bar"].factor, "bar"),
    )


def notes(choice: KindsFound) -> Iterator[Text]:
    if choice.verified:
        yield Text(
            "Rolling bearings of all sizes whose bore is no smaller than the core, and the design's own, are judged by "
            "life, static safety, speed and slope, and sit by the least change of class, fits and how the ring is "
            "held that leaves clearance and grip. Solved as whole designs: {rows}; the others are when they are taken.",
            rows=rows_of(list(choice.verified)),
        )
    if choice.dropped:
        yield Text("Refused by the whole design: {rows}.", rows=SEMICOLON.join(choice.dropped[:3]))
    for id in dict.fromkeys(c.id for checks in choice.elsewhere.values() for c in checks):
        there = {number: c for number, checks in choice.elsewhere.items() for c in checks if c.id == id}
        limit = against(next(iter(there.values())))
        yield Text("Then open, with {rows}: {id} ({limit}).", rows=rows_of(list(there)), id=id, limit=limit)


def written(choice: KindsFound, number: int) -> Text:
    row = choice.row(number)
    sides = listed(Text("{place} {size}", place=called(side.row.name), size=side.words) for side in row.sides)
    power = Amount(row.loss, "W")
    return Text("now has the bearings of row {row} ({sides}): {power}", row=number, sides=sides, power=power)


def hidden(choice: KindsFound, top: int) -> Text:
    """Which rows are not shown, and how to see them."""
    longer = len(choice.plain.beyond) if isinstance(choice.plain, BearingsFound) else 0
    last = len(choice.rows) + longer
    if top >= last:
        return EMPTY
    if longer:
        beyond = max(top, len(choice.rows)) + 1
        return Text("Rows {a} to {b}: --top {b} (from {c} on too long for their room).", a=top + 1, b=last, c=beyond)
    return Text("Rows {a} to {b}: --top {b}.", a=top + 1, b=last)
