# SPDX-License-Identifier: Apache-2.0
"""What the parts of the main screen's actions have in common."""

from typing import TYPE_CHECKING

from ..session import Session

if TYPE_CHECKING:
    from .workbench import Workbench


class Part:
    """Some of the actions.  Mixed into the main screen, and so able to reach all of it."""

    session: Session

    @property
    def _me(self) -> "Workbench":
        return self  # type: ignore[return-value]

    def rebuilt(self) -> None:
        """Show a design that has changed in more than one place."""
        me = self._me
        if (field := me.form.field) is not None:
            field.rewrite()
        me.edited()
        me.form.rebuild(me.form.here())
