# SPDX-License-Identifier: Apache-2.0
"""Accepting a finding: what is open stays open on purpose, with a reason that stands in the design and in the
report."""

from collections.abc import Sequence

from calc.locale import Language
from calc.sheet.check import Check
from calc.sheet.remedy import assignment
from calc.sheet.text import EMPTY, Amount, Text, plural

from .dialogs import Reason
from .edit_actions import rebuilt
from .host import Host

USUAL = (
    Text("seen on the test bench: it holds"),
    Text("agreed with …"),
    Text("as in the engine that runs"),
    Text("to be settled by the supplier"),
    Text("outside what this design is for"),
)
"""Reasons that are usual, to be written on."""


class Accept(Reason):
    """Why findings of one cause stay open, the worst of them first."""

    def __init__(self, checks: Sequence[Check], say: Language) -> None:
        worst, others = checks[0], len(checks) - 1
        what = Text(
            "{check}: {value}, {limit}",
            check=worst.name,
            value=Amount(worst.value, worst.unit),
            limit=worst.limit_text(),
        )
        more = (
            plural("and {n} finding of the same cause", "and {n} findings of the same cause", n=others)
            if others
            else EMPTY
        )
        about = " ".join(part for part in (say(what), say(more)) if part)
        super().__init__(Text("Leave this open: why is it right?"), about, USUAL)


class AcceptActions:
    """Accept the finding under the cursor, or take that back."""

    def __init__(self, host: Host) -> None:
        self._host = host

    def accept(self) -> None:
        host = self._host
        check = host.checks.check
        if check is None:
            host.app.tell(Text("Go to a finding first."))
        elif check.accepted:
            self._apply([f"accepted.{check.id}="], Text("Open again: {check}.", check=check.name))
        elif check.kind == "limit":
            why = Text(
                "{check} is a limit, which nobody can accept: change what is near it or beyond. {key} offers what "
                "would help.",
                check=check.name,
                key=host.app.shown_key("fix"),
            )
            host.app.tell(why, "warning")
        elif not check.open:
            host.app.tell(Text("{check} holds: there is nothing to accept.", check=check.name))
        else:
            group = [c for c in host.checks.group if c.kind != "limit"]
            host.app.push_screen(Accept(group, host.app.say), lambda reason: self._accepted(group, reason))

    def _accepted(self, checks: Sequence[Check], reason: str | None) -> None:
        if reason is not None:
            changes = [assignment(f"accepted.{check.id}", reason) for check in checks]
            self._apply(
                changes, Text("Accepted: {check}. It stands in the report with its reason.", check=checks[0].name)
            )

    def _apply(self, changes: Sequence[str], text: Text) -> None:
        self._host.session.apply(changes)
        rebuilt(self._host)
        self._host.app.tell(text)
