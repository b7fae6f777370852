# SPDX-License-Identifier: Apache-2.0
"""The design beside another one, differences first.  What has to be solved is solved in another thread."""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, ClassVar

from textual import work
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.message import Message
from textual.screen import Screen
from textual.style import Style
from textual.widgets import Static

from calc.sheet.text import EMPTY, Name, Text

from ..base_app import BaseApp
from ..session.versions import Chosen
from ..session.session import Session
from ..session.solving import Job, run
from ..widgets.comparison import SECTIONS, ComparisonList
from ..widgets.item_list import ItemList
from ..widgets.text import fit
from .once import Once

if TYPE_CHECKING:
    from calc.studies.compare import Comparison


NOW = Text("now")
KEYS = (
    (Name("↑↓ jk"), Text("Move")),
    (Name("←→ hl"), Text("Section")),
    (Text("Enter"), Text("Go there")),
    (Name("y Y"), Text("Copy")),
    (Text("Esc"), Text("Back")),
)


class CompareScreen(Once, Screen[str | None]):
    """Gives the id of what the user wants to go to; None: back to where the session was."""

    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape,q", "back", "Back", show=False),
        Binding("down,j", "move(1)", "Down", show=False),
        Binding("up,k", "move(-1)", "Up", show=False),
        Binding("right,l,tab", "section(1)", "Next section", show=False),
        Binding("left,h,shift+tab", "section(-1)", "Previous section", show=False),
        *(Binding(str(n), f"to_section('{name}')", name, show=False) for n, name in enumerate(SECTIONS, 1)),
        Binding("enter", "go", "Go there", show=False),
        Binding("y", "copy('value')", "Copy", show=False),
        Binding("Y", "copy('line')", "Copy the line", show=False),
    ]

    @dataclass
    class Compared(Message):
        """What the other thread found; `failure`: the program itself went wrong."""

        found: "Comparison | None" = field(repr=False)
        failure: Text = EMPTY

    def __init__(self, session: Session, other: Chosen) -> None:
        super().__init__()
        self.other = other
        self.data, self.made, self.results = session.data, session.design, session.results
        self.current = session.current
        self.counts: dict[str, int] = {}

    def compose(self) -> ComposeResult:
        self.set_class(self.app.ascii, "-ascii")
        yield Static(id="compare-title")
        yield Static(id="compare-sections")
        yield ComparisonList()
        yield Static(id="compare-here")
        keys = [Content.assemble((self.app.say(key), "bold $footer-key-foreground"), " ", self.app.say(word)) for key, word in KEYS]
        yield Static(Content(" ") + Content("  ").join(keys), id="compare-keys")

    def on_mount(self) -> None:
        self.query_one(ComparisonList).focus()
        self.query_one(ComparisonList).say(Text("Solving …"))
        self.show_title()
        self._compare()

    # --- solving
    @work(thread=True, exclusive=True, group="compare", exit_on_error=False)
    def _compare(self) -> None:
        from calc.studies.compare import compare as compared

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
        self.post_message(self.Compared(compared(self.other.data, self.data, theirs.results, mine)))

    def on_compare_screen_compared(self, event: Compared) -> None:
        event.stop()
        shown = self.query_one(ComparisonList)
        if event.found is None:
            shown.say(event.failure)
            return
        found = event.found
        counts = (len(found.inputs), len(found.steps_moved), len(found.checks), len(found.values))
        self.counts = dict(zip(list(SECTIONS)[1:], counts))
        shown.show(found, (self.other.name, NOW))
        self.show_place()

    # --- showing
    def show_title(self) -> None:
        width, say = self.app.size.width, self.app.say
        other = say(Text("{name}: {title}", name=self.other.name, title=self.other.title))
        title = f" {other}   {say(Text('beside the design as it is now'))}"
        self.query_one("#compare-title", Static).update(Content.styled(fit(title, width), "bold"))

    def show_place(self) -> None:
        """The sections with what differs in each, and what the cursor is on."""
        shown = self.query_one(ComparisonList)
        mark = self.app.signs.mark("cursor")
        parts = []
        for n, name in enumerate(SECTIONS, 1):
            here = name == shown.section and bool(self.counts)
            text = f"{mark if here else ' '}{n} {self.app.say(SECTIONS[name])} {self.counts.get(name, '')}"
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
        if id := self.query_one(ComparisonList).id_here:
            self.dismiss(id)

    def action_back(self) -> None:
        self.dismiss(None)
