# SPDX-License-Identifier: Apache-2.0
"""What can go wrong, and how it is said: what was wrong, what is allowed, what to do."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, order=True)
class InputError:
    """One mistake in the input: its line (0: none), its key, the value found, and the reason with what is allowed."""

    line: int
    key: str
    value: str
    reason: str

    def text(self, place: str) -> str:
        where = f"{place}:{self.line}" if self.line else place
        found = f"{self.value}: " if self.value else ""
        return f"{where}: {self.key}: {found}{self.reason}" if self.key else f"{where}: {found}{self.reason}"


class BadInput(Exception):
    """All mistakes of one reading, in the order of their lines."""

    def __init__(self, place: str, errors: list[InputError]) -> None:
        self.place = place
        self.errors = sorted(errors, key=lambda e: e.line)
        super().__init__("\n".join(e.text(place) for e in self.errors))


class NoSolution(Exception):
    """The numbers are allowed, but the method finds no solution for them.

    `what` says what was looked for, `tried` where; `advice` what the user can change.
    """

    def __init__(self, what: str, tried: str = "", advice: str = "") -> None:
        self.what, self.tried, self.advice = what, tried, advice
        super().__init__("; ".join(part for part in (what, tried, advice) if part))


class Cancelled(Exception):
    """Raised by who listens to the progress of a search, to stop it; the search lets it through."""
