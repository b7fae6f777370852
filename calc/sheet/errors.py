# SPDX-License-Identifier: Apache-2.0
"""What can go wrong, and how it is said: what was wrong, what is allowed, what to do."""

from .record import record
from .text import EMPTY, SEMICOLON, Name, Text, plural
from .visible import visible

SHOWN_ERRORS = 50  # of one reading


@record
class InputError:
    """One mistake in the input: its line (0: none), its key, the value found, and the reason with what is allowed.

    `called`: the key as it is told, where elements of arrays stand by their names and not by index; empty: as it is."""

    line: int
    key: str
    value: str
    reason: Text
    called: str = ""

    def text(self, place: str) -> Text:
        where = f"{place}:{self.line}" if self.line else place
        prefix = ": ".join(visible(part) for part in (where, self.called or self.key, self.value) if part)
        return Text("{where}: {reason}", where=prefix, reason=self.reason)


def written(value: object) -> str:
    """A value that was found, as a file has it, cut where it is long."""
    if isinstance(value, dict):
        return Text("a table")
    text = f'"{value}"' if isinstance(value, str) else str(value).lower() if isinstance(value, bool) else str(value)
    return text if len(text) <= 60 else text[:57] + "…"


class Mistakes(Exception):
    """All mistakes of one reading, in the order of their lines; its words are those of the first, and how many more
    there are."""

    def __init__(self, place: str, errors: list[InputError]) -> None:
        self.place = place
        self.errors = sorted(errors, key=lambda e: e.line)
        words = [e.text(place) for e in self.errors[:SHOWN_ERRORS]]
        if (rest := len(errors) - SHOWN_ERRORS) > 0:
            words.append(plural("{place}: {n} more mistake", "{place}: {n} more mistakes", rest, place=place))
        super().__init__("\n".join(words))


class BadInput(Mistakes):
    """Mistakes in what a user gave."""


class BadTable(Mistakes):
    """Mistakes in a table that comes with the program: no other input would help, so no search goes on after it."""


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
