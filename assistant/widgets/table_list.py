# SPDX-License-Identifier: Apache-2.0
"""A table of results as aligned columns.  The head stands still above the rows; what is too wide is leafed through by
columns."""

from rich.cells import cell_len
from textual.content import Content

from calc.locale import Language
from calc.sheet.number import short
from calc.sheet.step import Table
from calc.sheet.text import EMPTY, Text

from .item_list import Item, ItemList
from .text import fit, pad, wrap

GAP = 2  # cells between columns
LEAST = 12  # cells of a column of words that is wrapped
Cell = str | float | None


def cell_text(cell: Cell, say: Language) -> str:
    return "" if cell is None else cell if isinstance(cell, str) else say.number(short(cell))


class Setter:
    """Sets a table, whose texts are said in the language already, for a width.

    `first`: the column that follows the frozen one, where not all of them fit.
    """

    def __init__(self, table: Table, width: int, say: Language, first: int = 1) -> None:
        self.table, self.width, self.say = table, width, say
        count = len(table.columns)
        self.units = [say(unit) for _, unit in table.columns]
        cells = [[cell_text(row[i], say) for row in table.rows] for i in range(count)]
        self.numeric = [any(isinstance(row[i], (int, float)) for row in table.rows) for i in range(count)]
        least = [max([cell_len(unit), *map(cell_len, column)]) for unit, column in zip(self.units, cells)]
        whole = [max(size, cell_len(label)) for size, (label, _) in zip(least, table.columns)]
        tight = [max([size, *map(cell_len, label.split())]) for size, (label, _) in zip(least, table.columns)]
        self.widths = whole if self._total(whole) <= width else tight
        while self._total(self.widths) > width and (loose := self._loosest()) is not None:
            self.widths[loose] -= 1
        self.columns = list(range(count))
        self.last = 1  # the largest `first` that is of use
        if self._total(self.widths) > width:
            self.widths[0] = min(self.widths[0], max(LEAST, width // 3))
            while self.last < count - 1 and self._total([self.widths[0], *self.widths[self.last :]]) > width:
                self.last += 1
            self.columns = self._in_view(max(1, min(first, self.last)))

    def _total(self, widths: list[int]) -> int:
        return sum(widths) + GAP * (len(widths) - 1)

    def _loosest(self) -> int | None:
        """The widest column of words that can still be wrapped."""
        loose = [i for i, wide in enumerate(self.widths) if not self.numeric[i] and wide > LEAST]
        return max(loose, key=lambda i: self.widths[i], default=None)

    def _in_view(self, first: int) -> list[int]:
        shown = [0]
        for i in range(first, len(self.widths)):
            if len(shown) > 1 and self._total([self.widths[n] for n in (*shown, i)]) > self.width:
                break
            shown.append(i)
        return shown

    @property
    def part(self) -> Text:
        """Which columns are in view; empty where all are."""
        if len(self.columns) == len(self.widths):
            return EMPTY
        low, high = self.columns[1] + 1, self.columns[-1] + 1
        columns = Text("{low}–{high}", low=low, high=high) if high > low else Text("{low}", low=low)
        return Text("columns {columns} of {n}", columns=columns, n=len(self.widths))

    def _line(self, texts: list[str]) -> str:
        cells = []
        for text, i in zip(texts, self.columns):
            wide = self.widths[i]
            cells.append(
                f"{' ' * (wide - cell_len(text))}{text}"
                if self.numeric[i] and cell_len(text) <= wide
                else pad(text, wide)
            )
        return (" " * GAP).join(cells).rstrip()

    def _block(self, texts: list[str], foot: bool = False) -> list[str]:
        """One row of cells that may be broken into several lines; the head stands on its foot."""
        broken = [
            [fit(row, self.widths[i]) for row in wrap(text, self.widths[i])] for text, i in zip(texts, self.columns)
        ]
        high = max(map(len, broken))
        filled = [[""] * (high - len(rows)) + rows if foot else rows + [""] * (high - len(rows)) for rows in broken]
        return [self._line([rows[n] for rows in filled]) for n in range(high)]

    def head(self) -> list[Content]:
        """The labels, and below them the units."""
        labels: list[str] = [self.table.columns[i][0] for i in self.columns]
        units = [self.units[i] for i in self.columns]
        rows = [Content.styled(row, "bold") for row in self._block(labels, foot=True)]
        return [*rows, Content.styled(self._line(units), "dim")] if any(units) else rows

    def items(self) -> list[Item]:
        columns = self.table.columns
        listed = []
        for n, row in enumerate(self.table.rows):
            texts = [cell_text(cell, self.say) for cell in row]
            labelled = "; ".join(
                f"{label} {text} {unit}".strip() for (label, _), unit, text in zip(columns, self.units, texts) if text
            )
            rows = [Content(line) for line in self._block([texts[i] for i in self.columns])]
            listed.append(Item(f"{self.table.id} {n}", rows, "\t".join(texts), labelled))
        if self.table.note:
            note = [Content.styled(line, "dim") for line in wrap(self.table.note, self.width)]
            listed.append(Item("", [Content(""), *note]))
        return listed


class TableList(ItemList):
    """The rows of a table; `head` is shown above them by the pane.  The key of an item is the table's id and the row's
    number."""

    def __init__(self) -> None:
        super().__init__(id="table-list")
        self.table: Table | None = None
        self.head: list[Content] = []
        self.part = EMPTY
        self._column = 1

    def show(self, table: Table) -> None:
        if table is not self.table:
            if self.table is None or table.id != self.table.id:
                self._column = 1
            self.table = table
            self.rebuild()

    def build(self, width: int) -> list[Item]:
        if self.table is None:
            return []
        set_ = Setter(self.table, width, self.app.say, self._column)
        self._column = min(self._column, set_.last)
        self.head, self.part = set_.head(), set_.part
        return set_.items()

    def columns(self, by: int) -> None:
        """Leaf through the columns of a table that is too wide."""
        self._column = max(1, self._column + by)
        self.rebuild()
