# SPDX-License-Identifier: Apache-2.0
"""The app as its widgets and dialogs know it: the user's language, signs and keys, and what is told for a moment.

`app.ContralberoApp` adds the screens.  Widgets and dialogs annotate `app: BaseApp` and so need not import the screens
that hold them.  Every console of it writes out the characters that a terminal would obey."""

import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from textual.app import App
from textual.filter import LineFilter
from textual.notifications import SeverityLevel
from textual.screen import Screen
from textual.timer import Timer

from calc.locale import LANGUAGES, language
from calc.sheet.text import EMPTY, Text

from .actions import BY_ID, OLD_IDS, key_name
from .line_filters import LEGIBLE, PLAIN, READABLE
from .session.recovery import Memory, Settings
from .session.session import Session
from .widgets.signs import Signs

# seconds after a key in which the next one may come: until then a field does not complain of what is half typed, and
# what nobody waits for leaves the processor to the keys
TYPING = 0.6
STAYS = 24 * 3600.0  # seconds: what is told until it is forgotten


class BaseApp(App[int]):
    """`session`: none before one is begun.  `ascii`: plain signs.  `key_map`: other keys for some actions, by their
    ids.  `settings`: what the user chose in earlier sessions."""

    def __init__(
        self,
        session: Session | None,
        *,
        ascii: bool = False,
        key_map: dict[str, str] | None = None,
        settings: Settings | None = None,
        memory: Memory | None = None,
    ) -> None:
        self.ascii = ascii
        settings = settings or Settings()
        self.say = language(settings.language if settings.language in LANGUAGES else "en", ascii)
        self.signs = Signs(ascii, say=self.say)
        self.key_map = {new: keys for id, keys in (key_map or {}).items() if (new := OLD_IDS.get(id, id)) in BY_ID}
        super().__init__()
        self._session = session
        self.memory = session.memory if session is not None else memory or Memory()
        self.warned_of: Path | None = None  # the file that another program has changed, once the user has been told
        self.writing = EMPTY  # a file that is being written, and how far it is
        self.struck, self.struck_key = 0.0, ""  # when the last key was struck, by `time.monotonic`, and which
        self.guiding = settings.guide  # the form of a step that is there says, too, what is good in it

    def fit_signs(self) -> None:
        """The signs of the language, the theme and the terminal as they are now."""
        sixteen = self.console.color_system in ("standard", "windows")
        self.signs = Signs(self.ascii, self.current_theme.dark, not self.no_color, self.say, sixteen)

    def get_line_filters(self) -> Sequence[LineFilter]:
        readable = READABLE[self.current_theme.dark]
        return [*super().get_line_filters(), readable, LEGIBLE, *([PLAIN] if self.ascii else [])]

    def _fatal_error(self) -> None:
        """A fault of the program ends the session without textual's trace over the screen: `app.run` says it in one
        line."""
        self._close_messages_no_wait()

    @property
    def typing(self) -> bool:
        return time.monotonic() < self.struck + TYPING

    def rest(self, screen: Screen[Any]) -> None:
        """Asked in another thread, again and again, by what nobody waits for: between two lines a key may come, and
        need not wait."""
        time.sleep(0.0005)
        while screen.is_attached and self.typing:
            time.sleep(0.02)

    @property
    def session(self) -> Session:
        """The design that is open."""
        assert self._session is not None, "no design is open"
        return self._session

    async def enter(self, session: Session) -> None:
        """Go on with another design."""
        raise NotImplementedError

    async def speak(self, code: str) -> None:
        """Go on in another language."""
        raise NotImplementedError

    @property
    def holding(self) -> Timer | None:
        """For what the keys wait that come now; none where they wait for nothing."""
        raise NotImplementedError

    def release(self, hold: Timer | None) -> None:
        """Let the keys go on that came while a chosen command was still to be run, unless they wait for another one
        by now."""
        raise NotImplementedError

    def begin(self, *, engines: bool = False) -> None:
        """The start page, over the design that is open; at its engines."""
        raise NotImplementedError

    def keys_of(self, id: str) -> list[str]:
        """The keys of an action, as the table and the user's key map have them: what the map gives to another is that
        one's."""
        if id in self.key_map:
            return self.key_map[id].split(",")
        taken = {key for keys in self.key_map.values() for key in keys.split(",")}
        return [key for key in BY_ID[id].binding.split(",") if key not in taken]

    def shown_key(self, id: str) -> str:
        """The first key of an action; of one that has lost its keys to others the way by the palette."""
        if keys := self.keys_of(id):
            return key_name(keys[0])
        return Text("{palette} “{action}”", palette=self.shown_key("palette"), action=BY_ID[id].title)

    def shown_letter(self, id: str) -> str:
        """Its last key, a letter or a sign, which is shorter to strike where nobody types."""
        keys = self.keys_of(id)
        return key_name(keys[-1]) if keys else self.shown_key(id)

    def forget(self, *texts: Text) -> None:
        """Take these notifications back if they are still shown."""
        shown = set(map(self.say, texts))
        for notification in [n for n in self._notifications if n.message in shown]:
            self._unnotify(notification)

    def tell(self, text: Text, severity: SeverityLevel = "information", *, stays: bool = False) -> None:
        """Show a text for a moment, or until it is forgotten; it is never read as markup."""
        self.forget(text)  # the same text is not shown twice at a time
        for past in [
            notification
            for notification in self._notifications
            if notification.severity == severity == "information" and notification.timeout < STAYS
        ]:
            self._unnotify(past)  # what was done before that is no news
        timeout = STAYS if stays else 10 if severity == "error" else 4
        self.notify(self.say(text), severity=severity, markup=False, timeout=timeout)
