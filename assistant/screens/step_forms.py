# SPDX-License-Identifier: Apache-2.0
"""The forms of the steps, of which one is shown: those of further steps are made while nobody types, so that a step
opens at once."""

import time

from textual.timer import Timer
from textual.widget import AwaitMount

from calc.design.model import STEPS
from calc.sheet.step import Step
from calc.sheet.text import Name, Text

from ..widgets.form import Form
from .host import Host

QUIET = 0.2  # seconds without a key until the form of a further step is made: it takes a tenth of one


class StepForms:
    def __init__(self, host: Host) -> None:
        self._host = host
        self._timer: Timer | None = None
        self._mounting: AwaitMount | None = None

    async def show(self, step: Step) -> None:
        """The form of a step, made where it has none yet."""
        if (form := self._of(step)) is None:
            await self._host.add_form(Form(step, self._host.session))
            return
        if self._mounting is not None:  # that of this step, maybe
            await self._mounting
        form.display = True

    def make_ahead(self) -> None:
        """Soon, if no key comes: the form of a further step, hidden."""
        if self._timer is not None:
            self._timer.stop()
        self._timer = self._host.set_timer(QUIET, self._make)

    async def _make(self) -> None:
        host = self._host
        if not host.stands:
            return
        at = STEPS.index(host.step)
        step = next((step for step in (*STEPS[at:], *STEPS[:at]) if not step.optional and self._of(step) is None), None)
        if step is None:
            return
        if host.is_current and time.monotonic() > host.app.struck + QUIET:
            form = Form(step, host.session)
            form.display = False
            self._mounting = host.add_form(form)
            await self._mounting
            self._mounting = None
        self.make_ahead()

    def spare(self) -> None:
        """A step is gone to past a lone digit, with no Enter after it: the number stays as it was."""
        if (field := self._host.form.field) is not None and field.stray:
            stays = Text(
                "{label} stays {was}: {digit} was not accepted (Enter or Tab accept it)",
                label=field.about.label,
                was=Name(field.was),
                digit=Name(field.box.value),
            )
            field.restore()
            self._host.app.tell(stays)

    def _of(self, step: Step) -> Form | None:
        return next((form for form in self._host.forms() if form.step.key == step.key), None)
