# SPDX-License-Identifier: Apache-2.0
"""What the palette finds: every action, and every field of the design."""

from functools import partial
from typing import TYPE_CHECKING

from textual.command import DiscoveryHit, Hit, Hits, Provider

from calc.addresses import quantities
from calc.sheet.text import Text

from ..actions import ACTIONS, key_names
from .workbench import Workbench

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

HIDDEN = {"palette", "up", "down", "go_on", "leave", "more", "less"}  # of no use from a list
HIDDEN |= {action.id for action in ACTIONS if action.id.startswith("read")}


class Palette(Provider):
    def _found(self) -> "Iterator[tuple[str, str, Callable[[], object]]]":
        """(title, help, what it does)."""
        work = self.screen
        if not isinstance(work, Workbench):
            return
        say = work.app.say
        for action in ACTIONS:
            if action.id not in HIDDEN:
                keys = key_names(action.binding, say)
                title = say(action.title)
                yield f"{title}  ({keys})" if keys else title, say(action.help), partial(work.run_action, action.does)
        for path in work.session.memory.recent():
            if path != work.session.path:
                yield (
                    say(Text("Open recent: {path}", path=str(path))),
                    say(Text("Opens this design again.")),
                    partial(work.files.open_path, path),
                )
        yield (
            say(Text("Put back unsaved edits")),
            say(Text("Edits that were kept aside for another version of this file.")),
            work.files.restore,
        )

    async def discover(self) -> Hits:
        for title, help, does in self._found():
            yield DiscoveryHit(title, does, help=help)

    async def search(self, query: str) -> Hits:
        matcher = self.matcher(query)
        for title, help, does in self._found():
            if (score := matcher.match(title)) > 0:
                yield Hit(score, matcher.highlight(title), does, help=help)
        work = self.screen
        if isinstance(work, Workbench):
            say = work.app.say
            for key, about in quantities(work.session.data):
                title = say(Text("Field: {label}  {key}", label=about.label, key=key))
                if (score := matcher.match(title)) > 0:
                    yield Hit(
                        score * 0.9,
                        matcher.highlight(title),
                        partial(work.moves.to_field, work.session.place(key)),
                        help=say(about.help or about.allowed()),
                    )
