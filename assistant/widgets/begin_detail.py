# SPDX-License-Identifier: Apache-2.0
"""About the way to begin that is under the cursor: what an engine shakes with, what a design comes to.  Found out in another thread."""

from textual.app import ComposeResult
from textual.containers import VerticalScroll
from textual.content import Content
from textual.widgets import Static
from textual.worker import get_current_worker

from calc.sheet.errors import BadInput
from calc.sheet.text import Text

from ..base_app import BaseApp
from ..session.beginnings import Beginning, Finding, finding
from ..session.recovery import Memory
from .text import wrap

ABOUT = {
    "open": Text("A design file, from any folder. Unsaved edits of it that were kept are put back."),
    "example": Text(
        "The counter-shaft of a three-cylinder diesel as it was published, in all six steps. Look at what fails, and why. Nothing is "
        "written before you save, and then under a name of its own."
    ),
    "engine": Text(
        "Enter asks for a name. Then come balancing, shaft, bearings, gears and friction, one question at a time; every number of the "
        "engine can be replaced by your own."
    ),
}
ICON = 15, 7  # cells of the sketch at most where it stands beside the text
TALL = 32, 16  # and below it


class BeginDetail(VerticalScroll, can_focus=False):
    app: BaseApp

    def __init__(self, memory: Memory) -> None:
        super().__init__(id="begin-detail")
        self.memory = memory
        self._known: dict[str, Finding] = {}  # by the key of a row
        self._row: Beginning | None = None

    def compose(self) -> ComposeResult:
        yield Static(id="begin-text")
        yield Static(id="begin-sketch")

    def show(self, row: Beginning) -> None:
        self._row = row
        self.scroll_home(animate=False)
        self._draw()
        if row.key not in self._known and row.kind != "open":
            self.run_worker(lambda: self._find_out(row), thread=True, exclusive=True, exit_on_error=False, group="begin")

    def tell(self, text: Text) -> None:
        """Something to be said in its place."""
        self._row = None
        self._write([Content.styled(line, "bold") for line in wrap(self.app.say(text), self._room(False))])

    def on_resize(self) -> None:
        self._draw()

    @property
    def wide(self) -> bool:
        """It stands beside the rows, not below them."""
        return self.screen.has_class("-wide")

    def _room(self, sketch: bool) -> int:
        return max(10, self.size.width - 3 - (ICON[0] + 1 if sketch and not self.wide else 0))

    def _draw(self) -> None:
        row, say, wide = self._row, self.app.say, self.wide
        if row is None:
            return
        found = self._known.get(row.key)
        room = self._room(found is not None and found.sketch is not None)
        gap = [Content("")] if wide else []
        lines = [Content.styled(line, "bold") for line in wrap(say(row.title), room)]
        if row.kind in ("engine", "file") and (wide or row.kind == "file"):
            lines += [Content(line) for fact in filter(None, (row.about, row.size)) for line in wrap(say(fact), room)] + gap
        about = [Content.styled(line, "dim") for line in wrap(say(ABOUT[row.kind]), room)] if row.kind in ABOUT else []
        if about and row.kind != "engine":
            lines += [*about, *gap]
        if found is None and row.kind != "open":
            lines.append(Content(self.app.signs.mark("more")))
        for text in found.lines if found is not None else ():
            lines += [Content(line) for line in wrap(say(text), room, 2)]
        if row.kind == "engine" and wide:
            lines += [*gap, *about]
        self._write(lines, found)

    def _write(self, lines: list[Content], found: Finding | None = None) -> None:
        self.query_one("#begin-text", Static).update(Content("\n").join(lines))
        picture = self.query_one("#begin-sketch", Static)
        picture.display = found is not None and found.sketch is not None
        if found is not None and found.sketch is not None:
            from .canvas import draw

            columns, rows = TALL if self.wide else (ICON[0], max(2, min(ICON[1], self.size.height)))
            columns = min(columns, self.size.width - 3)
            picture.update(draw(found.sketch, columns, rows, self.app.signs, self.app.say))

    def _find_out(self, row: Beginning) -> None:
        """Runs in another thread."""
        worker = get_current_worker()
        try:
            found = finding(row, self.memory)
        except BadInput as bad:
            found = Finding((bad.errors[0].text(bad.place),))
        if not worker.is_cancelled:
            self.app.call_later(self.know, row, found)

    def know(self, row: Beginning, found: Finding) -> None:
        self._known[row.key] = found
        if self._row is row and self.is_attached:
            self._draw()

    def known(self, row: Beginning) -> Finding:
        """What was found out so far."""
        return self._known.get(row.key, Finding(()))
