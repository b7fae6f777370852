# SPDX-License-Identifier: Apache-2.0
"""Building a missing step, or the crank and shaft of a balancing, in another thread: that may take a second."""

from functools import partial

from calc.sheet.text import Text

from ..editing import Plan
from ..session import Session
from .host import Host

BUILDING = Text("It is being built by the rules …")


class Building:
    def __init__(self, host: Host) -> None:
        self._host = host

    def ask(self, step: str, balancing: str) -> None:
        host = self._host
        host.app.tell(BUILDING)
        host.in_thread("build", partial(self._build, host.session, step, balancing))

    def _build(self, session: Session, step: str, balancing: str) -> None:
        """Runs in another thread."""
        try:
            plan = session.plan(step, balancing)
        except Exception as error:  # a mistake of the program must not take the user's work with it
            why = Text("the program made a mistake: {kind}: {error}", kind=type(error).__name__, error=str(error))
            plan = Plan({}, {}, why)
        self._host.call_later(self._built, session, plan)

    def _built(self, session: Session, plan: Plan) -> None:
        host = self._host
        host.app.forget(BUILDING)
        if session is not host.session or not host.stands:
            return
        if why := plan.why or session.take(plan):
            host.app.tell(why, "warning")
            return
        host.form.focus(scroll_visible=False)
        host.edited()
