# SPDX-License-Identifier: Apache-2.0
"""Two designs side by side as one list: what it comes to; inputs, verdicts, checks, values, in each what differs first."""

from collections.abc import Sequence
from dataclasses import dataclass

from textual.content import Content

from calc.studies.compare import CheckDifference, Comparison
from calc.compare_conclusion import differing, moved, moved_table, result_table, sentences
from calc.studies.compare_tables import Names, check_table, input_table, value_table, verdict_table
from calc.design.model import STEPS
from calc.languages.outcome import in_language
from calc.sheet.step import Table
from calc.sheet.text import EMPTY, Name, Text, plural

from .item_list import Item, ItemList
from .signs import WORDS
from .table_list import Setter
from .text import wrap

SECTIONS = {
    "Conclusion": Text("Conclusion"),
    "Inputs": Text("Inputs"),
    "Verdicts": Text("Verdicts"),
    "Checks": Text("Checks"),
    "Values": Text("Values"),
}
ROOMY = 100  # columns in which the margins have room


@dataclass(frozen=True)
class Part:
    """One table of a section, with the id of each of its rows; a section that has nothing to show has a sentence."""

    section: str
    title: Text
    table: Table | None
    ids: tuple[str, ...] = ()


class ComparisonList(ItemList):
    """The key of an item is its section and the id of what it compares."""

    def __init__(self) -> None:
        super().__init__(id="comparison-list")
        self.found: Comparison | None = None
        self.names: Names = (Name("A"), Name("B"))
        self.waiting = EMPTY  # what is shown as long as there is nothing to show
        self._heads: dict[str, int] = {}  # section → its first item
        self._at = ""  # the section that was gone to by its key

    def say(self, text: Text) -> None:
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
            text = say(
                self.waiting if self.found is None else Text("The two designs are equal: no input, verdict, check or value differs.")
            )
            return [Item("", [Content(row) for row in wrap(text, width)])]
        told = sentences(self.found, self.names, self._sign)
        items = [Item("", [self._coloured(Content(row)) for text in told for row in wrap(say(text), width)])]
        self._heads = {"Conclusion": 0}
        for part in self._parts(self.found, width >= ROOMY):
            self._heads.setdefault(part.section, len(items))
            gap = [Content("")] if items else []
            if part.table is None:
                items.append(Item("", [*gap, Content.styled(say(part.title), "bold")]))
                continue
            set_ = Setter(in_language(part.table, say), width, say)
            items.append(Item("", [*gap, Content.styled(say(part.title), "bold underline"), *set_.head()]))
            items += [self._item(part.section, id, str(row[2]), item) for id, row, item in zip(part.ids, part.table.rows, set_.items())]
            if part.table.note:
                items.append(Item("", [Content.styled(row, "dim") for row in wrap(say(part.table.note), width)]))
        return items

    def _item(self, section: str, id: str, now: str, item: Item) -> Item:
        """`now`: what the second design has, which is what is copied."""
        rows = [self._coloured(row) for row in item.rows] if section in ("Conclusion", "Verdicts", "Checks") else item.rows
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
        parts = []
        if checks := moved(found):
            table = moved_table(found, names, self._sign)
            parts.append(Part("Conclusion", table.title, table, tuple(d.id for d in checks)))
        if results := differing(found):
            table = result_table(found, names)
            parts.append(Part("Conclusion", table.title, table, tuple(r.either.id for r in results)))
        if n:
            title = plural("{n} input differs", "{n} inputs differ", n=n)
            parts.append(Part("Inputs", title, input_table(found.inputs, names, ids=False), tuple(d.key for d in found.inputs)))
        else:
            parts.append(Part("Inputs", Text("No input differs."), None))
        n = len(found.steps_moved)
        changes = plural("{n} step changes its verdict", "{n} steps change their verdict", n=n)
        title = changes if n else Text("No step changes its verdict")
        parts.append(Part("Verdicts", title, verdict_table(found, names, self._sign), tuple(v.step for v in found.verdicts)))
        checks_moved, n = found.checks_moved, len(found.checks_moved)
        changes = plural("{n} check changes its verdict", "{n} checks change their verdict", n=n)
        title = changes if n else Text("No check changes its verdict")
        parts.append(self._checks(title, checks_moved, roomy) if checks_moved else Part("Checks", title, None))
        lone = [d for d in found.checks if not d.both and d.worse]
        if lone:
            parts.append(
                self._checks(
                    plural(
                        "{n} check stands in one design only, and does not pass",
                        "{n} checks stand in one design only, and do not pass",
                        n=len(lone),
                    ),
                    lone,
                    roomy,
                )
            )
        if rest := found.checks_kept:
            parts.append(
                self._checks(
                    plural(
                        "{n} check keeps its verdict at another value or limit",
                        "{n} checks keep their verdict at another value or limit",
                        n=len(rest),
                    ),
                    rest,
                    roomy,
                )
            )
        lone = [d for d in found.checks if not d.both and not d.worse]
        if lone:
            parts.append(
                self._checks(
                    plural("{n} check stands in one design only, and passes", "{n} checks stand in one design only, and pass", n=len(lone)),
                    lone,
                    roomy,
                )
            )
        for step in STEPS:
            values = [d for d in found.values if d.step == step.key]
            if values:
                title = plural("{step}: {n} value differs", "{step}: {n} values differ", n=len(values), step=step.title)
                table = value_table(step.key, title, values, names, ids=False)
                parts.append(Part("Values", title, table, tuple(d.id for d in values)))
        if not found.values:
            parts.append(Part("Values", Text("No value differs."), None))
        return parts

    def _checks(self, title: Text, found: Sequence[CheckDifference], roomy: bool) -> Part:
        table = check_table(found, self.names, self._sign, ids=False, margins=roomy)
        return Part("Checks", title, table, tuple(d.id for d in found))

    # --- sections
    @property
    def section(self) -> str:
        """The section that was gone to, else that of the item under the cursor."""
        return self._at or self.key.partition(" ")[0] or next(iter(SECTIONS))

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
        names = list(SECTIONS)
        self.to_section(names[max(0, min(len(names) - 1, names.index(self.section) + by))])
