# SPDX-License-Identifier: Apache-2.0
"""What was found, to choose from: the ranked tables of an offer below each other, of which each numbered row can be taken."""

from typing import ClassVar

from textual.binding import Binding, BindingType
from textual.content import Content

from calc.languages.outcome import in_language
from calc.sheet.text import Text

from ..offers.offer import Offer
from .item_list import Item, ItemList
from .table_list import Setter
from .text import wrap

TOP = 40  # rows of a table


class OfferList(ItemList):
    """The key of an item is the number of its row.  What can not be taken has no key."""

    BINDINGS: ClassVar[list[BindingType]] = [
        *ItemList.BINDINGS,
        Binding("shift+right", "columns(1)", "Columns to the right", show=False),
        Binding("shift+left", "columns(-1)", "Columns to the left", show=False),
    ]

    def __init__(self) -> None:
        super().__init__(id="offer-list")
        self.offer: Offer | None = None
        self._column = 1

    def show(self, offer: Offer) -> None:
        self.offer = offer
        self.rebuild()

    def build(self, width: int) -> list[Item]:
        if (offer := self.offer) is None:
            return []
        items: list[Item] = []
        say = self.app.say
        last, taken = 1, set[str]()
        for n, table in enumerate(in_language(one, say) for one in (offer.table(TOP), *offer.beside(TOP))):
            set_ = Setter(table, width, say, self._column)
            last = max(last, set_.last)
            part = say(Text("   ({columns}; Shift+→ ←)", columns=set_.part)) if set_.part else ""
            title = [Content.styled(row, "bold") for row in wrap(f"{table.title}{part}", width)]
            items.append(Item("", [Content(""), *title] if n else title))
            if not n:
                items += [Item("", [Content(row) for row in wrap(say(words), width)]) for words in offer.summary]
            items.append(Item("", set_.head()))
            numbered = bool(table.columns) and table.columns[0][0] == say(Text("no."))
            rows = set_.items()
            for item, cells in zip(rows, table.rows):
                first = cells[0] if numbered else None
                key = f"{first:g}" if isinstance(first, (int, float)) else first if isinstance(first, str) and first.isdigit() else ""
                items.append(Item("" if key in taken else key, item.rows, item.value, item.line))
                taken.add(key)
            items += [Item("", item.rows) for item in rows[len(table.rows) :]]
        for text in ((offer.hidden(TOP),) if offer.hidden(TOP) else ()) + offer.notes:
            items.append(Item("", [Content.styled(row, "dim") for row in wrap(f"· {say(text)}", width, 2)]))
        self._column = min(self._column, last)
        return items

    def action_columns(self, by: int) -> None:
        """Leaf through the columns of tables that are too wide."""
        self._column = max(1, self._column + by)
        self.rebuild()
