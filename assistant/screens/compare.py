# SPDX-License-Identifier: Apache-2.0
"""The design beside another one, differences first: the list of what differs, and the screen that shows it.

What has to be solved is solved in another thread."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import ClassVar

from textual import work
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.message import Message
from textual.screen import Screen
from textual.style import Style
from textual.widgets import Static

from calc.design.model import STEPS
from calc.locale.language import in_language
from calc.sheet.step import Table
from calc.sheet.text import EMPTY, Name, Text, plural
from calc.studies.compare import CheckDifference, Comparison
from calc.studies.compare import compare as compared
from calc.studies.compare_tables import (
    Names,
    check_table,
    differing,
    input_table,
    moved,
    moved_table,
    result_table,
    sentences,
    value_table,
    verdict_table,
)

from ..actions import BY_ID, bound
from ..base_app import BaseApp
from ..session.compare_with import Chosen
from ..session.session import Session
from ..session.solving import Job, run
from ..widgets.item_list import Item, ItemList
from ..widgets.signs import WORDS
from ..widgets.table_list import Setter
from ..widgets.text import fit, wrap
from .dialogs import Once

# --- two designs side by side as one list
# What it comes to; inputs, verdicts, checks, values, in each what differs first.

SECTIONS = {
    "Conclusion": Text("Conclusion"),
    "Inputs": Text("Inputs"),
    "Verdicts": Text("Verdicts"),
    "Checks": Text("Checks"),
    "Values": Text("Values"),
}
ROOMY = 100  # columns in which the margins have room


@dataclass(frozen=True)
class ComparisonPart:
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

    def show(self, comparison: Comparison, names: Names) -> None:
        self.found, self.names = comparison, names
        self.rebuild()

    # --- content
    def build(self, width: int) -> list[Item]:
        say = self.app.say
        if self.found is None or self.found.equal:
            text = say(
                self.waiting
                if self.found is None
                else Text("The two designs are equal: no input, verdict, check or value differs.")
            )
            return [Item("", [Content(row) for row in wrap(text, width)])]
        summary = sentences(self.found, self.names, self._sign)
        items = [Item("", [self._coloured(Content(row)) for text in summary for row in wrap(say(text), width)])]
        self._heads = {"Conclusion": 0}
        for part in self._parts(self.found, width >= ROOMY):
            self._heads.setdefault(part.section, len(items))
            gap = [Content("")] if items else []
            if part.table is None:
                items.append(Item("", [*gap, Content.styled(say(part.title), "bold")]))
                continue
            set_ = Setter(in_language(part.table, say), width, say)
            items.append(Item("", [*gap, Content.styled(say(part.title), "bold underline"), *set_.head()]))
            items += [
                self._item(part.section, id, str(row[2]), item)
                for id, row, item in zip(part.ids, part.table.rows, set_.items())
            ]
            if part.table.note:
                items.append(Item("", [Content.styled(row, "dim") for row in wrap(say(part.table.note), width)]))
        return items

    def _item(self, section: str, id: str, now: str, item: Item) -> Item:
        """`now`: what the second design has, which is what is copied."""
        rows = (
            [self._coloured(row) for row in item.rows] if section in ("Conclusion", "Verdicts", "Checks") else item.rows
        )
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

    def _parts(self, comparison: Comparison, roomy: bool) -> list[ComparisonPart]:
        names, n = self.names, len(comparison.inputs)
        parts = []
        if checks := moved(comparison):
            table = moved_table(comparison, names, self._sign)
            parts.append(ComparisonPart("Conclusion", table.title, table, tuple(d.id for d in checks)))
        if results := differing(comparison):
            table = result_table(comparison, names)
            parts.append(ComparisonPart("Conclusion", table.title, table, tuple(r.either.id for r in results)))
        if n:
            title = plural("{n} input differs", "{n} inputs differ", n=n)
            parts.append(
                ComparisonPart(
                    "Inputs",
                    title,
                    input_table(comparison.inputs, names, ids=False),
                    tuple(d.key for d in comparison.inputs),
                )
            )
        else:
            parts.append(ComparisonPart("Inputs", Text("No input differs."), None))
        n = len(comparison.steps_moved)
        changes = plural("{n} step changes its verdict", "{n} steps change their verdict", n=n)
        title = changes if n else Text("No step changes its verdict")
        parts.append(
            ComparisonPart(
                "Verdicts",
                title,
                verdict_table(comparison, names, self._sign),
                tuple(v.step for v in comparison.verdicts),
            )
        )
        checks_moved, n = comparison.checks_moved, len(comparison.checks_moved)
        changes = plural("{n} check changes its verdict", "{n} checks change their verdict", n=n)
        title = changes if n else Text("No check changes its verdict")
        parts.append(
            self._checks(title, checks_moved, roomy) if checks_moved else ComparisonPart("Checks", title, None)
        )
        lone = [d for d in comparison.checks if not d.both and d.worse]
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
        if rest := comparison.checks_kept:
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
        lone = [d for d in comparison.checks if not d.both and not d.worse]
        if lone:
            parts.append(
                self._checks(
                    plural(
                        "{n} check stands in one design only, and passes",
                        "{n} checks stand in one design only, and pass",
                        n=len(lone),
                    ),
                    lone,
                    roomy,
                )
            )
        for step in STEPS:
            values = [d for d in comparison.values if d.step == step.key]
            if values:
                title = plural("{step}: {n} value differs", "{step}: {n} values differ", n=len(values), step=step.title)
                table = value_table(step.key, title, values, names, ids=False)
                parts.append(ComparisonPart("Values", title, table, tuple(d.id for d in values)))
        if not comparison.values:
            parts.append(ComparisonPart("Values", Text("No value differs."), None))
        return parts

    def _checks(self, title: Text, differences: Sequence[CheckDifference], roomy: bool) -> ComparisonPart:
        table = check_table(differences, self.names, self._sign, ids=False, margins=roomy)
        return ComparisonPart("Checks", title, table, tuple(d.id for d in differences))

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


# --- the screen

NOW = Text("now")
GO, TAKE = Text("Go there"), Text("Take it")
TAKEN = "taken"  # what the screen gives where a row is taken
KEYS = (  # of actions; else as they are called
    ("↑↓", Text("Move")),
    ("←→", Text("Section")),
    ("go_on", GO),
    ("copy", Text("Copy")),
    ("leave", Text("Back")),
)


class CompareScreen(Once, Screen[str | None]):
    """Gives the id of what the user wants to go to; None: back to where the session was.

    `on`: the other design is one that may follow on this one, a row of a table: it stands behind it, and Enter gives
    TAKEN."""

    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [
        bound("leave", "back"),
        bound("save", "app.save"),
        bound("close", "back"),
        bound("down", "move(1)"),
        bound("up", "move(-1)"),
        bound("pane", "section(1)"),
        bound("pane_back", "section(-1)"),
        Binding("right,tab", "section(1)", "Next section", show=False),
        Binding("left,shift+tab", "section(-1)", "Previous section", show=False),
        bound("go_on", "go"),
        bound("copy", "copy('value')"),
        bound("copy_line", "copy('line')"),
    ]

    @dataclass
    class Compared(Message):
        """What the other thread found; `failure`: the program itself went wrong."""

        found: "Comparison | None" = field(repr=False)
        failure: Text = EMPTY

    def __init__(self, session: Session, other: Chosen, *, on: bool = False) -> None:
        super().__init__()
        self.other, self.on = other, on
        self.data, self.made, self.results = session.data, session.design, session.results
        self.current = session.current
        self.counts: dict[str, int] = {}

    def compose(self) -> ComposeResult:
        self.set_class(self.app.ascii, "-ascii")
        yield Static(id="compare-title")
        yield Static(id="compare-sections")
        yield ComparisonList()
        yield Static(id="compare-here")
        keys = [
            Content.assemble((self.app.say(key), "bold $footer-key-foreground"), " ", self.app.say(word))
            for key, word in (
                (self.app.shown_key(id) if id in BY_ID else id, TAKE if self.on and word is GO else word)
                for id, word in KEYS
            )
        ]
        yield Static(Content(" ") + Content("  ").join(keys), id="compare-keys")

    def on_mount(self) -> None:
        self.query_one(ComparisonList).focus()
        self.query_one(ComparisonList).say(Text("Solving …"))
        self.show_title()
        self._compare()

    # --- solving
    @work(thread=True, exclusive=True, group="compare", exit_on_error=False)
    def _compare(self) -> None:
        mine = self.results
        failure = EMPTY
        if mine is None or not self.current:
            answer = run(Job(0, self.made, mine))
            mine, failure = answer.results, answer.failure
        theirs = run(Job(0, self.other.design, mine))
        failure = failure or theirs.failure
        if mine is None or theirs.results is None:
            self.post_message(self.Compared(None, failure))
            return
        before, after = (self.other.data, theirs.results), (self.data, mine)
        if self.on:
            before, after = after, before
        self.post_message(self.Compared(compared(before[0], after[0], before[1], after[1])))

    def on_compare_screen_compared(self, event: Compared) -> None:
        event.stop()
        shown = self.query_one(ComparisonList)
        if event.found is None:
            shown.say(event.failure)
            return
        comparison = event.found
        counts = (len(comparison.inputs), len(comparison.steps_moved), len(comparison.checks), len(comparison.values))
        self.counts = dict(zip(list(SECTIONS)[1:], counts))
        shown.show(comparison, (NOW, self.other.name) if self.on else (self.other.name, NOW))
        self.show_place()

    # --- showing
    def show_title(self) -> None:
        width, say = self.app.size.width, self.app.say
        if self.on:
            there = Text("{now} → {row}: what it changes", now=NOW, row=self.other.name)
            title = f" {say(there).replace('→', self.app.signs.mark('then'))}"
        else:
            other = say(Text("{name}: {title}", name=self.other.name, title=self.other.title))
            title = f" {other}   {say(Text('beside the design as it is now'))}"
        self.query_one("#compare-title", Static).update(Content.styled(fit(title, width), "bold"))

    def show_place(self) -> None:
        """The sections with what differs in each, and what the cursor is on."""
        shown = self.query_one(ComparisonList)
        mark = self.app.signs.mark("cursor")
        parts = []
        for name in SECTIONS:
            here = name == shown.section and bool(self.counts)
            text = f"{mark if here else ' '}{self.app.say(SECTIONS[name])} {self.counts.get(name, '')}"
            part = Content.styled(text.rstrip(), "bold" if here else "not bold dim")
            parts.append(part.stylize(Style.from_meta({"@click": f"screen.to_section('{name}')"})))
        self.query_one("#compare-sections", Static).update(Content("  ").join(parts), layout=False)
        self.query_one("#compare-here", Static).update(Content.styled(f" {shown.id_here}", "dim"), layout=False)

    def on_item_list_moved(self, event: ItemList.Moved) -> None:
        event.stop()
        self.show_place()

    def on_item_list_chosen(self, event: ItemList.Chosen) -> None:
        """A click chooses; only Enter leaves the screen."""
        event.stop()

    def on_resize(self) -> None:
        self.show_title()

    # --- keys
    def action_move(self, by: int) -> None:
        self.query_one(ComparisonList).move(by)

    def action_section(self, by: int) -> None:
        self.query_one(ComparisonList).turn_section(by)

    def action_to_section(self, name: str) -> None:
        self.query_one(ComparisonList).to_section(name)

    def action_copy(self, what: str) -> None:
        item = self.query_one(ComparisonList).item
        text = (item.value if what == "value" else item.line) if item is not None else ""
        if not text:
            self.app.tell(Text("There is nothing to copy here."))
            return
        self.app.copy_to_clipboard(text)
        self.app.tell(Text("Copied: {text}", text=text))

    def action_go(self) -> None:
        if self.on:
            self.dismiss(TAKEN)
        elif id := self.query_one(ComparisonList).id_here:
            self.dismiss(id)

    def action_back(self) -> None:
        self.dismiss(None)
