# SPDX-License-Identifier: Apache-2.0
"""The app as its widgets and dialogs know it: the user's language, signs and keys, and what is told for a moment.

`app.ContralberoApp` adds the screens.  Widgets and dialogs annotate `app: BaseApp` and so need not import the screens
that hold them.  Every console of it writes out the characters that a terminal would obey."""

import re
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from rich.cells import cell_len
from rich.segment import Segment
from textual.app import App
from textual.color import Color
from textual.filter import LineFilter
from textual.notifications import SeverityLevel
from textual.screen import Screen

from calc.locale import LANGUAGES, language
from calc.sheet.in_ascii import in_ascii
from calc.sheet.text import EMPTY, Text
from calc.sheet.visible import visible

from .actions import BY_ID, OLD_IDS, key_name
from .session.recovery import Memory, Settings
from .session.session import Session
from .widgets.signs import Signs

# --- what the screen writes
# Characters that a terminal would obey are written out: a name in a design file may hold any.

BLANKS = re.compile(" {2,}")

# seconds after a key in which the next one may come: until then a field does not complain of what is half typed, and
# what nobody waits for leaves the processor to the keys
TYPING = 0.6


class Legible(LineFilter):
    """The line stays as wide as it was: what is written out takes its room from blanks beside it, else from the line's
    end."""

    def apply(self, segments: list[Segment], background: Color) -> list[Segment]:
        if all(segment.control or segment.text.isprintable() for segment in segments):
            return segments
        printable, owed = [], 0
        for segment in segments:
            text = segment.text if segment.control else visible(segment.text)
            owed += cell_len(text) - cell_len(segment.text)
            if owed and not segment.control:
                text, owed = _shortened(text, owed)
            printable.append(Segment(text, segment.style, segment.control))
        return Segment.adjust_line_length(printable, Segment.get_line_length(segments)) if owed else printable


def _shortened(text: str, owed: int) -> tuple[str, int]:
    """The text with fewer blanks where several follow each other, and how many cells are still too many."""

    def fewer(blanks: re.Match[str]) -> str:
        nonlocal owed
        taken = min(owed, len(blanks[0]) - 1)
        owed -= taken
        return blanks[0][taken:]

    return BLANKS.sub(fewer, text), owed


class Ascii(LineFilter):
    """What is left of other letters, where texts are in ASCII already: names of the user in fields, lines and bars.
    Each takes the cells that it took."""

    def apply(self, segments: list[Segment], background: Color) -> list[Segment]:
        if all(segment.text.isascii() for segment in segments):
            return segments
        return [Segment(_cells(segment.text), segment.style, segment.control) for segment in segments]


LINES = str.maketrans(
    {
        **dict.fromkeys("─━╍┈╌▁▂▃", "-"),
        **dict.fromkeys("│┃▏▎▍▕", "|"),
        **dict.fromkeys("┌┐└┘├┤┬┴┼┏┓┗┛┣┫┳┻╋", "+"),
        **dict.fromkeys("▄▅▆▇█▒▀▐▌▊", "#"),
        "░": ".",
        "…": "~",
    }
)


def _cells(text: str) -> str:
    """As many cells in ASCII."""
    if text.isascii():
        return text
    letters = (in_ascii(letter)[:1].ljust(cell_len(letter)) for letter in text.translate(LINES))
    return "".join(letters)


# --- the app

LEGIBLE, PLAIN = Legible(), Ascii()


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
        self.struck = 0.0  # when the last key was struck, by `time.monotonic`
        self.guiding = settings.guide  # each form begins with what is to be decided in its step

    def get_line_filters(self) -> Sequence[LineFilter]:
        return [*super().get_line_filters(), LEGIBLE, *([PLAIN] if self.ascii else [])]

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

    def release(self) -> None:
        """Let the keys go on that came while a chosen command was still to be run."""
        raise NotImplementedError

    def begin(self, *, engines: bool = False) -> None:
        """The start page, over the design that is open; at its engines."""
        raise NotImplementedError

    def shown_key(self, id: str) -> str:
        """The first key of an action, as the table and the user's key map have it."""
        return key_name((self.key_map.get(id) or BY_ID[id].binding).split(",")[0])

    def forget(self, *texts: Text) -> None:
        """Take these notifications back if they are still shown."""
        shown = set(map(self.say, texts))
        for notification in [n for n in self._notifications if n.message in shown]:
            self._unnotify(notification)

    def tell(self, text: Text, severity: SeverityLevel = "information") -> None:
        """Show a text for a moment; it is never read as markup."""
        self.forget(text)  # the same text is not shown twice at a time
        for past in [
            notification for notification in self._notifications if notification.severity == severity == "information"
        ]:
            self._unnotify(past)  # what was done before that is no news
        self.notify(self.say(text), severity=severity, markup=False, timeout=10 if severity == "error" else 4)
