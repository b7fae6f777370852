# SPDX-License-Identifier: Apache-2.0
"""Balance-shaft journals as makers print them in their service sheets: facts to set a design beside.

No sheet prints the length of a journal or its load.  What is not printed is None, or empty, and never interpolated.
Read without numpy."""

import math
from collections.abc import Callable, Iterable
from functools import cache

from ..sheet.quantity import choice, inputs, quantity, series, tables, text
from ..sheet.record import record
from ..sheet.text import EMPTY, Text
from ..sheet.units import Metre, Number, RevPerSecond
from .catalogue import CatalogueRows

ASSEMBLIES = ("threaded", "cartridge", "split", "caps", "module")  # as of the key `assembly` of a shaft
CONFIDENCE = Text("as collected for this program; the address was not opened again")
FEWEST = 3  # engines that print a number, before its least and most say anything
SAME_RATIO = 1e-6  # ratios of whole teeth are closer to 1 or 2 than this, or they are others

Limits = tuple[Metre, Metre]  # least and most


@inputs
class MakerJournal:
    """A journal of a sheet with what it runs in.  Lists are limits, least and most; of several classes the limits of
    each in turn, smallest first.  Clearances are diametral, at 20 °C."""

    place: str = text("Place", default=EMPTY, help="As the sheet tells journals, shafts or parts apart.")
    journal: tuple[Metre, ...] = series("Journal", "mm", default=())
    nominal: Metre | None = quantity("Diameter without limits", "mm", default=None, above=0)
    journal_limit: Metre | None = quantity("Journal, worn to", "mm", default=None, above=0)
    bore: tuple[Metre, ...] = series("Bore that it runs in", "mm", default=())
    housing: tuple[Metre, ...] = series("Bore that its bush or shells sit in", "mm", default=())
    wall: tuple[Metre, ...] = series("Wall of its bush or shell", "mm", default=())
    clearance: tuple[Metre, ...] = series("Clearance", "mm", default=())
    clearance_up_to: Metre | None = quantity("Clearance, up to", "mm", default=None, above=0)

    @property
    def diameter(self) -> Metre | None:
        """The middle of its limits, over all classes; else the diameter without limits."""
        return _middle(_ends(self.journal)) if self.journal else self.nominal

    @property
    def wall_middle(self) -> Metre | None:
        return _middle(_ends(self.wall)) if self.wall else None

    @property
    def clearance_of_bore(self) -> Limits | None:
        """Least and most of the bore less the journal."""
        return _between(_ends(self.bore), _ends(self.journal)) if self.bore and self.journal else None

    @property
    def clearance_of_shells(self) -> Limits | None:
        """Least and most of the housing's bore less two walls less the journal: as if the housing did not give way."""
        if not (self.housing and self.wall and self.journal):
            return None
        (least, most), (thin, thick) = _ends(self.housing), _ends(self.wall)
        return _between((least - 2 * thick, most - 2 * thin), _ends(self.journal))

    @property
    def stated_clearance(self) -> tuple[Limits, Text] | None:
        """Least and most clearance, and how it is known: as printed, else by the diameters that are printed."""
        ways = (
            (_ends(self.clearance) if self.clearance else None, Text("printed")),
            (self.clearance_of_bore, Text("bore less journal")),
            (self.clearance_of_shells, Text("housing less two walls less journal")),
        )
        return next(((limits, how) for limits, how in ways if limits is not None), None)

    @property
    def relative_clearance(self) -> Number | None:
        """The middle of its clearance over its diameter."""
        if self.stated_clearance is None or self.diameter is None:
            return None
        return _middle(self.stated_clearance[0]) / self.diameter


@inputs
class MakerSheet:
    """What a maker prints of the balance shafts of an engine.  Texts are the collection's words; `backlash` and
    `end_play` in mm."""

    name: str = text("Engine")
    layout: str = text("Cylinders", default=EMPTY)
    arrangement: str = text("Arrangement")
    ratio: Number = quantity("Speed over that of the crank", above=0)
    speed_max: RevPerSecond | None = quantity("Highest speed", "rpm", default=None, above=0)
    engine_speed: RevPerSecond | None = quantity("That of the engine", "rpm", default=None, above=0)
    assembly: str = choice("Assembly", *ASSEMBLIES)
    bearing: str = text("Bearing")
    service_limit: Metre | None = quantity("Clearance, worn to", "mm", default=None, above=0)
    backlash: str = text("Backlash, mm", default=EMPTY)
    end_play: str = text("End play, mm", default=EMPTY)
    other: str = text("Also", default=EMPTY)
    title: str = text("Sheet")
    address: str = text("Address")
    journals: tuple[MakerJournal, ...] = tables("Journals", MakerJournal, default=())


@record
class PrintedJournal:
    """A journal and the sheet that it stands on."""

    sheet: MakerSheet
    journal: MakerJournal


@cache
def maker_sheets() -> CatalogueRows[MakerSheet]:
    """All sheets, by the names of their engines."""
    return CatalogueRows("makers.toml", "row", MakerSheet)


def journals(ratio: Number, assembly: str | None = None) -> tuple[PrintedJournal, ...]:
    """The journals printed for shafts of this ratio to the crank, whichever way they turn, and of this assembly; None:
    of all."""
    return tuple(
        PrintedJournal(sheet, journal)
        for sheet in maker_sheets().values()
        if math.isclose(sheet.ratio, abs(ratio), rel_tol=SAME_RATIO) and assembly in (None, sheet.assembly)
        for journal in sheet.journals
    )


def span(printed: Iterable[PrintedJournal], number: Callable[[MakerJournal], Number | None]) -> Limits | None:
    """Least and most of a number over printed journals; None where fewer than three engines print it."""
    numbers = [(each.sheet.name, found) for each in printed if (found := number(each.journal)) is not None]
    if len({engine for engine, _ in numbers}) < FEWEST:
        return None
    return min(found for _, found in numbers), max(found for _, found in numbers)


def _ends(limits: tuple[Metre, ...]) -> Limits:
    return min(limits), max(limits)


def _middle(limits: Limits) -> Metre:
    return sum(limits) / 2


def _between(outer: Limits, inner: Limits) -> Limits:
    """Least and most of outer less inner."""
    return outer[0] - inner[1], outer[1] - inner[0]
