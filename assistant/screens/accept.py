# SPDX-License-Identifier: Apache-2.0
"""Accepting a finding: what is open stays open on purpose, with a reason that stands in the design and in the report."""

from collections.abc import Sequence
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.screen import ModalScreen
from textual.widgets import Input, OptionList, Static

from calc.sheet.check import Check
from calc.sheet.text import EMPTY, Amount, Text, plural

from ..base_app import BaseApp
from .edit_actions import rebuilt
from .host import Host
from .once import Once

USUAL = (
    Text("seen on the test bench: it holds"),
    Text("agreed with …"),
    Text("as in the engine that runs"),
    Text("to be settled by the supplier"),
    Text("outside what this design is for"),
)
"""Reasons that are usual, to be written on."""


class Accept(Once, ModalScreen[str | None]):
    """Asks for the reason; gives it, or None."""

    app: BaseApp
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "cancel", "Cancel", show=False),
        Binding("down", "list(1)", "To the usual reasons", show=False),
        Binding("up", "list(-1)", "Back to the reason", show=False),
    ]

    def __init__(self, checks: Sequence[Check]) -> None:
        super().__init__()
        self.checks = checks

    def compose(self) -> ComposeResult:
        say, worst = self.app.say, self.checks[0]
        what = Text("{check}: {value}, {limit}", check=worst.name, value=Amount(worst.value, worst.unit), limit=worst.limit_text())
        others = len(self.checks) - 1
        more = plural("and {n} finding of the same cause", "and {n} findings of the same cause", n=others) if others else EMPTY
        with Vertical(classes="dialog"):
            yield Static(Content.styled(say(Text("Leave this open: why is it right?")), "bold"))
            yield Static(Content(" ".join(part for part in (say(what), say(more)) if part)))
            yield Input(compact=True, select_on_focus=False, id="words")
            yield OptionList(*(Content(say(reason)) for reason in USUAL), compact=True, id="names")
            yield Static("", classes="wrong")
            yield Static(Content.styled(say(Text("Enter accepts it with this reason, ↓ chooses a usual one, Esc goes back.")), "dim"))

    def on_input_submitted(self, event: Input.Submitted) -> None:
        event.stop()
        if reason := event.value.strip():
            self.dismiss(reason)
        else:
            self.query_one(".wrong", Static).update(Content(self.app.say(Text("A reason is needed: it stands in the report."))))

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        event.stop()
        box = self.query_one(Input)
        box.value = self.app.say(USUAL[event.option_index]).removesuffix("…")
        box.cursor_position = len(box.value)
        box.focus()

    def action_list(self, by: int) -> None:
        options = self.query_one(OptionList)
        if by > 0 and self.focused is not options:
            options.focus()
            options.action_first()
        elif by < 0 and options.highlighted in (0, None):
            self.query_one(Input).focus()

    def action_cancel(self) -> None:
        self.dismiss(None)


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
                "{check} is a limit, which nobody can accept: change what is near it or beyond. {key} offers what would help.",
                check=check.name,
                key=host.app.shown_key("fix"),
            )
            host.app.tell(why, "warning")
        elif not check.open:
            host.app.tell(Text("{check} holds: there is nothing to accept.", check=check.name))
        else:
            group = [c for c in host.checks.group if c.kind != "limit"]
            host.app.push_screen(Accept(group), lambda reason: self._accepted(group, reason))

    def _accepted(self, checks: Sequence[Check], reason: str | None) -> None:
        if reason is not None:
            changes = [f"accepted.{check.id}={quoted(reason)}" for check in checks]
            self._apply(changes, Text("Accepted: {check}. It stands in the report with its reason.", check=checks[0].name))

    def _apply(self, changes: Sequence[str], text: Text) -> None:
        self._host.session.apply(changes)
        rebuilt(self._host)
        self._host.app.tell(text)


def quoted(reason: str) -> str:
    """A reason as TOML has it."""
    return '"' + reason.replace("\\", "\\\\").replace('"', '\\"') + '"'
