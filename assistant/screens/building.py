# SPDX-License-Identifier: Apache-2.0
"""A step that the design does not have: built by rules, or left out for a reason."""

from functools import partial

from calc.design.addresses import as_table
from calc.design.model import STEPS
from calc.sheet.text import Text

from ..session.editing import BuildPlan
from ..session.session import Session
from ..session.solving import mistake
from .dialogs import Reason
from .host import Host
from .moves import Moves

USUAL = (
    Text("left out on purpose"),
    Text("it is settled elsewhere"),
    Text("to be settled by the supplier"),
    Text("outside what this design is for"),
)
"""Reasons to leave a step out, to be written on."""
TITLES = {step.key: step.title for step in STEPS}
BUILDING = Text("It is being built by the rules …")


class Building:
    def __init__(self, host: Host, moves: Moves) -> None:
        self._host, self._moves = host, moves

    def ask(self, step: str, balancing: str) -> None:
        """Build it, or the crank and shaft of a balancing, in another thread: that may take a second."""
        host = self._host
        host.app.tell(BUILDING)
        host.in_thread("build", partial(self._build, host.session, step, balancing))

    def _build(self, session: Session, step: str, balancing: str) -> None:
        """Runs in another thread."""
        try:
            plan = session.plan(step, balancing)
        except Exception as error:  # a mistake of the program must not take the user's work with it
            why = mistake(error)
            plan = BuildPlan({}, {}, why)
        self._host.call_later(self._built, session, step, plan)

    def _built(self, session: Session, step: str, plan: BuildPlan) -> None:
        host = self._host
        host.app.forget(BUILDING)
        if session is not host.session or not host.stands:
            return
        if why := plan.why or session.take(plan):
            host.app.tell(why, "warning")
            return
        if step and (reason := as_table(session.data.get("without")).get(step)):
            host.app.tell(Text("Left out: {reason}.", reason=str(reason)), "warning")
        host.set_focus(
            host.form, scroll_visible=False
        )  # before the form is put in order, which would bring it back to a field
        host.edited()

    def leave_out(self, step: str) -> None:
        """Ask why."""
        host = self._host
        begun = str(as_table(host.session.data.get("without")).get(step) or host.app.say(USUAL[0]))
        dialog = Reason(Text("Leave this step out: why is it right?"), host.app.say(TITLES[step]), USUAL, begun)
        host.app.push_screen(dialog, partial(self._left_out, host.session, step))

    async def _left_out(self, session: Session, step: str, reason: str | None) -> None:
        if reason is None or session is not self._host.session or not self._host.stands:
            return
        session.leave_out(step, reason)
        self._host.edited()
        await self._moves.lead_on()
