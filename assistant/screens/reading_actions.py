# SPDX-License-Identifier: Apache-2.0
"""Actions that change nothing: explaining, comparing, help, palette, copying, the end."""

from typing import Any

from calc.design.model import STEPS
from calc.sheet.text import Text

from ..session.calculation import VALUES
from ..session.versions import Chosen
from ..widgets.calculation import Calculation
from ..widgets.checks import Checks
from ..widgets.item_list import ItemList
from ..widgets.table_list import TableList
from .background_solve import BackgroundSolve
from .host import Host
from .moves import WRITING, Moves


class ReadingActions:
    def __init__(self, host: Host, moves: Moves, background: BackgroundSolve) -> None:
        self._host, self._moves, self._background = host, moves, background

    # --- comparing and explaining
    def compare(self) -> None:
        """Ask what to compare with, show the comparison, and go where the user wants to."""
        from .compare import CompareScreen
        from .path_dialogs import CompareWith

        app, session = self._host.app, self._host.session
        if not session.valid:
            place, reason = next(iter(session.reasons().items()))
            app.tell(
                Text(
                    "Nothing to compare while the input is not valid: {key} {reason}",
                    key=".".join(map(str, place)),
                    reason=reason,
                ),
                "error",
            )
            return

        async def go(id: str | None) -> None:
            if id is not None and id.partition(".")[0] in {step.key for step in STEPS}:
                await self._moves.to_value(id)

        def show(other: Chosen | None) -> None:
            if other is not None:
                app.push_screen(CompareScreen(session, other), go)

        app.push_screen(CompareWith(session), show)

    def explain(self) -> None:
        """Where the number comes from that the cursor is on; then, if one was chosen, to the field of an input."""
        host = self._host
        subject = self._subject()
        if not subject and isinstance(host.focused, Calculation) and self._background.page is None:
            host.app.tell(WRITING)
            return
        if not subject:
            host.app.tell(
                Text("There is nothing to explain here: go to a check, a line of the calculation or a value.")
            )
            return
        from .explain import Explain

        host.app.push_screen(Explain(host.session, **subject), self._explained)

    async def _explained(self, key: str | None) -> None:
        if key is not None:
            await self._moves.to_value(key)

    def _subject(self) -> dict[str, Any]:
        """What is to be explained: the check, the line or the value under the cursor."""
        host, page = self._host, self._background.page
        results, focused = host.session.results, host.focused
        if results is None or not isinstance(focused, ItemList):
            return {}
        lines = page.whole.lines if page is not None else ()
        if isinstance(focused, Checks):
            check = next((c for c in results.checks() if c.id == focused.key), None)
            if check is None:
                return {}
            index = page.sheet.line_of.get(check.id) if page is not None else None
            return {"check": check} | ({"line": lines[index]} if index is not None else {})
        if (
            isinstance(focused, Calculation) and page is not None
        ):  # else those are lines of older results, as they are without a row to see
            numbers = [entry.number for entry in page.sheet.entries]
            return {"line": lines[numbers.index(focused.key)]} if focused.key in numbers else {}
        if isinstance(focused, TableList) and focused.table is not None and focused.table.id == VALUES:
            return {"value": focused.table.rows[int(focused.key.rpartition(" ")[2])][-1]}
        if focused.key in host.session.values():
            return {"value": focused.key}
        return {}

    # --- help, palette, copy, end
    def help(self) -> None:
        from .help import HelpScreen

        self._host.app.push_screen(HelpScreen(self._host))

    def palette(self) -> None:
        self._host.app.action_command_palette()

    def copy(self, what: str) -> None:
        """Copy the `value` or the whole `line` that the user is at."""
        host = self._host
        focused, pane = host.focused, host.curve_pane
        text = ""
        if isinstance(focused, ItemList) and focused.item is not None:
            text = getattr(focused.item, what) or focused.item.line
        elif host.pane_layout.pane == "curve" and (leaf := pane.leaf) is not None:
            reading = pane.reading
            line = (
                Text("{curve}: {reading}", curve=leaf.title, reading=reading.line)
                if reading is not None
                else leaf.title
            )
            text = host.app.say(reading.value if reading is not None and what == "value" else line)
        else:
            place = host.form.here() or host.form.last
            if place is not None and (place[-1] is not None) and host.session.text(place):
                about = host.session.about(place)
                value = f"{host.session.text(place)} {about.unit}".rstrip()
                text = value if what == "value" else f"{about.label} {value}"
        if not text:
            host.app.tell(Text("There is nothing to copy here."))
            return
        host.app.copy_to_clipboard(text)
        host.app.tell(Text("Copied: {text}", text=text))

    async def quit(self) -> None:
        await self._host.app.action_quit()
