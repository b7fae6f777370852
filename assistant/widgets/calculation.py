# SPDX-License-Identifier: Apache-2.0
"""The calculation of a step: formula, numbers, value, source, line by line, as it was computed; then what is
assumed."""

from collections.abc import Callable

from textual.content import Content

from calc.sheet.errors import Cancelled
from calc.sheet.step import Erratum
from calc.sheet.text import Amount, Text, plural

from ..session.calculation import CalculationSheet, SheetEntry
from .item_list import Item, ItemList
from .signs import Signs
from .text import wrap

BOUND = "\u00a0"  # a space at which no row is broken


class Typesetter:
    """Breaks a calculation into rows.  Knows no screen, so that a long one can be set in another thread."""

    def __init__(self, signs: Signs, width: int) -> None:
        self.signs, self.width = signs, width

    def items(self, sheet: CalculationSheet, stop: Callable[[], bool] = bool) -> list[Item]:
        """Raises Cancelled as soon as `stop` says so."""
        items: list[Item] = []
        about = ""
        for entry in sheet.entries:
            if stop():
                raise Cancelled
            if entry.about != about:
                about = entry.about
                title = about[:1].upper() + about[1:]
                items.append(Item("", [*([Content("")] if items else []), Content.styled(title, "bold")]))
            items.append(self.entry(entry))
        if sheet.errata:
            items.append(Item("", [Content(""), Content.styled(self.signs.say(Text("Errors of the sources")), "bold")]))
            items += [Item(f"erratum {n}", self._erratum(e, 0), line=e.why) for n, e in enumerate(sheet.errata)]
        for title, kind, texts in (
            (Text("Proposed"), "proposal", sheet.proposals),
            (Text("Assumed"), "note", sheet.notes),
        ):
            if texts:
                items.append(Item("", [Content(""), Content.styled(self.signs.say(title), "bold")]))
                items += [
                    Item(f"{kind} {n}", [Content(row) for row in wrap(f"· {text}", self.width, 2)], line=text)
                    for n, text in enumerate(texts)
                ]
        return items

    def entry(self, entry: SheetEntry) -> Item:
        width = self.width
        number = f"{entry.number:<5} "
        indent = len(number)
        rows = [
            Content.assemble((number, "dim"), entry_rows[0].lstrip()) if n == 0 else Content(text)
            for entry_rows in [wrap(" " * indent + entry.formula, width, indent + 2)]
            for n, text in enumerate(entry_rows)
        ]
        before, equals, after = entry.numbers.rpartition("= ")
        numbers = before + equals + after.replace(" ", BOUND, 1)  # a number and its unit stay together
        rows += [Content(text) for text in wrap(" " * (indent + 2) + numbers, width, indent + 4)]
        signs = self.signs
        for check, verdict in entry.checks:
            limit = signs.say(check.limit_text()).replace(" ", BOUND)
            text = f"{signs.mark(verdict)} {signs.word(verdict)}  {check.name} {limit}"
            rows += [
                Content.styled(row, signs.style(verdict)) for row in wrap(" " * (indent + 2) + text, width, indent + 4)
            ]
        for erratum in entry.errata:
            rows += self._erratum(erratum, indent + 2)
        rows += [Content.styled(row, "dim") for row in wrap(" " * (indent + 2) + entry.source, width, indent + 2)]
        return Item(entry.number, rows, entry.value(), entry.text())

    def _erratum(self, erratum: Erratum, indent: int) -> list[Content]:
        signs, width = self.signs, self.width
        text = Text(
            "the source has {value} for {label}: {reason} ({source})",
            value=Amount(erratum.source_value, erratum.unit),
            label=erratum.label,
            reason=erratum.why,
            source=erratum.source,
        )
        row = f"{signs.mark('warn')} {signs.say(text)}"
        return [Content.styled(row, signs.style("warn")) for row in wrap(" " * indent + row, width, indent + 2)]


class Calculation(ItemList):
    """The key of an item is the number of its line."""

    def __init__(self) -> None:
        super().__init__(id="calculation-list")
        self.sheet = CalculationSheet()
        # the calculations set last, with the width and the signs
        self._set: list[tuple[CalculationSheet, int, Signs, list[Item]]] = []

    def show(self, sheet: CalculationSheet) -> None:
        if sheet is not self.sheet:
            self.sheet = sheet
            self._wanted = None  # where to go was meant in the calculation before
            self.rebuild()

    def prepare(self, sheet: CalculationSheet, stop: Callable[[], bool]) -> None:
        """Set a calculation ahead; may be called from another thread."""
        if self._built > 1:
            self._items(sheet, self._built - 1, stop)

    def build(self, width: int) -> list[Item]:
        return self._items(self.sheet, width)

    def _items(self, sheet: CalculationSheet, width: int, stop: Callable[[], bool] = bool) -> list[Item]:
        signs = self.app.signs
        for known, for_width, for_signs, items in self._set:
            if known is sheet and for_width == width and for_signs is signs:
                return items
        items = Typesetter(signs, width).items(sheet, stop)
        self._set = [*self._set[-7:], (sheet, width, signs, items)]
        return items

    # --- what the title says
    def position(self) -> str:
        """Which lines are in view, of how many; and what stands at the end."""
        say = self.app.say
        entries = [i for i, item in enumerate(self.items) if "." in item.key]
        parts = []
        if entries and self._first:
            top, bottom = round(self.scroll_y), round(self.scroll_y) + self.size.height
            seen = [
                n
                for n, i in enumerate(entries, 1)
                if self._first[i] < bottom and self._first[i] + len(self.items[i].rows) > top
            ]
            count = plural("{n} line", "{n} lines", n=len(entries))
            parts.append(
                say(Text("{first}–{last} of {n}", first=seen[0], last=seen[-1], n=len(entries)) if seen else count)
            )
        errata = len(self.sheet.errata) + sum(len(e.errata) for e in self.sheet.entries)
        if errata:
            parts.append(say(plural("{n} erratum", "{n} errata", n=errata)))
        if self.sheet.proposals:
            parts.append(say(Text("{n} proposed", n=len(self.sheet.proposals))))
        if self.sheet.notes:
            parts.append(say(Text("{n} assumed", n=len(self.sheet.notes))))
        return " · ".join(parts)
