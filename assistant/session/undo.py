# SPDX-License-Identifier: Apache-2.0
"""Undo: the states that a design has been through, with the edits of one field in a row as one step."""

from collections.abc import Iterator
from dataclasses import dataclass

from calc.design.addresses import Table
from calc.design.labels import Place
from calc.sheet.text import Text

DEEPEST = 1000  # steps that can be undone


@dataclass(frozen=True)
class EditState:
    """One state of the design: its tables, and the entries that could not be understood, by field."""

    data: Table
    texts: dict[Place, tuple[str, Text]]  # place → (what was typed, why it is not understood)


class History:
    """`state` is the present one."""

    def __init__(self, state: EditState) -> None:
        self.state = state
        self._undo: list[tuple[EditState, Place | None]] = []
        self._redo: list[tuple[EditState, Place | None]] = []
        self._editing: Place | None = None
        self.joined = False  # the last edit went on with the one before it

    def go(self, state: EditState, where: Place | None) -> bool:
        """A new state, reached by an edit at a place; False where nothing has changed."""
        if state == self.state:
            return False
        self.joined = where is not None and where == self._editing
        if not self.joined:
            self._undo.append((self.state, where))
            del self._undo[:-DEEPEST]
        self._redo.clear()
        self._editing = where
        self.state = state
        return True

    def seal(self) -> None:
        """The next edit is a step of its own, at the same place too."""
        self._editing = None

    @property
    def begun(self) -> bool:
        """Whether there is anything to undo."""
        return bool(self._undo)

    @property
    def undone(self) -> bool:
        """Whether there is anything to do again."""
        return bool(self._redo)

    def past(self) -> Iterator[tuple[Table, Table]]:
        """The edits that can be taken back, the last first: the tables before and after each.  Nothing is taken back by
        this."""
        after = self.state
        for before, _ in reversed(self._undo):
            if before.data != after.data:
                yield before.data, after.data
            after = before

    def undo(self) -> Place | None:
        """Back by one step.  Gives the place that changed, () where it is no single one, None where there is nothing to
        undo."""
        return self._travel(self._undo, self._redo)

    def redo(self) -> Place | None:
        return self._travel(self._redo, self._undo)

    def _travel(
        self, back: list[tuple[EditState, Place | None]], forth: list[tuple[EditState, Place | None]]
    ) -> Place | None:
        while back and back[-1][0] == self.state:
            back.pop()
        if not back:
            return None
        state, where = back.pop()
        forth.append((self.state, where))
        self.seal()
        self.state = state
        return where or ()
