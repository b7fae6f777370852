# SPDX-License-Identifier: Apache-2.0
"""The formulas that lead to a value, the value first, and under each the inputs that enter it."""

from textual.content import Content

from calc.design.addresses import quantity_of
from calc.studies.explain import Link
from calc.library.publications import references
from calc.sheet.errors import BadInput
from calc.sheet.expression import line_text
from calc.sheet.text import Text

from ..base_app import BaseApp
from ..session.session import Session
from ..session.calculation import Entry
from .calculation import Typesetter
from .item_list import Item, ItemList
from .text import wrap

INPUT = "input "  # an item with this before its key is an input of the design; the others are numbers of links


class ChainList(ItemList):
    app: BaseApp

    def __init__(self, session: Session) -> None:
        super().__init__(id="chain-list")
        self.session = session
        self.links: list[Link] = []  # as they were computed: the value last

    def show(self, links: list[Link]) -> None:
        self.links = links
        self.rebuild()

    def build(self, width: int) -> list[Item]:
        items: list[Item] = []
        setter = Typesetter(self.app.signs, width)
        about, say = "", self.app.say
        for number in reversed(range(len(self.links))):
            link = self.links[number]
            if link.line.about != about:
                about = link.line.about
                shown = say(about)
                title = shown[:1].upper() + shown[1:]
                items.append(Item("", [*([Content("")] if items else []), Content.styled(title, "bold")] if title else [Content("")]))
            formula, numbers, source = line_text(link.line, say, say.number)
            entry = Entry(f"{len(self.links) - number}", link.line.about, formula, numbers, source)
            made = setter.entry(entry)
            items.append(Item(str(number), made.rows, made.value, made.line))
            items += [self._input(key, number, width) for key in dict.fromkeys(link.inputs)]
        return items + self._sources(width)

    def _sources(self, width: int) -> list[Item]:
        """What the publications behind the chain are, and how we know them."""
        say, rows = self.app.say, []
        for name, (publication, _, known) in references(link.line.formula.source for link in reversed(self.links)).items():
            rows += wrap(f"  {name}: {say(publication.described(known))}", width, 6)
        head = [Content(""), Content.styled(say(Text("Sources")), "bold")]
        return [Item("", [*head, *(Content.styled(row, "dim") for row in rows)])] if rows else []

    def _input(self, key: str, number: int, width: int) -> Item:
        """An input that enters a formula: what it is, and what the design has there."""
        try:
            about, text = quantity_of(self.session.data, key), self.session.text(key)
        except (BadInput, KeyError):  # a column of an array, or what a name brings in
            label, value = key, ""
        else:
            label, value = f"{self.app.say(about.label)}  {key}", f"{text} {about.unit}".strip()
        line = f"{label}  {value}".rstrip()
        rows = wrap(f"      {self.app.signs.mark('from')} {line}", width, 8)
        return Item(f"{INPUT}{key} {number}", [Content.styled(row, "italic") for row in rows], value or key, line)
