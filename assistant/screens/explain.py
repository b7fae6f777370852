# SPDX-License-Identifier: Apache-2.0
"""Where a number comes from: from the value, or the check, back through its formulas to the inputs."""

from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.screen import ModalScreen
from textual.widgets import Static

from calc.design.addresses import quantity_of
from calc.design.key_results import judged
from calc.library.publications import references
from calc.sheet.check import Check
from calc.sheet.errors import BadInput
from calc.sheet.expression import line_text
from calc.sheet.text import Amount, Text, plural
from calc.sheet.value import Line
from calc.studies.explain import Chains, Link, origin

from ..actions import bound
from ..base_app import BaseApp
from ..session.calculation import SheetEntry
from ..session.session import Session
from ..widgets.calculation import Typesetter
from ..widgets.item_list import Item, ItemList
from ..widgets.text import wrap
from .dialogs import Once

# --- the formulas that lead to a value
# The value first, and under each formula the inputs that enter it.

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
                items.append(
                    Item(
                        "",
                        [*([Content("")] if items else []), Content.styled(title, "bold")] if title else [Content("")],
                    )
                )
            formula, numbers, source = map(say, line_text(link.line, say, say.number))
            entry = SheetEntry(f"{len(self.links) - number}", link.line.about, formula, numbers, source)
            block = setter.entry(entry)
            items.append(Item(str(number), block.rows, block.value, block.line))
            items += [self._input(key, number, width) for key in dict.fromkeys(link.inputs)]
        return items + self._sources(width)

    def _sources(self, width: int) -> list[Item]:
        """What the publications behind the chain are, and how we know them."""
        say, rows = self.app.say, []
        for name, (publication, _, known) in references(
            link.line.formula.source for link in reversed(self.links)
        ).items():
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
            label, value = f"{self.app.say(about.label)}  {key}", self.app.say(f"{text} {about.unit}".strip())
        line = f"{label}  {value}".rstrip()
        rows = wrap(f"      {self.app.signs.mark('from')} {line}", width, 8)
        return Item(f"{INPUT}{key} {number}", [Content.styled(row, "italic") for row in rows], value or key, line)


# --- the screen

HINT = Text("Enter walks back to what a line is made of, or to the field of an input; Backspace returns, Esc closes")


class Explain(Once, ModalScreen[str | None]):
    """Gives the key of an input that is to be gone to, None where there is none."""

    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [
        bound("leave", "leave"),
        bound("save", "app.save"),
        bound("close", "leave"),
        Binding("backspace,left", "before", "Back", show=False),
        Binding("right", "follow", "Walk on", show=False),
        bound("go_on", "follow"),
        bound("down", "move(1)"),
        bound("up", "move(-1)"),
        bound("copy", "copy('value')"),
        bound("copy_line", "copy('line')"),
    ]

    def __init__(
        self, session: Session, *, value: str = "", check: Check | None = None, line: Line | None = None
    ) -> None:
        """What is explained: a value by its id, a check, or a line of the calculation."""
        super().__init__()
        assert session.results is not None
        self.session = session
        self.chains = Chains(session.results)
        self.check = check
        self.verdict = judged(check) if check is not None else ""
        self.value = value or (self.chains.behind(check) or "" if check is not None else "")
        first = self.chains.of(self.value) if self.value else self.chains.to(line) if line is not None else []
        self.way: list[list[Link]] = [first]  # the chains that were walked through; the last is shown

    def compose(self) -> ComposeResult:
        with Vertical(classes="dialog -tall"):
            yield Static(id="explain-title")
            yield ChainList(self.session)
            yield Static(Content.styled(self.app.say(HINT), "dim"))

    def on_mount(self) -> None:
        chain = self.query_one(ChainList)
        chain.focus()
        self.show()

    @property
    def room(self) -> int:
        """The cells of a row in the dialog."""
        return max(30, min(110, self.app.size.width * 9 // 10) - 8)

    def show(self) -> None:
        links, say = self.way[-1], self.app.say
        rows: list[Content] = []
        if len(self.way) > 1:
            shown = links[-1].line
            title = say(
                Text("{n} back: {what}", n=len(self.way) - 1, what=shown.about or Text("a line of the calculation"))
            )
            rows = [Content.styled(title, "bold")]
        else:
            rows = self._title()
        count = len(links)
        if count:
            inputs = len(dict.fromkeys(key for link in links for key in link.inputs))
            text = Text(
                "{formulas}, {inputs}; each line stands before those that it is made of",
                formulas=plural("{n} formula", "{n} formulas", n=count),
                inputs=plural("{n} input", "{n} inputs", n=inputs),
            )
            rows.append(Content.styled(say(text), "dim"))
        elif self.value and (taken := origin(self.chains.results, self.value)):
            rows.append(Content(say(Text("Taken from the inputs: {key}", key=taken))))
        else:
            rows.append(Content(say(Text("No single line of the calculation gives this number."))))
        self.query_one("#explain-title", Static).update(Content("\n").join(rows))
        chain = self.query_one(ChainList)
        chain.show(links)
        chain.call_after_refresh(chain.scroll_home, animate=False)

    def _title(self) -> list[Content]:
        rows: list[Content] = []
        say = self.app.say
        if (known := self.chains.values.get(self.value)) is not None:
            text = Text("{label}: {value}", label=known.label, value=Amount(known.shown, known.unit, digits=6))
            rows.append(Content.assemble((say(text), "bold"), (f"   {known.id}", "dim")))
        if (check := self.check) is not None:
            signs = self.app.signs
            sentence = Text(
                "{check}: {value}, {limit}, margin {margin}",
                check=check.name,
                value=Amount(check.value, check.unit),
                limit=check.limit_text(),
                margin=check.margin_text(),
            )
            row = f"{signs.mark(self.verdict)} {signs.word(self.verdict)}  {say(sentence)}"
            rows += [Content.styled(row, signs.style(self.verdict)) for row in wrap(row, self.room, 2)]
            rows += [Content(row) for row in wrap(say(check.to_do), self.room)] if check.to_do else []
            rows.append(Content.styled(say(check.source), "dim"))
        return rows

    # --- walking
    def action_move(self, by: int) -> None:
        self.query_one(ChainList).move(by)

    def action_follow(self) -> None:
        self.query_one(ChainList).choose()

    def on_item_list_chosen(self, event: ItemList.Chosen) -> None:
        event.stop()
        if event.key.startswith(INPUT):
            self.dismiss(event.key.removeprefix(INPUT).rpartition(" ")[0])
            return
        links = self.way[-1]
        number = int(event.key)
        if number == len(links) - 1:
            self.query_one(ChainList).move(1)
            return
        self.way.append(self.chains.to(links[number].line))
        self.show()

    def action_before(self) -> None:
        if len(self.way) > 1:
            self.way.pop()
            self.show()

    def action_copy(self, what: str) -> None:
        item = self.query_one(ChainList).item
        if item is not None:
            text = getattr(item, what) or item.line
            self.app.copy_to_clipboard(text)
            self.app.tell(Text("Copied: {text}", text=text))

    def action_leave(self) -> None:
        self.dismiss(None)
