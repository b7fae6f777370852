# SPDX-License-Identifier: Apache-2.0
"""What can go wrong, and how it is said: what was wrong, what is allowed, what to do."""

import re

from .record import record
from .text import EMPTY, SEMICOLON, Name, Text, plural

# Text of the user, made harmless where it leaves the program: what a terminal would obey, or nobody would see, is
# written out.
#
# A character is written as JSON writes it (`\\u202e`), so that a JSON text stays the same object.  What is written out:
# control characters, marks that turn the direction of the text, spaces and fillers without a width, line ends of
# Unicode, tags, halves of surrogate pairs (bytes of a file name that are no text).

UNSEEN = (
    "\x7f-\x9f\xad\u034f\u061c\u115f\u1160\u17b4\u17b5\u180b-\u180f\u200b-\u200f\u2028-\u202e\u2060-\u206f\u3164\ud800-\udfff\ufeff\uffa0"
    "\ufff0-\ufffb\ufffe\uffff\U000e0000-\U000e0fff"
)
IN_A_LINE = re.compile(f"[\x00-\x1f{UNSEEN}]")
IN_LINES = re.compile(f"[\x00-\x08\x0b-\x1f{UNSEEN}]")


def visible(text: str, *, lines: bool = False) -> str:
    """The text with what can not be seen in it written out.  `lines`: it is a text of the program, whose line ends and
    tabs are meant."""
    hidden = IN_LINES if lines else IN_A_LINE
    return hidden.sub(_written, text) if hidden.search(text) else text


def _written(match: re.Match[str]) -> str:
    pairs = match[0].encode("utf-16-be", "surrogatepass")
    return "".join(f"\\u{pairs[n]:02x}{pairs[n + 1]:02x}" for n in range(0, len(pairs), 2))


SHOWN_ERRORS = 50  # of one reading


@record
class InputError:
    """One mistake in the input: its line (0: none), its key, the value found, and the reason with what is allowed."""

    line: int
    key: str
    value: str
    reason: Text

    def text(self, place: str) -> Text:
        where = f"{place}:{self.line}" if self.line else place
        prefix = ": ".join(visible(part) for part in (where, self.key, self.value) if part)
        return Text("{where}: {reason}", where=prefix, reason=self.reason)


class BadInput(Exception):
    """All mistakes of one reading, in the order of their lines; its words are those of the first, and how many more
    there are."""

    def __init__(self, place: str, errors: list[InputError]) -> None:
        self.place = place
        self.errors = sorted(errors, key=lambda e: e.line)
        rest = len(errors) - SHOWN_ERRORS
        more = (
            [plural("{place}: {n} more mistake", "{place}: {n} more mistakes", rest, place=place)] if rest > 0 else []
        )
        super().__init__("\n".join([*(e.text(place) for e in self.errors[:SHOWN_ERRORS]), *more]))


class NoSolution(Exception):
    """The numbers are allowed, but the method finds no solution for them.

    `what` says what was looked for, `tried` where; `advice` what the user can change.
    """

    def __init__(self, what: Text, tried: Text = EMPTY, advice: Text = EMPTY) -> None:
        self.what, self.tried, self.advice = what, tried, advice
        super().__init__(self.text)

    @property
    def text(self) -> Text:
        """What was looked for, where, and what can be changed, in one sentence."""
        return SEMICOLON.join(part for part in (self.what, self.tried, self.advice) if part)


def text_of(error: Exception) -> Text:
    """What an error says: the Text that it was raised with, else its words as they stand."""
    words = getattr(error, "text", None) or (error.args[0] if error.args else "")
    return words if isinstance(words, Text) else Name(str(error))


class Cancelled(Exception):
    """Raised by who listens to the progress of a search, to stop it; the search lets it through."""
