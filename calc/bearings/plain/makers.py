# SPDX-License-Identifier: Apache-2.0
"""The journals of a shaft beside those that makers print for their balance shafts: a check and a table of facts."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from ...countershaft.rows import ROW, BearingRow, called, titled
from ...library.makers import PrintedJournal, journals, span
from ...sheet.check import Check, CheckRule
from ...sheet.quantity import dotted
from ...sheet.step import Table
from ...sheet.text import SPACE, Amount, Name, Text, plural
from ...sheet.units import UNITS, Metre, MetrePerSecond, NewtonPerMetreSecond, Number, Pascal
from .result import PlainResult

MAKER_RANGE = CheckRule(
    "bearings.B.maker_range",
    "advice",
    "What makers print for shafts of the same assembly and ratio; they print no length and no load.",
    sense="in",
    source=Text("rule of this program: least to most of the makers' printed journals, calc/library/tables/makers.toml"),
    cause="bearings.maker_range",
    moved_by=(dotted(ROW, BearingRow.diameter), dotted(ROW, BearingRow.clearance)),
)
NUMBERS = (  # what is compared: of a maker's journal, and in which unit
    (lambda journal: journal.diameters, "mm"),
    (lambda journal: journal.relative_clearances, "‰"),
)


class OwnJournal(NamedTuple):
    """A journal of this design: diameter and relative clearance as made, and what makers do not print: specific load,
    surface speed, heat index."""

    place: str
    diameter: Metre
    psi: Number
    p: Pascal
    u: MetrePerSecond
    W: NewtonPerMetreSecond


def own_journal(place: str, r: PlainResult) -> OwnJournal:
    d = r.seat.bearing.diameter
    return OwnJournal(place, float(d), float(r.clearance) / float(d), r.specific_load, r.surface_speed, r.heat_index)


def maker_checks(results: Mapping[str, PlainResult], assembly: str | None, ratio: Number | None) -> Iterator[Check]:
    """Of each bearing the one that can be made."""
    for place, r in results.items():
        if (check := maker_check(own_journal(place, r), assembly, ratio)) is not None:
            yield check


def maker_check(own: OwnJournal, assembly: str | None, ratio: Number | None) -> Check | None:
    """Diameter or relative clearance, whichever stands worse in what makers print for this assembly and ratio.

    A number that fewer than three engines have is not judged; None where neither is, or where assembly or ratio is not
    known."""
    if assembly is None or ratio is None:
        return None
    printed, at = journals(ratio, assembly), called(own.place)
    labels = (
        Text("Diameter among those of makers, {place}", place=at),
        Text("Relative clearance among those of makers, {place}", place=at),
    )
    made = [
        MAKER_RANGE(value, limits, at=own.place, name=label, unit=unit)
        for value, label, (number, unit) in zip((own.diameter, own.psi), labels, NUMBERS)
        if (limits := span(printed, number)) is not None
    ]
    return min(made, key=lambda check: check.margin, default=None)


def makers_table(own: Sequence[OwnJournal], assembly: str | None, ratio: Number | None) -> Table | None:
    """The journals of a shaft, then those that makers print for its ratio, of every assembly; None where its ratio is
    not known, or no sheet has it."""
    printed = journals(ratio) if ratio is not None else ()
    if not printed:
        return None
    columns = (
        (Text("journal"), ""),
        (Text("assembly"), ""),
        (Text("d"), "mm"),
        (Text("wall"), "mm"),
        (Text("clearance, from"), "µm"),
        (Text("to"), "µm"),
        (Text("how it is known"), ""),
        (Text("ψ"), "‰"),
        (Text("sheet"), ""),
    )
    design = Text("this design")
    rows = (
        *(_cells(called(j.place), assembly, (j.diameter, None, None, None, j.psi), None, design) for j in own),
        *(_printed_cells(each) for each in printed),
    )
    limits = [span(printed, number) for number, _ in NUMBERS]
    compared = [
        low_high[0] <= value <= low_high[1]
        for j in own
        for value, low_high in zip((j.diameter, j.psi), limits)
        if low_high is not None
    ]
    within = plural(
        "{within} of 1 number of this design (d and ψ) lies from the least to the most of these rows, where three "
        "engines have it.",
        "{within} of {n} numbers of this design (d and ψ) lie from the least to the most of these rows, where three "
        "engines have them.",
        n=len(compared),
        within=Amount(sum(compared), form="g"),
    )
    alone = Text(
        "Makers print no length and no load, so that p, u and W stand for this design alone. ψ is the middle of the "
        "clearance over d. `contralbero makers NAME` tells all of a sheet, and its address."
    )
    note = SPACE.join([within, *map(_alone, own), alone])
    return Table("makers", Text("Journals that makers print for shafts of this ratio"), columns, rows, note)


def _cells(
    journal: Text,
    assembly: str | None,
    numbers: tuple[float | None, ...],
    how: Text | None,
    sheet: Text,
) -> tuple[str | float | None, ...]:
    """A row from numbers in SI: diameter, wall, least and most clearance, relative clearance."""
    shown = (("mm", 4), ("mm", 4), ("µm", 1), ("µm", 1), ("‰", 2))
    d, wall, least, most, psi = (
        None if x is None else round(UNITS[unit].shown(x), digits) for x, (unit, digits) in zip(numbers, shown)
    )
    return journal, assembly and Name(assembly), d, wall, least, most, how, psi, sheet


def _printed_cells(printed: PrintedJournal) -> tuple[str | float | None, ...]:
    sheet, journal = printed.sheet, printed.journal
    name = Text("{engine}, {place}", engine=sheet.name, place=journal.place) if journal.place else Name(sheet.name)
    (least, most), how = journal.stated_clearance or ((None, None), None)
    if how is None and journal.clearance_up_to is not None:
        most, how = journal.clearance_up_to, Text("printed")
    numbers = journal.diameter, journal.wall_middle, least, most, journal.relative_clearance
    return _cells(name, sheet.assembly, numbers, how, Name(f"“{sheet.title}”"))


def _alone(own: OwnJournal) -> Text:
    return Text(
        "{place}: p {p}, u {u}, W {W}.",
        place=titled(own.place),
        p=Amount(UNITS["MPa"].shown(own.p), "MPa", digits=3),
        u=Amount(UNITS["m/s"].shown(own.u), "m/s", digits=3),
        W=Amount(UNITS["N·rpm/mm"].shown(own.W), "N·rpm/mm", digits=3),
    )
