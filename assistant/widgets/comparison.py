# SPDX-License-Identifier: Apache-2.0
"""Two designs side by side as one list: inputs, verdicts, checks, values, in each what differs first."""

from collections.abc import Sequence
from dataclasses import dataclass

from textual.content import Content

from calc.compare import CheckDifference, Comparison
from calc.compare_tables import Names, check_table, input_table, value_table, verdict_table
from calc.design import STEPS
from calc.languages.outcome import said_table
from calc.sheet.step import Table

from .item_list import Item, ItemList
from .signs import WORDS
from .table_list import Setter
from .wrap import wrap

SECTIONS = ("Inputs", "Verdicts", "Checks", "Values")
ROOMY = 100  # columns in which the margins have room


@dataclass(frozen=True)
class Part:
    """One table of a section, with the id of each of its rows; a section that has nothing to show has a sentence."""

    section: str
    title: str
    table: Table | None
    ids: tuple[str, ...] = ()


class ComparisonList(ItemList):
    """The key of an item is its section and the id of what it compares."""

    def __init__(self) -> None:
        super().__init__(id="comparison-list")
        self.found: Comparison | None = None
        self.names: Names = ("A", "B")
        self.waiting = ""  # what is said as long as there is nothing to show
        self._heads: dict[str, int] = {}  # section → its first item
        self._at = ""  # the section that was gone to by its key

    def say(self, text: str) -> None:
        """Something instead of a comparison."""
        self.waiting = text
        self.rebuild()

    def show(self, found: Comparison, names: Names) -> None:
        self.found, self.names = found, names
        self.rebuild()

    # --- content
    def build(self, width: int) -> list[Item]:
        say = self.app.say
        if self.found is None or self.found.equal:
            text = say(self.waiting if self.found is None else "The two designs are equal: no input, verdict, check or value differs.")
            return [Item("", [Content(row) for row in wrap(text, width)])]
        items: list[Item] = []
        self._heads = {}
        for part in self._parts(self.found, width >= ROOMY):
            self._heads.setdefault(part.section, len(items))
            gap = [Content("")] if items else []
            if part.table is None:
                items.append(Item("", [*gap, Content.styled(say(part.title), "bold")]))
                continue
            set_ = Setter(said_table(part.table, say), width)
            items.append(Item("", [*gap, Content.styled(say(part.title), "bold underline"), *set_.head()]))
            items += [self._item(part.section, id, str(row[2]), item) for id, row, item in zip(part.ids, part.table.rows, set_.items())]
        return items

    def _item(self, section: str, id: str, now: str, item: Item) -> Item:
        """`now`: what the second design has, which is what is copied."""
        rows = [self._coloured(row) for row in item.rows] if section in ("Verdicts", "Checks") else item.rows
        return Item(f"{section} {id}", rows, now, f"{id}: {item.line}")

    def _sign(self, verdict: str) -> str:
        return f"{self.app.signs.mark(verdict)} {self.app.signs.word(verdict)}"

    def _coloured(self, row: Content) -> Content:
        """Signs in their colours, which only help."""
        for verdict in WORDS:
            sign, start = self._sign(verdict), -1
            while (start := row.plain.find(sign, start + 1)) >= 0:
                row = row.stylize(self.app.signs.style(verdict), start, start + len(sign))
        return row

    def _parts(self, found: Comparison, roomy: bool) -> list[Part]:
        names, n = self.names, len(found.inputs)
        if n:
            title = "1 input differs" if n == 1 else f"{n} inputs differ"
            parts = [Part("Inputs", title, input_table(found.inputs, names, ids=False), tuple(d.key for d in found.inputs))]
        else:
            parts = [Part("Inputs", "No input differs.", None)]
        n = len(found.steps_moved)
        title = "1 step changes its verdict" if n == 1 else f"{n} steps change their verdict" if n else "No step changes its verdict"
        parts.append(Part("Verdicts", title, verdict_table(found, names, self._sign), tuple(v.step for v in found.verdicts)))
        moved, n = found.checks_moved, len(found.checks_moved)
        title = "1 check changes its verdict" if n == 1 else f"{n} checks change their verdict" if n else "No check changes its verdict"
        parts.append(self._checks(title, moved, roomy) if moved else Part("Checks", title, None))
        lone = [d for d in found.checks if not d.both and d.worse]
        if lone:
            parts.append(self._checks(f"{len(lone)} checks stand in one design only, and do not pass", lone, roomy))
        if rest := found.checks_kept:
            parts.append(self._checks(f"{len(rest)} checks keep their verdict at another value or limit", rest, roomy))
        lone = [d for d in found.checks if not d.both and not d.worse]
        if lone:
            parts.append(self._checks(f"{len(lone)} checks stand in one design only, and pass", lone, roomy))
        for step in STEPS:
            values = [d for d in found.values if d.step == step.key]
            if values:
                title = f"{step.title}: 1 value differs" if len(values) == 1 else f"{step.title}: {len(values)} values differ"
                table = value_table(step.key, title, values, names, ids=False)
                parts.append(Part("Values", title, table, tuple(d.id for d in values)))
        if not found.values:
            parts.append(Part("Values", "No value differs.", None))
        return parts

    def _checks(self, title: str, found: Sequence[CheckDifference], roomy: bool) -> Part:
        table = check_table(found, self.names, self._sign, ids=False, margins=roomy)
        return Part("Checks", title, table, tuple(d.id for d in found))

    # --- sections
    @property
    def section(self) -> str:
        """The section that was gone to, else that of the item under the cursor."""
        return self._at or self.key.partition(" ")[0] or SECTIONS[0]

    @property
    def id_here(self) -> str:
        return self.key.partition(" ")[2]

    def _move(self, index: int, *, top: bool = False) -> None:
        self._at = ""
        super()._move(index, top=top)

    def to_section(self, name: str) -> None:
        """To the head of a section, with the cursor on its first item; one may have none."""
        head = self._heads.get(name)
        if head is None:
            return
        index = next((i for i in range(head, len(self.items)) if self.items[i].key), -1)
        if index >= 0 and self.items[index].key.startswith(name):
            self._move(index)
        self._at = name
        self.scroll_to(y=self._first[head], animate=False)
        self.post_message(self.Moved(self))

    def turn_section(self, by: int) -> None:
        """To the next section, or the one before."""
        here = SECTIONS.index(self.section)
        self.to_section(SECTIONS[max(0, min(len(SECTIONS) - 1, here + by))])
