# SPDX-License-Identifier: Apache-2.0
"""A line to type on, in a form or a dialog."""

from textual import events
from textual.binding import Binding
from textual.widgets import Input

EDITS = {binding.key: binding.action for binding in Binding.make_bindings(Input.BINDINGS)}


class Line(Input):
    """A line to type on.  Keys that edit act at once, and not when they have come back from all parents: those that
    were struck later would come first."""

    async def _on_key(self, event: events.Key) -> None:
        action = EDITS.get(event.key)
        if action is None or event.is_printable:
            await super()._on_key(event)
            return
        event.stop()
        event.prevent_default()
        await self.run_action(action)
