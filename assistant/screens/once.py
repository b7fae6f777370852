# SPDX-License-Identifier: Apache-2.0
"""Closing a dialog once: Enter that repeats, or comes twice before the first is dealt with, must not close what is behind it."""

from typing import TYPE_CHECKING, Any

from textual.await_complete import AwaitComplete

if TYPE_CHECKING:
    from textual.screen import Screen

    Below = Screen[Any]
else:
    Below = object  # style sheets look at the first base that is a widget, which the dialog names itself


class Once(Below):
    """Stands before `ModalScreen` among the bases of a dialog."""

    def dismiss(self, result: Any = None) -> AwaitComplete:
        return super().dismiss(result) if self.is_active else AwaitComplete()
