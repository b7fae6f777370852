# SPDX-License-Identifier: Apache-2.0
"""A part of the screen with a title, which says whether it has the focus."""

from typing import ClassVar

from rich.cells import cell_len
from textual.containers import Vertical
from textual.content import Content
from textual.widget import Widget
from textual.widgets import Static

from ..base_app import BaseApp
from .text import fit, wrap


def short_of_room(widget: Widget) -> bool:
    """Whether a widget shares the screen with other panes that are no wider than they must be.  It then says what
    matters; the rest where it fills the screen, or on a very wide one."""
    alone = any(node.has_class("-single") for node in widget.ancestors_with_self if isinstance(node, Pane))
    return widget.screen.has_class("-wide") and not alone


class Pane(Vertical):
    """`target` takes the focus for the pane.  `whole`: a title that is too long goes on in further rows, and is not cut
    off."""

    app: BaseApp
    whole: ClassVar[bool] = False

    def __init__(self, title: str, *children: Widget, id: str) -> None:
        self.title = Static(id=f"{id}-title", classes="pane-title")
        super().__init__(self.title, *children, id=id, classes="pane")
        self.name_of = title
        self.right = ""
        self.views = Content("")
        self.here = False
        self._shown = ""

    def mark(self, here: bool) -> None:
        """Say by the title whether this pane has the focus: bold, with a sign before it.  `set_title` draws it."""
        self.here = here
        self.title.set_class(here, "-here")

    @property
    def target(self) -> Widget:
        return next((child for child in self.walk_children(Widget) if child.focusable), self)

    def set_title(self, title: str | None = None, right: str | None = None, views: Content | None = None) -> None:
        """The title, what is to be said beside it, and, where one pane stands for all, the names of the others."""
        self.name_of = self.app.say(title) if title is not None else self.name_of
        self.right = right if right is not None else self.right
        self.views = views if views is not None else self.views
        width = (self.title.size.width or self.size.width) - 2
        if width < 4:
            return
        room = width - (self.views.cell_length + 2 if self.views.plain else 0)
        parts = self.right.split(" · ") if self.right else []
        named = max(8, room - (len(parts[0]) + 3 if parts else 0))
        name, below = fit(self.name_of, named), list[str]()
        if self.whole and cell_len(self.name_of) > named:
            rows = wrap(self.name_of, width if self.views.plain else named)
            name, below = ("", rows) if self.views.plain else (rows[0], rows[1:])
        beside = ""
        for part in parts:
            if cell_len(name) + len(beside) + len(part) + 3 <= room:
                beside += f" · {part}"
        beside = beside if name else beside.removeprefix(" · ")
        if self.views.plain:
            end = self.views
        else:
            beside, end = "", Content.styled(beside.removeprefix(" · "), "not bold")
        gap = max(1, width - cell_len(name) - len(beside) - end.cell_length)
        mark = self.app.signs.mark("cursor") if self.here else " "
        heading = Content.assemble(mark, name, (beside, "not bold"), (" " * gap, "not underline"), end)
        heading = Content("\n").join([heading, *(Content(f" {row}") for row in below)])
        if heading.markup != self._shown:
            self._shown = heading.markup
            self.title.update(heading, layout=1 + len(below) != self.title.size.height)

    def on_mount(self) -> None:
        self.name_of = self.app.say(self.name_of)

    def on_resize(self) -> None:
        self.set_title()
